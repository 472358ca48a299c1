"""Components of a bank's force that a page names: "Lh is the horizontal component of L"."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

from symbalance.document.letters import plain_letter
from symbalance.notes.checking.declared.letter_spellings import spellings
from symbalance.notes.checking.declared.page_headings import LONGEST_LINE, is_heading, short_words
from symbalance.notes.checking.declared.proposed_meanings import Proposal, ScopeProposal
from symbalance.text import lazy_patterns as re

_COMPONENT = re.compile(
    r"(?<![A-Za-z])([A-Za-z][A-Za-z0-9_]{0,4})\s*は\s*([A-Za-z][A-Za-z0-9_]{0,4}?)\s*の?\s*(水平|鉛直|垂直)方向の?成分"
    r"|\b([A-Za-z][A-Za-z0-9_]{0,4})\$?\s+(?:is|ist)\s+(?:the|die)\s+(horizontal|vertical|waagerechte|senkrechte|horizontale|"
    r"vertikale)\s+(?:component|part|Komponente)\s+(?:of|von)\s+\$?([A-Za-z][A-Za-z0-9_]{0,4})\b"
)
_IS = "(?:が|=|is|ist|beträgt)"


def force_components(
    lines: Sequence[str], letters: Mapping[str, int], meanings: Mapping[str, Proposal]
) -> Iterator[ScopeProposal]:
    """Yield what a bank's components are, where a page names them and half its bank angle."""
    angle = next((p.letter for p in meanings.values() if p.meaning == "half the bank angle"), "")
    for number, line in enumerate(lines, 1):
        matches = list(_COMPONENT.finditer(line)) if angle and len(line) <= LONGEST_LINE else []
        given = [text for match in matches if (text := _component(match, letters, plain_letter(angle)))]
        if not given:
            continue
        last = next(
            (n - 1 for n in range(number + 1, len(lines) + 1) if is_heading(lines, n)), len(lines)
        )
        around = "\n".join(lines[number - 1 : min(number + 3, last)])
        signs = "|".join(map(re.escape, spellings(angle)))
        statement = re.search(rf"(?:{signs})\$?\s*{_IS}\s*([0-9]{{1,2}})\s*(?:度|°)", around)
        value = [f"{plain_letter(angle)} = {_in_pi(int(statement[1]))}"] if statement else []
        yield ScopeProposal(number, last, {}, (*value, *given), short_words(matches[0][0]))


def _component(match: re.Match[str], letters: Mapping[str, int], angle: str) -> str:
    """Return `Lh = L sin α` for "Lh is the horizontal component of L", its axis α from the vertical."""
    part, whole, direction = match[1] or match[4], match[2] or match[6], match[3] or match[5]
    if part not in letters or whole not in letters or part == whole:
        return ""
    is_across = direction in ("水平", "horizontal", "waagerechte", "horizontale")
    return f"{part} = {whole} {'sin' if is_across else 'cos'} {angle}"


def _in_pi(degrees: int) -> str:
    turn = Fraction(degrees, 180)
    above = "π" if turn.numerator == 1 else f"{turn.numerator} π"
    return above if turn.denominator == 1 else f"{above}/{turn.denominator}"
