"""Values of one moment are no constants: at θ = 90° M = 400 N m, and the mean of M is another.

In a derivative or an integral a letter that has its number at one place of the crank, at one time or as
its greatest value is not known: it runs there.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Derivative, Integral, Name, names, parts_of_kind
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_MOMENT = re.compile(
    r"(?<![^\W\d_])(?:peak|maxim(?:um|al|ale|o|a)?|greatest|largest|highest|instantaneous|momentary|größte[nrsm]?|höchste[nrsm]?"
    r"|augenblicklich\w*|momentan\w*|massim[oaie]|máxim[oa]s?|maximale?s?)(?![^\W\d_])|最大|瞬間"
    r"|(?<![^\W\d_])(?:at|zur\s+Zeit|bei|à|a)\s[\s$]*t\s?=\s?0",
    re.IGNORECASE,
)
"""Words for one value of what runs."""


def without_moments(chain: Chain, sections: Sections, knowledge: Knowledge) -> Knowledge:
    """Return what is known without the numbers of one moment that a derivative or an integral is of."""
    bodies = [
        part.expression if isinstance(part, Derivative) else part.body
        for side in chain.sides
        for part in parts_of_kind(side.node, Derivative, Integral)
    ]
    within = {name for body in bodies for name in names(body)}
    moments = {
        name
        for name in within & knowledge.definitions.keys()
        if knowledge.definitions[name].numeric and _is_of_moment(name, chain, sections, knowledge)
    }
    if not moments:
        return knowledge
    rest = {name: d for name, d in knowledge.definitions.items() if name not in moments}
    return replace(knowledge, definitions=rest)


def _is_of_moment(name: str, chain: Chain, sections: Sections, knowledge: Knowledge) -> bool:
    """Tell whether the words beside the relation that gave a letter its number name one moment."""
    line = knowledge.definitions[name].line
    for above in sections.chains_on(line):
        if above is chain or above.sides[0].node != Name(name):
            continue
        place = sections.place_behind(above) or sections.place_of_sentence(above)
        return place is not None or _MOMENT.search(sections.sentence_before(above)) is not None
    return False
