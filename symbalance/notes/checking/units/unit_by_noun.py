"""The unit that the noun right before a letter's value asks for: "the torque is M = 50 N" is no torque.

Only a noun that names one size counts, and only where it is what the letter is: "the torque is M",
"torque M"; a force "on the mass m" says nothing of a force.
"""

from __future__ import annotations

from symbalance.document.formula import Name
from symbalance.notes.checking.units.dimensions import Dimension, unit_of
from symbalance.notes.checking.units.sizes_by_words import unit_by_words
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_VERB = re.compile(
    r"\s+(?:is|are|was|equals|amounts\s+to|becomes|beträgt|ist|wird|vaut|est|è|es)(?:\s+(?:about|then|thus|also|therefore|dann|also|damit|etwa|rund))?$",
    re.IGNORECASE,
)
_CLAUSE = re.compile(
    r"[.,;:!?()]\s|\n\s*\n|(?<![A-Za-z])(?:and|und|et|so|hence|thus|then|with|mit|where|that|dass)\s"
)
_ARTICLE = re.compile(
    r"^(?:(?:the|an?|its|this|der|die|das|den|dem|ein|eine|einer|le|la|les|un|une)\s|l['’])+",
    re.IGNORECASE,
)
_PREPOSITION = re.compile(
    r"(?<![A-Za-z])(?:of|at|on|in|by|to|from|for|per|about|between|an|am|im|der|des|vom|von|zum|beim?|pro|je|de|du|sur)(?![A-Za-z])",
    re.IGNORECASE,
)
_SEVERAL = re.compile(r"(?:(?<![^\W\d_])(?:and|und|et|e|y|with|mit)\s|[,/&])[^.;:!?]*:?$", re.IGNORECASE)
"""In a label that heads more than one size: "piston area and gas force:"."""
_NO_NOUN = re.compile(r"[=≈0-9]|[.,;:!?)。、]\s*$|\n\s*\n")
_MARKS = " \t$\\([{*_'"
MOST_WORDS = 7
"""Of a noun with what it is of: the largest inertia force of one piston."""


_ITEM = re.compile(r"(?:\A|\n)[ \t]*(?:[*+•\-]|\d+[.)]|\\item)[\s*_']*")
"""What an item of a list begins with."""
_WEIGHT = re.compile(r"(?<![A-Za-z])(?:lbs?|lbf|kgf|kp|oz|pounds?|tons?|t|g)(?![A-Za-z/])")
_KILOGRAM = re.compile(r"(?<![A-Za-z])k?g(?![A-Za-z])")


def is_label(sentence: str) -> bool:
    """Tell whether what stands before a relation is a label: "Torque: M = 60 N m"."""
    return sentence.rstrip(_MARKS).endswith(":")


def unit_asked_for(chain: Chain, sentence: str, value: str) -> tuple[str, Dimension] | None:
    """Return the noun before a letter, and the dimension of the size it names; None where it is open.

    `sentence` is the text before the relation, `value` what stands behind it. Pounds are masses and
    forces, and so were kilograms.
    """
    if not isinstance(chain.sides[0].node, Name):
        return None
    before, has_label = _ITEM.split(sentence)[-1].rstrip(_MARKS), is_label(sentence)
    phrase = _CLAUSE.split(before.removesuffix(":") + " ")[-1].strip()
    if _NO_NOUN.search(phrase):
        return None
    bare = _VERB.sub("", phrase)
    has_verb = bare != phrase or has_label  # "Angular velocity: ω = ..." is a sentence without its verb
    noun = _ARTICLE.sub("", bare)
    if has_label and (_PREPOSITION.search(noun) or _SEVERAL.search(before)):
        return None  # "Torque of the force: F = 30 N" may head what the torque is computed from
    if not has_verb and _PREPOSITION.search(noun):
        noun = _ARTICLE.sub("", _PREPOSITION.split(noun)[-1].strip())
    if not noun or len(noun.split()) > MOST_WORDS:
        return None
    unit = unit_by_words(noun)
    dimension = unit_of(unit) if unit and unit != "1" else None
    is_of_force = dimension is not None and bool(dimension[2])
    if dimension is None or _WEIGHT.search(value) or (is_of_force and _KILOGRAM.search(value)):
        return None
    return noun, dimension
