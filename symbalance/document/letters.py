"""The letters of formulas: Greek by name and sign, raised and lowered signs, fonts and accents."""

from __future__ import annotations

from symbalance.document.wordlists import listed, word_set

_LOWER = listed("alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho")
_LOWER_END = listed("sigma tau upsilon phi chi psi omega")
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
    "overrightarrow": "vec", "tilde": "tilde", "widetilde": "tilde",
}  # fmt: skip
"""Accents make another letter: \\bar x is the letter bar_x."""

TIME_DOTS = {"dot": 1, "ddot": 2, "dddot": 3}

DOTTED = {sign: (letter, 1) for sign, letter in zip("ẋẏżṙṡṗṁṅḣḟėȧċġẇ", "xyzrspmnhfeacgw", strict=True)}
DOTTED |= {sign: (letter, 2) for sign, letter in zip("ẍÿẅẗöüä", "xywtoua", strict=True)}

FUNCTION_WORDS: dict[str, str] = {
    **{name: name for name in listed("sin cos tan cot sec csc sinh cosh tanh exp ln log abs sqrt")},
    "cosec": "csc", "arcsin": "asin", "arccos": "acos", "arctan": "atan", "asin": "asin", "acos": "acos",
    "atan": "atan",
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
