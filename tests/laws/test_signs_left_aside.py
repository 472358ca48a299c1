"""Relations in a page's head and in what programs print are no derivation, but they are counted."""

import json

import pytest

import symbalance as sb


def _counts(page, tmp_path, name):
    path = tmp_path / name
    path.write_text(page, encoding="utf-8")
    data = sb.check(str(path), {}).data()
    whys = [each["why"] for each in data["not_mathematics"]]
    assert data["seen"] == sum(data["counts"].values())
    return data["counts"]["not_mathematics"], whys, [link["verdict"] for link in data["links"]]


@pytest.mark.parametrize(
    ("head", "count"),
    [
        ("title: The proof that $1 = 2$", 1),
        ("title: On $a = b$\nsubtitle: E = m c^2", 2),
        ("title: None", 0),
    ],
)
def test_the_head_of_a_page(head, count, tmp_path):
    page = f"---\n{head}\n---\n\nWe have $2+2=4$.\n"
    expected = (count, ["in the head of the page"] * count, ["holds"])
    assert _counts(page, tmp_path, "page.md") == expected


@pytest.mark.parametrize(
    ("outputs", "count"),
    [
        ([{"output_type": "stream", "name": "stdout", "text": ["omega = 3\n", "k = 4"]}], 2),
        ([{"output_type": "execute_result", "data": {"text/latex": "$1 = 2$", "text/plain": "1=2"}}], 1),
        ([{"output_type": "stream", "name": "stdout", "text": "done"}], 0),
        ([], 0),
    ],
)
def test_what_a_program_printed(outputs, count, tmp_path):
    cells = [
        {"cell_type": "markdown", "source": ["$2+2=4$"]},
        {"cell_type": "code", "source": ["run()"], "outputs": outputs},
        {"cell_type": "markdown", "source": ["$2+2=5$"]},
    ]
    page = json.dumps({"cells": cells, "nbformat": 4, "nbformat_minor": 5, "metadata": {}})
    expected = (count, ["in what a program printed"] * count, ["holds", "refuted"])
    assert _counts(page, tmp_path, "page.ipynb") == expected
