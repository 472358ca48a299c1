"""Checking of hand derivations against this library's presets and engine files."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any, cast

from symbalance.budgets import Budget
from symbalance.document.formula import Derivative, Equation, Matrix, Name, equal
from symbalance.engine.catalogue import is_engine_file, load
from symbalance.errors import SymbalanceError
from symbalance.kinematics.slider_crank import acceleration_series, acceleration_value, surviving
from symbalance.notes.checking import documents
from symbalance.notes.checking.engines import KnownEngine
from symbalance.notes.checking.judging import PAGE
from symbalance.notes.checking.verdicts import Checked
from symbalance.text.files import STANDARD_INPUT
from symbalance.text.named_paths import NamingFolder
from symbalance.text.reals import nstr

VALUE_DIGITS = 30


@dataclass(frozen=True)
class LibraryEngines:
    """Knowledge of engines for the checker: presets, engine files, a slider-crank's harmonics.

    With `trust_paths` a document may name engine files outside its folder.
    """

    trust_paths: bool = False

    def engine(self, name: str, folder: Path) -> KnownEngine:
        """Return a preset, or the engine of a file: one in `folder` or, if trusted, where it is named."""
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
        return acceleration_series(order, power).terms if surviving(order) else {}

    def coefficient_value(self, order: int, ratio: Fraction) -> Fraction:
        """Return A_order at a rod ratio, to 30 digits."""
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
) -> Checked:
    """Return the verdicts on every equation of a hand derivation.

    `document` is a file (a Path, or a text that ends in .tex, .md or .txt, or `-` for standard input) or
    the derivation itself.
    `symbols` maps letters to their meaning or unit, or is a whole sidecar (keys `symbols`, `scope`,
    `bind`), or the path of one; without it NAME.symbols.toml beside the file is read, or the header of
    the document. Lines are bound to this library's presets and engine files; those that a document or
    its sidecar names must lie in its folder or below, unless its reader says `trust_paths`.
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
    return documents.check(document, symbols, engines=LibraryEngines(trusted), budget=budget)
