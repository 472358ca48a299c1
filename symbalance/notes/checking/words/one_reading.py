"""One reading of 1/2x in a document: as 1/(2x) or as (1/2)x, whichever makes more of it right.

Usage differs, so the reader offers both; an author means one. The document is judged in each, the reading
with fewer lines that are wrong is taken throughout and said, and where the other one would change a
verdict, that is said there.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import pairwise

from symbalance.document.formula import Formula, Name, Number, Product, Quotient, Sum, walk
from symbalance.notes.checking.verdicts import FAILING, Checked, Verdict
from symbalance.notes.reading.equations import Chain, ReadNotes, Side

LETTER, BRACKET = "letter", "bracket"
INSIDE, OUTSIDE = "inside", "outside"
USUAL = {LETTER: INSIDE, BRACKET: OUTSIDE}
"""1/2x is usually 1/(2x), and 1/2(a + b) a half of the bracket."""
_SHOWN = {
    (LETTER, INSIDE): "1/2x is read as 1/(2x)",
    (LETTER, OUTSIDE): "1/2x is read as (1/2)x",
    (BRACKET, INSIDE): "1/2(a + b) is read as 1/(2(a + b))",
    (BRACKET, OUTSIDE): "1/2(a + b) is read as (1/2)(a + b)",
}
Use = tuple[str, str]


def judge_in_one_reading(document: ReadNotes, judge: Callable[[ReadNotes], Checked]) -> Checked:
    """Return the verdicts on a document in which every 1/2x is read alike."""
    kinds = {kind for chain in document.chains for side in chain.sides for kind in doubtful(side)}
    if not kinds:
        return judge(document)
    usual = judge(_restricted(document, {kind: USUAL[kind] for kind in kinds}))
    choice = {kind: USUAL[kind] for kind in kinds}
    others: dict[str, Checked] = {}
    for kind in sorted(kinds):
        uses = {k: _other(USUAL[k]) if k == kind else USUAL[k] for k in kinds}
        others[kind] = judge(_restricted(document, uses))
        lines = {line for chain in document.chains if kind in _doubts(chain) for line in chain.lines}
        if _failures(others[kind], lines) < _failures(usual, lines):
            choice[kind] = uses[kind]
    chosen = usual
    changed = [kind for kind in kinds if choice[kind] != USUAL[kind]]
    if changed:
        is_one = len(changed) == 1
        chosen = others[changed[0]] if is_one else judge(_restricted(document, choice))
        others |= dict.fromkeys(changed, usual)
    notes = tuple(_SHOWN[kind, choice[kind]] for kind in sorted(kinds))
    verdicts = tuple(_with_other_reading(verdict, choice, others) for verdict in chosen.verdicts)
    return Checked(replace(document, notes=(*document.notes, *notes)), verdicts)


def _with_other_reading(verdict: Verdict, choice: dict[str, str], others: dict[str, Checked]) -> Verdict:
    """Return a verdict with what it would be, were 1/2x read the other way."""
    for kind, checked in others.items():
        same = (v for v in checked.verdicts if (v.line, v.link) == (verdict.line, verdict.link))
        other = next(same, None)
        if other is not None and other.verdict != verdict.verdict:
            words = _SHOWN[kind, _other(choice[kind])].replace("is read as", "read as")
            note = f"{words}, it would be: {other.verdict.replace('_', ' ')}"
            return replace(verdict, notes=(*verdict.notes, note))
    return verdict


def _failures(checked: Checked, lines: set[int]) -> int:
    return sum(v.verdict in FAILING and v.line in lines for v in checked.verdicts)


def _other(where: str) -> str:
    return OUTSIDE if where == INSIDE else INSIDE


def _restricted(document: ReadNotes, choice: dict[str, str]) -> ReadNotes:
    """Return a document without the readings that go against a choice."""
    chains = (
        replace(chain, sides=tuple(_restricted_side(side, choice) for side in chain.sides))
        for chain in document.chains
    )
    return replace(document, chains=tuple(chains))


def _restricted_side(side: Side, choice: dict[str, str]) -> Side:
    against = {(kind, _other(choice[kind])) for kind in doubtful(side) if kind in choice}
    readings = tuple(node for node in side.readings if not against & slash_uses(node))
    return replace(side, readings=readings) if readings and len(readings) < len(side.readings) else side


def _doubts(chain: Chain) -> set[str]:
    return {kind for side in chain.sides for kind in doubtful(side)}


def doubtful(side: Side) -> set[str]:
    """Return the kinds of slash that a side's readings take in both ways."""
    if len(side.readings) < 2:
        return set()
    uses = {use for node in side.readings for use in slash_uses(node)}
    return {kind for kind in (LETTER, BRACKET) if {(kind, INSIDE), (kind, OUTSIDE)} <= uses}


def slash_uses(node: Formula) -> set[Use]:
    """Return how a tree takes what follows a slash and a number at once: 1/2x, 1/2(a + b)."""
    return set(_uses(node))


def _uses(node: Formula) -> Iterator[Use]:
    for part in walk(node):
        if isinstance(part, Quotient) and isinstance(part.denominator, Product):
            below = part.denominator
            is_bare = below.span[0] == below.factors[0].span[0]
            if is_bare and _is_slash(part) and isinstance(below.factors[0], Number):
                yield _kind(below.factors[1]), INSIDE
        if isinstance(part, Product):
            for first, second in pairwise(part.factors):
                if _is_slash(first) and first.span[1] == second.span[0]:
                    yield _kind(second), OUTSIDE


def _is_slash(node: Formula) -> bool:
    """Tell a/2 from \\frac{a}{2}, whose command stands before its numerator."""
    if not isinstance(node, Quotient) or node.span[0] != node.numerator.span[0]:
        return False
    return isinstance(node.denominator, Number | Product)


def _kind(node: Formula) -> str:
    is_letter = isinstance(node, Name) or (not isinstance(node, Sum) and node.span[1] - node.span[0] == 1)
    return LETTER if is_letter else BRACKET
