"""Locomotives: tractive force, swaying couple and wheels; one cylinder's force at its dead centres."""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Number
from symbalance.notes.checking.meant.catalogue.crank_drive import COS_CRANK, SIN_CRANK
from symbalance.notes.checking.meant.catalogue.roles import (
    Quantity,
    arm_of_weight,
    balance_mass,
    base_force,
    diameter,
    letters,
    mass,
    omega,
    pin,
    pitch,
    radius,
    ratio,
    root,
    share,
    velocity,
    wheel_load,
    words,
)
from symbalance.notes.checking.meant.catalogue.strength import both

_TWO_CRANKS = words(r"locomotive|lokomotiv|機関車|swaying|schlinger|tractive|zugkraft|牽引|けん引")
_UNLIKE_SHARE = words(
    r"unbalanced (?:fraction|share|part|portion)|fraction (?:that is )?(?:left|unbalanced)|restanteil"
    r"|trough|crest|peak[- ]to[- ]peak|\brange\b|double amplitude|share left|remains unbalanced is"
    r"|three[- ]cylinder|dreizylinder|3気筒|four[- ]cylinder|120"
)
_LEFT = (1 - share) * mass * pin * omega**2
_TAKEN = share * mass * pin * omega**2
_ROOT = root(Number(Fraction(2)))
_FORCE = mass * pin * omega**2
_BALANCE_FACTOR = words(
    r"balance factor|balancing factor|balanc(?:e|es|ed|ing) (?:the|a) (?:share|fraction|part)"
    r"|(?:share|fraction|part) (?:\\?\$?\w+\$? )?of the reciprocating mass\w*(?: \w+)? (?:is"
    r"|are) balanced|counterweight β|überbalanc|overbalance|balance (?:degree|ratio|rate)"
    r"|ausgleichs(?:grad|faktor)"
    r"|(?:釣り?合い|つりあい|バランス)率"
)
_NO_BALANCE = words(r"rotating mass|rotierende|回転質量|second cylinder|V-twin")
_LIFTS = (
    r"(?:leaves\s+the\s+rail|(?:begins|starts)\s+to\s+lift(?:\s+off(?:\s+the\s+rails?)?)?"
    r"|(?:wheel\s+)?lift(?:s|ing)?(?:\s+off|\s+of\s+the\s+wheel|\s+from)?(?:\s+the\s+rails?)?"
    r"|hebt\s+(?:das\s+rad\s+)?ab|abheben|浮き上がる?り?|quitte\s+(?:le|the)\s+rail|se\s+soulève|décolle"
    r"|si\s+(?:solleva|stacca)|se\s+(?:levanta|despega))"
)

LOCOMOTIVES: tuple[Quantity, ...] = (
    Quantity(
        "variation of the tractive force of two cranks at right angles",
        letters("F T P Delta_T Delta_F Z Delta_P Delta_Z"),
        words(r"(?:max(?:imum|imal|\.)?|greatest|largest|peak)?\s*(?:variation|fluctuation"
              r"|change)s?\s+(?:of|in)"
              r"\s+(?:the\s+)?tractive\s+(?:force|effort)s?", r"tractive\s+(?:force|effort)\s+variation",
              r"zugkraftschwankung(?:en)?", r"schwankung\s+der\s+zugkraft",
              r"(?:variation|fluctuation|change|unevenness)s?\s+(?:of"
              r"|in)\s+(?:the\s+)?(?:draw-?bar\s+)?(?:pull|traction)", r"(?:けん引|牽引)力の?変動"),
        (_LEFT * (COS_CRANK - SIN_CRANK), _ROOT * _LEFT), ("edit", "factor", "power", "part"),
        others=(_LEFT * (COS_CRANK + SIN_CRANK), _LEFT * (SIN_CRANK - COS_CRANK)),
        mistakes=(_ROOT * _TAKEN, _TAKEN * (COS_CRANK - SIN_CRANK), _ROOT * (1 + share) * _FORCE,
                  _LEFT / _ROOT, _LEFT, 2 * _LEFT),
        unless=_UNLIKE_SHARE, stated=frozenset({"share"}),
    ),
    Quantity(
        "swaying couple of two cranks at right angles", letters("C M S T L Delta_C Delta_M"),
        words(r"(?:max(?:imum|imal|\.)?|greatest|largest|peak)?\s*swaying\s+(?:couple|moment)s?",
              r"schlinger(?:paar|moment)", r"(?:yawing|nosing)\s+(?:couple|moment)",
              r"couple\s+that\s+(?:makes|sways)[^.=]{0,30}?(?:sway|nos)\w*",
                  r"(?:nods?|sways?|swings?)\s+from\s+side\s+to\s+side[^.=]{0,30}?(?:couple"
                  r"|moment)(?:\s+is)?", r"(?:蛇行|首振り)(?:偶力|モーメント)"),
        (_LEFT * (pitch / 2) * (COS_CRANK + SIN_CRANK), _LEFT * pitch / _ROOT),
        ("edit", "factor", "power", "part"),
        others=(_LEFT * (pitch / 2) * (COS_CRANK - SIN_CRANK), _LEFT * pitch * (COS_CRANK + SIN_CRANK),
                _LEFT * (pitch / 2) * (SIN_CRANK - COS_CRANK)),
        mistakes=(_TAKEN * pitch / _ROOT, _ROOT * _LEFT * pitch, _LEFT * pitch / 2, _LEFT * pitch,
                  _TAKEN * (pitch / 2) * (COS_CRANK + SIN_CRANK)),
        unless=_UNLIKE_SHARE, stated=frozenset({"share"}),
        never=words(r"from the (?:middle|cent(?:re|er)|longitudinal)|each side|half the distance"
                    r"|von der mitte"),
    ),
    Quantity(
        "angular velocity at which a wheel leaves the rail", letters("omega Omega w"),
        words(_LIFTS + r"(?:[^.;=]{1,50}?(?:angular\s+(?:velocity|speed)|winkelgeschwindigkeit"
        r"|角速度)[^.;=]{0,14})?"),
        (root(wheel_load / (balance_mass * arm_of_weight)),), ("any", "root", "power", "bare factor"),
        mistakes=(wheel_load / (balance_mass * arm_of_weight),),
        only=words(r"rail|schiene|レール|wheel|\brad\b|車輪"),
        unless=words(r"km/h|velocity of the train"),
    ),
    Quantity(
        "angular velocity of a rolling wheel", letters("omega Omega w"),
        words(r"angular\s+(?:speed|velocity)\s+of\s+(?:the\s+|a\s+)?(?:driving\s+)?wheels?",
              r"winkelgeschwindigkeit\s+(?:des\s+(?:treib)?rades|der\s+(?:treib)?räder)",
              r"(?:動輪|車輪)の角速度"),
        (2 * velocity / diameter, velocity / radius), ("factor", "power"),
        others=(),
        mistakes=(velocity / diameter,),
    ),
    Quantity(
        "inertia force at the top dead centre beside a counterweight", letters("F P K f R X V"),
        words(r"(?:at\s+|im\s+|am\s+)?(?:the\s+)?(?:top|upper|inner)\s+dead\s+(?:cent(?:re|er)|point)",
              r"\bT\.?D\.?C\b", r"\btop(?=:)", r"top\s+of\s+the\s+stroke",
                  r"(?<!unteren )(?:oberen\s+)?totpunkt", r"\bOT\b",
              r"上死点"),
        (base_force * (1 + ratio - share), _FORCE * (1 + ratio - share),
         -(base_force * (1 + ratio - share)), -(_FORCE * (1 + ratio - share))),
        ("edit", "power"), only=_BALANCE_FACTOR, unless=_NO_BALANCE, is_told_once=True, stated=frozenset({
            "share"}),
    ),
    Quantity(
        "inertia force at the bottom dead centre beside a counterweight", letters("F P K f R X V"),
        words(r"(?:at\s+|im\s+|am\s+)?(?:the\s+)?(?:bottom|lower|outer)\s+dead\s+(?:cent(?:re|er)|point)",
              r"\bB\.?D\.?C\b", r"\bbottom(?=:)", r"bottom\s+of\s+the\s+stroke", r"unteren?\s+totpunkt",
                  r"\bUT\b", r"下死点"),
        (-(base_force * (1 - ratio - share)), -(_FORCE * (1 - ratio - share)),
         base_force * (1 - ratio - share), _FORCE * (1 - ratio - share)),
        ("edit", "power"), only=_BALANCE_FACTOR, unless=_NO_BALANCE, is_told_once=True, stated=frozenset({
            "share"}),
    ),
    Quantity(
        "force across the cylinder at 90° beside a counterweight", letters("F P K f R Q Y H"),
        words(r"across\s+the\s+(?:bore|cylinder)", r"90\s?°[^.;=\n]{0,30}?(?:force\s+(?:transverse"
                                                   r"|across|sideways)"
              r"|(?:transverse|lateral|sideways)\s+force)",
                  r"(?:halfway|half\s+way|mid-?stroke|at\s+90\s?°)[^.=]{0,30}"
              r"(?:across|sideways|transverse)[^=.\n]{0,30}?"),
        (share * base_force, _TAKEN, -(share * base_force), -_TAKEN),
        ("edit", "power"), mistakes=((1 - share) * base_force, (1 - share) * _FORCE),
        only=_BALANCE_FACTOR, unless=_NO_BALANCE, is_told_once=True, stated=frozenset({"share"}),
    ),
    Quantity(
        "horizontal force of an upright cylinder beside a counterweight", letters("F P R X Y Q H"),
        words(r"horizontal\s+(?:shaking\s+|unbalanced\s+|inertia\s+|free\s+)*force",
            r"水平方向の(?:加振力|不釣り?合い力)"),
        (_TAKEN * SIN_CRANK, -(_TAKEN * SIN_CRANK)), ("edit",),
        mistakes=(_TAKEN * COS_CRANK, -(_TAKEN * COS_CRANK)),
        only=_BALANCE_FACTOR, unless=words(r"\bV\b|V-?twin|\bbanks?\b|\btwo\b|horizontal (?:engine"
                                           r"|cylinder)"), is_told_once=True,
        turns=True,
    ),
    Quantity(
        "inertia force at a right angle of the crank", letters("F P K R X"),
        words(r"(?:inertia\s+)?force\s+at\s+90\s?(?:°|degrees?)(?:\s+after\s+TDC)?",
            r"massenkraft\s+bei\s+90\s?°",
              r"90\s?°\s?での慣性力"),
        (_FORCE * ratio / root(1 - ratio**2), -(_FORCE * ratio / root(1 - ratio**2))), ("power",),
        approximate=(_FORCE * ratio, -(_FORCE * ratio)), mistakes=(_FORCE * ratio**2,
        -(_FORCE * ratio**2)),
        unless=words(r"balance factor|second cylinder|V-?twin|\btwo\b|across"),
    ),
    Quantity(
        "resultant that the balance of a share leaves", letters("F R P"),
        words(r"(?:magnitude|size)\s+of\s+the\s+(?:resultant"
              r"|total)(?:\s+unbalanced)?(?:\s+primary)?(?:\s+force)?",
              r"resultant\s+unbalanced\s+(?:primary\s+)?force(?:\s+at\s+any\s+instant)?",
              r"(?:left-?over|remaining|residual)\s+(?:primary\s+|shaking\s+"
              r"|unbalanced\s+)*force[^.;=]{0,40}?(?:vector|length|constant"
              r"|magnitude)", r"betrag\s+der\s+rest(?:massen)?kraft",
              r"(?:残留力|不釣り?合い力)の(?:合力|大きさ)"),
        (_FORCE * root((1 - share) ** 2 * COS_CRANK**2 + share**2 * SIN_CRANK**2), _FORCE / 2),
        ("any", "edit", "power", "root"),
        others=(_FORCE * root((1 - share) ** 2 * SIN_CRANK**2 + share**2 * COS_CRANK**2),),
        mistakes=(_FORCE, _FORCE / 4,
        _FORCE * root((1 - share) ** 2 * COS_CRANK**2 + (1 - share) ** 2 * SIN_CRANK**2),
                  _FORCE * root((1 - share) * COS_CRANK**2 + share * SIN_CRANK**2)),
        only=words(r"\bhalf\b|50\s?\\?%|fraction|\bshare\b|hälfte|半分|balance factor"),
        unless=words(r"V-?twin|\btwo\b|three|four|tractive|secondary|second order"),
    ),
    Quantity(
        "resultant that the balance of a share leaves, by the angle from the line of stroke",
        letters("F R P"),
        words(r"resultant(?:\s+of\s+both)?(?:\s+unbalanced)?(?:\s+primary)?(?:\s+force)?(?:\s+at\s+any\s+instant)?",
              r"result(?:ante|ierende)(?:\s+\w+)?", r"合力(?:の大きさ)?"),
        (_FORCE * root((1 - share) ** 2 * COS_CRANK**2 + share**2 * SIN_CRANK**2),),
        ("any", "edit", "power", "root"),
        mistakes=(_FORCE * root((1 - share) ** 2 * SIN_CRANK**2 + share**2 * COS_CRANK**2),),
        only=words(
            r"\(1\s?-\s?[\w\\]{1,6}\)[^.;\n]{0,40}?\\?cos[^.;\n]{0,60}?\\?sin[^.;\n]{0,60}?(?:across"
            r"|perpendicular|quer|transvers|trasvers|垂直|直角)"
        ),
        unless=words(r"V-?twin|\btwo\b|three|four|tractive|secondary|second order"), turns=True,
    ),
    Quantity(
        "balance factor that makes two forces equal", letters("k beta c x b K"),
        words(r"(?:setting|making)\s+(?:them|both|the\s+two)\s+equal[^.;=]{0,12}",
            r"(?:they|both)\s+are\s+equal\s+(?:if|when|for)",
              r"equating\s+(?:them|both|the\s+two)[^.;=]{0,12}", r"gleichsetzen"),
        ((1 + ratio) / 2,), ("edit", "factor"), mistakes=((1 - ratio) / 2, (1 + ratio) / 4, 1 + ratio),
        only=both(_BALANCE_FACTOR, words(r"TDC|top dead|OT\b|totpunkt|上死点")), is_told_once=True,
        unless=words(r"bottom|\bBDC\b|\bUT\b"),
    ),
)  # fmt: skip
