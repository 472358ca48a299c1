"""Units among the letters of a formula: where \\mathrm{m}, 40 mm and [mm] are units and no letters."""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.letters import FUNCTION_WORDS
from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.pieces import relation_at_start
from symbalance.notes.reading.scanner import Scanner
from symbalance.notes.reading.units import (
    bracketed_unit_at,
    factor_tokens,
    is_set_apart,
    plain_unit_at,
    scale_of,
    unit_fraction_at,
    unit_set_at,
)

_WORD_FONTS = ("text", "textrm", "mbox")
_COMMANDS = ("mathrm", "unit", "si", *_WORD_FONTS)


class UnitScanner(Scanner):
    """Reads units: behind a number they multiply it, behind a letter only those of factor 1 are clear."""

    def set_unit(self, command: str) -> bool:
        """Read \\mathrm{mm} behind a number; tell whether it was a unit."""
        if command.endswith("frac") and self.is_behind_number():
            found = unit_fraction_at(self.text, self.place, self.end)
        else:
            found = unit_set_at(self.text, self.place, self.end) if command in _COMMANDS else None
        if found is None:
            return False
        unit, stop = found
        bare, scale = unit.strip("{} ~"), scale_of(unit)
        if len(bare) == 1 and self._is_factor_of_product(bare, stop):
            return False
        asked = command not in ("mathrm", *_WORD_FONTS) or self._may_be_unit(
            command, bare, scale is not None
        )
        if not asked:
            return False
        if scale is None:
            raise ReadingError(self.place, f"unit {bare} is not read", "leave it out of the formula")
        self.add_factor(bare, scale, stop)
        return True

    def _is_factor_of_product(self, letter: str, stop: int) -> bool:
        """Tell whether \\frac12\\mathrm{m}v^2 goes on after a declared letter: it is no unit there."""
        after = self.text[stop : min(stop + 8, self.end)].lstrip()
        goes_on = after[:1].isalnum() or after[:1] == "(" or after.startswith(("\\left", "\\frac"))
        apart = is_set_apart(self.text, self.place)
        return letter in self.words.names and goes_on and not apart

    def _may_be_unit(self, command: str, word: str, known: bool) -> bool:
        """Tell whether upright letters are a unit: behind a number; behind a letter if set apart."""
        names = frozenset() if command in _WORD_FONTS else self.words.names
        apart = is_set_apart(self.text, self.place)
        if word in FUNCTION_WORDS or (word in names and (len(word) > 1 or not self.is_behind_number())):
            return False
        if self.is_behind_number():
            foreign = word.isalpha() and len(word) > 1 and word[0] != "d"
            return known or (foreign and (apart or not all(sign in names for sign in word)))
        return known and bool(self.tokens) and (command in _WORD_FONTS or (apart and len(word) > 1))

    def is_behind_number(self) -> bool:
        """Tell whether a number, π or a bracket stands before the place."""
        if not self.tokens:
            return False
        last, pi = self.tokens[-1], "pi" not in self.words.names
        raised = last.kind == "number" and len(self.tokens) > 1 and self.tokens[-2].kind == "sup"
        if raised and not is_set_apart(self.text, self.place):
            return False
        return last.kind in ("number", "close", "vulgar") or (pi and last.value == "pi")

    def add_factor(self, unit: str, scale: tuple[Fraction, bool], stop: int) -> None:
        """Multiply by a unit's factor; behind a letter only a unit of factor 1 is clear."""
        if not self.is_behind_number() and scale != (1, False):
            what = f"unit {unit} behind a letter"
            raise ReadingError(self.place, what, "leave it out of the formula")
        self.tokens += factor_tokens(scale, self.place, stop)
        self.place = stop

    def plain_unit(self, sign: str) -> bool:
        """Read ` mm` or `[mm]` behind a number; tell whether it was a unit."""
        number = bool(self.tokens) and self.tokens[-1].kind == "number"
        if sign == " ":
            plain = number and not self.latex
            found = plain_unit_at(self.text, self.place, self.end, self.words.names) if plain else None
        else:
            found = bracketed_unit_at(self.text, self.place, self.end)
        scale = scale_of(found[0]) if found else None
        if not found or not scale or not (number or self._is_last(found[1])):
            return False
        self.add_factor(found[0], scale, found[1])
        return True

    def _is_last(self, stop: int) -> bool:
        """Tell whether a side ends at a place."""
        after = self.text[stop : self.end].lstrip()
        return self.tokens != [] and (not after or relation_at_start(after) != "")
