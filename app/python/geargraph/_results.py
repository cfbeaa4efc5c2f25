"""Results that are plain values."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any, Dict, List, NamedTuple, Optional, Tuple, Union

from ._errors import Diagnostic

if TYPE_CHECKING:
    import pandas as pd


class InputSets(NamedTuple):
    """The valid sets of inputs.

    Attributes
    ----------
    total : int or None
        How many there are, exactly; None where the mechanism is too entangled to count them.
    sets : tuple of tuple of int
        The first of them, each the labels of its joints.
    """

    total: Optional[int]
    sets: Tuple[Tuple[int, ...], ...]


class State(NamedTuple):
    """A gear of a gearbox: a row of the shift table.

    Attributes
    ----------
    name : str
        Of the gear.
    engaged : tuple of str
        Ids of the couplings that are engaged.
    dof : int or None
        Degrees of freedom, 1 in a gear; None where a coupling closes a linkage.
    ratio : Fraction or None
        Speed of the drive over speed of the driven link; None where the state locks or is free.
    symbol : str or None
        The same in the gear ratios.
    joint_speeds : dict of int to Fraction, or None
        By label, rad/s, for the drive at 1 rad/s; without joints of links that turn freely.
    diagnostics : tuple of Diagnostic
        Why it locks or is free, or which links turn freely.
    """

    name: str
    engaged: Tuple[str, ...]
    dof: Optional[int]
    ratio: Optional[Fraction]
    symbol: Optional[str]
    joint_speeds: Optional[Dict[int, Fraction]]
    diagnostics: Tuple[Diagnostic, ...]


class States(Tuple[State, ...]):
    """The shift table, a tuple of its states."""

    __slots__ = ()

    def to_pandas(self) -> pd.DataFrame:
        """Give the shift table; imports pandas.

        Returns
        -------
        pandas.DataFrame
            A row for each state, by name: ``engaged`` (ids), ``dof``, ``ratio`` (Fraction or None),
            ``symbol``, and the speed of each joint in rad/s by its label, for the drive at 1 rad/s.
        """
        import pandas as pd

        rows: List[Dict[Union[int, str], object]] = []
        for state in self:
            rows.append({"engaged": state.engaged, "dof": state.dof, "ratio": state.ratio, "symbol": state.symbol})
            for joint, speed in (state.joint_speeds or {}).items():
                rows[-1][joint] = speed
        names = pd.Index([state.name for state in self], name="state")
        return pd.DataFrame(rows, index=names, dtype=object)


class MotionCheck(NamedTuple):
    """Which links collide while the inputs run at their speeds.

    Attributes
    ----------
    start, end : float
        Seconds that were looked at.
    covers_all : bool
        Does that cover all of the motion?
    complete : bool
        False where too many parts come close to each other.
    diagnostics : tuple of Diagnostic
        Collisions, each with the time of first contact.
    """

    start: float
    end: float
    covers_all: bool
    complete: bool
    diagnostics: Tuple[Diagnostic, ...]


def state_of(row: Dict[str, Any]) -> State:
    """Make a row of the shift table of what the compiled module gives."""
    speeds = row["jointSpeeds"]
    found = tuple(
        Diagnostic(d["severity"], d["code"], d.get("detail", ""), d["message"], ())
        for d in row["diagnostics"]
    )
    return State(
        row["name"], tuple(row["engaged"]), row["dof"],
        None if row["ratio"] is None else Fraction(row["ratio"]), row["ratioSymbolic"],
        None if speeds is None
        else {int(k): Fraction(v) for k, v in speeds.items() if v is not None}, found,
    )
