"""Masses of rings and discs by their moments of inertia: m = J/R² of a ring, m = 2J/R² of a disc.

The two formulas differ by a factor that nobody sees in the letters, and the sentence names the body.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Formula, Name, Negative, Number, Power, Product, Quotient
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

_RING = re.compile(
    r"(?<![A-Za-z])(?:(?<!piston )(?<!slip )(?<!half )rings?|rims?|hoops?"
    r"|(?:Rad|Schwungrad)?kranz(?:es)?|anell[oi]|anneaux?|jantes?|anillos?|llantas?|an[eé](?:l|is)"
    r"|krans(?:en)?|pier[sś]cie[nń](?:ia)?|wien(?:iec|ca)|prsten(?:ec|ce)|v[eě]n(?:ec|ce))(?![^\W\d_])|円環|リム",
    re.IGNORECASE,
)
_DISC = re.compile(
    r"(?<![A-Za-z])(?:dis[ck]s?|solid\s+cylinders?|Scheiben?|Vollzylinders?|dis[ck]os?|dischi|disques?"
    r"|schij(?:f|ven)|skiv(?:a|an|or)|tarcz[ay]?|kotou[cč]e?)(?![^\W\d_])|円板|円盤",
    re.IGNORECASE,
)
_OTHERS = re.compile(
    r"thick|annular|hollow|hohl|inner|outer|spoke|speich|half|halb(?!messer)|厚|diameter|spess[oi]|cav[oi]"
    r"|forat[oi]|épais|creux|gruesos?|huecos?|dik(?:ke)?\b|ihålig|tjock|grub[ya]|wydrąż|dut[ýá]|tlust"
    r"|espess[oa]|oc[oa]\b|mezz[oi]|demi-",
    re.IGNORECASE,
)
_SENTENCE = re.compile(r"[.;!?]\s|[。；]|\n\s*\n")
_REACH = 200
_INERTIAS = frozenset(("J", "I", "Theta"))
_RADII = frozenset(("r", "R"))
_MASSES = frozenset(("m", "M"))


def decide_ring_or_disc(chain: Chain, k: int, document: ReadNotes) -> Decision | None:
    """Return that a mass is that of a disc where a ring is named, or the other way round; else None."""
    head, factor = chain.sides[0].node, _factor(chain.sides[1].node)
    if k or not isinstance(head, Name) or _stem(head) not in _MASSES or factor is None:
        return None
    text = document.text
    words = _SENTENCE.split(text[max(0, chain.start - _REACH) : chain.start])[-1]
    words = _behind_other_formula(words, head, chain, document)
    is_ring, is_disc = _RING.search(words) is not None, _DISC.search(words) is not None
    if is_ring == is_disc or _OTHERS.search(words):
        return None
    name, expected = ("ring", Fraction(1)) if is_ring else ("disc", Fraction(2))
    if factor not in (1, 2, Fraction(1, 2)) or factor == expected:
        return None
    times = "" if expected == 1 else f"{expected} "
    reason = f"the moment of inertia over the radius squared, times {expected}, is the mass of a {name}"
    return Decision(REFUTED, reason, witness={"left": f"{times}J/R²", "right": f"{factor} J/R²"})


def _behind_other_formula(words: str, head: Name, chain: Chain, document: ReadNotes) -> str:
    """Return what stands behind the last formula that the same sentence has for the letter.

    "A disc has m = 2J/R² = 29 kg, while a thin ring would have m = …" speaks of a ring where it ends.
    """
    start = chain.start - len(words)
    ends = [c.end for c in document.chains if c.sides[0].node == head and start <= c.start < chain.start]
    return document.text[max(ends) : chain.start] if ends else words


def _is_square_of_radius(node: Formula) -> bool:
    if not isinstance(node, Power) or node.exponent != Number(Fraction(2)):
        return False
    return isinstance(node.base, Name) and _stem(node.base) in _RADII


def _factor(node: Formula) -> Fraction | None:
    """Return the factor of J/R² in a formula; None for any other."""
    if isinstance(node, Product):
        numbers = [part.value for part in node.factors if isinstance(part, Number)]
        rest = [part for part in node.factors if not isinstance(part, Number)]
        quotients = [part for part in rest if isinstance(part, Quotient)]
        if len(numbers) == 1 and len(rest) == len(quotients) == 1:
            inner = _factor(quotients[0])
            return None if inner is None else numbers[0] * inner
        return None
    if not isinstance(node, Quotient) or isinstance(node, Negative):
        return None
    if not _is_square_of_radius(node.denominator):
        return None
    above = node.numerator
    parts = above.factors if isinstance(above, Product) else (above,)
    letters = [part for part in parts if isinstance(part, Name)]
    numbers = [part.value for part in parts if isinstance(part, Number)]
    is_inertia = len(letters) == 1 and _stem(letters[0]) in _INERTIAS
    if not is_inertia or len(letters) + len(numbers) != len(parts) or len(numbers) > 1:
        return None
    return numbers[0] if numbers else Fraction(1)


def _stem(letter: Name) -> str:
    return letter.name.partition("_")[0]
