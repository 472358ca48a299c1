"""Formula trees brought to normal form, with letters replaced by what they stand for."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from math import atan2, pi

from symbalance.document import formula
from symbalance.notes.algebra import conjugation, functions
from symbalance.notes.algebra.construct_rules import RULES, assume_constant, summed_in_letters
from symbalance.notes.algebra.derivatives import differentiate
from symbalance.notes.algebra.domain import Domain, NoFormError, Polynomial, TooLargeError
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.matrix_letters import Kinds
from symbalance.notes.algebra.open_sums import NOT_CONTINUED, goes_on_within
from symbalance.notes.algebra.polynomials import MOST_WORK
from symbalance.notes.algebra.roots import root, unit
from symbalance.notes.algebra.substitution_in_forms import substitute_letter
from symbalance.notes.algebra.sums import at_index, indexed_letters
from symbalance.notes.algebra.values import Valuation, letters

DEEPEST = 40
"""Definitions that use definitions, one in the other."""
DEEPEST_TREE = 150
"""Levels of one formula, its definitions put in: well below Python's limit of recursion."""
LONGEST_SUM = 400


@dataclass(frozen=True, slots=True)
class SymbolValue:
    """What the letters of a formula stand for.

    `values` replaces letters by formulas; `rates` gives, for a variable of differentiation, the letters
    that change with it and how fast; `positive` and `integer` restrict letters.
    """

    values: Mapping[str, formula.Formula] = field(default_factory=dict)
    rates: Mapping[str, Mapping[str, formula.Formula]] = field(default_factory=dict)
    positive: frozenset[str] = frozenset()
    integer: frozenset[str] = frozenset()
    ranges: Mapping[str, tuple[int, int]] = field(default_factory=dict)
    """Range of a letter's values at random points, in hundredths: a rod ratio l/r from 300 to 500."""
    constant: frozenset[str] = frozenset()
    """Letters that change with no other: sizes, speeds, what is declared constant."""
    complex: frozenset[str] = frozenset()
    """Letters that are not real: each is x + iy of two letters of its own."""
    kinds: Kinds = field(default_factory=Kinds)
    """Which letters are matrices and vectors."""
    known: Mapping[str, formula.Formula] = field(default_factory=dict)
    """All values there are, those too that `values` leaves out: what a letter may change with."""
    written: Mapping[str, formula.Formula] = field(default_factory=dict)
    """Of these, the formulas that lines and meanings give letters, and not what was solved for."""
    closes_sums: bool = False
    """Whether sums between numbers are brought to closed form too: Σ e^(2πipk/5) over five terms."""
    undeclared: frozenset[str] = frozenset()
    """Letters that nobody declared: that one does not change with a variable is an assumption."""

    def domain(self) -> Domain:
        """Return a fresh domain for formulas of this meaning."""
        return Domain(self.positive, self.integer, self.ranges)


class FormEvaluator:
    """Turns trees into forms of one domain.

    >>> half = formula.Quotient(formula.Name("s"), formula.Number(Fraction(2)))
    >>> evaluator = FormEvaluator(Domain(), SymbolValue({"s": formula.Name("d")}))
    >>> evaluator.form(half).numerator
    {((1, 1),): Fraction(1, 2)}
    """

    def __init__(self, domain: Domain, meaning: SymbolValue | None = None) -> None:
        self.domain, self.meaning = domain, meaning or SymbolValue()
        self._forms: dict[str, Form] = {}
        self._open: list[str] = []
        self._depth = 0

    def form(self, node: formula.Formula) -> Form:
        """Return the form of a formula; raises NoFormError without one, TooLargeError past the limits."""
        self._depth += 1
        try:
            if self._depth > DEEPEST_TREE:
                raise TooLargeError("parts within parts without end")
            rule = _RULES.get(type(node))
            if rule is None:
                raise NoFormError(f"a {type(node).__name__.lower()} among numbers")
            return rule(self, node)
        finally:
            self._depth -= 1

    def letter(self, name: str) -> Form:
        """Return what a letter stands for, or the letter itself; a complex one is x + iy."""
        if name in self.meaning.complex and name not in self.meaning.values:
            real, imaginary = (Form.letter(self.domain, part) for part in complex_parts(name))
            return real.plus(unit(self.domain).times(imaginary))
        if name not in self.meaning.values or name in self._open:
            return Form.letter(self.domain, name)
        if name not in self._forms:
            if len(self._open) > DEEPEST:
                raise NoFormError("definitions nested too deep")
            self._open.append(name)
            try:
                self._forms[name] = self.form(self.meaning.values[name])
            finally:
                self._open.pop()
        return self._forms[name]

    def replacing(self, name: str, value: formula.Formula) -> FormEvaluator:
        """Return an evaluator to which one more letter stands for a value: the index of a sum."""
        values = dict(self.meaning.values) | {name: value}
        inner = FormEvaluator(self.domain, replace(self.meaning, values=values))
        inner._open, inner._depth = [letter for letter in self._open if letter != name], self._depth
        return inner

    def freeing(self, name: str) -> FormEvaluator:
        """Return an evaluator to which a letter is free; what moves with time t as ωt does so still."""
        values = {other: value for other, value in self.meaning.values.items() if other != name}
        for moving, rate in self.meaning.rates.get(name, {}).items():
            values[moving] = formula.Product((rate, formula.Name(name)))
        inner = FormEvaluator(self.domain, replace(self.meaning, values=values))
        inner._open, inner._depth = [letter for letter in self._open if letter != name], self._depth
        return inner

    def counting(self, name: str) -> FormEvaluator:
        """Return an evaluator to which a letter is a whole number: the index of a sum."""
        self.domain.count(name)
        inner = FormEvaluator(self.domain, replace(self.meaning, integer=self.meaning.integer | {name}))
        inner._open, inner._depth = list(self._open), self._depth
        return inner

    def rates(self, variable: str) -> Mapping[int, Polynomial]:
        """Return the letters that change with `variable`, and their rates."""
        own = self.meaning.rates.get(variable, {})
        numbers = {self.domain.symbol(name): rate for name, rate in own.items()}
        return _Rates(self, self.domain.symbol(variable), numbers)


class _Rates(Mapping[int, Polynomial]):
    """The rates of letters, each brought to normal form when a formula has that letter."""

    def __init__(
        self, evaluator: FormEvaluator, variable: int, rates: Mapping[int, formula.Formula]
    ) -> None:
        self._evaluator, self._rates = evaluator, rates
        self._polynomials: dict[int, Polynomial] = (
            {} if variable in rates else {variable: {(): Fraction(1)}}
        )

    def __getitem__(self, number: int) -> Polynomial:
        if number not in self._polynomials:
            form = self._evaluator.form(self._rates[number])
            if not form.is_polynomial:
                raise NoFormError("a rate that is a quotient")
            self._polynomials[number] = form.numerator
        return self._polynomials[number]

    def __iter__(self) -> Iterator[int]:
        return iter({*self._rates, *self._polynomials})

    def __len__(self) -> int:
        return len({*self._rates, *self._polynomials})


def _number(evaluator: FormEvaluator, node: formula.Number) -> Form:
    return Form.number(evaluator.domain, node.value)


def _name(evaluator: FormEvaluator, node: formula.Name) -> Form:
    return evaluator.letter(node.name)


def _constant(evaluator: FormEvaluator, node: formula.Constant) -> Form:
    if node.name == "i":
        return unit(evaluator.domain)
    if node.name == "infinity":
        raise NoFormError("infinity")
    return Form.constant(evaluator.domain, node.name)


def _sum(evaluator: FormEvaluator, node: formula.Sum) -> Form:
    if goes_on_within(node):
        raise NoFormError(NOT_CONTINUED)
    total = Form.number(evaluator.domain, 0)
    terms = [term for term in node.terms if not isinstance(term, formula.Dots)]
    for term in terms or node.terms:  # of dots alone: not the number 0
        total = total.plus(evaluator.form(term))
    return total


def _product(evaluator: FormEvaluator, node: formula.Product) -> Form:
    total = Form.number(evaluator.domain, 1)
    for factor in node.factors:
        total = total.times(evaluator.form(factor))
    return total


def _quotient(evaluator: FormEvaluator, node: formula.Quotient) -> Form:
    return evaluator.form(node.numerator).over(evaluator.form(node.denominator))


def _negative(evaluator: FormEvaluator, node: formula.Negative) -> Form:
    return evaluator.form(node.operand).scaled(-1)


def _power(evaluator: FormEvaluator, node: formula.Power) -> Form:
    """Return b^x: e^x, rational powers, (-1)^x and (e^(ia))^x by rules of their own, else e^(x ln b)."""
    exponent = evaluator.form(node.exponent)
    if isinstance(node.base, formula.Constant) and node.base.name == "e":
        return functions.exponential(exponent)
    base, value = evaluator.form(node.base), exponent.rational()
    if value is not None:
        return rational_power(base, value)
    if base.rational() == -1:
        phase_exponent = unit(evaluator.domain).times(exponent)
        return functions.exponential(phase_exponent.times(Form.constant(evaluator.domain, "pi")))
    phase = functions.exponent_of(base)
    if phase is not None:
        functions.assume_whole(exponent, base)
        _assume_positive(evaluator, node)
        return functions.exponential(exponent.times(phase))
    return functions.exponential(exponent.times(functions.logarithm(base)))


def _assume_positive(evaluator: FormEvaluator, node: formula.Power) -> None:
    """Note that letters are positive for (x^a)^b = x^(ab), false for x = -1, a = 2, b = 1/2."""
    meaning, outer = evaluator.meaning, formula.names(node.exponent)
    if not isinstance(node.base, formula.Power) or (outer and outer <= meaning.integer):
        return
    for name in sorted(formula.names(node.base.base) - meaning.positive):
        evaluator.domain.assumptions[f"{name} > 0"] = None


def rational_power(base: Form, exponent: Fraction) -> Form:
    """Return base^exponent; roots other than square ones only of a single term."""
    if exponent.denominator == 1:
        return base.raised(int(exponent))
    if exponent.denominator == 2:
        return root(base).raised(exponent.numerator)
    if exponent.denominator > 60 or not base.is_polynomial or len(base.numerator) != 1:
        raise NoFormError("a root of a sum that is no square root")
    ((monomial, coefficient),) = base.numerator.items()
    number = _exact_root(coefficient, exponent.denominator)
    if number is None or any(not base.domain.generators[g].positive for g, _ in monomial):
        raise NoFormError("a root that is no square root")
    factor, power = base.domain.raised(monomial, exponent)
    return Form.of(base.domain, {power: Fraction(factor) * number**exponent.numerator})


def _exact_root(number: Fraction, degree: int) -> Fraction | None:
    """Return the positive root of a positive number where it is rational: 2 of 8, and of degree 3."""
    if number <= 0:
        return None
    roots = (
        [round(part ** (1 / degree)) for part in (number.numerator, number.denominator)]
        if (max(number.numerator, number.denominator) < 10**15)
        else [0, 0]
    )
    is_exact = roots[0] ** degree == number.numerator and roots[1] ** degree == number.denominator
    return Fraction(*roots) if is_exact else None


def _call(evaluator: FormEvaluator, node: formula.Call) -> Form:
    if node.function in ("conj", "re", "im", "arg"):
        _refuse_unknown_parts(evaluator, node)
    argument = evaluator.form(node.argument)
    if node.function == "arg":
        return _direction(argument)
    return functions.apply(node.function, argument)


def _direction(number: Form) -> Form:
    """Return the angle of a complex number, from -π to π; one with letters has none here."""
    if letters(number):
        raise NoFormError("the angle of a complex number with letters in it")
    real, imaginary = conjugation.real_part(number), conjugation.imaginary_part(number)
    at = Valuation(number.domain, {})
    across, up = (float(at.of(part).real) for part in (real, imaginary))
    if abs(across) + abs(up) < _NO_LENGTH:
        raise NoFormError("the angle of zero")
    straight = Form.constant(number.domain, "pi")
    part = Fraction(atan2(up, across) / pi).limit_denominator(_FINEST_PART)
    turned = number.times(functions.exponential(unit(number.domain).times(straight.scaled(-part))))
    if conjugation.imaginary_part(turned).is_zero():
        return straight.scaled(part)
    if abs(across) < _NO_LENGTH:
        return straight.scaled(Fraction(1 if up > 0 else -1, 2))
    slope = functions.apply("atan", imaginary.over(real))
    return slope if across > 0 else slope.plus(straight.scaled(1 if up > 0 else -1))


_FINEST_PART = 180
"""Of half a turn: angles of whole degrees are found as such."""
_NO_LENGTH = 1e-20
"""What differs beyond so many digits differs."""


def _refuse_unknown_parts(evaluator: FormEvaluator, node: formula.Call) -> None:
    """Refuse the conjugate of a bare letter that nothing says to be complex: it would be the letter."""
    inner = node.argument
    if isinstance(inner, formula.Name) and inner.name not in {
        *evaluator.meaning.values,
        *evaluator.meaning.complex,
    }:
        raise NoFormError(f"{inner.name}, of which nothing says that it is complex; declare it so")


def _derivative(evaluator: FormEvaluator, node: formula.Derivative) -> Form:
    inner, variable = node.expression, node.variable.name
    meaning = evaluator.meaning
    dependent = {*meaning.values, *meaning.rates.get(variable, ()), variable}
    if isinstance(inner, formula.Name) and inner.name not in dependent:
        _refuse_hidden_motion(evaluator, {inner.name}, variable)
        turning = {*meaning.rates, *(name for rate in meaning.rates.values() for name in rate)}
        if inner.name in meaning.positive and variable in turning:  # a size, such as ω: constant
            return Form.number(evaluator.domain, 0)
        return Form.letter(evaluator.domain, derivative_name(node))
    if variable in meaning.values and meaning.rates:
        return _by_chain_rule(evaluator, evaluator.form(inner), node)
    form, rates = evaluator.form(inner), evaluator.rates(variable)
    if not isinstance(inner, formula.Name):  # letters that are typed under the derivative
        changing = {variable, "omega", "Omega", *meaning.rates.get(variable, ())}
        typed = formula.names(inner) & set(letters(form))
        assume_constant(form, (meaning.undeclared & typed) - changing, variable)
    for _ in range(node.order):
        _refuse_open_rates(evaluator, form, variable)
        _refuse_hidden_motion(evaluator, {*letters(form)}, variable)
        form = differentiate(form, rates)
    return form


def _refuse_hidden_motion(evaluator: FormEvaluator, own: set[str], variable: str) -> None:
    """Refuse to differentiate a letter as constant that has a formula which changes: F of F = m a.

    With the formula put in, as the next choice of values does, it changes as that does.
    """
    meaning = evaluator.meaning
    changing = {variable, *meaning.rates.get(variable, ())}
    for name in sorted(own - changing & meaning.written.keys()):
        if changing.intersection(names_behind(meaning.written[name], meaning.written)):
            raise NoFormError(f"{name} changes with {variable}")


def _refuse_open_rates(evaluator: FormEvaluator, form: Form, variable: str) -> None:
    """Refuse to call constant what may change: E in dE/dt where ẋ is in it and nothing gives its motion.

    The rate of a sum in which some letters do change takes the others as constant; one in which none
    does would be zero whatever it is.
    """
    meaning = evaluator.meaning
    changing = {variable, *meaning.rates.get(variable, ())}
    own = {*letters(form)}
    open_letters = own - changing
    derivatives = sorted(name for name in open_letters if is_derivative_name(name))
    if derivatives:
        raise NoFormError(f"the rate of {derivatives[0]}, whose motion nothing gives")
    unknown = sorted(open_letters & meaning.undeclared)
    if unknown and not own & changing:
        raise NoFormError(f"a rate of {unknown[0]}, of which nothing says whether it is constant")


def _by_chain_rule(evaluator: FormEvaluator, form: Form, node: formula.Derivative) -> Form:
    """Return df/dx = (df/dt)/(dx/dt) where x itself is a motion."""
    time = next(iter(evaluator.meaning.rates))
    rates = evaluator.rates(time)
    below = differentiate(evaluator.letter(node.variable.name), rates)
    if below.is_zero():
        return _at_its_value(evaluator, node)
    for _ in range(node.order):
        _refuse_hidden_motion(evaluator, {*letters(form)}, time)
        form = differentiate(form, rates).over(below)
    return form


def _at_its_value(evaluator: FormEvaluator, node: formula.Derivative) -> Form:
    """Return df/dθ where θ is 0 or π/2: the derivative for any θ, and then at that value."""
    name = node.variable.name
    general = evaluator.freeing(name).form(node)
    return substitute_letter(general, evaluator.domain.symbol(name), evaluator.letter(name))


def complex_parts(name: str) -> tuple[str, str]:
    """Return the letters that stand for real and imaginary part of a complex letter."""
    return f"Re {name}", f"Im {name}"


def derivative_name(node: formula.Derivative) -> str:
    """Return the letter that stands for the derivative of an unknown letter.

    >>> derivative_name(formula.Derivative(formula.Name("S"), formula.Name("t"), 2))
    'd2S/dt2'
    """
    order = "" if node.order == 1 else str(node.order)
    inner = node.expression.name if isinstance(node.expression, formula.Name) else "(...)"
    return f"d{order}{inner}/d{node.variable.name}{order}"


def is_derivative_name(name: str) -> bool:
    """Tell whether a letter stands for the derivative of another one.

    >>> is_derivative_name("d2S/dt2"), is_derivative_name("d")
    (True, False)
    """
    return name.startswith("d") and "/d" in name


def _summation(evaluator: FormEvaluator, node: formula.Summation) -> Form:
    """Return a sum written out between whole bounds; without bounds, a function of its body."""
    if node.index is None or node.lower is None or node.upper is None:
        return functions.opaque("sum", evaluator.form(node.body))
    lower, upper = (evaluator.form(bound).rational() for bound in (node.lower, node.upper))
    if lower is None or upper is None or evaluator.meaning.closes_sums:
        return summed_in_letters(evaluator, node)
    if not lower.denominator == upper.denominator == 1:
        raise NoFormError("a sum without bounds in whole numbers")
    if upper - lower > LONGEST_SUM:
        raise NoFormError("a sum of very many terms")
    evaluator.domain.work += 100 * int(upper - lower)
    if evaluator.domain.work > MOST_WORK:
        raise TooLargeError("sums of very many terms")
    total = Form.number(evaluator.domain, 0)
    index = node.index.name
    is_indexed = any(n not in evaluator.meaning.values for n in indexed_letters(node.body, index))
    for value in range(int(lower), int(upper) + 1):
        inner = evaluator.replacing(index, formula.Number(Fraction(value)))
        total = total.plus(inner.form(at_index(node.body, index, value) if is_indexed else node.body))
    return total


def _dots(evaluator: FormEvaluator, node: formula.Dots) -> Form:
    raise NoFormError("dots alone")


_RULES: dict[type, Callable[[FormEvaluator, formula.Formula], Form]] = {
    formula.Number: _number,
    formula.Name: _name,
    formula.Constant: _constant,
    formula.Sum: _sum,
    formula.Product: _product,
    formula.Quotient: _quotient,
    formula.Negative: _negative,
    formula.Power: _power,
    formula.Call: _call,
    formula.Derivative: _derivative,
    formula.Summation: _summation,
    formula.Dots: _dots,
    **RULES,
}  # type: ignore[assignment]
