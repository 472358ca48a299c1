"""Two numbers of a letter side by side, each with its place or speed: later words choose between them."""

from __future__ import annotations

import pytest

from tests.checked_pages import last_verdict

PROVED = ("holds", "holds_to_order", "conditional")
SPEEDS = "$F = 3600$ N at 3000 rpm and $F = 14400$ N at 6000 rpm. $k = 0.25$.\n\n"
PRESSURES = "$p = 60$ bar at TDC and $p = 2$ bar at BDC, $A = 50$ cm².\n\n"
SIDE_BY_SIDE = [
    (SPEEDS + "At 3000 rpm $k F = ?$ N.", "900", "3600"),
    (SPEEDS + "At 6000 rpm $k F = ?$ N.", "3600", "900"),
    (
        "$F = 3600$ N (3000 rpm), $F = 14400$ N (6000 rpm), $k = 0.25$.\n\nAt 3000 rpm $k F = ?$ N.",
        "900",
        "3600",
    ),
    (
        "Es ist $Q = 3600$ N bei 3000 U/min und $Q = 14400$ N bei 6000 U/min. $k = 0{,}25$.\n\n"
        "Bei 3000 U/min ist $k Q = ?$ N.",
        "900",
        "3600",
    ),
    (
        "La forza è $F = 3600$ N a 3000 giri/min e $F = 14400$ N a 6000 giri/min. $k = 0.25$.\n\n"
        "A 3000 giri/min $k F = ?$ N.",
        "900",
        "3600",
    ),
    (
        "3000 rpmのとき $F = 3600$ N、6000 rpmのとき $F = 14400$ N。$k = 0.25$。\n\n"
        "3000 rpmのとき $k F = ?$ N。",
        "900",
        "3600",
    ),
    (PRESSURES + "At top dead centre $p A = ?$ kN.", "30", "1"),
    (PRESSURES + "At bottom dead centre $p A = ?$ kN.", "1", "30"),
    (
        "La pression est $p = 60$ bar au PMH et $p = 2$ bar au PMB, avec $A = 50$ cm².\n\n"
        "Au point mort haut la force est $p A = ?$ kN.",
        "30",
        "1",
    ),
    (
        "$M = 200$ N m at 3000 rpm and $M = 180$ N m at 4000 rpm.\n\nAt 3000 rpm $P = M\\omega = ?$ kW.",
        "62.8",
        "56.5",
    ),
    (
        "Main bearing $d = 60$ mm, crankpin $d = 50$ mm.\n\n"
        "The main bearing has the area $\\frac{\\pi}{4}d^2 = ?$ mm².",
        "2827",
        "1963",
    ),
    (
        "The tangential force is $T = 800$ N at 30° and $T = 1200$ N at 60°. "
        "The radius is $r = 50$ mm.\n\n"
        "At 30° the torque is $T r = ?$ N m.",
        "40",
        "60",
    ),
]
OF_THE_LAST = SPEEDS + "$k F = 3600$ N"


@pytest.mark.parametrize(("page", "right", "wrong"), SIDE_BY_SIDE)
def test_later_words_choose_the_number(tmp_path, page, right, wrong):
    assert last_verdict(tmp_path, page.replace("?", right)) in PROVED
    assert last_verdict(tmp_path, page.replace("?", wrong)) not in PROVED


def test_without_words_the_last_number_counts(tmp_path):
    assert last_verdict(tmp_path, OF_THE_LAST) in PROVED
