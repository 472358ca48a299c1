"""Words that make another quantity of a named one leave its formula a definition."""

import pytest

from tests.checked_pages import last_verdict

CHANGED = (
    r"Twice the kinetic energy is $$E = \frac12 m v^2$$",
    r"Die doppelte Fliehkraft ist $F = m r \omega^2$.",
    r"La moitié de la force centrifuge est $F = m r\omega^2$.",
    r"運動エネルギーの2倍は $E = \frac12 m v^2$ である。",
    r"A tenth of the kinetic energy is $E = \frac12 m v^2$.",
    r"The negative of the kinetic energy is $E = \frac12 m v^2$.",
    r"The kinetic energy per unit mass is $E = \frac12 m v^2$.",
    r"The mean kinetic energy over the stroke is $$E = \frac12 m v_{max}^2$$",
    r"The inverse of the natural frequency is $\omega_0 = \sqrt{k/m}$.",
    r"The natural frequency with the mass doubled is $\omega_0 = \sqrt{k/m}$.",
    r"The natural frequency of $m$ on two springs of stiffness $k$ is $\omega_0 = \sqrt{k/m}$.",
    r"The natural frequency in cycles per minute is $$f = \frac{1}{2\pi}\sqrt{\frac{k}{m}}$$",
    r"The second natural frequency is $\omega_0 = \sqrt{k/m}$.",
    r"The torsional stress at half the radius is $\tau = \frac{16 M_t}{\pi d^3}$",
    r"The centrifugal force of both masses is $F = m r\omega^2$",
    r"The swept volume of the four-cylinder engine is $V_H = \frac{\pi}{4}D^2 s$.",
    r"Das 1,5-fache der Fliehkraft beträgt $F = m r\omega^2$.",
    r"Minus the kinetic energy is $E = \frac12 m v^2$.",
    r"$E = \frac12 m v^2$ is twice the kinetic energy.",
    r"The power at twice the speed $\omega$ is $P = M\omega$.",
)
ITSELF = (
    r"The kinetic energy is $$E = \frac12 m v^2$$",
    r"運動エネルギーは $E = \frac12 m v^2$ である。",
    r"The centrifugal force on the counterweight at this speed is therefore $F = m r\omega^2$.",
    r"The natural frequency of the mass $m$ on the spring of stiffness $k$ is $\omega_0 = \sqrt{k/m}$.",
    r"The natural frequency in hertz is $f = \frac{1}{2\pi}\sqrt{\frac{k}{m}}$.",
    r"$E = \frac12 m v^2$ is the kinetic energy.",
    r"The torsional stress at the surface is $\tau = \frac{16 M_t}{\pi d^3}$.",
    r"The natural frequency of two discs is $\omega_0 = \sqrt{\frac{k(J_1+J_2)}{J_1 J_2}}$.",
    r"The stiffness of two springs in parallel is $k = k_1 + k_2$.",
    r"The swept volume of all four cylinders is $V_H = 4\cdot\frac{\pi}{4}D^2 s$.",
    r"The swept volume per cylinder is $V_h = \frac{\pi}{4}D^2 s$.",
    r"The mean piston speed of the four-cylinder engine is $c_m = 2 s n$.",
    r"The mean stress is $\sigma_m = \frac{\sigma_o + \sigma_u}{2}$.",
    r"The power of the four-stroke engine with the mean effective pressure $p_e$ is $P = p_e V_H n/2$.",
)


@pytest.mark.parametrize("page", CHANGED)
def test_the_standard_formula_is_not_that_of_what_words_change(tmp_path, page):
    assert last_verdict(tmp_path, page) in ("definition", "premise")


@pytest.mark.parametrize("page", ITSELF)
def test_the_standard_formula_is_that_of_the_quantity_itself(tmp_path, page):
    assert last_verdict(tmp_path, page) == "conditional"


def test_a_declared_meaning_is_read_in_the_same_way(tmp_path):
    symbols = '[symbols]\n"E" = "%s"\n"m" = "mass, kg"\n"v" = "speed, m/s"\n'
    page = r"We need $E = \frac12 m v^2$."
    assert last_verdict(tmp_path, page, symbols % "kinetic energy") == "conditional"
    assert last_verdict(tmp_path, page, symbols % "twice the kinetic energy") == "definition"
