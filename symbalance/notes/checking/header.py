"""Declarations at the head of a document itself: the sidecar's text in a comment.

    <!-- [symbols]                   % [symbols]                    # [symbols]
    r = "crank radius"               % r = "crank radius"           # r = "crank radius"
    -->                              (.tex)                         (.txt and others)
    (.md)

It must be the first thing in the document. What is read as equations is the rest, at its own lines.
"""

from __future__ import annotations

import re

_MARKDOWN = re.compile(r"\s*<!--[ \t]*(\[(?:symbols|\[scope\]|\[bind\])\].*?)-->", re.DOTALL)
_LINES = {mark: re.compile(rf"\s*(?:{mark}[^\n]*(?:\n|$))+") for mark in ("%", "#")}
_OPENING = re.compile(r"\s*\[\s*symbols\s*\]|\s*\[\[\s*(?:scope|bind)\s*\]\]")


def without_header(text: str, suffix: str) -> tuple[str, str]:
    """Return (the document with its header blank, the header's text as TOML); "" if there is none.

    >>> without_header('% [symbols]\\n% r = "crank radius"\\n$r=1$', ".tex")[1]
    '[symbols]\\nr = "crank radius"\\n'
    """
    found = (
        _MARKDOWN.match(text) if suffix == ".md" else _LINES["%" if suffix == ".tex" else "#"].match(text)
    )
    if found is None:
        return text, ""
    inside = found[1] if suffix == ".md" else re.sub(r"(?m)^[ \t]*[%#][ \t]?", "", found[0])
    if not _OPENING.match(inside):
        return text, ""
    blank = re.sub(r"[^\n]", " ", found[0])
    before = text[: found.start(1)].count("\n") if suffix == ".md" else 0
    return blank + text[found.end() :], "\n" * before + inside
