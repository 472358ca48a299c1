"""Which quantities words name beside a letter's formula: "the bending stress is σ = 16 M/(π d³)".

The words stand in the sentence before the formula, behind it, where its letter stands elsewhere, at the
head of its paragraph or in the heading. What else they say, of another shape, a part or another setup,
goes with them.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property

from symbalance.document.formula import (
    Formula,
    Name,
    names,
)
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.meant.catalogue import QUANTITIES, Quantity
from symbalance.notes.checking.meant.left_sides import LETTER
from symbalance.notes.checking.meant.letter_roles import (
    UNITS_ONLY,
    LetterRoles,
    ends_with,
    index_of,
    sign_of,
    without_accent,
)
from symbalance.notes.checking.meant.symbols_listed import ends_of_entries
from symbalance.notes.checking.words.case_words import engine_named
from symbalance.notes.checking.words.glossary import Glossary, glossary_of
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.checking.words.sentences import SENTENCE_END, bare
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

SENTENCE, PARAGRAPH, AFTER = 220, 500, 60
"""Characters that are looked through: before a formula for its name, and around for another shape."""
_BLANK = re.compile(r"\n\s*\n")
_DENIED = re.compile(
    r"\bnot\b(?! (?:only|just|merely)\b)|\binstead\b|\bwrong|mistak|confus|unlike|\bnicht\b(?! nur\b)"
    r"|\bstatt\b|anstelle|falsch"
    r"|verwechs|ではない|でなく"
    r"|誤り|間違|another book|older|empiric|faustformel"
    r"|rule of thumb|経験"
    r"|squared\b|square of|quadrat\b|quadrate?s?\s+de[rs]|[2二]乗",
    re.IGNORECASE,
)
"""Words with which a formula may be named that is not the standard one."""
_SUBORDINATE = re.compile(
    r"\b(?:although|though|while|whereas|since|because|obwohl|obgleich|während|da|weil)\s[^,;.]{3,80},",
    re.IGNORECASE,
)
"""A clause that says something else: "although they do not peak together,"."""
ROUGHLY = re.compile(r"approximat|roughly|näherung|近似", re.IGNORECASE)
_BEHIND = re.compile(
    r"[\s$`\\)\]},.]{0,8}(?:\(|(?:is|as|being|for|ist|als|für|gives|denotes)\s+)(?:(?:the|die|der|das"
    r"|its)\s+)?"
)
_MARKED_BEHIND = re.compile(
    r"[\s,(]{0,3}(?:\$|\\\(|`)\s?(?P<sign>\\?[A-Za-z]+(?:_\{?[A-Za-z0-9]+\}?)?)\s?(?:\$|\\\)|`)"
)
_AND = re.compile(r"[\s$,;\\()\[\]]*(?:and|und|bzw\.?|、|および)?[\s$,;\\()\[\]]*")
_ITEM = re.compile(r"[^\n=:]{3,80}:[\s*$]{0,4}")
_NEXT_ITEM = re.compile(r"\n(?=[^\n=:.]{3,80}:)")
"""A line that is one item of a list, its name before a colon: what stands in the next is of another."""
_NO_LETTER = re.compile(r"[\W\d_]+|\\[a-zA-Z]+")
PRODUCT = "·"
"""What stands for the letter of a product of a mass and its arm, m_A r_A."""
_ANGULAR = frozenset({"omega", "Omega"})
"""Letters of angular speeds: no words make one of them a frequency in cycles."""
BARE = 24
"""Letters in the words before a formula that its heading names: "so that", "With these"."""
NOUNLESS = 90
"""The same of words that name no quantity of the letter: "spread over the cycle this gives"."""
_OF_IT = re.compile(
    r"(?<![^\W\d_])(?:great|larg|high|max|min|peak|least|small|low|half|halb|twice|double|doppel|zwei|three|third|quarter|part|share"
    r"|differen|amplitud|rest|remain|mean|average|mittl|each|per(?!\s+(?:second|minute))|both|pair|total|whole|sum|one\s|größ|höchst|klein|scheitel|spitze"
    r"|anteil|teil|je|beide|gesamt|summe|moiti|doubl|plus\s|moyen|chaque|part|massim|minim|met[àa]|doppi|medi|ciascun|máxim|mínim|mitad"
    r"|dobl|cada)|最大|最小|半分|二倍|平均|それぞれ|合計|振幅",
    re.IGNORECASE,
)
"""Words that make another size of what the heading names."""
_LETTER_BEHIND = re.compile(
    r"(?:\s|of|is|,){0,3}(?:\$(?P<marked>[^$=]{1,24})\$|(?P<bare>\b(?!a\b"
    r"|I\b)[A-Za-zΑ-ω](?:_\{?\w{1,6}\}?)?)(?=[\s,;]))"
)
"""A letter right behind the words that name it, which is another one than the formula's."""
_NUMBER_BEHIND = re.compile(r"(?:\s|of|von|=|:){1,4}[0-9]")
"""A number right behind words: a mean effective pressure of 18 bar is that pressure's."""
_ASKS = re.compile(
    r"(?<![^\W\d_])(?:wanted|sought|required|asked(?:\s+for)?|look(?:ing)?\s+for|(?:to|we|let\s+us|now)\s+(?:find|compute|calculate|determine|derive|estimate)"
    r"|find|compute|calculate|determine|gesucht|gefragt|bestimme[nt]?|berechne[nt]?|ermittel[nt]|cherch(?:e|ons|er)|calcul(?:er|ons)|détermin(?:er|ons)"
    r"|trovare|calcolare|calcoliamo|determinare|si\s+(?:cerca|vuole|chiede)|calcular|calculamos|determinar|se\s+(?:busca|pide|quiere))(?![^\W\d_])|求め",
    re.IGNORECASE,
)
"""In a sentence that asks for a quantity, which the next one gives."""
_THIS_GIVES = re.compile(
    r"(?<![^\W\d_])(?:this|that|it|which|the\s+integral)\s+(?:gives|yields)|(?:dies|das|man|daraus)\s+(?:ergibt|liefert|erhält|folgt)"
    r"|(?:cela|ce\s+qui)\s+donne|on\s+(?:obtient|trouve)|si\s+(?:ottiene|trova)|se\s+obtiene(?![^\W\d_])|を?得る|得られる",
    re.IGNORECASE,
)
"""Words for what the sentence before has led to, which names it."""
_LEAD = re.compile(r"(?:\*\*|__)?([^.:\n]{3,60}?)(?:\*\*|__)?[.:](?=\s)")
"""The opening words of a paragraph, set off as a title."""
_ITS = re.compile(r"\b(?:its|whose|their|sein|seine|ihr|dessen|deren)\b|その", re.IGNORECASE)
"""Words that stand for a body that the sentence before names."""
_COPULA = re.compile(
    r"(?:\s|[:,=$({\[\\|*_`~—-]|<[^>]*>|\b(?:is|are|of|the|a|an|this|section|shaft|solid|round"
    r"|circular|given|by"
    r"|then|becomes|equals|ist|sind|beträgt|wird|wellen?|der|die|das|eines?r?|also|folgt|so|begin"
    r"|equation"
    r"|align|display|style|displaystyle)\b"
    r"|\b(?:in|over|along|for|auf|über)\s+(?:an?|the|its|der|die)\s+(?:length"
    r"|länge)(?:\s+of)?\s+\$?[lL]\b"
    r"|[はがを、とすると軸丸実中の])*",
    re.IGNORECASE,
)


@dataclass(frozen=True, slots=True)
class Named:
    """A quantity that words name, the words, and all the text that may qualify it."""

    quantity: Quantity
    words: str
    around: str
    sentence: str
    is_other: bool = False
    """Whether words name another shape or hypothesis: only formulas of two diameters hold."""

    is_declared: bool = False
    heading: str = ""
    is_by_form: bool = False
    """Whether the words only stand near, or tell how other formulas use the letter."""
    is_by_use: bool = False
    is_above: bool = False
    """Whether words above name the letter: another formula of it may be that, and is never refuted."""

    @property
    def cylinders(self) -> int | None:
        """The cylinders of the engine that the words around name, None where they name none."""
        text = f"{self.heading} {self.around}"
        engine = engine_named(text, len(text) + 1)
        return None if engine is None else engine[0]

    @property
    def may_refute(self) -> bool:
        """Whether the words name this quantity and no other shape or setup."""
        return not (self.is_other or self.is_above)

    end: str = ""
    """The number of the disc from which the words measure, where they say."""
    left: Formula = LETTER
    """The side that the letter stands on: ω² of ω² = k/m."""

    @property
    def formulas(self) -> tuple[Formula, ...]:
        """The standard formulas that the words leave open."""
        every = self.quantity.formulas
        return tuple(node for node in every if "outer" in names(node)) if self.is_other else every

    def formulas_for(self, sign: str) -> tuple[Formula, ...]:
        """Return those that a relation of some sign may confirm: a rough one only with ≈."""
        is_rough = (sign == "≈" or ROUGHLY.search(self.sentence) is not None) and not self.is_other
        return (*self.formulas, *self.quantity.approximate) if is_rough else self.formulas


@dataclass(frozen=True, slots=True)
class Places:
    """Where words may stand that qualify a quantity: around its formula, in the heading, on the page."""

    around: str
    heading: str
    page: str


@dataclass(frozen=True, slots=True)
class Around:
    """The words around a formula of which none stands right beside it: its sentence, and all others."""

    sentence: str
    places: Places

    def by_topic(self, quantity: Quantity, name: str) -> Named | None:
        """Return a quantity of which the paragraph or heading of a letter's formula speaks; else None."""
        near = self.places.around
        topic = quantity.phrases.search(near)
        index = index_of(name)
        if topic is None and quantity.context is not None and index and index in quantity.indices:
            topic = quantity.context.search(near)
        if topic is None or not topic[0].strip():
            return None
        named = _named(quantity, topic[0].strip(), self.places, self.sentence)
        return replace(named, is_by_form=True) if named.may_refute else None

    def by_use(self, quantity: Quantity, use: str) -> Named:
        """Return a quantity that other formulas use a letter for."""
        named = _named(quantity, use, self.places, self.sentence)
        return replace(named, is_by_form=True, is_by_use=True)


@dataclass
class QuantityWords:
    """Reads the words of one document around its formulas."""

    document: ReadNotes
    sections: Sections
    roles: LetterRoles
    words_above: dict[str, str] = field(default_factory=dict)
    """The words by which letters were named that had a standard formula."""
    _phrases: dict[str, list[tuple[int, int, Quantity]]] = field(default_factory=dict, init=False)
    """The phrases of quantities in a text, with their places: one text is asked for several letters."""

    @cached_property
    def glossary(self) -> Glossary:
        """The English terms of the page's language."""
        return glossary_of(self.document.text)

    @cached_property
    def page(self) -> str:
        """The text of the page with its terms in English."""
        return self.glossary.english(self.document.text)

    @cached_property
    def _ends_of_entries(self) -> list[int]:
        return ends_of_entries(self.document.text)

    def _heading(self, chain: Chain) -> str:
        """Return the heading above a relation with its terms in English."""
        return self.glossary.english(self.sections.heading_above(chain.lines[0]))

    def named(self, name: str, chain: Chain, knowledge: Knowledge) -> Iterator[Named]:
        """Yield the quantities that a letter may be, by its declared meaning or the words around it."""
        sentence, _, _ = self._texts(chain)
        is_rough = ROUGHLY.search(sentence) is not None
        if _DENIED.search(_SUBORDINATE.sub(" ", sentence)):
            return
        for named in self._every_named(name, chain, knowledge):
            if not is_rough or named.quantity.approximate:
                yield named

    def _every_named(self, name: str, chain: Chain, knowledge: Knowledge) -> Iterator[Named]:
        name_alone = without_accent(name)
        stem, _, index = name_alone.removeprefix("Delta_").partition("_")
        stem = stem.rstrip("'")
        stem = f"Delta_{stem}" if name.startswith("Delta_") else stem
        stem = PRODUCT if " " in name else stem
        declared = knowledge.meanings.get(name, "")
        sentence, before, around = self._texts(chain)
        heading = self._heading(chain)
        meanings = " ".join(knowledge.meanings.values())
        places = Places(around, heading, f"{self.page} {meanings}")
        by_meaning = [
            replace(named, is_declared=True)
            for named in self._by_phrases(declared, stem, places, declared)
        ]
        phrase = self.glossary.english(self.sections.phrases_in_order.of(chain))
        by_phrase = list(self._by_phrases(phrase, stem, places, sentence, name))
        by_phrase = by_phrase or list(self._by_phrases(before, stem, places, sentence, name))
        if by_meaning or (declared and not UNITS_ONLY.fullmatch(declared)):
            words = {named.words.casefold() for named in by_meaning}
            is_closer = any(w in named.words.casefold() for w in words for named in by_phrase)
            yield from by_phrase if is_closer else by_meaning  # a bending section modulus
            if not is_closer:
                told = {id(named.quantity) for named in by_meaning}
                yield from (
                    named
                    for named in by_phrase
                    if named.quantity.only is not None
                    and stem in named.quantity.letters
                    and id(named.quantity) not in told
                )
            return
        by_phrase = by_phrase or list(self.by_clause(name, chain, stem, places))
        by_phrase = by_phrase or list(self._by_words_behind(chain, stem, places, sentence))
        by_phrase = by_phrase or list(self._by_words_around(chain, before, stem, places, sentence))
        if stem == PRODUCT:
            by_phrase = by_phrase or list(self._by_phrases(around, stem, places, sentence))
        else:
            by_phrase = by_phrase or list(self._by_letter(name, stem, places, sentence))
        if by_phrase:
            yield from by_phrase
            return
        if name in self.words_above:
            above = self._by_phrases(self.words_above[name], stem, places, sentence)
            yield from (replace(each, is_above=True) for each in above)
        is_named = False
        for named in self._by_pronoun(chain, before, stem, places, sentence):
            is_named = True
            yield named
        if is_named:
            return
        yield from self._by_heading(chain, stem, index, (before, sentence), places)

    def _by_heading(
        self, chain: Chain, stem: str, index: str, texts: tuple[str, str], places: Places
    ) -> Iterator[Named]:
        """Yield the quantities that a heading or the words leading in name; a sentence names none."""
        before, sentence = texts
        around, heading = places.around, places.heading
        length = len(_NO_LETTER.sub("", before))
        own = [quantity for _, _, quantity in self._phrases.get(before, ()) if stem in quantity.letters]
        is_bare = length <= BARE or (length <= NOUNLESS and not own and not _OF_IT.search(before))
        lead = (self._lead_in(chain) or self._wanted(chain)) if is_bare else ""
        lead = lead or (self._given_by_this(chain, before) if is_bare else "")
        noun = _last_noun(before)
        for quantity in QUANTITIES:
            if stem not in quantity.letters:
                continue
            title = quantity.phrases.search(heading) or quantity.phrases.search(lead)
            if title is not None and (is_bare or (noun and noun in title[0].casefold().split()[:1])):
                yield _named(quantity, title[0].strip(), places, sentence)
                continue
            if quantity.context is None or (quantity.indices and index not in quantity.indices):
                continue
            match = quantity.context.search(before) or quantity.context.search(heading)
            if match is not None:
                wider = replace(places, around=f"{around} {heading}")
                yield _named(quantity, match[0].strip(), wider, sentence)

    def sentence_before(self, chain: Chain) -> str:
        """Return the words of a relation's sentence that stand before it."""
        return self._texts(chain)[1]

    def around(self, chain: Chain) -> Around | None:
        """Return the words of a relation's paragraph and heading; None where they deny or approximate."""
        sentence, _, around = self._texts(chain)
        heading = self._heading(chain)
        behind = _BLANK.split(self.document.text[chain.end : chain.end + SENTENCE])[0]
        near = f"{heading}\n{around}\n{self.glossary.english(behind)}"
        if _DENIED.search(near) or ROUGHLY.search(sentence):
            return None
        return Around(sentence, Places(near, heading, self.page))

    def by_words(self, words: str, name: str, chain: Chain) -> Iterator[Named]:
        """Yield the quantities that words name which stand elsewhere, in a unit."""
        sentence, _, around = self._texts(chain)
        heading = self._heading(chain)
        places = Places(around, heading, self.page)
        yield from self._by_phrases(words, name.partition("_")[0], places, sentence)

    def by_clause(self, name: str, chain: Chain, stem: str, places: Places) -> Iterator[Named]:
        """Yield what a letter was named in the clause before: the torque is T = …, of the other T = …

        Only the words of its own clause qualify it then; without any, as in ω_1 = … and ω_2 = …, those
        of the sentence.
        """
        start = chain.start
        above = self.sections.chain_before(start)
        head = above.sides[0].node if above is not None else None
        if above is None or not isinstance(head, Name):
            return
        clause = self.document.text[above.end : start]
        if len(clause) > SENTENCE or SENTENCE_END.search(clause):
            return
        clause = self.glossary.english(clause)
        sentence, before, _ = self._texts(above)
        if _AND.fullmatch(clause) and head.name.partition("_")[0] == stem:
            own = replace(places, around=sentence)
        elif head == Name(name) and _NO_LETTER.sub("", clause):
            own = Places(clause, sentence, "")  # what the sentence says, its own clause may deny
        else:
            return
        for named in self._by_phrases(before, stem, own, clause):
            if named.quantity.only is not None and not named.is_other:
                yield named

    def _by_words_behind(self, chain: Chain, stem: str, places: Places, sentence: str) -> Iterator[Named]:
        """Yield the quantities that words right behind a formula name: σ = M/W is the bending stress."""
        end = chain.end
        behind = self.glossary.english(self.document.text[end : end + SENTENCE])
        link = _BEHIND.match(behind)
        if link is None:
            return
        matches = [
            (match.end(), quantity, match[0])
            for quantity in QUANTITIES
            if stem in quantity.letters
            and (match := quantity.phrases.match(behind, link.end())) is not None
        ]
        last = max((stop for stop, _, _ in matches), default=0)
        for stop, quantity, words in matches:
            if stop == last:
                yield _named(quantity, words, places, sentence.replace(words, ""))

    def _lead_in(self, chain: Chain) -> str:
        """Return the few words that open a relation's paragraph like a title: "Radial force. Along …"."""
        start = chain.start
        above = _BLANK.split(bare(self.document.text[max(0, start - PARAGRAPH) : start]))[-1]
        other = self.sections.chain_before(start)
        is_first = (
            other is None
            or not isinstance(other.sides[0].node, Name)
            or not names(other.sides[-1].node)
            or self.document.source(other.sides[0].span) + " " not in above
        )
        match = _LEAD.match(self.glossary.english(above))
        return match[1] if match is not None and is_first else ""

    def _wanted(self, chain: Chain) -> str:
        """Return the sentence before a relation's if it asks for something: the stress is wanted. So …"""
        above = self.sections.chain_before(chain.start)
        first = max(chain.start - PARAGRAPH, 0 if above is None else above.end)
        sentences = SENTENCE_END.split(bare(self.document.text[first : chain.start]))
        asked = sentences[-2] if len(sentences) > 1 else ""
        return self.glossary.english(asked) if _ASKS.search(asked) else ""

    def _given_by_this(self, chain: Chain, before: str) -> str:
        """Return the sentence before a relation's if its own only says: about a diameter this gives …"""
        above = self.sections.chain_before(chain.start)
        first = max(chain.start - PARAGRAPH, 0 if above is None else above.end)
        paragraph = _BLANK.split(bare(self.document.text[first : chain.start]))[-1]
        sentences = SENTENCE_END.split(paragraph)
        if len(sentences) < 2 or not _THIS_GIVES.search(before):
            return ""
        return self.glossary.english(sentences[-2])

    def _by_words_around(
        self, chain: Chain, before: str, stem: str, places: Places, sentence: str
    ) -> Iterator[Named]:
        """Yield the quantities that words name around a formula: the thrust H = … against the liner."""
        end = chain.end
        after = SENTENCE_END.split(self.document.text[end : end + AFTER])[0].lstrip(" $)\\]")
        after = self.glossary.english(after)
        words = before.rstrip(" $(\\[") + " "
        matches = [
            (match, quantity)
            for quantity in QUANTITIES
            if stem in quantity.letters
            for match in quantity.phrases.finditer(words + after)
            if match.start() < len(words) < match.end()
        ]
        for match, quantity in matches:
            yield _named(quantity, match[0], places, sentence)

    def _by_pronoun(
        self, chain: Chain, before: str, stem: str, places: Places, sentence: str
    ) -> Iterator[Named]:
        """Yield those of the body that the sentence before names: the rim …; its inertia is I."""
        if _ITS.search(before) is None or "moment" not in before.casefold():
            return
        start = chain.start
        above = self.document.text[max(0, start - PARAGRAPH) : start]
        above = self.glossary.english(_BLANK.split(bare(above))[-1]).removesuffix(before)
        for named in self._by_phrases(
            SENTENCE_END.split(above.rstrip(" .;\n"))[-1], stem, places, sentence
        ):
            if "moment of inertia" in named.quantity.name:
                yield named

    def _by_letter(self, name: str, stem: str, places: Places, sentence: str) -> Iterator[Named]:
        """Yield the quantities that words beside a letter name anywhere on the page."""
        for words in dict.fromkeys((*self.roles.words_before(name), *self.roles.said_behind(name))):
            named = list(self._by_phrases(words, stem, places, sentence))
            yield from (each for each in named if ends_with(each.quantity.phrases, words))

    def _is_of_another_letter(self, words: str, end: int, name: str) -> bool:
        """Tell whether a phrase is followed by another letter at once: the mean stress s_m."""
        letter = _MARKED_BEHIND.match(words, end)
        own = name.split()  # of the product m_G r_G, each of its letters
        return (
            bool(own)
            and letter is not None
            and not any(re.fullmatch(sign_of(each), letter["sign"]) for each in own)
        )

    def _by_phrases(
        self, words: str, stem: str, places: Places, sentence: str, name: str = ""
    ) -> Iterator[Named]:
        """Yield the quantities that words name, those with the letter's usual use first of all."""
        if words not in self._phrases:
            self._phrases[words] = [
                (*match.span(), quantity)
                for quantity in (QUANTITIES if words else ())
                for match in quantity.phrases.finditer(words)
            ]
        everywhere = f"{words} {places.around} {places.heading} {places.page}"
        matches = [
            (start, end, quantity)
            for start, end, quantity in self._phrases[words]
            if _may_apply(quantity, everywhere)
        ]
        matches = [each for each in matches if not self._is_of_another_letter(words, each[1], name)]
        if stem == PRODUCT:  # "each shaft carries" names a mass too, by more words
            matches = [each for each in matches if stem in each[2].letters] or matches
        special = [each for each in matches if _is_told(each[2], places, sentence)]
        matches = special or matches  # an order is a pendulum's on pages of pendulums only
        longest = [
            (start, end, quantity)
            for start, end, quantity in matches
            if not any(s <= start and end <= e and e - s > end - start for s, e, _ in matches)
        ]
        longest = [each for each in longest if not _names_another(words, each[1], stem, name)]
        usual = [each for each in longest if stem in each[2].letters]
        if not usual and stem not in _ANGULAR:
            last = max((end for _, end, _ in longest), default=0)
            usual = [each for each in longest if each[1] == last and _COPULA.fullmatch(words[last:])]
            usual = usual if len({start for start, _, _ in longest}) == 1 else []
        last = max((end for _, end, _ in usual), default=0)
        for start, end, quantity in usual:
            if end == last:
                rest = sentence.replace(words[start:end], "")
                yield _named(quantity, words[start:end].strip(), places, rest)

    def _texts(self, chain: Chain) -> tuple[str, str, str]:
        """Return a relation's sentence, what of it stands right before, and what is around."""
        text, start = self.document.text, chain.start
        end = chain.end
        words = bare(text[max(0, start - PARAGRAPH) : start])
        sentence = SENTENCE_END.split(words[-SENTENCE:])[-1]
        above = self.sections.chain_before(start)
        first = 0 if above is None else above.end
        last = max(0, start - PARAGRAPH) + len(words)
        entries = bisect_right(self._ends_of_entries, start)
        if entries:  # a list of symbols is of other letters
            first = max(first, self._ends_of_entries[entries - 1])
            sentence = sentence[-max(1, last - first) :]
        before = sentence[-(last - first) :] if last - first < len(sentence) else sentence
        before = before if last > first else ""
        paragraphs = " ".join(_BLANK.split(words)[-2:])
        after = _NEXT_ITEM.split(SENTENCE_END.split(text[end : end + AFTER])[0])[0]
        item = _ITEM.fullmatch(words[words.rfind("\n") + 1 :])
        if item is not None and sentence.endswith(item[0]):
            sentence = item[0]
        english = self.glossary.english
        return english(f"{sentence} {after}"), english(before), english(f"{paragraphs} {after}")


def _named(quantity: Quantity, words: str, places: Places, sentence: str) -> Named:
    """Return a quantity that words name, and whether other words near make another one of it."""
    near = f"{places.around} {places.heading}" if quantity.only else places.around
    own = f"{sentence} {words}"
    is_told_here = quantity.only is not None and quantity.only.search(own) is not None
    may_be_denied = own if is_told_here else f"{places.around} {own}"  # its own sentence tells the shape
    is_other = quantity.unless is not None and quantity.unless.search(may_be_denied) is not None
    is_other |= quantity.never is not None and quantity.never.search(places.page) is not None
    if quantity.only is not None and not quantity.only.search(f"{near} {own}"):
        is_on_page = quantity.is_told_once and quantity.only.search(places.page) is not None
        is_other |= not is_on_page or (
            quantity.unless is not None and quantity.unless.search(places.page) is not None
        )
    return Named(quantity, words, places.around, sentence, is_other, heading=places.heading)


def _last_noun(before: str) -> str:
    """Return the last word before a formula that is no "is" or "the"."""
    words = [w for w in re.findall(r"[^\W\d_]{3,}", before) if not _COPULA.fullmatch(w)]
    return words[-1].casefold() if words else ""


def _names_another(words: str, end: int, stem: str, name: str) -> bool:
    """Tell whether a letter stands right behind words that another letter is named by.

    In "the power for a mean effective pressure $p_e$ is P = …" the pressure is not what P is.
    """
    match = _LETTER_BEHIND.match(words, end)
    if match is None:
        return _NUMBER_BEHIND.match(words, end) is not None
    letter = match["marked"] or match["bare"]
    if stem == PRODUCT and any(re.fullmatch(sign_of(each), letter) for each in name.split()):
        return False  # the counterweight $m_G$, of which the product m_G r_G is
    return not re.match(rf"\\?{re.escape(stem)}(?![A-Za-z])", letter)


def _may_apply(quantity: Quantity, text: str) -> bool:
    """Tell whether a text has the words without which a quantity is not meant at all."""
    return quantity.only is None or quantity.only.search(text) is not None


def _is_told(quantity: Quantity, places: Places, sentence: str) -> bool:
    """Tell whether the words are there without which a quantity is not meant."""
    near = f"{places.around} {places.heading} {sentence}"
    near = f"{near} {places.page}" if quantity.is_told_once else near
    return quantity.only is None or quantity.only.search(near) is not None
