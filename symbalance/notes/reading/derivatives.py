"""Derivatives: d x/d t with a bar or in line, d^2 x/d t^2, and the operator d/dθ before a bracket."""

from __future__ import annotations

from symbalance.document.formula import Derivative, Formula, Name
from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.scripts import Scripts
from symbalance.notes.reading.tokens import Token

HIGHEST = 20


def _is_d(token: Token | None) -> bool:
    return token is not None and (
        token.is_cmd("partial") or (token.kind == "name" and token.value == "d")
    )


class Derivatives(Scripts):
    """Reads derivatives; where d is itself a declared letter, the quotient is the second reading."""

    def derivative_fraction(self) -> Formula | None:
        """Read \\frac{d^n f}{d x^n} if the fraction at the place is one."""
        top, bottom = self._fraction_parts()
        if not (_is_d(top) and _is_d(bottom)) or ("d" in self.names and self.choose() == 1):
            return None
        first = self.place
        self.place += 2
        order, body = self._above("{")
        if not self.at("close", "}"):
            raise self.unexpected()
        self.place += 2
        variable = self._below(order)
        if not self.at("close", "}"):
            raise self.unexpected()
        self.take()
        return self._whole(first, order, body, variable)

    def _fraction_parts(self) -> tuple[Token | None, Token | None]:
        """Return the first tokens within the two braces of \\frac{…}{…}."""
        if not (opener := self.ahead(1)) or opener.kind != "open":
            return None, None
        depth, steps = 1, 2
        while depth and (token := self.ahead(steps)):
            depth += {"open": 1, "close": -1}.get(token.kind, 0)
            steps += 1
        after = self.ahead(steps)
        braced = after is not None and after.kind == "open" and after.value == "{"
        variable = self.ahead(steps + 2)
        named = braced and variable is not None and variable.kind in ("name", "cmd")
        return self.ahead(2), self.ahead(steps + 1) if named else None

    def derivative_in_line(self) -> Formula | None:
        """Read dx/dt, d^2x/dt^2 or d/dt if it begins at the place, without spaces."""
        if not _is_d(self.now) or not self._line_pattern() or ("d" in self.names and self.choose() == 1):
            return None
        first = self.place
        order, body = self._above("/")
        self.take()
        variable = self._below(order)
        return self._whole(first, order, body, variable)

    def _line_pattern(self) -> bool:
        """Tell whether the tokens are d [^n] [letter] / d letter, tight."""
        steps = 1
        if (token := self.ahead(steps)) and token.kind == "sup":
            steps += self._power_length(steps)
        if (token := self.ahead(steps)) and token.kind == "name":
            steps += 1
        slash = self.ahead(steps)
        letter = self.ahead(steps + 2)
        if slash is None or not (slash.is_op("/") or slash.is_cmd("over")):
            return False
        named = _is_d(self.ahead(steps + 1)) and letter is not None and letter.kind == "name"
        return named and (slash.is_cmd("over") or self._all_tight(steps + 2))

    def _all_tight(self, steps: int) -> bool:
        return all(self.tight(step) for step in range(1, steps + 1))

    def _power_length(self, steps: int) -> int:
        following = self.ahead(steps + 1)
        return 4 if following is not None and following.kind == "open" else 2

    def _above(self, stop: str) -> tuple[int, Formula | None]:
        """Read d^n f; f may be missing."""
        self.take()
        order = self._order()
        ended = (
            self.at("close", "}")
            if stop == "{"
            else bool(self.now and (self.now.is_op("/") or self.now.is_cmd("over")))
        )
        if ended:
            return order, None
        if stop == "/":
            token = self.take()
            return order, self.letter(token.value, (token.start, token.end))
        return order, self.product()

    def _order(self) -> int:
        if not self.at("sup"):
            return 1
        self.take()
        place = self.offset
        power = self.exponent()
        value = getattr(power, "value", None)
        if value is None or value.denominator != 1 or not 1 <= value <= HIGHEST:
            raise ReadingError(place, "a derivative of an order that is not read", "write a whole number")
        return int(value)

    def _below(self, order: int) -> Name:
        """Read d x^n, with the same n."""
        self.take()
        variable = self._variable()
        place = self.offset
        if self._order() != order:
            raise ReadingError(place, "two different orders in one derivative", "make them equal")
        return variable

    def _variable(self) -> Name:
        """Read the letter under the bar; time needs no declaration."""
        token = self.now
        if token is not None and token.kind == "name" and token.value == "t":
            self.take()
            return Name("t", span=(token.start, token.end))
        place = self.offset
        variable = self.atom()
        if not isinstance(variable, Name):
            raise ReadingError(place, "a derivative by something that is no letter", "name the variable")
        return variable

    def _whole(self, first: int, order: int, body: Formula | None, variable: Name) -> Formula:
        if body is None:
            with self.deeper():
                bracket = self.at("open", "(", "[", "{", "\\{")
                body = self.group() if bracket else self.run_of_factors()
        return Derivative(body, variable, order, span=self.since(first))
