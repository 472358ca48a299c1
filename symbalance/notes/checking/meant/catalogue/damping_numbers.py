"""How little a vibration is damped, as one number: the quality factor, the decrement of a light damping.

With them the second mode of three equal discs, √3 times as fast as the first.
"""

from __future__ import annotations

from symbalance.notes.checking.meant.catalogue.cycle_roles import gain
from symbalance.notes.checking.meant.catalogue.roles import (
    PI,
    Quantity,
    damping,
    damping_ratio,
    decay,
    decrement,
    inertia,
    letters,
    mass,
    omega,
    root,
    stiffness,
    words,
)
from symbalance.notes.checking.meant.catalogue.strength import both

_EXACT_DECREMENT = 2 * PI * damping_ratio / root(1 - damping_ratio**2)
_LIGHT = words(
    r"\b(?:small|light(?:ly)?|weak(?:ly)?|slight(?:ly)?|low)\b", r"schwach\w*", r"gering\w*",
    r"kleine\w*",
    r"\\ll\b", r"≪", r"<<", r"小さ", r"微小", r"弱い", r"faibl\w*", r"petite?s?", r"debol\w*",
    r"piccol\w*",
    r"pequeñ\w*", r"débil\w*", r"approx\w*", r"roughly", r"näherung\w*", r"近似", r"environ", r"\bnearly",
)  # fmt: skip
_THREE_EQUAL = words(
    r"(?:three|3)\s+(?:equal|identical|like|similar)\s+(?:\w+\s+)?(?:dis[ck]s?|inertias|masses|rotors"
    r"|flywheels)",
    r"drei\s+(?:gleichen?[nr]?|identischen?[nr]?)\s+(?:scheiben|massen|drehmassen|schwungmassen"
    r"|schwungscheiben)",
    r"(?:等しい|同じ|同一の)(?:3|三|３)[つ個枚]?の?(?:円板|慣性)",
    r"(?:3|三|３)[つ個枚]の(?:等しい|同じ|同一の)(?:円板|慣性)",
    r"trois\s+(?:disques|volants|inerties)\s+(?:identiques|égaux|égales)",
    r"tre\s+(?:dischi|volani)\s+(?:uguali|identici)", r"tres\s+(?:discos|volantes)\s+(?:iguales"
    r"|idénticos)",
)  # fmt: skip

DAMPING_NUMBERS: tuple[Quantity, ...] = (
    Quantity(
        "quality factor", letters("Q"),
        words(r"(?:quality|q)[ -]?factor", r"gütefaktor", r"\bgüte\b", r"facteur\s+(?:de"
            r"|of)\s+(?:qualité|surtension)",
              r"fattore\s+(?:di|of)\s+(?:qualità|merito)", r"factor\s+(?:de|of)\s+calidad", r"[QＱ]値"),
        (1 / (2 * damping_ratio), root(mass * stiffness) / damping, mass * omega / damping,
         root(inertia * stiffness) / damping, inertia * omega / damping, stiffness / (damping * omega),
         PI / decrement, omega / (2 * decay)),
        ("factor", "bare factor", "power", "part", "root"),
        others=(1 / (2 * damping_ratio * root(1 - damping_ratio**2)),
                root(1 - damping_ratio**2) / (2 * damping_ratio),
                root(1 - 2 * damping_ratio**2) / (2 * damping_ratio)),
        unless=words(r"loss\s+factor|verlustfaktor|hysteretic|structural\s+damping|損失係数"
                     r"|facteur\s+de\s+pertes?"),
    ),
    Quantity(
        "damping ratio by the quality factor", letters("D zeta xi vartheta theta"),
        words(r"damping\s+(?:ratio|factor)", r"lehr'?s?ches\s+dämpfungsmaß", r"dämpfungs(?:grad|maß)",
              r"減衰比", r"taux\s+d.amortissement"),
        (1 / (2 * gain),), ("factor", "power", "part"), others=(1 / gain,),
        only=words(r"(?:quality|q)[ -]?factor|güte|facteur\s+(?:de|of)\s+qualité|fattore\s+(?:di|of)"
            r"|factor\s+(?:de|of)\s+calidad"
                   r"|[QＱ]値"),
        unless=words(r"loss\s+factor|verlustfaktor|hysteretic|損失係数"),
    ),
    Quantity(
        "logarithmic decrement of a light damping", letters("Lambda delta vartheta theta"),
        words(r"log(?:arithmic|\.)?\s+decrement", r"logarithmisches?\s+dekrement", r"対数減衰率",
              r"décrément(?:\s+logarithmique)?", r"decremento(?:\s+logar[ií]tmico)?"),
        (2 * PI * damping_ratio,), ("factor", "turn", "power"),
        approximate=(2 * PI * damping_ratio,),
        others=(_EXACT_DECREMENT,),
        mistakes=(PI * damping_ratio, damping_ratio / (2 * PI), 2 * PI / damping_ratio,
        2 * damping_ratio),
        only=_LIGHT,
        unless=words(r"half\s+(?:a\s+)?(?:cycle|period)|halbe\s+(?:periode|schwingung)|半周期|半サイクル"
                     r"|demi-?période|successive\s+(?:extrem|peaks\s+of\s+opposite)"),
    ),
    Quantity(
        "natural angular frequency of the second mode of three equal discs", letters("omega Omega w p"),
        words(r"second\s+(?:(?:torsional|natural)\s+)?(?:mode|(?:natural\s+)?frequency)",
              r"two[- ]node\s+mode", r"zweite\w*\s+(?:eigen\w+|schwingungsform|mode?)", r"zweiknotig\w*",
              r"[二2２]次(?:の)?(?:モード|固有\w*)", r"(?:second|deuxième)\s+mode",
              r"secondo\s+modo", r"segundo\s+modo"),
        (root(3 * stiffness / inertia),), ("factor", "root", "part"),
        mistakes=(root(2 * stiffness / inertia), root(stiffness / inertia), 3 * stiffness / inertia,
                  root(stiffness / (2 * inertia)), root(stiffness / (3 * inertia)),
                  root(3 * stiffness / (2 * inertia)), root(9 * stiffness / inertia)),
        only=both(_THREE_EQUAL),
        unless=words(r"fixed|clamped|eingespannt|固定|einspannung|damp|gedämpft|減衰|four\b|vier\b"
                     r"|middle\s+(?:one|dis[ck])\s+(?:is|has)\s+(?:twice|double|half|larger|heavier"
                     r"|an?other)"
                     r"|doppelt|unequal|different\s+(?:stiff|inert)|geared|getriebe"),
        is_told_once=True,
    ),
)  # fmt: skip
