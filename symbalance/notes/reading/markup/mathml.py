"""MathML of web pages, put into plain LaTeX.

A page often brings its own LaTeX in an annotation; that is taken where there is one. An element that is
not read stands as a command of its name, so that it is refused by name.
"""

from __future__ import annotations

from collections.abc import Callable
from html import unescape

from symbalance.document.wordlists import word_set
from symbalance.text import lazy_patterns as re

MOST_ELEMENTS = 5000
DEEPEST = 60
_TAG = re.compile(r"<(/?)\s*(?:[A-Za-z]{1,8}:)?([A-Za-z]+)((?:\s[^<>]*)?)>", re.DOTALL)
_ANNOTATION = re.compile(
    r"<annotation\b[^<>]*encoding\s*=\s*[\"'](?:application/x-tex|TeX|LaTeX)[\"'][^<>]*>(.*?)</annotation>",
    re.DOTALL | re.IGNORECASE,
)
_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
_SIGNS = {
    "−": "-", "⁢": " ", "⁡": " ", "⁣": ",", "·": "\\cdot ", "×": "\\times ", "{": "\\{", "}": "\\}",
    "…": "\\dots ",    "⋯": "\\dots ", "≈": "\\approx ", "%": "\\%", "′": "'",
}  # fmt: skip
_ACCENTS = {"¯": "overline", "‾": "overline", "̇": "dot", "˙": "dot", "¨": "ddot", "^": "hat", "→": "vec"}
Node = tuple[str, str, list["Node"], str]
"""An element: its name, its attributes, its children, its text."""


def mathml_text(source: str) -> str:
    r"""Return the inside of a <math> element as LaTeX.

    >>> mathml_text("<mi>x</mi><mo>=</mo><mfrac><mn>1</mn><mi>&lambda;</mi></mfrac>")
    'x=\\frac{1}{λ}'
    """
    if match := _ANNOTATION.search(source):
        return unescape(match[1]).strip()
    return _written(_tree(_COMMENT.sub("", source)), 0)


def is_mathml(source: str) -> bool:
    """Tell whether the inside of <math> is MathML and not the LaTeX of a wiki."""
    return re.search(r"<\s*(?:[A-Za-z]{1,8}:)?(?:m[a-z]+|semantics)[\s>]", source) is not None


def _tree(source: str) -> Node:
    """Return the elements of a source below one of no name; a stray end is passed over."""
    root: Node = ("mrow", "", [], "")
    open_nodes: list[Node] = [root]
    place = 0
    for count, match in enumerate(_TAG.finditer(source)):
        if count > MOST_ELEMENTS or len(open_nodes) > DEEPEST:
            return ("symbalancelarge", "", [], "")
        _add_text(open_nodes[-1], source[place : match.start()])
        place = match.end()
        closes, name, attributes = match[1], match[2].lower(), match[3]
        if closes:
            if len(open_nodes) > 1 and any(node[0] == name for node in open_nodes[1:]):
                while open_nodes.pop()[0] != name:
                    pass
            continue
        node: Node = (name, attributes, [], "")
        open_nodes[-1][2].append(node)
        if not attributes.rstrip().endswith("/"):
            open_nodes.append(node)
    _add_text(open_nodes[-1], source[place:])
    return root


def _add_text(node: Node, text: str) -> None:
    if text.strip():
        node[2].append(("#text", "", [], unescape(text).strip()))


def _written(node: Node, depth: int) -> str:
    name, attributes, children, text = node
    if name == "#text":
        return "".join(_SIGNS.get(sign, sign) for sign in text)
    shown = (child for child in children if not child[0].startswith("annotation"))
    parts = [_written(child, depth + 1) for child in shown]
    inside = "".join(parts)
    write = _BY_COUNT.get((name, len(parts)))
    if write is not None:
        return write(parts)
    if name in _SHOWN_AS:
        return _SHOWN_AS[name](parts)
    if name == "mfenced":
        left, right = (_attribute(attributes, *pair) for pair in (("open", "("), ("close", ")")))
        return f"{left}{','.join(parts)}{right}"
    return f"\\{name} {inside}"


def _identifier(word: str) -> str:
    word = word.strip()
    if len(word) > 1 and word.isascii() and word.isalpha():
        return f"\\operatorname{{{word}}} " if word in _FUNCTIONS else f"\\mathrm{{{word}}}"
    return word


_FUNCTIONS = word_set("sin cos tan cot sec csc sinh cosh tanh exp ln log arcsin arccos arctan")


def _attribute(attributes: str, name: str, usual: str) -> str:
    match = re.search(rf"\b{name}\s*=\s*[\"']([^\"']*)[\"']", attributes)
    return unescape(match[1]) if match else usual


def _over(parts: list[str]) -> str:
    accent = _ACCENTS.get(parts[1].strip())
    return f"\\{accent}{{{parts[0]}}}" if accent else f"\\overset{{{parts[1]}}}{{{parts[0]}}}"


def _base(part: str) -> str:
    """Return a base in braces where it is more than one sign."""
    return part if len(part) == 1 or part.startswith("\\") else f"{{{part}}}"


_BY_COUNT: dict[tuple[str, int], Callable[[list[str]], str]] = {
    ("mfrac", 2): lambda p: f"\\frac{{{p[0]}}}{{{p[1]}}}",
    ("msup", 2): lambda p: f"{_base(p[0])}^{{{p[1]}}}",
    ("msub", 2): lambda p: f"{_base(p[0])}_{{{p[1]}}}",
    ("msubsup", 3): lambda p: f"{_base(p[0])}_{{{p[1]}}}^{{{p[2]}}}",
    ("munder", 2): lambda p: f"{_base(p[0])}_{{{p[1]}}}",
    ("munderover", 3): lambda p: f"{_base(p[0])}_{{{p[1]}}}^{{{p[2]}}}",
    ("mover", 2): _over,
    ("mroot", 2): lambda p: f"\\sqrt[{p[1]}]{{{p[0]}}}",
}
_SHOWN_AS: dict[str, Callable[[list[str]], str]] = {
    **dict.fromkeys(
        ("mrow", "math", "mstyle", "semantics", "mn", "mpadded", "menclose", "none", "mo", "mtd"), "".join
    ),
    **dict.fromkeys(("mspace", "mphantom", "mprescripts"), lambda p: " "),
    "mi": lambda p: _identifier("".join(p)),
    "mtext": lambda p: f"\\text{{{''.join(p)}}}" if "".join(p).strip(" \xa0") else " ",
    "msqrt": lambda p: f"\\sqrt{{{''.join(p)}}}",
    "mtable": lambda p: "\\begin{aligned}" + "".join(p) + "\\end{aligned}",
    **dict.fromkeys(("mtr", "mlabeledtr"), lambda p: "&".join(p) + "\\\\"),
}
