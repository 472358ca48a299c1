"""ω_max + ω_min ≈ 2ω says what the mean speed is, also where ω has its own number."""

import pytest

from tests.checked_pages import verdicts_in

PAGE = r"""The speed is $N = 3000$ rpm, $\omega = \frac{2\pi N}{60} = 314.2$ rad/s. With
$\delta = \frac{\omega_{\max}-\omega_{\min}}{\omega}$ and $CLAIM$ the energy follows.
"""


@pytest.mark.parametrize(
    "right",
    [r"\omega_{\max}+\omega_{\min} \approx 2\omega", r"2\omega \approx \omega_{\max}+\omega_{\min}"],
)
def test_the_mean_of_two_extremes(right):
    assert verdicts_in(PAGE.replace("CLAIM", right))[-1] == "conditional"


@pytest.mark.parametrize(
    "wrong",
    [r"\omega_{\max}+\omega_{\min} \approx 3\omega", r"\omega_{\max}-\omega_{\min} \approx 2\omega"],
)
def test_another_factor_or_sign_is_no_mean(wrong):
    assert verdicts_in(PAGE.replace("CLAIM", wrong))[-1] not in ("holds", "conditional", "holds_to_order")
