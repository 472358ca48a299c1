r"""The letter \Sigma where it stands for a sum: \Sigma F_I = 0 and \Sigma\cos\alpha_i = 0 become sums.

On a page where the letter stands by itself anywhere, `\Sigma = 4 m r`, or is declared, it is a letter.
"""

from __future__ import annotations

from collections.abc import Callable

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_SIGMA = re.compile(r"\\Sigma(?![A-Za-z])")
_SUMMAND = re.compile(
    r"(?:_\s*\{\s*[a-z]\s*=[^{}\n]{1,20}\}(?:\s*\^\s*(?:\w|\{[^{}\n]{1,12}\}))?)?"
    r"(?:\s|\\[,;:! ]|~|\{\})*(?:[A-Za-z|(\[]|\\(?:left|big|vec|bar|overline|mathbf|d?frac|sin|cos|tan"
    r"|alpha|beta|gamma|delta|phi|varphi|psi|theta|vartheta|omega|lambda|mu|nu|rho|tau)(?![A-Za-z]))"
)
"""What is summed: a letter, a bracket, a function."""


def with_sigma_sums(text: str, is_letter: Callable[[str, int], bool]) -> Rewritten | None:
    r"""Return a text with \sum for such a \Sigma, None where there are none.

    >>> with_sigma_sums(r"$\Sigma F_I = 0$", lambda name, line: False).text
    '$\\sum F_I = 0$'
    >>> with_sigma_sums(r"$\Sigma F_I = \Sigma$", lambda name, line: False) is None
    True
    """
    places = [match.span() for match in _SIGMA.finditer(text)]
    if not places or not all(_SUMMAND.match(text, end) for _, end in places):
        return None
    if any(is_letter("Sigma", text.count("\n", 0, start) + 1) for start, _ in places):
        return None
    rewriter = Rewriter(text)
    for start, end in places:
        rewriter.replace(start, end, "\\sum")
    return rewriter.finish()
