"""Tables of what each sign and LaTeX command of a formula stands for."""

from __future__ import annotations

import re

from symbalance.document.wordlists import word_set, words

RELATION_SIGNS = {
    "=": "=", "＝": "=", "≈": "≈", "≒": "≈", "≃": "≈", "≅": "≈", "≐": "≈", "∼": "≈", "≑": "≈", "<": "<",
    ">": ">", "≤": "≤", "≥": "≥", "≦": "≤", "≧": "≥", "⩽": "≤", "⩾": "≥", "≡": "≡", "≜": "=", "≔": "=",
    "≠": "≠",
}  # fmt: skip

RELATION_COMMANDS = {
    **dict.fromkeys(words("approx simeq fallingdotseq cong doteq doteqdot sim approxeq"), "≈"),
    **dict.fromkeys(words("leq le leqq leqslant"), "≤"),
    **dict.fromkeys(words("geq ge geqq geqslant"), "≥"),
    **dict.fromkeys(words("triangleq coloneqq eq defeq shallbe"), "="),
    "lt": "<", "gt": ">", "equiv": "≡", "neq": "≠", "ne": "≠",
}  # fmt: skip

OPERATOR_SIGNS = {
    "+": "+", "-": "-", "−": "-", "–": "-", "‐": "-", "‑": "-", "*": "*", "×": "*", "·": "*", "⋅": "*",
    "∙": "*", "•": "*", "∗": "*", "/": "/", "÷": "/", "∕": "/", "⁄": "/",
}  # fmt: skip

OPERATOR_COMMANDS = {"cdot": "*", "times": "*", "ast": "*", "centerdot": "*", "div": "/", "slash": "/"}

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

STRUCTURE = word_set("frac dfrac tfrac cfrac sqrt over sum partial dot ddot dddot boxed infty surd")

REFUSED: dict[str, tuple[str, str]] = {
    **dict.fromkeys(
        words("int iint iiint oint intop smallint"),
        ("integrals are not read", "write the integral's value"),
    ),
    **dict.fromkeys(words("binom dbinom tbinom choose"), ("binomials are not read", "write it out")),
    **dict.fromkeys(words("pm mp"), ("± is two formulas in one", "write each on its own")),
    **dict.fromkeys(words("prod coprod"), ("product signs are not read", "write the factors")),
    **dict.fromkeys(words("lim limsup liminf"), ("limits are not read", "write the limit's value")),
    **dict.fromkeys(words("max min sup inf"), ("max and min are not read", "write the case that holds")),
    **dict.fromkeys(
        words("to rightarrow Rightarrow longrightarrow Longrightarrow implies iff leftarrow Leftarrow"
        " leftrightarrow Leftrightarrow mapsto therefore because"),
        ("arrows are not read", "write each equation on a line of its own"),
    ),
    **dict.fromkeys(words("propto"), ("proportionality is not read", "write = with its constant")),
    **dict.fromkeys(words("in subset cup cap land lor forall exists"), ("sets are not read", "")),
}  # fmt: skip

REFUSED_SIGNS = {
    "∫": REFUSED["int"], "∮": REFUSED["int"], "±": REFUSED["pm"], "∓": REFUSED["pm"],
    "∏": REFUSED["prod"],
    "→": REFUSED["to"], "⇒": REFUSED["to"], "←": REFUSED["to"], "↔": REFUSED["to"], "⇔": REFUSED["to"],
    "∴": REFUSED["to"], "∵": REFUSED["to"], "∝": REFUSED["propto"],
    "!": ("factorials are not read", "write the number"),
    "%": ("percentages are not read", "write the number divided by 100"),
}  # fmt: skip

OPENING = {"(": "(", "[": "[", "{": "{", "〔": "[", "⟨": "<"}
CLOSING = {")": ")", "]": "]", "}": "}", "〕": "]", "⟩": ">"}
BRACKET_COMMANDS = {
    "lbrace": ("open", "\\{"), "rbrace": ("close", "\\}"), "lbrack": ("open", "["),
    "rbrack": ("close", "]"),
    "lparen": ("open", "("), "rparen": ("close", ")"), "langle": ("open", "<"), "rangle": ("close", ">"),
    "lvert": ("open", "|"), "rvert": ("close", "|"), "vert": ("bar", "|"), "mid": ("bar", "|"),
}  # fmt: skip

ENVIRONMENTS = word_set(
    "equation align aligned gather gathered eqnarray multline split displaymath flalign alignat alignedat"
    " math dmath multlined dgroup darray"
)
"""LaTeX environments that hold equations, without the star."""

RELATION = re.compile(
    r"\\(?:" + "|".join(sorted(RELATION_COMMANDS, key=len, reverse=True)) + r")(?![A-Za-z])|["
    + re.escape("".join(set(RELATION_SIGNS) - set("=<>"))) + r"]|=(?!>)|<(?!-)|(?<![-=])>|(?<=\s)~(?=\s)"
)  # fmt: skip
"""A relation wherever it may stand; arrows such as => and -> are none, and ~ is one between spaces."""


def relation_at_start(text: str) -> str:
    """Return the relation a text begins with, "" if none."""
    match = RELATION.match(text)
    if not match:
        return ""
    sign = match.group()
    return RELATION_COMMANDS[sign[1:]] if sign[0] == "\\" else RELATION_SIGNS.get(sign, "≈")
