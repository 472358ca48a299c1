"""The lexer's place in the text; numbers and letters."""

from __future__ import annotations

import re
from collections.abc import Collection

from symbalance.document.letters import FUNCTION_WORDS
from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.naming import with_scripts
from symbalance.notes.reading.numerals import read_number
from symbalance.notes.reading.tokens import Token
from symbalance.notes.reading.vocabulary import vocabulary

_DIGITS = re.compile(r"[0-9]+")


class Scanner:
    """Walks over one formula's text; every offset is one of the whole document."""

    def __init__(self, text: str, start: int, end: int, names: Collection[str]) -> None:
        self.text, self.place, self.end = text, start, end
        self.words = vocabulary(names)
        self.tokens: list[Token] = []
        self.skips: dict[int, int] = {}
        self.latex = "\\" in text[start:end]

    def _add(self, kind: str, value: str, stop: int) -> None:
        self.tokens.append(Token(kind, value, self.place, stop))
        self.place = stop

    def _decimal_point(self, sign: str) -> bool:
        return sign == "." and self.text[self.place + 1 : min(self.place + 2, self.end)].isdecimal()

    def _number(self) -> None:
        scientific = "e" not in self.words.names
        if not (found := read_number(self.text, self.place, self.end, scientific)):
            raise ReadingError(self.place, "a digit that is not read", "write it as 0 to 9")
        self.tokens.append(found)
        self.place = found.end

    def _word(self) -> None:
        found = self.words.longest(self.text, self.place, self.end)
        if found and found[0] != "name":
            kind, word = found
            value = FUNCTION_WORDS.get(word, word)
            self._add("name" if kind == "constant" else kind, value, self.place + len(word))
            return
        word = found[1] if found else self.text[self.place]
        digits = self._touching_digits(self.place + len(word))
        word += "" if self._is_imaginary(word, word + digits) else digits
        self._letter(word, self.place + len(word))

    def _touching_digits(self, place: int) -> str:
        """Return digits that touch a letter: M2 is a letter of its own, x 2 a product."""
        found = _DIGITS.match(self.text, place, self.end)
        return "" if found is None or self._expects_argument() else found.group()

    def _is_imaginary(self, word: str, whole: str) -> bool:
        """Tell whether i2 is i times 2: in a power of e, where neither i nor i2 is a letter."""
        if word not in ("i", "j") or word in self.words.names or whole in self.words.names:
            return False
        return any(token.value in ("e", "exp") for token in self.tokens[-40:])

    def _expects_argument(self) -> bool:
        last = self.tokens[-1] if self.tokens else None
        return last is not None and (last.kind in ("sup", "under") or last.is_cmd("frac", "sqrt"))

    def _letter(self, base: str, stop: int) -> None:
        known = self.words.names
        name, stop = (base, stop) if "_" in base else with_scripts(self.text, base, stop, self.end, known)
        if "_" in base:
            while stop < self.end and self.text[stop] in "'′’":
                name, stop = name + "'", stop + 1
        if name in ("Delta", "delta") and (after := self._difference(name, stop)):
            name, stop = after
        self._add("name", name, stop)

    def _difference(self, name: str, stop: int) -> tuple[str, int] | None:
        found = re.compile(r"\s*([A-Za-z])").match(self.text, stop, self.end)
        if found and f"{name}_{found.group(1)}" in self.words.names and name not in self.words.names:
            return f"{name}_{found.group(1)}", found.end()
        return None
