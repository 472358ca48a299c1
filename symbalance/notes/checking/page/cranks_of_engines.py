"""Crank angles that an engine's name says: ΣF_1 = 0 "in the in-line four", whose throws nobody lists.

Engines in line and boxers have one usual crankshaft. It is taken where the sentence, the paragraph or the
heading names one such engine and no other; what rests on it says so. Words for another crankshaft, for
shafts that balance, or for a part of the engine leave the cranks open.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from symbalance.errors import SymbalanceError
from symbalance.notes.checking.declared.engines import KnownEngine, Sources
from symbalance.notes.checking.words.case_words import ENGINE, engine_of
from symbalance.notes.checking.words.crank_angles_listed import CrankAngles
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.checking.words.sentences import SENTENCE_END
from symbalance.text import lazy_patterns as re

_UNUSUAL = re.compile(
    r"two[\s-]?stroke|2[\s-]?stroke|zwei[\s-]?takt|2[\s-]?takt|2\s?サイクル|2\s?ストローク"
    r"|cross[\s-]?plane|クロスプレーン|T-?plane|big[\s-]?bang|uneven|odd[\s-]?fire|ungleich|不等|位相|挟み角"
    r"|(?:90|120|270|360)\s*(?:°|\^\s*\\?\{?\\circ\}?|degrees?|Grad|度)[\s-]*"
    r"(?:crank|Kurbel|Kröpf|クランク|twin)"
    r"|right\s+angles?|rechte[nrm]?\s+Winkel|rechtwinklig|直角"
    r"|(?:pins?|throws?|cranks?|kröpfungen|hubzapfen)\s+(?:are\s+|is\s+|sind\s+)?(?:set\s+|placed\s+|versetzt\s+)?(?:at|um)\b"
    r"|balanc(?:er|ing)|balance\s+shaft|lanchester|ausgleichs|gegengewicht|counter-?weight|バランサ|バランスシャフト"
    r"|カウンタ|釣合い?おもり|opposed[\s-]piston|gegenkolben|radial|sternmotor|星[型形]",
    re.IGNORECASE,
)
"""Words for a crankshaft that is not the usual one, or for more that acts than pistons."""
_PART = re.compile(
    r"\b(?:pairs?|half|halves|outer|inner|middle|front|rear|other|single|each|per)\b"
    r"|bearing|\bgas\b|\brods?\b|bolt|lager|gaskr|pleuel|軸受|ガス"
    r"|cylinders?\s+[0-9]\s*(?:,|and|&|to|–|-)|\bone\s+(?:bank|cylinder)"
    r"|paar|hälfte|äußere|innere|vordere|hintere|mittlere|\bje\b|jede[rsnm]?\b|einzel"
    r"|zylinder\s+[0-9]\s*(?:,|und|bis|–|-)|1\s*気筒あたり|片側|半分|外側|内側|中央|一対|各",
    re.IGNORECASE,
)
"""Words for a part of an engine's cylinders, over which a sum may go, or for other forces."""
_BANKS = re.compile(
    r"(?<![A-Za-z])(?:V|W|VR)[-\s]?(?:[0-9]{1,2}(?![0-9])|engine|twin|motor|型)|(?<![A-Za-z])bank"
    r"|Gabelmotor|バンク",
    re.IGNORECASE,
)
_ROW = re.compile(r"^[ \t]*\|", re.MULTILINE)
_LONGEST, _TITLE = 400, 3
"""Characters of a sentence that are looked through, and lines of a page that may be its title."""
FEWEST, FULL_TURN = 3, 360
"""An engine in line with two cylinders has its cranks at 0° or at 180°: its name says too little."""
_USUALLY_IN_LINE = (3, 4)
"""Numbers of cylinders by which an engine is in line where nothing else is said of it."""
_ONE_CRANK = 4
"""The engine in line whose usual crank is not that of evenly spaced throws."""


@dataclass
class CranksOfEngines:
    """The engines that one page names, with their usual cranks; the engines are looked up once."""

    text: str
    sections: Sections
    sources: Sources

    @cached_property
    def _mentions(self) -> list[tuple[int, str]]:
        """The engines that the page names, and where."""
        return sorted(self.sources.engines.mentions(self.text))

    def at(self, start: int, end: int, line: int) -> CrankAngles | None:
        """Return the usual cranks of the engine that a relation is of; None where none is plainly named.

        `start` and `end` are where the relation stands, `line` is its line.
        """
        for first, last in self._scopes(start, end, line):
            names = {name for place, name in self._mentions if first <= place < last}
            if not names and (bare := self._by_number_alone(first, last, line)) is not None:
                return bare
            if not names:
                if self._names_another(first, last, None):
                    return None
                continue
            own = "" if len(names) > 1 else next(iter(names))
            return self._cranks(own, first, last, line) if own else None
        return None

    def _by_number_alone(self, first: int, last: int, line: int) -> CrankAngles | None:
        """Return the cranks of a three- or four-cylinder engine that nothing says to have banks."""
        engines = self.sections.named_engines.between(first, last)
        if len({engine.key for engine in engines}) != 1 or engines[0].cylinders not in _USUALLY_IN_LINE:
            return None
        engine, words = engines[0], self.text[first:last]
        section = self._section(line, words)
        is_other = engine.is_boxer or _BANKS.search(section) or _UNUSUAL.search(section)
        if is_other or _PART.search(words) or self._names_another(first, last, None, engine.cylinders):
            return None
        stars = self.sections.named_engines.with_stars(engine, first, last, "", words).stars
        if len(stars) != 1 or stars[0].signs:
            return None
        own, count = tuple(map(Fraction, stars[0].degrees)), engine.cylinders
        arms = tuple(Fraction(2 * k - count + 1, 2) for k in range(count))
        at = self.text.count("\n", 0, engine.place) + 1
        return CrankAngles(own, at, engine.place, is_usual=True, arms=arms)

    def _scopes(self, start: int, end: int, line: int) -> Iterator[tuple[int, int]]:
        """Yield where an engine may be named, the nearest first: sentence, paragraph, section, title."""
        floor = max(0, start - _LONGEST)
        before = [m.end() for m in SENTENCE_END.finditer(self.text, floor, start)]
        behind = SENTENCE_END.search(self.text, end, min(len(self.text), end + _LONGEST))
        line_start = self.text.rfind("\n", 0, start) + 1
        if _ROW.match(self.text, line_start):
            line_end = self.text.find("\n", end)
            yield line_start, len(self.text) if line_end < 0 else line_end
            return
        yield (
            (before[-1] if before else floor),
            (behind.start() if behind else min(len(self.text), end + _LONGEST)),
        )
        starts = self._line_starts
        yield starts[self.sections.paragraph_start(line) - 1], start
        yield starts[self.sections.section_start(line) - 1], start
        yield 0, min(starts[min(_TITLE, len(starts) - 1)], start)

    @cached_property
    def _line_starts(self) -> list[int]:
        return [0, *(k + 1 for k, c in enumerate(self.text) if c == "\n")]

    def _cranks(self, name: str, first: int, last: int, line: int) -> CrankAngles | None:
        """Return the usual cranks of an engine, unless the words around say more of it."""
        try:
            engine = self.sources.engines.engine(name, self.sources.folder)
        except SymbalanceError:
            return None  # named in prose, and no engine that is known: no fault of the page's
        section = self._section(line, self.text[first:last])
        if (
            self._names_another(first, last, engine)
            or _UNUSUAL.search(section)
            or _PART.search(self.text[first:last])
        ):
            return None
        return usual_cranks(
            engine, self.text.count("\n", 0, self._place(name, first)) + 1, self._place(name, first)
        )

    def _place(self, name: str, first: int) -> int:
        return next(place for place, own in self._mentions if own == name and place >= first)

    def _section(self, line: int, own: str) -> str:
        """Return the section that a line stands in; of a table only the row that a relation is in."""
        first, end = self.sections.section_start(line), self.sections.section_end(line)
        starts = [*self._line_starts, len(self.text)]
        section = self.text[starts[first - 1] : starts[min(end, len(starts) - 1)]]
        if not _ROW.match(own):
            return section
        return "\n".join([own, *(row for row in section.split("\n") if not _ROW.match(row))])

    def _names_another(
        self, first: int, last: int, engine: KnownEngine | None, count: int | None = None
    ) -> bool:
        """Tell whether words name an engine that is not the known one: other cylinders, or banks."""
        words = self.text[first:last]
        count = count if engine is None else len(engine.cylinders)
        others = [
            named[0] for m in ENGINE.finditer(words) if (named := engine_of(m)) and named[0] != count
        ]
        return bool(others) or _BANKS.search(words) is not None


def usual_cranks(engine: KnownEngine, line: int, place: int) -> CrankAngles | None:
    """Return the crank angles of an engine whose name says them; None for one with banks, or for a twin.

    An engine that may be of either stroke has the evenly spaced crank as the other.
    """
    count = len(engine.cylinders)
    axes = [cylinder.bank.turns for cylinder in engine.cylinders]
    is_boxer = len(set(axes)) == 2 and abs(axes[0] - axes[-1]) == Fraction(1, 2)
    if len(set(axes)) > 1 and not is_boxer:
        return None
    if not is_boxer and count < FEWEST:
        return None
    signs = tuple(1 if axis == axes[0] else -1 for axis in axes) if is_boxer else ()
    own = tuple(c.delay.turns * FULL_TURN % FULL_TURN for c in engine.cylinders)
    others: tuple[CrankAngles, ...] = ()
    if not is_boxer and count > _ONE_CRANK:
        even = tuple(Fraction(FULL_TURN * k, count) for k in range(count))
        others = (CrankAngles(even, line, place, is_usual=True),)
    arms = tuple(c.station - engine.mean_station for c in engine.cylinders)
    return CrankAngles(own, line, place, is_usual=True, signs=signs, others=others, arms=arms)
