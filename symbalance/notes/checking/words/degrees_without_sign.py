"""Angles in degrees without a sign, as in cos(t) + cos(t+120) + cos(t+240) = 0 and sin 30 = 0.5.

In mathematics a bare number is in radians, in mails and forums often not. Where the numbers within sines
and cosines are angles of engines in degrees (whole multiples of 15, 22.5, 36, 40, 72 or 360/7), the page
is judged in both, and taken in degrees throughout if that makes more of it right, or if neither does and
nothing speaks for radians. The report says so. Where only the other unit makes a line true, and the
page does not show in which it is meant, the line is undecided.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from functools import partial
from math import prod

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Name,
    Negative,
    Number,
    Product,
    Quotient,
    Sum,
    children,
    names,
    walk,
    with_children,
    with_parts_changed,
)
from symbalance.notes.checking.verdicts import (
    CONDITION,
    CONTRADICTION,
    FAILING,
    PROVED_WORDS,
    REFUTED,
    UNDECIDED,
    Checked,
    Verdict,
)
from symbalance.notes.checking.words.bare_degrees import MORE_THAN_A_TURN, with_bare_degrees
from symbalance.notes.checking.words.written_degrees import degrees_of
from symbalance.notes.reading.equations import Chain, ReadNotes, Side
from symbalance.text import lazy_patterns as re

_TURNED = ("sin", "cos", "tan", "cot", "sec", "csc")
_INVERSE = ("asin", "acos", "atan", "arg")
_STEPS = (Fraction(15), Fraction(45, 2), Fraction(36), Fraction(40), Fraction(72))
_SEVENTH = Fraction(360, 7)
_LEAST = 15
_WORD = re.compile(
    r"°|º|\\circ(?![A-Za-z])|(?<![A-Za-z-])(?:deg|degs?\.|degrees?|Grad|grados|gradi|degrés?)(?![A-Za-z])(?!\s+of\b)"
    r"|[0-9]\s*度"
)
"""What says that a page counts some angle in degrees; degrees of freedom are none."""
_PROGRAM = re.compile(r"(?:math|np|numpy|cmath|Math|mp|sp|sympy|torch|jnp)\.$")
"""What stands before the name of a function that is a program's, and takes radians."""
_COMMANDS = re.compile(r"\\(?:[dt]?frac|cdot|times|left|right|[,;: ])")
_RADIANS = re.compile(r"(?<![A-Za-z])rad(?:ians?)?(?![A-Za-z])")

IN_DEGREES = "angles without a sign are read in degrees: cos(t + 120) is cos(t + 120°)"
IN_RADIANS = "angles without a sign are read in radians"


def judge_in_one_unit_of_angle(document: ReadNotes, judge: Callable[[ReadNotes], Checked]) -> Checked:
    """Return the verdicts on a document in which bare angles are all in degrees, or all in radians."""
    typed = _as_typed(document)
    page = _Angles(typed)
    if not page.has_usual_angle:
        return judge(with_bare_degrees(document))
    radians, degrees = judge(typed), judge(page.in_degrees())
    gained, lost = _proved_only_in(degrees, radians), _proved_only_in(radians, degrees)
    says_degrees = page.is_within_functions and (not page.has_pi or page.says_degrees)
    is_shown = gained > lost
    if not is_shown and (lost or not says_degrees):
        if not _differ(radians, degrees):
            return radians
        return _with_note(_softened(radians, degrees, "degrees"), IN_RADIANS)
    note = (
        partial(_noted, other=radians)
        if is_shown
        else partial(_softened_verdict, other=radians, unit="radians")
    )
    verdicts = tuple(map(note, degrees.verdicts))
    return _with_note(replace(degrees, verdicts=verdicts), IN_DEGREES)


def _as_typed(document: ReadNotes) -> ReadNotes:
    """Return a page without the second readings of its sides that put degrees where no sign stands."""

    def side_as_typed(side: Side) -> Side:
        typed = tuple(node for node in side.readings if not any(map(_is_unsaid, walk(node))))
        return replace(side, readings=typed) if typed and len(typed) < len(side.readings) else side

    chains = (replace(c, sides=tuple(map(side_as_typed, c.sides))) for c in document.chains)
    return replace(document, chains=tuple(chains))


def _is_unsaid(node: Formula) -> bool:
    """Tell whether a number is one of degrees by a reading only: its unit stands where it does itself."""
    if not isinstance(node, Product) or degrees_of(node) is None:
        return False
    return node.factors[0].span == node.factors[-1].span


class _Angles:
    """The angles of a page that are numbers without a sign."""

    def __init__(self, document: ReadNotes) -> None:
        self.document = document
        self.calls = [
            part
            for chain in document.chains
            for side in chain.sides
            for reading in side.readings
            for part in walk(reading)
            if isinstance(part, Call) and part.function in _TURNED and self._is_of_page(part)
        ]
        self.angles = frozenset(n for call in self.calls for n in _angle_letters(call.argument))
        within = [value for call in self.calls for value in _bare_angles(call.argument)]
        given = [value for chain in document.chains for value in self._values_given(chain)]
        self.is_within_functions = any(map(_is_usual, within))
        """Whether a sine or cosine holds such a number, not only a letter that has it as its value."""
        self.has_usual_angle = self.is_within_functions or any(map(_is_usual, given))
        self.has_pi = any(_has_pi(call.argument) for call in self.calls)
        self.says_degrees = _WORD.search(document.text) is not None

    def _is_of_page(self, call: Call) -> bool:
        """Tell whether a function is the author's, not math.cos of a program, nor cos(2 rad)."""
        first, last = call.span
        text = self.document.text
        if _RADIANS.search(text, first, last):
            return False
        return _PROGRAM.search(text[max(0, first - 8) : first]) is None

    def _values_given(self, chain: Chain) -> Iterator[Fraction]:
        """Yield the numbers that a chain gives a letter of an angle: A = 60."""
        if self._gives_angle(chain):
            for side in chain.sides[1:]:
                value = _rational(side.node)
                if value is not None and not self._has_unit(side):
                    yield value

    def _gives_angle(self, chain: Chain) -> bool:
        head = chain.sides[0].node
        return isinstance(head, Name) and head.name in self.angles

    def _has_unit(self, side: Side) -> bool:
        """Tell whether a side has a unit or letters: 45 mm is no angle, 45 and 360/7 may be."""
        written = _COMMANDS.sub("", self.document.text[side.span[0] : side.span[1]])
        return re.search(r"[^\W\d_]|[°º%'′]", written) is not None

    def in_degrees(self) -> ReadNotes:
        """Return the page with its bare angles in degrees."""
        return replace(self.document, chains=tuple(map(self._chain, self.document.chains)))

    def _chain(self, chain: Chain) -> Chain:
        gives_angle = self._gives_angle(chain)
        is_inverse = any(_is_inverse(side.node) for side in chain.sides)
        sides = []
        for place, side in enumerate(chain.sides):
            readings = tuple(map(self._within_functions, side.readings))
            if any(map(_has_small_number, side.readings)):
                readings = (*readings, *side.readings)
            is_value = (gives_angle and place) or is_inverse
            if (
                is_value
                and not names(side.node)
                and not _is_inverse(side.node)
                and not self._has_unit(side)
            ):
                readings = tuple(map(_as_angle, readings))
            sides.append(replace(side, readings=readings))
        return replace(chain, sides=tuple(sides))

    def _within_functions(self, node: Formula) -> Formula:
        """Return a formula with the bare numbers in its sines and cosines as degrees."""
        if isinstance(node, Call) and node.function in _TURNED and self._is_of_page(node):
            return replace(node, argument=_as_angle(self._within_functions(node.argument)))
        return with_parts_changed(node, self._within_functions)


def _has_small_number(node: Formula) -> bool:
    """Tell whether a function is of a number below a turn in radians, cos 2: it may be either there."""
    calls = (part for part in walk(node) if isinstance(part, Call) and part.function in _TURNED)
    values = (_rational(call.argument) for call in calls)
    return any(value is not None and 0 < abs(value) < MORE_THAN_A_TURN for value in values)


def _as_angle(node: Formula) -> Formula:
    """Return an angle with its bare numbers as degrees: 2(t + 120) as 2(t + 120°)."""
    if degrees_of(node) is not None or _has_pi_of_its_own(node):
        return node
    if not names(node):
        return node if _rational(node) in (None, 0) else _degrees(node)
    if isinstance(node, Product):
        factors = tuple(_as_angle(f) if isinstance(f, Sum) and names(f) else f for f in node.factors)
        return replace(node, factors=factors)
    if isinstance(node, Quotient):
        is_angle = not names(node.denominator) or _rational(node.numerator) is not None  # 360/N
        return replace(node, numerator=_as_angle(node.numerator)) if is_angle else node
    if isinstance(node, Sum | Negative):
        return with_children(node, tuple(map(_as_angle, children(node))))
    return node


def _degrees(node: Formula) -> Formula:
    """Return n as n π/180, the unit at its end as where the sign ° would stand."""
    if isinstance(node, Number) and node.last_place is not None:
        sevenths = round(node.value / _SEVENTH) * _SEVENTH
        if 2 * abs(node.value - sevenths) <= node.last_place:
            node = Number(sevenths, span=node.span)  # 51.43 is 360/7
    place = (node.span[1], node.span[1])
    half_turn = Number(Fraction(180), span=place)
    return Product((node, Quotient(Constant("pi", span=place), half_turn, span=place)), span=node.span)


def _bare_angles(node: Formula) -> Iterator[Fraction]:
    """Yield the numbers that stand alone in an angle: 120 of 2(t + 120), 240 of 2·120."""
    if degrees_of(node) is not None:
        return
    if not names(node):
        value = _rational(node)
        if value is not None:
            yield value
    elif isinstance(node, Sum):
        for term in node.terms:
            yield from _bare_angles(term)
    elif isinstance(node, Negative):
        yield from _bare_angles(node.operand)
    elif isinstance(node, Quotient):
        yield from _bare_angles(node.numerator)
    elif isinstance(node, Product):
        for factor in node.factors:
            if isinstance(factor, Sum):
                yield from _bare_angles(factor)


def _angle_letters(node: Formula) -> Iterator[str]:
    """Yield the letters that are angles themselves: t of 2t - 30, no letter of w t."""
    if isinstance(node, Name):
        yield node.name
    elif isinstance(node, Sum):
        for term in node.terms:
            yield from _angle_letters(term)
    elif isinstance(node, Negative):
        yield from _angle_letters(node.operand)
    elif isinstance(node, Quotient) and not names(node.denominator):
        yield from _angle_letters(node.numerator)
    elif isinstance(node, Product):
        with_letters = [factor for factor in node.factors if names(factor)]
        if len(with_letters) == 1:
            yield from _angle_letters(with_letters[0])


def _rational(node: Formula) -> Fraction | None:
    """Return what a formula of numbers alone is, None for one with π, a root or a letter."""
    if isinstance(node, Number):
        return node.value
    values = [_rational(part) for part in children(node)]
    numbers = [value for value in values if value is not None]
    if not isinstance(node, Sum | Product | Quotient | Negative) or len(numbers) < len(values):
        return None
    if isinstance(node, Quotient):
        return numbers[0] / numbers[1] if numbers[1] else None
    if isinstance(node, Product):
        return prod(numbers, start=Fraction(1))
    return -numbers[0] if isinstance(node, Negative) else sum(numbers, start=Fraction(0))


def _is_usual(value: Fraction) -> bool:
    """Tell whether a number is an angle of engines in degrees: 15, 67.5, 72, 51.43."""
    size = abs(value)
    if size < _LEAST:
        return False
    turns = round(size / _SEVENTH)
    return any((size / step).denominator == 1 for step in _STEPS) or abs(
        size - turns * _SEVENTH
    ) < Fraction(1, 100)


def _has_pi(node: Formula) -> bool:
    """Tell whether π stands in an angle as a number beside its letters, no 2π in front of one."""
    if degrees_of(node) is not None:
        return False
    if not names(node):
        return _has_pi_of_its_own(node)
    if isinstance(node, Sum | Negative):
        return any(map(_has_pi, children(node)))
    return isinstance(node, Product) and any(_has_pi(f) for f in node.factors if isinstance(f, Sum))


def _has_pi_of_its_own(node: Formula) -> bool:
    """Tell whether a number is one with π: it is in radians."""
    return not names(node) and any(isinstance(p, Constant) and p.name == "pi" for p in walk(node))


def _is_inverse(node: Formula) -> bool:
    bare = node.operand if isinstance(node, Negative) else node
    return isinstance(bare, Call) and bare.function in _INVERSE


# The two ways of judging


def _pairs(first: Checked, second: Checked) -> Iterator[tuple[Verdict, Verdict]]:
    others = {(v.line, v.link): v for v in second.verdicts}
    for verdict in first.verdicts:
        other = others.get((verdict.line, verdict.link))
        if other is not None:
            yield verdict, other


def _proved_only_in(first: Checked, second: Checked) -> int:
    """Return how many relations one way of judging proves and the other does not, though they claim."""
    not_proved = (*FAILING, CONDITION)  # 1 + cos(t + 120) = 0 is an equation for t in radians
    return sum(
        v.verdict in PROVED_WORDS and other.verdict in not_proved for v, other in _pairs(first, second)
    )


def _differ(first: Checked, second: Checked) -> bool:
    return any(v.verdict != other.verdict for v, other in _pairs(first, second))


def _softened(checked: Checked, other: Checked, unit: str) -> Checked:
    verdicts = tuple(_softened_verdict(v, other=other, unit=unit) for v in checked.verdicts)
    return replace(checked, verdicts=verdicts)


def _softened_verdict(verdict: Verdict, *, other: Checked, unit: str) -> Verdict:
    """Return a verdict that accuses nothing which is true in the other unit."""
    elsewhere = next(
        (v for v in other.verdicts if (v.line, v.link) == (verdict.line, verdict.link)), None
    )
    if verdict.verdict not in (REFUTED, CONTRADICTION) or elsewhere is None:
        return verdict
    if elsewhere.verdict not in PROVED_WORDS:
        return verdict
    sign = "write 120°" if unit == "degrees" else "write 2 rad"
    reason = f"true with its angles in {unit}, and the page does not say in which they are: {sign}"
    return replace(verdict, verdict=UNDECIDED, reason=reason, fix=None, witness={}, differences=())


def _noted(verdict: Verdict, *, other: Checked) -> Verdict:
    """Return a refuted verdict with the note that a calculator set to radians gives its number."""
    elsewhere = next(
        (v for v in other.verdicts if (v.line, v.link) == (verdict.line, verdict.link)), None
    )
    if verdict.verdict == REFUTED and elsewhere is not None and elsewhere.verdict in PROVED_WORDS:
        note = "with its angles in radians it would hold: a calculator that was set to radians?"
        return replace(verdict, notes=(*verdict.notes, note))
    return verdict


def _with_note(checked: Checked, note: str) -> Checked:
    derivation = checked.derivation
    return replace(checked, derivation=replace(derivation, notes=(*derivation.notes, note)))
