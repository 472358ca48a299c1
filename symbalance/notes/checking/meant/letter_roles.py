"""Which letters of a page may stand for which roles of a standard formula.

By its declared meaning, else by the words right before it anywhere on the page, else as is usual for the
letter and its subscript: F_g is the force of the gas.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache, cached_property

from symbalance.document.formula import Formula, Name, names
from symbalance.document.letters import ACCENTS, plain_letter
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.meant.catalogue import OTHER_LENGTHS, ROLES
from symbalance.notes.checking.meant.nouns_of_several import nouns_of_several
from symbalance.notes.checking.meant.said_behind import (
    SaidBehind,
    all_said_behind,
    heads_of,
    shortest_head_of,
)
from symbalance.notes.checking.meant.symbols_listed import symbols_listed
from symbalance.text import lazy_patterns as re

UNITS_ONLY = re.compile(r"variable|positive|constant|[^\w]*|[A-Za-z°µ%/^*·0-9² ³⁴⁻¹-]{0,9}")
"""Declarations that say nothing of what a letter is."""
_NO_ROLE = frozenset(
    {"i", "a", "o", "m", "in", "out", "inner", "outer", "innen", "aussen", "außen", "mid"}
)
"""Subscripts of a diameter or a radius that is one of two."""
_OUTER, _INNER = (frozenset(text.split()) for text in ("a o e out outer", "i in inner innen"))
_OF_TWO = {"outer": (_OUTER, _INNER, "D d"), "inner": (_INNER, _OUTER, "d"),
           "outer_radius": (_OUTER, _INNER, "R r"), "inner_radius": (_INNER, _OUTER, "r")}  # fmt: skip
"""Subscripts of the two diameters of a hollow section; without one D is the larger, and d beside d_i."""
_WITH_NUMBER = re.compile(r"([A-Za-z]|[a-z]{2,8})([0-9])")
"""A letter with a number behind it, as a page without subscripts writes it: J1, omega0."""
_OF_WEIGHT = re.compile(
    r"counter-?\s?(?:weight|mass|balance)|balance\s+weight|gegengewicht|ausgleichs(?:masse|gewicht)|contre-?poids"
    r"|contrappes|contrapes|(?:釣り?合い?|つりあい)(?:おもり|錘|質量)|カウンタ",
    re.IGNORECASE,
)
_OF_CRANK = re.compile(
    r"crank(?:-?\s?pin)?\s+(?:radius|throw|length)|radius\s+of\s+the\s+crank|kurbelradius|kurbelhalbmesser|rayon\s+de"
    r"\s+(?:la\s+)?manivelle|raggio\s+d\w*\s*(?:la\s+)?manovella|radio\s+de\s+(?:la\s+)?manivela|クランク(?:の)?半径",
    re.IGNORECASE,
)
"""Whose radius a declared letter is: a counterweight's, the crank's."""
LONGEST_NAME = 48
"""Characters of the words before a letter that may name it."""
_GOES_ON = re.compile(r"\}?\s*(?:[A-Za-z0-9(+*/·^-]|\\(?:[a-z]+))(?<!\\approx)(?<!\\in)(?<!\\to)")
_ANGULAR = frozenset({"omega", "Omega"})
_ANGULAR_ROLES = frozenset({"omega", "omega_high", "omega_low"})
_TAGS = re.compile(r"<[^>]*>|\\(?:mathrm|text|it|rm|bf)\b|[${}()\\*_`|\[\]~]")
_LINKS = re.compile(
    r"(?:\s|,|:|=|\bof\b|\bthe\b|\bis\b|(?-i:\ba\b)|\bby\b|\bvon\b|\bist\b|\bder\b|\bdie\b|\bdes\b|\bmit\b"
    r"|\band\b|\bund\b|\b(?:per|je|pro|of\s(?:a|one|each))\s(?:cylinder|zylinder|piston|kolben|wheel)\b"
    r"|[をがはのと、])+$",
    re.I,
)
_IS = re.compile(
    r"\s*(?:be|is|denotes|being|sei|ist|bezeichnet)\s+(?:the|a|der|die|das)\s+"
    r"((?:[\w'’-]+ ){0,3}?[\w'’-]+)(?= of\b| der\b| des\b| at\b| am\b| and\b| und\b|[,.;]|\s*$)",
    re.I,
)
_LISTED = re.compile(r"[ \n]((?!and\b|und\b)[^\W\d_][\w-]{2,40}(?: [^\W\d_][\w-]{2,40})?)(?=[,.;(]|\s*$)")
"""Behind a letter in a list: m the mass, r crank radius, l rod length."""
_WITH = re.compile(r"\b(?:with|mit|where|wobei|and|und)\s$", re.I)
"""Behind a letter, and before it: with m the mass of the piston."""
_FOR = re.compile(
    r"\s*(?:for|für)\s+(?:the|die|den|das)\s+((?:[\w-]+ ){0,2}?[\w-]+)(?=,| and\b| und\b|[.;]|$)"
)
_WRITTEN = re.compile(r"\b(?:write|writing|put|with|mit|use|using|schreibe[n]?)\b[^.;]*$", re.I)
_ANOTHER = re.compile(r"(?<![^\W_])[^\W\d]\w{0,3} (?:for|für) (?:the|die|den|das) [^,;.]*$")
_APART = re.compile(r"\s*(?:apart|auseinander)\b")
"""Behind a letter, and before it: write β for the balance factor, λ for the crank ratio."""
"""What a letter is said to be behind it: d is the distance of the supports."""
_FROM_END = (
    r"(?:(?:from|to|vom?|von\s+de[rmn]|bis\s+zu[mr]?|de\s+la|du|de\s+l['’]|dalla?|del(?:la)?)\s+"
    r"(?:the\s+|de[rmn]\s+)?(?:cent(?:re|er)\s+of\s+(?:the\s+)?)?(?:{})(?![A-Za-z])"
    r"|(?:{})(?:の?中心|側)?から)"
)
_FIRST_OF_TWO = re.compile(
    r"((?:between (?:the )?|zwischen den )(?:radii|diameters|radien|halbmessern|durchmessern))"
    r" \\?\w{1,9} (?:and|und) $",
    re.I,
)
"""Between the words that name two lengths and the second of them: between the radii a and b."""
_WHOLE = {"outer": ("diameter", "inner"), "outer_radius": ("radius", "inner_radius")}
"""Of a hollow body the outer length is also just its diameter, if it is not called the inner one."""
_KINDS = {
    **dict.fromkeys(("first_inertia", "second_inertia", "own_inertia", "other_inertia"), "inertia"),
    **dict.fromkeys(("first_rate", "second_rate", "third_rate"), "stiffness"),
}
"""Roles of one of several, and the role that words give each of them: the flywheel J2."""
_EXTREMES = frozenset({"upper_stress", "lower_stress"})
_SWINGING = frozenset({"stress", "shearing", "force", "any_force", "torque", "bending", "excitation"})
"""What words call both values between which it swings: the stress σ_max, the stress σ_min."""
ROD_ENDS = {
    "to_big": _FROM_END.format(
        r"(?:big|large)[- ]end|crank[- ]?pin|großen\s+\w*(?:auge|kopf)|(?:kurbel|hub)zapfen",
        r"大端部?"
        r"|クランクピン",
    ),
    "to_small": _FROM_END.format(
        r"small[- ]end|(?:piston|gudgeon|wrist)[- ]?pin|kleinen\s+\w*(?:auge|kopf)|kolbenbolzen",
        r"小端部?|ピストンピン",
    ),
}
_CENTROID = re.compile(
    r"schwerpunkt|cent(?:re|er) (?:of|de) (?:gravity|mass|gravité|masse)|centroid|重心|baricentro"
    r"|centro de (?:gravedad|masas?|gravidade)|\bC\.?\s?G\b",
    re.IGNORECASE,
)
"""The point whose distance from an end of a rod says how its mass is shared."""
_BETWEEN_EYES = re.compile(
    r"(?:between|zwischen|entre|tra|fra)\s+(?:the\s+|its\s+|de[nr]\s+|les\s+|gli\s+|los\s+|le\s+|i\s+|\w+\s+){0,3}?"
    r"(?:eyes|(?:bore|bearing|eye|pin)\s+cent(?:re|er)s|(?:rod\s+)?ends|(?:pleuel|stangen|lager)?augen|augenmitten|œils|yeux"
    r"|alésages|occhi|piedi?\s+e\s+(?:la\s+)?testa|ojos)(?![^\W\d_])"
    r"|augenabstand|(?:pleuel)?stichmaß|entraxe\s+(?:de\s+(?:la\s+)?)?bielle|interasse\s+(?:della\s+)?biella"
    r"|(?:大端|小端)[^。、]{0,8}(?:大端|小端)[^。、]{0,6}距離|(?:両端|穴)(?:の)?(?:中心)?間(?:の)?距離",
    re.IGNORECASE,
)
"""What a rod's length is called by its ends: the distance between the eyes."""
_DISTANCE = re.compile(r"(?:distance|abstand|distanza|distancia)\s*$", re.IGNORECASE)
_IN_RADIANS = re.compile(r"rad\b|angular|winkelgeschw|angulaire|angolare|角速度", re.IGNORECASE)
"""An angular velocity at 6500 rpm is one."""
_TURNS_DECLARED = re.compile(r"\brpm\b|rev/|\br/min|U/min|1/min|min\^?\{?-1|min⁻¹|tr/min|giri/min")
"""In a declaration, the unit of a speed that counts turns: no angular speed has it."""
_RADIANS_DECLARED = re.compile(r"\brad\s?/\s?s\b|\brad(?:\s|\\,|·)*s\^?\{?(?:-1|⁻¹)")
"""In a declaration, the unit of a frequency that counts radians."""
_CRANK, _ROD = r"(?:crank|kurbel|クランク)", r"(?:\brod|pleuel|stange|連接棒|コンロッド|連桿)"
_OVER = (
    r"[\w\s]{0,24}?(?:\b(?:over|to|by|zu[mr]?|durch|à|sur|sobre|su|a|e|et|y|entre)\b|[/÷:と])"
    r"[\w\s]{0,24}?"
)
_CRANK_OVER_ROD = re.compile(
    rf"(?<![^\W\d_])r\s?/\s?(?:l|ell|L)(?![^\W\d_])|{_CRANK}{_OVER}{_ROD}", re.IGNORECASE
)
_ROD_OVER_CRANK = re.compile(
    rf"(?<![^\W\d_])(?:l|ell|L)\s?/\s?r(?![^\W\d_])|{_ROD}{_OVER}{_CRANK}", re.IGNORECASE
)
_QUOTIENT = re.compile(r"ratio|verhältnis|比|rapport|relación|rapporto|divided|geteilt|\bover\b|/")
"""A declaration of the crank radius over the rod's length, or of the rod's length over the radius."""
_END_BEHIND = {
    role: re.compile(rf"[^.;,、。\n]{{0,24}}?{words}", re.IGNORECASE) for role, words in ROD_ENDS.items()
}
_END_BEFORE = {
    role: re.compile(rf"{words}(?:(?!\b(?:and|und)\b|[.;,、\n=]).){{0,40}}$", re.IGNORECASE)
    for role, words in ROD_ENDS.items()
}
"""Which end of a rod a distance is taken from, behind its letter or before: a from the big end."""
_ARTICLE = r"(?:the|its|a|der|die|das|dem|den|des)"
_GREEK = (
    r"(?:alpha|beta|gamma|delta|epsilon|eta|(?:var)?theta|lambda|mu|nu|rho|sigma|tau"
    r"|(?:var)?phi|psi|omega)"
)
_APPOSED = re.compile(
    rf"\s*{_ARTICLE}\s+((?:[\w-]+ ){{0,5}}?[\w-]+)(?=\s*[,.;)]|\s+(?:and|und)\b|\s*$)", re.I
)
"""The same without a verb, as in a list: D is the damping ratio and η the frequency ratio."""
_NEXT_IN_LIST = re.compile(
    rf"(?:^|[\s(])(?:[^\W\d_]|{_GREEK})(?:_\w{{1,4}}|\d)?\s(?:is\s|being\s)?{_ARTICLE}\s[\w -]{{2,40}}"
    r"(?:,|\sand|\sund)\s*$"
)
"""Before a letter in a list, the item of the one before it: s the stroke, n the speed."""
_WHERE = re.compile(
    r"\s+(?:(?:up)?on|along|across|against|auf|längs|entlang|gegen)\s+(?:the\s+|de[rmns]\s+|die\s+)?"
    r"(?:[^\W\d_]{3,}[\s-])?[^\W\d_]{3,}$",
    re.I,
)
"""Where a force acts, behind its name: no letter of a force along the stroke is a stroke."""
_ADDED = re.compile(r"(?:,|\band|\bund)[\s(]*$", re.I)


@dataclass
class LetterRoles:
    """The roles that the letters of one page may have."""

    text: str
    piston_forces: set[str] = field(default_factory=set)
    """Letters that formulas elsewhere on the page show to be forces along the stroke."""
    taken: dict[str, str] = field(default_factory=dict)
    """The roles of letters that lines above showed to be a quantity."""
    _before: dict[str, list[str]] = field(default_factory=dict)
    _named: dict[str, tuple[frozenset[str], bool]] = field(default_factory=dict)

    def targets(
        self,
        formulas: tuple[Formula, ...],
        claim: Formula,
        meanings: Mapping[str, str],
        together: tuple[tuple[str, str], ...] = (),
        head: str = "",
    ) -> Iterator[Formula]:
        """Yield the formulas in the letters of a claim, each letter in a role that it may have.

        Roles that go together have letters of one subscript; "" is the letter that the claim is of.
        """
        for target, _ in self.readings(formulas, claim, meanings, together, head):
            yield target

    def readings(
        self,
        formulas: tuple[Formula, ...],
        claim: Formula,
        meanings: Mapping[str, str],
        together: tuple[tuple[str, str], ...] = (),
        head: str = "",
    ) -> Iterator[tuple[Formula, dict[str, str]]]:
        """Yield the formulas in the letters of a claim, as `targets`, and the letter of each role."""
        own = sorted(names(claim))
        for node in formulas:
            roles = sorted(names(node))
            if len(roles) != len(own):
                continue
            open_to = [[n for n in own if self.may_be(n, role, meanings)] for role in roles]
            for letters in _assignments(open_to):
                pairs = dict(zip(roles, letters, strict=True))
                if all(_is_of_one_index(pairs, head, *pair) for pair in together):
                    yield renamed(node, pairs), pairs

    def may_be(self, letter: str, role: str, meanings: Mapping[str, str]) -> bool:
        """Tell whether a letter may play a role: by its meaning, the words before it, or as is usual."""
        declared = meanings.get(letter, "")
        if declared and (by_words := _may_be_declared(declared, role)) is not None:
            return by_words
        roles, is_other = self._roles_named(letter)
        if self.taken.get(letter) == role:
            return True
        if role == "net_force" and letter in self.piston_forces and not roles & {"rod_force", "rod"}:
            return True
        if letter.partition("_")[0] in _ANGULAR and "frequency" in roles:
            roles = (roles | {"omega"}) - {"frequency"}  # a frequency ω counts radians
        is_extreme = role in _EXTREMES and bool(roles & _SWINGING) and _is_usual(letter, role)
        if is_extreme or _KINDS.get(role) in roles or _is_whole_size(roles, role):
            return True
        return role in roles if roles else not is_other and _is_usual(letter, role)

    def _roles_named(self, letter: str) -> tuple[frozenset[str], bool]:
        """Return the roles that words before a letter name, and whether they name another length."""
        if letter not in self._named:
            own = set(self.words_before(letter))
            before = {_without_place(words) for words in own - self._names_behind}
            roles = {
                name
                for name, each in ROLES.items()
                if any(ends_with(each.words, w) for w in before)
                or any(_is_noun_of(each.words, w) for w in own & self._names_behind)
            }
            if end := self._end_of_rod(letter):
                roles = (roles - {"near", "far"}) | {end}
            is_other = any(ends_with(OTHER_LENGTHS, w) for w in before)
            self._named[letter] = frozenset(roles), is_other
        return self._named[letter]

    def _end_of_rod(self, letter: str) -> str:
        """Return the role of a distance from one end of a rod, by the words beside it; "" for none."""
        ends = set()
        for match in re.finditer(rf"(?<![^\W_])(?<!\\){sign_of(letter)}", self.text):
            behind = _TAGS.sub("", self.text[match.end() : match.end() + 80])
            before = _TAGS.sub("", self.text[max(0, match.start() - 90) : match.start()])
            if before.rstrip(" ").endswith(("-", "+", "/", "·", "−")):
                continue  # b = l - a from the small end
            if _DISTANCE.search(before):
                behind = behind.replace(" of the ", " from the ")  # at the distance d of the big end
            own = {role for role, words in _END_BEHIND.items() if words.match(behind)}
            ends |= own or {role for role, words in _END_BEFORE.items() if words.search(before)}
        return ends.pop() if len(ends) == 1 else ""

    def is_multiplied(self, letter: str) -> bool:
        """Tell whether words name a multiple of a letter, a length 2l or a mass m/2: then a factor may be
        meant. A letter that words name by itself too, the crank radius r beside the stroke 2r, is that.
        """
        multiple = (
            rf"(?<=[^\W\d_]{{3}})(?<!angle)(?<!inkel)\s[\s$\\(]{{0,4}}\d{{1,9}}\s?{sign_of(letter)}"
        )
        part = rf"(?<=[^\W\d_]{{3}})\s[\s$\\(]{{0,4}}{sign_of(letter)}\s?/\s?[2-9]"
        is_named = bool(self._roles_named(letter)[0])
        if any(ROLES["diameter"].words.search(each) for each in self.words_before(letter)):
            part = part.removesuffix("[2-9]") + "[3-9]"  # D/2 of a diameter D is only the radius
        is_multiple = not is_named and re.search(multiple, self.text) is not None
        return is_multiple or re.search(part, self.text) is not None

    @cached_property
    def _said_behind(self) -> tuple[SaidBehind, ...]:
        text = self.text
        return *nouns_of_several(text), *symbols_listed(text), *all_said_behind(text)

    def said_behind(self, letter: str) -> Iterator[str]:
        """Yield what words behind a letter say that it is, whole and then without what qualifies it."""
        pattern = re.compile(sign_of(letter))
        for each in self._said_behind:
            if pattern.fullmatch(each.sign):
                yield from heads_of(each.words)

    @cached_property
    def _names_behind(self) -> frozenset[str]:
        """The names that stand behind letters: what their noun is counts, and not how they end."""
        return frozenset(self._name_behind.values())

    @cached_property
    def _name_behind(self) -> dict[int, str]:
        """By the place of a letter in the text: what is known of its name behind it, or its noun."""
        return {
            each.start: next(filter(_is_known, heads_of(each.words)), shortest_head_of(each.words))
            for each in self._said_behind
        }

    def words_before(self, letter: str) -> list[str]:
        """Return the few words before each place where a letter stands in the text, or what it is said
        to be behind it.
        """
        if letter not in self._before:
            pattern = rf"(?<![^\W_])(?<!\\){sign_of(letter)}"
            phrases = []
            for match in re.finditer(pattern, self.text):
                if _begins_formula(self.text, match.start(), match.end()):
                    continue  # the work $p V$: no word names p
                words = _TAGS.sub("", self.text[max(0, match.start() - 80) : match.start()])
                behind = _TAGS.sub("", self.text[match.end() : match.end() + 60])
                purpose = _FOR.match(behind)
                if purpose is not None and _WRITTEN.search(words):
                    phrases.append(purpose[1])
                    continue
                if _APART.match(behind):
                    phrases.append("apart")
                if _WRITTEN.search(words) and _ANOTHER.search(words):
                    continue  # λ for the crank ratio and F_0
                if (name := self._name_behind.get(match.start())) is not None:
                    phrases.append(name)
                    continue
                apposed = _APPOSED.match(behind) if _WITH.search(words) or _ADDED.search(words) else None
                listed = _LISTED.match(behind) if words.rstrip().endswith(",") else None
                follows = _IS.match(behind) or apposed or listed
                phrase = _LINKS.sub("", _FIRST_OF_TWO.sub(r"\1", words))
                is_in_list = _NEXT_IN_LIST.search(words) is not None
                if follows is None and is_in_list:
                    continue
                if ":" in words[len(phrase) :] and not _is_of_letter(phrase, letter):
                    continue
                if follows is not None:
                    phrases.append(_LINKS.sub("", follows[1]))
                if follows is None or not (
                    is_in_list or words.rstrip().endswith(",")
                ):  # in the rod, φ being
                    phrases.append(phrase[-LONGEST_NAME:])
            self._before[letter] = [words.replace("\n", " ") for words in phrases]
        return self._before[letter]


def _without_place(words: str) -> str:
    """Return the words before a letter without those that say where its force acts.

    >>> _without_place("the net force along the stroke"), _without_place("the length on a page")
    ('the net force', 'the length on a page')
    """
    shorter = _WHERE.sub("", words)
    return shorter if ends_with(ROLES["any_force"].words, shorter) else words


def _is_known(name: str) -> bool:
    """Tell whether a name is that of a role."""
    return any(_is_noun_of(role.words, name) for role in ROLES.values())


def _is_noun_of(words: re.Pattern[str], name: str) -> bool:
    """Tell whether a name ends with one of the words, which its noun begins or lies in.

    >>> [_is_noun_of(re.compile(words), "angle of the rod") for words in ("rod", "angle of the rod")]
    [False, True]
    """
    match = _at_end(words).search(name) if words.search(name) is not None else None
    return match is not None and match.start() < len(shortest_head_of(name))


def _is_whole_size(roles: frozenset[str], role: str) -> bool:
    """Tell whether words that name a diameter or radius let it be the outer one of two."""
    whole, inner = _WHOLE.get(role, ("", ""))
    return whole in roles and inner not in roles


def _begins_formula(text: str, start: int, end: int) -> bool:
    """Tell whether a letter is the first of a longer formula between dollars."""
    before = text[max(0, start - 4) : start].rstrip(" ")
    is_first = before.endswith("$") and not before.endswith("$$")
    return is_first and _GOES_ON.match(text, end) is not None


def _is_of_letter(phrase: str, letter: str) -> bool:
    """Tell whether words before a colon name what a letter usually is, and no diameter k."""
    stem = without_accent(letter).partition("_")[0]
    named = [each for each in ROLES.values() if ends_with(each.words, phrase)]
    return not named or any(stem in {n.partition("_")[0] for n in each.letters} for each in named)


def without_accent(letter: str) -> str:
    """Return a letter without the hat of an amplitude or the bar of a mean.

    >>> without_accent("hat_varphi"), without_accent("Delta_W")
    ('varphi', 'Delta_W')
    """
    return letter.removeprefix("hat_").removeprefix("bar_")


def index_of(letter: str) -> str:
    """Return the subscript of a letter, written below or behind it.

    >>> index_of("J_1"), index_of("J1"), index_of("hat_varphi")
    ('1', '1', '')
    """
    return _parts_of(letter)[1]


def stem_of(letter: str) -> str:
    """Return a letter without its subscript.

    >>> stem_of("J_1"), stem_of("J1"), stem_of("hat_varphi")
    ('J', 'J', 'varphi')
    """
    return _parts_of(letter)[0]


def _parts_of(letter: str) -> tuple[str, str]:
    """Return a letter without its subscript, and the subscript."""
    plain = without_accent(letter)
    stem, _, index = plain.partition("_")
    match = None if index else _WITH_NUMBER.fullmatch(plain)
    return (match[1], match[2]) if match is not None else (stem, index)


def sign_of(letter: str) -> str:
    """Return a pattern for a letter as a page may write it: \\omega_0, ω_{0}, \\hat\\varphi."""
    plain = without_accent(letter)
    if plain != letter:
        accents = "|".join(sign for sign, name in ACCENTS.items() if letter.startswith(f"{name}_"))
        return rf"\\(?:{accents})\s?\{{?\s?{sign_of(plain)}\}}?"
    stem, _, index = letter.partition("_")
    signs = {stem, plain_letter(stem), "\\" + stem}
    tail = rf"_?\{{?{re.escape(index)}\}}?" if index else r"(?!_)"
    return rf"(?:{'|'.join(map(re.escape, sorted(signs)))}){tail}(?![^\W\d_])"


def _may_be_declared(declared: str, role: str) -> bool | None:
    """Tell whether a declaration lets a letter play a role; None where it says nothing of what it is."""
    if told := _told_roles(declared):
        return role in told
    counts_turns = _TURNS_DECLARED.search(declared) and not _IN_RADIANS.search(declared)
    if role in _ANGULAR_ROLES and counts_turns:
        return False
    if roles := _roles_in(declared):
        if _RADIANS_DECLARED.search(declared) and "frequency" in roles:
            roles = (roles | {"omega"}) - {"frequency"}  # a natural frequency in rad/s
        return role in roles or _is_whole_size(roles, role)
    return None if UNITS_ONLY.fullmatch(declared) else False


@cache
def _told_roles(meaning: str) -> frozenset[str]:
    """Return the only roles that a declaration lets a letter have, where it says them in full.

    >>> sorted(_told_roles("r/l [-]")), sorted(_told_roles("rod length over crank radius"))
    (['ratio'], ['slender', 'slenderness'])
    >>> sorted(_told_roles("distance of the centre of gravity from the big end"))
    ['arm', 'to_big']
    """
    ends = {role for role, words in ROD_ENDS.items() if re.search(words, meaning, re.IGNORECASE)}
    if len(ends) == 1 and _CENTROID.search(meaning):
        return frozenset({*ends, "arm"})  # of a pendulum about that end, too
    if not _QUOTIENT.search(meaning.casefold()):
        return frozenset()
    is_of_crank = _CRANK_OVER_ROD.search(meaning) is not None
    is_of_rod = _ROD_OVER_CRANK.search(meaning) is not None
    if is_of_crank == is_of_rod:
        return frozenset()
    return frozenset({"ratio"} if is_of_crank else {"slender", "slenderness"})


@cache
def _roles_in(meaning: str) -> frozenset[str]:
    """Return the roles of which a declared meaning speaks.

    The radius of a counterweight is not that of the crank pin, whose radius is none of a counterweight.
    """
    roles = frozenset(name for name, role in ROLES.items() if role.words.search(meaning))
    if _BETWEEN_EYES.search(meaning):
        roles |= {"rod"}
    if _OF_WEIGHT.search(meaning):
        return roles - {"pin"}
    return roles - {"arm_of_weight"} if _OF_CRANK.search(meaning) else roles


def ends_with(words: re.Pattern[str], text: str) -> bool:
    """Tell whether a text ends with one of the words.

    >>> ends_with(re.compile("mass|masse"), "die Masse".lower())
    True
    """
    is_in_it = words.search(text) is not None  # else its other pattern is not even compiled
    return is_in_it and _at_end(words).search(text) is not None


@cache
def _at_end(words: re.Pattern[str]) -> re.Pattern[str]:
    return re.compile(rf"(?:{words.pattern})\Z", words.flags)


def renamed(node: Formula, letters: Mapping[str, str]) -> Formula:
    """Return a formula with its roles replaced by letters, all at once."""
    for role in letters:
        node = substitute(node, role, Name(f" {role}"))
    for role, letter in letters.items():
        node = substitute(node, f" {role}", Name(letter))
    return node


def _assignments(open_to: list[list[str]]) -> Iterator[tuple[str, ...]]:
    """Yield the ways to give each role a letter of its own."""
    if not open_to:
        yield ()
        return
    for letter in open_to[0]:
        rest = [[n for n in each if n != letter] for each in open_to[1:]]
        for others in _assignments(rest):
            yield (letter, *others)


def _is_of_one_index(pairs: Mapping[str, str], head: str, first: str, second: str) -> bool:
    """Tell whether two roles have letters of one subscript, if a formula has both."""
    if second not in pairs or (first and first not in pairs):
        return True
    index = index_of(pairs[first] if first else head)
    if not first and second == "arm_of_weight":  # of m_b the arm is r_b, where the other is r
        return index_of(pairs[second]) == index or index != index_of(pairs.get("pin", "")) or not index
    return index_of(pairs[second]) == index or (not first and index not in ("1", "2", "a", "b"))


def _is_usual(letter: str, role: str) -> bool:
    """Tell whether a letter of which no words say anything stands for a role on most pages."""
    stem, index = _parts_of(letter)
    letter = without_accent(letter)
    stem = letter if letter.startswith("Delta_") else stem
    if role in _OF_TWO:
        own, other, alone = _OF_TWO[role]
        return index in own or (stem in alone.split() and index not in other)
    if role in ("diameter", "radius", "crank") and index in _NO_ROLE:
        return False
    usual = ROLES[role]
    if index and letter in usual.letters:
        return True
    if index in usual.others or (usual.indices and index not in usual.indices):
        return False
    return stem.rstrip("'") in usual.letters
