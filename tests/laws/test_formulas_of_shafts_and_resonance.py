"""Standard formulas of shafts, springs in series and resonance, by the words that name them."""

import pytest

from tests.checked_pages import last_verdict, verdicts_in


@pytest.mark.parametrize("before", ["", "Le volant est un disque plein de masse $m$, $J = m R^2/2$.\n\n"])
def test_the_polar_moment_of_a_journal_below_a_flywheel(before):
    page = before + (
        r"On assimile un tourillon à un cylindre plein de diamètre $d$. Son moment quadratique polaire"
        "\n"
        r"est $I_0 = \dfrac{\pi d^4}{NUMBER}$. Le couple maximal est donné par la suite de la page."
    )
    assert verdicts_in(page.replace("NUMBER", "32"))[-1] == "conditional"
    assert verdicts_in(page.replace("NUMBER", "64"))[-1] == "refuted"


def test_the_polar_moment_of_a_flywheel_may_be_of_its_mass():
    page = "The flywheel, of mass $m$, is a disc. Its polar moment of inertia is $I_0 = m d^2/8$."
    assert verdicts_in(page)[-1] != "refuted"


@pytest.mark.parametrize(
    ("page", "right", "wrong"),
    [
        (
            "Pro Umdrehung legt der Kolben zwei Hübe zurück, die mittlere Kolbengeschwindigkeit ist"
            " $c_m = {}$, mit dem Hub $s$ und der Drehzahl $n$.",
            r"2\,s\,n",
            r"s\,n",
        ),
        (
            "The piston makes two strokes per revolution. The mean piston speed is $v = {}$, where s is"
            " the stroke and n the speed.",
            "2 s n",
            "s n",
        ),
    ],
)
def test_two_strokes_a_turn_make_the_mean_speed(page, right, wrong):
    assert verdicts_in(page.replace("{}", right))[-1] == "conditional"
    assert verdicts_in(page.replace("{}", wrong))[-1] == "refuted"


def test_strokes_that_are_counted_are_no_turns():
    page = "The pump has n strokes per minute. The mean piston speed is $v = s n$."
    assert verdicts_in(page)[-1] != "refuted"


@pytest.mark.parametrize(
    ("claim", "verdict"),
    [
        ("k = k_1 + k_2", "refuted"),
        ("k = k_1 k_2/(k_1 + k_2)", "conditional"),
        ("1/k = 1/k_1 + 1/k_2", "conditional"),
    ],
)
def test_shafts_in_series_with_a_declared_stiffness(claim, verdict, tmp_path):
    symbols = '[symbols]\n"k" = "torsional stiffness [N m/rad]"\n'
    page = f"## Shafts in series\n\nTheir twists add. So for the pair ${claim}$."
    assert last_verdict(tmp_path, page, symbols) == verdict


@pytest.mark.parametrize(
    ("page", "right", "wrong"),
    [
        (
            r"With damping ratio $\zeta$, the magnification at resonance is $Q = {}$.",
            r"1/(2\zeta)",
            r"2\zeta",
        ),
        (
            "Mit dem Dämpfungsgrad $D$ ist die Vergrößerungsfunktion in Resonanz $V = {}$.",
            "1/(2D)",
            "1/D",
        ),
    ],
)
def test_the_magnification_at_resonance(page, right, wrong):
    assert verdicts_in(page.replace("{}", right))[-1] == "conditional"
    assert verdicts_in(page.replace("{}", wrong))[-1] == "refuted"


@pytest.mark.parametrize(("claim", "verdict"), [(r"1/(2\zeta)", "conditional"), (r"1/\zeta", "refuted")])
def test_the_magnifier_where_the_ratio_is_one(claim, verdict, tmp_path):
    symbols = '[symbols]\n"Q" = "dynamic magnifier"\n"\\\\zeta" = "viscous damping ratio"\n'
    page = rf"With damping ratio $\zeta$, the magnifier at $\rho = 1$ is $Q = {claim}$."
    assert last_verdict(tmp_path, page, symbols) == verdict


def test_a_loss_factor_is_no_damping_ratio():
    page = r"The loss factor is $\eta$; the magnification at resonance is $Q = 1/\eta$."
    assert verdicts_in(page)[-1] != "refuted"


@pytest.mark.parametrize(("number", "is_refuted"), [("16", False), ("32", True)])
def test_the_diameter_for_an_equivalent_torque(number, is_refuted):
    page = (
        r"The equivalent torque is $T_e = \sqrt{M^2+T^2}$ and the diameter of the shaft by the allowable"
        rf" shear stress τ is $d = ({number} T_e/(\pi\tau))^{{1/3}}$."
    )
    assert (verdicts_in(page)[-1] == "refuted") == is_refuted


@pytest.mark.parametrize("number", ["1", "0.95", "2"])
def test_each_number_behind_at_is_a_case(number):
    page = (
        r"The ratio is $\rho = \omega/\omega_n$ and the magnifier $Q = \frac{1}{1+\rho^2}$."
        "\n\n"
        rf"At $\rho = 0.9$, $Q = 0.55$. At $\rho = {number}$ the magnifier is smaller."
    )
    assert verdicts_in(page)[-1] == "premise"
    assert verdicts_in(page.replace("At $\\rho = " + number, "So $\\rho = 1.01"))[-1] != "premise"


@pytest.mark.parametrize(
    ("claim", "verdict"),
    [
        (r"k \propto d^4/L", "holds"),
        (r"k \propto d^3/L", "refuted"),
        (r"\tau \propto d^{-3}", "holds"),
        (r"\tau \propto d^{-2}", "refuted"),
    ],
)
def test_proportions_by_another_form_of_the_letter(claim, verdict):
    page = r"""The stiffness is $$ k = \frac{T}{\theta} = \frac{GJ}{L}, \qquad J = \frac{\pi d^4}{32} $$
and the stress $$ \tau = \frac{Td/2}{J} = \frac{16T}{\pi d^3}. $$

Thus $CLAIM$.
"""
    assert verdicts_in(page.replace("CLAIM", claim))[-1] == verdict


@pytest.mark.parametrize(("power", "verdicts"), [("n^2", ("conditional", "holds")), ("n", ("refuted",))])
def test_a_force_grows_with_the_turns_that_its_number_is_of(power, verdicts):
    page = r"""$n = 12000$ rpm, so $\omega = 2\pi\cdot 12000/60 = 1257$ rad/s. The force
is $F = m r\omega^2$.

Forces go with the speed, $F \propto POWER$.
"""
    assert verdicts_in(page.replace("POWER", power))[-1] in verdicts
