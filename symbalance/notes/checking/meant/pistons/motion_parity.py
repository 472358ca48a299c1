"""Which harmonics a motion named by words can have: an inertia torque has sines alone, a way cosines.

Turned backwards from top dead centre a slider-crank without offset is where it is turned forwards, so
that its piston's way, its acceleration and the mass force are even in the crank angle; the velocity and
the torque of the mass forces are odd. Counted from a quarter turn, odd orders have the other function.
A line is refuted where one harmonic of several can stand in neither.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from symbalance.document.formula import Name
from symbalance.notes.checking.deciding.equality import REFUTED, Decision, without_dots
from symbalance.notes.checking.declared.symbol_roles import FROM_MIDDLE, FROM_PIN, FROM_TOP
from symbalance.notes.checking.meant.meant_words import NOBODY, TORQUE
from symbalance.notes.checking.meant.pistons.crank_series import Harmonic
from symbalance.notes.checking.meant.pistons.formula_patterns import FormulaPatterns
from symbalance.notes.checking.meant.pistons.motion_words import HAS_OFFSET
from symbalance.notes.checking.meant.pistons.wave_profiles import harmonics_of, has_waves
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_OTHER = {"cos": "sin", "sin": "cos"}
_FUNCTIONS: Mapping[str, str] = {
    TORQUE: "sin", "piston velocity": "sin", "piston acceleration": "cos", "inertia force": "cos",
    FROM_TOP: "cos", FROM_PIN: "cos", FROM_MIDDLE: "cos",
}  # fmt: skip
_TORQUE = re.compile(
    r"(?:inertia|mass)[- ]torque"
    r"|torque (?:of|from|by|due to|exerted by) the (?:inertia|mass|reciprocating)"
    r"|massen(?:kraft)?(?:dreh)?moment|慣性(?:力による|力の)?トルク",
    re.IGNORECASE,
)
_GAS = re.compile(
    r"\bgas|combustion|verbrennung|ガス|燃焼|total|gesamt|全トルク|friction|reibung", re.IGNORECASE
)
_WORDS = {"sin": "odd in the crank angle: sines alone", "cos": "even in the crank angle: cosines alone"}
_BEHIND = 60


@dataclass
class MotionParity:
    """Judges the harmonics of one page's motions."""

    patterns: FormulaPatterns

    def judge(self, chain: Chain, k: int) -> Decision | None:
        """Return the refutation of a sum of harmonics that the motion named by words cannot have."""
        head, right = chain.sides[k].node, without_dots(chain.sides[k + 1].node)[0]
        is_offset = HAS_OFFSET.search(self.patterns.document.text) is not None
        is_series = not k and not is_offset and isinstance(head, Name) and has_waves(right, 2)
        if not is_series or not isinstance(head, Name) or chain.relations[k].sign not in "=≈":
            return None
        role = self._role(head.name, chain)
        harmonics = harmonics_of(right)
        if not role or len(harmonics) < 2 or self.patterns.is_of_more(chain):
            return None
        function = _FUNCTIONS[role]
        wrong = [h for h in harmonics if h.function != function]
        turned = [h for h in harmonics if h.function != _expected(function, h)]
        may_be_turned = self.patterns.starts_near(chain) != {0}
        if len(wrong) != 1 or (may_be_turned and len(turned) <= 1):
            return None
        (odd_one,) = wrong
        multiple = "" if odd_one.order == 1 else str(odd_one.order)
        reason = (
            f"the {role} of a slider-crank ({NOBODY}; taken from the words) is {_WORDS[function]},"
            f" {_OTHER[odd_one.function]} {multiple}θ and not {odd_one.function} {multiple}θ"
        )
        return Decision(REFUTED, reason)

    def _role(self, name: str, chain: Chain) -> str:
        """Return which motion words name around a relation; "" for none."""
        words = self.patterns.words
        behind = self.patterns.document.text[chain.end : chain.end + _BEHIND].split(".")[0]
        near = f"{words.before(chain)} {behind}"
        if _TORQUE.search(near):
            return "" if _GAS.search(near) else TORQUE
        named = words.named(name, chain)
        return named.role if named is not None and named.role in _FUNCTIONS else ""


def _expected(function: str, harmonic: Harmonic) -> str:
    """Return the function of a harmonic where its angle is counted from a quarter turn."""
    return _OTHER[function] if harmonic.order % 2 else function
