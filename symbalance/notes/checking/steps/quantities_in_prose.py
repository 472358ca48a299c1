"""Quantities that prose gives without a letter, said again in another unit: 600 cm³, so V = 6·10⁻⁴ m³.

"The engine is rated at 200 hp. Its power in SI units is P = 200·0.7457 kW": words join the second number
to the first, and no other quantity of its kind stands in the paragraph. What is off by a power of ten, or
by the factor of the conversion itself, is a conversion gone wrong.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import product

from symbalance.document.formula import Name, names
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.numbers_of_their_units import has_several_in_a_turn
from symbalance.notes.checking.units.dimensions import unit_of, written_unit
from symbalance.notes.checking.units.worded_units import WordedUnit, worded_unit
from symbalance.notes.checking.verdicts import DEFINITION, PREMISE, UNDECIDED, Verdict
from symbalance.notes.reading.equations import Chain, Side
from symbalance.notes.reading.formulas.result_units import value_of, without_unit_of_result
from symbalance.text import lazy_patterns as re

_NUMBER = re.compile(
    r"(?<![\w.,^_{\\])(?P<number>[0-9]+(?:(?:\\,|[ \u2009\u202f~])[0-9]{3}(?![0-9]))*"
    r"(?:(?:\.|\{,\}|,)[0-9]+)?)"
    r"(?:\s*(?:\\cdot|\\times|[·×])\s*10\s*\^\s*(?:\{\s*(?P<braced>[-−]?\s*[0-9]{1,2})\s*\}|(?P<power>[0-9])))?"
)
_SPACES = re.compile(r"\\,|[ \u2009\u202f~]")
_RATIO_OF_UNITS = re.compile(
    r"(?<![\w.,])1\s*(?:\\,|~|\$|\\mathrm|\{|\s)*[^\W\d_]{1,6}[^.;=]{0,30}=|(?<![^\W\d_])(?:one|an?|eine?|une?|uno|una)\s+(?:[^\W\d_-]+[\s-]){0,3}?"
    r"(?:\([^()]*\)\s*)?(?:has|is|are|equals?|corresponds\s+to|ist|sind|hat|entspricht|beträgt|vaut|est|correspond|è|vale|equivale|corrisponde|corresponde|es)(?![^\W\d_])"
    r"|(?<![^\W\d_])(?:in|to|per)\s+an?\s+[^\W\d_]+\s*(?:and|$)|(?<![^\W\d_])(?:umrechnung|conversion|facteur|fattore|factor)|[はが].{0,20}に等しい",
    re.IGNORECASE,
)
"""A sentence on units alone: one horsepower is 745.7 W; 1000 g are in a kilogram; 1 bar = 10⁵ Pa."""
_SENTENCE = re.compile(r"(?<=[.;!?])\s+(?=[^\W\d_a-zà-ÿ]|\$)|。|\n\s*\n")
_THIS_IS = re.compile(
    r"(?<![^\W\d_])(?:(?:this|that|these|those|which|das|dies|cela|ceci|ce|questo|questa|ciò|eso|esto|esta)\s+(?:[^\W\d_]+\s+)?(?:is|are|means?|makes?|corresponds?|equals?"
    r"|ist|sind|entspricht|heißt|bedeutet|macht|fait|font|correspond|représente|vaut|est|sont|è|sono|corrisponde|significa|equivale|fa|es|son|corresponde)"
    r"|i\.\s?e\.|that\s+is|d\.\s?h\.|das\s+heißt|c['’]est|soit|cioè|ossia|o\s+sea|es\s+decir)(?![^\W\d_])|これは|すなわち|つまり|換算すると",
    re.IGNORECASE,
)
"""Words by which a sentence says the quantity before it again: this is, das sind, cela fait."""
_ITS = re.compile(
    r"(?<![^\W\d_])(?:its|their|ihre?|seine?|sa|son|leur|sua|suo|su)(?![^\W\d_])|その", re.IGNORECASE
)
_DELIVERS = re.compile(
    r"(?<![^\W\d_])(?:engine|motor|motore|moteur|machine|macchina|máquina|maschine)(?![^\W\d_])[^.;$]{0,40}?(?<![^\W\d_])(?:delivers?|develops?|makes|produces|gives"
    r"|leistet|liefert|fournit|développe|délivre|eroga|sviluppa|fornisce|entrega|desarrolla|suministra)(?![^\W\d_])"
    r"|エンジンは[^。]{0,20}を(?:出す|発生|出力)",
    re.IGNORECASE,
)
"""Words by which an engine gives what is in watts: that is its power."""
_POWER = re.compile(
    r"(?<![^\W\d_])(?:power|(?:motor)?leistung|puissance|potenza|potencia)(?![^\W\d_])"
    r"(?!\s+(?:of|at|der|des|an|de|du|d['’]|del|della|dell['’]|à|alla)(?![^\W\d_])\s*(?:(?:the|la|el)\s+|l['’])?"
    r"(?!engine|motor|moteur|machine|máquina|macchina))|出力|動力",
    re.IGNORECASE,
)
"""The power, and that of no other thing than the engine."""
_WATTS = unit_of("W")
_IN_A_UNIT = re.compile(
    r"(?<![^\W\d_])(?:in|en)\s+(?:the\s+)?(?:(?P<base>(?:SI|basic?|base|coherent|metric|unités|unità|unidades)(?![^\W\d_]))|(?=[^\W\d_]))"
    r"|(?P<converted>converted|umgerechnet|converti[es]?|convertit[oai]|convertid[oa]s?|換算)",
    re.IGNORECASE,
)
"""Words before a value that is said again in other units: in SI units, in cubic metres, converted."""
_COMPUTED = re.compile(
    r"(?<![^\W\d_])(?:gives?|yields?|produces?|causes?|results?|leads?|ergibt|liefert|erzeugt|führt|bewirkt|donne|produit|dà|produce|da)(?![^\W\d_])",
    re.IGNORECASE,
)
"""Words by which a sentence computes something else from a quantity."""
_NOUN = re.compile(r"[^\W\d_]{4,}|[\u4e00-\u9fff]{2,}")
_OTHER = re.compile(
    r"(?<![^\W\d_])(?:per|each|every|half|twice|double[ds]?|thrice|third|quarter|parts?|other|another|loses|losses|gains?|more|less|instead|different|larger|smaller|bigger|größer\w*|kleiner\w*"
    r"|pro|je|jeder?|jedes|halb\w*|doppelt\w*|dritte[lnr]?|viertel|teil\w*|andere[nrs]?|verlust\w*|statt|par|chaque|moitié|autre|double|tiers|quart|pertes?"
    r"|ogni|metà|altr[ao]|doppi[ao]|terzo|quarto|perdite?|cada|mitad|otr[ao]|doble|cam\w*|gear\w*|order|belt|wheel|ratio|nocken\w*|getriebe\w*|ordnung\w*|arbre\s+à\s+cames)"
    r"(?![^\W\d_])|半分|二倍|倍|他の|別の|あたり|ごと|カム|歯車|次",
    re.IGNORECASE,
)
"""Words of a part, a multiple or another thing: what they say is no conversion."""
_OWN_RATE = re.compile(
    r"natural|critical|resonan|eigen|kritisch|propre|propri[oa]|critic|crítica|固有|共振|危険",
    re.IGNORECASE,
)
"""Words of a frequency that a thing has by itself, whatever it turns at."""
_RATE_AGAIN = re.compile(
    r"(?<![^\W\d_])(?:this|that|these|it\s+is|corresponds?|corresponding|thus|hence|therefore|i\.\s?e\.|das|dies|entspricht|also|somit|daher|d\.\s?h\."
    r"|cela|ce|soit|donc|correspond|questo|ciò|cioè|quindi|dunque|corrisponde|eso|esto|luego|corresponde)(?![^\W\d_])|これは|すなわち|つまり|よって",
    re.IGNORECASE,
)
_COMMANDS = re.compile(
    r"\\(?:cdot|times|[dt]?frac|left|right|sqrt|pi|mathrm|text|textrm|unit)(?![A-Za-z])|\\[,;:! ]"
)
_LETTERS = re.compile(r"[A-Za-z]")
"""What is left of an arithmetic with a unit in it, without the commands of its markup."""
_EXPONENT = re.compile(r"\^\s*\{?[-−]?[0-9]\}?")
_ARITHMETIC = re.compile(r"[0-9+]|\\frac|\\cdot|\\times|[·×/−-]\s*[0-9]")
"""What is left behind a number, without the exponents of its unit, of more numbers."""
_REACH, _BEHIND = 60, 120
_NEAR = 700
"""Characters before a relation in which its quantity may stand."""
_SAME, _SLIP = 0.02, 0.012
"""Parts by which a conversion, and a slip of it, may be rounded."""
_TENS = 9
_UNIT_WORDS = frozenset([
    "cubic", "square", "metres", "meters", "units", "unit", "mathrm", "text", "unités", "unità",
    "unidades", "Einheiten", "converted", "umgerechnet", "convertito", "converti", "convertido",
    "Kubikmetern", "Litern", "litres", "liters",
])  # fmt: skip
"""Words of two sentences that are no name of a quantity."""
_MOMENT = re.compile(r"N\s?·?\s?m|lbf")
_STRESS = re.compile(r"stress|spannung|contrainte|tension|tensione|応力", re.IGNORECASE)
_BY_THE_SECOND = frozenset(["1/s", "s^-1", "s⁻¹"])


@dataclass(frozen=True, slots=True)
class _Given:
    """A quantity of the prose: its number in the SI, its unit, as it stands there, and its sentence."""

    value: float
    unit: WordedUnit
    text: str
    sentence: str
    place: int


def unless_converted_from_prose(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; refuted where a value is a quantity of the words before it, wrongly converted."""
    head = chain.sides[0].node
    is_open = verdict.verdict in (DEFINITION, PREMISE, UNDECIDED)
    if k or not is_open or not isinstance(head, Name) or any(names(s.node) for s in chain.sides[1:]):
        return verdict
    is_plain = {r.sign for r in chain.relations} <= {"=", "≈"}
    unit = _unit_of(state, chain.sides[-1]) if is_plain else None
    sentence = state.sections.sentence_before(chain)
    behind = _SENTENCE.split(state.document.text[chain.end : chain.end + _BEHIND])[0]
    if unit is None or _OTHER.search(sentence) or _OTHER.search(behind):
        return verdict
    given = _given_before(state, chain, unit)
    words = f"{sentence} {behind}"
    is_of_it = given is not None and not _is_of_another_kind(unit, given, words)
    if given is None or not is_of_it or not _speaks_of_it(state, chain, sentence, given):
        return verdict
    claimed = _claimed(state, chain, unit)
    ratios = [] if claimed is None else [claimed / given.value * each for each in _readings(unit, given)]
    is_so = any(math.isclose(ratio, 1, rel_tol=_SAME) for ratio in ratios)
    is_indexed = _have_one_index(state, chain, given)
    if is_so or not any(_is_slip(ratio, unit, given, is_indexed=is_indexed) for ratio in ratios):
        return verdict
    state.definitions.forget(head.name, chain.lines[0])
    reason = f"{given.text} is {given.value / unit.scale:.6g} {unit.text}"
    return describe(state.document, chain, k, Decision(REFUTED, reason))


def _unit_of(state: JudgingState, side: Side) -> WordedUnit | None:
    """Return the unit that a value ends in, in its formula or right behind it."""
    typed = written_unit(state.document.source(side.span))[1]
    unit = worded_unit(typed) if typed else None
    return unit or worded_unit(state.document.text[side.span[1] : side.span[1] + _REACH])


def _claimed(state: JudgingState, chain: Chain, unit: WordedUnit) -> float | None:
    """Return what the first value of a chain is in the SI: in its own unit, or in that of its end."""
    first = chain.sides[1]
    source = state.document.source(first.span)
    typed = _typed_number(source)
    if typed is not None:
        own = _unit_of(state, first)
        return typed * (unit if own is None or own.dimension != unit.dimension else own).scale
    if _LETTERS.search(_COMMANDS.sub("", source)) and not unit.is_rate:
        return value_of(first.node)  # the reader has put the unit in
    number = value_of(without_unit_of_result(first))
    return None if number is None else number * unit.scale


def _typed_number(source: str) -> float | None:
    """Return the number that a value consists of but for its unit; None for an arithmetic."""
    match = _NUMBER.match(source.lstrip())
    behind = "" if match is None else source.lstrip()[match.end() :]
    is_more = _ARITHMETIC.search(_EXPONENT.sub("", behind)) is not None
    return None if match is None or is_more else _value(match)


def _value(match: re.Match[str]) -> float:
    number = float(_SPACES.sub("", match["number"]).replace("{,}", ".").replace(",", "."))
    power = match["braced"] or match["power"] or "0"
    return number * 10.0 ** int(power.replace("−", "-").replace(" ", ""))


def _given_before(state: JudgingState, chain: Chain, unit: WordedUnit) -> _Given | None:
    """Return the one quantity of a kind that a paragraph has before a relation; None for none or two."""
    sections, text = state.sections, state.document.text
    first = sections.start_of_line(sections.paragraph_start(chain.lines[0]))
    start = max(first, chain.start - _NEAR)
    found: list[_Given] = []
    place = start
    for sentence in _SENTENCE.split(text[start : chain.start]):
        at = text.find(sentence, place, chain.start)
        place = at + len(sentence)
        if not sentence or _RATIO_OF_UNITS.search(sentence):
            continue
        for match in _NUMBER.finditer(sentence):
            there = worded_unit(sentence[match.end() : match.end() + 80])
            if there is not None and there.dimension == unit.dimension and (value := _value(match)):
                shown = f"{match[0]} {there.text}"
                found.append(_Given(value * there.scale, there, shown, sentence, at + match.start()))
    sizes = {f"{each.value:.4e}" for each in found}
    if len(sizes) != 1 or _OTHER.search(found[-1].sentence):
        return None
    return found[-1]


def _speaks_of_it(state: JudgingState, chain: Chain, sentence: str, given: _Given) -> bool:
    """Tell whether a sentence speaks of the quantity before it, and of no other of its kind."""
    if given.unit.is_rate:
        is_of_thing = _OWN_RATE.search(sentence) and not _OWN_RATE.search(given.sentence)
        if is_of_thing and not _have_one_index(state, chain, given):
            return False
        return _RATE_AGAIN.search(sentence) is not None
    if _THIS_IS.search(sentence):
        return not _COMPUTED.search(sentence)
    asked = any(
        m["base"] or m["converted"] or worded_unit(sentence[m.end() :]) is not None
        for m in _IN_A_UNIT.finditer(sentence)
    )
    first, second = ({*_NOUN.findall(words)} for words in (given.sentence, sentence))
    is_same = not second - _UNIT_WORDS or bool(first & second - _UNIT_WORDS)
    if given.unit.dimension == _WATTS and _DELIVERS.search(given.sentence):
        is_same |= _POWER.search(sentence) is not None
    return asked and (is_same or _ITS.search(sentence) is not None)


def _have_one_index(state: JudgingState, chain: Chain, given: _Given) -> bool:
    """Tell whether a value and the one it says again are of letters with the same index: ω_n and f_n."""
    above = state.sections.chain_before(chain.start)
    if above is None or not above.start <= given.place < above.end:
        return False
    heads = [each.sides[0].node for each in (above, chain)]
    indices = {head.name.partition("_")[2] for head in heads if isinstance(head, Name)}
    return len(indices) == 1 and "" not in indices


def _is_of_another_kind(unit: WordedUnit, given: _Given, words: str) -> bool:
    """Tell whether a value is another quantity of the same dimension: an energy, and no torque."""
    if unit.is_rate:
        return has_several_in_a_turn(words) or has_several_in_a_turn(given.sentence)
    is_moment = {bool(_MOMENT.search(text)) for text in (unit.text, given.unit.text)}
    return len(is_moment) > 1 or bool(_STRESS.search(words)) is not bool(_STRESS.search(given.sentence))


def _readings(unit: WordedUnit, given: _Given) -> tuple[float, ...]:
    """Return by what a rate in 1/s may be off: it counts radians, or revolutions."""
    signs = {unit.text.replace(" ", ""), given.unit.text.replace(" ", "")}
    return (1.0, math.tau, 1 / math.tau) if unit.is_rate and signs & _BY_THE_SECOND else (1.0,)


def _is_slip(ratio: float, unit: WordedUnit, given: _Given, *, is_indexed: bool) -> bool:
    """Tell whether a value is off by what goes wrong in a conversion, and by no other factor."""
    factor, powers = unit.scale / given.unit.scale, (-2, -1, 0, 1, 2)
    if unit.is_rate:
        halves = (-1, 0, 1) if is_indexed else (0,)
        sizes = [60.0**a * math.tau**b * 2.0**c for a, b, c in product(powers, powers, halves)]
        sizes += [10.0**n for n in powers]
    else:
        tens = range(-_TENS, _TENS + 1)
        sizes = [factor**m * 10.0**n for m, n in product(powers, tens)]
        sizes += [60.0**a for a in powers]
    others = (size for size in sizes if not math.isclose(size, 1, rel_tol=_SAME))
    return any(math.isclose(ratio, size, rel_tol=_SLIP) for size in others)
