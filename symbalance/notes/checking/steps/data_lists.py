"""Data of an example that an equation above does not allow: With m = 0.4 kg, r = 40 mm, a = 85 mm.

An example has its own numbers, whatever equation stands above; only numbers that stand by themselves, or
that follow from something, claim that they fit. So a datum is open, with the lines it does not fit.
"""

from __future__ import annotations

from dataclasses import replace
from operator import attrgetter

from symbalance.document.formula import Name, Product, names
from symbalance.notes.checking.premises.another_prefix import ANOTHER_PREFIX, FEWEST_DIGITS
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.units_left_out_above import unless_unit_left_out
from symbalance.notes.checking.verdicts import CONTRADICTION, REFUTED, UNDECIDED, Verdict
from symbalance.notes.checking.words.lists_of_data import gives_number, stand_in_one_list
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

FEWEST = 3
"""Data in a row that make a list, whatever words open it."""
_NEAR = 60
"""Characters before a number in which the words are looked for that give it."""
_OPENS = re.compile(
    r"(?<![^\W\d_])(?:with|for|at|let|take|taking|given|has|have|mit|für|bei|hat|sei(?:en)?|avec|pour|soit|con|per|para|sea"
    r"|met|voor|dla|przy|med|för)[\s$\\(\[`*]*$|[:：][\s$\\(\[`*]*$",
    re.IGNORECASE,
)
_DIGITS = re.compile(r"[^0-9=]{0,8}(?P<digits>[0-9]+(?:[.][0-9]+)?)(?![0-9.,]*[0-9])")
_GIVES = re.compile(
    r"(?:(?<![^\W\d_])(?:with|if|mit|wenn|avec|si|con|se|med|met|przy)"
    r"|(?:^|[.;:,(]\s{1,3}|\n)(?:and\s|und\s)?(?:for|für|pour|per|para|voor|dla|för)"
    r"|(?:^|[.;:]\s{1,3}|\n)(?:an?|eine?)\s(?:[^\W\d_]{2,15}\s){1,3}(?:of|with|von|mit))[\s$\\(\[`*]{0,6}$",
    re.IGNORECASE,
)
"""Words that give the number right behind them, whatever it is above: if P = 75 kN."""
_ENDS = re.compile(r"[\s$)\\~}]{0,6}(?:[^\W\d_]{1,4}[\s$]{0,3})?(?:[.;。；](?![0-9])|$|\n\s*\n|,[\s$])")
"""What stands behind the last number of a sentence or clause: perhaps a unit, and the stop."""
_LISTED = re.compile(
    r"[\s$)\]\\,]{0,6}(?:[^\W\d_]{1,4}\s)?,?\s?(?:and|und|et|y|e|con|with|mit)[\s$(\[\\]{0,6}"
)
_AND = re.compile(r"[\s$)\]\\,]{0,6}(?:[^\W\d_]{1,4}\s)?(?:,|and|und|et|y|e|con|with|mit)[\s$(\[\\]{0,6}")


def open_if_datum(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a number of an example that contradicts an equation above is undecided."""
    if verdict.verdict == REFUTED and ANOTHER_PREFIX in (verdict.reason or ""):
        return unless_unit_left_out(state, chain, verdict)  # a slip of the unit, whatever the example
    is_against = verdict.verdict == CONTRADICTION or (
        verdict.verdict == REFUTED and (verdict.reason or "").startswith("does not satisfy")
    )
    if (is_against or verdict.verdict == REFUTED) and _is_given(state, chain, k):
        return _given_number(state, chain, verdict)
    if verdict.verdict == REFUTED and not k and (line := _line_of_datum(state, chain)) is not None:
        reason = f"given in a list of data, and line {line} gives another number: another case, or a slip"
        return replace(verdict, verdict=UNDECIDED, reason=reason, fix=None)
    if not is_against or not is_datum(state, chain, k):
        return verdict
    reason = (verdict.reason or "").removeprefix("contradicts ").removeprefix("does not satisfy ")
    reason = f"a number of an example, which does not fit {reason}: another case, or wrong"
    return replace(verdict, verdict=UNDECIDED, reason=reason, fix=None)


def _line_of_datum(state: JudgingState, chain: Chain) -> int | None:
    """Return the line above that gives a letter of a list of data a number which follows from nothing."""
    head = chain.sides[0].node
    if not isinstance(head, Name) or not state.cases.is_in_list_of_data(chain):
        return None
    known = state.definitions.at(chain.lines[0]).get(head.name)
    is_datum = known is not None and known.numeric and known.formula is None
    return known.line if known is not None and is_datum else None


def _given_number(state: JudgingState, chain: Chain, verdict: Verdict) -> Verdict:
    """Return that a number is given against what is known of its letter, which has it from here on."""
    head, line = chain.sides[0].node, chain.lines[0]
    digits = [
        _DIGITS.match(text) for text in (state.document.source(chain.sides[1].span), verdict.exact or "")
    ]
    typed, above = (match["digits"] if match else "" for match in digits)
    if typed == above and len(typed) >= FEWEST_DIGITS:
        reason = f"the number of the lines above {ANOTHER_PREFIX}"
        refuted = replace(verdict, verdict=REFUTED, reason=reason, fix=None)
        return unless_unit_left_out(state, chain, refuted)
    exact = f", {verdict.exact}" if verdict.exact else ""
    if isinstance(head, Name):
        state.definitions.forget_all(head.name)
        state.definitions.define(head.name, chain.sides[1].node, chain, state.sections.case_end(line))
    reason = f"given here, and the lines above have another value{exact}: another case, or one is wrong"
    return replace(verdict, verdict=UNDECIDED, reason=reason, fix=None)


def _is_given(state: JudgingState, chain: Chain, k: int, behind: frozenset[str] = frozenset()) -> bool:
    """Tell whether words right before a letter's number give it: with W = 2651 mm³ the stress is.

    What stands `behind` its formula may not be given beside it: with ω = 310 1/s, F = 1822 N is a result.
    """
    if k or not chain.inline or not _is_size(chain) or state.sections.is_consequence(chain):
        return False
    if _completes_product(state, chain):
        return False
    text = state.document.text
    if _GIVES.search(text[max(0, chain.start - _NEAR) : chain.start]):
        return True
    above = [c for c in state.sections.chains_on(chain.lines[0]) if c.end <= chain.start]
    last = max(above, key=lambda each: each.end, default=None)
    if last is None or _AND.fullmatch(text, last.end, chain.start) is None:
        return False
    behind |= _letters_behind(state, chain)
    return not (names(last.sides[0].node) & behind) and _is_given(state, last, 0, behind)


def _letters_behind(state: JudgingState, chain: Chain) -> frozenset[str]:
    """Return the letters of the formulas that lines above have for a letter."""
    above = state.sections.chains_above(chain.sides[0].node, chain.start)
    return frozenset(name for c in above for side in c.sides[1:] for name in names(side.node))


def _is_size(chain: Chain) -> bool:
    """Tell whether a chain does nothing but give a letter, or a product of letters, a number."""
    left = chain.sides[0].node
    is_product = isinstance(left, Product) and all(isinstance(f, Name) for f in left.factors)
    is_plain = len(chain.relations) == 1 and (is_product or isinstance(left, Name))
    return is_plain and not names(chain.sides[1].node)


def is_datum(state: JudgingState, chain: Chain, k: int) -> bool:
    """Tell whether a letter has its number in a list of data, or right behind "with" or "for"."""
    if k or not gives_number(chain) or _has_formula_above(state, chain):
        return False
    if _completes_product(state, chain):
        return False
    chains, text = state.sections.in_order, state.document.text
    place = next(n for n, each in enumerate(chains) if each is chain)
    first = last = place
    while (
        first
        and gives_number(chains[first - 1])
        and stand_in_one_list(chains[first - 1], chains[first], text)
    ):
        first -= 1
    while last + 1 < len(chains) and gives_number(chains[last + 1]):
        if not stand_in_one_list(chains[last], chains[last + 1], text):
            break
        last += 1
    start = chains[first].start
    opened = _OPENS.search(text[max(0, start - _NEAR) : start]) is not None
    count = last - first + 1
    return (opened and count > 1) or (count >= FEWEST and not state.sections.is_consequence(chain))


def _has_formula_above(state: JudgingState, chain: Chain) -> bool:
    """Tell whether a line of its section above has a formula for the letter: its number is a result."""
    same = state.sections.chains_above(chain.sides[0].node, chain.start)
    same = [c for c in same if state.sections.same_section(c.lines[0], chain.lines[0])]
    return any(names(each.sides[1].node) for each in same)


def _completes_product(state: JudgingState, chain: Chain) -> bool:
    """Tell whether a sentence ends with a letter whose product with those given before it stands above.

    Below m_c r_c = 2.1 kg m the m_c of "with r_c = 110 mm, m_c = 19.1 kg." is a result.
    """
    head, sections = chain.sides[0].node, state.sections
    ends = _ENDS.match(state.document.text, chain.end) is not None
    last = max(
        (c for c in sections.chains_on(chain.lines[0]) if c.end <= chain.start),
        key=attrgetter("end"),
        default=None,
    )
    if not ends or last is None or not isinstance(head, Name) or not isinstance(last.sides[0].node, Name):
        return False
    text = state.document.text
    opened = _OPENS.search(text, max(0, last.start - _NEAR), last.start)
    if opened is None or opened[0][:1] in ":：" or _LISTED.fullmatch(text, last.end, chain.start):
        return False  # data: with m_c = 2 kg and r_c = 50 mm
    pair = {head.name, last.sides[0].node.name}
    return any(
        isinstance(c.sides[0].node, Product)
        and names(c.sides[0].node) == pair
        and c.start < last.start
        and sections.same_section(c.lines[0], chain.lines[0])
        for c in sections.in_order
    )
