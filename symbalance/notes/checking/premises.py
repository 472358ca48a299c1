"""Premises as a system: equations taken as given, solved before anything is judged by them.

Each is brought to normal form with what is known, and solved for a letter in which it is linear; what
that letter equals is put into the others. An equation that comes down to 0 = 0 follows from the rest, one
that comes down to a number contradicts it. What is linear in no letter is left over, and only checked.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise

from symbalance.document.formula import Formula, Negative, Number, Quotient, Sum, names
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.domain import Domain, Monomial, NoFormError, Polynomial, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.harmonics import polynomial_node
from symbalance.notes.algebra.tree_values import letters_behind
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.rounding import decimals

MOST = 24
"""Premises of one system: those nearest before a relation, if there are more."""
EVERYWHERE = 10**9
"""The last line of a premise that holds to the end of the document."""
LARGEST_VALUE = 60
"""Terms of what a letter is solved to; a longer one would make every later form large."""


@dataclass(frozen=True, slots=True)
class Premise:
    """An equation that a line takes as given."""

    left: Formula
    right: Formula
    line: int
    last_line: int = EVERYWHERE
    fixes: str = ""
    """The letter whose value it is, where it was solved for one that was new."""

    @property
    def text(self) -> str:
        """The equation as it is written."""
        return " = ".join(formula_text(node, plain=True) for node in (self.left, self.right))

    @property
    def names(self) -> frozenset[str]:
        """The letters that stand in it."""
        return names(self.left) | names(self.right)


@dataclass(frozen=True)
class Elimination:
    """What premises come down to: letters with values, equations left over, and what cannot be."""

    values: Mapping[str, Formula]
    leftover: tuple[Premise, ...]
    contradiction: tuple[Premise, ...]
    following: tuple[Premise, ...]
    """The premises that follow from those before them."""

    @property
    def is_consistent(self) -> bool:
        """Tell whether nothing contradictory came up."""
        return not self.contradiction


def related(premises: Iterable[Premise], nodes: Sequence[Formula], knowledge: Knowledge) -> list[Premise]:
    """Return the premises that formulas are connected with by their letters, also through others.

    What only holds to the digits printed is left out: elimination is exact.
    """
    values = _known_values(knowledge)

    def reach(*parts: Formula) -> set[str]:
        return {name for part in parts for name in letters_behind(part, values)}

    waiting = [p for p in premises if not decimals(p.left) and not decimals(p.right)][-MOST:]
    reached = reach(*nodes)
    chosen: list[Premise] = []
    while True:
        near = [p for p in waiting if reach(p.left, p.right) & reached]
        if not near:
            return _without_private(sorted(chosen, key=lambda p: p.line), nodes, knowledge)
        chosen += near
        waiting = [p for p in waiting if p not in near]
        reached |= {name for p in near for name in reach(p.left, p.right)}


def _without_private(
    premises: list[Premise], nodes: Sequence[Formula], knowledge: Knowledge
) -> list[Premise]:
    """Leave out what fixes a letter that stands nowhere else: R² = a² + b² says nothing of a and b."""
    solved_letters = {name for name, d in knowledge.definitions.items() if d.solved}
    while True:
        used = [p.names for p in premises] + [names(node) for node in nodes]
        private = [
            p for p in premises if p.fixes in solved_letters and sum(p.fixes in own for own in used) == 1
        ]
        if not private:
            return premises
        premises = [p for p in premises if p not in private]


def _known_values(knowledge: Knowledge) -> dict[str, Formula]:
    """Return what the letters stand for at most; what is printed in decimals stays a letter."""
    defined = {
        name: d.node for name, d in knowledge.definitions.items() if not d.solved and not decimals(d.node)
    }
    return {**defined, **knowledge.meaning.values}


def eliminate(premises: Sequence[Premise], knowledge: Knowledge) -> Elimination:
    """Solve premises for letters, one after the other; those in contradiction are as few as suffice."""
    result = _eliminate(premises, knowledge)
    if result.is_consistent:
        return result
    core = list(result.contradiction)
    for premise in list(core):
        fewer = [p for p in core if p is not premise]
        if not _eliminate(fewer, knowledge).is_consistent:
            core = fewer
    return replace(result, contradiction=tuple(core))


def _eliminate(premises: Sequence[Premise], knowledge: Knowledge) -> Elimination:
    base, solved = _known_values(knowledge), dict[str, Formula]()
    waiting, following = list(premises), list[Premise]()
    used: list[Premise] = []
    while waiting:
        before = len(waiting)
        for premise in list(waiting):
            outcome = _reduce(premise, {**base, **solved}, knowledge)
            if outcome is None:
                continue
            form, solution = outcome
            if form.is_zero():
                following.append(premise)
            elif _is_for_all_angles(premise, form, knowledge) or not letters(form):
                return Elimination(solved, (), (*used, premise), tuple(following))
            elif solution is None:
                continue
            else:
                solved[solution[0]] = solution[1]
                used.append(premise)
            waiting.remove(premise)
        if len(waiting) == before:
            break
    return Elimination(solved, tuple(waiting), (), tuple(following))


def _is_for_all_angles(premise: Premise, form: Form, knowledge: Knowledge) -> bool:
    """Tell whether a premise on other letters comes down to one on angles alone, which are free."""
    return set(letters(form)) <= knowledge.angles and not premise.names <= knowledge.angles


def _reduce(
    premise: Premise, values: Mapping[str, Formula], knowledge: Knowledge
) -> tuple[Form, tuple[str, Formula] | None] | None:
    """Return left - right in normal form, and what it says of a letter; None where it has none."""
    meaning = replace(knowledge.meaning, values=values)
    evaluator = FormEvaluator(meaning.domain(), meaning)
    try:
        form = evaluator.form(Sum((premise.left, Negative(premise.right))))
        return form, _solve_linearly(form.domain, form.numerator, knowledge)
    except (NoFormError, TooLargeError):
        return None


def _solve_linearly(
    domain: Domain, polynomial: Polynomial, knowledge: Knowledge
) -> tuple[str, Formula] | None:
    """Return the letter in which polynomial = 0 is linear, by the simplest coefficient, and its value."""
    best: tuple[tuple[bool, int], int, Polynomial, Polynomial] | None = None
    inside = _inner_generators(domain, polynomial)
    for number in {g for monomial in polynomial for g, _ in monomial}:
        generator = domain.generators[number]
        if generator.kind != "symbol" or number in inside or generator.content in knowledge.universal:
            continue
        parts = _by_powers(polynomial, number)
        powers = sorted(parts)
        if len(powers) == 1 and not any(m for m in parts[powers[0]]):
            return generator.content, Number(Fraction(0))  # 3 w = 0
        if len(powers) != 2 or any(b - a != 1 for a, b in pairwise(powers)):
            continue
        below, above = parts[powers[1]], parts[powers[0]]
        if len(above) > LARGEST_VALUE:
            continue
        rank = (any(m for m in below), len(below) + len(above))
        if best is None or rank < best[0]:
            best = (rank, number, above, below)
    if best is None:
        return None
    _, number, above, below = best
    value = Negative(polynomial_node(domain, above))
    return domain.generators[number].content, Quotient(value, polynomial_node(domain, below))


def _by_powers(polynomial: Polynomial, number: int) -> dict[Fraction | int, Polynomial]:
    parts: dict[Fraction | int, Polynomial] = {}
    for monomial, coefficient in polynomial.items():
        power = dict(monomial).get(number, 0)
        rest: Monomial = tuple(entry for entry in monomial if entry[0] != number)
        parts.setdefault(power, {})[rest] = coefficient
    return parts


def _inner_generators(domain: Domain, polynomial: Polynomial) -> set[int]:
    """Return the generators that stand inside angles, roots and functions."""
    inside: set[int] = set()
    waiting = [g for monomial in polynomial for g, _ in monomial]
    entered: set[int] = set()
    while waiting:
        number = waiting.pop()
        if number in entered:
            continue
        entered.add(number)
        kind, content = domain.generators[number].kind, domain.generators[number].content
        monomials: list[Monomial] = []
        if kind in ("exponential", "growth"):
            monomials = [content]
        elif kind == "radical":
            monomials = list(content)
        elif kind == "opaque":
            monomials = [*content[1].numerator, *content[1].denominator]
        inner = {g for monomial in monomials for g, _ in monomial}
        inside |= inner
        waiting += inner
    return inside
