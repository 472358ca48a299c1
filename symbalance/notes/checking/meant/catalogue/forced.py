"""Forced vibrations, what is passed on to the ground, and dampers that are tuned or take up energy."""

from __future__ import annotations

from symbalance.document.formula import Call
from symbalance.notes.checking.meant.catalogue.roles import (
    PI,
    Quantity,
    damping,
    damping_ratio,
    eccentricity,
    inertia,
    letters,
    mass,
    omega,
    order,
    root,
    stiffness,
    tuning,
    words,
)
from symbalance.notes.checking.meant.catalogue.shaft_roles import (
    amplitude,
    bob,
    excitation,
    hang,
    mass_ratio,
    resonant,
)
from symbalance.notes.checking.meant.catalogue.strength import both

_SPREAD = (1 - tuning**2) ** 2
_LOSS = 2 * damping_ratio * tuning
_BELOW = _SPREAD + 4 * damping_ratio**2 * tuning**2
_PASSED = 1 + 4 * damping_ratio**2 * tuning**2
_ABSORBER = words(
    r"damper|absorber|tilger|den hartog|\bdämpfer|schwingungsdämpfer|動吸振|ダンパ|吸振器"
    r"|dynamic absorber"
)
_UNTUNED = r"houdaille|untuned|viscous|lanchester|viskos|random|white noise|base|ground|acceleration"
_PENDULUM = words(
    r"pendul(?:um|a)\b.{0,200}(?:absorber|crank|centrifugal|tuned|damper|order|hung)"
    r"|(?:centrifugal|absorber|crank|tuned).{0,200}pendul(?:um|a)\b"
    r"|fliehkraftpendel|tilgerpendel|pendeltilger|遠心振り?子"
)

FORCED: tuple[Quantity, ...] = (
    Quantity(
        "transmissibility of a mount", letters("T TR V tau K eta lambda i D"),
        words(r"transmissibilit\w+", r"transmission\s+(?:ratio|factor|coefficient)",
              r"(?:part|share|fraction|ratio)\s+of\s+the\s+force\s+(?:that\s+is\s+)?(?:passed|transmitted)",
              r"force\s+(?:passed\s+on|transmi\w+)", r"(?:kraft)?durchlässigkeit\w*",
              r"übertragungs(?:funktion|faktor|maß|verhältnis)", r"(?:力|振動)?の?伝達[率比]",
              r"transmisibilidad", r"trasmissibilità",
              r"(?:part|share|fraction|ratio)\s+of\s+the\s+(?:\w+\s+){0,2}force\s+(?:that|which)\s+(?:reaches|is"
              r"\s+(?:passed|transmitted)|gets|goes)",
              r"force\s+(?:that|which)\s+reaches\s+the\s+(?:ground|foundation|floor)",
              r"anteil\s+der\s+(?:\w+)?kraft\w*", r"(?:基礎|床)に伝わる力の(?:割合|比)"),
        (root(_PASSED / _BELOW), root(_PASSED) / root(_BELOW), root((1 + _LOSS**2) / (_SPREAD
        + _LOSS**2)),
         1 / (tuning**2 - 1), 1 / (1 - tuning**2)),
        ("edit",),
        mistakes=(_PASSED / root(_BELOW), root(_PASSED) / _BELOW, _PASSED / _BELOW, 1 / root(_BELOW),
                  (1 + _LOSS) / root(_BELOW), root(1 + _LOSS) / root(_BELOW), root(_BELOW / _PASSED),
                  root(_PASSED / (_SPREAD - _LOSS**2)), 1 / (1 + tuning**2), 1 / (1 - tuning),
                  1 / (tuning - 1), tuning**2 - 1, 1 - tuning**2, 1 / (1 - tuning**2) ** 2,
                  root((tuning**2 + _LOSS**2) / (_SPREAD + _LOSS**2)),
                  root((1 + (_LOSS / 2) ** 2) / (_SPREAD + (_LOSS / 2) ** 2)),
                  root((1 + _LOSS**2) / ((1 + tuning**2) ** 2 + _LOSS**2))),
        others=(tuning**2 / (1 - tuning**2), tuning**2 / (tuning**2 - 1),
                tuning**2 * root(_PASSED) / root(_BELOW), (tuning**2 - 2) / (tuning**2 - 1)),
        unless=words(r"hysteretic|structural damping|loss factor|verlustfaktor|損失係数"
        r"|isolation efficiency"
                     r"|isoliergrad|gear|getriebe|magnification"),
    ),
    Quantity(
        "phase angle of a forced vibration",
        letters("phi varphi psi epsilon varepsilon delta alpha theta"),
        words(r"phase(?:\s+(?:angle|lag|shift|difference))?", r"phasen(?:winkel|verschiebung\w*|lage)",
              r"\blag(?:s|ging)?\b", r"nacheil\w*", r"eilt\b.{0,60}\bnach", r"位相(?:角|差|遅れ)?"),
        (Call("atan", _LOSS / (1 - tuning**2)),
         Call("atan", damping * omega / (stiffness - mass * omega**2))),
        ("edit",),
        mistakes=(Call("atan", damping_ratio * tuning / (1 - tuning**2)),
                  Call("atan", (1 - tuning**2) / _LOSS), Call("atan", _LOSS / (1 - tuning)),
                  Call("atan", 2 * damping_ratio / (1 - tuning**2)),
                  Call("atan", damping * omega / (stiffness + mass * omega**2)),
                  Call("atan", damping / (stiffness - mass * omega**2))),
        others=(Call("atan", _LOSS / (tuning**2 - 1)), Call("atan", -_LOSS / (1 - tuning**2)),
                Call("atan", damping * omega / (mass * omega**2 - stiffness)),
                Call("atan", (1 - tuning**2) / -_LOSS)),
        unless=words(r"base|fußpunkt|基礎|hysteretic|structural|velocity|geschwindigkeit|transmi"
                     r"|free vibration|freie schwingung|first and second|crank"),
    ),
    Quantity(
        "lag of a forced vibration behind its force",
        letters("phi varphi psi epsilon varepsilon delta alpha theta"),
        words(r"(?:phase\s+)?lags?\b", r"\blag(?:s|ging)?\b", r"nacheil\w*",
        r"phase(?:\s+(?:angle|lag|shift|difference))?",
              r"phasen(?:winkel|verschiebung\w*|nacheil\w*|lage)", r"位相(?:角|差|遅れ)?"),
        (Call("atan", _LOSS / (1 - tuning**2)),
         Call("atan", damping * omega / (stiffness - mass * omega**2))),
        ("edit", "factor"),
        mistakes=(Call("atan", _LOSS / (tuning**2 - 1)), Call("atan",
        damping_ratio * tuning / (1 - tuning**2)),
                  Call("atan", damping * omega / (mass * omega**2 - stiffness)), Call("atan",
                  _LOSS / (1 + tuning**2)),
                  Call("atan", (1 - tuning**2) / _LOSS)),
        only=words(r"\blag(?:s|ging)?\b|\bbehind\b|retard|nacheil|hinter|遅れ|retraso|ritardo|atraso"),
        unless=words(r"base|fußpunkt|基礎|hysteretic|structural|velocity|geschwindigkeit|transmi"
                     r"|free vibration|freie schwingung|first and second|crank|lead|vor(?:eil|aus)"),
    ),
    Quantity(
        "bow of a shaft that whirls", letters("y r x w f delta a"),
        words(r"deflection", r"\bbow", r"amplitude", r"whirl\w*", r"(?:wellen)?auslenkung",
        r"durchbiegung",
              r"たわみ", r"振れ回り\w*"),
        (eccentricity * tuning**2 / (1 - tuning**2), mass * omega**2 * eccentricity
         / (stiffness - mass * omega**2), eccentricity / (stiffness / (mass * omega**2) - 1),
         eccentricity / (1 / tuning**2 - 1)),
        ("edit",),
        mistakes=(eccentricity / (1 - tuning**2), eccentricity * tuning / (1 - tuning**2),
                  eccentricity * tuning**2 / (1 + tuning**2), eccentricity * (1 - tuning**2),
                  mass * omega**2 * eccentricity / (stiffness + mass * omega**2),
                  stiffness * eccentricity / (stiffness - mass * omega**2)),
        others=(eccentricity * tuning**2 / (tuning**2 - 1),
                mass * omega**2 * eccentricity / (mass * omega**2 - stiffness)),
        only=words(r"whirl|eccentric|exzentr|unwucht|unbalance|biegekritisch|偏心|ふれ|振れ"),
        unless=words(r"cent(?:re|er) of (?:gravity|mass)\b.{0,40}\b(?:moves|is|has|runs|describes|lies"
        r"|from)\b"
                     r"|radius of the cent|bahn des schwerpunkt|重心の(?:軌道|変位)|(?<!un)damp(?!er)"
                     r"|(?<!un)gedämpf|static"),
    ),
    Quantity(
        "energy lost per cycle in a viscous damper", letters("W E D A Delta_E Delta_W U Q"),
        words(r"per\s+(?:vibration|oscillation|cycle)(?:\s+it)?\s+is|energy|heat|wärme|熱|\bwork|\bloss|dissipat\w+|arbeit|energie|verlust|エネルギー?|仕事"),
        (PI * damping * omega * amplitude**2,), ("factor", "power", "part"),
        mistakes=(PI * damping * omega**2 * amplitude**2, damping * omega**2 * amplitude**2 / 2,
                  PI * damping * omega * amplitude,
                  PI * damping * omega**2 * amplitude),
        only=words(r"\A(?=(?s:.*?)(?:damp|dämpf|減衰|dashpot|viscous|friction|hysteres))(?s:.*?)"
                   r"(?:per (?:full )?(?:cycle|period|oscillation|vibration|turn|swing)"
                   r"|(?:each|one|a) cycle"
                   r"|(?:je|pro) (?:periode|schwingung|zyklus)|[1一](?:周期|サイクル))"),
        unless=words(r"power (?!lost|dissipated|absorbed)|leistung|動力|half a cycle|quarter"
        r"|hysteretic|peak[- ]to[- ]peak"
        r"|four pistons"),
    ),
    Quantity(
        "power lost in a viscous damper", letters("P W N L"),
        words(r"(?:mean\s+|average\s+)?power\s+(?:lost|dissipated|absorbed|consumed)(?:\s+(?:in|by)\s+(?:a|the)"
              r"\s+(?:viscous\s+)?damper)?", r"(?:mean\s+|average\s+)?damp(?:er|ing)\s+power",
              r"(?:mittlere\s+)?(?:dämpfungs|verlust|dämpfer)leistung",
              r"(?:減衰器?の?)?(?:消費|散逸|損失)動力"),
        (damping * omega**2 * amplitude**2 / 2,), ("factor", "power"),
        mistakes=(damping * omega * amplitude**2 / 2, damping * omega * amplitude / 2),
        only=words(r"damp|dämpf|減衰|dashpot|viscous"),
        unless=words(r"hysteretic|structural|friction|reibung|peak[- ]to[- ]peak"
                     r"|relative\s+amplitude\s+is"),
    ),
    Quantity(
        "amplitude of the angle by one harmonic of the torque",
        letters("Theta theta Phi phi varphi A X hat_theta"),
        words(r"amplitude\s+of\s+(?:the\s+)?(?:angle|twist|rotation|θ|theta|φ|phi)",
              r"ang(?:ular|le)\s+amplitude", r"winkelamplitude", r"amplitude\s+des\s+(?:dreh)?winkels",
              r"角(?:度|変位)?(?:の)?振幅"),
        (excitation / (inertia * order**2 * omega**2),), ("power",),
        only=words(r"harmonic|\border|harmonisch|ordnung|次|調和|single torque"),
        unless=words(r"stiffness|spring|steif|feder|ばね|剛性|resonan|relative"),
    ),
    Quantity(
        "amplitude of the speed by one harmonic of the torque",
        letters("Omega omega Delta_omega dot_theta hat_omega"),
        words(r"(?:angular\s+)?(?:speed|velocity)\s+amplitude",
              r"amplitude\s+of\s+(?:the\s+)?(?:angular\s+)?(?:speed|velocity)",
              r"(?:drehzahl|geschwindigkeits|winkelgeschwindigkeits)(?:amplitude|schwankung)",
              r"(?:角速度|回転速度)(?:の)?振幅"),
        (excitation / (inertia * order * omega),), ("power",),
        mistakes=(excitation / (inertia * order**2 * omega),),
        only=words(r"harmonic|\border|harmonisch|ordnung|次|調和|single torque"),
        unless=words(r"stiffness|spring|steif|feder|ばね|剛性|resonan|relative"),
    ),
    Quantity(
        "work of an excitation per cycle at resonance", letters("W E A Delta_E Delta_W U"),
        words(r"energy|\bwork|input|arbeit|energie|エネルギー?|仕事"),
        (PI * excitation * amplitude,), ("factor", "part"),
        mistakes=(PI * excitation * amplitude**2, excitation * amplitude),
        only=both(words(r"resonan|resonanz|90\W{0,3}(?:°|degrees|\^|grad)|quarter\s+(?:of\s+a\s+)?(?:cycle|period)|共振"),
                  words(r"(?:per|in (?:one|a|each)|during (?:one|a|each)|over (?:one"
                  r"|a)) (?:full )?(?:cycle|period|vibration"
                        r"|oscillation)|(?:je|pro) (?:schwingung|periode)|[1一](?:周期|サイクル)")),
        unless=words(r"power|leistung|動力|all cylinders|sum|gas"),
    ),
    Quantity(
        "natural frequency of an absorber with optimum tuning", letters("omega Omega f"),
        words(r"frequency", r"frequenz", r"振動数", r"tun(?:ed|es|ing)", r"abgestimmt"),
        (resonant / (1 + mass_ratio),), ("edit",),
        mistakes=(resonant * (1 + mass_ratio), resonant / (1 - mass_ratio), resonant * (1 - mass_ratio)),
        others=(resonant / root(1 + mass_ratio),), only=both(_ABSORBER, words(r"optim|den hartog|最適")),
        unless=words(r"houdaille|untuned|lanchester|random|white noise|acceleration"),
    ),
    Quantity(
        "optimum tuning of an absorber", letters("f alpha kappa delta nu beta gamma r eta q lambda g"),
        words(r"optim\w+\s+(?:tuning|frequency\s+ratio)",
        r"ratio\s+of\s+the\s+\w+'s\s+(?:natural\s+)?frequency",
              r"tuning(?:\s+(?:ratio|condition|rule))?", r"tuned", r"(?:optimale\s+)?abstimmung\w*",
              r"最適同調\w*", r"最適(?:固有)?振動数比"),
        (1 / (1 + mass_ratio),), ("edit",),
        mistakes=(1 / (1 - mass_ratio), 1 + mass_ratio, mass_ratio / (1 + mass_ratio), 1 - mass_ratio,
                  1 / (1 + mass_ratio) ** 2, 1 / mass_ratio, 1 / (1 + 2 * mass_ratio)),
        others=(1 / root(1 + mass_ratio), root(1 + mass_ratio), root(1 - mass_ratio / 2) / (1
        + mass_ratio)),
        only=_ABSORBER, unless=words(_UNTUNED),
    ),
    Quantity(
        "optimum damping of a tuned absorber", letters("zeta D xi vartheta theta delta ∕"),
        words(r"optim\w+\s+damping(?:\s+ratio)?", r"damping\s+optim\w+", r"damping(?:\s+ratio)?",
        r"optimale\s+dämpfung\w*",
              r"dämpfungs(?:grad|maß)", r"最適減衰比?"),
        (root(3 * mass_ratio / (8 * (1 + mass_ratio) ** 3)),), ("edit", "root"),
        mistakes=(root(3 * mass_ratio / (8 * (1 + mass_ratio) ** 2)), 3 * mass_ratio
                  / (8 * (1 + mass_ratio) ** 3), root(8 * mass_ratio / (3 * (1 + mass_ratio) ** 3)),
                  root(3 / (8 * (1 + mass_ratio) ** 3)),
                  root(3 * mass_ratio / (8 * (1 - mass_ratio) ** 3)),
                  root(3 * mass_ratio / (4 * (1 + mass_ratio) ** 3))),
        others=(root(3 * mass_ratio / (8 * (1 + mass_ratio))), root(mass_ratio / (8 * (1 + mass_ratio))),
                root(3 * mass_ratio / 8)),
        only=_ABSORBER, unless=words(_UNTUNED),
    ),
    Quantity(
        "optimum damping of a viscous ring", letters("zeta D xi vartheta theta delta"),
        words(r"optim\w+\s+damping(?:\s+ratio)?", r"damping(?:\s+ratio)?", r"optimale\s+dämpfung\w*",
              r"dämpfungs(?:grad|maß)", r"最適減衰比?"),
        (1 / root(2 * (1 + mass_ratio) * (2 + mass_ratio)),), ("edit", "root"),
        mistakes=(1 / root((1 + mass_ratio) * (2 + mass_ratio)), root(2 * (1 + mass_ratio)
                  * (2 + mass_ratio)), 1 / (2 * (1 + mass_ratio) * (2 + mass_ratio))),
        only=words(r"houdaille|untuned|viscous (?:torsional )?(?:vibration )?damper|lanchester"
        r"|viskos\w*dämpfer"
                   r"|viskositätsdämpfer|ビスカス"),
    ),
    Quantity(
        "greatest magnification with the best viscous ring", letters("M V A Q R ∕"),
        words(r"magnification|amplification|peak|vergrößerung\w*|überhöhung|倍率"),
        (1 + 2 / mass_ratio, (2 + mass_ratio) / mass_ratio), ("edit", "factor"),
        mistakes=(root(1 + 2 / mass_ratio), 1 + mass_ratio / 2, 2 / mass_ratio, 1 + 1 / mass_ratio,
                  1 - 2 / mass_ratio, 2 + 1 / mass_ratio),
        only=words(r"houdaille|untuned|viscous (?:torsional )?(?:vibration )?damper|lanchester"
        r"|viskos\w*dämpfer"
                   r"|viskositätsdämpfer|ビスカス"),
        unless=words(r"den hartog|tuned mass|fixed points|tilger"),
    ),
    Quantity(
        "order to which a pendulum is tuned", letters("n q i k m j p N nu"),
        words(r"\border", r"\bordnung(?:szahl)?", r"次数", r"tun(?:ed|ing)", r"abgestimmt", r"abstimm\w*",
              r"同調"),
        (root(hang / bob),), ("root", "edit", "turn"), mistakes=(root(bob / hang), hang / bob,
        bob / hang, root((hang + bob) / bob)),
        others=(root((hang - bob) / bob), root(hang / bob - 1)),
        only=_PENDULUM, unless=words(r"roller|bifilar|spring|feder|ばね|radius of gyration"
        r"|trägheitsradius"),
    ),
    Quantity(
        "natural angular frequency of a pendulum on a turning crank", letters("omega Omega w p"),
        words(r"natural\s+(?:angular\s+|circular\s+)?frequency", r"frequency", r"eigen(?:kreis)?frequenz",
              r"固有(?:角|円)?振動数"),
        (omega * root(hang / bob),), ("root", "edit", "power", "turn"),
        mistakes=(omega * root(bob / hang), omega * hang / bob, omega * root((hang + bob) / bob)),
        only=_PENDULUM, unless=words(r"roller|bifilar|spring|feder|ばね|gravity|erdschwere|重力"),
    ),
)  # fmt: skip
