"""Whatever a method is given, it answers or raises: the process never ends, and rejected edits change nothing."""

import inspect
import random

import geargraph as gg
import pytest
from conftest import EXAMPLES

REFUSALS = (gg.Error, TypeError, ValueError, KeyError, IndexError, AttributeError)
EDITS = sorted(
    name for name in vars(gg.Mechanism).keys() | {n for base in gg.Mechanism.__mro__ for n in vars(base)}
    if name.split("_")[0] in {"add", "set", "remove", "attach", "flip", "rename", "pin", "engage", "insert"}
)
QUESTIONS = ("matrix", "pose", "input_sets", "statics", "drawing", "graph", "csv", "solids")


def bases():
    yield gg.Mechanism()
    loose = gg.Mechanism("loose")
    loose.add_link()
    loose.add_link()
    loose.add_mesh(1, 2)
    yield loose
    for name in ("robot", "ravigneaux", "locked-train", "cannot-be-assembled"):
        yield gg.open(EXAMPLES / f"{name}.geargraph")
    loaded = gg.sets.planetary(24, 18)
    loaded.add_torque(5, link=3)
    loaded.add_brake(2, "B")
    loaded.add_state("1", ["B"], drive=1, driven=3)
    yield loaded


def junk(rng, m):
    elements = [*m.links, *m.joints, *m.meshes, *m.axes, *m.couplings, *m.loads]
    return rng.choice(
        [
            None, 0, 1, -1, 2**40, 3.5, float("nan"), "", "1", "a", "B", "x" * 2000, "\0", (), (0, 0, 1), (1, "1/3", 0),
            (0, 0, 0), (17, 30), (0, 5), (10**6, 1), {"8": 1}, {}, [1, 2], "external", "22/7", "1e400", b"bytes",
            m, True, *rng.sample(elements, min(3, len(elements))),
        ]
    )


def arguments(rng, m, method):
    given, named = [], {}
    for parameter in inspect.signature(method).parameters.values():
        if parameter.default is not parameter.empty and rng.random() < 0.6:
            continue
        if parameter.kind is parameter.VAR_POSITIONAL:
            given += [junk(rng, m) for _ in range(rng.randrange(3))]
        elif parameter.kind is parameter.KEYWORD_ONLY:
            named[parameter.name] = junk(rng, m)
        elif parameter.kind is not parameter.VAR_KEYWORD and not named:
            if parameter.default is parameter.empty:
                given.append(junk(rng, m))
            else:
                named[parameter.name] = junk(rng, m)
    return given, named


@pytest.mark.parametrize("seed", range(6))
def test_edits(seed):
    rng = random.Random(seed)
    made = 0
    for base in bases():
        m = base
        for _ in range(150):
            method = getattr(m, rng.choice(EDITS))
            given, named = arguments(rng, m, method)
            before = m.to_text()
            try:
                method(*given, **named)
                made += 1
            except REFUSALS:
                assert m.to_text() == before, (method.__name__, given, named)
            else:
                assert gg.loads(m.to_text()) == m
            if m.n > 12:
                m = base.copy()
    assert made > 50


def test_questions():
    rng = random.Random(3)
    for m in bases():
        a = m.analyze()
        for _ in range(60):
            method = getattr(a, rng.choice(QUESTIONS))
            given, named = arguments(rng, m, method)
            try:
                method(*given, **named)
            except REFUSALS:
                pass
        for name in ("rank", "dof", "inputs", "diagnostics", "screws", "coefficients", "solution", "joint_speeds",
                     "link_velocities", "matroid", "tt_graph", "agree", "ratios", "states", "derivation", "gears"):
            try:
                getattr(a, name)
            except gg.Error as error:
                assert error.code
        repr(a), repr(m)


def test_pictures_reject_what_is_out_of_range(robot):
    a = robot.analyze()
    nan = float("nan")
    for wrong in (
        {"time": nan}, {"time": 1e300}, {"explode": 2}, {"explode": nan}, {"section": ("w", 0.5)}, {"section": ("x", nan)},
        {"camera": (nan, 0)}, {"camera": (0, 91)}, {"size": (10**9, 10)}, {"hide": ["none"]}, {"ride": 99},
    ):
        with pytest.raises((ValueError, gg.Error)):
            a.picture(**wrong)
    with pytest.raises(ValueError):
        a.film("film.png", fps=nan)
    with pytest.raises(ValueError):
        a.export("gear.glb", seconds=nan)
    for efficiency in (0, 2, -1):
        with pytest.raises(ValueError):
            a.statics(efficiency=efficiency)
