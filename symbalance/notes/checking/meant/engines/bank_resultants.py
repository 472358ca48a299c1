"""Forces of two cylinders on one crank pin, along the line between their banks and across it.

With the crank angle θ counted from the line between the banks and A half the angle between them, order n
of both pistons' forces is

    along     2 cos A cos nA · cos nθ
    across    2 sin A sin nA · sin nθ        times one cylinder's amplitude

A formula that is one product shows by its size which of the two it is, or by its wave. One with the
size of one component and the wave of the other is refuted; so is one whose wave fits and whose factor
is off by 2 or √2, or one with a function of A missing or exchanged beside a right component of the same
letter. What the angle is counted from has to be shown: by another formula of the page that is
a component as it should be, by waves of θ + A and θ - A, or by words.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from math import cos, pi, sin, sqrt
from typing import NamedTuple

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
    names,
    walk,
)
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision, without_dots
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import substitute, with_every
from symbalance.notes.checking.meant.engines.banks_in_words import (
    AngleBetweenBanks,
    angle_in,
    direction_in,
    is_a_size,
    names_an_angle,
)
from symbalance.notes.checking.meant.engines.engine_claims import FORCE, EngineClaim
from symbalance.notes.checking.meant.engines.engine_letters import (
    FIRST_TERMS,
    Parts,
    mended,
    number_node,
    same,
)
from symbalance.notes.checking.meant.engines.engine_resultants import EngineResultants
from symbalance.notes.checking.meant.engines.order_indices import POWERS, index_of, wave_of
from symbalance.notes.checking.meant.engines.sizes_explained import (
    without_balance_to_come,
    without_masses_of_one,
)
from symbalance.notes.checking.meant.meant_words import NOBODY
from symbalance.notes.checking.meant.products import NoProductError, ProductOfPowers, product_of
from symbalance.notes.checking.repair.fixes import Repair, fix_of
from symbalance.notes.checking.verdicts import Verdict
from symbalance.notes.checking.words.engines_in_words import NamedEngine
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

_WAVES = ("cos", "sin")
_OTHER = {"cos": "sin", "sin": "cos"}
_COMPONENT = {"cos": "along the line between the banks", "sin": "across the line between the banks"}
_SAMPLES = (Fraction(3, 10), Fraction(7, 10), Fraction(11, 10))
"""Angles in radians at which a factor with a letter for the angle of the banks is compared."""
_PLACES = 9
"""To which factors are compared that come from floating-point numbers."""
_SLIPS = (2.0, 0.5, sqrt(2.0), sqrt(0.5), sqrt(3.0), sqrt(1 / 3), 4.0, 0.25)
_BISECTED = r"bisect|winkelhalbierend|二等分|bissectrice|bisectriz|bisettrice|bissetriz"
_FROM_A_BISECTOR = re.compile(_BISECTED, re.IGNORECASE)
_FROM_THE_MIDDLE = re.compile(
    rf"{_BISECTED}|symmetr|between\s+the\s+(?:banks|cylinders)"
    r"|(?:measured|counted|reckoned)\s+from\s+the\s+vertical|(?:\\pm|±)\s*\$?\s*(?:\\?[a-z]+|[0-9])",
    re.IGNORECASE,
)
_DIRECTED = re.compile(
    r"component|komponente|horizontal|vertical|transverse|across|along|\bquer|längs|sideways|水平|鉛直|垂直|成分"
    r"|composante|componente|bisect|symmetr",
    re.IGNORECASE,
)
_OF_MORE = re.compile(
    r"\bfour\b|\bsix\b|\beight\b|\bvier|\bsechs|\bacht(?:zyl)|(?<![A-Za-z])V-?\s?(?:[4-9]|1[0-9])(?![0-9])|W-?12"
    r"|[四六八4-8]\s?気筒|pairs|paare",
    re.IGNORECASE,
)
_OF_LESS = re.compile(
    r"\beach\b|\bper\s+(?:bank|cylinder|piston)|\bone\s+(?:bank|cylinder)|\bsingle|left\s+over"
    r"|remain\w*\s+(?:after|of)|residu|counter-?weight"
    r"|counterbalanc|gegengewicht|\bhal(?:f|b)(?!achs)(?!e[rns]? achs)(?!\s+ax)"
    r"|\bje\s+(?:zylinder|bank|seite)|\bje(?:der|des|dem|den)\b|eines\s+zylinders|\brest|after\s+balanc|offset|split|釣合いおもり|残",
    re.IGNORECASE,
)
_FROM_ELSEWHERE = re.compile(
    r"(?:from|ab|von)\s+(?:the\s+|der\s+)?(?:axis\s+of\s+|achse\s+)?(?:the\s+|des\s+)?"
    r"(?:cylinder|left|right|first|ersten|linken|rechten|zylinders?)"
    r"|(?:to|from|against)\s+the\s+horizontal|gegen\s+die\s+(?:waag|horizont)|zur\s+(?:waag|horizont)",
    re.IGNORECASE,
)
"""Words by which the crank's angle is counted from one bank, or that of the banks from another line."""
_RESULTANT = re.compile(
    r"resultant|resultier|résultante|resultante|risultante|合力|\bsum\b|summe", re.IGNORECASE
)
_ALONE = re.compile(
    r"\b(?:left|right|first|second|front|rear)\s+cylinder|\bdifferen|\btotal\s+(?:\w+\s+)?mass|gesamtmasse|linke[rn]?\s+zyl"
    r"|together|combined|altogether|\ball\b|zusammen|insgesamt|ensemble|insieme|en conjunto|合計|両"
    r"|[mM](?:_\w+)?\s?/\s?2"
    r"|mass\w*\s+(?:of|der|des|delle?)\s+(?:both|beide|the\s+two|deux|due)|m[aá]s+\w*\s+total\w*|masse\s+totale"
    r"|rotating\s+mass|rotierend\w*\s+mass|\bpercent|%|\bfraction|\banteil",
    re.IGNORECASE,
)
"""Words for one of the two cylinders, or for other masses."""
_RIGHT = 90
_DEGREES = (
    r"(?<![0-9.,])(?P<{}>45|50|60|65|72|75|80|90|120)"
    r"\s?(?:°|º|&deg;|\^\s*\{{?\s*\\circ\s*\}}?|[\s-]?deg|\s?Grad|度)"
)
_BANKS = r"(?:(?<![A-Za-z])V(?![A-Za-z])|\bvee\b|\bbanks?\b|V[形型]|Gabel|Bankwinkel|バンク)"
_ANGLE = re.compile(
    rf"{_DEGREES.format('a')}[^.=。\n]{{0,20}}?{_BANKS}|{_BANKS}[^.=。\n]{{0,30}}?{_DEGREES.format('b')}"
    rf"|\\ang\{{(?P<c>45|60|72|75|90|120)\}}[^.=。\n]{{0,20}}?{_BANKS}"
    rf"|^\W{{0,4}}(?:\\item)?\W{{0,3}}{_DEGREES.format('e')}\W{{0,3}}:|^\W*(?:the\s+)?\W{{0,2}}{_DEGREES.format('f')}\W{{1,3}}(?:engine|motor|twin)"
    rf"|(?P<letter>[α-ωΑ-Ω]|\\[a-z]+)\s*\$?\s*=\s*\$?\s*{_DEGREES.format('d')}",
    re.IGNORECASE,
)
_DIGITS = re.compile(r"[0-9]|[({]?I{1,2}[)}]?(?![A-Za-z])")
"""The order in a letter's index: X1 and X2, F_y^{(2)}."""
_ORDER_LETTERS = frozenset({"n", "k", "h", "nu", "m", "j"})
_CRANK_ANGLES = frozenset({"theta", "phi", "varphi", "t"})


class _Component(NamedTuple):
    """A force of two banks as printed: its order, its wave, its factor over one cylinder's amplitude."""

    order: int
    wave: Call
    factors: tuple[float, ...]
    bank: str
    """The letter of an angle of the banks, "" where the factor is a number."""
    parts: Parts
    product: ProductOfPowers
    rounding: float


class _Said(NamedTuple):
    """What words say of a force of two banks: its order, direction and angle, and whether it is whole."""

    order: int
    direction: str
    """The function of the crank angle in that direction; "" for a force of the same size in all."""
    angle: AngleBetweenBanks
    degrees: int
    words: str
    may_refute: bool


def component_factor(function: str, order: int, half: float) -> float:
    """Return what both pistons give along ("cos") or across ("sin"), over one cylinder's amplitude.

    >>> round(component_factor("sin", 2, pi / 4), 6)
    1.414214
    """
    f = cos if function == "cos" else sin
    return 2 * f(half) * f(order * half)


@dataclass
class BankResultants:
    """Judges the forces of two cylinders on one pin on one page."""

    resultants: EngineResultants
    _components: dict[int, list[_Component]] = field(default_factory=dict)

    @property
    def _text(self) -> str:
        return self.resultants.words.document.text

    def judge(self, chain: Chain, k: int, knowledge: Knowledge) -> Verdict | Decision | None:
        """Return the verdict on a component of two banks' forces; None for other relations."""
        head = chain.sides[0].node
        if k or not isinstance(head, Name) or chain.relations[0].sign not in "=≈":
            return None
        claims = self.resultants.claims
        if head.name in knowledge.letters or not self._is_of_banks(chain, knowledge):
            return None
        if _FROM_ELSEWHERE.search(claims.section(chain)):
            return None
        if (by_words := self._by_words(chain, knowledge)) is not None:
            return by_words
        own = next(self._resolved(chain.sides[1], knowledge), None)
        if own is None:
            return None
        return (self._by_letter if own.bank else self._by_number)(chain, own, knowledge)

    def _is_of_banks(self, chain: Chain, knowledge: Knowledge) -> bool:
        """Tell whether the page speaks of banks, or has both components of an angle between them."""
        is_named = self.resultants.claims.engines.has_banks(0, len(self._text))
        if is_named or (_FROM_A_BISECTOR.search(self._text) and names_an_angle(self._text)):
            return True
        right = {
            (each.bank, each.wave.function) for each in self._others(chain, knowledge) if _is_right(each)
        }
        return any((bank, _OTHER[function]) in right for bank, function in right)

    def _by_words(self, chain: Chain, knowledge: Knowledge) -> Verdict | Decision | None:
        """Return the verdict by words that name order, direction and the angle between the banks."""
        said = self._said(chain, knowledge)
        node = without_dots(chain.sides[1].node)[0]
        if said is None or not names(node):
            return None
        bank = said.angle.letter
        rest, of_bank = _split(node, bank)
        try:
            product = self.resultants.letters.expanded(product_of(rest), "", knowledge)
            factors = [_at(of_bank, bank, a) * abs(product.number) for a in _SAMPLES[: 3 if bank else 1]]
        except NoProductError:
            return None
        claim = EngineClaim(NamedEngine(0, "", 2), said.order, FORCE, "", "", "", "")
        parts = self.resultants.letters.parts(product, claim, knowledge)
        is_of_bank = bool(of_bank) or not bank
        is_other_wave = product.wave is not None and bank in names(product.wave)
        if parts is None or "base" in parts.letter or not is_of_bank or (bank and is_other_wave):
            return None
        if product.wave is None and said.direction and not is_a_size(said.words):
            return None
        return self._weighed(chain, said, parts, product, factors)

    def _weighed(
        self, chain: Chain, said: _Said, parts: Parts, product: ProductOfPowers, factors: list[float]
    ) -> Verdict | Decision | None:
        """Return the verdict on a force of two banks whose order, direction and angle are known."""
        first = 1.0 if parts.has_amplitude else float(FIRST_TERMS[said.order])
        angles = _SAMPLES if said.angle.letter else (Fraction(1),)
        halves = [said.angle.half * float(angle) for angle in angles]
        usual = [abs(component_factor(said.direction or "cos", said.order, half)) for half in halves]
        is_size = all(
            same(abs(f) / first, u, product.rounding) for f, u in zip(factors, usual, strict=True)
        )
        is_wave = product.wave is None or product.wave.function == said.direction
        if is_size and is_wave and not parts.slips and any(usual):
            return Decision(PROVED, assumptions=(*self._words_taken(chain, said),))
        if not any(usual) or not said.may_refute:
            return None
        return self._otherwise(chain, said, parts, product)

    def _said(self, chain: Chain, knowledge: Knowledge) -> _Said | None:
        """Return what words say of a force of two banks; None where they leave anything open."""
        claims, name = self.resultants.claims, chain.sides[0].node
        orders = claims.orders_before(chain)
        sentence = claims.sentence(chain)
        heading = claims.sections.heading_above(chain.lines[0])
        section = claims.section(chain)
        if len(orders) != 1 or not isinstance(name, Name):
            return None
        (order,) = orders
        before, above = claims.words_before(chain)
        if self._stands_behind_another(chain):
            return None  # F_y = …, F_x = …: the direction in words is the first one's
        words = before if direction_in(before) else f"{above} {before}"
        letters = names(chain.sides[1].node)
        angle = angle_in(section, letters)
        number = 0 if angle is not None else self._angle_given(chain, knowledge)
        number = number or (0 if angle is not None else self._angle_in_words(chain, letters))
        if (angle is None and not number) or index_of(name.name) not in (0, order):
            return None
        direction = direction_in(words)
        is_round = not angle and number == _RIGHT and order == 1 and not direction
        is_round = is_round and _RESULTANT.search(words) is not None
        if not direction and not is_round:
            return None
        is_middle = is_round or self._is_from_the_middle(chain, section, number, knowledge)
        if not is_middle:
            return None
        own = without_balance_to_come(without_masses_of_one(f"{heading} {words} {sentence}"))
        is_part = any(p.search(own) for p in (_OF_MORE, _OF_LESS, _ALONE))
        angle = angle or AngleBetweenBanks("", number * pi / 360)
        return _Said(order, direction, angle, number, " ".join(words.split()), not is_part)

    def _stands_behind_another(self, chain: Chain) -> bool:
        """Tell whether a formula stands right behind another one, with no word between."""
        above = self.resultants.claims.sections.chain_before(chain.start)
        between = "" if above is None else self._text[above.end : chain.start]
        return above is not None and re.search(r"[^\W\d_]", re.sub(r"\\[A-Za-z]+", "", between)) is None

    def _angle_in_words(self, chain: Chain, letters: frozenset[str]) -> int:
        """Return the degrees between the banks that the words near a formula name; 0 for none."""
        wave = Call("cos", Name("theta"))
        waves = [p for p in walk(chain.sides[1].node) if isinstance(p, Call) and names(p)]
        wave = waves[0] if waves else wave
        return self._angle(chain, wave) if letters else 0

    def _words_taken(self, chain: Chain, said: _Said) -> Iterator[str]:
        name = chain.sides[0].node
        letter = plain_letter(name.name) if isinstance(name, Name) else ""
        where = _COMPONENT.get(said.direction, "as a whole")
        source = f"{NOBODY}; taken from the words “{said.words}”"
        yield f"{letter} is order {said.order} of two cylinders' force {where} ({source})"
        if said.angle.letter:
            share = "half " if said.angle.half == 1 else ""
            yield f"{plain_letter(said.angle.letter)} is {share}the angle between the banks"
        else:
            yield f"the banks are {said.degrees}° apart, two cylinders on one pin"
        yield "the crank angle is counted from the line between the banks"
        if said.order > 1:
            yield "the rod is long"

    def _otherwise(
        self, chain: Chain, said: _Said, parts: Parts, product: ProductOfPowers
    ) -> Verdict | None:
        """Return the refutation of a force that is another than its words leave, with the right one."""
        letter, side = parts.letter, chain.sides[1]
        if not {"mass", "radius", "speed"} <= letter.keys():
            return None
        mass, radius, speed = (Name(letter[role]) for role in ("mass", "radius", "speed"))
        factors: list[Formula] = [mass, radius, speed**2]
        if said.order > 1:
            if "rod" in letter and "ratio" not in letter:
                factors.append(radius / Name(letter["rod"]))
            else:
                factors.append(Name(letter.get("ratio", "lambda")))
        function = said.direction or "cos"
        size = component_factor(function, said.order, said.angle.half)
        if said.angle.letter:
            factors = [Number(Fraction(2)), *factors, *_bank_factors(function, said.order, said.angle)]
        elif not same(abs(size), 1):
            factors = [number_node(abs(size)), *factors]
        if product.wave is not None:
            angle = next(iter(sorted(names(product.wave.argument))), "theta")
            if isinstance(product.wave.argument, Sum) or len(names(product.wave.argument)) != 1:
                return None
            turned = Name(angle) if said.order == 1 else said.order * Name(angle)
            factors.append(Call(function, turned))
        target = Product(tuple(factors))
        known = Knowledge(SymbolValue(positive=frozenset(names(target))), corrects=True)
        decision = decide(Side((target,), chain.sides[0].span), side, chain.relations[0].sign, known)
        if decision.status != REFUTED:
            return None
        reason = "if " + "; ".join(self._words_taken(chain, said))
        document = self.resultants.words.document
        verdict = describe(document, chain, 0, Decision(REFUTED, reason, witness=decision.witness))
        repair = Repair("force of two banks", target, ((side.node, target),), 1.0)
        return replace(verdict, fix=fix_of(repair, document, side))

    def _by_letter(
        self, chain: Chain, own: _Component, knowledge: Knowledge
    ) -> Verdict | Decision | None:
        """Return the verdict by another component of the page that is as it should be."""
        for half in (1.0, 0.5):
            scales = {
                scale
                for other in self._others(chain, knowledge)
                if other.bank == own.bank and (scale := _scale(other, other.wave.function, half))
            }
            if len(scales) != 1:
                continue
            (usual,) = scales
            share = "half " if half == 1 else ""
            text = f"{plain_letter(own.bank)} is {share}the angle between the banks"
            verdict = self._compared(chain, own, half, usual, text)
            return verdict or self._by_sister(chain, own, half, usual, text, knowledge)
        return None

    def _by_number(
        self, chain: Chain, own: _Component, knowledge: Knowledge
    ) -> Verdict | Decision | None:
        """Return the verdict by the angle between the banks that words near a formula name."""
        claims = self.resultants.claims
        sentence, section = claims.sentence(chain), claims.section(chain)
        heading = claims.sections.heading_above(chain.lines[0])
        if _OF_MORE.search(f"{heading} {sentence}") or _OF_LESS.search(f"{sentence} {heading}"):
            return None
        angle = self._angle_given(chain, knowledge) or self._angle(chain, own.wave)
        if not angle or not self._is_from_the_middle(chain, section, angle, knowledge):
            return None
        is_directed = _DIRECTED.search(sentence) is not None or self._is_of_rule(chain, own, knowledge)
        return self._at_angle(chain, own, angle, is_directed=is_directed)

    def _is_of_rule(self, chain: Chain, own: _Component, knowledge: Knowledge) -> bool:
        """Tell whether a letter has a right component for any angle above: Y_1 where Y_n has one."""
        head = chain.sides[0].node
        return isinstance(head, Name) and any(
            isinstance(other.sides[0].node, Name)
            and _stem(other.sides[0].node.name) == _stem(head.name)
            and any(
                each.bank and each.wave.function == own.wave.function and _is_right(each)
                for each in self._resolved(other.sides[1], knowledge)
            )
            for other in self.resultants.words.document.chains
            if other.relations and other.start < chain.start
        )

    def _at_angle(
        self, chain: Chain, own: _Component, angle: int, *, is_directed: bool
    ) -> Verdict | Decision | None:
        """Return the verdict on a component whose banks are some degrees apart."""
        text = f"the banks are {angle}° apart, two cylinders on one pin"
        half = angle * pi / 360
        own = own._replace(factors=own.factors[:1])
        function = own.wave.function
        expected, other = (
            round(component_factor(f, own.order, half), _PLACES) for f in (function, _OTHER[function])
        )
        factor = own.factors[0]
        if same(factor, abs(expected), own.rounding):
            return self._proved(chain, own, text) if expected else None
        if same(factor, abs(other), own.rounding):
            is_open = same(factor, 1, own.rounding) and not is_directed
            return None if is_open else self._refuted(chain, own, "function", 1.0, text)
        is_usual = any(same(factor, n, own.rounding) for n in (1, 2))
        is_open = not expected or (is_usual and not is_directed)
        rounding = max(own.rounding, 1e-3)
        is_slip = not is_open and any(same(factor, abs(expected) * slip, rounding) for slip in _SLIPS)
        return self._refuted(chain, own, "factor", abs(expected) / factor, text) if is_slip else None

    def _compared(
        self, chain: Chain, own: _Component, half: float, usual: float, text: str
    ) -> Verdict | Decision | None:
        """Return the verdict on a component whose factor has the letter of the banks' angle."""
        scale = _scale(own, own.wave.function, half)
        if scale and same(scale, usual):
            return self._proved(chain, own, text)
        other = _scale(own, _OTHER[own.wave.function], half)
        if other and same(other, usual):
            return self._refuted(chain, own, "function", 1.0, text)
        claims = self.resultants.claims
        words = f"{claims.sentence(chain)} {claims.sections.heading_above(chain.lines[0])}"
        is_slip = scale and usual == 1 and any(same(scale, s) for s in (2, 0.5))
        if is_slip and not _OF_LESS.search(words) and not _OF_MORE.search(words):
            return self._refuted(chain, own, "factor", usual / scale, text)
        return None

    def _by_sister(
        self, chain: Chain, own: _Component, half: float, usual: float, text: str, knowledge: Knowledge
    ) -> Verdict | None:
        """Return the refutation of a component with a wrong function of the angle between the banks.

        Of a higher order 2 sin A cos 2A sin 2θ comes from no sum or difference of two pistons' forces in
        any direction, nor does 2 sin²A sin 2θ, with the factor of the first order; other wrong functions
        may be one, and are refuted beside a right component only.
        """
        wrong = [
            place
            for place, factors in enumerate(_wrong_factors(own, half))
            if all(same(f, usual * w) for f, w in zip(own.factors, factors, strict=True))
        ]
        if not wrong or _scale(own, own.wave.function, half):
            return None
        is_of_nothing = own.order > 1 and usual == 1 and not {*wrong} - _OF_NOTHING
        if not is_of_nothing and not self._has_sister(chain, own, half, usual, knowledge):
            return None
        return self._refuted(chain, own, "bank", half, text)

    def _has_sister(
        self, chain: Chain, own: _Component, half: float, usual: float, knowledge: Knowledge
    ) -> bool:
        """Tell whether the same letter with another index is a component in the same direction.

        X1 stands beside a right X2, so that X1 is no mere sum of forces along the cylinders.
        """
        head = chain.sides[0].node
        stem = _DIGITS.sub("", head.name) if isinstance(head, Name) else ""
        return any(
            isinstance(other.sides[0].node, Name)
            and other.sides[0].node.name != (head.name if isinstance(head, Name) else "")
            and _DIGITS.sub("", other.sides[0].node.name) == stem
            and any(
                each.bank == own.bank
                and each.order != own.order
                and each.wave.function == own.wave.function
                and same(_scale(each, each.wave.function, half), usual)
                for side in other.sides[1:]
                for each in self._resolved(side, knowledge)
            )
            for other in self.resultants.words.document.chains
            if other is not chain
        )

    def _others(self, chain: Chain, knowledge: Knowledge) -> Iterator[_Component]:
        """Yield the components that the page's other formulas are, by any of their sides."""
        document = self.resultants.words.document
        for number, other in enumerate(document.chains):
            if other is chain:
                continue
            if number not in self._components:
                sides = other.sides if isinstance(other.sides[0].node, Name) else ()
                self._components[number] = [c for s in sides[1:] for c in self._resolved(s, knowledge)]
            yield from self._components[number]

    def _resolved(self, side: Side, knowledge: Knowledge) -> Iterator[_Component]:
        """Yield a formula as a component of two banks' forces, if it is one product of that kind."""
        node = _of_second_order(without_dots(side.node)[0])
        calls = [
            p for p in walk(node) if isinstance(p, Call) and p.function in _WAVES and names(p.argument)
        ]
        letters = sorted({n for c in calls for n in names(c.argument)})
        if not calls:
            return
        for bank in ("", *letters):
            rest, of_bank = _split(node, bank)
            try:
                product = self.resultants.letters.expanded(product_of(rest), "", knowledge)
            except NoProductError:
                continue
            order = 0 if product.wave is None else wave_of(product.wave)[0]
            if product.wave is None or order not in POWERS or isinstance(product.wave.argument, Sum):
                continue
            if bank and (not of_bank or bank in names(product.wave)):
                continue
            claim = EngineClaim(NamedEngine(0, "", 2), order, FORCE, "", "", "", "")
            parts = self.resultants.letters.parts(product, claim, knowledge)
            if parts is None or parts.slips:
                continue
            first = 1.0 if parts.has_amplitude else float(FIRST_TERMS[order])
            try:
                factors = tuple(_at(of_bank, bank, angle) * product.number / first for angle in _SAMPLES)
            except NoProductError:
                continue
            factors = factors if bank else (abs(factors[0]),)
            yield _Component(order, product.wave, factors, bank, parts, product, product.rounding)
            return

    def _angle_given(self, chain: Chain, knowledge: Knowledge) -> int:
        """Return the angle between the banks where a line gives it, or its half, a number."""
        angles: set[int] = set()
        for other in self._others(chain, knowledge):
            given = knowledge.definitions.get(other.bank)
            if given is None or names(given.node):
                continue
            try:
                degrees = product_of(given.node).number * 180 / pi
            except NoProductError:
                continue
            halves = (half for half in (1.0, 0.5) if _scale(other, other.wave.function, half))
            angles |= {round(2 * half * degrees) for half in halves}
        return angles.pop() if len(angles) == 1 else 0

    def _angle(self, chain: Chain, wave: Call) -> int:
        """Return the one angle between two banks that the nearest words name, 0 for none or several."""
        claims = self.resultants.claims
        before = self._text[max(0, chain.start - 200) : chain.start]
        scopes = (
            claims.sentence(chain), claims.sections.heading_above(chain.lines[0]), before,
            claims.section(chain), self._text.lstrip().partition("\n")[0],
        )  # fmt: skip
        turning = names(wave) | _CRANK_ANGLES
        for words in scopes:
            angles = set()
            for match in _ANGLE.finditer(words):
                letter = (match["letter"] or "").removeprefix("\\")
                is_crank = letter in turning or any(plain_letter(n) == letter for n in turning)
                if not is_crank:
                    angles |= {int(match[group]) for group in "abcdef" if match[group]}
            if angles:
                return angles.pop() if len(angles) == 1 else 0
        return 0

    def _is_from_the_middle(self, chain: Chain, section: str, angle: int, knowledge: Knowledge) -> bool:
        """Tell whether the crank angle is counted from the line between the banks."""
        if _FROM_THE_MIDDLE.search(section):
            return True
        if _FROM_A_BISECTOR.search(self._text) and not _FROM_ELSEWHERE.search(self._text):
            return True
        for other in self._others(chain, knowledge):
            if other.bank and any(_scale(other, other.wave.function, half) for half in (1.0, 0.5)):
                return True
        near = self.resultants.claims.sections.same_section
        halves = set()
        for each in self.resultants.words.document.chains:
            for side in each.sides if near(each.lines[0], chain.lines[0]) else ():
                halves |= {round(s, 6) for s in _shifts(side.node)}
        sizes = [angle * pi / 360 * n for n in (1, 2)]
        return any({round(s, 6), round(-s, 6)} <= halves for s in sizes)

    def _proved(self, chain: Chain, own: _Component, text: str) -> Decision:
        return Decision(PROVED, assumptions=(*self._assumptions(chain, own, text),))

    def _assumptions(self, chain: Chain, own: _Component, text: str, function: str = "") -> Iterator[str]:
        name = chain.sides[0].node
        letter = plain_letter(name.name) if isinstance(name, Name) else ""
        where = _COMPONENT[function or own.wave.function]
        yield f"{letter} is order {own.order} of two cylinders' force {where} ({NOBODY}; by its formula)"
        yield text
        yield "the crank angle is counted from the line between the banks"
        if own.order > 1:
            yield "the rod is long"

    def _refuted(
        self, chain: Chain, own: _Component, slip: str, ratio: float, text: str
    ) -> Verdict | None:
        """Return the refutation of a component, with its wave or its factor put right."""
        side = chain.sides[1]
        node = without_dots(side.node)[0]
        function = own.wave.function
        if slip == "function":
            function = _OTHER[function]
            target = with_every(node, own.wave, Call(function, own.wave.argument))
            kind = f"{function} for {own.wave.function}"
        elif slip == "bank":
            target, kind = _with_bank_factors(node, own, ratio), "factor of the angle between the banks"
        elif own.bank:
            target, kind = Product((Number(Fraction(ratio).limit_denominator(8)), node)), "factor"
        else:
            claim = EngineClaim(NamedEngine(0, "", 2), own.order, FORCE, "", "", "", "")
            mend = mended(product_of(node), own.parts, "factor", ratio, claim)
            if mend is None:
                return None
            target, kind = mend, "factor"
        known = Knowledge(SymbolValue(positive=frozenset(names(node))), corrects=True)
        decision = decide(Side((target,), chain.sides[0].span), side, chain.relations[0].sign, known)
        if decision.status != REFUTED:
            return None
        reason = "if " + "; ".join(self._assumptions(chain, own, text, function))
        document = self.resultants.words.document
        verdict = describe(document, chain, 0, Decision(REFUTED, reason, witness=decision.witness))
        repair = Repair(kind, target, ((side.node, target),), 1.0)
        return replace(verdict, fix=fix_of(repair, document, side))


def _stem(name: str) -> str:
    """Return a letter without its order: X of X_1 and X^II, F_y of F_y,2."""
    return _DIGITS.sub("", name).rstrip("_, nk")


def _of_second_order(node: Formula) -> Formula:
    """Return a formula that is given for any order n as that of order 2, others as they are."""
    waves = [part for part in walk(node) if isinstance(part, Call) and part.function in _WAVES]
    turning = frozenset[str]().union(*(names(wave.argument) for wave in waves))
    orders = sorted(turning & _ORDER_LETTERS)
    is_general = len(orders) == 1 and len(turning) > 1
    return substitute(node, orders[0], Number(Fraction(2))) if is_general else node


def _is_right(own: _Component) -> bool:
    """Tell whether a component is that of its wave, for the angle of the banks or for half of it."""
    return any(_scale(own, own.wave.function, half) == 1 for half in (1.0, 0.5))


def _scale(own: _Component, function: str, half: float) -> float:
    """Return how many times a component a factor is, at all sampled angles; 0 where it is none."""
    sizes = [component_factor(function, own.order, half * float(angle)) for angle in _SAMPLES]
    if not own.bank or not all(sizes):
        return 0.0
    ratios = [factor / size for factor, size in zip(own.factors, sizes, strict=True)]
    return round(ratios[0], _PLACES) if all(same(each, ratios[0]) for each in ratios) else 0.0


_OF_NOTHING = frozenset({2, 4, 5})
"""Places among the wrong factors of sin A cos 2A, sin²A, sin²2A: of a higher order no sum has them."""


def _wrong_factors(own: _Component, half: float) -> list[tuple[float, ...]]:
    """Return the factors with one of the two functions of the angle left out, or another in its place.

    Of a higher order also with both functions of one angle, as the first order has them.
    """
    f = cos if own.wave.function == "cos" else sin
    g = sin if own.wave.function == "cos" else cos
    n, angles = own.order, [half * float(angle) for angle in _SAMPLES]
    wrong = [
        tuple(2 * f(a) for a in angles),
        tuple(2 * f(n * a) for a in angles),
        tuple(2 * f(a) * g(n * a) for a in angles),
        tuple(2 * g(a) * f(n * a) for a in angles),
    ]
    squares = [tuple(2 * f(a) ** 2 for a in angles), tuple(2 * f(n * a) ** 2 for a in angles)]
    return wrong if n == 1 else wrong + squares


def _with_bank_factors(node: Formula, own: _Component, half: float) -> Formula:
    """Return a component with the functions of the angle between the banks that it should have."""
    rest, _ = _split(node, own.bank)
    factors = _bank_factors(own.wave.function, own.order, AngleBetweenBanks(own.bank, half))
    parts = rest.factors if isinstance(rest, Product) else (rest,)
    others = tuple(part for part in parts if part != Number(Fraction(1)))
    return Product((*others[:-1], *factors, *others[-1:]))


def _bank_factors(function: str, order: int, angle: AngleBetweenBanks) -> tuple[Formula, ...]:
    """Return the functions of the angle between the banks that a component has."""
    letter = Name(angle.letter)

    def of(multiple: Fraction) -> Formula:
        if multiple == 1:
            return Call(function, letter)
        whole = Product((Number(multiple), letter)) if multiple > 1 else letter / 2
        return Call(function, whole)

    first = Fraction(angle.half)
    return (of(first) ** Fraction(2),) if order == 1 else (of(first), of(first * order))


def _split(node: Formula, bank: str) -> tuple[Formula, list[Formula]]:
    """Return a product without its factors of one letter's sine and cosine, and these."""
    if not bank:
        return node, []
    of_bank: list[Formula] = []

    def without(part: Formula) -> Formula:
        base = part.base if isinstance(part, Power) else part
        if isinstance(base, Call) and base.function in _WAVES and names(base.argument) == {bank}:
            of_bank.append(part)
            return Number(Fraction(1))
        if isinstance(part, Sum) and names(part) == {bank}:
            of_bank.append(part)
            return Number(Fraction(1))
        match part:
            case Product(factors=factors):
                return Product(tuple(without(factor) for factor in factors))
            case Quotient(numerator=above, denominator=below):
                return Quotient(without(above), below)
            case Negative(operand=operand):
                return Negative(without(operand))
        return part

    return without(node), of_bank


def _at(of_bank: list[Formula], bank: str, angle: Fraction) -> float:
    """Return the product of factors at one angle between the banks."""
    value = 1.0
    for part in of_bank:
        value *= product_of(substitute(part, bank, Number(angle))).number
    return value


def _shifts(node: Formula) -> Iterator[float]:
    """Yield δ of each cos(nθ + δ) and sin(nθ + δ) of a formula."""
    for part in walk(node):
        if (
            not isinstance(part, Call)
            or part.function not in _WAVES
            or not isinstance(part.argument, Sum)
        ):
            continue
        fixed = [term for term in part.argument.terms if not names(term)]
        if len(fixed) == 1 and len(part.argument.terms) == 2:
            try:
                yield product_of(fixed[0]).number
            except NoProductError:
                continue
