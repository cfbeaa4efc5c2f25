"""Findings about mechanisms, and the exception that carries them."""

from __future__ import annotations

from typing import Iterable, List, NamedTuple, Optional, Tuple


class Element(NamedTuple):
    """An element of a mechanism, named by its kind and id.

    Attributes
    ----------
    kind : str
        "link", "axis", "joint", "mesh", "wheel", "coupling", "state" or "load".
    id : str
        Unique among the elements of this kind; it stays when labels are renewed.
    """

    kind: str
    id: str


class Diagnostic(NamedTuple):
    """One finding about a mechanism.

    Attributes
    ----------
    severity : str
        "error", "warning" or "info". A mechanism with errors has no solution.
    code : str
        What is wrong, a stable name: "turning-loop", "pitch-geometry", ...
    detail : str
        Which case of the code, "interference/wheels-overlap"; empty for codes with one case.
    message : str
        A sentence that tells what is wrong and what to do.
    elements : tuple of Element
        The elements that it is about.
    pointer : str
        JSON pointer into the file, of errors in a file; else empty.
    line, column : int
        Place in the text of a file, from 1; 0 for others.
    time : float or None
        Seconds of the motion at which parts collide; None for others.
    """

    severity: str
    code: str
    detail: str
    message: str
    elements: Tuple[Element, ...]
    pointer: str = ""
    line: int = 0
    column: int = 0
    time: Optional[float] = None

    def __str__(self) -> str:
        place = f"{self.line}:{self.column}: " if self.line else ""
        return f"{place}{self.severity}: {self.message} [{self.code}]"


DiagnosticRow = Tuple[
    str, str, str, str, Tuple[Tuple[str, str], ...], str, int, int, Optional[float]
]


def diagnostics_of(rows: Iterable[DiagnosticRow]) -> Tuple[Diagnostic, ...]:
    """Make diagnostics of the rows that the compiled module gives."""
    found: List[Diagnostic] = []
    for severity, code, detail, message, elements, pointer, line, column, time in rows:
        named = tuple(Element(kind, element) for kind, element in elements)
        found.append(
            Diagnostic(severity, code, detail, message, named, pointer, line, column, time)
        )
    return tuple(found)


class Error(Exception):
    """What GearGraph rejects: an edit, a file, or a question that a mechanism leaves open.

    A rejected edit leaves the mechanism as it was.

    Parameters
    ----------
    message : str
        The sentences of all errors.
    code : str
        The code of the first of them. Besides the codes of diagnostics: "file" (it could not be
        read or written), "limit" (beyond a stated limit), "undefined" (the mechanism does not
        determine the quantity), "graphics" (nothing can paint 3D pictures).
    diagnostics : tuple of Diagnostic, optional
        All findings.

    Attributes
    ----------
    code : str
        The code of the first error.
    elements : tuple of Element
        The elements that the errors are about, each once.
    diagnostics : tuple of Diagnostic
        All findings; empty where the code is none of a document.
    """

    def __init__(
        self, message: str, code: str, diagnostics: Tuple[Diagnostic, ...] = ()
    ) -> None:
        super().__init__(message)
        self.code = code
        self.diagnostics = diagnostics
        elements: List[Element] = []
        for diagnostic in diagnostics:
            for element in diagnostic.elements:
                if element not in elements:
                    elements.append(element)
        self.elements: Tuple[Element, ...] = tuple(elements)

    def __reduce__(self) -> Tuple[type, Tuple[str, str, Tuple[Diagnostic, ...]]]:
        return type(self), (str(self), self.code, self.diagnostics)


def of_diagnostics(rows: Iterable[DiagnosticRow]) -> Error:
    """Make the exception for these findings (called by the compiled module)."""
    found = diagnostics_of(rows)
    errors = [d for d in found if d.severity == "error"] or list(found)
    message = "\n".join(
        (f"{d.line}:{d.column}: " if d.line else "") + f"{d.message} [{d.code}]" for d in errors
    )
    return Error(message, errors[0].code, found)


def of_code(code: str, message: str) -> Error:
    """Make the exception for a failure that is none of a document (called by the compiled module)."""
    return Error(message, code)
