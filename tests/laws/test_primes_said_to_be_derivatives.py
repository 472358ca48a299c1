"""Primes are derivatives by the letter that the page says: "a prime denotes d/dθ", in any language."""

from __future__ import annotations

import pytest

import symbalance as sb
from symbalance.notes.checking.verdicts import DEFINITION, PROVED_WORDS, REFUTED
from symbalance.notes.reading.letters.primes_said import variable_of_primes

SAID = [
    (r"Differentiate with respect to $\theta$ (a prime denotes $d/d\theta$).", "theta"),
    (r"Primes denote derivatives with respect to the crank angle $\varphi$.", "varphi"),
    (r"Derivatives with respect to $\phi$ are denoted by a prime.", "phi"),
    (r"We write $()' = \mathrm{d}/\mathrm{d}\varphi$ for short.", "varphi"),
    (r"Ein Strich bezeichnet die Ableitung nach dem Kurbelwinkel $\alpha$.", "alpha"),
    (r"Le prime désigne la dérivée par rapport à $\theta$.", "theta"),
    (r"L'apice indica la derivata rispetto a $\theta$.", "theta"),
    (r"La prima denota la derivada respecto a $\alpha$.", "alpha"),
    (r"プライムは $\theta$ による微分を表す。", "theta"),
]
UNSAID = [
    "the prime mover has the derivative of $x$",
    "the moment J' of the other shaft. The derivative with respect to $t$ is zero.",
    r"Ein Strich am Buchstaben bezeichnet die zweite Welle. Die Ableitung nach $x$ ist null.",
]


@pytest.mark.parametrize(("words", "variable"), SAID)
def test_words_say_what_primes_are(words, variable):
    assert variable_of_primes(words) == variable


@pytest.mark.parametrize("words", UNSAID)
def test_words_that_say_nothing_of_primes(words):
    assert variable_of_primes(words) == ""


def last(page: str, symbols: dict[str, str] | None = None):
    checked = sb.check(page + "\n", {"symbols": symbols or {}})
    assert not checked.faults
    return max(checked.verdicts, key=lambda v: (v.line, v.span))


GERMAN = (
    "Ein Strich bezeichnet die Ableitung nach dem Kurbelwinkel $\\alpha$.\n\n"
    r"$$s = r\left(1-\cos\alpha + \tfrac{\lambda}{4}(1-\cos 2\alpha)\right)$$" + "\n\n"
)
JAPANESE = "プライムは $\\theta$ による微分を表す。\n\n" + r"$$u = A\cos\theta + B\cos 2\theta$$" + "\n\n"
ROD = {
    r"\theta": "crank angle", r"\beta": "rod angle", r"\kappa": "crank ratio r/l", "R": "crank radius",
    "L": "rod length", r"\omega": "angular speed",
}  # fmt: skip
ENGLISH = (
    "Here $\\sin\\beta = \\kappa\\sin\\theta$ and $\\kappa = R/L$. A prime denotes $d/d\\theta$, "
    "the speed is $\\dot\\theta = \\omega$.\n\n"
)
RIGHT = [
    (GERMAN, r"s' = r\left(\sin\alpha + \tfrac{\lambda}{2}\sin 2\alpha\right)", {}),
    (GERMAN, r"s'' = r\left(\cos\alpha + \lambda\cos 2\alpha\right)", {}),
    (JAPANESE, r"u' = -A\sin\theta - 2B\sin 2\theta", {}),
    (JAPANESE, r"u'' = -A\cos\theta - 4B\cos 2\theta", {}),
    (ENGLISH, r"\beta' = \frac{\kappa\cos\theta}{\cos\beta}", ROD),
    (ENGLISH, r"\beta'' = -\frac{\kappa(1-\kappa^2)\sin\theta}{\cos^3\beta}", ROD),
]
WRONG = [
    (GERMAN, r"s' = r\left(\sin\alpha + \lambda\sin 2\alpha\right)", {}),
    (GERMAN, r"s'' = r\left(\cos\alpha + 2\lambda\cos 2\alpha\right)", {}),
    (JAPANESE, r"u' = -A\sin\theta - B\sin 2\theta", {}),
    (JAPANESE, r"u'' = A\cos\theta - 4B\cos 2\theta", {}),
    (ENGLISH, r"\beta' = \frac{\kappa\omega\cos\theta}{\cos\beta}", ROD),
    (ENGLISH, r"\beta'' = -\frac{\kappa(1-\kappa^2)\sin\theta}{\cos^2\beta}", ROD),
]


@pytest.mark.parametrize(("page", "formula", "symbols"), RIGHT)
def test_a_derivative_by_the_angle_holds(page, formula, symbols):
    assert last(f"{page}$${formula}$$", symbols).verdict in PROVED_WORDS


@pytest.mark.parametrize(("page", "formula", "symbols"), WRONG)
def test_another_derivative_is_refuted(page, formula, symbols):
    assert last(f"{page}$${formula}$$", symbols).verdict == REFUTED


def test_a_letter_that_adds_to_its_bare_one_is_another():
    assert last(GERMAN + "Das Trägheitsmoment ist $J' = J + m r^2$.").verdict == DEFINITION
