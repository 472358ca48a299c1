"""`symbalance engines`: the presets."""

from __future__ import annotations

import argparse

from symbalance.cli.output import show, write
from symbalance.errors import SymbalanceError


def run(options: argparse.Namespace) -> int:
    """List the presets, or print one's engine file, or the schema of all engine files."""
    from symbalance.engine.catalogue import preset_text, presets

    if options.show is None and not options.schema:
        show(presets(), options)
        return 0
    for name in ("format", "standalone"):
        if getattr(options, name):
            other = "--schema" if options.schema else "--show"
            raise SymbalanceError(f"--{name}", f"plays no part in {other}", "leave it out")
    if options.show is not None:
        write(preset_text(options.show), options.output, "source")
        return 0
    from symbalance.engine.engine_file import schema_text

    write(schema_text(), options.output, "json")
    return 0
