"""One example of every result the library computes, for tests that hold for all of them."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import symbalance as sb
from symbalance.document.result import Result


def _balance() -> Result:
    return sb.balance(sb.load("v10-72"), 6)


def _balance_unlike() -> Result:
    return sb.balance(sb.load("r-985"), 4)


def _derivation() -> Result:
    return sb.derive("force", 6)


def _crank_stars() -> Result:
    return sb.crank_stars(5)


def _firing_orders() -> Result:
    return sb.firing_orders(sb.load("vw-vr6"), within="1/2")


def _truncation_bounds() -> Result:
    return sb.truncation_bounds("force", "7/2", 12)


def _harmonics() -> Result:
    return sb.harmonics("displacement", 6)


def _design() -> Result:
    return sb.design_balance(sb.load("inline-5"), [1, 2], shafts=2)


def _design_unlike() -> Result:
    return sb.design_balance(sb.load("vw-vr6"), [1], per_throw=True)


def _ellipse() -> Result:
    return sb.ellipse(sb.balance(sb.load("v10-72"), 1), 1, "couple")


def _rotating_balance() -> Result:
    pins = [("3/2", 0), ("1/2", 90), ("-1/2", 270), ("-3/2", 180)]
    weights = [sb.Weight(station, angle, unbalance=60) for station, angle in pins]
    return sb.balanced_weights(weights, [2, -2])


EXAMPLES: dict[str, Callable[[], Result]] = {
    "balance": _balance,
    "balance-unlike": _balance_unlike,
    "derivation": _derivation,
    "crank-stars": _crank_stars,
    "firing-orders": _firing_orders,
    "truncation-bounds": _truncation_bounds,
    "harmonics": _harmonics,
    "design": _design,
    "design-unlike": _design_unlike,
    "ellipse": _ellipse,
    "rotating-balance": _rotating_balance,
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
    return {cls for cls in _below(Result) if cls.kind}


def _below(cls: type[Result]) -> set[type[Result]]:
    """Return a class and all that derive from it, those that only others derive from among them."""
    return {cls}.union(*map(_below, cls.__subclasses__()))
