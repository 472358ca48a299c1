"""Which letter of an engine's force or couple is what: a mass, a radius, a speed, a distance.

By the words beside a letter, else as is usual for it; and what of the powers is not as it should be.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from math import isclose

from symbalance.document.formula import Call, Formula, Name, Number, Product, Quotient, Sum, names
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.declared.symbol_roles import role_of
from symbalance.notes.checking.meant.engines.engine_claims import COUPLE, EngineClaim
from symbalance.notes.checking.meant.engines.order_indices import POWERS, index_of, wave_of
from symbalance.notes.checking.meant.letter_roles import LetterRoles
from symbalance.notes.checking.meant.meant_words import MeantWords
from symbalance.notes.checking.meant.products import NoProductError, ProductOfPowers, product_of
from symbalance.text import lazy_patterns as re

FIRST_TERMS = {1: Fraction(1), 2: Fraction(1), 4: Fraction(1, 4), 6: Fraction(9, 128)}
"""The leading term of the piston's acceleration by order: its power of r/l, and the number before it."""
_PITCH_WORDS = re.compile(
    r"(?:cylinder|bore)s?[\s-]+(?:spacing|pitch|distance|centres?|centers?)|\bpitch\b|\bspacing\b"
    r"|\bdistances?\b"
    r"|distance\s+apart|(?:axial\s+)?offset|zylinderabst[aä]nd\w*|stichma(?:ß|ss)|abst[aä]nd\w*"
    r"|(?:zylinder|kröpfungs)versatz\w*|décalage\s+(?:axial|entre|des)|entraxes?|interass[ei]|rozstaw\w*"
    r"|気筒間(?:隔|距離)|シリンダ(?:ー)?間隔|ピッチ|distancia\s+entre|distanza\s+tra|cilinderafstand"
    r"|apart|bore\s+centres",
    re.IGNORECASE,
)
_MASSES, _RADII, _SPEEDS, _RODS = (
    frozenset(t.split()) for t in ("m M", "r R", "omega Omega w", "l L ell")
)
_ARMS = frozenset(
    ["a", "b", "c", "d", "e", "h", "p", "s", "x", "z", "i", "k", "A", "B", "D", "H", "L", "l", "t", "u"]
)
_AMPLITUDES = frozenset(["F", "P", "S", "Q", "K", "Z", "C", "R", "X", "T", "f", "p"])
_RATIOS = frozenset({"lambda", "lam"})
_BY_MEANING = {
    "crank radius": "radius", "rod length": "rod", "angular speed": "speed",
    "reciprocating mass": "mass",
    "rotating mass": "mass", "rod ratio l/r": "inverse", "crank ratio r/l": "ratio",
}  # fmt: skip
_DEPTH = 3
"""How many definitions deep a letter is followed: P_2 = λ P_1, P_1 = m r ω²."""
_BEHIND_PITCH = re.compile(
    r"(?:[\s,(:]|\b(?:of|the|two|between|neighbou?ring|adjacent|cylinders?|bores?|cent(?:re|er)s?"
    r"|throws?|pins?|der|den|des|zweier"
    r"|benachbarter|zylindern?|kröpfungen|de|des|du|la|le|les|entre|tra|i|dei|degli|cilindri|cilindros"
    r"|cylindres?|dos|os|el|van|cilinders"
    r"|is|ist|est|è|es|vaut|vale|beträgt|equal\s+to|by|um|von)\b"
    r"|[をはがのと])*",
    re.IGNORECASE,
)
_IS = re.compile(
    r"\s*(?:is|being|denotes|be|ist|sei|bezeichnet|jest|oznacza|est|étant|es|è|は|を|\(|:|the\b)",
    re.IGNORECASE,
)


@dataclass(frozen=True, slots=True)
class Parts:
    """Which letter of a formula is what, and what of it is not as it should be."""

    letter: Mapping[str, str]
    powers: Mapping[str, Fraction]
    slips: tuple[str, ...]
    has_amplitude: bool
    """Whether a letter is the amplitude of that order itself, its coefficient included."""
    missing: Fraction
    """By how much the power of the rod's ratio has to grow."""
    angle: str = ""

    @property
    def arm(self) -> str:
        """The letter of the cylinders' distance, "" for a force."""
        return self.letter.get("arm", "")


@dataclass
class EngineLetters:
    """Tells what the letters of one page stand for in an engine's resultants."""

    words: MeantWords
    _pitches: dict[str, list[str]] = field(default_factory=dict)

    @cached_property
    def _roles(self) -> LetterRoles:
        return LetterRoles(self.words.document.text)

    def expanded(self, product: ProductOfPowers, head: str, knowledge: Knowledge) -> ProductOfPowers:
        """Return a product with the letters put in that the page has defined as products."""
        for _ in range(_DEPTH):
            product = self._expanded_once(product, head, knowledge)
        return product

    def _expanded_once(
        self, product: ProductOfPowers, head: str, knowledge: Knowledge
    ) -> ProductOfPowers:
        for name in [*product.powers]:
            definition = knowledge.definitions.get(name)
            is_size = self._role(name, self._letter_roles(knowledge), None) not in (
                "base",
                "arm",
                "other",
            )
            if definition is None or definition.numeric or is_size or not names(definition.node):
                continue
            try:
                value = product_of(definition.node)
            except NoProductError:
                continue
            if value.wave is not None or head in value.powers:
                continue
            power = product.powers[name]
            rest = {n: p for n, p in product.powers.items() if n != name}
            product = ProductOfPowers(product.number, rest, product.wave, product.rounding)
            product = product.times(value, power)
        return product

    def parts(self, product: ProductOfPowers, claim: EngineClaim, knowledge: Knowledge) -> Parts | None:
        """Return which letter is what, and what of them is wrong; None for another kind of formula."""
        powers, roles = dict(product.powers), self._letter_roles(knowledge)
        by_role: dict[str, list[str]] = {}
        for name in powers:
            by_role.setdefault(self._role(name, roles, claim), []).append(name)
        if "other" in by_role or any(len(each) > 1 for each in by_role.values()):
            return None
        letter = {role: each[0] for role, each in by_role.items()}
        power = {role: powers[name] for role, name in letter.items()}
        if claim.kind == COUPLE and "arm" not in power and power.get("rod", 0) > 0:
            letter["arm"], power["arm"] = (
                letter.pop("rod"),
                power.pop("rod"),
            )  # L is the pitch, not the rod
        multiple, angle = (0, "") if product.wave is None else wave_of(product.wave)
        is_open = product.wave is not None and not multiple
        if is_open or power.get("arm", 0) != (claim.kind == COUPLE) or not _is_amplitude(power):
            return None
        slips: list[str] = []
        of_ratio = power.get("ratio", 0) - power.get("inverse", 0) - power.get("rod", 0)
        expected = Fraction(0 if "coefficient" in power else POWERS[claim.order])
        if "base" not in power:
            extra = -power.get("rod", Fraction(0))
            if extra and "ratio" not in power and extra != expected == power.get("radius", 0) - 1:
                slips, extra, of_ratio = ["rod"], expected, expected
            wanted = {"mass": Fraction(1), "speed": Fraction(2), "radius": 1 + extra}
            slips += [role for role, e in wanted.items() if power[role] != e]
        has_amplitude = "coefficient" in power or claim.is_rotating
        if "base" in power:
            index = index_of(letter["base"])
            if index == claim.order > 1 or (claim.order > 1 and not of_ratio and index not in (1,)):
                expected, has_amplitude = Fraction(0), True  # the amplitude of that order itself
        if claim.is_rotating:
            expected = Fraction(0)
        if of_ratio != expected:
            slips.append("ratio")
        if product.wave is not None and multiple != claim.order:
            slips.append("wave")
        elif product.wave is not None and product.wave.function == "sin" and claim.is_in_phase:
            slips.append("function")
        return Parts(
            letter, dict(product.powers), tuple(slips), has_amplitude, expected - of_ratio, angle
        )

    def _letter_roles(self, knowledge: Knowledge) -> Mapping[str, str]:
        meanings = {n: p.meaning for n, p in self.words.proposals.items() if p.words}
        return {**meanings, **{n: role_of(text) for n, text in knowledge.meanings.items()}}

    def _role(self, name: str, roles: Mapping[str, str], claim: EngineClaim | None) -> str:
        stem, _, index = name.partition("_")
        meaning = roles.get(name, "")
        if self.pitch_words(name) or _PITCH_WORDS.search(meaning):
            return "arm"
        declared = next((role for words, role in _BY_MEANING.items() if meaning.startswith(words)), "")
        if declared and not (stem in _RATIOS and declared in ("radius", "rod")):  # λ: radius by length
            return declared
        is_couple = claim is not None and claim.kind == COUPLE
        if (
            claim is not None
            and claim.order > 1
            and stem in ("A", "B", "C", "a", "b", "c", "alpha", "beta")
            and index == str(claim.order)
        ):
            return "coefficient"
        usual = {"ratio": stem in _RATIOS, "mass": stem in _MASSES, "speed": stem in _SPEEDS,
                 "radius": name in _RADII, "rod": name in _RODS, "inverse": name == "n",
                 "base": stem in _AMPLITUDES and not (stem == "p" and is_couple),
                 "arm": is_couple and stem in _ARMS}  # fmt: skip
        return next((role for role, is_it in usual.items() if is_it), "other")

    def role(self, name: str, knowledge: Knowledge) -> str:
        """Return what a letter is in a force: mass, radius, speed, rod, ratio, or another."""
        return self._role(name, self._letter_roles(knowledge), None)

    def is_inertia_of_one(self, name: str, knowledge: Knowledge) -> bool:
        """Tell whether the page gives a letter as m r ω², or a power of the ratio times it."""
        roles = self._letter_roles(knowledge)
        for chain in self.words.document.chains:
            head = chain.sides[0].node
            if not isinstance(head, Name) or head.name != name:
                continue
            for side in chain.sides[1:]:
                try:
                    product = product_of(side.node)
                except NoProductError:
                    continue
                own = [self._role(n, roles, None) for n in product.powers]
                is_whole = {"mass", "radius", "speed"} <= set(own) or own == ["ratio", "base"]
                if is_whole and same(abs(product.number), 1) and product.wave is None:
                    return True
        return False

    def pitch_words(self, name: str) -> list[str]:
        """Return the words that call a letter the distance of cylinders, before or behind it."""
        if name not in self._pitches:
            self._pitches[name] = self._pitch_words(name)
        return self._pitches[name]

    def _pitch_words(self, name: str) -> list[str]:
        before = [w for w in self._roles.words_before(name) if ends_with_phrase(_PITCH_WORDS, w)]
        sign = re.escape(plain_letter(name))
        behind = re.compile(rf"(?<![\\A-Za-z_]){sign}(?![A-Za-z_])\s?\$?\s?(?P<words>[^$;.\n=]{{0,50}})")
        return before + [
            m["words"]
            for m in behind.finditer(self.words.document.text)
            if _IS.match(m["words"]) and _PITCH_WORDS.search(m["words"])
        ]


def _is_amplitude(power: Mapping[str, Fraction]) -> bool:
    """Tell whether a product has a mass, a radius and a speed, or one letter for an amplitude instead."""
    inertia = {"mass", "radius", "speed"}
    return (
        inertia <= power.keys()
        if "base" not in power
        else power["base"] == 1 and not inertia & power.keys()
    )


def mended(
    own: ProductOfPowers, parts: Parts, slip: str, ratio: float, claim: EngineClaim
) -> Formula | None:
    """Return a claim with its one slip put right, in its own letters."""
    powers, factor, wave = dict(own.powers), abs(own.number), own.wave
    if slip == "factor":
        factor *= ratio
    elif slip == "ratio":
        name = parts.letter.get("ratio") or ("lambda" if "rod" not in parts.letter else "")
        if name:
            powers[name] = powers.get(name, Fraction(0)) + parts.missing
        else:
            for role, sign in (("radius", 1), ("rod", -1)):
                letter = parts.letter[role]
                powers[letter] = powers.get(letter, Fraction(0)) + sign * parts.missing
    elif slip == "wave" and wave is not None:
        angle = Name(parts.angle)
        if isinstance(wave.argument, Sum) or " " in parts.angle:
            return None
        turned = angle if claim.order == 1 else Product((Number(Fraction(claim.order)), angle))
        wave = Call(wave.function, turned)
    elif slip == "function" and wave is not None:
        wave = Call("cos", wave.argument)
    else:
        wanted = {
            "rod": -POWERS[claim.order],
            "mass": 1,
            "speed": 2,
            "radius": 1 - parts.powers.get(parts.letter.get("rod", ""), 0),
        }
        powers[parts.letter[slip]] = Fraction(wanted[slip])
    if not factor:
        return Number(Fraction(0))
    factors: list[Formula] = [number_node(factor)] if not same(factor, 1) else []
    factors += [Name(n) if p == 1 else Name(n) ** p for n, p in powers.items() if p > 0]
    below: list[Formula] = [Name(n) if p == -1 else Name(n) ** -p for n, p in powers.items() if p < 0]
    factors += [wave] if wave is not None else []
    node: Formula = _product(factors)
    node = Quotient(node, _product(below)) if below else node
    return -node if own.number < 0 else node


def _product(factors: list[Formula]) -> Formula:
    return (
        factors[0] if len(factors) == 1 else Product(tuple(factors)) if factors else Number(Fraction(1))
    )


def number_node(value: float) -> Formula:
    """Return a number as a fraction, a root, or to four digits."""
    near = Fraction(value).limit_denominator(512)
    if isclose(near, value, rel_tol=1e-9):
        return (
            Number(near)
            if near.denominator == 1
            else Quotient(Number(Fraction(near.numerator)), Number(Fraction(near.denominator)))
        )
    square = Fraction(value * value).limit_denominator(64)
    if isclose(square, value * value, rel_tol=1e-9):
        for below in range(1, 9):
            inner = square * below * below
            if inner.denominator == 1:
                root = Call("sqrt", Number(inner))
                return root if below == 1 else Quotient(root, Number(Fraction(below)))
    places = 3 if value < 10 else 2
    return Number(Fraction(round(value, places)).limit_denominator(10**places), Fraction(1, 10**places))


def same(first: float, second: float, rounding: float = 1e-9) -> bool:
    """Tell whether two numbers agree, as printed."""
    return isclose(first, second, rel_tol=max(rounding, 1e-9))


def ends_with_phrase(pattern: re.Pattern[str], text: str) -> bool:
    """Tell whether words end with a phrase, but for a few behind it: the spacing of the cylinders."""
    last = max((m.end() for m in pattern.finditer(text)), default=None)
    return last is not None and _BEHIND_PITCH.fullmatch(text[last:]) is not None
