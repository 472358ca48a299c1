"""Roots of unity that a page names, ζ = e^{-2πi/5}: a number with a name, and no size of an example.

What gives r a number speaks of one engine. A root of unity is what it is wherever its letter stands.
"""

from __future__ import annotations

from functools import lru_cache

from symbalance.document.formula import Constant, Formula, names, walk
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.tree_values import NO_VALUE, TreeValues

MOST = 48
"""The highest order that is tried: engines have few cylinders."""
_NEAR = 1e-12


@lru_cache(maxsize=1000)
def order_of_root(node: Formula) -> int:
    """Return the least n for which zⁿ = 1 of a number that is not real; 0 for any other formula."""
    if names(node) or Constant("i") not in set(walk(node)):
        return 0
    try:
        value = complex(TreeValues(SymbolValue(), {}).value(node))
    except NO_VALUE:
        return 0
    if abs(abs(value) - 1) > _NEAR or abs(value.imag) < _NEAR:
        return 0
    return next((n for n in range(2, MOST + 1) if abs(value**n - 1) < n * _NEAR), 0)
