"""A page that declares an offset is not accused by the motion of a centred crank."""

import pytest

from symbalance.checking import check

LETTERS = {
    "r": "crank radius",
    "l": "rod length",
    "e": "offset of the cylinder axis",
    "theta": "crank angle",
    "beta": "angle of the connecting rod",
    "x": "height of the piston pin above the crank axis",
    "s": "stroke",
}


@pytest.mark.parametrize(
    "line",
    [
        "\\sin\\beta = \\frac{r\\sin\\theta - e}{l}",
        "x = r\\cos\\theta + \\sqrt{l^2-(r\\sin\\theta-e)^2}",
        "s = \\sqrt{(l+r)^2-e^2}-\\sqrt{(l-r)^2-e^2}",
    ],
)
def test_the_motion_of_an_offset_crank_is_not_accused(line: str) -> None:
    (link,) = check(f"$${line}$$", LETTERS).data()["links"]
    assert link["verdict"] not in ("refuted", "contradiction")


def test_without_an_offset_it_is_judged() -> None:
    letters = {name: text for name, text in LETTERS.items() if name != "e"}
    (link,) = check("$$\\sin\\beta = \\frac{r\\cos\\theta}{l}$$", letters).data()["links"]
    assert link["verdict"] == "refuted"


def test_what_no_motion_is_in_is_judged_beside_an_offset() -> None:
    (link,) = check("$$(r + l)^2 = r^2 + r l + l^2$$", LETTERS).data()["links"]
    assert link["verdict"] == "refuted"
