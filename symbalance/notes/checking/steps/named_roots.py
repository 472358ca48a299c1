"""Roots of an equation that stand below it: "with the roots ω_I = √(k/J), ω_II = √(3k/J)".

Each root's letter is the unknown with a subscript of its own. Nothing else on the page says what it is,
and put into the equation it satisfies it, or it is no root. One solution of several, "the solution ω = 0
is the rigid rotation; the other is", gives the unknown no value for the lines below.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Name, Negative, Number, PlusMinus, names, walk
from symbalance.notes.checking.deciding.branches import with_sign
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.premises.angles_at import solves_as_printed
from symbalance.notes.checking.premises.system import Premise
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.words.plain_formulas import lone_side
from symbalance.notes.checking.words.sentences import SENTENCE_END
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

FARTHEST = 400
"""Characters between an equation and its last root."""
_NEAR = 160
"""Characters before and behind a formula that name it a solution."""
ROOTS = re.compile(
    r"(?<![A-Za-z])(?:roots?|solutions?|eigenvalues?|zeros|Wurzeln?|Lösung(?:en)?|Nullstellen?|Eigenwerte?|racines?)(?![A-Za-z])|根|解",
    re.IGNORECASE,
)
"""Words for the roots of an equation."""
_LEADING = re.compile(rf"(?:{ROOTS.pattern})[ \t\n]*[$:`\\(]*$", re.IGNORECASE)
"""One of those words right before a formula."""
_ANOTHER = re.compile(
    r"(?<![A-Za-z])(?:the\s+(?:other|second)|die\s+(?:andere|zweite)|l['’]autre|another)(?![A-Za-z])|他の|もう一つ",
    re.IGNORECASE,
)
_ROOTS_OF = re.compile(
    rf"(?:{ROOTS.pattern})\s+(?:of|von|der|des|to|for|de|du)\s(?:[^\W\d_]|[ \n]){{0,40}}[$(\\\[\s]*$",
    re.IGNORECASE,
)
"""Words right before an equation that say of what the roots are."""
_BOTH = re.compile(r"_(?:1,?2|1/2)$")
_SIGN = re.compile(r"\\(?:pm|mp|sqrt|[dt]?frac|cdot|left|right)(?![A-Za-z])|sqrt(?=\()")
"""Signs of arithmetic that are typed in letters, as no unit is."""
_SOLVED = re.compile(
    r"(?:[\s$,.;:&()\[\]⇒⟹→>=*|]|\\[,;:! \[\]()]"
    r"|\\(?:Rightarrow|Longrightarrow|implies|to|q?quad)(?![A-Za-z])"
    r"|(?:so|hence|thus|then|therefore|gives?|giving|yields?|with|we|get|obtain|have|also|somit|daher|daraus|folgt"
    r"|ergibt|mit|und|wir|erhalten|man|erhält|donc|d'où|soit|on|obtient)(?![A-Za-z]))*+"
)
"""What stands between an equation and both its solutions, where no word calls them so."""
_NONE = re.compile(r"(?<![A-Za-z])(?:of|other|another|square|cube|von|approximate\w*)\s*$", re.IGNORECASE)


def as_named_root(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the decision on a root of the equation above by that equation; None for other relations."""
    head, value = chain.sides[0].node, chain.sides[1].node
    if k or chain.relations[0].sign != "=" or not isinstance(head, Name) or "_" not in head.name:
        return None
    unknown = head.name.partition("_")[0]
    equation = _equation_above(state, chain, unknown)
    if equation is None or {unknown, head.name} & names(value):
        return None
    if not names(value):
        return _as_number(state, chain, equation, unknown)
    return _as_formula(state, chain, equation, unknown, knowledge)


def _as_formula(
    state: JudgingState, chain: Chain, equation: Chain, unknown: str, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on a formula in the letters of an equation as its root."""
    head, value = chain.sides[0].node, chain.sides[1].node
    sides = [side.node for side in equation.sides]
    own = names(sides[0]) | names(sides[1])
    if not isinstance(head, Name) or head.name in own or not names(value) <= own:
        return None
    left, right = (lone_side(substitute(node, unknown, value)) for node in sides)
    formulas = {
        n: d
        for n, d in knowledge.definitions.items()
        if n not in (unknown, head.name) and not d.numeric and not d.solved
    }
    decision = decide(left, right, "=", replace(knowledge, definitions=formulas))
    if decision.is_proved:
        state.definitions.define(head.name, value, chain)
        return Decision(PROVED, f"satisfies line {equation.lines[0]}", assumptions=decision.assumptions)
    if decision.status == REFUTED:
        return Decision(REFUTED, f"does not satisfy line {equation.lines[0]}", witness=decision.witness)
    return None


def _as_number(state: JudgingState, chain: Chain, equation: Chain, unknown: str) -> Decision | None:
    """Return the decision on a number as a root of an equation between numbers, each as it is printed.

    A whole number may be rounded to its last digit; one with a unit is left open.
    """
    head, value = chain.sides[0].node, chain.sides[1].node
    own = names(equation.sides[0].node) | names(equation.sides[1].node)
    typed = _SIGN.sub("", state.document.source(chain.sides[1].span))
    is_bare = re.search(r"[^\W\d_]", typed) is None
    if own != {unknown} or not isinstance(head, Name) or not is_bare:
        return None
    condition = Premise(equation.sides[0].node, equation.sides[1].node, equation.lines[0])
    if any(isinstance(part, PlusMinus) for part in walk(value)):
        return _with_both_signs(state, chain, condition, unknown)
    free = Knowledge()
    number = value.operand if isinstance(value, Negative) else value
    is_solution = solves_as_printed(condition, unknown, value, free)
    if is_solution:
        state.definitions.define(head.name, value, chain)
        is_printed = any(decimals(node) for node in (value, condition.left, condition.right))
        reason = f"satisfies line {equation.lines[0]}"
        return Decision(PROVED, reason, order="the digits printed" if is_printed else "")
    if isinstance(number, Number) and number.last_place is None:
        rough = replace(number, last_place=Fraction(1))
        rough_value = Negative(rough) if isinstance(value, Negative) else rough
        is_solution = None if solves_as_printed(condition, unknown, rough_value, free) else is_solution
    reason = f"does not satisfy line {equation.lines[0]}"
    return Decision(REFUTED, reason) if is_solution is False else None


def _with_both_signs(
    state: JudgingState, chain: Chain, condition: Premise, unknown: str
) -> Decision | None:
    """Return the decision on x = 1 ± 3 as the roots of an equation: each of the two has to be one."""
    value, line = chain.sides[1].node, condition.line
    are_roots = [
        solves_as_printed(condition, unknown, with_sign(value, sign), Knowledge()) for sign in (1, -1)
    ]
    if False in are_roots:
        signs = "upper" if are_roots[0] is False else "lower"
        return Decision(REFUTED, f"with the {signs} sign it does not satisfy line {line}")
    if are_roots != [True, True]:
        return None
    state.definitions.define(_head(chain), value, chain)
    order = "the digits printed" if decimals(value) else ""
    return Decision(PROVED, f"satisfies line {line}", order=order)


def as_one_solution(state: JudgingState, chain: Chain, k: int) -> Decision | None:
    """Return the proof that a number solves the equation above, one solution of several; else None.

    The equation alone proves it, whatever else its letters are; the number is the unknown's nowhere else.
    """
    head, value = chain.sides[0].node, chain.sides[1].node
    is_given = len(chain.relations) == 1 and chain.relations[k].sign == "=" and isinstance(head, Name)
    if not is_given or not isinstance(head, Name) or names(value):
        return None
    text, start = state.document.text, chain.sides[0].span[0]
    is_named = _LEADING.search(text, max(start - _NEAR, 0), start) is not None
    if not is_named or not _ANOTHER.search(text, chain.end, chain.end + _NEAR):
        return None
    above = [c for c in state.document.chains if c.end <= start and start - c.end < FARTHEST]
    for other in sorted(above, key=lambda c: c.end, reverse=True):
        if head.name not in names(other.sides[0].node) | names(other.sides[-1].node):
            continue
        sides = [side.node for side in (other.sides[0], other.sides[-1])]
        if Name(head.name) in sides:
            return None
        left, right = (lone_side(substitute(node, head.name, value)) for node in sides)
        decision = decide(left, right, "=", Knowledge())
        is_solution = decision.is_proved and not decision.assumptions
        return Decision(PROVED, f"satisfies line {other.lines[0]}") if is_solution else None
    return None


def _are_called_roots(text: str, equation: Chain, chain: Chain) -> bool:
    """Tell whether words name roots between an equation and one, or right before: "the roots of it are".

    Both signs at once, x_{1,2} = 1 ± 3 right below it, are roots without a word.
    """
    start = chain.sides[0].span[0]
    named = ROOTS.search(text, equation.end, start)
    if named:
        return not _NONE.search(text, equation.end, named.start())
    first = equation.sides[0].span[0]
    before = _ROOTS_OF.search(text, max(first - _NEAR, 0), first)
    if before and not _NONE.search(text, max(first - _NEAR, 0), before.start()):
        return not SENTENCE_END.search(text, equation.end, start)
    is_both = any(isinstance(part, PlusMinus) for part in walk(chain.sides[1].node))
    is_next = _SOLVED.fullmatch(text[equation.end : start]) is not None
    return is_both and is_next and _BOTH.search(_head(chain)) is not None


def _head(chain: Chain) -> str:
    """Return the letter that a chain begins with, "" for none."""
    head = chain.sides[0].node
    return head.name if isinstance(head, Name) else ""


def _equation_above(state: JudgingState, chain: Chain, unknown: str) -> Chain | None:
    """Return the equation in an unknown whose roots the words before a relation name, None for none."""
    text, start = state.document.text, chain.sides[0].span[0]
    above = [c for c in state.document.chains if c.end <= start and start - c.end < FARTHEST]
    above.sort(key=lambda c: c.sides[0].span[0], reverse=True)
    for other in above:
        is_root = isinstance(other.sides[0].node, Name) and other.sides[0].node.name.startswith(
            f"{unknown}_"
        )
        if is_root:
            continue
        own = names(other.sides[0].node) | names(other.sides[-1].node)
        if len(other.sides) != 2 or other.relations[0].sign != "=" or unknown not in own:
            return None
        if isinstance(other.sides[0].node, Name):
            return None
        return other if _are_called_roots(text, other, chain) else None
    return None
