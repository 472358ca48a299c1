"""What words say a formula is of: which engine, which order, and whether its force or its couple.

The nearest words decide: those of the sentence, the paragraph or the table's row, the section, the title.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

from symbalance.document.formula import Call, Name, Summation, walk
from symbalance.notes.checking.meant.engines.order_indices import (
    POWERS,
    are_orders,
    index_of,
    wave_multiples,
    wave_of,
)
from symbalance.notes.checking.meant.meant_words import MeantWords
from symbalance.notes.checking.words.accuracies import introduces_aid, without_accuracies
from symbalance.notes.checking.words.crank_angles_listed import CrankAngles, crank_angles, listed_at
from symbalance.notes.checking.words.eights_in_banks import eight_named
from symbalance.notes.checking.words.engines_in_words import (
    CrankStar,
    EnginesInWords,
    NamedEngine,
    engines_of_label,
)
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.checking.words.sentences import SENTENCE_END, bare
from symbalance.notes.checking.words.working_cycles import strokes_named
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

FORCE, COUPLE, TORQUE = "force", "couple", "torque"
_ORDER = re.compile(
    "|".join(
        rf"(?P<n{n}>(?<![A-Za-z0-9.])(?:{pattern}))"
        for n, pattern in {
            1: r"first|primary|1st|erste[rsnm]?|1\.|I\.|premi(?:er|ère)|primer[ao]?|prim[oa](?![a-z])"
            r"|primeir[oa]|pierwsz\w+|prvního|eerste"
               r"|första|перв\w+|[一1１]\s?次|orders?\s(?:of\s)?(?:1|one)(?![0-9])|ordnung\s(?:1"
               r"|I)(?![0-9])",
            2: r"second(?![a-z])|secondary|2nd|zweite[rsnm]?|2\.|II\.|secondaire|deuxième|segund[oa]"
            r"|second[oa](?![a-z])"
               r"|drugi\w+|druhého|tweede|andra|втор\w+|[二2２]\s?次|orders?\s(?:of\s)?(?:2|two)(?![0-9])"
               r"|ordnung\s(?:2|II)(?![0-9])",
            4: r"fourth|4th|vierte[rsnm]?|4\.|IV\.|quatrième|cuart[oa]|quart[oa]|czwart\w+|vierde"
            r"|čtvrtého|fjärde|[四4４]\s?次"
               r"|orders?\s(?:of\s)?(?:4|four)(?![0-9])",
            6: r"sixth|6th|sechste[rsnm]?|6\.|VI\.|sixième|sext[oa]|sest[oa]|szóst\w+|zesde|[六6６]\s?次"
               r"|orders?\s(?:of\s)?(?:6|six)(?![0-9])",
            3: r"third|3rd|dritte[rsnm]?|3\.|troisième|tercer[ao]?|terz[oa]|fifth|fünfte|eighth"
            r"|[三八五3358]\s?次",
        }.items()
    ),
    re.IGNORECASE,
)  # fmt: skip
_ORDER_WORD = re.compile(
    r"order|harmonic|ordnung|harmonische|primary|secondary|ordre|secondaire|primaire|orden|ordine|ordem|rzędu|řádu"
    r"|\borde\b|ordning|порядк|次",
    re.IGNORECASE,
)
_COUPLE = re.compile(
    r"couples?(?![a-z])|moments?(?![a-z])|moment[eoia]?(?![a-z])|kippmoment|\bpar(?:\s"
    r"|\b)(?=de\s+inercia)|coppi[ae]"
    r"|偶力|モーメント|momentów|момент",
    re.IGNORECASE,
)
_FORCE = re.compile(
    r"forces?(?![a-z])|kraft(?![a-z])|kräften?(?![a-z])|fuerzas?|forz[ae]|forças?|sił[ay]?\b|s[ií]l[ay]?\b|kracht(?:en)?"
    r"|krafter?|慣性力|合力|сил[аы]"
    r"|massenkr|shaking|imbalance|unbalance",
    re.IGNORECASE,
)
_TORQUE = re.compile(
    r"torque|drehmoment|couple\s+moteur|par\s+motor|coppia\s+motrice|motorkoppel|obrotow|vridmoment"
    r"|točiv|krout|トルク|of\s+inertia\b(?!\s+(?:force|couple))|trägheitsm",
    re.IGNORECASE,
)
_ROTATING = re.compile(
    r"rotating|revolving|rotierend|umlaufend|回転(?:部分|質量)|tournant|rotante|rotativ|roterend|roterande|wirując|rotujíc|girante",
    re.IGNORECASE,
)
WHOLE = re.compile(
    r"\bfree\b|freie|resultant|resultier|\btotal|gesamt|\bsum\b|summe|合力|合計|全体|残[るっ]|whole|engine'?s\b"
    r"|adds?\s+(?:up|to)|sums?\s+(?:up\s+)?to|altogether|addieren\s+sich|s['’]ajoutent|s['’]additionnent|si\s+sommano|se\s+suman|不つり(?:合|あ)い|不釣り?(?:合|あ)?い"
    r"|remain|surviv|\bleft\b|bleib|resultante|totale|risultant|libre|\bliber|wypadkow|výsledn|celkov|całkowit|totaal|totale|together|zusammen"
    r"|insgesamt"
    r"|of\s+the\s+(?:whole\s+)?engine|of\s+the\s+motor|des\s+(?:ganzen\s+)?motors|du\s+moteur"
    r"|del\s+motore?|エンジン",
    re.IGNORECASE,
)
OF_ALL = re.compile(
    r"\bfree\b|freie|resultant|resultier|résultante|risultante|\btotal|gesamt|whole|entire|合力|合計|全体"
    r"|des\s+ganzen|du\s+moteur|dell['’]intero|del\s+motore",
    re.IGNORECASE,
)
"""Words that make a force that of all cylinders together."""
_MACHINE_BEHIND = re.compile(
    r"[\s-]?(?:engine|motor|moteur|machine|maschine|機関|エンジン)", re.IGNORECASE
)
"""What makes one cylinder an engine of its own: a single-cylinder engine."""
_AND = re.compile(r"\b(?:and|und|et|y|ed?|en)\b")
"""Words behind which something else is said."""
_ITS = re.compile(
    r"\b(?:its|sein[e]?|ihr[e]?|dessen|deren|dieser?s?|sa|son|leur|su|sua|il\s+suo|la\s+sua|questa|esta"
    r"|cette)\s+(?:\w+\s+){0,2}?(?:amplitude|magnitude|maximum|peak|size|amount|length|value|largest|"
    r"betrag|größe|höchstwert|amplitud|ampiezza|valeur|valore?|módulo|modulo|module|grandeur|intensit\w+)"
    r"|(?:その|この)(?:大きさ|振幅|最大値|値|力|偶力)",
    re.IGNORECASE,
)
"""Words for the size of what the sentence before speaks of."""
_CLAUSES = re.compile(r"[,;:](?=\s)|、|\b(?:but|and|aber|und|mais|et|ma|pero|y|e|while|sondern)\b")
_NO_WORD = re.compile(
    r"(?:[\W\d_]|すなわち|よって|したがって|\b(?:so|thus|hence|i\.e|also|d\.h|donc)\b)*", re.IGNORECASE
)
_LABEL_OF_ORDER = re.compile(
    r"[\s$(]*([1246]|I{1,2}|IV|VI)[\s.$):]*(?:st|nd|th|\.?\s?order|\.\s?Ordnung|次)?[\s$)]*$"
)
"""What the first cell of a row is, where the first column is of orders."""
_ROMAN = {"I": "1", "II": "2", "IV": "4", "VI": "6"}
_MOST = 400
_TITLE, _FURTHEST_TITLE = 3, 12
"""Lines that may hold a page's title, and before which its first heading stands."""
_FEWEST_TOGETHER = 2
_SENTENCE, _INTRODUCED, _PARAGRAPH, _HEADING, _SECTION, _PAGE_TITLE = range(6)
"""The stretches that may name a formula's engine, the nearest first."""
_INDEXED = frozenset({"M", "C", "F", "P", "R", "K"})
"""Letters of forces and couples whose index may be an order."""
_OF_SOME = re.compile(
    r"\b(?:of|for|von|für|bei)\s+(?:two|three|four|five|six|eight|both|zwei|drei|vier|sechs|beiden?)\b",
    re.IGNORECASE,
)
"""Words for another number of cylinders than the paragraph's: "of two in phase"."""
VECTORS = re.compile(
    r"(?:sum|resultant|summe|合計)[^.;=]{0,40}(?:vectors|phasors|zeiger|vektoren|ベクトル)|(?:vector"
    r"|phasor|zeiger|ベクトル)[\s-]?(?:sum|summe|和)",
    re.IGNORECASE,
)


OF_ONE = re.compile(
    r"\b(?:per|each|every|one|single)[\s-]+(?:cylinder|piston|unit|pot)|\bper\s+cyl|a\s+(?:single"
    r"|lone)\s|of\s+a\s+piston"
    r"|(?:pro|je|eines|einen|einem|jeder|jedes|jeden)\s+(?:einzelnen\s+)?(?:zylinder|kolben)"
    r"|einzylinder|einzelne[rnms]?\s"
    r"|chaque\s+(?:cylindre|piston)|par\s+cylindre|cada\s+(?:cilindro|pist)|por\s+cilindro"
    r"|ogni\s+cilindro|per\s+cilindro"
    r"|ciascun|każd\w+\s+cylind|1\s*気筒|各気筒|単気筒|一気筒|of\s+(?:one|the\s+[ijk]-?th)",
    re.IGNORECASE,
)
"""Words of what one cylinder or each of them does."""
_IN_LINE = re.compile(r"(?<![A-Za-z])(?:in-?line|straight|reihen|[RL]-?[2-8])|直列", re.IGNORECASE)
"""Words in the name of an engine that is no boxer."""


@dataclass(frozen=True, slots=True)
class EngineClaim:
    """What words say a formula is of: an engine's free force or couple of an order."""

    engine: NamedEngine
    order: int
    kind: str
    words: str
    own: str
    """The words between the relations before and behind."""
    sentence: str
    around: str
    is_rotating: bool = False
    is_inferred: bool = False
    """Whether no words beside the formula name the order or the engine, but an index or others."""
    is_total: bool = False
    """Whether the formula is a sum over all cylinders, or another term of it is of all of them."""
    is_declared: bool = False
    """Whether the symbols file says of the letter what no words beside the formula do."""
    clause: str = ""
    """The sentence from the engine's name on, where that stands before the formula in it."""

    @property
    def is_in_phase(self) -> bool:
        """Whether all pistons' forces of an even order rise and fall with cos nθ, not with sin nθ.

        So does their couple, which is left of them in a boxer.
        """
        stars = self.engine.stars
        is_even = self.kind in (FORCE, COUPLE) and not self.order % 2 and not self.is_rotating
        phases = {degrees * self.order % 360 for star in stars for degrees in star.degrees}
        is_one_way = self.kind == COUPLE or not any(star.signs for star in stars)
        return is_even and phases == {0} and is_one_way and not any(star.is_radial for star in stars)

    def size(self, star: CrankStar) -> float:
        """Return how many times one cylinder's amplitude it is with one crankshaft."""
        return star.couple(self.order) if self.kind == COUPLE else star.force(self.order)

    def sizes(self) -> list[float]:
        """Return how many times one cylinder's amplitude it may be."""
        return sorted({self.size(star) for star in self.engine.stars})


@dataclass
class EngineClaims:
    """Reads what words say of the formulas of one page."""

    words: MeantWords
    sections: Sections

    @cached_property
    def engines(self) -> EnginesInWords:
        """The engines that the page names."""
        return self.sections.named_engines

    @cached_property
    def names_strokes(self) -> bool:
        """Whether the page names an engine of two or four strokes."""
        return bool(strokes_named(self._text))

    @cached_property
    def _crank_lists(self) -> tuple[CrankAngles, ...]:
        return crank_angles(self._text)

    @cached_property
    def usual_engines(self) -> list[NamedEngine]:
        """The engines that the page names anywhere, each with the cranks that are usual for it."""
        keys = {named.key: named for named in self.engines.mentions}
        return [self.engines.with_stars(named, 0, 0, "", "") for named in keys.values()]

    @property
    def _text(self) -> str:
        return self.words.document.text

    @cached_property
    def _last_of_title(self) -> int:
        """The last line of the title: that of the first heading, where that stands a little below."""
        first = next(iter(self.sections.heading_lines), 0)
        return first if _TITLE < first <= _FURTHEST_TITLE else _TITLE

    @cached_property
    def _line_starts(self) -> list[int]:
        return [0, *(k + 1 for k, c in enumerate(self._text) if c == "\n"), len(self._text)]

    def may_name(self, chain: Chain) -> bool:
        """Tell whether the page names an engine, or a relation stands in a table, whose labels may."""
        return bool(self.engines.every) or self.words.cells.at(chain.start) is not None

    def claim(self, name: str, chain: Chain) -> EngineClaim | None:
        """Return what words say of the formula that a letter is given; None where they leave it open."""
        if name.startswith("Delta_") or name.endswith("_rms"):
            return None
        start, end = chain.start, chain.end
        before, behind, sentence, own = self._words_around(chain, start, end)
        heading = self.sections.heading_above(chain.lines[0])
        if not index_of(name) and introduces_aid(self._text[:start][-_MOST:]):
            return None
        order, source = 0, ""
        title = self._text[: self._line_starts[1]]
        above = self._clause_of_pronoun(before, start)
        for words in map(without_accuracies, (before, behind, above, heading, title)):
            if _ORDER_WORD.search(words) and (order := _order_in(words, name)):
                source = words
                break
        if not order:
            order, source = self._order_otherwise(name, chain, before, sentence)
        is_inferred = not order or not _fits_index(name, order)
        if is_inferred:
            order, source = self._order_by_index(name, chain), ""
        declared = self._declared(name, chain, order) if is_inferred else ""
        order, is_inferred = _order_in(declared, name) or order, is_inferred and not declared
        source = declared or source
        kind = next((k for w in (before, behind, source) if (k := _kind_in(w, name))), "")
        is_rotating = _ROTATING.search(before) is not None
        if is_rotating and not order:
            order, source = 1, before
        kind = kind or (FORCE if VECTORS.search(sentence) else "")
        kind = kind or _kind_by_letter(name) or _kind_in(heading, name)
        if self._is_of_torque(name, chain, f"{before} {source}"):
            order, kind = (order or index_of(name)) if _ORDER_WORD.search(before) else 0, TORQUE
        if not order or not kind or not _fits_index(name, order):
            return None
        engine = self._engine(chain, start, end)
        by_labels = self._engine_of_cell(start) if is_inferred else None
        if by_labels is not None and index_of(name):
            is_inferred, source = False, by_labels[1]
        if engine is None:
            engine, is_inferred = self._nearest_engine(chain, start, end), True
        if engine is None:
            return None
        paragraph = self._text[self._line_starts[self.sections.paragraph_start(chain.lines[0]) - 1] : end]
        around = f"{heading} {paragraph} {sentence}"
        words, is_sum = _plain(source), isinstance(chain.sides[0].node, Summation)
        clause = self._text[max(engine.place, start - _MOST) : end] if engine.place < start else sentence
        return EngineClaim(
            engine, order, kind, words, own, sentence, around, is_rotating, is_inferred, is_sum,
            bool(declared), clause,
        )  # fmt: skip

    def _declared(self, name: str, chain: Chain, order: int) -> str:
        """Return what a letter is declared as, if that names an order, and not of one cylinder.

        The order of its index has to be the same.
        """
        text = without_accuracies(self.words.declarations.symbols_at(chain.lines[0]).get(name, ""))
        is_of_order = _ORDER_WORD.search(text) is not None and bool(_order_in(text, name))
        is_of_order = is_of_order and order in (0, _order_in(text, name))
        return text if is_of_order and not OF_ONE.search(text) else ""

    def _is_of_torque(self, name: str, chain: Chain, words: str) -> bool:
        """Tell whether a letter is said to be a torque, or is one where its section has nothing else."""
        if _TORQUE.search(words) or _kind_by_letter(name) != COUPLE or _COUPLE.search(words):
            return _TORQUE.search(words) is not None
        section = self.section(chain)
        return _TORQUE.search(section) is not None and _COUPLE.search(section) is None

    def _clause_of_pronoun(self, before: str, start: int) -> str:
        """Return what "its amplitude" is of: the last clause with one order in the sentence before.

        "" where the words before a formula have no such pronoun, or name what they are of themselves.
        """
        if not _ITS.search(before) or _ORDER_WORD.search(before):
            return ""
        first, _ = self._sentence(self._opening(start), start)
        above = self._text[self._sentence(max(first - 2, 0), first)[0] : first]
        clauses = [c for c in _CLAUSES.split(above) if _ORDER_WORD.search(c) and _ORDER.search(c)]
        return clauses[-1] if clauses else ""

    def _order_by_index(self, name: str, chain: Chain) -> int:
        """Return the order that a letter's index says, or the wave of its formula; 0 for none.

        An index is an order where the page's indices are: F_2 = 4 λ m r ω² cos 2θ, M_II = √3 λ a F.
        """
        stem = name.removeprefix("hat_").partition("_")[0].rstrip("0123456789")
        index = index_of(name)
        if stem not in _INDEXED:
            return 0
        multiples = wave_multiples(chain.sides[1].node)
        if not index and multiples and multiples <= POWERS.keys():
            return min(multiples)
        is_order = index in POWERS and are_orders(self.words.document.chains)
        return index if is_order else 0

    def engine_of(self, chain: Chain) -> NamedEngine | None:
        """Return the engine that a relation is of, None where words name none or several."""
        return self._engine(chain, chain.start, chain.end)

    def listed(self, chain: Chain) -> CrankAngles | None:
        """Return the crank angles that the page lists for a relation, of engines with two banks too."""
        same = self.sections.same_section
        return listed_at(self._crank_lists, chain.start, self._text, same, of_pins=True)

    def sentence(self, chain: Chain) -> str:
        """Return the sentence that a relation stands in, with what stands before a display."""
        first, last = self.sentence_place(chain)
        return self._text[first:last]

    def words_before(self, chain: Chain) -> tuple[str, str]:
        """Return the words of a relation's sentence before it, and the sentence before that one."""
        start = self._opening(chain.start)
        first, _ = self._sentence(start, chain.end)
        above, _ = self._sentence(max(first - 2, 0), first)
        return self._text[first:start], self._text[above:first]

    def orders_before(self, chain: Chain) -> set[int]:
        """Return the orders that the sentence of a relation names before it, or the one before that."""
        start = self._opening(chain.start)
        first, _ = self._sentence(start, chain.end)
        above = self._text[self._sentence(max(first - 2, 0), first)[0] : start]
        for words in map(without_accuracies, (self._text[first:start], above)):
            if _ORDER_WORD.search(words) and (
                orders := {int((m.lastgroup or "n0")[1:]) for m in _ORDER.finditer(words)}
            ):
                return orders & {1, 2, 4, 6} if 3 not in orders else set()
        return set()

    def section(self, chain: Chain) -> str:
        """Return the section that a relation stands in."""
        first, last = (
            f(chain.lines[0]) for f in (self.sections.section_start, self.sections.section_end)
        )
        return self._text[
            self._line_starts[first - 1] : self._line_starts[min(last, len(self._line_starts) - 1)]
        ]

    def sentence_place(self, chain: Chain) -> tuple[int, int]:
        """Return where the sentence of a relation begins and ends."""
        return self._sentence(self._opening(chain.start), chain.end)

    def section_before(self, chain: Chain) -> str:
        """Return what a relation's section says before it."""
        first = self._line_starts[self.sections.section_start(chain.lines[0]) - 1]
        return self._text[first : chain.start]

    def _order_otherwise(self, name: str, chain: Chain, before: str, sentence: str) -> tuple[int, str]:
        """Return the order that an index or the formula's wave says, where it is of the whole engine."""
        if not WHOLE.search(sentence) and not WHOLE.search(before):
            return 0, ""
        waves = [
            p for p in walk(chain.sides[1].node) if isinstance(p, Call) and p.function in ("cos", "sin")
        ]
        number = wave_of(waves[0])[0] if len(waves) == 1 else 0
        if number in POWERS and not index_of(name):
            return number, before
        stem, index = name.partition("_")[0], index_of(name)
        heads = {
            c.sides[0].node.name for c in self.words.document.chains if isinstance(c.sides[0].node, Name)
        }
        indices = {index_of(n) for n in heads if n.partition("_")[0] == stem}
        is_order = (
            index in (1, 2)
            and indices <= {1, 2, 4, 6}
            and (_COUPLE.search(before) or _FORCE.search(before))
        )
        return (index, before) if is_order else (0, "")

    def _words_around(self, chain: Chain, start: int, end: int) -> tuple[str, str, str, str]:
        """Return the clause before a formula, words behind it, its sentence, and its own part of it."""
        start, first, last = self._with_introduction(start, end)
        others = [c for c in self.words.document.chains if c is not chain and c.relations]
        earlier = max((c.end for c in others if first <= c.end <= start), default=first)
        later = min((c.start for c in others if end <= c.start < last), default=last)
        if (cell := self.words.cells.at(start)) is not None:
            earlier = min(max(earlier, cell.start), start)
        before = without_accuracies(self._text[earlier:start])
        clause = re.split(rf"[,;:、](?=\s|\$)|{_AND.pattern}", before)
        before = next((c for c in clause[:0:-1] if _ORDER_WORD.search(c)), before)
        if header := self.words.header_of_column(chain):
            before = f"{header} {self._row_label(start)} {before}"
        behind, own = self._text[end : min(later, end + 90)], self._text[earlier:start]
        following = _AND.split(behind)[0]
        return before, following, self._text[first:last], f"{own} {behind}"

    def _with_introduction(self, start: int, end: int) -> tuple[int, int, int]:
        """Return where a formula's words end, and where its sentence begins and ends.

        A formula that is a sentence of its own is of what the one before says.
        """
        start = self._opening(start)
        first, last = self._sentence(start, end)
        if _NO_WORD.fullmatch(self._text, first, start):
            first = self._sentence(max(first - 2, 0), first)[0]
        return start, first, last

    def _opening(self, start: int) -> int:
        """Return where the words end that a formula is set off from, by a line of its own or by signs."""
        floor = max(0, start - _MOST)
        words = bare(self._text[floor:start])
        return start if words.endswith((".", "!", "?", "。")) else floor + len(words)

    def _row_label(self, start: int) -> str:
        """Return what the first cell of a table's row says, as an order where its column is of orders."""
        cell = self.words.cells.at(start)
        if cell is None:
            return ""
        number = _LABEL_OF_ORDER.match(cell.row)
        is_order = number is not None and _ORDER_WORD.search(cell.rows)
        return (
            f"{cell.rows} order {_ROMAN.get(number[1], number[1])}" if number and is_order else cell.row
        )

    def _sentence(self, start: int, end: int) -> tuple[int, int]:
        floor = max(0, start - _MOST)
        ends = [m.end() for m in SENTENCE_END.finditer(self._text, floor, start)]
        behind = SENTENCE_END.search(self._text, end, min(len(self._text), end + _MOST))
        return (ends[-1] if ends else floor), (
            behind.start() if behind else min(len(self._text), end + _MOST)
        )

    def _engine(self, chain: Chain, start: int, end: int) -> NamedEngine | None:
        """Return the engine that a relation is of: of its sentence, paragraph, section or title."""
        line, at = chain.lines[0], self._line_starts
        section = at[self.sections.section_start(line) - 1]
        section_end = at[min(self.sections.section_end(line), len(at) - 1)]
        heading_end = at[min(self.sections.section_start(line), len(at) - 1)]
        title_end = at[min(self._last_of_title, len(at) - 1)]
        scopes = [
            self._sentence(start, end), self._with_introduction(start, end)[1:],
            (at[self.sections.paragraph_start(line) - 1], start),
            (section, heading_end), (section, start), (0, min(title_end, start)),
        ]  # fmt: skip
        is_of_all = self._is_of_all(chain)
        by_labels = self._engine_of_cell(start)
        if by_labels is not None:
            engine, near = by_labels
            return engine and self._with_cranks(engine, start, (section, section_end), near, near)
        for scope, (first, last) in enumerate(scopes):
            is_own = scope in (_SENTENCE, _INTRODUCED)
            own_last = self._end_of_own_words(chain, end, last) if is_own else last
            named = _without_units(self.engines.between(first, own_last), start, is_of_all=is_of_all)
            named = self._nearer(named, start) if is_own else named
            if scope == _INTRODUCED and _OF_SOME.search(self._text, *scopes[_SENTENCE]):
                return None
            if self.engines.has_banks(first, last):
                return eight_named(self.engines, first, last, self._text[section:heading_end])
            if not named:
                continue
            engine = _only_one(named)
            if engine is None or (scope > _HEADING and _only_one(self._of_several(start)) is None):
                return None
            title = "" if scope < _PAGE_TITLE and section > 0 else self._text[:title_end]
            around = f"{title}\n{self._text[section:heading_end]}"
            cell = self.words.cells.at(start)
            near = (cell and cell.row) or self._text[slice(*self._sentence(start, end))]
            return self._with_cranks(engine, start, (section, section_end), around, near)
        return None

    def _is_of_all(self, chain: Chain) -> bool:
        """Tell whether a relation's sentence speaks of all cylinders together, and not of one of them."""
        sentence = self.sentence(chain)
        if not OF_ALL.search(sentence) or OF_ONE.search(sentence):
            return False
        last = self.engines.last_before(max(0, chain.start - _MOST), chain.start)
        if last is None or last.cylinders != 1:
            return True
        is_machine = _MACHINE_BEHIND.match(self._text, last.place + len(last.words)) is not None
        return not is_machine and re.search(r"[\s-]", last.words) is not None

    def _of_several(self, start: int) -> list[NamedEngine]:
        """Return the mentions before a place of engines with more than one cylinder."""
        return [named for named in self.engines.between(0, start) if named.cylinders != 1]

    def _engine_of_cell(self, start: int) -> tuple[NamedEngine | None, str] | None:
        """Return the engine that the row or the column of a table's cell is of, with their words.

        No engine where other columns are of engines; None where the table's labels name none.
        """
        cell = self.words.cells.at(start)
        if cell is None:
            return None
        near = " ".join(label.text for label in cell.labels)
        named = [(engines_of_label(label.text), label) for label in cell.labels]
        found = [(each, label) for mentions, label in named for each in mentions]
        if not found:
            is_of_others = any(engines_of_label(label.text) for label in cell.others)
            return (None, near) if is_of_others and cell.column else None
        engine = _only_one([each for each, _ in found])
        if engine is None or EnginesInWords(near).has_banks(0, len(near)):
            return None, near
        return replace(engine, place=found[0][1].span[0]), near

    def _end_of_own_words(self, chain: Chain, end: int, last: int) -> int:
        """Return where the words of a relation end: before a later line with one of its own."""
        line = self._line_starts[chain.lines[-1]] if chain.lines[-1] < len(self._line_starts) else last
        later = [c.start for c in self.words.document.chains if c.relations and c.start >= max(line, end)]
        return min(last, line) if line >= end and later and min(later) < last else last

    def _nearer(self, named: list[NamedEngine], start: int) -> list[NamedEngine]:
        """Return of an engine in line and a boxer with as many cylinders the one that a formula is of.

        It is the last one named before the formula, if another formula stands between the two.
        """
        before = [each for each in named if each.place < start]
        lined = [e for e in named if not e.is_boxer and _IN_LINE.search(e.words)]
        if not before or not lined or len({e.is_boxer for e in named}) == 1:
            return named
        last = before[-1]
        others = [e.place for e in before if e.is_boxer != last.is_boxer]
        chains = self.words.document.chains
        is_apart = not others or any(max(others) < c.start < last.place for c in chains if c.relations)
        return [last] if is_apart else []

    def _nearest_engine(self, chain: Chain, start: int, end: int) -> NamedEngine | None:
        """Return the engine that the nearest sentence before a relation names, and alone."""
        line, at = chain.lines[0], self._line_starts
        section = at[self.sections.section_start(line) - 1]
        section_end = at[min(self.sections.section_end(line), len(at) - 1)]
        last = self.engines.last_before(max(section, start - _MOST), start)
        if last is None or not last.cylinders or _OF_SOME.search(self._text, *self._sentence(start, end)):
            return None
        first, sentence_end = self._sentence(last.place, last.place + len(last.words))
        if self.engines.has_banks(first, start):
            return None
        engine = _only_one(_without_units(self.engines.between(first, start), start))
        if engine is None or engine.cylinders < _FEWEST_TOGETHER:
            return None
        near = f"{self._text[first:sentence_end]} {self._text[slice(*self._sentence(start, end))]}"
        return self._with_cranks(engine, start, (section, section_end), "", near)

    def _with_cranks(
        self, engine: NamedEngine, start: int, section: tuple[int, int], around: str, near: str
    ) -> NamedEngine:
        """Return an engine with the cranks that its name, its section or a list says."""
        engine = self.engines.with_stars(engine, *section, around, near)
        listed = listed_at(self._crank_lists, start, self._text, self.sections.same_section)
        is_other = listed is None or listed.is_by_firing or len(listed.degrees) != engine.cylinders
        if listed is None or is_other or engine.is_boxer or any(s.is_radial for s in engine.stars):
            return engine
        return replace(engine, stars=(CrankStar(listed.degrees),))


def _without_units(named: list[NamedEngine], start: int, *, is_of_all: bool = False) -> list[NamedEngine]:
    """Return several mentions without the one cylinder that an engine's name comes behind.

    A force of the whole engine is of the one with several cylinders, though one cylinder's comes last.
    """
    last = next((m for m in reversed(named) if m.place < start), None)
    if last is None or (last.cylinders == 1 and not is_of_all):
        return named
    if last.cylinders == 1 and named[0].cylinders == 1:
        return named
    return [m for m in named if m.cylinders != 1]


def _only_one(named: list[NamedEngine]) -> NamedEngine | None:
    """Return the one engine of several mentions, None where they are of two."""
    twins = {m.turn for m in named if m.turn}
    keys = {(m.cylinders, m.is_boxer) for m in named}
    if len(keys) > 1 and len({m.cylinders for m in named}) == 1 and len(twins) <= 1:
        return next(m for m in named if m.is_boxer)
    if len(keys) != 1 or len(twins) > 1:
        return None
    return next((m for m in reversed(named) if m.turn), named[-1])


def _order_in(words: str, name: str) -> int:
    """Return the order that words name, by the letter's index where they name several; 0 for none."""
    numbers = {int((m.lastgroup or "n0")[1:]) for m in _ORDER.finditer(words)}
    if len(numbers) > 1:
        numbers &= {index_of(name)}
    number = numbers.pop() if len(numbers) == 1 else 0
    return number if number in POWERS else 0


def _fits_index(name: str, order: int) -> bool:
    return index_of(name) in (0, order)


def _kind_in(words: str, name: str) -> str:
    kinds = [k for k, pattern in ((COUPLE, _COUPLE), (FORCE, _FORCE)) if pattern.search(words)]
    by_letter = _kind_by_letter(name)
    return by_letter if by_letter in kinds else kinds[0] if kinds else ""


def _kind_by_letter(name: str) -> str:
    stem = name.removeprefix("hat_").partition("_")[0].rstrip("'0123456789")
    return COUPLE if stem in ("M", "C", "T") else FORCE if stem in ("F", "P", "R", "K") else ""


def _plain(words: str) -> str:
    return re.sub(r"\s+", " ", words).strip(" \n\t$,.;:、は\\([|*#")
