"""Brackets, exponents and the arguments of LaTeX commands."""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Call, Formula, Negative, Number, Power, Quotient
from symbalance.notes.reading.cursor import Cursor
from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.tokens import CLOSER, Token


class Scripts(Cursor):
    """Reads what stands in brackets or above a letter."""

    def group(self) -> Formula:
        """Read ( … ), [ … ], { … } or | … |, the last as an absolute value."""
        opener = self.take()
        closer = CLOSER[opener.value]
        with self.deeper():
            if self.at("close", closer):
                raise ReadingError(opener.start, "empty brackets", "write what stands in them")
            inside = self.contents()
        last = self.expect_close(opener)
        span = (opener.start, last.end)
        return Call("abs", inside, span=span) if opener.value == "|" else replace(inside, span=span)

    def contents(self) -> Formula:
        """Read a sum, or `a \\over b`."""
        first = self.place
        top = self.expression()
        if not self.at("cmd", "over"):
            return top
        self.take()
        return Quotient(top, self.expression(), span=self.since(first))

    def number(self, token: Token) -> Number:
        """Return a number's node."""
        return Number(token.number, token.place, span=(token.start, token.end))

    def exponent(self) -> Formula:
        """Read what follows ^: a group, a number or a letter, with a sign."""
        with self.deeper():
            if self.now and self.now.is_op("+-"):
                first, sign = self.place, self.take()
                power = self.exponent()
                return Negative(power, span=self.since(first)) if sign.value == "-" else power
            power = self.argument(whole_number=True)
            if self.at("sup") and self.tokens[self.place - 1].kind != "close":
                self.take()
                higher = self.exponent()
                return Power(power, higher, span=(power.span[0], higher.span[1]))
            return power

    def argument(self, whole_number: bool = False) -> Formula:
        """Read the argument of a command: a group, or the one sign that follows.

        `\\frac12` is a half: unless `whole_number`, only one digit is taken.
        """
        token = self.now
        if token is None:
            raise self.unexpected()
        if token.kind == "open":
            return self.group()
        if token.kind == "number":
            if not whole_number or (self.latex and self.tokens[self.place - 1].kind == "sup"):
                self.split_digit(token)
            return self.number(self.take())
        if token.kind == "name":
            self.take()
            return self.letter(token.value, (token.start, token.end))
        if token.kind in ("cmd", "vulgar", "function"):
            with self.deeper():
                return self.factor()
        raise self.unexpected()

    def split_digit(self, token: Token) -> None:
        """Cut a run of digits after its first, as TeX does."""
        if len(token.value) < 2 or not token.value.isdecimal():
            return
        cut = token.start + 1
        first, rest = token.value[0], token.value[1:]
        pieces = [
            Token("number", first, token.start, cut, type(token.number)(int(first))),
            Token("number", rest, cut, token.end, type(token.number)(int(rest))),
        ]
        self.tokens[self.place : self.place + 1] = pieces
