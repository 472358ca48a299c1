"""symbalance: exact free forces and couples of piston engines, as formulas, tables and functions.

    >>> import symbalance as sb
    >>> v12 = sb.balance(sb.load("v12-60"))
    >>> [(o.order, o.force.vertical.amplitude) for o in v12.orders]
    [(6, 6*sqrt(3)), (12, 6*sqrt(3))]

Every public name is loaded when it is first used, so that importing the package costs nothing.
"""

from symbalance.loading import attach

__version__ = "0.2.0"
__getattr__, __dir__, _names = attach(__name__, __file__)
__all__ = [*_names, "__version__"]  # pyright: ignore[reportUnsupportedDunderAll]
