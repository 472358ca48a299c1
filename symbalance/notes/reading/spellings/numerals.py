"""Numbers as countries and scanners write them, put into one form: 0,045 becomes 0.045, 1O5 becomes 105.

Whether a comma is a decimal sign is decided once for a document, from the numbers in which it can be
nothing else; what is read so is said in a note.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

from symbalance.document.letters import FUNCTION_WORDS, GREEK_SIGN, LOWERED, NAME_OF_SIGN, RAISED
from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.notes.reading.signs import (
    COMBINED,
    DOTTED_NUMBERED,
    RELATION,
    VULGAR,
    accented,
    dotted_numbered,
)
from symbalance.notes.reading.spellings.pointed_units import compound_unit, unit_with_inches
from symbalance.notes.reading.spellings.units_of_one_letter import sure_unit_behind
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

_APART = (
    r"(?:(?<![\w.,\\])|(?<=\\cdot)|(?<=\\times)|(?<=\\approx)|(?<=\\simeq)|(?<=\\le)|(?<=\\ge)|(?<=\\leq)"
    r"|(?<=\\geq)|(?<=\\pm)|(?<=\\mp))"
)
"""Where a number begins: behind no letter, digit or point but those of an operator, \\cdot0,5."""
_COMMA = re.compile(
    _APART + r"(?<!_\{)(?<!\^\{)(?<!\{,\})(?<![0-9]\s,)([0-9]{1,12})(,|\{,\})([0-9]{1,15})"
    r"(?![0-9]|(?!(?:[mck]?m|k?g|k?Nm?|k?W|bar|ms|rad|kp|PS)(?![A-Za-z0-9]))[A-Za-z]|,[0-9]|\{,\}"
    r"|\.[0-9])"
)
_GROUPED = re.compile(
    _APART + r"(?<!_\{)(?<!\{,\})([1-9][0-9]{0,2})((?:,[0-9]{3})+)(?![0-9A-Za-z]|,[0-9])"
)
_POINT = re.compile(_APART + r"([0-9]{1,12})\.([0-9]{1,15})(?![0-9A-Za-z]|\.[0-9])")
_POINTED = re.compile(_APART + r"([1-9][0-9]{0,2})((?:\.[0-9]{3})+)(?![0-9A-Za-z]|\.[0-9])")
_POINTED_WITH_COMMA = re.compile(
    _APART + r"(?<!_\{)([1-9][0-9]{0,2}(?:\.[0-9]{3}){1,4}),([0-9]{1,6})(?![0-9A-Za-z]|[.,][0-9])"
)
"""4.663,5 has points between thousands and a decimal comma, whatever the rest of the page has."""
_POINTED_SPEED = re.compile(
    _APART
    + r"([1-9][0-9]?)\.([0-9]{3})(?=(?:\$|\\\))?(?:[ ~]|\\[,;: ])*(?:\\(?:mathrm|text|textrm)\{)?[ ]?"
    r"(?:rpm|1?/min|(?:U|tr|giri|rev)\.?[ ]?/[ ]?min|min[ ]?(?:\^\{?[-−]1|⁻¹|<sup>[-−]1)))"
)
"""3.000 min⁻¹: no engine turns three times a minute, and nobody gives a speed to its thousandth."""
_THIN_THOUSANDS = re.compile(
    r"(?<![\w.,\\\u2009\u202f])[1-9][0-9]{0,2}(?:[\u2009\u202f][0-9]{3})+(?![0-9\u2009\u202f][0-9])(?![0-9])"
)
_APOSTROPHES = re.compile(
    r"(?<![\w.,\\°'’])[1-9][0-9]{0,2}(?:['’][0-9]{3})+(?![0-9A-Za-z'’″]|[.,][0-9]*['’])(?:\.[0-9]+)?"
)
"""1'234'567 as the Swiss write it."""
_LANGUAGES = re.compile(
    r"\b(?:und|der|die|das|ist|mit|für|wird|bei|les|des|est|avec|pour|donc|los|las|para|con|della|per|che"
    r"|het|een|voor|och|med|jest|oraz|dla)\b"
)
_SCANNED = re.compile(
    r"(?<![\w.,\\])(?=[0-9O.,]{0,20}O)(?=[0-9O.,]{0,20}[0-9])[0-9O]{1,12}(?:[.,][0-9O]{1,12})?(?![\w(\\])"
)
_SCANNED_ONE = re.compile(r"(?<![\w.,\\])l(?=\.[0-9O])")
_LONE_ZERO = re.compile(r"(?<=[=≈] )O(?=\s*(?:[,.;]|$|\n))", re.MULTILINE)
_DASH = re.compile("[—―‒]")
_WORD = re.compile(r"(?<![\\A-Za-z])[A-Za-z]{2,}")
_FUNCTION = re.compile(r"\b(?:" + "|".join(sorted(FUNCTION_WORDS, key=len, reverse=True)) + r")\b")
_OPERAND_BEFORE = re.compile(r"[\w)\]}²³°′'&]$")
_OPERAND_AFTER = re.compile(r"[\w(\[\\√½¼¾|{]")
_FOOT_POUND = r"(?:(?:foot|feet|ft)(?:[ .·‐‑-]){0,2}(?:pounds?|lbs?f?\.?))"
_SPELLED = (
    ("mm", "millimet(?:er|re)s?|milli(?:metr[io]|mètres?|metros?)"),
    ("cm", "centimet(?:er|re)s?|Zentimeter|centi(?:metr[io]|mètres?|metros?)"),
    ("km", "kilomet(?:er|re)s?"),
    ("dm^3", "lit(?:er|re)s?|Litern?|litr[io]|litros?"), ("ml", "millilit(?:er|re)s?|Millilitern?"),
    ("bar", "bars"),
    ("ton/inch^2", r"(?:long |short )?tons?[\s-]?(?:per|/)\s?sq(?:uare|\.)?\s?in(?:ch|\.|\b)"),
    ("Mg", "metric tons?|tonnes?|Tonnen?|tonnellat[ae]|toneladas?"), ("ton", "(?:long |short )?tons?"),
    ("m", "met(?:er|re)s?|Metern?|metr[io]|mètres?|metros?"),
    ("kg", "kilogram(?:me)?s?|Kilogramm|chilogramm[io]|kilogramos?"),
    ("g", "gram(?:me)?s?|Gramm|gramm[io]|gramos?"),
    ("ms", "milliseconds?|Millisekunden?"), ("s", "seconds?|Sekunden?|second[io]|secondes?|segundos?"),
    ("min", "minutes?|Minuten?|minut[io]|minutos?"),
    ("kN", "kilonewtons?"), ("N", "newtons?"), ("Nm", "newton[ -]?met(?:er|re)s?|Newtonmeter"),
    ("Hz", "hertz"), ("W", "watts?"), ("kW", "kilowatts?"), ("J", "joules?"), ("rad", "radians?|Radiant"),
    ("rad/s", r"rad(?:ians?)?\.? ?(?:per|/) ?s(?:ec(?:onds?)?)?\b"),
    ("m/s", r"(?:met(?:er|re)s?|m) ?(?:per|/) ?sec(?:onds?)?\b"),
    ("rpm", r"r\. ?p\. ?m\b|rev(?:olution)?s?\.? per min(?:ute)?\b|Umdrehungen pro Minute"),
    ("1/min", r"(?:per min(?:ute)?\b|(?:pro|je) (?:min\b|Minute)|par minute|a minute)"),
    ("1/s", r"(?:per sec(?:ond)?\b|(?:pro|je) Sekunde|par seconde)"),
    ("ft·lbf/s", rf"{_FOOT_POUND} ?(?:per|/) ?s(?:ec(?:onds?)?)?\b"),
    ("ft·lbf/min", rf"{_FOOT_POUND} ?(?:per|/) ?min(?:utes?)?\b"), ("ft·lbf", _FOOT_POUND),
    ("psi", r"(?:lbs?\.?|lbf\.?|pounds?)[\s-]?(?:per|/)\s?sq(?:uare|\.)?\s?in(?:ch|\.|\b)"),
    ("lbf·inch", r"lbs?\.[ -]in(?:ch(?:es)?|\.|\b)|in\.[ -]lbs?\.?"), ("lbf·ft", r"lbs?\.[ -]ft\.?"),
    ("lbf·ft", r"(?:pound[ -]?(?:feet|foot)|lbs?f?\.?[ ·‐‑-]ft)"),
    ("lbf·inch", r"(?:inch[ -]pounds?|lbs?f?\.?[-‐‑·]in|in\.?[·‐‑-]lbs?f?\.?|in\. lbs?f?\.?)"),
    ("oz·inch", r"(?:oz|ounces?)(?:[ ]?[·‐‑-][ ]?|[ ])in(?:ch(?:es)?|\.)?(?=\s*(?:$|[,;.)=≈\n]))"),
    ("oz·inch", "in[·‐‑-]oz"),
    ("N·m", "N[-‐‑]m"), ("hp", r"H\. ?P\.|h\. ?p\.|horse[ -]?power"),
    ("ft/s²", r"(?:feet|ft\.?) ?(?:per|/) ?sec(?:onds?)?\.? per sec(?:onds?)?\b"),
    ("ft/s", r"(?:feet|ft\.?) ?(?:per|/) ?sec(?:onds?)?\b"),
    ("ft/min", r"(?:feet|ft\.?) ?(?:per|/) ?min(?:ute)?\b"),
    ("ft", "feet|foot|ft(?=\\.)"),
    ("inch^2", r"sq(?:uare|\.)? ?in(?:ches|ch|\.|(?![a-z]))"),
    ("ft^2", r"sq(?:uare|\.)? ?(?:feet|foot|ft\.?)"),
    ("inch^3", r"cu(?:bic|\.)? ?in(?:ches|\.|(?![a-z]))"),
    ("ft^3", r"cu(?:bic|\.)? ?(?:feet|foot|ft\.?)"),
    ("inch", r"in\.(?=\s*(?:[=≈]|\\approx))|inch(?:es)?|Zoll"
     r"|in(?=[ \t]?(?:$|[,;.)=≈\n]|so\b|and\b|or\b|und\b|long\b"  # two blanks: a LaTeX reference
     r"|\$(?!\s*(?:[A-Za-z(]|\\(?!times|cdot|approx|pm)))))"),  # "put 50 in $x^2$"
    ("kgf", "kg[ -]?force|kilogram(?:me)?[ -]force|kg[ -]weight|kilopond"),
    ("lbf", "pounds?[ -]force"), ("lb", "pounds?|lbs?(?=\\.)"),
    ("°", "degrees?|deg|Grad|degrés?|grad[io]|grados?|° ?(?:KW|CA|crank)|deg ?CA"),
    ("%", "per ?cent|Prozent|pour ?cent|por ciento|per cento|por cento|procent"),
)  # fmt: skip
_SPELLED_UNIT = re.compile(
    rf"(?:(?<=[0-9{''.join(VULGAR)}])|(?<=[0-9]O))(?<!_[0-9])(\$?|\\\))[ ~]?(\$?)(?:"
    + "|".join(f"(?P<u{n}>{names})" for n, (_, names) in enumerate(_SPELLED))
    + r")(?![A-Za-z])",
    re.IGNORECASE,
)
_SET_UNIT = re.compile(
    r"(?<=[0-9])(?:\\[,;: ]|~)?\\(?:text|textrm|mathrm|mbox)\s*\{[ ~]*(?:"
    + "|".join(f"(?P<u{n}>{names})" for n, (_, names) in enumerate(_SPELLED))
    + r")(?P<behind>[.,;: ~]*)\}",
    re.IGNORECASE,
)
"""A unit written out, or abbreviated with points, within the words of a display."""
_PART_BEHIND = r"(?:1|[A-Za-zµμΩ]+)(?:\^?\{?[-−]?[1-4]\}?|[⁻]?[¹²³⁴]|\$\^\{?[-−]?[1-4]\}?\$)?"
_BEHIND_DOLLAR = re.compile(
    r"(?:(?<=[0-9])|(?<=\^\{[0-9]\})|(?<=\^\{[-−][0-9]\})|(?<=\^\{[0-9]{2}\})|(?<=\^\{[-−][0-9]{2}\})"
    r"|(?<=10[⁰¹²³⁴⁵⁶⁷⁸⁹])|(?<=10⁻[¹²³⁴⁵⁶⁷⁸⁹])|(?<=10[¹][⁰¹²]))(?<!_[0-9])(?:\\[,;: ]|~)?(?P<mark>\$"
    r"|\\\))(?:[ ~]|\\[,;: ])?"
    rf"(?P<unit>°|\\?%|{_PART_BEHIND}(?:(?:[ ]?[/·⋅*]?[ ]?|\\,|~){_PART_BEHIND}){{0,3}})"
    r"(?=[.,;:)]{0,2}(?:\s*$|[\s|)\ue000])|[.,;:)][\s$]|\((?=\$|\\\(|[\u3041-\u9fff])"
    r"|[\u3001-\u9fff\uff08-\uff1f])(?! ?[=<>≈+*/])",
    re.MULTILINE,
)
"""A unit behind the dollar or `\\)` that ends a formula: N m/rad as a whole, but m of `40$ m long`."""
_EXCLAIMED = re.compile(
    r"(?:(?<=[0-9])!|(?<=[0-9] [A-Za-z°%])!|(?<=[0-9] [A-Za-z]{2})!|(?<=[0-9] [A-Za-z]{3})!)"
    r"!{1,2}(?=\s|$)"
    r"|(?<=[0-9] (?:Hz|mm|cm|kg|kN|Nm))!(?=\s|$)"
)
"""Marks that end a sentence with a quantity, 300 Hz!!, and are no factorials."""
_NEARLY = re.compile(r"(?<=[\s\w)\]])(?:~=|=~|≈=|=≈)(?=[\s\w(√-])")
_PLUS_MINUS = re.compile(
    r"(?<=[0-9A-Za-z)][ ])\+[ ]?/[ ]?[-−](?=[ ]?[0-9A-Za-z(])|(?<=[0-9)])\+/[-−](?=[0-9])"
)
_OPENED = {
    "$": re.compile(r"\$[^$\n]*$"),
    "\\)": re.compile(r"\\\((?:(?!\\[()]).)*$"),
}
_AROUND = 400  # characters of a line looked at on either side
FEWEST_WORDS = 3
"""Of a language that writes decimal commas, before `1,5` counts as one; `i = 1,2` is a list elsewhere."""


def unit_spelled(text: str, place: int) -> tuple[str, int]:
    """Return the unit that is written out behind a number, and where it ends; "" and the place for none.

    >>> unit_spelled("8 inches or so", 1), unit_spelled("8 throws", 1)
    (('inch', 8), ('', 1))
    """
    match = _SPELLED_UNIT.match(text, place)
    if match is None:
        return "", place
    return _sign_spelled(match), match.end()


def _sign_spelled(match: re.Match[str]) -> str:
    return next(sign for n, (sign, _) in enumerate(_SPELLED) if match[f"u{n}"])


def with_plain_numerals(
    text: str, is_letter: Callable[[str, int], bool] = lambda name, line: False
) -> tuple[Rewritten | None, tuple[str, ...]]:
    """Return a text with its numbers in one form, None if they are so already, and what to say of it.

    `is_letter` tells whether a name is a letter on a line: where O is one, 2O is a product.

    >>> rewritten, notes = with_plain_numerals("m = 0,045 und l = 0,15")
    >>> rewritten.text, notes[0]
    ('m = 0.045 und l = 0.15', 'decimal commas: 0,045 is read as 0.045 (2 numbers)')
    """
    changes: dict[int, tuple[int, str]] = {}
    notes: list[str] = []
    raised = _raised_points(text)
    _note(notes, "decimal points", raised, text)
    commas = _commas(text, notes, bool(raised))
    changes |= commas
    speeds = {m.start(): (m.end(), m[1] + m[2]) for m in _POINTED_SPEED.finditer(text)}
    _note(notes, "points between thousands", speeds, text)
    changes |= speeds
    both = {
        m.start(): (m.end(), f"{m[1].replace('.', '')}.{m[2]}")
        for m in _POINTED_WITH_COMMA.finditer(text)
    }
    _note(notes, "points between thousands", both, text)
    changes |= both
    swiss = {m.start(): (m.end(), re.sub("['’]", "", m[0])) for m in _APOSTROPHES.finditer(text)}
    _note(notes, "apostrophes between thousands", swiss, text)
    changes |= swiss
    thin = {
        m.start(): (m.end(), re.sub("[\u2009\u202f]", "", m[0])) for m in _THIN_THOUSANDS.finditer(text)
    }
    changes |= {start: change for start, change in thin.items() if start not in changes}
    scanned = _scanned(text, is_letter, notes)
    for start, (end, written) in scanned.items():
        whole, comma, part = written.partition(",")
        is_decimal = comma and (commas or (whole.strip("0") == "" and len(part) > 1))
        changes[start] = end, f"{whole}.{part}" if is_decimal else written
    changes |= _dashes(text, notes)
    changes |= {m.start(): (m.end(), "≈") for m in _NEARLY.finditer(text)}
    changes |= {m.start(): (m.end(), "±") for m in _PLUS_MINUS.finditer(text)}
    changes |= _powers_before_units(text)
    changes |= _units_in_words(text)
    changes |= {m.start(): (m.end(), ".") for m in _EXCLAIMED.finditer(text)}
    changes |= _crosses(text)
    changes |= _parts_of(text)
    changes |= {m.start(): (m.end(), _mixed(m[1], m[2])) for m in _MIXED.finditer(text)}
    changes |= _mixed_and_inches(text)
    changes |= {
        m.start(): (m.end(), f"({_small(m[1])}/{_small(m[2])})") for m in _SMALL_FRACTION.finditer(text)
    }
    changes |= _points(text, notes)
    changes |= {m.start(): (m.end(), ".") for m in _BRACED_POINT.finditer(text)}
    changes |= _spaced_points(text, notes)
    changes |= _spaced_thousands(text, notes)
    changes |= _accents(text)
    changes |= _subscript_words(text, is_letter)
    changes |= raised
    changes |= _arrows(text)
    if not changes:
        return None, ()
    rewriter = Rewriter(text)
    for start, (end, written) in sorted(changes.items()):
        if start >= rewriter.place:
            rewriter.replace(start, end, written)
    return rewriter.finish(), tuple(notes)


def _commas(text: str, notes: list[str], has_raised_points: bool) -> dict[int, tuple[int, str]]:
    """Return the numbers with a comma as they are read, by their places: 3,000 is 3000 beside 0·0284."""
    matches = [match for match in _COMMA.finditer(text) if not _is_pair(text, match)]
    both = list(_POINTED_WITH_COMMA.finditer(text))
    grouped = [match for match in _GROUPED.finditer(text) if not _is_pair(text, match)]
    if not matches and not grouped and not both:
        return {}
    is_usual = len(_LANGUAGES.findall(text)) >= FEWEST_WORDS
    plain = [match for match in matches if _is_surely_decimal(match, is_usual)]
    sure = [*plain, *both]
    points = [match for match in _POINT.finditer(text) if len(match[2]) != 3 or match[1] == "0"]
    changes: dict[int, tuple[int, str]] = {}
    if sure and len(sure) >= len(points) and not has_raised_points:
        decimal = {match.start(): (match.end(), f"{match[1]}.{match[3]}") for match in matches}
        thousands = [match for match in _POINTED.finditer(text) if _follows_formula(text, match)]
        changes = decimal | {m.start(): (m.end(), m[1] + m[2].replace(".", "")) for m in thousands}
        _note(notes, "decimal commas", decimal, text)
        _note(notes, "points between thousands", {m.start(): changes[m.start()] for m in thousands}, text)
        return changes
    zeros = {
        m.start(): (m.end(), f"{m[1]}.{m[3]}") for m in plain if m[1].strip("0") == "" and len(m[3]) > 1
    }
    if zeros:  # 0,5 · 0,04 among points
        zeros |= {
            m.start(): (m.end(), f"{m[1]}.{m[3]}")
            for m in matches
            if m[1] == "0" and _BEFORE_OPERATION.match(text, m.end())
        }
    if any(m[2] == "{,}" for m in plain):  # a brace that is decimal once is always
        zeros |= {m.start(): (m.end(), f"{m[1]}.{m[3]}") for m in matches if m[2] == "{,}"}
    _note(notes, "decimal commas", zeros, text)
    if not points and not is_usual:  # 3,900/2,883 = 1.353 has both, and no words of a decimal comma
        points = [match for match in _POINT.finditer(text) if _follows_formula(text, match)]
    has_quantities = not is_usual and any(map(_is_one_number, grouped))  # 1,200 kg
    if (points or has_raised_points or has_quantities) and not zeros:
        changes = {m.start(): (m.end(), m[1] + m[2].replace(",", "")) for m in grouped}
        _note(notes, "commas between thousands", changes, text)
    return changes | zeros


_BEFORE_OPERATION = re.compile(r"\s*(?:[·⋅×*=≈/]|\\(?:cdot|times|approx)(?![A-Za-z]))")
_POINT_BETWEEN = re.compile(
    r"(?:(?<![A-Za-z\\])[A-Za-z](?:_\w{1,4}|_\{\w{1,6}\}|[₀-₉0-9])?[²³]?"
    r"|(?:sin|cos|tan)[²³]? ?[0-9]?[A-Za-z]|(?<![A-Za-z])pi(?=\.[0-9A-Za-z(])"
    r"|[)\]²³}\u03b1-\u03c9]|(?<![0-9.])[0-9]{1,3}|(?<=\^)[0-9])"
    r"(?P<point>\.)"
    r"(?=[A-Za-z](?![A-Za-z])|[A-Za-z]?(?:sin|cos|tan|sqrt|exp|pi)(?![a-z])"
    r"|[A-Za-z]?(?:sin|cos|tan)[a-z](?![a-z])|[\u03b1-\u03c9(√]"
    rf"|\\(?:{'|'.join((*GREEK_SIGN, *FUNCTION_WORDS, 'frac', 'dot', 'ddot', 'left'))})(?![A-Za-z])"
    r"|(?<=pi\.)[0-9])"
)
_ABBREVIATED = re.compile(
    r"\b(?:z\.B|d\.h|i\.e|e\.g|u\.a|s\.o|s\.u|p\.m|a\.m|i\.d|u\.U|o\.g|i\.A|i\.e|w\.r|r\.h|l\.h)\b"
)


def _points(text: str, notes: list[str]) -> dict[int, tuple[int, str]]:
    """Return the points that multiply, m.ω².r: between letters, without a space, beside a relation."""
    changes: dict[int, tuple[int, str]] = {}
    for match in _POINT_BETWEEN.finditer(text):
        place = match.start("point")
        begin, stop = text.rfind("\n", 0, place) + 1, text.find("\n", place)
        begin, stop = max(begin, place - _AROUND), min(stop if stop >= 0 else len(text), place + _AROUND)
        line = text[begin:stop]
        if RELATION.search(line) is None or any(
            m.start() <= place - begin < m.end() for m in _ABBREVIATED.finditer(line)
        ):
            continue
        changes[place] = (place + 1, "·")
    if changes:
        notes.append(f"a point between letters is read as a multiplication sign ({len(changes)}×)")
    return changes


_BRACED_POINT = re.compile(r"(?<=[0-9])\{\.\}(?=[0-9])")
_SPACED_POINT_OF_PRODUCT = re.compile(r"(?<=[0-9)²³]) \. (?=[0-9(])")
_SPACED_THOUSANDS = re.compile(
    r"(?<![\w.,])(?<![0-9] )[1-9][0-9]{0,2}(?: [0-9]{3})+(?![0-9A-Za-z])(?! [0-9])"
)
_OPERATION_BEFORE = re.compile(r"(?:[=≈<>≤≥+\-−–·×*/(]|\\(?:cdot|times|approx))\s*$")
_OPERATION_AFTER = re.compile(r"\s*(?:[=≈+\-−·×*/^]|\\(?:cdot|times|approx)|[²³])")


def _spaced_points(text: str, notes: list[str]) -> dict[int, tuple[int, str]]:
    """Return the points that multiply numbers, 0.5 . 0.04 . 314: with a space on both sides."""
    changes: dict[int, tuple[int, str]] = {}
    for match in _SPACED_POINT_OF_PRODUCT.finditer(text):
        line = text[text.rfind("\n", 0, match.start()) + 1 : match.start()]
        if RELATION.search(line[-_AROUND:]) is not None:
            changes[match.start()] = (match.end(), " · ")
    if changes:
        notes.append(f"a point between numbers is read as a multiplication sign ({len(changes)}×)")
    return changes


def _spaced_thousands(text: str, notes: list[str]) -> dict[int, tuple[int, str]]:
    """Return the numbers with spaces between thousands, 81 300/942.5: beside an operation."""
    changes: dict[int, tuple[int, str]] = {}
    for match in _SPACED_THOUSANDS.finditer(text):
        before = text[max(match.start() - 12, 0) : match.start()]
        if _OPERATION_BEFORE.search(before) or _OPERATION_AFTER.match(text, match.end()):
            changes[match.start()] = (match.end(), match.group().replace(" ", ""))
    _note(notes, "spaces between thousands", changes, text)
    return changes


_ARROW = re.compile(r"(?<=\s)(?:<=+>|<-+>|=+>|-+>)(?=\s)")


_CROSS = re.compile(
    r"(?<=[0-9)²³½¼¾⅓⅔⅛])(?:[ ]?[xX][ ](?=[0-9.])|[ ][xX](?=[0-9.])|[ ](?P<letter>[xX])[ ]?(?=[(√π]))"
)
_LETTER_X = re.compile(
    r"(?:sin|cos|tan)(?:\^?\{?[²³23]?\}?)\s?\(?[0-9]?\s?[xX](?![A-Za-z])|[xX]\s?(?:=|[²³^])"
)
"""Where a line has x as a letter of its own."""
_CROSS_BEHIND_UNIT = re.compile(
    r"(?<=[0-9])[ ]?(?P<unit>[A-Za-z.]{1,6}(?:[-/·][A-Za-z.]{1,4})?)(?P<cross>[ ][xX][ ])(?=[0-9(.])"
)
_SMALL_FRACTION = re.compile("([⁰¹²³⁴⁵⁶⁷⁸⁹]{1,3})[/⁄∕]([₀₁₂₃₄₅₆₇₈₉]{1,3})")


def _line_around(text: str, place: int) -> str:
    """Return the line of a place, so far as it is near."""
    before = text[max(place - _AROUND, 0) : place].rpartition("\n")[2]
    return before + text[place : place + _AROUND].partition("\n")[0]


def _crosses(text: str) -> dict[int, tuple[int, str]]:
    """Return the letters x that stand for a multiplication sign between numbers, 2 x 0.5."""
    changes = {
        match.start(): (match.end(), " × ")
        for match in _CROSS.finditer(text)
        if match["letter"] is None or _LETTER_X.search(_line_around(text, match.start())) is None
    }
    for match in _CROSS_BEHIND_UNIT.finditer(text):
        if sign_of_unit(match["unit"]):
            changes[match.start("cross")] = (match.end("cross"), " × ")
    return changes


_MIXED = re.compile(
    r"(?<![\w.,/+*·×^$])(?<![0-9] )([1-9][0-9]?)[ -]([1-9][0-9]?/(?:2|4|8|16|32|64))"
    r"(?=[ -]?(?:in|inch|inches|ft|lbs?)(?![A-Za-z]))"
)
"""One and a half inches as a workshop writes them, 1 1/2 in."""
_MIXED_SIGN = re.compile(
    r"(?<![\w.,])(?P<whole>[1-9][0-9]?)(?P<part>[½⅓⅔¼¾⅕⅖⅗⅘⅙⅚⅛⅜⅝⅞])"
    r"(?=[ -]?(?:ft|feet|lbs?|cm|mm|m|kg|miles?|hours?|turns?)(?![A-Za-z])"
    r"|(?P<inch>[ -]?(?:in|inch|inches)(?![A-Za-z])|[\"″]))"
)
_INCH_SIGN = re.compile(r"(?<=[0-9])(?<![′'][0-9])(?<![′'][0-9]{2})[\"″](?=[\s.,;:)=<>≈+×x*/-]|$)")
_QUOTE = re.compile(
    r"(?P<opening>(?:^|(?<=[\s(\[=>]))[\"″](?=\w))|(?P<closing>(?<=\w)[\"″]|(?<=[.,!?])[\"″])"
    r"|\n[ \t>]*\n",
    re.MULTILINE,
)
"""A sign that opens or closes a quotation, or an empty line, which ends all of them."""

_PER_MILLE = re.compile(
    r"(?<![\w.,])(?P<whole>[0-9]{1,6})(?:(?:[.,]|\{,\})(?P<rest>[0-9]{1,6}))?"
    r"(?:[ ~]|\\[,;: ])?(?P<mark>\$|\\\))?(?:[ ~]|\\[,;: ])?"
    r"(?P<open>\\(?:text|textrm|mathrm|mbox)\{[ ~]?)?(?:‰|\\permil(?![a-z])"
    r"|(?P<millionth>(?i:ppm|parts[ ]per[ ]million)(?![\w/]))"
    r"|(?i:per[ ]?mille?|promille|pour[ ]mille|por[ ]mil|per[ ]mil|o/oo|parts[ ]per[ ]thousand)(?!\w))"
    r"(?(open)[ ~]?\})"
)
"""A number per mille or per million, with the dollar that may end its formula before the word."""
_PART_OF = re.compile(
    r"(?<=[0-9])(?P<gap>[ ~]|\\[,;: ])?(?P<sign>\\?%|‰|percent|per cent|Prozent)[ ~]+(?:of|von|de)[ ~]+"
    r"(?:the[ ~]+|der[ ~]+)?(?=[0-9]+(?:[.,][0-9]+)?[^\n]{0,40}?[=≈])"
)


def _parts_of(text: str) -> dict[int, tuple[int, str]]:
    """Return 5 ‰ as 0.5 %, 200 ppm as 0.0200 %, and 12 % of 26.3 kN in a relation as a product."""
    changes: dict[int, tuple[int, str]] = {}
    for match in _PER_MILLE.finditer(text):
        places = 4 if match["millionth"] else 1
        whole = match["whole"].rjust(places + 1, "0")
        shifted = f"{whole[:-places]}.{whole[-places:]}{match['rest'] or ''}"
        is_inside = text.count("$", text.rfind("\n", 0, match.start()) + 1, match.start()) % 2
        escape = "\\" if is_inside or match["mark"] else ""
        changes[match.start()] = (match.end(), f"{shifted} {escape}%{match['mark'] or ''}")
    for match in _PART_OF.finditer(text):
        if match["sign"] == "‰":
            start = match.start("sign") + 1
            changes[start] = (match.end(), " · ")
        else:
            changes[match.start()] = (
                match.end(),
                f" {match['sign'] if '%' in match['sign'] else '%'} · ",
            )
    return changes


_POWER_BEFORE_UNIT = re.compile(
    r"(?<![\w.,\\])(?P<digits>[0-9]{1,9}(?:[.,][0-9]{1,9})?)[eE](?P<sign>[-+]?)0?(?P<power>[0-9]{1,2})"
    r"(?=[ ~](?P<unit>[A-Za-zµ]{1,4}(?:/[A-Za-z]{1,3}[²³]?)?)(?![A-Za-z0-9_]))"
)


def _powers_before_units(text: str) -> dict[int, tuple[int, str]]:
    """Return the powers of ten of programs before a unit, 1.2e6 Pa, as those of print."""
    changes: dict[int, tuple[int, str]] = {}
    for match in _POWER_BEFORE_UNIT.finditer(text):
        if scale_of(match["unit"]) is not None:
            sign = match["sign"].strip("+")
            changes[match.end("digits")] = (match.end(), f"·10^{{{sign}{match['power']}}}")
    return changes


def _mixed(whole: str, part: str) -> str:
    """Return 7 and 1/2 as one number."""
    above, _, below = part.partition("/")
    return f"({int(whole) * int(below) + int(above)}/{below})"


def _small(digits: str) -> str:
    return "".join({**RAISED, **LOWERED}[digit] for digit in digits)


_ENDING = re.compile(
    r"(?<![A-Za-z\\_{])([A-Za-z][0-9]?)(max|min|res|ges|tot|osz|rot|rms|eff|avg|mean)(?![A-Za-z0-9_])"
)
_RAISED_POINT = re.compile(
    r"(?<![\w.,·])(?P<whole>[0-9O]{1,6})(?:·|\{\\cdot\})(?P<part>(?!10(?:\^|[⁰¹²³⁴-⁹⁻]))[0-9O]{1,12})"
    r"(?![A-Za-z0-9_·]|[.,][0-9]|\{\\cdot\})"
)
"""Two numbers that nothing but a point on the line's middle parts: no power of ten, no third number."""
_SPACED_POINT = re.compile(r"[\w)] ?· |(?<=[^\W\dO])·|·(?=[^\W\dO])")


def _mixed_and_inches(text: str) -> dict[int, tuple[int, str]]:
    """Return 3½ in with its unit in letters, and the inches of 5.8" on a page that quotes nothing so."""
    changes: dict[int, tuple[int, str]] = {}
    for match in _MIXED_SIGN.finditer(text):
        unit = " inch" if match["inch"] else ""
        end = match.end("inch") if match["inch"] else match.end()
        changes[match.start()] = end, f"{match['whole']}{match['part']}{unit}"
    for match in _INCH_SIGN.finditer(text):
        if not _closes_quotation(text, match.start()):
            changes[match.start()] = (match.end(), " inch")
    return changes


def _closes_quotation(text: str, place: int) -> bool:
    """Tell whether a sign behind a number ends what was quoted in its paragraph: "size 5"."""
    is_open = False
    for match in _QUOTE.finditer(text, max(0, place - _PARAGRAPH), place):
        is_open = match["opening"] is not None
    return is_open


_PARAGRAPH = 1000
"""Characters before a sign in which a quotation may have been opened."""


def _accents(text: str) -> dict[int, tuple[int, str]]:
    """Return the letters with an accent of Unicode, F̂₂ and ẍ1, as those of LaTeX."""
    combined = {m.start(): (m.end(), f"{accented(m)} ") for m in COMBINED.finditer(text)}
    return combined | {
        m.start(): (m.end(), f"{dotted_numbered(m)} ") for m in DOTTED_NUMBERED.finditer(text)
    }


def _subscript_words(text: str, is_letter: Callable[[str, int], bool]) -> dict[int, tuple[int, str]]:
    """Return letters with their subscript's word run on, F1max and a_max typed amax."""
    return {
        match.start(2): (match.end(2), f"_{match[2]}")
        for match in _ENDING.finditer(text)
        if not is_letter(match.group(), text.count("\n", 0, match.start()) + 1)
    }


def _raised_points(text: str) -> dict[int, tuple[int, str]]:
    """Return the points of old prints, 125·7 for 125.7 and 0·0284 for 0.0284.

    No factor begins with a zero: 0·0284 shows that the page's points are decimal signs. Without such a
    number they are where products are written with a cross and few decimal signs stand on the line.
    """
    points = list(_RAISED_POINT.finditer(text))
    if not points:
        return {}
    if not any(_is_no_product(match) for match in points) and (
        ("×" not in text and "\\times" not in text)
        or _SPACED_POINT.search(text)
        or 2 * sum(_follows_formula(text, match) for match in _POINT.finditer(text)) > len(points)
    ):
        return {}
    return {m.start(): (m.end(), f"{m['whole']}.{m['part']}".replace("O", "0")) for m in points}


def with_raised_points_lowered(text: str) -> str:
    """Return a text of the same length with points on the line where its decimal points are raised.

    >>> with_raised_points_lowered("l = 8·5, thus r/l = 0·2647"), with_raised_points_lowered("l = 2·3")
    ('l = 8.5, thus r/l = 0.2647', 'l = 2·3')
    """
    pieces, place = list[str](), 0
    for start, (end, written) in _raised_points(text).items():
        pieces += [text[place:start], written.rjust(end - start)]
        place = end
    return "".join((*pieces, text[place:]))


def _is_no_product(match: re.Match[str]) -> bool:
    """Tell whether two numbers around a point are no factors: 0·04 and 2·05, but not 0·12 or 3·0."""
    part = match["part"]
    return (part[0] == "0" and part.strip("0") != "") or (match["whole"] == "0" and len(part) > 2)


def _arrows(text: str) -> dict[int, tuple[int, str]]:
    """Return the arrows typed in signs, => and ->, between spaces as arrows."""
    shown = {"<=": "⇔", "<-": "⇔", "==": "⇒", "=>": "⇒", "--": "→", "->": "→"}
    return {m.start(): (m.end(), shown[m.group()[:2]]) for m in _ARROW.finditer(text)}


def _is_pair(text: str, match: re.Match[str]) -> bool:
    """Tell whether brackets hold these two numbers alone: (1,2) and [0,1] are pairs, no cos(2,5)."""
    before, after = text[max(match.start() - 1, 0) : match.start()], text[match.end() : match.end() + 1]
    is_in_brackets = (before, after) in (("(", ")"), ("[", "]"), ("(", "]"), ("[", ")"), ("|", "|"))
    is_raised = after == ")" and _RAISED_BEHIND.match(text, match.end()) is not None
    return is_in_brackets and not is_raised and not _is_argument(match)


def _is_argument(match: re.Match[str]) -> bool:
    """Tell whether a number stands alone in the brackets of a function that takes one: cos(22,5)."""
    text, start, end = match.string, match.start(), match.end()
    return text[end : end + 1] == ")" and _CALLED.search(text, max(0, start - 16), start) is not None


_RAISED_BEHIND = re.compile(r"\)\s?(?:\^|[²³°])")
"""A power behind the bracket: (1,5)² is that of one number."""
_CALLED = re.compile(
    r"(?:(?<![A-Za-z])(?:a|arc|ar)?(?:sin|cos|tan|cot|sinh|cosh|tanh)|(?<![A-Za-z])(?:sqrt|exp|ln|abs|sen|tg)|√)"
    r"(?:[²³]|\^\{?[23]\}?)?[ ]?(?:\\left)?\($"
)


def _is_surely_decimal(match: re.Match[str], is_usual: bool) -> bool:
    """Tell whether a comma can be nothing but a decimal sign."""
    whole, sign, part = match.groups()
    if sign == "{,}":
        return len(part) != 3 or whole.strip("0") == ""
    if (whole.strip("0") == "" and len(part) > 1) or _is_argument(match):
        return True
    return len(part) != 3 and (is_usual or len(part) > 2 or _is_one_number(match))


_UNIT_BEHIND = re.compile(
    r"(?:\$|\\\))?(?:[ ~]|\\[,;: ])?(?:\\(?:mathrm|text|textrm)\{)?[ ]?"
    r"(?P<unit>(?:[kMmcµ]?(?:N|Pa|W|J|m|g|s|Hz)|bar|rad|U|kp|PS|min)(?:[²³]|[ ·]?m)?"
    r"(?:/(?:[mckM]?[msg]|min|mm|rad)[²³]?)?)"
    r"(?![A-Za-z0-9_\u00c0-\u024f])"
)
_COMPUTED_BESIDE = re.compile(r"[ ~]?(?:[·⋅×*/±^]|\\(?:cdot|times|pm)(?![A-Za-z]))")
_COMPUTED_BEFORE = re.compile(r"(?:[·⋅×*/±]|\\(?:cdot|times|pm))[ ~]?$")


def _is_one_number(match: re.Match[str]) -> bool:
    """Tell whether a comma stands within one number by its company: a unit, or a sign of multiplication.

    30,2 kN and 42,5 ± 0,5 are no lists; i = 1,2 may be one, and so may 1,2 m without a sign before it.
    """
    text, start, end = match.string, match.start(), match.end()
    before = text[max(start - 8, 0) : start]
    if _COMPUTED_BESIDE.match(text, end) or _COMPUTED_BEFORE.search(before):
        return True
    unit = _UNIT_BEHIND.match(text, end)
    is_stated = re.search(r"(?:[=≈<>+−-]|\\approx|\()[ ~]?$", before) is not None
    return unit is not None and is_stated


def _follows_formula(text: str, match: re.Match[str]) -> bool:
    """Tell whether a number stands in a formula, not in a date or the number of a section."""
    before = text[max(match.start() - 12, 0) : match.start()].rstrip()
    if re.match(r"\s*(?:[-+−*/·×=≈<>≤≥]|\\(?:cdot|times|approx))", text[match.end() : match.end() + 12]):
        return True
    return bool(before) and (
        before[-1] in "=≈<>≤≥+-−*/·×({^" or before.endswith(("cdot", "times", "approx"))
    )


def _note(notes: list[str], what: str, changes: dict[int, tuple[int, str]], text: str) -> None:
    if changes:
        start, (end, written) = next(iter(changes.items()))
        count = f"{len(changes)} {'number' if len(changes) == 1 else 'numbers'}"
        notes.append(f"{what}: {text[start:end]} is read as {written} ({count})")


def _scanned(
    text: str, is_letter: Callable[[str, int], bool], notes: list[str]
) -> dict[int, tuple[int, str]]:
    """Return the numbers in which a scanner wrote the letter O for a zero."""
    changes: dict[int, tuple[int, str]] = {}
    for match in _SCANNED_ONE.finditer(text):
        if not is_letter("l", text.count("\n", 0, match.start()) + 1):
            changes[match.start()] = (match.start() + 1, "1")
    if changes:
        notes.append(f"the letter l for a one ({len(changes)}×)")
    ones = len(changes)
    if _SCANNED.search(text) and any("O" in m.group() for m in _SCANNED.finditer(text)):
        for match in _LONE_ZERO.finditer(text):
            if not is_letter("O", text.count("\n", 0, match.start()) + 1):
                changes[match.start()] = (match.end(), "0")
    for match in _SCANNED.finditer(text):
        if "O" not in match.group() or is_letter("O", text.count("\n", 0, match.start()) + 1):
            continue
        changes[match.start()] = (match.end(), match.group().replace("O", "0"))
    _note(notes, "the letter O for a zero", dict(list(changes.items())[ones:]), text)
    return changes


def _units_in_words(text: str) -> dict[int, tuple[int, str]]:
    """Return the units written out, 40 millimetres, or behind a formula, $r = 40$ mm, in their signs."""
    changes: dict[int, tuple[int, str]] = {}
    for match in _SPELLED_UNIT.finditer(text):
        unit, dollars = _sign_spelled(match), match[1] + match[2]
        end = match.end()
        if "\n" in match.group():  # the unit stands where its number does
            end = match.start() + match.group().index("\n")
            changes[end + 1] = (match.end(), "")
        changes[match.start()] = (end, _unit_sign(unit, bool(dollars)) + dollars)
    for match in _SET_UNIT.finditer(text):
        changes[match.start()] = (match.end(), _unit_sign(_sign_spelled(match), True) + match["behind"])
    for match in _BEHIND_DOLLAR.finditer(text):
        unit, length = sure_unit_behind(text, match)
        if not unit:
            unit, length = _unit_behind(match["unit"], text[match.end() :][:1])
        if unit and _closes(text, match.start(), match["mark"]):
            end = match.start("unit") + length
            changes[match.start()] = (end, _unit_sign(unit, True) + match["mark"])
    return changes


def _unit_behind(words: str, after: str) -> tuple[str, int]:
    """Return the longest beginning of some words that is a unit, and its length; "" and 0 for none."""
    ends = [m.start() for m in re.finditer(r" |\\,|~", words)]
    for end in [len(words), *reversed(ends)]:
        unit = _SPACE_IN_UNIT.sub(" ", words[:end]).replace("$", "")
        is_inch = unit == "in" and end == len(words) and after == "."  # in, at a sentence's end
        if unit in ("°", "%", "\\%") or is_inch:
            return unit, end
        if scale_of(unit) is not None and not _ENDS_IN_WORD.search(unit):
            return unit, end
    return "", 0


_ENDS_IN_WORD = re.compile(r"(?<!lb)(?<!lbf)(?<!oz)(?<!ft) in$| (?:min|a|d|l|L|t)$|(?<!W) h$")
"""A word of the sentence that is spelled like a unit: 90 mm in both engines, 9 mm min., 3 N a piece."""
_SPACE_IN_UNIT = re.compile(r"\\,|~")


def unit_in_words(text: str) -> str:
    """Return the unit that a text begins with, spelled or as its sign, "" for none.

    >>> unit_in_words("inches, the speed"), unit_in_words("mm eingesetzt"), unit_in_words("motion")
    ('inch', 'mm', '')
    """
    for sign, spelled in _SPELLED:
        if re.match(rf"(?:{spelled})(?![A-Za-z])", text, re.IGNORECASE):
            return sign
    word = re.match(r"[A-Za-zµ]+(?:/[A-Za-z]+[²³]?)?", text)
    return word.group() if word and scale_of(word.group()) is not None else ""


@lru_cache(maxsize=1000)
def sign_of_unit(words: str) -> str:
    """Return the sign of a unit that is written out or abbreviated, "" for what is no unit.

    >>> sign_of_unit("in.-lb"), sign_of_unit("N m"), sign_of_unit("inches"), sign_of_unit("a lever")
    ('lbf·inch', 'N m', 'inch', '')
    >>> sign_of_unit("lb in"), sign_of_unit("in^2")
    ('lbf·inch', 'inch^2')
    """
    for sign, spelled in _SPELLED:
        if re.fullmatch(spelled, words, re.IGNORECASE):
            return sign
    if words.rstrip(".") == "in":
        return "inch"
    if compound := compound_unit(words) or unit_with_inches(words):
        return compound
    return words if scale_of(words) is not None else ""


def _unit_sign(unit: str, in_latex: bool) -> str:
    unit = "inch" if unit == "in" else unit
    if unit in ("°", "%", "\\%"):
        unit = unit.removeprefix("\\")
        return {"°": "°", "%": "\\%" if in_latex else "%"}[unit]
    return f"\\,\\mathrm{{{unit}}}" if in_latex else f" {unit}"


def _closes(text: str, place: int, mark: str) -> bool:
    """Tell whether the mark at a place closes mathematics of its line, which holds a relation."""
    line = text[max(place - _AROUND, 0) : place].rpartition("\n")[2]
    opened = _OPENED[mark].search(line)
    is_open = mark != "$" or line.count("$") % 2 == 1
    return is_open and opened is not None and RELATION.search(opened.group()) is not None


def _dashes(text: str, notes: list[str]) -> dict[int, tuple[int, str]]:
    """Return the long dashes that are minus signs: between operands, nothing but a formula after them."""
    changes: dict[int, tuple[int, str]] = {}
    for match in _DASH.finditer(text):
        before = text[max(match.start() - _AROUND, 0) : match.start()].rpartition("\n")[2]
        after = text[match.end() : match.end() + _AROUND].partition("\n")[0]
        if _is_minus(before, after):
            changes[match.start()] = (match.end(), "-")
    if changes:
        notes.append(f"a long dash is read as a minus sign ({len(changes)}×)")
    return changes


def _end_of_bracket(text: str) -> int:
    """Return where the bracket closes that was open before a text, else its end."""
    depth = 0
    for place, sign in enumerate(text):
        depth += {"(": 1, ")": -1}.get(sign, 0)
        if depth < 0:
            return place
    return len(text)


def _is_minus(before: str, after: str) -> bool:
    goes_on = re.split(r"[;,.:。、](?:\s|$)|\$|\\\)|\\\]|[—―‒]", after, maxsplit=1)[0].strip()
    if not goes_on or not (_OPERAND_AFTER.match(goes_on) or goes_on[0] in NAME_OF_SIGN):
        return False
    if re.search(r"(?:[=≈<>(\[·×/]|\\cdot|\\approx)$", before.rstrip()):
        return not _WORD.match(goes_on) or _FUNCTION.match(goes_on) is not None  # cos 120° = — ½
    is_range = before[-1:].isdecimal() and after[:1].isdecimal()  # 10—20
    return (
        _OPERAND_BEFORE.search(before.rstrip()) is not None and not is_range and _parts(before, goes_on)
    )


def _parts(before: str, goes_on: str) -> bool:
    """Tell whether a dash between two operands parts terms, not clauses."""
    is_open = before.count("(") > before.count(")")
    goes_on = goes_on[: _end_of_bracket(goes_on)] if is_open else goes_on
    is_formula = is_open or RELATION.search(before) is not None or "\\" in before or "&" in before
    is_formula = is_formula or before.count("$") % 2 == 1
    relation = RELATION.search(goes_on)
    words_behind = _WORD.findall(goes_on[: relation.start() if relation else None])
    if any(word not in FUNCTION_WORDS for word in words_behind):
        return False
    if is_open or relation is None:
        return is_formula
    begun = re.split(r"(?<![\\A-Za-z])[A-Za-z]{2,}(?!\s*\()", _FUNCTION.sub(" ", before))[-1]
    return RELATION.search(begun) is None or not _WORD.search(_FUNCTION.sub(" ", before))
