"""A page opened from disk by a browser, as a reader opens it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import symbalance as sb

OUTPUTS = ("force.vertical", "force.lateral", "couple.vertical", "couple.lateral", "torque.inertia")


class Opened:
    """A page opened from disk, with what it said and what it asked for."""

    def __init__(self, browser: Any, folder: Path, engine: sb.Engine, **options: Any) -> None:
        file = folder / "page.html"
        file.write_text(sb.page(engine, **options.pop("of", {})).html, encoding="utf-8")
        hash_ = options.pop("hash", "#theta=0")
        options = {"viewport": {"width": 1280, "height": 900}, "reduced_motion": "reduce"} | options
        self.page = browser.new_page(**options)
        self.messages: list[str] = []
        self.requests: list[str] = []
        self.page.on("console", lambda message: self.messages.append(message.text))
        self.page.on("pageerror", lambda error: self.messages.append(str(error)))
        self.page.on("request", lambda request: self.requests.append(request.url))
        self.page.goto(file.as_uri() + hash_)

    def show(self, **state: Any) -> list[float]:
        return self.page.evaluate(
            "s => { symbalance.show(s); return Array.from(symbalance.now.values); }", state
        )

    def transform(self, view: str, part: str) -> tuple[complex, float]:
        text = self.page.get_attribute(f'#{view} [data-part="{part}"]', "transform")
        place, turn = text.removeprefix("translate(").split(") rotate(")
        x, y = map(float, place.split())
        return complex(-y, x), float(turn.split(")")[0])

    def fill(self, label: str, text: str) -> None:
        """Type into a field of the editor, by what it is called."""
        self.page.evaluate("document.getElementById('edit').open = true")
        self.page.get_by_label(label, exact=True).fill(text)

    def saved(self, file: Path) -> sb.Engine:
        """Return the engine that the page saves, read from the file that it offers."""
        self.page.evaluate("document.getElementById('edit').open = true")
        with self.page.expect_download() as offered:
            self.page.click("#save")
        offered.value.save_as(file)
        return sb.load(str(file))


def values_of(engine: sb.Engine, radians: float) -> list[float]:
    """Return the library's outputs of an engine at an angle."""
    result = sb.balance(engine)
    functions = (sb.to_function(result, outputs=(of,), tolerance=0.0) for of in OUTPUTS)
    return [float(f(radians)) for f in functions]
