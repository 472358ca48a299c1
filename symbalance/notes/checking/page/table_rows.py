"""Rows of a table: a letter's number there is its formula's value at the angle or speed of the row.

    | 120° | a = -4157 |            below a = r ω² (cos θ + λ cos 2θ)
    | 4000 rpm | F = 5.58 kN |      below F = m r ω² (1 + λ)
    | ½ | F_y = -½ U sin φ |        below F_y = -k U sin φ, k the head of the column

A row that the formula contradicts is refuted where more rows agree with it than do not: then the table
was computed from it. Where any other row agrees, it is refuted if a slip of its digits lies between. Else
its number is a premise of its row alone, whatever it was computed from. No row gives the letter a number
for what follows.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from math import isnan
from operator import attrgetter
from typing import NamedTuple

from symbalance.document.formula import Formula, Name, Number, names, walk
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.slips_in_numbers import (
    has_one_digit_wrong,
    is_mistyped,
    is_slip,
)
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.page.page_data import bare_cell, number_in_cell
from symbalance.notes.checking.page.row_values import (
    BY_ROW,
    Judged,
    Place,
    Row,
    by_formula,
    by_ratios,
    in_letters,
    number_of,
)
from symbalance.notes.checking.units.conversions import quantity_of
from symbalance.notes.checking.verdicts import PREMISE, UNDECIDED
from symbalance.notes.checking.words.tables import Cell, Table, columns_of, tables_of
from symbalance.notes.reading.equations import Chain, ReadNotes, Side
from symbalance.notes.reading.letters.macro_letters import letter_in
from symbalance.notes.reading.signs import RELATION, VULGAR
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

_DEGREES = re.compile(r"°|\^\s*\{?\\circ\}?|\\degree|deg(?:rees?)?\.?|Grad|度")
_ANGLE_HEAD = re.compile(r"°|\\circ|degree|\bdeg\b|grad\b|angle|winkel|角|angolo|ángulo", re.IGNORECASE)
_PER_MINUTE = re.compile(
    r"rpm|r\.?p\.?m\.?|(?:r|rev|revs|U|Umdr\.?|tr|giri|g|1)\s?/\s?min\.?|min\s?(?:-1|⁻¹|−1|\^\s?\{?[-−]1\}?)"
    r"|revs?\.? per min(?:ute|\.)?|回転/分|回転毎分",
)
_LETTER_IN_HEAD = re.compile(
    r"(\\[A-Za-z]+(?:_\{?\w{1,5}\}?)?|(?<![^\W\d_])[^\W\d_](?:_\{?\w{1,5}\}?|[₀-₉])?(?![^\W\d_]))"
)
_FRACTION = re.compile(r"([1-9][0-9]{0,3})\s?/\s?([1-9][0-9]{0,3})")
_UNIT_IN_HEAD = re.compile(r"(?:\bin |[\[(/])\s*([^\s\])]{1,12})")
_FEWEST = 2
"""Rows that agree, one of them not at a dead centre: a rough formula and an exact one agree there."""
_SAME = 0.01
"""By how much factors of rounded numbers may differ."""
_ROUGH = 0.03
"""By how much of the largest number an exact value may differ from that of a series cut off."""


class _InTable(NamedTuple):
    """Where a relation stands: the number of its table, and the cells of its row."""

    table: int
    row: list[Cell]
    chain: Chain


@dataclass
class TableRows:
    """Judges the numbers of letters in the tables of one page, by the row that they stand in."""

    document: ReadNotes
    _decided: dict[tuple[int, str], dict[int, Decision]] = field(default_factory=dict)
    _judged: set[int] = field(default_factory=set)
    _ratios: dict[int, float] = field(default_factory=dict)
    """What the refuted numbers are over their formulas' values, by where they begin."""

    def judge(self, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
        """Return the decision on a letter's number in a row of a table; None elsewhere."""
        place = self._placed.get(chain.start)
        if place is None or k or not _gives_letter(chain):
            return None
        head = chain.sides[0].node
        assert isinstance(head, Name)
        key = place.table, head.name
        if key not in self._decided:
            self._decided[key] = {}  # a search that is given up is not begun again at each row
            self._decided[key] = self._of_table(place.table, head.name, knowledge)
            self._judged |= self._decided[key].keys()
        decision = self._decided[key].get(chain.start)
        return decision and self._unless_carried(chain, place.row, decision)

    def _unless_carried(self, chain: Chain, row: list[Cell], decision: Decision) -> Decision:
        """Return a decision; F_2 = λ F_1 that goes on with a wrong F_1 of its row is no second slip."""
        ratio = self._ratios.get(chain.start, 0.0)
        if decision.status != REFUTED or not ratio:
            return decision
        first = row[0].span[0]
        for start, other in self._ratios.items():
            if first <= start < chain.start and other and abs(other / ratio - 1) < _SAME:
                text = (
                    f"{decision.reason.split(';')[0]}, as what stands before it there, which is refuted"
                )
                return Decision(PROVED, order="the digits printed", assumptions=(text,))
        return decision

    def has_judged(self, chain: Chain) -> bool:
        """Tell whether a relation was judged as a row: its number is of that row alone."""
        return chain.start in self._judged

    @cached_property
    def _tables(self) -> list[Table]:
        """The tables of the page; columns of plain text are none within another one."""
        text = self.document.text
        tables = [t for t in tables_of(text) if len(t) > 1 and t[0]]
        ends = sorted((t[0][0].span[0], t[-1][-1].span[1]) for t in tables if t[-1])
        return [*tables, *(t for t in columns_of(text) if not _stands_in(t, ends))]

    @cached_property
    def _placed(self) -> dict[int, _InTable]:
        """The relations that stand in cells, by where they begin, in the order of their tables."""
        chains = sorted(self.document.chains, key=attrgetter("start"))
        starts = [chain.start for chain in chains]
        placed: dict[int, _InTable] = {}
        for number, table in enumerate(self._tables):
            for row in table:
                for cell in row:
                    first, last = (bisect_left(starts, place) for place in cell.span)
                    placed |= {c.start: _InTable(number, row, c) for c in chains[first:last]}
        return placed

    @cached_property
    def _has_commas(self) -> bool:
        return any(note.startswith("decimal commas") for note in self.document.notes)

    def _of_table(self, table: int, name: str, knowledge: Knowledge) -> dict[int, Decision]:
        """Return the decisions on a letter's numbers in one table, by where they begin.

        Of several formulas above, the rough one and the exact one, it is that which most rows agree with.
        """
        rows = list(self._rows_of(table, name))
        judged: list[list[Judged]] = []
        if any(names(row.chain.sides[1].node) for row in rows):
            formulas = self._formulas_of(name, rows, knowledge)
            judged = [list(in_letters(rows, formula, name, knowledge)) for formula in formulas]
            best = max(judged, key=lambda each: sum(one.decision.is_proved for one in each), default=[])
            return dict(_outcomes_in_letters(best))
        rows = [row for row in rows if not isnan(row.number)]
        for formula in self._formulas_of(name, rows, knowledge):
            of_numbers = list(by_formula(rows, formula, name, knowledge))
            # where all letters have numbers, a common factor of all rows is no open one
            judged += [of_numbers] if of_numbers else by_ratios(rows, formula, name, knowledge)
        best = max(judged, key=lambda each: sum(one.decision.is_proved for one in each), default=[])
        outcomes = dict(_outcomes(best))
        for each in best:
            if outcomes[each.row.chain.start].status == REFUTED:
                self._ratios[each.row.chain.start] = each.ratio
        return outcomes

    def _formulas_of(self, name: str, rows: list[Row], knowledge: Knowledge) -> Iterator[Formula]:
        """Yield the formulas that a letter has above its rows, each once."""
        definition = knowledge.definitions.get(name)
        known = [] if definition is None else [definition.formula, definition.node]
        known.append(knowledge.meaning.values.get(name))
        start = rows[0].chain.start if rows else 0
        above = (c for c in self.document.chains if c.start < start and c.sides[0].node == Name(name))
        known += [side.node for chain in above for side in chain.sides[1:]]
        if rows and rows[0].place.kind == "angle":  # amplitudes as printed, F₁ = 8.49 kN
            known += [self._with_printed(formula, start) for formula in known if formula is not None]
        yield from dict.fromkeys(each for each in known if each is not None and names(each))

    def _with_printed(self, formula: Formula, start: int) -> Formula:
        """Return a formula with the numbers that the page prints above for the letters in it."""
        for letter in names(formula):
            own = (c for c in self.document.chains if c.start < start and c.sides[0].node == Name(letter))
            numbers = [c.sides[-1].node for c in own if not names(c.sides[-1].node)]
            if numbers:
                formula = substitute(formula, letter, numbers[-1])
        return formula

    def _rows_of(self, table: int, name: str) -> Iterator[Row]:
        """Yield the rows in which a letter has a number or a formula, with what they are at."""
        for _, row, chain in self._by_table.get(table, ()):
            if chain.sides[0].node != Name(name) or len(chain.sides) != len("ab"):
                continue
            place = self._place_of(row, self._tables[table][0])
            if place is not None:
                number = chain.sides[1]
                yield Row(chain, number_of(number.node), self._half(number), place)

    @cached_property
    def _by_table(self) -> dict[int, list[_InTable]]:
        grouped: dict[int, list[_InTable]] = {}
        for each in self._placed.values():
            grouped.setdefault(each.table, []).append(each)
        return grouped

    def _half(self, number: Side) -> float:
        """Return half a unit of the last place of a number as printed, in the unit it is read in."""
        quantity = quantity_of(number, self.document)
        if quantity is not None:
            return float(quantity.half * quantity.scale)
        places = [p.last_place for p in walk(number.node) if isinstance(p, Number) and p.last_place]
        return float(max(places, default=1)) / 2

    def _place_of(self, row: list[Cell], heads: list[Cell]) -> Place | None:
        """Return the one angle, speed or number that a row names, by its cell's unit or column's head."""
        places = []
        for k, cell in enumerate(row):
            head = bare_cell(heads[k].text) if row is not heads and k < len(heads) else ""
            if not RELATION.search(cell.text) and (place := self._named_by(cell.text, head)) is not None:
                places.append(place)
        turning = [place for place in places if place.kind != "letter"]  # the others may be results
        others = tuple((p.letter, p.number) for p in places if turning and p.kind == "letter")
        places = turning or places
        return places[0]._replace(others=others) if len(places) == 1 else None

    def _named_by(self, text: str, head: str) -> Place | None:
        """Return what a cell and the head of its column say: an angle, a speed, or a letter's number."""
        match = _LETTER_IN_HEAD.search(head)
        letter = letter_in(self.document.text, match[1]) if match else None
        bare = bare_cell(text)
        if letter and (fraction := _fraction(bare)) is not None:
            return Place("letter", letter, Number(fraction), f"at {bare}{BY_ROW}")
        quantity = number_in_cell(text, self._has_commas)
        if quantity is None:
            return None
        number, unit = quantity
        value = f"{float(number.value):g}"
        if _DEGREES.fullmatch(unit) or (not unit and _ANGLE_HEAD.search(head)):
            return Place("angle", letter or "", number, f"at {value}°{BY_ROW}")
        if _PER_MINUTE.fullmatch(unit) or (not unit and _PER_MINUTE.search(head)):
            return Place("speed", letter or "", number, f"at {value} rpm{BY_ROW}")
        scale = scale_of(unit or _unit_in(head)) if unit or _unit_in(head) else (Fraction(1), False)
        is_size = letter and scale is not None and not scale[1]
        return _at_size(letter or "", number, scale[0], unit) if is_size and scale is not None else None


def _gives_letter(chain: Chain) -> bool:
    """Tell whether a relation gives a letter one number or formula without itself."""
    head, last = chain.sides[0].node, chain.sides[-1].node
    is_pair = len(chain.sides) == len("ab") and chain.relations[0].sign in ("=", "≈")
    return is_pair and isinstance(head, Name) and head.name not in names(last)


def _fraction(text: str) -> Fraction | None:
    """Return the value of a cell that is a fraction: 1/150, ½."""
    match = _FRACTION.fullmatch(text)
    pair = VULGAR.get(text) or ((int(match[1]), int(match[2])) if match is not None else None)
    return Fraction(*pair) if pair is not None else None


def _at_size(letter: str, number: Number, scale: Fraction, unit: str) -> Place:
    scaled = Number(number.value * scale, number.last_place and number.last_place * scale)
    text = f"at {float(number.value):g} {unit}".rstrip()
    return Place("letter", letter, scaled, text + BY_ROW)


def _unit_in(head: str) -> str:
    match = _UNIT_IN_HEAD.search(head)
    return match[1] if match is not None else ""


def _stands_in(table: Table, ends: list[tuple[int, int]]) -> bool:
    """Tell whether a table begins within others, given by where they begin and end."""
    start = table[0][0].span[0]
    place = bisect_right(ends, (start, start)) - 1
    return place >= 0 and start < ends[place][1]


def _outcomes(judged: list[Judged]) -> Iterator[tuple[int, Decision]]:
    """Yield the decisions on the rows of one table, by where their numbers begin."""
    agreeing = [each.row for each in judged if each.decision.is_proved]
    contrary = [each.row for each in judged if each.decision.status == REFUTED]
    is_enough = len(agreeing) >= max(_FEWEST, len(contrary))
    is_of_formula = is_enough and not all(row.place.is_at_dead_centre for row in agreeing)
    largest = max((abs(each.row.number) for each in judged), default=0.0)
    factor = _common_factor(judged)
    for row, there, gap, ratio in judged:
        text = row.place.text
        is_of_rows = any(not each.place.is_at_dead_centre for each in agreeing)
        may_be_exact = row.place.kind != "speed" and gap < _ROUGH * largest
        if there.is_proved:
            decision = replace(there, assumptions=(*there.assumptions, text))
        elif there.status == REFUTED and is_of_formula and not may_be_exact:
            decision = replace(there, reason=f"{text}; other rows have the formula's values")
        elif there.status == REFUTED and is_of_rows and ratio and _is_mistyped(row, ratio):
            decision = replace(there, reason=f"{text}; another row has the formula's value")
        elif there.status == REFUTED and factor:
            reason = f"{text}: all rows are {factor:.4g} times what the formula above gives"
            decision = Decision(UNDECIDED, reason)
        elif there.status == REFUTED and len(agreeing) >= _FEWEST and not may_be_exact:
            reason = f"{text}, the formula above has another value: of something else, or wrong"
            decision = Decision(UNDECIDED, reason)
        else:
            decision = Decision(PREMISE, f"{text}: a row of its own")
        yield row.chain.start, decision


def _is_mistyped(row: Row, ratio: float) -> bool:
    """Tell whether a slip of digits or a factor makes a row's number of its formula's."""
    typed, node = abs(row.number), row.chain.sides[1].node
    exact = typed / abs(ratio)
    if row.place.kind == "speed":
        return is_slip(typed, exact, node) or has_one_digit_wrong(typed, exact, node)
    return is_mistyped(typed, exact, node)


def _common_factor(judged: list[Judged]) -> float:
    """Return what times the formula's values all rows are, where none of them agrees; 0 for nothing."""
    ratios = [each.ratio for each in judged if each.ratio]
    if len(ratios) < _FEWEST or any(each.decision.is_proved and each.ratio for each in judged):
        return 0.0
    return ratios[0] if all(abs(ratio / ratios[0] - 1) < _SAME for ratio in ratios) else 0.0


def _outcomes_in_letters(judged: list[Judged]) -> Iterator[tuple[int, Decision]]:
    """Yield the decisions on the formulas that a letter has in the rows of one table."""
    count = sum(each.decision.is_proved for each in judged)
    for row, there, *_ in judged:
        text = row.place.text
        if there.is_proved:
            yield row.chain.start, replace(there, assumptions=(*there.assumptions, text))
        elif there.status == REFUTED and count:
            yield row.chain.start, replace(there, reason=f"{text}; another row is the formula's value")
