r"""What stands between the relations of a page, whatever its format: paragraphs, tables, code.

LaTeX, wiki markup, HTML and AsciiDoc are first written as the Markdown that says the same; then one
reader of Markdown parts it into blocks. Relations stand in it as marks, `INLINE` within a sentence and
`DISPLAY` on lines of their own, for whoever sets the page to fill in. What is not known is left out
where it sets type (`\noindent`) and stays where it says something.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from html import unescape

from symbalance.notes.reading.markup.macros import expand_macros
from symbalance.notes.reading.markup.mathml import is_mathml, mathml_text
from symbalance.notes.reading.sources import kind_of
from symbalance.text import lazy_patterns as re

INLINE, DISPLAY, END = "\ue010", "\ue011", "\ue012"
"""Around the number of a relation; signs that nobody types, and that are taken out of the page itself."""
_FORMULA, _BAR, _DOLLAR = "\ue013", "\ue014", "\ue015"
"""Around the number of a formula that claims nothing; a bar within a cell; a typed dollar sign."""
OWN_SIGNS = re.compile("[\ue010-\ue015]")
MOST_COLUMNS = 30


@dataclass(frozen=True)
class Stretch:
    """A block of a page: a heading, paragraph, list item, code, table, or the mark of a relation.

    `text` is that of the block, of code its lines, of a relation its number; a table has `rows`, the
    first of them its head if `has_head`.
    """

    kind: str
    text: str = ""
    rows: tuple[tuple[str, ...], ...] = ()
    has_head: bool = False


class Prose:
    """The blocks of a page, and its formulas that claim nothing."""

    def __init__(self, text: str, suffix: str) -> None:
        self.formulas: list[str] = []
        kind = kind_of(text, suffix)
        write = _WRITERS.get(kind)
        self.is_plain = kind == "plain"
        self._text = write(self, text) if write else self.stash_all(text)

    def stretches(self) -> Iterator[Stretch]:
        """Yield the blocks from top to bottom."""
        if self.is_plain:
            for line in _DISPLAYS.sub(r"\n\1\n", self._text).split("\n"):
                yield from _line(line.strip())
        else:
            yield from _markdown(self._text)

    def inline(self, text: str) -> Iterator[tuple[str, str]]:
        """Yield (kind, content) of a block: text, code, strong, formula, or a relation's number."""
        at = 0
        for match in (_PLAIN_INLINE if self.is_plain else _INLINE).finditer(text):
            if before := text[at : match.start()]:
                yield "text", _unescaped(before)
            at = match.end()
            kind = match.lastgroup or ""
            content = match[kind]
            if kind == "formula":
                yield "formula", self.formulas[int(content)]
            elif (
                kind in ("em", "link")
                or (kind == "code" and INLINE in content)
                or (kind == "strong" and any(sign in content for sign in (INLINE, _FORMULA)))
            ):
                yield from self.inline(content)
            else:
                yield kind, content if kind == "relation" else _unescaped(content)
        if rest := text[at:]:
            yield "text", _unescaped(rest)

    def stash(self, source: str) -> str:
        """Return a mark for a formula, which no rewriting of the text around it touches.

        Of one that holds relations only the signs around it go: they stand in for themselves.
        """
        if INLINE in source or DISPLAY in source:
            return _rest_of_formula(source)
        if not source.strip():
            return ""
        self.formulas.append(" ".join(source.split()))
        return f"{_FORMULA}{len(self.formulas) - 1}{END}"

    def stash_all(self, text: str) -> str:
        """Return a text with a mark for every formula between signs, and without what sets displays."""

        def replaced(match: re.Match[str]) -> str:
            if is_mathml(match[0]):
                return self.stash(mathml_text(match[0]))
            return self.stash(next(group for group in match.groups() if group is not None))

        text = _DISPLAYED.sub(_between_displayed, text.replace("\\$", _DOLLAR))
        text = _SETTING.sub("\n", text)
        return _MATHS.sub(replaced, text).replace(_DOLLAR, "$" if self.is_plain else "\\$")


_MATHS = re.compile(
    r"\$`([^`\n]{0,400})`\$|\$((?:[^$\n]|\n(?!\s*\n)){0,400})\$|\\\(((?:(?!\\\)|\n\s*\n).){0,400})\\\)"
    r"|<math\b[^<>]*>((?:(?!</math|\n\s*\n).){0,4000})</math\s*>",
    re.DOTALL,
)
_DISPLAYED = re.compile(
    r"\$\$((?:(?!\$\$|\n\s*\n).){0,4000})\$\$|\\\[((?:(?!\\\[|\\\]|\n\s*\n).){0,4000})\\\]", re.DOTALL
)
_DISPLAYS = re.compile(rf"({DISPLAY}[0-9]+{END})(?:\s{{0,3}}[.;:](?=\s))?")
"""What stands on lines of its own, with the point behind it, which is no line's beginning."""
_RAISED = str.maketrans("0123456789-+", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺")


def _rest_of_formula(source: str) -> str:
    """Return what stands between the relations of one formula, units above all, as words."""
    source = re.sub(r"\\(?:mathrm|text[a-z]*|mbox|operatorname|rm|bf)\s*\{([^{}]*)\}", r" \1", source)
    source = re.sub(r"\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}", r"\1/\2", source)
    source = re.sub(r"\s*\^\s*(?:\{\s*\\circ\s*\}|\\circ(?![A-Za-z]))", "°", source)
    source = re.sub(r"\^\{?([-+]?[0-9]+)\}?", lambda match: match[1].translate(_RAISED), source)
    for pattern, sign in _SIGNS_BETWEEN:
        source = pattern.sub(sign, source)
    return re.sub(r"\\(?:[,;:! ]|quad|qquad|left|right|big|cdot)(?![A-Za-z])", " ", source)


_SIGNS_BETWEEN = (
    (re.compile(r"\\(?:Rightarrow|implies|Longrightarrow)(?![A-Za-z])"), " ⇒ "),
    (re.compile(r"\\(?:Leftrightarrow|iff|Longleftrightarrow)(?![A-Za-z])"), " ⇔ "),
    (re.compile(r"\\therefore(?![A-Za-z])"), " ∴ "),
    (re.compile(r"\\because(?![A-Za-z])"), " ∵ "),
)


def _between_displayed(match: re.Match[str]) -> str:
    """Return a display whose relations are marks, with what stands between them as words."""
    inside = match[1] if match[2] is None else match[2]
    if DISPLAY not in inside:
        return match[0]
    parts = re.split(f"({DISPLAY}[0-9]+{END})", inside)
    words = (part if part[:1] == DISPLAY else _rest_of_formula(part) for part in parts)
    return "\n" + "".join("" if _ONLY_POINTS.fullmatch(part) else part for part in words) + "\n"


_ONLY_POINTS = re.compile(r"[\s,;.&\\]*")
"""Between the relations of a display, which stand on lines of their own."""
_SETTING = re.compile(
    r"\$\$|\\\[|\\\]|\\(?:begin|end)\s*\{(?:align|aligned|alignat|equation|gather|gathered|multline|split|eqnarray"
    r"|math|displaymath|IEEEeqnarray|empheq|dmath|flalign)\*?\}(?:\{[^{}]*\})?|\\(?:label|tag)\*?\s*\{[^{}]*\}"
    r"|\\displaystyle(?![A-Za-z])"
)
"""What sets a display around its relations, and is nothing to read."""
_INLINE = re.compile(
    rf"{INLINE}(?P<relation>[0-9]+){END}|{_FORMULA}(?P<formula>[0-9]+){END}"
    r"|`+(?P<code>[^`\n]+)`+"
    r"|\*\*(?P<strong>[^*\n]+)\*\*"
    r"|!?\[(?P<link>[^\[\]\n]+)\]\([^()\s]*\)"
    r"|(?<![\w*])[*_](?P<em>[^*_\n]+)[*_](?![\w*])"
)
_PLAIN_INLINE = re.compile(rf"{INLINE}(?P<relation>[0-9]+){END}|{_FORMULA}(?P<formula>[0-9]+){END}")


def _unescaped(text: str) -> str:
    return re.sub(r"\\([\\$*_`{}\[\]#|&%~-])", r"\1", text).replace(_BAR, "|")


def _line(line: str) -> Iterator[Stretch]:
    if match := re.fullmatch(f"{DISPLAY}([0-9]+){END}", line):
        yield Stretch("relation", match[1])
    elif line and not re.fullmatch(r"[=\-_*~]{3,}", line):
        yield Stretch("paragraph", line)


# Markdown


_FENCE = re.compile(r"\s{0,3}(`{3,}|~{3,})(.*)")
_ATX = re.compile(r"\s{0,3}(#{1,6})\s+(.*?)(?:\s+#+)?\s*$")
_ITEM = re.compile(r"\s*(?:[-*+•]|([0-9]{1,3}[.)]))\s+(?=\S)")
_RULER = re.compile(r"\s*\|?\s*:?-{1,}:?\s*(?:\|\s*:?-{1,}:?\s*)*\|?\s*$")


def _markdown(text: str) -> Iterator[Stretch]:
    """Yield the blocks of a Markdown text whose relations are marks."""
    text = re.sub(r"<!--.*?-->", lambda match: "\n" * match[0].count("\n"), text, flags=re.DOTALL)
    text = _DISPLAYS.sub(r"\n\1\n", text)
    lines = text.split("\n")
    paragraph: list[str] = []
    kind = "paragraph"
    k = 0
    while k < len(lines):
        line = lines[k]
        bare = line.strip()
        fence, atx, item = _FENCE.match(line), _ATX.match(line), _ITEM.match(line)
        is_table = bare.startswith("|") or (
            "|" in bare and k + 1 < len(lines) and "|" in lines[k + 1] and _RULER.match(lines[k + 1])
        )
        is_mark = re.fullmatch(f"{DISPLAY}([0-9]+){END}", bare)
        underline = re.fullmatch(r"\s{0,3}(?:=+|-{2,})\s*", line)
        if not bare or fence or atx or item or is_table or is_mark or underline:
            joined = " ".join(paragraph)
            if underline and len(paragraph) == 1:
                kind = "heading"
            if joined:
                yield Stretch(kind, joined)
            paragraph, kind = [], "paragraph"
        k += 1
        if fence and bare:
            end = next((n for n in range(k, len(lines)) if lines[n].strip().startswith(fence[1])), None)
            inside = lines[k : len(lines) if end is None else end]
            k = len(lines) if end is None else end + 1
            yield from _fenced(inside)
        elif atx:
            yield Stretch("heading", atx[2])
        elif is_mark:
            yield Stretch("relation", is_mark[1])
        elif is_table:
            k -= 1
            rows = []
            while k < len(lines) and "|" in lines[k]:
                rows.append(lines[k])
                k += 1
            yield from _table(rows)
        elif item:
            kind = "item"
            paragraph.append((f"{item[1]} " if item[1] else "• ") + line[item.end() :].strip())
        elif bare and not underline and not re.fullmatch(r"(?:[*_]\s*){3,}", bare):
            paragraph.append(re.sub(r"^(?:>\s?)+", "", bare))
    if paragraph:
        yield Stretch(kind, " ".join(paragraph))


def _fenced(lines: list[str]) -> Iterator[Stretch]:
    """Yield a fenced block: program code, unless relations stand in it."""
    code: list[str] = []
    for line in lines:
        marks = re.findall(f"[{INLINE}{DISPLAY}]([0-9]+){END}", line)
        if marks:
            if code:
                yield Stretch("code", "\n".join(code))
            code = []
            yield from (Stretch("relation", mark) for mark in marks)
        elif line.strip() or code:
            code.append(line)
    if any(line.strip() for line in code):
        yield Stretch("code", "\n".join(code).rstrip())


def _table(lines: list[str]) -> Iterator[Stretch]:
    rows = [_cells(line) for line in lines if not _RULER.match(line)]
    has_head = len(lines) > 1 and bool(_RULER.match(lines[1]))
    if rows:
        width = min(max(map(len, rows)), MOST_COLUMNS)
        padded = tuple((*row, *[""] * width)[:width] for row in rows)
        yield Stretch("table", "", tuple(padded), has_head)


def _cells(line: str) -> tuple[str, ...]:
    inner = line.strip().removeprefix("|")
    inner = inner[:-1] if inner.endswith("|") and not inner.endswith("\\|") else inner
    return tuple(cell.strip() for cell in re.split(r"(?<!\\)\|", inner))


def _as_table(rows: list[list[str]], has_head: bool) -> str:
    """Return rows as a Markdown table; without a head of their own the first row stands in for it."""
    if not rows:
        return "\n"
    lines = [
        "| " + " | ".join(" ".join(c.replace("|", _BAR).split()) for c in row) + " |" for row in rows
    ]
    if has_head:
        lines.insert(1, "|" + "---|" * len(rows[0]))
    return "\n\n" + "\n".join(lines) + "\n\n"


# LaTeX


_GROUP = r"\{((?:[^{}]|\{[^{}]*\}){0,2000})\}"
_ACCENTS = {'"': "\u0308", "'": "\u0301", "`": "\u0300", "^": "\u0302", "~": "\u0303", "=": "\u0304"}
_LETTERS = {"ss": "ß", "o": "ø", "O": "Ø", "ae": "æ", "AE": "Æ", "aa": "å", "AA": "Å", "l": "ł"}
_SIGNS = {
    "LaTeX": "LaTeX", "TeX": "TeX", "ldots": "…", "dots": "…", "textdegree": "°", "degree": "°",
    "textmu": "µ", "textbackslash": "\\", "S": "§", "quad": " ", "qquad": " ", "copyright": "©",
    "newline": "\n", "linebreak": "\n", "par": "\n\n", "today": "",
}  # fmt: skip
_TEX_RULES: tuple[tuple[re.Pattern[str], str | Callable[[re.Match[str]], str]], ...] = tuple(
    (re.compile(pattern, re.DOTALL), to)
    for pattern, to in (
        (r"\\(?:re)?newcommand\*?\s*\{?\\[A-Za-z]+\}?(?:\[[^\]]*\]){0,2}\s*" + _GROUP, ""),
        (
            r"\\(?:part|chapter|(?:sub){0,2}section|(?:sub)?paragraph)\*?\s*(?:\[[^\]]*\])?" + _GROUP,
            r"\n\n# \1\n\n",
        ),
        (r"\\title\s*" + _GROUP, r"\n\n# \1\n\n"),
        (r"\\(?:author|date|caption)\s*(?:\[[^\]]*\])?" + _GROUP, r"\n\n\1\n\n"),
        (r"\\(?:textbf|boldsymbol)\s*" + _GROUP, r"**\1**"),
        (r"\\(?:emph|textit|textsl|underline)\s*" + _GROUP, r"*\1*"),
        (r"\\(?:texttt|url|verb)\s*" + _GROUP, r"`\1`"),
        (r"\\href\s*\{[^{}]*\}\s*" + _GROUP, r"\1"),
        (r"\\(?:footnote|marginpar)\s*" + _GROUP, r" (\1)"),
        (r"\\(?:intertext|shortintertext|text[a-z]*|mbox|mathrm|hbox)\s*" + _GROUP, r" \1 "),
        (r"\\(?:eq)?ref\s*" + _GROUP, r"(\1)"),
        (r"\\cite[a-z]*\s*(?:\[[^\]]*\])?" + _GROUP, r"[\1]"),
        (
            r"\\(?:label|tag\*?|vspace\*?|hspace\*?|includegraphics|bibliography(?:style)?|pagestyle|usepackage"
            r"|documentclass|setlength|thispagestyle|input|phantom|vphantom|color)\s*(?:\[[^\]]*\])?\s*"
            + _GROUP,
            " ",
        ),
        (r"\\item\s*(?:\[([^\]]*)\])?", lambda match: f"\n- {match[1] or ''} "),
        (
            r"\\begin\s*\{(?:figure|table|center|array|minipage)\*?\}(?:\[[^\]]*\])?(?:\{[^{}]*\})?",
            "\n\n",
        ),
        (r"\\(?:begin|end)\s*\{[A-Za-z]+\*?\}(?:\[[^\]]*\])?", "\n\n"),
    )
)


def _from_tex(page: Prose, text: str) -> str:
    """Return a LaTeX page as Markdown."""
    text = _without_comments(text)
    expanded = expand_macros(text).source
    text = text if expanded is None else expanded.text
    title = "".join(match[0] for match in re.finditer(r"\\(?:title|author)\s*" + _GROUP, _head(text)))
    begin = text.find("\\begin{document}")
    text = title + "\n\n" + text[begin + len("\\begin{document}") :] if begin >= 0 else text
    text = text.partition("\\end{document}")[0]
    text = re.sub(
        r"\\begin\s*\{(verbatim|lstlisting|minted)\*?\}(?:\[[^\]]*\])?(?:\{[^{}]*\})?(.*?)\\end\s*\{\1\*?\}",
        r"\n```\n\2\n```\n",
        text,
        flags=re.DOTALL,
    )
    text = page.stash_all(text)
    text = re.sub(
        r"\\begin\s*\{(?:tabular|longtable|tabularx)\*?\}(?:\s*(?:\[[^\]]*\]|" + _GROUP + r"))*"
        r"(.*?)\\end\s*\{(?:tabular|longtable|tabularx)\*?\}",
        _tex_table,
        text,
        flags=re.DOTALL,
    )
    for _ in range(2):  # a group within a group
        for pattern, to in _TEX_RULES:
            text = pattern.sub(to, text)
    text = re.sub(r"\\([\"'`^~=])\s*(?:\{([A-Za-z])\}|([A-Za-z]))", _accent, text)
    text = re.sub(
        r"\{?\\(ss|ae|AE|aa|AA|o|O|l)(?![A-Za-z])(?:\{\}|\}|[ \t]+)?", lambda m: _LETTERS[m[1]], text
    )
    text = re.sub(r"\s*\^\s*(?:\{\s*\\circ\s*\}|\\circ(?![A-Za-z]))", "°", text)
    text = re.sub(r"\\\\(?:\[[^\]]*\])?", "\n", text)
    text = re.sub(r"\\([A-Za-z]+)\*?(?:\{\})?[ \t]*", lambda match: _SIGNS.get(match[1], " "), text)
    text = re.sub(r"\\[,;:! ]", " ", text)
    text = re.sub(r"(?<!\\)[{}&]", "", text).replace("~", "\u00a0")
    text = text.replace("---", "—") if "|---" not in text else text
    text = re.sub(r"(?<![-|])--(?![-|])", "–", text)
    return text.replace("``", "“").replace("''", "”").replace('"`', "„").replace("\"'", "“")


def _head(text: str) -> str:
    begin = text.find("\\begin{document}")
    return text[: max(begin, 0)]


def _without_comments(text: str) -> str:
    return re.sub(r"(?<!\\)%[^\n]*", "", text)


def _accent(match: re.Match[str]) -> str:
    return unicodedata.normalize("NFC", (match[2] or match[3]) + _ACCENTS[match[1]])


def _tex_table(match: re.Match[str]) -> str:
    rules = (
        r"\\(?:hline|toprule|midrule|bottomrule|cline\s*\{[^{}]*\}|cmidrule\s*(?:\([^)]*\))?\{[^{}]*\})"
    )
    inside = match[2]
    rows = []
    bare = re.sub(
        r"\\multicolumn\s*\{[^{}]*\}\s*\{[^{}]*\}\s*" + _GROUP, r"\1", re.sub(rules, " ", inside)
    )
    for row in re.split(r"\\\\(?:\[[^\]]*\])?|\\tabularnewline", bare):
        if row.strip():
            rows.append(re.split(r"(?<!\\)&", row))
    first, _, rest = inside.strip().removeprefix("\\toprule").removeprefix("\\hline").partition("\\\\")
    return _as_table(rows, bool(first) and bool(re.match(r"\s*" + rules, rest)))


# Wiki, HTML, AsciiDoc


_ANY = re.DOTALL | re.IGNORECASE


def _from_wiki(page: Prose, text: str) -> str:
    """Return a wiki page as Markdown."""
    text = re.sub(r"<!--.*?-->", "", text, flags=re.DOTALL)
    text = re.sub(
        r"<(math|chem)[^<>]*>(.*?)</\1>", lambda match: page.stash(match[2]), text, flags=re.DOTALL
    )
    text = re.sub(r"(?m)^[:;]+[ \t]*", "\n", text)
    text = re.sub(r"(?m)^[*#]+[ \t]*", "- ", text)
    text = re.sub(r"(?m)^\{\|[^\n]*\n(.*?)^\|\}", _wiki_table, text, flags=re.DOTALL)
    text = re.sub(r"(?m)^(={1,6})[ \t]*([^\n=]+?)[ \t]*\1[ \t]*$", r"\n# \2\n", text)
    text = re.sub(r"'''([^'\n]+)'''", r"**\1**", text)
    text = re.sub(r"''([^'\n]+)''", r"*\1*", text)
    text = re.sub(r"\[\[(?:File|Image|Datei|ファイル):[^\[\]]*\]\]", "", text)
    text = re.sub(r"\[\[(?:[^\[\]|]*\|)?([^\[\]|]*)\]\]", r"\1", text)
    text = re.sub(r"\[https?://\S+ ([^\]\n]+)\]", r"\1", text)
    text = re.sub(r"<ref[^<>]*/>|<ref[^<>]*>.*?</ref>", "", text, flags=re.DOTALL)
    text = re.sub(r"\{\{[^{}]*\}\}", "", text)
    return _plain_tags(page, text)


def _wiki_table(match: re.Match[str]) -> str:
    rows: list[list[str]] = [[]]
    has_head = False
    for line in match[1].split("\n"):
        if line.startswith("|-"):
            rows.append([])
        elif line.startswith(("|", "!")) and not line.startswith("|+"):
            has_head = has_head or (line.startswith("!") and not any(rows[:-1]))
            for cell in re.split(r"\|\||!!", line[1:]):
                rows[-1].append(re.sub(r"^[^|\[\]{}]*=[^|\[\]{}]*\|(?!\|)", "", cell).strip())
        elif rows[-1]:
            rows[-1][-1] += " " + line
    return _as_table([row for row in rows if row], has_head)


def _from_html(page: Prose, text: str) -> str:
    """Return a web page as Markdown."""
    text = re.sub(r"<(head|script|style|annotation)\b.*?</\1\s*>", "", text, flags=_ANY)
    text = re.sub(r"<!--.*?-->|<![^<>]*>", "", text, flags=re.DOTALL)
    return _plain_tags(page, text)


_TAGS: tuple[tuple[str, str], ...] = (
    (r"<h[1-6]\b[^<>]*>(.*?)</h[1-6]\s*>", r"\n\n# \1\n\n"),
    (r"<(?:b|strong)\b[^<>]*>([^<>]*)</(?:b|strong)\s*>", r"**\1**"),
    (r"<(?:i|em)\b[^<>]*>([^<>]*)</(?:i|em)\s*>", r"*\1*"),
    (r"<(?:code|tt|kbd)\b[^<>]*>([^<>]*)</(?:code|tt|kbd)\s*>", r"`\1`"),
    (r"<sub\b[^<>]*>([^<>]*)</sub\s*>", r"\\_\1"),
    (r"<sup\b[^<>]*>([^<>]*)</sup\s*>", r"^\1"),
    (r"<li\b[^<>]*>", "\n- "),
    (
        r"<br\s*/?>|</?(?:p|div|ul|ol|dl|dt|dd|section|article|main|figure|figcaption|body|html)\b[^<>]*>",
        "\n\n",
    ),
)


def _plain_tags(page: Prose, text: str) -> str:
    """Return a text whose tags are written as Markdown, or are gone."""

    def formula(match: re.Match[str]) -> str:
        source = match[0]
        if INLINE in source or DISPLAY in source:
            return "".join(re.findall(f"[{INLINE}{DISPLAY}][0-9]+{END}", source))
        return page.stash(mathml_text(source)) if is_mathml(source) else ""

    text = re.sub(r"<math\b[^<>]*>.*?</math\s*>", formula, text, flags=_ANY)
    text = re.sub(r"<pre\b[^<>]*>(.*?)</pre\s*>", r"\n```\n\1\n```\n", text, flags=_ANY)
    text = re.sub(r"<table\b[^<>]*>(.*?)</table\s*>", _html_table, text, flags=_ANY)
    for pattern, to in _TAGS:
        text = re.sub(pattern, to, text, flags=_ANY)
    text = re.sub(r"</?[A-Za-z][^<>]*>", "", text)
    return page.stash_all(unescape(text))


def _html_table(match: re.Match[str]) -> str:
    rows = []
    for row in re.split(r"<tr\b[^<>]*>", match[1], flags=re.IGNORECASE)[1:]:
        cells = re.findall(r"<t[dh]\b[^<>]*>(.*?)(?=<t[dh]\b|</tr|$)", row, flags=_ANY)
        rows.append([re.sub(r"</?(?:t[dhr]|tbody|thead|p)\b[^<>]*>", " ", cell) for cell in cells])
    return _as_table([row for row in rows if row], "<th" in match[1].lower())


def _from_asciidoc(page: Prose, text: str) -> str:
    """Return an AsciiDoc page as Markdown."""
    text = re.sub(r"(?m)^//(?!/)[^\n]*", "", text)
    text = re.sub(
        r"(?:stem|latexmath|asciimath):\[((?:[^\]\\]|\\.){0,400})\]",
        lambda match: page.stash(match[1].replace("\\]", "]")),
        text,
    )
    text = re.sub(r"(?m)^\+{4,}[ \t]*$|^\[(?:stem|latexmath|asciimath)[^\]\n]*\][ \t]*$", "", text)
    text = re.sub(r"(?ms)^\|={3,}[ \t]*\n(.*?)^\|={3,}[ \t]*$", _asciidoc_table, text)
    text = re.sub(r"(?m)^(?:-{4,}|\.{4,})[ \t]*$", "```", text)
    text = re.sub(r"(?m)^={1,6}[ \t]+([^\n]+)$", r"\n# \1\n", text)
    text = re.sub(r"(?m)^:[A-Za-z][\w-]*:[^\n]*$|^\[[^\]\n]*\][ \t]*$", "", text)
    text = re.sub(r"(?m)^\.([A-Za-z][^\n]*)$", r"**\1**\n", text)
    text = re.sub(r"(?m)^[*.]{1,5}[ \t]+", "- ", text)
    return re.sub(r"(?<![\w*])\*([^*\n]+)\*(?![\w*])", r"**\1**", text)


def _asciidoc_table(match: re.Match[str]) -> str:
    rows = []
    for line in match[1].split("\n"):
        if line.startswith("|"):
            rows.append([cell.strip() for cell in line[1:].split("|")])
        elif line.strip() and rows:
            rows[-1][-1] += " " + line.strip()
    has_head = bool(re.match(r"\|[^\n]*\n\s*\n", match[1]))
    return _as_table(rows, has_head)


_WRITERS: dict[str, Callable[[Prose, str], str]] = {
    "tex": _from_tex,
    "wiki": _from_wiki,
    "html": _from_html,
    "asciidoc": _from_asciidoc,
}
