"""How an output's harmonics are summed: which cosines, which recurrence, and what that rounds.

Powers of the cosine by Horner's rule where their rounding stays small; Clenshaw's recurrence where
powers lose digits; the first order on a cosine of its own, or Reinsch's recurrence from the nearest
crest, where the bound would pass `MANY` u (many orders, rho near 1).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from symbalance.codegen import rounding
from symbalance.codegen.bases import Bases
from symbalance.codegen.crests import reinsch_lines, rounding_of_reinsch
from symbalance.codegen.kernels import Kernel
from symbalance.codegen.polynomials import Family, clenshaw_lines, decompositions, power_lines, powers
from symbalance.codegen.waves import Wave
from symbalance.text.reals import Real

MANY = 11.0
"""Rounding, in u of the amplitude, above which the first order goes apart, or Reinsch's way is gone."""
FEW = 4.0
"""Rounding, in u of the amplitude, up to which powers of the cosine are preferred to Clenshaw."""
HIGHEST_POWER = 40
"""Above this degree, powers of the cosine are never tried: their coefficients grow like 2.4^degree."""


def prefix(name: str) -> str:
    """Return what the names of an output's own constants begin with.

    >>> prefix("force.vertical")
    'FORCE_VERTICAL_'
    """
    return name.replace(".", "_").upper() + "_"


def polynomials(wave: Wave, bases: Bases, tail: Kernel, size: float) -> tuple[str, float, str]:
    """Return an output's formula, its rounding (absolute, in u) and its form in words."""
    ways = [[_Way.of(one, size) for one in found] for found in decompositions(wave.terms)]
    sums = [sum(way.error for way in one) for one in ways]
    chosen = next((i for i, error in enumerate(sums) if error <= MANY * size), sums.index(min(sums)))
    parts = []
    for i, way in enumerate(ways[chosen]):
        own = prefix(wave.name) + "ABC"[i] * (len(ways[chosen]) > 1)
        parts.append(way.written(own, bases, tail))
    count = sum(1 + any(way.family.odd) for way in ways[chosen])
    form = "polynomial in one cosine" if count == 1 else f"polynomials in {count} cosines"
    if any(way.careful for way in ways[chosen]):
        form = "Reinsch's recurrence"
    return " + ".join(parts), sums[chosen], form


@dataclass(frozen=True)
class _Way:
    """How one family is computed: by which recurrence, and what that rounds (absolute, in u)."""

    family: Family
    error: float
    careful: bool
    by_powers: tuple[bool, bool]

    @staticmethod
    def of(found: Family, size: float) -> _Way:
        """Return the shortest way that rounds little beside `size`, else the one that rounds least."""
        psi = rounding.angles(max(len(found.even), len(found.odd)))
        rows = (("T", found.even), ("U", found.odd))
        plain = [_plain(row, kind, psi) for kind, row in rows]
        error = float(np.max(plain[0][1] + plain[1][1]))
        by_powers = (plain[0][0], plain[1][0])
        if error > MANY * size:
            reinsch = [rounding_of_reinsch([float(a) for a in row], psi, kind) for kind, row in rows]
            careful = float(np.max(reinsch[0] + reinsch[1]))
            if careful < error:
                return _Way(found, careful, True, by_powers)
        return _Way(found, error, False, by_powers)

    def written(self, own: str, bases: Bases, tail: Kernel) -> str:
        """Return the formula, adding its constants and lines."""
        found = self.family
        if self.careful:
            return _careful(found, own, bases, tail)
        cosine, parts = bases.name(found.step, found.phase), []
        if any(found.even):
            parts.append(_recurrence(found.even, "T", self.by_powers[0], own, cosine, tail))
        if any(found.odd):
            sine = bases.name(found.step, found.phase + 0.25)
            over = _recurrence(found.odd, "U", self.by_powers[1], own + "S", cosine, tail)
            parts.append(f"{sine}*({over})")
        return " + ".join(parts)


def _recurrence(
    row: Sequence[Real], kind: str, by_powers: bool, own: str, cosine: str, tail: Kernel
) -> str:
    if by_powers:
        return power_lines(tail, own, powers(row, kind), cosine)
    return clenshaw_lines(tail, own, row, cosine, kind)


def _careful(found: Family, own: str, bases: Bases, tail: Kernel) -> str:
    """Return the formula by Reinsch's recurrence, adding its lines."""
    m, sigma, sine = bases.crest(found.step, found.phase)
    parts = []
    if any(found.even):
        d, b = reinsch_lines(tail, own, found.even, m, sigma)
        parts.append(f"({d} - 0.5*{m}*{b})")
    if any(found.odd):
        _, b = reinsch_lines(tail, own + "S", found.odd, m, sigma)
        parts.append(f"{sine}*{b}")
    return " + ".join(parts)


def _plain(row: Sequence[Real], kind: str, psi: rounding.Grid) -> tuple[bool, rounding.Grid]:
    """Tell whether powers of the cosine do for a row, and what it rounds over `psi`."""
    floats = [float(a) for a in row]
    if not any(floats):
        return True, np.zeros_like(psi)
    of_cosine = rounding.cosine_error(psi) * rounding.derivative(floats, psi)
    over = 1.0
    if kind == "U":  # times the sine, whose own error counts once more
        inner, change = rounding.sine_factors(floats, psi)
        over = np.sin(psi)
        of_cosine = rounding.cosine_error(psi) * change
        of_cosine = of_cosine + rounding.cosine_error(np.abs(psi - np.pi / 2)) * inner + over * inner
    by_clenshaw = over * rounding.of_clenshaw(floats, psi, kind)
    if len(floats) > HIGHEST_POWER + 1:
        return False, of_cosine + by_clenshaw
    by_horner = over * rounding.of_powers([float(p) for p in powers(row, kind)], psi)
    few = FEW * max(abs(a) for a in floats)
    if np.max(by_horner) <= max(few, float(np.max(by_clenshaw))):
        return True, of_cosine + by_horner
    return False, of_cosine + by_clenshaw
