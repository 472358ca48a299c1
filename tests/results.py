"""One example of every result the library computes, for tests that hold for all of them."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import sympy

import symbalance as sb
from symbalance.document.result import Result


def _balance() -> Result:
    return sb.balance(sb.load("v10-72"), 6)


def _balance_unlike() -> Result:
    return sb.balance(sb.load("r-985"), 4)


PAGE = r"""
$$x \approx r(1-\cos\theta) + \frac{r}{2\lambda}(1-\cos 2\theta)$$

連桿比 $\lambda = 147.15/36.65 = 4.02$ and $|k| = |-k|$, so that $k \neq q$; $\ln(k^2) = 2 \ln k$

$$\frac{\mathrm{d}x}{\mathrm{d}\theta} 度 = r \sin\theta = r \cos\theta$$
"""
"""Every verdict, Japanese prose, and characters that each medium writes in its own way."""
LETTERS = {
    "theta": "crank angle",
    "r": "crank radius",
    "lambda": "rod ratio l/r",
    "x": "displacement from top dead centre",
    "k": "positive",
}


def _check() -> Result:
    return sb.check(PAGE, LETTERS)


def _verdict() -> Result:
    x = sympy.Symbol("x")
    return sb.check_equal(sympy.sin(x) ** 2, (1 + sympy.cos(2 * x)) / 2)


EXAMPLES: dict[str, Callable[[], Result]] = {
    "balance": _balance,
    "balance-unlike": _balance_unlike,
    "check": _check,
    "verdict": _verdict,
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
