r"""Ratios of similar engines by a product in words: with p the same, V as k³ and n as 1/k, P₂/P₁ is k².

Words say that a quantity goes as the product of others, or a product of letters stands beside it, and the
paragraph says by which power of one letter each of them grows, or that it stays the same. The quantity
grows by the sum of these powers.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from symbalance.document.formula import Formula, Name, Quotient, names
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.values_at_points import value_at
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, DEFINITION, PREMISE, UNDECIDED, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_KINDS = {
    "pressure": r"pressures?|\w*[dD]ruck|pressions?|pression[ei]|presi[oó]n(?:es)?|圧力?|平均有効圧",
    "volume": r"displacements?|(?:swept\s+)?volumes?|\w*[hH]ubr[aä]um\w*|\w*[vV]olum\w*"
    r"|cylindrées?|cilindrat[ae]|cilindradas?|排気量|体積|容積",
    "speed": r"(?:rotational\s+|engine\s+|angular\s+)?speeds?|\w*[dD]rehzahl(?:en)?"
    r"|Winkelgeschwindigkeit|(?:vitesses?|régimes?)(?:\s+de\s+rotation)?"
    r"|(?:velocità|regime)(?:\s+di\s+rotazione)?|(?:velocidad|régimen)(?:\s+de\s+giro)?|回転(?:数|速度)|角速度",
    "mass": r"mass(?:es)?|Massen?|masses?|mass[ae]|masas?|質量",
    "radius": r"(?:crank\s+)?radi(?:us|i)|(?:Kurbel)?[rR]adi(?:us|en)|rayons?(?:\s+de\s+manivelle)?"
    r"|raggio(?:\s+di\s+manovella)?|radios?(?:\s+de\s+manivela)?|(?:クランク)?半径",
    "area": r"areas?|\w*[fF]lächen?|\w*[qQ]uerschnitt\w*|sections?|surfaces?|sezion[ei]|aree|áreas?|面積",
    "force": r"forces?|\w*[kK]r[aä]fte?|forz[ae]|fuerzas?|力",
    "stroke": r"strokes?|(?:Kolben)?[hH]ub(?!r|v)|courses?|cors[ae]|carreras?|行程|ストローク",
}
"""Nouns of the quantities that are multiplied."""
_LETTERS = {
    "pressure": "p", "volume": "V", "speed": "omega Omega n N", "mass": "m M", "radius": "r R",
    "area": "A", "force": "F", "stroke": "s",
}  # fmt: skip
_KIND_OF = {letter: kind for kind, letters in _LETTERS.items() for letter in letters.split()}
_NAMED = "|".join(f"(?P<{kind}>{words})" for kind, words in _KINDS.items())
_NOUN = rf"(?<![A-Za-zÀ-ÿ])(?:{_NAMED})(?![A-Za-zÀ-ÿ])"
_ANY = r"(?<![A-Za-zÀ-ÿ])(?:" + "|".join(_KINDS.values()) + r")(?![A-Za-zÀ-ÿ])"
_MEAN = r"mean\s+effective|mittlere[rnms]?|mean"
_ARTICLE = rf"(?:(?:the|its|die|der|das|dem|la|le|les|l['’]|il|lo|el|los|{_MEAN})\s*)*"
_TIMES = r"(?:\s*(?:times|mal|fois|per|por|multiplied\s+by|×|\$\\times\$|・|×|と)\s*)"
_PRODUCT = re.compile(
    rf"(?:(?:goes|go|grows|scales|varies|is\s+proportional|proportional|geht|wächst|ist\s+proportional|varie|croît|est\s+proportionnelle|va|cresce|è\s+proporzionale|crece"
    rf"|es\s+proporcional)\s+(?:as|with|like|to|mit|wie|zu[mr]?|comme|à|avec|come|con|a)\s+)(?:the\s+product\s+of\s+)?"
    rf"(?P<factors>{_ARTICLE}{_ANY}(?:{_TIMES}{_ARTICLE}{_ANY})+)|(?P<factors_ja>{_ANY}(?:\s?[×と]\s?{_ANY})+)の?(?:積)?に比例",
    re.IGNORECASE,
)
"""A quantity goes as pressure times displacement times speed."""
_EACH = re.compile(_NOUN, re.IGNORECASE)
_POWER = (
    r"\$\s*(?P<one>\\[dt]?frac\{?1\}?\{?|1/)?\s*(?P<letter>[a-z]|\\lambda|\\mu|\\nu)\}?"
    r"\s*(?:\^\s*\{?\s*(?P<exponent>[-−]?[0-9])\s*\}?)?\}?\s*\$"
)
_GROWS = re.compile(
    rf"{_NOUN}(?P<between>[^.;$。]{{0,40}}?)(?:(?<![A-Za-zÀ-ÿ])(?:with|as|like|by|mit|wie|um|comme|avec|en|come|con|como|di)\s+|[はがの]\s?)"
    rf"(?:(?:the\s+factor|dem\s+Faktor|den\s+Faktor|le\s+facteur)\s+)?{_POWER}",
    re.IGNORECASE,
)
"""The mass grows with k³."""
_SAME_FIRST = re.compile(
    rf"(?<![^\W\d_])(?:same|gleiche[rnm]?|même|stess[ao]|mism[ao])\s+(?:mean\s+effective\s+)?{_NOUN}",
    re.IGNORECASE,
)
_STAYS = re.compile(
    rf"{_NOUN}\s*(?:(?:is|are|stays?|remains?|bleib(?:t|en)|ist|sind|reste(?:nt)?|est|sont|resta(?:no)?|rimane|è|queda|permanece|es|は|が)\s*)+(?:also\s+|auch\s+)?"
    r"(?:the\s+same|unchanged|constant|equal|unaltered|gleich|unverändert|konstant|dieselbe|la\s+même|inchangée?|constante?|la\s+stessa|invariat[ao]|costante|la\s+misma|igual|同じ|一定|変わらない)",
    re.IGNORECASE,
)
"""The pressure is the same; bei gleicher Drehzahl."""
_OTHERWISE = re.compile(
    r"(?<![^\W\d_])(?:per|specific|each|every|unit|stress|half|square\s+root|spezifisch\w*|bezogen\w*|je|pro|jede[rs]?|spannung|wurzel|par|spécifique|chaque|contrainte|specific[ao]"
    r"|ciascun\w*|tensione|específic[ao]|cada|tensión)(?![^\W\d_])|あたり|応力|比(?!例)",
    re.IGNORECASE,
)
_ANOTHER = re.compile(
    r"moment|torque|couple|coppia|\barm\b|hebel|bras|braccio|brazo|energ|énerg|arbeit|work|travail|lavoro|trabajo|stress"
    r"|deflect|power|leistung|puissance|potenza|potencia|モーメント|トルク|エネルギ|仕事|動力|出力",
    re.IGNORECASE,
)
"""Words behind a product for another quantity, which is made of it."""
_LETTER_PRODUCT = re.compile(r"\$(?P<product>[^$=]{3,60})\$")
_FACTOR = re.compile(
    r"\s*(?P<letter>\\?[A-Za-z]+?(?![A-Za-z])"
    r"|[A-Za-z])(?:_\{?\w+\}?)?\s*(?:\^\s*\{?(?P<power>[0-9])\}?)?"
)
_STRESSES = frozenset(f"{stem}{index}" for stem in ("sigma", "tau") for index in ("", "_1", "_2", "'"))
"""Letters of stresses, which are a force over an area."""
_NEAR, _POINTS = 700, (2.0, 3.0)
_CLOSE = 1e-9


def unless_of_other_product(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; refuted for a ratio that is another power than its product in words gives."""
    is_open = verdict.verdict in (DEFINITION, PREMISE, UNDECIDED, CONDITION)
    if k or not is_open or chain.relations[0].sign != "=" or len(chain.sides) != 2:
        return verdict
    head, right = chain.sides[0].node, chain.sides[1].node
    letters = names(right)
    claimed = _power_of(right)
    if not _is_ratio(head) or len(letters) != 1 or claimed is None:
        return verdict
    (letter,) = letters
    sentence = state.sections.sentence_before(chain)
    factors = _factors(sentence)
    if not factors or _OTHERWISE.search(sentence) or names(head) & _STRESSES:
        return verdict
    growth = _growth(state, chain, letter)
    if any(kind not in growth for kind, _ in factors):
        return verdict
    expected = sum(power * growth[kind] for kind, power in factors)
    if math.isclose(expected, claimed, abs_tol=_CLOSE):
        return verdict
    shown = plain_letter(letter)
    parts = ", ".join(f"{kind} with {shown}^{growth[kind]}" for kind, _ in factors)
    reason = f"it goes with {shown}^{expected}: {parts}"
    return describe(state.document, chain, k, Decision(REFUTED, reason))


def _is_ratio(head: Formula) -> bool:
    """Tell whether a formula is a letter over another of its stem: P_2/P_1, F'/F."""
    match head:
        case Quotient(numerator=Name(name=above), denominator=Name(name=below)):
            stems = [name.partition("_")[0].rstrip("'").removesuffix("prime") for name in (above, below)]
            return above != below and stems[0] == stems[1]
    return False


def _power_of(right: Formula) -> float | None:
    """Return by which power of its one letter a formula goes; None for another formula."""
    own = names(right)
    if len(own) != 1:
        return None
    (letter,) = own
    values = [value_at(right, {letter: at}) for at in (1.0, *_POINTS)]
    sizes = [value for value in values if value is not None and value > 0]
    if len(sizes) < len(values) or abs(sizes[0] - 1) > _CLOSE:
        return None
    first, second = (math.log(v) / math.log(at) for v, at in zip(sizes[1:], _POINTS, strict=True))
    return first if math.isclose(first, second, abs_tol=_CLOSE) else None


def _factors(sentence: str) -> list[tuple[str, int]]:
    """Return the kinds of quantity that a sentence multiplies, in words or in letters; [] for none."""
    match = _PRODUCT.search(sentence)
    if match is not None:
        words = match["factors"] or match["factors_ja"]
        return [(_kind(each), 1) for each in _EACH.finditer(words)]
    products = [(m, f) for m in _LETTER_PRODUCT.finditer(sentence) if (f := _letters_of(m["product"]))]
    if len(products) != 1 or _ANOTHER.search(sentence, products[0][0].end()):
        return []
    return products[0][1]


def _letters_of(product: str) -> list[tuple[str, int]]:
    """Return the kinds of quantity of a product of letters, with their exponents; [] for another formula.

    >>> _letters_of(r"m r\\omega^2"), _letters_of("m + r")
    ([('mass', 1), ('radius', 1), ('speed', 2)], [])
    """
    plain = re.sub(r"\\(?:[,;: ]|cdot(?![A-Za-z]))|·", " ", product).strip()
    place, found = 0, list[tuple[str, int]]()
    while place < len(plain):
        match = _FACTOR.match(plain, place)
        kind = None if match is None else _KIND_OF.get(match["letter"].lstrip("\\"))
        if match is None or kind is None:
            return []
        found.append((kind, int(match["power"] or 1)))
        place = match.end()
    return found if len(found) > 1 else []


def _kind(match: re.Match[str]) -> str:
    return next(kind for kind in _KINDS if match[kind])


def _growth(state: JudgingState, chain: Chain, letter: str) -> dict[str, int]:
    """Return by which power of a letter each kind of quantity grows, where the paragraph says one."""
    sections = state.sections
    start = sections.start_of_line(sections.paragraph_start(chain.lines[0]))
    start = max(min(start, chain.start), chain.start - _NEAR)
    text = state.document.text[start : chain.start]
    found: dict[str, set[int]] = {}
    for kind, power in (*_said(text, letter), *_written(state, chain, start, letter)):
        found.setdefault(kind, set()).add(power)
    return {kind: next(iter(powers)) for kind, powers in found.items() if len(powers) == 1}


def _said(text: str, letter: str) -> Iterator[tuple[str, int]]:
    for match in _GROWS.finditer(text):
        is_of_it = match["letter"].lstrip("\\") == letter
        if is_of_it and _EACH.search(match["between"]) is None:
            power = int((match["exponent"] or "1").replace("−", "-"))
            yield _kind(match), -power if match["one"] else power
    for pattern in (_STAYS, _SAME_FIRST):
        for match in pattern.finditer(text):
            yield _kind(match), 0


def _written(state: JudgingState, chain: Chain, start: int, letter: str) -> Iterator[tuple[str, int]]:
    """Yield the kinds whose ratio a relation above gives: the displacements, V_2/V_1 = k³."""
    for above in state.sections.chains_between(start, chain.start):
        head, right = above.sides[0].node, above.sides[-1].node
        power = _power_of(right) if names(right) == {letter} and _is_ratio(head) else None
        if power is None or abs(power - round(power)) > _CLOSE:
            continue
        nouns = [_kind(each) for each in _EACH.finditer(state.sections.sentence_before(above))]
        if nouns and isinstance(head, Quotient) and isinstance(head.numerator, Name):
            stem = head.numerator.name.partition("_")[0]
            if _KIND_OF.get(stem, nouns[-1]) == nouns[-1]:
                yield nouns[-1], round(power)
