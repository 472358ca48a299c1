"""Sixty turns a minute are one a second: N = 60 f in rpm, and never f/60."""

import pytest

from symbalance.checking import check


def verdict_of(formula: str, symbols: dict[str, str], tmp_path) -> str:
    page = tmp_path / "page.md"
    page.write_text(f"${formula}$\n")
    rows = "\n".join(f'"{name}" = "{text}"' for name, text in symbols.items())
    (tmp_path / "page.symbols.toml").write_text(f"[symbols]\n{rows}\n")
    return check(page).data()["links"][-1]["verdict"]


SYMBOLS = {"N": "speed of the shaft [rpm]", "f": "frequency of rotation [Hz]"}


@pytest.mark.parametrize(
    ("formula", "is_refuted"),
    [
        ("N = 60 f", False),
        ("N = f/60", True),
        (r"N = \frac{1}{60} f", True),
        ("f = N/60", False),
        (r"f = \frac{N}{60}", False),
        ("f = 60 N", True),
        ("N = f", False),
        ("f = N/30", False),
    ],
)
def test_turns_a_minute_and_a_second(formula, is_refuted, tmp_path):
    assert (verdict_of(formula, SYMBOLS, tmp_path) == "refuted") == is_refuted


@pytest.mark.parametrize(
    "words",
    ["With f in Hz and N in rpm, $N = {}$.", "f in Hz. In revolutions per minute, $N = {}$."],
)
def test_units_in_words_say_the_same(words):
    for value, is_refuted in (("60 f", False), ("f/60", True)):
        verdict = check(words.replace("{}", value)).data()["links"][-1]["verdict"]
        assert (verdict == "refuted") == is_refuted
