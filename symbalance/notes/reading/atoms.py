"""Single factors: numbers, letters, brackets, fractions, roots, accents and their powers."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Constant,
    Derivative,
    Formula,
    Name,
    Number,
    Power,
    Product,
    Quotient,
    Span,
)
from symbalance.document.letters import ACCENTS, TIME_DOTS
from symbalance.notes.reading.calls import Calls
from symbalance.notes.reading.derivatives import Derivatives
from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.numerals import VULGAR
from symbalance.notes.reading.summations import Summations
from symbalance.notes.reading.tokens import Token

_STARTS = frozenset({"number", "name", "function", "vulgar"})


class Atoms(Calls, Derivatives, Summations):
    """Reads one factor."""

    def starts_factor(self) -> bool:
        """Tell whether a factor begins at the place."""
        token = self.now
        if token is None:
            return False
        if token.kind == "cmd":
            return token.value != "over"
        if token.kind == "bar":
            return not self.open_bars
        return token.kind in _STARTS or token.kind == "open"

    def factor(self) -> Formula:
        """Read an atom with what is attached to it: powers, degrees."""
        first = self.place
        node = self.atom()
        powers = 0
        while self.now is not None:
            if self.at("degree"):
                self.take()
                node = _degrees(node, self.since(first))
            elif self.at("sup"):
                powers += 1
                if powers > 1:
                    raise ReadingError(
                        self.offset, "two exponents on one base", "put the base in brackets"
                    )
                self.take()
                node = Power(node, self.exponent(), span=self.since(first))
            elif self.at("under") or self.at("sub"):
                raise ReadingError(
                    self.offset, "a subscript that is not a letter's", "write the letter itself"
                )
            else:
                break
        return node

    def atom(self) -> Formula:
        """Read one number, letter, bracket or command."""
        token = self.now
        if token is None:
            raise self.unexpected()
        if token.kind == "number":
            return self.number(self.take())
        if token.kind == "vulgar":
            return self._vulgar(self.take())
        if token.kind == "name":
            return self._name(token)
        if token.kind == "function":
            return self.call()
        if token.kind == "cmd":
            return self._command(token)
        return self._bracket()

    def _vulgar(self, token: Token) -> Formula:
        span = (token.start, token.end)
        top, bottom = (Number(Fraction(n), span=span) for n in VULGAR[token.value])
        return Quotient(top, bottom, span=span)

    def _bracket(self) -> Formula:
        if self.at("open"):
            return self.group()
        if self.at("bar"):
            self.open_bars += 1
            opener = self.take()
            with self.deeper():
                inside = self.contents()
            if not (self.at("bar") or self.at("close", "|")):
                raise ReadingError(opener.start, "bracket | is never closed", "close it")
            last = self.take()
            self.open_bars -= 1
            return Call("abs", inside, span=(opener.start, last.end))
        raise self.unexpected()

    def _name(self, token: Token) -> Formula:
        if (derivative := self.derivative_in_line()) is not None:
            return derivative
        following = self.ahead(1)
        if token.value == "e" and "e" not in self.names and following and following.kind == "sup":
            return self._exponential()
        self.take()
        return self.letter(token.value, (token.start, token.end))

    def _exponential(self) -> Formula:
        first = self.place
        self.place += 2
        self.exponentials += 1
        power = self.exponent()
        self.exponentials -= 1
        return Call("exp", power, span=self.since(first))

    def _command(self, token: Token) -> Formula:
        readers = {
            "frac": self._fraction,
            "sqrt": self._root,
            "surd": self._root,
            "sum": self.summation,
            "infty": self._infinity,
            "boxed": self._boxed,
        }
        readers |= dict.fromkeys(TIME_DOTS, self._dotted) | dict.fromkeys(ACCENTS, self._accented)
        return readers.get(token.value, self._operator)()

    def _operator(self) -> Formula:
        if (derivative := self.derivative_in_line()) is not None:
            return derivative
        raise self.unexpected()

    def _infinity(self) -> Formula:
        token = self.take()
        return Constant("infinity", span=(token.start, token.end))

    def _boxed(self) -> Formula:
        self.take()
        if not self.at("open"):
            raise self.unexpected()
        return self.group()

    def _fraction(self) -> Formula:
        if (derivative := self.derivative_fraction()) is not None:
            return derivative
        first = self.place
        self.take()
        top = self.argument()
        bottom = self.argument()
        return Quotient(top, bottom, span=self.since(first))

    def _root(self) -> Formula:
        first = self.place
        self.take()
        if self.at("open", "[") and self.tokens[first].value == "sqrt" and self._has_index():
            index = self.group()
            return self._indexed_root(index, self.argument(True), self.since(first))
        if self.at("open", "(") and self.tokens[first].value == "sqrt":
            self.note("\\sqrt( ) read as the root of the bracket")
        return Call("sqrt", self.argument(True), span=self.since(first))

    def _has_index(self) -> bool:
        """Tell whether [n] is followed by something to take the root of."""
        steps = 1
        while (token := self.ahead(steps)) and token.kind != "close":
            steps += 1
        after = self.ahead(steps + 1)
        return after is not None and (after.kind in _STARTS or after.kind in ("open", "cmd"))

    def _indexed_root(self, index: Formula, inside: Formula, span: Span) -> Formula:
        span = (span[0], inside.span[1])
        if index == Number(Fraction(2)):
            return Call("sqrt", inside, span=span)
        return Power(
            inside, Quotient(Number(Fraction(1), span=index.span), index, span=index.span), span=span
        )

    def _dotted(self) -> Formula:
        first = self.place
        order = TIME_DOTS[self.take().value]
        name = self._bare_name()
        span = self.since(first)
        return Derivative(self.letter(name, span), Name("t", span=span), order, span=span)

    def _accented(self) -> Formula:
        first = self.place
        accent = ACCENTS[self.take().value]
        bare = self._bare_name()
        name = f"{accent}_{bare}"
        if accent == "vec" and name not in self.names and bare in self.names:
            name = bare
            self.note(f"vector {bare} read as {bare}")
        return self.letter(name, self.since(first))

    def _bare_name(self) -> str:
        """Read the letter under an accent and the subscript that follows the accent."""
        token = self.take()
        braced = token.kind == "open" and token.value == "{"
        inner = self.take() if braced else token
        if inner.kind != "name" or (braced and not self.at("close", "}")):
            raise ReadingError(
                inner.start, "an accent over more than one letter", "write one letter under it"
            )
        if braced:
            self.take()
        scripts = self.take().value if self.at("sub") else ""
        return f"{inner.value}_{scripts}" if scripts else inner.value


def _degrees(node: Formula, span: Span) -> Formula:
    """30° is 30 π/180."""
    place = (span[1] - 1, span[1])
    half_turn = Number(Fraction(180), span=place)
    unit = Quotient(Constant("pi", span=place), half_turn, span=place)
    return Product((replace(node), unit), span=span)
