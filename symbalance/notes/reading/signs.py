"""Tables of what each sign and LaTeX command of a formula stands for."""

from __future__ import annotations

from symbalance.document.letters import DOTTED
from symbalance.document.wordlists import word_set, words
from symbalance.text import lazy_patterns as re

RELATION_SIGNS = {
    "=": "=", "＝": "=", "≈": "≈", "≒": "≈", "≃": "≈", "≅": "≈", "≐": "≈", "∼": "≈", "≑": "≈", "<": "<",
    ">": ">", "≤": "≤", "≥": "≥", "≦": "≤", "≧": "≥", "⩽": "≤", "⩾": "≥", "≡": "≡", "≜": "=", "≔": "=",
    "≠": "≠", "≪": "≪", "≫": "≫", "∝": "∝",
}  # fmt: skip

RELATION_COMMANDS = {
    **dict.fromkeys(words("approx simeq fallingdotseq cong doteq doteqdot sim approxeq"), "≈"),
    **dict.fromkeys(words("leq le leqq leqslant"), "≤"),
    **dict.fromkeys(words("geq ge geqq geqslant"), "≥"),
    **dict.fromkeys(words("triangleq coloneqq coloneq colonequals eqqcolon eqcolon equalscolon"), "="),
    **dict.fromkeys(words("eq defeq shallbe"), "="),
    "lt": "<", "gt": ">", "equiv": "≡", "neq": "≠", "ne": "≠", "ll": "≪", "gg": "≫",
    "propto": "∝", "varpropto": "∝",
}  # fmt: skip

OPERATOR_SIGNS = {
    "+": "+", "-": "-", "−": "-", "–": "-", "‐": "-", "‑": "-", "*": "*", "×": "*", "·": "*", "⋅": "*",
    "∙": "*", "•": "*", "∗": "*", "/": "/", "÷": "/", "∕": "/", "⁄": "/", "±": "±", "∓": "∓",
}  # fmt: skip

OPERATOR_COMMANDS = {
    "cdot": "*", "times": "*", "ast": "*", "centerdot": "*", "div": "/", "slash": "/",
    "pm": "±", "mp": "∓",
}  # fmt: skip

DOTS_COMMANDS = word_set("cdots ldots dots dotsb dotsc dotsm dotso hdots")
DOTS_SIGNS = ("･･･", "・・・", "...", "⋯", "…")

SPACE_COMMANDS = word_set(
    "displaystyle textstyle scriptstyle scriptscriptstyle limits nolimits displaylimits quad qquad"
    " nonumber notag hfill hfil strut mathstrut thinspace medspace thickspace negthinspace enspace"
    " enskip allowbreak nobreak relax left right middle big Big bigg Bigg bigl bigr bigm Bigl Bigr"
    " Bigm biggl biggr Biggl Biggr null noindent centering"
)
"""Commands without a meaning of their own; \\left and its kin are handled before this."""

SPACE_WITH_ARGUMENT = word_set("label tag hspace vspace phantom hphantom vphantom hskip mspace")

STRUCTURE = word_set(
    "frac dfrac tfrac cfrac sqrt over sum partial dot ddot dddot boxed infty surd surd3 surd4"
)

WITH_BOUNDS = {
    "int": "int", "intop": "int", "smallint": "int", "oint": "oint", "prod": "prod", "lim": "lim",
    "max": "max", "min": "min",
}  # fmt: skip
"""Commands that take bounds or a place below them, to the construct they begin."""

CONSTRUCTS = {
    **WITH_BOUNDS, **dict.fromkeys(words("binom dbinom tbinom"), "binom"), "top": "top",
    "intercal": "top", "det": "det",
}  # fmt: skip
"""Commands of constructs that `constructs` reads."""

CELLS = {
    **dict.fromkeys(words("matrix pmatrix bmatrix Bmatrix smallmatrix array"), "[matrix]"),
    "vmatrix": "[vmatrix]", "cases": "[cases]", "dcases": "[cases]",
}  # fmt: skip
"""Environments of rows and cells, to the bracket that stands for them."""

CONDITION_WORDS = frozenset(
    {
        "",
        "if",
        "for",
        "when",
        "where",
        "falls",
        "für",
        "wenn",
        "otherwise",
        "else",
        "sonst",
        "andernfalls",
    }
)
"""Words that stand among cases and say nothing that the relation does not."""

DIVIDES = frozenset({"divides", "teilt", "divise", "is a divisor of", "ist teiler von"})
IS_DIVISIBLE = frozenset(
    {
        "is a multiple of",
        "a multiple of",
        "multiple of",
        "is divisible by",
        "divisible by",
        "vielfaches von",
    }
    | {"ist vielfaches von", "ist ein vielfaches von", "is an integer multiple of"}
)
"""Words between two whole numbers of a case: N divides n, n is a multiple of N."""
MULTIPLE = "⋮"
EVEN = frozenset(
    {"even", "is even", "gerade", "ist gerade", "pair", "est pair", "par", "es par", "pari", "偶数"}
)
ODD = frozenset(
    {
        "odd",
        "is odd",
        "ungerade",
        "ist ungerade",
        "impair",
        "est impair",
        "impar",
        "es impar",
        "dispari",
        "奇数",
    }
)
"""What a case says of a whole number: what is left of it, divided by two."""
REMAINDERS = ("bmod", "mod", "pmod")
"""Commands for what is left of a whole number: n \\bmod 4 = 1, n \\equiv 1 \\pmod 4."""

ARROWS = word_set("to rightarrow longrightarrow searrow nearrow")
"""Arrows that a limit may have."""

OWN_FUNCTIONS = {"Re": "re", "Im": "im", "conj": "conj", "lg": "lg"}
"""Functions by words that are letters too, where all of these are declared; they need brackets."""

REFUSED: dict[str, tuple[str, str]] = {
    **dict.fromkeys(
        words("iint iiint iiiint idotsint"),
        ("integrals over areas are not read", "write one integral in the other"),
    ),
    **dict.fromkeys(words("choose"), ("a binomial by \\choose is not read", "write \\binom{n}{k}")),
    "substack": ("conditions stacked below a sum are not read", "write one range, \\sum_{k=1}^{n}"),
    **dict.fromkeys(words("coprod"), ("coproducts are not read", "write the factors")),
    **dict.fromkeys(
        words("limsup liminf"), ("upper and lower limits are not read", "write the limit's value")
    ),
    **dict.fromkeys(
        words("sup inf argmax argmin"), ("sup and inf are not read", "write max or min, or the value")
    ),
    **dict.fromkeys(
        words("to rightarrow Rightarrow longrightarrow Longrightarrow implies iff leftarrow Leftarrow"
        " leftrightarrow Leftrightarrow mapsto therefore because"),
        ("arrows are not read", "write each equation on a line of its own"),
    ),
    **dict.fromkeys(words("in subset cup cap land lor forall exists"), ("sets are not read", "")),
}  # fmt: skip

UNREAD_RELATIONS = re.compile(
    "[≙≘≚≛≝≞≟≊∽≍≎≏≢≣≨≩≭≮≯≰≱≲≳≴≵≶≷≺≻≼≽≾≿⋍⋖⋗⋘⋙⋚⋛⩰⩵⪅⪆⪇⪈⪉⪊⪋⪌⪍⪎⪕⪖⪝⪞⪯⪰≁≄≇≉"
    "≂≆≋≌≓≕-≗≸≹⊀⊁⋜-⋟⧣-⧥⩦-⩯⩱-⩴⩶-⩼⩿-⪄⪏-⪔⪗-⪜⪟-⪢⪪-⪮⪱-⪼﹤-﹦꞊]"
    r"|\\(?:gtrsim|lesssim|gtrapprox|lessapprox|asymp|nless|ngtr|nleq|ngeq|nleqslant|ngeqslant|bumpeq|Bumpeq"
    r"|risingdotseq|circeq|prec|succ|preceq|succeq|ncong|nsim|gneqq?|lneqq?|lessgtr|gtrless|lesseqgtr|gtreqless"
    r"|backsimeq|backsim|eqcirc|thickapprox|thicksim)(?![A-Za-z])"
)
"""Relations that are counted and not judged: about what they claim people differ, or they are rare."""

REFUSED_SIGNS = {
    "→": REFUSED["to"], "⇒": REFUSED["to"], "←": REFUSED["to"], "↔": REFUSED["to"], "⇔": REFUSED["to"],
    "∴": REFUSED["to"], "∵": REFUSED["to"],
    "%": ("percentages are not read", "write the number divided by 100"),
}  # fmt: skip

OPENING = {"(": "(", "[": "[", "{": "{", "〔": "[", "⟨": "<"}
CLOSING = {")": ")", "]": "]", "}": "}", "〕": "]", "⟩": ">"}
BRACKET_COMMANDS = {
    "lbrace": ("open", "\\{"), "rbrace": ("close", "\\}"), "lbrack": ("open", "["),
    "rbrack": ("close", "]"),
    "lparen": ("open", "("), "rparen": ("close", ")"), "langle": ("open", "<"), "rangle": ("close", ">"),
    "lVert": ("open", "|"), "rVert": ("close", "|"), "Vert": ("bar", "|"),
    "lvert": ("open", "|"), "rvert": ("close", "|"), "vert": ("bar", "|"), "mid": ("bar", "|"),
}  # fmt: skip

ENVIRONMENTS = word_set(
    "equation align aligned gather gathered eqnarray multline split displaymath flalign alignat alignedat"
    " math dmath multlined dgroup darray"
)
"""LaTeX environments that hold equations, without the star."""

RELATION = re.compile(
    r"\\(?:" + "|".join(sorted(RELATION_COMMANDS, key=len, reverse=True)) + r")(?![A-Za-z])|["
    + re.escape("".join(set(RELATION_SIGNS) - set("=<>"))) + r"]|=(?!>)|<(?!-+(?![\w.\\(]))|(?<![-=])>"
    r"|(?<=\s)~(?=\s)"
)  # fmt: skip
"""A relation wherever it may stand; arrows such as => and -> are none, x<-2 is one, ~ between spaces."""

VULGAR = {
    "½": (1, 2), "⅓": (1, 3), "⅔": (2, 3), "¼": (1, 4), "¾": (3, 4), "⅕": (1, 5), "⅖": (2, 5),
    "⅗": (3, 5), "⅘": (4, 5), "⅙": (1, 6),
    "⅚": (5, 6), "⅛": (1, 8), "⅜": (3, 8), "⅝": (5, 8), "⅞": (7, 8),
}  # fmt: skip
"""Fractions of one sign, as numerator and denominator."""


def relation_at_start(text: str) -> str:
    """Return the relation a text begins with, "" if none."""
    match = RELATION.match(text)
    if not match:
        return ""
    sign = match.group()
    return RELATION_COMMANDS[sign[1:]] if sign[0] == "\\" else RELATION_SIGNS.get(sign, "≈")


_COMBINING = {
    "\u0302": "hat", "\u0304": "bar", "\u0303": "tilde", "\u0307": "dot", "\u0308": "ddot",
    "\u20d7": "vec",
}  # fmt: skip
COMBINED = re.compile(
    rf"([A-Za-zα-ω])([{''.join(_COMBINING)}])([₀₁₂₃₄₅₆₇₈₉]+|[0-9]{{1,2}}(?![0-9]|[.,][0-9])|)"
)
"""A letter with an accent that Unicode sets above it, and its subscript, be it typed on the line: φ̈1."""


def accented(match: re.Match[str]) -> str:
    r"""Return such a letter as LaTeX has it.

    >>> accented(COMBINED.match("F\u0302₂"))
    '\\hat{F₂}'
    >>> accented(COMBINED.match("φ\u03081"))
    '\\ddot{φ1}'
    """
    return f"\\{_COMBINING[match[2]]}{{{match[1]}{match[3]}}}"


DOTTED_NUMBERED = re.compile(rf"(?<![^\W\d_])([{''.join(DOTTED)}])([0-9]{{1,2}})(?![0-9]|[.,][0-9])")
"""A letter that Unicode has with its dots, and its subscript typed on the line: ẍ1."""


def dotted_numbered(match: re.Match[str]) -> str:
    r"""Return such a letter as LaTeX has it.

    >>> dotted_numbered(DOTTED_NUMBERED.match("ẍ1"))
    '\\ddot{x1}'
    """
    letter, order = DOTTED[match[1]]
    return f"\\{'dot' if order == 1 else 'ddot'}{{{letter}{match[2]}}}"
