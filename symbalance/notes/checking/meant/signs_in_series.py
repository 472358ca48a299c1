"""The sign that a page's own series gives a coefficient: of cos θ - A_4 cos 4θ that of A_4 is minus."""

from __future__ import annotations

from collections.abc import Iterable

from symbalance.document.formula import Call, Formula, Name, Negative, Number, Product, Sum, walk
from symbalance.notes.reading.equations import Chain


def sign_in_series(chains: Iterable[Chain], name: str, order: int) -> int:
    """Return the sign of a coefficient times cos nθ beside a bare cos θ; 0 where no series has both.

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


def _sign_beside_first(series: Sum, name: str, order: int) -> int:
    own = first = 0
    for term in series.terms:
        sign, body = (-1, term.operand) if isinstance(term, Negative) else (1, term)
        factors = body.factors if isinstance(body, Product) else (body,)
        cosines = [f for f in factors if isinstance(f, Call) and f.function == "cos"]
        others = [f for f in factors if f not in cosines]
        if len(cosines) != 1:
            continue
        multiple = multiple_of_angle(cosines[0].argument)
        if not others and multiple == 1:
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
