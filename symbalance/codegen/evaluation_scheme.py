"""Choice of the summation scheme, Horner's, Clenshaw's or Reinsch's, by its rounding error.

Powers of the cosine by Horner's rule where their rounding stays small; Clenshaw's recurrence where
powers lose digits; the first order on a cosine of its own, or Reinsch's recurrence from the nearest
crest, where the bound would pass `LARGE_ROUNDING` u (many orders, rho near 1).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from symbalance.codegen import rounding
from symbalance.codegen.expression_ir import Kernel
from symbalance.codegen.harmonic_sum import HarmonicSum
from symbalance.codegen.polynomials import Family, clenshaw_lines, decompositions, power_lines, powers
from symbalance.codegen.reinsch import reinsch_lines, reinsch_rounding
from symbalance.codegen.shared_cosines import SharedCosines
from symbalance.text.reals import Real

LARGE_ROUNDING = 11.0
"""Rounding, in u of the amplitude, above which the first order goes apart or Reinsch's is taken."""
SMALL_ROUNDING = 4.0
"""Rounding, in u of the amplitude, up to which powers of the cosine are preferred to Clenshaw."""
HIGHEST_POWER = 40
"""Above this degree, powers of the cosine are never tried: their coefficients grow like 2.4^degree."""


def constant_prefix(name: str) -> str:
    """Return what the names of an output's own constants begin with.

    >>> constant_prefix("force.vertical")
    'FORCE_VERTICAL_'
    """
    return name.replace(".", "_").upper() + "_"


def sum_formula(
    harmonic_sum: HarmonicSum, shared: SharedCosines, tail: Kernel, size: float
) -> tuple[str, float, str]:
    """Return an output's formula, its rounding (absolute, in u) and its form in words.

    Of the decompositions, the shortest to compute first, the first one whose rounding is not large is
    taken, and where all are large the one that rounds least.
    """
    schemes = [
        [_Scheme.of(one, size) for one in families] for families in decompositions(harmonic_sum.terms)
    ]
    errors = [sum(scheme.error for scheme in each) for each in schemes]
    small = (i for i, error in enumerate(errors) if error <= LARGE_ROUNDING * size)
    best = next(small, errors.index(min(errors)))
    parts = []
    for i, scheme in enumerate(schemes[best]):
        prefix = constant_prefix(harmonic_sum.name) + "ABC"[i] * (len(schemes[best]) > 1)
        parts.append(scheme.formula(prefix, shared, tail))
    count = sum(1 + any(scheme.family.odd) for scheme in schemes[best])
    form = "polynomial in one cosine" if count == 1 else f"polynomials in {count} cosines"
    if any(scheme.by_reinsch for scheme in schemes[best]):
        form = "Reinsch's recurrence"
    return " + ".join(parts), errors[best], form


@dataclass(frozen=True)
class _Scheme:
    """How one family is computed: by which recurrence, and what that rounds (absolute, in u)."""

    family: Family
    error: float
    by_reinsch: bool
    by_powers: tuple[bool, bool]

    @staticmethod
    def of(family: Family, size: float) -> _Scheme:
        """Return the shortest scheme that rounds little beside `size`, else the one that rounds least."""
        psi = rounding.resolving_angles(max(len(family.even), len(family.odd)))
        rows = (("T", family.even), ("U", family.odd))
        even, odd = (_horner_or_clenshaw(row, kind, psi) for kind, row in rows)
        error = float(np.max(even[1] + odd[1]))
        by_powers = (even[0], odd[0])
        if error > LARGE_ROUNDING * size:
            reinsch = [reinsch_rounding([float(a) for a in row], psi, kind) for kind, row in rows]
            smaller = float(np.max(reinsch[0] + reinsch[1]))
            if smaller < error:
                return _Scheme(family, smaller, True, by_powers)
        return _Scheme(family, error, False, by_powers)

    def formula(self, prefix: str, shared: SharedCosines, tail: Kernel) -> str:
        """Return the formula, adding its constants and lines."""
        family = self.family
        if self.by_reinsch:
            return _reinsch_formula(family, prefix, shared, tail)
        cosine, parts = shared.name(family.step, family.phase), []
        if any(family.even):
            parts.append(_row_formula(family.even, "T", self.by_powers[0], prefix, cosine, tail))
        if any(family.odd):
            sine = shared.name(family.step, family.phase + 0.25)
            factor = _row_formula(family.odd, "U", self.by_powers[1], prefix + "S", cosine, tail)
            parts.append(f"{sine}*({factor})")
        return " + ".join(parts)


def _row_formula(
    row: Sequence[Real], kind: str, by_powers: bool, prefix: str, cosine: str, tail: Kernel
) -> str:
    if by_powers:
        return power_lines(tail, prefix, powers(row, kind), cosine)
    return clenshaw_lines(tail, prefix, row, cosine, kind)


def _reinsch_formula(family: Family, prefix: str, shared: SharedCosines, tail: Kernel) -> str:
    """Return the formula by Reinsch's recurrence, adding its lines."""
    m, sigma, sine = shared.crest(family.step, family.phase)
    parts = []
    if any(family.even):
        d, b = reinsch_lines(tail, prefix, family.even, m, sigma)
        parts.append(f"({d} - 0.5*{m}*{b})")
    if any(family.odd):
        _, b = reinsch_lines(tail, prefix + "S", family.odd, m, sigma)
        parts.append(f"{sine}*{b}")
    return " + ".join(parts)


def _horner_or_clenshaw(row: Sequence[Real], kind: str, psi: rounding.Grid) -> tuple[bool, rounding.Grid]:
    """Tell whether powers of the cosine do for a row, and what it rounds over `psi`."""
    floats = [float(a) for a in row]
    if not any(floats):
        return True, np.zeros_like(psi)
    of_cosine = rounding.cosine_error(psi) * rounding.derivative(floats, psi)
    factor = 1.0
    if kind == "U":  # times the sine, whose own error counts once more
        inner, change = rounding.sine_factors(floats, psi)
        factor = np.sin(psi)
        of_cosine = rounding.cosine_error(psi) * change
        of_cosine = of_cosine + rounding.cosine_error(np.abs(psi - np.pi / 2)) * inner + factor * inner
    by_clenshaw = factor * rounding.clenshaw_rounding(floats, psi, kind)
    if len(floats) > HIGHEST_POWER + 1:
        return False, of_cosine + by_clenshaw
    by_horner = factor * rounding.horner_rounding([float(p) for p in powers(row, kind)], psi)
    small = SMALL_ROUNDING * max(abs(a) for a in floats)
    if np.max(by_horner) <= max(small, float(np.max(by_clenshaw))):
        return True, of_cosine + by_horner
    return False, of_cosine + by_clenshaw
