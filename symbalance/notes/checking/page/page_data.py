"""The data of a page that stand in no relation: tables of letters and values, lists, a notebook's code.

    | crank radius | $r$ | 45 mm |        a letter and its value, with a unit here or in the next cell
    | $r$ | $l$ |  over  | 45 mm | 150 mm |
    - crank radius $r$: 45 mm
    the mass $m$ is 0.5 kg                in a sentence
    r, l = 0.045, 0.150                   in program code

Each becomes the chain r = 45 mm, at its place. Nothing is taken that may be read in two ways: a letter
with two values in one table, a size without a unit, a name that stands in no formula of the page.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction

from symbalance.document.formula import Constant, Formula, Name, Number, Product, Quotient, Span, names
from symbalance.notes.checking.declared.symbol_roles import role_of
from symbalance.notes.checking.page.indexed_data import (
    instances_of_rules,
    rows_of_values,
    tables_of_values,
)
from symbalance.notes.checking.page.values_in_prose import GivenInProse, values_in_prose
from symbalance.notes.checking.page.words_of_values import as_unit
from symbalance.notes.checking.words.tables import Cell, Table, tables_of
from symbalance.notes.reading.equations import Chain, ReadNotes, Relation, Side
from symbalance.notes.reading.letters.macro_letters import letter_in
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

Symbols = Callable[[int], Mapping[str, str]]
LONGEST_METRES = 3
"""A length in program code without a unit is in metres up to it; 45 is in millimetres, or anything."""
LARGEST_COUNT = 64
"""A whole number up to it may stand without a unit: a count."""
_LENGTHS = ("crank radius", "stroke", "rod length", "cylinder pitch")
_BARE = ("integer", "rod ratio l/r", "rod ratio l/s", "crank ratio r/l", "engine speed rpm")
"""Meanings whose numbers need no unit."""

_BARE_NOUN = re.compile(
    r"(?:ratio|factor|coefficient|efficiency|(?i:verhältnis|faktor|beiwert|wirkungsgrad)|rapport|facteur|rapporto"
    r"|fattore|coefficiente|relación|cociente)(?![^\W\d_])|比|係数|率"
)
"""Words for what is a number without a unit."""
_NEAR_WORDS = 40
"""Characters before a letter and its number in which words say what it is."""

_MARKUP = re.compile(
    r"</?(?:i|b|em|strong|var|math|span|p|code|tt)\b[^>]*>|'{2,3}|\$|\\[()]|`|\\(?:,|;|:|!| )"
    r"|\*\*|~|&nbsp;",
    re.IGNORECASE,
)
_STEM = re.compile(r"(?:stem|latexmath|asciimath):[a-z,]{0,20}\[([^][\n]{1,60})\]|:math:`([^`\n]{1,60})`")
"""A formula as AsciiDoc and reStructuredText mark it."""
_SUBSCRIPT = re.compile(r"<sub>([^<]{1,12})</sub>", re.IGNORECASE)
_MARKED_LETTER = re.compile(r"(?P<words>[^$]*?)\$(?P<letter>[^$=]{1,40})\$(?P<unit>[^$]{0,20})")
_NAMED_LETTER = re.compile(
    r"(?P<words>(?:[^\W\d_]{2,}[-\s.]+)*[^\W\d_]{3,})\s+(?P<letter>[A-Za-zα-ωΑ-Ω](?:_\{?\w{1,8}\}?|[₀-₉])?)"
)
"""A letter behind the words for it, without marks of a formula: crank radius r."""
_OTHERS = re.compile(
    r"(?:engine|motor|moteur|motore|cylinder|zylinder|cylindre|cilindro|case|fall|cas|caso|variant\w*|type|typ|model\w*"
    r"|point|punkt|punto|part|teil|plane|ebene|bearing|lager|journal|web|wange|side|seite|row|column|figure|item|step"
    r"|section|bank|pin|gear|shaft|and|und|et|of|in)$",
    re.IGNORECASE,
)
"""Words behind which a letter tells things apart, and is none of a formula: engine A."""
_UNIT_BESIDE = re.compile(
    r"(?P<letter>.*?)\s*(?:\[(?P<square>[^\]]+)\]|\((?P<round>[^)]+)\)|/\s*(?P<per>\S+))"
)
_VALUE = re.compile(
    r"[=≈]?\s*(?P<sign>[-−]?)(?P<digits>[0-9]+(?:[.,][0-9]+|[\u00a0\u202f ][0-9]{3}(?![0-9]))*)"
    r"(?:/(?P<divisor>[1-9][0-9]{0,2})(?![0-9/]|[.,][0-9]))?"
    r"(?:\s*(?:×|·|\*|\\cdot|\\times)\s*10(?:\^?\{?(?P<power>[-−]?[0-9]{1,2})\}?|(?P<raised>⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]{1,2})))?"
    r"\s*(?P<unit>(?:1\s*/|[^\d\s]).*)?"
)
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻−", "0123456789--")
_GROUPED = re.compile(r"[1-9][0-9]{0,2}(?:[,.  ][0-9]{3})+")
_ITEM = re.compile(
    r"^[^\S\n]*+(?:[-*+•]|[0-9]{1,2}[.)]|\\item)\s+(?P<letter>[^\n:=]{1,60}?)\s*[:：]\s+(?P<value>[^\n=]{1,40}?)[.;,]?$",
    re.MULTILINE,
)
_DATUM = re.compile(
    r"^[^\S\n]+(?:(?P<words>[^\n:=$|]{2,40}?)[^\S\n]+)(?P<letter>[^\W\d_]\w{0,4})[^\S\n]*:[^\S\n]+"
    r"(?P<value>[0-9][^\n=(:]{0,24}?)(?:[^\S\n]{2,}[^\n]*|[^\S\n]*\([^\n]*|[.;,]?)$",
    re.MULTILINE,
)
"""A line of a list without bullets, as mails have it: "   crank radius r: 36 mm   (stroke 72 mm)"."""
FEWEST_DATA = 3
"""Such lines one below the other that are a list."""
_FENCED = re.compile(
    r"^(`{3,}+|~{3,}+)(?P<language>\w*+)[^\n]*+\n(?P<code>.*?)^\1", re.MULTILINE | re.DOTALL
)
_PROGRAM = ("code", "python", "py", "julia", "matlab", "octave", "r", "ipython")
_ASSIGNED = re.compile(
    r"^(?P<names>[A-Za-z_]\w*(?:\s*,\s*[A-Za-z_]\w*)*)\s*=\s*"
    r"(?P<values>[-+0-9.eE_]+(?:\s*,\s*[-+0-9.eE_]+)*)\s*;?\s*(?:[#%](?P<comment>.*))?$",
    re.MULTILINE,
)
_CODE_NAMES = {"lam": "lambda", "lmbda": "lambda", "lambda_": "lambda", "lamda": "lambda", "om": "omega"}


def data_of(notes: ReadNotes, symbols_at: Symbols) -> tuple[Chain, ...]:
    """Return the data of a page as chains of a letter and its value, in the order of their lines."""
    used = {name for chain in notes.chains for side in chain.sides for name in names(side.node)}
    reader = _Reader(notes, used, symbols_at)
    numbered = list(tables_of_values(notes, list(tables_of(notes.text)), used))
    within = {(c.lines[0], name) for c in numbered for name in names(c.sides[1].node)}
    chains = [
        # in a row z_k | a | 0 | -a the a is a value, and has none there itself
        *(chain for chain in reader.of_tables() if (chain.lines[0], _letter(chain)) not in within),
        *reader.of_items(),
        *reader.of_lines(),
        *reader.of_prose(),
        *reader.of_code(),
        *rows_of_values(notes, used),
        *instances_of_rules(notes, used),
        *numbered,
    ]
    return tuple(sorted(chains, key=lambda chain: chain.sides[0].span))


@dataclass(frozen=True)
class _Reader:
    notes: ReadNotes
    used: set[str]
    symbols_at: Symbols

    def of_tables(self) -> Iterator[Chain]:
        """Yield the data of tables; a letter with two values in one table has none."""
        for table in tables_of(self.notes.text):
            chains = [*self._by_rows(table), *self._by_columns(table)]
            counts = Counter(_letter(chain) for chain in chains)
            yield from (chain for chain in chains if counts[_letter(chain)] == 1)

    def _by_rows(self, table: Table) -> Iterator[Chain]:
        for row in table:
            letters = [(k, own) for k, cell in enumerate(row) if (own := self._letter_of(cell))]
            values = [k for k, cell in enumerate(row) if _value_match(cell.text)]
            if len(letters) != 1 or len(values) != 1:
                continue
            (place, (name, unit)), value = letters[0], values[0]
            behind = [cell.text for cell in row[value + 1 : value + 2]]
            chain = self._chain(name, row[place], row[value], unit or "".join(behind))
            if chain is not None and value > place:
                yield chain

    def _by_columns(self, table: Table) -> Iterator[Chain]:
        if len(table) != 2 or len(table[0]) != len(table[1]):
            return
        heads = [self._letter_of(cell) for cell in table[0]]
        if sum(head is not None for head in heads) < 2:
            return
        for head, above, below in zip(heads, *table, strict=True):
            chain = self._chain(head[0], above, below, head[1]) if head else None
            if chain is not None:
                yield chain

    def of_items(self) -> Iterator[Chain]:
        """Yield the data of lists: `- crank radius $r$: 45 mm`."""
        for match in _ITEM.finditer(self.notes.text):
            letter = Cell(match["letter"], match.span("letter"))
            own = self._letter_of(letter)
            if own is not None:
                chain = self._chain(own[0], letter, Cell(match["value"], match.span("value")), own[1])
                if chain is not None:
                    yield chain

    def of_lines(self) -> Iterator[Chain]:
        """Yield the data of lists whose lines have no bullets: three at least, one below the other."""
        block: list[re.Match[str]] = []
        for match in (*_DATUM.finditer(self.notes.text), None):
            if match is not None and block and match.start() <= block[-1].end() + 1:
                block.append(match)
                continue
            for each in block if len(block) >= FEWEST_DATA else ():
                name = letter_in(self.notes.text, each["letter"])
                letter, value = (Cell(each[key], each.span(key)) for key in ("letter", "value"))
                is_letter = name is not None and self._is_letter(name, letter.span[0])
                if name is not None and is_letter and (chain := self._chain(name, letter, value, "")):
                    yield chain
            block = [] if match is None else [match]

    def of_prose(self) -> Iterator[Chain]:
        """Yield the data of sentences: the mass $m$ is 0.5 kg."""
        for given in values_in_prose(self.notes, self._letter_given):
            letter = Cell(given.letter, given.letter_span)
            name = self._letter_given(given)
            chain = self._chain(name, letter, Cell(given.value, given.value_span), "") if name else None
            if chain is not None:
                yield chain

    def _letter_given(self, given: GivenInProse) -> str | None:
        bare = bare_cell(given.letter)
        spellings = (bare, f"{bare[0]}_{{{bare[1:]}}}") if bare.isalpha() and len(bare) > 1 else (bare,)
        names_of_it = (letter_in(self.notes.text, spelling) for spelling in spellings)
        return next((n for n in names_of_it if n and self._is_letter(n, given.letter_span[0])), None)

    def of_code(self) -> Iterator[Chain]:
        """Yield the numbers that program code gives to letters of the page."""
        for block in _FENCED.finditer(self.notes.text):
            if block["language"].lower() not in _PROGRAM:
                continue
            begin, code = block.start("code"), block["code"]
            for match in _ASSIGNED.finditer(code):
                letters = [name.strip() for name in match["names"].split(",")]
                values = [value.strip() for value in match["values"].split(",")]
                span = begin + match.start("values"), begin + match.end("values")
                for letter, value in zip(letters, values, strict=False):
                    name = _CODE_NAMES.get(letter, letter)
                    if len(letters) == len(values) and self._is_letter(name, span[0]):
                        yield from self._assigned(name, value, match["comment"] or "", span)

    def _assigned(self, name: str, value: str, comment: str, span: Span) -> Iterator[Chain]:
        number = _typed(value)
        line = self.notes.line_of(span[0])
        role = role_of(self.symbols_at(line).get(name, ""))
        if number is None:
            return
        unit = next((word for word in _words_of(comment) if scale_of(word)), "")
        if not unit and role in _LENGTHS and number.value > LONGEST_METRES:
            return
        if (node := _with_unit(number, unit, span)) is not None:
            yield _as_chain(name, span, node, span, line)

    def _letter_of(self, cell: Cell) -> tuple[str, str] | None:
        """Return the letter of the page that a cell holds, perhaps behind words, and its unit."""
        marked = _MARKED_LETTER.fullmatch(_formula_marks(cell.text).strip())
        text = f"{marked['letter']} {marked['unit']}".strip() if marked else bare_cell(cell.text)
        unit = ""
        if beside := _UNIT_BESIDE.fullmatch(text):
            unit = beside["square"] or beside["round"] or beside["per"]
            text = beside["letter"]
            if scale_of(unit) is None:
                return None
        named = None if marked else _NAMED_LETTER.fullmatch(text)
        if named is not None and not _OTHERS.search(named["words"]):
            text = named["letter"]
        name = letter_in(self.notes.text, bare_cell(text))
        return (name, unit) if name and self._is_letter(name, cell.span[0]) else None

    def _is_letter(self, name: str, place: int) -> bool:
        """Tell whether a name is one of the page's letters: in a formula, or declared."""
        return name in self.used or name in self.symbols_at(self.notes.line_of(place))

    def _chain(self, name: str, letter: Cell, value: Cell, unit_beside: str) -> Chain | None:
        match = _value_match(value.text)
        number = _number(match, self._has_commas) if match else None
        if match is None or number is None:
            return None
        line = self.notes.line_of(value.span[0])
        unit = match["unit"] or (unit_beside if scale_of(as_unit(bare_cell(unit_beside))) else "")
        is_count = number.value.denominator == 1 and number.value <= LARGEST_COUNT
        role = role_of(self.symbols_at(line).get(name, ""))
        is_bare = (
            role in _BARE
            or (is_count and role not in _LENGTHS)
            or self._is_called_bare(letter.span, value.span)
        )
        if not unit and not is_bare:
            return None
        node = _with_unit(number, bare_cell(unit), value.span)
        return None if node is None else _as_chain(name, letter.span, node, value.span, line)

    def _is_called_bare(self, letter: Span, value: Span) -> bool:
        """Tell whether the words around a letter and its number call it what has no unit."""
        text = self.notes.text
        first, last = min(letter[0], value[0]), max(letter[1], value[1])
        start = max(text.rfind("\n", 0, first) + 1, text.rfind(". ", 0, first) + 1, first - _NEAR_WORDS)
        return _BARE_NOUN.search(text, start, last) is not None

    @property
    def _has_commas(self) -> bool:
        return any(note.startswith("decimal commas") for note in self.notes.notes)


def _letter(chain: Chain) -> str:
    node = chain.sides[0].node
    return node.name if isinstance(node, Name) else ""


def _as_chain(name: str, letter: Span, node: Formula, value: Span, line: int) -> Chain:
    sides = Side((Name(name, span=letter),), letter), Side((node,), value)
    return Chain(sides, (Relation("=", line),), (line,))


def number_in_cell(text: str, has_commas: bool) -> tuple[Number, str] | None:
    """Return the number that a cell consists of, and its unit, "" where it has none; else None.

    >>> number, unit = number_in_cell("$4000$ rpm", False)
    >>> number.value, unit
    (Fraction(4000, 1), 'rpm')
    """
    match = _VALUE.fullmatch(bare_cell(text))
    number = _number(match, has_commas) if match is not None else None
    return None if match is None or number is None else (number, match["unit"] or "")


def quantity_typed(text: str, span: Span, *, has_commas: bool) -> Formula | None:
    """Return a number with its unit as it is typed in a sentence, None for anything else."""
    read = number_in_cell(text, has_commas)
    return None if read is None else _with_unit(*read, span)


def bare_cell(text: str) -> str:
    """Return a cell without markup."""
    text = _STEM.sub(r"\1\2", _SUBSCRIPT.sub(r"_{\1}", text))
    return " ".join(_MARKUP.sub(" ", text.replace("{,}", ",")).split())


def _formula_marks(text: str) -> str:
    r"""Return a cell with one kind of marks around its formulas: <math>, \( \), '' and <i> as dollars."""
    text = _STEM.sub(r"$\1\2$", _SUBSCRIPT.sub(r"_{\1}", text))
    text = re.sub(r"</?(?:math|i|em|var)\b[^>]*>|\\[()]|'{2,3}", "$", text)
    return re.sub(r"(?<=\w)\$(_\{[^}]*\})", r"\1$", text)  # <i>m</i><sub>1</sub>


def _value_match(text: str) -> re.Match[str] | None:
    match = _VALUE.fullmatch(bare_cell(text))
    if match is None or (match["unit"] and scale_of(as_unit(match["unit"])) is None):
        return None
    return match


def _number(match: re.Match[str], has_commas: bool) -> Number | None:
    """Return the number of a value as printed."""
    digits = re.sub("[  ]", "", match["digits"])
    is_lone = len(re.findall("[,.]", digits)) == 1 and "," in digits
    if has_commas or (is_lone and not _GROUPED.fullmatch(digits)):
        digits = (digits.replace(".", "") if "," in digits else digits).replace(",", ".")
    elif _GROUPED.fullmatch(digits) and "," in digits:
        digits = digits.replace(",", "")
    number = _typed(match["sign"].replace("−", "-") + digits)
    power = int((match["power"] or match["raised"] or "0").translate(_RAISED))
    if number is None:
        return None
    if match["divisor"]:
        return Number(number.value / int(match["divisor"]))
    scale = Fraction(10) ** power
    return Number(number.value * scale, number.last_place * scale if number.last_place else None)


def _typed(text: str) -> Number | None:
    """Return a number as program code writes it, 45e-3."""
    match = re.fullmatch(r"([-+]?[0-9]+)(?:\.([0-9]*))?(?:[eE]([-+]?[0-9]{1,2}))?", text.replace("_", ""))
    if match is None:
        return None
    scale = Fraction(10) ** int(match[3] or 0)
    decimals = match[2] or ""
    place = scale / 10 ** len(decimals) if decimals else None
    return Number(Fraction(int(match[1] + decimals), 10 ** len(decimals)) * scale, place)


def _with_unit(number: Number, unit: str, span: Span) -> Formula | None:
    """Return a quantity as it is read in a formula, every part at its place."""
    scale = scale_of(as_unit(unit)) if unit else (Fraction(1), False)
    if scale is None:
        return None
    size, is_turn = scale
    if is_turn:
        half_turn = Number(1 / size, span=span) if size.numerator == 1 else None
        if half_turn is None:
            return None
        factor = Quotient(Constant("pi", span=span), half_turn, span=span)
        return Product((Number(number.value, number.last_place, span=span), factor), span=span)
    return Number(number.value * size, number.last_place * size if number.last_place else None, span=span)


def _words_of(comment: str) -> list[str]:
    """Return what of a comment may be a unit: in brackets, or a word of its own, the last one first."""
    bracketed = re.findall(r"[\[(]([^\])]+)[\])]", comment)
    return [*bracketed, comment.strip(), *reversed(comment.replace(",", " ").split())]
