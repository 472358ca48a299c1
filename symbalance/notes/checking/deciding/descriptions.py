"""Verdicts built from decisions: the verdict's word, its place, and the texts that explain it.

Where two sides differ, the difference is given coefficient by coefficient: of which term, what is
claimed, what is exact.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from traceback import format_exception

from symbalance.budgets import Budget, OverBudgetError, run_within
from symbalance.document.formula import (
    Decimal,
    Formula,
    Number,
    Quotient,
    Span,
    Upright,
    walk,
    with_parts_changed,
)
from symbalance.document.text_writer import formula_text
from symbalance.errors import fault_of
from symbalance.notes.algebra import polynomials as poly
from symbalance.notes.algebra import values
from symbalance.notes.algebra.domain import Domain, NoFormError, Polynomial, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.harmonics import components, key_node, polynomial_node, sort_keys
from symbalance.notes.algebra.number_formulas import number_node, rational_of
from symbalance.notes.algebra.values import Valuation
from symbalance.notes.algebra.zero import is_zero
from symbalance.notes.checking.deciding.equality import Decision, digits
from symbalance.notes.checking.deciding.usual_sizes import usual_witness
from symbalance.notes.checking.verdicts import (
    BAD,
    CONDITIONAL,
    DEFINITION,
    HOLDS,
    HOLDS_TO_ORDER,
    REFUTED,
    STATED,
    UNDECIDED,
    UNREADABLE,
    Difference,
    Verdict,
)
from symbalance.notes.checking.words.written_numbers import (
    MOST_DIGITS,
    WrittenNumber,
    corrected,
    has_letters,
    nearer,
    written_number,
)
from symbalance.notes.reading.equations import Chain, Explained, ReadNotes, Side, Unreadable

IN_WORDS = "a meaning in words"
"""The reason of a definition that explains a letter."""
MOST_DIFFERENCES = 12
DETAILS = Budget(2)
"""For the exact value and the differences: a line that is decided stays so without them."""
SHARE = 0.5
"""At most, of what is left of the relation's budget: the verdict and its correction need the rest."""
LARGEST_VALUE = Fraction(10) ** 60
"""Of a number that is put right in its digits."""
PREFIXES, NEARLY_SAME = (1e3, 1e6, 1e-3, 1e-6), 0.005
"""Of a unit that is wrong where the digits are right: 0.3·4442 = 1333 kN wants 1333 N."""
REAL = 1e-25
"""Relative: an imaginary part that is only rounded."""
SHORT_VALUE = 8
"""Characters of an exact value that stands beside a whole number as it is: √3/2, 7/12."""
LONGEST_VALUE = 600
"""Characters of an exact value; a longer one is left out of the report."""


def describe(document: ReadNotes, chain: Chain, k: int, decision: Decision) -> Verdict:
    """Return the verdict on a relation with its place, texts and differences; `link` is left at 1."""
    side = chain.sides[k + 1]
    line = chain.relations[k].line
    word = word_for(decision)
    bad = word in BAD
    (exact, exact_node), terms, notes = ("", None), (), chain.notes
    if bad:
        try:
            (exact, exact_node), terms = run_within(
                DETAILS, lambda: _details(decision, word, document, side, chain.sides[k]), SHARE
            )
        except OverBudgetError as problem:
            notes = (*notes, f"where the sides differ was not worked out within {problem.spent}")
    return Verdict(
        line=line,
        link=1,
        source=document.shown(side.node, side.span),
        verdict=word,
        reason=decision.reason,
        order=decision.order if word != REFUTED else "",
        assumption=", ".join(decision.assumptions) if word == CONDITIONAL else "",
        claimed=formula_text(side.node, plain=True),
        exact=exact,
        exact_node=exact_node,
        witness=usual_witness(decision) if bad else {},
        differences=terms,
        lines=source_lines(document, side, line),
        column=document.column_of(side.span[0]),
        inline=chain.inline,
        notes=notes,
        tag=chain.tag,
        span=side.span,
        node=side.node,
        decision=decision,
    )


def _details(
    decision: Decision, word: str, document: ReadNotes, side: Side, before: Side
) -> tuple[tuple[str, Formula | None], tuple[Difference, ...]]:
    """Return a decision's exact value and, if it is refuted, where the sides differ."""
    exact = exact_value(decision)
    printed = printed_value(decision, document, side, before)
    if printed is None:
        return exact, differences(decision) if word == REFUTED else ()
    claim, value, _ = printed
    if claim.place is None and not claim.unit and len(exact[0]) <= SHORT_VALUE:
        return exact, ()
    number = next((number for _, number in corrected(claim, value)), None)
    return exact if number is None else (number.text, number.written), ()


def printed_value(
    decision: Decision, document: ReadNotes, side: Side, before: Side | None
) -> tuple[WrittenNumber, Fraction, bool] | None:
    """Return the number that a right side is printed as and what it should be; None with letters.

    Also whether that is what the numbers before it make without any unit: 8600/9 = 965 lb is computed in
    pounds, where that comes nearer than in kg.
    """
    left, right, source = decision.left, decision.right, document.source(side.span)
    if left is None or right is None or not any(map(str.isdigit, source)):
        return None
    exact, claimed = _number(left), _number(right)
    claim = written_number(source, float(claimed)) if claimed else None
    if exact is None or claimed is None or claim is None:
        return None
    if before is not None and claim.factor != 1 and not has_letters(document.source(before.span)):
        try:
            bare = _number(FormEvaluator(Domain()).form(before.node))
        except (NoFormError, TooLargeError):
            bare = None
        plain = claim.without_scale()
        ratio = exact / claimed
        is_of_prefix = any(abs(ratio * size - 1) < NEARLY_SAME for size in PREFIXES)
        if bare and nearer(bare / plain.size, ratio) and not is_of_prefix:
            return plain, bare, True
    return claim, exact, False


def _number(form: Form) -> Fraction | None:
    """Return the value of a form without letters; None for 0, what is not real or beyond floats."""
    if values.letters(form):
        return None
    exact = form.rational()
    if exact is None:
        try:
            value = values.value(form, {})
        except (NoFormError, ZeroDivisionError):
            return None
        if not values.context().isfinite(value) or abs(value.imag) > abs(value) * REAL:
            return None
        exact = Fraction(str(value.real))
    return exact if exact and 1 / LARGEST_VALUE < abs(exact) < LARGEST_VALUE else None


def word_for(decision: Decision) -> str:
    """Return the verdict's word."""
    if decision.status in STATED:
        return decision.status
    if not decision.is_proved:
        return decision.status
    if decision.assumptions:
        return CONDITIONAL
    return HOLDS_TO_ORDER if decision.order else HOLDS


def source_lines(document: ReadNotes, side: Side, line: int) -> tuple[int, ...]:
    """Return the lines a relation's right side stands on."""
    last = document.line_of(max(side.span[1] - 1, side.span[0]))
    return tuple(range(line, max(last, line) + 1))


def undecided(
    document: ReadNotes, span: Span, line: int, reason: str, lines: tuple[int, ...] = ()
) -> Verdict:
    """Return the verdict on a relation that was not judged, for a reason that stands in the report."""
    return Verdict(
        line,
        1,
        document.typed(span),
        UNDECIDED,
        reason,
        lines=lines or (line,),
        column=document.column_of(span[0]),
        span=span,
        is_unjudged=True,
    )


def undecided_by_fault(
    document: ReadNotes, span: Span, line: int, problem: Exception, lines: tuple[int, ...] = ()
) -> Verdict:
    """Return the verdict on a relation whose judging failed, by a fault that is not the document's."""
    reason = f"not judged, by a fault of symbalance: {fault_of(problem)}; please report it"
    verdict = undecided(document, span, line, reason, lines)
    return replace(verdict, fault=fault_of(problem), traceback="".join(format_exception(problem)))


def with_fault(
    document: ReadNotes, chain: Chain, verdicts: list[Verdict], problem: Exception
) -> list[Verdict]:
    """Return a chain's verdicts where judging broke off: what is judged stays, the rest is undecided."""
    judged_spans = {verdict.span for verdict in verdicts}
    places = [(chain.sides[k + 1].span, relation.line) for k, relation in enumerate(chain.relations)]
    places = places or [(chain.sides[-1].span, chain.lines[0])]
    rest = [place for place in places if place[0] not in judged_spans]
    if rest:
        return [*verdicts, *(undecided_by_fault(document, span, line, problem) for span, line in rest)]
    fault, last = fault_of(problem), verdicts[-1]
    note = f"what follows may lack its letters, by a fault of symbalance: {fault}; please report it"
    traceback = last.traceback + "".join(format_exception(problem))
    return [*verdicts[:-1], replace(last, notes=(*last.notes, note), fault=fault, traceback=traceback)]


def unreadable_verdict(document: ReadNotes, part: Unreadable) -> Verdict:
    """Return the verdict on what could not be read."""
    source = document.typed(part.span)
    reason = f"column {part.column}: {part.what}; {part.remedy}"
    return Verdict(
        part.line,
        1,
        source,
        UNREADABLE,
        reason,
        lines=(part.line,),
        column=part.column,
        span=part.span,
    )


def explained_verdict(document: ReadNotes, part: Explained) -> Verdict:
    """Return the verdict on a sign that explains a letter in words, a definition."""
    return Verdict(
        part.line,
        1,
        document.typed(part.span),
        DEFINITION,
        IN_WORDS,
        lines=(part.line,),
        column=part.column,
        inline=True,
        span=part.span,
    )


# Where two sides differ


def exact_value(decision: Decision) -> tuple[str, Formula | None]:
    """Return the left side of a decision as a sum of harmonics, as text and as a formula.

    ("", None) if it has no normal form or is too long to be read.
    """
    form = decision.left
    if form is None or len(form.numerator) > 60:
        return "", None
    try:
        above = polynomial_node(form.domain, form.numerator)
        text, node = formula_text(above, plain=True), above
        if not form.is_polynomial:
            below = polynomial_node(form.domain, form.denominator)
            text, node = f"({text})/({formula_text(below, plain=True)})", Quotient(above, below)
    except (NoFormError, TooLargeError):
        return "", None
    short = with_short_numbers(node)
    if short is not node:
        text, node = formula_text(short, plain=True), short
    return (text, node) if len(text) <= LONGEST_VALUE else ("", None)


def with_short_numbers(node: Formula) -> Formula:
    """Return a formula with decimals of six digits for fractions and numbers longer than that."""
    value = rational_of(node)
    if value is not None:
        is_long = max(abs(value.numerator), value.denominator) >= 10**MOST_DIGITS
        return Decimal(f"{float(value):.{MOST_DIGITS}g}") if is_long and value.denominator != 1 else node
    return with_parts_changed(node, with_short_numbers)


def differences(decision: Decision) -> tuple[Difference, ...]:
    """Return the coefficients in which the claimed (right) side differs from the exact (left) one."""
    left, right = decision.left, decision.right
    if left is None or right is None or not (left.is_polynomial and right.is_polynomial):
        return ()
    if max(len(left.numerator), len(right.numerator)) > 400:
        return ()
    if left.rational() is not None and right.rational() is not None:
        return ()  # two numbers: the witness says it
    domain = left.domain
    exact_numbers, claimed_numbers = (
        components(domain, left.numerator),
        components(domain, right.numerator),
    )
    result: list[Difference] = []
    for key in sort_keys({**exact_numbers, **claimed_numbers}):
        exact_number, claimed_number = exact_numbers.get(key, {}), claimed_numbers.get(key, {})
        if is_zero(domain, poly.minus(exact_number, claimed_number)) is not True:
            node = key_node(domain, key)
            term = "constant" if node is None else formula_text(node, plain=True)
            (claimed_text, claimed_node), (exact_text, exact_node) = (
                number_text(domain, number) for number in (claimed_number, exact_number)
            )
            result.append(Difference(term, claimed_text, exact_text, node, claimed_node, exact_node))
    return tuple(result[:MOST_DIFFERENCES])


def number_text(domain: Domain, number: Polynomial) -> tuple[str, Formula]:
    """Return a number as text and as a formula: exact where it is short, else with 12 digits."""
    node = number_node(domain, number)
    long = any(
        isinstance(part, Number) and max(part.value.numerator, part.value.denominator) > 10**9
        for part in walk(node)
    )
    text = formula_text(node, plain=True)
    if long or (len(text) > 40 and not poly.is_rational(number)):
        text = digits(Valuation(domain, {}).polynomial(number))
        return text, rounded_number(text)
    return text, node


def rounded_number(text: str) -> Formula:
    """Return a number printed in decimals as a formula; a complex one stays as it is printed.

    >>> rounded_number("0.25").text, type(rounded_number("(1.0 + 2.0j)")).__name__
    ('0.25', 'Upright')
    """
    try:
        float(text)
    except ValueError:
        return Upright(text)
    return Decimal(text)
