"""Teeth for wanted ratios."""

import json
import subprocess
from fractions import Fraction

import geargraph as gg
import pytest

from conftest import CLI, SOURCE

FILES = SOURCE / "tests" / "golden" / "files"
WISH = json.loads((FILES / "two-ring-wish.json").read_text())


@pytest.fixture
def reducer() -> gg.Mechanism:
    return gg.open(FILES / "two-ring.geargraph")


def test_counts_and_choices(reducer):
    found = reducer.teeth(WISH)
    assert found.complete and found.tried == 38997
    assert found.filters == {"turns": 37919, "clears": 30372, "assembles": 10112}
    assert found.count == len(found.choices) == 12 and found.nearest is None
    best = found.choices[0]
    assert best.ratios == (Fraction(64),) and best.error == 0
    assert (best.teeth[15], best.teeth[16], best.teeth[17]) == ((17, 34), (34, 85), (29, 80))
    assert best.planets == (3,) and best.undercut == ("15:tail",)
    assert best.efficiency == pytest.approx(0.699, abs=5e-4)
    assert best.efficiency_backward == pytest.approx(0.581, abs=5e-4)


def test_a_choice_is_one_edit(reducer):
    best = reducer.teeth(WISH, limit=1).choices[0]
    reducer.use_teeth(best)
    state = reducer.analyze().states[0]
    assert state.ratio == 64
    with pytest.raises(ValueError):
        gg.sets.planetary(24, 18).use_teeth(best)


def test_exact_wishes():
    train = gg.sets.planetary(24, 18, planets=1)
    ratio = {"drive": 1, "driven": 3, "held": [2], "ratio": Fraction(9, 2)}
    found = train.teeth({"ratios": [ratio], "most": 60, "planets": 3})
    assert found.count > 0
    assert all(choice.ratios == (Fraction(9, 2),) for choice in found.choices)


def test_wrong_wishes_are_rejected(reducer):
    with pytest.raises(gg.Error) as error:
        reducer.teeth({"ratios": [{"state": "1", "ratio": 0}]})
    assert error.value.code == "schema"
    assert error.value.diagnostics[0].pointer == "/ratios/0/ratio"


def test_certificates(reducer, tmp_path):
    text = reducer.teeth_certificate(WISH)
    checked = gg.check_teeth(text)
    assert checked.holds and not checked.faults
    assert (checked.tried, checked.count) == (38997, 12)
    wrong = gg.check_teeth(text.replace("38997", "38996"))
    assert not wrong.holds and wrong.faults
    path = tmp_path / "certificate.json"
    path.write_text(text)
    assert subprocess.run([CLI, "teeth", "--check", path], capture_output=True).returncode == 0
    with pytest.raises(gg.Error):
        gg.check_teeth("{}")
