"""A chain while its lines are being gathered."""

from __future__ import annotations

from dataclasses import dataclass, field

from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.items import Item
from symbalance.notes.reading.notation import head_and_argument, is_value, is_variable, refusal, shortened
from symbalance.notes.reading.tokens import CLOSER, Token

EQUALITIES = ("=", "≈", "≡")


@dataclass(slots=True)
class Draft:
    """A chain while its lines are being gathered."""

    item: Item
    names: set[str]
    sides: list[list[Token]] = field(default_factory=lambda: [[]])
    signs: list[Token] = field(default_factory=list)
    items: list[Item] = field(default_factory=list)
    opened: list[Token] = field(default_factory=list)
    failures: dict[int, ReadingError] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)
    called: list[str] = field(default_factory=list)

    @property
    def last(self) -> Item:
        """The item added last."""
        return self.items[-1]

    @property
    def is_unfinished(self) -> bool:
        """Tell whether the last side wants more: an open bracket, an operator or relation at its end."""
        side = self.sides[-1]
        return bool(self.opened) or not side or side[-1].kind == "op"

    def add(self, item: Item, tokens: list[Token]) -> None:
        """Take the tokens of one more item."""
        self.items.append(item)
        if tokens and tokens[0].kind == "rel" and self.opened:
            self._leave_open()
        for place, token in enumerate(tokens):
            if token.kind == "rel" and not self.opened:
                self.signs.append(token)
                self.sides.append([])
            elif self._fits(token, place == len(tokens) - 1):
                self.sides[-1].append(token)
        if self.signs:
            self._without_argument(0)

    def _without_argument(self, place: int) -> None:
        """Read x(θ), all of the left side, as x, and refuse x(0); x is so called on later sides too."""
        side = self.sides[place]
        if place in self.failures or not (parts := head_and_argument(side)):
            return
        head, inside = parts
        name = "".join(token.value for token in head)
        if place and name not in self.called:
            return
        if is_variable(inside):
            self.sides[place], note = shortened(head, inside, side[-1])
            self.notes += [note] if note not in self.notes else []
        elif is_value(inside):
            self.failures[place] = refusal(head, inside)
        else:
            return
        self.called.append(name)

    def own_letter(self) -> frozenset[str]:
        """Return the undeclared letter that stands alone on the left: it declares itself."""
        if not self.signs or self.signs[0].value not in EQUALITIES or len(self.sides[0]) != 1:
            return frozenset()
        token = self.sides[0][0]
        unknown = token.kind == "name" and token.value not in self.names and token.value != "pi"
        return frozenset({token.value} if unknown else ())

    def finish_alone(self) -> None:
        """Finish a chain of its own and raise the first failure."""
        self.finish()
        for failure in self.failures.values():
            raise failure

    def _leave_open(self) -> None:
        opener = self.opened[-1]
        self.fail(ReadingError(opener.start, f"bracket {opener.value} is never closed", "close it"))
        self.opened.clear()

    def fail(self, error: ReadingError) -> None:
        """Give up the last side."""
        self.failures.setdefault(len(self.sides) - 1, error)

    def _fits(self, token: Token, last: bool) -> bool:
        if token.kind == "open":
            self.opened.append(token)
        elif token.kind == "close" and not self.opened:
            if last and token.value != "}":
                self.notes.append(f"stray {token.value} dropped")
            else:
                what = f"bracket {token.value} was never opened"
                self.fail(ReadingError(token.start, what, "open it or remove it"))
            return False
        elif token.kind == "close":
            self._close(token)
        return True

    def _close(self, token: Token) -> None:
        opener = self.opened.pop()
        if CLOSER[opener.value] != token.value:
            what = f"bracket {opener.value} is closed by {token.value}"
            self.fail(ReadingError(token.start, what, "make them a pair"))

    def finish(self) -> None:
        """Note what is missing at the end."""
        if self.opened:
            self._leave_open()
        for place, side in enumerate(self.sides):
            if not side and place not in self.failures:
                self.failures[place] = self._missing(place)
            elif place:
                self._without_argument(place)

    def _missing(self, place: int) -> ReadingError:
        if not self.signs:
            return ReadingError(self.item.start, "an empty formula", "write one")
        sign = self.signs[place - 1] if place else self.signs[0]
        what = f"nothing stands {'right' if place else 'left'} of {sign.value}"
        return ReadingError(sign.start, what, "complete the equation")


def has_own_relation(tokens: list[Token]) -> bool:
    """Tell whether a relation stands outside the brackets opened among the tokens."""
    depth = 0
    for token in tokens:
        depth += {"open": 1, "close": -1}.get(token.kind, 0)
        if depth < 0 or (token.kind == "rel" and depth == 0):
            return depth == 0
    return False


def is_equation(tokens: list[Token]) -> bool:
    """Tell whether tokens hold a relation outside brackets and all brackets are paired."""
    depth, found = 0, False
    for token in tokens:
        depth += {"open": 1, "close": -1}.get(token.kind, 0)
        found = found or (token.kind == "rel" and depth == 0)
        if depth < 0:
            return False
    return found and depth == 0


def without_aside(tokens: list[Token]) -> list[Token]:
    """Read `m (= n/2)` as m = n/2: drop the brackets around a relation at the end."""
    last = tokens[-1] if tokens else None
    if last is None or last.kind != "close" or last.value != ")":
        return tokens
    for place, token in enumerate(tokens[1:-2], 1):
        if token.kind == "open" and token.value == "(" and tokens[place + 1].kind == "rel":
            aside = tokens[place + 1 : -1]
            return [*tokens[:place], *aside] if is_equation(aside) else tokens
    return tokens
