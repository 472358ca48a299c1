"""Relations that state something: numbers put in for letters, and equations to be solved.

They are premises and conditions, and no line is refuted for them, unless no values satisfy them.

F = m r ω² = 0.5·0.04·628² = 7888       the second = puts numbers in, the third is arithmetic
cos θ = 0,  2θ = 180°,  x² - 3x = 2     a condition
F_1 + F_2 = 0                           a premise, where neither has a value
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import (
    PI,
    Call,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    names,
    walk,
)
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.harmonics import polynomial_node
from symbalance.notes.algebra.letters_behind import letters_behind, names_behind
from symbalance.notes.algebra.series import Expansion
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.equality import (
    PROVED,
    REFUTED,
    UNDECIDED,
    Decision,
    decide_equality,
    without_dots,
)
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.numbers_put_in import constants_put_in, paired
from symbalance.notes.checking.deciding.order_agreement import SmallLetter, truncated_sum
from symbalance.notes.checking.deciding.remainders import has_remainder
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.deciding.satisfiability import survey
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.verdicts import CONDITION, PREMISE
from symbalance.notes.reading.equations import Chain
from symbalance.notes.reading.units import USUAL_SCALES

HIGHEST_ORDER = 8
"""Of the rod ratio's powers that a line with numbers may have been cut off at."""

MANY_WAVES = 3
"""Waves of a sum that is said to vanish for all angles; two may be an equation to be solved."""
UNITS_LEFT_OUT = "the numbers are in units that are left out"
FIXES = "it fixes "
"""How the reason begins of a relation that gives a letter its value."""
NUMBERS_PUT_IN = "numbers put in"
GIVE_IT = "here: give what is put in"
NO_VALUES = "no values satisfy it, as far as tried"
NO_POINT = "no point where both sides are real"
ON_A_BRANCH = "equal at some points and not at others: say for which values it is meant"


def decide_case(
    chain: Chain, k: int, refutation: Decision, knowledge: Knowledge, *, is_solved: bool = False
) -> Decision | None:
    """Return the decision on a refuted relation that only states something; None where it is a claim.

    It puts numbers in for letters, is an equation for one unknown letter, or a balance of letters without
    values (F_1 + F_2 = 0). One that no values satisfy stays refuted. `is_solved` tells that the text
    around takes it for an equation to be solved.
    """
    if any(has_remainder(s.node) or without_dots(s.node)[1] for s in chain.sides[k : k + 2]):
        return None  # an order is a claim, and a series is one
    right = chain.sides[k + 1].node
    is_cut_off = (
        refutation.through is not None and isinstance(right, Number) and right.last_place is not None
    )
    # ≈: no forms were kept, or those of a series: r/l ≈ 0.307 says nothing of an endless rod
    if (refutation.left is None or is_cut_off) and not names(right):
        exactly = decide_equality(chain.sides[k].node, chain.sides[k + 1].node, knowledge)
        refutation = replace(refutation, left=exactly.left, right=exactly.right)
    if (in_units := in_units_left_out(chain, k, knowledge)) is not None:
        return in_units
    word, reason = _kind_of_statement(chain, k, refutation, knowledge)
    if not word and is_solved and refutation.left is not None and letters(refutation.left):
        word = CONDITION
    if not word:
        return None
    left = chain.sides[k].node
    if reason == NUMBERS_PUT_IN and _is_of_sizes(left, right, knowledge):
        return _decide_put_in(left, right, refutation, knowledge)
    level = refutation.level or list(knowledge.levels(left, right))[-1]
    meaning = replace(knowledge.meaning, values=level.values)
    signs = survey(left, right, meaning)
    if not signs.tried and refutation.left is not None and refutation.right is not None:
        first, second = _written(refutation.left), _written(refutation.right)
        signs = survey(first, second, meaning)  # what it comes to: a derivative has no value at a point
    is_solvable = not names(right) and _is_solvable(left, right, refutation)
    if signs.is_equal_in_places and not is_solvable:
        return replace(refutation, status=UNDECIDED, reason=ON_A_BRANCH)
    status, why = (REFUTED, NO_VALUES) if signs.tried else (UNDECIDED, NO_POINT)
    given = Decision(word, reason)
    if not (signs.has_root or is_solvable):
        given = replace(refutation, status=status, reason=why)
    return _unless_against_formulas(left, right, given, knowledge)


def _unless_against_formulas(
    left: Formula, right: Formula, decision: Decision, knowledge: Knowledge
) -> Decision:
    """Return a decision; where a formula of the page forbids a number, which of them is wrong is open."""
    lines = _formulas_against(left, right, knowledge) if decision.reason == NO_VALUES else []
    if not lines:
        return decision
    shown = f"line{'s' * (len(lines) > 1)} {', '.join(map(str, lines))}"
    reason = f"no values satisfy it with {shown}: one of them may be wrong"
    return replace(decision, status=UNDECIDED, reason=reason)


def _formulas_against(left: Formula, right: Formula, knowledge: Knowledge) -> list[int]:
    """Return the lines whose formulas alone keep a number from being possible; none where it never is.

    After A = (1 + m ω²/k) B no ω gives A/B = 0.27, which by itself says nothing impossible.
    """
    values = {name: d.node for name, d in knowledge.definitions.items()}
    behind = {*names(left), *names(right), *names_behind(left, values), *names_behind(right, values)}
    formulas = {n: d for n, d in knowledge.definitions.items() if n in behind and names(d.node)}
    if names(right) or isinstance(left, Name) or not formulas:
        return []
    others = {n: d for n, d in knowledge.definitions.items() if n not in formulas}
    known = replace(knowledge, definitions=others)
    level = list(known.levels(left, right))[-1]
    alone = survey(left, right, replace(knowledge.meaning, values=level.values))
    return sorted({d.line for d in formulas.values()}) if alone.has_root else []


def _is_solvable(left: Formula, right: Formula, refutation: Decision) -> bool:
    """Tell whether a product has a letter without a value that takes any number: G I/L = 4.69·10⁶."""
    if refutation.left is None or any(isinstance(part, Negative) for part in (*walk(left), *walk(right))):
        return False
    free, factors = {*letters(refutation.left)}, [left]
    lone: list[str] = []
    while factors:
        part = factors.pop()
        if isinstance(part, Product):
            factors += part.factors
        elif isinstance(part, Quotient):
            factors += [part.numerator, part.denominator]
        elif names(part) & free:
            lone += [part.name] if isinstance(part, Name) else [*names(part)] * 2
    return right != Number(Fraction(0)) and any(lone.count(name) == 1 for name in free)


def _written(form: Form) -> Formula:
    above, below = (polynomial_node(form.domain, part) for part in (form.numerator, form.denominator))
    return above if form.is_polynomial else Quotient(above, below)


def in_units_left_out(chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return that m R = 0.35·38 holds with R in mm: numbers put in one by one, their units left out."""
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    if names(right) or not names(left) or isinstance(right, Number) or chain.relations[k].sign != "=":
        return None
    are_left_out = False
    if _other_constant(left, right, knowledge) is not None:
        return None
    for part, number in paired(left, right) or ():
        there = decide_equality(part, number, knowledge)
        is_known = there.left is not None and not letters(there.left)
        if not is_known or not (there.is_proved or _is_so_in_some_unit(part, number, knowledge)):
            return None
        are_left_out = are_left_out or not there.is_proved
    return Decision(PROVED, UNITS_LEFT_OUT) if are_left_out else None


def _other_constant(
    left: Formula, right: Formula, knowledge: Knowledge
) -> tuple[Formula, Formula] | None:
    """Return the constant of a formula that is another one among the numbers put in: d F/3 = 0.7·64/2."""
    for constant, number in constants_put_in(left, right):
        there = decide_equality(constant, number, knowledge)
        if there.status == REFUTED and not _is_so_in_some_unit(constant, number, knowledge):
            return constant, number
    return None


def _is_so_in_some_unit(part: Formula, number: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a number put in is a letter's value in mm, lb or another unit, left out there."""
    return any(
        decide_equality(part, Product((number, Number(scale))), knowledge).is_proved
        for scale in USUAL_SCALES
    )


def _is_of_sizes(left: Formula, right: Formula, knowledge: Knowledge) -> bool:
    """Tell whether numbers are put into a product of sizes: some have values, or the numbers are several.

    x + y = 3 and x y = 2 are premises, m r ω² = 2025 a result where m and r are known.
    """
    if isinstance(left, Name) or any(isinstance(part, Sum) for part in walk(left)):
        return False
    if not isinstance(right, Number) and paired(left, right) is not None:
        return True
    return any(n in knowledge.definitions and knowledge.definitions[n].numeric for n in names(left))


def _decide_put_in(left: Formula, right: Formula, refutation: Decision, knowledge: Knowledge) -> Decision:
    """Return the decision on numbers for letters of which some have no values.

    Put in one for each, m r ω² = 0.5·0.04·628², they are given, but for those that have other values. One
    result fixes the one letter without a value; of several it could be judged only if all had values.
    """
    missing = sorted(_free_letters(left, refutation))
    texts = ", ".join(formula_text(Name(name), plain=True) for name in missing)
    have = "has no value" if len(missing) == 1 else "have no values"
    pairs = paired(left, right)
    is_one = len(missing) == 1 and missing[0] not in knowledge.definitions
    is_rate = any("/d" in name for name in missing)  # it may have its number from a line above
    if pairs is None and is_one and not is_rate:
        by_turns = _by_turns(left, right, missing[0], knowledge)
        return by_turns or Decision(PREMISE, f"{FIXES}{texts}, which {have} above")
    if pairs is None:
        return replace(refutation, status=UNDECIDED, reason=f"{texts} {have} {GIVE_IT}")
    if (other := _other_constant(left, right, knowledge)) is not None:
        stands, put = (formula_text(node, plain=True) for node in other)
        return replace(refutation, reason=f"{put} is put in for {stands}")
    for part, number in pairs:
        there = decide_equality(part, number, knowledge)
        is_known = there.left is not None and not letters(there.left)
        if there.status == REFUTED and is_known and not _is_so_in_some_unit(part, number, knowledge):
            put, stands = (formula_text(node, plain=True) for node in (number, part))
            return replace(refutation, reason=f"{put} is put in for {stands}, which has another value")
    return Decision(PREMISE, f"{NUMBERS_PUT_IN}; {texts} {have} above")


def _by_turns(left: Formula, right: Formula, name: str, knowledge: Knowledge) -> Decision | None:
    """Return the decision on P = T ω = 254.8 kW by n = 3000 rpm, where ω has no value; else None."""
    speed = next((n for n in ("n", "N") if n in knowledge.definitions), "")
    if name.casefold() != "omega" or not speed or not knowledge.definitions[speed].numeric:
        return None
    line = knowledge.definitions[speed].line
    text = f"{formula_text(Name(name), plain=True)} = 2π {speed}"
    for scale in (Fraction(2), Fraction(1, 30)):  # n in turns per second, or a bare number per minute
        turned = Product((Number(scale), PI, Name(speed)))
        there = decide_equality(left, right, knowledge.with_definition(name, Definition(turned, line)))
        if there.is_proved:
            return replace(there, assumptions=(*there.assumptions, text))
    return Decision(UNDECIDED, f"not so with {text}: say which speed is meant")


def _free_letters(node: Formula, refutation: Decision) -> set[str]:
    """Return the letters without values in a side, by its form; by its text where it has none, as ε^κ."""
    if refutation.left is not None:
        return set(letters(refutation.left))
    has_power = any(isinstance(part, Power) and _has_no_form(part.exponent) for part in walk(node))
    return set(letters_behind(node, refutation.level.values)) if has_power and refutation.level else set()


def _has_no_form(exponent: Formula) -> bool:
    """Tell whether a power has no normal form: with a letter in its exponent, or a cube root."""
    if names(exponent):
        return True
    if isinstance(exponent, Quotient) and isinstance(exponent.denominator, Number):
        return exponent.denominator.value not in (1, 2)
    return isinstance(exponent, Number) and exponent.value.denominator not in (1, 2)


def _kind_of_statement(
    chain: Chain, k: int, refutation: Decision, knowledge: Knowledge
) -> tuple[str, str]:
    """Return the verdict's word for what a relation states, and the reason; "" for a claim."""
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    is_alone, is_zero = k == 0 and len(chain.relations) == 1, right == Number(Fraction(0))
    free = _free_letters(left, refutation)
    if is_alone and _is_balance_of_unknowns(left, right, knowledge):
        return PREMISE, ""
    if not k and _is_of_an_angle(left, right, knowledge):
        return CONDITION, "an equation for an angle"
    if names(right) or not names(left) or not free or _is_of_shifted_waves(left):
        return "", ""
    if free & knowledge.angles:
        is_condition = is_alone and (
            is_simple(left)
            or _is_product(left, right, knowledge)
            or (is_zero and _is_of_several_orders(left, knowledge))
        )
        return (CONDITION, "") if is_condition else ("", "")
    is_equation = names(left) == free and not knowledge.has_meaning(min(free))
    if is_alone and len(free) == 1 and (is_equation or not is_zero):
        is_arithmetic = not isinstance(right, Number) and len(names(left)) > 1
        return (PREMISE, NUMBERS_PUT_IN) if is_arithmetic and paired(left, right) else (CONDITION, "")
    numeric_letters = {n for n, d in knowledge.definitions.items() if d.numeric}
    return ("", "") if is_zero or names(left) <= numeric_letters else (PREMISE, NUMBERS_PUT_IN)


def _is_of_an_angle(left: Formula, right: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a wave of one crank angle is equal to sizes that do not turn: cos θ = −1/(4λ)."""
    if not isinstance(left, Call) or left.function not in ("sin", "cos", "tan") or not names(right):
        return False
    own = names(left)
    if (
        len(own) != 1
        or not own <= knowledge.angles
        or own & (knowledge.definitions.keys() | names(right))
    ):
        return False  # cos 2θ = cos²θ + sin²θ is an identity, and wrong
    try:
        sizes = letters(knowledge.evaluator(list(knowledge.levels(left, right))[-1]).form(right))
    except (NoFormError, TooLargeError):
        return False
    return is_simple(left.argument) and not knowledge.angles & {*sizes}


def _is_of_shifted_waves(node: Formula) -> bool:
    """Tell whether a sum is of one wave at several places: cos t + cos(t + 120°) + … is 0 for all t."""
    waves = [term.operand if isinstance(term, Negative) else term for term in _terms(node)]
    calls = [wave for wave in waves if isinstance(wave, Call) and wave.function in ("sin", "cos")]
    if len(calls) < MANY_WAVES or len(calls) < len(waves) or len({call.function for call in calls}) > 1:
        return False
    letters_of_waves = {names(call.argument) for call in calls}
    numbers = [part for call in calls for part in walk(call.argument) if isinstance(part, Sum)]
    return len(letters_of_waves) == 1 and len(numbers) >= len(calls) - 1


def _is_balance_of_unknowns(left: Formula, right: Formula, knowledge: Knowledge) -> bool:
    """Tell whether letters without values are balanced: F_1 + F_2 = 0, or F_1 + F_2 = F_3 + 2."""
    if any(_is_given(n, knowledge) for n in names(left) | names(right)) or not names(left):
        return False
    if names(right):
        return _has_number(left, right) and _is_balance(Sum((left, right)))
    return _is_balance(left)


def _has_number(*nodes: Formula) -> bool:
    """Tell whether a number stands alone among the terms: F_1 + F_2 = F_3 + 2 claims no identity."""
    return any(isinstance(term, Number) for node in nodes for term in _terms(node))


def _terms(node: Formula) -> tuple[Formula, ...]:
    return node.terms if isinstance(node, Sum) else (node,)


def _is_balance(node: Formula) -> bool:
    """Tell whether a formula is a sum of letters, each once, perhaps times numbers: F_1 + 2 F_2."""
    parts = [part for term in _terms(node) for part in _terms(term)]
    terms = [part for part in parts if not isinstance(part, Number)]
    bare = [term.operand if isinstance(term, Negative) else term for term in terms]
    single = [
        term.factors[1]
        if isinstance(term, Product) and len(term.factors) == 2 and isinstance(term.factors[0], Number)
        else term
        for term in bare
    ]
    letters_of_terms = [term.name for term in single if isinstance(term, Name)]
    return 1 < len(terms) == len(set(letters_of_terms))


def _is_given(name: str, knowledge: Knowledge) -> bool:
    definition = knowledge.definitions.get(name)
    return knowledge.has_meaning(name) if definition is None else not definition.solved


def states_a_case(chain: Chain) -> bool:
    """Tell whether a chain gives one letter, or a function of it, a number: α = 45°, tan δ = 1/3.

    Such a chain is taken first of those on its line: a condition often stands behind what it holds for.
    """
    if len(chain.sides) != 2 or names(chain.sides[1].node):
        return False
    left = chain.sides[0].node
    return isinstance(left, Name) or (isinstance(left, Call) and isinstance(left.argument, Name))


def decide_with_ratio(left: Formula, right: Formula, knowledge: Knowledge) -> Decision | None:
    """Return the decision on a ≈ r ω²(cos θ + ¼ cos 2θ) after λ = 4: cut off at an order, then put in.

    None unless the ratio has a number, does not stand on the right, and some order agrees.
    """
    small = knowledge.crank.small if knowledge.crank else None
    definition = knowledge.definitions.get(small[0]) if small else None
    if small is None or definition is None or not definition.numeric or small[0] in names(right):
        return None
    level = list(knowledge.levels(left, right))[-1]
    evaluator = knowledge.evaluator(level)
    try:
        exact = Expansion(evaluator.domain, *small, HIGHEST_ORDER).of(evaluator.form(left))
        for order in range(HIGHEST_ORDER + 1):
            cut_off = truncated_sum(exact.cut(order), SmallLetter(*small, order))
            series = polynomial_node(evaluator.domain, cut_off.numerator)
            node = substitute(series, small[0], definition.node)
            if decide_equality(node, right, knowledge).is_proved:
                as_given = _exact_beside_finer(definition.node, right)
                of_given = substitute(series, small[0], as_given) if as_given else node
                if not decide_equality(of_given, right, knowledge).is_proved:
                    text, given = (formula_text(n, plain=True) for n in (Name(small[0]), definition.node))
                    return Decision(
                        UNDECIDED, f"{text} is given as {given}, and no line has more digits of it"
                    )
                name = SmallLetter(*small, order).text
                return Decision(
                    PROVED,
                    f"with {formula_text(Name(small[0]), plain=True)} of line {definition.line}",
                    order=name,
                )
    except (NoFormError, TooLargeError):
        return None
    return None


def _exact_beside_finer(number: Formula, right: Formula) -> Number | None:
    """Return a number as its digits say, where a formula has a number with more digits; else None."""
    if not isinstance(number, Number) or number.last_place is None:
        return None
    places = [each.last_place for each in decimals(right) if each.last_place is not None]
    return Number(number.value) if any(place < number.last_place for place in places) else None


def _is_product(left: Formula, right: Formula, knowledge: Knowledge) -> bool:
    """Tell whether sin θ (1 + 2ρ cos θ) = 0 is stated: a product of functions of an angle is to be 0."""
    if right != Number(Fraction(0)) or not isinstance(left, Product):
        return False
    return sum(bool(names(factor) & knowledge.angles) for factor in left.factors) > 1


def _is_of_several_orders(left: Formula, knowledge: Knowledge) -> bool:
    """Tell whether cos θ + λ cos 2θ = 0 is stated: waves of unlike orders, which never cancel."""
    terms = [part.operand if isinstance(part, Negative) else part for part in _terms(left)]
    arguments = []
    for term in terms:
        calls = [
            part for part in walk(term) if isinstance(part, Call) and part.function in ("sin", "cos")
        ]
        is_wave = len(calls) == 1 and names(term) - names(calls[0]) == names(term) - knowledge.angles
        if not is_wave or not is_simple(calls[0].argument):
            return False
        arguments.append(calls[0].argument)
    return len(terms) > 1 and all(a != b for n, a in enumerate(arguments) for b in arguments[:n])


def is_simple(node: Formula) -> bool:
    """Tell whether a side is a function of an angle, or a multiple of a letter, as in a condition."""
    if isinstance(node, Negative):
        return is_simple(node.operand)
    if isinstance(node, Product):
        return (
            len(node.factors) == 2 and isinstance(node.factors[0], Number) and is_simple(node.factors[1])
        )
    if isinstance(node, Call):
        return node.function in ("sin", "cos", "tan") and is_simple(node.argument)
    return isinstance(node, Name)
