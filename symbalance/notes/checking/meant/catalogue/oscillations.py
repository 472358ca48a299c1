"""Free swings and how they are measured: harmonic motion, decay of peaks, pendulums, suspensions."""

from __future__ import annotations

from symbalance.document.formula import Call
from symbalance.notes.checking.meant.catalogue.roles import (
    PI,
    Quantity,
    arm,
    damping_ratio,
    decay,
    frequency,
    gravity,
    inertia,
    letters,
    mass,
    omega,
    period,
    root,
    stiffness,
    words,
)
from symbalance.notes.checking.meant.catalogue.shaft_roles import amplitude
from symbalance.notes.checking.meant.catalogue.strength import both
from symbalance.notes.checking.meant.catalogue.vibration import NATURAL_WORDS
from symbalance.notes.checking.meant.catalogue.vibration_roles import (
    cycles,
    displacement,
    first_peak,
    later_peak,
    string_circle,
    string_gap,
    strings,
    transmission,
    whole_swing,
)

_HARMONIC = words(
    r"simple\s+harmonic", r"\bSHM\b", r"harmonic\s+(?:motion|oscillation|vibration)",
    r"harmonische\w*\s+(?:schwingung|bewegung)",
    r"単振動", r"調和振動", r"(?:pure|sine|sinusoidal)\s+(?:sine|motion|vibration|oscillation)",
    r"sinusoidal|sinusförmig",
    r"pure\s+sine", r"正弦",
)  # fmt: skip
_LARGEST = r"(?:peak|maximum|greatest|largest|max\.?)\s+"
_VELOCITY = words(rf"(?:{_LARGEST})?velocity", r"\bspeed", r"geschwindigkeit", r"速[さ度]", r"schnelle")
_ACCELERATION = words(
    rf"(?:{_LARGEST})?acceleration",
    r"(?:größte\s+|maximale\s+|spitzen)?beschleunigung",
    r"(?:最大)?加速度",
)
_GREATEST = words(r"peak|maxim\w+|greatest|largest|amplitude|größte|höchst|scheitel|最大|振幅|ピーク")
_NOT_SWINGING = (
    r"piston|kolben|ピストン|crank|kurbel|クランク|r\.?m\.?s\.?\b|effektivwert|実効値"
    r"|averag|mittlere|平均"
)
_INERTIA = words(
    r"(?:mass\s+)?moment\s+of\s+inertia", r"inertia", r"(?:massen)?trägheitsmoment", r"慣性モーメント",
    r"period", r"schwingungsdauer", r"周期", r"(?:small|torsional)\s+(?:\w+\s+)?(?:oscillations|swings"
    r"|vibrations)",
    r"drehschwingung\w*", r"folgt|follows", r"ねじり振動",
)  # fmt: skip
_ABOUT_CENTRE = words(
    r"(?:(?:mass\s+)?moment\s+of\s+)?inertia\s+(?:about|round)\s+(?:the|its)\s+(?:cent(?:re|er)\s+of\s+(?:gravity|mass)"
    r"|centroid|own\s+cent\w+)", r"about\s+(?:the|its)\s+(?:cent(?:re|er)\s+of\s+(?:gravity|mass)"
    r"|centroid)",
    r"trägheitsmoment\s+um\s+(?:den|die|seinen|ihren)\s+(?:eigenen\s+)?schwer\w+",
    r"重心(?:ま|周)わりの慣性モーメント",
    r"um\s+den\s+schwerpunkt",
)  # fmt: skip
_PIVOT = (
    r"(?:pivot|(?:point|axis)\s+of\s+(?:suspension|swing|rotation)|suspension|knife[- ]?edge|small[- ]end"
    r"|big[- ]end"
    r"|(?:piston|gudgeon|wrist|crank)[- ]?pin)"
)
_ABOUT_PIVOT = words(
    rf"(?:(?:mass\s+)?moment\s+of\s+)?inertia\s+(?:about|round)\s+(?:the|its|this|that)\s+{_PIVOT}",
    rf"about\s+(?:the|its|this|that)\s+{_PIVOT}",
    r"trägheitsmoment\s+um\s+(?:den|die|das|seinen|ihren)\s+(?:aufhänge|dreh|pendel|schneide|kleine|große|auge)\w*",
    r"(?:支点|回転軸|懸垂点|小端|大端)(?:ま|周|回)わりの慣性モーメント",
    r"moment\s+d['’]inertie\s+(?:par\s+rapport\s+(?:au|à\s+l['’])|autour\s+d[ue])\s*(?:\w+\s+)?"
    r"(?:pivot|couteau|suspension|axe)",
    r"momento\s+d['’]inerzia\s+(?:rispetto\s+al|intorno\s+al)\w*\s*(?:perno|coltello|punto|asse)",
    r"momento\s+de\s+inercia\s+(?:respecto\s+(?:al|de)|alrededor\s+de)\w*\s*(?:el\s+)?(?:pivote|punto|cuchilla|eje)",
)  # fmt: skip
_PENDULUM = words(
    r"pendul", r"pendel", r"knife[- ]edge", r"schneide", r"swings?\b", r"suspended|hung\b|hangs",
    r"schwingt", r"振り子",
    r"ナイフエッジ", r"period|schwingungsdauer|周期",
)  # fmt: skip
_BIFILAR = words(
    r"bifilar",
    r"zweifaden\w*",
    r"二本吊り|2本吊り|バイファイラ|2本の(?:糸|ワイヤ)",
    r"two\s+(?:\w+\s+){0,3}(?:wires|strings|threads|cords)",
    r"zwei\s+(?:\w+\s+){0,3}(?:fäden|drähten?)",
)
_TRIFILAR = words(
    r"trifilar",
    r"dreifaden\w*",
    r"三本吊り|3本吊り|3本の(?:糸|ワイヤ)",
    r"three\s+(?:\w+\s+){0,3}(?:wires|strings|threads|cords)",
    r"drei\s+(?:\w+\s+){0,3}(?:fäden|drähten?)",
)
_HUNG = mass * gravity * arm * period**2
_OF_TWO = mass * gravity * string_gap**2 * period**2 / strings
_OF_CIRCLE = mass * gravity * string_circle**2 * period**2 / strings
_LOG = Call("ln", first_peak / later_peak)
_PEAKS = (("first_peak", "0 1 i"), ("later_peak", "n N m k 2 j"))
_FREELY = root(1 - damping_ratio**2)

OSCILLATIONS: tuple[Quantity, ...] = (
    Quantity(
        "velocity in a harmonic oscillation at a displacement", letters("v dot_x u V"), _VELOCITY,
        (omega * root(amplitude**2 - displacement**2),), ("edit", "power", "root"),
        mistakes=(omega * (amplitude - displacement), omega * (amplitude**2 - displacement**2),
                  root(omega * (amplitude**2 - displacement**2)), omega * root(amplitude - displacement),
                  omega**2 * root(amplitude**2 - displacement**2)),
        only=_HARMONIC, unless=words(_NOT_SWINGING),
    ),
    Quantity(
        "largest velocity of a harmonic vibration", letters("v hat_v V dot_x"), _VELOCITY,
        (omega * amplitude, 2 * PI * frequency * amplitude, PI * frequency * whole_swing,
         omega * whole_swing / 2), ("turn",),
        mistakes=(omega**2 * amplitude, 2 * PI * frequency * whole_swing, omega * whole_swing,
                  4 * PI**2 * frequency**2 * amplitude, amplitude / omega, frequency * amplitude),
        only=both(_HARMONIC, _GREATEST), unless=words(_NOT_SWINGING),
    ),
    Quantity(
        "largest acceleration of a harmonic vibration", letters("a hat_a A ddot_x"), _ACCELERATION,
        (omega**2 * amplitude, 4 * PI**2 * frequency**2 * amplitude,
        2 * PI**2 * frequency**2 * whole_swing,
         omega**2 * whole_swing / 2), ("turn", "power"),
        mistakes=(
            4 * PI**2 * frequency**2 * whole_swing, PI**2 * frequency**2 * whole_swing,
            2 * PI * frequency**2 * whole_swing, frequency**2 * whole_swing / 2,
            2 * PI * frequency * whole_swing, omega**2 * whole_swing,
            2 * PI * frequency * amplitude, 2 * PI * frequency**2 * amplitude,
            2 * PI**2 * frequency**2 * amplitude, 4 * PI * frequency**2 * amplitude,
        ),
        only=both(_HARMONIC, _GREATEST), unless=words(_NOT_SWINGING, r"static|statisch"),
    ),
    Quantity(
        "logarithmic decrement by two peaks", letters("Lambda delta vartheta theta D"),
        words(r"log(?:arithmic|\.)?\s+decrement", r"logarithmisches?\s+dekrement", r"対数減衰率"),
        (_LOG / cycles, (Call("ln", first_peak) - Call("ln", later_peak)) / cycles, _LOG), ("minus",),
        mistakes=(Call("ln", later_peak / first_peak) / cycles, cycles * _LOG,
        first_peak / later_peak / cycles,
                  _LOG / (2 * PI * cycles), _LOG / (cycles + 1), _LOG / (2 * cycles), _LOG / (cycles - 1),
                  Call("ln", later_peak / first_peak), _LOG / (PI * cycles), 2 * PI * _LOG / cycles),
        subscripts=_PEAKS,
        unless=words(r"half|halb|半|successive\s+(?:maxima\s+and\s+minima|extrem)|opposite|both\s+sides"
        r"|peak[- ]to[- ]peak"),
    ),
    Quantity(
        "angular frequency of a damped free oscillation", letters("omega Omega w p"),
        words(NATURAL_WORDS.pattern, r"(?:angular\s+)?frequency", r"(?:kreis)?frequenz",
        r"oscillat\w+|vibrat\w+",
              r"schwing\w+", r"(?:角|円)?振動数", r"pulsation"),
        (omega * _FREELY, root(omega**2 - decay**2)), ("edit", "root"),
        mistakes=(omega * (1 - damping_ratio**2), omega * root(1 - 2 * damping_ratio**2),
                  omega / _FREELY, omega * root(1 - damping_ratio), omega * (1 - damping_ratio)),
        only=both(words(r"damp|dämpf|減衰"), words(r"free(?:ly)?\b|\bfrei\w*\b|自由|libera\w*|libre\w*")),
        unless=words(r"undamped\s+(?:natural\s+)?(?:frequency|system|oscill)|forced|erzwungen|強制|resonan|peak|maxim"
                     r"|amplitude\s+(?:is|has)|hysteretic|structural|loss\s+factor"),
    ),
    Quantity(
        "moment of inertia about the centre of gravity by a pendulum's period", letters("J I Theta"),
        _ABOUT_CENTRE,
        (_HUNG / (4 * PI**2) - mass * arm**2,), ("edit", "power"),
        mistakes=(_HUNG / (4 * PI**2) + mass * arm**2, _HUNG / (4 * PI**2),
        _HUNG / (2 * PI) - mass * arm**2,
                  mass * gravity * arm * period / (4 * PI**2) - mass * arm**2,
                  4 * PI**2 * mass * gravity * arm / period**2 - mass * arm**2,
                  _HUNG / (4 * PI) - mass * arm**2, _HUNG / (2 * PI**2) - mass * arm**2,
                  mass * gravity * period**2 / (4 * PI**2) - mass * arm**2),
        only=_PENDULUM, unless=words(r"bifilar|trifilar|zweifaden|dreifaden|torsion|half|halbe|半"),
    ),
    Quantity(
        "moment of inertia about its pivot by a pendulum's period", letters("J I Theta"), _ABOUT_PIVOT,
        (_HUNG / (4 * PI**2),), ("edit", "power", "factor"),
        mistakes=(_HUNG / (4 * PI), _HUNG / (2 * PI), _HUNG / (2 * PI**2), _HUNG / PI**2,
                  _HUNG / (8 * PI**2),
                  mass * gravity * arm * period / (4 * PI**2), mass * gravity * period**2 / (4 * PI**2),
                  4 * PI**2 * mass * gravity * arm / period**2, mass * gravity * arm * period / (2 * PI),
                  mass * arm * period**2 / (4 * PI**2)),
        only=_PENDULUM, unless=words(r"bifilar|trifilar|zweifaden|dreifaden|torsion|halbe|半周期"
                                     r"|half\s+(?:swing|period)"),
    ),
    Quantity(
        "moment of inertia by a bifilar suspension", letters("J I Theta"), _INERTIA,
        (_OF_TWO / (16 * PI**2),), ("factor", "power", "part"),
        mistakes=(_OF_TWO / (4 * PI**2), _OF_TWO / (8 * PI**2), _OF_TWO / (16 * PI)),
        only=_BIFILAR, unless=words(r"trifilar|dreifaden|radius|halb|half|inclin|spread|unequal"
        r"|different"),
    ),
    Quantity(
        "period of a bifilar suspension", letters("T tau"), _INERTIA,
        (4 * PI / string_gap * root(inertia * strings / (mass * gravity)),), ("factor", "power", "root",
        "part"),
        mistakes=(2 * PI / string_gap * root(inertia * strings / (mass * gravity)),
                  4 * PI * string_gap * root(inertia * strings / (mass * gravity))),
        only=_BIFILAR, unless=words(r"trifilar|dreifaden|radius|halb|half|inclin|spread|unequal"
        r"|different"),
    ),
    Quantity(
        "moment of inertia by a trifilar suspension", letters("J I Theta"), _INERTIA,
        (_OF_CIRCLE / (4 * PI**2),), ("factor", "power", "part"),
        mistakes=(3 * _OF_CIRCLE / (4 * PI**2), _OF_CIRCLE / (2 * PI), _OF_CIRCLE / (16 * PI**2),
                  mass * gravity * string_circle**2 * strings / (4 * PI**2 * period**2)),
        only=_TRIFILAR, unless=words(r"bifilar|zweifaden|inclin|platform|plattform|unequal|\beach\b"
        r"|\bper\s+wire|\bjede\w*|\bje\s"),
    ),
    Quantity(
        "period of a trifilar suspension", letters("T tau"), _INERTIA,
        (2 * PI / string_circle * root(inertia * strings / (mass * gravity)),), ("factor", "power",
        "root", "part"),
        mistakes=(2 * PI * string_circle * root(inertia * strings / (mass * gravity)),),
        only=_TRIFILAR, unless=words(r"bifilar|zweifaden|inclin|platform|plattform|unequal|\beach\b"
        r"|\bper\s+wire|\bjede\w*|\bje\s"),
    ),
    Quantity(
        "frequency ratio for a transmissibility", letters("r eta u beta nu lambda"),
        words(r"frequency\s+ratio", r"ratio\s+of\s+(?:the\s+)?frequencies", r"frequenzverhältnis",
        r"振動数比", r"tuning",
              r"abstimmung\w*", r"ratio"),
        (root(1 + 1 / transmission), root((1 + transmission) / transmission)), ("root", "edit"),
        mistakes=(root(1 - 1 / transmission), root(1 + transmission), 1 + 1 / transmission,
                  root(1 / transmission), root(1 / transmission - 1), 1 / transmission),
        only=words(r"transmiss|isolat|durchlässig|isolier|伝達[率比]|防振"),
        unless=words(r"(?<!un)damped|(?<!un)gedämpft|damping\s+ratio|(?<!out\s)(?<!no\s)damping\s+of|mit\s+dämpfung|減衰を考慮|減衰比"),
    ),
    Quantity(
        "angular frequency at which an undamped absorber stops a mass", letters("omega Omega w"),
        words(NATURAL_WORDS.pattern, r"condition", r"tuned",
        r"at\s+rest|standstill|stands?\s+still|vanish\w*|zero", r"bedingung",
              r"abgestimmt|abstimmung", r"\bruhe|still", r"条件", r"同調", r"零|ゼロ|静止"),
        (root(stiffness / mass), root(stiffness / inertia)), ("root", "turn"),
        mistakes=(root(2 * stiffness / mass), root(stiffness / (2 * mass)),
        root(2 * stiffness / inertia)),
        only=words(r"undamped\s+(?:dynamic\s+|vibration\s+)*absorber|absorber\s+without\s+damping|ungedämpfte\w*\s+\w*tilger"
                   r"|減衰の(?:ない|無い)動吸振器|(?:absorber|tilger|動吸振器)"),
        unless=words(r"den\s+hartog|optim|最適|pendul|pendel|振り子|mass\s+ratio|massenverhältnis|質量比"
                     r"|(?<!un)damped\s+absorber|gedämpfter?\s+tilger"),
    ),
    Quantity(
        "stiffness of an undamped absorber", letters("c k C K"),
        words(r"stiffness", r"spring\s+(?:rate|constant)", r"condition", r"tuned",
        r"at\s+rest|stands?\s+still|vanish\w*|zero",
              r"feder(?:steifigkeit|konstante|rate)", r"bedingung", r"abgestimmt|abstimmung", r"条件",
              r"ばね定数", r"同調",
              r"零|ゼロ|静止"),
        (mass * omega**2, inertia * omega**2), ("power", "turn"),
        mistakes=(2 * mass * omega**2, mass * omega, mass / omega**2, omega**2 / mass,
        mass * omega**2 / 2),
        only=words(r"absorber|tilger|動吸振器"),
        unless=words(r"den\s+hartog|optim|最適|pendul|pendel|振り子|mass\s+ratio|massenverhältnis|質量比"
                     r"|(?<!un)damped\s+absorber|gedämpfter?\s+tilger"),
    ),
)  # fmt: skip
