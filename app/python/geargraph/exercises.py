"""Exercise sheets from a mechanism, a variant for each student, and the grading of answers.

    >>> sheet = gg.exercises.Sheet(m, variants=30, seed=2026)
    >>> sheet.questions(7)[0]["prompt"]
    >>> sheet.grade(7, {1: {"C16,8": "1"}})[0].reason
"""

from __future__ import annotations

import json
from operator import index
from random import SystemRandom
from typing import Any, Dict, Iterable, List, Mapping, NamedTuple, Optional, Tuple

from . import _geargraph
from ._mechanism import Mechanism

__all__ = ["Answers", "Grade", "Kind", "Sheet", "kinds", "read_answers"]


class Kind(NamedTuple):
    """A kind of question.

    Attributes
    ----------
    name : str
        "cycle-basis", as `Sheet` takes it.
    title : str
        What is asked.
    reason : str or None
        Why the mechanism does not give it; None if it does.
    """

    name: str
    title: str
    reason: Optional[str]


class Grade(NamedTuple):
    """What the grader tells about the answer to one question.

    Attributes
    ----------
    kind : str
        Of the question.
    points, of : int
        Points given, of those that there are.
    right : bool
        Is the answer right?
    mistake : str or None
        Name of the mistake that explains a wrong answer.
    fields : tuple of str
        The fields that are marked; none where the answer as a whole is.
    reason : str
        Why it is wrong.
    """

    kind: str
    points: int
    of: int
    right: bool
    mistake: Optional[str]
    fields: Tuple[str, ...]
    reason: str


class Answers(NamedTuple):
    """What a learner handed in.

    Attributes
    ----------
    sheet : str
        The mark of the sheet that was answered, `Sheet.mark`.
    variant : int
        Of the sheet.
    student : str
        As written by them.
    answers : dict
        By number of the question, from 1: texts by field.
    """

    sheet: str
    variant: int
    student: str
    answers: Dict[int, Dict[str, str]]


class Sheet:
    """A sheet of exercises with its variants; immutable.

    The same mechanism, kinds, seed and variant give the same questions everywhere.

    Parameters
    ----------
    mechanism : Mechanism
        At most 60 moving links.
    kinds : iterable of str, optional
        Names of kinds, which may occur again, at most 100; else all that the mechanism gives.
    seed : int, optional
        0 to 2**64 - 1; without it a random one, which ``seed`` tells.
    variants : int, optional
        1 to 1,000.
    title : str, optional
        Of the sheet.

    Raises
    ------
    Error
        "limit" for a larger mechanism.
    ValueError
        For a kind that the mechanism does not give, with the reason, or a number out of its range.
    """

    def __init__(
        self,
        mechanism: Mechanism,
        kinds: Optional[Iterable[str]] = None,
        *,
        seed: Optional[int] = None,
        variants: int = 1,
        title: str = "",
    ) -> None:
        seed = SystemRandom().randrange(2**31) if seed is None else index(seed)
        variants = index(variants)
        if not 0 <= seed < 2**64 or not 1 <= variants <= 1000:
            raise ValueError("a seed is 0 to 2**64 - 1, and a sheet has 1 to 1,000 variants")
        names = None if kinds is None else list(kinds)
        self._sheet = _geargraph.ExerciseSheet(mechanism._document, names, seed, variants, title)

    @classmethod
    def from_text(cls, text: str) -> Sheet:
        """Read a sheet from its file, ``sheet.json``.

        Parameters
        ----------
        text : str
            As `to_text` and ``geargraph-cli exercises make`` write it.

        Returns
        -------
        Sheet
            With the same questions.

        Raises
        ------
        Error
            "syntax", "format", "version", "schema".
        """
        sheet = cls.__new__(cls)
        sheet._sheet = _geargraph.ExerciseSheet.read(text)
        return sheet

    def to_text(self) -> str:
        """Write the sheet as a file, from which all variants and their keys can be made again.

        Returns
        -------
        str
            JSON.
        """
        return self._sheet.text()

    def __repr__(self) -> str:
        return f"<Sheet {self.title!r}: {self.variants} variants, seed {self.seed}>"

    @property
    def title(self) -> str:
        """The title."""
        return self._sheet.title()

    @property
    def seed(self) -> int:
        """The seed."""
        return self._sheet.seed()

    @property
    def variants(self) -> int:
        """How many variants there are."""
        return self._sheet.variants()

    @property
    def mark(self) -> str:
        """16 hexadecimal digits by which answers name the sheet."""
        return self._sheet.mark()

    def questions(self, variant: int = 1, *, solved: bool = False) -> List[Dict[str, Any]]:
        """Give the questions of a variant.

        Parameters
        ----------
        variant : int, optional
            From 1.
        solved : bool, optional
            With solution, what is accepted, and known mistakes.

        Returns
        -------
        list of dict
            As ``exercises.schema.json`` describes them.

        Raises
        ------
        ValueError
            If there is no such variant.
        """
        asked: List[Dict[str, Any]] = json.loads(self._sheet.questions(variant, solved))["questions"]
        return asked

    def grade(
        self, variant: int, answers: Mapping[int, Mapping[str, object]]
    ) -> Tuple[Grade, ...]:
        """Grade the answers to a variant.

        Parameters
        ----------
        variant : int
            From 1.
        answers : mapping
            By number of the question, from 1: texts or numbers by the names of its fields. What is
            left out is not answered.

        Returns
        -------
        tuple of Grade
            A grade for each question.

        Raises
        ------
        ValueError
            If there is no such variant.
        """
        texts = {
            index(number): {name: str(value) for name, value in fields.items()}
            for number, fields in answers.items()
        }
        return tuple(
            Grade(kind, points, of, right, mistake, tuple(fields), reason)
            for kind, points, of, right, mistake, fields, reason in self._sheet.graded(variant, texts)
        )


def kinds(mechanism: Mechanism) -> Tuple[Kind, ...]:
    """List the kinds of questions.

    Parameters
    ----------
    mechanism : Mechanism
        At most 60 moving links.

    Returns
    -------
    tuple of Kind
        All kinds, each with the reason where the mechanism does not give it.

    Raises
    ------
    Error
        "limit" for a larger mechanism.
    """
    return tuple(Kind(*row) for row in _geargraph.exercise_kinds(mechanism._document))


def read_answers(text: str) -> Answers:
    """Read a file of answers.

    Parameters
    ----------
    text : str
        JSON, as ``geargraph-cli exercises make`` writes a form for it.

    Returns
    -------
    Answers
        What was handed in.

    Raises
    ------
    Error
        "syntax", "format", "version", "schema".
    """
    return Answers(*_geargraph.exercise_answers(text))
