"""Gas cycles: the efficiency of the Otto cycle, temperature and pressure at the end of compression."""

from __future__ import annotations

from symbalance.notes.checking.meant.catalogue.cycle_roles import (
    adiabatic,
    first_pressure,
    first_temperature,
    first_volume,
    second_pressure,
    second_volume,
)
from symbalance.notes.checking.meant.catalogue.roles import Quantity, compression, letters, words
from symbalance.notes.checking.meant.catalogue.strength import both

_ADIABAT = words(
    r"adiabat\w*", r"isentrop\w*", r"polytrop\w*", r"断熱", r"等エントロピー?", r"ポリトロープ",
    r"[pP]\s?\\?,?\s?[Vv]\s?\^\s?\{?\s?\\?(?:gamma|kappa|k|n)\b",
    r"T\s?\\?,?\s?[Vv]\s?\^\s?\{?\s?\\?(?:gamma|kappa|k|n)\b",
)  # fmt: skip
_COMPRESSED = words(
    r"compress\w*", r"verdicht\w*", r"komprim\w*", r"kompress\w*", r"圧縮", r"compr[ei]\w*"
)
_NO_COMPRESSION = (
    r"expan[ds]\w*|expansion|détente|espansione|expansión|膨張|compressor|kompressor|verdichter\b"
    r"|compresseur|turbin\w*|タービン|isothermal?|isotherm\w*|等温|pressure\s+ratio|druckverhältnis"
    r"|rapport\s+de\s+pression|圧力比"
)
"""Words of another change of state, or of a ratio of pressures under the letter of that of volumes."""
_RATIO = first_volume / second_volume
_ONE = "1 a A i 0 u ein"

GAS_CYCLES: tuple[Quantity, ...] = (
    Quantity(
        "thermal efficiency of the Otto cycle", letters("eta"),
        words(r"(?:(?:thermal|ideal|theoretical|air[- ]standard|cycle)\s+)*efficiency",
              r"(?:thermische[rn]?\s+|theoretische[rn]?\s+|idealer?\s+)?wirkungsgrad",
              r"(?:rendement|efficiency)(?:\s+(?:thermique|thermodynamique|théorique))*",
              r"(?:理論)?(?:熱)?効率",
              r"(?:rendimento|efficiency)(?:\s+(?:termico|ideale|teorico))*",
              r"(?:rendimiento|efficiency)(?:\s+(?:térmico|ideal|teórico))*"),
        (1 - 1 / compression ** (adiabatic - 1), 1 - compression ** (1 - adiabatic)), ("edit",),
        only=words(r"\botto\b", r"constant[- ]volume", r"gleichraum\w*", r"オットー", r"等容サイクル",
                   r"beau\s+(?:de|of)\s+rochas", r"otto", r"volum[ei]n?\s+constante?"),
        unless=words(r"diesel|ディーゼル|seiliger|サバテ|sabath\w*|\bdual\b|mixed\s+cycle|gleichdruck"
                     r"|constant[- ]pressure|brayton|joule|gütegrad|mechanic\w*|mechanisch\w*|機械効率"
                     r"|\bbrake\b|effective\s+efficiency|pressure\s+ratio|druckverhältnis|圧力比"
                     r"|atkinson|miller|volumetric|liefergrad|充填"),
        is_told_once=True,
    ),
    Quantity(
        "temperature at the end of an adiabatic compression", letters("T vartheta Theta"),
        words(r"(?:(?:absolute|final|end)\s+)*temperature", r"(?:end|verdichtungsend)?temperatur",
              r"température(?:\s+(?:finale|absolue))*", r"temperatura(?:\s+(?:finale?|assoluta"
              r"|absoluta))*",
              r"(?:終わりの|終了時の)?(?:絶対)?温度"),
        (first_temperature * compression ** (adiabatic - 1),
         first_temperature * _RATIO ** (adiabatic - 1),
         first_temperature * (second_pressure / first_pressure) ** ((adiabatic - 1) / adiabatic)),
        ("edit",), mistakes=(first_temperature * compression,),
        only=both(_ADIABAT, _COMPRESSED), unless=words(_NO_COMPRESSION),
        subscripts=(("first_temperature", _ONE),),
    ),
    Quantity(
        "pressure at the end of an adiabatic compression", letters("p P"),
        words(r"(?:(?:absolute|final|end|compression)\s+)*pressure", r"(?:end|verdichtungsend"
            r"|kompressions)?druck",
              r"pression(?:\s+(?:finale|absolue))*", r"pressione(?:\s+finale)?", r"presión(?:\s+final)?",
              r"(?:終わりの|終了時の|圧縮)?圧力?"),
        (first_pressure * compression**adiabatic, first_pressure * _RATIO**adiabatic),
        ("edit",), mistakes=(first_pressure * compression,),
        only=both(_ADIABAT, _COMPRESSED), unless=words(_NO_COMPRESSION),
        subscripts=(("first_pressure", _ONE),),
    ),
)  # fmt: skip
