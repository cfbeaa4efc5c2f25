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

    @property
    def name(self) -> str:
        """What the link is called; may be empty."""
        return str(self._data.get("name", ""))

    @property
    def pinned(self) -> bool:
        """Do its gears keep their teeth while others are fitted?"""
        return bool(self._data.get("pinned", False))

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

    @property
    def pinned(self) -> bool:
        """Does it keep its place while others are fitted?"""
        return bool(self._data.get("pinned", False))

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
    def limits(self) -> Tuple[Optional[Fraction], Optional[Fraction]]:
        """How far it may turn from the reference pose, degrees; None for an open end."""
        low, high = self._data.get("limits", (None, None))
        return (
            None if low is None else exact(low),
            None if high is None else exact(high),
        )


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

    @property
    def efficiency(self) -> Optional[Fraction]:
        """The efficiency that the mesh states."""
        value = self._data.get("efficiency")
        return None if value is None else exact(value)

    @property
    def friction(self) -> Optional[Fraction]:
        """The coefficient of friction that the mesh states."""
        value = self._data.get("friction")
        return None if value is None else exact(value)


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
