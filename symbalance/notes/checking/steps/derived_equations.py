"""Equations that words derive from one above: a x + b = 0 gives x = b/a is wrong, not a new equation.

A second equation of the same letters may stand beside the first and fix one more of them. Where words say
that it is solved, differentiated or rearranged it adds nothing, and has to be true with the first.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Derivative, Formula, Name, names, walk
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.letters_in_waves import letters_in_waves
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.premises.system import Premise
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

LONGEST = 60
"""Characters before an equation in which words say that it is derived."""
_DERIVED = re.compile(
    r"(?<![A-Za-zÀ-ÿ\\])(?:gives?|giving|yields?|yielding|get|obtain(?:ed|s)?|find|follows?|implies|implying|means"
    r"|results?|so|hence|thus|therefore|then|whence|consequently|accordingly|that\s+is|i\.?\s?e\.?|solutions?|solved?"
    r"|solving|rearrang\w+|different\w+|derivative|squaring|dividing|multiplying|integrat\w+|from\s+(?:this|which|it)"
    r"|ergibt|liefert|folgt|erhält|erhalten|bekommt|also|daher|somit|damit|mithin|folglich|demnach|heißt|d\.\s?h\."
    r"|Lösung|aufgelöst|umgestellt|[aA]bleit\w+|abgeleitet|differenzier\w+|quadrier\w+|donne|donc|d'où|solution)"
    r"(?![A-Za-zÀ-ÿ])|\\(?:Rightarrow|implies|Longrightarrow|therefore)(?![A-Za-z])|[⇒⟹∴]"
    r"|よって|したがって|従って|ゆえに|故に|微分|解くと|より|から",
    re.IGNORECASE,
)
_GIVEN = re.compile(
    r"(?<![A-Za-zÀ-ÿ])(?:with|from|using|by|since|because|as|mit|aus|wegen|da|avec|de)[\s$\\(\[]*$",
    re.IGNORECASE,
)
_ONLY_MARKS = re.compile(r"[\s$.:,)\]\\]*(?:we\s+have|is|gilt|ist|wird)?[\s$.:,(\[\\]*")


def decide_derived(
    state: JudgingState,
    chain: Chain,
    k: int,
    as_step: Decision,
    knowledge: Knowledge,
    *,
    is_following: bool,
) -> Decision | None:
    """Return the decision on an equation of letters that one above connects, None where it may be new.

    `as_step` is that on it with the letter that the equation above fixes put in; `is_following` tells
    that it follows from all equations above together. Letters behind those of the equation count where
    words say that it follows: u b = M/2 gives u in the letters of M.
    """
    if as_step.status != REFUTED or is_following:
        return None
    own = _letters(chain.sides[k].node, chain.sides[k + 1].node)
    line = chain.lines[0]
    values = {name: d.node for name, d in knowledge.definitions.items()}
    head = chain.sides[0].node
    behind = {
        p.line: p.names.union(*({*names_behind(values[n], values)} for n in p.names & values.keys()))
        for p in state.definitions.premises_at(line)
        if isinstance(head, Name) and head.name in p.names
    }
    premises = [p for p in state.definitions.premises_at(line) if p.line <= line]
    above = [p for p in premises if own <= p.names or own <= behind.get(p.line, frozenset())]
    if k or not above or len(chain.relations) > 1:
        return None
    premise = above[-1]
    reason = f"does not follow from {premise.text} of line {premise.line}"
    if _is_said_to_follow(state, chain, premise):
        return replace(as_step, reason=as_step.reason or reason)
    if not own <= premise.names:
        return None
    if isinstance(head, Name) or _turned_letters(chain, k) & _free(as_step):
        return Decision(UNDECIDED, f"{reason}, of whose letters it has no others: say what it fixes")
    return None


def _letters(*nodes: Formula) -> frozenset[str]:
    """Return the letters of formulas but those by which they are differentiated."""
    parts = [part for node in nodes for part in walk(node)]
    times = {part.variable.name for part in parts if isinstance(part, Derivative)}
    return frozenset(name for node in nodes for name in names(node)) - times


def _free(decision: Decision) -> frozenset[str]:
    return frozenset(
        n for form in (decision.left, decision.right) if form is not None for n in letters(form)
    )


def _turned_letters(chain: Chain, k: int) -> frozenset[str]:
    """Return the letters within sines and cosines of a relation."""
    return letters_in_waves(chain.sides[k].node) | letters_in_waves(chain.sides[k + 1].node)


def _is_said_to_follow(state: JudgingState, chain: Chain, premise: Premise) -> bool:
    """Tell whether words lead from an equation to one of its letters: hence, gives, with …:"""
    text, start = state.document.text, chain.start
    before = [c for c in state.document.chains if c.relations and c.end <= start]
    last = max(before, key=lambda c: c.end, default=None)
    if last is None:
        return False
    between = text[max(last.end, start - LONGEST) : start]
    if _DERIVED.search(between):
        return True
    is_next = premise.line in last.lines
    return (
        is_next
        and _ONLY_MARKS.fullmatch(between) is not None
        and bool(_GIVEN.search(text[max(0, last.start - LONGEST) : last.start]))
    )
