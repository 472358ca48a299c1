"""The motion of a slider-crank that the words around a relation name, and the places of the crank.

They stand in the clause before the relation, behind it, in the row and the head of a table, in the
sentences since the relation before, or in the heading; the letter's index, its dots and what it was above
say the rest.
"""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import NamedTuple

from symbalance.document.formula import Call, Formula, Name, walk
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.letters_in_waves import WAVES, letters_in_waves
from symbalance.notes.checking.meant.catalogue.kinematics import (
    ACCELERATION,
    BOTTOM,
    FASTEST,
    HALF,
    HUMP,
    JERK,
    LARGEST,
    PATH,
    RIGHT,
    ROD_ACCELERATION,
    ROD_ANGLE,
    ROD_SPEED,
    SPEED,
    STROKE,
    TOP,
    TURNED,
)
from symbalance.notes.checking.meant.pistons.motion_letters import OF_CRANK, angle_rank
from symbalance.notes.checking.meant.pistons.motion_words import (
    HAS_OFFSET,
    motions_named,
    names_another,
    place_of_index,
    places_named,
)
from symbalance.notes.checking.words.glossary import Glossary, glossary_of
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.checking.words.sentences import SENTENCE_END
from symbalance.notes.checking.words.table_cells import TableCells, cells_of
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

BEFORE, BEHIND = 320, 70
"""Characters that are looked through before a formula and behind it."""
_CELL_OR_SENTENCE = re.compile(rf"{SENTENCE_END.pattern}|\|")
BARE = 8
"""Letters since the relation before that name nothing: "so", "then"."""
_LEAD = re.compile(r"(?:^|\n)\s*\*\*([^*\n$]{3,60}?)[.:]?\*\*(?:(?!\n\s*\n).)*$", re.DOTALL)
"""The title in bold that opens the paragraph of a formula."""
_SET_OFF = " \t\n$\\([{&|"
_MARKUP = re.compile(r"<[^>]*>|\\(?:begin|end|label)\{[^}]*\}|\\\w+|[$*_#`]")
OF_ROD = frozenset({ROD_ANGLE, ROD_SPEED, ROD_ACCELERATION})
_FAST = re.compile(r"fast|velocit|speed|geschwindig|速度|schnell|vitesse|velocidad", re.IGNORECASE)
_EXTREME = re.compile(r"extrem|\btop|peak|hump|minim|largest|greatest|maxim", re.IGNORECASE)
_MIDWAY = re.compile(
    r"mid-?stroke|half[- ](?:the |its |of the |of its |way )?(?:down |through |along )?(?:the "
    r"|its )?stroke"
    r"|middle of (?:the|its) stroke|half ?way (?:down|through|along|on) (?:the|its) (?:stroke|travel)"
    r"|half[- ]way down its stroke|hubmitte|mitte des (?:kolben)?hub|halbe[mnr]? (?:kolben)?hub"
    r"|halben? kolbenweg"
    r"|行程の?(?:中央|半分|1/2|中点)|mi-course|milieu de (?:la |sa )?(?:course|stroke)"
    r"|mitad de (?:la |su )?(?:carrera|stroke)|metà (?:della )?(?:corsa|stroke)",
    re.IGNORECASE,
)
_DOUBTS = re.compile(
    r"\bnot\b(?! (?:an )?offset)|\binstead\b|\bwrong|mistak|\bnicht\b(?! (?:geschränkt|desaxiert"
    r"|versetzt))|\bstatt\b|anstelle|falsch|ではない|誤り|間違|older|empiri"
    r"|rule of thumb|faustformel|mistook|often written",
    re.IGNORECASE,
)
"""Words with which a formula may be shown that is not the right one."""
_USUAL = {"a": ACCELERATION, "b": ACCELERATION, "v": SPEED, "x": PATH, "s": PATH}
"""Letters of motions, where several are named at once, or none near."""


@dataclass(frozen=True, slots=True)
class _Kind:
    """A motion, the words that name it, and whether they leave no doubt."""

    name: str
    words: str
    is_sure: bool


class NamedMotion(NamedTuple):
    """A motion that words name, the places that it may be at, and whether that is sure."""

    kind: str
    places: tuple[str, ...]
    words: str
    is_sure: bool
    may_be_other: bool = False
    """Whether the dead centre may be the other one: inner and outer are called so from either end."""


class Head(NamedTuple):
    """A left side: a letter, the function that it stands in, and how often it is differentiated."""

    function: str
    name: str
    order: int

    @property
    def stem(self) -> str:
        """The letter without its index."""
        return self.name.partition("_")[0]


class _Texts(NamedTuple):
    """The words around a relation, from the nearest on."""

    clause: str
    since: str
    """All words since the relation before."""
    sentence: str
    """The sentence up to the relation, with other relations in it."""
    behind: str
    row: str
    """The first cell of its row in a table, with the head of its column."""
    heading: str

    @property
    def near(self) -> tuple[str, ...]:
        """The texts in which a motion may be named, the nearest first."""
        texts = (self.row,) if self.row else (self.clause, self.behind.split(",")[0], self.since)
        if not self.row and sum(map(str.isalpha, self.since)) <= BARE:
            texts = (*texts, _plain(self.sentence))  # at θ = 90°: α = …
        return tuple(text for text in texts if text.strip())


@dataclass
class NamedMotions:
    """What the words of one page name; which letter was which motion is its state."""

    document: ReadNotes
    sections: Sections
    kinds: dict[tuple[str, int], str] = field(default_factory=dict)
    """The motions of letters without their index, by how often they are differentiated."""
    spots: dict[str, tuple[str, ...]] = field(default_factory=dict)
    """Places at which words put a letter."""
    directions: dict[tuple[str, int], int] = field(default_factory=dict)
    """The direction in which a letter's motion was counted first: it stays that one."""

    @cached_property
    def glossary(self) -> Glossary:
        """The English terms of the page's language."""
        return glossary_of(self.document.text)

    @cached_property
    def page(self) -> str:
        """The text of the page with its terms in English."""
        return self.glossary.english(self.document.text)

    def named(self, chain: Chain, head: Head, claim: Formula, declared: str = "") -> NamedMotion | None:
        """Return the motion that the words around a relation name, with its places; None for none.

        `declared` is what a symbols file says of the letter: it names the motion where no words do.
        """
        texts = self._texts(chain)
        is_doubted = _DOUBTS.search(f"{texts.clause} {texts.behind}") is not None
        kind = None if is_doubted else self._kind(texts, head, claim, declared)
        if kind is None:
            return None
        is_turned = any(isinstance(part, Call) and part.function in WAVES for part in walk(claim))
        spots = self._spots(texts, head.name.partition("_")[2], kind.name, is_turned=is_turned)
        if head.function and angle_rank(head.name) < angle_rank("psi") and kind.name not in OF_ROD:
            around = f"{texts.since} {texts.heading} {texts.sentence}"
            kind = replace(kind, name=_crank_angle(around, kind.name, spots), is_sure=True)
        if not kind.name or (head.function and kind.name not in (ROD_ANGLE, FASTEST, HALF, HUMP)):
            return None
        words = " ".join(self.glossary.own_words(kind.words).split())[-60:].strip(" ,:;([|")
        if is_turned and kind.name in TURNED:
            return NamedMotion(kind.name, ("",), words, kind.is_sure)
        if kind.name in (STROKE, FASTEST, HALF, HUMP):
            places = tuple(spots) if self.is_offset and kind.name == FASTEST else ("",)
            return NamedMotion(kind.name, places, words, kind.is_sure)
        if {TOP, BOTTOM} & {*spots}:
            spots = [spot for spot in spots if not spot.startswith("~")]  # the outer (upper) dead centre
        may_be_other = any(spot.startswith("~") for spot in spots)
        spots = [spot.removeprefix("~") for spot in spots]
        if spots == [""] or (len(spots) > 1 and "" in spots):
            spots = [TOP, BOTTOM]
        places = tuple(spots) or self.spots.get(head.name, ())
        return NamedMotion(kind.name, places, words, kind.is_sure, may_be_other) if places else None

    def words_of(self, chain: Chain) -> str:
        """Return the words that name a number and its place."""
        texts = self._texts(chain)
        if texts.row:
            return texts.row
        words = texts.clause if motions_named(texts.clause) else texts.since
        return f"{words} {texts.sentence}"

    def clause(self, chain: Chain) -> str:
        """Return the words right before a relation."""
        return self._texts(chain).clause

    @cached_property
    def is_offset(self) -> bool:
        """Whether the page speaks of an offset line of stroke."""
        return HAS_OFFSET.search(self.page) is not None

    def _kind(self, texts: _Texts, head: Head, claim: Formula, declared: str) -> _Kind | None:
        """Return which motion is meant: "" where nothing names it, None where it is another body's."""
        by_dots = _by_dots(head.stem, head.order)
        usual = by_dots or _USUAL.get(head.stem, "")
        kind = _Kind("", "", is_sure=False)
        for text in texts.near:
            motions = motions_named(text, f"{texts.heading} {texts.sentence}")
            motions = [usual] if len({*motions}) > 1 and usual in motions else motions
            if motions:
                if names_another(text):
                    return None
                kind = _Kind(motions[-1], text, is_sure=True)
                break
        if not kind.name and names_another(texts.clause):
            return None
        if (
            by_dots
            and kind.name != by_dots
            and (kind.name in OF_ROD) != (by_dots in OF_ROD)
            and kind.name
        ):
            return None
        if by_dots and kind.name != by_dots:
            is_sure = bool(kind.name) or self._is_rod_angle(head.stem)
            return _Kind(by_dots, "the dots over the letter", is_sure=is_sure)
        if not kind.name and (motions := motions_named(declared)):
            kind = _Kind(motions[-1], declared, is_sure=True)
        if kind.name:
            return kind
        return self._kind_elsewhere(texts, head, claim, usual)

    def _kind_elsewhere(self, texts: _Texts, head: Head, claim: Formula, usual: str) -> _Kind:
        """Return which motion a letter is by lines above, a heading, or as is usual."""
        above = f"{plain_letter(head.stem)} above"
        if (head.stem, head.order) in self.kinds:
            return _Kind(self.kinds[head.stem, head.order], above, is_sure=True)
        motions = list(dict.fromkeys(motions_named(texts.heading)))
        motions = [usual] if usual in motions else motions
        if len(motions) == 1 and not names_another(texts.heading):
            return _Kind(motions[0], texts.heading, is_sure=True)
        angles = letters_in_waves(claim)
        if head.function and len(angles) == 1 and head.name not in angles:
            return _Kind(ROD_ANGLE, "its formula says so", is_sure=False)
        if angle_rank(head.stem) < len(OF_CRANK) and self._is_rod_angle(head.stem):
            return _Kind(ROD_ANGLE, above, is_sure=True)
        if not head.function and usual and usual in self._named_on_page:
            return _Kind(usual, "as is usual for this letter", is_sure=False)
        return _Kind("", "", is_sure=False)

    def _spots(self, texts: _Texts, index: str, kind: str, *, is_turned: bool) -> list[str]:
        """Return the places that words name, or the index of the letter."""
        behind = "" if texts.row else texts.behind.split(",")[0]
        spots = places_named(texts.row or texts.clause)
        if not {TOP, BOTTOM, RIGHT} & {*spots}:  # else the words behind may be the next relation's
            spots = places_named(f"{texts.row or texts.clause} {behind}", texts.sentence)
        spots = spots or places_named(texts.since)
        if not spots and not is_turned:
            spots = places_named(texts.heading)
        place, is_sure = place_of_index(index)
        if kind == SPEED and index in ("top", "t"):
            return spots or [LARGEST]
        return [place] if place and (is_sure or not spots) else spots

    def _texts(self, chain: Chain) -> _Texts:
        text, start = self.document.text, chain.start
        above = bisect_right(self._ends, start)
        first = max(start - BEFORE, 0, self._ends[above - 1] if above else 0)
        since = text[first:start].rstrip(_SET_OFF)
        sentence = _CELL_OR_SENTENCE.split(text[max(0, start - BEFORE) : start].rstrip(_SET_OFF))[-1]
        behind = _CELL_OR_SENTENCE.split(text[chain.end : chain.end + BEHIND])[0]
        heading = self.sections.heading_above(chain.lines[0])
        if (lead := _LEAD.search(self.document.text[max(0, start - BEFORE) : start])) is not None:
            heading = f"{heading}\n{lead[1]}"
        since = self.sections.phrases_in_order.of(chain) or since
        clause = _plain(_CELL_OR_SENTENCE.split(since)[-1])
        row, above_it = self._row(chain), _plain(heading)
        plain = (clause, _plain(since), sentence, _plain(behind), row, above_it)
        return _Texts(*map(self.glossary.english, plain))

    def _row(self, chain: Chain) -> str:
        """Return the first cell of a relation's row in a table and the head of its column, "" outside."""
        cell = self._cells.at(chain.start)
        return "" if cell is None else f"{_plain(cell.row)} {_plain(cell.column)}"

    @cached_property
    def _cells(self) -> TableCells:
        return cells_of(self.document.text)

    @cached_property
    def _ends(self) -> list[int]:
        """The places behind the relations, in their order."""
        return sorted(chain.end for chain in self.document.chains if chain.relations)

    @cached_property
    def _named_on_page(self) -> frozenset[str]:
        """The motions that words name anywhere."""
        return frozenset(motions_named(_plain(self.page)))

    @cached_property
    def _rod_angles(self) -> frozenset[str]:
        """The letters whose sine a line gives by the sine of another: β of sin β = λ sin θ."""
        letters = set[str]()
        for chain in self.document.chains:
            left = chain.sides[0].node
            if isinstance(left, Call) and left.function == "sin" and isinstance(left.argument, Name):
                name = left.argument.name
                if any(letters_in_waves(side.node) - {name} for side in chain.sides[1:]):
                    letters.add(name)
        return frozenset(letters)

    def _is_rod_angle(self, stem: str) -> bool:
        return stem in self._rod_angles


def _plain(words: str) -> str:
    return _MARKUP.sub(" ", words).strip()


def _crank_angle(words: str, kind: str, spots: list[str]) -> str:
    """Return which crank angle words name of which a page gives the sine or cosine; "" for none."""
    if _MIDWAY.search(words) and not HAS_OFFSET.search(words) and not _EXTREME.search(words):
        return HALF
    if HAS_OFFSET.search(words) or TOP in spots or BOTTOM in spots:
        return FASTEST
    if kind == ACCELERATION and _EXTREME.search(words):
        return HUMP
    return FASTEST if _FAST.search(words) and (_EXTREME.search(words) or "fast" in words) else ""


def _by_dots(stem: str, order: int) -> str:
    """Return the motion that dots over a letter make of it."""
    if stem in ("beta", "phi", "varphi", "psi", "gamma", "delta"):
        return {1: ROD_SPEED, 2: ROD_ACCELERATION}.get(order, "")
    return {1: SPEED, 2: ACCELERATION, 3: JERK}.get(order, "") if stem in ("x", "y", "z", "s") else ""
