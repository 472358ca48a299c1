r"""A column written \binom{a}{b}: short for a vector of two components, and no binomial coefficient.

No coefficient has a negative number below, or a sine: where a page has such a one, or a letter with an
arrow that is one, all of the page are columns.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import (
    Apply,
    Call,
    Formula,
    Matrix,
    Negative,
    Number,
    parts_of_kind,
    with_parts_changed,
)
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

_BINOMIAL = "binomial"
_ARROW = re.compile(r"\\(?:vec|overrightarrow|boldsymbol|mathbf|bm)(?![A-Za-z])")


def with_columns(document: ReadNotes) -> ReadNotes:
    """Return a page whose binomials are columns, if it shows that they are."""
    if not any(_shows_column(chain, document) for chain in document.chains):
        return document
    return replace(document, chains=tuple(map(_with_columns, document.chains)))


def _binomials(node: Formula) -> list[Apply]:
    return [part for part in parts_of_kind(node, Apply) if part.function == _BINOMIAL]


def _shows_column(chain: Chain, document: ReadNotes) -> bool:
    found = [part for side in chain.sides for node in side.readings for part in _binomials(node)]
    if any(_is_no_count(part.arguments[1]) for part in found):
        return True
    return bool(found) and _ARROW.search(document.source(chain.sides[0].span)) is not None


def _is_no_count(node: Formula) -> bool:
    """Tell whether a formula is no lower number of a coefficient: below zero, or a sine."""
    if isinstance(node, Negative):
        return isinstance(node.operand, Number) or bool(parts_of_kind(node, Call))
    is_negative = isinstance(node, Number) and node.value < 0
    return is_negative or any(part.function in ("sin", "cos") for part in parts_of_kind(node, Call))


def _with_columns(chain: Chain) -> Chain:
    sides = (replace(side, readings=tuple(map(_as_column, side.readings))) for side in chain.sides)
    return replace(chain, sides=tuple(sides))


def _as_column(node: Formula) -> Formula:
    if isinstance(node, Apply) and node.function == _BINOMIAL:
        return Matrix(tuple((_as_column(part),) for part in node.arguments), span=node.span)
    return with_parts_changed(node, _as_column)
