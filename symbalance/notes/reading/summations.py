"""Sum signs, with and without bounds."""

from __future__ import annotations

from symbalance.document.formula import Formula, Name, Summation
from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.scripts import Scripts


class Summations(Scripts):
    """Reads a sum sign; what it sums goes as far as the next + or -."""

    def summation(self) -> Formula:
        """Read \\sum_{k=0}^{N-1} body."""
        first = self.place
        self.take()
        index, lower = self._below_sign() if self.at("under") else (None, None)
        upper = self._above_sign() if self.at("sup") else None
        if index is None and self.at("under"):
            index, lower = self._below_sign()
        if upper is not None and lower is None:
            raise ReadingError(self.offset, "a sum with an end but no beginning", "write \\sum_{k=0}^{n}")
        self.bound.append(index.name if index else "")
        with self.deeper():
            body = self.product()
        self.bound.pop()
        return Summation(body, index, lower, upper, span=self.since(first))

    def _below_sign(self) -> tuple[Name, Formula | None]:
        self.take()
        braced = self.at("open", "{")
        opener = self.take() if braced else None
        token = self.take()
        if token.kind != "name":
            raise ReadingError(token.start, "a sum without an index", "write \\sum_{k=0}^{n}")
        index = Name(token.value, span=(token.start, token.end))
        lower = None
        if opener is not None:
            if self.at("rel", "="):
                self.take()
                lower = self.expression()
            self.expect_close(opener)
        return index, lower

    def _above_sign(self) -> Formula:
        self.take()
        return self.exponent()
