"""Words that go on behind a comparison of numbers and say what it is a multiple of.

    √3 ≈ 1.732 times the first          7200/1800 = 4 times that of one cylinder
    1/4 = 25 % of the first order       √2 ≈ 1.414 mal so groß
    6/2 = 3 times per revolution        6/2 = 3 mal pro Umdrehung
    4973/670 ≈ 7.42 times the speed     a quotient, whose decimal is whole
    12991/9.81 ≈ 1324 times gravity     a quotient by what the words name

Both sides are numbers, so the relation is whole without the words. With a letter on a side it is not: F =
4 times that of one cylinder gives F no value of 4. So it is with 2 + 3 = 5 times the mass, which goes on.
"""

from __future__ import annotations

from symbalance.text import lazy_patterns as re

_ANOTHER = (
    r"(?:first|second|third|fourth|other|same|one|single|former|latter|primary|secondary|original|previous"
    r"|ersten?|zweiten?|dritten?|anderen?|einen|vorigen|einzelnen|premi[eè]re?|seconde?|autre)"
)
_NAMED = (
    rf"(?:(?:the|its|der|die|das|des|dem|den|le|la)\s+{_ANOTHER}|that|those|as|what|larger|greater|smaller|bigger"
    r"|higher|lower|more|less|faster|slower|longer|shorter|stronger|weaker|so|wie|größer|kleiner|jene[rsmn]?"
    r"|celle|celui|plus|moins)"
)
_SPAN = (
    r"(?:per|each|every|pro|je|jede[nrs]?|par|an?|one|in|within|during|im|während|de[rsm]|the)\s+"
    r"(?:(?:an?|one|each|every|the|eine[mnrs]?|jede[mnrs]?|de[rmns]|full|whole|single|complete|ganzen?|vollen?)\s+){0,3}"
    r"(?:rev(?:olution)?s?\.?|turns?|rotations?|cycles?|strokes?|seconds?|sec\.?|s|minutes?|min\.?|hours?|days?|period"
    r"|Umdrehung(?:en)?|Kurbelumdrehung|Umlauf|Arbeitsspiel|Spiel|Takt|Hub|Sekunde|Minute|Stunde|Periode|tour|cycle|seconde)"
)
"""In what span of time something happens so many times: per revolution, in one cycle."""
_MULTIPLE = re.compile(
    rf"(?:times|mal|fois)\s+(?:(?=(?:[^\W\d_]+\s+)??{_NAMED}\b)|(?={_SPAN}(?![A-Za-z])))", re.IGNORECASE
)
_TIMES = re.compile(
    r"(?:times|mal|fois|veces|volte)\s+(?=(?:the|its|der|die|das|la|le|el|il)\s)", re.IGNORECASE
)
_RATIO = re.compile(
    r"[^=≈]{1,40}(?:/|\\[dt]?frac)[^=≈]{1,40}(?:[=≈]|\\approx(?![A-Za-z]))\s*[0-9]+[.,][0-9]+\s*\$?"
)
"""A quotient with its decimal, which words can only say to be a multiple of something."""
_OVER_GRAVITY = re.compile(
    r"[^=≈]{1,60}(?:/|÷|\}\s?\{)\s?(?:9[.,]8[0-9]{0,4}|9\{,\}8[0-9]{0,4}|10)\s?\}?\s?(?:[=≈]|\\approx(?![A-Za-z]))"
    r"\s*[0-9][0-9.,]*\s*\$?"
)
_GRAVITY = re.compile(
    r"(?:times|mal|fois|veces|volte)\s+(?:(?:the|die|der|la|l')\s?)?(?:normal\s+|own\s+|earth(?:'s|’s)?\s+)?"
    r"(?:acceleration\s+(?:of|due\s+to)\s+)?(?:gravity|(?:the\s+)?weight|g|Erdbeschleunigung|Fallbeschleunigung"
    r"|Schwerkraft|pesanteur|gravedad|gravità)(?![\w/*·^(])",
    re.IGNORECASE,
)
"""What a number divided by 9.81 is a multiple of; else it may be put in: 49 = 5 times gravity."""
_SHARE = re.compile(rf"(?:of|von|de)\s+(?={_NAMED}\b)", re.IGNORECASE)
_COMPUTED = re.compile(
    r"\b(?:root|square|squared|cube|cubed|sum|difference|product|quotient|ratio|reciprocal|inverse|sine|cosine"
    r"|tangent|logarithm|half|third|quarter|double|twice|plus|minus|times|divided|Wurzel|Quadrat|Summe|Differenz"
    r"|Produkt|Kehrwert|Hälfte|mal|geteilt|durch)\b|[$\\=+*/^√·×]|[0-9]",
    re.IGNORECASE,
)
_CLAUSE = re.compile(r"[,;:!?)]|\.(?=\s|$)|\b(?:and|or|but|while|und|oder|aber|et|ou)\b|\n|$")
_CONSTANT = re.compile(
    r"\\(?:[dt]?frac|sqrt|cdot|times|approx|pi|left|right|sin|cos|tan|circ|text|mathrm)(?![A-Za-z])"
    r"|\\[,;: ]|\b(?:sin|cos|tan|sqrt|pi|exp)\b|π"
)


def says_multiple_of(text: str, start: int, end: int, behind: str) -> bool:
    """Tell whether words behind a relation of numbers only name what they are a multiple or a share of.

    >>> line = "√3 ≈ 1.732 times the first"
    >>> says_multiple_of(line, 0, 10, "times the first")
    True
    >>> says_multiple_of(line, 0, 10, "times the square root of 2")
    False
    """
    lead = _MULTIPLE.match(behind)
    if lead is None and _OVER_GRAVITY.fullmatch(text, start, end):
        lead = _GRAVITY.match(behind)
    if lead is None and _RATIO.fullmatch(text, start, end):
        lead = _TIMES.match(behind)
    if lead is None and text[end - 1 : end] == "%":
        lead = _SHARE.match(behind)
    if lead is None or re.search(r"[^\W\d_]", _CONSTANT.sub(" ", text[start:end])):
        return False
    clause = _CLAUSE.search(behind, lead.end())
    return _COMPUTED.search(behind[lead.end() : clause.start() if clause else len(behind)]) is None
