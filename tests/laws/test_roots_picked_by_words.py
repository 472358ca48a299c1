"""Words that pick a root, or say where it lies, are heeded: lengths are positive, only x = 3 is one."""

from __future__ import annotations

import pytest

from tests.checked_pages import last_verdict

SQUARED = "$\\sqrt{x+1} = x - 1 \\Rightarrow x + 1 = (x-1)^2 \\Rightarrow x = 0$ or $x = 3$. "
STEPS = "$\\sqrt{x+1} = x - 1$.\n\nSquaring gives $x + 1 = (x-1)^2$, so $x = 0$ or $x = 3$. "
PAGES = [
    ("$x^2 = 16$. Because lengths are positive, $x = ?$.", "4", "-4"),
    ("$x^2 = 16$. Lengths are positive. So $x = ?$.", "4", "-4"),
    ("$x^2 = 16$. A length cannot be negative, so $x = ?$.", "4", "-4"),
    ("$x^2 = 16$. Da Längen positiv sind, ist $x = ?$.", "4", "-4"),
    ("$x^2 = 16$. Les longueurs sont positives, donc $x = ?$.", "4", "-4"),
    ("$x^2 = 16$. Le lunghezze sono positive, quindi $x = ?$.", "4", "-4"),
    ("$x^2 = 16$. Las longitudes son positivas, luego $x = ?$.", "4", "-4"),
    ("$x^2 = 16$. 長さは正なので $x = ?$。", "4", "-4"),
    ("$x^2 - x - 6 = (x-3)(x+2) = 0$. The larger root is $x = ?$.", "3", "-2"),
    ("$x^2 - x - 6 = (x-3)(x+2) = 0$. The smaller root is $x = ?$.", "-2", "3"),
    ("$x^2 = 16$. The larger of the roots is $x = ?$.", "4", "-4"),
    ("$x^2 = 16$. Die größere der beiden Lösungen ist $x = ?$.", "4", "-4"),
    ("$\\sin\\beta = 0.5$ with $\\beta$ between 90° and 180°, so $\\beta = ?$.", "150°", "30°"),
    ("$\\sin\\beta = 0.5$ mit $\\beta$ zwischen 90° und 180°, also $\\beta = ?$.", "150°", "30°"),
    ("$\\cos\\beta = 0.5$, $\\beta$ between 270° and 360°: $\\beta = ?$.", "300°", "60°"),
    (
        "$\\tan\\varphi = b/a$ with $a = -1$, $b = 1$, "
        "$\\varphi$ in the second quadrant: $\\varphi = ?$.",
        "135°",
        "-45°",
    ),
    (SQUARED + "Only $x = ?$ is a solution.", "3", "0"),
    (SQUARED + "The solution is $x = ?$.", "3", "0"),
    (SQUARED + "Nur $x = ?$ ist eine Lösung.", "3", "0"),
    (SQUARED + "Seul $x = ?$ est une solution.", "3", "0"),
    (STEPS + "Only $x = ?$ is a solution.", "3", "0"),
]
NOT_ACCUSED = [
    "$x^2 = 16$. Lengths are positive, so $x = -4$ is impossible.",
    "$x^2 = 16$. A length cannot be negative, so we reject $x = -4$.",
    "$x^2 = 16$. A length cannot be negative; $x = -4$ drops out.",
    "$x^2 = 16$. Da Längen positiv sind, scheidet $x = -4$ aus.",
    "$x^2 = 16$. Comme les longueurs sont positives, on écarte $x = -4$.",
    "For $\\varphi$ between 0° and 20°, $\\sin\\beta = 0.5$ gives $\\beta = 30°$.",
    SQUARED + "But $x = 0$ is not a solution.",
]


@pytest.mark.parametrize(("page", "right", "wrong"), PAGES)
def test_the_root_that_words_pick_is_asked_for(tmp_path, page, right, wrong):
    assert last_verdict(tmp_path, page.replace("?", right)) in ("holds", "holds_to_order", "conditional")
    assert last_verdict(tmp_path, page.replace("?", wrong)) == "refuted"


@pytest.mark.parametrize("page", NOT_ACCUSED)
def test_a_root_that_is_left_out_is_not_accused(tmp_path, page):
    assert last_verdict(tmp_path, page) != "refuted"
