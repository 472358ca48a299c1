"""Moments of inertia about parallel axes: J_S = J_A - m a² about the centre of gravity, J_A = J_S + m a².

About the centre of gravity it is smallest. Words beside the two letters, or their subscripts, say which
of them is meant about it; where both are, as of a web and of the whole crank, nothing is said.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Formula, Name, Negative, Number, Power, Product, Sum
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.meant.letter_roles import index_of, sign_of, stem_of
from symbalance.notes.checking.meant.meant_words import NOBODY
from symbalance.notes.checking.words.glossary import glossary_of
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

_INERTIAS, _MASSES = frozenset(("J", "I", "Theta")), frozenset(("m", "M"))
_LENGTHS = frozenset("adehrsclLbxRkz") | {"ell"}
_CENTRE = (
    r"(?:cent(?:re|er)\s+of\s+(?:gravity|mass)|mass\s+cent(?:re|er)|centroid\w*|schwerpunkt\w*|baricentro"
    r"|barycentre|centro\s+(?:di|de)\s+(?:massa|masa|gravità|gravedad)|重心|質量中心)"
)
_OTHER = (
    r"(?:(?:big|small|large)[- ]end|(?:crank|piston|gudgeon|wrist)?[- ]?pin\b|pivot"
    r"|point\s+of\s+(?:support"
    r"|suspension)|axis\s+of\s+(?:rotation|the\s+pin)|crank\s+cent(?:re|er)|drehpunkt\w*|drehachse|\w*auge[sn]?\b"
    r"|\w*bolzens?\b|\w*zapfens?\b|aufhängepunkt|支点|回転軸|ピン|大端|小端|perno|pivote|fulcro|\baxe\b|\basse\b"
    r"|\beje\b|\bpied\b|axis\b(?!\s+through))"
)
_ABOUT = (
    r"(?:about|around|round|through|for|at|um|durch|bezogen\s+auf|bezüglich|für|to\s+the\s+axis|par\s+rapport|by\s+ratio"
    r"|rispetto|respecto|respeto)"
)
_BEFORE = re.compile(
    rf"{_ABOUT}\s[^.;:$=。、]{{0,30}}?(?:(?P<centre>{_CENTRE})|(?P<other>{_OTHER}))[^.;$=。、]{{0,70}}?$"
    rf"|(?:(?P<centre_ja>{_CENTRE})|(?P<other_ja>{_OTHER}))(?:まわり|周り|回り|を通る)"
    r"(?:の慣性モーメント[はが][^。=]{0,70}|[^。$=、]{0,16})$",
    re.IGNORECASE,
)
"""About what a moment of inertia is taken, before its letter: about the pin, by Steiner, J_A."""
_BEHIND = re.compile(
    rf"[\s$)}}]{{0,4}}(?:,\s)?(?:is\s|being\s|the\s|that\s|moment\s|of\s|inertia\s|das\s|celui\s){{0,5}}{_ABOUT}\s"
    rf"[^.,;:$=。、]{{0,24}}?(?:(?P<centre>{_CENTRE})|(?P<other>{_OTHER}))",
    re.IGNORECASE,
)
"""The same behind its letter: J_A about the pivot."""
_CENTRAL = frozenset(("S", "G", "C", "s", "g", "c", "cg", "CG", "cm", "CM", "Sp", "SP"))
"""Subscripts of a moment of inertia about the centre of gravity."""
_OF_PARTS = re.compile(
    r"\bweb|counterweight|both|parts?\b|whole|total|sum\b|removed|\bhole|\bbore|minus\b|together|wange|gegengewicht"
    r"|beide|teile?\b|gesamt|summe|abzüglich|zusammen|付加|合計|全体|\bplus\b|cheek|assembly|composite",
    re.IGNORECASE,
)
"""Words for a body of several parts, or for what is taken out of it."""
_THEOREM = re.compile(r"parallel[- ]ax|steiner|平行軸|huygens", re.IGNORECASE)
_REACH = 160


def decide_parallel_axes(chain: Chain, k: int, document: ReadNotes) -> Decision | None:
    """Return the decision on J_S = J_A - m a², or J_A = J_S + m a²; None for other relations."""
    head = chain.sides[0].node
    parts = _parts(chain.sides[1].node)
    if k or parts is None or not isinstance(head, Name) or stem_of(head.name) not in _INERTIAS:
        return None
    other, is_added = parts
    glossary = glossary_of(document.text)
    own = glossary.english(document.text[max(0, chain.start - _REACH) : chain.start])
    near = glossary.english(document.text[max(0, chain.start - 2 * _REACH) : chain.end + _REACH])
    if head.name == other or _OF_PARTS.search(near):
        return None
    text = glossary.english(document.text)
    of_head = _axis_before(own) or _axis_of(head.name, text)
    of_other = _axis_of(other, text)
    if of_head is None or of_head == of_other:
        return None
    is_central, words = of_head
    if is_central and of_other is None and not _THEOREM.search(near):
        return None  # a web's own, moved to the centre of gravity of the whole
    about = "the centre of gravity" if is_central else "another axis"
    source = f"{NOBODY}; taken from {words}"
    text = f"{plain_letter(head.name)} is the moment of inertia about {about} ({source})"
    if is_central != is_added:
        return Decision(PROVED, assumptions=(text, f"{plain_letter(other)} is that about the other axis"))
    size = "smallest, and less" if is_central else "more"
    than = "about a parallel axis" if is_central else "about the centre of gravity"
    return Decision(REFUTED, f"if {text}: it is {size} than {than}")


def _parts(node: Formula) -> tuple[str, bool] | None:
    """Return the inertia of J ± m a² and whether m a² is added; None for another formula."""
    if not isinstance(node, Sum) or len(node.terms) != 2:
        return None
    inertias = [term.name for term in node.terms if isinstance(term, Name)]
    others = [term for term in node.terms if not isinstance(term, Name)]
    if len(inertias) != 1 or len(others) != 1 or stem_of(inertias[0]) not in _INERTIAS:
        return None
    is_added = not isinstance(others[0], Negative)
    product = others[0].operand if isinstance(others[0], Negative) else others[0]
    match product:
        case Product(factors=(Name(name=mass), Power(base=Name(name=arm), exponent=Number(value=two)))):
            is_shift = stem_of(mass) in _MASSES and stem_of(arm) in _LENGTHS and two == Fraction(2)
            return (inertias[0], is_added) if is_shift else None
    return None


def _axis_before(words: str) -> tuple[bool, str] | None:
    """Return whether the words right before a letter name the centre of gravity, and what says so."""
    match = _BEFORE.search(words)
    if match is None:
        return None
    is_central = (match["centre"] or match["centre_ja"]) is not None
    said = match["centre"] or match["centre_ja"] or match["other"] or match["other_ja"]
    return is_central, f"the words “{said}”"


def _axis_of(letter: str, text: str) -> tuple[bool, str] | None:
    """Return the same of a letter by the words beside it anywhere on a page, or by its subscript."""
    found: set[bool] = set()
    for match in re.finditer(rf"(?<![^\W_])(?<!\\){sign_of(letter)}", text):
        before = _axis_before(text[max(0, match.start() - _REACH // 2) : match.start()].rstrip("$ \\({"))
        behind = _BEHIND.match(text, match.end())
        if behind is not None:
            found.add(behind["centre"] is not None)
        elif before is not None:
            found.add(before[0])
    if len(found) == 1:
        return found.pop(), f"the words beside {plain_letter(letter)}"
    is_central = index_of(letter) in _CENTRAL and not found
    return (True, f"the subscript of {plain_letter(letter)}") if is_central else None
