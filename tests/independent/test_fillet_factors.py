"""Nominal stresses of an uneven, bored throw by beam statics, and the fillets' factors term by term.

The factors' coefficients are told from the function's values alone: with all else fixed a factor is a
polynomial or a power of one ratio, whose coefficients a fit gives back exactly.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from symbalance.crankshaft.assembly import assemble
from symbalance.crankshaft.crank import Crank, Disc, Journal, Pin, Web
from symbalance.crankshaft.stress import FilletFactors, channels, fillet_factors, stress_matrix

D = 0.05
JOURNAL, WEB, PIN = (
    Journal(0.06, 0.03, fillet=0.003),
    Web(0.02, 0.08, 0.04, 0.04),
    Pin(D, 0.03, 0.04, 0.7, (1,), fillet=0.0035),
)


def factors(**ratios: float) -> FilletFactors:
    """Return a web's factors at ratios of the pin's diameter, named as M53 has them."""
    at = {"s": 0.3, "w": 0.4, "b": 1.6, "r": 0.07, "r_G": 0.06, "d_G": 0.0, "d_H": 0.0, **ratios}
    journal = replace(JOURNAL, fillet=at["r_G"] * D, bore=at["d_G"] * D)
    pin = replace(PIN, fillet=at["r"] * D, bore=at["d_H"] * D)
    pin = replace(pin, radius=(pin.diameter + journal.diameter) / 2 - at["s"] * D)
    return fillet_factors(journal, replace(WEB, thickness=at["w"] * D, width=at["b"] * D), pin)


def ratio_of(name: str, **ratios: float) -> float:
    """Return a factor over itself at the reference ratios."""
    return getattr(factors(**ratios), name) / getattr(factors(), name)


FIVE, THREE = np.array([0.25, 0.37, 0.5, 0.63, 0.75]), np.array([0.25, 0.5, 0.75])
APART = np.array([0.6, 0.9, 1.2])  # 1 - s


def surface(name: str, thick: np.ndarray, power: float) -> np.ndarray:
    """Return the coefficients of f(s, w), rows by powers of 1 - s, over the constant of a factor."""
    values = np.array([[getattr(factors(s=1 - a, w=w), name) / w**power for w in thick] for a in APART])
    in_w = np.linalg.solve(np.vander(thick, increasing=True), values.T)
    return np.linalg.solve(np.vander(APART, increasing=True), in_w.T)


def test_bending_over_overlap_and_thickness():
    """f(s, w) of alpha_B and beta_B with their constants: 3 x 5 and 3 x 3 coefficients of the rule."""
    pin = [
        [-4.1883, 29.2004, -77.5925, 91.9454, -40.0416],
        [9.5440, -58.3480, 159.3415, -192.5846, 85.2916],
        [-3.8399, 25.0444, -70.5571, 87.0328, -39.1832],
    ]
    journal = [[-1.7625, 2.9821, -1.5276], [5.1169, -5.8089, 3.1391], [-2.1567, 2.3297, -1.2952]]
    wide = np.polyval([0.1473, -0.0077, 0.6840], 1.6), np.polyval([0.1176, 0.1197, 0.5616], 1.6)
    rest = 2.6914 * 2.1790 * 0.2081 * 0.07**-0.5231 * wide[0] * 0.9993 * 0.9978
    assert surface("pin_bending", FIVE, 0.7171) / rest == pytest.approx(np.array(pin), rel=1e-6)
    rest = 2.7145 * 2.2422 * 0.1908 * 0.06**-0.5568 * wide[1] * 1.0012 * 1.0022
    assert surface("journal_bending", THREE, 0.7548) / rest == pytest.approx(np.array(journal), rel=1e-6)


@pytest.mark.parametrize(
    ("name", "ratio", "coefficients"),
    [
        ("pin_bending", "b", [0.6840, -0.0077, 0.1473]),
        ("pin_bending", "d_G", [0.9993, 0.27, -1.0211, 0.5306]),
        ("pin_bending", "d_H", [0.9978, 0.3145, -1.5241, 2.4147]),
        ("pin_torsion", "b", [7.8955, -10.654, 5.3482, -0.857]),
        ("journal_torsion", "b", [7.8955, -10.654, 5.3482, -0.857]),
        ("journal_bending", "b", [0.5616, 0.1197, 0.1176]),
        ("journal_bending", "d_G", [1.0012, -0.6441, 1.2265]),
        ("journal_bending", "d_H", [1.0022, -0.1903, 0.0073]),
        ("journal_pressure", "b", [-0.5, 1.0]),
        ("journal_pressure", "d_H", [0.9937, -1.1949, 1.7373]),
    ],
)
def test_each_width_and_bore_has_its_polynomial(name, ratio, coefficients):
    low, high = (1.1, 2.2) if ratio == "b" else (0.0, 0.8)
    places = np.linspace(low, high, len(coefficients))
    values = [ratio_of(name, **{ratio: x}) for x in places]
    fit = np.linalg.solve(np.vander(places, increasing=True), values)
    assert fit / fit[0] == pytest.approx(np.array(coefficients) / coefficients[0], rel=1e-7)


@pytest.mark.parametrize(
    ("name", "ratio", "power"),
    [
        ("pin_bending", "r", -0.5231),
        ("journal_bending", "r_G", -0.5568),
        ("journal_pressure", "r_G", -0.2038),
        ("pin_torsion", "w", -0.145),
        ("journal_torsion", "w", -0.145),
        ("pin_torsion", "r", -0.322 + 0.1015 * 0.7),
        ("journal_torsion", "r_G", -0.322 + 0.1015 * 0.7),
    ],
)
def test_each_fillet_has_its_power(name, ratio, power):
    low, high = (0.25, 0.6) if ratio == "w" else (0.045, 0.11)
    grown = ratio_of(name, **{ratio: high}) / ratio_of(name, **{ratio: low})
    assert np.log(grown) / np.log(high / low) == pytest.approx(power, rel=1e-9)


def test_torsion_and_pressure_have_their_constants():
    at = factors()
    wide = np.polyval([-0.857, 5.3482, -10.654, 7.8955], 1.6)
    exponent = -0.322 + 0.1015 * 0.7
    assert at.pin_torsion == pytest.approx(0.8 * 0.07**exponent * wide * 0.4**-0.145, rel=1e-12)
    own = 0.06 * D / JOURNAL.diameter
    assert at.journal_torsion == pytest.approx(0.8 * own**exponent * wide * 0.4**-0.145, rel=1e-12)
    parabola = 0.4368 + 2.1630 * 0.7 - 1.5212 * 0.49
    pressure = 3.0128 * parabola * 0.4 / (0.0637 + 0.9369 * 0.4) * 1.1 * 0.5331 * 0.06**-0.2038 * 0.9937
    assert at.journal_pressure == pytest.approx(pressure, rel=1e-12)


@pytest.mark.parametrize(
    ("name", "low", "high"),
    [
        ("s", -0.5, 0.5),
        ("w", 0.2, 0.8),
        ("b", 1.1, 2.2),
        ("r", 0.03, 0.13),
        ("r_G", 0.03, 0.13),
        ("d_G", None, 0.8),
        ("d_H", None, 0.8),
    ],
)
def test_the_range_of_each_ratio_is_the_rules(name, low, high):
    for end, beyond in ((low, -1e-3), (high, 1e-3)):
        if end is not None:
            assert factors(**{name: end}).outside == ()
            assert factors(**{name: end + beyond}).outside == (f"{name} = {end + beyond:.4g}",)


# Statics: a throw with unlike journals, webs and bores on two bearings

ANGLE = 2.3
OUT, ACROSS = (np.array([np.cos(a), np.sin(a), 0.0]) for a in (ANGLE, ANGLE + np.pi / 2))
PARTS = (
    Journal(0.06, 0.03, bore=0.02, fillet=0.003),
    Web(0.02, 0.08, 0.04, 0.04),
    Pin(D, 0.036, 0.044, ANGLE, (1,), bore=0.018, fillet=0.003),
    Web(0.026, 0.094, 0.036, 0.042),
    Journal(0.068, 0.042, bore=0.03, fillet=0.0035),
)
SPAN = 0.015 + 0.02 + 0.036 + 0.026 + 0.021
BEFORE_PIN = 0.015 + 0.02 + 0.018
FRONT, REAR = (SPAN - BEFORE_PIN) / SPAN, BEFORE_PIN / SPAN
"""The shares of a load on the pin that the two bearings carry."""


def moduli(part: Journal | Pin) -> float:
    return np.pi * (part.diameter**4 - part.bore**4) / (32 * part.diameter)


def stresses(force: np.ndarray, at: str, torque: float = 0.0) -> dict[str, float]:
    """Return the channels under a force (3,) on the pin or the rear end, and a torque at the rear end."""
    crank = Crank(PARTS)
    rotor = assemble(crank)
    front, rear, last = rotor.journals[0], rotor.journals[-1], len(rotor.points) - 1
    fixed = [6 * front, 6 * front + 1, 6 * rear, 6 * rear + 1, 6 * front + 2, 6 * front + 5]
    free = [i for i in range(rotor.size) if i not in fixed]
    loads, moved = np.zeros(rotor.size), np.zeros(rotor.size)
    node = rotor.pins[0] if at == "pin" else last
    loads[6 * node : 6 * node + 3] = force
    loads[6 * last + 5] += torque
    moved[free] = np.linalg.solve(rotor.stiffness[np.ix_(free, free)], loads[free])
    rows = channels(crank, rotor)
    turn = np.degrees(moved[6 * rear + 5] - moved[6 * front + 5])
    by_name = dict(zip([c.name for c in rows], stress_matrix(rows) @ moved, strict=True))
    assert by_name["twist 1"] == pytest.approx(turn, rel=1e-9, abs=1e-15)
    return by_name


def web_factors(web: int) -> FilletFactors:
    journal, slab = (PARTS[0], PARTS[1]) if web == 1 else (PARTS[4], PARTS[3])
    assert isinstance(journal, Journal)
    assert isinstance(slab, Web)
    assert isinstance(PARTS[2], Pin)
    return fillet_factors(journal, slab, PARTS[2])


def test_a_load_on_the_pin_of_an_uneven_throw():
    load = 9e3
    by_name = stresses(-load * OUT, "pin")
    pin = load * FRONT * BEFORE_PIN / moduli(PARTS[2])
    assert by_name["pin 1 bending"] == pytest.approx(pin, rel=1e-9)
    assert by_name["pin 1 sideways"] == pytest.approx(0, abs=10)
    for web, share, arm, width, thick in (
        (1, FRONT, 0.015 + 0.01, 0.08, 0.02),
        (2, REAR, 0.021 + 0.013, 0.094, 0.026),
    ):
        bent, pressed = load * share * arm * 6 / (width * thick**2), -load * share / (width * thick)
        by_rule = web_factors(web)
        at_pin, at_journal = (by_name[f"web {web} {end} fillet bending"] for end in ("pin", "journal"))
        assert at_pin == pytest.approx(bent * by_rule.pin_bending, rel=1e-9)
        expected = pressed * by_rule.journal_pressure - bent * by_rule.journal_bending
        assert at_journal == pytest.approx(expected, rel=1e-9)


def test_a_load_across_the_throw_twists_by_what_the_held_front_bears():
    load = 7e3
    by_name = stresses(load * ACROSS, "pin")
    # about the pin's axis the front bearing's force has the lever of the radius
    held = load * 0.044 - load * FRONT * 0.044
    assert by_name["pin 1 torsion"] == pytest.approx(-held / (2 * moduli(PARTS[2])), rel=1e-9)
    bent = load * FRONT * BEFORE_PIN / moduli(PARTS[2])
    assert by_name["pin 1 sideways"] == pytest.approx(bent, rel=1e-9)
    assert by_name["pin 1 bending"] == pytest.approx(0, abs=10)
    held = load * 0.044 / (2 * moduli(PARTS[0])) * web_factors(1).journal_torsion
    assert by_name["web 1 journal fillet torsion"] == pytest.approx(-held, rel=1e-6)
    assert by_name["web 2 journal fillet torsion"] == pytest.approx(0, abs=50)


def test_a_pull_along_the_axis_opens_the_throw_and_stretches_the_pin():
    pull = 5e3
    by_name = stresses(np.array([0.0, 0.0, pull]), "rear")
    tension = pull / (np.pi / 4 * (D**2 - 0.018**2))
    assert by_name["pin 1 bending"] == pytest.approx(tension + pull * 0.044 / moduli(PARTS[2]), rel=1e-9)
    assert by_name["pin 1 sideways"] == pytest.approx(tension, rel=1e-9)
    for web, width, thick in ((1, 0.08, 0.02), (2, 0.094, 0.026)):
        bent = pull * 0.022 * 6 / (width * thick**2)
        by_rule = web_factors(web)
        for end, factor in (("pin", by_rule.pin_bending), ("journal", -by_rule.journal_bending)):
            assert by_name[f"web {web} {end} fillet bending"] == pytest.approx(bent * factor, rel=1e-6)


def test_a_torque_through_bored_parts():
    by_name = stresses(np.zeros(3), "rear", torque=-250.0)
    assert by_name["pin 1 torsion"] == pytest.approx(250 / (2 * moduli(PARTS[2])), rel=1e-9)
    for web, journal in ((1, PARTS[0]), (2, PARTS[4])):
        by_rule = web_factors(web)
        at_pin = 250 / (2 * moduli(PARTS[2])) * by_rule.pin_torsion
        at_journal = 250 / (2 * moduli(journal)) * by_rule.journal_torsion
        assert by_name[f"web {web} pin fillet torsion"] == pytest.approx(at_pin, rel=1e-6)
        assert by_name[f"web {web} journal fillet torsion"] == pytest.approx(at_journal, rel=1e-6)


def test_channels_name_their_factor_unit_and_what_is_extrapolated():
    wide = replace(PARTS[3], width=0.2)
    crank = Crank((*PARTS[:3], wide, PARTS[4]), flywheel=Disc(10.0, 0.2, 0.1))
    rows = {c.name: c for c in channels(crank, assemble(crank))}
    assert [c.unit for c in rows.values()].count("degrees") == 2  # between the bearings, to the flywheel
    assert {c.unit for name, c in rows.items() if "twist" not in name} == {"Pa"}
    assert rows["web 1 pin fillet bending"].factor == web_factors(1).pin_bending
    assert rows["web 1 journal fillet bending"].factor == web_factors(1).journal_bending
    assert rows["web 1 pin fillet torsion"].factor == web_factors(1).pin_torsion
    assert rows["web 1 journal fillet torsion"].factor == web_factors(1).journal_torsion
    assert (rows["web 1 pin fillet bending"].outside, rows["pin 1 bending"].factor) == ((), 1.0)
    assert rows["web 2 pin fillet bending"].outside == ("b = 4",)


def test_a_flying_web_has_pins_on_both_sides_and_no_published_factors():
    second = replace(PARTS[2], angle=ANGLE + 2.0, cylinders=(2,))
    crank = Crank((PARTS[0], PARTS[1], PARTS[2], PARTS[3], second, PARTS[1], PARTS[4]))
    names = [c.name for c in channels(crank, assemble(crank))]
    assert [web for web in (1, 2, 3) if any(n.startswith(f"web {web} ") for n in names)] == [1, 3]
    assert "pin 2 torsion" in names
