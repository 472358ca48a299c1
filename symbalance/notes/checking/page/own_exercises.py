"""Exercises that stand for themselves: below "Problem 2" the J of a letter is not that of problem 1.

A page of solved problems uses k, J and F in each of them for other things. Where a numbered problem
begins and nothing in it points back to another one, the undeclared letters that it gives values, or that
stand in its equations of motion, have none yet. Others keep theirs: problems share their data.
"""

from __future__ import annotations

from bisect import bisect_right

from symbalance.document.formula import Derivative, names, walk
from symbalance.notes.checking.declared.sidecar import Declarations
from symbalance.notes.checking.meant.left_sides import head_of
from symbalance.notes.checking.premises.definitions import Definitions
from symbalance.notes.reading.equations import ReadNotes
from symbalance.text import lazy_patterns as re

_KIND = (
    r"(?:exercise|problem|question|task|aufgabe|übung|exercice|problème|esercizio|ejercicio|problema"
    r"|opgave|uppgift|zadanie|příklad|задача)"
)
_MARK = r"(?:#{1,6} ?|=+ ?|\\(?:sub)*section\*?\{|\\paragraph\*?\{)"
_HEADING = re.compile(
    rf"^[ \t]{{0,3}}{_MARK}?(?:[*_]{{1,3}}|\\textbf\{{)?"
    rf"{_KIND}\s?(?:No\.?|Nr\.?|n°|№)?\s?[0-9]{{1,2}}(?![0-9]|[.,][0-9])"
    rf"|^[ \t]{{0,3}}{_MARK}\s?(?:[0-9]{{1,2}}(?:\.[0-9]{{1,2}})?[.)]?\s+)?"
    rf"(?P<alone>{_KIND})(?=\s*[:.–—(])",
    re.IGNORECASE | re.MULTILINE,
)
"""A numbered problem, or a heading that calls its section one: "6. Exercise: a single cylinder"."""
_POINTS_BACK = re.compile(
    rf"\b{_KIND}s?\s?(?:No\.?|Nr\.?)?\s?\(?[0-9]{{1,2}}\)?(?![0-9])"
    r"|\b(?:above|before|previous(?:ly)?|earlier|former|as\s+in|of\s+part|oben|obige[nrsm]?|vorher\w*|vorige[nrsm]?"
    r"|desselben|wie\s+in|weiterhin|ci-dessus|précédente?s?|sopra|precedente|anterior|vorige"
    r"|föregående|powyżej|выше|same\s+(?:data|numbers|values|notation|letters|symbols|\w+\s+as)"
    r"|same\s+(?:engine|shaft|flywheel|system|machine|rotor|crank\w*|piston|disc|disk|motor|train)"
    r"|(?:gleiche|selbe|derselbe|dieselbe|dasselbe|demselben|derselben)[nrsm]?\s+(?:\w+)\s+wie"
    r"|(?:dieselbe|derselbe|derselben|demselben|dasselbe|denselben)\s+(?:Welle|Motor|Maschine|System|Kurbel\w*|Schwungrad|Daten)"
    r"|même\s+(?:arbre|moteur|système)|stesso\s+(?:albero|motore|sistema)|mismo\s+(?:eje|motor|sistema))\b"
    r"|前問|上の|上記|同じ",
    re.IGNORECASE,
)


class OwnExercises:
    """The numbered problems of a page that point back to no other one, and which was judged last."""

    def __init__(self, page: ReadNotes) -> None:
        text, self.chains = page.text, page.chains
        matches = list(_HEADING.finditer(text))
        ends = [*(match.start() for match in matches[1:]), len(text)]
        self.starts = [text.count("\n", 0, match.start()) + 1 for match in matches]
        self.are_alone = [match["alone"] is not None for match in matches]
        self.are_own = [
            _POINTS_BACK.search(text, match.end(), end) is None
            for match, end in zip(matches, ends, strict=False)
        ]
        self.current = 0

    def enter(self, line: int, definitions: Definitions, declarations: Declarations) -> None:
        """Forget what letters of another exercise are, where a line is the first one of its own."""
        own = bisect_right(self.starts, line)
        if own <= self.current:
            return
        self.current = own
        is_first = own == 1 and not self.are_alone[0]  # what stands above problem 1 is of them all
        if is_first or not self.are_own[own - 1]:
            return
        declared = set(declarations.symbols_at(line))
        anew = self._letters_given(own) - declared
        for name in anew:
            definitions.forget_all(name)
        for name in self._letters_given(own, in_numbers=True) & declared:
            definitions.forget_all(name)  # what it means is said for the page, its number is not
        definitions.premises = [p for p in definitions.premises if not p.names & anew]

    def _letters_given(self, number: int, *, in_numbers: bool = False) -> set[str]:
        """Return the letters that an exercise gives a value or moves by differential equations.

        With `in_numbers` only those whose relation ends in a number: T_m = P/ω_m = 191 N m.
        """
        first = self.starts[number - 1]
        last = self.starts[number] if number < len(self.starts) else None
        own: set[str] = set()
        for chain in self.chains:
            if chain.lines[0] < first or (last is not None and chain.lines[0] >= last):
                continue
            if in_numbers and names(chain.sides[-1].node):
                continue
            head = head_of(chain.sides[0].node) if chain.relations else None
            own |= {head} if head is not None else set()
            if any(isinstance(part, Derivative) for side in chain.sides for part in walk(side.node)):
                own |= chain.letters
        return own
