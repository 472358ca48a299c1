"""A page made small: scripts without what only people read, parts of a drawing written once.

No general tool: it packs our own scripts, in which no regular expression stands between slashes, and no
template within a template, and the functions that `symbalance.codegen` emits.
"""

from __future__ import annotations

import re
from collections import Counter

TEXT = r"\"(?:[^\"\\\n]|\\.)*\"|'(?:[^'\\\n]|\\.)*'|`(?:[^`\\]|\\.)*`"
COMMENT = r"//[^\n]*|/\*.*?\*/"
_PIECES = re.compile(f"({TEXT})|({COMMENT})", re.DOTALL)
_AROUND = re.compile(r"[ \t]*([{}()\[\];,:?=<>*/&|!])[ \t]*")
# a - -b and a + +b keep their spaces.
_SIGNS = re.compile(r"(?<![-+])[ \t]*([-+])[ \t]*(?![-+ \t])")
WORDS = re.compile(r"[A-Za-z_]\w*")
SHORTEST = 4
"""Letters of a name from which a shorter one saves room."""
LETTERS = "abcdefghijklmnopqrstuvwxyz"


def packed(script: str) -> str:
    """Return a script without comments, and without the spaces that its meaning does not need.

    >>> packed('const a = [1, 2];  // two\\nif (a[0] - -1 > 0) say("a - b", `x ${ a } y`);')
    'const a=[1,2];if(a[0]- -1>0)say("a - b",`x ${ a } y`);'
    """
    parts: list[str] = []
    texts: list[str] = []
    end = 0
    for piece in _PIECES.finditer(script):
        parts.append(script[end : piece.start()])
        if piece[1] is not None:
            parts.append(f"\0{len(texts)}\0")
            texts.append(piece[1])
        end = piece.end()
    parts.append(script[end:])
    lines = (_packed_line(line) for line in "".join(parts).splitlines())
    whole = "\n".join(line for line in lines if line)
    # Where a line ends in what asks for more, or the next begins so, the break means nothing.
    whole = re.sub(r"(?<=[,{(\[;=&|?:])\n", "", whole)
    return re.sub("\0(\\d+)\0", lambda place: texts[int(place[1])], whole)


def _packed_line(line: str) -> str:
    return _SIGNS.sub(r"\1", _AROUND.sub(r"\1", line.strip()))


def with_short_names(script: str, kept: tuple[str, ...]) -> str:
    """Return a script that nothing but `kept` is called from, its own constants by short names.

    >>> with_short_names('const LONG = 1;\\nconst evaluate = (x) => x*LONG;', ("evaluate",))
    'const aA = 1;\\nconst evaluate = (x) => x*aA;'
    """
    own = re.findall(r"\b(?:const|let|function)\s+([A-Za-z_]\w*)", script)
    counts = Counter(WORDS.findall(script))
    wanted = [n for n in dict.fromkeys(own) if len(n) >= SHORTEST and n not in kept]
    wanted.sort(key=lambda n: -counts[n] * len(n))
    names = dict(zip(wanted, _short_names(set(counts)), strict=False))

    def renamed(piece: re.Match[str]) -> str:
        if piece[1] is not None or piece[2] is not None:
            return piece[0]
        return names.get(piece[3], piece[3])

    # Properties and texts keep their names.
    return re.sub(
        rf"({TEXT}|(?<=[\w)\]]\.)[A-Za-z_]\w*)|({COMMENT})|\b([A-Za-z_]\w*)",
        renamed,
        script,
        flags=re.DOTALL,
    )


def _short_names(taken: set[str]) -> list[str]:
    """Return names of two and three letters that a script does not hold, none a word of the language."""
    capitals = LETTERS.upper()
    names = [a + b for a in LETTERS for b in capitals]
    names += [a + b + c for a in LETTERS for b in capitals for c in LETTERS + capitals]
    return [name for name in names if name not in taken]


def with_shared_parts(svg: str) -> str:
    """Return a drawing in which pistons and rods that look alike are drawn once, and used again."""
    group = re.compile(r"(<g data-part=\"(?:piston|rod)-\d+\"[^>]*>)((?:(?!<g|</g>).)*)</g>", re.DOTALL)
    counts = Counter(inner for _, inner in group.findall(svg))
    places: dict[str, int] = {}

    def shared(piece: re.Match[str]) -> str:
        head, inner = piece.groups()
        if counts[inner] == 1:
            return piece[0]
        if inner in places:
            return f'{head}<use href="#part{places[inner]}"/></g>'
        places[inner] = len(places)
        return f'{head}<g id="part{places[inner]}">{inner}</g></g>'

    return group.sub(shared, svg)
