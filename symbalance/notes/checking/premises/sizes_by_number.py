"""Numbers given to sizes that other letters make up: s = 2r = 87 gives r = 43.5."""

from __future__ import annotations

from symbalance.document.formula import Formula, Name, names
from symbalance.notes.algebra.domain import Domain, NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.equality import PROVED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.premises.another_value import refuse_case
from symbalance.notes.checking.premises.constraints import letter_counts, solve_for
from symbalance.notes.checking.premises.definitions import Definitions
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.verdicts import DEFINITION, PREMISE
from symbalance.notes.checking.words.plain_formulas import lone_side, plain_text
from symbalance.notes.reading.equations import Chain


def define_size(
    definitions: Definitions, name: str, value: Formula, chain: Chain, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on a size that is fixed by itself, such as l = 4r: a case, λ = 4."""
    if knowledge.crank is None or knowledge.crank.small is None or name in knowledge.moving:
        return None
    by_numbers = _define_by_number(definitions, name, value, chain, knowledge)
    if by_numbers is not None:
        return by_numbers
    small, evaluator = knowledge.crank.small[0], FormEvaluator(Domain(), knowledge.meaning)
    try:
        ratio = evaluator.letter(name).over(evaluator.form(value))
    except (NoFormError, TooLargeError):
        return None
    if not ratio.is_polynomial or len(ratio.numerator) != 1 or letters(ratio) != [small]:
        return None
    ((monomial, coefficient),) = ratio.numerator.items()
    if [abs(exponent) for _, exponent in monomial] != [1]:
        return None
    number = 1 / coefficient if monomial[0][1] > 0 else coefficient
    return _define_case(definitions, small, rational_node(number), chain, knowledge)


def _define_by_number(
    definitions: Definitions, name: str, value: Formula, chain: Chain, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on a size with a number: s = 2r = 87 gives r, l = 160 after r = 40 gives λ.

    A letter that has a number, and what was solved from it, keeps it within the section.
    """
    node, line, reasons = knowledge.meaning.values[name], chain.lines[0], list[str]()
    if names(value):
        return None
    for letter in sorted(names(node)):
        known = knowledge.definitions.get(letter)
        is_other = len(names(node)) > 1
        if known is None or not known.numeric or not is_other or letter in knowledge.angles:
            continue
        if not definitions.is_stale(letter, knowledge):
            node = substitute(node, letter, known.node)
            reasons.append(f"{plain_text(Name(letter))} = {plain_text(known.node)}")
    base = _solve_for_one_letter(node, value)
    if base is None:
        return None
    letter, solution = base
    earlier = knowledge.definitions.get(letter)
    if earlier is not None and earlier.numeric and not definitions.is_stale(letter, knowledge):
        again = decide(lone_side(solution), lone_side(earlier.node), "=", knowledge)
        if again.is_proved:
            return None  # said before: it is decided by numbers
        if _agrees_in_another_letter(definitions, name, value, knowledge):
            return Decision(PROVED, order="the digits printed")
        refusal = refuse_case(definitions, letter, solution, earlier, chain, knowledge)
        if refusal is not None:
            return refusal
    word = PREMISE if definitions.define(letter, solution, chain) else DEFINITION
    text = f"{plain_text(Name(letter))} = {_as_number(solution, knowledge)}"
    if reasons:
        behind = [(n, knowledge.definitions.get(n)) for n in names(knowledge.meaning.values[name])]
        definitions.solved_from[letter] = (line, {n: d and d.node for n, d in behind if n != letter})
    return Decision(word, f"with {' and '.join(reasons)}: {text}" if reasons else "")


def _solve_for_one_letter(node: Formula, value: Formula) -> tuple[str, Formula] | None:
    """Return the one letter a size is written in, and its value if the size has a number: s = 2r = 87."""
    counts = letter_counts(node)
    if names(value) or list(counts.values()) != [1]:
        return None
    (letter,) = counts
    solution = solve_for(node, value, letter)
    return None if solution is None else (letter, solution)


def _agrees_in_another_letter(
    definitions: Definitions, name: str, value: Formula, knowledge: Knowledge
) -> bool:
    """Tell whether a size agrees with the digits printed of a letter it rests on.

    After r = 43, λ = 0.3 the rod's length 145 gives r = 43.5, but λ = 0.297, which is 0.3.
    """
    node = knowledge.meaning.values[name]
    known = {n: d.node for n in names(node) if (d := knowledge.definitions.get(n)) and d.numeric}
    for letter, earlier in known.items():
        rest = node
        for other, number in known.items():
            rest = substitute(rest, other, number) if other != letter else rest
        base = _solve_for_one_letter(rest, value)
        if base and decide(lone_side(base[1]), lone_side(earlier), "=", knowledge).is_proved:
            return True
    return False


def _define_case(
    definitions: Definitions, small: str, number: Formula, chain: Chain, knowledge: Knowledge
) -> Decision:
    """Return the decision on a size that gives the ratio a number: a case, or a contradiction."""
    earlier = knowledge.definitions.get(small)
    if earlier is not None and earlier.numeric:
        again = decide(lone_side(number), lone_side(earlier.node), "=", knowledge)
        if not again.is_proved:
            refusal = refuse_case(definitions, small, number, earlier, chain, knowledge)
            if refusal is not None:
                return refusal
    word = PREMISE if definitions.define(small, number, chain) else DEFINITION
    return Decision(word, f"a case: {plain_text(Name(small))} = {_as_number(number, knowledge)}")


def _as_number(node: Formula, knowledge: Knowledge) -> str:
    """Return the number that a formula comes to, in six digits at most; the formula if it is none."""
    value = number_of(node, knowledge)
    return plain_text(node) if value is None else f"{float(value):.6g}"
