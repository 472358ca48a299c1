r"""Units typed without the signs between them: kgm² is kg m², \mathrm{kg^3m^6} is kg³ m⁶, N/mm2 is N/mm².

An exponent belongs to the last sign only: kNm² is kN m², and no (kNm)². A figure behind a sign is its
exponent where the two can be no letter with its number: mm2, kg m2, m/s2 and m s-1, but not 3 m2.
"""

from __future__ import annotations

from collections.abc import Callable

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

_SIGNS = r"(?:kg|mg|[kM]?N|[kM]?J|[kM]?W|[kMG]?Pa|mm|cm|dm|km|rad|[msgK])"
_EXPONENT = r"(?:\^\{[-−]?[1-9]\}|\^[-−]?[1-9]|⁻?[¹²³⁴⁵⁶])"
_NUMBER_END = r"(?<=[0-9⁰¹²³⁴⁵⁶⁷⁸⁹}½¼¾])(?<!_[0-9])"
_GAP = r"(?:\$|\\\))?(?:[ ~\u2009\u202f]|\\[,;: ])*+(?:\\(?:text|mathrm|mbox|textrm)\s?\{\s?)?"
_RUN = re.compile(
    rf"{_NUMBER_END}{_GAP}(?P<run>(?:{_SIGNS}{_EXPONENT}?){{2,5}})(?![A-Za-z0-9(_^'′⁻¹²³⁴{{])"
    rf"(?P<behind>(?:\}}[ ]?|\$){_EXPONENT})?"
)
_FLAT_EXPONENT = r"-?[1-4](?![0-9.])"
_PART = re.compile(rf"(?P<sign>{_SIGNS})(?P<power>{_EXPONENT}|{_FLAT_EXPONENT})?")
_RUN_OF_UNIT = re.compile(
    rf"(?<![A-Za-z0-9])(?P<run>(?:{_SIGNS}(?:{_EXPONENT}|{_FLAT_EXPONENT})?){{2,5}})(?![A-Za-z0-9^⁻¹²³⁴])"
)
_MILLISECONDS_BELOW = re.compile(r"(?<![A-Za-z])ms\s?(?:\^[{(]?|(?=⁻))[-−⁻]")
_TURNING = re.compile(r"(?:[nfωΩ]|\\[oO]mega|omega)(?:_\w+|_\{[^{}=]*\})?[ $]*[=≈][^=≈]*$")
"""What is so many times in a millisecond: ω = 0.3 ms^{-1}."""
_JOINT = r"(?:[ ]?[/·⋅*][ ]?|[ ]|\\[,; ]|\\cdot[ ]|(?<=kg)|(?<=Nm)|(?<=N))"
_FLAT = re.compile(
    rf"{_NUMBER_END}{_GAP}"
    rf"(?P<unit>(?:(?:mm|cm|dm|km)[234]|min-1|(?<=[0-9][0-9] )s-1"
    rf"|{_SIGNS}[234]?(?:{_JOINT}{_SIGNS}(?:-?[1-4])?)"
    rf"{{1,3}}+)(?<=[1-4]))(?![A-Za-z0-9(_^'′⁻¹²³⁴{{]|[.,][0-9])"
)
_FLAT_PART = re.compile(rf"(?P<joint>{_JOINT})?(?P<sign>min|{_SIGNS})(?P<figure>-?[1-4])?")
_AROUND = 40
Changes = dict[int, tuple[int, str]]


def with_joined_units(
    text: str, is_letter: Callable[[str, int], bool] = lambda name, line: False
) -> tuple[Rewritten | None, tuple[str, ...]]:
    r"""Return a text with the signs of units apart, None where they are, and what to say of it.

    `is_letter` tells whether a name is a declared letter on a line.

    >>> with_joined_units(r"280.8\,\mathrm{kg^3m^6} or 3 kNm²")[0].text
    '280.8\\,\\mathrm{kg^3 m^6} or 3 kN m²'
    >>> with_joined_units("A = 54 mm2, m = 3 m2, a = 9 m/s2")[0].text
    'A = 54 mm^2, m = 3 m2, a = 9 m/s^2'
    """
    changes: Changes = {}
    speeds, flats = list[str](), list[str]()
    for match in _RUN.finditer(text):
        line = text.count("\n", 0, match.start()) + 1
        apart = "" if is_letter(match["run"], line) else _apart(match["run"], match["behind"] or "")
        before = text[max(match.start() - _AROUND, 0) : match.start()]
        is_rate = apart.startswith("m s") and _TURNING.search(before) is not None
        if apart and not is_rate:
            changes[match.start("run")] = match.end("run"), apart
            if apart.startswith("m s"):
                speeds.append(re.sub(r"[{}$ ]", "", f"{match['run']}{match['behind'] or ''}"))
    for match in _FLAT.finditer(text):
        if match.start("unit") not in changes and (raised := _raised(match, is_letter)):
            changes[match.start("unit")] = match.end("unit"), raised
            flats.append(f"{match['unit']} is read as {raised}")
    if not changes:
        return None, ()
    rewriter = Rewriter(text)
    for start, (end, written) in sorted(changes.items()):
        rewriter.replace(start, end, written)
    notes = [f"{speeds[0]} is read as metres by seconds ({len(speeds)}×)"] if speeds else []
    notes += [f"figures as exponents of units: {flats[0]} ({len(flats)}×)"] if flats else []
    return rewriter.finish(), tuple(notes)


def signs_apart(unit: str) -> str:
    """Return a unit as it is declared with its signs apart, and what is so already as it stands.

    >>> signs_apart("kgm^2/s"), signs_apart("Nm"), signs_apart("N/mm2")
    ('kg m^2/s', 'Nm', 'N/mm2')
    """
    return _RUN_OF_UNIT.sub(lambda match: _apart(match["run"]) or match["run"], unit)


def may_be_of_milliseconds(unit: str) -> bool:
    """Tell whether ms^-1 stands in a unit, which may be one in a millisecond or a metre in a second."""
    return _MILLISECONDS_BELOW.search(unit) is not None


def _apart(run: str, behind: str = "") -> str:
    """Return a run of signs of units with spaces between them, "" for what stays."""
    parts = list(_PART.finditer(run))
    powers = [part["power"] or "" for part in parts]
    powers[-1] = powers[-1] or behind
    if not any(powers) and scale_of(run) is not None:
        return ""  # Nm, kgmm: signs of their own
    if [part["sign"] for part in parts] == ["m", "s"] and not any(sign in powers[1] for sign in "-−⁻"):
        return ""  # milliseconds
    return " ".join(part.group() for part in parts)


def _raised(match: re.Match[str], is_letter: Callable[[str, int], bool]) -> str:
    """Return a unit whose figures are exponents with carets, "" where they may number letters."""
    parts = list(_FLAT_PART.finditer(match["unit"]))
    text, line = match.string, match.string.count("\n", 0, match.start()) + 1
    written = ""
    for part in parts:
        sign, figure = part["sign"], part["figure"] or ""
        if is_letter(sign, line) and len(sign) == 1 and (len(parts) == 1 or "-" in figure):
            return ""
        own = (sign + figure, f"{sign}_{figure}", *([sign] if "-" in figure and len(parts) == 1 else []))
        if figure and any(is_letter(name, line) or _has_value(text, name) for name in own):
            return ""
        if figure and len(sign) == 1 and part is parts[0] and len(parts) > 1:
            return ""  # 3 m2/s: a mass by its number
        joint = (part["joint"] or " ") if written else ""
        written += f"{joint}{sign}{f'^{figure}' if figure else ''}"
    is_sure = len(parts) == 1 or len(parts[0]["sign"]) > 1 or "/" in written or "-" in written
    return written if is_sure and scale_of(written) is not None else ""


def _has_value(text: str, name: str) -> bool:
    """Tell whether a page gives a letter a value, m2 = 3 kg, by which it is none of its units."""
    head = rf"(?:^|[,;:(.$|][ \t$]*|\b(?:and|with|where|for|und|mit|wo|für|et|avec)[ $]+){name}[ ]?[=≈]"
    return re.compile(head, re.MULTILINE).search(text) is not None
