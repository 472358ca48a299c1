"""The letters that stand behind a formula: its own, those of the formulas they stand for, and so on."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from symbalance.document import formula
from symbalance.document.formula import Formula


def letters_behind(node: Formula, values: Mapping[str, Formula]) -> list[str]:
    """Return the letters a formula comes down to once all that have values are replaced."""
    return [name for name in names_behind(node, values) if name not in values]


def names_behind(node: Formula, values: Mapping[str, Formula]) -> list[str]:
    """Return all letters of a formula, of what they stand for, and so on, as they come up."""
    return letters_with_behind(formula.names(node), values)


def letters_with_behind(letters: Iterable[str], values: Mapping[str, Formula]) -> list[str]:
    """Return letters, those of what they stand for, and so on, as they come up."""
    every: dict[str, None] = {}
    waiting = [letters]
    while waiting:
        for name in sorted(waiting.pop()):
            if name in values and name not in every:
                waiting.append(formula.names(values[name]))
            every[name] = None
    return list(every)
