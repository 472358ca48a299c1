r"""Inches and pounds set upright, \mathrm{in} and \mathrm{lb\cdot s^2/in}, also in macros of the page."""

from __future__ import annotations

import pytest

import symbalance as sb
from symbalance.notes.checking.verdicts import PROVED_WORDS, REFUTED

INCH = r"\newcommand{\inch}{\,\mathrm{in}}" + "\n"
ZOLL = r"\newcommand{\zoll}{\ensuremath{\,\mathrm{in}}}" + "\n"
INLB = r"\newcommand{\inlb}{\,\mathrm{in\,lb}}" + "\n"
LBIN = r"\newcommand{\lbin}{\,\mathrm{lb{\cdot}in}}" + "\n"
LENGTHS = r"The crank radius is $r = 1.70\,\mathrm{in}$, the rod length $l = 5.50\,\text{in}$." + "\n\n"
OF_MACROS = r"The crank radius is $r = 1.70\inch$, the rod length $l = 5.50\zoll$." + "\n\n"
WEIGHT = r"The weight is $W = 3.00\,\mathrm{lb}$ at the radius $r = 2.0\,\mathrm{in}$." + "\n\n"
FORCE = (
    r"$F = (6.47\times10^{-3})(2.0)(300)^2 = 1165\,\mathrm{lb}$ acts at $a = 3.00\,\mathrm{in}$." + "\n\n"
)


def last(page: str):
    checked = sb.check(page + "\n", {})
    assert not checked.faults
    return max(checked.verdicts, key=lambda v: (v.line, v.span))


RIGHT = [
    LENGTHS + r"$l + r = 7.20\,\mathrm{in}$",
    LENGTHS + r"$l + r = 182.9\,\mathrm{mm}$",
    INCH + ZOLL + OF_MACROS + r"$l + r = 7.20\inch$",
    INCH + ZOLL + OF_MACROS + r"$l/r = 3.235$",
    r"$d = 3.5\,\mathrm{in} = 88.9\,\mathrm{mm}$",
    r"$d = \frac{\pi}{4}(4.0)^2 = 12.57\,\text{in}^2$",
    r"$d = 12.57\cdot 4.0 = 50.3~\text{in}^{3}$",
    r"$d = 250\,\mathrm{lb\cdot in} = 20.8\,\mathrm{lb\cdot ft}$",
    r"$d = 250\,\mathrm{lb}\cdot\mathrm{in} = 28.2\,\mathrm{N\,m}$",
    LBIN + r"$d = 250\lbin = 28.2\,\mathrm{N\,m}$",
    r"$m = \frac{1.15}{386.1} = 2.979\times10^{-3}\,\mathrm{lb\cdot s^2/in}$",
    r"$m = \frac{1.15}{386.1} = 2.979\times10^{-3}\,\mathrm{lb}\cdot\mathrm{s^2/in}$",
    r"$m = \frac{2.50}{32.2} = 0.0776\,\mathrm{lb\,s^2/ft}$",
    WEIGHT + r"$M = W r = 6.00\,\mathrm{lb\cdot in}$",
    INLB + WEIGHT + r"$M = W r = 6.00\inlb$",
    FORCE + r"$M = F a = 3494\,\mathrm{lb\,in}$",
]
WRONG = [
    LENGTHS + r"$l + r = 7.30\,\mathrm{in}$",
    LENGTHS + r"$l + r = 192.9\,\mathrm{mm}$",
    INCH + ZOLL + OF_MACROS + r"$l + r = 7.30\inch$",
    r"$d = 3.5\,\mathrm{in} = 98.9\,\mathrm{mm}$",
    r"$d = \frac{\pi}{4}(4.0)^2 = 13.57\,\text{in}^2$",
    r"$d = 250\,\mathrm{lb\cdot in} = 28.0\,\mathrm{lb\cdot ft}$",
    LBIN + r"$d = 250\lbin = 82.2\,\mathrm{N\,m}$",
    r"$m = \frac{1.15}{386.1} = 2.579\times10^{-3}\,\mathrm{lb\cdot s^2/in}$",
    r"$m = \frac{1.15}{386.1} = 2.979\times10^{-2}\,\mathrm{lb}\cdot\mathrm{s^2/in}$",
    INLB + WEIGHT + r"$M = W r = 9.00\inlb$",
    FORCE + r"$M = F a = 3944\,\mathrm{lb\,in}$",
]


@pytest.mark.parametrize("page", RIGHT)
def test_upright_inches_are_read(page):
    assert last(page).verdict in PROVED_WORDS


@pytest.mark.parametrize("page", WRONG)
def test_upright_inches_are_counted(page):
    assert last(page).verdict == REFUTED


def test_the_word_in_is_no_unit_in_a_sentence():
    found = sb.check(r"Let $x = 3 \text{ in the case}$ of $b$." + "\n\n$2 x = 6$\n", {})
    assert found.verdicts[-1].verdict in PROVED_WORDS
