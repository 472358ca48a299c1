"""Finding of mathematics within a line of prose: where it begins and ends."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass
from itertools import pairwise

from symbalance.document.letters import (
    ACCENTS,
    DOTTED,
    FONTS,
    FUNCTION_WORDS,
    GREEK_SIGN,
    LOWERED,
    NAME_OF_SIGN,
    RAISED,
    TIME_DOTS,
    WORDS,
)
from symbalance.document.wordlists import word_set
from symbalance.notes.reading import signs
from symbalance.notes.reading.formulas.lexer import Vocabulary
from symbalance.notes.reading.units import (
    are_letters_behind_number,
    follows_number,
    plain_unit_at,
    scale_of,
    unit_set_at,
)
from symbalance.text import lazy_patterns as re

_UNIT = r"(?P<unit>\[\s*[A-Za-zµμ]+[A-Za-z0-9^/²³⁻¹-]*\s*\])|"
_PLAIN_UNIT = re.compile(r"(?P<unit>.+)", re.DOTALL)
_BEHIND_NUMBER = frozenset("0123456789)]⁰¹²³⁴⁵⁶⁷⁸⁹π}") | frozenset(signs.VULGAR)
_ARGUED = "unit|si|mathrm|mathit|mathbf|operatorname|tag|label|mathsf|bm|boldsymbol"
_UMLAUTS = "ÄÖÜäöüßàáâãçèéêëíîñóôõøåæœú"
_PIECE = re.compile(
    rf"(?P<prose>\\(?:{'|'.join(sorted(WORDS, key=len, reverse=True))})\s*\{{[^{{}}]*\}})"
    r"|(?P<cells>\\begin\s*\{[pbvV]?matrix\}(?:(?!\\begin)[^\n]){1,400}?\\end\s*\{[pbvV]?matrix\})"
    rf"|(?P<argued>\\(?:{_ARGUED})\*?\s*\{{(?:[^{{}}]|\{{[^{{}}]{{0,20}}\}})*\}})"
    r"|(?P<command>\\[A-Za-z]+)|(?P<escape>\\.)"
    r"|(?P<abbreviation>(?<![\w\\])(?:i\. ?e|e\. ?g|d\. ?h|d\. ?i|z\. ?B|u\. ?a)\.(?!\w))"
    r"|(?P<script>_\{(?:[^{}]|\{[^{}]{0,40}\}){0,80}\}|_[A-Za-z0-9]+)|(?P<degrees>(?<=[0-9])\s?度)|"
    rf"{_UNIT}(?P<word>(?=[A-Za-z]*[{_UMLAUTS}][A-Za-z]|[A-Za-z]+[{_UMLAUTS}])[A-Za-z{_UMLAUTS}]+"
    r"|[A-Za-z]+(?:['’][a-z]+)?[0-9]*)|(?P<dots>・・・|･･･|\.\.\.)|(?P<other>.)",
    re.DOTALL,
)
_PIECE_BUT_UNITS = re.compile(_PIECE.pattern.replace(_UNIT, ""), re.DOTALL)
_SECONDS_BEFORE = re.compile(r"['′’][ ]?[0-5]?[0-9](?:[.,][0-9]{1,3})?$")
"""What the sign of seconds stands behind in 26° 33' 54"."""
_MATHEMATICAL = frozenset(
    "0123456789 \t\u205f()[]{}|^_,;'′″°√∛∜∂∞Σ∑.&~"
    + "".join(signs.OPERATOR_SIGNS) + "".join(signs.RELATION_SIGNS) + "".join(RAISED) + "".join(LOWERED)
    + "".join(signs.VULGAR) + "".join(NAME_OF_SIGN) + "".join(DOTTED) + "…⋯±∓∫∮∏⊤"
)  # fmt: skip
_COMMANDS = (
    frozenset(GREEK_SIGN) | frozenset(FUNCTION_WORDS) | frozenset(signs.RELATION_COMMANDS)
    | frozenset(signs.OPERATOR_COMMANDS) | signs.DOTS_COMMANDS | signs.SPACE_COMMANDS | signs.STRUCTURE
    | FONTS | frozenset(ACCENTS) | frozenset(TIME_DOTS) | frozenset(signs.REFUSED)
    | frozenset(signs.BRACKET_COMMANDS) | frozenset(signs.CONSTRUCTS) | frozenset(signs.OWN_FUNCTIONS)
    | {"tag", "label", "circ", "prime", "degree", "underbrace", "overbrace"}
)  # fmt: skip
_PLAIN_WORDS = word_set(
    "a an as at be by do go he if in is it me my no of on or so to up us we and are but can for had has"
    " her his how its may new not now off old one our out per she the too two use was way who why you"
    " rpm mm cm km kg kw hz vs via etc cost tank sink sing since sine tang logs sins cosy tans expo"
    " logo coth sech csch sect sind secs cots expr logi sinn stand stands instant instants"
    " constant constants distance distances standard standards tandem cosine cosines tangent tangents"
    " expand expands"
    " mit bei und von vom zum zur ist sei der die das den dem des ein aus auf wie bzw les est une par sur"
)
_CLAUSE_WORDS = word_set(
    "which that this these just about exactly quite very much well still only then there here what"
    " because also das die der den ein eine wie was und oder aber nicht nur noch etwa genau damit weil"
    " denn est ce qui et c soit que como es"
)
"""Words that begin a clause behind a dash: what a formula subtracts begins with none of them."""
_OWN_FUNCTION = re.compile(r"(?:lim|max|min|det|Re|Im|conj|lg)(?=\s*[_(])|lg(?=\s[0-9])")
_DERIVATIVE = re.compile(
    r"d[A-Za-z]?(?=[α-ωϕ]?/d[A-Za-zα-ωϕ](?![A-Za-z]))"
    r"|(?:(?<=d/)|(?<=d[A-Za-zα-ωϕ]/)|(?<=d[²³]/)|(?<=d[²³][A-Za-zα-ωϕ]/)|(?<=d\^[23]/)"
    r"|(?<=d\^[23][A-Za-zα-ωϕ]/))d[A-Za-z]?(?![A-Za-z])"
)
_DIFFERENTIAL = re.compile(r"d[a-zA-Z]")
_INTEGRAL = re.compile(r"[∫∮][^=≈<>≤≥\n]*$")
"""What stands before the dx of an integral in plain text."""
_LONGEST_INTEGRAL = 80
_LONGEST_FUNCTION = 20
LONGEST_PRODUCT = 3
"""Letters that are read as a product beside a Greek one, without being letters of the page."""
LONGEST_RUN = 2
"""Letters that are read as a product behind a function's bracket without being letters of the page."""
_GREEK = frozenset(sign for sign in NAME_OF_SIGN if "α" <= sign <= "ω" or sign == "ϕ")
_BEHIND_PRODUCT, _BEFORE_PRODUCT = _GREEK | {"²", "³"}, _GREEK | frozenset(signs.VULGAR)
_IN_FUNCTION = re.compile(r"(?<![A-Za-z])(?:sin|cos|tan|cot)\(\s*(?:[0-9.]+\s*\*?\s*)?\Z")
"""What stands before the letters of cos(wt) and sin(2wt), which are no word there."""
_LONG_WORD = re.compile(r"(?<![\\A-Za-z_])[A-Za-z]{4,}")
_ARTICLE_FIRST = re.compile(r"(a|I|A)\s+(?=[\w\\(])")
_DASH_LAST = re.compile(r"\s+[-–—−]\s*$")
_ENDS_OPEN = re.compile(
    rf"(?:{signs.RELATION.pattern}|[*·×/]|(?<![A-Za-z])(?:{'|'.join(FUNCTION_WORDS)})[²³]?)\s*$"
)
_ARTICLE_LAST = re.compile(r"\s(a|I|A)$")
_WORD_BEHIND = re.compile(
    r"[ \t~]*(?:\n[ \t]*)?"
    r"(?!(?:and|or|is|are|was|so|but|which|where|when|while|if|for|with|at|as|in|on|to|by|of|the|we|it|this|that"
    r"|per|then|thus|hence)(?![^\W\d_]))[A-Za-zÀ-ɏ]{2}"
)
"""What an article stands before, a Latin word: a is a letter in "F = m r a." and "F = m r a and"."""


@dataclass(frozen=True, slots=True)
class LineRules:
    """What decides about the words of a line: its letters, and how freely runs of them are taken.

    `longest` is how many single letters may stand side by side without being a word: in a line of
    English "mass" is no product, even of declared letters. `lenient` takes short unknown words too.
    """

    words: Vocabulary
    lenient: bool = False
    longest: int = 3

    def is_mathematical(self, word: str) -> bool:
        """Tell whether a run of letters is mathematics here; with an umlaut it is a word."""
        if len(word) > 1 and not word.isascii():
            return False
        if self.lenient:
            return len(word) <= 3 or is_letters(word, self.words, len(word))
        return is_letters(word, self.words, self.longest)


def line_rules(text: str, start: int, end: int, words: Vocabulary, lenient: bool) -> LineRules:
    """Return the rules for a line: stricter where it holds words written in these letters."""
    long_words = (match.group() for match in _LONG_WORD.finditer(text, start, end))
    english = not lenient and any(not is_letters(word, words, 3) for word in long_words)
    return LineRules(words, lenient, 2 if english else 3)


def segments(text: str, start: int, end: int, line: LineRules) -> list[tuple[int, int]]:
    """Return the stretches of a line without prose."""
    spans: list[tuple[int, int]] = []
    first = start
    for piece in _pieces(text, start, end, line):
        if _is_mathematical(piece, text, end, line):
            continue
        if text[first : piece.start()].strip():
            spans.append((first, piece.start()))
        first = piece.end()
    if text[first:end].strip():
        spans.append((first, end))
    return [(_after_speed(text, begin, stop) if begin > start else begin, stop) for begin, stop in spans]


_SPEED_FIRST = re.compile(
    r"\s*[0-9][0-9.,]*[ \u00a0\u2009\u202f]?(?P<unit>[A-Za-z/.]{3,6})\s+"
    r"(?=[^\W\d_]|[0-9][0-9.,]*[ ]?[*·×⋅∙])"
)


_QUANTITY_FIRST = re.compile(
    r"\s*[0-9][0-9.,]*[ \u00a0\u2009\u202f]?(?P<unit>°|1/min|1/s|[A-Za-z/.]{2,6}),?\s+"
    r"(?=[^\W\d][\w']{0,12}(?:\([^()=\n]{1,12}\))?\s*[=≈≒≃])"
)
_GIVES_CASE = re.compile(
    r"(?<![^\W\d_])(?:for|at|with|für|fuer|bei|mit|pour|à|avec|para|con|per|voor|bij|met)\s*$",
    re.IGNORECASE,
)
_NUMBERED = re.compile(
    r"(?<![^\W\d_])(?:cylinder|zylinder|cylindre|cilindro|cilinder|order|ordnung|ordre|orden|ordine|orde|harmonic|case|fall|cas"
    r"|caso|engine|motor|moteur|motore|mode|eigenform|throw|pin|bearing|lager|palier|station|section|journal|disc|disk|scheibe"
    r"|disque|piston|kolben|bank|reihe|row|number|no\.?|nr\.?|n°|test|versuch|essai|point|punkt|shaft|welle|arbre|variant"
    r"|variante|example|beispiel|exemple)[ ~]?$|(?:場合|ケース|例)[ ~]?$",
    re.IGNORECASE,
)
"""Words for things that are counted, whose number is no factor: cylinder 2."""
_LABEL_FIRST = re.compile(
    r"[ ~]?[0-9]{1,2}(?:[,:]?\s+(?=[^\W\d][\w']{0,12}(?:\([^()=\n]{1,12}\))?\s*[=≈≒≃])"
    r"|[.:]?\s*(?=\([^()\n]{0,30}[=≈<>≤≥≠][^()\n]{1,30}\)))"
)
"""Such a number before a letter that is set equal to something, or before a relation in brackets."""


def _after_speed(text: str, start: int, end: int) -> int:
    """Return where a formula begins behind words and the speed they end in: at 9000 rpm rω² = …

    Behind "for" and the like it is so with any quantity before a lone letter: for 72° δ = 36°. The number
    of a thing is no factor either: for cylinder 2 P = 300 N.
    """
    if (label := _LABEL_FIRST.match(text, start, end)) and _NUMBERED.search(
        text, max(0, start - 16), start
    ):
        return label.end()
    speed = _SPEED_FIRST.match(text, start, end)
    scale = scale_of(speed["unit"]) if speed else None
    if speed and scale is not None and scale[1]:
        return speed.end()
    given = _QUANTITY_FIRST.match(text, start, end)
    if given is None or (given["unit"] != "°" and scale_of(given["unit"]) is None):
        return start
    return given.end() if _GIVES_CASE.search(text, max(0, start - 12), start) else start


def _pieces(text: str, start: int, end: int, line: LineRules) -> Iterator[re.Match[str]]:
    """Yield the pieces of a line; what only looks like a unit is taken apart."""
    while piece := _plain_unit(text, start, end, line) or _PIECE.match(text, start, end):
        if piece.lastgroup == "unit" and not _is_unit(piece, text):
            piece = _PIECE_BUT_UNITS.match(text, start, end)
            assert piece
        yield piece
        start = piece.end()


def _plain_unit(text: str, start: int, end: int, line: LineRules) -> re.Match[str] | None:
    """Return the unit behind a number that begins at a place."""
    if not start or start >= end or text[start - 1] not in _BEHIND_NUMBER:
        return None
    unit = plain_unit_at(text, start, end, line.words.names)
    return _PLAIN_UNIT.match(text, start, unit[1]) if unit else None


def _is_unit(piece: re.Match[str], text: str) -> bool:
    """Tell whether what stands in square brackets is a unit."""
    if piece.group()[0] != "[":
        return True
    before = text[max(piece.start() - 2, 0) : piece.start()].rstrip()[-1:]
    if not before or not (before in ")]}" or (before.isascii() and before.isalnum())):
        return False
    return scale_of(piece.group()[1:-1]) is not None


def _is_mathematical(piece: re.Match[str], text: str, end: int, line: LineRules) -> bool:
    kind, sign = piece.lastgroup, piece.group()
    if kind == "word":
        is_run = len(sign) == LONGEST_RUN and sign not in _PLAIN_WORDS
        is_in_function = is_run and is_behind_function(text, piece.start())
        is_derivative = _DERIVATIVE.match(text, piece.start(), end) is not None
        if (
            _is_product(sign, text, *piece.span())
            or is_derivative
            or is_in_function
            or _is_differential(sign, text, piece.start())
        ):
            return True
        own = _OWN_FUNCTION.match(text, piece.start(), end)
        is_own = own is not None and own.group() == sign
        is_product = are_letters_behind_number(text, piece.start(), sign.rstrip("ωΩ"))
        return is_own or is_product or line.is_mathematical(sign)
    if kind == "command":
        return sign[1:] in _COMMANDS or line.lenient
    if kind == "other":
        return _is_mathematical_sign(sign, text, piece.start(), end)
    if kind == "prose":
        behind = follows_number(text, 0, piece.start())
        unit = unit_set_at(text, piece.start(), end) if behind else None
        return unit is not None and scale_of(unit[0]) is not None
    return kind != "abbreviation"


def _is_product(run: str, text: str, start: int, end: int) -> bool:
    """Tell whether a run of letters goes on as no word and no unit does: mrω², ωrm, ½mR²."""
    if not 1 < len(run) <= LONGEST_PRODUCT or run in _PLAIN_WORDS or scale_of(run) is not None:
        return False
    if len({*run}) < len(run):
        return False  # foo² is a function; of m m ω² one would have typed the square
    before, after = text[start - 1 : start], text[end : end + 1]
    return after in _BEHIND_PRODUCT or before in _BEFORE_PRODUCT


def _is_differential(sign: str, text: str, place: int) -> bool:
    """Tell whether a word is the dx of an integral, whose sign stands before it."""
    before = max(place - _LONGEST_INTEGRAL, 0)
    return bool(_DIFFERENTIAL.fullmatch(sign) and _INTEGRAL.search(text, before, place))


def is_behind_function(text: str, place: int) -> bool:
    """Tell whether nothing but a number stands between a function's bracket and a place: cos(2wt."""
    return _IN_FUNCTION.search(text, max(place - _LONGEST_FUNCTION, 0), place) is not None


def _is_mathematical_sign(sign: str, text: str, place: int, end: int) -> bool:
    if sign == ":":
        return text[place + 1 : place + 2] == "=" or _is_ratio(text, place)
    if sign in "!%":
        before = text[max(place - 2, 0) : place]
        before = before.rstrip() if sign == "%" else before
        return _is_operation(sign, before[-1:], text[place + 1 : min(place + 9, end)])
    if sign == '"':
        return _SECONDS_BEFORE.search(text, max(place - 12, 0), place) is not None
    if sign == ".":
        return place + 1 < end and text[place + 1].isdecimal()
    return sign in _MATHEMATICAL


def _is_ratio(text: str, place: int) -> bool:
    """Tell 12 : 4 and 12:4 from the colon behind a label, as in (3): 4·2 = 8."""
    before, after = text[max(place - 2, 0) : place], text[place + 1 : place + 3]
    is_even = before[-1:].isspace() == after[:1].isspace()
    return is_even and before.strip()[-1:].isdecimal() and after.strip()[:1].isdecimal()


def _is_operation(sign: str, before: str, after: str) -> bool:
    """Tell 50% and n! from a percent sign and an exclamation mark of the prose."""
    operand = before.isdecimal() if sign == "%" else before.isalnum()
    return (operand or before == ")") and (sign == "%" or not after.lstrip()[:1].isalpha())


def is_letters(word: str, words: Vocabulary, longest: int) -> bool:
    """Tell whether a run of letters is one letter, or declared letters and functions side by side."""
    if len(word) == 1 or word in words.names or word in FUNCTION_WORDS or word == "pi":
        return True
    if word.lower() in _PLAIN_WORDS or len(word) > 20:
        return False
    return word[1:].isdecimal() or _consists_of_letters(word, words, longest)


def _consists_of_letters(word: str, words: Vocabulary, longest: int) -> bool:
    place, unknown, whole = 0, 0, False
    while place < len(word):
        entry = words.longest(word, place, len(word))
        length = len(entry[1]) if entry else 0
        whole = whole or length > 1
        unknown += not (
            length or word[place].isdecimal() or word[place] == "i" or (word[0] == "d" and not place)
        )
        place += length or 1
    if unknown:
        return unknown == 1 and (_is_factor_before_function(word) or is_function_of_letter(word))
    return whole or len(word) <= longest


def is_function_of_letter(word: str) -> bool:
    """Tell whether a run is a function and its letter, as sinA, and no word, as sine."""
    return word[:-1] in FUNCTION_WORDS and word.lower() not in _PLAIN_WORDS and word not in FUNCTION_WORDS


def _is_factor_before_function(word: str) -> bool:
    """Tell whether a run is one letter and a function, as rcos."""
    return word[1:] in FUNCTION_WORDS and word not in FUNCTION_WORDS


_POINT_FIRST = re.compile(r"(?<![^\s(=≈])[.](?=[0-9])")
"""The decimal point of a number without a zero, .25; not that of Fig.25."""


def trim_segment(text: str, start: int, end: int, words: Vocabulary) -> tuple[int, int]:
    """Return a segment without articles, bullets and brackets that belong to the prose around it."""
    while start < end and (text[start].isspace() or text[start] in ",;.'′~&"):
        if _POINT_FIRST.match(text, start, end):
            break
        start += 1
    if (match := _ARTICLE_FIRST.match(text, start, end)) and match.group(1) not in words.names:
        start = match.end()
    while start < end and text[start] in "*-+/•·" and text[start + 1 : start + 2].isspace():
        start += 1
        while start < end and text[start].isspace():
            start += 1
    while start < end and (text[end - 1].isspace() or text[end - 1] in ",;'~&"):
        end -= 1
    end = _before_dash_of_prose(text, start, end)
    clause = _CLAUSE_BEGUN.search(text, max(start, end - 12), end)
    if clause and signs.RELATION.search(text, start, clause.start()):
        end = clause.start()  # s = 88 mm; r is half the stroke
    match = _ARTICLE_LAST.search(text[max(start, end - 4) : end])
    is_article = match is not None and _WORD_BEHIND.match(text, end) is not None
    if (
        match
        and is_article
        and match[1] not in words.names
        and not _ENDS_OPEN.search(text, start, end - 1)
    ):
        end -= len(match.group())
        if dash := _DASH_LAST.search(text[max(start, end - 4) : end]):
            end -= len(dash.group())  # "… - a known identity": the dash is the prose's too
    return _behind_quantity(text, *_within_brackets(text, start, end))


_IN_BRACKETS = re.compile(
    r"[0-9][0-9.,]*[ ~]?(?P<before>[^()=≈<>≤≥+*·×^\n]{0,40}?)(?P<gap>[\s,;]*)\((?P<inside>[^()\n]*)\)"
)


def _behind_quantity(text: str, start: int, end: int) -> tuple[int, int]:
    """Return the span of the relation in brackets behind a number of the prose: 70 mm (r = 35 mm)."""
    match = _IN_BRACKETS.fullmatch(text, start, end)
    if match is None or signs.RELATION.search(match["inside"]) is None:
        return start, end
    if not match["gap"] and scale_of(match["before"]) is None:
        return start, end  # 2 f(x = 3)
    return match.span("inside")


_CLAUSE_BEGUN = re.compile(r";\s+[^\W\d_](?:_\w{1,4})?$")
_SPACED_DASH = re.compile(r"(?<=[^\s=≈<>+\-*/·×(])\s+(?:[–—]|(?P<typed>-{2,3}))(?=\s*$)")
_FIRST_WORD = re.compile(r"\s*([^\W\d_]+)(?:[\s,]|$)")


def _before_dash_of_prose(text: str, start: int, end: int) -> int:
    """Return where a segment ends before the long dash of the words behind it: 916 cm³ – as it says."""
    match = _SPACED_DASH.search(text, max(start, end - 4), end)
    word = _FIRST_WORD.match(text, end) if match else None
    is_clause = word is not None and word[1].lower() in _PLAIN_WORDS | _CLAUSE_WORDS
    is_typed = match is not None and match["typed"] is not None  # two hyphens are no minus
    return match.start() if match and (is_clause or is_typed) else end


def parts_at_lone_brackets(text: str, start: int, end: int) -> list[tuple[int, int]]:
    """Return the parts of `λ = 0.3), r = 40` on both sides of the bracket that the prose opened.

    Only where two of them hold a relation: elsewhere a bracket without partner is the formula's own.
    """
    edges = sorted(_lone_brackets(text, start, end))
    if not edges:
        return [(start, end)]
    places = [start - 1, *edges, end]
    parts = [(a + 1, b) for a, b in pairwise(places) if text[a + 1 : b].strip()]
    with_relation = sum(signs.RELATION.search(text, *part) is not None for part in parts)
    return parts if with_relation > 1 else [(start, end)]


def _within_brackets(text: str, start: int, end: int) -> tuple[int, int]:
    """Drop brackets without partner at the edges, then a pair around all."""
    for _ in range(3):
        lone = _lone_brackets(text, start, end)
        inner = {place for place in lone if start < place < end - 1}
        if start < end and start in lone:
            start += 1
        if start < end and end - 1 in lone:
            end -= 1
        if inner:
            start, end = _longest_between(inner, start, end)
        while start < end and text[start].isspace():
            start += 1
        while start < end and text[end - 1].isspace():
            end -= 1
        if _is_enclosed(text, start, end):
            start, end = start + 1, end - 1
    return start, end


def _longest_between(places: Collection[int], start: int, end: int) -> tuple[int, int]:
    edges = [start - 1, *sorted(places), end]
    return max(((a + 1, b) for a, b in pairwise(edges)), key=lambda span: span[1] - span[0])


def _lone_brackets(text: str, start: int, end: int) -> set[int]:
    open_brackets: list[int] = []
    lone: set[int] = set()
    for place in range(start, end):
        if text[place] in "([{":
            open_brackets.append(place)
        elif text[place] in ")]}":
            if open_brackets:
                open_brackets.pop()
            else:
                lone.add(place)
    return lone | set(open_brackets)


def _is_enclosed(text: str, start: int, end: int) -> bool:
    if end - start < 2 or text[start] != "(" or text[end - 1] != ")":
        return False
    depth = 0
    for place in range(start, end - 1):
        depth += {"(": 1, ")": -1}.get(text[place], 0)
        if depth == 0:
            return False
    return True
