"""Largest values of motions that nobody declared: ẋ_max ≈ r ω (1 + ε²/2) of a displacement x."""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Name, names
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.declared.symbol_roles import role_of
from symbalance.notes.checking.meant.meant_quantities import MeantQuantities
from symbalance.notes.checking.meant.meant_words import NOBODY, USUAL_END
from symbalance.notes.checking.motions.extremes import decide_extreme, decide_place
from symbalance.notes.reading.equations import Chain, ReadNotes


def decide_meant_extreme(
    meant: MeantQuantities, chain: Chain, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    """Decide what a line says of the extreme of a motion that words or its formula name; None if nothing.

    The direction of such a motion is not known: it is refuted where it is wrong in both.
    """
    left, right, sign = chain.sides[0], chain.sides[1], chain.relations[0].sign
    if not isinstance(left.node, Name) or knowledge.knows(left.node.name):
        return None
    refuted: Decision | None = None
    for known, texts in meant.motions(left.node.name, chain, knowledge):
        decision = decide_extreme(left, right, sign, known)
        if decision is None:
            return None
        decision = decide_place(decision, chain, document, known)
        if decision.is_proved:
            return replace(decision, assumptions=(*texts, *decision.assumptions))
        is_guess = any(text.endswith(USUAL_END) and text not in meant.shown for text in texts)
        if decision.status != REFUTED or is_guess:
            return None
        refuted = replace(decision, reason=f"{decision.reason}, if {'; '.join(texts)}")
    return refuted


def decide_declared_extreme(
    meant: MeantQuantities, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return the proof of a line whose words say that it gives the largest value of a declared motion.

    "The largest acceleration is a = r ω² (1 + λ)", where a is declared for every angle: the words say of
    the letter what they would say of one that nobody declared.
    """
    name = chain.sides[0].node
    if k or not isinstance(name, Name) or name.name not in knowledge.moving:
        return None
    named = meant.words.named(name.name, chain)
    role = role_of(knowledge.meanings.get(name.name, ""))
    own = names(chain.sides[1].node)
    if named is None or not named.is_largest or named.role != role or own & knowledge.angles:
        return None
    values = {n: node for n, node in knowledge.meaning.values.items() if n != name.name}
    meanings = {n: text for n, text in knowledge.meanings.items() if n != name.name}
    unsaid = replace(
        knowledge,
        meaning=replace(knowledge.meaning, values=values),
        meanings=meanings,
        letters=knowledge.letters - {name.name},
        moving=knowledge.moving - {name.name},
    )
    decision = meant.judge(chain, k, unsaid)
    if not isinstance(decision, Decision) or not decision.is_proved:
        return None
    texts = tuple(text.replace(f"{NOBODY}; ", "") for text in decision.assumptions)
    return replace(decision, assumptions=texts)
