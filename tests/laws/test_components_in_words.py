"""A component along the line of stroke has the cosine of the angle from it, one across it the sine."""

import pytest

import symbalance as sb

PAGES = [
    (
        "The component of P along the line of stroke is $F = ?$.",
        "cos",
        "crank angle from inner dead centre",
    ),
    (
        "The component of P across the line of stroke is $F = ?$.",
        "sin",
        "crank angle from inner dead centre",
    ),
    ("Die Komponente von P längs der Zylinderachse ist $F = ?$.", "cos", "Kurbelwinkel ab OT [rad]"),
    ("Die Komponente von P senkrecht zur Zylinderachse ist $F = ?$.", "sin", "Kurbelwinkel ab OT [rad]"),
    ("P のシリンダ軸方向の分力は $F = ?$ である。", "cos", "上死点から測ったクランク角 [rad]"),
]


def _last(page, angle, force="centrifugal force at the crank pin [N]"):
    symbols = {"theta": angle, "P": force}
    return sb.check(page + "\n", {"symbols": symbols}).data()["links"][-1]["verdict"]


@pytest.mark.parametrize(("page", "wave", "angle"), PAGES)
def test_a_component_has_the_wave_of_its_direction(page, wave, angle):
    other = "sin" if wave == "cos" else "cos"
    assert _last(page.replace("?", f"P \\{wave}\\theta"), angle) == "definition"
    assert _last(page.replace("?", f"P \\{other}\\theta"), angle) == "refuted"


@pytest.mark.parametrize(
    ("angle", "force"),
    [
        ("crank angle from top dead centre", "tangential force at the crank pin [N]"),
        ("angle of the crank from the horizontal", "centrifugal force [N]"),
        ("angle between two cranks", "centrifugal force [N]"),
    ],
)
def test_other_forces_and_other_angles_are_left_alone(angle, force):
    for wave in ("sin", "cos"):
        page = PAGES[0][0].replace("?", f"P \\{wave}\\theta")
        assert _last(page, angle, force) == "definition"
