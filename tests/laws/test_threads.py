"""Eight threads at once, with fresh caches: every answer to the byte what one thread alone gives.

Beside them another thread keeps setting mpmath's precision to odd values: they neither count nor change.
"""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from functools import cache

import pytest
from mpmath import mp

import symbalance as sb
from symbalance.design.balancing import ellipse
from symbalance.kinematics.mechanism_torque import inertia_harmonics
from symbalance.kinematics.mechanisms import LinkRod, SliderCrank, dead_centres, force_harmonics
from symbalance.kinematics.piston_torque import torque_left_out, torque_values
from symbalance.kinematics.slider_crank import acceleration_values
from symbalance.kinematics.truncation import left_out
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.tree_constructs import AREAS
from symbalance.notes.algebra.tree_values import TreeValues
from symbalance.notes.algebra.values import context
from symbalance.notes.reading import read_equation
from tests.caches import clear_caches

THREADS = 8
PRECISIONS = (1, 7, 33, 90)
"""Digits that the host sets meanwhile."""
PAGE = "$a = 2 \\sin(0.3)$\n\n$\\sin^2 x + \\cos^2 x = 1$\n\n$\\sqrt{2} \\approx 1.4142$\n"
ENGINES = ("inline-4", "v8-90", "vw-vr6", "inline-5", "boxer-2", "v2-45")
OFFSET = SliderCrank(4, "1/2")
HUNG = LinkRod(SliderCrank(4), "1/9", "3/4", "13/4", "1/9")


def calls() -> dict[str, Callable[[], object]]:
    """Return what is asked of the library, each call by a name, its answer a text or a number."""
    found: dict[str, Callable[[], object]] = {}
    for name in ENGINES:
        found |= {
            f"{name}: balance": lambda n=name: sb.to_text(sb.balance(sb.load(n), 6)),
            f"{name}: balance, JSON": lambda n=name: sb.to_json(sb.balance(sb.load(n), 6)),
            f"{name}: torque": lambda n=name: repr(
                sb.inertia_torque(sb.load(n), 6, ratio=_ratio(n)).terms()
            ),
            f"{name}: torque, printed": lambda n=name: sb.to_text(
                sb.torque.torque_report(sb.load(n), 6, ratio=_ratio(n))
            ),
            f"{name}: design": lambda n=name: sb.to_text(sb.design_balance(sb.load(n))),
            f"{name}: sensitivities": lambda n=name: repr(
                [(s.parameter, s.cylinder, s.factor, s.values) for s in sb.sensitivities(sb.load(n), 3)]
            ),
            f"{name}: source": lambda n=name: (
                sb.to_function(sb.balance(sb.load(n), 6), outputs="force.vertical", tolerance=1e-9).source
            ),
            f"{name}: worst cases": lambda n=name: repr(
                sb.worst_cases(sb.load(n), sb.design.Tolerances(throw="0.1", mass="1%"), 2).cases
            ),
        }
    for digits in (12, 20, 35, 50, 80, 120):
        found |= {
            f"A_n to {digits}": lambda d=digits: repr(acceleration_values(12, Fraction(37, 11), d)),
            f"t_n to {digits}": lambda d=digits: repr(torque_values(9, Fraction(37, 11), d)),
            f"offset to {digits}": lambda d=digits: repr(force_harmonics(OFFSET, 6, d)),
            f"torque of an offset axis to {digits}": lambda d=digits: repr(
                inertia_harmonics(OFFSET, 4, d)
            ),
            f"dead centres to {digits}": lambda d=digits: repr(dead_centres(HUNG, d)),
        }
    found |= {
        "left out": lambda: repr([left_out(n, Fraction(7, 2)) for n in (2, 6, 12)]),
        "torque left out": lambda: repr([torque_left_out(n, Fraction(7, 2)) for n in (2, 6, 12)]),
        "derivation": lambda: sb.to_text(sb.derive("force", 6)),
        "derivation of the rod's angle": lambda: sb.to_text(sb.derive("rod-angle", 5)),
        "ellipse": lambda: repr(ellipse(sb.balance(sb.load("v2-45"), 2)).reach(Fraction(1, 3))),
        "a page": lambda: sb.to_text(sb.check(PAGE)),
    }
    return found


def _ratio(name: str) -> object:
    return None if sb.load(name).ratio else 4


@pytest.fixture
def impatient() -> Iterator[None]:
    """Let threads take turns as often as Python can, and put mpmath's precision back."""
    interval, precision = sys.getswitchinterval(), mp.prec
    sys.setswitchinterval(1e-6)
    yield
    sys.setswitchinterval(interval)
    mp.prec = precision


def answers_of_threads(asked: dict[str, Callable[[], object]]) -> list[dict[str, object]]:
    """Return what each of `THREADS` threads was answered; each begins with another call."""
    names = list(asked)
    answers: list[dict[str, object]] = [{} for _ in range(THREADS)]
    start = threading.Barrier(THREADS)

    def work(place: int) -> None:
        start.wait()
        first = place * len(names) // THREADS
        for name in names[first:] + names[:first]:
            try:
                answers[place][name] = asked[name]()
            except Exception as problem:  # told apart from the answer below
                answers[place][name] = problem

    threads = [threading.Thread(target=work, args=(place,)) for place in range(THREADS)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return answers


def meddle(stop: threading.Event, changed: list[int]) -> None:
    """Set mpmath's precision to one value after another; note those that somebody else changed."""
    while not stop.is_set():
        for digits in PRECISIONS:
            mp.dps = digits
            stop.wait(0.002)
            if mp.dps != digits:
                changed.append(digits)


@pytest.mark.slow
@pytest.mark.usefixtures("impatient")
def test_threads_get_what_one_thread_gets() -> None:
    asked, stop = calls(), threading.Event()
    changed: list[int] = []
    clear_caches()
    host = threading.Thread(target=meddle, args=(stop, changed))
    host.start()
    found = answers_of_threads(asked)
    stop.set()
    host.join()
    clear_caches()
    mp.dps = 15
    alone = {name: call() for name, call in asked.items()}
    different = [name for one in found for name, answer in one.items() if answer != alone[name]]
    total = THREADS * len(asked)
    assert not different, f"{len(different)} of {total}: {sorted(set(different))}"
    assert not changed, f"mpmath's precision was changed {len(changed)} times"
    assert mp.dps == 15


@pytest.mark.slow
@pytest.mark.parametrize("digits", PRECISIONS)
def test_the_hosts_precision_does_not_count(digits: int) -> None:
    asked, before = calls(), mp.prec
    try:
        clear_caches()
        mp.dps = digits
        found = {name: call() for name, call in asked.items()}
        assert mp.dps == digits
    finally:
        mp.prec = before
    alone = answers_at_usual_precision()
    assert [name for name in asked if found[name] != alone[name]] == []


@cache
def answers_at_usual_precision() -> dict[str, object]:
    """Return every call's answer where nobody changes mpmath's precision, computed once."""
    clear_caches()
    return {name: call() for name, call in calls().items()}


def test_an_integral_that_is_kept_stays_in_its_thread() -> None:
    """Its number belongs to one mpmath context, and computing with it sets that context's precision."""
    area = read_equation("y = \\int_0^2 u^2 e^u\\,du", frozenset("yu")).sides[1].node

    def contexts() -> set[object]:
        TreeValues(SymbolValue(), {}).value(area)
        return {number.context for number in AREAS.values.values()}

    assert contexts() == {context()}
    with ThreadPoolExecutor(1) as pool:
        assert pool.submit(lambda: contexts() == {context()}).result()
