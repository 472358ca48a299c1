"""What a relation's own words give a letter counts: no value of another place, speed, size or case."""

from __future__ import annotations

import pytest

import symbalance as sb
from tests.checked_pages import last_verdict

PROVED = ("holds", "holds_to_order", "conditional")
FORCE = "With $m = 0.5$ kg, $r = 40$ mm, $\\omega = 300$ rad/s the force is $m r\\omega^2 = 1800$ N.\n\n"
TOP_FR = "Au point mort haut, $\\theta = 0$ et $\\cos\\theta = 1$. La bielle est longue.\n\n"
TOP_IT = "Al punto morto superiore $\\theta = 0$ e $\\cos\\theta = 1$. La biella è lunga.\n\n"
POSITION = (
    "Given: crank radius $R = 50$ mm, rod length $L = 200$ mm, crank angle $\\theta = 60^\\circ$ "
    "measured from TDC.\n\n"
    "$$s = R\\cos\\theta + \\sqrt{L^2 - R^2\\sin^2\\theta} = 220.26\\text{ mm}$$\n\n"
)
AT_TOP = POSITION + "At TDC $s_0 = R + L = 250$ mm, so the piston has moved $x = s_0 - s = NUMBER$ mm."
RANGES = "$M = M_0\\sin\\theta$ for $0 \\le \\theta \\le \\pi$, $M = 0$ for $\\pi < \\theta < 2\\pi$.\n\n"
TABLE = (
    "$n = 3000$ rpm, $s = 80$ mm\n\n"
    "| speed | mean piston speed |\n|---|---|\n| 3000 rpm | $2 s n = 8$ m/s |\n"
)
OTHER_WORDS = [
    (
        "At top dead centre $\\theta = 0$, so $\\cos\\theta = 1$.\n\n"
        "At bottom dead centre $\\cos\\theta = ?$.",
        "-1",
        "1",
    ),
    (
        "At $\\theta = 0$ we have $\\cos\\theta = 1$.\n\nAt 90° after TDC we have $\\cos\\theta = ?$.",
        "0",
        "1",
    ),
    ("Im OT ist $\\varphi = 0$ und $\\cos\\varphi = 1$.\n\nIm UT ist $\\cos\\varphi = ?$.", "-1", "1"),
    (TOP_FR + "Au point mort bas, $\\cos\\theta = ?$.", "-1", "1"),
    (TOP_IT + "Al punto morto inferiore $\\cos\\theta = ?$.", "-1", "1"),
    (
        "上死点では $\\theta = 0$ であり、$\\cos\\theta = 1$。\n\n下死点では $\\cos\\theta = ?$。",
        "-1",
        "1",
    ),
    ("For $N = 4$ cylinders, $720°/N = 180°$.\n\nFor six cylinders $720°/N = ?°$.", "120", "180"),
    ("Für $z = 4$ Zylinder ist $720°/z = 180°$.\n\nFür sechs Zylinder ist $720°/z = ?°$.", "120", "180"),
    ("$N = 4$ 気筒では $720°/N = 180°$。\n\n6気筒では $720°/N = ?°$。", "120", "180"),
    ("Engine A: $s = 80$ mm, $s/2 = 40$ mm.\n\nEngine B: stroke 90 mm, $s/2 = ?$ mm.", "45", "40"),
    ("Motor A: $s = 80$ mm, $s/2 = 40$ mm.\n\nMotor B: Hub 90 mm, $s/2 = ?$ mm.", "45", "40"),
    (FORCE + "When the speed is raised to 400 rad/s, $m r\\omega^2 = ?$ N.", "3200", "1800"),
    (FORCE + "When the mass is raised to 0.8 kg, $m r\\omega^2 = ?$ N.", "2880", "1800"),
    (FORCE + "At idle (800 rpm) $m r\\omega^2 = ?$ N.", "140", "1800"),
    (FORCE + "If the mass is doubled, $m r\\omega^2 = ?$ N.", "3600", "1800"),
    (FORCE + "Wird die Masse verdoppelt, so ist $m r\\omega^2 = ?$ N.", "3600", "1800"),
    (TABLE + "| 6000 rpm | $2 s n = ?$ m/s |", "16", "8"),
    (TABLE + "| 6000 rpm | $2 s n = 16$ m/s |\n| 4500 rpm | $2 s n = ?$ m/s |", "12", "8"),
    (
        "$F_2 = k F_1$ with $F_1 = 3000$ N.\n\n| engine | k | force |\n|---|---|---|\n"
        "| A | $k = 0.25$ | $F_2 = 750$ N |\n| B | $k = 0.3$ | $F_2 = ?$ N |",
        "900",
        "750",
    ),
    (
        "## 3000 rpm\n\n$\\omega = 314$ rad/s, $F = 0.02\\omega^2 = 1972$ N.\n\n"
        "## 6000 rpm\n\n$F = ?$ N.",
        "7888",
        "1972",
    ),
    (
        "If $J = \\frac12 m r^2$ (disc), $J/m = r^2/2$.\n\nIf $J = m r^2$ (ring), $J/m = ?$.",
        "r^2",
        "r^2/2",
    ),
    (RANGES + "$\\int_0^{\\pi} M\\,d\\theta = ?$", "2 M_0", "0"),
]
WITHOUT_A_VALUE = [
    "If $m_1 = m_2$, then $m_1 + m_2 = 2 m_1$.\n\nIn general $m_1 + m_2 = 2m_1$.",
    "Wenn $m_1 = m_2$, dann ist $m_1 + m_2 = 2 m_1$.\n\nIm Allgemeinen ist $m_1 + m_2 = 2m_1$.",
    "## Equal discs\n\n$J_1 = J_2$: $J_1 + J_2 = 2 J_1$.\n\n## Different discs\n\n$J_1 + J_2 = 2 J_1$",
    "For an infinitely long rod, $\\lambda = 0$: $1 + \\lambda = 1$.\n\n"
    "For a finite rod $1 + \\lambda = 1$.",
    FORCE + "With a heavier piston $m r\\omega^2 = 1800$ N.",
    FORCE + "Mit einem schwereren Kolben ist $m r\\omega^2 = 1800$ N.",
    RANGES + "$\\int_0^{2\\pi} M\\,d\\theta = 0$",
    "For $\\theta < 180°$: $M = 100$ N m. For $\\theta > 180°$: $M = -20$ N m.\n\n"
    "At $\\theta = 90°$: $M = -20$ N m.",
]
OF_THE_SAME = [
    "The engine turns at $n = 3000$ rpm; the red line is at 6000 rpm. With $s = 80$ mm, $2 s n = 8$ m/s.",
    "At TDC $\\theta = 0$. There $\\cos\\theta = 1$.",
    "## Engine of 3000 rpm\n\n$\\omega = 314$ rad/s, $F = 0.02\\omega^2 = 1972$ N.\n\nSo $F/2 = 986$ N.",
    FORCE + "If the mass is doubled, $2 m r\\omega^2 = 3600$ N.",
    FORCE + "At 300 rad/s $m r\\omega^2 = 1800$ N.",
    "For $\\theta = 30°$, $\\sin\\theta = 0.5$.\n\nAt 150° too $\\sin\\theta = 0.5$.",
    "At TDC $\\theta = 0$.\n\nAt bottom dead centre, too, $\\sin^2\\theta + \\cos^2\\theta = 1$.",
    "$J_1 = J_2$.\n\nFor different discs $J_1 + J_2 = J_2 + J_1$.",
    RANGES + "$\\int_{\\pi}^{2\\pi} M\\,d\\theta = 0$",
]


@pytest.mark.parametrize(("number", "is_right"), [("29.74", True), ("27.94", False)])
def test_the_place_of_a_letter_with_an_index_is_not_that_of_the_letter_beside_it(
    tmp_path, number, is_right
):
    assert (last_verdict(tmp_path, AT_TOP.replace("NUMBER", number)) in PROVED) is is_right


def test_words_that_begin_the_next_sentence_are_not_of_the_display_above(tmp_path):
    assert last_verdict(tmp_path, POSITION) in PROVED
    below = sb.check(POSITION + "At TDC the rod is in line with the crank.\n", {}).data()["links"]
    assert below[-1]["verdict"] in PROVED
    behind = sb.check(POSITION.rstrip() + " at TDC.\n", {}).data()["links"]
    assert behind[-1]["verdict"] not in PROVED


@pytest.mark.parametrize("number", ["220.26", "440.52"])
def test_the_place_of_a_letter_with_an_index_is_that_of_others(tmp_path, number):
    factor = "" if number == "220.26" else "2 "
    page = (
        POSITION + f"At TDC $s_0 = R + L = 250$ mm, and $L + {factor}s = {200 + float(number):.2f}$ mm."
    )
    assert last_verdict(tmp_path, page) not in PROVED


@pytest.mark.parametrize(("page", "right", "wrong"), OTHER_WORDS)
def test_what_its_own_words_give_decides(tmp_path, page, right, wrong):
    assert last_verdict(tmp_path, page.replace("?", right)) not in (
        "refuted",
        "contradiction",
        "undecided",
    )
    assert last_verdict(tmp_path, page.replace("?", wrong)) not in PROVED


@pytest.mark.parametrize("page", WITHOUT_A_VALUE)
def test_words_of_another_case_prove_nothing(tmp_path, page):
    assert last_verdict(tmp_path, page) not in PROVED


@pytest.mark.parametrize("page", OF_THE_SAME)
def test_words_of_the_same_case_leave_what_is_proved(tmp_path, page):
    assert last_verdict(tmp_path, page) in PROVED
