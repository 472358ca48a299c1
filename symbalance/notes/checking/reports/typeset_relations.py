"""Relations as a page shows them: `left = right` of the first in a chain, `= right` of those after it."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from itertools import islice
from operator import is_

from symbalance.document.formula import (
    Constant,
    Equation,
    Formula,
    Name,
    Number,
    Product,
    Quotient,
    Span,
    Upright,
    children,
    names,
    walk,
    with_parts_changed,
)
from symbalance.document.letters import GREEK_SIGN, NAME_OF_SIGN, raised
from symbalance.notes.checking.verdicts import Verdict
from symbalance.notes.checking.words.written_degrees import degrees_of
from symbalance.notes.checking.words.written_numbers import written_number
from symbalance.notes.reading import ReadingError, read_equation
from symbalance.notes.reading.equations import Chain, ReadNotes, Side
from symbalance.notes.reading.units import USUAL_SCALES, scale_of
from symbalance.text import lazy_patterns as re

LARGEST_NUMBER = 10**60
LARGEST_FORMULA = 300
"""Parts of a formula that is written out."""
Sides = Mapping[Span, tuple[Chain, int]]


def sides_by_span(derivation: ReadNotes) -> Sides:
    """Return the chain of each side, by where the side stands, and which side of it it is."""
    return {side.span: (chain, k) for chain in derivation.chains for k, side in enumerate(chain.sides)}


def typeset(verdict: Verdict, sides: Sides, text: str = "") -> Formula | Equation | None:
    """Return a verdict's relation; None where it was not read, or is too large to be written out.

    Of a page's `text` its units are as they were typed.
    """
    if verdict.node is None or not is_readable(verdict.node):
        return None
    chain, k = sides.get(verdict.span, (None, 0))
    right = as_written(_with_unit_behind(verdict.node, verdict.span), text)
    if chain is None or not k:
        return right
    left = _with_its_dots(chain.sides[k - 1], text)
    first = as_written(left, text) if k == 1 and is_readable(left) else Upright("")
    return Equation(first, ((chain.relations[k - 1].sign, right),))


def formula_of(source: str, letters: Collection[str] = ()) -> Formula | Equation | None:
    r"""Return a source as a formula, its single letters letters; None where it cannot be read.

    >>> from symbalance.document.text_writer import formula_text
    >>> formula_text(formula_of(r"F = \sqrt{2}\, m r"))
    'F = √2 m r'
    >>> formula_of(r"\frac{1}{")
    """
    here = {*letters, *re.findall(r"(?<![A-Za-z\\])[A-Za-z](?![A-Za-z])", source)}
    here |= {word for word in re.findall(r"\\([A-Za-z]+)", source) if word in GREEK_SIGN}
    here |= {NAME_OF_SIGN[sign] for sign in source if sign in NAME_OF_SIGN}
    try:
        return whole_chain(read_equation(source, here), source)
    except ReadingError:
        return None


def is_readable(node: Formula) -> bool:
    """Tell whether a formula is small enough to be written out; the JSON has any."""
    return next(islice(walk(node), LARGEST_FORMULA, None), None) is None


def whole_chain(chain: Chain, text: str = "") -> Formula | Equation:
    """Return a chain as one equation; of a page's `text` its units are as they were typed."""
    rest = tuple(
        (relation.sign, as_written(_with_unit_behind(side.node, side.span), text))
        for relation, side in zip(chain.relations, chain.sides[1:], strict=True)
    )
    first = as_written(_with_its_dots(chain.sides[0], text), text)
    return Equation(first, rest) if rest else first


def _with_its_dots(side: Side, text: str) -> Formula:
    """Return a side, as it was typed where it is a dotted letter that was read as another: φ̇ as ω."""
    source = text[slice(*side.span)]
    if not isinstance(side.node, Name) or _DOTTED.match(source) is None:
        return side.node
    typed = formula_of(source)
    return side.node if typed is None or isinstance(typed, Equation) else typed


def _with_unit_behind(node: Formula, span: Span) -> Formula:
    """Return a number alone on its side as far as the side goes: n = 6000 rpm is read as 6000."""
    is_all = isinstance(node, Number) and node.span[0] == span[0] < node.span[1] < span[1]
    return replace(node, span=span) if is_all else node


def as_written(node: Formula, text: str = "") -> Formula:
    """Return a formula with degrees and, of a page's `text`, units as they were written.

    The reader makes 90° 90 π/180 and 40 mm 40/1000.

    >>> from symbalance.document.text_writer import formula_text
    >>> from symbalance.notes.reading import read_equation
    >>> formula_text(as_written(read_equation("cos(x + 90°)", {"x"}).sides[0].node))
    'cos(x + 90°)'
    """
    if (degrees := degrees_of(node)) is not None:
        typed = _COMMA_DEGREES.match(text[slice(*node.span)])
        return Upright(f"{typed['whole']},{typed['rest']}°") if typed else degrees
    if text and (quantity := _quantity(node, text)) is not None:
        return quantity
    return with_parts_changed(node, lambda part: as_written(part, text))


def _quantity(node: Formula, text: str) -> Formula | None:
    """Return a number, with its unit if it has one, as it was typed; None of any other formula."""
    if not isinstance(node, Number | Product) or node.span == (0, 0):
        return None
    value = _value(node)
    number = None if value is None else written_number(text[slice(*node.span)], value)
    if number is not None:
        return None if number.written == node else number.written
    if not isinstance(node, Product):
        return None
    factors = _with_units([each for each in node.factors if not _is_unit_understood(each)], text)
    if len(factors) == len(node.factors) and all(map(is_, factors, node.factors)):
        return None
    rest = tuple(each if isinstance(each, Upright) else as_written(each, text) for each in factors)
    return rest[0] if len(rest) == 1 else Product(rest)


def _is_unit_understood(factor: Formula) -> bool:
    """Tell whether a factor is a unit that is not typed: `√45 = 6.71 in` has √45 in inches too."""
    return isinstance(factor, Number) and factor.span == (0, 0) and factor.value in USUAL_SCALES


def _with_units(factors: Sequence[Formula], text: str) -> list[Formula]:
    """Return factors with each number and the unit behind it as one, as they were typed."""
    result: list[Formula] = []
    for factor in factors:
        unit = _AROUND_UNIT.sub("", text[slice(*factor.span)])
        is_unit = re.match("[A-Za-zµμ°%]|1/", unit) is not None and scale_of(unit) is not None
        if is_unit and not names(factor) and result and isinstance(result[-1], Number):
            size = text[slice(*result.pop().span)].replace("{,}", ",").strip("$ ")
            result.append(Upright(f"{size} {unit}"))
        elif is_unit and not names(factor) and result:  # behind a bracket or a fraction
            result.append(Upright(_EXPONENT.sub(lambda match: raised(match[1]), unit)))
        else:
            result.append(factor)
    return result


_COMMA_DEGREES = re.compile(r"\s*(?P<whole>[0-9]+)(?:\{,\}|,)(?P<rest>[0-9]+)")
_EXPONENT = re.compile(r"\^([0-9])")
_DOTTED = re.compile(r"\\d{1,3}ot(?![A-Za-z])")
_AROUND_UNIT = re.compile(r"\\(?:mathrm|text|textrm|mbox|unit|si|rm)(?![A-Za-z])|\\[,;: ]|[${}~\s]")


def _value(node: Formula) -> float | None:
    """Return the value of numbers, π and their quotients and products; None of anything else."""
    if isinstance(node, Number):
        return float(node.value) if abs(node.value) < LARGEST_NUMBER else None
    if isinstance(node, Constant):
        return math.pi if node.name == "pi" else None
    values = [_value(part) for part in children(node)] if isinstance(node, Product | Quotient) else [None]
    sizes = [value for value in values if value is not None]
    if len(sizes) < len(values):
        return None
    if isinstance(node, Quotient):
        return sizes[0] / sizes[1] if sizes[1] else None
    return math.prod(sizes)
