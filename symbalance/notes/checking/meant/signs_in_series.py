"""What a page's own series says of a coefficient: of cos θ - A_4 cos 4θ that its sign is minus."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Sum,
    walk,
)
from symbalance.notes.reading.equations import Chain

_TWO = Number(Fraction(2))


def sign_in_series(chains: Iterable[Chain], name: str, order: int) -> int:
    """Return the sign of a coefficient times cos nθ beside cos θ or A_1 cos θ; 0 where none has both.

    Beside cos θ it is the same whatever the series is of: of the acceleration, or of the displacement
    with its - cos θ. Series that disagree say nothing.
    """
    signs = {
        sign
        for chain in chains
        for side in chain.sides
        for part in walk(side.node)
        if isinstance(part, Sum) and (sign := _sign_beside_first(part, name, order))
    }
    return signs.pop() if len(signs) == 1 else 0


def line_of_acceleration(chains: Iterable[Chain], name: str, order: int) -> int:
    """Return the line of r ω² (cos θ + … + A_n cos nθ), in which A_n is an acceleration's; 0 for none.

    The displacement r (cos θ + …) has no ω², and a velocity sines. Where a coefficient stands in a
    series beside cos θ without ω², it may be of that one.
    """
    lines: list[int] = []
    for chain in chains:
        is_series = any(
            isinstance(part, Sum) and _sign_beside_first(part, name, order)
            for side in chain.sides
            for part in walk(side.node)
        )
        if is_series:
            lines.append(chain.lines[0] if any(_has_rate(side.node) for side in chain.sides) else 0)
    return min(lines, default=0)


def _has_rate(node: Formula) -> bool:
    """Tell whether a formula has ω², or a second derivative."""
    return any(
        (isinstance(part, Power) and part.exponent == _TWO and isinstance(part.base, Name)
         and part.base.name.lower().startswith("omega"))
        or (isinstance(part, Derivative) and part.order == _TWO.value)
        for part in walk(node)
    )  # fmt: skip


def coefficients_beside_first(node: Formula) -> frozenset[str]:
    """Return the letters of a series with a bare cos θ that stand at a cosine of their own number."""
    return frozenset(
        factor.name
        for part in walk(node)
        if isinstance(part, Sum)
        for term in part.terms
        for factor in walk(term)
        if isinstance(factor, Name)
        and (number := factor.name.rpartition("_")[2]).isdecimal()
        and _sign_beside_first(part, factor.name, int(number))
    )


def _sign_beside_first(series: Sum, name: str, order: int) -> int:
    own = first = 0
    first_letter = f"{name.rpartition('_')[0]}_1"  # A_1, which is 1 where A_4 is of an acceleration
    for term in series.terms:
        sign, body = (-1, term.operand) if isinstance(term, Negative) else (1, term)
        factors = body.factors if isinstance(body, Product) else (body,)
        cosines = [f for f in factors if isinstance(f, Call) and f.function == "cos"]
        others = [f for f in factors if f not in cosines]
        if len(cosines) != 1:
            continue
        multiple = multiple_of_angle(cosines[0].argument)
        if multiple == 1 and (not others or others == [Name(first_letter)]):
            first = sign
        elif others == [Name(name)] and multiple == order:
            own = sign
    return own * first


def multiple_of_angle(node: Formula) -> int:
    """Return n of nθ, 0 for another formula."""
    match node:
        case Name():
            return 1
        case Product((Number(value=n), Name())) if n.denominator == 1:
            return int(n)
    return 0
