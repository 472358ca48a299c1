"""The letters of a series of harmonics or powers, as of √(1 - ε² sin²θ) = B_0 + B_2 cos 2θ + ….

Each is the coefficient of its harmonic in the other side,

    B_0 = <f>,    B_k = 2 <f cos kθ>,    < > the mean over a turn,

or, in a series of powers, of its power, less what stands there in known letters, and over what it is
multiplied by. What later lines say of it, as a series, in closed form or in numbers, is judged by that.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction

from symbalance.document.formula import (
    Formula,
    Name,
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
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra import functions
from symbalance.notes.algebra.domain import (
    Exponent,
    Monomial,
    NoFormError,
    Polynomial,
    TooLargeError,
)
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.functions import TURNING
from symbalance.notes.algebra.harmonics import HarmonicKey, components, polynomial_node
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.means import mean
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.notes.algebra.series import Expansion
from symbalance.notes.algebra.substitution_in_forms import Dependence, depends, substitute_letter
from symbalance.notes.algebra.sums import at_index, indexed_letters
from symbalance.notes.algebra.values import context, letters, sample
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision, without_dots
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge, Level
from symbalance.notes.checking.deciding.order_agreement import decide_agreement
from symbalance.notes.checking.deciding.relations import MEANT_ROUGHLY, decide
from symbalance.notes.checking.deciding.remainders import has_remainder
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.reading.equations import Side

MOST_HARMONICS = 8
"""Terms of a sum without end that are written out: letters of higher ones are seldom given."""


CONTINUED = 3
"""Letters behind the last one written that a series with dots goes on with."""


@dataclass(frozen=True, slots=True)
class _Place:
    """Where a letter stands in a series: at `function` of an angle, or a power; and times what."""

    function: str
    multiple: int
    factor: Form


def coefficient_values(
    left: Formula,
    right: Formula,
    knowledge: Knowledge,
    in_use: Collection[str] = (),
    *,
    on_page: Collection[str] = (),
    is_rough: bool = False,
) -> dict[str, Formula] | None:
    """Return the letters that a relation fixes as coefficients of a series, with their values.

    None where it is no such series: its letters are known or stand twice, or the other side is not known.
    Of a sum, Σ T_k sin kθ, these are the letters `on_page`. A series that ends has to be equal to the
    other side, unless ≈ stands between them (`is_rough`).
    """
    for series, other in ((right, left), (left, right)):
        if not _may_be_series(series):
            continue
        if not _new_letters(series, other, knowledge) or is_known_roughly(other, knowledge):
            continue
        try:
            written, is_open = _written_out(series)
            is_open = is_open or is_rough
            own = _new_letters(written, other, knowledge)
            values = _values(
                other, written, knowledge, own & {*names(series), *on_page}, on_page, is_open
            )
        except NoFormError:
            continue
        if values and _are_coefficients(values, in_use, is_open=is_open):
            return values
    return None


def _values(
    other: Formula,
    series: Formula,
    knowledge: Knowledge,
    fresh: frozenset[str],
    on_page: Collection[str],
    is_open: bool,
) -> dict[str, Formula] | None:
    """Return the letters' values, by meanings alone where these suffice: λ stays a letter then."""
    for name in _new_letters(series, other, knowledge) - fresh:  # of higher terms, on which nothing rests
        series = substitute(series, name, Number(Fraction(0)))
    defined = {n: d.node for n, d in knowledge.definitions.items() if not (d.numeric or d.assumption)}
    for level in (knowledge.meaning.values, {**defined, **knowledge.meaning.values}):
        try:
            form = _Series(other, series, fresh, knowledge, Level(level))
            values = form.values(on_page, is_open=is_open)
        except (NoFormError, TooLargeError):
            continue
        if values:
            return values
    return None


def _are_coefficients(values: Mapping[str, Formula], in_use: Collection[str], *, is_open: bool) -> bool:
    """Tell whether letters are written as coefficients: numbered, B_2 and B_4, or several that are new.

    Of a sum that ends one letter is none: P cos θ - c P cos θ is about c.
    """
    is_numbered = all(re.search(r"_\d+$", name) for name in values)
    is_new = len(values) > 1 and not set(values) & set(in_use)
    return (is_numbered and (is_open or len(values) > 1)) or is_new


def decide_coefficient(left: Side, right: Side, sign: str, knowledge: Knowledge) -> Decision:
    """Decide what a line says of a coefficient; a mean that no numbers come near refutes nothing."""
    decision = _decide_coefficient(left, right, sign, knowledge)
    form = decision.left if decision.status == REFUTED else None
    if form is None or not form.domain.opaque or sample([form], 1):
        return decision
    return Decision(UNDECIDED, "a mean over a turn that numbers do not come near")


def _decide_coefficient(left: Side, right: Side, sign: str, knowledge: Knowledge) -> Decision:
    """Decide what a line says of a coefficient: a series as far as it is written, a form, or a number.

    Letters that a line before gave numbers stay letters in a series, with the formulas they had.
    """
    is_number = not names(right.node) and not has_remainder(right.node)
    knowledge = _with_ratios_put_in(knowledge) if is_number else knowledge
    if not is_number:
        knowledge = replace(knowledge, definitions=_lettered(knowledge.definitions))
    elif open_letters := _open_letters(left.node, right.node, knowledge):
        texts = " and ".join(formula_text(Name(n), plain=True) for n in open_letters)
        return Decision(UNDECIDED, f"a number that depends on {texts}, which has none here")
    by_series = None if is_number else _by_series(left, right, sign, knowledge)
    if by_series is not None:
        return by_series
    decision = decide(left, right, sign, knowledge)
    if decision.is_proved or is_number or has_remainder(right.node):
        return decision  # O( ) says through which power: a shorter agreement proves nothing
    if decision.status == UNDECIDED or sign == "=":
        by_series = decide_agreement(left.node, right.node, knowledge)
        if by_series.is_proved and by_series.through is not None:
            return replace(by_series, reason=by_series.reason or MEANT_ROUGHLY)
        if by_series.through is not None:
            return by_series
    return decision


def _lettered(definitions: Mapping[str, Definition]) -> dict[str, Definition]:
    """Return definitions without the numbers among them; n = l/r stays where n = 3.6 came after it."""
    formulas = {n: d if not d.numeric else _formula_before(d) for n, d in definitions.items()}
    return {n: d for n, d in formulas.items() if d is not None}


def _formula_before(definition: Definition) -> Definition | None:
    node = definition.formula
    return None if node is None else replace(definition, node=node, numeric=False, assumption="")


def _by_series(left: Side, right: Side, sign: str, knowledge: Knowledge) -> Decision | None:
    """Return the decision by series where the coefficient is a mean, which is no polynomial; else None.

    To compare the two by numbers first would take many integrals.
    """
    node, is_cut = without_dots(right.node)
    level = list(knowledge.levels(left.node, node))[-1]
    try:
        form = knowledge.evaluator(level).form(left.node)
    except (NoFormError, TooLargeError):
        return None
    if not form.domain.opaque or has_remainder(right.node):
        return None
    decision = decide_agreement(left.node, right.node, knowledge, loose=is_cut, by_series_alone=True)
    if decision.through is None or not (decision.is_proved or decision.status == REFUTED):
        return None
    is_meant_roughly = decision.is_proved and sign == "=" and not is_cut
    return replace(decision, reason=MEANT_ROUGHLY) if is_meant_roughly else decision


def exact_value(decision: Decision) -> Formula:
    """Return the coefficient that a line was compared with, as a formula that is quickly evaluated."""
    form = decision.left
    if form is None or not form.domain.opaque:
        return Name("") if form is None else _node(form)
    points = sample([form], 1)
    if letters(form) or not points:
        return _node(form)
    return rational_node(Fraction(context().nstr(points[0][1][0].real, 20)))


def _with_ratios_put_in(knowledge: Knowledge) -> Knowledge:
    """Return what is known with r = 0.3 l where λ = r/l has that number, and r and l have none."""
    for d in tuple(knowledge.definitions.values()):
        ratio = d.formula
        if not d.numeric or not isinstance(ratio, Quotient):
            continue
        above, below = ratio.numerator, ratio.denominator
        if not isinstance(above, Name) or not isinstance(below, Name):
            continue
        if not {above.name, below.name} & knowledge.definitions.keys():
            part = Definition(Product((d.node, below)), d.line)
            knowledge = knowledge.with_definition(above.name, part)
    return knowledge


def _open_letters(left: Formula, right: Formula, knowledge: Knowledge) -> list[str]:
    """Return the letters of a coefficient that have no number by all that is known."""
    level = list(knowledge.levels(left, right))[-1]
    try:
        return letters(knowledge.evaluator(level).form(left))
    except (NoFormError, TooLargeError):
        return []


def _may_be_series(node: Formula) -> bool:
    """Tell whether a side is a sum, perhaps times something, with letters in it."""
    return any(isinstance(part, Sum | Summation) for part in walk(node))


def _new_letters(node: Formula, other: Formula, knowledge: Knowledge) -> frozenset[str]:
    """Return the letters of a side without a value or a meaning that the other side has not."""
    taken = names(other) | knowledge.moving | knowledge.angles
    return frozenset(n for n in names(node) - taken if not knowledge.has_meaning(n))


def is_known_roughly(node: Formula, knowledge: Knowledge) -> bool:
    """Tell whether what a side stands for is cut off or rounded: its harmonics are not those meant."""
    values = {**{n: d.node for n, d in knowledge.definitions.items()}, **knowledge.meaning.values}
    behind = {n for n in names_behind(node, values) if n not in knowledge.meaning.values}
    definitions = [knowledge.definitions[n] for n in behind if n in knowledge.definitions]
    return any(d.is_rough for d in definitions) or without_dots(node)[1]


def _written_out(node: Formula) -> tuple[Formula, bool]:
    """Return a series with its first terms written out, and whether it goes on: Σ T_k sin kθ, or dots."""
    bare, is_cut = without_dots(node)
    is_open = is_cut

    def expand(part: Formula) -> Formula:
        nonlocal is_open
        if isinstance(part, Summation) and part.index is not None:
            terms, goes_on = _terms_of(part)
            is_open = is_open or goes_on
            return Sum(terms)
        parts = children(part)
        return with_children(part, tuple(expand(p) for p in parts)) if parts else part

    return expand(bare), is_open


def _terms_of(node: Summation) -> tuple[tuple[Formula, ...], bool]:
    """Return the first terms of a sum over an index whose letters carry it, and whether more follow."""
    assert node.index is not None
    index, lower, upper = node.index.name, node.lower, node.upper
    if not indexed_letters(node.body, index) or not (lower is None or isinstance(lower, Number)):
        raise NoFormError("a sum over something else")
    first = int(lower.value) if isinstance(lower, Number) else 1
    last = int(upper.value) if isinstance(upper, Number) else first + MOST_HARMONICS - 1
    goes_on = not isinstance(upper, Number) or last >= first + MOST_HARMONICS
    last = min(last, first + MOST_HARMONICS - 1)
    numbers = [(k, Number(Fraction(k))) for k in range(first, last + 1)]
    return tuple(substitute(at_index(node.body, index, k), index, n) for k, n in numbers), goes_on


class _Series:
    """A side and the series it is said to be, as forms of one domain."""

    def __init__(
        self,
        other: Formula,
        series: Formula,
        fresh: frozenset[str],
        knowledge: Knowledge,
        level: Level,
    ) -> None:
        evaluator = knowledge.evaluator(level)
        self.knowledge, self.domain = knowledge, evaluator.domain
        self.other, self.series = evaluator.form(other), evaluator.form(series)
        self.fresh = {self.domain.symbol(name): name for name in fresh}

    def values(self, on_page: Collection[str], *, is_open: bool) -> dict[str, Formula] | None:
        """Return the letters' values, None where they are no coefficients."""
        divisor = Form.of(self.domain, self.series.denominator)
        if any(self._letters_of(m) for m in self.series.denominator):
            return None
        terms = components(self.domain, self.series.numerator)
        own: dict[int, dict[HarmonicKey, Polynomial]] = {}
        for key, number in terms.items():
            in_key = self._letters_of(key.letters)
            if not in_key:
                continue
            if len(in_key) > 1 or dict(key.letters)[in_key[0]] != 1:
                return None
            own.setdefault(in_key[0], {})[key] = number
        known = {m: c for m, c in self.series.numerator.items() if not self._letters_of(m)}
        rest = self.other.minus(Form.of(self.domain, known).over(divisor))
        if not own or not self._is_known(rest):
            return None
        forms = self._by_harmonics(own, rest, divisor, on_page if is_open else ()) or self._by_powers(
            own, rest, divisor
        )
        if forms is None:
            return None
        is_sure = is_open and not any(map(self._may_move, forms.values()))
        if not is_sure and not self._is_exact(forms):
            return None
        return {self.fresh[number]: _node(form) for number, form in forms.items()}

    def _letters_of(self, monomial: Monomial) -> list[int]:
        return [g for g, _ in monomial if g in self.fresh]

    def _is_known(self, rest: Form) -> bool:
        """Tell whether nothing in the other side moves but the angle: no force that is not put in."""
        inside, knowledge = set(letters(rest)), self.knowledge
        values = {n: d.node for n, d in knowledge.definitions.items()}
        is_circular = bool(inside & set(self.fresh.values()))
        is_moving = any(
            n not in knowledge.angles
            and (n in knowledge.moving or "/d" in n or self._moves(values.get(n), values))
            for n in inside
        )
        return not is_circular and not is_moving

    def _moves(self, node: Formula | None, values: Mapping[str, Formula]) -> bool:
        """Tell whether what a letter stands for holds an angle."""
        return node is not None and not self.knowledge.angles.isdisjoint(names_behind(node, values))

    def _may_move(self, form: Form) -> bool:
        """Tell whether all of a coefficient is times a letter that nobody declared: p of p A r sin θ."""
        factors = [{g for g, e in m if e == 1} for m in form.numerator]
        common = set.intersection(*factors) if factors else set()
        generators = self.domain.generators
        open_letters = {generators[g].content for g in common if generators[g].kind == "symbol"}
        return not open_letters <= (self.knowledge.declared | self.knowledge.meaning.constant)

    def _by_harmonics(
        self,
        own: Mapping[int, Mapping[HarmonicKey, Polynomial]],
        rest: Form,
        divisor: Form,
        on_page: Collection[str],
    ) -> dict[int, Form] | None:
        """Return the letters' values as coefficients of harmonics of one angle."""
        angles = [dict(key.angle) for keys in own.values() for key in keys if key.angle]
        turned = self._turned(angles[0], rest) if angles else None
        if turned is None:
            return None
        letter, moving, turned_rest = turned
        (base,) = {g for g in angles[0] if moving.of(g)}
        places: dict[int, _Place] = {}
        for number, keys in own.items():
            place = self._place(number, keys, (base, angles[0]), moving, divisor)
            if place is None:
                return None
            places[number] = place
        positions = [(p.function, p.multiple) for p in places.values()]
        if len(set(positions)) < len(positions):
            return None
        self._continue(places, on_page)
        turning = self.domain.symbol(TURNING)
        forms: dict[int, Form] = {}
        for number, place in places.items():
            value = mean(turned_rest, turning)
            if place.function != "1":
                wave_form = functions.apply(place.function, letter.scaled(place.multiple))
                value = mean(turned_rest.times(wave_form), turning).scaled(2)
            forms[number] = value.over(place.factor)
        return forms

    def _continue(self, places: dict[int, _Place], on_page: Collection[str]) -> None:
        """Add the letters that the dots stand for: after B_2 cos 2θ + B_4 cos 4θ the next one is B_6.

        Only where letters are numbered by their harmonics, and all stand with one sign and factor.
        """
        stems = {self.fresh[number].rpartition("_")[0] for number in places}
        multiples = [place.multiple for place in places.values()]
        is_numbered = all(
            self.fresh[number].rpartition("_")[2] == str(place.multiple)
            for number, place in places.items()
        )
        first, *others = [place for place in places.values() if place.multiple]
        is_alike = all(p.function == first.function and p.factor.equals(first.factor) for p in others)
        if len(stems) > 1 or not is_numbered or not is_alike:
            return
        top, below = max(multiples), max((m for m in multiples if m < max(multiples)), default=0)
        (stem,) = stems
        for step in range(1, CONTINUED + 1):
            multiple = top + step * (top - below)
            name = f"{stem}_{multiple}"
            if name in on_page and not self.knowledge.has_meaning(name):
                number = self.domain.symbol(name)
                self.fresh[number] = name
                places[number] = _Place(first.function, multiple, first.factor)

    def _turned(self, angle: Mapping[int, Exponent], rest: Form) -> tuple[Form, Dependence, Form] | None:
        """Return the turning angle, what tells whether a factor moves, and the side in that angle.

        θ becomes the angle itself, of ωt the time becomes angle over ω, of θ - ψ the θ angle plus ψ.
        """
        chosen = [g for g in angle if self._turning_letter(g) is not None]
        if len(chosen) > 1:
            known = self.knowledge.angles
            chosen = [
                g for g in chosen if self.domain.generators[self._turning_letter(g) or 0].content in known
            ]
        if len(chosen) != 1:
            return None
        letter = self._turning_letter(chosen[0])
        if letter is None or not depends(self.other, letter):
            return None  # a letter F that nobody has said anything of is no constant
        turning = Form.letter(self.domain, TURNING)
        shift, multiple = Form.number(self.domain, 0), angle[chosen[0]]
        for generator, exponent in angle.items():
            if generator != chosen[0]:
                content = self.domain.generators[generator].content
                inner = Form.of(self.domain, {content: Fraction(exponent) / multiple})
                shift = shift.plus(inner)
        content = self.domain.generators[chosen[0]].content
        speed = Form.of(self.domain, {tuple((g, e) for g, e in content if g != letter): Fraction(1)})
        if depends(shift, letter):
            return None
        turned = substitute_letter(rest, letter, turning.minus(shift).over(speed))
        return turning, Dependence(self.domain, letter), turned

    def _turning_letter(self, generator: int) -> int | None:
        """Return the letter of an angle that turns, None where there is none, or more than one."""
        content = self.domain.generators[generator].content
        letters_in = [g for g, e in content if e == 1 and self._may_turn(g, content)]
        return letters_in[0] if len(letters_in) == 1 else None

    def _may_turn(self, number: int, content: Monomial) -> bool:
        """Tell whether a letter in an angle is what turns: the only one, or an angle or the time."""
        generator = self.domain.generators[number]
        if generator.kind != "symbol":
            return False
        knowledge = self.knowledge
        return len(content) == 1 or generator.content in (knowledge.angles - knowledge.meaning.integer)

    def _place(
        self,
        number: int,
        keys: Mapping[HarmonicKey, Polynomial],
        axis: tuple[int, Mapping[int, Exponent]],
        moving: Dependence,
        divisor: Form,
    ) -> _Place | None:
        """Return where a letter stands, None unless it is at one harmonic, times what does not move."""
        positions = {(key.function, key.angle) for key in keys}
        if len(positions) != 1:
            return None
        ((function, angle),) = positions
        base, direction = axis
        multiple = dict(angle).get(base, 0)
        if multiple != int(multiple) or any(
            dict(angle).get(g, 0) * direction[base] != multiple * e for g, e in direction.items()
        ):
            return None
        factor = self._factor(number, keys).over(divisor)
        if moving.of_polynomial(factor.numerator) or moving.of_polynomial(factor.denominator):
            return None
        return _Place(function, int(multiple), factor)

    def _factor(self, number: int, keys: Mapping[HarmonicKey, Polynomial]) -> Form:
        """Return what a letter is multiplied by, beside its harmonic."""
        total = Form.number(self.domain, 0)
        for key, value in keys.items():
            beside = tuple(entry for entry in key.letters if entry[0] != number)
            total = total.plus(
                Form.of(self.domain, value).times(Form.of(self.domain, {beside: Fraction(1)}))
            )
        return total

    def _by_powers(
        self, own: Mapping[int, Mapping[HarmonicKey, Polynomial]], rest: Form, divisor: Form
    ) -> dict[int, Form] | None:
        """Return the letters' values as coefficients of powers of one letter."""
        if any(key.angle for keys in own.values() for key in keys) or len(own) < 2:
            return None
        for name in letters(rest):
            variable = self.domain.symbol(name)
            powers: dict[int, Fraction] = {}
            for number, keys in own.items():
                exponents = {Fraction(dict(key.letters).get(variable, 0)) for key in keys}
                if len(exponents) == 1:
                    powers[number] = exponents.pop()
            if len(powers) < len(own) or len(set(powers.values())) < len(own):
                continue
            if any(p.denominator != 1 or p < 0 for p in powers.values()):
                continue
            top = int(max(powers.values()))
            series = Expansion(self.domain, name, 1, top).of(rest).cut(top)
            if series.through < top or series.start < 0:
                continue
            forms: dict[int, Form] = {}
            for number, power in powers.items():
                beside = {
                    HarmonicKey(k.function, k.angle, tuple(e for e in k.letters if e[0] != variable)): v
                    for k, v in own[number].items()
                }
                value = series.terms.get(int(power), Form.number(self.domain, 0))
                forms[number] = value.over(self._factor(number, beside).over(divisor))
            return forms
        return None

    def _is_exact(self, forms: Mapping[int, Form]) -> bool:
        """Tell whether the series with the letters put in is the other side."""
        whole = self.series
        for number, form in forms.items():
            whole = substitute_letter(whole, number, form)
        return whole.equals(self.other) is True


def _node(form: Form) -> Formula:
    above = polynomial_node(form.domain, form.numerator)
    return (
        above if form.is_polynomial else Quotient(above, polynomial_node(form.domain, form.denominator))
    )
