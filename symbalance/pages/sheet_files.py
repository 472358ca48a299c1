"""Sheets as files: SVG, LaTeX with TikZ, and PDF by the TeX that is installed."""

from __future__ import annotations

import os
import re
import subprocess
from collections.abc import Sequence
from pathlib import Path
from shutil import which
from tempfile import TemporaryDirectory

from symbalance.document.latex_characters import east_asian
from symbalance.document.latex_document import character_settings
from symbalance.document.shapes import Drawing
from symbalance.document.tikz_writer import drawing_tikz
from symbalance.errors import MissingPartError, SymbalanceError, brief

SLOWEST = 120.0
"""Seconds that TeX may take: a page takes two, and a first run of lualatex a minute for its fonts."""

_HEAD = r"""\documentclass[10pt]{article}
\usepackage[a4paper,margin=0pt,nohead,nofoot]{geometry}
\usepackage{tikz}
"""
EAST_ASIAN = r"""\usepackage{iftex}
\iftutex
  \IfFileExists{luatexja.sty}{\usepackage{luatexja}}{%
    \PackageError{symbalance}{East Asian characters need luatexja (texlive-lang-japanese)}{}\stop}
\else
  \PackageError{symbalance}{East Asian characters need lualatex with luatexja}{}
  \expandafter\stop
\fi
"""
"""A sheet is a picture of its words: codes in their place, as a table may have them, are of no use."""
_DEBIAN = {"luatexja": "texlive-lang-japanese", "tikz.sty": "texlive-pictures"}
"""What a TeX may come without, and Debian's package that has it."""
_BEGIN = r"""\pagestyle{empty}
\setlength{\parindent}{0pt}
\setlength{\parskip}{0pt}
\setlength{\topskip}{0pt}
\renewcommand{\familydefault}{\sfdefault}
\begin{document}
"""


def sheets_latex(drawings: Sequence[Drawing]) -> str:
    """Return sheets as a LaTeX document, a page each."""
    # A hair less than the page: rounding must not call for a second one.
    pages = "\\newpage\n".join(drawing_tikz(each, scale=0.9985) for each in drawings)
    settings = EAST_ASIAN if east_asian(pages) else character_settings(pages)
    return _HEAD + settings + _BEGIN + pages + "\\end{document}\n"


def sheets_pdf(drawings: Sequence[Drawing]) -> bytes:
    """Return sheets as a PDF by pdflatex, or by lualatex, which East Asian signs need.

    Refused where neither is installed, and where TeX stops, with its own words.
    """
    source = sheets_latex(drawings)
    signs = east_asian(source)
    programs = ("lualatex",) if signs else ("pdflatex", "lualatex")
    program = next((path for name in programs if (path := which(name))), None)
    if program is None:
        rule = f"{' or '.join(programs)} is not installed" + (", for East Asian signs" if signs else "")
        remedy = "write .tex or .svg, or apt-get install texlive-latex-extra texlive-pictures"
        raise MissingPartError(".pdf", rule, remedy + (" texlive-lang-japanese" if signs else ""))
    with TemporaryDirectory() as folder:
        (Path(folder) / "sheet.tex").write_text(source, encoding="utf-8")
        command = [program, "-interaction=nonstopmode", "-halt-on-error", "-no-shell-escape", "sheet.tex"]
        try:
            done = subprocess.run(
                command,
                cwd=folder,
                capture_output=True,
                timeout=SLOWEST,
                check=False,
                stdin=subprocess.DEVNULL,
                env={**os.environ, "max_print_line": "1000"},  # a message is a line
            )
        except subprocess.TimeoutExpired:
            rule = f"has not ended within {SLOWEST:g} s"
            raise SymbalanceError(Path(program).name, rule, "write .tex and see what it says") from None
        pdf = Path(folder) / "sheet.pdf"
        if done.returncode or not pdf.is_file():
            log = done.stdout.decode("utf-8", "replace")
            said = re.search(r"^! (.*)", log, re.MULTILINE)
            words = said[1].removeprefix("Package symbalance Error: ") if said else ""
            rule = f"stopped: {brief(words) if words else 'without a message'}"
            for part, package in _DEBIAN.items():
                if part in words:
                    remedy = f"apt-get install {package}, or write .svg"
                    raise MissingPartError(Path(program).name, rule, remedy)
            raise SymbalanceError(Path(program).name, rule, "write .tex or .svg instead")
        return pdf.read_bytes()
