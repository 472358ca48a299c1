"""The smallest pieces of a formula, each with the place where it stands."""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction


@dataclass(frozen=True, slots=True)
class Token:
    """A piece of a formula from `start` to `end` (offsets in the document).

    Kinds: number, name, function, op (+ - * /), rel, open, close, bar, sup, sub, under, cmd, sep,
    dots, degree. `sub` carries a subscript that follows something other than a letter; `under` is a
    bare underscore after a sum sign or a function. `spaced` tells of a space typed as such before it.
    """

    kind: str
    value: str
    start: int
    end: int
    number: Fraction = Fraction(0)
    place: Fraction | None = None
    spaced: bool = False

    def moved(self, offset: int) -> Token:
        """Return the token so many characters further on."""
        return replace(self, start=self.start + offset, end=self.end + offset)

    def is_op(self, signs: str) -> bool:
        """Tell whether this is one of the operators."""
        return self.kind == "op" and self.value in signs

    def is_cmd(self, *names: str) -> bool:
        """Tell whether this is one of the commands."""
        return self.kind == "cmd" and self.value in names


CLOSER = {"(": ")", "[": "]", "{": "}", "\\{": "\\}", "<": ">", "|": "|"}
