"""Files as people keep them (LaTeX, Markdown, wiki, web page, AsciiDoc, notebook), put into one form.

What is no mathematics (comments, code, addresses, markup) becomes blank; other people's delimiters
(<math>, $`…`$, stem:[…], MathML) become those of LaTeX; macros, units and decimal commas are replaced.
Lines stay lines, and every character knows where it stands in the document.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from html import unescape

from symbalance.document.wordlists import words
from symbalance.notes.reading.letters.component_names import with_components
from symbalance.notes.reading.letters.compound_names import with_compound_names
from symbalance.notes.reading.letters.engine_abbreviations import with_abbreviations
from symbalance.notes.reading.letters.extremes_apart import with_extremes_apart, with_extremes_of_bars
from symbalance.notes.reading.letters.function_names import with_function_names
from symbalance.notes.reading.letters.greek_words import with_greek_words
from symbalance.notes.reading.letters.imaginary_j import with_imaginary_j
from symbalance.notes.reading.letters.inertia_letters import inertias_named
from symbalance.notes.reading.letters.letter_d import means_diameter
from symbalance.notes.reading.letters.letter_e import lengths_named, means_letter, with_number_e
from symbalance.notes.reading.letters.letter_i import counts_by_i
from symbalance.notes.reading.letters.letters_in_braces import with_letters_unbraced
from symbalance.notes.reading.letters.listed_letters import with_bounds_of_each
from symbalance.notes.reading.letters.marked_letters import with_marked_letters
from symbalance.notes.reading.letters.pointed_words import with_points_left_out
from symbalance.notes.reading.letters.primed_rates import with_dots_for_primes
from symbalance.notes.reading.letters.scanned_letters import with_scanned_letters
from symbalance.notes.reading.letters.segments import with_segments
from symbalance.notes.reading.letters.short_greek import with_short_greek
from symbalance.notes.reading.letters.sigma_sums import with_sigma_sums
from symbalance.notes.reading.letters.turned_scripts import with_scripts_in_order
from symbalance.notes.reading.letters.typed_changes import with_typed_changes
from symbalance.notes.reading.markup.ascii_math import with_ascii_math
from symbalance.notes.reading.markup.frames_and_overlaps import with_frames_opened
from symbalance.notes.reading.markup.joined_dollars import with_joined_dollars, with_units_between_dollars
from symbalance.notes.reading.markup.macros import expand_macros
from symbalance.notes.reading.markup.mathml import is_mathml, mathml_text
from symbalance.notes.reading.markup.page_marks import with_page_marks
from symbalance.notes.reading.markup.templates import formula_of_template, stands_in_formula
from symbalance.notes.reading.markup.type_settings import (
    with_one_inline_mark,
    with_tildes_blank,
    with_upright_parts,
)
from symbalance.notes.reading.rewriting import Rewriter, Rewritten, Span
from symbalance.notes.reading.spellings.and_so_on import with_dots
from symbalance.notes.reading.spellings.bracketed_divisors import with_bracketed_divisors
from symbalance.notes.reading.spellings.cases_in_words import with_conditions_apart
from symbalance.notes.reading.spellings.division_colons import with_divisions
from symbalance.notes.reading.spellings.joined_units import with_joined_units
from symbalance.notes.reading.spellings.limits_by_arrows import with_limits_by_arrows
from symbalance.notes.reading.spellings.memberships import with_memberships
from symbalance.notes.reading.spellings.multiples_in_words import with_multiples_in_signs
from symbalance.notes.reading.spellings.numerals import with_plain_numerals
from symbalance.notes.reading.spellings.one_letter_words import with_one_letter_words
from symbalance.notes.reading.spellings.operator_words import with_operator_words
from symbalance.notes.reading.spellings.places_in_brackets import with_places
from symbalance.notes.reading.spellings.pointed_units import with_compound_units
from symbalance.notes.reading.spellings.ranges import with_ranges
from symbalance.notes.reading.spellings.recurring_decimals import with_recurring_decimals
from symbalance.notes.reading.spellings.row_vectors import with_row_vectors
from symbalance.notes.reading.spellings.systems_in_braces import with_rows_of_relations, with_systems
from symbalance.notes.reading.spellings.tables_of_quantities import with_equations_of_tables
from symbalance.notes.reading.spellings.times_in_parts import with_times_in_one
from symbalance.notes.reading.spellings.units_behind_waves import with_units_of_waves
from symbalance.notes.reading.spellings.units_below_strokes import with_units_below_strokes
from symbalance.notes.reading.spellings.units_in_brackets import with_units_without_brackets
from symbalance.notes.reading.spellings.units_in_parts import with_sums_of_units
from symbalance.notes.reading.spellings.upright_inches import with_upright_inches
from symbalance.notes.reading.spellings.words_behind_units import with_words_apart
from symbalance.notes.reading.spellings.wrapped_lines import SOFT_END, with_soft_ends
from symbalance.notes.reading.units import height_named
from symbalance.text import lazy_patterns as re

CELL_END = "\ue000"
"""Stands between the cells of a table: no formula goes over it. (A sign that nobody types.)"""

KINDS = {
    ".tex": "tex", ".latex": "tex", ".md": "markdown", ".markdown": "markdown", ".ipynb": "markdown",
    ".wiki": "wiki", ".mediawiki": "wiki", ".html": "html", ".htm": "html", ".xhtml": "html",
    ".adoc": "asciidoc", ".asciidoc": "asciidoc", ".txt": "plain", ".text": "plain",
}  # fmt: skip
"""What a file's ending says about how it is written; anything else is plain."""


@dataclass(frozen=True, slots=True)
class Source:
    """A text ready to be read.

    `formulas` are the spans of fenced blocks of formulas, `codes` those of program code that may be
    formulas. `refusals` tell, by their place in the document, why a macro was not replaced.
    """

    text: str
    kind: str
    formulas: tuple[Span, ...] = ()
    codes: tuple[Span, ...] = ()
    origin: Rewritten | None = None
    refusals: tuple[tuple[int, tuple[str, str]], ...] = ()
    notes: tuple[str, ...] = ()
    own_letters: frozenset[str] = frozenset()
    """Letters that elsewhere are numbers, as e, and are none on this page."""


@dataclass
class _Rewriting:
    """A text that is rewritten step by step, with the way back to where each piece was typed."""

    text: str
    origin: Rewritten | None = None
    notes: tuple[str, ...] = ()

    def apply(self, done: Rewritten | None) -> None:
        """Take a rewriting of the text; None where nothing changes."""
        if done is not None:
            self.origin = done.after(self.origin)
            self.text = self.origin.text

    def apply_noted(self, done: tuple[Rewritten | None, tuple[str, ...]]) -> None:
        """Take a rewriting and what is to be said of it."""
        self.apply(done[0])
        self.notes += done[1]


def prepare(
    text: str,
    suffix: str,
    is_letter: Callable[[str, int], bool] = lambda name, line: False,
    *,
    imaginary_j: bool = False,
) -> Source:
    """Return a document's text as it is read; the suffix says how it is written.

    `is_letter` tells whether a name is a declared letter on a line, `imaginary_j` whether j is declared
    the imaginary unit.
    """
    reader = _Rewriting(to_half_width(text))
    kind = kind_of(reader.text, suffix)
    if kind == "tex":
        reader.text = mask_code_of_tex(reader.text)
    reader.text = with_tildes_blank(reader.text, is_tex=kind == "tex")
    reader.apply(with_page_marks(reader.text, kind, suffix))
    for rules in _RULES.get(kind, ()):
        reader.apply(_rewritten(reader.text, rules))
    if kind == "asciidoc":
        reader.apply(with_ascii_math(reader.text))
    reader.apply(with_one_inline_mark(reader.text))
    macros = expand_macros(reader.text)
    reader.apply(macros.source)
    reader.apply(with_upright_parts(reader.text))
    reader.apply(with_frames_opened(reader.text))
    reader.apply(with_scripts_in_order(reader.text))
    own_letters = frozenset({"i"} if counts_by_i(reader.text) else ())
    own_letters |= (
        inertias_named(reader.text)
        | lengths_named(reader.text)
        | height_named(reader.text)
        | _diameters(reader.text)
    )
    if means_letter(reader.text):
        own_letters |= {"e"}
        reader.apply(with_number_e(reader.text))
    if kind in ("tex", "markdown"):
        reader.apply(with_equations_of_tables(reader.text, kind))
    has_dollars = kind != "plain" or _TEX_FORMULA.search(text) is not None  # not money
    if has_dollars:
        reader.apply(with_joined_dollars(reader.text))
    reader.apply_noted(with_segments(reader.text))
    reader.apply(with_abbreviations(reader.text))
    if kind != "wiki":  # there two quotation marks begin italics
        reader.apply(with_dots_for_primes(reader.text))
    for rewrite in (
        with_typed_changes,
        with_letters_unbraced,
        with_marked_letters,
        partial(with_imaginary_j, is_declared=imaginary_j),
        with_bounds_of_each,
        with_row_vectors,
        with_conditions_apart,
        with_extremes_of_bars,
        with_operator_words,
        with_multiples_in_signs,
        with_rows_of_relations,
        with_systems,
        with_recurring_decimals,
        with_limits_by_arrows,
        with_memberships,
        with_function_names,
        with_one_letter_words,
        with_dots,
        with_places,
        with_divisions,
        with_times_in_one,
        with_words_apart,
        with_units_without_brackets,
        with_sums_of_units,
        with_bracketed_divisors,
        with_upright_inches,
    ):
        reader.apply(rewrite(reader.text))
    reader.apply(with_sigma_sums(reader.text, is_letter))
    if kind != "tex":
        reader.apply_noted(with_short_greek(reader.text, is_letter))
        reader.apply(with_greek_words(reader.text, is_letter))
        reader.apply(with_extremes_apart(reader.text))
        reader.apply(with_components(reader.text))
        reader.apply_noted(with_compound_names(reader.text, is_letter))
    if kind == "plain":
        reader.apply(with_points_left_out(reader.text))
        reader.apply_noted(with_scanned_letters(reader.text))
    reader.apply(with_compound_units(reader.text))
    reader.apply(with_units_below_strokes(reader.text, is_letter))
    for noted in (with_joined_units, with_plain_numerals):
        reader.apply_noted(noted(reader.text, is_letter))
    reader.apply(with_units_of_waves(reader.text, is_letter))
    if has_dollars:
        reader.apply(with_units_between_dollars(reader.text))
    reader.apply_noted(with_ranges(reader.text))
    current, formulas, codes = _masked(reader.text, kind)
    refusals = tuple(sorted(macros.refusals.items()))
    return Source(
        current, kind, tuple(formulas), tuple(codes), reader.origin, refusals, reader.notes, own_letters
    )


def _diameters(text: str) -> frozenset[str]:
    """Return the letter d where a page means a diameter by it."""
    return frozenset({"d"} if means_diameter(text) else ())


def _masked(text: str, kind: str) -> tuple[str, list[Span], list[Span]]:
    """Return a text with what is no mathematics blank, and its blocks of formulas and of codes."""
    if kind == "tex":
        return mask_tex(text), [], []
    formulas, codes = list[Span](), list[Span]()
    if kind == "markdown":
        text, formulas, codes = mask_markdown(text)
    else:
        text = mask_plain(with_letters_shown(text).translate(_SHOWN_IN_CODE))
    return with_soft_ends(text, (*formulas, *codes), has_bullets=kind != "plain"), formulas, codes


def kind_of(text: str, suffix: str) -> str:
    """Return how a text is written; plain text with a wiki's tags is a wiki's."""
    kind = KINDS.get(suffix, "plain")
    if kind == "plain" and re.search(r"<math[\s>]", text):
        return "html" if re.match(r"\s*<(?:!doctype|html|\?xml)", text, re.IGNORECASE) else "wiki"
    return kind


def _rewritten(text: str, rules: tuple[Rule, ...]) -> Rewritten | None:
    """Return a text with a format's own marks in LaTeX, None where nothing changed."""
    pattern = re.compile("|".join(f"(?:{rule.pattern.pattern})" for rule in rules), _FLAGS)
    rewriter = Rewriter(text)
    place, changed = 0, False
    while match := pattern.search(text, place):
        for rule in rules:
            if inner := rule.pattern.match(text, match.start()):
                break
        else:  # a rule looks behind: leave the place as it is
            place = match.start() + 1
            continue
        texts = rule.write(inner)
        if texts is not None:
            rewriter.replace(inner.start(), inner.end(), *texts)
            changed = True
        place = max(inner.end(), inner.start() + 1)
    return rewriter.finish() if changed else None


# The marks of each format

_FLAGS = re.DOTALL | re.IGNORECASE | re.MULTILINE
Texts = tuple[str | Span, ...]


@dataclass(frozen=True, slots=True)
class Rule:
    """A mark of a format and what stands in its place; None: it stays as it is."""

    pattern: re.Pattern[str]
    write: Callable[[re.Match[str]], Texts | None]


def _rule(pattern: str, write: Callable[[re.Match[str]], Texts | None]) -> Rule:
    return Rule(re.compile(pattern, _FLAGS), write)


def _inside(number: int, left: str, right: str) -> Callable[[re.Match[str]], Texts]:
    """Return what writes a group as it stands, between two texts."""
    return lambda match: (left, match.span(number), right)


def _blank(match: re.Match[str]) -> Texts:
    return (" ",)


def _gap(match: re.Match[str]) -> Texts:
    return (CELL_END,)


def _math_element(match: re.Match[str]) -> Texts:
    """<math> of a wiki holds LaTeX, of a web page MathML."""
    head, inside = match[0].partition(">")[0], match[0].partition(">")[2].rpartition("<")[0]
    is_block = re.search(r"display\s*=\s*[\"']?block", head, re.IGNORECASE) is not None
    left, right = ("\\[", "\\]") if is_block else ("\\(", "\\)")
    if is_mathml(inside):
        return (f"{left} {mathml_text(inside)} {right}",)
    start = match.start() + len(head) + 1
    return (left, (start, start + len(inside)), right)


def _entity(match: re.Match[str]) -> Texts | None:
    sign = unescape(match[0])
    return None if sign == match[0] else (sign.replace("\n", " ").translate(_WIDE),)


_MATH = _rule(r"<math(?:\s[^<>]*)?>(?:(?!<math).){0,20000}?</math\s*>", _math_element)
_COMMENT = _rule(r"<!--.*?(?:-->|\Z)", _blank)


def _raised(left: str, right: str) -> Callable[[re.Match[str]], Texts]:
    """Return what writes a script between two texts, its entities as signs."""

    def write(match: re.Match[str]) -> Texts:
        inside = match[1]
        return (left, unescape(inside) if "&" in inside else match.span(1), right)

    return write


_ALTERNATIVE = re.compile(r"\salt\s*=\s*(?:\"([^\"]*)\"|'([^']*)')", re.IGNORECASE)
_OF_FORMULA = re.compile(
    r"\sclass\s*=\s*[\"'][^\"']*(?<![\w-])(?:tex|latex|math|mathtex|ql-img-\w+-equation|mwe-math-[\w-]+)(?![\w-])"
    r"|\ssrc\s*=\s*[\"'][^\"']*(?:latex|mathtex|codecogs|/math/)",
    re.IGNORECASE,
)


_STYLED = re.compile(r"\{\\(?:display|text)style\s+(.*)\}", re.DOTALL)
"""The TeX of a picture as Wikipedia has it, {\\displaystyle a = b}."""
_MATHML_BEFORE = re.compile(r"</math\s*>\s*(?:</span\s*>\s*){0,3}$", re.IGNORECASE)
"""The end of a formula as MathML, and of what holds it, right before its picture."""


def _picture(match: re.Match[str]) -> Texts:
    """A picture of a formula holds its TeX as what is read aloud; any other picture is a gap.

    So is one right behind the same formula as MathML, which is for a reader who cannot show that.
    """
    alternative = _ALTERNATIVE.search(match[0])
    is_second = _MATHML_BEFORE.search(match.string, max(match.start() - 80, 0), match.start())
    if alternative is None or is_second or not _OF_FORMULA.search(match[0]):
        return (CELL_END,)
    number = 1 if alternative[1] is not None else 2
    inside, start = alternative[number].strip(" $"), match.start()
    if (styled := _STYLED.fullmatch(inside)) is not None:
        inside = styled[1]
    if "&" in inside or inside != alternative[number]:
        return ("\\(", unescape(inside), "\\)")
    return ("\\(", (start + alternative.start(number), start + alternative.end(number)), "\\)")


_STACKED = _rule(
    r"<sup(?:\s[^<>]*)?>([0-9]{1,4})</sup\s*>\s*(?:/|&frasl;"
    r"|⁄)\s*<sub(?:\s[^<>]*)?>([0-9]{1,4})</sub\s*>",
    lambda match: ("(", match.span(1), "/", match.span(2), ")"),
)
_RAISED = _rule(r"<sup(?:\s[^<>]*)?>([^<>]{1,40})</sup\s*>", _raised("^{", "}"))
_LOWERED = _rule(r"<sub(?:\s[^<>]*)?>([^<>]{1,40})</sub\s*>", _raised("_{", "}"))
_INLINE_TAGS = "|".join(
    words("span i b em strong u var big small font a abbr tt cite ins mark q s wbr code samp kbd")
)
_BLOCK_TAGS = "|".join(
    words(
        "p div li ul ol dl dt dd h1 h2 h3 h4 h5 h6 table thead tbody tfoot tr td th caption br hr img"
        " body html head meta link title section article header footer main nav figure figcaption"
        " pre blockquote input button form label aside center sup sub details summary"
        " colgroup col svg path gallery poem references"
    )
)
_INLINE_TAG = _rule(rf"</?(?:{_INLINE_TAGS})(?:\s[^<>]*)?/?>", lambda match: ("",))
_BLOCK_TAG = _rule(rf"</?(?:{_BLOCK_TAGS})(?:\s[^<>]*)?/?>|<!doctype[^<>]*>|<\?xml[^<>]*>", _gap)
_PICTURE = _rule(r"<img\s[^<>]*>", _picture)
_ENTITY = _rule(r"&(?:[a-z]{2,8}[0-9]{0,2}|#[0-9]{1,6}|#x[0-9a-f]{1,5});", _entity)
_GITLAB = _rule(r"\$`([^`\n]{1,2000})`\$", _inside(1, "\\(", "\\)"))
_DOUBLE_BACKSLASH = (
    _rule(r"(?<!\\)\\\\\(([^$\n]{1,2000}?)\\\\\)", _inside(1, "\\(", "\\)")),
    _rule(r"(?<!\\)\\\\\[([^$]{1,4000}?)\\\\\]", _inside(1, "\\[", "\\]")),
)
_DISPLAYED = (
    _rule(r"\$\$.{0,20000}?\$\$", lambda match: None),
    _rule(
        r"\\begin\s*\{(?P<environment>[a-z]+\*?)\}(?:(?!\\begin\s*\{(?P=environment)\}).){0,20000}?"
        r"\\end\s*\{(?P=environment)\}",
        lambda match: None,
    ),
)
"""Mathematics that is LaTeX already: no mark of the format stands in it."""
_FENCED = _rule(
    r"^[ ]{0,3}(?P<fence>`{3,}|~{3,}).*?(?:^[ ]{0,3}(?P=fence)[`~]*[ \t]*$|\Z)", lambda match: None
)


def _script(match: re.Match[str]) -> Texts:
    """A script of MathJax holds a formula, any other a program."""
    head, _, inside = match[0].partition(">")
    if "math/tex" not in head:
        return (" ",)
    start = match.start() + len(head) + 1
    span = (start, start + len(inside.rpartition("<")[0]))
    return ("\\[", span, "\\]") if "display" in head else ("\\(", span, "\\)")


def _template(match: re.Match[str]) -> Texts:
    """{{math|x = 1}} shows its argument, other templates are markup."""
    if _MATH_BEGINS.search(match[1]):  # an equation with its number: {{NumBlk|:|<math>a = b</math>|1}}
        texts: list[str | Span] = [CELL_END]
        for element in _MATH.pattern.finditer(match.string, *match.span(1)):
            texts += [*_math_element(element), CELL_END]
        return tuple(texts)
    name, _, inside = match[1].partition("|")
    if (formula := formula_of_template(match)) is not None:
        return formula
    if name.strip().lower() not in _SHOWN or not inside:
        return (" \\template ",) if stands_in_formula(match) else (" ",)
    start = match.start(1) + len(name) + 1
    numbered = _NUMBERED_ARGUMENT.match(inside)
    return (" ", (start + (numbered.end() if numbered else 0), match.end(1)), " ")


_TEMPLATE = _rule(r"\{\{([^{}]{1,2000})\}\}", _template)
_MATH_BEGINS = re.compile(r"<math[\s>]", re.IGNORECASE)
_NUMBERED_ARGUMENT = re.compile(r"\s*[0-9]\s*=")
"""{{math|1=a = b}}: with its number an argument may hold an equals sign."""
_SHOWN = frozenset(
    [
        *words("math mvar nowrap nobr bigmath nobold center quote blockquote cquote indent big small"),
        *("bold", "em", "strong", "block indent"),
    ]
)
_WIKI_ROW = re.compile(r"\|\||!!")


def _wiki_row(match: re.Match[str]) -> Texts:
    """A row of a wiki's table: its cells, without what says how they look."""
    texts: list[str | Span] = [CELL_END]
    start, end = match.span(2)
    text, place = match.string, start
    for gap in [*_WIKI_ROW.finditer(text, start, end), None]:
        stop = gap.start() if gap else end
        style = re.compile(r"\s*[a-z]+\s*=\s*(?:\"[^\"\n]*\"|[0-9]+)[^|\n]*\|(?!\|)").match(
            text, place, stop
        )
        texts += [(style.end() if style else place, stop), CELL_END]
        place = gap.end() if gap else end
    return tuple(texts)


def _heading(match: re.Match[str]) -> Texts:
    return (" ", match.span("title"), " ")


def _boxed_display(match: re.Match[str]) -> Texts:
    """\\begin{empheq}[box=\\fbox]{align} is an align; so are the equations of IEEEtran."""
    name = match["display"]
    return (f"\\begin{{{name}}}", match.span("body"), f"\\end{{{name}}}")


_TEX_DISPLAYS = (
    _rule(
        r"\\begin\s*\{empheq\}\s*(?:\[[^\[\]]{0,200}\])?\s*\{(?P<display>[a-z]+\*?)(?:=[0-9]+)?\}"
        r"(?P<body>(?:(?!\\begin\s*\{empheq).){0,20000}?)\\end\s*\{empheq\}",
        _boxed_display,
    ),
    _rule(
        r"\\begin\s*\{IEEEeqnarray(\*?)\}\s*(?:\[[^\[\]]*\])?\s*\{[^{}]*(?:\{[^{}]*\}[^{}]*)*\}",
        lambda match: (f"\\begin{{eqnarray{match[1]}}}",),
    ),
    _rule(r"\\end\s*\{IEEEeqnarray(\*?)\}", lambda match: (f"\\end{{eqnarray{match[1]}}}",)),
    _rule(
        r"\\begin\s*\{IEEEeqnarraybox\*?\}\s*(?:\[[^\[\]]*\])?\s*\{[^{}]*\}",
        lambda match: ("\\begin{aligned}",),
    ),
    _rule(r"\\end\s*\{IEEEeqnarraybox\*?\}", lambda match: ("\\end{aligned}",)),
)
_CELL_WITH_RELATION = _rule(
    rf"[ \t]*{CELL_END}[ \t{CELL_END}]*(?=[=≈<>≤≥])|(?<=[=≈≤≥])[ \t]*{CELL_END}[ \t{CELL_END}]*(?=\S)",
    _blank,
)
"""Cells of a table in which an equation stands in columns: r | = | 40 mm."""
_RULES: dict[str, tuple[tuple[Rule, ...], ...]] = {
    "tex": (_TEX_DISPLAYS,),
    "markdown": (_TEX_DISPLAYS, (
        _FENCED, _COMMENT, _GITLAB, *_DOUBLE_BACKSLASH, *_DISPLAYED, _MATH, _STACKED, _RAISED, _LOWERED,
        _INLINE_TAG, _PICTURE, _BLOCK_TAG, _ENTITY,
        _rule(r"(?<=\])\([^()\s]{0,400}[.#/][^()\s]{0,400}[?&][^()\s]{0,400}=[^()\s]{0,400}\)", _blank),
    ),),
    "wiki": ((
        _COMMENT,
        _rule(r"<nowiki>(?:(?!<nowiki).){0,20000}?</nowiki>|<(?:source|syntaxhighlight"
            r"|pre)[\s>](?:(?!<(?:source|syntax|pre)).)*?</(?:source|syntaxhighlight|pre)>",
              _blank),
        Rule(_MATH.pattern, lambda match: None), *_DISPLAYED,
        _rule(r"\{\{\s*=\s*\}\}", lambda match: ("=",)),
        _rule(r"^(?P<heading>={2,6})(?P<title>[^=\n](?:[^\n]*?[^=\n])?)(?P=heading)[ \t]*$", _heading),
        _TEMPLATE,
        _rule(r"^[ \t]*(?:(?:\{\||\|\}|\|-)[^\n]*$|\|\+)", _blank),
        _rule(r"^[ \t]*([|!])(?![|}+-])([^\n]*)$", _wiki_row),
    ), (Rule(_MATH.pattern, lambda match: None), *_DISPLAYED, _TEMPLATE), (
        _MATH, *_DISPLAYED, _STACKED, _RAISED, _LOWERED,
        _rule(r"<ref(?:\s[^<>]*)?/>|<ref(?:\s[^<>]*)?>|</ref>", _gap),
        _INLINE_TAG, _PICTURE, _BLOCK_TAG, _ENTITY,
        _rule(r"\[\[(?:[^][|\n]*\|)*([^][|\n]*)\]\]", _inside(1, " ", " ")),
        _rule(r"\[https?://[^\s\]]+", _blank),
        _rule(r"^[:;]+|'{2,5}", _blank),
    )),
    "html": ((
        _COMMENT,
        _rule(r"<script(?:\s[^<>]*)?>(?:(?!<script).)*?</script\s*>", _script),
        _rule(r"<(?P<hidden>style|noscript|head)(?:\s[^<>]*)?>(?:(?!<(?P=hidden)[\s>]).)*?"
              r"</(?P=hidden)\s*>", _blank),
        _MATH, _STACKED, _RAISED, _LOWERED, _INLINE_TAG, _PICTURE, _BLOCK_TAG, _ENTITY,
    ), (_CELL_WITH_RELATION,)),
    "asciidoc": ((
        _rule(r"^////$.*?^////$|^//(?!/)[^\n]*", _blank),
        _rule(r"^\[(?:stem|latexmath|asciimath)[^\]\n]*\]\n\+{4}\n(.{0,20000}?)\n\+{4}$",
              lambda match: ("\\[", match.span(1), "\\]")),
        _rule(r"^(?P<listing>-{4,}|\.{4,}|\+{4,})$.*?^(?P=listing)$", _blank),
        _rule(r"\b(?:stem|latexmath|asciimath):[a-z,]*\[((?:[^][\n]|\\\]|\[[^][\n]*\]){1,4000})\]",
              _inside(1, "\\(", "\\)")),
        _rule(r"^\[[^\]\n]*\]$|^:[^:\n]+:[^\n]*$|^\.(?=[A-Z])", _blank),
        _rule(r"^=+[ ]|^\|={3,}$", _blank),
        _rule(r"(?:^|(?<=\s))[0-9.+]{0,5}[a-z]?\|(?![|=])", _gap),
    ),),
}  # fmt: skip
"""The marks of each format in passes, one after the other; within a pass in the order they are tried."""


# What is not to be read as mathematics: blanked

_WIDE = {0xFF01 + k: 0x21 + k for k in range(94)} | {0x3000: 0x20, 0x0D: 0x20, 0xA0: 0x20}
_WIDE |= dict.fromkeys(
    (
        *range(9),
        0x0B,
        0x0C,
        *range(0x0E, 0x20),
        0x7F,
        0xFEFF,
        *range(0x200B, 0x200E),
        *range(0x2060, 0x2065),
    ),
    0x20,
)
_DOT_OF_PRODUCT = re.compile(r"(?<=[A-Za-zα-ω0-9²³)])[・･](?=[A-Za-zα-ω0-9(√])")
_DEGREE_TYPED = re.compile("(?<=[0-9])[º˚](?![A-Za-z])")
_TEX_COMMENT = re.compile(r"(?<!\\)(?:\\\\)*(%[^\n]*)")
_VERBATIM = re.compile(r"\\begin\s*\{(verbatim\*?|lstlisting|minted|comment|Verbatim)\}")
_VERB = re.compile(r"\\verb\*?([^A-Za-z\s*])[^\n]{0,400}?\1")
_ADDRESS = re.compile(
    r"[A-Za-z][A-Za-z0-9+.-]{1,20}://[^\s<>\"「」、。]+|[\w.+-]{1,64}@[\w-]{1,64}(?:\.[\w-]{1,64})+"
)
_RULE_OF_SIGNS = re.compile(r"^[ \t]*(?:={2,}|~{3,})[ \t]*$", re.MULTILINE)
_QUOTED = re.compile(r"^[ ]{0,3}(?:>[ ]?)+", re.MULTILINE)
_TITLE = re.compile(
    r"\\(?:title|subtitle)\s*(?:\[[^\[\]]{0,200}\])?\s*\{((?:[^{}]|\{(?:[^{}]"
    r"|\{[^{}]{0,80}\}){0,80}\}){1,400})\}"
)
_OPTIONS = re.compile(r"(?<=[A-Za-z}*])\[\s*[a-z-]{2,20}\s*=[^\[\]\n$]{0,200}\]")
_FENCE = re.compile(r"[ ]{0,3}(`{3,}|~{3,})\s*([A-Za-z]*)")
_BOLD = re.compile(r"(?<![\w)*])\*\*(?=[^\s*])([^*\n]{1,300})(?<=\S)\*\*(?![\w(*])")
_ITALIC = re.compile(
    r"(?<![\w*)\]}°²³])\*(?=[^\s*])([^*\n=]{1,60})(?<=[^\s*])\*(?![\w*(])"
    r"|(?<![\w}\])])_([^\W_](?:[^_\n=]{0,40}[^\W_])?)_(?!\w)"
)
_CODE = re.compile(r"(`+)(?!`)[^`\n]{1,400}\1(?!`)")
_CODE_LANGUAGES_OF_FORMULAS = ("math", "latex", "tex")
_CODE_LANGUAGES_UNKNOWN = ("", "text", "txt", "plain")


def blank(text: str) -> str:
    """Return as many spaces, with the line ends where they were."""
    return "".join("\n" if c == "\n" else " " for c in text) if "\n" in text else " " * len(text)


_TEX_FORMULA = re.compile(
    r"\$[^$\n]{0,200}(?<!\\)\\[A-Za-z,;][^$\n]{0,200}\$|\\\("
    r"|\$(?! )[^$\n]{1,80}(?<![ =])\$[^$\n]{0,8}[=≈] ?\$(?! )"
)
"""In plain text: dollars that set formulas, $3$ kg = $3000$ g, and are no money."""
_NARROW_SPACE = re.compile(
    "[\u00a0\u2002-\u200a\u202f\u205f](?![0-9])|(?<![0-9])[\u00a0\u2002-\u200a\u202f\u205f]"
)


def to_half_width(text: str) -> str:
    """Return the text with full-width signs and typographic spaces as plain ones, of the same length.

    m・r is a product. Between figures a thin space may group thousands, and stays.
    """
    narrow = _DEGREE_TYPED.sub("°", text.translate(_WIDE)).replace(SOFT_END, " ")
    narrow = _NARROW_SPACE.sub(" ", narrow)
    return _DOT_OF_PRODUCT.sub("·", narrow) if "・" in narrow else narrow


def mask_code_of_tex(text: str) -> str:
    """Blank comments and verbatim."""
    text = _TEX_COMMENT.sub(lambda m: m.group()[: m.start(1) - m.start()] + blank(m.group(1)), text)
    text = _without_environments(text)
    return _VERB.sub(lambda m: blank(m.group()), text)


def _shown_of_preamble(text: str) -> str:
    """Return a preamble in which only its title stands, which the page shows."""
    shown = list(blank(text))
    for match in _TITLE.finditer(text):
        shown[match.start(1) : match.end(1)] = match[1]
    return "".join(shown)


def mask_tex(text: str) -> str:
    """Blank comments, verbatim, the preamble and what follows the end."""
    text = _OPTIONS.sub(lambda m: blank(m.group()), mask_code_of_tex(text))
    begin = text.find("\\begin{document}")
    if begin >= 0:
        begin += len("\\begin{document}")
        text = _shown_of_preamble(text[:begin]) + text[begin:]
    end = text.find("\\end{document}")
    return text if end < 0 else text[:end] + blank(text[end:])


def _without_environments(text: str) -> str:
    pieces: list[str] = []
    place = 0
    while match := _VERBATIM.search(text, place):
        closer = f"\\end{{{match.group(1)}}}"
        end = text.find(closer, match.end())
        end = len(text) if end < 0 else end + len(closer)
        pieces += [text[place : match.start()], blank(text[match.start() : end])]
        place = end
    return "".join([*pieces, text[place:]])


def mask_plain(text: str) -> str:
    """Blank addresses of the net and of mail, and rules of equals signs under a heading."""
    text = _RULE_OF_SIGNS.sub(lambda m: blank(m.group()), text)
    return _ADDRESS.sub(lambda m: blank(m.group()), text)


def mask_markdown(text: str) -> tuple[str, list[Span], list[Span]]:
    """Blank code and comments; return the text, the blocks of formulas, and code that may be formulas."""
    text = _without_comments(text)
    formulas: list[Span] = []
    codes: list[Span] = []
    lines: list[str] = []
    fence, language, begin = "", "", 0
    for offset, line in _lines(text):
        match = _FENCE.match(line)
        if fence:
            is_closing = match is not None and match.group(1).startswith(fence)
            is_shown = language in (*_CODE_LANGUAGES_OF_FORMULAS, *_CODE_LANGUAGES_UNKNOWN)
            if is_closing and language in _CODE_LANGUAGES_OF_FORMULAS and "$" not in text[begin:offset]:
                formulas.append((begin, offset))
            elif not is_closing and language in _CODE_LANGUAGES_UNKNOWN:
                codes.append((offset, offset + len(line)))
            lines.append(line if is_shown and not is_closing else blank(line))
            fence = "" if is_closing else fence
        elif match:
            fence, language, begin = match.group(1), match.group(2).lower(), offset + len(line)
            lines.append(blank(line))
        else:
            shown = with_letters_shown(line)
            for code in _CODE.finditer(shown):
                ticks = len(code.group(1))
                codes.append((offset + code.start() + ticks, offset + code.end() - ticks))
            without_ticks = _CODE.sub(_without_ticks, shown)
            plain = _BOLD.sub(lambda m: f"  {m.group(1)}  ", without_ticks)
            slanted = _ITALIC.sub(lambda m: f" {m.group(1) or m.group(2)} ", plain)
            lines.append(slanted.translate(_SHOWN_IN_CODE))
    unquoted = _QUOTED.sub(lambda m: blank(m.group()), "".join(lines))
    return mask_plain(unquoted), formulas, codes


_HIDDEN_IN_CODE = {ord("*"): "\ue001", ord("_"): "\ue002"}
_SHOWN_IN_CODE = {ord(hidden): chr(sign) for sign, hidden in _HIDDEN_IN_CODE.items()}
"""Signs of emphasis that are none in code: `a*b*c` is a product."""


_LETTER_IN_CODE = re.compile(
    r"(?<!`)`(?P<letter>(?:\\?[A-Za-z]+|[^\W\d_])(?:_\{[^{}`\n]{1,12}\}|_\w{1,12}|[0-9₀-₉]{1,2})?['′]?)`(?!`)"
    r"(?P<sign>[ \t]*[=≈][ \t]*)(?:(?<!`)`(?P<side>[^`\n]{1,200})`(?!`))?"
)
"""A letter in code left of a sign that is not: `λ` = r/l."""


def with_letters_shown(text: str) -> str:
    """Return a text with the letters in code that a formula outside is about as that formula's."""
    return _LETTER_IN_CODE.sub(_shown_letter, text) if "`" in text else text


def _shown_letter(match: re.Match[str]) -> str:
    """Return it as a formula of prose, with what code stands right of it."""
    side = "" if match["side"] is None else f" {match['side'].translate(_HIDDEN_IN_CODE)} "
    return f" {match['letter'].translate(_HIDDEN_IN_CODE)} {match['sign']}{side}"


def _without_ticks(match: re.Match[str]) -> str:
    """Return code without its ticks, which no formula goes over."""
    ticks = CELL_END * len(match.group(1))
    return f"{ticks}{match.group()[len(ticks) : -len(ticks)].translate(_HIDDEN_IN_CODE)}{ticks}"


def _lines(text: str) -> Iterator[tuple[int, str]]:
    place = 0
    while place < len(text):
        end = text.find("\n", place)
        end = len(text) if end < 0 else end + 1
        yield place, text[place:end]
        place = end


def _without_comments(text: str) -> str:
    pieces: list[str] = []
    place = 0
    while (start := text.find("<!--", place)) >= 0:
        end = text.find("-->", start)
        end = len(text) if end < 0 else end + 3
        pieces += [text[place:start], blank(text[start:end])]
        place = end
    return "".join([*pieces, text[place:]])
