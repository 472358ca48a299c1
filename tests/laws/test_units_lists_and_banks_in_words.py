"""English units with points, falling lists, letters typed as words, half bank angles, ruled sums."""

from __future__ import annotations

from pathlib import Path

import pytest

from symbalance.checking import check

HOLDS = ("holds", "holds_to_order", "conditional")


def words_of(folder: Path, text: str, ending: str) -> list[str]:
    """Return the verdicts on a page's relations."""
    path = folder / f"page{ending}"
    path.write_text(text, encoding="utf-8")
    return [link["verdict"] for link in check(path).data()["links"]]


READ = [
    ("I₁ = 12 lb. in. sec.², with a flywheel for which I₂ = 60 lb. in. sec.².", ".txt"),
    ("The couple K = 3 lb.ft.sec.² and Q = 4 lb. in. sec. are given.", ".txt"),
    ("These come at n = 2400, 1200 and 800 r.p.m. respectively.", ".txt"),
    ("Die Drehzahlen sind n = 2400, 1200 und 800 min⁻¹.", ".txt"),
    ("Les vitesses sont n = 2400, 1200 et 800 tr/min.", ".txt"),
    ("Son n = 3000, 2000 y 1000 rpm.", ".txt"),
    ("The shell carries $m = 4.50$ kg plus the centrifugal force of the rod.", ".md"),
    ("Es trägt $m = 4{,}50$ kg plus die Fliehkraft des Zapfens.", ".md"),
]


@pytest.mark.parametrize(("text", "ending"), READ)
def test_what_is_well_said_is_read(tmp_path, text, ending):
    words = words_of(tmp_path, f"{text}\n", ending)
    assert set(words) <= {"definition", "premise", "range"}, words


@pytest.mark.parametrize("text", ["x = 3 plus 4", "cos 2t = 1 - 2 sin^2 t plus 3", "x = 5, 3 and y = 2"])
def test_what_goes_on_in_words_is_not_read(tmp_path, text):
    assert "unreadable" in words_of(tmp_path, f"{text}\n", ".txt")


PUT_IN = [
    ("With a = 12 mm and b = 60 mm, ab/(a + b) = {} = 10, so that all is well.", True),
    ("With J = 12 lb. in. sec.² and K = 60 lb. in. sec.², JK/(J + K) = {} = 10.", True),
    ("Mit a = 12 in. und b = 60 in. ist ab/(a + b) = {} = 10.", True),
    ("With a = 12 in. and b = 60 mm, ab/(a + b) = {} = 10.", False),
]


@pytest.mark.parametrize(("text", "is_one_unit"), PUT_IN)
def test_numbers_of_one_unit_are_put_in_without_it(tmp_path, text, is_one_unit):
    right = words_of(tmp_path, f"{text.format('720/72')}\n", ".txt")
    wrong = words_of(tmp_path, f"{text.format('720/27')}\n", ".txt")
    assert (right[2] in HOLDS) == is_one_unit, right
    assert wrong[2] == "refuted", wrong


TYPED = [
    ("HP = 2.67 hp\nT = 5252*HP/rpm = 5252*2.67/300 = {} lb ft", "46.7", "64.7"),
    ("  dE = 0.25*293 = 73 ft lb\n\n  Cs = dE/(5*9) = 73/(5*9) = {}", "1.62", "1.26"),
    ("  dQ = 5*3 = 15\n  Q = 2*dQ = {}", "30", "45"),
]


@pytest.mark.parametrize(("text", "right", "wrong"), TYPED)
def test_rpm_and_changes_typed_in_a_formula_are_letters(tmp_path, text, right, wrong):
    good = words_of(tmp_path, f"{text.format(right)}\n", ".txt")
    assert "unreadable" not in good
    assert "refuted" not in good
    assert words_of(tmp_path, f"{text.format(wrong)}\n", ".txt")[-1] == "refuted"


def test_a_quotient_of_differentials_stays_one(tmp_path):
    assert words_of(tmp_path, "E = x^2\n\n  k = dE/dx = 2 x\n", ".txt")[-1] == "holds"
    assert words_of(tmp_path, "E = x^2\n\n  k = dE/dx = 3 x\n", ".txt")[-1] == "refuted"


BANKS = [
    ("V型2気筒の挟み角を$2{0}$とする。1次慣性力の垂直成分と水平成分は", "\\beta", "\\theta"),
    ("V型2気筒のバンク角の半分を${0}$とする。1次慣性力の垂直成分と水平成分は", "\\alpha", "\\theta"),
    ("V-twin on one pin: the angle between the cylinders is $2{0}$. The vertical and horizontal"
     " components of the primary force are", "\\gamma", "\\theta"),
]  # fmt: skip


@pytest.mark.parametrize(("words", "half", "crank"), BANKS)
def test_half_the_angle_between_the_banks_is_no_whole(tmp_path, words, half, crank):
    along = f"Y = 2 m r \\omega^2 \\cos^2 {half} \\cos {crank}"
    across = f"X = 2 m r \\omega^2 \\%s^2 {half} \\sin {crank}"
    page = f"{words.format(half)}\n\n$${along}$$\n$${across}$$\n"
    assert all(word in HOLDS for word in words_of(tmp_path, page % "sin", ".md"))
    wrong = words_of(tmp_path, page % "cos", ".md")
    assert wrong[1] == "refuted"


def test_the_whole_angle_between_the_banks_is_no_half(tmp_path):
    page = "V型2気筒の挟み角を$\\beta$とする。1次慣性力の垂直成分は\n\n"
    page += "$$Y = 2 m r \\omega^2 \\cos^2 %s \\cos\\theta$$\n"
    assert words_of(tmp_path, page % "\\frac{\\beta}{2}", ".md")[-1] in HOLDS
    assert words_of(tmp_path, page % "\\beta", ".md")[-1] == "refuted"


RULED = [
    ("With $\\beta_j = 120°(j-1)$:", "\\sum_j \\cos(\\theta+\\beta_j) = 0", True),
    ("With $\\beta_j = 120°(j-1)$:", "\\sum_j \\cos 2(\\theta+\\beta_j) = 0", True),
    ("With $\\beta_j = 120°(j-1)$:", "\\sum_j \\cos 3(\\theta+\\beta_j) = 0", False),
    ("Mit $\\delta_k = 72°(k-1)$:", "\\sum_k \\sin 4(\\varphi-\\delta_k) = 0", True),
    ("Mit $\\delta_k = 72°(k-1)$:", "\\sum_k \\sin 5(\\varphi-\\delta_k) = 0", False),
    ("Avec $\\alpha_i = 90°(i-1)$ :", "\\sum_i z_i \\cos(\\theta+\\alpha_i) = 0", False),
]


@pytest.mark.parametrize(("rule", "claim", "is_right"), RULED)
def test_a_sum_runs_once_round_the_angles_of_a_rule(tmp_path, rule, claim, is_right):
    word = words_of(tmp_path, f"{rule}\n\n$${claim}$$\n", ".md")[-1]
    assert (word in HOLDS) == is_right, word


BOXERS = [
    ("El cuatro cilindros bóxer", "que el cuatro en línea, donde"),
    ("Il quattro cilindri boxer", "del quattro cilindri in linea, dove"),
    ("Le quatre cylindres à plat", "que le quatre cylindres en ligne, où"),
    ("The boxer four", "than the inline four, where"),
]


@pytest.mark.parametrize(("engine", "other"), BOXERS)
def test_a_boxer_has_no_force_and_the_engine_it_is_compared_with_has(tmp_path, engine, other):
    page = f"# {engine}\n\n{engine}: 0°, 180°, 180°, 0°.\n\n$$\\sum F_1 = 0, \\qquad \\sum F_2 = 0$$\n\n"
    page += f"+ {other} $F_2 = %s \\lambda m r \\omega^2 \\cos 2\\theta$.\n"
    right = words_of(tmp_path, page % 4, ".md")
    assert "refuted" not in right
    assert all(word in HOLDS for word in right[:2])


def test_what_vanishes_in_another_engine_contradicts_nothing(tmp_path):
    page = "## The {}\n\nHere $M_1 = \\sqrt3 a m r \\omega^2$ and "
    page += "$M_2 = \\sqrt3 \\lambda a m r \\omega^2$.\n\n"
    page += "{}\n\nAll is balanced, and $M_1 = M_2 = 0$.\n"
    other = words_of(tmp_path, page.format("inline three", "## The inline six"), ".md")
    assert other[-2:] == ["definition", "definition"]
    own = words_of(tmp_path, page.format("inline three", ""), ".md")
    assert not set(own[-2:]) & {"definition", *HOLDS}


CASES = "\\begin{tabular}{l|c}\nRate & what \\\\ \\hline\n$b = 0$ & none \\\\\n"
CASES += "$b = 1/2$ & half \\\\\n\\end{tabular}"


def test_the_first_cells_of_a_table_are_cases(tmp_path):
    page = f"\\documentclass{{article}}\\begin{{document}}\n{CASES}\n\\end{{document}}\n"
    assert words_of(tmp_path, page, ".tex") == ["definition", "premise"]


PENDULUMS = [
    "The rod was swung on a knife edge. Its moment of inertia about the pivot comes from its period $T$:",
    "Das Pleuel schwingt als Pendel, Schwingungsdauer $T$. Das Trägheitsmoment um die Schneide ist",
]


@pytest.mark.parametrize("words", PENDULUMS)
def test_the_inertia_of_a_pendulum_goes_with_the_square_of_its_turn(tmp_path, words):
    page = f"{words}\n\n$$J = \\frac{{m g h T^2}}{{%s}}$$\n"
    assert words_of(tmp_path, page % "4\\pi^2", ".md")[-1] in HOLDS
    assert words_of(tmp_path, page % "4\\pi", ".md")[-1] == "refuted"
    assert words_of(tmp_path, page % "2\\pi^2", ".md")[-1] == "refuted"
