"""Sums of angles γ_k whose sentence says other ones than the page has given: γ_k only 0° and 180°.

What γ_1, γ_2, … were above is another crankshaft's then.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Summation, names, parts_of_kind
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.words.crank_angles_listed import CrankAngles
from symbalance.notes.reading.equations import Chain


def with_cranks_of_sentence(
    chain: Chain, before: Chain | None, listed: CrankAngles | None, knowledge: Knowledge
) -> tuple[Knowledge, CrankAngles | None]:
    """Return what is known and the crank angles listed for a relation's sums, without former angles.

    `before` is the relation above, behind which the sentence begins. A list of fewer angles than there
    are cranks says only which ones occur, and none of them is known then.
    """
    start = before.end if before is not None else 0
    if listed is None or not chain.has_sum or not start <= listed.place < chain.start:
        return knowledge, listed
    sums = (part for side in chain.sides for part in parts_of_kind(side.node, Summation))
    bases = {name.rpartition("_")[0] for part in sums if part.index for name in names(part.body)}
    former = {
        name
        for name in knowledge.definitions
        if name.rpartition("_")[0] in bases and name.rpartition("_")[2].isdigit()
    }
    if not former:
        return knowledge, listed
    others = {name: d for name, d in knowledge.definitions.items() if name not in former}
    is_whole = len(listed.degrees) >= len(former)
    return replace(knowledge, definitions=others), listed if is_whole else None
