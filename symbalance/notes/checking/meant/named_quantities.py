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

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import permutations
from math import isclose, isfinite, log2, pi

from symbalance.budgets import Budget, OverBudgetError, run_within
from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Number,
    Sum,
    children,
    names,
    walk,
    with_children,
)
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.tree_values import TreeValues
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision, without_dots
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.meant.known_formulas import OTHER_LENGTHS, QUANTITIES, ROLES, Quantity
from symbalance.notes.checking.meant.meant_words import NOBODY
from symbalance.notes.checking.repair.fixes import Repair, add_fix, fix_of, is_proved_as_far
from symbalance.notes.checking.verdicts import Verdict
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading.equations import Chain, ReadNotes, Side

SEARCH, SHARE = Budget(4), 0.6
"""What this may take, and of what is left of the relation's budget: a definition stays one without it."""
SENTENCE, PARAGRAPH, AFTER = 220, 500, 60
"""Characters that are looked through: before a formula for its name, and around for another shape."""
POINTS = ((3, 7, 11, 13, 17), (5, 2, 19, 23, 29), (31, 37, 41, 43, 47))
"""Values of a formula's letters at which two formulas are compared, in tenths."""
_EXACT = 1e-9
_FACTORS = frozenset({1, 2, 3, 4, 6, 8, 9, 16, 32, 64})
"""Numerators and denominators of a factor that is a slip: 5, 12, 60, 1000 may be a change of units."""
_ONE_TERM = re.compile(r"order|exponent|number misprinted .*|sign|factor -?[0-9/]+")
_SENTENCE_END = re.compile(r"[.;!?](?:\s|$)|[。；]|\n\s*\n|<p\b|<li\b|\\item|\\section|\n#|\n\|")
_BLANK = re.compile(r"\n\s*\n")
_OPENING = re.compile(
    r"(?:\s|\$+|\\[\[(]|\\begin\{[a-z]+\*?\}|\\displaystyle|&|\||<p>|<div>"
    r"|<math>|`)+$"
)
"""What stands between words and the formula that is set off from them."""
_PART = re.compile(
    r"\b(?:two|three|four|five|six|eight|twelve)\b(?![- ]stroke)|\bboth\b|\beach\b|\bpairs?\b"
    r"|\btwice\b|twin"
    r"|\bdoubled?\b|\bhalf\b|\bhalv|\bmean\b|\baverage|amplitude|alternating|boxer|\bV\d|together"
    r"|\bequal\b"
    r"|\bzwei(?!takt)|\bbeide[nrs]?\b|\bdrei|\bvier(?!takt)|\bsechs|\bacht|\bjede[rsnm]?\b|\bje\b"
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
_DENIED = re.compile(
    r"\bnot\b|\binstead\b|\bwrong|mistak|confus|unlike|\bnicht\b|\bstatt\b|anstelle|falsch"
    r"|verwechs|ではない|でなく"
    r"|誤り|間違|another book|older|approximat|roughly|näherung|近似|empiric|faustformel"
    r"|rule of thumb|経験"
    r"|squared\b|square of|quadrat\b|quadrate?s?\s+de[rs]|[2二]乗",
    re.IGNORECASE,
)
"""Words with which a formula may be named that is not the standard one."""
_UNITS_ONLY = re.compile(r"variable|positive|constant|[^\w]*|[A-Za-z°µ%/^*·0-9² ³⁴⁻¹-]{0,9}")
_NO_ROLE = frozenset(
    {"i", "a", "o", "m", "in", "out", "inner", "outer", "innen", "aussen", "außen", "mid"}
)
"""Subscripts of a diameter or a radius that is one of two."""
_OUTER, _INNER = (frozenset(text.split()) for text in ("a o e out outer", "i in inner innen"))
_OF_TWO = {"outer": (_OUTER, _INNER), "inner": (_INNER, _OUTER)}
"""Subscripts of the two diameters of a hollow section; without one D is the larger."""
_TAGS = re.compile(r"<[^>]*>|\\(?:mathrm|text|it|rm|bf)\b|[${}()\\*_`|\[\]~]")
_LINKS = re.compile(
    r"(?:\s|,|:|=|\bof\b|\bthe\b|\bis\b|\ba\b|\bby\b|\bvon\b|\bist\b|\bder\b|\bdie\b|\bdes\b|\bmit\b"
    r"|\band\b|\bund\b|[をがはのと、])+$",
    re.I,
)
_IS = re.compile(
    r"\s*(?:be|is|denotes|being|sei|ist|bezeichnet)\s+(?:the|a|der|die|das)\s+"
    r"((?:[\w-]+ ){0,2}?[\w-]+)(?= of\b| der\b| des\b|[,.;]|\s*$)",
    re.I,
)
"""What a letter is said to be behind it: d is the distance of the supports."""
_COPULA = re.compile(
    r"(?:\s|[:,=$({\[\\|*_`~—-]|<[^>]*>|\b(?:is|are|of|the|a|an|this|section|shaft|solid|round"
    r"|circular|given|by"
    r"|then|becomes|equals|ist|sind|beträgt|wird|wellen?|der|die|das|eines?r?|also|folgt|so|begin"
    r"|equation"
    r"|align|display|style|displaystyle)\b"
    r"|\b(?:in|over|along|for|auf|über)\s+(?:an?|the|its|der|die)\s+(?:length|länge)(?:\s+of)?\s+\$?[lL]\b"
    r"|[はがを、とすると軸丸実中の])*",
    re.IGNORECASE,
)


@dataclass(frozen=True, slots=True)
class _Named:
    """A quantity that words name, the words, and all the text that may qualify it."""

    quantity: Quantity
    words: str
    around: str
    sentence: str
    is_other: bool = False
    """Whether words name another shape or hypothesis: only formulas of two diameters hold."""

    is_declared: bool = False

    @property
    def formulas(self) -> tuple[Formula, ...]:
        """The standard formulas that the words leave open."""
        every = self.quantity.formulas
        return tuple(node for node in every if "outer" in names(node)) if self.is_other else every


@dataclass
class NamedQuantities:
    """Judges the formulas of one document whose quantity the words around name."""

    document: ReadNotes
    sections: Sections
    _said: dict[str, str] = field(default_factory=dict)
    """The words right before each letter, wherever it stands."""

    def judge(self, chain: Chain, k: int, knowledge: Knowledge) -> Verdict | Decision | None:
        """Return the verdict on a relation that gives a named quantity a formula; None for others."""
        left, right = chain.sides[k].node, without_dots(chain.sides[k + 1].node)[0]
        is_plain = k == 0 and isinstance(left, Name) and chain.relations[0].sign in "=≈"
        own = names(right)
        if not is_plain or not isinstance(left, Name) or not 1 <= len(own) <= 5 or left.name in own:
            return None
        if any(isinstance(part, Call) and part.function != "sqrt" for part in walk(right)):
            return None
        try:
            return run_within(SEARCH, lambda: self._judge(chain, left.name, right, knowledge), SHARE)
        except OverBudgetError:
            return None  # a definition, as it stands

    def _judge(
        self, chain: Chain, name: str, claim: Formula, knowledge: Knowledge
    ) -> Verdict | Decision | None:
        known = Knowledge(SymbolValue(positive=frozenset(names(claim))), corrects=True)
        side = chain.sides[1]
        candidates = list(self._named(name, chain, knowledge))
        pairs = [
            (named, target)
            for named in candidates
            for target in self._targets(named.formulas, claim, knowledge)
        ]
        for named, target in pairs:
            decision = decide(Side((target,), side.span), side, chain.relations[0].sign, known)
            if decision.is_proved and not decision.order:
                signs = {f"{n} ≥ 0" for n in names(claim)}
                signs |= {f"{plain_letter(n)} ≥ 0" for n in names(claim)}
                rest = [text for text in decision.assumptions if text not in signs]
                return replace(decision, assumptions=(self._text(name, named), *rest))
        plain = [named for named in candidates if not named.is_other]
        if len({named.quantity.name for named in plain}) != 1:
            return None
        targets = [target for named, target in pairs if named is plain[0]]
        return self._with_slip(chain, name, claim, plain[0], targets, known, knowledge)

    def _text(self, name: str, named: _Named) -> str:
        source = f"{NOBODY}; taken from the words “{named.words}”"
        source = f"declared as “{named.words}”" if named.is_declared else source
        return f"{plain_letter(name)} is the {named.quantity.name} ({source})"

    # What words name

    def _named(self, name: str, chain: Chain, knowledge: Knowledge) -> Iterator[_Named]:
        """Yield the quantities that a letter may be, by its declared meaning or the words before it."""
        stem, _, index = name.removeprefix("Delta_").partition("_")
        stem = f"Delta_{stem}" if name.startswith("Delta_") else stem
        declared = knowledge.meanings.get(name, "")
        sentence, before, around = self._texts(chain)
        if _DENIED.search(sentence):
            return
        by_meaning = [
            replace(named, is_declared=True)
            for named in self._by_phrases(declared, stem, around, declared)
        ]
        if by_meaning or (declared and not _UNITS_ONLY.fullmatch(declared)):
            yield from by_meaning
            return
        by_phrase = list(self._by_phrases(before, stem, around, sentence))
        if by_phrase:
            yield from by_phrase
            return
        heading = self.sections.heading_above(chain.lines[0])
        for quantity in QUANTITIES:
            if quantity.context is None or stem not in quantity.letters:
                continue
            if quantity.indices and index not in quantity.indices:
                continue
            match = quantity.context.search(before) or quantity.context.search(heading)
            if match is not None:
                all_around = f"{around} {heading}"
                yield _named(quantity, match[0].strip(), all_around, sentence)

    def _by_phrases(self, words: str, stem: str, around: str, sentence: str) -> Iterator[_Named]:
        """Yield the quantities that words name, those with the letter's usual use first of all."""
        matches = [
            (match.start(), match.end(), quantity)
            for quantity in QUANTITIES
            for match in quantity.phrases.finditer(words)
        ]
        longest = [
            (start, end, quantity)
            for start, end, quantity in matches
            if not any(s <= start and end <= e and e - s > end - start for s, e, _ in matches)
        ]
        usual = [each for each in longest if stem in each[2].letters]
        if not usual:
            last = max((end for _, end, _ in longest), default=0)
            usual = [each for each in longest if each[1] == last and _COPULA.fullmatch(words[last:])]
            usual = usual if len({start for start, _, _ in longest}) == 1 else []
        last = max((end for _, end, _ in usual), default=0)
        for start, end, quantity in usual:
            if end == last:
                rest = sentence.replace(words[start:end], "")
                yield _named(quantity, words[start:end].strip(), around, rest)

    def _texts(self, chain: Chain) -> tuple[str, str, str]:
        """Return a relation's sentence, what of it stands right before, and what is around."""
        text, start = self.document.text, min(side.span[0] for side in chain.sides)
        end = max(side.span[1] for side in chain.sides)
        words = _OPENING.sub("", text[max(0, start - PARAGRAPH) : start])
        sentence = _SENTENCE_END.split(words[-SENTENCE:])[-1]
        ends = [
            max(side.span[1] for side in other.sides) for other in self.document.chains if other.relations
        ]
        first = max([0, *(e for e in ends if e <= start)])
        last = max(0, start - PARAGRAPH) + len(words)
        before = sentence[-(last - first) :] if last - first < len(sentence) else sentence
        before = before if last > first else ""
        paragraphs = " ".join(_BLANK.split(words)[-2:])
        after = _SENTENCE_END.split(text[end : end + AFTER])[0]
        return f"{sentence} {after}", before, f"{paragraphs} {after}"

    # Which letters play which roles

    def _targets(
        self, formulas: tuple[Formula, ...], claim: Formula, knowledge: Knowledge
    ) -> Iterator[Formula]:
        """Yield the formulas in the letters of a claim, each letter in a role that it may have."""
        own = sorted(names(claim))
        for node in formulas:
            roles = sorted(names(node))
            if len(roles) != len(own):
                continue
            for order in permutations(own):
                pairs = list(zip(roles, order, strict=True))
                if all(self._may_be(letter, role, knowledge) for role, letter in pairs):
                    yield _renamed(node, dict(pairs))

    def _may_be(self, letter: str, role: str, knowledge: Knowledge) -> bool:
        """Tell whether a letter may play a role: by its meaning, the words before it, or as is usual."""
        declared = knowledge.meanings.get(letter, "")
        if declared and any(each.words.search(declared) for each in ROLES.values()):
            return ROLES[role].words.search(declared) is not None
        if declared and not _UNITS_ONLY.fullmatch(declared):
            return False
        before = self._words_before(letter)
        roles = {name for name, each in ROLES.items() if any(_ends_with(each.words, w) for w in before)}
        is_other = any(_ends_with(OTHER_LENGTHS, w) for w in before)
        return role in roles if roles else not is_other and _is_usual(letter, role)

    def _words_before(self, letter: str) -> list[str]:
        """Return the few words before each place where a letter stands in the text."""
        if letter not in self._said:
            stem, _, index = letter.partition("_")
            signs = {stem, plain_letter(stem), "\\" + stem}
            tail = rf"_?\{{?{re.escape(index)}\}}?" if index else r"(?!_)"
            pattern = (
                rf"(?<![^\W_])(?<!\\)(?:{'|'.join(map(re.escape, sorted(signs)))}){tail}(?![A-Za-z])"
            )
            text = self.document.text
            places = [m.start() for m in re.finditer(pattern, text)]
            tails = (_TAGS.sub("", text[max(0, start - 60) : start]) for start in places)
            phrases = [_LINKS.sub("", tail)[-30:] for tail in tails]
            for match in re.finditer(pattern, text):
                follows = _IS.match(_TAGS.sub("", text[match.end() : match.end() + 60]))
                if follows is not None:
                    phrases.append(follows[1])
            self._said[letter] = "\n".join(words.replace("\n", " ") for words in phrases)
        return self._said[letter].split("\n")

    # What is wrong

    def _with_slip(
        self,
        chain: Chain,
        name: str,
        claim: Formula,
        named: _Named,
        targets: list[Formula],
        known: Knowledge,
        knowledge: Knowledge,
    ) -> Verdict | None:
        """Return that a formula is wrong by one slip, with the standard one; None where that is open."""
        quantity = named.quantity
        others = self._targets(quantity.others, claim, knowledge)
        if any(_ratio_of(other, claim) == (1.0,) * len(POINTS) for other in others) or decimals(claim):
            return None
        may_be_part = _PART.search(named.sentence) is not None or _has_own_convention(claim, knowledge)
        for target in targets:
            kind = _slip(target, claim, quantity.slips, may_be_part)
            if not kind:
                continue
            side = chain.sides[1]
            left = Side((target,), chain.sides[0].span)
            decision = decide(left, side, chain.relations[0].sign, known)
            if decision.status != REFUTED:
                continue
            decision = replace(decision, reason=f"if {self._text(name, named)}")
            verdict = self._with_fix(chain, left, decision, known)
            fix = verdict.fix
            is_one_change = fix is not None and len(fix.faults) == 1 and not fix.of_left
            change = "exponent" if kind == "power of a term" else _ONE_TERM
            if is_one_change and fix is not None and re.fullmatch(change, fix.kind):
                return verdict
            if kind in ("term", "power of a term"):
                continue
            repair = Repair(kind, target, ((side.node, target),), 1.0)
            return replace(verdict, fix=fix_of(repair, self.document, side))
        return None

    def _with_fix(self, chain: Chain, left: Side, decision: Decision, known: Knowledge) -> Verdict:
        side = chain.sides[1]

        def proves(node: Formula) -> bool:
            return is_proved_as_far(decide(left, Side((node,), side.span), "≈", known), decision)

        verdict = describe(self.document, chain, 0, decision)
        return add_fix(verdict, self.document, side, decision, known, proves)


def _named(quantity: Quantity, words: str, around: str, sentence: str) -> _Named:
    is_other = quantity.unless is not None and quantity.unless.search(around) is not None
    is_other |= quantity.only is not None and not quantity.only.search(f"{around} {words}")
    return _Named(quantity, words, around, sentence, is_other)


def _is_usual(letter: str, role: str) -> bool:
    """Tell whether a letter of which no words say anything stands for a role on most pages."""
    stem, _, index = letter.partition("_")
    stem = letter if letter.startswith("Delta_") else stem
    if role in _OF_TWO:
        own, other = _OF_TWO[role]
        return index in own or (stem == ("D" if role == "outer" else "d") and index not in other)
    if role in ("diameter", "radius", "crank") and index in _NO_ROLE:
        return False
    return stem.rstrip("'") in ROLES[role].letters


def _has_own_convention(claim: Formula, knowledge: Knowledge) -> bool:
    """Tell whether the page defines a letter as half a difference: δ = (ω₁ - ω₂)/(2 ω) is another δ."""
    own = [knowledge.definitions[n] for n in names(claim) if n in knowledge.definitions]
    formulas = [d.formula if d.numeric else d.node for d in own]
    parts = [list(walk(node)) for node in formulas if node is not None]
    return any(
        any(isinstance(part, Sum) for part in each)
        and any(isinstance(part, Number) and part.value != 1 for part in each)
        for each in parts
    )


def _ends_with(words: re.Pattern[str], text: str) -> bool:
    """Tell whether a text ends with one of the words."""
    return any(match.end() == len(text) for match in words.finditer(text))


def _renamed(node: Formula, letters: Mapping[str, str]) -> Formula:
    """Return a formula with its roles replaced by letters, all at once."""
    for role in letters:
        node = substitute(node, role, Name(f" {role}"))
    for role, letter in letters.items():
        node = substitute(node, f" {role}", Name(letter))
    return node


# Which slip


def _values(node: Formula, point: Mapping[str, Fraction]) -> float:
    """Return a formula's value at a point; NaN where it has none."""
    try:
        value = TreeValues(SymbolValue(), dict(point)).value(node)
    except (NoFormError, TooLargeError, ZeroDivisionError, ValueError, KeyError, TypeError):
        return float("nan")
    return float(value.real) if abs(value.imag) <= _EXACT * abs(value) else float("nan")


def _points(letters: list[str]) -> list[dict[str, Fraction]]:
    return [{n: Fraction(row[k], 10) for k, n in enumerate(letters)} for row in POINTS]


def _ratio_of(target: Formula, claim: Formula) -> tuple[float, ...]:
    """Return the claim over the target at each point, 1.0 where they agree to the last digits."""
    letters = sorted(names(target) | names(claim))
    ratios = []
    for point in _points(letters):
        below = _values(target, point)
        ratio = _values(claim, point) / below if below else float("nan")
        ratios.append(1.0 if isclose(ratio, 1, rel_tol=_EXACT) else ratio)
    return tuple(ratios)


def _slip(target: Formula, claim: Formula, slips: tuple[str, ...], may_be_part: bool) -> str:
    """Return the kind of the one slip by which a claim differs from a formula; "" for none."""
    ratios = _ratio_of(target, claim)
    if not all(isfinite(ratio) and ratio for ratio in ratios):
        return "term" if "term" in slips else ""  # σ² - 3 τ² below a root
    if all(isclose(ratio, ratios[0], rel_tol=_EXACT) for ratio in ratios):
        return _slip_by_factor(target, ratios[0], slips, may_be_part)
    letters = sorted(names(claim))
    tests = {
        "root missing": ("root", lambda: _agrees(_with_roots(target, lambda node: node), claim)),
        "fraction inverted": ("root", lambda: _agrees(_with_roots(target, _inverse_root), claim)),
        "exponent": ("power", lambda: _is_other_power(target, claim, letters)),
        "sign": ("minus", lambda: _is_sum_for_difference(target, claim)),
    }
    for kind, (allowed, test) in tests.items():
        if allowed in slips and test():
            return kind
    return next((kind for kind in ("term", "power of a term") if kind in slips), "")


def _slip_by_factor(target: Formula, ratio: float, slips: tuple[str, ...], may_be_part: bool) -> str:
    """Return the kind of a slip that is a factor; "" where that may be right."""
    if ratio <= 0 or ratio == 1:
        return ""
    if "turn" in slips and any(isclose(ratio, (2 * pi) ** n, rel_tol=_EXACT) for n in (1, -1, 2, -2)):
        return "factor 2π"
    is_told = "bare factor" in slips or ("factor" in slips and _has_number(target))
    return "factor" if is_told and not may_be_part and _is_slip_factor(ratio) else ""


def _inverse_root(radicand: Formula) -> Formula:
    return Call("sqrt", 1 / radicand)


def _with_roots(node: Formula, change: Callable[[Formula], Formula]) -> Formula:
    """Return a formula with each of its roots made another formula of what is below it."""
    if isinstance(node, Call) and node.function == "sqrt":
        return change(node.argument)
    parts = children(node)
    return with_children(node, tuple(_with_roots(part, change) for part in parts)) if parts else node


def _agrees(target: Formula, claim: Formula) -> bool:
    return _ratio_of(target, claim) == (1.0,) * len(POINTS)


def _has_number(node: Formula) -> bool:
    """Tell whether a formula has a factor of its own: 32/π of 32 M/(π d³), none of M/W."""
    values = {name: Number(Fraction(1)) for name in names(node)}
    for name, value in values.items():
        node = substitute(node, name, value)
    return not isclose(_values(node, {}), 1)


def _is_slip_factor(ratio: float) -> bool:
    """Tell whether a factor is one that is forgotten or taken from a neighbouring formula: ½, 4, π."""
    for factor in (1.0, pi, 1 / pi):
        value = ratio / factor
        near = Fraction(value).limit_denominator(64)
        if near and isclose(float(near), value, rel_tol=_EXACT):
            return {near.numerator, near.denominator} <= _FACTORS
    return False


def _is_other_power(target: Formula, claim: Formula, letters: list[str]) -> bool:
    """Tell whether a claim has another exponent at one letter, or two letters exchanged."""
    quotient = claim / target
    exponents: dict[str, float] = {}
    for letter in letters:
        doubled = substitute(quotient, letter, 2 * Name(letter))
        steps = [ratio for ratio in _ratio_of(quotient, doubled) if isfinite(ratio) and ratio > 0]
        if len(steps) != len(POINTS) or not all(isclose(s, steps[0], rel_tol=_EXACT) for s in steps):
            return False
        exponent = log2(steps[0])
        if abs(exponent) > _EXACT:
            exponents[letter] = exponent
    halves = {letter: round(2 * exponent) for letter, exponent in exponents.items()}
    if not halves or any(abs(e) > 4 for e in halves.values()):
        return False
    rest = quotient
    for letter, half in halves.items():
        rest = rest / Name(letter) ** Fraction(half, 2)
    if not _agrees(Number(Fraction(1)), rest):
        return False
    is_exchange = len(halves) == 2 and not sum(halves.values())
    return len(halves) == 1 or (is_exchange and _is_exchanged(target, claim, [*halves]))


def _is_exchanged(target: Formula, claim: Formula, pair: list[str]) -> bool:
    return _agrees(_renamed(target, {pair[0]: pair[1], pair[1]: pair[0]}), claim)


def _is_sum_for_difference(target: Formula, claim: Formula) -> bool:
    """Tell whether a claim has the other sign at one of its letters: (ω₁ + ω₂)/ω."""
    return any(_agrees(target, substitute(claim, n, -Name(n))) for n in sorted(names(claim)))
