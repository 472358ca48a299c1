"""The command line's reference, made from the parser itself: a page of all commands and one for each."""

from __future__ import annotations

import argparse
import os
import re
from pathlib import Path

_COLUMNS = "88"


def pages(root: Path) -> dict[str, bytes]:
    """Return a page for each command and the page that lists them, as Markdown."""
    from symbalance.cli.parser import build_parser

    # argparse fits the usage line to the terminal, and colours it from Python 3.14 on.
    os.environ |= {"COLUMNS": _COLUMNS, "NO_COLOR": "1"}
    parser = build_parser()
    commands = next(a for a in parser._actions if isinstance(a, argparse._SubParsersAction))
    helps = {action.dest: action.help or "" for action in commands._choices_actions}
    contents = {f"{name}.md": _page(sub) for name, sub in commands.choices.items()}
    rows = "".join(f"| [{name}]({name}.md) | {_cell(helps[name])} |\n" for name in commands.choices)
    toctree = "\n".join(commands.choices)
    general = (root / "docs" / "command-line.md").read_text(encoding="utf-8").replace("](", "](../")
    contents["index.md"] = (
        f"# Commands\n\n{_text(parser.description or '')}\n\n```text\n{_usage(parser)}\n```\n\n"
        f"| command | what it does |\n|---|---|\n{rows}\n{_options(parser)}"
        f"{general}\n```{{toctree}}\n:hidden:\n\n{toctree}\n```\n"
    )
    return {name: text.encode() for name, text in contents.items()}


def _page(parser: argparse.ArgumentParser) -> str:
    usage = _usage(parser)
    title = parser.prog.removeprefix("symbalance ")
    page = (
        f"# {title}\n\n{_text(parser.description or '')}\n\n```text\n{usage}\n```\n\n{_options(parser)}"
    )
    return page + (f"{_text(parser.epilog)}\n" if parser.epilog else "")


def _usage(parser: argparse.ArgumentParser) -> str:
    return parser.format_usage().removeprefix("usage: ").rstrip()


def _options(parser: argparse.ArgumentParser) -> str:
    """Return a table for each group of arguments that has any but --help."""
    page = ""
    for group in parser._action_groups:
        actions = [a for a in group._group_actions if not isinstance(a, argparse._HelpAction)]
        actions = [a for a in actions if not isinstance(a, argparse._SubParsersAction)]
        if not actions:
            continue
        title = {"positional arguments": "Arguments", "options": "Options"}.get(
            group.title or "", group.title
        )
        rows = "".join(
            f"| {_head(parser, action)} | {_meaning(parser, action)} |\n" for action in actions
        )
        page += f"## {title}\n\n| | |\n|---|---|\n{rows}\n"
    return page


def _head(parser: argparse.ArgumentParser, action: argparse.Action) -> str:
    formatter = parser._get_formatter()
    value = ""
    if action.nargs != 0:
        default = action.dest.upper() if action.option_strings else action.dest
        value = (
            formatter._format_args(action, default).replace("{", "").replace("}", "").replace(",", ", ")
        )
    if not action.option_strings:
        return f"`{_bars(value)}`"
    flags = ", ".join(f"`{_bars(flag)}`" for flag in action.option_strings)
    values = value if action.choices is None else "|".join(map(str, action.choices))
    return f"{flags} `{_bars(values)}`" if value else flags


def _meaning(parser: argparse.ArgumentParser, action: argparse.Action) -> str:
    words = parser._get_formatter()._expand_help(action) if action.help else ""
    repeated = "; may be given more than once" if isinstance(action, argparse._AppendAction) else ""
    required = "; required" if action.required and action.option_strings else ""
    return _cell(words + repeated + required)


def _text(words: str) -> str:
    """Return help text as Markdown that means what it says."""
    words = re.sub(r"([\\`*_\[\]<>$#])", r"\\\1", words)
    return re.sub(r"(?<![\w-])(--[a-z][a-z-]*|symbalance [a-z]+[a-z0-9 -]*)", r"`\1`", words)


def _cell(words: str) -> str:
    return _bars(_text(" ".join(words.split())))


def _bars(words: str) -> str:
    return words.replace("|", "\\|")
