"""Rotors: stresses of turning discs, critical speeds, what unbalances do to mounts and bearings."""

from __future__ import annotations

from symbalance.notes.checking.meant.catalogue.roles import (
    PI,
    Quantity,
    crank,
    damping_ratio,
    density,
    diameter,
    eccentricity,
    far,
    force,
    frequency,
    grade,
    length,
    letters,
    mass,
    near,
    omega,
    order,
    radius,
    root,
    rotation,
    section,
    tuning,
    unbalanced,
    velocity,
    words,
    young,
)
from symbalance.notes.checking.meant.catalogue.shaft_roles import driving, natural
from symbalance.notes.checking.meant.catalogue.strength import both
from symbalance.notes.checking.meant.catalogue.trains import CRITICAL_WORDS
from symbalance.notes.checking.meant.catalogue.vibration_roles import (
    couple_arm,
    eccentric_mass,
    machine_mass,
    poisson,
    span,
)

_TURNING = words(
    r"rotat|spinning|\bburst|rim\s+speed|flywheel|schwungrad|umfangsgeschw|tourn|volant|volano|girator|周速|はずみ車|turns?\b|turning|revolv|rotier|umlauf|dreht|drehend|回転"
)
_FULL_DISC = words(
    r"(?:solid|full|uniform|flat|thin)\s+(?:\w+\s+){0,2}(?:dis[ck]|cylinder|wheel)",
    r"voll(?:e|en)?\s?scheibe",
    r"scheibe\s+gleicher\s+dicke", r"中実(?:円板|円盤)",
    r"dis[ck]\s+of\s+(?:uniform|constant|equal)\s+thickness",
    r"一様(?:な)?(?:厚さの)?円板",
    r"dis[ck]\s+without\s+(?:a\s+)?(?:hole|bore)", r"scheibe\s+ohne\s+bohrung",
    r"disque\s+plein", r"disco\s+(?:pieno|macizo|lleno)", r"穴のない円板",
)  # fmt: skip
_CENTRAL = density * omega**2 * radius**2
_BY_SPEED = density * velocity**2
_WRONG_SHARES = (
    (3 + poisson) / 4, (3 + poisson) / 16, (3 - poisson) / 8, (1 + 3 * poisson) / 8, (1 - poisson) / 8,
)  # fmt: skip
"""What the largest stress of a full disc is taken for: that beside a small hole is twice as large."""
_MIDDLE = words(
    r"middle", r"\bmid(?:dle|way|span)", r"cent(?:re|er)\b", r"central(?:ly)?", r"mitte|mittig",
    r"中央", r"half\s+way",
)  # fmt: skip
_CLAMPED = (
    r"clamped|built[- ]in|fixed\s+(?:at|ends?)|eingespannt|固定|cantilever|kragarm|einseitig"
    r"|overhung|fliegend|片持"
)
_SAGGING = words(r"deflection", r"\bsag", r"durchbiegung", r"einsenkung", r"たわみ")
_OFF_CENTRE = force * near**2 * far**2 / (3 * young * section * length)
_BEAM = 48 * young * section
_UNBALANCE = words(r"unbalance|imbalance|unwucht|eccentric|exzentr|不釣|偏心")
_BELOW = root((1 - tuning**2) ** 2 + (2 * damping_ratio * tuning) ** 2)
_LEVER = eccentric_mass * eccentricity / machine_mass
_BY_MASSES = eccentric_mass * eccentricity * tuning**2 / machine_mass / _BELOW
_COUPLE = unbalanced * crank * omega**2 * couple_arm / span
_ABOVE = words(
    r"above\s+(?:the\s+)?(?:natural|resonan|critical)", r"ü?über\s?kritisch\w*",
    r"oberhalb\s+de[rs]\s+(?:resonanz|eigen)",
    r"supercritical", r"共振(?:点)?より(?:上|高)|固有振動数より(?:上|高|大)",
)  # fmt: skip
_POSITIVE = words(r"positive|magnitude|absolute|\bsize\b|betrag|positiv|絶対値|大きさ|正の")
_RATIO = driving / natural
_SQUARE = _RATIO**2
_MEETS = words(
    r"resonan\w*", r"\bmeets?\b", r"critical", r"natural\s+(?:\w+\s+)?frequency", r"kritisch",
    r"eigenfrequenz", r"共振", r"固有",
    r"危険",
)  # fmt: skip

ROTORS: tuple[Quantity, ...] = (
    Quantity(
"largest stress of a turning full disc", letters("sigma S"), words(r"stress", r"spannung",
        r"応力", r"contrainte", r"tensione", r"tensión"),
        ((3 + poisson) / 8 * _CENTRAL, (3 + poisson) / 8 * _BY_SPEED),
        ("factor", "power", "edit", "part"),
        mistakes=(*(n * each for n in _WRONG_SHARES for each in (_CENTRAL, _BY_SPEED)),
                  (3 + poisson) / 8 * density * omega**2 * diameter**2),
        others=((1 - poisson) / 4 * _CENTRAL, (1 - poisson) / 4 * _BY_SPEED),
        only=both(_TURNING, _FULL_DISC),
        unless=words(r"(?<!without\sa\s)(?<!no\s)(?:\bhole\b|\bbore\b(?!\s?[=|:]))|\bbored\b|(?<!ohne\s)(?:bohrung|loch\b)|gebohrt|hollow|hohl"
                     r"|中空|穴(?!のな|がな|なし)|annul|\bring\b|kreisring|plane\s+strain|ebener\s+verzerrung|forat[oa]|percé"
                     r"|long\s+cylinder|\brims?\b(?!\s+(?:speed|velocity))|am\s+rand|at\s+the\s+edge|外周(?!速)"),
    ),
    Quantity(
        "critical speed of a disc in the middle of a shaft on two bearings",
        letters("omega Omega w p"), words(CRITICAL_WORDS.pattern, r"critical\s+\w+\s+speed"),
        (root(_BEAM / (mass * length**3)),), ("root", "power", "factor"),
        mistakes=(root(3 * young * section / (mass * length**3)),
        root(192 * young * section / (mass * length**3)),
                  root(_BEAM / (mass * length**2)), root(24 * young * section / (mass * length**3)),
                  root(_BEAM / (mass * length**4)), root(8 * young * section / (mass * length**3))),
        only=both(_MIDDLE, words(r"bearing|support|lager|gestützt|aufliegend|軸受|支持")),
        unless=words(_CLAMPED, r"uniform\s+shaft|two\s+dis[ck]s|zwei\s+scheiben|own\s+mass"),
    ),
    Quantity(
        "deflection under a load between two bearings", letters("delta f y w x s v"), _SAGGING,
        (_OFF_CENTRE,), ("power", "factor", "part"),
        mistakes=(force * near**2 * far**2 / (48 * young * section * length),
                  force * near**2 * far**2 / (6 * young * section * length),
                  force * near * far / (3 * young * section * length),
                  force * near**3 * far**3 / (3 * young * section * length**3),
                  force * near**2 * far**2 * length / (3 * young * section)),
        only=words(r"bearings?|supports?|lagern?|stützen|軸受|支点|支持"),
        unless=words(_CLAMPED, r"largest|greatest|maxim|größte|最大|in\s+the\s+middle|in\s+der\s+mitte"
        r"|two\s+loads"),
    ),
    Quantity(
        "bow of a whirling shaft by its critical speed", letters("y r x w f delta a"),
        words(r"deflection", r"\bbow", r"amplitude", r"whirl\w*", r"(?:wellen)?auslenkung",
        r"durchbiegung", r"たわみ",
              r"振れ回り\w*", r"bends?"),
        (eccentricity * _SQUARE / (1 - _SQUARE), eccentricity / (1 / _SQUARE - 1)), ("edit",),
        mistakes=(eccentricity / (1 - _SQUARE), eccentricity * _SQUARE / (1 + _SQUARE),
                  eccentricity * _RATIO / (1 - _RATIO), eccentricity * _RATIO / (1 - _SQUARE)),
        others=(eccentricity * _SQUARE / (_SQUARE - 1), eccentricity / (_SQUARE - 1)),
        only=words(r"whirl|eccentric|exzentr|unwucht|unbalance|biegekritisch|偏心|ふれ|振れ|cent(?:re|er)\s+of\s+(?:mass|gravity)"
                   r"|schwerpunkt|重心"),
        unless=words(r"above|supercritical|überkritisch|oberhalb|(?<!un)damp(?!er)|(?<!un)gedämpf|static"
                     r"|(?:distance|path|orbit)\s+of\s+the\s+cent|bahn\s+des\s+schwerpunkt|重心の(?:軌道|変位)"),
    ),
    Quantity(
        "amplitude of a machine by a rotating unbalance", letters("X x A a y z hat_x"),
        words(r"amplitude", r"ausschlag", r"振幅", r"schwingt"),
        (_BY_MASSES, _LEVER * tuning**2 / (1 - tuning**2)), ("edit",),
        mistakes=(_LEVER / _BELOW, _LEVER * tuning / _BELOW, _LEVER * tuning**2 / _BELOW**2,
                  machine_mass * eccentricity / eccentric_mass * tuning**2 / _BELOW,
                  _LEVER * tuning**2 / root((1 - tuning**2) ** 2 + 2 * damping_ratio * tuning),
                  _LEVER * tuning**2 / root((1 + tuning**2) ** 2 + (2 * damping_ratio * tuning) ** 2),
                  _LEVER * tuning**2 / root((1 - tuning**2) ** 2 + (damping_ratio * tuning) ** 2),
                  _LEVER / (1 - tuning**2), _LEVER * tuning / (1 - tuning**2)),
        others=(_LEVER, _LEVER * tuning**2 / (tuning**2 - 1)),
        only=words(_UNBALANCE.pattern, r"rotating\s+mass|umlaufende\s+masse"),
        unless=words(r"\bforce amplitude|kraftamplitude|力の振幅|transmi|two\s+(?:rotating\s+)?masses"
        r"|zwei"),
    ),
    Quantity(
        "permissible unbalance by the turns per minute", letters("U"),
        words(r"(?:permissible|residual|allowable|admissible)\s+(?:\w+\s+)?(?:unbalance|imbalance)",
              r"(?:zulässige\w*\s+)?(?:rest)?unwucht", r"許容(?:残留)?不釣り?合い"),
        (30000 * grade * mass / (PI * rotation),), ("factor", "turn", "power", "exchange"),
        mistakes=(30 * grade * mass / (PI * rotation), PI * rotation * grade * mass / 30000,
                  60000 * grade * mass / (PI * rotation), 30000 * grade / (PI * rotation * mass),
                  30000 * mass / (PI * rotation * grade), 1000 * grade * mass / rotation),
        only=both(words(r"rev/min|r/min|\brpm|min\^|1/min|min-1|/min|毎分"),
        words(r"g\W{0,6}mm|gmm|グラム")),
        unless=words(r"each\s+plane|per\s+plane|je\s+ebene|各面|kg\W{0,6}m\b"),
    ),
    Quantity(
        "force of a couple of unbalances on each of two bearings", letters("F R P S A B N Q"),
        words(r"(?:bearing\s+)?(?:force|load|reaction)", r"(?:lager)?(?:kraft|last|reaktion)",
        r"(?:軸受)?(?:反力|荷重|力)"),
        (_COUPLE,), ("power", "part"),
        mistakes=(unbalanced * crank * omega**2 * span / couple_arm, 2 * _COUPLE, _COUPLE / 2,
        2 * unbalanced * crank * omega**2,
                  unbalanced * crank * omega**2, unbalanced * crank * omega * couple_arm / span),
        only=both(words(r"bearing|lager|軸受"),
                  words(r"opposite|opposed|entgegengesetzt|gegenüber\w*|diametral\w*|couple|momentenunwucht|180|反対|対向|偶")),
        unless=words(r"same\s+side|gleiche\s+seite|overhung|fliegend|three|drei|four|vier"),
    ),
    Quantity(
        "magnification above the natural frequency", letters("V M alpha mu beta Q R"),
        words(r"magnification(?:\s+(?:factor|function))?", r"magnifier",
        r"(?:dynamic\s+)?amplification(?:\s+factor)?",
              r"vergrößerungs(?:funktion|faktor)", r"(?:振幅|動的)倍率",
              r"(?:divided\s+by|over|to|in\s+units\s+of)\s+the\s+static\s+\w+", r"static\s+deflection",
              r"静たわみ"),
        (1 / (_SQUARE - 1), 1 / (tuning**2 - 1)), ("edit", "minus"),
        mistakes=(1 / (1 - _SQUARE), 1 / (1 / _SQUARE - 1), _SQUARE / (_SQUARE - 1), 1 / (_RATIO - 1),
        1 / (_SQUARE + 1),
                  1 / (1 - tuning**2), tuning**2 / (tuning**2 - 1), 1 / (tuning - 1),
                  1 / (tuning**2 + 1)),
        only=both(_ABOVE, _POSITIVE),
        unless=words(r"unbalance|unwucht|不釣|base|fußpunkt|基礎|transmiss|(?<!un)damped|(?<!un)gedämpft"),
    ),
    Quantity(
        "engine speed of resonance with an order", letters("n N"),
        words(r"(?:engine\s+|shaft\s+|crankshaft\s+|critical\s+|rotational\s+)*speed",
        r"revolutions(?:\s+per\s+minute)?",
              r"(?:resonanz|motor|kritische\s+)*drehzahl", r"(?:機関|危険|共振)?回転(?:数|速度)"),
        (60 * frequency / order, 30 * omega / (PI * order)), ("turn", "part"),
        mistakes=(60 * frequency * order, frequency / (60 * order), 30 * frequency / order,
        120 * frequency / order,
                  60 * frequency / (2 * PI * order), 30 * frequency / (PI * order), 60 * omega / order,
                  30 * PI * omega / order,
                  60 * order / frequency, 30 * omega * order / PI),
        only=both(words(r"rev/min|r/min|\brpm|per\s+min|1/min|min\^|min-1|/min|毎分"),
        words(r"order|ordnung|次数?|per\s+revolution"), _MEETS),
        unless=words(r"whirl|biegekritisch|per\s+cycle|je\s+arbeitsspiel|per\s+two\s+(?:turns"
        r"|revolutions)|gear|getriebe|half[- ]speed"
                     r"|camshaft|nockenwelle|four[- ]stroke|viertakt|working\s+cycle|of\s+two\s+turns"
                     r"|arbeitsspiel|サイクル"),
    ),
)  # fmt: skip
