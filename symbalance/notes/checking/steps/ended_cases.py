"""A case ends where words turn to its opposite: "if x = 2, then y = 4; otherwise …", and "for x ≠ 2 …".

What the case gave its letters, and what was given within it, is of no use behind that place, be it on
the same line.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Formula, Name, Number, names
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.inequalities import SATISFIED_BY
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge, StatedRange
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.premises.definitions import Definitions
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, PREMISE, UNDECIDED, Verdict
from symbalance.notes.checking.words import case_words
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_OTHERWISE = re.compile(
    r"(?<![^\W\d_\\])(?:otherwise(?!\s+(?:said|put|stated|expressed|known))|else(?!where)|if\s+(?:it\s+(?:is|does)\s+)?not(?=\s*[,:$])"
    r"|in\s+(?:all|any|every|each|the)\s+other\s+(?:cases?|positions?)|without\s+(?:this|that)\s+(?:\w+\s+)?(?:assumption|condition|restriction|premise)"
    r"|sonst|andernfalls|ansonsten|andererseits|wenn\s+nicht(?=\s*[,:$])|falls\s+nicht(?=\s*[,:$])|in\s+(?:allen|jedem|dem)\s+ander(?:e?n|em)\s+f[aä]ll?e?n?"
    r"|ohne\s+diese\s+(?:annahme|bedingung|voraussetzung|einschränkung)|sinon|autrement(?!\s+dit)|dans\s+(?:tous\s+)?les\s+autres\s+cas|dans\s+le\s+cas\s+contraire"
    r"|sans\s+cette\s+(?:hypothèse|condition)|altrimenti|in\s+caso\s+contrario|negli\s+altri\s+casi|de\s+lo\s+contrario|si\s+no(?=\s*[,:$])|en\s+(?:otro|los\s+demás)\s+casos?)"
    r"(?![^\W\d_])|そうでな|それ以外|さもな|他の場合",
    re.IGNORECASE,
)
"""Words of the opposite of the case before."""
_REALLY = re.compile(
    r"(?<![^\W\d_\\])(?:in\s+(?:fact|reality|truth)|actually|really|but\s+(?:it|this|that)\s+is(?:\s+not|n't)?|tatsächlich|in\s+Wirklichkeit"
    r"|aber\s+(?:es|das|dem)\s+ist(?:\s+nicht)?|en\s+(?:fait|réalité)|mais\s+ce\s+n'est\s+pas|in\s+realtà|en\s+realidad)(?![^\W\d_])|実際",
    re.IGNORECASE,
)
"""Words that leave what was only supposed, before it or behind it."""
_UNREAL = re.compile(
    r"(?<![^\W\d_\\])(?:were|would|wäre[nt]?|würde[nt]?|hätte[nt]?|était|serait|aurait|fosse|sarebbe|fuera|sería)(?![^\W\d_])"
    r"|仮に",
    re.IGNORECASE,
)
"""Words of a supposition that is not so: if x were 2."""
_SUPPOSED = re.compile(
    r"(?<![^\W\d_\\])(?:assum(?:e|ing)|suppos(?:e|ing|ed)|angenommen|annahme|supposons|supposé|supponiamo|supongamos)(?![^\W\d_])|仮定",
    re.IGNORECASE,
)
_ONLY = re.compile(
    r"(?<![^\W\d_\\])(?:only|nur|seulement|solo|solamente|uniquement)(?![^\W\d_])|のみ", re.IGNORECASE
)
"""Before a range that something holds in: it leaves no case, isolation only when η > 2."""
_UNEQUAL = re.compile(
    r"(?<![^\W\d_\\])(?:unequal|not\s+equal|different|differ|distinct|ungleiche?[nrsm]?|verschiedene?[nrsm]?|unterschiedliche?[nrsm]?"
    r"|inégales?|inégaux|différente?s?|distincte?s?|divers[aieo]|disugual[ei]|desiguales|distint[ao]s|diferentes)(?![^\W\d_])|異な",
    re.IGNORECASE,
)
"""Words that leave a case of two letters that are equal."""
_NOT_ZERO = re.compile(
    r"(?<![^\W\d_\\])(?:finite|non-?zero|not\s+zero|endliche?[nrsm]?|von\s+null\s+verschieden\w*|non\s+null[eoai]?s?|finit[aoie]|finie?s?|finit[ao]s)"
    r"(?![^\W\d_])|有限|零でない",
    re.IGNORECASE,
)
"""Words that leave a case in which a letter is zero."""
_WITHOUT = re.compile(
    r"(?<![^\W\d_\\])(?:without|no|zero|ohne|sans|senza|sin)\s+(?:the\s+|an?\s+)?(?P<what>[^\W\d_]{4,})",
    re.IGNORECASE,
)
_WITH = re.compile(
    r"(?<![^\W\d_\\])(?:with|mit|avec|con)\s+(?:the\s+|an?\s+|some\s+)?(?P<what>[^\W\d_]{4,})",
    re.IGNORECASE,
)
"""Without damping, and with it."""
_LABEL = re.compile(
    r"(?<![^\W\d_\\])(?:case|fall|cas|caso)\s*\(?(?:[0-9]{1,2}|[a-h]|[ivx]{1,4})\)?\s*(?:[.:,)–—-]|(?=\())"
    r"|場合\s*[0-9]",
    re.IGNORECASE,
)
"""What numbers one case of several."""
_LABEL_LAST = re.compile(rf"(?:{_LABEL.pattern})[\s$*(]*$", re.IGNORECASE)
_TITLE_BEHIND = re.compile(r"[\s$)}\]*]{0,4}[:：](?!=)")
"""Behind a relation that is the title of what follows: J_1 = J_2: …"""
_SENTENCE = re.compile(r"[.;!?]\s|[;。；]|\n\s*\n")
_JOINED = re.compile(r"[\s$,)]*(?:(?:and|und|et|y|e)(?![^\W\d_])|[,、と])[\s$(]*")
_THEN = re.compile(
    r"[.;]\s+(?:then|dann|alors|allora|entonces)(?![^\W\d_])|。\s*(?:すると|このとき)", re.IGNORECASE
)
"""What leads from a supposition to what is said to follow."""
_LEADS = re.compile(
    r"[\s$,.;:)}\]、。]*(?:(?:then|so|hence|thus|therefore|it|we|one|is|that|has|have|get|clearly|also|dann|gilt|ist|also|somit"
    r"|folglich|wird|alors|donc|on|a|allora|quindi|si|ha|entonces|luego|se|tiene|tenemos)(?![^\W\d_])[\s$,:({]*)+"
    r"|[\s$]*(?:ならば?|のとき|では)[、\s$]*",
    re.IGNORECASE,
)
"""Between a case and what is claimed of its letter itself: if λ = 4, then λ > 5."""
_TURNS = re.compile(
    r"\n\s*\n|(?<![^\W\d_])(?:but|while|whereas|yet|usually|mostly|aber|während|jedoch|meist\w*|mais|tandis|alors\s+que|ma|mentre"
    r"|pero|mientras)(?![^\W\d_])|しかし",
    re.IGNORECASE,
)
"""Words that turn from a case to something else."""
_MOST_CLAIMS = 4
"""Claims of one case in a sentence, over which the case is looked for."""
REACH = 200
"""Characters behind a supposition in which its sentence ends."""


def leave_ended_cases(state: JudgingState, chain: Chain) -> None:
    """Forget the cases above a relation in its section that its words, or the relation itself, end."""
    state.cases_to_leave |= {case.start: (case, chain.start) for case in _ended_by(state, chain)}
    state.starts_judged.add(chain.start)
    if not state.cases_to_leave:
        return
    on_line = state.sections.chains_on(chain.lines[0])
    row = [c.start for c in on_line if c.start not in state.starts_judged]
    first = min([*row, chain.start])  # of one line a case is judged first, whatever stands before it
    for start, (case, place) in list(state.cases_to_leave.items()):
        if place <= first:
            _forget_since(state.definitions, case, place)
            state.ended_cases.append(case)
            del state.cases_to_leave[start]


def turn_to_opposite_range(state: JudgingState, chain: Chain) -> None:
    """State the opposite of a range behind "otherwise": if x > 0, |x| = x, and otherwise |x| = -x."""
    sections, text = state.sections, state.document.text
    last = sections.chain_before(chain.start)
    words = "" if last is None else _SENTENCE.split(text[last.end : chain.start])[-1]
    if last is None or not _OTHERWISE.search(words):
        return
    start = sections.start_of_line(sections.paragraph_start(chain.lines[0]))
    above = sections.chains_between(start, chain.start)
    ranges = [c for c in above if _is_range_of_letter(c) and len(c.relations) == 1]
    case = next((c for c in reversed(ranges) if sections.opens_case(c)), None)
    if case is None or case.relations[0].sign not in _OPPOSITE:
        return
    left, right = (side.node for side in case.sides)
    definitions, line = state.definitions, chain.lines[0]
    definitions.forget_range(case)
    definitions.cases = [c for c in definitions.cases if c.start != case.start]
    opposite = StatedRange(left, _OPPOSITE[case.relations[0].sign], right, line, line)
    definitions.ranges.append(opposite)


_OPPOSITE = {">": "≤", "<": "≥", "≥": "<", "≤": ">"}


def letters_of_ended(state: JudgingState, chain: Chain) -> frozenset[str]:
    """Return the letters of the cases that words end right before a relation, which is a claim there.

    If θ = 90°, sin θ = 1; otherwise sin θ < 1. A value of the letter itself is another case.
    """
    last = state.sections.chain_before(chain.start)
    if not state.ended_cases or last is None or any(isinstance(s.node, Name) for s in chain.sides):
        return frozenset()
    words = state.document.text[last.end : chain.start]
    is_range = all(relation.sign in SATISFIED_BY for relation in chain.relations)
    is_said = case_words.is_said_generally(words) or (is_range and _OTHERWISE.search(words))
    letters = frozenset(name for case in state.ended_cases for name in case.letters)
    return letters & chain.letters if is_said else frozenset()


def _ended_by(state: JudgingState, chain: Chain) -> list[Chain]:
    """Return the open cases that end right before a relation, or with it."""
    cases, titled = _open_cases(state, chain), _titles_of_sections_above(state, chain)
    last = state.sections.chain_before(chain.start)
    if not cases or last is None:
        return titled
    text = state.document.text
    words = _SENTENCE.split(text[last.end : chain.start])
    ended: list[Chain] = []
    if _OTHERWISE.search(words[-1]):
        ended = _last_of(cases, text)
    elif case_words.is_said_generally(words[-1]) and (len(words) > 1 or last not in cases):
        ended = [c for c in cases if c.sides[0].node != chain.sides[0].node]
    elif _LABEL.search(text[last.end : chain.start]):
        ended = [c for c in cases if _LABEL_LAST.search(text[max(0, c.start - REACH) : c.start])]
    elif opposed := [c for c in cases if _is_opposite(text, c, words[-1])]:
        ended = opposed
    elif _is_range_of_letter(chain) and not _ONLY.search(words[-1]):
        claimed = _claimed_in(state, cases, chain)
        others = [c for c in cases if c.letters == chain.letters and c not in claimed]
        ended = [c for c in others if _is_left_by(c, chain)]
    ended += [c for c in cases if c not in ended and _is_no_more_supposed(state, c, chain)]
    return [*ended, *titled]


def _titles_of_sections_above(state: JudgingState, chain: Chain) -> list[Chain]:
    """Return the titles of two equal letters, J_1 = J_2: …, of the sections before a relation's."""
    first = state.sections.section_start(chain.lines[0])
    closed = {c.start for c in state.ended_cases} | state.cases_to_leave.keys()
    return [
        case
        for case in state.openings or ()
        if case.lines[0] < first
        and case.start not in closed
        and all(isinstance(side.node, Name) for side in case.sides)
        and _is_titled(state.document.text, case)
    ]


def _open_cases(state: JudgingState, chain: Chain) -> list[Chain]:
    """Return the cases above a relation in its section that nothing has ended yet."""
    if state.openings is None:
        chains = state.sections.in_order
        state.openings = [c for c in chains if _gives_value(c) and _is_case(state, c)]
    first = state.sections.section_start(chain.lines[0])
    above = (c for c in state.openings if c.end <= chain.start and c.lines[0] >= first)
    ended = {c.start for c in state.ended_cases}
    return [c for c in above if c.start not in ended and c.start not in state.cases_to_leave]


def unless_of_ended_case(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; what is only stated, and is true in a case that is left, is open."""
    is_stated = verdict.verdict in (CONDITION, PREMISE)
    if not is_stated or not state.ended_cases or state.sections.is_condition(chain):
        return verdict
    knowledge = _without_own(state, chain, state.knowledge(chain.lines[0]))
    nodes = {name: d.node for name, d in knowledge.definitions.items()}
    behind = {n for side in chain.sides[k : k + 2] for n in names_behind(side.node, nodes)}
    for case in state.ended_cases:
        letter, value = case.sides[0].node, case.sides[1].node
        if not isinstance(letter, Name) or letter.name not in behind or letter.name in nodes:
            continue
        if not state.sections.same_section(case.lines[0], chain.lines[0]):
            continue
        there = knowledge.with_definition(letter.name, Definition(value, case.lines[0]))
        if decide(chain.sides[k], chain.sides[k + 1], chain.relations[k].sign, there).is_proved:
            shown = f"{plain_text(letter)} = {plain_text(value)}"
            reason = f"it holds in the case {shown} of line {case.lines[0]}, which words have left"
            return describe(state.document, chain, k, Decision(UNDECIDED, reason))
    return verdict


def _without_own(state: JudgingState, chain: Chain, knowledge: Knowledge) -> Knowledge:
    """Return what is known without what a relation itself has just given, and been solved for."""
    own = {id(side.node) for side in chain.sides}
    definitions = dict(knowledge.definitions)
    for name in chain.letters & definitions.keys():
        earlier = [
            e.definition
            for e in state.definitions.values.get(name, [])
            if id(e.definition.node) not in own and not e.definition.solved
        ]
        if definitions[name].solved or id(definitions[name].node) in own:
            del definitions[name]
            definitions |= {name: earlier[-1]} if earlier else {}
    return replace(knowledge, definitions=definitions)


def _gives_value(chain: Chain) -> bool:
    return len(chain.relations) == 1 and chain.relations[0].sign == "=" and len(chain.letters) >= 1


def _is_case(state: JudgingState, chain: Chain) -> bool:
    """Tell whether a relation is said to hold in a case only: for x = 2, suppose x = 2."""
    text = state.document.text
    before = case_words.clause_before(text, chain.start)
    is_said = state.sections.opens_case(chain) or bool(_SUPPOSED.search(before))
    return chain.inline and (is_said or _is_titled(text, chain) or _is_bare_case(text, chain, before))


def _is_titled(text: str, chain: Chain) -> bool:
    """Tell whether a relation is one of several cases that are numbered, or the title of a line."""
    is_labelled = _LABEL_LAST.search(text[max(0, chain.start - REACH) : chain.start]) is not None
    is_first = not text[text.rfind("\n", 0, chain.start) + 1 : chain.start].strip(" \t$*#-(")
    return is_labelled or (is_first and _TITLE_BEHIND.match(text, chain.end) is not None)


def _is_bare_case(text: str, chain: Chain, before: str) -> bool:
    """Tell whether a letter is zero without something: without damping, D = 0, the root is 1."""
    is_zero = isinstance(chain.sides[1].node, Number) and not chain.sides[1].node.value
    return is_zero and _WITHOUT.search(before) is not None


def _is_opposite(text: str, case: Chain, words: str) -> bool:
    """Tell whether words name the opposite of a case: unequal masses after m_1 = m_2."""
    left, right = case.sides[0].node, case.sides[1].node
    if isinstance(left, Name) and isinstance(right, Name):
        return _UNEQUAL.search(words) is not None
    if not (isinstance(right, Number) and not right.value):
        return False
    without = _WITHOUT.search(case_words.clause_before(text, case.start))
    named = {match["what"].casefold() for match in _WITH.finditer(words)}
    is_without = without is not None and without["what"].casefold() in named
    return is_without or _NOT_ZERO.search(words) is not None


def _last_of(cases: list[Chain], text: str) -> list[Chain]:
    """Return the case that was opened last, with those that are joined to it: for x = 2 and y = 3."""
    last = cases[-1:]
    for case in reversed(cases[:-1]):
        if not _JOINED.fullmatch(text, case.end, last[0].start):
            break
        last.insert(0, case)
    return last


def _is_range_of_letter(chain: Chain) -> bool:
    return len(chain.letters) == 1 and all(r.sign in SATISFIED_BY for r in chain.relations)


def _claimed_in(state: JudgingState, cases: list[Chain], chain: Chain) -> list[Chain]:
    """Return the cases of which a range is the claim, right or wrong: if λ = 4, then 1/λ > 1/3.

    It stands right behind them, in their sentence or as what follows, and is no case itself.
    """
    sections, text = state.sections, state.document.text
    if sections.opens_case(chain) or sections.is_one_of_several(chain):
        return []
    place, last = chain.start, sections.chain_before(chain.start)
    for _ in range(_MOST_CLAIMS):
        if last is None or last in cases or _SENTENCE.search(text, last.end, place):
            break
        place, last = last.start, sections.chain_before(last.start)
    if last is None or last not in cases:
        return []
    between = text[last.end : place]
    is_lone = any(isinstance(side.node, Name) for side in chain.sides)
    if is_lone and chain.relations[0].sign == "≠":
        return []  # so x ≠ 2: what was supposed is not so
    own_words = between if place == chain.start else ""
    if (is_lone and not _LEADS.fullmatch(own_words or " then ")) or _TURNS.search(between):
        return []
    if _SENTENCE.search(between) and not (sections.is_consequence(chain) or _THEN.search(between)):
        return []
    own = _last_of(cases, text)
    given = [(c.sides[0].node, c.sides[-1].node) for c in own]
    return [c for c in cases if c in own or (c.sides[0].node, c.sides[-1].node) in given]


def _is_left_by(case: Chain, chain: Chain) -> bool:
    """Tell whether a range leaves a case, whose value does not satisfy it: for x ≠ 2 after for x = 2."""
    letter, value = case.sides[0].node, case.sides[1].node
    if not isinstance(letter, Name):
        return False
    for k, relation in enumerate(chain.relations):
        sides = [substitute(side.node, letter.name, value) for side in chain.sides[k : k + 2]]
        points = sample_trees(sides, SymbolValue(), 1)
        gap = points[0][1][0].real - points[0][1][1].real if points else 0
        if points and (gap > 0) - (gap < 0) not in SATISFIED_BY[relation.sign]:
            return True
    return False


def _is_no_more_supposed(state: JudgingState, case: Chain, chain: Chain) -> bool:
    """Tell whether a supposition of what is not so is left: "if x were 2, …. But it is 3, and …"."""
    text, between = state.document.text, state.document.text[case.end : chain.start]
    sentence = text[case_words.clause_start(text, case.start) : case.end]
    sentence += _SENTENCE.split(text[case.end : case.end + REACH])[0]
    if _UNREAL.search(sentence) is None:
        return False
    if _REALLY.search(between) is not None:
        return True
    is_later = _SENTENCE.search(between) is not None
    own = case_words.clause_before(text, chain.start)
    return is_later and _UNREAL.search(own) is None and not state.sections.is_consequence(chain)


def _forget_since(definitions: Definitions, case: Chain, place: int) -> None:
    """Forget what a case gives its letters, and what is given of any from there to a place.

    A formula in which the letter of the case stands itself was given for every value of it.
    """

    def is_of_case(node: Formula, line: int) -> bool:
        start = node.span[0] or definitions.sections.start_of_line(line + 1) - 1
        is_own = case.start <= start < case.end  # m_1 = m_2 itself
        return case.start <= start < place and (is_own or not names(node) & case.letters)

    definitions.cases = [c for c in definitions.cases if not case.start <= c.start < place]
    definitions.premises = [p for p in definitions.premises if not is_of_case(p.right, p.line)]
    definitions.ranges = [r for r in definitions.ranges if not is_of_case(r.right, r.line)]
    for name, entries in list(definitions.values.items()):
        others = [e for e in entries if not is_of_case(e.definition.node, e.definition.line)]
        if others:
            definitions.values[name] = others
        else:
            del definitions.values[name]
