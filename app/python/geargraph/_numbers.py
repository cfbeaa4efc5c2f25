"""Numbers on their way to and from the compiled module, which takes and gives exact texts."""

from __future__ import annotations

import math
import re
import struct
from decimal import Decimal
from fractions import Fraction
from numbers import Integral, Rational, Real
from typing import TYPE_CHECKING, Any, Iterable, List, Optional, Sequence, Tuple, Union

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
    import sympy

Number = Union[int, float, Fraction, Decimal, str]
"""What a length, an angle, a speed or a torque may be: fractions, and texts such as "22/7", stay
exact; a float is taken for the shortest decimal that reads back as it."""


def text_of(number: object) -> str:
    """Write a number as a text that keeps it exact."""
    if isinstance(number, str):
        return number.strip()
    if isinstance(number, bool) or not isinstance(number, (Real, Decimal)):
        raise TypeError(f"a number is needed, not {number!r}")
    if isinstance(number, Integral):
        return str(int(number))
    if isinstance(number, Rational):
        return f"{int(number.numerator)}/{int(number.denominator)}"
    if isinstance(number, Decimal):
        if not number.is_finite():
            raise ValueError(f"a finite number is needed, not {number}")
        return str(number)
    value = float(number)
    if not math.isfinite(value):
        raise ValueError(f"a finite number is needed, not {value}")
    return repr(value)


def optional_text(number: Optional[Number]) -> Optional[str]:
    """Write a number, or None, as a text."""
    return None if number is None else text_of(number)


def triple_of(numbers: Sequence[Number]) -> Tuple[str, str, str]:
    """Write a point or direction as three texts."""
    if isinstance(numbers, str) or len(numbers) != 3:
        raise ValueError("a point or direction has three components")
    x, y, z = numbers
    return text_of(x), text_of(y), text_of(z)


def optional_triple(numbers: Optional[Sequence[Number]]) -> Optional[Tuple[str, str, str]]:
    """Write a point, or None, as three texts."""
    return None if numbers is None else triple_of(numbers)


def exact(value: Union[int, Fraction, str]) -> Fraction:
    """Read a number of a document."""
    return Fraction(value)


def exact_triple(values: Iterable[Union[int, Fraction, str]]) -> Tuple[Fraction, ...]:
    """Read a point or direction of a document."""
    return tuple(Fraction(value) for value in values)


def doubles(packed: bytes) -> Tuple[float, ...]:
    """Unpack doubles."""
    return struct.unpack(f"={len(packed) // 8}d", packed)


def integers(packed: bytes) -> Tuple[int, ...]:
    """Unpack int32 numbers."""
    return struct.unpack(f"={len(packed) // 4}i", packed)


def array(packed: bytes, dtype: str, *shape: int) -> npt.NDArray[Any]:
    """Make a read-only NumPy array of packed numbers; imports NumPy."""
    import numpy as np

    return np.frombuffer(packed, dtype=np.dtype(dtype)).reshape(shape)


def expression(text: str) -> sympy.Expr:
    """Make a SymPy expression of a formula in gear ratios, "-i18*i17/2"; imports SymPy.

    The ratios are positive symbols under their own names.
    """
    import sympy

    names = sorted(set(_names_in(text)))
    symbols = {name: sympy.Symbol(name, positive=True) for name in names}
    result: sympy.Expr = sympy.sympify(text.replace("^", "**"), locals=symbols, rational=True)
    return result


def _names_in(text: str) -> List[str]:
    names: List[str] = []
    name = ""
    for character in text + " ":
        if character.isalpha() or (name and (character.isdigit() or character in "_'")):
            name += character
        elif name:
            names.append(name)
            name = ""
    return names


def latex_of(value: Union[int, Fraction, float]) -> str:
    """Typeset a number."""
    if isinstance(value, Fraction) and value.denominator != 1:
        sign = "-" if value < 0 else ""
        return f"{sign}\\frac{{{abs(value.numerator)}}}{{{value.denominator}}}"
    if isinstance(value, float):
        return f"{value:.6g}"
    return str(value)


def formula_latex(text: str) -> str:
    """Typeset a formula in gear ratios, "-i18*i17"."""
    text = re.sub(r"\^(\d+)", r"^{\1}", text.replace("*", " "))
    return re.sub(r"([a-z]+)(\d+)", r"\1_{\2}", text)
