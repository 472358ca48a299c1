"""Whether a number as it is typed, 314 rad/s, is what another one rounds to."""

from __future__ import annotations

from symbalance.text import lazy_patterns as re

_TYPED = re.compile(r"(?P<whole>[0-9]+)(?:(?:[.,]|\{,\})(?P<part>[0-9]+))?")


def half_unit(source: str) -> float:
    """Return half a unit of the last digit of a number as typed, as a part of the number itself.

    >>> half_unit("50 Hz"), half_unit(r"0{,}25\\,\\mathrm{m}"), half_unit("x")
    (0.01, 0.02, 0.0)
    """
    match = _TYPED.search(source)
    if match is None:
        return 0.0
    part = match["part"] or ""
    digits = int(match["whole"] + part)
    return 0.5 / digits if digits else 0.0


def rounds_to(exact: float, typed: float, *sources: str) -> bool:
    """Tell whether a value rounds to a typed one, by the digits of both and of what it was made from."""
    allowed = sum(map(half_unit, sources)) + 1e-9
    return bool(exact) and abs(typed / exact - 1) <= allowed
