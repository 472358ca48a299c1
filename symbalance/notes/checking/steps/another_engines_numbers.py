"""Numbers of another engine than above: 4π·142/0.0016 for 4πT/V, where T and V have other values.

With words that name another engine, an exercise of its own or the number itself they are its data, and
its letters have them from there on. In a clause that only supposes, if γ were 60°, nothing is claimed.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from symbalance.document.formula import (
    Formula,
    Name,
    Number,
    Power,
    Product,
    Quotient,
    names,
    walk,
)
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.numbers_put_in import paired, without_unit
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.conversions import quantity_of
from symbalance.notes.checking.verdicts import CONDITION, PREMISE, UNDECIDED
from symbalance.notes.checking.words.case_words import clause_before
from symbalance.notes.checking.words.cases_named import (
    OF_ANOTHER_ENGINE,
    names_another_example,
    names_some_engine,
)
from symbalance.notes.checking.words.lists_of_data import sets_number
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

REACH = 120
"""Characters before a letter in which the thing is named that it is of."""
FEWEST = 2
"""Numbers of another engine that are put in together; one alone may be a slip."""
_ROUNDED = 0.03
"""By which a number may be off that is only rounded: 0.65 for 0.64."""
_SHIFTED = tuple(10.0**power for power in range(-6, 7))
_EXACT = 1e-3
"""To which a number of the page is put in as it stands, in any unit."""
_SMALLEST = 10
"""Numbers below this may count something or belong to the formula."""
_WITH_UNIT = re.compile(
    r"(?:\b(?:with|mit|avec|con|for|für|a|an|ein(?:er|em)?|une?)\s)(?:an?\s|ein(?:er|em)?\s|une?\s)?"
    r"([0-9]+(?:[.,][0-9]+)?)(?:&nbsp;|[\s~]|\\,)?(?:mm|cm|m|kg|g|rpm|min|N|kN|%)(?![A-Za-z])",
    re.IGNORECASE,
)
"""A size in words, which a letter may have from there on."""
_SUPPOSED = re.compile(
    r"(?<![A-Za-zäöü])(?:were|would|had\s+been|wären?|würden?)(?![A-Za-zäöü])|仮に", re.IGNORECASE
)
"""In a clause that speaks of what is not so: if γ were 60°."""
_DEMANDED = re.compile(
    r"(?<![A-Za-zäöü])(?:(?:we|one|you)\s+(?:need|require|must\s+have|demand|want)"
    r"|(?:fordern|verlangen|brauchen|benötigen)\s+wir|(?:wir|man)\s+(?:fordern|verlangt?|brauch(?:t|en)|benötig(?:t|en))"
    r"|il\s+faut(?:\s+que)?|on\s+(?:exige|demande)|se\s+(?:exige|requiere))"
    r"[\s$\\(]*$",
    re.IGNORECASE,
)
"""Right before an equation that somebody wants to be so."""
_RELATION_ABOVE = re.compile(r"[=≈][^\n]*\n")
"""A line of its own above, with a relation: its words say nothing of the next."""
_SUBJECT = re.compile(
    r"(?<![A-Za-z])(?:the|die|der|das)\s+(?P<kind>[\w-]+)\s+(?P<noun>[\w-]+)"
    r"\s+(?:is|was|ist|war|beträgt)[\s$]*$",
    re.IGNORECASE,
)
_RESULT_COLON = re.compile(r"[^,;.:=\n]{0,14}[:：][\s$\\(\[`]*")
"""Behind a datum, before what it comes to."""
_TEN = Number(Fraction(10))


def puts_another_engines_numbers_in(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return what 4π·142/0.0016 for 4πT/V is, where T and V have other numbers above; else None.

    All of them are other ones, two at least: with words that name another engine they are its data.
    Without such words it may be wrong.
    """
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    is_result = names(right) or isinstance(right, Number) or isinstance(left, Name)
    if is_result or quantity_of(chain.sides[k + 1], state.document) is not None:
        return None
    pairs = _numbers_for_letters(left, without_unit(right))
    others = {part.name: number for part, number in pairs}
    if not FEWEST <= len(others) == len(pairs) or not all(
        _is_another(*pair, knowledge) for pair in pairs
    ):
        return None
    shown = ", ".join(f"{plain_text(Name(name))} = {plain_text(node)}" for name, node in others.items())
    text = state.document.text
    words = clause_before(text, chain.start)
    if not names_another_example(words):
        return Decision(UNDECIDED, f"numbers of another case are put in, or wrong ones: {shown}")
    for name, node in others.items():
        state.definitions.define(name, node, chain, state.sections.case_end(chain.lines[0]))
    return Decision(PREMISE, f"another engine's numbers put in: {shown}")


def _is_another(letter: Name, number: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a number is none that a letter has above, in any unit, nor a slip of it."""
    known, put_in = number_of(letter, knowledge), number_of(number, knowledge)
    if not known or not put_in:
        return False
    definition = knowledge.definitions.get(letter.name)
    typed = walk(definition.node) if definition is not None else ()
    own = [known, *(each.value for each in typed if isinstance(each, Number))]
    return not any(_may_be_slip(float(each) / float(put_in)) for each in own if each)


def _numbers_for_letters(left: Formula, right: Formula) -> list[tuple[Name, Formula]]:
    """Return the letters of a product or quotient with the numbers that stand for them; none elsewhere.

    The numbers that both have are left out: 4 and π of 4πT/V and 4π·142/0.0016.
    """
    wanted, given = list(_factors(left)), _with_powers_of_ten(list(_factors(right)))
    pairs: list[tuple[Name, Formula]] = []
    for part, power in wanted:
        place = next((n for n, each in enumerate(given) if each == (part, power)), None)
        if place is None and isinstance(part, Name):
            place = next((n for n, (_, other) in enumerate(given) if other == power), None)
        if place is None:
            return []
        number, _ = given.pop(place)
        if isinstance(part, Name):
            pairs.append((part, number))
    return [] if given else pairs


def _factors(node: Formula, sign: int = 1) -> Iterator[tuple[Formula, Fraction]]:
    """Yield the factors of a formula with their exponents."""
    match node:
        case Product(factors=parts):
            for part in parts:
                yield from _factors(part, sign)
        case Quotient(numerator=above, denominator=below):
            yield from _factors(above, sign)
            yield from _factors(below, -sign)
        case Power(base=base, exponent=Number(value=exponent)) if names(base) or base != _TEN:
            yield base, sign * exponent
        case _:
            yield node, Fraction(sign)


def _with_powers_of_ten(factors: list[tuple[Formula, Fraction]]) -> list[tuple[Formula, Fraction]]:
    """Return factors with each power of ten as a part of the number before it."""
    whole: list[tuple[Formula, Fraction]] = []
    for part, power in factors:
        is_ten = isinstance(part, Power) or part == _TEN
        if is_ten and whole and whole[-1][1] == power:
            whole[-1] = (Product((whole[-1][0], part)), power)
        else:
            whole.append((part, power))
    return whole


def _may_be_slip(ratio: float) -> bool:
    """Tell whether one number may stand for another: rounded, or in another unit, by a power of ten."""
    return ratio < 0 or any(abs(ratio / shift - 1) < _ROUNDED for shift in _SHIFTED)


def as_number_of_another(state: JudgingState, chain: Chain, k: int) -> Decision | None:
    """Return that a letter has its number in another engine, which the words before name; or None."""
    head, value = chain.sides[0].node, chain.sides[-1].node
    if k or not isinstance(head, Name) or len(chain.relations) != 1 or names(value):
        return None
    text, line = state.document.text, chain.lines[0]
    words = clause_before(text, chain.start)
    behind = re.split(r"[.;,。；\n=$]", text[chain.end : chain.end + 30], maxsplit=1)[0]
    given = state.definitions.at(line).get(head.name)
    is_known = given is not None or any(p.names == {head.name} for p in state.definitions.premises)
    is_result = state.sections.is_consequence(chain)
    is_own = given is not None and not is_result and _is_by_its_own_data(state, chain, given)
    if not is_known or is_own:
        return None
    if is_result:
        is_open = _SUPPOSED.search(words) is not None
        return Decision(UNDECIDED, "supposed, and not so above") if is_open else None
    is_datum = given is not None and given.numeric and given.formula is None
    is_elsewhere = is_datum and given is not None and not state.sections.same_exercise(given.line, line)
    is_elsewhere = is_elsewhere or (given is not None and _has_another_subject(state, chain, given.line))
    if is_elsewhere or names_another_example(words) or names_another_example(behind):
        has_formula = given is not None and not given.numeric and given.formula is None
        if given is None or not has_formula or given.solved:  # a formula is as good there
            state.definitions.forget_all(head.name)
            state.definitions.define(head.name, value, chain)
        return Decision(PREMISE, OF_ANOTHER_ENGINE)
    is_below = given is not None and given.line < state.sections.paragraph_start(line)
    if is_below and names_some_engine(words):
        return Decision(UNDECIDED, "of the engine above it is another number: say which is meant")
    return None


def _is_by_its_own_data(state: JudgingState, chain: Chain, given: Definition) -> bool:
    """Tell whether a letter's number is the result of data of its own case, by a formula of the page.

    The case gives anew all that the one before gave for it, or it stands right behind its datum and a
    colon: with the lighter piston, m = 0.4 kg: F = 4000 N. So does a case in one sentence, in the second
    case r = 50 mm, A = 10000 mm², and what still has the number that was printed for other data.
    """
    formula = given.node if given.formula is None else given.formula
    if not names(formula):
        return False
    line = chain.lines[0]
    values = {name: d.node for name, d in state.definitions.at(line).items()}
    behind = {*names_behind(formula, values)}
    if state.cases.gives_all_anew(behind, line) or _is_by_data_of_sentence(state, chain, behind):
        return True
    before = [c for c in state.sections.chains_on(line) if c.end <= chain.start]
    if given.is_coefficient and any(not names(c.sides[-1].node) for c in before):
        return True  # of a series, by the ratio that is given beside it
    last = max(before, key=lambda c: c.end, default=None)
    if last is None or not isinstance(last.sides[0].node, Name) or names(last.sides[-1].node):
        return False
    between = state.document.text[last.end : chain.start]
    return last.sides[0].node.name in behind and _RESULT_COLON.fullmatch(between) is not None


def _is_by_data_of_sentence(state: JudgingState, chain: Chain, behind: set[str]) -> bool:
    """Tell whether the sentence of a result gives anew all that its formula comes down to.

    Where it speaks of another case of the same thing and repeats the printed result, one datum will do.
    """
    sentence, known = state.sections.sentence_before(chain), state.definitions.at(chain.lines[0])
    first = chain.start - len(sentence)
    own = {c.sides[0].node for c in state.sections.chains_between(first, chain.start) if sets_number(c)}
    data = {n for n in behind if n in known and known[n].numeric and known[n].formula is None}
    if not any(Name(n) in own for n in data) or not all(n in known for n in behind):
        return False
    head, value = chain.sides[0].node, chain.sides[1].node
    printed = state.results.numbers.get(head.name, (0, []))[1] if isinstance(head, Name) else []
    is_stale, is_case = value in printed, _CASE_OF_IT.search(sentence) is not None
    if all(Name(n) in own for n in data):
        return is_stale or is_case
    return is_stale and is_case


_CASE_OF_IT = re.compile(
    r"(?<![^\W\d_])(?:cases?|instead|f[aä]ll\w*|stattdessen|statt\s?dessen|cas|au\s+lieu|caso|casi|casos|invece|en\s+cambio"
    r"|new\s+values?|trials?|tests?|neue[nr]?\s+werte?n?|versuch\w*|nouvelles?\s+valeurs?|essais?|nuovi?o?\s+valor[ei]|prova"
    r"|nuevos?\s+valor(?:es)?|ensayo)(?![^\W\d_])|場合|代わりに|新しい値",
    re.IGNORECASE,
)
"""Words for another case of the same thing, whose formulas are the same."""


def _has_another_subject(state: JudgingState, chain: Chain, line: int) -> bool:
    """Tell whether a letter is that of two things by their sentences: the gas force, the drag force."""
    text = state.document.text
    now = _SUBJECT.search(text, max(0, chain.start - REACH), chain.start)
    above = [c for c in state.sections.chains_on(line) if c.sides[0].node == chain.sides[0].node]
    matches = (_SUBJECT.search(text, max(0, c.start - REACH), c.start) for c in above if c is not chain)
    before = [match for match in matches if match is not None]
    return now is not None and any(
        match["noun"].lower() == now["noun"].lower() and match["kind"].lower() != now["kind"].lower()
        for match in before
    )


def as_number_in_words(state: JudgingState, chain: Chain, k: int) -> Decision | None:
    """Return that a letter has its number anew, with one that the words before give; or None."""
    head, value, text = chain.sides[0].node, chain.sides[1].node, state.document.text
    words = clause_before(text, chain.start)
    if k or not isinstance(head, Name) or names(value) or not _is_in_words(value, words):
        return None
    knowledge = state.knowledge(chain.lines[0])
    given = knowledge.definitions.get(head.name)
    formula = None if given is None else given.formula if given.numeric else given.node
    if formula is not None and not _puts_words_in(formula, value, words, knowledge):
        return None
    state.definitions.forget_all(head.name)
    state.definitions.define(head.name, value, chain)
    return Decision(PREMISE, "with a number that the words before it give")


def _is_in_words(value: Formula, words: str) -> bool:
    """Tell whether words give a number that is put in: with a 150 mm rod n = 150/39.5."""
    numbers = [part for part in walk(value) if isinstance(part, Number)]
    if value in numbers:
        return False
    typed = {number.value for number in numbers if abs(number.value.numerator) >= _SMALLEST}
    return any(Fraction(match[1].replace(",", ".")) in typed for match in _WITH_UNIT.finditer(words))


def _puts_words_in(formula: Formula, value: Formula, words: str, knowledge: Knowledge) -> bool:
    """Tell whether an arithmetic is a letter's formula with numbers of the words or of the page."""
    pairs = paired(formula, without_unit(value))
    for part, number in pairs or ():
        known, put_in = number_of(part, knowledge), number_of(number, knowledge)
        if isinstance(number, Number) and _is_in_words(Product((number, number)), words):
            continue
        if not known or not put_in:
            return False
        if not any(abs(float(known) / float(put_in) / shift - 1) < _EXACT for shift in _SHIFTED):
            return False
    return bool(pairs)


def as_supposed(state: JudgingState, chain: Chain, k: int) -> Decision | None:
    """Return that a relation refuted by lines above is one of a clause that only supposes; or None.

    A step from a formula to its value supposes nothing, nor does a line that was ended before. What is
    demanded, we need ω_p = n ω, fixes a letter that stands nowhere above.
    """
    text = state.document.text
    words = clause_before(text, chain.start)
    if not k and len(chain.relations) == 1 and _DEMANDED.search(words):
        above = (c.letters for c in state.document.chains if c.end <= chain.start)
        if chain.letters.difference(*above):
            return Decision(CONDITION, "demanded by the words before it, to be solved")
    if k or _RELATION_ABOVE.search(words) or _SUPPOSED.search(words) is None or not chain.letters:
        return None
    return Decision(UNDECIDED, "supposed, and not so above")


def leave_products_of_another(state: JudgingState, chain: Chain, k: int) -> bool:
    """Forget m r = 20 of engine A before m r = 0.6·44 of engine B; tell if there was such an equation."""
    left, right = chain.sides[0].node, chain.sides[1].node
    text, own = state.document.text, names(left)
    words = clause_before(text, chain.start)
    if k or isinstance(left, Name) or names(right) or not own or not names_another_example(words):
        return False
    rest = [p for p in state.definitions.premises if p.names != own]
    is_known = len(rest) < len(state.definitions.premises)
    state.definitions.premises = rest
    return is_known
