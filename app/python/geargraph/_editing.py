"""The edits of mechanisms. Each is atomic: a rejected one raises Error and changes nothing."""

from __future__ import annotations

from operator import index
from typing import (
    TYPE_CHECKING, Any, Iterable, List, Mapping, Optional, Sequence, Tuple, Union,
)

from ._elements import (
    Axis, AxisLike, Coupling, GearMesh, JointLike, Link, LinkLike, Load, MeshLike, TurningJoint,
)
from ._numbers import Number, optional_text, optional_triple, text_of
from ._shifting import ShiftEdits

if TYPE_CHECKING:
    from ._mechanism import Mechanism

ElementLike = Union[Link, Axis, TurningJoint, GearMesh, Coupling, Load]


class Edits(ShiftEdits):
    """The edits of links, joints and meshes."""

    # --- links, joints, meshes -------------------------------------------------------------------

    def add_link(self, name: str = "") -> Link:
        """Add a link, tied to nothing yet.

        Parameters
        ----------
        name : str, optional
            What it is called.

        Returns
        -------
        Link
            The last of the links.
        """
        self._document = self._document.with_link(name)
        return self._last(Link)

    def add_turning_joint(
        self,
        tail: LinkLike,
        head: LinkLike,
        axis: Optional[AxisLike] = None,
        *,
        point: Optional[Sequence[Number]] = None,
        direction: Optional[Sequence[Number]] = None,
        offset: Number = 0,
        limits: Optional[Tuple[Optional[Number], Optional[Number]]] = None,
    ) -> TurningJoint:
        """Add a turning joint from ``tail`` to ``head``.

        Parameters
        ----------
        tail, head : Link, str or int
            Positive speed turns ``head`` against ``tail``.
        axis : Axis or str, optional
            The line that it turns about; joints that stay coaxial share one. An id that no axis
            has makes a new axis; without it a new one with the next letter is made.
        point, direction : sequence of three numbers, optional
            Where a new axis is in the reference pose, base frame, in the document's unit; the
            direction has any length above 0. Without them it is placed from the tooth counts.
        offset : number, optional
            Where along the axis the bearing is drawn, from the axis's point.
        limits : tuple of two numbers or None, optional
            How far it may turn from the reference pose, degrees.

        Returns
        -------
        TurningJoint
            The last of the joints. The labels of all meshes grow by 1.

        Raises
        ------
        Error
            "self-joint", "unknown-id", "turning-loop" if it would close a loop of turning joints,
            "schema" for numbers beyond the limits of the format.
        """
        name = axis.id if isinstance(axis, Axis) else (axis or "")
        is_new = self._document.position("axis", name) < 0
        made = self._document.with_turning_joint(
            self._id(Link, tail), self._id(Link, head), "" if is_new else name
        )
        joint = made.last("joint")
        if is_new:
            letter = made.last("axis")
            if name:
                made, letter = made.with_renamed("axis", letter, name), name
            if point is not None or direction is not None:
                made = made.with_axis_placed(
                    letter, optional_triple(point), optional_triple(direction)
                )
        elif point is not None or direction is not None:
            raise ValueError("the axis exists; set_axis moves it")
        if text_of(offset) != "0":
            made = made.with_offset(joint, text_of(offset))
        if limits is not None:
            made = made.with_limits(joint, optional_text(limits[0]), optional_text(limits[1]))
        self._document = made
        return self._last(TurningJoint)

    def add_mesh(
        self,
        tail: LinkLike,
        head: LinkLike,
        teeth: Tuple[int, int] = (20, 20),
        *,
        kind: Optional[str] = None,
        pitch_point: Optional[Sequence[Number]] = None,
        efficiency: Optional[Number] = None,
        friction: Optional[Number] = None,
    ) -> GearMesh:
        """Add a gear mesh from ``tail`` to ``head``.

        Parameters
        ----------
        tail, head : Link, str or int
            The links with the two gears.
        teeth : tuple of two int, optional
            N_tail and N_head, 1 to 100,000 each; the paper's ratio i is N_tail / N_head.
        kind : {"external", "internal", "bevel"}, optional
            Without it the geometry decides; of an internal pair the ring has the more teeth.
        pitch_point : sequence of three numbers, optional
            Where the pitch surfaces touch, base frame; without it, it follows from axes and teeth.
        efficiency : number, optional
            Share of the power, seen from the carrier, that is not lost: above 0, at most 1.
        friction : number, optional
            Coefficient of friction of the teeth, 0 to 1; not beside an efficiency.

        Returns
        -------
        GearMesh
            The last of the meshes.

        Raises
        ------
        Error
            "self-joint", "unknown-id", "schema".
        """
        made = self._document.with_mesh(self._id(Link, tail), self._id(Link, head), *_pair(teeth))
        id = made.last("mesh")
        if kind is not None:
            made = made.with_mesh_kind(id, kind)
        if pitch_point is not None:
            made = made.with_pitch_point(id, optional_triple(pitch_point))
        if efficiency is not None or friction is not None:
            made = made.with_losses(id, optional_text(efficiency), optional_text(friction))
        self._document = made
        return self._last(GearMesh)

    def attach_gear(
        self, gear: LinkLike, carrier: LinkLike, teeth: Optional[Tuple[int, int]] = None
    ) -> Link:
        """Add a link with a gear that meshes with one on ``gear`` and turns in ``carrier``.

        Parameters
        ----------
        gear, carrier : Link, str or int
            The link that it meshes with, and the link that carries it.
        teeth : tuple of two int, optional
            Tooth counts of the gear that is there and of the new one.

        Returns
        -------
        Link
            The new link; its joint and mesh are the last of their lists.

        Raises
        ------
        Error
            "self-joint", "unknown-id", "schema".
        """
        made = self._document.with_gear_attached(self._id(Link, gear), self._id(Link, carrier))
        if teeth is not None:
            made = made.with_teeth(made.last("mesh"), *_pair(teeth))
        self._document = made
        return self._last(Link)

    def add_planets(self, planet: LinkLike, total: int) -> None:
        """Spread equal planets evenly: copies of one with its joint and its meshes.

        Parameters
        ----------
        planet : Link, str or int
            The planet that is there.
        total : int
            How many there are then, 1 to 100.

        Raises
        ------
        Error
            "schema" if the link is no planet, "assembly" if that many do not go in evenly.
        """
        self._document = self._document.with_planets(self._id(Link, planet), total)

    def insert(self, other: Mechanism) -> None:
        """Put another mechanism beside what is there, under ids that are free; the ground is shared.

        Parameters
        ----------
        other : Mechanism
            A gear set of `geargraph.sets`, for one.
        """
        self._document = self._document.with_set(other._document)

    def remove(self, *elements: ElementLike) -> None:
        """Remove elements and all that needs them.

        A link takes its joints, meshes, couplings and loads with it; an axis that is not used any
        more goes, too.

        Parameters
        ----------
        *elements : Link, TurningJoint, GearMesh, Coupling, Axis or Load
            What goes.

        Raises
        ------
        Error
            "unknown-id", or "schema" for the ground.
        """
        names: List[Tuple[str, str]] = []
        for element in elements:
            names.append(("load", element.id) if isinstance(element, Load) else element.element)
        self._document = self._document.without(names)

    def flip(self, element: Union[TurningJoint, GearMesh]) -> None:
        """Exchange tail and head of a joint or mesh, with its teeth.

        Parameters
        ----------
        element : TurningJoint or GearMesh
            Its column of the matrices changes its sign.
        """
        self._document = self._document.with_flipped(*element.element)

    def rename(self, element: Union[Link, Axis], name: str) -> None:
        """Give a link another name, or an axis another id.

        Parameters
        ----------
        element : Link or Axis
            The link or axis.
        name : str
            Another handle of the axis is needed then.

        Raises
        ------
        Error
            "duplicate-id" or "schema" for an axis.
        """
        self._document = self._document.with_renamed(*element.element, name)

    def merge_links(self, link: LinkLike, other: LinkLike) -> Link:
        """Weld two links to one: two gear sets become one gearbox.

        Joints, meshes, couplings and loads of `other` are then those of `link`. Where both turn on a
        third link, their axes become one line. The inputs stay a valid set.

        Parameters
        ----------
        link : Link, str or int
            The link that stays; of the ground and another link the ground stays.
        other : Link, str or int
            The link that goes.

        Returns
        -------
        Link
            The one that stayed.

        Raises
        ------
        Error
            "self-joint" for one link, or two that mesh with each other, "turning-loop" if the link
            would turn about two axes, "schema" for stated masses, or loads that lose their place.
        """
        kept, gone = self._id(Link, link), self._id(Link, other)
        after = self._document.with_links_merged(kept, gone)
        kept = gone if gone == self._id(Link, 0) else kept
        self._document = after
        mechanism: Any = self
        return Link(mechanism, kept)

    def split_link(
        self, link: LinkLike, *elements: Union[TurningJoint, GearMesh, Coupling]
    ) -> Link:
        """Divide a link: a new one takes some of its joints, meshes and couplings.

        The two turn about the axis on which the link is carried. So this undoes `merge_links` of
        coaxial links. A joint that becomes free is driven at its present speed where the document
        states inputs.

        Parameters
        ----------
        link : Link, str or int
            The link.
        *elements : TurningJoint, GearMesh or Coupling
            What the new link takes; without any, the side of the train that was drawn last.

        Returns
        -------
        Link
            The new one.

        Raises
        ------
        Error
            "schema" for the ground, for elements of other links, and if nothing would stay or go.
        """
        names: List[Tuple[str, str]] = [element.element for element in elements]
        self._document = self._document.with_link_split(self._id(Link, link), names)
        return self._last(Link)

    def set_ground(self, link: LinkLike) -> None:
        """Make a link the ground: it gets the label 0, and the labels of links follow.

        Parameters
        ----------
        link : Link, str or int
            The link.

        Raises
        ------
        Error
            "schema" if loads act on it.
        """
        self._document = self._document.with_ground(self._id(Link, link))

    # --- geometry --------------------------------------------------------------------------------

    def set_axis(
        self,
        axis: AxisLike,
        point: Optional[Sequence[Number]] = None,
        direction: Optional[Sequence[Number]] = None,
    ) -> None:
        """Place an axis, or leave its place to the program.

        Parameters
        ----------
        axis : Axis or str
            The axis.
        point, direction : sequence of three numbers, optional
            In the reference pose, base frame; None leaves them to the program.

        Raises
        ------
        Error
            "unknown-id", or "schema" for a direction of length 0.
        """
        self._document = self._document.with_axis_placed(
            self._id(Axis, axis), optional_triple(point), optional_triple(direction)
        )

    def set_joint_axis(self, joint: JointLike, axis: AxisLike) -> None:
        """Let a joint turn about another axis.

        Parameters
        ----------
        joint : TurningJoint, str or int
            The joint.
        axis : Axis or str
            An axis that exists.

        Raises
        ------
        Error
            "unknown-id".
        """
        self._document = self._document.with_joint_axis(
            self._id(TurningJoint, joint), self._id(Axis, axis)
        )

    def set_offset(self, joint: JointLike, offset: Number) -> None:
        """Set where along its axis the bearing of a joint is drawn.

        Parameters
        ----------
        joint : TurningJoint, str or int
            The joint.
        offset : number
            From the axis's point, in the document's unit.
        """
        self._document = self._document.with_offset(
            self._id(TurningJoint, joint), text_of(offset)
        )

    def set_limits(
        self, joint: JointLike, low: Optional[Number] = None, high: Optional[Number] = None
    ) -> None:
        """Limit how far a joint may turn from the reference pose.

        Parameters
        ----------
        joint : TurningJoint, str or int
            The joint.
        low, high : number, optional
            Degrees, ``low`` at most 0 and ``high`` at least 0; None for an open end.

        Raises
        ------
        Error
            "schema" if the reference pose is beyond them.
        """
        self._document = self._document.with_limits(
            self._id(TurningJoint, joint), optional_text(low), optional_text(high)
        )

    def set_teeth(self, mesh: MeshLike, teeth: Tuple[int, int], fit: bool = False) -> None:
        """Set the tooth counts of a mesh.

        Parameters
        ----------
        mesh : GearMesh, str or int
            The mesh.
        teeth : tuple of two int
            N_tail and N_head.
        fit : bool, optional
            Let everything else follow that has to: other meshes of the same gears, the ring of a
            planetary set, places of axes that are stated.

        Raises
        ------
        Error
            "schema" beyond 1 to 100,000; with ``fit`` "teeth-geometry" or "pitch-geometry" if
            nothing fits.
        """
        id = self._id(GearMesh, mesh)
        edit = self._document.with_teeth_fitted if fit else self._document.with_teeth
        self._document = edit(id, *_pair(teeth))

    def set_kind(self, mesh: MeshLike, kind: Optional[str]) -> None:
        """Set the kind of a mesh, or let the geometry decide.

        Parameters
        ----------
        mesh : GearMesh, str or int
            The mesh.
        kind : {"external", "internal", "bevel"} or None
            None: the geometry decides.
        """
        self._document = self._document.with_mesh_kind(self._id(GearMesh, mesh), kind)

    def set_pitch_point(self, mesh: MeshLike, point: Optional[Sequence[Number]]) -> None:
        """Set where the pitch surfaces of a mesh touch, or let it follow from axes and teeth.

        Parameters
        ----------
        mesh : GearMesh, str or int
            The mesh.
        point : sequence of three numbers or None
            In the reference pose, base frame, in the document's unit.
        """
        self._document = self._document.with_pitch_point(
            self._id(GearMesh, mesh), optional_triple(point)
        )

    def pin(self, element: Union[Link, Axis, GearMesh], pinned: bool = True) -> None:
        """Keep what an element has while other things are fitted.

        Parameters
        ----------
        element : Link, Axis or GearMesh
            An axis keeps its place, the gears of a link their teeth, a mesh its module.
        pinned : bool, optional
            False lets it go.
        """
        self._document = self._document.with_pinned(*element.element, pinned)

    # --- motion ----------------------------------------------------------------------------------

    def set_inputs(
        self, speeds: Optional[Union[Mapping[Any, Number], Iterable[JointLike]]]
    ) -> None:
        """Set the driven joints.

        Parameters
        ----------
        speeds : mapping, iterable or None
            Speeds in rad/s by joint, or joints that turn at 1 rad/s, in the order of the
            solution's columns; None leaves the choice to the program.

        Raises
        ------
        Error
            "unknown-id", "duplicate-id". Whether the set is valid is found by the analysis
            ("invalid-inputs").
        """
        if speeds is None:
            self._document = self._document.with_inputs(None)
            return
        pairs = speeds.items() if isinstance(speeds, Mapping) else ((joint, 1) for joint in speeds)
        self._document = self._document.with_inputs(
            [(self._id(TurningJoint, joint), text_of(speed)) for joint, speed in pairs]
        )


def _pair(teeth: Tuple[int, int]) -> Tuple[int, int]:
    tail, head = (index(count) for count in teeth)
    if not 0 <= min(tail, head) <= max(tail, head) < 2**31:
        raise ValueError(f"a gear has 1 to 100,000 teeth, not {tail} or {head}")
    return tail, head
