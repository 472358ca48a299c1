"""What is said of a wrong number: in the unit, the digits and the decimal sign of its author."""

import re

import pytest

import symbalance as sb
from symbalance.document.text_writer import formula_text
from symbalance.notes.checking.reports.typeset_relations import sides_by_span, typeset
from symbalance.notes.checking.words.written_numbers import written_number

NUMBERS = {
    r"$31.4/0.7457 \approx 45$": ("miscalculated", "42"),
    r"$7\cdot\frac{\pi}{4}\cdot 68^2 \approx 25.4$ N": ("unit: kN, not N", "25.4 kN"),
    r"$0.292\cdot 18.7\,\mathrm{kN} = 0.546\,\mathrm{kN}$": ("ten times too small", "5.46 kN"),
    r"$\frac{500}{2\pi} = 796\ \mathrm{Hz}$": ("ten times too large", "79.6 Hz"),
    r"$2\cdot 0.0955\cdot 66.67 = 25.46$": ("factor 1/2: twice what it is", "12.73"),
    r"$720^\circ/7 = 105.9^\circ$": ("miscalculated", "102.9°"),
    r"$720^\circ/6 = 150^\circ$": ("120, not 150", "120°"),
    r"$12\cdot 5 = 62$": ("60, not 62", "60"),
    r"$231\cdot 16.387 \approx 3585$": ("miscalculated", "3785"),
    r"$3\cdot 7 = \SI{22}{N}$": ("21, not 22", "21 N"),
    r"$2\cdot 0{,}72\cdot 6{,}1 = 7{,}88$": ("digits exchanged", "8,78"),
    r"$4\cdot 32 \approx 1.28\times 10^{3}$": ("ten times too large", "1.28 × 10²"),
    r"$8600/9 = 965$ lb": ("miscalculated", "955.6 lb"),
    r"$8\cdot 10^5\cdot 269.4\cdot 10^{-6}\cdot 25 \approx 3.59\,\mathrm{kW}$": (
        "digits exchanged",
        "5.39 kW",
    ),
}


def only(page):
    (found,) = sb.check(page).verdicts
    return found


@pytest.mark.parametrize("page", NUMBERS)
def test_a_wrong_number_is_mended_as_it_was_written(page):
    found = only(page)
    plain = {"·": "*", "−": "-"}
    text = "".join(plain.get(each, each) for each in sb.to_text(found))
    assert found.verdict == "refuted"
    words, number = NUMBERS[page]
    assert found.fix.words == words
    assert f"put {number}" in text, text
    assert text.index("found: ") < text.index("put ")


@pytest.mark.parametrize("page", NUMBERS)
def test_the_page_with_the_mended_number_is_right(page):
    """But where the number is what bare numbers make in its unit, which other rules judge."""
    (fault,) = only(page).fix.faults
    if fault.source.endswith("lb"):
        return
    source = fault.source
    at = page.rindex(source)
    number = fault.should.replace("1.28e2", "128")
    tail = page[at + len(source) :]
    digits = re.match(r"[0-9.,]+", number)[0]
    unit = number[len(digits) :].strip()
    mended = f"{page[:at]}{digits.replace(',', '{,}')}"
    mended += "^\\circ" if unit == "°" else rf"\,\mathrm{{{unit}}}" if unit else ""
    mended += "$" if not tail.endswith("$") else tail
    assert only(mended).verdict in ("holds", "holds_to_order", "conditional"), mended


@pytest.mark.parametrize("page", NUMBERS)
def test_no_number_beside_a_decimal_has_more_than_six_digits(page):
    found = only(page)
    for text in (found.fix.text, found.exact):
        for number in re.findall(r"[0-9.,]+", text.split("×")[0].split("^")[0]):
            assert len(re.sub("[^0-9]", "", number).lstrip("0")) <= 6, text


def test_exact_lines_keep_exact_values():
    assert only(r"$2\cos 30^\circ = 2$").fix.text == "sqrt(3)"
    assert only(r"$\frac13 + \frac14 = \frac{5}{12}$").fix.text == "7/12"


def test_what_a_link_before_has_proved_is_not_mended():
    """λ m r/2 is right by the first link, so the second one's right side is wrong."""
    page = r"$\frac{a b}{4} + \frac{a b}{4} = \frac{a b}{2} = a b$"
    _, last = sb.check(page).verdicts
    assert last.verdict == "refuted"
    assert (last.fix.of_left, last.fix.text) == (False, "1/2 a b")


@pytest.mark.parametrize(
    ("line", "words", "put"),
    [
        (r"(a+b)^2 = a^2 - 2ab + b^2", "sign of the second term", "+ 2a b"),
        (r"x(x+1) = x^2 + x^2", "exponent of the first term", "x"),
        (r"\sin 2x = 2\sin x \sin x", "cos, not sin", "cos x"),
        (r"\frac12\sin 2x = \frac14 \sin x\cos x", "4 is too much", None),
        (r"-\frac32\cos x+\frac{\sqrt3}{2}\sin x = \sqrt3\cos(x-\frac{\pi}{6})", "phase", "−5π/6"),
    ],
)
def test_the_slip_is_said_in_words(line, words, put):
    found = only(f"${line}$")
    assert found.verdict == "refuted"
    assert found.fix.words == words or found.fix.of_left
    assert put is None or f"put {put}" in sb.to_text(found) or found.fix.of_left


def test_a_rewritten_side_is_no_correction():
    """m r ω²/n for cos θ + cos 2θ/n has nothing in common with it: the exact value says more."""
    found = only(r"$\cos x + y\cos 2x = y\sin^2 3x + \cos^3 5x$")
    assert found.verdict == "refuted"
    assert found.fix is None
    assert found.exact


@pytest.mark.parametrize(
    ("line", "shown"),
    [
        (r"p = 0{,}546\,\mathrm{kN}", "0,546 kN"),
        (r"p = 41\,\mathrm{mm}", "41 mm"),
        (r"p = 38.48\,\mathrm{cm}^2", "38.48 cm²"),
        (r"p = 1382", "1382"),
    ],
)
def test_a_page_shows_numbers_as_they_were_typed(line, shown):
    checked = sb.check(f"${line}$")
    relation = typeset(checked.verdicts[0], sides_by_span(checked.derivation), checked.derivation.text)
    assert formula_text(relation, plain=True) == f"p = {shown}"


@pytest.mark.parametrize("source", ["2 + 3", "2·3", "5·1", "x", "", "1/3", "9" * 200, "10^{400}"])
def test_what_is_no_number_is_none(source):
    for value in (1.0, 5.0, 6.0, 1 / 3):
        assert written_number(source, value) is None


@pytest.mark.parametrize(
    ("source", "value", "text"),
    [
        ("13,530", 13530.0, "13530"),
        ("13,530", 13.53, "13,530"),
        (r"-4.50\,\mathrm{m/s}", -4.5, "−4.50 m/s"),
        ("５２５ cm³", 0.000525, "525 cm³"),
        (r"\SI{25,46}{m/s}", 25.46, "25,46 m/s"),
        (r"6.17\times10^{4}\ \mathrm{m/s^2}", 61700.0, "6.17 × 10⁴ m/s²"),
        ("537&nbsp;kN·m", 537000.0, "537 kN·m"),
        ("3.05·10⁻³", 0.00305, "3.05 × 10⁻³"),
    ],
)
def test_a_number_is_read_with_its_unit(source, value, text):
    assert written_number(source, value).text == text
