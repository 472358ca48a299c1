"""Draft of a symbols file: every letter of a page, with proposed meanings that a person confirms.

A proposal stands behind a question mark, `s = "? stroke"`: until the mark is deleted, s is just a letter.
A proposed scope or binding says `proposed = true`, and plays no part before that line is deleted.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

from symbalance.document.formula import Equation, Formula, Name
from symbalance.document.letters import plain_letter
from symbalance.document.nodes import Code, Column, Document, Paragraph, Strong, Table, Words, blocks
from symbalance.document.result import Result
from symbalance.errors import SymbalanceError, visible
from symbalance.notes.checking.declared.proposals import Proposals
from symbalance.notes.checking.declared.proposed_bindings import BindProposal
from symbalance.notes.checking.declared.proposed_meanings import ScopeProposal
from symbalance.notes.checking.declared.sidecar import PROPOSED
from symbalance.notes.checking.declared.symbol_roles import KNOWN
from symbalance.notes.reading import ReadingError, read_equation

_USUAL = "usual for this letter; the text does not say"


@dataclass(frozen=True, repr=False)
class DeclarationDraft(Result):
    """What a page's letters are proposed to mean, and what its lines are proposed to claim."""

    name: str
    proposals: Proposals

    kind: ClassVar[str] = "declaration-draft"
    record_keys: ClassVar[tuple[str, ...]] = ("letter", "line", "meaning", "from_line", "words")

    def summary(self) -> str:
        """Return how many letters there are, and for how many a meaning is proposed."""
        letters, known = len(self.proposals.letters), len(self.proposals.meanings)
        more = len(self.proposals.scopes) + len(self.proposals.bindings)
        return (
            f"Letters of {visible(self.name)}: {letters}, a meaning proposed for {known}; "
            f"{more} further proposals on lines"
        )

    def toml(self) -> str:
        """Return the draft as a symbols file."""
        proposed = self.proposals
        lines = [
            f"# Letters of {visible(self.name)}.",
            "# Behind a question mark: proposed, not believed. Delete the mark of what is right,",
            "# and the line `proposed = true` of a scope or binding that is right.",
            "",
            "[symbols]",
        ]
        lines += [self._symbol(letter, line) for letter, line in proposed.letters.items()]
        for scope in proposed.scopes:
            lines += ["", *_scope(scope)]
        for binding in proposed.bindings:
            lines += ["", *_binding(binding)]
        return "\n".join(lines) + f"\n\n{_known_meanings()}\n"

    def _symbol(self, letter: str, line: int) -> str:
        proposal = self.proposals.meanings.get(letter)
        meaning = f"{PROPOSED} {proposal.meaning}" if proposal else ""
        entry = f"{_text(plain_letter(letter))} = {_text(meaning)}"
        if proposal is None:
            return f"{entry:<40}  # line {line}"
        why = f"line {proposal.line}: {proposal.words}" if proposal.words else f"line {line}: {_USUAL}"
        return f"{entry:<40}  # {visible(why)}"

    def document(self) -> Document:
        """Return the letters as they are read with what is proposed of each, then scopes and bindings."""
        proposed = self.proposals
        columns = tuple(Column(head) for head in ("letter", "first on line", "proposed", "taken from"))
        rows = tuple(
            (Name(letter), str(line), *self._proposed(letter))
            for letter, line in proposed.letters.items()
        )
        letters = Table("Letters", columns, rows, empty="every letter is declared")
        scopes = tuple(
            (f"{scope.first}–{scope.last}", *_equalities(scope), scope.words) for scope in proposed.scopes
        )
        bindings = tuple(
            (str(each.keys["line"]), _claim(each.keys), each.words) for each in proposed.bindings
        )
        lead = ("Nothing here is believed until it is ", Strong("confirmed"), " in the symbols file.")
        return Document(
            ("Letters of ", Code(self.name)),
            blocks(
                letters,
                Table("Proposed on some lines", _heads("lines", "proposed", "taken from"), scopes)
                if scopes
                else None,
                Table("Proposed claims", _heads("line", "claims to be", "taken from"), bindings)
                if bindings
                else None,
                Paragraph(("Known meanings: ", ", ".join(KNOWN), ".")),
            ),
            lead,
        )

    def _proposed(self, letter: str) -> tuple[Words, Words]:
        proposal = self.proposals.meanings.get(letter)
        if proposal is None:
            return ("", "")
        return proposal.meaning, f"line {proposal.line}: {proposal.words}" if proposal.words else _USUAL

    def data(self) -> dict[str, Any]:
        """Return every letter with what is proposed of it, and the proposed scopes and bindings."""
        return {
            "document": self.name,
            "letters": self.records(),
            "scopes": [
                {
                    "lines": [scope.first, scope.last],
                    "symbols": {plain_letter(name): text for name, text in scope.symbols.items()},
                    "given": list(scope.given),
                    "words": scope.words,
                }
                for scope in self.proposals.scopes
            ],
            "bindings": [{**each.keys, "words": each.words} for each in self.proposals.bindings],
        }

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each letter; what is not proposed is None."""
        rows = []
        for letter, line in self.proposals.letters.items():
            proposal = self.proposals.meanings.get(letter)
            rows.append(
                {
                    "letter": plain_letter(letter),
                    "line": line,
                    "meaning": proposal.meaning if proposal else None,
                    "from_line": proposal.line if proposal else None,
                    "words": (proposal.words or None) if proposal else None,
                }
            )
        return rows


def _heads(*heads: str) -> tuple[Column, ...]:
    return tuple(map(Column, heads))


def _text(text: str) -> str:
    """Return a text as TOML writes it, with nothing in it that a reader does not see."""
    return '"' + visible(text).replace("\\", "\\\\").replace('"', '\\"') + '"'


def _scope(scope: ScopeProposal) -> list[str]:
    symbols = ", ".join(f"{_text(plain_letter(n))} = {_text(text)}" for n, text in scope.symbols.items())
    given = ", ".join(map(_text, scope.given))
    return [
        f"[[scope]]                       # {visible(scope.words)}",
        "proposed = true",
        f"lines = [{scope.first}, {scope.last}]",
        *([f"symbols = {{ {symbols} }}"] if symbols else []),
        *([f"given = [{given}]"] if given else []),
    ]


def _binding(binding: BindProposal) -> list[str]:
    keys = [
        f"{key} = {value if isinstance(value, int) else _text(value)}"
        for key, value in binding.keys.items()
    ]
    return [f"[[bind]]                        # {visible(binding.words)}", "proposed = true", *keys]


def _equalities(scope: ScopeProposal) -> tuple[Words]:
    """Return what holds in a scope, as words and formulas."""
    parts: list[Any] = []
    for name, text in scope.symbols.items():
        parts += [", " if parts else "", Name(name), f": {text}"]
    for text in scope.given:
        parts += [", " if parts else "", _equation(text)]
    return (tuple(parts),)


def _equation(text: str) -> Equation | Formula | Code:
    """Return `Lh = L sin α` as an equation; as it is written where it cannot be read."""
    letters = {text.split("=", maxsplit=1)[0].strip()}
    try:
        chain = read_equation(text, {*letters, *text.replace("=", " ").split()} - {"sin", "cos"})
    except (ReadingError, SymbalanceError):
        return Code(text)
    return Equation(chain.sides[0].node, (("=", chain.sides[1].node),))


def _claim(keys: Mapping[str, str | int]) -> str:
    order, engine = keys.get("order"), keys.get("engine")
    parts = [
        str(keys["quantity"]),
        f"order {order}",
        *([f"bank {keys['bank']}"] if "bank" in keys else []),
    ]
    return ", ".join(parts) + (f" of {engine}" if engine else "")


# One draft for several documents


def course_toml(drafts: Sequence[DeclarationDraft]) -> str:
    """Return one symbols file for several documents: each letter, how many have it, what they propose.

    Where documents say different things of a letter, none is proposed and all are named: whichever stood
    there would accuse right lines of the others. What is of single lines stays with each document.
    """
    users: dict[str, list[tuple[str, int]]] = {}
    meanings: dict[str, Counter[str]] = {}
    usual: dict[str, str] = {}
    reasons: dict[tuple[str, str], str] = {}
    for draft in drafts:
        for letter, line in draft.proposals.letters.items():
            users.setdefault(letter, []).append((draft.name, line))
            proposal = draft.proposals.meanings.get(letter)
            if proposal is None:
                continue
            if proposal.words:
                meanings.setdefault(letter, Counter())[proposal.meaning] += 1
            else:
                usual[letter] = proposal.meaning
            words = f"{draft.name}, line {proposal.line}: {proposal.words}" if proposal.words else _USUAL
            reasons.setdefault((letter, proposal.meaning), words)
    count = len(drafts)
    lines = [
        f"# Letters of {count} {'document' if count == 1 else 'documents'}; symbols.toml in their folder "
        "declares them for all.",
        "# Behind a question mark: proposed, not believed. Delete the mark of what is right.",
        "",
        "[symbols]",
    ]
    for letter in sorted(users, key=lambda each: (-len(users[each]), each)):
        ranked = meanings.get(letter, Counter()).most_common()
        best = ranked[0][0] if len(ranked) == 1 else "" if ranked else usual.get(letter, "")
        name, line = users[letter][0]
        why = reasons[letter, best] if best else f"{name}, line {line}"
        if len(ranked) > 1:
            why = "they differ: " + ", ".join(f"{meaning} ({n})" for meaning, n in ranked)
        entry = f"{_text(plain_letter(letter))} = {_text(f'{PROPOSED} {best}' if best else '')}"
        lines.append(f"{entry:<40}  # {len(users[letter])} of {count}; {visible(why)}")
    return "\n".join(lines) + f"\n\n{_known_meanings()}\n"


def _known_meanings() -> str:
    meanings = "\n".join(f"#   {meaning}" for meaning in KNOWN)
    return f"# meanings the checker knows; any other text is just a letter:\n{meanings}"
