"""Mean values that a page uses and never writes: ω_0 between ω_max and ω_min, ω between ω_1 and ω_2.

ΔE = J (ω_max² - ω_min²)/2 is J ω_0² δ if ω_0 is half the sum of the two. Words say so, or nobody does:
what is true with it is true on that condition.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Formula, Name, Number, Quotient, Sum
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_ENDS = (("max", "min"), ("1", "2"), ("o", "u"), ("a", "b"))
_MEANS = ("{}", "{}_0", "{}_m", "{}_mean", "{}_av", "{}_mittel", "{}_mit", "bar_{}")
_END = re.compile(r"(?P<stem>.+)_(?P<end>max|min|1|2|o|u|a|b)")


def decide_by_mean(chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the proof of a relation that takes a letter for the mean of two others, None without one."""
    left, right, sign = chain.sides[k], chain.sides[k + 1], chain.relations[k].sign
    if sign not in ("=", "≈"):
        return None
    formulas = knowledge.formulas
    values = {name: d.node for name, d in formulas.items()} | dict(knowledge.meaning.values)
    behind = {n for side in (left, right) for n in names_behind(side.node, values)}
    for mean, value in _means(behind):
        if mean in formulas or mean in knowledge.meaning.values:
            continue
        known = replace(knowledge, definitions={**formulas, mean: Definition(value, chain.lines[0])})
        decision = decide(left, right, "=", known)
        if decision.is_proved:
            text = f"{plain_text(Name(mean))} = {plain_text(value)}"
            return replace(decision, assumptions=(*decision.assumptions, text))
    return None


def _means(letters: set[str]) -> Iterator[tuple[str, Formula]]:
    """Yield the letters that may be the mean of two others of one stem, with that mean."""
    for name in sorted(letters):
        match = _END.fullmatch(name)
        for first, second in _ENDS if match is not None else ():
            assert match is not None
            other = f"{match['stem']}_{second}"
            if match["end"] != first or other not in letters:
                continue
            value = Quotient(Sum((Name(name), Name(other))), Number(Fraction(2)))
            for pattern in _MEANS:
                mean = pattern.format(match["stem"])
                if mean in letters:
                    yield mean, value
