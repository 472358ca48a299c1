r"""What stands at a brace without a relation: \underbrace{x + x}_{2x} says that x + x = 2x.

A name is a name, \underbrace{m r ω²}_{F}, and words are words. A whole number may be the value, the
number of the term, or how many terms there are: it is not guessed which.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.formulas.lexer import Token
from symbalance.text import lazy_patterns as re

COUNT_OR_VALUE = "a number at a brace, which may be its value or a count"
_NUMBERED = re.compile(r"\}\s*[_^]\s*\{\s*(?P<number>[0-9])\s*\}")


def numbers_its_braces(text: str) -> bool:
    r"""Tell whether the braces of an equation are numbered from 1, {a}_{1} + {b}_{2}."""
    numbers = [int(match["number"]) for match in _NUMBERED.finditer(text)]
    return len(numbers) > 1 and numbers == list(range(1, len(numbers) + 1))


def with_equality_at_brace(
    body: Sequence[Token], note: Sequence[Token], *, is_numbered: bool
) -> list[Token]:
    """Return what stands at a brace around a formula, with the sign = before it where it is its value."""
    tokens = list(note)
    if tokens[0].kind == "rel" or any(token.kind == "dots" for token in body):
        return tokens  # a label at dots says how often
    numbers = [token for token in tokens if token.kind == "number"]
    is_lone = len(numbers) == 1 and all(t.kind == "number" or t.is_op("+-") for t in tokens)
    if is_lone and numbers[0].place is None and numbers[0].number:
        if is_numbered:
            return tokens
        raise ReadingError(
            tokens[0].start, COUNT_OR_VALUE, "write = before a value, or the count in words"
        )
    if is_lone or _is_computed(tokens, {token.value for token in body if token.kind == "name"}):
        return [Token("rel", "=", tokens[0].start, tokens[0].start), *tokens]
    return tokens


def _is_computed(tokens: Sequence[Token], letters: Collection[str]) -> bool:
    """Tell whether a label is a formula: with an operation, or in the letters at the brace."""
    kinds = {token.kind for token in tokens}
    if not kinds <= {"number", "name", "op", "function", "open", "close", "sup", "cmd"}:
        return False
    own = [token.value for token in tokens if token.kind == "name"]
    factors = [token for token in tokens if token.kind in ("number", "name", "function")]
    holds_operation = any(token.is_op("+-*/") for token in tokens) or "function" in kinds
    return len(factors) > 1 and (holds_operation or ("number" in kinds and set(own) <= set(letters)))
