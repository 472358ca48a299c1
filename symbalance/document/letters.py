"""The letters of formulas: Greek by name and sign, raised and lowered signs, fonts and accents."""

from __future__ import annotations

from functools import lru_cache

from symbalance.document.wordlists import word_set, words

_LOWER = words("alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho")
_LOWER_END = words("sigma tau upsilon phi chi psi omega")
_UPPER = {
    "Gamma": "Γ", "Delta": "Δ", "Theta": "Θ", "Lambda": "Λ", "Xi": "Ξ", "Pi": "Π", "Sigma": "Σ",
    "Upsilon": "Υ", "Phi": "Φ", "Psi": "Ψ", "Omega": "Ω",
}  # fmt: skip
_VARIANTS = {
    "varphi": "ϕ", "varepsilon": "ϵ", "vartheta": "ϑ", "varrho": "ϱ", "varsigma": "ς", "varpi": "ϖ",
    "varkappa": "ϰ", "ell": "ℓ",
}  # fmt: skip

GREEK_SIGN: dict[str, str] = {
    **{name: chr(0x3B1 + place) for place, name in enumerate(_LOWER)},
    **{name: chr(0x3C3 + place) for place, name in enumerate(_LOWER_END)},
    **_UPPER,
    **_VARIANTS,
}
"""The sign of each letter that has a name: GREEK_SIGN["theta"] == "θ"."""

NAME_OF_SIGN: dict[str, str] = {sign: name for name, sign in GREEK_SIGN.items()}
NAME_OF_SIGN |= {"µ": "mu", "∆": "Delta", "Ω": "Omega"}

RAISED = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁽⁾ⁿⁱ", "0123456789+-()ni", strict=True))
LOWERED = dict(zip("₀₁₂₃₄₅₆₇₈₉ₐₑₒₓₕₖₗₘₙₚₛₜᵢⱼᵣᵤᵥ", "0123456789aeoxhklmnpstijruv", strict=True))

FONTS = word_set(
    "mathrm mathit mathbf mathsf mathtt mathcal mathscr mathbb mathfrak mathnormal boldsymbol bm"
    " symbf symup symit pmb operatorname rm it bf"
)
"""Commands that change a letter's look and not what it is."""

WORDS = word_set("text textrm textit textbf mbox textnormal hbox textsf textup")
"""Commands whose argument is prose; in a subscript it is the subscript."""

ACCENTS = {
    "bar": "bar", "overline": "bar", "hat": "hat", "widehat": "hat", "vec": "vec",
    "overrightarrow": "vec", "tilde": "tilde", "widetilde": "tilde", "underline": "underline",
}  # fmt: skip
"""Accents make another letter: \\bar x is the letter bar_x; a line below marks a phasor."""

TIME_DOTS = {"dot": 1, "ddot": 2, "dddot": 3}

DOTTED = {sign: (letter, 1) for sign, letter in zip("ẋẏżṙṡṗṁṅḣḟėȧċġẇ", "xyzrspmnhfeacgw", strict=True)}
DOTTED |= {sign: (letter, 2) for sign, letter in zip("ẍÿẅẗöüä", "xywtoua", strict=True)}

FUNCTION_WORDS: dict[str, str] = {
    **{name: name for name in words("sin cos tan cot sec csc sinh cosh tanh exp ln log abs sqrt")},
    "cosec": "csc", "arcsin": "asin", "arccos": "acos", "arctan": "atan", "asin": "asin", "acos": "acos",
    "atan": "atan", "arg": "arg",
}  # fmt: skip
"""What a function's name as written means."""


CIRCULAR = word_set("sin cos tan cot sec csc sinh cosh tanh")
"""Functions that take their argument without brackets and their power before it."""


def is_greek(name: str) -> bool:
    """Tell whether a letter is Greek, with or without a subscript; π is a number here.

    >>> is_greek("theta_1"), is_greek("n"), is_greek("pi")
    (True, False, False)
    """
    base = name.rstrip("'").split("_")[0]
    return base in GREEK_SIGN and base not in ("pi", "ell")


# Letters in print -------------------------------------------------------------------------------

SHORT_NAMES: dict[str, str] = {"lam": "lambda"}
"""Names of letters that Python keeps for itself, to the letters they stand for."""

_RAISED_SIGNS = str.maketrans("0123456789+−-()kmnij", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁻⁽⁾ᵏᵐⁿⁱʲ", " ")
_LOWERED_SIGNS = str.maketrans(
    "0123456789+−-()aehijklmnoprstuvx", "₀₁₂₃₄₅₆₇₈₉₊₋₋₍₎ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ", " "
)


def raised(printed: str) -> str:
    """Return text as a superscript; with a caret where Unicode lacks a sign of it.

    >>> raised("2m − 1"), raised("θ"), raised("2θ")
    ('²ᵐ⁻¹', '^θ', '^(2θ)')
    """
    shifted = _shifted(printed, _RAISED_SIGNS)
    return shifted or f"^{printed if len(printed) == 1 else f'({printed})'}"


def lowered(printed: str) -> str:
    """Return text as a subscript; after an underscore where Unicode lacks a sign of it.

    >>> lowered("2k"), lowered("rec"), lowered("k+y")
    ('₂ₖ', '_rec', '_(k+y)')
    """
    shifted = _shifted(printed, _LOWERED_SIGNS)
    return shifted or f"_{printed if printed.isalnum() else f'({printed})'}"


def _shifted(printed: str, table: dict[int, int | None]) -> str | None:
    return printed.translate(table) if all(ord(sign) in table for sign in printed) else None


def _parts(name: str) -> tuple[str, str, str]:
    """Return a name's letter, its subscript and its primes."""
    bare = name.rstrip("'")
    base, _, subscript = bare.partition("_")
    return base, subscript, name[len(bare) :]


def letter_parts(name: str) -> tuple[str, str, str, str]:
    """Return a letter's accent, its sign, its subscript and its primes.

    >>> letter_parts("bar_x_1'"), letter_parts("omega_rho"), letter_parts("lam")
    (('bar', 'x', '1', "'"), ('', 'ω', 'ρ', ''), ('', 'λ', '', ''))
    """
    base, subscript, primes = _parts(SHORT_NAMES.get(name, name))
    accent = ""
    if base in _ACCENT_SIGNS and subscript:
        accent = base
        base, _, subscript = subscript.partition("_")
    return accent, GREEK_SIGN.get(base, base), GREEK_SIGN.get(subscript, subscript), primes


def plain_letter(name: str) -> str:
    """Return a letter as plain text that reads back as the same letter.

    >>> plain_letter("theta"), plain_letter("m_rec"), plain_letter("omega_1'")
    ('θ', 'm_rec', "ω_1'")
    """
    base, subscript, primes = _parts(name)
    if not subscript:
        return GREEK_SIGN.get(base, base) + primes
    plain = subscript.isascii() and subscript.replace("_", "").isalnum()
    script = subscript if plain else f"{{{subscript}}}"
    return f"{GREEK_SIGN.get(base, base)}_{script}{primes}"


@lru_cache(maxsize=1024)
def text_letter(name: str) -> str:
    """Return a letter as Unicode text.

    >>> text_letter("lam"), text_letter("m_1"), text_letter("m_rec"), text_letter("Delta x")
    ('λ', 'm₁', 'm_rec', 'Δx')
    """
    if " " in name:
        return "".join(map(text_letter, name.split()))
    accent, base, script, primes = letter_parts(name)
    return base + _ACCENT_SIGNS.get(accent, "") + (lowered(script) if script else "") + primes


@lru_cache(maxsize=1024)
def latex_letter(name: str) -> str:
    r"""Return a letter as LaTeX that reads back as the same letter.

    >>> latex_letter("m_1"), latex_letter("Lh"), latex_letter("bar_x'"), latex_letter("lam")
    ('m_{1}', '\\mathit{Lh}', "\\bar{x}'", '\\lambda')
    """
    if len(name) == 1:
        return name
    if " " in name:
        return " ".join(map(latex_letter, name.split()))
    base, subscript, primes = _parts(SHORT_NAMES.get(name, name))
    if base in _ACCENT_SIGNS and subscript:
        inner, _, script = subscript.partition("_")
        return (
            f"\\{base}{{{_latex_base(inner)}}}"
            + (f"_{{{_latex_script(script)}}}" if script else "")
            + primes
        )
    return _latex_base(base) + (f"_{{{_latex_script(subscript)}}}" if subscript else "") + primes


_ACCENT_SIGNS = {
    "bar": "\u0304",
    "hat": "\u0302",
    "vec": "\u20d7",
    "tilde": "\u0303",
    "underline": "\u0332",
}
_ACCENT_SIGNS |= {"dot": "\u0307", "ddot": "\u0308", "dddot": "\u20db"}


def _latex_base(base: str) -> str:
    if base in GREEK_SIGN:
        return f"\\{base}"
    return base if len(base) == 1 else f"\\mathit{{{base}}}"


def _latex_script(subscript: str) -> str:
    if subscript in GREEK_SIGN:
        return f"\\{subscript}"
    return f"\\mathrm{{{subscript}}}" if len(subscript) > 1 and subscript.isalpha() else subscript
