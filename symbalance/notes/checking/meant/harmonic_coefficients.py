"""Coefficients of the harmonics of the piston's acceleration, by number: A_4 ≈ -λ³/4, A_6 ≈ 9 λ⁵/128.

Of x = r (1 - cos θ) + l (1 - √(1 - λ² sin²θ)) the acceleration over r ω² is cos θ + Σ A_n cos nθ, with

    A_2j = (8 j²/λ) Σ_{k ≥ j} (-1)^(j+k) C(1/2, k) C(2k, k - j) (λ/2)^(2k),     λ = r/l

and what a page writes of its A_n, cut off anywhere, says by its first term whether it means these. From
then on a wrong one is refuted: a page may count with other signs, and it may mean the harmonics of the
velocity or the displacement, so that before one coefficient has agreed only a leading term is refuted
that is none of these. Where the page has the series itself, r ω² (cos θ + A_2 cos 2θ + …), they are those
of the acceleration, each with its sign there.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from math import comb

from symbalance.document.formula import Formula, Name, Number, Power, Product, Quotient, Sum, names
from symbalance.document.letters import plain_letter
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.domain import Domain, NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator, SymbolValue
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision, without_dots
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.meant.meant_words import NOBODY
from symbalance.notes.checking.meant.signs_in_series import line_of_acceleration, sign_in_series
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

_NAME = re.compile(r"(?P<stem>.+)_(?P<order>[02468]|10|12)")
_WORDS = re.compile(
    r"coefficient|constant|position|harmonic|\borders?\b|\bterms?\b|series|Koeffizient|Beiwert|Harmonische|Ordnung|Reihe"
    r"|係数|[2468二四六八]\s*次|高調波|級数",
    re.IGNORECASE,
)
_TORQUE = re.compile(
    r"torque|moment|energy|inertia of|トルク|モーメント|peak[- ]to|double amplitude|spitze[- ]spitze"
    r"|complex|komplex",
    re.IGNORECASE,
)
"""Words for coefficients of something else, or of twice or half of it."""
_COEFFICIENTS = frozenset({"A", "B", "a", "b", "k"})
"""Letters of the coefficients of a piston's acceleration on most pages."""
_FACTORS = frozenset(Fraction(n) for n in (2, 4, 8)) | {Fraction(1, n) for n in (2, 4, 8)}
"""By what a coefficient that is one of a known series may be wrong."""
_NO_LETTER = re.compile(r"[\W\d_]+")
BARE, REACH = 12, 160
"""Letters of a sentence that is only the opening of a display, and characters before it that are read."""
_RATIOS = frozenset({"lambda", "rho", "epsilon", "n", "kappa", "mu", "q", "nu", "k"})
"""Letters of r/l or l/r on most pages."""


@dataclass
class HarmonicCoefficients:
    """Judges the coefficients of one page; which letters have agreed so far is its state."""

    sections: Sections
    agreed: dict[tuple[str, str], int] = field(default_factory=dict)
    """Stems and ratios of which a coefficient has agreed, with the line."""
    norms: dict[tuple[str, str], int] = field(default_factory=dict)
    """How often the order divides: never of the acceleration, twice of the position."""

    def judge(self, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
        """Return the decision on a relation that gives such a coefficient its series; None for others."""
        left, right = chain.sides[k].node, without_dots(chain.sides[k + 1].node)[0]
        match = _NAME.fullmatch(left.name) if isinstance(left, Name) and not k else None
        own = names(right)
        if match is None or not isinstance(left, Name) or len(own) != 1 or knowledge.knows(left.name):
            return None
        (ratio,) = own
        order, terms = int(match["order"]), _terms(right, ratio)
        key, is_rough = (match["stem"], ratio), chain.relations[0].sign in "=≈"
        is_inverse = _is_inverse(terms, order)
        if ratio not in _RATIOS or not is_rough or is_inverse is None:
            return None
        powers = {-power if is_inverse else power: value for power, value in terms.items()}
        first, series = min(powers), coefficients(order, max(map(abs, powers)))
        leading = min(series, default=first - 1)
        scale = powers[first] / series[leading] if first == leading else Fraction(0)
        norm = _norm(scale, order)
        by_series = self._by_series(left.name, order)
        is_said = bool(by_series) or key in self.agreed or (norm is not None and self._is_said(chain))
        known_norm = 0 if by_series or not order else self.norms.get(key)
        if not scale or not is_said or (known_norm is None and norm is None):
            return self._with_slip(chain, k, powers, -1 if is_inverse else 1)
        norm = known_norm if known_norm is not None else norm or 0
        size = Fraction(1, max(order, 1) ** norm)
        stated = sign_in_series(self.sections.document.chains, left.name, order) if norm != 1 else 0
        turned = stated < 0 if stated else scale < 0
        target = _series_node(series, ratio, -1 if is_inverse else 1, -size if turned else size)
        side = chain.sides[k + 1]
        bare = Knowledge(SymbolValue(positive=frozenset(own)), corrects=knowledge.corrects)
        decision = decide(Side((target,), chain.sides[k].span), Side((right,), side.span), "=", bare)
        line = by_series or self.agreed.get(key)
        source = f"as in line {line}" if line else "its formula says so"
        motion = ("acceleration over r ω²", "velocity over r ω", "position over r")[norm if order else 2]
        what = f"the coefficient of {'sin' if norm == 1 else 'cos'} {order}θ in the piston's {motion}"
        what = what if order else f"the mean of the piston's {motion}"
        text = f"{plain_letter(left.name)} is {what} ({NOBODY}; {source})"
        if decision.is_proved:
            self.agreed.setdefault(key, chain.lines[0])
            if order:
                self.norms.setdefault(key, norm)
            through = f"{plain_letter(ratio)}^{max(map(abs, terms))}"
            return Decision(PROVED, order=through, assumptions=(text,))
        refuted = replace(decision, reason=f"if {text}", assumptions=())
        return refuted if decision.status == REFUTED else None

    def _with_slip(
        self, chain: Chain, k: int, powers: Mapping[int, Fraction], direction: int
    ) -> Decision | None:
        """Return that the leading term alone is wrong by its power or its number; else None.

        Another power needs a coefficient that agreed before: one over l ω² has another power than one
        over r ω². One twice or four times too large is none of an acceleration, velocity or position.
        """
        left = chain.sides[k].node
        match = _NAME.fullmatch(left.name) if isinstance(left, Name) else None
        if match is None or not isinstance(left, Name) or len(powers) != 1 or not int(match["order"]):
            return None
        (ratio,), order = names(chain.sides[k + 1].node), int(match["order"])
        ((power, value),) = powers.items()
        leading = order - 1
        size = coefficients(order, leading)[leading]
        by_series = self._by_series(left.name, order)
        norm = 0 if by_series else self.norms.get((match["stem"], ratio))
        scales = {n: abs(value) / abs(size) * order**n for n in ((0, 1, 2) if norm is None else (norm,))}
        if norm is not None:
            is_slip = power != leading and abs(power - leading) <= 2 and scales[norm] == 1
            is_slip |= power == leading and scales[norm] in _FACTORS
        else:
            is_slip = (
                power == leading and scales[0] in (2, 4) and not {1, Fraction(1, 2)} & {*scales.values()}
            )
            is_slip &= (
                match["stem"] in _COEFFICIENTS and self._is_said(chain) and not self._is_of_torque(chain)
            )
        if not is_slip:
            return None
        number = Fraction(size, order ** (norm or 0))
        target = _series_node({leading: abs(number)}, ratio, direction, Fraction(1 if value > 0 else -1))
        what = f"the leading term of the coefficient of order {order} in the piston's motion"
        line = by_series or self.agreed.get((match["stem"], ratio))
        source = f"as in line {line}" if line and norm is not None else "its form says so"
        text = f"{plain_letter(left.name)} is {what} ({NOBODY}; {source}), {formula_text(target)}"
        bare = Knowledge(SymbolValue(positive=frozenset({ratio})))
        decision = decide(Side((target,), chain.sides[k].span), chain.sides[k + 1], "=", bare)
        refuted = replace(decision, reason=f"if {text}", assumptions=())
        return refuted if decision.status == REFUTED else None

    def _by_series(self, name: str, order: int) -> int:
        """Return the line of the series of an acceleration that a coefficient stands in; 0 for none."""
        return line_of_acceleration(self.sections.document.chains, name, order) if order else 0

    def _is_of_torque(self, chain: Chain) -> bool:
        """Tell whether the sentence or heading speaks of a torque, whose coefficients are others."""
        return _TORQUE.search(self._words(chain)) is not None

    def _is_said(self, chain: Chain) -> bool:
        """Tell whether the sentence or its section's heading speaks of harmonics."""
        return _WORDS.search(self._words(chain)) is not None

    def _words(self, chain: Chain) -> str:
        """Return the words of a relation's sentence, or else of the lines before, and its heading."""
        sentence = self.sections.sentence_leading_to(chain)
        if len(_NO_LETTER.sub("", sentence)) <= BARE:
            sentence = self.sections.document.text[max(0, chain.start - REACH) : chain.start]
        return sentence + self.sections.heading_above(chain.lines[0])


def coefficients(order: int, highest: int) -> dict[int, Fraction]:
    """Return the coefficient of cos nθ in the acceleration over r ω², by powers of r/l up to a highest.

    >>> coefficients(2, 3), coefficients(6, 5)
    ({1: Fraction(1, 1), 3: Fraction(1, 4)}, {5: Fraction(9, 128)})
    >>> coefficients(0, 3)
    {-1: Fraction(1, 1), 1: Fraction(-1, 4), 3: Fraction(-3, 64)}
    """
    j, series = order // 2, dict[int, Fraction]()
    if not j:  # of the mean of √(1 - λ² sin²θ)/λ, what the harmonics of the position leave at θ = 0
        series[-1] = Fraction(1)
        for n in range(2, highest + 2, 2):
            for power, value in coefficients(n, highest).items():
                series[power] = series.get(power, Fraction(0)) - value / n**2
        return series
    binomial = Fraction(1)  # of 1/2 over k
    for k in range(1, highest // 2 + 2):
        binomial *= (Fraction(1, 2) - (k - 1)) / k
        power = 2 * k - 1
        if k >= j and power <= highest:
            series[power] = 8 * j**2 * (-1) ** (j + k) * binomial * comb(2 * k, k - j) / Fraction(4) ** k
    return series


def _is_inverse(terms: dict[int, Fraction], order: int) -> bool | None:
    """Tell whether a series is in l/r and not in r/l; None where it is neither."""
    if not terms or 0 in terms:
        return None
    directions = {power > 0 for power in terms}
    if order:
        return directions == {False} if len(directions) == 1 else None
    for is_inverse in (False, True):
        turned = {-power if is_inverse else power for power in terms}
        if -1 in turned and 1 in turned and min(turned) == -1:
            return is_inverse if len(turned) > 2 or turned != {-1, 1} else terms.get(-1) != 1
    return None


def _norm(scale: Fraction, order: int) -> int | None:
    """Return how often the order divides a coefficient of the acceleration: 2 for one of the position."""
    if not order:
        return 0 if abs(scale) == 1 else None
    return next((k for k in range(3) if abs(scale) * order**k == 1), None)


def _terms(node: Formula, ratio: str) -> dict[int, Fraction]:
    """Return the coefficients of a polynomial in one letter by its powers; none of another form."""
    try:
        form = FormEvaluator(Domain(), SymbolValue()).form(node)
    except (NoFormError, TooLargeError):
        return {}
    if len(form.denominator) != 1 or form.domain.radicals or form.domain.opaque:
        return {}
    symbol = form.domain.symbol(ratio)
    ((below, divisor),) = form.denominator.items()
    terms: dict[int, Fraction] = {}
    for monomial, coefficient in form.numerator.items():
        power = Fraction(dict(monomial).get(symbol, 0)) - Fraction(dict(below).get(symbol, 0))
        if {g for g, _ in (*monomial, *below)} - {symbol} or power.denominator != 1:
            return {}
        terms[int(power)] = Fraction(coefficient) / Fraction(divisor)
    return terms


def _series_node(series: dict[int, Fraction], ratio: str, direction: int, sign: Fraction) -> Formula:
    """Return a series in r/l, or in l/r where the direction is -1, through its highest power."""
    terms: list[Formula] = []
    for power, coefficient in sorted(series.items()):
        raised = Power(Name(ratio), Number(Fraction(power)))
        number = rational_node(sign * coefficient)
        terms.append(Product((number, raised)) if direction > 0 else Quotient(number, raised))
    return terms[0] if len(terms) == 1 else Sum(tuple(terms))
