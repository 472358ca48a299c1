"""Formulas judged by the one beside them: F_1 = m r ω² cos θ and F_2 = λ m r ω² sin 2θ cannot both be.

No words have to name an engine. Two formulas of one letter with two subscripts show by their form what
they are, and the first says how the second one counts:

    two orders of a piston's force       the second has the ratio of the crank to the rod once more, and
                                         the same function of twice the angle; K = m r ω² is put in
    two components of a turning force    where one goes with the cosine, the other goes with the sine
    a harmonic of several cylinders      a multiple of the one in the series of one cylinder above
    the sums at the two dead centres     where F_1 + F_2 is at the top, F_1 - F_2 is at the bottom

A second order that is several times as large may be of several cylinders, and one with no ratio
at all may be of a shaft: such a number is left alone where the page speaks of any. Which convention the
ratio follows has to be shown by the page.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from math import isclose
from typing import NamedTuple

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Negative,
    Number,
    Product,
    Quotient,
    Sum,
    children,
    names,
    with_children,
)
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision, without_dots
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.declared.role_phrases import CONVENTIONS
from symbalance.notes.checking.meant.engines.order_indices import wave_of
from symbalance.notes.checking.meant.meant_words import MeantWords
from symbalance.notes.checking.meant.named_orders import SPEAKS_OF_MORE
from symbalance.notes.checking.meant.products import (
    NoProductError,
    ProductOfPowers,
    product_of,
    terms_of,
    written_out,
)
from symbalance.notes.checking.repair.fixes import Repair, fix_of
from symbalance.notes.checking.verdicts import Verdict
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

NEAR, BESIDE = 900, 320
"""Characters between the formulas of two orders at most, and between those of two components."""
_OVER_ROD, _OVER_CRANK = CONVENTIONS["r/l"], CONVENTIONS["l/r"]
_FEWEST_HARMONICS = 2
_OTHER_FUNCTION = {"cos": "sin", "sin": "cos"}
_SPEEDS, _RADII, _RODS = (
    frozenset({"omega", "Omega", "w"}),
    frozenset({"r", "R"}),
    frozenset({"l", "L", "ell"}),
)
_FORCES = frozenset({"F", "P", "K", "Q", "Z"})
_RATIOS = frozenset({"lambda", "lam", "rho", "varepsilon", "epsilon", "mu", "n", "kappa", "q"})
_ORDERS = {
    "1": 1, "I": 1, "p": 1, "P": 1, "pri": 1, "prim": 1, "'": 1,
    "2": 2, "II": 2, "s": 2, "S": 2, "sec": 2, "''": 2,
}  # fmt: skip
_PARTLY = re.compile(
    r"\bhal(?:f|ves?)\b|hälfte|halbe|moitié|mitad|metà|半分|\beach\b|\bje(?:de[rs]?)?\b|quarter|viertel|imaginary"
    r"|gedacht|仮想|lanchester|balance\s+shaft|ausgleichswelle|バランス|counter-?rotat|gegenläufig",
    re.IGNORECASE,
)
_SIDEWAYS = re.compile(
    r"(?:_|\A)(?:h|H|hor|horizontal|side|quer|q|lat|perp|across|t|transverse)\Z|\AH(?:_|\Z)|\\perp",
    re.IGNORECASE,
)
_FIRST_AXIS, _SECOND_AXIS = (
    re.compile(r"_[xX](?:[,_ ]|\Z)|[,_ ][xX]\Z|\AX(?:_|\Z)"),
    re.compile(r"_[yY](?:[,_ ]|\Z)|[,_ ][yY]\Z|\AY(?:_|\Z)"),
)
_UPRIGHT = re.compile(
    r"(?:_|\A)(?:v|V|ver|vert|vertical|up|lon|par|along|l)\Z|\AV(?:_|\Z)", re.IGNORECASE
)
_ACROSS = re.compile(
    r"across|sideways|transverse|perpendicular|at\s+right\s+angles|horizontal\w*|\bquer|senkrecht\s+dazu|waagrecht\w*"
    r"|水平|直角(?:な|の)?方向|transversal\w*|perpendiculaire|orizzontal\w*|fore\s+and\s+aft",
    re.IGNORECASE,
)
_ALONG = re.compile(
    r"\balong\b|in\s+the\s+(?:direction|line)\s+of|vertical\w*|längs|in\s+(?:zylinder)?richtung|lotrecht|鉛直|垂直"
    r"|シリンダ\w{0,4}方向|verticale?|up\s+and\s+down",
    re.IGNORECASE,
)
_TURNS = re.compile(
    r"rotat|revolv|constant\s+(?:length|size|magnitude)|turns?\b|umlauf|dreht|konstant\w*\s+(?:länge|größe|betrag)|回転"
    r"|一定|tourn|gira|counter-?weight|gegengewicht|balance|ausgleich|contrepoids|contrappes|contrapes|radial|stern"
    r"|星[形型]|おもり|hammer",
    re.IGNORECASE,
)
"""Words for a force that turns with the crank, or for the weight that makes one."""
_INCLINED = re.compile(
    r"inclin|geneigt|tilted|schräg|\bbank|\bV-|\bvee\b|V-?twin|gabel|傾|V型|V形|45\s*(?:°|\^|deg|\\deg)",
    re.IGNORECASE,
)
_TOP = re.compile(r"_(?:TDC|OT|top|PMH|PMS|u)\Z|_(?:max)\Z")
_BOTTOM = re.compile(r"_(?:BDC|UT|bottom|bot|PMB|PMI)\Z")


class _Ratio(NamedTuple):
    """The ratio of a second order as it should be, and whether the formula in hand has its inverse."""

    node: Formula
    is_inverted: bool = False
    is_told: bool = False
    """Whether the page shows which of the two ratios it is."""
    is_squared: bool = False
    is_missing: bool = False
    """Whether the formula in hand has its square, or does not have it."""


class _Shared(NamedTuple):
    """A formula as a product, without its factors 1 - k; the letters of these."""

    product: ProductOfPowers
    complements: tuple[str, ...]


class _Pair(NamedTuple):
    """A formula above that belongs to one in hand, and that formula as a product."""

    chain: Chain
    name: str
    product: ProductOfPowers
    complements: tuple[str, ...]
    node: Formula


@dataclass
class FormulasBeside:
    """Judges formulas of one page by those beside them."""

    words: MeantWords
    sections: Sections

    def judge(self, chain: Chain, k: int, knowledge: Knowledge) -> Verdict | None:
        """Return the refutation of a formula that the one beside it excludes; None for others."""
        head = chain.sides[0].node
        if k or not isinstance(head, Name) or chain.relations[0].sign not in "=≈":
            return None
        value = without_dots(chain.sides[1].node)[0]
        if knowledge.meanings.get(head.name) or not names(value) or head.name in names(value):
            return None
        if _BOTTOM.search(head.name):
            return self._at_bottom(chain, head.name, value)
        own = _product(value)
        if own is None:
            return None
        of_order = None if own.complements else self._second_order(chain, own.product, knowledge)
        of_order = of_order or self._component(chain, head.name, own)
        return of_order or self._harmonic(chain, head.name, value, own)

    def _above(self, chain: Chain, reach: int) -> Iterator[_Pair]:
        """Yield the formulas above that are products, the nearest first."""
        for other in reversed(self.sections.in_order):
            if other.end > chain.start or not other.relations:
                continue
            if chain.start - other.end > reach:
                return
            head = other.sides[0].node
            if not isinstance(head, Name) or not self.sections.same_section(
                other.lines[0], chain.lines[0]
            ):
                continue
            nodes = (without_dots(side.node)[0] for side in other.sides[1:])
            products = ((node, own) for node in nodes if (own := _product(node)) is not None)
            for node, own in products:
                if own.product.powers:
                    yield _Pair(other, head.name, *own, node)
                    break

    def _second_order(
        self, chain: Chain, product: ProductOfPowers, knowledge: Knowledge
    ) -> Verdict | None:
        """Return the refutation of a second order that does not go with the first one; or None."""
        name = _name_of(chain)
        if _order_of(name, product) != 2:
            return None
        second = written_out(product, knowledge)
        text = self.words.document.text
        for pair in self._above(chain, NEAR):
            first = written_out(pair.product, knowledge)
            is_first = _stem(pair.name) == _stem(name) and _order_of(pair.name, first) == 1
            if not is_first or pair.complements or not pair.product.powers:
                continue
            ratio = self._ratio(_quotient(second, first), chain)
            has_speed = _has_speed(first) and _has_speed(second, with_crank=False)
            if ratio is None or not first.number or not _is_same_angle(first.wave, second.wave):
                return None
            is_force = _stem(name) in _FORCES and ratio.is_told and first.wave is not None
            if not (has_speed or is_force):  # of a piston's way the second order is λ/4
                return None
            near = text[max(0, pair.chain.start - NEAR // 2) : chain.end + 60]
            is_of_one = isclose(abs(first.number), 1) and not _PARTLY.search(near)
            is_of_one &= not _INCLINED.search(near)
            is_alone = is_of_one and ratio.is_told and not SPEAKS_OF_MORE.search(self.words.page)
            kind = _slip_of_order(ratio, first, second, is_of_one=is_of_one, is_alone=is_alone)
            if not kind:
                return None
            target = ratio.node * pair.node
            if first.wave is not None:
                twice = Product((Number(Fraction(2)), first.wave.argument))
                target = _with_wave(target, first.wave, Call(first.wave.function, twice))
            beside = f"the second order beside {plain_letter(pair.name)} of line {pair.chain.lines[0]}"
            return self._refuted(chain, target, kind, f"if {plain_letter(name)} is {beside}")
        return None

    def _ratio(self, powers: dict[str, Fraction], chain: Chain) -> _Ratio | None:
        """Return the ratio of the crank to the rod that a second order has beside the first; or None.

        One without any lacks that which the page defines, λ = r/l.
        """
        if not powers:
            return self._ratio_of_page(chain)
        largest = max(powers.values())
        letters = {power / abs(largest): name for name, power in powers.items()}
        if len(powers) == 2 and letters.keys() == {Fraction(1), Fraction(-1)} and largest in (1, 2):
            above, below = letters[Fraction(1)], letters[Fraction(-1)]
            if _stem(above) in _RODS and _stem(below) in _RADII:
                return _Ratio(Quotient(Name(below), Name(above)), is_inverted=True, is_told=True)
            is_usual, is_squared = _stem(above) in _RADII and _stem(below) in _RODS, largest == 2
            node: Formula = Quotient(Name(above), Name(below))
            return _Ratio(node, is_told=True, is_squared=is_squared) if is_usual else None
        if len(powers) != 1:
            return None
        ((name, power),) = powers.items()
        if abs(power) not in (1, 2) or _stem(name) not in _RATIOS:
            return None
        role = self._role_of(name, chain)
        is_told = role in (_OVER_ROD, _OVER_CRANK)
        is_over_crank = role == _OVER_CRANK or (not is_told and power == -1)
        node = Quotient(Number(Fraction(1)), Name(name)) if is_over_crank else Name(name)
        is_inverted = (power > 0) == is_over_crank
        return _Ratio(node, is_inverted=is_inverted, is_told=is_told, is_squared=abs(power) == 2)

    def _role_of(self, name: str, chain: Chain) -> str:
        """Return which ratio words, or a formula, say that a letter is; "" for none."""
        declared, proposed = self.words.sizes(chain.lines[0])
        proposal = self.words.proposals.get(name)
        is_guess = name not in declared and proposal is not None and not proposal.words
        by_words = "" if is_guess else {**proposed, **declared}.get(name, "")
        return by_words or self._ratio_by_formula(name)

    def _ratio_of_page(self, chain: Chain) -> _Ratio | None:
        """Return the one ratio of crank and rod that a line above defines, λ of λ = r/l; or None."""
        heads = {
            other.sides[0].node.name
            for other in self.sections.in_order
            if other.relations and other.end <= chain.start and isinstance(other.sides[0].node, Name)
        }
        told = {name: self._ratio_by_formula(name) for name in heads if _stem(name) in _RATIOS}
        told = {name: role for name, role in told.items() if role}
        if len(told) != 1:
            return None
        ((name, role),) = told.items()
        is_over_crank = role == _OVER_CRANK
        node: Formula = Quotient(Number(Fraction(1)), Name(name)) if is_over_crank else Name(name)
        return _Ratio(node, is_told=True, is_missing=True)

    def _ratio_by_formula(self, name: str) -> str:
        """Return what a letter is by a line that gives it as a quotient of crank and rod; "" for none."""
        for chain in self.sections.chains_of(Name(name)):
            value = chain.sides[1].node
            if (
                isinstance(value, Quotient)
                and isinstance(value.numerator, Name)
                and isinstance(value.denominator, Name)
            ):
                above, below = _stem(value.numerator.name), _stem(value.denominator.name)
                if above in _RADII and below in _RODS:
                    return _OVER_ROD
                if above in _RODS and below in _RADII:
                    return _OVER_CRANK
        return ""

    def _component(self, chain: Chain, name: str, own: _Shared) -> Verdict | None:
        """Return the refutation of a component across the stroke in phase with that along it; or None."""
        product = own.product
        if product.wave is None:
            return None
        text = self.words.document.text
        for pair in self._above(chain, BESIDE):
            first = pair.product
            if first.wave is None or not self._are_across(pair, chain, name):
                continue
            near = text[max(0, pair.chain.start - BESIDE) : chain.end + BESIDE // 2]
            near = f"{self.sections.heading_above(chain.lines[0])} {near}"
            is_same_size = isclose(abs(first.number), abs(product.number), rel_tol=1e-9)
            is_same_wave = first.wave == product.wave and wave_of(product.wave)[0] > 0
            powers = _quotient(product, first)
            is_share = powers == dict.fromkeys(pair.complements, Fraction(1)) and not own.complements
            is_share = is_share or (own.complements == pair.complements and not powers)
            if not is_same_wave or not _TURNS.search(near) or _INCLINED.search(near):
                return None
            if not (is_same_size and is_share) or first.wave.function != "cos":
                return None
            other = Call(_OTHER_FUNCTION[product.wave.function], product.wave.argument)
            value = without_dots(chain.sides[1].node)[0]
            target = _with_wave(value, product.wave, other)
            both = f"{plain_letter(name)} and {plain_letter(pair.name)} of line {pair.chain.lines[0]}"
            reason = f"if {both} are the components of a force that turns: one goes with the sine"
            return self._refuted(chain, target, "sin for cos", reason)
        return None

    def _harmonic(self, chain: Chain, name: str, value: Formula, own: _Shared) -> Verdict | None:
        """Return the refutation of a multiple of a series' harmonic with the other function; or None."""
        wave = own.product.wave
        order, angle = (0, "") if wave is None else wave_of(wave)
        if wave is None or own.complements or str(order) != _index(name):
            return None
        for other in reversed(self.sections.in_order):
            head = other.sides[0].node
            if other.end > chain.start or not isinstance(head, Name) or head.name != _stem(name):
                continue
            terms = [_product(term) for term in terms_of(without_dots(other.sides[-1].node)[0])]
            products = [each.product for each in terms if each is not None]
            if len(products) != len(terms) or len(terms) < _FEWEST_HARMONICS:
                continue
            waves = [each.wave for each in products if each.wave is not None]
            if len(waves) != len(terms) or len({each.function for each in waves}) != 1:
                return None
            same = [each for each in products if each.wave and wave_of(each.wave) == (order, angle)]
            if len(same) != 1 or waves[0].function == wave.function or _quotient(own.product, same[0]):
                return None
            number = own.product.number / same[0].number
            near = self.words.document.text[max(0, chain.start - BESIDE) : chain.end]
            if number < 1 or not isclose(number, round(number), rel_tol=1e-9) or _INCLINED.search(near):
                return None
            target = _with_wave(value, wave, Call(waves[0].function, wave.argument))
            reason = (
                f"if {plain_letter(name)} is {round(number)} times the harmonic of line {other.lines[0]}"
            )
            return self._refuted(chain, target, f"{waves[0].function} for {wave.function}", reason)
        return None

    def _are_across(self, pair: _Pair, chain: Chain, name: str) -> bool:
        """Tell whether a formula above is a component along a line and this one that across it."""
        if _FIRST_AXIS.search(pair.name) and _SECOND_AXIS.search(name):
            return not _SIDEWAYS.search(pair.name)
        if _UPRIGHT.search(pair.name) and _SIDEWAYS.search(name):
            return True
        words = self.words.before(chain)
        above = self.words.before(pair.chain)
        return bool(_ACROSS.search(words) and _ALONG.search(above) and not _ALONG.search(words))

    def _at_bottom(self, chain: Chain, name: str, value: Formula) -> Verdict | None:
        """Return the refutation of a sum at the bottom of two orders that add up at the top; or None."""
        pair = _two_letters(value)
        if pair is None or {_ORDERS.get(_index(n), 0) for n in pair} != {1, 2}:
            return None
        first, second = sorted(pair, key=lambda n: _ORDERS.get(_index(n), 0))
        if pair[first] != pair[second]:
            return None
        tops = (c for c in self.sections.in_order if c.relations and c.end <= chain.start)
        is_sum_at_top = any(
            isinstance(c.sides[0].node, Name)
            and _TOP.search(c.sides[0].node.name)
            and (own := _two_letters(c.sides[1].node)) is not None
            and own.keys() == pair.keys()
            and own[first] == own[second]
            for c in tops
        )
        if not is_sum_at_top:
            return None
        lead, other = (
            (Name(first), Negative(Name(second)))
            if pair[first] > 0
            else (Negative(Name(first)), Name(second))
        )
        reason = "the first order changes its sign from one dead centre to the other, the second does not"
        return self._refuted(chain, Sum((lead, other)), "sign", reason)

    def _refuted(self, chain: Chain, target: Formula, kind: str, reason: str) -> Verdict | None:
        side = chain.sides[1]
        value = Sum((target, Negative(without_dots(side.node)[0])))
        known = Knowledge(SymbolValue(positive=frozenset(names(value))), corrects=True)
        left = Side((target,), chain.sides[0].span)
        decision = decide(left, side, chain.relations[0].sign, known)
        if decision.status != REFUTED:
            return None
        decision = Decision(REFUTED, reason, witness=decision.witness)
        verdict = describe(self.words.document, chain, 0, decision)
        repair = Repair(kind, target, ((side.node, target),), 1.0)
        return replace(verdict, fix=fix_of(repair, self.words.document, side))


def _quotient(product: ProductOfPowers, first: ProductOfPowers) -> dict[str, Fraction]:
    """Return the powers of the letters by which one product differs from another."""
    every = sorted({*product.powers, *first.powers})
    zero = Fraction(0)
    gaps = {n: product.powers.get(n, zero) - first.powers.get(n, zero) for n in every}
    return {name: gap for name, gap in gaps.items() if gap}


def _name_of(chain: Chain) -> str:
    head = chain.sides[0].node
    return head.name if isinstance(head, Name) else ""


def _stem(name: str) -> str:
    return name.partition("_")[0].rstrip("'0123456789")


def _index(name: str) -> str:
    plain = name.rpartition("_")[2] if "_" in name else name[len(_stem(name)) :]
    return plain.split(",")[0].strip()


def _order_of(name: str, product: ProductOfPowers) -> int:
    """Return the order of a formula, by its letter's subscript; by its wave where that says another."""
    by_index = _ORDERS.get(_index(name), 0)
    if by_index and product.wave is not None and not wave_of(product.wave)[0]:
        return 0
    return by_index


def _has_speed(product: ProductOfPowers, *, with_crank: bool = True) -> bool:
    """Tell whether a product has a speed of rotation squared, and a length that may be a crank's."""
    speeds = [p for name, p in product.powers.items() if _stem(name) in _SPEEDS]
    has_crank = any(_stem(name) in _RADII and p >= 1 for name, p in product.powers.items())
    return speeds == [Fraction(2)] and (has_crank or not with_crank)


def _is_same_angle(first: Call | None, second: Call | None) -> bool:
    """Tell whether two formulas have no waves, or the first a cosine of the angle of the other's wave."""
    if first is None or second is None:
        return first is second
    (order, angle), (_, other) = wave_of(first), wave_of(second)
    return first.function == "cos" and order == 1 and angle == other != ""


def _slip_of_order(
    ratio: _Ratio,
    first: ProductOfPowers,
    second: ProductOfPowers,
    *,
    is_of_one: bool,
    is_alone: bool,
) -> str:
    """Return the one slip of a second order beside the first, "" for none or for several.

    `is_alone` says that the page speaks of one cylinder only. 2 cos θ for cos 2θ is one slip.
    """
    number, one, other = second.number / first.number, first.wave, second.wave
    has_other_order = other is not None and wave_of(other)[0] != 2
    has_two_before = has_other_order and isclose(number, 2, rel_tol=1e-9)
    slips = {
        "rod ratio inverted": ratio.is_inverted and not ratio.is_squared,
        "exponent": ratio.is_squared,
        "rod ratio missing": ratio.is_missing,
        "order": has_other_order,
        "function": one is not None and other is not None and one.function != other.function,
        "factor": not isclose(number, 1, rel_tol=1e-9) and not has_two_before,
    }
    kinds = [kind for kind, has_slip in slips.items() if has_slip]
    is_factor = _is_of_path_or_speed(number) or (is_alone and _is_small_whole(number))
    may_be_right = {
        "rod ratio inverted": not ratio.is_told,
        "exponent": not ratio.is_told or ratio.is_inverted,
        "rod ratio missing": not is_alone or one is None,
        "factor": not (is_of_one and is_factor),
    }
    return kinds[0] if len(kinds) == 1 and not may_be_right.get(kinds[0]) else ""


def _is_small_whole(number: float) -> bool:
    """Tell whether a factor is one that several cylinders give: 2 or 4."""
    return any(isclose(number, size, rel_tol=1e-9) for size in (2, 4))


def _is_of_path_or_speed(number: float) -> bool:
    """Tell whether a second order is smaller by what that of the path is, or of the velocity."""
    return any(isclose(number, size, rel_tol=1e-9) for size in (0.25, 0.5))


def _with_wave(node: Formula, wave: Call, other: Call) -> Formula:
    """Return a product with another wave in the place of its own."""
    if isinstance(node, Call) and node == wave:
        return other
    parts = children(node)
    return with_children(node, tuple(_with_wave(part, wave, other) for part in parts)) if parts else node


def _product(node: Formula) -> _Shared | None:
    """Return a formula as a product, its factors 1 - k apart; None for a sum of another kind."""
    factors = node.factors if isinstance(node, Product) else (node,)
    complements = [(factor, name) for factor in factors if (name := _complement(factor))]
    rest = tuple(factor for factor in factors if factor not in [each for each, _ in complements])
    try:
        return _Shared(product_of(Product(rest)), tuple(name for _, name in complements))
    except NoProductError:
        return None


def _complement(node: Formula) -> str:
    """Return k of 1 - k, "" for another formula."""
    terms = node.terms if isinstance(node, Sum) else ()
    one, others = Number(Fraction(1)), [t.operand for t in terms if isinstance(t, Negative)]
    is_plain = len(terms) == 2 and one in terms and len(others) == 1
    other = others[0] if is_plain else None
    return other.name if isinstance(other, Name) else ""


def _two_letters(node: Formula) -> dict[str, int] | None:
    """Return the signs of the two letters that a formula adds up; None for another one."""
    if isinstance(node, Negative) and isinstance(node.operand, Sum):
        inner = _two_letters(node.operand)
        return None if inner is None else {name: -sign for name, sign in inner.items()}
    if not isinstance(node, Sum) or len(node.terms) != 2:
        return None
    signs: dict[str, int] = {}
    for term in node.terms:
        bare = term.operand if isinstance(term, Negative) else term
        if not isinstance(bare, Name):
            return None
        signs[bare.name] = -1 if isinstance(term, Negative) else 1
    return signs if len(signs) == 2 else None
