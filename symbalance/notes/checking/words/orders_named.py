r"""How far words say that a series is taken: "to second order in x", "neglecting λ³ and higher".

The order named is the highest power that is kept, and the letter is the one that is small. Words that
name no letter leave it open.
"""

from __future__ import annotations

from dataclasses import dataclass

from symbalance.document.letters import plain_letter
from symbalance.text import lazy_patterns as re


@dataclass(frozen=True, slots=True)
class OrderNamed:
    """The highest power that is kept, and its letter as words spell it, "" where they name none."""

    order: int
    letter: str = ""


_ORDINALS = {
    1: "first|1st|1\\.|erste[rn]?|premier|première|primo|prim[eo]r",
    2: "second|2nd|2\\.|zweite[rn]?|deuxième|second[eo]?|2e|segundo",
    3: "third|3rd|3\\.|dritte[rn]?|troisième|terzo|tercer|3e",
    4: "fourth|4th|4\\.|vierte[rn]?|quatrième|quarto|cuarto|4e",
    5: "fifth|5th|5\\.|fünfte[rn]?|cinquième|quinto",
    6: "sixth|6th|6\\.|sechste[rn]?|sixième|sesto|sexto",
}
_ORDINAL = "|".join(f"(?P<o{order}>{words})" for order, words in _ORDINALS.items())
_GREEK = (
    r"(?:var)?(?:epsilon|theta|phi)|lambda|alpha|beta|gamma|delta|kappa|mu|nu|xi|eta|zeta|rho|sigma|tau"
    r"|psi|omega"
)
_LETTER = rf"\$?\\?(?P<letter>(?:{_GREEK})(?![A-Za-z])|[A-Za-zα-ωϑϕϵ](?![A-Za-zα-ω]))(?:\(?\$|(?![\w^]))"
_POWER = (
    rf"\$?\\?(?P<base>(?:{_GREEK})(?![A-Za-z])|[A-Za-zα-ωϑϕϵ](?![A-Za-zα-ω]))\s?"
    r"(?:\^\s?\{?\s?(?P<flat>[1-9])\s?\}?|(?P<raised>[²³⁴⁵⁶⁷⁸⁹]))\$?"
)
_NOUN = r"(?:[\s-]?(?:orders?|Ordnung|ordre|ordine|orden)(?![^\W\d_]))"
_TO = (
    r"(?<![^\W\d_])(?:(?:up\s)?to(?:\sand\sincluding)?|through|bis(?:\seinschließlich)?(?:\s(?:zur?|in\sdie))?"
    r"|jusqu['’](?:au|à\sl['’])|au|à\sl['’]|fino\sal|al|hasta\sel)(?:\sthe)?\s?"
)
_IN = r"\s(?:in|of|en|von)\s(?:the\s(?:ratio|parameter|angle)\s)?"
_BY_ORDINAL = re.compile(rf"{_TO}(?:{_ORDINAL}){_NOUN}(?:{_IN}{_LETTER})?", re.IGNORECASE)
_WITHIN = re.compile(rf"(?<![^\W\d_])in\s(?:{_ORDINAL}){_NOUN}{_IN}{_LETTER}", re.IGNORECASE)
_BY_NUMBER = re.compile(
    rf"(?:{_TO}(?:order|Ordnung|ordre|ordine|orden)|à\sl['’]ordre|all['’]ordine)\s\$?(?P<number>[1-6])\$?"
    rf"(?![.,]?[0-9])(?:{_IN}{_LETTER})?",
    re.IGNORECASE,
)
_UP_TO_POWER = re.compile(
    r"(?<![^\W\d_])(?:up\sto|through|bis(?:\szu)?|jusqu['’](?:à|en)|fino\sa|hasta)\s"
    r"(?:(?:and|including|terms|the|in|of|order|einschließlich|Glieder[n]?|Terme[n]?|Ordnung|termes|en"
    r"|ordre|l['’]ordre|ordine|orden)\s){0,4}"
    rf"{_POWER}",
    re.IGNORECASE,
)
_LEFT_OUT = re.compile(
    r"(?<![^\W\d_])(?:neglect|drop|ignor|omit|discard|disregard|vernachlässig|néglige|trascura|desprecia)\w*"
    rf"(?P<gap>[^.,;:=≈\n]{{0,40}}?)(?<![\w^\\]){_POWER}",
    re.IGNORECASE,
)
_JAPANESE = re.compile(
    rf"\$?\\?(?P<letter>(?:{_GREEK})(?![A-Za-z])|[A-Za-zα-ωϑϕϵ](?![A-Za-zα-ω]))\$?\s?の\s?\$?"
    r"(?P<number>[1-6])\$?\s?次まで"
)
_BEYOND = re.compile(
    r"higher\sthan|above|beyond|over|höher(?:e[rn]?)?\sals|über|supérieur|au-delà|oltre|superior", re.I
)
_DENIED = re.compile(r"(?<![^\W\d_])(?:not|nicht|pas|non|no|only\sif)\s(?:\w+\s){0,2}$", re.IGNORECASE)
_ENDS = re.compile(r"(?<![0-9])[.!?;]\s|[。；]|\n\s*\n")
"""Where a sentence ends; the point of an ordinal, 2. Ordnung, ends none."""
_GOES_ON = re.compile(r"\s?(?:[=≈<>+*/·_^(]|\\(?:cos|sin|frac|cdot)|(?:cos|sin)(?![a-z]))")
"""What goes on with a formula behind a power, which is then no power alone."""
_RAISED = {sign: number for number, sign in enumerate("²³⁴⁵⁶⁷⁸⁹", 2)}


def order_named(words: str) -> OrderNamed | None:
    r"""Return the order that the last sentence of some words names last, None where it names none.

    >>> order_named("To second order in $x$, ")
    OrderNamed(order=2, letter='x')
    >>> order_named("Unter Vernachlässigung von λ³ und höher gilt "), order_named("Up to fourth order ")
    (OrderNamed(order=2, letter='λ'), OrderNamed(order=4, letter=''))
    >>> order_named("xの2次までで")
    OrderNamed(order=2, letter='x')
    >>> order_named("with terms up to $\\lambda^4$: "), order_named("bis zur 2. Ordnung in x ist ")
    (OrderNamed(order=4, letter='λ'), OrderNamed(order=2, letter='x'))
    >>> order_named("To second order. Then "), order_named("the second order force is ")
    (None, None)
    """
    sentence = _ENDS.split(words)[-1]
    found: list[tuple[int, OrderNamed]] = []
    for pattern in (_BY_ORDINAL, _WITHIN):
        for match in pattern.finditer(sentence):
            order = next(order for order in _ORDINALS if match[f"o{order}"])
            found.append((match.start(), OrderNamed(order, _spelled(match["letter"]))))
    for pattern in (_BY_NUMBER, _JAPANESE):
        for match in pattern.finditer(sentence):
            found.append((match.start(), OrderNamed(int(match["number"]), _spelled(match["letter"]))))
    for pattern in (_UP_TO_POWER, _LEFT_OUT):
        for match in pattern.finditer(sentence):
            if _GOES_ON.match(sentence, match.end()):
                continue
            power = int(match["flat"]) if match["flat"] else _RAISED[match["raised"]]
            is_out = pattern is _LEFT_OUT and not _BEYOND.search(match["gap"])
            found.append((match.start(), OrderNamed(power - is_out, _spelled(match["base"]))))
    found = [each for each in found if not _DENIED.search(sentence[: each[0]])]
    return max(found, key=lambda each: each[0])[1] if found else None


def _spelled(letter: str | None) -> str:
    """Return a letter as people write it, whatever way it is typed: λ for lambda and \\lambda."""
    if not letter:
        return ""
    shown = plain_letter(letter.removeprefix("var"))
    return {"ϵ": "ε", "ϑ": "θ", "ϕ": "φ"}.get(shown, shown)
