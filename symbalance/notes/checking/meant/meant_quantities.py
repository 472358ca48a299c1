"""Letters that mean a known quantity though nobody declared them: a ≈ r ω² (cos θ + λ cos 2θ).

The first formula of such a letter is a definition, and true of any letter. Where it is one of the
slider-crank's quantities, or where the words around name one, it says more, and is judged by that:

    it agrees, exactly or to the order written        conditional on what the letter is taken to be
    it differs by one slip, and the words name it     refuted, with what the letter is taken to be
    anything else                                     a definition, as before

One slip is one sign within, one exponent, one sine for a cosine, n for 1/n, another multiple of the angle
or another number, all terms there: a formula that lacks a term, the first order alone, a sum over
cylinders or a force in the other direction may be meant as it stands.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import NamedTuple

from symbalance.budgets import Budget, OverBudgetError, run_within
from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Name,
    Negative,
    Number,
    PlusMinus,
    Product,
    Quotient,
    Sum,
    names,
    walk,
)
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.letters_behind import letters_behind, names_behind
from symbalance.notes.algebra.tree_values import NO_VALUE, TreeValues
from symbalance.notes.algebra.values import random_point
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision, without_dots
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.declared.engines import Sources
from symbalance.notes.checking.declared.geometry import Geometry, two
from symbalance.notes.checking.declared.role_phrases import CONVENTIONS
from symbalance.notes.checking.declared.symbol_roles import FROM_MIDDLE, FROM_PIN, FROM_TOP, role_of
from symbalance.notes.checking.declared.symbols import meaning_of
from symbalance.notes.checking.meant.meant_words import (
    NOBODY,
    TORQUE,
    USUAL_END,
    MeantWords,
    Named,
    letters_text,
)
from symbalance.notes.checking.repair.fixes import add_fix, is_proved_as_far
from symbalance.notes.checking.units.dimensions import Dimension, Dimensions, unit_of, unit_text
from symbalance.notes.checking.units.unit_by_noun import unit_asked_for
from symbalance.notes.checking.verdicts import DEFINITION, Verdict
from symbalance.notes.checking.words.places_in_words import dead_centre_named
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

LONG, POINTS, NEAR = 1000, 4, 0.02
"""How much longer the rod is at the points at which numbers are compared, and how near they come."""
SEARCH, SHARE = Budget(8), 0.8
"""What it may take alone, and its part of a budget around it: a definition stays one without."""
FROM_BOTTOM = "displacement from bottom dead centre"
_USUAL_UNITS = {
    **dict.fromkeys("FKPNRQ", "N"), **dict.fromkeys("MTC", "N m"), "v": "m/s", "a": "m/s^2",
    "sigma": "Pa", "tau": "Pa",
}  # fmt: skip
"""The units of what usual letters stand for."""
_USUAL_SIZES = {
    "m": "kg", **dict.fromkeys("rRlabh", "m"), "J": "kg m^2", "F": "N", "omega": "1/s", "Omega": "1/s",
    **dict.fromkeys(("theta", "phi", "varphi", "alpha", "psi", "lambda"), "1"),
}  # fmt: skip
"""The units of letters that nobody explains, beside an angular speed and a radius or inertia."""
_DISPLACEMENTS = (FROM_TOP, FROM_PIN, FROM_MIDDLE, FROM_BOTTOM)
_EITHER_SIGN = ("piston velocity", "piston acceleration", "inertia force", FROM_MIDDLE, TORQUE)
"""Quantities that have the other sign where the other direction is the positive one."""
_USUAL_MOTIONS = {"v": "piston velocity", "a": "piston acceleration"}
"""What letters mean beside a displacement, on any page."""
_PEAK = re.compile(r"(?:_max|_peak|_top)$|^hat_")
_MOTION_WORDS = (
    ("piston velocity", re.compile(
        r"piston (?:speed|velocity)|(?:speed|velocity) of the piston|Kolbengeschwindigkeit"
        r"|Geschwindigkeit des Kolbens|ピストンの?速度|ピストンの?最高速度", re.IGNORECASE)),
    ("piston acceleration", re.compile(
        r"piston(?:'s)? acceleration|acceleration of the piston|Kolbenbeschleunigung"
        r"|Beschleunigung des Kolbens|ピストンの?加速度", re.IGNORECASE)),
)  # fmt: skip
"""Words of a paragraph by which v_max is the largest velocity of the piston."""
_RECIPROCATING = re.compile(r"[mM]_(?:o|os[zc]|rec|recip|hin|alt)")
"""Letters of a mass whose subscript says that it reciprocates."""
ONE_SLIP = re.compile(
    r"sign|(?:sin|cos|tan) for (?:sin|cos|tan)|exponent|order|number misprinted .*"
    r"|factor -?[0-9/]+|rod ratio (?:inverted|of the other convention) .*|\S+ missing"
)
"""The kinds of a change that leaves all terms and only puts one thing in them right."""


OF_RATIO = re.compile(rf" is the (?:rod|crank) ratio [lr]/[lrs], {USUAL_END}")
_OF_TURNING = re.compile(r" is the (?:angular speed|crank angle|time), ")
"""Letters that a formula shows by themselves: what is squared before a wave, and what turns in it."""


@dataclass(frozen=True, slots=True)
class Meant:
    """What a letter is taken to be, and the assumption that says so."""

    role: str
    assumption: str


class _Frame(NamedTuple):
    """What is known with the letters that words explain, the crank of these, and what that assumes."""

    known: Knowledge
    crank: Geometry
    assumptions: tuple[str, ...]


_OF_ANOTHER_BODY = re.compile(
    r"(?:acceleration|velocity|speed|motion|displacement|beschleunigung|geschwindigkeit|accélération|vitesse|accelerazione|velocità"
    r"|aceleración|velocidad)\s+(?:of|der|des|vom|von|du|de|della?|dell['’])\s*(?:the\s+|la\s+|l['’]|el\s+)?(?:\w+[-\s]){0,2}?"
    r"(?:counter-?weight|balanc\w+|rod|conrod|crank|gravity|valve|tappet|flywheel|gegengewicht\w*|pleuel\w*|kurbel\w*|schwerpunkt\w*"
    r"|ventil\w*|contrepoids|bielle|manivelle|soupape|contrappeso|biella|manovella|contrapeso|biela|manivela)",
    re.IGNORECASE,
)
"""Words for the motion of something that is not the piston: its formula alone says nothing then."""


@dataclass
class MeantQuantities:
    """Judges the letters of one document that nobody declared; what each was taken for is its state."""

    words: MeantWords
    sources: Sources
    taken: dict[str, Meant] = field(default_factory=dict)
    shown: set[str] = field(default_factory=set)
    """What was assumed of other letters where a formula came out: ω is the angular speed, as is usual."""

    def judge(self, chain: Chain, k: int, knowledge: Knowledge) -> Verdict | Decision | None:
        """Return the verdict on a relation that defines a letter, if that is known to mean a quantity."""
        name, value = _defined(chain, k)
        if not name or name in knowledge.letters or not names(value):
            return None
        mismatch = self._by_dimensions(name, value, chain, knowledge)
        if mismatch is not None or _are_two_roots(value):
            return mismatch
        frame = self.frame(name, value, chain, knowledge)
        if frame is None:
            return None
        named = self.words.named(name, chain) or self._by_company(name)
        is_unnamed = named is None or not named.role
        if is_unnamed and _OF_ANOTHER_BODY.search(self.words.sentence_before(chain)):
            return None
        frames = [frame]
        if named is not None and named.role and any(OF_RATIO.search(text) for text in frame.assumptions):
            frames.append(self.frame(name, value, chain, knowledge, ratio=CONVENTIONS["r/l"]) or frame)

        def verdict() -> Verdict | Decision | None:
            for each in frames:
                if (agreeing := self._agreeing(chain, k, name, named, each)) is not None:
                    return agreeing
            slip = self._with_slip(chain, k, name, named, frames[-1])
            if slip is not None and slip.verdict == REFUTED:
                return slip
            return self._from_top_instead(chain, k, named, frames) or slip

        try:
            return run_within(SEARCH, verdict, SHARE)
        except OverBudgetError as problem:
            reason = (
                f"whether it is a quantity of the slider-crank was not decided within {problem.spent}"
            )
            return Decision(DEFINITION, reason)

    def _by_company(self, name: str) -> Named | None:
        """Return what a letter is beside those that were taken to be quantities: ẍ or a beside x."""
        marks = {"ddot_": "piston acceleration", "dot_": "piston velocity"}
        for mark, role in marks.items():
            base = name.removeprefix(mark)
            if base != name and base in self.taken and self.taken[base].role in _DISPLACEMENTS:
                return Named(role, "", company=base)
        if name not in _USUAL_MOTIONS or name in self.taken:
            return None
        beside = [
            n for n, meant in self.taken.items() if meant.role in (*_DISPLACEMENTS, "piston velocity")
        ]
        return Named(_USUAL_MOTIONS[name], "", company=beside[-1]) if beside else None

    def again(self, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
        """Return the proof of a further formula of a letter that was taken to be a quantity before.

        None where it is another one: it is judged by the letter's first formula then.
        """
        name, value = _defined(chain, k)
        meant = self.taken.get(name)
        if meant is None or name in knowledge.letters or not names(value):
            return None
        frame = self.frame(name, value, chain, knowledge)
        if frame is None:
            return None
        decision = self._agreeing(chain, k, name, Named(meant.role, ""), frame)
        if decision is None:
            return None
        return replace(decision, assumptions=(meant.assumption, *frame.assumptions))

    def motions(
        self, name: str, chain: Chain, knowledge: Knowledge
    ) -> Iterator[tuple[Knowledge, tuple[str, ...]]]:
        """Yield what is known with the motion that a letter is the extreme of, in both directions.

        That is one which was taken to be a quantity before: x of dot_x_max, a of a_max.
        """
        base = name.removeprefix("hat_") if name.startswith("hat_") else name.rpartition("_")[0] or name
        base = base.removeprefix("hat_").removeprefix("ddot_").removeprefix("dot_")
        meant = self.taken.get(base) or self._peak(name, base, chain)
        if meant is None or base in knowledge.letters:
            return
        frame = self.frame(name, chain.sides[1].node, chain, knowledge)
        if frame is None:
            return
        known, crank, assumptions = frame
        target = _quantities(crank)[meant.role]
        for value in (target, Negative(target)):
            meaning = replace(known.meaning, values={**known.meaning.values, base: value})
            others = {n: d for n, d in known.definitions.items() if n != base}
            moving = replace(known, meaning=meaning, moving=frozenset({base}), definitions=others)
            yield moving, (meant.assumption, *assumptions)

    def _peak(self, name: str, base: str, chain: Chain) -> Meant | None:
        """Return what the letter of a largest value is of by words: the peak is v_max, of piston speeds.

        The mean piston speed has v too, and nothing of a crank angle in it.
        """
        if base not in _USUAL_MOTIONS or name == base or not _PEAK.search(name):
            return None
        role = _USUAL_MOTIONS[base]
        words = self.words.paragraph(chain)
        phrase = next((w for r, w in _MOTION_WORDS if r == role and w.search(words)), None)
        if phrase is None:
            return None
        match = phrase.search(words)
        text = match[0] if match else ""
        return Meant(
            role, f"{plain_letter(base)} is the {role} ({NOBODY}; taken from the words “{text}”)"
        )

    def rod_angle(self, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
        """Return the proof of what fixes an angle that is the rod's: sin β = (r/l) sin θ."""
        left, right = chain.sides[k], chain.sides[k + 1]
        for side in (left, right):
            for part in walk(side.node):
                if not isinstance(part, Call) or not isinstance(part.argument, Name):
                    continue
                name = part.argument.name
                if name in knowledge.letters or part.function not in ("sin", "cos", "tan"):
                    continue
                frame = self.frame(name, Sum((left.node, right.node)), chain, knowledge)
                if frame is None or knowledge.crank is None:
                    continue
                known, crank, assumptions = frame
                called = [
                    n for n, p in self.words.proposals.items() if p.meaning == "rod angle" and p.words
                ]
                own = names(left.node) | names(right.node)
                if name in names(crank.theta) or (called and name not in called):
                    continue
                if not names(crank.theta) <= own:
                    continue  # of two angles that are both the rod's anything is true
                angle = Call("asin", Product((crank.ratio, Call("sin", crank.theta))))
                known = known.with_definition(name, Definition(angle, chain.lines[0]))
                decision = decide(left, right, chain.relations[k].sign, known)
                if decision.is_proved and decision.through is None:
                    text = f"{plain_letter(name)} is the rod angle ({NOBODY}; its formula says so)"
                    return replace(decision, assumptions=(text, *assumptions, *decision.assumptions))
        return None

    def frame(
        self, name: str, value: Formula, chain: Chain, knowledge: Knowledge, ratio: str = ""
    ) -> _Frame | None:
        """Return what is known with the letters that the words explain, the crank, and what that assumes.

        `ratio` is what the crank's ratio is taken for where no words say it: both are
        usual. None where a letter of the formula is neither declared, nor explained, nor defined by such.
        """
        line = chain.lines[0]
        declared, proposed = self.words.sizes(line)
        # of an offset crank, sin β = λ sin θ - δ, no angle is the rod's without its own formula
        is_fixed = knowledge.definitions
        proposed = {n: m for n, m in proposed.items() if m != "rod angle" or n not in is_fixed}
        guessed = {n: ratio for n, m in proposed.items() if ratio and m in CONVENTIONS.values()}
        proposed |= guessed
        has_mass = {"reciprocating mass", "piston mass"} & {
            *map(role_of, declared.values()),
            *proposed.values(),
        }
        by_index = [n for n in names(value) - {*declared, *proposed} if _RECIPROCATING.fullmatch(n)]
        if len(by_index) == 1 and not has_mass:
            proposed |= {by_index[0]: "reciprocating mass"}
        symbols = {**declared, **proposed}
        symbols.pop(name, None)
        if "t" in names(value) and "t" not in symbols and "time" not in map(role_of, symbols.values()):
            symbols["t"] = "time"
        meaning, crank = meaning_of(symbols, engines=self.sources.engines)
        sizes = {n for part in _parts(crank) for n in names(part)}
        definitions = {
            n: d
            for n, d in knowledge.definitions.items()
            if n != name and n not in symbols and n not in sizes and not d.numeric and not d.assumption
        }
        own = names_behind(value, {n: d.node for n, d in definitions.items()})
        ends = {n for n in own if n not in definitions} - {name}
        usual = {n for n in ends if n not in declared and n not in proposed}
        if not ends <= sizes | set(meaning.values) or not isinstance(crank.theta, Name):
            return None
        used = {n: m for n, m in proposed.items() if n in ends}
        texts = (
            *letters_text(used, self.words.proposals),
            *(_usual(n, crank) for n in sorted(usual)),
        )
        if self.words.has_angle_from_bottom:
            texts = (*texts, f"{plain_letter(crank.theta.name)} counts from bottom dead centre")
        law = self.words.law_of_angle(crank.theta, crank.time, line)
        if law and isinstance(crank.omega, Name):
            speed = f"{plain_letter(crank.omega.name)} is the angular speed, "
            texts = tuple(f"{speed}by {law}" if t == speed + USUAL_END else t for t in texts)
        known = replace(
            knowledge,
            meaning=meaning,
            crank=crank,
            definitions=definitions,
            assumptions=(),
            solved={},
            solved_from=(),
            ranges=(),
            letters=frozenset({*symbols, *sizes}),
            moving=frozenset(),
            angles=names(crank.theta) | {crank.time},
            universal=names(crank.theta) | {crank.time},
            meanings=symbols,
        )
        return _Frame(known, crank, tuple(texts))

    def _agreeing(
        self,
        chain: Chain,
        k: int,
        name: str,
        named: Named | None,
        frame: _Frame,
    ) -> Decision | None:
        """Return the proof that a formula is a quantity of the slider-crank: the named one, or any."""
        known, crank, assumptions = frame
        right = chain.sides[k + 1]
        is_motion = any(isinstance(part, Call) for part in walk(right.node))
        place = None if is_motion else self._place(name, chain, named)
        if not is_motion and place is None:
            return None
        for role, target in self._targets(named, crank, place):
            if not _is_near(target, right, known, crank):
                continue
            decision = decide(Side((target,), right.span), right, chain.relations[k].sign, known)
            if not decision.is_proved or _is_first_order(decision) or rests_on_more(decision):
                continue
            where = "" if place is None else f" at {'bottom' if place else 'top'} dead centre"
            source = named.source if named else Named("", "").source
            text = f"{plain_letter(name)} is the {role}{where} ({NOBODY}; {source})"
            if place is None and name not in self.taken:
                self.taken[name] = Meant(role, text)
                self.shown.update(assumptions)
            return replace(decision, assumptions=(text, *assumptions, *decision.assumptions))
        return None

    def _from_top_instead(
        self, chain: Chain, k: int, named: Named | None, frames: list[_Frame]
    ) -> Decision | None:
        """Return that a formula is right for the angle from the top, where a page counts otherwise."""
        if not self.words.has_angle_from_bottom:
            return None
        right, sign = chain.sides[k + 1], chain.relations[k].sign
        for known, crank, assumptions in frames:
            if not isinstance(crank.theta, Name):
                continue
            theta = crank.theta
            back = Sum((theta, Negative(Constant("pi"))))
            for role, turned in self._targets(named, crank, None):
                target = substitute(turned, theta.name, back)
                if not _is_near(target, right, known, crank):
                    continue
                decision = decide(Side((target,), right.span), right, sign, known)
                if decision.is_proved and not _is_first_order(decision):
                    letter = plain_letter(theta.name)
                    reason = (
                        f"it is the {role} if {letter} counts from top dead centre; by the page's words"
                    )
                    reason += f" {letter} counts from bottom dead centre"
                    return Decision(UNDECIDED, "; ".join((reason, *assumptions)))
        return None

    def _place(self, name: str, chain: Chain, named: Named | None) -> int | None:
        """Return the dead centre that a value without an angle is of: 0 top, 1 bottom, None for none."""
        if named is None or not named.role:
            return None
        centre = dead_centre_named(self.words.before(chain))
        if centre is not None:
            return int(centre)
        is_size = named.role in ("piston acceleration", "inertia force")
        return 0 if is_size and (named.is_largest or name.endswith("_max")) else None

    def _targets(
        self, named: Named | None, crank: Geometry, place: int | None
    ) -> Iterator[tuple[str, Formula]]:
        """Yield the quantities that a formula may be, each in both directions where it has two."""
        quantities = _quantities(crank)
        roles = list(quantities)
        if named is not None:
            roles = [named.role] if named.role else roles
            if named.role in _DISPLACEMENTS:
                roles = [named.role, *(r for r in _DISPLACEMENTS if r != named.role)]
                if place is not None and self.words.travels_from_top:
                    roles = [FROM_TOP]  # at the top 2r is its way from the bottom
        for role in roles:
            for sign in (1, -1) if role in _EITHER_SIGN else (1,):
                target = quantities[role] if sign > 0 else Negative(quantities[role])
                if place is None and self.words.has_angle_from_bottom and isinstance(crank.theta, Name):
                    target = substitute(target, crank.theta.name, Sum((crank.theta, Constant("pi"))))
                elif place is not None and isinstance(crank.theta, Name):
                    angle: Formula = Constant("pi") if place else Number(Fraction(0))
                    target = substitute(target, crank.theta.name, angle)
                yield role, target

    def _with_slip(
        self,
        chain: Chain,
        k: int,
        name: str,
        named: Named | None,
        frame: _Frame,
    ) -> Verdict | None:
        """Return that a formula is wrong by one slip, of the quantity that words name; else None.

        The second order has to be there, since r ω² cos θ alone is a first order. Where no words say what
        the lengths of the crank and their ratio are, it is undecided: λ may be another ratio. Where
        an angle may be counted from the bottom dead centre, nothing is said of what is right so.
        """
        known, crank, assumptions = frame
        right = chain.sides[k + 1]
        if named is None or not named.role or named.is_largest or crank.small is None:
            return None
        turns = names(crank.theta) | {crank.time}
        guessed = [text for text in assumptions if text.endswith(USUAL_END) and text not in self.shown]
        is_guess = any(not _OF_TURNING.search(text) for text in guessed)
        behind = names_behind(right.node, {n: d.node for n, d in known.definitions.items()})
        is_of_ratio = crank.small[0] in behind or (behind and crank.small[0] in names(crank.length))
        is_open = not turns & names(right.node) or not is_of_ratio
        if is_open or self._from_bottom(chain, k, named, known, crank):
            return None
        for role, target in self._targets(named, crank, None):
            left = Side((target,), chain.sides[k].span)
            decision = decide(left, right, chain.relations[k].sign, known)
            if decision.status != REFUTED or decision.left is None:
                continue
            text = f"{plain_letter(name)} is the {role} ({NOBODY}; {named.source})"
            decision = replace(decision, reason="; ".join((f"if {text}", *assumptions)))
            verdict = self.with_fix(chain, k, left, decision, known)
            fix = verdict.fix
            if fix is None or len(fix.faults) != 1 or fix.of_left or not ONE_SLIP.fullmatch(fix.kind):
                continue
            if is_only_negated(right.node, fix.node):
                continue
            if is_guess:
                reason = f"{decision.reason}; the usual formula has {fix.text}"
                undecided = replace(decision, status=UNDECIDED, reason=reason, witness={})
                return describe(self.words.document, chain, k, undecided)
            self.taken[name] = Meant(role, text)
            return verdict
        return None

    def with_fix(self, chain: Chain, k: int, left: Side, decision: Decision, known: Knowledge) -> Verdict:
        """Return a refutation with the change that would make the formula the quantity."""
        right = chain.sides[k + 1]

        def proves(node: Formula) -> bool:
            fixed = decide(left, Side((node,), right.span), "≈", known)
            return is_proved_as_far(fixed, decision)

        document = self.words.document
        verdict = describe(document, chain, k, decision)
        return add_fix(verdict, document, right, decision, replace(known, corrects=True), proves)

    def _from_bottom(self, chain: Chain, k: int, named: Named, known: Knowledge, crank: Geometry) -> bool:
        """Tell whether a formula is right where the crank angle is counted from bottom dead centre."""
        is_open = self.words.counts_from_bottom and not self.words.has_angle_from_bottom
        if not is_open or not isinstance(crank.theta, Name):
            return False
        turned = Sum((crank.theta, Constant("pi")))
        right = chain.sides[k + 1]
        for _, target in self._targets(named, crank, None):
            for sign in (1, -1):
                other = substitute(target, crank.theta.name, turned)
                side = Side((other if sign > 0 else Negative(other),), right.span)
                if (
                    _is_near(side.node, right, known, crank)
                    and decide(side, right, chain.relations[k].sign, known).is_proved
                ):
                    return True
        return False

    def refute_by_usual_units(self, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
        """Refute a formula of an angular speed and other letters that nobody explains, by its dimension.

        The inertia torque is no m r² ω sin 2θ/4: a torque goes with ω². None where that is open.
        """
        name, value = _defined(chain, k)
        if not name or name in knowledge.letters or not names(value):
            return None
        return self._by_dimensions(name, value, chain, knowledge, is_usual=True)

    def _asked_for(self, chain: Chain) -> tuple[str, Dimension] | None:
        behind = self.words.document.source(chain.sides[1].span)
        return unit_asked_for(chain, self.words.before(chain), behind)

    def _by_dimensions(
        self, name: str, value: Formula, chain: Chain, knowledge: Knowledge, *, is_usual: bool = False
    ) -> Decision | None:
        """Refute a formula whose dimension cannot be that which the words, or the page's unit, say.

        By one length or one time only: a force without its mass, or in units of m r ω², is usual. A mass
        too much, as in ω = √(k J₁ J₂/(J₁ + J₂)), is left out nowhere.
        """
        line = chain.lines[0]
        units = self.words.units_on_page
        unit = units.get(name)
        expected: tuple[str, Dimension] | None = None
        if unit is not None:
            expected = f"{plain_letter(name)} is in {unit[0]} on line {unit[2]}", unit[1]
        elif name not in self.words.declarations.symbols_at(line) and (
            by_words := self.words.unit_named(chain) or (self._asked_for(chain) if is_usual else None)
        ):  # a declared letter has the size of its own words
            expected = f"the words “{by_words[0]}” name {plain_letter(name)}", by_words[1]
        if expected is None:
            return None
        symbols = {n: p.meaning for n, p in self.words.proposals.items() if p.words}
        symbols |= {n: each[0] for n, each in units.items()}
        symbols |= self.words.declarations.symbols_at(line)
        symbols.pop(name, None)
        values = {n: d.node for n, d in knowledge.definitions.items() if n != name}
        source = self.words.document.source(chain.sides[1].span)
        dimension = Dimensions(symbols, values, self.words.document.text).side(value, source)
        if is_usual:
            sizes = _usual_sizes(value, {*symbols, *values}) if dimension is None else {}
            known = Dimensions({**sizes, **symbols}, values, self.words.document.text)
            dimension = known.side(value, source) if sizes else None
        if dimension is None or dimension == expected[1]:
            return None
        if self.words.has_result_in(name, dimension):
            return None
        usual = _USUAL_UNITS.get(name.removeprefix("hat_").partition("_")[0], "")
        if unit is None and usual and dimension == unit_of(usual):
            return None  # the moments M = F a: the words name the next letter
        gap = [a - b for a, b in zip(dimension, expected[1], strict=True)]
        is_of_one = [place for place, e in enumerate(gap) if e] in ([1], [2])  # of kg, m, s
        is_of_one &= not is_usual or bool(gap[2])  # √3 m r ω² without the lever arm is a couple too
        has_mass_more = unit is not None and gap[0] > 0 and not expected[1][0]
        if not is_of_one and not has_mass_more:
            return None
        reason = (
            f"dimensions: {expected[0]}, which is {unit_text(expected[1])}, and the right side is in"
            f" {unit_text(dimension)}"
        )
        return Decision(
            REFUTED, reason, witness={"left": unit_text(expected[1]), "right": unit_text(dimension)}
        )


def _are_two_roots(value: Formula) -> bool:
    """Tell whether a formula is that of the roots of a quadratic, -p ± √(p² - q): no motion is."""
    parts = [*walk(value)]
    has_root = any(isinstance(p, Call) and p.function == "sqrt" and names(p.argument) for p in parts)
    return has_root and any(isinstance(part, PlusMinus) for part in parts)


def _usual(name: str, crank: Geometry) -> str:
    roles = {
        "crank angle": crank.theta, "crank radius": crank.radius, "rod length": crank.length,
        "angular speed": crank.omega, "reciprocating mass": crank.mass, "time": Name(crank.time),
    }  # fmt: skip
    role = next((role for role, node in roles.items() if name in names(node)), "size")
    return f"{plain_letter(name)} is the {role}, {USUAL_END}"


def _parts(crank: Geometry) -> tuple[Formula, ...]:
    return crank.theta, crank.radius, crank.length, crank.omega, crank.mass


def _quantities(crank: Geometry) -> dict[str, Formula]:
    """Return the quantities of one slider-crank that a formula may be, by what they are called."""
    torque = Quotient(Product((crank.force, crank.velocity)), crank.omega)
    from_bottom = Sum((Product((two(), crank.radius)), Negative(crank.displacement)))
    return {
        FROM_TOP: crank.displacement,
        FROM_PIN: crank.position,
        FROM_BOTTOM: from_bottom,
        FROM_MIDDLE: Sum((crank.position, Negative(crank.length))),
        "piston velocity": crank.velocity,
        "piston acceleration": crank.acceleration,
        "inertia force": crank.force,
        TORQUE: torque,
    }


def _defined(chain: Chain, k: int) -> tuple[str, Formula]:
    """Return the letter that stands alone left of a relation, and the formula right of it."""
    left, right = chain.sides[k].node, without_dots(chain.sides[k + 1].node)[0]
    is_plain = k == 0 and isinstance(left, Name) and chain.relations[k].sign in "=≈"
    return (left.name, right) if is_plain and isinstance(left, Name) else ("", right)


def _usual_sizes(value: Formula, known: Collection[str]) -> dict[str, str]:
    """Return the units that letters of a formula usually have; {} where one may be anything."""
    units = {name: _USUAL_SIZES.get(name.partition("_")[0], "") for name in names(value) - {*known}}
    stems = {name.partition("_")[0] for name in names(value)}
    is_of_crank = bool(stems & {"omega", "Omega"}) and bool(stems & {"r", "R", "J"})
    return {n: f"size, {u}" for n, u in units.items()} if is_of_crank and all(units.values()) else {}


def _is_near(target: Formula, side: Side, known: Knowledge, crank: Geometry) -> bool:
    """Tell whether two formulas differ little where the rod is long, measured by how the first varies.

    A proof costs a second, and most formulas are none of the quantities.
    """
    if crank.small is None:
        return True
    values = {**{n: d.node for n, d in known.definitions.items()}, **known.meaning.values}
    meaning = replace(known.meaning, values=values)
    small, sign = crank.small
    nodes = [target, *(without_dots(node)[0] for node in side.readings)]
    open_letters = {n for node in nodes for n in letters_behind(node, values)}
    rows: list[list[float]] = []
    for seed in range(POINTS):
        point = random_point(sorted(open_letters), meaning.domain(), seed)
        if small in point:
            point[small] = (
                point[small] * (1 if sign < 0 else Fraction(1, LONG)) * (LONG if sign < 0 else 1)
            )
        try:
            rows.append([float(TreeValues(meaning, point).value(node).real) for node in nodes])
        except NO_VALUE:
            return True  # decided by proof
    scale = max(row[0] for row in rows) - min(row[0] for row in rows)
    ways = range(1, len(nodes))
    return not scale or any(all(abs(row[0] - row[k]) <= NEAR * scale for row in rows) for k in ways)


def _is_first_order(decision: Decision) -> bool:
    """Tell whether sides agree in what is left where the rod is endless: a first order, or a part."""
    return decision.through is not None and decision.through < 1


def is_only_negated(node: Formula, fixed: Formula) -> bool:
    """Tell whether a fix only changes the direction."""
    return fixed == Negative(node) or node == Negative(fixed)


def rests_on_more(decision: Decision) -> bool:
    """Tell whether a proof assumes which letter is small, which nobody has said."""
    return any(text.endswith((" is small", " is large")) for text in decision.assumptions)
