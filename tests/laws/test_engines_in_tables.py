"""Tables of engines: the label of a row or the head of a column says whose force a cell gives."""

from __future__ import annotations

from pathlib import Path

import pytest

from symbalance.checking import check

WORDS = (
    "Free forces and couples\n\nOne cylinder gives F = m r ω² in the first and λF in the second order; "
    "a is the cylinder spacing.\n\n"
)
MARKDOWN = (
    "| order of the {kind} | in-line three | in-line {two} |\n|--|--|--|\n| {n} | ${one}$ | ${last}$ |\n"
)
WIKI = (
    '{{| class="wikitable"\n! order !! in-line three !! in-line {two}\n|-\n'
    "| {n} || ${one}$ || ${last}$\n|}}\n"
)
HTML = (
    "<table><tr><th>engine</th><th>{kind} of order {n}</th></tr>\n"
    "<tr><td>in-line three</td>\n<td>${one}$</td></tr>\n"
    "<tr><td>in-line {two}</td>\n<td>${last}$</td></tr></table>\n"
)
TABULAR = (
    "\\begin{{tabular}}{{ccc}}\norder of the {kind} & Three & {two}\\\\ \\hline\n"
    "{n} & ${one}$ & ${last}$\\\\\n\\end{{tabular}}\n"
)
_IN_HTML = {"_2": "<sub>2</sub>", "_1": "<sub>1</sub>", "\\lambda": "λ", "\\sqrt3": "√3", "$": ""}
CELLS = [
    ("force", "2", "four", "F_2 = 0", "F_2 = 4\\lambda F", "F_2 = 2\\lambda F"),
    ("force", "2", "six", "F_2 = 0", "F_2 = 0", "F_2 = 6\\lambda F"),
    ("couple", "1", "four", "M_1 = \\sqrt3 F a", "M_1 = 0", "M_1 = 2 F a"),
    ("couple", "2", "six", "M_2 = \\sqrt3\\lambda F a", "M_2 = 0", "M_2 = \\sqrt3\\lambda F a"),
]
TORQUE = r"""\section{Torque}
The inertia torque of a piston is
\[ M = F r\left(\frac{\lambda}{4}\sin\varphi - \frac12\sin 2\varphi
  - \frac{3\lambda}{4}\sin 3\varphi\right) . \]
Of whole engines:

\begin{tabular}{cll}
order & four, flat crank & six, 120 degrees\\
1 & $M_1 = 0$ & $M_1 = 0$ \\
{n} & $M_{n} = {four}$ & $M_{n} = {six}$ \\
\end{tabular}
"""


def words(page: str | Path) -> list[str]:
    return [entry["verdict"] for entry in check(page).data()["links"]]


def filled(markup: str, **cells: str) -> str:
    page = WORDS + markup.format(**cells)
    if markup != HTML:
        return page
    for typed, shown in _IN_HTML.items():
        page = page.replace(typed, shown)
    return f"<html><body>{page}</body></html>"


@pytest.mark.parametrize("markup", [MARKDOWN, WIKI, HTML, TABULAR])
@pytest.mark.parametrize(("kind", "n", "two", "one", "right", "wrong"), CELLS)
def test_each_cell_is_of_its_own_engine(tmp_path, markup, kind, n, two, one, right, wrong):
    page = tmp_path / ("page.html" if markup == HTML else "page.md")
    verdicts = []
    for last in (right, wrong):
        page.write_text(filled(markup, kind=kind, n=n, two=two, one=one, last=last), encoding="utf-8")
        verdicts.append(words(page))
    of_right, of_wrong = verdicts
    assert "refuted" not in of_right
    assert of_right[-2] == "conditional"
    may_be = (
        ("premise", "conditional") if one == right else ("conditional",)
    )  # 0, as in the column before
    assert of_right[-1] in may_be
    assert of_wrong[-2:] == ["conditional", "refuted"]


@pytest.mark.parametrize(
    ("n", "four", "six", "is_right"),
    [(4, "F r", "0", True), (4, "0", "0", False), (2, "2 F r", "0", True), (2, "0", "0", False)],
)
def test_orders_of_a_torque_add_up_without_arms(n, four, six, is_right):
    page = TORQUE.replace("{n}", str(n)).replace("{four}", four).replace("{six}", six)
    assert ("refuted" not in words(page)) == is_right


@pytest.mark.parametrize("wrong", [False, True])
def test_words_before_a_display_name_its_engine_before_the_title_does(wrong):
    page = (
        "# 水平対向4気筒\n\nF = m r ω²、λ = r/l とする。\n\n直列4気筒の2次慣性力は\n\n"
        f"F2 = {2 if wrong else 4} λ F cos 2φ\n"
    )
    assert words(page)[-1] == ("refuted" if wrong else "conditional")


TITLED = (
    "---\ntitle: {title}\nlang: it\n---\n\n# {title}\n\n"
    "Le manovelle stanno a 0°, 180°, 180° e 0°; per un cilindro "
    "$F = m r\\omega^2$, $\\lambda = r/l$, con $r = 45$ mm; $p$ è l'interasse.\n\n## Somma\n\n{words}\n"
)


@pytest.mark.parametrize("title", ["Il quattro in linea", "Le quatre en ligne", "Four in line"])
@pytest.mark.parametrize(
    ("claim", "right", "wrong"),
    [
        (
            r"La forza del secondo ordine: $F_{II} = 4{}m r\omega^2\cos 2\theta$.",
            r"\lambda ",
            r"\lambda^2 ",
        ),
        ("Il momento del primo ordine ha ampiezza $M_I = {}$.", "0", "2F p"),
    ],
)
def test_a_title_below_front_matter_names_the_engine_of_each_section(title, claim, right, wrong):
    page = TITLED.replace("{title}", title)
    assert words(page.replace("{words}", claim.replace("{}", right)))[-1] == "conditional"
    assert words(page.replace("{words}", claim.replace("{}", wrong)))[-1] == "refuted"
