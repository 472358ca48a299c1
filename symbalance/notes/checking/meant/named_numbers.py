"""Numbers put into the formula of a quantity that words name: at 18 bar, 12.78 dm³ and 1900 rpm, P = ….

The first line of such a letter has numbers alone, and no letter that could be compared. Where the words
name the quantity and give each of its sizes one number with a unit, the quantity has a value:

    the line comes to it                                        None: a definition, as before
    it comes to a usual mistake's value, or to a simple
    multiple of the right one made of the same numbers          refuted
    anything else                                               None

Nothing is refuted where a size has two numbers on the page, or where words make a part of the quantity.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from math import floor, isclose, log10, pi

from symbalance.document.formula import Formula, Name, Number, names, walk
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.tree_values import NO_VALUE, TreeValues
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.meant.catalogue import ROLES
from symbalance.notes.checking.meant.given_numbers import number_in_example
from symbalance.notes.checking.meant.letter_roles import ROD_ENDS, index_of
from symbalance.notes.checking.meant.named_quantities import NamedQuantities, may_be_part
from symbalance.notes.checking.meant.numbers_beside_names import (
    decays_beside,
    lengths_beside,
    speaks_of_cycles,
)
from symbalance.notes.checking.meant.quantity_words import Named
from symbalance.notes.checking.units.dimensions import written_unit
from symbalance.notes.checking.words.case_words import ENGINE, engine_of
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

REACH = 1500
"""Characters above a line, in its section, in which its sizes may be given."""
_SPELLED_RATES = (
    "revolutions per minute", "turns per minute", "Umdrehungen pro Minute", "Umdrehungen je Minute",
    "tours par minute", "tours by minute", "tours per minute", "giri al minuto",
    "revoluciones por minuto", "vueltas por minuto",
)  # fmt: skip
"""How prose spells revolutions a minute, before and after its terms are put in English."""
_UNITS = {
    "length": {"mm": 1e-3, "cm": 1e-2, "dm": 0.1, "m": 1},
    "pressure": {"bar": 1e5, "MPa": 1e6, "N/mm²": 1e6, "N/mm^2": 1e6, "kPa": 1e3, "Pa": 1},
    "volume": {"l": 1e-3, "L": 1e-3, "litres": 1e-3, "liters": 1e-3, "litre": 1e-3, "Liter": 1e-3,
    "dm³": 1e-3,
               "dm^3": 1e-3, "cm³": 1e-6, "cm^3": 1e-6, "cc": 1e-6, "m³": 1, "m^3": 1},
    "mass": {"kg": 1, "g": 1e-3},
    "speed": {"rpm": 1 / 60, "min⁻¹": 1 / 60, "1/min": 1 / 60, "U/min": 1 / 60, "r/min": 1 / 60,
    "rev/min": 1 / 60, "min^{-1}": 1 / 60, "min^-1": 1 / 60, "tr/min": 1 / 60, "giri/min": 1 / 60,
    "回転/分": 1 / 60, **dict.fromkeys(_SPELLED_RATES, 1 / 60)},
    "velocity": {"m/s": 1, "km/h": 1 / 3.6},
    "angular": {"rad/s": 1},
    "power": {"W": 1, "kW": 1e3, "MW": 1e6},
    "energy": {"J": 1, "kJ": 1e3, "N m": 1, "Nm": 1},
    "torque": {"N m": 1, "Nm": 1, "kN m": 1e3, "kNm": 1e3},
    "inertia": {"kg m²": 1, "kg m^2": 1, "kgm²": 1},
    "force": {"N": 1, "kN": 1e3},
    "ratio": {"%": 1e-2, "": 1},
}  # fmt: skip
_KINDS = {
    "length": "diameter radius crank pin stroke rod to_big to_small",
    "pressure": "pressure effective_pressure indicated_pressure lost_pressure",
    "volume": "volume swept",
    "mass": "mass",
    "speed": "rotation turn_rate",
    "angular": "omega",
    "velocity": "velocity",
    "power": "power effective_power indicated_power lost_power",
    "energy": "swing excess cycle_work kinetic",
    "torque": "torque",
    "inertia": "inertia",
    "force": "piston_force any_force",
    "ratio": "efficiency fluctuation",
}
RATES = ("rotation", "turn_rate")
"""Roles of a speed of rotation, which has the same number for both."""
_KIND_OF = {role: kind for kind, roles in _KINDS.items() for role in roles.split()}
_NUMBER = r"(?P<number>(?<![0-9.,])[0-9]{1,6}(?:[.,][0-9]{1,6})?)(?![0-9])"
_GAP = r"[^.;\n0-9]{0,25}?"
_THOUSANDS = re.compile(r"[0-9]{1,3}[.,][0-9]{3}")
_FACTORS = (2, 3, 4, 6, 8, pi, 2 * pi, 4 * pi)
_SMALL = 9
"""Whole numbers up to it stand for themselves: the 2 of ½ J ω²."""
_OF_ALL = re.compile(
    r"\b(?:total[ei]?|whole|entire|gesamte?[rnms]?|gesamt\w+|complessiv[oa]|complète"
    r"|of\s+(?:the\s+|this\s+)?engine|engine\s+displacement|des\s+motors)\b|総|全(?!開|負荷)|エンジンの",
    re.IGNORECASE,
)
"""Words for all cylinders of an engine."""
_OF_ONE = re.compile(
    r"(?:one|an?|single|each|eines|un|d['’]un|uno)\s+(?:einzelnen\s+|single\s+)?(?:cylind|zylind|cilind)|[1一]気筒",
    re.IGNORECASE,
)
"""Words for one of them."""
NEAR, SAME = 0.02, 0.004
"""How near a line comes to the quantity by rounding, and how near to a wrong value to be that."""


def _pattern(kind: str, words: str) -> re.Pattern[str]:
    units = "|".join(map(re.escape, sorted(filter(None, _UNITS[kind]), key=len, reverse=True)))
    unit = rf"(?:\s|\\,|\$|\{{|\\mathrm|\\text)*(?P<unit>{units})(?![A-Za-z0-9²³^/])"
    unit += r"(?!\s[cm]?m(?![A-Za-z]))" if kind in ("mass", "force", "power") else ""  # kg m², N m
    unit = rf"(?:{unit})?" if kind == "ratio" else unit
    return re.compile(words.format(number=rf"{_NUMBER}{unit}"), re.IGNORECASE if kind == "ratio" else 0)


def _word_pattern(role: str) -> re.Pattern[str]:
    kind = _KIND_OF[role]
    if role in ROD_ENDS:
        ends = ROD_ENDS[role].replace("{", "{{").replace("}", "}}")
        return _pattern(kind, rf"(?i:{{number}}\s+(?:away\s+)?{ends})")
    words = ROLES[role].words.pattern.replace("{", "{{").replace("}", "}}")
    words += r"|centres|centers" if role == "rod" else ""
    gap = _GAP.replace("{", "{{").replace("}", "}}")
    return _pattern(kind, rf"(?:(?i:{words})){gap}{{number}}")


_PATTERNS = {role: _word_pattern(role) for role in _KIND_OF if role not in (*RATES, "omega")}
_ALONE = {
    role: _pattern(_KIND_OF[role], "{number}")
    for role in ("volume", "pressure", "torque", "power", "mass", "velocity", "inertia")
}
"""Sizes whose unit says enough, where no words name them: 2.3 l."""
_LONG = _pattern("length", r"{number}\s+(?i:long\b|lang\b|de\s+long\b)")
"""A connecting rod is 200 mm long."""
_SPACES = re.compile(r"(?:\\[,;: ]|~|\\cdot(?![A-Za-z])|·)+")
"""Between the parts of a unit, N\\,m and kg·m²."""
_COMMA = re.compile(r"(?<=[0-9])\{,\}(?=[0-9])")
_THOUSANDS_APART = re.compile(
    r"(?:(?<=(?<![0-9.,}])[0-9])|(?<=(?<![0-9.,}])[0-9]{2})|(?<=(?<![0-9.,}])[0-9]{3}))(?:\\,"
    r"|[ \u2009\u202f~])"
    r"(?=[0-9]{3}(?![0-9]))"
)
"""The gap in 1 200, and in no 0,001 200."""
_TURNS_BEFORE = re.compile(rf"毎分\s?\$?{_NUMBER}\$?\s?回転")
"""4500 turns a minute, as Japanese says it."""
_CYLINDERS = re.compile(
    r"(?<![0-9.,])(?P<count>[1-9]|1[0-9])\$?[\s-]+(?:cylinders|zylindern?|cylindres|cilindri|cilindros)\b",
    re.IGNORECASE,
)
_SPEEDS = _pattern("speed", "{number}")
_ANGULAR = _pattern("angular", "{number}")


@dataclass
class NamedNumbers:
    """Judges the lines of one document that put numbers into a named quantity's formula."""

    named: NamedQuantities

    def judge(self, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
        """Return the refutation of a line of numbers that is not the quantity it is said to be."""
        left, right = chain.sides[k].node, chain.sides[k + 1].node
        is_plain = k == 0 and isinstance(left, Name) and chain.relations[0].sign in "=≈"
        numbers = [part.value for part in walk(right) if isinstance(part, Number)]
        if not is_plain or not isinstance(left, Name) or names(right) or not numbers:
            return None
        value = number_in_example(right, knowledge)
        candidates = [
            each for each in self.named.words.named(left.name, chain, knowledge) if each.may_refute
        ]
        candidates = candidates or self._by_unit(left.name, chain)
        if len(numbers) == 1:  # eight firings per turn of eight cylinders
            candidates = [each for each in candidates if _is_of_count(each)]
        if value is None or not candidates:
            return None
        return self._refuted(chain, left.name, candidates, float(value), numbers, knowledge)

    def _refuted(
        self,
        chain: Chain,
        name: str,
        candidates: list[Named],
        value: float,
        numbers: list[Fraction],
        knowledge: Knowledge,
    ) -> Decision | None:
        """Return the refutation of a value that is a slip from what the sizes give; else None."""
        result = list(self._result(chain, knowledge))
        # of numbers in units that the line leaves out, 7.0/0.85, the digits are compared
        results = [value, *result] if result else [value * 10**k for k in range(-9, 10)]
        digits = frozenset(_digits(float(n)) for n in numbers if n)
        values = self._values(chain, knowledge, digits)
        targets = [(each, t) for each in candidates for t in self._targets(each, values, numbers)]
        if any(isclose(r, t, rel_tol=NEAR) for r in results for _, (t, _) in targets):
            return None
        if len({round(log10(t), 2) for _, (t, _) in targets}) != 1:
            return None  # no formula, or two with two values: which is meant is open
        named, (target, roles) = targets[0]
        if not self._is_slip(_of_all_cylinders(named), target, roles, results, values, numbers):
            return None
        text = self.named.text(name, named)
        sizes = ", ".join(f"{role.replace('_', ' ')} {_text(values[role])}" for role in sorted(roles))
        reason = f"if {text}: by the numbers of the page ({sizes}) it is {_text(target)}"
        return Decision(REFUTED, reason, witness={plain_letter(name): _text(target)})

    def _by_unit(self, name: str, chain: Chain) -> list[Named]:
        """Return the quantities that the unit of the result says: what is in kW is a power."""
        _, unit = written_unit(self.named.document.source(chain.sides[-1].span))
        words = {"kW": "power", "W": "power", "MW": "power"}.get(unit, "")
        named = self.named.words.by_words(words, name, chain) if words and len(chain.sides) > 2 else ()
        return [each for each in named if each.may_refute]

    @staticmethod
    def _is_slip(
        named: Named,
        target: float,
        roles: frozenset[str],
        results: list[float],
        values: dict[str, float],
        numbers: list[Fraction],
    ) -> bool:
        wrong = [value for node in named.quantity.mistakes if (value := _value(node, values)) is not None]
        others = [value for node in named.quantity.others if (value := _value(node, values)) is not None]
        may_be_all = any("cylinders" in names(node) for node in named.quantity.formulas)
        if may_be_all and "cylinders" not in roles and not _OF_ONE.search(named.sentence):
            others.append(values.get("cylinders", 0) * target)  # π d² s of four cylinders
        if any(isclose(r, o, rel_tol=NEAR) for r in results for o in others):
            return False
        if any(isclose(r, w, rel_tol=SAME) for r in results for w in wrong):
            return True
        if _is_of_these(named, {role: values[role] for role in roles}, numbers):
            return not any(_is_change_of_units(r / target) for r in results if r > 0)
        digits = {_digits(float(number)) for number in numbers if number}
        of_roles = [_digits(values[role]) for role in roles if role != "cylinders"]
        speeds = [_digits(values[role] * 60) for role in RATES if role in roles]
        halves = {d for n in numbers if n for d in (_digits(2 * float(n)), _digits(float(n) / 2))}
        is_half_stroke = "stroke" in roles and _digits(values["stroke"]) in halves
        digits |= {_digits(values["stroke"])} if is_half_stroke else set()
        missing = [d for d in of_roles if d not in digits]
        is_of_speed = missing == [_digits(values.get("rotation", 0) or 1)]
        if missing and not (is_of_speed and any(d in digits for d in speeds)):
            return False
        factors = [*_FACTORS, *(values[role] for role in roles if "part" not in named.quantity.slips)]
        ratios = [r / target for r in results if r > 0]
        is_of_all = any("cylinders" in names(node) for node in named.quantity.formulas)
        counts = [n for n in numbers if is_of_all and n.denominator == 1 and "cylinders" not in roles]
        if any(isclose(ratio, count, rel_tol=SAME) for ratio in ratios for count in counts):
            return False  # 3·π/4·d²·s is of three cylinders, though no words near it say so
        return not may_be_part(named.sentence) and any(
            isclose(ratio, way, rel_tol=SAME) for ratio in ratios for f in factors for way in (f, 1 / f)
        )

    @staticmethod
    def _result(chain: Chain, knowledge: Knowledge) -> Iterator[float]:
        """Yield what stands last in a chain of numbers, in units of its own."""
        last = chain.sides[-1].node
        if len(chain.sides) > 2 and not names(last):
            value = number_in_example(last, knowledge)
            if value is not None:
                yield float(value)

    @staticmethod
    def _targets(
        named: Named, values: dict[str, float], numbers: list[Fraction]
    ) -> Iterator[tuple[float, frozenset[str]]]:
        """Yield the quantity's value by each of its formulas, with the sizes in it.

        Of formulas of the same sizes those for revolutions per minute are left out; the number of
        cylinders is put in where the line has it.
        """
        has_count = Fraction(values.get("cylinders", 0)) in numbers
        is_of_all = (
            _OF_ALL.search(f"{named.words} {named.sentence}") is not None and "cylinders" in values
        )
        has_count |= is_of_all
        faster = {**values, **{role: 60 * values.get(role, 0) for role in RATES}}
        rows = [
            (names(node), value, _value(node, faster))
            for node in named.quantity.formulas
            if (value := _value(node, values)) is not None and value > 0
        ]
        counts_cycles = any("cycles" in own for own, _, _ in rows)
        of_all = {own - {"cylinders"} for own, _, _ in rows if is_of_all and "cylinders" in own}
        rows = [row for row in rows if row[0] not in of_all]  # one cylinder's, where words ask for all
        for own, value, of_minutes in rows:
            if counts_cycles and "cycles" not in own and not speaks_of_cycles(named.sentence):
                continue  # of a decay over five periods, and not over one
            is_per_minute = bool(own & {*RATES}) and any(
                other == own and third != value and of_minutes and isclose(of_minutes, third)
                for other, third, _ in rows
            )
            if not is_per_minute and ("cylinders" in own) <= has_count:
                yield value, own

    def _values(self, chain: Chain, knowledge: Knowledge, digits: frozenset[int]) -> dict[str, float]:
        """Return the sizes of which the section gives one number, by words or by a letter.

        Of several that which has the digits of a number put in, if one alone has them.
        """
        start = chain.start
        text = self.named.document.text[max(0, start - REACH) : start]
        opening = max(text.rfind("\n#"), text.rfind("\\section"), text.rfind("<h"))
        source = _with_plain_numbers(text[opening + 1 :])
        text = self.named.words.glossary.english(source)
        beside = lengths_beside(text)
        several: dict[str, list[float]] = {
            role: [*_numbers(pattern, text, _KIND_OF[role], beside.places), *beside.of(role)]
            for role, pattern in _PATTERNS.items()
        }
        for role, number in decays_beside(source):
            several.setdefault(role, []).append(number)
        for role in RATES:
            several[role] = list(_numbers(_SPEEDS, text, "speed"))
        several["rod"] = several["rod"] or list(_numbers(_LONG, text, "length"))
        for role, pattern in _ALONE.items():
            several[role] = several[role] or list(_numbers(pattern, text, _KIND_OF[role]))
        several["omega"] = list(_numbers(_ANGULAR, text, "angular"))
        several["omega"] = several["omega"] or [2 * pi * each for each in several["rotation"]]
        counts = [count for match in ENGINE.finditer(text) if (count := engine_of(match)) is not None]
        several["cylinders"] = [float(count) for count, _ in counts if count > 1]
        several["cylinders"] += [float(match["count"]) for match in _CYLINDERS.finditer(text)]
        stated = self.named.stated.numbers.get("cylinders")
        if stated is not None and not several["cylinders"]:
            several["cylinders"] = [float(stated)]
        for letter, definition in knowledge.definitions.items():
            if not definition.numeric or definition.line > chain.lines[0]:
                continue
            number = number_in_example(definition.node, knowledge)
            if number is None:
                continue
            for role, meant in ROLES.items():
                if role in (*RATES, "cylinders") or (
                    meant.indices and index_of(letter) not in meant.indices
                ):
                    continue
                if self.named.roles.may_be(letter, role, {}):
                    several.setdefault(role, []).append(float(number))
        single: dict[str, float] = {}
        for role, numbers in several.items():
            put_in = [n for n in numbers if _digits(n) in digits]
            own = put_in or numbers
            if own and all(isclose(n, own[0], rel_tol=SAME) for n in own):
                single[role] = own[0]
        return single


def _with_plain_numbers(text: str) -> str:
    r"""Return a text with its numbers and units as they are read here.

    >>> _with_plain_numbers(r"$1\,200\,\mathrm{N\,m}$, $0{,}3$ und 毎分4500回転")
    '$1200 \\mathrm{N m}$, $0.3$ und 4500 rpm'
    """
    text = _THOUSANDS_APART.sub("", text)
    return _TURNS_BEFORE.sub(r"\g<number> rpm", _SPACES.sub(" ", _COMMA.sub(".", text)))


def _of_all_cylinders(named: Named) -> Named:
    """Return a quantity without the words that ask for all cylinders, if it has a formula of them.

    The total displacement of a four-cylinder engine is that of its four cylinders, and no other part.
    """
    if not any("cylinders" in names(node) for node in named.quantity.formulas):
        return named
    if not _OF_ALL.search(f"{named.words} {named.sentence}"):
        return named
    return replace(named, sentence=ENGINE.sub(" ", _OF_ALL.sub(" ", named.sentence)))


def _is_of_count(named: Named) -> bool:
    """Tell whether a quantity is known by the number of cylinders alone."""
    return all(names(node) == {"cylinders"} for node in named.quantity.formulas)


def _is_of_these(named: Named, sizes: dict[str, float], numbers: list[Fraction]) -> bool:
    """Tell whether a line has all sizes of a formula and nothing else but small or converting numbers."""
    if may_be_part(named.sentence) or len(sizes) < 2:
        return False
    put_in = {_digits(float(n)) for n in numbers if n}
    plain = {_digits(float(n)) for n in numbers if n and _stands_for_itself(n)}
    own: set[int] = set()
    for role, size in sizes.items():
        ways = [size, 60 * size] if role in RATES else [size]
        found = {_digits(way) for way in ways} & put_in
        is_small = role == "cylinders" and Fraction(size) in numbers
        if not found and not is_small:
            return False
        own |= found
    return put_in <= own | plain


def _stands_for_itself(number: Fraction) -> bool:
    """Tell whether a number may be a plain factor, or turns minutes into seconds."""
    return number.denominator == 1 and (number <= _SMALL or number in (30, 60, 120))


def _is_change_of_units(ratio: float) -> bool:
    """Tell whether a number is a power of ten or of sixty, or made of both."""
    return any(
        isclose(ratio * 60**k, 10 ** round(log10(ratio * 60**k)), rel_tol=SAME) for k in (-2, -1, 0, 1, 2)
    )


def _numbers(
    pattern: re.Pattern[str], text: str, kind: str, taken: frozenset[int] = frozenset()
) -> Iterator[float]:
    for match in pattern.finditer(text):
        if match.start("number") in taken:
            continue  # the bore and 90 mm of stroke
        if _THOUSANDS.fullmatch(match["number"]) and "." not in match["number"]:
            continue  # 1,800 J may be one or the other
        number = float(match["number"].replace(",", ".")) * _UNITS[kind][match["unit"] or ""]
        if number and (kind != "ratio" or number < 1):
            yield number


def _value(node: Formula, values: dict[str, float]) -> float | None:
    """Return a formula's value with the sizes put in; None where one has no number."""
    if not names(node) <= values.keys():
        return None
    point = {name: Fraction(values[name]) for name in names(node)}
    try:
        return float(TreeValues(SymbolValue(), point).value(node).real)
    except NO_VALUE:
        return None


def _digits(value: float) -> int:
    """Return the first three digits of a number: 1278 and 0.01278 have the same."""
    return round(abs(value) / 10 ** (floor(log10(abs(value))) - 2)) if value else 0


def _text(value: float) -> str:
    return f"{value:.4g}"
