"""Rolling bearings: the rating life by the load rating C and the load P, with its exponent."""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Formula, number
from symbalance.notes.checking.meant.catalogue.roles import Quantity, letters, turn_rate, words
from symbalance.notes.checking.meant.catalogue.shaft_roles import bearing_load, load_rating

_LIFE = words(
    r"(?:basic |nominal |rating |rated "
    r"|bearing )*\blife(?:time)?\b", r"\w*lebensdauer", r"(?:定格|基本定格)?寿命",
    r"durée (?:de|of) vie", r"\bdurata\b", r"\bvida\b(?: útil"
    r"| nominal)?", r"\blevensduur", r"trwałość", r"životnost",
)  # fmt: skip
_BALL = words(
    r"\bball bearings?|\bball\b|kugellagers?|rillenkugel\w*|玉軸受"
    r"|(?:roulements?|bearings?) (?:à|at) billes"
    r"|\b(?:a|at) sfere|(?:de|of) bolas"
    r"|kogellagers?|kulkowe\w*|kuličkov\w*"
)
_ROLLER = words(
    r"roller bearings?|\brollers?\b|needle bearings?|rollenlagers?|\w+rollenlagers?|nadellagers?|ころ軸受"
    r"|(?:roulements?|bearings?) (?:à|at) (?:rouleaux|aiguilles)|\b(?:a|at) rulli|(?:de|of) rodillos"
    r"|rolko?lagers?|wałeczkow\w*|válečkov\w*"
)
_LETTERS = letters("L L_10 L_h L_10h L_n")
_OTHER = r"adjusted|modified|reliab|a_1|erweitert|modifiziert|补正|補正|fatigue load|notch"


def _lives(exponent: Fraction) -> tuple[Formula, ...]:
    """Return the life in millions of turns, and in hours at a speed, for an exponent."""
    million = (load_rating / bearing_load) ** exponent
    return million, number(10) ** Fraction(6) * million / (60 * turn_rate)


_THREE, _TEN_THIRDS = Fraction(3), Fraction(10, 3)
_WRONG = tuple(Fraction(n) for n in (1, 2, 4, -3))
BEARINGS: tuple[Quantity, ...] = (
    Quantity(
        "rating life of a ball bearing", _LETTERS, _LIFE, _lives(_THREE), ("power",),
        mistakes=(*_lives(_TEN_THIRDS), *(node for n in _WRONG for node in _lives(n))),
        only=_BALL, unless=words(_ROLLER.pattern, _OTHER), is_told_once=True,
    ),
    Quantity(
        "rating life of a roller bearing", _LETTERS, _LIFE, _lives(_TEN_THIRDS), ("power",),
        mistakes=(*_lives(_THREE), *(node for n in _WRONG for node in _lives(n))),
        only=_ROLLER, unless=words(_BALL.pattern, _OTHER), is_told_once=True,
    ),
)  # fmt: skip
