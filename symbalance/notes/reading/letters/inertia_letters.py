"""Inertias J_2 that a page names: J_2 (n_2/n_1)² is a product then, and no Bessel function."""

from __future__ import annotations

from symbalance.text import lazy_patterns as re

_ALONE = re.compile(r"(?<![\\A-Za-z])J_\{?([A-Za-z0-9])\}?\s?(?:\$|\\\)|`)")
_BESSEL = re.compile("bessel", re.IGNORECASE)


def inertias_named(text: str) -> frozenset[str]:
    """Return the letters J_n that a page names alone, where it speaks of no Bessel function.

    >>> sorted(inertias_named("the inertia $J_2$")), inertias_named("$J_2(x)$")
    (['J_2'], frozenset())
    >>> inertias_named("Bessel's $J_2$")
    frozenset()
    """
    return frozenset() if _BESSEL.search(text) else frozenset(f"J_{n}" for n in _ALONE.findall(text))
