"""A relation said for multiples of a number: the sum over three cylinders, for k a multiple of 3."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

PAGE = """The crank angles are θ_1 = θ, θ_2 = θ − 120°, θ_3 = θ − 240°.

{before}$${relation}$${behind}
"""
SUM = r"\sum_{i=1}^{3}\cos k\theta_i = 3\cos k\theta"
WORDS = [
    ("", "\n\nholds only if $k$ is a multiple of {}."),
    ("", "\n\nif $k$ is divisible by {}."),
    ("", " for $k$ a multiple of {}."),
    ("", ", wenn $k$ durch {} teilbar ist."),
    ("", " gilt nur, wenn $k$ ein Vielfaches von {} ist."),
    ("", " si $k$ est multiple de {}."),
    ("", "\n\nとなるのは $k$ が{}の倍数のときだけである。"),
    ("If $k$ is a multiple of {}, then ", ""),
    ("When $k$ is divisible by {}, we have\n\n", ""),
    ("$k$ が{}の倍数のとき、", "となる。"),
]


def verdict_of(tmp_path, before, behind, relation=SUM):
    page = tmp_path / "page.md"
    page.write_text(PAGE.format(before=before, relation=relation, behind=behind), encoding="utf-8")
    return max(check(page).verdicts, key=lambda v: v.span).verdict


@pytest.mark.parametrize(("before", "behind"), WORDS)
@pytest.mark.parametrize("number", ["3", "6"])
def test_the_condition_is_of_the_relation_beside_it(tmp_path, before, behind, number):
    assert verdict_of(tmp_path, before.format(number), behind.format(number)) == "conditional"


@pytest.mark.parametrize(("before", "behind"), WORDS[:-1])
def test_multiples_of_another_number_do_not_satisfy_it(tmp_path, before, behind):
    assert verdict_of(tmp_path, before.format("2"), behind.format("2")) == "refuted"


@pytest.mark.parametrize(("before", "behind"), WORDS[:-1])
def test_another_sum_is_not_satisfied_by_multiples(tmp_path, before, behind):
    relation = SUM.replace("3\\cos", "2\\cos")
    assert verdict_of(tmp_path, before.format("3"), behind.format("3"), relation) == "refuted"


def test_what_a_sentence_before_says_is_not_of_the_next(tmp_path):
    before = "Orders with $k$ a multiple of 3 are special. In general "
    assert verdict_of(tmp_path, before, "") == "refuted"
