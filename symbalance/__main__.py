"""Runs the command line: `symbalance …` or `python -m symbalance …`."""

import sys


def main() -> None:
    """Run the command line and exit with its code."""
    try:
        from symbalance.cli import run
        from symbalance.cli.streams import prepare

        prepare()
        code = run(sys.argv[1:])
    except KeyboardInterrupt:
        code = 130
    sys.exit(code)


if __name__ == "__main__":
    main()
