"""The letters declared at one place of a document, ready to be found in running letters."""

from __future__ import annotations

from collections.abc import Collection
from functools import lru_cache

from symbalance.document.letters import FUNCTION_WORDS, LOWERED


class Vocabulary:
    """Finds the longest declared letter or function that begins at a place.

    >>> Vocabulary(frozenset({"L", "Lh"})).longest("Lh cos", 0, 6)
    ('name', 'Lh')
    >>> Vocabulary(frozenset()).longest("cosh x", 0, 6)
    ('function', 'cosh')
    """

    def __init__(self, names: frozenset[str]) -> None:
        self.names = names
        words = {name for name in names if name.isascii() and name[:1].isalpha()}
        words |= {name.split("_")[0].rstrip("'") for name in words}
        self._by_letter: dict[str, list[tuple[int, str, str]]] = {}
        functions = set(FUNCTION_WORDS) - names
        functions -= {"asin", "acos", "atan"} if "a" in names else set()
        for kind, group in (("name", words), ("function", functions), ("constant", {"pi"} - names)):
            for word in group:
                self._by_letter.setdefault(word[:1], []).append((-len(word), kind, word))
        for entries in self._by_letter.values():
            entries.sort()

    def longest(self, text: str, start: int, end: int) -> tuple[str, str] | None:
        """Return kind and word of the longest entry at `start`; a base counts where a script follows."""
        for _, kind, word in self._by_letter.get(text[start], ()):
            stop = start + len(word)
            if stop <= end and text.startswith(word, start) and self._fits(text, word, stop, end, kind):
                return kind, word
        return None

    def _fits(self, text: str, word: str, stop: int, end: int, kind: str) -> bool:
        after = text[stop] if stop < end else " "
        if kind != "name":
            return True
        if word[-1].isdigit() and after.isdigit():
            return False
        return word in self.names or (len(word) > 1 and (after in "_'′" or after in LOWERED))


@lru_cache(maxsize=256)
def _vocabulary(names: frozenset[str]) -> Vocabulary:
    return Vocabulary(names)


def vocabulary(names: Collection[str]) -> Vocabulary:
    """Return the vocabulary of some names, made once."""
    return _vocabulary(names if isinstance(names, frozenset) else frozenset(names))
