"""Whole gear sets: mechanisms from tooth counts, and tooth counts from requirements."""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple, Tuple

from . import _geargraph
from ._mechanism import Mechanism
from ._numbers import Number, text_of

__all__ = [
    "PlanetaryChoice", "RevertedChoice", "bevel_differential", "bevel_wrist", "planetary",
    "planetary_choices", "ravigneaux", "reverted", "reverted_choices", "simpson",
]


class PlanetaryChoice(NamedTuple):
    """Tooth counts of a planetary set.

    Attributes
    ----------
    sun, planet, ring : int
        Teeth; ring = sun + 2 planet.
    ratio : Fraction
        Speed of the drive over speed of the driven member, by Willis.
    error : float
        Relative to the required ratio.
    """

    sun: int
    planet: int
    ring: int
    ratio: Fraction
    error: float


class RevertedChoice(NamedTuple):
    """Tooth counts of a reverted train: first with second, third with fourth.

    Attributes
    ----------
    first, second, third, fourth : int
        Teeth; equal sums make both pairs one module.
    ratio : Fraction
        Speed of the drive over speed of the driven gear.
    error : float
        Relative to the required ratio.
    """

    first: int
    second: int
    third: int
    fourth: int
    ratio: Fraction
    error: float


def planetary(sun: int, planet: int, planets: int = 3) -> Mechanism:
    """Make a planetary set: sun 1, ring 2, carrier 3, planets from 4 on; the ring held.

    Parameters
    ----------
    sun, planet : int
        Teeth; the ring has sun + 2 planet.
    planets : int, optional
        How many, equally spaced.

    Returns
    -------
    Mechanism
        Its places are left open; the sun turns at 1 rad/s. Whether the planets go in evenly is
        among the findings of its analysis ("assembly").

    Raises
    ------
    ValueError
        For numbers out of range.
    """
    return Mechanism._of(_geargraph.planetary_set(sun, planet, planets))


def planetary_choices(
    ratio: Number,
    *,
    drive: str = "sun",
    driven: str = "carrier",
    planets: int = 3,
    fewest: int = 17,
    most: int = 120,
    count: int = 20,
) -> Tuple[PlanetaryChoice, ...]:
    """Look for tooth counts of a planetary set whose planets go in evenly and clear each other.

    Parameters
    ----------
    ratio : number
        Speed of the drive over speed of the driven member; the third member is held.
    drive, driven : {"sun", "ring", "carrier"}, optional
        Two different members.
    planets : int, optional
        How many, equally spaced.
    fewest, most : int, optional
        Teeth of a gear, at most 2,000.
    count : int, optional
        How many choices are given.

    Returns
    -------
    tuple of PlanetaryChoice
        Nearest to the required ratio first, of equals the smallest first; empty where the signs can
        never agree.

    Raises
    ------
    ValueError
        For numbers or members out of range.
    """
    rows = _geargraph.planetary_choices(
        text_of(ratio), drive, driven, planets, fewest, most, count
    )
    return tuple(PlanetaryChoice(*row[:3], Fraction(row[3]), row[4]) for row in rows)


def reverted(first: int, second: int, third: int, fourth: int) -> Mechanism:
    """Make a reverted train: two external pairs that lead back to the first axis.

    Parameters
    ----------
    first, second, third, fourth : int
        Teeth: first with second, third with fourth; second and third are one shaft.

    Returns
    -------
    Mechanism
        Input 1 and output 3 on one axis, countershaft 2; the input turns at 1 rad/s.

    Raises
    ------
    ValueError
        For numbers out of range.
    """
    return Mechanism._of(_geargraph.reverted_train(first, second, third, fourth))


def reverted_choices(
    ratio: Number, *, fewest: int = 17, most: int = 100, count: int = 20
) -> Tuple[RevertedChoice, ...]:
    """Look for tooth counts of a reverted train with pairs of one module.

    Parameters
    ----------
    ratio : number
        Speed of the drive over speed of the driven gear, above 0.
    fewest, most : int, optional
        Teeth of a gear, at most 2,000.
    count : int, optional
        How many choices are given.

    Returns
    -------
    tuple of RevertedChoice
        Nearest to the required ratio first, one for each ratio.

    Raises
    ------
    ValueError
        For numbers out of range.
    """
    rows = _geargraph.reverted_choices(text_of(ratio), fewest, most, count)
    return tuple(RevertedChoice(*row[:4], Fraction(row[4]), row[5]) for row in rows)


def bevel_differential(side: int, pinion: int, pinions: int = 2) -> Mechanism:
    """Make a bevel differential: case 1, side gears 2 and 3, pinions.

    Parameters
    ----------
    side, pinion : int
        Teeth of both side gears and of the pinions.
    pinions : int, optional
        How many.

    Returns
    -------
    Mechanism
        The speeds of the side gears add up to twice the case's.

    Raises
    ------
    Error
        "assembly" if 2 side / pinions is not whole.
    """
    return Mechanism._of(_geargraph.bevel_differential(side, pinion, pinions))


def bevel_wrist(
    bend_shaft: int = 20,
    bend: int = 30,
    roll_shaft: int = 25,
    idler: int = 40,
    idler_pinion: int = 24,
    tool: int = 18,
) -> Mechanism:
    """Make a robot wrist of bevels whose axes intersect in one point.

    Parameters
    ----------
    bend_shaft, bend : int, optional
        Teeth of the pair that bends it.
    roll_shaft, idler : int, optional
        Teeth of the pair that turns the idler.
    idler_pinion, tool : int, optional
        Teeth of the pair that turns the tool.

    Returns
    -------
    Mechanism
        Housing 1, bend shaft 2, bend 3, roll shaft 4, idler 5, tool 6.

    Raises
    ------
    ValueError
        For numbers out of range.
    """
    return Mechanism._of(
        _geargraph.bevel_wrist(bend_shaft, bend, roll_shaft, idler, idler_pinion, tool)
    )


def ravigneaux(
    small_sun: int = 30,
    large_sun: int = 36,
    short_planet: int = 20,
    long_planet: int = 18,
    pairs: int = 3,
) -> Mechanism:
    """Make a Ravigneaux gearbox with brakes, a clutch and the states 1, 2, 3 and R.

    Parameters
    ----------
    small_sun, large_sun, short_planet, long_planet : int, optional
        Teeth; the ring has large_sun + 2 long_planet.
    pairs : int, optional
        Pairs of planets, equally spaced.

    Returns
    -------
    Mechanism
        Small sun 1, large sun 2, ring 3, carrier 4, then the planets.

    Raises
    ------
    Error
        "teeth-geometry" if the planets cannot touch or collide, "assembly" if they do not go in
        evenly.
    """
    return Mechanism._of(
        _geargraph.ravigneaux(small_sun, large_sun, short_planet, long_planet, pairs)
    )


def simpson(sun: int = 24, planet: int = 18, planets: int = 3) -> Mechanism:
    """Make a Simpson gearbox: two equal planetary sets, with the states 1, 2, 3 and R.

    Parameters
    ----------
    sun, planet : int, optional
        Teeth of both sets.
    planets : int, optional
        Of each set, equally spaced.

    Returns
    -------
    Mechanism
        Suns 1, first ring 2, output 3, second carrier 4, then the planets.

    Raises
    ------
    Error
        "assembly" or "teeth-geometry".
    """
    return Mechanism._of(_geargraph.simpson(sun, planet, planets))
