"""A result is of the case that its label names: for A, before, (b), Cylinder 2, the old engine."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from tests.checked_pages import last_verdict

ENGINES = "A: $n = 3000$ rpm, $T = 100$ N m. B: $n = 6000$ rpm, $T = 80$ N m.\n$P = 2\\pi n T$. "
OLD = "Old: $\\varepsilon = 9$; new: $\\varepsilon = 11$. With $\\eta = 1 - \\varepsilon^{-0.4}$: "
STATES = "Before: $T = 300$ K. After: $T = 600$ K. $p = 2T$.\n"
ITEMS = "(a) $x = 10$ (b) $x = 20$. $y = 2x$.\n"
MOTORS = "Motor A: $n = 3000$; motor B: $n = 6000$. $v = 2n$. "
CYLINDERS = "Cylinder 1: $p = 10$ bar. Cylinder 2: $p = 20$ bar. $A = 50$ cm². $F = pA$. "
PAGES = [
    (ENGINES + "For A, $P = ?$ kW.", "31.4", "50.3"),
    (ENGINES + "For A, $P = 31.4$ kW; for B, $P = ?$ kW.", "50.3", "31.4"),
    (OLD + "old $\\eta = ?$.", "0.585", "0.617"),
    (OLD + "old $\\eta = 0.585$, new $\\eta = ?$.", "0.617", "0.585"),
    (STATES + "Before, $p = ?$.", "600", "1200"),
    (STATES + "Before, $p = 600$; after, $p = ?$.", "1200", "600"),
    (STATES + "$p = ?$ before.", "600", "1200"),
    (ITEMS + "(a) $y = ?$", "20", "40"),
    (ITEMS + "(a) $y = 20$ (b) $y = ?$", "40", "20"),
    (MOTORS + "Motor A: $v = ?$.", "6000", "12000"),
    (MOTORS + "$v = 6000$ for motor A and $v = ?$ for motor B.", "12000", "6000"),
    (CYLINDERS + "The force on cylinder 1 is $F = ?$ N.", "5000", "10000"),
    (CYLINDERS + "In cylinder 1 we have $F = ?$ N.", "5000", "10000"),
    (
        "Cylinder 1: $p = 10$ bar, $A = 50$ cm², $F = pA = 5000$ N. Cylinder 2: $p = 20$ bar, $F = ?$ N.",
        "10000",
        "5000",
    ),
    (
        "At the start $T = 300$ K, at the end $T = 600$ K. $p = 2T$. At the start $p = ?$.",
        "600",
        "1200",
    ),
    ("Empty: $m = 300$ kg. Loaded: $m = 600$ kg. $F = 10 m$. Empty $F = ?$ kg.", "3000", "6000"),
    (
        "Vorher: $T = 300$ K. Nachher: $T = 600$ K. $p = 2T$.\nVorher ist $p = ?$.",
        "600",
        "1200",
    ),
    ("Avant : $T = 300$ K. Après : $T = 600$ K. $p = 2T$. Avant, $p = ?$.", "600", "1200"),
    ("変更前：$T = 300$ K、変更後：$T = 600$ K。$p = 2T$。変更前は $p = ?$。", "600", "1200"),
    ("Prima: $T = 300$ K. Dopo: $T = 600$ K. $p = 2T$. Prima, $p = ?$.", "600", "1200"),
    ("Antes: $T = 300$ K. Después: $T = 600$ K. $p = 2T$. Antes, $p = ?$.", "600", "1200"),
    (
        "Steel: $E = 210$. Aluminium: $E = 70$. $s = 2E$. For steel $s = ?$.",
        "420",
        "140",
    ),
    (
        "Petrol: $\\lambda = 3$. Diesel: $\\lambda = 4$. $q = 2\\lambda$. The petrol engine has $q = ?$.",
        "6",
        "8",
    ),
    (
        "The first: $T = 300$ K. The second: $T = 600$ K. $p = 2T$. For the first, $p = ?$.",
        "600",
        "1200",
    ),
    (
        "A: $n = 3000$, $T = 100$. B: $n = 6000$, $T = 80$. $P = nT$. $Q = 2P$.\n"
        "For A, $P = 300000$ and $Q = ?$.",
        "600000",
        "960000",
    ),
    ("- A: $n = 3000$\n- B: $n = 6000$\n\n$v = 2n$\n\n- A: $v = ?$", "6000", "12000"),
]
OPEN = [
    "A: $n = 3000$, $T = 100$. B: $n = 6000$, $T = 80$. $P = nT$.\nFor A and B, $P = 480000$.",
    "Before: $T = 300$ K. After: $T = 600$ K. Before we work out $p = 2T = 1200$, note it.",
]
HELD = [
    "A: $n = 3000$, $T = 100$. B: $n = 6000$, $T = 50$. $P = nT$.\nFor A and B, $P = 300000$.",
    "First: $T = 300$ K. Second: $T = 600$ K. $p = 2T$. First, $p = 1200$ follows.",
    "A: $n = 3000$. B: $n = 6000$. Now $n = 1000$. For A, $2n = 2000$.",
    "A: $n = 3000$. B: $n = 6000$. $P = 2n$. Compared with A, $P = 12000$.",
]
PROVED = ("holds", "holds_to_order", "conditional")


@pytest.mark.parametrize(("page", "right", "wrong"), PAGES)
def test_a_result_is_judged_by_the_data_of_its_label(tmp_path, page, right, wrong):
    assert last_verdict(tmp_path, page.replace("?", right)) in PROVED
    assert last_verdict(tmp_path, page.replace("?", wrong)) in ("refuted", "undecided")


@pytest.mark.parametrize("page", OPEN)
def test_what_no_label_decides_is_open(tmp_path, page):
    assert last_verdict(tmp_path, page) == "undecided"


@pytest.mark.parametrize("page", HELD)
def test_words_that_are_no_label_change_nothing(tmp_path, page):
    assert last_verdict(tmp_path, page) in PROVED


@pytest.mark.parametrize("page", [ENGINES, OLD, STATES, ITEMS, MOTORS, CYLINDERS])
def test_data_of_another_label_are_another_case(tmp_path, page):
    written = tmp_path / "page.md"
    written.write_text(page, encoding="utf-8")
    words = {verdict.verdict for verdict in check(written).verdicts}
    assert words <= {"definition", "premise"}
