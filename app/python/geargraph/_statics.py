"""Torques, forces and powers under loads."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any, Dict, List, NamedTuple, Optional, Tuple, Union

from ._errors import Diagnostic, Element
from ._matrix import Entry, Heading, Matrix

if TYPE_CHECKING:
    import pandas as pd

Value = Optional[Union[Fraction, float]]
"""Exact where it is a fraction, a float where roots are in it, None where it is not determined."""

Vector = Optional[Tuple[float, float, float]]

_KINDS = {
    "links": "link", "axes": "axis", "turningJoints": "joint", "gearMeshes": "mesh",
    "wheels": "wheel", "couplings": "coupling", "states": "state", "loads": "load",
}


class Balance(NamedTuple):
    """A torque that holds the loads.

    Attributes
    ----------
    joint, link : int or None
        Label of where it acts: one of the two.
    axis : str or None
        Of a torque on a link: about whose direction.
    torque : Fraction, float or None
        N m, in a joint tail on head about +direction of its axis; None where it is not determined.
    power : Fraction, float or None
        W, fed into the train.
    """

    joint: Optional[int]
    link: Optional[int]
    axis: Optional[str]
    torque: Value
    power: Value


class MeshForce(NamedTuple):
    """What a gear mesh transmits.

    Attributes
    ----------
    mesh, tail, head, carrier : int
        Labels of the mesh and of its links.
    tail_torque, head_torque : Fraction, float or None
        N m on each gear, about +direction of the axis of the joint next to it on the way to the
        carrier, which has the reactions.
    tangential : float or None
        N; None where it is not determined or the unit of length has no known size.
    force : tuple of three float, or None
        N, of the tail on the head, base frame.
    power : Fraction, float or None
        W across the teeth from tail to head, seen from the carrier.
    loss : Fraction, float or None
        W.
    driver : str or None
        "tail" or "head".
    """

    mesh: int
    tail: int
    head: int
    carrier: int
    tail_torque: Value
    head_torque: Value
    tangential: Optional[float]
    force: Vector
    power: Value
    loss: Value
    driver: Optional[str]


class Bearing(NamedTuple):
    """The reaction in a turning joint, tail on head.

    Attributes
    ----------
    joint : int
        Label.
    point : tuple of three float
        Where it is taken, base frame, in the document's unit.
    force : tuple of three float, or None
        N.
    moment : tuple of three float, or None
        N m about the point.
    """

    joint: int
    point: Tuple[float, float, float]
    force: Vector
    moment: Vector


class Efficiency(NamedTuple):
    """The efficiency of a train with losses.

    Attributes
    ----------
    value : Fraction, float or None
        Power out over power in.
    symbol : str or None
        The same in the gear ratios and the efficiencies of the meshes.
    self_locking : bool
        No motion is possible in this direction.
    """

    value: Value
    symbol: Optional[str]
    self_locking: bool


class Statics:
    """The torques that hold the loads of a mechanism, by both methods; immutable.

    Attributes
    ----------
    state : str or None
        The state that was solved.
    engaged : tuple of str
        Ids of the couplings that are engaged.
    """

    def __init__(self, data: Dict[str, Any]) -> None:
        self._data = data
        self.state: Optional[str] = data["state"]
        self.engaged: Tuple[str, ...] = tuple(data["engaged"] or ())

    def __repr__(self) -> str:
        solved = "held" if self.held else "not held"
        return f"<Statics: {solved}, {len(self.diagnostics)} findings>"

    @property
    def json(self) -> Dict[str, Any]:
        """All members of ``geargraph-cli statics --json``, which its schema page describes."""
        return dict(self._data)

    @property
    def diagnostics(self) -> Tuple[Diagnostic, ...]:
        """Findings: "unbalanced" where nothing holds a load, "statically-indeterminate", ..."""
        found: List[Diagnostic] = []
        for row in self._data["diagnostics"]:
            elements = tuple(
                Element(_KINDS[kind], id) for kind, ids in row["elements"].items() for id in ids
            )
            found.append(
                Diagnostic(
                    row["severity"], row["code"], row.get("detail", ""), row["message"], elements
                )
            )
        return tuple(found)

    @property
    def held(self) -> bool:
        """Are the loads held?"""
        return self._data["meshes"] is not None

    @property
    def balances(self) -> Tuple[Balance, ...]:
        """The torques that hold the loads."""
        return tuple(
            Balance(
                row.get("joint"), row.get("link"), row.get("axis"), _value(row["torque"]),
                _value(row.get("power")),
            )
            for row in self._data["balances"] or ()
        )

    @property
    def joint_torques(self) -> Dict[int, Value]:
        """Torques of loads and balances in the joints by label, N m, tail on head; joints without
        any are left out."""
        torques: Dict[str, Any] = self._data["jointTorques"] or {}
        return {int(label): _value(torque) for label, torque in torques.items()}

    @property
    def coupling_torques(self) -> Dict[str, Value]:
        """Torques of the engaged couplings by id, N m: of a brake on its link, of a clutch on the
        first link that it names."""
        couplings: Dict[str, Any] = self._data["couplings"] or {}
        return {id: _value(row["torque"]) for id, row in couplings.items()}

    @property
    def mesh_forces(self) -> Tuple[MeshForce, ...]:
        """What each mesh transmits."""
        return tuple(
            MeshForce(
                row["mesh"], row["tail"], row["head"], row["carrier"], _value(row["tailTorque"]),
                _value(row["headTorque"]), row["tangentialForce"], _vector(row["force"]),
                _value(row.get("power")), _value(row.get("loss")), row.get("driver"),
            )
            for row in self._data["meshes"] or ()
        )

    @property
    def bearings(self) -> Tuple[Bearing, ...]:
        """The reaction in each turning joint."""
        return tuple(
            Bearing(
                row["joint"], _vector(row["point"]) or (0.0, 0.0, 0.0), _vector(row["force"]),
                _vector(row["moment"]),
            )
            for row in self._data["bearings"] or ()
        )

    @property
    def efficiency(self) -> Optional[Efficiency]:
        """The efficiency; None without losses or without a motion."""
        return _efficiency(self._data["efficiency"])

    @property
    def backward_efficiency(self) -> Optional[Efficiency]:
        """The efficiency where the known torques are reversed."""
        data = self._data["efficiency"]
        return _efficiency(None if data is None else data["backward"])

    @property
    def power(self) -> Optional[Dict[str, Value]]:
        """Powers "input", "output" and "loss", W; None without a motion."""
        data = self._data["power"]
        if data is None:
            return None
        return {name: _value(data[name]) for name in ("input", "output", "loss")}

    @property
    def solution(self) -> Optional[Matrix]:
        """Torques of the balanced joints over those of the loaded ones, -K_rᵀ, Eq. (23*); None
        where balances are not all in joints."""
        data = self._data["solution"]
        if data is None:
            return None
        entries: Dict[Tuple[int, int], Entry] = {
            (i, j): Fraction(text)
            for i, row in enumerate(data["exact"]) for j, text in enumerate(row) if text != "0"
        }
        return Matrix(
            "τ", "Balancing torques", 23, "fractions", _headings(data["balanced"]),
            _headings(data["loaded"]), None, entries,
        )

    @property
    def agree(self) -> Optional[bool]:
        """Do both methods give the same torques? None where the T-T graph has no sign for a mesh."""
        agreement = self._data["agreement"]
        return None if agreement is None else bool(agreement["equal"])

    def to_pandas(self) -> pd.DataFrame:
        """Give what the meshes transmit as a table; imports pandas.

        Returns
        -------
        pandas.DataFrame
            A row for each mesh, by label; columns as the fields of `MeshForce`.
        """
        import pandas as pd

        frame = pd.DataFrame(self.mesh_forces, columns=MeshForce._fields)
        return frame.set_index("mesh")


def _value(value: Any) -> Value:
    return Fraction(value) if isinstance(value, str) else value


def _vector(value: Optional[List[float]]) -> Vector:
    return None if value is None else (value[0], value[1], value[2])


def _efficiency(data: Optional[Dict[str, Any]]) -> Optional[Efficiency]:
    if data is None:
        return None
    return Efficiency(_value(data["value"]), data["symbolic"], bool(data["selfLocking"]))


def _headings(labels: List[int]) -> Tuple[Heading, ...]:
    return tuple(Heading(label, f"τ{label}", None) for label in labels)
