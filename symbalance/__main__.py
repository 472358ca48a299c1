"""Runs the command line: `symbalance …` or `python -m symbalance …`."""

import sys

from symbalance.cli import run


def main() -> None:
    """Run the command line and exit with its code."""
    sys.exit(run(sys.argv[1:]))


if __name__ == "__main__":
    main()
