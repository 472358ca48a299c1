"""Orders that words or an index name: "the second-order force is F_2 = λ m r ω² cos 2θ", A_4 = -λ³/4 - ….

The first formula of such a letter is a definition, and true of any letter. Where words name an order of
the inertia force, the acceleration or the inertia torque, or where the page has a series with A_n cos nθ,
it says more:

    it is that order, its amplitude or its coefficient, of one cylinder or of the engine   conditional
    it differs by one slip that no other convention makes right                            refuted
    anything else                                                                          a definition

Authors part in the sign of a force and in what a coefficient is divided by (n or n², as of the velocity
or the displacement): what one of these makes right is right.
"""

from __future__ import annotations

from cmath import rect
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from math import pi

from symbalance.budgets import OverBudgetError, run_within
from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Summation,
    names,
    walk,
)
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision, without_dots
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.declared.engines import Engines, NoEngines
from symbalance.notes.checking.declared.geometry import Geometry, square
from symbalance.notes.checking.declared.role_phrases import CONVENTIONS
from symbalance.notes.checking.declared.symbols import far_power, series_node
from symbalance.notes.checking.meant.meant_quantities import (
    OF_RATIO,
    ONE_SLIP,
    SEARCH,
    SHARE,
    MeantQuantities,
    is_only_negated,
    rests_on_more,
)
from symbalance.notes.checking.meant.meant_words import NOBODY, USUAL_END
from symbalance.notes.checking.meant.order_directions import OrderDirections, Sizes
from symbalance.notes.checking.meant.signs_in_series import (
    line_of_acceleration,
    multiple_of_angle,
    sign_in_series,
)
from symbalance.notes.checking.meant.waves_of_named_orders import (
    WITHOUT_RATIO,
    OrderNamed,
    has_ratio_as_number,
    refute_wave,
)
from symbalance.notes.checking.verdicts import DEFINITION, Verdict
from symbalance.notes.checking.words.accuracies import introduces_aid, without_accuracies
from symbalance.notes.checking.words.crank_angles_listed import CrankAngles
from symbalance.notes.checking.words.engines_in_words import EnginesInWords
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

FORCE, ACCELERATION, TORQUE = "inertia force", "piston acceleration", "inertia torque"
COUPLE = "couple"
REACH = 300
"""Characters before a relation in which words say that other orders cancel."""
FAR = 800
"""Characters before a relation in which its engine is named."""
HIGHEST = 8
"""Orders above are named by nobody."""
_NUMBERS = {
    1: r"first|primer[oa]?|premier|primary|1st|erste[rsnm]?|1\.|I\.|[一1]\s?次",
    2: r"second(?:ary)?|segund[oa]|deuxième|2nd|zweite[rsnm]?|2\.|II\.|[二2]\s?次",
    3: r"third|3rd|dritte[rsnm]?|3\.|III\.|[三3]\s?次",
    4: r"fourth|4th|vierte[rsnm]?|4\.|IV\.|[四4]\s?次",
    6: r"sixth|6th|sechste[rsnm]?|6\.|VI\.|[六6]\s?次",
}
_ORDER = re.compile(
    "|".join(rf"(?P<n{n}>(?<![A-Za-z0-9.]){pattern})" for n, pattern in _NUMBERS.items()),
    re.IGNORECASE,
)
_KINDS: Mapping[str, re.Pattern[str]] = {
    TORQUE: re.compile(r"torque|(?:massen)?drehmoment|トルク", re.IGNORECASE),
    COUPLE: re.compile(
        r"couples?(?![A-Za-z])|moments?(?![A-Za-z])|momente?(?![A-Za-z])|偶力|モーメント", re.IGNORECASE
    ),
    FORCE: re.compile(
        r"forces?(?![A-Za-z])|fuerzas?|kräfte|kraft(?![A-Za-z])|慣性力|合力|釣り?合い?力", re.IGNORECASE
    ),
    ACCELERATION: re.compile(r"acceleration|beschleunigung|加速度", re.IGNORECASE),
}
_ORDER_WORD = re.compile(
    r"order|orden\b|ordre\b|harmonic|Ordnung|Harmonische|primary|secondary|次(?:の)?(?:慣性|成分|項|調和|の力|加速"
    r"|トルク|不?釣|力)",
    re.IGNORECASE,
)
SPEAKS_OF_MORE = re.compile(
    r"cylinders|cilindros|cilindri\b|cylindres|zylindern?(?![A-Za-z])|気筒|\bbanks?\b|b[oó]xer|lanchester|rotating\s+(?:vector|mass)"
    r"|vectors?\b|zeiger"
    r"|twin|pair|paar|\btwo\b|\bzwei|both|beide|half|hälfte|balanc|ausgleich|釣合|バランス|resultant"
    r"|resultier|total|gesamt|\bsum\b|summe|合力|合計|component"
    r"|komponente|mean|mittel|gas|rotating|rotier|umlauf|回転質量|side|seiten|rod|pleuel|V-?\d|couple|kipp"
    r"|偶力",
    re.IGNORECASE,
)
"""Words for more or for less than what one cylinder's piston does: no factor is a slip beside them."""
_IN_A_CASE = re.compile(
    r"\b(?:at|when|if|where|double[ds]?|twice|times|speed|wenn|falls|bei|im|am|doppelt\w*|verdoppel\w*"
    r"|drehzahl"
    r"|left|remain\w*|rest|leaves|bleib\w*)\b|のとき|の場合|倍|残",
    re.IGNORECASE,
)
"""Words for a case in which an order is another than in general."""
_FREE = re.compile(
    r"\bfree\b|freie|resultant|resultier|total|gesamt|\bsum\b|summe|合力|合計|全体|不?釣|不つりあい|不つり合い"
    r"|\b(?:adds?|sums?)\s+(?:up\s+)?(?:to|into)\b|addieren\s+sich|s['’]ajoutent|s['’]additionnent|si\s+sommano|se\s+suman|zusammen\s+ergeben"
    r"|\ball\s+(?:the\s+)?(?:\w+\s+)?cylinders|\balle[rn]?\s+(?:\w+\s+)?zylinder|whole\s+engine"
    r"|ganzen?\s+motors?|全気筒",
    re.IGNORECASE,
)
_ALL_CYLINDERS = re.compile(
    r"(?:\ball|\bboth|\btwo|\bthree|\bfour|\bsix|\beight|\balle[rn]?|\bbeide[rn]?|\bzwei|\bdrei|\bvier|\bsechs|\bacht)\s+"
    r"(?:the\s+)?(?:\w+\s+)?(?:cylinders|zylindern?|pistons|kolben)|[二三四六八2-9全両]\s?(?:つの)?(?:気筒|シリンダ)",
    re.IGNORECASE,
)
_OF_ONE = re.compile(
    r"\b(?:per|each|one|single)\b|\bje\b|\bpro\b|einzel|eines\s+zylinders|1\s?気筒|各|単気筒|一つ",
    re.IGNORECASE,
)
_SINGLE = re.compile(
    r"single[\s-]cylinder|one[\s-]cylinder|einzylinder|monocyl|monocil|単気筒|一気筒", re.IGNORECASE
)
_OF_HALVES = re.compile(
    r"\b(?:direct|reverse|forward|backward|co-?rotating|counter-?rotating)\b|gegenlauf|mitlauf|逆回転",
    re.IGNORECASE,
)
"""Words for the two cranks that turn with the crank and against it, half of a piston's force each."""
_PARTLY = re.compile(
    r"pair|paar|half|hälfte|halb|both|beide|\btwo\b|\bzwei\b|each|\bje\b|\bper\b|balanc|ausgleich"
    r"|lanchester|bank|remain"
    r"|rest|bleib|component|komponente|bearing|lager|ratio|rotating|rotier|対|半分|各|両|残|釣合"
    r"|バランス",
    re.IGNORECASE,
)
"""Words for a part of what a whole engine does, or for what is done against it."""
_CANCEL = re.compile(
    r"vanish|cancel|balance\s+each|heben\s+sich|verschwind|entfall|打ち消|消え", re.IGNORECASE
)
_LEFT = re.compile(r"remain|is\s+left|bleib|übrig|残", re.IGNORECASE)
"""Words by which orders of the whole engine vanish, and by which one is all that it has left."""
_BANKS = re.compile(
    r"\bV-?\s?(?:twin|engine|motor|[2468]\b|1[026]\b)|\bvee\b|\bbanks?\b|gabelmotor|V型|V形|バンク|\ben\s+V\b|\ba\s+V\b"
    r"|radial|stern(?:motor|form)|星[型形]",
    re.IGNORECASE,
)
"""Words for engines of which a force of the whole is no multiple of one cylinder's."""
_PISTON = re.compile(r"\bpiston(?!s)|kolben|ピストン", re.IGNORECASE)
_NOTHING = 1e-6
_COEFFICIENT = re.compile(r"(?P<stem>[A-Za-z])_(?P<order>[1-9])")
_FACTOR = re.compile(r"(?:factor|number misprinted) .*")
_IS_FACTOR = re.compile(r"factor|number misprinted")
_SINE = re.compile(r"(?:sin|cos) for (?:sin|cos)")


Frame = tuple[Knowledge, Geometry, tuple[str, ...]]
"""What is known with the letters that words explain, the crank of these, and what that assumes."""


@dataclass(frozen=True, slots=True)
class _Order:
    """An order that words or an index name, and of what."""

    number: int
    kind: str
    words: str
    is_coefficient: bool = False
    is_alone: bool = True
    """Whether the words speak of one cylinder's piston only."""
    series: frozenset[str] = frozenset()
    """The letters of the series that a coefficient stands in."""
    sign: int = 0
    """The sign it has there beside a bare cos θ, 0 where none stands."""
    is_of_engine: bool = False
    """Whether they speak of what is free of the whole engine."""
    is_in_row: bool = False
    """Whether it stands in a table, whose row names the engine."""
    is_left: bool = False
    """Whether words say that it is what the whole engine has left."""
    quote: str = ""
    """The words as the page has them, where it is in another language."""
    is_of_acceleration: bool = False
    """Whether the series is r ω² (cos θ + … + A_n cos nθ): its coefficients are divided by nothing."""
    is_of_several: bool = False
    """Whether the lines before speak of an engine of several cylinders."""
    declared: str = ""
    """What the letter is declared as, where that says of which order it is."""

    @property
    def source(self) -> str:
        """What says so."""
        if self.declared:
            return f"declared as “{self.declared}”"
        words = (self.quote or self.words).strip(" \n\t$,.;:、は\\([")
        taken = f"taken from the words “{words}”" if words else "by the series it stands in"
        return f"{NOBODY}; {taken}"


@dataclass
class NamedOrders:
    """Judges the orders of one page that words or an index name."""

    meant: MeantQuantities

    @cached_property
    def _directions(self) -> OrderDirections:
        return OrderDirections(self.meant.words.document.chains)

    @cached_property
    def _speaks_of_more(self) -> bool:
        """Tell whether the page speaks of more or less than one cylinder's piston."""
        return SPEAKS_OF_MORE.search(self.meant.words.page) is not None

    @cached_property
    def _speaks_of_banks(self) -> bool:
        """Tell whether the page speaks of cylinders in banks, whose forces do not simply add up."""
        return _BANKS.search(self.meant.words.page) is not None

    @cached_property
    def _names_several(self) -> bool:
        """Tell whether the page names an engine of several cylinders and none of one."""
        sizes = {engine.cylinders for engine in EnginesInWords(self.meant.words.page).mentions}
        return (
            any(size > 1 for size in sizes)
            and 1 not in sizes
            and not _SINGLE.search(self.meant.words.page)
        )

    def judge(
        self,
        chain: Chain,
        k: int,
        knowledge: Knowledge,
        cranks: Callable[[Chain], CrankAngles | None],
    ) -> Verdict | Decision | None:
        """Return the verdict on a relation that defines a letter, if it is an order by its words.

        `cranks` gives the cranks of the engine that a relation is of, where one is named.
        """
        right = without_dots(chain.sides[k + 1].node)[0]
        head = self._head(chain, k, knowledge)
        order = None if head is None else self._order_of(head, chain, right)
        if head is None or order is None or order.number > HIGHEST or _has_several_orders(right):
            return None
        outcome = self._judge_order(head, order, chain, knowledge, cranks(chain))
        is_of_letters = names(right) and not order.is_coefficient
        if outcome is not None or not is_of_letters or isinstance(self.meant.sources.engines, NoEngines):
            return outcome
        kind = order.kind
        text = f"{plain_letter(head.name)} is order {order.number} of the {kind} ({order.source})"
        named = OrderNamed(order.number, order.words, text, kind == TORQUE, kind == COUPLE)
        return run_within(SEARCH, lambda: refute_wave(named, chain, self.meant, knowledge), SHARE)

    def _judge_order(
        self, head: Name, order: _Order, chain: Chain, knowledge: Knowledge, angles: CrankAngles | None
    ) -> Verdict | Decision | None:
        """Return the verdict on an order by the slider-crank's series, or by the whole engine."""
        right = without_dots(chain.sides[1].node)[0]
        is_of_all = isinstance(chain.sides[0].node, Summation) or order.is_left
        if is_of_all and (angles is None or not angles.is_usual):
            return None
        if isinstance(self.meant.sources.engines, NoEngines):
            return None  # nobody is at hand who knows a slider-crank's series
        frame = self.meant.frame(head.name, right, chain, knowledge)
        if frame is not None and any(OF_RATIO.search(text) for text in frame[2]) and not _divides(right):
            frame = (
                self.meant.frame(head.name, right, chain, knowledge, ratio=CONVENTIONS["r/l"]) or frame
            )
        balanced = self._balanced(order, angles)
        if not names(right) or (balanced and all(balanced)):
            return self._vanishing(head.name, order, chain.sides[1], angles, frame)
        return None if frame is None else self._within_budget(chain, order, frame, angles)

    def _within_budget(
        self, chain: Chain, order: _Order, frame: Frame, angles: CrankAngles | None
    ) -> Verdict | Decision | None:
        if order.kind == COUPLE:
            return None
        try:
            return run_within(SEARCH, lambda: self._judge(chain, order, frame, angles), SHARE)
        except OverBudgetError as problem:
            reason = f"whether it is the engine's {order.kind} was not decided within {problem.spent}"
            return Decision(DEFINITION, reason)

    @staticmethod
    def _head(chain: Chain, k: int, knowledge: Knowledge) -> Name | None:
        """Return the letter that a relation gives a formula, or whose sum over all cylinders it gives."""
        left = chain.sides[k].node
        is_sum = isinstance(left, Summation) and left.index is None
        head = left.body if isinstance(left, Summation) and is_sum else left
        if k or not isinstance(head, Name) or chain.relations[0].sign not in "=≈":
            return None
        return None if head.name in knowledge.letters or (is_sum and knowledge.knows(head.name)) else head

    def _order_of(self, head: Name, chain: Chain, value: Formula) -> _Order | None:
        if isinstance(chain.sides[0].node, Summation):
            return _summed(head.name)
        return self._coefficient(head.name, value, chain) or self._named(head.name, chain)

    def _vanishing(
        self, name: str, order: _Order, side: Side, angles: CrankAngles | None, frame: Frame | None
    ) -> Decision | None:
        """Decide whether a whole engine's order is 0, where a table's row or the words say that it is."""
        each = self._balanced(order, angles)
        if not each or angles is None:
            return None
        is_zero = isinstance(side.node, Number) and not side.node.value
        if not is_zero and (frame is None or any(isinstance(p, Summation) for p in walk(side.node))):
            return None
        if not is_zero and frame is not None:
            value = decide(side, Side((Number(Fraction(0)),), side.span), "=", frame[0])
            if value.status not in (PROVED, REFUTED):
                return None
            is_zero = value.is_proved
        text = (
            f"{plain_letter(name)} is order {order.number} of the whole engine's {order.kind}"
            f" ({order.source})"
        )
        if is_zero and all(each):
            return Decision(PROVED, assumptions=(text, angles.text))
        if is_zero != any(each) and not (is_zero and order.kind == COUPLE and angles.signs):
            what = "cancel" if any(each) else "do not cancel"
            kind = "couples" if order.kind == COUPLE else "forces"
            return Decision(
                REFUTED, f"if {text}; if {angles.text}: the {kind} of order {order.number} {what}"
            )
        return None

    @staticmethod
    def _balanced(order: _Order, angles: CrankAngles | None) -> list[bool]:
        """Return whether a whole engine's order cancels, for each crank it may have; else nothing."""
        if order.kind not in (FORCE, COUPLE) or order.is_coefficient or angles is None:
            return []
        if not (order.is_of_engine and angles.is_usual):
            return []
        is_couple = order.kind == COUPLE
        ways = (angles, *angles.others)
        if is_couple and not angles.arms:
            return []
        return [
            is_balanced(way, order.number, with_arms=is_couple)
            for way in ways
            if way.arms or not is_couple
        ]

    def _named(self, name: str, chain: Chain) -> _Order | None:
        """Return the order that the sentence before a relation names; None where it names none or two."""
        header = self.meant.words.header_of_column(chain)
        header = (
            header if _ORDER.search(header) else ""
        )  # the row's first cell may name it: formula, value
        own = header or self.meant.words.before(chain)
        original = self.meant.words.glossary.own_words(own)
        quote = "" if original == own else original
        declared = "" if header else self._declared_order(name, own, chain)
        own = self.meant.words.glossary.english(declared) if declared else own
        is_aid = name.partition("_")[2] in ("", "0") and introduces_aid(own)
        if is_aid or _OF_HALVES.search(own):
            return None
        own = without_accuracies(own)
        clause = re.split(r"[,;:、](?=\s|\$)|\b(?:and|und)\b", own)[-1]
        own = clause if _ORDER_WORD.search(clause) else own
        numbers = {int((m.lastgroup or "n0")[1:]) for m in _ORDER.finditer(own)}
        kinds = [kind for kind, pattern in _KINDS.items() if pattern.search(own)]
        whole = self.meant.words.document.text[max(0, chain.start - REACH) : chain.start]
        whole = self.meant.words.glossary.english(whole)
        far = self.meant.words.document.text[max(0, chain.start - FAR) : chain.start]
        is_left = _CANCEL.search(whole) is not None and _LEFT.search(own) is not None
        if is_left:  # of the first and second orders the torques cancel, of the third there remains
            kinds = kinds or [kind for kind, pattern in _KINDS.items() if pattern.search(whole)]
        if len(numbers) != 1 or not kinds or not _ORDER_WORD.search(own):
            return None
        number = numbers.pop()
        roman = {"I": 1, "II": 2, "III": 3, "IV": 4, "VI": 6}
        index = name.rpartition("_")[2] if "_" in name else ""
        by_index = roman.get(index) or (int(index) if index.isdecimal() else number)
        if by_index != number:
            return None
        is_alone = not self._speaks_of_more and not _IN_A_CASE.search(own)
        is_of_one = _OF_ONE.search(own) is not None
        is_of_engine = (bool(header) or is_left or _FREE.search(own) is not None) and not is_of_one
        is_of_engine |= kinds[0] == TORQUE and _is_of_several(own)
        return _Order(
            number,
            kinds[0],
            own,
            is_alone=is_alone,
            is_of_engine=is_of_engine,
            is_in_row=bool(header) or is_left,
            is_left=is_left,
            quote=quote,
            is_of_several=is_of_engine and _names_several(far),
            declared=declared,
        )

    def _declared_order(self, name: str, own: str, chain: Chain) -> str:
        """Return what a letter is declared as where that names its order and the sentence names none."""
        declared = self.meant.words.declarations.symbols_at(chain.lines[0]).get(name, "")
        meaning = declared.partition("[")[0].strip()
        english = self.meant.words.glossary.english(meaning)
        is_of_order = _ORDER_WORD.search(english) is not None and _ORDER.search(english) is not None
        return meaning if is_of_order and _ORDER_WORD.search(own) is None else ""

    def _coefficient(self, name: str, value: Formula, chain: Chain) -> _Order | None:
        """Return the order of A_n, if a series on the page has A_n cos nθ, and A_n no angle in it."""
        match = _COEFFICIENT.fullmatch(name)
        if match is None or any(isinstance(part, Call) for part in walk(value)):
            return None
        number = int(match["order"])
        for other in self.meant.words.document.chains:
            for side in other.sides:
                if name in names(side.node) and _has_wave(side.node, name, number):
                    sentence = self.meant.words.before(other)
                    kinds = [kind for kind, pattern in _KINDS.items() if pattern.search(sentence)]
                    kind = kinds[0] if len(kinds) == 1 else ""
                    letters = frozenset(names(side.node))
                    chains = self.meant.words.document.chains
                    return _Order(
                        number,
                        kind,
                        sentence,
                        is_coefficient=True,
                        series=letters,
                        sign=sign_in_series(chains, name, number),
                        is_of_acceleration=line_of_acceleration(chains, name, number) > 0,
                    )
        own = self.meant.words.sentence_before(chain)
        kinds = [kind for kind, pattern in _KINDS.items() if pattern.search(own)]
        if len(kinds) == 1 and re.search(r"coefficient|koeffizient|beiwert|係数", own, re.IGNORECASE):
            return _Order(number, kinds[0], own.split("=")[0], is_coefficient=True)
        return None

    def _judge(
        self, chain: Chain, order: _Order, frame: Frame, angles: CrankAngles | None
    ) -> Verdict | Decision | None:
        known, crank, assumptions = frame
        right = chain.sides[1]
        name = plain_text(chain.sides[0].node)
        what = "coefficient of " if order.is_coefficient else ""
        kind = order.kind or "piston's motion"
        text = f"{name} is {what}order {order.number} of the {kind} ({order.source})"
        for target, more, sign in self._targets(order, crank, right.node, angles):
            decision = decide(Side((target,), right.span), right, "≈", known)
            if decision.is_proved and not rests_on_more(decision) and not _is_cut_short(decision, order):
                if (against := self._against_direction(chain, order, target, sign, frame)) is not None:
                    return against
                return replace(decision, assumptions=(text, *assumptions, *more, *decision.assumptions))
        total = _whole_sum(angles, order.number) if angles is not None and angles.is_usual else 0
        is_of_all = total and (order.is_of_engine or order.is_in_row) and not order.is_coefficient
        factor = total if is_of_all and angles is not None else 1
        more = (f"if {angles.text}",) if factor > 1 and angles is not None else ()
        return self._with_slip(chain, order, (f"if {text}", *more), frame, factor)

    def _against_direction(
        self, chain: Chain, order: _Order, target: Formula, sign: int, frame: Frame
    ) -> Verdict | None:
        """Return that an order is counted against the direction of the others; None if it is not.

        F_1 = m r ω² cos θ and F_4 = m r ω² (λ³/4) cos 4θ cannot both be: with the first, the fourth is
        negative.
        """
        known, crank, _ = frame
        right, head = chain.sides[1], chain.sides[0].node
        has_wave = any(isinstance(part, Call) for part in walk(right.node))
        is_of_one = not order.is_of_engine and SPEAKS_OF_MORE.search(order.words) is None
        if not has_wave or not isinstance(head, Name) or order.is_coefficient or not is_of_one:
            return None
        stem, sizes = head.name.partition("_")[0], names(crank.radius) | names(crank.omega)
        sizes |= names(crank.mass) if order.kind == FORCE else frozenset()
        direction = self._directions.direction(stem, order.kind, sign, chain, Sizes(crank, sizes))
        if direction.sign == sign or order.kind == TORQUE or self.meant.words.counts_from_bottom:
            return None
        left = Side((Negative(target),), right.span)
        decision = decide(left, right, "≈", known)
        if decision.status != REFUTED:
            return None
        counted = f"line {direction.line} counts the {order.kind} the other way"
        return self.meant.with_fix(chain, 0, left, replace(decision, reason=counted), known)

    def _targets(
        self, order: _Order, crank: Geometry, value: Formula, angles: CrankAngles | None
    ) -> Iterator[tuple[Formula, tuple[str, ...], int]]:
        """Yield what an order may be by one of the conventions, what it rests on, and its direction."""
        has_sizes = bool(names(crank.omega) & names(value))
        base = self._base(order, crank, with_sizes=has_sizes)
        if base is None:
            return
        factors: list[tuple[Fraction, tuple[str, ...]]] = []
        if not order.is_of_engine and not order.is_coefficient and _is_of_several(order.words):
            return
        names_several = order.is_of_several or self._names_several
        is_unknown = angles is None and not self._speaks_of_banks and not names_several
        if not order.is_of_engine or is_unknown:
            factors.append((Fraction(1), ()))
        if order.is_coefficient and not order.is_of_acceleration:
            factors += [(Fraction(1, order.number**p), ()) for p in (1, 2)]
        elif angles is not None and angles.is_usual and (total := _whole_sum(angles, order.number)):
            factors.append((Fraction(total), (angles.text,)))
        for factor, more in factors:
            for sign in (order.sign,) if order.sign else (1, -1):
                yield (
                    Product((rational_node(factor * sign), base, *self._wave(order, crank, value))),
                    more,
                    sign,
                )

    def _wave(self, order: _Order, crank: Geometry, value: Formula) -> tuple[Formula, ...]:
        if order.is_coefficient or not any(isinstance(part, Call) for part in walk(value)):
            return ()
        function = "sin" if order.kind == TORQUE else "cos"
        return (Call(function, Product((Number(Fraction(order.number)), crank.theta))),)

    def _base(
        self, order: _Order, crank: Geometry, *, is_first: bool = False, with_sizes: bool = False
    ) -> Formula | None:
        """Return the amplitude of an order, or its coefficient, as a series in the rod ratio.

        With `is_first` it is the first term of the series, with `with_sizes` a coefficient in units.
        """
        engines, power = self.meant.sources.engines, far_power(order.number)
        if order.kind == TORQUE:
            terms = torque_terms(engines, order.number, power)
            sizes = (crank.mass, square(crank.radius), square(crank.omega))
        else:
            terms = dict(engines.coefficient_terms(order.number, power))
            sizes = (crank.radius, square(crank.omega))
            sizes = (crank.mass, *sizes) if order.kind == FORCE else sizes
        if not terms:
            return None
        lowest = min(terms)
        series = series_node({lowest: terms[lowest]} if is_first else terms, crank.ratio)
        return series if order.is_coefficient and not with_sizes else Product((series, *sizes))

    def _with_slip(
        self, chain: Chain, order: _Order, texts: tuple[str, ...], frame: Frame, factor: int
    ) -> Verdict | None:
        """Return that a formula is wrong by one slip from the order that words name; else None."""
        known, crank, assumptions = frame
        right = chain.sides[1]
        usual = [t for t in assumptions if t.endswith(USUAL_END) and t not in self.meant.shown]
        is_guess = any("length" in text for text in usual)
        is_of_lambda = any("ratio" in text and text.startswith("λ") for text in usual)
        is_guess |= any("ratio" in text and not text.startswith("λ") for text in usual)
        if order.series and not order.series & names(crank.omega):
            return None  # in a unit of its own
        is_whole = order.is_in_row or (order.is_of_engine and not _PARTLY.search(order.words))
        is_alone = order.is_alone or (is_whole and factor > 1)
        is_whole_of_all = is_whole and factor > 1
        if WITHOUT_RATIO.search(order.words) or (factor <= 1 and _is_of_several(order.words)):
            return None
        has_ratio = names(right.node) & (names(crank.ratio) - names(crank.radius))
        if not has_ratio and order.kind != TORQUE and has_ratio_as_number(right.node):
            return None
        if order.is_of_several and factor <= 1:
            return None  # of an engine whose cranks nobody knows
        if not order.kind or not is_alone or (is_guess and not is_whole_of_all) or crank.small is None:
            return None
        sizes = names(crank.mass) | names(crank.radius) | names(crank.omega)
        has_all_sizes = sizes <= names(right.node) and not order.is_coefficient
        verdicts: list[Verdict] = []
        for target, relation in self._standard(order, crank, right.node):
            for sign in (order.sign,) if order.sign else (1, -1):
                side = Product((rational_node(Fraction(sign * factor)), target))
                left = Side((side,), right.span)
                decision = decide(left, right, relation, known)
                if decision.status != REFUTED or decision.left is None:
                    continue
                decision = replace(decision, reason="; ".join((*texts, *assumptions)))
                verdict = self.meant.with_fix(chain, 0, left, decision, known)
                fix = verdict.fix
                is_slip = fix is not None and (
                    ONE_SLIP.fullmatch(fix.kind) or (fix.kind == "factor" and has_all_sizes)
                )
                if fix is None or len(fix.faults) != 1 or fix.of_left or not is_slip:
                    continue
                if is_of_lambda and not _FACTOR.fullmatch(fix.kind):
                    continue  # l/r, it may be; a factor is wrong of both
                if is_guess and not _IS_FACTOR.match(fix.kind):
                    continue  # the ratio's power is right, so it is the ratio
                is_negated = is_only_negated(right.node, fix.node) and not order.sign
                if not is_negated and not _may_be_meant(fix.kind, order, right.node):
                    verdicts.append(verdict)
        return min(verdicts, key=lambda v: len(v.fix.text) if v.fix else 0, default=None)

    def _standard(self, order: _Order, crank: Geometry, value: Formula) -> Iterator[tuple[Formula, str]]:
        """Yield an order as a series, and its first term alone for a formula that is but one term."""
        wave = self._wave(order, crank, value)
        if (base := self._base(order, crank)) is None:
            return
        yield Product((base, *wave)), "≈"
        first = self._base(order, crank, is_first=True)
        if first is not None and not any(isinstance(part, Sum) for part in walk(value)):
            yield Product((first, *wave)), "="


def _is_of_several(words: str) -> bool:
    """Tell whether words name an engine of several cylinders, and not one of them."""
    names_engine = _BANKS.search(words) is not None or any(
        engine.cylinders > 1 for engine in EnginesInWords(words).mentions
    )
    return names_engine and _OF_ONE.search(words) is None and _PISTON.search(words) is None


def _names_several(words: str) -> bool:
    """Tell whether words speak of an engine of several cylinders, or of both or all cylinders."""
    mentions = EnginesInWords(words).mentions
    return any(engine.cylinders > 1 for engine in mentions) or _ALL_CYLINDERS.search(words) is not None


def _divides(node: Formula) -> bool:
    """Tell whether a formula has a letter below a line: a ratio there is that of the rod to the crank."""
    return any(isinstance(part, Quotient) and names(part.denominator) for part in walk(node))


def _summed(name: str) -> _Order | None:
    """Return the order of ΣF_2, the sum over all cylinders of a force whose index is its order."""
    stem, _, index = name.rpartition("_")
    number = {"1": 1, "I": 1, "2": 2, "II": 2, "4": 4, "IV": 4}.get(index, 0)
    is_force = number and stem in ("F", "K", "P", "f")
    return _Order(number, FORCE, f"Σ{name}", is_of_engine=True, is_in_row=True) if is_force else None


def torque_terms(engines: Engines, order: int, power: int) -> dict[int, Fraction]:
    """Return T_order of the inertia torque over m r² ω² as power of r/l -> coefficient, of sin nθ.

    With a = r ω² Σ A_n cos nθ and v = -r ω Σ (A_n/n) sin nθ it is the product of both, order by order.
    """
    terms = {n: dict(engines.coefficient_terms(n, power)) for n in range(1, power + 1)}
    result: dict[int, Fraction] = {}
    for n, first in terms.items():
        for m, second in terms.items():
            # cos nθ sin mθ = (sin (m + n)θ + sin (m - n)θ)/2
            share = (m + n == order) + (m - n == order) - (n - m == order)
            for (p, a), (q, b) in ((x, y) for x in first.items() for y in second.items()):
                if share and p + q <= power:
                    result[p + q] = result.get(p + q, Fraction(0)) + share * a * b / (2 * m)
    return {p: c for p, c in sorted(result.items()) if c}


def _whole_sum(angles: CrankAngles, order: int) -> int:
    """Return how many times one cylinder's order all of them give, 0 where it is no whole number."""
    turns = [degrees * order / 360 % 1 for degrees in angles.degrees]
    return len(turns) if len(set(turns)) == 1 and not angles.signs else 0


def is_balanced(angles: CrankAngles, order: int, *, with_arms: bool = False) -> bool:
    """Tell whether the forces of an order cancel in an engine, Σ e^(i n δ) = 0, or their couples."""
    signs = angles.signs or (1,) * len(angles.degrees)
    arms = angles.arms if with_arms else (Fraction(1),) * len(signs)
    parts = zip(signs, arms, angles.degrees, strict=True)
    waves = [float(s * a) * rect(1, order * pi * float(d) / 180) for s, a, d in parts]
    return abs(sum(waves)) < _NOTHING  # cranks at parts of a turn: what does not vanish is far above


def _has_wave(node: Formula, name: str, order: int) -> bool:
    """Tell whether a formula has a letter times the cosine or the sine of an order."""
    for part in walk(node):
        if not isinstance(part, Product) or Name(name) not in part.factors:
            continue
        for factor in part.factors:
            is_wave = isinstance(factor, Call) and factor.function in ("cos", "sin")
            if is_wave and isinstance(factor, Call) and multiple_of_angle(factor.argument) == order:
                return True
    return False


def _has_several_orders(node: Formula) -> bool:
    """Tell whether a formula is a sum of several orders, cos θ + λ cos 2θ: no order by itself."""
    waves = (p for p in walk(node) if isinstance(p, Call) and p.function in ("sin", "cos"))
    return len({abs(multiple_of_angle(wave.argument)) for wave in waves} - {0}) > 1


def _is_cut_short(decision: Decision, order: _Order) -> bool:
    """Tell whether sides agree before the order's first power: nothing of it is shown then."""
    return decision.through is not None and decision.through < order.number - 1 and order.kind != TORQUE


def _may_be_meant(kind: str, order: _Order, value: Formula) -> bool:
    """Tell whether a slip may be another convention: a lone coefficient's factor, an angle's origin."""
    terms = [part for part in walk(value) if isinstance(part, Power | Name)]
    is_lone = order.is_coefficient and len(terms) <= 2
    if _FACTOR.fullmatch(kind):
        return is_lone
    return bool(_SINE.fullmatch(kind)) and order.number % 2 == 1
