r"""Zeros, poles and extremes that words place beside a formula: y = x² - 4 vanishes at x = 2 and x = -2.

The value is no premise there. The formula has to be zero at it, to grow without end or to turn; what is
said to be left out of where it is defined (x ≠ 1) has to be such a place.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from symbalance.document.formula import Formula, Name, Negative, Number, names
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.premises.angles_at import solves_as_printed
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.premises.system import Premise
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import (
    CONDITION,
    DEFINITION,
    PREMISE,
    PROVED_WORDS,
    RANGE,
    UNDECIDED,
    Verdict,
)
from symbalance.notes.reading import ReadingError, read_equation
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_KINDS = {
    "zero": r"zeros?|roots?|nullstellen?|zéros?|racines?|zeri|zero|ceros?|raíz|raíces",
    "pole": r"poles?|singularit(?:y|ies)|pol(?:e|stellen?)?|pôles?|poli|polo|polos",
    "minimum": r"minim(?:um|a)|tiefpunkt|minimo|mínimo|least\s+value|smallest\s+value",
    "maximum": r"maxim(?:um|a)|hochpunkt|massimo|máximo|largest\s+value|greatest\s+value",
}
_IS = {
    "zero": r"(?:vanish(?:es)?|is\s+(?:zero|0)|becomes\s+zero|verschwindet|(?:wird|ist)\s+(?:null|0)"
    r"|s'annule|est\s+nulle?|si\s+annulla|è\s+null[ao]|se\s+anula|es\s+nul[ao])",
    "pole": r"(?:is\s+(?:singular|infinite)|becomes\s+infinite"
    r"|(?:wird|ist)\s+(?:singulär|unendlich)|est\s+infinie?)",
    "minimum": r"(?:is\s+(?:smallest|minimal|least)"
    r"|(?:ist|wird)\s+minimal|est\s+minimale?|è\s+minim[ao]|es\s+mínim[ao])",
    "maximum": r"(?:is\s+(?:largest|maximal|greatest)"
    r"|(?:ist|wird)\s+maximal|est\s+maximale?|è\s+massim[ao]|es\s+máxim[ao])",
}
_HAS = (
    r"(?:has|have|hat|haben|a|possède|admet|ha|tiene)\s+(?:(?:an?|its|the|two|only|one|ein|eine|einen|sein|seine|seinen|ihr|ihre|ihren|das|die"
    r"|zwei|un|une|son|sa|ses|deux|le|les|uno|una|il|suo|due|su|sus|dos|local|global|absolute|single|double|lokales|relatives)\s+){0,3}"
)
_AT = r"(?:at|for|when|where|in|bei|für|an\s+der\s+stelle|en|pour|à|quand|per|a|quando|para|cuando)"
_SUBJECT = r"(?:it|which|that|and|this|es|das|die|der|und|er|sie|elle|il|qui|et|che|e|y|que)\s+"
_BETWEEN = {
    kind: re.compile(
        rf"[\s$,]*(?:{_SUBJECT})?(?:{_IS[kind]}|{_HAS}(?:{nouns}))\s+{_AT}[\s$({{\[]*", re.IGNORECASE
    )
    for kind, nouns in _KINDS.items()
}
"""All that stands between a formula and where it is zero, has a pole or turns."""
_OF = {
    kind: re.compile(
        rf"(?<![^\W\d_])(?:{nouns})\s+(?:of|von|der|des|du|de|di|del|della)(?:\s+(?:the|la|le|il|el|function|expression|funktion|fonction|funzione|función))*[\s$({{\[]*$",
        re.IGNORECASE,
    )
    for kind, nouns in _KINDS.items()
}
_LIES = re.compile(
    r"[\s$,]*(?:(?:is|are|lies?|occurs?|ist|sind|liegt|liegen|est|sont|se\s+trouvent?|è|sono|si\s+trova|es|son|está|están)\s+)"
    r"(?:at|bei|in|en|à|a)?[\s$({\[]*",
    re.IGNORECASE,
)
"""Around a formula: the pole of 1/(x - 1) is at x = 1."""
_DEFINED = re.compile(
    r"[\s$,.]*(?:(?:which|and|it|es|sie|und|elle|che|que)\s+)?(?:(?:is|ist|est|è|es)\s+)?(?:only\s+|nur\s+)?"
    r"(?:defined|valid|definiert|définie?|definit[ao]|definid[ao])\s+(?:only\s+)?(?:for|if|when|für|pour|per|para)[\s$({\[]*",
    re.IGNORECASE,
)
_JOINED = re.compile(
    r"[\s$,)]*(?:(?:and|or|und|oder|et|ou|e|o|y|u)(?![^\W\d_]))?[\s$]*(?:(?:at|bei|à|en|a|in)\s)?[\s$(]*"
)
_BARE = re.compile(r"\$(?P<formula>[^$\n=<>]{1,120})\$(?P<behind>[^$\n.;]{1,60})\$?$")
"""A formula without a relation before a value."""
_WITHIN = re.compile(
    r"(?<![^\W\d_])(?:intervals?|intervalls?|intervall[eo]|intervalo|between|within|zwischen|entre|tra|fra|positive|positiven?|positif|positiv[ioae])"
    r"(?![^\W\d_])|∈|\\in(?![A-Za-z])|区間|範囲",
    re.IGNORECASE,
)
"""Words that say where a letter lies."""
_RANGE_NEAR = 400
_FARTHEST, _MOST_JOINED = 120, 6
_STEP, _TINY = Fraction(1, 1000), 1e-9
_POLE = (Fraction(1, 10**3), Fraction(1, 10**6))
_GROWS = 10
"""By what factor a formula grows at least from a thousandth to a millionth beside a pole."""


def unless_at_another_place(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a value at which a formula is not what words say of it there is refuted."""
    head, value = chain.sides[0].node, chain.sides[-1].node
    is_open = verdict.verdict in (*PROVED_WORDS, PREMISE, DEFINITION, RANGE, CONDITION, UNDECIDED)
    if k or not is_open or not isinstance(head, Name) or len(chain.relations) != 1 or names(value):
        return verdict
    sign = chain.relations[0].sign
    if sign not in "=≈≠":
        return verdict
    found = _formula_and_kind(state, chain, head.name, sign)
    if found is None:
        return verdict
    formula, kind = found
    knowledge = state.knowledge(chain.lines[0])
    if kind in ("minimum", "maximum") and _is_within_range(state, chain, head.name):
        return verdict  # its end may be where it is smallest
    wrong = _why_not(formula, kind, head.name, value, knowledge)
    if not wrong:
        return verdict
    state.definitions.forget(head.name, chain.lines[0])
    return describe(state.document, chain, k, Decision(REFUTED, wrong))


def _is_within_range(state: JudgingState, chain: Chain, name: str) -> bool:
    """Tell whether words or a range near a value say where its letter lies."""
    near = state.sections.chains_between(max(0, chain.start - _RANGE_NEAR), chain.end + _FARTHEST)
    has_range = any(
        name in other.letters and any(r.sign in ("<", ">", "≤", "≥") for r in other.relations)
        for other in near
    )
    words = state.document.text[max(0, chain.start - _FARTHEST) : chain.end + _FARTHEST]
    return has_range or _WITHIN.search(words) is not None


def _formula_and_kind(
    state: JudgingState, chain: Chain, name: str, sign: str
) -> tuple[Formula, str] | None:
    """Return the formula of one letter before a value, and what words say of it there; or None."""
    text, first = state.document.text, chain
    for _ in range(_MOST_JOINED):
        before = state.sections.chain_before(first.start)
        is_listed = before is not None and before.sides[0].node == Name(name)
        if before is None or not is_listed or not _JOINED.fullmatch(text, before.end, first.start):
            break
        first = before
    before = state.sections.chain_before(first.start)
    if before is not None and first.start - before.end <= _FARTHEST:
        formula = before.sides[-1].node
        kind = _kind(
            text[before.end : first.start], text[max(0, before.start - _FARTHEST) : before.start], sign
        )
        if kind and names(formula) == {name}:
            return formula, kind
    bare = _BARE.search(text, max(0, first.start - _FARTHEST - 60), first.start)
    if bare is None:
        return None
    kind = _kind(bare["behind"], text[max(0, bare.start() - _FARTHEST) : bare.start() + 1], sign)
    formula = _read(bare["formula"], name, state) if kind else None
    return None if formula is None or names(formula) != {name} else (formula, kind)


def _kind(between: str, before: str, sign: str) -> str:
    """Return what words say of a formula at a value: "zero", "pole", an extreme, "defined"; or ""."""
    if sign == "≠":
        return "defined" if _DEFINED.fullmatch(between) else ""
    by_verb = next((kind for kind, words in _BETWEEN.items() if words.fullmatch(between)), "")
    if by_verb or not _LIES.fullmatch(between):
        return by_verb
    return next((kind for kind, words in _OF.items() if words.search(before)), "")


def _read(typed: str, name: str, state: JudgingState) -> Formula | None:
    """Return a formula that stands without a relation, None where it is not read."""
    try:
        return read_equation(f"u_0 = {typed}", frozenset(state.letters) | {name}).sides[-1].node
    except ReadingError:
        return None


def _why_not(formula: Formula, kind: str, name: str, value: Formula, knowledge: Knowledge) -> str:
    """Return why a formula is not what is said of it at a value, "" where it is or may be."""
    at = _values_of(formula, name, knowledge)
    place = number_of(value, knowledge)
    if place is None:
        return ""
    place = Fraction(str(float(place)))
    if kind == "zero":
        condition = Premise(formula, Number(Fraction(0)), 0)
        is_root = solves_as_printed(condition, name, value, Knowledge())
        return f"it is {at(place):.6g} there" if is_root is False and at(place) is not None else ""
    own, near, far = at(place), *(at(place + step) for step in _POLE[::-1])
    if kind in ("pole", "defined"):
        is_pole = own is None or near is None or far is None or abs(near) > _GROWS * abs(far)
        return "" if is_pole else f"it is {own:.6g} there"
    last = value.operand if isinstance(value, Negative) else value
    step = getattr(last, "last_place", None) or max(abs(place), Fraction(1)) * _STEP
    beside = [at(place - step), at(place + step)]
    if own is None or None in beside:
        return ""
    way = 1 if kind == "minimum" else -1
    tiny = _TINY * max(1.0, abs(own))
    is_turned = all(each is not None and way * (each - own) >= -tiny for each in beside)
    return "" if is_turned else f"it is no {kind} there"


def _values_of(formula: Formula, name: str, knowledge: Knowledge) -> Callable[[Fraction], float | None]:
    """Return a function of a letter's value: what a formula comes to there, None if it has no value."""

    def at(place: Fraction) -> float | None:
        number: Formula = Number(place) if place >= 0 else Negative(Number(-place))
        try:
            rows = sample_trees([substitute(formula, name, number)], knowledge.meaning, 1, tries=1)
        except (NoFormError, ArithmeticError):
            return None
        if not rows or abs(rows[0][1][0].imag) > _TINY:
            return None
        return float(rows[0][1][0].real)

    return at
