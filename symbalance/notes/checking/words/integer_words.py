"""Words by which a page says that a letter is a whole number: "every integer k", k ∈ ℤ, k = 1, 2, …."""

from __future__ import annotations

import re
from collections.abc import Collection

from symbalance.document.letters import plain_letter

_WORDS = (
    r"(?:integers?|whole\s+numbers?|natural\s+numbers?|ganze[nrms]?\s+Zahl(?:en)?|ganzzahlige[nrms]?"
    r"|natürliche[nrms]?\s+Zahl(?:en)?|entiers?|整数|自然数)"
)
_BLANK = r"[\s$~]{0,4}"
_OTHERS = r"(?:[A-Za-z]\s*[,$]+\s*(?:and|und|et)?[\s$]*){0,3}"
_SETS = r"(?:∈|\\in(?![a-z]))\s*\{?\s*(?:\\mathbb\s*\{?\s*[ZN]|\\bb\s*[ZN]|[ℤℕ]|Z(?![a-z])|N(?![a-z]))"
_RUN = r"=\s*(?:0\s*,\s*)?1\s*,\s*2\s*,(?:\s*3\s*,)?\s*(?:\\[lc]?dots|\\ldots|…|\.\.\.)"


def integers_said(text: str, letters: Collection[str]) -> frozenset[str]:
    """Return the letters that a text says to be whole numbers, as orders of harmonics are.

    >>> sorted(integers_said("for every integer $k$, and $m ∈ ℤ$; n = 1, 2, 3, …", "kmnp"))
    ['k', 'm', 'n']
    """
    return frozenset(name for name in letters if _is_said(text, re.escape(plain_letter(name))))


def _is_said(text: str, letter: str) -> bool:
    own = rf"(?<![A-Za-z\\_]){letter}(?![A-Za-z0-9_])"
    before = rf"{_WORDS}{_BLANK}{_OTHERS}{own}"
    article = r"(?:(?:is|are|ist|sind|being)\s+)?(?:(?:an?|eine?)\s+)?(?:positive\s+)?"
    behind = rf"{own}{_BLANK}{article}{_WORDS}"
    return any(
        re.search(pattern, text) for pattern in (before, behind, rf"{own}\s*{_SETS}", rf"{own}\s*{_RUN}")
    )
