"""Drawings within documents: each medium shows them in its own form, and draws none in vain."""

from __future__ import annotations

import subprocess
import sys

import symbalance as sb
from symbalance.document.html_document import document_html
from symbalance.document.nodes import Document, Figure
from symbalance.document.shapes import Drawing


def balance() -> sb.Balance:
    return sb.balance(sb.load("v8-90"), 4)


def test_html_holds_the_drawings_with_their_words_and_their_style_once() -> None:
    html = sb.to_html(balance())
    assert html.count('<svg class="sbd"') == 2
    assert html.count(".sbd .crank{") == 2  # in light and in dark surroundings
    assert "<desc" in html
    assert "Fires 1-8-4-3-6-5-7-2, every 90°." in html
    assert sb.to_html(balance()) == html  # names within it are the same however often it is written


def test_latex_in_full_holds_them_as_tikz_and_says_what_it_needs() -> None:
    full = sb.to_latex(balance(), full=True)
    assert full.splitlines()[0].endswith("{amsmath,booktabs,tikz}")
    assert full.count(r"\begin{tikzpicture}") == 2
    short = sb.to_latex(balance())
    assert "tikz" not in short
    assert "crank star" not in short


def test_text_and_markdown_say_what_they_show() -> None:
    said = "Fires 1-8-4-3-6-5-7-2, every 90°."
    assert said in sb.to_text(balance(), full=True)
    assert said not in sb.to_text(balance())
    assert "Fires 1\\-8" in sb.to_markdown(balance()) or said in sb.to_markdown(balance())


def test_text_and_json_load_nothing_that_draws() -> None:
    lines = "b = sb.balance(sb.load('v8-90'), 4); sb.to_text(b); sb.to_json(b)"
    code = f"import sys, symbalance as sb; {lines}; print([m for m in sys.modules if 'draw' in m])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "[]\n"


def test_a_figure_is_drawn_by_the_medium_that_shows_it_and_once() -> None:
    drawn = []

    def draw() -> Drawing:
        drawn.append(1)
        return Drawing((), 0.0, 0.0, 1.0, 1.0, "a < b", "says & shows")

    document = Document("x", (Figure("x.svg", draw, ""),))
    assert not drawn
    assert "a &lt; b" in document_html(document)
    assert len(drawn) == 1
