"""Trial solutions of free vibrations: y₁ = A sin pt and y₂ = B sin pt in the equations of motion above.

They become linear in the amplitudes A and B, and what a page says of these and of p is judged by that.

    (k - I₁ p²) A - k B = 0         a row of them, or what follows wherever their determinant is 0
    A/B = -I₂/I₁                    the ratio in one of the modes
    I₁ I₂ p² - k (I₁ + I₂) = 0      the determinant, a factor p² left out where p = 0 is a root
    p² = k (I₁ + I₂)/(I₁ I₂)        one of its roots
    p = 0                           a root that says nothing of p in the lines below

Letters may be equal in a special case: "for I₁ = I₂ = I and k₁ = k₂ = k", p² = 3k/I and A/B = 1 - 3.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import combinations

from symbalance.document.formula import (
    Call,
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
from symbalance.notes.algebra import polynomials as poly
from symbalance.notes.algebra.domain import Domain, NoFormError, Polynomial, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator, SymbolValue
from symbalance.notes.algebra.harmonics import polynomial_node
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision, decide_equality
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.motions.equations_of_motion import MOST, EquationOfMotion, determinant
from symbalance.notes.checking.motions.special_systems import (
    chosen_letters,
    is_ratio_in_mode,
    number_of,
    with_letters_chosen,
)
from symbalance.notes.checking.verdicts import CONDITION
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain

_ZERO, _ONE, _TWO = Number(Fraction(0)), Number(Fraction(1)), Number(Fraction(2))
_BARE = Knowledge()
_MOST_FACTORS = 2
"""How often p² may be left out of a frequency equation."""


@dataclass(frozen=True, slots=True)
class Trial:
    """One trial motion: the letter that moves, its amplitude, the angular frequency, and its line."""

    moving: str
    amplitude: str
    frequency: str
    wave: Formula
    line: int


@dataclass(frozen=True)
class FreeVibration:
    """Equations of motion without forces, with a trial motion for each letter that moves in them."""

    equations: tuple[EquationOfMotion, ...]
    trials: tuple[Trial, ...]

    @property
    def frequency(self) -> Name:
        """The letter of the angular frequency."""
        return Name(self.trials[0].frequency)

    @property
    def amplitudes(self) -> tuple[str, ...]:
        """The letters of the amplitudes."""
        return tuple(trial.amplitude for trial in self.trials)

    @property
    def letters(self) -> frozenset[str]:
        """The masses and stiffnesses."""
        return frozenset[str]().union(*(equation.letters for equation in self.equations))

    @property
    def is_independent(self) -> bool:
        """Whether no equation follows from the others: else every frequency would be a natural one."""
        whole = determinant(self.rows(Power(self.frequency, _TWO)))
        return not decide_equality(whole, _ZERO, _BARE).is_proved

    def in_case(self, chosen: Mapping[str, Formula]) -> FreeVibration:
        """Return the vibration with letters that are set equal to others written by them."""
        equations = tuple(with_letters_chosen(each, chosen) for each in self.equations)
        return replace(self, equations=equations)

    @property
    def where(self) -> str:
        """The lines of the equations."""
        lines = sorted({equation.line for equation in self.equations})
        return f"line {lines[0]}" if len(lines) == 1 else f"lines {lines[0]} to {lines[-1]}"

    def rows(self, square: Formula) -> list[list[Formula]]:
        """Return the factors of the amplitudes where the frequency has a square."""
        return [[_factor(each, trial.moving, square) for trial in self.trials] for each in self.equations]


def trial_of(chain: Chain, k: int, equations: Sequence[EquationOfMotion]) -> Trial | None:
    """Return a relation as a trial motion of a letter that moves above; None for others."""
    head, value = chain.sides[k].node, chain.sides[k + 1].node
    moving = {name for equation in equations for name in equation.moving}
    if k or not isinstance(head, Name) or head.name not in moving or not isinstance(value, Product):
        return None
    waves = [f for f in value.factors if isinstance(f, Call) and f.function in ("sin", "cos")]
    others = [f for f in value.factors if f not in waves]
    if len(waves) != 1 or len(others) != 1 or not isinstance(others[0], Name):
        return None
    argument = waves[0].argument
    turning = [
        part
        for part in (argument.terms if isinstance(argument, Sum) else (argument,))
        if "t" in names(part)
    ]
    if len(turning) != 1 or not isinstance(turning[0], Product) or len(turning[0].factors) != 2:
        return None
    letters = [f.name for f in turning[0].factors if isinstance(f, Name) and f.name != "t"]
    if len(letters) != 1 or Name("t") not in turning[0].factors:
        return None
    return Trial(head.name, others[0].name, letters[0], waves[0], chain.lines[0])


def free_vibration(
    equations: Sequence[EquationOfMotion], trials: Sequence[Trial]
) -> FreeVibration | None:
    """Return the free vibration that trial motions are of: as many equations as letters that move."""
    last = {trial.moving: trial for trial in trials}
    nearest = list(reversed(equations))[: 2 * MOST]
    for count in range(MOST, 0, -1):
        for system in combinations(nearest, count):
            moving = sorted(frozenset[str]().union(*(each.moving for each in system)))
            own = tuple(last[name] for name in moving if name in last)
            is_free = all(each.rest == _ZERO and not _is_damped(each) for each in system)
            if not is_free or not len(own) == len(moving) == count:
                continue
            is_one = len({trial.wave for trial in own}) == 1
            is_apart = len({trial.amplitude for trial in own}) == count
            vibration = FreeVibration(tuple(reversed(system)), own)
            known = {*vibration.letters, *moving}
            is_new = not known & {own[0].frequency, *vibration.amplitudes}
            if is_one and is_apart and is_new and vibration.is_independent:
                return vibration
    return None


def decide_by_trial(
    chain: Chain, k: int, vibration: FreeVibration, equal: Sequence[tuple[Formula, ...]]
) -> Decision | None:
    """Return the decision on what a page says of amplitudes and frequencies; None for other relations.

    `equal` is what words near set equal: masses and stiffnesses to each other or to new letters.
    """
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    if any(relation.sign != "=" for relation in chain.relations[: k + 1]):
        return None
    amplitudes = {*vibration.amplitudes}
    head = left if names(left) & amplitudes else chain.sides[0].node
    try:
        if k and decide_equality(left, right, _BARE).is_proved:
            return None  # a step like any other
        own = (names(head) | names(right)) - amplitudes
        own -= {n for n in own if n.partition("_")[0] == vibration.frequency.name.partition("_")[0]}
        decision = None if own - vibration.letters else _decide(head, right, vibration)
        return decision or _decide_special(
            head, right, vibration, chosen_letters(equal, own, vibration.letters)
        )
    except (NoFormError, TooLargeError):
        return None


def _decide_special(
    left: Formula, right: Formula, vibration: FreeVibration, chosen: Mapping[str, Formula]
) -> Decision | None:
    """Return the decision on an equation where letters are set equal to others; None if none are."""
    special = vibration.in_case(chosen)
    if not chosen or not special.is_independent:
        return None
    decision = _decide(left, right, special) or _decide_bare_ratio(left, right, special)
    if decision is None:
        return None
    case = ", ".join(f"{plain_text(Name(a))} = {plain_text(b)}" for a, b in sorted(chosen.items()))
    if decision.is_proved:
        return replace(decision, assumptions=(*decision.assumptions, case))
    return replace(decision, reason=f"{decision.reason}, with {case}")


def _decide(left: Formula, right: Formula, vibration: FreeVibration) -> Decision | None:
    """Return the decision on an equation by what stands in it: amplitudes, p alone, or p and the rest."""
    own, p = names(left) | names(right), vibration.frequency
    head = left.base if isinstance(left, Power) and left.exponent == _TWO else left
    is_frequency = isinstance(head, Name) and (head == p or head.name.startswith(f"{p.name}_"))
    if own & {*vibration.amplitudes}:
        sizes = _sizes_of_amplitudes(left, right, vibration)
        return sizes or _decide_amplitudes(left, right, vibration)
    if is_frequency and right == _ZERO:
        at_rest = decide_equality(determinant(vibration.rows(_ZERO)), _ZERO, _BARE)
        return Decision(CONDITION, "a root of the frequency equation") if at_rest.is_proved else None
    if is_frequency and not any(name.partition("_")[0] == p.name for name in names(right)):
        return _decide_root(right if head is not left else Power(right, _TWO), vibration)
    return _decide_frequency_equation(left, right, vibration) if p.name in own else None


def _decide_root(square: Formula, vibration: FreeVibration) -> Decision | None:
    """Return whether a formula for p² is a root of the frequency equation."""
    own, known = names(square), vibration.letters
    if not own or not own <= known:
        return None
    decision = decide_equality(determinant(vibration.rows(square)), _ZERO, _BARE)
    if decision.is_proved:
        return Decision(PROVED, f"a natural frequency by {vibration.where}")
    if decision.status != REFUTED or own != known:
        return None
    reason = f"no natural frequency by {vibration.where}"
    return Decision(REFUTED, reason, witness=decision.witness)


def _sizes_of_amplitudes(left: Formula, right: Formula, vibration: FreeVibration) -> Decision | None:
    """Return the decision on a ratio of sizes, |A|/|B| = I₂/I₁; None where no size of amplitudes stands.

    Masses and stiffnesses are positive, and so is what has plus signs only.
    """
    bare = _without_sizes(left)
    if bare == left or not _is_positive(right) or names(right) & {*vibration.amplitudes}:
        return None
    ways = [_decide_amplitudes(bare, value, vibration) for value in (right, Negative(right))]
    for way in ways:
        if way is not None and way.is_proved:
            return way
    return ways[0] if all(way is not None and way.status == REFUTED for way in ways) else None


def _without_sizes(node: Formula) -> Formula:
    """Return a quotient of two sizes without the strokes, |A/B| as A/B."""
    if isinstance(node, Call) and node.function == "abs":
        return node.argument
    if isinstance(node, Quotient):
        above, below = _without_sizes(node.numerator), _without_sizes(node.denominator)
        is_both = above != node.numerator and below != node.denominator
        return Quotient(above, below) if is_both else node
    return node


def _is_positive(node: Formula) -> bool:
    """Tell whether a formula of positive letters has no minus sign."""
    return all(
        isinstance(part, Name | Sum | Product | Quotient | Power)
        or (isinstance(part, Number) and part.value > 0)
        for part in walk(node)
    )


def _decide_bare_ratio(left: Formula, right: Formula, vibration: FreeVibration) -> Decision | None:
    """Return whether a ratio of two amplitudes as a number, A₂/A₁ = 1 - 3, is one of a natural mode."""
    amplitudes = vibration.amplitudes
    if not isinstance(left, Quotient) or names(right):
        return None
    if not isinstance(left.numerator, Name) or not isinstance(left.denominator, Name):
        return None
    pair = left.numerator.name, left.denominator.name
    ratio = number_of(right)
    if ratio is None or not {*pair} <= {*amplitudes} or pair[0] == pair[1]:
        return None
    inertia, still = (
        [
            [each.factors.get((t.moving, order), _ZERO) for t in vibration.trials]
            for each in vibration.equations
        ]
        for order in (2, 0)
    )
    places = amplitudes.index(pair[0]), amplitudes.index(pair[1])
    is_mode = is_ratio_in_mode(still, inertia, places, ratio)
    one, other = (plain_text(Name(name)) for name in pair)
    if is_mode is None:
        return None
    kind = "a" if is_mode else "no"
    reason = f"the ratio of {one} and {other} in {kind} natural mode by {vibration.where}"
    return Decision(PROVED if is_mode else REFUTED, reason)


def _decide_frequency_equation(
    left: Formula, right: Formula, vibration: FreeVibration
) -> Decision | None:
    """Return whether an equation in p is that of the natural frequencies; None if letters are missing."""
    p = vibration.frequency
    if names(left) | names(right) != vibration.letters | {p.name}:
        return None
    other = Name(p.name + "'")
    gap, whole = Sum((left, Negative(right))), determinant(vibration.rows(Power(p, _TWO)))
    last: Decision | None = None
    for count in range(_MOST_FACTORS + 1):
        full = Product((gap, *[Power(p, _TWO)] * count))
        last = decide_equality(
            Product((full, substitute(whole, p.name, other))),
            Product((substitute(full, p.name, other), whole)),
            _BARE,
        )
        if last.is_proved:
            return Decision(PROVED, f"the frequency equation by {vibration.where}")
    if last is None or last.status != REFUTED:
        return None
    return Decision(REFUTED, f"not the frequency equation by {vibration.where}", witness=last.witness)


def _decide_amplitudes(left: Formula, right: Formula, vibration: FreeVibration) -> Decision | None:
    """Return whether an equation in the amplitudes follows from the equations of motion."""
    p, amplitudes = vibration.frequency, vibration.amplitudes
    own = names(left) | names(right)
    if not own <= vibration.letters | {p.name, *amplitudes}:
        return None
    factors = _linear(Sum((left, Negative(right))), amplitudes)
    if factors is None:
        return None
    rows = vibration.rows(Power(p, _TWO))
    if any(_is_multiple(factors, row) for row in rows):
        return Decision(PROVED, f"by {vibration.where}, with this motion put in")
    if p.name not in own and len(amplitudes) == 2 and {*amplitudes} <= own:
        return _decide_ratio(factors, vibration, is_told=bool(own - {*amplitudes}))
    mode = [Product((factor, each)) for factor, each in zip(factors, _cofactors(rows), strict=True)]
    whole = determinant(rows)
    counts = [n for n in (0, 1) if _vanishes_with(Sum(tuple(mode)), whole, p.name, n)]
    if counts:
        assumptions = (f"{plain_text(p)} ≠ 0",) if counts[0] else ()
        reason = f"by {vibration.where}, at a natural frequency"
        return Decision(PROVED, reason, assumptions=assumptions)
    # without p it may be of one mode, or of a special case
    reason = f"does not follow from {vibration.where} with this motion put in"
    return Decision(REFUTED, reason) if p.name in own else None


def _decide_ratio(
    factors: Sequence[Formula], vibration: FreeVibration, *, is_told: bool
) -> Decision | None:
    """Return whether two amplitudes have the ratio of a mode; None for one without masses, if wrong."""
    one, other = (plain_text(Name(name)) for name in vibration.amplitudes)
    if _is_ratio_of_mode(factors, vibration):
        reason = f"the ratio of {one} and {other} in a natural mode by {vibration.where}"
        return Decision(PROVED, reason)
    reason = f"the ratio of {one} and {other} in no natural mode by {vibration.where}"
    return Decision(REFUTED, reason) if is_told else None


def _cofactors(rows: Sequence[Sequence[Formula]]) -> list[Formula]:
    """Return the cofactors of a matrix's first row: a mode, where the determinant is 0."""
    cofactors: list[Formula] = []
    for column in range(len(rows)):
        minor = [[*row[:column], *row[column + 1 :]] for row in rows[1:]]
        part: Formula = determinant(minor) if minor else _ONE
        cofactors.append(Negative(part) if column % 2 else part)
    return cofactors


def _is_ratio_of_mode(factors: Sequence[Formula], vibration: FreeVibration) -> bool:
    """Tell whether some frequency has a motion of two amplitudes that an equation without p fixes.

    The first row of the equations gives p² for these amplitudes, and the second one has to agree.
    """
    amplitudes = (factors[1], Negative(factors[0]))
    rest, slope = [], []
    for still, at_one in zip(vibration.rows(_ZERO), vibration.rows(_ONE), strict=True):
        fixed = Sum(tuple(Product((f, a)) for f, a in zip(still, amplitudes, strict=True)))
        moved = Sum(tuple(Product((f, a)) for f, a in zip(at_one, amplitudes, strict=True)))
        rest.append(fixed)
        slope.append(Sum((moved, Negative(fixed))))
    across, back = Product((rest[0], slope[1])), Product((rest[1], slope[0]))
    return decide_equality(across, back, _BARE).is_proved


def _linear(gap: Formula, amplitudes: Sequence[str]) -> list[Formula] | None:
    """Return the factors of the amplitudes in what is homogeneous and linear in them, else None.

    A quotient A/B = c is so once it is multiplied by what stands below.
    """
    form = FormEvaluator(Domain(), SymbolValue()).form(gap)
    domain = form.domain
    numbers = [domain.symbol(name) for name in amplitudes]
    parts: dict[int, Polynomial] = {number: {} for number in numbers}
    least = {n: min((dict(m).get(n, Fraction(0)) for m in form.numerator), default=0) for n in numbers}
    for monomial, coefficient in form.numerator.items():
        powers = dict(monomial)
        own = [n for n in numbers if powers.get(n, Fraction(0)) != least[n]]
        if len(own) != 1 or powers.get(own[0], Fraction(0)) - least[own[0]] != 1:
            return None
        parts[own[0]][tuple(entry for entry in monomial if entry[0] not in numbers)] = coefficient
    return [polynomial_node(domain, parts[number]) for number in numbers]


def _is_multiple(factors: Sequence[Formula], row: Sequence[Formula]) -> bool:
    """Tell whether two rows of factors are the same but for a factor."""
    return all(
        decide_equality(Product((factors[i], row[j])), Product((factors[j], row[i])), _BARE).is_proved
        for i, j in combinations(range(len(row)), 2)
    )


def _vanishes_with(value: Formula, whole: Formula, p: str, count: int) -> bool:
    """Tell whether a formula is zero wherever another one is, p² left out of that so many times."""
    evaluator = FormEvaluator(Domain(), SymbolValue())
    below, above = (_by_powers(evaluator, node, p) for node in (whole, value))
    domain = evaluator.domain
    if any(power < 2 * count for power in below):
        return False
    below = {power - 2 * count: part for power, part in below.items()}
    highest = max(below)
    while above and max(above) >= highest:
        top = max(above)
        lead, remainder = above[top], dict[int, Polynomial]()
        for power, part in above.items():
            remainder[power] = poly.times(domain, part, below[highest])
        for power, part in below.items():
            at = power + top - highest
            remainder[at] = poly.minus(remainder.get(at, {}), poly.times(domain, part, lead))
        above = {power: part for power, part in remainder.items() if part}
    return not above


def _by_powers(evaluator: FormEvaluator, node: Formula, name: str) -> dict[int, Polynomial]:
    """Return the coefficients of a polynomial by the powers of one letter."""
    form = evaluator.form(node)
    symbol = form.domain.symbol(name)
    parts: dict[int, Polynomial] = {}
    for monomial, coefficient in form.numerator.items():
        power = Fraction(dict(monomial).get(symbol, 0))
        if power.denominator != 1 or power < 0:
            raise NoFormError("a root of a frequency")
        rest = tuple(entry for entry in monomial if entry[0] != symbol)
        parts.setdefault(int(power), {})[rest] = coefficient
    return parts


def _factor(equation: EquationOfMotion, name: str, square: Formula) -> Formula:
    stiffness = equation.factors.get((name, 0), _ZERO)
    inertia = equation.factors.get((name, 2), _ZERO)
    return Sum((stiffness, Negative(Product((inertia, square)))))


def _is_damped(equation: EquationOfMotion) -> bool:
    return any(order == 1 for _, order in equation.factors)
