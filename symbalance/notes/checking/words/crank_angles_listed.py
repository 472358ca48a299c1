"""Crank angles that a page lists in words: "crank throws at 0°, 180°, 180°, 0°".

A sum over the cylinders without an index, ΣF_1, goes over the list that its section gives last; so does
Σ cos(φ + δ_i), whose δ_i stand in no formula of their own. Equal firing intervals of an engine in line
say the angles too: one after the other, by two turns over the number of cylinders, or by one.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache

from symbalance.document.formula import Constant, Formula, Number, Product
from symbalance.notes.checking.words.case_words import engine_named
from symbalance.notes.checking.words.cranks_apart import cranks_apart
from symbalance.text import lazy_patterns as re

_NUMBER = r"[0-9]{1,3}(?:\.[0-9]+)?"
_DEGREE = r"(?:\s?(?:°|º|\^\s*\{?\s*\\circ\s*\}?|\\degree|\\textdegree|\$?\s?(?:Grad|degrees?|deg|度)))"
_ANGLE = re.compile(
    rf"\\ang\{{(?P<ang>{_NUMBER})\}}"
    rf"|\\[dt]?frac\s*\{{(?P<above>{_NUMBER})?\s*(?:\\pi|π)\s*\}}\s*\{{(?P<below>{_NUMBER})\}}"
    rf"|(?P<times>{_NUMBER})?\s*(?:\\pi|π)(?![A-Za-z])\s*(?:/\s*(?P<over>{_NUMBER}))?"
    rf"|(?P<number>{_NUMBER})(?P<degree>{_DEGREE})?"
)
_SEPARATOR = re.compile(
    r"(?:\s|\\[,;: ]|~|\$|\\q?quad)*"
    r"(?:\|\|?|[,;、，/&–—-]|(?<=[\s$])(?:and|und|et|bzw\.|[eyi]|oraz|och|og|en)(?=[\s$\\])|と|および)"
    r"(?:\s|\\[,;: ]|~|\$|(?:and|und|et|[eyi]|oraz|och|og|en)(?=[\s$\\]))*"
)
_STARTS = re.compile(r"(?<![\w.^{=\\(])(?:(?<=\$)|(?<=\{)|)(?=0|\\ang\{0)|(?:(?<=[($（])|(?<=\\\{))(?=0)")
_OF_CRANKS = re.compile(
    r"crank|throw|\bpins?\b|cylind|phase|offset|kröpfung|zapfen|kurbel|zylind|versatz|stern|manivelle|maneton"
    r"|vilebrequin|気筒|クランク|シリンダ|ピン|\b[1-9][0-9]?-?cyl|cilind|manovell|gomit|manivela|muñequill"
    r"|codos?\b|cigüeñal|wykorb|korb|klik|válc|vevs|vevtapp|kruk"
    r"|(?:\\?(?:delta|psi|varphi|phi|alpha|beta|gamma)|[δψφϕαβγ])\s*_\s*\{?\s*[1ijkn]",
    re.IGNORECASE,
)
_CRANK_ANGLE = re.compile(r"crank\s*angles?|Kurbelwinkeln?|クランク角度?", re.IGNORECASE)
_THROWS = re.compile(
    r"throws|crank\s*pins|kröpfung"
    r"|cranks?\s+(?:(?:are|stand|set|placed)\s+){0,2}at|_\s*\{?\s*[1ijkn]",
    re.IGNORECASE,
)
_ANGLES_OF_A_LETTER = re.compile(
    r"(?:\\(?:delta|psi|varphi|phi|alpha|beta|gamma)|[δψφϕαβγ])\s*\$?(?P<several>['’]s)?"
    r"\s*(?::|are|runs?(?:\s+through)?|(?:is\s+)?equal(?:s|\s+to)?|sind|betragen|sont|valent)\s*[$(\\{]*$"
)
"""Before a list, the letter whose values for the cylinders it gives: the δ's are 0, π, π, 0."""
_RANGE = re.compile(
    r"(?:between|zwischen|interval|range|from|von|Bereich|∈|\\in|\[)[\s$(]*$", re.IGNORECASE
)
_EQUAL_FIRING = re.compile(
    r"equal(?:ly\s+spaced)?\s+firing|even(?:ly)?[\s-]firing|firing\s+(?:at\s+)?equal"
    r"|gleiche[nrm]?\s+Zündabst|gleichmäßige[nrm]?\s+Zünd|等間隔(?:の)?(?:点火|爆発|着火)",
    re.IGNORECASE,
)
_IN_LINE = re.compile(r"in-?\s?line|straight|Reihe|直列", re.IGNORECASE)
_COUNT = re.compile(r"(?<![A-Za-z\\])[zNni]\s*\$?\s*=\s*\$?\s*([2-9]|1[0-9])(?![0-9.,]*[0-9])")
_CLAUSE = re.compile(r"[.!?。]\s|[;；]|\n\s*\n|\n#|\n(?=\s*[-*+]\s)")
_TWO_STROKE = re.compile(r"(?:two|2)[\s-]?stroke|(?:Zwei|2)[\s-]?takt|2サイクル", re.IGNORECASE)
_FOUR_STROKE = re.compile(r"(?:four|4)[\s-]?stroke|(?:Vier|4)[\s-]?takt|4サイクル", re.IGNORECASE)
_IN_BANKS = re.compile(
    r"(?<![A-Za-z])(?:V|W|VR)[-\s]?(?:[0-9]{1,2}(?![0-9])|engine|twin|motor|型)|boxer|flat[-\s](?!crank|plane)|opposed"
    r"|(?<![A-Za-z])bank|radial|Gabel|Sternmotor|水平対向|星型|バンク",
    re.IGNORECASE,
)
"""Words for engines in which the same crank angle is not the same force in one direction."""
_TWO_OF_THEM = re.compile(
    r"\b(?:two|twice|double|mirror\w*|halves|zwei|gespiegelt\w*|spiegel\w*|hälften|deux|miroir|dos|espejo|due"
    r"|specchi\w*|twee|två)\b|2つ|二つ|2基|鏡|2台",
    re.IGNORECASE,
)
"""Words that say an engine is two of a smaller one: a six as two threes, mirrored."""
_SENTENCE = re.compile(r"[.!?。]\s|[;；]|\n")
"""What ends the words that lead to a list, a line too."""
_HEADING = re.compile(
    r"^(?:#{1,6}\s|={2,6}|\\(?:sub)*section\*?\{|<h[1-6])[^\n]*", re.MULTILINE | re.IGNORECASE
)
_NAMED = re.compile(
    r"(?P<flat>\bflat|flach|plane?\s+Kurbel)|(?P<cross>\bcross|kreuz)|(?P<n2>\btwins?\b|\bthe\s+two\b|zweizyl)"
    r"|(?P<n3>\bthe\s+three\b|triple|three-cyl|dreizyl|3\s?気筒)"
    r"|(?P<n4>\bthe\s+four\b|four-cyl|inline[\s-]four\b|vierzyl|4\s?気筒)"
    r"|(?P<n5>\bthe\s+five\b|five-cyl|inline[\s-]five\b|fünfzyl|5\s?気筒)"
    r"|(?P<n6>\bthe\s+six\b|six-cyl|inline[\s-]six\b|sechszyl|6\s?気筒)",
    re.IGNORECASE,
)
"""Words that tell the engines of one page apart."""
_IN_GROUP = (
    r"(?P<cranks>[1-9](?:\s*(?:,|and|und|et|e|y|と|、)\s*[1-9])*)[\s$]*(?:(?:are|stand|lie|stehen|liegen|sont)\s+)?"
    rf"(?:at|bei|auf|à|a)[\s$]+(?P<angle>{_NUMBER})(?P<degree>{_DEGREE})?\$?"
)
_GROUP = re.compile(_IN_GROUP, re.IGNORECASE)
_PLAIN_GROUP = re.sub(r"\(\?P<\w+>", "(?:", _IN_GROUP)
_OF_GROUP = (
    r"(?:cranks?|throws?|(?:crank)?pins?|cylinders?|kurbeln|kröpfungen|zylinder|manetons|manivelles)\s+"
)
_GROUPS = re.compile(
    rf"(?<![^\W\d_]){_OF_GROUP}{_PLAIN_GROUP}"
    rf"(?:[\s,;$]+(?:(?:and|und|et|while|whereas|während)\s+)?(?:the\s+)?(?:{_OF_GROUP})?{_PLAIN_GROUP})+",
    re.IGNORECASE,
)
_ROW = re.compile(r"^[ \t]*\|?[ \t]*(?P<cells>[^\n]*[|&][^\n]*)$", re.MULTILINE)
_BEFORE, _BEHIND = 120, 30
"""Characters before and behind a list in which words have to say that it is of cranks."""
_FURTHEST, _TITLE = 60, 3
"""Lines of a section before a list, and of the page, that may name an engine in banks.

A section that says its engine is in line has the last word."""
_MARKS = re.compile(r"[\s$]|\\\\|\\hline")
FEWEST = 2
SMALLEST_ANGLE = 10
"""Of a crank in degrees, where it stands without their sign."""


@dataclass(frozen=True, slots=True)
class CrankAngles:
    """The angles of a page's cylinders in degrees, and the line on which they stand."""

    degrees: tuple[Fraction, ...]
    line: int
    place: int = 0
    """Where in the page the list begins."""
    is_by_firing: bool = False
    others: tuple[CrankAngles, ...] = ()
    """What else the words may say: the angles of a two-stroke engine."""
    is_usual: bool = False
    """Whether no list says them, but the name of an engine whose crankshaft is usual."""
    signs: tuple[int, ...] = ()
    """For engines with opposed cylinders: which way each one's force counts."""
    arms: tuple[Fraction, ...] = ()
    """The cylinders' places along the crank from the middle, where an engine's name says them."""

    engines: frozenset[str] = frozenset()
    """What tells the list's engine from others of the page: its planes, the number of its cylinders."""
    is_against: bool = False
    """Whether each is how far a crank lags behind the angle counted: θ - 90°."""

    @property
    def nodes(self) -> tuple[Formula, ...]:
        """The angles as formulas."""
        pi = Constant("pi")
        sign = -1 if self.is_against else 1
        return tuple(Product((Number(sign * angle / 180), pi)) for angle in self.degrees)

    @property
    def text(self) -> str:
        """The angles as a condition of what rests on them."""
        angles = ", ".join(f"{_plain(angle)}°" for angle in self.degrees)
        angles = f"{angles} behind" if self.is_against else angles
        if self.is_usual:
            opposed = ", the cylinders opposed" if self.signs else ""
            usual = f"as is usual for the engine that line {self.line} names"
            return f"the cranks are at {angles}{opposed}, {usual}"
        where = "equal firing intervals" if self.is_by_firing else "the list"
        return f"the cranks are at {angles} ({where} of line {self.line})"


def _plain(number: Fraction) -> str:
    return str(number.numerator) if number.denominator == 1 else f"{float(number):.6g}"


@lru_cache(maxsize=4)
def crank_angles(text: str) -> tuple[CrankAngles, ...]:
    """Return the lists of crank angles of a page, in the order of its lines; it is asked several times.

    >>> [str(a) for a in crank_angles("Crank throws at 0°, 180°, 180° and 0°.")[0].degrees]
    ['0', '180', '180', '0']
    """
    groups = list(_GROUPS.finditer(text))
    others = (
        each for each in _in_words(text) if not any(g.start() <= each.place < g.end() for g in groups)
    )
    apart = (CrankAngles(own, _line_at(text, at), at) for own, at in cranks_apart(text))
    lists = [*others, *_by_rows(text), *_by_firing(text), *_by_groups(groups, text), *apart]
    lists.sort(key=lambda angles: angles.place)
    before = [0, *(angles.place for angles in lists)]
    return tuple(_with_engine(own, first, text) for own, first in zip(lists, before, strict=False))


def listed_at(
    lists: Sequence[CrankAngles],
    start: int,
    text: str,
    same_section: Callable[[int, int], bool],
    *,
    of_pins: bool = False,
) -> CrankAngles | None:
    """Return the angles that are listed last before a place, in its section, or behind it on its line.

    A page that lists one engine's cranks alone lists them for the sections below too. None where another
    engine is named since, or one whose cylinders are not in line: there the force of a cylinder is not
    that of its pin alone, but a sum of the pins' own angles (`of_pins`), Σ cos φ_k, goes over them.
    """
    line = _line_at(text, start) if lists else 0
    near = [a for a in lists if a.line <= line and same_section(a.line, line)]
    before = [a for a in near if a.place < start]
    behind = [a for a in near if a.line == line and a.place > start]
    is_before_here = bool(before) and before[-1].line == line
    near = behind[:1] if behind and not is_before_here else before
    if not near and len({frozenset(each.degrees) for each in lists}) == 1:
        near = [each for each in lists if each.place < start]
    words = _CLAUSE.split(text[max(0, start - _BEFORE) : start])[-1]
    near = _of_engine_named(near, lists, words, start, line)
    if not near:
        return None
    lines = text.splitlines(keepends=True)
    first = near[-1].line
    while first > max(near[-1].line - _FURTHEST, 1) and same_section(first - 1, line):
        first -= 1
    own = "".join(lines[max(first - 2, 0) : line])
    title = "" if _IN_LINE.search(own) else "".join(lines[:_TITLE])
    if not of_pins and _IN_BANKS.search(title + own):
        return None
    between = text[near[-1].place : start]
    engine = engine_named(between, len(between))
    cylinders = len(near[-1].degrees)
    is_half = (
        engine is not None and 2 * engine[0] == cylinders and _TWO_OF_THEM.search(between) is not None
    )
    is_other = engine is not None and engine[0] not in (1, cylinders) and not is_half  # 1: of one of them
    return None if is_other else near[-1]


def _of_engine_named(
    near: list[CrankAngles], lists: Sequence[CrankAngles], words: str, start: int, line: int
) -> list[CrankAngles]:
    """Return the lists near that a relation may go over, where several engines stand side by side.

    "In the cross-plane engine" is the list that has that name, wherever it stands. Two lists in a row,
    of different engines, leave open which is meant where nothing names one.
    """
    if not near:
        return near
    own, last = _engines_named(words), near[-1]
    if _TWO_OF_THEM.search(words):
        own = frozenset()  # "two threes, mirrored": the six that they make
    if own and last.engines and not own & last.engines:
        return [each for each in lists if each.place < start and own & each.engines]
    named = [each for each in near if own & each.engines]
    if named or len(near) == 1:
        return named or near
    are_in_a_row = last.line - near[-2].line <= 1 and last.line < line
    return [] if are_in_a_row and last.degrees != near[-2].degrees else near


def _with_engine(angles: CrankAngles, first: int, text: str) -> CrankAngles:
    """Return a list with the engine that the words before it name from `first` on, or its heading."""
    own = _engines_named(_SENTENCE.split(text[max(first, angles.place - _BEFORE) : angles.place])[-1])
    if not own:
        headings = list(_HEADING.finditer(text, 0, angles.place))
        own = _engines_named(headings[-1].group()) if headings else own
    return replace(angles, engines=own)


def _engines_named(words: str) -> frozenset[str]:
    """Return what words name an engine by: its planes, the number of its cylinders."""
    return frozenset(match.lastgroup or "" for match in _NAMED.finditer(words))


def _line_at(text: str, place: int) -> int:
    return text.count("\n", 0, place) + 1


def _in_words(text: str) -> Iterator[CrankAngles]:
    """Yield the lists that stand in a sentence or in one row of a table."""
    last = 0
    for start in _STARTS.finditer(text):
        if start.start() < last:
            continue
        matches, end = _angles_from(text, start.start())
        if len(matches) < FEWEST:
            continue
        last = end
        is_of_cells = re.search(r"[|&]", text[start.start() : end]) is not None
        degrees = None if is_of_cells and _has_small_number(matches) else _degrees(matches)
        before = _CLAUSE.split(text[max(0, start.start() - _BEFORE) : start.start()])[-1]
        behind = _CLAUSE.split(text[end : end + _BEHIND])[0]
        if degrees is not None and _is_of_cranks(before, behind, degrees):
            yield CrankAngles(degrees, _line_at(text, start.start()), start.start())


def _has_small_number(matches: list[re.Match[str]]) -> bool:
    """Tell whether one of some cells is a small number: in the row 0° | 1 | 0 the 1 is a cosine."""
    bare = (m["number"] for m in matches if m["number"] and not m["degree"])
    return any(0 < Fraction(number) < SMALLEST_ANGLE for number in bare)


def _is_of_cranks(before: str, behind: str, degrees: tuple[Fraction, ...]) -> bool:
    """Tell whether words around a list say that it is where the cranks stand.

    "At crank angles 0°, 30°, 60°" says where one crank is looked at; "between 0 and 180°" is a range.
    """
    named = engine_named(before + behind, len(before + behind))
    if len(degrees) == FEWEST and (_RANGE.search(before) or not (named and named[0] == FEWEST)):
        return len(set(degrees)) == 1 or _THROWS.search(before) is not None
    bare_before, bare_behind = (_CRANK_ANGLE.sub(" ", words) for words in (before, behind))
    if _OF_CRANKS.search(bare_before) or _OF_CRANKS.search(bare_behind):
        return True
    is_arrangement = len(set(degrees)) < len(degrees)
    letter = _ANGLES_OF_A_LETTER.search(before)
    if letter is not None and (is_arrangement or letter["several"]):
        return True
    return is_arrangement and bool(_CRANK_ANGLE.search(before) or _CRANK_ANGLE.search(behind))


def _angles_from(text: str, start: int) -> tuple[list[re.Match[str]], int]:
    matches: list[re.Match[str]] = []
    place, end = start, start
    while match := _ANGLE.match(text, place):
        matches.append(match)
        end = match.end()
        separator = _SEPARATOR.match(text, end)
        if separator is None:
            break
        place = separator.end()
    return matches, end


def _degrees(matches: list[re.Match[str]]) -> tuple[Fraction, ...] | None:
    """Return the angles of a list in degrees; numbers without a sign are such if one of them has it."""
    has_pi = [m["number"] is None and m["ang"] is None for m in matches]
    signed = [m["degree"] is not None or m["ang"] is not None for m in matches]
    values: list[Fraction] = []
    for match, of_pi in zip(matches, has_pi, strict=True):
        if of_pi:
            above = Fraction(match["above"] or match["times"] or 1)
            values.append(180 * above / Fraction(match["below"] or match["over"] or 1))
        else:
            values.append(Fraction(match["ang"] or match["number"]))
    bare = [v for v, of_pi, sign in zip(values, has_pi, signed, strict=True) if not of_pi and not sign]
    is_meant = any(has_pi) != any(signed) and (not any(has_pi) or not any(bare))
    return tuple(values) if is_meant else None


def _by_rows(text: str) -> Iterator[CrankAngles]:
    """Yield the lists that stand in the rows of a table: number of the cylinder, its angle."""
    header, rows, first, first_line = "", list[Fraction](), 0, 0
    for match in [*_ROW.finditer(text), None]:
        cells = [_MARKS.sub("", cell) for cell in re.split(r"[|&]", match["cells"])] if match else []
        cells = [cell for cell in cells if cell]
        number = cells[0] if cells else ""
        angles = [_degrees([m]) for c in cells[1:] if (m := _ANGLE.fullmatch(c)) and m["number"] != c]
        zero = [c for c in cells[1:] if c == "0"]
        value = angles[0] if len(angles) == 1 else (Fraction(0),) if zero and not angles else None
        if value is not None and number == str(len(rows) + 1):
            first = first if rows or match is None else match.start()
            first_line = _line_at(text, first)
            rows.append(value[0])
            continue
        if len(rows) >= FEWEST and any(rows) and _OF_CRANKS.search(header):
            yield CrankAngles(tuple(rows), first_line, first)
        if rows or (cells and not set("".join(cells)) <= set("-: ")):
            header = match["cells"] if match else ""
        rows = []


def _by_groups(groups: Sequence[re.Match[str]], text: str) -> Iterator[CrankAngles]:
    """Yield the angles that cranks have in groups: cranks 1 and 4 at 0, cranks 2 and 3 at 180°."""
    for match in groups:
        angles: dict[int, Fraction] = {}
        bare: list[Fraction] = []
        numbers = 0
        for group in _GROUP.finditer(match[0]):
            own = [int(number) for number in re.findall(r"[0-9]+", group["cranks"])]
            numbers += len(own)
            angles |= dict.fromkeys(own, Fraction(group["angle"]))
            bare += [] if group["degree"] else [Fraction(group["angle"])]
        if (
            sorted(angles) == list(range(1, numbers + 1))
            and len(set(angles.values())) > 1
            and not any(bare)
        ):
            degrees = tuple(angles[number] for number in sorted(angles))
            yield CrankAngles(degrees, _line_at(text, match.start()), match.start())


def _by_firing(text: str) -> Iterator[CrankAngles]:
    """Yield the angles of engines in line with equal firing intervals: 720°/z one after the other."""
    for match in _EQUAL_FIRING.finditer(text):
        before = re.split(r"[.!?。]\s|\n\s*\n", text[max(0, match.start() - _BEFORE) : match.start()])[-1]
        behind = _CLAUSE.split(text[match.end() : match.end() + 2 * _BEHIND])[0]
        count = _COUNT.search(behind) or _COUNT.search(before)
        named = engine_named(before + match.group(), len(before))
        number = int(count[1]) if count else named[0] if named else 0
        if number < FEWEST or not (_IN_LINE.search(before) or _IN_LINE.search(behind)):
            continue
        line = _line_at(text, match.start())
        four, two = (
            CrankAngles(
                tuple(Fraction(cycle * k, number) % 360 for k in range(number)),
                line,
                match.start(),
                is_by_firing=True,
            )
            for cycle in (720, 360)
        )
        if _TWO_STROKE.search(before + behind):
            yield two
        else:
            yield four if _FOUR_STROKE.search(before + behind) else replace(four, others=(two,))
