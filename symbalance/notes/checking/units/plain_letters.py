"""Letters that are plain numbers by a page's own lines: the f of 1 - f has no unit, nor δ = 0.02."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from symbalance.document.formula import (
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Sum,
    parts_of_kind,
)
from symbalance.notes.checking.units.dimensions import written_unit
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading.equations import ReadNotes, Side


@dataclass
class PlainLetters:
    """The letters of one page that stand in a sum with a bare 1, or are ratios with a bare number."""

    document: ReadNotes
    sections: Sections

    def at(self, line: int) -> frozenset[str]:
        """Return the letters that are plain numbers in the section of a line."""
        return frozenset(
            name
            for name, where in self._lines.items()
            if any(self.sections.same_section(w, line) for w in where)
        )

    def _is_bare(self, side: Side) -> bool:
        """Tell whether a side is one number, with no unit typed behind it."""
        if not isinstance(side.node, Number):
            return False
        return not written_unit(self.document.source(side.span))[1].strip()

    @cached_property
    def _lines(self) -> dict[str, set[int]]:
        lines: dict[str, set[int]] = {}
        for chain in self.document.chains:
            for side in chain.sides:
                for name in _beside_one(side.node):
                    lines.setdefault(name, set()).add(chain.lines[0])
            head, right = chain.sides[0].node, chain.sides[-1]
            is_ratio = isinstance(head, Name) and head.name.partition("_")[0] in _RATIOS
            if is_ratio and len(chain.sides) > 1 and self._is_bare(right):
                assert isinstance(head, Name)
                lines.setdefault(head.name, set()).add(chain.lines[0])
        return lines


_RATIOS = frozenset({"delta", "lambda", "epsilon", "varepsilon", "eta", "zeta", "kappa", "mu", "nu"})
"""Usual letters of ratios, coefficients and angles."""


def _beside_one(node: Formula) -> Iterator[str]:
    """Yield the letters that sums add to 1, themselves or squared, times a whole number or not.

    >>> f, x = Name("f"), Name("x")
    >>> list(_beside_one((1 - f) * x)), list(_beside_one(x - f))
    (['f'], [])
    """
    for part in parts_of_kind(node, Sum):
        assert isinstance(part, Sum)
        ones = [term for term in part.terms if isinstance(term, Number) and term.value == 1]
        others = [term for term in part.terms if term not in ones]
        if len(ones) == len(others) == 1 and ones[0].last_place is None:
            bare = others[0].operand if isinstance(others[0], Negative) else others[0]
            factors = bare.factors if isinstance(bare, Product) else (bare,)
            letters = [each.base if isinstance(each, Power) else each for each in factors]
            letters = [each for each in letters if not isinstance(each, Number)]
            if len(letters) == 1 and isinstance(letters[0], Name):
                yield letters[0].name
