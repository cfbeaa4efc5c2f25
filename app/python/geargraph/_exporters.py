"""The formats that a mechanism is exported in, as the program lists them."""

from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import Any, Dict, Optional, Tuple

from . import _geargraph


@dataclass(frozen=True)
class ExportOption:
    """An option of an exporter."""

    name: str
    """As `Analysis.export_as` takes it: "tolerance", "no_labels"."""
    type: str
    """"flag", "number", "choice" or "text"."""
    meaning: str
    default: Optional[str]
    """What holds without it; None if its meaning tells."""
    needed: bool
    bounds: Optional[Tuple[float, float]]
    """Of a number."""
    choices: Tuple[str, ...]


@dataclass(frozen=True)
class Exporter:
    """A format."""

    id: str
    form: str
    """The word after ``--to`` on the command line."""
    title: str
    what: str
    """What the file holds."""
    folder: bool
    """It writes a folder."""
    suffix: str
    """Of the file, without its dot."""
    options: Tuple[ExportOption, ...]
    refusals: Dict[str, str]
    """Codes of errors for which nothing is written, with their meanings."""


def _option(row: Tuple[Any, ...]) -> ExportOption:
    name, kind, meaning, default, needed, least, most, choices = row
    bounds = (least, most) if kind == "number" else None
    return ExportOption(
        name[2:].replace("-", "_"), kind, meaning, default or None, needed, bounds, tuple(choices)
    )


@functools.lru_cache(maxsize=None)
def exporters() -> Tuple[Exporter, ...]:
    """List the formats of `Analysis.export_as`.

    Returns
    -------
    tuple of Exporter
        In the order of the command line's help.
    """
    return tuple(
        Exporter(
            id, form, title, what, folder, suffix,
            tuple(_option(option) for option in options), dict(refusals),
        )
        for id, form, title, what, folder, suffix, options, refusals in _geargraph.exporters()
    )


def exporter_of(ending: str) -> Optional[Exporter]:
    """Give the first exporter that writes files with this ending (".mo")."""
    for exporter in exporters():
        if exporter.suffix and "." + exporter.suffix == ending:
            return exporter
    return None


def command_options(options: Dict[str, Any]) -> Dict[str, str]:
    """Spell options as the command line does: flags that are off are left out."""
    spelled: Dict[str, str] = {}
    for name, value in options.items():
        if value is None or value is False:
            continue
        if isinstance(value, (list, tuple)):
            value = ",".join(str(each) for each in value)
        spelled["--" + name.replace("_", "-")] = str(value)
    return spelled
