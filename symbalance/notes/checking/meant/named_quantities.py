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
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property

from symbalance.budgets import Budget, OverBudgetError, run_within
from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Number,
    Product,
    Quotient,
    Sum,
    names,
    walk,
)
from symbalance.document.letters import plain_letter
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.checking.deciding.cases import NO_POINT
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision, without_dots
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.meant.catalogue import QUANTITIES, Quantity
from symbalance.notes.checking.meant.catalogue.roles import cylinders, net_force
from symbalance.notes.checking.meant.claims_in_letters import (
    in_letters,
    name_of_head,
    outside_calls,
    with_exact_halves,
    with_sizes,
    without_plus_minus,
)
from symbalance.notes.checking.meant.correction_planes import CorrectionPlanes
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
from symbalance.notes.checking.meant.stated_numbers import StatedNumbers
from symbalance.notes.checking.repair.fixes import Repair, add_fix, fix_of, is_proved_as_far
from symbalance.notes.checking.verdicts import DEFINITION, Verdict
from symbalance.notes.checking.words.case_words import engine_named
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading.equations import Chain, ReadNotes, Side

SEARCH, SHARE = Budget(4), 0.6
"""What this may take, and of what is left of the relation's budget: a definition stays one without it."""
SENTENCE, PARAGRAPH, AFTER = 220, 500, 60
"""Characters that are looked through: before a formula for its name, and around for another shape."""
_ONE_TERM = re.compile(r"order|exponent|number misprinted .*|sign|factor -?[0-9/]+")
_SENTENCE_END = re.compile(
    r"[;!?](?:\s|$)|\.(?:\s(?!Ordnung|Harmonische)|$)|[。；]|\n\s*\n|<p\b|<li\b"
    r"|\\item|\\section|\n#|\n\||\n {0,4}(?:[*•-]|\d{1,3}[.)])\s"
)
_BLANK = re.compile(r"\n\s*\n")
_OPENING = re.compile(
    r"(?:\s|\$+|\\[\[(]|\\begin\{[a-z]+\*?\}|\\displaystyle|&|\||<p>|<div>"
    r"|<math>|`)+$"
)
"""What stands between words and the formula that is set off from them."""
_PART = re.compile(
    r"\b(?:two|three|four|five|six|eight|twelve)\b(?![- ]stroke)|\bboth\b|\beach\b|\bpairs?\b"
    r"|\btwice\b|twin"
    r"|per cylinder|pro zylinder"
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
    r"\b(?:on|between|auf|zwischen|in) (?:two|zwei) \w+|\bbetween (?:the two|both) \w+"
    r"|zwischen (?:den )?beiden \w+|\b(?:at )?both ends|\bbeidseitig|両端"
    r"|\b(?:two|both|zwei|beiden?) (?:revolutions|turns|speeds|umdrehungen|drehzahlen|point masses"
    r"|dead cent\w+|totpunkt\w*)",
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
MOST_LETTERS = 7
"""Letters that a standard formula has at most."""
PRODUCT = "·"
"""What stands for the letter of a product of a mass and its arm, m_A r_A."""
_ANGULAR = frozenset({"omega", "Omega"})
"""Letters of angular speeds: no words make one of them a frequency in cycles."""
BARE = 24
"""Letters in the words before a formula that its heading names: "so that", "With these"."""
_LETTER_BEHIND = re.compile(
    r"(?:\s|of|is|,){0,3}(?:\$(?P<marked>[^$=]{1,24})\$|(?P<bare>\b(?!a\b"
    r"|I\b)[A-Za-zΑ-ω](?:_\{?\w{1,6}\}?)?)(?=[\s,;]))"
)
"""A letter right behind the words that name it, which is another one than the formula's."""
_ROLE_OF = {
    "force in the connecting rod": "rod_force",
    "gas force": "piston_force",
    "tangential force at the crank pin": "tangential",
    "radial force at the crank pin": "radial_part",
    "centrifugal force": "centrifugal",
    "mechanical efficiency": "efficiency",
    "degree of irregularity": "fluctuation",
}
"""The role that a letter plays further down which was shown to be a quantity."""
_NUMBER_BEHIND = re.compile(r"(?:\s|of|von|=|:){1,4}[0-9]")
"""A number right behind words: a mean effective pressure of 18 bar is that pressure's."""
_OF_A_LETTER = (
    r"(?i:\b(?:total|whole|mean|average|mittlere[rnms]?|gesamte?[rnms]?|effektive[rnms]?|gesamt(?=\w))"
    r"|平均|総|全)"
)
"""Words before the name of a letter that make of it no part of another: the mean pressure p."""
_LEAD = re.compile(r"(?:\*\*|__)?([^.:\n]{3,60}?)(?:\*\*|__)?[.:](?=\s)")
"""The opening words of a paragraph, set off as a title."""
_ENGINE_SIZE = re.compile(
    r"\b(?:two|three|four|five|six|eight|twelve|[2-9]|1[0-9])[- ]cylinder(?!s)|\b(?:zwei|drei|vier|fünf"
    r"|sechs|acht)zylinder"
    r"|[2-9２-９]気筒",
    re.IGNORECASE,
)
"""The number of an engine's cylinders, which its formulas take as it is."""
_ROD_FORCE = re.compile(
    r"\brod\s+(?:force|thrust|load)|(?:force|thrust)\s+(?:in|of|along|on)\s+the\s+(?:connecting[- ])?rod"
    r"|(?:pleuel|stangen)-?kraft|(?:連接棒|コンロッド)[^、。]{0,8}力|bielle|biela",
    re.IGNORECASE,
)
"""Words for the force in the rod, whose letter may be any that a force has."""
_ITS = re.compile(r"\b(?:its|whose|their|sein|seine|ihr|dessen|deren)\b|その", re.IGNORECASE)
"""Words that stand for a body that the sentence before names."""
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

    left: Formula = LETTER
    """The side that the letter stands on: ω² of ω² = k/m."""

    @property
    def formulas(self) -> tuple[Formula, ...]:
        """The standard formulas that the words leave open."""
        every = self.quantity.formulas
        return tuple(node for node in every if "outer" in names(node)) if self.is_other else every

    def formulas_for(self, sign: str) -> tuple[Formula, ...]:
        """Return those that a relation of some sign may confirm: a rough one only with ≈."""
        is_rough = (sign == "≈" or _ROUGHLY.search(self.sentence) is not None) and not self.is_other
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
    words_above: dict[str, str] = field(default_factory=dict)
    """The words by which letters were named that had a standard formula."""

    @cached_property
    def roles(self) -> LetterRoles:
        """The roles that the letters of the document may have."""
        return LetterRoles(self.document.text)

    @cached_property
    def planes(self) -> CorrectionPlanes:
        """The planes between which something acts, with their distances from it."""
        return CorrectionPlanes(self.document.text)

    @cached_property
    def stated(self) -> StatedNumbers:
        """The numbers that words of the document give for a share, or for the cylinders."""
        return StatedNumbers(self.document.text)

    @cached_property
    def counts_from_elsewhere(self) -> bool:
        """Tell whether an angle is counted from somewhere else than the top dead centre."""
        return _FROM_ELSEWHERE.search(self.document.text) is not None

    def judge(self, chain: Chain, k: int, knowledge: Knowledge) -> Verdict | Decision | None:
        """Return the verdict on a relation that gives a named quantity a formula; None for others.

        It stays a definition, with the reason, where the search took more than its share of the budget.
        """
        left, right = chain.sides[k].node, without_dots(chain.sides[k + 1].node)[0]
        is_first = k == 0 and chain.relations[0].sign in "=≈"
        name = (name_of_head(left) or head_of(left) or "") if is_first else ""
        right = without_plus_minus(right)
        chain = replace(
            chain, sides=(chain.sides[0], Side((right,), chain.sides[1].span), *chain.sides[2:])
        )
        if name and not names(right):
            right = in_letters(right, knowledge, self.stated.numbers.values())
            chain = replace(
                chain, sides=(chain.sides[0], Side((right,), chain.sides[1].span), *chain.sides[2:])
            )
        right = with_exact_halves(right, self.stated.numbers.values())
        own = names(right)
        if not name or not 1 <= len(own) <= MOST_LETTERS or names(left) & own:
            return None
        if any(isinstance(part, Call) and part.function not in _FUNCTIONS for part in walk(right)):
            return None
        try:
            return run_within(SEARCH, lambda: self._judge_both(chain, name, right, knowledge), SHARE)
        except OverBudgetError as problem:
            reason = f"whether its words name a standard formula was not decided within {problem.spent}"
            return Decision(DEFINITION, reason)

    def _judge_both(
        self, chain: Chain, name: str, claim: Formula, knowledge: Knowledge
    ) -> Verdict | Decision | None:
        """Return the verdict on a formula as it stands, or else with the products above put in."""
        outcome = self._share_of_plane(chain, name, claim)
        outcome = outcome or self._judge(chain, name, claim, knowledge)
        if outcome is not None:
            return outcome
        whole = with_sizes(claim, knowledge)
        if whole == claim or len(names(whole)) > MOST_LETTERS or name in names(whole):
            return None
        sides = (chain.sides[0], Side((whole,), chain.sides[1].span), *chain.sides[2:])
        return self._judge(replace(chain, sides=sides), name, whole, knowledge)

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

    def _share_of_plane(self, chain: Chain, name: str, claim: Formula) -> Verdict | Decision | None:
        """Return the verdict on what one of two planes takes, by their distances; None for others."""
        shares = self.planes.shares(name, claim)
        if shares is None:
            return None
        known = Knowledge(SymbolValue(positive=frozenset(names(claim))), corrects=True)
        left, side = Side((shares[0],), chain.sides[0].span), chain.sides[1]
        decision = decide(left, side, chain.relations[0].sign, known)
        source = f"{NOBODY}; taken from the words of the page"
        text = f"{plain_letter(name)} is the share of its plane by the other's distance ({source})"
        if decision.is_proved:
            return replace(decision, assumptions=(text,))
        if decision.status != REFUTED or not agrees(shares[1], claim):
            return None
        decision = replace(decision, reason=f"if {text}")
        verdict = self._with_fix(chain, left, decision, known)
        repair = Repair("the other plane's share", shares[0], ((side.node, shares[0]),), 1.0)
        return replace(verdict, fix=fix_of(repair, self.document, side))

    def _judge(
        self, chain: Chain, name: str, claim: Formula, knowledge: Knowledge
    ) -> Verdict | Decision | None:
        known = Knowledge(SymbolValue(positive=frozenset(names(claim))), corrects=True)
        side = chain.sides[1]
        left = LETTER if " " in name else chain.sides[0].node
        candidates = [replace(each, left=left) for each in self.named(name, chain, knowledge)]
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
                self.words_above[name] = named.words
                self.roles.taken[name] = _ROLE_OF.get(named.quantity.name, "")
                return replace(decision, assumptions=(self.text(name, named), *rest))
        fitting = {n.quantity.name: n for n in candidates if n.may_refute}
        if len(fitting) > 1:  # words that name several: by the letters of their formulas
            fitting = {n: each for n, each in fitting.items() if any(p is each for p, _ in pairs)}
            told = {n: each for n, each in fitting.items() if each.quantity.only is not None}
            fitting = told if len(told) == 1 else fitting
        if len(fitting) != 1:
            return None
        (named,) = fitting.values()
        if named.quantity.turns and self.counts_from_elsewhere:
            return None
        self.words_above.setdefault(name, named.words)
        targets = [target for each, target in pairs if each is named]
        targets += self._targets(named.quantity.approximate, claim, name, named, knowledge)
        return self._with_slip(chain, name, claim, named, targets, known, knowledge)

    def _targets(
        self,
        formulas: tuple[Formula, ...],
        claim: Formula,
        name: str,
        named: Named,
        knowledge: Knowledge,
    ) -> list[Formula]:
        """Return the formulas of a quantity in the letters of a claim."""
        together = named.quantity.together
        count = named.cylinders
        if count is not None and named.quantity.only is not None:  # f = 6 n/2 of a six-cylinder engine
            put_in = (substitute(f, cylinders.name, Number(Fraction(count))) for f in formulas)
            formulas = (*formulas, *(f for f in put_in if f not in formulas))
        every = self.stated.with_numbers(formulas, named.quantity.stated)
        shaped = tuple(as_side(named.left, formula) for formula in every)
        return list(self.roles.targets(shaped, claim, knowledge.meanings, together, name))

    def text(self, name: str, named: Named) -> str:
        """Return what a letter is taken to be, and what says so."""
        source = f"{NOBODY}; taken from the words “{named.words}”"
        source = f"declared as “{named.words}”" if named.is_declared else source
        return f"{' '.join(map(plain_letter, name.split()))} is the {named.quantity.name} ({source})"

    # What words name

    def named(self, name: str, chain: Chain, knowledge: Knowledge) -> Iterator[Named]:
        """Yield the quantities that a letter may be, by its declared meaning or the words around it."""
        sentence, _, _ = self._texts(chain)
        is_rough = _ROUGHLY.search(sentence) is not None
        if _DENIED.search(sentence):
            return
        for named in self._every_named(name, chain, knowledge):
            if not is_rough or named.quantity.approximate:
                yield named

    def _every_named(self, name: str, chain: Chain, knowledge: Knowledge) -> Iterator[Named]:
        name_alone = without_accent(name)
        stem, _, index = name_alone.removeprefix("Delta_").partition("_")
        stem = f"Delta_{stem}" if name.startswith("Delta_") else stem
        stem = PRODUCT if " " in name else stem
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
        is_bare = len(_NO_LETTER.sub("", before)) <= BARE
        lead = self._lead_in(chain) if is_bare else ""
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

    def by_words(self, words: str, name: str, chain: Chain) -> Iterator[Named]:
        """Yield the quantities that words name which stand elsewhere, in a unit."""
        sentence, _, around = self._texts(chain)
        heading = self.sections.heading_above(chain.lines[0])
        places = _Places(around, heading, self.document.text)
        yield from self._by_phrases(words, name.partition("_")[0], places, sentence)

    def _by_clause(self, name: str, chain: Chain, stem: str, places: _Places) -> Iterator[Named]:
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
    ) -> Iterator[Named]:
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

    def _lead_in(self, chain: Chain) -> str:
        """Return the few words that open a relation's paragraph like a title: "Radial force. Along …"."""
        start = min(side.span[0] for side in chain.sides)
        above = _BLANK.split(_OPENING.sub("", self.document.text[max(0, start - PARAGRAPH) : start]))[-1]
        _, other = self._chain_before(start)
        is_first = (
            other is None
            or not isinstance(other.sides[0].node, Name)
            or not names(other.sides[-1].node)
            or self.document.source(other.sides[0].span) + " " not in above
        )
        match = _LEAD.match(above)
        return match[1] if match is not None and is_first else ""

    def _by_words_around(
        self, chain: Chain, before: str, stem: str, places: _Places, sentence: str
    ) -> Iterator[Named]:
        """Yield the quantities that words name around a formula: the thrust H = … against the liner."""
        end = max(side.span[1] for side in chain.sides)
        after = _SENTENCE_END.split(self.document.text[end : end + AFTER])[0].lstrip(" $)\\]")
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
        self, chain: Chain, before: str, stem: str, places: _Places, sentence: str
    ) -> Iterator[Named]:
        """Yield those of the body that the sentence before names: the rim …; its inertia is I."""
        if _ITS.search(before) is None or "moment" not in before.casefold():
            return
        start = min(side.span[0] for side in chain.sides)
        above = self.document.text[max(0, start - PARAGRAPH) : start]
        above = _BLANK.split(_OPENING.sub("", above))[-1].removesuffix(before)
        for named in self._by_phrases(
            _SENTENCE_END.split(above.rstrip(" .;\n"))[-1], stem, places, sentence
        ):
            if "moment of inertia" in named.quantity.name:
                yield named

    def _by_letter(self, name: str, stem: str, places: _Places, sentence: str) -> Iterator[Named]:
        """Yield the quantities that words right before a letter name anywhere on the page."""
        for words in dict.fromkeys(self.roles.words_before(name)):
            named = list(self._by_phrases(words, stem, places, sentence))
            yield from (each for each in named if ends_with(each.quantity.phrases, words))

    def _is_of_another_letter(self, words: str, end: int, name: str) -> bool:
        """Tell whether a phrase is followed by another letter at once: the mean stress s_m."""
        letter = _MARKED_BEHIND.match(words, end)
        return bool(name) and letter is not None and not re.fullmatch(sign_of(name), letter["sign"])

    def _by_phrases(
        self, words: str, stem: str, places: _Places, sentence: str, name: str = ""
    ) -> Iterator[Named]:
        """Yield the quantities that words name, those with the letter's usual use first of all."""
        matches = [
            (match.start(), match.end(), quantity)
            for quantity in QUANTITIES
            for match in quantity.phrases.finditer(words)
            if _may_apply(quantity, f"{words} {places.around} {places.heading} {places.page}")
        ]
        matches = [each for each in matches if not self._is_of_another_letter(words, each[1], name)]
        told = [each for each in matches if _is_told(each[2], places, sentence)]
        matches = told or matches  # an order is a pendulum's on pages of pendulums only
        longest = [
            (start, end, quantity)
            for start, end, quantity in matches
            if not any(s <= start and end <= e and e - s > end - start for s, e, _ in matches)
        ]
        longest = [each for each in longest if not _names_another(words, each[1], stem)]
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
        after = _NEXT_ITEM.split(_SENTENCE_END.split(text[end : end + AFTER])[0])[0]
        item = _ITEM.fullmatch(words[words.rfind("\n") + 1 :])
        if item is not None and sentence.endswith(item[0]):
            sentence = item[0]
        return f"{sentence} {after}", before, f"{paragraphs} {after}"

    # What is wrong

    def _with_slip(
        self,
        chain: Chain,
        name: str,
        claim: Formula,
        named: Named,
        targets: list[Formula],
        known: Knowledge,
        knowledge: Knowledge,
    ) -> Verdict | None:
        """Return that a formula is wrong by one slip, with the standard one; None where that is open."""
        quantity = named.quantity
        others = self._targets(quantity.others, claim, name, named, knowledge)
        others += self._targets(quantity.approximate, claim, name, named, knowledge)
        mistakes = self._mistakes(named, claim, name, knowledge)
        is_mistake = any(agrees(each, claim) for each in mistakes)
        is_other = not is_mistake and any(agrees(other, claim) for other in others)
        if is_other or _has_complement(claim, knowledge):
            return None
        count = named.cylinders
        is_of_more = quantity.is_of_one and (count or 1) > 1
        is_scaled = is_of_more or any(self.roles.is_multiplied(n) for n in outside_calls(claim))
        own = _without_letters_named(named.sentence, names(claim))
        own = own if quantity.only is None else _ENGINE_SIZE.sub("", own)
        is_in_words = may_be_part(own)
        is_part = is_in_words or _has_own_convention(claim, knowledge)
        is_part = is_scaled or (is_part and "part" not in quantity.slips)
        by_number = self.stated.with_numbers(quantity.formulas, quantity.stated)
        counted = self._targets(
            tuple(node for node in by_number if node not in quantity.formulas),
            claim, name, named, knowledge,
        )  # fmt: skip
        if decimals(claim) and not (is_mistake and counted):
            return None
        if is_mistake and not targets and not is_part:  # without one of the letters: no fix in its own
            standard = formula_text(quantity.formulas[0], plain=True).replace("_", " ")
            reason = f"if {self.text(name, named)}, which is {standard}"
            return describe(self.document, chain, 0, Decision(REFUTED, reason))
        for target in targets:
            slips = (*quantity.slips, "factor") if target in counted else quantity.slips
            kind = slip_of(target, claim, slips, is_part)
            if not kind and is_mistake and not (is_part and is_multiple(target, claim)) and not is_scaled:
                kind = "another formula"
            if not kind or (is_scaled and kind == "one change"):
                continue
            side = chain.sides[1]
            left = Side((target,), chain.sides[0].span)
            decision = decide(left, side, chain.relations[0].sign, known)
            if decision.reason == NO_POINT:  # √(1 - λ²), whose values differ below λ = 1
                decision = replace(decision, status=REFUTED)
            if decision.status == UNDECIDED and differs(target, claim):
                decision = replace(decision, status=REFUTED)  # complex where letters are large: √(1 - D²)
            if decision.status != REFUTED:
                continue
            decision = replace(decision, reason=f"if {self.text(name, named)}")
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

    def _mistakes(self, named: Named, claim: Formula, name: str, knowledge: Knowledge) -> list[Formula]:
        """Return a quantity's usual mistakes, of the net force where nothing says that it is the rod's.

        N = F sin φ is right of a rod's force F, which is the piston's over cos φ; where the page has
        F/cos φ or F tan φ too, F is the piston's.
        """
        known = named.quantity.mistakes
        other_words = self.document.text.replace(named.words, "")
        is_open = any(
            isinstance(part, Call) and part.function == "cos"
            for n in names(claim) & knowledge.definitions.keys()
            for part in walk(knowledge.definitions[n].node)
        )
        if is_open or not (names(claim) & self.piston_forces or not _ROD_FORCE.search(other_words)):
            known = tuple(node for node in known if net_force.name not in names(node))
        return self._targets(known, claim, name, named, knowledge)

    @cached_property
    def piston_forces(self) -> frozenset[str]:
        """The letters that stand over the cosine of an angle, or times its tangent, somewhere."""
        forces: set[str] = set()
        for chain in self.document.chains:
            for side in chain.sides:
                for part in walk(side.node):
                    forces |= _over_cosine(part)
        self.roles.piston_forces |= forces
        return frozenset(forces)

    def _with_fix(self, chain: Chain, left: Side, decision: Decision, known: Knowledge) -> Verdict:
        side = chain.sides[1]

        def proves(node: Formula) -> bool:
            return is_proved_as_far(decide(left, Side((node,), side.span), "≈", known), decision)

        verdict = describe(self.document, chain, 0, decision)
        return add_fix(verdict, self.document, side, decision, known, proves)


def may_be_part(sentence: str) -> bool:
    """Tell whether words make of a quantity a part or a multiple of it."""
    return _PART.search(_SETTING.sub("", sentence)) is not None


def _named(quantity: Quantity, words: str, places: _Places, sentence: str) -> Named:
    """Return a quantity that words name, and whether other words near make another one of it."""
    near = f"{places.around} {places.heading}" if quantity.only else places.around
    own = f"{sentence} {words}"
    is_told_here = quantity.only is not None and quantity.only.search(own) is not None
    may_be_denied = own if is_told_here else places.around  # its own sentence tells the shape
    is_other = quantity.unless is not None and quantity.unless.search(may_be_denied) is not None
    is_other |= quantity.never is not None and quantity.never.search(places.page) is not None
    if quantity.only is not None and not quantity.only.search(f"{near} {words}"):
        is_on_page = quantity.is_told_once and quantity.only.search(places.page) is not None
        is_other |= not is_on_page or (
            quantity.unless is not None and quantity.unless.search(places.page) is not None
        )
    return Named(quantity, words, places.around, sentence, is_other, heading=places.heading)


def _last_noun(before: str) -> str:
    """Return the last word before a formula that is no "is" or "the"."""
    words = [w for w in re.findall(r"[^\W\d_]{3,}", before) if not _COPULA.fullmatch(w)]
    return words[-1].casefold() if words else ""


def _over_cosine(node: Formula) -> set[str]:
    """Return the letters that are forces along the stroke in a formula: F of F/cos φ and of F tan φ."""
    match node:
        case Quotient(numerator=above, denominator=Call(function="cos", argument=Name())):
            factors = above.factors if isinstance(above, Product) else (above,)
        case Product(factors=factors) if any(
            isinstance(f, Call) and f.function == "tan" and isinstance(f.argument, Name) for f in factors
        ):
            pass
        case _:
            return set()
    return {factor.name for factor in factors if isinstance(factor, Name)}


def _names_another(words: str, end: int, stem: str) -> bool:
    """Tell whether a letter stands right behind words that another letter is named by.

    In "the power for a mean effective pressure $p_e$ is P = …" the pressure is not what P is.
    """
    match = _LETTER_BEHIND.match(words, end)
    if match is None:
        return _NUMBER_BEHIND.match(words, end) is not None
    letter = match["marked"] or match["bare"]
    return not re.match(rf"\\?{re.escape(stem)}(?![A-Za-z])", letter)


def _without_letters_named(sentence: str, own: frozenset[str]) -> str:
    """Return a sentence without the words that name a formula's own letters: the total volume $V_H$."""
    for letter in own:
        signs = {letter, plain_letter(letter), "\\" + letter, letter.partition("_")[0]}
        sign = "|".join(map(re.escape, sorted(signs, key=len, reverse=True)))
        sentence = re.sub(
            rf"{_OF_A_LETTER}[^.;,$=]{{0,40}}?\$?(?<![A-Za-z])(?:{sign})(?![A-Za-z])", " ", sentence
        )
    return sentence


def _may_apply(quantity: Quantity, text: str) -> bool:
    """Tell whether a text has the words without which a quantity is not meant at all."""
    return quantity.only is None or quantity.only.search(text) is not None


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
