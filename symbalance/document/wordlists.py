"""Lists and sets of words from a string with spaces between them."""

from __future__ import annotations


def words(text: str) -> list[str]:
    """Return the words of a text, in order.

    >>> words("sin cos")
    ['sin', 'cos']
    """
    return text.split()


def word_set(text: str) -> frozenset[str]:
    """Return the words of a text, as a set."""
    return frozenset(text.split())
