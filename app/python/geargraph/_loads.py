"""The edits of loads, balances and losses."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterable, List, Optional, Sequence, Tuple, Type, TypeVar, Union

from . import _geargraph
from ._elements import (
    Axis, AxisLike, GearMesh, JointLike, Link, LinkLike, Load, MeshLike, ShiftState,
    TurningJoint, _Handle,
)
from ._numbers import Number, optional_text, optional_triple, text_of, triple_of

_Found = TypeVar("_Found", bound=_Handle)


class LoadEdits:
    """What edits need of a mechanism, and the edits of what acts on it."""

    _document: _geargraph.Document
    _folder: str

    if TYPE_CHECKING:

        @property
        def states(self) -> Tuple[ShiftState, ...]: ...
        @property
        def loads(self) -> Tuple[Load, ...]: ...
        def _resolved(self, made: Type[_Found], reference: Any) -> _Found: ...

    def _id(self, made: Type[_Found], reference: Any) -> str:
        return self._resolved(made, reference).id

    def _last(self, made: Type[_Found]) -> _Found:
        mechanism: Any = self
        return made(mechanism, self._document.last(made._kind))

    def add_torque(
        self,
        torque: Number,
        *,
        joint: Optional[JointLike] = None,
        link: Optional[LinkLike] = None,
        axis: Optional[AxisLike] = None,
        id: str = "",
    ) -> Load:
        """Add a torque in a joint, or from outside on a link.

        Parameters
        ----------
        torque : number
            N m. In a joint: by its tail on its head about +direction of its axis.
        joint : TurningJoint, str or int, optional
            The joint; or
        link : Link, str or int, optional
            the link, whose reaction the ground takes.
        axis : Axis or str, optional
            About whose direction a torque on a link acts; without it, it is the first axis on the
            link's way to the ground.
        id : str, optional
            Without it "L1", "L2", ...

        Returns
        -------
        Load
            The last of the loads.

        Raises
        ------
        Error
            "unknown-id", "duplicate-id", "schema" for a load on the ground.
        ValueError
            If not just one of ``joint`` and ``link`` is given.
        """
        if (joint is None) == (link is None):
            raise ValueError("give a joint or a link")
        if joint is not None:
            place = self._id(TurningJoint, joint)
            self._document = self._document.with_joint_torque(id, place, text_of(torque))
        else:
            about = None if axis is None else self._id(Axis, axis)
            place = self._id(Link, link)
            self._document = self._document.with_link_torque(id, place, about, text_of(torque))
        return self.loads[-1]

    def add_force(
        self, link: LinkLike, force: Sequence[Number], point: Sequence[Number], id: str = ""
    ) -> Load:
        """Add a force from outside on a link; the ground takes the reaction.

        Parameters
        ----------
        link : Link, str or int
            The link.
        force : sequence of three numbers
            N, base frame.
        point : sequence of three numbers
            Where it acts in the reference pose, base frame, in the document's unit.
        id : str, optional
            Without it "L1", "L2", ...

        Returns
        -------
        Load
            The last of the loads.

        Raises
        ------
        Error
            "unknown-id", "duplicate-id", "schema" for a load on the ground.
        """
        self._document = self._document.with_force(
            id, self._id(Link, link), triple_of(force), triple_of(point)
        )
        return self.loads[-1]

    def set_balances(
        self, places: Optional[Iterable[Union[TurningJoint, Link, Tuple[Link, AxisLike]]]]
    ) -> None:
        """Set where torques are found that hold the loads.

        Parameters
        ----------
        places : iterable of TurningJoint, Link or (Link, Axis), or None
            None: the inputs that bear no load of their own.

        Raises
        ------
        Error
            "unknown-id", "duplicate-id", "schema" for the ground.
        """
        if places is None:
            self._document = self._document.with_balances(None)
            return
        named: List[Tuple[str, str, Optional[str]]] = []
        for place in places:
            if isinstance(place, TurningJoint):
                named.append(("joint", self._id(TurningJoint, place), None))
            elif isinstance(place, Link):
                named.append(("link", self._id(Link, place), None))
            else:
                link, axis = place
                named.append(("link", self._id(Link, link), self._id(Axis, axis)))
        self._document = self._document.with_balances(named)

    def set_losses(
        self,
        mesh: Optional[MeshLike] = None,
        *,
        efficiency: Optional[Number] = None,
        friction: Optional[Number] = None,
    ) -> None:
        """Set the losses of a mesh, or of all meshes that state none.

        Parameters
        ----------
        mesh : GearMesh, str or int, optional
            Without it all meshes that state neither.
        efficiency : number, optional
            Share of the power, seen from the carrier, that is not lost: above 0, at most 1; or
        friction : number, optional
            coefficient of friction of the teeth, 0 to 1. Without both nothing is stated.

        Raises
        ------
        Error
            "schema" for both, or for a number out of its range.
        """
        self._document = self._document.with_losses(
            None if mesh is None else self._id(GearMesh, mesh),
            optional_text(efficiency),
            optional_text(friction),
        )

    def set_sharing(self, sharing: Optional[str]) -> None:
        """Set how loads are shared where the balances leave that open.

        Parameters
        ----------
        sharing : "stiffness" or None
            By equal stiffness of the teeth; or open, and by stiffness only where losses need it.

        Raises
        ------
        ValueError
            For another word.
        """
        if sharing not in (None, "stiffness"):
            raise ValueError(f'sharing is "stiffness" or None, not {sharing!r}')
        self._document = self._document.with_sharing(sharing is not None)

    def set_drive_torque(self, torque: Optional[Number]) -> None:
        """Set the torque at the drive of every state, for the shift table.

        Parameters
        ----------
        torque : number or None
            N m; None: the torques of the shift table follow from the loads.

        Raises
        ------
        Error
            "schema" for a number beyond the limits.
        """
        self._document = self._document.with_drive_torque(optional_text(torque))

    def add_shape(
        self,
        link: LinkLike,
        file: str,
        *,
        position: Optional[Sequence[Number]] = None,
        orientation: Optional[Sequence[Number]] = None,
        scale: Optional[Number] = None,
    ) -> None:
        """Show a 3D file (STL, OBJ, PLY, GLB) with a link.

        Parameters
        ----------
        link : Link, str or int
            The link.
        file : str
            A path from the folder of the document, with slashes, that stays inside it.
        position : sequence of three numbers, optional
            Where the file's origin is, base frame, in the document's unit.
        orientation : sequence of three numbers, optional
            Degrees about x, then y, then z of the base frame.
        scale : number, optional
            Above 0.

        Raises
        ------
        Error
            "unknown-id", or "schema" for a path that leads out of the folder.
        """
        self._document = self._document.with_shape(
            self._id(Link, link), file, optional_triple(position), optional_triple(orientation),
            optional_text(scale),
        )

    # --- masses ----------------------------------------------------------------------------------

    def set_density(self, density: Optional[Number]) -> None:
        """Set the density of all solids.

        Parameters
        ----------
        density : number or None
            kg/m³, above 0; None: 7850, that of steel.
        """
        self._document = self._document.with_density(optional_text(density))

    def set_gravity(self, gravity: Optional[Sequence[Number]]) -> None:
        """Set the acceleration of free fall.

        Parameters
        ----------
        gravity : sequence of three numbers or None
            m/s², base frame, ``(0, 0, -9.81)``; None for no weight.
        """
        self._document = self._document.with_gravity(optional_triple(gravity))

    def set_mass(
        self,
        link: LinkLike,
        mass: Optional[Number],
        center: Optional[Sequence[Number]] = None,
        inertia: Optional[Sequence[Number]] = None,
    ) -> None:
        """State the mass of a moving link, or leave it to its solids.

        Parameters
        ----------
        link : Link, str or int
            The link.
        mass : number or None
            kg, at least 0; None: that of its solids.
        center : sequence of three numbers, optional
            Centre of mass in the reference pose, base frame, in the document's unit; else that of
            the solids.
        inertia : sequence of six numbers, optional
            About the centre along the axes of the base frame, kg m²: xx, yy, zz, xy, xz, yz.

        Raises
        ------
        Error
            "schema" if no body has such an inertia.
        ValueError
            If the inertia has not six numbers.
        """
        texts: Optional[Tuple[str, str, str, str, str, str]] = None
        if inertia is not None:
            if isinstance(inertia, str) or len(inertia) != 6:
                raise ValueError("an inertia has six components: xx, yy, zz, xy, xz, yz")
            xx, yy, zz, xy, xz, yz = (text_of(number) for number in inertia)
            texts = (xx, yy, zz, xy, xz, yz)
        self._document = self._document.with_mass(
            self._id(Link, link), optional_text(mass), optional_triple(center), texts
        )
