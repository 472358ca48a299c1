"""Formulas of a slider-crank that say themselves what they are: λ/4 sin φ - ½ sin 2φ - λ/4 sin 3φ.

No word has to name what a series of harmonics is of. Two of these terms agree with the torque of the mass
forces of one slider-crank, whatever factor stands before them, and with nothing else that is known; the
third differs from it by one slip (a sign, a factor, a sine for a cosine, a power of the ratio, an order)
and has to be -3λ/4 sin 3φ. Then the line is refuted, by its pattern.

    all terms agree                                   None: a definition, as before
    two agree and one is wrong by one slip            refuted, with what it should be
    one agrees, two are wrong, two quantities fit     None

An angle may be counted from any quarter of a turn, and either way. What words call balanced, a rest, of a
bank or of several cylinders may have other factors, and nothing is said of it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache, cached_property
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
)
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import (
    PROVED,
    REFUTED,
    Decision,
    decide_equality,
    without_dots,
)
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.declared.role_phrases import CONVENTIONS
from symbalance.notes.checking.declared.symbol_roles import role_of
from symbalance.notes.checking.meant.meant_words import NOBODY, MeantWords
from symbalance.notes.checking.meant.pistons.crank_series import (
    HIGHEST,
    Harmonic,
    Series,
    in_powers_of_sine,
    known_series,
    turned,
)
from symbalance.notes.checking.meant.pistons.motion_words import motions_named
from symbalance.notes.checking.meant.pistons.wave_profiles import (
    RADII,
    RODS,
    Profile,
    Ratio,
    has_powers_of_sine,
    has_waves,
    profiles,
)
from symbalance.notes.checking.meant.products import ProductOfPowers, written_out
from symbalance.notes.checking.repair.fixes import add_fix
from symbalance.notes.checking.verdicts import Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading.equations import Chain, ReadNotes, Side
from symbalance.text import lazy_patterns as re

_ANOTHER = re.compile(
    r"(?<!un)balanc|counter-?weight|residu|remain|left over|compensat|(?<!un)ausgeglichen|ausgleich"
    r"|\brest(?:kraft|moment|lich|anteil|\b)|gegengewicht|釣合|つり合|釣り合|残|équilibr|contrepoids|equilibr|contrapeso"
    r"|\bV-?\d|\bV-?(?:engine|motor|twin)|V型|V形|\bbanks?\b|\bradial engine|sternmotor|星型|星形"
    r"|b[oó]xer"
    r"|opposed|水平対向"
    r"|cylinders\b|zylindern\b|(?:aller|beider|zwei|drei|vier|sechs|acht) zylinder|\w+-cylinder"
    r"|[2-9２-９二三四六八]\s?気筒"
    r"|全気筒|offset|desax|dés?ax|geschränkt|オフセット|articulated|slave rod|nebenpleuel|副連"
    r"|\brod'?s? (?:cent(?:re|er)|middle)|cent(?:re|er) of (?:gravity|mass)|mid-?point|schwerpunkt|重心"
    r"|scotch|yoke|\bcams?\b|nocken|カム|wrong|mistak|instead|falsch|誤",
    re.IGNORECASE,
)
"""Words of a sentence, a paragraph or a heading by which the terms may have other factors."""
_OF_ONE = re.compile(
    r"\b(?:of|in|for)\s+(?:one|a\s+single|each)\s+(?:piston|cylinder)(?!s)|\bone\s+(?:piston|cylinder)(?:'s|\s+gives)"
    r"|eines\s+(?:einzelnen\s+)?(?:kolbens|zylinders)|d.un\s+(?:seul\s+)?(?:piston|cylindre)"
    r"|de\s+un\s+(?:solo\s+)?(?:pist[oó]n|cilindro)|(?:1|一)\s?気筒の|単気筒",
    re.IGNORECASE,
)
"""Words by which a sentence is of one cylinder, whatever stands around it."""
_WEIGHTS = re.compile(
    r"balanc|weight|gewicht|gegen|ausgleich|(?<!crank)(?<!crank )shaft|lanchester|residu|remain"
    r"|\brest|half|hälfte|compensat|釣|つり合|バランス|残|半分|おもり|contrepoids|équilib|equilib|contrapeso|masselotte",
    re.IGNORECASE,
)
_FORCES = frozenset({"acceleration", "inertia torque"})
"""What counterweights and balance shafts take a part of: forces over a mass, and torques."""
_OF_PISTON = frozenset(
    {"displacement", "displacement from the bottom", "position", "velocity", "acceleration"}
)
_OTHER_BODY = re.compile(
    r"(?<!actual )(?<!real )(?<!finite )\brods?\b(?! (?:of|is|length|ratio)\b)"
    r"|cent(?:re|er) of|midpoint|mid-point|middle|\bpoint\b"
    r"|pleuel(?!länge)|stange(?!nverhältnis)|schwerpunkt|mitte"
    r"|punkt\b|コンロッド|連接棒|重心|bielle|biela",
    re.IGNORECASE,
)
_FROM_TOP = re.compile(
    r"top dead|upper dead|inner dead|\bTDC\b|\bIDC\b|\bOT\b|oberen? totp|上死点|\bPMH\b|\bPMS\b",
    re.IGNORECASE,
)
_NUMBERS = frozenset({1, 2, 3, 4, 6, 8, 9, 16, 32, 64})
"""Numerators and denominators of a factor that is a slip."""
_SHIFTS = (0, -1, 1, -2)
"""Powers of the ratio that may stand before a whole formula."""
_FROM_ELSEWHERE = re.compile(
    r"\b(?:from|von|vom|ab|gegen|against)\b[^.\n]{0,30}?(?:vertical|horizontal|perpendicular|senkrecht"
    r"|waagrecht|vertikal|lotrecht)|(?:水平|鉛直|垂直)[^。\n]{0,10}から",
    re.IGNORECASE,
)
_QUARTERS = 4
_FEWEST = 2
"""Terms that have to agree."""
_OF_ANGLES = {"cos": "cosine of the rod's angle", "tan": "tangent of the rod's angle"}
_OF_ROOT = {
    Fraction(1, 2): "cosine of the rod's angle", Fraction(-1, 2): "secant of the rod's angle",
}  # fmt: skip
_BY_LETTER = {
    "v": "velocity", "c": "velocity", "dot_x": "velocity", "dot_s": "velocity", "a": "acceleration",
    "ddot_x": "acceleration", "ddot_s": "acceleration",
}  # fmt: skip
"""What usual letters are of with the factor r ω or r ω² before the harmonics."""
_SPEEDS = {"velocity": 1, "acceleration": 2, "inertia force": 2}
_MOTION_OF_FORCE = {"inertia force": "acceleration"}
_STROKES = frozenset({"s", "S", "H", "h"})
"""Letters of twice the crank radius."""
_FORCE_LETTERS = frozenset({"F", "P", "K"})
_BODIES = (
    {"m": Fraction(1)}, {"M": Fraction(1)},
    {"W": Fraction(1), "g": Fraction(-1)}, {"G": Fraction(1), "g": Fraction(-1)},
)  # fmt: skip
"""What a force along the stroke has of the body that moves."""
_OVER_ROD, _OVER_CRANK = CONVENTIONS["r/l"], CONVENTIONS["l/r"]
_OMEGAS = frozenset({"omega", "Omega", "w"})


class _Term(NamedTuple):
    """One term of a series: a harmonic, the power of the ratio at it, and the number."""

    harmonic: Harmonic
    power: int
    value: Fraction


class _Match(NamedTuple):
    """How a formula's harmonics compare with one quantity's."""

    quantity: str
    quarters: int
    agreeing: tuple[_Term, ...]
    wrong: tuple[_Term, ...]
    right: tuple[_Term, ...]
    """What has to stand in the place of the wrong ones."""
    has_other_constant: bool
    shift: int = 0
    """The power of the ratio that stands before the whole formula."""

    @property
    def is_whole(self) -> bool:
        """Whether all terms agree, the constant among them."""
        return not self.wrong and not self.has_other_constant


class _Outcome(NamedTuple):
    profile: Profile
    match: _Match


@dataclass
class FormulaPatterns:
    """Judges the series of one page by what they are."""

    document: ReadNotes
    sections: Sections
    words: MeantWords

    def judge(self, chain: Chain, k: int, knowledge: Knowledge) -> Verdict | Decision | None:
        """Return the verdict on a relation whose right side is nearly a known series; None for others."""
        left, right = chain.sides[k].node, without_dots(chain.sides[k + 1].node)[0]
        if chain.relations[k].sign not in "=≈" or not has_waves(right):
            return None
        quantity, ratio = _quantity_of_root(left)
        quantity, ratio = (quantity, ratio) if quantity else _quantity_of_angle(left, knowledge)
        is_certain = ratio is not None
        if not quantity and has_waves(left):
            return None
        if not is_certain and (self.is_of_more(chain) or not (quantity or _is_series(right))):
            return None
        outcomes = list(self._outcomes(right, knowledge, chain, quantity, ratio))
        starts = self.starts_near(chain) if outcomes else frozenset[int]()
        if len(starts) == 1:
            outcomes = [each for each in outcomes if each.match.quarters in starts]
        if any(each.match.is_whole for each in outcomes):
            return _agreeing(outcomes, chain, k) if quantity else None
        least = _FEWEST + 1 if any(not each.match.wrong for each in outcomes) else 0
        outcomes = [each for each in outcomes if each.match.wrong and len(each.match.agreeing) >= least]
        outcomes = [each for each in outcomes if not each.match.quarters or len(starts) == 1]
        outcomes = [each for each in outcomes if is_certain or _is_sure(each.match, starts)]
        if len({each.match.quantity for each in outcomes}) != 1 or self._may_be_rest(outcomes[0]):
            return None
        return self._refuted(outcomes[0], chain, k, right, knowledge)

    def _outcomes(
        self, node: Formula, knowledge: Knowledge, chain: Chain, quantity: str, other: Formula | None
    ) -> Iterator[_Outcome]:
        """Yield the quantities with which a formula agrees, all of it or but for one slip."""
        head = chain.sides[0].node
        for profile in profiles(node):
            is_ratio = self._may_be_ratio(profile.ratio, knowledge, other, chain.lines[0])
            by_letter = _by_letter(head, profile, knowledge) if isinstance(head, Name) else ""
            words = self.words.sentence_before(chain) if by_letter else ""
            is_named = bool(by_letter in _BY_LETTER.values() and motions_named(words))
            by_letter = "" if is_named or _OTHER_BODY.search(words) else by_letter
            is_certain = other is not None
            has_ratio = bool(by_letter) and self._has_ratio(profile.ratio, knowledge, chain.lines[0])
            fewest = 1 if is_certain or has_ratio else _FEWEST
            has_pair, only = bool(profile.ratio.below), quantity or by_letter
            only = _MOTION_OF_FORCE.get(only, only)
            for match in _matches(profile.series, has_powers_of_sine(node), only, fewest, bool(quantity)):
                is_plain = not match.shift or is_certain or (has_pair and not quantity)
                is_enough = not match.shift or has_pair or len(match.agreeing) > _FEWEST or quantity
                if by_letter and has_ratio and not is_ratio:
                    continue
                if is_enough and (not match.wrong or (is_ratio and is_plain)):
                    yield _Outcome(profile, match)

    def starts_near(self, chain: Chain) -> frozenset[int]:
        """Return the quarter turns from which the section counts the crank angle; none if that is open.

        By the other series of the section that agree, or as words say.
        """
        if self.words.has_angle_from_bottom:
            return frozenset({_QUARTERS // 2})
        if self.words.counts_from_bottom or _FROM_ELSEWHERE.search(self.document.text):
            return frozenset()
        starts = set(range(_QUARTERS))
        for line, own in self._starts:
            if line != chain.lines[0] and self.sections.same_section(line, chain.lines[0]):
                starts &= own
        if len(starts) == 1:
            return frozenset(starts)
        return frozenset({0}) if 0 in starts and _FROM_TOP.search(self.document.text) else frozenset()

    @cached_property
    def _starts(self) -> list[tuple[int, frozenset[int]]]:
        """The lines whose series agree, each with the quarter turns from which it may count its angle."""
        starts = []
        for chain in self.document.chains:
            for k, relation in enumerate(chain.relations):
                node = without_dots(chain.sides[k + 1].node)[0]
                if relation.sign not in "=≈" or not _is_series(node) or has_waves(chain.sides[k].node):
                    continue
                outcomes = self._outcomes(node, Knowledge(), chain, "", None)
                plain = [each.match for each in outcomes if each.match.is_whole and not each.match.shift]
                if own := frozenset(match.quarters for match in plain):  # a whole λ before may be a slip
                    starts.append((chain.lines[0], own))
        return starts

    def is_of_more(self, chain: Chain) -> bool:
        """Tell whether words near speak of a rest, of several cylinders, or of another mechanism."""
        own = self.sections.sentence_leading_to(chain)
        if _OF_ONE.search(own) and not _ANOTHER.search(own):
            return False
        heading = self.sections.heading_above(chain.lines[0])
        behind = self.document.text[chain.end : chain.end + 80].split("\n\n")[0]
        before = f"{self.words.paragraph(chain)}\n{self.sections.sentence_leading_to(chain)}"
        return _ANOTHER.search(f"{heading}\n{before}{behind}") is not None

    def _may_be_rest(self, outcome: _Outcome) -> bool:
        """Tell whether a first or second order may be what a counterweight or a shaft leaves of it.

        The first order of a force of any other size or sign, the second one too where the page speaks of
        weights or shafts anywhere. Of a point within the rod the first order is larger than the others.
        """
        wrong, right = outcome.match.wrong[0], outcome.match.right[0]
        motion = {
            n for n in outcome.profile.factor if n.partition("_")[0] in RADII | RODS or n in _OMEGAS
        }
        is_motion, quantity = motion == {*outcome.profile.factor}, outcome.match.quantity
        if wrong.harmonic != right.harmonic or wrong.power != right.power:
            return False
        if wrong.harmonic.order == 1 and quantity in _OF_PISTON:  # or of the rod's middle
            return not is_motion or abs(wrong.value) > abs(right.value)
        is_of_weights = quantity in _FORCES and not is_motion and wrong.harmonic.order == 2
        return is_of_weights and _WEIGHTS.search(self.document.text) is not None

    def _may_be_ratio(self, ratio: Ratio, knowledge: Knowledge, other: Formula | None, line: int) -> bool:
        """Tell whether a letter may be r/l, or l/r where it is inverse, by what the page says."""
        if other is not None:
            return ratio.node == other
        if ratio.below:
            return True
        meaning = self._meaning_of(ratio.letter, line)
        if meaning:
            return meaning == (_OVER_CRANK if ratio.is_inverse else _OVER_ROD)
        definition = knowledge.definitions.get(ratio.letter)
        if definition is None or isinstance(definition.node, Number):
            return True
        return _is_ratio(definition.node, ratio.is_inverse)

    def _meaning_of(self, letter: str, line: int) -> str:
        """Return what a letter is declared to be, or what words call it; "" where they say nothing."""
        declared = self.words.declarations.symbols_at(line)
        if letter in declared:
            return role_of(declared[letter])
        proposal = self.words.proposals.get(letter)
        return proposal.meaning if proposal is not None and proposal.words else ""

    def _has_ratio(self, ratio: Ratio, knowledge: Knowledge, line: int) -> bool:
        """Tell whether the page says that a letter is the crank over the rod, or writes these."""
        if any(self._meaning_of(name, line) not in ("", "angular speed") for name in _OMEGAS):
            return False
        if ratio.below or self._meaning_of(ratio.letter, line):
            return True
        definition = knowledge.definitions.get(ratio.letter)
        return definition is not None and _is_ratio(definition.node, ratio.is_inverse)

    def _refuted(
        self, outcome: _Outcome, chain: Chain, k: int, right: Formula, knowledge: Knowledge
    ) -> Verdict | None:
        """Return the refutation of a series, with what its wrong term should be."""
        profile, match = outcome
        head = chain.sides[k].node
        is_force = isinstance(head, Name) and _by_letter(head, profile, knowledge) in _MOTION_OF_FORCE
        quantity = "inertia force" if is_force else match.quantity
        fixed = _with_terms(right, profile, match)
        bare = Knowledge(SymbolValue(), corrects=knowledge.corrects)
        side = chain.sides[k + 1]
        left = Side((fixed,), chain.sides[k].span)
        decision = decide_equality(fixed, right, bare)
        if decision.status != REFUTED:
            return None
        count = len(match.agreeing)
        where = (
            "",
            ", its angle counted from a quarter turn before",
            ", its angle counted from bottom dead centre",
            ", its angle counted from a quarter turn behind",
        )[match.quarters]
        ratio = plain_text(profile.ratio.node)
        means = (
            ""
            if profile.ratio.below
            else f" with {ratio} = {'l/r' if profile.ratio.is_inverse else 'r/l'}"
        )
        reason = (
            f"by its pattern it is the {quantity} of one slider-crank{means}{where}:"
            f" {count} {'terms agree' if count > 1 else 'term agrees'},"
            f" and {_written(profile, match.wrong)} should be {_written(profile, match.right)}"
        )
        decision = replace(decision, reason=reason)
        verdict = describe(self.document, chain, k, decision)

        def proves(node: Formula) -> bool:
            return decide_equality(left.node, node, bare).is_proved

        return add_fix(verdict, self.document, side, decision, replace(knowledge, corrects=True), proves)


def _is_series(node: Formula) -> bool:
    """Tell whether a formula has more than one wave, or one and its powers."""
    return has_waves(node, 2) or has_powers_of_sine(node)


def _agreeing(outcomes: list[_Outcome], chain: Chain, k: int) -> Decision | None:
    """Return the proof that a root's series agrees through the power of the ratio that is written."""
    profile, match = next(each for each in outcomes if each.match.is_whole)
    if chain.relations[k].sign != "≈":
        return None
    letter = plain_text(profile.ratio.node)
    size = "large" if profile.ratio.is_inverse else "small"
    highest = max(abs(term.power) for term in match.agreeing)
    assumptions = (f"{letter} is {size}",)
    head = chain.sides[k].node
    if isinstance(head, Call) and isinstance(head.argument, Name):
        angle = f"{plain_letter(head.argument.name)} is the rod angle ({NOBODY}; its formula says so)"
        assumptions = (angle, *assumptions)
    return Decision(PROVED, order=f"{letter}^{highest}", assumptions=assumptions)


def _is_sure(match: _Match, starts: frozenset[int]) -> bool:
    """Tell whether a term is wrong wherever the angle is counted from, for a motion by letter alone."""
    pairs = zip(match.wrong, match.right, strict=True)
    is_sign = all(wrong == right._replace(value=-right.value) for wrong, right in pairs)
    return len(match.agreeing) >= _FEWEST or not is_sign or len(starts) == 1


def _quantity_of_root(node: Formula) -> tuple[str, Formula | None]:
    """Return which function of the rod's angle √(1 - λ² sin²θ) or its inverse is, and its ratio."""
    base, exponent = node, Fraction(1)
    if isinstance(base, Quotient) and base.numerator == Number(Fraction(1)):
        base, exponent = base.denominator, -exponent
    if isinstance(base, Call) and base.function == "sqrt":
        base, exponent = base.argument, exponent / 2
    elif isinstance(base, Power) and isinstance(base.exponent, Number):
        base, exponent = base.base, exponent * base.exponent.value
    elif isinstance(base, Power) and isinstance(base.exponent, Negative | Quotient):
        base, exponent = base.base, exponent * _number(base.exponent)
    quantity = _OF_ROOT.get(exponent, "")
    for profile in profiles(base) if quantity and has_waves(base) else ():
        powers = in_powers_of_sine(profile.series)
        first, second = powers.get(Harmonic("1", 0), {}), powers.get(Harmonic("1", 2), {})
        is_root = len(powers) == 2 and len(first) == len(second) == 1
        if (
            is_root
            and [p + 2 for p in first] == [*second]
            and [-v for v in first.values()] == [*second.values()]
        ):
            return quantity, profile.ratio.node
    return "", None


def _quantity_of_angle(node: Formula, knowledge: Knowledge) -> tuple[str, Formula | None]:
    """Return which function of the rod's angle cos β is, and λ where the page says sin β = λ sin θ.

    A letter that is declared, or has another value, is no angle of a rod.
    """
    if not isinstance(node, Call) or not isinstance(node.argument, Name):
        return "", None
    quantity, name = _OF_ANGLES.get(node.function, ""), node.argument.name
    definition = knowledge.definitions.get(name)
    if definition is None:
        return ("" if name in knowledge.letters else quantity), None
    value = definition.node
    for profile in (
        profiles(value.argument) if isinstance(value, Call) and value.function == "asin" else ()
    ):
        if profile.series == {Harmonic("sin", 1): {1: Fraction(1)}} and not profile.factor:
            return quantity, profile.ratio.node
    return "", None


def _number(node: Formula) -> Fraction:
    """Return the value of -½ and the like, 0 of what has letters."""
    if isinstance(node, Negative):
        return -_number(node.operand)
    if isinstance(node, Quotient):
        below = _number(node.denominator)
        return _number(node.numerator) / below if below else Fraction(0)
    return node.value if isinstance(node, Number) else Fraction(0)


def _is_ratio(node: Formula, is_inverse: bool) -> bool:
    """Tell whether a letter's value is r/l, or l/r where it is inverse; other letters may be either."""
    if not (
        isinstance(node, Quotient)
        and isinstance(node.numerator, Name)
        and isinstance(node.denominator, Name)
    ):
        return False
    above, below = (each.name.partition("_")[0] for each in (node.numerator, node.denominator))
    if is_inverse:
        above, below = below, above
    return above not in (*RODS, *_STROKES) and below not in RADII


def _by_letter(head: Name, profile: Profile, knowledge: Knowledge) -> str:
    """Return the motion that a usual letter with the factor r ω or r ω² before its harmonics is.

    A force has the factor m r ω² besides, or W r ω²/g, perhaps as one letter: F = F_0 (cos θ + …).
    """
    plain = head.name.removesuffix("_K").removesuffix("_P").removesuffix("_p")
    is_force = plain.partition("_")[0] in _FORCE_LETTERS
    motion = "inertia force" if is_force else _BY_LETTER.get(plain, "")
    orders = {harmonic.order for harmonic in profile.series if harmonic.order}
    if not motion or orders != {1, 2}:
        return ""
    factor = dict(written_out(ProductOfPowers(1.0, profile.factor), knowledge).powers)
    radius = [n for n in factor if n.partition("_")[0] in RADII and factor[n] == 1]
    speed = [n for n in factor if n in _OMEGAS and factor[n] == _SPEEDS[motion]]
    body = {n.partition("_")[0]: power for n, power in factor.items() if n not in (*radius, *speed)}
    is_whole = body in _BODIES if is_force else not body
    return motion if len(radius) == len(speed) == 1 and is_whole else ""


@cache
def _targets(is_in_sines: bool) -> tuple[tuple[str, int, Series], ...]:
    """Return the known series with their angle counted from each quarter turn."""
    return tuple(
        (name, quarters, in_powers_of_sine(own) if is_in_sines else own)
        for name, series in known_series().items()
        for quarters in range(_QUARTERS)
        for own in [turned(series, quarters)]
    )


def _matches(
    series: Series, is_in_sines: bool, only: str, fewest: int, is_exact: bool
) -> Iterator[_Match]:
    """Yield how a series compares with the known ones, or with one alone; an exact one as it stands."""
    own = in_powers_of_sine(series) if is_in_sines else series
    for name, quarters, target in _targets(is_in_sines):
        if (only and name != only) or (is_exact and quarters):
            continue
        for shift in _SHIFTS:
            match = _compare(own, target, shift, fewest, is_exact=is_exact)
            if match is not None:
                yield match._replace(quantity=name, quarters=quarters)


def _compare(own: Series, target: Series, shift: int, fewest: int, *, is_exact: bool) -> _Match | None:
    """Return how a formula's terms compare with those of a quantity; None if by more than one slip.

    A constant may come from elsewhere: it counts where it agrees, and is not wrong; but where the other
    side says the quantity itself (`is_exact`), and no factor stands before it.
    """
    terms = {(h, p): v for h, powers in own.items() for p, v in powers.items()}
    known = {(h, p + shift): v for h, powers in target.items() for p, v in powers.items()}
    if len({p for _, p in terms}) < 2 or max(abs(p) for _, p in terms) >= HIGHEST - 1:
        return None
    factors = [value / known[key] for key, value in terms.items() if key in known]
    factors = [factor for factor in factors if factor == 1 or not is_exact]
    best: tuple[int, Fraction] = (0, Fraction(0))
    for factor in factors:
        count = sum(1 for key, value in terms.items() if key in known and value == factor * known[key])
        best = max(best, (count, factor), key=lambda each: each[0])
    factor = best[1]
    agreeing = [key for key, value in terms.items() if key in known and value == factor * known[key]]
    wrong = [key for key in terms if key not in agreeing and (key[0].order or is_exact)]
    missing = [
        (h, p)
        for h, p in known
        if (h.order or is_exact) and h in own and (h, p) not in terms and p <= max(own[h])
    ]
    if len(agreeing) < fewest or not (is_exact or any(h.order for h, _ in agreeing)):
        return None
    if fewest == _FEWEST and not is_exact and not _is_told(agreeing):
        return None

    right: list[tuple[Harmonic, int]] = []
    if wrong or missing:
        of_page = {key: factor * value for key, value in known.items()}
        own_right = _right_term(wrong[0], terms, of_page, missing, own) if len(wrong) == 1 else None
        if own_right is None:
            return None
        right = [own_right]
    return _Match(
        "", 0,
        tuple(_Term(*key, terms[key]) for key in agreeing),
        tuple(_Term(*key, terms[key]) for key in wrong),
        tuple(_Term(*key, factor * known[key]) for key in right),
        any(not h.order and (h, p) not in agreeing for h, p in terms),
        shift,
    )  # fmt: skip


def _is_told(agreeing: list[tuple[Harmonic, int]]) -> bool:
    """Tell whether terms that agree are of two powers of the ratio or of two orders, a constant aside."""
    powers, orders = {p for _, p in agreeing}, {h.order for h, _ in agreeing if h.order}
    return len(powers) > 1 or len(orders) > 1


def _right_term(
    key: tuple[Harmonic, int],
    terms: dict[tuple[Harmonic, int], Fraction],
    known: dict[tuple[Harmonic, int], Fraction],
    missing: list[tuple[Harmonic, int]],
    own: Series,
) -> tuple[Harmonic, int] | None:
    """Return the term that belongs in the place of a wrong one; None where no one slip leads there."""
    (harmonic, power), value = key, terms[key]
    if missing:
        first = (
            min(p for h, p in known if h == harmonic) if any(h == harmonic for h, _ in known) else None
        )
        is_power = len(own[harmonic]) == 1 and all(h == harmonic for h, _ in missing)
        is_power = is_power and first is not None and known[harmonic, first] == value
        return (harmonic, first) if is_power and first is not None and abs(first - power) <= 2 else None
    if key in known:
        ratio = value / known[key]
        is_slip = ratio == -1 or {ratio.numerator, ratio.denominator} <= _NUMBERS
        return key if is_slip else None
    same = [p for h, p in known if h == harmonic]
    if same and min(same) > power:  # λ cos 4θ for λ³ cos 4θ
        first = min(same)
        is_power = len(own[harmonic]) == 1 and known[harmonic, first] == value and first - power <= 2
        return (harmonic, first) if is_power else None
    others = [
        (h, p)
        for (h, p), v in known.items()
        if p == power and v == value and h not in own and h.order
        and (h.order == harmonic.order) != (h.function == harmonic.function)
    ]  # fmt: skip
    return others[0] if len(others) == 1 else None


def _factor(profile: Profile) -> list[Formula]:
    """Return the letters before all terms of a formula."""
    return [
        Power(Name(n), rational_node(e)) if e != 1 else Name(n) for n, e in sorted(profile.factor.items())
    ]


def _with_terms(node: Formula, profile: Profile, match: _Match) -> Formula:
    """Return a formula with what is right in the place of its wrong terms."""
    changes = [profile.node(*term.harmonic, term.power, term.value) for term in match.right]
    changes += [profile.node(*term.harmonic, term.power, -term.value) for term in match.wrong]
    return Sum((node, Product((*_factor(profile), Sum(tuple(changes))))))


def _written(profile: Profile, terms: tuple[_Term, ...]) -> str:
    """Return terms of a formula as text, without the factor before all of them."""
    texts = [plain_text(profile.node(*term.harmonic, term.power, term.value)) for term in terms]
    return " + ".join(texts).replace("+ -", "- ")
