"""Resonance curves: where their top is, how wide, what unbalance and excitation make of a mass."""

from __future__ import annotations

from symbalance.document.formula import Formula
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.meant.catalogue.roles import (
    PI,
    Quantity,
    damping_ratio,
    eccentricity,
    frequency,
    inertia,
    length,
    letters,
    mass,
    omega,
    root,
    section,
    stiffness,
    tuning,
    unbalanced,
    words,
    young,
)
from symbalance.notes.checking.meant.catalogue.shaft_roles import (
    driving,
    excitation,
    lower_point,
    mass_per_length,
    natural,
    resonant,
    upper_point,
)


def by_speeds(*formulas: Formula) -> tuple[Formula, ...]:
    """Return formulas with the frequency ratio written as ω/ω_0."""
    return tuple(substitute(node, "tuning", driving / natural) for node in formulas)


_UNBALANCE = words(r"unbalance|imbalance|unwucht|eccentric|exzentr|不釣|偏心")
_PEAK = words(
    r"\bpeak", r"\btop\b", r"maximum", r"resonan\w+", r"\bhöchst\w+", r"scheitel", r"größt\w+",
    r"共振\w*",
    r"極大", r"最大",
)  # fmt: skip
_NO_PEAK = r"unbalance|unwucht|velocity|geschwindigkeit|base|fußpunkt|hysteretic|damped natural|freie"
_WIDTH = words(r"half[- ]power|bandwidth|band ?width|halbwert|bandbreite|halbe leistung|半値|半パワー")
_UNIFORM_SHAFT = words(
    r"uniform|per (?:unit )?length|own weight|massenbelegung|glatte?n? welle|je länge|一様|単位長さ"
)
_SHAPES = root(young * section / mass_per_length)
_RELATIVE = tuning**2 / (1 - tuning**2)
_LEVER = unbalanced * eccentricity / mass
_TOP = root(1 - 2 * damping_ratio**2)

_MAGNIFIER = words(
    r"(?:(?:dynamic\s+)?magnifi(?:er|cation)(?:\s+(?:factor|function))?"
    r"|(?:dynamic\s+|resonan\w+\s+)?amplification(?:\s+(?:factor|dynami\w+))?"
    r"|quality\s+factor|Q[- ]factor"
    r"|vergrößerungs(?:funktion|faktor)|(?:resonanz)?überhöhung(?:sfaktor)?|\bgüte(?:faktor)?\b"
    r"|facteur\s+(?:de\s+qualité|d.amplification)"
    r"|fattore\s+(?:di\s+(?:qualità|merito)|d.amplificazione)"
    r"|factor\s+de\s+(?:calidad|amplificación)|(?:振幅|動的|応答)倍率|[QＱ]値)"
    r"(?:\s+(?:at|in|bei|à|alla|en|of)\s+(?:the\s+|der\s+|la\s+)?r[eé]?i?son\w+)?",
)
_AT_RESONANCE = words(
    r"\b(?:at|in|of)\s+(?:the\s+)?resonan\w+", r"\b(?:bei|in|im)\s+(?:der\s+)?resonanz",
    r"resonanzüberhöhung",
    r"à\s+la\s+résonance", r"(?:alla|in)\s+risonanza", r"en\s+(?:la\s+)?resonancia",
    r"共振(?:時|点|で|における)",
    r"\b(?:at|for|bei|für|à|pour|per|para)\s[$\s]{0,3}(?:\\?(?:rho|eta|beta|nu)|r|ρ|η|β)"
    r"\s?=\s?1(?![0-9.,]*[0-9])",
)  # fmt: skip

RESONANCE: tuple[Quantity, ...] = (
    Quantity(
        "magnification factor at resonance", letters("Q V M alpha mu beta R A"), _MAGNIFIER,
        (1 / (2 * damping_ratio),), ("edit", "bare factor"),
        others=(1 / (2 * damping_ratio * root(1 - damping_ratio**2)),),
        mistakes=(1 / damping_ratio, 2 * damping_ratio, 1 / (4 * damping_ratio),
                  1 / (2 * damping_ratio**2), 1 / damping_ratio**2, damping_ratio / 2),
        only=_AT_RESONANCE,
        unless=words(r"\bbase\b|fußpunkt|hysteretic|loss\s+factor|verlustfaktor|absorber|tilger"
                     r"|transmiss|half[- ]power|velocity|geschwindigkeit|unbalance|unwucht|不釣"),
    ),
    Quantity(
        "isolation of a mount", letters("i I eta epsilon s R"),
        words(r"isol(?:ation|ier\w*)(?:\s*(?:degree|efficiency|grad|wirkungsgrad))?", r"kept\s+away",
              r"ferngehalten", r"絶縁\w*", r"防振効率"),
        (1 - 1 / (tuning**2 - 1), (tuning**2 - 2) / (tuning**2 - 1)), ("edit",),
        mistakes=(1 - 1 / (tuning**2 + 1), 1 - 1 / (1 - tuning**2), 1 / (tuning**2 - 1),
                  1 - 1 / (tuning - 1), 1 + 1 / (tuning**2 - 1)),
        others=(1 / (tuning**2 - 1), 1 / (1 - tuning**2)),
        unless=words(r"(?<!un)damped|(?<!un)gedämpft|mit dämpfung|with damping|減衰を考慮"),
    ),
    Quantity(
        "transmissibility by the two frequencies", letters("T TR V tau K lambda"),
        words(r"transmissibilit\w+", r"force\s+transmi\w+", r"(?:kraft)?durchlässigkeit\w*",
              r"übertragungs(?:funktion|faktor|maß)", r"(?:力|振動)?の?伝達[率比]"),
        by_speeds(1 / (tuning**2 - 1), 1 / (1 - tuning**2)), ("edit",),
        mistakes=by_speeds(1 / (1 + tuning**2), 1 / (1 - tuning), 1 / (tuning - 1), tuning**2 - 1),
        others=by_speeds(_RELATIVE, tuning**2 / (tuning**2 - 1)),
        unless=words(r"loss factor|verlustfaktor|gear|getriebe"),
    ),
    Quantity(
        "magnification by the two frequencies", letters("V M alpha mu beta Q R"),
        words(r"magnification(?:\s+(?:factor|function))?", r"(?:dynamic\s+)?amplification(?:\s+factor)?",
              r"vergrößerungs(?:funktion|faktor)", r"überhöhung(?:sfaktor)?", r"(?:振幅|動的)倍率"),
        by_speeds(1 / (1 - tuning**2)), ("edit",),
        mistakes=by_speeds(1 / (1 + tuning**2), 1 / (1 - tuning)),
        others=by_speeds(1 / (tuning**2 - 1), _RELATIVE, tuning**2 / (tuning**2 - 1)),
        unless=words(r"at resonance|in resonanz|bei resonanz|共振時|unbalance|unwucht|不釣|base"
        r"|fußpunkt|transmiss"),
    ),
    Quantity(
        "amplitude by an unbalance", letters("X x A a y z hat_x"),
        words(r"amplitude", r"ausschlag", r"振幅", r"schwingt"),
        (_LEVER * _RELATIVE,), ("edit",),
        mistakes=(_LEVER / (1 - tuning**2), _LEVER * tuning / (1 - tuning**2), _LEVER * (1 - tuning**2),
                  _LEVER * tuning**2 / (1 + tuning**2), _LEVER * tuning**2),
        others=(_LEVER, _LEVER * tuning**2 / (tuning**2 - 1)),
        only=_UNBALANCE, unless=words(r"\bforce amplitude|kraftamplitude|力の振幅|transmi"),
    ),
    Quantity(
        "amplitude of a forced vibration", letters("X x A a y z hat_x theta Theta hat_theta hat_varphi"),
        words(r"amplitude", r"ausschlag", r"振幅"),
        (excitation / (stiffness - mass * omega**2), excitation / (stiffness - inertia * omega**2),
         excitation / (stiffness * (1 - tuning**2)), excitation / stiffness / (1 - tuning**2)), ("edit",),
        mistakes=(excitation / (stiffness + mass * omega**2), excitation / (stiffness + inertia
        * omega**2),
                  excitation / (stiffness * (1 + tuning**2)), excitation * stiffness / (1 - tuning**2),
                  excitation / (stiffness - mass * omega), excitation / (stiffness - inertia * omega),
                  excitation / (stiffness * (1 - tuning))),
        others=(excitation / (mass * omega**2 - stiffness), excitation / (inertia * omega**2 - stiffness),
                excitation / (stiffness * (tuning**2 - 1))),
        only=words(r"forced|harmonic|excit|erzwungen|erreg|強制|加振|driv(?:en|ing)"),
        unless=words(r"unbalance|unwucht|base|fußpunkt|two|zwei|absorber|tilger|hysteretic"
        r"|free vibration"),
    ),
    Quantity(
        "frequency ratio at the top of a resonance curve", letters("r eta beta nu"), _PEAK,
        (_TOP,), ("edit", "root"), mistakes=(root(1 - damping_ratio**2), 1 - 2 * damping_ratio**2),
        others=(1 / _TOP,), unless=words(_NO_PEAK),
    ),
    Quantity(
        "frequency of the top of a resonance curve", letters("omega Omega f"),
        words(r"resonan\w+\s+(?:angular\s+|circular\s+)?(?:frequency|speed)", r"peak\s+frequency",
              r"resonanz(?:kreis)?frequenz", r"共振(?:角|円)?振動数",
              r"(?:peak|maximum|top)\b(?=[^.]{0,40}\bat)"),
        (resonant * _TOP,), ("edit", "root"), others=(resonant / _TOP, resonant),
        mistakes=(resonant * (1 - 2 * damping_ratio**2),),
        only=words(r"\bpeak|maximum|\btop\b|largest|greatest|höchst|größt|scheitel|maximal|forced|erzwungen|最大"
                   r"|極大|強制"),
        unless=words(_NO_PEAK, r"damped\s+(?:natural\s+)?frequency|gedämpfte eigen|減衰固有"),
    ),
    Quantity(
        "height of a resonance curve", letters("V M Q R alpha"),
        words(_PEAK.pattern, r"\bheight", r"höhe", r"高さ"),
        (1 / (2 * damping_ratio * root(1 - damping_ratio**2)),), ("edit", "factor"),
        others=(1 / (2 * damping_ratio),),
        mistakes=(1 / (2 * damping_ratio * (1 - damping_ratio**2)), 1 / (damping_ratio
                  * root(1 - damping_ratio**2)), 1 / root(1 - damping_ratio**2)),
        unless=words(r"base|fußpunkt|hysteretic|damper|absorber|tilger"),
    ),
    Quantity(
        "damping ratio by the half-power points", letters("D zeta xi vartheta theta"),
        words(r"damping(?:\s+ratio)?", r"dämpfungs(?:grad|maß)", r"dämpfung", r"減衰比", r"lehr\w*"),
        ((upper_point - lower_point) / (2 * resonant),), ("factor", "edit", "part"),
        mistakes=((upper_point - lower_point) / resonant, (upper_point + lower_point) / (2 * resonant),
                  resonant / (2 * (upper_point - lower_point))),
        only=_WIDTH,
    ),
    Quantity(
        "quality factor by the half-power points", letters("Q V M"),
        words(r"quality(?:\s+factor)?", r"\bgüte(?:faktor)?", r"magnification", r"[QＱ]値"),
        (resonant / (upper_point - lower_point),), ("bare factor", "edit", "part"),
        mistakes=((upper_point - lower_point) / resonant, resonant / (upper_point + lower_point)),
        only=_WIDTH,
    ),
    Quantity(
        "stiffness by a natural frequency", letters("c k C K"),
        words(r"(?:torsional\s+|spring\s+|dynamic\s+)?stiffness", r"spring\s+(?:rate|constant)",
        r"feder(?:steifigkeit|konstante|rate)", r"ばね定数",
              r"(?:dreh)?steifigkeit"),
        (mass * omega**2, 4 * PI**2 * frequency**2 * mass, mass * (2 * PI * frequency) ** 2,
         inertia * omega**2, 4 * PI**2 * frequency**2 * inertia), ("turn", "power"),
        mistakes=(2 * PI * frequency**2 * mass, 4 * PI * frequency**2 * mass, 2 * PI * frequency * mass,
                  2 * PI * frequency**2 * inertia, 4 * PI * frequency**2 * inertia, mass / omega**2),
        only=words(r"natural|eigen|frequency|frequenz|固有|tuned|abgestimmt"),
        unless=words(r"each|\bone of|two|three|four|je(?:der|des|de)?\b|zwei|drei|vier|各|dynamic"),
    ),
    Quantity(
        "period of a damped oscillation", letters("T tau"),
        words(r"(?:damped\s+)?period", r"schwingungsdauer", r"periodendauer", r"周期"),
        (2 * PI / (omega * root(1 - damping_ratio**2)),), ("factor", "turn", "edit"),
        mistakes=(2 * PI * root(1 - damping_ratio**2) / omega, 2 * PI / (omega * (1 - damping_ratio**2)),
                  2 * PI / omega * (1 - damping_ratio**2)),
        only=words(r"(?<!un)damp(?!er)|(?<!un)gedämpf|dämpfung|減衰"),
        unless=words(r"undamped|ungedämpft|pendul|pendel"),
    ),
    Quantity(
        "whirling speed of a uniform shaft on two bearings", letters("omega Omega w p"),
        words(r"whirl\w*(?:\s+speed)?", r"(?:critical|lowest)\s+(?:\w+\s+)?(?:speed|frequency)",
        r"whirls",
              r"(?:biege)?kritische\w*\s+\w+", r"危険(?:角)?速度", r"natural\s+(?:\w+\s+)?frequency",
              r"eigen(?:kreis)?frequenz", r"固有(?:角|円)?振動数"),
        (PI**2 / length**2 * _SHAPES, PI**2 * root(young * section / (mass_per_length * length**4))),
        ("power", "factor", "edit"),
        mistakes=(PI / length * _SHAPES, PI / length**2 * _SHAPES, PI**2 / length * _SHAPES,
                  PI**2 * root(young * section / (mass_per_length * length**3)),
                  PI * root(young * section / (mass_per_length * length**4)),
                  PI**2 * root(mass_per_length * length**4 / (young * section)),
                  PI / 2 * root(young * section / (mass_per_length * length**4))),
        only=_UNIFORM_SHAFT,
        unless=words(r"clamped|built[- ]in|fixed|eingespannt|固定|cantilever|kragarm|overhung"
        r"|second(?!\s+moment)"
        r"|zweite|disc"
                     r"|scheibe|円板|free-free"),
    ),
)  # fmt: skip
