"""Fatigue of shafts: stresses that swing, notches, factors of safety."""

from __future__ import annotations

from symbalance.document.formula import Name
from symbalance.notes.checking.meant.catalogue.roles import Quantity, letters, root, words
from symbalance.notes.checking.meant.catalogue.shaft_roles import (
    bending_safety,
    endurance,
    form_factor,
    lower_stress,
    mean_stress,
    sensitivity,
    static_strength,
    stress_amplitude,
    torsion_safety,
    upper_stress,
)

_ONE_AND_OTHER = bending_safety * torsion_safety
_SQUARES = bending_safety**2 + torsion_safety**2
_SAFETY = r"safety\s+(?:factor|margin)|factor\s+of\s+safety|\bsafety|sicherheit(?:szahl|sfaktor)?|安全率"
_SWINGS = words(
    r"amplitud\w*", r"alternating", r"fluctuat\w*", r"fatigue", r"ausschlag", r"mittelspannung",
    r"schw[ai]nk\w*", r"schwell\w*", r"dauer(?:festigkeit|bruch)", r"ermüdung", r"応力振幅", r"振幅",
    r"平均応力", r"疲[労れ]",
    r"(?:contrainte|tensi[oó]n|tensione)\s+m(?:oyenne|edia)", r"mean\s+(?:stress|value)",
)  # fmt: skip
"""Words of what swings between two values, whose letters say which part of it they are: σ_a and σ_m."""
_LINE = words(r"goodman|soderberg|haigh|グッドマン|ソダーバーグ")


def _by_a_line(first: Name, second: Name) -> tuple:
    """Return the inverse of the sum of two parts of strengths, in the two usual forms."""
    parts = first / endurance, second / static_strength
    return (
        1 / (parts[0] + parts[1]),
        endurance / (first + endurance / static_strength * second),
    )


FATIGUE: tuple[Quantity, ...] = (
    Quantity(
        "amplitude of a stress that swings", letters("sigma tau S T M F P"),
        words(r"alternating\s+(?:torque|load|moment|force|part)|(?:stress|alternating)\s+amplitude|amplitude\s+of\s+(?:the\s+)?stress|alternating\s+stress"
              r"|variable\s+stress|stress\s+amplitude|spannungsamplitude|(?:spannungs)?ausschlag(?:spannung)?"
              r"|応力振幅"),
        ((upper_stress - lower_stress) / 2,), ("factor", "edit", "part"),
        mistakes=(upper_stress - lower_stress, (upper_stress + lower_stress) / 2),
        unless=words(r"stress range|range of stress|schwingbreite|doppelamplitude|peak[- ]to[- ]peak"
        r"|応力範囲"
                     r"|double amplitude"),
        indices=letters("a A w alt v"), context=_SWINGS,
    ),
    Quantity(
        "mean of a stress that swings", letters("sigma tau S T M F P"),
        words(r"(?:mean|average)\s+(?:stress|torque|load|moment|force)|mittelspannung|平均応力"),
        ((upper_stress + lower_stress) / 2,), ("factor", "edit", "part"),
        mistakes=(upper_stress + lower_stress, (upper_stress - lower_stress) / 2),
        indices=letters("m M mean"), context=_SWINGS,
    ),
    Quantity(
        "fatigue notch factor", letters("K beta k"),
        words(r"(?:fatigue\s+)(?:notch|stress[- ]concentration|strength[- ]reduction)\s+factor"
              r"|(?:effective|actual)\s+(?:notch|stress[- ]concentration)\s+factor"
              r"|kerbwirkungszahl|切り?欠き係数"),
        (1 + sensitivity * (form_factor - 1),), ("edit",),
        mistakes=(1 + (form_factor - 1) / sensitivity, sensitivity * (form_factor - 1),
                  sensitivity * form_factor, 1 + sensitivity * form_factor, 1 + form_factor / sensitivity,
                  form_factor / sensitivity, form_factor + sensitivity * (form_factor - 1),
                  1 + (1 - sensitivity) * (form_factor - 1)),
        unless=words(r"neuber|siebel|peterson radius"),
    ),
    Quantity(
        "safety factor in bending and torsion together", letters("n S nu s k"),
        words(_SAFETY),
        (_ONE_AND_OTHER / root(_SQUARES), 1 / root(1 / bending_safety**2 + 1 / torsion_safety**2)),
        ("edit",),
        mistakes=(_ONE_AND_OTHER / (bending_safety + torsion_safety), root(_SQUARES),
                  (bending_safety + torsion_safety) / 2, _ONE_AND_OTHER, bending_safety + torsion_safety,
                  root(_SQUARES) / _ONE_AND_OTHER, _ONE_AND_OTHER / _SQUARES,
                  1 / (1 / bending_safety + 1 / torsion_safety), root(_ONE_AND_OTHER)),
        unless=words(r"tresca|rankine|normalspannungshypothese|conservative|smaller of|kleinere"),
    ),
    Quantity(
        "allowable amplitude by a straight line of the fatigue diagram", letters("sigma S tau"),
        words(r"amplitude", r"alternating\s+stress", r"\w*ausschlag\w*", r"応力振幅", r"goodman",
        r"soderberg"),
        (endurance * (1 - mean_stress / static_strength), endurance - endurance * mean_stress
         / static_strength), ("edit", "exchange", "part"),
        mistakes=(static_strength * (1 - mean_stress / endurance), endurance * (1 - static_strength
                  / mean_stress), endurance * (1 - mean_stress / endurance), endurance - mean_stress,
                  endurance - mean_stress / static_strength,
                  endurance * (1 - (mean_stress / static_strength) ** 2),
                  endurance * (1 + mean_stress / static_strength)),
        only=_LINE, unless=words(r"gerber|parabol|ellip|morrow|walker|langer"),
    ),
    Quantity(
        "safety factor by a straight line of the fatigue diagram", letters("n S nu s k N"),
        words(_SAFETY, _LINE.pattern),
        _by_a_line(stress_amplitude, mean_stress),
        ("exchange",),
        mistakes=(endurance / stress_amplitude + static_strength / mean_stress,
                  1 / (stress_amplitude / endurance - mean_stress / static_strength),
                  stress_amplitude / endurance + mean_stress / static_strength,
                  1 / (stress_amplitude / static_strength + mean_stress / endurance)),
        only=_LINE, unless=words(r"gerber|parabol|ellip|morrow|walker|langer"),
    ),
)  # fmt: skip
