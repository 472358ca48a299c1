"""One canonical name for each letter, however it is written: θ, \\theta and theta are `theta`."""

from __future__ import annotations

from collections.abc import Collection

from symbalance.document.letters import (
    ACCENTS,
    FONTS,
    FUNCTION_WORDS,
    GREEK_SIGN,
    LOWERED,
    NAME_OF_SIGN,
    RAISED,
    TIME_DOTS,
    WORDS,
)
from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.signs import COMBINED, VULGAR, accented
from symbalance.text import lazy_patterns as re

_COMMAND = re.compile(r"\\([A-Za-z]+)\s*")
_WORD = re.compile(r"[A-Za-z][A-Za-z0-9]*")
_CANONICAL = re.compile(r"[A-Za-z][A-Za-z0-9]*(?:_[A-Za-z0-9]+)+'*")
_TOUCHING = re.compile(r"([A-Za-z0-9]+)(['′]*)")
_PRIMES = re.compile(r"(?:['′’″]|\^\s*\{?\s*(?:\\prime\s*)+\}?)+")
_NUMBERED = re.compile(
    r"\s*\^\s*\{(?:\\[,;:! ]|\s)*(?:\\left)?\(\s*([0-9]{1,2}|[A-Za-z]|[IVX]{1,4})\s*(?:\\right)?\)\s*\}"
    r"|⁽([⁰¹²³⁴-⁹ⁿⁱ]{1,2})⁾"
)
"""The (2) of F^{(2)}: nobody writes a power so."""
_LISTED_BELOW = re.compile(r"([^\W\d_]+)_([A-Za-z0-9]+(?:,[A-Za-z0-9]+)+)('*)")
"""A subscript of several parts as it is typed without braces, F_cap,115."""
_ORDER = re.compile(
    r"(?:^|(?<=,))\s*(?:\\left)?\(\s*([0-9]{1,2}|[A-Za-z]|[IVX]{1,4})\s*(?:\\right)?\)(?=\s*(?:,|$))"
)
"""The (1) of F_{(1)} and F_{osc,(2)}, the order of a force."""
LONGEST_SUBSCRIPT = 80
"""Longer runs of letters are no subscript; the limit keeps the search for a declared one short."""
EXTREMES = ("max", "min", "sup", "inf", "lim")
"""Words that are one subscript, behind an underscore too: ω_min is no ω_m times i n."""


_SIGNS_BELOW = {"∥": "parallel", "⊥": "perp", "∞": "infty", "‖": "parallel"}
"""Signs that tell directions and limits apart: M_∥ along the cylinders, M_⊥ across them."""


_INITIALS = re.compile(r"[A-Z]\.(?:[ ]?[A-Z]\.){1,4}")
"""An abbreviation with points, T.E., which a page sets equal to something."""


def letter_of_initials(text: str) -> str:
    """Return an abbreviation with points as one letter: I.H.P. as I_{HP}.

    >>> letter_of_initials("I.H.P.")
    'I_{HP}'
    """
    first, *others = re.findall("[A-Z]", text)
    return f"{first}_{{{''.join(others)}}}"


def canonical_name(text: str) -> str:
    r"""Return the canonical name of a letter written in LaTeX, Unicode or plain text.

    >>> canonical_name(r"m_{\mathrm{rec}}"), canonical_name("m₁"), canonical_name(r"\bar{x}'")
    ('m_rec', 'm_1', "bar_x'")
    >>> canonical_name("F_cap,115") == canonical_name("F_{cap,115}")
    True
    >>> canonical_name("T.E."), canonical_name("I.H.P.")
    ('T_E', 'I_HP')
    >>> canonical_name("ωm"), canonical_name("θ2"), canonical_name(r"\ddot{x}")
    ('omega_m', 'theta_2', 'ddot_x')
    """
    bare = COMBINED.sub(accented, text.strip().strip("$").strip())
    if _CANONICAL.fullmatch(bare):
        return bare
    if _INITIALS.fullmatch(bare):
        return canonical_name(letter_of_initials(bare))
    if listed := _LISTED_BELOW.fullmatch(bare):
        return canonical_name(f"{listed[1]}_{{{listed[2]}}}{listed[3]}")
    base, stop = _base(bare)
    if (touching := _TOUCHING.fullmatch(bare, stop)) and bare[:1] in NAME_OF_SIGN and base != "pi":
        return f"{base}_{touching[1]}{len(touching[2]) * chr(39)}"
    name, stop = with_scripts(bare, base, stop, len(bare))
    if not bare or stop != len(bare):
        raise _junk(text)
    return name


def _junk(text: str) -> ReadingError:
    quotation = text if len(text) <= 40 else text[:37] + "..."
    return ReadingError(
        0, f"{quotation!r} is not a letter", "write a letter such as \\lambda, λ, m_1 or Lh"
    )


def _base(text: str) -> tuple[str, int]:
    if match := _WORD.match(text):
        return match.group(), match.end()
    if text[:1] in NAME_OF_SIGN:
        return _differential(text, NAME_OF_SIGN[text[0]], 1)
    if match := _COMMAND.match(text):
        return _command_base(text, match)
    raise _junk(text)


def _command_base(text: str, match: re.Match[str]) -> tuple[str, int]:
    command = match.group(1)
    if command in GREEK_SIGN:
        plain_end = match.start() + len(command) + 1
        return _differential(text, command, plain_end)
    if command in FONTS or command in WORDS or command in ACCENTS:
        inner, stop = _argument(text, match.end())
        name = canonical_name(inner)
        return (f"{ACCENTS[command]}_{name}" if command in ACCENTS else name), stop
    if command in TIME_DOTS:
        inner, stop = _argument(text, match.end())
        return f"{command}_{canonical_name(inner)}", stop
    raise _junk(text)


def _differential(text: str, name: str, stop: int) -> tuple[str, int]:
    """Δx is one letter, Delta_x."""
    if name in ("Delta", "delta") and (match := re.compile(r"\s*([A-Za-z])$").match(text, stop)):
        return f"{name}_{match.group(1)}", match.end()
    return name, stop


def _argument(text: str, start: int) -> tuple[str, int]:
    if text[start : start + 1] != "{":
        match = _COMMAND.match(text, start)
        stop = match.end() if match else start + 1
        return text[start:stop], stop
    stop = matching_brace(text, start, len(text))
    return text[start + 1 : stop - 1], stop


def matching_brace(text: str, start: int, end: int, longest: int = 4 * LONGEST_SUBSCRIPT) -> int:
    """Return the offset after the brace that closes the one at `start`."""
    depth = 0
    for place in range(start, min(end, start + longest)):
        depth += {"{": 1, "}": -1}.get(text[place], 0)
        if depth == 0:
            return place + 1
    raise ReadingError(start, "bracket { is never closed", "close it")


def with_scripts(
    text: str, base: str, start: int, end: int, names: Collection[str] | None = None
) -> tuple[str, int]:
    """Return a letter's name with the subscript and primes that follow, and where they end.

    `names` settles what of an unbraced subscript belongs to it: `m_pr` is m_p r where m_p is declared.
    """
    subscript, primes, stop = "", 0, start
    while True:
        if match := _PRIMES.match(text, stop, end):
            primes += len(re.findall(r"\\prime|['′’]", match.group())) + 2 * match.group().count("″")
            stop = match.end()
        elif not subscript and (after := subscript_at(text, stop, end, base, names)):
            subscript, stop = after
        else:
            break
    if order := order_at(text, stop, end):
        number, stop = order
        if not subscript and (after := subscript_at(text, stop, end, base, names)):
            subscript, stop = after
        subscript = f"{subscript},({number})" if subscript else f"({number})"
        if match := _PRIMES.match(text, stop, end):
            primes += len(re.findall(r"\\prime|['′’]", match.group())) + 2 * match.group().count("″")
            stop = match.end()
    return base + (f"_{subscript}" if subscript else "") + "'" * primes, stop


def with_order(text: str, name: str, start: int, end: int) -> tuple[str, int]:
    """Return a known letter with the order in brackets above it, F_x^{(2)} as F_x,(2), and its end."""
    order = order_at(text, start, end)
    return (name, start) if order is None else (f"{name},({order[0]})", order[1])


def order_at(text: str, start: int, end: int) -> tuple[str, int] | None:
    r"""Return the 2 of an order in brackets above a letter, F_1^{(2)}, and where it ends; or None."""
    match = _NUMBERED.match(text, start, end)
    if match is None:
        return None
    return match[1] or "".join(RAISED[sign] for sign in match[2]), match.end()


def subscript_at(
    text: str, start: int, end: int, base: str = "", names: Collection[str] | None = None
) -> tuple[str, int] | None:
    """Return the subscript that begins at `start` (spaces allowed) and where it ends, or None."""
    stop_ = start
    while stop_ < end and text[stop_] in LOWERED:
        stop_ += 1
    if stop_ > start:
        return "".join(LOWERED[c] for c in text[start:stop_]), stop_
    match = re.compile(r"\s*_\s*").match(text, start, end)
    if not match or match.end() >= end:
        return None
    if text[match.end()] == "{":
        stop = matching_brace(text, match.end(), end)
        return subscript_name(text[match.end() + 1 : stop - 1], match.end()), stop
    return _bare_subscript(text, match.end(), end, base, names)


def _bare_subscript(
    text: str, start: int, end: int, base: str, names: Collection[str] | None
) -> tuple[str, int]:
    """Return a subscript without braces: a command's, the longest declared one, or a single sign."""
    if match := _COMMAND.match(text, start, end):
        if match.group(1) in FONTS | WORDS:
            inner, stop = _argument(text, match.end())
            return subscript_name(inner, start), stop
        return subscript_name(match.group(), start), start + len(match.group(1)) + 1
    if match := re.compile(r"[0-9]+|[A-Za-z][A-Za-z0-9]*").match(text, start, end):
        run = match.group()[:LONGEST_SUBSCRIPT]
        if len(run) > 1 and text[start + len(run) : min(start + len(run) + 1, end)] == "_":
            run = run[:-1]  # a_zm_o is a_z m_o
        if run in EXTREMES:
            return run, start + len(run)
        lengths = range(len(run), 0, -1) if names is not None else ()
        whole = (n for n in lengths if not (run[n - 1 : n].isdecimal() and run[n : n + 1].isdecimal()))
        length = next(
            (
                n
                for n in whole
                if f"{base}_{run[:n]}" in (names or ()) and may_be_letters(run[n:], names or ())
            ),
            len(run),
        )
        return run[:length], start + length
    return subscript_name(text[start], start), start + 1


def may_be_letters(rest: str, names: Collection[str]) -> bool:
    """Tell whether what follows a declared letter, the r of m_pr, may be letters; I in F_II is none."""
    begins_function = any(rest.startswith(word) for word in FUNCTION_WORDS)
    return not rest or begins_function or rest[0] in names or rest[0] in "deij" or rest[0].isdecimal()


_EXTREME_IN_BRACKETS = re.compile(
    rf"(?P<comma>,?)\s*(?:\\left)?\(\s*(?:\\(?:{'|'.join(sorted(FONTS | WORDS))})\s*\{{\s*)?"
    rf"\\?(?P<word>{'|'.join(EXTREMES)})\s*\}}?\s*(?:\\right)?\)"
)


_FRACTION_BELOW = re.compile(
    r"\\[td]?frac(?:\s*\{\s*([0-9]{1,2})\s*\}|\s*([0-9]))\s*(?:\{\s*([0-9]{1,2})\s*\}|([0-9]))"
)
_FRACTION_SIGN = re.compile(rf"(?<![0-9])[{''.join(VULGAR)}]")
_ORDER_SLASH = re.compile(r"(?<=[0-9])/(?=[0-9])")
"""The stroke of R_{1/2}, the wave of order one half."""


def _beside(match: re.Match[str]) -> str:
    """Return the (max) of F_{S(max)} as that of F_{S,max}."""
    return f",{match['word']}" if match.start() else match["word"]


def subscript_name(text: str, offset: int) -> str:
    r"""Return a subscript in plain letters.

    >>> subscript_name(r"\mathrm{rec},\theta", 0)
    'rec,theta'
    >>> subscript_name("(1)", 0), subscript_name(r"S(\max)", 0), subscript_name(r"\frac{3}{2}", 0)
    ('(1)', 'S,max', '3/2')
    >>> subscript_name(r"\perp", 0), subscript_name("∥", 0)
    ('perp', 'parallel')
    """
    text = _EXTREME_IN_BRACKETS.sub(_beside, text)
    text = _FRACTION_BELOW.sub(lambda m: f"{m[1] or m[2]}/{m[3] or m[4]}", text)
    text = _FRACTION_SIGN.sub(lambda m: "{}/{}".format(*VULGAR[m[0]]), text)
    slashes = {match.start() for match in _ORDER_SLASH.finditer(text)}
    pieces: list[str] = []
    orders = {place for match in _ORDER.finditer(text) for place in range(*match.span())}
    for match in re.finditer(r"\\([A-Za-z]+)|\\[,;: !]|(.)", text, re.DOTALL):
        command, sign = match.group(1), match.group(2)
        if command in GREEK_SIGN or command in EXTREMES or command in _SIGNS_BELOW.values():
            pieces.append(command)
        elif sign in _SIGNS_BELOW:
            pieces.append(_SIGNS_BELOW[sign])
        elif command in FONTS or command in WORDS or (sign and sign in "{} \n"):
            continue
        elif sign and (sign.isalnum() or sign in ",.+-−*"):
            pieces.append(NAME_OF_SIGN.get(sign, sign))
        elif match.start() in slashes:
            pieces.append("/")
        elif match.start() in orders:
            pieces.append(sign if sign in ("(", ")") else "")
        elif sign or command:
            raise ReadingError(offset, f"subscript {text!r} is not read", "use letters and digits")
    if not pieces:
        raise ReadingError(offset, "empty subscript", "name the letter's subscript")
    return "".join(pieces)
