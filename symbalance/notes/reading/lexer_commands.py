"""What begins with a backslash, to tokens."""

from __future__ import annotations

import re

from symbalance.document.letters import ACCENTS, FONTS, FUNCTION_WORDS, GREEK_SIGN, TIME_DOTS
from symbalance.notes.reading import signs
from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.lexer_units import UnitScanner
from symbalance.notes.reading.naming import matching_brace, with_scripts
from symbalance.notes.reading.regions import ENVIRONMENTS

_LONGEST_NOTED = 2000
_COMMAND = re.compile(r"\\([A-Za-z]+)\*?")
_FONT_WORD = re.compile(r"\s*\{\s*([A-Za-z0-9]+)\s*\}")
_LEFT_RIGHT = re.compile(r"\\(left|right|[bB]igg?[lr])\s*(\\[{}|]|\\[lr]?vert(?![A-Za-z])|[|.])")
_SIZED_BRACKET = re.compile(r"\\(?:left|right|[bB]igg?[lrm]?)\s*([()\[\]])")
_ARGUMENT = re.compile(r"\s*\{[^{}]*\}")
_ENVIRONMENT = re.compile(r"\s*\{([A-Za-z]+)\*?\}(?:\s*\{\s*[0-9]+\s*\}|\[[a-z]\])?")


class CommandScanner(UnitScanner):
    """Reads commands."""

    def _backslash(self) -> None:
        if bracket := _SIZED_BRACKET.match(self.text, self.place, self.end):
            kind = "open" if bracket.group(1) in "([" else "close"
            self._add(kind, bracket.group(1), bracket.end())
        elif found := _LEFT_RIGHT.match(self.text, self.place, self.end):
            self._sized(found)
        elif found := _COMMAND.match(self.text, self.place, self.end):
            self._command(found.group(1), found.end())
        else:
            self._escaped(self.text[self.place + 1 : self.place + 2])

    def _sized(self, found: re.Match[str]) -> None:
        side, delimiter = found.group(1), found.group(2)
        if delimiter == ".":
            raise ReadingError(self.place, "a bracket with one side only", "write both sides")
        if "|" in delimiter or "vert" in delimiter:
            self._add("open" if side in ("left",) or side[-1] == "l" else "close", "|", found.end())
        else:
            self._add("open" if delimiter == "\\{" else "close", delimiter, found.end())

    def _escaped(self, sign: str) -> None:
        if sign in ("{", "}"):
            self._add("open" if sign == "{" else "close", "\\" + sign, self.place + 2)
        elif sign == "|":
            self._add("bar", "|", self.place + 2)
        elif sign == "%":
            raise ReadingError(self.place, *signs.REFUSED_SIGNS["%"])
        elif not sign or sign in ",;:!> \t\r\n/\\":
            self.place += 2
        else:
            raise ReadingError(self.place, f"unknown command \\{sign}", "write it without")

    def _command(self, name: str, stop: int) -> None:
        if self.text[stop - 1] == "*":
            stop -= 1
        if self.set_unit(name):
            return
        if name in GREEK_SIGN:
            self._greek(name, stop)
        elif name in FUNCTION_WORDS and name != "sqrt":
            self._add("function", FUNCTION_WORDS[name], stop)
        elif name in signs.RELATION_COMMANDS:
            self._add("rel", signs.RELATION_COMMANDS[name], stop)
        elif name in signs.OPERATOR_COMMANDS:
            self._add("op", signs.OPERATOR_COMMANDS[name], stop)
        elif name in signs.DOTS_COMMANDS:
            self._add("dots", "…", stop)
        elif name in signs.BRACKET_COMMANDS:
            self._add(*signs.BRACKET_COMMANDS[name], stop)
        else:
            self._other_command(name, stop)

    def _other_command(self, name: str, stop: int) -> None:
        if name in signs.STRUCTURE or name in ACCENTS or name in TIME_DOTS:
            self._add("cmd", "frac" if name.endswith("frac") else name, stop)
        elif name in FONTS:
            self._font(name, stop)
        elif name in signs.SPACE_COMMANDS:
            self.place = stop
        elif name in ("underbrace", "overbrace"):
            self._noted(stop)
        elif name in signs.SPACE_WITH_ARGUMENT:
            argument = _ARGUMENT.match(self.text, stop, self.end)
            self.place = argument.end() if argument else stop
        elif name in signs.REFUSED:
            raise ReadingError(self.place, *signs.REFUSED[name])
        elif name in ("begin", "end"):
            self._environment(stop)
        else:
            raise ReadingError(self.place, f"unknown command \\{name}", "write what it stands for")

    def _noted(self, stop: int) -> None:
        """\\underbrace{X}_{words} is X: the words will be skipped."""
        sign = "_" if self.text.startswith("\\under", self.place) else "^"
        after = matching_brace(self.text, stop, self.end, _LONGEST_NOTED)
        found = re.compile(rf"\s*\{sign}\s*(?=\{{)").match(self.text, after, self.end)
        if found:
            self.skips[after] = matching_brace(self.text, found.end(), self.end, _LONGEST_NOTED)
        self.place = stop

    def _environment(self, stop: int) -> None:
        found = _ENVIRONMENT.match(self.text, stop, self.end)
        if not found or found.group(1) not in ENVIRONMENTS:
            what = "cases, arrays and matrices are not read"
            raise ReadingError(self.place, what, "write each row as an equation")
        self.place = found.end()

    def _greek(self, name: str, stop: int) -> None:
        if name == "pi" and "pi" not in self.words.names:
            scripted, after = with_scripts(self.text, name, stop, self.end, self.words.names)
            self._add("name", scripted, after if scripted != name else stop)
        else:
            self._letter(name, stop)

    def _font(self, name: str, stop: int) -> None:
        """\\mathrm{Lh} is the run Lh, \\operatorname{sin} the function; the rest stays as it is."""
        found = _FONT_WORD.match(self.text, stop, self.end)
        if found and found.group(1) in FUNCTION_WORDS and found.group(1) not in self.words.names:
            self._add("function", FUNCTION_WORDS[found.group(1)], found.end())
        elif found and found.group(1)[0].isalpha() and self._is_one_letter(found.group(1)):
            self._letter(found.group(1), found.end())
        elif found and name == "operatorname":
            raise ReadingError(
                self.place, f"unknown function {found.group(1)}", "write what it stands for"
            )
        else:
            self.place = stop

    def _is_one_letter(self, word: str) -> bool:
        return len(word) == 1 or word in self.words.names or word[1:].isdecimal()
