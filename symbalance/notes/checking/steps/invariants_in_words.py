"""States of one process, of which words or "const" say what stays the same: p V^κ = const, p₂ = p₁ ε^κ.

The product has the same value with the letters of the one state as with those of the other; the ratio of
two of them stands in the same paragraph, ε = V₁/V₂. What a formula gives for the second state has to fit.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

from symbalance.document.formula import Formula, Name, names
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.deciding.values_at_points import solved_at, value_at
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, DEFINITION, PREMISE, UNDECIDED, Verdict
from symbalance.notes.checking.words.formulas_typed import formula_typed
from symbalance.notes.reading import ReadingError, read_equation
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_JUDGED = (CONDITION, DEFINITION, PREMISE, UNDECIDED)
_CONSTANT = (
    r"(?:constant[es]?|const\.?|konstant\w*|konst\.?|costante|constante|invariable|unchanged|the\s+same"
    r"|conserved|unverändert|erhalten|conservée?|conservat[ao]|conservad[ao])"
)
_STAYS = re.compile(
    r"\$(?P<product>[^$=<>≈]{2,60})\$[\s,)]*(?:(?:is|are|stays?|remains?|keeps?|ist|bleibt|sind|bleiben|est|reste|demeure|è|rimane|resta|es|permanece|se\s+mantiene|being|then|always|stets|immer"
    rf"|dabei|toujours|sempre|siempre)\s+){{1,3}}{_CONSTANT}|\$(?P<equated>[^$=<>≈]{{2,60}})=\s*(?:\\(?:mathrm|text|textrm|mathit|operatorname|mbox|rm)\s*\{{?\s*)?[Kk]?[Cc]?onst"
    r"|\$(?P<japanese>[^$=<>≈]{2,60})\$\s*(?:は|が)[^。$]{0,10}(?:一定|保存)",
    re.IGNORECASE,
)
"""A product of which a sentence says that it stays the same, or that equals const."""
_OTHER_PROCESS = re.compile(
    r"isochor|isobar|isotherm|heat|combust|expan[ds]\w*\s+again|throttl|Verbrennung|Wärmezufuhr|chaleur|combustion|calore|calor|等温|等圧|等容|燃焼",
    re.IGNORECASE,
)
_EQUATION = re.compile(r"\$([^$=<>≈]{1,40}_[^$=<>≈]{1,40}=[^$=<>≈]{1,40})\$")
_LETTER = re.compile(r"[A-Za-z]_[0-9]")
_FEWEST = 2
"""Letters of a product that stays the same."""
_NEAR = 700
_CLOSE = 1e-6
_INDEX = re.compile(r"(?P<base>[^_]+)_(?P<index>[0-9a-zA-Z]{1,3})")
_POINTS = ((1.3, 2.1, 1.7, 2.6, 3.4), (2.2, 1.4, 3.1, 1.6, 1.2), (3.7, 1.2, 1.35, 1.9, 2.5))


@dataclass(frozen=True, slots=True)
class _States:
    """Two states that a formula connects: what is the same in both, and the equations of their ratios."""

    same: tuple[Formula, Formula]
    ratios: tuple[tuple[Formula, Formula], ...]


def unless_against_what_stays(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; that on a letter of a second state by what words say to stay the same."""
    head, right = chain.sides[0].node, chain.sides[1].node
    match = _INDEX.fullmatch(head.name) if isinstance(head, Name) else None
    if k or verdict.verdict not in _JUDGED or match is None or not isinstance(head, Name):
        return verdict
    if not names(right) or chain.relations[0].sign != "=" or _OTHER_PROCESS.search(_words(state, chain)):
        return verdict
    states = _states(state, chain, head.name, names(right))
    outcomes = [] if states is None else [*_outcomes(states, head.name, right)]
    if len(outcomes) < len(_POINTS):
        return verdict
    if all(outcomes):
        by_words = Decision(PROVED, assumptions=("what stays the same by the words above",))
        return describe(state.document, chain, k, by_words)
    if any(outcomes):
        return verdict
    state.definitions.forget(head.name, chain.lines[0])
    reason = "does not follow from what stays the same above"
    return describe(state.document, chain, k, Decision(REFUTED, reason))


def _words(state: JudgingState, chain: Chain) -> str:
    """Return the paragraph of a relation before it."""
    sections = state.sections
    first = sections.start_of_line(sections.paragraph_start(chain.lines[0]))
    start = max(min(first, chain.start), chain.start - _NEAR)
    return state.document.text[start : chain.start]


def _states(state: JudgingState, chain: Chain, head: str, own: frozenset[str]) -> _States | None:
    """Return what connects the two states of a formula; None where the paragraph does not say it."""
    text = _words(state, chain)
    found = [m["product"] or m["equated"] or m["japanese"] for m in _STAYS.finditer(text)]
    base, index = head.split("_", 1)
    others = {n.split("_", 1)[1] for n in own if n.startswith(f"{base}_")}
    if not found or len(others) != 1 or others == {index}:
        return None
    other = others.pop()
    ratios = [*_ratios(state, chain, text)]
    letters = own | {head} | {n for ratio in ratios for node in ratio for n in names(node)}
    bases = {n.split("_", 1)[0] for n in letters}
    same: list[tuple[Formula, Formula]] = []
    for typed in found:
        product = formula_typed(typed, frozenset(bases))
        if product is None or base not in names(product) or len(names(product)) < _FEWEST:
            continue
        first = second = product
        for name in names(product):
            if {f"{name}_{index}", f"{name}_{other}"} <= letters:
                first = substitute(first, name, Name(f"{name}_{index}"))
                second = substitute(second, name, Name(f"{name}_{other}"))
        same.append((first, second))
    if len(same) != 1:
        return None
    return _States(same[0], tuple(ratios))


def _ratios(state: JudgingState, chain: Chain, text: str) -> Iterator[tuple[Formula, Formula]]:
    """Yield the equations of a paragraph before a relation that have letters with an index.

    Where the page's reading has none, from $V_1$ to $V_2 = V_1/r$, they are read where they are typed.
    """
    here = state.sections.chains_between(chain.start - len(text), chain.start)
    single = [c for c in here if len(c.relations) == 1 and c.relations[0].sign == "="]
    of_states = [c for c in single if "_" in "".join(c.letters)]
    yield from (
        (c.sides[0].node, c.sides[1].node) for c in of_states if c.sides[1].span[0] not in state.refuted
    )
    for match in _EQUATION.finditer(text) if not of_states else ():
        try:
            read = read_equation(match[1], frozenset(chain.letters | {*_LETTER.findall(match[1])}))
        except ReadingError:
            continue
        if len(read.sides) == 2:
            yield read.sides[0].node, read.sides[1].node


def _outcomes(states: _States, head: str, right: Formula) -> Iterator[bool]:
    """Yield at some points whether a formula is what the second state has there."""
    own = sorted(names(right))
    needed = (names(states.same[0]) | names(states.same[1])) - {head}
    for point in _POINTS:
        if len(own) > len(point):
            return
        values = dict(zip(own, point, strict=False))
        claimed = value_at(right, values)
        free = sorted(needed - values.keys())
        for name in free:
            ratio = next((r for r in states.ratios if name in names(r[0]) | names(r[1])), None)
            if ratio is None:
                return
            unknown = (names(ratio[0]) | names(ratio[1])) - values.keys()
            for extra in sorted(unknown - {name}):
                values[extra] = 1.45  # any: only the ratio counts
            solved = solved_at(ratio, name, values) if name not in values else values[name]
            if solved is None:
                return
            values[name] = solved
        exact = solved_at(states.same, head, values)
        if claimed is None or exact is None:
            return
        yield math.isclose(claimed, exact, rel_tol=_CLOSE)
