"""Mechanisms: what they hold, and how they are read and written."""

from __future__ import annotations

import json
import os
from contextlib import contextmanager
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Dict, Iterator, Optional, Tuple, Type, TypeVar, Union

from . import _geargraph
from ._elements import (
    LISTS, Axis, Coupling, GearMesh, Link, Load, ShiftState, TurningJoint, _Handle, unknown,
)
from ._errors import Error
from ._identity import Identification

if TYPE_CHECKING:
    from ._analysis import Analysis

Point = Tuple[float, float, float]
MeshGeometryRow = Tuple[str, Point, float, float, int]
PathLike = Union[str, "os.PathLike[str]"]
_Found = TypeVar("_Found", bound=_Handle)


def read_bytes(path: PathLike) -> bytes:
    """Read a file, or raise geargraph.Error ("file")."""
    try:
        with open(path, "rb") as file:
            return file.read()
    except OSError as why:
        raise Error(f"{os.fspath(path)} could not be read: {why.strerror}.", "file") from why


class Mechanism(Identification):
    """A geared mechanism: links, turning joints, gear meshes, and what acts on them.

    Methods that begin with ``add_``, ``set_``, ``remove`` and the like edit it; an edit that is
    rejected raises `Error` and leaves it as it was, so does a block under `edit`. All numbers may be
    whole numbers, floats, fractions, or texts ("22/7"), and stay exact.

    Elements are named by themselves (what ``add_link`` gives), by their ids (text), or by their
    labels (whole numbers), the paper's numbers: links 0 (the ground) to n, turning joints n+1 to
    n+t, meshes n+t+1 to n+t+c. Labels follow from the order in the document and change with it; ids
    stay.

    Parameters
    ----------
    name : str, optional
        What it is called.
    unit : str, optional
        Of all lengths.

    Examples
    --------
    >>> import geargraph as gg
    >>> m = gg.Mechanism("spur pair")
    >>> pinion, wheel = m.add_link("pinion"), m.add_link("wheel")
    >>> m.add_turning_joint(m.ground, pinion)
    <joint 3>
    >>> m.add_turning_joint(m.ground, wheel)
    <joint 4>
    >>> m.add_mesh(pinion, wheel, (18, 36))
    <mesh 5>
    >>> m.analyze().dof
    1
    """

    def __init__(self, name: str = "", unit: str = "mm") -> None:
        self._document = _geargraph.Document.empty().with_name(name).with_unit(unit)
        self._folder = ""
        self._cached: Dict[str, Any] = {}
        self._cached_of: Optional[_geargraph.Document] = None

    @classmethod
    def _of(cls: Type[Mechanism], document: _geargraph.Document, folder: str = "") -> Mechanism:
        mechanism = cls.__new__(cls)
        mechanism._document = document
        mechanism._folder = folder
        mechanism._cached = {}
        mechanism._cached_of = None
        return mechanism

    # --- files -----------------------------------------------------------------------------------

    @classmethod
    def open(cls, path: PathLike) -> Mechanism:
        """Read a document (``*.geargraph``).

        Parameters
        ----------
        path : path-like
            The file.

        Returns
        -------
        Mechanism
            The document; 3D files that it names are looked for in its folder.

        Raises
        ------
        Error
            "file" if it cannot be read; "syntax", "schema", "version", ... with all problems of the
            file, each with line and column.
        """
        document = _geargraph.Document.read(read_bytes(path))
        return cls._of(document, os.path.dirname(os.path.abspath(os.fspath(path))))

    @classmethod
    def from_text(cls, text: str) -> Mechanism:
        """Read a document from its text.

        Parameters
        ----------
        text : str
            JSON, as a ``*.geargraph`` file holds it.

        Returns
        -------
        Mechanism
            The document.

        Raises
        ------
        Error
            As `open`.
        """
        return cls._of(_geargraph.Document.read(text.encode()))

    def to_text(self) -> str:
        """Write the document as text.

        Returns
        -------
        str
            JSON, as a ``*.geargraph`` file holds it; `from_text` gives the same mechanism.
        """
        return self._document.write()

    def save(self, path: PathLike) -> None:
        """Write the document to a file, whole or not at all.

        Parameters
        ----------
        path : path-like
            The file; one that is there is replaced.

        Raises
        ------
        Error
            "file" if it cannot be written.
        """
        _geargraph.write_file(os.fspath(path), self.to_text().encode())

    def to_dict(self) -> Dict[str, Any]:
        """Give the document as the members of its file.

        Returns
        -------
        dict
            Numbers that are not whole are ``fractions.Fraction``, or texts where they were written
            as "22/7".
        """
        return dict(json.loads(self.to_text(), parse_float=Fraction))

    def copy(self) -> Mechanism:
        """Copy the mechanism.

        Returns
        -------
        Mechanism
            Edits of one leave the other alone. Cost: next to nothing.
        """
        return self._of(self._document, self._folder)

    __copy__ = copy

    def __deepcopy__(self, memo: Dict[int, Any]) -> Mechanism:
        return self.copy()

    def __reduce__(self) -> Tuple[Any, Tuple[str]]:
        return type(self).from_text, (self.to_text(),)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Mechanism) and self._document == other._document

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        name = repr(self.name) if self.name else "without a name"
        return f"<Mechanism {name}: n = {self.n}, t = {self.t}, c = {self.c}>"

    def _repr_svg_(self) -> str:
        return self.analyze().drawing("schematic").svg

    # --- what it holds ---------------------------------------------------------------------------

    def _cache(self) -> Dict[str, Any]:
        if self._cached_of is not self._document:
            self._cached, self._cached_of = {}, self._document
        return self._cached

    @property
    def _members(self) -> Dict[str, Any]:
        cache = self._cache()
        if "members" not in cache:
            cache["members"] = self.to_dict()
        members: Dict[str, Any] = cache["members"]
        return members

    def _positions(self, kind: str) -> Dict[str, int]:
        cache = self._cache()
        if kind not in cache:
            cache[kind] = {id: place for place, id in enumerate(self._document.ids(kind))}
        positions: Dict[str, int] = cache[kind]
        return positions

    def _element(self, kind: str, id: str) -> Dict[str, Any]:
        positions = self._positions(kind)
        if id not in positions:
            raise unknown(kind, id)
        element: Dict[str, Any] = self._members[LISTS[kind]][positions[id]]
        return element

    def _label(self, kind: str, id: str) -> int:
        position = self._positions(kind).get(id)
        if position is None:
            raise unknown(kind, id)
        first = {"link": 0, "joint": self.n + 1, "mesh": self.n + self.t + 1}[kind]
        return first + position

    def _axis_line(self, id: str) -> Tuple[Point, Point]:
        for axis, point, direction, _ in self._document.axes():
            if axis == id:
                return _point(point), _point(direction)
        raise unknown("axis", id)

    def _mesh_geometry(self, id: str) -> Optional[MeshGeometryRow]:
        place = self._positions("mesh").get(id)
        if place is None:
            raise unknown("mesh", id)
        rows = self._document.meshes()
        row = rows[place] if place < len(rows) else None
        return None if row is None else (row[0], _point(row[1]), row[2], row[3], row[4])

    def _resolved(self, made: Type[_Found], reference: Any) -> _Found:
        kind = made._kind
        if isinstance(reference, _Handle):
            if reference._kind == kind and self._document.position(kind, reference.id) >= 0:
                return made(self, reference.id)
        elif isinstance(reference, int) and not isinstance(reference, bool):
            first = {"link": 0, "joint": self.n + 1, "mesh": self.n + self.t + 1}.get(kind)
            ids = self._document.ids(kind) if first is not None else []
            if first is not None and 0 <= reference - first < len(ids):
                return made(self, ids[reference - first])
        elif isinstance(reference, str):
            if self._document.position(kind, reference) >= 0:
                return made(self, reference)
            if kind == "link":
                named = [e["id"] for e in self._members["links"] if e.get("name") == reference]
                if len(named) == 1:
                    return made(self, named[0])
        raise unknown(kind, reference)

    @property
    def name(self) -> str:
        """What the mechanism is called. It may be set."""
        return self._document.name

    @name.setter
    def name(self, name: str) -> None:
        self._document = self._document.with_name(name)

    @property
    def notes(self) -> str:
        """Free text. It may be set."""
        return self._document.notes

    @notes.setter
    def notes(self, notes: str) -> None:
        self._document = self._document.with_notes(notes)

    @property
    def unit(self) -> str:
        """The unit of all lengths. It may be set; numbers stay as they are."""
        return self._document.unit

    @unit.setter
    def unit(self, unit: str) -> None:
        self._document = self._document.with_unit(unit)

    @property
    def n(self) -> int:
        """Number of moving links."""
        return self._document.counts[0]

    @property
    def t(self) -> int:
        """Number of turning joints."""
        return self._document.counts[1]

    @property
    def c(self) -> int:
        """Number of gear meshes."""
        return self._document.counts[2]

    @property
    def ground(self) -> Link:
        """The link with the label 0."""
        return self.links[0]

    @property
    def links(self) -> Tuple[Link, ...]:
        """All links by label, the ground first."""
        return tuple(Link(self, id) for id in self._positions("link"))

    @property
    def axes(self) -> Tuple[Axis, ...]:
        """All axes."""
        return tuple(Axis(self, id) for id in self._positions("axis"))

    @property
    def joints(self) -> Tuple[TurningJoint, ...]:
        """All turning joints by label."""
        return tuple(TurningJoint(self, id) for id in self._positions("joint"))

    @property
    def meshes(self) -> Tuple[GearMesh, ...]:
        """All gear meshes by label."""
        return tuple(GearMesh(self, id) for id in self._positions("mesh"))

    @property
    def couplings(self) -> Tuple[Coupling, ...]:
        """All brakes and clutches."""
        return tuple(Coupling(self, id) for id in self._positions("coupling"))

    @property
    def states(self) -> Tuple[ShiftState, ...]:
        """What is engaged together, the gears of a gearbox."""
        return tuple(ShiftState(data) for data in self._members.get("states", ()))

    @property
    def loads(self) -> Tuple[Load, ...]:
        """What acts on the mechanism."""
        return tuple(Load(data) for data in self._members.get("loads", ()))

    @property
    def engaged(self) -> Tuple[str, ...]:
        """Ids of the couplings that are engaged now."""
        return tuple(self._members.get("engaged", ()))

    @property
    def inputs(self) -> Optional[Dict[str, Fraction]]:
        """Speeds of the driven joints by id, rad/s; None where the program chooses them."""
        inputs = self._members.get("inputs")
        if inputs is None:
            return None
        return {str(data["joint"]): Fraction(data.get("speed", 0)) for data in inputs}

    # --- analysis --------------------------------------------------------------------------------

    @contextmanager
    def edit(self) -> Iterator[Mechanism]:
        """Make several edits one: if one of them fails, none is made.

        Yields
        ------
        Mechanism
            This mechanism.

        Examples
        --------
        >>> import geargraph as gg
        >>> m = gg.Mechanism()
        >>> with m.edit():
        ...     planet = m.add_link("planet")
        """
        before = self._document
        try:
            yield self
        except BaseException:
            self._document = before
            raise

    def analyze(self, symbolic: bool = True) -> Analysis:
        """Analyse the mechanism as it is now, by both methods.

        Rank, freedom and speeds are computed at once, all else when it is asked for. Long work
        leaves the interpreter to other threads, and Ctrl+C ends it.

        Parameters
        ----------
        symbolic : bool, optional
            Solve in the gear ratios, too.

        Returns
        -------
        Analysis
            It stays as it is when the mechanism is edited.
        """
        from ._analysis import Analysis

        cache = self._cache()
        key = f"analysis {symbolic}"
        if key not in cache:
            cache[key] = Analysis(self.copy(), symbolic)
        analysis: Analysis = cache[key]
        return analysis


def _point(values: Any) -> Point:
    x, y, z = values
    return float(x), float(y), float(z)
