"""How far a premise in prose reaches: "Take r = 1" to the next heading, a caption to a blank line."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cached_property

from symbalance.document.formula import Name
from symbalance.notes.reading.equations import Chain, ReadNotes

_HEADING = re.compile(
    r"#{1,6}\s|={2,6}\s*\S.*|<h[1-6]\b"
    r"|\\(?:part|chapter|(?:sub){0,2}section|paragraph|subparagraph)\*?\s*[\[{]",
    re.IGNORECASE,
)
_UNDERLINE = re.compile(r"(?:={3,}|-{3,})\s*$")
_CAPTION = re.compile(
    r"\s*(?:[*_]{0,2}(?:figure|fig\.|table|tab\.|abbildung|abb\.|bild|tabelle)\s*[\d.:a-z(]"
    r"|[*_]{0,2}(?:caption|legende?|bildunterschrift)\s*:|図|表|!\[|\\caption\b)",
    re.IGNORECASE,
)
_IN_BRACKETS = re.compile(r"\s*\([^()\n$]{1,40}\)\s*$")
"""A line of its own in brackets is a remark on what it stands beside: (θ = 90°)."""
_END = r"\s[^.;:!?\n$=]{0,30}$"
_INTRODUCTION = re.compile(
    r"(?<![A-Za-z])(?:take|for|if|assume|assuming|suppose|supposing|when|whenever|choose|at"
    rf"|für|bei|falls|wenn|nimm|angenommen){_END}",
    re.IGNORECASE,
)
_NAMING = re.compile(
    rf"(?<![A-Za-z])(?:let|with|put|set|setting|sei|seien|mit|setze|setzt man){_END}", re.IGNORECASE
)
"""Before a number a premise (let r = 1), before a formula the name of it (let P = m r ω²)."""
_CONSEQUENCE = re.compile(
    r"(?:(?<![A-Za-z\\])(?:therefore|hence|thus|then|dann|so(?!\s+(?:that|dass|daß|as)\b)|consequently|accordingly"
    r"|it\s+follows(?:\s+that)?|(?:this|which)\s+implies|daher|folglich|somit|demnach|mithin"
    r"|daraus\s+folgt|es\s+folgt|hieraus\s+folgt)(?![A-Za-z])"
    r"|\\(?:Rightarrow|implies|Longrightarrow|therefore|Leftrightarrow|iff)(?![A-Za-z])|[⇒⟹⇔∴]"
    r"|よって|したがって|従って|ゆえに|故に)[^.;:!?$=]{0,30}$",
    re.IGNORECASE,
)
_CONDITION = re.compile(
    r"(?:(?<![A-Za-z\\{])(?:where|when|whenever|if|setting|set|solve|solving|condition|equation|root|roots|extremum"
    r"|extrema|maximum|minimum|wo|wenn|falls|setze|setzt|löse|Bedingung|Gleichung|Nullstellen?|Maximum)"
    r"(?![A-Za-z])|条件|方程式|のとき)[^.;!?$=]{0,40}$",
    re.IGNORECASE,
)
"""Before an equation that is to be solved, not claimed for all angles."""
_LINK = re.compile(
    r"(?:[\s,;:.()、。，；：–—-]|\\(?:[,;: !]|quad|qquad|ldots|dots)|(?<![A-Za-zÀ-ÿ])(?:also|and|so"
    r"|hence|thus|therefore"
    r"|whence|ergo|which|this|that|it|we|one|you|i\.?\s?e\.?|is|are|to|say|be|by|in|other|words"
    r"|means?|meaning|gives?|giving"
    r"|yields?|yielding|get|obtain|have|had|find|finally|then|follows?|implies|imply|implying"
    r"|equivalently|because|since|as|but|yet"
    r"|namely|consequently|accordingly|results?|resulting|equals?|means|still|hereby|from|therefrom"
    r"|damit|dann|d\.?\s?h\.?"
    r"|das|dies|heißt|heisst|daher|folglich|somit|mithin|demnach|ist|da|weil|denn|aber|wir|man|also"
    r"|ergibt|liefert|folgt"
    r"|erhalten|erhält|bekommen|bedeutet|schließlich|nämlich|sich|wodurch|woraus|womit|donc|d'où|ce"
    r"|qui|c'est|est|dire|à"
    r"|donne|ainsi|alors|car|puisque|mais|on|obtient|luego|entonces|pues|porque|pero|quindi|dunque"
    r"|perché|cioè|not"
    r"|[mck]?m|kg|g|k?N|k?Nm|rpm|m/s|rad/s|1/s|s)"
    r"(?![A-Za-zÀ-ÿ])|すなわち|つまり|だから|なので|より|から|ので|よって|したがって|従って|ゆえに|故に|である|となる|を得る|が|は)*$",
    re.IGNORECASE,
)
"""Nothing but words that lead from one statement to what is the same or follows."""
_NEW_CASE = re.compile(
    r"(?<![A-Za-zÀ-ÿ\\])(?:for|at|case|cases|now|if|when|whenever|or|with|take|let|put|set|setting|suppose|supposing"
    r"|assume|assuming|choose|another|second|third|fourth|next|instead|otherwise|else|elsewhere|while|whereas"
    r"|respectively|resp|alternatively|again|later|once|new|use|changed?|becomes?|until|through|up|down|to|after|than|until|say"
    r"|example|exercise|problem|variant|version|engine|one|either|both|values?|solutions?|roots?|between|vs"
    r"|für|bei|im|am|fall|falls|fälle|wenn|nun|jetzt|oder|bzw|sei|seien|mit|setze|setzt|nimm|zweite[nrs]?|dritte[nrs]?"
    r"|andere[nrs]?|sonst|dagegen|während|statt|anstelle|beispiel|aufgabe|variante|bis|zu|nach|danach|alternativ|neu|wird"
    r"|lösung(?:en)?|nullstellen?|werte?|hingegen|erst|pour|si|ou|avec|maintenant|cas|sinon|puis|para|sea|con|ahora|caso"
    r"|se|oppure)(?![A-Za-zÀ-ÿ])"
    r"|の場合|のとき|の時|では|とする|とすると|または|あるいは|および|次に|今|いま|例|ならば|なら|まで|一方|他方|別|に対して|解"
    r"|(?:^|[\s(])(?:[0-9]{1,2}|[a-z]|[ivx]{1,4})\)|\\(?:lor|vee|land|wedge|text|mathrm|to|rightarrow)(?![A-Za-z])",
    re.IGNORECASE,
)
"""Between two values of a letter, what says that they belong to two cases."""
_DENIED = re.compile(r"(?<![A-Za-z])(?:not|nicht|never|nie|kein)[\s$\\(]{0,4}$", re.IGNORECASE)
_ROW_OR_ITEM = re.compile(r"\s*(?:\||[-*+•]\s|[0-9]{1,3}[.)]\s|\\item|<t[dr])")
_SPLIT_CLAUSE = re.compile(r"(?<!bzw)(?<!resp)(?<!i\.e)(?<!d\.h)(?<!\bvs)[.!?]\s|;|[。；]|\n\s*\n")
_DISPLAY = re.compile(r"\\(?:begin|end|label|tag)\{[^{}]*\}|^[^\\\s]*\}")
_DISPLAY_LAST = re.compile(r"\s*(?:\\(?:begin|label|tag)\{[^{}]*\}\s*)+$")
_CASE_BEHIND = re.compile(r"[\s$)\]]{0,4}(?:なら|のとき|の時|の場合|とすると|とすれば|では(?=[\s$]))")
"""Behind a relation that is a case, in Japanese."""
_TOP = r"(?:top|inner|upper|oberen?r?|inneren?)\s+(?:dead\s+cent(?:re|er)s?|Totpunkte?s?)|上死点"
_BOTTOM = r"(?:bottom|outer|lower|unteren?r?|äußeren?)\s+(?:dead\s+cent(?:re|er)s?|Totpunkte?s?)|下死点"
_SHORT_TOP, _SHORT_BOTTOM = r"(?<![A-Za-z])(?:TDC|OT)(?![A-Za-z])", r"(?<![A-Za-z])(?:BDC|UT)(?![A-Za-z])"
_DEAD_CENTRE = re.compile(
    rf"(?i:(?P<top>{_TOP})|(?P<bottom>{_BOTTOM}|(?:im|at\s+the|am)\s+(?:unteren|outer|lower|bottom)))"
    rf"|(?P<short_top>{_SHORT_TOP})|(?P<short_bottom>{_SHORT_BOTTOM})"
)
_OPENING = " \t\n$\\([{&"
"""What stands between a word and the formula that it introduces."""
LONGEST_SENTENCE = 160
"""Characters before a relation in which a dead centre may be named."""
LONGEST_INTRODUCTION = 60
"""Characters before a relation in which such a word is looked for."""


@dataclass(frozen=True)
class Sections:
    """The headings and paragraphs of a document."""

    document: ReadNotes

    @cached_property
    def _lines(self) -> list[str]:
        return self.document.text.split("\n")

    @cached_property
    def _headings(self) -> list[int]:
        """The lines, from 1, that begin a section."""
        marked = [k for k, line in enumerate(self._lines, 1) if _HEADING.match(line.lstrip())]
        underlined = [
            k
            for k in range(1, len(self._lines))
            if _UNDERLINE.match(self._lines[k]) and self._lines[k - 1].strip()
        ]
        return sorted({*marked, *underlined})

    def section_end(self, line: int) -> int:
        """Return the last line of the section that a line stands in."""
        after = [heading for heading in self._headings if heading > line]
        return after[0] - 1 if after else len(self._lines)

    def paragraph_end(self, line: int) -> int:
        """Return the last line of the paragraph that a line stands in."""
        for k in range(line, len(self._lines)):
            if not self._lines[k].strip():
                return k
        return len(self._lines)

    def is_in_brackets(self, chain: Chain) -> bool:
        """Tell whether a relation stands in brackets, as the condition of a formula: = 0 (N ≥ 2)."""
        start, end = chain.sides[0].span[0], max(side.span[1] for side in chain.sides)
        before, after = self.document.text[:start].rstrip(" $"), self.document.text[end:].lstrip(" $")
        return before[-1:] == "(" and after[:1] == ")"

    def case_end(self, line: int) -> int:
        """Return the last line of a case: its paragraph, and the displays that stand right below."""
        end = self.paragraph_end(line)
        while (following := self._next_text(end)) and _SET_OFF.match(self._lines[following - 1]):
            end = self.paragraph_end(following)
        return end

    def _next_text(self, line: int) -> int | None:
        """Return the next line that is not blank."""
        return next((k + 1 for k in range(line, len(self._lines)) if self._lines[k].strip()), None)

    def premise_end(self, chain: Chain, *, is_number: bool) -> int | None:
        """Return the last line that a relation reaches if its sentence makes it a premise, else None.

        `is_number` tells whether it gives its letter a number.
        """
        line = chain.lines[0]
        first = self._lines[self.paragraph_start(line) - 1]
        if (chain.inline and _CAPTION.match(first)) or _IN_BRACKETS.match(first):
            return self.paragraph_end(line)
        start = min(side.span[0] for side in chain.sides)
        before = self.document.text[max(0, start - LONGEST_INTRODUCTION) : start]
        before = re.split(r"\n\s*\n", before)[-1].rstrip(" \t\n$\\([")
        if not chain.inline:
            return None
        end = max(side.span[1] for side in chain.sides)
        if _CASE_BEHIND.match(self.document.text, end):
            return self.section_end(line)
        is_premise = _INTRODUCTION.search(before + " ") or (is_number and _NAMING.search(before + " "))
        return self.section_end(line) if is_premise else None

    def is_consequence(self, chain: Chain) -> bool:
        """Tell whether a relation is introduced as what follows: therefore, hence, ⇒."""
        return _CONSEQUENCE.search(self._text_before(chain)) is not None

    def starts_new_case(self, chain: Chain, earlier_line: int, name: str) -> bool | None:
        """Tell whether words before a letter's other value say that it belongs to another case.

        False where they say that it follows or is the same, or there are none; None where they may mean
        either.
        """
        start = min(side.span[0] for side in chain.sides)
        row = self._lines[chain.lines[0] - 1]
        if _ROW_OR_ITEM.match(row):
            return True
        text = self.document.text
        before = [
            other
            for other in self.document.chains
            if other.lines[0] == earlier_line and other is not chain and _end(other) <= start
        ]
        givers = [other for other in before if _gives(other, name)]
        end = max(map(_end, givers or before), default=None)
        if end is None:
            return True  # taken before what stands left of it: x² = 4 for x = 2
        between = list(text[end:start])
        for other in self.document.chains:
            first, last = other.sides[0].span[0], other.sides[-1].span[1]
            if end <= first and last <= start:
                between[first - end : last - end] = " " * (last - first)
        words = "".join(between).replace("$", " ").strip(_OPENING)
        if self.is_consequence(chain):
            return False
        if words.lower() in ("and", "und", "et", "y", "e", "と"):
            return True  # the roots are x = 1 and x = 2
        if _LINK.fullmatch(words):
            return None if ";" in words and any(c.isdigit() for c in text[end:start]) else False
        clause = _SPLIT_CLAUSE.split(words)[-1]
        return True if _NEW_CASE.search(clause) else None

    def is_denied(self, chain: Chain) -> bool:
        """Tell whether a relation stands behind a "not"."""
        start = min(side.span[0] for side in chain.sides)
        return (
            _DENIED.search(self.document.text[max(0, start - LONGEST_INTRODUCTION) : start]) is not None
        )

    def stands_next(self, chain: Chain, line: int) -> bool:
        """Tell whether no other relation stands between a line and a relation below it."""
        start = min(side.span[0] for side in chain.sides)
        return not any(
            line < other.lines[0] and other.sides[0].span[0] < start for other in self.document.chains
        )

    def is_condition(self, chain: Chain) -> bool:
        """Tell whether a relation is introduced as an equation to be solved: where, condition, set."""
        return _CONDITION.search(self._text_before(chain)) is not None

    def dead_centre(self, chain: Chain) -> bool | None:
        """Return whether a relation's sentence names bottom dead centre, False for top, else None."""
        start = min(side.span[0] for side in chain.sides)
        before = re.split(
            r"[.;!?。]\s|\n\s*\n", self.document.text[max(0, start - LONGEST_SENTENCE) : start]
        )[-1]
        matches = list(_DEAD_CENTRE.finditer(before))
        return None if not matches else bool((matches[-1].lastgroup or "").endswith("bottom"))

    def _text_before(self, chain: Chain) -> str:
        """Return the words before a relation, without the marks that begin and end displays."""
        start = min(side.span[0] for side in chain.sides)
        before = self.document.text[max(0, start - LONGEST_INTRODUCTION) : start]
        return _DISPLAY.sub(".", _DISPLAY_LAST.sub("", before.rstrip(_OPENING))).rstrip(_OPENING)

    def same_section(self, first: int, second: int) -> bool:
        """Tell whether no heading stands between two lines."""
        return self.section_end(min(first, second)) >= max(first, second)

    def paragraph_start(self, line: int) -> int:
        """Return the first line of the paragraph that a line stands in."""
        first = line
        while first > 1 and self._lines[first - 2].strip():
            first -= 1
        return first


def _end(chain: Chain) -> int:
    return max(side.span[1] for side in chain.sides)


def _gives(chain: Chain, name: str) -> bool:
    """Tell whether a letter is a side of a chain, alone."""
    return any(isinstance(side.node, Name) and side.node.name == name for side in chain.sides)


_SET_OFF = re.compile(r"\s*(?:\$\$|\\\[|\\begin\s*\{|```math|<math|\+\+\+\+|\[stem\])|\s{4}")
"""How a display begins."""
