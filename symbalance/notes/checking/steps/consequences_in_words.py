"""Formulas that words draw from the paragraph before them: "Solving for V_c gives V_c = V_h/(ε - 1)".

Where all letters of a formula stand in one equation right above, and words say that it is solved, the
formula has to make that equation true. So has a formula that "therefore" follows from the definitions of
its letters in the same paragraph: I/v behind I = … and v = D/2.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from symbalance.document.formula import (
    Call,
    Derivative,
    Formula,
    Integral,
    Name,
    Product,
    Quotient,
    Summation,
    names,
    walk,
)
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.deciding.values_at_points import value_at
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, DEFINITION, PREMISE, UNDECIDED, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_JUDGED = (CONDITION, DEFINITION, PREMISE, UNDECIDED)
_WORD, _END = r"(?<![^\W\d_\\])", r"(?![^\W\d_])"
_SOLVED = re.compile(
    rf"{_WORD}(?:solv(?:ing|ed)\s+(?:for|this|it|the|that)|rearrang(?:ing|ed)|(?:is|be)\s+solved\s+for|(?:auf|um)gelöst|auflösen|auflösung|umstellen|umgestellt|löst\s+man"
    r"|en\s+résolvant|résolue?\s+pour|on\s+isole|en\s+isolant|risolvendo|risolta?\s+rispetto|ricavando|si\s+ricava|despejando|resolviendo|se\s+despeja)"
    rf"{_END}|について解く|を解く|解くと",
    re.IGNORECASE,
)
"""Words by which a sentence solves the equation before it."""
_GIVES = re.compile(
    rf"(?:{_WORD}(?:gives?|yields?|giving|yielding|leads?\s+to|results?\s+in|we\s+(?:get|find|obtain|have)|one\s+(?:gets|finds|obtains)|hence|thus|therefore|whence|consequently|it\s+follows"
    r"|ergibt(?:\s+sich)?|liefert|folgt|erhält(?:\s+man)?|daher|somit|mithin|folglich|also|demnach|donne|donc|on\s+(?:obtient|trouve|en\s+tire)|d['’]où|par\s+conséquent|il\s+vient"
    r"|dà|fornisce|quindi|dunque|pertanto|si\s+(?:ottiene|trova|ha)|segue|resulta|da|luego|se\s+(?:obtiene|tiene)|por\s+tanto|por\s+lo\s+tanto)"
    rf"{_END}|よって|したがって|従って|ゆえに|を得る|となる)[^.;:!?$=\n。]{{0,40}}[\s$:(]*$",
    re.IGNORECASE,
)
"""Right before a formula, that it follows."""
_CASE = re.compile(
    rf"{_WORD}(?:if|when|unless|where|at|for\s+(?:an?|small|large|the\s+case)|case|provided|neglect\w*|small|large|limit|approx\w*|roughly|nearly|about|other|another|instead|new|second|further|additional|condition|solid|full|hollow"
    r"|wenn|falls|bei|wo|fall|klein\w*|groß\w*|vernachlässig\w*|grenzfall|etwa|andere[nrs]?|zweite[nrs]?|weitere[nrs]?|bedingung|voll\w*|hohl\w*|si(?!\s+(?:ottiene|ha|trova|ricava|può))|quand|lorsque|cas|négligeant|petit\w*|grande?s?|autre|deuxième|seconde|plein\w*|massif|creux|creuse"
    r"|se(?!\s+(?:obtiene|tiene|despeja|sigue|halla|deduce))|quando|caso|trascurando|piccol\w*|altr[ao]|seconda|condizione|pien[ao]|cav[ao]|cuando|despreciando|pequeñ\w*|otr[ao]|segunda|condición|maciz[ao]|huec[ao])"
    rf"{_END}|とき|場合|近似|無視|別の|他の|中実|中空",
    re.IGNORECASE,
)
"""Words of a case, an approximation or another body: no equation above is solved there."""
_NEAR = 500
"""Characters before a formula in which its equation stands."""
_FEWEST = 3
"""Letters of an equation that is solved: of two anything may be meant, x = 2y."""
_SETS = (
    (0.21, 0.34, 0.27, 0.31, 0.23),
    (1.3, 2.1, 1.7, 3.4, 2.6),
    (7.0, 1.9, 4.3, 2.9, 5.1),
    (2.2, 6.4, 1.2, 8.5, 3.7),
)
"""Values of the letters at which a formula is tried, in the order of their names."""
_FEWEST_POINTS = 2
_CLOSE = 1e-7
_ROUNDED = 0.02
"""By how much a formula with a printed decimal may be off."""
_INVERSE = {"sin": math.asin, "cos": math.acos, "tan": math.atan}
_HIDDEN = (Derivative, Integral, Summation)


def unless_no_consequence(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; refuted where words draw a formula from equations above that do not give it."""
    if k or verdict.verdict not in _JUDGED or chain.relations[0].sign != "=":
        return verdict
    left, right = (side.node for side in chain.sides[:2])
    if not names(left) or not names(right) or _has_hidden(left) or _has_hidden(right):
        return verdict
    sentence = state.sections.sentence_leading_to(chain)
    if not _GIVES.search(sentence) or _CASE.search(sentence):
        return verdict
    above = _equation_solved(state, chain, sentence)
    is_false = above is not None and _misses_equation(chain, above)
    if not is_false:
        values = _definitions_above(state, chain)
        is_false = bool(values) and _misses_definitions(left, right, values)
        above = None
    if not is_false:
        return verdict
    if isinstance(left, Name):
        state.definitions.forget(left.name, chain.lines[0])
    shown = "the definitions above" if above is None else _text_of(above)
    return describe(state.document, chain, k, Decision(REFUTED, f"does not follow from {shown}"))


def _text_of(above: Chain) -> str:
    left, right = (plain_text(side.node) for side in above.sides[:2])
    return f"{left} = {right} of line {above.lines[0]}"


def _has_hidden(node: Formula) -> bool:
    return any(isinstance(part, _HIDDEN) for part in walk(node))


def _paragraph(state: JudgingState, chain: Chain) -> list[Chain]:
    """Return the relations of a formula's paragraph before it that are not refuted."""
    sections = state.sections
    first = sections.start_of_line(sections.paragraph_start(chain.lines[0]))
    start = max(min(first, chain.start), chain.start - _NEAR)
    here = sections.chains_between(start, chain.start)
    return [c for c in here if c.relations and c.sides[1].span[0] not in state.refuted]


def _equation_solved(state: JudgingState, chain: Chain, sentence: str) -> Chain | None:
    """Return the equation right before a formula that has all its letters and is solved, else None."""
    left, own = chain.sides[0].node, chain.letters
    is_head = isinstance(left, Name) or (isinstance(left, Call) and isinstance(left.argument, Name))
    before = state.sections.chain_before(chain.start)
    if not is_head or before is None or len(own) < 2 or before not in _paragraph(state, chain):
        return None
    is_one = len(before.relations) == 1 and before.relations[0].sign == "="
    is_solved = _SOLVED.search(sentence) is not None
    if not is_one or len(chain.relations) > 1 or before.letters != own:
        return None
    if any(map(_has_hidden, (side.node for side in before.sides))):
        return None
    return before if is_solved or len(own) >= _FEWEST else None


def _misses_equation(chain: Chain, above: Chain) -> bool:
    """Tell whether a formula makes the equation above false at every point."""
    head, right = chain.sides[0].node, chain.sides[1].node
    function = head.function if isinstance(head, Call) else ""
    name = next(iter(names(head)))
    if name in names(right) or (function and function not in _INVERSE):
        return False
    others = sorted(names(right))
    if decimals(right):
        return False
    verdicts = [
        _holds_at(above, name, function, value_at(right, point), point) for point in _points(others)
    ]
    known = [each for each in verdicts if each is not None]
    return len(known) >= _FEWEST_POINTS and not any(known)


def _holds_at(
    above: Chain, name: str, function: str, value: float | None, point: Mapping[str, float]
) -> bool | None:
    """Tell whether an equation holds where a letter, or a wave of it, has a value; None if open."""
    if value is None:
        return None
    if function in ("sin", "cos") and abs(value) > 1:
        return False  # no angle has it
    angles = [value] if not function else [_INVERSE[function](value)]
    if function:
        angles += {"sin": [math.pi - angles[0]], "cos": [-angles[0]], "tan": [math.pi + angles[0]]}[
            function
        ]
    found = []
    for angle in angles:
        sides = [value_at(side.node, {**point, name: angle}) for side in above.sides]
        if sides[0] is None or sides[1] is None:
            continue
        size = max(abs(sides[0]), abs(sides[1]), 1e-3 if 0.0 in sides else 0.0)
        found.append(abs(sides[0] - sides[1]) <= _CLOSE * size if size else True)
    return any(found) if found else None


def _points(letters: list[str]) -> Iterator[dict[str, float]]:
    """Yield values for letters; none where there are too many."""
    for values in _SETS:
        if len(letters) <= len(values):
            yield dict(zip(letters, values, strict=False))


def _definitions_above(state: JudgingState, chain: Chain) -> dict[str, Formula]:
    """Return the formulas that the paragraph has given the letters of a product or quotient."""
    left = chain.sides[0].node
    if not isinstance(left, Product | Quotient) or len(chain.relations) > 1:
        return {}
    values: dict[str, Formula] = {}
    for above in _paragraph(state, chain):
        head, value = above.sides[0].node, above.sides[1].node
        if isinstance(head, Name) and above.relations[0].sign == "=" and not _has_hidden(value):
            if head.name in values:
                return {}
            values[head.name] = value
    return {n: values[n] for n in names(left)} if names(left) <= values.keys() else {}


def _misses_definitions(left: Formula, right: Formula, values: Mapping[str, Formula]) -> bool:
    """Tell whether a formula is not its left side with the letters' definitions put in."""
    node = left
    for name, value in values.items():
        node = substitute(node, name, value)
    others = sorted(names(node))
    if not names(right) or not names(right) <= {*others} or {*values} & {*others}:
        return False
    pairs = [(value_at(node, point), value_at(right, point)) for point in _points(others)]
    known = [(a, b) for a, b in pairs if a is not None and b is not None and a]
    near = _ROUNDED if decimals(right) or decimals(node) else _CLOSE
    return len(known) >= _FEWEST_POINTS and all(abs(b / a - 1) > near for a, b in known)
