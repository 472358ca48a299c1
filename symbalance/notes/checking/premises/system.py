"""Premises as a system: equations taken as given, solved before anything is judged by them.

Each is brought to normal form with what is known, and solved for a letter in which it is linear; what
that letter equals is put into the others. An equation that comes down to 0 = 0 follows from the rest, one
that comes down to a number contradicts it, unless the decimals it rests on explain the number, each off
by half a unit of its last place. What is linear in no letter is left over: a Gröbner basis tells whether
it can be true with the rest, and what follows from it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise
from typing import Any

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Quotient,
    Sum,
    names,
)
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.domain import Domain, Monomial, NoFormError, Polynomial, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.harmonics import components, polynomial_node
from symbalance.notes.algebra.ideals import cannot_hold, follows
from symbalance.notes.algebra.letters_behind import letters_behind, names_behind
from symbalance.notes.algebra.values import Valuation, letters
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.deciding.substitution import replace_part
from symbalance.notes.checking.words.plain_formulas import plain_text

_ZERO = Number(Fraction(0))
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
    vanishing: tuple[str, ...] = ()
    """Letters that can only be 0: a² = 2a²."""
    nonzero: tuple[str, ...] = ()
    """Letters that an equation was divided by: w x = w y gives x = y where w ≠ 0."""
    residue: Form | None = None
    """What the last premise in contradiction comes down to, which should be zero."""

    @property
    def is_consistent(self) -> bool:
        """Tell whether nothing contradictory came up."""
        return not self.contradiction


def related(
    premises: Iterable[Premise],
    nodes: Sequence[Formula],
    knowledge: Knowledge,
    *,
    rounded: bool = False,
) -> list[Premise]:
    """Return the premises that formulas are connected with by their letters, also through others.

    What only holds to the digits printed is left out unless `rounded`: elimination is exact.
    """
    values = _known_values(knowledge, rounded=rounded)

    def reach(*parts: Formula) -> set[str]:
        return {name for part in parts for name in letters_behind(part, values)}

    waiting = [p for p in premises if rounded or not has_decimals(p)][-MOST:]
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


def has_decimals(premise: Premise) -> bool:
    """Tell whether a premise only holds to the digits printed."""
    return bool(decimals(premise.left) or decimals(premise.right))


def _known_values(knowledge: Knowledge, *, rounded: bool = False) -> dict[str, Formula]:
    """Return what letters stand for at most; what is printed in decimals stays one unless `rounded`."""
    defined = {
        name: d.node
        for name, d in knowledge.definitions.items()
        if not d.solved
        and (rounded or not decimals(d.node))
        and not (d.numeric and name in knowledge.angles)  # an angle at which something was looked at
    }
    return {**defined, **knowledge.meaning.values}


def eliminate(premises: Sequence[Premise], knowledge: Knowledge, *, rounded: bool = False) -> Elimination:
    """Solve premises for letters, one after the other; those in contradiction are as few as suffice.

    With `rounded`, decimals are taken in as they stand, and what they bring is no contradiction.
    """
    base = _known_values(knowledge, rounded=rounded)
    result = _eliminate(premises, knowledge, base)
    if result.is_consistent and result.leftover and _cannot_hold(premises, knowledge, base):
        result = replace(result, contradiction=tuple(premises))
    if result.is_consistent:
        return result

    def is_contradictory(some: Sequence[Premise]) -> bool:
        part = _eliminate(some, knowledge, base)
        return not part.is_consistent or (bool(part.leftover) and _cannot_hold(some, knowledge, base))

    core = list(result.contradiction)
    for premise in list(core):
        fewer = [p for p in core if p is not premise]
        if is_contradictory(fewer):
            core = fewer
    if rounded and _is_of_rounding(core, knowledge, base):
        return replace(result, contradiction=())
    return replace(result, contradiction=tuple(core))


def _is_of_rounding(core: Sequence[Premise], knowledge: Knowledge, base: Mapping[str, Formula]) -> bool:
    """Tell whether the number that premises come down to is explained by the decimals it rests on."""
    behind = {name for p in core for node in (p.left, p.right) for name in names_behind(node, base)}
    values = {name: base[name] for name in behind if name in base}
    numbers = [n for p in core for n in (*decimals(p.left), *decimals(p.right))]
    numbers += [n for node in values.values() for n in decimals(node)]
    if not numbers:
        return False
    residue = _residue(core, knowledge, base)
    if residue is None:
        return True  # not brought down to a number: nothing is accused on that
    total = abs(residue) * 0
    for number in numbers:
        assert number.last_place is not None
        off = Number(number.value + number.last_place / 2, number.last_place)
        moved = [
            replace(p, left=replace_part(p.left, number, off), right=replace_part(p.right, number, off))
            for p in core
        ]
        moved_base = {**base, **{n: replace_part(v, number, off) for n, v in values.items()}}
        there = _residue(moved, knowledge, moved_base)
        if there is None:
            return True
        total += abs(there - residue)
    return bool(abs(residue) < total * (1 - 1e-9))  # 0.4 + 0.5 for 1 is off by all of it


def _residue(premises: Sequence[Premise], knowledge: Knowledge, base: Mapping[str, Formula]) -> Any:
    """Return the number that premises in contradiction come down to, None where it is none."""
    form = _eliminate(premises, knowledge, base).residue
    if form is None or letters(form):
        return None
    return Valuation(form.domain, {}).polynomial(form.numerator)


def implied(
    premises: Sequence[Premise], left: Formula, right: Formula, knowledge: Knowledge
) -> bool | None:
    """Tell whether left = right follows from premises as polynomials: True, False if they exclude it.

    None where neither is proved.
    """
    base = _known_values(knowledge)
    if _by_ideal(premises, Premise(left, right, 0), knowledge, base):
        return True
    return False if _cannot_hold([*premises, Premise(left, right, 0)], knowledge, base) else None


def _cannot_hold(premises: Sequence[Premise], knowledge: Knowledge, base: Mapping[str, Formula]) -> bool:
    """Tell whether premises, as polynomial equations, are satisfied by no numbers."""
    forms = _forms(premises, knowledge, base)
    if forms is None or any(has_decimals(p) for p in premises):
        return False
    domain = forms[0].domain
    return cannot_hold(domain, [form.numerator for form in forms], _nonzero(domain))


def _by_ideal(
    premises: Sequence[Premise], claim: Premise, knowledge: Knowledge, base: Mapping[str, Formula]
) -> bool:
    forms = _forms([*premises, claim], knowledge, base)
    if forms is None or any(has_decimals(p) for p in (*premises, claim)):
        return False
    *given, claimed = forms
    return follows(
        claimed.domain, [form.numerator for form in given], claimed.numerator, _nonzero(claimed.domain)
    )


def _forms(
    premises: Sequence[Premise], knowledge: Knowledge, base: Mapping[str, Formula]
) -> list[Form] | None:
    """Return left - right of premises in one domain, None where one has no form."""
    meaning = replace(knowledge.meaning, values=base)
    evaluator = FormEvaluator(meaning.domain(), meaning)
    try:
        return [evaluator.form(_difference(p)) for p in premises]
    except (NoFormError, TooLargeError):
        return None


def _nonzero(domain: Domain) -> list[int]:
    """Return the letters that are positive, and so not zero."""
    return [n for n, g in enumerate(domain.generators) if g.kind == "symbol" and g.positive]


def _eliminate(
    premises: Sequence[Premise], knowledge: Knowledge, base: Mapping[str, Formula]
) -> Elimination:
    solved = dict[str, Formula]()
    waiting, following = list(premises), list[Premise]()
    used: list[Premise] = []
    vanishing: list[str] = []
    nonzero: dict[str, None] = {}
    while waiting:
        before = len(waiting)
        for premise in list(waiting):
            outcome = _reduce(premise, {**base, **solved}, knowledge)
            if outcome is None:
                continue
            form, solution = outcome
            if form.is_zero() or _vanishes(form):
                following.append(premise)
            elif _is_for_all_angles(premise, form, knowledge) or not letters(form):
                core = (*used, premise)
                ends = tuple(vanishing), tuple(nonzero)
                return Elimination(solved, (), core, tuple(following), *ends, form)
            elif solution is None:
                continue
            else:
                solved[solution[0]] = solution[1]
                nonzero |= dict.fromkeys(_common_letters(form.domain, form.numerator, solution[0]))
                if solution[1] == _ZERO:
                    vanishing.append(solution[0])
                used.append(premise)
            waiting.remove(premise)
        if len(waiting) == before:
            break
    return Elimination(solved, tuple(waiting), (), tuple(following), tuple(vanishing), tuple(nonzero))


def _vanishes(form: Form) -> bool:
    """Tell whether a number is 0 to twenty digits, e^(-ln 2) - 1/2: it contradicts nothing."""
    if letters(form):
        return False
    value = Valuation(form.domain, {}).polynomial(form.numerator)
    return bool(abs(value) < 1e-20)


def _is_for_all_angles(premise: Premise, form: Form, knowledge: Knowledge) -> bool:
    """Tell whether a premise on other letters comes down to one on angles alone, which are free.

    A common factor that is positive does not count: r² cos 2θ = 0 is no equation for a radius r. A letter
    that stands in sines and cosines only, and not in the premise itself, is such an angle too.
    """
    if not form.is_polynomial:
        return False
    parts = components(form.domain, form.numerator)
    factors = {key.letters for key in parts}
    inside = _inner_generators(form.domain, form.numerator)
    generators = form.domain.generators
    free = {generators[n].content for n in inside if generators[n].kind == "symbol"}
    own = set(letters(form))
    if free and own <= free and free.isdisjoint(premise.names):
        return True
    is_common = len(factors) == 1 and all(generators[g].positive for g, _ in next(iter(factors)))
    if is_common and any(key.function != "1" for key in parts):
        own &= free
    return own <= knowledge.angles and not premise.names <= knowledge.angles


def _reduce(
    premise: Premise, values: Mapping[str, Formula], knowledge: Knowledge
) -> tuple[Form, tuple[str, Formula] | None] | None:
    """Return left - right in normal form, and what it says of a letter; None where it has none."""
    meaning = replace(knowledge.meaning, values=values)
    evaluator = FormEvaluator(meaning.domain(), meaning)
    try:
        form = evaluator.form(_difference(premise))
        return form, _solve_linearly(form.domain, form.numerator, knowledge)
    except (NoFormError, TooLargeError):
        return None


def _difference(premise: Premise) -> Formula:
    """Return left - right; of |y| = 3 the difference of the squares, since y may be -3 as well."""
    sides = premise.left, premise.right
    sizes = [side for side in sides if isinstance(side, Call) and side.function == "abs"]
    others = [side for side in sides if side not in sizes]
    if len(sizes) != 1 or names(others[0]):
        return Sum((premise.left, Negative(premise.right)))
    two = Number(Fraction(2))
    return Sum((Power(sizes[0].argument, two), Negative(Power(others[0], two))))


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
            return generator.content, _ZERO  # 3 w = 0
        if len(powers) != 2 or any(b - a != 1 for a, b in pairwise(powers)):
            continue
        if powers[0] and not generator.positive:
            continue  # x² = x is not x = 1
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


def _common_letters(domain: Domain, polynomial: Polynomial, solved: str) -> list[str]:
    """Return the letters that all terms have as a factor, and that may be 0, but the one solved for."""
    factors = [{g for g, power in monomial if power > 0} for monomial in polynomial]
    common = set.intersection(*factors) if factors else set[int]()
    generators = (domain.generators[number] for number in sorted(common))
    return [
        g.content for g in generators if g.kind == "symbol" and not g.positive and g.content != solved
    ]


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


def lines_of(premises: Sequence[Premise]) -> str:
    """Return the lines of premises, as `lines 1 and 3`."""
    numbers = [str(n) for n in sorted({p.line for p in premises})]
    *others, last = numbers
    return f"lines {', '.join(others)} and {last}" if others else f"line {last}"


def nonzero_texts(result: Elimination) -> tuple[str, ...]:
    """Return the letters that an elimination divided by, each as `w ≠ 0`."""
    return tuple(f"{plain_text(Name(name))} ≠ 0" for name in result.nonzero)
