"""Free forces and couples of engines that words name: "the triple's primary couple is √3 m r ω² a".

Where the words say an engine, an order, and whether a force or a couple is meant, the amplitude follows
from the cranks: |Σ e^{ikδ}| or |Σ z e^{ikδ}| times one cylinder's amplitude. A first formula that is one
product is compared with it:

    it is that amplitude, with or without cos kθ                        conditional on what the words say
    it has another number, another power of the ratio, another order    refuted, with what it should be
    anything else: two slips, a part, a balanced engine, a letter that
    may mean something else                                             None, a definition as before
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Number,
    Sum,
    Summation,
    names,
    walk,
)
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, UNDECIDED, Decision, without_dots
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.declared.symbol_roles import role_of
from symbalance.notes.checking.meant.engines.engine_claims import (
    COUPLE,
    FORCE,
    OF_ALL,
    OF_ONE,
    TORQUE,
    VECTORS,
    WHOLE,
    EngineClaim,
    EngineClaims,
)
from symbalance.notes.checking.meant.engines.engine_letters import (
    FIRST_TERMS,
    EngineLetters,
    Parts,
    mended,
    same,
)
from symbalance.notes.checking.meant.engines.order_indices import POWERS, index_of, wave_of
from symbalance.notes.checking.meant.engines.phases_of_waves import fits_the_cranks
from symbalance.notes.checking.meant.engines.sizes_explained import (
    without_balance_to_come,
    without_letters_explained,
    without_masses_of_one,
)
from symbalance.notes.checking.meant.letter_roles import sign_of
from symbalance.notes.checking.meant.meant_words import NOBODY, MeantWords
from symbalance.notes.checking.meant.products import (
    NoProductError,
    ProductOfPowers,
    product_of,
    terms_of,
)
from symbalance.notes.checking.repair.fixes import Repair, fix_of
from symbalance.notes.checking.verdicts import Verdict
from symbalance.notes.checking.words.engines_in_words import (
    EnginesInWords,
    NamedEngine,
    names_count,
)
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

_PART = re.compile(
    r"\b(?:pairs?|half|halves|halved|outer|inner|middle|front|rear|single|each(?!\s+(?:crank\s?)?(?:pin"
    r"|throw))|every|per|both|either|component|twice|thrice"
    r"|times|double[ds]?|mean|average|rms|peak[\s-]to[\s-]peak|swings?|gas|rods?|bearings?|ratio|left\s+over|residual|component\w*"
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
    r"|釣合い?おもり|バランサ|バランスシャフト|カウンタ|残(?![るっ])|各|1\s*気筒あたり|片側|半分|外側|内側|中央"
    r"|一対|成分|倍",
    re.IGNORECASE,
)
"""Words for a part or a multiple of what an engine's cylinders do, or for more that acts."""
_SHARE = re.compile(
    r"[0-9]\s?\\?%|per\s?cent|prozent|\bhal(?:f|ves?)\b|hälfte|moitié|mitad|metà|半分|thirds?\s+of|\bleft\b",
    re.IGNORECASE,
)
"""Words for a share of what acts, anywhere in a formula's paragraph or heading."""
_BALANCED = re.compile(
    r"balanc(?:er|ing|e\s+(?:shaft|weight|mass))|lanchester|counter-?(?:weight|balance|rotat)"
    r"|ausgleichs|gegengewicht"
    r"|contrepoids|contrapes|バランサ|バランスシャフト|カウンタ|釣合い?おもり|ウ[ェエ]イトで",
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
    r"(?:\b(?:outer(?:most)?|end|total|overall|half)\b|äußer\w*|\bhalbe\w*|gesamt\w*|外側|全長|first\s+(?:and"
    r"|to)\s+(?:the\s+)?last|extr[eê]me?s)"
    r"|length\s+of\s+the\s+(?:block|engine|crank)|baulänge",
    re.IGNORECASE,
)
_WEIGHTED = re.compile(
    r"weighted|lever|moment|couple|gewichtet|hebel|mass|偶力|モーメント", re.IGNORECASE
)
_SUMMED = re.compile(r"\\sum|Σ|∑|_\{?[ijk]\b")
_TORQUE_ORDERS = (1, 2, 3, 4)
_FEWEST_TERMS = _EITHER = 2
_ALL_OF = {
    count: re.compile(
        rf"\b(?:{english})\s+(?:cylinders?|pistons?|(?:crank)?throws?|crank\s?pins?|cranks)\b"
        rf"|\b(?:{german})\s+(?:zylindern?|kolben|kröpfungen|kurbeln|hubzapfen)",
        re.IGNORECASE,
    )
    for count, english, german in ((2, "two|both", "zwei|beiden?"), (3, "three", "drei"))
}
"""Words for all cylinders of an engine, by their number."""
_NONE = re.compile(r"(?!)")
_NEARLY = 2e-3
"""How near a rounded number has to come to the amplitude of one of several crankshafts."""
_KINDS = {
    "ratio": "exponent",
    "rod": "exponent",
    "mass": "exponent",
    "speed": "exponent",
    "radius": "exponent",
    "wave": "order",
    "function": "cos for sin",
}
_NEGATIVE_ORDER = 4
"""The order whose term of the exact force is negative."""
_IN_A_CASE = re.compile(
    r"\b(?:if|when|where|speed|wenn|falls|doubles?|doubled|increas\w*|grows?)\b|のとき|の場合|same\s+as"
    r"|compared|vergl|than\b|wie\s+beim",
    re.IGNORECASE,
)
_OF_CRANK = ("crank angle", "angular speed", "engine speed rpm", "time")
"""Roles of the letters in the argument of an engine's wave: cos 2θ, cos 2ωt."""
_OF_ANOTHER = re.compile(
    r"\b(?:divided|per\s+unit|relative|bezogen\s+auf\s+\$|ratio|normali[sz]ed|squared?)\b|比",
    re.IGNORECASE,
)


_UP_TO_SECOND = re.compile(
    r"(?:up\s+to|bis\s+(?:einschließlich\s+)?zu[mr]?|jusqu['’][àa]u?|fino\s+(?:al|a)|hasta\s+(?:el|la)?)\s+(?:and\s+"
    r"including\s+)?(?:\w+\s+)?(?:second|2nd|2\.|zweite|deuxième|2e|segund|second)|[2二]次まで",
    re.IGNORECASE,
)
"""Words for a sum of the first two orders: a term of one order alone is not what they are of."""
_BEHIND = 200
"""Characters behind a force's sentence in which it may be multiplied by the number of cylinders."""
_SPEED = re.compile(
    r"(?:twice|double|two\s+times|doppelte[rn]?|zweifache[rn]?)\s+(?:the\s+)?(?:crank(?:shaft)?|engine|kurbel(?:wellen)?)?"
    r"[\s-]*(?:speed|drehzahl|geschwindigkeit)|(?:crank(?:shaft)?|engine)[\s-]+speed|2\s?倍の(?:速度|速さ|回転)",
    re.IGNORECASE,
)
"""Words for how fast something turns, which make no multiple of a force."""


@dataclass
class EngineResultants:
    """Judges the free forces and couples of named engines on one page."""

    words: MeantWords
    sections: Sections

    @cached_property
    def claims(self) -> EngineClaims:
        """What the words of the page say."""
        return EngineClaims(self.words, self.sections)

    @cached_property
    def letters(self) -> EngineLetters:
        """What the letters of the page stand for."""
        return EngineLetters(self.words)

    @property
    def _text(self) -> str:
        return self.words.document.text

    def judge(self, chain: Chain, k: int, knowledge: Knowledge) -> Verdict | Decision | None:
        """Return the verdict on a relation that gives a letter a formula; None for others."""
        head = chain.sides[0].node
        head = head.argument if isinstance(head, Call) and head.function == "abs" else head
        is_sum = isinstance(head, Summation) and head.index is None
        head = head.body if isinstance(head, Summation) and is_sum else head
        if k or not isinstance(head, Name) or chain.relations[0].sign not in "=≈":
            return None
        value = without_dots(chain.sides[1].node)[0]
        is_open = (is_sum or head.name not in knowledge.letters) and head.name not in names(value)
        claim = self.claims.claim(head.name, chain) if is_open and self.claims.may_name(chain) else None
        meaning = knowledge.meanings.get(head.name, "")
        if claim is None or not claim.engine.stars or _is_of_another_engine(meaning, claim):
            return None
        # what nothing but its wave says gives a letter no second formula
        is_second = not claim.words and head.name in knowledge.definitions
        if is_second or self._turns_otherwise(value, knowledge):
            return None
        if claim.kind == TORQUE or not names(value):
            return self._vanishing(head.name, claim, value, chain)
        # the formula is of any size: λ = 36.5/125 is still the crank ratio
        formulas = {n: d for n, d in knowledge.definitions.items() if not d.numeric or n == head.name}
        knowledge = replace(knowledge, definitions=formulas)
        try:
            product = self.letters.expanded(product_of(value), head.name, knowledge)
            return self._compared(chain, head.name, claim, product, knowledge)
        except NoProductError:
            return self._by_terms(chain, head.name, claim, value, knowledge)

    def _turns_otherwise(self, value: Formula, knowledge: Knowledge) -> bool:
        """Tell whether a formula has a wave of the rod's angle: F_K sin β is no order of the engine.

        So is a wave of any other letter where the page calls one the crank angle: F_p sin φ beside θ.
        """
        calls = (part for part in walk(value) if isinstance(part, Call) and part.function != "sqrt")
        turning = {name for call in calls for name in names(call.argument)}
        meanings = {n: p.meaning for n, p in self.words.proposals.items()} | dict(knowledge.meanings)
        roles = {name: role_of(meaning) for name, meaning in meanings.items()}
        of_crank = {name for name, role in roles.items() if role in _OF_CRANK}
        if turning and "crank angle" in roles.values() and not turning & of_crank:
            return True
        return any(
            roles.get(name) == "rod angle"
            or ((known := knowledge.definitions.get(name)) is not None and known.is_rod_angle)
            for name in turning
        )

    def _by_terms(
        self, chain: Chain, name: str, claim: EngineClaim, value: Formula, knowledge: Knowledge
    ) -> Verdict | Decision | None:
        """Return the verdict on a sum of several orders, each of them one product with its own wave.

        It is refuted where one term is wrong by one slip and all others are the engine's.
        """
        terms = terms_of(value)
        if len(terms) < _FEWEST_TERMS or len(self.claims.orders_before(chain)) == 1:
            return None  # several orders where words name one are not that one
        products = self._orders(terms, name, claim, knowledge)
        if not products:
            return None
        outcomes = [
            self._compared(chain, name, own, product, knowledge, term)
            for term, (own, product) in zip(terms, products, strict=True)
        ]
        is_proved = [isinstance(each, Decision) and each.is_proved for each in outcomes]
        if all(isinstance(each, Verdict) for each in outcomes):
            return self._with_one_factor(chain, name, claim, terms, products, knowledge)
        if is_proved.count(True) != len(terms) - 1 + all(is_proved):
            return None
        for k, (own, product) in enumerate(products):
            if outcomes[k] is None:  # one cylinder's, beside a term that is of all
                of_all = replace(own, is_total=not same(own.sizes()[0], 1))
                outcomes[k] = self._compared(chain, name, of_all, product, knowledge, terms[k])
        wrong = [each for each in outcomes if isinstance(each, Verdict)]
        if None in outcomes or wrong:
            return wrong[0] if None not in outcomes and len(wrong) == 1 else None
        texts = (text for each in outcomes if isinstance(each, Decision) for text in each.assumptions)
        return Decision(PROVED, assumptions=tuple(dict.fromkeys(texts)))

    def _with_one_factor(
        self,
        chain: Chain,
        name: str,
        claim: EngineClaim,
        terms: tuple[Formula, ...],
        products: list[tuple[EngineClaim, ProductOfPowers]],
        knowledge: Knowledge,
    ) -> Verdict | None:
        """Return the refutation of a sum all of whose terms are wrong by one and the same factor."""
        ratios: list[float] = []
        mends: list[Formula] = []
        for term, (own, product) in zip(terms, products, strict=True):
            parts = self.letters.parts(product, own, knowledge)
            if parts is None or parts.slips:
                return None
            first = 1.0 if parts.has_amplitude else float(FIRST_TERMS[own.order])
            ratios.append(own.sizes()[0] * first / abs(product.number))
            mend = mended(product_of(term), parts, "factor", ratios[-1], own)
            if mend is None:
                return None
            mends.append(mend)
        if not all(same(ratio, ratios[0], 1e-3) for ratio in ratios):
            return None
        parts = self.letters.parts(products[0][1], products[0][0], knowledge)
        whole = Sum(tuple(mends))
        return parts and self._refuted(chain, name, claim, parts, "factor", ratios[0], target=whole)

    def _orders(
        self, terms: tuple[Formula, ...], name: str, claim: EngineClaim, knowledge: Knowledge
    ) -> list[tuple[EngineClaim, ProductOfPowers]]:
        """Return what each term claims and its product; nothing where one is no order, or cancels."""
        products: list[tuple[EngineClaim, ProductOfPowers]] = []
        for term in terms:
            try:
                product = self.letters.expanded(product_of(term), name, knowledge)
            except NoProductError:
                return []
            order = 0 if product.wave is None else wave_of(product.wave)[0]
            own = replace(claim, order=order)
            if order not in POWERS or order in {c.order for c, _ in products} or not any(own.sizes()):
                return []
            products.append((own, product))
        return products

    def _compared(
        self,
        chain: Chain,
        name: str,
        claim: EngineClaim,
        product: ProductOfPowers,
        knowledge: Knowledge,
        term: Formula | None = None,
    ) -> Verdict | Decision | None:
        parts = self.letters.parts(product, claim, knowledge)
        if parts is None:
            return None
        sizes = claim.sizes()
        if claim.is_rotating and product.wave is not None:
            return None
        first = Fraction(1) if parts.has_amplitude else FIRST_TERMS[claim.order]
        number = abs(product.number)
        is_amount = any(same(number, size * float(first), product.rounding) for size in sizes)
        slips = list(parts.slips)
        if not is_amount:
            slips.append("factor")
        if not slips:
            is_alone = term is None and claim.order == 1 and not index_of(name)
            is_open = is_alone and _UP_TO_SECOND.search(claim.sentence) is not None
            is_open = is_open or _is_what_half_a_balance_leaves(claim)
            other_wave = _other_wave(claim, product)
            is_open = is_open or not (other_wave or self._has_phase(chain, claim, product))
            if is_open or (term is None and self._is_against_another(chain, claim, product, knowledge)):
                return None
            return other_wave or Decision(
                PROVED,
                assumptions=(
                    self._assumption(name, claim),
                    *self._conditions(claim, parts, number / float(first)),
                ),
            )
        if len(slips) != 1 or not self._may_accuse(
            chain, knowledge, claim, parts, product, slips[0], sizes, float(first)
        ):
            return None
        return self._refuted(chain, name, claim, parts, slips[0], sizes[0] * float(first) / number, term)

    def _has_phase(self, chain: Chain, claim: EngineClaim, product: ProductOfPowers) -> bool:
        """Tell whether a formula's wave has the phase of the cranks, as far as it or the page has one."""
        if product.wave is None or claim.is_rotating:
            return True
        letter = wave_of(product.wave)[1]
        before = self.claims.section_before(chain)
        is_couple = claim.kind == COUPLE
        return any(
            fits_the_cranks(
                star, product.wave, claim.order, is_couple=is_couple, text=before, letter=letter
            )
            for star in claim.engine.stars
        )

    def _is_against_another(
        self, chain: Chain, claim: EngineClaim, product: ProductOfPowers, knowledge: Knowledge
    ) -> bool:
        """Tell whether a force above, of the same engine and another order, is counted the other way.

        All orders of one force are cos θ + λ cos 2θ - λ³/4 cos 4θ up to a common sign, where θ is counted
        from top dead centre; where it is not, another sign may be right, so nothing is refuted.
        """
        sign = _sign_of_wave(product)
        others = self.words.document.chains if sign and claim.kind == FORCE else []
        for other in others:
            head = other.sides[0].node
            is_above = other.relations and other.end <= chain.start
            if (
                not isinstance(head, Name)
                or not is_above
                or not self.sections.same_section(other.lines[0], chain.lines[0])
            ):
                continue
            of = self.claims.claim(head.name, other)
            if (
                of is None
                or (of.engine.key, of.kind) != (claim.engine.key, FORCE)
                or of.order == claim.order
            ):
                continue
            try:
                value = without_dots(other.sides[1].node)[0]
                before = _sign_of_wave(self.letters.expanded(product_of(value), head.name, knowledge))
            except NoProductError:
                continue
            if before == -sign:
                return True
        return False

    def _assumption(self, name: str, claim: EngineClaim) -> str:
        of = "rotating " if claim.is_rotating else ""
        source = f"{NOBODY}; taken from the words “{claim.words}”" if claim.words else ""
        source = source or f"{NOBODY}; by its index and its wave"
        source = f"declared as “{claim.words}”" if claim.is_declared else source
        return (
            f"{plain_letter(name)} is order {claim.order} of the whole engine's {of}{claim.kind}"
            f" ({source})"
        )

    @staticmethod
    def _conditions(claim: EngineClaim, parts: Parts, amount: float | None = None) -> Iterator[str]:
        yield from EngineResultants._star(claim, amount)
        if parts.arm:
            yield f"{plain_letter(parts.arm)} is the distance of neighbouring cylinders"
        if claim.order > 1:
            yield "the rod is long"

    def _vanishing(self, name: str, claim: EngineClaim, value: Formula, chain: Chain) -> Decision | None:
        if claim.kind == TORQUE:
            return self._vanishing_torque(name, claim, value)
        if VECTORS.search(claim.sentence):
            return self._phasor_sum(name, claim, value)
        is_part = _PART.search(_SPEED.sub("", without_masses_of_one(claim.sentence))) is not None
        if not isinstance(value, Number) or value.value or is_part:
            return None
        sizes = claim.sizes()
        if not all(sizes):
            return Decision(PROVED, assumptions=(self._assumption(name, claim), *self._star(claim, 0.0)))
        may_accuse = not claim.engine.is_boxer or self._has_other_couple(claim, chain)
        if not claim.is_inferred and not _BALANCED.search(claim.around) and may_accuse:
            reason = "; ".join((f"if {self._assumption(name, claim)}", *self._star(claim)))
            return Decision(REFUTED, f"{reason}: the {claim.kind}s of order {claim.order} do not cancel")
        return None

    def _has_other_couple(self, claim: EngineClaim, chain: Chain) -> bool:
        """Tell whether the same section has a couple of another order of the same boxer.

        Its cylinders are set off from each other then: a page that neglects this has no couple at all.
        """
        for other in self.words.document.chains:
            head = other.sides[0].node
            is_near = other.relations and self.sections.same_section(other.lines[0], chain.lines[0])
            if (
                other is chain
                or not is_near
                or not isinstance(head, Name)
                or not names(other.sides[1].node)
            ):
                continue
            of = self.claims.claim(head.name, other)
            if of is not None and (of.engine.key, of.kind) == (claim.engine.key, COUPLE):
                return of.order != claim.order
        return False

    def _vanishing_torque(self, name: str, claim: EngineClaim, value: Formula) -> Decision | None:
        """Return the decision on an order of the torque that is said to vanish: each crank has its own.

        One cylinder's inertia torque has the orders 1 to 4.
        """
        is_zero = isinstance(value, Number) and not value.value
        stars = claim.engine.stars
        if not is_zero or claim.order not in _TORQUE_ORDERS or any(s.banks or s.is_radial for s in stars):
            return None
        sizes = {replace(star, signs=()).force(claim.order) for star in stars}
        text = f"{plain_letter(name)} is order {claim.order} of the whole engine's torque ({NOBODY})"
        if sizes == {0}:
            return Decision(PROVED, assumptions=(text, *self._star(claim)))
        if 0 in sizes or _PART.search(claim.sentence) or _BALANCED.search(claim.around):
            return None
        reason = "; ".join((f"if {text}", *self._star(claim)))
        return Decision(REFUTED, f"{reason}: the torques of order {claim.order} do not cancel")

    def _phasor_sum(self, name: str, claim: EngineClaim, value: Formula) -> Decision | None:
        """Return the decision on a number for the sum of the unit phasors of an order."""
        sizes = sorted({star.force(claim.order) for star in claim.engine.stars})
        try:
            product = product_of(value)
        except NoProductError:
            return None
        number = abs(product.number)
        text = f"{plain_letter(name)} is the sum of the cranks' unit vectors of order {claim.order}"
        text = f"{text} ({NOBODY}; taken from the words “{claim.words}”)"
        if any(same(number, size, product.rounding) or number == size == 0 for size in sizes):
            return Decision(PROVED, assumptions=(text, *self._star(claim)))
        if len(sizes) != 1 or _PART.search(claim.own) or _WEIGHTED.search(claim.sentence):
            return None
        return Decision(
            REFUTED, "; ".join((f"if {text}", *self._star(claim))) + f": it is {sizes[0]:.5g}"
        )

    @staticmethod
    def _star(claim: EngineClaim, amount: float | None = None) -> Iterator[str]:
        stars = claim.engine.stars
        fitting = [s for s in stars if amount is not None and abs(claim.size(s) - amount) < _NEARLY]
        shown = fitting[:1] or (stars if len(stars) == _EITHER else stars[:1])
        what = "cylinders" if any(star.is_radial for star in shown) else "cranks"
        words = " ".join(claim.engine.words.split())
        yield f"the {what} are at {' or at '.join(s.text for s in shown)} (“{words}”)"

    def _may_accuse(
        self,
        chain: Chain,
        knowledge: Knowledge,
        claim: EngineClaim,
        parts: Parts,
        product: ProductOfPowers,
        slip: str,
        sizes: list[float],
        first: float,
    ) -> bool:
        """Tell whether the words leave no other meaning under which a formula is right."""
        is_of_other = claim.is_inferred and not self._is_of_no_other(claim, product, sizes, first)
        sentence = without_letters_explained(_SPEED.sub("", claim.sentence))
        if is_of_other or _IN_A_CASE.search(sentence):
            return False
        if slip != "factor":
            return not _OF_ANOTHER.search(sentence)
        is_part = self._is_of_part(claim, parts.letter.get("base", ""))
        if len(sizes) != 1 or is_part or not self._is_told(parts.letter.get("base", ""), knowledge):
            return False
        number, size = abs(product.number) / first, sizes[0]
        is_of_one = same(number, 1, product.rounding)
        if claim.kind == FORCE:
            return bool(size) and self._is_of_all(chain, claim, knowledge) if is_of_one else True
        if not size or (claim.engine.is_boxer and len(claim.engine.stars[0].degrees) > 2):
            return not (size or is_of_one)
        return self._is_of_pitch(claim, parts, product.rounding, number, size)

    def _is_of_part(self, claim: EngineClaim, base: str) -> bool:
        """Tell whether words make a formula that of a part or a multiple of what the cylinders do.

        Those that only say that the letter of an amplitude, `base`, is one cylinder's do not.
        """
        own = f"{claim.words} {claim.own} {claim.clause if claim.is_inferred else ''}"
        own = _ALL_OF.get(claim.engine.cylinders, _NONE).sub("", own.replace(claim.engine.words, ""))
        own = without_masses_of_one(without_letters_explained(own))
        own = _explained(base).sub(" ", own) if base else own
        own = without_balance_to_come(_SPEED.sub("", own))
        around = without_balance_to_come(claim.around)
        is_part = any(words.search(own) for words in (_PART, OF_ONE)) or _BALANCED.search(around)
        is_part = is_part or _SHARE.search(around) is not None
        return bool(is_part) or _TOTAL_MASS.search(self._text) is not None

    def _is_of_pitch(
        self, claim: EngineClaim, parts: Parts, rounding: float, number: float, size: float
    ) -> bool:
        """Tell whether a couple's number is wrong for whatever distance of cylinders its arm may be."""
        count = len(claim.engine.stars[0].degrees)
        scales = (2.0, 0.5, count - 1.0, 1 / (count - 1.0), (count - 1) / 2, 2 / (count - 1.0))
        is_scaled = any(same(number, size * scale, rounding) for scale in scales)
        is_pitch = any(not _FAR_APART.search(w) for w in self.letters.pitch_words(parts.arm))
        return not is_scaled or (is_pitch and not _FAR_APART.search(claim.around))

    def _is_of_no_other(
        self, claim: EngineClaim, product: ProductOfPowers, sizes: list[float], first: float
    ) -> bool:
        """Tell whether a formula whose order or engine no words beside it name is right of no other one.

        Where the engine's order cancels it may be another's, too.
        """
        stars = [star for each in self.claims.usual_engines for star in each.stars]
        others = [claim.size(star) for star in stars]
        number = abs(product.number) / first
        is_own = any(same(number, size, product.rounding) for size in sizes)
        is_of_other = any(size and same(number, size, product.rounding) for size in others)
        return all(sizes) and (is_own or not is_of_other)

    def _is_told(self, base: str, knowledge: Knowledge) -> bool:
        """Tell whether a letter for an amplitude is said to be one cylinder's, or there is none."""
        if not base or self.letters.is_inertia_of_one(base, knowledge):
            return True
        if OF_ONE.search(knowledge.meanings.get(base, "")):
            return True
        sign = re.compile(rf"(?<![\\A-Za-z_]){re.escape(plain_letter(base))}(?![A-Za-z])")
        places = [m.start() for m in sign.finditer(self._text)]
        return any(OF_ONE.search(self._text, max(0, place - 80), place + 80) for place in places)

    def _is_of_all(self, chain: Chain, claim: EngineClaim, knowledge: Knowledge) -> bool:
        """Tell whether one cylinder's amplitude is said to be the whole engine's.

        The words say so, or another line of the section is the whole engine's: then a formula of one
        cylinder would be told apart. Where the letter is used further on, it may be one cylinder's.
        """
        if claim.is_total:
            return True
        text = self._without_what_one_does(chain, claim)
        if OF_ONE.search(without_masses_of_one(text)) or _SUMMED.search(text):
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
        is_said = any(w.search(text) for w in (WHOLE, OF_ALL) for text in (claim.sentence, claim.around))
        return is_said or any(is_all for _, is_all in amounts)

    def _without_what_one_does(self, chain: Chain, claim: EngineClaim) -> str:
        """Return the page without the words before a whole engine's force on what one cylinder does.

        "Each cylinder gives m r ω² λ cos 2θ. The resultant of the engine is" tells the two apart, unless
        the words behind speak of the number of the cylinders: "and four of them".
        """
        start, end = self.claims.sentence_place(chain)
        own, behind = self._text[start:end], self._text[chain.end : end + _BEHIND]
        is_counted = names_count(claim.engine.cylinders, behind)
        is_told = OF_ONE.search(self._text, 0, start) is not None and OF_ONE.search(own) is None
        return self._text[start:] if is_told and OF_ALL.search(own) and not is_counted else self._text

    def _amount(
        self, chain: Chain, engine: NamedEngine, knowledge: Knowledge
    ) -> tuple[tuple[int, str], bool]:
        """Return the order and kind of another formula, and whether it is of more than one cylinder."""
        head, value = chain.sides[0].node, chain.sides[1].node
        claim = self.claims.claim(head.name, chain) if isinstance(head, Name) else None
        if claim is None or claim.engine.key != engine.key or not claim.engine.stars:
            return (0, ""), False
        sizes = claim.sizes()
        if not names(value):
            is_zero = isinstance(value, Number) and not value.value
            return (claim.order, claim.kind), is_zero and not any(sizes)
        try:
            number = abs(self.letters.expanded(product_of(value), "", knowledge).number)
        except NoProductError:
            return (0, ""), False
        firsts = (1.0, float(FIRST_TERMS[claim.order]))
        is_all = any(same(number, size * first) for size in sizes for first in firsts)
        return (claim.order, claim.kind), is_all and (claim.kind == COUPLE or not same(number, 1))

    def _refuted(
        self,
        chain: Chain,
        name: str,
        claim: EngineClaim,
        parts: Parts,
        slip: str,
        factor: float,
        term: Formula | None = None,
        target: Formula | None = None,
    ) -> Verdict | None:
        side = chain.sides[1]
        whole = without_dots(side.node)[0]
        if target is None:
            target = mended(product_of(term or whole), parts, slip, factor, claim)
        if target is None:
            return None
        if term is not None:
            target = Sum(tuple(target if each == term else each for each in terms_of(whole)))
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


def _explained(name: str) -> re.Pattern[str]:
    """Return what says that a letter is one cylinder's: $F_2$ is the force of one cylinder."""
    sign = sign_of(name)
    return re.compile(
        rf"(?<![\\A-Za-z_])\$?{sign}\$?(?![A-Za-z_])\s*(?:(?:is|being|ist|est|è|es)\s+|für\s+)?(?:the|die|la|il|le|el)\s"
        rf"[^$.;:=\n]{{0,60}}?(?:{OF_ONE.pattern})",
        re.IGNORECASE,
    )


def _other_wave(claim: EngineClaim, product: ProductOfPowers) -> Decision | None:
    """Return that a force or couple goes with the other wave, where θ is the angle of a crank.

    Two cranks at 180° give a couple with cos θ. It is sin θ only for an angle that is counted otherwise.
    """
    if product.wave is None or claim.kind not in (FORCE, COUPLE) or claim.is_rotating:
        return None
    if isinstance(product.wave.argument, Sum):
        return None  # cos(θ + 30°): its phase is counted from a crank of its own
    possible = [star.waves(claim.order, is_couple=claim.kind == COUPLE) for star in claim.engine.stars]
    if not all(possible) or any(product.wave.function in waves for waves in possible):
        return None
    (right, *_) = sorted(possible[0])
    reason = f"its size is right; counted from top dead centre of a cylinder, it goes with {right}"
    return Decision(UNDECIDED, reason)


def _sign_of_wave(product: ProductOfPowers) -> int:
    """Return the sign by which a term's cosine stands to the first order's; 0 where it has none."""
    if product.wave is None or product.wave.function != "cos" or not product.number:
        return 0
    sign = 1 if product.number > 0 else -1
    return -sign if wave_of(product.wave)[0] == _NEGATIVE_ORDER else sign


def _is_what_half_a_balance_leaves(claim: EngineClaim) -> bool:
    """Tell whether words speak of a share that is balanced: what is left of a force is another one."""
    around = without_balance_to_come(f"{claim.around} {claim.sentence}")
    return _BALANCED.search(around) is not None and _SHARE.search(around) is not None


def _is_of_another_engine(meaning: str, claim: EngineClaim) -> bool:
    """Tell whether a letter's own words name an engine, and none that the page's words claim it of."""
    own = EnginesInWords(meaning).mentions if meaning else []
    return bool(own) and not any(_may_be_same(named, claim.engine) for named in own)


def _may_be_same(one: NamedEngine, other: NamedEngine) -> bool:
    """Tell whether two names may be of one engine: a twin's pins may be told by one of them alone."""
    is_like = (one.cylinders, one.is_boxer) == (other.cylinders, other.is_boxer)
    return is_like and (one.turn == other.turn or not one.turn or not other.turn)
