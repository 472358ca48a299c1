r"""A page's own list or table of symbols says what its letters are, as a sentence does."""

import pytest

from symbalance.checking import check

LISTS = {
    "items": "- $v$: mean piston speed\n- $s$: stroke\n- $n$: revolutions per second",
    "with units": "- $v$: mean piston speed in m/s\n- $s$: stroke in m\n- $n$: speed in 1/s",
    "dashes": "* $v$ – mean piston speed\n* $s$ – stroke",
    "equals": "Symbols: $v$ = mean piston speed, $s$ = stroke, $n$ = revolutions per second.",
    "a table": "| Symbol | Meaning |\n|---|---|\n| $v$ | mean piston speed |\n| $s$ | stroke |",
    "with units in a table": "||||\n|-|-|-|\n| $v$ | mean piston speed | m/s |\n| $s$ | stroke | m |",
    "brackets": "($v$ mean piston speed, $s$ stroke, $n$ revolutions per second)",
    "German": "- $v$: mittlere Kolbengeschwindigkeit\n- $s$: Hub\n- $n$: Drehzahl in 1/s",
    "Japanese": "$v$ は平均ピストン速度、$s$ は行程、$n$ は毎秒回転数である。",
    "Japanese items": "- $v$：平均ピストン速度\n- $s$：行程",
    "LaTeX": "\\begin{itemize}\n\\item[$v$] mean piston speed\n\\item[$s$] stroke\n\\end{itemize}",
    "LaTeX table": r"""\begin{tabular}{ll}
$v$ & mean piston speed \\
$s$ & stroke \\
\end{tabular}""",
}


@pytest.mark.parametrize("listed", LISTS.values(), ids=LISTS)
def test_a_listed_letter_is_what_its_entry_says(listed):
    wrong = check(f"{listed}\n\n$$v = s n$$\n").verdicts[-1]
    assert (wrong.verdict, "nobody declared it" in wrong.reason) == ("refuted", True)
    assert wrong.fix is not None
    assert wrong.fix.text == "2s n"
    right = check(f"{listed}\n\n$$v = 2 s n$$\n").verdicts[-1]
    assert right.verdict == "conditional"


@pytest.mark.parametrize(
    "text",
    [
        "| $v$ | mean piston speed in m/s |\n|---|---|\n| 1 | 8 |",  # the head of a table of numbers
        "With the unbalance $v$: the mean piston speed adds to it.",
        "| $s$ | mean piston speed |\n| $u$ | crank radius |",
    ],
)
def test_other_letters_and_clauses_are_not(text):
    assert check(f"{text}\n\n$$v = s n$$\n").verdicts[-1].verdict != "refuted"


ROD = (
    "The connecting rod of mass $m_b$ and length $l$ is replaced by {}. "
    "The centre of gravity lies at the distance $h$ from the big end."
    "\n\n$$m_1 = m_b \\frac{{{}}}{{l}}$$\n"
)


@pytest.mark.parametrize(
    "words",
    [
        "two point masses, $m_1$ at the small end and $m_2$ at the big end",
        "two masses: $m_1$ at the small end, $m_2$ at the big end",
        "the masses $m_1$ at the small end and $m_2$ at the big end",
    ],
)
@pytest.mark.parametrize(("share", "verdict"), [("h", "conditional"), ("l-h", "refuted")])
def test_one_noun_may_name_two_letters(words, share, verdict):
    assert check(ROD.format(words, share)).verdicts[-1].verdict == verdict
