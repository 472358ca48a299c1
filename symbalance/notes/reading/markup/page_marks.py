r"""What formats mark around formulas without saying mathematics: slides, Word's pages, Org, reST, e-mail.

Overlays (`\item<2->`, `\alert<2>{…}`), a page's head of keys, elements of Word, quoting signs, rules of
tables and program code become blank; roles and verbatim marks become the delimiters of LaTeX.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from symbalance.document.letters import GREEK_SIGN
from symbalance.notes.reading.rewriting import Rewriter, Rewritten, Span
from symbalance.text import lazy_patterns as re

Texts = tuple[str | Span, ...]
_FLAGS = re.MULTILINE | re.DOTALL


@dataclass(frozen=True, slots=True)
class Mark:
    """A mark of a format, and what stands in its place; None: it stays as it is."""

    pattern: re.Pattern[str]
    write: Callable[[re.Match[str]], Texts | None]


def _mark(pattern: str, write: Callable[[re.Match[str]], Texts | None]) -> Mark:
    return Mark(re.compile(pattern, _FLAGS), write)


def _blank(match: re.Match[str]) -> Texts:
    return (" ",)


def _first_group(match: re.Match[str]) -> Texts:
    return (match.span(1),)


def _in_dollars(match: re.Match[str]) -> Texts:
    return ("\\(", match.span(1), "\\)")


def _apart(match: re.Match[str]) -> Texts:
    """Verbatim text: no formula goes over its edges."""
    return ("\ue000", match.span(1), "\ue000")


def _displayed(match: re.Match[str]) -> Texts:
    return ("\\[", match.span(1), "\\]")


def _office_formula(match: re.Match[str]) -> Texts:
    """A formula of Word is not read: it stands as a command of its name, with its relations."""
    signs = re.findall("[=≈<>≤≥]", re.sub("<[^<>]*>", "", match[0]))
    return ("\\(\\oMath ", *(f"{sign} \\oMath " for sign in signs), "\\)")


_OVERLAY = r"<[\w@:|.,+\- ()]{0,40}>"
_END_OF_ROW = r"(?=\s*(?:\\\\|\\end\s*\{|\\tag|\\label|\\nonumber|\\notag|\\\]|\$\$))"
_SLIDES = (
    _mark(
        rf"\\(?:alert|structure|only|uncover|visible|invisible|onslide)\s*(?:{_OVERLAY})?(?=\s*\{{)",
        _blank,
    ),
    _mark(rf"(\\(?:item|pause|onslide|column|note|frame|begin\s*\{{[A-Za-z]+\*?\}})\s*){_OVERLAY}",
          _first_group),
)  # fmt: skip
_IN_FRACTION = r"\{((?:[^{}$]|\^\{[^{}]{1,4}\}){1,30})\}"
_UPRIGHT_FRACTION = _mark(  # the unit \mathrm{\frac{m}{s^2}} is \frac{\mathrm{m}}{\mathrm{s^2}}
    rf"\\(mathrm|mathsf|text|textrm|mbox|rm)\s?\{{\s?\$?\\([dt]?frac)\s?{_IN_FRACTION}\s?{_IN_FRACTION}\s?\$?\}}",
    lambda m: ("\\", m.span(2), "{\\mathrm{", m.span(3), "}}{\\mathrm{", m.span(4), "}}"),
)
_EQUALS_IN_WORDS = _mark(
    r"\\(?:text|textrm|mbox|mathrm|hbox)\s?\{\s*(?:is\s+equal\s+to|is\s+exactly|equals|ist\s+gleich|gleich|est\s+égal\s+à)"
    r"\s*\}",
    lambda m: (" = ",),
)
_MICRO = _mark(  # 27.8\,\mu\text{s}
    r"(?<=[0-9])((?:\\[,;: ]|[ ~]){0,3})\\mu\s?\\(?:text|textrm|mathrm|mbox|rm)\s?"
    r"\{\s?([A-Za-z]{1,3})\s?\}",
    lambda m: (m.span(1), "\\mathrm{u", m.span(2), "}"),
)
_KERN = _mark(r"\\m?(?:kern|skip)\s?[-+]?[0-9.]{1,8}\s?(?:mu|pt|em|ex|mm)(?![A-Za-z])", _blank)
_WORDS_OF_ROWS = (
    _mark(r"\\(?=(?:short)?intertext\s*\{)", lambda m: (" \\\\ \\",)),
    _mark(  # (\text{for all }\theta) behind an equation
        r"((?:\\q?quad|\\[,;: ]|~)\s*)[(（]\s*(\\(?:mbox|text|textrm|textit|hbox)\s*\{[^{}$]*\})"
        r"[^()=<>≈$\n\\]{0,20}(?:\\(?!leq?|geq?|approx|neq?|in)[a-z]{2,10}[^()=<>≈$\n\\]{0,10}){0,3}[)）]",
        lambda m: (m.span(1), m.span(2)),
    ),
)
_EVERYWHERE = (*_WORDS_OF_ROWS, _UPRIGHT_FRACTION, _EQUALS_IN_WORDS, _MICRO, _KERN)
_TEX = (
    *_SLIDES,
    _mark(  # units with a raised digit in dollars, \mbox{m/s$^2$}
        r"(\\(?:mbox|text|textrm|hbox|mathrm)\s*\{[^{}$]{0,40})\$\s*(\^\{?[-−]?[0-9]\}?)\s*\$([^{}$]{0,20}\})",
        lambda m: (m.span(1), m.span(2), m.span(3)),
    ),
    _mark(  # words in brackets behind an equation
        r"(?:(?<=\s)|(?<=quad)|(?<=[;,~]))[(（]\s*(\\(?:mbox|text|textrm|textit|hbox)\s*\{[^{}$]*\})\s*[)）]"
        + _END_OF_ROW,
        lambda m: ("\\quad", m.span(1)),
    ),
    _mark(r"\\mathop\s*\{\s*\}\s*(?:\\!)?\s*(?=\\mathrm|\{?\\mathrm)", _blank),
    _mark(  # f\colon\mathbb R\to\mathbb R says from where to where, and claims nothing
        r"(?:\\[A-Za-z]+|[A-Za-z])\s*\\colon(?![A-Za-z])[^,;$=\n]{1,80}\\(?:long)?(?:to|rightarrow)(?![A-Za-z])[^,;$=\n]{1,60}?"
        r"(?:(?=\$|\\quad|\\\)|\\\])|[,;])",
        _blank,
    ),
    _mark(r"\\colon(?![A-Za-z])(?=\s*=)", lambda m: (":",)),
)  # fmt: skip


def _outside_dollars(*texts: str | int) -> Callable[[re.Match[str]], Texts | None]:
    """Return what writes texts and groups for a mark in prose; between dollars it stays as it is."""

    def write(match: re.Match[str]) -> Texts | None:
        before = match.string[match.string.rfind("\n", 0, match.start()) + 1 : match.start()]
        if before.replace("\\$", "").count("$") % 2:
            return None
        return tuple(match.span(part) if isinstance(part, int) else part for part in texts)

    return write


_LETTER = r"(?:[A-Za-zα-ωΑ-Ωϕϑϵ]|&[A-Za-z]{2,7};)"
_SCRIPT_BEHIND = r"(?:<su[bp]>|~[A-Za-z0-9,]{1,8}~|\^[-−+]?[A-Za-z0-9]{1,4}\^)"
_SCRIPTS_OF_PROSE = (
    _mark(
        rf"(?<![\w*_])(?P<sign>\*{{1,2}}|_)({_LETTER})(?P=sign)(?={_SCRIPT_BEHIND})", _outside_dollars(2)
    ),
    _mark(
        r"(?<=[A-Za-zα-ωΑ-Ωϕϑϵ)0-9;])~([A-Za-z0-9]{1,8}(?:,[A-Za-z0-9]{1,6})?)~(?![A-Za-z0-9~])",
        _outside_dollars("_{", 1, "}"),
    ),
    _mark(
        r"(?<=[A-Za-zα-ωΑ-Ωϕϑϵ)0-9;}])\^([-−+]?[A-Za-z0-9]{1,4})\^(?![A-Za-z0-9({^])",
        _outside_dollars("^{", 1, "}"),
    ),
    _mark(
        r"(<su[bp]>)[*_]([A-Za-z0-9]{1,8})[*_](</su[bp]>)", lambda m: (m.span(1), m.span(2), m.span(3))
    ),
)
"""Slanted letters with scripts, *F*<sub>2</sub>, and scripts by tildes and carets, F~2~ and x^2^."""
FRONT_MATTER = r"\A---[ \t]*\n(?:[^\n]*\n){0,40}?---[ \t]*$"
"""The head of a page in YAML: its title, its author, how it is to be shown."""
_MARKDOWN = (
    *_SCRIPTS_OF_PROSE,
    _mark(FRONT_MATTER, _blank),
    _mark(r"(?:^|(?<=\s))==(?=[^\s=])([^\n]{1,300}?)(?<=[^\s=])==(?=[\s.,;:)]|$)", _first_group),
    _mark(r"(?<!\\)%%[^\n%]{1,400}%%", _blank),
    _mark(r"(?<=[$.)\]!?:])[ \t]+\^[A-Za-z][\w-]{1,40}[ \t]*$", _blank),
)
_REMARKS = (
    _mark(r"(?<=\s)[:;]-[)(DP](?=\s|$)", _blank),
    _mark(r"(?<=[\w)])[ \t]+<-+[ \t]*(?=[A-Za-z!?])[^\n=<>0-9]*$", _blank),
    _mark(  # and above another line that is quoted, or alone, a line without words: > 3 x, >
        r"^[ ]{0,4}(?:>[ ]?)+(?!=)(?=[^\n]*(?:[^\W\d_]{2}|[=≈])|[^\n]*\n>(?!=)|[ \t]*$)", _blank
    ),
    _mark(r"^--[ ]?$", _blank),
    _mark(r"\[/?quote\b[^\]\n]{0,60}\]", lambda m: (" ; ",)),
    _mark(r"^={2,}[ \t]+([^\n=]*?)[ \t]+={2,}[ \t]*$", _first_group),
)
"""What people put beside a line, and the signs by which e-mail quotes."""
_FORUM = (
    _mark(
        r"\[(?:tex|latex|math|itex|katex)\]([^\[\]]{0,400}(?:\[[^\[\]]{0,40}\][^\[\]]{0,400}){0,8})"
        r"\[/(?:tex|latex|math|itex|katex)\]",
        _in_dollars,
    ),
    _mark(r"\[sub\]([^\[\]\n]{1,40})\[/sub\]", lambda m: ("_{", m.span(1), "}")),
    _mark(r"\[sup\]([^\[\]\n]{1,40})\[/sup\]", lambda m: ("^{", m.span(1), "}")),
    _mark(
        r"\[/?(?:code|pre|list|table|td|tr|th|center|left|right|indent|spoiler|\*)(?:=[^\]\n]{0,40})?\]",
        lambda m: ("\ue000",),
    ),
    _mark(
        r"\[(b|i|u|s|size|color|colour|font|highlight)(?:=[^\]\n]{0,40})?\]([^\[\]\n]{1,300})\[/\1\]",
        lambda m: (m.span(2),),
    ),
)
"""The marks of a forum's posts, [b]F = 3[/b] and x[sub]1[/sub]."""
_WORD = (
    _mark(r"<!\[[^\]<>]{1,80}\]>", _blank),
    _mark(r"</?(?:o|v|w|u[0-9]|st[0-9]):[A-Za-z]+[^<>]*>", lambda m: ("",)),
    _mark(r"<m:oMathPara\b.*?</m:oMathPara\s*>|<m:oMath\b.*?</m:oMath\s*>", _office_formula),
    _mark(r"<code\s[^<>]*class\s*=\s*[\"']?[^<>\"']*lang(?:uage)?-[^<>]*>(?:(?!</code).)*</code\s*>",
          _blank),
)  # fmt: skip
_ORG = (
    _mark(r"^[ \t]*#\+begin_(src|example)\b.*?^[ \t]*#\+end_\1[ \t]*$", _blank),
    _mark(
        r"^[ \t]*#\+(?:CAPTION|TITLE|SUBTITLE)(?:\[[^\]\n]*\])?:([^\n]*)$", lambda m: (m.span(1), " ;")
    ),
    _mark(r"^[ \t]*#\+caption:([^\n]*)$", lambda m: (m.span(1), " ;")),
    _mark(r"^[ \t]*#\+[A-Za-z_]+:[^\n]*$", _blank),
    _mark(r"^[ \t]*:PROPERTIES:.*?:END:[ \t]*$", _blank),
    _mark(r"^[ \t]*[-+][ \t]+(?:(?!::)[^\n$\\=]){1,60}::(?=\s)", _blank),
    _mark(r"(?<![\w=])=(?=[^\s=])([^\n]{1,200}?)(?<=[^\s=])=(?![\w=])", _apart),
    _mark(r"(?<![\w~])~(?=[^\s~])([^\n~]{1,200}?)(?<=[^\s~])~(?![\w~])", _apart),
    _mark(r"(?<!\S)/(?=[^\s/])([^/\n=]{1,60})(?<=\S)/(?=[\s.,;:)]|$)", _first_group),
    _mark(r"^[ \t]*\|[-+]+\|[ \t]*$", _blank),
    _mark(r"\|", lambda m: ("\ue000",)),
)
_REST = (
    _mark(r"(?:\\[ ])?:sub:`([^`\n]{1,40})`(?:\\[ ])?", lambda m: ("_{", m.span(1), "}")),
    _mark(r"(?:\\[ ])?:sup:`([^`\n]{1,40})`(?:\\[ ])?", lambda m: ("^{", m.span(1), "}")),
    _mark(rf"\|({'|'.join(sorted(GREEK_SIGN, key=len, reverse=True))})\|", _first_group),
    _mark(r"^([ \t]*)\.\. (?:code-block|code|sourcecode|literalinclude|highlight)::[^\n]*\n"
          r"(?:[ \t]*\n|\1[ \t]+[^\n]*(?:\n|\Z))*", _blank),
    _mark(r":math:`([^`]{1,2000})`", _in_dollars),
    _mark(r"^[ \t]*\.\. math::[ \t]*(\S[^\n]*)$", _displayed),
    _mark(r"^[ \t]*(?:=+[ \t]+)+=+[ \t]*$|^[ \t]*\.\. math::[ \t]*$|^[ \t]+:[a-z]+:[^\n=]*$", _blank),
    _mark(r"``([^`\n]{1,300})``", _apart),
)  # fmt: skip
_BY_KIND = {
    "tex": (_TEX,),
    "markdown": (_TEX[len(_SLIDES) :], _MARKDOWN),
    "asciidoc": (_SCRIPTS_OF_PROSE,),
    "html": (_WORD,),
    "plain": (_REMARKS, _FORUM),
}
_BY_ENDING = {".org": (_ORG,), ".rst": (_REST,), ".rest": (_REST,)}


def with_page_marks(text: str, kind: str, ending: str = "") -> Rewritten | None:
    r"""Return a text without the marks of its format, None where there are none.

    >>> with_page_marks(r"\item<2-> \alert<3>{$a = b$}", "tex").text
    '\\item  {$a = b$}'
    >>> with_page_marks(r"Here :math:`a = b`.", "plain", ".rst").text
    'Here \\(a = b\\).'
    """
    result = _without_second_copies(text) if kind == "html" else None
    for marks in (_EVERYWHERE, *_BY_KIND.get(kind, ()), *_BY_ENDING.get(ending, ())):
        for mark in marks:
            done = _without(result.text if result else text, mark)
            result = done.after(result) if done else result
    return result


def _without(text: str, mark: Mark) -> Rewritten | None:
    rewriter, changed = Rewriter(text), False
    for match in mark.pattern.finditer(text):
        texts = mark.write(match)
        if texts is not None and match.start() >= rewriter.place:
            rewriter.replace(*match.span(), *texts)
            changed = True
    return rewriter.finish() if changed else None


_SECOND_COPY = re.compile(r"<span\s[^<>]*class\s*=\s*[\"']?katex-html[^<>]*>")
_SPAN = re.compile(r"<(/?)span(?:\s[^<>]*)?>")


def _without_second_copies(text: str) -> Rewritten | None:
    """Blank what KaTeX shows of a formula that stands as MathML beside it."""
    rewriter, changed = Rewriter(text), False
    for match in _SECOND_COPY.finditer(text):
        depth, end = 1, len(text)
        for tag in _SPAN.finditer(text, match.end()):
            depth += -1 if tag[1] else 1
            if depth == 0:
                end = tag.end()
                break
        if match.start() >= rewriter.place:
            rewriter.replace(match.start(), end, " ")
            changed = True
    return rewriter.finish() if changed else None
