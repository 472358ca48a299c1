"""Letters in the formulas of shafts, mounts and fatigue: the stress amplitude, the mass ratio, the wire.

They join those of `roles`, in the same form.
"""

from __future__ import annotations

from collections.abc import Mapping

from symbalance.document.formula import Name
from symbalance.notes.checking.meant.catalogue.roles import Role, letters, words

_SAFETY = r"(?:safety )?factors?|safety|sicherheit(?:en)?|安全率"
_SPEEDS = r"speeds?|frequenc(?:y|ies)|drehzahl(?:en)?|frequenz(?:en)?|危険速度|振動数"
_ENTRIES: tuple[tuple[str, ...], ...] = (
    ("upper_stress", "sigma tau S T M F P", r"(?:largest|greatest|highest|maximum|upper|peak"
    r"|max\.?)\s+(?:stress|torque|force|load|moment)"
     r"|oberspannung|最大応力", "max o O ob upper"),
    ("lower_stress", "sigma tau S T M F P", r"(?:smallest|least|lowest|minimum|lower"
    r"|min\.?)\s+(?:stress|torque|force|load|moment)"
     r"|unterspannung|最小応力", "min u U un lower"),
    ("stress_amplitude", "sigma tau S", r"amplitude|alternating stress|\w*ausschlag\w*|応力振幅",
     "a A w alt"),
    ("mean_stress", "sigma tau S", r"mean stress|mittelspannung|平均応力", "m M mean"),
    ("endurance", "S_e S_n S_f S_w sigma_-1 sigma_e sigma_w sigma_W sigma_D sigma_A sigma_E sigma_bW",
     r"(?:endurance|fatigue)\s+(?:limit|strength)|dauerfestigkeit|wechselfestigkeit|疲[労れ]限度?"),
    ("static_strength",
     "S_u S_ut S_y S_yt R_m R_e sigma_B sigma_u sigma_y sigma_S sigma_ut sigma_Y sigma_T",
     r"(?:ultimate|tensile|yield)\s+(?:strength|stress|point|limit)|zugfestigkeit|streckgrenze"
     r"|引張強さ|降伏(?:点|応力)"),
    ("form_factor", "K_t alpha_k alpha_K K_T k_t alpha",
     r"(?:stress[- ]concentration|form|notch)\s+(?:factor|number)|formzahl|形状係数|応力集中係数"),
    ("sensitivity", "q eta_k eta_K eta", r"sensitivity|empfindlichkeit\w*|感度\w*"),
    ("bending_safety", "n S nu s k", _SAFETY, "sigma b sig 1"),
    ("torsion_safety", "n S nu s k", _SAFETY, "tau t 2"),
    ("amplitude", "X A a x z x_0 hat_x x_a", r"amplitude|ausschlag|振幅"),
    ("hang", "R r a", r"radius|distance|halbmesser|abstand|半径|距離"),
    ("bob", "l L r ell rho", r"length|länge|長さ"),
    ("mass_ratio", "mu gamma", r"(?:mass |inertia )?ratio|massenverhältnis|(?:質量|慣性)比"),
    ("gear_ratio", "i u n", r"\b(?:turns|rotates|runs)|\bläuft|ratio|übersetzung\w*|変速比|減速比"
    r"|歯車比"),
    ("wire", "d", r"wire(?:'s)?(?: of)?(?: the)? diameter|wire|diameter of the wire|draht(?:durchmesser)?"
     r"|線径"),
    ("coil", "D d_m D_m", r"(?:mean|coil|spring)(?: \w+)? diameter|diameter of (?:the|a) (?:coils?"
    r"|spring)"
     r"|(?:mittlere[rnm]? |windungs)+durchmesser|コイル(?:平均)?径"),
    ("windings", "n i z N", r"turns|coils|windungen|windungszahl|巻数"),
    ("amplitude_before", "theta Theta vartheta alpha a A phi varphi beta",
     r"amplitude|mass|dis[ck]|masse|scheibe|振幅"),
    ("first_speed", "n N omega Omega f", _SPEEDS, "1 a A s S 0"),
    ("second_speed", "n N omega Omega f", _SPEEDS, "2 b B"),
    ("third_speed", "n N omega Omega f", _SPEEDS, "3 c C"),
    ("third_rate", "c k C K", r"stiffness|rates?|constants?|steifigkeiten|springs?|federn?|ばね定数?",
    "3 c C III"),
    ("driving", "omega Omega f n N", r"(?:driving|exciting|forcing|excitation)\s+frequency|frequency"
    r"|speed"
     r"|erreger\w*|drehzahl|振動数|回転数", "", "0 n 1 2 e k c cr krit crit d"),
    ("natural", "omega f n N", r"natural\s+(?:\w+\s+)?frequency|eigen\w*|critical speed|固有\w*",
     "0 n 1 e k c cr krit crit"),
    ("upper_point", "omega f", r"frequenc(?:y|ies)|points?|frequenz", "2 b B o"),
    ("lower_point", "omega f", r"frequenc(?:y|ies)|points?|frequenz", "1 a A u"),
    ("resonant", "omega f", r"frequency|resonance|frequenz|resonanz|共振\w*|固有\w*", "0 n r res m e"),
    ("mass_per_length", "mu m rho q", r"mass per (?:unit )?length|linear density|masse je länge"
    r"|massenbelegung"
     r"|線密度"),
    ("excitation", "F P T M Q", r"force|torque|moment|kraft|力|トルク"
     r"|(?:force|torque|moment|kraft)(?:es|s)? (?:of|with|mit|der) (?:the |an |der )?amplitude"
     r"|(?:moment|kraft)amplitude"
     r"|(?:力|トルク)の?振幅", "0 a e hat n i k 1"),
    ("shear_stress_allowed", "tau", r"stress|spannung|応力"),
    ("load_rating", "C C_r C_dyn C_a", r"(?:load rating|basic rating|capacity|tragzahl|負荷容量)"),
    ("bearing_load", "P F P_r F_r P_m F_m", r"(?:loads?|forces?|last|kraft|荷重)"),
    ("shear_force", "Q V F P S", r"(?:shear(?:ing)? )?force|querkraft|せん断力"),
)  # fmt: skip
SHAFT_ROLES: Mapping[str, Role] = {
    name: Role(letters(usual), words(phrase), *map(letters, indices))
    for name, usual, phrase, *indices in _ENTRIES
}
(
    upper_stress, lower_stress, stress_amplitude, mean_stress, endurance, static_strength,
    form_factor, sensitivity, bending_safety, torsion_safety, amplitude, hang, bob, mass_ratio,
    gear_ratio, wire, coil, windings, amplitude_before, first_speed, second_speed, third_speed,
    third_rate, driving, natural, upper_point, lower_point, resonant, mass_per_length, excitation,
    shear_stress_allowed, load_rating, bearing_load, shear_force,
) = map(Name, SHAFT_ROLES)  # fmt: skip
