"""The report on a checked derivation: counts, then each relation with its verdict and reasons."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from symbalance.document.fitting import plain_words
from symbalance.document.formula import Equation, Formula, Name
from symbalance.document.nodes import (
    Code,
    Document,
    Facts,
    Inline,
    Paragraph,
    Source,
    SourceLine,
    Words,
)
from symbalance.document.text_writer import formula_text
from symbalance.notes.checking.deciding.descriptions import rounded_number
from symbalance.notes.checking.reports.typeset_relations import (
    Sides,
    as_written,
    is_readable,
    sides_by_span,
    typeset,
)
from symbalance.notes.checking.verdicts import (
    CONDITION,
    CONDITIONAL,
    CONTRADICTION,
    DEFINITION,
    FAILING,
    HOLDS,
    HOLDS_TO_ORDER,
    NOT_MATHEMATICS,
    PREMISE,
    RANGE,
    REFUTED,
    UNDECIDED,
    UNREADABLE,
    VERDICTS,
    Checked,
    Difference,
    Fault,
    Verdict,
)
from symbalance.notes.reading.equations import as_shown

LONGEST_SOURCE = 600
"""Characters of a relation that are shown; the rest is in the JSON."""
LONGEST_BOTH = 200
"""Of both sides of a relation that is wrong, of which a reader wants to see what is set equal."""
LONGEST_PIECE = 60
"""Of a wrong piece, which stands within a sentence."""
DIGITS, NOISE = 6, 1e-15
"""Of a number at a witness, and what of it is rounding."""

_TITLES = {
    HOLDS: "holds",
    HOLDS_TO_ORDER: "holds to order",
    CONDITIONAL: "holds if",
    REFUTED: "REFUTED",
    CONTRADICTION: "CONTRADICTION",
    UNDECIDED: "UNDECIDED",
    DEFINITION: "definition",
    PREMISE: "premise",
    CONDITION: "condition",
    RANGE: "range",
    UNREADABLE: "UNREADABLE",
}
_DIGITS_AND_TERMS = ("the digits printed", "leading term", "the leading term of each harmonic")
"""Orders that are no power of a letter."""
_MEANINGS = {
    HOLDS: "proved, for all values of the letters",
    HOLDS_TO_ORDER: "proved through the order named, in the powers that the line keeps",
    CONDITIONAL: "proved under the assumption named",
    REFUTED: "different: the witness is a point, with the value of each side there",
    UNDECIDED: "neither proved nor refuted",
    CONTRADICTION: "cannot be true together with the lines named",
    DEFINITION: "gives a new letter its value",
    PREMISE: "taken as given from here on",
    CONDITION: "an equation to be solved: what solves it is checked",
    RANGE: "says where a letter lies",
    UNREADABLE: "not read, for the reason given",
}


def report_document(checked: Checked) -> Document:
    """Return the counts, every verdict in line order, then what the verdicts mean."""
    sides = sides_by_span(checked.derivation)
    text = checked.derivation.text
    lines = tuple(_line(verdict, sides, text) for verdict in _with_notes_once(checked.verdicts))
    remarks = tuple(map(Paragraph, checked.remarks))
    title, lead = page_title(checked.derivation.name), summary(checked)
    if not lines:
        return Document(title, remarks, lead)
    return Document(title, (*remarks, Source(lines), legend(checked.verdicts)), lead)


def _with_notes_once(verdicts: tuple[Verdict, ...]) -> Iterator[Verdict]:
    """Yield verdicts of which what a letter is read as stands where it comes first: "F1 read as F_1".

    What was dropped from a line, or done with it, is said of each.
    """
    above: set[str] = set()
    for verdict in verdicts:
        notes = tuple(note for note in verdict.notes if note not in above)
        above.update(note for note in notes if " read as " in note)
        yield verdict if notes == verdict.notes else replace(verdict, notes=notes)


def verdict_document(verdict: Verdict) -> Document:
    """Return one verdict with its reasons, then what it means."""
    return Document(
        f"Verdict: {verdict_words(verdict)}", (Source((_line(verdict, {}, ""),)), legend((verdict,)))
    )


def page_title(name: str) -> Words:
    """Return what was checked; a derivation that is no file has no name."""
    return "Check of a derivation" if name == "text" else ("Check of ", Code(name))


def report_summary(checked: Checked) -> str:
    """Return what was checked and the counts of its verdicts, in one line."""
    return f"{plain_words(page_title(checked.derivation.name))}: {summary(checked)}"


def summary(checked: Checked) -> str:
    """Return the counts of the verdicts in one line."""
    counts = checked.counts()
    if not checked.relation_count:
        return "No relation was seen: nothing is checked."
    titles = _TITLES | {NOT_MATHEMATICS: "not mathematics"}
    kinds = ", ".join(f"{count} {titles[name].lower()}" for name, count in counts.items())
    count = checked.relation_count
    notes = "".join(f" Note: {note}." for note in checked.derivation.notes)
    return f"{count} {'relation' if count == 1 else 'relations'} seen: {kinds}.{notes}"


def verdict_summary(verdict: Verdict) -> str:
    """Return a verdict in one line: its place, its word, and the correction or the reason."""
    fix = verdict.fix
    words = verdict.reason or verdict.source
    if fix:
        side = "left side should be" if fix.of_left else "should be"
        words = f"{side} {formula_text(fix.node, plain=True)} ({fix.words or fix.kind})"
    return one_line(f"Verdict on line {place(verdict)}: {verdict_words(verdict)}: {words}", 180)


def verdict_words(verdict: Verdict) -> str:
    """Return the verdict as it is read: with its order or its assumption."""
    title = _TITLES[verdict.verdict]
    if verdict.verdict == HOLDS_TO_ORDER and verdict.order in _DIGITS_AND_TERMS:
        return f"holds to the {verdict.order.removeprefix('the ')}"
    supplements = {HOLDS_TO_ORDER: verdict.order, CONDITIONAL: verdict.assumption}
    return f"{title} {supplements[verdict.verdict]}" if verdict.verdict in supplements else title


def place(verdict: Verdict) -> str:
    """Return a relation's line, with its number there unless it is the first.

    In a notebook the cell comes first: 3:2 is the second line of the third cell.
    """
    line = f"{verdict.cell[0]}:{verdict.cell[1]}" if verdict.cell else f"{verdict.line}"
    return line if verdict.link == 1 else f"{line}.{verdict.link}"


def one_line(source: str, limit: int) -> str:
    r"""Return a source of several lines on one, shortened to `limit` characters.

    >>> one_line("\\displaystyle x\n  = 1 + 2", 7)
    'x = 1 …'
    """
    line = " ".join(source.replace("\\displaystyle", " ").split())
    return line if len(line) <= limit else line[: limit - 1] + "…"


def _line(verdict: Verdict, sides: Sides, text: str) -> SourceLine:
    """Return a verdict as a line of a report; of the page's `text` its units are as they were typed."""
    return SourceLine(
        place(verdict),
        one_line(_source(verdict, sides, text), LONGEST_SOURCE),
        verdict_words(verdict),
        verdict.verdict in FAILING,
        tuple(_notes(verdict)),
        _formulas(verdict, text),
        typeset(verdict, sides, text),
    )


def _source(verdict: Verdict, sides: Sides, text: str) -> str:
    """Return the side of a relation that is shown: the right one; of a wrong relation both, if short."""
    if verdict.sign:
        return arrow_source(verdict)
    chain, k = sides.get(verdict.span, (None, 0))
    if verdict.verdict not in FAILING or chain is None or not k:
        return verdict.source
    left = as_shown(text[slice(*chain.sides[k - 1].span)].strip().strip("&$ "), chain.sides[k - 1].node)
    whole = f"{left} {chain.relations[k - 1].sign} {verdict.source}"
    return whole if left and len(whole) <= LONGEST_BOTH else verdict.source


def arrow_source(verdict: Verdict) -> str:
    """Return an arrow with the relations on either side of it, as they are typed."""
    return f"{verdict.left} {verdict.sign} {verdict.source}"


def _notes(verdict: Verdict) -> Iterable[Words]:
    """Yield what is said below a verdict's line."""
    if verdict.bind:
        yield f"claims to be: {verdict.bind}"
    if verdict.fix:
        side = " (left side)" if verdict.fix.of_left else ""
        yield f"found: {verdict.fix.words or verdict.fix.kind}{side}"
        yield from (fault_words(fault, verdict) for fault in verdict.fix.faults)
    if verdict.reason:
        yield verdict.reason
    yield from (f"note: {note}" for note in verdict.notes)
    yield from map(difference_words, verdict.differences)
    if needs_witness(verdict):
        yield witness_words(verdict)


def needs_witness(verdict: Verdict) -> bool:
    """Tell whether a witness says more: not of two numbers, of which the right one is shown."""
    if not verdict.is_bad or not verdict.witness:
        return False
    is_point = any(name not in ("left", "right") for name in verdict.witness)
    return is_point or (verdict.fix is None and not verdict.exact)


def difference_words(difference: Difference) -> Words:
    """Return a difference as `cos 2θ: claimed 1/4, exact 1/2`."""
    term = difference.term_node or difference.term
    claimed = difference.claimed_node or difference.claimed
    return (term, ": claimed ", claimed, ", exact ", difference.exact_node or difference.exact)


def witness_words(verdict: Verdict) -> Words:
    """Return a witness as `witness: θ = 1.2, λ = 3.7: left 0.5, right 0.25`."""
    sides = {name: verdict.witness[name] for name in ("left", "right") if name in verdict.witness}
    short = {name: _in_few_digits(value) for name, value in sides.items()}
    sides = sides if len(sides) > len({*short.values()}) else short
    parts: list[Inline] = []
    for name, value in verdict.witness.items():
        if name not in sides:
            parts += [", " if parts else "", Equation(Name(name), (("=", rounded_number(value)),))]
    parts += [": "] if parts and sides else []
    for k, (name, value) in enumerate(sides.items()):
        parts += [", " if k else "", f"{name} ", rounded_number(value)]
    return ("witness: ", *parts)


def _in_few_digits(value: str) -> str:
    """Return a number with no more digits than a person compares; of a complex one both parts.

    >>> _in_few_digits("7.0370422223"), _in_few_digits("(-1.14794370197e-41 + 3.80664950489j)")
    ('7.03704', '3.80665i')
    """
    try:
        number = complex(value.strip("()").replace(" ", ""))
    except ValueError:
        return value
    real, imaginary = f"{number.real:.{DIGITS}g}", f"{abs(number.imag):.{DIGITS}g}i"
    if abs(number.imag) <= NOISE * abs(number):
        return real
    sign = "-" if number.imag < 0 else ""
    if abs(number.real) <= NOISE * abs(number):
        return f"{sign}{imaginary}"
    return f"{real} {sign or '+'} {imaginary}"


def fault_words(fault: Fault, verdict: Verdict) -> Words:
    """Return a wrong piece as `line 3, column 7: for cos put sin`, with the cell in a notebook."""
    should = fault.node or fault.should
    where = f"line {fault.line}, column {fault.column}: "
    if verdict.cell:
        number, line = verdict.cell
        where = f"cell {number}, line {line + fault.line - verdict.line}, column {fault.column}: "
    if not fault.source:
        return (f"{where}add ", should)
    is_later_term = fault.kind == "sign" and fault.source[:1] in tuple("-−–") and not fault.is_first
    put = " put + " if is_later_term else " put "
    return (f"{where}for ", Code(one_line(fault.source, LONGEST_PIECE)), put, should)


def _formulas(verdict: Verdict, text: str) -> tuple[tuple[str, Formula], ...]:
    """Return a side that is not right as it was read, and as it should be; its exact value, if not."""
    if not verdict.is_bad:
        return ()
    claim = None if verdict.node is None else as_written(verdict.node, text)
    stands, fix = ("stands", claim), verdict.fix
    if fix is None:
        is_number = bool(verdict.exact) and "right" in verdict.witness and not needs_witness(verdict)
        exact = ("exactly", verdict.exact_node)
        sides = (exact,) if is_number else (stands, exact)
    elif fix.of_left:
        sides = (("left side should be", fix.node),)
    elif len(fix.faults) == 1 and fix.faults[0].node == fix.node:
        sides = ()  # the change says it
    else:
        sides = (stands, ("should be", fix.node))
    return tuple((name, node) for name, node in sides if node is not None and is_readable(node))


def legend(verdicts: tuple[Verdict, ...]) -> Facts:
    """Return what the verdicts that occur mean, and how places and corrections are written."""
    kinds = {verdict.verdict for verdict in verdicts}
    entries: list[tuple[Words, Words]] = [
        (_TITLES[word], _MEANINGS[word]) for word in VERDICTS if word in kinds
    ]
    first_cell = next((verdict for verdict in verdicts if verdict.cell), None)
    if first_cell is not None and first_cell.cell:
        number, line = first_cell.cell
        entries.append((f"{number}:{line}", f"cell {number} of the notebook, line {line}"))
    second = next((place(verdict) for verdict in verdicts if verdict.link == 2), None)
    if second:
        entries.append((second, f"the second relation of line {second.rpartition('.')[0]}"))
    if any(verdict.sign for verdict in verdicts):
        meaning = (
            "an arrow, numbered behind the relations of its line: does the relation to its right follow"
        )
        entries.append(("⇒, ⇔", meaning))
    if any(verdict.differences for verdict in verdicts):
        entries.append(("claimed, exact", "a term's coefficient in the line, and the right one"))
    if any(verdict.fix for verdict in verdicts):
        entries.append(("found", "a change after which the line is proved"))
    return Facts(tuple(entries), "How to read it")
