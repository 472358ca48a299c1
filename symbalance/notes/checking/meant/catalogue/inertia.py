"""Moments of inertia of discs, rings and rods, and the masses that stand for a connecting rod."""

from __future__ import annotations

from symbalance.document.formula import number
from symbalance.notes.checking.meant.catalogue.roles import (
    PI,
    Quantity,
    area,
    central,
    density,
    diameter,
    far,
    gyration,
    height,
    inertia,
    inner,
    inner_radius,
    length,
    letters,
    mass,
    near,
    outer,
    outer_radius,
    radius,
    rod,
    root,
    section,
    shift,
    width,
    words,
)
from symbalance.notes.checking.meant.catalogue.strength import HOLLOW, both

_NO_DISC = (
    r"hollow|hohl|annul|\bbored|\brims?\b|hoop|kranz|リング|円環|リム|中空"
    r"|two dis[ck]|dis[ck]s|scheiben\b"
    r"|about (?:a|its|the) diam"
    r"|durchmesserachse|直径(?:軸|まわり|を軸)"
    r"|tapered|kegel|\bpins?\b|zapfen|gyration|trägheitsradius|回転半径"
    r"|\bedge|point\b|piston|kolben|ピストン|\bcrank|kurbel|クランク|reduced|reduziert|換算|eccentric|exzent"
    r"|offset"
    r"|parallel axis|steiner|second moment of area|flächenträg|断面"
    r"|half|halb(?!messer)|半円|sector|sektor|pulley|riemenscheibe"
)
_ABOUT_AXLE = (
    r"(?:about|round|around)\s+(?:its|the)\s+(?:own\s+)?(?:axle|axis|shaft|cent(?:re|er)\s?line)\b"
    r"|um\s+(?:ihre|seine|die)\s+(?:eigene\s+)?(?:dreh|symmetrie)?achse\b|autour\s+de\s+son\s+axe"
    r"|(?:attorno|rispetto)\s+al\s+(?:proprio\s+|suo\s+)?asse|alrededor\s+de\s+su\s+eje"
    r"|(?:中心|回転)軸(?:まわり|周り|の)"
)
"""Words for the axis of a disc about which it turns, not one of its diameters."""
INERTIA: tuple[Quantity, ...] = (
    Quantity(
        "moment of inertia of a disc about its axis", letters("J I Theta"),
        words(r"\b(?:solid\s+)?dis[ck]\b", r"solid\s+cylinder",
        r"(?:voll|kreis|schwung)?scheibe\b", r"vollzylinder",
               r"円板", r"円盤"),
        (mass * radius**2 / 2, mass * diameter**2 / 8),
        others=(mass * radius**2 / 4, mass * diameter**2 / 16, 3 * mass * radius**2 / 2,
                3 * mass * diameter**2 / 8),
        unless=words(HOLLOW, r"pulley|riemenscheibe|プーリ",
        r"\brims?\b|hoop|kranz|リング|円環|リム|two dis[ck]|dis[ck]s|scheiben\b"
        r"|about (?:a|its) "
                      r"diameter|durchmesserachse|直径軸|直径まわり|直径を軸|tapered|kegel"
                      r"|\bpins?\b|zapfen"
                      r"|gyration"
                      r"|trägheitsradius|回転半径|edge|point on"),
    ),
    Quantity(
        "moment of inertia of a disc about its axle", letters("J I Theta"),
        words(r"\bdis[ck]\b", r"(?:mass\s+)?moment\s+of\s+inertia", r"(?:voll|kreis|schwung)?scheibe\b",
              r"disque\b", r"\bdisco\b", r"円板", r"円盤"),
        (mass * radius**2 / 2, mass * diameter**2 / 8),
        mistakes=(mass * radius**2 / 4, mass * diameter**2 / 16, mass * radius**2, mass * diameter**2 / 4,
                  mass * diameter**2 / 2, mass * radius / 2, 2 * mass * radius**2 / 5,
                  mass * diameter**2 / 10),
        only=both(words(r"\bdis[ck]\b|scheibe\b|disque\b|\bdisco\b|円板|円盤"),
                  words(_ABOUT_AXLE)),
        unless=words(_NO_DISC), together=(("", "mass"),),
    ),
    Quantity(
        "moment of inertia of a solid disc", letters("J I Theta"),
        words(r"(?:mass\s+)?moment\s+of\s+inertia", r"\binertia", r"(?:massen)?trägheitsmoment",
              r"慣性モーメント"),
        (mass * radius**2 / 2, mass * diameter**2 / 8), ("factor", "power"),
        others=(mass * radius**2 / 4, mass * diameter**2 / 16, 3 * mass * radius**2 / 2),
        only=words(r"(?:solid|full|plain|uniform|homogeneous|steel|cast[- ]iron|round)"
                   r"\s+(?:\w+\s+)?dis[ck]\b"
                   r"|(?:voll|schwung|stahl|guss|kreis|rund)scheibe\b|"
                   r"(?:homogene|volle|massive|runde)\s+scheibe"
                   r"|dis[ck]\s+of\s+(?:\w+\s+)?(?:radius|diameter|steel|[0-9])"
                   r"|dis[ck][^.;\n]{0,30}(?:thick|diameter)"
                   r"|scheibe[^.;\n]{0,30}(?:durchmesser|dick)|円板"),
        unless=words(_NO_DISC, _ABOUT_AXLE), together=(("", "mass"),),
    ),
    Quantity(
        "moment of inertia of a thin ring about its axis", letters("J I Theta"),
        words(r"thin\s+(?:ring|rim|hoop)", r"\bhoop\b", r"dünner?n?\s+(?:ring|kranz|reifen)",
        r"薄い(?:円環|リング)",
               r"細い(?:円環|リング)"),
        (mass * radius**2, mass * diameter**2 / 4),
        others=(mass * radius**2 / 2, mass * diameter**2 / 8, 2 * mass * radius**2),
        unless=words(r"dis[ck]|scheibe|円板|diameter of|about (?:a|its) diameter|thick|dick(?!e)"
        r"|hollow|hohl"),
    ),
    Quantity(
        "moment of inertia of a thin rod about its centre", letters("J I Theta"),
        words(r"(?:thin|slender|uniform)\s+(?:rod|bar)\s+about\s+(?:its|the)\s+(?:cent(?:re|er)"
        r"|middle|centroid)",
               r"(?:dünner|schlanker)\s+stab(?:es)?\s+um\s+(?:seine\s+mitte|den\s+schwerpunkt)",
               r"細い棒の(?:重心|中心)まわりの慣性モーメント"),
        (mass * length**2 / 12,), others=(mass * length**2 / 3,), unless=words(r"\bend\b|\bende\b|端"
        r"|half|halb"),
    ),
    Quantity(
        "moment of inertia of a thin rod about its end", letters("J I Theta"),
        words(r"(?:thin|slender|uniform)\s+(?:rod|bar)\s+about\s+(?:its|the|one)\s+end",
               r"(?:dünner|schlanker)\s+stab(?:es)?\s+um\s+(?:sein|ein|das)\s+ende",
               r"細い棒の(?:一)?端まわりの慣性モーメント"),
        (mass * length**2 / 3,), others=(mass * length**2 / 12,),
        unless=words(r"cent(?:re|er)|middle|mitte|schwerpunkt|重心|中心|half|halb"),
    ),
    Quantity(
        "moment of inertia about a parallel axis", letters("J I Theta"),
        words(r"parallel[- ]axis", r"steiner(?:scher?)?(?:\s+satz)?", r"平行軸(?:の定理)?"),
        (central + mass * shift**2,), slips=("power of a term",), others=(central - mass * shift**2,),
    ),
    Quantity(
        "moment of inertia of a hollow cylinder about its axis", letters("J I Theta"),
        words(r"hollow\s+(?:cylinder|dis[ck]|shaft)", r"(?:annular|bored)\s+dis[ck]",
              r"hohl(?:zylinder|welle)",
              r"\b(?:(?:thick|steel|cast[- ]iron)\s+)?(?<!piston )(?<!slip )rings?\b", r"\brims?\b",
              r"(?:kreis|stahl|schwung|guss)ring(?:e?s|scheibe)?\b", r"\b(?:schwung|rad)?kranz(?:es)?\b",
              r"ringscheibe", r"中空円[筒柱板]", r"円環", r"リム", r"リング"),
        (mass * (outer_radius**2 + inner_radius**2) / 2, mass * (outer**2 + inner**2) / 8),
        ("factor", "edit"),
        mistakes=(mass * (outer_radius**2 - inner_radius**2) / 2, mass * (outer**2 - inner**2) / 8),
        others=(mass * (outer_radius**2 + inner_radius**2) / 4, mass * (outer**2 + inner**2) / 16),
        unless=words(r"about (?:a|its) diameter|durchmesserachse|直径|thin|dünn|薄"),
    ),
    Quantity(
        "moment of inertia of a ring about the axis that it turns about", letters("J I Theta"),
        words(r"about\s+(?:its|the)\s+(?:own\s+)?axis(?:\s+of\s+(?:rotation|symmetry))?",
              r"um\s+(?:ihre|seine|die)\s+(?:dreh)?achse"),
        (mass * (outer_radius**2 + inner_radius**2) / 2, mass * (outer**2 + inner**2) / 8),
        ("factor", "edit"),
        mistakes=(mass * (outer_radius**2 - inner_radius**2) / 2, mass * (outer**2 - inner**2) / 8,
                  mass * (outer_radius**4 - inner_radius**4) / 2,
                          mass * (outer_radius + inner_radius) ** 2 / 2,
                  mass * (outer_radius**2 + inner_radius**2),
                          mass * (outer_radius**2 + inner_radius**2) / 4),
        only=words(r"hollow\s+(?:cylinder|dis[ck]|shaft)|(?:annular|bored)\s+dis[ck]|\brims?\b|\brings?\b|hohlzylinder"
                   r"|(?:schwung|rad)?kranz|ringscheibe|中空円[筒柱板]|円環|リム"),
        unless=words(r"mean (?:radius|diameter)|mittlere[rnm]? (?:radius|halbm|durchm)"
                     r"|平均", r"about (?:a|its|the) diameter|durchmesserachse|直径(?:軸|まわり)"
                     r"|thin|dünn|薄"
                     r"|arms|spokes|speichen|\bhub\b|nabe"),
        is_told_once=True,
    ),
    Quantity(
        "moment of inertia of a solid cylinder about a line across it", letters("J I Theta"),
        words(r"(?:mass\s+)?moment\s+of\s+inertia(?:[^.;=$]{0,90}(?:axis|axe|asse|eje|achse|cylinder|zylinders?)\b)?",
              r"(?:massen)?trägheitsmoment(?:[^.;=$]{0,90}(?:achse|zylinders?)\b)?", r"慣性モーメント"),
        tuple(mass * radius**2 / 4 + mass * each**2 / 12 for each in (height, length)), ("edit",),
        mistakes=tuple(
            wrong
            for each in (height, length)
            for wrong in (
                mass * radius**2 / 2 + mass * each**2 / 12, mass * radius**2 / 4 + mass * each**2 / 3,
                mass * (radius**2 + each**2) / 12, mass * (3 * radius**2 - each**2) / 12,
                        mass * radius**2 / 2,
            )
        ),
        only=both(
            words(r"cylinder|zylinder|cylindre|cilindr|円[柱筒]"),
            words(r"(?:perpendicular|at\s+right\s+angles|normal|transverse|perpendicol\w+|perpendiculaire|ortogonal\w*)"
                  r"[^.;]{0,30}(?:axis|axe|asse|eje|shaft)|(?:senkrecht|quer)\s+zu[rm]?\s+(?:\w+\s+)?\w*achse|querachse"
                  r"|軸に(?:垂直|直角)"),
            words(r"cent(?:re|er|roid)|middle|schwerpunkt|mitte|baricentr|gravit|重心|中心"),
        ),
        unless=words(r"hollow|hohl|中空|\bend\b|\bface\b|\bbase\b|stirnfl|\bende\b|端|cavo|creux"
                     r"|hueco|diameter of|piston"),
        is_told_once=True,
    ),
    Quantity(
        "moment of inertia by the radius of gyration", letters("J I Theta"),
        words(r"radius\s+of\s+gyration", r"trägheits(?:radius|halbmesser)", r"(?:慣性|回転)半径"),
        (mass * gyration**2,), ("power",),
        unless=words(r"area|fläche|断面|parallel|steiner|平行軸"),
    ),
    Quantity(
        "mass by its radius of gyration", letters("m M"),
        words(r"\bmass\b", r"\bmasse\b", r"質量", r"\bmasa\b", r"\bmassa\b"),
        (inertia / gyration**2,), ("power",), mistakes=(inertia * gyration**2,),
        only=words(r"radius\s+of\s+gyration", r"trägheits(?:radius|halbmesser)", r"(?:慣性|回転)半径",
                   r"rayon\s+de\s+giration", r"radio\s+de\s+giro", r"raggio\s+(?:giratore|d.inerzia)"),
        unless=words(r"area|fläche|断面|parallel|steiner|平行軸"),
    ),
    Quantity(
        "radius of gyration", letters("k i r rho"),
        words(r"radius\s+of\s+gyration", r"trägheits(?:radius|halbmesser)", r"(?:慣性|回転)半径"),
        (root(inertia / mass),), ("power", "root"),
        others=(root(section / area), diameter / root(number(8)), radius / root(number(2))),
    ),
    Quantity(
        "radius of gyration of a ring between two radii", letters("k i r rho"),
        words(r"radius\s+of\s+gyration", r"trägheits(?:radius|halbmesser)", r"(?:慣性|回転)半径"),
        (root((outer_radius**2 + inner_radius**2) / 2), root((outer**2 + inner**2) / 8)), ("edit",),
        others=(root(outer_radius**2 + inner_radius**2) / 2, root(outer**2 + inner**2) / 4),
        only=words(r"hollow|hohl|\bbored\b|annul|\brings?\b|\w+ring(?:es)?\b|\brims?\b|kranz|中空|円環|リム"),
        unless=words(r"about\s+(?:a|its|the)\s+diameter|durchmesserachse|直径(?:軸|まわり)|\barea\b|fläche"
                     r"|断面"),
    ),
    Quantity(
        "mass of a round disc", letters("m M"),
        words(r"mass\s+of\s+(?:the|a)\s+(?:\w+\s+)?dis[ck]",
        r"masse\s+(?:der|einer)\s+(?:voll|kreis)?scheibe",
              r"円板の質量"),
        (PI * density * diameter**2 * width / 4, PI * density * radius**2 * width,
         PI * density * diameter**2 * height / 4, PI * density * radius**2 * height),
        ("factor", "power"), unless=words(HOLLOW, r"\brims?\b|kranz|cone|kegel"),
    ),
    Quantity(
        "centre part of a rod in three masses", letters("Delta_J J I Delta_I Theta"),
        words(r"(?:correction|correcting)\s+(?:moment|couple|inertia|term)(?:\s+of\s+inertia)?",
              r"(?:difference|error|defect)\s+(?:of|in)\s+(?:the\s+)?moments?\s+of\s+inertia",
              r"korrektur(?:moment|trägheitsmoment|glied)", r"zusatzträgheitsmoment",
              r"(?:慣性モーメントの)?補正(?:量|項)?"),
        (mass * (gyration**2 - near * far), mass * (near * far - gyration**2),
         central - mass * near * far, mass * near * far - central),
        ("edit",), unless=words(r"about the (?:pin|end)|um den zapfen"),
    ),
    Quantity(
        "part of a rod's mass at one end", letters("m M"),
        words(r"(?:rotating|reciprocating|oscillating)\s+(?:part|share|portion)\s+of\s+(?:the"
        r"|its)\s+(?:connecting[- ])?rod",
              r"(?:rotierender|oszillierender)\s+(?:pleuel)?(?:massen)?anteil(?:\s+(?:des|der)\s+\w+)?",
              r"連接棒の(?:回転|往復)(?:部分の)?質量"),
        (mass * near / rod, mass * far / rod, mass * (rod - near) / rod, mass * (rod - far) / rod,
         mass * near / (near + far), mass * far / (near + far)),
        ("edit",), others=(mass * near / far, mass * far / near),
        unless=words(r"percussion|stoßmittelpunkt|打撃|statistic"),
    ),
)  # fmt: skip
