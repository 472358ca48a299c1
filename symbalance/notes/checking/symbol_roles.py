"""The roles a letter may be declared to have, such as crank radius, and how each may be spelled."""

from __future__ import annotations

import re
from collections.abc import Mapping
from difflib import SequenceMatcher

FROM_TOP = "displacement from top dead centre"
FROM_PIN = "piston position"
FROM_MIDDLE = "piston position from mid-stroke"

ALIASES = {
    "displacement from tdc": FROM_TOP,
    "piston displacement from top dead centre": FROM_TOP,
    "piston displacement from tdc": FROM_TOP,
    "displacement from top dead center": FROM_TOP,
    "connecting rod length": "rod length",
    "crank speed": "angular speed",
    "angular velocity": "angular speed",
    "rod ratio (l/r)": "rod ratio l/r",
    "rod ratio (l/s)": "rod ratio l/s",
    "rod ratio r/l": "crank ratio r/l",
    "rod ratio (r/l)": "crank ratio r/l",
    "ratio l/r": "rod ratio l/r",
    "ratio l/s": "rod ratio l/s",
    "ratio r/l": "crank ratio r/l",
    "crank ratio (r/l)": "crank ratio r/l",
}

KNOWN = (
    "crank angle",
    "rod angle",
    "crank radius",
    "stroke",
    "rod length",
    "rod ratio l/r",
    "rod ratio l/s",
    "crank ratio r/l",
    "angular speed",
    "engine speed rpm",
    "time",
    "reciprocating mass",
    FROM_TOP,
    FROM_PIN,
    FROM_MIDDLE,
    "piston velocity",
    "piston acceleration",
    "inertia force",
    "cylinder pitch",
    "integer",
    "positive",
    "constant",
    "complex",
    "variable",
)

MOVING = (FROM_TOP, FROM_PIN, FROM_MIDDLE, "piston velocity", "piston acceleration", "inertia force")
POSITIVE = {
    *("crank radius", "stroke", "rod length", "rod ratio l/r", "rod ratio l/s", "crank ratio r/l"),
    *("angular speed", "engine speed rpm", "reciprocating mass", "cylinder pitch", "positive"),
}
CONSTANT = (
    *("crank radius", "stroke", "rod length", "rod ratio l/r", "rod ratio l/s", "crank ratio r/l"),
    *("angular speed", "engine speed rpm", "reciprocating mass", "cylinder pitch", "constant"),
)
"""What changes with no angle and no time: it stands outside an integral."""
CONSTANT_WORD = re.compile(
    r"\b(?:constant|coefficient|amplitude|length|radius|ratio|mass|factor|width|distance|number|konstante)\b"
)
"""Words of a meaning that say the same."""
SMALL_WORD = re.compile(
    r"\b(?:small|little|tiny|perturbation|klein\w*|gering\w*)\b|微小|小さ", re.IGNORECASE
)
"""Words of a meaning that say that a letter is small beside 1."""
_CALLED_SMALL = re.compile(
    r"(?:(?<![A-Za-z])(?:small|klein(?:e[nsrm]?)?)\s+(?:angles?\s+|values\s+of\s+|Winkel\s+)?\$?\\?"
    r"([A-Za-z]+(?:_\{?\w+\}?)?)\$?(?:\s+(?:and|und|et)\s+\$\\?([A-Za-z]+(?:_\{?\w+\}?)?)\$)?"
    r"|(?<![A-Za-z])\\?([A-Za-z]++(?:_\{?\w{1,40}+\}?)?)\s*+(?:\\ll(?![a-z])|≪|<<)\s*1(?![\d.])"
    r"|(?<![A-Za-z])([A-Za-z]++)(?:\s*=\s*[^$.;,\n]{1,20})?\$?\s+(?:is|ist)\s+(?:very\s+|sehr\s+|much\s+)?(?:small|klein)"
    r"|(?<![A-Za-z])([A-Za-z]++)\$?\s*は\s*(?:十分に?|非常に)?小さ"
    r"|(?<![A-Za-z])([A-Za-z]++)\s*=\s*(?:\\[td]?frac\s*\{?\s*r\s*\}?\s*\{?\s*l(?![A-Za-z])|r\s*/\s*l(?![A-Za-z\w])))"
)


def small_letters(text: str) -> frozenset[str]:
    """Return the letters that a text calls small: "for small x", "ε ≪ 1", or the ratio λ = r/l.

    >>> sorted(small_letters(r"for small $\\varphi$ and $x \\ll 1$"))
    ['varphi', 'x']
    """
    text = re.sub(r"[ερλφβδ]", lambda sign: GREEK_NAMES[sign.group()], text)
    return frozenset(
        n.replace("{", "").replace("}", "") for m in _CALLED_SMALL.finditer(text) for n in m.groups() if n
    )


GREEK_NAMES = {"ε": "epsilon", "ρ": "rho", "λ": "lambda", "φ": "phi", "β": "beta", "δ": "delta"}
HARMONIC = re.compile(r"A_\d{1,3}$")
RANGES = {
    "crank angle": (10, 620),
    "rod ratio l/r": (300, 500),
    "rod ratio l/s": (150, 250),
    "crank ratio r/l": (15, 40),
    "rod length": (300, 500),
    "crank radius": (60, 100),
    "stroke": (120, 200),
}
"""Ranges of values at random points, in hundredths: such that a rod is longer than its crank."""
FEWEST_WORDS = 2
"""Words of a meaning that can be misspelt: one alone (strike, tine) is as likely meant as it stands."""
UNITS = (
    "m",
    "mm",
    "kg",
    "g",
    "s",
    "rpm",
    "rad/s",
    "N",
    "m/s",
    "m/s^2",
    "m/s²",
    "kg m",
    "N m",
    "bar",
    "Pa",
)


def conjugate_name(name: str) -> str:
    """Return the letter with the bar that is the conjugate of a complex letter."""
    return f"bar_{name}"


def readable_letters(symbols: Mapping[str, str]) -> frozenset[str]:
    """Return the letters that may be written: those declared, and the conjugates of complex ones."""
    not_real = {conjugate_name(n) for n, text in symbols.items() if role_of(text) == "complex"}
    return frozenset(symbols) | not_real


def role_of(text: str) -> str:
    """Return the known meaning a declaration states, or its text.

    >>> role_of("Crank radius, half the stroke")
    'crank radius'
    """
    head = text.split(",", maxsplit=1)[0].strip()
    role = " ".join(head.lower().split())
    role = ALIASES.get(role, role)
    return role if role in KNOWN else head


SIMILAR = 0.7
"""Of two words, by difflib: cranck and crank are 0.91, piston and position 0.71, rod and road 0.86."""


def misspelt_role(text: str) -> str | None:
    """Return the known meaning that a declaration misspells, None where it states one or another.

    Word for word like a known meaning, but not the same: "cranck angle". A slip would make the letter
    just a letter, and true lines refuted. "variable, cranck angle" is meant as it stands.

    >>> misspelt_role("cranck angle"), misspelt_role("crank angle"), misspelt_role("angle of the bank")
    ('crank angle', None, None)
    """
    role = role_of(text)
    if role in KNOWN or HARMONIC.match(role):
        return None
    words = role.lower().split()
    near: list[tuple[float, str]] = []
    for known in (*KNOWN, *ALIASES):
        known_words = known.split()
        if len(words) != len(known_words) or len(words) < FEWEST_WORDS:
            continue
        scores = [SequenceMatcher(None, a, b).ratio() for a, b in zip(words, known_words, strict=True)]
        if min(scores) >= SIMILAR:
            near.append((sum(scores), ALIASES.get(known, known)))
    return max(near)[1] if near else None


def letters_by_role(symbols: Mapping[str, str]) -> dict[str, list[str]]:
    """Return the letters of each meaning."""
    letters: dict[str, list[str]] = {}
    for name, text in symbols.items():
        letters.setdefault(role_of(text), []).append(name)
    return letters
