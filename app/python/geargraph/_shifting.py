"""The edits of brakes, clutches and states."""

from __future__ import annotations

from typing import Iterable, Optional

from ._elements import Coupling, CouplingLike, Link, LinkLike, ShiftState
from ._loads import LoadEdits


class ShiftEdits(LoadEdits):
    """The edits of what is engaged."""

    def add_brake(self, link: LinkLike, id: str = "") -> Coupling:
        """Add a brake, which engaged holds a link against the ground.

        Parameters
        ----------
        link : Link, str or int
            The link.
        id : str, optional
            Its letter; without it the first that is free.

        Returns
        -------
        Coupling
            The brake, released.

        Raises
        ------
        Error
            "unknown-id", "duplicate-id", "schema" for the ground.
        """
        self._document = self._document.with_brake(self._id(Link, link), id)
        return self._last(Coupling)

    def add_clutch(self, one: LinkLike, other: LinkLike, id: str = "") -> Coupling:
        """Add a clutch, which engaged makes two links turn as one.

        Parameters
        ----------
        one, other : Link, str or int
            The links.
        id : str, optional
            Its letter; without it the first that is free.

        Returns
        -------
        Coupling
            The clutch, released.

        Raises
        ------
        Error
            "unknown-id", "duplicate-id", "self-joint".
        """
        self._document = self._document.with_clutch(
            self._id(Link, one), self._id(Link, other), id
        )
        return self._last(Coupling)

    def add_freewheel(self, first: LinkLike, second: LinkLike, id: str = "") -> Coupling:
        """Add a freewheel: the first link may not turn faster than the second.

        Which of them lock in a state follows from its drive; a state names none.

        Parameters
        ----------
        first, second : Link, str or int
            The links, in +direction of the axis of the first one's own joint. One may be the ground.
        id : str, optional
            Its letter; without it the first that is free.

        Returns
        -------
        Coupling
            The freewheel, not locked.

        Raises
        ------
        Error
            "unknown-id", "duplicate-id", "self-joint".
        """
        self._document = self._document.with_freewheel(
            self._id(Link, first), self._id(Link, second), id
        )
        return self._last(Coupling)

    def add_state(
        self,
        name: Optional[str] = None,
        engaged: Iterable[CouplingLike] = (),
        drive: Optional[LinkLike] = None,
        driven: Optional[LinkLike] = None,
    ) -> ShiftState:
        """Add a state of a gearbox.

        Parameters
        ----------
        name : str, optional
            Of the gear; without it the first whole number that is free.
        engaged : iterable of Coupling or str, optional
            What is engaged together.
        drive, driven : Link, str or int, optional
            The links whose speeds make the ratio; without them those of the state before.

        Returns
        -------
        ShiftState
            The last of the states.

        Raises
        ------
        Error
            "unknown-id", "duplicate-id".
        """
        self._document = self._document.with_state(
            name,
            [self._id(Coupling, each) for each in engaged],
            None if drive is None else self._id(Link, drive),
            None if driven is None else self._id(Link, driven),
        )
        return self.states[-1]

    def remove_state(self, name: str) -> None:
        """Remove a state.

        Parameters
        ----------
        name : str
            Of the state.

        Raises
        ------
        Error
            "unknown-id".
        """
        self._document = self._document.without_state(name)

    def engage(self, *couplings: CouplingLike) -> None:
        """Engage exactly these couplings; without any release all.

        Inputs follow, so that they stay valid: joints that couplings decide are driven no longer.

        Parameters
        ----------
        *couplings : Coupling or str
            What is engaged then.

        Raises
        ------
        Error
            "unknown-id", "duplicate-id", "turning-loop" if a coupling closes a linkage.
        """
        self._document = self._document.with_engaged(
            [self._id(Coupling, each) for each in couplings]
        )

    def engage_state(self, name: str) -> None:
        """Engage the couplings of a state, with its drive at 1 rad/s.

        Parameters
        ----------
        name : str
            Of the state.

        Raises
        ------
        Error
            "unknown-id", "turning-loop" if a coupling closes a linkage.
        """
        self._document = self._document.with_state_engaged(name)
