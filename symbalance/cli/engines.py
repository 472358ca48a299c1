"""`symbalance engines`: the presets."""

from __future__ import annotations

import argparse
from textwrap import wrap

from symbalance.cli.output import write


def run(options: argparse.Namespace) -> int:
    """List the presets, or print one's engine file, or the schema of all engine files."""
    from symbalance.engine.catalogue import preset_text, presets

    if options.schema:
        from symbalance.engine.engine_file import schema_text

        write(schema_text(), None, "json")
        return 0
    if options.show is not None:
        write(preset_text(options.show), None, "source")
        return 0
    found = presets()
    width = max(len(p.name) for p in found)
    lines = []
    for preset in found:
        about = wrap(preset.description, 77 - width) + wrap(f"[{preset.source}]", 77 - width)
        lines.append(f"{preset.name:<{width}}  {about[0]}")
        lines += [" " * (width + 2) + line for line in about[1:]]
    write("\n".join(lines) + "\n", None)
    return 0
