"""Terms of a page in another language by their English names: poussée latérale is the side thrust.

What the checker knows of quantities it knows by English, German and Japanese words. On a page in one of
eight other languages the words around a formula are read with their technical terms in English; the
languages' tables, in `tongues`, are loaded and compiled only for a page that is written in one of them.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from functools import cache, lru_cache
from importlib import import_module
from itertools import accumulate

from symbalance.text import lazy_patterns as re

_WORDS = {
    "english": "the and is of with for are from by this that at its we as in on force torque speed"
    " mass engine crank piston rod shaft cylinder cylinders four per each moment",
    "german": "der die das und ist mit des im für den dem ein eine einer von bei zur zum kraft wird"
    " sind je pro zwei drei vier zylinder masse kurbel kolben ordnung moment motor welle",
    "french": "le la les des du de une un est et dans pour avec sur par aux où sont cette vaut que moteur"
    " bielle manivelle couple vitesse effort ordre gaz masse rayon contrainte",
    "spanish": "el la los las del de una un es con por para que donde al en son vale fuerza orden pistón"
    " biela manivela velocidad cigüeñal momento masa motor inercia",
    "italian": "il lo la gli della dello delle dei del di è con per una un nel alla dove sono che vale"
    " forza ordine pistone biella manovella velocità coppia momento motore inerzia",
    "dutch": "de het een van is met voor op bij zijn wordt waarin tussen kracht zuiger krukas drijfstang"
    " koppel snelheid orde massa per traagheidsmoment",
    "polish": "jest na dla oraz do się przy gdzie wynosi siła siły tłoka korby wału moment prędkość rzędu"
    " bezwładności silnika masa koła korbowodu kąt",
    "portuguese": "os as do da dos das de um uma é com por para no na ao em que onde são vale força"
    " pistão êmbolo biela manivela velocidade ordem momento massa motor inércia",
    "swedish": "och av är den det ett en med för vid som där kraft kraften kolven vevstaken veven"
    " ordningen masskraften hastighet blir två svänghjulet axeln kolvens vevens motorn massan varvtalet"
    " dödpunkten vevaxeln övre undre",
    "czech": "je na pro při se ve kde síla síly pístu kliky řádu rychlost moment hřídele setrvačná"
    " setrvačnosti motoru ojnice úvrati hmotnost úhel",
}
_MARKERS = {language: frozenset(words.split()) for language, words in _WORDS.items()}
_LETTERS = {language: frozenset[str]() for language in _WORDS} | {
    "polish": frozenset("łżąęśź"),
    "czech": frozenset("řěů"),
    "swedish": frozenset("å"),
    "portuguese": frozenset("ãõ"),
    "spanish": frozenset("ñ"),
}
"""Letters that no other of the languages has."""
_OWN = frozenset({"english", "german"})
_WORD = re.compile(r"(?<![\w\\{])[^\W_]+")
_KANA = re.compile("[\u3040-\u30ff]")
_LOOKED_AT, _FEWEST = 20_000, 2
"""Characters of a page that tell its language, and how many words of it there have to be."""
_SHORTEST = 4
"""Letters of an English term that is put back into the page's own words; "of" is none."""
_TERM_END = r"(?:(?<=['’])|(?![^\W_]))"
_LINE = re.compile(r"^(?P<english>[^:\n]+): (?P<own>.+)$", re.MULTILINE)


@dataclass
class Glossary:
    """The terms of one language, and those that a page was read with."""

    language: str
    originals: dict[str, str] = field(default_factory=dict)
    """The page's own words of the terms that were put in English."""
    _memo: dict[str, str] = field(default_factory=dict)
    _sources: dict[str, str] = field(default_factory=dict)

    def english(self, text: str) -> str:
        """Return a text with its technical terms in English."""
        if text not in self._memo:
            self._memo[text] = self._put_in_english(text)
            self._sources.setdefault(self._memo[text], text)
        return self._memo[text]

    def _put_in_english(self, text: str) -> str:
        tables = _tables(self.language)
        parts, last = list[str](), 0
        for word in _WORD.finditer(text):
            start = word.start()
            if start < last or (table := tables.get(text[start].casefold())) is None:
                continue
            if _any_of(self.language, text[start].casefold()).match(text, start) is None:
                continue
            matches = [(match, term) for own, term in table if (match := own.match(text, start))]
            match, term = max(matches, key=lambda pair: pair[0].end())
            if len(term) >= _SHORTEST:
                self.originals.setdefault(term, match[0])
            end = match.end()
            parts += [text[last:start], term, " " if match[0].endswith(("'", "’")) else ""]
            last = end
        return "".join((*parts, text[last:]))

    def own_words(self, words: str) -> str:
        """Return words that were put in English as the page has them, a whole text or its terms."""
        if words in self._sources:
            return self._sources[words]
        originals = [*self.originals.items()]  # another thread may add some meanwhile
        whole = next((own for term, own in originals if words in term), "")
        if whole and words not in self.originals:
            return whole
        for term, source in sorted(originals, key=lambda each: len(each[0]), reverse=True):
            if term in words:
                own = source.replace("\\", r"\\")
                words = re.sub(rf"(?<!\w){term}(?!\w)", own, words)
        return words


class NoGlossary(Glossary):
    """A page in a language that is read as it stands."""

    def english(self, text: str) -> str:
        """Return a text as it stands."""
        return text

    def own_words(self, words: str) -> str:
        """Return words as they stand."""
        return words


@lru_cache(maxsize=64)
def glossary_of(text: str) -> Glossary:
    """Return the glossary for the language that a page is written in.

    >>> glossary_of("La poussée latérale est $N = F\\\\tan\\\\beta$.").english("La poussée latérale est")
    'the side thrust is'
    >>> glossary_of("The side thrust is $N$.").english("de la bielle")
    'de la bielle'
    """
    language = language_of(text)
    glossary = Glossary(language) if language else NoGlossary("")
    glossary.english(text)  # so that a term is quoted as the page has it first
    return glossary


def language_of(text: str) -> str:
    """Return which of the languages with a table a page is written in; "" for none or for any other.

    >>> language_of("De zijkracht van de zuiger is F"), language_of("the torque of a crank")
    ('dutch', '')
    """
    start = text[:_LOOKED_AT]
    if _KANA.search(start):
        return ""
    counts = Counter(map(str.casefold, _WORD.findall(start)))
    scores, several = dict[str, float](), dict[str, int]()
    for language, words in _MARKERS.items():
        own = [word for word in counts if word in words or not _LETTERS[language].isdisjoint(word)]
        several[language] = len(own)
        scores[language] = sum(counts[word] for word in own) + len(own) / 1000
    first, second = sorted(scores, key=lambda language: scores[language])[:-3:-1]
    is_clear = several[first] >= _FEWEST and scores[first] > scores[second]
    return first if is_clear and first not in _OWN else ""


@cache
def _tables(language: str) -> dict[str, list[tuple[re.Pattern[str], str]]]:
    """Return the patterns of a language's terms with the English ones, by their first letter."""
    module = import_module(f"{__package__}.tongues.{language}")
    tables: dict[str, list[tuple[re.Pattern[str], str]]] = {}
    for line in _LINE.finditer(module.TERMS):
        for own in _alternatives(line["own"].replace("§", "§ ")):
            pattern = own.replace(" ?", r"\s*").replace(" ", r"\s+").replace("'", "['’]")
            pattern = pattern.replace(r"§\s+", module.OF.replace("'", "['’]"))
            whole = re.compile(rf"(?:{pattern}){_TERM_END}", re.IGNORECASE)
            for first in _first_letters(own):
                tables.setdefault(first, []).append((whole, line["english"]))
    return tables


@cache
def _any_of(language: str, first: str) -> re.Pattern[str]:
    """Return one pattern for all of a language's terms that begin with a letter."""
    return re.compile("|".join(own.pattern for own, _ in _tables(language)[first]), re.IGNORECASE)


def _alternatives(text: str) -> list[str]:
    """Return the alternatives of a pattern that stand in no brackets."""
    parts, depth = [""], 0
    for sign in text:
        depth += (sign == "(") - (sign == ")")
        if sign == "|" and not depth:
            parts.append("")
        else:
            parts[-1] += sign
    return parts


def _first_letters(pattern: str) -> set[str]:
    """Return the letters that a pattern's matches may begin with."""
    if not pattern.startswith("(?:"):
        return {pattern[0].casefold()}
    depths = accumulate((sign == "(") - (sign == ")") for sign in pattern)
    end = next(place for place, depth in enumerate(depths) if not depth)
    firsts = {first for part in _alternatives(pattern[3:end]) for first in _first_letters(part)}
    return firsts | (_first_letters(pattern[end + 2 :]) if pattern[end + 1 : end + 2] == "?" else set())
