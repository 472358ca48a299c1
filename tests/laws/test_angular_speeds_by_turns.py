"""ω of a letter that words count in revolutions, or of a speed in words, is right or wrong by itself."""

import pytest

from tests.checked_pages import last_in


@pytest.mark.parametrize(
    ("page", "right", "wrong"),
    [
        ("For $N$ revolutions a minute $\\omega = {}$.", "\\pi N/30", "\\pi N/60"),
        ("At $N$ revolutions per minute $\\omega = {}$.", "2\\pi N/60", "2\\pi N"),
        ("If it makes $n$ revolutions per second, $\\omega = {}$.", "2\\pi n", "\\pi n"),
        ("Bei $n$ Umdrehungen pro Minute ist $\\omega = {}$.", "\\pi n/30", "n/60"),
        ("À $N$ tours par minute, $\\omega = {}$.", "2\\pi N/60", "\\pi N/60"),
        ("At 1300 rpm $\\omega = {}$.", "2\\pi\\cdot 1300/60", "1300/60"),
        ("At 3000 rpm $\\omega = 314$ rad/s, at 6000 rpm $\\omega = {}$ rad/s.", "628", "314"),
        ("$\\omega = 314$ rad/s at 3000 rpm and $\\omega = {}$ rad/s at 6000 rpm.", "628", "314"),
        ("Bei 1300 U/min ist $\\omega = {}$.", "\\pi\\cdot 1300/30", "\\pi\\cdot 1300/60"),
    ],
)
def test_an_angular_speed_by_the_turns_that_words_count(page, right, wrong):
    assert last_in(page.format(right)) in ("holds", "conditional", "holds_to_order")
    assert last_in(page.format(wrong)) == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        "At $N$ revolutions per minute of the crank the camshaft has $\\omega = \\pi N/60$.",
        "At 1300 rpm the engine makes $n = 1300/60$.",
        "For $N$ teeth $\\omega = \\pi N/60$.",
        "At 3000 rpm the whirl has $\\omega = 157$ rad/s.",
    ],
)
def test_another_shaft_and_another_letter_are_left_alone(page):
    assert last_in(page) != "refuted"
