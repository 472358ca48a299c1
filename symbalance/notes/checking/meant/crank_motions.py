"""Motions of a slider-crank that words name: "in the lower dead centre the piston is slowed by r ω² (1 - λ)".

The words, the index of the letter, the row of a table or a heading say which motion it is and at which
place of the crank (`motion_words`). The letters of its formula are known by the page, or as is usual: the
one in a sine is the crank angle. Then it is compared with the catalogue's formulas:

    it agrees, exactly or through its power of the rod ratio    conditional on what the letter is taken to be
    one change makes it agree                                   refuted, with that change
    anything else                                               None: a definition, as before

A ratio λ of which nothing says whether it is r/l or l/r may be either; both directions of a motion are right.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from math import asin, sin
from typing import NamedTuple

from symbalance.budgets import Budget, OverBudgetError, run_within
from symbalance.document.formula import (
    Call,
    Constant,
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    children,
    names,
    walk,
    with_children,
)
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision, without_dots
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.declared.symbol_roles import role_of
from symbalance.notes.checking.meant.catalogue.kinematics import (
    ACCELERATION,
    FASTEST,
    HUMP,
    LARGEST,
    LEAST,
    MOTIONS,
    OFFSET,
    PATH,
    ROD_ACCELERATION,
    ROD_ANGLE,
    ROD_SPEED,
    SPEED,
    STROKE,
    TOP,
    BOTTOM,
    TURNED,
    Motion,
)
from symbalance.notes.checking.meant.letter_roles import renamed
from symbalance.notes.checking.meant.meant_words import NOBODY, MeantWords
from symbalance.notes.checking.meant.motion_numbers import MotionNumbers
from symbalance.notes.checking.meant.motion_slips import POINTS, Point, agreement, slips, value_at
from symbalance.notes.checking.meant.motion_words import (
    HAS_OFFSET,
    OF_ENGINE,
    OTHERS,
    motions_named,
    place_of_index,
    places_named,
)
from symbalance.notes.checking.repair.fixes import Repair, fix_of
from symbalance.notes.checking.verdicts import Verdict
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading.equations import Chain, ReadNotes, Side

SEARCH, SHARE = Budget(6), 0.7
"""What this may take, and of what is left of the relation's budget: a definition stays one without it."""
BEFORE, BEHIND = 320, 70
"""Characters that are looked through before a formula and behind it."""
MOST_LETTERS = 5
_BREAK = re.compile(r"[.;!?](?:\s|$)|[。；]|\n\s*\n|<p\b|<li\b|<td\b|\\item|\n#|\n\s*[-*]\s|\|")
_CLAUSE = re.compile(r",\s+(?:and|while|whereas|but|und|während|aber|et|mais|y|pero)\s|；|;")
_MARKUP = re.compile(r"<[^>]*>|\\(?:begin|end|label)\{[^}]*\}|\\\w+|[$*_#`]")
_FROM_ELSEWHERE = re.compile(
    r"\b(?:from|von|vom|ab)\b[^.\n]{0,40}?(?:\bbottom|lower dead|\bBDC\b|vertical|horizontal"
    r"|perpendicular|unteren? totp|\bUT\b|senkrecht|waagrecht|vertikal|lotrecht)"
    r"|(?:下死点|水平|鉛直|垂直)[^。\n]{0,10}から",
    re.IGNORECASE,
)
_FUNCTIONS = frozenset({"sqrt", "sin", "cos", "tan", "asin", "acos", "atan"})
_HEADS = frozenset({"sin", "cos", "tan"})
_OF_CRANK = ("theta", "vartheta", "alpha", "phi", "varphi", "psi", "gamma", "delta", "beta")
"""Letters of angles, those of the crank first: of two, the later one is the rod's."""
_STEMS: Mapping[str, frozenset[str]] = {
    "w": frozenset({"omega", "Omega", "w"}),
    "r": frozenset({"r", "R"}),
    "l": frozenset({"l", "L", "ell"}),
    "ratio": frozenset({"lambda", "kappa", "rho", "varepsilon", "epsilon", "mu", "k", "q", "nu", "n"}),
    "e": frozenset({"e", "d", "a", "y", "c"}),
    "s": frozenset({"S", "H", "s", "h"}),
}
_CRANK_OVER_ROD = re.compile(
    r"crank(?:[- ](?:radius|throw|length))?\s*(?:/|over|to|by|divided by|:)\s*(?:the\s+)?(?:connecting[- ])?rod"
    r"|(?:crank|rod)[- ]ratio\s+\$?r\s*/\s*l|ratio of (?:the )?crank(?: \w+)? to (?:the )?(?:connecting[- ])?rod"
    r"|(?:half[- ]stroke|throw) (?:over|to|by) (?:the )?(?:connecting[- ])?rod"
    r"|manivelle(?:\s*/\s*|\s+(?:sur|à)\s+)bielle|manivela(?:\s*/\s*|\s+y\s+)(?:longitud de )?biela"
    r"|(?:schub|pleuel)stangenverhältnis|pleuelverhältnis|kurbelradius (?:zu|durch|/) |\b[rR]\s*/\s*[lL]\b",
    re.IGNORECASE,
)
_ROD_OVER_CRANK = re.compile(
    r"(?:connecting[- ])?rod(?:[- ]length)?\s*(?:/|over|to|by|divided by|:)\s*(?:the\s+)?crank"
    r"|ratio of (?:the )?(?:connecting[- ])?rod(?: \w+)? to (?:the )?crank|\b[lL]\s*/\s*[rR]\b",
    re.IGNORECASE,
)
_OF_STROKE = re.compile(
    r"(?:stroke|hub|行程|ストローク)\s*(?:/|to|over|zu)\s*(?:the\s+)?(?:rod|pleuel|stange)"
    r"|(?:rod|pleuel\w*)\s*(?:/|to|over|zu)\s*(?:the\s+)?(?:stroke|hub)|\b[lL]\s*/\s*[sS]\b|\b[sS]\s*/\s*[lL]\b",
    re.IGNORECASE,
)
_OF_ROD = frozenset({ROD_ANGLE, ROD_SPEED, ROD_ACCELERATION})
_FAST = re.compile(r"fast|velocit|speed|geschwindig|速度|schnell|vitesse|velocidad", re.IGNORECASE)
_EXTREME = re.compile(r"extrem|\btop|peak|hump|minim|largest|greatest|maxim", re.IGNORECASE)
_DOUBTS = re.compile(
    r"\bnot\b|\binstead\b|\bwrong|mistak|\bnicht\b|\bstatt\b|anstelle|falsch|ではない|誤り|間違|older|empiri"
    r"|rule of thumb|faustformel|mistook|often written",
    re.IGNORECASE,
)


_PART = re.compile(
    r"\bhalf\b|\btwice|\bdouble|\beach\b|\bboth\b|\btwo\b|total|\bhalbe?\b|doppelt|zweifach|半|倍|両"
    r"|\bsum\b|amplitude|peak[- ]to[- ]peak|\brange\b|per\b|proportion",
    re.IGNORECASE,
)
"""Words that make a part or a multiple of a motion."""
_UNCERTAIN = re.compile(r"missing|too many|differentiation")
"""Changes after which another quantity may stand there."""


_ROLES = {
    "crank radius": "r", "rod length": "l", "stroke": "s", "angular speed": "w", "rod ratio l/r": "ratio",
    "crank ratio r/l": "ratio",
}  # fmt: skip
_USUAL = {"a": ACCELERATION, "b": ACCELERATION, "v": SPEED, "x": PATH, "s": PATH}
"""Letters of motions, where several are named at once, or none near."""


class _Named(NamedTuple):
    """A motion that words name, the places that it may be at, and whether both rest on words of its own."""

    kind: str
    places: tuple[str, ...]
    words: str
    is_sure: bool
    may_be_other: bool = False
    """Whether the dead centre may be the other one: inner and outer are called so from either end."""


class _Reading(NamedTuple):
    """Which letter of a claim plays which role, with the convention of its ratio."""

    letters: Mapping[str, str]
    is_inverse: bool
    law: Formula | None
    """What stands for the crank angle: ω t."""

    def point(self, at: Point) -> dict[str, Fraction]:
        """Return the numbers of the claim's letters at a point of the roles."""
        numbers = {"r": at["r"], "w": at["w"], "theta": at["theta"], "e": at["e"]}
        numbers |= {"l": at["r"] / at["lam"], "s": 2 * at["r"]}
        numbers["ratio"] = 1 / at["lam"] if self.is_inverse else at["lam"]
        inclined = asin(float(at["lam"]) * sin(float(at["theta"])))
        numbers["rod"] = Fraction(inclined).limit_denominator(10**15)
        numbers["t"] = at["theta"] / at["w"]
        return {letter: numbers[role] for letter, role in self.letters.items()}

    def target(self, node: Formula) -> Formula | None:
        """Return a formula of the catalogue in the letters of the claim, if it has those it needs."""
        of = {role: Name(letter) for letter, role in self.letters.items()}
        radius: Formula | None = of.get("r") or (Quotient(of["s"], Number(Fraction(2))) if "s" in of else None)
        ratio: Formula | None = of.get("ratio")
        if ratio is not None and self.is_inverse:
            ratio = Quotient(Number(Fraction(1)), ratio)
        if ratio is None and "l" in of and radius is not None:
            ratio = Quotient(radius, of["l"])
        if radius is None and ratio is not None and "l" in of:
            radius = Product((ratio, of["l"]))
        if ratio is None and "rod" in of and "theta" in of:
            ratio = Quotient(Call("sin", of["rod"]), Call("sin", of["theta"]))
        angle = self.law or of.get("theta")
        values = {"r": radius, "lam": ratio, "w": of.get("w"), "theta": angle, "e": of.get("e")}
        needed = names(node)
        if any(values[role] is None for role in needed):
            return None
        return _with_roles(node, {role: value for role, value in values.items() if value is not None})


def _with_roles(node: Formula, values: Mapping[str, Formula]) -> Formula:
    """Return a formula with all its roles replaced at once."""
    if isinstance(node, Name):
        return values.get(node.name, node)
    parts = children(node)
    return with_children(node, tuple(_with_roles(part, values) for part in parts)) if parts else node


@dataclass
class CrankMotions:
    """Judges the motions of one page; which letter was which motion is its state."""

    document: ReadNotes
    sections: Sections
    words: MeantWords
    kinds: dict[tuple[str, int], str] = field(default_factory=dict)
    """Stems of letters, with how often they are differentiated, that words named a motion, or that agreed with one."""
    spots: dict[str, tuple[str, ...]] = field(default_factory=dict)
    """Places at which words put a letter."""

    @cached_property
    def numbers(self) -> MotionNumbers:
        """The sizes that the page names."""
        return MotionNumbers(self.document)

    @cached_property
    def is_of_crank(self) -> bool:
        """Tell whether the page is about a slider-crank at all."""
        return OF_ENGINE.search(self.document.text) is not None

    @cached_property
    def counts_from_elsewhere(self) -> bool:
        """Tell whether an angle may be counted from another place than the top dead centre."""
        return _FROM_ELSEWHERE.search(self.document.text) is not None

    def judge(
        self, chain: Chain, k: int, knowledge: Knowledge, *, refutes: bool = True
    ) -> Verdict | Decision | None:
        """Return the verdict on a relation that gives a named motion its formula; None for others."""
        left, claim = chain.sides[k].node, without_dots(chain.sides[k + 1].node)[0]
        head = _head(left)
        if k or head is None or chain.relations[0].sign not in ("=", "≈") or not self.is_of_crank:
            return None
        claim = _with_letter_e(claim) if self.is_offset_page else claim
        own = names(claim)
        if claim == Number(Fraction(0)):
            return self._zero(chain, *head, claim)
        if not own:
            return self._number(chain, *head, claim)
        if not own or len(own) > MOST_LETTERS or head[1] in own or decimals(claim):
            return None
        if any(isinstance(part, Call) and part.function not in _FUNCTIONS for part in walk(claim)):
            return None
        if any(isinstance(part, Derivative) for part in walk(claim)):
            return None
        try:
            return run_within(SEARCH, lambda: self._judge(chain, *head, claim, knowledge, refutes), SHARE)
        except OverBudgetError:
            return None  # a definition, as it stands

    def _judge(
        self, chain: Chain, function: str, name: str, order: int, claim: Formula, knowledge: Knowledge, refutes: bool
    ) -> Verdict | Decision | None:
        named = self._named(chain, function, name, order, claim)
        if named is None:
            return None
        readings = list(self._readings(claim, knowledge, chain.lines[0], is_offset=self.is_offset_page))
        if named.kind == STROKE:
            readings = [each for each in readings if "s" not in each.letters.values()]
        table = OFFSET if self.is_offset_page else MOTIONS
        if self.is_offset_page and not any("e" in each.letters.values() for each in readings):
            return None
        self.spots.setdefault(name, named.places)
        place_of = [(place, table.get((named.kind, place))) for place in named.places]
        motions = [(place, motion) for place, motion in place_of if motion is not None]
        if not motions:
            return None
        for reading in readings:
            for place, motion in motions:
                decision = self._agreeing(chain, function, name, claim, named, place, motion, reading)
                if decision is not None:
                    self.kinds.setdefault((_stem(name), order), named.kind)
                    return decision
        self.kinds.setdefault((_stem(name), order), named.kind)
        if not refutes or not named.is_sure or len({reading.is_inverse for reading in readings}) == 0:
            return None
        if self._agrees_elsewhere(function, claim, named, readings, table):
            return None
        firsts = [(place, Motion(motion.exact, motion.rough[:1])) for place, motion in motions]
        for reading in readings:
            for _, motion in (*firsts, *motions):
                verdict = self._with_slip(chain, function, name, claim, named, motion, reading, readings)
                if verdict is not None:
                    return verdict
        return None

    def _zero(self, chain: Chain, function: str, name: str, order: int, claim: Formula) -> Decision | None:
        """Return the proof that a motion is zero at a place where it is."""
        named = self._named(chain, function, name, order, claim)
        places = () if named is None else named.places
        if named is None or not places or self.is_offset_page:
            return None
        self.spots.setdefault(name, places)
        motions = [MOTIONS.get((named.kind, place)) for place in places]
        if not all(motion is not None and claim in motion.exact for motion in motions):
            return None
        return Decision(PROVED, assumptions=(self._text(function, name, named, places[0]),))

    def _number(self, chain: Chain, function: str, name: str, order: int, claim: Formula) -> Decision | None:
        """Return the decision on a number of a named motion, by the sizes that the page names."""
        if function or order:
            return None
        clause, since, sentence, _ = self._texts(chain)
        named = self._named(chain, function, name, order, claim)
        row, column = self._row(chain)
        words = f"{row} {column}" if row else since
        words = clause if motions_named(clause) else words
        if named is not None and named.is_sure:
            self.kinds.setdefault((_stem(name), order), named.kind)
        kind, places = (named.kind, named.places) if named is not None and named.is_sure else ("", ())
        return self.numbers.judge(chain, f"{words} {sentence}" if not row else words, kind, places, name)

    # What words name

    def _texts(self, chain: Chain) -> tuple[str, str, str, str]:
        """Return a relation's own clause, the words since the relation before, its sentence, and those behind."""
        text, start = self.document.text, chain.start
        ends = [other.end for other in self.document.chains if other.end <= start and other.relations]
        first = max([start - BEFORE, 0, *ends[-1:]])
        first = max([first, *(end for end in ends if end > first)])
        since = text[first:start]
        clause = _BREAK.split(since.rstrip(" \t\n$\\([{&|"))[-1]
        sentence = _BREAK.split(text[max(0, start - BEFORE) : start].rstrip(" \t\n$\\([{&|"))[-1]
        after = _BREAK.split(text[chain.end : chain.end + BEHIND])[0]
        return _plain(clause), _plain(since), sentence, _plain(after)

    def _row(self, chain: Chain) -> tuple[str, str]:
        """Return the words of a relation's row in a table, and the head of its column."""
        lines, line = self.document.text.split("\n"), chain.lines[0] - 1
        if line >= len(lines) or not lines[line].lstrip().startswith("|"):
            return "", ""
        first = line
        while first and lines[first - 1].lstrip().startswith("|"):
            first -= 1
        start = chain.start - sum(len(each) + 1 for each in lines[:line])
        column = lines[line][:start].count("|")
        heads = lines[first].split("|")
        words = lines[line].split("|")[1] if "|" in lines[line][1:] else ""
        return _plain(words), _plain(heads[column]) if column < len(heads) and first < line else ""

    def _named(self, chain: Chain, function: str, name: str, order: int, claim: Formula) -> _Named | None:
        clause, since, sentence, after = self._texts(chain)
        row, column = self._row(chain)
        heading = _plain(self.sections.heading_above(chain.lines[0]))
        stem, _, index = name.partition("_")
        if _DOUBTS.search(f"{clause} {after}"):
            return None
        near = [each for each in ((f"{row} {column}",) if row else (clause, after.split(",")[0], since)) if each.strip()]
        kind, words = "", ""
        by_mark = _by_dots(stem, order)
        usual = by_mark or _USUAL.get(stem, "")
        for text in near:
            motions = motions_named(text, f"{heading} {sentence}")
            if len({*motions}) > 1 and usual in motions:
                motions = [usual]
            if motions:
                if OTHERS.search(text):
                    return None
                kind, words = (motions[0] if text is near[-1] and text == after else motions[-1]), text
                break
        if not kind and OTHERS.search(clause):
            return None
        is_turned = any(isinstance(p, Call) and p.function in _HEADS for p in walk(claim))
        sure = bool(kind)
        if by_mark and kind != by_mark and (not kind or (kind in _OF_ROD) == (by_mark in _OF_ROD)):
            kind, words, sure = by_mark, "the dots over the letter", bool(kind) or self._is_rod_angle(stem)
        if not kind and (stem, order) in self.kinds:
            kind, words, sure = self.kinds[stem, order], f"{plain_letter(stem)} above", True
        if not kind:
            motions = list(dict.fromkeys(motions_named(heading)))
            motions = [usual] if usual in motions else motions
            if len(motions) == 1 and not OTHERS.search(heading):
                kind, words, sure = motions[0], heading, True
        if by_mark and kind != by_mark:
            return None
        if not kind and function and len(_angles_in(claim)) == 1 and name not in _angles_in(claim):
            kind, words = ROD_ANGLE, "its formula says so"
        if not kind and _rank(stem) < len(_OF_CRANK) and self._is_rod_angle(stem):
            kind, words, sure = ROD_ANGLE, f"{plain_letter(stem)} above", True
        if not kind and not function and usual and usual in self._named_on_page:
            kind, words = usual, "as is usual for this letter"
        place, is_place_sure = place_of_index(index)
        spots = places_named(" ".join(near[:1]) if row else f"{clause} {after.split(',')[0]}", sentence)
        if not spots:
            spots = places_named(since) or (places_named(heading) if not is_turned else [])
        if function and _rank(name) < _rank("psi") and kind not in _OF_ROD:
            kind, spots, sure = _angle_kind(f"{since} {heading} {sentence}", kind, spots)
            if not kind:
                return None
        if not kind or (function and kind not in (ROD_ANGLE, FASTEST, HUMP)):
            return None
        if is_turned and kind in TURNED:
            return _Named(kind, ("",), _short(words), sure)
        if kind in (STROKE, FASTEST, HUMP):
            return _Named(kind, tuple(spots) if self.is_offset_page and kind == FASTEST else ("",), _short(words), sure)
        if kind == SPEED and index in ("top", "t"):
            spots = spots or [LARGEST]
        elif is_place_sure:
            spots = [place]
        elif not spots and place:
            spots = [place]
        if {TOP, BOTTOM} & {*spots}:
            spots = [spot for spot in spots if not spot.startswith("~")]  # the outer (upper) dead centre
        may_be_other = any(spot.startswith("~") for spot in spots)
        spots = [spot.removeprefix("~") for spot in spots]
        if spots == [""] or (len(spots) > 1 and "" in spots):
            spots = [TOP, BOTTOM]
        spots = spots or list(self.spots.get(name, ()))
        if not spots:
            return None
        if len(spots) > 1 and not {TOP, BOTTOM} & {*spots}:
            return None
        return _Named(kind, tuple(spots), _short(words), sure, may_be_other)

    @cached_property
    def _named_on_page(self) -> frozenset[str]:
        """The motions that words name anywhere."""
        return frozenset(motions_named(_plain(self.document.text)))

    def _is_rod_angle(self, stem: str) -> bool:
        """Tell whether a line gives the sine of a letter by the sine of another: sin β = λ sin θ."""
        for chain in self.document.chains:
            left = chain.sides[0].node
            is_sine = isinstance(left, Call) and left.function == "sin" and left.argument == Name(stem)
            if is_sine and any(_angles_in(side.node) - {stem} for side in chain.sides[1:]):
                return True
        return False

    @cached_property
    def is_offset_page(self) -> bool:
        """Whether the page speaks of an offset line of stroke."""
        return HAS_OFFSET.search(self.document.text) is not None

    # What the letters stand for

    def _readings(
        self, claim: Formula, knowledge: Knowledge, line: int, *, is_offset: bool
    ) -> Iterator[_Reading]:
        """Yield the ways in which the letters of a claim may play their roles."""
        inside = {n for p in walk(claim) if isinstance(p, Call) and p.function in _HEADS for n in names(p.argument)}
        letters: dict[str, str] = {}
        law: Formula | None = None
        if "t" in inside:
            speeds = [n for n in inside if n.partition("_")[0] in _STEMS["w"]]
            if len(speeds) != 1 or len(inside) != 2:
                return
            letters |= {speeds[0]: "w", "t": "t"}
            law = Product((Name(speeds[0]), Name("t")))
        elif inside:
            angles = sorted(inside, key=_rank)
            if len(angles) > 2 or any(_rank(n) >= len(_OF_CRANK) for n in angles):
                return
            letters |= dict(zip(angles, ("theta", "rod"), strict=False))
        conventions = [False]
        declared, proposed = self.words.sizes(line)
        told = {n: _ROLES[role] for n, m in {**proposed, **declared}.items() if (role := role_of(m)) in _ROLES}
        for letter in sorted(names(claim) - letters.keys()):
            stem = letter.partition("_")[0]
            roles = [role for role in ("w", "r", "l", "ratio") if stem in _STEMS[role]]
            roles = [told[letter]] if letter in told and roles != ["ratio"] else roles
            if is_offset and stem in _STEMS["e"] and not roles:
                roles = ["e"]
            elif stem in _STEMS["s"] and not roles:
                roles = ["s"]
            if len(roles) != 1 or roles[0] in letters.values():
                return
            letters[letter] = roles[0]
            if roles == ["ratio"]:
                conventions = list(self._conventions(letter, knowledge))
        if {"r", "s"} <= {*letters.values()}:
            return
        for is_inverse in conventions:
            yield _Reading(letters, is_inverse, law)

    def _conventions(self, letter: str, knowledge: Knowledge) -> Iterator[bool]:
        """Yield whether a ratio may be l/r (True) or r/l (False); nothing for one that is something else."""
        known: set[bool] = set()
        definition = knowledge.definitions.get(letter)
        values = [definition.node] if definition is not None else []
        for chain in self.document.chains:
            if chain.sides[0].node == Name(letter):
                values += [side.node for side in chain.sides[1:]]
        for value in values:
            if isinstance(value, Quotient) and isinstance(value.numerator, Name) and isinstance(value.denominator, Name):
                pair = tuple(n.name.partition("_")[0] for n in (value.numerator, value.denominator))
                is_crank = pair[0] in _STEMS["r"] and pair[1] in _STEMS["l"]
                is_rod = pair[0] in _STEMS["l"] and pair[1] in _STEMS["r"]
                if not is_crank and not is_rod:
                    return
                known.add(is_rod)
            elif not names(value):
                number = value_at(value, {})
                if number == number and not 0.6 < number < 1.7:
                    known.add(number > 1)
        declared, text = knowledge.meanings.get(letter, ""), self.document.text
        if _OF_STROKE.search(text) or "l/s" in declared:
            return
        if not known:
            if "r/l" in declared or (_CRANK_OVER_ROD.search(text) and not _ROD_OVER_CRANK.search(text)):
                known.add(False)
            elif "l/r" in declared or (_ROD_OVER_CRANK.search(text) and not _CRANK_OVER_ROD.search(text)):
                known.add(True)
        yield from sorted(known or {False, True})

    # What is right and wrong

    def _agreeing(
        self, chain: Chain, function: str, name: str, claim: Formula, named: _Named, place: str, motion: Motion,
        reading: _Reading,
    ) -> Decision | None:
        """Return the proof that a claim is a motion's formula, in either direction."""
        motion = _inside(motion, function)
        for turned in self._counted(motion, named):
            found = agreement(turned, claim, _values(reading), _signs(named.kind, function))
            if found is None:
                continue
            target, sign, how = found
            node = reading.target(Negative(target) if sign < 0 else target)
            if not how and node is not None:
                decision = decide(Side((node,), chain.sides[0].span), chain.sides[1], "=", _known(claim, reading, chain))
                if decision.status == REFUTED:
                    return None
            texts = [self._text(function, name, named, place), *self._letters(reading)]
            if how == "rough":
                texts.append("the rod is long")
            order = f"{self._ratio_text(reading)}^{how}" if how.isdigit() else ""
            return Decision(PROVED, order=order, assumptions=tuple(texts))
        return None

    def _counted(self, motion: Motion, named: _Named) -> Iterator[Motion]:
        """Yield a motion, and with the crank angle counted from the bottom where the page may do so."""
        yield motion
        if self.counts_from_elsewhere and not named.places[0] and named.kind in TURNED:
            turned = {"theta": Call("acos", Number(Fraction(0)))}  # π/2; a half turn is twice that
            half = Product((Number(Fraction(2)), turned["theta"]))
            shifted = [
                tuple(_with_roles(n, {"theta": Name("theta") + half}) for n in nodes)
                for nodes in (motion.exact, motion.rough)
            ]
            yield Motion(*shifted)

    def _agrees_elsewhere(
        self, function: str, claim: Formula, named: _Named, readings: list[_Reading],
        table: Mapping[tuple[str, str], Motion],
    ) -> bool:
        """Tell whether a claim is a formula of the motion at another place that no words exclude."""
        if named.places in ((TOP,), (BOTTOM,), ("right",)) and not named.may_be_other:
            return False
        return any(
            agreement(_inside(motion, function), claim, _values(reading), _signs(kind, function)) is not None
            for reading in readings
            for (kind, place), motion in table.items()
            if kind == named.kind and (place or not named.places[0])
        )

    def _with_slip(
        self, chain: Chain, function: str, name: str, claim: Formula, named: _Named, motion: Motion,
        reading: _Reading, readings: list[_Reading],
    ) -> Verdict | None:
        """Return that a claim is wrong by one change, with that change; None where that is open."""
        if self.counts_from_elsewhere and not named.places[0]:
            return None
        motion = _inside(motion, function)
        side = chain.sides[1]
        ratio = next((letter for letter, role in reading.letters.items() if role == "ratio"), "")
        inverted = substitute(claim, ratio, Quotient(Number(Fraction(1)), Name(ratio))) if ratio else claim
        is_known = len({each.is_inverse for each in readings}) == 1
        more = [("rod ratio inverted", inverted)] if ratio and is_known else []
        of = {role: letter for letter, role in reading.letters.items()}
        if {"r", "l"} <= {*of}:
            more.append(("lengths exchanged", renamed(claim, {of["r"]: of["l"], of["l"]: of["r"]})))
        if not _PART.search(self._texts(chain)[0]):
            more += [(f"factor {f}", Product((Number(f), claim))) for f in (Fraction(1, 2), Fraction(2))]
        for kind, changed in (*slips(claim), *more):
            is_other = any(letter not in names(claim) for letter in names(changed))
            if is_other or changed == claim or _UNCERTAIN.search(kind):
                continue
            found = agreement(motion, changed, _values(reading), _signs(named.kind, function))
            if found is None or found[2] == "0":
                continue
            if _is_scaled(claim, changed, _values(reading)):
                continue
            known = _known(claim, reading, chain)
            decision = decide(Side((changed,), chain.sides[0].span), side, "=", known)
            if decision.status == PROVED:
                continue
            decision = _refuted(claim, changed, reading)
            texts = [self._text(function, name, named, named.places[0]), *self._letters(reading)]
            decision = replace(decision, reason="if " + "; ".join(texts))
            verdict = describe(self.document, chain, 0, decision)
            repair = Repair(kind, changed, ((side.node, changed),), 1.0)
            return replace(verdict, fix=fix_of(repair, self.document, side))
        return None

    # What is said of it

    def _text(self, function: str, name: str, named: _Named, place: str) -> str:
        where = {
            TOP: " at top dead centre", BOTTOM: " at bottom dead centre", "right": " a quarter turn behind the top",
            LARGEST: ", its largest value", LEAST: ", its smallest value",
        }.get(place, "")  # fmt: skip
        whose = "" if named.kind in (ROD_ANGLE, ROD_SPEED, ROD_ACCELERATION, STROKE, FASTEST, HUMP) else "piston's "
        return f"{plain_letter(name)} is the {whose}{named.kind}{where} ({NOBODY}; taken from the words “{named.words}”)"

    def _letters(self, reading: _Reading) -> list[str]:
        texts = []
        for letter, role in reading.letters.items():
            if role == "ratio":
                texts.append(f"{plain_letter(letter)} is {'l/r' if reading.is_inverse else 'r/l'}")
        return texts

    def _ratio_text(self, reading: _Reading) -> str:
        return next((plain_letter(n) for n, role in reading.letters.items() if role == "ratio"), "(r/l)")


def _head(left: Formula) -> tuple[str, str, int] | None:
    """Return the function, the letter and the times it is differentiated of a left side: sin β, ẍ."""
    function, order = "", 0
    if isinstance(left, Call) and left.function in _HEADS:
        function, left = left.function, left.argument
    if isinstance(left, Derivative) and left.variable == Name("t"):
        order, left = left.order, left.expression
    return (function, left.name, order) if isinstance(left, Name) else None


def _stem(name: str) -> str:
    return name.partition("_")[0]


def _plain(words: str) -> str:
    return _MARKUP.sub(" ", words).strip()


def _short(words: str) -> str:
    return " ".join(words.split())[-60:].strip(" ,:;([|")


def _angles_in(node: Formula) -> frozenset[str]:
    """Return the letters that stand in sines and cosines."""
    waves = (p for p in walk(node) if isinstance(p, Call) and p.function in _HEADS)
    return frozenset(n for wave in waves for n in names(wave.argument))


def _with_letter_e(node: Formula) -> Formula:
    """Return a formula in which e is a letter: an offset, and not the base of logarithms."""
    if node == Constant("e"):
        return Name("e")
    if isinstance(node, Call) and node.function == "exp":
        return Power(Name("e"), _with_letter_e(node.argument))
    parts = children(node)
    return with_children(node, tuple(map(_with_letter_e, parts))) if parts else node


def _rank(letter: str) -> int:
    stem = letter.partition("_")[0]
    return _OF_CRANK.index(stem) if stem in _OF_CRANK else len(_OF_CRANK)


def _angle_kind(words: str, kind: str, spots: list[str]) -> tuple[str, list[str], bool]:
    """Return which crank angle words name of which a page gives the sine or cosine."""
    if HAS_OFFSET.search(words) or (TOP in spots or BOTTOM in spots):
        return FASTEST, spots, True
    if kind == ACCELERATION and _EXTREME.search(words):
        return HUMP, [""], True
    if _FAST.search(words) and (_EXTREME.search(words) or "fast" in words):
        return FASTEST, [""], True
    return "", [], False


def _by_dots(stem: str, order: int) -> str:
    """Return the motion that dots over a letter make of it."""
    if not order:
        return ""
    if stem in ("beta", "phi", "varphi", "psi", "gamma", "delta"):
        return (ROD_SPEED, ROD_ACCELERATION)[order - 1] if order < 3 else ""
    if stem in ("x", "y", "z", "s"):
        return (SPEED, ACCELERATION, "jerk")[order - 1] if order < 4 else ""
    return ""


def _inside(motion: Motion, function: str) -> Motion:
    """Return a motion of whose angle the page gives a sine, a cosine or a tangent."""
    if not function:
        return motion
    return Motion(
        tuple(Call(function, node) for node in motion.exact), tuple(Call(function, node) for node in motion.rough)
    )


def _signs(kind: str, function: str) -> tuple[int, ...]:
    return (1, -1) if kind in TURNED and not function else (1,)


def _values(reading: _Reading):  # noqa: ANN202
    return lambda node, at: value_at(node, reading.point(at))


def _known(claim: Formula, reading: _Reading, chain: Chain) -> Knowledge:
    """Return what is known for a comparison: all sizes are positive, the rod's angle follows the crank's."""
    angles = {letter for letter, role in reading.letters.items() if role in ("theta", "rod", "t")}
    known = Knowledge(SymbolValue(positive=frozenset(names(claim) - angles)), corrects=True)
    of = {role: letter for letter, role in reading.letters.items()}
    if "rod" in of and "theta" in of:
        ratio: Formula = Name(of.get("ratio", "lambda"))
        if reading.is_inverse:
            ratio = Quotient(Number(Fraction(1)), ratio)
        elif "l" in of and "r" in of:
            ratio = Quotient(Name(of["r"]), Name(of["l"]))
        angle = Call("asin", Product((ratio, Call("sin", Name(of["theta"])))))
        known = known.with_definition(of["rod"], Definition(angle, chain.lines[0]))
    return known


def _refuted(claim: Formula, changed: Formula, reading: _Reading) -> Decision:
    """Return that two formulas differ, with their values at a point as witness."""
    point = reading.point(POINTS[0])
    shown = {plain_letter(letter): f"{float(value):.6g}" for letter, value in point.items()}
    left, right = value_at(changed, point), value_at(claim, point)
    return Decision(REFUTED, witness={**shown, "left": f"{left:.6g}", "right": f"{right:.6g}"})


def _is_scaled(claim: Formula, changed: Formula, claimed) -> bool:  # noqa: ANN001
    """Tell whether a change only multiplies the whole: the unit, or the direction, may be another one."""
    ratios = [claimed(changed, point) / claimed(claim, point) for point in POINTS if claimed(claim, point)]
    return bool(ratios) and all(abs(each / ratios[0] - 1) < 1e-9 for each in ratios) and ratios[0] < 0
