"""Forces of an engine's cylinders in one direction: one with other signs than its place is refuted."""

from __future__ import annotations

import pytest

from symbalance.checking import check

WORDS = {
    "flat four": "# The flat four\n\nThe throws stand at 0°, 180°, 180°, 0°; {pair} are on the right. "
    "Forces to the right are positive, $P = m r\\omega^2$, $\\lambda = r/l$.\n\n",
    "boxer": "# Vierzylinder-Boxermotor\n\nDie Zylinder {pair} liegen links, die Kraft nach links zählt "
    "positiv; $P = m r\\omega^2$, $\\lambda = r/l$.\n\n",
    "in line": "# Reihenvierzylinder\n\nKröpfungen bei 0°, 180°, 180° und 0°, "
    "$P = m r\\omega^2$, $\\lambda = r/l$.\n\n",
}
PAIRS = {"flat four": "cylinders {} and {}", "boxer": "{} und {}", "in line": "{}{}"}
LINE = r"$F_{k} = {first}P\cos\theta {second} \lambda P\cos2\theta$"
SIGNS = {
    ("flat four", "13"): "++ -- -+ +-",
    ("flat four", "12"): "++ -+ -- +-",
    ("boxer", "13"): "++ -- -+ +-",
    ("boxer", "12"): "++ -+ -- +-",
    ("in line", "13"): "++ -+ -+ ++",
}


def page(kind: str, pair: str, signs: list[str]) -> str:
    lines = [
        LINE.replace("{k}", str(k)).replace("{first}", own[0].strip("+")).replace("{second}", own[1])
        for k, own in enumerate(signs, 1)
    ]
    return WORDS[kind].replace("{pair}", PAIRS[kind].format(*pair)) + "\n\n".join(lines) + "\n"


def words(kind: str, pair: str, signs: list[str]) -> list[str]:
    return [entry["verdict"] for entry in check(page(kind, pair, signs)).data()["links"]][-4:]


@pytest.mark.parametrize(("kind", "pair"), SIGNS)
def test_forces_of_all_cylinders_hold_together(kind, pair):
    assert words(kind, pair, SIGNS[kind, pair].split()) == ["conditional"] * 4


@pytest.mark.parametrize(("kind", "pair"), SIGNS)
@pytest.mark.parametrize("number", [1, 2, 3, 4])
@pytest.mark.parametrize("order", [0, 1])
def test_a_wrong_sign_is_that_cylinders(kind, pair, number, order):
    signs = SIGNS[kind, pair].split()
    own = signs[number - 1]
    signs[number - 1] = "".join("+-"[c == "+"] if k == order else c for k, c in enumerate(own))
    verdicts = words(kind, pair, signs)
    assert verdicts.pop(number - 1) == "refuted"
    assert "refuted" not in verdicts


def test_several_wrong_signs_are_another_engines():
    assert not {"refuted", "conditional"} & {*words("flat four", "13", ["++", "+-", "-+", "--"])}
