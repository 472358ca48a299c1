"""The account of a document's relation signs: each is read, unreadable, or no mathematics.

What the reader did not take is looked at once more. A sign between words of prose, in a tag or in program
code that is no formula says nothing in mathematics; any other is reported as unreadable, with the reason
that the reader had, so that nothing vanishes.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from symbalance.document.wordlists import word_set
from symbalance.notes.reading.equations import Explained, Passed, Unreadable
from symbalance.notes.reading.failures import ReadingError, UndeclaredError
from symbalance.notes.reading.passages.meanings_in_words import Meaning, is_meaning, is_word, meaning_at
from symbalance.notes.reading.signs import RELATION, UNREAD_RELATIONS
from symbalance.notes.reading.sources import CELL_END
from symbalance.notes.reading.units import is_unit_of_letter
from symbalance.text import lazy_patterns as re

_SETTINGS = word_set(
    "magnification hsize vsize parindent parskip baselineskip tolerance hoffset voffset nopagenumbers"
    " pretolerance topskip hbadness vbadness overfullrule jot abovedisplayskip belowdisplayskip count"
)
LineOf = Callable[[int], tuple[int, int]]
"""Tells the line and column, from 1, of an offset."""

MOST_SIGNS = 20_000
"""Signs looked at; a text with more is no derivation, and is said to have more."""
_AROUND = 120  # characters looked at on either side of a sign
_BOUNDS = re.compile(r"[_^]\s*\{(?:[^{}\n]|\{[^{}\n]{0,60}\}){0,60}\}")
_TAG = re.compile(
    r"</?[\u2e80-\u9fff][^<>\n=]{0,60}>|</?[A-Za-z!][\w-]*\s[^<>\n]{0,200}>|<[A-Za-z][\w.]{0,20}>"
)
_MEASURED_WORD = re.compile(r"[0-9]\s?[^\W\d_]+\s*$")
_SETTING = re.compile(r"\\([A-Za-z]+)\s*$")
_NO_RELATION_BEHIND = r"(?!(?:[^\n=<>≈≤≥⇒,;.]|[.,](?=[0-9])){0,60}[=≈≤≥])"
_BETWEEN_NUMBERS = rf"(?<=[0-9)])(?:\s*(?:(?:=>|⇒)\s*{_NO_RELATION_BEHIND}|(?:<<|>>)\s*)(?=[-−(]?[0-9]))"
"""An arrow from number to number: between relations it says what follows from what, here it claims."""
_SIGN = re.compile(
    rf"==|:=|<=(?!>)|>=|!=|{_BETWEEN_NUMBERS}|{RELATION.pattern}"
    rf"|{UNREAD_RELATIONS.pattern}"
)
_WORD = r"[^\W\d_][\w'’]*(?:-[^\W\d_]{2}[\w'’]*)*"
_BEFORE = re.compile(rf"({_WORD}|\S)\s*$")
_AFTER = re.compile(rf"\s*({_WORD}|\S)")
_CONSTANT = re.compile(
    r"(?:=|≈|\\approx)\s*\$?\s*(?:\\(?:text|mathrm|mbox|textrm|textit|operatorname)\s*\{\s*)?[ckCK]onst"
    r"(?:ant|\.)?(?![A-Za-z])"
)
SAID_TO_BE_CONSTANT = "said to be constant"
_WORDS_OF_PROSE = re.compile(r"(?<![\\A-Za-z])[^\W\d_]{3,}[ ]")
_SIDE_BEFORE = re.compile(r"[^=<>≈≤≥,;:$\n&]{1,60}$")
_OPERATION_IN_WORDS = re.compile(
    r"∫|∑|∏|(?<![^\W\d_])(?:integral|sum|product|limit|derivative|Summe|Produkt|Grenzwert|somme|intégrale)\s?"
    r"(?:\((?=[\d\w]{1,3}\s?(?:\.\.|…|,|:|=))|(?:of\s\S{1,12}\s)?(?:from|von|de)\s\S{1,12}\s(?:to|bis|à)\s)",
    re.IGNORECASE,
)
_SAID_IN_WORDS = ("words on both sides", "a letter explained in words")
"""Reasons for which a sign may explain a letter."""
_EXPLAINING = ("=", ":=", "\\equiv", "≡", "≙", "\\triangleq", "≜", "≔", "\\coloneqq")
_SIZE = re.compile(_BETWEEN_NUMBERS)
_END_OF_SENTENCE = re.compile(rf"[\n{CELL_END}]|[.;:!?。](?=\s)")
_BLOCK = 256
"""Characters of a text whose failures are looked through together."""
_ASSIGNED = re.compile(r"^[\w.-]*[A-Za-z][\w.-]+=(?:[\"'\w./#%-]*[A-Za-z\"'][\"'\w./#%-]*)$")


def relation_places(text: str) -> list[int]:
    """Return where the relation signs of a prepared text stand, those in the bounds of sums left out."""
    without = _BOUNDS.sub(lambda m: " " * len(m.group()), text)
    return [match.start() for match in _SIGN.finditer(without)]


@dataclass
class Account:
    """What the reader did with a text's relation signs."""

    text: str
    codes: Sequence[tuple[int, int]] = ()
    read: set[int] = field(default_factory=set)
    """Where the signs of the relations read stand."""
    refused: list[tuple[tuple[int, int], ReadingError]] = field(default_factory=list)
    """What could not be read and was not reported, as it may be prose."""

    def settle(
        self, unreadable: Sequence[Unreadable], names: Collection[str], line_of: LineOf
    ) -> tuple[list[Unreadable], list[Passed], list[Explained]]:
        """Return the signs not accounted for yet: unreadable, no mathematics, and letters explained.

        Each of `unreadable` accounts for the first sign in its span that was not read.
        """
        places = relation_places(self.text)
        beyond = places[MOST_SIGNS:]
        spans = sorted(unreadable, key=lambda part: part.span)
        begins = [part.span[0] for part in spans]
        lead = _running_ends(spans)
        counted: set[int] = set()
        more: list[Unreadable] = []
        passed: list[Passed] = []
        explained: list[Explained] = []
        for place in places[:MOST_SIGNS]:
            if place in self.read or (self.text[place] == "!" and place + 1 in self.read):
                continue  # of 3!= 6 in TeX the relation is the =, behind a factorial
            number = bisect_right(begins, place) - 1
            holder = lead[number] if number >= 0 and spans[lead[number]].span[1] > place else None
            if holder is not None:
                if holder in counted:
                    more.append(self._further(place, spans[holder], line_of))
                counted.add(holder)
                continue
            outcome = self._leftover(place, names, line_of)
            if isinstance(outcome, Unreadable):
                more.append(outcome)
            elif isinstance(outcome, Explained):
                explained.append(outcome)
            else:
                passed.append(outcome)
        if beyond:
            what = f"more than {MOST_SIGNS} relation signs: {len(beyond)} were not looked at"
            line, column = line_of(beyond[0])
            more.append(Unreadable(line, column, what, "split the document", (beyond[0], beyond[0] + 1)))
        return more, passed, explained

    @cached_property
    def _refused_near(self) -> dict[int, list[tuple[tuple[int, int], ReadingError]]]:
        """What could not be read, by the blocks of the text it touches: there may be thousands."""
        blocks: dict[int, list[tuple[tuple[int, int], ReadingError]]] = {}
        for (start, end), failure in self.refused:
            for block in range(start // _BLOCK, max(end - 1, start) // _BLOCK + 1):
                blocks.setdefault(block, []).append(((start, end), failure))
        return blocks

    def _further(self, place: int, holder: Unreadable, line_of: LineOf) -> Unreadable:
        """Return a further relation of an equation that is not read."""
        line, column = line_of(place)
        what = f"a part of the equation that is not read: {holder.what}"
        return Unreadable(line, column, what, holder.remedy, self._sides(place))

    def _sides(self, place: int) -> tuple[int, int]:
        """Return the sign with what stands around it, up to the next signs."""
        match = _SIGN.match(self.text, place)
        end = match.end() if match else place + 1
        following = RELATION.search(self.text, end, end + 4 * _AROUND)
        line_end = self.text.find("\n", end)
        stops = [stop for stop in (following.start() if following else -1, line_end) if stop > 0]
        return place, max(min([*stops, len(self.text), end + 4 * _AROUND]), end)

    def _leftover(
        self, place: int, names: Collection[str], line_of: LineOf
    ) -> Unreadable | Passed | Explained:
        line, column = line_of(place)
        span = self._clause(place)
        why = self._why_no_mathematics(place, span, names)
        meaning = self._meaning(place, names) if why in ("", *_SAID_IN_WORDS) else None
        meaning = self._constant(place) if why == SAID_TO_BE_CONSTANT else meaning
        if meaning is not None:
            return self._explained(meaning, line_of)
        if why:
            return Passed(line, column, why, span)
        if (reason := self._unread_sign(place)) is not None:
            return Unreadable(line, column, *reason, span)
        near = self._refused_near.get(place // _BLOCK, ())
        failure = next((f for (a, b), f in near if a <= place < b), None)
        if failure is not None:
            line, column = line_of(failure.offset if span[0] <= failure.offset < span[1] else place)
            return Unreadable(line, column, failure.what, failure.remedy, span)
        before, after = self._neighbours(place)
        word = next((w for w in (before, after) if is_word(w, names)), "")
        if word:
            undeclared = UndeclaredError(place, word)
            return Unreadable(line, column, undeclared.what, undeclared.remedy, span)
        what = "a relation in prose whose sides are not clear"
        return Unreadable(line, column, what, "write it between dollars", span)

    def _meaning(self, place: int, names: Collection[str]) -> Meaning | None:
        """Return the letter that a sign explains in words, None where it does not."""
        sign = _SIGN.match(self.text, place)
        if sign is None or sign[0] not in _EXPLAINING:
            return None
        return meaning_at(self.text, place, sign.end(), names)

    def _explained(self, meaning: Meaning, line_of: LineOf) -> Explained:
        line, column = line_of(meaning.letter[0])
        letter, words = (self.text[slice(*span)] for span in meaning[:2])
        return Explained(line, column, letter, words, (meaning.letter[0], meaning.end))

    def _constant(self, place: int) -> Meaning | None:
        """Return what is said to be constant, ω = const., with the word that says so."""
        said = _CONSTANT.match(self.text, place)
        side = _SIDE_BEFORE.search(self.text, max(place - _AROUND, 0), place)
        if said is None or side is None:
            return None
        words = [match.end() for match in _WORDS_OF_PROSE.finditer(side[0])]
        bare = side[0][words[-1] if words else 0 :].lstrip()
        if not bare.strip():
            return None
        start = place - len(bare)
        word = said.start() + said[0].lower().rindex("onst") - 1
        return Meaning((start, start + len(bare.rstrip())), (word, said.end()), said.end())

    def _unread_sign(self, place: int) -> tuple[str, str] | None:
        """Return why a relation sign is never judged and what to write for it, None for others."""
        if (operation := self._operation_before(place)) is not None:
            word = operation[0].rstrip("( ").split()[0]
            return f"{word}, an operation with its bounds in words", "write it in signs"
        if (unread := UNREAD_RELATIONS.match(self.text, place)) is not None:
            return f"{unread[0]} is not read", "write =, ≈, < or >"
        size = _SIZE.match(self.text, place)
        return None if size is None else (f"{size[0].strip()} between numbers", "write =, < or >")

    def _operation_before(self, place: int) -> re.Match[str] | None:
        """Return where the side before a sign begins an integral or a sum in words, None for others."""
        side = _SIDE_BEFORE.search(self.text, max(place - _AROUND, 0), place)
        return _OPERATION_IN_WORDS.search(side[0]) if side is not None else None

    def _clause(self, place: int) -> tuple[int, int]:
        """Return the part of a line that a sign stands in."""
        first = max(place - _AROUND, 0)
        ends = [match.end() for match in _END_OF_SENTENCE.finditer(self.text, first, place)]
        match = _END_OF_SENTENCE.search(self.text, place + 1, place + _AROUND)
        start = ends[-1] if ends else first
        end = match.start() if match else min(place + _AROUND, len(self.text))
        start += len(self.text[start:place]) - len(self.text[start:place].lstrip())
        return start, max(end, place + 1)

    def _neighbours(self, place: int) -> tuple[str, str]:
        """Return the words or signs next to a relation; for a bracket behind a word, f(x), that word."""
        sign = _SIGN.match(self.text, place)
        end = sign.end() if sign else place + 1
        left = self.text[max(place - _AROUND, 0) : place]
        before = re.search(r"([A-Za-z]\w+)\([^()]*\)\s*$", left) or _BEFORE.search(left)
        after = _AFTER.match(self.text[end : end + _AROUND])
        return before[1] if before else "", after[1] if after else ""

    def _why_no_mathematics(self, place: int, clause: tuple[int, int], names: Collection[str]) -> str:
        """Return why a sign says nothing in mathematics, "" if it may."""
        before, after = self._neighbours(place)
        is_code = any(a <= place < b for a, b in self.codes) and not self._is_formula(clause, names)
        is_value = re.fullmatch(r"[-+−]?[0-9.,]+\W*(?:\w+\W*)?", self._right_side(place))
        reasons = {
            "in a tag": self._is_in_tag(place),
            "in program code": is_code,
            "alone on its line": not before and not after,
            "a setting of TeX": self._is_setting(place),
            "a blank to be filled in": self._is_blank(place),
            "an option or attribute": self._is_option(place) and is_word(before, names),
            "words on both sides": is_word(before, names) and is_word(after, names),
            "the value of a word that is no declared letter": is_value
            and is_word(before, names)
            and self._operation_before(place) is None
            and not _MEASURED_WORD.search(self.text[max(place - _AROUND, 0) : place]),
            SAID_TO_BE_CONSTANT: _CONSTANT.match(self.text, place),
            "a letter explained in words": _is_explanation(before, self._right_side(place), names),
            "the unit of a letter": self._is_unit_of_letter(place),
            "a sum of money": re.match(r"\s*\$[0-9]", self.text[place + 1 : place + 4]),
            "a sign of the layout": before in ("", *"|&-•*") and (not after or is_word(after, names)),
        }
        return next((reason for reason, holds in reasons.items() if holds), "")

    def _is_unit_of_letter(self, place: int) -> bool:
        """Tell whether [F] = N says in what a letter is measured."""
        start = self.text.rfind("[", max(place - _AROUND, 0), place)
        right = re.split(
            r"[$,;)]|\.(?=\s|$)|\s(?:und|and|with|mit)\s", self._right_side(place), maxsplit=1
        )[0]
        if start < 0:
            return False
        return is_unit_of_letter(
            f"{self.text[start : place + 1]}{right}", 0, place + 1 - start + len(right)
        )

    def _is_in_tag(self, place: int) -> bool:
        tags = _TAG.finditer(self.text, max(place - 200, 0), min(place + 200, len(self.text)))
        return self.text[place] in "<>=" and any(tag.start() <= place < tag.end() for tag in tags)

    def _is_setting(self, place: int) -> bool:
        setting = _SETTING.search(self.text[max(place - _AROUND, 0) : place])
        return setting is not None and setting[1] in _SETTINGS

    def _is_blank(self, place: int) -> bool:
        """Tell whether nothing stands right of a sign, nor on the line below: a form's field."""
        rest, _, below = self.text[place + 1 : place + 1 + 4 * _AROUND].partition("\n")
        return not rest.strip() and not below.partition("\n")[0].strip()

    def _is_option(self, place: int) -> bool:
        first = max(self.text.rfind(" ", 0, place), self.text.rfind("\n", 0, place)) + 1
        chunk = re.match(r"\S*", self.text[first : first + 2 * _AROUND])
        return chunk is not None and _ASSIGNED.match(chunk.group().rstrip(".,;)")) is not None

    def _right_side(self, place: int) -> str:
        """Return what stands between a sign and the next word of prose or the end of the clause."""
        rest = self.text[place + 1 : self._clause(place)[1]]
        match = RELATION.search(rest)
        rest = rest[: match.start()] if match else rest
        return re.split(r"\s(?:and|or|und|oder|et|ou)\s", rest, maxsplit=1)[0].strip()

    def _is_formula(self, clause: tuple[int, int], names: Collection[str]) -> bool:
        """Tell whether all the words of a clause are declared letters and functions."""
        words_here = re.findall(r"[^\W\d_]\w*", self.text[slice(*clause)])
        return bool(words_here) and not any(is_word(word, names) for word in words_here)


def _is_explanation(before: str, right: str, names: Collection[str]) -> bool:
    """Tell whether R = crank radius explains a letter: nothing but words stands right of the relation."""
    phrase = re.split(r"[.,;:()、。]|\s[-–—]\s", right, maxsplit=1)[0].replace("$", " ").strip()
    is_letter = len(before) == 1 or not is_word(before, names)
    return is_letter and len(phrase) > 2 and is_meaning(phrase, names)


def _running_ends(spans: Sequence[Unreadable]) -> list[int]:
    """Return for each span which of those that begin so far ends last."""
    result: list[int] = []
    for number, part in enumerate(spans):
        before = result[-1] if result else number
        result.append(number if part.span[1] >= spans[before].span[1] else before)
    return result
