"""Escaping of text for LaTeX: special characters literally, others as the standard fonts have them."""

from __future__ import annotations

import unicodedata

from symbalance.errors import encodable_name

_SPECIAL = {
    "\\": r"\textbackslash{}",
    "{": r"\{",
    "}": r"\}",
    "_": r"\_",
    "^": r"\textasciicircum{}",
    "~": r"\textasciitilde{}",
    "%": r"\%",
    "&": r"\&",
    "#": r"\#",
    "$": r"\$",
}


def escaped(text: str) -> str:
    r"""Return text as LaTeX prints it; a character that its standard fonts lack becomes its code.

    Chinese, Japanese and Korean stay as they are, for lualatex.

    >>> print(escaped("50 % of s_1 √ 度 ☃"))
    50 \% of s\_1 $\surd$ 度 \texttt{U+2603}
    """
    return "".join(_SPECIAL.get(c, c if c.isascii() else letter(c)) for c in encodable_name(text))


_SIGNS = {
    "≈": r"$\approx$",
    "≥": r"$\geq$",
    "≤": r"$\leq$",
    "≠": r"$\neq$",
    "≪": r"$\ll$",
    "≫": r"$\gg$",
    "≡": r"$\equiv$",
    "∝": r"$\propto$",
    "±": r"$\pm$",
    "∓": r"$\mp$",
    "×": r"$\times$",
    "÷": r"$\div$",
    "·": r"$\cdot$",
    "⋅": r"$\cdot$",
    "−": "--",
    "–": "--",
    "—": "---",
    "√": r"$\surd$",
    "∞": r"$\infty$",
    "∂": r"$\partial$",
    "∫": r"$\int$",
    "∑": r"$\sum$",
    "→": r"$\to$",
    "⇒": r"$\Rightarrow$",
    "∴": r"$\Rightarrow$",
    "°": r"$^{\circ}$",
    "′": r"$'$",
    "½": r"$\frac12$",
    "¼": r"$\frac14$",
    "…": "...",
    "⋯": "...",
    "\u00a0": " ",
    "\u2009": " ",
    "\u202f": " ",
    "≃": r"$\simeq$",
    "ϕ": r"$\phi$",
    "ϑ": r"$\vartheta$",
    "ϵ": r"$\epsilon$",
    "ϱ": r"$\varrho$",
    "ϖ": r"$\varpi$",
    "∈": r"$\in$",
    "∼": r"$\sim$",
    "─": "--",
    "Å": r"\AA{}",
    "µ": r"$\mu$",
    "‐": "-",
    "‑": "-",
    "‘": "`",
    "’": "'",
    "“": "``",
    "”": "''",
}


def east_asian(text: str) -> list[str]:
    """Return the Chinese, Japanese and Korean characters of a text, each once, in order.

    >>> east_asian("角度 of 度 and θ")
    ['度', '角']
    """
    return sorted(set(filter(_is_east_asian, text)))


def _is_east_asian(character: str) -> bool:
    return (
        character > "\u2e7f"
        and unicodedata.east_asian_width(character) in "WF"
        and character < "\U0001f000"
    )


def letter(character: str) -> str:
    """Return a character beyond ASCII as LaTeX prints it; by its code where it cannot."""
    if character in _SIGNS:
        return _SIGNS[character]
    name = unicodedata.name(character, "")
    if known := _greek(name) or _script(character):
        return known
    if (name.startswith("LATIN ") and character <= "\u00ff") or _is_east_asian(character):
        return character
    return rf"\texttt{{U+{ord(character):04X}}}"


def _script(character: str) -> str:
    """Return a raised or lowered character, empty for any other."""
    kind, _, code = unicodedata.decomposition(character).partition(" ")
    if kind not in ("<super>", "<sub>") or " " in code:
        return ""
    line = chr(int(code, 16)).replace("−", "-")
    return rf"${'^' if kind == '<super>' else '_'}{{{line}}}$" if line.isascii() else ""


def _greek(name: str) -> str:
    """Return the letter of a Unicode name, such as GREEK SMALL LETTER THETA; empty for any other."""
    size, _, letter = name.removeprefix("GREEK ").partition(" LETTER ")
    letter = letter.lower().replace("lamda", "lambda")
    if name.startswith("GREEK ") and size == "SMALL" and letter.isalpha() and letter not in _LATIN:
        return rf"$\{letter}$"
    if name.startswith("GREEK ") and letter in _CAPITALS:
        return rf"$\{letter.capitalize()}$"
    return ""


_LATIN = ("omicron", "stigma", "digamma", "koppa", "sampi", "sho", "san", "heta")
"""Small letters LaTeX has no name for."""
_CAPITALS = ("gamma", "delta", "theta", "lambda", "xi", "pi", "sigma", "upsilon", "phi", "psi", "omega")
