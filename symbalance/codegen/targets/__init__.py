"""Source code in each target language: C, JavaScript, Octave, and Python for three array libraries."""

from __future__ import annotations

from symbalance.codegen.plans import Plan
from symbalance.codegen.targets.array_api import array_api_source
from symbalance.codegen.targets.c import c_sources
from symbalance.codegen.targets.header_text import identifier
from symbalance.codegen.targets.javascript import javascript_source
from symbalance.codegen.targets.numba_module import numba_source
from symbalance.codegen.targets.numpy_module import numpy_source
from symbalance.codegen.targets.octave import octave_source

__all__ = ["FILES", "IN_MEMORY", "files", "identifier"]

IN_MEMORY = ("numpy", "numba", "array-api")
FILES = {
    "numpy": (".py",),
    "numba": (".py",),
    "array-api": (".py",),
    "c": (".c",),
    "javascript": (".mjs", ".js"),
    "octave": (".m",),
}
"""Targets, and how the file that `emit` is told to write may end."""
MODULES = {"numpy": numpy_source, "numba": numba_source, "array-api": array_api_source}


def files(plan: Plan, target: str, engine: str, name: str, grid: bool = True) -> dict[str, str]:
    """Return a target's source files by their endings; `name` is what its functions are called.

    `grid` adds the function for evenly spaced angles.
    """
    if target == "c":
        return c_sources(plan, engine, name, grid)
    if target == "javascript":
        return {".mjs": javascript_source(plan, engine, grid)}
    if target == "octave":
        return {".m": octave_source(plan, engine, name, grid)}
    return {".py": MODULES[target](plan, engine, grid)}
