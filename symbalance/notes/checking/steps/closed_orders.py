"""Relations that close on themselves are checked, though each alone only states something: a < b = a.

What a chain or a run of relations says of two of its sides follows from all signs between them: from
x < y = z it follows that x < z, and a = b = c + 1 = a + 1 cannot be.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import tau

from symbalance.document.formula import Formula, names
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONTRADICTION, REFUTED, STATED, UNDECIDED, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_UP = {"=": 0, "≤": 0, "<": 1}
_DOWN = {"=": 0, "≥": 0, ">": 1}
"""Signs that lead up, or down, and whether strictly."""
_STRICT, _MIRRORED = {"<": "≤", ">": "≥"}, {"≤": "≥", "≥": "≤"}
MOST = 4
"""Relations before one with which it is put together."""
FARTHEST = 80
"""Characters between two of them."""
_ONLY_LINKS = re.compile(
    r"(?:[\s$,;.&]|\\(?:[,;: \]\[]|\\|q?quad|Rightarrow|implies|therefore|(?:begin|end)\{[a-z*]+\})|⇒"
    r"|(?<![^\W\d_])(?:and|und|et|y|e|also|so|hence|thus|then|therefore|daher|also|somit|folglich|donc|quindi|luego)(?![^\W\d_])|よって|ゆえに|かつ)*"
)
_SAME = 1e-9


def unless_closed(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a relation that cannot be beside those before it is refuted."""
    if verdict.verdict not in STATED:
        return verdict
    for status, reason in _objections(state, chain, k):
        if reason is not None:
            _forget(state, chain, k)
            return describe(state.document, chain, k, Decision(status, reason))
    return verdict


def _objections(state: JudgingState, chain: Chain, k: int) -> Iterator[tuple[str, str | None]]:
    """Yield what may be said against a relation, with the reason or None, the surest first."""
    yield REFUTED, _against_own_chain(chain, k)
    yield UNDECIDED, _stronger_than_before(state, chain, k)
    yield CONTRADICTION, _against_run(state, chain, k)


def _forget(state: JudgingState, chain: Chain, k: int) -> None:
    """Let nothing rest on a relation that cannot be."""
    right = chain.sides[k + 1].node
    definitions = state.definitions
    definitions.ranges = [r for r in definitions.ranges if r.right is not right]
    definitions.premises = [p for p in definitions.premises if p.right is not right]


def _against_own_chain(chain: Chain, k: int) -> str | None:
    """Return why a side cannot stand behind an earlier one of its chain, None where it can."""
    right = chain.sides[k + 1].node
    for first in range(k):
        signs = [relation.sign for relation in chain.relations[first : k + 1]]
        left = chain.sides[first].node
        gap = _constant_gap(left, right)
        if gap is None:
            continue
        is_equal = all(sign == "=" for sign in signs)
        is_up = all(sign in _UP for sign in signs) and any(_UP[sign] for sign in signs)
        is_down = all(sign in _DOWN for sign in signs) and any(_DOWN[sign] for sign in signs)
        if (is_equal and not _is_of_turns(gap)) or (is_up and gap >= 0) or (is_down and gap <= 0):
            sign = "=" if is_equal else "<" if is_up else ">"
            shown = f"{plain_text(left)} {sign} {plain_text(right)}"
            return f"with the signs before it {shown} would be so"
    return None


def _is_of_turns(gap: float) -> bool:
    """Tell whether angles that differ by so much are the same: none, one, two turns."""
    return abs(gap / tau - round(gap / tau)) <= _SAME


def _constant_gap(left: Formula, right: Formula) -> float | None:
    """Return by how much two formulas differ for all values of their letters, None where that varies."""
    if not names(left) or names(left) != names(right):
        return None
    if left == right:
        return 0.0
    points = sample_trees([left, right], SymbolValue())
    gaps = [float((first - second).real) for _, (first, second) in points]
    is_constant = len(gaps) > 1 and all(abs(gap - gaps[0]) <= _SAME * (1 + abs(gap)) for gap in gaps)
    return None if not is_constant else 0.0 if abs(gaps[0]) <= _SAME else gaps[0]


def _stronger_than_before(state: JudgingState, chain: Chain, k: int) -> str | None:
    """Return why words draw too much from the range before: from x ≥ y it does not follow that x > y."""
    last = state.sections.chain_before(chain.start)
    sign, left, right = chain.relations[k].sign, chain.sides[k].node, chain.sides[k + 1].node
    if k or last is None or len(last.relations) != 1 or sign not in _STRICT:
        return None
    if not state.sections.is_consequence(chain) or state.sections.opens_case(chain):
        return None
    weak = _STRICT[sign]
    before = last.sides[0].node, last.relations[0].sign, last.sides[1].node
    if before not in ((left, weak, right), (right, _MIRRORED[weak], left)):
        return None
    pair = {left, right}
    if any(r.sign == "≠" and {r.left, r.right} == pair for r in state.definitions.ranges):
        return None
    shown = f"{plain_text(before[0])} {before[1]} {plain_text(before[2])}"
    return f"from {shown} it does not follow: both may be equal"


def _against_run(state: JudgingState, chain: Chain, k: int) -> str | None:
    """Return why a relation cannot be beside those right before it, None where it can."""
    sign, left, right = chain.relations[k].sign, chain.sides[k].node, chain.sides[k + 1].node
    if not (names(left) and names(right)) or sign not in {**_UP, **_DOWN}:
        return None
    run = list(_run_before(state, chain))
    if not run:
        return None
    facts = [fact for each in (*run, chain) for fact in _facts(each, k if each is chain else None)]
    for low, high, strict in _ways(left, sign, right):
        if (path := _path(facts, high, low)) is not None and (strict or any(f[2] for f in path)):
            return "with " + " and ".join(dict.fromkeys(f[3] for f in path)) + " it cannot be"
    return None


Fact = tuple[Formula, Formula, bool, str]
"""A side that is not above another one, whether it is below, and the relation as text."""


def _ways(left: Formula, sign: str, right: Formula) -> Iterator[tuple[Formula, Formula, bool]]:
    if sign in _UP:
        yield left, right, bool(_UP[sign])
    if sign in _DOWN:
        yield right, left, bool(_DOWN[sign])


def _facts(chain: Chain, stop: int | None) -> Iterator[Fact]:
    """Yield what the relations of a chain say, up to one of them."""
    for n, relation in enumerate(chain.relations[:stop]):
        left, right = chain.sides[n].node, chain.sides[n + 1].node
        if names(left) and names(right):
            text = f"{plain_text(left)} {relation.sign} {plain_text(right)}"
            yield from (
                (low, high, strict, text) for low, high, strict in _ways(left, relation.sign, right)
            )


def _path(facts: list[Fact], start: Formula, end: Formula) -> list[Fact] | None:
    """Return the facts that lead up from one side to another, None where none do; strict ones first."""
    ways: dict[tuple[Formula, bool], list[Fact]] = {(start, False): []}
    queue = [(start, False)]
    while queue:
        node, is_strict = queue.pop(0)
        for fact in facts:
            key = (fact[1], is_strict or fact[2])
            if fact[0] == node and key not in ways:
                ways[key] = [*ways[node, is_strict], fact]
                queue.append(key)
    return ways.get((end, True)) or (ways.get((end, False)) if start != end else None)


def _run_before(state: JudgingState, chain: Chain) -> Iterator[Chain]:
    """Yield the relations right before one, with nothing but marks and "and" or "hence" between them."""
    text, last = state.document.text, chain
    if state.sections.opens_case(chain):
        return
    for _ in range(MOST):
        before = state.sections.chain_before(last.start)
        if before is None or last.start - before.end > FARTHEST:
            return
        if not _ONLY_LINKS.fullmatch(text, before.end, last.start):
            return
        is_case = state.sections.opens_case(before)
        if is_case or not state.sections.same_section(before.lines[0], chain.lines[0]):
            return
        if any(side.span[0] in state.refuted for side in before.sides[1:]):
            return
        yield before
        last = before
