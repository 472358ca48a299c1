"""An angle's value in a sentence, "at θ = 90° the force is": a case, whatever it was solved for before.

An equation further up, cos θ = 0.2247 for the largest speed, fixes the angle where that was asked for. It
says nothing of the next example, or of what stands in a later paragraph. Nor does 360° - γ = 315°, of one
V-twin, say anything of the next: for γ = 52°.
"""

from __future__ import annotations

from symbalance.document.formula import Constant, Formula, names, walk
from symbalance.notes.algebra.letters_in_waves import letters_in_waves
from symbalance.notes.checking.deciding.equality import UNDECIDED, Decision
from symbalance.notes.checking.premises.definitions import Definitions
from symbalance.notes.checking.verdicts import PREMISE
from symbalance.notes.reading.equations import Chain

ANOTHER_ANGLE = "a case: the angle before was another question's"


def case_of_angle(definitions: Definitions, name: str, value: Formula, chain: Chain) -> Decision | None:
    """Return the decision on an angle's number that equations above contradict; None where they may.

    In a later section it is a case unless words say that it follows, in a later paragraph where words
    such as "at" introduce it. In the paragraph of the equation such words may claim its solution.
    """
    sections, line = definitions.sections, chain.lines[0]
    premises = [p for p in definitions.premises_at(line) if name in p.names]
    nodes = [node for p in premises for node in (p.left, p.right)]
    is_angle = any(part == Constant("pi") for part in walk(value))  # 52°, of γ in 360° - γ = 315°
    is_angle = is_angle or any(name in letters_in_waves(node) for node in nodes)
    if not premises or names(value) or not chain.inline or not is_angle:
        return None
    if sections.is_consequence(chain):
        return None
    last = max(p.line for p in premises)
    is_introduced = sections.opens_case(chain)
    if not sections.same_section(last, line) or (is_introduced and sections.paragraph_start(line) > last):
        return Decision(PREMISE, ANOTHER_ANGLE)
    if is_introduced:
        return Decision(UNDECIDED, f"another case, or a solution of line {last} that is none: say which")
    return None
