"""A design's JSON and rows against its own weights, turned by hand: forces, phases, what is left.

A weight of speed s at angle a has the force share e^(i (a + s theta)), straight up + i to the right. So
the harmonics of the engine as it was, plus those of the weights, must be what the design says it leaves.
"""

from __future__ import annotations

import cmath
from fractions import Fraction
from typing import Any

import pytest
import sympy

import symbalance as sb

SIZES = sb.engine.CrankTrain(
    stroke=Fraction(80), rod=Fraction(140), pitch=Fraction(100), reciprocating_mass=Fraction(1, 2)
)
DESIGNS = [
    ("inline-3", {"remove": [1, 2]}),
    ("inline-3", {"remove": [1, 2], "counter_rotation": False}),
    ("inline-4", {"remove": [2, 4], "stations": ["1/2", "-3/2"], "spread": "even"}),
    ("v6-90", {"remove": [1, 2], "shafts": 1}),
    ("v2-45", {"remove": [1, 2], "shafts": 1, "counterweights": False}),
    ("boxer-4", {"remove": [2]}),
    ("radial-5", {"remove": [1, 2]}),
]


def exact(text: str) -> float:
    return float(sympy.sympify(text, rational=True))


def vector(values: dict[str, Any]) -> complex:
    """Return cos + i sin of a component's values, its other spellings compared with it."""
    number = complex(exact(values["cos"]), exact(values["sin"]))
    assert cmath.rect(exact(values["amplitude"]), exact(values["phase"])) == pytest.approx(
        number, abs=1e-12
    )
    assert complex(*map(float, values["decimal"])) == pytest.approx(number, abs=1e-12)
    return number


def turning(orders: list[dict[str, Any]], kind: str) -> dict[int, complex]:
    """Return n -> c_n of e^(i n theta), from the vertical components of both turning parts."""
    parts = {}
    for row in orders:
        n = int(row["order"])
        forward, backward = vector(row[kind]["forward"]), vector(row[kind]["backward"])
        parts[n], parts[-n] = forward.conjugate(), backward
    return parts


def design_of(name: str, limits: dict[str, Any]) -> sb.design.Design:
    engine = sb.load(name)
    return sb.design_balance(
        sb.engine.from_cylinders(engine.cylinders, crank_train=SIZES, name=name), **limits
    )


@pytest.mark.spread(2)
@pytest.mark.parametrize(("name", "limits"), DESIGNS, ids=str)
def test_the_weights_turned_by_hand_leave_what_the_json_says(name, limits):
    design = design_of(name, limits)
    data, before = design.data(), design.before.data()
    assert data["remove"] == [str(n) for n in limits["remove"]]
    after = {}
    for kind in ("force", "couple"):
        sums = turning(before["orders"], kind)
        for device in data["devices"]:
            arms = [float(Fraction(w["station"])) if kind == "couple" else 1.0 for w in device["weights"]]
            shares = [vector(w["share"]) for w in device["weights"]]
            whole = sum(a * z for a, z in zip(arms, shares, strict=True))
            assert vector(device[kind]) == pytest.approx(whole, abs=1e-12)
            sums[device["speed"]] = sums.get(device["speed"], 0) + whole
        remains = turning(data["remains"]["orders"], kind)
        for n in {*sums, *remains}:
            assert remains.get(n, 0) == pytest.approx(sums.get(n, 0), abs=1e-12)
        after[kind] = sums
    assert len(data["certificate"]) == 4 * len(limits["remove"])
    was = {kind: turning(before["orders"], kind) for kind in ("force", "couple")}
    for claim in data["certificate"]:
        n, kind = int(claim["order"]), claim["kind"]
        old, new = was[kind].get(n, 0), after[kind].get(n, 0)
        assert vector(claim["left"]) == pytest.approx(new.conjugate() if n > 0 else new, abs=1e-12)
        words = {(False, False): "absent", (False, True): "added", (True, False): "removed"}
        by_hand = words.get((abs(old) > 1e-9, abs(new) > 1e-9))
        by_hand = by_hand or ("unchanged" if abs(old - new) < 1e-9 else "reduced")
        assert claim["verdict"] == by_hand
    assert data["complete"] == all(c["verdict"] in ("absent", "removed") for c in data["certificate"])
    left = {(int(row["order"]), row["kind"]): row for row in data["left"]}
    for n in limits["remove"]:
        for kind in ("force", "couple"):
            check_ellipse(left.get((n, kind)), after[kind].get(n, 0), after[kind].get(-n, 0))


def check_ellipse(row: dict[str, Any] | None, forward: complex, backward: complex) -> None:
    """Compare an ellipse with forward e^(i x) + backward e^(-i x) along its course."""
    course = [
        forward * cmath.exp(1j * k / 500) + backward * cmath.exp(-1j * k / 500) for k in range(3142)
    ]
    if row is None:
        assert max(map(abs, course)) < 1e-9
        return
    major, minor, direction = (exact(row[key]) for key in ("major", "minor", "direction"))
    far = max(course, key=abs)
    assert abs(far) == pytest.approx(major, rel=1e-5)
    assert min(map(abs, course)) == pytest.approx(minor, abs=2e-3 * major)
    if row["shape"] == "circle":
        assert (major, direction) == (pytest.approx(minor), 0)
    else:  # a straight angle either way
        across = (far * cmath.exp(-1j * direction)).imag
        assert abs(across) < 2e-2 * major * (1 if row["shape"] == "line" else 2)
        assert (row["shape"] == "line") == (minor < 1e-9)


@pytest.mark.spread(2)
@pytest.mark.parametrize(("name", "limits"), DESIGNS, ids=str)
def test_rows_and_unbalances_are_the_same_weights(name, limits):
    design = design_of(name, limits)
    data, rows = design.data(), design.records()
    values = {int(o["order"]): float(o["coefficient"]["value"]) for o in design.before.data()["orders"]}
    weights = [(device, w) for device in data["devices"] for w in device["weights"]]
    assert len(rows) == len(weights) > 0
    for row, (device, weight) in zip(rows, weights, strict=True):
        share, speed = vector(weight["share"]), device["speed"]
        assert row["speed"] == speed
        assert (device["kind"], row["on"]) in (("counterweights", "crank"), ("shaft", "shaft"))
        assert (row["on"] == "crank") == (speed == 1 and limits.get("counterweights", True))
        assert row["station"] == float(Fraction(weight["station"]))
        own = values.get(abs(speed), 0) if abs(speed) > 1 else 1.0
        below = -1 if own < 0 else 1  # a share of what is below 0 is so too, and the weight is not
        assert row["share"] == pytest.approx(below * abs(share), rel=1e-12)
        assert float(weight["direction"]) == pytest.approx(row["direction_deg"], rel=1e-12)
        # degrees from straight up, to the right
        turned = cmath.rect(row["share"], sympy.rad(row["direction_deg"]).evalf())
        assert complex(turned) == pytest.approx(share, rel=1e-9)
        assert complex(exact(row["exact_up"]), exact(row["exact_right"])) == pytest.approx(share)
        # kg mm: |share A_n| m r / n^2, at 0.5 kg and 40 mm
        unbalance = abs(share * own) * 0.5 * 40 / speed**2
        assert row["unbalance_kg_mm"] == pytest.approx(unbalance, rel=1e-9)
        assert float(weight["unbalance"]) == pytest.approx(unbalance, rel=1e-9)


@pytest.mark.spread(4)
@pytest.mark.parametrize(("name", "order"), [("v2-45", 1), ("v2-60", 2), ("inline-5", 1), ("v6-90", 2)])
@pytest.mark.parametrize("kind", ["force", "couple"])
def test_an_ellipse_in_decimals_is_the_exact_one(name, order, kind):
    balance = sb.balance(sb.load(name), 2)
    shape = sb.design.ellipse(balance, order, kind)
    data, (row,) = shape.data(), shape.records()
    forward, backward = vector(data["forward"]), vector(data["backward"])
    rows = [o for o in balance.data()["orders"] if o["order"] == str(order)]
    parts = turning(rows, kind) if rows else {order: 0j, -order: 0j}
    assert (forward, backward) == (pytest.approx(parts[order]), pytest.approx(parts[-order]))
    check_ellipse(data if shape.shape != "nothing" else None, forward, backward)
    major, minor, direction = map(float, data["decimal"])
    assert (major, minor) == pytest.approx((exact(data["major"]), exact(data["minor"])), abs=1e-15)
    assert (row["major"], row["minor"]) == pytest.approx((major, minor))
    if shape.shape in ("line", "ellipse"):
        off = (direction - exact(data["direction"])) / cmath.pi
        assert off == pytest.approx(round(off), abs=1e-9)
        assert row["direction_deg"] == pytest.approx(direction * 180 / cmath.pi)
    gap = abs(forward) - abs(backward)
    assert data["sense"] == (0 if abs(gap) < 1e-12 else 1 if gap > 0 else -1)
    for angle in (0.0, 0.4, -1.2):
        points = [
            forward * cmath.exp(1j * k / 100) + backward * cmath.exp(-1j * k / 100) for k in range(629)
        ]
        seen_along = max((z * cmath.exp(-1j * angle)).real for z in points)
        assert float(shape.reach(angle)) == pytest.approx(seen_along, rel=1e-4, abs=1e-12)


@pytest.mark.spread(4)
@pytest.mark.parametrize("in_kg_mm", [True, False])
@pytest.mark.parametrize("planes", [[2, -2], [3, 1, "-5/2"], [0], ["1/2"]])
def test_counterweights_to_turning_weights_are_in_balance_with_them(in_kg_mm, planes):
    """Statically in one plane, dynamically in two or more: sums of w and of z w over all of them."""
    unit = "unbalance" if in_kg_mm else "share"
    given = [("1", 20, 3), ("-2", 130, 5), ("1/3", 250, 2)]
    weights = [sb.engine.Weight(Fraction(z), angle, **{unit: size}) for z, angle, size in given]
    result = sb.design.balanced_weights(weights, planes)
    assert result.in_kg_mm == in_kg_mm
    data = result.data()
    assert data["unit"] == ("kg mm" if in_kg_mm else "m r")
    rows = [
        (float(Fraction(row["station"])), vector(row["vector"]))
        for row in [*data["counterweights"], *data["weights"]]
    ]
    assert [c.weight.in_kg_mm for c in result if c.weight] == [in_kg_mm] * len(result)
    sources = [(float(Fraction(z)), cmath.rect(size, angle * cmath.pi / 180)) for z, angle, size in given]
    assert rows[len(result) :] == [(z, pytest.approx(w)) for z, w in sources]
    assert abs(sum(w for _, w in rows)) < 1e-12
    couple = sum(z * w for z, w in rows)
    assert (abs(couple) < 1e-12) == (len(planes) > 1)
    assert {z for z, _ in rows[: len(result)]} <= {float(Fraction(z)) for z in planes}
    force = sum(w for _, w in sources)
    about_zero = sum(z * w for z, w in sources)
    assert vector(data["force"]["before"]) == pytest.approx(force)
    assert vector(data["couple"]["before"]) == pytest.approx(about_zero)
    assert vector(data["couple"]["left"]) == pytest.approx(couple, abs=1e-12)
    assert data["complete"] == (len(planes) > 1)
    assert [r["is_counterweight"] for r in result.records()] == [True] * len(result) + [False] * 3
    for record, (z, w) in zip(result.records(), rows, strict=True):
        turned = cmath.rect(record["size"], record["direction_deg"] * cmath.pi / 180)
        assert (record["station"], record["unit"]) == (z, data["unit"])
        assert turned == pytest.approx(w, abs=1e-12)
    assert complex(result.before[1].evaluated()) == pytest.approx(about_zero)
    assert complex(result.remains[1].evaluated()) == pytest.approx(couple, abs=1e-12)
