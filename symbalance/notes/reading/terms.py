"""Sums, products and slashes."""

from __future__ import annotations

from symbalance.document.formula import Dots, Formula, Negative, Number, Product, Quotient, Sum
from symbalance.notes.reading.atoms import Atoms
from symbalance.notes.reading.cursor import multiplied
from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.tokens import Token

MOST_SLASHES = 20


class Terms(Atoms):
    """Reads a whole formula."""

    def expression(self) -> Formula:
        """Read a sum; three dots are a term, with or without a sign before them."""
        first = self.place
        terms = [self._first_term()]
        while (token := self.now) is not None:
            if token.kind == "dots":
                terms.append(self._dots())
            elif token.is_op("+-"):
                terms.append(self._signed_term())
            elif isinstance(terms[-1], Dots) and self.starts_factor():
                terms.append(self.product())
            else:
                break
        return terms[0] if len(terms) == 1 else Sum(tuple(terms), span=self.since(first))

    def _first_term(self) -> Formula:
        if self.at("dots"):
            return self._dots()
        if self.now is not None and self.now.is_op("+-"):
            return self._signed_term()
        return self.product()

    def _dots(self) -> Formula:
        token = self.take()
        return Dots(span=(token.start, token.end))

    def _signed_term(self) -> Formula:
        first = self.place
        minus = self._signs()
        term = self._dots() if self.at("dots") else self._order_term() or self.product()
        if isinstance(term, Dots):
            return term
        for _ in range(minus):
            term = Negative(term, span=self.since(first))
        return term

    def _order_term(self) -> Dots | None:
        """Read O(x^7) at the end of a sum: what is left out."""
        following = self.ahead(1)
        if not self.at("name", "O") or "O" in self.names or not following or following.value != "(":
            return None
        depth, steps = 1, 2
        while depth and (token := self.ahead(steps)):
            depth += {"open": 1, "close": -1}.get(token.kind, 0)
            steps += 1
        after = self.ahead(steps)
        if depth or not (after is None or after.kind == "close"):
            return None
        first = self.place
        self.place += steps
        return Dots(span=self.since(first))

    def _signs(self) -> int:
        """Take signs and return how many are minus."""
        taken = [self.take()]
        while self.now is not None and self.now.is_op("+-"):
            taken.append(self.take())
        if len(taken) > 3:
            raise ReadingError(taken[0].start, "more than three signs in a row", "write one")
        if [t.value for t in taken] == ["+", "+"]:
            self.note("+ + read as +")
        if self.now is None:
            raise ReadingError(taken[-1].start, f"nothing stands after {taken[-1].value}", "complete it")
        return sum(t.value == "-" for t in taken)

    def product(self) -> Formula:
        """Read runs of factors joined by · or ×."""
        factors: list[Formula] = []
        self._join(factors, self.run_of_factors())
        while (token := self.now) is not None and token.is_op("*"):
            self.take()
            if self.at("dots"):
                raise ReadingError(self.offset, "dots within a product are not read", "write the factors")
            self._join(factors, self._signed_run(token))
        return multiplied(factors)

    def _join(self, factors: list[Formula], run: Formula) -> None:
        bracketed = self.tokens[self.place - 1].kind == "close" and run.span[1] == self._last_end()
        whole = isinstance(run, Product) and not (bracketed and self._opens(run))
        if whole and isinstance(run, Product) and not self._is_degrees(run):
            factors.extend(run.factors)
        else:
            factors.append(run)

    def _opens(self, run: Product) -> bool:
        return run.span[0] != run.factors[0].span[0]

    def _last_end(self) -> int:
        return self.tokens[self.place - 1].end

    def _is_degrees(self, run: Product) -> bool:
        last = run.factors[-1]
        return isinstance(last, Quotient) and last.numerator.span == last.denominator.span

    def _signed_run(self, operator: Token) -> Formula:
        if self.now is None:
            raise ReadingError(
                operator.start, "nothing stands after the multiplication sign", "complete it"
            )
        if not self.now.is_op("+-"):
            return self.run_of_factors()
        first, sign = self.place, self.take()
        run = self.run_of_factors()
        return Negative(run, span=self.since(first)) if sign.value == "-" else run

    def run_of_factors(self) -> Formula:
        """Read factors side by side; a slash divides all of the run before it by one factor."""
        if not self.starts_factor():
            raise self.unexpected()
        factors: list[Formula] = [self.factor()]
        slashes = 0
        while self.now is not None:
            if self.now.is_op("/"):
                slashes += 1
                if slashes > MOST_SLASHES:
                    raise ReadingError(self.offset, "too many slashes", "write brackets")
                top = multiplied(factors)
                bottom = self._denominator()
                factors = [Quotient(top, bottom, span=(top.span[0], bottom.span[1]))]
            elif self.starts_factor():
                self._refuse_two_numbers(factors[-1])
                factors.append(self.factor())
            else:
                break
        return multiplied(factors)

    def _refuse_two_numbers(self, last: Formula) -> None:
        if (
            self.at("number")
            and isinstance(last, Number)
            and self.tokens[self.place - 1].kind == "number"
        ):
            raise ReadingError(self.offset, "two numbers side by side", "write · between them")

    def _denominator(self) -> Formula:
        """Read what follows a slash: one factor, or digits with the letters that touch them (1/2λ)."""
        slash, first = self.take(), self.place
        if self.now is None:
            raise ReadingError(slash.start, "nothing stands after the slash", "complete it")
        if self.now.is_op("+-"):
            sign = self.take()
            bottom = self.factor()
            return Negative(bottom, span=self.since(first)) if sign.value == "-" else bottom
        if not self.starts_factor():
            raise self.unexpected()
        digits = self.at("number")
        factors = [self.factor()]
        if self.place != first + 1 and isinstance(factors[0], Number):
            return factors[0]
        touching = self.tight() and (self.at("name") or (digits and self.at("open", "(", "[")))
        if not touching:
            return factors[0]
        usual_inside = digits and self.at("name")
        inside = usual_inside if self.choose() == 0 else not usual_inside
        while inside and self.tight() and (self.at("name") or (len(factors) == 1 and self.at("open"))):
            factors.append(self.factor())
        return multiplied(factors)
