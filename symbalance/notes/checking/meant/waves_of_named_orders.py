"""The wave and the rod ratio of an order that words name: a second-order force goes with 2θ and with λ.

An order says two things of its formula, whatever stands before it:

    its wave turns n times as fast as the crank             sin nθ or cos nθ
    it goes with a power of the rod ratio, λ = r/l          λ^(n-1) of an even order, none of the first

A force of several cylinders, a couple with its arms and a force across the bore have them too. Higher
powers of λ, by two each, are further terms of the same order. A formula that has another wave or another
power is refuted. Where the page may count its angle otherwise, or where a letter of the formula may hold
the ratio, nothing is said.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from math import isclose

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Number,
    Power,
    Product,
    Quotient,
    names,
    walk,
)
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.notes.algebra.tree_values import NO_VALUE, TreeValues
from symbalance.notes.checking.deciding.equality import REFUTED, without_dots
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import replace_part
from symbalance.notes.checking.declared.role_phrases import CONVENTIONS
from symbalance.notes.checking.declared.symbol_roles import role_of
from symbalance.notes.checking.meant.letter_roles import stem_of
from symbalance.notes.checking.meant.meant_quantities import MeantQuantities
from symbalance.notes.checking.meant.products import NoProductError, ProductOfPowers, product_of
from symbalance.notes.checking.verdicts import Verdict
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

_ANGLES = frozenset({"theta", "vartheta", "phi", "varphi"})
"""Letters that are the crank angle where no words say what they are."""
_SPEEDS = frozenset({"omega", "Omega"})
_RADII, _RODS, _RATIOS = frozenset("rR"), frozenset({"l", "L", "ell"}), frozenset({"lambda"})
_MASSES, _WEIGHTS = frozenset("mM"), frozenset("WG")
_COUNTS = frozenset("zZN")
_ARMS = frozenset("abdehsLl") | {"ell"}
_OTHERS, _PLACES = (Fraction(3), Fraction(7)), (Fraction(0), Fraction(1), Fraction(2))
_USUAL_RATIOS = (0.15, 0.45)
"""Between these is r/l of all engines: a number that may stand for it."""
_SMALLEST_PART, _SAME = 12, 1e-9
"""Of an angle, to which the number before it is told, and how near two of these are the same."""
_OTHER_ANGLE = re.compile(
    r"(?:twice|double|doppelte\w*|zweifache\w*|2\s?倍|[二２]倍|deux\s+fois|doble|doppio)[^.。]{0,24}"
    r"(?:angle|winkel|角|ángulo|angolo)"
    r"|(?:imaginary|secondary|fictitious|virtual)\s+crank",
    re.IGNORECASE,
)
"""Words by which an angle of the page may be a multiple of the crank's."""
_OTHERWISE = re.compile(
    r"\b(?:double[ds]?|twice|half|halve[ds]?|times|derivative|rate|shafts?|imaginary|fictitious|counterweights?"
    r"|balanc(?:er|ing)|ableitung|doppel\w*|halb\w*|\w*wellen?|gegengewicht\w*|ausgleich\w*"
    r"|dérivée|derivata|derivada|arbres?|alber[oi]|árbol\w*|not|nicht|wrong|falsch|instead|statt\w*"
    r"|stroke|takt|camshaft|firing|zünd\w*|gas|coils?|windings?|circuit|spule|wicklung)\b|コイル|倍|微分|軸|ガス|誤",
    re.IGNORECASE,
)
"""Words in the sentence for another shaft, for what is no order of the crank, or for a mistake."""
WITHOUT_RATIO = re.compile(
    r"\bwithout\b|\bomit|left out|apart from|divided|normali[sz]ed|\bunits?\b|proportional"
    r"|\bper\s+unit|relative"
    r"|\bohne\b|bezogen|geteilt|\bsans\b|\bsenza\b|\bsin\s+el\b|除[いく]|無次元|比例",
    re.IGNORECASE,
)
"""Words for a formula without its ratio."""
_OFFSET = re.compile(
    r"offset|desax|désax|geschränk|schränkung|オフセット|articulat|link[- ]rod|anlenk|descentr",
    re.IGNORECASE,
)
"""Words for a mechanism whose first order has the ratio too."""
_OF_CRANK = re.compile(
    r"order|primary|secondary|ordnung|次|ordre|orden|ordine|ordem|primaire|secondaire|primari|secondari"
    r"|secundari|řád|rzęd|orde\b",
    re.IGNORECASE,
)
"""Words for an order of the crank; the first harmonic may be that of anything periodic."""


@dataclass(frozen=True, slots=True)
class OrderNamed:
    """An order that words name: its number, the words, and whether of a torque, a couple or neither."""

    number: int
    words: str
    text: str
    is_torque: bool = False
    is_couple: bool = False

    @property
    def lowest(self) -> int | None:
        """The lowest power of r/l that the order has; None where a centred piston has none."""
        if self.is_torque:
            return 1 if self.number == 1 else self.number - 2
        if self.number == 1:
            return 0
        return self.number - 1 if self.number % 2 == 0 else None


def refute_wave(
    order: OrderNamed, chain: Chain, meant: MeantQuantities, knowledge: Knowledge
) -> Verdict | None:
    """Return that a formula's wave or power of the rod ratio is not that of the order words name."""
    if _OTHERWISE.search(order.words) or not _OF_CRANK.search(order.words):
        return None
    claim = without_dots(chain.sides[1].node)[0]
    page = _Page(chain, meant)
    changed = page.with_its_wave(order, claim)
    if changed is None:
        return _refuted(page, claim, page.with_its_ratio(order, claim), order, knowledge)
    return _refuted(page, claim, changed, order, knowledge)


def _refuted(
    page: _Page,
    claim: Formula,
    changed: tuple[Formula, str] | None,
    order: OrderNamed,
    knowledge: Knowledge,
) -> Verdict | None:
    """Return the refutation of a claim by the formula that it should be, with what it should have."""
    if changed is None:
        return None
    target, what = changed
    known = Knowledge(SymbolValue(positive=names(claim) | names(target)), corrects=knowledge.corrects)
    left, right = Side((target,), page.chain.sides[0].span), page.chain.sides[1]
    decision = decide(left, right, page.chain.relations[0].sign, known)
    if decision.status != REFUTED:
        return None
    reason = f"if {order.text}: {what}"
    return page.meant.with_fix(page.chain, 0, left, replace(decision, reason=reason), known)


@dataclass(frozen=True)
class _Page:
    """The letters of the page of one relation."""

    chain: Chain
    meant: MeantQuantities

    def with_its_wave(self, order: OrderNamed, claim: Formula) -> tuple[Formula, str] | None:
        """Return a claim with the wave of its order; None where it has it, or has none of the crank."""
        waves = [p for p in walk(claim) if isinstance(p, Call) and p.function in ("sin", "cos")]
        is_power = any(
            isinstance(p, Power) and any(isinstance(q, Call) for q in walk(p.base)) for p in walk(claim)
        )
        if is_power or any(isinstance(p, Call) and p not in waves for p in walk(claim)):
            return None
        of_crank = {wave for wave in waves if self._multiple(wave.argument)}
        if len(of_crank) != 1 or any(not self._is_still(wave) for wave in waves if wave not in of_crank):
            return None
        (wave,) = of_crank
        multiple = self._multiple(wave.argument)
        is_of_size = order.is_torque and not {stem_of(n) for n in names(claim)} & _SPEEDS
        if abs(multiple) == order.number or is_of_size or self._counts_otherwise(wave):
            return None
        right = Call(wave.function, _scaled(wave.argument, Fraction(order.number) / abs(multiple)))
        times = f"{order.number} times " if order.number > 1 else ""
        return replace_part(claim, wave, right), f"order {order.number} goes with {times}the crank angle"

    def with_its_ratio(self, order: OrderNamed, claim: Formula) -> tuple[Formula, str] | None:
        """Return a claim with the power of the rod ratio that its order has; None where that is open."""
        try:
            product = product_of(claim)
        except NoProductError:
            return None
        page = self.meant.words.page
        if WITHOUT_RATIO.search(order.words) or _OFFSET.search(page):
            return None
        is_torque = (order.is_torque or order.is_couple) and not _has_arm(product)
        order = replace(order, is_torque=is_torque)
        lowest, totals = order.lowest, self._totals(product, is_torque=is_torque)
        if 0 in totals and has_ratio_as_number(claim):
            return None
        if lowest is None or not totals or any(_is_of_order(t, order, lowest) for t in totals):
            return None
        ratio = self._ratio(claim, exact=totals)
        if ratio is None:
            return None
        node, sign = ratio
        missing = (lowest - totals[0]) * sign
        power = rational_node(Fraction(abs(missing)))
        factor = node if abs(missing) == 1 else Power(node, power)
        target = Product((claim, factor)) if missing > 0 else Quotient(claim, factor)
        times = f"with the power {lowest} of r/l" if lowest else "without r/l"
        return target, f"order {order.number} goes {times}"

    def _totals(self, product: ProductOfPowers, *, is_torque: bool) -> list[int]:
        """Return the powers of r/l that a product may have, by what its letters may be; [] if open."""
        powers = dict(product.powers)
        angle = names(product.wave.argument) if product.wave is not None else frozenset[str]()
        for name in angle & powers.keys():
            if stem_of(name) not in _SPEEDS:
                return []
        ratios = {n: powers.pop(n) for n in [*powers] if n in self._ratios() or n in _RATIOS}
        radii = {n: powers.pop(n) for n in [*powers] if self._is_of("crank radius", n, _RADII)}
        speeds = [powers.pop(n) for n in [*powers] if stem_of(n) in _SPEEDS]
        rods = {
            n: powers.pop(n) for n in [*powers] if powers[n] < 0 and self._is_of("rod length", n, _RODS)
        }
        rest = [n for n in powers if not _is_harmless(n, powers[n])]
        if len(ratios) > 1 or len(radii) != 1 or len(rods) > 1 or speeds != [2] or rest:
            return []
        if any(self._holds_ratio(n) for n in powers):
            return []
        own = 2 if is_torque else 1
        by_lengths = sum(radii.values()) - own
        if sum(rods.values(), Fraction(0)) != -by_lengths:
            return []
        ((name, power),) = ratios.items() if ratios else (("", Fraction(0)),)
        sign = self._ratios().get(name, 0)
        ways = [by_lengths + power * s for s in ((sign,) if sign else (1, -1))]
        return [int(w) for w in dict.fromkeys(ways)] if all(w.denominator == 1 for w in ways) else []

    def _ratio(self, claim: Formula, exact: list[int]) -> tuple[Formula, int] | None:
        """Return a formula for the rod ratio that the page has, and 1 for r/l or -1 for l/r."""
        own = [n for n in names(claim) if n in _RATIOS or n in self._ratios()]
        known = [*own, *self._ratios()]
        if known:
            return Name(known[0]), self._ratios().get(known[0], 1)
        radius = next((n for n in names(claim) if self._is_of("crank radius", n, _RADII)), None)
        rod = next((n for n in self._letters() if self._is_of("rod length", n, _RODS)), None)
        if radius is not None and rod is not None:
            return Quotient(Name(radius), Name(rod)), 1
        lone = next((n for n in self._letters() if n in _RATIOS), None)
        return (Name(lone), 1) if lone and 0 in exact else None

    def _ratios(self) -> Mapping[str, int]:
        """Return the letters that the page says are the rod ratio, 1 for r/l and -1 for l/r."""
        found = {
            n: 1 if role_of(m) == CONVENTIONS["r/l"] else -1
            for n, m in self.meant.words.declarations.symbols_at(self.chain.lines[0]).items()
            if role_of(m) in CONVENTIONS.values()
        }
        for other in self._chains():
            for left, right in zip(other.sides, other.sides[1:], strict=False):
                match left.node, right.node:
                    case Name(name=name), Quotient(numerator=Name(name=one), denominator=Name(name=two)):
                        pair = stem_of(one), stem_of(two)
                        if pair[0] in _RADII and pair[1] in _RODS:
                            found.setdefault(name, 1)
                        elif pair[0] in _RODS and pair[1] in _RADII:
                            found.setdefault(name, -1)
        return found

    def _is_of(self, role: str, name: str, usual: Iterable[str]) -> bool:
        """Tell whether a letter has a role, by its declaration, the words or as is usual for it."""
        declared, proposed = self.meant.words.sizes(self.chain.lines[0])
        said = declared.get(name, "") or proposed.get(name, "")
        return role_of(said) == role if said else name in usual

    def _holds_ratio(self, name: str) -> bool:
        """Tell whether a line gives a letter a formula that may have the rod ratio in it."""
        return any(
            other.sides[0].node == Name(name) and any(names(side.node) for side in other.sides[1:])
            for other in self._chains()
        )

    def _multiple(self, argument: Formula) -> Fraction:
        """Return how many times the crank angle an argument has in it, 0 where it is another angle."""
        letters = names(argument)
        angles = {n for n in letters if self._is_crank_angle(n)}
        if "t" in letters and letters & _SPEEDS and len(letters & _SPEEDS) == 1:
            angles = {"t"}
        if len(angles) != 1:
            return Fraction(0)
        return _coefficient(argument, angles.pop()) or Fraction(0)

    def _is_crank_angle(self, name: str) -> bool:
        declared, proposed = self.meant.words.sizes(self.chain.lines[0])
        said = declared.get(name, "") or proposed.get(name, "")
        if said or any("crank angle" in map(role_of, each.values()) for each in (declared, proposed)):
            return role_of(said) == "crank angle"
        return name in _ANGLES

    def _is_still(self, wave: Call) -> bool:
        """Tell whether a wave is of an angle that stays: of a bank, or of a number."""
        return not names(wave.argument) & {*_ANGLES, *_SPEEDS, "t"}

    def _counts_otherwise(self, wave: Call) -> bool:
        """Tell whether an angle may be no crank angle: a line gives it a formula, or words double one."""
        declared, _ = self.meant.words.sizes(self.chain.lines[0])
        is_crank = any(role_of(declared.get(n, "")) == "crank angle" for n in names(wave.argument))
        if not is_crank and _OTHER_ANGLE.search(self.meant.words.page):
            return True
        own = [Name(n) for n in names(wave.argument) - {"t"}]
        for other in self._chains():
            nodes = [side.node for side in other.sides]
            values = [node for node in nodes if node not in own] if any(n in own for n in nodes) else []
            for node in values:
                letters = names(node)
                is_speed = letters <= {"n", "N"} or (letters <= _SPEEDS | {"t"} and _is_turned(node))
                if letters and not is_speed:
                    return True
        return False

    def _chains(self) -> Iterator[Chain]:
        return (other for other in self.meant.words.document.chains if other.start != self.chain.start)

    def _letters(self) -> list[str]:
        chains = self.meant.words.document.chains
        return sorted({n for other in chains for side in other.sides for n in names(side.node)})


def has_ratio_as_number(node: Formula) -> bool:
    """Tell whether the number before a formula may be the rod ratio: 0.25 m r ω² cos 2θ."""
    try:
        number = abs(product_of(node).number)
    except NoProductError:
        return False
    low, high = _USUAL_RATIOS
    return low <= number <= high


def _is_of_order(total: int, order: OrderNamed, lowest: int) -> bool:
    """Tell whether a power of r/l is one that an order has: its lowest, or by two each more."""
    is_exact = order.number == 1 and not order.is_torque
    return total == lowest if is_exact else total >= lowest and (total - lowest) % 2 == 0


def _has_arm(product: ProductOfPowers) -> bool:
    """Tell whether a product has the arm of a couple, a length that is no radius."""
    return any(power > 0 and stem_of(name) in _ARMS for name, power in product.powers.items())


def _is_harmless(name: str, power: Fraction) -> bool:
    """Tell whether a letter is a mass, a weight over gravity, a number of cylinders or an arm."""
    stem = stem_of(name)
    if power < 0:
        return name == "g"
    return stem in _MASSES | _WEIGHTS | _COUNTS | _ARMS


def _is_turned(node: Formula) -> bool:
    """Tell whether a formula is ω t, or with a first angle: what a crank angle is."""
    return _coefficient(node, "t") == 1


def _coefficient(node: Formula, letter: str) -> Fraction | None:
    """Return the number that a letter is multiplied by in an argument; None where it is no number.

    An angular speed counts as 1: ω t has one of t.
    """
    slopes: list[float] = []
    for other in _OTHERS:
        point = {n: Fraction(1) if n in _SPEEDS else other for n in names(node)}
        try:
            low, middle, high = (
                float(TreeValues(SymbolValue(), {**point, letter: x}).value(node).real) for x in _PLACES
            )
        except NO_VALUE:
            return None
        slopes += [middle - low, high - middle]
    slope = Fraction(slopes[0]).limit_denominator(_SMALLEST_PART)
    return slope if all(isclose(each, slope, abs_tol=_SAME) for each in slopes) else None


def _scaled(argument: Formula, factor: Fraction) -> Formula:
    """Return an argument times a number, as one writes it: 2θ of θ, θ of 2θ."""
    match argument:
        case Product(factors=(Number(value=value), *rest)):
            number, others = value * factor, tuple(rest)
        case _:
            number, others = factor, (argument,)
    if number == 1:
        return others[0] if len(others) == 1 else Product(others)
    return Product((rational_node(number), *others))
