"""Long lines of generated code, broken where the language allows it."""

from __future__ import annotations

from collections.abc import Iterator

WIDTH = 100
BREAKS = (" + ", " - ", ", ")


def folded(text: str, note: str, tail: str = "", bracketed: bool = False) -> str:
    r"""Return code with no line over `WIDTH`, as far as it has places to break a line at.

    `note` begins a comment: one that makes its line too long goes before it. `tail` ends a line that goes
    on. `bracketed`: only inside brackets may a line go on.

    >>> print(folded("x = (" + "abcdefgh + "*10 + "z)  # long", "# ", bracketed=True))
    # long
    x = (abcdefgh + abcdefgh + abcdefgh + abcdefgh + abcdefgh + abcdefgh + abcdefgh + abcdefgh
        + abcdefgh + abcdefgh + z)
    """
    found: list[str] = []
    for line in text.split("\n"):
        if len(line) <= WIDTH:
            found.append(line)
            continue
        code, mark, rest = line.partition(f"  {note}")
        indent = code[: len(code) - len(code.lstrip())]
        if mark:
            found.append(indent + note + rest)
        found += _pieces(code, indent + "    ", tail, bracketed)
    return "\n".join(found)


def _pieces(code: str, indent: str, tail: str, bracketed: bool) -> Iterator[str]:
    depth = 0
    while len(code) > WIDTH:
        place, depth = _place(code, len(indent), WIDTH - len(tail), depth, bracketed)
        if not place:
            break
        yield code[:place].rstrip() + tail
        code = indent + code[place:].lstrip()
    yield code


def _place(code: str, first: int, last: int, depth: int, bracketed: bool) -> tuple[int, int]:
    """Return the last place to break at between two columns, 0 if there is none, and the depth there."""
    place, found = 0, depth
    for i, character in enumerate(code[:last]):
        if i > first and (depth > 0 or not bracketed) and code.startswith(BREAKS, i):
            place, found = i + code.startswith(",", i), depth
        depth += (character in "([{") - (character in ")]}")
    return place, found
