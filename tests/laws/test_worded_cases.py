"""A relation is of the number that its words speak of: at idle, the small one, (a), both."""

from __future__ import annotations

import pytest

from tests.checked_pages import last_verdict

SYMBOLS = (
    '[symbols]\n"r" = "crank radius"\n"l" = "rod length"\n"lambda" = "crank ratio r/l"\n"D" = "bore"\n'
    '"theta" = "crank angle"\n"omega" = "angular speed"\n'
)
ENGINES = "## Engine A\n\n$r = 40$ mm, $l = 140$ mm.\n\n## Engine B\n\n$r = 50$ mm, $l = 150$ mm.\n\n"
PAGES = [
    (
        "The small piston has $D = 50$ mm and the big one $D = 80$ mm. "
        "The area of the small one is $$\\frac{\\pi D^2}{4} = ?\\,\\mathrm{mm^2}$$",
        "1963",
        "5027",
    ),
    ("At point P $\\theta = 30°$, at Q $\\theta = 60°$. At P $$\\sin\\theta = ?$$", "0.5", "0.866"),
    (
        "(a) $\\theta = 30°$\n\n(b) $\\theta = 60°$\n\nSolution of (a): $$\\sin\\theta = ?$$",
        "0.5",
        "0.866",
    ),
    ("1. $y = 2$\n2. $y = 3$\n\nFor 1: $$y^2 = ?$$", "4", "9"),
    ("Before: $u = 2$. After: $u = 3$. Before, $$u^2 = ?$$", "4", "9"),
    (
        "At idle $\\omega = 80$ 1/s, at full speed $\\omega = 600$ 1/s. "
        "At idle, with $r = 50$ mm, $$r\\omega = ?\\,\\mathrm{m/s}$$",
        "4",
        "30",
    ),
    (ENGINES + "## Comparison\n\nThe first engine has $$\\lambda = r/l = ?$$", "0.286", "0.333"),
    (
        "Der alte Motor hat $r = 40$ mm, der neue hat $r = 50$ mm. "
        "Beim alten ist $$2 r = ?\\,\\mathrm{mm}$$",
        "80",
        "100",
    ),
    (
        "旧型では $r = 40$ mm、新型では $r = 50$ mm である。旧型では $$2 r = ?\\,\\mathrm{mm}$$",
        "80",
        "100",
    ),
    (
        "L'ancien moteur a $r = 40$ mm, le nouveau $r = 50$ mm. "
        "Pour l'ancien on a $$2 r = ?\\,\\mathrm{mm}$$",
        "80",
        "100",
    ),
    ("In summer $T = 300$ K. In winter $T = 260$ K. So in summer $$2 T = ?$$ K", "600", "520"),
]
OF_BOTH = [
    (ENGINES + "## Comparison\n\nBoth have $$\\lambda = r/l = 0.333$$", False),
    ("Motor A: $r = 40$ mm. Motor B: $r = 50$ mm. Beide haben $$2 r = 100\\,\\mathrm{mm}$$", False),
    (
        "Motor A: $r = 40$ mm, $l = 160$ mm. Motor B: $r = 50$ mm, $l = 200$ mm. "
        "Beide haben $$\\lambda = r/l = 0.25$$",
        True,
    ),
]
OF_THE_LAST = [
    "The crank radius is $r = 40$ mm. The new one has $r = 50$ mm. "
    "With this radius $$2 r = 100\\,\\mathrm{mm}$$",
    "The small piston has $D = 50$ mm and the big one $D = 80$ mm. "
    "It is larger than the small one: $$D^2 = 6400\\,\\mathrm{mm^2}$$",
    "At idle $\\omega = 80$ 1/s. At full load $\\omega = 600$ 1/s, "
    "more than at idle, and $$2\\omega = 1200$$ 1/s",
    "Der alte Motor hat $r = 40$ mm, der neue hat $r = 50$ mm. Der Hub ist $$2 r = 100\\,\\mathrm{mm}$$",
]
PROVED = ("holds", "holds_to_order", "conditional")
OPEN = ("refuted", "undecided", "contradiction")


@pytest.mark.parametrize(("page", "right", "wrong"), PAGES)
def test_the_number_spoken_of_decides(tmp_path, page, right, wrong):
    assert last_verdict(tmp_path, page.replace("?", right), SYMBOLS) in PROVED
    assert last_verdict(tmp_path, page.replace("?", wrong), SYMBOLS) in OPEN


@pytest.mark.parametrize(("page", "is_right"), OF_BOTH)
def test_what_is_said_of_both_is_asked_of_both(tmp_path, page, is_right):
    assert last_verdict(tmp_path, page, SYMBOLS) in (PROVED if is_right else OPEN)


@pytest.mark.parametrize("page", OF_THE_LAST)
def test_words_that_only_compare_lead_nowhere(tmp_path, page):
    assert last_verdict(tmp_path, page, SYMBOLS) in PROVED
