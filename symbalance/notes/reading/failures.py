"""Errors of the reader: where a formula cannot be read, why, and what to do about it."""

from __future__ import annotations

from symbalance.errors import PicklableError


class ReadingError(PicklableError):
    """A formula the reader refuses; `offset` counts characters in the text it was given.

    >>> print(ReadingError(3, "unknown command \\\\foo", "write it out"))
    at character 4: unknown command \\foo; write it out
    """

    def __init__(self, offset: int, what: str, remedy: str = "") -> None:
        self.offset, self.what, self.remedy = offset, what, remedy
        tail = f"; {remedy}" if remedy else ""
        super().__init__(f"at character {offset + 1}: {what}{tail}")


class UndeclaredError(ReadingError):
    """A letter that is not declared."""

    def __init__(self, offset: int, letter: str) -> None:
        self.letter = letter
        remedy = f'declare it: {_key(letter)} = "its meaning" in the [symbols] of the sidecar'
        super().__init__(offset, f"letter {letter} is not declared", remedy)


def _key(letter: str) -> str:
    bare = letter.isascii() and letter.replace("_", "").isalnum()
    return letter if bare else f'"{letter}"'
