"""Table of every symbol in the formulas: its name in Python, its LaTeX, its unit and its meaning.

=======  ==========  =====  ==========================================================
name     LaTeX       unit   meaning
=======  ==========  =====  ==========================================================
theta    \\theta      rad    crank angle, positive with the rotation; a pin stands at
                            theta + throw from straight up
lam      \\lambda     1      rod ratio l/r (rod length over crank radius), above 1
rho      \\rho        1      crank ratio r/l = 1/lam
r        r           m      crank radius, half the stroke
l        l           m      connecting rod length between centres
m        m           kg     reciprocating mass of one cylinder
omega    \\omega      rad/s  angular speed of the crank
a        a           m      pitch between neighbouring cylinders of a bank
=======  ==========  =====  ==========================================================

SymPy is imported when a symbol is first asked for, so that what needs no symbol stays light.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, NamedTuple

from symbalance.errors import SymbalanceError, brief

if TYPE_CHECKING:
    import sympy


class SymbolMeaning(NamedTuple):
    """What a symbol stands for."""

    latex: str
    unit: str
    meaning: str


MEANINGS = {
    "theta": SymbolMeaning(r"\theta", "rad", "crank angle, positive with the rotation"),
    "lam": SymbolMeaning(r"\lambda", "1", "rod ratio l/r"),
    "rho": SymbolMeaning(r"\rho", "1", "crank ratio r/l"),
    "r": SymbolMeaning("r", "m", "crank radius"),
    "l": SymbolMeaning("l", "m", "connecting rod length"),
    "m": SymbolMeaning("m", "kg", "reciprocating mass of one cylinder"),
    "omega": SymbolMeaning(r"\omega", "rad/s", "angular speed of the crank"),
    "a": SymbolMeaning("a", "m", "cylinder pitch"),
}

_REAL_ONLY = {"theta"}


@cache
def symbol(name: str) -> sympy.Symbol:
    """Return the SymPy symbol of that name, always the same object; all but theta are positive.

    >>> symbol("lam").is_positive, symbol("theta").is_positive
    (True, None)
    """
    import sympy

    if not isinstance(name, str) or name not in MEANINGS:
        raise SymbalanceError(f"symbol = {brief(name)}", "is unknown", f"known: {', '.join(MEANINGS)}")
    return sympy.Symbol(name, real=True) if name in _REAL_ONLY else sympy.Symbol(name, positive=True)
