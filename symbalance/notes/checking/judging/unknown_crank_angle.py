"""Nothing is accused by an angle of the crank that no letter of a page is declared to be.

So too where a letter is, for all pages of a course, and stands nowhere on this one.

The geometry of a slider-crank is written in θ. Where a page counts its angle by another letter and
nobody says that it is the crank's, a declared β = arcsin(λ sin θ) is of an angle that stands nowhere on
the page, and everything true of the page's own angle would differ from it.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Call, Name, names, walk
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.declared.symbol_roles import KNOWN, letters_by_role, role_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONTRADICTION, REFUTED, UNDECIDED, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain


def unless_angle_unknown(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a refutation by a crank angle that nobody declared is undecided instead."""
    if verdict.verdict not in (REFUTED, CONTRADICTION):
        return verdict
    angle = _undeclared_angle(state, chain.lines[0])
    if not angle or not _rests_on(angle, state, chain, k, verdict):
        return verdict
    others = _other_angles(state, chain.lines[0])
    if _turns_with_time(chain, state) and not others & chain.letters:
        return verdict  # cos ω t, where nothing but the crank turns by a declared ω
    if not others:
        return verdict  # of any angle: what words say of a largest value, or of a dead centre
    if _is_refuted_of_any(angle, others, state, chain, k):
        return verdict
    bare = {name for name in others if "_" not in name and name not in state.integers}
    texts = " or ".join(plain_text(Name(name)) for name in sorted(bare or others))
    reason = f"no letter is declared to be the crank angle: declare whether {texts} is"
    if angle in state.declarations.symbols_at(chain.lines[0]):
        own = plain_text(Name(angle))
        reason = f"{own}, declared to be the crank angle, stands nowhere here: declare whether {texts} is"
    return replace(
        verdict, verdict=UNDECIDED, reason=reason, fix=None, witness={}, differences=(), decision=None
    )


def _undeclared_angle(state: JudgingState, line: int) -> str:
    """Return the geometry's own crank angle where it stands nowhere on the page, else ""."""
    crank = state.knowledge(line).crank
    theta = crank.theta if crank is not None else None
    if not isinstance(theta, Name):
        return ""
    return "" if any(theta.name in chain.letters for chain in state.document.chains) else theta.name


def _turns_with_time(chain: Chain, state: JudgingState) -> bool:
    """Tell whether a relation's waves are of ω t, a speed of the crank and a time that are declared."""
    letters_here = letters_by_role(state.declarations.symbols_at(chain.lines[0]))
    speeds, times = ({*letters_here.get(role, ())} for role in ("angular speed", "time"))
    waves = [
        names(part.argument)
        for side in chain.sides
        for part in walk(side.node)
        if isinstance(part, Call) and part.function in ("sin", "cos")
    ]
    return bool(waves) and all(own & speeds and own & times for own in waves)


def _other_angles(state: JudgingState, line: int) -> set[str]:
    """Return the letters within sines and cosines of a page that may be the crank angle."""
    symbols = state.declarations.symbols_at(line)
    return {name for name in state.turned if role_of(symbols.get(name, "")) not in KNOWN}


def _is_refuted_of_any(angle: str, others: set[str], state: JudgingState, chain: Chain, k: int) -> bool:
    """Tell whether a relation is wrong whatever its angle is: cos 2φ = 2 cos² φ + 1."""
    left, right, line = chain.sides[k], chain.sides[k + 1], chain.lines[0]
    knowledge = state.knowledge(line)
    if chain.has_sum:
        cranks = state.knowledge_of(chain, knowledge).crank_angles
        knowledge = replace(knowledge, crank_angles=cranks)
    values = {**{n: d.node for n, d in knowledge.definitions.items()}, **knowledge.meaning.values}
    turning = {name for name in values if angle in names_behind(Name(name), values)}
    behind = {name for side in (left, right) for name in names_behind(side.node, values)}
    known = knowledge.definitions
    if any(n in known and known[n].is_coefficient for n in behind):
        return False
    if (names(left.node) | names(right.node)) & turning - others:
        return False
    definitions = {n: d for n, d in knowledge.definitions.items() if n not in turning}
    own_values = {n: node for n, node in knowledge.meaning.values.items() if n not in turning}
    meaning = replace(knowledge.meaning, values=own_values)
    free = replace(knowledge, definitions=definitions, meaning=meaning)
    return decide(left, right, chain.relations[k].sign, free).status == REFUTED


def _rests_on(angle: str, state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> bool:
    """Tell whether a relation's sides, or the series that fixed a letter in them, come to an angle."""
    decision = verdict.decision
    forms = [] if decision is None else [f for f in (decision.left, decision.right) if f is not None]
    if any(angle in letters(form) for form in forms):
        return True
    is_of_words = verdict.reason.startswith("if ")  # judged by what words name, in the page's own letters
    return not is_of_words and angle in names_rested_on(state, chain, k)


def names_rested_on(state: JudgingState, chain: Chain, k: int) -> set[str]:
    """Return the letters of a relation, those in their values, and those of the series that fixed one."""
    knowledge = state.knowledge(chain.lines[0])
    definitions = knowledge.definitions
    values = {**{n: d.node for n, d in definitions.items()}, **knowledge.meaning.values}
    sides = (chain.sides[k].node, chain.sides[k + 1].node)
    behind = {name for side in sides for name in names_behind(side, values)}
    rows = {definitions[n].line for n in behind if n in definitions and definitions[n].is_coefficient}
    series = (c for c in state.document.chains if rows.intersection(c.lines))
    behind |= {
        name for c in series for side in c.sides for own in names(side.node)
        for name in (own, *names_behind(Name(own), values))
    }  # fmt: skip
    return behind
