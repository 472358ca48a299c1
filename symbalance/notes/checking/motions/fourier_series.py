r"""Fourier series without end, T(θ) = T_0 + Σ (a_j cos jωθ + b_j sin jωθ), and their coefficients.

The series only says what its letters are. Of ∫ T cos jωθ dθ over whole periods the other harmonics leave
nothing, so that a_j is 2/(interval) times it, and T_0 is 1/(interval) times ∫ T dθ.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Integral,
    Name,
    Negative,
    Number,
    Product,
    Quotient,
    Sum,
    Summation,
    children,
    names,
    walk,
    with_children,
)
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision, decide_equality
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.verdicts import DEFINITION
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain

_ZERO, _ONE, _TWO = (Number(Fraction(n)) for n in range(3))
MOST_PERIODS = 4
"""Periods over which a coefficient's integral may run."""
_RESULT = Name("∫")
"""A letter for the integral, which no page has."""


@dataclass(frozen=True, slots=True)
class FourierSeries:
    """A function as the sum of a constant and all its harmonics."""

    function: str
    constant: Formula | None
    index: str
    waves: tuple[tuple[str, Call], ...]
    """The letters of the harmonics, each with its cosine or sine."""
    line: int

    @property
    def letters(self) -> frozenset[str]:
        """The letters that the series defines."""
        own = {name for name, _ in self.waves}
        return frozenset(own | (names(self.constant) if self.constant is not None else set()))


def fourier_series(chain: Chain, k: int, knowledge: Knowledge) -> FourierSeries | None:
    """Return a relation as the Fourier series of a letter, with letters that are new; None for others.

    The bounds may go without saying, Σ_k. What is known of the function says nothing of its letters.
    """
    head, total = chain.sides[k].node, chain.sides[k + 1].node
    if k or chain.relations[0].sign != "=" or not isinstance(head, Name):
        return None
    terms = total.terms if isinstance(total, Sum) else (total,)
    sums = [term for term in terms if isinstance(term, Summation)]
    rest = [term for term in terms if not isinstance(term, Summation)]
    if len(sums) != 1 or len(rest) > 1 or sums[0].index is None:
        return None
    index = sums[0].index.name
    waves = [_wave(part, index) for part in _parts_of(sums[0].body)]
    series = tuple(wave for wave in waves if wave is not None)
    constant = rest[0] if rest else None
    own = FourierSeries(head.name, constant, index, series, chain.lines[0])
    is_read = len(series) == len(waves) and _has_own_letters(own, knowledge)
    return own if is_read and _has_all_harmonics(own, sums[0], knowledge) else None


def _has_own_letters(series: FourierSeries, knowledge: Knowledge) -> bool:
    """Tell whether a series has new letters, one for each kind of wave; of a known function all kinds."""
    own = [name for name, _ in series.waves]
    if any(map(knowledge.knows, own)) or len({*own}) < len(own):
        return False
    steady = names(series.constant) if series.constant is not None else frozenset[str]()
    if series.constant is not None and (len(steady) != 1 or steady & {series.function, *own}):
        return False
    is_whole = len(own) == len(_HARMONIC) and bool(steady) and not any(map(knowledge.knows, steady))
    return is_whole or not knowledge.knows(series.function)


def _has_all_harmonics(series: FourierSeries, total: Summation, knowledge: Knowledge) -> bool:
    """Tell whether a series goes over all multiples of one angle, its bounds written or not.

    Without them, Σ_k cos(θ + kα) may go over cylinders.
    """
    functions = {call.function for _, call in series.waves}
    if not 0 < len(series.waves) == len(functions) <= len(_HARMONIC):
        return False
    first = series.waves[0][1].argument
    bounds = (total.lower, total.upper)
    if bounds != (_ONE, Constant("infinity")):
        at_zero = substitute(first, series.index, _ZERO)
        if bounds not in ((None, None), (_ONE, None)) or not _is_same(at_zero, _ZERO, knowledge):
            return False
    return all(_is_same(call.argument, first, knowledge) for _, call in series.waves)


_HARMONIC = ("cos", "sin")


def _parts_of(body: Formula) -> tuple[Formula, ...]:
    return body.terms if isinstance(body, Sum) else (body,)


def _wave(node: Formula, index: str) -> tuple[str, Call] | None:
    """Return the letter and the harmonic of a term a_j cos jθ."""
    if not isinstance(node, Product) or len(node.factors) != 2:
        return None
    letter, call = node.factors
    if not isinstance(letter, Name) or not isinstance(call, Call) or call.function not in _HARMONIC:
        return None
    is_own = letter.name.endswith(f"_{index}") and index in names(call.argument)
    return (letter.name, call) if is_own else None


def decide_fourier(
    chain: Chain, k: int, series: Sequence[FourierSeries], knowledge: Knowledge
) -> Decision | None:
    """Return the decision on a coefficient's integral over whole periods; None for other relations."""
    head, value = chain.sides[k].node, chain.sides[k + 1].node
    if chain.relations[k].sign != "=" or not isinstance(head, Name):
        return None
    integrals = [part for part in walk(value) if isinstance(part, Integral)]
    if len(integrals) != 1 or integrals[0].lower is None or integrals[0].upper is None:
        return None
    for each in reversed(series):
        if head.name in each.letters and each.function in names(integrals[0].body):
            return _decide_coefficient(head, value, integrals[0], each, knowledge)
    return None


def _decide_coefficient(
    head: Name, value: Formula, integral: Integral, series: FourierSeries, knowledge: Knowledge
) -> Decision | None:
    factor = _factor(value, integral, knowledge)
    interval = Sum((integral.upper or _ONE, Negative(integral.lower or _ONE)))
    kernel = _kernel(integral.body, series.function, knowledge)
    if factor is None or kernel is None or not _is_of_periods(interval, integral, series, knowledge):
        return None
    mean = Quotient(_RESULT, interval)
    for letter, multiple, wave in _components(series):
        if not _is_same(kernel, wave, knowledge):
            continue
        amplitude = mean if wave == _ONE else Product((_TWO, mean))
        if letter != head.name:
            reason = (
                f"with {plain_text(wave)} it is that of {plain_text(Name(letter))} in line {series.line}"
            )
            return Decision(REFUTED, reason)
        solved = Quotient(amplitude, Quotient(multiple, Name(letter)))
        claimed = Product((factor, _RESULT))
        decision = decide_equality(claimed, solved, knowledge)
        if decision.is_proved:
            return Decision(PROVED, f"the coefficient of the series of line {series.line}")
        if decision.status != REFUTED:
            return None
        reason = f"not the coefficient of the series of line {series.line}: the factor is another"
        return replace(Decision(REFUTED, reason), witness=decision.witness)
    return None


def _components(series: FourierSeries) -> Iterator[tuple[str, Formula, Formula]]:
    """Yield a letter of the series, the term it stands in without its wave, and the wave."""
    if series.constant is not None:
        yield next(iter(names(series.constant))), series.constant, _ONE
    for letter, call in series.waves:
        yield letter, Name(letter), call


def _factor(value: Formula, integral: Integral, knowledge: Knowledge) -> Formula | None:
    """Return what an integral is multiplied by, None where it is not only multiplied."""
    marked = _with(value, integral, _RESULT)
    factor = substitute(marked, _RESULT.name, _ONE)
    return factor if _is_same(marked, Product((factor, _RESULT)), knowledge) else None


def _kernel(body: Formula, function: str, knowledge: Knowledge) -> Formula | None:
    """Return what a function is multiplied by under its integral."""
    kernel = substitute(body, function, _ONE)
    marked = substitute(body, function, _RESULT)  # whatever is known of the function
    return kernel if _is_same(marked, Product((_RESULT, kernel)), knowledge) else None


def _with(node: Formula, part: Formula, other: Formula) -> Formula:
    if node is part:
        return other
    parts = children(node)
    return with_children(node, tuple(_with(p, part, other) for p in parts)) if parts else node


def _is_of_periods(
    interval: Formula, integral: Integral, series: FourierSeries, knowledge: Knowledge
) -> bool:
    """Tell whether an interval is a whole number of periods of the lowest harmonic."""
    variable = integral.variable.name
    argument = series.waves[0][1].argument
    turn = Product((_TWO, Constant("pi"), Name(series.index), Name(variable)))
    if variable not in names(argument):
        return False
    return any(
        _is_same(Product((interval, argument)), Product((Number(Fraction(n)), turn)), knowledge)
        for n in range(1, MOST_PERIODS + 1)
    )


def _is_same(one: Formula, other: Formula, knowledge: Knowledge) -> bool:
    return decide_equality(one, other, knowledge).is_proved


def as_fourier_series(
    chain: Chain, k: int, series: list[FourierSeries], knowledge: Knowledge
) -> Decision | None:
    """Return that a relation only says what a Fourier series is; it is noted among the others."""
    own = fourier_series(chain, k, knowledge)
    if own is None:
        return None
    series.append(own)
    return Decision(DEFINITION, "a Fourier series")
