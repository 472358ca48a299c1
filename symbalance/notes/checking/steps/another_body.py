"""Formulas of another body, J of a disc and of a rim, or of another writer, whom an answer corrects.

"disc: J = m R²/2; thin rim: J ≈ m R²" lists what is usual for each: neither is said of the wheel at hand.
What a mail quotes, and the answer denies ("No, you lost a factor"), binds the answer in nothing.
"""

from __future__ import annotations

from collections.abc import Callable

from symbalance.document.formula import Name, Product, names
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_DENIES = re.compile(
    r"(?<![A-Za-z])(?:no[,.!]|wrong|not\s+(?:right|correct|quite)|mistaken?|error|slip|lost"
    r"|forgot(?:ten)?|missing"
    r"|should\s+(?:be|read)|nein|falsch|nicht\s+(?:richtig|ganz)|stimmt\s+nicht|fehl(?:t|er)"
    r"|vergessen|umgekehrt|verkehrt|auf\s+dem\s+kopf|upside[\s-]+down|inverted|(?:the\s+)?(?:wrong|other)\s+way"
    r"|faux|fausse|erreur|(?:oublié|inversé|trompé)e?s?|à\s+l['’]envers|errore|sbagliat[oa]|errat[oa]"
    r"|dimenticat[oa]|manca|rovesciat[oa]|capovolt[oa]|equivocad[oa]|incorrect[oa]|erróne[oa]|invertid[oa]"
    r"|falta|olvidad[oa]|al\s+revés)(?![A-Za-z])"
    r"|違|誤|間違|忘れ|逆",
    re.IGNORECASE,
)


_WOULD = re.compile(r"(?<![A-Za-zäöü])(?:would|could|might|würden?|müssten?|könnten?)(?![A-Za-zäöü])")
_WITH = re.compile(
    r"(?:(?<![^\W\d_])(?:with|if|mit|wenn|avec|si|con|se)|(?:^|[.;:,(]\s{1,3}|\n)(?:for|für|pour|per|para)"
    r"|(?:made|chosen|gewählt|ausgeführt))[\s$`\\(\[]{0,6}$",
    re.IGNORECASE,
)
"""Words right before a product that is made so, whatever would be needed."""


def leave_product_made(state: JudgingState, chain: Chain, k: int) -> bool:
    """Forget what a product would have to be, where words say that it is made another one."""
    return not k and not isinstance(chain.sides[0].node, Name) and _leave_product(state, chain)


def leave_product_given_anew(state: JudgingState, chain: Chain, k: int) -> None:
    """Forget what a product is above, where it is given anew: a letter in it is not fixed by both.

    It is behind "with", or by a letter more: m_g r_g = m_r r above, m_g r_g = (m_r + κ m_o) r here.
    """
    left = chain.sides[0].node
    if k or not isinstance(left, Product):
        return
    is_given = _WITH.search(state.document.text[max(0, chain.start - 60) : chain.start]) is not None
    above = [p.right for p in state.definitions.premises if p.left == left]
    is_share = bool(above) and all(names(right) < names(chain.sides[1].node) for right in above)
    if is_given or is_share:
        _leave_product(state, chain, is_share=is_share)


def _leave_product(state: JudgingState, chain: Chain, *, is_share: bool = False) -> bool:
    """Forget what a product would have to be, 2 m_g r_g = (m_c + m_p) r, where it is made another one.

    The line above only says what would be needed, or this one has the product behind "with" or "for".
    """
    left, text = chain.sides[0].node, state.document.text
    premises = [p for p in state.definitions.premises if p.left == left]
    last = state.sections.last_above(left, chain.start)
    if last is None or not isinstance(left, Product) or not premises:
        return False
    would = _WOULD.search(state.sections.sentence_leading_to(last)) is not None
    is_made = would or is_share
    if not is_made and not _WITH.search(text[max(0, chain.start - 60) : chain.start]):
        return False
    state.definitions.premises = [p for p in state.definitions.premises if p not in premises]
    for premise in premises:
        for name in premise.names:
            state.definitions.forget(name, premise.line)
    return True


def leave_body(state: JudgingState, chain: Chain, k: int) -> bool:
    """Forget the formula that a letter has of another body; tell whether there was one."""
    head = chain.sides[0].node
    if k or not isinstance(head, Name) or not names(chain.sides[1].node):
        return False
    if not state.sections.is_of_another_body(chain, head.name):
        return False
    return state.definitions.forget_line(head.name, _last_above(state, chain, head).lines[0])


def leave_cycle(state: JudgingState, chain: Chain, k: int) -> bool:
    """Forget what a letter is in an engine that works otherwise: k = 4/2 per turn of a four-stroke."""
    head = chain.sides[0].node
    if k or not isinstance(head, Name) or head.name in state.declarations.symbols_at(chain.lines[0]):
        return False
    lines = {e.definition.line for e in state.definitions.values.get(head.name, ())}
    lines |= {p.line for p in state.definitions.premises if p.left == head}
    others = [line for line in sorted(lines) if state.sections.is_of_another_cycle(chain, line)]
    left = [state.definitions.forget_line(head.name, line) for line in others]
    return any(left)


def leave_quotation(
    state: JudgingState, chain: Chain, k: int, is_quoted: Callable[[int], bool], *, is_open: bool
) -> bool:
    """Forget the formula that quoted words give a letter, where the answer denies it; tell if it does.

    Nothing has to be denied where the answer's own formula says neither that nor its contrary: `is_open`.
    """
    head = chain.sides[0].node
    if k or not isinstance(head, Name) or is_quoted(chain.start):
        return False
    quoted = [c for c in state.document.chains if c.sides[0].node == head and c.start < chain.start]
    last = max(quoted, key=lambda c: c.start, default=None)
    if last is None or not is_quoted(last.start):
        return False
    between = state.document.text[last.end : chain.start]
    if not is_open and not _DENIES.search(between):
        return False
    same = [c for c in quoted if any(side.node == last.sides[1].node for side in c.sides[1:])]
    lines = sorted({c.lines[0] for c in (*same, last)})  # the letter's own line too, which is quoted
    known = [state.definitions.forget_line(head.name, line) for line in lines]
    return any(known)


def _last_above(state: JudgingState, chain: Chain, head: Name) -> Chain:
    above = (c for c in state.document.chains if c.sides[0].node == head and c.start < chain.start)
    return max(above, key=lambda c: c.start)
