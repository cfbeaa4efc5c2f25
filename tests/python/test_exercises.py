"""Exercise sheets and their grading."""

import json
import subprocess

import geargraph as gg
import pytest

from conftest import CLI, EXAMPLES


def solutions(sheet, variant):
    """The answers that the sheet itself gives."""
    asked = sheet.questions(variant, solved=True)
    return {
        number: dict(zip((field["name"] for field in question["fields"]), question["solution"]))
        for number, question in enumerate(asked, 1)
    }


def test_every_solution_is_right(robot):
    sheet = gg.exercises.Sheet(robot, seed=5, variants=3, title="Robot")
    assert (sheet.title, sheet.seed, sheet.variants) == ("Robot", 5, 3)
    for variant in (1, 3):
        grades = sheet.grade(variant, solutions(sheet, variant))
        assert len(grades) == len(sheet.questions(variant)) > 10
        assert all(grade.right and grade.points == grade.of for grade in grades)


def test_wrong_answers_get_a_reason(robot):
    sheet = gg.exercises.Sheet(robot, ["cycle-basis", "teeth"], seed=5)
    answers = solutions(sheet, 1)
    answers[1]["C16,9"] = -int(answers[1]["C16,9"])
    del answers[2]
    wrong, blank = sheet.grade(1, answers)
    assert not wrong.right and wrong.points < wrong.of and wrong.reason and wrong.fields == ("C16,9",)
    assert not blank.right and blank.points == 0


def test_sheets_are_those_of_the_command_line(robot, tmp_path):
    words = ["exercises", "make", EXAMPLES / "robot.geargraph", "--seed", "9", "--variants", "2", "--to", "json"]
    subprocess.run([CLI, *words, "-o", tmp_path / "class"], check=True, capture_output=True)
    text = (tmp_path / "class" / "sheet.json").read_text()
    sheet = gg.exercises.Sheet.from_text(text)
    assert sheet.to_text() == text and sheet.variants == 2
    own = gg.exercises.Sheet(robot, seed=9, variants=2, title=sheet.title)
    assert own.mark == sheet.mark
    printed = json.loads((tmp_path / "class" / "sheet-2.json").read_text())["questions"]
    assert sheet.questions(2) == printed and own.questions(2) == printed
    handed = gg.exercises.read_answers((tmp_path / "class" / "answers-2.json").read_text())
    assert handed.sheet == sheet.mark and handed.variant == 2
    assert not any(grade.right for grade in sheet.grade(handed.variant, handed.answers))


def test_kinds_tell_why_they_are_not_given(robot):
    offered = gg.exercises.kinds(robot)
    assert len(offered) == 27 and len({kind.name for kind in offered}) == 27
    missing = next(kind for kind in offered if kind.reason)
    with pytest.raises(ValueError, match="gives no question"):
        gg.exercises.Sheet(robot, [missing.name])


def test_what_is_wrong_is_rejected(robot):
    sheet = gg.exercises.Sheet(robot, ["cycle"])
    for call in (
        lambda: gg.exercises.Sheet(robot, ["no such kind"]),
        lambda: gg.exercises.Sheet(robot, []),
        lambda: gg.exercises.Sheet(robot, variants=0),
        lambda: gg.exercises.Sheet(robot, seed=-1),
        lambda: sheet.questions(2),
        lambda: sheet.grade(0, {}),
    ):
        with pytest.raises(ValueError):
            call()
    for read in (gg.exercises.Sheet.from_text, gg.exercises.read_answers):
        with pytest.raises(gg.Error) as broken:
            read("{")
        assert broken.value.code == "syntax"
