"""Numbers, units and angles of LaTeX's package siunitx, put into plain LaTeX.

\\SI{40}{\\milli\\metre} and \\qty{40}{mm} become 40\\,\\mathrm{mm}, \\num{1.5e3} 1.5\\cdot 10^{3},
\\ang{12;30} becomes (12+30/60)^\\circ. Lists and ranges are written out; an uncertainty is
no number: None.
"""

from __future__ import annotations

from symbalance.document.wordlists import word_set, words
from symbalance.text import lazy_patterns as re

_PREFIXES = {
    "kilo": "k", "mega": "M", "giga": "G", "centi": "c", "deci": "d",
    "milli": "m", "micro": "u", "nano": "n",
}  # fmt: skip
_UNITS = dict(
    zip(
        words(
            "metre meter gram second newton joule watt pascal radian hertz minute hour bar kelvin percent"
            " degree kg kilogram kilogramme rpm"
        ),
        words("m m g s N J W Pa rad Hz min h bar K % ° kg kg kg rpm"),
        strict=True,
    )
)
_SHORT = dict.fromkeys(words("kg mm cm dm km um g mg s ms N kN MN J kJ W kW Pa kPa MPa Hz kHz rad K m"))
"""Abbreviations of siunitx that are a unit's own letters: \\kg, \\mm."""
_TURNS = word_set("rev revs r U Umdr tr giri turns")
"""What stands before /min for a revolution, in some languages: rpm, as one unit."""
_RATES: dict[tuple[tuple[str, int], ...], str] = {(("min", -1),): "rpm", (("s", -1),): "rps"}
"""The speeds that a revolution with one of these behind it is: rev/min and rev/s."""
_NUMBER = re.compile(
    r"(?P<sign>[-+−–]?)(?P<digits>[0-9][0-9 ~]*(?:[.,][0-9 ]*[0-9])?|[.,][0-9]+)?"
    r"(?:[eEdD](?P<power>[-+−]?[0-9]{1,3}))?"
)
_WORD = re.compile(
    r"\s*(?:\\([A-Za-z]+)|([A-Za-zµμ%°]+)|(\^\s*\{?\s*([-−]?[0-9])\s*\}?)|([./*·~]|\\,)|(\{|\}))"
)
_LIKE_THOUSANDS = re.compile(r"(?<=[0-9])\.(?=[0-9]{3}$)")
"""The point of 2.592, which parts thousands on a page of decimal commas, but never within \\num."""
_MOST_WORDS = 30


def number_text(source: str) -> str | None:
    r"""Return the argument of \num as LaTeX, None for what is no single plain number.

    >>> number_text("1,5e-3"), number_text("0.45(2)"), number_text("-40")
    ('1.5\\cdot 10^{-3}', None, '-40')
    """
    match = _NUMBER.fullmatch(source.strip())
    if match is None or not (match["digits"] or match["power"]):
        return None
    sign = "-" if match["sign"] and match["sign"] in "-−–" else ""
    digits = re.sub(r"[ ~]", "", match["digits"] or "").replace(",", ".")
    digits = _LIKE_THOUSANDS.sub("{.}", digits)
    power = (match["power"] or "").replace("−", "-").lstrip("+")
    scale = f"10^{{{power}}}" if power else ""
    return sign + (f"{digits}\\cdot {scale}" if digits and scale else digits or scale)


def unit_text(source: str) -> str | None:
    r"""Return the argument of \si as \mathrm{...}, None for a unit that is not read.

    >>> unit_text("rev/min"), unit_text("rev/s"), unit_text("1/s")
    ('\\mathrm{rpm}', '\\mathrm{rps}', '\\mathrm{s^{-1}}')
    >>> unit_text(r"\kilo\gram\metre\per\second\squared"), unit_text("N.m"), unit_text(r"\furlong")
    ('\\mathrm{kg\\,m\\,s^{-2}}', '\\mathrm{N\\,m}', None)
    """
    parts: list[tuple[str, int]] = []
    place, prefix, sign, power, is_literal = 0, "", 1, 1, False
    source = re.sub(r"^\^?\s*\{?\s*\\circ\s*\}?$", "°", source.strip())
    source = re.sub(r"^1(?=\s*/)", "", source)
    for _ in range(_MOST_WORDS):
        if place >= len(source):
            break
        match = _WORD.match(source, place)
        if match is None:
            return None
        place = match.end()
        command, literal, raised, digit, joint, _brace = match.groups()
        if command == "per":
            sign = -1
        elif command in _PREFIXES:
            prefix = _PREFIXES[command]
        elif command in ("square", "cubic"):
            power = 2 if command == "square" else 3
        elif command in ("squared", "cubed", "tothe", "raiseto") or raised:
            exponent, place = _exponent(command or "", digit, source, place)
            if exponent is None or not parts:
                return None
            parts[-1] = (parts[-1][0], parts[-1][1] * exponent)
        elif joint:
            sign = -1 if joint == "/" else (1 if is_literal else sign)
        elif command or literal:
            unit = literal or _UNITS.get(command) or (command if command in _SHORT else None)
            if unit is None:
                return None
            is_literal = is_literal or bool(literal)
            parts.append((prefix + unit, sign * power))
            prefix, sign, power = "", 1, 1
    if place < len(source) or not parts or prefix:
        return None
    return _written(parts)


def _exponent(command: str, digit: str | None, source: str, place: int) -> tuple[int | None, int]:
    """Return the exponent that a command or a caret gives, and where it ends."""
    if command in ("squared", "cubed"):
        return (2 if command == "squared" else 3), place
    if digit:
        return int(digit.replace("−", "-")), place
    match = re.compile(r"\s*\{\s*(-?[0-9])\s*\}").match(source, place)
    return (int(match[1]), match.end()) if match else (None, place)


def _written(parts: list[tuple[str, int]]) -> str:
    if parts[0][0] in _TURNS and parts[0][1] == 1 and (turns := _RATES.get(tuple(parts[1:]))):
        parts = [(turns, 1)]
    if parts in ([("%", 1)], [("°", 1)]):
        return "\\%" if parts[0][0] == "%" else "^{\\circ}"
    pieces = (unit if power == 1 else f"{unit}^{{{power}}}" for unit, power in parts)
    return "\\mathrm{" + "\\,".join(pieces) + "}"


def quantity_text(number: str, unit: str) -> str | None:
    r"""Return \SI{number}{unit} as LaTeX.

    >>> quantity_text("6000", "\\per\\minute"), quantity_text("5", "\\percent")
    ('6000\\,\\mathrm{min^{-1}}', '5\\%')
    """
    size, measure = number_text(number), unit_text(unit) if unit.strip() else ""
    if size is None or measure is None:
        return None
    tight = measure.startswith(("^", "\\%")) or not measure
    return size + ("" if tight else "\\,") + measure


def angle_text(source: str) -> str | None:
    r"""Return \ang{degrees;minutes;seconds} as LaTeX.

    >>> angle_text("60"), angle_text("12;30;")
    ('60^{\\circ}', '(12+30/60)^{\\circ}')
    """
    parts = [part.strip() for part in source.split(";")]
    numbers = [number_text(part) if part else "0" for part in parts]
    if len(parts) > 3 or None in numbers or "\\" in "".join(n or "" for n in numbers):
        return None
    if len(parts) == 1:
        return f"{numbers[0]}^{{\\circ}}"
    sign = "-" if (numbers[0] or "").startswith("-") else "+"
    terms = [str(n) + "/60" * place for place, n in enumerate(numbers) if n not in ("0", None)]
    return f"({sign.join(terms) or '0'})^{{\\circ}}"


def list_text(source: str, unit: str = "") -> str | None:
    r"""Return \SIlist{30;40;50}{mm} as numbers with commas between them, each with the unit.

    >>> list_text("30;40", "mm"), list_text("1;2")
    ('30\\,\\mathrm{mm}, 40\\,\\mathrm{mm}', '1, 2')
    """
    quantities = [quantity_text(part.strip(), unit) for part in source.split(";")]
    return None if None in quantities else ", ".join(q for q in quantities if q)


def range_text(first: str, last: str, unit: str = "") -> str | None:
    r"""Return \SIrange{10}{20}{mm} as two quantities with dots between them.

    >>> range_text("1", "4"), range_text("0", "90", "\\degree")
    ('1 \\ldots 4', '0^{\\circ} \\ldots 90^{\\circ}')
    """
    ends = quantity_text(first, unit), quantity_text(last, unit)
    return None if None in ends else f"{ends[0]} \\ldots {ends[1]}"
