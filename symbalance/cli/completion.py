"""`symbalance completion`: a script that lets a shell finish commands, options, presets and files."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from dataclasses import dataclass

from symbalance.cli.options import command
from symbalance.cli.output import write

SHELLS = ("bash", "zsh", "fish")
FILES = frozenset({"FILE", "FOLDER", "OUT", "NOTES", "ENGINE"})
"""What help calls an argument that is a file's name, or may be."""
PRESETS = frozenset({"ENGINE", "NAME"})
"""What help calls an argument that is a preset's name, where it speaks of a preset."""

_HEAD = "# Completion of symbalance for {shell}, made by: symbalance completion {shell}\n"
_BASH = """\
# For every new shell, in ~/.bashrc: source <(symbalance completion bash)
_symbalance() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}
    local command= values= options= files= name i
    for ((i = 1; i < COMP_CWORD; i++)); do
        if [[ ${COMP_WORDS[i]} != -* ]]; then command=${COMP_WORDS[i]}; break; fi
    done
CASES
    COMPREPLY=()
    if [[ $word == -* && -n $options ]]; then values=$options files=; fi
    while IFS= read -r name; do COMPREPLY+=("$name"); done < <(compgen -W "$values" -- "$word")
    if [[ -n $files ]]; then
        while IFS= read -r name; do COMPREPLY+=("$name"); done < <(compgen -f -- "$word")
    fi
}
complete -o filenames -F _symbalance symbalance
"""
_ZSH = """\
# For every new shell, in ~/.zshrc after compinit: source <(symbalance completion zsh)
_symbalance() {
    local word=${words[CURRENT]} before=${words[CURRENT-1]}
    local command= values= options= files= i
    for ((i = 2; i < CURRENT; i++)); do
        if [[ ${words[i]} != -* ]]; then command=${words[i]}; break; fi
    done
CASES
    if [[ $word == -* && -n $options ]]; then values=$options files=; fi
    compadd -- ${=values}
    if [[ -n $files ]]; then _files; fi
}
compdef _symbalance symbalance
"""


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    parser = command(
        commands, "completion", run, "A script for the shell, which then finishes what is typed."
    )
    parser.add_argument("shell", choices=SHELLS, help="the shell that is to load it")


def run(options: argparse.Namespace) -> int:
    """Print the script, from the parser and the presets as they are."""
    from symbalance.cli.parser import build_parser
    from symbalance.engine.catalogue import preset_names

    known = _commands(build_parser(), preset_names())
    write(_HEAD.format(shell=options.shell) + _WRITERS[options.shell](known), None, "source")
    return 0


@dataclass(frozen=True)
class _Argument:
    """What may follow: words to choose from, and whether it may be a file's name."""

    words: tuple[str, ...] = ()
    is_file: bool = False


@dataclass(frozen=True)
class _Command:
    """A command: its name, what it does, its options and the arguments of those that take one."""

    name: str
    does: str
    options: tuple[str, ...]
    valued: tuple[tuple[tuple[str, ...], _Argument], ...]
    positional: _Argument


def _commands(parser: argparse.ArgumentParser, presets: tuple[str, ...]) -> list[_Command]:
    """Return the commands that a parser takes."""
    (group,) = (a for a in parser._actions if isinstance(a, argparse._SubParsersAction))
    summaries = {action.dest: action.help or "" for action in group._choices_actions}
    return [_command(name, summaries[name], sub, presets) for name, sub in group.choices.items()]


def _command(name: str, does: str, parser: argparse.ArgumentParser, presets: tuple[str, ...]) -> _Command:
    options: list[str] = []
    valued: list[tuple[tuple[str, ...], _Argument]] = []
    positional = _Argument()
    for action in parser._actions:
        argument = _argument(action, presets)
        if not action.option_strings:
            positional = argument
            continue
        options += action.option_strings
        if action.nargs != 0:
            valued.append((tuple(action.option_strings), argument))
    return _Command(name, does, tuple(options), tuple(valued), positional)


def _argument(action: argparse.Action, presets: tuple[str, ...]) -> _Argument:
    called = str(action.metavar or action.dest)
    if action.choices is not None:
        return _Argument(tuple(map(str, action.choices)))
    takes_presets = called in PRESETS and "preset" in (action.help or "")
    return _Argument(presets if takes_presets else (), called in FILES)


def _bash(known: list[_Command]) -> str:
    return _BASH.replace("CASES", "\n".join(_cases(known)))


def _zsh(known: list[_Command]) -> str:
    return _ZSH.replace("CASES", "\n".join(_cases(known)))


def _cases(known: list[_Command]) -> Iterator[str]:
    """Yield the lines that say what may follow, alike in bash and zsh.

    No word here holds a sign that shells take for their own: a test says so.
    """
    yield "    case $command in"
    names = " ".join(one.name for one in known)
    yield f"    '') values='{names}' options='--help --version' ;;"
    for one in known:
        yield f"    {one.name})"
        yield "        case $before in"
        for options, argument in one.valued:
            yield f"        {'|'.join(options)}) {_assigned(argument)} ;;"
        yield f"        *) {_assigned(one.positional)}"
        yield f"            options='{' '.join(one.options)}' ;;"
        yield "        esac ;;"
    yield "    esac"


def _assigned(argument: _Argument) -> str:
    return f"values='{' '.join(argument.words)}' files={'yes' if argument.is_file else ''}"


def _fish(known: list[_Command]) -> str:
    lines = [
        "# For every new shell: symbalance completion fish > ~/.config/fish/completions/symbalance.fish"
    ]
    lines += ["complete -c symbalance -f"]
    for one in known:
        does = one.does.replace("\\", "\\\\").replace("'", "\\'")
        lines.append(f"complete -c symbalance -n __fish_use_subcommand -a {one.name} -d '{does}'")
    for one in known:
        head = f"complete -c symbalance -n '__fish_seen_subcommand_from {one.name}'"
        lines.append(f"{head}{_follows(one.positional)}")
        valued = {option: argument for options, argument in one.valued for option in options}
        for option in one.options:
            name = f" -l {option[2:]}" if option.startswith("--") else f" -s {option[1:]}"
            value = f" -r{_follows(valued[option])}" if option in valued else ""
            lines.append(head + name + value)
    return "\n".join(lines) + "\n"


def _follows(argument: _Argument) -> str:
    files = " -F" if argument.is_file else " -f"
    return files + (f" -a '{' '.join(argument.words)}'" if argument.words else "")


_WRITERS = {"bash": _bash, "zsh": _zsh, "fish": _fish}
