"""One letter behind a formula's dollar is a unit, $m = 2$ t, unless the page has it as a letter."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

RIGHT = [
    ("$m = 2$ t, $a = 3$ m/s²", "$F = m a = 6$ kN"),
    ("$m_1 = 2$ t, $m_2 = 500$ kg", "$m_1 + m_2 = 2500$ kg"),
    ("The load is $m = 2$ t at time $t$.", "$2m = 4000$ kg"),
    ("Die Masse beträgt \\(M = 1{,}5\\) t.", "\\(M = 1500\\) kg"),
    ("$U = 12$ V, $I = 5$ A.", "$P = U I = 60$ W"),
    ("$U = 12$ V and $I = 5$ A.", "$R = U/I = 2.4$ Ω"),
    ("$U = 12$ kV, $I = 5$ mA", "$P = U I = 60$ W"),
    ("$U = 12\\,\\mathrm{kV}$, $I = 5\\,\\mathrm{mA}$", "$P = U I = 60$ W"),
    ("$I = 5$ A, $t = 2$ h", "$Q = I t = 36000$ A s"),
    ("$I = 5$ A, $t = 2$ h", "$Q = I t = 10$ A h"),
    ("$V_h = 2$ l", "$V_h = 2000$ cm³"),
    ("$\\rho = 7.85$ t/m³", "$\\rho = 7850$ kg/m³"),
    ("$m = 2$ are used a day.", "$2m = 4$"),
    ("$m = 2$ a day.", "$2m = 4$"),
]
WRONG = [
    ("$m = 2$ t, $a = 3$ m/s²", "$F = m a = 6$ N"),
    ("$m_1 = 2$ t, $m_2 = 500$ kg", "$m_1 + m_2 = 502$ kg"),
    ("$U = 12$ V, $I = 5$ A", "$P = U I = 60$ J"),
    ("$U = 12$ V, $I = 5$ A", "$R = U/I = 2.4$ V"),
    ("$U = 12$ kV, $I = 5$ mA", "$P = U I = 600$ W"),
    ("$V_h = 2$ l", "$V_h = 20$ cm³"),
]
OPEN = [
    "The time is $t = 3$ s. The path is $x = 2$ t.",
    "$A = 5$ mm². Then $F = 2$ A.",
    "The moment is $M = 2$ t m.",
    "The charge is $Q = 10$ Ah.",
    "$B = 2$ T, so $2B = 4$ T.",
]


def _verdicts(page: str, line: int) -> list[str]:
    return [link["verdict"] for link in check(page).data()["links"] if link["line"] == line]


@pytest.mark.parametrize(("given", "claim"), RIGHT)
def test_right_lines_hold(given: str, claim: str):
    assert _verdicts(f"{given}\n\n{claim}\n", 3)[-1] in ("holds", "holds_to_order")


@pytest.mark.parametrize(("given", "claim"), WRONG)
def test_wrong_lines_are_refuted(given: str, claim: str):
    verdicts = _verdicts(f"{given}\n\n{claim}\n", 3)
    assert {"refuted", "contradiction"} & set(verdicts), verdicts


@pytest.mark.parametrize("page", OPEN)
def test_a_letter_of_the_page_is_not_dropped(page: str):
    assert "unreadable" in _verdicts(page + "\n", 1)
