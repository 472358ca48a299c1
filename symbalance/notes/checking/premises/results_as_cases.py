"""Results that look like new cases: M = F a - F a/3, so M = 0; 1. ω = 2π·3000/60, 2. so ω = 364.2.

Another value of a letter may be that of another case. It is none where words lead to it from the formula
or the arithmetic right above as to its result, or where a summary states it once more.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Summation,
    names,
)
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.premises.definitions import Definitions
from symbalance.notes.checking.verdicts import CONTRADICTION
from symbalance.notes.checking.words.case_words import opens_case
from symbalance.notes.checking.words.cases_named import names_another_example
from symbalance.notes.checking.words.plain_formulas import lone_side, plain_text
from symbalance.notes.checking.words.worked_out import is_worked_out
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_ENDS = r"(?:[\s$,;:.)\]}&|*_]|\\(?:[,;: \\\]\[()]|q?quad(?![a-z])|(?:begin|end)\{[a-z*]{1,12}\}))"
_ARROW = r"\\(?:Rightarrow|implies|Longrightarrow|therefore)(?![A-Za-z])|[⇒⟹→∴]"
_LEADS = (
    r"so|hence|thus|therefore|then|consequently|which|that|this|it|and|we|one|gives?|giving|yields?|get|gets|obtain|obtains|find"
    r"|finds|have|follows|comes?|out|as|to|is|becomes?|value|results?|(?:the|its|our|a)|answer|force|couple|moment|total|sum|all"
    r"|also|daher|daraus|hieraus|damit|somit|folglich|demnach|das|dies|es|ergibt|liefert|gilt|folgt|wird|und|man|erhält|wir|erhalten|der|die"
    r"|sich|ergebnis|wert|zu|ist|donc|d'où|ainsi|soit|cela|donne|résultat|on|obtient|da|luego|entonces|resulta|quindi|dunque"
)
_CANCELS = (
    r"cancels?|cancell?ed|cancell?ing|vanish(?:es)?|disappears?|out|off|altogether|completely|hebt|heben|auf|weg|verschwindet"
    r"|s'annule|se|anula|annulla|compensates?"
)
_JAPANESE = (
    r"よって|したがって|従って|ゆえに|すなわち|これより|より|となる|打ち消し合(?:う|い)|結果|は|が|、|。"
)
_LINKS = re.compile(
    rf"(?:{_ENDS}|{_ARROW}|(?<![^\W\d_])(?:{_LEADS}|{_CANCELS})(?![^\W\d_])|{_JAPANESE})*", re.IGNORECASE
)
"""Nothing but words that lead to a result."""
_RESULT = re.compile(
    rf"{_ARROW}|(?<![^\W\d_])(?:so|hence|thus|therefore|consequently|gives?|giving|yields?|follows|daher|damit|somit|folglich|demnach"
    rf"|ergibt|liefert|folgt|donc|d'où|ainsi|donne|luego|entonces|quindi|dunque|{_CANCELS})(?![^\W\d_])|よって|したがって|ゆえに|打ち消",
    re.IGNORECASE,
)
_NOT_ALWAYS = re.compile(
    r"(?<![^\W\d_])(?:at|when|whenever|if|where|while|equal|same|identical|symmetr\w*|special|balanced|opposite|equilibrium|rest"
    r"|mean|average|bei|wenn|falls|im|gleich\w*|entgegengesetzt\w*|symmetrisch\w*|gleichgewicht|mittel\w*|à|quand|si|égal\w*)"
    r"(?![^\W\d_])|dead\s+cent|totpunkt|死点|のとき|場合|[0-9]\s*\$?\s*(?:°|\^)",
    re.IGNORECASE,
)
"""Words by which a formula is of one place or one kind, and 0 there."""
_MARK = re.compile(
    r"(?:^|\n)[ \t>]*(?:[-*+•]|\\item|\(?(?:[0-9]{1,2}|[a-h])[.)]|"
    r"(?:step|part|schritt|teil|étape|paso|手順)\s*[0-9a-h]{1,2}\s*[:.)]?)"
    r"[*_]{0,2}[ \t]*",
    re.IGNORECASE,
)
_SUMMARY = re.compile(
    r"(?<![^\W\d_])(?:summary|summaries|results?|conclusions?|overview|zusammenfassung|ergebniss?e?|überblick|résumé|résultats?"
    r"|conclusión|resumen|resultados?|riassunto|risultati)(?![^\W\d_])|まとめ|結果|結論",
    re.IGNORECASE,
)
NO_RESULT = "not the result of"
FARTHEST = 120
"""Characters between a formula and the result of it."""


def refute_result(
    definitions: Definitions,
    name: str,
    value: Formula,
    earlier: Definition,
    chain: Chain,
    knowledge: Knowledge,
) -> Decision | None:
    """Return that a number is not what its formula or arithmetic comes to; None for a case."""
    if names(value) or len(chain.relations) != 1 or chain.relations[0].sign not in "=≈":
        return None
    sections = definitions.sections
    above = sections.last_above(Name(name), chain.start)
    if (
        above is None
        or above.lines[0] != earlier.line
        or opens_case(sections.document.text, chain.start, chain.end)
    ):
        return None
    if names(earlier.node):
        is_wrong = _is_false_zero(definitions, value, earlier.node, above, chain, knowledge)
    else:
        is_wrong = earlier.formula is None and _is_of_arithmetic(definitions, value, above, chain)
    if not is_wrong:
        return None
    text = f"{plain_text(Name(name))} = {plain_text(earlier.node)}"
    return Decision(CONTRADICTION, f"{NO_RESULT} {text} of line {earlier.line}")


def is_led_to(definitions: Definitions, value: Formula, chain: Chain) -> bool:
    """Tell whether words lead from a letter's formula right above to a bare number: u = cos θ, so u = 2.

    No case of its own is opened there; where the formula comes to that number is for its letters to say.
    """
    sections, text = definitions.sections, definitions.sections.document.text
    bare = value.operand if isinstance(value, Negative) else value
    if (
        not isinstance(bare, Number)
        or len(chain.relations) != 1
        or opens_case(text, chain.start, chain.end)
    ):
        return False
    above = sections.last_above(chain.sides[0].node, chain.start)
    if above is None or sections.end_before(chain.start) != above.end:
        return False
    between = text[above.end : chain.start]
    is_result = len(between) <= FARTHEST and _RESULT.search(between) is not None
    behind = re.split(r"[.;。；]\s|\n\s*\n", text[chain.end : chain.end + FARTHEST], maxsplit=1)[0]
    if not is_result or _LINKS.fullmatch(between) is None:
        return False
    return not _NOT_ALWAYS.search(sections.sentence_leading_to(above)) and not _NOT_ALWAYS.search(behind)


def _is_false_zero(
    definitions: Definitions,
    value: Formula,
    formula: Formula,
    above: Chain,
    chain: Chain,
    knowledge: Knowledge,
) -> bool:
    """Tell whether words lead from a formula right above to 0, and it is 0 for none of its letters."""
    sections, text = definitions.sections, definitions.sections.document.text
    between = text[above.end : chain.start]
    is_result = len(between) <= FARTHEST and _RESULT.search(between) is not None
    if not isinstance(value, Number) or value.value:
        return False
    is_next = sections.end_before(chain.start) == above.end
    if not is_result or not is_next or _LINKS.fullmatch(between) is None:
        return False
    behind = re.split(r"[.;。；]\s|\n\s*\n", text[chain.end : chain.end + FARTHEST], maxsplit=1)[0]
    if _NOT_ALWAYS.search(sections.sentence_leading_to(above)) or _NOT_ALWAYS.search(behind):
        return False
    values = {n: d.node for n, d in knowledge.definitions.items()}
    letters = {*names_behind(formula, values)}
    known = [knowledge.definitions[n] for n in letters if n in knowledge.definitions]
    if any(d.numeric for d in known) or any(
        p.names & letters for p in definitions.premises_at(chain.lines[0])
    ):
        return False
    if not _has_one_size(formula):
        return False
    return decide(lone_side(formula), lone_side(value), "=", knowledge).status == REFUTED


def _has_one_size(formula: Formula) -> bool:
    """Tell whether all terms have the same letters, but for what turns: none cancels another."""
    terms = formula.terms if isinstance(formula, Sum) else (formula,)
    sizes = [_size(term) for term in terms]
    return None not in sizes and all(size == sizes[0] for size in sizes)


def _size(node: Formula, sign: int = 1) -> Counter[str] | None:
    """Return the letters of a product, each with its power; None where a factor has several sizes."""
    size: Counter[str] | None = None
    match node:
        case Negative(operand=inner) | Summation(body=inner):
            size = _size(inner, sign)
        case Number() | Call():
            size = Counter()
        case Name(name=name):
            size = Counter({name: sign})
        case Product(factors=factors):
            size = _together(_size(factor, sign) for factor in factors)
        case Quotient(numerator=above, denominator=below):
            size = _together((_size(above, sign), _size(below, -sign)))
        case Power(base=Name(name=name), exponent=Number(value=power)) if power.denominator == 1:
            size = Counter({name: sign * int(power)})
        case Sum(terms=terms) if _has_one_size(node):
            size = _size(terms[0], sign)
        case _ if not names(node):
            size = Counter()
        case _:
            pass
    return size


def _together(sizes: Iterable[Counter[str] | None]) -> Counter[str] | None:
    """Return the letters of factors, each with its power; None where one has none."""
    total: Counter[str] = Counter()
    for size in sizes:
        if size is None:
            return None
        total.update(size)
    return total


def _is_of_arithmetic(definitions: Definitions, value: Formula, above: Chain, chain: Chain) -> bool:
    """Tell whether a number is said to be what an arithmetic comes to, or is stated once more."""
    sections = definitions.sections
    document = sections.document
    if not is_worked_out(document.source(above.sides[1].span)) or is_worked_out(
        document.source(chain.sides[1].span)
    ):
        return False
    between = document.text[above.end : chain.start]
    if names_another_example(between[-FARTHEST:]):
        return False
    is_open = len(above.relations) == 1
    if is_open and sections.same_section(above.lines[0], chain.lines[0]):
        is_near = len(between) <= FARTHEST and sections.end_before(chain.start) == above.end
        return is_near and _LINKS.fullmatch(_without_unit(_MARK.sub(" ", between))) is not None
    return _is_in_summary(definitions, above, chain)


def _without_unit(words: str) -> str:
    """Return the words behind a number without the unit that they begin with."""
    return re.sub(
        r"^[\s$}]*(?:k?N(?:\s?m)?|mm|cm|m/s²?|m|kg|g|rad/s|1/s|rpm|k?W|MPa|bar)(?![A-Za-z])", " ", words
    )


def _is_in_summary(definitions: Definitions, above: Chain, chain: Chain) -> bool:
    """Tell whether a letter of one value on the page stands below a heading that sums up."""
    sections = definitions.sections
    if sections.same_section(above.lines[0], chain.lines[0]):
        return False
    if not _SUMMARY.search(sections.heading_above(chain.lines[0])):
        return False
    first = sections.start_of_line(chain.lines[0])
    words = _MARK.sub(" ", sections.document.text[first : chain.start])
    is_bare = re.search(r"[0-9]", words) is None and "=" not in words
    others = [c for c in sections.chains_of(chain.sides[0].node) if c is not chain and c is not above]
    return is_bare and not any(not names(c.sides[-1].node) for c in others)
