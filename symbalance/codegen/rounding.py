"""First-order bounds on rounding errors of Horner's and Clenshaw's schemes, in u = 2^-53.

A rounding made on the way is as if one coefficient were changed: by Horner's rule in c, an error d in
step j counts d |c|^j; by Clenshaw's recurrence d |T_k(c)|, or d |U_{k-1}(c)|. What the cosine itself
errs, counts |df/dc| times. Sums run over a grid of angles fine enough for every harmonic kept.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

Grid = Any
SUMS = 1.0
"""Each product and each sum rounds by at most u of itself."""


def resolving_angles(highest: int) -> Grid:
    """Return angles from 0 to pi that resolve harmonics to `highest`."""
    return np.linspace(0.0, np.pi, 16 * max(16, highest) + 1)


def cosine_error(psi: Grid) -> Grid:
    """Return what the computed cos(psi) errs at most: its argument's two roundings, the sine's own."""
    x = np.pi / 2 - psi
    return 2 * np.abs(x * np.cos(x)) + 0.5 * np.abs(np.sin(x)) + 1.5 * np.abs(x - np.sin(x))


def derivative(row: Sequence[float], psi: Grid) -> Grid:
    """Return |d/dc| of sum a_k cos k psi in c = cos psi, sum k a_k U_{k-1}(c)."""
    return np.abs(sum(k * a * chebyshev_u(k, psi) for k, a in enumerate(row) if a))


def sine_factors(row: Sequence[float], psi: Grid) -> tuple[Grid, Grid]:
    """Return |P| and |sin psi P'(c)| of sum a_k sin k psi = sin psi P(c), P = sum a_k U_{k-1}.

    sin psi P' = (c P - sum k a_k cos k psi)/sin psi, which goes to 0 with sin psi.
    """
    inner = sum(a * chebyshev_u(k, psi) for k, a in enumerate(row) if a)
    slope = sum(k * a * np.cos(k * psi) for k, a in enumerate(row) if a)
    sine = np.sin(psi)
    inside = np.abs(sine) > 1e-9
    change = np.where(inside, (np.cos(psi) * inner - slope) / np.where(inside, sine, 1.0), 0.0)
    return np.abs(inner), np.abs(change)


def chebyshev_u(k: int, psi: Grid) -> Grid:
    """Return U_{k-1}(cos psi) = sin k psi/sin psi."""
    near = np.minimum(psi, np.pi - psi) < 1e-9
    sine = np.where(near, 1.0, np.sin(psi))
    ends = np.where(psi < 1.0, float(k), float(k) * (-1.0) ** (k - 1))
    return np.where(near, ends, np.sin(k * psi) / sine)


def horner_rounding(coefficients: Sequence[float], psi: Grid) -> Grid:
    """Return what Horner's rule rounds, for a series in powers of c; zeros cost nothing."""
    c, total = np.cos(psi), np.zeros_like(psi)
    value = np.zeros_like(psi)
    for j in range(len(coefficients) - 1, -1, -1):
        product = value * c
        value = product + coefficients[j]
        local = abs(coefficients[j]) + SUMS * (np.abs(product) + np.abs(value))
        total += (local if coefficients[j] else np.abs(product)) * np.abs(c) ** j
    return total


def clenshaw_rounding(row: Sequence[float], psi: Grid, kind: str = "T") -> Grid:
    """Return what Clenshaw's recurrence rounds, for sum a_k T_k(c) or sum a_k U_{k-1}(c)."""
    c, total = np.cos(psi), np.zeros_like(psi)
    above, here = np.zeros_like(psi), np.zeros_like(psi)
    for k in range(len(row) - 1, 0, -1):
        product = 2 * c * here
        value = row[k] + product - above
        local = abs(row[k]) + np.abs(product) + np.abs(row[k] + product) + np.abs(value)
        weight = np.cos(k * psi) if kind == "T" else chebyshev_u(k, psi)
        total += local * np.abs(weight)
        above, here = here, value
    return total + (np.abs(c * here) + np.abs(c * here - above) if kind == "T" else 0.0)
