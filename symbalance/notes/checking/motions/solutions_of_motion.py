"""Solutions of equations of motion, put back: m ẍ + k x = F cos Ωt is solved by F cos Ωt/(k - m Ω²).

Words have to say that a motion is the solution: with other letters it may be one that is tried.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Derivative,
    Formula,
    Name,
    Number,
    Power,
    Product,
    Sum,
    names,
    parts_of_kind,
)
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision, decide_equality
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.motions.equations_of_motion import EquationOfMotion
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_SOLUTION = re.compile(
    r"(?<![A-Za-zÀ-ÿ])(?:solution|solved\s+by|solves|satisfied\s+by|Lösung|gelöst\s+durch|löst)(?![A-Za-zÀ-ÿ])|解",
    re.IGNORECASE,
)
_INTEGRATED = re.compile(
    r"(?<![A-Za-zÀ-ÿ])(?:integrat(?:ing|ion|ed)|[Ii]ntegriert|Integrieren|intégr\w+|integrando"
    r"|steady(?:[\s-]state)?|stationär\w*|eingeschwungen\w*|régime\s+(?:permanent|établi))(?![A-Za-zÀ-ÿ])"
    r"|積分|定常",
    re.IGNORECASE,
)
"""Words of a motion, a formula of the time, that the equation above leads to."""
_TRIED = re.compile(
    r"(?<![A-Za-zÀ-ÿ])(?:tr(?:y|ies|ied|ial)|assum\w*|ansatz|guess\w*|look\w*|sought|seek|approx\w*|form|suppos\w*|not"
    r"|small|weak\w*|light\w*|slight\w*|neglect\w*|klein\w*|schwach\w*|vernachl\w*"
    r"|without|undamped|would|ohne|ungedämpft\w*|wäre\w*|sans|serait"
    r"|Lösungsansatz|gesucht\w*|angenommen|angenähert|Näherung\w*|nicht|kein\w*)(?![A-Za-zÀ-ÿ])|仮定|近似",
    re.IGNORECASE,
)
_TIME = Name("t")
_ZERO = Number(Fraction(0))


def decide_motion_solution(
    chain: Chain, k: int, equations: Sequence[EquationOfMotion], words: str, knowledge: Knowledge
) -> Decision | None:
    """Return whether a motion satisfies the equation above that `words` say it solves, None for others.

    One with a letter that the equation lacks, which may have to be chosen, is proved or left open; but no
    amplitude of a free vibration makes A cos 2ωt one where ω is its frequency.
    """
    head, value = chain.sides[k].node, chain.sides[k + 1].node
    if k or not isinstance(head, Name) or chain.relations[0].sign != "=" or head.name in names(value):
        return None
    above = [equation for equation in equations if equation.moving == {head.name}]
    is_said = _SOLUTION.search(words) or (_TIME.name in names(value) and _INTEGRATED.search(words))
    if not above or not is_said or _TRIED.search(words):
        return None
    equation = above[-1]
    solution = Definition(value, chain.lines[0])
    there = replace(knowledge, definitions={**knowledge.definitions, head.name: solution})
    decision = decide_equality(_left_side(equation), _ZERO, there)
    if decision.is_proved:
        return Decision(
            PROVED, f"solves {equation.text} of line {equation.line}", assumptions=decision.assumptions
        )
    if decision.status != REFUTED:
        return None
    free = {n for form in (decision.left, decision.right) if form is not None for n in letters(form)}
    own = equation.letters | names(equation.rest) | {_TIME.name}
    is_free = equation.rest == _ZERO and _rates_of_arguments(value) <= own
    if not free <= own and not is_free:
        return None
    return replace(decision, reason=f"does not satisfy {equation.text} of line {equation.line}")


def _rates_of_arguments(motion: Formula) -> frozenset[str]:
    """Return the letters that the time has as factors in waves and exponents: ω of A cos(ωt + ε)."""
    arguments = [part.argument for part in parts_of_kind(motion, Call)]
    arguments += [part.exponent for part in parts_of_kind(motion, Power) if names(part.exponent)]
    terms = (t for a in arguments for t in (a.terms if isinstance(a, Sum) else (a,)))
    return frozenset[str]().union(*(names(term) for term in terms if _TIME.name in names(term)))


def _left_side(equation: EquationOfMotion) -> Formula:
    """Return an equation's terms, which are to be zero together."""
    terms = (
        Product((factor, Derivative(Name(name), _TIME, order) if order else Name(name)))
        for (name, order), factor in equation.factors.items()
    )
    return Sum((*terms, equation.rest))
