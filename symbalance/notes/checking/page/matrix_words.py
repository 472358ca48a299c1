"""Letters that a page calls matrices, or takes the determinant of, where nobody has declared them.

Read as numbers their products would commute: for matrices A and B (A + B)² = A² + 2AB + B² would hold.
Where others stand beside them of which nobody says what they are, nothing is known of their products.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import replace
from itertools import pairwise

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
    rf"(?<![A-Za-z])(?:[Mm]atri(?:x|ces|zen)|[Mm]atrici|行列){_LETTER % ('first', 'first_index')}{_MORE}"
)

_WORD = (
    r"(?<![A-Za-z])(?:\w+\s)?(?:matri(?:x|ces)|\w*[Mm]atri(?:x|zen)|matrici|matrices)(?![A-Za-z])|行列"
)
_AND = r"\s*(?:,|,?\s*(?:and|und|et|y|e|と)(?![A-Za-z]))"
_CALLED = re.compile(
    rf"(?<![A-Za-z\\_^]){_LETTER % ('first', 'first_index')}"
    + "".join(rf"(?:{_AND}{_LETTER % (name, name + '_index')})?" for name in _MEMBERS[1:])
    + r"\s*(?P<said>(?:be|are|is|sind|ist|deux|due|dos|zwei|two|sont|est|son|sono)(?![A-Za-z])|[をはが])?"
    r"\s*"
    r"(?:(?!(?:in|of|by|with|from|for|von|de[rsmn]?|du)\s)[^\s.;:=]{1,20}\s+){0,4}"
    rf"(?:{_WORD})"
)
"""Letters and behind them what they are: let A and B be two matrices."""
_OF_ANY = re.compile(
    r"(?<![A-Za-z])(?:two|any|all|square|arbitrary|zwei(?:er)?|alle[nr]?|beliebige[nr]?|deux|dos|due)\s+(?:square\s+)?"
    r"(?:matrices|Matrizen|matrici)[^.;=\n]{0,40}$"
)
"""Before a formula that is said of matrices without naming them first."""
_COMMUTE = re.compile(
    r"commut|vertausch|kommut|conmut|可換|交換|[Dd]iagonal|diagonale|対角|(?:same|common)\s+axis|(?:gleichen?|selben?)\s+Achse|même\s+axe"
    r"|(?<![A-Za-z])(?:plane|scalar|powers?)(?![A-Za-z])|[Ee]bene|2\s*D(?![A-Za-z])|two-dimensional|平面|begin\{.?matrix"
)
"""Words of matrices whose product may be taken in either order."""
_SUPPOSED = re.compile(
    r"(?<![A-Za-z])(?:with|where|if|such\s+that|for\s+which|mit|wenn|falls|avec|si|con|supposing|suppose|assume|assuming)"
    r"[\s$,]*$"
)
_LONGEST = 120
"""Characters of a sentence before a formula that are looked at."""


def with_matrix_letters(page: ReadNotes, declarations: Declarations) -> Declarations:
    """Return the declarations with the letters that the words of a page call matrices."""
    used = {name for chain in page.chains for side in chain.sides for name in names(side.node)}
    declared = {*declarations.symbols, *(name for scope in declarations.scopes for name in scope.symbols)}
    said = {name: "matrix" for name in _of_determinants(page) if name not in declared}
    may_commute = _COMMUTE.search(page.text) is not None or _supposes_that_they_commute(page)
    called = () if may_commute else _CALLED.finditer(page.text)
    sure = (match for match in called if match["said"] or match["second"])  # A matrix is no letter
    for match in (*_SAID.finditer(page.text), *sure):
        for member in _MEMBERS:
            index = re.sub(r"[_{}]", "", match[f"{member}_index"] or "")
            name = f"{match[member]}_{index}" if index else match[member]
            if name in used and name not in declared:
                said[name] = "matrix"
    for chain in () if may_commute else page.chains:
        begin = chain.sides[0].span[0]
        is_said = _OF_ANY.search(page.text[max(begin - _LONGEST, 0) : begin].rstrip(" $\\(["))
        if is_said and all(name[:1].isupper() and name not in declared for name in chain.letters):
            said |= dict.fromkeys(chain.letters, "matrix")
    for name in list(_products_of(page, said)):
        if name not in declared:
            said[name] = "matrix"
    for chain in page.chains:
        own = chain.letters & said.keys()
        if own and not set(chain.letters) <= {*said, *declared}:  # M x, where x may be a vector or not
            said = {name: meaning for name, meaning in said.items() if name not in own}
    return replace(declarations, symbols={**declarations.symbols, **said}) if said else declarations


def _products_of(page: ReadNotes, said: Collection[str]) -> Iterator[str]:
    """Yield the capital letters that a page sets equal to products of matrices: C = A B."""
    for chain in page.chains:
        for first, second in pairwise(side.node for side in chain.sides):
            for head, other in ((first, second), (second, first)):
                is_product = isinstance(other, Product) and set() < names(other) <= {*said}
                if is_product and isinstance(head, Name) and head.name[:1].isupper():
                    yield head.name


def _of_determinants(page: ReadNotes) -> set[str]:
    """Return the capital letters whose determinant a page takes, alone or as a product of them."""
    nodes = [part for chain in page.chains for side in chain.sides for part in walk(side.node)]
    inner = [node.arguments[0] for node in nodes if isinstance(node, Apply) and node.function == "det"]
    parts = [node.factors if isinstance(node, Product) else (node,) for node in inner]
    letters = {p.name for own in parts for p in own if isinstance(p, Name)}
    return {name for name in letters if name[:1].isupper()}


def _supposes_that_they_commute(page: ReadNotes) -> bool:
    """Tell whether a page takes matrices with AB = BA."""
    for chain in page.chains:
        nodes = [side.node for side in chain.sides]
        begin = chain.sides[0].span[0]
        is_given = _SUPPOSED.search(page.text[max(begin - _LONGEST, 0) : begin]) is not None
        pairs = pairwise(nodes)
        if is_given and any(
            isinstance(a, Product) and isinstance(b, Product) and _letters(a) == _letters(b)[::-1]
            for a, b in pairs
        ):
            return True
    return False


def _letters(node: Product) -> list[str]:
    return [factor.name for factor in node.factors if isinstance(factor, Name)]
