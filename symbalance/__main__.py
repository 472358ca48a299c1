"""Runs the command line: `symbalance …` or `python -m symbalance …`."""

import gc
import sys


def main() -> None:
    """Run the command line and exit with its code."""
    gc.set_threshold(20_000, 10, 10)  # formulas hold no cycles: looking for them often finds nothing
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
