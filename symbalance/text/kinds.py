"""Kinds of values in a TOML file: how each is read and described, and its JSON Schema.

Numbers are read exactly, from TOML's own numbers or from text such as "360/7". The schemas hold only
keywords that mean the same in every draft of JSON Schema from 6 to 2020-12: editors differ in theirs.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Protocol

from symbalance.errors import SymbalanceError, brief
from symbalance.text.measurements import measurement
from symbalance.text.numbers import LARGEST, checked_whole, exact

Schema = dict[str, Any]


class Kind(Protocol):
    """What a key's value must be."""

    @property
    def words(self) -> str:
        """What it is, as the reference of keys says it: "number", "list of numbers"."""
        ...

    @property
    def range(self) -> str:
        """Which values it may have, as the reference says it; "" if all of its kind."""
        ...

    def read(self, value: object, name: str, remedy: str) -> Any:
        """Return the value that is meant, or refuse; `name` and `remedy` are for the refusal."""
        ...

    def schema(self) -> Schema:
        """Return the JSON Schema of what `read` takes, as nearly as a schema can say it."""
        ...


@dataclass(frozen=True)
class ExactNumber:
    """A number within `low` and `high` (None: no bound), which an `open_` end leaves out.

    `finest` is the largest denominator (None: as `exact` has it); `rule_text` is what a refusal says of a
    number out of range, where that says more than the range.

    >>> POSITIVE.read("360/7", "stroke", ""), POSITIVE.range
    (Fraction(360, 7), '> 0')
    """

    low: Fraction | int | None = None
    high: Fraction | int | None = None
    open_low: bool = False
    open_high: bool = False
    finest: int | None = None
    rule_text: str = ""

    words = "number"
    plural = "numbers or fractions"
    largest = LARGEST
    """The largest magnitude that is read, None if any is."""

    def parse(self, value: object, name: str) -> Fraction:
        """Return the number that is written, whatever its range."""
        return exact(value, name, self.finest)

    def read(self, value: object, name: str, remedy: str) -> Fraction:
        """Return the exact number, or refuse one that is none or out of range."""
        number = self.parse(value, name)
        below = self.low is not None and (number < self.low or (self.open_low and number == self.low))
        above = self.high is not None and (number > self.high or (self.open_high and number == self.high))
        if below or above:
            what = f"{name} = {brief(value)}"
            raise SymbalanceError(what, self.rule, remedy or "check the value")
        return number

    @property
    def rule(self) -> str:
        """What a refusal says of a number out of range."""
        if self.rule_text:
            return self.rule_text
        if self.low == 0 and self.high is None:
            return "must be positive" if self.open_low else "must not be negative"
        return f"must lie {self.range}" if self.high is not None else f"must be {self.range}"

    @property
    def range(self) -> str:
        """The interval: "> 0", "≥ 0", "in [0, 720)"."""
        if self.low is None and self.high is None:
            return ""
        if self.high is None:
            return f"{'>' if self.open_low else '≥'} {_plain(self.low or 0)}"
        first, last = "(" if self.open_low else "[", ")" if self.open_high else "]"
        return f"in {first}{_plain(self.low or 0)}, {_plain(self.high)}{last}"

    def schema(self) -> Schema:
        """Return the schema: a number in range, or text of a number with a sign that can be in range."""
        schema: Schema = {"type": ["number", "string"], "pattern": _pattern(self.low, self.open_low)}
        low = -self.largest if self.low is None and self.largest else self.low
        high = self.largest if self.high is None and self.largest else self.high
        if low is not None:
            schema["exclusiveMinimum" if self.open_low else "minimum"] = _plain(low)
        if high is not None:
            schema["exclusiveMaximum" if self.open_high else "maximum"] = _plain(high)
        return schema


class MeasuredNumber(ExactNumber):
    """A number of any length and magnitude: a measured value, or one that was computed."""

    largest = None

    def parse(self, value: object, name: str) -> Fraction:
        """Return the number that is written, as `measurement` reads it."""
        return measurement(value, name)


POSITIVE, NOT_NEGATIVE, ANY = ExactNumber(0, open_low=True), ExactNumber(0), ExactNumber()

_DIGITS = r"([0-9]{1,110}(\.[0-9]{0,110})?|\.[0-9]{1,110})([eE][+-]?[0-9]{1,3})?"
_NOT_ZERO = r"(?=[0-9.]*[1-9])"


def _pattern(low: Fraction | int | None, open_low: bool) -> str:
    """Return the pattern of text that says a number: decimal or fraction, no sign where none can be."""
    sign = "[+-]?" if low is None or low < 0 else r"\+?"
    first = _NOT_ZERO if low is not None and low >= 0 and (open_low or low > 0) else ""
    below = f"{sign}{_NOT_ZERO}{_DIGITS}"
    return rf"^\s*{sign}{first}{_DIGITS}\s*(/\s*{below}\s*)?$"


def _plain(number: Fraction | int) -> int | float:
    return int(number) if number == int(number) else float(number)


@dataclass(frozen=True)
class Whole:
    """A whole number from `low` to `high`, of which `but` is left out."""

    low: int
    high: int
    but: int | None = None

    words = "whole number"
    plural = "whole numbers"

    def read(self, value: object, name: str, remedy: str) -> int:
        """Return the whole number; a float is none, whatever its value."""
        number = checked_whole(value, name, self.low, self.high, remedy)
        if number == self.but:
            raise SymbalanceError(f"{name} = {number}", f"must not be {self.but}", remedy)
        return number

    @property
    def range(self) -> str:
        """The interval, its ends included."""
        left_out = "" if self.but is None else f", not {self.but}"
        return f"{self.low} to {self.high}{left_out}"

    def schema(self) -> Schema:
        """Return the schema; JSON has no difference between 1 and 1.0."""
        schema: Schema = {"type": "integer", "minimum": self.low, "maximum": self.high}
        return schema if self.but is None else {**schema, "not": {"const": self.but}}


@dataclass(frozen=True)
class Text:
    """A text; with `longest` one printable line of 1 to so many characters."""

    longest: int | None = None

    words = "text"
    plural = "texts"

    def read(self, value: object, name: str, remedy: str) -> str:
        """Return the text."""
        if not isinstance(value, str):
            raise SymbalanceError(f"{name} = {brief(value)}", "must be text", "write it in quotes")
        if self.longest is not None and not (
            value.isprintable() and 1 <= len(value.strip()) <= len(value) <= self.longest
        ):
            rule = f"must be one line of 1 to {self.longest} characters"
            raise SymbalanceError(f"{name} = {brief(value)!r}", rule, remedy)
        return value

    @property
    def range(self) -> str:
        """How long it may be."""
        return "" if self.longest is None else f"in one line of 1 to {self.longest} characters"

    def schema(self) -> Schema:
        """Return the schema; control characters are left to the reader, but for the ends of lines."""
        if self.longest is None:
            return {"type": "string"}
        return {
            "type": "string",
            "maxLength": self.longest,
            "pattern": r"^[^\x00-\x1f]*[^\s][^\x00-\x1f]*$",
        }


@dataclass(frozen=True)
class Choice:
    """One of a few values, all of them texts or all of them whole numbers."""

    values: tuple[str, ...] | tuple[int, ...]

    @property
    def words(self) -> str:
        """The values."""
        return " or ".join(_quoted(v) for v in self.values)

    @property
    def plural(self) -> str:
        """The same of several."""
        return f"values {self.words}"

    @property
    def range(self) -> str:
        """Nothing more: `words` are the values."""
        return ""

    def read(self, value: object, name: str, remedy: str) -> Any:
        """Return the value, or refuse another one, or one of another type."""
        if type(value) is not type(self.values[0]) or value not in self.values:
            choices = f"one of {', '.join(map(str, self.values))}"
            if len(self.values) == 2 and isinstance(self.values[0], int):
                choices = " or ".join(map(str, self.values))
            quoted = f"'{brief(value)}'" if isinstance(value, str) else brief(value)
            raise SymbalanceError(f"{name} = {quoted}", f"must be {choices}", remedy)
        return value

    def schema(self) -> Schema:
        """Return the schema."""
        return {"enum": list(self.values)}


def _quoted(value: object) -> str:
    return f'"{value}"' if isinstance(value, str) else str(value)


@dataclass(frozen=True)
class ListOf:
    """A list of values of one kind, at least `least` of them; `example` is how one is written."""

    kind: Any
    example: str
    least: int = 0
    exactly: int | None = None

    @property
    def words(self) -> str:
        """A list of the kind."""
        count = f"{self.exactly} " if self.exactly else ""
        return f"list of {count}{self.kind.plural}"

    @property
    def plural(self) -> str:
        """Lists of the kind."""
        return f"lists of {self.kind.plural}"

    @property
    def range(self) -> str:
        """The range of each element, and how many there must be."""
        parts = (*self.kind.range.split("; "), "one or more" if self.least else "")
        return "; ".join(dict.fromkeys(p for p in parts if p))

    def read(self, value: object, name: str, remedy: str) -> list[Any]:
        """Return the elements, each read as its kind is; a refusal says which by its number."""
        if not isinstance(value, list):
            raise SymbalanceError(
                f"{name} = {brief(value)}", f"must be a {self.words}", f"write it like {self.example}"
            )
        if len(value) < self.least or self.exactly not in (None, len(value)):
            rule = f"must hold {self.exactly}" if self.exactly else "must not be empty"
            raise SymbalanceError(f"{name} = {brief(value)}", rule, f"write it like {self.example}")
        return [self.kind.read(v, f"{name}[{i}]", remedy) for i, v in enumerate(value, 1)]

    def schema(self) -> Schema:
        """Return the schema."""
        schema: Schema = {"type": "array", "items": self.kind.schema()}
        least = self.exactly or self.least
        if least:
            schema["minItems"] = least
        return {**schema, "maxItems": self.exactly} if self.exactly else schema


@dataclass(frozen=True)
class ListOrLists:
    """A list of values of one kind for all, or a list of such lists, one each; none of them empty.

    >>> each = ListOrLists(ANY, "[0, 120]", "[[0, 120], [30, 150]]")
    >>> each.read([0, 120], "pins", "") == [0, 120], each.read([[0], [30]], "pins", "") == [[0], [30]]
    (True, True)
    """

    kind: Any
    example: str
    example_of_lists: str

    @property
    def _list(self) -> ListOf:
        return ListOf(self.kind, self.example, least=1)

    @property
    def _lists(self) -> ListOf:
        return ListOf(self._list, self.example_of_lists, least=1)

    @property
    def words(self) -> str:
        """A list of the kind, or a list of lists."""
        return f"{self._list.words}, or a list of such lists"

    @property
    def plural(self) -> str:
        """The kind's own."""
        return self.kind.plural

    @property
    def range(self) -> str:
        """The range of each element, and how many there must be."""
        return self._list.range

    def read(self, value: object, name: str, remedy: str) -> list[Any]:
        """Return the list, or the list of lists; one that mixes both is refused."""
        nested = isinstance(value, list) and any(isinstance(inner, list) for inner in value)
        return (self._lists if nested else self._list).read(value, name, remedy)

    def schema(self) -> Schema:
        """Return the schema."""
        return {"anyOf": [self._list.schema(), self._lists.schema()]}


@dataclass(frozen=True)
class OneOrList:
    """One value of a kind, or a list of them."""

    kind: Any

    @property
    def words(self) -> str:
        """One or a list of the kind."""
        return f"{self.kind.words}, or a list"

    @property
    def plural(self) -> str:
        """The kind's own."""
        return self.kind.plural

    @property
    def range(self) -> str:
        """The range of each."""
        return self.kind.range

    def read(self, value: object, name: str, remedy: str) -> Any:
        """Return the value, or the list of values."""
        if not isinstance(value, list):
            return self.kind.read(value, name, remedy)
        return [self.kind.read(v, f"{name}[{i}]", remedy) for i, v in enumerate(value, 1)]

    def schema(self) -> Schema:
        """Return the schema."""
        each = self.kind.schema()
        return {"anyOf": [each, {"type": "array", "items": each}]}
