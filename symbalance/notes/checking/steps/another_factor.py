"""Formulas and numbers with another factor or sign than an equation above has: which of the two is wrong?

m_A r_A b = √3 m r a stands above, and m_A r_A = (√3/2)·0.48·0.043·0.082/0.29 has the same sizes at the
same places. Where nothing proves the formula, its letters are no better witness than the numbers: one of
the two lines is wrong. A number that is none of the page's is a slip of the numbers, and so is a size
left out. So too where B b = (2M + m) r stands above and B = (M + m) r/b below, unless an arrow says that
the second comes from the first.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from itertools import product as combinations_of

from symbalance.document.formula import Formula, Name, Negative, Number, Power, Sum, names, walk
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator
from symbalance.notes.algebra.harmonics import split
from symbalance.notes.checking.deciding.equality import UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge, Level
from symbalance.notes.checking.deciding.numbers_put_in import is_lone_number
from symbalance.notes.checking.deciding.substitution import replace_part
from symbalance.notes.checking.premises.carried_values import ONE_IS_WRONG
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.premises.system import Premise, lines_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

MOST_CHOICES = 64
"""Ways to take numbers for letters, where letters have the same one."""
_LEAST_TERMS = 2
"""Of an equation that is solved by a division alone: the letter's term, and one other."""
MOST_PLAIN = 12
"""A whole number up to this counts something, or is a factor: 2, 1/2, √3."""
_SCALES = (1.0, 1e-3, 1e3, 1e-2, 1e2, 1e-6, 1e6, 180 / math.pi)
"""A value in mm, g or degrees is put in as it is typed."""
_MULTIPLES = (1.0, 0.5, 2.0)
"""Half a mass, and the diameter of a radius, are put in as one number."""
_ROUNDING = 1 + 1e-9
_ARROW = re.compile(
    r"\\(?:Long|long)?(?:[Ll]eft)?[Rr]ightarrow|\\(?:implies|iff|to)(?![A-Za-z])|[⇒→⇔⟹]|=>"
)
_DIGITS = re.compile(r"[0-9]+(?:[.,][0-9]+)?")

_Terms = frozenset[tuple[tuple[int, object], ...]]


def put_in_with_another_factor(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return that an arithmetic differs from an unproved formula above in a factor or sign, or None."""
    left, side = chain.sides[k].node, chain.sides[k + 1]
    if k or not names(left) or names(side.node) or is_lone_number(side.node):
        return None
    printed = state.results.with_formulas(side)
    arithmetics = [side.node] if printed is None else [side.node, printed.node]
    evaluator = knowledge.evaluator(Level({}))
    for above in formulas_only_stated(state, chain, knowledge):
        own = sorted(above.names - names(left))
        wanted = _terms(above.left, above.right, evaluator)
        if not own or wanted is None:
            continue
        words = state.sections.sentence_before(chain)
        values = {name: [*_values_of(state, name, knowledge)] for name in own}
        choices = (c for right in arithmetics for c in _with_letters(right, values, above, words))
        for put_in in choices:
            if names(put_in) == set(own) and _terms(left, put_in, evaluator) == wanted:
                reason = f"has another factor or sign than {lines_of([above])}, which nothing proves"
                return Decision(UNDECIDED, f"{reason}: {ONE_IS_WRONG}")
    return None


def fixed_with_another_factor(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return that a letter's formula differs from what an unproved equation above fixes, or None.

    Of a sum they differ in the numbers of some terms alone: nothing says that the slip is in the second
    one. A single term may be solved wrongly, and then it is the second that is wrong.
    """
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    if k or not isinstance(left, Name) or not names(right) or chain.relations[0].sign != "=":
        return None
    definition = knowledge.definitions.get(left.name)
    if definition is None or not definition.solved or definition.alternatives or definition.numeric:
        return None
    above = [
        c
        for c in state.sections.chains_on(definition.line)
        if left.name in c.letters and c.start < chain.start and c.sides[-1].span[0] in state.stated
    ]
    if not above or _ARROW.search(state.document.text[above[-1].end : chain.start]):
        return None
    evaluator = knowledge.evaluator(Level({}))
    wanted = _terms(left, definition.node, evaluator)
    is_sum = wanted is not None and len(wanted) > _LEAST_TERMS
    if not is_sum or _terms(left, right, evaluator) != wanted:
        return None
    equation = " = ".join(plain_text(side.node) for side in above[-1].sides)
    here = f"{equation} of line {definition.line}"
    return Decision(UNDECIDED, f"contradicts {here}, which nothing proves: {ONE_IS_WRONG}")


def formulas_only_stated(state: JudgingState, chain: Chain, knowledge: Knowledge) -> Iterator[Premise]:
    """Yield the equations above, only stated there, in which all letters of a left side stand."""
    left = chain.sides[0].node
    if isinstance(left, Name) and (definition := knowledge.definitions.get(left.name)) is not None:
        node = definition.node if definition.formula is None else definition.formula
        if names(node) and node.span[0] in state.stated:
            yield Premise(left, node, definition.line)
    for premise in state.definitions.premises_at(chain.lines[0]):
        is_formula = names(left) < premise.names and premise.line < chain.lines[0]
        if is_formula and premise.right.span[0] in state.stated:
            yield premise


def _values_of(state: JudgingState, name: str, knowledge: Knowledge) -> Iterator[float]:
    """Yield the numbers that a letter has: by all that is known, and as the page printed it."""
    _, printed = state.results.numbers.get(name, (0, []))
    for node in (Name(name), *printed):
        value = number_of(node, knowledge)
        if value is not None:
            yield abs(float(value))


def _with_letters(
    right: Formula, values: dict[str, list[float]], above: Premise, words: str
) -> Iterator[Formula]:
    """Yield an arithmetic with a formula's letters for the numbers that may stand for them.

    Another engine's number stands in the words before: in the 52° twins. Nothing comes of a number that
    is neither a letter's, nor a plain factor, nor in the formula itself.
    """
    constants = {
        p.value for side in (above.left, above.right) for p in walk(side) if isinstance(p, Number)
    }
    in_words = {Fraction(digits.replace(",", ".")) for digits in _DIGITS.findall(words)}
    exponents = {id(part.exponent) for part in walk(right) if isinstance(part, Power)}
    places: list[Number] = []
    choices: list[list[str]] = []
    for part in walk(right):
        if not isinstance(part, Number) or id(part) in exponents:
            continue
        fitting = [name for name, sizes in values.items() if any(_is_of(part, size) for size in sizes)]
        is_plain = part.value in constants or _is_plain(part)
        if not fitting and not is_plain and part.value in in_words:
            fitting = [*values]
        if fitting:
            places.append(part)
            choices.append([*fitting, *([""] if is_plain else [])])
        elif not is_plain:
            return
    if math.prod(len(each) for each in choices) > MOST_CHOICES:
        return
    for chosen in combinations_of(*choices):
        node = right
        for part, name in zip(places, chosen, strict=True):
            node = replace_part(node, part, Name(name)) if name else node
        yield node


def _is_of(number: Number, size: float) -> bool:
    """Tell whether a number is a letter's value, to its digits and in some unit, or half or twice it."""
    typed = abs(float(number.value))
    half = float(number.last_place) / 2 if number.last_place is not None else typed * 1e-9
    near = max(half, typed * 1e-9) * _ROUNDING
    return bool(typed) and any(
        abs(size * scale * multiple - typed) <= near for scale in _SCALES for multiple in _MULTIPLES
    )


def _is_plain(number: Number) -> bool:
    """Tell whether a number is a small whole one, a simple fraction or a power of ten."""
    top, bottom = abs(number.value.numerator), number.value.denominator
    is_small = max(top, bottom) <= MOST_PLAIN
    is_of_ten = 1 in (top, bottom) and set(str(max(top, bottom))) <= {"1", "0"}
    return number.last_place is None and (is_small or is_of_ten)


def _terms(left: Formula, right: Formula, evaluator: FormEvaluator) -> _Terms | None:
    """Return the letters and waves of the terms of an equation, without their numbers; None for none.

    A power that all terms have is left out: m_c = r m/ρ and m_c ρ = m r are one equation.
    """
    try:
        form = evaluator.form(Sum((left, Negative(right))))
    except (NoFormError, TooLargeError):
        return None
    terms, generators = [], form.domain.generators
    for monomial in form.numerator:
        _, angle, letters = split(form.domain, monomial)
        powers = {g: e for g, e in (*angle, *letters) if generators[g].kind != "constant"}
        terms.append(powers)
    least = {g: min(term.get(g, 0) for term in terms) for term in terms for g in term}
    return frozenset(
        tuple(sorted((g, term.get(g, 0) - low) for g, low in least.items() if term.get(g, 0) != low))
        for term in terms
    )
