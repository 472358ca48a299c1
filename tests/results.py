"""One example of every result the library computes, for tests that hold for all of them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from cranks import sheet, written

import symbalance as sb
from symbalance.crankshaft.files import read_running_engine
from symbalance.crankshaft.reports import summary
from symbalance.crankshaft.running import setting, swept
from symbalance.document.result import Result


def _balance() -> Result:
    return sb.balance(sb.load("v10-72"), 6)


def _balance_unlike() -> Result:
    return sb.balance(sb.load("r-985"), 4)


def _rotor() -> Any:
    discs = {0.5: sb.Disc(32.6, 0.33, 0.18)}
    return sb.shaft([sb.Tube(1.5, 0.05)], discs, bearings=(0.0, 1.5))


UNEVEN = [sb.Support((1e6, 8e5), damping=100.0)] * 2
"""Supports softer sideways, N/m, with damping in N s/m."""


def _modes() -> Result:
    return sb.natural_modes(_rotor(), 5)


def _campbell() -> Result:
    rotor = _rotor()
    return sb.campbell(rotor, [0.0, 200.0, 400.0], sb.held_at(rotor, 1e6, axial=1e8), count=8)


def _whirl() -> Result:
    return sb.whirl(_rotor(), UNEVEN, 400.0)


def _critical_speeds() -> Result:
    return sb.critical_speeds(_rotor(), UNEVEN, most=600.0)


def _unbalance_response() -> Result:
    return sb.unbalance_response(_rotor(), UNEVEN, {0.5: 1e-3, 0.0: 2e-4j}, [80.0, 400.0])


def _torsional_chain() -> Result:
    return sb.torsional_chain([3.5e-3, 3.5e-3, 3.5e-3, 0.15, 0.05], [12e3, 12e3, 14e3, 10e3])


def _crank_node() -> Result:
    return sb.node_equations("uvw")


def _crankshaft() -> Result:
    """A run of one cylinder at three speeds, of which the last is not to be relied on."""
    with TemporaryDirectory() as folder:
        engine = read_running_engine(written(Path(folder), sheet())).at_speeds((1000.0, 1500.0, 2000.0))
        made = setting(engine, webs="nominal", steps=120, about="centre")
        outcomes = swept(made, None, lambda line: None)
    lost = replace(outcomes[-1], reason="films do not settle at 120 steps a cycle")
    return summary(made, [*outcomes[:-1], lost])


EXAMPLES: dict[str, Callable[[], Result]] = {
    "balance": _balance,
    "balance-unlike": _balance_unlike,
    "campbell": _campbell,
    "crank-node": _crank_node,
    "crankshaft": _crankshaft,
    "critical-speeds": _critical_speeds,
    "natural-modes": _modes,
    "torsional-chain": _torsional_chain,
    "unbalance-response": _unbalance_response,
    "whirl": _whirl,
}
"""By a name of its own for each; a class may have several."""


@cache
def example(name: str) -> Result:
    """Return an example, computed once."""
    return EXAMPLES[name]()


def result_classes() -> set[type[Result]]:
    """Return every class of result in the package, all of its modules imported."""
    from importlib import import_module
    from pkgutil import walk_packages

    import symbalance

    for module in walk_packages(symbalance.__path__, "symbalance."):
        if ".bench" not in module.name and not module.name.endswith("__main__"):
            import_module(module.name)
    return _below(Result)


def _below(cls: type[Result]) -> set[type[Result]]:
    own = {cls} if cls is not Result else set()
    return own.union(*map(_below, cls.__subclasses__())) if cls.__subclasses__() else own
