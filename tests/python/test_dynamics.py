"""Masses, the equation of motion and simulated motion."""

import json
import math
import subprocess
import xml.etree.ElementTree as xml

import geargraph as gg
import numpy as np
import pytest

from conftest import CLI, EXAMPLES


def cli(*words):
    return json.loads(subprocess.run([CLI, *words, "--json"], check=True, capture_output=True).stdout)


def test_numbers_are_those_of_the_command_line(robot):
    robot.set_gravity((0, 0, "-9.81"))
    dynamics = robot.analyze().dynamics
    said = cli("dynamics", str(EXAMPLES / "robot.geargraph"), "--gravity", "0,0,-9.81", "--torque", "8=1/2Nm")
    equation = dynamics.equation()
    assert list(dynamics.inputs) == said["inputs"]
    assert np.allclose(equation.inertia, said["inertia"], rtol=1e-12, atol=0)
    assert np.allclose(equation.bias, said["bias"], rtol=1e-9, atol=1e-12)
    assert dynamics.gravity == (0, 0, -9.81)
    for link in dynamics.links:
        row = said["links"][str(link.link)]
        assert link.source == row["source"]
        assert math.isclose(link.mass, row["mass"], rel_tol=1e-12)
        assert np.allclose(equation.reflected[link.link], row["reflected"], rtol=1e-12)
    assert np.allclose(dynamics.accelerations({8: 0.5}), said["accelerations"], rtol=1e-9)


def test_inertia_reflected_at_motors_adds_up(robot):
    equation = robot.analyze().dynamics.equation({8: 0.3, 9: -1, 11: 2})
    assert np.allclose(equation.reflected.sum(axis=0), np.diag(equation.inertia), rtol=1e-12)
    assert np.allclose(equation.inertia, equation.inertia.T, rtol=0, atol=1e-18)


def test_a_motion_keeps_its_energy(robot):
    robot.set_gravity((0, 0, -9.81))
    motion = robot.analyze().dynamics.simulate(0.2, {8: 0.05, 9: -0.02}, damping={8: 0.001}, interval=0.01)
    assert motion.end == "complete" and motion.limit_joint is None and len(motion) == 21
    frame = motion.to_pandas()
    energy = frame["kinetic"] + frame["potential"] - frame["work"]
    assert np.ptp(energy) < 1e-8 * max(1, frame["kinetic"].max())
    assert frame["kinetic"].iloc[-1] > 1e-6
    assert frame.index[-1] == pytest.approx(0.2)


def test_a_motion_ends_at_a_limit(robot):
    motion = robot.analyze().dynamics.simulate(60, {8: 1})
    assert motion.end == "limit" and motion.limit_joint in (10, 12)


def test_stated_masses_count():
    m = gg.open(EXAMPLES / "spur-pair.geargraph")
    before = m.analyze().dynamics.equation().inertia[0, 0]
    m.set_mass(1, 2, inertia=(1, 1, "1/2", 0, 0, 0))
    stated = m.analyze().dynamics
    assert stated.links[0].source == "stated" and stated.links[0].mass == 2
    assert stated.equation().inertia[0, 0] > before + 0.1
    m.set_mass(1, None)
    assert m.analyze().dynamics.equation().inertia[0, 0] == before
    m.set_density(15700)
    assert m.analyze().dynamics.equation().inertia[0, 0] == pytest.approx(2 * before)


def test_what_is_wrong_is_rejected(robot):
    dynamics = robot.analyze().dynamics
    for call in (
        lambda: dynamics.equation({10: 1}),
        lambda: dynamics.equation({8: math.nan}),
        lambda: dynamics.simulate(0),
        lambda: dynamics.simulate(1, damping={8: -1}),
        lambda: dynamics.simulate(1e6, interval=1e-6),
        lambda: robot.set_mass(1, 1, inertia=(1, 2)),
    ):
        with pytest.raises(ValueError):
            call()
    text = robot.to_text()
    with pytest.raises(gg.Error) as refused:
        robot.set_mass(1, 1, inertia=(1, 1, 9, 0, 0, 0))
    assert refused.value.code == "schema" and robot.to_text() == text
    with pytest.raises(gg.Error):
        robot.set_density(0)
    robot.unit = "furlong"
    with pytest.raises(gg.Error) as unknown:
        robot.analyze().dynamics
    assert unknown.value.code == "unknown-unit"
    with pytest.raises(gg.Error):
        gg.open(EXAMPLES / "robot-to-mend.geargraph").analyze().dynamics


def test_models_for_simulators(robot, tmp_path):
    a = robot.analyze()
    a.export_model(tmp_path / "mjcf", name="robot", motor="torque")
    said = tmp_path / "said"
    subprocess.run(
        [CLI, "export", EXAMPLES / "robot.geargraph", "--to", "mjcf", "--motor", "torque", "-o", said], check=True
    )
    assert (tmp_path / "mjcf" / "robot.xml").read_bytes() == (said / "robot.xml").read_bytes()
    meshes = sorted(path.name for path in (tmp_path / "mjcf" / "meshes").iterdir())
    assert meshes == sorted(path.name for path in (said / "meshes").iterdir()) and meshes
    with pytest.raises(gg.Error) as there:
        a.export_model(tmp_path / "mjcf", name="robot")
    assert there.value.code == "file"
    a.export_model(tmp_path / "mjcf", name="robot", overwrite=True)
    with pytest.raises(gg.Error) as several:
        a.export_model(tmp_path / "urdf", "urdf")
    assert several.value.code == "undefined" and "can follow one other joint" in str(several.value)
    assert not (tmp_path / "urdf").exists()
    gg.open(EXAMPLES / "three-planets.geargraph").analyze().export_model(tmp_path / "urdf", "urdf", name="train")
    assert xml.parse(tmp_path / "urdf" / "train.urdf").getroot().tag == "robot"
    for wrong in ({"form": "sdf"}, {"motor": "steam"}, {"timestep": 0}, {"armature": -1}, {"tolerance": 1}, {"name": "a/b"}):
        with pytest.raises(ValueError):
            a.export_model(tmp_path / "wrong", **wrong)
