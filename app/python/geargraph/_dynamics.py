"""Masses, the equation of motion in the inputs, and the motion that torques cause."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping, NamedTuple, Optional, Tuple

from . import _geargraph
from ._elements import JointLike
from ._numbers import array, doubles

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
    import pandas as pd

    from ._analysis import Analysis

ByInput = Optional[Mapping[Any, float]]
"""Numbers by input (a `TurningJoint`, its label or id); those that are left out are 0."""


class LinkMass(NamedTuple):
    """A link as a rigid body, in the reference pose, base frame.

    Attributes
    ----------
    link : int
        Label.
    mass : float
        kg.
    center : tuple of three float
        Its centre, m.
    inertia : tuple of six float
        About the centre along the axes of the base frame, kg m²: xx, yy, zz, xy, xz, yz.
    source : str
        "solids", "stated", "scaled" (a stated mass, spread as the solids are) or "none".
    """

    link: int
    mass: float
    center: Tuple[float, float, float]
    inertia: Tuple[float, float, float, float, float, float]
    source: str


class EquationOfMotion:
    """M a + h = tau + load in the inputs, at one pose and speed; immutable.

    Attributes
    ----------
    inputs : tuple of int
        Labels, in the order of rows and columns.
    kinetic, potential : float
        Energies, J.
    """

    __slots__ = ("inputs", "kinetic", "potential", "_inertia", "_bias", "_load", "_reflected", "_links")

    def __init__(
        self,
        inputs: Tuple[int, ...],
        links: int,
        row: Tuple[bytes, bytes, bytes, bytes, float, float],
    ) -> None:
        self.inputs = inputs
        self._links = links
        self._inertia, self._bias, self._load, self._reflected, self.kinetic, self.potential = row

    def __repr__(self) -> str:
        return f"<EquationOfMotion in the inputs {self.inputs}>"

    @property
    def inertia(self) -> npt.NDArray[np.float64]:
        """M, the generalised inertia; imports NumPy.

        Returns
        -------
        numpy.ndarray
            float64, shape ``(E, E)``, symmetric, kg m².
        """
        return array(self._inertia, "=f8", len(self.inputs), len(self.inputs))

    @property
    def bias(self) -> Tuple[float, ...]:
        """h: torques, N m, for Coriolis and centrifugal forces and for weight."""
        return doubles(self._bias)

    @property
    def load(self) -> Tuple[float, ...]:
        """What the document's loads do, N m."""
        return doubles(self._load)

    @property
    def holding_torques(self) -> Tuple[float, ...]:
        """What motors have to give for constant speeds, N m: h - load."""
        return tuple(bias - load for bias, load in zip(self.bias, self.load))

    @property
    def reflected(self) -> npt.NDArray[np.float64]:
        """The inertia that each link has at each motor while the others stand still; imports NumPy.

        Returns
        -------
        numpy.ndarray
            float64, shape ``(n + 1, E)``, by label of the link, kg m². Each column sums to the
            diagonal entry of `inertia`.
        """
        return array(self._reflected, "=f8", self._links, len(self.inputs))


class Motion:
    """The motion that torques cause; immutable.

    Attributes
    ----------
    inputs : tuple of int
        Labels of the inputs.
    end : str
        "complete"; "limit": a joint reached the end of its range; "massless": a motion of the
        inputs moves no mass, so torques determine no acceleration; "unbounded": speeds grow beyond
        what can be followed.
    limit_joint : int or None
        Label of the joint at its limit.
    columns : tuple of str
        "time", "angle 8", "speed 8", "acceleration 8", "torque 8", ..., "kinetic", "potential",
        "work": s, rad, rad/s, rad/s², N m, J.
    """

    __slots__ = ("inputs", "end", "limit_joint", "columns", "_rows")

    def __init__(
        self, inputs: Tuple[int, ...], first: int, row: Tuple[str, int, bytes]
    ) -> None:
        self.inputs = inputs
        self.end, joint, self._rows = row
        self.limit_joint = first + joint if joint >= 0 else None
        quantities = ("angle", "speed", "acceleration", "torque")
        by_input = (f"{quantity} {label}" for quantity in quantities for label in inputs)
        self.columns = ("time", *by_input, "kinetic", "potential", "work")

    def __len__(self) -> int:
        return len(self._rows) // (8 * len(self.columns))

    def __repr__(self) -> str:
        return f"<Motion: {len(self)} samples, {self.end}>"

    def to_numpy(self) -> npt.NDArray[np.float64]:
        """Give the samples; imports NumPy.

        Returns
        -------
        numpy.ndarray
            float64, shape ``(len(motion), len(columns))``, read-only.
        """
        return array(self._rows, "=f8", len(self), len(self.columns))

    def to_pandas(self) -> pd.DataFrame:
        """Give the samples as a table; imports pandas.

        Returns
        -------
        pandas.DataFrame
            The other `columns`, by time.
        """
        import pandas as pd

        return pd.DataFrame(self.to_numpy(), columns=list(self.columns)).set_index("time")


class Dynamics:
    """A mechanism as rigid links that its inputs move, as engaged; immutable.

    Attributes
    ----------
    inputs : tuple of int
        Labels of the inputs, in the order of all tuples and arrays.
    gravity : tuple of three float
        Acceleration of free fall, m/s², base frame.
    """

    def __init__(self, analysis: Analysis) -> None:
        self._analysis = analysis
        self._made = _geargraph.Dynamics(analysis._snapshot)
        self._first = analysis.mechanism.n + 1
        self.inputs = tuple(self._first + joint for joint in self._made.inputs())
        self.gravity = doubles(self._made.gravity())

    def __repr__(self) -> str:
        return f"<Dynamics of {self._analysis.mechanism!r} in the inputs {self.inputs}>"

    @property
    def links(self) -> Tuple[LinkMass, ...]:
        """The masses of the moving links."""
        rows = enumerate(self._made.links())
        return tuple(LinkMass(label, *row) for label, row in rows if label > 0)

    def equation(self, angles: ByInput = None, speeds: ByInput = None) -> EquationOfMotion:
        """Set up the equation of motion.

        Parameters
        ----------
        angles, speeds : mapping, optional
            Of the inputs, rad and rad/s.

        Returns
        -------
        EquationOfMotion
            At this pose and these speeds.

        Raises
        ------
        ValueError
            If a joint is not an input.
        """
        row = self._made.equation(self._numbers(angles), self._numbers(speeds))
        return EquationOfMotion(self.inputs, self._first, row)

    def accelerations(
        self, torques: ByInput = None, *, angles: ByInput = None, speeds: ByInput = None
    ) -> Optional[Tuple[float, ...]]:
        """Find the accelerations of the inputs for torques of their motors.

        Parameters
        ----------
        torques : mapping, optional
            N m, tail of the joint on its head about +direction of its axis.
        angles, speeds : mapping, optional
            Of the inputs, rad and rad/s.

        Returns
        -------
        tuple of float or None
            rad/s²; None where a motion of the inputs moves no mass.
        """
        packed = self._made.accelerations(
            self._numbers(angles), self._numbers(speeds), self._numbers(torques)
        )
        return None if packed is None else doubles(packed)

    def simulate(
        self,
        seconds: float,
        torques: ByInput = None,
        *,
        damping: ByInput = None,
        angles: ByInput = None,
        speeds: ByInput = None,
        interval: Optional[float] = None,
    ) -> Motion:
        """Follow the motion that motors, loads and weight cause.

        Kinetic and potential energy less the work stay the same, but for the accuracy of 1e-9 a
        step. Contacts are not computed.

        Parameters
        ----------
        seconds : float
            How long, 1e-6 to 1e6.
        torques : mapping, optional
            Of the motors at rest, N m.
        damping : mapping, optional
            What each motor gives less for each rad/s, N m s, at least 0.
        angles, speeds : mapping, optional
            Of the inputs at the start, rad and rad/s.
        interval : float, optional
            Between samples, s; a hundredth of the motion.

        Returns
        -------
        Motion
            At most a million samples.

        Raises
        ------
        ValueError
            If a joint is not an input, or a number is out of its range.
        """
        row = self._made.simulate(
            self._numbers(torques), self._numbers(damping), self._numbers(angles),
            self._numbers(speeds), seconds, seconds / 100 if interval is None else interval,
        )
        return Motion(self.inputs, self._first, row)

    def _numbers(self, values: ByInput) -> Tuple[float, ...]:
        numbers = dict.fromkeys(self.inputs, 0.0)
        for reference, value in (values or {}).items():
            label = self._label(reference)
            if label not in numbers:
                raise ValueError(f"joint {label} is not an input; these are {self.inputs}")
            numbers[label] = float(value)
        return tuple(numbers.values())

    def _label(self, reference: JointLike) -> int:
        return self._analysis.mechanism.joint(reference).label
