"""The two methods, with their steps."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any, Dict, List, NamedTuple, Optional, Tuple

from ._errors import Element
from ._matrix import Entry, Heading, Matrix, Quantity
from ._numbers import expression

if TYPE_CHECKING:
    import sympy

    from ._analysis import Analysis

FormulaRow = Optional[Tuple[str, str]]


class Formula(NamedTuple):
    """A formula in the gear ratios.

    Attributes
    ----------
    text : str
        "-i18*i17", as any computer algebra system reads it.
    latex : str
        The same typeset.
    """

    text: str
    latex: str

    def to_sympy(self) -> sympy.Expr:
        """Give the formula as an expression; imports SymPy.

        Returns
        -------
        sympy.Expr
            The ratios are positive symbols under their names.
        """
        return expression(self.text)

    def _repr_latex_(self) -> str:
        return f"$\\displaystyle {self.latex}$"


class Term(NamedTuple):
    """A joint's part in the equation of another.

    Attributes
    ----------
    joint : int
        Label.
    coefficient : Formula
        In the gear ratios.
    """

    joint: int
    coefficient: Formula


class MatroidStep(NamedTuple):
    """A line of the Matroid method's solution: the rate of ``joint`` is the sum of the terms.

    Attributes
    ----------
    joint : int
        Label of the unknown.
    equation : Element or None
        The mesh or coupling whose row gives it; None where elimination combined several.
    terms : tuple of Term
        Over inputs and joints of lines before.
    """

    joint: int
    equation: Optional[Element]
    terms: Tuple[Term, ...]


class TtStep(NamedTuple):
    """A step of the T-T graph method's chain, Eqs. (39)-(42).

    Attributes
    ----------
    number : int
        Of the equation, counted on from the paper's.
    joint : int
        Label of the unknown.
    name : str
        The unknown as the paper writes it, "w21".
    equations : tuple of Element
        The meshes (and engaged couplings) that give it.
    coupled : bool
        Had they to be solved together?
    uses : tuple of int
        Numbers of the equations that are put in.
    before : tuple of Term
        The mesh's equations solved for the unknown.
    after : tuple of Formula or None
        The same over the inputs, one for each; None where it is too long.
    """

    number: int
    joint: int
    name: str
    equations: Tuple[Element, ...]
    coupled: bool
    uses: Tuple[int, ...]
    before: Tuple[Term, ...]
    after: Tuple[Optional[Formula], ...]


class TransferVertex(NamedTuple):
    """The carrier arm of a mesh in the T-T graph.

    Attributes
    ----------
    mesh : int
        Label.
    carrier : int or None
        Label of the link where the path changes its level; None where there is none.
    path : tuple of int
        Labels of the links from the tail's gear to the head's.
    axes : tuple of str
        The levels along it.
    sign : int or None
        -1 where the gears turn against each other, seen from the carrier.
    """

    mesh: int
    carrier: Optional[int]
    path: Tuple[int, ...]
    axes: Tuple[str, ...]
    sign: Optional[int]


class _Method:
    __slots__ = ("_analysis",)

    def __init__(self, analysis: Analysis) -> None:
        self._analysis = analysis

    def _joint(self, ordinal: int) -> int:
        return self._analysis.mechanism.n + 1 + ordinal

    def _equation(self, ordinal: int) -> Element:
        mechanism = self._analysis.mechanism
        if ordinal < mechanism.c:
            return mechanism.meshes[ordinal].element
        rows: List[str] = self._analysis._json["couplingRows"]["rows"]
        return Element("coupling", rows[ordinal - mechanism.c])

    def _terms(self, rows: List[Tuple[int, Tuple[str, str]]]) -> Tuple[Term, ...]:
        return tuple(Term(self._joint(joint), Formula(*formula)) for joint, formula in rows)


class MatroidMethod(_Method):
    """The Matroid method of an analysis."""

    __slots__ = ()

    @property
    def solution(self) -> Quantity:
        """Rates of the outputs over those of the inputs, Eqs. (23), (25)."""
        return self._analysis.solution

    @property
    def steps(self) -> Optional[Tuple[MatroidStep, ...]]:
        """The lines of the solution in the order in which they are found; None where the symbolic
        solution was switched off or is too long."""
        rows = self._analysis._snapshot.matroid_steps()
        if rows is None:
            return None
        return tuple(
            MatroidStep(
                self._joint(joint),
                None if equation < 0 else self._equation(equation),
                self._terms(terms),
            )
            for joint, equation, terms in rows
        )


class TtGraphMethod(_Method):
    """The T-T graph method of an analysis; it shares no step with the Matroid method."""

    __slots__ = ()

    @property
    def transfer_vertices(self) -> Tuple[TransferVertex, ...]:
        """The carrier arm of each mesh."""
        rows: List[Dict[str, Any]] = self._analysis._json["transferVertices"] or []
        return tuple(
            TransferVertex(
                row["mesh"], row["carrier"], tuple(row["path"]), tuple(row["axes"]), row["sign"]
            )
            for row in rows
        )

    @property
    def solution(self) -> Quantity:
        """Rates of the outputs over those of the inputs, Eqs. (43), (45).

        Raises
        ------
        Error
            The errors of the mechanism.
        """
        self._analysis._snapshot.rates()
        data = self._analysis._json["ttSolution"]
        rows = tuple(self._heading(label) for label in data["outputs"])
        columns = tuple(self._heading(label) for label in data["inputs"])
        exact = {
            (i, j): Fraction(text)
            for i, row in enumerate(data["exact"]) for j, text in enumerate(row) if text != "0"
        }

        def matrix(form: str, entries: Dict[Tuple[int, int], Entry]) -> Matrix:
            return Matrix("θ̇", "Solution (T-T graph)", 43, form, rows, columns, None, entries)

        symbols = data["symbolic"]
        texts: Optional[Dict[Tuple[int, int], Entry]] = None
        if symbols is not None and all(text is not None for row in symbols for text in row):
            texts = {
                (i, j): text
                for i, row in enumerate(symbols) for j, text in enumerate(row) if text != "0"
            }
        return Quantity(
            matrix("decimals", {place: float(value) for place, value in exact.items()}),
            matrix("fractions", dict(exact)),
            None if texts is None else matrix("symbols", texts),
        )

    def _heading(self, label: int) -> Heading:
        return Heading(label, f"θ̇{label}", self._analysis.mechanism.joint(label).element)

    @property
    def steps(self) -> Optional[Tuple[TtStep, ...]]:
        """The chain (39)-(42): a step for each unknown; None where the symbolic solution was
        switched off or is too long."""
        rows = self._analysis._snapshot.tt_steps()
        if rows is None:
            return None
        return tuple(
            TtStep(
                number, self._joint(joint), name, tuple(self._equation(e) for e in equations),
                coupled, tuple(uses), self._terms(before),
                tuple(None if formula is None else Formula(*formula) for formula in after),
            )
            for number, joint, equations, coupled, uses, before, after, name, _ in rows
        )
