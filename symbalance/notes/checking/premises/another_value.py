"""A second value of a letter that has one: a new case, a condition, or a contradiction."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Cases,
    Formula,
    Integral,
    Name,
    Negative,
    Number,
    Product,
    Sum,
    Summation,
    names,
    walk,
)
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.letters_behind import letters_behind, names_behind
from symbalance.notes.algebra.sums import indexed_letters
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.equality import (
    REFUTED,
    UNDECIDED,
    Decision,
    decide_equality,
    without_dots,
)
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import decide, written_out
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.declared.symbol_roles import role_of
from symbalance.notes.checking.premises.another_prefix import ANOTHER_PREFIX, is_in_another_prefix
from symbalance.notes.checking.premises.cases_of_angles import case_of_angle
from symbalance.notes.checking.premises.definitions import Definitions
from symbalance.notes.checking.premises.impossible_values import outside_range
from symbalance.notes.checking.premises.premise_decisions import FAR, decide_by_premises, is_refused
from symbalance.notes.checking.premises.results_as_cases import is_led_to, refute_result
from symbalance.notes.checking.premises.system import Premise
from symbalance.notes.checking.verdicts import CONDITION, CONTRADICTION, DEFINITION, PREMISE
from symbalance.notes.checking.words.angles_of_time import is_time_of_angle
from symbalance.notes.checking.words.case_labels import are_labels_of_a_kind, label_beside
from symbalance.notes.checking.words.case_words import numbers_of_several, opens_case
from symbalance.notes.checking.words.lists_of_data import sets_number
from symbalance.notes.checking.words.plain_formulas import lone_side, plain_text
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

FEWEST_NEW = 2
"""Letters of a formula that make it one of another thing: x = y may be a claim."""
NEARLY = 0.1
"""Relative difference: a second value closer to the first is a slip, not a new case."""

MOST_GIVERS = 4
"""Relations above that give a letter its number, the last ones, that labels are compared with."""
NO_WORDS = "and no words say that it is another case"
ROUNDED = 0.05
"""Relative difference up to which a number may stand for one with more digits, where words say so."""


def define_anew(
    definitions: Definitions, name: str, value: Formula, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on another value of a defined letter: a new case, a condition, or None."""
    by_case = None if k else _of_its_own_case(definitions, name, value, chain, knowledge)
    by_case = by_case or (None if k else _as_other_angle(definitions, name, value, chain, knowledge))
    return by_case or _define_anew(definitions, name, value, chain, k, knowledge)


def _as_other_angle(
    definitions: Definitions, name: str, value: Formula, chain: Chain, knowledge: Knowledge
) -> Decision | None:
    """Return that an angle which an equation above forbids is another engine's, for γ = 52°."""
    line = chain.lines[0]
    by_case = case_of_angle(definitions, name, value, chain)
    if by_case is None or by_case.status != PREMISE:
        return None
    if not is_refused(decide_by_premises(definitions, Premise(Name(name), value, line), knowledge)):
        return None
    definitions.define(name, value, chain, definitions.sections.case_end(line))
    return by_case


def _define_anew(
    definitions: Definitions, name: str, value: Formula, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    earlier, line = knowledge.definitions[name], chain.lines[0]
    other = "" if k else _anew_at_its_place(definitions, name, value, chain, knowledge)
    has_letters = bool(names(value) or names(earlier.node))
    if has_letters and definitions.sections.names_another_case(chain, earlier.line):
        other = f"anew: in line {earlier.line} it was of another engine"
    if other:
        definitions.define(name, without_dots(value)[0], chain)
        return Decision(DEFINITION, other)
    by_premises = decide_by_premises(definitions, Premise(Name(name), value, line), knowledge)
    is_apart = _is_of_another_section(definitions, earlier, value, chain, knowledge)
    if by_premises is not None and not is_apart:
        outside = outside_range(definitions, name, value, line, knowledge)
        if by_premises.status == PREMISE and outside is None:
            definitions.define(name, value, chain)
        is_slip = _is_wrong_solution(earlier, value, by_premises, chain, k, knowledge)
        return None if is_slip else outside or by_premises  # a step says what it should be
    if earlier.solved and not is_apart and _each_has_own_letters(earlier.node, value, knowledge):
        contradiction = outside_range(definitions, name, value, line, knowledge)
        if contradiction is None:
            definitions.define(name, without_dots(value)[0], chain)
        return contradiction or Decision(PREMISE, f"beside line {earlier.line}")
    is_numbered = name.endswith(")") and not definitions.sections.same_section(earlier.line, line)
    reason = ""
    of_letters = names(earlier.node if earlier.formula is None else earlier.formula)
    if is_numbered or (of_letters and names(value) and _is_anew(definitions, earlier, chain)):
        reason = f"anew: in line {earlier.line} it was another one's"
    elif _is_exact_form(name, value, earlier, chain, k, knowledge):
        reason = f"exactly what line {earlier.line} has approximately"
    by_words = "" if reason else _said_by_words(value, earlier, chain, k, definitions, knowledge)
    if reason or by_words:
        definitions.define(name, without_dots(value)[0], chain)
        return Decision(DEFINITION, reason) if reason else Decision(PREMISE, by_words)
    if chain.relations[k].sign == "≈" and not k and names(earlier.node) and not names(value):
        condition = Premise(earlier.node, value, line, definitions.sections.case_end(line))
        turning = _turning_behind(name, earlier.node, knowledge)
        definitions.open_conditions |= dict.fromkeys(turning, condition)  # c ≈ 0.25, so θ ≈ 75.5°
    is_put_in = not names(value) and _has_number_put_in(definitions, earlier, line, knowledge)
    is_called_case = not definitions.sections.same_section(earlier.line, line)
    is_called_case = is_called_case and definitions.sections.opens_case(chain)
    is_number = not k and not names(value) and earlier.numeric
    is_datum = is_number and (
        (earlier.formula is None and definitions.sections.is_in_list_of_data(chain, earlier.line))
        or definitions.sections.is_in_another_row(chain, earlier.line)
    )
    sign = chain.relations[k].sign
    is_none = is_put_in or not _new_case(earlier, value, sign, knowledge, is_called_case=is_called_case)
    if is_none and not (is_datum or is_apart):
        return None
    return _define_case_anew(definitions, name, value, earlier, chain, knowledge)


def _zero_of_case(
    name: str, earlier: Definition, value: Formula, line: int, knowledge: Knowledge
) -> Decision | None:
    """Refute that a letter vanishes in a case of its own line, where its formula does not; else None.

    If ε = 1, then Y = 0: with Y = -ε F sin θ above it is -F sin θ there.
    """
    if value != Number(Fraction(0)):
        return None
    values = {n: d.node for n, d in knowledge.definitions.items()}
    behind = (knowledge.definitions.get(n) for n in names_behind(earlier.node, values))
    is_in_case = any(d is not None and d.numeric and d.line == line != earlier.line for d in behind)
    if not is_in_case or decide_equality(earlier.node, value, knowledge).status != REFUTED:
        return None
    shown = f"{plain_text(Name(name))} = {plain_text(earlier.node)} of line {earlier.line}"
    return Decision(REFUTED, f"{shown} does not vanish in the case of this line")


def _is_in_another_prefix(earlier: Definition, value: Formula) -> bool:
    """Tell whether a number is that of an earlier line, as printed there, with another prefix."""
    printed = [node for node in (earlier.rounded, earlier.node) if node is not None]
    return any(is_in_another_prefix(node, value) for node in printed)


def _of_its_own_case(
    definitions: Definitions, name: str, value: Formula, chain: Chain, knowledge: Knowledge
) -> Decision | None:
    """Define a number that is chosen, or a formula of a listed case, and return what it is."""
    earlier, line = knowledge.definitions[name], chain.lines[0]
    if _is_in_another_prefix(earlier, value):
        return None  # no choice: a slip of the unit
    is_chosen = not names(value) and definitions.sections.is_chosen(chain, earlier.line)
    if is_chosen and name not in knowledge.angles:
        if outside_range(definitions, name, value, line, knowledge) is not None:
            return None
        definitions.define(name, without_dots(value)[0], chain)
        return Decision(PREMISE, f"chosen: line {earlier.line} had another value")
    reason = ""
    if not names(value) and _is_rounded_choice(definitions, earlier, value, chain):
        reason = f"rounded: line {earlier.line} has more digits"
    elif _is_labelled_otherwise(definitions, name, earlier, value, chain):
        reason = f"another case than in line {earlier.line}, by its label"
    elif _heads_its_results(definitions, name, value, chain):
        reason = f"a new case: line {earlier.line} had another value"
    elif _is_of_another_in_its_sentence(definitions, name, value, chain):
        reason = f"of another than in line {earlier.line}: its sentence has both"
    elif value != earlier.node and _each_opens_its_case(definitions, name, value, chain):
        reason = f"another case than in line {earlier.line}: each opens one"
    elif _is_of_other_parity(definitions, name, chain):
        reason = f"another case than in line {earlier.line}: even, and odd"
    if reason:
        definitions.define(name, without_dots(value)[0], chain)
        return Decision(PREMISE, reason)
    case_end = _end_of_listed_case(definitions, earlier, chain)
    if case_end is None:
        return None
    definitions.define(name, without_dots(value)[0], chain, case_end)
    return Decision(DEFINITION, f"another case than in line {earlier.line}")


def _heads_its_results(definitions: Definitions, name: str, value: Formula, chain: Chain) -> bool:
    """Tell whether a number opens its sentence and leads to what follows from it, as another one does.

    x = 1: y = 3. x = 2: y = 5. So does a number after "but": but x = 5 gives z = 12.
    """
    sections = definitions.sections
    if names(value) or not sets_number(chain):
        return False
    text = sections.document.text
    opened = _OPENS_SENTENCE.fullmatch(sections.sentence_before(chain))
    if opened is None or sections.has_formula_above(Name(name), chain.start):
        return False
    if opened["but"] is not None and _GIVES.match(text, chain.end):
        return True
    before = [c for c in sections.chains_above(Name(name), chain.start) if sets_number(c)]
    return bool(before) and all(_COLON.match(text, c.end) for c in (chain, before[-1]))


_OPENS_SENTENCE = re.compile(
    r"[\s$*_(•-]*(?:(?P<but>but|aber|doch|mais|ma|però|pero|しかし)|and|now|next|finally|und|nun|et|enfin|e|ora|y|ahora|次に)?[\s$(,、]*",
    re.IGNORECASE,
)
"""What may stand before a number that opens its sentence."""
_COLON = re.compile(r"[\s$)]*[:：](?!=)")
_GIVES = re.compile(
    r"[\s$)]*(?:gives?|yields?|leads?\s+to|makes|means|would\s+give|ergibt|gibt|liefert|führt\s+auf|donne|conduit\s+à|dà|porta\s+a|da|lleva\s+a)"
    r"(?![^\W\d_])|[\s$]*(?:のとき|ならば|では)",
    re.IGNORECASE,
)
"""Words behind a number that lead to what follows from it."""


def _is_of_another_in_its_sentence(
    definitions: Definitions, name: str, value: Formula, chain: Chain
) -> bool:
    """Tell whether a sentence has two values of a letter, with words between that draw no conclusion.

    The long rod has q = 0.25, the short one q = 0.3: of one thing nobody says two in a breath. A formula
    may follow from the other one, unless both are conditions: A fires when u = a, B when u = a + b.
    """
    sections = definitions.sections
    before = sections.chains_above(Name(name), chain.start)
    start = chain.start - len(sections.sentence_before(chain))
    if not before or before[-1].start < start:
        return False
    text, end = sections.document.text, before[-1].end
    if names(value):
        return all(opens_case(text, c.start, c.end) for c in (before[-1], chain))
    if sections.is_consequence(chain) or _CONCLUDES.search(text, end, chain.start):
        return False
    behind = [_BEHIND.match(text, c.end) for c in (before[-1], chain)]
    if behind[0] and behind[1] and behind[0][1] == behind[1][1]:
        return False  # b = 17.8° for the 5.70 and b = 16.9° for the 5.70
    words = text[end : chain.start]
    for other in reversed(sections.chains_between(end, chain.start)):
        words = words[: other.start - end] + words[other.end - end :]
    points = sample_trees([before[-1].sides[1].node, value], SymbolValue(), 1)
    is_far = bool(points) and abs(points[0][1][0] - points[0][1][1]) > ROUNDED * abs(points[0][1][0])
    are_cases = all(opens_case(text, c.start, c.end) for c in (before[-1], chain))
    return (
        is_far
        and _WORD.search(words) is not None
        and (are_cases or _TWO_THINGS.search(words) is not None)
        and not any(names(c.sides[1].node) for c in before)  # its formula says which it has where
    )


_TWO_THINGS = re.compile(
    r"(?<![^\W\d_])(?:the\s+(?:other|second|larger|smaller|short|long|new|old)|(?:engine|motor|twin|cylinder|rod|piston|shaft)s?"
    r"|beim|der\s+(?:andere|zweite)|Motor|pour|l'autre|cel(?:ui|le)|while|whereas|während|tandis)(?![^\W\d_])"
)
"""Words between two numbers by which the second one is of another thing."""


_BEHIND = re.compile(
    r"\$?[ ]((?:for|of|with|at|für|bei|mit|pour|avec|à|per|con|para)[ ](?:[^\W_]+[ ])?[\w.]+)"
)
_WORD = re.compile(r"(?<![\\A-Za-z])[^\W\d_]{3,}|[\u3041-\u9fff]{2}")
_CONCLUDES = re.compile(
    r"(?<![^\W\d_])(?:that\s+is|i\.?\s?e\.|d\.?\s?h\.|das\s+heißt|c'est-à-dire|soit|cio[eè]|es\s+decir|also|or|oder|ou"
    r"|because|since|means|whence|hence|so|therefore|thus|damit|donc|daher|weil|folglich|quindi|perché|luego|porque|car"
    r"|rounded|about|say|gerundet|rund|etwa|environ|circa)(?![^\W\d_])|すなわち|つまり|約",
    re.IGNORECASE,
)
"""Words between two numbers that make the second one the first, told again."""


def _each_opens_its_case(definitions: Definitions, name: str, value: Formula, chain: Chain) -> bool:
    """Tell whether each of two formulas is a case itself: for M = a sin² φ, and for M = a cos² φ.

    So is each of two numbers, however near they are: at ρ = 0.9, and then at ρ = 1.
    """
    text = definitions.sections.document.text
    before = definitions.sections.last_above(Name(name), chain.start)
    if before is None or bool(names(value)) != bool(names(before.sides[1].node)):
        return False
    if not names(value):
        is_apart = _SENTENCE_BETWEEN.search(text, before.end, chain.start) is not None
        return is_apart and all(
            c.inline and sets_number(c) and _AT_NUMBER.search(text, max(0, c.start - _REACH), c.start)
            for c in (before, chain)
        )
    return all(
        len(c.relations) == 1 and _CASE_ITSELF.search(text, max(0, c.start - _REACH), c.start)
        for c in (before, chain)
    )


_REACH = 20
_MARK = re.compile(r"(?:^|\n)[ \t]*\(?[a-z0-9]{1,2}[.)][\s$]*$")
"""The mark of an item that begins with a formula: (a)."""
_ARITHMETIC = re.compile(r"\\(?:cdot|times|[dt]?frac|pi)(?![a-z])|[*×·+π]")
_SENTENCE_BETWEEN = re.compile(r"[.;!?]\s|[。；]")
_AT_NUMBER = re.compile(
    r"(?<![^\W\d_])(?:for|at|für|bei|pour|à|per|para|voor|bij)[\s$(\\]*$", re.IGNORECASE
)
_CASE_ITSELF = re.compile(r"(?<![^\W\d_])(?:for|if|für|bei|wenn|pour|si|per|para)[\s$(]*$", re.IGNORECASE)


def _is_of_other_parity(definitions: Definitions, name: str, chain: Chain) -> bool:
    """Tell whether words behind a value are of the other parity than those behind the one before it.

    h = N if N is even, and h = 2N if N is odd.
    """
    text = definitions.sections.document.text
    before = definitions.sections.chains_above(Name(name), chain.start)
    if not before:
        return False
    words = [_PARITY.search(text[c.end : c.end + _BEHIND_PARITY]) for c in (before[-1], chain)]
    kinds = {match.lastgroup for match in words if match is not None}
    return len(kinds) > 1


_BEHIND_PARITY = 40
_PARITY = re.compile(
    r"(?P<even>(?<![A-Za-z])(?:even|gerade[nrsm]?|pair|pari)(?![A-Za-z])|偶数)"
    r"|(?P<odd>(?<![A-Za-z])(?:odd|ungerade[nrsm]?|impair|dispari)(?![A-Za-z])|奇数)",
    re.IGNORECASE,
)


def _is_labelled_otherwise(
    definitions: Definitions, name: str, earlier: Definition, value: Formula, chain: Chain
) -> bool:
    """Tell whether labels give two numbers of a letter to two things, short rod: λ = …, long rod: …"""
    sections = definitions.sections
    above = sections.chains_above(Name(name), chain.start)
    if names(value) or (above and _is_next_step(sections.document.text, above[-1], chain)):
        return False
    if any(definitions.labelled_data.is_another(chain, before) for before in above[-MOST_GIVERS:]):
        return True
    is_result = sections.has_formula_above(Name(name), chain.start)
    if is_result and definitions.labelled_data.numbers_at(chain):
        return False  # what the data of its label give
    if not above or above[-1].lines[0] != earlier.line or names(above[-1].sides[1].node):
        return False
    if not sections.same_section(earlier.line, chain.lines[0]):
        return False
    text = sections.document.text
    labels = [label_beside(text, c.start, c.sides[1].span[1]) for c in (above[-1], chain)]
    ends = [label_beside(text, c.start, c.end) for c in (above[-1], chain)]
    return are_labels_of_a_kind(labels[0], labels[1]) or are_labels_of_a_kind(ends[0], ends[1])


def _is_next_step(text: str, before: Chain, chain: Chain) -> bool:
    """Tell whether an arithmetic stands at once behind one item's mark, and a number behind the next."""
    first, second = (text[slice(*c.sides[1].span)] for c in (before, chain))
    is_computed = _ARITHMETIC.search(first) is not None and not _ARITHMETIC.search(second)
    return is_computed and all(_MARK.search(text[max(0, c.start - 8) : c.start]) for c in (before, chain))


def _is_rounded_choice(
    definitions: Definitions, earlier: Definition, value: Formula, chain: Chain
) -> bool:
    """Tell whether a number stands, by its words, for one with more digits: 15947, say 16000."""
    if not definitions.sections.is_rounded_choice(chain):
        return False
    for node in (earlier.node, earlier.rounded):
        points = [] if node is None else sample_trees([node, value], SymbolValue(), 1)
        if points and abs(points[0][1][0] - points[0][1][1]) <= ROUNDED * abs(points[0][1][0]):
            return True
    return False


def _end_of_listed_case(definitions: Definitions, earlier: Definition, chain: Chain) -> int | None:
    """Return where an item of a list of cases ends whose formula another item has otherwise; or None."""
    sections = definitions.sections
    if sections.is_consequence(chain):
        return None
    own = sections.item_of_cases(chain.lines[0], chain.sides[0].span[0])
    if own is None:
        return None
    places = [
        item
        for other in sections.chains_on(earlier.line)
        if other.sides[0].node == chain.sides[0].node
        if (item := sections.item_of_cases(earlier.line, other.sides[0].span[0])) is not None
    ]
    is_case = any(first == own[0] for first, last in places)
    is_other = all(last < chain.lines[0] for first, last in places)
    return own[1] if is_case and is_other else None


def _is_at_another_place(
    definitions: Definitions, name: str, value: Formula, chain: Chain, knowledge: Knowledge
) -> bool:
    """Tell whether two values of a letter are each at a place of its own: a at TDC, then a at BDC.

    Only of values in which nothing turns: what is so at every angle is so at both.
    """
    earlier = knowledge.definitions[name].node
    turning = names(knowledge.crank.theta) if knowledge.crank is not None else frozenset[str]()
    for node in (earlier, value):
        calls = [p for p in walk(node) if isinstance(p, Call) and names(p.argument)]
        waves = any(call.function in ("sin", "cos") for call in calls)
        if waves or not names(node) or turning.intersection(_letters_behind([node], knowledge)):
            return False
    return definitions.sections.is_at_another_place(chain)


def _each_has_own_letters(earlier: Formula, value: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a second value fixes another letter: F_1 = -F_2, then F_1 = cos θ; or is a number."""
    first, second = (set(_letters_behind([node], knowledge)) for node in (earlier, value))
    return not second or bool(first - second and second - first)


def _anew_at_its_place(
    definitions: Definitions, name: str, value: Formula, chain: Chain, knowledge: Knowledge
) -> str:
    """Return why a formula is that of another thing with the same letter, "" if it is not."""
    line = knowledge.definitions[name].line
    if _is_at_another_place(definitions, name, value, chain, knowledge):
        return f"at another place than in line {line}"
    if _is_of_new_letters(definitions, name, value, chain, knowledge):
        return f"anew: of other letters than in line {line}"
    if names(value) and definitions.sections.is_of_another_body(chain, name):
        return f"of another body than in line {line}"
    is_elsewhere = _is_of_another_exercise(definitions, name, value, chain, knowledge)
    return f"anew: not what line {line} has" if is_elsewhere else ""


def _is_of_new_letters(
    definitions: Definitions, name: str, value: Formula, chain: Chain, knowledge: Knowledge
) -> bool:
    """Tell whether a formula is of two letters or more that all came up after a letter's last mention.

    A disc of mass M and radius R has J = M R²/2, whatever the J of the flywheel before was; where the
    next formula is M = 2 J/R², it is that J, and the disc's mass is asked for.
    """
    own, start, known = names(value), chain.sides[0].span[0], knowledge.definitions[name]
    if known.numeric and known.formula is None:
        return False  # E = 310 J, then what formula it has
    if len(own) < FEWEST_NEW or any(
        knowledge.has_meaning(n) and n not in knowledge.definitions for n in own
    ):
        return False
    if own & knowledge.meanings.keys() or definitions.sections.is_consequence(chain):
        return False
    chains = definitions.sections.document.chains
    below = [c for c in chains if c.sides[0].span[0] > start]
    below.sort(key=lambda c: c.sides[0].span[0])
    solved = below[0].sides[:2] if below and len(below[0].sides) > 1 else ()
    if solved and solved[0].node in [Name(n) for n in own] and name in names(solved[1].node):
        return False
    above = [c for c in chains if c.sides[0].span[0] < start]
    last = max((c.sides[-1].span[1] for c in above if name in c.letters), default=None)
    earlier = [c for c in above if last is None or c.sides[0].span[0] < last]
    used = frozenset[str]().union(*(c.letters for c in earlier))
    return last is not None and used.isdisjoint(own)


def _is_wrong_solution(
    earlier: Definition, value: Formula, by_premises: Decision, chain: Chain, k: int, knowledge: Knowledge
) -> bool:
    """Tell whether an equation was solved for a letter, and a formula is not what it comes to."""
    is_refused = by_premises.status in (CONTRADICTION, UNDECIDED)
    if not is_refused or not earlier.solved or earlier.numeric or not names(value):
        return False
    if isinstance(value, Name) or not names(earlier.node) or earlier.alternatives:
        return False
    bare, sign = without_dots(value)[0], chain.relations[k].sign
    return decide(lone_side(earlier.node), lone_side(bare), sign, knowledge).status == REFUTED


def _is_of_another_exercise(
    definitions: Definitions, name: str, value: Formula, chain: Chain, knowledge: Knowledge
) -> bool:
    """Tell whether a letter with a number has a formula of a new letter, and another number, elsewhere.

    The couple M = 485 N m of exercise 6 is not the torque M = P/ω = 40000/314 = 127 N m of exercise 10.
    """
    earlier, sections = knowledge.definitions[name], definitions.sections
    if not earlier.numeric or sections.same_exercise(earlier.line, chain.lines[0]):
        return False
    is_new = any(n not in knowledge.definitions and not knowledge.has_meaning(n) for n in names(value))
    if not is_new or sections.is_consequence(chain):
        return False
    numbers = [side.node for side in chain.sides[2:] if not names(side.node)]
    points = sample_trees([earlier.node, numbers[-1]], SymbolValue(), 1) if numbers else []
    return bool(points) and _is_far(*points[0][1])


def _is_far(old: complex, new: complex) -> bool:
    """Tell whether a second value is no slip of the first."""
    return abs(old - new) > NEARLY * max(abs(old), abs(new))


def _is_anew(definitions: Definitions, earlier: Definition, chain: Chain) -> bool:
    """Tell whether a second formula of a letter is of another engine, or in another exercise."""
    sections = definitions.sections
    if sections.headings_name_other_engines(chain.lines[0], earlier.line):
        return True  # what "so" ties it to stands in its own section
    if sections.is_of_another_cycle(chain, earlier.line):
        return True
    return not sections.is_consequence(chain) and sections.is_of_another_engine(chain, earlier.line)


def _said_by_words(
    value: Formula,
    earlier: Definition,
    chain: Chain,
    k: int,
    definitions: Definitions,
    knowledge: Knowledge,
) -> str:
    """Return what words before a second formula say of it: general, or of several; "" for nothing."""
    if new := _general_letter(value, chain, k, definitions, knowledge):
        return f"anew: for any {plain_text(Name(new))}, by the words before"
    if times := _times_the_earlier(value, earlier, chain, k, definitions, knowledge):
        return f"{times} times that of line {earlier.line}, by the words before"
    return ""


def _general_letter(
    value: Formula, chain: Chain, k: int, definitions: Definitions, knowledge: Knowledge
) -> str:
    """Return the letter that a formula is general in: for a bank angle 2γ, after the one for 90°; or "".

    The letter has not stood on the page before its paragraph, nobody has declared it, and the words
    before name it as any: for a, for any, in general.
    """
    if k or not names(value):
        return ""
    line, sections = chain.lines[0], definitions.sections
    before = definitions.letters_before(line)
    for letter in sorted(names(value) - before - knowledge.meanings.keys()):
        if not knowledge.has_meaning(letter) and sections.is_introduced_as_any(chain, letter):
            return letter
    return ""


def _times_the_earlier(
    value: Formula,
    earlier: Definition,
    chain: Chain,
    k: int,
    definitions: Definitions,
    knowledge: Knowledge,
) -> int:
    """Return how many times its earlier formula a letter is now, where words say so; 0 for none.

    Both pistons go up together: F = 2 m r ω² (cos θ + λ cos 2θ), after the F of one piston.
    """
    if k or not names(value) or not names(earlier.node):
        return 0
    numbers = numbers_of_several(definitions.sections.sentence_leading_to(chain))
    for number in sorted(numbers):
        several = Product((Number(Fraction(number)), earlier.node))
        if decide(lone_side(several), lone_side(value), "=", knowledge).is_proved:
            return number
    return 0


def _is_exact_form(
    name: str, value: Formula, earlier: Definition, chain: Chain, k: int, knowledge: Knowledge
) -> bool:
    """Tell whether a formula is what an earlier line gave a letter with ≈, cut off at some order."""
    if k or not earlier.is_rough or chain.relations[0].sign != "=" or not names(value):
        return False
    lettered = {n: d for n, d in knowledge.definitions.items() if n != name and not d.numeric}
    known = replace(knowledge, definitions=lettered)
    return bool(names(earlier.node)) and (
        decide(lone_side(value), lone_side(earlier.node), "≈", known).is_proved
        and not decide(lone_side(earlier.node), lone_side(value), "=", known).is_proved
    )


def _new_case(
    earlier: Definition, value: Formula, sign: str, knowledge: Knowledge, *, is_called_case: bool
) -> bool:
    """Tell whether another value of a letter starts a new case, and is not a slip.

    It does between lone letters or numbers (θ = 0, then θ = π/2), unless two numbers nearly agree and no
    words in another section call the second a case (for n = 4, after n = 3.6).
    """
    old = Side((earlier.node,), (0, 0))
    if sign == "≈" or decide(old, Side((value,), (0, 0)), sign, knowledge).is_proved:
        return False
    is_area = _is_integral_with_a_number(value, knowledge)
    if _are_times_of_angles(earlier.node, value):
        return True
    if names(earlier.node) and names(value) and not is_area:
        return isinstance(value, Name)
    if names(earlier.node) or (names(value) and not is_area):
        is_listed = not names(value) and _is_sum_over_listed_cranks(earlier.node, knowledge)
        return not is_listed and not _comes_to_a_number(earlier.node, knowledge)
    points = sample_trees([earlier.node, value], SymbolValue(), 1)
    if not points or is_called_case:
        return True
    return _is_far(*points[0][1])


def _is_sum_over_listed_cranks(node: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a formula is a sum of nothing but the angles of cylinders, and these are listed."""
    if not isinstance(node, Summation) or node.index is None or knowledge.crank_angles is None:
        return False
    return names(node.body) == frozenset(indexed_letters(node.body, node.index.name))


def _are_times_of_angles(*values: Formula) -> bool:
    """Tell whether values of t say where the crank stands: ω t = 0, and then ω t = π."""
    return all(is_time_of_angle("t", value) for value in values)


def _is_integral_with_a_number(value: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a value is an integral that comes to a number: ∫ 340 sin 2θ dθ from 0 to π/2."""
    bare = value.factors[-1] if isinstance(value, Product) else value
    return isinstance(bare, Integral) and _comes_to_a_number(value, knowledge)


def _is_of_another_section(
    definitions: Definitions, earlier: Definition, value: Formula, chain: Chain, knowledge: Knowledge
) -> bool:
    """Tell whether an integral gives a letter its number in a section after that of its other value."""
    if not _is_integral_with_a_number(value, knowledge):
        return False
    return not definitions.sections.same_section(earlier.line, chain.lines[0])


def _has_number_put_in(
    definitions: Definitions, earlier: Definition, line: int, knowledge: Knowledge
) -> bool:
    """Tell whether a line gives a formula its value, by its letters' numbers: λ = 3.5, F = 648."""
    behind = (knowledge.definitions.get(n) for n in names(earlier.node) - knowledge.angles)
    is_here = any(d is not None and d.numeric and d.line == line for d in behind)
    return is_here and _comes_to_a_number(earlier.node, knowledge, Number(Fraction(0)))


def _comes_to_a_number(node: Formula, knowledge: Knowledge, *beside: Formula) -> bool:
    """Tell whether a formula has a number by all that is known: another one then contradicts it."""
    level = list(knowledge.levels(node, *beside))[-1]
    try:
        return not letters(knowledge.evaluator(level).form(node))
    except TooLargeError:
        return False
    except NoFormError:  # ε^κ with numbers for both
        meaning = replace(knowledge.meaning, values=level.values)
        return not letters_behind(node, meaning.values) and bool(sample_trees([node], meaning, 1))


def _define_case_anew(
    definitions: Definitions,
    name: str,
    value: Formula,
    earlier: Definition,
    chain: Chain,
    knowledge: Knowledge,
) -> Decision:
    """Return the decision on a value that may start a new case, after defining it."""
    line = chain.lines[0]
    if (wrong := refute_result(definitions, name, value, earlier, chain, knowledge)) is not None:
        return wrong
    if (not_zero := _zero_of_case(name, earlier, value, line, knowledge)) is not None:
        return not_zero
    if names(earlier.node) and is_led_to(definitions, value, chain):
        reason = (
            f"words lead to it from line {earlier.line}, and nothing says that the formula comes to it"
        )
        return Decision(UNDECIDED, reason)
    if isinstance(value, Name) and value.name in knowledge.definitions:
        definitions.conditions[line] = frozenset(_letters_behind([earlier.node, value], knowledge))
        return Decision(CONDITION, "sets two quantities equal")
    refusal = refuse_case(definitions, name, value, earlier, chain, knowledge)
    if refusal is None and _is_no_other_root(definitions, name, value, chain, knowledge):
        refusal = Decision(CONTRADICTION, "no solution of the equation that the other value solves")
    if refusal is None and _is_in_another_prefix(earlier, value):
        reason = f"the number of line {earlier.line} {ANOTHER_PREFIX}"
        refusal = Decision(REFUTED, reason)
    if refusal is not None:
        return refusal
    bare = without_dots(value)[0]
    end: int | None = None
    turning = _turning_behind(name, earlier.node, knowledge)
    # z_2 = -d/2, then z_2 = 0 with three cylinders: no d is zero for that
    is_possible = turning or isinstance(earlier.node, Sum) or bare != Number(Fraction(0))
    if not names(bare) and names(earlier.node) and name not in knowledge.angles and is_possible:
        end = definitions.sections.section_end(line)  # u = 2v, then u = 6: 2v is 6 here
        end = min(end, definitions.end_of_place(earlier.node, line) or end)
        end = min(end, line) if definitions.sections.is_labelled_item(line) else end
        if turning:
            end = min(end, definitions.sections.case_end(line))  # v = 0 at one moment, and not below
        premise = Premise(earlier.node, bare, line, end)
        definitions.premises.append(premise)
        definitions.open_conditions |= dict.fromkeys(turning, premise)
        end = end if turning else None
    definitions.define(name, bare, chain, end)
    return Decision(PREMISE, f"a new case: line {earlier.line} had another value")


def _turning_behind(name: str, node: Formula, knowledge: Knowledge) -> frozenset[str]:
    """Return the angles that a letter's value turns with: it has a number at a moment only."""
    values = {n: d.node for n, d in knowledge.definitions.items() if n != name}
    behind = {*names_behind(node, {**values, **knowledge.meaning.values})}
    roles = knowledge.meanings
    return frozenset(n for n in behind if role_of(roles.get(n, "")) in ("crank angle", "rod angle"))


def _letters_behind(nodes: list[Formula], knowledge: Knowledge) -> list[str]:
    values = {name: d.node for name, d in knowledge.definitions.items()}
    return [name for node in nodes for name in letters_behind(node, values)]


def _is_no_other_root(
    definitions: Definitions, name: str, value: Formula, chain: Chain, knowledge: Knowledge
) -> bool:
    """Tell whether a second value is said to solve what the first does, and does not: or x = 4."""
    if not definitions.sections.is_one_of_several(chain):
        return False
    for premise in definitions.premises_at(chain.lines[0]):
        if premise.names == {name}:
            try:
                sides = [written_out(side, knowledge, name) for side in (premise.left, premise.right)]
                left, right = (lone_side(substitute(side, name, value)) for side in sides)
            except (NoFormError, TooLargeError):
                continue  # what cannot be put in proves nothing of this value
            if decide(left, right, "=", knowledge).status == REFUTED:
                return True
    return False


def refuse_case(
    definitions: Definitions,
    name: str,
    value: Formula,
    earlier: Definition,
    chain: Chain,
    knowledge: Knowledge,
) -> Decision | None:
    """Return why another value of a letter is no new case: it contradicts the earlier one, or may.

    In prose a new case is said to be one, or stands in a section of its own.
    """
    line, text = chain.lines[0], f"{plain_text(Name(name))} = {plain_text(earlier.node)}"
    is_moment = name in knowledge.angles or _are_times_of_angles(earlier.node, value)
    if is_moment or definitions.is_stale(name, knowledge):
        return None
    if definitions.sections.premise_end(chain, is_number=not names(value)) is not None:
        return None
    if chain.inline and definitions.sections.is_denied(chain):
        return Decision(CONDITION, f"said not to be so: {text} in line {earlier.line}")
    is_case = _says_new_case(definitions, name, earlier, chain)
    if name in definitions.sections.spoken_of_generally(chain, {name: False}):
        is_case = False  # "in general y = 1" is no case
    is_excluded = is_case is not True and _excludes(earlier.node, value, knowledge)
    if not is_excluded or _is_another_solution(definitions, name, value, line, knowledge):
        return None
    if is_case is None or line - earlier.line > FAR:
        reason = f"not {text} of line {earlier.line}, {NO_WORDS}"
        return Decision(UNDECIDED, reason)
    return Decision(CONTRADICTION, f"contradicts {text} of line {earlier.line}")


def _says_new_case(definitions: Definitions, name: str, earlier: Definition, chain: Chain) -> bool | None:
    """Tell whether what stands around another value makes it a new case; None where it may."""
    line, near = chain.lines[0], definitions.sections.paragraph_start(chain.lines[0])
    same_section = definitions.sections.same_section(earlier.line, line)
    if not same_section or (chain.inline and near > earlier.line):
        follows_at_once = definitions.sections.stands_next(chain, earlier.line)
        return not (definitions.sections.is_consequence(chain) and follows_at_once)
    if not chain.inline:
        is_next = definitions.sections.is_in_next_group(chain)
        return is_next or (bool(earlier.assumption) and near > earlier.line)
    return definitions.sections.starts_new_case(chain, earlier.line, name)


def _excludes(earlier: Formula, value: Formula, knowledge: Knowledge) -> bool:
    """Tell whether no values of their letters make two values of one letter the same.

    Two numbers, values that differ by a number, or a number that no case of the earlier one gives.
    """
    if isinstance(earlier, Cases) and not names(value):
        return not any(names(v) for v in earlier.values) and all(
            decide(lone_side(v), lone_side(value), "=", knowledge).status == REFUTED
            for v in earlier.values
        )
    if not names(earlier) and not names(value):
        return True
    level = list(knowledge.levels(earlier, value))[-1]
    try:
        gap = knowledge.evaluator(level).form(Sum((earlier, Negative(value))))
    except (NoFormError, TooLargeError):
        return False
    return not letters(gap) and not gap.is_zero()


def _is_another_solution(
    definitions: Definitions, name: str, value: Formula, line: int, knowledge: Knowledge
) -> bool:
    """Tell whether a second value solves an equation too that a letter's first one solves."""
    others = {n: d for n, d in knowledge.definitions.items() if n != name}
    without = replace(knowledge, definitions=others)
    if not any(name in p.names and not p.fixes for p in definitions.premises_at(line)):
        return False
    decision = decide_by_premises(definitions, Premise(Name(name), value, line), without)
    return decision is not None and decision.status == PREMISE
