"""Printed decimals held to half a unit of their last place, on either side, at either end."""

from __future__ import annotations

from fractions import Fraction

import pytest

import symbalance as sb
from symbalance.document.formula import Number
from symbalance.notes.checking.deciding.rounding import significant

LETTERS = {"x": "angle", "k": "any", "q": "any"}
HOLDS = ("holds", "holds_to_order")


def passes(relation: str) -> bool:
    (verdict,) = sb.check(f"$${relation}$$", LETTERS).verdicts
    assert verdict.fault == ""
    assert verdict.verdict in (*HOLDS, "refuted")
    return verdict.verdict in HOLDS


def decimal(value: Fraction, places: int) -> str:
    """Return a fraction as a decimal of so many places; it must end there."""
    digits = value * 10**places
    assert digits.denominator == 1
    text = f"{abs(digits.numerator):0{places + 1}d}"
    return ("-" if digits < 0 else "") + f"{text[:-places]}.{text[-places:]}"


def off_by(relation: str, number: str, units: str, places: int) -> str:
    """Return a relation with `number` in place of N, moved by some units of its last place."""
    moved = Fraction(number) + Fraction(units) / 10**places
    return relation.replace("N", decimal(moved, places))


CASES = [
    # the exact side, a value and the places it is printed to
    (r"\frac{1553}{128} = N", Fraction(1553, 128)),
    (r"N = \frac{1553}{128}", Fraction(1553, 128)),
    (r"\sqrt{2} + 3 \approx N", 3 + Fraction(14142135623730950488, 10**19)),
    (r"-\frac{4127}{64} = N", Fraction(-4127, 64)),
    (r"\frac{4127}{640} = 5 \cdot N", Fraction(4127, 3200)),
]


@pytest.mark.spread(6)
@pytest.mark.parametrize(("relation", "value"), CASES, ids=[c[0] for c in CASES])
@pytest.mark.parametrize("places", [1, 2, 3])
def test_a_lone_decimal_is_the_nearest_and_no_other(relation, value, places):
    """Off by a unit of its last place it is wrong; off by half a unit and more likewise."""
    nearest = Fraction(round(value * 10**places), 10**places)
    assert passes(relation.replace("N", decimal(nearest, places)))
    for units in (-2, -1, 1, 2):
        printed = nearest + Fraction(units, 10**places)
        strictly = abs(printed - value) * 10**places > Fraction(1, 2)
        assert strictly
        assert not passes(relation.replace("N", decimal(printed, places))), printed


@pytest.mark.parametrize("sign", ["", "-"])
def test_half_a_unit_is_the_end_of_it(sign):
    """2.3454 to two places is 2.35 as 2.345 is, and 2.3449 is not: either side of the half."""
    for exact, printed, right in (
        ("2.345", "2.35", True),
        ("2.345", "2.34", True),
        (r"\frac{23449}{10000}", "2.35", False),
        (r"\frac{23449}{10000}", "2.34", True),
        (r"\frac{23451}{10000}", "2.35", True),
        (r"\frac{23451}{10000}", "2.34", False),
        (r"\frac{2344999}{1000000}", "2.35", False),
        (r"\frac{2345001}{1000000}", "2.34", False),
    ):
        exact_text = exact if "frac" in exact else r"\frac{2345}{1000}"
        assert passes(f"{sign}{exact_text} = {sign}{printed}") == right, (exact, printed)
        assert passes(f"{sign}{printed} = {sign}{exact_text}") == right, (exact, printed)


@pytest.mark.parametrize(
    ("relation", "right"),
    [
        # a long decimal stands for all that is rounded to it, a short one is data
        (r"1.414 \cdot 1.414 = 2.00", True),
        (r"1.414 \cdot 1.414 = 1.99", False),
        (r"1.414 \cdot 1.414 = 2.01", False),
        (r"1.4 \cdot 1.4 = 1.96", True),
        (r"1.4 \cdot 1.4 = 2.0", True),
        (r"1.4 \cdot 1.4 = 1.9", False),
        (r"1.4 \cdot 1.4 = 2.1", False),
        # a printed zero has no unit to be generous with
        (r"1.234 - 1.230 = 0.00", True),
        (r"1.234 - 1.226 = 0.00", False),
        # a whole number is exact, unless decimals come to one of three digits
        (r"2.5 \cdot 4.0 = 10", True),
        (r"2.4 \cdot 4.3 = 10", False),
        (r"2.4 \cdot 4.4 = 10", False),
        (r"2.4 \cdot 4.0 = 10", False),
        (r"2.4 \cdot 43 = 103", True),
        (r"2.4 \cdot 43 = 104", False),
        (r"103 = 103.2", False),
        (r"2.3 \cdot 4.1 = 10", False),
    ],
)
def test_decimals_on_the_way_to_a_result(relation, right):
    assert passes(relation) == right


@pytest.mark.spread(10)
@pytest.mark.parametrize("letters", [r"\cos x", "k", r"k \sin x"])
@pytest.mark.parametrize(
    ("exact", "printed", "right"),
    [
        (r"\frac{1}{3}", "0.33", True),
        (r"\frac{1}{3}", "0.34", False),
        (r"\frac{1}{3}", "0.32", False),
        (r"\frac{333}{1000}", "0.33", True),
        (r"\frac{336}{1000}", "0.33", False),
        (r"\frac{334}{1000}", "0.33", True),
        (r"\frac{324}{1000}", "0.33", False),
        (r"\frac{326}{1000}", "0.33", True),
        (r"\frac{335}{1000}", "0.33", True),
        (r"\frac{325}{1000}", "0.33", True),
    ],
)
def test_a_coefficient_is_held_to_half_a_unit_of_its_own(letters, exact, printed, right):
    assert passes(f"{exact} {letters} = {printed} {letters}") == right
    assert passes(f"q + {printed} {letters} = q + {exact} {letters}") == right
    # another coefficient beside it neither helps nor harms
    assert passes(rf"{exact} {letters} + 0.5 q = {printed} {letters} + \frac{{1}}{{2}} q") == right
    assert not passes(rf"{exact} {letters} + 0.5 q = {printed} {letters} + \frac{{14}}{{25}} q")


def test_two_rounded_coefficients_have_room_for_both():
    """0.33 k + 0.17 k may be off by a half unit each, and no more."""
    for total, right in (
        ("0.50", True),
        ("0.49", True),
        ("0.51", True),
        ("0.48", False),
        ("0.53", False),
    ):
        exact = Fraction(total)
        relation = rf"0.33 k + 0.17 k = \frac{{{exact.numerator}}}{{{exact.denominator}}} k"
        assert passes(relation) == right, total


@pytest.mark.parametrize(
    ("value", "place", "digits"),
    [("0.040", "0.001", 2), ("12.5", "0.1", 3), ("-3.50", "0.01", 3), ("0.00", "0.01", 1), ("7", "1", 1)],
)
def test_the_digits_of_a_decimal_that_count(value, place, digits):
    assert significant(Number(Fraction(value), Fraction(place))) == digits


@pytest.mark.parametrize(
    ("claim", "wrong"),
    [
        ("cos(22,5)^2 = 0,854 und sin(22,5)^2 = 0,146", "0,164"),
        ("$\\cos(22,5^\\circ) = 0,924$", "0,942"),
        ("sqrt(2,25) = 1,5", "1,6"),
        ("exp(0,5) = 1,649", "1,694"),
    ],
)
def test_a_comma_in_the_brackets_of_a_function_is_a_decimal_sign(claim, wrong):
    found = [link["verdict"] for link in sb.check(f"Es ist {claim}.").data()["links"]]
    assert {*found} <= {"holds", "holds_to_order"}
    false = claim.rstrip("$").rsplit(" ", 1)[0] + f" {wrong}" + "$" * claim.endswith("$")
    assert sb.check(f"Es ist {false}.").data()["links"][-1]["verdict"] == "refuted"


@pytest.mark.parametrize("pair", ["f(2,5) = 3", "max(1,5) = 5", "$(1,5)$"])
def test_a_comma_between_two_numbers_in_brackets_parts_them(pair):
    assert not any("decimal" in note for note in sb.check(f"Es ist {pair}.").data()["notes"])
