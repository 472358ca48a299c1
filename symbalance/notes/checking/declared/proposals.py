"""Proposals of what a page's letters mean and what its lines claim to be, gathered from the words around.

Nothing here is believed. A proposal goes, marked, into a draft of the symbols file; a person confirms it.

    letters     every letter and word of the page's formulas, with the line it first stands on
    roles       "s: ストローク", "where r is the crank radius", "Kurbelradius r", λ = l/s
    scopes      a letter that is introduced again with another meaning; components of a force
    bindings    what stands below a heading such as "6次慣性力", for the engine named last
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Negative,
    Number,
    Product,
    Quotient,
    names,
    walk,
)
from symbalance.document.letters import FUNCTION_WORDS, GREEK_SIGN, LOWERED, plain_letter
from symbalance.document.wordlists import word_set
from symbalance.notes.checking.declared.engines import Engines
from symbalance.notes.checking.declared.role_phrases import (
    CONVENTIONS,
    GERMAN_RATIO,
    MOVING_SECTIONS,
    RATIO,
    USUAL,
    NamedRole,
    roles_named,
)
from symbalance.notes.checking.declared.symbol_roles import FROM_TOP, KNOWN, UNITS
from symbalance.notes.reading import read_document
from symbalance.notes.reading.equations import Chain, ReadNotes

MOST_ROUNDS = 60
"""Each round of reading finds the first undeclared letter of every equation."""
_UNDECLARED = re.compile(r"letter (\S+) is not declared$")
_PLAIN_WORDS = word_set(
    "as at be by do go he if in is it me my no of on or so to up us we and are but can for had has let"
    " now so one our out per the two use was pi mm cm km kg kw hz nm rpm vs via etc ab am an da der die"
    " das du er es ich im ist man mit so um und von was wir wo zu tdc bdc ot ut"
)
_LONGEST_LINE = 2000
"""Characters of a line of prose that is searched: longer ones are no sentences of a derivation."""


@dataclass(frozen=True, slots=True)
class Proposal:
    """A meaning proposed for a letter, and the words it is taken from; none where it is merely usual."""

    letter: str
    meaning: str
    line: int
    words: str = ""


@dataclass(frozen=True, slots=True)
class ScopeProposal:
    """Lines in which a letter is proposed to mean something else, or in which equalities hold."""

    first: int
    last: int
    symbols: Mapping[str, str] = field(default_factory=dict)
    given: tuple[str, ...] = ()
    words: str = ""


@dataclass(frozen=True, slots=True)
class BindProposal:
    """What a line is proposed to claim: the keys of [[bind]], and the words it is taken from."""

    keys: Mapping[str, str | int]
    words: str


@dataclass(frozen=True, slots=True)
class Proposals:
    """All that is proposed for a page; `letters` tells the line on which each letter first stands."""

    letters: Mapping[str, int]
    meanings: Mapping[str, Proposal] = field(default_factory=dict)
    scopes: tuple[ScopeProposal, ...] = ()
    bindings: tuple[BindProposal, ...] = ()


def propose(
    text: str, name: str, names_at: Callable[[int], Collection[str]], engines: Engines
) -> Proposals:
    """Return what the words of a page propose; `names_at` tells the letters declared at each line.

    >>> from symbalance.notes.checking.declared.engines import NoEngines
    >>> page = "crank radius r, crank angle θ\\n\\n$$y = r cos θ$$"
    >>> proposed = propose(page, "page.md", lambda line: (), NoEngines())
    >>> [(p.letter, p.meaning) for p in proposed.meanings.values()]
    [('r', 'crank radius'), ('theta', 'crank angle')]
    """
    page, letters = _read_with_all_letters(text, name, names_at)
    lines = text.split("\n")
    roles = _Roles(lines, page, letters, names_at)
    meanings, scopes = roles.gather()
    sections = _Sections(lines, page, engines)
    bindings = tuple(sections.bindings(meanings))
    scopes = (*scopes, *_components(lines, letters, meanings))
    return Proposals(letters, meanings, tuple(sorted(scopes, key=lambda s: s.first)), bindings)


def meanings_from_words(
    page: ReadNotes, declared_at: Callable[[int], Collection[str]]
) -> dict[str, Proposal]:
    """Return the first meaning that a page's words propose for each letter of its formulas.

    Of a page as it was read; lines of prose that were broken are read on to the next one.
    """
    letters: dict[str, int] = {}
    for chain in page.chains:
        for letter in sorted({n for side in chain.sides for n in names(side.node)}):
            if letter not in declared_at(chain.lines[0]) and not letter.endswith("'"):
                letters.setdefault(letter, chain.lines[0])
    lines = list(_read_on(page.text.split("\n")))
    return _Roles(lines, page, letters, declared_at).gather()[0]


def _read_on(lines: Sequence[str]) -> Iterator[str]:
    """Yield lines, of prose that goes on with the first words of the next one."""
    for line, following in zip(lines, [*lines[1:], ""], strict=True):
        is_prose = re.search(r"[a-z,]\s*$", line) and re.match(r"[a-z]{2,}\s+[a-z]", following)
        yield f"{line.rstrip()} {' '.join(following.split()[:4])}" if is_prose else line


# The letters


_WORD = re.compile(r"(?<![A-Za-z\\{_.])([A-Z][a-z]{1,2}|[a-z]{2}|[A-Za-z][0-9]{1,2})(?![A-Za-z0-9({_])")
_LEFT_ALONE = re.compile(
    r"(?:^|[^A-Za-z0-9\\_{}^)\]])(?:\\displaystyle\s+)?(\\?[A-Za-zα-ωΑ-Ω][A-Za-z0-9]*(?:_\{?[A-Za-z0-9]+\}?)?)"
    r"\s*&?(?:=|≈|\\approx|\\fallingdotseq)"
)


def _read_with_all_letters(
    text: str, name: str, names_at: Callable[[int], Collection[str]]
) -> tuple[ReadNotes, dict[str, int]]:
    """Return a page read with every letter declared, and the letters that are not, by first line."""
    letters: dict[str, int] = dict(_words(text, names_at))
    page = read_document(text, name, lambda line: {*names_at(line), *letters})
    for _ in range(MOST_ROUNDS):
        missing = [(_UNDECLARED.search(part.what), part.line) for part in page.unreadable]
        new = {match[1]: line for match, line in reversed(missing) if match and match[1] not in letters}
        if not new:
            break
        letters.update(new)
        page = read_document(text, name, lambda line: {*names_at(line), *letters})
    for chain in page.chains:
        for side in chain.sides:
            for letter in names(side.node):
                line = chain.lines[0]
                if letter not in names_at(line) and not letter.endswith("'"):
                    letters[letter] = min(letters.get(letter, line), line)
    occurring = {letter for chain in page.chains for side in chain.sides for letter in names(side.node)}
    unread = {letter for letter in letters if letter not in occurring and not _WORD.fullmatch(letter)}
    ordered = sorted(letters, key=lambda letter: (letters[letter], letter))
    return page, {letter: letters[letter] for letter in ordered if letter in occurring | unread}


def _words(text: str, names_at: Callable[[int], Collection[str]]) -> Iterator[tuple[str, int]]:
    """Yield runs of letters that are one letter, such as Lh: alone before an equals sign, or named."""
    for number, line in enumerate(text.split("\n"), 1):
        if len(line) > _LONGEST_LINE:
            continue
        for match in _WORD.finditer(line):
            word = match[1]
            if word in FUNCTION_WORDS or word in names_at(number) or word.lower() in _PLAIN_WORDS:
                continue
            rest, before = line[match.end() :].lstrip(), line[: match.start()]
            before = before.rstrip().removesuffix("\\displaystyle").rstrip()
            is_side = rest[:1] == "=" and not before[-1:].isalnum() and before[-1:] not in ("/", ")", "}")
            is_named = any(
                role.may_name(word) and _gap_is_naming(line, role.start, role.end, *match.span(1))
                for role in roles_named(line)
            )
            if is_side or is_named:
                yield word, number


# What the words around say


_AFTER = re.compile(
    r"[\s$\\({\[（「]*(?:(?:\([^()]{0,20}\)|（[^（）]{0,20}）)[\s$\\({]*)?[:：=]?[\s$\\({]*"
    r"(?:(?:is|are|be|by|called|denoted|given|with|mit|ist|sei|heißt|bezeichnet|als|を|が|は)[\s$\\({]*){0,2}"
)
_BEFORE = re.compile(
    r"[\s$\\)}\]）」]*(?:(?:\([^()]{0,12}\)|（[^（）]{0,12}）)\s*)?"
    r"(?:[:：=]\s*(?:[lrs]/[lrs]\s*)?[\u3040-\u9fff]{0,8}"
    r"|(?:is|are|be|being|denotes|means|stands\s+for|ist|sei|bezeichnet)\b|,\s*(?=the\b|der\b|die\b|das\b)"
    r"|は[^、。は]{0,14}|が[^、。は]{0,20}|を|…|\.{2,3}|[-–—])[\s$]*"
    r"(?:(?:the|a|an|der|die|das|den|its|one|half)\s+)?"
)
_OF_LIST = re.compile(r"[\s$\\)]{1,4}(?:the|der|die|das|den)\s+")
_BARE = re.compile(r"\$ |\\\) ")
_LISTED = re.compile(r"(?:^|[,;:(]|\*)\s*(?:\$|\\\()\s*\\?$")
_LIST_GOES_ON = re.compile(r"\s*(?:[,;.)]|$)")
_COUNTED = re.compile(
    r"(?<![A-Za-z\\])\$?([NnkKzij])\$?"
    r"(?:気筒|次の?(?:慣性|成分|$)|[- ]cylinders?\b|[- ]?th\b| Zylinder|-te\b)"
)


_WIDEST_GAP = 40
"""Characters between a letter and the words that name it."""


def _gap_is_naming(line: str, start: int, end: int, first: int, last: int) -> bool:
    """Tell whether what stands between a phrase (start, end) and a letter (first, last) names it."""
    if max(start - last, first - end) > _WIDEST_GAP:
        return False
    if end <= first:
        return _AFTER.fullmatch(line, end, first) is not None
    if last > start:
        return False
    # "R is the crank radius, L the length of the rod": of a list each but the first goes without "is"
    is_in_list = line[:first].rstrip(" $\\(").endswith((",", ";", "and", "und", "with", "where", "mit"))
    is_of_list = is_in_list and _OF_LIST.fullmatch(line, last, start) is not None
    return (
        is_of_list
        or _BEFORE.fullmatch(line, last, start) is not None
        or (
            _BARE.fullmatch(line, last, start) is not None  # "$r$ crank radius, $l$ rod length"
            and _LISTED.search(line[:first]) is not None
            and _LIST_GOES_ON.match(line, end) is not None
        )
    )


class _Roles:
    """Gathers the roles that a page's words give its letters."""

    def __init__(
        self,
        lines: Sequence[str],
        page: ReadNotes,
        letters: Mapping[str, int],
        names_at: Callable[[int], Collection[str]],
    ) -> None:
        self.lines, self.page, self.letters, self.names_at = lines, page, letters, names_at
        self.spelling = _spelling(letters)
        self.letter_of = {written: name for name in letters for written in _spellings(name)}
        self.introduced: dict[str, list[Proposal]] = {}

    def gather(self) -> tuple[dict[str, Proposal], tuple[ScopeProposal, ...]]:
        """Return the first meaning of each letter, and scopes for those it gets later."""
        for number, line in enumerate(self.lines, 1):
            if len(line) <= _LONGEST_LINE:
                self._named_in(line, number)
        self._named_by_sections()
        self._named_by_formulas()
        self._named_by_use()
        self._named_by_shape()
        self._without_mass()
        meanings, scopes = {}, []
        for letter in self.letters:
            if proposals := self._in_order(letter):
                meanings[letter] = proposals[0]
                scopes += self._scopes(proposals)
        return meanings, tuple(scopes)

    def _add(self, letter: str, meaning: str, line: int, words: str = "") -> None:
        self.introduced.setdefault(letter, []).append(
            Proposal(letter, self._moving(letter, meaning), line, words)
        )

    def _moving(self, letter: str, meaning: str) -> str:
        """Return the displacement for a "stroke" that is differentiated: a size has no velocity."""
        if meaning != "stroke":
            return meaning
        sign = "|".join(map(re.escape, _spellings(letter)))
        differentiated = re.compile(rf"d(?:\^\{{?2\}}?|²)?\s*(?:{sign})\s*\}}?\s*(?:/|\{{)\s*d\s*t")
        return FROM_TOP if any(map(differentiated.search, self.lines)) else meaning

    def _named_in(self, line: str, number: int) -> None:
        """Add the letters that a line of prose names by a phrase, the closest pairs first."""
        found = list(roles_named(line))
        if found and self.spelling is not None:
            places = [(m.span(1), self.letter_of[m[1]]) for m in self.spelling.finditer(line)]
            pairs = [
                (_distance(line, role, place), place[0] < role.start, place, role, letter)
                for place, letter in places
                for role in found
                if role.may_name(letter)
                and _gap_is_naming(line, role.start, role.end, *place)
                and not (role.role == RATIO and _is_in_quotient(line, *place))
            ]
            spent: set[object] = set()
            for _, _, place, role, letter in sorted(pairs, key=lambda pair: pair[:3]):
                if role not in spent and (letter, number) not in spent and not _is_asked(line, role):
                    spent |= {role, (letter, number)}
                    meaning = (
                        self._convention(letter, role.phrase, line[role.end :])
                        if role.role == RATIO
                        else role.role
                    )
                    words = _quotation(line, role.start, role.end)
                    self._add(letter, meaning, number, words)
                    if role.role in UNITS and place[0] >= role.end:
                        for other in _listed_after(line, place[1], places):
                            self._add(other, role.role, number, words)
            self._named_for_the_next_line(line, number, [role for role in found if role not in spent])
        for match in _COUNTED.finditer(line):
            if match[1] in self.letters:
                self._add(match[1], "integer", number, match[0].strip("$"))

    def _named_for_the_next_line(self, line: str, number: int, roles: Sequence[NamedRole]) -> None:
        """Add the letter on the left of the next line for "the displacement is:" and the like.

        Of the line's roles those that have no letter yet: "position, with θ the crank angle:".
        """
        after = re.search(
            r"(?:は|[:：]|\b(?:is|are|ist|gilt|lautet))\s*(?:以下の通りと(?:なる|する))?[。.]?\s*$", line
        )
        follows = next(
            (n for n in range(number, min(number + 2, len(self.lines))) if self.lines[n].strip()), None
        )
        if after is None or follows is None or any(sign in line for sign in "=≈"):
            return
        letter = self._letter_alone_on_the_left(self.lines[follows])
        roles = [role for role in roles if role.end <= after.start() and role.may_name(letter)]
        usual = [role for role in roles if USUAL["crank"].get(letter) == role.role]
        named = (usual or roles)[-1:]  # of "velocity and acceleration:" v is the velocity
        if letter and named and not self.introduced.get(letter) and named[0].role != RATIO:
            self._add(letter, named[0].role, number, _quotation(line, named[0].start, named[0].end))

    def _letter_alone_on_the_left(self, line: str) -> str:
        match = _LEFT_ALONE.match(line.strip().lstrip("$&").strip())
        return self.letter_of.get(match[1], "") if match else ""

    def _named_by_sections(self) -> None:
        """Add what a heading says of the first letter that is derived below it."""
        role, words, begun = "", "", 0
        seen: set[str] = set()
        for number, line in enumerate(self.lines, 1):
            if _is_heading(self.lines, number):
                is_of_many = order_in(line) or _OF_MANY.search(line)
                role = "" if is_of_many else _moving_role(line)
                words, begun = line.strip(), number
                continue
            letter = self._letter_alone_on_the_left(line)
            if not letter:
                continue
            is_motion = re.search(r"cos|sin|\\frac\s*\{\s*d|d[²^]?2?\s*[a-z]\s*/\s*d", line) is not None
            is_new = not any(p.line <= number for p in self.introduced.get(letter, ()))
            if role and is_motion and letter not in seen and is_new and begun:
                self._add(letter, role, number, words)
                role = ""
            seen.add(letter)

    def _named_by_formulas(self) -> None:
        """Add a ratio of two lengths that are known, and ω with n where ω = π n/30."""
        for letter in self.letters:
            if letter not in self.introduced and (ratio := self._ratio_written(letter)):
                convention, number = ratio
                if convention in CONVENTIONS:
                    words = self.lines[number - 1].strip()
                    self._add(letter, CONVENTIONS[convention], number, _short(words))
        for chain in self.page.chains:
            for left, right in zip(chain.sides, chain.sides[1:], strict=False):
                source = self.page.source(right.span)
                is_speed = re.search(r"π|\\pi", source) and "30" in source and isinstance(left.node, Name)
                if is_speed and isinstance(left.node, Name) and len(names(right.node)) == 1:
                    (speed,) = names(right.node)
                    for letter, meaning in (
                        (left.node.name, "angular speed"),
                        (speed, "engine speed rpm"),
                    ):
                        if letter in self.letters and letter not in self.introduced:
                            self._add(letter, meaning, chain.lines[0], _short(source))

    def _ratio_written(self, letter: str) -> tuple[str, int] | None:
        """Return of which lengths a page says a letter is the ratio, "l/s", and on which line."""
        sign = "|".join(map(re.escape, _spellings(letter)))
        written = re.compile(
            rf"(?<![A-Za-z\\])(?:{sign})\s*\$?\s*[:：=]\s*\$?\s*(?:\\[td]?frac\s*\{{?\s*([A-Za-z])\s*\}}?\s*\{{?\s*([A-Za-z])\b"
            r"|([A-Za-z])\s*/\s*([A-Za-z])(?![A-Za-z0-9(]))"
        )
        for number, line in enumerate(self.lines, 1):
            if match := written.search(line):
                above, below = match[1] or match[3], match[2] or match[4]
                return f"{self._length(above)}/{self._length(below)}", number
        for chain in self.page.chains:  # behind macros, in HTML, in full-width letters
            head, *others = chain.sides
            value = others[0].node if others else None
            if head.node == Name(letter) and isinstance(value, Quotient):
                above, below = value.numerator, value.denominator
                if isinstance(above, Name) and isinstance(below, Name):
                    return f"{self._length(above.name)}/{self._length(below.name)}", chain.lines[0]
        return None

    def _multiplies_second_order(self, letter: str) -> bool:
        """Tell whether a ratio stands above the cosine of twice an angle: r/l does, l/r below it."""
        powers = [
            _power_of(part, letter)
            for chain in self.page.chains
            for side in chain.sides
            for part in walk(side.node)
            if isinstance(part, Product | Quotient) and _is_of_second_order(part)
        ]
        return sum(power > 0 for power in powers) > sum(power < 0 for power in powers)

    def _has_value_below_one(self, letter: str) -> bool:
        """Tell whether a page gives a letter a value below one: then it is r/l, a rod being longer."""
        for chain in self.page.chains:
            for left, right in zip(chain.sides, chain.sides[1:], strict=False):
                if left.node == Name(letter):
                    value = _plain_number(right.node)
                    return value is not None and 0 < value < 1
        return False

    def _length(self, letter: str) -> str:
        """Return r, l or s for a letter that is said to be the radius, the rod or the stroke."""
        short = {"crank radius": "r", "rod length": "l", "stroke": "s"}
        said = [short[p.meaning] for p in self.introduced.get(letter, ()) if p.meaning in short]
        usual = {"r": "r", "R": "r", "l": "l", "L": "l", "s": "s", "S": "s"}
        return (said or [usual.get(letter, "?")])[0]

    def _convention(self, letter: str, phrase: str, behind: str) -> str:
        """Return which ratio is meant by a "rod ratio": as what stands behind says, or a formula."""
        if quotient := _QUOTIENT_BEHIND.match(behind):
            named = f"{self._length(quotient[1])}/{self._length(quotient[2])}"
            if named in CONVENTIONS:
                return CONVENTIONS[named]
        ratio = self._ratio_written(letter)
        if ratio and ratio[0] in CONVENTIONS:
            return CONVENTIONS[ratio[0]]
        return "crank ratio r/l" if phrase in GERMAN_RATIO else "rod ratio l/r"

    def _named_by_use(self) -> None:
        """Add what a letter usually means, where no word says it: of θ, ω, t, β and the ratio alone."""
        named = (role for line in self.lines for role in roles_named(line[:_LONGEST_LINE]))
        sizes = {role.role for role in named if not role.is_part}
        has_stroke = "stroke" in sizes and not {"crank radius"} & sizes and "r" not in self.letters
        ratio = "rod ratio l/s" if has_stroke else "rod ratio l/r"
        is_below_one = self._multiplies_second_order("lambda") or self._has_value_below_one("lambda")
        if ratio == "rod ratio l/r" and is_below_one:
            ratio = "crank ratio r/l"
        usual = {"theta": "crank angle", "lambda": ratio, "rho": "crank ratio r/l"}
        usual |= {name: USUAL["crank"][plain_letter(name)] for name in ("omega", "t", "beta")}
        if "theta" not in self.letters:
            usual |= {"phi": "crank angle", "varphi": "crank angle"}
        known = {p.meaning for each in self.introduced.values() for p in each}
        for letter, meaning in usual.items():
            has_role = any(p.meaning in KNOWN for p in self.introduced.get(letter, ()))
            if letter in self.letters and not has_role and meaning not in known:
                self._add(letter, meaning, self.letters[letter])

    def _named_by_shape(self) -> None:
        """Add a slider-crank's usual letters, where the page is of one, and letters by their formulas.

        A page is of one if it has a crank angle, and an angular speed or a ratio of its lengths.
        """
        role_of = {p.letter: p.meaning for each in self.introduced.values() for p in each}
        roles = set(role_of.values())
        is_of_crank = "crank angle" in roles and roles & {"angular speed", *CONVENTIONS.values()}
        if not is_of_crank:
            return
        sources = [self.page.source(side.span) for chain in self.page.chains for side in chain.sides]
        squared = [source for source in sources if _SQUARED_SPEED.search(source)]
        masses = [name for name in ("m", "M") if any(_has_letter(source, name) for source in squared)]
        usual = {"l": "rod length", "r": "crank radius", "s": "stroke"}
        if "stroke" in roles or ("r" not in self.letters and "s" in self.letters):
            usual.pop("r")
        elif "r" in self.letters:
            usual.pop("s")
        usual |= dict.fromkeys(masses[:1], "reciprocating mass")
        for letter, meaning in usual.items():
            if letter in self.letters and letter not in self.introduced and meaning not in roles:
                self._add(letter, meaning, self.letters[letter])
        for chain in self.page.chains:
            head = chain.sides[0].node
            if not isinstance(head, Name) or head.name not in self.letters or len(chain.sides) < 2:
                continue
            last = chain.sides[-1]
            roles_there = {role_of.get(n) or usual.get(n) for n in names(last.node)}
            if not roles_there <= _SIZES:
                continue
            meaning = _motion_of(self.page.source(last.span), masses)
            known = {p.meaning for each in self.introduced.values() for p in each}
            if meaning and head.name not in self.introduced and meaning not in known:
                self._add(head.name, meaning, self.letters[head.name])

    def _without_mass(self) -> None:
        """Leave an inertia force a force in newtons where no letter is the mass that it is of."""
        if any(p.meaning == "reciprocating mass" for each in self.introduced.values() for p in each):
            return
        for letter, proposals in self.introduced.items():
            self.introduced[letter] = [
                replace(p, meaning="N") if p.meaning == "inertia force" else p for p in proposals
            ]

    def _in_order(self, letter: str) -> list[Proposal]:
        """Return a letter's meanings by line, each once; a unit gives way to a role."""
        proposals = sorted(self.introduced.get(letter, ()), key=lambda p: p.line)
        roles = [p for p in proposals if p.meaning in KNOWN] or proposals[:1]
        changes = [p for k, p in enumerate(roles) if not k or p.meaning != roles[k - 1].meaning]
        return [
            p for k, p in enumerate(changes) if not k or _is_another(changes[k - 1].meaning, p.meaning)
        ]

    def _scopes(self, proposals: Sequence[Proposal]) -> Iterator[ScopeProposal]:
        """Yield a scope for each meaning after the first: to where the letter is introduced again."""
        for k, proposal in enumerate(proposals[1:], 1):
            first = _section_start(self.lines, proposal.line)
            last = proposals[k + 1].line - 1 if k + 1 < len(proposals) else len(self.lines)
            yield ScopeProposal(
                first, max(first, last), {proposal.letter: proposal.meaning}, (), proposal.words
            )


_SIZES = {
    "crank angle", "crank radius", "stroke", "rod length", "angular speed", "time", "reciprocating mass",
    "rod angle", *CONVENTIONS.values(),
}  # fmt: skip
"""What a formula of one piston's motion holds, and no other letter."""
_SQUARED_SPEED = re.compile(r"(?:\\omega|ω)\s*(?:\^\s*\{?\s*2|²)")
_SPEED = re.compile(r"(?:\\omega|ω)(?!\s*(?:\^|²|t))")
_FROM_ONE = re.compile(r"1\s*[-−–]\s*\\?cos")
_FIRST_ORDER = "(?:\\\\theta|\\\\varphi|\\\\phi|\\\\alpha|θ|φ|ϕ|α|ωt|ω t)"
_SINE = re.compile(rf"\\?sin\s*\(?\s*{_FIRST_ORDER}")
_COSINE = re.compile(rf"\\?cos\s*\(?\s*{_FIRST_ORDER}")
_SECOND = re.compile(r"(?:cos|sin)\s*\(?\s*2")


def _has_letter(source: str, name: str) -> bool:
    """Tell whether a formula as it is written holds a letter by itself."""
    return re.search(rf"(?<![A-Za-z\\]){name}(?![A-Za-z_0-9])", source) is not None


def _motion_of(source: str, masses: Collection[str]) -> str:
    """Return which motion of the piston a formula looks like, to its second order; "" if none.

    >>> _motion_of("r ω² (cos θ + λ cos 2θ)", ["m"]), _motion_of("m r ω² (cos θ + λ cos 2θ)", ["m"])
    ('piston acceleration', 'inertia force')
    """
    if _FROM_ONE.search(source) and not _SPEED.search(source) and not _SQUARED_SPEED.search(source):
        is_length = any(_has_letter(source, name) for name in "rls")
        return FROM_TOP if is_length else ""
    if not _SECOND.search(source):
        return ""
    if _SQUARED_SPEED.search(source) and _COSINE.search(source):
        has_mass = any(_has_letter(source, name) for name in masses)
        return "inertia force" if has_mass else "piston acceleration"
    return "piston velocity" if _SPEED.search(source) and _SINE.search(source) else ""


def _distance(line: str, role: NamedRole, place: tuple[int, int]) -> int:
    """Return how far a letter is from the phrase that names it; a colon between brings it nearer."""
    before = place[1] <= role.start
    gap = line[place[1] : role.start] if before else line[role.end : place[0]]
    return 2 * len(gap) - (1 if gap.strip()[:1] in (":", "=", "は", "を", "：") else 0)


_QUOTIENT_BEHIND = re.compile(
    r"[\s$(,:=]{0,6}(?:\\lambda\s*=\s*|λ\s*=\s*)?(?:\\[td]?frac\s*\{\s*)?([A-Za-z])\s*(?:/|\}\s*\{)\s*([A-Za-z])(?![A-Za-z])"
)


def _is_in_quotient(line: str, first: int, last: int) -> bool:
    """Tell whether a letter is a part of r/l: "the crank ratio r/l" names neither r nor l."""
    return re.match(r"\s*/\s*[^\W\d]", line[last:]) is not None or (
        re.search(r"[^\W\d](?:_\w)?\s*/\s*$", line[:first]) is not None
    )


def _is_asked(line: str, role: NamedRole) -> bool:
    """Tell whether a phrase is part of a condition: "where u is an integer" does not say that it is."""
    return role.role == "integer" and re.match(r"[^。]{0,4}場合", line[role.end :]) is not None


def _listed_after(line: str, end: int, places: Sequence[tuple[tuple[int, int], str]]) -> Iterator[str]:
    """Yield the letters of a list that goes on behind a letter: "distances r_1, r_2, r_3"."""
    for (first, last), letter in places:
        if first >= end:
            if not re.fullmatch(r"[\s$]*(?:[,、]|and|und|と)[\s$]*", line[end:first]):
                return
            end = last
            yield letter


def _is_another(one: str, other: str) -> bool:
    """Tell whether two meanings cannot be two words for one thing."""
    same = {"rod ratio l/r", "rod ratio l/s", "crank ratio r/l"}
    return one != other and not {one, other} <= same


def _moving_role(heading: str) -> str:
    """Return the motion that a heading is about."""
    low = heading.casefold()
    return next(
        (role for role, phrases in MOVING_SECTIONS.items() if any(p.casefold() in low for p in phrases)),
        "",
    )


def _spelling(letters: Iterable[str]) -> re.Pattern[str] | None:
    """Return a pattern of the letters as a line of prose may write them."""
    written = sorted({s for name in letters for s in _spellings(name)}, key=len, reverse=True)
    if not written:
        return None
    return re.compile(rf"(?<![A-Za-z\\])({'|'.join(map(re.escape, written))})(?![A-Za-z0-9_₀-₉'′])")


def _spellings(name: str) -> list[str]:
    """Return the ways to write a letter: θ, \\theta; m_1, m_{1}, m₁.

    >>> _spellings("m_1")
    ['m_1', 'm_{1}', 'm₁']
    """
    base, _, script = name.partition("_")
    bases = [GREEK_SIGN[base], f"\\{base}"] if base in GREEK_SIGN else [base]
    if not script:
        return bases
    raised = {plain: sign for sign, plain in LOWERED.items()}
    lowered = "".join(raised.get(sign, "?") for sign in script)
    scripts = [f"_{script}", f"_{{{script}}}", *([lowered] if "?" not in lowered else [])]
    return [b + s for b in bases for s in scripts]


def _quotation(line: str, start: int, end: int) -> str:
    """Return the words around a phrase, to show where a proposal is from."""
    return _short(line[max(0, start - 14) : end + 14].strip())


def _short(words: str) -> str:
    line = " ".join(words.split())
    return line if len(line) <= 60 else line[:59] + "…"


# Sections and what their headings claim


_ORDER = (
    re.compile(r"(?<![0-9])([0-9]{1,2}|[一二四六])\s*次"),
    re.compile(r"(?<![0-9.])([0-9]{1,2})(?:st|nd|rd|th)[- ]order", re.IGNORECASE),
    re.compile(r"\border\s+([0-9]{1,2})\b", re.IGNORECASE),
    re.compile(r"(?<![0-9.])([0-9]{1,2})\.\s*Ordnung"),
    re.compile(
        r"\b(first|second|fourth|sixth|erster?|zweiter?|vierter?|sechster?)[- ](?:order|Ordnung)",
        re.IGNORECASE,
    ),
)
_ORDINALS = {
    "first": 1, "second": 2, "fourth": 4, "sixth": 6, "erste": 1, "erster": 1, "zweite": 2, "zweiter": 2,
    "vierte": 4, "vierter": 4, "sechste": 6, "sechster": 6, "一": 1, "二": 2, "四": 4, "六": 6,
}  # fmt: skip
_OF_MANY = re.compile(
    r"合計|総和|各気筒|多気筒|\bsum\b|total|Summe|resultant|several cylinders", re.IGNORECASE
)
_COUPLE = re.compile(r"偶力|モーメント|couple|moment", re.IGNORECASE)
_FORCE = re.compile(r"慣性力|force|kraft|kräfte", re.IGNORECASE)
_LEFT_BANK = re.compile(r"左バンク|left bank|linke Bank|linke Zylinderreihe", re.IGNORECASE)
_RIGHT_BANK = re.compile(r"右バンク|right bank|rechte Bank|rechte Zylinderreihe", re.IGNORECASE)
_BOTH = re.compile(r"左右|both banks|beide", re.IGNORECASE)
_UP = re.compile(r"鉛直|垂直|vertical|senkrecht|vertikal", re.IGNORECASE)
_ACROSS = re.compile(r"水平|horizontal|lateral|waagerecht|waagrecht", re.IGNORECASE)
_ALONG = re.compile(r"ストローク方向|along the (?:stroke|axis|bank)|in Zylinderrichtung", re.IGNORECASE)
_HARMONIC = re.compile(r"\\?(?:cos|sin)\s*([0-9]{0,2})\s*(?:\\theta|\\varphi|\\phi|θ|φ|ϕ)")
_SHARE = re.compile(r"100\s*(?:とする|とすると|%)|as 100|taken as 100|gleich 100|=\s*100")


def order_in(heading: str) -> int | None:
    """Return the order a heading names.

    >>> order_in("6次慣性力"), order_in("Kräfte zweiter Ordnung"), order_in("The fourth-order force")
    (6, 2, 4)
    """
    for pattern in _ORDER:
        if match := pattern.search(heading):
            word = match[1].casefold()
            return _ORDINALS.get(word) or int(word)
    return None


class _Sections:
    """Goes down a page and binds what stands below a heading that names an order."""

    def __init__(self, lines: Sequence[str], page: ReadNotes, engines: Engines) -> None:
        self.lines, self.page = lines, page
        self.engines = sorted(engines.mentions("\n".join(lines)))
        self.offsets = [0]
        for line in lines:
            self.offsets.append(self.offsets[-1] + len(line) + 1)
        self.heads = [n for n in range(1, len(lines) + 1) if _is_heading(lines, n)]
        self.subjects = {
            head: name for place, name in self.engines if (head := self._line_of(place)) in self.heads
        }
        self.order: int | None = None
        self.quantity, self.bank, self.direction, self.head, self.begun = "", 0, "", "", 0

    def bindings(self, meanings: Mapping[str, Proposal]) -> Iterator[BindProposal]:
        """Yield what the lines below headings are proposed to claim."""
        chains = {chain.lines[0]: chain for chain in self.page.chains if not chain.inline}
        shares = any(_SHARE.search(line) for line in self.lines)
        for number, line in enumerate(self.lines, 1):
            if shares and (share := self._share(line, number)):
                yield share
            elif _is_heading(self.lines, number):
                self._enter(line, number)
            elif self.order is not None and number in chains:
                yield from self._of_chain(chains[number], meanings)
            elif self.order is not None and number <= self.begun + 2:
                yield from self._harmonic(line, number)

    def _engine_at(self, number: int) -> str:
        """Return the engine named last before a line."""
        offset = self.offsets[number]
        return next((name for place, name in reversed(self.engines) if place < offset), "")

    def _subject(self, number: int) -> str:
        """Return the engine that the headings above a line are about; the one named last if none is."""
        above = [head for head in self.subjects if head <= number]
        return self.subjects[max(above)] if above else self._engine_at(number)

    def _line_of(self, offset: int) -> int:
        return bisect_right(self.offsets, offset)

    def _enter(self, heading: str, number: int) -> None:
        """Take up what a heading says; one that names an order begins anew."""
        order = order_in(heading)
        if order is not None:
            self.order, self.bank, self.direction = order, 0, ""
            self.quantity = (
                "couple" if _COUPLE.search(heading) else "force" if _FORCE.search(heading) else ""
            )
            self.head, self.begun = heading.strip(), number
        if _BOTH.search(heading):
            self.bank, self.direction = 0, ""
        elif _LEFT_BANK.search(heading) or _RIGHT_BANK.search(heading):
            self.bank, self.direction = 1 if _LEFT_BANK.search(heading) else 2, "along"
        for pattern, direction in ((_UP, "vertical"), (_ACROSS, "lateral"), (_ALONG, "along")):
            if pattern.search(heading):
                self.direction = direction

    def _harmonic(self, line: str, number: int) -> Iterator[BindProposal]:
        """Yield the binding of "cos 2θ" in the sentence right below a heading of order 2."""
        match = _HARMONIC.search(line)
        if match and self.quantity and self.order and not any(sign in line for sign in "=≈"):
            keys = {"line": number, "text": match[0], "quantity": "harmonic", "order": self.order}
            yield BindProposal(keys, self.head)

    def _share(self, line: str, number: int) -> BindProposal | None:
        """Return the binding of a row "2次慣性力 12.46" of a list whose first order is 100."""
        match = re.fullmatch(r"\s*(\S.*?)[\s:：]+([0-9]+\.[0-9]+)\s*%?\s*", line)
        order, engine = order_in(match[1]) if match else None, self._engine_at(number)
        if match is None or order is None or order < 2 or not engine or not _FORCE.search(match[1]):
            return None
        sign = (
            "-" if order % 4 == 0 else ""
        )  # the amplitude of A_n cos nθ is listed; A_4, A_8, … are negative
        keys = {
            "line": number, "text": match[2], "quantity": "coefficient", "order": order, "engine": engine,
            "scale": f"{sign}100",
        }  # fmt: skip
        return BindProposal(keys, f"{line.strip()} ({engine})")

    def _of_chain(self, chain: Chain, meanings: Mapping[str, Proposal]) -> Iterator[BindProposal]:
        """Yield the bindings of a chain's first and last side that hold the order's harmonic."""
        engine, order = self._subject(chain.lines[0]), self.order
        direction = f".{self.direction}" if self.direction in ("vertical", "lateral") else ""
        if (
            not engine
            or not self.quantity
            or order is None
            or not (direction or self.direction == "along")
        ):
            return
        sides = [s for s in chain.sides if _holds_order(s.node, order)]
        lines = {self.page.line_of(side.span[0]): side.node for side in (*sides[:1], *sides[-1:])}
        for line, node in lines.items():
            in_units = {p.meaning for name in names(node) if (p := meanings.get(name))}
            is_force = bool(in_units & {"reciprocating mass", "angular speed"})
            keys: dict[str, str | int] = {
                "line": line, "quantity": f"{self.quantity}{direction}", "engine": engine, "order": order,
            }  # fmt: skip
            keys |= {"bank": self.bank} if self.bank else {}
            keys |= {} if is_force else {"unit": "F_n"}
            yield BindProposal(keys, self.head)


def _holds_order(node: Formula, order: int) -> bool:
    """Tell whether a formula holds a cosine or sine of `order` times a letter."""

    def is_multiple(part: Formula) -> bool:
        if isinstance(part, Product):
            numbers = [p for p in part.factors if isinstance(p, Number)]
            letters = [p for p in part.factors if isinstance(p, Name)]
            return any(n.value == order for n in numbers) and bool(letters)
        return order == 1 and isinstance(part, Name)

    calls = [part for part in walk(node) if isinstance(part, Call) and part.function in ("cos", "sin")]
    return any(is_multiple(inner) for call in calls for inner in walk(call.argument))


# Components of a force


_COMPONENT = re.compile(
    r"(?<![A-Za-z])([A-Za-z][A-Za-z0-9_]{0,4})\s*は\s*([A-Za-z][A-Za-z0-9_]{0,4}?)\s*の?\s*(水平|鉛直|垂直)方向の?成分"
    r"|\b([A-Za-z][A-Za-z0-9_]{0,4})\$?\s+(?:is|ist)\s+(?:the|die)\s+(horizontal|vertical|waagerechte|senkrechte|horizontale|"
    r"vertikale)\s+(?:component|part|Komponente)\s+(?:of|von)\s+\$?([A-Za-z][A-Za-z0-9_]{0,4})\b"
)


_IS = "(?:が|=|is|ist|beträgt)"


def _components(
    lines: Sequence[str], letters: Mapping[str, int], meanings: Mapping[str, Proposal]
) -> Iterator[ScopeProposal]:
    """Yield what a bank's components are, where a page names them and half its bank angle."""
    angle = next((p.letter for p in meanings.values() if p.meaning == "half the bank angle"), "")
    for number, line in enumerate(lines, 1):
        matches = list(_COMPONENT.finditer(line)) if angle and len(line) <= _LONGEST_LINE else []
        given = [text for match in matches if (text := _component(match, letters, plain_letter(angle)))]
        if not given:
            continue
        last = next(
            (n - 1 for n in range(number + 1, len(lines) + 1) if _is_heading(lines, n)), len(lines)
        )
        around = "\n".join(lines[number - 1 : min(number + 3, last)])
        signs = "|".join(map(re.escape, _spellings(angle)))
        said = re.search(rf"(?:{signs})\$?\s*{_IS}\s*([0-9]{{1,2}})\s*(?:度|°)", around)
        value = [f"{plain_letter(angle)} = {_in_pi(int(said[1]))}"] if said else []
        yield ScopeProposal(number, last, {}, (*value, *given), _short(matches[0][0]))


def _component(match: re.Match[str], letters: Mapping[str, int], angle: str) -> str:
    """Return `Lh = L sin α` for "Lh is the horizontal component of L", its axis α from the vertical."""
    part, whole, direction = match[1] or match[4], match[2] or match[6], match[3] or match[5]
    if part not in letters or whole not in letters or part == whole:
        return ""
    is_across = direction in ("水平", "horizontal", "waagerechte", "horizontale")
    return f"{part} = {whole} {'sin' if is_across else 'cos'} {angle}"


def _in_pi(degrees: int) -> str:
    turn = Fraction(degrees, 180)
    above = "π" if turn.numerator == 1 else f"{turn.numerator} π"
    return above if turn.denominator == 1 else f"{above}/{turn.denominator}"


def _is_heading(lines: Sequence[str], number: int) -> bool:
    """Tell whether a line (from 1) is a heading: marked as one, or short, alone and no sentence."""
    words = lines[number - 1].strip()
    if not words:
        return False
    if words.startswith(
        ("#", "\\section", "\\subsection", "\\subsubsection", "\\paragraph", "\\chapter")
    ):
        return True
    around = [lines[k].strip() if 0 <= k < len(lines) else "" for k in (number - 2, number)]
    if re.fullmatch(r"([=\-~^*])\1{2,}", around[1]):
        return True
    has_formula = any(sign in words for sign in "=≈$\\")
    return not any(around) and len(words) <= 40 and words[-1] not in "。.、,:：;" and not has_formula


def _section_start(lines: Sequence[str], number: int) -> int:
    """Return the line of the heading above a line; itself where there is none."""
    return next((n for n in range(number, 0, -1) if _is_heading(lines, n)), number)


def _plain_number(node: Formula) -> Fraction | None:
    """Return the value of a number or of a quotient of two numbers; none for any other formula."""
    if isinstance(node, Number):
        return Fraction(node.value)
    if isinstance(node, Quotient):
        above, below = _plain_number(node.numerator), _plain_number(node.denominator)
        return above / below if above is not None and below else None
    return None


def _power_of(node: Formula, letter: str) -> int:
    """Return the power of a letter in a product.

    >>> from symbalance.document.formula import number
    >>> _power_of(Quotient(Name("r"), Product((number(2), Name("k")))), "k")
    -1
    """
    match node:
        case Name():
            return int(node.name == letter)
        case Product():
            return sum(_power_of(factor, letter) for factor in node.factors)
        case Quotient():
            return _power_of(node.numerator, letter) - _power_of(node.denominator, letter)
        case Negative():
            return _power_of(node.operand, letter)
        case _:
            return 0


def _is_of_second_order(node: Formula) -> bool:
    """Tell whether one factor of a product is the cosine of twice a letter."""
    factors = node.factors if isinstance(node, Product) else (node,)
    for factor in factors:
        top = factor.numerator if isinstance(factor, Quotient) else factor
        for part in top.factors if isinstance(top, Product) else (top,):
            if isinstance(part, Call) and part.function == "cos" and _is_double(part.argument):
                return True
    return False


def _is_double(node: Formula) -> bool:
    if not isinstance(node, Product) or len(node.factors) != 2:
        return False
    return node.factors[0] == Number(Fraction(2)) and isinstance(node.factors[1], Name)
