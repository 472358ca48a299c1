"""Free and forced vibrations: natural frequencies, damping, magnification, critical speeds, pendulums."""

from __future__ import annotations

from symbalance.notes.checking.meant.catalogue.roles import (
    PI,
    Quantity,
    arm,
    central,
    damping,
    damping_ratio,
    decay,
    decrement,
    first_inertia,
    frequency,
    gravity,
    gyration,
    inertia,
    length,
    letters,
    mass,
    omega,
    order,
    other_inertia,
    own_inertia,
    period,
    root,
    rotation,
    second_inertia,
    static_deflection,
    stiffness,
    tuning,
    words,
)
from symbalance.notes.checking.meant.catalogue.vibration_roles import shaft_length

_NATURAL = (
    root(stiffness / inertia), root(stiffness / mass),
    root(stiffness * (first_inertia + second_inertia) / (first_inertia * second_inertia)),
    2 * PI * frequency,
)  # fmt: skip
_VIBRATION = r"vibrat|oscillat|resonan|schwing|eigen|振動|固有|natural"
NATURAL_WORDS = words(
    r"natural\s+(?:angular\s+|circular\s+|radian\s+)?frequenc(?:y|ies)",
    r"angular\s+natural\s+frequency",
    r"eigen(?:angular\s+)?frequency",
    r"eigen(?:kreis)?frequenz",
    r"固有(?:角|円)?振動数",
    r"固有角周波数",
    r"frequency of (?:the )?(?:free )?(?:torsional )?(?:vibration"
    r"|oscillation)s?",
)
_SIDES = "1 2 3 a b A B"
"""Subscripts of two discs, where none says which of them is the flywheel."""
_FROM_WHEEL = (
    r"from\s+(?:the\s+)?(?:fly)?wheel|vo[mn]\s+(?:der\s+)?schwung|(?:フライホイール|はずみ車)(?:側)?(?:の円板)?から"
    r"|(?:du|depuis\s+le)\s+volant|dal\s+volano|desde\s+el\s+volante"
)
_NODE = words(
    r"(?:position|distance|place)\s+of\s+(?:the|its)\s+node",
    r"\bnode(?:\s+(?:is|lies|sits|has))?\s+(?:then\s+)?at(?:\s+(?:the|a)\s+distance)?",
    r"\bnode\s+(?:[\w-]+\s+){0,8}distance",
    r"lage\s+des\s+(?:schwingungs)?knotens",
    r"abstand\s+des\s+(?:schwingungs)?knotens",
    r"\bnode[^.;=]{0,24}?\bfrom\s+(?:the\s+)?(?:\w+[\s-]){0,3}?(?:dis[ck]|side|engine|cylinders?)",
    r"(?:from|von)\s[^.;=]{0,24}?(?:to|zum?)\s(?:the\s)?(?:node|knoten)",
    r"節(?:の位置|までの(?:距離|長さ)|は[^。、=]{0,16}から)",
)

VIBRATION: tuple[Quantity, ...] = (
    Quantity(
        "natural angular frequency", letters("omega Omega w p"),
        NATURAL_WORDS,
        _NATURAL, slips=("power", "root", "turn"), context=words(_VIBRATION),
        indices=letters("0 1 e n d eig E nat k"),
        unless=words(r"damp|gedämpf|減衰|pendul|pendel|振り子|rotating vector|three|drei|三|3つ"),
    ),
    Quantity(
        "natural frequency in cycles", letters("f nu"),
        words(r"natural\s+frequenc(?:y|ies)", r"eigenfrequenz", r"eigenfrequency",
        r"固有(?:振動数|周波数)",
               r"frequency of (?:the )?(?:free )?(?:torsional )?(?:vibration|oscillation)s?"),
        (*(node / (2 * PI) for node in _NATURAL[:3]), omega / (2 * PI)),
        slips=("root", "turn"), mistakes=tuple(node / PI for node in _NATURAL[:3]),
        context=words(_VIBRATION), indices=letters("0 1 e n d eig E nat k"),
        unless=words(r"damp|gedämpf|減衰|pendul|pendel|振り子"),
    ),
    Quantity(
        "period of the free oscillation", letters("T tau"),
        words(r"natural\s+period", r"period\s+of\s+(?:the\s+)?(?:free\s+)?(?:vibration|oscillation)s?",
               r"schwingungsdauer", r"eigenperiode", r"periodendauer", r"固有周期"),
        (2 * PI * root(mass / stiffness), 2 * PI * root(inertia / stiffness), 2 * PI / omega,
         1 / frequency),
        slips=("power", "root", "turn"), unless=words(r"damp|gedämpf|減衰|pendul|pendel|振り子"),
    ),
    Quantity(
        "natural angular frequency of three equal discs", letters("omega Omega w p"), NATURAL_WORDS,
        (root(stiffness / inertia), root(3 * stiffness / inertia)), ("root", "part"),
        mistakes=(root(2 * stiffness / inertia), root(stiffness / (2 * inertia)),
                  root(stiffness / (3 * inertia)), root(3 * stiffness / (2 * inertia))),
        only=words(r"three\s+(?:equal|identical|like)\s+(?:dis[ck]s?|inertias|masses|rotors|flywheels)",
                   r"drei\s+gleichen?[nr]?\s+(?:scheiben|massen|drehmassen|schwungmassen"
                   r"|schwungscheiben)",
                   r"(?:等しい|同じ|同一の)(?:3|三|３)[つ個枚]?の?(?:円板|慣性)",
                   r"(?:3|三|３)[つ個枚]の(?:等しい|同じ|同一の)"
                   r"(?:円板|慣性)"),
        unless=words(r"fixed|clamped|eingespannt|固定|wall|einspannung|half|halb|damp|gedämpf|four"
        r"|vier|middle"
                     r" (?:one|dis[ck]) is|doppelt|twice"),
    ),
    Quantity(
        "natural angular frequency by the static deflection", letters("omega Omega w p"), NATURAL_WORDS,
        (root(gravity / static_deflection),), ("power", "root", "turn"),
        only=words(r"static(?:al)? deflection|deflection under (?:its own|the) weight"
                   r"|statischen?\s+(?:durchbiegung|einsenkung|durchsenkung)|静たわみ"),
        unless=words(r"pendul|pendel|振り子|damp|gedämpf|減衰"),
    ),
    Quantity(
        "damped natural angular frequency", letters("omega Omega w p"),
        words(r"damped\s+(?:natural\s+)?(?:angular\s+|circular\s+)?frequency",
              r"frequency\s+of\s+(?:the\s+)?damped\s+(?:vibration|oscillation)s?",
              r"gedämpfte\s+eigen(?:kreis)?frequenz",
              r"eigen(?:kreis)?frequenz\s+der\s+gedämpften\s+schwingung",
              r"減衰固有(?:角|円)?振動数"),
        (omega * root(1 - damping_ratio**2), root(omega**2 - decay**2)), ("edit", "root"),
        mistakes=(omega * (1 - damping_ratio), omega * root(1 - 2 * damping_ratio**2)),
        unless=words(r"undamped|ungedämpft|非減衰|resonan|peak|hysteretic|structural|loss factor"
        r"|verlustfaktor"),
    ),
    Quantity(
        "damping ratio", letters("D zeta xi vartheta theta"),
        words(r"damping\s+(?:ratio|factor)", r"lehr'?s?ches\s+dämpfungsmaß", r"dämpfungs(?:grad|maß)",
              r"減衰比"),
        (damping / (2 * root(mass * stiffness)), damping / (2 * mass * omega), decay / omega,
         damping / (2 * root(inertia * stiffness)), damping / (2 * inertia * omega),
         decrement / root(4 * PI**2 + decrement**2), damping * omega / (2 * stiffness)),
        ("factor", "power", "edit"), others=(decrement / (2 * PI),),
        unless=words(r"hysteretic|structural|loss factor|verlustfaktor|損失係数|material"),
    ),
    Quantity(
        "critical damping", letters("d c b r k"),
        words(r"critical\s+damping(?:\s+(?:constant|coefficient))?", r"kritische\s+dämpfung\w*",
              r"臨界減衰(?:係数)?", r"aperiodische\w*\s+grenzfall\w*", r"aperiodic\s+limit",
              r"critically\s+damped",
              r"ceases?\s+to\s+oscillate|just\s+(?:no\s+longer|not)\s+oscillat\w+", r"臨界減衰となる"),
        (2 * root(mass * stiffness), 2 * mass * omega, 2 * root(inertia * stiffness),
        2 * inertia * omega),
        ("factor", "power", "root"),
        mistakes=(root(2 * mass * stiffness), root(2 * inertia * stiffness)),
    ),
    Quantity(
        "logarithmic decrement", letters("Lambda delta vartheta theta"),
        words(r"log(?:arithmic|\.)?\s+decrement", r"logarithmisches?\s+dekrement", r"対数減衰率"),
        (2 * PI * damping_ratio / root(1 - damping_ratio**2), decay * period),
        ("factor", "edit"), others=(2 * PI * damping_ratio, decay / frequency),
        mistakes=(PI * damping_ratio, 2 * PI * damping_ratio * root(1 - damping_ratio**2),
                  2 * PI * damping_ratio / (1 - damping_ratio**2)),
    ),
    Quantity(
        "magnification of a forced vibration", letters("V M alpha mu beta Q R"),
        words(r"magnification(?:\s+(?:factor|function))?", r"(?:dynamic\s+)?amplification(?:\s+factor)?",
              r"vergrößerungs(?:funktion|faktor)", r"überhöhung(?:sfaktor)?", r"(?:振幅|動的)倍率",
              r"応答倍率"),
        (1 / root((1 - tuning**2) ** 2 + 4 * damping_ratio**2 * tuning**2),
         1 / root((1 - tuning**2) ** 2 + (2 * damping_ratio * tuning) ** 2), 1 / (1 - tuning**2)),
        ("edit",),
        mistakes=(1 / ((1 - tuning**2) ** 2 + 4 * damping_ratio**2 * tuning**2), 1 / (1 - tuning),
                  1 / root((1 - tuning**2) ** 2 + 2 * damping_ratio * tuning**2),
                  1 / root((1 - tuning**2) ** 2 + damping_ratio**2 * tuning**2),
                  1 / root((1 - tuning**2) ** 2 + 2 * damping_ratio * tuning)),
        others=(1 / (tuning**2 - 1), tuning**2 / (1 - tuning**2), tuning**2 / (tuning**2 - 1),
                tuning**2 / root((1 - tuning**2) ** 2 + 4 * damping_ratio**2 * tuning**2),
                root(1 + 4 * damping_ratio**2 * tuning**2)
                / root((1 - tuning**2) ** 2 + 4 * damping_ratio**2 * tuning**2)),
        unless=words(r"at resonance|in resonanz|bei resonanz|共振時|unbalance|unwucht|不釣合い|base"
        r"|fußpunkt|基礎"
                     r"|transmiss|loss factor|hysteretic"),
    ),
    Quantity(
        "magnification at resonance", letters("V M alpha mu beta Q R"),
        words(r"magnification(?:\s+factor)?\s+(?:at|in)\s+resonance", r"resonance\s+magnification",
              r"resonanzüberhöhung", r"共振倍率", r"vergrößerung\s+(?:bei|in)\s+resonanz"),
        (1 / (2 * damping_ratio),), ("factor", "power"),
        others=(1 / (2 * damping_ratio * root(1 - damping_ratio**2)),),
        unless=words(r"loss factor|verlustfaktor|hysteretic|structural"),
    ),
    Quantity(
        "critical speed of an order", letters("n N omega Omega"),
        words(r"critical\s+(?:engine\s+|shaft\s+)?speeds?", r"kritischen?\s+(?:motor)?drehzahl(?:en)?",
              r"resonanzdrehzahl(?:en)?", r"危険(?:回転数|速度|回転速度)", r"共振回転数"),
        (30 * omega / (PI * order), omega / (2 * PI * order), frequency / order, 60 * frequency / order,
         omega / order, rotation / order),
        ("turn", "exchange"),
        mistakes=(30 * omega * order / PI, 60 * frequency * order, frequency * order, omega * order,
                  omega * order / (2 * PI), 60 * order / frequency, 60 * omega / order,
                  30 * PI * omega / order, 60 * PI * omega / order),
        unless=words(r"whirl|biegekritisch|per\s+cycle|je\s+arbeitsspiel|per\s+two\s+(?:turns"
        r"|revolutions)|gear"),
    ),
    Quantity(
        "distance of the node of two discs", letters("a l x s L"),
        _NODE,
        (length * other_inertia / (own_inertia + other_inertia),), ("edit", "exchange"),
        mistakes=(shaft_length * other_inertia / own_inertia, shaft_length * own_inertia / other_inertia,
                  shaft_length * (own_inertia + other_inertia) / other_inertia,
                  shaft_length * other_inertia / (own_inertia - other_inertia)),
        together=(("", "own_inertia"),),
        subscripts=(("own_inertia", f"{_SIDES} e E m M k K"), ("other_inertia", f"{_SIDES} f F s S")),
        unless=words(_FROM_WHEEL, r"three|drei|三|3つ"
                     r"|from\s+(?:the\s+)?(?:second|right|dis[ck]\s+\$?[2B])"
                     r"|von\s+(?:der\s+)?(?:zweiten|rechten|scheibe\s+\$?2)"),
    ),
    Quantity(
        "period of a simple pendulum", letters("T tau"),
        words(r"(?:period|time)\s+of\s+(?:swing\s+of\s+)?(?:the|a)\s+(?:simple\s+"
        r"|mathematical\s+)pendulum",
              r"schwingungsdauer\s+(?:des|eines)\s+(?:mathematischen\s+|faden)pendels",
              r"単振り子の周期"),
        (2 * PI * root(length / gravity),), ("turn", "root", "power", "factor"),
        unless=words(r"half|halbe|半|compound|physical|physisch|beat"),
    ),
    Quantity(
        "period of a compound pendulum", letters("T tau"),
        words(r"(?:period|time)\s+of\s+(?:swing|(?:the|a)\s+(?:swing|oscillation|pendulum)"
        r"|the\s+(?:compound|physical)"
              r"\s+pendulum)", r"pendelzeit", r"schwingungsdauer\s+des\s+(?:physischen\s+)?pendels",
              r"(?:物理|複|実体)振り子の周期", r"振り子の周期"),
        (2 * PI * root(inertia / (mass * gravity * arm)), 2 * PI * root(length / gravity),
         2 * PI * root((gyration**2 + arm**2) / (gravity * arm))),
        ("turn", "root", "power", "factor"), unless=words(r"half|halbe|半|bifilar|trifilar|\bfilar"
        r"|torsion"),
    ),
    Quantity(
        "moment of inertia from a pendulum's period", letters("J I Theta"),
        words(r"(?:moment\s+of\s+)?inertia\s+(?:about|round)\s+(?:the|its)\s+(?:point|axis|axle"
        r"|knife edge)\s+of"
              r"\s+(?:suspension|support|swing)",
              r"trägheitsmoment\s+um\s+(?:den\s+aufhängepunkt|die\s+(?:pendel|aufhänge)achse"
              r"|die\s+schneide)",
              r"支点まわりの慣性モーメント"),
        (mass * gravity * arm * period**2 / (4 * PI**2), central + mass * arm**2),
        ("factor", "turn", "power"), unless=words(r"half|halbe|半|bifilar|trifilar"),
    ),
)  # fmt: skip
