"""A formula's text, LaTeX or plain, to tokens."""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import replace

from symbalance.document.letters import DOTTED, NAME_OF_SIGN, RAISED
from symbalance.notes.reading import signs
from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.lexer_commands import CommandScanner
from symbalance.notes.reading.naming import subscript_at
from symbalance.notes.reading.numerals import VULGAR, read_number
from symbalance.notes.reading.tokens import Token

LONGEST_EQUATION = 20_000
_DEGREE = re.compile(r"\^\s*(?:\{\s*\\circ\s*\}|\\circ(?![A-Za-z]))|[°˚º]|度|\\degree(?![A-Za-z])")
_SPACE = re.compile(
    r"(?:\\[,;:> \t\n]|\\(?:q?quad|enspace|enskip|thinspace|medspace|thickspace|hspace)(?![A-Za-z])|~)"
)
_ARROW = re.compile(r"-+>|=+>|<-+|<=+>")
_RELATION = re.compile(r"==|:=|<=|>=|!=")
_TWO_SIGNS = {"==": "=", ":=": "=", "<=": "≤", ">=": "≥", "!=": "≠"}


class Lexer(CommandScanner):
    """Cuts one formula into tokens; every offset is one of the whole document."""

    def run(self) -> list[Token]:
        """Return all tokens."""
        if self.end - self.place > LONGEST_EQUATION:
            what = f"an equation of more than {LONGEST_EQUATION} characters"
            raise ReadingError(self.place, what, "write it in parts")
        spaced = False
        while self.place < self.end:
            known, space = len(self.tokens), _SPACE.match(self.text, self.place, self.end)
            self._one()
            if len(self.tokens) == known:
                spaced = spaced or space is not None
            elif spaced:
                self.tokens[known] = replace(self.tokens[known], spaced=True)
                spaced = False
        return _with_three_dots(_without_braces(self.tokens))

    def _one(self) -> None:
        sign = self.text[self.place]
        if sign in " [" and self.plain_unit(sign):
            return
        if self.place in self.skips:
            self.place = self.skips.pop(self.place)
        elif sign.isspace() or sign == "&" or not sign.isprintable():
            self.place += 1
        elif found := _DEGREE.match(self.text, self.place, self.end):
            self._add("degree", "°", found.end())
        elif sign == "\\":
            self._backslash()
        elif sign.isascii() and sign.isalpha():
            self._word()
        elif sign in "0123456789" or self._decimal_point(sign):
            self._number()
        else:
            self._sign(sign)

    def _sign(self, sign: str) -> None:
        arrow = _ARROW.match(self.text, self.place, self.end)
        if arrow and arrow.group() != "<=":
            raise ReadingError(self.place, *signs.REFUSED["to"])
        if found := _RELATION.match(self.text, self.place, self.end):
            self._add("rel", _TWO_SIGNS[found.group()], found.end())
        elif dots := next((d for d in signs.DOTS_SIGNS if self.text.startswith(d, self.place)), None):
            self._add("dots", "…", self.place + len(dots))
        elif sign in signs.RELATION_SIGNS:
            self._add("rel", signs.RELATION_SIGNS[sign], self.place + 1)
        elif sign in signs.OPERATOR_SIGNS:
            self._operator(sign)
        elif sign in signs.OPENING:
            self._add("open", signs.OPENING[sign], self.place + 1)
        elif sign in signs.CLOSING:
            self._add("close", signs.CLOSING[sign], self.place + 1)
        else:
            self._rare_sign(sign)

    def _operator(self, sign: str) -> None:
        if self.text.startswith("**", self.place):
            self._add("sup", "^", self.place + 2)
        else:
            self._add("op", signs.OPERATOR_SIGNS[sign], self.place + 1)

    def _rare_sign(self, sign: str) -> None:
        simple = {"^": "sup", "|": "bar", ",": "sep", ";": "sep"}
        if sign in simple:
            self._add(simple[sign], sign, self.place + 1)
        elif sign == "_":
            self._underscore()
        elif sign in RAISED:
            self._raised()
        elif sign in VULGAR:
            self._vulgar(sign)
        elif sign in ("√", "∂", "∞", "Σ", "∑"):
            self._named_sign(sign)
        elif sign in DOTTED:
            letter, order = DOTTED[sign]
            self.tokens.append(Token("cmd", "dot" if order == 1 else "ddot", self.place, self.place + 1))
            self._letter(letter, self.place + 1)
        elif sign in NAME_OF_SIGN:
            self._greek(NAME_OF_SIGN[sign], self.place + 1)
        else:
            self._unknown(sign)

    def _named_sign(self, sign: str) -> None:
        if sign == "Σ" and "Sigma" in self.words.names:
            self._letter("Sigma", self.place + 1)
        else:
            name = {"√": "surd", "∂": "partial", "∞": "infty", "Σ": "sum", "∑": "sum"}[sign]
            self._add("cmd", name, self.place + 1)

    def _vulgar(self, sign: str) -> None:
        if self.tokens and self.tokens[-1].kind == "number" and self.tokens[-1].end == self.place:
            raise ReadingError(self.place, "a mixed number is not read", "write 5/2 for 2½")
        self._add("vulgar", sign, self.place + 1)

    def _underscore(self) -> None:
        last = self.tokens[-1] if self.tokens else None
        if last and (last.is_cmd("sum") or last.kind in ("function", "number", "sup", "close", "name")):
            if last.kind == "close":
                subscript = subscript_at(self.text, self.place, self.end)
                if subscript:
                    self._add("sub", *subscript)
                    return
            self._add("under", "_", self.place + 1)
            return
        raise ReadingError(self.place, "a subscript without its letter", "write the letter before it")

    def _raised(self) -> None:
        first = self.place
        self._add("sup", "^", first)
        self._add("open", "{", first)
        while self.place < self.end and (plain := RAISED.get(self.text[self.place])):
            self._raised_sign(plain)
        self._add("close", "}", self.place)

    def _raised_sign(self, plain: str) -> None:
        if plain.isdecimal():
            stop = self.place
            while stop < self.end and RAISED.get(self.text[stop], " ").isdecimal():
                stop += 1
            digits = "".join(RAISED[c] for c in self.text[self.place : stop])
            number = read_number(digits, 0, len(digits))
            assert number
            self.tokens.append(Token("number", digits, self.place, stop, number.number))
            self.place = stop
            return
        kinds = {"+": "op", "-": "op", "(": "open", ")": "close"}
        self._add(kinds.get(plain, "name"), plain, self.place + 1)

    def _unknown(self, sign: str) -> None:
        if sign in signs.REFUSED_SIGNS:
            raise ReadingError(self.place, *signs.REFUSED_SIGNS[sign])
        if sign == "~":
            self._tilde()
        elif sign in ".。":
            raise ReadingError(self.place, "a stray point", "remove it")
        else:
            raise ReadingError(
                self.place, f"sign {sign} is not read", "write it in letters and operators"
            )

    def _tilde(self) -> None:
        around = self.text[max(self.place - 1, 0) : self.place + 2]
        if self.latex:
            self.place += 1
        elif around[:1].isspace() and around[-1:].isspace():
            self._add("rel", "≈", self.place + 1)
        else:
            raise ReadingError(self.place, "~ is not read here", "write ≈")


def _without_braces(tokens: list[Token]) -> list[Token]:
    """{\\cos}^2 is \\cos^2."""
    kept: list[Token] = []
    for token in tokens:
        kept.append(token)
        kinds = [one.kind for one in kept[-3:]]
        if kinds == ["open", "function", "close"] and token.value == "}":
            kept[-3:] = [replace(kept[-2], start=kept[-3].start, end=token.end)]
    return kept


def _with_three_dots(tokens: list[Token]) -> list[Token]:
    """\\cdot \\cdot \\cdot is three dots."""
    joined: list[Token] = []
    place = 0
    while place < len(tokens):
        if all(t.is_op("*") for t in tokens[place : place + 3]) and len(tokens) >= place + 3:
            joined.append(Token("dots", "…", tokens[place].start, tokens[place + 2].end))
            place += 3
        else:
            joined.append(tokens[place])
            place += 1
    return joined


def lex(text: str, start: int, end: int, names: Collection[str]) -> list[Token]:
    """Return the tokens of text[start:end]."""
    return Lexer(text, start, end, names).run()
