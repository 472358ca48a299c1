"""Engines that a page's words name, as "the 270° twin", with the angles of their cranks.

Engines in line and boxers have a usual crankshaft; a twin's is told by its angle, a five's by its firing
order. An engine in banks, and one of which the words leave the cranks open, is named without them.
"""

from __future__ import annotations

from bisect import bisect_left
from cmath import rect
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import permutations
from math import cos, pi, sin

from symbalance.notes.checking.words.working_cycles import strokes_named
from symbalance.text import lazy_patterns as re

_NOTHING = 1e-9
_WORDS = {
    1: "single one ein mono mono einen un uno één jedno одно 単 単 1",
    2: "two twin twins zwei deux dos due dois twee två to dwu dvou dois двух bi 二 2",
    3: "three triple triples drei trois tres tre três drie trzy tří três tri трёх трех 三 3",
    4: "four vier quatre cuatro quattro quatro fyra fire cztero čtyř quadri tetra четырёх четырех 四 4",
    5: "five fünf cinq cinco cinque vijf fem pięcio pěti penta пяти 五 5",
    6: "six sechs seis sei zes sex sześcio šesti esa шести 六 6",
    7: "seven sieben sept siete sette sete zeven sju siedmio sedmi семи 七 7",
    8: "eight acht huit ocho otto oito åtta ośmio osmi восьми 八 8",
    9: "nine neun neuf nueve nove negen nio dziewięcio devíti девяти 九 9",
    10: "ten zehn dix diez 十 10",
    12: "twelve zwölf douze doce 十二 12",
    16: "sixteen sechzehn 16",
}
_COUNTS = {word: count for count, words in _WORDS.items() for word in words.split()}
_ANY = "|".join(sorted(_COUNTS, key=len, reverse=True))
_ONE_OF_MANY = (
    r"cylinder(?!s)|cyl(?!ind)|pot(?![a-z])|zylind(?:er|rig)|cilinder|cil[ií]ndr(?!os|i(?![a-zà-ü]))"
    r"|cylindre(?!s)"
    r"|cylindr(?:ow|ig)|válc|цилиндров|気筒|シリンダ"
)
_SEVERAL = r"cylinders|zylindern?|cylindres|cilindros|cilindri|cilinders|cylindrów|cylindrar|цилиндрами"
_GAP = r"(?:[^\w\n]|\n(?!\s*\n))+"
_MACHINE = rf"(?:engines?|motor\w*|moteurs?|machine|maschine|silnik|двигатель){_GAP}(?:\w+{_GAP}){{0,2}}?"
_MENTION = re.compile(
    rf"(?<![A-Za-z0-9.,])(?P<line>Reihen|B[oó]xer|Parallel)?[-\s]?(?P<count>{_ANY})(?:-\n|[-\s])?(?:{_ONE_OF_MANY})"
    rf"|(?<![A-Za-z])(?:une?|le|du|el|del|il|um|o)\s+(?P<latin>{_ANY})[-\s](?:cylindres|cilindros"
    rf"|cilindri)"
    rf"|{_MACHINE}(?P<many>{_ANY})[-\s]?(?:{_SEVERAL})"
    r"|(?<![A-Za-z])(?P<kind>in-?line|straight|flat|b[oó]xer|cross-?plane|flat-plane|reihen|直列|並列"
    r"|水平対向)"
    rf"[-\s]?(?P<behind>{_ANY}(?<!one))(?![0-9A-Za-z])(?![.,][0-9])"
    rf"|(?<![A-Za-z])(?P<row>{_ANY})[-\s](?:in[-\s]line(?:a\b)?|en\sl(?:igne|ínea)\b|em\slinha\b)"
    rf"|(?<![A-Za-z])(?<!\se\s)(?<!\set\s)(?<!\sy\s)(?<!und\s)(?<!and\s)(?<!ou\s)(?<!\so\s)(?P<lined>{_ANY})\s(?:{_SEVERAL})\s(?:in\sline[a]?|en\sl[ií](?:nea|gne)|em\slinha|in\sReihe)"
    r"|(?<![A-Za-z0-9_\\{$])(?P<code>[RIL])-?(?P<coded>[2-68])(?![0-9A-Za-z_}]|\s*[=^(*/]|[.,][0-9])"
    rf"|^[#=][^\n]{{0,60}}?(?<![A-Za-z])(?P<titled>{_ANY})[-\s](?:cylinders|pots|zylinder)(?![A-Za-z])"
    r"|^[ \t>*_#|-]{0,6}(?:the\s+)?(?P<label>three|four|five|six|eight)s?"
    r"(?=(?:\s+(?:180|120|90|72))?\W{0,3}[:|])"
    r"|(?<![A-Za-z])(?P<noun>twins?|triples?)(?![A-Za-z])"
    r"|(?<![A-Za-z])(?:an?|the|of|our|this|as|old|every)\s+(?:[a-z-]+\s)?(?P<bare>three|four|five|six"
    r"|eight|single)"
    r"(?=\s*(?:[.,:;)(!?*—–$]|\\\(|\n|$)|\s(?:has|have|is|shows|with|vibrates?|at|shakes?|produces|gives"
    r"|suffers|generates|again|runs|needs|turns?|fires?|by|and)\b)",
    re.IGNORECASE | re.MULTILINE,
)
_BANKS = re.compile(
    r"(?<![A-Za-z])(?:V|W|VR)(?:[-\s]?(?:[0-9]{1,2}(?![0-9])|型)|[-\s](?:engine|twin|motor|four|six|eight))"
    r"|(?<![A-Za-z])(?:banks?|narrow[- ]angle)\b|bankwinkel|[VＶ]-?(?:winkel|angle)"
    r"|gabel(?:winkel|motor)|gegenkolben"
    r"|opposed[\s-]piston"
    r"|バンク|[VＶ]型|en\s+V\b|a\s+V\b",
    re.IGNORECASE,
)
_RADIAL = re.compile(
    r"(?<![A-Za-z])radial|sternmotor|星[型形]|en\s+étoile|a\s+stella\b|stellar[ei]|en\s+estrella|em\s+estrela"
    r"|gwiazdow|hvězdicov|stjärnmotor|stermotor|звездообразн",
    re.IGNORECASE,
)
_IN_ROW = re.compile(r"in-?\s?line|straight|reihe|直列|in\s+linea|en\s+l[ií]|em\s+linha", re.IGNORECASE)
_HEAD = 400
"""Characters at the beginning of a page that say what it is about."""
_BOXER = re.compile(
    r"b[oó]xer|flat[-\s](?:twin|two|four|six|2|4|6)|(?<!horizontally )opposed|horizontally|水平対向"
    r"|à plat|gegenüberliegend|opuestos|contrapuestos|opposés|contrapposti|opostos|contrapostos"
    r"|przeciwsobn|protilehl|оппозит",
    re.IGNORECASE,
)
_ODD = re.compile(
    r"cross[\s-]?plane|クロスプレーン|T-?plane|big[\s-]?bang|uneven|odd[\s-]?fire|ungleichm|不等"
    r"|two[\s-]?plane"
    r"|rechtwinklig|right\s+angles?|直角",
    re.IGNORECASE,
)
_CROSSPLANE = re.compile(r"cross[\s-]?plane|クロスプレーン", re.IGNORECASE)
_FLAT = re.compile(
    r"flat[\s-](?:plane\s+)?crank|flat[\s-]plane|single[\s-]plane|ebene?n?\s+Kurbelwelle"
    r"|180\s*-?\s*(?:°|\^|deg)",
    re.IGNORECASE,
)
_ANGLE = re.compile(
    r"(?<![0-9.,])(?P<turn>90|180|270|360)(?![0-9.,])[\s~-]?\s*(?:°|º|&deg;|\^\s*\\?\{?\s*\\circ\}?|degrees?"
    r"|deg\b|Grad|度|gradi)"
    r"|\\ang\{(?P<ang>90|180|270|360)\}|(?<=twin )(?P<bare>90|180|270|360)(?=\s*[:,)]|\s*$)",
    re.IGNORECASE,
)
_LABEL = re.compile(
    r"^[ \t>*_#|-]{0,6}(?P<turn>180|270|360)\s?(?:°|º|\^\s*\\?\{?\s*\\circ\}?|-?degrees?|-?deg\b|度)",
    re.MULTILINE,
)
"""An angle that a paragraph or an item begins with, on a page about twins."""
_QUARTER = re.compile(
    r"(?<![0-9.])(?:90|270)(?![0-9])|right\s+angles?|crossplane|T-?plane|直角", re.IGNORECASE
)
"""Words by which a twin's cranks may stand neither together nor opposite to each other."""
_NEAR, _BESIDE = 40, 12
_FIRES = re.compile(
    r"fir(?:es?|ing)|ignit|zünd|allum|encend|accens|点火|爆発|着火|zapł|ontstek|interval|abst[aä]nd|720",
    re.IGNORECASE,
)
_CLAUSE = re.compile(r"[.;:!?]\s|[。；]|\n")
_AGAINST = re.compile(
    r"opposite\s+direction|anti-?phase|gegenläufig|逆位相|in\s+opposition", re.IGNORECASE
)
_TOGETHER = re.compile(
    r"up\s+and\s+down\s+together|rise\s+and\s+fall\s+together|side\s+by\s+side|in\s+step|gleichläufig"
    r"|同位相",
    re.IGNORECASE,
)
_COMPARED_WITH = re.compile(
    r"(?<![^\W\d_])(?:(?:un)?like|than|(?:that|those)\s+of|same\s+as|as\s+(?:in|for|with|of)|compared\s+(?:to|with)"
    r"|(?:in\s+contrast|contrary|opposed|similar(?:ly)?)\s+to|instead\s+of|unterschied\s+zu[mr]?|gegensatz\s+zu[mr]?"
    r"|anders\s+als|(?:wie|als)(?:\s+bei[m]?)?|verglichen\s+mit|vergleich\s+zu[mr]?|(?:die|das|der)jenige\s+de[rs]"
    r"|comme|(?:contrairement|rapport)\s+[àa]u?|celles?\s+d[eu'’]|(?:que|diferencia\s+de|contrario\s+di)"
    r"|quella\s+di|como|come)\s*"
    r"(?:(?:an?|the|any|every|einem|einer|eines|ein|dem|der|des|den|une?|le|la|el|il|dans|en|nel)[\s'’]+){0,2}"
    r"(?:(?!with\s)[^\W\d_]{2,12}[\s-])?$",
    re.IGNORECASE,
)
_COMPARED_BEHIND = re.compile(r"(?:エンジン|機関)?(?:と(?:同じ|違|異な)|に(?:比べ|対し)|とは?違|より)")
"""Words around an engine that is named only to compare another one with it."""
_SAID_OF_IT = re.compile(
    r"(?:[\s-]+(?:engines?|motors?|moteur|motore))?,?\s+(?:where|in\s+which|for\s+which|wo|bei\s+(?:dem|welchem)|où"
    r"|donde|en\s+el\s+(?:que|cual)|dove|in\s+cui|onde|em\s+que)(?![^\W\d_])[\s$`\\(]{1,4}(?=[^.;\n]{1,40}[=≈])",
    re.IGNORECASE,
)
"""Behind an engine that is only compared with, and whose formula follows: the four, where F = …"""
_SUPPOSED = re.compile(
    r"(?<![A-Za-z])(?:instead|would|wäre|würde|hätte|serait|aurait|sarebbe|sería)(?![A-Za-z])"
)
"""What makes a clause of an engine that is only thought of."""
_ORDER_LIST = re.compile(
    r"(?:firing\s+(?:order|sequence)|zündfolge|ordre\s+d.allumage|orden\s+de\s+encendido"
    r"|ordine\s+di\s+accensione"
    r"|点火順序|着火順序|fires?)[^0-9\n]{0,24}(?P<list>[1-9](?:\s?[-–—,→]\s?[1-9]){2,7})",
    re.IGNORECASE,
)
_BARE_LIST = re.compile(
    r"(?:cranks?|throws?|pins?|kröpfung(?:en)?|kurbeln)\s+(?:(?:are\s+)?at\s+"
    r"|bei\s+)?(?P<list>0(?:\s?[-–/]\s?[0-9]{1,3}){1,7})(?![0-9])",
    re.IGNORECASE,
)
_INLINE = {
    1: (0,),
    3: (0, 240, 120),
    4: (0, 180, 180, 0),
    6: (0, 240, 120, 120, 240, 0),
    8: (0, 180, 90, 270, 270, 90, 180, 0),
}
"""The usual cranks in line, in degrees; a twin's and a five's are told by more than the name."""
_OPPOSED = {2: (0, 0), 4: (0, 0, 180, 180), 6: (0, 0, 240, 240, 120, 120)}
"""Boxers: where each crank is, counted from its own cylinder's axis; the banks take turns."""
_OF_EACH = re.compile(r"(?:あたり|当たり|当り|ごと|毎|分の|の(?:往復|運動|質量|慣性))")
"""Words behind "one cylinder" by which it is no engine: the mass that goes with each of several."""
_FIVE, _FULL = 5, 360
_FEWEST_DEGREES = 45

_THIRD = re.compile(
    r"(?<![\d.,])(?:120|240)\s*\$?\s*(?:°|\^\s*\\?\{?\\circ|-?\s?degrees?|Grad|度)", re.IGNORECASE
)


@dataclass(frozen=True, slots=True)
class CrankStar:
    """Where an engine's cranks are, in degrees, and which way each cylinder points."""

    degrees: tuple[int | Fraction, ...]
    signs: tuple[int, ...] = ()
    """For opposed cylinders: which way each one's force counts."""
    banks: int = 0
    """The angle between two banks with a cylinder of each on every crank; 0 for one row."""
    is_radial: bool = False
    """Whether all cylinders stand at equal angles around one crank."""

    def force(self, order: int) -> float:
        """Return how many times one cylinder's amplitude of an order all of them give.

        Around one crank each force is two half vectors, which turn with the crank and against it.

        >>> [CrankStar((0,) * 3, is_radial=True).force(order) for order in (1, 2, 3, 4)]
        [1.5, 1.5, 0.0, 1.5]
        """
        if self.is_radial:
            count = len(self.degrees)
            return count / 2 if (order - 1) % count == 0 or (order + 1) % count == 0 else 0.0
        return self._size(order, [Fraction(1)] * len(self.degrees))

    def couple(self, order: int) -> float:
        """Return the amplitude of the couple of an order over a cylinder's amplitude and the pitch."""
        return 0.0 if self.is_radial else self._size(order, self._arms)

    @property
    def _arms(self) -> list[Fraction]:
        """How far each cylinder stands from the middle, in pitches."""
        count = len(self.degrees)
        return [Fraction(count - 1 - 2 * k, 2) for k in range(count)]

    def whole(self, order: int, *, is_couple: bool, degrees: tuple[int | Fraction, ...] = ()) -> complex:
        """Return the sum of the cylinders' phasors, of cranks that stand elsewhere if these are given."""
        star = replace(self, degrees=degrees) if degrees else self
        return star._whole(order, star._arms if is_couple else [Fraction(1)] * len(star.degrees))

    def _whole(self, order: int, arms: list[Fraction]) -> complex:
        """Return the sum of the cylinders' phasors of an order, each with its arm."""
        signs = self.signs or (1,) * len(self.degrees)
        parts = zip(signs, arms, self.degrees, strict=True)
        return sum((rect(float(s * a), order * pi * float(d) / 180) for s, a, d in parts), 0j)

    def _size(self, order: int, arms: list[Fraction]) -> float:
        size = abs(self._whole(order, arms))
        if self.banks:  # the larger of what two cylinders on a crank give along and across their middle
            half = self.banks * pi / 360
            size *= 2 * max(abs(f(half) * f(order * half)) for f in (cos, sin))
        return 0.0 if size < _NOTHING else size

    def waves(self, order: int, *, is_couple: bool) -> frozenset[str]:
        """Return which of cos nθ and sin nθ an order goes with, θ being the angle of any of the cranks.

        Empty where it goes with neither for one of them: the couple of two cranks at 90° lies between.

        >>> CrankStar((0, 180)).waves(1, is_couple=True)
        frozenset({'cos'})
        >>> CrankStar((45, 225)).waves(1, is_couple=True), CrankStar((0, 90)).waves(1, is_couple=True)
        (frozenset({'cos'}), frozenset())
        """
        if self.is_radial or self.banks:
            return frozenset()
        arms = self._arms if is_couple else [Fraction(1)] * len(self.degrees)
        waves: set[str] = set()
        for own in self.degrees:
            whole = self._whole(order, arms) * rect(1, -order * pi * float(own) / 180)
            if abs(whole) < _NOTHING or min(abs(whole.real), abs(whole.imag)) >= _NOTHING:
                return frozenset()
            waves.add("cos" if abs(whole.imag) < _NOTHING else "sin")
        return frozenset(waves)

    @property
    def text(self) -> str:
        """The angles for an assumption."""
        if self.is_radial:
            return f"{len(self.degrees)} equal angles around one crank"
        opposed = ", the cylinders opposed" if self.signs else ""
        opposed = f", two cylinders on each, {self.banks}° apart" if self.banks else opposed
        return ", ".join(f"{float(d):g}°" for d in self.degrees) + opposed


_FLAT_THREE = CrankStar((0, 180, 0))


@dataclass(frozen=True, slots=True)
class NamedEngine:
    """An engine that words name: its cylinders, its kind, and the cranks it may have."""

    place: int
    words: str
    cylinders: int
    is_boxer: bool = False
    has_banks: bool = False
    stars: tuple[CrankStar, ...] = ()
    """The cranks that the name leaves open; none where it says too little."""
    turn: int = 0
    """The angle between a twin's cranks where the name says it."""

    @property
    def key(self) -> tuple[int, bool, int]:
        """What tells two engines apart."""
        return self.cylinders, self.is_boxer, self.turn


@dataclass
class EnginesInWords:
    """The engines that one text names, in order."""

    text: str

    def __post_init__(self) -> None:
        named = [
            named
            for m in _MENTION.finditer(self.text)
            if (named := self._named(m)) and not self._is_compared_with(m)
        ]
        places = (m for words in (_BANKS, _RADIAL) for m in words.finditer(self.text))
        vees = [NamedEngine(m.start(), m[0], 0, has_banks=True) for m in places]
        if named and all(each.cylinders == 2 and not each.is_boxer for each in named):
            labels = (
                NamedEngine(m.start("turn"), "twin", 2, turn=int(m["turn"]))
                for m in _LABEL.finditer(self.text)
                if not any(each.place <= m.end() <= each.place + _NEAR for each in named)
            )
            named = sorted([*named, *labels], key=lambda engine: engine.place)
        self.mentions = named
        self.every = sorted([*named, *vees], key=lambda engine: engine.place)
        self._places = [named.place for named in self.mentions]
        self._all_places = [named.place for named in self.every]

    def between(self, first: int, last: int) -> list[NamedEngine]:
        """Return the engines that are named in a part of the text."""
        return self.mentions[bisect_left(self._places, first) : bisect_left(self._places, last)]

    def last_before(self, first: int, last: int) -> NamedEngine | None:
        """Return the engine that a part of the text names last, one with banks too; None for none."""
        place = bisect_left(self._all_places, last)
        return self.every[place - 1] if place and self._all_places[place - 1] >= first else None

    def has_banks(self, first: int, last: int) -> bool:
        """Tell whether a part of the text speaks of an engine whose cylinders are in banks."""
        return _BANKS.search(self.text, first, last) is not None

    def _is_compared_with(self, match: re.Match[str]) -> bool:
        """Tell whether an engine is named only to compare another with it: unlike the single cylinder."""
        if _SAID_OF_IT.match(self.text, match.end()):
            return False
        start = match.start() + len(match[0]) - len(match[0].lstrip())
        before = self.text[max(0, start - 60) : start].rpartition("\n\n")[2]
        is_behind = _COMPARED_BEHIND.match(self.text, match.end()) is not None
        return is_behind or _COMPARED_WITH.search(before) is not None

    def _named(self, match: re.Match[str]) -> NamedEngine | None:
        words = _count_in(match)
        start, end = match.span()
        near = self.text[max(0, start - 3) : end + 1]
        if _BANKS.search(self.text, max(0, start - 12), end):
            return None
        count = _COUNTS[words.lower()]
        if count == 1 and _OF_EACH.match(self.text, end):
            return None
        lines = self.text.rfind("\n", 0, start) + 1, self.text.find("\n", end)
        line = self.text[lines[0] : lines[1] if lines[1] >= 0 else len(self.text)]
        is_boxer = _BOXER.search(self.text, max(0, start - 30), min(len(self.text), end + 12)) is not None
        is_boxer = is_boxer or ("flat" in near.lower() and count in _OPPOSED)
        if (
            is_boxer
            and re.search(r"flat[\s-](?:plane|crank)", line, re.IGNORECASE)
            and "boxer" not in line.lower()
        ):
            is_boxer = False
        turn = self._turn_of_twin(start, end, lines[0]) if count == 2 else 0
        return NamedEngine(start, match[0].strip(), count, is_boxer, turn=turn)

    def _turn_of_twin(self, start: int, end: int, line_start: int) -> int:
        """Return the angle of a twin's cranks that stands right beside it, or near it on its line."""
        before = _turn_told(self.text[max(line_start, start - _BESIDE) : start])
        behind = _turn_told(self.text[end : end + 2 * _BESIDE])
        return before or behind or _turn_told(self.text[max(line_start, start - _NEAR) : end + _NEAR])

    def _is_radial(self, engine: NamedEngine, around: str) -> bool:
        """Tell whether an engine's cylinders stand around one pin, by the words near or by the title."""
        first, last = max(0, engine.place - _NEAR), engine.place + len(engine.words) + _BESIDE
        if engine.is_boxer or _IN_ROW.search(self.text, first, last):
            return False
        return _RADIAL.search(around) is not None or _RADIAL.search(self.text, 0, _HEAD) is not None

    def with_stars(
        self, engine: NamedEngine, first: int, last: int, heading: str, near: str
    ) -> NamedEngine:
        """Return an engine with the cranks that it may have, by the words of its section or page.

        A twin's angle may stand in the words `near` a formula alone, in a sentence or in a table's row:
        "in one with a 180° crank" speaks of another twin than the one that the page has named.
        """
        if self._is_radial(engine, f"{heading}\n{near}"):
            count = engine.cylinders if engine.cylinders % 2 else 0
            return replace(engine, stars=(CrankStar((0,) * count, is_radial=True),) if count > 1 else ())
        if engine.cylinders == 2 and (turn := _turn_told(near)):
            engine = replace(engine, turn=turn)
        heading, near = _lines_of(engine, heading), _without_suppositions(near)
        around = f"{heading}\n{_lines_of(engine, self.text[first:last])}"
        stars = _stars_of(engine, around)
        if (
            not stars
            and engine.cylinders == 2
            and not (_BANKS.search(self.text) or _RADIAL.search(self.text) or _QUARTER.search(self.text))
        ):
            stars = (CrankStar((0, 180)), CrankStar((0, 0)))
        is_told = _FLAT.search(f"{heading}\n{near}") is not None
        if stars == (_FLAT_THREE,) and not is_told:  # half a turn may be of another engine of the section
            is_usual = _THIRD.search(near) is not None  # its own sentence has cranks at 120°
            stars = (CrankStar(_INLINE[3]),) if is_usual else (CrankStar(_INLINE[3]), _FLAT_THREE)
        return replace(engine, stars=stars)


def names_count(count: int, words: str) -> bool:
    """Tell whether a number of cylinders stands in words, spelt out: "and four of them".

    >>> names_count(4, "for all four"), names_count(4, "times 4")
    (True, False)
    """
    spelt = "|".join(word for word in _WORDS.get(count, "").split() if not word.isdecimal())
    return bool(spelt) and re.search(rf"(?<![^\W\d_])(?:{spelt})", words, re.IGNORECASE) is not None


def engines_of_label(words: str) -> list[NamedEngine]:
    """Return the engines that a cell names, which may be called by their number alone: four, 180°.

    >>> [(engine.cylinders, engine.words) for engine in engines_of_label("six, 120°")]
    [(6, 'the six')]
    """
    return EnginesInWords(f"the {words.strip(' *_$')}").mentions


def _lines_of(engine: NamedEngine, text: str) -> str:
    """Return a text without the rows of a table that name other engines alone, and suppositions."""
    lines = list[str]()
    for line in text.splitlines():
        is_row = line.lstrip().startswith("|")
        counts = {_COUNTS[_count_in(m).lower()] for m in _MENTION.finditer(line)} if is_row else set()
        if not counts or engine.cylinders in counts:
            lines.append(_without_suppositions(line))
    return "\n".join(lines)


def _count_in(match: re.Match[str]) -> str:
    """Return the word for how many cylinders a mention has."""
    groups = (
        "count",
        "many",
        "behind",
        "coded",
        "noun",
        "bare",
        "row",
        "label",
        "latin",
        "titled",
        "lined",
    )
    return next(match[group] for group in groups if match[group])


def _without_suppositions(words: str) -> str:
    """Return words without the clauses that only suppose an engine: with other cranks it would …"""
    return "; ".join(clause for clause in words.split(";") if not _SUPPOSED.search(clause))


def is_another_engine(before: NamedEngine, now: NamedEngine) -> bool:
    """Tell whether two mentions are of two engines: other cylinders or banks, another twin's crank."""
    is_other_twin = bool(before.turn and now.turn and before.turn != now.turn)
    is_other_kind = before.is_boxer != now.is_boxer or before.has_banks != now.has_banks
    return before.cylinders != now.cylinders or is_other_kind or is_other_twin


def _stars_of(engine: NamedEngine, around: str) -> tuple[CrankStar, ...]:
    count = engine.cylinders
    if engine.is_boxer:
        degrees = _OPPOSED.get(count)
        signs = tuple((-1) ** k for k in range(count))
        return () if degrees is None or _ODD.search(around) else (CrankStar(degrees, signs),)
    listed = {tuple(map(int, re.findall("[0-9]+", m["list"]))) for m in _BARE_LIST.finditer(around)}
    if (
        len(listed) == 1
        and len(degrees := next(iter(listed))) == count
        and max(degrees) >= _FEWEST_DEGREES
    ):
        return (CrankStar(degrees),)
    fired = _by_firing_order(around, count)
    return (fired,) if fired is not None else _usual_stars(engine, around)


def _usual_stars(engine: NamedEngine, around: str) -> tuple[CrankStar, ...]:
    """Return the cranks in line that an engine's name and the words around leave open."""
    count = engine.cylinders
    if count == 2:
        turn = engine.turn or _turn_told(around)
        turn = turn or (180 if _AGAINST.search(around) else 360 if _TOGETHER.search(around) else 0)
        return (CrankStar((0, turn % _FULL)),) if turn else ()
    is_flat = _FLAT.search(around) is not None
    if count == 4 and _CROSSPLANE.search(around) and not is_flat:
        return (CrankStar((0, 90, 270, 180)),)
    if _ODD.search(around) or (2 in strokes_named(around) and count > 3):
        return ()
    if count == _FIVE:
        return tuple(CrankStar((0, *(72 * k for k in way))) for way in permutations(range(1, _FIVE)))
    if count == 3 and is_flat:
        return (_FLAT_THREE,)
    degrees = _INLINE.get(count)
    return () if degrees is None else (CrankStar(degrees),)


def _turn_told(words: str) -> int:
    """Return the one angle between two cranks that words tell, 0 for none or several."""
    turns = set()
    for clause in _CLAUSE.split(words):
        if not _FIRES.search(clause):
            turns |= {int(m["turn"] or m["ang"] or m["bare"]) for m in _ANGLE.finditer(clause)}
    return turns.pop() if len(turns) == 1 else 0


def _by_firing_order(around: str, count: int) -> CrankStar | None:
    """Return the cranks of an engine in line that fires evenly in an order that the words list."""
    lists = {m["list"] for m in _ORDER_LIST.finditer(around)}
    orders = {tuple(int(d) for d in re.findall("[1-9]", each)) for each in lists}
    if len(orders) != 1 or _ODD.search(around):
        return None
    (order,) = orders
    if sorted(order) != list(range(1, count + 1)):
        return None
    cycle = _FULL if 2 in strokes_named(around) else 2 * _FULL
    fired = {cylinder: k * cycle // count for k, cylinder in enumerate(order)}
    return CrankStar(tuple(-fired[c] % _FULL for c in sorted(fired)))
