"""Any result as text, LaTeX or JSON: a result prints itself, here it is asked to.

A class that has a form has the method for it, `as_text()`, `as_latex(standalone)` or `as_json()`; its
printer stands in the room of the class and is imported when it is called.
"""

from __future__ import annotations

from typing import Any

from symbalance.errors import SymbalanceError


def to_text(result: Any) -> str:
    """Return a result as text for a terminal of 80 columns: a balance, a design."""
    return _form(result, "as_text", "text")()


def to_latex(result: Any, *, standalone: bool = False) -> str:
    r"""Return LaTeX of a balance, design, torque report, derivation, component, series or expression.

    `standalone` wraps a balance, a torque report or a derivation in a complete document; a fragment needs
    amsmath and booktabs. Components, series and SymPy expressions give a formula for math mode.

    >>> from symbalance.kinematics.slider_crank import acceleration_series
    >>> print(to_latex(acceleration_series(6, 7)))
    \frac{9}{128 \lambda^{5}} + \frac{45}{512 \lambda^{7}} + \cdots
    """
    if not hasattr(result, "as_latex"):
        import sympy

        if isinstance(result, sympy.Expr):
            from symbalance.document.expressions import latex

            return latex(result)
    return _form(result, "as_latex", "LaTeX")(standalone=standalone)


def to_json(result: Any) -> str:
    """Return a result as a JSON document for other programs: every number exact, as a string."""
    return _form(result, "as_json", "JSON")()


def _form(result: Any, method: str, name: str) -> Any:
    """Return the method that prints a result in a form, or refuse a result that has none."""
    if isinstance(result, type) or not callable(getattr(result, method, None)):
        what = (result if isinstance(result, type) else type(result)).__name__
        raise SymbalanceError(what, f"has no {name} form", "give a balance or another result")
    return getattr(result, method)
