"""Regular expressions that are compiled when first used: `re` with another `compile`.

A reader of people's pages holds two thousand patterns, and compiling them takes longer than all else that
happens when its modules are imported; a page meets less than half of them. A module that holds many takes
this one in the place of `re`:

    from symbalance.text import lazy_patterns as re

A pattern that is wrong is refused when it is first used; a test compiles them all.
A match knows the pattern of `re` and not the lazy one: compare `match.re.pattern`, not `match.re`.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cached_property, wraps
from re import ASCII, DOTALL, IGNORECASE, MULTILINE, I, Match, Pattern, escape
from typing import Any, TypeVar, cast

__all__ = (
    "ASCII", "DOTALL", "IGNORECASE", "MULTILINE", "I", "Match", "Pattern", "compile", "escape", "findall",
    "finditer", "fullmatch", "match", "search", "split", "sub",
)  # fmt: skip
_Function = TypeVar("_Function", bound=Callable[..., Any])


def compile(pattern: str, flags: int = 0) -> re.Pattern[str]:
    """Return a pattern that is compiled at its first search.

    >>> compile("a+").sub("b", "caat")
    'cbt'
    """
    return cast("re.Pattern[str]", LazyPattern(pattern, flags))


class LazyPattern:
    """A pattern of `re` that is compiled when any of its methods or its flags are asked for.

    From then on the methods are attributes of the object, and a call costs what it costs in `re`.
    """

    def __init__(self, pattern: str, flags: int = 0) -> None:
        self.pattern, self._options = pattern, int(flags)

    @cached_property
    def compiled(self) -> re.Pattern[str]:
        """The pattern of `re`."""
        return re.compile(self.pattern, self._options)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):  # what copy and pickle ask for, and a pattern has not
            raise AttributeError(name)
        value = getattr(self.compiled, name)
        setattr(self, name, value)
        return value

    def __reduce__(self) -> tuple[type[LazyPattern], tuple[str, int]]:
        return LazyPattern, (self.pattern, self._options)

    def __repr__(self) -> str:
        return repr(self.compiled)


def _for_both(function: _Function) -> _Function:
    """Return a function of `re`, which knows only its own patterns, for lazy ones too."""

    @wraps(function)
    def call(pattern: Any, *arguments: Any, **options: Any) -> Any:
        one = pattern.compiled if isinstance(pattern, LazyPattern) else pattern
        return function(one, *arguments, **options)

    return cast(_Function, call)


findall = _for_both(re.findall)
finditer = _for_both(re.finditer)
fullmatch = _for_both(re.fullmatch)
match = _for_both(re.match)
search = _for_both(re.search)
split = _for_both(re.split)
sub = _for_both(re.sub)
