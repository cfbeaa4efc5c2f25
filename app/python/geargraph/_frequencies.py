"""Frequencies of shafts, tooth meshes and planets, and lost motion by the play of the teeth."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any, Dict, List, NamedTuple, Optional, Tuple

if TYPE_CHECKING:
    import pandas as pd


class Frequency(NamedTuple):
    """A line of the spectrum.

    Attributes
    ----------
    kind : str
        "shaft", "joint", "planet-pass", "tooth-mesh", "sideband", "assembly-phase" or "hunting-tooth".
    ratio : Fraction
        Cycles for a turn of the reference shaft, above 0.
    hertz : float or None
        At the given speed of that shaft; None without one.
    mesh, link, joint : str or None
        Ids of what it is of.
    harmonic : int
        The multiple of the tooth mesh.
    sideband : int
        How often the modulating frequency is added, below 0 if it is taken away; 0 for others.
    planets : int
        How many planets pass the link; 0 for others.
    """

    kind: str
    ratio: Fraction
    hertz: Optional[float]
    mesh: Optional[str]
    link: Optional[str]
    joint: Optional[str]
    harmonic: int
    sideband: int
    planets: int


class Frequencies(NamedTuple):
    """The lines of one motion.

    Attributes
    ----------
    state : str or None
        The state; None for the train as engaged, driven by its inputs.
    reference : str or None
        Id of the joint, or in a state of the link, that ratios are to.
    reason : str or None
        Why there are no lines: "unfinished", "at-rest" or "free".
    lines : tuple of Frequency
        Shafts, joints, planets, then mesh by mesh.
    """

    state: Optional[str]
    reference: Optional[str]
    reason: Optional[str]
    lines: Tuple[Frequency, ...]

    def to_pandas(self) -> pd.DataFrame:
        """Give the lines as a table; imports pandas.

        Returns
        -------
        pandas.DataFrame
            A row for each line, the attributes of Frequency as columns.
        """
        import pandas as pd

        return pd.DataFrame(list(self.lines), columns=list(Frequency._fields))


class LostMotion(NamedTuple):
    """How far a joint turns from stop to stop while the inputs are held.

    Attributes
    ----------
    joint : str
        Its id.
    worst : Fraction or None
        Every mesh at its worst, rad; None for a train with shared play that is too large.
    root_of_squares : float or None
        The root of the sum of the squares of the parts, rad; None where meshes share their play.
    most : str or None
        Id of the mesh that contributes most.
    parts : dict of str to Fraction
        By mesh, rad: what ``worst`` loses if the mesh has no play.
    at_inputs : dict of str to Fraction or None
        By input, rad: how far it turns while the joint is held; None where it does not move the joint.
    """

    joint: str
    worst: Optional[Fraction]
    root_of_squares: Optional[float]
    most: Optional[str]
    parts: Dict[str, Fraction]
    at_inputs: Dict[str, Optional[Fraction]]


class Backlash(NamedTuple):
    """Lost motion of the train as engaged, or in a state.

    Attributes
    ----------
    state : str or None
        The state; None for the train as engaged.
    shared : bool or None
        Do meshes follow from others, so that the tightest decides? None without a solution.
    plays : dict of str to Fraction
        By mesh: the teeth of its tail times the angle between both flanks, rad.
    outputs : tuple of LostMotion
        The joints that are no inputs, by label.
    """

    state: Optional[str]
    shared: Optional[bool]
    plays: Dict[str, Fraction]
    outputs: Tuple[LostMotion, ...]


def frequencies_of(row: Dict[str, Any]) -> Frequencies:
    """Make the lines of a motion of what the compiled module gives."""
    reference = row["reference"] or {}
    lines: List[Frequency] = [
        Frequency(
            line["kind"], Fraction(line["ratio"]), line["hertz"], line.get("mesh"), line.get("link"),
            line.get("joint"), line.get("harmonic", 1), line.get("sideband", 0), line.get("planets", 0),
        )
        for line in row["lines"]
    ]
    return Frequencies(
        row["state"], reference.get("joint") or reference.get("link"), row["reason"], tuple(lines)
    )


def _fraction(text: Optional[str]) -> Optional[Fraction]:
    return None if text is None else Fraction(text)


def backlash_of(row: Dict[str, Any]) -> Backlash:
    """Make the lost motion of what the compiled module gives."""
    outputs = tuple(
        LostMotion(
            each["joint"], _fraction(each["worst"]), each["rootOfSquares"], each["most"],
            {mesh: Fraction(part) for mesh, part in each["parts"].items()},
            {joint: _fraction(angle) for joint, angle in each["atInputs"].items()},
        )
        for each in row["outputs"] or ()
    )
    plays = {mesh: Fraction(play) for mesh, play in row["plays"].items()}
    return Backlash(row["state"], row["shared"], plays, outputs)
