"""Engines with all cylinders around one crank: half of each force turns with it, half against it."""

from __future__ import annotations

import numpy as np
import pytest

from symbalance.checking import check
from symbalance.notes.checking.words.engines_in_words import CrankStar

PAGE = (
    "# {title}\n\nOne piston gives $F = m r\\omega^2$ in the first and $\\lambda F$ in the second order, "
    "$\\lambda = r/l$.\n\n{words}\n"
)
TITLES = ["Radial engines", "Der Sternmotor", "Motores en estrella", "星形エンジン"]
CLAIMS = [
    ("In the five-cylinder engine the resultant primary force is $F_1 = {}F$.", r"\frac52", "5"),
    ("In the seven-cylinder engine the resultant primary force is $F_1 = {}F$.", r"\frac72", "7"),
    (
        "In the three-cylinder engine the resultant of the secondary forces turns backwards with twice "
        r"the crank speed and is $F_2 = {}\lambda F$.",
        r"\frac32",
        "3",
    ),
    (
        "In the three-cylinder engine the secondary forces have the sum $F_2 = {}$.",
        r"\frac32\lambda F",
        "0",
    ),
]


def last(title: str, words: str) -> str:
    return check(PAGE.replace("{title}", title).replace("{words}", words)).data()["links"][-1]["verdict"]


@pytest.mark.parametrize("title", TITLES)
@pytest.mark.parametrize(("words", "right", "wrong"), CLAIMS)
def test_forces_around_one_crank_add_up_to_half_of_all(title, words, right, wrong):
    assert last(title, words.replace("{}", right)) == "conditional"
    assert last(title, words.replace("{}", wrong)) == "refuted"


def test_an_engine_in_line_on_the_same_page_is_none():
    words = "In the in-line three-cylinder engine the secondary forces have the sum $F_2 = {}$."
    assert last(TITLES[0], words.replace("{}", "0")) == "conditional"
    assert last(TITLES[0], words.replace("{}", r"\frac32\lambda F")) != "conditional"


@pytest.mark.parametrize("count", [3, 5, 7, 9])
@pytest.mark.parametrize("order", [1, 2, 3, 4, 6])
def test_the_size_is_that_of_the_vectors(count, order):
    axes = 2 * np.pi * np.arange(count) / count
    theta = np.linspace(0, 2 * np.pi, 97)
    forces = np.cos(order * (theta[:, None] - axes)) @ np.exp(1j * axes)
    star = CrankStar((0,) * count, is_radial=True)
    assert star.force(order) == pytest.approx(np.abs(forces).max(), abs=1e-12)
