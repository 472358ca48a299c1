r"""Relations of letters set as vectors or matrices, \mathbf{A}, \vec a, that are proved of numbers only.

They are read as letters of numbers, and most that pages say of forces and motions is as true of vectors:
sums, and products with numbers. Where vectors and matrices stand in products, powers and lengths the two
sides are compared in arrays too. A bold capital may be a vector or a matrix; what is true of one kind
only is left open, and so is what other lines or words may make true.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from itertools import product

from symbalance.document.formula import (
    Apply,
    Call,
    Constant,
    Formula,
    Matrix,
    Name,
    Number,
    Power,
    Product,
    Quotient,
    names,
    parts_of_kind,
    walk,
)
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.values_of_arrays import (
    MATRIX,
    VECTOR,
    ArrayValues,
    MisfitError,
    NoArrayError,
    Value,
    entries,
    gap,
    inverse,
    is_close,
    times,
    transposed,
)
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import DEFINITION, PROVED_WORDS, Verdict
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.checking.words.sentences import SENTENCE_END
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

_FONTS = r"\\(?:mathbf|boldsymbol|bm|mathbfit|symbf|pmb|vb|bf)(?![A-Za-z])"
_BOLD = re.compile(_FONTS)
_BOLD_BEFORE = re.compile(rf"{_FONTS}\s*(?:\{{[^{{}}]{{0,24}})?$")
_BEFORE = 36
"""Characters before a letter in which the command for its font stands."""
_LENGTH = re.compile(r"(?:\\left\s*)?(?:\\\||\\lVert(?![A-Za-z])|‖)")
_VEC = "vec_"
_SPECIAL = re.compile(
    r"commut|vertausch|kommut|conmut|可換|交換|diagonal|対角|symmetri|対称|orthogonal|直交|orthonorm|parallel|平行|co-?linear"
    r"|kollinear|collin[eé]a|perpendic|senkrecht|垂直|gleichgerichtet|gleichsinnig|same\s+(?:direction|line|axis|sense)"
    r"|gleiche[nr]?\s+(?:Richtung|Achse)|même\s+(?:direction|sens|axe)|同じ向き|同方向|unit\s+vector|Einheitsvektor|unitaire|単位"
    r"|aligned|in\s+line|one\s+(?:direction|axis)|simétric|paralel|symétri|parallèl|scalar\s+multiple|nilpotent|proportional",
    re.IGNORECASE,
)
"""Words of vectors and matrices of which more is true than of any."""
_PARALLEL = re.compile(
    r"(?<!not )(?<!nicht )(?<!non )(?<!un)(?:parallel|co-?linear|kollinear|collin[eé]a|paralel|parallèl"
    r"|aligned|gleichgerichtet|gleichsinnig|(?:same|one)\s+(?:direction|line|sense)|in\s+line|gleiche[nr]?\s+Richtung|même\s+(?:direction|sens)"
    r"|stess[oa]\s+(?:direzione|verso)|misma\s+dirección|平行|同じ向き|同方向)",
    re.IGNORECASE,
)
"""Words of vectors that all have one direction."""
_NEAR = 120
"""Characters behind a relation in which its sentence may say so."""
_MOST_LETTERS = 6
"""Capital letters of which each is tried as a vector and as a matrix."""
_MOST_PREMISES = 8
_FIXES = "read as what fixes"

NEITHER = "true of numbers; sizes of vectors and matrices that do not fit"
OF_NUMBERS = "true of numbers, whose products commute and are divided by: not of vectors or matrices"
OF_VECTORS = "true of vectors; as matrices its letters do not commute: say what they are"


def unless_of_arrays(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; what is proved of numbers and fails of vectors and matrices is not confirmed."""
    is_fixed = verdict.verdict == DEFINITION and verdict.reason.startswith(_FIXES)
    if not is_fixed and verdict.verdict not in PROVED_WORDS:
        return verdict
    sides = [chain.sides[k].node, chain.sides[k + 1].node]
    faces = _Faces(state.document, sides)
    if not any(map(faces.has_arrays, sides)):
        return verdict
    faces.numbers = _numbers(state.knowledge(chain.lines[0]))
    if not any(map(faces.has_arrays, sides)):
        return verdict
    decision = _of_arrays(state, chain, k, faces, is_fixed=is_fixed)
    if decision is None:
        return verdict
    if decision.reason == OF_NUMBERS and _is_of_one_direction(state, chain, k, faces):
        return verdict
    for name in (*names(sides[0]), *names(sides[1])) if is_fixed else ():
        state.definitions.forget_line(name, chain.lines[0])
    return describe(state.document, chain, k, decision)


def _numbers(knowledge: Knowledge) -> frozenset[str]:
    """Return the letters that a page gives numbers: set in bold they are none but numbers."""
    known = knowledge.definitions.items()
    return frozenset(n for n, d in known if d.numeric and d.node != Number(Fraction(0)))


def _of_arrays(
    state: JudgingState, chain: Chain, k: int, faces: _Faces, *, is_fixed: bool
) -> Decision | None:
    """Return the decision on a relation that fails as one of vectors and matrices; None for others."""
    sides = [chain.sides[k].node, chain.sides[k + 1].node]
    knowledge = state.knowledge_of(chain, state.knowledge(chain.lines[0]))
    given = {n for n, d in knowledge.definitions.items() if any(parts_of_kind(d.node, Matrix))}
    own_letters = names(sides[0]) | names(sides[1])
    if not own_letters.isdisjoint(knowledge.meaning.kinds.letters | given):
        return None  # declared, or with entries: judged as what they are
    values = {name: d.node for name, d in knowledge.definitions.items() if not d.solved}
    values |= knowledge.meaning.values
    behind = [*sides, *(node for n, node in values.items() if n in own_letters)]
    if any(part == Constant("i") or part == Name("j") for node in behind for part in walk(node)):
        return None  # phasors are called vectors too, and commute
    others = list(_beside(chain, state.document, faces, sides))
    own = any(map(faces.multiplies, sides))
    before = [pair for other, pair in others if other.end <= chain.start]
    before += [(a.node, b.node) for a, b in zip(chain.sides[:k], chain.sides[1 : k + 1], strict=True)]
    if not own and not any(faces.multiplies(node) for pair in before for node in pair):
        return None
    claim = _Claim(sides[0], sides[1], before[-_MOST_PREMISES:], values, faces)
    stems = {name.removeprefix(_VEC) for name in claim.letters()}
    if not all(claim.letters_behind([side]) or faces.stems(side) & stems for side in sides):
        return None  # a number: what other lines say of sizes
    if is_fixed:
        is_about_both = own and faces.stems(sides[0]) == faces.stems(sides[1])
        decision = _decide(claim, may_refute=True) if is_about_both else None
        is_wrong = decision is not None and decision.status == REFUTED and not others
        return decision if is_wrong and _is_plain(chain, state.sections) else None
    return _decide(claim, may_refute=own and not others and _is_plain(chain, state.sections))


def _is_of_one_direction(state: JudgingState, chain: Chain, k: int, faces: _Faces) -> bool:
    """Tell whether a relation's sentence speaks of parallel vectors, and it is true of such ones."""
    behind = SENTENCE_END.split(state.document.text[chain.end : chain.end + _NEAR])[0]
    if not _PARALLEL.search(f"{state.sections.sentence_before(chain)} {behind}"):
        return False
    sides = [chain.sides[k].node, chain.sides[k + 1].node]
    kinds = dict.fromkeys(sorted(faces.arrays_of(sides[0]) | faces.arrays_of(sides[1])), VECTOR)
    at = ArrayValues(kinds, {}, faces.is_array, 1, of_one_direction=True)
    try:
        return is_close(at.value(sides[0]), at.value(sides[1])) is True
    except (MisfitError, NoArrayError):
        return False


def _is_plain(chain: Chain, sections: Sections) -> bool:
    """Tell whether a relation is claimed, of any vectors or matrices."""
    is_case = sections.opens_case(chain) or sections.is_supposed(chain) or sections.is_condition(chain)
    is_case = is_case or sections.is_denied(chain) or sections.is_said_to_fail(chain)
    return not is_case and _SPECIAL.search(sections.document.text) is None


def _beside(
    chain: Chain, document: ReadNotes, faces: _Faces, sides: list[Formula]
) -> Iterator[tuple[Chain, tuple[Formula, Formula]]]:
    """Yield the other equations of a page in which vectors or matrices of this one stand."""
    own = {name for node in sides for name in faces.arrays_of(node)}
    for other in document.chains:
        if other.start == chain.start or own.isdisjoint(other.letters):
            continue
        for relation, first, second in zip(other.relations, other.sides, other.sides[1:], strict=False):
            if relation.sign == "=":
                yield other, (first.node, second.node)


class _Faces:
    """How letters are set: as vectors, matrices, or numbers."""

    def __init__(self, document: ReadNotes, sides: list[Formula]) -> None:
        self._text = document.text
        self._faces: dict[tuple[int, int], bool] = {}
        self.numbers: frozenset[str] = frozenset()
        self._in_lengths = {
            name
            for node in sides
            for call in parts_of_kind(node, Call)
            if call.function == "abs" and _LENGTH.match(self._text, call.span[0])
            for name in names(call.argument)
        }

    def is_array(self, node: Name) -> bool:
        """Tell whether a letter is set as a vector or a matrix where it stands."""
        if node.name in self.numbers:
            return False
        if self.is_named(node.name):
            return True
        if node.span not in self._faces:
            start, end = node.span
            before = self._text[max(0, start - _BEFORE) : start]
            is_bold = _BOLD.search(self._text, start, end) or _BOLD_BEFORE.search(before)
            self._faces[node.span] = start < end and is_bold is not None
        return self._faces[node.span]

    def is_named(self, name: str) -> bool:
        """Tell whether a letter is a vector by its name, or stands between the bars of a length."""
        return name.startswith(_VEC) or name in self._in_lengths

    def arrays_of(self, node: Formula) -> set[str]:
        """Return the letters of a formula that are set as vectors or matrices."""
        return {part.name for part in parts_of_kind(node, Name) if self.is_array(part)}

    def has_arrays(self, node: Formula) -> bool:
        """Tell whether a formula has such a letter."""
        return bool(self.arrays_of(node))

    def stems(self, node: Formula) -> set[str]:
        """Return the letters of a formula, however they are set."""
        return {name.removeprefix(_VEC) for name in names(node)}

    def kinds_of(self, name: str) -> tuple[str, ...]:
        """Return what a letter may be: a capital a vector or a matrix, another one a vector."""
        if self.is_named(name) or not name[:1].isupper():
            return (VECTOR,)
        return (MATRIX, VECTOR)

    def multiplies(self, node: Formula) -> bool:
        """Tell whether vectors or matrices stand in more than sums and products with numbers."""
        return any(map(self._multiplies, walk(node)))

    def _multiplies(self, part: Formula) -> bool:
        match part:
            case Product():
                return sum(map(self.has_arrays, part.factors)) > 1
            case Power():
                return self.has_arrays(part)
            case Quotient():
                return self.has_arrays(part.denominator)
            case Call() | Apply():
                return self.has_arrays(part)
            case _:
                return False


@dataclass(frozen=True, slots=True)
class _Claim:
    """A relation, the equations that stand before it, and the values of its letters."""

    left: Formula
    right: Formula
    before: list[tuple[Formula, Formula]]
    values: Mapping[str, Formula]
    faces: _Faces

    def letters(self) -> list[str]:
        """Return the vectors and matrices that it is about, its values and the equations before it."""
        nodes = [self.left, self.right, *(node for pair in self.before for node in pair)]
        return sorted(self.letters_behind(nodes))

    def letters_behind(self, nodes: list[Formula]) -> set[str]:
        """Return the vectors and matrices in formulas, and in the values of their letters."""
        left, seen, own = [*nodes], set[str](), set[str]()
        while left:
            node = left.pop()
            own |= self.faces.arrays_of(node)
            new = names(node) - seen
            seen |= new
            left += [self.values[name] for name in new if name in self.values]
        return own


def _decide(claim: _Claim, *, may_refute: bool) -> Decision | None:
    """Return the decision on a claim that fails as one of arrays; None where it is true, or not known."""
    letters = claim.letters()
    if sum(len(claim.faces.kinds_of(name)) > 1 for name in letters) > _MOST_LETTERS:
        return Decision(UNDECIDED, OF_NUMBERS)
    true, false = 0, list[ArrayValues]()
    for chosen in product(*map(claim.faces.kinds_of, letters)):
        kinds = dict(zip(letters, chosen, strict=True))
        points = [ArrayValues(kinds, claim.values, claim.faces.is_array, seed) for seed in (1, 2)]
        try:
            answers = [is_close(at.value(claim.left), at.value(claim.right)) for at in points]
        except MisfitError:
            continue
        except NoArrayError:
            return None
        if None in answers:
            continue
        if all(answers) or all(_follows(claim, letters, at) for at in points):
            true += 1
        else:
            false.append(points[0])
    if not false:
        return None if true else Decision(UNDECIDED, NEITHER)
    if true:
        return Decision(UNDECIDED, OF_VECTORS)
    return Decision(REFUTED if may_refute else UNDECIDED, OF_NUMBERS, witness=false[0].printed())


def _follows(claim: _Claim, letters: list[str], at: ArrayValues) -> bool:
    """Tell whether a relation is one before it, times a matrix from a side, or a sum of such ones."""
    target = gap(at.value(claim.left), at.value(claim.right))
    factors = [_identity, *_factors(letters, at)]
    plain: list[list[float]] = []
    for left, right in claim.before:
        try:
            own = gap(at.value(left), at.value(right))
        except (MisfitError, NoArrayError):
            continue
        for first, second, turned in product(factors, factors, (False, True)):
            try:
                there = second(first(transposed(own) if turned else own, True), False)
            except (MisfitError, NoArrayError):
                continue
            if isinstance(there, list) == isinstance(target, list) and _is_multiple(target, there):
                return True
        plain.append(entries(own))
    return _is_sum(entries(target), plain)


_Factor = Callable[[Value, bool], Value]


def _identity(value: Value, is_left: bool) -> Value:
    return value


def _factors(letters: list[str], at: ArrayValues) -> Iterator[_Factor]:
    """Yield products with each letter, its transpose and its inverse, from the left or the right."""
    for name in letters:
        own = at.array(name)
        ways: list[Value] = [own, transposed(own)]
        if isinstance(own, list) and len(own) == len(own[0]):
            ways.append(inverse(own))
        for way in ways:

            def by(value: Value, is_left: bool, way: Value = way) -> Value:
                return times(way, value) if is_left else times(value, way)

            yield by


def _is_multiple(target: Value, other: Value) -> bool:
    """Tell whether an array is a number times another one; a number is only itself, or minus itself."""
    first, second = entries(target), entries(other)
    if len(first) != len(second) or not any(second):
        return False
    place = max(range(len(second)), key=lambda i: abs(second[i]))
    factor = first[place] / second[place]
    if len(first) == 1 and factor not in (1, -1, 2, 0.5, -2, -0.5):
        return False
    scale = max(map(abs, first)) or 1
    return all(abs(a - factor * b) <= 1e-7 * scale for a, b in zip(first, second, strict=True))


def _is_sum(target: list[float], parts: list[list[float]]) -> bool:
    """Tell whether a row of numbers is a sum of multiples of others, which are fewer than its numbers."""
    rows = [row[:] for row in parts if len(row) == len(target) and any(row)]
    if not rows or len(rows) >= len(target):
        return False
    rest, scale = target[:], max(map(abs, target)) or 1
    for i in range(len(rows)):
        place = max(range(len(target)), key=lambda c, i=i: abs(rows[i][c]))
        if abs(rows[i][place]) < 1e-9:
            continue
        for other in (*rows[i + 1 :], rest):
            factor = other[place] / rows[i][place]
            other[:] = [a - factor * b for a, b in zip(other, rows[i], strict=True)]
    return all(abs(entry) <= 1e-7 * scale for entry in rest)
