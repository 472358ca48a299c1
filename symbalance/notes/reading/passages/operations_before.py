"""Operations that words before a formula begin: the sine of 30° = 0.5, the sum of 2 and 3 = 5.

The formula is their last operand alone, so the relation is not whole without the words. Words that only
name it stay apart: the sum of the forces F = 3 N, a ratio of λ = 0.25.
"""

from __future__ import annotations

from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.signs import RELATION
from symbalance.text import lazy_patterns as re

_OF = r"(?:of|from|between|aus|von|vom|zwischen|der|des|de|del|du|entre|di)"
_ONE = (
    r"(?:co)?sine|(?:co)?tangent|logarithm|exponential|root|square|cube|reciprocal|inverse|factorial"
    r"|absolute\s+value|Sinus|[KC]osinus|Tangens|Logarithmus|[^\W\d_]{0,12}[Ww]urzel|Quadrat|Kehrwert|Betrag"
    r"|Fakultät|cosinus|tangente|logarithme|racine(?:\s+carrée)?|carré|seno|coseno|logaritmo|raíz(?:\s+cuadrada)?"
)
_OPERATION_OF_ONE = re.compile(rf"(?<![^\W\d_])(?P<what>{_ONE})\s+{_OF}$", re.IGNORECASE)
_MANY = (
    r"sum|difference|product|quotient|ratio|mean|average|maximum|minimum|larger|greater|smaller|remainder"
    r"|Summe|Differenz|Produkt|Quotienten?|Verhältnis|[^\W\d_]{0,12}Mittel|[^\W\d_]{0,12}Mittelwert|Durchschnitt"
    r"|Rest|somme|différence|produit|rapport|moyenne|suma|diferencia|producto|cociente|promedio"
)
_OPERAND = (
    r"(?:\$[^$\n=<>≈≤≥]{1,60}\$|[-−]?[0-9][0-9.,]*(?:[ ]?[A-Za-zµ°%/²³·]{1,8})?"
    r"|[^\W\d_](?:_\{?\w{1,4}\}?|[₀-₉]{1,2}|[0-9]{1,2})?)"
)
_AND = (
    r"(?:\s?,(?:\s(?:and|und|or|oder))?"
    r"|\s(?:and|und|et|y|e|to|zu|by|durch|par|por|from|mit|with|von|&))\s"
)
_OPERATION_OF_MANY = re.compile(
    rf"(?<![^\W\d_])(?P<what>{_MANY})\s{_OF}\s(?:{_OPERAND}{_AND}){{1,6}}$", re.IGNORECASE
)
_POWER = re.compile(
    r"(?:^|[\s(=])(?:[-−]?[0-9][0-9.,]*|[^\W\d_]|\$[^$\n=<>]{1,60}\$|[^\s()]{0,20}\))\s"
    r"(?P<what>hoch|raised\s+to(?:\s+the\s+power(?:\s+of)?)?|to\s+the\s+power(?:\s+of)?|puissance|elevado\s+a)$",
    re.IGNORECASE,
)
_COUNT = (
    r"(?:[2-9]|[1-9][0-9]|two|three|four|five|six|eight|ten|twelve|zwei|drei|vier|fünf|sechs|acht|zehn|deux|trois"
    r"|quatre|cinq|huit|dos|tres|cuatro|seis|ocho)"
)
_SEVERAL = re.compile(
    rf"(?<![\w.,/])(?P<what>{_COUNT}\s[^\W\d_]{{3,20}}(?:\s[^\W\d_]{{3,20}})?\s(?:at|of|with|zu|von|mit|à|de)(?:\s+je)?)$",
    re.IGNORECASE,
)
_TENDING = re.compile(r"(?:^|[^\w=<>≈\\])(?P<what>[^\W\d_](?:_\w{1,3})?\s?(?:→|->|\\to))$")
_TARGET_FIRST = re.compile(r"[-−+]?(?:[0-9][0-9.,]*|∞|π)\s?[^\W\d_\\(]")
_LETTER_ALONE = re.compile(r"\$?\\?[^\W\d_]+(?:_\{?\w{1,5}\}?|[₀-₉]{1,2})?\s*")
_QUANTITY = re.compile(
    r"\$?[-−]?[0-9][0-9.,{}]*\s?(?:\\[,; ]|\\mathrm\{|\$)*\s?(?!rpm|min|Hz|U/|r/|rev|rad|deg)[^\W\d_]"
)
"""A quantity that each of several may have; a speed or an angle is that of all."""

_LETTER = re.compile(r"[^\W\d_]")
_OPERATION = re.compile(r"[-+−*/·×^]|\\[dt]?frac")
_EACH = re.compile(r"^[ ]?[^.;]{0,20}\b(?:each|apiece|je|jeweils|chacun|cada)\b")
_BEHIND = 30
"""Characters behind a relation in which words may say that it is of each."""


def doubt_of_operation(text: str, start: int, end: int, before: str) -> ReadingError | None:
    """Return why an equation in prose is the last operand of an operation in the words `before` it.

    >>> line = "the sum of 200 N and 300 N = 300 N"
    >>> print(doubt_of_operation(line, 21, len(line), line[:20]))
    at character 22: a formula that begins in words: sum; write the relation in signs
    >>> doubt_of_operation("the sum of the forces F = 3 N", 22, 29, "the sum of the forces")
    """
    relation = RELATION.search(text, start, end)
    if relation is None:
        return None
    side, result = text[start : relation.start()].strip(), text[relation.end() : end]
    names_angle = _LETTER.search(side) is not None and "°" in result
    is_named = names_angle or _LETTER_ALONE.fullmatch(side) is not None  # the sine of 2θ = 60°
    is_restated = before.endswith(",") and _OPERATION.search(side) is not None  # of s to d, s/d = 0.9
    is_of_each = _EACH.search(text[end : end + _BEHIND].partition("\n")[0]) is not None
    if match := (not is_named and _OPERATION_OF_ONE.search(before)) or None:
        what = match.group()
    elif match := (not is_restated and _OPERATION_OF_MANY.search(f"{before} ")) or _POWER.search(before):
        what = match["what"]
    elif (match := not is_of_each and _SEVERAL.search(before)) and _QUANTITY.match(side):
        return ReadingError(start, f"one or all of several: {match['what']}", "write how often in signs")
    elif (match := _TENDING.search(before)) and _TARGET_FIRST.match(side):
        what = f"the limit {match['what']}"
    else:
        return None
    return ReadingError(start, f"a formula that begins in words: {what}", "write the relation in signs")
