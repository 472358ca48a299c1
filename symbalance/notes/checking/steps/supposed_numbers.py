"""Numbers that a sentence only supposes: if k were 3, i.e. k = 3, then 2k = 6; but k = 5.

Such a number ends with its sentence, and the letter is again what it was.
"""

from __future__ import annotations

from symbalance.document.formula import Name, names
from symbalance.notes.checking.premises.definitions import Entry
from symbalance.notes.checking.premises.system import Premise
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_LONGEST = 160
"""Characters before a number in which its sentence begins."""
_SENTENCE_END = re.compile(r"(?<!i\.e)(?<!e\.g)(?<!d\.h)(?<!z\.B)[.!?]\s|[。]|\n\s*\n")
_SUPPOSED = re.compile(
    r"(?<![^\W\d_])(?:if\s[^.;]{0,60}\swere|were\s[^.;]{0,20}\s(?:equal|to\s+be|only)|would|wäre\w*|hätte\w*"
    r"|würde\w*|si\s[^.;]{0,40}(?:était|valait)|serait|se\s[^.;]{0,40}\sfosse"
    r"|si\s[^.;]{0,40}\sfuera)(?![^\W\d_])",
    re.IGNORECASE,
)
"""Words of what is not so; "suppose" opens a case that goes on: suppose θ = 70°. Then φ = 15.8°."""


class SupposedNumbers:
    """What letters were before a sentence supposed another number of them."""

    def __init__(self) -> None:
        self._before: dict[str, tuple[int, list[Entry], list[Premise]]] = {}

    def enter(self, state: JudgingState, chain: Chain) -> None:
        """Give letters back what they were where their sentence has ended; note what one supposes."""
        definitions = state.definitions
        for name, (end, entries, premises) in list(self._before.items()):
            if chain.start < end:
                continue
            definitions.values[name] = entries
            kept = [p for p in definitions.premises if p.left != Name(name) or p in premises]
            definitions.premises = kept
            del self._before[name]
        head = chain.sides[0].node
        if not isinstance(head, Name) or len(chain.sides) < 2 or names(chain.sides[1].node):
            return
        text = state.document.text
        before = _SENTENCE_END.split(text[max(0, chain.start - _LONGEST) : chain.start])[-1]
        entries = definitions.values.get(head.name)
        if not entries or head.name in self._before or not _SUPPOSED.search(before):
            return
        match = _SENTENCE_END.search(text, chain.end)
        end = len(text) if match is None else match.start()
        self._before[head.name] = end, [*entries], [*definitions.premises]
