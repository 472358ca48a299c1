r"""A bar over a formula of the crank angle is its mean over a turn: \overline{\sin^2\varphi} = 1/2.

Elsewhere a bar is the complex conjugate. On a page without i there is none, and what is under the bar is
real: so is a square, v², where words call it a mean.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Integral,
    Name,
    Number,
    Product,
    Quotient,
    names,
    parts_of_kind,
    walk,
    with_parts_changed,
)
from symbalance.notes.algebra.letters_in_waves import WAVES, letters_in_waves
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

_BAR = re.compile(r"\\(?:overline|bar|widebar)(?![A-Za-z])")
MEAN = re.compile(
    r"(?<![^\W\d_])(?:means?|average[ds]?|mittel\w*|\w+mittel(?:s|wert\w*)?|gemittelt\w*|mittlere\w*|quadratisch\w*|moyen\w*|medi[aoe]?s?"
    r"|promedio|r\.?m\.?s|gemiddeld\w*|méd[ií]\w*|medel\w*|průměr\w*|śred\w*)(?![^\W\d_])|平均",
    re.IGNORECASE,
)
COMPLEX = re.compile(r"(?<![^\W\d_])[ck]ompl(?:ex|e[ij]|ess)|複素|zespolon", re.IGNORECASE)
_NEAR = 300
"""Characters before a bar in which words may call it a mean."""
_TIME = "t"


def with_means_under_bars(document: ReadNotes) -> ReadNotes:
    """Return a page on which a bar over a formula of a turning angle is the mean over a turn."""
    nodes = [node for chain in document.chains for side in chain.sides for node in side.readings]
    bars = [part for node in nodes for part in parts_of_kind(node, Call) if part.function == "conj"]
    if (
        not bars
        or COMPLEX.search(document.text)
        or any(part == Constant("i") for node in nodes for part in walk(node))
    ):
        return document
    turning = {name for node in nodes for name in letters_in_waves(node)}
    mean = _Means(document.text, next(iter(turning)) if len(turning) == 1 else "")
    return replace(document, chains=tuple(_changed(chain, mean.of) for chain in document.chains))


def _changed(chain: Chain, change: Callable[[Formula], Formula]) -> Chain:
    sides = (replace(side, readings=tuple(map(change, side.readings))) for side in chain.sides)
    return replace(chain, sides=tuple(sides))


@dataclass(frozen=True, slots=True)
class _Means:
    """Puts means for the bars of a text; `angle` is the one letter of the page that turns."""

    text: str
    angle: str

    def of(self, node: Formula) -> Formula:
        """Return a formula in which a bar over what turns is a mean."""
        if not isinstance(node, Call) or node.function != "conj":
            return with_parts_changed(node, self.of)
        is_bar = _BAR.match(self.text, node.span[0]) is not None
        mean = self._mean(node) if is_bar else None
        return mean or with_parts_changed(node, self.of)

    def _mean(self, bar: Call) -> Formula | None:
        inside = bar.argument
        letters = letters_in_waves(inside)
        if not letters and self.angle and names(inside) and self._is_called_mean(bar.span[0]):
            letters = frozenset({self.angle})  # v², and v has its formula above
        turn: Formula = Product((Number(Fraction(2)), Constant("pi")))
        speeds = letters - {_TIME}
        if _TIME in letters and len(speeds) == 1:
            variable, turn = _TIME, Quotient(turn, Name(next(iter(speeds))))
        elif len(letters) == 1:
            (variable,) = letters
        else:
            return None
        if any(map(_is_slower, parts_of_kind(inside, Call))):
            return None  # of half orders the mean is over two turns
        whole = Integral(inside, Name(variable), Number(Fraction(0)), turn, span=bar.span)
        return Quotient(whole, turn, span=bar.span)

    def _is_called_mean(self, start: int) -> bool:
        return MEAN.search(self.text, max(0, start - _NEAR), start) is not None


def _is_slower(wave: Call) -> bool:
    """Tell whether a wave's angle is a part of the crank's: sin(φ/2)."""
    if wave.function not in WAVES:
        return False
    numbers = (part for part in walk(wave.argument) if isinstance(part, Number))
    return isinstance(wave.argument, Quotient) or any(n.value.denominator != 1 for n in numbers)
