"""What an engine file may hold, for people and for editors: a reference in Markdown and a JSON Schema.

Both are made from the tables of keys that the reader reads by. ENGINE_FILES.md and the package hold them
as text, so that nothing is made when they are wanted.
"""

from __future__ import annotations

import json

from symbalance.crankshaft.files.crank_keys import FILE_KEYS
from symbalance.text.key_tables import json_schema

ABOUT = (
    'A number may be written as text, so that it is exact: "360/7". Lengths are in mm, masses in kg, '
    "angles in degrees, speeds in rpm, pressures in bar."
)


def schema_of_engine_files() -> str:
    """Return the JSON Schema (draft 2020-12) of an engine file.

    It says which keys there are, what their values are and which go together; what depends on several
    tables (a firing order and its cylinders, a rod and its stroke) is left to the reader.
    """
    schema = json_schema(FILE_KEYS, "urn:symbalance:engine-file", "symbalance engine file", ABOUT)
    return json.dumps(schema, indent=1, ensure_ascii=False) + "\n"


def reference_of_keys() -> str:
    """Return the reference of all keys of an engine file, in Markdown."""
    return "\n".join(FILE_KEYS.reference()).rstrip() + "\n"
