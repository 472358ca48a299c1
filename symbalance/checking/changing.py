"""Changed copies of formulas: a letter, or one part, replaced."""

from __future__ import annotations

from symbalance.reading import syntax
from symbalance.reading.syntax import Name, Node


def substituted(node: Node, name: str, value: Node) -> Node:
    """Return a formula with a letter replaced."""
    if isinstance(node, Name) and node.name == name:
        return value
    parts = syntax.children(node)
    changed = tuple(substituted(part, name, value) for part in parts)
    return (
        node
        if all(a is b for a, b in zip(parts, changed, strict=True))
        else syntax.with_children(node, changed)
    )


def replaced(node: Node, old: Node, new: Node) -> Node:
    """Return a formula with one of its parts (that very object) replaced."""
    if node is old:
        return new
    parts = syntax.children(node)
    changed = tuple(replaced(part, old, new) for part in parts)
    return (
        node
        if all(a is b for a, b in zip(parts, changed, strict=True))
        else syntax.with_children(node, changed)
    )
