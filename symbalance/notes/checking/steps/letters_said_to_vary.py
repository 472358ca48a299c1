"""A letter that the page says to vary is no constant: F(θ), "F varies with θ", l = l_0 + r cos θ.

Under an integral or a derivative a letter without a formula is a constant, and a verdict says so. Where
the page says otherwise, nothing is proved by that.
"""

from __future__ import annotations

from collections.abc import Iterator

from symbalance.document.formula import Derivative, Name, names, parts_of_kind
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import PROVED_WORDS, UNDECIDED, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_CONSTANT = re.compile(r"(?P<letter>[^\s;,]+) does not depend on (?P<variable>[^\s;,]+)")
_VARIES = (
    r"(?:varies|vary|varying|changes|depends|variable|ändert|veränderlich|schwankt|hängt|variiert|varie|dépend|varia|dipende"
    r"|depende|cambia)"
)
_NEAR = (
    r"[\s$}]{1,4}(?:(?:is|ist|est|itself|then|here|hier|selbst|sich|also|auch|strongly|stark"
    r"|not\s+constant|nicht\s+konstant)\s+){0,2}"
)


def unless_said_to_vary(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; what is proved with a letter as constant that varies by the page is open."""
    if verdict.verdict not in PROVED_WORDS:
        return verdict
    for match in _CONSTANT.finditer(verdict.assumption):
        if _is_said_to_vary(state, match["letter"], match["variable"]):
            reason = f"proved only if {match[0]}, and the page says that it does"
            return describe(state.document, chain, k, Decision(UNDECIDED, reason))
    for letter, variable, line in _formulas_left_out(state, chain, k):
        reason = f"line {line} gives {plain_letter(letter)} a formula with {plain_letter(variable)}"
        return describe(
            state.document, chain, k, Decision(UNDECIDED, f"{reason}, which is not used here")
        )
    return verdict


def _is_said_to_vary(state: JudgingState, letter: str, variable: str) -> bool:
    """Tell whether a page writes a letter as a function of another one, or says that it varies."""
    letters = [n for n in state.letters if plain_letter(n) == letter]
    variables = [
        n for n in (*state.letters, "theta", "phi", "varphi", "t") if plain_letter(n) == variable
    ]
    own = "|".join(re.escape(way) for n in {letter, *letters} for way in (n, f"\\{n}"))
    other = "|".join(re.escape(way) for n in {variable, *variables} for way in (n, f"\\{n}"))
    as_function = rf"(?<![A-Za-z\\_])(?:{own})(?:\\[!,]|\\left|\s)*\(\s*(?:{other})\s*(?:\\right)?\)"
    in_words = rf"(?<![A-Za-z\\_])(?:{own}){_NEAR}{_VARIES}(?![^\W\d_])"
    return re.search(f"{as_function}|{in_words}", state.document.text) is not None


def _formulas_left_out(state: JudgingState, chain: Chain, k: int) -> Iterator[tuple[str, str, int]]:
    """Yield the letters under a derivative whose formula with its variable is open, and not in force."""
    known = state.knowledge(chain.lines[0]).definitions
    for side in chain.sides[k : k + 2]:
        for part in parts_of_kind(side.node, Derivative):
            for letter in sorted(names(part.expression)):
                own = known.get(letter)
                if own is not None and names(own.node):
                    continue
                for line in _lines_with(state, letter, part.variable.name, chain):
                    yield letter, part.variable.name, line


def _lines_with(state: JudgingState, letter: str, variable: str, chain: Chain) -> Iterator[int]:
    for above in state.sections.chains_above(Name(letter), chain.start):
        is_equation = bool(above.relations) and above.relations[0].sign in "=≈"
        place = above.sides[1].span[0] if is_equation else 0
        is_open = is_equation and place not in state.refuted | state.proved | state.stated
        if is_open and variable in names(above.sides[1].node) - {letter}:
            yield above.lines[0]
