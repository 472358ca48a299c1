"""The exceptions symbalance raises for bad input, all in one form: place, value, rule, remedy."""

from __future__ import annotations

import re
from copy import copy
from pathlib import Path
from traceback import extract_tb
from typing import Any


class PicklableError(Exception):
    """An exception that copies and pickles whatever arguments its class is constructed with.

    Python calls the class again with `args`, which here is the finished line; where the class takes
    other arguments that fails, and a `multiprocessing.Pool` that cannot read its worker's exception
    waits for ever. So the constructor is passed over, and the attributes are put back.
    """

    def __reduce__(self) -> tuple[Any, ...]:
        return _without_init, (type(self), self.args), self.__dict__


def _without_init(kind: type[PicklableError], args: tuple[object, ...]) -> PicklableError:
    error = kind.__new__(kind)
    error.args = args
    return error


class SymbalanceError(PicklableError, ValueError):
    """Bad input; `str()` gives a one-line message for the user.

    The line reads ``place = value: rule; remedy``, for instance
    ``fires = 800: must lie in [0, 720); degrees after cylinder 1's firing``.

    >>> str(SymbalanceError("fires = 800", "must lie in [0, 720)", "degrees after cylinder 1's firing"))
    "fires = 800: must lie in [0, 720); degrees after cylinder 1's firing"
    >>> str(SymbalanceError("fires = 800", "is too large").within("a.toml:3: cylinder 2"))
    'a.toml:3: cylinder 2: fires = 800: is too large'
    """

    def __init__(self, what: str, rule: str, remedy: str = "", place: str = "") -> None:
        self.what, self.rule, self.remedy, self.place = what, rule, remedy, place
        super().__init__(self._line())

    def _line(self) -> str:
        head = f"{self.place}: " if self.place else ""
        tail = f"; {self.remedy}" if self.remedy else ""
        line = f"{head}{self.what}: {self.rule}{tail}"
        return printable(line)

    def within(self, place: str) -> SymbalanceError:
        """Return the same refusal, said of something inside `place`."""
        full = f"{place}: {self.place}" if self.place else place
        copied = copy(self)
        copied.place = full
        copied.args = (copied._line(),)
        return copied


class MissingPartError(SymbalanceError):
    """An optional part that is not installed; the remedy is the command that installs it."""


class JobFaultError(PicklableError, RuntimeError):
    """A fault of symbalance that ended a job elsewhere, with the traceback of the process it was in."""

    def __init__(self, fault: str = "", traceback: str = "") -> None:
        super().__init__(fault)
        self.fault, self.traceback = fault, traceback


def printable(text: str) -> str:
    r"""Return a text on one line, what cannot be printed by its code; a name stays the name it is.

    A byte of a file's name that is no text in the locale's encoding is one such.

    >>> print(printable("b\udcff.md: one\tline"))
    b\xff.md: one line
    """
    if text.isprintable() and not _UNSEEN.search(text):
        return text
    return "".join(" " if c in "\n\r\t\v\f" else c if _shows(c) else _code(c) for c in text)


_SPACES = re.compile("[\n\t\u00a0\u1680\u2000-\u200a\u202f\u205f\u3000]")
_UNSEEN = re.compile("[\u034f\u115f\u1160\u17b4\u17b5\u180b-\u180f\u2800\u3164\ufe00-\ufe0f\uffa0]")
"""Letters and accents by their kind that show nothing: fillers and joiners."""


def visible(text: str) -> str:
    r"""Return a text whose every character shows: those that do not, or move others, by their codes.

    Control characters, which a terminal obeys, marks that turn the direction of writing, signs of no
    width, ends of lines and paragraphs but the newline, and what is no character. Spaces and tabs stay,
    and so do letters of every script with their accents. A result that quotes somebody's file passes it
    through here, once: see `symbalance.document.nodes`.

    >>> print(visible("V8 \x1b[31mred\u202e\u200b, Größe, 直列四気筒"))
    V8 \x1b[31mred\u202e\u200b, Größe, 直列四気筒
    """
    if text.isprintable() and not _UNSEEN.search(text):
        return text
    return "".join(c if _shows(c) or _SPACES.match(c) else _code(c) for c in text)


def _shows(character: str) -> bool:
    return character.isprintable() and not _UNSEEN.match(character)


_UNPAIRED = re.compile("[\ud800-\udfff]")


def encodable_name(text: str, escape: str = "\\") -> str:
    r"""Return a text with the bytes of file names that are no text by their codes; `escape` opens one.

    >>> print(encodable_name("b\udcff.md, ü.md"))
    b\xff.md, ü.md
    """
    return _UNPAIRED.sub(lambda match: _code(match[0]).replace("\\", escape), text)


def _code(character: str) -> str:
    number = ord(character)
    return f"\\x{number - 0xDC00:02x}" if 0xDC80 <= number <= 0xDCFF else ascii(character)[1:-1]


def fault_of(problem: BaseException) -> str:
    """Return what went wrong inside symbalance, and where: the last line of its own that was running.

    >>> try:
    ...     SymbalanceError("bank = 400", "is too large").within(3) + 1
    ... except TypeError as problem:
    ...     print(fault_of(problem))
    TypeError
    """
    home = Path(__file__).parent
    own = [frame for frame in extract_tb(problem.__traceback__) if home in Path(frame.filename).parents]
    name = type(problem).__name__
    if not own:
        return name
    return f"{name} in {Path(own[-1].filename).relative_to(home).as_posix()}:{own[-1].lineno}"


def brief(value: object, limit: int = 40) -> str:
    """Return `value` as an error may quote it: short, and never a failure itself.

    >>> brief(10**100)
    '10000000000000000000...(101 characters)'
    >>> from fractions import Fraction
    >>> brief([Fraction(1, 4), "x"])
    "[1/4, 'x']"
    """
    try:
        text = _listed(value) if isinstance(value, list) else str(value)
    except ValueError:  # an integer past Python's limit for decimal strings
        return "an integer of thousands of digits"
    return text if len(text) <= limit else f"{text[:20]}...({len(text)} characters)"


def _listed(values: list[Any], depth: int = 2) -> str:
    """Return a list as a person writes it: its fractions and decimals without their types' names."""
    if not depth:
        return str(values)
    numbers = ("Fraction", "Decimal")
    parts = (
        _listed(v, depth - 1)
        if isinstance(v, list)
        else str(v)
        if type(v).__name__ in numbers
        else repr(v)
        for v in values
    )
    return f"[{', '.join(parts)}]"


def literal(value: object) -> str:
    """Return `value` as an error may quote it where text is mistaken for a number: text in quotes.

    >>> literal("4"), literal(4)
    ("'4'", '4')
    """
    return repr(brief(value)) if isinstance(value, str) else brief(value)
