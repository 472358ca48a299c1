"""A number that a page has once more, at another place: at n = 3000 ω = 314, and at n = 6000 ω = 314.

The letter had that number before, and would have it still. But other letters have other numbers since,
or words name another place, "at 60°" and "at 120°": a repetition proves nothing there. The number is
judged without the one before it, and is open where nothing else gives it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from symbalance.document.formula import Formula, Name, Number, names, with_parts_changed
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.premises.definitions import Entry
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import (
    CONDITION,
    DEFINITION,
    PREMISE,
    PROVED_WORDS,
    UNDECIDED,
    Verdict,
)
from symbalance.notes.checking.words.lists_of_data import sets_number
from symbalance.notes.checking.words.table_cells import cells_of
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_UNIT = (
    r"(?:°|\^\s?\{?\s?\\circ|度|Grad(?![^\W\d_])|degrees?|rpm|[U1r]\s?/\s?min|min⁻¹|rad|mm|cm|km"
    r"|m|ms|min|s|h|kg|g|kN|N|bar|Hz|kW|W|%)"
)
_AT = (
    r"(?<![^\W\d_])(?:at|for|after|before|in|with|bei|für|nach|vor|mit|à|après|pour|avec|dopo|per|con|después\s+de|para|tras)\s+"
    r"(?:an?\s+\w+\s+of\s+|einer?\s+\w+\s+von\s+)?"
)
_PLACE = re.compile(
    rf"(?:{_AT}[$\\(]{{0,3}}|(?=[0-9][0-9.,]*\s?{_UNIT}[^。]{{0,3}}(?:では|で|のとき|の場合)))"
    r"(?P<size>[0-9]+(?:[.,][0-9]+)?)[\s~$}]*(?:\\[,;: ]|\\(?:mathrm|text|unit)\s*\{)?"
    rf"(?P<unit>{_UNIT})(?![\w/])",
    re.IGNORECASE,
)
"""A place that words name by a number: at 60°, after 2 s."""
_ALSO = re.compile(
    r"(?<![^\W\d_])(?:also|again|too|still|likewise|once\s+more|equally|ebenfalls|ebenso|wieder|auch|gleichfalls|aussi|encore|également|de\s+nouveau"
    r"|anche|ancora|di\s+nuovo|también|otra\s+vez|de\s+nuevo|(?:it\s+)?(?:gives?|is|becomes?)|gibt|ergibt|ist|wird|donne|dà|da)(?![^\W\d_])|同じ|やはり|再び|も",
    re.IGNORECASE,
)
_ALSO_BEHIND = re.compile(
    r"[^.;。\n]{0,16}?(?<![^\W\d_])(?:as\s+well|too|again|likewise|ebenfalls|auch|aussi|également|anche|también)(?![^\W\d_])",
    re.IGNORECASE,
)
_CLAUSE = re.compile(r"(?<![0-9])[.!?;:](?=\s|$)|[。；：]|\n\s*\n|\n\s*[-*•|]")
"""What parts the words of one number from those of the number before."""
REACH = 80


def unless_said_again(
    state: JudgingState, chain: Chain, k: int, verdict: Verdict, judge_again: Callable[[], Verdict]
) -> Verdict:
    """Return a verdict; what only repeats a number given at another place is not proved by it."""
    head, value = chain.sides[0].node, chain.sides[k + 1].node
    is_number = not names(value) and bool(names(head)) and chain.relations[k].sign in ("=", "≈")
    if verdict.verdict not in PROVED_WORDS or not is_number or (chain.start, k) in state.told_by_words:
        return verdict
    before = _said_before(state, chain, value)
    moved = "" if before is None else _moved(state, before, chain)
    if before is None or not moved:
        return verdict
    with_others = _without_number(state, chain, value, judge_again)
    if with_others.verdict not in (DEFINITION, PREMISE, CONDITION):
        return with_others
    shown = f"the number of line {before.lines[0]}, {moved}"
    if _is_datum(state, before, chain):
        return describe(state.document, chain, k, Decision(PREMISE, f"as there: {shown}"))
    reason = f"{shown}: nothing says that it is the same here"
    return describe(state.document, chain, k, Decision(UNDECIDED, reason))


def _said_before(state: JudgingState, chain: Chain, value: Formula) -> Chain | None:
    """Return the last relation above in its section that gives what a relation begins with its number."""
    above = state.sections.chains_above(chain.sides[0].node, chain.start)
    given = next((c for c in reversed(above) if c.relations and not names(c.sides[-1].node)), None)
    if given is None or not state.sections.same_section(given.lines[0], chain.lines[0]):
        return None
    is_same = any(_is_number(side.node, value) for side in given.sides[1:])
    return given if is_same else None


def _is_number(node: Formula | None, value: Formula) -> bool:
    """Tell whether a formula is a number, however many digits of it are sure."""
    return node is not None and _bare(node) == _bare(value)


def _bare(node: Formula) -> Formula:
    """Return a formula whose numbers are taken for exact."""
    if isinstance(node, Number):
        return replace(node, last_place=None)
    return with_parts_changed(node, _bare)


def _without_number(
    state: JudgingState, chain: Chain, value: Formula, judge_again: Callable[[], Verdict]
) -> Verdict:
    """Return the verdict on a number without that number itself, as lines above have it."""
    head, definitions = chain.sides[0].node, state.definitions
    values, premises, conditions = definitions.values, definitions.premises, definitions.open_conditions
    printed = state.results.numbers
    definitions.values = {
        name: [*_without(entries, value, name, head)] for name, entries in values.items()
    }
    definitions.values = {name: entries for name, entries in definitions.values.items() if entries}
    behind = _behind(state, chain)
    definitions.premises = [
        p for p in premises if not _is_number(p.right, value) or not p.names <= behind
    ]
    definitions.open_conditions = {**conditions}
    own = names(head)
    state.results.numbers = {name: each for name, each in printed.items() if name not in own}
    try:
        return judge_again()
    finally:
        definitions.values, definitions.premises = values, premises
        definitions.open_conditions, state.results.numbers = conditions, printed


def _behind(state: JudgingState, chain: Chain) -> set[str]:
    """Return the letters of what a relation begins with, and of the formulas behind them."""
    known = state.knowledge(chain.lines[0]).definitions
    nodes = {n: d.formula or d.node for n, d in known.items()}
    own = {name for side in chain.sides for name in names(side.node)}
    return {*own, *(n for name in own for n in names_behind(Name(name), nodes))}


def _without(entries: list[Entry], value: Formula, name: str, head: Formula) -> Iterator[Entry]:
    """Yield what lines give a letter, without a number of its own, and of its formula if it has one."""
    for entry in entries:
        definition = entry.definition
        is_own = Name(name) == head
        if not is_own and (definition.node.span[1] or name not in names(head)):
            yield entry
        elif not is_own:
            continue  # solved for it: φ of cos φ = 0.5
        elif not (_is_number(definition.node, value) or _is_number(definition.rounded, value)):
            yield entry
        elif not _is_number(definition.node, value):
            yield replace(entry, definition=replace(definition, rounded=None))
        elif definition.formula is not None:
            formula = replace(definition, node=definition.formula, numeric=False, formula=None)
            yield replace(entry, definition=formula)


def _moved(state: JudgingState, before: Chain, chain: Chain) -> str:
    """Return what is another than it was where a number stood before, "" for nothing."""
    if (given := _number_given_anew(state, before, chain)) is not None:
        earlier, now = given
        shown = [" ".join(state.document.text[c.start : c.end].split()) for c in (earlier, now)]
        return f"which had {shown[0]}, and here is {shown[1]}"
    places = [_place_of(state, c) for c in (before, chain)]
    if places[0] and places[1] and places[0] != places[1]:
        return f"said at {places[0]}, and this at {places[1]}"
    return ""


def _number_given_anew(state: JudgingState, before: Chain, chain: Chain) -> tuple[Chain, Chain] | None:
    """Return what gave a letter its number before a relation, and before that of another place."""
    head, sections = chain.sides[0].node, state.sections
    knowledge = state.knowledge(chain.lines[0])
    nodes = {n: d.formula or d.node for n, d in knowledge.definitions.items()}
    formula = nodes.get(head.name) if isinstance(head, Name) else head
    behind = {*names_behind(formula, nodes)} if formula is not None and names(formula) else None
    cells = cells_of(state.document.text)
    cell, other = cells.at(chain.start), cells.at(before.start)
    if cell is not None and other is not None and chain.lines[0] == before.lines[0]:
        by_column = [_of_column(state, c) for c in (before, chain)]
        givers = ((by_column[0][n], g) for n, g in by_column[1].items() if n in by_column[0])
    else:
        first = sections.start_of_line(sections.paragraph_start(chain.lines[0]))
        between = sections.chains_between(max(before.end, first), chain.start)
        new = [c for c in between if sets_number(c) and c.sides[0].node != head]
        own = {c.sides[0].node: c for c in new}
        above = ((_last_number(state, node, before, c), c) for node, c in own.items())
        givers = ((old, c) for old, c in above if old is not None)
    for earlier, now in givers:
        is_other = earlier.sides[1].node != now.sides[1].node
        name = now.sides[0].node
        is_of_it = behind is None or (isinstance(name, Name) and name.name in behind)
        if is_other and is_of_it and not _is_number_of_case(state, earlier, before):
            return earlier, now
    return None


def _last_number(state: JudgingState, letter: Formula, before: Chain, now: Chain) -> Chain | None:
    """Return what gives a letter its number at a relation: before it, or behind it in its list."""
    above = [c for c in state.sections.chains_above(letter, now.start) if sets_number(c)]
    above = [c for c in above if state.sections.same_section(c.lines[0], before.lines[0])]
    earlier = [c for c in above if c.start < before.start]
    return earlier[-1] if earlier else above[0] if above else None


def _is_number_of_case(state: JudgingState, earlier: Chain, before: Chain) -> bool:
    """Tell whether a letter's earlier number was of a case that words had left."""
    return earlier in state.ended_cases and earlier.end <= before.start


def _of_column(state: JudgingState, chain: Chain) -> dict[str, Chain]:
    """Return the relations in a relation's column of its table that give letters numbers, above it."""
    cells = cells_of(state.document.text)
    own = cells.at(chain.start)
    found: dict[str, Chain] = {}
    if own is None or not own.column:
        return found
    first = state.sections.start_of_line(state.sections.paragraph_start(chain.lines[0]))
    for other in state.sections.chains_between(first, chain.start):
        cell, head = cells.at(other.start), other.sides[0].node
        if cell is None or not cell.column or not isinstance(head, Name) or not sets_number(other):
            continue
        if cell.labels[0].span == own.labels[0].span:
            found[head.name] = other
    return found


def _place_of(state: JudgingState, chain: Chain) -> str:
    """Return the place that the words right before a relation name by a number, "" for none."""
    text, last = state.document.text, state.sections.chain_before(chain.start)
    first = max(chain.start - REACH, 0 if last is None else last.end)
    words = _CLAUSE.split(text[first : chain.start])[-1]
    found = [*_PLACE.finditer(words)]
    return f"{found[-1]['size']} {found[-1]['unit']}" if found else ""


def _is_datum(state: JudgingState, before: Chain, chain: Chain) -> bool:
    """Tell whether a number is one of the data of another thing: r = 40 mm of engine B too.

    A number "at n = 6000 rpm", one that follows, and one of which words say that it is so again are not.
    """
    text, sections = state.document.text, state.sections
    has_formula = sections.has_formula_above(chain.sides[0].node, chain.start)
    if has_formula or any(sections.is_consequence(c) for c in (before, chain)):
        return False
    first = max(before.end, chain.start - REACH)
    words = _CLAUSE.split(text[first : chain.start])[-1]
    last = sections.chain_before(chain.start)
    is_of_case = last is not None and last.start >= before.end and sections.opens_case(last)
    if is_of_case or _place_of(state, chain) or _ALSO_BEHIND.match(text, chain.end):
        return False
    return _ALSO.search(words) is None
