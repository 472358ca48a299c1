"""Pages on a phone, on a screen, on paper: nothing overlaps, nothing is cut, all by keyboard."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

import symbalance as sb
from tests.browser.opened import Opened

pytestmark = pytest.mark.rare
KINDS = ["inline-3", "vw-vr6", "v8-90", "v12-60", "boxer-4", "bugatti-w16", "r-1820", "kharkiv-v2"]
KINDS += ["man-6s50mc-c", "r-4360", "innio-v16"]
OVERLAPS = """() => Array.from(document.querySelectorAll("figure svg")).flatMap((svg) => {
    // Where one piston stands before another it hides its number.
    const id = svg.closest("figure").id, all = document.querySelectorAll("#plan [data-part]").length;
    if (id === "oblique" || (id === "plan" && all > 16)) return [];
    const labels = Array.from(svg.querySelectorAll("text"))
        .map((node) => [node, node.getBoundingClientRect()]).filter(([, box]) => box.width > 0);
    const found = [];
    labels.forEach(([a, p], i) => labels.slice(i + 1).forEach(([b, q]) => {
        const wide = Math.min(p.right, q.right) - Math.max(p.left, q.left);
        // A line of type is higher than its letters.
        const high = Math.min(p.bottom, q.bottom) - Math.max(p.top, q.top)
            - 0.2*Math.min(p.height, q.height);
        if (wide > 1 && high > 1) found.push([svg.closest("figure").id, a.textContent, b.textContent]);
    }));
    return found;
})"""
CUT = """() => Array.from(document.querySelectorAll("figure svg")).flatMap((svg) => {
    const box = svg.viewBox.baseVal;
    const labels = Array.from(svg.querySelectorAll("text"));
    return labels.filter((node) => node.getBoundingClientRect().width).map((node) => {
        const b = node.getBBox(), to = node.getCTM().inverse().multiply(svg.getCTM()).inverse();
        const at = (x, y) => new DOMPoint(x, y).matrixTransform(to);
        const p = at(b.x, b.y), q = at(b.x + b.width, b.y + b.height);
        const out = Math.max(box.x - p.x, q.x - box.x - box.width, box.y - p.y, q.y - box.y - box.height);
        return out > 3 ? [svg.closest("figure").id, node.textContent, out] : null;
    }).filter((each) => each);
})"""


@pytest.mark.parametrize("language", ["en", "ja"])
@pytest.mark.parametrize("name", KINDS)
def test_no_two_labels_overlap_and_none_is_cut(
    name: str, language: str, browser: Any, tmp_path: Path
) -> None:
    options = {"of": {"lang": language}, "viewport": {"width": 1280, "height": 900}}
    opened = Opened(browser, tmp_path, sb.load(name), **options)
    orders = opened.page.eval_on_selector_all("#order option", "all => all.map((o) => Number(o.value))")
    for order in [orders[0], *orders[-1:], 2]:
        for theta in (0, 77):
            opened.show(order=order, theta=theta)
            assert opened.page.evaluate(OVERLAPS) == []
            assert opened.page.evaluate(CUT) == []
    opened.show(share=0.5, back=0.3, order=1)
    assert opened.page.evaluate(OVERLAPS) == []
    assert opened.messages == []


@pytest.mark.parametrize("width", [390, 768, 1280])
@pytest.mark.parametrize("name", ["v8-90", "bugatti-w16", "r-985", "inline-3"])
def test_no_sideways_scroll(name: str, width: int, browser: Any, tmp_path: Path) -> None:
    opened = Opened(browser, tmp_path, sb.load(name), viewport={"width": width, "height": 800})
    opened.page.evaluate("document.querySelectorAll('details').forEach((each) => { each.open = true; })")
    assert opened.page.evaluate("document.documentElement.scrollWidth") <= width


@pytest.mark.parametrize("name", ["inline-3", "vw-vr6", "bugatti-w16", "r-1820", "wartsila-10rta96c"])
def test_a_page_prints_on_one_a4(name: str, browser: Any, tmp_path: Path) -> None:
    opened = Opened(browser, tmp_path, sb.load(name))
    pdf = opened.page.pdf(format="A4", prefer_css_page_size=True)
    assert len(re.findall(rb"/Type /Page[^s]", pdf)) == 1
    # Columns of figures are not cut off where the columns of the page are narrow.
    opened.page.emulate_media(media="print")
    opened.page.set_viewport_size({"width": 718, "height": 1000})
    wide = opened.page.evaluate(
        """() => { const half = document.querySelector("article").clientWidth/2;
        const tables = document.querySelectorAll("article table");
        return Array.from(tables, (table) => table.rows[0].offsetWidth - half); }"""
    )
    assert max(wide) <= 0


@pytest.fixture(scope="module")
def axe(tmp_path_factory: pytest.TempPathFactory) -> str:
    npm = shutil.which("npm")
    if npm is None:
        pytest.skip("no npm on this machine")
    folder = tmp_path_factory.mktemp("axe")
    fetched = subprocess.run(
        [npm, "install", "--silent", "--prefix", str(folder), "axe-core@4"],
        capture_output=True,
        check=False,
    )
    if fetched.returncode:
        pytest.skip("axe-core cannot be fetched here")
    return (folder / "node_modules/axe-core/axe.min.js").read_text(encoding="utf-8")


@pytest.mark.parametrize("media", ["light", "dark", "print"])
@pytest.mark.parametrize("name", ["v8-90", "r-1820", "two-stroke-37"])
def test_axe_finds_nothing(name: str, media: str, axe: str, browser: Any, tmp_path: Path) -> None:
    file = tmp_path / "page.html"
    file.write_text(sb.page(sb.load(name)).html, encoding="utf-8")
    scheme = "light" if media == "print" else media
    context = browser.new_context(color_scheme=scheme, bypass_csp=True, reduced_motion="reduce")
    page = context.new_page()
    page.goto(file.as_uri())
    if media == "print":
        page.emulate_media(media="print")
    page.evaluate("document.querySelectorAll('details').forEach((each) => { each.open = true; })")
    page.add_script_tag(content=axe)
    found = page.evaluate("async () => (await axe.run()).violations.map(v => [v.id, v.nodes[0].html])")
    assert found == []
    context.close()


def test_everything_is_reached_by_keyboard(browser: Any, tmp_path: Path) -> None:
    opened = Opened(browser, tmp_path, sb.load("v8-90"))
    page = opened.page
    reached = set()
    for _ in range(80):
        page.keyboard.press("Tab")
        reached.add(page.evaluate("(document.activeElement.id || document.activeElement.tagName)"))
    assert {"run", "theta", "angle", "reset", "order", "cylinder", "lambda", "bank", "reading"} <= reached
    assert {"share", "ahead", "back", "delta", "svg", "SUMMARY"} <= reached
    page.focus("#theta")
    page.keyboard.press("ArrowRight")
    assert page.evaluate("symbalance.state.theta") == 0.5
    page.focus("#run")
    page.keyboard.press("Space")
    assert page.get_attribute("#run", "aria-pressed") == "true"
    page.keyboard.press("Space")
    before = page.inner_html("#oblique svg")
    page.focus("#oblique svg")
    page.keyboard.press("ArrowLeft")
    assert page.inner_html("#oblique svg") != before


def test_an_angle_that_is_typed_is_shown(browser: Any, tmp_path: Path) -> None:
    opened = Opened(browser, tmp_path, sb.load("v8-90"))
    opened.page.fill("#angle", "123.25")
    assert opened.page.evaluate("symbalance.now.theta") == 123.25
    assert opened.transform("section", "crank")[1] == pytest.approx(123.25)
    assert "θ = 123.3°" in opened.page.inner_text("#now")
    opened.page.fill("#angle", "-90")
    assert opened.page.evaluate("symbalance.now.theta") == 630
    opened.page.fill("#angle", "")
    assert opened.page.evaluate("symbalance.now.theta") == 630


HOSTILE = ["<script>alert(1)</script>", "]]>", "\\input{x}", "x" * 60, "横置き", "</title><b>"]


@pytest.mark.parametrize("text", HOSTILE)
def test_a_hostile_name_is_shown_and_saved_as_text(text: str, browser: Any, tmp_path: Path) -> None:
    engine = sb.Engine(sb.load("inline-3").cylinders, name=text)
    opened = Opened(browser, tmp_path, engine)
    assert opened.page.text_content("h1") == text
    assert opened.page.title() == " ".join(text.split())
    assert opened.page.locator("b, script:not([type])").count() == 0
    assert opened.saved(tmp_path / "saved.toml") == engine
    opened.fill("cylinder 1, pin at", "10")
    assert opened.saved(tmp_path / "saved.toml").name == f"{text[:51]} (edited)"
    assert opened.messages == []


@pytest.mark.parametrize("name", ["v8-90", "r-1820", "vw-vr6"])
def test_every_drawing_says_what_it_shows(name: str, browser: Any, tmp_path: Path) -> None:
    opened = Opened(browser, tmp_path, sb.load(name))
    words = opened.page.eval_on_selector_all(
        "figure svg desc", "all => all.map((d) => [d.closest('figure').id, d.textContent])"
    )
    assert len(words) >= 10
    for figure, said in words:
        assert figure == "oblique" or re.search(r"\d|cancels", said), figure


def test_what_is_no_longer_the_engine_s_own_is_grey_and_says_so(browser: Any, tmp_path: Path) -> None:
    opened = Opened(browser, tmp_path, sb.load("v8-90"))
    colour = "getComputedStyle(document.querySelector('article')).color"
    before = opened.page.evaluate(colour)
    assert opened.page.is_hidden(".own")
    opened.show(**{"lambda": 3.3})
    assert opened.page.evaluate(colour) != before
    assert opened.page.is_visible(".own")
    opened.page.click("#reset")
    assert opened.page.evaluate(colour) == before
    assert opened.page.is_hidden(".own")


@pytest.mark.parametrize(
    ("name", "state", "edit"),
    [
        ("v8-90", {"bank": 175}, None),
        ("v8-90", {"lambda": 7.5}, None),
        ("inline-5", {}, ("cylinder 2, axis at", "100")),
        ("boxer-4", {}, ("cylinder 3, axis at", "0")),
        ("inline-3", {}, ("cylinder 3, station", "-4")),
    ],
)
def test_what_was_moved_is_in_sight(
    name: str, state: dict[str, Any], edit: tuple[str, str] | None, browser: Any, tmp_path: Path
) -> None:
    opened = Opened(browser, tmp_path, sb.load(name))
    if edit is not None:
        opened.fill(*edit)
    for theta in (0, 120, 250):
        opened.show(theta=theta, **state)
        out = opened.page.evaluate(
            """() => ["section", "plan"].flatMap((id) => {
            const svg = document.querySelector(`#${id} svg`);
            if (!svg) return [];
            const all = svg.getBBox(), box = svg.viewBox.baseVal;
            return [box.x - all.x, box.y - all.y, all.x + all.width - box.x - box.width,
                all.y + all.height - box.y - box.height]; })"""
        )
        assert max(out) <= 0
        assert opened.page.evaluate(OVERLAPS) == []
    opened.page.click("#reset")
    again = Opened(browser, tmp_path, sb.load(name))
    # The library's own box, its numbers to a tenth.
    boxes = [each.page.get_attribute("#section svg", "viewBox") for each in (opened, again)]
    assert boxes[0] == boxes[1]
