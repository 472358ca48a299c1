"""Stress concentration factors of a crank's fillets, for solid forged throws between two bearings.

They multiply nominal stresses: bending of the web's section B W^2/6 and pressure over B W (here width
times thickness), torsion of the pin's or journal's section. All sizes over the pin's diameter D:

    s = S/D overlap,  w = W/D thickness,  b = B/D width,  r fillet,  d_G, d_H bores of journal and pin

but in the journal's torsion, where the fillet counts over the journal's own diameter: r = R_G/D_G.

Source: IACS Unified Requirement M53, Calculation of Crankshafts for I.C. Engines: fits to measured
throws, without a recess. Compared with the print of the Korean Register (Rules for the Classification of
Steel Ships, Part 5, Guidance, Annex 5-3, 2025, in a public transcription), which differs by a digit in
three numbers: 2.7146 and 1.527 of beta_B (here 2.7145 and 1.5276), 0.85 of alpha_T (here 0.857, up to 5 %
less at wide webs). Which is right is not known: compare before relying on them in a classification.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

from symbalance.crankshaft.crank import Journal, Pin, Web

RANGES = {
    "s": (-0.5, 0.5),
    "w": (0.2, 0.8),
    "b": (1.1, 2.2),
    "r": (0.03, 0.13),
    "r_G": (0.03, 0.13),
    "d_G": (0.0, 0.8),
    "d_H": (0.0, 0.8),
}
"""Where the formulas hold. Below the least overlap those of bending and torsion are taken at it; that of
pressure, as the print has it, at the overlap there is."""
FILLET_ASSUMPTION = (
    "stress concentration factors of the fillets: the formulas of IACS UR M53 for solid forged throws; "
    "three of their coefficients differ by a digit from the one print they were compared with"
)
"""What a report of a run says of the factors."""


@dataclass(frozen=True)
class FilletFactors:
    """A web's factors: bending, torsion at the pin; bending, pressure, torsion at the journal.

    `outside` names what lies outside the formulas' range, with its value: then they are extrapolated.
    """

    pin_bending: float
    pin_torsion: float
    journal_bending: float
    journal_pressure: float
    journal_torsion: float
    outside: tuple[str, ...] = ()


def fillet_factors(journal: Journal, web: Web, pin: Pin) -> FilletFactors:
    """Return the stress concentration factors of a web between a journal and a pin.

    >>> journal = Journal(0.065, 0.03, fillet=0.0035)
    >>> pin = Pin(0.055, 0.036, 0.06, 0.0, (1,), fillet=0.0035)
    >>> factors = fillet_factors(journal, Web(0.022, 0.092, 0.038, 0.042), pin)
    >>> [round(x, 2) for x in (factors.pin_bending, factors.journal_bending)]
    [2.74, 3.1]
    >>> round(factors.pin_torsion, 3), round(factors.journal_torsion, 3)  # equal fillets, thicker journal
    (1.723, 1.788)
    """
    size = pin.diameter
    ratios = {
        "s": ((pin.diameter + journal.diameter) / 2 - pin.radius) / size,
        "w": web.thickness / size,
        "b": web.width / size,
        "r": pin.fillet / size,
        "r_G": journal.fillet / size,
        "d_G": journal.bore / size,
        "d_H": pin.bore / size,
    }
    outside = tuple(f"{k} = {v:.4g}" for k, v in ratios.items() if not _within(k, v))
    s = max(ratios["s"], RANGES["s"][0])
    w, b = ratios["w"], ratios["b"]
    least = RANGES["r"][0]
    r, r_g, r_own = (
        max(x, least) for x in (ratios["r"], ratios["r_G"], journal.fillet / journal.diameter)
    )
    bores = ratios["d_G"], ratios["d_H"]
    return FilletFactors(
        _pin_bending(s, w, b, r, *bores),
        _torsion(s, w, b, r),
        _journal_bending(s, w, b, r_g, *bores),
        _journal_pressure(ratios["s"], w, b, r_g, ratios["d_H"]),
        _torsion(s, w, b, r_own),
        outside,
    )


def _within(name: str, value: float) -> bool:
    low, high = RANGES[name]
    return low - 1e-9 <= value <= high + 1e-9


def _powers(x: float, *coefficients: float) -> float:
    return sum(c * x**k for k, c in enumerate(coefficients))


def _pin_bending(s: float, w: float, b: float, r: float, d_g: float, d_h: float) -> float:
    """Return alpha_B."""
    apart = 1 - s
    shape = _powers(w, -4.1883, 29.2004, -77.5925, 91.9454, -40.0416)
    shape += apart * _powers(w, 9.5440, -58.3480, 159.3415, -192.5846, 85.2916)
    shape += apart**2 * _powers(w, -3.8399, 25.0444, -70.5571, 87.0328, -39.1832)
    wide = _powers(b, 0.6840, -0.0077, 0.1473)
    hollow = _powers(d_g, 0.9993, 0.27, -1.0211, 0.5306) * _powers(d_h, 0.9978, 0.3145, -1.5241, 2.4147)
    return 2.6914 * shape * 2.1790 * w**0.7171 * wide * 0.2081 * r**-0.5231 * hollow


def _torsion(s: float, w: float, b: float, r: float) -> float:
    """Return alpha_T, or beta_T with the journal's fillet over the journal's diameter."""
    wide = _powers(b, 7.8955, -10.654, 5.3482, -0.857)
    return 0.8 * r ** (-0.322 + 0.1015 * (1 - s)) * wide * w**-0.145


def _journal_bending(s: float, w: float, b: float, r: float, d_g: float, d_h: float) -> float:
    """Return beta_B."""
    apart = 1 - s
    shape = _powers(w, -1.7625, 2.9821, -1.5276)
    shape += apart * _powers(w, 5.1169, -5.8089, 3.1391)
    shape += apart**2 * _powers(w, -2.1567, 2.3297, -1.2952)
    wide = _powers(b, 0.5616, 0.1197, 0.1176)
    hollow = _powers(d_g, 1.0012, -0.6441, 1.2265) * _powers(d_h, 1.0022, -0.1903, 0.0073)
    return 2.7145 * shape * 2.2422 * w**0.7548 * wide * 0.1908 * r**-0.5568 * hollow


def _journal_pressure(s: float, w: float, b: float, r: float, d_h: float) -> float:
    """Return beta_Q."""
    shape = _powers(1 - s, 0.4368, 2.1630, -1.5212)
    hollow = _powers(d_h, 0.9937, -1.1949, 1.7373)
    return 3.0128 * shape * w / (0.0637 + 0.9369 * w) * (b - 0.5) * 0.5331 * r**-0.2038 * hollow


def round_modulus(diameter: float, bore: float) -> float:
    """Return the section modulus in bending of a round section, m^3; twice that in torsion.

    >>> round(round_modulus(0.055, 0.0) * 1e9)
    16334
    """
    return pi / 32 * (diameter**4 - bore**4) / diameter
