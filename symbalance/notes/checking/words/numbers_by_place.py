"""Which of several numbers of a letter a result goes with by its place: its column, its index, its turn.

A table with an engine in each column has each engine's results in its own. G_A is of what is labelled
A. Of r = 40 mm and r = 50 mm, s = 80 mm and s = 100 mm "respectively", the first goes with the first.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from symbalance.document.formula import Name
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.checking.words.table_cells import cells_of
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_RESPECTIVELY = re.compile(
    r"(?<![^\W\d_])(?:respectively|resp\.|beziehungsweise|bzw\.|jeweils|respectivement|rispettivamente"
    r"|respectivamente)(?![^\W\d_])|それぞれ",
    re.IGNORECASE,
)
SENTENCE_END = re.compile(r"(?<![0-9])(?<!bzw)(?<!resp)[.!?](?=\s|$)|。|\n\s*\n")
_BESIDE = re.compile(
    r"[\s$)}\]]*(?:,?\s*(?<![^\W\d_])(?:and|or|und|oder|bzw\.|resp\.|et|ou|e|o|y)(?![^\W\d_])|,|と|または|、)[\s$({\[]*",
    re.IGNORECASE,
)
"""Between two results in a row, one for each of the numbers before: s = 80 mm or s = 100 mm."""


def by_own_column(text: str, chain: Chain, givers: Sequence[Chain]) -> int | None:
    """Return the only number in a relation's column of a table, where the others stand in its others."""
    tables = cells_of(text)
    cell = tables.at(chain.start)
    if cell is None or not cell.column:
        return None
    heads = [
        None if (c := tables.at(g.start)) is None or not c.column else c.labels[0].span for g in givers
    ]
    beside = {other.span for other in cell.others}
    own = [n for n, head in enumerate(heads) if head == cell.labels[0].span]
    is_table = all(head is not None and (n in own or head in beside) for n, head in enumerate(heads))
    return own[-1] if own and is_table and len(own) < len(givers) else None


def by_index(sections: Sections, chain: Chain, own: Sequence[frozenset[str]]) -> int | None:
    """Return the only number whose words are the index of the letter worked out: G_A of "engine A".

    A digit may be an order: it counts where the results beside it have the other digits.
    """
    index = _index(chain)
    named = [n for n, each in enumerate(own) if index and index in each]
    if len(named) != 1:
        return None
    if index.isdecimal():
        first = sections.start_of_line(sections.paragraph_start(chain.lines[0]))
        last = sections.start_of_line(sections.paragraph_end(chain.lines[0]) + 1)
        stem = _stem(chain)
        beside = [c for c in sections.chains_between(first, last) if _stem(c) == stem and c is not chain]
        if not any(_index(c) != index and any(_index(c) in each for each in own) for c in beside):
            return None
    return named[0]


def by_order(sections: Sections, text: str, chain: Chain, givers: Sequence[Chain]) -> int | None:
    """Return the number of a result's own turn in a sentence that says "respectively".

    Without that word as many results in a row as there are numbers in a row go with these too.
    """
    start = givers[0].start
    if givers[-1].end > chain.start or SENTENCE_END.search(text, start, chain.start):
        return None
    match = SENTENCE_END.search(text, chain.end)
    end = match.start() if match is not None else len(text)
    between = sections.chains_between(givers[-1].end, end)
    results = [c for c in between if _stem(c) == _stem(chain)]
    if len(results) != len(givers) or chain not in results:
        return None
    is_said = _RESPECTIVELY.search(text, start, end) is not None
    is_in_rows = len(givers) > 1 and all(_stand_in_row(text, row) for row in (givers, results))
    return results.index(chain) if is_said or is_in_rows else None


def _stand_in_row(text: str, row: Sequence[Chain]) -> bool:
    """Tell whether nothing but "and", "or" and commas stands between relations."""
    return all(_BESIDE.fullmatch(text, a.end, b.start) for a, b in pairwise(row))


def _index(chain: Chain) -> str:
    head = chain.sides[0].node
    return head.name.rpartition("_")[2] if isinstance(head, Name) and "_" in head.name else ""


def _stem(chain: Chain) -> str:
    head = chain.sides[0].node
    return head.name.partition("_")[0] if isinstance(head, Name) else ""
