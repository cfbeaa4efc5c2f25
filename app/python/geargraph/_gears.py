"""Gears and other solids, as arrays of vertices."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Tuple

from . import _geargraph
from ._numbers import array

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt


class Mesh3D:
    """A closed surface of triangles; immutable.

    Vertices at a crease are there once for each side, with equal positions: joining equal positions
    closes the surface.
    """

    __slots__ = ("_packed",)

    def __init__(self, packed: Tuple[bytes, bytes, bytes]) -> None:
        self._packed = packed

    @property
    def vertices(self) -> npt.NDArray[np.float32]:
        """Positions, float32 of shape ``(vertices, 3)``, in the document's unit; read-only."""
        return array(self._packed[0], "=f4", -1, 3)

    @property
    def normals(self) -> npt.NDArray[np.float32]:
        """Outward unit normals, float32 of shape ``(vertices, 3)``; read-only."""
        return array(self._packed[1], "=f4", -1, 3)

    @property
    def triangles(self) -> npt.NDArray[np.uint32]:
        """Positions of corners, uint32 of shape ``(triangles, 3)``, counter-clockwise seen from
        outside; read-only."""
        return array(self._packed[2], "=u4", -1, 3)

    @property
    def volume(self) -> float:
        """Volume that the surface encloses, in the cube of the document's unit."""
        import numpy as np

        corners = self.vertices.astype(np.float64)[self.triangles]
        return float(np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6)

    def __repr__(self) -> str:
        return f"<Mesh3D, {len(self._packed[2]) // 12} triangles>"


class Gear:
    """A toothed wheel of a mechanism; immutable.

    Its frame: axis +z, tooth 0 centred on +x; spur gears and rings centred on z = 0, bevels with
    the apex at the origin.

    Attributes
    ----------
    name : str
        "15:tail" after the label of its mesh, or the id of its wheel.
    link : int
        Label of the link that it turns with.
    meshes : tuple of int
        Labels of its meshes.
    kind : str
        "external", "internal" (a ring), "bevel", "pulley" (of a belt), "worm" or "wormWheel".
    teeth : int
        Their number.
    module : float
        At the reference circle, of bevels at the large end; in the document's unit, as all lengths.
        Of a helical gear module, pressure angle and shift are those of the transverse section.
    pressure_angle, cone_angle, helix_angle : float
        rad; the pitch cone of a bevel; the helix at the reference circle, positive right-hand.
    profile_shift : float
        In modules.
    thinning, face_width, bore : float
        This gear's part of the backlash; of a bevel along the pitch cone; diameter, 0 for none.
    pitch_radius, tip_radius, root_radius : float
        Of the circles; of a bevel at the large end.
    """

    def __init__(
        self,
        snapshot: _geargraph.Snapshot,
        first_mesh: int,
        row: Tuple[str, int, Tuple[int, ...], Dict[str, Any], bytes],
    ) -> None:
        self._snapshot = snapshot
        self.name, self.link, meshes, values, self._pose = row
        self.meshes = tuple(first_mesh + mesh for mesh in meshes)
        self.kind: str = values["kind"]
        self.teeth: int = values["teeth"]
        self.module: float = values["module"]
        self.pressure_angle: float = values["pressure_angle"]
        self.cone_angle: float = values["cone_angle"]
        self.helix_angle: float = values["helix_angle"]
        self.profile_shift: float = values["profile_shift"]
        self.thinning: float = values["thinning"]
        self.face_width: float = values["face_width"]
        self.bore: float = values["bore"]
        self.pitch_radius: float = values["pitch_radius"]
        self.tip_radius: float = values["tip_radius"]
        self.root_radius: float = values["root_radius"]

    @property
    def pose(self) -> npt.NDArray[np.float64]:
        """The gear's frame to the base frame in the reference pose, turned so that the teeth mesh:
        float64 of shape ``(4, 4)``; read-only."""
        return array(self._pose, "=f8", 4, 4)

    def mesh(self, tolerance: float = 0.002) -> Mesh3D:
        """Give the surface of the gear in its own frame.

        Parameters
        ----------
        tolerance : float, optional
            Farthest chord from the exact form, in modules, 0.0001 to 0.2.

        Returns
        -------
        Mesh3D
            Flanks and roots are exact at the vertices.

        Raises
        ------
        Error
            "interference" if no such gear can be made; "limit" for over 10 million triangles.
        ValueError
            If the tolerance is out of its range.
        """
        return Mesh3D(self._snapshot.gear_arrays(self.name, tolerance))

    def __repr__(self) -> str:
        return f"<Gear {self.name}, {self.kind}, {self.teeth} teeth>"


class Solid:
    """A solid that rides on a link: a gear, or its shafts and arms; immutable.

    Attributes
    ----------
    name : str
        Of the gear or the link.
    link : int
        Label of the link.
    is_gear : bool
        Is it a gear?
    mesh : Mesh3D
        Its surface in its own frame.
    """

    def __init__(
        self, row: Tuple[str, int, bool, bytes, Tuple[bytes, bytes, bytes]]
    ) -> None:
        self.name, self.link, self.is_gear, self._pose, packed = row
        self.mesh = Mesh3D(packed)

    @property
    def pose(self) -> npt.NDArray[np.float64]:
        """Its frame to the base frame in the reference pose, float64 of shape ``(4, 4)``;
        read-only."""
        return array(self._pose, "=f8", 4, 4)

    def __repr__(self) -> str:
        return f"<Solid {self.name} of link {self.link}>"
