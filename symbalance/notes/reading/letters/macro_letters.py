r"""Letters as a document writes them, in macros of its own: \crank, which it defines as \varphi."""

from __future__ import annotations

from collections.abc import Callable

from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.letters.letter_names import canonical_name
from symbalance.notes.reading.markup.macros import definitions_in, expand_macros
from symbalance.text import lazy_patterns as re

_COMMAND = re.compile(r"\\([A-Za-z]+)")


def letters_of(document: str) -> Callable[[str], str]:
    r"""Return what names a letter by a document's own spelling of it, as `canonical_name` does.

    >>> letters_of(r"\newcommand{\crank}{\varphi}")(r"\crank_1"), letters_of("")("λ")
    ('varphi_1', 'lambda')

    What is returned raises ReadingError for anything but one letter.
    """
    expanded = _expander(document)
    return lambda text: canonical_name(expanded(text))


def formulas_of(document: str) -> Callable[[str], str]:
    r"""Return what puts a formula of a document without its own macros.

    >>> formulas_of(r"\newcommand{\dg}{^{\circ}}")(r"120\dg"), formulas_of("")(r"120\dg")
    ('120^{\\circ}', '120\\dg')
    """
    expanded = _expander(document)
    return lambda text: expanded(text).strip()


def _expander(document: str) -> Callable[[str], str]:
    """Return what expands a document's own macros in a text."""
    definitions = definitions_in(document) if "\\" in document else None
    preamble = "" if definitions is None else "".join(document[a:b] for a, b in definitions.spans)
    macros = set() if definitions is None else set(definitions.by_name)

    def expanded(text: str) -> str:
        if macros.isdisjoint(_COMMAND.findall(text)):
            return text
        source = expand_macros(f"{preamble}\n{text}").source
        return text if source is None else source.text

    return expanded


def letter_in(document: str, text: str) -> str | None:
    r"""Return the name of a letter as a document spells it, None for what is no letter there.

    >>> letter_in(r"\newcommand{\crank}{\varphi}", r"\crank"), letter_in("", r"\crank")
    ('varphi', None)
    """
    try:
        return letters_of(document)(text)
    except ReadingError:
        return None
