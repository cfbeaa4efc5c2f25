"""The paper's robot: printed numbers, typed from the page."""

from fractions import Fraction

import numpy as np
import pytest
from conftest import built_robot

F = Fraction


def test_edits_give_the_robot_of_the_example(robot):
    m = built_robot()
    assert [(j.tail.label, j.head.label) for j in m.joints] == [
        (j.tail.label, j.head.label) for j in robot.joints
    ]
    assert [mesh.teeth for mesh in m.meshes] == [mesh.teeth for mesh in robot.meshes]
    assert m.analyze().incidence == robot.analyze().incidence
    assert m.analyze().joint_speeds == robot.analyze().joint_speeds


def test_eq05_cycle_basis_matrix(robot):
    expected = [
        # 8  9  10  11  12  13  14  15  16  17  18
        [1, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0],
        [0, 1, -1, 0, -1, 0, 0, 0, 1, 0, 0],
        [0, 0, 0, 1, -1, -1, 0, 0, 0, 1, 0],
        [0, 0, 0, 0, 0, 1, -1, 0, 0, 0, 1],
    ]
    c = robot.analyze().cycle_basis
    assert c.to_list() == expected
    assert [row.text for row in c.rows] == ["C15", "C16", "C17", "C18"]
    assert [column.label for column in c.columns] == list(range(8, 19))
    assert c.equation == 5
    assert c["C15", 10] == c[15, "10"] == -1


def test_identities_of_the_matrices(robot):
    a = robot.analyze()
    n, t = robot.n, robot.t
    whole, reduced, path, tree, cycles, cutsets = (
        matrix.to_numpy()
        for matrix in (a.incidence, a.reduced_incidence, a.path, a.spanning_tree, a.cycle_basis, a.cutset)
    )
    assert not whole.sum(axis=0).any()
    turning, meshing = (a.reduced_incidence.part(side).to_numpy() for side in (0, 1))
    assert (turning @ path == -np.eye(n)).all()
    assert (tree == meshing.T @ path.T).all()  # Eq. (4)
    assert not (reduced @ cycles.T).any()
    assert not (cycles @ cutsets.T).any()
    assert (cutsets[:, :t] == np.eye(t)).all()


def test_eq06_screws(robot):
    screws = robot.analyze().screws
    assert screws.fractions.rows[0].text == "C15 8"
    assert screws.fractions.to_list()[:2] == [[0, 0, 1, -18, 0, 0], [0, 0, 1, 36, 0, 0]]


def test_eq19_coefficients_are_diameters_over_two(robot):
    p = robot.analyze().coefficients
    assert p.fractions.shape == (4, 7)
    theta = np.array(robot.analyze().joint_rates)
    assert np.allclose(p.to_numpy() @ theta, 0)
    assert p.fractions[15, 8] == -18 and p.fractions[15, 10] == -36
    assert p.symbols[15, 8] in ("i15", "-i15")


def test_eq25_solution_in_gear_ratios(robot):
    symbols = robot.analyze().solution.symbols
    assert [row.label for row in symbols.rows] == [10, 12, 13, 14]
    assert [column.label for column in symbols.columns] == [8, 9, 11]
    assert symbols.at(0, 0) == "-i15"
    assert symbols.to_list()[0][1:] == ["0", "0"]


def test_eq45_tt_graph_gives_the_same(robot):
    a = robot.analyze()
    assert a.agree
    ours, theirs = a.matroid.solution.fractions, a.tt_graph.solution.fractions
    assert [row.label for row in theirs.rows] == [row.label for row in ours.rows]
    assert ours.to_list() == theirs.to_list()
    assert theirs.to_list()[0] == [F(-1, 2), 0, 0]


def test_eq39_to_eq42_are_the_steps(robot):
    steps = robot.analyze().tt_graph.steps
    assert [step.number for step in steps] == [39, 40, 41, 42]
    assert [step.joint for step in steps] == [10, 12, 14, 13]
    assert all(step.before and len(step.after) == 3 for step in steps)
    assert 39 in steps[1].uses


def test_transfer_vertices(robot):
    vertices = robot.analyze().tt_graph.transfer_vertices
    assert [vertex.carrier for vertex in vertices] == [0, 1, 2, 2]
    assert vertices[0].path[0] == 4 and vertices[0].path[-1] == 1


def test_matroid_steps_solve_in_an_order(robot):
    known = set(robot.analyze().inputs)
    for step in robot.analyze().matroid.steps:
        assert all(term.joint in known for term in step.terms)
        assert step.equation.kind == "mesh"
        known.add(step.joint)
    assert known == set(range(8, 15))


def test_exact_speeds_are_fractions(robot):
    speeds = robot.analyze().joint_speeds
    assert speeds[8] == 1 and speeds[9] == F(1, 2) and speeds[10] == F(-1, 2)
    assert all(isinstance(speed, Fraction) for speed in speeds.values())


@pytest.mark.parametrize("number", [*range(1, 7), 16, 17, 18, 20, 21, 23, 24, 25, *range(27, 46)])
def test_the_derivation_has_the_papers_equations(robot, number):
    equation = robot.analyze().derivation.equation(number)
    assert equation.tex
    assert f"\\tag{{{number}}}" in equation._repr_latex_()


def test_link_velocities(robot):
    velocities = robot.analyze().link_velocities
    assert velocities[1] == (0, 0, -0.5)
    assert set(velocities) == set(range(1, 8))


def test_poses_follow_the_rates(robot):
    a = robot.analyze()
    pose = a.pose({8: 30, 11: -45}, degrees=True)
    assert pose.joint_angles[10] == pytest.approx(-np.pi / 12)
    placed = pose.to_numpy()
    assert placed.shape == (8, 4, 4)
    assert (placed[0] == np.eye(4)).all()
    assert np.allclose(placed[:, :3, :3] @ placed[:, :3, :3].transpose(0, 2, 1), np.eye(3))
    assert a.pose({8: 400}, degrees=True).beyond_limits == (10, 12)
    turned = a.pose({8: 3630}, degrees=True)
    assert turned.joint_angles[8] == pytest.approx(np.radians(3630))
    assert turned.joint_angles[10] == pytest.approx(np.radians(-1815))
    assert np.allclose(a.pose().to_numpy(), np.eye(4))


def test_input_sets(robot):
    found = robot.analyze().input_sets(limit=5)
    assert found.total == 21 and len(found.sets) == 5
    assert found.sets[0] == (8, 9, 11)
