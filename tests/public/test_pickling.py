"""Errors and results on their way between processes: copied, pickled, and sent by a pool of workers."""

import copy
import importlib
import pickle
import pkgutil
import subprocess
import sys
import textwrap
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
import sympy

import symbalance
import symbalance as sb
from symbalance.budgets import OverBudgetError
from symbalance.crankshaft.system import UnsolvedError
from symbalance.errors import JobFaultError, MissingPartError, SymbalanceError
from symbalance.exact.phasor import Phasor
from symbalance.exact.spectrum import Spectrum
from symbalance.jobs.running import _NobodyLeftError
from symbalance.notes.checking.units.dimensions import Mismatch, _MismatchError
from symbalance.notes.reading.failures import ReadingError, UndeclaredError
from symbalance.torque import torque_report

ARGUMENTS = {
    SymbalanceError: ("throw = x", "must be a number", "write it like 120", "a.toml:3"),
    MissingPartError: ("matplotlib", "is not installed", "pip install matplotlib"),
    UnsolvedError: ("films at 3000 rpm", "do not settle", "take more steps"),
    ReadingError: (3, "unknown command", "write it out"),
    UndeclaredError: (4, "q_1"),
    OverBudgetError: ("10 s",),
    _MismatchError: (Mismatch("the left side is in", (Fraction(1),), (Fraction(2),)),),
    _NobodyLeftError: ("the executor", "is lost"),
    JobFaultError: ("ZeroDivisionError in exact/phasor.py:12", "Traceback ..."),
}
"""What each class of the package is constructed with, where that is not nothing."""

WAYS = {
    "copy": copy.copy,
    "deepcopy": copy.deepcopy,
    **{
        f"pickle {p}": lambda x, p=p: pickle.loads(pickle.dumps(x, p))
        for p in range(pickle.HIGHEST_PROTOCOL + 1)
    },
}


def exception_classes() -> list[type[BaseException]]:
    modules = [m.name for m in pkgutil.walk_packages(symbalance.__path__, "symbalance.")]
    classes = {
        value
        for name in modules
        if not name.endswith("__main__")
        for value in vars(importlib.import_module(name)).values()
        if isinstance(value, type) and issubclass(value, BaseException)
    }
    own = {kind for kind in classes if kind.__module__.startswith("symbalance")}
    return sorted(own, key=lambda kind: kind.__qualname__)


@pytest.mark.parametrize("way", WAYS)
def test_every_exception_of_the_package_copies_and_pickles(way):
    classes = exception_classes()
    assert {*ARGUMENTS} <= {*classes}
    assert len(classes) >= 8
    for kind in classes:
        error = kind(*ARGUMENTS.get(kind, ()))
        error.add_note("read from a file")
        again = WAYS[way](error)
        assert type(again) is kind
        assert (str(again), repr(again), again.args) == (str(error), repr(error), error.args)
        assert vars(again) == vars(error)


class TwoArgumentsError(SymbalanceError):
    """As a program may write it: arguments of its own, one of them by name only."""

    def __init__(self, number: int, *, unit: str) -> None:
        super().__init__(f"{number} {unit}", "is too much")
        self.number = number


def test_a_subclass_with_arguments_of_its_own_pickles_and_keeps_its_class():
    error = TwoArgumentsError(3, unit="kg").within("a.toml:3")
    assert type(error) is TwoArgumentsError
    assert str(error) == "a.toml:3: 3 kg: is too much"
    for again in (pickle.loads(pickle.dumps(error)), copy.deepcopy(error)):
        assert type(again) is TwoArgumentsError
        assert (str(again), again.number) == (str(error), 3)
    missing = MissingPartError("gmsh", "is not installed", "pip install gmsh").within("a.toml")
    assert type(missing) is MissingPartError  # it was a SymbalanceError once it had a place


POOL = """
import multiprocessing
import symbalance as sb

def job(name):
    return [(o.order, str(o.force.vertical.cos)) for o in sb.balance(sb.load(name), 4).orders]

if __name__ == "__main__":
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        print(pool.map(job, ["inline-4"]))
        try:
            pool.map(job, ["nope"])
        except sb.SymbalanceError as error:
            print("refused:", error)
"""


@pytest.mark.slow
def test_a_pool_of_workers_hands_a_refusal_on(tmp_path):
    """A worker's exception that cannot be read lets the pool wait for ever: here the test fails."""
    script = tmp_path / "pool.py"
    script.write_text(textwrap.dedent(POOL), encoding="utf-8")
    done = subprocess.run(
        [sys.executable, str(script)], capture_output=True, text=True, timeout=60, check=True
    )
    first, second = done.stdout.splitlines()
    assert first == "[[(2, '4'), (4, '4')]]"
    assert second.startswith("refused: ")
    assert "nope" in second


def test_the_components_of_a_copied_spectrum_are_its_own():
    """The cache went by the numbers' addresses, which after unpickling are those of other numbers."""

    def warm(first: int) -> bytes:
        made = Spectrum({n: Phasor.of(1, {0: first + n}) for n in (1, 2, 3)})
        for n in (1, 2, 3):
            _ = made.component(n, "forward").cos
        return pickle.dumps(made)

    for first in range(300):  # addresses are used again at once where the numbers before are gone
        again = pickle.loads(warm(first))
        assert [again.component(n, "forward").cos for n in (3, 2, 1)] == [first + n for n in (3, 2, 1)]
    other = replace(pickle.loads(warm(0)), terms={n: Phasor.of(1, {0: -n}) for n in (1, 2, 3)})
    assert [other.component(n, "forward").cos for n in (1, 2, 3)] == [-1, -2, -3]


def test_orders_with_the_same_numbers_share_components_also_in_a_copy():
    force = sb.balance(sb.load("inline-5"), 24).force
    shared = [
        n for n in force.orders() if force.component(n, "vertical") is force.component(10, "vertical")
    ]
    assert shared == [10, 20]
    for again in (pickle.loads(pickle.dumps(force)), copy.deepcopy(force)):
        assert again.component(20, "vertical") is again.component(10, "vertical")
        assert again.component(8, "vertical").is_zero()


ALPHA = sympy.Symbol("alpha", real=True)
LAYOUTS = {
    "v8-90": lambda: sb.load("v8-90"),
    "vw-vr6": lambda: sb.load("vw-vr6"),
    "r-1820": lambda: sb.load("r-1820"),
    "symbolic": lambda: sb.vee(ALPHA, pins=[0]),
}


@pytest.mark.spread(2)
@pytest.mark.parametrize("name", LAYOUTS)
@pytest.mark.parametrize("warm", [False, True])
def test_a_balance_says_the_same_after_pickle(name, warm):
    made = sb.balance(LAYOUTS[name](), 4)
    expected = sb.to_json(sb.balance(LAYOUTS[name](), 4))
    if warm:  # cached properties and components are pickled too
        assert sb.to_json(made) == expected
        _ = made.engine.modulus, made.engine.first, made.engine.has_common_harmonics
    for way in ("pickle 2", "pickle 5", "deepcopy"):
        again = WAYS[way](made)
        assert again.engine == made.engine
        assert hash(again.engine) == hash(made.engine)
        assert (sb.to_json(again), sb.to_text(again)) == (expected, sb.to_text(made))
        assert sb.to_latex(again) == sb.to_latex(made)


def twice(made):
    return {way: WAYS[way](made) for way in ("pickle 2", "pickle 5", "deepcopy")}.values()


@pytest.mark.slow
@pytest.mark.parametrize("name", ["inline-4", "vw-vr6", "v8-90"])
def test_torque_says_the_same_after_pickle(name):
    engine, warm = sb.load(name), torque_report(sb.load(name), 4)
    text = sb.to_text(warm)
    for again in [*twice(warm), *twice(torque_report(engine, 4))]:
        assert sb.to_text(again) == text
    sizes = {"reciprocating_mass": 0.5} if name == "vw-vr6" else {"reciprocating_mass": 0.5, "stroke": 80}
    running = sb.running_torque(engine, sb.torque.ideal_cycle(10, heat=20), bore=80, rpm=3000, **sizes)
    expected = running.mean, running.fluctuation, running.terms(3)
    for again in twice(running):
        assert (again.mean, again.fluctuation, again.terms(3)) == expected
    stars = [(s.order, s.vectors, s.is_closed()) for s in sb.torque.firing_stars(engine, 3)]
    for again in twice(sb.torque.firing_stars(engine, 3)):
        assert [(s.order, s.vectors, s.is_closed()) for s in again] == stars


@pytest.mark.slow
def test_designs_variations_and_verdicts_say_the_same_after_pickle():
    design = sb.design_balance(sb.load("inline-3"), remove=[1])
    for again in twice(design):
        assert sb.to_text(again) == sb.to_text(design)
        assert sb.to_json(again) == sb.to_json(design)
        assert again.balanced == design.balanced
    checked = sb.check("$$\\sin^2 x = \\frac{1 - \\cos 2x}{3}$$", {"x": "angle"})
    for again in twice(checked):
        assert (sb.to_json(again), sb.to_text(again)) == (sb.to_json(checked), sb.to_text(checked))
        assert again.verdicts[0].fix.text == "(1 - cos 2x)/2"
    three = sb.load("inline-3")
    changes = sb.sensitivities(three, 2)
    for again in twice(changes):
        assert [(c.parameter, c.step(), c.values) for c in again] == [
            (c.parameter, c.step(), c.values) for c in changes
        ]
    worst = sb.worst_cases(three, sb.design.Tolerances(mass="1%"), 2)
    assert all(again == worst for again in twice(worst))
    best = sb.design.assign_parts(three, [0.45, 0.46, 0.44])
    assert all(again == best for again in twice(best))
    steps = sb.derive(order=4)
    assert all(str(again) == str(steps) for again in twice(steps))


@pytest.mark.slow
@pytest.mark.parametrize("target", ["numpy", "numba"])
@pytest.mark.parametrize("warm", [False, True])
def test_functions_give_the_same_numbers_after_pickle(target, warm):
    made = sb.to_function(sb.balance(sb.load("v8-90")), outputs="couple.vertical", target=target)
    theta = np.linspace(-7, 7, 24)
    expected = sb.to_function(sb.balance(sb.load("v8-90")), outputs="couple.vertical")(theta)
    if warm:  # compiled already: the compiled module stays behind
        made(theta)
    for again in twice(made):
        np.testing.assert_allclose(again(theta), expected, rtol=0, atol=1e-14)
