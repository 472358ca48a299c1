"""Words that name an order which is not that of the formula behind them.

"Up to 2nd order", "bis zur 2. Ordnung" and "2次まで" say how far a series is taken: the amplitude that
stands next may be the first order's. So may that of a letter which only helps to write the formula: the
second-order force is, with F_0 = m r ω², ….
"""

from __future__ import annotations

from symbalance.text import lazy_patterns as re

_ACCURACY = re.compile(
    r"(?<![^\W\d_])(?:(?:accurate|correct|exact|right|expanded|developed|good)\s(?:only\s)?to\s"
    r"|(?<!add\s)(?<!adds\s)(?<!sum\s)(?<!sums\s)(?<!adding\s)up\sto\s|through\s"
    r"|beyond\s|above\sthe\s|higher\sthan\s|bis\s|oberhalb\s|jusqu['’]|au-delà\s|hasta\s|fino\sa|oltre\s|até\s|tot\s)"
    r"[^.,;:()\n]{0,34}(?:\.[^.,;:()\n]{0,3})?"
    r"(?<=[\s.'’])(?:orders?|ordnung(?:en)?|ordre|orden|ordine|ordem|orde)(?![^\W\d_])(?:\s(?:[0-9]|I{1,3}V?)(?![0-9]))?"
    r"|[0-9０-９一二三四五六]\s?次(?:の?項|の?成分|の?オーダー)?(?:まで|以上|以下|より)",
    re.IGNORECASE,
)


_AID = re.compile(r"(?<![^\W\d_])(?:with|mit|avec|con|com|met|med)[\s$\\(\[`]*$", re.IGNORECASE)


def introduces_aid(words: str) -> bool:
    """Tell whether the letter behind words only helps to write what they speak of.

    >>> introduces_aid("The second-order force is, with $")
    True
    >>> introduces_aid("together with the second-order force $")
    False
    """
    return _AID.search(words) is not None


def without_accuracies(words: str) -> str:
    """Return words without those that say how far a series is taken.

    >>> without_accuracies("the acceleration (up to 2nd order) gives the first-order force")
    'the acceleration ( ) gives the first-order force'
    >>> without_accuracies("die Kraft zweiter Ordnung")
    'die Kraft zweiter Ordnung'
    """
    return _ACCURACY.sub(" ", words)
