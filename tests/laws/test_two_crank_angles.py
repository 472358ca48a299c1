"""Of two declared crank angles, θ of the engine and φ of one cylinder, a formula is judged in its own."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

ANGLES = [
    ("crank angle", "crank angle of the cylinder looked at, from its own top dead centre"),
    ("crank angle from the vertical", "crank angle from the axis of the cylinder looked at"),
    ("crank angle", "crank angle, measured from the cylinder axis"),
    ("Kurbelwinkel", "Kurbelwinkel gegen die Zylinderachse"),
    ("Kurbelwinkel", "Kurbelwinkel, gezählt von der Zylinderachse"),
    ("crank angle", "crank angle from its own top dead centre"),
]
CASES = [
    ("s = r cos φ + sqrt(l^2 - r^2 sin^2 φ)", "holds"),
    ("s = r sin φ + sqrt(l^2 - r^2 sin^2 φ)", "refuted"),
    ("s = r cos φ + sqrt(l^2 - r^2 cos^2 φ)", "refuted"),
    ("ds/dt ≈ -r ω (sin φ + r/(2l) sin 2φ)", "holds_to_order"),
    ("ds/dt ≈ -r ω (sin φ + r/l sin 2φ)", "refuted"),
]


@pytest.mark.parametrize(("of_engine", "of_cylinder"), ANGLES)
@pytest.mark.parametrize(("line", "word"), CASES)
def test_a_formula_is_judged_in_the_angle_that_it_has(tmp_path, of_engine, of_cylinder, line, word):
    path = tmp_path / "page.txt"
    path.write_text(f"One cylinder leans by γ, φ = θ - γ.\n\n{line}\n", encoding="utf-8")
    path.with_suffix(".symbols.toml").write_text(
        f"""[symbols]
"r" = "crank radius"
"l" = "rod length"
"ω" = "angular speed"
"γ" = "half of the bank angle"
"s" = "height of the piston pin above the crank centre"
"θ" = "{of_engine}"
"φ" = "{of_cylinder}"
""",
        encoding="utf-8",
    )
    verdicts = check(path, fixes=False).verdicts
    assert verdicts[-1].verdict == word
