"""What both methods say about a mechanism."""

from __future__ import annotations

import json
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Optional, Tuple, Union

from . import _geargraph
from ._derivation import Derivation
from ._dynamics import Dynamics
from ._elements import Link, TurningJoint
from ._errors import Diagnostic, diagnostics_of
from ._exports import Exports
from ._frequencies import Backlash, Frequencies, backlash_of, frequencies_of
from ._matrix import Entry, Matrix, Quantity, headings_of
from ._methods import MatroidMethod, TtGraphMethod
from ._numbers import Number, array, doubles, integers, text_of
from ._results import InputSets, MotionCheck, States, state_of
from ._statics import Statics

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from ._mechanism import Mechanism


_MATRICES = tuple(name for name, kind in _geargraph.results() if kind == "matrix")
_QUANTITIES = tuple(name for name, kind in _geargraph.results() if kind == "quantity")


class Pose:
    """Where a mechanism is for given angles of its inputs; immutable.

    Attributes
    ----------
    joint_angles : dict of int to float
        By label, rad, with all turns; ``inf`` beyond the range of doubles.
    whole_angles : dict of int to float
        The same.
    beyond_limits : tuple of int
        Labels of joints that are beyond their limits.
    """

    __slots__ = ("joint_angles", "whole_angles", "beyond_limits", "_links", "_matrices")

    def __init__(self, analysis: Analysis, row: Tuple[bytes, bytes, List[int]]) -> None:
        angles, self._matrices, beyond = row
        first = analysis.mechanism.n + 1
        self.joint_angles = {first + i: angle for i, angle in enumerate(doubles(angles))}
        self.whole_angles = self.joint_angles
        self.beyond_limits = tuple(first + joint for joint in beyond)
        self._links = analysis.mechanism.n + 1

    def to_numpy(self) -> npt.NDArray[np.float64]:
        """Give the displacements of all links; imports NumPy.

        Returns
        -------
        numpy.ndarray
            float64, shape ``(n + 1, 4, 4)``, by label, read-only: a point that was at x in the
            reference pose is at ``T[label] @ [*x, 1]``, base frame, in the document's unit.
        """
        return array(self._matrices, "=f8", self._links, 4, 4)

    def __repr__(self) -> str:
        return f"<Pose of {self._links} links>"


class Analysis(Exports):
    """What follows from a mechanism as it was when it was analysed; immutable.

    Each part is computed when it is asked for first. Long work leaves the interpreter to other
    threads, and Ctrl+C ends it with ``KeyboardInterrupt``.

    Attributes
    ----------
    mechanism : Mechanism
        A copy of the mechanism that was analysed.
    """

    def __init__(self, mechanism: Mechanism, symbolic: bool = True) -> None:
        self.mechanism = mechanism
        self._snapshot = _geargraph.Snapshot(mechanism._document, symbolic)
        self._kept: Dict[str, Any] = {}

    def __repr__(self) -> str:
        errors = sum(d.severity == "error" for d in diagnostics_of(self._snapshot.live_findings()))
        state = f"{errors} errors" if errors else f"rank {self.rank}, {self.dof} degrees of freedom"
        return f"<Analysis of {self.mechanism!r}: {state}>"

    @property
    def _json(self) -> Dict[str, Any]:
        if "json" not in self._kept:
            self._kept["json"] = json.loads(self._snapshot.json())
        parts: Dict[str, Any] = self._kept["json"]
        return parts

    # --- counts ----------------------------------------------------------------------------------

    @property
    def rank(self) -> int:
        """Rank r of the coefficient matrix P, with the rows of engaged couplings below it; exact."""
        return self._snapshot.rank()

    @property
    def dof(self) -> int:
        """Degrees of freedom E = t - r, Eq. (21)."""
        return self._snapshot.dof()

    @property
    def inputs(self) -> Tuple[int, ...]:
        """Labels of the driven joints, in the order of the solution's columns."""
        first = self.mechanism.n + 1
        return tuple(first + joint for joint in self._snapshot.inputs())

    @property
    def diagnostics(self) -> Tuple[Diagnostic, ...]:
        """All findings, those about teeth and states among them."""
        return diagnostics_of(self._snapshot.findings())

    @property
    def ok(self) -> bool:
        """Is the mechanism without errors?"""
        rows = diagnostics_of(self._snapshot.live_findings())
        return all(d.severity != "error" for d in rows)

    # --- matrices --------------------------------------------------------------------------------

    def matrix(self, name: str) -> Matrix:
        """Give a matrix of whole numbers.

        Parameters
        ----------
        name : {"incidence", "reduced-incidence", "path", "spanning-tree", "cycle-basis", "cutset"}
            As the command line names it.

        Returns
        -------
        Matrix
            With its labels.

        Raises
        ------
        Error
            "disconnected" or "turning-loop" if the matrix needs a spanning tree.
        ValueError
            If there is no such matrix; the names are listed.
        """
        if name not in _MATRICES:
            raise ValueError(f"There is no matrix {name!r}; these are {', '.join(_MATRICES)}.")
        if name not in self._kept:
            symbol, title, equation, rows, columns, partition, *packed = self._snapshot.matrix(name)
            row_of, column_of, values = packed
            signed = [value - 256 if value > 127 else value for value in values]
            entries: Dict[Tuple[int, int], Entry] = dict(
                zip(zip(integers(row_of), integers(column_of)), signed)
            )
            self._kept[name] = Matrix(
                symbol, title, equation, "integers", headings_of(rows), headings_of(columns),
                partition, entries,
            )
        matrix: Matrix = self._kept[name]
        return matrix

    @property
    def incidence(self) -> Matrix:
        """Incidence matrix Γ⁰, Eq. (1): (n+1) × (t+c), +1 where an edge's arrow ends, -1 where it
        begins."""
        return self.matrix("incidence")

    @property
    def reduced_incidence(self) -> Matrix:
        """Reduced incidence matrix Γ = [G | G*], Eq. (2): n × (t+c), without the ground's row."""
        return self.matrix("reduced-incidence")

    @property
    def path(self) -> Matrix:
        """Path matrix Z, Eq. (3): t × n; G Z = -I."""
        return self.matrix("path")

    @property
    def spanning_tree(self) -> Matrix:
        """Spanning-tree matrix T = G*ᵀ Zᵀ, Eq. (4): c × t."""
        return self.matrix("spanning-tree")

    @property
    def cycle_basis(self) -> Matrix:
        """Cycle-basis matrix C = [T | U], Eq. (5): c × (t+c); Γ Cᵀ = 0."""
        return self.matrix("cycle-basis")

    @property
    def cutset(self) -> Matrix:
        """Cutset matrix Q = [U | -Tᵀ]: t × (t+c); C Qᵀ = 0."""
        return self.matrix("cutset")

    def _form(self, name: str, form: str) -> Optional[Matrix]:
        row = self._snapshot.quantity(name, form)
        if row is None:
            return None
        (
            symbol, title, equation, rows, columns, partition, row_of, column_of, values, texts, latex,
        ) = row
        places = list(zip(integers(row_of), integers(column_of)))
        entries: List[Entry]
        if form == "decimals":
            entries = list(doubles(values))
        elif form == "fractions":
            if any(text.startswith("≈") for text in texts):
                return None
            entries = [Fraction(text) for text in texts]
        else:
            entries = list(texts)
        return Matrix(
            symbol, title, equation, form, headings_of(rows), headings_of(columns), partition,
            dict(zip(places, entries)), dict(zip(places, latex)),
        )

    def quantity(self, name: str) -> Quantity:
        """Give a result of numbers, formulas or both methods.

        Parameters
        ----------
        name : {"screw", "p", "solution", "tt-circuits", "tt-cutsets", "cutset-equations"}
            As the command line names it. ``screws``, ``coefficients`` and ``solution`` are the first three.

        Returns
        -------
        Quantity
            In the forms that it has.

        Raises
        ------
        Error
            The errors of the mechanism; "undefined" where it leaves nothing to solve.
        ValueError
            If there is no such result; the names are listed.
        """
        if name not in _QUANTITIES:
            raise ValueError(f"There is no quantity {name!r}; these are {', '.join(_QUANTITIES)}.")
        if name not in self._kept:
            decimals = self._form(name, "decimals")
            fractions = self._form(name, "fractions")
            assert decimals is not None
            self._kept[name] = Quantity(decimals, fractions, self._form(name, "symbols"))
        quantity: Quantity = self._kept[name]
        return quantity

    @property
    def screws(self) -> Quantity:
        """Screws û = (L M N; P Q R) of the joints of each cycle about its pitch point, Eqs. (6)-(12)."""
        return self.quantity("screw")

    @property
    def coefficients(self) -> Quantity:
        """Coefficient matrix P, Eqs. (18), (19), (24): c × t, lengths in the document's unit; as
        symbols the rows divided by the radius of the head's gear."""
        return self.quantity("p")

    @property
    def solution(self) -> Quantity:
        """Rates of the outputs over those of the inputs, -P_r⁻¹ P_E, Eqs. (22), (23), (25).

        Raises
        ------
        Error
            The errors of the mechanism, "invalid-inputs" among them.
        """
        self._snapshot.rates()  # raises where there is no solution
        return self.quantity("solution")

    # --- motion ----------------------------------------------------------------------------------

    @property
    def joint_speeds(self) -> Dict[int, Fraction]:
        """Speeds of all turning joints by label, rad/s, head against tail; exact."""
        self._snapshot.rates()
        return {int(label): Fraction(rate) for label, rate in self._json["jointSpeeds"].items()}

    @property
    def joint_rates(self) -> Tuple[float, ...]:
        """The same in doubles, in the order of the joints; for studies of many mechanisms, which do
        not need fractions."""
        return doubles(self._snapshot.rates())

    @property
    def link_velocities(self) -> Dict[int, Tuple[float, float, float]]:
        """Absolute angular velocities of the moving links by label, rad/s, base frame, reference
        pose."""
        self._snapshot.rates()
        velocities: Dict[str, List[float]] = self._json["linkVelocities"]
        return {int(label): (w[0], w[1], w[2]) for label, w in velocities.items()}

    def input_sets(self, limit: int = 1000) -> InputSets:
        """Count and list the valid sets of inputs.

        Parameters
        ----------
        limit : int, optional
            How many are listed.

        Returns
        -------
        InputSets
            In the order of their labels.

        Raises
        ------
        Error
            The errors of the mechanism; "limit" if it is too large.
        """
        total, sets = self._snapshot.input_sets(limit)
        return InputSets(None if total is None else int(total), tuple(tuple(s) for s in sets))

    def pose(
        self, angles: Optional[Mapping[Any, Number]] = None, *, degrees: bool = False
    ) -> Pose:
        """Find where every link is for given angles of the inputs.

        Parameters
        ----------
        angles : mapping of TurningJoint, str or int to number, optional
            Angles of the inputs from the reference pose; those left out are 0.
        degrees : bool, optional
            Are they in degrees? Else in radians.

        Returns
        -------
        Pose
            Angles of all joints and displacements of all links.

        Raises
        ------
        Error
            The errors of the mechanism.
        ValueError
            If a joint is not an input.
        """
        inputs = self.inputs
        texts = ["0"] * len(inputs)
        for reference, angle in (angles or {}).items():
            label = self.mechanism.joint(reference).label
            if label not in inputs:
                raise ValueError(f"joint {label} is not an input; these are {inputs}")
            texts[inputs.index(label)] = text_of(angle)
        zeros = ["0"] * len(inputs)
        row = self._snapshot.pose(texts, zeros) if degrees else self._snapshot.pose(zeros, texts)
        return Pose(self, row)

    def check_motion(self) -> Optional[MotionCheck]:
        """Look for links that collide while the inputs run at their speeds.

        Returns
        -------
        MotionCheck or None
            None where nothing moves, the mechanism has errors, or it has over 300 links.
        """
        row = self._snapshot.motion()
        if row is None:
            return None
        start, end, covers_all, complete, rows = row
        return MotionCheck(start, end, covers_all, complete, diagnostics_of(rows))

    # --- methods, states, statics, derivation ------------------------------------------------------

    @property
    def matroid(self) -> MatroidMethod:
        """The Matroid method, Eqs. (6)-(25)."""
        return MatroidMethod(self)

    @property
    def tt_graph(self) -> TtGraphMethod:
        """The T-T graph method, Eqs. (26)-(45)."""
        return TtGraphMethod(self)

    @property
    def agree(self) -> bool:
        """Do both methods give the same fractions?"""
        self._snapshot.rates()
        return bool(self._json["agreement"]["equal"])

    @property
    def ratios(self) -> Dict[str, Fraction]:
        """The gear ratios i = N_tail / N_head by name, "i15", Eq. (20); and by the names of the T-T
        graph, "n41" and its inverse "n14", Eq. (44)."""
        values: Dict[str, Fraction] = {}
        for mesh, (name, own, _, inverse, _) in zip(self.mechanism.meshes, self._snapshot.ratios()):
            values[name] = values[own] = mesh.ratio
            values[inverse] = 1 / mesh.ratio
        return values

    @property
    def states(self) -> States:
        """The shift table: what each state of the document does, whatever is engaged now."""
        if "states" not in self._kept:
            rows = json.loads(self._snapshot.states_json())["states"]
            self._kept["states"] = States(state_of(row) for row in rows or ())
        states: States = self._kept["states"]
        return states

    def vibration(
        self,
        rpm: Optional[float] = None,
        *,
        reference: Union[TurningJoint, Link, int, None] = None,
        harmonics: int = 1,
        sidebands: int = 1,
        planets: int = 1,
    ) -> Tuple[Frequencies, ...]:
        """Find the frequencies of shafts, tooth meshes and planets.

        Parameters
        ----------
        rpm : float, optional
            The speed of the reference shaft: frequencies are also in Hz.
        reference : TurningJoint, Link or int, optional
            The shaft that ratios are to, an element or its label; without it the first input that
            turns, in a state its drive.
        harmonics, sidebands : int, optional
            Multiples of each tooth mesh, 1 to 20, and lines on each side of each, 0 to 20.
        planets : int, optional
            How many planets one stands for that is drawn alone, 1 to 100.

        Returns
        -------
        tuple of Frequencies
            One for each state; one alone without states, or with couplings engaged.

        Raises
        ------
        ValueError
            A number out of its range.
        Error
            "unknown-id" if there is no such element.
        """
        label = reference if reference is None or isinstance(reference, int) else reference.label
        rows = json.loads(self._snapshot.vibration_json(rpm, label, harmonics, sidebands, planets))
        return tuple(frequencies_of(row) for row in rows["cases"])

    @property
    def backlash(self) -> Tuple[Backlash, ...]:
        """How far outputs turn while the inputs are held, by the play of the teeth: for each state;
        once without states, or with couplings engaged."""
        if "backlash" not in self._kept:
            rows = json.loads(self._snapshot.backlash_json())
            self._kept["backlash"] = tuple(backlash_of(row) for row in rows["cases"])
        backlash: Tuple[Backlash, ...] = self._kept["backlash"]
        return backlash

    def statics(
        self,
        *,
        state: Optional[str] = None,
        losses: bool = False,
        efficiency: Optional[Number] = None,
        stiffness: bool = False,
        symbolic: bool = True,
    ) -> Statics:
        """Find the torques that hold the loads of the mechanism.

        Parameters
        ----------
        state : str, optional
            With the couplings of this state engaged, instead of those engaged now.
        losses : bool, optional
            With the losses of the meshes.
        efficiency : number, optional
            Of meshes that state no losses, above 0, at most 1; implies ``losses``.
        stiffness : bool, optional
            Share what several meshes carry together by equal stiffness of all teeth; else as
            the document states.
        symbolic : bool, optional
            Solve in the gear ratios, too.

        Returns
        -------
        Statics
            Torques, forces, powers and efficiency.

        Raises
        ------
        Error
            The errors of the mechanism; "unknown-id" if there is no such state.
        """
        share = None if efficiency is None else text_of(efficiency)
        return Statics(
            json.loads(self._snapshot.statics_json(state, losses, share, stiffness, symbolic))
        )

    @property
    def dynamics(self) -> Dynamics:
        """The masses of the links, the equation of motion in the inputs, and motions.

        Raises
        ------
        Error
            The errors of the mechanism; "unknown-unit" if its unit of length has no known size;
            "limit" if it is too large.
        """
        if "dynamics" not in self._kept:
            self._kept["dynamics"] = Dynamics(self)
        dynamics: Dynamics = self._kept["dynamics"]
        return dynamics

    @property
    def derivation(self) -> Derivation:
        """Both methods worked out for this mechanism, equation by equation.

        Raises
        ------
        Error
            "limit" over 200 links.
        """
        if "derivation" not in self._kept:
            title, blocks = self._snapshot.derivation()
            self._kept["derivation"] = Derivation(self._snapshot, title, blocks)
        derivation: Derivation = self._kept["derivation"]
        return derivation
