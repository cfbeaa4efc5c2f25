"""Links, joints and the other elements of a mechanism, as it is now."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any, Dict, Optional, Tuple, Union

from ._errors import Element, Error, Diagnostic
from ._numbers import exact, exact_triple

if TYPE_CHECKING:
    from ._mechanism import Mechanism

LISTS = {
    "link": "links",
    "axis": "axes",
    "joint": "turningJoints",
    "mesh": "gearMeshes",
    "coupling": "couplings",
    "load": "loads",
}


def unknown(kind: str, reference: object) -> Error:
    """Make the exception for an element that is not there."""
    message = f"There is no {kind} {reference!r}."
    element = Element(kind, str(reference))
    found = (Diagnostic("error", "unknown-id", "", message, (element,)),)
    return Error(f"{message} [unknown-id]", "unknown-id", found)


class _Handle:
    """Names an element of a mechanism by its id; what it tells is what the mechanism holds now."""

    __slots__ = ("_mechanism", "id")
    _kind = ""

    def __init__(self, mechanism: Mechanism, id: str) -> None:
        self._mechanism = mechanism
        self.id = id

    @property
    def _data(self) -> Dict[str, Any]:
        return self._mechanism._element(self._kind, self.id)

    @property
    def element(self) -> Element:
        """Kind and id."""
        return Element(self._kind, self.id)

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, _Handle)
            and self._mechanism is other._mechanism
            and self.element == other.element
        )

    def __hash__(self) -> int:
        return hash((id(self._mechanism), self._kind, self.id))


class _Labelled(_Handle):
    __slots__ = ()

    @property
    def label(self) -> int:
        """The paper's number, which follows from the order in the document."""
        return self._mechanism._label(self._kind, self.id)

    def __repr__(self) -> str:
        return f"<{self._kind} {self.label}>"


class Link(_Labelled):
    """A rigid link; label 0 is the ground.

    Attributes
    ----------
    id : str
        Unique among the links; it stays when labels are renewed.
    """

    __slots__ = ()
    _kind = "link"

    # Members of the document, from core/mechanism/model/fields.h.

    @property
    def name(self) -> str:
        """What the link is called."""
        value = self._data.get("name")
        return "" if value is None else str(value)

    @property
    def pinned(self) -> bool:
        """Its gears keep their teeth while other things are fitted."""
        value = self._data.get("pinned")
        return False if value is None else bool(value)

    @property
    def mass(self) -> Optional[Fraction]:
        """For dynamics. Without it mass, centre and inertia follow from the link's solids; a mass
        alone is spread as the solids are (kg)."""
        value = self._data.get("mass")
        return None if value is None else exact(value)

    @property
    def center_of_mass(self) -> Optional[Tuple[Fraction, ...]]:
        """In the reference pose, base frame; only beside a ``mass``."""
        value = self._data.get("centerOfMass")
        return None if value is None else exact_triple(value)

    @property
    def inertia(self) -> Optional[Tuple[Fraction, ...]]:
        """About the centre of mass, along the axes of the base frame: xx, yy, zz, xy, xz, yz.
        Products as in the matrix: xy is minus the sum of m x y. Only beside a ``mass`` (kg m2)."""
        value = self._data.get("inertia")
        return None if value is None else exact_triple(value)

    @property
    def shapes(self) -> Tuple[Dict[str, Any], ...]:
        """3D files (STL, OBJ, PLY, GLB) that are shown with the link: ``{"file": "parts/arm.stl",
        "position": [0, 0, 12], "orientation": [90, 0, 0], "scale": 1}``."""
        value = self._data.get("shapes")
        return () if value is None else tuple(value)

    # End of members.

    def __repr__(self) -> str:
        return f"<link {self.label} {self.name!r}>" if self.name else f"<link {self.label}>"


class Axis(_Handle):
    """A line that turning joints turn about.

    Attributes
    ----------
    id : str
        Its letter.
    """

    __slots__ = ()
    _kind = "axis"

    @property
    def point(self) -> Tuple[float, float, float]:
        """A point of the line in the reference pose, base frame, in the document's unit; as stated,
        or where the program places it."""
        return self._mechanism._axis_line(self.id)[0]

    @property
    def direction(self) -> Tuple[float, float, float]:
        """Direction of the line, of length 1."""
        return self._mechanism._axis_line(self.id)[1]

    @property
    def placed(self) -> bool:
        """Does the document state both point and direction?"""
        return "point" in self._data and "direction" in self._data

    # Members of the document, from core/mechanism/model/fields.h.

    @property
    def pinned(self) -> bool:
        """It keeps its place while other things are fitted."""
        value = self._data.get("pinned")
        return False if value is None else bool(value)

    # End of members.

    def __repr__(self) -> str:
        return f"<axis {self.id}>"


class TurningJoint(_Labelled):
    """A turning pair: positive speed turns ``head`` about +direction of the axis against ``tail``.

    Attributes
    ----------
    id : str
        Unique among the turning joints.
    """

    __slots__ = ()
    _kind = "joint"

    @property
    def tail(self) -> Link:
        """The link that the joint turns against."""
        return Link(self._mechanism, self._data["tail"])

    @property
    def head(self) -> Link:
        """The link that it turns."""
        return Link(self._mechanism, self._data["head"])

    @property
    def axis(self) -> Axis:
        """The line that it turns about."""
        return Axis(self._mechanism, self._data["axis"])

    @property
    def offset(self) -> Fraction:
        """Where along the axis the bearing is drawn, from the axis's point, in the document's unit."""
        return exact(self._data.get("offset", 0))

    @property
    def kind(self) -> str:
        """"turning" or "sliding": along its axis then, with limits, offset and speeds in lengths."""
        return str(self._data.get("kind", "turning"))

    @property
    def limits(self) -> Tuple[Optional[Fraction], Optional[Fraction]]:
        """How far it may turn from the reference pose, degrees; None for an open end."""
        low, high = self._data.get("limits", (None, None))
        return (
            None if low is None else exact(low),
            None if high is None else exact(high),
        )

    # Members of the document, from core/mechanism/model/fields.h.

    # End of members.


class GearMesh(_Labelled):
    """A pair of gears in mesh.

    Attributes
    ----------
    id : str
        Unique among the meshes.
    """

    __slots__ = ()
    _kind = "mesh"

    @property
    def tail(self) -> Link:
        """The link with the first gear."""
        return Link(self._mechanism, self._data["tail"])

    @property
    def head(self) -> Link:
        """The link with the second gear."""
        return Link(self._mechanism, self._data["head"])

    @property
    def teeth(self) -> Tuple[int, int]:
        """Tooth counts of tail and head."""
        return int(self._data["tailTeeth"]), int(self._data["headTeeth"])

    @property
    def ratio(self) -> Fraction:
        """The paper's i = N_tail / N_head, Eq. (20)."""
        return Fraction(*self.teeth)

    @property
    def kind(self) -> Optional[str]:
        """"external", "internal" or "bevel", as stated or as the geometry tells; None where neither
        does."""
        geometry = self._mechanism._mesh_geometry(self.id)
        stated = self._data.get("kind")
        return geometry[0] if geometry else stated

    @property
    def pitch_point(self) -> Optional[Tuple[float, float, float]]:
        """Where the pitch surfaces touch in the reference pose, base frame, in the document's unit;
        None where the mesh has no geometry."""
        geometry = self._mechanism._mesh_geometry(self.id)
        return geometry[1] if geometry else None

    # Members of the document, from core/mechanism/model/fields.h.

    @property
    def tail_teeth(self) -> int:
        """Teeth of the first gear."""
        value = self._data.get("tailTeeth")
        return 0 if value is None else int(value)

    @property
    def head_teeth(self) -> int:
        """Teeth of the second gear; the ring of an internal pair has the more teeth."""
        value = self._data.get("headTeeth")
        return 0 if value is None else int(value)

    @property
    def face_width(self) -> Optional[Fraction]:
        """The width of the gears along the axis (bevel: the cone)."""
        value = self._data.get("faceWidth")
        return None if value is None else exact(value)

    @property
    def tail_wheel(self) -> Optional[str]:
        """The shape of the first gear. Without names, meshes on the same link, axis, tooth count
        and plane (bevel: same apex and side) share one wheel, and shifts follow from the centre
        distances."""
        value = self._data.get("tailWheel")
        return None if value is None else str(value)

    @property
    def head_wheel(self) -> Optional[str]:
        """The shape of the second gear."""
        value = self._data.get("headWheel")
        return None if value is None else str(value)

    @property
    def pinned(self) -> bool:
        """It keeps its module while other things are fitted."""
        value = self._data.get("pinned")
        return False if value is None else bool(value)

    @property
    def efficiency(self) -> Optional[Fraction]:
        """Of the power that crosses the teeth, seen from the carrier of the mesh."""
        value = self._data.get("efficiency")
        return None if value is None else exact(value)

    @property
    def friction(self) -> Optional[Fraction]:
        """The coefficient of friction of the teeth, instead of an ``efficiency``."""
        value = self._data.get("friction")
        return None if value is None else exact(value)

    @property
    def helix_angle(self) -> Optional[Fraction]:
        """Of the teeth of the first gear at its reference cylinder; of a bevel pair the spiral
        angle. Not of a worm, a face gear or a hypoid pair. The ratio does not depend on it
        (degrees)."""
        value = self._data.get("helixAngle")
        return None if value is None else exact(value)

    @property
    def hand(self) -> Any:
        """Of the helix of the first gear. That of the second follows: the opposite one of an
        external or bevel pair, the same of an internal one and of a worm, and of
        ``crossedHelical`` that which the crossing angle leaves. Right-hand bevel teeth turn
        clockwise outwards, seen from the apex."""
        value = self._data.get("hand")
        return None if value is None else value

    @property
    def herringbone(self) -> bool:
        """The helix changes its hand at mid face, so that no axial force is left; ``hand`` is that
        of the half on the side against the direction of the first gear's axis."""
        value = self._data.get("herringbone")
        return False if value is None else bool(value)

    @property
    def module(self) -> Optional[Fraction]:
        """The normal module; with the centre distance it fixes the sum of the profile shifts. Of a
        bevel pair or face gear without ``pitchPoint``: the transverse one at the large end, or at
        the pitch point; of a worm: in its axial section; of a rack, which needs it or a ``pitch``:
        that of the rack along its motion; of a hypoid pair without ``pitchPoint``: that of the
        larger gear at its pitch point."""
        value = self._data.get("module")
        return None if value is None else exact(value)

    @property
    def pressure_angle(self) -> Optional[Fraction]:
        """Of the teeth, in the normal section (degrees)."""
        value = self._data.get("pressureAngle")
        return None if value is None else exact(value)

    @property
    def crossed(self) -> bool:
        """Of a belt: its strands cross between the pulleys."""
        value = self._data.get("crossed")
        return False if value is None else bool(value)

    @property
    def pitch(self) -> Optional[Fraction]:
        """Of a belt: the length of one of its teeth; of a rack the same, along its motion, instead
        of a ``module``."""
        value = self._data.get("pitch")
        return None if value is None else exact(value)

    @property
    def tail_diameter(self) -> Optional[Fraction]:
        """Of a belt, instead of ``tailTeeth``: the running diameter of the first pulley; then also
        ``headDiameter``."""
        value = self._data.get("tailDiameter")
        return None if value is None else exact(value)

    @property
    def head_diameter(self) -> Optional[Fraction]:
        """The same of the second pulley."""
        value = self._data.get("headDiameter")
        return None if value is None else exact(value)

    @property
    def lead(self) -> Optional[Fraction]:
        """Of a screw, which needs it: its advance in one turn."""
        value = self._data.get("lead")
        return None if value is None else exact(value)

    # End of members.


class Coupling(_Handle):
    """A brake, which engaged holds a link against the ground, or a clutch between two links.

    Attributes
    ----------
    id : str
        Its letter.
    """

    __slots__ = ()
    _kind = "coupling"

    @property
    def kind(self) -> str:
        """"brake" or "clutch"."""
        return str(self._data["kind"])

    @property
    def links(self) -> Tuple[Link, ...]:
        """The link of a brake, or the two of a clutch."""
        data = self._data
        ids = [data["link"]] if "link" in data else data["links"]
        return tuple(Link(self._mechanism, id) for id in ids)

    @property
    def engaged(self) -> bool:
        """Is it engaged now?"""
        return self.id in self._mechanism.engaged

    # Members of the document, from core/mechanism/model/fields.h.

    @property
    def link(self) -> Optional[Link]:
        """The link that a brake holds."""
        value = self._data.get("link")
        return None if value is None else Link(self._mechanism, value)

    # End of members.

    def __repr__(self) -> str:
        return f"<{self.kind} {self.id}>"


class Load:
    """What acts on a mechanism in the reference pose; immutable.

    Attributes
    ----------
    id : str
        May be empty.
    joint, link : str or None
        The id of what bears it: one of the two.
    axis : str or None
        The axis about whose direction a torque on a link acts.
    torque : Fraction or None
        N m.
    force, point : tuple of Fraction, or None
        A force, N, and where it acts, base frame, in the document's unit.
    """

    __slots__ = ("id", "joint", "link", "axis", "torque", "force", "point")

    def __init__(self, data: Dict[str, Any]) -> None:
        self.id: str = data.get("id", "")
        self.joint: Optional[str] = data.get("joint")
        self.link: Optional[str] = data.get("link")
        self.axis: Optional[str] = data.get("axis")
        self.torque = exact(data["torque"]) if "torque" in data else None
        self.force = exact_triple(data["force"]) if "force" in data else None
        self.point = exact_triple(data["point"]) if "point" in data else None

    def __repr__(self) -> str:
        where = f"joint {self.joint}" if self.joint is not None else f"link {self.link}"
        return f"<load {self.id} on {where}>"


class ShiftState:
    """What is engaged together in a gear of a gearbox; immutable.

    Attributes
    ----------
    name : str
        Of the gear: "1", "R".
    engaged : tuple of str
        Ids of couplings.
    drive, driven : str or None
        Ids of the links whose speeds make the ratio.
    """

    __slots__ = ("name", "engaged", "drive", "driven")

    def __init__(self, data: Dict[str, Any]) -> None:
        self.name: str = data["name"]
        self.engaged: Tuple[str, ...] = tuple(data.get("engaged", ()))
        self.drive: Optional[str] = data.get("drive")
        self.driven: Optional[str] = data.get("driven")

    def __repr__(self) -> str:
        return f"<state {self.name!r}: {', '.join(self.engaged) or 'nothing engaged'}>"


LinkLike = Union[Link, str, int]
"""A link: itself, its id, its name where one link has it, or its label."""
JointLike = Union[TurningJoint, str, int]
"""A turning joint: itself, its id, or its label."""
MeshLike = Union[GearMesh, str, int]
"""A mesh: itself, its id, or its label."""
AxisLike = Union[Axis, str]
"""An axis: itself or its id."""
CouplingLike = Union[Coupling, str]
"""A coupling: itself or its id."""
