"""A standard formula with a slip that changes its dimension is refuted where no words name it at all."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import FAILING, REFUTED

PAIRS = [
    (r"T = 2\pi\sqrt{\frac{J}{m g s}}", r"T = 2\pi\sqrt{\frac{m g s}{J}}"),
    (r"\omega_0 = \sqrt{\frac{c}{J}}", r"\omega_0 = \sqrt{\frac{J}{c}}"),
    (r"k = \frac{G I_p}{L}", r"k = \frac{G L}{I_p}"),
    (r"\Delta E = J\omega^2\delta", r"\Delta E = J\omega\delta"),
    (r"F = m r\omega^2", r"F = m r\omega"),
    (r"C = \frac{W V^2}{g r}", r"C = \frac{W V}{g r}"),
    (r"\sigma = \rho r^2\omega^2", r"\sigma = \rho r\omega^2"),
    (r"P = 2\pi n T", r"P = \frac{2\pi T}{n}"),
    (r"f = \frac{F l^3}{48 E I}", r"f = \frac{F l^2}{48 E I}"),
    (r"\varphi = \frac{T l}{G I_p}", r"\varphi = \frac{T G}{l I_p}"),
    (r"\tau = \frac{16 T}{\pi d^3}", r"\tau = \frac{16 T}{\pi d^2}"),
    (r"\sigma = \frac{32 M}{\pi d^3}", r"\sigma = \frac{32 M}{\pi d^4}"),
]
WORDS = ["We have ${}$.", "Damit wird ${}$.", "したがって ${}$ となる。", "On obtient ${}$."]
HOLLOW = [
    ("The polar moment of the hollow shaft is $I_p = \\frac{\\pi}{32}(D^4-d^4)$.",
     "The polar moment of the hollow shaft is $I_p = \\frac{\\pi}{32}(D-d)^4$."),
    ("中空軸の断面二次極モーメントは $I_p = \\frac{\\pi}{32}(D^4-d^4)$ である。",
     "中空軸の断面二次極モーメントは $I_p = \\frac{\\pi}{32}(D^3-d^3)$ である。"),
]  # fmt: skip
RIGHTLY = [  # quantities of the same letters that are no standard ones
    r"A = \frac{F}{c\,\omega}", r"v = F\omega/k", r"a = F\omega^2/k", r"x = F/(m\omega^2)",
    r"W = p A s n", r"q = m g/l", r"M = q l^2/8", r"M = q l^3 b", r"k = E A/l", r"k = 3 E I/l^3",
    r"c = G d^4/(8 D^3 n)", r"\sigma = E d/D", r"e = U/m \omega", r"p = \rho r \omega", r"p = F v/V",
    r"T = \frac{P t}{\omega}", r"T = J\omega/t", r"\alpha = T l/(G I)", r"J = \rho b d^4", r"F = m v/t",
    r"F = \rho A v^2", r"F = \rho A v", r"m = \rho b r", r"n = 30 v/(\pi r)", r"v = \omega r \lambda",
    r"\tau = T r/J", r"I = m k^2/A", r"A = \frac{F_0}{m\sqrt{g l}}", r"\omega_0 = \sqrt{F l/J}",
    r"\omega = \sqrt{\frac{c}{m l}}", r"f = \frac{1}{2\pi}\sqrt{\frac{p A}{m l}}",
    r"T = 2\pi\sqrt{\frac{m l}{F}}", r"F = \frac{T}{r\cos\beta}", r"M = U \omega^2 l",
]  # fmt: skip
OTHERWISE = [
    "The angular momentum is $T = m r^2\\omega$.",
    "The momentum of the pin is $P = m r\\omega$.",
    "The force in units of $\\omega$ is $F = m r\\omega$.",
    "Die auf die Drehzahl bezogene Kraft ist $F = m r\\omega$.",
    "It is not $F = m r\\omega$.",
]


def failing(page: str) -> list[str]:
    checked = check(page + "\n", {})
    assert not checked.derivation.unreadable
    return [v.verdict for v in checked.verdicts if v.verdict in FAILING]


@pytest.mark.parametrize(("right", "wrong"), PAIRS)
@pytest.mark.parametrize("words", WORDS)
def test_another_dimension_is_refuted_without_a_name(words, right, wrong):
    assert not failing(words.format(right))
    assert failing(words.format(wrong)) == [REFUTED]


@pytest.mark.parametrize(("right", "wrong"), HOLLOW)
def test_the_powers_of_a_hollow_section_are_taken_apart(right, wrong):
    assert not failing(right)
    assert failing(wrong) == [REFUTED]


@pytest.mark.parametrize("formula", RIGHTLY)
def test_other_quantities_of_these_letters_are_not_accused(formula):
    assert not failing(f"We have ${formula}$.")


@pytest.mark.parametrize("page", OTHERWISE)
def test_words_that_name_something_else_excuse_the_dimension(page):
    assert not failing(page)


def test_a_stress_in_japanese_is_no_force():
    words = "応力は $\\sigma_o$ と $\\sigma_u$ の間で変動する。応力振幅は"
    page = words + "\n\n$$\\sigma_a = \\frac{{\\sigma_o {} \\sigma_u}}{{2}}$$"
    assert not failing(page.format("-"))
    assert failing(page.format("+")) == [REFUTED]


@pytest.mark.parametrize(
    ("above", "stem", "index"),
    [
        ("The alternating load goes from $F_{max}$ to $F_{min}$ in each cycle. ", "F", ("max", "min")),
        ("Das Moment schwankt zwischen $T_{o}$ und $T_{u}$. ", "T", ("o", "u")),
        (
            "Fatigue: the upper value is $\\sigma_{max}$, the lower one $\\sigma_{min}$. ",
            "\\sigma",
            ("max", "min"),
        ),
    ],
)
def test_the_subscript_says_whether_it_is_the_mean_or_the_amplitude(above, stem, index):
    high, low = (f"{stem}_{{{each}}}" for each in index)
    for own, sign, other in (("m", "+", "-"), ("a", "-", "+")):
        assert not failing(f"{above}We have ${stem}_{own} = \\frac{{{high} {sign} {low}}}{{2}}$.")
        assert failing(f"{above}We have ${stem}_{own} = \\frac{{{high} {other} {low}}}{{2}}$.") == [
            REFUTED
        ]
