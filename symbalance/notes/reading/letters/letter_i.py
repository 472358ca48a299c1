r"""The letter i of a page that counts by it, the order of a harmonic, told from the imaginary unit.

A page with "harmonic of order $i$", "die Anzahl $i$ der Zylinder", "i cylinders" or i = 2 and without
complex numbers means that letter. On every other page a lone i is the imaginary unit.
"""

from __future__ import annotations

from symbalance.text import lazy_patterns as re

_I = r"(?:\$|\\\()?[ ]{0,2}(?<![A-Za-z0-9\\_^{}.'’])i(?![A-Za-z0-9_^'’(]|\s*\()"
_COUNTED = (
    r"(?:cylinders?|harmonics?|vibrations?|oscillations?|impulses?|pulses?|firings?|cranks?|throws?|teeth|blades?"
    r"|cylindres?|cilindr[oi]s?|cilinders?|harmoniques?|arm[oó]nic(?:os?|he)|impulsions|impulsi|manivelles|manovelle"
    r"|Zylindern?|Schwingungen|Zündungen|Kröpfungen|Impulsen?|Zähnen?|次|気筒|個)"
)
_COUNTS = re.compile(
    r"(?:\b(?:orders?|number|count|ratio|Ordnung(?:szahl)?|Ordnungen|Anzahl|Zahl|Zylinderzahl|Übersetzung"
    r"(?:sverhältnis)?|nombre|numero|número|ordre|ordine|orden|rapport|rapporto|relación|aantal)|次数|気筒数|個数|変速比|減速比)\s*(?:(?:of|de|di|van)\s+(?:(?:the|los|de)\s+)?[a-z]{3,12}\s*)?[はを]?\s*"
    rf"{_I}|{_I}\s*(?:\$|\\\))?(?:\s|-(?:te[rnsm]?|th)\s){_COUNTED}(?![a-z])"
)
_GIVEN = re.compile(rf"{_I}[ ]{{0,2}}&?=[ ]{{0,2}}[0-9]")
"""A number of it, i = 2 for a gear; the imaginary unit has none."""
_COMPLEX = re.compile(
    r"\^\s*\{?\s*[-−+]?\s*(?:\\mathrm\{)?[ij](?![A-Za-z0-9_])|\\(?:mathrm|imath|text|operatorname)\s*\{\s*i\s*\}|\\imath"
    r"|\\exp\s*(?:\\left)?\s*[({]\s*[-−]?\s*i(?![A-Za-z])|(?<![A-Za-z])exp\s*\(\s*[-−]?\s*i(?![A-Za-z])"
    r"|\b(?:imaginary|complex\s+(?:number|plane|amplitude|conjugate|notation)|imaginäre?n?|komplexe?[nr]?"
    r"|imaginaires?|complexes?|immaginari[ao]|compless[oaie]|imaginari[ao]s?|complej[oa]s?)\b|虚数|複素"
    r"|(?<![A-Za-z_])i\s*(?:\^\s*2|²)\s*=\s*[-−]\s*1|\\(?:Re|Im|operatorname\{(?:Re|Im)\})(?![A-Za-z])"
)


def counts_by_i(text: str) -> bool:
    """Tell whether a page counts by the letter i, and has no complex numbers.

    >>> counts_by_i("the harmonic of order $i$"), counts_by_i("order $i$ of $e^{i t}$")
    (True, False)
    """
    is_given = "=" in text and _GIVEN.search(text) is not None
    is_letter = is_given or _COUNTS.search(text) is not None
    return is_letter and _COMPLEX.search(text) is None
