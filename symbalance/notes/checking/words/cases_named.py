"""Cases that words name beside a formula: how far apart cranks are, which order, another engine's data.

A page gives F and C of a twin with cranks at 180° and goes on to cranks at 270°; its critical speed of
order 2 and then that of order 4; a pressure of one engine and then of a larger one. The letters stay the
same, and what they are does not.
"""

from __future__ import annotations

from symbalance.text import lazy_patterns as re

OF_ANOTHER_ENGINE = "of another engine than above"
"""What is said of a number that words give to another engine."""
_DEGREES = (
    r"(?<![0-9.,+*/^-])(?P<{}>[1-9][0-9]{{1,2}})\s?\$?\s?"
    r"(?:°|\^\s?\{{?\\circ\}}?|-?\s?(?:degrees?|deg(?![a-z]))|Grad(?![a-z])|度)\$?"
)
_SHAFT = (
    r"(?:cranks(?![a-z])|crank-?\s?shafts?(?![a-z])|crank-?\s?pins(?![a-z])|throws(?![a-z])|twins?(?![a-z])"
    r"|Kurbelwellen?(?![a-z])|Kurbelversatz|Kröpfungen|Kurbelzapfen|Hubzapfen(?:versatz)?|クランク(?!角)|位相|vilebrequin|manivelles"
    r"|calage|cig[uü]eñal|manovelle)"
)
_SPREAD = re.compile(
    rf"{_DEGREES.format('behind')}[\s-]{{0,3}}(?:{_SHAFT}|crank(?![a-z])(?!\s+(?:angle|position)))"
    rf"|(?:{_SHAFT}|(?<![A-Za-z])an?\s+crank\s+of)[^.;:=\n0-9。]{{0,25}}{_DEGREES.format('before')}(?!\s?(?:after|past|before|nach|vor))",
    re.IGNORECASE,
)
_ORDINALS = {
    "first": 1, "second": 2, "third": 3, "fourth": 4, "sixth": 6, "eighth": 8,
    "primary": 1, "secondary": 2,
    "erste": 1, "zweite": 2, "dritte": 3, "vierte": 4, "sechste": 6, "achte": 8,
    "premier": 1, "deuxième": 2, "quatrième": 4, "一": 1, "二": 2, "三": 3, "四": 4,
}  # fmt: skip
_ORDINAL = "|".join(sorted(_ORDINALS, key=len, reverse=True))
_ORDER = re.compile(
    r"(?<![A-Za-z])(?:order|Ordnung|ordre|orden)\s+(?:No\.?\s?)?\$?(?P<behind>[0-9]{1,2}(?:[.,]5)?)(?![0-9.,]*[0-9A-Za-z/])"
    rf"|(?<![A-Za-z0-9.,])(?:(?P<number>[0-9]{{1,2}}(?:[.,]5)?)\s?(?:st|nd|rd|th|\.|e|次)|(?P<word>{_ORDINAL})(?:[a-zè]{{0,2}}|次))"
    r"[\s-]{0,2}(?:orders?(?![a-z])|Ordnung|ordre|(?<=次))",
    re.IGNORECASE,
)
_THING = (
    r"(?:engines?|motors?|machines?|units?|compressors?|versions?|variants?|designs?|models?|examples?|cases?|shafts?|pumps?"
    r"|cars?|bikes?|motorcycles?|cylinders|twins?|singles?|fours?|sixes|diesels?|rotors?|crankshafts?)"
)
_ADJECTIVE = (
    r"(?:other|second|third|fourth|next|new|newer|old|older|earlier|later|former|original|modern|competing|final|larger|bigger"
    r"|smaller|longer|shorter|heavier|lighter|wider|stiffer|softer|stronger|thicker|thinner|higher|lower|faster|slower"
    r"|turbocharged|tuned|racing|sister)"
)
_MEASURED = (
    r"(?:measurements?|tests?|runs?|trials?|gears?|experiments?|attempts?|readings?|sets?|series|specimens?|journals?|springs?"
    r"|pistons?|rods?|flywheels?|cranks?|levers?|ones?|speeds?|points?|rows?|values?)"
)
_ADJEKTIV = (
    r"(?:ander|zweit|dritt|größer|kleiner|länger|kürzer|schwerer|leichter|nächst|neu|neuer|alt|älter|früher|später|ursprünglich)"
    r"e[rnms]?"
)
_ANOTHER = re.compile(
    rf"(?<![A-Za-z])(?:another|(?:the|an?|its|our|my)\s+{_ADJECTIVE})\s+(?:[\w.-]+\s+){{0,2}}?(?:{_THING}|{_MEASURED})(?![A-Za-z])"
    rf"|(?<![A-Za-z])(?:first|{_ADJECTIVE})\s+{_MEASURED}(?![A-Za-z])"
    rf"|(?<![A-Za-z])the\s+(?:first|{_ADJECTIVE})\s+(?:with|has|had|is|was|one|gives?|runs)(?![A-Za-z])"
    r"|(?<![A-Za-z])(?:successor|predecessor|rival|by\s+comparison|for\s+comparison|suppose|supposing|imagine|instead|try|trying"
    r"|doubling|halving|nominal(?:ly)?|worn|would|nowadays|today|had\s+(?:we|it|been)|in\s+contrast|whereas|typical(?:ly)?|usual(?:ly)?"
    r"|in\s+(?:18|19|20)[0-9]{2})(?![A-Za-z0-9])"
    r"|(?<![A-Za-z])(?:for|of|in|für|bei|pour|de)\s+(?:the\s+)?(?:(?:engine|twin|motor|Motor|moteur|machine|case|variant|set)\s+)?"
    r"[A-D1-9]\s?[:,]"
    r"|(?<![A-Za-z])(?:engine|twin|motor|moteur|machine|case|variant|set)\s+[A-D1-9](?![A-Za-z0-9])"
    rf"|(?<![A-Za-zäöü])(?:der|die|das|beim?|eine?[rnms]?|dem|den)\s+{_ADJEKTIV}(?![a-zäöü])(?!\s+(?:Ordnung|Harmonische|Kritische))"
    r"|(?<![A-Za-zäöü])(?:zum\s+Vergleich|dagegen|hingegen|angenommen|stattdessen|wäre|nominell|gemessen|üblich\w*|heute"
    r"|im\s+Jahre?\s+[0-9]{4})(?![A-Za-zäöü])"
    r"|(?:別の|他の|もう一つの|もう一方の|次の|新しい|大型の|小型の)[^。、\n]{0,12}(?:機関|エンジン|例|場合|仕様)|新型|旧型|改良型|[二2]回目"
    r"|仮に|代わりに|これに対し|一方"
    r"|(?<![A-Za-z])(?:un(?:e)?\s+autre|l'autre|le\s+second|la\s+seconde|le\s+nouveau|l'ancien)(?![A-Za-z])",
    re.IGNORECASE,
)


def crank_spread_named(text: str, first: int, last: int) -> tuple[int, int] | None:
    """Return where a part of a text last says how far apart cranks are, and the angle in degrees.

    >>> crank_spread_named("a twin with 270° cranks", 0, 23)
    (2, 270)
    >>> crank_spread_named("at a crank angle of 90°", 0, 23) is None
    True
    """
    match = max(_SPREAD.finditer(text, first, last), key=lambda m: m.start(), default=None)
    return None if match is None else (match.start(), int(match["behind"] or match["before"]))


def orders_named(words: str) -> list[str]:
    """Return the orders that words name, in their order.

    >>> orders_named("the critical speed of order 4"), orders_named("a second-order force, 6. Ordnung")
    (['4'], ['2', '6'])
    """
    return [
        str(_ORDINALS[match["word"].lower()])
        if match["word"]
        else (match["behind"] or match["number"]).replace(",", ".")
        for match in _ORDER.finditer(words)
    ]


def names_another_example(words: str) -> bool:
    """Tell whether words speak of another engine than the one before, or of what is only supposed.

    >>> names_another_example("the larger engine has"), names_another_example("the engine has")
    (True, False)
    """
    return _ANOTHER.search(words) is not None


_EXAMPLE = (
    r"(?:examples?|exercise|problem|engine|motor|Beispiel|Zahlenbeispiel|Aufgabe|Fall|Motor|exemple|exercice|moteur|cas"
    r"|ejemplo|esempio|motore|caso)"
)
_FOLLOWING = (
    r"(?:second|2nd|third|3rd|next|another|other|zweite[srn]?|2\.|dritte[srn]?|3\.|nächste[srn]?|andere[srn]?|noch\s+ein(?:e|en)?"
    r"|weitere[srn]?|deuxième|2e|troisième|autre|second[aeo]?|otro|altro)"
)
_NEXT = re.compile(
    rf"(?<![^\W\d_]){_FOLLOWING}\s+{_EXAMPLE}(?![^\W\d_])"
    r"|(?:別|他|次|第[二三])の?(?:数値)?(?:例|エンジン|機関|場合)|例題?\s*[2-9２-９]|(?:2|3|二|三)つ目の(?:例|エンジン|機関)",
    re.IGNORECASE,
)


def names_next_example(words: str) -> bool:
    """Tell whether words open the next example by name.

    >>> names_next_example("Second example: with"), names_next_example("An example:")
    (True, False)
    """
    return _NEXT.search(words) is not None


_SOME = re.compile(
    rf"(?<![A-Za-z])an?\s+(?:[\w-]+\s+){{1,3}}{_THING}(?![A-Za-z])"
    r"|(?<![A-Za-z])(?:eine?[rnm]?|einem)\s+(?:[\w-]+\s+){0,3}[\w-]*(?:motor|maschine|verdichter)s?(?![a-z])"
    r"|(?<![A-Za-z])une?\s+(?:[\w-]+\s+){0,2}(?:moteur|machine)|(?:ある|別の)[^。、\n]{0,10}(?:機関|エンジン)",
    re.IGNORECASE,
)


def names_some_engine(words: str) -> bool:
    """Tell whether words begin to speak of an engine: a marine engine has; not of the one at hand.

    >>> names_some_engine("A marine engine has "), names_some_engine("the engine has ")
    (True, False)
    """
    return _SOME.search(words) is not None


_CASE_OF_ANGLE = re.compile(
    r"(?<![^\W\d_])(?:for|with|at|für|fuer|bei|beim|mit|pour|à|avec|para|con|per|per\s+i|voor|bij)\s+"
    r"(?:(?:an?|the|eine[mnr]?|dem|der|den|une?|le|la|un|el|il)\s+){0,2}\$?(?P<behind>[1-9][0-9]{0,2})(?![0-9.,]*[0-9])"
    r"[\s~]?(?:°|\^\s?\{?\s?\\circ\s?\}?|-?\s?(?:degrees?|deg|Grad|degrés|grados|gradi)(?![a-z]))\$?"
    r"(?!\s?(?:after|before|past|nach|vor|après|avant|crank|Kurbel|KW|CA|ATDC|BTDC|phase|Phasen))"
    r"|(?<![0-9.,=/+-])(?P<before>[1-9][0-9]{0,2})\s?(?:°|度)\$?(?:の場合|のとき|では|なら)",
    re.IGNORECASE,
)


def angle_of_case(text: str, first: int, last: int) -> tuple[int, int] | None:
    """Return where a part of a text last names the angle of a case, and that in degrees; None for none.

    >>> angle_of_case("with 60 degrees F = 3, for 45° F = 2", 0, 30)
    (23, 45)
    >>> angle_of_case("it turns by 60° at 30° after top dead centre", 0, 40) is None
    True
    """
    match = max(_CASE_OF_ANGLE.finditer(text, first, last), key=lambda m: m.start(), default=None)
    return None if match is None else (match.start(), int(match["behind"] or match["before"]))
