"""Two cylinders on one crank pin: forces along the line between the banks and across, in both orders.

A piston's force turns with the crank and against it, half of it each; what turns against it in one bank
meets that of the other at twice the angle between the banks.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from symbalance.document.formula import Call, Formula, Number
from symbalance.notes.checking.meant.catalogue.crank_drive import COS_CRANK, SIN_CRANK
from symbalance.notes.checking.meant.catalogue.roles import (
    PI,
    Quantity,
    bank,
    crank_angle,
    half_bank,
    letters,
    mass,
    omega,
    pin,
    ratio,
    reciprocating,
    rod,
    root,
    rotating,
    slender,
    words,
)
from symbalance.notes.checking.meant.catalogue.strength import both

V_WORDS = (
    r"\b[VL]-?(?:twins?|engines?|motor(?:en)?|2|two|pair|form)\b|(?<![A-Za-z])vee\b|V形|V型|\bbanks?\b"
    r"|Zweizylinder-V|V-Zweizylinder|V2-Motors?|Gabelmotor|bankwinkel|moteur en V|bicylindre en V"
    r"|motor en V|two cylinders at \d+\s?°|bank angle|degree V\b|°\s?V\b|° twin"
    r"|V-?winkel|V-angle|angle (?:du|of(?: the)?) V|angolo (?:del|della) V|ángulo de la V|V角|挟み角"
)
_MORE = (
    r"\bfour\b|\bsix\b|\beight\b|\bvier|\bsechs|\bacht|V-?(?:[4-9]|1[0-9])\b|W-?12|b[oó]xer|flat twin"
    r"|opposed|offset|counterweight|gegengewicht|after balanc|each cylinder|one cylinder|per cylinder"
    r"|single cylinder|cylinder alone|one bank|each bank"
    r"|(?:from|ab|von) (?:the |der )?(?:axis of |achse )?(?:the |des )?"
    r"(?:cylinder|left|right|first|ersten|linken|rechten|zylinders?)"
    r"|(?:to|from|against) the horizontal|gegen die (?:waag|horizont)|zur (?:waag|horizont)"
)
_FORCES = (
    r"(?:resultant|primary|secondary|first[- ]order|second[- ]order|inertia|unbalanced|shaking|total)"
)
_FORCE = rf"(?:\s+(?:of\s+(?:the\s+)?)?(?:{_FORCES}\s+)*forces?)?"
_LINE = (
    r"(?:bisector|bisecting line|line of symmetry|axis of symmetry|symmetry axis|symmetry line"
    r"|cent(?:re|er)[- ]?line"
    r"|middle line|line between the banks|V axis|axis of the V|plane of symmetry)(?: (?:of the"
    r"|between the)"
    r" (?:V|banks|vee|cylinders))?"
)
_SYMMETRY = (
    r"(?:the\s+|l['’]|la\s+|el\s+|['’])?(?:(?:axe|asse|shaft|axis|eje)\s+(?:of|de|di)\s+(?:symétrie|simmetria|simetría|symmetry)"
    r"|bissectrice|bisettrice|bisectriz)"
)
"""The line between the banks, in words of which the small ones stand in English."""
ALONG = words(
    rf"vertical(?:ly)?(?:\s+(?:component|part|resultant))?{_FORCE}", r"upright",
        rf"(?:{_FORCES}\s+)*forces?\s+vertical(?:ly)?",
    rf"(?:(?:{_FORCES}\s+)*(?:forces?|components?|parts?)\s+)?(?:along|in the direction of|parallel to"
    rf"|on|upon|in)"
    rf"\s+(?:the\s+)?{_LINE}",
    rf"components?\s+(?:along|in\s+the\s+direction\s+of)\s+(?:the\s+)?{_LINE}",
        r"(?:sum\s+)?project(?:ed|ion)\s+on(?:to)?\s+(?:the\s+)?(?:bisecting\s+line|bisector)",
    r"(?:in\s+richtung|längs)\s+der\s+(?:winkelhalbierenden|symmetrie(?:achse|linie|ebene))",
    r"(?:in|auf|entlang|längs)\s+der\s+(?:symmetrie(?:ebene|achse|linie)|winkelhalbierenden)",
    rf"(?:suivant|selon|dans|in|along|the\s+long\s+of|lungo|secondo|según|a\s+lo\s+largo\s+(?:de|of))\s+{_SYMMETRY}",
    r"対称軸(?:方向)?(?:の)?(?:一次慣性力|二次慣性力|成分)?",
    r"(?:鉛直|(?<!に)垂直)(?:方向)?(?:の)?(?:成分|分力|合力)?", r"二等分線方向(?:の成分)?",
)  # fmt: skip
ACROSS = words(
    rf"horizontal(?:ly)?(?:\s+(?:component|part|resultant))?{_FORCE}", r"transverse(?:ly)?",
        r"crosswise", r"sideways",
    rf"(?:(?:{_FORCES}\s+)*(?:forces?|components?|parts?)\s+)?(?:across|perpendicular\s+to|normal\s+to"
    rf"|at\s+right\s+angles\s+to)\s+(?:it\b|the\s+{_LINE})",
    rf"components?\s+at\s+right\s+angles\s+to\s+(?:the\s+)?{_LINE}",
        r"(?:sum\s+)?project(?:ed|ion)\s+at\s+right\s+angles\s+to\s+it",
    r"(?:quer|senkrecht)\s+(?:dazu|zur\s+(?:winkelhalbierenden|symmetrie(?:achse|linie|ebene)))",
    rf"(?:perpendic\w+|normale?(?:ment|mente)?)\s+(?:à|at|to|all?|a)\s*{_SYMMETRY}",
    r"perpendicular\s+to\s+(?:that|this)(?:\s+(?:plane|line|axis|direction))?",
        r"(?:これ|それ|対称軸)に(?:垂直|直角)な方向",
    r"水平(?:方向)?(?:の)?(?:成分|分力|合力)?",
)  # fmt: skip
_ONE = mass * pin * omega**2
_COS_TWICE, _SIN_TWICE = (Call(f, Number(Fraction(2)) * crank_angle) for f in ("cos", "sin"))
_HALF = bank / 2
_LETTERS = letters("F P R X Y H V S Q Z K C G")
_SECOND = (_ONE / slender, _ONE * ratio, _ONE * pin / rod)


def _cos(node: Formula) -> Formula:
    return Call("cos", node)


def _sin(node: Formula) -> Formula:
    return Call("sin", node)


def _along() -> Iterator[Formula]:
    yield 2 * _ONE * _cos(half_bank) ** 2 * COS_CRANK
    yield 2 * _ONE * _cos(_HALF) ** 2 * COS_CRANK
    yield _ONE * (1 + _cos(bank)) * COS_CRANK
    yield 2 * _ONE * _cos(half_bank) ** 2
    yield _ONE * (1 + _cos(bank))
    for size in _SECOND:
        yield 2 * size * _cos(half_bank) * _cos(2 * half_bank) * _COS_TWICE
        yield 2 * size * _cos(_HALF) * _cos(bank) * _COS_TWICE


def _across() -> Iterator[Formula]:
    yield 2 * _ONE * _sin(half_bank) ** 2 * SIN_CRANK
    yield 2 * _ONE * _sin(_HALF) ** 2 * SIN_CRANK
    yield _ONE * (1 - _cos(bank)) * SIN_CRANK
    yield 2 * _ONE * _sin(half_bank) ** 2
    yield _ONE * (1 - _cos(bank))
    for size in _SECOND:
        yield 2 * size * _sin(half_bank) * _sin(2 * half_bank) * _SIN_TWICE
        yield 2 * size * _sin(_HALF) * _sin(bank) * _SIN_TWICE


_V_PAGE = words(V_WORDS)
_GENERAL: tuple[Quantity, ...] = (
    Quantity(
        "force of two cylinders on one pin along the line between the banks", _LETTERS, ALONG,
        tuple(_along()), ("edit", "part"),
        mistakes=(2 * _ONE * _cos(half_bank) * COS_CRANK, 2 * _ONE * _cos(_HALF) * COS_CRANK,
                  2 * _ONE * _sin(half_bank) ** 2 * COS_CRANK, _ONE * (1 - _cos(bank)) * COS_CRANK,
                  _ONE * _cos(half_bank) ** 2 * COS_CRANK,
                  2 * _ONE * _sin(half_bank) * _cos(half_bank) * COS_CRANK,
                  2 * _ONE * _cos(2 * half_bank) * COS_CRANK, _ONE * _cos(bank) * COS_CRANK,
                  *(2 * size * _cos(half_bank) ** 2 * _COS_TWICE for size in _SECOND)),
        only=_V_PAGE, unless=words(_MORE), is_told_once=True,
    ),
    Quantity(
        "force of two cylinders on one pin across the line between the banks", _LETTERS, ACROSS,
        tuple(_across()), ("edit", "part"),
        mistakes=(2 * _ONE * _sin(half_bank) * SIN_CRANK, 2 * _ONE * _sin(_HALF) * SIN_CRANK,
                  2 * _ONE * _cos(half_bank) ** 2 * SIN_CRANK, _ONE * (1 + _cos(bank)) * SIN_CRANK,
                  _ONE * _sin(half_bank) ** 2 * SIN_CRANK,
                  2 * _ONE * _sin(half_bank) * _cos(half_bank) * SIN_CRANK,
                  2 * _ONE * _sin(2 * half_bank) * SIN_CRANK, _ONE * _cos(bank) * SIN_CRANK,
                  _ONE * _sin(bank) * SIN_CRANK,
                  *(2 * size * _sin(half_bank) ** 2 * _SIN_TWICE for size in _SECOND)),
        only=_V_PAGE, unless=words(_MORE), is_told_once=True,
    ),
)  # fmt: skip

_H = Number(Fraction(1, 2))
_R2, _R3 = root(Number(Fraction(2))), root(Number(Fraction(3)))
ANGLES: dict[int, tuple[Formula, Formula, Formula]] = {
    45: (_R2 / 2, root(2 + _R2) / 2, root(2 - _R2) / 2),
    60: (_H, _R3 / 2, _H),
    90: (Number(Fraction(0)), _R2 / 2, _R2 / 2),
    120: (-_H, _H, _R3 / 2),
}  # fmt: skip
"""Degrees between two banks -> the cosine of the angle, the cosine and the sine of its half."""
_SUMS = {
    45: (1 + _R2 / 2, 1 - _R2 / 2), 60: (Number(Fraction(3, 2)), _H),
    90: (Number(Fraction(1)), Number(Fraction(1))), 120: (_H, Number(Fraction(3, 2))),
}  # fmt: skip
_SECONDS = {  # 2 cos γ cos γ/2 and 2 sin γ sin γ/2
    60: (_R3 / 2, _R3 / 2), 90: (Number(Fraction(0)), _R2), 120: (-_H, Number(Fraction(3, 2))),
}  # fmt: skip


def _degrees(number: int) -> str:
    return rf"(?<![0-9.]){number}\s?(?:°|\\?deg|\^|\\circ|-degree| degree|[\s-]?grad|度)"


def _at_angle(number: int) -> str:
    """Return a pattern for words that two banks stand so many degrees apart: 60° V, the banks at 60°."""
    own = _degrees(number)
    banks = (
        r"(?:(?<![A-Za-z])V(?![A-Za-z])|\bvee\b|[VL]-?(?:twin|engine|motor|2)|banks?\b|V[形型]"
        r"|Gabelwinkel|Gabelmotor|(?:rods|cylinders)\s+(?:on|at)\b)"
    )
    before = (
        rf"(?:{banks}|moteur\s+en\s+V|cylinders\s+at|Bankwinkel|bank angle|included angle|V-?angle"
        rf"|Bankwinkel|V-Winkel|バンク角)[^.=。\n]{{0,40}}?(?:[^\w=]=\s?)?"
    )
    return rf"{own}[^.=。\n]{{0,14}}?{banks}|{before}{own}"


def _by_angle() -> Iterator[Quantity]:
    for number in ANGLES:
        others = "|".join(_degrees(other) for other in (30, *ANGLES, 180) if other != number)
        only = words(_at_angle(number))
        unless = words(_MORE, others)
        along, across = _SUMS[number]
        sizes = [size for size in _SECOND if number in _SECONDS]
        up, aside = _SECONDS.get(number, (along, across))
        yield Quantity(
            f"force of a V-twin at {number}° along the line between its banks", _LETTERS, ALONG,
            (along * _ONE * COS_CRANK, *(() if number == 90 else (along * _ONE,)),
             *(up * size * _COS_TWICE for size in sizes if number != 90)),
            ("edit", "factor", "part"),
            mistakes=tuple(n * _ONE * COS_CRANK for n in (2, _R2, _R3, _R3 / 2, _H, 2 * across, across)
                           if n != along),
            only=only, unless=unless, is_told_once=True, turns=True,
        )  # fmt: skip
        yield Quantity(
            f"force of a V-twin at {number}° across the line between its banks", _LETTERS, ACROSS,
            (across * _ONE * SIN_CRANK, *(() if number == 90 else (across * _ONE,)),
             *(aside * size * _SIN_TWICE for size in sizes)),
            ("edit", "factor", "part"),
            mistakes=tuple(n * _ONE * SIN_CRANK for n in (2, _R2, _R3, _R3 / 2, 2 * along, along)
                           if n != across),
            only=only, unless=unless, is_told_once=True, turns=True,
        )  # fmt: skip


_CRANKS = (
    r"(?:primary\s+|secondary\s+)?(?:direct|reverse)(?:\s+(?:and|or)\s+(?:the\s+)?(?:(?:primary"
    r"|secondary)\s+)?(?:direct|reverse))?\s+cranks?"
)
_HALVES: tuple[Quantity, ...] = (
    Quantity(
        "force of one of the two cranks that stand for a piston", letters("F P C K Z R"),
        words(rf"force\s+of\s+(?:the\s+|a\s+|each\s+)?{_CRANKS}",
            rf"{_CRANKS}[^.;=]{{0,140}}?force\s+of\s+each(?:\s+is)?",
              r"force\s+of\s+each\s+(?:primary\s+|secondary\s+)?(?:direct\s+|reverse\s+)?crank",
              r"force\s+of\s+each", r"each\s+crank\s+(?:gives|has"
                                    r"|exerts)\s+a\s+(?:centrifugal\s+)?force"),
        (_ONE / 2, *(size / 2 for size in _SECOND)), ("factor", "power", "part"),
        mistakes=(_ONE, _ONE / 4, *_SECOND, *(size / 4 for size in _SECOND)),
        only=words(r"direct and reverse|reverse crank|reverse and direct"),
        unless=words(r"radial|star|cylinders|V-?twin|banks"), is_told_once=True,
    ),
    Quantity(
        "radius of the cranks that stand for a piston's second order", letters("r R rho r_2 q"),
        words(r"radius\s+of\s+(?:the\s+|each\s+)?secondary\s+(?:direct\s+"
              r"|reverse\s+)?(?:and\s+reverse\s+)?cranks?",
              r"secondary\s+(?:effect|force)s?[^.;=]{0,40}cranks?\s+of\s+(?:length|radius)"),
        (pin / (4 * slender), pin * ratio / 4, pin**2 / (4 * rod)), ("factor", "power", "part"),
        mistakes=(pin / slender, pin / (2 * slender), pin * ratio, pin**2 / rod),
    ),
    Quantity(
        "vector of two cylinders on one pin that turns with the crank", letters("F P K R Z C A V"),
        words(r"(?:forward|direct|positive|co-?rotating)(?:\s+(?:primary|rotating))?\s+(?:vector|force"
              r"|component|part)",
              r"mitlaufende[rn]?\s+(?:anteil|zeiger|kraft)"),
        (_ONE,), ("bare factor", "power"), mistakes=(2 * _ONE, _ONE * _cos(bank), _ONE * _cos(half_bank)),
        only=_V_PAGE, unless=words(_MORE, r"second|zweite|2次|each bank|one cylinder|single"),
        is_told_once=True,
    ),
    Quantity(
        "vector of two cylinders on one pin that turns against the crank", letters("F P K R Z C A V"),
        words(r"(?:backward|reverse|negative|counter-?rotating)(?:\s+(?:primary|rotating))?\s+"
              r"(?:vector|force|component|part)", r"gegenlaufende[rn]?\s+(?:anteil|zeiger|kraft)"),
        (_ONE * _cos(bank), _ONE * _cos(2 * half_bank)), ("edit", "power"),
        mistakes=(_ONE * _cos(_HALF), _ONE * _cos(2 * bank), _ONE * _sin(bank)),
        only=_V_PAGE, unless=words(_MORE, r"second|zweite|2次|each bank|one cylinder|single"),
        is_told_once=True,
    ),
    Quantity(
        "mass of one of the two cranks that stand for a piston", letters("m M"),
        words(rf"(?:mass\s+)?(?:on|at)\s+the\s+{_CRANKS}", rf"mass\s+of\s+(?:the\s+|each\s+)?{_CRANKS}"),
        (mass / 2,), ("bare factor", "part"),
    ),
    Quantity(
        "second-order force of a star of three cylinders", letters("F P R Z K"),
        words(r"(?:resultant\s+)?(?:secondary|second[- ]order)\s+(?:inertia\s+)?forces?",
              r"(?:massenkraft|resultierende)\s+(?:2\.|zweiter|II\.)\s+ordnung",
                  r"(?:二|2)次(?:の)?(?:慣性力の)?(?:合力|慣性力)"),
        tuple(3 * size / 2 for size in _SECOND), ("factor", "power"),
        mistakes=tuple(3 * size for size in _SECOND),
        only=both(words(r"\bthree|drei|[三3]\s?気筒|\b3[- ]cyl"),
        words(r"radial|\bstar\b|sternmotor|星[形型]")),
        unless=words(r"\bfive\b|\bseven|\bnine|fünf|sieben|neun|articulated|slave|each cylinder"
                     r"|per cylinder"),
        is_told_once=True,
    ),
)  # fmt: skip

_RIGHT_ANGLED = words(_at_angle(90), r"right[- ]angled V|rechtwinkliger V")
_SECOND_WORDS = words(
    r"second(?:ary|[- ]order)[^.;=]{0,50}?(?:amplitude|resultant|horizontal|transverse)",
    r"(?:resultant|amplitude)[^.;=]{0,30}?second(?:ary|[- ]order)(?:\s+forces?)?",
        r"zweite[rn]?\s+ordnung[^.;=]{0,50}?amplitude",
    r"massenkraft\s+(?:2\.|zweiter|II\.)\s+ordnung", r"(?:二|2)次慣性力の合力(?:の最大値)?",
    r"résultante\s+des\s+forces\s+secondaires(?:\s+est\s+horizontale)?", r"zweite\s+ordnung",
)  # fmt: skip
_OF_ONE = r"|each cylinder|per cylinder|one cylinder|one bank|a single|je zylinder|eines zylinders"
_BALANCED_FIRST = words(
    r"(?:first|primary)(?:[- ]order)?[^.;。]{0,60}(?:balanc|cancel|vanish)"
    r"|(?:balanc|cancel)\w*[^.;。]{0,60}(?:first[- ]order|primary)",
    r"(?:1\.|erste[rnms]?|I\.)\s+ordnung[^.;。]{0,60}(?:ausgleich|ausgeglichen|ausgewucht|aufheben|heben)",
    r"(?:ausgleich|ausgeglichen|ausgewucht)\w*[^.;。]{0,60}(?:1\.|erste[rnms]?|I\.)\s+ordnung",
    r"[一1]次[^。]{0,30}(?:釣り?合|消|バランス)",
)  # fmt: skip
_UPRIGHT_V: tuple[Quantity, ...] = (
    Quantity(
        "angle between the crank pins of a V-twin without first order",
        letters("delta psi epsilon beta sigma"),
        words(r"(?:set\s+apart|offset|splay|split|versetz\w*|versatz|オフセット|ずら)[^.;。]{0,120}",
              r"(?:hubzapfen|kröpfungs|pin|crank)\w*[- ]?(?:versatz|offset|versatzwinkel)", r"位相差"),
        (PI - 2 * bank, 2 * bank - PI), (),
        mistakes=(PI - bank, PI + bank, 2 * PI - 2 * bank),
        only=_BALANCED_FIRST,
        unless=words(r"\bfir(?:es?|ing)\b|zünd|点火|even(?:ly)? spaced|\bhalf\b"
                     r"|halbe[rn]? V|V\s?6|V\s?8"),
    ),
    Quantity(
        "resultant second-order force of a V-twin at 90°", letters("F P R Z K S Y Q H"), _SECOND_WORDS,
        (*(_R2 * size for size in _SECOND), *(_R2 * size * _SIN_TWICE for size in _SECOND)),
        ("factor", "part", "power"), others=tuple(_R2 * size * _COS_TWICE for size in _SECOND),
        mistakes=(*(n * size for size in _SECOND for n in (2, _R2 / 2)), *_SECOND,
                  *(n * size * _SIN_TWICE for size in _SECOND for n in (1, 2, _R2 / 2))),
        only=_RIGHT_ANGLED, unless=words(_MORE.replace("|counterweight|gegengewicht", "") + _OF_ONE),
        is_told_once=True,
    ),
    Quantity(
        "moment of the counterweight of a V-twin at 90°", letters("· U D u"),
        words(r"(?:counter|balance)-?\s?(?:weights?|mass(?:es)?)", r"gegengewichte?s?", r"contrepoids",
            r"ausgleich", r"カウンタ(?:ー)?ウェイト", r"(?:釣り?合い|つりあい)(?:おもり|錘)"),
        (mass * pin, (rotating + reciprocating) * pin, (rotating + mass) * pin), ("edit", "part"),
        others=((rotating + 2 * reciprocating) * pin,),
        mistakes=(2 * mass * pin, mass * pin / 2, (rotating + reciprocating / 2) * pin,
                  (rotating + mass / 2) * pin),
        only=_RIGHT_ANGLED, unless=words(_MORE.replace("|counterweight|gegengewicht", "") +
            r"|each web|half|je wange"),
        never=words(r"mass\w*\s+(?:of|der|von|aller?)\s+(?:both|beide|the\s+two|all)",
                    r"(?:total|whole|both|gesamte|beide)\w*\s+(?:reciprocating|oscillating|oszill)",
                    r"両気筒|合計|全往復"),
        is_told_once=True,
    ),
)  # fmt: skip

_ANGLES = letters(
    "alpha beta gamma delta epsilon phi varphi theta psi chi A B Delta_phi Delta_varphi Delta_theta"
)
_FIRES = words(r"\bfir(?:es?|ing)\b|ignit|zünd|allumage|accension|scopp|encendid|explosi|点火|爆発|着火")
_FOUR_STROKE = words(
    r"four[- ]stroke|4[- ]stroke|viertakt|4-takt|4ストローク|4サイクル|四サイクル|quatre temps"
    r"|quattro tempi|cuatro tiempos"
)
_ONE_PIN = words(
    r"one\s+(?:crank\s?)?pin|single\s+(?:crank\s?)?pin|(?:common|shared|same)\s+(?:crank\s?)?pin"
    r"|one crank\b"
    r"|(?:einem|gemeinsame[rnm]*)\s+(?:hubzapfen|kurbelzapfen)|même maneton|(?:same|common|shared"
    r"|single|one|même|stess\w+|misma|unique|seul)\s+crank\s?pin|(?:seul|unique) maneton"
    r"|maneton (?:unique|commun)"
    r"|stess[oa]\s+(?:perno|manovella)|misma\s+muñequilla|crank pin common|一つのクランクピン"
    r"|クランクピン共通"
)
_TURN, _THIRD = 2 * PI, 2 * PI / 3
_FIRING: tuple[Quantity, ...] = (
    Quantity(
        "shorter firing interval of two cylinders on one pin", _ANGLES,
        words(r"(?:the\s+)?short(?:er|est|)\s+(?:firing\s+)?(?:one"
              r"|interval)", r"kürzere[rsnm]?(?:\s+zünd\w+)?",
              r"plus\s+court", r"più\s+(?:corto|breve)", r"más\s+corto", r"短い(?:方の)?(?:点火|爆発"
                                                                         r"|着火)?間隔|短い方"),
        (_TURN - bank,), ("edit",), others=(_TURN + bank,),
        mistakes=(PI - bank, _TURN - 2 * bank, 2 * _TURN - bank, _TURN - bank / 2),
        only=both(_V_PAGE, _FIRES, _FOUR_STROKE, _ONE_PIN), is_told_once=True,
        unless=words(r"offset|versetz|split|two pins|zwei hubzapfen|two[- ]stroke|zweitakt"
                     r"|V\s?-?[4-9]|V\s?-?1[0-9]"),
    ),
    Quantity(
        "longer firing interval of two cylinders on one pin", _ANGLES,
        words(r"(?:the\s+)?long(?:er|est|)\s+(?:firing\s+)?(?:one"
              r"|interval)", r"längere[rsnm]?(?:\s+zünd\w+)?",
              r"plus\s+long", r"più\s+lungo", r"más\s+largo", r"長い(?:方の)?(?:点火|爆発|着火)?間隔"
                                                              r"|長い方"),
        (_TURN + bank,), ("edit",), others=(_TURN - bank,),
        mistakes=(PI + bank, _TURN + 2 * bank, 2 * _TURN + bank, _TURN + bank / 2),
        only=both(_V_PAGE, _FIRES, _FOUR_STROKE, _ONE_PIN), is_told_once=True,
        unless=words(r"offset|versetz|split|two pins|zwei hubzapfen|two[- ]stroke|zweitakt"
                     r"|V\s?-?[4-9]|V\s?-?1[0-9]"),
    ),
    Quantity(
        "angle between the split pins of a V6 that fires evenly", _ANGLES,
        words(r"(?:offset|splay|split|versatz|versetz\w*|décal\w+|sfals\w+|decalad\w+|desfas\w+|spread)[^.;=]{0,60}",
              r"(?:pin|crank|throw)s?\s+(?:offset|angle)", r"位相差|オフセット"),
        (_THIRD - bank,), ("edit",), others=(bank - _THIRD,),
        mistakes=(PI - bank, PI / 3 - bank, _THIRD - bank / 2, _THIRD - 2 * bank, bank + PI / 3),
        only=both(words(r"(?<![A-Za-z])V\s?-?6(?![0-9])|V-?Sechszyl|6気筒V|V型6気筒"), _FOUR_STROKE,
                  words(r"evenly|even(?:ly)?[- ](?:spaced|firing)|equal\s+(?:firing\s+)?intervals"
                        r"|gleichmäßig|equidist|régulièr|uniform|regolar"
                        r"|equispa|等間隔")),
        unless=words(r"two[- ]stroke|zweitakt|V\s?-?8|V\s?-?12"), is_told_once=True,
    ),
)  # fmt: skip

TWO_CYLINDERS: tuple[Quantity, ...] = (*_GENERAL, *_by_angle(), *_HALVES, *_UPRIGHT_V, *_FIRING)
