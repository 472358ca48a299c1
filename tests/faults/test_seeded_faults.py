"""Evidence about the evidence: small faults put into the core on purpose, and seen by the checkers.

Each test breaks one thing (a sign, a Catalan number, a bank, the mean station, a rewriting rule)
for its own duration and asserts that the comparison with quadrature raises. Without the fault the
same comparison passes, which the first test holds.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
from mpmath import mp

from symbalance.engine.builders import inline, vee
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine
from symbalance.exact import phasor, spectrum
from symbalance.exact.phasor import Phasor
from symbalance.exact.radicals import characters, forms
from symbalance.forces import force_sums
from symbalance.forces import free_forces as balance_module
from symbalance.kinematics.coefficients import FORCE
from symbalance.kinematics.slider_crank import acceleration_series, power_series
from tests import kinematics
from tests.independent.test_against_quadrature import DisagreementError, assert_agrees, assert_close
from tests.kinematics import DIGITS, Place

ORDER = 6
VEE_PLACES = [
    Place(Fraction(throw + on), Fraction(bank), Fraction(station))
    for station, throw in ((1, 0), (0, 100), (-1, 220))
    for bank, on in ((-35, 0), (35, 20))
]


def compare_seven() -> None:
    """Sevenths: where normal forms matter."""
    assert_agrees(inline([1, 6, 3, 5, 2, 7, 4]), order=8)


def compare_nine() -> None:
    """Ninths: a prime whose square divides the modulus."""
    assert_agrees(inline([1, 6, 3, 8, 5, 2, 7, 4, 9]), order=4)


def compare_vee() -> None:
    """A splayed vee, its places written out above rather than asked of the layout."""
    layout = vee(70, pins=[0, 100, 220], splay=20)
    assert_agrees(layout, places=VEE_PLACES, order=ORDER)


def compare_off_centre() -> None:
    """Stations whose mean is not 0."""
    layout = Engine([Cylinder(1, 0, 0, 2), Cylinder(2, 90, 10, 5)])
    assert_agrees(layout, order=ORDER)


def compare_series() -> None:
    """Powers of 1/lambda against quadrature at lambda = 4."""
    ratio = Fraction(4)
    with mp.workdps(DIGITS):
        lam = kinematics.number(ratio)
        measured = kinematics.harmonics(
            lambda p: kinematics.acceleration(p, lam), range(1, 7), kinematics.points_for(ratio, 6)
        )
        for n in (2, 4, 6):
            value = kinematics.number(acceleration_series(n, n + 81).at(ratio))
            assert_close(value, measured[n][0].real, f"series of A_{n}")


@pytest.fixture(autouse=True)
def _no_memory() -> Iterator[None]:
    """Nothing found under a fault may stay in a cache, nor anything found without it."""
    forget = _caches()
    forget()
    yield
    forget()


def _caches() -> Callable[[], None]:
    """Return what clears the caches there are now, even once a fault has replaced one."""
    found = [
        thing.cache_clear
        for module in (phasor, forms, characters, power_series)
        for thing in vars(module).values()
        if hasattr(thing, "cache_clear")
    ]
    return lambda: [clear() for clear in found] and None


COMPARISONS: list[Callable[[], None]] = [
    compare_seven,
    compare_nine,
    compare_vee,
    compare_off_centre,
    compare_series,
]


@pytest.mark.slow
@pytest.mark.parametrize("compare", COMPARISONS)
def test_without_a_fault_all_agree(compare: Callable[[], None]) -> None:
    compare()


def assert_seen(compare: Callable[[], None]) -> None:
    with pytest.raises(DisagreementError):
        compare()


def test_a_flipped_sign_in_order_four(monkeypatch: pytest.MonkeyPatch) -> None:
    sound = FORCE.values

    def faulty(*given: Any) -> dict[int, mp.mpf]:
        values = sound(*given)
        return {n: -v if n == 4 else v for n, v in values.items()}

    monkeypatch.setattr(balance_module, "FORCE", replace(FORCE, values=faulty))
    assert_seen(compare_vee)


def test_a_wrong_catalan_number(monkeypatch: pytest.MonkeyPatch) -> None:
    """Catalan(k-1) is C(2k-2, k-1)/k; the one below it in the table is given instead."""
    sound = power_series.comb
    monkeypatch.setattr(power_series, "comb", lambda n, k: sound(n - 2, k - 1) if k > 1 else sound(n, k))
    assert_seen(compare_series)


def test_a_digit_in_the_thirtieth_place(monkeypatch: pytest.MonkeyPatch) -> None:
    sound = FORCE.values

    def faulty(*given: Any) -> dict[int, mp.mpf]:
        with mp.workdps(DIGITS):
            return {n: v * (1 + mp.mpf(10) ** -28) for n, v in sound(*given).items()}

    monkeypatch.setattr(balance_module, "FORCE", replace(FORCE, values=faulty))
    assert_seen(compare_vee)


def _with_rows(monkeypatch: pytest.MonkeyPatch, change: Callable[[int, int, int], tuple]) -> None:
    sound = force_sums._exponent_sums

    def faulty(rows: Any, n: int, modulus: int) -> dict[int, int]:
        return sound([change(*row) for row in rows], n, modulus)

    monkeypatch.setattr(force_sums, "_exponent_sums", faulty)


def test_a_bank_on_the_wrong_side(monkeypatch: pytest.MonkeyPatch) -> None:
    _with_rows(monkeypatch, lambda bank, delay, weight: (-bank, delay, weight))
    assert_seen(compare_vee)


def test_a_crank_that_turns_the_wrong_way(monkeypatch: pytest.MonkeyPatch) -> None:
    _with_rows(monkeypatch, lambda bank, delay, weight: (bank, -delay, weight))
    assert_seen(compare_vee)


def test_a_delay_that_forgets_the_bank(monkeypatch: pytest.MonkeyPatch) -> None:
    _with_rows(monkeypatch, lambda bank, delay, weight: (bank, delay + bank, weight))
    assert_seen(compare_vee)


def test_couples_about_the_origin_instead_of_the_mean(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Engine, "mean_station", Fraction(0))
    assert_seen(compare_off_centre)


def test_a_lateral_component_with_its_sign_turned(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(spectrum, "QUARTER", Fraction(-1, 4))
    assert_seen(compare_vee)


def test_a_rewriting_rule_with_a_wrong_shift(monkeypatch: pytest.MonkeyPatch) -> None:
    """The powers zeta^(k + i) summed to zero, where those of zeta^(k + i m/p) are."""
    sound = phasor._steps
    monkeypatch.setattr(
        phasor, "_steps", lambda modulus: tuple((*step[:3], 1) for step in sound(modulus))
    )
    assert_seen(compare_nine)


def test_a_rewriting_rule_with_a_wrong_sign(monkeypatch: pytest.MonkeyPatch) -> None:
    sound = phasor._ReductionTable.__missing__

    def faulty(self: Any, exponent: int) -> tuple:
        self[exponent] = tuple((place, 1) for place, _ in sound(self, exponent))
        return self[exponent]

    monkeypatch.setattr(phasor._ReductionTable, "__missing__", faulty)
    assert_seen(compare_seven)


def test_a_number_called_zero_that_is_none(monkeypatch: pytest.MonkeyPatch) -> None:
    """An order dropped: its quadrature is not zero, and the checker looks at absent orders too."""
    sound = Phasor.is_zero

    def faulty(self: Phasor) -> bool:
        size = sum(c * cmath.exp(2j * cmath.pi * k / self.modulus) for k, c in self.terms.items())
        return sound(self) or abs(size) < 0.5

    monkeypatch.setattr(Phasor, "is_zero", faulty)
    assert_seen(compare_off_centre)


def test_a_phase_in_the_wrong_quadrant(monkeypatch: pytest.MonkeyPatch) -> None:
    sound = spectrum.turns_and_size

    def faulty(number: Phasor) -> Any:
        found = sound(number)
        return found and (-found[0], found[1])

    monkeypatch.setattr(spectrum, "turns_and_size", faulty)
    assert_seen(compare_vee)


def test_a_root_with_the_wrong_sign(monkeypatch: pytest.MonkeyPatch) -> None:
    sound = characters._part_form
    monkeypatch.setattr(
        characters, "_part_form", lambda part, order: sound(part, order).scaled(-1 if order > 1 else 1)
    )
    assert_seen(compare_off_centre)
