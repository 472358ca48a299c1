"""Declarations at the head of a document itself: the sidecar's text in a comment.

    <!-- [symbols]                   % [symbols]                    # [symbols]
    r = "crank radius"               % r = "crank radius"           # r = "crank radius"
    -->                              (.tex)                         (.txt and others)
    (.md)

It must be the first thing in the document. What is read as equations is the rest, at its own lines.
A text without a file, typed in or piped, may have any of the three.
"""

from __future__ import annotations

import re

_MARKDOWN = re.compile(r"\s*<!--[ \t]*(\[(?:symbols|\[scope\]|\[bind\])\].*?)-->", re.DOTALL)
_LINES = {mark: re.compile(rf"\s*(?:{mark}[^\n]*(?:\n|$))+") for mark in ("%", "#")}
_BY_SUFFIX = {
    ".md": (_MARKDOWN,),
    ".tex": (_LINES["%"],),
    "": (_MARKDOWN, _LINES["%"], _LINES["#"]),
}
_OPENING = re.compile(r"\s*\[\s*symbols\s*\]|\s*\[\[\s*(?:scope|bind)\s*\]\]")


def without_header(text: str, suffix: str) -> tuple[str, str]:
    """Return (the document with its header blank, the header's text as TOML); "" if there is none.

    >>> without_header('% [symbols]\\n% r = "crank radius"\\n$r=1$', ".tex")[1]
    '[symbols]\\nr = "crank radius"\\n'
    """
    for pattern in _BY_SUFFIX.get(suffix, (_LINES["#"],)):
        found = pattern.match(text)
        if found is None:
            continue
        in_lines = pattern is not _MARKDOWN
        inside = re.sub(r"(?m)^[ \t]*[%#][ \t]?", "", found[0]) if in_lines else found[1]
        if _OPENING.match(inside):
            blank = re.sub(r"[^\n]", " ", found[0])
            before = 0 if in_lines else text[: found.start(1)].count("\n")
            return blank + text[found.end() :], "\n" * before + inside
    return text, ""
