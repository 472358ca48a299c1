"""What is known of a page where its next relation is judged: what it declares and has said so far."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from typing import Any

from symbalance.document.formula import Integral, Name, Sum, Summation, names, parts_of_kind, walk
from symbalance.document.letters import is_greek
from symbalance.errors import SymbalanceError
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.checking.deciding.conjugate_letters import with_conjugates
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.inequalities import sample_ranges
from symbalance.notes.checking.deciding.knowledge import Assumption, Definition, Knowledge
from symbalance.notes.checking.deciding.numbers_put_in import (
    counted_things,
    printed_results,
    stated_values,
)
from symbalance.notes.checking.deciding.whole_numbers import may_count, orders_in
from symbalance.notes.checking.declared.engines import Sources
from symbalance.notes.checking.declared.geometry import Geometry
from symbalance.notes.checking.declared.sidecar import Declarations
from symbalance.notes.checking.declared.symbol_roles import (
    CRANK_ANGLE,
    MOVING,
    SMALL_WORD,
    letters_by_role,
    role_of,
    settled_letters,
    small_letters,
)
from symbalance.notes.checking.declared.symbols import meaning_of
from symbalance.notes.checking.meant.engine_speeds import speeds_of
from symbalance.notes.checking.meant.engines.bank_resultants import BankResultants
from symbalance.notes.checking.meant.engines.cylinder_forces import CylinderForces
from symbalance.notes.checking.meant.engines.dead_centre_sizes import DeadCentreSizes
from symbalance.notes.checking.meant.engines.engine_resultants import EngineResultants
from symbalance.notes.checking.meant.engines.formulas_beside import FormulasBeside
from symbalance.notes.checking.meant.given_numbers import GivenNumbers
from symbalance.notes.checking.meant.harmonic_coefficients import HarmonicCoefficients
from symbalance.notes.checking.meant.meant_quantities import MeantQuantities
from symbalance.notes.checking.meant.meant_words import MeantWords
from symbalance.notes.checking.meant.motion_in_time import Motions, with_motions
from symbalance.notes.checking.meant.named_numbers import NamedNumbers
from symbalance.notes.checking.meant.named_orders import NamedOrders
from symbalance.notes.checking.meant.named_quantities import NamedQuantities
from symbalance.notes.checking.meant.pistons.crank_motions import CrankMotions
from symbalance.notes.checking.meant.pistons.formula_patterns import FormulaPatterns
from symbalance.notes.checking.meant.pistons.motion_parity import MotionParity
from symbalance.notes.checking.meant.unbalances_in_units import UnbalancesInUnits
from symbalance.notes.checking.meant.varying_speeds import VaryingSpeed, varying_speed, with_varying_speed
from symbalance.notes.checking.motions.equations_of_motion import EquationOfMotion
from symbalance.notes.checking.motions.fourier_series import FourierSeries
from symbalance.notes.checking.motions.trial_solutions import Trial
from symbalance.notes.checking.page.cases_side_by_side import CasesSideBySide
from symbalance.notes.checking.page.cranks_of_engines import CranksOfEngines
from symbalance.notes.checking.premises import constraints
from symbalance.notes.checking.premises.carried_values import CarriedValues
from symbalance.notes.checking.premises.conditions_behind import equalities_behind, with_conditions
from symbalance.notes.checking.premises.definitions import Definitions
from symbalance.notes.checking.premises.ranges_beside import RangesBeside
from symbalance.notes.checking.premises.ranges_in_words import with_ranges_in_words
from symbalance.notes.checking.premises.rounded_values import values_put_in
from symbalance.notes.checking.premises.system import Premise
from symbalance.notes.checking.steps.cranks_said_anew import with_cranks_of_sentence
from symbalance.notes.checking.steps.printed_results import PrintedResults
from symbalance.notes.checking.steps.values_of_moments import without_moments
from symbalance.notes.checking.units.stated_units import StatedUnits
from symbalance.notes.checking.verdicts import CONTRADICTION, PROVED_WORDS, REFUTED, STATED
from symbalance.notes.checking.words.crank_angles_listed import CrankAngles, crank_angles, listed_at
from symbalance.notes.checking.words.integer_words import integers_said
from symbalance.notes.checking.words.labelled_data import LabelledData
from symbalance.notes.checking.words.labels_of_cases import LabelsOfCases
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading import ReadingError, read_equation
from symbalance.notes.reading.equations import Chain, ReadNotes, Side
from symbalance.text import lazy_patterns as re

ANGLES = ("crank angle", "rod angle", "time", "integer")
_COUNT = re.compile(r"\bnumber of|\bcount\b|integer|anzahl|zahl\b|気筒数|シリンダ数", re.IGNORECASE)
"""Words of a meaning that say of a letter at the end of a sum that it counts."""
NEAR_RANGE = 2
"""Lines above a relation on which a range is said of it."""
UNIVERSAL = (
    "crank angle",
    "rod angle",
    "time",
    "rod ratio l/r",
    "rod ratio l/s",
    "crank ratio r/l",
    "integer",
)
"""Roles of letters of all of whose values a relation is claimed."""


@dataclass(frozen=True, slots=True)
class CountedMotion:
    """A piston's way, velocity or acceleration, and in which direction the page counts it."""

    sign: int
    """1 where the way is counted from the crank outwards, -1 where it is from top dead centre inwards."""
    start: int
    line: int


@dataclass
class JudgingState:
    """A page while its relations are judged in turn: what it declares, and what is defined so far."""

    document: ReadNotes
    declarations: Declarations
    sources: Sources
    corrects: bool
    motions: Motions = field(default_factory=Motions)
    data: tuple[Chain, ...] = ()
    """What tables, lists and code give letters."""
    refuted: set[int] = field(default_factory=set)
    """Places where the right sides of refuted relations begin."""
    rough_lines: list[int] = field(default_factory=list)
    """Lines of relations with = that turned out to be meant roughly."""
    stated: set[int] = field(default_factory=set)
    """Places where the right sides of relations begin that the page only states: nothing proves them."""
    proved: set[int] = field(default_factory=set)
    """Places where the right sides of proved relations begin."""
    openings: list[Chain] | None = None
    """The relations that open a case, None before any was asked for."""
    starts_judged: set[int] = field(default_factory=set)
    """Where the relations begin that have been judged, or are."""
    cases_to_leave: dict[int, tuple[Chain, int]] = field(default_factory=dict)
    """Cases that end, by their place, with where: what stands before that on the line is judged first."""
    ended_cases: list[Chain] = field(default_factory=list)
    """Cases that words have left, for x = 2 say: none of their numbers is in force behind."""
    told_by_words: set[tuple[int, int]] = field(default_factory=set)
    """Relations, by place and number, whose words say which of several numbers they are about."""
    other_meanings: dict[str, list[Definition]] = field(default_factory=dict, init=False)
    """What letters were above whose noun and unit make them another quantity since."""
    _meanings: dict[tuple[Any, ...], tuple[SymbolValue, Geometry]] = field(
        default_factory=dict, init=False
    )
    """What declared letters stand for, by the declarations that hold at a line."""
    solved_angles: dict[int, Decision] = field(default_factory=dict, init=False)
    """Where an angle stands that solves the equation before it, though it had another value above."""

    counted_motions: list[CountedMotion] = field(default_factory=list, init=False)
    """The piston's motions judged so far, each with the direction in which it counts."""

    def __post_init__(self) -> None:
        self.sections = Sections(self.document)
        self.definitions = Definitions(self.declarations, self.sections, LabelledData(self.sections))
        self.cases = CasesSideBySide(self.document, self.sections, self.data)
        self.stated_units = StatedUnits(self.document)
        self.meant = MeantQuantities(
            MeantWords(self.document, self.declarations, self.sections), self.sources
        )
        self.named = NamedQuantities(self.document, self.sections)
        self.named_numbers = NamedNumbers(self.named)
        self.named_orders = NamedOrders(self.meant)
        self.engine_resultants = EngineResultants(self.meant.words, self.sections)
        self.crank_motions = CrankMotions(self.document, self.sections, self.meant.words)
        self.patterns = FormulaPatterns(self.document, self.sections, self.meant.words)
        self.parity = MotionParity(self.patterns)
        self.harmonics = HarmonicCoefficients(self.sections)
        self.small_letters = small_letters(self.document.text)
        self.counts = _counts(self.document)
        self.letters = {n for chain in self.document.chains for n in chain.letters}
        self.printed, self.data_values = printed_results(self.document), stated_values(self.document)
        self.counted = counted_things(self.document.text)
        self.wrong_numbers = CarriedValues()
        self.given_numbers = GivenNumbers()
        self.results = PrintedResults()
        self.much_larger: list[Chain] = []
        """Relations ≫ and ≪ between letters that the page has stated."""
        self.speeds = speeds_of(self.document.text)
        self.crank_angles = crank_angles(self.document.text)
        self.cranks_of_engines = CranksOfEngines(self.document.text, self.sections, self.sources)
        sides = [side.node for chain in self.document.chains for side in chain.sides]
        self.has_sums = any(isinstance(p, Summation | Integral) for node in sides for p in walk(node))
        self.orders = orders_in(sides) if self.has_sums else frozenset()
        self.integers = integers_said(self.document.text, self.orders)
        """Orders that the page's words say to be whole numbers."""
        self.conditions = equalities_behind(self.document)
        """Where equations begin that are conditions of the relation before them alone: (m = n)."""
        self.equations_of_motion: list[EquationOfMotion] = []
        self.trials: list[Trial] = []
        """Motions of letters that are put into the equations of motion."""
        self.fourier_series: list[FourierSeries] = []
        self.not_judged: dict[str, int] = {}
        """Letters that a relation may define which was not judged, with its line."""
        self.solutions: dict[int, tuple[Premise, Decision]] = {}
        """Where an equation's solution stands: the equation, and whether the solution satisfies it."""
        self.extremes: dict[tuple[str, str], tuple[Side, int]] = {}
        """Largest and smallest values of quantities without a formula, each with its line."""
        self.balances: set[int] = set()
        """Places of the solutions of balances, which are wrong where they do not satisfy them."""
        self.wrong_angles: dict[int, Decision] = {}
        """Where an angle stands that is said to solve the equation before it, and does not."""
        self.turned = self.sections.running.letters
        self.general: frozenset[str] = frozenset()
        """Letters of all of whose values the relation in hand is claimed, whatever case stands before."""

    def note_verdict(self, place: int, verdict: str) -> None:
        """Note where a relation's right side begins, if it is refuted, proved or only stated."""
        if verdict in (REFUTED, CONTRADICTION):
            self.refuted.add(place)
        elif verdict in STATED:
            self.stated.add(place)
        elif verdict in PROVED_WORDS:
            self.proved.add(place)

    @cached_property
    def bank_resultants(self) -> BankResultants:
        """The forces of two cylinders on one pin."""
        return BankResultants(self.engine_resultants)

    @cached_property
    def cylinder_forces(self) -> CylinderForces:
        """The forces of single cylinders, counted in one direction."""
        return CylinderForces(self.engine_resultants.claims)

    @cached_property
    def formulas_beside(self) -> FormulasBeside:
        """Formulas that belong together: two orders, two components of a force."""
        return FormulasBeside(self.meant.words, self.sections)

    @cached_property
    def dead_centre_sizes(self) -> DeadCentreSizes:
        """The sizes of a piston's acceleration at the dead centres."""
        return DeadCentreSizes(self.engine_resultants)

    @cached_property
    def ranges_beside(self) -> RangesBeside:
        """The values that letters have on ranges of others."""
        return RangesBeside(self.sections)

    @property
    def labelled_data(self) -> LabelledData:
        """The numbers that labels give to several things: old and new, A and B."""
        return self.definitions.labelled_data

    @cached_property
    def labels_of_cases(self) -> LabelsOfCases:
        """The labels by which the page tells its engines or cases apart."""
        return LabelsOfCases(self.document.text, self.sections)

    @cached_property
    def varying_speed(self) -> VaryingSpeed | None:
        """The first line that lets the declared crank turn otherwise than steadily."""
        return varying_speed(self.document, self.declarations)

    def enter_case(self, line: int) -> None:
        """End the numbers of the case before where a line is the first of another one."""
        self.cases.enter(line, self.definitions, self.given_numbers)

    @cached_property
    def lines_with_rough_sign(self) -> list[int]:
        """The lines on which a formula stands behind ≈, in order."""
        return sorted(
            chain.lines[0]
            for chain in self.document.chains
            if any(
                r.sign == "≈" and names(s.node)
                for r, s in zip(chain.relations, chain.sides[1:], strict=True)
            )
        )

    def knowledge(self, line: int, convention: str = "") -> Knowledge:
        """Return what is known at a line."""
        symbols = {**self.counts, **self.declarations.symbols_at(line)}
        symbols = self._by_own_crank_angle(symbols, line)
        meaning, crank = self._meaning_of(symbols, convention)
        definitions = self._without_crank_angle(self.definitions.at(line), crank, line)
        letters = letters_by_role(symbols)
        meaning = with_motions(meaning, self.motions, line, definitions, symbols)
        meaning = with_varying_speed(meaning, self.varying_speed, line)
        running = self.motions.turning(line)
        universal = frozenset(n for m in UNIVERSAL for n in letters.get(m, ())) | running
        moving = frozenset(n for m in MOVING for n in letters.get(m, ()))
        angles = frozenset(n for m in ANGLES for n in letters.get(m, ())) | running
        letters_declared = frozenset(symbols)
        ranges = self.definitions.ranges_at(line)
        undeclared = frozenset(self.document.free_letters) - letters_declared - definitions.keys()
        counts = {n for n in self.counts if _COUNT.search(symbols[n])}
        counts |= {n for n in self.integers if may_count(n, symbols)}
        meaning = replace(
            meaning,
            ranges={**meaning.ranges, **sample_ranges(ranges)},
            integer=meaning.integer | counts,
            undeclared=undeclared,
        )
        knowledge = Knowledge(
            meaning,
            crank,
            definitions,
            self.assumptions(line, letters_declared),
            settled_letters(symbols) | self.document.own_letters,
            moving,
            angles,
            symbols,
            universal,
            corrects=self.corrects,
            ranges=tuple(ranges),
            printed=self.printed,
            stated=self.data_values,
            counted=self.counted,
            has_sums=self.has_sums,
            orders=self.orders,
            small=frozenset(n for n, text in symbols.items() if _is_small(text)) | self.small_letters,
        )
        return self.definitions.on_stated_branches(knowledge)

    def _by_own_crank_angle(self, symbols: dict[str, str], line: int) -> dict[str, str]:
        """Return declarations with the crank angle first that stands alone on a line, of two declared."""
        angles = [name for name, text in symbols.items() if role_of(text) == CRANK_ANGLE]
        here = [name for name in angles if name in self._letters_by_line.get(line, ())]
        if len(here) != 1 or here == angles[:1]:
            return symbols
        return {here[0]: symbols[here[0]], **symbols}

    def _without_crank_angle(
        self, definitions: dict[str, Definition], crank: Geometry, line: int
    ) -> dict[str, Definition]:
        """Return definitions without the crank angle's own by an angle that a line has not: θ - γ."""
        own = definitions.get(crank.theta.name) if isinstance(crank.theta, Name) else None
        here = self._letters_by_line.get(line, set())
        if own is None or not isinstance(crank.theta, Name) or not isinstance(own.node, Sum):
            return definitions
        is_by_another = names(own.node) and here.isdisjoint(names(own.node))
        if crank.theta.name not in here or not is_by_another:
            return definitions
        return {n: d for n, d in definitions.items() if n != crank.theta.name}

    @cached_property
    def _letters_by_line(self) -> dict[int, set[str]]:
        """The letters of the relations on each line."""
        letters: dict[int, set[str]] = {}
        for chain in self.document.chains:
            for line in chain.lines:
                letters.setdefault(line, set()).update(chain.letters)
        return letters

    def _meaning_of(self, symbols: Mapping[str, str], convention: str) -> tuple[SymbolValue, Geometry]:
        """Return what declared letters stand for, the same at every line of one scope."""
        key = (convention, *symbols.items())
        if key not in self._meanings:
            self._meanings[key] = meaning_of(symbols, convention, self.sources.engines)
        return self._meanings[key]

    def knowledge_of(self, chain: Chain, knowledge: Knowledge) -> Knowledge:
        """Return what is known with what stands around one relation on its line."""
        same_section = self.sections.same_section
        angles = listed_at(
            self.crank_angles, chain.start, self.document.text, same_section, of_pins=_is_of_pins(chain)
        )
        above = self.sections.chain_before(chain.start)
        knowledge, angles = with_cranks_of_sentence(chain, above, angles, knowledge)
        if angles is None and chain.has_sum:
            angles = self.cranks_of(chain)
        printed = knowledge.printed | values_put_in(chain, knowledge)
        first = chain.lines[0] - NEAR_RANGE
        own = replace(knowledge, crank_angles=angles, own_ranges_from=first, printed=printed)
        own = without_moments(chain, self.sections, with_conjugates(chain, own))
        return with_ranges_in_words(chain, self.document, with_conditions(chain, self.document, own))

    @cached_property
    def unbalances(self) -> UnbalancesInUnits:
        """What the page says of unbalances with their units."""
        return UnbalancesInUnits(self.named)

    def cranks_of(self, chain: Chain) -> CrankAngles | None:
        """Return the usual cranks of the engine that words say a relation is of."""
        return self.cranks_of_engines.at(chain.start, chain.end, chain.lines[0])

    def assumptions(self, line: int, letters: frozenset[str]) -> tuple[Assumption, ...]:
        """Return the assumptions at a line, each solved for a letter."""
        return tuple(
            read_assumption(text, letters, self.declarations.place)
            for text in self.declarations.assumptions_at(line)
        )


def _is_of_pins(chain: Chain) -> bool:
    """Tell whether a relation sums angles of pins alone, Σ cos 2φ_k, and no forces of cylinders."""
    if not chain.has_sum:
        return False
    sums = [part for side in chain.sides for part in parts_of_kind(side.node, Summation)]
    summed = [(name, part.index) for part in sums for name in names(part.body)]
    return all(
        is_greek(name.partition("_")[0]) and index is not None and name.endswith(f"_{index.name}")
        for name, index in summed
    )


@lru_cache(maxsize=1000)
def _is_small(meaning: str) -> bool:
    """Tell whether a letter's declared meaning says that it is small."""
    return SMALL_WORD.search(meaning) is not None


def _counts(document: ReadNotes) -> dict[str, str]:
    """Return the letters that sums run to: integers, where nobody declared them anything else."""
    sums = (
        part
        for chain in document.chains
        for side in chain.sides
        for part in walk(side.node)
        if isinstance(part, Summation) and part.upper is not None
    )
    ends = {name for total in sums if total.upper is not None for name in names(total.upper)}
    return dict.fromkeys(sorted(ends), "integer")


def read_assumption(text: str, letters: frozenset[str], place: str) -> Assumption:
    """Return an assumption of the sidecar, solved for a letter."""
    try:
        chain = read_equation(text, letters)
    except ReadingError as problem:
        raise SymbalanceError(f"given = {text}", problem.what, problem.remedy, place) from None
    if len(chain.sides) == 2 and chain.relations[0].sign == "=":
        solution = constraints.solve(chain.sides[0].node, chain.sides[1].node)
        if solution is not None:
            return Assumption(text, *solution)
    raise SymbalanceError(
        f"given = {text}", "must be an equality that fixes a letter", 'write "α = π/6"', place
    )
