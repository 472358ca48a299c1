"""The public face: names, commands, formats, schemas, pickling."""
