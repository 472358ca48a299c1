"""Sides that give a letter its value in another form, as ω² = k/m, 1/c = 1/c₁ + 1/c₂ or tan φ = λ do."""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Call, Formula, Name, Number, Power, Quotient, names
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.text import lazy_patterns as re

LETTER = Name("x")
"""A side that is a lone letter."""
_FROM = re.compile(
    r"(?:\bfrom|\bvom?|\bvon|\bab)\s+(?:(?:the|der|dem)\s+)?(?:(?P<first>first|left|ersten|linken)\b"
    r"|(?:second|right|zweiten|rechten)\b"
    r"|(?:dis[ck]|mass|rotor|inertia|wheel|scheibe|masse)\s*(?:no\.\s?)?(?:\$?\\?[A-Za-z]_?\{?)?(?P<number>[12])"
    r"|\$?[JIm]_?\{?(?P<index>[12]))",
    re.IGNORECASE,
)
"""Words for the end of a shaft from which a distance is taken."""
_ONE = Number(Fraction(1))


def head_of(side: Formula) -> str | None:
    """Return the letter that a side gives a value: alone, as power, inverse or sine; None for others.

    >>> head_of(1 / Name("c")), head_of(Name("omega") ** Fraction(2)), head_of(Name("a") * Name("b"))
    ('c', 'omega', None)
    """
    match side:
        case Name(name=name):
            return name
        case Power(base=Name(name=name), exponent=Number(value=value)) if value in (2, 3):
            return name
        case Quotient(numerator=Number(value=1), denominator=below):
            return None if isinstance(below, Quotient) else head_of(below)
        case Call(function="tan" | "sin" | "cos", argument=Name(name=name)):
            return name
    return None


def end_named(words: str) -> str:
    """Return the number of the disc from which words measure a distance; "" where they name none.

    >>> end_named("at x from the first"), end_named("from disc 2"), end_named("from the wall")
    ('1', '2', '')
    """
    match = _FROM.search(words)
    if match is None:
        return ""
    return match["number"] or match["index"] or ("1" if match["first"] else "2")


def as_side(side: Formula, formula: Formula) -> Formula:
    """Return what a side is by the formula of its letter: k/m for ω² where ω is √(k/m)."""
    match side, formula:
        case Name(), _:
            return formula
        case Call(function=function), Call(function="atan", argument=tangent):
            longest = Call("sqrt", 1 + tangent ** Fraction(2))
            return {"tan": tangent, "sin": tangent / longest, "cos": 1 / longest}[function]
        case Power(exponent=Number(value=2)), _:
            return _squared(formula)
        case Quotient(denominator=below), _:
            return _inverse(as_side(below, formula))
    (letter,) = names(side)
    return substitute(side, letter, formula)


def _squared(formula: Formula) -> Formula:
    match formula:
        case Call(function="sqrt", argument=radicand):
            return radicand
        case Quotient(numerator=above, denominator=below) if any(
            isinstance(part, Call) for part in (above, below)
        ):
            return _squared(above) / _squared(below)
        case Number(value=value):
            return Number(value**2)
    return formula ** Fraction(2)


def _inverse(formula: Formula) -> Formula:
    match formula:
        case Quotient(numerator=Number(value=1), denominator=below):
            return below
        case Quotient(numerator=above, denominator=below):
            return below / above
        case Call(function="sqrt", argument=radicand):
            return Call("sqrt", _inverse(radicand))
    return _ONE / formula
