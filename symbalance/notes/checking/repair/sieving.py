"""Changes sieved in floats: the values a side should have at a few points, and what fits them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from symbalance.document import formula
from symbalance.document.formula import Formula
from symbalance.notes.algebra import values
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.forms import Form
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.steps import Answer
from symbalance.notes.checking.repair.floats import NoValueError, Sieve, Values, close


@dataclass(frozen=True)
class Case:
    """A refuted side: the formula, the answer that refuted it, and how a changed one is proved."""

    node: Formula
    answer: Answer
    knowledge: Knowledge
    proves: Callable[[Formula], bool]


def sieve_of(case: Case) -> tuple[list[Values], Sieve] | None:
    """Return the values the side should have at a few points, and a sieve for its changed copies."""
    answer, knowledge = case.answer, case.knowledge
    if answer.left is None or answer.right is None or answer.level is None:
        return None
    points = _points(case)
    if not points:
        return None
    count = 1 + len(answer.further)
    targets = [tuple(complex(found[n]) for _, found in points) for n in range(count)]
    letters = {name: [complex(f[k]) for _, f in points] for k, name in enumerate(letters_of(case), count)}
    sieve = Sieve(letters, len(points))
    evaluator = knowledge.evaluator(answer.level)
    for part in formula.walk(case.node):
        if isinstance(part, formula.Derivative):
            try:
                form = evaluator.form(part)
                sieve.tell(part, tuple(complex(values.value(form, p)) for p, _ in points))
            except (NoFormError, TooLargeError, KeyError):
                return None
    try:
        sieve.keep(case.node)
    except NoValueError:
        return None
    return targets, sieve


def letters_of(case: Case) -> list[str]:
    """Return the letters that stand in the side or may be put into it."""
    known = dict.fromkeys(sorted(formula.names(case.node)))
    extra = [n for n in sorted(case.knowledge.letters) if n not in known][:30]
    return [
        *known,
        *extra,
        *[n for n in sorted(case.knowledge.definitions) if n not in known and n not in extra][:20],
    ]


def _points(case: Case) -> list[tuple[values.Point, list[Any]]]:
    assert case.answer.left is not None
    assert case.answer.level is not None
    evaluator = case.knowledge.evaluator(case.answer.level)
    evaluator.domain = case.answer.left.domain
    forms: list[Form] = [case.answer.left, *case.answer.further]
    for name in letters_of(case):
        try:
            forms.append(evaluator.letter(name))
        except (NoFormError, TooLargeError):
            forms.append(Form.number(case.answer.left.domain, 1))
    found = values.sample(forms)
    if found:
        return found
    count = 1 + len(case.answer.further)  # some letter has no value: leave it out
    one = Form.number(case.answer.left.domain, 1)
    usable = [f if values.sample([case.answer.left, f]) else one for f in forms[count:]]
    return values.sample([*forms[:count], *usable])


def fits(node: Formula, sieve: Sieve, targets: list[Values]) -> bool:
    """Tell whether a changed side has one of the rows of values it may have."""
    try:
        found = sieve.values(node)
        return any(close(found, target) for target in targets)
    except NoValueError:
        return False
