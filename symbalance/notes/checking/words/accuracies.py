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

_NUMBER = (
    r"(?:first|second|third|fourth|fifth|sixth|higher|lowest|next|leading|1st|2nd|3rd|[1-6]th|[1-9])"
)
_THAT_ORDER = (
    rf"\s(?:the\s)?{_NUMBER}(?:\s(?:and|or)\s{_NUMBER})?[\s-]orders?(?![^\W\d_])"
    r"(?!\s(?:force|couple|moment|torque|term|part|comp))"
)
_TO_ORDER = re.compile(rf"(?<![^\W\d_])to{_THAT_ORDER}", re.IGNORECASE)
_AT_ORDER = re.compile(rf"(?<![^\W\d_])(?:to|at|in|au|al){_THAT_ORDER}", re.IGNORECASE)
"""How far a series is taken, where nothing is added to that order: to the second order."""
_ADDED = re.compile(
    r"contribut|belong|\badd|amount|share|part\b|correspond|refer|due|relat|compar|reduc"
    r"|give[sn]? rise|responds?"
    r"|beitr|gehör",
    re.IGNORECASE,
)
_LEFT_OUT = re.compile(
    r"(?<![^\W\d_])(?:neglect(?:ing)?|ignoring?|dropping|omitting|discarding|disregarding"
    r"|leaving out|without"
    r"|(?:unter|bei)\svernachlässigung|vernachlässig(?:t|en)\s(?:man|wir)|ohne|en\snégligeant|sans|trascurando"
    r"|despreciando)\s[^.,;:$]{0,40}?(?:orders?|ordnung(?:en)?|ord(?:re|ini|en)s?|órdenes)(?![^\W\d_])(?:[\s-]terms)?"
    r"|(?:(?:when|if|since|wenn|da|falls)\s)?[^.,;:$]{0,30}?(?:orders?|ordnung(?:en)?)(?![^\W\d_])(?:[\s-](?:terms|glieder))?"
    r"\s(?:(?:are|being|is|werden)\s)?(?:neglected|dropped|ignored|omitted|left out|discarded"
    r"|vernachlässigt|weggelassen)"
    r"|[^、。，,]{0,12}次[^、。，,]{0,8}を(?:無視|省略)",
    re.IGNORECASE,
)
"""What is left out of a series: neglecting higher orders."""
_BOTH = re.compile(
    r"(?:terms\sof\s)?(?:the\s)?\b(?:first|1st)(?:-|\sorder)?\sand\s(?:the\s)?second[\s-]orders?(?:\sterms)?(?:\sonly)?"
    r"|erster\sund\szweiter\sordnung|[一1]次(?:と|および|及び)[二2]次",
    re.IGNORECASE,
)
"""Both orders that a piston's motion has, which is the motion."""


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
    >>> without_accuracies("neglecting higher orders, the acceleration is, to second order, a")
    ' , the acceleration is,  , a'
    >>> without_accuracies("the contribution to the second order is")
    'the contribution to the second order is'
    """
    words = _LEFT_OUT.sub(" ", _ACCURACY.sub(" ", words))
    return words if _ADDED.search(words) else _TO_ORDER.sub(" ", words)


def without_orders_of_series(words: str) -> str:
    """Return words without those that say which orders of a motion a series has, and that is the motion.

    >>> without_orders_of_series("the acceleration with terms of the first and second order only is")
    'the acceleration with   is'
    >>> without_orders_of_series("the acceleration of the second order is")
    'the acceleration of the second order is'
    """
    words = _BOTH.sub(" ", without_accuracies(words))
    return words if _ADDED.search(words) else _AT_ORDER.sub(" ", words)
