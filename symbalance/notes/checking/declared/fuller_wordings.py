"""Known meanings in a fuller wording: "length of the rod between centres" declares the rod length.

What is put off from a declaration says nothing else of the letter: a unit, "of the crankshaft", "of
cylinder 1", "constant", where an angle or a way is counted from if that is the top. What is left has to
be a known phrase to the last word: "mass of the rod" and "crank angle from the bottom" stay as they are.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache

from symbalance.notes.checking.declared.role_phrases import GERMAN_RATIO, PHRASES, ratio_in_words
from symbalance.notes.checking.declared.sidecar import PROPOSED, Declarations
from symbalance.notes.checking.declared.symbol_roles import (
    CRANK_ANGLE,
    FROM_TOP,
    HARMONIC,
    KNOWN,
    MOVING,
    role_of,
)
from symbalance.text import lazy_patterns as re

_ROLES = (
    *("crank angle", "rod angle", "crank radius", "stroke", "rod length", "angular speed"),
    *("reciprocating mass", FROM_TOP, "piston velocity", "piston acceleration", "cylinder pitch"),
)
_OF_PISTON = re.compile(r"piston|kolben|ピストン", re.IGNORECASE)
"""In phrases for a mass that is but a part of what reciprocates."""
_TOP = (
    r"(?:the )?(?:(?:top|inner|upper) dead (?:cent(?:re|er)|point)|TDC|IDC|OT|PMH|PMS"
    r"|oberen? Totpunkte?s?|point mort haut|punto morto superiore)"
)
_PUT_OFF = (
    r"\s*[(（][^()（）]*[)）]",
    r"\s*\b(?:in|en) (?:degrees|Grad|radians|rad|°)",
    r",?\s*\b(?:counted |measured |gemessen |compté |)(?:down |downwards? )?"
    rf"(?:from|ab|von|vom|depuis(?: le)?|dal) {_TOP}",
    r"\s*\b(?:of|for|von|du|del) (?:cylinder|throw|crank|Zylinder|cylindre|cilindro) 1",
    r"\s*\b(?:between (?:the )?(?:centres|centers|eyes)|cent(?:re|er) to cent(?:re|er)|eye to eye)",
    r"\s*\b(?:of the (?:crank ?shaft|crank|engine)|der Kurbel(?:welle)?|des Motors)",
    r"\s*\b(?:(?:per|of one|of an?|of each|of the|for one) (?:single )?(?:cylinder|piston)"
    r"|(?:je|pro) (?:Zylinder|Kolben))",
    r"^(?:the |constant |rated |mittlere |konstante )",
    r"(?:の|)(?:下向き正|中心間)",
)
_MEAN = re.compile(r"(?<![^\W\d_])mittlere[rnms]?(?![^\W\d_])", re.IGNORECASE)
_ANGULAR = frozenset({"omega", "Omega"})
"""Letters whose speed of rotation is in radians."""
_ROTATION = re.compile(
    r"rotation(?:al)? speed|speed of rotation|vitesse de rotation|(?:Dreh|Rotations)geschwindigkeit"
    r"|velocità di rotazione|velocidad de (?:giro|rotación)|回転速度|回転の速さ",
    re.IGNORECASE,
)
_BY_MINUTE = re.compile(r"\b(?:rpm|tr|turns?|revolutions?|giri|U/min|min)\b|毎分", re.IGNORECASE)
_RATIO_WORDS = re.compile(r"ratio|verhältnis|rapport|rapporto|比|^[rl](?:/| over )[rl]$", re.IGNORECASE)


def with_fuller_roles(declarations: Declarations, english: Callable[[str], str]) -> Declarations:
    """Return declarations in which a fuller wording stands behind the known meaning that it states.

    Any other meaning has its terms in English; `english` puts those of the page's language so.
    """

    def stated(symbols: Mapping[str, str]) -> dict[str, str]:
        fuller = {name: _with_role(name, text, english) for name, text in symbols.items()}
        if CRANK_ANGLE in {*map(role_of, fuller.values()), *map(role_of, declarations.symbols.values())}:
            return fuller
        # the motion of an angle that is not said would be of another letter than the page's
        return {n: symbols[n] if role_of(text) in MOVING else text for n, text in fuller.items()}

    scopes = tuple(replace(scope, symbols=stated(scope.symbols)) for scope in declarations.scopes)
    return replace(declarations, symbols=stated(declarations.symbols), scopes=scopes)


def _with_role(name: str, text: str, english: Callable[[str], str]) -> str:
    role = role_of(text)
    if role in KNOWN or HARMONIC.match(role) or text.startswith(PROPOSED):
        return text
    if role := fuller_role(text):
        return f"{role}, {text}"
    in_english = english(text)  # asked for only where English words say nothing: it loads a language
    role = fuller_role(in_english)
    if not role and name in _ANGULAR and _ROTATION.search(text) and not _BY_MINUTE.search(text):
        role = "angular speed"
    if role_of(in_english) == "inertia force":
        return text  # F = -m a and F = m a are both called so: which way it counts is not said
    return f"{role}, {text}" if role else in_english


@cache
def fuller_role(text: str) -> str:
    """Return the known meaning that a fuller wording states, "" for another.

    >>> fuller_role("length of the connecting rod between centres"), fuller_role("mass of the rod")
    ('rod length', '')
    >>> fuller_role("rated angular speed"), fuller_role("Verhältnis Kurbelradius zu Pleuellänge")
    ('angular speed', 'crank ratio r/l')
    >>> fuller_role("mittlere Winkelgeschwindigkeit"), fuller_role("mittlere Kolbengeschwindigkeit")
    ('angular speed', '')
    >>> fuller_role("angle of the bank"), fuller_role("crank angle from bottom dead centre")
    ('', '')
    """
    if _RATIO_WORDS.search(text):
        own = text.partition(",")[0].strip()
        return ratio_in_words(text) or ("crank ratio r/l" if own in GERMAN_RATIO else "")
    left, has_top = text, False
    for off in _PUT_OFF:
        shorter = re.sub(off, "", left, flags=re.IGNORECASE).strip(" ,")
        has_top = has_top or (shorter != left and re.search(_TOP, left, re.IGNORECASE) is not None)
        left = shorter or left
    role = _phrases().get(left.casefold(), "")
    if not role and has_top and left.casefold() in ("angle", "winkel", "crank", "kurbel"):
        role = CRANK_ANGLE
    if role in MOVING and _MEAN.search(text):
        return ""  # over a stroke, and nothing that turns with the crank
    return role if role != FROM_TOP or has_top else ""


def _names_speed(text: str) -> bool:
    return (
        re.search(r"speed|drehzahl|revolutions|régime|rpm|回転|velocità|giri", text, re.IGNORECASE)
        is not None
    )


@cache
def _phrases() -> dict[str, str]:
    """Return the phrases that name roles of the crank drive, each with its role."""
    return {
        phrase.casefold(): role
        for role in _ROLES
        for phrase in (role, *PHRASES[role])
        if role != "reciprocating mass" or not _OF_PISTON.search(phrase)
    }
