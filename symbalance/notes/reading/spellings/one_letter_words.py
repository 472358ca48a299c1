"""One-letter words of Romance and Slavic languages between a unit and what follows: r = 3 m y l = 2 m.

The Spanish y, the Italian e and o, the Polish i and z would be letters that the unit is multiplied by.
They become a comma where the page is in such a language, a unit or a degree stands before them, and a
word, or a letter with its equals sign, behind: "la biela y λ = r/l" is no product either.
"""

from __future__ import annotations

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

_LANGUAGES = {
    "yeo": r"\b(?:el|los|las|del|una|por|para|con|que|la|es|se|il|lo|gli|della|che|per|di|è|si)\b",
    "eao": r"\b(?:do|da|dos|das|uma|para|com|que|não|os|as|é)\b",
    "izwau": r"\b(?:jest|się|dla|oraz|przy|nie|na|od|do|pro|při|je|se|ve|podle|které|który|siły|wału)\b",
}
_MOST_WORDS = 4
"""Words of a language that tell a page to be in it."""
_WORD = re.compile(
    r"(?<=[0-9])(?P<unit>[ ~]?(?:°|[A-Za-zµ]{1,5}(?:[/·][A-Za-z]{1,3})?[²³]?))"
    r"(?P<gap>[ ])(?P<word>[a-z])[ ]"
    r"(?=[^\W\d_]{2}|[^\W\d_](?:_?\w{1,3})?[ ]?=)"
)
_BEHIND_WORD = re.compile(
    r"(?<![\\\w])(?P<before>[^\W\d_]{3,20})(?P<gap>[ ])(?P<word>[a-z])[ ]"
    r"(?=[^\W\d_](?:_?\w{1,3})?[ ]?[=≈])"
)
_BEHIND_SIDE = re.compile(
    r"(?<=[)°])(?P<gap>[ ])(?P<word>[a-z])[ ](?=[^\W\d_](?:_?\w{1,3})?[ ]?[=≈]|[0-9][0-9.,]*[ ]?°)"
)
"""Between two relations of angles or waves: 360° + 60° = 420° y 360° - 60° = 300°."""
_FUNCTIONS = frozenset(["sen", "sin", "cos", "tan", "cot", "sec", "log", "exp", "arc"])


def with_one_letter_words(text: str) -> Rewritten | None:
    """Return a text with such words as commas, None where there are none.

    >>> page = "Sea el radio r de la manivela y l la biela; con r = 3,5 m y l = 2,5 m"
    >>> with_one_letter_words(page).text
    'Sea el radio r de la manivela y l la biela; con r = 3,5 m, l = 2,5 m'
    >>> with_one_letter_words("Sea el radio r de la manivela, l el largo de la biela y λ = r/l").text
    'Sea el radio r de la manivela, l el largo de la biela, λ = r/l'
    """
    words = _words_of(text)
    rewriter, places = Rewriter(text), list[tuple[int, int]]()
    for match in _WORD.finditer(text):
        unit = match["unit"].strip(" ~")
        if match["word"] in words and (unit == "°" or scale_of(unit) is not None):
            places.append((match.start("gap"), match.end("word")))
    for match in _BEHIND_WORD.finditer(text):
        if match["word"] in words and match["before"].lower() not in _FUNCTIONS:
            places.append((match.start("gap"), match.end("word")))
    for match in _BEHIND_SIDE.finditer(text):
        if match["word"] in words:
            places.append((match.start("gap"), match.end("word")))
    for start, end in sorted(set(places)):
        rewriter.replace(start, end, ",")
    return rewriter.finish() if places else None


def _words_of(text: str) -> str:
    """Return the one-letter words of the languages that a page may be in."""
    return "".join(
        words
        for words, common in _LANGUAGES.items()
        if sum(1 for _ in zip(range(_MOST_WORDS), re.finditer(common, text), strict=False)) == _MOST_WORDS
    )
