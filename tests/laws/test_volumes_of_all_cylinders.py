"""The volume of an engine is that of one cylinder times their number: 3·(π/4) D² S is no slip."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

RIGHT = [
    r"The swept volume is $V = 3\cdot\frac{\pi}{4}D^2 S$.",
    r"The swept volume is $V = 2\pi D^2 S/4$.",
    r"A four-cylinder engine. The swept volume is $V = \pi D^2 S$.",
    r"A four-cylinder engine. The swept volume is $V = \frac{\pi}{4} D^2 S$.",
    r"Ein Vierzylinder mit Hubraum $V = 4\cdot\frac{\pi}{4} D^2 s$.",
    r"Der V8 hat den Hubraum $V = 8\cdot\frac{\pi}{4} D^2 s$.",
    "直列3気筒の排気量は V = 3×(π/4)D²S である。",
    r"Motore: un quattro cilindri. La corsa è $c$. Cilindrata: $V = 4\cdot\frac{\pi}{4}D^2 c$.",
    r"Moteur : un trois cylindres. La course est $c$. La cylindrée est $V = 3\cdot\frac{\pi}{4}D^2 c$.",
    r"The mean torque of the four-stroke engine is $M = 3 p V/(4\pi)$, with the mean pressure $p$"
    r" and the swept volume $V$ of one cylinder.",
]
WRONG = [
    r"The swept volume is $V = 3\cdot\frac{\pi}{2}D^2 S$.",
    r"The swept volume is $V = \frac{\pi}{2} D^2 S$.",
    r"The swept volume is $V = \pi D^2 S$.",
    r"A four-cylinder engine. The swept volume is $V = 3\cdot\frac{\pi}{4} D^2 S$.",
    r"A four-cylinder engine. The swept volume is $V = 4\pi D^2 S$.",
    r"Ein Vierzylinder mit Hubraum $V = 6\cdot\frac{\pi}{4} D^2 s$.",
    r"Ein Einzylinder mit Hubraum $V = 2\cdot\frac{\pi}{4} D^2 s$.",
    r"Der V8 hat den Hubraum $V = 6\cdot\frac{\pi}{4} D^2 s$.",
    "直列3気筒の排気量は V = 4×(π/4)D²S である。",
    r"Motore: un quattro cilindri. La corsa è $c$. Cilindrata: $V = 3\cdot\frac{\pi}{4}D^2 c$.",
    r"The mean effective pressure of the four-stroke engine is $p = 2\pi M/V$, with the mean torque $M$"
    r" and the swept volume $V$.",
]


@pytest.mark.parametrize("line", RIGHT)
def test_the_volume_of_several_cylinders_is_right(tmp_path, line):
    assert _verdict(tmp_path, line) == "conditional"


@pytest.mark.parametrize("line", WRONG)
def test_another_number_of_cylinders_or_another_share_of_pi_is_wrong(tmp_path, line):
    assert _verdict(tmp_path, line) == "refuted"


def _verdict(folder, line):
    path = folder / "page.md"
    path.write_text(line + "\n", encoding="utf-8")
    return check(path, fixes=False).verdicts[0].verdict
