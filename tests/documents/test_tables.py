"""What a printed table says besides its numbers: its conventions, its firing, what is rounded."""

import math
import re

import pytest

import symbalance as sb


def said(layout: sb.Engine, order: int = 4) -> tuple[str, str]:
    """Return a layout's balance as text and as LaTeX, each on one line."""
    result = sb.balance(layout, order=order)
    return tuple(" ".join(form(result).split()) for form in (sb.to_text, sb.to_latex))  # type: ignore[return-value]


def test_the_conventions_are_stated():
    text, latex = said(sb.load("v6-60"))
    meaning = "reciprocating mass of one cylinder, crank radius, cylinder pitch"
    assert text.count(f"m, r, a {meaning}") == 1
    assert latex.count(f"$m$, $r$, $a$: {meaning}") == 1
    for form in (text, latex):
        assert "a couple + pushes the front up or right" in " ".join(form.split())


@pytest.mark.parametrize(
    ("layout", "words"),
    [
        (sb.load("v12-60"), "cylinder 1 at firing top dead centre"),
        (sb.vee(60, "1-2", cylinders=[[2], [1]]), "cylinder 1 at firing top dead centre"),
        (sb.inline(throws=[0, 180]), "cylinder 1 at top dead centre"),
        (sb.Engine([sb.Cylinder(1, fires=360)]), "cylinder 1 at top dead centre"),
        (sb.inline(throws=[30, 90]), "the pin of cylinder 1 at"),
        (sb.vee(90, pins=[0, 90]), "the pin of cylinder 1 at"),
    ],
)
def test_where_theta_is_zero_is_said(layout, words):
    assert all(words in form for form in said(layout))


@pytest.mark.parametrize(
    ("layout", "words"),
    [
        (sb.load("v2-45"), "1-2 at intervals of 405°, 315°"),
        (sb.load("v6-90"), "1-6-5-4-3-2 at intervals of 150°, 90°, and so on"),
        (sb.inline("1-2", firing_intervals=["128.1234", "591.8766"]), "of 128.1234°, 591.8766°"),
        (sb.inline("1-2", firing_intervals=[180, 180], strokes=2), "1-2"),
    ],
)
def test_uneven_firing_is_said(layout, words):
    text, latex = said(layout)
    assert words in " ".join(text.split())
    assert words.replace("°", r"$^{\circ}$") in latex


def test_even_firing_is_not_called_uneven():
    assert not any("intervals" in form for form in said(sb.load("v8-90")))


def test_a_bank_is_one_and_several_are_several(golden):
    """What stands over the orders: banks, firing, units, signs."""
    engines = [
        sb.load("inline-4"),
        sb.load("v6-60"),
        sb.engine.from_firing_order("1-2", banks=[15], name="tilted"),
    ]
    heads = [sb.to_text(sb.balance(engine, order=2)).partition("\n\n")[0] for engine in engines]
    golden("balance-heads.txt", "\n\n".join(heads) + "\n")


def test_rounded_phases_are_marked():
    text, latex = said(sb.load("v8-90"))
    assert text.count("−1.10715") == text.count("≈ −1.10715") == 1
    assert latex.count("-1.10715") == latex.count(r"$\approx$ $-1.10715$") == 1


def test_a_balance_in_newtons(golden):
    golden("balance-newtons.txt", sb.to_text(sb.balance(sb.load("vq30de"), 6).at(rpm=6000)))


def test_what_a_short_document_leaves_out_is_named_and_shown_in_full():
    """The rotating parts, and exact forms too long for a cell; nothing goes from the JSON."""
    result = sb.balance(sb.load("v6-90"), 4)
    short, full = sb.to_text(result), sb.to_text(result, full=True)
    assert "as rotating parts (--full)" in " ".join(short.split())
    assert "against it" not in short
    assert "forward (with the crank)" in full
    assert "--full" not in full
    assert len(short.splitlines()) <= 60
    assert "<details>" in sb.to_html(result)


def test_several_orders_are_orders():
    text = " ".join(sb.to_text(sb.balance(sb.inline("1-3-5-7-6-4-2"), 24), full=True).split())
    assert re.search(r"orders \d+, \d+", text)
    assert not re.search(r"order \d+, \d+", text)


def lines(text: str) -> int:
    return text.rstrip("\n").count("\n") + 1


@pytest.mark.slow
def test_every_preset_is_one_page_and_what_it_leaves_out_is_in_the_whole():
    """Of 60 lines. Orders that are named in a line, and left to --full, are below a ten-thousandth."""
    shortened = 0
    for preset in sb.presets():
        result = sb.balance(sb.load(preset.name))
        text, full = sb.to_text(result), sb.to_text(result, full=True)
        assert lines(text) <= 60, preset.name
        unit = result.kinematics is None
        for order in result.orders:
            for of in ("force", "couple"):
                parts = [getattr(order, of).component(name) for name in ("vertical", "lateral")]
                factor = 1.0 if unit else abs(float(result.values[order.order]))
                size = max(math.hypot(*map(float, part.decimal())) for part in parts) * factor
                title = "Free force" if of == "force" else "Free couple"
                table = re.split(r"\n\n", text[text.index(title) :])[0]
                is_tabled = bool(re.search(rf"^ +{order.order}  ", table, re.MULTILINE))
                assert is_tabled or size < 1e-4, (preset.name, of, order.order)
                if 1e-6 < size < 1e-4 and not is_tabled:
                    shortened += 1
                    assert re.search(
                        rf"^{of} of orders? [^\n]*\b{order.order}\b[^\n]*unit", full, re.MULTILINE
                    )
                    assert "below 10⁻⁴ of one piston's first order" in " ".join(text.split())
    assert shortened > 10


@pytest.mark.slow
def test_at_a_speed_no_order_above_a_millionth_is_left_out():
    result = sb.balance(sb.load("vw-w8")).at(rpm=3000, mass="0.5")
    text = sb.to_text(result)
    assert "10⁻⁴" not in text
    assert all(re.search(rf"^ +{n} +vertical", text, re.MULTILINE) for n in (5, 7, 8))
