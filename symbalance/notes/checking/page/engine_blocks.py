"""Ways back to an engine: "Engine A: N = 4. Engine B: N = 6. Engine A: 2N = 8" is right of the first.

Lines that begin with such a label open a block; what a page gives letters there holds again wherever it
comes back to the label.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.notes.checking.premises.definitions import Definitions
from symbalance.notes.checking.words.sections import Sections
from symbalance.text import lazy_patterns as re

_LABEL = re.compile(
    r"^[ \t>*_#|•-]*+(?P<kind>engine|motor|version|variante?|design|layout|machine|maschine|case|fall"
    r"|option|configuration|konfiguration|機関|エンジン|ケース)\s*(?P<own>[A-Z]|[IVX]{1,4}|[0-9]{1,2})(?![A-Za-z0-9])[*_]*\s*"
    r"(?:\([^()\n]{0,40}\)\s*)?[*_]*(?:[:.：)—–]|$)",
    re.IGNORECASE | re.MULTILINE,
)


class EngineBlocks:
    """The labelled blocks of a page, and the one that was judged last."""

    def __init__(self, text: str, sections: Sections) -> None:
        self.sections = sections
        self.starts = [
            (text.count("\n", 0, match.start("kind")) + 1, f"{match['kind'].lower()} {match['own']}")
            for match in _LABEL.finditer(text)
        ]
        self.current = ""

    def label_at(self, line: int) -> str:
        """Return the label of the block that a line stands in, "" for none."""
        before = [(start, label) for start, label in self.starts if start <= line]
        if not before:
            return ""
        start, label = before[-1]
        return label if self.sections.same_section(start, line) else ""

    def enter(self, line: int, definitions: Definitions) -> None:
        """Take up the values of a block's earlier part where the page comes back to its label."""
        label, before = self.label_at(line), self.current
        self.current = label
        if not label or label == before:
            return
        for entries in definitions.values.values():
            own = [e for e in entries if self.label_at(e.definition.line) == label]
            last = entries[-1] if entries else None
            if own and last is not None and self.label_at(last.definition.line) not in ("", label):
                entries.append(replace(own[-1], last_line=None))
        definitions.premises = [p for p in definitions.premises if self.label_at(p.line) in ("", label)]
