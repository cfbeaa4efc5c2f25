"""Drawings and pictures."""

from __future__ import annotations

import os
from typing import Optional, Tuple, Union

from . import _geargraph

PathLike = Union[str, "os.PathLike[str]"]
Size = Optional[Tuple[int, int]]


class Drawing:
    """A drawing of a mechanism: its functional schematic, digraph or T-T graph; immutable.

    Attributes
    ----------
    name : str
        "schematic", "digraph", "ttgraph", "levers", "nomogram", "plan", "kutzbach",
        "spectrum" or "motors".
    """

    __slots__ = ("name", "_snapshot", "_dark", "_transparent", "_size")

    def __init__(
        self,
        snapshot: _geargraph.Snapshot,
        name: str,
        dark: bool,
        transparent: bool,
        size: Size,
    ) -> None:
        self._snapshot = snapshot
        self.name = name
        self._dark = dark
        self._transparent = transparent
        self._size = size

    def _bytes(self, form: str) -> bytes:
        return self._snapshot.drawing(self.name, form, self._dark, self._transparent, self._size)

    @property
    def svg(self) -> str:
        """The drawing in SVG; text stays text."""
        return self._bytes("svg").decode()

    @property
    def png(self) -> bytes:
        """The drawing in pixels, two for a unit of the sheet where no size was given.

        Raises
        ------
        Error
            "graphics" where it would be larger than 16,384 pixels.
        """
        return self._bytes("png")

    @property
    def pdf(self) -> bytes:
        """The drawing as a page; lines stay lines, text stays text."""
        return self._bytes("pdf")

    def save(self, path: PathLike) -> None:
        """Write the drawing to a file.

        Parameters
        ----------
        path : path-like
            Ends with ``.svg``, ``.png`` or ``.pdf``.

        Raises
        ------
        Error
            "file" if it cannot be written.
        ValueError
            For another ending.
        """
        form = os.path.splitext(os.fspath(path))[1][1:].lower()
        _geargraph.write_file(os.fspath(path), self._bytes(form))

    def _repr_svg_(self) -> str:
        return self.svg

    def __repr__(self) -> str:
        return f"<Drawing {self.name}>"


class Picture:
    """A 3D picture of a mechanism; immutable.

    Attributes
    ----------
    png : bytes
        The picture as a PNG file holds it.
    notes : tuple of str
        What is not shown or simplified, and why: 3D files that cannot be read, for one.
    """

    __slots__ = ("png", "notes")

    def __init__(self, png: bytes, notes: Tuple[str, ...] = ()) -> None:
        self.png = png
        self.notes = notes

    @property
    def size(self) -> Tuple[int, int]:
        """Width and height in pixels."""
        width = int.from_bytes(self.png[16:20], "big")
        return width, int.from_bytes(self.png[20:24], "big")

    def save(self, path: PathLike) -> None:
        """Write the picture to a file.

        Parameters
        ----------
        path : path-like
            A PNG, whatever its ending.

        Raises
        ------
        Error
            "file" if it cannot be written.
        """
        _geargraph.write_file(os.fspath(path), self.png)

    def _repr_png_(self) -> bytes:
        return self.png

    def __repr__(self) -> str:
        return f"<Picture, {self.size[0]} × {self.size[1]}>"
