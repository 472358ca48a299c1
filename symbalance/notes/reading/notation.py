"""A letter written as a function, x(θ), on the left of a relation."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from symbalance.document.letters import TIME_DOTS, is_greek, plain_letter
from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.tokens import Token


def head_and_argument(side: Sequence[Token]) -> tuple[list[Token], list[Token]] | None:
    """Return a letter, perhaps with dots above, and what stands in the brackets right after it."""
    place = next((n for n, token in enumerate(side) if token.kind == "open" and token.value == "("), 0)
    closed = bool(side) and side[-1].kind == "close" and side[-1].value == ")"
    head, inside = list(side[:place]), list(side[place + 1 : -1])
    if not closed or not inside or not _is_letter(head) or any(t.kind == "close" for t in _outer(inside)):
        return None
    return head, inside


def _outer(tokens: Sequence[Token]) -> list[Token]:
    """Return the brackets that close what was not opened among the tokens."""
    depth, found = 0, []
    for token in tokens:
        depth += {"open": 1, "close": -1}.get(token.kind, 0)
        if depth < 0:
            found.append(token)
    return found


def _is_letter(head: Sequence[Token]) -> bool:
    letters = [token for token in head if token.kind == "name"]
    if len(letters) != 1 or letters[0].value == "pi":
        return False
    dotted = head[0].is_cmd(*TIME_DOTS)
    rest = [token for token in head[dotted:] if token.kind != "name"]
    return not rest or (dotted and [t.value for t in rest] == ["{", "}"])


def is_variable(inside: Sequence[Token]) -> bool:
    """Tell whether brackets hold one angle, or time: x(θ) is x."""
    return len(inside) == 1 and inside[0].kind == "name" and _is_running(inside[0].value)


def _is_running(name: str) -> bool:
    return name == "t" or is_greek(name)


def is_value(inside: Sequence[Token]) -> bool:
    """Tell whether brackets hold a number or an angle in π or degrees: x(0) is a value of x."""
    if len(inside) == 1 and inside[0].kind in ("number", "vulgar"):
        return True
    letters = [token.value for token in inside if token.kind == "name"]
    angle = "pi" in letters or any(token.kind == "degree" for token in inside)
    called = any(token.kind == "function" for token in inside)
    return angle and not called and all(name == "pi" or _is_running(name) for name in letters)


def shortened(head: list[Token], inside: Sequence[Token], last: Token) -> tuple[list[Token], str]:
    """Return x for x(θ), in the place of the whole, and the remark."""
    name = shown(head)
    return [*head[:-1], replace(head[-1], end=last.end)], f"{name}({shown(inside)}) read as {name}"


def refusal(head: Sequence[Token], inside: Sequence[Token]) -> ReadingError:
    """Return the refusal of x(π)."""
    what = f"a value of a function: {shown(head)}({shown(inside)})"
    return ReadingError(head[0].start, what, "write out what is meant")


def shown(tokens: Sequence[Token]) -> str:
    """Return tokens as text: names by their signs, commands by name."""
    signs = {"cmd": lambda word: f"\\{word} ", "name": plain_letter}
    pieces = (signs.get(token.kind, str)(token.value) for token in tokens)
    return "".join(pieces).replace(" {", "{")
