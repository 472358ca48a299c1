"""The sidecar file of a document: what its letters mean, where, and what its lines claim to be.

    [symbols]                        letter -> meaning or unit
    [[scope]]                        lines = [a, b] with symbols and equalities of their own
    [[bind]]                         line, quantity, engine, order, ...: what a line claims to be

`letters = "crank"` at the head takes a standard set of letters; what [symbols] says goes before it.
Behind a question mark, `s = "? stroke"`, a meaning is proposed and not confirmed: s is just a letter. A
scope or a binding with `proposed = true` plays no part.

Unknown keys are errors; every refusal names the file and the line. What stands in [symbols] and is no
letter, as `"|x|"`, declares nothing: the report says so, and the exit code.

The declarations may stand at the head of the document itself instead, as a comment that comes first:

    <!-- [symbols]                   % [symbols]                    # [symbols]
    r = "crank radius"               % r = "crank radius"           # r = "crank radius"
    -->                              (.tex)                         (.txt and others)
    (.md)

In a notebook they are a raw cell of their own, without marks, wherever it stands.

What is read as equations is the rest, at its own lines. A text without a file, typed in or piped, may
have any of the three.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Set
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, NamedTuple

from symbalance.notes.checking.declared.role_phrases import USUAL
from symbalance.notes.checking.declared.symbol_roles import KNOWN, letters_by_role, misspelt_role
from symbalance.notes.reading import ReadingError, canonical_name
from symbalance.text import lazy_patterns as re
from symbalance.text.files import file_name, read_text
from symbalance.text.key_tables import Key, TableKeys
from symbalance.text.kinds import Choice, Flag, ListOf, Text, Whole
from symbalance.text.sections import Section, SourceText, read_sections

Letter = Callable[[str], str]
"""What names a letter by its spelling, as `canonical_name` does; raises ReadingError for no letter."""
CONVENTIONS = ("l/r", "r/l", "l/s")
_MOST = 10**9
_COUNT = Whole(1, _MOST)
_ORDER = Whole(1, 1000)
"""As far as every command goes: a series through 10^9 would fill the memory."""
_SYMBOLS = "Letters and their meanings or units"
PROPOSED = "?"
"""Before a meaning that is proposed and not confirmed."""
_PROPOSED = Key("proposed", Flag(), "Whether it is proposed and not confirmed: it plays no part")
SCOPE = TableKeys(
    "scope",
    (
        Key(
            "lines",
            ListOf(_COUNT, "[10, 20]", exactly=2),
            "The first and the last line it holds for",
            required=True,
            remedy="count from 1",
            add="write lines = [10, 20]",
        ),
        Key("symbols", TableKeys("scope.symbols", (), others=Text()), _SYMBOLS),
        Key("given", ListOf(Text(), '["α = π/6"]'), "Equalities that hold there"),
        _PROPOSED,
    ),
)
BIND = TableKeys(
    "bind",
    (
        Key("line", _COUNT, "The line", required=True, remedy="write line = 2"),
        Key("quantity", Text(), "What it claims to be", required=True),
        Key("engine", Text(), "Of which engine: a preset or an engine file"),
        Key("convention", Choice(CONVENTIONS), "What a series is in", remedy="name one of them"),
        Key("text", Text(), "The piece of the line that is meant"),
        Key("scale", Text(), "What it is a multiple of"),
        Key("unit", Text(), "Its unit"),
        Key("order", _ORDER, "Of which order", remedy="write order = 2"),
        *(
            Key(name, _COUNT, "Of which " + name, remedy=f"write {name} = 2")
            for name in ("column", "cylinder")
        ),
        Key("bank", Whole(-_MOST, _MOST), "Of which bank", remedy="write bank = 2"),
        Key("through", _ORDER, "The highest order", remedy="write through = 4"),
        Key("power", Whole(-1000, 1000), "Of the series", remedy="write power = 2"),
        _PROPOSED,
    ),
)
SIDECAR = TableKeys(
    "",
    (
        Key("letters", Choice(tuple(USUAL)), "A standard set of letters", remedy="name one of them"),
        Key("symbols", TableKeys("symbols", (), others=Text()), _SYMBOLS),
        Key("scope", SCOPE, "Lines with letters and assumptions of their own", listed=True),
        Key("bind", BIND, "What lines claim to be", listed=True),
    ),
)
_MARKDOWN = re.compile(r"\s*<!--\s*(\[(?:symbols|\[scope\]|\[bind\])\].*?)-->", re.DOTALL)
_LINES = {mark: re.compile(rf"\s*(?:{mark}[^\n]*(?:\n|$))+") for mark in ("%", "#")}
_I = re.compile(r"\\?(?:mathrm\s*\{\s*)?(?:i{1,3}|imath|im|iu|I|j|jmath)(?:\s*\})?")
_IMAGINARY_UNIT = re.compile(
    r"imaginary\s+(?:unit|number)|imaginäre[rn]?\s+(?:Einheit|Zahl)|imaginaire|imaginaria|immaginaria"
    r"|imaginære?|虚数単位|sqrt\s*\(?-\s*1|√\(?[-−]\s*1",
    re.IGNORECASE,
)
_RAW_CELL = re.compile(
    r"<!-- cell [0-9]{1,6}: raw -->\n(`{3,})code\n(\s*\[(?:symbols|\[scope\]|\[bind\])\].*?)\n\1(?:\n|$)",
    re.DOTALL,
)
_BY_SUFFIX = {
    ".md": (_MARKDOWN,),
    ".tex": (_LINES["%"],),
    "": (_MARKDOWN, _LINES["%"], _LINES["#"]),
}
_OPENING = re.compile(r"\s*\[\s*symbols\s*\]|\s*\[\[\s*(?:scope|bind)\s*\]\]")


@dataclass(frozen=True, slots=True)
class Scope:
    """Lines with letters and assumptions of their own; both ends included."""

    first: int
    last: int
    symbols: Mapping[str, str] = field(default_factory=dict)
    assumptions: tuple[str, ...] = ()
    proposed: bool = False
    by_page: bool = False
    """Whether the page's own words made it: it is of its letters alone, not of all that stands there."""

    def confines(self, letters: Set[str]) -> bool:
        """Tell whether what is defined in its lines, of these letters, holds nowhere else.

        A page that says k = 1, …, N in one section counts with k there; all else it gives stays given.
        """
        if not self.by_page:
            return True
        return any(n in self.symbols and self.symbols[n] != "integer" for n in letters)

    def holds(self, line: int) -> bool:
        """Tell whether a line lies in the scope."""
        return self.first <= line <= self.last


@dataclass(frozen=True, slots=True)
class Binding:
    """What a line, or a piece `text` of it, claims to be."""

    line: int
    quantity: str
    engine: str = ""
    convention: str = ""
    text: str = ""
    scale: str = ""
    unit: str = ""
    order: int | None = None
    column: int | None = None
    cylinder: int | None = None
    bank: int | None = None
    through: int | None = None
    power: int | None = None
    proposed: bool = False
    place: str = ""

    @property
    def title(self) -> str:
        """Return what the line claims to be, in words."""
        if self.quantity == "value":
            return self.scale
        parts = [self.quantity]
        parts += [f"order {self.order}"] if self.order is not None else []
        parts += [f"cylinder {self.cylinder}"] if self.cylinder is not None else []
        parts += [f"bank {self.bank}"] if self.bank is not None else []
        parts += [f"of {Path(self.engine).stem}"] if self.engine else []
        return ", ".join(parts[:-1]) + (" " if self.engine else ", " if parts[:-1] else "") + parts[-1]


class UnreadLetter(NamedTuple):
    """What [symbols] gives a meaning and is no letter: its line declares nothing."""

    place: str
    rule: str
    remedy: str


@dataclass(frozen=True, slots=True)
class Declarations:
    """All that is declared about a document."""

    symbols: Mapping[str, str] = field(default_factory=dict)
    scopes: tuple[Scope, ...] = ()
    bindings: tuple[Binding, ...] = ()
    place: str = "symbols"
    proposed_scopes: tuple[Scope, ...] = ()
    proposed_bindings: tuple[Binding, ...] = ()
    """What is proposed and not confirmed, which nothing is judged by."""
    unread: tuple[UnreadLetter, ...] = ()
    """Lines of [symbols] that declare nothing: the report names each, and the document fails by it."""

    @property
    def is_declared(self) -> bool:
        """Tell whether anything at all is declared."""
        return self.place != "symbols" or bool(self.symbols or self.scopes or self.bindings)

    @property
    def proposal_count(self) -> int:
        """The number of proposals that nobody has confirmed."""
        texts = [
            *self.symbols.values(),
            *(text for scope in self.scopes for text in scope.symbols.values()),
        ]
        of_letters = sum(text.startswith(PROPOSED) for text in texts)
        return of_letters + len(self.proposed_scopes) + len(self.proposed_bindings)

    def without_idle(self, used: Set[str]) -> Declarations:
        """Return the declarations without letters that stand aside for another of the same meaning.

        A course whose notes write θ or φ declares both a crank angle. A page that writes φ alone has one
        crank angle, and what is known of a rod angle or a displacement must be said in that.
        """
        if self.scopes or self.bindings:  # their texts may hold letters that the page does not
            return self
        by_role = letters_by_role(self.symbols)
        idle = {
            name
            for role, letters in by_role.items()
            if role in KNOWN and not used.isdisjoint(letters)
            for name in letters
            if name not in used
        }
        return replace(self, symbols={n: text for n, text in self.symbols.items() if n not in idle})

    @property
    def has_imaginary_j(self) -> bool:
        """Whether j is declared the imaginary unit."""
        return _IMAGINARY_UNIT.search(self.symbols.get("j", "")) is not None

    def without_imaginary_unit(self) -> Declarations:
        r"""Return the declarations without an i, \ii or j that is the imaginary unit, a number."""
        symbols = {
            name: text
            for name, text in self.symbols.items()
            if not (_I.fullmatch(name) and _IMAGINARY_UNIT.search(text))
        }
        return self if len(symbols) == len(self.symbols) else replace(self, symbols=symbols)

    def accepted(self) -> Declarations:
        """Return the declarations with every proposal taken as confirmed."""
        scopes = (*self.scopes, *self.proposed_scopes)
        return replace(
            self,
            symbols=_confirmed(self.symbols),
            scopes=tuple(replace(scope, symbols=_confirmed(scope.symbols)) for scope in scopes),
            bindings=(*self.bindings, *self.proposed_bindings),
            proposed_scopes=(),
            proposed_bindings=(),
        )

    def below(self, other: Declarations) -> Declarations:
        """Return the declarations with the letters of `other` added that these do not declare."""
        unread = (*self.unread, *other.unread)
        return replace(self, symbols={**other.symbols, **self.symbols}, unread=unread)

    def symbols_at(self, line: int) -> dict[str, str]:
        """Return the letters declared for a line; later scopes override earlier ones."""
        symbols = dict(self.symbols)
        for scope in self.scopes:
            if scope.holds(line):
                symbols |= scope.symbols
        return symbols

    def assumptions_at(self, line: int) -> tuple[str, ...]:
        """Return the assumptions that stand at a line."""
        holding = (scope for scope in self.scopes if scope.holds(line))
        return tuple(text for scope in holding for text in scope.assumptions)

    def owner(self, letter: str, line: int) -> int:
        """Return the number of the last scope that declares a letter at a line, -1 for [symbols]."""
        return max((k for k in self.scope_at(line) if letter in self.scopes[k].symbols), default=-1)

    def scopes_of(self, letters: Set[str], line: int) -> tuple[int, ...]:
        """Return the numbers of the scopes that what a line says of letters does not reach out of."""
        return tuple(k for k in self.scope_at(line) if self.scopes[k].confines(letters))

    def scope_at(self, line: int) -> tuple[int, ...]:
        """Return the numbers of the scopes a line lies in: what tells two places' letters apart."""
        return tuple(k for k, scope in enumerate(self.scopes) if scope.holds(line))


def read_sidecar(path: str | Path, letter: Letter = canonical_name) -> Declarations:
    """Return the declarations of a sidecar file; `letter` reads a letter as the document writes it."""
    return parse_sidecar(read_text(path, what="a symbols file"), file_name(path), letter)


def parse_sidecar(text: str, place: str, letter: Letter = canonical_name) -> Declarations:
    """Return the declarations in the text of a sidecar; `place` is what errors call it."""
    remedy = 'correct the line; a letter such as θ stands in quotes: "θ" = "crank angle"'
    return _declarations(read_sections(text, place, SIDECAR, remedy), letter)


def declarations_in(symbols: Mapping[str, Any], letter: Letter = canonical_name) -> Declarations:
    """Return the declarations in a Python mapping: letters to meanings, or a sidecar's whole table."""
    table = dict(symbols)
    if any(isinstance(value, str) for value in table.values()) or not set(table) <= set(SIDECAR.by_name):
        table = {"symbols": table}
    return _declarations(Section(table, SIDECAR, SourceText("", "symbols")).check(), letter)


def _declarations(file: Section, letter: Letter) -> Declarations:
    unread: list[UnreadLetter] = []
    scopes = tuple(_scope(table, letter, unread) for table in file.sections("scope"))
    bindings = tuple(Binding(**table.values(), place=table.place()) for table in file.sections("bind"))
    usual = {canonical_name(usual): text for usual, text in USUAL.get(file.value("letters"), {}).items()}
    symbols = usual | _symbols(file.section("symbols"), letter, unread)
    return Declarations(
        symbols,
        tuple(scope for scope in scopes if not scope.proposed),
        tuple(binding for binding in bindings if not binding.proposed),
        file.source.place,
        tuple(scope for scope in scopes if scope.proposed),
        tuple(binding for binding in bindings if binding.proposed),
        tuple(unread),
    )


def _confirmed(symbols: Mapping[str, str]) -> dict[str, str]:
    return {name: text.removeprefix(PROPOSED).strip() for name, text in symbols.items()}


def _symbols(table: Section, letter: Letter, unread: list[UnreadLetter]) -> dict[str, str]:
    """Return the meanings of a table by letter; what is no letter goes to `unread`."""
    meanings: dict[str, str] = {}
    for spelling, meaning in table.values().items():
        try:
            name = letter(spelling)
        except ReadingError as problem:
            name = _product(spelling, letter)
            if not name:
                remedy = problem.remedy or "write one letter"
                unread.append(UnreadLetter(table.place(spelling), problem.what, remedy))
                continue
        if meanings.get(name, meaning.strip()) != meaning.strip():
            raise table.refusal(spelling, "is declared twice", "keep one line of it")
        nearest = misspelt_role(meaning)
        if nearest is not None:
            remedy = f'write "{nearest}", or "variable, {meaning.strip()}" for just a letter'
            raise table.refusal(spelling, f"has no known meaning, but one much like {nearest}", remedy)
        meanings[name] = meaning.strip()
    return meanings


def _product(spelling: str, letter: Letter) -> str:
    """Return the letters of a product that has a meaning of its own, "m_w r_w" an unbalance; else "".

    Its letters have none by that.
    """
    parts = [part for part in re.split(r"[\s·*⋅]+|\\,|\\cdot", spelling) if part]
    try:
        return " ".join(letter(part) for part in parts) if len(parts) > 1 else ""
    except ReadingError:
        return ""


def _scope(table: Section, letter: Letter, unread: list[UnreadLetter]) -> Scope:
    first, last = table.value("lines")
    if first > last:
        raise table.refusal("lines", "must go upwards", "write lines = [10, 20]")
    symbols = _symbols(table.section("symbols"), letter, unread)
    return Scope(first, last, symbols, tuple(table.value("given") or ()), bool(table.value("proposed")))


# Declarations at the head of the document itself


def without_header(text: str, suffix: str) -> tuple[str, str]:
    """Return (the document with its header blank, the header's text as TOML); "" if there is none.

    >>> without_header('% [symbols]\\n% r = "crank radius"\\n$r=1$', ".tex")[1]
    '[symbols]\\nr = "crank radius"\\n'
    """
    if suffix.lower() == ".ipynb":  # a raw cell stands fenced, and is passed over as it is
        cell = _RAW_CELL.search(text)
        return text, "\n" * text[: cell.start(2)].count("\n") + cell[2] + "\n" if cell else ""
    for pattern in _BY_SUFFIX.get(suffix, (_LINES["#"],)):
        match = pattern.match(text)
        if match is None:
            continue
        in_lines = pattern is not _MARKDOWN
        inside = re.sub(r"(?m)^[ \t]*[%#][ \t]?", "", match[0]) if in_lines else match[1]
        if _OPENING.match(inside):
            blank = re.sub(r"[^\n]", " ", match[0])
            before = 0 if in_lines else text[: match.start(1)].count("\n")
            return blank + text[match.end() :], "\n" * before + inside
    return text, ""
