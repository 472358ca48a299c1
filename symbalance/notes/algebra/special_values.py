"""Values of whole numbers at which a closed form does not hold: the sum of one unit vector is not 0.

    Σ_{k=0}^{N-1} e^(2πipk/N) = 0   where N does not divide p,      ∫_0^{2π} cos kφ dφ = 0   where k ≠ 0

Each is noted with the form as an assumption in words, and beside it as a letter's value, at which a
relation can be decided apart.
"""

from __future__ import annotations

from fractions import Fraction
from math import lcm

from symbalance.document.formula import Formula, Name, Negative, Number, Product, Sum
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.domain import HALF, ONE, Domain, Exponent, Monomial, Polynomial
from symbalance.notes.algebra.forms import Form

ANY_WHOLE = "any whole number"
"""The letter that p is N times of, where N divides p: no written letter has a blank in its name."""
MOST_DIVISORS = 1000
"""Of a number whose divisors are looked for one by one: the order of a harmonic."""

SpecialValue = tuple[str, Formula]
"""A letter, and the value of it at which a form does not hold."""


def note_that_terms_differ(ratio: Form, otherwise: str) -> None:
    """Note for which values of its letters the ratio of a geometric sum's terms is not 1.

    Those are whole numbers in e^(2πip/N); for other ratios the assumption in words `otherwise` is noted.
    """
    domain = ratio.domain
    turns = _turns(ratio)
    if turns is None:
        domain.assumptions[otherwise] = None
        return
    above, below, scale = _as_quotient(turns)
    if not below and not any(above):
        return  # a number of turns, which is not whole: the ratio is known not to be 1
    is_large = not any(above) and abs(above.get(ONE, 0)) > MOST_DIVISORS
    if len(below) > 1 or set(below.values()) - {1} or is_large:
        domain.assumptions[otherwise] = None
        return
    letters = [domain.generators[g].content for g in below]
    if not any(above):
        _note_divisors(domain, letters[0], int(above.get(ONE, 0)), scale)
        return
    factors = [*([Number(Fraction(scale))] if scale > 1 else []), *map(Name, letters)]
    _note_multiples(domain, above, factors[0] if len(factors) == 1 else Product(tuple(factors)))


def _turns(ratio: Form) -> Polynomial | None:
    """Return x where a form is e^(2πix) with x of whole numbers, None where it is not."""
    if not ratio.is_polynomial or len(ratio.numerator) != 1:
        return None
    domain = ratio.domain
    pi = domain.constant("pi")
    ((monomial, coefficient),) = ratio.numerator.items()
    if abs(coefficient) != 1:
        return None
    turns: Polynomial = {ONE: HALF} if coefficient == -1 else {}
    for number, exponent in monomial:
        generator = domain.generators[number]
        if generator.kind == "turn":
            rest, size = ONE, Fraction(exponent)
        elif generator.kind == "exponential" and (pi, 1) in generator.content:
            rest = tuple(pair for pair in generator.content if pair != (pi, 1))
            size = Fraction(exponent) / 2
        else:
            return None
        if not all(_is_whole(domain, g) and Fraction(e).denominator == 1 for g, e in rest):
            return None
        turns[rest] = turns.get(rest, Fraction(0)) + size
    for rest, size in turns.items():
        if all(e > 0 for _, e in rest):
            turns[rest] = size - round(size)  # 5p/6 turns are -p/6, p whole
    return {m: c for m, c in turns.items() if c}


def _is_whole(domain: Domain, number: int) -> bool:
    generator = domain.generators[number]
    return generator.kind == "symbol" and generator.content in domain.integer


def _as_quotient(turns: Polynomial) -> tuple[Polynomial, dict[int, int], int]:
    """Return what stands above, and below it the letters with their powers, and a number."""
    powers: dict[int, int] = {}
    for monomial in turns:
        for g, e in monomial:
            powers[g] = max(powers.get(g, 0), -int(e))
    scale = lcm(*(c.denominator for c in turns.values()))
    above: Polynomial = {}
    for monomial, coefficient in turns.items():
        exponents: dict[int, Exponent] = dict(monomial)
        for g, power in powers.items():
            exponents[g] = exponents.get(g, 0) + power
        key = tuple(sorted((g, e) for g, e in exponents.items() if e))
        above[key] = above.get(key, Fraction(0)) + coefficient * scale
    return above, {g: power for g, power in powers.items() if power}, scale


def _note_divisors(domain: Domain, letter: str, number: int, scale: int) -> None:
    """Note for p/(sN) turns, p and s numbers, that N is none of those of which they are whole."""
    for divisor in range(1, abs(number) + 1):
        if number % (divisor * scale) == 0:
            note(domain, letter, Number(Fraction(divisor)))


def _note_multiples(domain: Domain, above: Polynomial, divisor: Formula) -> None:
    if all(coefficient < 0 for coefficient in above.values()):
        above = {monomial: -coefficient for monomial, coefficient in above.items()}
    text = formula_text(_whole_node(domain, above), plain=True)
    condition = f"{text} is no multiple of {formula_text(divisor, plain=True)}"
    domain.assumptions[condition] = None
    solved = _solved(domain, above)
    if solved is not None:
        letter, rest = solved
        value = Product((Name(ANY_WHOLE), divisor))
        domain.special[condition] = letter, value if rest is None else Sum((rest, value))


def _solved(domain: Domain, above: Polynomial) -> tuple[str, Formula | None] | None:
    """Return a letter that stands alone in a sum of whole numbers, and what the others come to."""
    for monomial, coefficient in sorted(above.items()):
        if len(monomial) == 1 and monomial[0][1] == 1 and abs(coefficient) == 1:
            number = monomial[0][0]
            others = {m: -c / coefficient for m, c in above.items() if m != monomial}
            if all(g != number for m in others for g, _ in m):
                name = domain.generators[number].content
                return name, _whole_node(domain, others) if others else None
    return None


def _whole_node(domain: Domain, polynomial: Polynomial) -> Formula:
    """Return a polynomial in letters as a formula, positive terms first."""
    ordered = sorted(polynomial.items(), key=lambda item: (item[1] < 0, item[0]))
    terms = [_term(domain, monomial, coefficient) for monomial, coefficient in ordered]
    return terms[0] if len(terms) == 1 else Sum(tuple(terms))


def _term(domain: Domain, monomial: Monomial, coefficient: Fraction) -> Formula:
    factors: list[Formula] = [
        Name(domain.generators[g].content) for g, e in monomial for _ in range(int(e))
    ]
    if abs(coefficient) != 1 or not factors:
        factors.insert(0, Number(abs(coefficient)))
    node = factors[0] if len(factors) == 1 else Product(tuple(factors))
    return Negative(node) if coefficient < 0 else node


def note_that_not_zero(form: Form, text: str) -> None:
    """Note the value of a letter at which a form of whole numbers is 0: n of m - n, beside its text."""
    domain = form.domain
    polynomial = {
        tuple((g, e) for g, e in m if domain.generators[g].kind not in ("turn", "constant")): c
        for m, c in form.numerator.items()
    }
    if not all(_is_whole(domain, g) and e == 1 for m in polynomial for g, e in m):
        return
    solved = _solved(domain, _with_unit_content(polynomial))
    if solved is not None:
        letter, rest = solved
        domain.special[text] = letter, Number(Fraction(0)) if rest is None else rest


def _with_unit_content(polynomial: Polynomial) -> Polynomial:
    least = min(abs(c) for c in polynomial.values())
    return {m: c / least for m, c in polynomial.items()}


def note(domain: Domain, letter: str, value: Formula) -> None:
    """Note that a letter is not of one value."""
    text = f"{formula_text(Name(letter), plain=True)} ≠ {formula_text(value, plain=True)}"
    domain.assumptions[text] = None
    domain.special[text] = letter, value
