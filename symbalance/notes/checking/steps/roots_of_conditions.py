r"""Roots that stand below an equation set to zero: (k - m ω²)² - k_c² = 0, so ω_1² = (k + k_c)/m.

A determinant that is to vanish, or a polynomial that is zero, says of its unknown what it can be. A value
in the equation's own letters right below it is a root, or it is wrong; the square of the unknown may
stand for it, and ± for both.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import (
    Apply,
    Call,
    Constant,
    Derivative,
    Formula,
    Matrix,
    Name,
    Number,
    PlusMinus,
    Power,
    Product,
    Quotient,
    names,
    walk,
    with_parts_changed,
)
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.letters_behind import letters_behind, names_behind
from symbalance.notes.checking.deciding.branches import with_sign
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.premises.angles_at import solves_as_printed
from symbalance.notes.checking.premises.system import Premise
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.named_roots import FARTHEST, ROOTS
from symbalance.notes.checking.verdicts import (
    CONDITIONAL,
    CONTRADICTION,
    HOLDS,
    HOLDS_TO_ORDER,
    Verdict,
)
from symbalance.notes.checking.words.plain_formulas import lone_side
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_COUNTED = {"f": "frequency", "nu": "frequency", "T": "period"}
"""Letters of what a natural angular frequency is counted as."""
_ANGULAR = re.compile(r"(?:omega|Omega|p)(?:_.*)?")
_PER_SECOND = re.compile(
    r"rad/s|s\^\{?-1\}?|s⁻¹|1/s|/s|Hz|s(?![a-z])|rad|\\(?:mathrm|text|,|;|:)|[{}$\s~]"
)
"""Units of an angular frequency, a frequency and a period, and what sets them."""
_IDENTITIES = ("I", "E")
"""Letters of the unit matrix in a determinant."""
_CLOSE = Fraction(1, 50)
"""Part by which a number may be off that is computed with rounded ones."""
_ZERO, _TWO = Number(Fraction(0)), Number(Fraction(2))
_INDEX = re.compile(r"(?:n?[1-9](?:[,/]?[1-9])*|I{1,3}|IV|[ab+-]|pm|s|u|g)")
"""Subscripts that tell roots apart; ω_0, ω_m or ω_c may be abbreviations."""
_LEADS = re.compile(
    r"(?<![^\W\d_])(?:so|hence|thus|then|therefore|giv(?:es?|ing|en)|yields?|get|obtain\w*|find|follows?|leads?|means"
    r"|satisfied|true|vanishes|frequenc\w+|folg\w+|ergeben|ergibt|ergeben|somit|daher|also|daraus|liefert|erhält|erhalten"
    r"|\w*[Ff]requenz\w*|donc|d'où|soit|obtient|donne\w*|pulsation\w*|fréquence\w*|quindi|dunque|dà|ottiene|si\s+ha|frequenz\w*"
    r"|pulsazion\w*|entonces|luego|por\s+tanto|resulta\w*|obtiene\w*|frecuencia\w*|da)(?![^\W\d_])"
    r"|よって|したがって|ゆえに|より|から|固有|振動数|[⇒⟹]|\\(?:Rightarrow|Longrightarrow|implies|iff)(?![A-Za-z])|=>",
    re.IGNORECASE,
)
"""Words that lead from an equation to its roots."""
_SILENT = re.compile(
    r"(?:[\s$,.;:&()\[\]|]|\\[,;:! \[\]()\\]"
    r"|\\(?:q?quad|hspace\{[^{}]*\}|text(?=\{)|mathrm(?=\{))(?![A-Za-z])"
    r"|[{}]"
    r"|\\(?:begin|end)\{(?:equation|align|aligned|gather|gathered)\*?\}"
    r"|(?<![^\W\d_])(?:and|or|und|oder|et|ou|e|o|y|bzw\.?|resp\.?)(?![^\W\d_])|および|または|と|、|。)*+"
)
"""What may stand between an equation and its roots where nothing is said."""
_APART = re.compile(
    r"(?<![^\W\d_])(?:approx\w*|rough\w*|nearly|small|large|weak\w*|strong\w*|limit\w*|uncoupled|special|if|when|unless|where"
    r"|abbreviat\w*|denot\w*|define\w*|let|set(?:ting)?|called|instead|without|not|never|wrong\w*|other\s+than|näherung\w*|genähert"
    r"|etwa|klein\w*|groß\w*|schwach\w*|ungekoppelt\w*|falls|wenn|wobei|worin|abkürzung\w*|setze\w*|ohne|nicht|kein\w*"
    r"|environ|petit\w*|grand\w*|faible\w*|où|notons|posons|pose|ne|non|dove|poniamo|circa|donde|sea|pongamos"
    r"|driv\w*|excit\w*|forcing|operat\w*|running|reference|erreg\w*|anreg\w*|betrieb\w*|bezug\w*|referenz\w*|exploitation"
    r"|average|mean|sum|product|difference|mittel\w*|summe|differenz|produkt|somme|produit)(?![^\W\d_])"
    r"|≈|≪|≫|\\approx|\\ll|\\gg|\\to(?![A-Za-z])|→|近似|ただし|ここで|とおく|ない",
    re.IGNORECASE,
)
"""Words of what is no root of the equation as it stands."""
_BESIDE = re.compile(r"(?<![^\W\d_])(?:with|mit|avec|con)[\s$\\(\[]*$", re.IGNORECASE)
"""A word right before what may be an abbreviation."""


def unless_no_root(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; what stands as a root of an equation set to zero above has to satisfy it."""
    if verdict.verdict in (REFUTED, CONTRADICTION) or (unknown := _unknown(chain, k)) is None:
        return verdict
    found = _equation_above(state, chain, unknown[0])
    if found is None:
        return verdict
    equation, letter, leading = found
    is_root = ROOTS.search(leading) or (_LEADS.search(leading) and not _BESIDE.search(leading))
    if is_said_apart(leading) or not (is_root or _SILENT.fullmatch(leading)):
        return verdict
    decision = _decide_root(state, chain, equation, letter, is_square=unknown[1])
    is_proved = verdict.verdict in (HOLDS, HOLDS_TO_ORDER)
    if decision is None or is_proved or (decision.is_proved and verdict.verdict == CONDITIONAL):
        return verdict
    if decision.status == REFUTED and isinstance(head := chain.sides[0].node, Name):
        state.definitions.forget(head.name, chain.lines[0])
    return describe(state.document, chain, k, decision)


def is_said_apart(words: str) -> bool:
    """Tell whether words between an equation and a formula say that this is no plain result of it."""
    return _APART.search(words) is not None


def _unknown(chain: Chain, k: int) -> tuple[str, bool] | None:
    """Return the letter of which a relation says what it is, and whether it says it of its square."""
    if k or chain.relations[0].sign != "=":
        return None
    head = chain.sides[0].node
    is_square = isinstance(head, Power) and head.exponent == _TWO
    letter = head.base if isinstance(head, Power) and is_square else head
    if not isinstance(letter, Name) or letter.name in names(chain.sides[1].node):
        return None
    return letter.name, is_square


def _equation_above(
    state: JudgingState, chain: Chain, name: str
) -> tuple[tuple[Formula, Formula, int], str, str] | None:
    """Return the equation set to zero above whose unknown a letter is, that, and the words between.

    Roots that stand between them are passed over, and so is what gives one of its letters a formula.
    """
    text, line = state.document.text, chain.lines[0]
    stem, _, index = name.partition("_")
    unknowns = {name, stem} if _INDEX.fullmatch(index) else {name}
    place, words, explained = chain.start, "", ""
    while (other := state.sections.chain_before(place)) is not None:
        if chain.start - other.end > FARTHEST or not state.sections.same_section(other.lines[0], line):
            return None
        between = "" if explained == text[other.end : place] else text[other.end : place]
        words, place = f"{between} {words}", other.start
        if _explains(other, unknowns):  # "where x = cos φ" says what the unknown is
            above = state.sections.chain_before(place)
            explained = text[above.end : place] if above is not None else ""
            continue
        if _is_root_of(other, unknowns):
            if not (_SILENT.fullmatch(between) or ROOTS.search(between) or _LEADS.search(between)):
                return None  # "the makers use k = 0.6"
            continue
        left = _with_identity(state, other, other.sides[-2].node)
        right = other.sides[-1].node
        if other.relations[-1].sign == "=" and right == _ZERO and not isinstance(left, Name):
            own = _names_within(state, other, left)
            letter = next((n for n in (name, stem) if n in unknowns and n in own), None)
            angular = [n for n in own if _ANGULAR.fullmatch(n)]
            if letter is None and stem in _COUNTED and unknowns & {name, stem} and len(angular) == 1:
                letter = angular[0]
            is_wrong = any(side.span[0] in state.refuted for side in other.sides[1:])
            if letter is not None and _is_polynomial(left, letter) and not is_wrong:
                return (left, right, other.lines[0]), letter, words
            return None
        if not all(isinstance(side.node, Name) for side in other.sides[:-1]):
            return None
    return None


def _explains(other: Chain, unknowns: set[str]) -> bool:
    """Tell whether a chain says that the unknown stands for a wave of another letter: x = cos φ."""
    found = _unknown(other, 0)
    right = other.sides[-1].node
    return found is not None and found[0] in unknowns and isinstance(right, Call) and bool(names(right))


def _is_root_of(other: Chain, unknowns: set[str]) -> bool:
    """Tell whether a chain gives one of the letters, or another root, a value: ω², ω_1, ω_2²."""
    found = _unknown(other, 0)
    if found is None:
        return False
    stem, _, index = found[0].partition("_")
    is_alike = stem in unknowns or {stem, *unknowns} <= {*_COUNTED, "omega"} | unknowns
    return found[0] in unknowns or (is_alike and _INDEX.fullmatch(index) is not None)


def _names_within(state: JudgingState, other: Chain, node: Formula) -> set[str]:
    """Return the letters of an equation and of the formulas behind them: of det(K - ω² M), those of K."""
    values = {n: d.node for n, d in _formulas(state.knowledge(other.lines[0])).items()}
    return {*names_behind(node, values)}


def _formulas(knowledge: Knowledge) -> dict[str, Definition]:
    """Return the formulas of letters, without numbers and those that an equation was solved for."""
    return {n: d for n, d in knowledge.definitions.items() if not d.numeric and not d.solved}


def _with_identity(state: JudgingState, other: Chain, node: Formula) -> Formula:
    """Return det(A - λ I) with the unit matrix of A's size for an I or E of which nothing is known."""
    knowledge = state.knowledge(other.lines[0])
    inner = [p for p in walk(node) if isinstance(p, Apply) and p.function == "det"]
    matrices = [
        d.node
        for part in inner
        for name in names(part)
        if (d := knowledge.definitions.get(name)) is not None and isinstance(d.node, Matrix)
    ]
    if not matrices:
        return node
    count = len(matrices[0].rows)
    unit = tuple(tuple(Number(Fraction(int(m == n))) for n in range(count)) for m in range(count))
    for name in _IDENTITIES:
        if name in names(node) and not knowledge.knows(name):
            node = substitute(node, name, Matrix(unit))
    return node


def _is_polynomial(node: Formula, letter: str) -> bool:
    """Tell whether a letter stands in no wave, function or derivative of a formula."""
    inner = (p for p in walk(node) if isinstance(p, Call | Derivative))
    others = (p for p in walk(node) if isinstance(p, Apply) and p.function != "det")
    return not any(letter in names(part) for part in (*inner, *others))


def _decide_root(
    state: JudgingState,
    chain: Chain,
    equation: tuple[Formula, Formula, int],
    letter: str,
    *,
    is_square: bool,
) -> Decision | None:
    """Return whether a value satisfies an equation with every sign it stands with; None where open."""
    left, right, line = equation
    value = chain.sides[1].node
    knowledge = state.knowledge_of(chain, state.knowledge(chain.lines[0]))
    formulas = _formulas(knowledge)
    own = {letter, *(names(chain.sides[0].node))}
    values = {n: d.node for n, d in formulas.items() if n not in own}  # c = cos θ says what c is
    if letter in names(value) or not {*letters_behind(value, values)} <= {*names_behind(left, values)}:
        return None
    has_signs = any(isinstance(part, PlusMinus) for part in walk(value))
    each = [with_sign(value, sign) for sign in (1, -1)] if has_signs else [value]
    wanted = [_as_angular(Call("sqrt", one) if is_square else one, chain, letter) for one in each]
    if not names(value):
        decisions = _as_numbers(state, chain, equation, letter, wanted, knowledge)
    else:
        formulas = {n: d for n, d in formulas.items() if n != letter}
        decisions = [_put_in(left, right, letter, one, formulas, knowledge) for one in wanted]
        every = {n: d for n, d in knowledge.definitions.items() if n != letter and not d.solved}
        if len(every) > len(formulas) and any(d is not None and d.status == REFUTED for d in decisions):
            there = [_put_in(left, right, letter, one, every, knowledge) for one in wanted]
            if not all(d is not None and d.status == REFUTED for d in there):
                return None
    if any(d is not None and d.status == REFUTED for d in decisions):
        wrong = next(d for d in decisions if d is not None and d.status == REFUTED)
        return Decision(REFUTED, f"does not satisfy line {line}", witness=wrong.witness)
    if not all(d is not None and d.is_proved for d in decisions):
        return None
    assumptions = [t for d in decisions if d is not None for t in d.assumptions if "≥ 0" not in t]
    order = next((d.order for d in decisions if d is not None and d.order), "")
    return Decision(
        PROVED, f"satisfies line {line}", order=order, assumptions=tuple(dict.fromkeys(assumptions))
    )


def _put_in(
    left: Formula,
    right: Formula,
    letter: str,
    value: Formula,
    definitions: Mapping[str, Definition],
    knowledge: Knowledge,
) -> Decision | None:
    """Return whether an equation is true with a value put in for its unknown."""
    try:
        written = substitute(_written_out(left, letter, definitions), letter, value)
        known = replace(knowledge, definitions=dict(definitions))
        return decide(lone_side(written), lone_side(right), "=", known)
    except (NoFormError, TooLargeError):
        return None


def _written_out(node: Formula, letter: str, definitions: Mapping[str, Definition]) -> Formula:
    """Return a formula with the letters written out behind which its unknown stands: K of K(ω)."""
    values = {n: d.node for n, d in definitions.items()}
    for name in sorted(names(node)):
        if name in values and letter in names_behind(Name(name), values):
            node = substitute(node, name, values[name])
    return node


def _as_angular(value: Formula, chain: Chain, letter: str) -> Formula:
    """Return the angular frequency of a value whose letter is that of a frequency or a period."""
    found = _unknown(chain, 0)
    stem = "" if found is None else found[0].partition("_")[0]
    if stem not in _COUNTED or stem == letter.partition("_")[0]:
        return value
    turn = Product((_TWO, Constant("pi")))
    return Quotient(turn, value) if _COUNTED[stem] == "period" else Product((turn, value))


def _as_numbers(
    state: JudgingState,
    chain: Chain,
    equation: tuple[Formula, Formula, int],
    letter: str,
    wanted: list[Formula],
    knowledge: Knowledge,
) -> list[Decision | None]:
    """Return for each number whether it solves an equation whose other letters have numbers.

    Between bare numbers it does as it is printed; where the numbers of letters are put in, one that is
    off by little may be computed from rounded ones, and is left open.
    """
    left, right, line = equation
    typed = state.document.source(chain.sides[1].span)
    condition = Premise(left, right, line)
    if names(left) == {letter}:
        if not _is_bare(typed):
            return [None]
        known = Knowledge()
    else:
        known = _with_numbers(left, letter, knowledge)
        if known is None or not _is_bare(_PER_SECOND.sub("", typed)):
            return [None]
    decisions: list[Decision | None] = []
    for value in wanted:
        if any(isinstance(part, Matrix) for d in known.definitions.values() for part in walk(d.node)):
            exactly = _put_in(left, right, letter, value, known.definitions, knowledge)
            decisions.append(None if exactly is None or decimals(value) else exactly)
            continue
        is_root = solves_as_printed(condition, letter, value, known)
        if is_root is False:
            rough = _rounded(value, Fraction(1)) if known.definitions == {} else _rounded(value, _CLOSE)
            is_root = None if solves_as_printed(condition, letter, rough, known) is not False else False
        reason = "the digits printed"
        decisions.append(
            None if is_root is None else Decision(PROVED, order=reason) if is_root else Decision(REFUTED)
        )
    return decisions


def _with_numbers(node: Formula, letter: str, knowledge: Knowledge) -> Knowledge | None:
    """Return what is known where all letters of an equation but its unknown have numbers, else None."""
    own = {n: d for n, d in knowledge.definitions.items() if n != letter and not d.solved}
    values = {n: d.node for n, d in own.items()}
    is_known = letters_behind(node, values) == [letter] and not any(d.is_rough for d in own.values())
    return replace(knowledge, definitions=own) if is_known else None


def _is_bare(typed: str) -> bool:
    """Tell whether a number is typed without a unit."""
    signs = re.sub(r"\\(?:pm|mp|sqrt|[dt]?frac|cdot|left|right)(?![A-Za-z])|sqrt(?=\()", "", typed)
    return re.search(r"[^\W\d_]", signs) is None


def _rounded(value: Formula, share: Fraction) -> Formula:
    """Return a formula whose numbers may be off: whole ones by half a unit, or each by a share."""
    if not isinstance(value, Number):
        return with_parts_changed(value, lambda part: _rounded(part, share))
    if share == 1:
        return value if value.last_place is not None else replace(value, last_place=share)
    return replace(value, last_place=max(abs(value.value) * share, value.last_place or Fraction(0)))
