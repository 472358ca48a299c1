"""Letters as lines of prose may write them: θ and \\theta, m_1, m_{1} and m₁."""

from __future__ import annotations

from collections.abc import Iterable

from symbalance.document.letters import GREEK_SIGN, LOWERED, SHORT_NAMES
from symbalance.text import lazy_patterns as re


def letters_pattern(letters: Iterable[str]) -> re.Pattern[str] | None:
    """Return a pattern of the letters as a line of prose may write them."""
    written = sorted({s for name in letters for s in spellings(name)}, key=len, reverse=True)
    if not written:
        return None
    return re.compile(rf"(?<![A-Za-z\\])({'|'.join(map(re.escape, written))})(?![A-Za-z0-9_₀-₉'′])")


def letter_pattern(letter: str) -> re.Pattern[str] | None:
    """Return a pattern of one letter, by its short name too: λ as lam.

    >>> pattern = letter_pattern("lambda")
    >>> pattern is not None and bool(pattern.search("l = rod length, lam = r/l"))
    True
    """
    return letters_pattern([letter, *(word for word, name in SHORT_NAMES.items() if name == letter)])


def spellings(name: str) -> list[str]:
    """Return the ways to write a letter: θ, \\theta; m_1, m_{1}, m₁.

    >>> spellings("m_1")
    ['m_1', 'm_{1}', 'm₁']
    """
    base, _, script = name.partition("_")
    bases = [GREEK_SIGN[base], f"\\{base}"] if base in GREEK_SIGN else [base]
    if not script:
        return bases
    raised = {plain: sign for sign, plain in LOWERED.items()}
    lowered = "".join(raised.get(sign, "?") for sign in script)
    scripts = [f"_{script}", f"_{{{script}}}", *([lowered] if "?" not in lowered else [])]
    return [b + s for b in bases for s in scripts]
