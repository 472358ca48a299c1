"""What must hold, filed by kind of evidence (a folder each), and the models that tests share."""

from pathlib import Path

TESTS = Path(__file__).parent
ROOT = TESTS.parent
