"""Sizes of a piston's acceleration and mass force at the dead centres: r ω² (1 + r/l) and r ω² (1 - r/l).

The first is that at top dead centre and the largest, the second that at bottom dead centre, whatever
sign the author counts with. A formula of this shape whose index or whose words name the other dead centre
is refuted; one that nothing places is not judged.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

from symbalance.document.formula import (
    Call,
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Sum,
    names,
    walk,
)
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision, without_dots
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import with_every
from symbalance.notes.checking.meant.engines.engine_letters import same
from symbalance.notes.checking.meant.engines.engine_resultants import EngineResultants
from symbalance.notes.checking.meant.products import NoProductError, product_of
from symbalance.notes.checking.repair.fixes import Repair, fix_of
from symbalance.notes.checking.verdicts import Verdict
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

_TOP = frozenset({"max", "ot", "tdc", "idc", "top", "pmh", "pms", "hat"})
_BOTTOM = frozenset({"ut", "bdc", "odc", "bot", "bottom", "pmb", "pmi"})
_OTHER_MECHANISM = re.compile(
    r"offset|desax|dés?ax|geschränkt|オフセット|\bcams?\b|nocken|カム|scotch|yoke|articulated|slave\s+rod|nebenpleuel"
    r"|\bvalves?\b|ventil",
    re.IGNORECASE,
)
_FROM_EITHER_END = re.compile(
    r"\b(?:inner|outer)\b|\b(?:inner|äußer|ausser)e[nmrs]?\b|[内外](?:側|死点)", re.IGNORECASE
)
"""Words for a dead centre that are counted from the crank in one book, from the cylinder in another."""
_STEMS = frozenset({"a", "b", "j", "f", "p", "k", "x", "s", "z", "ddot", "f_in", "acc"})
_SIZES = ({"radius": 1, "speed": 2}, {"radius": 1, "speed": 2, "mass": 1})
_WORDS = {
    True: ("top dead centre", "the largest"),
    False: ("bottom dead centre", "the smaller one"),
}


class _Shape(NamedTuple):
    """A size times (1 ± the rod's ratio), its second term, and whether that is added."""

    term: Formula
    is_added: bool


@dataclass
class DeadCentreSizes:
    """Judges the sizes of a piston's acceleration and mass force at the dead centres on one page."""

    resultants: EngineResultants

    def refute(self, chain: Chain, k: int, knowledge: Knowledge) -> Verdict | None:
        """Return the refutation of a size that belongs to the other dead centre; None for others."""
        head = chain.sides[0].node
        head = head.argument if isinstance(head, Call) and head.function == "abs" else head
        letter = head.expression if isinstance(head, Derivative) else head
        if k or not isinstance(letter, Name) or chain.relations[0].sign not in "=≈":
            return None
        if letter.name.partition("_")[0].casefold() not in _STEMS:
            return None
        node = without_dots(chain.sides[1].node)[0]
        shape = self._shape(node, knowledge)
        is_top = None if shape is None else self._is_top(chain, letter.name)
        if shape is None or is_top is None or is_top == shape.is_added:
            return None
        if _OTHER_MECHANISM.search(self.resultants.words.document.text):
            return None
        opposite = _opposite(shape.term)
        target = with_every(node, shape.term, opposite)
        side = chain.sides[1]
        known = Knowledge(SymbolValue(positive=frozenset(names(node))), corrects=True)
        decision = decide(Side((target,), chain.sides[0].span), side, chain.relations[0].sign, known)
        if decision.status != REFUTED:
            return None
        place, size = _WORDS[is_top]
        reason = (
            f"the size of a piston's acceleration at {place}, {size}, has 1 {'+' if is_top else '-'} r/l"
        )
        document = self.resultants.words.document
        verdict = describe(document, chain, 0, Decision(REFUTED, reason, witness=decision.witness))
        repair = Repair("sign", target, ((shape.term, opposite),), 1.0)
        return replace(verdict, fix=fix_of(repair, document, side))

    def _is_top(self, chain: Chain, name: str) -> bool | None:
        """Return whether an index or words name top dead centre, False for bottom, else None."""
        index = {part.casefold() for part in re.split(r"[_,\s]+", name)}
        by_index = {True for _ in index & _TOP} | {False for _ in index & _BOTTOM}
        named = self.resultants.sections.dead_centre(chain)
        sentence = self.resultants.sections.sentence_before(chain)
        is_open = named is None or _FROM_EITHER_END.search(sentence) is not None
        by_words = set() if is_open else {not named}
        if by_index - by_words and by_words and not index & (_BOTTOM | (_TOP - {"max", "hat"})):
            return None  # the largest at bottom dead centre, whatever that is
        places = by_index or by_words
        return places.pop() if len(places) == 1 else None

    def _shape(self, node: Formula, knowledge: Knowledge) -> _Shape | None:
        """Return r ω² (1 ± r/l) or m r ω² (1 ± r/l) as such; None for another formula."""
        sums = [part for part in walk(node) if isinstance(part, Sum) and names(part)]
        if len(sums) != 1 or len(sums[0].terms) != 2:
            return None
        one, term = sums[0].terms
        try:
            ratio = product_of(term)
            rest = product_of(
                with_every(node, sums[0], Number(one.value)) if isinstance(one, Number) else node
            )
        except NoProductError:
            return None
        if not isinstance(one, Number) or one.value != 1 or not same(abs(ratio.number), 1) or ratio.wave:
            return None
        role = self.resultants.letters.role
        roles = {role(n, knowledge): p for n, p in ratio.powers.items()}
        is_ratio = roles in ({"radius": 1, "rod": -1}, {"inverse": -1}, {"ratio": 1}, {"ratio": -1})
        sizes = {role(n, knowledge): p for n, p in rest.powers.items()}
        if not is_ratio or sizes not in _SIZES or not same(abs(rest.number), 1) or rest.wave:
            return None
        return _Shape(term, ratio.number > 0)


def _opposite(term: Formula) -> Formula:
    return term.operand if isinstance(term, Negative) else Negative(term)
