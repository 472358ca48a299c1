"""What letters stand for in the standard formulas, and what is known of a quantity.

Letters in the formulas are the names of roles; `ROLES` tells which letters stand for a role on most
pages, and which words name it. Where two roles share their letters, a subscript parts them: F_g is the
force of the gas, F_s that of the rod.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from symbalance.document.formula import Call, Constant, Formula, Name
from symbalance.text import lazy_patterns as re


@dataclass(frozen=True, slots=True)
class Role:
    """What a letter in a known formula stands for: its usual letters, and the words that name it."""

    letters: frozenset[str]
    """Letters, with a subscript where only that one is usual: b, r_g."""
    words: re.Pattern[str]
    indices: frozenset[str] = frozenset()
    """Subscripts of which a letter needs one, where no words name it."""
    others: frozenset[str] = frozenset()
    """Subscripts with which a letter stands for something else."""


@dataclass(frozen=True, slots=True)
class Quantity:
    """A quantity with its standard formulas, in roles.

    The words that name it stand in the sentence of its formula or in its heading (`phrases`); with the
    usual letter those of `context` are enough. A formula is refuted if it has one of the `slips`, or is
    one of the `mistakes`, and is none of `others`, which the same words may mean.
    """

    name: str
    letters: frozenset[str]
    """The usual letters of the quantity itself."""
    phrases: re.Pattern[str]
    formulas: tuple[Formula, ...]
    slips: tuple[str, ...] = ("factor", "power")
    """What one may get wrong: "factor" (of a formula with a number), "bare factor", "power", "root",
    "turn" (2π), "minus", "term", and "edit": a sign, a function,
    an exponent or a number anywhere within; "any" for whatever else is not a multiple. With "part", words
    of a part (each, half) excuse no factor."""
    mistakes: tuple[Formula, ...] = ()
    """Formulas that are wrong by whatever convention."""
    context: re.Pattern[str] | None = None
    approximate: tuple[Formula, ...] = ()
    """Formulas that hold roughly, where the rod is long: right with ≈, open with =."""
    others: tuple[Formula, ...] = ()
    """Formulas that the same words may mean: never refuted."""
    unless: re.Pattern[str] | None = None
    """Words of the paragraph with which another formula may be right."""
    indices: frozenset[str] = frozenset()
    """Subscripts of which one has to stand at the letter where only the context names the quantity."""
    never: re.Pattern[str] | None = None
    """Words anywhere on the page with which another formula may be right."""
    only: re.Pattern[str] | None = None
    """Words of the paragraph or its heading without which the formula is compared but never refuted."""
    is_told_once: bool = False
    """Whether those words may stand anywhere on the page, if none of `unless` does."""
    together: tuple[tuple[str, str], ...] = ()
    """Roles whose letters have the same subscript, l_2 and d_2; "" is the quantity itself."""
    subscripts: tuple[tuple[str, str], ...] = ()
    """Roles whose letters need one of some subscripts, whatever words name them: x_0 the first peak."""
    stated: frozenset[str] = frozenset()
    """Roles whose number the words of the page may give: half of the mass, seven cylinders."""
    is_of_one: bool = False
    """Whether it is one cylinder's: where the words name an engine with more, no factor is a slip."""
    is_plain: bool = False
    """Whether its formula is that of many others, F/A: nothing is proved by it, and where the words may
    name another quantity of these letters nothing is refuted."""
    is_by_unit: bool = False
    """Whether its formulas differ by a letter's unit, 2πn and πn/30: a declared one settles which, or
    another formula of the quantity on the page."""
    turns: bool = False
    """Whether the angle has to be counted from the line of stroke, at the top, for a refutation."""


def words(*patterns: str) -> re.Pattern[str]:
    """Return a pattern for words in any case."""
    return re.compile("|".join(patterns), re.IGNORECASE)


def letters(text: str) -> frozenset[str]:
    """Return the letters, or subscripts, of a list."""
    return frozenset(text.split())


def root(node: Formula) -> Formula:
    """Return the square root of a formula."""
    return Call("sqrt", node)


PI = Constant("pi")
_ENTRIES: tuple[tuple[str, ...], ...] = (
    ("diameter", "d D", r"diameters?|durchmessers?|(?<!半)径|\bbore|bohrung|ボア"),
    ("outer", "d D", r"(?:outer|outside|external)(?: diameter)?|(?:diameter |\be |\bet "
                     r"|\by )(?:exterior|extérieur|externo|esterno)|außen(?:durchmesser)?"
                     r"|aussendurchmesser"
     r"|between (?:the )?diameters|zwischen den durchmessern"
     r"|外径"),
    ("inner", "d D", r"(?:inner|inside|internal)(?: diameter)?|(?:diameter |\be |\bet "
                     r"|\by )(?:interior|intérieur|interno)|innen(?:durchmesser)?|内径|\bbore"
     r"|diameter of the (?:hole|bore|drilling)|\bhole(?: diameter)?|\bdrilled to"
     r"|(?:auf|durch)?bohrung(?:sdurchmesser)?"
     r"|durchmesser der bohrung|between (?:the )?diameters|zwischen den durchmessern|穴径"),
    ("radius", "r R", r"radi(?:us|i)|halbmesser|半径|crank throw"),
    ("crank", "r R", r"radi(?:us|i)|halbmesser|半径|crank throw|crank length"),
    ("bending", "M", r"(?<!trägheits)(?<!widerstands)(?<!flächen)moments?(?! of)|曲げモーメント"),
    ("torque", "T M tau", r"(?<!trägheits)(?<!widerstands)(?<!flächen)moments?(?! of)|torques?|トルク"
     r"|ねじりモーメント"),
    ("force", "F P", r"forces?|loads?|kraft|last|力|荷重|weights?|gewicht"),
    ("pressure", "p P", r"pressure(?: (?:interior|intérieure|interna))?|druck|圧力?|[bi]?mep"),
    ("area", "A S F", r"area|fläche|面積|cross[- ]section|querschnitt(?!s)"),
    ("modulus", "W Z S", r"section modulus|widerstandsmoment|断面係数"),
    ("section", "I J", r"second moment|moment of (?:inertia|area)|polar moment|trägheitsmoment"
     r"|断面二次|inertia"),
    ("polar_section", "J I", r"polar (?:second )?moment(?: of (?:inertia|area))?"
     r"|polare[rns]? (?:flächen)?trägheitsmoment|断面二次極モーメント", "p t P T pol"),
    ("shear", "G C N", r"shear modulus|modulus of rigidity|rigidity|schubmodul|gleitmodul"
     r"|横弾性係数|せん断弾性係数|剛性率"),
    ("length", "l L ell", r"length|lang|länge|長さ?|distance|\bspan|abstand|stützweite|距離|スパン"),
    ("stress", "sigma", r"(?<!shear )(?<!shearing )(?<!torsional )stress|(?<!schub)(?<!torsions)spannung"
     r"|(?<!せん断)(?<!ねじり)応力"),
    ("shearing", "tau", r"(?<!bending )(?<!normal )(?<!tensile )(?<!direct )stress"
     r"|(?<!biege)(?<!normal)(?<!zug)spannung|(?<!曲げ)(?<!垂直)応力"),
    ("stiffness", "c k C K", r"stiffness|spring (?:rate|constant)|rate|constant|steifigkeit"
     r"|federkonstante|federrate|federn?|springs?|ばね定数?|剛性|こわさ"),
    ("mass", "m M", r"masse[ns]?|mass(?:es)?|質量|weight|gewicht|weigh(?:s|ing)|wiegt|rotor|dis[ck]s?"
     r"|scheiben?|円板"),
    ("inertia", "J I Theta", r"inertia|trägheitsmoment|massenträgheit|drehmasse|schwungmasse"
     r"|慣性モーメント|flywheel|schwungrad|rotor|円板|dis[ck]s?|scheiben?"),
    ("second_section", "I J", r"second moment|moment of (?:inertia|area)|polar moment|trägheitsmoment"
     r"|断面二次|inertia", "1 2 3 a b"),
    ("first_inertia", "J I Theta", r"inertia|trägheitsmoment(?:en?)?|massen|dis[ck]s?|scheiben?"
    r"|慣性モーメント"),
    ("second_inertia", "J I Theta", r"inertia|trägheitsmoment(?:en?)?|massen|dis[ck]s?|scheiben?"
    r"|慣性モーメント"),
    ("omega", "omega Omega w", r"(?:angular|circular) (?:speed|velocity|frequency)|speeds?"
    r"|winkelgeschwindigkeit"
     r"|kreisfrequenz|角速度|角振動数"),
    ("omega_high", "omega Omega", r"speeds?|velocit(?:y|ies)|winkelgeschwindigkeit(?:en)?"
    r"|角速度", "", "min"),
    ("omega_low", "omega Omega", r"speeds?|velocit(?:y|ies)|winkelgeschwindigkeit(?:en)?"
    r"|角速度", "", "max"),
    ("rotation", "n N f", r"speed|rpm|revolutions|drehzahl|回転数|回転速度|frequency"),
    ("frequency", "f nu", r"frequency|frequenz|振動数|周波数"),
    ("stroke", "s S H L", r"stroke|hub|行程|ストローク"),
    ("cylinders", "z Z i N n k", r"cylinders|zylinder(?:zahl)?|気筒数?|シリンダ数?"),
    ("velocity", "v u V", r"speed|velocity|geschwindigkeit|速度"),
    ("fluctuation", "delta C_s C_f K_s k_s", r"(?:coefficient"
        r"|degree) of (?:cyclic )?fluctuation(?: of(?: the)? speed)?|irregularity|fluctuation"
        r"|ungleichförmigkeit(?:sgrad)?|変動率|steadiness"),
    ("swing", "Delta_E E W Delta_W A", r"energy|work|arbeit|energie|エネルギ|swing|fluctuation"),
    ("power", "P N L", r"power|leistung|動力|出力"),
    ("shift", "a e d s", r"distance|abstand|eccentricity|距離|offset"),
    ("central", "J I Theta", r"inertia|trägheitsmoment|慣性モーメント"),
    ("gravity", "g", r"(?<!centre of )(?<!center of )gravity|erdbeschleunigung|重力加速度"),
    ("weight", "W G w", r"weight|gewicht|重量"),
    ("rod_angle", "beta phi varphi psi gamma delta", r"rod angle|obliquity|inclination(?: of the"
     r" (?:connecting )?rod)?|angle of the (?:connecting )?rod|(?:pleuel|stangen|schwenk"
     r"|pleuelstangen)winkel"
     r"|(?:連接棒|コンロッド)の?(?:傾き|傾斜|揺動)?角"
     r"|angle between (?:the )?(?:connecting )?rod and (?:the )?(?:cylinder|stroke|line of stroke)"
     r"|winkel zwischen (?:der )?(?:pleuel|schub)?(?:stange|pleuel) und (?:der )?zylinder(?:achse)?"
     r"|(?:連接棒|コンロッド)とシリンダ(?:ー)?(?:軸|中心線)?(?:と)?の(?:なす)?角"),
    ("crank_angle", "theta vartheta alpha phi varphi", r"crank ?angle|angle of the (?:first )?crank"
     r"|crank rotation"
     r"|kurbelwinkel|winkel der (?:ersten )?kurbel|クランク(?:回転)?角度?"),
    ("any_force", "F P S Q N K Z",
     r"(?<!piston )(?<!gas )(?<!rod )(?:forces?|loads?)"
     r"|(?<!gas)(?<!kolben)(?<!stangen)(?<!pleuel)kraft|(?<!ガス)(?<!ピストン)(?<!ガス圧)力",
     "", "s S st St cr c l pl rod g G p K k gas kol Gas Kol"),
    ("piston_force", "F P Q K",
    r"(?:piston|gas)\s+(?:force|load|effort|thrust)|(?:axial )?force (?:total "
    r"|resultant |acting |axial )?(?:up)?on the (?:piston|gudgeon pin|wrist ?pin)"
     r"|force along the (?:axis of the cylinder|cylinder(?:'s)? axis|line of stroke)"
     r"|ピストンに(?:働く|作用する|かかる)?(?:軸方向の?)?力"
        r"|net (?:piston )?(?:force|load)"
     r"|(?:kolben|gas)-?kraft|(?:ピストン|ガス)力", "g G p K k gas kol Gas Kol"),
    ("rod_force", "F S Q", r"(?:rod|stangen|pleuel)\w*[ -]*(?:force|thrust|load|kraft)|force (?:in|of"
    r"|along)"
     r" the (?:connecting )?rod|(?:連接棒|コンロッド)(?:の)?(?:軸)?力", "s S st St cr c l pl rod"),
    ("rod", "l L ell", r"length|rod|lang|länge|pleuel|stange|長さ?|連接棒|コンロッド"),
    ("ratio", "lambda rho varepsilon epsilon", r"ratio|verhältnis|比"),
    ("volume", "V", r"volume|displacement|hubraum|hubvolumen|容積|排気量"),
    ("clearance", "V", r"clearance(?: volume)?|compression (?:volume|space)|volume (?:left"
                       r"|remaining)|schadraum|(?:kompressions"
    r"|verdichtungs|brenn)"
     r"(?:raum|volumen)|(?:すきま|隙間|燃焼室)容積", "c k K C 0 cl comp v V"),
    ("swept", "V", r"swept(?: volume)?|displacement|displaced volume|volume displaced|hubraum"
                   r"|hubvolumen|行程容積|排気量",
    "h H s S d D st hub"),
    ("total_volume", "V", r"total volume|whole volume|gesamtvolumen|全容積", "",
    "c k K C 0 cl comp v V h H s S hub"),
    ("unbalance", "U", r"unbalance|imbalance|unwucht|不釣り?合い量?"),
    ("slenderness", "lambda n nu", r"ratio|verhältnis|比"),
    ("compression", "epsilon varepsilon r R kappa", r"compression ratio|verdichtung(?:sverhältnis)?"
    r"|圧縮比"),
    ("efficiency", "eta", r"efficiency|wirkungsgrad|効率"),
    ("width", "b B w", r"width|breadth|breite|幅"),
    ("height", "h H", r"height|depth|höhe|高さ|thickness|dicke|厚さ"),
    ("wall", "t s delta", r"thickness|wanddicke|wandstärke|dicke|肉厚|厚さ"),
    ("line_load", "q w p", r"loads?|last|荷重|forces?|kraft|per (?:unit )?length"),
    ("young", "E", r"modulus|elasticity|young|elastizitätsmodul|e-modul|ヤング率|縦弾性係数"),
    ("first_rate", "c k C K", r"stiffness|rates?|constants?|steifigkeiten|springs?|federn?"
    r"|ばね定数?", "1 a A I"),
    ("second_rate", "c k C K", r"stiffness|rates?|constants?|steifigkeiten|springs?|federn?|ばね定数?",
     "2 b B II"),
    ("own_length", "l L ell", r"length|länge|長さ?", "1 2 3 a b"),
    ("own_diameter", "d D", r"diameters?|durchmesser|径", "1 2 3 a b"),
    ("first_length", "l L ell", r"lengths?|längen?|長さ?", "1 a"),
    ("first_diameter", "d D", r"diameters?|durchmesser|径", "1 a"),
    ("density", "rho varrho gamma", r"density|dichte|密度"),
    ("own_inertia", "J I Theta", r"inertia|trägheitsmoment(?:en?)?|massen|dis[ck]s?|scheiben?"
    r"|慣性モーメント",
     "1 2 a b A B"),
    ("other_inertia", "J I Theta", r"inertia|trägheitsmoment(?:en?)?|massen|dis[ck]s?|scheiben?"
    r"|慣性モーメント",
     "1 2 a b A B f F"),
    ("decay", "delta sigma alpha", r"decay(?: constant| rate)?|abklingkonstante|abklingkoeffizient"
    r"|減衰定数"),
    ("damping", "d c b r k", r"damping(?: constant| coefficient)?|dämpfungs(?:konstante|koeffizient)"
     r"|dämpfung|減衰係数|dashpot|(?:damper|dämpfer)[^.,;]{0,12}(?:constant|konstante)"),
    ("damping_ratio", "D zeta xi vartheta theta", r"damping(?: ratio| factor)?|dämpfungs(?:grad|maß)"
    r"|lehr\w*"
     r"|減衰比"),
    ("tuning", "eta r beta nu", r"(?:frequency )?ratio|tuning|abstimmung|frequenzverhältnis|振動数比"
     r"|振動数[^、。]{0,14}の比|ratio of (?:the )?\w+ (?:to|and) (?:the )?\w+ frequenc(?:y|ies)"),
    ("decrement", "Lambda delta vartheta theta", r"decrement|dekrement|減衰率"),
    ("order", "i k n nu j x z m", r"\border|ordnung|ordnungszahl|次数?|harmonic|per (?:turn|revolution)"),
    ("static_deflection", "delta f y x s w", r"(?:deflection|durchsenkung|durchbiegung|einsenkung)"
     r"(?: (?:at|under|of|in|au|unter|am|an|der|des)\b[^,.;$=\\]{0,30})?|たわみ"),
    ("period", "T tau", r"period|time|dauer|zeit|周期"),
    ("arm", "s h a d e L l", r"distance|abstand|距離|length|länge|長さ"),
    ("gyration", "k i r rho", r"gyration|trägheitsradius|trägheitshalbmesser|回転半径"),
    ("near", "a c", r"distances?|abständen?|abstand|距離"),
    ("far", "b d", r"distances?|abständen?|abstand|距離"),
    ("share", "beta b c k kappa epsilon x alpha", r"factor|fraction|share|balance|counterweight|anteil"
                                                  r"|(?<=\w)grad|割合|率"
     r"|proportion"),
    ("rotating", "m M W w", r"(?:rotating|revolving)(?: mass)?|rotierende(?:n)?(?: masse)?"
    r"|回転(?:部分の)?質量",
     "r R rot Rot d dreh k K"),
    ("reciprocating", "m M W w", r"(?:reciprocating|oscillating)(?: mass)?|oszillierende(?:n)?(?: masse)?"
     r"|hin- und hergehende(?:n)?(?: masse)?|往復(?:部分の)?質量", "o O osz Osz osc h H rec p P alt a A"),
    ("pin", "r R", r"radi(?:us|i)|halbmesser|半径|crank throw|crank length", "", "g G b B c w cw A"),
    ("arm_of_weight", "b e rho R r_g r_G r_b r_c r_w r_cw r_B R_g R_b R_c r_A", r"radi(?:us|i)|halbmesser"
     r"|半径|distance|abstand|距離|arm"),
    ("kinetic", "E T K W U E_k E_kin", r"energy|energie|エネルギー?"),
    ("eccentricity", "e a s r", r"eccentricity|exzentrizität|偏心量?|radius|halbmesser|半径|shift"),
    ("balance_mass", "B m M", r"masse[ns]?|mass(?:es)?|weights?|gewicht|質量|おもり"),
    ("unbalanced", "m M u", r"mass|masse|質量|unbalance|unwucht"),
    ("tangential", "T F_T F_t F_tan P_t P_T K_T K_t Q_t Q_T S_t S_T", r"tangential(?:\s+(?:force|share"
        r"|component))?"
     r"|(?:tangential|dreh|umfangs)kraft|(?:接線|回転)(?:方向の?)?(?:力|分力)"),
    ("radial_part", "R F_R F_r F_rad P_r P_R K_R K_r Q_r Q_R S_r S_R",
     r"radial(?:\s+(?:force|share|component))?|radialkraft|(?:半径|法線)(?:方向の?)?(?:力|分力)"),
    ("centrifugal", "F_c C F_z F_Z Z F_rot F_f F_F P_c K_z F_cf F_C", r"centrifugal(?:\s+force)?"
        r"|fliehkraft"
     r"|zentrifugalkraft|遠心力"),
    ("effective_pressure", "p_e p_me p_b p_eff p_bmep P_e", r"(?:brake"
        r"|effective) mean (?:effective )?pressure"
     r"|(?<!indicated )(?<!friction )(?<!fmep )mean effective pressure"
     r"|effektiver? (?:mittel|nutz)druck|正味平均有効圧力?|bmep"),
    ("indicated_pressure", "p_i p_mi p_ind p_imep P_i", r"indicated (?:mean )?(?:effective )?pressure"
     r"|mean indicated pressure|indizierter? (?:mittel|innen)druck|図示平均有効圧力?|imep"),
    ("lost_pressure", "p_r p_mr p_f p_fr p_mf p_fmep", r"friction (?:mean )?(?:effective )?pressure"
     r"|mean (?:effective )?pressure of friction"
        r"|reib(?:ungs)?mitteldruck"
     r"|摩擦平均有効圧力?|fmep"),
    ("effective_power", "P_e P_b P_eff N_e P_bp P_bhp P_B N_b", r"(?:brake|effective"
        r"|shaft) (?:horse ?)?power|effektive leistung"
     r"|(?:nutz|effektiv)leistung|正味出力|軸出力"),
    ("indicated_power", "P_i P_ind N_i P_ip P_ihp", r"indicated (?:horse ?)?power|(?:indizierte "
        r"|innen)leistung|図示出力"),
    ("lost_power", "P_r P_f P_v P_fr N_r P_fp P_fhp", r"friction (?:horse ?)?power|reib(?:ungs)?leistung"
        r"|verlustleistung|摩擦損失(?:出力|動力)"),
    ("cycle_work", "W A W_T A_T W_c W_cyc W_Z W_i", r"work(?: done)?(?: (?:of|in|per|during) (?:a|one"
        r"|the|each) cycle)?"
     r"|arbeit|arbeitsspiel|仕事"),
    ("excess", "Delta_E Delta_W Delta_A Delta_U", r"fluctuation(?: of (?:the )?energy)?"
        r"|überschuss(?:arbeit)?|変動量?"),
    ("rod_acceleration",
        "alpha epsilon varepsilon ddot_beta ddot_phi ddot_psi ddot_varphi alpha_r alpha_c",
     r"angular acceleration|winkelbeschleunigung|角加速度"),
    ("to_big", "", r"(?!)"),
    ("to_small", "", r"(?!)"),
    ("piston_mass", "m_K m_Ko m_k m_p m_P m_piston M_p m_Kolben m_1", r"(?:mass of the )?piston(?: mass"
        r"| assembly)|mass of (?:the )?piston"
     r"|kolbenmasse|ピストン[^、。]{0,4}質量"),
    ("rod_mass", "m_Pl m_pl m_S m_St m_c m_r m_rod m_R m_P m_Pleuel m_cr", r"(?:connecting[- ])?rod mass"
        r"|mass of the (?:connecting[- ])?rod"
     r"|pleuel(?:stangen)?masse|(?:連接棒|コンロッド)(?:の)?質量"),
    ("crank_mass", "m_KZ m_Z m_c m_cr m_crank m_W m_k m_K m_KW", r"crank(?:[- ]?pin)? mass"
        r"|mass of the crank(?:[- ]?pin)?"
     r"|(?:(?:kurbel|hub)zapfen|kurbel)masse|クランク(?:ピン)?(?:の)?質量"),
    ("net_force", "P F_K F_p F_P F_k P_K K_K", r"piston (?:force|effort|load)|kolbenkraft"
        r"|(?:force|load|effort|kraft) (?:up)?(?:on|auf) (?:the |den )?(?:piston|kolben)"
        r"|(?:net|effective)"
     r" (?:force|load|effort)|ピストン力", "", "s S st St cr c l pl rod R r b B t T"),
    ("outer_radius", "R r",
            r"(?:outer|outside|external)(?: radius)?|(?:radius |\be |\bet |\by )(?:exterior"
            r"|extérieur|externo|esterno)|außen(?:radius)?|外半径"
     r"|between (?:the )?radii|zwischen den (?:radien|halbmessern)"),
    ("turn_rate", "n N f", r"rotational speed|engine speed|crank ?shaft speed|rev/(?:min|s)\b"
    r"|\b1/min|revolutions|\brpm|drehzahl|回転数"
     r"|回転速度|turns"),
    ("inner_radius", "r R", r"(?:inner|inside|internal)(?: radius)?|(?:radius |\be |\bet "
                            r"|\by )(?:interior|intérieur|interno)|innen(?:radius)?|内半径"
     r"|between (?:the )?radii|zwischen den (?:radien|halbmessern)"),
    ("bank", "gamma delta alpha V beta", r"(?:bank|vee|V|included|cylinder|fork)[- ]?angle|bankwinkel"
     r"|V-winkel|gabelwinkel|バンク角|挟み角"
     r"|(?:angle|angolo|ángulo) (?:of|du|del|della|de) (?:the |la )?V"
     r"|angle between the (?:banks|cylinders|cylinder (?:axes|lines))",
     "", "1 2 A B"),
    ("half_bank", "alpha beta gamma delta", r"half[- ](?:the )?(?:bank|vee|V|included)?[- ]?angle"
                                            r"|(?:bank|vee|V|included) ?-?angle(?: of)?"
     r" 2|(?:angle|angolo|ángulo) (?:of|du|del|della|de) (?:the |la )?V 2"
     r"|semi-?angle|angle between the (?:banks|cylinders|cylinder (?:axes|lines)) 2|winkel 2"
     r"|halber? (?:bank|V-|gabel)winkel|半(?:バンク角|挟み角|V角)"
     r"|(?:バンク角|挟み角|V角)(?:の(?:半分|1/2|二分の一)(?:の角度?)?|[をはがの、]?\s?2)"
     r"|(?:demi-?angle|moitié de l['’]angle)"
     r"(?: (?:du V|entre (?:les )?(?:cylindres|axes)|d['’]ouverture))?"
     r"|(?:semi-?angolo|metà dell['’]angolo)(?: (?:della V|(?:tra|fra) i cilindri|di apertura))?"
     r"|(?:semi-?ángulo|mitad del ángulo)(?: (?:de la V|entre (?:los )?cilindros|de apertura))?"),
    ("slender", "n nu q k lambda", r"ratio|l/r|verhältnis|比"),
    ("wheel_load", "P W Q N G F",
    r"loads?|charge statique|carga estática|carico statico|dead weight|weight|force|radlast|last"
    r"|kraft|荷重"),
    ("pitch", "a d b l s c e p L y", r"apart|distances?|spacing|pitch|abstand|距離|間隔|offset|arm"),
    ("base_force", "F P K f", r"force|amplitude|kraft|力", "0 o 1 I i c m rec"),
    ("sector", "beta gamma phi varphi theta alpha delta", r"(?:opening|full|sector|central|whole"
                                                          r"|included)"
     r" (?:sector )?angle|öffnungswinkel|zentriwinkel|中心角"),
    ("half_sector", "alpha beta gamma phi varphi theta delta",
        r"half[- ]?(?:the )?(?:\w+ )?angle|(?:opening|sector|full"
     r"|included)(?: \w+)? angle 2|öffnungswinkel 2|semi-?angle|halbe[nrms]? (?:\w+ )?\w*winkel|半角"),
    ("grade", "G Q", r"grade|quality|gütestufe|auswuchtgüte|等級|mm/s"),
    ("back_pressure", "p P", r"(?:crankcase|ambient|atmospheric|back|outside|surrounding|external"
    r"|counter)"
     r"\s+pressure|pressure\s+(?:in|of|at)\s+(?:the\s+)?(?:crankcase|surroundings|atmosphere|environment"
     r"|underside|outside)|atmosphere|(?:umgebungs|atmosphären|kurbelgehäuse|kurbelraum|außen|gegen)-?druck"
     r"|druck\s+(?:im|in\s+de[mr]|der)\s+(?:kurbelgehäuse|kurbelraum|umgebung)"
     r"|(?:クランク(?:室|ケース)|大気|外|背)の?(?:内)?の?圧力?|pression\s+(?:atmosphérique|ambiante)"
     r"|presi[oó]n\s+(?:atmosférica|ambiente)|pressione\s+(?:atmosferica|ambiente)",
     "0 a u k K KG atm amb U c L b crank cc umg o"),
    ("turned_angle", "theta vartheta alpha phi varphi psi gamma delta beta", r"(?!)"),
    ("wall_of_weight", "t b h s w d B", r"thick\w*|width|breadth|dicke|breite|厚さ?|幅"),
)  # fmt: skip
ROLES: Mapping[str, Role] = {
    name: Role(letters(usual), words(phrase), *map(letters, indices))
    for name, usual, phrase, *indices in _ENTRIES
}
OTHER_LENGTHS = words(
    r"distance|abstand|spacing|\bpitch|\barm|hebelarm|width|breite|thickness|dicke|height|höhe|depth"
    r"|距離|間隔|幅|厚さ|高さ|eccentricity|strokes? per"
)
"""Words for lengths that play no part here, whatever their letter."""
(
    diameter, outer, inner, radius, crank, bending, torque, force, pressure, area, modulus, section,
    polar_section, shear, length, stress, shearing, stiffness, mass, inertia, second_section,
    first_inertia,
    second_inertia, omega,
    omega_high, omega_low, rotation, frequency, stroke, cylinders, velocity, fluctuation, swing,
    power, shift, central, gravity, weight, rod_angle, crank_angle, any_force, piston_force,
    rod_force, rod, ratio, volume, clearance, swept, total_volume, unbalance, slenderness,
    compression, efficiency, width, height, wall,
    line_load, young, first_rate, second_rate, own_length, own_diameter, first_length,
    first_diameter, density, own_inertia, other_inertia, decay, damping, damping_ratio, tuning,
    decrement, order, static_deflection, period,
    arm, gyration, near, far, share, rotating, reciprocating, pin, arm_of_weight, kinetic,
    eccentricity, balance_mass, unbalanced, tangential, radial_part, centrifugal,
    effective_pressure, indicated_pressure, lost_pressure, effective_power, indicated_power,
    lost_power, cycle_work, excess, rod_acceleration, to_big, to_small, piston_mass, rod_mass,
    crank_mass, net_force, outer_radius, turn_rate, inner_radius, bank, half_bank, slender,
    wheel_load, pitch, base_force, sector, half_sector, grade, back_pressure, turned_angle,
    wall_of_weight,
) = map(Name, ROLES)  # fmt: skip
