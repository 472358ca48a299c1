"""Formulas that the lines of a paragraph cut in two: "T = 4.69 ×" ends one, "0.873" begins the next.

The end of such a line becomes a space that still counts as the end of a line: every place in the text
stays, and so does the number of each line.
"""

from __future__ import annotations

from collections.abc import Sequence

from symbalance.document.letters import FUNCTION_WORDS
from symbalance.notes.reading.markup.marked_formulas import is_inside, marked_formulas
from symbalance.notes.reading.rewriting import Span
from symbalance.notes.reading.signs import RELATION
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

SOFT_END = "\u205f"
"""Stands for the end of a line within a formula. (A rare space; where it is typed, it is a plain one.)"""
ENDS = f"\n{SOFT_END}"
_WINDOW = 80
_SCRIPT = r"²³⁰¹⁴⁵⁶⁷⁸⁹₀-₉"
_OPERAND_LAST = (
    rf"(?:[0-9)\]}}°%½¼¾{_SCRIPT}α-ωϕϑπ'′]|(?<![^\W_])[A-Za-z]|_\{{?\w{{1,6}}\}}?"
    r"|[0-9][ ]?[A-Za-z/·]{1,5}[²³]?)"
)
_FUNCTION = r"(?:sin|cos|tan|cot|sqrt|exp|ln)"
_OPEN_END = re.compile(
    rf"(?:{_OPERAND_LAST}(?:[ ]?[=≈≤≥×·⋅+−/(]|[ ][-–*<>]|(?<=[0-9)])\*)|[=≈+−×·⋅*/(][ ]?\("
    rf"|(?<![A-Za-z]){_FUNCTION}[²³]?)[ \t]*$"
)
_OPERAND_FIRST = re.compile(
    rf"[ \t]*(?![0-9]{{1,3}}[.)][ \t])(?![aAI][ ][^\W\d_]{{2}})"
    rf"(?:[-−][ ]?)?(?:[0-9(√Σ∑∫½¼¾α-ωϕϑΩΔ]|\.[0-9]|{_FUNCTION}(?![A-Za-z])|[A-Za-z](?![^\W\d_])|\|)"
)
_OPERAND_ENDS = re.compile(rf"{_OPERAND_LAST}[ \t]*$")
_OPERATOR_FIRST = re.compile(
    r"[ \t]*(?P<sign>[+·×⋅−/-])[ ]?(?=[0-9(√α-ωϕ½¼¾]|[A-Za-z](?![^\W\d_])|" + _FUNCTION + ")"
)
_FUNCTION_FIRST = re.compile(rf"[ \t]*{_FUNCTION}(?![A-Za-z])")
_BEGUN = re.compile(r"[=≈≤≥+×·⋅−(]|[0-9) ]/")
"""What a line has that ends within a formula."""
_WORD = re.compile(r"(?<![^\W_])(?<!\\)[A-Za-zÀ-ÖØ-öø-ÿ\u3040-\u30ff\u4e00-\u9fff]{3,}")
_TABLE_OR_HEADING = re.compile(r"[ \t]*[|#]")
_BULLET = re.compile(r"[ \t]*(?:[|#>]|[-*+•][ ]|[0-9]{1,2}[.)][ ])")
_UNIT_FIRST = re.compile(
    r"[ \t]*(?P<unit>[A-Za-zµ]{1,4}(?:[/·][A-Za-z]{1,3})?[²³]?)(?![^\W_])(?P<behind>[.,;)]|[ ]|$)"
)
_VALUE_LAST = re.compile(r"[=≈][ ]?[-−]?[0-9][0-9.,]*(?<=[0-9])(?:[ ]?[×·][ ]?10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?[ \t]*$")
_NO_UNITS = frozenset(("in", "min", "to", "hp"))
"""Words that a line may begin with; so it may with a letter."""


def with_soft_ends(text: str, spans: Sequence[Span] = (), *, has_bullets: bool = False) -> str:
    r"""Return a text of the same length in which such ends of lines are soft; `spans` stay as they are.

    A line that is a formula as a whole is left to the reader. Where a text `has_bullets`, + is one.

    >>> with_soft_ends("The torque is T = 4 ×\n3 = 12.").count(SOFT_END), with_soft_ends("x = 4 ×\n3")
    (1, 'x = 4 ×\n3')
    """
    inside = sorted([*spans, *marked_formulas(text)])
    places: list[int] = []
    start, is_prose = 0, False
    for end in (match.start() for match in re.finditer("\n", text)):
        line = text[start:end]
        is_prose = _has_words(line) or (is_prose and bool(places) and places[-1] == start - 1)
        stop = text.find("\n", end + 1)
        below = text[end + 1 : stop if stop >= 0 else len(text)]
        is_cut = (
            (is_prose or _has_words(below)) and below.strip() and _TABLE_OR_HEADING.match(line) is None
        )
        if is_cut and _goes_on(line, below, has_bullets) and not is_inside(end, inside):
            places.append(end)
        start = end + 1
    signs = list(text)
    for place in places:
        signs[place] = SOFT_END
    return "".join(signs) if places else text


def _has_words(line: str) -> bool:
    """Tell whether a line holds prose, and is no formula as a whole."""
    return any(word.lower() not in FUNCTION_WORDS for word in _WORD.findall(line))


def _goes_on(line: str, below: str, has_bullets: bool) -> bool:
    """Tell whether a line ends within a formula that goes on in the line below."""
    last = line[-_WINDOW:]
    if _OPEN_END.search(last):
        return _OPERAND_FIRST.match(below) is not None and _BULLET.match(below) is None
    if _OPERAND_ENDS.search(last) is None:
        return False
    begun = last[_last_word_end(last) :]
    is_open = begun.count("(") > begun.count(")")
    if operator := _OPERATOR_FIRST.match(below):
        may_be_bullet = operator["sign"] == "-" or (has_bullets and operator["sign"] == "+")
        return _BEGUN.search(begun) is not None and (is_open or not may_be_bullet)
    if _FUNCTION_FIRST.match(below):
        rest = re.split(r"[,;:]|\.(?:\s|$)", below, maxsplit=1)[0]
        return RELATION.search(begun) is not None and RELATION.search(rest) is None
    unit = _UNIT_FIRST.match(below)
    if unit is None or _VALUE_LAST.search(last) is None or scale_of(unit["unit"]) is None:
        return False
    is_letter = len(unit["unit"]) == 1 or unit["unit"] in _NO_UNITS
    is_last = unit["behind"] in (".", ",", ";", ")")
    return is_last if is_letter else RELATION.match(below[unit.end() :].lstrip()) is None


def _last_word_end(line: str) -> int:
    """Return where the last word of prose ends, behind which the formula begins."""
    ends = [m.end() for m in _WORD.finditer(line) if m.group().lower() not in FUNCTION_WORDS]
    return ends[-1] if ends else 0
