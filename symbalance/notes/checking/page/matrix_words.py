"""Letters that a page calls matrices, or takes the determinant of, where nobody has declared them.

Read as numbers their products would commute: for matrices A and B (A + B)² = A² + 2AB + B² would hold.
Where others stand beside them of which nobody says what they are, nothing is known of their products.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Apply, Name, Product, names, walk
from symbalance.notes.checking.declared.sidecar import Declarations
from symbalance.notes.reading.equations import ReadNotes
from symbalance.text import lazy_patterns as re

_LETTER = (
    r"[\s$({]{0,4}(?:\\(?:mathbf|boldsymbol|bm|mathsf|underline)\s*)?\{?(?P<%s>[A-Z])\}?"
    r"(?P<%s>_\{?[A-Za-z0-9]{1,3}\}?)?(?![A-Za-z0-9_'])\$?"
)
_MEMBERS = ("first", "second", "third", "fourth")
_MORE = "".join(
    rf"(?:\s*(?:,|,?\s+(?:and|und|et|y))\s*{_LETTER % (name, name + '_index')})?" for name in _MEMBERS[1:]
)
_SAID = re.compile(
    rf"(?<![A-Za-z])(?:matri(?:x|ces)|Matri(?:x|zen)|行列){_LETTER % ('first', 'first_index')}{_MORE}"
)


def with_matrix_letters(page: ReadNotes, declarations: Declarations) -> Declarations:
    """Return the declarations with the letters that the words of a page call matrices."""
    used = {name for chain in page.chains for side in chain.sides for name in names(side.node)}
    declared = {*declarations.symbols, *(name for scope in declarations.scopes for name in scope.symbols)}
    said = {name: "matrix" for name in _of_determinants(page) if name not in declared}
    for match in _SAID.finditer(page.text):
        for member in _MEMBERS:
            index = re.sub(r"[_{}]", "", match[f"{member}_index"] or "")
            name = f"{match[member]}_{index}" if index else match[member]
            if name in used and name not in declared:
                said[name] = "matrix"
    for chain in page.chains:
        own = chain.letters & said.keys()
        if own and not set(chain.letters) <= {*said, *declared}:  # M x, where x may be a vector or not
            said = {name: meaning for name, meaning in said.items() if name not in own}
    return replace(declarations, symbols={**declarations.symbols, **said}) if said else declarations


def _of_determinants(page: ReadNotes) -> set[str]:
    """Return the capital letters whose determinant a page takes, alone or as a product of them."""
    nodes = [part for chain in page.chains for side in chain.sides for part in walk(side.node)]
    inner = [node.arguments[0] for node in nodes if isinstance(node, Apply) and node.function == "det"]
    parts = [node.factors if isinstance(node, Product) else (node,) for node in inner]
    letters = {p.name for own in parts for p in own if isinstance(p, Name)}
    return {name for name in letters if name[:1].isupper()}
