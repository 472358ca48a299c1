"""Sums, integrals and series as notes have them, each with its wrong neighbours beside the right line.

A relation with its condition behind it, (N ≥ 3), is two: what is said of both is listed.
"""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.units.units_behind import letters_counted
from symbalance.notes.checking.words.crank_angles_listed import crank_angles

LETTERS = {
    "alpha": "crank angle", "theta": "crank angle", "N": "number of cylinders", "r": "crank radius",
    "l": "rod length", "omega": "angular speed", "m_o": "reciprocating mass",
}  # fmt: skip

CONDITIONS_BEHIND = [
    (r"\sum_{k=0}^{N-1} e^{i(\alpha+2\pi k/N)} = 0 \qquad (N \geq 2)", ["holds", "range"]),
    (r"\sum_{k=0}^{N-1} e^{i(\alpha+2\pi k/N)} = 0 \qquad (N \geq 1)", ["refuted", "range"]),
    (r"\sum_{k=0}^{N-1} \cos 2(\alpha+2\pi k/N) = 0 \qquad (N \geq 3)", ["holds", "range"]),
    (r"\sum_{k=0}^{N-1} \cos 2(\alpha+2\pi k/N) = 0 \qquad (N > 2)", ["holds", "range"]),
    (r"\sum_{k=0}^{N-1} \cos 2(\alpha+2\pi k/N) = 0 \qquad (N \geq 2)", ["refuted", "range"]),
    (r"\sum_{k=1}^{N} \cos(\alpha+\pi k/N) = 0 \qquad (N \geq 2)", ["refuted", "range"]),
    (r"\sum_{k=0}^{N} e^{2\pi i k/N} = 0 \qquad (N \geq 2)", ["refuted", "range"]),
    (r"\sum_{k=1}^{N} \cos^2(\alpha+2\pi k/N) = \frac{N}{2} \qquad (N \geq 3)", ["holds", "range"]),
    (r"\sum_{k=1}^{N} \cos^2(\alpha+2\pi k/N) = \frac{N}{2} \qquad (N \geq 2)", ["refuted", "range"]),
    (r"\sum_{k=1}^{N} \cos^2(\alpha+2\pi k/N) = \frac{N}{4} \qquad (N \geq 3)", ["refuted", "range"]),
    (
        r"\sum_{k=1}^{N} \cos(\alpha+2\pi k/N) = 0\ (N \ge 2),\quad"
        r" \sum_{k=1}^{N} \cos 3(\alpha+2\pi k/N) = 0\ (N \ge 4)",
        ["holds", "range", "holds", "range"],
    ),
    (
        r"\sum_{k=1}^{N} \cos 3(\alpha+2\pi k/N) = 0\ (N \ge 4),\quad"
        r" \sum_{k=1}^{N} \cos 3(\alpha+2\pi k/N) = 0\ (N \ge 3)",
        ["holds", "range", "refuted", "range"],
    ),
    (r"\int_0^{2\pi}\cos m\phi\cos n\phi\,d\phi = 0 \quad (m \neq n)", ["conditional", "range"]),
    (r"\int_0^{2\pi}\cos m\phi\cos n\phi\,d\phi = \pi \quad (m \neq n)", ["refuted", "range"]),
    (r"\int_0^{2\pi}\cos m\phi\cos n\phi\,d\phi = \pi \quad (m = n)", ["conditional", "condition"]),
    (r"\int_0^{2\pi}\cos m\phi\cos n\phi\,d\phi = 0 \quad (m = n)", ["refuted", "condition"]),
    (r"\int_0^{2\pi}\cos m\phi\cos n\phi\,d\phi = \frac{\pi}{2} \quad (m = n)", ["refuted", "condition"]),
    (
        r"\sum_{k=0}^{N-1} e^{2\pi i p k/N} ="
        r" \begin{cases} N & N \mid p \\ 0 & \text{sonst}\end{cases}",
        ["conditional"],
    ),
    (
        r"\sum_{k=0}^{N-1} e^{2\pi i p k/N} ="
        r" \begin{cases} 1 & N \mid p \\ 0 & \text{sonst}\end{cases}",
        ["refuted"],
    ),
    (
        r"\sum_{k=0}^{N-1} e^{2\pi i p k/N} ="
        r" \begin{cases} N & N \mid p \\ 1 & \text{sonst}\end{cases}",
        ["refuted"],
    ),
    (r"\int_0^{\pi}\sin k\phi\,d\phi = 0 \quad (k \geq 1)", ["refuted", "range"]),
]


@pytest.mark.parametrize(("formula", "words"), CONDITIONS_BEHIND)
def test_a_condition_behind_a_relation_is_its_own(formula, words):
    checked = check(f"$${formula}$$\n", LETTERS)
    assert not checked.faults
    assert [v.verdict for v in sorted(checked.verdicts, key=lambda v: v.span)] == words


def test_the_number_that_a_range_should_leave_out_is_the_witness():
    page = r"$$\sum_{k=0}^{N-1} \cos 2(\alpha+2\pi k/N) = 0 \qquad (N \geq 2)$$"
    refuted = min(check(page + "\n", LETTERS).verdicts, key=lambda v: v.span)
    assert refuted.witness["N"] == "2"
    assert "includes N = 2" in refuted.reason


def test_an_equality_behind_an_integral_reaches_no_further():
    page = (
        r"$$\int_0^{2\pi}\cos m\phi\cos n\phi\,d\phi = \pi \quad (m = n)$$"
        "\n\n"
        r"$$\int_0^{2\pi}\cos m\phi\cos n\phi\,d\phi = 0$$"
    )
    last = max(check(page + "\n", LETTERS).verdicts, key=lambda v: v.span)
    assert last.verdict == "conditional"
    assert "m - n ≠ 0" in last.assumption


WORDS = [
    ("For every integer $k$ we have ", "holds"),
    ("With $k \\in \\mathbb{Z}$ we have ", "holds"),
    ("Für ganzzahliges $k$ gilt ", "holds"),
    ("", "conditional"),
    ("With $k$ as the balance fraction ", "conditional"),
]


@pytest.mark.parametrize(("words", "verdict"), WORDS)
def test_words_say_that_an_order_is_a_whole_number(words, verdict):
    page = words + r"$\int_0^{2\pi}\sin k\phi\,d\phi = 0$."
    (only,) = check(page + "\n", LETTERS).verdicts[-1:]
    assert only.verdict == verdict


LISTS = [
    ("crank throws at 0°, 180°, 180° and 0°.", [0, 180, 180, 0]),
    ("4気筒（$0,\\pi,\\pi,0$）では", [0, 180, 180, 0]),
    (r"Kröpfungsfolge $0^\circ, 120^\circ, 120^\circ, 0^\circ$", [0, 120, 120, 0]),
    (r"with $\delta_i = \ang{0}, \ang{90}, \ang{270}, \ang{180}$", [0, 90, 270, 180]),
    (r"$\delta_i = 0, \frac{2\pi}{3}, \frac{4\pi}{3}$", [0, 120, 240]),
    ("| cylinder | 1 | 2 | 3 |\n|---|---|---|---|\n| $\\delta_i$ | 0° | 120° | 240° |", [0, 120, 240]),
    ("| cylinder | phase |\n|---|---|\n| 1 | 0° |\n| 2 | 120° |\n| 3 | 240° |", [0, 120, 240]),
    ("Reihe, gleiche Zündabstände: z = 3", [0, 240, 120]),
    ("an in-line four-stroke with equal firing intervals, z = 4", [0, 180, 0, 180]),
    ("The crank angle is between 0 and 180°", None),
    ("at crank angles 0°, 30°, 60°, 90° the piston is at", None),
    ("| crank angle | 0° | 90° | 180° |", None),
    ("bank angles 0°, 60°, 90°", None),
    ("for the cylinder 0, 1, 2 mm", None),
]  # fmt: skip


@pytest.mark.parametrize(("text", "degrees"), LISTS)
def test_crank_angles_are_read_from_words_and_tables(text, degrees):
    lists = [[int(angle) for angle in angles.degrees] for angles in crank_angles(text)]
    assert lists == ([] if degrees is None else [degrees])


FORCES = "$F_1 = m_o r\\omega^2\\cos\\theta$\n\n"
ENGINES = [
    ("crank throws at 0°, 180°, 180°, 0°:", "conditional"),
    ("crank throws at 0°, 180°, 180°, 90°:", "refuted"),
    ("the V4 has crank throws at 0°, 180°, 180°, 90°:", "undecided"),
    ("the engine:", "undecided"),
    ("Reihe, gleiche Zündabstände, z = 3:", "conditional"),
]


def test_each_of_several_engines_on_a_line_has_its_own_cranks():
    first, second = (
        "two throws at 0°, 180°: $\\sum F_1 = 0$",
        "two throws at 0°, 360°: $\\sum F_1 = 2 F_1$",
    )
    page = f"{FORCES}{first}; {second}\n"
    words = [v.verdict for v in sorted(check(page, LETTERS).verdicts, key=lambda v: v.span)]
    assert words[1:] == ["conditional", "conditional"]


def test_a_range_further_above_refutes_nothing():
    page = (
        r"$\sum_{k=1}^{N} \cos(\alpha+2\pi k/N) = 0$ for $N \ge 2$"
        "\n\n\n\n"
        r"$\sum_{k=1}^{N} \cos 2(\alpha+2\pi k/N) = 0$"
    )
    last = max(check(page + "\n", LETTERS).verdicts, key=lambda v: v.span)
    assert (last.verdict, last.assumption) == ("conditional", "N ≠ 2")


def test_a_number_behind_a_sum_is_of_that_sum():
    page = (
        r"$\sum_{k=1}^{N} \cos 4(\alpha+2\pi k/N) = 0$ ($N = 3$)"
        "\n\n"
        r"$\sum_{k=1}^{N} \cos 2(\alpha+2\pi k/N) = 0$ ($N \ge 5$)"
    )
    words = [v.verdict for v in sorted(check(page + "\n", LETTERS).verdicts, key=lambda v: v.span)]
    assert words == ["conditional", "condition", "holds", "range"]


def test_a_sum_of_moments_needs_the_lever_arms():
    page = "$M_1 = m_o r\\omega^2 a\\cos\\theta$\n\ncrank throws at 0°, 120°, 240°: $$\\sum M_1 = 0$$\n"
    last = max(check(page, LETTERS | {"a": "cylinder pitch"}).verdicts, key=lambda v: v.span)
    assert last.verdict == "undecided"


@pytest.mark.parametrize(("words", "verdict"), ENGINES)
def test_a_sum_without_an_index_goes_over_the_engine_of_its_section(words, verdict):
    last = max(check(f"{FORCES}{words} $$\\sum F_1 = 0$$\n", LETTERS).verdicts, key=lambda v: v.span)
    assert last.verdict == verdict
    assert "no point" not in last.reason


UNITS = [
    (" (n in 1/min)", {"n": "1/min"}),
    ("$ ($n$ in $\\mathrm{min^{-1}}$)", {"n": "min^{-1}"}),
    (", with n in rpm and P in kW.", {"n": "rpm", "P": "kW"}),
    (" mit n in min⁻¹, P in kW.", {"n": "min⁻¹", "P": "kW"}),
    (" (n in a table)", {}),
    (" and n in 1/min", {}),
]


@pytest.mark.parametrize(("text", "units"), UNITS)
def test_units_behind_a_side_are_those_of_its_letters(text, units):
    counted = letters_counted(text, {"n": "n", "P": "P"})
    assert {name: unit for name, (unit, _) in counted.items()} == units


MOTION = {
    "r": "crank radius", "l": "connecting rod length", "\\lambda": "crank ratio r/l",
    "theta": "crank angle", "phi": "angle of the connecting rod to the cylinder axis",
    "x": "distance of the piston pin from the crank axis",
}  # fmt: skip

MOTION_AND_ENDS = r"""$$r\sin\theta = l\sin\phi$$

$$x = r\cos\theta + l\cos\phi$$

At $\theta = 0$ the pin is farthest away, $x_{\max} = r + l$, and at $\theta = \pi$ nearest,
$x_{\min} = l - r$.

## The motion as a series

$$\frac{x}{r} = A_0 + \cos\theta + A_2\cos 2\theta + A_4\cos 4\theta + \dots$$

"""

COEFFICIENTS = [
    (r"\frac{\lambda}{4} + \frac{\lambda^3}{16}", r"-\frac{\lambda^3}{64}", "", ""),
    (r"\frac{\lambda}{4} + \frac{\lambda^3}{16}", r"\frac{\lambda^3}{64}", "", "refuted"),
    (r"\frac{\lambda}{4} + \frac{\lambda^3}{16}", r"-\frac{\lambda^3}{32}", "", "refuted"),
    (r"\frac{\lambda}{2} + \frac{\lambda^3}{16}", r"-\frac{\lambda^3}{64}", "refuted", ""),
    (r"\frac{\lambda}{4} - \frac{\lambda^3}{16}", r"-\frac{\lambda^2}{64}", "refuted", "refuted"),
]


@pytest.mark.parametrize(("second", "fourth", "by_second", "by_fourth"), COEFFICIENTS)
def test_a_series_behind_values_at_places_fixes_its_coefficients(second, fourth, by_second, by_fourth):
    mean_part = r"$$A_0 = \frac1\lambda - \frac{\lambda}{4} - \frac{3\lambda^3}{64} - \dots$$"
    rest = f"$$A_2 = {second} + \\dots$$\n\n$$A_4 = {fourth} - \\dots$$"
    verdicts = check(f"{MOTION_AND_ENDS}{mean_part}\n\n{rest}\n", MOTION).verdicts
    series, mean, *others = sorted(verdicts, key=lambda v: v.span)[-4:]
    assert series.verdict in ("premise", "conditional", "holds_to_order")
    words = ["holds_to_order", by_second or "holds_to_order", by_fourth or "holds_to_order"]
    assert [v.verdict for v in (mean, *others)] == words


def test_a_motion_that_is_no_such_series_is_refuted_behind_values_at_places():
    page = (
        MOTION_AND_ENDS.partition("$$\\frac{x}{r}")[0]
        + "$$\\frac{x}{r} = \\frac1\\lambda + 2\\cos\\theta$$\n"
    )
    assert max(check(page, MOTION).verdicts, key=lambda v: v.span).verdict == "refuted"
