"""Mechanisms from wishes: gearboxes and hub gears from ratios, chains of the atlas."""

from __future__ import annotations

import json
from fractions import Fraction
from typing import Any, Dict, Mapping, NamedTuple, Optional, Tuple

from . import _geargraph
from ._errors import Error
from ._mechanism import Mechanism
from ._numbers import text_of


class FoundGearbox(NamedTuple):
    """A gearbox with wanted ratios.

    Attributes
    ----------
    mechanism : Mechanism
        It as a document, with brakes, clutches and a state for each gear.
    ratios : dict of str to Fraction
        By gear, "1", "2", ..., "R": input over output.
    engaged : dict of str to tuple of str
        By gear: the elements that it engages.
    error : float
        The largest difference from a wanted ratio, relative to it.
    buildable : bool
        Can its section be drawn without shafts that cross?
    data : dict
        All that ``geargraph-cli gearbox --json`` tells of it.
    """

    mechanism: Mechanism
    ratios: Dict[str, Fraction]
    engaged: Dict[str, Tuple[str, ...]]
    error: float
    buildable: bool
    data: Dict[str, Any]


class GearboxSearch(NamedTuple):
    """What a search for gearboxes found.

    Attributes
    ----------
    complete : bool
        Was nothing left out? False wherever ratios of ring to sun were sampled.
    layouts : int
        That were searched: all within the limits.
    count : int
        Gearboxes that were found.
    gearboxes : tuple of FoundGearbox
        The first of them: fewest elements, buildable, least error.
    """

    complete: bool
    layouts: int
    count: int  # type: ignore[assignment]  # beside the method of tuples
    gearboxes: Tuple[FoundGearbox, ...]


class FoundHub(NamedTuple):
    """What may be inside a hub gear.

    Attributes
    ----------
    mechanism : Mechanism
        It as a document, with a state for each gear.
    ratios : tuple of Fraction
        By gear: hub shell over driver.
    data : dict
        All that ``geargraph-cli hardware --json`` tells of it: the teeth of its sets.
    """

    mechanism: Mechanism
    ratios: Tuple[Fraction, ...]
    data: Dict[str, Any]


class HubSearch(NamedTuple):
    """What a search for hub gears found.

    Attributes
    ----------
    complete : bool
        Were all teeth within the limits tried?
    count : int
        Candidates of which equal planets can be assembled.
    candidates : tuple of FoundHub
        The first of them.
    shared : dict of str to int
        Wheels with the same teeth in all candidates, "1.ring".
    decide : dict or None
        The wheel to count or the gear to measure whose worst answer leaves the fewest candidates.
    data : dict
        All that ``geargraph-cli hardware --json`` tells.
    """

    complete: bool
    count: int  # type: ignore[assignment]
    candidates: Tuple[FoundHub, ...]
    shared: Dict[str, int]
    decide: Optional[Dict[str, Any]]
    data: Dict[str, Any]


class AtlasChain(NamedTuple):
    """A geared kinematic chain of the atlas; its links count from 1.

    Attributes
    ----------
    number : str
        "6-1.5.1": links, freedom, number of the equations, number among those with them.
    axes : tuple of tuple of int
        The links that turn on each axis.
    meshes : tuple of tuple of int
        Of each gear pair its two gears and their carrier.
    """

    number: str
    axes: Tuple[Tuple[int, ...], ...]
    meshes: Tuple[Tuple[int, int, int], ...]

    def mechanism(self, frame: Optional[int] = None) -> Mechanism:
        """Make a document of the chain, with axes, teeth and places.

        Parameters
        ----------
        frame : int, optional
            The link that is held; without it one with which the bodies have room.

        Returns
        -------
        Mechanism
            The document.
        """
        return atlas_document(self.number, frame)


def gearbox(wish: Mapping[str, Any], limit: int = 20) -> GearboxSearch:
    """Search for gearboxes with wanted ratios, on all processors but one.

    Parameters
    ----------
    wish : mapping
        As ``geargraph-cli gearbox`` reads it: ``forward``, ``reverse``, ``tolerance``, ``sets``,
        ``links``, ``elements``, ... Numbers may be fractions.
    limit : int, optional
        How many gearboxes are given.

    Returns
    -------
    GearboxSearch
        The gearboxes, with what was searched.

    Raises
    ------
    Error
        "schema" with the place in the wish.

    Examples
    --------
    >>> wish = {"forward": ["2.52", "1.52", "1"], "tolerance": 0.01, "links": 5, "reverse": None}
    >>> found = gg.gearbox({**wish, "sets": ["simple", "simple"], "elements": 4}, limit=1)
    >>> len(found.gearboxes[0].mechanism.states)
    3
    """
    if limit < 0:
        raise ValueError("limit is a whole number from 0 on")
    text, documents = _geargraph.gearbox(json.dumps(wish, default=text_of), limit)
    found = json.loads(text)
    return GearboxSearch(
        found["complete"],
        found["layouts"],
        found["count"],
        tuple(
            FoundGearbox(
                Mechanism._of(document),
                {state["name"]: Fraction(state["ratio"]) for state in row["states"]},
                {state["name"]: tuple(state["engaged"]) for state in row["states"]},
                float(row["error"]),
                row["buildable"],
                row,
            )
            for row, document in zip(found["gearboxes"], documents)
        ),
    )


def hardware(wish: Mapping[str, Any], limit: int = 20) -> HubSearch:
    """Find what may be inside a hub gear with the ratios of its maker's sheet.

    Parameters
    ----------
    wish : mapping
        As ``geargraph-cli hardware`` reads it: ``ratios``, ``sets``, ``stepped``, ``counted``, ...
    limit : int, optional
        How many candidates are given.

    Returns
    -------
    HubSearch
        The candidates, what they share, and what to count.

    Raises
    ------
    Error
        "schema" with the place in the wish.
    """
    if limit < 0:
        raise ValueError("limit is a whole number from 0 on")
    text, documents = _geargraph.hardware(json.dumps(wish, default=text_of), limit)
    found = json.loads(text)
    return HubSearch(
        found["complete"],
        found["count"],
        tuple(
            FoundHub(Mechanism._of(document), tuple(Fraction(each) for each in row["ratios"]), row)
            for row, document in zip(found["candidates"], documents)
        ),
        found["shared"],
        found["decide"],
        found,
    )


def atlas(
    links: Optional[int] = None,
    dof: int = 1,
    axes: Optional[int] = None,
    nonfractionated: bool = False,
) -> Tuple[AtlasChain, ...]:
    """List geared kinematic chains of up to 7 links.

    Parameters
    ----------
    links : int, optional
        Only chains of so many links.
    dof : int, optional
        Of this freedom: 1, 2, or 0 for trains that cannot turn.
    axes : int, optional
        With so many axes.
    nonfractionated : bool, optional
        Only those that no link parts, with every link in a gear pair.

    Returns
    -------
    tuple of AtlasChain
        The chains, by number.

    Examples
    --------
    >>> len(gg.atlas(links=5))
    13
    """
    return tuple(
        AtlasChain(number, tuple(tuple(axis) for axis in chain_axes), tuple(meshes))
        for number, chain_axes, meshes in _geargraph.atlas(links, dof, axes, nonfractionated)
    )


def atlas_document(number: str, frame: Optional[int] = None) -> Mechanism:
    """Make a document of a chain of the atlas.

    Parameters
    ----------
    number : str
        Of the chain, "6-1.12.1".
    frame : int, optional
        The link that is held, from 1.

    Returns
    -------
    Mechanism
        The document.

    Raises
    ------
    Error
        "unknown-id" if the atlas has no chain of this number.
    """
    document = _geargraph.atlas_document(number, frame)
    if document is None:
        raise Error(f"The atlas has no chain {number}.", "unknown-id")
    return Mechanism._of(document)
