"""Letters that run through values: θ = 0…720° and n = 1, 2, 3 become 0 ≤ θ ≤ 720° and 1 ≤ n ≤ 3.

Such a letter has no single value; what is known of it is where its values lie, and a note says so.
"""

from __future__ import annotations

from itertools import pairwise

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.notes.reading.spellings.listed_multiples import VALUE, is_multiple, range_of
from symbalance.text import lazy_patterns as re

_NUMBER = (
    r"[-−]?(?:[0-9]+(?:\.[0-9]+|\{,\}[0-9]+)?(?:\s*(?:\\pi(?![A-Za-z])|π))?|\\pi(?![A-Za-z])|π)"
    r"(?:\s?°|\^\\circ(?![A-Za-z])|\^\{\\circ\})?"
)
_UNIT = (
    r"(?P<unit>(?:\\[,;: ]|~| )*\\mathrm\{[^{}]{1,12}\}"
    r"|[^\S\n]?(?:(?:mm|cm|rpm|N|m|kg|kN|Nm|Hz|bar|[kM]Pa|kW|lbs?|ft|psi|hp|s|(?:[1U]|rev|tr|r|giri|ot)/min)"
    r"(?![A-Za-z0-9/^²³·])|r\.\s?p\.\s?m\.?|min(?:⁻¹|\^\{?[-−]1\}?)|in\.(?=[\s,;)]|$)))"
)
_DOTS = r"(?:\\(?:l|c)?dots[a-z]?(?![A-Za-z])|…|⋯|\.{2,3}|・・・)"
_HEAD = r"(?<![\w\\}\])'′⁄])(?P<letter>(?:\\[A-Za-z]+|[^\W\d_])(?:_\{\w{1,6}\}|_\w{1,4}|[₀-₉])?)\s*&?=\s*"
_NOT_BEFORE_FORMULA = (
    r"(?!\.?[0-9]|\.\.)(?![^\S\n]*(?:[-+−*/·×=^_<>(≈≤≥≠√°²³]|\\(?!\)|\]|q?quad|text|end|\\|,|;)"
    r"|[A-Za-zα-ωϕϑΑ-Ω](?![^\W\d_])|(?:sin|cos|tan)\b))"
)
_RANGE = re.compile(
    rf"{_HEAD}(?P<first>{_NUMBER})(?:{_UNIT.replace('unit', 'one')})?\s*"
    rf"(?:{_DOTS}|(?:\\text\s*\{{\s*)?\b(?:to|bis)\b(?:\s*\}})?)\s*"
    rf"(?P<last>{_NUMBER})(?:{_UNIT})?{_NOT_BEFORE_FORMULA}"
)
_UNIT_OF_SPAN = (
    r"(?P<unit>(?:\\[,;: ]|~|[ ])*(?:\\(?:mathrm|text)\s?\{[^{}]{1,12}\}(?:\^\{?[-−]?[1-3]\}?)?"
    r"|(?:(?:[1U]|rev|r)/min|min(?:⁻¹|\^\{?[-−]1\}?)|1/s|s⁻¹|rpm|[kM]?Hz|[kMm]?N(?:m|/mm²)?|k?W|bar|[kM]Pa|GPa|[cmk]?m|k?g|s|PS|%|°)"
    r"(?![A-Za-z0-9^²³/])))"
)
_SPAN = re.compile(
    rf"{_HEAD}(?P<first>{_NUMBER})(?P<dash>–|--|-)"
    rf"(?P<last>{_NUMBER.replace('[-−]?', '')})(?:{_UNIT_OF_SPAN})?{_NOT_BEFORE_FORMULA}"
)
"""From one number to a larger one, n = 1500–6000 rpm: a hyphen needs the unit, or it is a minus sign."""
_AND = "and|or|und|oder|et|ou|e|ed|o|y|och|i|en|of"
_COMMA = (
    rf"\s*(?:[,;、と]|\\text\s*\{{\s*(?:{_AND})\s*\}}|(?<=\s)(?:{_AND})(?=\s)|および)"
    r"(?:\s|\\[,; ])*"
)
_ONE_UNIT = _UNIT.replace("P<unit>", ":")
_NEXT_CASE = r"(?!\s?\$?(?:では|の場合|のとき|なら)は?[、\s$]{0,3}(?P=letter)\s*=)"
"""Behind δ = 60°、72° stands では δ = 36°: the 72° open the next case."""
_LIST = re.compile(
    rf"{_HEAD}(?P<first>{_NUMBER})(?P<one>{_ONE_UNIT})?(?P<rest>(?:{_COMMA}(?>{_NUMBER}(?:{_ONE_UNIT})?){_NEXT_CASE})*+)"
    rf"(?:(?:{_COMMA})?\s*(?P<dots>{_DOTS})(?:{_COMMA}(?P<last>{_NUMBER}|[A-Za-z](?:\s*[-−+]\s*[0-9])?))?+)?+"
    rf"{_NOT_BEFORE_FORMULA}"
)
_HEAD_OF_LIST = _HEAD.replace(r"_\{\w{1,6}\}", r"_\{[\w,]{1,8}\}")
_MULTIPLES = re.compile(
    rf"{_HEAD_OF_LIST}(?P<values>{VALUE}(?:{_COMMA}(?>{VALUE}){_NEXT_CASE}){{0,11}}+)"
    rf"(?:(?:{_COMMA}|\s)(?P<dots>{_DOTS})(?:{_COMMA}(?P<last>{VALUE}))?+)?+{_NOT_BEFORE_FORMULA}"
)
"""Where cranks stand: z = +a, 0, -a, multiples of one length; n = 1/2, 1, 3/2, … of one number."""
_END_OF_FORMULA = re.compile(r"\s*(?:\$|\\[)\]]|\\\\|\\end\{|[.;)](?![0-9A-Za-z])|\n|$)")
_OPERATOR_BEFORE = re.compile(r"(?:[-+−*/·×^=<>≤≥≈]|\\(?:cdot|times|pm|sum|prod|int|lim)|[_^]\s*\{)\s*$")
_LONGEST_BEFORE = 12
_BETWEEN = re.compile(_COMMA)
_DEGREES = re.compile(r"(?:\s?°|\^\\circ|\^\{\\circ\})$")
_INDEXED = re.compile(r"[^_]+_\{?[ijkn]\}?")
_NUMBERED = re.compile(r"_\{?[0-9]+\}?$|[₀-₉]$")
_ENDS_IN_AND = re.compile(rf"(?:\s(?:{_AND})\s|と|および)[^,;、]*$")
WIDEST = 1000
"""How many times larger the next of several values of a letter may be."""
_PAIR = 2
_STEP, _TWO_TURNS = 6, 720
"""Degrees by which cranks are apart, and those of a whole cycle."""
_LENGTHS = frozenset(("mm", "cm", "m"))
"""Units between which a list of values may change."""
_PROGRAM = re.compile(r"^(`{3,}+|~{3,}+)[^\n]*+\n.*?^\1", re.MULTILINE | re.DOTALL)
"""Program code, whose `r, l = 0.045, 0.15` gives two letters a value each."""


def with_ranges(text: str) -> tuple[Rewritten | None, tuple[str, ...]]:
    """Return a text with runs of values as ranges, None where there are none, and what to say of it.

    >>> with_ranges("n = 1, 2, …")[0].text, with_ranges("n = 1, m = 2")[0]
    ('n ≥ 1', None)
    >>> with_ranges("n = 1500–6000 rpm")[0].text, with_ranges("x = 5-8 = -3")[0]
    ('1500 rpm ≤ n ≤ 6000 rpm', None)
    """
    program = [match.span() for match in _PROGRAM.finditer(text)]
    changes: dict[int, tuple[int, str]] = {}
    for match in _RANGE.finditer(text):
        if _stands_first(text, match):
            unit = match["unit"] or match["one"] or ""
            has_degrees = re.search(r"°$|circ\}?$", match["last"]) and not re.search(
                r"°$|circ\}?$", match["first"]
            )
            first = f"{match['first']}{match['one'] or unit}{'°' if has_degrees else ''}"
            changes[match.start()] = match.end(), f"{first} ≤ {match['letter']} ≤ {match['last']}{unit}"
    for match in _SPAN.finditer(text):
        is_new = not any(start <= match.start() < change[0] for start, change in changes.items())
        if is_new and _stands_first(text, match) and _ascends(match):
            unit = match["unit"] or ""
            changes[match.start()] = (
                match.end(),
                f"{match['first']}{unit} ≤ {match['letter']} ≤ {match['last']}{unit}",
            )
    for match in _LIST.finditer(text):
        is_new = not any(start <= match.start() < change[0] for start, change in changes.items())
        if is_new and (match["rest"] or match["dots"]) and _stands_first(text, match):
            written = _listed(match)
            changes |= {match.start(): (match.end(), written)} if written else {}
    for match in _MULTIPLES.finditer(text):
        is_new = not any(start <= match.start() < change[0] for start, change in changes.items())
        if is_new and _stands_first(text, match) and (written := _of_one_letter(match)):
            changes[match.start()] = match.end(), written
    changes = {
        start: change for start, change in changes.items() if not any(a <= start < b for a, b in program)
    }
    if not changes:
        return None, ()
    rewriter = Rewriter(text)
    for start, (end, written) in sorted(changes.items()):
        rewriter.replace(start, end, written)
    start, (end, written) = min(changes.items())
    shown = " ".join(text[start:end].split())
    return rewriter.finish(), (f"a run of values: {shown} is read as {written} ({len(changes)}×)",)


def _stands_first(text: str, match: re.Match[str]) -> bool:
    """Tell whether the letter is all of its side, and no bound of a sum."""
    before = text[max(match.start() - _LONGEST_BEFORE, 0) : match.start()]
    return _OPERATOR_BEFORE.search(before) is None


def _ascends(match: re.Match[str]) -> bool:
    """Tell whether a dash stands between two numbers of which the second is larger, and no minus sign."""
    if match["dash"] == "-" and not match["unit"]:
        return False
    plain = [match[part].replace("{,}", ".").rstrip("°") for part in ("first", "last")]
    return all(re.fullmatch(r"[0-9.]+", number) for number in plain) and float(plain[0]) < float(plain[1])


def _turned_through(match: re.Match[str], plain: list[str], bare: list[str]) -> str | None:
    """Return a list of angles in degrees as the range that holds them, None for fewer than three."""
    if (
        not all(re.fullmatch(r"-?[0-9.]+", value) for value in bare)
        or len(bare) <= _PAIR
        or match["dots"]
    ):
        return None
    before = match.string[max(match.start() - _LONGEST_BEFORE, 0) : match.start()].rstrip()
    if _NUMBERED.search(match["letter"]) or before.endswith((",", "dots", "…")):
        return None  # δ_1, …, δ_5 = 0°, 144°, …: a value for each
    sized = sorted(zip(map(float, bare), plain, strict=True))
    return f"{sized[0][1]} ≤ {match['letter']} ≤ {sized[-1][1]}" if sized[0][0] < sized[-1][0] else None


def _of_one_letter(match: re.Match[str]) -> str | None:
    """Return a list of multiples of one letter as the range that holds them, None for other lists.

    Two values in a row are a list where the formula ends behind them: "for l = 4r, r being …" has one.
    """
    values = _BETWEEN.split(match["values"])
    last = [match["last"]] if match["last"] else []
    if len(values) + len(last) < _PAIR or match["letter"].startswith("\\text"):
        return None
    before = match.string[max(match.start() - _LONGEST_BEFORE, 0) : match.start()].rstrip()
    if before.endswith((",", "dots", "…")) and _NUMBERED.search(match["letter"]):
        return None  # x_1, x_2, x_3 = -a, 0, a: a value for each
    is_short = len(values) == _PAIR and not match["dots"] and not is_multiple(values[-1])
    if is_short and _END_OF_FORMULA.match(match.string, match.end()) is None:
        return None
    is_endless = match["dots"] is not None and not last
    return range_of(match["letter"], [*values, *last], is_endless=is_endless)


def _listed(match: re.Match[str]) -> str | None:
    """Return a list of values as the range that holds them, None where it is none."""
    rest = match["rest"]
    values = [match["first"], *re.findall(_NUMBER, rest)]
    plain = [value.replace("−", "-").replace("{,}", ".") for value in values]
    bare = [_DEGREES.sub("", value) for value in plain]
    if any(re.match(r"-?0[0-9]", value) for value in bare):
        return None  # 0,04 is one number, with a comma that elsewhere parts a list
    if (
        bare != plain
        and "0" in plain
        and all(b != p or b == "0" for b, p in zip(bare, plain, strict=True))
    ):
        return _turned_through(match, [p if p != "0" else "0°" for p in plain], bare)  # 0, 120°, 240°
    if not all(re.fullmatch(r"-?[0-9.]+", value) for value in bare):
        return None
    is_last_alone = bare[-1] != plain[-1] and bare[:-1] == plain[:-1]  # 0, 120, 240°
    if is_last_alone and _are_cranks(sizes := [float(value) for value in bare]):
        return f"0° ≤ {match['letter']} ≤ {max(sizes):g}°"
    if bare == plain and _are_cranks(sizes := [float(value) for value in plain]):
        return f"0 ≤ {match['letter']} ≤ {max(sizes):g}"
    return _plain_list(match, values, plain, bare)


def _are_cranks(sizes: list[float]) -> bool:
    """Tell whether numbers are the angles of an engine's cranks in degrees: 0, 240, 120, 120, 240, 0."""
    is_turned = len(sizes) > _PAIR and sizes[0] == 0 and 0 < max(sizes) < _TWO_TURNS and min(sizes) >= 0
    return is_turned and all(size % _STEP == 0 for size in sizes)


def _plain_list(match: re.Match[str], values: list[str], plain: list[str], bare: list[str]) -> str | None:
    """Return a list of numbers with or without degrees as the range that holds them."""
    rest = match["rest"]
    if _INDEXED.fullmatch(match["letter"]) and not match["dots"]:  # one value for each k
        sized = sorted(zip(map(float, bare), plain, strict=True))
        sign = "°" if any(value != part for value, part in zip(plain, bare, strict=True)) else ""
        lowest, highest = (f"{_DEGREES.sub('', each[1])}{sign}" for each in (sized[0], sized[-1]))
        is_list = sign and len(values) > _PAIR and lowest != highest
        return f"{lowest} ≤ {match['letter']} ≤ {highest}" if is_list else None
    if all(b != p for b, p in zip(bare, plain, strict=True)):
        return _turned_through(match, plain, bare)
    sizes = [float(value) for value in plain] if bare == plain else []
    is_falling = len(sizes) > _PAIR and sizes == sorted(sizes, reverse=True) and _ENDS_IN_AND.search(rest)
    is_run = bool(sizes) and len(set(sizes)) == len(sizes) and (sizes == sorted(sizes) or is_falling)
    if is_falling and not match["dots"]:  # n = 2400, 1200 and 800 rpm
        values, sizes = values[::-1], sizes[::-1]
    if not is_run or any(second > WIDEST * first > 0 for first, second in pairwise(sizes)):
        return None  # λ = 0.31, 6000 rpm: the speed is another quantity
    units = [unit.group() for unit in re.finditer(_UNIT, (match["one"] or "") + rest)]
    if len({re.sub(r"\\[,;: ]|[~\s]", "", unit) for unit in units}) > 1:
        return None  # L = 110 mm, 10000 rpm
    unit = units[-1] if units else ""
    letter, lowest, last = match["letter"], f"{values[0]}{unit}", match["last"]
    if match["dots"] and not last:
        return f"{letter} ≥ {lowest}"
    return f"{lowest} ≤ {letter} ≤ {last or values[-1]}{unit}"
