"""Values for which an equation is said to hold: cos θ = sin θ for θ = 45°; z² = -4, so z = ±2i.

An equation of one letter may be a condition; with a value right behind it, it is a claim for that value.
Every further value in that breath has to satisfy it, and so do roots that are complex numbers.
"""

from __future__ import annotations

from symbalance.document.formula import (
    Constant,
    Formula,
    Name,
    PlusMinus,
    names,
    walk,
)
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.checking.deciding.branches import with_sign
from symbalance.notes.checking.deciding.cases import NO_VALUES
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.premises.angles_at import solves_as_printed
from symbalance.notes.checking.premises.conditions_behind import values_behind
from symbalance.notes.checking.premises.system import Premise
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, CONTRADICTION, DEFINITION, PREMISE, Verdict
from symbalance.notes.checking.verdicts import REFUTED as REFUTED_WORD
from symbalance.notes.checking.words.joined_numbers import joined_numbers
from symbalance.notes.checking.words.lists_of_data import sets_number
from symbalance.notes.checking.words.plain_formulas import lone_side, plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_LEADS = re.compile(
    r"(?:[\s$,:]|(?<![^\W\d_])(?:holds?|is\s+(?:true|satisfied)|gilt|est\s+vraie?|vaut|vale|for|at|if|when|only|and|für|bei|wenn|nur|und|pour|à|si|per|se|para"
    r"|has|have|hat|a|ha|tiene|with|the|two|three|four|real|complex|imaginary|purely|die|zwei|drei|vier|komplexen?|reellen?|rein|imaginären?|les|deux|trois|complexes?"
    r"|imaginaires?|le|due|tre|complesse|las|dos|tres|complejas|solutions?|roots?|zeros?|values?|lösung(?:en)?|nullstellen?|wurzeln?|racines?|soluzion[ei]|radic[ei]"
    r"|soluci(?:ón|ones)|raíz|raíces|are|is|sind|ist|sont|est|sono|è|son|es|so|hence|gives?|thus|that|also|daher|folgt|donc|quindi|luego|we|get|by|of|conjugate)"
    r"(?![^\W\d_])|の解は|の複素数解は)*",
    re.IGNORECASE,
)
"""Between an equation and the first value for which it is said to hold, or its first root."""
_COMPLEX = re.compile(
    r"(?<![^\W\d_])(?:complex|imaginary|conjugate|komplex\w*|imaginär\w*|konjugiert\w*|complexe?s?|imaginaires?|conjugu\w+|compless\w+|immaginari\w*|complej\w+"
    r"|imaginari\w+)(?![^\W\d_])|複素|虚数",
    re.IGNORECASE,
)
_UNITS = ("i", "j")
_ANOTHER = ("a new case", "of another", "another case")
_REACH = 90


def unless_value_fails(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a value for which an equation is said to hold, or a root, has to satisfy it."""
    if k or len(chain.relations) != 1 or chain.relations[0].sign not in "=≈":
        return verdict
    head = chain.sides[0].node
    if verdict.verdict == REFUTED_WORD and (verdict.reason or "").startswith(NO_VALUES):
        is_complex = _has_complex_roots(state, chain)
        reason = "to be solved in complex numbers"
        return describe(state.document, chain, k, Decision(CONDITION, reason)) if is_complex else verdict
    if verdict.verdict == CONDITION and not isinstance(head, Name):
        return _at_value_behind(state, chain, verdict)
    if not isinstance(head, Name) or not _is_value(chain):
        return verdict
    is_new = verdict.verdict == PREMISE and verdict.reason.startswith(_ANOTHER)
    is_stated = verdict.verdict in (DEFINITION, PREMISE, CONDITION, CONTRADICTION)
    is_open = is_new or (is_stated and _is_complex(chain.sides[1].node))
    decision = _as_root(state, chain, head) if is_open else None
    return verdict if decision is None else describe(state.document, chain, k, decision)


def _is_value(chain: Chain) -> bool:
    """Tell whether a relation gives a letter a number, be it a complex one."""
    return names(chain.sides[1].node) <= {*_UNITS}


def _is_complex(node: Formula) -> bool:
    """Tell whether a number has the imaginary unit in it."""
    has_unit = any(isinstance(part, Constant) and part.name == "i" for part in walk(node))
    return has_unit or bool(names(node))


def _equation_of(chain: Chain) -> str:
    """Return the only letter of an equation of one letter, "" for any other relation."""
    is_one = len(chain.relations) == 1 and chain.relations[0].sign == "="
    own = names(chain.sides[0].node) | names(chain.sides[1].node)
    is_given = any(isinstance(side.node, Name) for side in chain.sides) and not all(
        names(side.node) for side in chain.sides
    )
    return next(iter(own)) if is_one and len(own) == 1 and not is_given else ""


def _has_complex_roots(state: JudgingState, chain: Chain) -> bool:
    """Tell whether words, or the roots right behind an equation, say that its roots are complex."""
    name, text = _equation_of(chain), state.document.text
    below = next(state.sections.chains_behind(chain.start), None)
    if not name or below is None or below.start - chain.end > _REACH:
        return False
    words = text[chain.end : below.start]
    stem = below.sides[0].node.name.partition("_")[0] if isinstance(below.sides[0].node, Name) else ""
    is_root = stem == name and len(below.relations) == 1 and _is_value(below)
    return is_root and (_is_complex(below.sides[1].node) or _COMPLEX.search(words) is not None)


def _at_value_behind(state: JudgingState, chain: Chain, verdict: Verdict) -> Verdict:
    """Return the verdict on an equation; refuted where a value right behind it does not satisfy it."""
    name = _equation_of(chain)
    for letter, value in values_behind(chain, state.document) if name else ():
        if letter == name and _satisfies(state, chain, name, value) is False:
            reason = f"not for {plain_text(Name(name))} = {state.document.source(value.span)}"
            return describe(state.document, chain, 0, Decision(REFUTED, reason))
    return verdict


def _as_root(state: JudgingState, chain: Chain, head: Name) -> Decision | None:
    """Return whether a value satisfies the equation of whose values or roots it is one, None for none."""
    sections, text = state.sections, state.document.text
    stem = head.name.partition("_")[0]
    givers = [c for c in sections.in_order if c.start <= chain.start and _is_giver(c, stem)]
    joined = joined_numbers(text, givers)
    first = givers[-1] if joined is None else givers[joined.first]
    equation = sections.chain_before(first.start)
    if equation is None or equation.end > first.start or _equation_of(equation) not in (head.name, stem):
        return None
    if _LEADS.fullmatch(text, equation.end, first.start) is None:
        return None
    is_root = _satisfies(state, equation, _equation_of(equation), chain.sides[1].node)
    line = equation.lines[0]
    if is_root is None:
        return None
    if not is_root:
        return Decision(REFUTED, f"does not satisfy line {line}")
    return Decision(PROVED, f"satisfies line {line}")


def _is_giver(chain: Chain, stem: str) -> bool:
    """Tell whether a relation gives a root of a letter, with an index or without."""
    head = chain.sides[0].node
    is_plain = len(chain.relations) == 1 and isinstance(head, Name)
    is_value = is_plain and (sets_number(chain) or (_is_value(chain) and chain.relations[0].sign == "="))
    return is_value and isinstance(head, Name) and head.name.partition("_")[0] == stem


def _satisfies(state: JudgingState, equation: Chain, name: str, value: Formula) -> bool | None:
    """Tell whether a number satisfies an equation of one letter; None where that is open."""
    left, right = (side.node for side in equation.sides)
    has_signs = any(isinstance(part, PlusMinus) for part in walk(value))
    each = [with_sign(value, sign) for sign in (1, -1)] if has_signs else [value]
    found = [_satisfies_one(state, equation, (left, right), name, one) for one in each]
    if False in found:
        return False
    return None if None in found else True


def _satisfies_one(
    state: JudgingState, equation: Chain, sides: tuple[Formula, Formula], name: str, value: Formula
) -> bool | None:
    line = equation.lines[0]
    try:
        if not _is_complex(value):
            return solves_as_printed(Premise(*sides, line), name, value, Knowledge())
        if decimals(value):
            return None
        for unit in names(value):
            value = substitute(value, unit, Constant("i"))
        left, right = (lone_side(substitute(side, name, value)) for side in sides)
        there = decide(left, right, "=", Knowledge())
    except (NoFormError, TooLargeError):
        return None
    return True if there.is_proved else False if there.status == REFUTED else None
