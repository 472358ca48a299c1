r"""Relations under bars and of means, \overline{ab}, \langle v^2 \rangle, E[X²], proved of real letters.

A bar over a formula is read as a conjugate of what is real and changes nothing, an angle bracket as any
bracket. Both sides are compared again with samples of numbers, of which a bar is the mean, and with
complex numbers. The letter z between bars, |z_1 + z_2|, is a complex number where nothing says otherwise.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Name,
    Power,
    Product,
    Quotient,
    children,
    names,
    parts_of_kind,
    walk,
)
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.values_under_bars import BarValues, NoSampleError, are_close
from symbalance.notes.checking.declared.symbol_roles import conjugate_name
from symbalance.notes.checking.premises.ranges_in_words import letters_without_sign
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITIONAL, PROVED_WORDS, Verdict
from symbalance.notes.checking.words.means_under_bars import COMPLEX, MEAN
from symbalance.notes.reading import ReadingError
from symbalance.notes.reading.document import read_expression
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

_BAR = conjugate_name("")
_OPENS = re.compile(r"(?:\\left\s*)?(?:\\langle(?![A-Za-z])|⟨|〈)")
_CLOSES = re.compile(r"(?:\\right\s*)?(?:\\rangle(?![A-Za-z])|⟩|〉)")
_SURE_E = r"\\(?:mathbb|operatorname|mathrm|mathsf)\s*(?:E(?![A-Za-z])|\{\s*E\s*\})"
_EXPECTED = re.compile(rf"(?:(?P<sure>{_SURE_E})|(?<![A-Za-z\\])E)\s*(?:\\left\s*)?(?P<open>[\[(])")
_OF_CHANCE = re.compile(r"(?<![A-Za-z\\])[a-z]{0,2}[UVXYZ](?![a-z])")
_CHANCE = re.compile(
    r"expect(?:ed|ation)|varianc|random|Erwartungswert|Varianz|Zufalls|espérance|aléatoire|valore\s+atteso|varianza"
    r"|esperanza|aleatori|期待値|分散|確率",
    re.IGNORECASE,
)
_INDEPENDENT = re.compile(
    r"(?<!not )(?<!nicht )(?:independent|uncorrelated|unabhängig|unkorreliert|indépendant|non\s+corrélé"
    r"|indipendent|incorrelat|independiente|constant|konstant|costant|独立|無相関|一定)",
    re.IGNORECASE,
)
"""Words of what may be true of means beyond their rules."""
_BEFORE, _BEHIND = 300, 160
"""Characters around a relation in which words may call it one of means."""
_MOST_ABOVE = 8
"""Lines above that a relation of means may be one of."""
_COMPLEX_LETTERS = frozenset("zwZW")
_OF_COMPLEX = ("re", "im", "arg")

NO_MEAN = "true of numbers: a mean of products is not the product of the means"
REAL_ONLY = "true of real numbers only, and what stands under a bar may be complex, or a mean is meant"
COMPLEX_TOO = "true of real numbers only, and its letters may be complex: say what they are"
CONJUGATE = "the bar is the complex conjugate"


def unless_under_bars(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; what is proved of real numbers and fails of means or others is not confirmed."""
    if verdict.verdict not in (*PROVED_WORDS, REFUTED):
        return verdict
    pair = chain.sides[k], chain.sides[k + 1]
    as_means = [_with_means(state, chain, side) for side in pair]
    if any(side is not None for side in as_means):
        sides = [side.node if mean is None else mean for side, mean in zip(pair, as_means, strict=True)]
        decision = _of_means(state, chain, sides)
        if verdict.verdict == REFUTED:  # of numbers, of which E is one too
            is_right = decision is None and _is_true_of_means(state, chain, sides)
            return describe(state.document, chain, k, Decision(PROVED)) if is_right else verdict
        return verdict if decision is None else describe(state.document, chain, k, decision)
    if verdict.verdict == REFUTED:
        return verdict
    sides = [side.node for side in pair]
    bars = [c for node in sides for c in parts_of_kind(node, Call) if c.function == "conj"]
    if not bars:
        decision = _of_sizes(state, chain, sides)
        return verdict if decision is None else describe(state.document, chain, k, decision)
    return _under_bars(state, chain, k, sides, verdict)


def _under_bars(
    state: JudgingState, chain: Chain, k: int, sides: list[Formula], verdict: Verdict
) -> Verdict:
    """Return the verdict on a relation with a bar over a formula: of means, or of conjugates."""
    text = state.document.text
    is_complex = COMPLEX.search(text) is not None or _has_imaginary(state, sides)
    near = text[max(0, chain.start - _BEFORE) : chain.end + _BEHIND]
    if not is_complex and MEAN.search(near):
        decision = _of_means(state, chain, sides)
        return verdict if decision is None else describe(state.document, chain, k, decision)
    inside = _under(sides)
    if is_complex:
        said = letters_without_sign(chain, state.document)
        inside = {name for name in inside if name[:1] in _COMPLEX_LETTERS or name in said}
    knowledge = state.knowledge_of(chain, state.knowledge(chain.lines[0]))
    inside -= {*knowledge.definitions, *knowledge.meaning.values, *knowledge.meanings}
    outside = set().union(*(_outside(node, "conj") for node in sides))
    if inside.isdisjoint(name.removeprefix(_BAR) for name in outside):
        return verdict
    is_known = not inside.isdisjoint(knowledge.meaning.complex)  # judged as complex numbers already
    if not is_known and _Claim(sides, inside, _values(knowledge)).holds(are_means=False) is False:
        return describe(state.document, chain, k, Decision(UNDECIDED, REAL_ONLY))
    if is_complex or all(name[:1] in _COMPLEX_LETTERS for name in inside):
        return verdict
    if _Claim(sides, _varying(sides), _values(knowledge)).holds(are_means=True) is False:
        assumption = ", ".join(filter(None, (verdict.assumption, CONJUGATE)))
        return replace(verdict, verdict=CONDITIONAL, assumption=assumption)
    return verdict


def _has_imaginary(state: JudgingState, sides: list[Formula]) -> bool:
    """Tell whether a page has i, or takes real parts or angles of numbers."""
    nodes = [side.node for chain in state.document.chains for side in chain.sides]
    return any(
        part == Constant("i") or (isinstance(part, Call) and part.function in _OF_COMPLEX)
        for node in (*sides, *nodes)
        for part in walk(node)
    )


def _is_of_line_above(state: JudgingState, chain: Chain, claim: _Claim) -> bool:
    """Tell whether a relation of means is one above it with its terms moved."""
    above = [
        c
        for c in state.document.chains
        if c.end <= chain.start and not c.letters.isdisjoint(chain.letters)
    ]
    for other in above[-_MOST_ABOVE:]:
        sides = [_with_means(state, other, side) or side.node for side in other.sides]
        for first, second in pairwise(sides):
            if claim.is_like(first, second):
                return True
    return False


def _is_true_of_means(state: JudgingState, chain: Chain, sides: list[Formula]) -> bool:
    """Tell whether a relation is true of means of samples, of independent ones where words say so."""
    is_of_apart = _INDEPENDENT.search(state.document.text) is not None
    return _claim(state, chain, sides).holds(are_means=True, are_independent=is_of_apart) is True


def _of_means(state: JudgingState, chain: Chain, sides: list[Formula]) -> Decision | None:
    """Return the decision on a relation of means that fails for samples of numbers; None for others."""
    claim = _claim(state, chain, sides)
    varying = claim.varying
    bars = [c for node in sides for c in parts_of_kind(node, Call) if c.function == "conj"]
    if not any(_is_product(part, varying) for bar in bars for part in walk(bar.argument)):
        return None  # of sums the mean is what it is of numbers
    own = [part for node in sides for part in parts_of_kind(node, Name)]
    apart = {part.name.removeprefix(_BAR) for part in own if part.name.startswith(_BAR)}
    if len(bars) < 2 and apart.isdisjoint(varying):
        return None  # one mean, whose value is said or worked out
    if claim.holds(are_means=True) is not False or _is_of_line_above(state, chain, claim):
        return None
    others = (c for c in state.document.chains if c.start != chain.start and c.relations)
    is_alone = all(varying.isdisjoint({n.removeprefix(_BAR) for n in c.letters}) for c in others)
    sections = state.sections
    is_case = sections.opens_case(chain) or sections.is_supposed(chain) or sections.is_condition(chain)
    is_case = is_case or sections.is_denied(chain) or sections.is_said_to_fail(chain)
    is_of_apart = _INDEPENDENT.search(state.document.text) is not None
    if is_of_apart and claim.holds(are_means=True, are_independent=True):
        return None
    may_refute = is_alone and not is_case and not is_of_apart
    return Decision(REFUTED if may_refute else UNDECIDED, NO_MEAN, witness=claim.witness())


def _of_sizes(state: JudgingState, chain: Chain, sides: list[Formula]) -> Decision | None:
    """Return that |z_1 + z_2| = |z_1| + |z_2| is open, whose letters stand between bars alone."""
    sizes = [c for node in sides for c in parts_of_kind(node, Call) if c.function == "abs"]
    inside = {name for call in sizes for name in names(call.argument)}
    if not inside:
        return None
    said = letters_without_sign(chain, state.document)
    inside = {name for name in inside if name[:1] in _COMPLEX_LETTERS or name in said}
    knowledge = state.knowledge_of(chain, state.knowledge(chain.lines[0]))
    known = {*knowledge.meaning.values, *knowledge.definitions, *knowledge.meanings}
    known |= {name for stated in knowledge.ranges for name in names(stated.left) | names(stated.right)}
    if not inside or not inside.isdisjoint(known | knowledge.meaning.positive):
        return None
    if any(not inside.isdisjoint(_outside(node, "abs")) for node in sides):
        return None
    fails = _Claim(sides, inside, _values(knowledge)).holds(are_means=False) is False
    return Decision(UNDECIDED, COMPLEX_TOO) if fails else None


@dataclass(frozen=True, slots=True)
class _Claim:
    """Two sides, the letters that vary or are complex, and the values of others."""

    sides: list[Formula]
    varying: set[str]
    values: dict[str, Formula]

    def holds(self, *, are_means: bool, are_independent: bool = False) -> bool | None:
        """Tell whether both sides are the same; None where they have no values."""
        try:
            for seed in (1, 2):
                at = BarValues(
                    self.varying,
                    self.values,
                    are_means=are_means,
                    are_independent=are_independent,
                    seed=seed,
                )
                if not are_close(*map(at.value, self.sides)):
                    return False
        except NoSampleError:
            return None
        return True

    def is_like(self, left: Formula, right: Formula) -> bool:
        """Tell whether the sides of another relation differ by as much, wherever these two do."""
        try:
            for seed in (1, 2):
                at = BarValues(self.varying, self.values, are_means=True, seed=seed)
                own = [a - b for a, b in zip(*map(at.value, self.sides), strict=True)]
                other = [a - b for a, b in zip(at.value(left), at.value(right), strict=True)]
                if not are_close(own, other) and not are_close(own, [-gap for gap in other]):
                    return False
        except NoSampleError:
            return False
        return True

    def witness(self) -> dict[str, str]:
        """Return the samples at which the sides differ."""
        at = BarValues(self.varying, self.values, are_means=True, seed=1)
        left, right = map(at.value, self.sides)
        return at.printed() | {"left": f"{left[0].real:.6g}", "right": f"{right[0].real:.6g}"}


def _claim(state: JudgingState, chain: Chain, sides: list[Formula]) -> _Claim:
    """Return a relation of means, of letters that vary and the values of others."""
    knowledge = state.knowledge_of(chain, state.knowledge(chain.lines[0]))
    return _Claim(sides, _varying(sides), _values(knowledge))


def _values(knowledge: Knowledge) -> dict[str, Formula]:
    known = {n: d.node for n, d in knowledge.definitions.items() if not (d.solved or d.numeric)}
    return known | dict(knowledge.meaning.values)


def _under(sides: list[Formula]) -> set[str]:
    """Return the letters under bars over formulas."""
    calls = [c for node in sides for c in parts_of_kind(node, Call) if c.function == "conj"]
    return {name for call in calls for name in names(call.argument)}


def _varying(sides: list[Formula]) -> set[str]:
    """Return the letters that stand under bars only: another one is a number, its own mean."""
    outside = set().union(*(_outside(node, "conj") for node in sides))
    barred = {name.removeprefix(_BAR) for name in outside if name.startswith(_BAR)}
    return (_under(sides) | barred) - outside


def _is_product(part: Formula, varying: set[str]) -> bool:
    """Tell whether what varies stands in a product with itself, a power, a function or a denominator."""
    if isinstance(part, Product):
        return sum(not varying.isdisjoint(names(factor)) for factor in part.factors) > 1
    if isinstance(part, Quotient):
        return not varying.isdisjoint(names(part.denominator))
    return isinstance(part, (Power, Call)) and not varying.isdisjoint(names(part))


def _outside(node: Formula, function: str) -> set[str]:
    """Return the letters of a formula that stand outside of a function's brackets."""
    if isinstance(node, Name):
        return {node.name}
    if isinstance(node, Call) and node.function == function:
        return set()
    return set().union(*(_outside(part, function) for part in children(node)))


def _with_means(state: JudgingState, chain: Chain, side: Side) -> Formula | None:
    """Return a side with bars over what stands in ⟨ ⟩ and E[ ]; None where it has no such bracket."""
    source = state.document.source(side.span)
    if "E" not in source and _OPENS.search(source) is None:
        return None
    barred = _CLOSES.sub("}", _OPENS.sub(r"\\overline{", source)) if _pairs(source) else source
    barred = _without_expected(barred, is_of_chance=_CHANCE.search(state.document.text) is not None)
    if barred == source:
        return None
    letters = chain.letters | {_BAR + name for name in chain.letters}
    try:
        return read_expression(barred, letters)[0]
    except ReadingError:
        return None


def _pairs(source: str) -> bool:
    """Tell whether angle brackets come in pairs, with no comma or bar in them, as of a product of two."""
    count = len(_OPENS.findall(source))
    inner = re.sub(r"\\[,;:!|]", " ", source)
    return 0 < count == len(_CLOSES.findall(source)) and not re.search(r"[,|]", inner)


def _without_expected(source: str, *, is_of_chance: bool) -> str:
    """Return a formula with bars for E[…]: of X, Y or Z, or where words speak of chance."""
    place = 0
    while (match := _EXPECTED.search(source, place)) is not None:
        start, depth, end = match.end(), 1, match.end()
        closer = "]" if match["open"] == "[" else ")"
        while end < len(source) and depth:
            depth += {match["open"]: 1, closer: -1}.get(source[end], 0)
            end += 1
        inside = re.sub(r"\\(?:left|right|cdot|,|;)|\^\s*\{[^{}]*\}", " ", source[start : end - 1])
        is_meant = match["sure"] or is_of_chance
        is_meant = is_meant or (match["open"] == "[" and _OF_CHANCE.search(inside) is not None)
        place = match.end()
        if not depth and is_meant:
            source = f"{source[: match.start()]}\\overline{{{source[start : end - 1]}}}{source[end:]}"
            place = match.start() + 1
    return source
