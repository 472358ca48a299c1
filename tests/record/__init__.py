"""The record: what every command prints, kept in a folder, and two such folders compared."""
