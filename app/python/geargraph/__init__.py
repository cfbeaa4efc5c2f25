"""Geared mechanisms: built, analysed by the Matroid and the T-T graph method, drawn and exported.

    >>> import geargraph as gg
    >>> m = gg.sets.planetary(sun=24, planet=18)
    >>> m.analyze().joint_speeds[m.joint(9).label]
    Fraction(2, 7)

Lengths are in the document's unit, angles in rad, speeds in rad/s, torques in N m, forces in N,
powers in W. Labels are the paper's numbers: links 0 (the ground) to n, turning joints n+1 to n+t,
gear meshes n+t+1 to n+t+c. Equation numbers are those of S. Amirinezhad and M. K. Uyguroğlu,
Kinematic analysis of geared robotic mechanism using Matroid and T-T graph methods (MED 2014).

NumPy, pandas and SymPy are imported by the methods that give their types, and not before.
"""

from __future__ import annotations

from . import _geargraph, exercises, sets
from ._analysis import Analysis, Pose
from ._derivation import Block, Derivation, Equation
from ._design import (
    AtlasChain, FoundGearbox, FoundHub, GearboxSearch, HubSearch, atlas, atlas_document, gearbox,
    hardware,
)
from ._dynamics import Dynamics, EquationOfMotion, LinkMass, Motion
from ._elements import Axis, Coupling, GearMesh, Link, Load, ShiftState, TurningJoint
from ._errors import Diagnostic, Element, Error
from ._exporters import Exporter, ExportOption, exporters
from ._frequencies import Backlash, Frequencies, Frequency, LostMotion
from ._gears import Gear, Mesh3D, Solid
from ._identity import IdentifiedChain, Identity
from ._matrix import Heading, Matrix, Quantity
from ._mechanism import Mechanism, PathLike
from ._methods import (
    Formula, MatroidMethod, MatroidStep, Term, TransferVertex, TtGraphMethod, TtStep,
)
from ._pictures import Drawing, Picture
from ._results import InputSets, MotionCheck, State, States
from ._statics import Balance, Bearing, Efficiency, MeshForce, Statics
from ._teeth import TeethCheck, TeethChoice, TeethChoices, check_teeth

__version__: str = _geargraph.version

__all__ = [
    "Analysis", "AtlasChain", "Axis", "Backlash", "Balance", "Bearing", "Block", "Coupling",
    "Derivation", "Diagnostic", "Drawing", "Dynamics", "Efficiency", "Element", "Equation",
    "EquationOfMotion", "Error", "ExportOption", "Exporter", "Formula", "FoundGearbox",
    "FoundHub", "Frequencies", "Frequency", "Gear", "GearMesh", "GearboxSearch", "Heading",
    "HubSearch", "IdentifiedChain", "Identity", "InputSets", "Link", "LinkMass", "Load",
    "LostMotion", "Matrix", "MatroidMethod", "MatroidStep", "Mechanism", "Mesh3D", "MeshForce",
    "Motion", "MotionCheck", "Picture", "Pose", "Quantity", "ShiftState", "Solid", "State",
    "States", "Statics", "TeethCheck", "TeethChoice", "TeethChoices", "Term", "TransferVertex",
    "TtGraphMethod", "TtStep", "TurningJoint", "atlas", "atlas_document", "check_teeth",
    "exercises", "exporters", "gearbox", "hardware", "loads", "open", "sets",
]


def open(path: PathLike) -> Mechanism:
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
    return Mechanism.open(path)


def loads(text: str) -> Mechanism:
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
    return Mechanism.from_text(text)
