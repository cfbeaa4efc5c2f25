"""Matrices with their labels."""

from __future__ import annotations

from fractions import Fraction
from typing import (
    TYPE_CHECKING, Any, Dict, Iterator, List, NamedTuple, Optional, Tuple, Union,
)

from ._errors import Element
from ._numbers import expression, formula_latex, latex_of

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
    import pandas as pd
    import sympy

Entry = Union[int, float, Fraction, str]

_MOST_TYPESET = 40
_MOST_SHOWN = 30


class Heading(NamedTuple):
    """What a row or a column of a matrix is about.

    Attributes
    ----------
    label : int
        The paper's number of the link, joint or mesh.
    text : str
        As the row is headed: "8", "C15" for the cycle of mesh 15, "C16 12" for a screw.
    element : Element or None
        The element; of a cycle its mesh.
    """

    label: int
    text: str
    element: Optional[Element]


HeadingRow = Tuple[int, str, str, str]


def headings_of(rows: List[HeadingRow]) -> Tuple[Heading, ...]:
    """Make headings of the rows that the compiled module gives."""
    return tuple(
        Heading(label, " ".join(text.split()), Element(kind, element) if element else None)
        for label, text, kind, element in rows
    )


class Matrix:
    """A matrix with its labels; immutable.

    Entries are whole numbers, floats, fractions, or texts of formulas in the gear ratios
    (``form``). ``matrix[row, column]`` takes the texts or labels of headings; ``matrix.at(i, j)``
    positions.

    Attributes
    ----------
    symbol : str
        As the paper writes it, "Γ = [G | G*]".
    title : str
        "Reduced incidence matrix".
    equation : int
        The paper's equation; 0 where it shows none.
    form : str
        "integers", "decimals", "fractions" or "symbols".
    rows, columns : tuple of Heading
        What the rows and columns are about.
    partition : int or None
        The first column after the dashed line of a matrix in two parts, [G | G*].
    """

    __slots__ = (
        "symbol", "title", "equation", "form", "rows", "columns", "partition", "_entries", "_latex",
    )

    def __init__(
        self,
        symbol: str,
        title: str,
        equation: int,
        form: str,
        rows: Tuple[Heading, ...],
        columns: Tuple[Heading, ...],
        partition: Optional[int],
        entries: Dict[Tuple[int, int], Entry],
        latex: Optional[Dict[Tuple[int, int], str]] = None,
    ) -> None:
        self.symbol = symbol
        self.title = title
        self.equation = equation
        self.form = form
        self.rows = rows
        self.columns = columns
        self.partition = partition
        self._entries = entries
        self._latex = latex

    @property
    def shape(self) -> Tuple[int, int]:
        """Number of rows and of columns."""
        return len(self.rows), len(self.columns)

    @property
    def _zero(self) -> Entry:
        zeros: Dict[str, Entry] = {"decimals": 0.0, "fractions": Fraction(0), "symbols": "0"}
        return zeros.get(self.form, 0)

    def at(self, row: int, column: int) -> Entry:
        """Give the entry at these positions.

        Parameters
        ----------
        row, column : int
            Positions from 0; negative ones count from the end.

        Returns
        -------
        int, float, Fraction or str
            By ``form``.

        Raises
        ------
        IndexError
            If there is no such row or column.
        """
        height, width = self.shape
        if not (-height <= row < height and -width <= column < width):
            raise IndexError(f"there is no entry ({row}, {column}) in a {height} x {width} matrix")
        return self._entries.get((row % height, column % width), self._zero)

    def __getitem__(self, key: Tuple[Union[int, str], Union[int, str]]) -> Entry:
        row, column = key
        return self.at(_position(self.rows, row), _position(self.columns, column))

    def __len__(self) -> int:
        return len(self.rows)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Matrix):
            return NotImplemented
        return (
            self.form == other.form
            and self.rows == other.rows
            and self.columns == other.columns
            and self._entries == other._entries
        )

    __hash__ = None  # type: ignore[assignment]

    def nonzeros(self) -> Iterator[Tuple[int, int, Entry]]:
        """Go through the entries that are not 0.

        Yields
        ------
        tuple of int, int and entry
            Positions and value, row by row.
        """
        for row, column in sorted(self._entries):
            yield row, column, self._entries[row, column]

    def part(self, which: int) -> Matrix:
        """Give a part of a matrix that is partitioned.

        Parameters
        ----------
        which : {0, 1}
            0: left of the dashed line (G of Γ = [G | G*]), 1: right of it.

        Returns
        -------
        Matrix
            With the headings of the part.

        Raises
        ------
        ValueError
            If the matrix has no parts.
        """
        if self.partition is None or which not in (0, 1):
            raise ValueError("the matrix has no such part")
        first, last = [(0, self.partition), (self.partition, len(self.columns))][which]
        inside = [key for key in self._entries if first <= key[1] < last]
        latex = self._latex
        return Matrix(
            self.symbol, self.title, self.equation, self.form, self.rows,
            self.columns[first:last], None,
            {(row, column - first): self._entries[row, column] for row, column in inside},
            None if latex is None
            else {(row, column - first): latex[row, column] for row, column in inside},
        )

    def to_list(self) -> List[List[Entry]]:
        """Give all entries.

        Returns
        -------
        list of list
            Row by row.
        """
        height, width = self.shape
        return [[self.at(row, column) for column in range(width)] for row in range(height)]

    def to_numpy(self) -> npt.NDArray[Any]:
        """Give the entries as an array; imports NumPy.

        Returns
        -------
        numpy.ndarray
            Shape ``(rows, columns)``, read-only: int64 for whole numbers, float64 for decimals and
            for fractions (their nearest doubles), object (texts) for symbols.
        """
        import numpy as np

        kinds: Dict[str, Any] = {"integers": np.int64, "symbols": object}
        result: npt.NDArray[Any] = np.zeros(self.shape, dtype=kinds.get(self.form, np.float64))
        if self.form == "symbols":
            result[...] = "0"
        for (row, column), value in self._entries.items():
            result[row, column] = float(value) if isinstance(value, Fraction) else value
        result.flags.writeable = False
        return result

    def __array__(
        self, dtype: Any = None, copy: Optional[bool] = None
    ) -> npt.NDArray[Any]:
        result = self.to_numpy()
        return result if dtype is None else result.astype(dtype)

    def to_pandas(self) -> pd.DataFrame:
        """Give the entries as a table with the headings as index and columns; imports pandas.

        Returns
        -------
        pandas.DataFrame
            Whole numbers, floats, or objects: ``fractions.Fraction`` and texts.
        """
        import pandas as pd

        return pd.DataFrame(
            self.to_list(),
            index=[heading.text for heading in self.rows],
            columns=[heading.text for heading in self.columns],
        )

    def to_sympy(self) -> sympy.ImmutableDenseMatrix:
        """Give the entries as a SymPy matrix; imports SymPy.

        Returns
        -------
        sympy.ImmutableDenseMatrix
            Integers, rationals, floats, or expressions in the gear ratios, which are positive
            symbols under their names (``i15``).
        """
        import sympy

        def converted(value: Entry) -> Any:
            if isinstance(value, str):
                return expression(value)
            if isinstance(value, Fraction):
                return sympy.Rational(value.numerator, value.denominator)
            return sympy.sympify(value)

        height, width = self.shape
        return sympy.ImmutableDenseMatrix(
            height, width, lambda row, column: converted(self.at(int(row), int(column)))
        )

    def to_csv(self) -> str:
        """Write the matrix as comma-separated values with its headings.

        Returns
        -------
        str
            One line a row, after a line of column headings.
        """
        lines = ["," + ",".join(heading.text for heading in self.columns)]
        for heading, entries in zip(self.rows, self.to_list()):
            lines.append(",".join([heading.text] + [str(entry) for entry in entries]))
        return "\n".join(lines) + "\n"

    def to_latex(self) -> str:
        """Typeset the matrix with its headings.

        Returns
        -------
        str
            An ``array`` environment, for math mode; needs no package.
        """
        width = len(self.columns)
        columns = "r" * width
        if self.partition is not None:
            columns = "r" * self.partition + ":" + "r" * (width - self.partition)
            columns = columns.replace(":", "|")
        head = " & ".join([""] + [_typeset(heading.text) for heading in self.columns])
        lines = [f"\\begin{{array}}{{r|{columns}}}", head + " \\\\ \\hline"]
        for row, heading in enumerate(self.rows):
            cells = [_typeset(heading.text)]
            cells += [self._latex_at(row, column) for column in range(width)]
            lines.append(" & ".join(cells) + " \\\\")
        return "\n".join(lines + ["\\end{array}"])

    def _latex_at(self, row: int, column: int) -> str:
        if self._latex is not None:
            return self._latex.get((row, column), "0")
        value = self.at(row, column)
        return formula_latex(value) if isinstance(value, str) else latex_of(value)

    def _repr_latex_(self) -> Optional[str]:
        if max(self.shape, default=0) > _MOST_TYPESET:
            return None
        return f"$\\displaystyle {self.to_latex()}$"

    def _repr_html_(self) -> Optional[str]:
        if max(self.shape, default=0) <= _MOST_TYPESET:
            return None  # typeset instead
        height, width = (min(side, _MOST_SHOWN) for side in self.shape)
        more = "<td>…</td>" if len(self.columns) > width else ""
        head = "".join(f"<th>{heading.text}</th>" for heading in self.columns[:width])
        body = ""
        for row in range(height):
            cells = "".join(f"<td>{self.at(row, column)}</td>" for column in range(width))
            body += f"<tr><th>{self.rows[row].text}</th>{cells}{more}</tr>"
        caption = f"<caption>{self.title}, {len(self.rows)} × {len(self.columns)}</caption>"
        return f"<table>{caption}<tr><th></th>{head}{more}</tr>{body}</table>"

    def __repr__(self) -> str:
        return f"<{self.title} {self.symbol}, {len(self.rows)} × {len(self.columns)}, {self.form}>"

    def __str__(self) -> str:
        height, width = (min(side, _MOST_SHOWN) for side in self.shape)
        table = [[""] + [heading.text for heading in self.columns[:width]]]
        for row in range(height):
            entries = [self.at(row, column) for column in range(width)]
            shown = [f"{e:.6g}" if isinstance(e, float) else str(e) for e in entries]
            table.append([self.rows[row].text] + shown)
        widths = [max(map(len, column)) for column in zip(*table)]
        lines = ["  ".join(c.rjust(w) for c, w in zip(line, widths)) for line in table]
        return "\n".join(lines)


def _position(headings: Tuple[Heading, ...], key: Union[int, str]) -> int:
    found = [
        position for position, heading in enumerate(headings)
        if (heading.label == key if isinstance(key, int) else heading.text == key)
    ]
    if len(found) != 1:
        raise KeyError(key)
    return found[0]


def _typeset(text: str) -> str:
    letters = text.rstrip("0123456789")
    digits = text[len(letters):]
    if letters and digits and letters.isalpha():
        return f"{letters}_{{{digits}}}"
    return text if text.isdigit() or len(text) == 1 else f"\\text{{{text}}}"


class Quantity:
    """A quantity of the matroid method in the forms that it has; immutable.

    Attributes
    ----------
    decimals : Matrix
        In doubles.
    fractions : Matrix or None
        Exact; None where a length or a direction is irrational, or the solution has over 250,000
        entries.
    symbols : Matrix or None
        In the gear ratios i = N_tail / N_head; None where they were switched off or are too long.
    """

    __slots__ = ("decimals", "fractions", "symbols")

    def __init__(
        self, decimals: Matrix, fractions: Optional[Matrix], symbols: Optional[Matrix]
    ) -> None:
        self.decimals = decimals
        self.fractions = fractions
        self.symbols = symbols

    @property
    def best(self) -> Matrix:
        """The fractions where there are any, else the decimals."""
        return self.fractions if self.fractions is not None else self.decimals

    def to_numpy(self) -> npt.NDArray[np.float64]:
        """Give the decimals as an array; imports NumPy.

        Returns
        -------
        numpy.ndarray
            float64, shape ``(rows, columns)``, read-only.
        """
        return self.decimals.to_numpy()

    def __repr__(self) -> str:
        forms = [name for name in ("decimals", "fractions", "symbols") if getattr(self, name)]
        height, width = self.decimals.shape
        return f"<{self.decimals.title}, {height} × {width}: {', '.join(forms)}>"

    def _repr_latex_(self) -> Optional[str]:
        return (self.symbols or self.best)._repr_latex_()

    def _repr_html_(self) -> Optional[str]:
        return (self.symbols or self.best)._repr_html_()
