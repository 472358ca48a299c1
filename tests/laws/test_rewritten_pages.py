"""Texts put into the form the reader takes: what belongs together is joined, what does not is left."""

from collections.abc import Callable
from fractions import Fraction

import pytest

from symbalance.notes.reading.formulas.lexer import Token
from symbalance.notes.reading.formulas.second_values import with_second_values
from symbalance.notes.reading.letters.greek_words import with_greek_words
from symbalance.notes.reading.rewriting import Rewritten
from symbalance.notes.reading.spellings.memberships import with_memberships
from symbalance.notes.reading.spellings.operator_words import with_operator_words
from symbalance.notes.reading.spellings.systems_in_braces import with_systems

REWRITTEN = {
    "several letters of a set": (
        with_memberships,
        r"$x = k\pi (k, n \in \mathbb{N}_0)$",
        r"$x = k\pi  $",
    ),
    "an interval": (with_memberships, r"$x > 0, x \in [0, 1)$", "$x > 0,  $"),
    "for every letter": (with_memberships, r"$\forall x: x^2 \ge 0$", r"$  x^2 \ge 0$"),
    "no set": (with_memberships, "$x = 1$ in the set", None),
    "a word that divides": (with_operator_words, "$F = m$ divided by $r$", "$F = m / r$"),
    "a word between two formulas": (with_operator_words, "$F = m$ and $r$", None),
    "a factor of what was not said": (with_operator_words, "$m$ times $r$", None),
    "what a word multiplies is not clear": (with_operator_words, "$F = a + b$ times $c$", None),
    "a brace of cases": (with_systems, r"$f = \begin{cases} 0 \\ 1 \end{cases}$", None),
    "a brace of equations": (
        with_systems,
        r"$\begin{cases} a = 1 \\ b &= 2 \end{cases}$",
        r"$\begin{aligned} a = 1 \\ b &= 2 \end{aligned}$",
    ),
    "an array as cases": (
        with_systems,
        r"$f = \left\{\begin{array}{l} 0 \\ 1 \end{array}\right.$",
        r"$f = \begin{cases} 0 \\ 1 \end{cases}$",
    ),
    "Greek in a formula": (with_greek_words, "x = 2 omega t", "x = 2 ω t"),
    "Greek before an operator": (with_greek_words, "theta = omega*t", "θ = ω*t"),
    "pressure in psi": (with_greek_words, "p = 120 psi = 8.3 bar", None),
    "Greek within TeX": (with_greek_words, r"$theta = 1$", None),
}


@pytest.mark.parametrize("name", REWRITTEN)
def test_a_text_is_rewritten_or_not(name: str) -> None:
    rewrite: Callable[[str], Rewritten | None] = REWRITTEN[name][0]
    result = rewrite(REWRITTEN[name][1])
    same = result is None or result.text == REWRITTEN[name][1]
    assert (None if same else result.text) == REWRITTEN[name][2]  # type: ignore[union-attr]


def _number(text: str, unit: bool) -> Token:
    return Token("number", text, 0, 1, scale=Fraction(1) if unit else None)


EQUALS = Token("rel", "=", 0, 1)
LETTER = [Token("name", "w", 0, 1)]
OPEN, CLOSE = Token("open", "(", 0, 1), Token("close", ")", 0, 1)


def test_a_second_value_in_brackets_is_a_side_of_its_own() -> None:
    inches = Token("number", "88", 0, 1, scale=Fraction(254, 10000))
    sides, signs = with_second_values([LETTER, [inches, OPEN, _number("2.235", True), CLOSE]], [EQUALS])
    assert [[token.value for token in part] for part in sides] == [["w"], ["88"], ["2.235"]]
    assert [sign.value for sign in signs] == ["=", "≈"]


def test_a_value_in_brackets_in_the_same_unit_claims_nothing() -> None:
    side = [_number("88", True), OPEN, _number("70", True), CLOSE]
    sides, signs = with_second_values([LETTER, side], [EQUALS])
    assert [[token.value for token in part] for part in sides] == [["w"], ["88"]]
    assert [sign.value for sign in signs] == ["="]


@pytest.mark.parametrize(
    "side",
    [
        [_number("88", True), OPEN, _number("2.235", False), CLOSE],
        [_number("88", False), OPEN, _number("2.235", True), CLOSE],
        [*LETTER, OPEN, _number("2.235", True), CLOSE],
        [_number("88", True), OPEN, *LETTER, CLOSE],
    ],
    ids=["no unit inside", "no unit before", "a letter before", "a letter inside"],
)
def test_other_brackets_are_factors(side: list[Token]) -> None:
    assert with_second_values([LETTER, side], [EQUALS]) == ([LETTER, side], [EQUALS])
