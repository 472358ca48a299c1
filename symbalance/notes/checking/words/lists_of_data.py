"""Lists of data: m = 0.52 kg, r = 41 mm and l = 144 mm, one number behind the other, none worked out."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from symbalance.document.formula import Name, names
from symbalance.notes.checking.words.worked_out import is_worked_out
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_NEAR = 60
"""Characters at most between two data of a list: units and words such as "stroke"."""
_BETWEEN = re.compile(r"[^=.;:。；\n]*(?:\n(?!\s*\n)[^=.;:。；\n]*)?")
_RESULT = re.compile(
    r"(?<![^\W\d_])(?:wird|werden|ist|sind|is|are|gives?|get|becomes?|follows?|folgt|ergibt|so|hence|then|therefore|we"
    r"|one|also|daher|damit|donne|est|vaut|resulta|risulta|wordt|daje|blir)(?![^\W\d_])|となる|より|よって|から",
    re.IGNORECASE,
)
"""Words behind which the results of the data stand."""
_RESULT_BEFORE = re.compile(
    r"(?<![^\W\d_])(?:(?:so|hence|thus|then|therefore|gives?|giving|get|becomes?|follows?|folgt|ergibt|wird|werden|daher|damit"
    r"|donne|donc|d'où|resulta|risulta|quindi)(?=[^.:：]{0,12}$)|results?|checks?|checking|answers?|solutions?|obtain\w*|find|found|comes?|computed|calculated"
    r"|ergebniss?e?|ergeben|probe|kontrolle|lösung(?:en)?|erhalten|erhält|berechnet|résultats?|vérification|obtient|trouve"
    r"|resultados?|solución|risultat[oi])(?![^\W\d_])|結果|検算|確認|答|求め|得られ|(?:より|よって|から)[^.:：。]{0,6}$",
    re.IGNORECASE,
)
"""Before numbers that are results: "Check:" anywhere in the clause, "so" right before them."""
_CLAUSE = re.compile(r"[.!?]\s|[;。；]|\n\s*\n")
FEWEST = 2
"""Numbers in a row that make a list."""


def gives_number(chain: Chain) -> bool:
    """Tell whether a chain does nothing but give a letter a number."""
    is_plain = len(chain.relations) == 1 and isinstance(chain.sides[0].node, Name)
    return is_plain and not names(chain.sides[1].node)


def sets_number(chain: Chain) -> bool:
    """Tell whether a chain does nothing but set a letter equal to a number, or about equal."""
    return gives_number(chain) and chain.relations[0].sign in "=≈"


def stand_in_one_list(before: Chain, after: Chain, text: str) -> bool:
    """Tell whether nothing but units, commas and words for sizes stands between two data."""
    between = text[before.end : after.start]
    is_list = len(between) <= _NEAR and _BETWEEN.fullmatch(between) is not None
    return is_list and _RESULT.search(between) is None


def lists_of_data(text: str, in_order: Sequence[Chain]) -> Iterator[list[Chain]]:
    """Yield the lists of data of a text, whose relations are given in their order.

    Numbers behind words for results, "so" or "Check:", are no data, nor are those of a list in which one
    is worked out.
    """
    own: list[Chain] = []
    for chain in in_order:
        if own and gives_number(chain) and stand_in_one_list(own[-1], chain, text):
            own.append(chain)
            continue
        if _is_list(own, text):
            yield own
        own = [chain] if gives_number(chain) else []
    if _is_list(own, text):
        yield own


def _is_list(own: Sequence[Chain], text: str) -> bool:
    if len(own) < FEWEST or any(c.relations[0].sign != "=" for c in own):
        return False
    if any(is_worked_out(text[c.sides[1].span[0] : c.sides[1].span[1]]) for c in own):
        return False
    before = _CLAUSE.split(text[max(0, own[0].start - 2 * _NEAR) : own[0].start])[-1]
    return _RESULT_BEFORE.search(before) is None
