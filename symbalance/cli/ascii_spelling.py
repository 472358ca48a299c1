"""Results in plain ASCII for streams without Unicode: −√(5 − 2√5)/λ² as -sqrt(5 - 2*sqrt(5))/lam^2.

A sign that a stream cannot encode must never be lost: `?` for − is another number. Formulas are spelled
so that programs read them with the same value; columns of tables stay in line.
"""

from __future__ import annotations

import re
import unicodedata

from symbalance.errors import encodable_name


def _decomposed(kind: str) -> dict[str, str]:
    """Return the raised or lowered characters, and what each is when it stands on the line."""
    every = [chr(code) for code in (0xB2, 0xB3, 0xB9, *range(0x2B0, 0x2E5), *range(0x1D2C, 0x1DC0))]
    every += [chr(code) for code in (*range(0x2070, 0x20A0), *range(0x2C7C, 0x2C7E))]
    parts_of = {c: unicodedata.decomposition(c).split() for c in every}
    parts_of = {c: chr(int(parts[1], 16)) for c, parts in parts_of.items() if parts[:1] == [kind]}
    return {c: "-" if plain == "−" else plain for c, plain in parts_of.items()}


RAISED = _decomposed("<super>")
LOWERED = _decomposed("<sub>")
GREEK = {
    "α": "alpha", "β": "beta", "γ": "gamma", "δ": "delta", "ε": "epsilon", "ζ": "zeta", "η": "eta",
    "θ": "theta", "ι": "iota", "κ": "kappa", "λ": "lam", "μ": "mu", "ν": "nu", "ξ": "xi",
    "ο": "omicron", "π": "pi", "ρ": "rho", "σ": "sigma", "ς": "sigma", "τ": "tau", "υ": "upsilon",
    "φ": "phi", "χ": "chi", "ψ": "psi", "ω": "omega", "ϑ": "theta", "ϕ": "phi", "ϵ": "epsilon",
    "Γ": "Gamma", "Δ": "Delta", "Θ": "Theta", "Λ": "Lambda", "Ξ": "Xi", "Π": "Pi", "Σ": "Sum",
    "Φ": "Phi", "Ψ": "Psi", "Ω": "Omega",
}  # fmt: skip
SIGNS = {
    "−": "-", "·": "*", "⋅": "*", "∙": "*", "•": "*", "×": "x", "÷": "/", "∕": "/", "∗": "*", "±": "+/-",
    "∓": "-/+", "≈": "~", "≃": "~", "≅": "~", "∼": "~", "≒": "~", "≤": "<=", "≥": ">=", "≦": "<=",
    "≧": ">=", "⩽": "<=", "⩾": ">=", "≠": "!=", "≡": "==", "≔": ":=", "∞": "infinity", "→": "->",
    "←": "<-", "↔": "<->", "⇒": "=>", "⇔": "<=>", "…": "...", "⋯": "...", "°": " deg", "′": "'",
    "″": "''", "‘": "'", "’": "'", "“": '"', "”": '"', "„": '"', "«": '"', "»": '"', "–": "-", "—": "-",
    "‐": "-", "‑": "-", "∂": "d", "∆": "Delta", "∑": "Sum", "∏": "Product", "∫": "integral",
    "∮": "integral", "µ": "u", "∴": "therefore", "∵": "because", "∝": " is proportional to ", "∈": " in ",
    "\u00a0": " ", "\u202f": " ", "\u2009": " ",
}  # fmt: skip

SAME = {c: SIGNS[c] for c in "−–—‐‑‘’“”…\u00a0\u202f\u2009"}
"""What may be written otherwise even in somebody's own words."""
LETTERS = {"ß": "ss", "æ": "ae", "Æ": "Ae", "œ": "oe", "Œ": "Oe", "ø": "o", "Ø": "O", "ł": "l", "Ł": "L"}

_UP, _DOWN, _GREEK = (f"[{''.join(table)}]" for table in (RAISED, LOWERED, GREEK))
_PARTS = "½⅓⅔¼¾⅕⅖⅗⅘⅙⅚⅛⅜⅝⅞"
_ATOM = rf"(?:\d+(?:\.\d+)?|[{_PARTS}]|(?!a?(?:sin|cos|tan))[A-Za-z]{_DOWN}*|{_GREEK}{_DOWN}*)"
_NAME = r"\b(a?(?:sin|cos|tan))"
_PRODUCT = rf"{_ATOM}*{_GREEK}{_DOWN}*{_ATOM}*"
_FUNCTION = re.compile(rf"{_NAME}({_UP}*)(?: ?({_PRODUCT})| (\([^()]*\){_PRODUCT}))(?![\w(]|{_UP})")
"""sin²nωt or sin (2i+1)θ: the argument goes as far as the product that is written without a space."""
_OPEN_FUNCTION = re.compile(rf"{_NAME}{_UP}* ?{_PRODUCT}{_UP}*")
_ROOT_SIGN = r"\u221a"
_POWER_OF_FUNCTION = re.compile(rf"{_NAME}({_UP}+)(\([^()]*\))")
_SERIES = re.compile("([₀-₉])F([₀-₉])(?=\\()")
_MIXED = re.compile(rf"(?<![\w.])(\d+)([{_PARTS}])")
_UNDER_ROOT = re.compile(
    rf"√*(?:\d+(?:\.\d+)?|[{_PARTS}]|(?:[A-Za-z]|{_GREEK}){_DOWN}*(?![A-Za-z]|{_GREEK}))(?!{_UP})"
)
_POWER_OF_TEN = re.compile(r"(?<=\d) × 10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)")
_FACTORS = "λπρ"
"""Letters that are no functions: λ(λ + 1) is a product."""
_RULE = re.compile(r" *─[─ ]*$")
_CELL = re.compile(r"\S+(?: \S+)*")


def encodable(text: str, encoding: str) -> bool:
    """Tell whether a stream of this encoding can take a text."""
    try:
        text.encode(encoding)
    except (UnicodeEncodeError, LookupError):
        return False
    return True


def as_encodable(text: str, encoding: str) -> str:
    """Return a text as it is, or spelled so that a stream of this encoding can take it.

    >>> as_encodable("−√(5 − 2√5)/2 at λ⁻³, 3πθ, cos 2θ, λ = 4 naïve 度", "ascii")
    '-sqrt(5 - 2*sqrt(5))/2 at lam^(-3), 3*pi*theta, cos(2*theta), lam = 4 naive \\\\u5ea6'
    >>> as_encodable("6√3 r ω²", "utf-8")
    '6√3 r ω²'
    """
    if encodable(text, encoding):
        return text
    blocks = re.split(r"(\n(?: *\n)+)", text)  # blocks of lines, and the blank lines between them
    return "".join(_block(block, encoding) for block in blocks)


def as_quoted(text: str, encoding: str) -> str:
    r"""Return somebody's own words, or a file's name: as they are, or each character by its code.

    They are no formula of ours, and what they mean is not known: none is changed into another.

    >>> print(as_quoted("ü.md: sinωt − 1", "ascii"))
    \xfc.md: sin\u03c9t - 1
    """
    text = encodable_name(text)
    return "".join(c if encodable(c, encoding) else SAME.get(c, ascii(c)[1:-1]) for c in text)


def as_json(text: str, encoding: str) -> str:
    """Return a JSON document as it is, or with escapes that stand for the same characters."""
    if encodable(text, encoding):
        return text
    units = (c.encode("utf-16-be") for c in text)
    return "".join(
        c if c.isascii() else "".join(f"\\u{pair.hex()}" for pair in (unit[:2], unit[2:]) if pair)
        for c, unit in zip(text, units, strict=True)
    )


def _block(block: str, encoding: str) -> str:
    lines = block.split("\n")
    rules = [k for k, line in enumerate(lines) if _RULE.match(line)]
    if rules and rules[0]:
        return "\n".join(_table(lines, rules[0], encoding))
    return "\n".join(_spelled(line, encoding) for line in lines)


def _table(lines: list[str], rule: int, encoding: str) -> list[str]:
    """Return the lines of a table anew, its columns as wide as their cells have become.

    A column is where cells of several lines overlap; the line above the rule has the titles. Lines of one
    cell stand above or below the table, or within it, and keep to themselves.
    """
    cells = [list(_CELL.finditer(line)) for line in lines]
    of_table = [k for k, row in enumerate(cells) if k >= rule - 1 and k != rule and len(row) > 1]
    columns: list[list[int]] = []
    for start, end in sorted(cell.span() for k in of_table for cell in cells[k]):
        if columns and start < columns[-1][1]:
            columns[-1][1] = max(columns[-1][1], end)
        else:
            columns.append([start, end])
    # A cell that goes on alone in its line, and does not stand in the first column, moves with its own.
    ends = {column[0]: column[1] for column in columns[1:]}
    alone = [(k, row[0].span()) for k, row in enumerate(cells) if k > rule and len(row) == 1]
    of_table += [k for k, (start, end) in alone if end <= ends.get(start, 0)]
    texts: list[dict[int, str]] = []
    for k, line in enumerate(lines):
        within = [line[start:end].rstrip() for start, end in columns] if k in of_table else []
        texts.append({c: _spelled(cell.strip(), encoding) for c, cell in enumerate(within) if cell})
    widths = [max((len(row[c]) for row in texts if c in row), default=0) for c in range(len(columns))]
    to_right = [
        all(len(lines[k][:end].rstrip()) == end for k in of_table if texts[k].get(c))
        and not all(lines[k][start : start + 1].strip() for k in of_table if texts[k].get(c))
        for c, (start, end) in enumerate(columns)
    ]
    gaps = [start - (columns[c - 1][1] if c else 0) for c, (start, _) in enumerate(columns)]
    new_lines: list[str] = []
    for k, line in enumerate(lines):
        if k == rule and columns:
            indent = len(line) - len(line.lstrip())
            new_lines.append(" " * indent + "-" * (sum(gaps) + sum(widths) - indent))
        elif k in of_table:
            parts = [
                " " * gap + (cell.rjust(width) if right else cell.ljust(width))
                for gap, width, right, cell in zip(
                    gaps,
                    widths,
                    to_right,
                    (texts[k].get(c, "") for c in range(len(columns))),
                    strict=True,
                )
            ]
            new_lines.append("".join(parts).rstrip())
        else:
            new_lines.append(_spelled(line, encoding))
    return new_lines


def _spelled(line: str, encoding: str) -> str:
    """Return one line, or a piece of one, with every sign of a formula spelled in ASCII."""
    line = _POWER_OF_TEN.sub(lambda m: "e" + "".join(RAISED[c] for c in m[1]), line)
    line, out, at = _bracketed_arguments(line), "", 0
    while at < len(line):
        character, end = line[at], at + 1
        follows = line[end : end + 1]
        if character in RAISED or character in LOWERED:
            piece, end = _script(line, at, out, encoding)
            out += piece
        elif character == "√":
            piece, end = _root(line, end, encoding)
            out += ("*" if _ends_factor(out) else "") + piece
        elif character in GREEK:
            out += ("*" if _ends_factor(out) and not out.endswith(_ROOT_SIGN) else "") + GREEK[character]
            if follows.isascii() and follows.isalpha():
                out += "_" if character == "Δ" else "*"
            elif character in _FACTORS and follows == "(":
                out += "*"
        elif character in _PARTS:
            out += ("*" if _ends_factor(out) else "") + f"({_fraction(character)})"
            out += "*" if follows == "(" or (follows.isascii() and follows.isalpha()) else ""
        else:
            sign = _sign(character, encoding)
            out += (sign.lstrip() or sign) if out.endswith(" ") else sign
        at = end
    return out


def _bracketed_arguments(line: str) -> str:
    """Return a line with the arguments of its functions in brackets, as far as they can be told."""
    line = _SERIES.sub(lambda m: f"hyp{LOWERED[m[1]]}f{LOWERED[m[2]]}", line)
    line = _MIXED.sub(lambda m: f"({m[1]}+{_fraction(m[2])})", line)
    line = _POWER_OF_FUNCTION.sub(r"\1\3\2", line)
    line = _FUNCTION.sub(lambda m: f"{m[1]}({m[3] or m[4]}){m[2]}", line)
    return _OPEN_FUNCTION.sub(lambda m: ascii(m[0])[1:-1], line)


def _script(line: str, at: int, out: str, encoding: str) -> tuple[str, int]:
    """Return the spelling of the raised or lowered characters at a place, and where they end."""
    table, mark = (RAISED, "^") if line[at] in RAISED else (LOWERED, "_")
    end = at
    while end < len(line) and line[end] in table:
        end += 1
    plain = "".join(table[c] for c in line[at:end])
    if mark == "^" and line[end : end + 1] == "√" and not _ends_factor(out):  # ³√2, not x³√2
        under = _UNDER_ROOT.match(line, end + 1)
        if under is None:
            return ascii(line[at : end + 1])[1:-1], end + 1
        return f"({_spelled(under[0], encoding)})^(1/{plain})", under.end()
    if mark == "^" and plain in ("-", "+") and line[end : end + 1] in tuple(_PARTS):
        plain += _fraction(line[end])
        end += 1
    follows = line[end : end + 1]
    times = "*" if follows and (_is_factor(follows) or (mark == "^" and follows == "(")) else ""
    return mark + _bracketed(_spelled(plain, encoding)) + times, end


def _root(line: str, end: int, encoding: str) -> tuple[str, int]:
    """Return the spelling of a root whose sign ends at a place, and where it ends.

    How far it goes where letters follow each other is not told: its sign is then left, by its code.
    """
    if line[end : end + 1] == "(":
        return "sqrt", end
    under = _UNDER_ROOT.match(line, end)
    if under is None:
        return _ROOT_SIGN, end
    times = "*" if line[under.end() : under.end() + 1] == "(" else ""
    return f"sqrt({_spelled(under[0], encoding)}){times}", under.end()


def _fraction(character: str) -> str:
    return unicodedata.normalize("NFKD", character).replace("\u2044", "/")


def _bracketed(exponent: str) -> str:
    plain = exponent.isdigit() or len(exponent) == 1 or exponent.startswith("(")
    return exponent if plain else f"({exponent})"


def _is_factor(character: str) -> bool:
    """Tell whether a product goes on with this character: r²ω is r^2*omega."""
    return (
        character in GREEK or character in ("√", *_PARTS) or (character.isascii() and character.isalpha())
    )


def _ends_factor(out: str) -> bool:
    return bool(out) and ((out[-1].isascii() and out[-1].isalnum()) or out[-1] == ")")


def _sign(character: str, encoding: str) -> str:
    """Return a character's spelling: by the table, without its accents, by its code; never a `?`."""
    if character in SIGNS:
        return SIGNS[character]
    if "\u2500" <= character <= "\u257f":  # lines of tables
        return {"─": "-", "━": "-", "═": "-", "│": "|", "┃": "|", "║": "|"}.get(character, "+")
    if encodable(character, encoding):
        return character
    bare = unicodedata.normalize("NFKD", LETTERS.get(character, character))
    if "\u0307" in bare or ("\u0308" in bare and bare[0] not in "aeiouAEIOU"):
        return ascii(character)[1:-1]  # a derivative by time, which is not the letter
    bare = "".join(c for c in bare if not unicodedata.combining(c))
    if unicodedata.decomposition(character).startswith("<fraction>"):
        bare = f"({bare.replace(chr(0x2044), '/')})"
    return bare if bare.isascii() and bare else ascii(character)[1:-1]
