"""The size that the words of a declaration name: a bearing force is a force, a span of a shaft a length.

What counts is the noun before "of", "at" and the like, with the words before it: the "gyroscopic couple",
the "amplitude of the first-order couple", "couple de correction". A word that has several sizes says
nothing: a moment, a speed, a weight, a stiffness. Nor does what is divided by something, or counted in
its units.
"""

from __future__ import annotations

from functools import cache

from symbalance.text import lazy_patterns as re

_NOUNS = tuple(
    (size, re.compile(rf"(?:{pattern})$"))
    for size, pattern in (
        ("N", r"(?<![a-z])force|[a-zäöü]*kraft"),
        (
            "N m",
            r"(?<![a-z])(?:couple|torque)|(?:bending|twisting|turning|pitching) moment|[a-z]*drehmoment",
        ),
        ("kg", r"(?<![a-z])mass|[a-zäöü]*masse"),
        (
            "m",
            r"(?<![a-z])(?:length|diameter|radius|distance|width|height|thickness|span|bore|stroke)"
            r"|[a-zäöü]*(?:durchmesser|radius|länge|(?<!zünd)(?<!folge)(?<!winkel)(?<!frequenz)(?<!zeit)abstand"
            r"|breite|höhe)",
        ),
        ("m^2", r"(?<![a-z])(?:sheared |piston |cross[- ]sectional )?area|[a-zäöü]*fläche"),
        ("1/s", r"angular (?:speed|velocity|frequency)|natural frequency|winkelgeschwindigkeit"),
        ("J", r"(?:kinetic |(?<![a-z]))energy|[a-z]*energie"),
        ("W", r"(?<![a-z])power|[a-z]*leistung"),
        ("Pa", r"(?<![a-z])(?:stress|pressure)|(?:shear|tensile|yield) strength|[a-z]*spannung"),
        ("kg m^2", r"mass moment of inertia|massenträgheitsmoment"),
        ("s", r"(?<![a-z])(?:period|duration)|(?:cycle|punching) time|schwingungsdauer|periodendauer"),
        ("1", r"(?<![a-z])(?:efficiency|angle)|wirkungsgrad|[a-zäöü]*winkel"),
    )
)
_FIRST = tuple(
    (size, re.compile(rf"(?:{pattern})(?: |$)"))
    for size, pattern in (
        ("kg", "masse"), ("N", "force"), ("N m", "couple"), ("1/s", "vitesse angulaire"),
        ("m", "rayon|longueur|diamètre|distance|épaisseur|largeur|hauteur"), ("s", "période"),
        ("J", "énergie"), ("W", "puissance"), ("1", "angle|rendement"), ("Pa", "contrainte|pression"),
    )
)  # fmt: skip
"""Of Romance languages, which begin with the noun."""
_ALONE = frozenset(("length", "distance", "width", "height", "radius", "angle", "span"))
"""Words that alone are as good as none: y, a length, may be any variable."""
_INERTIA = re.compile(
    r"(?:\w+ )?moment of inertia(?: needed)? of (?:the |a |each )?"
    r"(?:fly-?wheel|dis[ck]|rotor|rim|wheel|drum|crankshaft|connecting[- ]rod|rod|propeller)s?(?: .*)?"
)
_PREPOSITION = re.compile(
    r" (?:of|at|in|on|by|to|from|for|about|along|across|between|with|after|under|above|needed"
    r"|delivered|taken|given|turning|an|am|im|der|des|vom|von|zum|beim?|je|aus|zwischen|um|ab)(?: |$)"
)
_PART = re.compile(
    r"(?:amplitude|size|magnitude|component|(?:largest|greatest|maximum|least|mean) value)"
    r" of (?:the )?(?P<whole>.+)"
)
_NOT_IT = re.compile(
    r"(?<![a-z])(?:per|pro|par|ratio|relative|specific|reduced|dimensionless|unit|units|number|coefficient|factor|half|times"
    r"|squared?|inverse|reciprocal|logarithm|percent|share|fraction|divided|over|durch|sur|verhältnis|bezogen\w*"
    r"|(?:vol[uú]mi|superfi[cz]i|surfaci|linéi|linei|massi|mási|molai|specifi|spécifi|réduit|ridott|reducid)\w*"
    r"|rms|index|equivalent|(?:real|imaginary) axis|complex plane)(?![a-z])|[/÷²^]|verhältnis|zahl\b"
)


@cache
def unit_by_words(meaning: str) -> str:
    """Return the unit of the size that words name, "" where they name none or may name several.

    >>> unit_by_words("gyroscopic couple"), unit_by_words("bearing force"), unit_by_words("speed")
    ('N m', 'N', '')
    >>> unit_by_words("mass per unit length"), unit_by_words("couple de correction")
    ('', 'N m')
    >>> unit_by_words("Zylinderabstand"), unit_by_words("Zündabstand"), unit_by_words("masse volumique")
    ('m', '', '')
    """
    text = " ".join(meaning.lower().split())
    if part := _PART.fullmatch(text):
        return unit_by_words(part["whole"])
    if _NOT_IT.search(text) or text in _ALONE:
        return ""
    if _INERTIA.fullmatch(text):
        return "kg m^2"
    head = _PREPOSITION.split(text, maxsplit=1)[0].removeprefix("the ")
    is_by_noun = (size for size, pattern in _NOUNS if pattern.search(head))
    is_first = (size for size, pattern in _FIRST if pattern.match(text))
    return next(is_by_noun, "") or next(is_first, "")
