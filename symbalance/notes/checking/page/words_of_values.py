"""How sentences give a letter its value: the letters, verbs, numbers and units that they use for it."""

from __future__ import annotations

from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

_SUBSCRIPT = r"(?:_\{[A-Za-z0-9,]{1,8}\}|_[A-Za-z0-9]|[₀-₉])?"
_NAME = r"(?:\\?[A-Za-z]{1,12}|[α-ωΑ-Ω])"
_IN_DOLLARS = rf"\$\s*(?P<dollars>{_NAME}(?:_\{{?[A-Za-z0-9,\\ {{}}]{{1,14}}\}}?)?)\s*\$"
_LETTER = (
    rf"(?:{_IN_DOLLARS}|\\\(\s*(?P<bracket>{_NAME}(?:_\{{?[A-Za-z0-9,]{{1,8}}\}}?)?)\s*\\\)"
    rf"|(?<=[a-zäöüßé]{{3}}[ ])(?P<plain>[A-Za-zα-ωΑ-Ω](?:[a-z]{{1,2}}|{_SUBSCRIPT}))(?![A-Za-z])"
    rf"|(?<=[\u3041-\u9fff])[ ]?(?P<after_sign>[A-Za-zα-ωΑ-Ω]{_SUBSCRIPT})(?![A-Za-z])"
    rf"|(?P<apart>(?:(?<=[a-zäöüßé]{{3}},[ ])|(?<=[.!?][ ])|^)[A-Za-zα-ωΑ-Ω]{_SUBSCRIPT})"
    r"(?=,?[ ](?:is|ist|est|è|es)[ ]))"
)
_VERB = (
    r"is(?:[ ](?:equal[ ]to|taken[ ](?:as|to[ ]be)|assumed[ ]to[ ]be|set[ ]to))?|amounts[ ]to|comes[ ]to"
    r"|equals|measures|be|ist(?:[ ]gleich)?|beträgt|sei|misst|vaut|mesure"
    r"|est(?:[ ](?:de|égale?[ ]à|prise?[ ]égale?[ ]à))?|è(?:[ ](?:di|pari[ ]a|uguale[ ]a))?|vale"
    r"|es(?:[ ](?:de|igual[ ]a))?|mide"
)
_THE = r"(?:the|our|its|der|die|das|le|la|l['’]|il|el)"
_CALLED = rf"[ ](?:is|ist|est|è|es)[ ]{_THE}[ ]?[^\W\d_][^.,;:!?$=()\n]{{2,40}}[,:][ ]"
"""Between a letter and its value, what it is: m is the mass of the piston, 2 kg."""
_GIVES = (
    rf"(?:,?[ ~\n](?:{_VERB}|of|von|mit|de|di)[ ~\n]|[ ]?[はがを][ ]?"
    r"|(?:[ ]\(|[ ]?（)(?=[^()（）\n]{1,24}[)）])|(?P<comma>,[ ])(?=[0-9])|(?P<beside>[ ~])(?=\$?[0-9])"
    rf"|;[ ]it[ ]is[ ]|{_CALLED})"
)
_NUMBER = (
    r"(?P<number>[0-9]{1,3}(?:[ \u202f\u2009][0-9]{3})+(?![0-9])"
    r"|[0-9]+(?:(?:[.,]|\{,\})[0-9]+|/[1-9][0-9]{0,2}(?![0-9/]|[.,][0-9]))?)"
)
GIVEN = re.compile(
    rf"{_LETTER}{_GIVES}\$?{_NUMBER}\$?(?=(?P<behind>[^\n]{{0,40}}(?:\n[^\n]{{0,20}})?))", re.MULTILINE
)
"""A letter and the number that a sentence gives it, with what stands behind."""
GIVEN_BEFORE = re.compile(
    rf"(?<=[ ~\n])(?:{_VERB}|of|von|de|di)[ ~\n]\$?{_NUMBER}\$?[ ~]?\$?"
    r"(?P<unit>[^\s\d$()（）,.;:=][^\s$()（）,.;:=]{0,12}|)\$?(?:[ ]?[(（]"
    r"|,[ ](?:which[ ]we[ ]call|called|denoted[ ](?:by[ ])?|genannt|notée?|detto|detta|llamad[oa])[ ])"
    rf"(?:{_IN_DOLLARS}|(?P<plain>[A-Za-zα-ωΑ-Ω]{_SUBSCRIPT}))(?=[)）]|[.,;]?(?:\s|$))"
)
"""A value before its letter: the stroke is 80 mm ($s$), a mass of 2 kg, which we call m."""
SAID = re.compile(rf"{_LETTER}[ ](?:is|equals|ist|beträgt|est|vaut|è|vale|es)[ ~\n](?:\$|\\\()?\s*$")
"""Before a formula, the letter that a sentence says it is: the stroke $C$ is $2R = 80$ mm."""
SETTING = re.compile(r"\\(?:mathrm|text|textrm|rm)(?![A-Za-z])|[{}$]|\\[,;: ]|~")
"""What sets a unit, and is none of its letters."""
_POWER, _END = r"(?:\^?-?[0-9]|[²³])?", r"(?=[\s,.;:)）、。のでにとをは]|$)"
_WORD = rf"[A-Za-zµΩ][A-Za-z]{{0,4}}{_POWER}"
_UNIT = re.compile(
    rf"\s*(?P<unit>%|1/[a-z]{{1,3}}|{_WORD}(?:[ ]?[/·][ ]?[A-Za-z]{{1,4}}{_POWER}"
    rf"|[ ][A-Za-z]{{1,2}}{_POWER})?){_END}"
)
_FIRST_OF_UNIT = re.compile(rf"\s*(?P<unit>{_WORD}){_END}")
_DEGREES = re.compile(
    r"[\s$]*(?:[°º]|\^\s*\{?\s*\\circ\s*\}?|\\degree|度|(?:degrees?|deg|grad|degrés?|gradi|grados?)(?![^\W\d_]))"
    r"(?!\s?(?:[CFK]|Celsius|Fahrenheit|Kelvin)(?![A-Za-z]))",
    re.IGNORECASE,
)
"""Behind the number of an angle: a number without them would be one of radians."""
_JOINS = (
    r"and|or|so|then|hence|thus|therefore|here|there|which|with|in|at|on|for|as|since|because|if|when|where|while"
    r"|we|the|this|that|but|und|oder|so|also|dann|damit|daher|hier|dort|mit|im|bei|am|für|wie|da|weil|wenn|wo|wir"
    r"|ist|et|ou|donc|alors|ainsi|ici|avec|dans|pour|au|car|si|on|e|o|quindi|allora|dunque|qui|con|nel|nella|per"
    r"|dove|se|y|entonces|luego|aquí|en|para|donde|cuando"
)
COUNTED = re.compile(
    rf"[ ~\n](?!(?:{_JOINS})(?![^\W\d_]))[A-Za-zÀ-ÿ]{{2,}}|[ ~]?(?:[°º′″]|\^|\\(?!\)))", re.IGNORECASE
)
"""Behind a number, what it counts, where that is no unit that is read: 5 pounds, 6 throws, 20 °C."""


def as_unit(text: str) -> str:
    """Return a unit as it is known: degrees have a sign, a power of a circle, or a word.

    >>> as_unit("°"), as_unit("Grad"), as_unit("mm")
    ('deg', 'deg', 'mm')
    """
    return "deg" if _DEGREES.fullmatch(text) else text


def unit_behind(text: str) -> tuple[str, int]:
    """Return the unit that stands behind a number, and where it ends; "" and 0 for none.

    >>> unit_behind(" kg, so"), unit_behind("° here"), unit_behind(" °C"), unit_behind(" throws")
    (('kg', 3), ('deg', 1), ('', 0), ('', 0))
    """
    degrees = _DEGREES.match(text)
    if degrees is not None:
        return "deg", degrees.end()
    plain = SETTING.sub(lambda match: " " * len(match[0]), text)
    for pattern in (_UNIT, _FIRST_OF_UNIT):
        match = pattern.match(plain)
        if match is not None and scale_of(" ".join(match["unit"].split())) is not None:
            return " ".join(match["unit"].split()), match.end()
    return "", 0
