"""What the tests share: the examples, and the paper's robot."""

import os
from pathlib import Path

import geargraph as gg
import pytest

SOURCE = Path(os.environ["GEARGRAPH_SOURCE"])
CLI = os.environ["GEARGRAPH_CLI"]
EXAMPLES = SOURCE / "resources" / "examples"


@pytest.fixture
def robot() -> gg.Mechanism:
    return gg.open(EXAMPLES / "robot.geargraph")


def built_robot() -> gg.Mechanism:
    """The paper's robot, made by the edits."""
    m = gg.Mechanism("robot")
    names = ("carrier 1", "carrier 2", "end-effector", "sun 1", "sun 2", "sun 3", "planets")
    c1, c2, tool, s1, s2, s3, planets = [m.add_link(name) for name in names]
    z, y = (0, 0, 1), (0, 1, 0)
    m.add_turning_joint(m.ground, s1, "a", point=(0, -54, 0), direction=z)
    m.add_turning_joint(m.ground, s2, "b", point=(0, 0, 0), direction=z)
    m.add_turning_joint(m.ground, c1, "b", offset=30, limits=(-170, 170))
    m.add_turning_joint(c1, s3, "c", point=(0, 0, 60), direction=y, offset=40)
    m.add_turning_joint(c1, c2, "c", offset=-40, limits=(-110, 110))
    m.add_turning_joint(c2, planets, "d", point=(0, 0, 96), direction=z)
    m.add_turning_joint(c2, tool, "e", point=(0, 0, 132), direction=y, offset=-40)
    m.add_mesh(s1, c1, (18, 36), kind="external", pitch_point=(0, -36, 0))
    m.add_mesh(s2, c2, (20, 30), kind="bevel", pitch_point=(0, -20, 30))
    m.add_mesh(s3, planets, (24, 18), kind="bevel", pitch_point=(0, 18, 84))
    m.add_mesh(planets, tool, (16, 24), kind="bevel", pitch_point=(0, 16, 108))
    m.set_inputs({8: 1, 9: "1/2", 11: 0})
    return m
