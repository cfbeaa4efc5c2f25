"""A mechanism worked out by both methods, as data and as documents."""

from __future__ import annotations

from typing import Any, Iterator, List, NamedTuple, Tuple, Union

from . import _geargraph
from ._errors import Element

Words = Tuple[Tuple[str, bool], ...]


class Equation(NamedTuple):
    """A numbered equation of the derivation.

    Attributes
    ----------
    number : str
        The paper's, "17"; of statics that of its twin of the kinematics with a star, "17*"; empty
        where nothing refers to it.
    tex : str
        In TeX, for math mode.
    elements : tuple of Element
        What it is about; empty where it is about the whole mechanism.
    section : str
        The heading that it is under.
    """

    number: str
    tex: str
    elements: Tuple[Element, ...]
    section: str

    def _repr_latex_(self) -> str:
        tag = f" \\tag{{{self.number}}}" if self.number else ""
        return f"$$ {self.tex}{tag} $$"


class Block(NamedTuple):
    """A piece of the derivation.

    Attributes
    ----------
    kind : str
        "heading", "paragraph", "equation", "table", "list" or "figure".
    content : object
        Of a heading (level, text); of a paragraph its words, each (text, is it a formula); of an
        equation an `Equation`; of a table (headings, rows of words); of a list its items as words;
        of a figure (name of the drawing, caption).
    """

    kind: str
    content: Any


class Derivation:
    """Both methods worked out for a mechanism: Eqs. (1)-(45) of the paper for its own links, joints
    and teeth; immutable. In Jupyter it shows itself typeset.

    Attributes
    ----------
    title : str
        The name of the mechanism.
    blocks : tuple of Block
        Headings, sentences, equations, tables, lists and figures in their order.
    """

    def __init__(
        self, snapshot: _geargraph.Snapshot, title: str, rows: List[Tuple[Any, ...]]
    ) -> None:
        self._snapshot = snapshot
        self.title = title
        self.blocks = tuple(_blocks(rows))

    def __repr__(self) -> str:
        return f"<Derivation {self.title!r}: {len(self.equations)} equations>"

    @property
    def equations(self) -> Tuple[Equation, ...]:
        """All equations on lines of their own."""
        return tuple(block.content for block in self.blocks if block.kind == "equation")

    def equation(self, number: Union[int, str]) -> Equation:
        """Find an equation by its number.

        Parameters
        ----------
        number : int or str
            17, or "17*" for its twin of the statics.

        Returns
        -------
        Equation
            The first with this number.

        Raises
        ------
        KeyError
            If no equation of this mechanism has the number; the numbers are listed.
        """
        for equation in self.equations:
            if equation.number == str(number):
                return equation
        known = ", ".join(each.number for each in self.equations if each.number)
        raise KeyError(f"There is no equation {number!r}; these are {known}.")

    @property
    def html(self) -> str:
        """A page that any browser shows: formulas in MathML, drawings in SVG, no scripts."""
        return self._snapshot.report("html").decode()

    @property
    def latex(self) -> str:
        """A document for any of the LaTeX programs, with amsmath."""
        return self._snapshot.report("latex").decode()

    @property
    def markdown(self) -> str:
        """Markdown with formulas between dollar signs."""
        return self._snapshot.report("md").decode()

    @property
    def pdf(self) -> bytes:
        """Pages of A4."""
        return self._snapshot.report("pdf")

    def _repr_markdown_(self) -> str:
        return self.markdown

    def _repr_html_(self) -> str:
        page = self.html
        start, end = page.find("<body"), page.rfind("</body>")
        return "<div>" + page[page.index(">", start) + 1 : end] + "</div>"

    def _repr_latex_(self) -> str:
        page = self.latex
        start = page.index("\\begin{document}") + len("\\begin{document}")
        return page[start : page.rindex("\\end{document}")]


def _words(row: Any) -> Words:
    return tuple((text, is_formula) for text, is_formula in row)


def _blocks(rows: List[Tuple[Any, ...]]) -> Iterator[Block]:
    section = ""
    for kind, *content in rows:
        if kind == "heading":
            section = content[1]
            yield Block(kind, (content[0], section))
        elif kind == "paragraph":
            yield Block(kind, _words(content[0]))
        elif kind == "equation":
            tex, number, named = content
            elements = tuple(Element(*each) for each in named)
            yield Block(kind, Equation(number, tex, elements, section))
        elif kind == "table":
            head, cells = content
            rows_of_words = tuple(tuple(_words(cell) for cell in row) for row in cells)
            yield Block(kind, (tuple(head), rows_of_words))
        elif kind == "list":
            yield Block(kind, tuple(_words(item) for item in content[0]))
        else:
            yield Block(kind, (content[0], content[1]))
