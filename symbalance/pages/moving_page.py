"""One page of an engine that moves: drawings, orders, tables and formulas in one file."""

from __future__ import annotations

import json
from base64 import b64encode
from collections.abc import Callable
from dataclasses import dataclass, replace
from hashlib import sha256
from html import escape
from importlib.resources import files
from typing import TYPE_CHECKING, Any

from symbalance.codegen.evaluators import plan_for
from symbalance.codegen.targets import files as sources
from symbalance.document import svg_writer
from symbalance.document.html_document import document_html
from symbalance.document.nodes import Details, Document, Figure
from symbalance.document.shapes import Drawing
from symbalance.drawing.crank_star import draw_star
from symbalance.drawing.firing_diagram import draw_firing
from symbalance.drawing.oblique import draw_oblique
from symbalance.drawing.plan import draw_plan
from symbalance.drawing.positions import Machine
from symbalance.drawing.section import draw_section
from symbalance.engine.engine import Engine, checked_engine
from symbalance.errors import SymbalanceError
from symbalance.forces.free_forces import Balance, balance
from symbalance.forces.pictures import draw_force_path, draw_one_of_forces, draw_orders
from symbalance.pages.engine_data import engine_data
from symbalance.pages.sentence import sentence
from symbalance.pages.words import translated, words_of
from symbalance.torque.inertia_balance import inertia_torque
from symbalance.torque.pictures import draw_torque

if TYPE_CHECKING:
    from symbalance.torque.inertia_balance import TorqueBalance

OUTPUTS = ("force.vertical", "force.lateral", "couple.vertical", "couple.lateral", "torque.inertia")
ORDER = 12
MOST_CYLINDERS = 64
"""Beyond, a page is neither small nor readable."""
FASTEST = 30_000


@dataclass(frozen=True)
class Page:
    """A page as one HTML text; in a notebook it shows itself within a frame."""

    title: str
    html: str

    def __repr__(self) -> str:
        return f"Page: {self.title}, {len(self.html.encode()) / 1000:.0f} kB"

    def _repr_html_(self) -> str:
        frame = 'style="width:100%;height:44rem;border:1px solid #999"'
        return f'<iframe title="{escape(self.title)}" {frame} srcdoc="{escape(self.html)}"></iframe>'


def page(subject: Engine | Balance, *, rpm: object = None, lang: str = "en") -> Page:
    """Return a page of an engine, or of a balance, that moves, and asks for nothing from outside.

    `rpm` puts its numbers in N and N m, if the engine has mass, stroke and pitch; `lang` is en or ja.
    Refused where no rod ratio is known, or angles are symbols.

    >>> from symbalance.engine.catalogue import load
    >>> page(load("inline-3")).title
    'inline-3'
    """
    words = words_of(lang)
    result = subject if isinstance(subject, Balance) else balance(checked_engine(subject), ORDER)
    engine = result.engine
    if len(engine.cylinders) > MOST_CYLINDERS:
        rule = f"has {len(engine.cylinders)} cylinders; a page shows {MOST_CYLINDERS} at most"
        raise SymbalanceError(engine.name, rule, "take symbalance balance, or draw")
    if rpm is not None:
        result = result.at(rpm=rpm)
    data = engine_data(result) | {"words": words}
    torque = inertia_torque(engine, result.highest)
    script = f"{_emitted(result)}\n{_compact(_file('page.js'))}"
    assumed = Machine(engine).assumed
    made = words["made"].replace("@", _version())
    if assumed:
        made += " " + words["assumed"].replace("@", ", ".join(assumed))
    contents = {
        "lang": lang,
        "title": escape(engine.name),
        "sentence": escape(sentence(result, lang)),
        "style": _file("page.css") + svg_writer.style(),
        "controls": escape(words["controls"]),
        "unchecked": escape(words["unchecked"]),
        "noscript": escape(words["noscript"]),
        "inputs": _inputs(data, words),
        "figures": "\n".join(_figures(result, torque, data, words)),
        "tables": document_html(_without_pictures(result.document())),
        "made": escape(made),
        # "<" cannot end the element, nor can a line separator end a string.
        "data": _json(data),
        "hash": "sha256-" + b64encode(sha256(script.encode()).digest()).decode("ascii"),
        "script": script,
    }
    return Page(engine.name, _filled(_file("page.html"), contents))


def _without_pictures(document: Document) -> Document:
    """Return a document without the folded drawings, which the page has in motion."""
    blocks = (
        b for b in document.blocks if not (isinstance(b, Details) and isinstance(b.blocks[0], Figure))
    )
    return replace(document, blocks=tuple(blocks))


def _filled(template: str, contents: dict[str, str]) -> str:
    """Return a template with its @names@ filled, and none within what another was filled with."""
    parts = template.split("@")
    known = [contents[part] if place % 2 else part for place, part in enumerate(parts)]
    return "".join(known)


def _json(data: dict[str, Any]) -> str:
    text = json.dumps(data, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    return text.replace("<", "\\u003c").replace("\u2028", "\\u2028").replace("\u2029", "\\u2029")


def _file(name: str) -> str:
    return (files("symbalance.pages") / name).read_text(encoding="utf-8")


def _compact(script: str) -> str:
    """Return a script without indentation and lines of comment, which a page need not carry."""
    lines = (line.strip() for line in script.splitlines())
    return "\n".join(line for line in lines if line and not line.startswith("//"))


def _version() -> str:
    from symbalance import __version__

    return __version__


def _emitted(result: Balance) -> str:
    """Return the library's functions of the engine as JavaScript, without its self-test."""
    # In units of m r omega^2 whatever the speed: the script multiplies by what its slider says.
    plan = plan_for(replace(result, operating_point=None), None, OUTPUTS, "javascript", 0.0, ORDER)
    (source,) = sources(plan, "javascript", result.engine.name, "engine", grid=False).values()
    start, test = source.index("*/") + 2, source.find("const CHECKS")
    body = source[start:test] if test > 0 else source[start:]
    body = body[: body.rindex("}") + 1].replace("export ", "").replace("</", "<\\/")
    head = "// Made by symbalance: first the engine's functions as it emits them, then what draws."
    return f"{head}\n{_compact(body)}"


def _inputs(data: dict[str, Any], words: dict[str, str]) -> str:
    cycle = 180 * data["strokes"]
    speed = '<input id="speed" type="range" min="5" max="720" step="5" value="60">'
    rows = [
        f'<button type="button" id="run" aria-pressed="false">{escape(words["run"])}</button>',
        _range("theta", words, 0, cycle, 0.5, "°"),
        f"<label>{escape(words['speed'])}{speed}</label>",
    ]
    if data["lambda"] is not None:
        least = 1.0 + max(abs(c["offset"]) for c in data["cylinders"])
        rows.append(_range("lambda", words, round(least + 0.5, 1), max(8, data["lambda"] + 1), 0.05, ""))
    if data["bankBetween"] is not None:
        rows.append(_range("bank", words, 0, 180, 0.5, "°"))
        names = ("crank", "firing")
        options = "".join(f'<option value="{n}">{escape(words[f"reading-{n}"])}</option>' for n in names)
        rows.append(f'<label>{escape(words["reading"])}<select id="reading">{options}</select></label>')
    rows.append(_range("share", words, 0, 1, 0.01, ""))
    if data["hasWeights"]:
        rows.append(_range("weights", words, 0, 1.5, 0.01, ""))
    if data["sizes"] is not None:
        rows.append(_range("rpm", words, 0, max(9000, data["rpm"]), 50, " rpm"))
    options = "".join(f"<option>{n}</option>" for n in data["orders"])
    rows.append(f'<label>{escape(words["order"])}<select id="order">{options}</select></label>')
    rows.append(f'<button type="button" id="reset">{escape(words["reset"])}</button>')
    rows.append('<p id="now" class="now"></p>')
    return "\n".join(rows)


def _range(name: str, words: dict[str, str], low: float, high: float, step: float, unit: str) -> str:
    limits = f'min="{low:g}" max="{high:g}" step="{step:g}" data-unit="{unit}"'
    head = f'<span>{escape(words[name])} <output for="{name}"></output></span>'
    return f'<label>{head}<input id="{name}" type="range" {limits}></label>'


def _figures(
    result: Balance, torque: TorqueBalance, data: dict[str, Any], words: dict[str, str]
) -> list[str]:
    """Return the figures, those that there is something to see in."""
    engine = result.engine
    alone = len({c.station for c in engine.cylinders}) == 1
    figures: list[tuple[str, Callable[[], Drawing], str]] = [
        ("section", lambda: draw_section(engine), "")
    ]
    if data["drawsOblique"]:
        figures.append(("oblique", lambda: draw_oblique(engine), ""))
    if not alone:
        figures.append(("plan", lambda: draw_plan(engine), ""))
    if len({c.bank for c in engine.cylinders}) <= 4:
        figures.append(("star", lambda: draw_star(engine, data["order"]), ""))
    for of, name in (("force", "forces"), ("couple", "couples")):
        if getattr(result, of).orders():
            path = "path" if of == "force" else "couple-path"
            figures.append((name, lambda of=of: draw_one_of_forces(result, of), ""))
            figures.append((path, lambda of=of: draw_force_path(result, of), ""))
            phasors = "phasors" if of == "force" else "couple-phasors"
            figures.append((phasors, lambda name=phasors: _empty(words[name]), " live"))
    figures.append(("orders", lambda: draw_orders(result), ""))
    figures.append(("torque", lambda: draw_torque(torque), ""))
    if all(c.fires is not None for c in engine.cylinders):
        figures.append(("firing", lambda: draw_firing(engine), ""))
    parts = []
    for name, draw, kind in figures:
        drawing = translated(draw(), words)
        caption = words["torque-figure" if name == "torque" else name]
        if name == "star":
            caption += f" {data['order']}"
        svg = svg_writer.drawing_svg(drawing, styled=False)
        hidden = ' data-live=""' if kind else ""
        parts.append(
            f'<figure id="{name}"{hidden}>\n{svg}\n<figcaption>{escape(caption)}</figcaption></figure>'
        )
    return parts


def _empty(title: str) -> Drawing:
    return Drawing((), -200, -190, 200, 190, title, "Drawn by the page's script, turning.")
