"""Letters that a page explains in words: each is a definition, and no words are a product of letters."""

import pytest

from symbalance.checking import check
from symbalance.notes.checking.verdicts import DEFINITION, Verdict

SUFFIXES = (".txt", ".md", ".tex", ".html")


def judged(text: str, suffix: str, folder, symbols=None) -> list[Verdict]:
    page = folder / f"page{suffix}"
    page.write_text(text + "\n", encoding="utf-8")
    return list(check(page, symbols).verdicts)


def is_in_words(verdict: Verdict) -> bool:
    return verdict.verdict == DEFINITION and verdict.reason == "a meaning in words"


LIST = "m = recip mass, R = throw, L = rod length, q = R/L, w = crank speed in rad/s, t = angle from TDC"


@pytest.mark.parametrize("suffix", [".txt", ".md", ".tex"])
def test_a_list_of_letters_has_an_entry_each_and_its_formula_is_read(suffix, tmp_path):
    verdicts = judged(LIST, suffix, tmp_path)
    assert [v.source for v in verdicts if is_in_words(v)] == [
        "m = recip mass",
        "R = throw",
        "L = rod length",
        "w = crank speed in rad/s",
        "t = angle from TDC",
    ]
    (formula,) = [v for v in verdicts if not is_in_words(v)]
    assert (formula.link, formula.source, formula.verdict) == (4, "R/L", DEFINITION)


EACH_IN_WORDS = [
    ("where **m** = recip mass, *r* = crank radius and _l_ = rod length", ".md", 3),
    ("`m` = recip mass, `r` = crank radius", ".md", 2),
    ("| m = recip mass | kg |\n| r = throw | m |", ".md", 2),
    ("- m = recip mass\n- w = angular speed, rad/s", ".md", 2),
    ("where <i>m</i> = recip mass, <b>r</b> = crank radius", ".html", 2),
    ("<li>m<sub>r</sub> = rotating mass</li>", ".html", 1),
    ("[i]m[/i] = recip mass, [b]r[/b] = throw", ".txt", 2),
    ("where $m$ = recip mass, $\\lambda$ = rod ratio and $L$ = rod length.", ".tex", 3),
    ("where $m = \\text{recip mass}$, $R = \\text{throw}$.", ".tex", 2),
    ("where $m = \\mathrm{mass}$, $R = \\mathrm{throw}$.", ".tex", 2),
    ("\\[ m = \\text{recip mass}, \\quad r = \\text{throw} \\]", ".tex", 2),
    ("\\begin{align*} m &= \\text{recip mass} \\\\ r &= \\text{radius (m)} \\end{align*}", ".tex", 2),
    ("with m = recip. mass and r = crank radius.", ".tex", 2),
    ("m = mass [kg], r = crank radius (m), l = rod length in mm; n = speed, 1/min", ".txt", 4),
    ("F1 = primary force, m_rot = rotating mass, x1 = displacement of piston 1", ".txt", 3),
    ("m = oszillierende Masse, r = Kurbelradius", ".txt", 2),
    ("m = 往復質量, r = クランク半径", ".txt", 2),
    ("φ = crank angle, β = rod angle", ".txt", 2),
]


@pytest.mark.parametrize(("text", "suffix", "count"), EACH_IN_WORDS)
def test_a_meaning_in_words_is_a_definition(text, suffix, count, tmp_path):
    verdicts = judged(text, suffix, tmp_path)
    assert len(verdicts) == count
    assert all(map(is_in_words, verdicts))


@pytest.mark.parametrize("text", ["R = rod, r = arm, e = offset, i = cam", "m = recip mass, R = throw"])
def test_words_are_no_product_of_declared_letters(text, tmp_path):
    letters = dict.fromkeys("recipmashowtdf", "any")
    assert all(map(is_in_words, judged(text, ".txt", tmp_path, letters)))


FORMULAS = [
    ("F = m r w2 it follows", ".txt", "F = m r w2"),
    ("m = 3 kg mass", ".txt", "m = 3 kg"),
    ("m = m_p + m_r mass of piston and rod", ".txt", "m = m_p + m_r"),
    ("w = 2 pi n crank speed", ".txt", "w = 2 pi n"),
    ("`F` = m r", ".md", "F` = m r"),
    ("`F` = `m_rot*r`", ".md", "F` = `m_rot*r"),
    ("λ = r/l = Pleuelverhältnis", ".txt", "λ = r/l"),
]


@pytest.mark.parametrize(("text", "suffix", "formula"), FORMULAS)
def test_a_formula_with_words_behind_stays_a_formula(text, suffix, formula, tmp_path):
    page = tmp_path / f"page{suffix}"
    page.write_text(text + "\n", encoding="utf-8")
    report = check(page)
    (verdict,) = report.verdicts
    (chain,) = report.derivation.chains
    assert report.derivation.source((chain.start, chain.end)) == formula
    assert verdict.verdict == DEFINITION
    assert not is_in_words(verdict)


def test_letters_in_code_with_formulas_and_words_behind(tmp_path):
    verdicts = judged("(`λ` = r/l, `ω` = 2πn angular speed, n in 1/s)", ".md", tmp_path)
    assert [(v.source, v.verdict) for v in verdicts] == [("r/l", DEFINITION), ("2πn", DEFINITION)]


def test_a_value_behind_a_meaning_is_judged(tmp_path):
    text = "m = mass = 3 kg\n\nA = area = 2 + 2 = 5"
    words = [v.verdict for v in judged(text, ".txt", tmp_path)]
    assert words == [DEFINITION, DEFINITION, DEFINITION, DEFINITION, "refuted"]


NO_MEANING = [
    "a = b plus 3",
    "m = mass times 3",
    "a = the sum of b and c",
    "F = mass times acceleration",
    "a b = mass",
    "a + b = mass",
    "sin a = rise",
    "2 b = mass",
    "m = half the mass",
    "m = mass 3",
    "$F = \\text{mass} \\cdot a$",
    "F = mrw",
    "W = mgh",
    "F = mrw cos t",
    "F = m a = mrw",
]


@pytest.mark.parametrize("text", NO_MEANING)
def test_what_is_a_claim_or_no_letter_is_no_meaning(text, tmp_path):
    for suffix in SUFFIXES[:3]:
        assert not any(map(is_in_words, judged(text, suffix, tmp_path)))
