"""The line number of every key and table in a TOML text, which Python's TOML reader does not give.

The text is one that reader takes, so that only what parts keys from values has to be recognised here:
heads, dotted and quoted keys, strings of one or more lines, lists, tables within lists.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator

KeyPath = tuple[str | int, ...]
"""Keys from the top: ("cylinder", 2, "throw") is the key throw of the third [[cylinder]] table."""

_TOKEN = re.compile(
    r'(?P<text>"{3}(?:\\.|[^\\])*?"{3}(?!")|\'{3}.*?\'{3}(?!\')|"(?:\\.|[^"\\\n])*"|\'[^\'\n]*\')'
    r"|(?P<end>\n)|(?P<mark>[\[\]{}=,.])|(?P<bare>[^\s\[\]{}=,.#\"']+)|[^\S\n]+|#[^\n]*",
    re.DOTALL,
)


def lines_of(text: str) -> dict[KeyPath, int]:
    """Return the first line, from 1, that each key, each table and each element of a list stands on.

    >>> lines = lines_of("a = 1\\n[[b]]\\n[[b]]\\nc = [\\n{ d = 2 }]")
    >>> lines["a",], lines["b",], lines["b", 1], lines["b", 1, "c", 0, "d"]
    (1, 2, 3, 5)
    """
    return _Finder().lines(text)


class _Finder:
    """Walks over the tokens of a text; `within` are the lists and tables in braces that are open."""

    def __init__(self) -> None:
        self.places: dict[KeyPath, int] = {}
        self.tables: dict[KeyPath, int] = {}
        """The lists of tables with heads of their own, and how many each has so far."""
        self.line = 1

    def lines(self, text: str) -> dict[KeyPath, int]:
        base: KeyPath = ()
        tokens = self.tokens(text)
        for kind, token in tokens:
            if kind == "end":
                continue
            if token == "[":
                base = self.head(tokens)
            else:
                self.statement(kind, token, tokens, base)
        return self.places

    def tokens(self, text: str) -> Iterator[tuple[str, str]]:
        """Yield the tokens, spaces and comments left out, `line` being that on which each begins."""
        for match in _TOKEN.finditer(text):
            if match.lastgroup:
                yield match.lastgroup, match[0]
            self.line += match[0].count("\n")

    def head(self, tokens: Iterator[tuple[str, str]]) -> KeyPath:
        """Return the path of the table whose head begins; the first bracket has been taken."""
        kind, token = next(tokens)
        listed = token == "["
        if listed:
            kind, token = next(tokens)
        keys = []
        while token != "]":
            if kind != "mark":
                keys.append(_key(kind, token))
            kind, token = next(tokens)
        path: KeyPath = ()
        for depth, key in enumerate(keys, 1):
            path = (*path, key)
            self.note(path)
            if listed and depth == len(keys):
                self.tables[path] = self.tables.get(path, 0) + 1
            if path in self.tables:
                path = (*path, self.tables[path] - 1)
                self.note(path)
        if listed:
            next(tokens, None)
        return path

    def statement(self, kind: str, token: str, tokens: Iterator[tuple[str, str]], base: KeyPath) -> None:
        """Note the keys of one statement, from its first token to the end of its value."""
        within: list[tuple[str, KeyPath, int]] = [("", base, 0)]
        reads_key, path = True, base
        while True:
            bracket, inside, count = within[-1]
            if kind == "end":
                if len(within) == 1:
                    return
            elif reads_key and kind != "mark":
                path = (*path, _key(kind, token))
                self.note(path)
            elif token == "=":
                reads_key = False
            elif token in ("[", "{"):
                if bracket == "[":
                    path = (*inside, count)
                    self.note(path)
                within.append((token, path, 0))
                reads_key = token == "{"
            elif token in ("]", "}"):
                within.pop()
                reads_key = False
            elif token == ",":
                within[-1] = (bracket, inside, count + 1)
                reads_key, path = bracket == "{", inside
            elif bracket == "[":
                self.note((*inside, count))
            kind, token = next(tokens, ("", ""))
            if not kind:
                return

    def note(self, path: KeyPath) -> None:
        self.places.setdefault(path, self.line)


def _key(kind: str, token: str) -> str:
    return next(iter(tomllib.loads(f"{token} = 0"))) if kind == "text" else token
