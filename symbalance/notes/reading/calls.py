"""Functions and how far their argument goes when no bracket says so."""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Negative,
    Number,
    Power,
    Quotient,
    names,
    walk,
)
from symbalance.document.letters import TIME_DOTS, is_greek
from symbalance.notes.reading.cursor import multiplied
from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.scripts import Scripts
from symbalance.notes.reading.tokens import Token

_INDICES = ("i", "j", "k", "n", "N")
_INVERSE = {"sin": "asin", "cos": "acos", "tan": "atan"}


class Calls(Scripts):
    """Reads a function with its argument.

    Without brackets the argument is the product that follows: sin 2θ cos θ = sin(2θ)·cos θ,
    cos n(θ + h) = cos(n(θ + h)). After a whole angle such as θ a bracket or fraction stands outside.
    """

    open_bars = 0

    def call(self) -> Formula:
        """Read sin x, sin^2 x, sin^{-1} x, sqrt(x), exp(x)."""
        first = self.place
        function = self.take()
        power = self._function_power(function.value)
        if self.at("under"):
            raise ReadingError(self.offset, "a logarithm's base is not read", "write log x / log b")
        self.exponentials += function.value == "exp"
        argument = self.call_argument(function.value)
        self.exponentials -= function.value == "exp"
        name = function.value
        if power is not None and _is_minus_one(power):
            name, power = self._inverse(name), None
        node = Call(name, argument, span=self.since(first))
        return node if power is None else Power(node, power, span=node.span)

    def _function_power(self, function: str) -> Formula | None:
        if not self.at("sup"):
            return None
        if function in ("sqrt", "exp", "abs"):
            raise ReadingError(self.offset, f"an exponent on {function}", "put the whole in brackets")
        self.take()
        if self.now is not None and self._is_power_and_multiple(self.now):
            self.split_digit(self.now)
        return self.exponent()

    def _is_power_and_multiple(self, token: Token) -> bool:
        """Tell sin^22θ, which is sin²(2θ), from sin^10θ and sin^22 θ."""
        following = self.ahead(1)
        touched = following is not None and following.kind == "name" and self.tight(1)
        digits = token.kind == "number" and token.value.isdecimal() and len(token.value) > 1
        return digits and touched and token.value[0] in "23456789" and token.value[1] != "0"

    def _inverse(self, function: str) -> str:
        if function not in _INVERSE:
            what = f"the inverse of {function} is not read"
            raise ReadingError(self.offset, what, "write it with asin, acos or atan")
        return _INVERSE[function]

    def call_argument(self, function: str) -> Formula:
        """Read the argument: the bracket that follows at once, else the product that follows."""
        with self.deeper():
            if self.at("open") or (self.at("bar") and not self.open_bars):
                return self._bracket()
            if function in ("sqrt", "abs"):
                return self.argument(whole_number=True)
            if self.now and self.now.is_op("+-"):
                first, sign = self.place, self.take()
                inside = self._open_argument()
                return Negative(inside, span=self.since(first)) if sign.value == "-" else inside
            return self._open_argument()

    def _bracket(self) -> Formula:
        raise NotImplementedError

    def starts_factor(self) -> bool:
        """Tell whether a factor begins at the place."""
        raise NotImplementedError

    def _open_argument(self) -> Formula:
        if self.at("function"):
            return self.call()
        if not self.starts_factor():
            raise ReadingError(self.offset, "a function without an argument", "write its argument")
        factors = [self.factor()]
        while self._goes_on(factors):
            factors.append(self.factor())
        inside = multiplied(factors)
        if self._tight_slash() and self.choose() == 1:
            self.take()
            bottom = self.factor()
            return Quotient(inside, bottom, span=(inside.span[0], bottom.span[1]))
        return inside

    def _tight_slash(self) -> bool:
        return self.now is not None and self.now.is_op("/") and self.tight() and self.tight(1)

    def _goes_on(self, factors: list[Formula]) -> bool:
        """Tell whether the factor at the place belongs to the argument too."""
        token = self.now
        if token is None or not self.starts_factor() or self._ends_argument(token):
            return False
        whole = any(map(_is_whole_angle, factors))
        if whole and (self._leaves_angle(token) or self._may_leave_angle(token, factors)):
            return not self._leaves_angle(token) and self.choose() == 1
        if not (token.kind in ("open", "vulgar", "bar") or token.is_cmd("frac", "sqrt", "surd")):
            return True
        if token.kind == "open" and not whole:
            return True
        if token.kind == "open" and not any(map(names, factors)):
            return False  # cos 45° [...]: an angle in numbers is complete
        return whole == bool(self.choose())

    def _leaves_angle(self, token: Token) -> bool:
        """Tell whether a factor after a whole angle is outside: \\cos\\phi\\,r, \\cos\\phi\\dot\\phi."""
        if _is_time(token):
            return False
        degrees = self.tokens[self.place - 1].kind == "degree"
        latin = _is_latin(token) and (degrees or not (self.latex or self.tight()))
        return token.spaced or latin or token.is_cmd(*TIME_DOTS)

    def _may_leave_angle(self, token: Token, factors: list[Formula]) -> bool:
        """Tell whether a Latin letter follows a Greek angle, \\cos\\theta r: usually it is outside."""
        greek = any(is_greek(name) for factor in factors for name in names(factor))
        return greek and _is_latin(token) and not _is_time(token)

    def _ends_argument(self, token: Token) -> bool:
        """Tell whether a factor can never belong to an argument already begun."""
        power_of_e = token.kind == "name" and token.value == "e" and "e" not in self.names
        return token.kind in ("function", "number") or token.is_cmd("sum") or power_of_e


def _is_whole_angle(factor: Formula) -> bool:
    """Tell whether a factor is an angle already: it holds a Greek letter, or is a part of π."""
    letters = names(factor)
    pi = any(isinstance(part, Constant) and part.name == "pi" for part in walk(factor))
    return any(map(is_greek, letters)) or (pi and not letters)


def _is_latin(token: Token) -> bool:
    """Tell whether a token is a Latin letter that counts nothing; n and k are multipliers."""
    greek = is_greek(token.value) or token.value == "pi"
    return token.kind == "name" and not greek and token.value not in _INDICES


def _is_time(token: Token) -> bool:
    return token.kind == "name" and token.value.split("_")[0] == "t"


def _is_minus_one(power: Formula) -> bool:
    return power in (Negative(Number(Fraction(1))), Number(Fraction(-1)))
