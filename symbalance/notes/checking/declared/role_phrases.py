"""The phrases by which English, German and Japanese pages name what a letter stands for.

Each role of `symbol_roles` has the phrases that mean it, and so have the units of letters that play no
part in a slider-crank. `USUAL` holds the standard letter sets: what a letter stands for on most pages.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache

from symbalance.notes.checking.declared.symbol_roles import FROM_MIDDLE, FROM_PIN, FROM_TOP
from symbalance.text import lazy_patterns as re

RATIO = "rod ratio"
"""Not a role: which of l/r, l/s and r/l is meant, a page says by a formula."""

PHRASES: Mapping[str, tuple[str, ...]] = {
    "crank angle": (
        "crank has turned through the angle", "crank has turned through an angle",
        "crank turned through the angle", "crank turns through the angle",
        "crank has turned by the angle", "crank has turned by an angle",
        "crank angle", "crankshaft angle", "angle of the crankshaft", "angle of the crank",
        "angle of the first crank", "Winkel der Kurbel", "Winkel der ersten Kurbel", "クランクの角度",
        "angle of rotation of the crank", "crank turns at", "crank is at", "Kurbelwinkel",
        "Drehwinkel der Kurbel", "クランクシャフトの角度", "クランク軸の角度", "クランク角度",
        "クランク角", "クランク回転角", "クランクの回転角",
    ),
    "rod angle": (
        "connecting rod angle", "connecting-rod angle", "conrod angle", "rod angle",
        "angle of the connecting rod", "angle of the rod", "inclination of the rod", "Pleuelwinkel",
        "Schwenkwinkel", "Pleuelstangenwinkel", "Auslenkung der Pleuelstange", "コンロッドがなす角度",
        "コンロッドのなす角", "コンロッドの傾き", "コンロッド角", "連桿角", "連接棒の傾き",
        "連接棒の角度",
    ),
    "crank radius": (
        "crank radius", "radius of the crank", "crank of radius", "Kurbel mit dem Radius",
        "crank throw", "crank length", "throw of the crank", "Kurbelradius", "Kurbelhalbmesser",
        "クランク半径", "クランクの半径", "クランク長さ",
    ),
    "stroke": (
        "piston stroke", "stroke", "Kolbenhub", "Hub", "ピストンストローク", "ストローク", "行程",
    ),
    "rod length": (
        "connecting rod length", "connecting-rod length", "conrod length", "rod length",
        "length of the connecting rod", "length of the rod", "rod of length",
        "connecting rod of length", "length of the conrod", "Pleuellänge", "Länge der Pleuelstange",
        "Länge des Pleuels", "Pleuelstangenlänge", "Schubstangenlänge", "コンロッドの長さ",
        "コンロッド長さ", "コンロッド長", "連桿の長さ", "連桿長",
        "連接棒の長さ", "連接棒長さ", "連接棒長",
    ),
    RATIO: (
        "rod ratio", "rod-stroke ratio", "rod to crank ratio", "crank ratio", "ratio of crank to rod",
        "rod/crank ratio", "crank to rod ratio", "ratio of rod to crank", "Schubstangenverhältnis",
        "Pleuelstangenverhältnis", "Pleuelverhältnis", "連桿比",
    ),
    "angular speed": (
        "angular speed", "angular velocity", "angular frequency", "speed of rotation",
        "Winkelgeschwindigkeit", "Kreisfrequenz", "クランク回転角速度", "クランク角速度", "回転角速度",
        "角速度", "角振動数",
    ),
    "engine speed rpm": (
        "engine speed in rpm", "engine speed", "speed in rpm", "revolutions per minute",
        "Motordrehzahl", "Drehzahl", "エンジン回転数", "回転数", "回転速度",
    ),
    "time": ("time", "Zeit", "時刻", "時間"),
    "reciprocating mass": (
        "reciprocating mass", "oscillating mass", "reciprocating masses", "reciprocating weight",
        "mass of the piston", "piston mass", "oszillierende Masse", "oszillierenden Masse",
        "hin- und hergehende Masse", "Kolbenmasse", "往復質量", "往復部の質量", "往復部の重量",
        "往復部分の質量", "往復運動部の質量", "往復運動質量", "ピストン質量", "ピストンの質量",
    ),
    FROM_TOP: (
        "displacement from top dead centre", "displacement from top dead center",
        "displacement from the top", "distance from top dead centre", "distance from top dead center",
        "displacement of the piston from the top", "piston displacement", "displacement of the piston",
        "piston travel", "Kolbenweg", "Weg des Kolbens", "Kolbenverschiebung",
        "上死点からピストンピンまでの距離", "上死点からの変位", "上死点からの距離",
        "上死点からのピストン変位", "ピストン変位", "ピストンの変位",
    ),
    FROM_PIN: (
        "piston position", "position of the piston", "distance from the crank centre",
        "distance from the crank axis", "height of the piston pin", "Kolbenstellung", "Kolbenlage",
        "ピストンピンの位置", "ピストン位置", "ピストンの位置",
    ),
    FROM_MIDDLE: (
        "piston position from mid-stroke", "position of the piston from mid-stroke",
        "distance from mid-stroke", "ストローク中央を原点とするピストンの位置", "行程中央からの変位",
    ),
    "piston velocity": (
        "piston velocity", "piston speed", "velocity of the piston", "speed of the piston",
        "Kolbengeschwindigkeit", "Geschwindigkeit des Kolbens", "ピストンの速度", "ピストン速度",
    ),
    "piston acceleration": (
        "piston acceleration", "acceleration of the piston", "Kolbenbeschleunigung",
        "Beschleunigung des Kolbens", "ピストンの加速度", "ピストン加速度",
    ),
    "inertia force": (
        "inertia force", "inertial force", "force of inertia", "oscillating force", "Massenkraft",
        "oszillierende Massenkraft", "ピストンの往復運動に伴う慣性力", "往復慣性力", "慣性力",
    ),
    "cylinder pitch": (
        "cylinder pitch", "cylinder spacing", "bore pitch", "bore spacing",
        "distance between cylinders", "spacing of the cylinders", "Zylinderabstand", "ボアピッチ",
        "シリンダ間距離", "シリンダ中心間距離", "シリンダピッチ", "気筒間距離",
    ),
    "integer": (
        "number of cylinders", "whole number", "integer", "natural number", "Zylinderzahl",
        "Anzahl der Zylinder", "ganze Zahl", "気筒数", "整数",
    ),
    "half the bank angle": (
        "half the bank angle", "half bank angle", "halber V-Winkel", "バンク角の半分の角度",
        "バンク角の半分",
    ),
    "N": (
        "centrifugal force", "centripetal force", "force", "Fliehkraft", "Kraft", "遠心力", "求心力",
        "力",
    ),
    "N m": ("couple", "moment", "torque", "Moment", "Drehmoment", "モーメント", "偶力", "トルク"),
    "kg": ("counterweight mass", "balance mass", "mass", "Masse", "質量", "重量"),
    "m": ("distance", "radius", "Abstand", "Radius", "距離", "半径"),
    "rad": ("phase angle", "angle", "Winkel", "位相", "角度"),
}  # fmt: skip

MOVING_SECTIONS: Mapping[str, tuple[str, ...]] = {
    "piston acceleration": ("acceleration", "Beschleunigung", "加速度"),
    "piston velocity": ("velocity", "Geschwindigkeit", "速度"),
    "inertia force": ("慣性力", "inertia force", "Massenkraft"),
    FROM_TOP: ("displacement", "Kolbenweg", "変位"),
}
"""What a section is about by a word in its heading, where the letter it derives is not named in words.

The first that occurs counts: 加速度, acceleration, ends in 速度, velocity."""

PARTS = {
    "rod": "rod length", "con rod": "rod length", "conrod": "rod length",
    "connecting rod": "rod length", "connecting-rod": "rod length", "Pleuel": "rod length",
    "Pleuelstange": "rod length", "コンロッド": "rod length", "crank": "crank radius",
    "Kurbel": "crank radius",
}  # fmt: skip
"""Parts of the crank drive, which stand for their lengths before a letter for one: rod L = 160 mm."""
_TURNS_AT = "crank turns at"
_LETTERS_OF_SPEEDS = frozenset({"omega", "Omega", "ω", "Ω", "w", "n", "N"})
LETTERS_OF_LENGTHS = {"rod length": ("l", "L", "ell"), "crank radius": ("r", "R")}

CONVENTIONS = {"l/r": "rod ratio l/r", "l/s": "rod ratio l/s", "r/l": "crank ratio r/l"}
GERMAN_RATIO = ("Schubstangenverhältnis", "Pleuelstangenverhältnis", "Pleuelverhältnis")
"""Names of r/l where nothing else is said; of all others l/r is the usual reading."""

_GERMAN_ROD = r"(?:der )?(?:Pleuellänge|(?:Pleuel|Schub)stangenlänge)"
_JOINED = r"(?: ?/ ?| (?:over|on|to|and|by|divided by|et|[àaey]|sulla|sur la|sobre la|alla|à la|a la) )"
"""Between two lengths whose ratio is named, also where only the lengths' own names are in English."""
_RATIOS = (
    (rf"r/l|r over l|crank(?: radius| throw)?{_JOINED}(?:the )?"
     r"(?:length of the )?(?:con(?:necting[- ])?)?rod(?: length)?"
     rf"|Kurbelradius (?:zu|durch|/) {_GERMAN_ROD}", "crank ratio r/l"),
    (rf"l/r|l over r|rod(?: length)?{_JOINED}(?:the )?crank(?: radius| throw)?",
     "rod ratio l/r"),
)  # fmt: skip


def ratio_in_words(text: str) -> str:
    """Return which ratio of the crank's and the rod's lengths words spell out, "" where they do not.

    >>> ratio_in_words("(crank radius over rod length)"), ratio_in_words("rod ratio")
    ('crank ratio r/l', '')
    """
    ratios = (role for how, role in _RATIOS if re.search(rf"(?<!\w)(?:{how})(?!\w)", text, re.IGNORECASE))
    return next(ratios, "")


_COMMON = {
    "β": "rod angle", "r": "crank radius", "l": "rod length", "ω": "angular speed", "t": "time",
    "x": FROM_TOP, "v": "piston velocity", "a": "piston acceleration", "m": "reciprocating mass",
    "F": "inertia force",
}  # fmt: skip
USUAL: Mapping[str, Mapping[str, str]] = {
    "crank": {"θ": "crank angle", **_COMMON, "λ": "rod ratio l/r"},
    "crank r/l": {"θ": "crank angle", **_COMMON, "λ": "crank ratio r/l", "ρ": "crank ratio r/l"},
    "crank l/s": {"θ": "crank angle", **_COMMON, "s": "stroke", "λ": "rod ratio l/s"},
    "Kurbeltrieb": {"φ": "crank angle", **_COMMON, "s": "stroke", "λ": "crank ratio r/l"},
}
"""Standard letter sets, by the name a symbols file calls them: `letters = "crank"`."""


@dataclass(frozen=True, slots=True)
class NamedRole:
    """A phrase in a line: where it stands and the role that it names."""

    start: int
    end: int
    role: str
    phrase: str

    def may_name(self, letter: str) -> bool:
        """Tell whether the phrase may name a letter: a rod stands for its length before l or L alone."""
        if self.phrase.casefold() == _TURNS_AT and letter.strip("\\") in _LETTERS_OF_SPEEDS:
            return False  # "the crank turns at ω" gives its speed, "at θ" its place
        return not self.is_part or letter in LETTERS_OF_LENGTHS[self.role]

    @property
    def is_part(self) -> bool:
        """Whether the phrase names a part, the rod or the crank, and only before a letter its length."""
        return self.phrase.casefold() in _PARTS


_PARTS = frozenset(phrase.casefold() for phrase in PARTS)


_MEAN = re.compile(
    r"(?:(?<![A-Za-z])(?:mean|average|mittlere[rnms]?|durchschnittliche[rnms]?)[\s-]*|平均の?)$",
    re.IGNORECASE,
)


def roles_named(line: str) -> Iterator[NamedRole]:
    """Yield the roles that a line names, each by its longest phrase, from left to right.

    >>> [named.role for named in roles_named("Kurbelradius r, Pleuellänge l")]
    ['crank radius', 'rod length']
    >>> [named.role for named in roles_named("力 F、応力 σ、出力 P")]
    ['N']
    """
    pattern, roles = _pattern()
    for match in pattern.finditer(line):
        role = roles[match[0].casefold()]
        if role == "piston velocity" and _MEAN.search(line[max(match.start() - 20, 0) : match.start()]):
            continue  # of a whole stroke, and no velocity that turns with the crank
        yield NamedRole(match.start(), match.end(), role, match[0])


_NOT_BEHIND = "(?<![偶圧出動応能入馬電強])"
"""Characters before 力 that make no force of it: 応力 is a stress, 出力 a power."""


@cache
def _pattern() -> tuple[re.Pattern[str], dict[str, str]]:
    """Return one pattern of all phrases, the longest first; Latin ones are whole words, plurals too."""
    roles = {phrase.casefold(): role for phrase, role in PARTS.items()}
    roles |= {phrase.casefold(): role for role, phrases in PHRASES.items() for phrase in phrases}
    longest_first = sorted(roles, key=len, reverse=True)
    latin = [re.escape(phrase) for phrase in longest_first if phrase[0] < "\u2e80"]
    other = [re.escape(phrase) for phrase in longest_first if phrase[0] >= "\u2e80"]
    other = [f"{_NOT_BEHIND}{phrase}" if phrase == "力" else phrase for phrase in other]
    text = rf"(?<![A-Za-zäöüß])(?:{'|'.join(latin)})(?![A-Za-zäöüß])|{'|'.join(other)}"
    return re.compile(text, re.IGNORECASE), roles
