"""Checking of a whole document, a file or a text, with the declarations of its letters.

`sidecar_draft` writes the sidecar a document still needs: its undeclared letters, to be given meanings.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Collection, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path, PurePath
from shlex import quote
from typing import TYPE_CHECKING, Any

from symbalance.budgets import Budget, run_within
from symbalance.document.formula import names
from symbalance.document.letters import plain_letter
from symbalance.document.nodes import Code, Strong, Words
from symbalance.errors import SymbalanceError, brief
from symbalance.notes.checking.deciding.guarded_verdicts import PAGE
from symbalance.notes.checking.declared.engines import Engines, NoEngines, Sources
from symbalance.notes.checking.declared.fuller_wordings import with_fuller_roles
from symbalance.notes.checking.declared.sidecar import (
    Declarations,
    Letter,
    UnreadLetter,
    declarations_in,
    parse_sidecar,
    read_sidecar,
    without_header,
)
from symbalance.notes.checking.declared.symbol_roles import readable_letters
from symbalance.notes.checking.declared.symbols import motions_of
from symbalance.notes.checking.judging.arrows import with_arrows
from symbalance.notes.checking.judging.judge import Judge
from symbalance.notes.checking.meant.meant_words import BY_WORDS, FROM_WORDS
from symbalance.notes.checking.page.angle_in_words import with_angle_in_words
from symbalance.notes.checking.page.continued_sums import with_continued_sums
from symbalance.notes.checking.page.expanded_sums import with_expanded_sums
from symbalance.notes.checking.page.letters_anew import with_letters_anew
from symbalance.notes.checking.page.matrix_words import with_matrix_letters
from symbalance.notes.checking.page.page_data import data_of
from symbalance.notes.checking.page.signs_of_motions import with_signs_of_motions
from symbalance.notes.checking.page.sums_by_rule import with_sums_by_rule
from symbalance.notes.checking.page.time_letters import with_time
from symbalance.notes.checking.page.whole_letters import with_whole_letters
from symbalance.notes.checking.reports.written_assumptions import with_cells, with_written_assumptions
from symbalance.notes.checking.units.angles_per_turn import with_turns_divided
from symbalance.notes.checking.verdicts import DECLARES_NOTHING, MOST_LETTERS, UNDECLARED, Checked
from symbalance.notes.checking.words.bare_degrees import with_bare_degrees
from symbalance.notes.checking.words.degrees_without_sign import judge_in_one_unit_of_angle
from symbalance.notes.checking.words.glossary import glossary_of
from symbalance.notes.checking.words.one_reading import judge_in_one_reading
from symbalance.notes.reading import Motions, read_document
from symbalance.notes.reading.equations import ReadNotes
from symbalance.notes.reading.letters.macro_letters import letters_of
from symbalance.notes.reading.markup.notebooks import SUFFIX as NOTEBOOK
from symbalance.notes.reading.markup.notebooks import notebook_text
from symbalance.text import lazy_patterns as re
from symbalance.text.files import STANDARD_INPUT, file_name, read_text

if TYPE_CHECKING:
    from symbalance.notes.checking.declared.declaration_draft import DeclarationDraft

IN_FOLDERS = (
    ".tex",
    ".md",
    ".txt",
    ".text",
    ".ipynb",
    ".markdown",
    ".latex",
    ".wiki",
    ".adoc",
    ".rst",
    ".org",
)
"""What is taken for notes in a folder."""
WEB_PAGES = (".html", ".htm", ".xhtml")
"""Notes too, in a folder those that are no reports of ours."""
SUFFIXES = (*IN_FOLDERS, ".mediawiki", ".asciidoc", ".rest", *WEB_PAGES)
COURSE = "symbols.toml"
"""The file that declares letters for every document of its folder."""


def check(
    document: str | Path,
    symbols: Mapping[str, Any] | str | Path | None = None,
    *,
    engines: Engines | None = None,
    budget: Budget = PAGE,
    accept_proposals: bool = False,
    fixes: bool = True,
) -> Checked:
    """Return the verdicts on every equation of a hand derivation.

    `document` is a file (a Path, or a text that ends as one of SUFFIXES, or `-` for standard input) or
    the derivation itself.
    `symbols` maps letters to their meaning or unit, or is a whole sidecar (keys `symbols`, `scope`,
    `bind`), or the path of one; without it NAME.symbols.toml beside the file is read, or the header of
    the document. `engines` knows the engines that lines are bound to; without it such a line is refused.
    `accept_proposals` takes what a symbols file proposes as confirmed or, where there is none, what the
    document's own words propose (see `sidecar_draft`); the report says so at its head.
    `fixes` searches a refuted line for the smallest change that makes it true, and takes time.
    `budget` is what the document may take, each relation a 60th of the time and a quarter of the memory;
    what takes more is "undecided" with that reason.

        >>> from symbalance.notes.checking import check
        >>> checked = check("$$\\\\sin^2 x = \\\\frac{1 - \\\\cos 2x}{3}$$", {"x": "angle"})
        >>> checked.verdicts[0].verdict, checked.verdicts[0].fix.text
        ('refuted', '(1 - cos 2x)/2')

    Raises SymbalanceError for a file or a declaration that cannot be used; an equation that cannot be
    read is a verdict, not an error.
    """
    text, name, folder = text_of(document)
    declarations, text = declarations_of(document, symbols, text, name)
    has_j = declarations.has_imaginary_j
    declarations = declarations.without_imaginary_unit()
    provider = engines or NoEngines()
    remarks: list[Words] = [_unread(each) for each in declarations.unread]
    is_declared = declarations.is_declared
    if accept_proposals:
        if not is_declared:
            draft = run_within(budget, partial(_draft, text, name, declarations, provider))
            declarations = parse_sidecar(draft.toml(), f"the draft for {name}")
        remarks += _acceptance(declarations)
        declarations = declarations.accepted()
    elif count := declarations.proposal_count:
        remarks.append(_waiting(count))
    letters, motions = _letters_by_line(declarations), _motions_by_line(declarations)
    page = run_within(budget, partial(read_document, text, name, letters, motions, imaginary_j=has_j))
    page = with_bare_degrees(page, only_named=True)
    page, declarations = with_letters_anew(page, declarations.without_idle(page_letters(page)))
    page, declarations = with_signs_of_motions(page, declarations)
    declarations = with_matrix_letters(page, declarations)
    page, declarations = with_angle_in_words(page, declarations)
    declarations = with_whole_letters(page, with_time(page, declarations))
    page = with_continued_sums(with_sums_by_rule(page))
    page = with_expanded_sums(with_turns_divided(page), data_of(page, declarations.symbols_at))
    beside = Path(declarations.place).parent if declarations.place.endswith(".toml") else folder
    sources = Sources(provider, beside)
    start = time.thread_time()

    def judge(notes: ReadNotes) -> Checked:
        """Judge a reading of the page in what is left of its budget."""
        seconds, memory = budget
        left = None if seconds is None else max(seconds - (time.thread_time() - start), 1e-9)
        return Judge(notes, declarations, sources, Budget(left, memory), fixes).check()

    in_one_reading = partial(judge_in_one_reading, judge=judge)
    checked = with_arrows(judge_in_one_unit_of_angle(page, in_one_reading), declarations)
    checked = with_cells(with_written_assumptions(checked))
    if not is_declared and not accept_proposals and (offer := _offer(checked, name)):
        remarks.append(offer)
    return replace(checked, remarks=tuple(remarks), unread_letters=len(declarations.unread))


def page_letters(page: ReadNotes) -> frozenset[str]:
    """Return the letters that stand in a page's formulas."""
    return frozenset(name for chain in page.chains for side in chain.sides for name in names(side.node))


def _unread(letter: UnreadLetter) -> Words:
    """Return what a report says first of a line of the symbols file that declares nothing."""
    return (Strong(DECLARES_NOTHING), f"{letter.place}: {letter.rule}; {letter.remedy}.")


def _acceptance(declarations: Declarations) -> list[Words]:
    """Return what a report says first that rests on proposals nobody has confirmed."""
    count = declarations.proposal_count
    if not count:
        return []
    what = f"{count} proposed {'declaration' if count == 1 else 'declarations'}"
    return [(Strong("Not confirmed: "), f"{what} taken as they are, by --accept-proposals.")]


def _waiting(count: int) -> Words:
    proposals = (
        "1 proposal waits for confirmation and is"
        if count == 1
        else f"{count} proposals wait for confirmation and are"
    )
    remedy = "delete the ? or the line proposed = true of what is right, or add --accept-proposals"
    return f"{proposals} not used: {remedy}."


def _offer(checked: Checked, name: str) -> Words:
    """Return what a document needs that declares nothing, and the command that drafts it."""
    missing = {m[1] for v in checked.verdicts if (m := UNDECLARED.search(v.reason))}
    missing |= set(checked.derivation.free_letters)
    if not missing:
        return ""
    in_words = {letter for letter in missing if _is_said(letter, checked)}
    beside = PurePath(name).with_suffix(".symbols.toml")
    return (
        f"Nobody has said what these letters mean: {_listed(missing - in_words)}. "
        if missing - in_words
        else "",
        f"By the page's own words, which nobody has confirmed: {_listed(in_words)}. " if in_words else "",
        Code(f"symbalance check {quote(name)} --declare -o {quote(str(beside))}"),
        " lists every letter with what the text proposes; ",
        Code("--accept-proposals"),
        " takes the proposals unread.",
    )


def _listed(letters: Collection[str]) -> str:
    """Return letters as a list, the first of many."""
    more = ", …" if len(letters) > MOST_LETTERS else ""
    return ", ".join(map(plain_letter, sorted(letters)[:MOST_LETTERS])) + more


def _is_said(letter: str, checked: Checked) -> bool:
    """Tell whether verdicts rest on words of the page that say what a letter means."""
    head = f"{plain_letter(letter)} is the "
    return any(
        part.startswith(head) and (BY_WORDS in part or FROM_WORDS in part)
        for verdict in checked.verdicts
        if head in verdict.assumption
        for part in _EACH_LETTER.split(verdict.assumption)
    )


_EACH_LETTER = re.compile(r", (?=[^ ,]{1,24} is the )")
"""Between what an assumption says of one letter and of the next."""


def declarations_of(
    document: str | Path, symbols: Mapping[str, Any] | str | Path | None, text: str, name: str
) -> tuple[Declarations, str]:
    """Return what is declared about a document, and its text without a header that declared it."""
    declarations, body = _declarations_as_typed(document, symbols, text, name)
    meanings = " ".join(f"{text}." for text in declarations.symbols.values())

    def english(meaning: str) -> str:
        """Return a meaning in English; it is in the language of the others, or of the page.

        The page's own glossary is asked first: it quotes the terms of both as they are typed.
        """
        page, own = glossary_of(body), glossary_of(meanings)
        return (page if own.language in ("", page.language) else own).english(meaning)

    return with_fuller_roles(declarations, english), body


def _declarations_as_typed(
    document: str | Path, symbols: Mapping[str, Any] | str | Path | None, text: str, name: str
) -> tuple[Declarations, str]:
    path = None if name == "text" else Path(document)
    letter = letters_of(text)
    declarations = _declarations_apart(symbols, path, letter)
    body, header = without_header(text, Path(name).suffix)
    if declarations is not None:
        return declarations, text
    if header:
        declarations, text = parse_sidecar(header, name, letter), body
    course = course_file(path) if path is not None and symbols is None else None
    if course is None:
        return declarations or Declarations(), text
    of_course = _course(course, letter)
    return (declarations.below(of_course) if declarations else of_course), text


def _course(path: Path, letter: Letter) -> Declarations:
    """Return what a folder's file declares for every document in it; what is of lines, it cannot say."""
    declarations = read_sidecar(path, letter)
    of_lines = (declarations.scopes, declarations.bindings, declarations.proposed_scopes)
    if any(of_lines) or declarations.proposed_bindings:
        rule = "holds a [[scope]] or [[bind]], and is for every document of its folder"
        raise SymbalanceError(file_name(path), rule, "put it into NAME.symbols.toml beside its document")
    return declarations


def _letters_by_line(declarations: Declarations) -> Any:
    """Return the letters declared for a line, each set of scopes looked up once."""
    cache: dict[tuple[int, ...], frozenset[str]] = {}

    def names_at(line: int) -> frozenset[str]:
        key = declarations.scope_at(line)
        if key not in cache:
            cache[key] = readable_letters(declarations.symbols_at(line))
        return cache[key]

    return names_at


def _motions_by_line(declarations: Declarations) -> Callable[[int], Motions]:
    """Return the letters declared for a line to move with the crank angle, and what they move with."""
    cache: dict[tuple[int, ...], Motions] = {}

    def motions_at(line: int) -> Motions:
        key = declarations.scope_at(line)
        if key not in cache:
            cache[key] = motions_of(declarations.symbols_at(line))
        return cache[key]

    return motions_at


def text_of(document: str | Path) -> tuple[str, str, Path]:
    """Return a document's text, its name and its folder; a text without a file is called `text`."""
    if not isinstance(document, str | Path):
        raise SymbalanceError(
            f"document = {brief(document)}", "must be a path or a text", 'write check("notes.md")'
        )
    if isinstance(document, str) and ("\n" in document or not is_file_name(document)):
        return document, "text", Path()
    path = Path(document)
    text, name = (
        read_text(path, what="a .tex, .md, .txt, .ipynb, .wiki, .html, .adoc, .rst or .org file"),
        file_name(path),
    )
    is_notebook = path.suffix.lower() == NOTEBOOK
    return (notebook_text(text, name) if is_notebook else text), name, path.parent


def is_file_name(document: str) -> bool:
    """Tell whether a text is the name of a file of notes, or `-` for standard input."""
    return document == STANDARD_INPUT or document.endswith(SUFFIXES)


def _declarations_apart(
    symbols: Mapping[str, Any] | str | Path | None, path: Path | None, letter: Letter
) -> Declarations | None:
    """Return what is declared apart from the document; None where it may have a header of its own."""
    if isinstance(symbols, Mapping):
        return declarations_in(symbols, letter)
    if symbols is not None:
        return read_sidecar(symbols, letter)
    if path is not None:
        for beside in own_sidecars(path):
            declarations, course = read_sidecar(beside, letter), course_file(path)
            return declarations if course is None else declarations.below(_course(course, letter))
    return None


def sidecars_beside(path: Path) -> list[Path]:
    """Return the files that declare a document's letters, its own first, then that of its folder."""
    course = course_file(path)
    return [*own_sidecars(path), *([] if course is None else [course])]


def course_file(path: Path) -> Path | None:
    """Return the file that declares letters for every document of a folder, if there is one."""
    if not path.name or str(path) == STANDARD_INPUT:
        return None
    course = path.with_name(COURSE)
    return course if course.is_file() else None


def own_sidecars(path: Path) -> list[Path]:
    """Return the sidecars that lie beside a document; the first is its own. A pipe has none."""
    if not path.name or str(path) == STANDARD_INPUT:
        return []
    names = (f"{path.stem}.symbols.toml", f"{path.name}.symbols.toml")
    return [beside for name in names if (beside := path.with_name(name)).exists()]


# The sidecar a document still needs


def sidecar_draft(
    document: str | Path,
    symbols: Mapping[str, Any] | str | Path | None = None,
    *,
    engines: Engines | None = None,
    budget: Budget = PAGE,
) -> DeclarationDraft:
    """Return a draft of the symbols file: every letter that is not declared, with proposed meanings.

    `symbols` declares some already, and `budget` is what it may take, as for `check`.

    >>> draft = sidecar_draft("crank radius r\\n\\n$$v = r u$$")
    >>> [row["letter"] for row in draft.records()], draft.records()[0]["meaning"]
    (['r', 'u', 'v'], 'crank radius')
    """
    text, name, _ = text_of(document)
    declarations, text = declarations_of(document, symbols, text, name)
    return run_within(budget, partial(_draft, text, name, declarations, engines or NoEngines()))


def _draft(text: str, name: str, declarations: Declarations, engines: Engines) -> DeclarationDraft:
    from symbalance.notes.checking.declared.declaration_draft import DeclarationDraft
    from symbalance.notes.checking.declared.proposals import (
        propose,  # most checks have their letters declared
    )

    return DeclarationDraft(name, propose(text, name, _letters_by_line(declarations), engines))
