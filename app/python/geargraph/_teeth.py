"""Whole teeth for wanted ratios of a drawn train."""

from __future__ import annotations

import json
from fractions import Fraction
from typing import Any, Dict, Mapping, NamedTuple, Optional, Tuple

from . import _geargraph
from ._lookup import Lookup
from ._numbers import text_of


class TeethChoice(NamedTuple):
    """Tooth counts with which a train has the wanted ratios.

    Attributes
    ----------
    teeth : dict of int to tuple of two int
        By label of the mesh: N_tail and N_head.
    ratios : tuple of Fraction
        By wish.
    errors : tuple of float
        Relative to what is wanted, by wish.
    error : float
        The largest of them without its sign.
    planets : tuple of int
        Numbers of equal planets that go in at equal distances and clear each other; none without
        planets.
    hunting : dict of int to bool
        By label of the mesh: have its two tooth counts no common factor?
    undercut : tuple of str
        Gears that are undercut without a profile shift, "15:tail".
    efficiency, efficiency_backward : float or None
        The smallest of the ratios, and with the power the other way; None without losses, and where
        the train locks itself.
    """

    teeth: Dict[int, Tuple[int, int]]
    ratios: Tuple[Fraction, ...]
    errors: Tuple[float, ...]
    error: float
    planets: Tuple[int, ...]
    hunting: Dict[int, bool]
    undercut: Tuple[str, ...]
    efficiency: Optional[float]
    efficiency_backward: Optional[float]


class TeethChoices(NamedTuple):
    """What a search for teeth found.

    Attributes
    ----------
    complete : bool
        Were all choices tried?
    tried : int
        Tooth counts within the limits with one centre distance between two axes.
    filters : dict of str to int
        How many of them pass each condition and all before it: "turns", "clears", "assembles", ...
    count : int
        How many meet the wish.
    choices : tuple of TeethChoice
        The best of them, the best first.
    nearest : TeethChoice or None
        Where there are none: what comes nearest.
    conflicts : tuple of tuples of int
        Where there are none: the positions of wished ratios that no choice meets, alone or two together.
    """

    complete: bool
    tried: int
    filters: Dict[str, int]
    count: int  # type: ignore[assignment]  # beside the method of tuples
    choices: Tuple[TeethChoice, ...]
    nearest: Optional[TeethChoice]
    conflicts: Tuple[Tuple[int, ...], ...]


class TeethCheck(NamedTuple):
    """What a check of a certificate found.

    Attributes
    ----------
    holds : bool
        Is every claim of the certificate true?
    faults : tuple of str
        Why not.
    tried : int
        Choices that were gone through again.
    count : int
        Those of them within the bounds.
    """

    holds: bool
    faults: Tuple[str, ...]
    tried: int
    count: int  # type: ignore[assignment]


def _choice(row: Mapping[str, Any]) -> TeethChoice:
    return TeethChoice(
        {int(mesh): (pair[0], pair[1]) for mesh, pair in row["teeth"].items()},
        tuple(Fraction(ratio) for ratio in row["ratios"]),
        tuple(float(error) for error in row["errors"]),
        float(row["error"]),
        tuple(row["planets"]),
        {int(mesh): hunting for mesh, hunting in row["hunting"].items()},
        tuple(row["undercut"]),
        row["efficiency"],
        row["efficiencyBackward"],
    )


class TeethSearch(Lookup):
    """The search for teeth."""

    def teeth(self, wish: Mapping[str, Any], limit: int = 20) -> TeethChoices:
        """Find all whole teeth with which this train has wanted ratios, or the best of them.

        Parameters
        ----------
        wish : mapping
            As ``geargraph-cli teeth`` reads it: ``ratios``, a list of ``drive``, ``driven``,
            ``held`` or ``state``, ``ratio`` and ``tolerance``, or ``between``; ``fewest``, ``most``,
            ``mostRing``, ``planets``, ``slack``, ``wheels``, ... Numbers may be fractions, links
            their labels or ids.
        limit : int, optional
            How many choices are given, the best first; all are counted.

        Returns
        -------
        TeethChoices
            The choices, with what was tried.

        Raises
        ------
        Error
            "schema" or "unknown-id" with the place in the wish; what the train has errors with.

        Examples
        --------
        >>> train = gg.sets.planetary(24, 18)
        >>> wish = {"drive": 1, "driven": 3, "held": [2], "ratio": "9/2"}
        >>> train.teeth({"ratios": [wish], "most": 60}).choices[0].teeth[13]
        (20, 25)
        """
        text = json.dumps(wish, default=text_of)
        found = json.loads(self._document.teeth(text, limit))
        return TeethChoices(
            found["complete"],
            found["tried"],
            {name: count for name, count in found["filters"]},
            found["count"],
            tuple(_choice(row) for row in found["choices"]),
            None if found["nearest"] is None else _choice(found["nearest"]),
            tuple(tuple(conflict) for conflict in found["conflicts"]),
        )

    def use_teeth(self, choice: TeethChoice) -> None:
        """Give all meshes the teeth of a choice, as one edit; places of axes follow.

        Parameters
        ----------
        choice : TeethChoice
            One of `teeth`.

        Raises
        ------
        Error
            "teeth-geometry" or "pitch-geometry" if the axes cannot follow.
        """
        links, joints, meshes = self._document.counts
        first = links + joints + 1
        rows = [(mesh - first, tail, head) for mesh, (tail, head) in choice.teeth.items()]
        if sorted(row[0] for row in rows) != list(range(meshes)):
            raise ValueError("the choice is of another mechanism")
        self._document = self._document.with_all_teeth(rows)

    def teeth_certificate(self, wish: Mapping[str, Any], limit: int = 20) -> str:
        """Find teeth, and write what proves that all were tried.

        Parameters
        ----------
        wish : mapping
            As for `teeth`.
        limit : int, optional
            How many choices are listed.

        Returns
        -------
        str
            JSON, which `check_teeth` checks.
        """
        return self._document.teeth_certificate(json.dumps(wish, default=text_of), limit)


def check_teeth(certificate: str) -> TeethCheck:
    """Go through all choices of a certificate again, with code of its own.

    Parameters
    ----------
    certificate : str
        As `Mechanism.teeth_certificate` and ``geargraph-cli teeth --certificate`` write it.

    Returns
    -------
    TeethCheck
        Whether it holds.

    Raises
    ------
    Error
        "syntax", "format", "version" or "schema" for what is no certificate.
    """
    holds, faults, tried, count = _geargraph.check_teeth(certificate)
    return TeethCheck(holds, tuple(faults), tried, count)
