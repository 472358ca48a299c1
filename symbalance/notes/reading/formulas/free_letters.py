"""Letters that nobody declared, read as letters of their own where what they are cannot change the sense.

In `cos α − cos β = −2 sin((α + β)/2) sin((α − β)/2)` it does not matter what α means, and f of f(x) is a
function of which nothing is known. It matters for the rate of a sin t, and for N behind a number, which
may be a unit: those stay undeclared, and are said to be.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence

from symbalance.document.formula import Call, Constant, Derivative, Formula, Name, Summation, names, walk
from symbalance.document.letters import ACCENTS, GREEK_SIGN, TIME_DOTS
from symbalance.notes.reading.equations import Side
from symbalance.notes.reading.formulas.lexer import Token
from symbalance.notes.reading.units import scale_of

_MARKS = frozenset(ACCENTS.values()) | frozenset(TIME_DOTS) | {"Delta", "delta"}
_NEVER = frozenset({"O", "e", "i"})
"""Big O, or a nought misread, and the constants."""
_INDICES = frozenset({"i", "j", "k"})


def is_plain(name: str) -> bool:
    """Tell whether a canonical name is one letter, with subscript, accent or prime: no word.

    >>> [is_plain(name) for name in ("F", "m_rot", "J1", "gamma_1'", "delta_i", "Lh", "O")]
    [True, True, True, True, True, False, False]
    """
    parts = re.sub(r"'+$", "", name).split("_")
    if parts[0] == "delta" and parts[1:] in (["i"], ["e"]):
        return True  # δ_i, and no step of the constant
    if parts[0] == "delta" and len(parts) == 2 and _is_mark_of_value(parts[1]):
        return True
    while len(parts) > 1 and parts[0] in _MARKS:
        parts = parts[1:]
    base = re.sub(r"(?<=^[A-Za-z])[0-9]+$", "", parts[0])
    return (len(base) == 1 and base.isalpha() and base not in _NEVER) or base in GREEK_SIGN


def _is_mark_of_value(subscript: str) -> bool:
    """Tell whether a subscript is a number or a word: δ_0 and δ_st are no steps of a letter."""
    return subscript.isdigit() or (
        len(subscript) > 1 and subscript.isalpha() and subscript not in GREEK_SIGN
    )


def may_be_free(
    name: str, tokens: Sequence[Token], start: int, place: int, known: Collection[str] = ()
) -> bool:
    """Tell whether an undeclared letter that begins at `start` is one by what stands around it.

    `place` is that of the token behind it; `known` are letters that lines above use: 2J, where J_1 = J.
    """
    if not is_plain(name) and name not in known:
        return False
    before = next((t for t in reversed(tokens[:place]) if t.end <= start), None)
    if before is not None and _is_exponent_of_letter(tokens, tokens.index(before)):
        before = None  # r ω² d: the 2 is no number that a unit stands behind
    is_last = place >= len(tokens) or tokens[place].kind in ("sep", "close")
    is_word = tokens[place - 1].end - start == len(name)  # 20 psi, but 2\psi and 2ψ
    if tokens[place - 1].counted:
        return True
    if is_last and is_word and before is not None and before.kind in ("number", "vulgar"):
        is_letter = not scale_of(name) or (name in known and (before.end == start or name == "h"))
        return is_letter and (name != "d" or name in known)  # 3 N, but 2 m r
    is_apart = place < len(tokens) and tokens[place].start > start + 1
    return name != "d" or (name in known and is_apart) or _is_no_differential(tokens, place)


def _is_exponent_of_letter(tokens: Sequence[Token], place: int) -> bool:
    """Tell whether a number is the exponent of a letter, and no number that has a unit: ω^2 s."""
    if place and tokens[place - 1].kind == "open":
        place -= 1
    has_sign = place > 1 and tokens[place - 1].kind == "sup"
    return has_sign and tokens[place - 2].kind not in ("number", "vulgar", "close")


def _is_no_differential(tokens: Sequence[Token], place: int) -> bool:
    r"""Tell whether the d before a place is a letter: d \dot q, \frac1d, and no d of dx or d \theta."""
    after = tokens[place] if place < len(tokens) else None
    if after is None or after.kind not in ("name", "cmd") or after.is_cmd(*TIME_DOTS):
        return True
    below = place > 2 and tokens[place - 3].is_cmd("frac") and tokens[place - 2].kind == "number"
    return below or (place > 1 and tokens[place - 2].is_cmd("frac") and after.kind == "cmd")


def unclear(node: Formula, free: Collection[str]) -> str | None:
    """Return a free letter that stands where its meaning counts, None if there is none.

    Under a derivative of what does not hold its variable it may vary; under a sum its subscript may
    count, unless the sum is a series of harmonics.
    """
    for part in walk(node):
        if isinstance(part, Derivative):
            if isinstance(part.expression, Name):
                continue  # the rate of a letter of which nothing is known is a letter too
            inside = names(part.expression) - {part.variable.name}
            if inside != names(part.expression):
                continue  # d(m r cos θ)/dθ: that m is a constant is said to be assumed
        elif isinstance(part, Summation) and not _is_of_harmonics(part):
            inside = {name for name in names(part.body) if _is_indexed(name, part)}
        else:
            continue
        for name in sorted(inside):
            if name in free:
                return name
    return None


def _is_of_harmonics(total: Summation) -> bool:
    """Tell whether a sum is of harmonics, Σ T_k sin kθ: its letters are their coefficients."""
    index = total.index.name if total.index is not None else ""
    return any(isinstance(part, Call) and index in names(part.argument) for part in walk(total.body))


def _is_indexed(name: str, total: Summation) -> bool:
    subscripts = set(re.split(r"[_,()]+", name)[1:])
    if total.index is None or total.lower is None:
        return False  # a sum that does not say from where to where is a quantity of its own
    index = total.index.name
    carried = rf"(?:(?<=[_,(])|(?<=[_,(][i-nN]))\d*{re.escape(index)}(?=[i-nN]?(?:,\w+)?\)?$)"
    if re.search(carried, name):
        return False  # F_k summed over k from 1 to 4 is F_1 + F_2 + F_3 + F_4
    return total.index.name in subscripts or not subscripts.isdisjoint(_INDICES)


def with_real_letters(sides: Sequence[Side | None], signs: Sequence[str]) -> list[Side | None]:
    """Return the sides of a chain, an i that is compared in size as a letter: 1 ≤ i ≤ N."""
    if not set(signs) & _ORDERED:
        return list(sides)
    return [_with_real_letter(side) for side in sides]


_ORDERED = frozenset({"<", ">", "≤", "≥"})


def _with_real_letter(side: Side | None) -> Side | None:
    if side is None or side.node != Constant("i"):
        return side
    return Side((Name("i", span=side.node.span),), side.span)
