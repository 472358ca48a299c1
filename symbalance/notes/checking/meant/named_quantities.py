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

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property

from symbalance.budgets import Budget, OverBudgetError, run_within
from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Name,
    Negative,
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
from symbalance.notes.checking.deciding.equality import (
    PROVED,
    REFUTED,
    UNDECIDED,
    Decision,
    without_dots,
)
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.deciding.substitution import bound_letter, substitute
from symbalance.notes.checking.meant.catalogue import ROLES, Quantity
from symbalance.notes.checking.meant.catalogue.roles import cylinders, net_force
from symbalance.notes.checking.meant.changed_quantities import Traits, is_changed
from symbalance.notes.checking.meant.claims_in_letters import (
    in_letters,
    name_of_head,
    outside_calls,
    with_exact_halves,
    with_ratios,
    with_sizes,
    without_plus_minus,
)
from symbalance.notes.checking.meant.correction_planes import CorrectionPlanes
from symbalance.notes.checking.meant.formula_slips import (
    agrees,
    differs,
    factor_of,
    is_multiple,
    slip_of,
)
from symbalance.notes.checking.meant.left_sides import LETTER, as_side, end_named, head_of
from symbalance.notes.checking.meant.letter_roles import LetterRoles, index_of, stem_of
from symbalance.notes.checking.meant.letter_units import (
    LetterUnits,
    Numbers,
    between_quantities,
    numbers_of,
)
from symbalance.notes.checking.meant.letters_otherwise import are_otherwise
from symbalance.notes.checking.meant.meant_words import NOBODY
from symbalance.notes.checking.meant.other_formulas import kind_of_other
from symbalance.notes.checking.meant.quantity_forms import QuantityForms, is_telling
from symbalance.notes.checking.meant.quantity_words import Named, Places, QuantityWords
from symbalance.notes.checking.meant.role_dimensions import are_of_other_dimension
from symbalance.notes.checking.meant.solved_sides import RATIO, Solved, otherwise_solved, solved_sides
from symbalance.notes.checking.meant.stated_numbers import StatedNumbers
from symbalance.notes.checking.repair.fixes import Repair, add_fix, fix_of, is_proved_as_far
from symbalance.notes.checking.verdicts import DEFINITION, PROVED_WORDS, Verdict
from symbalance.notes.checking.words.glossary import glossary_of
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading.equations import Chain, ReadNotes, Side
from symbalance.text import lazy_patterns as re

BY_LETTERS = "its letters say so"
SEARCH, SHARE = Budget(4), 0.6
"""What it may take alone, and its part of a budget around it: a definition stays one without."""
_ONE_TERM = re.compile(r"order|exponent|number misprinted .*|sign|factor -?[0-9/]+")
_PART = re.compile(
    r"\b(?:two|three|four|five|six|eight|twelve)\b(?![- ]stroke)|\bboth\b|\beach\b|\bpairs?\b"
    r"|\btwice\b|twin"
    r"|per cylinder|pro zylinder"
    r"|\bdoubled?\b|\bhalf\b|\bhalv|\bmean\b|\baverage|amplitude|alternating|b[oó]xer|\bV\d|together"
    r"|\bequal\b"
    r"|\bzwei(?!takt|te)|\bbeide[nrs]?\b|\bdrei|\bvier(?!takt|te)|\bsechs(?!te)|\bacht(?!e)|\bjede[rsnm]?\b|\bje\b"
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
    r"\b(?:per|je|pro) (?:cycle|arbeitsspiel|arbeitszyklus)|\b(?:on|between|auf|zwischen"
    r"|in) (?:two|zwei) \w+|\bbetween (?:the two|both) \w+"
    r"|zwischen (?:den )?beiden \w+|\b(?:at )?both ends|\bbeidseitig|両端"
    r"|\b(?:brake |indicated )?mean (?:effective |indicated )*(?:effective )?pressure"
    r"|\bmean (?:piston(?! pressure)|angular|speed|velocity)|mittlere[rnms]? (?:kolben"
    r"|winkel)(?!druck)(?:gesch\w*)?"
    r"|mittlere[rnms]? drehzahl|平均(?:ピストン|角)?(?:速度|スピード)|平均回転(?:数|速度)"
    r"|mittlere[rnms]? (?:\w+ )?(?:arbeits|nutz|innen|kolben)?druck|(?:正味|図示)?平均有効圧力?"
    r"|pression (?:effective )?moyenne(?: effective)?"
    r"|\b(?:two|both|zwei|beiden?) (?:revolutions|turns|speeds|strokes|umdrehungen|drehzahlen|hübe"
    r"|point masses"
    r"|dead cent\w+|totpunkt\w*)",
    re.IGNORECASE,
)
"""Words that make nothing a part: a shaft on two bearings, two strokes a turn, a mean pressure."""
_FROM_ELSEWHERE = re.compile(
    r"\b(?:from|von|vom|ab|gegen|against|aus)\b[^.\n]{0,30}?(?:bottom|outer dead|lower dead|\bBDC\b"
    r"|vertical|horizontal"
    r"|perpendicular|unteren? totp|\bUT\b|äußeren totp|senkrecht|waagrecht|vertikal|lotrecht)"
    r"|(?:下死点|水平|鉛直|垂直)[^。\n]{0,10}から",
    re.IGNORECASE,
)
"""Words for another place where an angle begins: a sine is a cosine there."""
BEHIND = 40
"""Characters behind a relation in which words may say from where it measures."""
MOST_LETTERS = 7
"""Letters that a standard formula has at most."""
FEWEST_LETTERS = 3
"""Letters of a formula whose dimension alone says that it is wrong, if it should have no root or π."""
_RELATIVE = re.compile(
    r"\bunits? of\b|dimensionless|normali[sz]ed|relative|\bratio\b|\bper\b|specific|reduced|proportional"
    r"|\brates?\b|slope|momentum|impuls|drall|neigung|dimensionslos|einheitenlos|bezogen|verhältnis|\bje\b|\bpro\b|spezifisch|reduziert|無次元"
    r"|運動量|たわみ角|あたり|当たり|比",
    re.IGNORECASE,
)
"""Words by which a letter may be a quantity over another one."""
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
_OF_A_LETTER = (
    r"(?i:\b(?:total|whole|mean|average|mittlere[rnms]?|gesamte?[rnms]?|effektive[rnms]?|gesamt(?=\w))"
    r"|平均|総|全)"
)
"""Words before the name of a letter that make of it no part of another: the mean pressure p."""
_ENGINE_SIZE = re.compile(
    r"\b(?:two|three|four|five|six|eight|twelve|[2-9]|1[0-9])[- ]cylinder(?!s)|\b(?:zwei|drei|vier|fünf"
    r"|sechs|acht)zylinder"
    r"|[2-9２-９]気筒|\bV-?[2468]\b|\bV1[026]\b",
    re.IGNORECASE,
)
"""The number of an engine's cylinders, which its formulas take as it is."""
_OF_ALL = re.compile(r"\btotal\w*|\bwhole|\bentire|\bgesamt\w*|総|全", re.IGNORECASE)
_COUNTED_BY_LETTER = re.compile(
    r"\$\\?[A-Za-z](?:_\{?\w{1,4}\}?)?\$[- ](?:cylinder|zylinder|cylindre|cilindr)"
    r"|(?:number of cylinders|zylinderzahl"
    r"|anzahl der zylinder|(?:シリンダ|気筒)数を?)\s?\$?[A-Za-z]\b|\$[A-Za-z]\$\s?気筒",
    re.IGNORECASE,
)
"""Words for all cylinders of an engine, and for a letter that is their number."""
_SINGLE = re.compile("single|ein[^ s]|mono|単", re.IGNORECASE)
"""The name of an engine of one cylinder, and no words of one cylinder of an engine."""
_ROD_FORCE = re.compile(
    r"\brod\s+(?:force|thrust|load)|(?:force|thrust)\s+(?:in|of|along|on)\s+the\s+(?:connecting[- ])?rod"
    r"|(?:pleuel|stangen)-?kraft|(?:連接棒|コンロッド)[^、。]{0,8}力|bielle|biela",
    re.IGNORECASE,
)
"""Words for the force in the rod, whose letter may be any that a force has."""
_OF_MINUTES = (30, 60, 120)
"""Numbers that turn revolutions or cycles of a second into those of a minute."""
_MANY, _FEWEST_DIGITS = 100, 3
"""A number of so many digits that it may be rounded."""
_UNIT_OF_TIME = re.compile(r"\b(?:1/s|s\^?-1|Hz|rps|1/min|min\^?-1|rpm|rev/|tr/|U/min)|s⁻¹|min⁻¹")
"""In a declaration, what a speed of rotation is counted in."""
_CONVERTING = 1000
"""A number from which on one in a standard formula is that of units."""
_ANGULAR = ("omega", "omega_high", "omega_low")
_WITHOUT_UNIT = (
    "cylinders", "efficiency", "ratio", "slenderness", "order", "fluctuation", "compression", "share",
    "crank_angle", "turned_angle",
)  # fmt: skip
"""Roles of numbers that have no unit."""
_FUNCTIONS = ("sqrt", "sin", "cos", "tan", "cot", "atan", "ln")


@dataclass
class NamedQuantities:
    """Judges the formulas of one document whose quantity the words around name."""

    document: ReadNotes
    sections: Sections
    _is_solving: bool = field(default=False, init=False)
    """Whether a relation is judged as solved for one of its letters: by words alone then."""
    numbers: Numbers | None = None
    """The units of the letters of the formula that is judged, where words give them."""
    read_otherwise: dict[int, Formula] = field(default_factory=dict)
    """By where relations begin: formulas that are their quantity as read otherwise than usual."""

    @cached_property
    def units(self) -> LetterUnits:
        """The units that words give letters."""
        return LetterUnits(self.document)

    @cached_property
    def page(self) -> str:
        """The text of the document with its technical terms in English."""
        return glossary_of(self.document.text).english(self.document.text)

    @cached_property
    def roles(self) -> LetterRoles:
        """The roles that the letters of the document may have."""
        return LetterRoles(self.page)

    @cached_property
    def words(self) -> QuantityWords:
        """The words of the document around its formulas."""
        return QuantityWords(self.document, self.sections, self.roles)

    @cached_property
    def forms(self) -> QuantityForms:
        """What the letters of the document may be by the form of their formulas."""
        return QuantityForms(self.words)

    @cached_property
    def planes(self) -> CorrectionPlanes:
        """The planes between which something acts, with their distances from it."""
        return CorrectionPlanes(self.page)

    @cached_property
    def stated(self) -> StatedNumbers:
        """The numbers that words of the document give for a share, or for the cylinders."""
        return StatedNumbers(self.page)

    @cached_property
    def counts(self) -> frozenset[int]:
        """The numbers of cylinders that the page's engines may have by their names; empty if any."""
        engines = self.sections.named_engines.every
        if any(not engine.cylinders and not _size_of_vee(engine.words) for engine in engines):
            return frozenset()
        sizes = {engine.cylinders or _size_of_vee(engine.words) for engine in engines}
        is_of_one = any(e.cylinders == 1 and _SINGLE.match(e.words) for e in engines)
        return frozenset(sizes if is_of_one else sizes - {1})

    @cached_property
    def counts_from_elsewhere(self) -> bool:
        """Tell whether an angle is counted from somewhere else than the top dead centre."""
        return _FROM_ELSEWHERE.search(self.page) is not None

    def judge(self, chain: Chain, k: int, knowledge: Knowledge) -> Verdict | Decision | None:
        """Return the verdict on a relation that gives a named quantity a formula; None for others.

        It stays a definition, with the reason, where the search took more than its share of the budget.
        What is wrong as usually read may be right as read otherwise: π G d⁴ / 32 L.
        """
        outcome = self._as_read(chain, k, knowledge)
        if not isinstance(outcome, Verdict) or outcome.verdict != REFUTED:
            return outcome
        if "has the form of that" in outcome.reason and _is_multiple_of_its_kind(chain):
            return None
        for other in chain.sides[k + 1].readings[1:]:
            side = replace(chain.sides[k + 1], readings=(other,))
            read = replace(chain, sides=(*chain.sides[: k + 1], side, *chain.sides[k + 2 :]))
            there = self._as_read(read, k, knowledge)
            is_open = there is None and BY_LETTERS in outcome.reason
            if is_open or (there is not None and _is_right(there)):
                self.read_otherwise[chain.start] = other
                return there
        return outcome

    def _as_read(self, chain: Chain, k: int, knowledge: Knowledge) -> Verdict | Decision | None:
        left, right = chain.sides[k].node, without_dots(chain.sides[k + 1].node)[0]
        is_first = k == 0 and chain.relations[0].sign in "=≈"
        name = (name_of_head(left) or head_of(left) or "") if is_first else ""
        if is_first and not name:
            return self._solved(chain, knowledge)
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
        if _has_arm_of_another(name, own):
            return self._with_arms_exchanged(chain, name, right, knowledge)
        if not name or not 1 <= len(own) <= MOST_LETTERS or names(left) & own:
            return None
        if any(_is_of_no_formula(part, own) for part in walk(right)):
            return None
        try:
            return run_within(SEARCH, lambda: self._judge_both(chain, name, right, knowledge), SHARE)
        except OverBudgetError as problem:
            reason = f"whether its words name a standard formula was not decided within {problem.spent}"
            return Decision(DEFINITION, reason)

    def _with_arms_exchanged(
        self, chain: Chain, name: str, claim: Formula, knowledge: Knowledge
    ) -> Verdict | None:
        """Return that a moment is right but for its arms: m_b r = (m_r + c m) r_b, each mass's other one.

        Only that of a counterweight: words name what it does, and r_b is no crank radius.
        """
        mass, arm = name.split()
        if index_of(arm):
            return None
        others = [n for n in names(claim) if stem_of(n) == stem_of(arm) and index_of(n) == index_of(mass)]
        if len(others) != 1 or arm in names(claim):
            return None
        exchanged = substitute(claim, others[0], Name(arm))
        left = Product((Name(mass), Name(others[0])))
        sides = (Side((left,), chain.sides[0].span), Side((exchanged,), chain.sides[1].span))
        swapped = replace(chain, sides=(*sides, *chain.sides[2:]))
        outcome = self._judge_both(swapped, f"{mass} {others[0]}", exchanged, knowledge)
        text = next(iter(outcome.assumptions), "") if isinstance(outcome, Decision) else ""
        if not isinstance(outcome, Decision) or not outcome.is_proved or "counterweight" not in text:
            return None
        reason = f"the arms are exchanged: {plain_letter(others[0])} goes with {plain_letter(mass)}"
        return describe(self.document, chain, 0, Decision(REFUTED, f"if {text}; {reason}"))

    def _solved(self, chain: Chain, knowledge: Knowledge) -> Verdict | Decision | None:
        """Return the verdict on a relation that gives one of several letters a value, i n = 60 f.

        It is judged as solved for each of them. A proof of one says more than that another is wrong.
        """
        first, second = chain.sides[0], chain.sides[1]
        found: Verdict | None = None
        right = without_dots(second.node)[0]
        for solved in (*solved_sides(first.node, right), *otherwise_solved(first.node, right)):
            sides = (Side((solved.left,), first.span), Side((solved.right,), second.span))
            self._is_solving = True
            try:
                outcome = self.judge(replace(chain, sides=(*sides, *chain.sides[2:])), 0, knowledge)
            finally:
                self._is_solving = False
            if isinstance(outcome, Decision):
                return outcome
            found = found or (outcome and self._as_written(chain, solved, outcome))
        return found

    def _as_written(self, chain: Chain, solved: Solved, verdict: Verdict) -> Verdict:
        """Return the verdict on a relation solved for a letter as one on the relation as it stands."""
        side = chain.sides[1]
        shown = replace(
            verdict, source=self.document.shown(side.node, side.span), node=side.node,
            claimed=formula_text(side.node, plain=True), exact="", exact_node=None, differences=(),
        )  # fmt: skip
        if verdict.fix is None:
            return shown
        node = solved.as_written(verdict.fix.node)
        repair = Repair(verdict.fix.kind, node, ((side.node, node),), 1.0)
        return replace(shown, fix=fix_of(repair, self.document, side))

    def _judge_both(
        self, chain: Chain, name: str, claim: Formula, knowledge: Knowledge
    ) -> Verdict | Decision | None:
        """Return the verdict on a formula as it stands, or else with the products above put in."""
        outcome = self._share_of_plane(chain, name, claim)
        by_speeds = with_ratios(claim, knowledge)
        if outcome is None and by_speeds != claim and len(names(by_speeds)) <= MOST_LETTERS:
            sides = (chain.sides[0], Side((by_speeds,), chain.sides[1].span), *chain.sides[2:])
            outcome = self._judge_in_units(replace(chain, sides=sides), name, by_speeds, knowledge)
        outcome = outcome or self._judge_in_units(chain, name, claim, knowledge)
        if outcome is not None:
            return outcome
        whole = with_sizes(claim, knowledge)
        if whole == claim or len(names(whole)) > MOST_LETTERS or name in names(whole):
            return None
        sides = (chain.sides[0], Side((whole,), chain.sides[1].span), *chain.sides[2:])
        return self._judge_in_units(replace(chain, sides=sides), name, whole, knowledge)

    def _judge_in_units(
        self, chain: Chain, name: str, claim: Formula, knowledge: Knowledge
    ) -> Verdict | Decision | None:
        """Return the verdict on a formula with the units that words give its letters."""
        self.numbers = self._numbers(chain, name, claim, knowledge)
        if self.numbers is not None and self.numbers.is_mixed:
            return None
        return self._judge(chain, name, claim, knowledge)

    def of_another(self, chain: Chain, k: int, knowledge: Knowledge) -> Verdict | Decision | None:
        """Return the verdict on a letter's formula where its clause names it of something else.

        That is of another engine or shaft than in the clause before: it has another value then.
        """
        left = chain.sides[0].node
        if k or not isinstance(left, Name) or knowledge.meanings.get(left.name):
            return None
        stem = left.name.partition("_")[0]
        is_another = any(
            not named.is_other
            for named in self.words.by_clause(left.name, chain, stem, Places("", "", ""))
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
        left = LETTER if " " in name else chain.sides[0].node
        candidates = [
            replace(each, left=left, end=self._end(chain))
            for each in self.words.named(name, chain, knowledge)
        ]
        if name in knowledge.definitions or any(
            _UNIT_OF_TIME.search(m) for m in knowledge.meanings.values()
        ):
            candidates = [each for each in candidates if not each.quantity.is_by_unit]
        sign = chain.relations[0].sign
        plain = [each for each in candidates if each.quantity.is_plain]
        candidates = [each for each in candidates if not each.quantity.is_plain]
        pairs = [
            (named, target)
            for named in candidates
            for target in self._targets(named.formulas_for(sign), claim, name, named, knowledge)
        ]
        proofs = (self._proof(chain, name, claim, *pair, known, knowledge) for pair in pairs)
        proof = next((each for each in proofs if each is not None), None)
        if proof is not None:
            return proof if proof.is_proved else None
        if (inverted := self._inverted(chain, name, claim, plain, knowledge)) is not None:
            return inverted
        in_letters_of = {
            n.quantity.name
            for n in candidates
            if any(agrees(node, claim) for node in self._mistakes(n, claim, name, knowledge))
            or self._targets((*n.quantity.formulas, *n.quantity.approximate), claim, name, n, knowledge)
        }
        fitting = {n.quantity.name: n for n in candidates if n.may_refute}
        if self._is_solving:  # m_1 p = m_2 q is of both parts of a rod's mass
            fitting = {n: each for n, each in fitting.items() if not n.startswith("mass of a rod at its")}
        fitting = {n: each for n, each in fitting.items() if n in in_letters_of}
        if len(fitting) > 1:
            special = {n: each for n, each in fitting.items() if each.quantity.only is not None}
            fitting = special if len(special) == 1 else fitting
        stems = {stem_of(name).rstrip("'"), name}
        own = [each for each in candidates if stems & each.quantity.letters]
        if len(fitting) != 1:
            is_unnamed = all(each.is_other or each.quantity.name not in in_letters_of for each in own)
            is_unnamed &= " " not in name
            if self._is_solving:
                return None  # F L = m r ω² a is no formula of F by its form
            by_form = self._by_form(chain, name, claim, knowledge, known) if is_unnamed else None
            return by_form or self._by_dimension(chain, name, claim, knowledge)
        (named,) = fitting.values()
        is_turned = named.quantity.turns and self.counts_from_elsewhere
        if is_turned or self._is_one_of_all(chain, name, claim, named, knowledge):
            return None
        self.words.words_above.setdefault(name, named.words)
        targets = [target for each, target in pairs if each is named]
        targets += self._targets(named.quantity.approximate, claim, name, named, knowledge)
        return self._with_slip(chain, name, claim, named, targets, known, knowledge)

    def _proof(
        self,
        chain: Chain,
        name: str,
        claim: Formula,
        named: Named,
        target: Formula,
        known: Knowledge,
        knowledge: Knowledge,
    ) -> Decision | None:
        """Return the proof that a formula is a standard one; None where it is not.

        An open decision says that it is, but that the words make another quantity of the named one.
        """
        side, sign = chain.sides[1], chain.relations[0].sign
        is_equal = decimals(claim) or agrees(target, claim)
        if is_equal:  # a proof costs more than a comparison
            decision = decide(Side((target,), side.span), side, sign, known)
        elif self.numbers is not None and _is_rounded(target, claim):
            decision = Decision(
                PROVED, assumptions=(f"its number is rounded, of {formula_text(target)}",)
            )
        else:
            return None
        if not decision.is_proved or decision.order:
            return None
        if self._is_changed(chain, name, claim, named, knowledge):
            return Decision(UNDECIDED)
        is_rough = target in self._targets(named.quantity.approximate, claim, name, named, knowledge)
        signs = {f"{n} ≥ 0" for n in names(claim)}
        signs |= {f"{plain_letter(n)} ≥ 0" for n in names(claim)}
        rest = [text for text in decision.assumptions if text not in signs]
        rest += ["the rod is long"] if is_rough else []
        self.words.words_above[name] = named.words
        self.roles.taken[name] = _ROLE_OF.get(named.quantity.name, "")
        return replace(decision, assumptions=(self.text(name, named), *rest))

    def _numbers(self, chain: Chain, name: str, claim: Formula, knowledge: Knowledge) -> Numbers | None:
        """Return the units that words give the letters of a formula; None where none of them matters."""
        if " " in name:
            return None
        without = [
            n
            for n in names(claim)
            if any(self.roles.may_be(n, role, knowledge.meanings) for role in _WITHOUT_UNIT)
        ]
        return numbers_of(self.units, chain, name, names(claim), without)

    def _is_changed(
        self, chain: Chain, name: str, claim: Formula, named: Named, knowledge: Knowledge
    ) -> bool:
        """Tell whether the words beside a quantity's name make another one of it: twice the force.

        The number of an engine's cylinders does so with a formula of one of them.
        """
        text = (
            knowledge.meanings.get(name, "") if named.is_declared else self.words.sentence_before(chain)
        )
        formulas = (*named.quantity.formulas, *named.quantity.approximate)
        if self._is_one_of_all(chain, name, claim, named, knowledge):
            return True
        of_all = tuple(node for node in formulas if cylinders.name in names(node))
        of_one = tuple(node for node in formulas if cylinders.name not in names(node))
        if of_all and not any(
            agrees(t, claim) for t in self._shaped(of_one, claim, name, named, knowledge)
        ):
            return False
        text = text if of_all else _ENGINE_SIZE.sub("", text)
        traits = Traits(
            named.quantity.name,
            is_told=named.quantity.only is not None and named.quantity.only.search(text) is not None,
            has_several=len({stem_of(n) for n in names(claim)}) < len(names(claim)),
            is_by_minute=any(isinstance(p, Number) and p.value in _OF_MINUTES for p in walk(claim)),
        )
        return is_changed(text, named.words, traits)

    def _is_one_of_all(
        self, chain: Chain, name: str, claim: Formula, named: Named, knowledge: Knowledge
    ) -> bool:
        """Tell whether a formula is one cylinder's, where words ask for all of $z$ cylinders."""
        of_all = [node for node in named.quantity.formulas if _is_times_cylinders(node)]
        of_all = [
            node for node in of_all if cylinders.name in names(node) and "volume" not in names(node)
        ]
        text = self.words.glossary.english(self.words.sentence_before(chain))
        if not of_all or not _OF_ALL.search(text) or not _COUNTED_BY_LETTER.search(text):
            return False
        of_one = tuple(substitute(node, cylinders.name, Number(Fraction(1))) for node in of_all)
        return any(agrees(each, claim) for each in self._shaped(of_one, claim, name, named, knowledge))

    def _shaped(
        self,
        formulas: tuple[Formula, ...],
        claim: Formula,
        name: str,
        named: Named,
        knowledge: Knowledge,
    ) -> list[Formula]:
        """Return formulas of a quantity in the letters of a claim, with no number of cylinders put in."""
        shaped = tuple(as_side(named.left, formula) for formula in formulas)
        return list(self.roles.targets(shaped, claim, knowledge.meanings, named.quantity.together, name))

    def _inverted(
        self, chain: Chain, name: str, claim: Formula, plain: list[Named], knowledge: Knowledge
    ) -> Verdict | None:
        """Return that a formula is a plain quotient upside down, σ = A/F of a stress; None for others."""
        sign, known = chain.relations[0].sign, Knowledge(SymbolValue(positive=frozenset(names(claim))))
        for named in plain:
            targets = self._targets(named.formulas_for(sign), claim, name, named, knowledge)
            mistakes = self._targets(named.quantity.mistakes, claim, name, named, knowledge)
            if any(agrees(each, claim) for each in targets) or not named.may_refute:
                continue
            roles = {role for node in named.quantity.mistakes for role in names(node)}
            if may_be_part(named.sentence) or are_otherwise(self.page, names(claim), roles):
                continue
            if targets and any(agrees(each, claim) for each in mistakes):
                return self._with_slip(chain, name, claim, named, targets, known, knowledge)
        return None

    def _end(self, chain: Chain) -> str:
        """Return the number of the end from which the words beside a relation measure."""
        behind = self.document.text[chain.end : chain.end + BEHIND]
        return end_named(behind) or end_named(self.words.sentence_before(chain))

    def _by_form(
        self, chain: Chain, name: str, claim: Formula, knowledge: Knowledge, known: Knowledge
    ) -> Verdict | None:
        """Return that a formula that no words name is one slip from the only one that it may be."""
        if not isinstance(chain.sides[0].node, Name) or not is_telling(claim):
            return None
        candidates = [
            replace(named, left=chain.sides[0].node, end=self._end(chain))
            for named in self.forms.candidates(name, chain, self.piston_forces)
            if not (named.quantity.turns and self.counts_from_elsewhere)
        ]
        for quantity in self.forms.possible(name, candidates):
            every = (*quantity.formulas, *quantity.approximate)
            every = every if any(each.is_by_use for each in candidates) else (*every, *quantity.others)
            every = (*every, *self._counted(quantity, every, claim, name, knowledge))
            targets = self.roles.targets(every, claim, knowledge.meanings, quantity.together, name)
            if any(agrees(target, claim) for target in targets):
                return None
        verdicts: list[Verdict] = []
        for named in candidates:
            targets = self._targets(named.quantity.formulas, claim, name, named, knowledge)
            verdict = self._with_slip(chain, name, claim, named, targets, known, knowledge)
            if verdict is not None and verdict.fix is not None:
                verdicts.append(verdict)
        mended = [verdict.fix.node for verdict in verdicts if verdict.fix is not None]
        is_one = bool(mended) and all(agrees(mended[0], node) for node in mended[1:])
        if is_one:
            self.forms.refuted.setdefault(name, chain.start)
        return verdicts[0] if is_one else None

    def _by_dimension(
        self, chain: Chain, name: str, claim: Formula, knowledge: Knowledge
    ) -> Verdict | None:
        """Return that a formula is the only one that it may be but for its dimension: √(m g a/J).

        Its letters alone say what it is. A number that is wrong may be another quantity's, a dimension
        may not: what differs from the formula by it is no quantity of that letter.
        """
        around = self.words.around(chain)
        is_open = around is None or _RELATIVE.search(around.sentence) is not None
        is_open |= any(map(_may_be_power, names(claim)))
        if is_open or not isinstance(chain.sides[0].node, Name) or decimals(claim):
            return None
        found = self._of_other_dimension(name, claim, knowledge) if is_telling(claim) else None
        if found is None:
            return None
        target, quantity = found
        text = f"{plain_letter(name)} is the {quantity.name} ({NOBODY}; {BY_LETTERS})"
        decision = Decision(REFUTED, f"if {text}; the right side is of another dimension")
        known = Knowledge(SymbolValue(positive=frozenset(names(claim))), corrects=True)
        verdict = self._with_fix(chain, Side((target,), chain.sides[0].span), decision, known)
        if verdict.fix is not None:
            return verdict
        repair = Repair("another dimension", target, ((chain.sides[1].node, target),), 1.0)
        return replace(verdict, fix=fix_of(repair, self.document, chain.sides[1]))

    def _of_other_dimension(
        self, name: str, claim: Formula, knowledge: Knowledge
    ) -> tuple[Formula, Quantity] | None:
        """Return the one formula from which a claim differs by a slip and in its dimension, or None.

        None too where the claim is a formula of its letter, or may be one but for a number.
        """
        is_long = len(names(claim)) >= FEWEST_LETTERS
        found: tuple[Formula, Quantity] | None = None
        for quantity in self.forms.of_letter(name, knowledge.meanings.get(name, "")):
            meanings, together = knowledge.meanings, quantity.together
            mistakes = self.roles.targets(quantity.mistakes, claim, meanings, together, name)
            is_mistake = any(agrees(each, claim) for each in mistakes)
            every = (*quantity.formulas, *quantity.approximate, *quantity.others)
            for target, roles in self.roles.readings(every, claim, meanings, together, name):
                if agrees(target, claim):
                    return None
                if not is_long and not any(isinstance(part, Call | Constant) for part in walk(target)):
                    continue
                is_multiplied = is_multiple(target, claim)
                is_slip = is_mistake or slip_of(target, claim, ("power", "root"), may_be_part=True)
                if not is_slip and not is_multiplied:
                    continue
                if is_multiplied or not are_of_other_dimension(target, claim, roles):
                    return None
                if found is not None and not agrees(found[0], target):
                    return None
                found = found or (target, quantity)
        return found

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
        formulas = (*self._counted(named.quantity, formulas, claim, name, knowledge), *formulas)
        if self.numbers is not None and self.numbers.has_rate:
            formulas = between_quantities(named.quantity, formulas)
        every = self.stated.with_numbers(formulas, named.quantity.stated)
        shaped = tuple(as_side(named.left, formula) for formula in every)
        head = name
        if ("", "own_inertia") in together and not index_of(name):
            head = f"{name}_{named.end}"
        readings = self.roles.readings(shaped, claim, knowledge.meanings, together, head)
        needed = [(role, index.split()) for role, index in named.quantity.subscripts]
        fitting = [
            (target, letters)
            for target, letters in readings
            if all(index_of(letters[role]) in indices for role, indices in needed if role in letters)
        ]
        if self.numbers is None or any(map(_has_large_number, formulas)):
            return [target for target, _ in fitting]  # 30000 G m/(π n) is between numbers as it stands
        return [
            self.numbers.converted(target)
            for target, letters in fitting
            if not any(letters.get(role) in self.numbers.rates for role in _ANGULAR)  # n in min⁻¹ is no ω
        ]

    def _counted(
        self,
        quantity: Quantity,
        formulas: tuple[Formula, ...],
        claim: Formula,
        name: str,
        knowledge: Knowledge,
    ) -> tuple[Formula, ...]:
        """Return formulas of all cylinders, where a quantity may be of one too, with their number put in.

        The number is the page's, or a whole factor of the claim that stands apart: 3 of 3·(π/4) D² S.
        """
        of_all = [
            node for node in formulas if cylinders.name in names(node) and _is_times_cylinders(node)
        ]
        of_one = tuple(node for node in formulas if cylinders.name not in names(node))
        if not of_all or not of_one or quantity.stated:
            return ()
        is_of_sizes = not any("volume" in names(node) for node in of_all)  # that may be the engine's
        counts = set(self.counts if len(self.counts) == 1 and is_of_sizes else ())
        for number, rest in _factors_apart(claim):
            targets = self.roles.targets(of_one, rest, knowledge.meanings, quantity.together, name)
            is_of_one = any(is_multiple(target, rest) for target in targets)
            if is_of_one and (not self.counts or number in self.counts):
                counts.add(number)
        return tuple(
            substitute(f, cylinders.name, Number(Fraction(n))) for n in sorted(counts) for f in of_all
        )

    def text(self, name: str, named: Named) -> str:
        """Return what a letter is taken to be, and what says so."""
        own = self.words.glossary.own_words(named.words)
        source = f"{NOBODY}; taken from the words “{own}”"
        if named.is_by_form:
            source = f"{NOBODY}; it has the form of that, and “{own}” stands near"
            source = f"{NOBODY}; {own}" if named.is_by_use else source
        source = f"declared as “{own}”" if named.is_declared else source
        return f"{' '.join(map(plain_letter, name.split()))} is the {named.quantity.name} ({source})"

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
        is_other |= self._is_between_quantities(name, claim, named, knowledge)
        if is_other or _has_complement(claim, knowledge):
            return None
        count = named.cylinders
        is_of_more = quantity.is_of_one and (count or 1) > 1
        is_scaled = is_of_more or any(
            self.roles.is_multiplied(n) for n in outside_calls(claim) if not knowledge.meanings.get(n)
        )
        is_part = is_scaled or self._is_part(named, claim, knowledge)
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
            other = kind_of_other(
                target, targets, claim, quantity, f"{named.heading} {named.around} {named.sentence}",
                is_part=is_part or _is_woven(claim, knowledge),
            )  # fmt: skip
            other = "" if _is_compared(quantity, name, claim) else other
            kind = slip_of(target, claim, slips, is_part)
            kind = kind or ("" if is_part else self._slip_of_units(target, claim, mistakes))
            is_share = is_multiple(target, claim) and not agrees(Negative(target), claim)
            if not kind and is_mistake and not (is_part and is_share) and not is_scaled:
                kind = "another formula"
            kind = kind or other
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
            if kind in ("term", "power of a term") and not is_mistake:
                kind = other
            if not kind:
                continue
            repair = Repair(kind, target, ((side.node, target),), 1.0)
            return replace(verdict, fix=fix_of(repair, self.document, side))
        return None

    def _is_part(self, named: Named, claim: Formula, knowledge: Knowledge) -> bool:
        """Tell whether words or definitions make of a quantity a part or a multiple of it."""
        quantity = named.quantity
        own = _without_letters_named(named.sentence, names(claim))
        is_counted = any(cylinders.name in names(formula) for formula in quantity.formulas)
        if quantity.only is not None or (is_counted and len(self.counts) == 1):
            own = _ENGINE_SIZE.sub("", own)
        if is_counted and any(self._counts_cylinders(n) for n in names(claim)):
            own = _OF_ALL.sub("", own)  # the total of n cylinders has the letter n
        is_part = may_be_part(own) or _has_own_convention(claim, knowledge)
        return is_part and "part" not in quantity.slips

    def _counts_cylinders(self, name: str) -> bool:
        """Tell whether words say that a letter is the number of cylinders."""
        said = (*self.roles.words_before(name), *self.roles.said_behind(name))
        counted = rf"\$?\\?{re.escape(plain_letter(name))}\$?\s?(?:cylinders|zylinder|気筒)"
        return any(ROLES[cylinders.name].words.search(each) for each in said) or (
            re.search(counted, self.page, re.IGNORECASE) is not None
        )

    def _is_between_quantities(
        self, name: str, claim: Formula, named: Named, knowledge: Knowledge
    ) -> bool:
        """Tell whether a formula may be one between quantities, and not between numbers of units."""
        if self.numbers is None or self.numbers.is_whole:
            return False
        numbers, self.numbers = self.numbers, None
        plain = self._targets(named.quantity.formulas, claim, name, named, knowledge)
        self.numbers = numbers
        return any(agrees(each, claim) for each in plain)

    def _slip_of_units(self, target: Formula, claim: Formula, mistakes: list[Formula]) -> str:
        """Return that a formula between numbers of units has another constant than converts them."""
        if self.numbers is None or not self.numbers.is_whole or _is_rounded(target, claim):
            return ""
        is_changed = is_multiple(target, claim) or any(
            is_multiple(each, claim) and not is_multiple(each, target) for each in mistakes
        )
        return "change of units" if is_changed else ""

    def _mistakes(self, named: Named, claim: Formula, name: str, knowledge: Knowledge) -> list[Formula]:
        """Return a quantity's usual mistakes, of the net force where nothing says that it is the rod's.

        N = F sin φ is right of a rod's force F, which is the piston's over cos φ; where the page has
        F/cos φ or F tan φ too, F is the piston's.
        """
        known = named.quantity.mistakes
        other_words = self.page.replace(named.words, "")
        angles = [part.argument for part in walk(claim) if isinstance(part, Call)]
        is_open = any(
            isinstance(part, Call) and part.function == "cos" and part.argument in angles
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


def _is_rounded(target: Formula, claim: Formula) -> bool:
    """Tell whether a formula is another one but for the last digit of its number: 9549 P/n, 9550 P/n."""
    factor = factor_of(target, claim)
    numbers = [abs(p.value) for p in walk(claim) if isinstance(p, Number) and abs(p.value) >= _MANY]
    if factor is None or len(numbers) != 1 or numbers[0].denominator != 1:
        return False
    digits = str(numbers[0]).rstrip("0")
    unit = 10 ** (len(str(numbers[0])) - len(digits))
    return len(digits) >= _FEWEST_DIGITS and abs(numbers[0] / factor - numbers[0]) <= max(
        Fraction(unit, 2), 1
    )


def _has_arm_of_another(name: str, own: frozenset[str]) -> bool:
    """Tell whether a product has another's arm, and its own is in the formula: m_c r = (…) r_c.

    >>> _has_arm_of_another("m_c r", frozenset({"m", "r_c"}))
    True
    """
    parts = name.split()
    if len(parts) != 2:
        return False
    indices = {index_of(part) for part in parts}
    stems = {stem_of(part) for part in parts}
    bare = [part for part in parts if not index_of(part)]
    return bool(bare) and any(index_of(n) and index_of(n) in indices and stem_of(n) in stems for n in own)


def _has_large_number(node: Formula) -> bool:
    """Tell whether a formula holds between the numbers of stated units, which its own number converts."""
    return any(isinstance(part, Number) and abs(part.value) >= _CONVERTING for part in walk(node))


def _is_of_no_formula(part: Formula, own: frozenset[str]) -> bool:
    """Tell whether no standard formula has such a part: an unknown function, the n of ∫ n π/30 dn."""
    is_other_call = isinstance(part, Call) and part.function not in _FUNCTIONS
    return is_other_call or bound_letter(part) in own


def _may_be_power(letter: str) -> bool:
    """Tell whether a letter may be the power of one, typed without its sign: w2 for w²."""
    return index_of(letter) in ("2", "3", "4") and stem_of(letter) not in ("J", "I", "Theta")


def _size_of_vee(words: str) -> int:
    """Return the cylinders that the name of an engine in banks says, 8 of V8; 0 for none."""
    digits = re.search(r"[0-9]{1,2}", words)
    return int(digits[0]) if digits else 0


def _is_times_cylinders(node: Formula) -> bool:
    """Tell whether a formula is that of one cylinder times their number."""
    return agrees(node, cylinders * substitute(node, cylinders.name, Number(Fraction(1))))


def _factors_apart(node: Formula) -> Iterator[tuple[int, Formula]]:
    """Yield each whole number that multiplies all else of a formula, with the rest."""
    match node:
        case Product(factors=factors):
            for k, factor in enumerate(factors):
                if isinstance(factor, Number) and factor.value.denominator == 1 and factor.value > 1:
                    yield int(factor.value), Product((*factors[:k], *factors[k + 1 :]))
                elif isinstance(factor, Quotient):
                    for number, rest in _factors_apart(factor):
                        yield number, Product((*factors[:k], rest, *factors[k + 1 :]))
        case Quotient(numerator=above, denominator=below):
            yield from ((number, rest / below) for number, rest in _factors_apart(above))
        case _:
            return


def may_be_part(sentence: str) -> bool:
    """Tell whether words make of a quantity a part or a multiple of it."""
    return _PART.search(_SETTING.sub("", sentence)) is not None


def _over_cosine(node: Formula) -> set[str]:
    """Return the letters that are forces along the stroke in a formula: F of F/cos φ and of F tan φ."""
    match node:
        case Quotient(numerator=above, denominator=Call(function="cos", argument=Name())):
            factors = above.factors if isinstance(above, Product) else (above,)
        case Product(factors=factors) if any(map(_is_tangent, factors)):
            pass
        case _:
            return set()
    return {factor.name for factor in factors if isinstance(factor, Name)}


def _is_tangent(node: Formula) -> bool:
    """Tell whether a formula is the tangent of an angle, or anything over the cosine of one."""
    match node:
        case Call(function="tan", argument=Name()):
            return True
        case Quotient(denominator=Call(function="cos", argument=Name())):
            return True
    return False


def _without_letters_named(sentence: str, own: frozenset[str]) -> str:
    """Return a sentence without the words that name a formula's own letters: the total volume $V_H$."""
    for letter in own:
        signs = {letter, plain_letter(letter), "\\" + letter, letter.partition("_")[0]}
        sign = "|".join(map(re.escape, sorted(signs, key=len, reverse=True)))
        sentence = re.sub(
            rf"{_OF_A_LETTER}[^.;,$=]{{0,40}}?\$?(?<![A-Za-z])(?:{sign})(?![A-Za-z])", " ", sentence
        )
    return sentence


def _has_own_convention(claim: Formula, knowledge: Knowledge) -> bool:
    """Tell whether the page defines a letter as half a difference: δ = (ω₁ - ω₂)/(2 ω) is another δ."""
    own = [knowledge.definitions[n] for n in names(claim) if n in knowledge.definitions]
    formulas = [d.formula if d.numeric else d.node for d in own]
    parts = [list(walk(node)) for node in formulas if node is not None]
    return any(
        any(map(_is_of_letters, each))
        and any(isinstance(part, Number) and part.value != 1 for part in each)
        for each in parts
    )


def _is_woven(claim: Formula, knowledge: Knowledge) -> bool:
    """Tell whether the page gives a letter of a formula by others of it: T_e of M + T_e by √(M² + T²)."""
    own = names(claim)
    given = [knowledge.definitions[n] for n in own if n in knowledge.definitions]
    behind = [each.node for each in given if not each.solved]  # m s² + c s + k = 0 gives no c
    return any(names(node) & own for node in behind if node is not None)


def _is_of_letters(node: Formula) -> bool:
    """Tell whether a formula is a sum or difference of letters."""
    terms = node.terms if isinstance(node, Sum) else ()
    bare = [term.operand if isinstance(term, Negative) else term for term in terms]
    return bool(bare) and all(isinstance(term, Name) for term in bare)


def _is_multiple_of_its_kind(chain: Chain) -> bool:
    """Tell whether a relation is a number times another letter of the kind: P_2 = 1.5 P."""
    head, own = chain.sides[0].node, names(chain.sides[1].node)
    if not isinstance(head, Name) or len(own) != 1:
        return False
    (other,) = own
    return other != head.name and stem_of(other) == stem_of(head.name)


def _is_compared(quantity: Quantity, name: str, claim: Formula) -> bool:
    """Tell whether a formula is of a ratio, or ties two letters of a kind, τ_1 = τ_2 (d_2/d_1)³.

    The state at the end of a process is given by that at its beginning.
    """
    alike = any(n != name and stem_of(n) == stem_of(name) for n in names(claim))
    return RATIO in name or (alike and "at the end of" not in quantity.name)


def _has_complement(claim: Formula, knowledge: Knowledge) -> bool:
    """Tell whether the page defines a letter as what another leaves: k = 1 - β, a share the other way."""
    own = [knowledge.definitions[n].node for n in names(claim) if n in knowledge.definitions]
    return any(isinstance(node, Sum) and Number(Fraction(1)) in node.terms for node in own)


def _is_right(outcome: Verdict | Decision) -> bool:
    return outcome.is_proved if isinstance(outcome, Decision) else outcome.verdict in PROVED_WORDS
