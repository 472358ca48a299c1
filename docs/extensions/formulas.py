r"""Formulas of the site as MathML: read by `symbalance.notes.reading`, written by `symbalance.document`.

A formula is cut at the commas, spaces and signs ± that separate formulas from each other, each piece is
read as a hand derivation's line is, and its tree is written. What the reader refuses is shown as it was
typed; the build counts it.

>>> mathml(r"\lambda = l/r")
'<math><mrow><mi>λ</mi><mo>=</mo><mfrac><mi>l</mi><mi>r</mi></mfrac></mrow></math>'
>>> mathml("|phi| <= pi/2")
'<math><mrow><mrow><mo>|</mo><mi>φ</mi><mo>|</mo></mrow><mo>≤</mo><mfrac><mi>π</mi><mn>2</mn></mfrac></mrow></math>'
>>> mathml(r"\begin{cases} a \end{cases}") is None
True
"""

from __future__ import annotations

import re
from collections import Counter
from html import escape
from typing import Any

from symbalance.document.formula import Equation
from symbalance.document.letters import FUNCTION_WORDS, GREEK_SIGN
from symbalance.document.mathml_writer import formula_mathml
from symbalance.notes.reading import ReadingError, UndeclaredError, read_equation

_MOST_LETTERS = 80
"""A formula with more letters than this is none."""
_SIZES = re.compile(r"\\(?:[Bb]igg?[lr]?|left|right|displaystyle|textstyle)(?![A-Za-z])")
"""What only sets the size of a bracket or of the type."""
_CUT = re.compile(
    r"\\q?quad(?![A-Za-z])|\\pm(?![A-Za-z])|\\mp(?![A-Za-z])|[,;:±]|\\%|\\text\{[^{}]*\}|\\ (?=\S)"
)
_RELATIONS = {r"\le": "≤", r"\ge": "≥", r"\approx": "≈", r"\equiv": "≡", r"\to": "→"}
_RELATION = re.compile(r"\\(?:le|ge|approx|equiv|to)(?![A-Za-z])|[=<>≤≥≈≡→]")
_SPACE = '<mspace width="1em"></mspace>'
_THIN = '<mspace width="0.3em"></mspace>'
_SEPARATORS = {
    r"\quad": _SPACE,
    r"\qquad": _SPACE + _SPACE,
    r"\pm": "<mo>±</mo>",
    r"\mp": "<mo>∓</mo>",
    r"\%": "<mtext>%</mtext>",
    "\\ ": _THIN,
}
_WORD = re.compile(r"(?<![A-Za-z_\\\\])[A-Za-z]{2,}")
_LOWER_WORD = re.compile(r"_\\text\{([^{}]*)\}")
_OPEN, _CLOSE = "{([", "})]"


def mathml(text: str, display: bool = False, words: bool = True) -> str | None:
    """Return a formula in LaTeX or plain text as a `<math>` element, or None if it cannot be read.

    `words`: a word may be a product of its letters, `mr`, as in LaTeX; in plain text it may not, nor may
    a formula be one that is read in two ways.

    >>> mathml("rate of change", words=False) is None
    True
    """
    try:
        inside = "".join(_pieces(text.strip(), words))
    except (ReadingError, RecursionError):
        return None
    kind = ' display="block"' if display else ""
    return f"<math{kind}>{inside}</math>" if inside else None


def _pieces(text: str, words: bool) -> list[str]:
    """Return the elements of formulas and of what stands between them."""
    end = "." if text.endswith((" .", ".")) and not text.endswith("..") else ""
    text = _SIZES.sub("", text.removesuffix(end)).rstrip()
    text = text.replace("^\\top", "^T")
    text = _LOWER_WORD.sub(r"_{\\mathrm{\1}}", text)
    if "\\begin" in text:
        raise ReadingError(0, "an array is not read")
    pieces: list[str] = []
    start = 0
    for cut in [*_cuts(text, _CUT), None]:
        part = text[start : cut.start() if cut else len(text)].strip().removesuffix("\\,").strip()
        if part:
            pieces += _sides(part, words)
        if cut:
            pieces.append(_separator(cut.group()))
            start = cut.end()
    return [*pieces, "<mtext>.</mtext>"] if end and pieces else pieces


def _cuts(text: str, separator: re.Pattern[str]) -> list[re.Match[str]]:
    """Return the separators that stand outside all brackets."""
    depth, place, cuts = 0, 0, []
    while place < len(text):
        cut = separator.match(text, place) if depth == 0 and text[place - 1 : place] != "\\" else None
        if cut:
            cuts.append(cut)
            place = cut.end()
            continue
        depth += (text[place] in _OPEN) - (text[place] in _CLOSE)
        place += 1
    return cuts


def _sides(text: str, words: bool) -> list[str]:
    """Return a chain of relations; one that is not read whole side by side, lists in brackets too."""
    try:
        return [_element(text, words)]
    except ReadingError:
        if text.startswith("(") and text.endswith(")") and not _cuts(text, re.compile(r"\)")):
            return ["<mo>(</mo>", *_pieces(text[1:-1], words), "<mo>)</mo>"]
        cuts = _cuts(text, _RELATION)
        if not cuts:
            raise
    sides: list[str] = []
    start = 0
    for cut in [*cuts, None]:
        side = text[start : cut.start() if cut else len(text)].strip()
        sides += _sides(side, words) if side else []
        if cut:
            sides.append(f"<mo>{escape(_RELATIONS.get(cut.group(), cut.group()))}</mo>")
            start = cut.end()
    return sides


def _separator(text: str) -> str:
    if text.startswith("\\text{"):
        words = text.removeprefix("\\text{").removesuffix("}")
        return f"<mtext>{escape(words).replace(' ', chr(0xA0))}</mtext>"
    return _SEPARATORS.get(text) or f"<mo>{escape(text)}</mo>{_THIN}"


def _element(text: str, words: bool) -> str:
    """Return one formula or chain of relations as a MathML element."""
    if not words and not all(map(_is_plain_word, _WORD.findall(text))):
        raise ReadingError(0, "this is prose")
    letters = {word for word in _WORD.findall(text) if word in GREEK_SIGN}
    while True:
        try:
            chain = read_equation(text, letters)
            break
        except UndeclaredError as problem:
            if problem.letter in letters or len(letters) > _MOST_LETTERS:
                raise
            letters.add(problem.letter)
    if not words and any(len(side.readings) > 1 for side in chain.sides):
        raise ReadingError(0, "this may be read in two ways")
    left, *rights = (side.node for side in chain.sides)
    signs = (relation.sign for relation in chain.relations)
    equation = Equation(left, tuple(zip(signs, rights, strict=True)))
    return formula_mathml(equation if rights else left).removeprefix("<math>").removesuffix("</math>")


def _is_plain_word(word: str) -> bool:
    """Tell whether a word of several letters is usual in formulas in plain text: rho, cos, dx."""
    return word in GREEK_SIGN or word in FUNCTION_WORDS or (len(word) == 2 and word[0] == "d")


# --- the extension ---

_COUNT: Counter[str] = Counter()


def _html(node: Any, display: bool) -> str:
    source = node.astext()
    element = mathml(source, display)
    _COUNT["read" if element else "unread"] += 1
    tag = "div" if display else "span"
    if element is None:
        return f'<{tag} class="formula unread"><code>{escape(source)}</code></{tag}>'
    element = element.replace("<math", f'<math alttext="{escape(source, quote=True)}"', 1)
    return f'<{tag} class="formula">{element}</{tag}>'


def _visit_inline(translator: Any, node: Any) -> None:
    from docutils.nodes import SkipNode

    translator.body.append(_html(node, display=False))
    raise SkipNode


def _visit_block(translator: Any, node: Any) -> None:
    from docutils.nodes import SkipNode

    translator.body.append(_html(node, display=True) + "\n")
    raise SkipNode


def _report(_app: Any, failure: Exception | None) -> None:
    from sphinx.util import logging

    if failure is None:
        read, unread = _COUNT["read"], _COUNT["unread"]
        logging.getLogger(__name__).info(f"formulas: {read} as MathML, {unread} as they were typed")


def setup(app: Any) -> dict[str, bool]:
    """Make this the site's way of showing formulas."""
    app.add_html_math_renderer("symbalance", (_visit_inline, None), (_visit_block, None))
    app.connect("build-finished", _report)
    return {"parallel_read_safe": True, "parallel_write_safe": False}
