"""Mutations that plant typical human errors in a formula: wrong sign, coefficient, order, letter.

Each kind is a function from the text of one side (LaTeX, as in the bench's page) to changed copies of it.
Only the text is looked at; whether a change changes the value is for `planting` to find out.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

Kind = Callable[[str], Iterator[str]]

_ANGLE = r"\\(?:theta|alpha|beta)|[AB](?![a-z])"
_NUMBER = re.compile(r"(?<![\d.^_])(?<!\^\{)\d+(?:\.\d+)?(?![\d.])")
_NOT_A_COEFFICIENT = re.compile(rf"\s*(?:i\s*)?(?:{_ANGLE}|\^\\circ|\\pi|k \\cdot|\(\\theta)")
_IN_PHASE = re.compile(r"\\frac\{\d*\\pi\}\{$")
_BOUNDS = re.compile(r"\\sum_\{[^}]*\}\^\{[^}]*\}")
_ORDER = re.compile(rf"(?<![\d^])\d+(?=\s*(?:i\s*)?(?:{_ANGLE}))")
_BARE = re.compile(r"(?<=\\cos|\\sin)(\^\d)?\s*(?=\\theta|\\alpha)")
_DEGREES = re.compile(r"(\d+)(?=\^\\circ)")
_PI = re.compile(r"\\frac\{(\d*)\\pi\}\{(\d+)\}|(?<![\d{\\a-z])(\d*)\\pi")
_UNMULTIPLIED = re.compile(r"\\cos (\w)\(\\theta ([+-] [^()]+)\)")
_STEP = re.compile(r"\d+ k \\cdot")
_EXPONENT = re.compile(r"\^(?:\{(\d+)\}|(\d))")
_LETTER = re.compile(r"(?<![\\A-Za-z_])(?:\\lambda|\\omega|[rlmbuqUL])(?![a-zA-Z])(\^\d)?")
_SWAPS = {
    r"\lambda": (r"\omega", "r"), r"\omega": (r"\lambda", "m"), "r": ("l", "m"), "l": ("r",),
    "m": ("b", "r"), "b": ("r", "m"), "u": ("q",), "q": ("r",), "U": ("m",), "L": ("K",),
    "A": ("B",), "B": ("A",), r"\alpha": (r"\theta",), r"\beta": (r"\theta",),
}  # fmt: skip
_SWAPPED = re.compile(r"(?<![\\A-Za-z_])(?:\\(?:lambda|omega|alpha|beta)|[rlmbuqULAB])(?![a-zA-Z])")


def signs(text: str) -> Iterator[str]:
    """Yield copies with one sign turned.

    >>> list(signs("1 - x"))
    ['1 + x', '-1 - x']
    """
    for match in re.finditer(r"[+-]", text):
        yield _put(text, match, "-" if match[0] == "+" else "+")
    if not text.startswith(("-", "0", r"\left")):
        yield "-" + text


def coefficients(text: str) -> Iterator[str]:
    """Yield copies with one number 2, 3 or 10 times what it was, or one off, and with a factor put in.

    >>> list(coefficients("3 x^2"))
    ['6 x^2', '9 x^2', '30 x^2', '4 x^2', '2 x^2']
    """
    bounds = [range(*match.span()) for match in _BOUNDS.finditer(text)]
    for match in _NUMBER.finditer(text):
        before, after = text[: match.start()], text[match.end() :]
        if _NOT_A_COEFFICIENT.match(after) or _IN_PHASE.search(before) or before.endswith(r"\sqrt"):
            continue
        if any(match.start() in span for span in bounds):
            continue
        if "." in match[0]:
            yield _put(text, match, _misprint(match[0]))
        else:
            for value in _other_integers(int(match[0])):
                yield _put(text, match, str(value))
    if not text[0].isdigit() and text[0] != "-" and not text.startswith((r"\left", r"\sum")):
        yield from (f"{factor} {text}" for factor in (2, 3, r"\frac{1}{2}"))


def _other_integers(value: int) -> list[int]:
    return [n for n in (2 * value, 3 * value, 10 * value, value + 1, value - 1) if n and n != value]


def _misprint(number: str) -> str:
    place = number.index(".") + 2
    return number[:place] + str((int(number[place]) + 3) % 10) + number[place + 1 :]


def orders(text: str) -> Iterator[str]:
    r"""Yield copies with one multiple of the angle changed.

    >>> list(orders(r"\cos 2\theta"))
    ['\\cos 3\\theta', '\\cos 4\\theta', '\\cos 1\\theta']
    """
    for match in _ORDER.finditer(text):
        value = int(match[0])
        for other in (value + 1, 2 * value, value - 1):
            if other and other != value:
                yield _put(text, match, str(other))
    for match in _BARE.finditer(text):
        for order in (2, 3):
            yield _put(text, match, f"{match[1] or ''} {order}")


def phases(text: str) -> Iterator[str]:
    r"""Yield copies with one phase changed, or not multiplied by the order.

    >>> list(phases(r"\cos 3(\theta + 120^\circ)"))[-1]
    '\\cos(3\\theta + 120^\\circ)'
    """
    for match in _DEGREES.finditer(text):
        for factor in (2, 0.5, 1 / 3):
            yield _put(text, match, f"{factor * int(match[0]):g}")
    for match in _PI.finditer(text):
        top = int(match[1] or match[3] or 1)
        bottom = int(match[2] or 1)
        for above, below in ((2 * top, bottom), (top, 2 * bottom), (top, bottom + 1)):
            yield _put(text, match, rf"\frac{{{above}\pi}}{{{below}}}")
    for match in _STEP.finditer(text):
        yield _put(text, match, r"k \cdot")
    for match in _UNMULTIPLIED.finditer(text):
        yield _put(text, match, rf"\cos({match[1]}\theta {match[2]})")


def functions(text: str) -> Iterator[str]:
    r"""Yield copies with one sine for a cosine or the reverse.

    >>> list(functions(r"\sin\theta"))
    ['\\cos\\theta']
    """
    for match in re.finditer(r"\\(sin|cos)\b", text):
        yield _put(text, match, r"\cos" if match[1] == "sin" else r"\sin")


def exponents(text: str) -> Iterator[str]:
    """Yield copies with one exponent one more, one less, or gone, or with a square put in.

    >>> list(exponents("x^2"))
    ['x^{3}', 'x^{1}', 'x']
    """
    for match in _EXPONENT.finditer(text):
        if text[: match.start()].endswith("}"):  # the upper bound of a sum
            continue
        value = int(match[1] or match[2])
        for other in (value + 1, value - 1):
            if other:
                yield _put(text, match, f"^{{{other}}}")
        yield _put(text, match, "")
    for match in _LETTER.finditer(text):
        if not match[1]:
            yield text[: match.end()] + "^2" + text[match.end() :]


def missing_letters(text: str) -> Iterator[str]:
    """Yield copies without one of the letters.

    >>> list(missing_letters("m r"))
    [' r', 'm ']
    """
    for match in _LETTER.finditer(text):
        yield _put(text, match, "")


def swapped_letters(text: str) -> Iterator[str]:
    """Yield copies with one letter for another.

    >>> list(swapped_letters("l"))
    ['r']
    """
    for match in _SWAPPED.finditer(text):
        for other in _SWAPS[match[0]]:
            yield _put(text, match, other)


def dropped_terms(text: str) -> Iterator[str]:
    """Yield copies without one of the terms of a sum.

    >>> list(dropped_terms("a + (b - c) + d"))
    ['a + d', 'a + (b ) + d', 'a + (b - c) ']
    """
    for match in re.finditer(r"[+-]", text):
        end, depth = match.end(), 0
        while end < len(text):
            depth += (text[end] in "([{") - (text[end] in ")]}")
            if depth < 0 or (depth == 0 and (text[end] in "+-" or text.startswith(r"\right", end))):
                break
            end += 1
        if not text[: match.start()].rstrip().endswith(("(", "[", "{")) and match.start():
            yield text[: match.start()] + text[end:]


def _put(text: str, match: re.Match[str], new: str) -> str:
    return text[: match.start()] + new + text[match.end() :]


KINDS: dict[str, Kind] = {
    "sign turned": signs,
    "wrong coefficient": coefficients,
    "wrong order": orders,
    "wrong phase": phases,
    "sin for cos": functions,
    "wrong exponent": exponents,
    "letter missing": missing_letters,
    "wrong letter": swapped_letters,
    "term dropped": dropped_terms,
}
