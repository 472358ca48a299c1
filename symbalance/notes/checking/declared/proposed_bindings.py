"""What lines below a heading such as "6次慣性力" are proposed to claim, for the engine named last."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from symbalance.document.formula import Call, Formula, Name, Number, Product, names, walk
from symbalance.notes.checking.declared.engines import Engines
from symbalance.notes.checking.declared.page_headings import is_heading, order_in
from symbalance.notes.checking.declared.proposed_meanings import Proposal
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

_COUPLE = re.compile(r"偶力|モーメント|couple|moment", re.IGNORECASE)
_FORCE = re.compile(r"慣性力|force|kraft|kräfte", re.IGNORECASE)
_LEFT_BANK = re.compile(r"左バンク|left bank|linke Bank|linke Zylinderreihe", re.IGNORECASE)
_RIGHT_BANK = re.compile(r"右バンク|right bank|rechte Bank|rechte Zylinderreihe", re.IGNORECASE)
_BOTH = re.compile(r"左右|both banks|beide", re.IGNORECASE)
_UP = re.compile(r"鉛直|垂直|vertical|senkrecht|vertikal", re.IGNORECASE)
_ACROSS = re.compile(r"水平|horizontal|lateral|waagerecht|waagrecht", re.IGNORECASE)
_ALONG = re.compile(r"ストローク方向|along the (?:stroke|axis|bank)|in Zylinderrichtung", re.IGNORECASE)
_HARMONIC = re.compile(r"\\?(?:cos|sin)\s*([0-9]{0,2})\s*(?:\\theta|\\varphi|\\phi|θ|φ|ϕ)")
_SHARE = re.compile(r"100\s*(?:とする|とすると|%)|as 100|taken as 100|gleich 100|=\s*100")


@dataclass(frozen=True, slots=True)
class BindProposal:
    """What a line is proposed to claim: the keys of [[bind]], and the words it is taken from."""

    keys: Mapping[str, str | int]
    words: str


class BindingsFromHeadings:
    """Goes down a page and binds what stands below a heading that names an order."""

    def __init__(self, lines: Sequence[str], page: ReadNotes, engines: Engines) -> None:
        self.lines, self.page = lines, page
        self.engines = sorted(engines.mentions("\n".join(lines)))
        self.offsets = [0]
        for line in lines:
            self.offsets.append(self.offsets[-1] + len(line) + 1)
        self.heads = [n for n in range(1, len(lines) + 1) if is_heading(lines, n)]
        self.subjects = {
            head: name for place, name in self.engines if (head := self._line_of(place)) in self.heads
        }
        self.order: int | None = None
        self.quantity, self.bank, self.direction, self.head, self.begun = "", 0, "", "", 0

    def bindings(self, meanings: Mapping[str, Proposal]) -> Iterator[BindProposal]:
        """Yield what the lines below headings are proposed to claim."""
        chains = {chain.lines[0]: chain for chain in self.page.chains if not chain.inline}
        shares = any(_SHARE.search(line) for line in self.lines)
        for number, line in enumerate(self.lines, 1):
            if shares and (share := self._share(line, number)):
                yield share
            elif is_heading(self.lines, number):
                self._enter(line, number)
            elif self.order is not None and number in chains:
                yield from self._of_chain(chains[number], meanings)
            elif self.order is not None and number <= self.begun + 2:
                yield from self._harmonic(line, number)

    def _engine_at(self, number: int) -> str:
        """Return the engine named last before a line."""
        offset = self.offsets[number]
        return next((name for place, name in reversed(self.engines) if place < offset), "")

    def _subject(self, number: int) -> str:
        """Return the engine that the headings above a line are about; the one named last if none is."""
        above = [head for head in self.subjects if head <= number]
        return self.subjects[max(above)] if above else self._engine_at(number)

    def _line_of(self, offset: int) -> int:
        return bisect_right(self.offsets, offset)

    def _enter(self, heading: str, number: int) -> None:
        """Take up what a heading says; one that names an order begins anew."""
        order = order_in(heading)
        if order is not None:
            self.order, self.bank, self.direction = order, 0, ""
            self.quantity = (
                "couple" if _COUPLE.search(heading) else "force" if _FORCE.search(heading) else ""
            )
            self.head, self.begun = heading.strip(), number
        if _BOTH.search(heading):
            self.bank, self.direction = 0, ""
        elif _LEFT_BANK.search(heading) or _RIGHT_BANK.search(heading):
            self.bank, self.direction = 1 if _LEFT_BANK.search(heading) else 2, "along"
        for pattern, direction in ((_UP, "vertical"), (_ACROSS, "lateral"), (_ALONG, "along")):
            if pattern.search(heading):
                self.direction = direction

    def _harmonic(self, line: str, number: int) -> Iterator[BindProposal]:
        """Yield the binding of "cos 2θ" in the sentence right below a heading of order 2."""
        match = _HARMONIC.search(line)
        if match and self.quantity and self.order and not any(sign in line for sign in "=≈"):
            keys = {"line": number, "text": match[0], "quantity": "harmonic", "order": self.order}
            yield BindProposal(keys, self.head)

    def _share(self, line: str, number: int) -> BindProposal | None:
        """Return the binding of a row "2次慣性力 12.46" of a list whose first order is 100."""
        match = re.fullmatch(r"\s*(\S.*?)[\s:：]+([0-9]+\.[0-9]+)\s*%?\s*", line)
        order, engine = order_in(match[1]) if match else None, self._engine_at(number)
        if match is None or order is None or order < 2 or not engine or not _FORCE.search(match[1]):
            return None
        sign = (
            "-" if order % 4 == 0 else ""
        )  # the amplitude of A_n cos nθ is listed; A_4, A_8, … are negative
        keys = {
            "line": number, "text": match[2], "quantity": "coefficient", "order": order, "engine": engine,
            "scale": f"{sign}100",
        }  # fmt: skip
        return BindProposal(keys, f"{line.strip()} ({engine})")

    def _of_chain(self, chain: Chain, meanings: Mapping[str, Proposal]) -> Iterator[BindProposal]:
        """Yield the bindings of a chain's first and last side that hold the order's harmonic."""
        engine, order = self._subject(chain.lines[0]), self.order
        direction = f".{self.direction}" if self.direction in ("vertical", "lateral") else ""
        if (
            not engine
            or not self.quantity
            or order is None
            or not (direction or self.direction == "along")
        ):
            return
        sides = [s for s in chain.sides if _holds_order(s.node, order)]
        lines = {self.page.line_of(side.span[0]): side.node for side in (*sides[:1], *sides[-1:])}
        for line, node in lines.items():
            in_units = {p.meaning for name in names(node) if (p := meanings.get(name))}
            is_force = bool(in_units & {"reciprocating mass", "angular speed"})
            keys: dict[str, str | int] = {
                "line": line, "quantity": f"{self.quantity}{direction}", "engine": engine, "order": order,
            }  # fmt: skip
            keys |= {"bank": self.bank} if self.bank else {}
            keys |= {} if is_force else {"unit": "F_n"}
            yield BindProposal(keys, self.head)


def _holds_order(node: Formula, order: int) -> bool:
    """Tell whether a formula holds a cosine or sine of `order` times a letter."""

    def is_multiple(part: Formula) -> bool:
        if isinstance(part, Product):
            numbers = [p for p in part.factors if isinstance(p, Number)]
            letters = [p for p in part.factors if isinstance(p, Name)]
            return any(n.value == order for n in numbers) and bool(letters)
        return order == 1 and isinstance(part, Name)

    calls = [part for part in walk(node) if isinstance(part, Call) and part.function in ("cos", "sin")]
    return any(is_multiple(inner) for call in calls for inner in walk(call.argument))
