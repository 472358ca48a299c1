"""A unit typed once, behind the last number of a side: 0.35 + 0.11 + 0.57/3 kg may be a mass as a whole.

Whether the unit belongs to that number or to all, what stands beside decides: the reading that agrees
with a side next to it comes first, both stay. (83.8 - 52.4)/11.5 s⁻² is divided by 11.5 s⁻², but
(1200 + 350)/2 N is half a force. Where other numbers have units of their own, each has its own.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Constant, Formula, Number, Product, Quotient, Sum
from symbalance.notes.reading.equations import Side
from symbalance.notes.reading.formulas.lexer import Token
from symbalance.text import lazy_patterns as re

_DIGITS = re.compile(r"[0-9](?:[0-9.,{}  ]*[0-9])?")
_LONG = 3
"""Digits of a whole number that is measured, not a factor."""
_CLOSE = 0.005
"""Of a number printed: what it is rounded by."""


def with_unit_of_whole(
    sides: Sequence[Side | None],
    tokens: Sequence[Sequence[Token]],
    text: str,
    read: Callable[[Sequence[Token]], tuple[Formula, ...]],
    value_of: Callable[[Formula], float | None],
) -> list[Side | None]:
    """Return the sides of a chain, those with a lone unit at their end in both readings.

    `read` turns tokens into formulas, `value_of` a formula without letters into its value.
    """
    done = list(sides)
    for place, side in enumerate(sides):
        end = _lone_unit_at_end(tokens[place], text) if side is not None else None
        if side is None or end is None:
            continue
        number, stop, unit = end
        bare = [*tokens[place][:number], stop]
        if not any(token.is_op("+-/") for token in bare[1:-1]):
            continue
        wholes = tuple(Product((node, unit), span=side.span) for node in read(bare))
        beside = [
            value
            for other in (*sides[place - 1 : place][:1], *sides[place + 1 : place + 2])
            if other is not None and (value := value_of(other.node)) is not None
        ]
        is_sum = isinstance(side.node, Sum)
        agree = [any(_agrees(value_of(n), v) for v in beside) for n in (side.node, wholes[0])]
        is_whole = agree[1] if agree[0] != agree[1] else is_sum
        readings = (*wholes, *side.readings) if is_whole else (*side.readings, *wholes)
        done[place] = replace(side, readings=readings)
    return done


def with_units_of_divisors(tokens: Sequence[Token]) -> list[Token]:
    """Return a side's tokens with a divisor's unit beside it: 120 N/4 mm is divided by millimetres.

    Only where what is divided has its own unit: in π·8²/4 cm³ the unit is that of the whole. A letter has
    one, U/31.5 mm, where the divisor is measured: s/2 mm is half a stroke.
    """
    done: list[Token] = []
    place = 0
    while place < len(tokens):
        token = tokens[place]
        behind = tokens[place + 1 : place + 4]
        is_divisor = token.kind == "number" and token.scale is not None
        is_divisor = is_divisor and (
            _ends_in_unit(done) or (_ends_in_letter(done) and _is_measured(token))
        )
        if is_divisor and [part.kind for part in behind] == ["open", "number", "close"]:
            opening = Token("open", "(", token.start, token.start)
            closing = Token("close", ")", behind[-1].end, behind[-1].end)
            done += [opening, token, *behind, closing]
            place += 4
            continue
        done.append(token)
        place += 1
    return done


def with_unit_of_range(sides: Sequence[Sequence[Token]], signs: Sequence[str]) -> list[list[Token]]:
    """Return the sides of a range with the unit of its last number at the first: 52 < n < 64 rpm.

    The first number has none of its own, and is not 0, which needs none.
    """
    done = [list(tokens) for tokens in sides]
    if len(done) != 3 or not (set(signs) <= {"<", "≤"} or set(signs) <= {">", "≥"}):
        return done
    if len(done[0]) != 1 or not done[2]:
        return done
    first, (last, *unit) = done[0][0], done[2]
    has_unit = last.scale is not None or [token.kind for token in unit] == ["degree"]
    is_bare = first.kind == "number" and first.scale is None and first.number != 0
    if is_bare and last.kind == "number" and has_unit:
        done[0] = [replace(first, scale=last.scale), *unit]
    return done
    has_unit = last.scale is not None or [token.kind for token in unit] == ["degree"]
    if first.scale is None and first.number and has_unit:
        done[0] = [replace(first, scale=last.scale), *unit]
    return done


def _ends_in_unit(tokens: Sequence[Token]) -> bool:
    """Tell whether tokens end in a quantity with its unit and a stroke."""
    if len(tokens) < 2 or not tokens[-1].is_op("/"):
        return False
    before = tokens[-2]
    if before.kind == "number":
        return before.scale is not None
    return before.kind == "close" and len(tokens) > 4 and tokens[-5].scale is not None


def _ends_in_letter(tokens: Sequence[Token]) -> bool:
    """Tell whether a side begins with a letter and a stroke, nothing else."""
    is_lone = len(tokens) == 2 and tokens[1].is_op("/")
    return is_lone and tokens[0].kind == "name" and tokens[0].value != "pi"


def _is_measured(token: Token) -> bool:
    """Tell a number as a measurement gives it from the 2, 60 or 1000 of a formula."""
    digits = str(token.number.numerator).rstrip("0")
    return token.place is not None or (token.number.denominator == 1 and len(digits) >= _LONG)


def _lone_unit_at_end(tokens: Sequence[Token], text: str) -> tuple[int, Token, Formula] | None:
    """Return the place of the last number, that without its unit, and the unit; None for other sides."""
    place = next((n for n in range(len(tokens) - 1, -1, -1) if tokens[n].scale is not None), None)
    if place is None or place == 0 or tokens[place].kind != "number":
        return None
    number, behind = tokens[place], tokens[place + 1 :]
    if behind and (behind[0].kind != "open" or behind[0].value != "{" or behind[-1].kind != "close"):
        return None
    others = tokens[:place]
    if any(token.scale is not None or token.kind in ("degree", "cmd") for token in others):
        return None
    if any(token.kind == "name" and token.value != "pi" for token in others) or _is_in_bracket(others):
        return None
    length = len(text[number.start : number.end]) - len(_unit_text(text[number.start : number.end]))
    digits_end = number.start + length
    span = (digits_end, behind[-1].end if behind else number.end)
    unit = _unit(behind, span)
    if unit is None:
        return None
    return place, replace(number, scale=None, end=digits_end), unit


def _unit_text(source: str) -> str:
    """Return what stands behind the digits of a number's text: `3 kg` is one piece where kg counts 1."""
    digits = _DIGITS.match(source)
    return source[digits.end() if digits else 0 :]


def _unit(tokens: Sequence[Token], span: tuple[int, int]) -> Formula | None:
    """Return the factor that a unit's tokens are; None for anything but a number or π/30."""
    inside = list(tokens[1:-1])
    if not inside:
        return Number(Fraction(1), span=span)
    if len(inside) == 1 and inside[0].kind == "number":
        return Number(inside[0].number, span=span)
    is_turn = [token.value for token in inside[:2]] == ["pi", "/"] and len(inside) == 3
    if is_turn:
        return Quotient(Constant("pi", span=span), Number(inside[2].number, span=span), span=span)
    return None


def _is_in_bracket(tokens: Sequence[Token]) -> bool:
    """Tell whether a bracket is open before a place, or a power begun: there the unit ends too."""
    depth = sum({"open": 1, "close": -1}.get(token.kind, 0) for token in tokens)
    return depth > 0 or (bool(tokens) and tokens[-1].kind in ("sup", "sub"))


def _agrees(value: float | None, printed: float) -> bool:
    return value is not None and abs(value - printed) <= _CLOSE * abs(printed)
