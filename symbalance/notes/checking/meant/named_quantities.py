"""Letters whose quantity words name: "the bending stress is σ = 16 M/(π d³)" is wrong by a factor.

The first formula of a letter is a definition, and true of any letter. Where words name a quantity that
has a standard formula (`known_formulas`) and the letters fit its roles, it says more:

    it agrees exactly                          conditional on what the letter is taken to be
    it differs by one slip of the usual kinds  refuted, with that assumption and the standard formula
    anything else                              None: a definition, as before

Soundness comes before reach: another shape, another hypothesis, a part or a multiple in the words, a
letter that words call something else, or any formula that the same words may mean: nothing is refuted.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property

from symbalance.budgets import Budget, OverBudgetError, run_within
from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Number,
    Sum,
    names,
    walk,
)
from symbalance.document.letters import plain_letter
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision, without_dots
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.meant.catalogue import QUANTITIES, Quantity
from symbalance.notes.checking.meant.formula_slips import agrees, differs, is_multiple, slip_of
from symbalance.notes.checking.meant.left_sides import LETTER, as_side, head_of
from symbalance.notes.checking.meant.letter_roles import (
    UNITS_ONLY,
    LetterRoles,
    ends_with,
    sign_of,
    without_accent,
)
from symbalance.notes.checking.meant.meant_words import NOBODY
from symbalance.notes.checking.repair.fixes import Repair, add_fix, fix_of, is_proved_as_far
from symbalance.notes.checking.verdicts import DEFINITION, Verdict
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading.equations import Chain, ReadNotes, Side

SEARCH, SHARE = Budget(4), 0.6
"""What this may take, and of what is left of the relation's budget: a definition stays one without it."""
SENTENCE, PARAGRAPH, AFTER = 220, 500, 60
"""Characters that are looked through: before a formula for its name, and around for another shape."""
_ONE_TERM = re.compile(r"order|exponent|number misprinted .*|sign|factor -?[0-9/]+")
_SENTENCE_END = re.compile(r"[.;!?](?:\s|$)|[。；]|\n\s*\n|<p\b|<li\b|\\item|\\section|\n#|\n\|")
_BLANK = re.compile(r"\n\s*\n")
_OPENING = re.compile(
    r"(?:\s|\$+|\\[\[(]|\\begin\{[a-z]+\*?\}|\\displaystyle|&|\||<p>|<div>"
    r"|<math>|`)+$"
)
"""What stands between words and the formula that is set off from them."""
_PART = re.compile(
    r"\b(?:two|three|four|five|six|eight|twelve)\b(?![- ]stroke)|\bboth\b|\beach\b|\bpairs?\b"
    r"|\btwice\b|twin"
    r"|\bdoubled?\b|\bhalf\b|\bhalv|\bmean\b|\baverage|amplitude|alternating|boxer|\bV\d|together"
    r"|\bequal\b"
    r"|\bzwei(?!takt)|\bbeide[nrs]?\b|\bdrei|\bvier(?!takt)|\bsechs|\bacht|\bjede[rsnm]?\b|\bje\b"
    r"|\bdoppel"
    r"|\bhalbe?[nrs]?\b|mittlere|durchschnitt|ausschlag|wechsel|schwell|zusammen|reduced"
    r"|reduziert|equivalent length"
    r"|\bsafety|sicherheit|\bfactor\b|faktor|beiwert|dynamic|impact|stoß|安全率|衝撃|vehicle"
    r"|fahrzeug|車両|whole"
    r"|平均|振幅|両|[二三四六八2-9]つ|[2-9２-９][本個枚]|[2-9二三四六八]気筒|全体|半分|それぞれ"
    r"|各|片側|差|合計|倍"
    r"|differen|relative|proportional|\bsum\b|summe|\btotal|gesamt|ratio of|verhältnis",
    re.IGNORECASE,
)
"""Words that make of a quantity a part or a multiple of it: no factor in it is a slip."""
_SETTING = re.compile(
    r"\b(?:on|between|auf|zwischen|in) (?:two|zwei) \w+|\b(?:at )?both ends|\bbeidseitig|両端",
    re.IGNORECASE,
)
"""Words with a number that make nothing a part: a shaft on two bearings."""
_DENIED = re.compile(
    r"\bnot\b|\binstead\b|\bwrong|mistak|confus|unlike|\bnicht\b|\bstatt\b|anstelle|falsch"
    r"|verwechs|ではない|でなく"
    r"|誤り|間違|another book|older|empiric|faustformel"
    r"|rule of thumb|経験"
    r"|squared\b|square of|quadrat\b|quadrate?s?\s+de[rs]|[2二]乗",
    re.IGNORECASE,
)
"""Words with which a formula may be named that is not the standard one."""
_ROUGHLY = re.compile(r"approximat|roughly|näherung|近似", re.IGNORECASE)
_FROM_ELSEWHERE = re.compile(
    r"\b(?:from|von|vom|ab|gegen|against|aus)\b[^.\n]{0,30}?(?:bottom|outer dead|lower dead|\bBDC\b"
    r"|vertical|horizontal"
    r"|perpendicular|unteren? totp|\bUT\b|äußeren totp|senkrecht|waagrecht|vertikal|lotrecht)"
    r"|(?:下死点|水平|鉛直|垂直)[^。\n]{0,10}から",
    re.IGNORECASE,
)
"""Words for another place where an angle begins: a sine is a cosine there."""
_BEHIND = re.compile(
    r"[\s$`\\)\]},.]{0,8}(?:\(|(?:is|as|being|for|ist|als|für|gives|denotes)\s+)(?:(?:the|die|der|das|its)\s+)?"
)
_LETTER_BEHIND = re.compile(
    r"[\s,(]{0,3}(?:\$|\\\(|`)\s?(?P<sign>\\?[A-Za-z]+(?:_\{?[A-Za-z0-9]+\}?)?)\s?(?:\$|\\\)|`)"
)
_AND = re.compile(r"[\s$,;\\()\[\]]*(?:and|und|bzw\.?|、|および)?[\s$,;\\()\[\]]*")
_NO_LETTER = re.compile(r"[\W\d_]+|\\[a-zA-Z]+")
_ANGULAR = frozenset({"omega", "Omega"})
"""Letters of angular speeds: no words make one of them a frequency in cycles."""
BARE = 24
"""Letters in the words before a formula that its heading names: "so that", "With these"."""
_FUNCTIONS = ("sqrt", "sin", "cos", "tan", "atan")
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
class _Named:
    """A quantity that words name, the words, and all the text that may qualify it."""

    quantity: Quantity
    words: str
    around: str
    sentence: str
    is_other: bool = False
    """Whether words name another shape or hypothesis: only formulas of two diameters hold."""

    is_declared: bool = False
    left: Formula = LETTER
    """The side that the letter stands on: ω² of ω² = k/m."""

    @property
    def formulas(self) -> tuple[Formula, ...]:
        """The standard formulas that the words leave open."""
        every = self.quantity.formulas
        return tuple(node for node in every if "outer" in names(node)) if self.is_other else every

    def formulas_for(self, sign: str) -> tuple[Formula, ...]:
        """Return those that a relation of some sign may confirm: a rough one only with ≈."""
        is_rough = sign == "≈" and not self.is_other
        return (*self.formulas, *self.quantity.approximate) if is_rough else self.formulas


@dataclass(frozen=True, slots=True)
class _Places:
    """Where words may stand that qualify a quantity: around its formula, in the heading, on the page."""

    around: str
    heading: str
    page: str


@dataclass
class NamedQuantities:
    """Judges the formulas of one document whose quantity the words around name."""

    document: ReadNotes
    sections: Sections

    @cached_property
    def roles(self) -> LetterRoles:
        """The roles that the letters of the document may have."""
        return LetterRoles(self.document.text)

    @cached_property
    def counts_from_elsewhere(self) -> bool:
        """Tell whether an angle is counted from somewhere else than the top dead centre."""
        return _FROM_ELSEWHERE.search(self.document.text) is not None

    def judge(self, chain: Chain, k: int, knowledge: Knowledge) -> Verdict | Decision | None:
        """Return the verdict on a relation that gives a named quantity a formula; None for others.

        It stays a definition, with the reason, where the search took more than its share of the budget.
        """
        left, right = chain.sides[k].node, without_dots(chain.sides[k + 1].node)[0]
        head = head_of(left)
        is_plain = k == 0 and head is not None and chain.relations[0].sign in "=≈"
        own = names(right)
        if not is_plain or head is None or not 1 <= len(own) <= 5 or head in own:
            return None
        if any(isinstance(part, Call) and part.function not in _FUNCTIONS for part in walk(right)):
            return None
        try:
            return run_within(SEARCH, lambda: self._judge(chain, head, right, knowledge), SHARE)
        except OverBudgetError as problem:
            reason = f"whether its words name a standard formula was not decided within {problem.spent}"
            return Decision(DEFINITION, reason)

    def of_another(self, chain: Chain, k: int, knowledge: Knowledge) -> Verdict | Decision | None:
        """Return the verdict on a letter's formula where its clause names it of something else.

        That is of another engine or shaft than in the clause before: it has another value then.
        """
        left = chain.sides[0].node
        if k or not isinstance(left, Name) or knowledge.meanings.get(left.name):
            return None
        stem = left.name.partition("_")[0]
        is_another = any(
            not named.is_other for named in self._by_clause(left.name, chain, stem, _Places("", "", ""))
        )
        return self.judge(chain, k, knowledge) if is_another else None

    def _judge(
        self, chain: Chain, name: str, claim: Formula, knowledge: Knowledge
    ) -> Verdict | Decision | None:
        known = Knowledge(SymbolValue(positive=frozenset(names(claim))), corrects=True)
        side = chain.sides[1]
        left = chain.sides[0].node
        candidates = [replace(each, left=left) for each in self._named(name, chain, knowledge)]
        sign = chain.relations[0].sign
        pairs = [
            (named, target)
            for named in candidates
            for target in self._targets(named.formulas_for(sign), claim, name, named, knowledge)
        ]
        for named, target in pairs:
            if not decimals(claim) and not agrees(target, claim):
                continue  # a proof costs more than a comparison
            decision = decide(Side((target,), side.span), side, sign, known)
            is_rough = target in self._targets(named.quantity.approximate, claim, name, named, knowledge)
            if decision.is_proved and not decision.order:
                signs = {f"{n} ≥ 0" for n in names(claim)}
                signs |= {f"{plain_letter(n)} ≥ 0" for n in names(claim)}
                rest = [text for text in decision.assumptions if text not in signs]
                rest += ["the rod is long"] if is_rough else []
                return replace(decision, assumptions=(self._text(name, named), *rest))
        fitting = {named.quantity.name: named for named in candidates if not named.is_other}
        if len(fitting) > 1:  # words that name several: by the letters of their formulas
            fitting = {n: each for n, each in fitting.items() if any(p is each for p, _ in pairs)}
            told = {n: each for n, each in fitting.items() if each.quantity.only is not None}
            fitting = told if len(told) == 1 else fitting
        if len(fitting) != 1:
            return None
        (named,) = fitting.values()
        if named.quantity.turns and self.counts_from_elsewhere:
            return None
        targets = [target for each, target in pairs if each is named]
        targets += self._targets(named.quantity.approximate, claim, name, named, knowledge)
        return self._with_slip(chain, name, claim, named, targets, known, knowledge)

    def _targets(
        self,
        formulas: tuple[Formula, ...],
        claim: Formula,
        name: str,
        named: _Named,
        knowledge: Knowledge,
    ) -> list[Formula]:
        """Return the formulas of a quantity in the letters of a claim."""
        together = named.quantity.together
        shaped = tuple(as_side(named.left, formula) for formula in formulas)
        return list(self.roles.targets(shaped, claim, knowledge.meanings, together, name))

    def _text(self, name: str, named: _Named) -> str:
        source = f"{NOBODY}; taken from the words “{named.words}”"
        source = f"declared as “{named.words}”" if named.is_declared else source
        return f"{plain_letter(name)} is the {named.quantity.name} ({source})"

    # What words name

    def _named(self, name: str, chain: Chain, knowledge: Knowledge) -> Iterator[_Named]:
        """Yield the quantities that a letter may be, by its declared meaning or the words around it."""
        sentence, _, _ = self._texts(chain)
        is_rough = chain.relations[0].sign == "≈" and _ROUGHLY.search(sentence) is not None
        if _DENIED.search(sentence) or (_ROUGHLY.search(sentence) and not is_rough):
            return
        for named in self._every_named(name, chain, knowledge):
            if not is_rough or named.quantity.approximate:
                yield named

    def _every_named(self, name: str, chain: Chain, knowledge: Knowledge) -> Iterator[_Named]:
        name_alone = without_accent(name)
        stem, _, index = name_alone.removeprefix("Delta_").partition("_")
        stem = f"Delta_{stem}" if name.startswith("Delta_") else stem
        declared = knowledge.meanings.get(name, "")
        sentence, before, around = self._texts(chain)
        heading = self.sections.heading_above(chain.lines[0])
        meanings = " ".join(knowledge.meanings.values())
        places = _Places(around, heading, f"{self.document.text} {meanings}")
        by_meaning = [
            replace(named, is_declared=True)
            for named in self._by_phrases(declared, stem, places, declared)
        ]
        by_phrase = list(self._by_phrases(before, stem, places, sentence, name))
        if by_meaning or (declared and not UNITS_ONLY.fullmatch(declared)):
            words = {named.words.casefold() for named in by_meaning}
            is_closer = any(w in named.words.casefold() for w in words for named in by_phrase)
            yield from by_phrase if is_closer else by_meaning  # a bending section modulus
            return
        by_phrase = by_phrase or list(self._by_clause(name, chain, stem, places))
        by_phrase = by_phrase or list(self._by_words_behind(chain, stem, places, sentence))
        by_phrase = by_phrase or list(self._by_letter(name, stem, places, sentence))
        if by_phrase:
            yield from by_phrase
            return
        is_bare = len(_NO_LETTER.sub("", before)) <= BARE
        for quantity in QUANTITIES:
            if stem not in quantity.letters:
                continue
            title = quantity.phrases.search(heading) if is_bare else None
            if title is not None:
                yield _named(quantity, title[0].strip(), places, sentence)
                continue
            if quantity.context is None or (quantity.indices and index not in quantity.indices):
                continue
            match = quantity.context.search(before) or quantity.context.search(heading)
            if match is not None:
                wider = replace(places, around=f"{around} {heading}")
                yield _named(quantity, match[0].strip(), wider, sentence)

    def _by_clause(self, name: str, chain: Chain, stem: str, places: _Places) -> Iterator[_Named]:
        """Yield what a letter was named in the clause before: the torque is T = …, of the other T = …

        Only the words of its own clause qualify it then; without any, as in ω_1 = … and ω_2 = …, those
        of the sentence.
        """
        start = chain.start
        end, above = self._chain_before(start)
        head = above.sides[0].node if above is not None else None
        if above is None or not isinstance(head, Name):
            return
        clause = self.document.text[end:start]
        if len(clause) > SENTENCE or _SENTENCE_END.search(clause):
            return
        sentence, before, _ = self._texts(above)
        if _AND.fullmatch(clause) and head.name.partition("_")[0] == stem:
            own = replace(places, around=sentence)
        elif head == Name(name) and _NO_LETTER.sub("", clause):
            own = _Places(clause, sentence, "")  # what the sentence says, its own clause may deny
        else:
            return
        for named in self._by_phrases(before, stem, own, clause):
            if named.quantity.only is not None and not named.is_other:
                yield named

    def _by_words_behind(
        self, chain: Chain, stem: str, places: _Places, sentence: str
    ) -> Iterator[_Named]:
        """Yield the quantities that words right behind a formula name: σ = M/W is the bending stress."""
        end = chain.end
        link = _BEHIND.match(self.document.text, end)
        if link is None:
            return
        matches = [
            (match.end(), quantity, match[0])
            for quantity in QUANTITIES
            if stem in quantity.letters
            and (match := quantity.phrases.match(self.document.text, link.end())) is not None
        ]
        last = max((stop for stop, _, _ in matches), default=0)
        for stop, quantity, words in matches:
            if stop == last:
                yield _named(quantity, words, places, sentence.replace(words, ""))

    def _by_letter(self, name: str, stem: str, places: _Places, sentence: str) -> Iterator[_Named]:
        """Yield the quantities that words right before a letter name anywhere on the page."""
        for words in dict.fromkeys(self.roles.words_before(name)):
            named = list(self._by_phrases(words, stem, places, sentence))
            yield from (each for each in named if ends_with(each.quantity.phrases, words))

    def _is_of_another_letter(self, words: str, end: int, name: str) -> bool:
        """Tell whether a phrase is followed by another letter at once: the mean stress s_m."""
        letter = _LETTER_BEHIND.match(words, end)
        return bool(name) and letter is not None and not re.fullmatch(sign_of(name), letter["sign"])

    def _by_phrases(
        self, words: str, stem: str, places: _Places, sentence: str, name: str = ""
    ) -> Iterator[_Named]:
        """Yield the quantities that words name, those with the letter's usual use first of all."""
        matches = [
            (match.start(), match.end(), quantity)
            for quantity in QUANTITIES
            for match in quantity.phrases.finditer(words)
        ]
        matches = [each for each in matches if not self._is_of_another_letter(words, each[1], name)]
        told = [each for each in matches if _is_told(each[2], places, sentence)]
        matches = told or matches  # an order is a pendulum's on pages of pendulums only
        longest = [
            (start, end, quantity)
            for start, end, quantity in matches
            if not any(s <= start and end <= e and e - s > end - start for s, e, _ in matches)
        ]
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

    @cached_property
    def _ends(self) -> list[tuple[int, Chain]]:
        """The ends of the document's relations, in order."""
        chains = [chain for chain in self.document.chains if chain.relations]
        ends = [(chain.end, chain) for chain in chains]
        return sorted(ends, key=lambda pair: pair[0])

    def _chain_before(self, start: int) -> tuple[int, Chain | None]:
        """Return the last chain before a place with its end; 0 and None for the first."""
        place = bisect_right(self._ends, start, key=lambda pair: pair[0])
        return self._ends[place - 1] if place else (0, None)

    def _texts(self, chain: Chain) -> tuple[str, str, str]:
        """Return a relation's sentence, what of it stands right before, and what is around."""
        text, start = self.document.text, chain.start
        end = chain.end
        words = _OPENING.sub("", text[max(0, start - PARAGRAPH) : start])
        sentence = _SENTENCE_END.split(words[-SENTENCE:])[-1]
        first = max(0, self._chain_before(start)[0])
        last = max(0, start - PARAGRAPH) + len(words)
        before = sentence[-(last - first) :] if last - first < len(sentence) else sentence
        before = before if last > first else ""
        paragraphs = " ".join(_BLANK.split(words)[-2:])
        after = _SENTENCE_END.split(text[end : end + AFTER])[0]
        return f"{sentence} {after}", before, f"{paragraphs} {after}"

    # What is wrong

    def _with_slip(
        self,
        chain: Chain,
        name: str,
        claim: Formula,
        named: _Named,
        targets: list[Formula],
        known: Knowledge,
        knowledge: Knowledge,
    ) -> Verdict | None:
        """Return that a formula is wrong by one slip, with the standard one; None where that is open."""
        quantity = named.quantity
        others = self._targets(quantity.others, claim, name, named, knowledge)
        others += self._targets(quantity.approximate, claim, name, named, knowledge)
        if any(agrees(other, claim) for other in others) or decimals(claim):
            return None
        if _has_complement(claim, knowledge):
            return None
        is_scaled = any(self.roles.is_multiplied(n) for n in names(claim))
        is_in_words = _PART.search(_SETTING.sub("", named.sentence)) is not None
        may_be_part = is_in_words or _has_own_convention(claim, knowledge)
        may_be_part = is_scaled or (may_be_part and "part" not in quantity.slips)
        mistakes = self._targets(quantity.mistakes, claim, name, named, knowledge)
        is_mistake = any(agrees(each, claim) for each in mistakes)
        if (
            is_mistake and not targets and not may_be_part
        ):  # without one of the letters: no fix in its own
            standard = formula_text(quantity.formulas[0], plain=True).replace("_", " ")
            reason = f"if {self._text(name, named)}, which is {standard}"
            return describe(self.document, chain, 0, Decision(REFUTED, reason))
        for target in targets:
            kind = slip_of(target, claim, quantity.slips, may_be_part)
            if (
                not kind
                and is_mistake
                and not (may_be_part and is_multiple(target, claim))
                and not is_scaled
            ):
                kind = "another formula"
            if not kind:
                continue
            side = chain.sides[1]
            left = Side((target,), chain.sides[0].span)
            decision = decide(left, side, chain.relations[0].sign, known)
            if decision.status == UNDECIDED and differs(target, claim):
                decision = replace(decision, status=REFUTED)  # complex where letters are large: √(1 - D²)
            if decision.status != REFUTED:
                continue
            decision = replace(decision, reason=f"if {self._text(name, named)}")
            verdict = self._with_fix(chain, left, decision, known)
            fix = verdict.fix
            is_one_change = fix is not None and len(fix.faults) == 1 and not fix.of_left
            change = "exponent" if kind == "power of a term" else _ONE_TERM
            if is_one_change and fix is not None and re.fullmatch(change, fix.kind):
                return verdict
            if kind in ("term", "power of a term"):
                continue
            repair = Repair(kind, target, ((side.node, target),), 1.0)
            return replace(verdict, fix=fix_of(repair, self.document, side))
        return None

    def _with_fix(self, chain: Chain, left: Side, decision: Decision, known: Knowledge) -> Verdict:
        side = chain.sides[1]

        def proves(node: Formula) -> bool:
            return is_proved_as_far(decide(left, Side((node,), side.span), "≈", known), decision)

        verdict = describe(self.document, chain, 0, decision)
        return add_fix(verdict, self.document, side, decision, known, proves)


def _named(quantity: Quantity, words: str, places: _Places, sentence: str) -> _Named:
    """Return a quantity that words name, and whether other words near make another one of it."""
    near = f"{places.around} {places.heading}" if quantity.only else places.around
    own = f"{sentence} {words}"
    is_told_here = quantity.only is not None and quantity.only.search(own) is not None
    may_be_denied = own if is_told_here else places.around  # its own sentence tells the shape
    is_other = quantity.unless is not None and quantity.unless.search(may_be_denied) is not None
    if quantity.only is not None and not quantity.only.search(f"{near} {words}"):
        is_on_page = quantity.is_told_once and quantity.only.search(places.page) is not None
        is_other |= not is_on_page or (
            quantity.unless is not None and quantity.unless.search(places.page) is not None
        )
    return _Named(quantity, words, places.around, sentence, is_other)


def _is_told(quantity: Quantity, places: _Places, sentence: str) -> bool:
    """Tell whether the words are there without which a quantity is not meant."""
    near = f"{places.around} {places.heading} {sentence}"
    near = f"{near} {places.page}" if quantity.is_told_once else near
    return quantity.only is None or quantity.only.search(near) is not None


def _has_own_convention(claim: Formula, knowledge: Knowledge) -> bool:
    """Tell whether the page defines a letter as half a difference: δ = (ω₁ - ω₂)/(2 ω) is another δ."""
    own = [knowledge.definitions[n] for n in names(claim) if n in knowledge.definitions]
    formulas = [d.formula if d.numeric else d.node for d in own]
    parts = [list(walk(node)) for node in formulas if node is not None]
    return any(
        any(isinstance(part, Sum) for part in each)
        and any(isinstance(part, Number) and part.value != 1 for part in each)
        for each in parts
    )


def _has_complement(claim: Formula, knowledge: Knowledge) -> bool:
    """Tell whether the page defines a letter as what another leaves: k = 1 - β, a share the other way."""
    own = [knowledge.definitions[n].node for n in names(claim) if n in knowledge.definitions]
    return any(isinstance(node, Sum) and Number(Fraction(1)) in node.terms for node in own)
