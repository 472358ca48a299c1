"""Checking of hand derivations against this library's presets and engine files."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from symbalance.budgets import Budget
from symbalance.document.formula import Derivative, Equation, Matrix, Name, equal
from symbalance.errors import SymbalanceError
from symbalance.notes.checking import documents
from symbalance.notes.checking.deciding.guarded_verdicts import PAGE
from symbalance.notes.checking.declared.engines import KnownEngine
from symbalance.notes.checking.verdicts import Checked
from symbalance.text import lazy_patterns as re
from symbalance.text.files import STANDARD_INPUT
from symbalance.text.named_paths import NamingFolder

if TYPE_CHECKING:
    from symbalance.notes.checking.declared.declaration_draft import DeclarationDraft

VALUE_DIGITS = 30
_COUNTS = {
    "two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "eight": 8, "zwei": 2, "drei": 3, "vier": 4,
    "fünf": 5, "sechs": 6, "acht": 8, "二": 2, "三": 3, "四": 4, "五": 5, "六": 6, "八": 8, "twin": 2,
}  # fmt: skip
_COUNT = "|".join(("[0-9]{1,2}", *_COUNTS))
_INLINE = re.compile(
    rf"(?:in-?line|straight)[- ]?({_COUNT})\b|Reihen-?({_COUNT})(?:-?zylinder|(?![\w-]))"
    rf"|直列\s*({_COUNT})\s*(?:気筒|シリンダ)"
    rf"|(?<![\w-])({_COUNT})[- ]?(?:cylinders?|throw)[- ](?:in-?line|straight)(?![A-Za-z])"
    rf"|(?<![\w-])({_COUNT})-?zylinder-?(?:reihenmotor|in\s+Reihe)"
    rf"|flat-?(?:plane)?[- ]?crank[- ]({_COUNT})\b"
    rf"|in-?line\s+engine\s+with\s+({_COUNT})\s+cylinders|Reihenmotor\s+mit\s+({_COUNT})\s+Zylindern"
    rf"|(?<![\w])({_COUNT})\s*気筒\s*直列",
    re.IGNORECASE,
)
_BOXER = re.compile(
    rf"boxer[- ]({_COUNT})\b|(?<![\w-])flat[- ]({_COUNT})\b|({_COUNT})-?zylinder-?boxer"
    rf"|水平対向\s*({_COUNT})\s*気筒",
    re.IGNORECASE,
)
_VEE = re.compile(r"\bV-?([0-9]{1,2})(?![0-9])|V\s*型\s*([0-9]{1,2})\s*気筒")
_BANK_ANGLE = re.compile(r"([0-9]{2,3})\s*(?:°|度|degrees?|-degree)")
_NEAR = 400
"""Characters around the name of a vee engine in which its bank angle is looked for."""


@dataclass(frozen=True)
class LibraryEngines:
    """Knowledge of engines for the checker: presets, engine files, a slider-crank's harmonics.

    With `trust_paths` a document may name engine files outside its folder.
    """

    trust_paths: bool = False

    def engine(self, name: str, folder: Path) -> KnownEngine:
        """Return a preset, or the engine of a file: one in `folder` or, if trusted, where it is named."""
        from symbalance.engine.catalogue import is_engine_file, load  # a page may name no engine

        is_preset = not is_engine_file(name) and name != STANDARD_INPUT
        # A cached property is no property to a type checker, and an engine has them.
        return cast(KnownEngine, load(name if is_preset else self._file(name, folder)))

    def _file(self, name: str, folder: Path) -> Path:
        path = NamingFolder(folder, self.trust_paths).file(name)
        return Path(name) if self.trust_paths and not path.exists() else path

    def coefficient_terms(self, order: int, power: int) -> Mapping[int, Fraction]:
        """Return A_order as power of r/l -> coefficient, through a power; empty if it is 0.

        >>> LibraryEngines().coefficient_terms(2, 3)
        {1: Fraction(1, 1), 3: Fraction(1, 4)}
        """
        from symbalance.kinematics.slider_crank import acceleration_series, surviving

        return acceleration_series(order, power).terms if surviving(order) else {}

    def mentions(self, text: str) -> Sequence[tuple[int, str]]:
        """Return the presets that a text speaks of: by name, or by how many cylinders stand how.

        >>> LibraryEngines().mentions("the VQ30DE; V型12気筒、バンク角は60度")
        [(4, 'vq30de'), (12, 'v12-60')]
        """
        from symbalance.engine.catalogue import preset_names

        known = frozenset(preset_names())
        return sorted((*_by_name(text, known), *_by_arrangement(text, known)))

    def coefficient_value(self, order: int, ratio: Fraction) -> Fraction:
        """Return A_order at a rod ratio, to 30 digits."""
        from symbalance.kinematics.slider_crank import acceleration_value
        from symbalance.text.reals import nstr

        return Fraction(nstr(acceleration_value(order, ratio, VALUE_DIGITS), VALUE_DIGITS))

    def equation(self, name: str) -> Equation:
        """Return the equation of motion of a node of the turning crankshaft, of the principal one.

        Its letters are those of `symbalance derive --quantity crank-node`, with F_u to N_w for the force.
        """
        if name != "crank-node":
            raise SymbalanceError(f"quantity = {name}", "is no known equation", "write crank-node")
        from symbalance.crankshaft.equations.node import node_equations
        from symbalance.document.expressions import formula_of

        node = node_equations().principal()
        letters = ("u", "v", "w", "theta_u", "theta_v", "theta_w")
        time, omega = Name("t"), Name("omega")

        def column(order: int) -> Matrix:
            rows = [Derivative(Name(q), time, order) if order else Name(q) for q in letters]
            return Matrix(tuple((row,) for row in rows))

        mass, gyroscopic, centrifugal, outward = map(
            formula_of, (node.mass, node.gyroscopic, node.centrifugal, node.centrifugal_force)
        )
        force = Matrix(tuple((Name(f"{kind}_{axis}"),) for kind in "FN" for axis in "uvw"))
        left = mass * column(2) + omega * gyroscopic * column(1) + omega**2 * centrifugal * column(0)
        return equal(left, force + omega**2 * outward)


def check(
    document: str | Path,
    symbols: Mapping[str, Any] | str | Path | None = None,
    *,
    budget: Budget = PAGE,
    trust_paths: bool = False,
    accept_proposals: bool = False,
    fixes: bool = True,
) -> Checked:
    """Return the verdicts on every equation of a hand derivation.

    `document` is a file (a Path, or a text that ends in .tex, .md or .txt, or `-` for standard input) or
    the derivation itself.
    `symbols` maps letters to their meaning or unit, or is a whole sidecar (keys `symbols`, `scope`,
    `bind`), or the path of one; without it NAME.symbols.toml beside the file is read, or the header of
    the document. Lines are bound to this library's presets and engine files; those that a document or
    its sidecar names must lie in its folder or below, unless its reader says `trust_paths`.
    `accept_proposals` takes what a symbols file proposes, or the document's own words do where there is
    none, as if somebody had confirmed it; the report says so at its head.
    `fixes` searches a refuted line for the smallest change that makes it true, and takes time.
    `budget` is what the document may take, in seconds and MB (`symbalance.budgets.Budget`); each relation
    may take a 60th of that time and a quarter of the memory, and is "undecided" where it takes more.

        >>> checked = check("$$\\\\sin^2 x = \\\\frac{1 - \\\\cos 2x}{3}$$", {"x": "angle"})
        >>> checked.verdicts[0].verdict, checked.verdicts[0].fix.text
        ('refuted', '(1 - cos 2x)/2')

    Raises SymbalanceError for a file or a declaration that cannot be used; an equation that cannot be
    read is a verdict, not an error.
    """
    # What a caller's own mapping names is the caller's word, not that of a file.
    trusted = trust_paths or isinstance(symbols, Mapping)
    engines = LibraryEngines(trusted)
    return documents.check(
        document,
        symbols,
        engines=engines,
        budget=budget,
        accept_proposals=accept_proposals,
        fixes=fixes,
    )


def sidecar_draft(
    document: str | Path,
    symbols: Mapping[str, Any] | str | Path | None = None,
    *,
    budget: Budget = PAGE,
) -> DeclarationDraft:
    """Return a draft of a document's symbols file; what its words propose stands in it, unconfirmed."""
    return documents.sidecar_draft(document, symbols, engines=LibraryEngines(), budget=budget)


# Engines that a text speaks of


def _by_name(text: str, known: frozenset[str]) -> Iterator[tuple[int, str]]:
    """Yield the presets that a text names, whatever its capitals."""
    names = "|".join(re.escape(name) for name in sorted(known, key=len, reverse=True))
    for match in re.finditer(rf"(?<![A-Za-z0-9-])(?:{names})(?![A-Za-z0-9-])", text, re.IGNORECASE):
        yield match.start(), match[0].lower()


def _by_arrangement(text: str, known: frozenset[str]) -> Iterator[tuple[int, str]]:
    """Yield the plain presets of the arrangements that a text names: "V12" with its angle near it."""
    for kind, pattern in (("inline", _INLINE), ("boxer", _BOXER)):
        for match in pattern.finditer(text):
            name = f"{kind}-{_count(next(group for group in match.groups() if group))}"
            if name in known:
                yield match.start(), name
    for match in _VEE.finditer(text):
        around = text[max(0, match.start() - 40) : match.end() + _NEAR]
        angles = {f"v{match[1] or match[2]}-{angle}" for angle in _BANK_ANGLE.findall(around)} & known
        if len(angles) == 1:
            yield match.start(), next(iter(angles))


def _count(word: str) -> int:
    return _COUNTS[word.casefold()] if word.casefold() in _COUNTS else int(word)
