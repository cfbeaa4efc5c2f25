"""How elements of a mechanism are found."""

from __future__ import annotations

from ._editing import Edits
from ._elements import (
    Axis, AxisLike, Coupling, CouplingLike, GearMesh, JointLike, Link, LinkLike, MeshLike,
    TurningJoint,
)


class Lookup(Edits):
    """Elements by id, name or label."""

    def link(self, reference: LinkLike) -> Link:
        """Find a link.

        Parameters
        ----------
        reference : Link, str or int
            A link, its id, its name where one link has it, or its label.

        Returns
        -------
        Link
            The link.

        Raises
        ------
        Error
            "unknown-id" if there is no such link.
        """
        return self._resolved(Link, reference)

    def axis(self, reference: AxisLike) -> Axis:
        """Find an axis.

        Parameters
        ----------
        reference : Axis or str
            An axis or its id.

        Returns
        -------
        Axis
            The axis.

        Raises
        ------
        Error
            "unknown-id" if there is no such axis.
        """
        return self._resolved(Axis, reference)

    def joint(self, reference: JointLike) -> TurningJoint:
        """Find a turning joint.

        Parameters
        ----------
        reference : TurningJoint, str or int
            A joint, its id or its label.

        Returns
        -------
        TurningJoint
            The joint.

        Raises
        ------
        Error
            "unknown-id" if there is no such joint.
        """
        return self._resolved(TurningJoint, reference)

    def mesh(self, reference: MeshLike) -> GearMesh:
        """Find a gear mesh.

        Parameters
        ----------
        reference : GearMesh, str or int
            A mesh, its id or its label.

        Returns
        -------
        GearMesh
            The mesh.

        Raises
        ------
        Error
            "unknown-id" if there is no such mesh.
        """
        return self._resolved(GearMesh, reference)

    def coupling(self, reference: CouplingLike) -> Coupling:
        """Find a brake or clutch.

        Parameters
        ----------
        reference : Coupling or str
            A coupling or its id.

        Returns
        -------
        Coupling
            The coupling.

        Raises
        ------
        Error
            "unknown-id" if there is no such coupling.
        """
        return self._resolved(Coupling, reference)
