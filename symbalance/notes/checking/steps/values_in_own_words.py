"""The values that a relation's own words give the letters behind it: at bottom dead centre, | 6000 rpm |.

Its sentence, what stands right behind it, its row of a table and its heading are looked at, the nearest
first. What a line says further on, of the letter itself, counts before words that stand above that line.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from math import isclose, pi

from symbalance.document.formula import Constant, Formula, Name, Number, Product, Quotient, names
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.letters_in_waves import letters_in_waves
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.declared.symbol_roles import role_of
from symbalance.notes.checking.meant.engine_speeds import speeds_of
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.another_case import whole_degrees
from symbalance.notes.checking.steps.dead_centres import angle_of_crank
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.scaled_in_words import changes_in, is_of_kind
from symbalance.notes.checking.steps.sizes_in_sentences import letters_of_size
from symbalance.notes.checking.steps.sizes_without_letters import LETTERS
from symbalance.notes.checking.steps.values_on_ranges import value_on_own_range
from symbalance.notes.checking.units.own_units import is_angular_speed
from symbalance.notes.checking.words.case_words import ENGINE, engine_of
from symbalance.notes.checking.words.crank_places import crank_places
from symbalance.notes.checking.words.glossary import glossary_of
from symbalance.notes.checking.words.labels_of_cases import without_comparisons
from symbalance.notes.checking.words.lists_of_data import sets_number
from symbalance.notes.checking.words.places_in_words import last_place
from symbalance.notes.checking.words.sizes_of_page import sizes_of_page
from symbalance.notes.checking.words.sizes_said import SizeSaid, sizes_in_words
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_USUAL_ANGLES = ("theta", "vartheta", "phi", "varphi", "alpha", "psi")
_COUNTS = ("N", "n", "z", "Z", "i", "n_c", "N_c", "n_z")
"""Letters that count the cylinders on most pages."""
_MOST = 24
"""Cylinders of an engine; n = 6500 is its speed."""
_NEARLY = 0.01
"""By how much a speed as a page rounds it differs from the same speed, 314 from 3000 rpm, at most."""
_ANGULAR = ("rad/s", "1/s", "s⁻¹")
_CHANGED = re.compile(
    r"(?<![^\W\d_])(?:raised|increased|lowered|reduced|changed|set|rises?|rose|falls?|fell|goes|drops?|dropped|grows?)\s+(?:up\s+|down\s+)?to\s+$"
    r"|(?<![^\W\d_])(?:auf|portée?|réduite?\s+à|augmentée?\s+à|passe\s+à|aumenta\w*\s+[aà]|portat[ao]\s+a|ridott[ao]\s+a|elevad[ao]\s+a|reducid[ao]\s+a)\s+$",
    re.IGNORECASE,
)
"""Words before what a size is changed to."""
_BEHIND = re.compile(
    r"[\s$)\]}~]*(?:\(|(?:at|for|with|when|bei|beim|im|am|für|mit|à|au|pour|avec|per|con|para|al|a)\s)"
    r"(?P<words>(?:[^.,;:!?。、=$()\n]|[.,](?=[0-9])){2,60})"
)
"""Words right behind a relation that say of what it is; with a capital they begin what is said next."""
_MADE = re.compile(
    r"doubl(?:e|es|ed|ing|é\w*|ant)$|doubled|halv|tripled|tripl\w+|quadrupled|verdoppel|halbier|verdreifach|vervierfach|doubl[ée]|raddoppi|dimezz|dupli"
    r"|(?:[2-4２-４二三四]倍|半分)",
    re.IGNORECASE,
)
"""Words by which something is made a multiple of itself."""
_COMPARED = re.compile(
    r"(?<![^\W\d_])(?:than|exceed\w*|als|que|di|over|above|more)(?![^\W\d_])", re.IGNORECASE
)
_DIFFERENT = re.compile(
    r"(?<![^\W\d_])(?:different|unequal|unlike|verschieden\w*|ungleich\w*|unterschiedlich\w*|différent\w*|inégal\w*|divers[aeio]"
    r"|disugual\w*|diferentes|distint[ao]s|desiguales)(?![^\W\d_])"
    r"(?!\s+(?:ways?|methods?|forms?|notations?|signs?|units?|shafts?|steps?|approach\w*|letters?|places?|Weisen?|Wegen?|Wellen?|Formen"
    r"|Einheiten|manières?|façons?|formes?|modi|formas?|maneras?)(?![^\W\d_]))|異なる",
    re.IGNORECASE,
)
_FINITE = re.compile(
    r"(?<![^\W\d_])(?:finite(?:ly)?|endlich\w*|fini[es]?|longueur\s+finie|finit[ao]|lunghezza\s+finita)(?![^\W\d_])|有限",
    re.IGNORECASE,
)
_ENDS = (".", "!", "?", ";", "。")
_PLACE = re.compile(
    r"\w+\s+(?:dead[\s-]\w+|Tot(?:punkt|lage)\w*)|[^0-9,.]{0,20}[0-9]+\s?\$?(?:°|\^\{?\\circ\}?|degrees?|Grad|度)|[^\s:,、で]+",
    re.IGNORECASE,
)
"""A place as words name it."""
_HERE = re.compile(
    r"(?<![^\W\d_])(?:but|here|aber|hier|mais|ici|pero|aquí|ma|qui)(?![^\W\d_])|ここ", re.IGNORECASE
)
"""Words that leave the case which a sentence has supposed."""
_MORE = {
    "mass": re.compile(
        r"(?<![^\W\d_])(?:heavier|lighter|schwerere?[nrsm]?|leichtere?[nrsm]?|plus\s+(?:lourd|lég)\w*|más\s+(?:pesad|liger)\w+"
        r"|più\s+(?:pesant|legger)\w+)(?![^\W\d_])|(?:より)?重い|(?:より)?軽い",
        re.IGNORECASE,
    ),
    "speed": re.compile(
        r"(?<![^\W\d_])(?:(?:higher|lower|greater)\s+(?:engine\s+)?speeds?|faster|slower|(?:höhere|niedrigere)[nrm]?\s+Drehzahl"
        r"|(?:régime|vitesse)\s+plus\s+\w+|velocità\s+più\s+\w+|(?:mayor|menor)\s+velocidad)(?![^\W\d_])|高い回転|低い回転",
        re.IGNORECASE,
    ),
}
"""Comparatives, by the kind of quantity that is another one."""
_ROW = re.compile(r"[ \t]*\|")
_ANGLE_CELL = re.compile(r"(?<=\|)[\s$]*(?P<angle>[0-9]{1,3}[\s$]?(?:°|\^\{?\\circ\}?))[\s$]*(?=\|)")
"""A cell of a table that is an angle and nothing else."""
_REACH = 60
"""Characters beside a count in which its cylinders are named."""


@dataclass(frozen=True, slots=True)
class ValueSaid:
    """What words give letters, all of them at once, and the words."""

    values: dict[str, Formula]
    words: str


@dataclass(frozen=True, slots=True)
class _Words:
    """Words of a relation, and where they begin on the page."""

    text: str
    start: int


def values_in_own_words(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> list[list[ValueSaid]]:
    """Return what a relation's words give the letters behind it, by kind, other than the lines above.

    None of a kind of which the words, the last ones, name what the lines above have.
    """
    values = _nodes(knowledge)
    sides = [side.node for side in chain.sides[k : k + 2]]
    behind = {n for node in sides for n in names_behind(node, values)}
    numbers = {n for n in behind & values.keys() if not names(values[n])}
    turning = {
        n
        for node in (*sides, *(values[m] for m in behind & values.keys()))
        for n in letters_in_waves(node)
    }
    found: list[list[ValueSaid]] = []
    for kind in (_angles, _speeds, _counts, _sizes_changed, _sizes_named, _multiples):
        for words in _words_of(state, chain):
            earlier = {n for n in numbers if _place_of(state, knowledge, n) < words.start}
            own = earlier & turning if kind is _angles else earlier
            said = list(kind(state, chain, words, own, knowledge)) if own else []
            if said:
                is_again = any(_is_again(each, knowledge) for each in said)
                found += [] if is_again else [said]
                break
    beside = [*_given_beside(state, chain, k, behind, knowledge)]
    beside += _on_ranges(state, chain, k, behind, knowledge)
    return found + [[said] for said in beside]


def before_it(state: JudgingState, chain: Chain, knowledge: Knowledge) -> Knowledge:
    """Return what is known before a relation, without what it gives its own letter."""
    head = chain.sides[0].node
    own = knowledge.definitions.get(head.name) if isinstance(head, Name) else None
    if own is None or not isinstance(head, Name) or not chain.start <= own.node.span[0] < chain.end:
        return knowledge
    entries = [e.definition for e in state.definitions.values.get(head.name, ())]
    earlier = [d for d in entries if not chain.start <= d.node.span[0] < chain.end]
    formulas = [d for d in earlier if names(d.node)]
    definitions = {n: d for n, d in knowledge.definitions.items() if n != head.name}
    if not earlier:  # the formula that its number has replaced
        above = [c for c in state.sections.chains_above(head, chain.start) if names(c.sides[1].node)]
        formulas = [
            Definition(c.sides[1].node, c.lines[0])
            for c in above
            if c.sides[1].span[0] not in state.refuted and head.name not in names(c.sides[1].node)
        ]
    if formulas or earlier:
        definitions[head.name] = (formulas or earlier)[-1]
    return replace(knowledge, definitions=definitions)


def _nodes(knowledge: Knowledge) -> dict[str, Formula]:
    """Return what letters are by the lines above: the formula of one that has a formula and a number."""
    return {
        name: d.node if d.formula is None or not d.numeric else d.formula
        for name, d in knowledge.definitions.items()
    }


def _words_of(state: JudgingState, chain: Chain) -> Iterator[_Words]:
    """Yield the words that may say of what a relation is, the nearest first."""
    sections, text, line = state.sections, state.document.text, chain.lines[0]
    first = sections.start_of_line(line)
    if _ROW.match(text, first):
        end = sections.start_of_line(line + 1) - 1
        row = _without_formulas(state, first, end, chain)
        angles = [*_ANGLE_CELL.finditer(row)]
        yield _Words(f"{row} at {angles[0]['angle']}" if len(angles) == 1 else row, first)
    else:
        sentence = sections.sentence_before(chain)
        if not sentence.strip(" \t\n$\\([{&"):
            sentence = sections.sentence_leading_to(chain)
            sentence = "" if sentence.rstrip().endswith(_ENDS) else sentence
        start = text.rfind(sentence, 0, chain.start)  # marks of a formula may stand behind it
        behind = _BEHIND.match(text, chain.end)
        if behind is not None:
            yield _Words(f"at {behind['words']}", start)
        start = max(start, 0, *_ends_of_values_at_places(state, start, chain))
        yield _Words(_without_formulas(state, start, chain.start, chain), start)
    heading = sections.heading_above(line)
    if heading:
        yield _Words(heading.lstrip("#=* "), sections.start_of_line(sections.section_start(line)))


def _ends_of_values_at_places(state: JudgingState, start: int, chain: Chain) -> list[int]:
    """Return where formulas of a sentence end that its words place: at TDC s_0 = 250, so x = s_0 - s.

    The letter with its index is the value there of the letter without, which stands beside it; the place
    is that of the one and not of the other.
    """
    before = (c for c in state.sections.chains_between(max(start, 0), chain.start) if c.relations)
    heads = ((c.end, c.sides[0].node) for c in before if "_" in "".join(names(c.sides[0].node)))
    return [
        end
        for end, head in heads
        if isinstance(head, Name) and {head.name, head.name.partition("_")[0]} <= chain.letters
    ]


def _without_formulas(state: JudgingState, start: int, end: int, chain: Chain) -> str:
    """Return a part of the page in English, with a sign for each of its relations."""
    words, place = list[str](), start
    for other in state.sections.chains_behind(start - 1):
        if other.start >= end:
            break
        words += [state.document.text[place : other.start], " = "]
        place = max(place, other.end)
    words.append(state.document.text[place:end])
    english = glossary_of(state.document.text).english("".join(words))
    return without_comparisons(english)


def _place_of(state: JudgingState, knowledge: Knowledge, name: str) -> int:
    """Return where the page gives a letter the value that is in force."""
    definition = knowledge.definitions[name]
    return definition.node.span[0] or state.sections.start_of_line(definition.line + 1) - 1


def _is_again(said: ValueSaid, knowledge: Knowledge) -> bool:
    """Tell whether words name the value of a letter that is in force, to the digits of a speed."""
    for name, node in said.values.items():
        sizes = [number_of(each, knowledge) for each in (node, knowledge.definitions[name].node)]
        if None not in sizes and isclose(*map(float, sizes), rel_tol=_NEARLY, abs_tol=1e-9):
            return True
    return False


def _on_ranges(
    state: JudgingState, chain: Chain, k: int, behind: set[str], knowledge: Knowledge
) -> Iterator[ValueSaid]:
    """Yield the values of letters on the range that a relation is about, and are not in force."""
    for name in sorted(behind & knowledge.definitions.keys()):
        value = value_on_own_range(state, chain, k, name, knowledge)
        if value is not None and value[0] is not None:
            yield ValueSaid({name: value[0]}, value[1].words)


def _given_beside(
    state: JudgingState, chain: Chain, k: int, behind: set[str], knowledge: Knowledge
) -> Iterator[ValueSaid]:
    """Yield what a relation's own row of a table, or a case its sentence opens, gives a letter.

    The lines above give the letter another value, which is the one in force.
    """
    sections, line, text = state.sections, chain.lines[0], state.document.text
    first = sections.start_of_line(line)
    if _ROW.match(text, first):
        beside = [c for c in sections.chains_on(line) if c.start != chain.start and sets_number(c)]
    else:
        first = chain.start - len(sections.sentence_before(chain))
        before = sections.chains_between(first, chain.start)
        cases = (c for c in before if len(c.relations) == 1 and sections.opens_case(c))
        beside = [c for c in cases if not _HERE.search(text, c.end, chain.start)]
    for giver in beside:
        head, value = giver.sides[0].node, giver.sides[1].node
        if not isinstance(head, Name) or head.name not in behind & knowledge.definitions.keys():
            continue
        if head == chain.sides[0].node:
            continue  # of the same letter: for 60° d = 60°, for 72° d = 36°
        own = knowledge.definitions[head.name]
        is_above = _place_of(state, knowledge, head.name) < first
        said = ValueSaid({head.name: value}, text[giver.start : giver.end].strip(" $"))
        if (
            head.name not in names(value)
            and is_above
            and own.node != value
            and not _is_again(said, knowledge)
        ):
            yield said


def _angles(
    state: JudgingState, chain: Chain, words: _Words, names_given: set[str], knowledge: Knowledge
) -> Iterator[ValueSaid]:
    """Yield the crank angle that words name last: at bottom dead centre, at 90° after TDC."""
    place = last_place(words.text)
    counted = crank_places(words.text)[-1:]
    if place is None and not counted:
        return
    crank = angle_of_crank(state, chain.lines[0], knowledge)
    angles = {
        n
        for n in names_given
        if (n == crank if crank else n in _USUAL_ANGLES)
        and (
            whole_degrees(knowledge.definitions[n].node) is not None
            or number_of(knowledge.definitions[n].node, knowledge) == 0
        )
    }
    if len(angles) != 1:
        return
    (name,) = angles
    if counted and (place is None or counted[0].start >= place.start - _REACH):
        turn = Product((Number(counted[0].degrees / 180), Constant("pi")))
        yield ValueSaid({name: turn}, counted[0].words)
    elif place is not None and place.may_be_of(name, state.document.text):
        shown = _PLACE.match(words.text, place.start)
        yield ValueSaid({name: place.angle}, shown[0].strip(" $") if shown else words.text)


def _speeds(
    state: JudgingState, chain: Chain, words: _Words, names_given: set[str], knowledge: Knowledge
) -> Iterator[ValueSaid]:
    """Yield what the engine speeds in words give n and ω: at 6000 rpm, bei 600 rad/s.

    A letter with an index that has none of the page's speeds is a natural frequency, or of a mode.
    """
    names_given = {n for n in names_given if not _is_of_a_mode(state, n, knowledge)}
    for name in names_given:
        typed = [
            e.definition for e in state.definitions.values.get(name, ()) if e.definition.node.span[1]
        ]
        if typed and not knowledge.definitions[name].node.span[1]:  # by its unit as the page has it
            knowledge = knowledge.with_definition(name, typed[-1])
    for speed in sorted(speeds_of(words.text)):
        said = SizeSaid(f"{speed} rpm", Fraction(speed), "rpm")
        values = letters_of_size(said, names_given, state, knowledge)
        for name in values:
            node = knowledge.definitions[name].node
            size = number_of(node, knowledge)
            in_units = (speed, speed / 60, pi * speed / 30)
            if size is not None and any(isclose(float(size), n, rel_tol=_NEARLY) for n in in_units):
                values = {name: node}  # in whichever unit the page counts it
                break
        if values:
            yield ValueSaid(values, said.text)
        if rounded := _with_digits_of(state, values, speed, knowledge):
            yield ValueSaid(rounded, said.text)
    turning = {n for n in names_given if is_angular_speed(n, knowledge.meanings)}
    for said in sizes_in_words(words.text) if turning else ():
        if said.unit in _ANGULAR:
            yield ValueSaid({n: Number(said.number) for n in turning}, said.text)


def _is_of_a_mode(state: JudgingState, name: str, knowledge: Knowledge) -> bool:
    size = number_of(knowledge.definitions[name].node, knowledge) if "_" in name else None
    turns = [pi * other / 30 for other in state.speeds] + [other / 60 for other in state.speeds]
    return size is not None and not any(isclose(float(size), n, rel_tol=_NEARLY) for n in turns)


def _with_digits_of(
    state: JudgingState, values: dict[str, Formula], speed: int, knowledge: Knowledge
) -> dict[str, Formula]:
    """Return angular speeds as multiples of those in force: 628 from 314, where 3000 rpm are 314 1/s."""
    rounded: dict[str, Formula] = {}
    for name in values:
        node = knowledge.definitions[name].node
        size = number_of(node, knowledge)
        if size is None or not is_angular_speed(name, knowledge.meanings):
            continue
        for other in state.speeds:
            if isclose(float(size), pi * other / 30, rel_tol=_NEARLY) and other != speed:
                rounded[name] = Product((Number(Fraction(speed, other)), node))
    return rounded


def _counts(
    state: JudgingState, chain: Chain, words: _Words, names_given: set[str], knowledge: Knowledge
) -> Iterator[ValueSaid]:
    """Yield the number of cylinders that words name last, for the letter that counts them."""
    found = [*ENGINE.finditer(words.text)]
    engine = engine_of(found[-1]) if found else None
    if engine is None:
        return
    text = state.document.text
    for name in sorted(names_given & {*_COUNTS}):
        node = knowledge.definitions[name].node
        if not isinstance(node, Number) or node.value.denominator != 1 or not 0 < node.value <= _MOST:
            continue
        start, end = node.span
        beside = glossary_of(text).english(
            text[max(0, start - _REACH) : end + _REACH // 3].replace("$", "")
        )
        if re.search(r"cylinder|zylinder|シリンダ|気筒", beside, re.IGNORECASE):
            yield ValueSaid({name: Number(Fraction(engine[0]))}, found[-1][0])


def _sizes_changed(
    state: JudgingState, chain: Chain, words: _Words, names_given: set[str], knowledge: Knowledge
) -> Iterator[ValueSaid]:
    """Yield what a size is changed to by words: when the mass is raised to 0.8 kg."""
    for said in sizes_in_words(words.text):
        place = words.text.rfind(said.text)
        if _CHANGED.search(words.text[:place].rstrip("$ ") + " "):
            values = letters_of_size(said, names_given, state, knowledge)
            if len(values) == 1:
                yield ValueSaid(values, said.text)


def _sizes_named(
    state: JudgingState, chain: Chain, words: _Words, names_given: set[str], knowledge: Knowledge
) -> Iterator[ValueSaid]:
    """Yield the sizes that words give by their nouns: engine B has a stroke of 90 mm."""
    line, labels = chain.lines[0], state.labels_of_cases
    own = labels.at(chain.start, line) if labels.are_several else ""
    _, proposed = state.meant.words.sizes(line)
    for role, size in sizes_of_page(words.text).items():
        for name in sorted(names_given & {*LETTERS[role]}):
            place = _place_of(state, knowledge, name)
            label = labels.at(place, knowledge.definitions[name].line) if own else ""
            roles = {role_of(knowledge.meanings.get(name, "")), role_of(proposed.get(name, ""))}
            if role in roles or label not in ("", own):
                yield ValueSaid({name: size.number}, size.text)


def _multiples(
    state: JudgingState, chain: Chain, words: _Words, names_given: set[str], knowledge: Knowledge
) -> Iterator[ValueSaid]:
    """Yield the multiple that words make of a size: if the mass is doubled.

    A formula that has the factor itself is one of the size as it was.
    """
    factors = {part.value for side in chain.sides for part in _factors(side.node)}
    for change in changes_in(words.text):
        if not _MADE.search(change.words) or Fraction(change.factor) in factors:
            continue
        like = {n for n in names_given if is_of_kind(state, n, change.kind)}
        if len(like) == 1:
            (name,) = like
            number = Number(Fraction(change.factor).limit_denominator(12))
            yield ValueSaid({name: Product((number, knowledge.definitions[name].node))}, change.words)


def _factors(node: Formula) -> Iterator[Number]:
    """Yield the numbers that a side is a multiple of."""
    if isinstance(node, Product):
        for factor in node.factors:
            yield from _factors(factor)
    elif isinstance(node, Quotient):
        yield from _factors(node.numerator)
    elif isinstance(node, Number):
        yield node


def letters_said_otherwise(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Iterator[tuple[frozenset[str], str]]:
    """Yield letters that words give another value than lines above, without saying which, and the words.

    A heavier piston has another mass, a rod of finite length no ratio λ = 0, and two different discs
    not the same inertia.
    """
    definitions = knowledge.definitions
    sides = [side.node for side in chain.sides[k : k + 2]]
    behind = {n for node in sides for n in names_behind(node, _nodes(knowledge))}
    for name in sorted(behind & definitions.keys()):
        value = value_on_own_range(state, chain, k, name, knowledge)
        if value is not None and value[0] is None:
            yield frozenset({name}), f"over more than {value[1].words}"
    for words in _words_of(state, chain):
        given = {n for n in behind & definitions.keys() if _place_of(state, knowledge, n) < words.start}
        if _COMPARED.search(words.text):
            continue
        if (match := _DIFFERENT.search(words.text)) is not None:
            same = {n for n in given if _is_of_same_kind(n, definitions[n].node)}
            if same:
                yield frozenset(same), match[0]
        if (match := _FINITE.search(words.text)) is not None:
            zero = {n for n in given & {"lambda"} if number_of(definitions[n].node, knowledge) == 0}
            if zero:
                yield frozenset(zero), match[0]
        for kind, pattern in _MORE.items():
            match = pattern.search(words.text)
            like = {n for n in given if definitions[n].numeric and is_of_kind(state, n, kind)}
            if match is not None and like and _is_repeated(state, chain, k):
                yield frozenset(like), match[0]


def _is_of_same_kind(name: str, node: Formula) -> bool:
    """Tell whether a letter's value is a letter with another index: J_1 = J_2."""
    base, mark, _ = name.partition("_")
    return bool(mark) and isinstance(node, Name) and node.name.partition("_")[0] == base


def _is_repeated(state: JudgingState, chain: Chain, k: int) -> bool:
    """Tell whether a line above has the same value of the same formula."""
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    above = (c for c in state.document.chains if c.lines[0] < chain.lines[0] or c.end <= chain.start)
    pairs = ((a.node, b.node) for c in above for a, b in zip(c.sides, c.sides[1:], strict=False))
    return (left, right) in pairs
