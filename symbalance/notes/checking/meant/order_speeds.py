"""Speeds at which an order meets a natural frequency: the sixth meets 162 Hz at 60 · 162/6 = 1620 rpm.

Such a number has no formula beside it that it could be checked by,
only words or the index of its letter for
the order,
and a frequency in Hz somewhere on the page. It is confirmed if it is that speed of any frequency
of the page. It is refuted if the page has one frequency only,
and it is no speed of this order by any usual
count (of turns, or of the four-stroke cycle with its two turns).
"""

from __future__ import annotations

from symbalance.document.formula import Formula, Name, Number, names, walk
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.meant.given_numbers import number_in_example
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

_GAP = r"(?:\s|\\[,; ]|~|\$|\\(?:mathrm|text|unit|,)|\{|\}){0,8}"
_FREQUENCY = re.compile(
    rf"(?<![\w.,])(?P<number>[0-9]{{1,5}}(?:(?:[.,]|\{{,\}})[0-9]{{1,3}})?){_GAP}(?P<unit>Hz|cps)\b"
)
_PER_MINUTE = re.compile(
    rf"(?<![\w.,])(?P<number>[0-9]{{2,6}}){_GAP}(?:vibrations|oscillations|cycles|schwingungen)"
    r"\s+(?:per|pro|je)\s+minute",
    re.IGNORECASE,
)
_TIMES = {
    "first": 1, "second": 2, "third": 3, "fourth": 4, "fifth": 5, "sixth": 6, "seventh": 7, "eighth": 8,
    "ninth": 9, "tenth": 10, "twelfth": 12, "erste": 1, "zweite": 2, "dritte": 3, "vierte": 4,
    "fünfte": 5,
    "sechste": 6, "siebte": 7, "achte": 8, "neunte": 9, "zehnte": 10, "zwölfte": 12,
}  # fmt: skip
_NUMBER = r"[0-9]{1,2}(?:[.,]5)?"
_ORDER = re.compile(
    rf"(?P<word>{'|'.join(_TIMES)})[nrs]?[-\s]+(?:order|ordnung|harmonic|harmonische)"
    rf"|(?P<number>{_NUMBER})(?:\.|th|rd|nd|st)?[-\s]{{0,2}}(?:order|ordnung|次)"
    rf"|(?:order|ordnung)(?:\s+(?:i|k|n|number|no\.?|nr\.?))?[\s=$]{{1,4}}(?P<behind>{_NUMBER})(?![0-9.,]*[0-9])",
    re.IGNORECASE,
)
_ORDERS_NEAR = re.compile(r"\borders?\b|ordnung|次数|[0-9]次|harmonic", re.IGNORECASE)
_RESONANCE = re.compile(
    r"critical|resonan|excite|kritisch|erreg|anregung|campbell|共振|危険|加振|natural frequency"
    r"|eigenfrequenz"
    r"|torsional|drehschwing|cross",
    re.IGNORECASE,
)
_OTHERS = re.compile(r"gear|getriebe|歯車|firing frequency|zündfrequenz|sampling|abtast", re.IGNORECASE)
_SPEED_LETTERS = frozenset({"n", "N"})
_INDEX = re.compile(rf"(?P<number>{_NUMBER})")
_START = re.compile(r".*(?:[.;:!?]\s|\n\s*[-*|]|\n\s*\n|\|)", re.DOTALL)
CLAUSE, PARAGRAPH = 90, 600
CONVENTIONS = (2.0, 0.5)
"""Factors by which a count of the cycle differs from one of the turns."""
FAR = 0.03


def decide_order_speed(
    chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on a number for the speed at which an order is in resonance."""
    left, right = chain.sides[0].node, chain.sides[1].node
    if k or not isinstance(left, Name) or names(right) or chain.relations[0].sign not in "=≈":
        return None
    stem, _, index = left.name.partition("_")
    order = _order_of(chain, index, document.text) if stem in _SPEED_LETTERS else None
    if not order or not _RESONANCE.search(document.text) or _OTHERS.search(document.text):
        return None
    value = number_in_example(right, knowledge)
    frequencies = _frequencies(document.text)
    return _decide(abs(float(value)), right, order, frequencies) if value and frequencies else None


def _decide(
    value: float, right: Formula, order: float, frequencies: list[tuple[float, float]]
) -> Decision | None:
    """Decide on a speed, in turns per minute or per second, by the frequencies of the page."""
    claims = [value, value * 60]
    for frequency, place in frequencies:
        speed = 60 * frequency / order
        near = 30 * place / order + _half_place(right) + 1e-9 * speed
        if any(abs(claim - speed) <= near for claim in claims):
            reason = f"60 · {frequency:g} Hz over the order {order:g}"
            return Decision(PROVED, reason, order="the digits printed")
    speed = 60 * frequencies[0][0] / order
    usual = [speed * factor for factor in (1.0, *CONVENTIONS)]
    is_near = any(abs(claim / each - 1) < FAR for claim in claims for each in usual)
    if len(frequencies) > 1 or is_near:
        return None
    reason = f"the order {order:g} meets {frequencies[0][0]:g} Hz at {speed:g} revolutions per minute"
    nearest = min(claims, key=lambda claim: abs(claim - speed))
    return Decision(REFUTED, reason, witness={"left": f"{speed:g}", "right": f"{nearest:g}"})


def _half_place(node: Formula) -> float:
    """Return half a unit of the last place of a printed number, or of a whole one."""
    places = [part.last_place for part in walk(node) if isinstance(part, Number) and part.last_place]
    return float(places[0]) / 2 if places else 0.5


def _order_of(chain: Chain, index: str, text: str) -> float | None:
    """Return the order that the words before a formula or its letter's index name."""
    start = chain.start
    words = _START.sub("", text[max(0, start - CLAUSE) : start])
    told = [_number(match) for match in _ORDER.finditer(words)]
    by_index = _INDEX.fullmatch(index.strip("{}"))
    number = float(by_index["number"].replace(",", ".")) if by_index is not None else None
    if len(set(told)) == 1:
        return told[0] if number in (None, told[0]) else None
    if told or number is None:
        return None
    paragraph = text[max(0, start - PARAGRAPH) : start]
    return number if _ORDERS_NEAR.search(paragraph) else None


def _number(match: re.Match[str]) -> float:
    digits = match["number"] or match["behind"]
    return float(digits.replace(",", ".")) if digits else float(_TIMES[match["word"].casefold()])


def _frequencies(text: str) -> list[tuple[float, float]]:
    """Return the frequencies of a page in Hz, each once, with a unit of its last place."""
    every: dict[float, float] = {}
    for match in _FREQUENCY.finditer(text):
        digits = match["number"].replace("{,}", ".").replace(",", ".")
        every[float(digits)] = 10.0 ** -len(digits.partition(".")[2])
    for match in _PER_MINUTE.finditer(text):
        every[float(match["number"]) / 60] = 1 / 60
    return [pair for pair in every.items() if pair[0]]
