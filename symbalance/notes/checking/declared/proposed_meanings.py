"""Meanings that a page's words and formulas propose for letters: "r is the crank radius", λ = l/s."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
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
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.declared.letter_spellings import letter_pattern, letters_pattern, spellings
from symbalance.notes.checking.declared.page_headings import (
    LONGEST_LINE,
    is_heading,
    order_in,
    section_start,
    short_words,
    words_around,
)
from symbalance.notes.checking.declared.role_phrases import (
    CONVENTIONS,
    GERMAN_RATIO,
    MOVING_SECTIONS,
    RATIO,
    USUAL,
    NamedRole,
    ratio_in_words,
    roles_named,
)
from symbalance.notes.checking.declared.symbol_roles import FROM_TOP, KNOWN, UNITS
from symbalance.notes.reading.equations import ReadNotes
from symbalance.text import lazy_patterns as re

_LEFT_ALONE = re.compile(
    r"(?:^|[^A-Za-z0-9\\_{}^)\]])(?:\\displaystyle\s+)?(\\?[A-Za-zα-ωΑ-Ω][A-Za-z0-9]*(?:_\{?[A-Za-z0-9]+\}?)?)"
    r"\s*&?(?:=|≈|\\approx|\\fallingdotseq)"
)
_AFTER = re.compile(
    r"[\s$\\({\[（「]*(?:(?:\([^()]{0,20}\)|（[^（）]{0,20}）)[\s$\\({]*)?[:：=]?[\s$\\({]*"
    r"(?:(?:is|are|be|by|called|denoted|given|with|mit|ist|sei|heißt|bezeichnet|als|を|が|は)[\s$\\({]*){0,2}"
)
_BEFORE = re.compile(
    r"[\s$\\)}\]）」]*(?:(?:\([^()]{0,12}\)|（[^（）]{0,12}）)\s*)?"
    r"(?:[:：=]\s*(?:[lrs]/[lrs]\s*)?[\u3040-\u9fff]{0,8}"
    r"|(?:is|are|be|being|denotes?|means?|stands?\s+for|ist|sei|bezeichnet)\b|,\s*(?=the\b|der\b|die\b|das\b)"
    r"|は[^、。は]{0,14}|が[^、。は]{0,20}|を|…|\.{2,3}|[-–—])[\s$]*"
    r"(?:(?:the|a|an|der|die|das|den|its|one|half)\s+)?"
)
_APPOSED = re.compile(r"[\s$\\)}\]]*,\s*(?:the|der|die|das)\b")
_IS_SUBJECT = re.compile(
    r"[^,.;:=()$]{0,40}?\b(?:is|are|equals|becomes|ist|sind|wird|beträgt|lautet)\b", re.IGNORECASE
)
"""Behind a phrase that has a verb of its own, and is no apposition."""
_OF_LIST = re.compile(r"[\s$\\)]{1,4}(?:the|der|die|das|den)\s+")
_BARE = re.compile(r"\$ |\\\) ")
_LISTED = re.compile(r"(?:^|[,;:(]|\*)\s*(?:\$|\\\()\s*\\?$")
_LISTED_PLAIN = re.compile(r"(?:^|[,;:(])\s*$")
_LIST_GOES_ON = re.compile(r"\s*(?:[,;.)]|$)")
_COUNTED = re.compile(
    r"(?<![A-Za-z\\])\$?([NnkKzij])\$?"
    r"(?:気筒|次の?(?:慣性|成分|$)|[- ]cylinders?\b|[- ]?th\b| Zylinder|-te\b)"
)
_WIDEST_GAP = 40
"""Characters between a letter and the words that name it."""
_OF_MANY = re.compile(
    r"合計|総和|各気筒|多気筒|\bsum\b|total|Summe|resultant|several cylinders", re.IGNORECASE
)


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


def gap_is_naming(line: str, start: int, end: int, first: int, last: int) -> bool:
    """Tell whether what stands between a phrase (start, end) and a letter (first, last) names it."""
    if max(start - last, first - end) > _WIDEST_GAP:
        return False
    if end <= first:
        return _AFTER.fullmatch(line, end, first) is not None
    if last > start:
        return False
    if _APPOSED.match(line, last, start) and _IS_SUBJECT.match(line, end):
        return False  # "pushed with F, the torque is M": the words begin a clause, and name its letter
    # "R is the crank radius, L the length of the rod": of a list each but the first goes without "is"
    is_in_list = line[:first].rstrip(" $\\(").endswith((",", ";", "and", "und", "with", "where", "mit"))
    is_of_list = is_in_list and _OF_LIST.fullmatch(line, last, start) is not None
    return (
        is_of_list
        or _BEFORE.fullmatch(line, last, start) is not None
        or (
            line[last:start] == " "  # "r crank radius, l rod length"
            and line[first:last] not in ("a", "A", "I")
            and _LISTED_PLAIN.search(line[:first]) is not None
            and _LIST_GOES_ON.match(line, end) is not None
        )
        or (
            _BARE.fullmatch(line, last, start) is not None  # "$r$ crank radius, $l$ rod length"
            and _LISTED.search(line[:first]) is not None
            and _LIST_GOES_ON.match(line, end) is not None
        )
    )


class MeaningsFromWords:
    """Gathers the roles that a page's words give its letters."""

    def __init__(
        self,
        lines: Sequence[str],
        page: ReadNotes,
        letters: Mapping[str, int],
        names_at: Callable[[int], Collection[str]],
    ) -> None:
        self.lines, self.page, self.letters, self.names_at = lines, page, letters, names_at
        self.spelling = letters_pattern(letters)
        self.letter_of = {written: name for name in letters for written in spellings(name)}
        self.introduced: dict[str, list[Proposal]] = {}

    def gather(self) -> tuple[dict[str, Proposal], tuple[ScopeProposal, ...]]:
        """Return the first meaning of each letter, and scopes for those it gets later."""
        for number, line in enumerate(self.lines, 1):
            if len(line) <= LONGEST_LINE:
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
        sign = "|".join(map(re.escape, spellings(letter)))
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
                and gap_is_naming(line, role.start, role.end, *place)
                and not (role.role == RATIO and _is_in_quotient(line, *place))
                and not (role.role in UNITS and _begins_product(line, *place))
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
                    words = words_around(line, role.start, role.end)
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
            self._add(letter, named[0].role, number, words_around(line, named[0].start, named[0].end))

    def _letter_alone_on_the_left(self, line: str) -> str:
        match = _LEFT_ALONE.match(line.strip().lstrip("$&").strip())
        return self.letter_of.get(match[1], "") if match else ""

    def _named_by_sections(self) -> None:
        """Add what a heading says of the first letter that is derived below it."""
        role, words, begun = "", "", 0
        seen: set[str] = set()
        for number, line in enumerate(self.lines, 1):
            if is_heading(self.lines, number):
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
                    words = self._from_letter_on(letter, self.lines[number - 1].strip())
                    self._add(letter, CONVENTIONS[convention], number, short_words(words))
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
                            self._add(letter, meaning, chain.lines[0], short_words(source))

    def _from_letter_on(self, letter: str, line: str) -> str:
        """Return a line that is too long to be quoted from where it comes to a letter."""
        pattern = letter_pattern(letter)
        own = pattern.search(line) if pattern is not None and short_words(line) != line else None
        return line if own is None else line[own.start() :]

    def _ratio_written(self, letter: str) -> tuple[str, int] | None:
        """Return of which lengths a page says a letter is the ratio, "l/s", and on which line."""
        sign = "|".join(map(re.escape, spellings(letter)))
        written = re.compile(
            rf"(?<![A-Za-z\\_])(?:{sign})\s*\$?\s*[:：=]\s*\$?\s*(?:\\[td]?frac\s*\{{?\s*([A-Za-z])\s*\}}?\s*\{{?\s*([A-Za-z])\b"
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
        if (said := _BRACKET_BEHIND.match(behind)) and (named := ratio_in_words(said[1])):
            return named
        ratio = self._ratio_written(letter)
        if ratio and ratio[0] in CONVENTIONS:
            return CONVENTIONS[ratio[0]]
        is_below_one = phrase in GERMAN_RATIO or self._has_value_below_one(letter)
        return "crank ratio r/l" if is_below_one else "rod ratio l/r"

    def _named_by_use(self) -> None:
        """Add what a letter usually means, where no word says it: of θ, ω, t, β and the ratio alone."""
        named = (role for line in self.lines for role in roles_named(line[:LONGEST_LINE]))
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
            first = section_start(self.lines, proposal.line)
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


_BRACKET_BEHIND = re.compile(r"\s*\$?\s?\\?[^\W\d_]{1,10}\s?\$?\s*[(（]([^()（）]{4,60})[)）]")
"""What a bracket right behind a letter says of it: the rod ratio λ (crank radius over rod length)."""
_QUOTIENT_BEHIND = re.compile(
    r"[\s$(,:=]{0,6}(?:\\lambda\s*=\s*|λ\s*=\s*)?(?:\\[td]?frac\s*\{\s*)?([A-Za-z])\s*(?:/|\}\s*\{)\s*([A-Za-z])(?![A-Za-z])"
)


def _is_in_quotient(line: str, first: int, last: int) -> bool:
    """Tell whether a letter is a part of r/l: "the crank ratio r/l" names neither r nor l."""
    return re.match(r"\s*/\s*[^\W\d]", line[last:]) is not None or (
        re.search(r"[^\W\d](?:_\w)?\s*/\s*$", line[:first]) is not None
    )


_FACTOR_BEHIND = re.compile(
    r"[ ]?(?P<sign>\\cdot(?![a-z])|\\,|[*·])?[ ]?"
    r"(?:[A-Za-z](?![a-z])|\\(?:omega|lambda|theta|varphi|alpha)(?![a-z]))"
)


def _begins_product(line: str, first: int, last: int) -> bool:
    """Tell whether a letter is a product's first factor: of "the couple $F_1 a$" F_1 is no couple."""
    match = _FACTOR_BEHIND.match(line, last)
    is_formula = line[:first].count("$") % 2 == 1 or line[:first].rstrip().endswith("\\(")
    return match is not None and (is_formula or match["sign"] in ("*", "·"))


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
