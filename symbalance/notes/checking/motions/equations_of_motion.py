"""Linear differential equations of motion, J φ̈ + c φ = 0, and the natural frequencies that follow.

Such an equation holds along one motion: it gives no letter its value, least of all a mass. With
x = X e^(iωt) each becomes linear in the amplitudes; a natural frequency is where the determinant of them
all is zero.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import combinations, product

from symbalance.document.formula import (
    Constant,
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    names,
    walk,
)
from symbalance.notes.algebra.domain import Monomial, NoFormError, Polynomial, TooLargeError
from symbalance.notes.algebra.evaluation import derivative_name
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.harmonics import polynomial_node
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision, decide_equality
from symbalance.notes.checking.deciding.knowledge import Knowledge, Level
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.verdicts import CONDITION
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_ZERO, _TWO = Number(Fraction(0)), Number(Fraction(2))
MOST = 3
"""Equations that are solved together."""
HIGHEST = 2
"""Order of the derivatives of an equation of motion."""
_ANGULAR = re.compile(r"(?:omega|Omega)(?:_.*|\d*)")
_FREQUENCY = re.compile(r"(?:f|nu)(?:_.*|\d*)")
_PERIOD = re.compile(r"(?:T|tau)(?:_.*|\d*)")


@dataclass(frozen=True, slots=True)
class EquationOfMotion:
    """A linear equation in letters that move: their factors, by letter and order of differentiation."""

    factors: Mapping[tuple[str, int], Formula]
    rest: Formula
    """What stands beside them on one side: the force, with a minus sign."""
    line: int
    text: str

    @property
    def moving(self) -> frozenset[str]:
        """The letters that move in it."""
        return frozenset(name for name, _ in self.factors)

    @property
    def lone_rate(self) -> tuple[str, Formula] | None:
        """The one dotted letter of J ω̇ = M_1 - M_2, and what it is; None where several letters move."""
        if len(self.factors) != 1:
            return None
        ((name, order), factor) = next(iter(self.factors.items()))
        rate = derivative_name(Derivative(Name(name), Name("t"), order))
        return (rate, Quotient(Negative(self.rest), factor)) if order else None

    @property
    def letters(self) -> frozenset[str]:
        """The letters of its factors."""
        return frozenset(name for factor in self.factors.values() for name in names(factor))


def equation_of_motion(
    chain: Chain, k: int, elsewhere: Collection[str], knowledge: Knowledge
) -> EquationOfMotion | None:
    """Return a relation as an equation of motion, None for what is none: m ẍ = m ẍ, or v = ẋ.

    `elsewhere` are the letters that other lines differentiate: they move here too.
    """
    if k or len(chain.relations) != 1 or chain.relations[0].sign != "=":
        return None
    left, right = chain.sides[0].node, chain.sides[1].node
    moving = moving_letters(left, right, knowledge)
    if not moving or any(_gives_a_letter(one, other) for one, other in ((left, right), (right, left))):
        return None
    try:
        form = knowledge.evaluator(Level({})).form(Sum((left, Negative(right))))
    except (NoFormError, TooLargeError):
        return None
    others = {n for n in elsewhere if not knowledge.knows(n)}
    own = moving | (others & (names(left) | names(right)))
    text = f"{plain_text(left)} = {plain_text(right)}"
    equation = linear_equation(form, own, chain.lines[0], text)
    has_rates = equation is not None and any(order for _, order in equation.factors)
    return equation if has_rates and len(form.numerator) > 1 else None


def linear_equation(
    form: Form, moving: frozenset[str] | set[str], line: int, text: str
) -> EquationOfMotion | None:
    """Return a form that is zero as a linear equation in what moves; None where it is not linear."""
    linear = _linear_factors(form, frozenset(moving))
    return None if linear is None else EquationOfMotion(*linear, line, text)


def decide_motion(
    equation: EquationOfMotion,
    earlier: Sequence[EquationOfMotion],
    knowledge: Knowledge,
    *,
    follows: bool,
) -> Decision:
    """Return that an equation of motion is a condition, or follows from one above, or does not.

    `follows` tells that the relation goes on from the one before it.
    """
    for other in reversed(earlier):
        if other.factors.keys() != equation.factors.keys():
            continue
        if _is_multiple(equation, other, knowledge):
            return Decision(PROVED, f"by line {other.line}")
        if follows and other is earlier[-1] and equation.letters <= other.letters:
            return Decision(REFUTED, f"is another equation than {other.text} of line {other.line}")
    return Decision(CONDITION, "equation of motion")


def is_combination(equation: EquationOfMotion, others: Sequence[EquationOfMotion]) -> list[int]:
    """Return the lines of equations of which another one is a sum or difference; [] for none."""
    nearest = list(others)[-MOST:]
    for signs in product((0, 1, -1), repeat=len(nearest)):
        terms = [(sign, each) for sign, each in zip(signs, nearest, strict=True) if sign]
        if len(terms) < 2:
            continue
        keys = equation.factors.keys() | {key for _, each in terms for key in each.factors}
        if all(
            _is_sum([(s, e.factors.get(key, _ZERO)) for s, e in terms], equation, key) for key in keys
        ):
            rests = Sum(tuple(e.rest if s > 0 else Negative(e.rest) for s, e in terms))
            if decide_equality(equation.rest, rests, Knowledge()).is_proved:
                return sorted({each.line for _, each in terms})
    return []


def is_weighted_sum(equation: EquationOfMotion, others: Sequence[EquationOfMotion]) -> bool | None:
    """Tell whether an equation is a sum of multiples of others, each with one second rate of its own.

    The multiples are those of the second rates: 1/J_1 and -1/J_2 for the twist of two discs. None where
    the others are not of this kind, or leave a rate out.
    """
    own = [[name for (name, order) in each.factors if order == 2] for each in others]
    heads = [names_[0] for names_ in own if len(names_) == 1]
    rates = {name for name, order in equation.factors if order == 2}
    if len(heads) < len(others) or len({*heads}) < len(heads) or not rates or not rates <= {*heads}:
        return None
    weights = [
        Quotient(equation.factors.get((head, 2), _ZERO), each.factors[head, 2])
        for head, each in zip(heads, others, strict=True)
    ]
    keys = equation.factors.keys() | {key for each in others for key in each.factors}
    pairs = [
        (equation.factors.get(key, _ZERO), [each.factors.get(key, _ZERO) for each in others])
        for key in keys
    ]
    for one, parts in [*pairs, (equation.rest, [each.rest for each in others])]:
        total = Sum(tuple(Product((w, p)) for w, p in zip(weights, parts, strict=True)))
        decision = decide_equality(one, total, Knowledge())
        if not decision.is_proved:
            return False if decision.status == REFUTED else None
    return True


def _is_sum(
    terms: Sequence[tuple[int, Formula]], equation: EquationOfMotion, key: tuple[str, int]
) -> bool:
    total = Sum(tuple(node if sign > 0 else Negative(node) for sign, node in terms))
    return decide_equality(equation.factors.get(key, _ZERO), total, Knowledge()).is_proved


def decide_natural_frequency(
    chain: Chain, k: int, equations: Sequence[EquationOfMotion], knowledge: Knowledge
) -> Decision | None:
    """Return whether a frequency's formula is a natural frequency of the equations above, or None.

    None too for a letter of the equations themselves, and where the formula has letters of its own.
    """
    square = _square_of_frequency(chain, k, knowledge) if equations else None
    if square is None:
        return _decide_frequency_equation(chain, k, equations, knowledge) if equations else None
    own = names(square)
    nearest = list(reversed(equations))[: 2 * MOST]
    for count in range(1, MOST + 1):
        for system in combinations(nearest, count):
            moving = frozenset[str]().union(*(e.moving for e in system))
            coefficients = frozenset[str]().union(*(e.letters for e in system))
            if len(moving) != count or not own <= coefficients or not own:
                continue
            return _decide_system(system, sorted(moving), square, own == coefficients, knowledge)
    return None


def _decide_system(
    system: Sequence[EquationOfMotion],
    moving: Sequence[str],
    square: Formula,
    has_all_letters: bool,
    knowledge: Knowledge,
) -> Decision | None:
    """Return whether the determinant of a system is zero at a frequency; None where it says nothing."""
    formulas = {name: d for name, d in knowledge.definitions.items() if not d.numeric}
    known = replace(knowledge, definitions=formulas)
    first, last = min(e.line for e in system), max(e.line for e in system)
    where = f"line {first}" if first == last else f"lines {first} and {last}"
    is_damped = any(order == 1 for e in system for _, order in e.factors)
    rows = [[_at_frequency(e, name, square) for name in moving] for e in system]
    decision = decide_equality(determinant(rows), _ZERO, known)
    if not decision.is_proved and is_damped and len(system) == 1:
        decision = decide_equality(square, _damped_square(system[0], moving[0]), known)
    if decision.is_proved:
        return Decision(PROVED, f"a natural frequency by {where}", assumptions=decision.assumptions)
    if decision.status != REFUTED or not (has_all_letters or len(system) == 1):
        return None
    reason = f"no natural frequency by {where}: no motion A cos(ω t) satisfies it"
    return Decision(REFUTED, reason, witness=decision.witness)


def _decide_frequency_equation(
    chain: Chain, k: int, equations: Sequence[EquationOfMotion], knowledge: Knowledge
) -> Decision | None:
    """Return whether c - J ω² = 0 says the same as the one equation of motion above; None for others."""
    last = equations[-1]
    is_damped = any(order == 1 for _, order in last.factors)
    if k or len(chain.relations) != 1 or chain.relations[0].sign != "=" or is_damped:
        return None
    left, right = chain.sides[0].node, chain.sides[1].node
    own = names(left) | names(right)
    angular = [n for n in own - last.letters if _ANGULAR.fullmatch(n) and not knowledge.knows(n)]
    if len(last.moving) != 1 or len(angular) != 1 or own - {*angular} != last.letters:
        return None
    (omega,), (moving,) = angular, last.moving
    gap = Sum((left, Negative(right)))
    condition = _at_frequency(last, moving, Power(Name(omega), _TWO))
    other = Name(omega + "'")
    decision = decide_equality(
        Product((gap, substitute(condition, omega, other))),
        Product((substitute(gap, omega, other), condition)),
        Knowledge(),
    )
    if decision.is_proved:
        return Decision(PROVED, f"by line {last.line}, with A cos({plain_text(Name(omega))} t)")
    if decision.status != REFUTED:
        return None
    reason = f"does not follow from line {last.line} with A cos({plain_text(Name(omega))} t)"
    return Decision(REFUTED, reason, witness=decision.witness)


def moving_letters(left: Formula, right: Formula, knowledge: Knowledge) -> frozenset[str]:
    """Return the letters that two sides differentiate by the time and of which nothing is known."""
    time = knowledge.crank.time if knowledge.crank else "t"
    return frozenset(
        part.expression.name
        for node in (left, right)
        for part in walk(node)
        if isinstance(part, Derivative)
        and isinstance(part.expression, Name)
        and part.variable.name == time
        and part.order <= HIGHEST
        and not knowledge.knows(part.expression.name)
    )


def _gives_a_letter(one: Formula, other: Formula) -> bool:
    """Tell whether one side is a letter, or a dotted letter that stands nowhere else: F = m ẍ, ẍ = -g."""
    if isinstance(one, Name):
        return one.name not in names(other)
    if not isinstance(one, Derivative) or not isinstance(one.expression, Name):
        return False
    return one.expression.name not in names(other)


def _linear_factors(
    form: Form, moving: frozenset[str]
) -> tuple[dict[tuple[str, int], Formula], Formula] | None:
    """Return the factors of moving letters and their rates in a form, and the rest; else None."""
    domain = form.domain
    generators: dict[int, tuple[str, int]] = {}
    for name in moving:
        generators[domain.symbol(name)] = name, 0
        for order in range(1, HIGHEST + 1):
            rate = derivative_name(Derivative(Name(name), Name("t"), order))
            generators[domain.symbol(rate)] = name, order
    polynomials: dict[tuple[str, int], Polynomial] = {}
    beside: Polynomial = {}
    for monomial, coefficient in form.numerator.items():
        own = [(g, e) for g, e in monomial if g in generators]
        behind = {
            n for g, _ in monomial if domain.generators[g].kind != "symbol" for n in _names_in(form, g)
        }
        if len(own) > 1 or (own and own[0][1] != 1) or behind & moving:
            return None
        if own:
            rest: Monomial = tuple(entry for entry in monomial if entry[0] not in generators)
            polynomials.setdefault(generators[own[0][0]], {})[rest] = coefficient
        else:
            beside[monomial] = coefficient
    if any(n in moving for m in form.denominator for g, _ in m for n in _names_in(form, g)):
        return None
    factors = {key: polynomial_node(domain, p) for key, p in polynomials.items()}
    return factors, polynomial_node(domain, beside)


def _names_in(form: Form, number: int) -> Iterator[str]:
    """Yield the letters of a generator: the letter itself, or those of a root or a wave."""
    alone = polynomial_node(form.domain, {((number, 1),): Fraction(1)})
    yield from names(alone)


def _is_multiple(one: EquationOfMotion, other: EquationOfMotion, knowledge: Knowledge) -> bool:
    """Tell whether two equations are the same but for a factor."""
    (key, first), *rest = one.factors.items()
    return all(
        decide_equality(
            Product((first, other.factors[own])), Product((other.factors[key], factor)), knowledge
        ).is_proved
        for own, factor in rest
    )


def _square_of_frequency(chain: Chain, k: int, knowledge: Knowledge) -> Formula | None:
    """Return ω² by a relation that gives ω, ω², f or T a formula; None for others."""
    if k or chain.relations[0].sign != "=":
        return None
    head, value = chain.sides[0].node, chain.sides[1].node
    is_square = isinstance(head, Power) and head.exponent == _TWO
    letter = head.base if isinstance(head, Power) and is_square else head
    if not isinstance(letter, Name) or letter.name in names(value) or knowledge.knows(letter.name):
        return None
    power = value if is_square else Power(value, _TWO)
    if _ANGULAR.fullmatch(letter.name):
        return power
    full = Product((Number(Fraction(4)), Power(Constant("pi"), _TWO)))
    has_turn = any(isinstance(part, Constant) and part.name == "pi" for part in walk(value))
    if _FREQUENCY.fullmatch(letter.name) and has_turn:
        return Product((full, power))
    if _PERIOD.fullmatch(letter.name) and has_turn:
        return Quotient(full, power)
    return None


def _at_frequency(equation: EquationOfMotion, name: str, square: Formula) -> Formula:
    """Return an equation's factor of an amplitude: c - J ω², damping left out."""
    stiffness = equation.factors.get((name, 0), _ZERO)
    inertia = equation.factors.get((name, 2), _ZERO)
    return Sum((stiffness, Negative(Product((inertia, square)))))


def _damped_square(equation: EquationOfMotion, name: str) -> Formula:
    """Return ω² of the damped motion, c/m - (d/2m)²."""
    inertia = equation.factors.get((name, 2), _ZERO)
    stiffness = Quotient(equation.factors.get((name, 0), _ZERO), inertia)
    decay = Quotient(equation.factors.get((name, 1), _ZERO), Product((_TWO, inertia)))
    return Sum((stiffness, Negative(Power(decay, _TWO))))


def determinant(rows: Sequence[Sequence[Formula]]) -> Formula:
    """Return the determinant of a matrix of formulas, by its first row."""
    if len(rows) == 1:
        return rows[0][0]
    terms: list[Formula] = []
    for column, entry in enumerate(rows[0]):
        minor = [[*row[:column], *row[column + 1 :]] for row in rows[1:]]
        term = Product((entry, determinant(minor)))
        terms.append(Negative(term) if column % 2 else term)
    return Sum(tuple(terms))
