"""Gearboxes and hub gears from ratios, and the atlas."""

import json
import subprocess
from fractions import Fraction

import geargraph as gg
import pytest

from conftest import CLI, SOURCE

FILES = SOURCE / "tests" / "golden" / "files"
GEARBOX = json.loads((FILES / "gearbox.wish.json").read_text())
HUB = json.loads((FILES / "hardware.wish.json").read_text())


def printed(*words):
    run = subprocess.run([CLI, *map(str, words)], capture_output=True, check=True, text=True)
    return json.loads(run.stdout)


def test_gearboxes_are_those_of_the_command_line():
    found = gg.gearbox(GEARBOX, limit=2)
    alone = printed("gearbox", FILES / "gearbox.wish.json", "--json", "--limit", 2)
    assert [each.data for each in found.gearboxes] == alone["gearboxes"]
    assert (found.complete, found.layouts, found.count) == (False, alone["layouts"], alone["count"])


def test_a_gearbox_is_a_document_with_its_ratios():
    first = gg.gearbox(GEARBOX, limit=1).gearboxes[0]
    states = first.mechanism.analyze().states
    assert {state.name: state.ratio for state in states} == first.ratios
    assert all(first.engaged[state.name] for state in states)


def test_hubs():
    found = gg.hardware(HUB)
    assert found.complete and found.count == len(found.candidates) == 3
    assert found.shared["1.ring"] == 72
    assert found.decide["of"] == "2.sun2" and found.decide["leaves"] == 1
    first = found.candidates[0]
    assert first.ratios[0] == Fraction(12, 19)
    states = first.mechanism.analyze().states
    assert [1 / state.ratio for state in states] == list(first.ratios)


def test_wrong_wishes_are_rejected():
    with pytest.raises(gg.Error) as error:
        gg.gearbox({"forward": ["3", "0"], "sets": ["simple"], "links": 4})
    assert error.value.code == "schema" and error.value.diagnostics[0].pointer == "/forward/1"
    with pytest.raises(gg.Error) as error:
        gg.hardware({"ratios": ["4/0"]})
    assert error.value.diagnostics[0].pointer == "/ratios/0"
    with pytest.raises(ValueError):
        gg.gearbox(GEARBOX, limit=-1)


def test_atlas():
    assert [len(gg.atlas(links=links)) for links in (3, 4, 5, 6, 7)] == [1, 3, 13, 81, 647]
    chain = gg.atlas(links=4)[1]
    assert chain.number == "4-1.1.2" and len(chain.meshes) == 2
    assert chain.mechanism().identify().chains[0].displacement == chain.number
    locked = gg.atlas(links=4, dof=0)[0]
    assert locked.number == "4-0.1.1" and locked.mechanism().identify().chains[0].locked
    with pytest.raises(gg.Error):
        gg.atlas_document("9-1.1.1")


def test_identity():
    identity = gg.sets.planetary(24, 18, planets=3).identify()
    assert list(identity.removed.values()).count("copy") == 2
    assert [chain.displacement for chain in identity.chains] == ["4-1.1.1"]
    assert identity.chains[0].dof == 1 and not identity.chains[0].locked
