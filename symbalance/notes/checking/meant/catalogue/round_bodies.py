"""Round bodies by their density: areas, masses and inertia of discs and rings, the stress of a rim."""

from __future__ import annotations

from symbalance.notes.checking.meant.catalogue.roles import (
    PI,
    Quantity,
    density,
    diameter,
    inner,
    inner_radius,
    length,
    letters,
    omega,
    outer,
    outer_radius,
    radius,
    velocity,
    wall_of_weight,
    words,
)

_RING = r"hollow|\bbored\b|annul|\brings?\b|hohl|ring|中空|円環|内径"
_RIM = words(
    r"\brims?\b|flywheel|schwung(?:rad|ring)|kranz|rotating|umlaufend|リム|はずみ車|フライホイール"
)
_THICKNESSES = (wall_of_weight, length)
_INERTIA = words(
    r"(?:mass\s+)?moment\s+of\s+inertia", r"(?:massen)?trägheitsmoment", r"慣性モーメント",
    r"(?:solid\s+|steel\s+|round\s+|full\s+|voll)?(?:dis[ck]|scheibe)\b", r"円板",
)  # fmt: skip
_HOLLOW_DISC = words(
    r"(?:hollow|annular|bored)\s+(?:dis[ck]|cylinder|wheel|shaft)", r"(?:hohl|ring)(?:scheibe|zylinder)",
    r"\brings?\b", r"中空(?:円板|円筒)",
)  # fmt: skip
_NO_DISC = (
    r"about\s+(?:a|its|the)\s+diameter|transverse|spoke|speich|cone|kegel|half|halb|sector|sektor|半円"
    r"|sphere|kugel|second\s+moment\s+of\s+area|flächenträgheit|断面"
)

_ABOUT_AXLE = (
    r"axis\s+of\s+(?:rotation|revolution|symmetry)|(?:its|the)\s+(?:own\s+)?(?:axle|axis)\b"
    r"|drehachse|symmetrieachse|autour\s+de\s+son\s+axe|(?:中心|回転)軸"
)
"""Words for the axis of a disc about which it turns, by which no diameter is meant."""

ROUND_BODIES: tuple[Quantity, ...] = (
    Quantity(
        "hoop stress of a turning rim", letters("sigma S f"),
        words(r"hoop\s+stress(?:\s+(?:of|in)\s+(?:a|the)\s+(?:thin\s+)?(?:rim|ring))?",
              r"(?:centrifugal|tensile|circumferential)\s+stress\s+(?:of|in)\s+(?:a|the)\s+(?:thin\s+)?(?:rim|ring)",
              r"(?:umfangs|kranz|tangential)spannung", r"(?:zug)?spannung\s+im\s+(?:kranz|schwungring)",
              r"(?:フープ|円周|周方向)応力"),
        (density * velocity**2, density * radius**2 * omega**2), ("bare factor", "power", "part"),
        only=_RIM, unless=words(r"thick|dick|厚|solid\s+dis[ck]|vollscheibe|pressure|druck|圧力|spoke"
                                r"|specific\s+weight"),
        is_told_once=True,
    ),
    Quantity(
        "area of a half disc", letters("A S F"),
        words(r"area\s+of\s+(?:the|a|each|one)\s+(?:half[- ]?(?:dis[ck]|circle)|semi-?circ\w+)",
              r"(?:half[- ]?dis[ck]|semi-?circular)\s+area",
              r"(?:fläche\s+(?:der|einer)\s+halb(?:scheibe|kreis\w*)"
              r"|halbkreisfläche|fläche\s+des\s+halbkreises)", r"半円(?:板)?の面積"),
        (PI * radius**2 / 2, PI * diameter**2 / 8), ("factor", "power", "part"),
        others=(PI * radius**2, PI * diameter**2 / 4),
        mistakes=(PI * radius**2 / 4, PI * diameter**2 / 16),
        unless=words(r"quarter|viertel|hole|bohrung|minus|less\s+the"),
    ),
    Quantity(
        "area of a ring", letters("A S F"),
        words(r"(?:cross[- ]?section(?:al)?\s+|annular\s+|ring\s+)?area"
              r"(?:\s+of\s+(?:the|a)\s+(?:ring|annulus"
              r"|hollow\s+\w+))?", r"(?:ringfläche|ringquerschnitt|querschnitt(?:sfläche)?)",
              r"(?:断面積|環状面積)"),
        (PI * (outer**2 - inner**2) / 4, PI * (outer_radius**2 - inner_radius**2)), ("factor", "edit"),
        only=words(_RING), unless=words(r"half|halb|半|two\s+rings|sector"),
    ),
    Quantity(
        "moment of inertia of a disc by its density", letters("J I Theta"), _INERTIA,
        tuple(node for b in _THICKNESSES
              for node in (PI * density * b * radius**4 / 2, PI * density * b * diameter**4 / 32)),
        ("factor", "power"),
        others=tuple(node for b in _THICKNESSES
              for node in (PI * density * b * radius**4 / 4, PI * density * b * diameter**4 / 64)),
        only=words(r"\A(?=(?s:.*?)(?:densit|dichte|密度|ρ|\\rho))(?s:.*?)"
                   r"(?:\bdis[ck]s?\b|scheibe|円板|円盤|cylinder|zylinder|flywheel|schwung)"),
        unless=words(_NO_DISC, r"\brims?\b|kranz", _ABOUT_AXLE),
    ),
    Quantity(
        "moment of inertia of a hollow disc by its density", letters("J I Theta"), _HOLLOW_DISC,
        tuple(node for b in _THICKNESSES for node in (
            PI * density * b * (outer_radius**4 - inner_radius**4) / 2,
            PI * density * b * (outer**4 - inner**4) / 32)),
        ("factor", "edit"), unless=words(_NO_DISC),
    ),
    Quantity(
        "mass of a hollow disc", letters("m M"),
        words(r"mass\s+of\s+(?:the|a)\s+(?:\w+\s+){0,2}(?:dis[ck]|ring|rim|cylinder|wheel|tube)",
              r"masse\s+(?:der|des|einer|eines)\s+\w*(?:scheibe|kranzes|rings?|zylinders)",
              r"(?:円環|リム|円板|中空円板|中空円筒)の質量"),
        tuple(node for b in _THICKNESSES for node in (
            PI * density * b * (outer_radius**2 - inner_radius**2),
            PI * density * b * (outer**2 - inner**2) / 4)),
        ("factor", "edit"), unless=words(r"half|halb|半|sector|sektor|spoke|speich"),
    ),
)  # fmt: skip
