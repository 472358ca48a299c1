"""The atlas of engines: a page of each, a table of all that sorts by what shakes, and published tables.

A folder of HTML files that open from disk: nothing in them asks for a network.
"""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from hashlib import sha256
from html import escape
from typing import Any

from symbalance.drawing.charts import figure
from symbalance.drawing.firing_diagram import NEAR, firing_intervals
from symbalance.engine.engine import Engine
from symbalance.forces.free_forces import NEGLIGIBLE, Balance, balance
from symbalance.pages.moving_page import page
from symbalance.pages.published_tables import PublishedCell, cells_by_engine
from symbalance.pages.sentence import sizes_of_orders

MOST_NAMED = 6
"""Uneven firing intervals that are written out in the table."""

COLUMNS = (
    ("engine", "engine"),
    ("cylinders", "cylinders"),
    ("first order of force", "lowestForce"),
    ("largest force", "force"),
    ("first order of couple", "lowestCouple"),
    ("largest couple", "couple"),
    ("firing intervals", "intervals"),
)
PUBLISHED = "published"
"""Where on the page the published tables stand."""
PUBLISHED_HEADS = ("engine", "quantity", "as printed", "right", "off by", "why", "where")
_STYLE = """
:root{color-scheme:light dark;--ink:#1f2937;--paper:#fff;--quiet:#4b5563;--line:#d1d5db;--link:#1d4ed8}
@media screen and (prefers-color-scheme:dark){
:root{--ink:#e5e7eb;--paper:#111827;--quiet:#9ca3af;--line:#4b5563;--link:#7db2ff}}
body{margin:0;background:var(--paper);color:var(--ink);font:16px/1.45 system-ui,sans-serif}
main{max-width:80rem;margin:0 auto;padding:.8rem}
a{color:var(--link)}
.wide{overflow-x:auto}
table{border-collapse:collapse;width:100%}
th,td{text-align:left;padding:.25rem .9rem .25rem 0;vertical-align:top}
tr{border-bottom:1px solid var(--line)}
tbody th{font-weight:normal;white-space:nowrap}
th button{font:inherit;font-weight:bold;color:var(--ink);background:none;border:0;padding:0}
th button{cursor:pointer;text-align:left}
th[aria-sort=ascending] button::after{content:" ▲"}
th[aria-sort=descending] button::after{content:" ▼"}
td{font-variant-numeric:tabular-nums}
details{margin:.6rem 0}
.quiet{color:var(--quiet);font-size:.85rem}
@media print{@page{size:A4 landscape;margin:10mm}body{font-size:8pt}}
"""
_SCRIPT = """
for (const table of document.querySelectorAll("table")) {
const body = table.tBodies[0], heads = [...table.tHead.rows[0].cells];
heads.forEach((head, column) => {
  const button = document.createElement("button");
  button.type = "button";
  button.textContent = head.textContent;
  head.replaceChildren(button);
  button.addEventListener("click", () => {
    const down = head.getAttribute("aria-sort") === "ascending";
    const key = (row) => row.children[column].dataset.key ?? row.children[column].textContent;
    const order = (a, b) => {
      const x = key(a), y = key(b), n = Number(x) - Number(y);
      return Number.isNaN(n) ? x.localeCompare(y) : n;
    };
    const rows = [...body.rows].sort((a, b) => (down ? order(b, a) : order(a, b)));
    heads.forEach((each) => each.removeAttribute("aria-sort"));
    head.setAttribute("aria-sort", down ? "descending" : "ascending");
    body.append(...rows);
  });
});
}
"""
_PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; \
script-src 'sha256-{digest}'">
<title>Atlas of engines</title>
<style>{style}</style>
</head>
<body>
<main>
<h1>Atlas of engines</h1>
<p>{count}: which orders are free, and how much. A head sorts the table; a name opens the engine.
Sizes are over one piston's first order, of couples also over the pitch. None: every order to {order}
cancels exactly or is below 10⁻⁶.</p>
<section class="wide" tabindex="0" aria-label="Engines by what shakes">
<table>
<thead><tr>{heads}</tr></thead>
<tbody>
{rows}
</tbody>
</table>
</section>
{published}{refused}<p class="quiet">Made by symbalance {version}. Nothing here is fetched.</p>
</main>
<script type="module">{script}</script>
</body>
</html>
"""


@dataclass(frozen=True)
class Entry:
    """An engine in the atlas: its page, and its row of the table as texts and keys to sort by."""

    html: str
    row: dict[str, Any]


def atlas_entry(engine: Engine, order: int = 12) -> Entry:
    """Return an engine's page and its row of the table."""
    result = balance(engine, order)
    return Entry(page(result).html, _row(result))


def _row(result: Balance) -> dict[str, Any]:
    """Return a row: a text and a key to sort by for each column.

    >>> from symbalance.engine.catalogue import load
    >>> row = _row(balance(load("v8-90")))
    >>> row["lowestForce"], row["couple"][0], row["intervals"][0]
    (['4', 4], '3.162 (order 1)', 'every 90°')
    """
    engine = result.engine
    row: dict[str, Any] = {
        "engine": [engine.name, engine.name],
        "cylinders": [str(len(engine.cylinders)), len(engine.cylinders)],
    }
    for of, lowest in (("force", "lowestForce"), ("couple", "lowestCouple")):
        sizes = {n: s for n, s in sizes_of_orders(result, of).items() if s >= NEGLIGIBLE}
        if not sizes:
            row[lowest], row[of] = ["none", result.highest + 1], ["0", 0.0]
            continue
        least, largest = min(sizes), max(sizes, key=lambda n: sizes[n])
        row[lowest] = [str(least), least]
        row[of] = [f"{figure(sizes[largest])} (order {largest})", sizes[largest]]
    row["intervals"] = _intervals(engine)
    return row


def _intervals(engine: Engine) -> list[Any]:
    """Return an engine's firing intervals in words, and how far they differ."""
    if any(c.fires is None for c in engine.cylinders):
        return ["not known", 1e9]
    steps = [step for _, _, step in firing_intervals(engine)]
    uneven = float(max(steps) - min(steps))
    if uneven <= 2 * NEAR:
        return [f"every {_degrees(sum(steps, Fraction(0)) / len(steps))}°", uneven]
    named = "-".join(map(_degrees, steps[:MOST_NAMED])) + ("-…" if len(steps) > MOST_NAMED else "")
    return [f"uneven: {named}°", uneven]


def _degrees(value: Fraction) -> str:
    return f"{float(round(value, 2)):g}"


def atlas_index(
    entries: Sequence[tuple[str, dict[str, Any]]],
    refused: Sequence[str],
    order: int,
    cells: Sequence[PublishedCell] = (),
) -> str:
    """Return the table of an atlas as a page, of rows each with its page's file name.

    Below it stand `cells` of published tables, those that are wrong beside what is right. What was
    `refused` is said at the end, so that nobody takes it for forgotten.
    """
    from symbalance import __version__

    rows = []
    wrong = cells_by_engine(cells)
    for file, row in entries:
        name = row["engine"][0]
        here = f' <a href="#{PUBLISHED}" class="quiet">misprints</a>' if name in wrong else ""
        parts = [f'<th scope="row"><a href="{escape(file)}">{escape(name)}</a>{here}</th>']
        parts += [
            f'<td data-key="{escape(str(row[key][1]))}">{escape(str(row[key][0]))}</td>'
            for _, key in COLUMNS[1:]
        ]
        rows.append(f"<tr>{''.join(parts)}</tr>")
    missing = "".join(f"<li>{escape(line)}</li>" for line in refused)
    return _PAGE.format(
        digest=b64encode(sha256(_SCRIPT.encode()).digest()).decode("ascii"),
        style=_STYLE,
        count=f"{len(entries)} engine{'' if len(entries) == 1 else 's'}",
        order=order,
        heads="".join(f'<th scope="col">{escape(head)}</th>' for head, _ in COLUMNS),
        rows="\n".join(rows),
        published=_published(cells, {row["engine"][0]: file for file, row in entries}),
        refused=f"<h2>Not shown</h2>\n<ul>{missing}</ul>\n" if missing else "",
        version=__version__,
        script=_SCRIPT,
    )


def _published(cells: Sequence[PublishedCell], files: Mapping[str, str]) -> str:
    """Return the cells of published tables that are wrong as a table, and how many hold."""
    if not cells:
        return ""
    rows = [_published_row(cell, files) for cell in cells if not cell.holds]
    held = sum(cell.holds for cell in cells)
    sources = "".join(
        f"<li>{escape(title)}: {escape(source)}</li>"
        for title, source in dict.fromkeys((cell.table, cell.source) for cell in cells)
    )
    heads = "".join(f'<th scope="col">{escape(head)}</th>' for head in PUBLISHED_HEADS)
    return f"""<h2 id="{PUBLISHED}">Published tables, and what is right</h2>
<p>Of {len(cells)} cells that were compared {held} are right to their last digit; {len(rows)} are not.
Sizes are in F<sub>n</sub> = A<sub>n</sub> m r ω², couples times the pitch.</p>
<section class="wide" tabindex="0" aria-label="Cells of published tables that are wrong">
<table>
<thead><tr>{heads}</tr></thead>
<tbody>
{chr(10).join(rows)}
</tbody>
</table>
</section>
<details><summary>Where the tables stand</summary><ul>{sources}</ul></details>
"""


def _published_row(cell: PublishedCell, files: Mapping[str, str]) -> str:
    name, file = escape(cell.engine), files.get(cell.engine)
    engine = f'<a href="{escape(file)}">{name}</a>' if file else name
    off = cell.off
    said = "should be 0" if off is None else f"{100 * off:.3g} %"
    where = cell.table + (f", line {cell.line}" if cell.line else "")
    cells = (
        (cell.quantity, None),
        (cell.printed, None),
        (cell.right_text, cell.right),
        (said, 1e9 if off is None else off),
        (cell.why, None),
        (where, None),
    )
    texts = "".join(f"<td{_key(key)}>{escape(text)}</td>" for text, key in cells)
    return f'<tr><th scope="row">{engine}</th>{texts}</tr>'


def _key(value: float | None) -> str:
    """Return the attribute that a cell is sorted by, where that is not its text."""
    return "" if value is None else f' data-key="{value!r}"'
