"""Of letters that nothing is said of, equal squares make no equal letters: a may be -b."""

import pytest

from symbalance.notes.checking import check


def words_of(page: str, symbols: dict[str, str] | None = None) -> list[str]:
    return [verdict.verdict for verdict in check(page + "\n", symbols or {}).verdicts]


@pytest.mark.parametrize(
    "page",
    [
        r"$a^2 = b^2 \Rightarrow a = b$",
        "For $a ≠ b$:\n\n" + r"$a^2 = b^2 \Rightarrow a = b$",
        r"$x^4 = y^4 ⇒ x = y$",
        "$a^2 = b^2$, hence $a = b$.",
    ],
)
def test_equal_even_powers_leave_the_sign_open(page):
    assert words_of(page)[-1] == "undecided"


@pytest.mark.parametrize(
    "page",
    [
        r"$x^3 = y^3 \Rightarrow x = y$",
        r"$2a = 2b \Rightarrow a = b$",
        "$a > 0$, $b > 0$\n\n" + r"$a^2 = b^2 \Rightarrow a = b$",
        r"$v^2 = 2 g h \Rightarrow v = \sqrt{2 g h}$",
    ],
)
def test_what_follows_is_not_doubted(page):
    assert "undecided" not in words_of(page)


def test_of_declared_speeds_the_positive_root_is_meant():
    page = r"$v^2 = w^2 \Rightarrow v = w$"
    assert "undecided" not in words_of(page, {"v": "speed", "w": "speed of the wheel"})
