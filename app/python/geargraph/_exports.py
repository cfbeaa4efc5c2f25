"""Drawings, pictures, gears and files of an analysed mechanism."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Dict, Iterable, Optional, Tuple

from . import _geargraph
from ._elements import LinkLike
from ._errors import Error, diagnostics_of
from ._exporters import command_options, exporter_of
from ._gears import Gear, Solid
from ._pictures import Drawing, PathLike, Picture, Size

if TYPE_CHECKING:
    from ._mechanism import Mechanism

_REPORTS = {".html": "html", ".tex": "latex", ".md": "md"}
_SOLIDS = (".stl", ".obj", ".ply", ".glb", ".3mf")
_DRAWINGS = (".svg", ".png", ".pdf")


class Exports:
    """What an analysis shows and writes."""

    mechanism: Mechanism
    _snapshot: _geargraph.Snapshot

    # --- drawings and pictures -------------------------------------------------------------------

    def drawing(
        self,
        name: str = "schematic",
        *,
        dark: bool = False,
        transparent: bool = False,
        size: Size = None,
    ) -> Drawing:
        """Give a drawing.

        Parameters
        ----------
        name : {"schematic", "digraph", "ttgraph", "levers", "nomogram", "plan", "kutzbach", "spectrum",
            "motors"}, optional
            Functional schematic (ISO 3952), digraph [paper, Fig. 2], T-T graph [Fig. 5].
        dark : bool, optional
            On a dark ground.
        transparent : bool, optional
            On no ground.
        size : tuple of two int, optional
            Width and height in pixels; without it as large as the drawing is.

        Returns
        -------
        Drawing
            As SVG, PNG and PDF; Jupyter shows it.

        Raises
        ------
        ValueError
            When it is drawn, for another name or a size out of range.
        """
        return Drawing(self._snapshot, name, dark, transparent, size)

    def _chosen(self, options: Dict[str, Any]) -> Dict[str, Any]:
        chosen: Dict[str, Any] = {
            "size": None, "dark": False, "transparent": False, "view": None, "camera": None,
            "time": 0.0, "section": None, "explode": 0.0, "faces": "shaded", "show": (),
            "hide": (), "ride": None,
        }
        unknown = sorted(set(options) - set(chosen))
        if unknown:
            raise TypeError(f"a picture has no option {unknown[0]!r}")
        chosen.update(options)
        chosen["show"] = list(chosen["show"])
        chosen["hide"] = [self.mechanism.link(link).id for link in chosen["hide"]]
        if chosen["ride"] is not None:
            chosen["ride"] = self.mechanism.link(chosen["ride"]).id
        if chosen["section"] is not None:
            axis, place = chosen["section"]
            chosen["section"] = ("xyz".index(axis), _between("section", place, 0, 1))
        chosen["time"] = _between("time", chosen["time"], -1e9, 1e9)
        chosen["explode"] = _between("explode", chosen["explode"], 0, 1)
        if chosen["camera"] is not None:
            azimuth, elevation = chosen["camera"]
            chosen["camera"] = (
                _between("azimuth", azimuth, -360, 360), _between("elevation", elevation, -90, 90),
            )
        chosen["folder"] = self.mechanism._folder or os.getcwd()
        reader = os.path.join(os.path.dirname(__file__), "geargraph-mesh")
        chosen["reader"] = reader if os.path.exists(reader) else ""
        return chosen

    def picture(
        self,
        *,
        size: Size = None,
        dark: bool = False,
        transparent: bool = False,
        view: Optional[str] = None,
        camera: Optional[Tuple[float, float]] = None,
        time: float = 0,
        section: Optional[Tuple[str, float]] = None,
        explode: float = 0,
        faces: str = "shaded",
        show: Iterable[str] = (),
        hide: Iterable[LinkLike] = (),
        ride: Optional[LinkLike] = None,
    ) -> Picture:
        """Paint the mechanism in 3D; needs no display.

        Parameters
        ----------
        size : tuple of two int, optional
            Width and height in pixels, 16 to 8,192; 1600 × 1000 without it.
        dark, transparent : bool, optional
            On a dark ground; on no ground.
        view : {"front", "back", "left", "right", "top", "bottom", "iso"}, optional
            Where it is seen from; or
        camera : tuple of two float, optional
            azimuth and elevation in degrees.
        time : float, optional
            Seconds that the inputs have run at their speeds.
        section : tuple of str and float, optional
            ("y", 0.5): perpendicular to x, y or z at this fraction of the length.
        explode : float, optional
            Exploded view along the axes, 0 to 1.
        faces : {"shaded", "lines", "edges"}, optional
            "lines" leaves hidden edges out.
        show : iterable of str, optional
            "labels", "joint-labels", "axis-labels", "scale", "pitch-circles", "pitch-points",
            "axes", "instant-axes", "velocities", "forces", "power".
        hide : iterable of Link, str or int, optional
            Links that are left out.
        ride : Link, str or int, optional
            The link that the reference frame is fixed to.

        Returns
        -------
        Picture
            A PNG; Jupyter shows it.

        Raises
        ------
        Error
            "graphics" if nothing can paint; "limit" over 4,000 links; the errors of a mechanism
            that has no spanning tree.
        ValueError
            For another name or a size out of range.
        """
        options = dict(
            size=size, dark=dark, transparent=transparent, view=view, camera=camera, time=time,
            section=section, explode=explode, faces=faces, show=show, hide=hide, ride=ride,
        )
        png, notes = self._snapshot.picture(self._chosen(options))
        return Picture(png, tuple(notes))

    def film(
        self,
        path: PathLike,
        kind: str = "motion",
        *,
        frames: int = 72,
        fps: float = 24,
        folder: bool = False,
        overwrite: bool = False,
        **options: Any,
    ) -> None:
        """Write an animated PNG, or its pictures.

        Parameters
        ----------
        path : path-like
            The file, or the folder.
        kind : {"motion", "turntable"}, optional
            One period of the motion, or once round the mechanism.
        frames : int, optional
            Pictures, 2 to 10,000.
        fps : float, optional
            Pictures a second.
        folder : bool, optional
            Write the pictures one by one into a folder, "0001.png" and on.
        overwrite : bool, optional
            Replace pictures that are in the folder.
        **options
            As of `picture`.

        Raises
        ------
        Error
            As `picture`; "file" if it cannot be written.
        """
        if kind not in ("motion", "turntable"):
            raise ValueError(f"a film is of the motion or a turntable, not {kind!r}")
        rate = _between("fps", fps, 0.1, 100)
        self._snapshot.film(
            self._chosen(options), os.fspath(path), folder, overwrite, kind, frames, rate
        )

    # --- gears -----------------------------------------------------------------------------------

    @property
    def gears(self) -> Tuple[Gear, ...]:
        """The toothed wheels, with their teeth.

        Raises
        ------
        Error
            The errors of the mechanism.
        """
        first = self.mechanism.n + self.mechanism.t + 1
        return tuple(Gear(self._snapshot, first, row) for row in self._snapshot.gears())

    def solids(self, tolerance: float = 0.01) -> Tuple[Solid, ...]:
        """Give the surfaces of all gears, shafts and arms.

        Parameters
        ----------
        tolerance : float, optional
            Farthest chord from the exact form, in modules, 0.0001 to 0.2.

        Returns
        -------
        tuple of Solid
            Each with its place in the reference pose.

        Raises
        ------
        Error
            The errors of the mechanism.
        """
        return tuple(Solid(row) for row in self._snapshot.parts(tolerance))

    # --- files -----------------------------------------------------------------------------------

    def export(self, path: PathLike, **options: Any) -> None:
        """Write a file for another program; its ending decides.

        Parameters
        ----------
        path : path-like
            ``.svg``, ``.png``, ``.pdf`` with ``drawing=name``: a drawing; ``.png`` without: a 3D
            picture; ``.html``, ``.tex``, ``.md``, ``.pdf``: the derivation; ``.csv`` with
            ``table=name``: a table; ``.dot``, ``.graphml`` with ``graph=name``: a graph;
            ``.stl``, ``.obj``, ``.ply``, ``.glb``, ``.3mf``: gears; another ending: the first of
            `exporters` that writes such a file, by `export_as`.
        **options
            Of drawings those of `drawing`; of pictures those of `picture`; of tables
            ``separator``, ``decimal`` and ``labels`` as of `csv`; of gears ``gear`` ("15:tail"),
            ``link``, ``tolerance`` (modules) and, with GLB, ``seconds`` in which one period plays;
            or, with GLB, ``as_seen=True`` and the options of `picture`: what a picture shows.

        Raises
        ------
        Error
            "file" if it cannot be written, "limit", "graphics", or the errors of the mechanism.
        ValueError
            For another ending, or a name that is none.

        Warns
        -----
        UserWarning
            If gears are left out, nothing moves, or the gears are coarser than usual.
        """
        name = os.fspath(path)
        ending = os.path.splitext(name)[1].lower()
        if ending in _DRAWINGS and "drawing" in options:
            self.drawing(options.pop("drawing"), **options).save(path)
        elif ending == ".png":
            self.picture(**options).save(path)
        elif ending in _REPORTS or ending == ".pdf":
            _none(options)
            _geargraph.write_file(name, self._snapshot.report(_REPORTS.get(ending, "pdf")))
        elif ending == ".csv":
            table = options.pop("table")
            _geargraph.write_file(name, self.csv(table, **options).encode())
        elif ending in (".dot", ".graphml"):
            graph = options.pop("graph", "digraph")
            _none(options)
            _geargraph.write_file(name, self.graph(graph, ending[1:]).encode())
        elif ending == ".glb" and options.pop("as_seen", False):
            self._snapshot.write_view(self._chosen(options), name)
        elif ending in _SOLIDS:
            self._write_solids(name, ending[1:], **options)
        elif (exporter := exporter_of(ending)) is not None:
            self.export_as(exporter.id, path, **options)
        else:
            raise ValueError(f"there is no export to {ending!r}")

    def export_as(
        self, exporter: str, path: PathLike, *, overwrite: bool = False, **options: Any
    ) -> Tuple[str, ...]:
        """Write in any format of `exporters`.

        Parameters
        ----------
        exporter : str
            Its id: "modelica", "mjcf", "scorm", ...
        path : path-like
            The file, or the folder.
        overwrite : bool, optional
            Replace files that are in the folder.
        **options
            As the exporter lists them; several values as a list.

        Returns
        -------
        tuple of str
            What a reader of the file has to know, sentences.

        Raises
        ------
        Error
            With the code of a refusal that the exporter lists, "file", or the errors of the mechanism.
        TypeError
            For an option that it does not have.
        ValueError
            For an id that is none, or a value that an option does not take.
        """
        notes = self._snapshot.write_export(
            exporter, command_options(options), os.fspath(path), overwrite, self.mechanism._folder
        )
        return tuple(notes)

    def _write_solids(
        self,
        path: str,
        form: str,
        *,
        gear: Optional[str] = None,
        link: Optional[LinkLike] = None,
        seconds: float = 0,
        tolerance: Optional[float] = None,
    ) -> None:
        label = None if link is None else str(self.mechanism.link(link).label)
        taken, left_out, shows = self._snapshot.write_solids(
            path, form, gear, label, seconds, tolerance
        )
        notes = [shows] if shows else []
        if left_out:
            first = diagnostics_of(left_out)[0]
            notes.append(f"{len(left_out)} gears are left out: {first.message}")
        if tolerance is None and taken > 0.002:
            notes.append(f"The chords are within {taken:g} modules, so that the file is not too large.")
        if notes:
            import warnings

            warnings.warn(" ".join(notes), stacklevel=3)

    @property
    def tables(self) -> Tuple[str, ...]:
        """Names of the tables that the mechanism has, for `csv`."""
        return tuple(self._snapshot.csv(None, ",", ".", True))

    def csv(
        self, table: str, *, separator: str = ",", decimal: str = ".", labels: bool = True
    ) -> str:
        """Write a matrix or a table of statics as comma-separated values.

        Parameters
        ----------
        table : str
            One of `tables`: "incidence", ..., "screw", "p", "solution"; with loads "joint-torques",
            "mesh-forces", "bearings", "powers", ...
        separator : {",", ";", tab}, optional
            Between fields.
        decimal : {".", ","}, optional
            The decimal point.
        labels : bool, optional
            With a header row and a first column.

        Returns
        -------
        str
            The table.

        Raises
        ------
        Error
            "undefined" if the mechanism has no such table.
        """
        if separator not in (",", ";", "\t") or decimal not in (".", ","):
            raise ValueError("fields are separated by ',', ';' or a tab, decimals by '.' or ','")
        texts = self._snapshot.csv(table, separator, decimal, labels)
        if table not in texts:
            raise Error(f"The mechanism has no table {table!r}.", "undefined")
        return texts[table]

    def graph(self, name: str = "digraph", form: str = "node-link") -> str:
        """Write a graph of the mechanism for other programs.

        Parameters
        ----------
        name : {"digraph", "ttgraph"}, optional
            Digraph [paper, Fig. 2] or T-T graph [Fig. 5].
        form : {"node-link", "dot", "graphml"}, optional
            JSON as ``networkx.node_link_graph(json.loads(text))`` takes it, Graphviz, or GraphML.

        Returns
        -------
        str
            The text of the file.

        Raises
        ------
        Error
            "undefined", or the errors of the mechanism, if there is no T-T graph.
        ValueError
            For another name or form.
        """
        return self._snapshot.graph(name, form)

    def export_tables(self, folder: PathLike, overwrite: bool = False) -> Tuple[str, ...]:
        """Write all tables into a folder, ``name.csv`` each.

        Parameters
        ----------
        folder : path-like
            It is made where it is not there.
        overwrite : bool, optional
            Replace files that are there.

        Returns
        -------
        tuple of str
            Paths of the files.

        Raises
        ------
        Error
            "file" if a file is there or cannot be written.
        """
        texts = self._snapshot.csv(None, ",", ".", True)
        os.makedirs(folder, exist_ok=True)
        paths = {name: os.path.join(os.fspath(folder), name + ".csv") for name in texts}
        there = [path for path in paths.values() if os.path.exists(path)]
        if there and not overwrite:
            raise Error(f"{there[0]} is there already; nothing was written.", "file")
        for name, path in paths.items():
            _geargraph.write_file(path, texts[name].encode())
        return tuple(paths.values())

    def export_assembly(
        self,
        folder: PathLike,
        *,
        frames: int = 24,
        tolerance: float = 0.002,
        overwrite: bool = False,
    ) -> None:
        """Write what an independent check of the teeth needs: an STL for each gear, and their poses.

        Parameters
        ----------
        folder : path-like
            ``assembly.json`` and the STL files.
        frames : int, optional
            Moments, 12 to 10,000.
        tolerance : float, optional
            Farthest chord from the exact form, in modules.
        overwrite : bool, optional
            Replace files that are there.

        Raises
        ------
        Error
            "file" if files are there or cannot be written; the errors of the mechanism.
        """
        self._snapshot.write_assembly(os.fspath(folder), frames, tolerance, overwrite)

    def export_model(
        self,
        folder: PathLike,
        form: str = "mjcf",
        *,
        name: str = "mechanism",
        motor: str = "speed",
        timestep: float = 0.001,
        armature: Optional[float] = None,
        tolerance: float = 0.01,
        overwrite: bool = False,
    ) -> Tuple[str, ...]:
        """Write a model of rigid bodies for simulators, with its meshes.

        Parameters
        ----------
        folder : path-like
            It takes ``name.xml`` or ``name.urdf`` and ``meshes/link-<label>.stl``.
        form : {"mjcf", "urdf"}, optional
            For MuJoCo; or URDF, in which a joint follows at most one other.
        name : str, optional
            Of the file.
        motor : {"speed", "torque", "none"}, optional
            MJCF: servos at the document's speeds, plain motors, or none.
        timestep : float, optional
            MJCF: s, 1e-6 to 1.
        armature : float, optional
            MJCF: inertia of the rotors, kg m²; else 100 times what the input feels.
        tolerance : float, optional
            Farthest chord of the meshes from the exact form, in modules.
        overwrite : bool, optional
            Replace files that are there.

        Returns
        -------
        tuple of str
            What a reader of the model has to know, sentences.

        Raises
        ------
        Error
            "undefined" if the form cannot hold the mechanism, with the reason; "file", "limit";
            the errors of the mechanism.
        ValueError
            For another form or motor, or a number out of its range.
        """
        if os.path.basename(name) != name or not name:
            raise ValueError(f"{name!r} is not the name of a file")
        return tuple(
            self._snapshot.write_model(
                os.fspath(folder), name, form, motor, timestep, armature, tolerance, overwrite
            )
        )


def _between(name: str, value: Any, least: float, most: float) -> float:
    number = float(value)
    if not least <= number <= most:
        raise ValueError(f"{name} is {least:g} to {most:g}, not {number}")
    return number


def _none(options: Dict[str, Any]) -> None:
    if options:
        raise TypeError(f"this export has no option {sorted(options)[0]!r}")
