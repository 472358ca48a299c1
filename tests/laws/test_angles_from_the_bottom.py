"""Where a page counts its crank angle from bottom dead centre, no formula of the other angle holds."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

PROVED = ("holds", "holds_to_order", "conditional")
FROM_BOTTOM = (
    "The angle θ is counted from bottom dead centre. The piston's acceleration is a ≈ {}, λ = r/l.",
    "The crank angle θ is measured from BDC. The piston acceleration is a ≈ {} with λ = r/l.",
    "Der Winkel θ wird vom unteren Totpunkt aus gezählt. Die Kolbenbeschleunigung ist a ≈ {}, λ = r/l.",
    "L'angle θ est compté à partir du point mort bas. L'accélération du piston est a ≈ {}, λ = r/l.",
    "クランク角 θ は下死点から測る。ピストンの加速度は a ≈ {}、λ = r/l。",
    "El ángulo θ se mide desde el punto muerto inferior. La aceleración del pistón es a ≈ {}, λ = r/l.",
    "L'angolo θ è misurato dal punto morto inferiore. L'accelerazione del pistone è a ≈ {}, λ = r/l.",
)
OF_TOP, OF_BOTTOM = "r ω² (cos θ + λ cos 2θ)", "r ω² (−cos θ + λ cos 2θ)"
COUNTED = "The crank angle φ is measured from BDC. "
PAIRS = (
    (
        "With φ from BDC, the piston displacement from BDC is x ≈ {}, r crank radius, l rod length.",
        "r (1 − cos φ) − (r²/(2l)) sin² φ",
        "r (1 − cos φ) + (r²/(2l)) sin² φ",
    ),
    (
        COUNTED + "The piston displacement from top dead centre is s ≈ {} with λ = r/l.",
        "r (1 + cos φ) + (λ r/2) sin² φ",
        "r (1 − cos φ) + (λ r/2) sin² φ",
    ),
    (
        COUNTED + "The piston velocity is v ≈ {} with λ = r/l.",
        "r ω (sin φ − (λ/2) sin 2φ)",
        "r ω (sin φ + (λ/2) sin 2φ)",
    ),
    (
        COUNTED + "The inertia force of the piston is F ≈ {} with λ = r/l.",
        "m r ω² (λ cos 2φ − cos φ)",
        "m r ω² (cos φ + λ cos 2φ)",
    ),
)
USUAL = (
    "The crank angle θ is measured from top dead centre. The piston acceleration is a ≈ {}, λ = r/l.",
    "The crank angle θ is measured from TDC. The exhaust opens at an angle of 50° before bottom dead "
    "centre. The piston acceleration is a ≈ {} with λ = r/l.",
    "The piston moves from bottom dead centre to top dead centre. Its acceleration is a ≈ {} with "
    "λ = r/l, θ the crank angle.",
    "The crank turns through the angle θ. From bottom dead centre the piston goes up. "
    "The piston acceleration is a ≈ {} with λ = r/l.",
)


def _verdict(tmp_path, text):
    page = tmp_path / "page.md"
    page.write_text(text + "\n", encoding="utf-8")
    return next(each for each in check(page, fixes=False).verdicts if "λ =" not in each.source)


@pytest.mark.parametrize("text", FROM_BOTTOM)
def test_an_acceleration_goes_with_the_angle_that_is_counted(tmp_path, text):
    assert _verdict(tmp_path, text.format(OF_BOTTOM)).verdict in PROVED
    wrong = _verdict(tmp_path, text.format(OF_TOP))
    assert wrong.verdict in ("undecided", "refuted")
    assert "bottom dead centre" in wrong.reason


@pytest.mark.parametrize(("text", "right", "wrong"), PAIRS)
def test_other_motions_go_with_the_angle_that_is_counted(tmp_path, text, right, wrong):
    assert _verdict(tmp_path, text.format(right)).verdict in PROVED
    assert _verdict(tmp_path, text.format(wrong)).verdict in ("undecided", "refuted")


@pytest.mark.parametrize("text", USUAL)
def test_an_angle_from_the_top_is_as_before(tmp_path, text):
    assert _verdict(tmp_path, text.format(OF_TOP)).verdict in PROVED
