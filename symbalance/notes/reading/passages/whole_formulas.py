"""Whether a formula in prose is read whole: what stands right before or behind it may belong to it.

"1 - 2 sin² t plus 3" ends in words that go on with it, "λ foo α" in a function that nobody knows, and
"half of m = 3" begins in words. Such a relation is not judged in part; it is unreadable, with the reason.
"""

from __future__ import annotations

from symbalance.document.letters import FUNCTION_WORDS, GREEK_SIGN, NAME_OF_SIGN
from symbalance.document.wordlists import word_set, words
from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.formulas.lexer import Vocabulary
from symbalance.notes.reading.passages.operations_before import doubt_of_operation
from symbalance.notes.reading.passages.words_behind_numbers import says_multiple_of
from symbalance.notes.reading.sources import CELL_END
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

MARGIN = 200
"""Characters of the line around a formula that are looked at."""
JOINING = re.compile(
    r"(?:(?:plus|minus|times(?!\s+(?:per|a|an|each|every|in|as)\b)|divided|multiplied|mal(?!\s+(?:pro|je)\b)|geteilt|fois|por|moins|squared|cubed"
    r"|percent|prozent|thousand|million|hundred|half|twice|tausend|hundert)\b"
    r"|(?:over|durch|less|weniger)\s+(?:[0-9$\\(√]|(?![aAI]\b)[^\W_]\b)|and\s+so\s+[-+−*×·/^])",
    re.IGNORECASE,
)
"""Words that go on with a formula; over one turn, and so θ = 77° do not."""
_WRITE_WHOLE = "write it whole, between dollars"
_UNKNOWN_UNIT = re.compile(
    r"(?<=[0-9])\s?(?:°C|°F|dB|oz|slugs?|cps|HP|CV|ch|kcal|cal|dyn|erg|t|[kM]?V|mA|kWh|l|L|cl|ml)"
    r"(?![\w(^])(?=[\s.,;)]|$)"
    r"|(?<=[0-9]\$)[ ~]?(?:t[ ·]?m|tf|Mp|[tdlLVAΩTFHC]|[kMmnµμ][VAΩTFHC]|[km]?(?:Vs|Ah|VA)"
    r"|As(?=[.,;)]|$))(?![\w(^])(?=[\s.,;)]|$)"
)
_UNIT_LEFT_OUT = re.compile(r"(?<=[0-9])[ ~](?P<unit>[A-Za-z]{2,5})(?=[\s.,;:)]|$)")
_WORDS_LIKE_UNITS = word_set("in as at us per deg min cd do it be an")
"""A known unit right behind a number that was taken for words, 11 bar where a, b and r are letters."""
_PART_OF = re.compile(r"(?:of|von|de)\b", re.IGNORECASE)
_JOINED_BEFORE = re.compile(
    r"(?:(?<=[0-9%)½¼¾²³}$])\s*(?:of|von|de)|\b(?:twice|(?:half|halves|quarters?"
    r"|(?:thir|four|fif|six|seven|eigh|nin|ten)(?:d|th)s?|per ?cent|squared?|cube|root|reciprocal) of"
    r"|(?:[^\W\d_]{2,8}tel|Prozent|Hälfte|Quadrat|Kehrwert) von)"
    r"|(?:\b|\s)(?:plus|minus|times|mal|divided by|multiplied by|geteilt durch)"
    r"|(?:[0-9$)}\]²³%]|(?<![^\W_])d?[^\W_])\s+(?:over|durch|über))$",
    re.IGNORECASE,
)
_BOUNDS_BEFORE = re.compile(r"\b(?:from|von|de)\s+\S{1,12}\s+(?:to|bis|à)$", re.IGNORECASE)
_CHANGE_BEFORE = re.compile(
    r"\b(?:up|down|rises?|rose|falls?|fell|drops?|dropped|grows?|grew|sinks?|sank|increases?"
    r"|increased|decreases?|decreased|reduces?|reduced|lowers?|lowered|raised?|raises|changes?|changed|halved|doubled"
    r"|shrinks?|shrank|steigt|sinkt|fällt|wächst|verringert|erhöht|reduziert|monte|baisse|tombe)"
    r"(?:\s+(?!over|sum)[^\W\d_]+){0,2}\s+(?:from|von|de)\s+\S{1,12}\s+(?:to|bis|à)$",
    re.IGNORECASE,
)
"""A change between two values, the second of which begins a relation: down from 2 to √2 ≈ 1.41."""
OPERATION = re.compile(r"[+\-−–*×·⋅∙/÷^±∓!]|\\(?:cdot|times|div|pm|mp|over)(?![A-Za-z])|\*\*")


_PLUS_A_THING = re.compile(
    r"(?:plus|and\s+also|zuzüglich|más|più|mais)\s+(?:the|an?|its|that|those|de[rnm]|die|das|l[ea]|les|une?|il|lo|gli|el|los|las|os?)"
    r"\s+[^\W\d_]{4,}",
    re.IGNORECASE,
)
"""What a sentence adds to a result: the mass m = 4.5 kg plus the centrifugal force of the pin."""
_NUMBER_LAST = re.compile(
    r"[=≈]\s*[-−]?[0-9][0-9.,]*[$\]\s]*(?:\\[,;: ])?\s*"
    r"(?:\\(?:mathrm|text)\s*\{[^{}]{1,16}\}\S{0,5}|[^\W\d_]{0,4}[²³]?)[$\]\s]*$"
)


def cut_error(place: int, rest: str) -> ReadingError:
    """Return the failure of a formula that goes on with the words at a place."""
    words_left = " ".join(rest.split())
    shown = words_left if len(words_left) <= 30 else words_left[:29] + "…"
    return ReadingError(
        place, f"a formula that goes on in words: {shown}", "write it in signs, or end it"
    )


def doubt_around(text: str, start: int, end: int, words: Vocabulary) -> ReadingError | None:
    """Return why an equation in prose is not whole: what stands right before or behind it belongs to it.

    >>> from symbalance.notes.reading.formulas.lexer import vocabulary
    >>> text = "cos 2t = 1 - 2 sin^2 t plus 3"
    >>> print(doubt_around(text, 0, 22, vocabulary({"t"})))
    at character 24: a formula that goes on in words: plus 3; write it in signs, or end it
    """
    if _is_cut_from(text, start - 1) and not text[start].isspace():
        return ReadingError(start, "a formula that begins before what is read", _WRITE_WHOLE)
    is_pointed = re.match(r"\.[a-z0-9α-ω\\(]", text[end : end + 2]) is not None
    if (is_pointed or _is_cut_from(text, end)) and not text[end - 1].isspace():
        return ReadingError(end, "a formula that goes on behind what is read", _WRITE_WHOLE)
    line_end = text.find("\n", end)
    stop = min(line_end if line_end >= 0 else len(text), end + MARGIN)
    after = text[end:stop].partition(CELL_END)[0]
    behind = after.lstrip(" \t~)")
    place = end + len(after) - len(behind)
    if unit := _UNKNOWN_UNIT.match(text, end, stop):
        what = f"a unit that is not known: {unit.group().strip()}"
        return ReadingError(end, what, "give the value in SI units")
    unit = _UNIT_LEFT_OUT.match(text, end, stop)
    if unit and unit["unit"] not in _WORDS_LIKE_UNITS and scale_of(unit["unit"]) is not None:
        what = f"{unit['unit']}, a unit or letters"
        return ReadingError(unit.start("unit"), what, "write the unit upright, or the letters apart")
    is_of_thing = _PLUS_A_THING.match(behind) and _NUMBER_LAST.search(text, start, end)
    if is_of_thing or says_multiple_of(text, start, end, behind):
        behind = ""
    goes_on = _goes_on(behind, after, words) or _applies_a_word(text, start, behind)
    if goes_on or (text[end - 1 : end] == "%" and _PART_OF.match(behind)):
        return cut_error(place, behind)
    line_begin = text.rfind("\n", 0, start) + 1
    before = text[max(line_begin, start - MARGIN) : start].rpartition(CELL_END)[2].rstrip()
    return (
        _doubt_of_place(text, start, end, before)
        or _doubt_before(start, before)
        or doubt_of_operation(text, start, end, before)
    )


_NUMBER_FIRST = re.compile(r"[0-9][0-9.,]*[ ]?(?:°|deg\b)?[ ]?=")
_PLACE_BEFORE = re.compile(r"[^\W\d_]{2,}[ ](?:at|for|bei|für|à|pour)$")


def _doubt_of_place(text: str, start: int, end: int, before: str) -> ReadingError | None:
    """Return why "drop at 90 = 7.5 - 5.8" gives no number another value: the words are its side."""
    if _NUMBER_FIRST.match(text, start, end) is None or _PLACE_BEFORE.search(before) is None:
        return None
    what = f"a formula that begins in words: {before.rpartition(' ')[2]}"
    return ReadingError(start, what, "write a letter for what has the value")


def _doubt_before(start: int, before: str) -> ReadingError | None:
    """Return why an equation in prose begins with what stands before it."""
    operation = re.search(r"([\w)\]}²³])\s*([+*×·/^÷−])$", before)
    operation = operation or re.search(r"((?<!\w)\w|[0-9)²³])\s+([—–])$", before)
    if operation:
        word = re.search(r"\w+$", before[: operation.start(2)].rstrip())
        what = f"a formula that begins in words: {word.group() if word else ''} {operation[2]}"
        return ReadingError(start, what, "declare the word, or write the relation in signs")
    joined = _JOINED_BEFORE.search(before)
    joined = joined or (not _CHANGE_BEFORE.search(before) and _BOUNDS_BEFORE.search(before)) or None
    if joined:
        what = f"a formula that begins in words: {joined.group()}"
        return ReadingError(start, what, "write the relation in signs")
    return None


def _is_cut_from(text: str, place: int) -> bool:
    """Tell whether a letter or digit, or a bracket that goes with one, stands at a place."""
    sign = text[place : place + 1] if place >= 0 else ""
    if sign in (")", "]"):
        place, sign = place + 1, text[place + 1 : place + 2]
        return sign in ("(", "[") or (sign.isascii() and sign.isalnum())
    return sign.isascii() and sign.isalnum()


def _goes_on(behind: str, after: str, words: Vocabulary) -> bool:
    """Tell whether what stands behind an equation in prose goes on with it."""
    if not behind:
        return False
    if after[:1] == "," and after[1:2].isdecimal():
        return True
    if JOINING.match(behind) or _UNKNOWN_FUNCTION.match(behind) or _goes_on_in_factors(after):
        return True
    operation = re.match(
        r"(?:[A-Za-z]{2,8}\s+){0,3}?([+*×·/÷^±∓]|[−—–-](?=\s*[0-9(\\]|\s[A-Za-z]\b))\s*", behind
    )
    if operation is None or _OPENS_CASE.match(behind):
        return False
    operand = behind[operation.end() :]
    word = re.match(r"[A-Za-z]+", operand)
    if word is None:
        return (
            operand[:1].isdecimal() or operand[:1] in ("(", "\\", "√", "$") or operand[:1] in NAME_OF_SIGN
        )
    return (len(word.group()) == 1 and word.group() not in "aAI") or word.group() in words.names


_UNKNOWN_FACTOR = re.compile(
    r"[ ](?P<word>(?!(?:is|ist|est|are|sind)\b)[a-z]{2,8})[ ]"
    r"(?P<factors>[^\n=≈<>.,;:$\\]{3,120})[.,;]?\s*$"
)
_POWER_OR_FUNCTION = re.compile(rf"[\w)][ ]?[\^²³]|(?:{'|'.join(sorted(FUNCTION_WORDS))})[²³]?[ ]?\(")


def _goes_on_in_factors(after: str) -> bool:
    """Tell whether a word that is no letter stands among factors, with a power or a function in them.

    >>> _goes_on_in_factors(" foo m r w^2 sin(2 x)"), _goes_on_in_factors(" for r w^2 sin(2 x) small")
    (True, False)
    """
    match = _UNKNOWN_FACTOR.match(after)
    if match is None or match["word"] in _CONNECTING or scale_of(match["word"]) is not None:
        return False
    runs = re.findall(r"[^\W\d_]{2,}", match["factors"])
    are_factors = all(run in FUNCTION_WORDS or run in GREEK_SIGN for run in runs)
    return are_factors and _POWER_OR_FUNCTION.search(match["factors"]) is not None


_UNKNOWN_FUNCTION = re.compile(
    r"[A-Za-z]{2,8}(?:[²³⁴]|\^[0-9])\s?(?:[0-9]*[α-ω]|[A-Za-z](?![A-Za-z])|\()"
    r"|[A-Za-z]{2,8}\([0-9]*[ ]?[α-ω]"
    r"|[\[(][ ]?[A-Za-z]{2,8}[ ]?[0-9]*[ ]?(?:[α-ω]|\()[^\[\]()\n]{0,60}[-+−·*/]"
)
"""A word that stands like a function which is not known: foo² α, foo(α), [foo α + b]."""
_WORD_BEFORE_ANGLE = re.compile(r"(?P<word>[a-z]{2,5}) [0-9]{0,2}[α-ω](?![a-z])[ ,.;]*(?:\(\d+\))?[ ]*$")
_CONNECTING = words(
    "for at with when if where and or in of by from to is as than over per the all any about near small"
    " large gives angle crank bei für mit wenn falls wo und oder von vom am im um je das der die"
    " pro pour si où et ou avec de du en par la le les el los il lo para con donde y o se dove di del per"
    " su voor met als op van een het dla przy gdy gdzie lub od do för vid och där när med av při kde když"
)


def _applies_a_word(text: str, start: int, behind: str) -> bool:
    """Tell whether a line that holds nothing but a formula ends in a word and an angle: β = λ foo α."""
    match = _WORD_BEFORE_ANGLE.fullmatch(behind)
    line = text[text.rfind("\n", 0, start) + 1 : start]
    return match is not None and not line.strip() and match["word"] not in _CONNECTING


_OPENS_CASE = re.compile(
    r"(?:for|when|if|where|at|with|als|für|wenn|wo|bei|mit|falls|pour|si|où)\s+[-−–+±]", re.IGNORECASE
)
"""Words between a relation and the case it is said for, and no sum: for -a < z < a."""
