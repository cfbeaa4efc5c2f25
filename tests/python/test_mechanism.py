"""Mechanisms: edits, files, names of elements."""

import copy
import json
import pickle
from decimal import Decimal
from fractions import Fraction

import geargraph as gg
import numpy as np
import pytest
from conftest import EXAMPLES, built_robot


def spur_pair():
    m = gg.Mechanism("spur pair")
    pinion, wheel = m.add_link("pinion"), m.add_link("wheel")
    m.add_turning_joint(m.ground, pinion)
    m.add_turning_joint(m.ground, wheel)
    m.add_mesh(pinion, wheel, (18, 36))
    return m


def test_labels_follow_the_order_and_ids_stay():
    m = spur_pair()
    mesh = m.meshes[0]
    assert (mesh.label, mesh.id) == (5, mesh.id)
    idler = m.add_link("idler")
    assert mesh.label == 6
    m.remove(idler)
    assert mesh.label == 5
    assert mesh.ratio == Fraction(1, 2) and mesh.kind == "external"


@pytest.mark.parametrize("reference", ["pinion", 1])
def test_links_are_named_by_name_and_label(reference):
    m = spur_pair()
    assert m.link(reference).name == "pinion"
    assert m.link(m.link(reference)) == m.link(reference)
    assert m.link(m.links[1].id).label == 1


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.geargraph")), ids=lambda path: path.stem)
def test_every_example_is_read_and_written_unchanged(path, tmp_path):
    m = gg.open(path)
    m.save(tmp_path / "copy.geargraph")
    assert gg.open(tmp_path / "copy.geargraph") == m
    assert gg.loads(m.to_text()) == m
    assert pickle.loads(pickle.dumps(m)) == m
    assert copy.deepcopy(m) == m
    assert isinstance(m.analyze().diagnostics, tuple)


@pytest.mark.parametrize(
    "number, kept",
    [
        (7, Fraction(7)),
        (0.1, Fraction(1, 10)),
        ("22/7", Fraction(22, 7)),
        (Fraction(-3, 8), Fraction(-3, 8)),
        (Decimal("1.25"), Fraction(5, 4)),
        (np.float64(2.5), Fraction(5, 2)),
        (np.int64(-4), Fraction(-4)),
    ],
)
def test_numbers_stay_exact(number, kept):
    m = spur_pair()
    m.set_inputs({3: number})
    assert m.inputs == {m.joints[0].id: kept}
    assert m.analyze().joint_speeds[3] == kept


@pytest.mark.parametrize("number", [float("nan"), float("inf"), "one", Decimal("nan")])
def test_what_is_no_number_is_rejected(number):
    m = spur_pair()
    before = m.to_text()
    with pytest.raises((ValueError, gg.Error)):
        m.set_inputs({3: number})
    assert m.to_text() == before


def test_sympy_numbers_are_taken():
    import sympy

    m = spur_pair()
    m.set_inputs({3: sympy.Rational(2, 3)})
    assert m.analyze().joint_speeds[4] == Fraction(-1, 3)


REJECTED = {
    "self-joint": lambda m: m.add_turning_joint(1, 1),
    "turning-loop": lambda m: m.add_turning_joint(1, 2),
    "unknown-id": lambda m: m.add_mesh("pinion", "rack"),
    "schema": lambda m: m.set_teeth(5, (0, 7)),
    "duplicate-id": lambda m: (m.add_brake(1, "A"), m.add_brake(2, "A")),
}


@pytest.mark.parametrize("code", REJECTED)
def test_a_rejected_edit_changes_nothing(code):
    m = spur_pair()
    before = m.copy()
    with pytest.raises(gg.Error) as caught, m.edit():
        REJECTED[code](m)
    assert caught.value.code == code
    assert caught.value.diagnostics[0].message in str(caught.value)
    assert m == before


def test_errors_name_the_elements():
    m = spur_pair()
    with pytest.raises(gg.Error) as caught:
        m.add_turning_joint(1, 2)
    assert {element.kind for element in caught.value.elements} <= {"joint", "link", "axis"}
    assert caught.value.elements
    again = pickle.loads(pickle.dumps(caught.value))
    assert (again.code, again.elements, str(again)) == (
        caught.value.code, caught.value.elements, str(caught.value),
    )


def test_a_joint_on_a_new_axis_is_one_edit():
    m = gg.Mechanism()
    link = m.add_link()
    before = m.copy()
    with pytest.raises(gg.Error):
        m.add_turning_joint(0, link, "k", direction=(0, 0, 0))
    assert m == before
    joint = m.add_turning_joint(0, link, "k", point=("1/3", 0, 0), direction=(0, 1, 0))
    assert joint.axis.id == "k" and joint.axis.placed
    assert joint.axis.direction == (0, 1, 0)


def test_files_that_are_none():
    with pytest.raises(gg.Error) as caught:
        gg.open(EXAMPLES / "none.geargraph")
    assert caught.value.code == "file"
    with pytest.raises(gg.Error) as caught:
        gg.loads("{")
    assert caught.value.code == "syntax"
    assert caught.value.diagnostics[0].line == 1
    with pytest.raises(gg.Error) as caught:
        gg.loads('{"format": "geargraph", "version": 99}')
    assert caught.value.code == "version"


def test_all_edits_of_a_gearbox():
    m = gg.sets.planetary(24, 18)
    assert m.ground.label == 0 and m.link("sun").label == 1
    brake = m.add_brake(2)
    clutch = m.add_clutch(1, 3)
    m.add_state("low", [brake], drive=1, driven=3)
    m.add_state("high", [clutch])
    m.set_inputs(None)
    low, high = m.analyze().states
    assert (low.ratio, high.ratio) == (Fraction(7, 2), 1)
    assert low.dof == 1 and low.joint_speeds is not None
    m.engage_state("low")
    assert m.engaged == (brake.id,) and brake.engaged
    m.engage()
    assert m.engaged == ()
    m.remove_state("high")
    assert [state.name for state in m.states] == ["low"]
    with pytest.raises(gg.Error):
        m.engage_state("high")


def test_edits_of_geometry():
    m = built_robot()
    m.set_limits(11, -20, None)
    assert m.joint(11).limits == (-20, None)
    m.set_offset(11, "1/2")
    assert m.joint(11).offset == Fraction(1, 2)
    m.set_axis("a", point=(0, -60, 0), direction=(0, 0, 1))
    assert m.axis("a").point == (0, -60, 0)
    m.set_pitch_point(15, None)
    m.flip(m.mesh(15))
    assert m.mesh(15).teeth == (36, 18)
    n, mesh = len(m.links), m.mesh(16)
    part = m.split_link(2, mesh)  # labels of meshes move on by two
    assert len(m.links) == n + 1 and part.id in (mesh.tail.id, mesh.head.id)
    assert m.merge_links(2, part).label == 2 and len(m.links) == n and mesh.label == 16
    with pytest.raises(gg.Error) as weld:
        m.merge_links(3, 3)
    assert weld.value.code == "self-joint"
    m.rename(m.link(1), "arm")
    m.rename(m.axis("e"), "f")
    assert m.link("arm").label == 1 and m.joint(14).axis.id == "f"
    m.set_joint_axis(10, "a")
    assert m.joint(10).axis.id == "a"
    m.name, m.notes, m.unit = "other", "notes", "in"
    assert (m.name, m.notes, m.unit) == ("other", "notes", "in")


def test_stated_members_are_told():
    m = gg.Mechanism.from_text(spur_pair().to_text())
    pinion = m.link("pinion")
    assert (pinion.mass, pinion.center_of_mass, pinion.inertia, pinion.shapes) == (None, None, None, ())
    m.set_mass(pinion, "1/3", center=(0, 0.5, 2), inertia=(1, 1, 1, 0, 0, 0))
    assert pinion.mass == Fraction(1, 3)
    assert pinion.center_of_mass == (0, Fraction(1, 2), 2)
    assert pinion.inertia == (1, 1, 1, 0, 0, 0)
    mesh = m.meshes[0]
    assert (mesh.tail_teeth, mesh.head_teeth) == (18, 36)
    assert (mesh.face_width, mesh.tail_wheel, mesh.pinned) == (None, None, False)
    brake = m.add_brake(m.link("wheel"))
    assert brake.link == m.link("wheel")
    clutch = m.add_clutch(pinion, m.link("wheel"))
    assert clutch.link is None and len(clutch.links) == 2


def test_teeth_are_fitted():
    m = gg.sets.planetary(24, 18)
    sun_planet, planet_ring = m.meshes[0], m.meshes[1]
    m.pin(m.link("sun"))
    m.set_teeth(sun_planet, (24, 21), fit=True)
    assert planet_ring.teeth in ((21, 66), (66, 21))


def test_sets_and_planets_and_insertion():
    m = gg.sets.planetary(24, 18, planets=1)
    m.add_planets(4, 3)
    assert m.n == 6
    m.insert(gg.sets.reverted(20, 40, 20, 40))
    assert m.n == 9
    best = gg.sets.planetary_choices("7/2")[0]
    assert best.ratio == Fraction(7, 2) and best.ring == best.sun + 2 * best.planet
    assert gg.sets.reverted_choices(4)[0].ratio == 4
    for made in (gg.sets.bevel_differential(20, 10), gg.sets.bevel_wrist(), gg.sets.ravigneaux(), gg.sets.simpson()):
        assert made.analyze().ok, made
    with pytest.raises(gg.Error) as caught:
        gg.sets.bevel_differential(20, 10, 3)
    assert caught.value.code == "assembly"
    with pytest.raises(ValueError):
        gg.sets.planetary(0, 10)


def test_values_are_read_only(robot):
    a = robot.analyze()
    with pytest.raises(ValueError):
        a.incidence.to_numpy()[0, 0] = 7
    with pytest.raises(AttributeError):
        robot.links[0].label = 3
    speeds = a.joint_speeds
    robot.set_inputs({8: 3})
    assert a.joint_speeds == speeds
    assert robot.analyze() is not a


def test_sharing_and_the_torque_at_the_drive_are_part_of_the_document(robot):
    robot.set_sharing("stiffness")
    robot.set_drive_torque("25/2")
    document = json.loads(robot.to_text())
    assert document["sharing"] == "stiffness"
    assert document["driveTorque"] == "25/2"
    robot.set_sharing(None)
    robot.set_drive_torque(None)
    document = json.loads(robot.to_text())
    assert "sharing" not in document and "driveTorque" not in document
    with pytest.raises(ValueError, match="stiffness"):
        robot.set_sharing("equal")
    with pytest.raises(gg.Error):
        robot.set_drive_torque("1e30")
