"""Letters in the formulas of trains, rotors and pendulums: the middle disc, the total mass, a peak.

They join those of `roles` and `shaft_roles`, in the same form.
"""

from __future__ import annotations

from collections.abc import Mapping

from symbalance.document.formula import Name
from symbalance.notes.checking.meant.catalogue.roles import Role, letters, words

_SPEEDS = (
    r"(?:angular )?(?:speed|velocity)|rpm|(?:winkel)?geschwindigkeit|drehzahl(?:en)?|回転(?:数"
    r"|速度)|角速度"
)
_INERTIA = r"inertia|trägheitsmoment(?:en?)?|masse[ns]?|mass(?:es)?|慣性モーメント"
_TORQUE = r"torques?|(?<!trägheits)(?<!widerstands)momente?n?|(?<!慣性)モーメント|トルク"
_PEAK = r"amplitudes?|peaks?|ausschl[aä]ge?|振幅|極大値?"
_BODY = (
    r"(?:ones?|dis[ck]s?|rotors?|mass(?:es)?|inertia|of|has|have|with|each|the|scheiben?|masse[n]?|hat|haben|je|hanno|ha"
    r"|trägheitsmoment|円板|の|は|慣性モーメント)"
)
_ENTRIES: tuple[tuple[str, ...], ...] = (
    ("poisson", "nu mu", r"poisson\w*(?:['’]s)?(?: ratio| number)?|quer(?:kontraktion|dehn)\w*"
    r"|ポアソン比"),
    ("shaft_length", "l L ell", r"(?:whole|total|overall|shaft)\s+length|length of the (?:whole "
    r"|entire )?shaft"
     r"|(?:shaft|welle)(?: \w+){0,3} (?:of|de|di|der) (?:the )?(?:length|länge)|gesamtlänge"
     r"|länge der (?:ganzen )?welle|軸の(?:全)?長さ|全長", "", "1 2 a b A B"),
    ("own_speed", "n N omega Omega", _SPEEDS, "1 2 a b A B"),
    ("other_speed", "n N omega Omega", _SPEEDS, "1 2 a b A B"),
    ("own_teeth", "z Z", r"teeth|zähne\w*|歯数", "1 2 a b A B"),
    ("other_teeth", "z Z", r"teeth|zähne\w*|歯数", "1 2 a b A B"),
    ("middle_inertia", "J I Theta m M", rf"(?:middle|central\w*|mittler\w*|中央|中間)(?:\s?{_BODY})+"
     r"|(?:quello|quella|celui|die|der) (?:del |du )?(?:centrale|milieu|mittleren?)", "0 m c 2 M"),
    ("outer_inertia", "J I Theta m M",
     rf"(?:\bouter|\bend|outside|extern\w*|estern\w*|äußere\w*|両端|外側)(?:\s?{_BODY})+", "",
     "0 m c 2 M"),
    ("shaft_inertia", "J I Theta m M", rf"{_INERTIA}|federmasse|wellenmasse", "s sh w W S f F sp"),
    ("first_torque", "M T Q", _TORQUE, "a A 1 l"),
    ("second_torque", "M T Q", _TORQUE, "b B 2 r"),
    ("transmission", "T tau V TR T_R D i epsilon K",
    r"transmissib\w*|(?:振動|力の?)?伝達[率比]|durchlässigkeit\w*"
     r"|übertragungs\w+|transmission (?:ratio|factor)"),
    ("first_peak", "x X a A y theta vartheta varphi phi u q", _PEAK, "0 1 i"),
    ("later_peak", "x X a A y theta vartheta varphi phi u q", _PEAK, "n N m k 2 j"),
    ("cycles", "n N m k j", r"(?:full |complete )?cycles|apart|サイクル(?:数)?"),
    ("whole_swing", "x s d X", r"peak[- ]to[- ]peak(?:\s+\w+)?|schwingweite|double amplitude"
    r"|doppelamplitude"
     r"|(?:全|両)振幅", "pp ss PP"),
    ("displacement", "x y s z q u", r"displacement|deflection|elongation|auslenkung|変位|distance"),
    ("machine_mass", "M m_M m_ges m_tot m_g", r"(?:(?:total|whole|overall|machine(?:'s)?|engine(?:'s)?"
    r"|rotor(?:'s)?"
     r"|gesamt|maschinen)[ -]?(?:mass|masse|weight))|(?:mass|masse) (?:of|der) (?:the )?(?:whole "
     r"|ganzen )?"
     r"(?:machine|maschine|engine)|(?:machine|engine|maschine)(?: \w+)? (?:mass|masse)"
     r"|(?:機械|全体?)の?質量"),
    ("eccentric_mass", "m m_u m_0 m_e m_r", r"(?:rotating|eccentric|unbalanced?|out-of-balance"
    r"|exzentrische|rotierende"
     r"|umlaufende)[ -](?:mass|masse)|unwuchtmasse|(?:不釣り?合い|偏心|回転)の?質量"),
    ("span", "L l b B", r"bearing (?:distance|spacing|span)|lagerabstand|bearings (?:are|at"
    r"|stand)(?: apart| distant)?|span"
     r"|distance (?:between|of) (?:the )?bearings|abstand der lager|lager(?: haben"
     r"| sind)? (?:den )?(?:im )?abstand"
     r"|軸受間?の?(?:距離|間隔)"),
    ("couple_arm", "a b c s h l d", r"along the (?:axis|shaft)|apart|distances?|axial distance|abstand"
    r"|距離|間隔"),
    ("strings", "l L ell h", r"length|länge|長さ"),
    ("string_circle", "R r a b", r"radius|halbmesser|半径"),
    ("string_gap", "d a b D s c", r"distance|abstand|間隔|距離|apart|spacing"),
)  # fmt: skip
VIBRATION_ROLES: Mapping[str, Role] = {
    name: Role(letters(usual), words(phrase), *map(letters, indices))
    for name, usual, phrase, *indices in _ENTRIES
}
(
    poisson, shaft_length, own_speed, other_speed, own_teeth, other_teeth, middle_inertia, outer_inertia,
    shaft_inertia, first_torque, second_torque, transmission, first_peak, later_peak, cycles, whole_swing,
    displacement, machine_mass, eccentric_mass, span, couple_arm, strings, string_circle, string_gap,
) = map(Name, VIBRATION_ROLES)  # fmt: skip
