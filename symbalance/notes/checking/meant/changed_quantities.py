"""Words that make another quantity of a named one: twice the energy, the stress at half the radius.

What a phrase names has its standard formula where the phrase stands for itself. In its noun phrase,
before it and behind it, may stand a multiple or a share, several bodies for one, a second value or
another unit: then the standard formula is not what the words say, and nothing is known of it.
"""

from __future__ import annotations

from dataclasses import dataclass

from symbalance.text import lazy_patterns as re

_CLAUSE_ENDS = re.compile(r"[.,](?![0-9])|[;:()\[$=|#、。：「]|\n|—|–|(?<=\s)-(?=\s)|\\begin|<[^>]*>|\*")
_VERB = re.compile(
    r"\b(?:is|are|was|be|becomes?|equals?|follows|gives?|ist|sind|wird|beträgt|ergibt|lautet|est|vaut|sont|è|vale|es)\b"
    r"|[はがを]",
    re.IGNORECASE,
)
_MULTIPLE = re.compile(
    r"\bhalf\b(?![ -](?:dis[ck]|circle|round|ring|cylinder|order|wave|cycle|turn|revolution))"
    r"|\btwice|\bthrice|\bhalv(?:e|es|ed|ing)\b|\bdoubl|\btripl|\bquadrupl|\btimes\b|[0-9]\s?%|\bnegative\b"
    r"|\bminus\b|\bless\b|\babzüglich|\bmoins\b"
    r"|\b(?:third|quarter|fourth|fifth|sixth|eighth|tenth|hundredth)s?\s+(?:of\b|the\b|as\b)"
    r"|\b(?:share|fraction|multiple|part|percent(?:age)?|negative|opposite|square|root|difference|sum)\s+of\b"
    r"|\bhalfway|\bmidway|\bmean\b|\baverage"
    r"|\bdoppel|\bhalbe?[mnrs]?\b|\bhälfte|(?:[a-zäöü]|-)(?<!ein)fach\w*\b|\b\w*(?:drittel|viertel|fünftel|zehntel)\b"
    r"|\bmittlere[mnrs]?\b"
    r"|\bmoitié|\btiers\b|\bquart\b|\bfois\b|\btriple|\bmoyenn|\bmetà\b|\bdoppi[oa]|\bmitad|\bdoble"
    r"|\bvolte\b|\bveces\b|倍|半分|分の[一1１]|平均",
    re.IGNORECASE,
)
"""A multiple, a share or a mean, of the quantity or of what it is had at."""
_SEVERAL = re.compile(
    r"\b(?:two|three|four|five|six|eight|twelve|zwei|drei|vier|fünf|sechs"
    r"|acht|zwölf|deux|trois|quatre)[ -](?!stroke|point|plane|revolution|turn|dead|cent)\w+"
    r"|\bboth\b(?! ends)|\bpair\s+of\b|\bbeide[mnrs]?\b|[二三四六八2-9]つの|両方"
    r"|\bin\s+(?:parallel|series|reihe)\b|\bparallel(?:geschaltet\w*|en)|並列|直列",
    re.IGNORECASE,
)
_INVERSE = re.compile(r"\b(?:inverse|reciprocal)\b|\bkehrwert|\binverso\b|逆数", re.IGNORECASE)
_RATE = re.compile(
    r"\b(?:per|pro|par)\s+(?!cylinder|cycle|revolution|turn|throw|pin|web|second|zylinder|umdrehung|sekunde|seconde|tour)"
    r"(?!minute|min\b)\w+|(?:単位|あたり|当たり)",
    re.IGNORECASE,
)
_MINUTE = re.compile(r"\b(?:per|pro|par|a)\s+minute\b|/min\b|\bmin⁻¹|毎分", re.IGNORECASE)
_LETTER = re.compile(r"\$[^$\n]{1,24}\$(?!\$)")
_SECOND = re.compile(
    r"\b(?:second|third|higher|next|zweite[mnrs]?|dritte[mnrs]?|höhere[mnrs]?|deuxième|seconde)\s*$|第[二三2-3２３]の?$",
    re.IGNORECASE,
)
_SETTING = re.compile(
    r"\b(?:on|between|auf|zwischen|in|entre)\s+(?:the\s+|den\s+)?(?:two|both|zwei|beiden|deux)\s+(?!springs?|federn)\w+"
    r"|\bmean\s+(?:effective|indicated|piston|speed|angular|radius|diameter|position)|\b(?:at\s+)?both\s+ends",
    re.IGNORECASE,
)
"""Words that make of nothing another quantity: a shaft on two bearings, at the mean speed."""


@dataclass(frozen=True, slots=True)
class Traits:
    """What is known of a quantity and of its formula, beside the words around its name."""

    name: str = ""
    is_told: bool = False
    """Whether it is told by words of its own, as that of two half discs."""
    has_several: bool = False
    """Whether its formula has the letters of several bodies."""
    is_by_minute: bool = False


def is_changed(text: str, words: str, traits: Traits) -> bool:
    """Tell whether the words beside a phrase make another quantity of the one that it names.

    >>> is_changed("Twice the kinetic energy is", "kinetic energy", Traits())
    True
    >>> is_changed("The kinetic energy of the disc is", "kinetic energy", Traits())
    False
    """
    before, behind = noun_phrase(text, words)
    bare = _SETTING.sub(" ", f"{before} · {behind}")
    is_natural = "natural" in traits.name or "critical" in traits.name
    patterns = [_MULTIPLE, _RATE]
    patterns += [] if traits.is_told or traits.has_several else [_SEVERAL]
    patterns += [] if "ratio" in traits.name else [_INVERSE]
    patterns += [_MINUTE] if "frequency" in traits.name and not traits.is_by_minute else []
    is_second = is_natural and not traits.is_told and _SECOND.search(before.rstrip()) is not None
    return is_second or any(pattern.search(bare) for pattern in patterns)


def noun_phrase(text: str, words: str) -> tuple[str, str]:
    """Return what stands in a phrase's own noun phrase, before it and behind it."""
    place = text.rfind(words)
    if place < 0:
        return "", ""
    before = _CLAUSE_ENDS.split(text[:place])[-1]
    behind = _CLAUSE_ENDS.split(_LETTER.sub("x", text[place + len(words) :]))[0]
    return _VERB.split(before)[-1], _VERB.split(behind)[0]
