"""The unit of a result is that of its formula beside a speed in rpm, and beside g.

Revolutions per minute count as a bare number where a formula divides them by 60, and g has no number on
most pages; their units are known all the same.
"""

import pytest

from tests.checked_pages import last_verdict

RUNNING = r"$n = 3000$ rpm, $r = 40$ mm, $m = 2$ kg. "
FORCE = '[symbols]\n"F" = "force, N"\n"m" = "mass, kg"\n"r" = "crank radius"\n"n" = "speed"\n'
POWER = '[symbols]\n"P" = "power"\n"M" = "torque"\n"n" = "speed"\n'
CYLINDERS = '[symbols]\n"z" = "number of cylinders"\n"n" = "speed"\n'
ANGULAR = '[symbols]\n"omega" = "angular speed"\n"n" = "speed"\n'
PAGES = (
    (RUNNING + r"$$F = m r \left(\frac{2\pi n}{60}\right)^2 = 7896\,\mathrm{?}$$", FORCE, "N", "J"),
    (r"$m = 2$ kg、$r = 40$ mm、$n = 3000$ rpm のとき、$F = m r (\pi n/30)^2 = 7.9$ ?", "", "kN", "kJ"),
    (r"$n = 3000$ rpm, $M = 200$ N m. $$P = \frac{2\pi n M}{60} = 62832\,\mathrm{?}$$", POWER, "W", "J"),
    (r"La vitesse est $N = 3000$ tr/min, la course $c = 80$ mm. $v_m = c N/30 = 8$ ?", "", "m/s", "m"),
    (r"Bei $n = 4500\,\mathrm{min^{-1}}$ ist $\omega = \pi n/30 = 471{,}2$ ?.", "", "rad/s", "N"),
    (r"The engine turns at $n=3000$ rpm. $\omega = \pi n/30 = 314.2$ ?.", ANGULAR, "rad/s", "rad/min"),
    (r"$n = 3000$ rpm, $z = 4$. $$f = \frac{z n}{120} = 100\,\mathrm{?}$$", CYLINDERS, "Hz", "kg"),
    (r"$V_h = 2$ dm³, $p_m = 10$ bar, $n = 3000$ min⁻¹. $P = p_m V_h n/120 = 50$ ?", "", "kW", "kPa"),
    (r"$m = 2$ kg: $$F = m g = 19.6\,\mathrm{?}$$", FORCE, "N", "s"),
    (r"Die Masse $m = 2$ kg liegt $h = 3$ m hoch: $E = m g h = 58{,}9$ ?", "", "J", "N"),
)  # fmt: skip
CONFIRMED = ("holds", "holds_to_order", "conditional")


@pytest.mark.parametrize(("page", "symbols", "right", "wrong"), PAGES)
def test_the_unit_is_that_of_the_formula(tmp_path, page, symbols, right, wrong):
    assert last_verdict(tmp_path, page.replace("?", right), symbols) in CONFIRMED
    assert last_verdict(tmp_path, page.replace("?", wrong), symbols) == "refuted"


def test_a_sentence_at_another_speed_counts_revolutions_as_typed(tmp_path):
    page = RUNNING + "\n\n$\\omega = 2\\pi n/60$\n\nAt 1500 rpm the force is $F = m r \\omega^2 = %s$ N."
    assert last_verdict(tmp_path, page % "1974") in CONFIRMED
    assert last_verdict(tmp_path, page % "7896") not in CONFIRMED


@pytest.mark.parametrize(
    ("page", "symbols"),
    [
        (
            r"$N = 3000$ rpm: $\omega = 2\pi N/60 = 314$ rad/s.",
            '"N" = "number of revolutions per minute"',
        ),
        (r"$M = 200$ N m, $n = 3000$ rpm: $P = 2\pi n M/60 = 62.8$ kW.", '"P" = "power, W"'),
        (r"$n = 600$ rpm, $d = 0.05$ m. $v = \pi d n = 94.2$ m/min.", '"d" = "diameter"'),
        (r"$n = 3000$ rpm. The engine fires $f = 4\cdot n/2 = 6000$ min⁻¹.", '"n" = "engine speed"'),
        (r"$m = 2$ kg, $r = 40$ mm. $U = m r = 80$ kg mm.", '"U" = "unbalance, kg m"'),
        (r"$G = 200$ N. $m = G/g = 20.4$ kg.", '"m" = "mass, kg"'),
    ],
)
def test_a_unit_of_the_same_dimension_is_right(tmp_path, page, symbols):
    assert last_verdict(tmp_path, page, f"[symbols]\n{symbols}\n") in CONFIRMED
