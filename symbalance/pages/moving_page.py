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
from symbalance.drawing.positions import Machine
from symbalance.drawing.section import draw_section
from symbalance.engine.engine import Engine, checked_engine
from symbalance.errors import SymbalanceError
from symbalance.forces.free_forces import Balance, balance
from symbalance.forces.pictures import draw_one_of_forces, draw_orders
from symbalance.pages.engine_data import engine_data
from symbalance.pages.packing import packed, with_shared_parts, with_short_names
from symbalance.pages.sentence import sentence
from symbalance.pages.words import translated, words_of

if TYPE_CHECKING:
    from symbalance.torque.running import RunningTorque

OUTPUTS = ("force.vertical", "force.lateral", "couple.vertical", "couple.lateral", "torque.inertia")
ORDER = 12
MOST_CYLINDERS = 64
"""Beyond, a page is neither small nor readable."""
MOST_RESOLVED = 9
"""Directions of axes whose forces are shown one by one."""
MOST_STILL = 20
"""Cylinders beyond which a page has no room for more than section, star and orders standing still."""
SCRIPT = ("kinematics", "shapes", "views", "charts", "stars", "editor", "frames")
"""The parts of the page's script, in order."""


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


def page(
    subject: Engine | Balance,
    *,
    rpm: object = None,
    lang: str = "en",
    running: RunningTorque | None = None,
) -> Page:
    """Return a page of an engine, or of a balance, that moves, and asks for nothing from outside.

    `rpm` puts its numbers in N and N m, if the engine has mass, stroke and pitch; `lang` is en or ja.
    With a `running` engine, `sb.running_torque(...)`, its gas and its whole torque are shown, in N m.
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
    if running is not None:
        _check_running(running, engine)
        rpm = running.rpm if rpm is None else rpm
    if rpm is not None:
        result = result.at(rpm=rpm)
    data = engine_data(result, running) | {"words": words, "fileName": f"{file_name(engine.name)}.toml"}
    script = f"{_emitted(result)}\n{packed(''.join(_file(f'script/{part}.js') for part in SCRIPT))}"
    assumed = Machine(engine).assumed
    made = words["made"].replace("@", _version())
    if assumed:
        made += " " + words["assumed"].replace("@", ", ".join(assumed))
    contents = {
        "lang": lang,
        "title": escape(engine.name),
        "sentence": escape(sentence(result, lang)),
        # What is used again in a drawing is styled as it stands alone, without the drawing around it.
        "style": _file("page.css")
        + svg_writer.style().replace(".sbd .", ".").replace(".sbd text", "text"),
        "controls": escape(words["controls"]),
        "unchecked": escape(words["unchecked"]),
        "noscript": escape(words["noscript"]),
        "inputs": _inputs(data, words),
        "figures": "\n".join(_figures(result, data, words)),
        "edit": escape(words["edit"]),
        "own": escape(words["own"]),
        "tables": document_html(_without_pictures(result.document())),
        "made": escape(made),
        # "<" cannot end the element, nor can a line separator end a string.
        "data": _json(data),
        "hash": "sha256-" + b64encode(sha256(script.encode()).digest()).decode("ascii"),
        "script": script,
    }
    return Page(engine.name, _filled(_file("page.html"), contents))


def _check_running(running: RunningTorque, engine: Engine) -> None:
    if running.engine.cylinders != engine.cylinders:
        rule = f"is of {running.engine.name}, whose cylinders are not those of {engine.name}"
        raise SymbalanceError("running", rule, "give running_torque of the page's own engine")
    if engine.first.reciprocating_mass is None or engine.first.radius is None:
        rule = "needs stroke and reciprocating mass in the engine's file"
        raise SymbalanceError("running", rule, "a page shows its torque in N m")


def file_name(name: str) -> str:
    """Return an engine's name as that of a file: letters, digits, - and _; others become -.

    >>> file_name("V8 <90>"), file_name("")
    ('V8--90', 'engine')
    """
    plain = "".join(c if c.isalnum() or c in "-_" else "-" for c in name).strip("-")
    return plain[:60] or "engine"


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
    head = (
        "// Made by symbalance: first the engine's functions as it emits them, packed; then what draws."
    )
    return f"{head}\n{packed(with_short_names(body, ('evaluate', 'OUTPUTS')))}"


def _inputs(data: dict[str, Any], words: dict[str, str]) -> str:
    """Return the controls: what moves, which stays in sight; what is looked at; the engine's sliders."""
    cycle = 180 * data["strokes"]
    speed = '<input id="speed" type="range" min="5" max="720" step="5" value="60">'
    angle = (
        f'<input id="angle" type="number" step="any" value="0" aria-label="{escape(words["angleBox"])}">'
    )
    motion = [
        f'<button type="button" id="run" aria-pressed="false">{escape(words["run"])}</button>',
        _range("theta", words, 0, cycle, 0.5, "°"),
        f"<span>{angle}°</span>",
        f"<label>{escape(words['speed'])}{speed}</label>",
        f'<button type="button" id="reset">{escape(words["reset"])}</button>',
    ]
    engine: list[str] = []
    if data["lambda"] is not None:
        least = 1.0 + max(abs(c["offset"]) for c in data["cylinders"])
        engine.append(
            _range("lambda", words, round(least + 0.5, 1), max(8, data["lambda"] + 1), 0.05, "")
        )
    if data["bankBetween"] is not None:
        engine.append(_range("bank", words, 0, 180, 0.5, "°"))
        engine.append(
            _choice("reading", words, [(n, words[f"reading-{n}"]) for n in ("crank", "firing")])
        )
    engine += [_range(name, words, 0, 1, 0.01, "") for name in ("share", "ahead", "back")]
    if data["hasWeights"]:
        engine.append(_range("weights", words, 0, 1.5, 0.01, ""))
    orders = [(f"{n}", f"{n}") for n in data["orders"]]
    orders += [(f"{n:g}", f"{round(2 * n)}/2 ({words['torqueOrder']})") for n in data["halfOrders"]]
    looked = [_choice("order", words, orders)]
    numbers = sorted(c["number"] for c in data["cylinders"])
    if len(numbers) > 1:
        looked.append(_choice("cylinder", words, [(f"{n}", f"{n}") for n in numbers]))
    if data["sizes"] is not None:
        looked.append(_range("rpm", words, 0, max(9000, data["rpm"]), 50, " rpm"))
    looked.append(_range("delta", words, 0.002, 0.1, 0.001, ""))
    rows = [
        '<div class="motion">',
        *motion,
        "</div>",
        '<div class="sliders">',
        *looked,
        *engine,
        "</div>",
    ]
    return "\n".join([*rows, '<p id="now" class="now"></p>'])


def _choice(name: str, words: dict[str, str], values: list[tuple[str, str]]) -> str:
    options = "".join(f'<option value="{escape(v)}">{escape(text)}</option>' for v, text in values)
    return f'<label>{escape(words[name])}<select id="{name}">{options}</select></label>'


def _range(name: str, words: dict[str, str], low: float, high: float, step: float, unit: str) -> str:
    limits = f'min="{low:g}" max="{high:g}" step="{step:g}" data-unit="{unit}"'
    head = f'<span>{escape(words[name])} <output for="{name}"></output></span>'
    return f'<label>{head}<input id="{name}" type="range" {limits}></label>'


NOTED = ("piston", "path", "couple-path", "phasors", "couple-phasors", "torque", "banks")
"""Figures with a line of numbers below them."""


def _figures(result: Balance, data: dict[str, Any], words: dict[str, str]) -> list[str]:
    """Return the figures, those that there is something to see in.

    Without scripts section, star, forces, orders and firing stand, as far as there is room; scripts draw
    the others.
    """
    engine = result.engine
    alone = len({c.station for c in engine.cylinders}) == 1
    directions = len({c.bank for c in engine.cylinders})
    large = len(engine.cylinders) > MOST_STILL
    figures: list[tuple[str, Callable[[], Drawing] | None]] = [
        ("section", lambda: draw_section(engine)),
        ("piston", None),
        *([("oblique", None)] if len(engine.cylinders) <= 32 else []),
        *([("strokes", None)] if any(c.link for c in engine.cylinders) else []),
        *([] if alone else [("plan", None)]),
        ("star", None if data["stars"]["turning"] else lambda: draw_star(engine, data["order"])),
        *([("banks", None)] if 2 <= directions <= MOST_RESOLVED else []),
    ]
    for of, name in (("force", "forces"), ("couple", "couples")):
        if getattr(result, of).orders():
            path = "path" if of == "force" else "couple-path"
            phasors = "phasors" if of == "force" else "couple-phasors"
            still = None if large else lambda of=of: draw_one_of_forces(result, of)
            figures += [(name, still), (path, None), (phasors, None)]
    figures += [("orders", lambda: draw_orders(result)), ("torque", None)]
    if all(c.fires is not None for c in engine.cylinders):
        figures.append(("firing", None if large else lambda: draw_firing(engine)))
    return [_figure(name, draw, data, words) for name, draw in figures]


def _figure(
    name: str, draw: Callable[[], Drawing] | None, data: dict[str, Any], words: dict[str, str]
) -> str:
    caption = words[f"{name}-figure"] if name in ("torque", "piston") else words[name]
    if name == "star":
        caption += f" {data['order']}"
    drawing = _empty(caption, words) if draw is None else translated(draw(), words)
    svg = svg_writer.drawing_svg(drawing, styled=False)
    if name == "section":
        svg = with_shared_parts(svg)
    live = " hidden" if draw is None else ""
    noted = '<p class="note"></p>' if name in NOTED else ""
    return (
        f'<figure id="{name}"{live}>\n{svg}\n<figcaption>{escape(caption)}</figcaption>{noted}</figure>'
    )


def _empty(title: str, words: dict[str, str]) -> Drawing:
    return Drawing((), -200, -190, 200, 190, title.replace("@", ""), words["drawnLive"])
