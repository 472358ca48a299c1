"""Free forces and couples of engines that words name: "the triple's second-order couple is √3 λ m r ω² a".

Where the words say an engine, an order, and whether a force or a couple is meant, the amplitude follows
from the cranks: |Σ e^{ikδ}| or |Σ z e^{ikδ}| times one cylinder's amplitude. A first formula that is one
product is compared with it:

    it is that amplitude, with or without cos kθ                        conditional on what the words say
    it has another number, another power of the ratio, another order    refuted, with what it should be
    anything else: two slips, a part, a balanced engine, a letter that
    may mean something else                                             None, a definition as before
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from math import isclose

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Number,
    Product,
    Quotient,
    names,
    walk,
)
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision, without_dots
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.meant.letter_roles import LetterRoles
from symbalance.notes.checking.meant.meant_words import NOBODY, MeantWords
from symbalance.notes.checking.meant.products import NoProductError, ProductOfPowers, product_of
from symbalance.notes.checking.repair.fixes import Repair, fix_of
from symbalance.notes.checking.verdicts import Verdict
from symbalance.notes.checking.words.crank_angles_listed import CrankAngles, crank_angles, listed_at
from symbalance.notes.checking.words.engines_in_words import CrankStar, EnginesInWords, NamedEngine
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading.equations import Chain, Side

FORCE, COUPLE = "force", "couple"
_POWERS = {1: 0, 2: 1, 4: 3, 6: 5}
_FIRST_TERMS = {1: Fraction(1), 2: Fraction(1), 4: Fraction(1, 4), 6: Fraction(9, 128)}
"""The leading term of the piston's acceleration by order: its power of r/l, and the number before it."""
_ROMAN = {"I": 1, "II": 2, "IV": 4, "VI": 6}
_ORDER = re.compile(
    "|".join(
        rf"(?P<n{n}>(?<![A-Za-z0-9.])(?:{pattern}))"
        for n, pattern in {
            1: r"first|primary|1st|erste[rsnm]?|1\.|I\.|premi(?:er|ère)|primer[ao]?|prim[oa](?![a-z])"
            r"|pierwsz\w+|eerste"
               r"|första|перв\w+|[一1１]\s?次|orders?\s(?:of\s)?(?:1|one)(?![0-9])|ordnung\s(?:1"
               r"|I)(?![0-9])",
            2: r"second(?![a-z])|secondary|2nd|zweite[rsnm]?|2\.|II\.|secondaire|deuxième|segund[oa]"
            r"|second[oa](?![a-z])"
               r"|drugi\w+|tweede|andra|втор\w+|[二2２]\s?次|orders?\s(?:of\s)?(?:2|two)(?![0-9])"
               r"|ordnung\s(?:2|II)(?![0-9])",
            4: r"fourth|4th|vierte[rsnm]?|4\.|IV\.|quatrième|cuart[oa]|quart[oa]|czwart\w+|vierde"
            r"|[四4４]\s?次"
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
    r"order|harmonic|ordnung|harmonische|primary|secondary|ordre|secondaire|primaire|orden|ordine|rzędu"
    r"|\borde\b|порядк|次",
    re.IGNORECASE,
)
_COUPLE = re.compile(
    r"couples?(?![a-z])|moments?(?![a-z])|moment[eoia]?(?![a-z])|kippmoment|\bpar(?:\s"
    r"|\b)(?=de\s+inercia)|coppi[ae]"
    r"|偶力|モーメント|momentów|момент",
    re.IGNORECASE,
)
_FORCE = re.compile(
    r"forces?(?![a-z])|kraft(?![a-z])|kräften?(?![a-z])|fuerzas?|forz[ae]|sił[ay]?\b|kracht(?:en)?"
    r"|krafter?|慣性力|合力|сил[аы]"
    r"|massenkr|shaking|imbalance|unbalance",
    re.IGNORECASE,
)
_TORQUE = re.compile(
    r"torque|drehmoment|トルク|of\s+inertia\b(?!\s+(?:force|couple))|trägheitsm", re.IGNORECASE
)
_ROTATING = re.compile(
    r"rotating|revolving|rotierend|umlaufend|回転(?:部分|質量)|tournant|rotante|rotativ", re.IGNORECASE
)
_PART = re.compile(
    r"\b(?:pairs?|half|halves|halved|outer|inner|middle|front|rear|single|each(?!\s+(?:crank\s?)?(?:pin"
    r"|throw))|every|per|both|either|component|twice|thrice"
    r"|times|double[ds]?|mean|average|rms|gas|rods?|bearings?|ratio|left\s+over|residual|component\w*"
    r"|per\s*cent)\b|%"
    r"|\b(?:one|a|two|three|another)\s+(?:cylinder|piston|crank|bank|throw)s?\b|cylinders?\s+[0-9]"
    r"|pistons?\s+[0-9]"
    r"|(?<!un)balanc(?:er|ing|ed|es|e\s+(?:shaft|weight|mass))|lanchester|counter-?(?:weight|balance"
    r"|rotat)|ausgleich|gegengewicht"
    r"|paar|hälfte|halbe|äußere|innere|vordere|hintere|mittlere|\bje\b|jede[rsnm]?\b|einzel"
    r"|eines\s+zylinders|restlich"
    r"|verbleibend|doppelte|zylinder\s+[0-9]|pleuel|lager\b|gaskr|komponente|restkraft|restmoment"
    r"|chaque|chacun|demi|moitié|équilibr|contrepoids|cada|mitad|contrapes|equilibr|ciascun|metà|każd"
    r"|połow"
    r"|釣合い?おもり|バランサ|バランスシャフト|カウンタ|残|各|1\s*気筒あたり|片側|半分|外側|内側|中央"
    r"|一対|成分|倍",
    re.IGNORECASE,
)
"""Words for a part or a multiple of what an engine's cylinders do, or for more that acts."""
_BALANCED = re.compile(
    r"balanc(?:er|ing|e\s+(?:shaft|weight|mass))|lanchester|counter-?(?:weight|balance|rotat)"
    r"|ausgleichs|gegengewicht"
    r"|contrepoids|contrapes|バランサ|バランスシャフト|カウンタ|釣合い?おもり",
    re.IGNORECASE,
)
_OF_ONE = re.compile(
    r"\b(?:per|each|every|one|single)[\s-]+(?:cylinder|piston|unit|pot)|\bper\s+cyl|a\s+(?:single"
    r"|lone)\s|of\s+a\s+piston"
    r"|(?:pro|je|eines|einen|einem|jeder|jedes|jeden)\s+(?:einzelnen\s+)?(?:zylinder|kolben)"
    r"|einzylinder|einzelne[rnms]?\s"
    r"|chaque\s+(?:cylindre|piston)|par\s+cylindre|cada\s+(?:cilindro|pist)|por\s+cilindro"
    r"|ogni\s+cilindro|per\s+cilindro"
    r"|ciascun|każd\w+\s+cylind|1\s*気筒|各気筒|単気筒|一気筒|of\s+(?:one|the\s+[ijk]-?th)",
    re.IGNORECASE,
)
_WHOLE = re.compile(
    r"\bfree\b|freie|resultant|resultier|\btotal|gesamt|\bsum\b|summe|合力|合計|全体|whole|engine'?s\b"
    r"|add\s+up|altogether"
    r"|remain|surviv|bleib|resultante|totale|risultant|libre|\bliber|wypadkow|together|zusammen"
    r"|insgesamt"
    r"|of\s+the\s+(?:whole\s+)?engine|of\s+the\s+motor|des\s+(?:ganzen\s+)?motors|du\s+moteur"
    r"|del\s+motore?|エンジン",
    re.IGNORECASE,
)
_TOTAL_MASS = re.compile(
    r"(?:total|all|whole|entire|complete|gesamte?n?|sämtliche[rn]?)\s+(?:\w+\s+){0,2}mass(?:e?s"
    r"|en?)?(?![a-z])|gesamtmasse"
    r"|mass(?:es)?\s+of\s+(?:all|both|the\s+(?:two|three|four|five|six))|masse\s+aller|全質量"
    r"|masse\s+totale|masa\s+total",
    re.IGNORECASE,
)
_FAR_APART = re.compile(
    r"(?:outer(?:most)?|end|total|overall|half|äußer\w*|halbe\w*|gesamt\w*|外側|全長|first\s+(?:and"
    r"|to)\s+(?:the\s+)?last|extr[eê]me?s)"
    r"|length\s+of\s+the\s+(?:block|engine|crank)|baulänge",
    re.IGNORECASE,
)
_PITCH_WORDS = re.compile(
    r"(?:cylinder|bore)s?[\s-]+(?:spacing|pitch|distance|centres?|centers?)|\bpitch\b|\bspacing\b"
    r"|\bdistances?\b"
    r"|distance\s+apart|(?:axial\s+)?offset|zylinderabst[aä]nd\w*|stichma(?:ß|ss)|abst[aä]nd\w*"
    r"|entraxes?|interass[ei]|rozstaw\w*"
    r"|気筒間(?:隔|距離)|シリンダ(?:ー)?間隔|ピッチ|distancia\s+entre|distanza\s+tra|cilinderafstand"
    r"|apart|bore\s+centres",
    re.IGNORECASE,
)
_MASSES, _RADII, _SPEEDS, _RODS = (
    frozenset(t.split()) for t in ("m M", "r R", "omega Omega w", "l L ell")
)
_ARMS = frozenset(
    ["a", "b", "c", "d", "e", "h", "p", "s", "x", "z", "i", "k", "A", "B", "D", "H", "L", "l", "t", "u"]
)
_AMPLITUDES = frozenset(["F", "P", "S", "Q", "K", "Z", "C", "R", "X", "T", "f", "p"])
_ANGLES = frozenset(["theta", "varphi", "phi", "vartheta", "alpha", "psi", "beta", "gamma"])
_RATIOS = frozenset({"lambda", "lam"})
_MOST = 400
_OPENING = re.compile(
    r"(?:\s|\$|\\\[|\\\(|\\begin\{[a-z]+\*?\}|\\displaystyle|&|</?(?:p|div|math|span|li)\b[^<>]{0,40}>"
    r"|`|>)+$"
)
"""What stands between words and the formula that is set off from them."""
_SENTENCE_END = re.compile(
    r"[.!?]\s+(?![IVX0-9]{1,3}\.|Ordnung|order)|[。；;]|\n\s*\n|\n#|\n\s*(?:[-*+]|[0-9]+[.)])\s|\n\s*\|"
    r"|\n(?=[^\n]*:\s*\n)|\\item|<li|<p\b"
)


@dataclass(frozen=True, slots=True)
class _Claim:
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

    def sizes(self) -> list[float]:
        """Return how many times one cylinder's amplitude it may be."""
        stars: tuple[CrankStar, ...] = self.engine.stars
        sizes = [s.couple(self.order) if self.kind == COUPLE else s.force(self.order) for s in stars]
        return sorted(set(sizes))


@dataclass(frozen=True, slots=True)
class _Parts:
    """Which letter of a formula is what, and what of it is not as it should be."""

    letter: Mapping[str, str]
    powers: Mapping[str, Fraction]
    slips: tuple[str, ...]
    has_amplitude: bool
    """Whether a letter is the amplitude of that order itself, its coefficient included."""
    missing: Fraction
    """By how much the power of the rod's ratio has to grow."""
    angle: str = ""

    @property
    def arm(self) -> str:
        """The letter of the cylinders' distance, "" for a force."""
        return self.letter.get("arm", "")


_BY_MEANING = {
    "crank radius": "radius", "rod length": "rod", "angular speed": "speed",
    "reciprocating mass": "mass",
    "rotating mass": "mass", "rod ratio l/r": "inverse", "crank ratio r/l": "ratio",
}  # fmt: skip
_BEHIND_PITCH = re.compile(
    r"(?:[\s,(:]|\b(?:of|the|two|between|neighbou?ring|adjacent|cylinders?|bores?|cent(?:re|er)s?"
    r"|throws?|pins?|der|den|des|zweier"
    r"|benachbarter|zylindern?|kröpfungen|de|des|du|la|le|les|entre|tra|i|dei|degli|cilindri|cilindros"
    r"|cylindres?|dos|os|el|van|cilinders)\b"
    r"|[をはがのと])*",
    re.IGNORECASE,
)
_VECTORS = re.compile(
    r"(?:sum|resultant|summe|合計)[^.;=]{0,40}(?:vectors|phasors|zeiger|vektoren|ベクトル)|(?:vector"
    r"|phasor|zeiger|ベクトル)[\s-]?(?:sum|summe|和)",
    re.IGNORECASE,
)
_WEIGHTED = re.compile(
    r"weighted|lever|moment|couple|gewichtet|hebel|mass|偶力|モーメント", re.IGNORECASE
)
_MASS_OF_ONE = re.compile(
    r"(?:mass|kg|reciprocating|oszillierend|masse)[^.;:,\n]{0,30}?\s(?:of|per|je|pro|d.un|par|por|eines"
    r"|einer)\s+(?:\w+\s+){0,3}(?:cylind\w+|piston|zylinders?|kolbens?)"
    r"|1\s?気筒(?:あたり|分)?の(?:往復|運動)(?:部分の)?質量",
    re.IGNORECASE,
)
_SUMMED = re.compile(r"\\sum|Σ|∑|_\{?[ijk]\b")
_IS = re.compile(
    r"\s*(?:is|being|denotes|be|ist|sei|bezeichnet|jest|oznacza|est|étant|es|è|は|を|\(|:|the\b)",
    re.IGNORECASE,
)
_KINDS = {
    "ratio": "exponent",
    "rod": "exponent",
    "mass": "exponent",
    "speed": "exponent",
    "radius": "exponent",
    "wave": "order",
}
_IN_A_CASE = re.compile(
    r"\b(?:if|when|where|speed|wenn|falls|doubles?|doubled|increas\w*|grows?)\b|のとき|の場合|same\s+as"
    r"|compared|vergl|than\b|wie\s+beim",
    re.IGNORECASE,
)
_OF_ANOTHER = re.compile(
    r"\b(?:divided|per\s+unit|relative|bezogen\s+auf\s+\$|ratio|normali[sz]ed|squared?)\b|比",
    re.IGNORECASE,
)


@dataclass
class EngineResultants:
    """Judges the free forces and couples of named engines on one page."""

    words: MeantWords
    sections: Sections

    @cached_property
    def _engines(self) -> EnginesInWords:
        return EnginesInWords(self._text)

    @cached_property
    def _crank_lists(self) -> list[CrankAngles]:
        return crank_angles(self._text)

    @property
    def _text(self) -> str:
        return self.words.document.text

    @cached_property
    def _roles(self) -> LetterRoles:
        return LetterRoles(self._text)

    @cached_property
    def _line_starts(self) -> list[int]:
        return [0, *(k + 1 for k, c in enumerate(self._text) if c == "\n"), len(self._text)]

    def judge(self, chain: Chain, k: int, knowledge: Knowledge) -> Verdict | Decision | None:
        """Return the verdict on a relation that gives a letter a formula; None for others."""
        head = chain.sides[0].node
        head = head.argument if isinstance(head, Call) and head.function == "abs" else head
        if k or not isinstance(head, Name) or chain.relations[0].sign not in "=≈":
            return None
        if head.name in knowledge.letters or not self._engines.mentions:
            return None
        value = without_dots(chain.sides[1].node)[0]
        if head.name in names(value):
            return None
        claim = self._claim(head.name, chain)
        if claim is None or not claim.engine.stars:
            return None
        if not names(value):
            return self._vanishing(head.name, claim, value)
        try:
            product = self._expanded(product_of(value), head.name, knowledge)
            return self._compared(chain, head.name, claim, product, knowledge)
        except NoProductError:
            return None

    # What the words say

    def engine_of(self, chain: Chain) -> NamedEngine | None:
        """Return the engine that a relation is of, None where words name none or several."""
        return self._engine(chain, min(s.span[0] for s in chain.sides), chain.end)

    def sentence(self, chain: Chain) -> str:
        """Return the sentence that a relation stands in, with what stands before a display."""
        first, last = self._sentence(self._opening(min(s.span[0] for s in chain.sides)), chain.end)
        return self._text[first:last]

    def orders_before(self, chain: Chain) -> set[int]:
        """Return the orders that the sentence of a relation names before it, or the one before that."""
        start = self._opening(min(s.span[0] for s in chain.sides))
        first, _ = self._sentence(start, chain.end)
        for words in (
            self._text[first:start],
            self._text[self._sentence(max(first - 2, 0), first)[0] : start],
        ):
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

    def _claim(self, name: str, chain: Chain) -> _Claim | None:
        start, end = min(s.span[0] for s in chain.sides), chain.end
        before, behind, sentence, own = self._words_around(chain, start, end)
        heading = self.sections.heading_above(chain.lines[0])
        order, said = 0, ""
        title = self._text[: self._line_starts[1]]
        for words in (before, behind, heading, title):
            if _ORDER_WORD.search(words) and (order := _order_in(words, name)):
                said = words
                break
        if not order:
            order, said = self._order_otherwise(name, chain, before, sentence)
        kind = next((k for w in (before, behind, said) if (k := _kind_in(w, name))), "")
        is_rotating = _ROTATING.search(before) is not None
        if is_rotating and not order:
            order, said = 1, before
        kind = kind or (FORCE if _VECTORS.search(sentence) else "")
        kind = kind or _kind_by_letter(name) or _kind_in(heading, name)
        if not order or not kind or _TORQUE.search(f"{before} {said}") or not _fits_index(name, order):
            return None
        engine = self._engine(chain, start, end)
        if engine is None:
            return None
        paragraph = self._text[self._line_starts[self.sections.paragraph_start(chain.lines[0]) - 1] : end]
        around = f"{heading} {paragraph} {sentence}"
        return _Claim(engine, order, kind, _plain(said), own, sentence, around, is_rotating)

    def _order_otherwise(self, name: str, chain: Chain, before: str, sentence: str) -> tuple[int, str]:
        """Return the order that an index or the formula's own wave says, where it is of the whole engine."""
        if not _WHOLE.search(sentence) and not _WHOLE.search(before):
            return 0, ""
        waves = [
            p for p in walk(chain.sides[1].node) if isinstance(p, Call) and p.function in ("cos", "sin")
        ]
        number = _wave(waves[0])[0] if len(waves) == 1 else 0
        if number in _POWERS and not _index(name):
            return number, before
        stem, index = name.partition("_")[0], _index(name)
        heads = {
            c.sides[0].node.name for c in self.words.document.chains if isinstance(c.sides[0].node, Name)
        }
        indices = {_index(n) for n in heads if n.partition("_")[0] == stem}
        is_order = (
            index in (1, 2)
            and indices <= {1, 2, 4, 6}
            and (_COUPLE.search(before) or _FORCE.search(before))
        )
        return (index, before) if is_order else (0, "")

    def _words_around(self, chain: Chain, start: int, end: int) -> tuple[str, str, str, str]:
        """Return the clause before a formula, words behind it, its sentence, and what of it is its own."""
        start = self._opening(start)
        first, last = self._sentence(start, end)
        others = [c for c in self.words.document.chains if c is not chain and c.relations]
        earlier = max((c.end for c in others if first <= c.end <= start), default=first)
        later = min((c.start for c in others if end <= c.start < last), default=last)
        before = self._text[earlier:start]
        clause = re.split(r"[,;:、](?=\s|\$)|\b(?:and|und|et|y|ed?|en)\b", before)
        before = next((c for c in clause[:0:-1] if _ORDER_WORD.search(c)), before)
        if header := self.words.header_of_column(chain):
            before = f"{header} {self._row_label(start)} {before}"
        behind, own = self._text[end : min(later, end + 90)], self._text[earlier:start]
        return before, behind, self._text[first:last], f"{own} {behind}"

    def _opening(self, start: int) -> int:
        """Return where the words end that a formula is set off from, by a line of its own or by signs."""
        floor = max(0, start - _MOST)
        bare = _OPENING.sub("", self._text[floor:start])
        return start if bare.endswith((".", "!", "?", "。")) else floor + len(bare)

    def _row_label(self, start: int) -> str:
        """Return what the first cell of a table's row says, as an order where its column is of orders."""
        text, line = self._text, self._text.rfind("\n", 0, start) + 1
        label = text[line:start].split("|")[1] if "|" in text[line:start] else ""
        rows = text[:line].split("\n")[:-1]
        while len(rows) > 1 and rows[-2].lstrip().startswith("|"):
            rows.pop()
        head = rows[-1].split("|")[1] if rows and rows[-1].count("|") else ""
        is_number = label.strip(" $.") in ("1", "2", "4", "6")
        return f"order {label.strip(' $.')}" if is_number and _ORDER_WORD.search(head) else label

    def _row(self, start: int) -> str:
        """Return the first cell of a table's row, "" outside of tables."""
        own = self._text[self._text.rfind("\n", 0, start) + 1 : start]
        return own.split("|")[1] if own.lstrip().startswith("|") and own.count("|") > 1 else ""

    def _sentence(self, start: int, end: int) -> tuple[int, int]:
        floor = max(0, start - _MOST)
        ends = [m.end() for m in _SENTENCE_END.finditer(self._text, floor, start)]
        behind = _SENTENCE_END.search(self._text, end, min(len(self._text), end + _MOST))
        return (ends[-1] if ends else floor), (
            behind.start() if behind else min(len(self._text), end + _MOST)
        )

    def _engine(self, chain: Chain, start: int, end: int) -> NamedEngine | None:
        """Return the engine that a relation is of: of its sentence, paragraph, section or title."""
        line, at = chain.lines[0], self._line_starts
        section = at[self.sections.section_start(line) - 1]
        section_end = at[min(self.sections.section_end(line), len(at) - 1)]
        heading_end = at[min(self.sections.section_start(line), len(at) - 1)]
        title_end = at[min(3, len(at) - 1)]
        scopes = [
            self._sentence(start, end), (at[self.sections.paragraph_start(line) - 1], start),
            (section, heading_end), (section, start), (0, min(title_end, start)),
        ]  # fmt: skip
        for number, (first, last) in enumerate(scopes):
            named = self._engines.between(first, last)
            if self._engines.has_banks(first, last):
                return None
            if not named:
                continue
            engine = _only_one(named)
            if engine is None or (number > 2 and _only_one(self._engines.between(0, start)) is None):
                return None
            title = "" if number < 4 and section > 0 else self._text[:title_end]
            around = f"{title}\n{self._text[section:heading_end]}"
            near = self._row(start) or self._text[slice(*self._sentence(start, end))]
            engine = self._engines.with_stars(engine, section, section_end, around, near)
            listed = listed_at(self._crank_lists, start, self._text, self.sections.same_section)
            if (
                listed is None
                or listed.is_by_firing
                or len(listed.degrees) != engine.cylinders
                or engine.is_boxer
            ):
                return engine
            return replace(engine, stars=(CrankStar(listed.degrees),))
        return None

    # What it should be

    def _expanded(self, product: ProductOfPowers, head: str, knowledge: Knowledge) -> ProductOfPowers:
        """Return a product with the letters put in that the page has defined as products."""
        for name in [*product.powers]:
            definition = knowledge.definitions.get(name)
            is_size = self._role(name, self._letter_roles(knowledge), None) not in (
                "base",
                "arm",
                "other",
            )
            if definition is None or definition.numeric or is_size or not names(definition.node):
                continue
            try:
                value = product_of(definition.node)
            except NoProductError:
                continue
            if value.wave is not None or head in value.powers:
                continue
            power = product.powers[name]
            rest = {n: p for n, p in product.powers.items() if n != name}
            product = ProductOfPowers(product.number, rest, product.wave, product.rounding)
            product = product.times(value, power)
        return product

    def _compared(
        self, chain: Chain, name: str, claim: _Claim, product: ProductOfPowers, knowledge: Knowledge
    ) -> Verdict | Decision | None:
        parts = self._parts(product, claim, knowledge)
        if parts is None:
            return None
        sizes = claim.sizes()
        if claim.is_rotating and product.wave is not None:
            return None
        first = Fraction(1) if parts.has_amplitude else _FIRST_TERMS[claim.order]
        number = abs(product.number)
        is_amount = any(_same(number, size * float(first), product.rounding) for size in sizes)
        slips = list(parts.slips)
        if not is_amount:
            slips.append("factor")
        if not slips:
            return Decision(
                PROVED, assumptions=(self._assumption(name, claim), *self._conditions(claim, parts))
            )
        if len(slips) != 1 or not self._may_accuse(
            chain, knowledge, claim, parts, product, slips[0], sizes, float(first)
        ):
            return None
        return self._refuted(chain, name, claim, parts, slips[0], sizes[0] * float(first) / number)

    def _assumption(self, name: str, claim: _Claim) -> str:
        of = "rotating " if claim.is_rotating else ""
        return (
            f"{plain_letter(name)} is order {claim.order} of the whole engine's {of}{claim.kind}"
            f" ({NOBODY}; taken from the words “{claim.words}”)"
        )

    @staticmethod
    def _conditions(claim: _Claim, parts: _Parts) -> Iterator[str]:
        stars = claim.engine.stars
        yield f"the cranks are at {stars[0].text} (“{claim.engine.words}”)"
        if parts.arm:
            yield f"{plain_letter(parts.arm)} is the distance of neighbouring cylinders"
        if claim.order > 1:
            yield "the rod is long"

    def _parts(self, product: ProductOfPowers, claim: _Claim, knowledge: Knowledge) -> _Parts | None:
        """Return which letter is what, and what of them is wrong; None for another kind of formula."""
        powers, roles = dict(product.powers), self._letter_roles(knowledge)
        by_role: dict[str, list[str]] = {}
        for name in powers:
            by_role.setdefault(self._role(name, roles, claim), []).append(name)
        if "other" in by_role or any(len(each) > 1 for each in by_role.values()):
            return None
        letter = {role: each[0] for role, each in by_role.items()}
        power = {role: powers[name] for role, name in letter.items()}
        if claim.kind == COUPLE and "arm" not in power and "rod" in power and power["rod"] > 0:
            letter["arm"], power["arm"] = (
                letter.pop("rod"),
                power.pop("rod"),
            )  # L is the pitch, not the rod
        slips: list[str] = []
        of_ratio = power.get("ratio", 0) - power.get("inverse", 0) - power.get("rod", 0)
        has_inertia = {"mass", "radius", "speed"} & power.keys()
        expected = Fraction(0 if "coefficient" in power else _POWERS[claim.order])
        if has_inertia and "base" not in power:
            extra = -power.get("rod", Fraction(0))
            if extra and "ratio" not in power and extra != expected == power.get("radius", 0) - 1:
                slips, extra, of_ratio = ["rod"], expected, expected
            wanted = {"mass": Fraction(1), "speed": Fraction(2), "radius": 1 + extra}
            if not {"mass", "radius", "speed"} <= power.keys():
                return None
            slips += [role for role, e in wanted.items() if power[role] != e]
        elif "base" not in power or power["base"] != 1 or has_inertia:
            return None
        has_amplitude = "coefficient" in power or claim.is_rotating
        if "base" in power:
            index = _index(letter["base"])
            if index == claim.order > 1 or (claim.order > 1 and not of_ratio and index not in (1,)):
                expected, has_amplitude = Fraction(0), True  # the amplitude of that order itself
        if claim.is_rotating:
            expected = Fraction(0)
        if of_ratio != expected:
            slips.append("ratio")
        if claim.kind == COUPLE and power.get("arm") != 1:
            return None
        if claim.kind == FORCE and "arm" in power:
            return None
        multiple, angle = (0, "") if product.wave is None else _wave(product.wave)
        if product.wave is not None and multiple != claim.order:
            if not multiple:
                return None
            slips.append("wave")
        return _Parts(
            letter, dict(product.powers), tuple(slips), has_amplitude, expected - of_ratio, angle
        )

    def _letter_roles(self, knowledge: Knowledge) -> Mapping[str, str]:
        meanings = {n: p.meaning for n, p in self.words.proposals.items() if p.words}
        return {**meanings, **knowledge.meanings}

    def _role(self, name: str, roles: Mapping[str, str], claim: _Claim | None) -> str:
        stem, _, index = name.partition("_")
        meaning = roles.get(name, "")
        if self._pitch_words(name) or _PITCH_WORDS.search(meaning):
            return "arm"
        for words, role in _BY_MEANING.items():
            if meaning.startswith(words):
                return role
        if stem in _RATIOS:
            return "ratio"
        is_couple = claim is not None and claim.kind == COUPLE
        if (
            claim is not None
            and claim.order > 1
            and stem in ("A", "B", "C", "a", "b", "c", "alpha", "beta")
            and index == str(claim.order)
        ):
            return "coefficient"
        if stem in _MASSES:
            return "mass"
        if stem in _SPEEDS:
            return "speed"
        if name in _RADII:
            return "radius"
        if name in _RODS:
            return "rod"
        if name == "n":
            return "inverse"
        if stem in _AMPLITUDES and not (stem == "p" and is_couple):
            return "base"
        return "arm" if is_couple and stem in _ARMS else "other"

    def _pitch_words(self, name: str) -> list[str]:
        """Return the words that call a letter the distance of cylinders, before or behind it."""
        before = [w for w in self._roles.words_before(name) if _ends(_PITCH_WORDS, w)]
        sign = re.escape(plain_letter(name))
        behind = re.compile(rf"(?<![\\A-Za-z_]){sign}(?![A-Za-z_])\s?\$?\s?(?P<words>[^$;.\n=]{{0,50}})")
        return before + [
            m["words"]
            for m in behind.finditer(self._text)
            if _IS.match(m["words"]) and _PITCH_WORDS.search(m["words"])
        ]

    # What is wrong

    def _vanishing(self, name: str, claim: _Claim, value: Formula) -> Decision | None:
        if _VECTORS.search(claim.sentence):
            return self._phasor_sum(name, claim, value)
        if not isinstance(value, Number) or value.value or _PART.search(claim.sentence):
            return None
        sizes = claim.sizes()
        if not any(sizes):
            return Decision(PROVED, assumptions=(self._assumption(name, claim), *self._star(claim)))
        if all(sizes) and not _BALANCED.search(claim.around) and not claim.engine.is_boxer:
            reason = "; ".join((f"if {self._assumption(name, claim)}", *self._star(claim)))
            return Decision(REFUTED, f"{reason}: the {claim.kind}s of order {claim.order} do not cancel")
        return None

    def _phasor_sum(self, name: str, claim: _Claim, value: Formula) -> Decision | None:
        """Return the decision on a number for the sum of the unit phasors of an order."""
        sizes = sorted({star.force(claim.order) for star in claim.engine.stars})
        try:
            product = product_of(value)
        except NoProductError:
            return None
        number = abs(product.number)
        text = f"{plain_letter(name)} is the sum of the cranks' unit vectors of order {claim.order}"
        text = f"{text} ({NOBODY}; taken from the words “{claim.words}”)"
        if any(_same(number, size, product.rounding) or number == size == 0 for size in sizes):
            return Decision(PROVED, assumptions=(text, *self._star(claim)))
        if len(sizes) != 1 or _PART.search(claim.own) or _WEIGHTED.search(claim.sentence):
            return None
        return Decision(
            REFUTED, "; ".join((f"if {text}", *self._star(claim))) + f": it is {sizes[0]:.5g}"
        )

    @staticmethod
    def _star(claim: _Claim) -> Iterator[str]:
        yield f"the cranks are at {claim.engine.stars[0].text} (“{claim.engine.words}”)"

    def _may_accuse(
        self,
        chain: Chain,
        knowledge: Knowledge,
        claim: _Claim,
        parts: _Parts,
        product: ProductOfPowers,
        slip: str,
        sizes: list[float],
        first: float,
    ) -> bool:
        """Tell whether the words leave no other meaning under which a formula is right."""
        if _IN_A_CASE.search(claim.sentence):
            return False
        if slip != "factor":
            return not _OF_ANOTHER.search(claim.sentence)
        own = f"{claim.words} {claim.own}".replace(claim.engine.words, "")
        is_part = _PART.search(own) or _OF_ONE.search(own)
        if (
            len(sizes) != 1
            or is_part
            or not self._is_told(parts.letter.get("base", ""))
            or _TOTAL_MASS.search(self._text)
        ):
            return False
        number, size = abs(product.number) / first, sizes[0]
        if _same(number, 1, product.rounding) and claim.kind == FORCE:
            return self._is_of_all(chain, claim, knowledge)
        if claim.kind == FORCE or not size:
            return bool(size) or not _same(number, 1, product.rounding)
        if claim.engine.is_boxer and len(claim.engine.stars[0].degrees) > 2:
            return False
        count = len(claim.engine.stars[0].degrees)
        scales = (2.0, 0.5, count - 1.0, 1 / (count - 1.0), (count - 1) / 2, 2 / (count - 1.0))
        is_scaled = any(_same(number, size * scale, product.rounding) for scale in scales)
        is_pitch = any(not _FAR_APART.search(w) for w in self._pitch_words(parts.arm))
        return not is_scaled or (is_pitch and not _FAR_APART.search(claim.around))

    def _is_told(self, base: str) -> bool:
        """Tell whether a letter for an amplitude is said to be one cylinder's; also where there is none."""
        if not base:
            return True
        sign = re.compile(rf"(?<![\\A-Za-z_]){re.escape(plain_letter(base))}(?![A-Za-z])")
        places = [m.start() for m in sign.finditer(self._text)]
        return any(_OF_ONE.search(self._text, max(0, place - 80), place + 80) for place in places)

    def _is_of_all(self, chain: Chain, claim: _Claim, knowledge: Knowledge) -> bool:
        """Tell whether one cylinder's amplitude is said to be the whole engine's.

        The words say so, or another line of the section is the whole engine's: then a formula of one
        cylinder would be told apart. Where the letter is used further on, it may be one cylinder's.
        """
        if _OF_ONE.search(_MASS_OF_ONE.sub("", self._text)) or _SUMMED.search(self._text):
            return False
        head = chain.sides[0].node
        others = [c for c in self.words.document.chains if c is not chain and c.relations]
        if any(
            isinstance(head, Name) and head.name in names(s.node) for c in others for s in c.sides[1:]
        ):
            return False
        near = [c for c in others if self.sections.same_section(c.lines[0], chain.lines[0])]
        amounts = [self._amount(c, claim.engine, knowledge) for c in near]
        if any(of == (claim.order, claim.kind) and is_all for of, is_all in amounts):
            return False
        is_said = _WHOLE.search(claim.sentence) is not None or _WHOLE.search(claim.around) is not None
        return is_said or any(is_all for _, is_all in amounts)

    def _amount(
        self, chain: Chain, engine: NamedEngine, knowledge: Knowledge
    ) -> tuple[tuple[int, str], bool]:
        """Return the order and kind of another formula, and whether it is the whole engine's and not one cylinder's."""
        head, value = chain.sides[0].node, chain.sides[1].node
        claim = self._claim(head.name, chain) if isinstance(head, Name) else None
        if claim is None or claim.engine.key != engine.key or not claim.engine.stars:
            return (0, ""), False
        sizes = claim.sizes()
        if not names(value):
            is_zero = isinstance(value, Number) and not value.value
            return (claim.order, claim.kind), is_zero and not any(sizes)
        try:
            number = abs(self._expanded(product_of(value), "", knowledge).number)
        except NoProductError:
            return (0, ""), False
        firsts = (1.0, float(_FIRST_TERMS[claim.order]))
        is_all = any(_same(number, size * first) for size in sizes for first in firsts)
        return (claim.order, claim.kind), is_all and (claim.kind == COUPLE or not _same(number, 1))

    def _refuted(
        self,
        chain: Chain,
        name: str,
        claim: _Claim,
        parts: _Parts,
        slip: str,
        factor: float,
    ) -> Verdict | None:
        side = chain.sides[1]
        own = product_of(without_dots(side.node)[0])
        target = self._mended(own, parts, slip, factor, claim)
        if target is None:
            return None
        known = Knowledge(SymbolValue(positive=frozenset(names(side.node))), corrects=True)
        decision = decide(Side((target,), chain.sides[0].span), side, chain.relations[0].sign, known)
        if decision.status != REFUTED:
            return None
        reason = "; ".join((f"if {self._assumption(name, claim)}", *self._conditions(claim, parts)))
        verdict = describe(
            self.words.document, chain, 0, Decision(REFUTED, reason, witness=decision.witness)
        )
        repair = Repair(_KINDS.get(slip, slip), target, ((side.node, target),), 1.0)
        return replace(verdict, fix=fix_of(repair, self.words.document, side))

    def _mended(
        self, own: ProductOfPowers, parts: _Parts, slip: str, ratio: float, claim: _Claim
    ) -> Formula | None:
        """Return a claim with its one slip put right, in its own letters."""
        powers, factor, wave = dict(own.powers), abs(own.number), own.wave
        if slip == "factor":
            factor *= ratio
        elif slip == "ratio":
            name = parts.letter.get("ratio") or ("lambda" if "rod" not in parts.letter else "")
            if name:
                powers[name] = powers.get(name, Fraction(0)) + parts.missing
            else:
                for role, sign in (("radius", 1), ("rod", -1)):
                    letter = parts.letter[role]
                    powers[letter] = powers.get(letter, Fraction(0)) + sign * parts.missing
        elif slip == "wave" and wave is not None:
            angle = Name(parts.angle)
            turned = angle if claim.order == 1 else Product((Number(Fraction(claim.order)), angle))
            wave = Call(wave.function, turned)
        else:
            wanted = {
                "rod": -_POWERS[claim.order],
                "mass": 1,
                "speed": 2,
                "radius": 1 - parts.powers.get(parts.letter.get("rod", ""), 0),
            }
            powers[parts.letter[slip]] = Fraction(wanted[slip])
        factors = [_number_node(factor)] if not _same(factor, 1) else []
        factors += [Name(n) if p == 1 else Name(n) ** p for n, p in powers.items() if p > 0]
        below = [Name(n) if p == -1 else Name(n) ** -p for n, p in powers.items() if p < 0]
        factors += [wave] if wave is not None else []
        node: Formula = _product(factors)
        node = Quotient(node, _product(below)) if below else node
        return -node if own.number < 0 else node


def _product(factors: list[Formula]) -> Formula:
    return (
        factors[0] if len(factors) == 1 else Product(tuple(factors)) if factors else Number(Fraction(1))
    )


def _number_node(value: float) -> Formula:
    """Return a number as a fraction, a root, or to four digits."""
    near = Fraction(value).limit_denominator(512)
    if isclose(near, value, rel_tol=1e-9):
        return (
            Number(near)
            if near.denominator == 1
            else Quotient(Number(Fraction(near.numerator)), Number(Fraction(near.denominator)))
        )
    square = Fraction(value * value).limit_denominator(64)
    if isclose(square, value * value, rel_tol=1e-9):
        for below in range(1, 9):
            inner = square * below * below
            if inner.denominator == 1:
                root = Call("sqrt", Number(inner))
                return root if below == 1 else Quotient(root, Number(Fraction(below)))
    places = 3 if value < 10 else 2
    return Number(Fraction(round(value, places)).limit_denominator(10**places), Fraction(1, 10**places))


def _same(first: float, second: float, rounding: float = 1e-9) -> bool:
    return isclose(first, second, rel_tol=max(rounding, 1e-9))


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
        numbers &= {_index(name)}
    number = numbers.pop() if len(numbers) == 1 else 0
    return number if number in _POWERS else 0


def _index(name: str) -> int:
    """Return the number that a letter has as index, 0 for none."""
    for part in re.split(r"[_,\s]+", name)[1:]:
        if part in _ROMAN or part.isdecimal():
            return _ROMAN.get(part) or int(part)
    match = re.fullmatch(r"[A-Za-z]+([1-9])", name)
    return int(match[1]) if match else 0


def _fits_index(name: str, order: int) -> bool:
    return _index(name) in (0, order)


def _kind_in(words: str, name: str) -> str:
    kinds = [k for k, pattern in ((COUPLE, _COUPLE), (FORCE, _FORCE)) if pattern.search(words)]
    by_letter = _kind_by_letter(name)
    return by_letter if by_letter in kinds else kinds[0] if kinds else ""


def _kind_by_letter(name: str) -> str:
    stem = name.partition("_")[0].rstrip("'")
    return COUPLE if stem in ("M", "C", "T") else FORCE if stem in ("F", "P", "R", "K") else ""


def _wave(wave: Call) -> tuple[int, str]:
    """Return n and θ of cos nθ, of cos nωt the angle's letters together; 0 for another argument."""
    try:
        argument = product_of(wave.argument)
    except NoProductError:
        return 0, ""
    number = argument.number
    letters = [n for n, p in argument.powers.items() if p == 1]
    if len(letters) != 1 or len(argument.powers) != 1 or not number.is_integer() or number <= 0:
        return 0, ""
    return int(number), letters[0]


def _ends(pattern: re.Pattern[str], text: str) -> bool:
    """Tell whether words end with a phrase, but for a few that may follow it: the spacing of the cylinders."""
    last = max((m.end() for m in pattern.finditer(text)), default=None)
    return last is not None and _BEHIND_PITCH.fullmatch(text[last:]) is not None


def _plain(words: str) -> str:
    return re.sub(r"\s+", " ", words).strip(" \n\t$,.;:、は\\([|*#")
