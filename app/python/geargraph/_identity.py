"""Which chains of the atlas a train is made of."""

from __future__ import annotations

from typing import Dict, NamedTuple, Optional, Tuple

from ._teeth import TeethSearch


class IdentifiedChain(NamedTuple):
    """A part of a train that has at most one link in common with the others.

    Attributes
    ----------
    links, meshes : tuple of int
        By label.
    dof : int
        With the teeth that are drawn, one link held.
    locked : bool
        Do links turn as one for all teeth?
    rotation, displacement : str or None
        Numbers of its equations and of the chain in the atlas; None beyond it.
    """

    links: Tuple[int, ...]
    meshes: Tuple[int, ...]
    dof: int
    locked: bool
    rotation: Optional[str]
    displacement: Optional[str]


class Identity(NamedTuple):
    """Which chains a train is made of.

    Attributes
    ----------
    removed : dict of int to str
        Links that were left out, by label: "copy" of a planet, or in "no-mesh".
    chains : tuple of IdentifiedChain
        The parts of what stays.
    """

    removed: Dict[int, str]
    chains: Tuple[IdentifiedChain, ...]


class Identification(TeethSearch):
    """Looks trains up in the atlas."""

    def identify(self) -> Identity:
        """Tell which geared kinematic chains this train is made of.

        Returns
        -------
        Identity
            Its chains with their numbers, and what was left out.

        Raises
        ------
        Error
            What the train has errors with.

        Examples
        --------
        >>> gg.sets.planetary(24, 18).identify().chains[0].displacement
        '4-1.1.1'
        """
        removed, chains = self._document.identify()
        return Identity(
            dict(removed),
            tuple(
                IdentifiedChain(tuple(links), tuple(meshes), dof, locked, rotation, displacement)
                for links, meshes, dof, locked, rotation, displacement in chains
            ),
        )
