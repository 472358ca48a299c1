"""A place in a row of tokens, with the choices made and the remarks collected on the way."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from contextlib import contextmanager

from symbalance.document.formula import Constant, Formula, Name, Product, Span
from symbalance.notes.reading.failures import ReadingError, UndeclaredError
from symbalance.notes.reading.tokens import CLOSER, Token

DEEPEST = 60


class Cursor:
    """Walks over tokens; where usage differs, `choose` follows a script of decisions."""

    def __init__(
        self,
        tokens: Sequence[Token],
        names: Collection[str],
        script: Sequence[int],
        latex: bool,
        end: int,
    ) -> None:
        self.tokens, self.names, self.script = list(tokens), names, script
        self.latex, self.end = latex, end
        self.place = 0
        self.taken: list[tuple[int, int]] = []
        self.notes: list[str] = []
        self.bound: list[str] = []
        self.exponentials = 0
        self._depth = 0

    def choose(self, options: int = 2) -> int:
        """Return the way to read what follows, among so many; 0 is the usual way."""
        site = len(self.taken)
        option = self.script[site] if site < len(self.script) else 0
        self.taken.append((option, options))
        return option

    def note(self, remark: str) -> None:
        """Keep a remark on something read generously, once."""
        if remark not in self.notes:
            self.notes.append(remark)

    @contextmanager
    def deeper(self) -> Iterator[None]:
        """Go one level into brackets, scripts or arguments."""
        self._depth += 1
        if self._depth > DEEPEST:
            raise ReadingError(
                self.offset, f"more than {DEEPEST} levels of brackets", "write it in parts"
            )
        try:
            yield
        finally:
            self._depth -= 1

    @property
    def now(self) -> Token | None:
        """The token at the place, None at the end."""
        return self.tokens[self.place] if self.place < len(self.tokens) else None

    def ahead(self, steps: int) -> Token | None:
        """Return the token so many steps on."""
        place = self.place + steps
        return self.tokens[place] if 0 <= place < len(self.tokens) else None

    @property
    def offset(self) -> int:
        """Where the token at the place begins, in the document."""
        return self.now.start if self.now else self.end

    def take(self) -> Token:
        """Return the token at the place and go past it."""
        token = self.now
        if token is None:
            raise ReadingError(self.end, "the formula ends too early", "complete it")
        self.place += 1
        return token

    def at(self, kind: str, *values: str) -> bool:
        """Tell whether the token at the place is of a kind, and one of the values if any are given."""
        token = self.now
        return token is not None and token.kind == kind and (not values or token.value in values)

    def tight(self, steps: int = 0) -> bool:
        """Tell whether no space stands before the token so many steps on."""
        before, token = self.ahead(steps - 1), self.ahead(steps)
        return before is not None and token is not None and before.end == token.start

    def expect_close(self, opener: Token) -> Token:
        """Go past the bracket that closes `opener`."""
        token = self.now
        if token is None:
            raise ReadingError(opener.start, f"bracket {opener.value} is never closed", "close it")
        if token.kind not in ("close", "bar") or token.value != CLOSER[opener.value]:
            raise self.unexpected()
        return self.take()

    def unexpected(self) -> ReadingError:
        """Return the refusal of the token at the place."""
        token = self.now
        if token is None:
            return ReadingError(self.end, "the formula ends too early", "complete it")
        if token.kind == "sep":
            return ReadingError(token.start, f"{token.value} within a formula", "write two equations")
        if token.kind == "rel":
            return ReadingError(token.start, "a relation within brackets", "write it as an equation")
        if token.kind == "close":
            return ReadingError(
                token.start, f"bracket {token.value} was never opened", "open it or remove it"
            )
        return ReadingError(
            token.start, f"{shown(token)} is not expected here", "check what stands before it"
        )

    def since(self, place: int) -> Span:
        """Return the span from the token at `place` to the last one taken."""
        last = max(self.place - 1, 0)
        return (self.tokens[place].start, self.tokens[last].end) if self.tokens else (self.end, self.end)

    def letter(self, name: str, span: Span) -> Formula:
        """Return a letter's node: a declared or bound name, π, the imaginary i, j in an exponential."""
        if name in self.names or name in self.bound:
            return Name(name, span=span)
        if name == "pi":
            return Constant("pi", span=span)
        if name == "i" or (name == "j" and self.exponentials):
            return Constant("i", span=span)
        raise UndeclaredError(span[0], name)

    def expression(self) -> Formula:
        """Read a sum."""
        raise NotImplementedError

    def product(self) -> Formula:
        """Read a term of a sum."""
        raise NotImplementedError

    def run_of_factors(self) -> Formula:
        """Read factors side by side, with slashes."""
        raise NotImplementedError

    def atom(self) -> Formula:
        """Read one factor without its powers."""
        raise NotImplementedError

    def factor(self) -> Formula:
        """Read one factor with its powers."""
        raise NotImplementedError


def shown(token: Token) -> str:
    """Return a token as a refusal names it."""
    return f"\\{token.value}" if token.kind == "cmd" else token.value


def multiplied(factors: Sequence[Formula]) -> Formula:
    """Return the product of factors, the factor itself if there is one."""
    if len(factors) == 1:
        return factors[0]
    return Product(tuple(factors), span=(factors[0].span[0], factors[-1].span[1]))
