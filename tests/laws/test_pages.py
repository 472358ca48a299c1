"""Pages hold what they show, fetch nothing, fit their budget and take hostile names as text."""

from __future__ import annotations

import json
import math
import re
import xml.etree.ElementTree as ET
from base64 import b64encode
from hashlib import sha256

import pytest

import symbalance as sb
from symbalance.drawing.charts import figure
from symbalance.pages.sentence import sentence
from symbalance.pages.words import ENGLISH, JAPANESE, LANGUAGES

QUICK = ["inline-3", "vw-vr6"]
KINDS = [
    *QUICK,
    *(pytest.param(name, marks=pytest.mark.slow) for name in ("v8-90", "v12-60", "boxer-4")),
    *(pytest.param(name, marks=pytest.mark.slow) for name in ("bugatti-w16", "r-1820", "kharkiv-v2")),
]
LARGEST = 150_000


def data_of(html: str) -> dict:
    found = re.search(r'<script type="application/json" id="engine">(.*?)</script>', html, re.DOTALL)
    assert found is not None
    return json.loads(found[1])


@pytest.mark.parametrize("name", KINDS)
def test_a_page_is_small_and_fetches_nothing(name: str) -> None:
    html = sb.page(sb.load(name)).html
    assert len(html.encode()) <= LARGEST
    assert "default-src 'none'" in html
    # Names of vocabularies are no addresses that are fetched.
    assert set(re.findall(r"https?://[^\"' <]*", html)) <= {"http://www.w3.org/2000/svg"}
    assert not re.search(r"<(link|iframe|img|object|embed)\b", html)


def test_the_policy_names_the_script_it_allows() -> None:
    html = sb.page(sb.load("inline-3")).html
    script = html.rpartition('<script type="module">')[2].rpartition("</script>")[0]
    digest = b64encode(sha256(script.encode()).digest()).decode()
    assert f"script-src 'sha256-{digest}'" in html


@pytest.mark.parametrize(
    "text", ["<script>alert(1)</script>", "]]>", "@hash@", "a & b", "横置き", "</script>"]
)
def test_a_hostile_name_is_text(text: str) -> None:
    engine = sb.Engine(sb.load("inline-3").cylinders, name=text)
    html = sb.page(engine).html
    assert html.count("<script") == 2
    assert html.count("</script>") == 2
    assert data_of(html)["name"] == text


@pytest.mark.parametrize("name", KINDS)
def test_the_still_drawings_are_well_formed(name: str) -> None:
    html = sb.page(sb.load(name)).html
    drawings = re.findall(r"<svg.*?</svg>", html, re.DOTALL)
    assert len(drawings) >= 5
    for drawing in drawings:
        root = ET.fromstring(drawing)
        words = [node.text for node in root if node.tag in ("title", "desc")]
        assert len(words) == 2
        assert all(words)
    names = re.findall(r'id="([^"]+)"', html)
    assert len(names) == len(set(names))


@pytest.mark.slow
def test_every_word_is_in_both_languages() -> None:
    assert set(ENGLISH) <= set(JAPANESE)
    for language in LANGUAGES:
        html = sb.page(sb.load("v8-90"), lang=language).html
        assert f'<html lang="{language}">' in html
    assert "慣性偶力" in html
    assert "膨張" in html
    # Nothing of the English page is left in what a script writes.
    assert not [w for key, w in data_of(html)["words"].items() if w == ENGLISH.get(key) != key]


def test_newtons_stand_on_a_page_at_a_speed() -> None:
    html = sb.page(sb.load("vq30de"), rpm=6000).html
    data = data_of(html)
    assert data["rpm"] == 6000
    assert data["sizes"] == {"mass": 0.673, "radius": 0.03665, "pitch": 0.108}
    assert " N" in html


@pytest.mark.parametrize("lang", ["en", "ja"])
def test_the_sentence_says_newtons_where_they_are_known(lang: str) -> None:
    engine = sb.load("vq30de")
    result = sb.balance(engine).at(rpm=6000)
    said = sentence(result, lang)
    order = result.couple.orders()[0]
    part = result.couple.component(order, "lateral").decimal(20)
    amount = float(result.unit_value("couple")) * math.hypot(*map(float, part))
    assert f"({figure(amount)} N m)" in said
    assert "N" not in sentence(sb.balance(engine), "ja")


@pytest.mark.parametrize(
    ("engine", "said"),
    [
        (sb.inline("1-3-4-2"), "no rod ratio"),
        (sb.inline(throws=[0] * 65, ratio=4), "64 at most"),
    ],
)
def test_what_cannot_be_shown_is_refused(engine: sb.Engine, said: str) -> None:
    with pytest.raises(sb.SymbalanceError, match=said):
        sb.page(engine)


def test_the_language_is_checked() -> None:
    with pytest.raises(sb.SymbalanceError, match="lang = fr"):
        sb.page(sb.load("inline-3"), lang="fr")


def test_a_notebook_gets_the_page_in_a_frame() -> None:
    page = sb.page(sb.load("inline-3"))
    assert page._repr_html_().startswith("<iframe")
    assert repr(page).startswith("Page: inline-3, ")


@pytest.mark.slow
def test_the_numbers_for_the_script_are_the_engine_s() -> None:
    engine = sb.load("r-985")
    for row, cylinder in zip(data_of(sb.page(engine).html)["cylinders"], engine.cylinders, strict=True):
        assert row["number"] == cylinder.number
        assert row["length"] == float(cylinder.known_mechanism.length)
        assert ("link" in row) == (cylinder.link is not None)
