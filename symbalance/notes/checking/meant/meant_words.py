"""What the words of a page say of letters that nobody declared: which size, which motion, which unit.

Nothing here is believed silently: a verdict that rests on such words names them. Words that speak of a
part, a sum or another body (the second order, all cylinders, the rod) name no motion of the piston, but
the unit of what they name still stands.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

from symbalance.document.formula import Formula, Name, Product, Quotient, names
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.declared.letter_spellings import letter_pattern
from symbalance.notes.checking.declared.proposals import meanings_from_words
from symbalance.notes.checking.declared.proposed_meanings import Proposal
from symbalance.notes.checking.declared.role_phrases import (
    CONVENTIONS,
    MOVING_SECTIONS,
    RATIO,
    roles_named,
)
from symbalance.notes.checking.declared.sidecar import Declarations
from symbalance.notes.checking.declared.symbol_roles import (
    FROM_MIDDLE,
    FROM_PIN,
    FROM_TOP,
    MOVING,
    role_of,
)
from symbalance.notes.checking.units.dimensions import Dimension, unit_of, written_unit
from symbalance.notes.checking.words.accuracies import without_orders_of_series
from symbalance.notes.checking.words.glossary import Glossary, glossary_of
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.checking.words.sentences import SENTENCE_END, bare
from symbalance.notes.checking.words.table_cells import TableCells, cells_of
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

NOBODY = "nobody declared it"
"""In the assumption of every verdict that rests on what a letter is taken to be."""
BY_WORDS, FROM_WORDS = "by “", "taken from the words “"
"""Before the words of a page that say what a letter is taken to be."""
TORQUE = "inertia torque"
"""Not a role that a letter may be declared with: -m a dx/dθ."""
LONGEST_WORDS = 160
"""Characters before a relation in which its quantity is named: a sentence."""
SIZES = (
    "crank angle", "rod angle", "crank radius", "stroke", "rod length", "angular speed",
    "reciprocating mass", *CONVENTIONS.values(),
)  # fmt: skip
"""The roles that the slider-crank is written in."""
_OTHER = re.compile(
    r"first|second|third|fourth|primary|secondary|\borders?\b|Ordnung|[一二三四六0-9]\s*次"
    r"|\bmean\b|average|mittlere|durchschnitt|平均|amplitude|振幅"
    r"|\bsum\b|total|result(?:ant|ing)|gesamt|Summe|resultier|合力|cylinders|Zylinder\b|気筒"
    r"|angular|Winkel[gb]|角速度|角加速度|centripetal|centrifugal|Flieh|遠心|\bgas"
    r"|\brod\b|Pleuel(?!länge)|Stange|コンロッド|component|Komponente|成分|\bside\b|Seiten|\bnormal"
    r"|counterweight|Gegengewicht|Ausgleich|balance|flywheel|Schwungrad|\bshaft|Welle\b|Schwerpunkt|重心"
    r"|relative|square|Quadrat|per\s+unit|proportional|difference|Differenz|error|Fehler|\bratio\b|mass\s+moment",
    re.IGNORECASE,
)
"""Words that make of the piston's motion or force a part, a sum or another body's."""
_LARGEST = re.compile(
    r"\bmax|greatest|largest|größte|maximal|最大|peak|\bmin|smallest|kleinste|最小", re.IGNORECASE
)
_CLAUSE_DONE = re.compile(
    r"(?:(?:で|と)(?:あり|なり)|(?:する|ある|なる)(?:が|から|ので))[,，、]"
    r"|[,，](?=\s+(?:and|while|whereas|but|und|während|aber|et|mais)\s)"
)
"""Behind a statement of its own, whose words say nothing of what follows: 偶力は零であり、F = 0."""
_AND_ANOTHER = re.compile(
    r"\b(?:and\s+(?:the|its|an?|we|so)|und\s+(?:d(?:er|ie|as)|sein|ihr|ein)|et\s+l[ea]|y\s+(?:el|la))\b"
)
"""Behind it another thing is named: put in the force, and the largest term is T."""
_NO_UNIT = re.compile(
    r"\bper\b|\bje\b|\bpro\b|proportional|specific|spezifisch|bezogen|relative|\bunits?\b|of\s+inertia|Trägheits"
    r"|Widerstands|Flächen|moments?\s+of\s+(?:area|resistance)|慣性モーメント|断面|momentum|\bratio|Verhältnis|比"
    r"|dimensionless|divided|geteilt|derivative|rates?\s+of\s+change|ableitung|微分",
    re.IGNORECASE,
)
"""Words beside the name of a force or a moment that may make another dimension of it."""
_DIMENSIONS: Mapping[str, str] = {
    "force": r"(?<![A-Za-z])forces?(?![A-Za-z])|[Kk]raft(?![A-Za-z])|[Kk]räfte(?![A-Za-z])"
    r"|(?<![偶圧出動応能入馬電強])力(?!学|の?モーメント|対)",
    "torque": r"(?<![A-Za-z])(?:torques?|moments?|couples?)(?![A-Za-z])"
    r"|[Mm]oment(?![A-Za-z])|トルク|モーメント|偶力",
    "stress": r"(?<![A-Za-z])stress(?:es)?(?![A-Za-z])|[Ss]pannung(?![A-Za-z])|応力",
    "velocity": r"(?<![A-Za-z])(?<!angular\s)(?<!rotational\s)velocity(?![A-Za-z])"
    r"|(?<!inkel)(?<!reh)[Gg]eschwindigkeit(?![A-Za-z])",
    "acceleration": r"(?<![A-Za-z])(?<!angular\s)(?<!rotational\s)acceleration(?![A-Za-z])"
    r"|(?<!inkel)(?<!reh)[Bb]eschleunigung(?![A-Za-z])|(?<!角)加速度",
}
"""Words for a kind of size; what turns (angular acceleration, Winkelgeschwindigkeit) is none of them."""
_UNITS = {"force": "N", "torque": "N m", "stress": "Pa", "velocity": "m/s", "acceleration": "m/s^2"}
_KIND = re.compile("|".join(f"(?P<{kind}>{pattern})" for kind, pattern in _DIMENSIONS.items()))
_BOTTOM = re.compile(
    r"bottom dead|lower dead|outer dead|\bBDC\b|\bUT\b|unteren? Totpunkt|下死点|crank[- ]end",
    re.IGNORECASE,
)
_ANGLE_FROM = (
    r"(?:angle|winkel|ángulo|angolo|ângulo|kąt|úhel|hoek|vinkel|角)[^.]{0,80}?"
    r"(?:\bfrom|\bvon|\bvom|\bab|\bdesde|\bdal|\bdepuis|\bpartir|\bod|\bvanaf|\bfrån)\s[^.]{0,16}?"
)
_ANGLE_FROM_TOP = re.compile(rf"{_ANGLE_FROM}(?:top|upper|inner) dead|{_ANGLE_FROM}\b(?:TDC|OT)\b", re.I)
TRAVEL_FROM_TOP = re.compile(
    r"(?:travel|displacement|distance|Kolbenweg|Hubweg|course)[^.]{0,60}?"
    r"\b(?:from|below|von|vom|ab)\s[^.]{0,16}?(?:(?:top|upper|inner) dead|\b(?:TDC|OT)\b)"
    r"|上死点から[^。]{0,30}(?:変位|距離|移動)|(?:変位|距離)[^。]{0,20}上死点から",
    re.IGNORECASE,
)
"""Words by which the piston's way is zero at the top and the stroke at the bottom, nothing else."""
_ANGLE_FROM_BOTTOM = re.compile(
    rf"{_ANGLE_FROM}(?:bottom|lower|outer) dead|{_ANGLE_FROM}\b(?:BDC|UT)\b", re.I
)
_COUNTED = (
    r"(?:counted|measured|reckoned|taken|zero|gezählt|gemessen|gerechnet|zählt|misst|compté|mesuré"
    r"|se\smide|se\scuenta|medido|misurato|contato|si\smisura)"
)
_AWAY = (
    r"(?:from|at|von|vom|ab|à\spartir\sd[eu]|at\spartir\sof|depuis|desde|dal|a\spartire\sdal)"
    r"\s(?:(?:the|der|dem|le|el|il)\s)?"
)
_LOWEST = (
    r"(?:(?:bottom|lower|outer)\sdead|(?:BDC|UT|PMB)\b|unteren?\sTotpunkt|point\smort\sbas"
    r"|punto\smuerto\sinferior|punto\smorto\sinferiore)"
)
_ANGLE = r"(?:angle|winkel|ángulo|angolo|θ|ϑ|φ|ϕ|\\(?:var)?(?:theta|phi))"
_SURELY_FROM_BOTTOM = re.compile(
    rf"{_ANGLE}[^.;\n]{{0,60}}?\b{_COUNTED}\s(?:[\w]+\s){{0,2}}?{_AWAY}{_LOWEST}"
    rf"|{_ANGLE}[^.;\n]{{0,40}}?\s{_AWAY}{_LOWEST}[^.;\n]{{0,12}}?\s{_COUNTED}"
    rf"|(?<![^\W\d_])(?:with|mit|avec|con|where|the\sangle)\s\$?{_ANGLE}\$?\s{_AWAY}{_LOWEST}"
    r"|角[^。\n]{0,20}下死点から(?:測|数|計|取|と)|下死点から(?:測|数|計|取)[^。\n]{0,12}角",
    re.IGNORECASE,
)
"""Words by which the crank angle is zero at the bottom dead centre."""


@dataclass(frozen=True, slots=True)
class Named:
    """What words name a letter: a motion or force of the piston ("" for none), and the words."""

    role: str
    words: str
    is_largest: bool = False
    company: str = ""
    """The letter that it is known by, where no words name it: a beside x and v."""

    @property
    def source(self) -> str:
        """What says so."""
        if self.company:
            return f"it goes with {plain_letter(self.company)} above"
        return f"taken from the words “{self.words}”" if self.role else "its formula says so"


@dataclass
class MeantWords:
    """The words of one page, read once, when a letter first needs them."""

    document: ReadNotes
    declarations: Declarations
    sections: Sections

    @cached_property
    def glossary(self) -> Glossary:
        """The English terms of the page's language."""
        return glossary_of(self.document.text)

    @cached_property
    def page(self) -> str:
        """The text of the page with its terms in English."""
        return self.glossary.english(self.document.text)

    @cached_property
    def proposals(self) -> Mapping[str, Proposal]:
        """The meanings that words propose for letters that are not declared."""
        return meanings_from_words(self.document, self.declarations.symbols_at, self.glossary.english)

    @cached_property
    def counts_from_bottom(self) -> bool:
        """Tell whether the page speaks of the bottom dead centre: an angle may be counted from there.

        Where it says that its angle is counted from the top, it is not.
        """
        if _ANGLE_FROM_TOP.search(self.page) and not _ANGLE_FROM_BOTTOM.search(self.page):
            return False
        return _BOTTOM.search(self.page) is not None

    @cached_property
    def has_angle_from_bottom(self) -> bool:
        """Tell whether the page says that its crank angle counts from bottom dead centre."""
        texts = (self.document.text, self.page)
        if any(_ANGLE_FROM_TOP.search(text) for text in texts):
            return False
        return any(_SURELY_FROM_BOTTOM.search(text) is not None for text in texts)

    @cached_property
    def travels_from_top(self) -> bool:
        """Whether the page says that the piston's way is counted from the top dead centre."""
        return TRAVEL_FROM_TOP.search(self.page) is not None

    @cached_property
    def _sizes_proposed(self) -> dict[str, Proposal]:
        """The proposals of sizes, and of conventions of the rod ratio."""
        return {name: each for name, each in self.proposals.items() if each.meaning in SIZES}

    @cached_property
    def ratios(self) -> list[tuple[int, str, Quotient]]:
        """The lines that give a letter a quotient of two letters, or of a letter and a formula."""
        return [
            (chain.lines[0], chain.sides[0].node.name, side.node)
            for chain in self.document.chains
            if isinstance(chain.sides[0].node, Name)
            for side in chain.sides[1:]
            if isinstance(side.node, Quotient) and isinstance(side.node.numerator, Name)
        ]

    @cached_property
    def _ends(self) -> list[int]:
        """Where the relations of the page end, in order."""
        return sorted(chain.end for chain in self.document.chains)

    def sizes(self, line: int) -> tuple[dict[str, str], dict[str, str]]:
        """Return the letters of the slider-crank at a line: the declared ones, and those of the words."""
        declared = self.declarations.symbols_at(line)
        roles = {role_of(meaning) for meaning in declared.values()}
        proposed: dict[str, str] = {}
        for letter, proposal in self._sizes_proposed.items():
            is_new = letter not in declared and proposal.meaning not in {*roles, *proposed.values()}
            is_new = is_new and not (
                proposal.meaning in CONVENTIONS.values() and roles & {*CONVENTIONS.values()}
            )
            if is_new and proposal.line <= line + 1:
                proposed[letter] = proposal.meaning
        if not {*CONVENTIONS.values()} & {*roles, *proposed.values()}:
            proposed |= self._ratio({**declared, **proposed}, line)
        return declared, proposed

    def _ratio(self, symbols: Mapping[str, str], line: int) -> dict[str, str]:
        """Return the letter that a line above defines as the ratio of two known lengths."""
        short = {"crank radius": "r", "rod length": "l", "stroke": "s"}
        lengths = {name: short[role_of(text)] for name, text in symbols.items() if role_of(text) in short}
        for above, name, ratio in self.ratios:
            numerator, below = ratio.numerator, ratio.denominator
            if above > line or name in symbols or not isinstance(numerator, Name):
                continue
            pair = f"{lengths.get(numerator.name)}/" + (
                str(lengths.get(below.name)) if isinstance(below, Name) else ""
            )
            if pair in CONVENTIONS:
                return {name: CONVENTIONS[pair]}
        return {}

    def law_of_angle(self, theta: Formula, time: str, line: int) -> str:
        """Return how a page says, up to a line, that its crank angle grows: θ = ω t; "" for not."""
        for above, left, right in self._products:
            if above <= line and left == theta and names(right) - {time} and time in names(right):
                return f"{plain_text(left)} = {plain_text(right)}"
        return ""

    @cached_property
    def _products(self) -> list[tuple[int, Formula, Product]]:
        """The pairs of neighbouring sides of which the second is a product, with their lines."""
        return [
            (chain.lines[0], left.node, right.node)
            for chain in self.document.chains
            for left, right in pairwise(chain.sides)
            if isinstance(right.node, Product)
        ]

    def before(self, chain: Chain) -> str:
        """Return the words of the sentence before a relation, behind the relation before it."""
        if phrase := self.sections.phrases_in_order.of(chain):
            return self.glossary.english(phrase)
        text, start = self.document.text, chain.start
        place = bisect_right(self._ends, start)
        first = max(start - LONGEST_WORDS, self._ends[place - 1] if place else 0)
        return self.glossary.english(SENTENCE_END.split(bare(text[first:start]))[-1])

    def sentence_before(self, chain: Chain) -> str:
        """Return the sentence before a relation, other relations in it included."""
        start = chain.start
        words = bare(self.document.text[max(0, start - 2 * LONGEST_WORDS) : start])
        return self.glossary.english(SENTENCE_END.split(words)[-1])

    def header_of_column(self, chain: Chain) -> str:
        """Return the head of the column of a table that a relation stands in, "" outside of tables."""
        cell = self.cells.at(chain.start)
        return "" if cell is None else self.glossary.english(cell.column)

    @cached_property
    def cells(self) -> TableCells:
        """The cells of the page's tables."""
        return cells_of(self.document.text)

    def paragraph(self, chain: Chain) -> str:
        """Return the paragraph of a relation up to its end, with what stands before a display."""
        text, end = self.document.text, chain.end
        first = max(text.rfind("\n\n", 0, max(chain.start - 2, 0)), chain.start - 4 * LONGEST_WORDS, 0)
        return self.glossary.english(text[first:end])

    def named(self, name: str, chain: Chain) -> Named | None:
        """Return what words say of the letter that a relation defines; None where they say nothing."""
        named = self._named(name, chain)
        return named and replace(named, words=self.glossary.own_words(named.words))

    def _named(self, name: str, chain: Chain) -> Named | None:
        """Return the same with the words in English."""
        own = self._without_letters_told(without_orders_of_series(self.before(chain)))
        proposal = self.proposals.get(name)
        if proposal is not None and proposal.words and proposal.line <= chain.lines[0]:
            quoted = proposal.words
            said = without_orders_of_series(quoted)
            if proposal.meaning in MOVING and not _OTHER.search(f"{said} {own}"):
                return Named(proposal.meaning, phrase_of(proposal), _LARGEST.search(quoted) is not None)
            if proposal.meaning in MOVING:
                return Named("", quoted)
        if _OTHER.search(own):
            return Named("", own.strip()) if _motions(own) else None
        motions = _motions(own)
        kinds = {match.lastgroup for match in _KIND.finditer(own)}
        if motions and "torque" in kinds:
            return Named("", own.strip())  # the moment of the inertia force
        if len({role for role, _ in motions}) == 1:
            role, words = motions[0]
            return Named(role, words, _LARGEST.search(own) is not None)
        return Named("", own.strip()) if motions else None

    def _without_letters_told(self, words: str) -> str:
        """Return words without the clauses that only tell a size's letter, ω being the angular speed."""
        clauses = words.split(",")
        return ",".join(clause for clause in clauses if not self._tells_a_letter(clause))

    def _tells_a_letter(self, clause: str) -> bool:
        if _motions(clause):
            return False
        phrases = [named for named in roles_named(clause) if not named.is_part]
        told, rest = {named.role for named in phrases} & {*SIZES}, clause
        for named in reversed(phrases):
            rest = rest[: named.start] + rest[named.end :]
        return not _OTHER.search(rest) and any(
            proposal.meaning in told
            and re.search(rf"(?<![A-Za-z]){re.escape(sign)}(?![A-Za-z])", clause) is not None
            for letter, proposal in self._sizes_proposed.items()
            for sign in {letter, plain_letter(letter)}
        )

    def unit_named(self, chain: Chain) -> tuple[str, Dimension] | None:
        """Return the kind of size that the sentence before a relation names, with its dimension."""
        own = _AND_ANOTHER.split(_CLAUSE_DONE.split(self.before(chain))[-1])[-1]
        kinds = {match.lastgroup or "": match[0] for match in _KIND.finditer(own)}
        if len(kinds) != 1 or _NO_UNIT.search(own):
            return None
        ((kind, word),) = kinds.items()
        dimension = unit_of(_UNITS[kind])
        return None if dimension is None else (word, dimension)

    @cached_property
    def units_on_page(self) -> Mapping[str, tuple[str, Dimension, int]]:
        """The units in which letters have numbers: M = 500 N m; not of letters that have several."""
        units: dict[str, tuple[str, Dimension, int]] = {}
        several: set[str] = set()
        for chain in self.document.chains:
            for left, right in zip(chain.sides, chain.sides[1:], strict=False):
                if not isinstance(left.node, Name) or names(right.node):
                    continue
                source = self.document.source(right.span).replace("{,}", ",").replace("}^", "^")
                has_number, unit = written_unit(source)
                dimension = unit_of(unit) if has_number and unit else None
                if dimension is None:
                    continue
                name = left.node.name
                if name in units and units[name][1] != dimension:
                    several.add(name)
                units.setdefault(name, (unit, dimension, chain.lines[0]))
        return {name: unit for name, unit in units.items() if name not in several}

    def has_result_in(self, name: str, dimension: Dimension) -> bool:
        """Tell whether a letter has a number of a dimension: M = 142·400/4 = 14200 Nmm is no stress."""
        for chain in self.document.chains:
            if chain.sides[0].node != Name(name):
                continue
            for side in chain.sides[1:]:
                has_number, unit = written_unit(self.document.source(side.span))
                if has_number and unit and not names(side.node) and unit_of(unit) == dimension:
                    return True
        return False


def _motions(words: str) -> list[tuple[str, str]]:
    """Return the motions and forces that words name, each with the phrase."""
    motions = [(named.role, named.phrase) for named in roles_named(words) if not named.is_part]
    low = words.casefold()
    for role, phrases in MOVING_SECTIONS.items():
        phrase = next((p for p in phrases if p.casefold() in low), "")
        if phrase and not any(r == role for r, _ in motions) and not _is_within(phrase, motions):
            motions.append((role, phrase))
    return [
        (role, phrase)
        for role, phrase in motions
        if role in MOVING or role in (FROM_PIN, FROM_MIDDLE, FROM_TOP)
    ]


def _is_within(phrase: str, found: list[tuple[str, str]]) -> bool:
    """Tell whether a phrase is part of one that means something else: 速度 of 加速度."""
    return any(phrase.casefold() in other.casefold() for _, other in found)


def letters_text(letters: Mapping[str, str], words: Mapping[str, Proposal]) -> Iterator[str]:
    """Yield for letters that are not declared what they are taken to be, with the words that say so."""
    for letter, meaning in letters.items():
        proposal = words.get(letter)
        is_said = proposal is not None and proposal.words
        source = USUAL_END
        if proposal is not None and is_said:
            phrase = phrase_of(proposal)
            source = f"by {phrase}" if phrase == f"line {proposal.line}" else f"{BY_WORDS}{phrase}”"
        yield f"{plain_letter(letter)} is the {meaning}, {source}"


def phrase_of(proposal: Proposal) -> str:
    """Return the words that name a proposal's meaning, without those around."""
    roles = (proposal.meaning, RATIO) if proposal.meaning in CONVENTIONS.values() else (proposal.meaning,)
    own = [named.phrase for named in roles_named(proposal.words) if named.role in roles]
    if own:
        return own[0]
    pieces = [piece.strip(" .") for piece in _PIECE.split(_MARKS.sub("", proposal.words))]
    pattern = letter_pattern(proposal.letter)
    of_letter = [piece for piece in pieces if pattern is not None and pattern.search(piece)]
    return of_letter[0] if of_letter else pieces[0] if len(pieces) == 1 else f"line {proposal.line}"


_PIECE = re.compile(r"[,;](?![0-9])|:\s")
"""Between what a list says of one letter and of the next."""
_MARKS = re.compile(r"<[^>]*>?|[#$*]|\\[,;]")
USUAL_END = "as is usual for this letter"
"""Of a letter of which no words say what it is."""
