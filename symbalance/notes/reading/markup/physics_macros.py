r"""Commands of the packages physics, diffcoeff and their like: \qty, \dv, \mqty, \eval, \cos[2](x).

Each writes what it stands for in plain LaTeX: \mqty(a & b) is a matrix, \dd{x} an upright d and its
letter.
"""

from __future__ import annotations

from collections.abc import Callable

from symbalance.document.wordlists import words
from symbalance.notes.reading.markup.differential_signs import without_definition
from symbalance.notes.reading.rewriting import Span
from symbalance.text import lazy_patterns as re

Texts = list[str | Span]
Handler = Callable[[str, int, dict[int, int]], "tuple[Texts, int] | str | None"]
_SPACE = re.compile(r"[ \t]*\n?[ \t]*")
_OPTION = re.compile(r"\s*\[([^\[\]\n]{0,40})\]")
_POWER_OF_FUNCTION = re.compile(r"\[\s*([0-9n])\s*\](?=\s*(?:\(|\{|\\left|\\qty))")
_CLOSER = {"(": ")", "[": "]"}
_LONGEST = 2000


def _group(text: str, place: int, pairs: dict[int, int]) -> tuple[Span, int] | None:
    """Return the inside of an argument in braces at a place, and where it ends."""
    blank = _SPACE.match(text, place)
    start = blank.end() if blank else place
    close = pairs.get(start)
    return None if close is None else ((start + 1, close), close + 1)


def _bracketed(text: str, place: int) -> tuple[Span, int] | None:
    """Return the inside of ( ) or [ ] at a place, and where it ends."""
    closer = _CLOSER.get(text[place : place + 1])
    if closer is None:
        return None
    depth = 0
    for at in range(place, min(len(text), place + _LONGEST)):
        depth += {text[place]: 1, closer: -1}.get(text[at], 0)
        if not depth:
            return (place + 1, at), at + 1
    return None


def _around(before: str, after: str) -> Handler:
    """Return the handler of a command that sets its argument between two texts, starred or not."""

    def handle(text: str, place: int, pairs: dict[int, int]) -> tuple[Texts, int] | None:
        group = _group(text, place + text.startswith("*", place), pairs)
        return ([before, group[0], after], group[1]) if group else None

    return handle


def _matrix(text: str, place: int, pairs: dict[int, int]) -> tuple[Texts, int] | None:
    """Write \\mqty(a & b \\\\ c & d) as a matrix in the brackets it was given."""
    place += text.startswith("*", place)
    name = {"(": "pmatrix", "[": "bmatrix", "|": "vmatrix"}.get(text[place : place + 1], "matrix")
    if name == "vmatrix":
        end = text.find("|", place + 1, place + _LONGEST)
        group = ((place + 1, end), end + 1) if end > 0 else None
    else:
        group = _bracketed(text, place) or _group(text, place, pairs)
    return ([f"\\begin{{{name}}}", group[0], f"\\end{{{name}}}"], group[1]) if group else None


def _differential(text: str, place: int, pairs: dict[int, int]) -> tuple[Texts, int] | None:
    """Write \\dd{x}, \\dd x and \\dd[2]{x} with an upright d."""
    option = _OPTION.match(text, place)
    power = f"^{{{option[1]}}}" if option else ""
    start = option.end() if option else place
    group = _group(text, start, pairs)
    if group is None:
        return [f"\\mathrm{{d}}{power} "], start
    return [f"\\,\\mathrm{{d}}{power} ", group[0]], group[1]


def _two(write: Callable[[Span, Span], Texts]) -> Handler:
    """Return the handler of a command with two arguments in braces."""

    def handle(text: str, place: int, pairs: dict[int, int]) -> tuple[Texts, int] | None:
        first = _group(text, place, pairs)
        second = _group(text, first[1], pairs) if first else None
        return (write(first[0], second[0]), second[1]) if first and second else None

    return handle


def _derivative_of_two(sign: str) -> Handler:
    """Return the handler of \\diff[2]{y}{x} and \\odv[order=2]{y}{x}; with one it is a differential."""

    def handle(text: str, place: int, pairs: dict[int, int]) -> tuple[Texts, int] | None:
        option = _OPTION.match(text, place)
        start = option.end() if option else place
        first = _group(text, start + text.startswith("*", start), pairs)
        second = _group(text, first[1], pairs) if first else None
        if first is None or second is None:
            return without_definition(text, place, pairs) if sign == "d" else None
        order = option[1].removeprefix("order=").strip() if option else ""
        power = f"^{{{order}}}" if order else ""
        return [f"\\frac{{{sign}{power} ", first[0], f"}}{{{sign} ", second[0], f"{power}}}"], second[1]

    return handle


def _power(name: str) -> Handler:
    """Return the handler of \\cos[2](x), which is \\cos^{2}(x)."""

    def handle(text: str, place: int, pairs: dict[int, int]) -> tuple[Texts, int] | None:
        match = _POWER_OF_FUNCTION.match(text, place)
        return ([f"\\{name}^{{", match.span(1), "}"], match.end()) if match else None

    return handle


def _words(text: str, place: int, pairs: dict[int, int]) -> tuple[Texts, int] | None:
    group = _group(text, place + text.startswith("*", place), pairs)
    return (["\\quad\\text{", group[0], "}\\quad "], group[1]) if group else None


def _joining(word: str) -> Handler:
    return lambda text, place, pairs: ([f"\\quad\\text{{{word}}}\\quad "], place)


PHYSICS: dict[str, Handler] = {
    "eval": _around("\\left.", "\\right|"),
    "norm": _around("\\left|", "\\right|"),
    "order": _around("O(", ")"),
    "pqty": _around("(", ")"),
    **dict.fromkeys(words("bqty Bqty"), _around("[", "]")),
    **dict.fromkeys(words("vb vectorbold"), _around("\\mathbf{", "}")),
    **dict.fromkeys(words("va vectorarrow"), _around("\\vec{", "}")),
    **dict.fromkeys(words("vu vectorunit"), _around("\\hat{", "}")),
    **dict.fromkeys(words("mqty matrixquantity"), _matrix),
    "pmqty": _around("\\begin{pmatrix}", "\\end{pmatrix}"),
    "bmqty": _around("\\begin{bmatrix}", "\\end{bmatrix}"),
    **dict.fromkeys(words("vmqty mdet"), _around("\\begin{vmatrix}", "\\end{vmatrix}")),
    **dict.fromkeys(words("comm commutator"), _two(lambda a, b: ["(", a, " ", b, " - ", b, " ", a, ")"])),
    **dict.fromkeys(
        words("acomm anticommutator"), _two(lambda a, b: ["(", a, " ", b, " + ", b, " ", a, ")"])
    ),
    **dict.fromkeys(words("dd differential"), _differential),
    **dict.fromkeys(words("odv derivative diff"), _derivative_of_two("d")),
    **dict.fromkeys(words("partialderivative diffp"), _derivative_of_two("\\partial")),
    "qq": _words,
    **{f"q{word}": _joining(word) for word in words("and or if for with where then given otherwise")},
    **{name: _power(name) for name in words("sin cos tan cot sec csc sinh cosh tanh")},
    **dict.fromkeys(
        words("phantom hphantom vphantom"),
        lambda text, place, pairs: ([" "], group[1]) if (group := _group(text, place, pairs)) else None,
    ),
}  # fmt: skip
"""What each command writes at the place behind its name; None leaves it as it stands."""
