"""The three ways in which books write a series in powers of 1/lambda.

==========  ======================  =============================
convention  letter                  in terms of the rod ratio l/r
==========  ======================  =============================
l/r         lambda, in its inverse  itself
r/l         rho, in its powers      its inverse
l/s         lambda, in its inverse  half of it: the stroke is 2 r
==========  ======================  =============================

Formulas:
    rho = r/l = 1/lambda
"""

from __future__ import annotations

from typing import NamedTuple

from symbalance.errors import SymbalanceError, shown


class Convention(NamedTuple):
    """How rho = r/l is written: rho^p = letter^(direction p) / scale^p."""

    letter: str
    direction: int
    scale: int


CONVENTIONS = {
    "l/r": Convention("lam", -1, 1),
    "r/l": Convention("rho", 1, 1),
    "l/s": Convention("lam", -1, 2),
}


def convention_named(name: str) -> Convention:
    """Return a convention, or refuse a name that is none.

    >>> convention_named("l/s").scale
    2
    """
    if not isinstance(name, str) or name not in CONVENTIONS:
        rule = f"must be one of {', '.join(CONVENTIONS)}"
        raise SymbalanceError(f"convention = {shown(name)}", rule, "l/r is the default")
    return CONVENTIONS[name]
