"""What every LaTeX document of ours is made of: preamble, tables, numbers, text taken literally."""

from __future__ import annotations

from symbalance.document.latex_characters import letter
from symbalance.errors import encodable_name

ROWS_PER_TABLE = 36

_PREAMBLE = r"""\documentclass[a4paper,11pt]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{lmodern}
\usepackage[margin=22mm]{geometry}
\usepackage{amsmath}
\usepackage{booktabs}
\setlength{\parindent}{0pt}
\setlength{\jot}{6pt}
\allowdisplaybreaks
\begin{document}
"""


def in_document(body: str) -> str:
    """Return a complete document around a fragment."""
    return f"{_PREAMBLE}{body.rstrip()}\n\\end{{document}}\n"


def escaped(text: str) -> str:
    r"""Return text with LaTeX's own characters taken literally, others by their command or their code.

    >>> print(escaped("1 % of m r ω²"))
    1 \% of m r \(\omega\)\(^2\)
    """
    return "".join(_ESCAPED.get(c, c if 32 <= ord(c) < 127 else letter(c)) for c in encodable_name(text))


_ESCAPED = {c: f"\\{c}" for c in "&%$#_{}"}
_ESCAPED |= {"\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}"}
_ESCAPED |= {"°": r"\textdegree{}", "–": "--", "…": r"\dots{}"}
_ESCAPED |= {
    c: rf"\({math}\)"
    for c, math in {
        **{"−": "-", "±": r"\pm", "·": r"\cdot", "×": r"\times", "≤": r"\le"},
        **{"λ": r"\lambda", "ψ": r"\psi", "ω": r"\omega", "ₓ": "_x", "²": "^2"},
    }.items()
}


def number(decimal: str) -> str:
    r"""Return a decimal with its power of ten typeset.

    >>> print(number("7.4379e-5"))
    7.4379\cdot 10^{-5}
    """
    mantissa, *exponent = decimal.split("e")
    return mantissa + (rf"\cdot 10^{{{int(exponent[0])}}}" if exponent else "")


def tabulars(columns: str, head: str, lines: list[str], gap: int = 2) -> str:
    """Return tables of at most `ROWS_PER_TABLE` rows, one below the other."""
    chunks = [lines[i : i + ROWS_PER_TABLE] for i in range(0, len(lines), ROWS_PER_TABLE)]
    return "\n".join(
        "\n".join(
            [
                r"\begin{center}",
                rf"\begin{{tabular}}{{@{{}}{columns}@{{}}}}",
                r"\toprule",
                head + r" \\",
                r"\midrule",
                *(rf"{line} \\[{gap}pt]" for line in chunk),
                r"\bottomrule",
                r"\end{tabular}",
                r"\end{center}",
            ]
        )
        for chunk in chunks
    )
