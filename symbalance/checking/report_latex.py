"""The report as LaTeX: every equation with its verdict, corrected lines beside the wrong ones."""

from __future__ import annotations

from symbalance.checking.report_text import summary, verdict_words, witness_text
from symbalance.checking.verdicts import Checked, Verdict
from symbalance.reading import render_latex

_HEAD = r"""\documentclass[a4paper,10pt]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{lmodern}
\usepackage{amsmath}
\usepackage{booktabs}
\usepackage{longtable}
\usepackage[margin=18mm]{geometry}
\setlength{\parindent}{0pt}
\begin{document}
"""
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


def report_latex(checked: Checked) -> str:
    """Return a document that compiles with pdflatex: amsmath, booktabs and longtable only."""
    parts = [_HEAD, rf"\section*{{{escaped(checked.document.name)}}}", "\n"]
    parts += [_entry(checked, verdict) for verdict in checked.verdicts]
    parts += [r"\medskip\hrule\medskip", "\n", escaped(summary(checked)), "\n", r"\end{document}", "\n"]
    return "".join(parts)


def _entry(checked: Checked, verdict: Verdict) -> str:
    place = f"{verdict.line}" if verdict.link == 1 else f"{verdict.line}.{verdict.link}"
    head = rf"\textbf{{{place}}}\quad {_words(verdict)}\\" + "\n"
    body = rf"{{\small\ttfamily\raggedright {_source(verdict)}\par}}" + "\n"
    lines = [_note(f"claims to be: {verdict.bind}")] if verdict.bind else []
    lines += [_note(verdict.reason)] if verdict.reason else []
    if verdict.is_bad and verdict.witness:
        lines.append(_note(f"witness: {witness_text(verdict)}"))
    if verdict.fix:
        lines.append(_note(f"found: {verdict.fix.kind}; it should read"))
        lines.append(displayed(render_latex(verdict.fix.node)))
    return r"\begin{samepage}" + head + body + "".join(lines) + r"\end{samepage}\medskip" + "\n\n"


def _words(verdict: Verdict) -> str:
    words = escaped(verdict_words(verdict))
    return rf"\fbox{{\textsc{{{words.lower()}}}}}" if verdict.is_bad else rf"\textit{{{words}}}"


def displayed(formula: str) -> str:
    """Return a formula on its own line, made to fit if it is wide."""
    return rf"\[\begin{{gathered}}{formula}\end{{gathered}}\]" + "\n"


def _source(verdict: Verdict) -> str:
    joined = " ".join(verdict.source.split())
    return escaped(joined if len(joined) <= 600 else joined[:599] + "...")


def _note(text: str) -> str:
    return rf"{{\small {escaped(text)}\par}}" + "\n"


def escaped(text: str) -> str:
    """Return text as LaTeX prints it; characters its standard fonts lack become their names.

    >>> escaped("50 % of s_1")
    '50 \\\\% of s\\\\_1'
    """
    return "".join(_SPECIAL.get(c, c if c.isascii() else _letter(c)) for c in text)


def _letter(character: str) -> str:
    import unicodedata

    known = {
        "≈": r"$\approx$",
        "≥": r"$\geq$",
        "≤": r"$\leq$",
        "·": r"$\cdot$",
        "−": "--",
        "²": r"\textsuperscript{2}",
        "√": r"$\surd$",
        "…": "...",
    }
    if character in known:
        return known[character]
    name = unicodedata.name(character, "")
    if name.startswith("GREEK SMALL LETTER "):
        letter = name.removeprefix("GREEK SMALL LETTER ").lower().replace("lamda", "lambda")
        return rf"$\{letter}$" if letter.isalpha() and letter != "omicron" else "?"
    return "?" if character.isprintable() else " "
