r"""Primes that stand for derivatives by the time, J φ'' + k φ = 0, put into dots.

A prime makes another letter of J' and x'' as a rule. It is a rate where one formula adds the letter with
two primes to the bare letter, and the page speaks of a motion: it has a wave of the time, cos ω t, or the
words "equation of motion". Then the same letter with one prime is its speed.
"""

from __future__ import annotations

from symbalance.document.letters import GREEK_SIGN, NAME_OF_SIGN
from symbalance.notes.reading.letters.primes_said import variable_of_primes
from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_GREEK = "|".join(sorted(GREEK_SIGN, key=len, reverse=True))
_SIGNS = "".join(sign for sign in NAME_OF_SIGN if sign != "π")
_LOW = "₀₁₂₃₄₅₆₇₈₉"
_SCRIPT = (
    r"(?:_(?:\{[A-Za-z0-9]{1,4}\}|[A-Za-z0-9]{1,2}(?![A-Za-z0-9]))"
    rf"|[{_LOW}]{{1,2}}|[0-9]{{1,2}}(?![0-9]))"
)
_PRIMES = r"(?P<marks>['′’″]{1,2}|\^\{\s?(?:\\prime\s?){1,2}\})(?!['′’″\w])"
_TWICE = re.compile(r"['′’]{2}|″|\\prime\s?\\prime")
_PRIMED = re.compile(
    rf"(?P<letter>\\(?:{_GREEK})(?![A-Za-z])\s?|(?<![A-Za-z\\])[A-Za-z]|(?<=[^A-Za-z\\][A-Za-z])[A-Za-z]|[{_SIGNS}])"
    rf"(?P<before>{_SCRIPT})?{_PRIMES}(?P<behind>_\{{[A-Za-z0-9]{{1,4}}\}}|_[A-Za-z0-9](?![A-Za-z0-9])|[{_LOW}]{{1,2}})?"
)
_WAVE_OF_TIME = re.compile(
    r"(?:cos|sin|exp|cosh|sinh)\s?[({{]?\s?[^\s=+\-,;]{0,24}[ ]?(?<![A-Za-z])?t(?![A-Za-z])"
    r"|[eE]\s?\^\s?[({{]?[^\s=,;]{0,12}t(?![A-Za-z])"
)
_OF_MOTION = re.compile(
    r"equations?\s+of\s+(?:free\s+)?motion|motion\s+equations?|free\s+vibrations?|free\s+oscillations?"
    r"|Bewegungsgleichung|Schwingungsgleichung|freie\w*\s+Schwingung|équations?\s+d[ue]\s+mouvement"
    r"|equazion[ei]\s+(?:del|di)\s+moto|ecuaci(?:ón|ones)\s+de(?:l)?\s+movimiento|bewegingsvergelijking"
    r"|rörelseekvation|równani\w+\s+ruchu|pohybov\w+\s+rovnic|運動方程式|уравнени\w+\s+движения",
    re.IGNORECASE,
)
_END_OF_FORMULA = re.compile(r"\n[ \t]*\n|\\\\|\$|;")


_FACTOR_BEFORE = re.compile(r"[\w)}²]\s?(?:\\[,;!]|\\cdot|\\times|[·*×⋅])?\s?\(?$")
"""What multiplies a letter: without it, J'' = J + J' is a sum of three letters."""


def with_dots_for_primes(text: str) -> Rewritten | None:
    r"""Return a text with dots for the primes that are rates, None where there are none.

    >>> with_dots_for_primes("Equation of motion: J·φ1'' + k(φ1 − φ2) = 0, speed φ1'").text
    'Equation of motion: J·\\ddot{φ1}  + k(φ1 − φ2) = 0, speed \\dot{φ1} '
    >>> with_dots_for_primes("Reduced: J'' = J + J', the motion x = A cos ωt")
    """
    if _TWICE.search(text) is None or variable_of_primes(text) not in ("", "t"):
        return None
    primed = [match for match in _PRIMED.finditer(text) if _is_formula(text, match)]
    if not any(_order(match) == 2 for match in primed) or not _speaks_of_motion(text):
        return None
    moving = {_letter(match) for match in primed if _order(match) == 2 and _has_bare(text, match)}
    # J₂ φ₂'' beside φ₁'' + φ₁ moves as well
    bases = {letter[0] for letter in moving}
    rewriter, changed = Rewriter(text), False
    for match in primed:
        letter = _letter(match)
        if letter not in moving and not (_order(match) == 2 and letter[0] in bases):
            continue
        dots = "dot" if _order(match) == 1 else "ddot"
        script = match["before"] or match["behind"] or ""
        rewriter.replace(match.start(), match.end(), f"\\{dots}{{{match['letter'].strip()}{script}}} ")
        changed = True
    return rewriter.finish() if changed else None


def _order(match: re.Match[str]) -> int:
    marks = match["marks"]
    return marks.count("prime") or len(marks) + marks.count("″")


def _letter(match: re.Match[str]) -> tuple[str, str]:
    """Return a primed letter and its subscript, however both are typed."""
    letter = match["letter"].strip().lstrip("\\")
    script = re.sub(r"[_{}]", "", match["before"] or match["behind"] or "")
    for number, sign in enumerate(_LOW):
        script = script.replace(sign, str(number))
    return NAME_OF_SIGN.get(letter, letter), script


def _is_formula(text: str, match: re.Match[str]) -> bool:
    """Tell whether primes are no closing quotation marks: ``case a'' has its own opening ones."""
    start = text.rfind("\n", 0, match.start()) + 1
    line = text[start : match.start()]
    return line.count("``") <= line.count("''") and not line.endswith(("'", "‘", "′"))


def _has_bare(text: str, match: re.Match[str]) -> bool:
    """Tell whether the letter stands without primes in the same formula, added to or set equal."""
    formula = _formula_around(text, match)
    if not re.search(r"[=≈]", formula) or not re.search(r"[+\-−–]", formula):
        return False
    others = _PRIMED.sub(" ", formula)
    name, script = _letter(match)
    if len(name) == 1:
        signs = [rf"(?<![A-Za-z\\]){name}", rf"(?<=[^A-Za-z\\][A-Za-z]){name}"]
    else:
        signs = [re.escape(s) for s, n in NAME_OF_SIGN.items() if n == name]
        signs.append(rf"\\{name}(?![A-Za-z])\s?")
    low = "".join(_LOW[int(c)] for c in script) if script.isdecimal() else ""
    behind = rf"(?:_?\{{?{re.escape(script)}\}}?{f'|{low}' if low else ''})" if script else ""
    bare = re.search(rf"(?:{'|'.join(signs)}){behind}(?![A-Za-z0-9_₀-₉]|['′’″])", others)
    if bare is None:
        return False
    is_multiplied = _FACTOR_BEFORE.search(text, max(match.start() - 8, 0), match.start()) is not None
    return (
        is_multiplied
        or _FACTOR_BEFORE.search(others[max(bare.start() - 8, 0) : bare.start()]) is not None
    )


def _formula_around(text: str, match: re.Match[str]) -> str:
    """Return the line that a letter stands in, up to the delimiters of the formula."""
    start = text.rfind("\n", 0, match.start()) + 1
    stop = text.find("\n", match.end())
    stop = len(text) if stop < 0 else stop
    before = [m.end() for m in _END_OF_FORMULA.finditer(text, start, match.start())]
    behind = _END_OF_FORMULA.search(text, match.end(), stop)
    return text[before[-1] if before else start : behind.start() if behind else stop]


def _speaks_of_motion(text: str) -> bool:
    return _OF_MOTION.search(text) is not None or _WAVE_OF_TIME.search(text) is not None
