"""The unit of a result is judged by the formula, the numbers and the noun before it."""

import pytest

from symbalance.checking import check
from tests.checked_pages import last_verdict

RIGHT = (
    r"""Power $P = 50$ kW at $n = 3000$ min⁻¹.

$M = P/\omega = 50000/314 = 159$ N m""",
    r"""Power $P = 50$ kW at $n = 3000$ min⁻¹.

$M = P/\omega = 50/314 = 0.159$ kN m""",
    r"""The stroke is $s=86$ mm.

The mean piston speed at 6000 rpm is $c = 2\cdot 0.086\cdot 100 = 17.2$ m/s.""",
    r"""The stroke is $s=86$ mm.

The mean piston speed at 6000 rpm is $c = 2\cdot 0.086\cdot 100\cdot 3.6 = 61.9$ km/h.""",
    r"""$M = 120$ N m, $d = 30$ mm, $W_t = 5301$ mm³

$\tau = M/W_t$

$\tau = 120000/5301 = 22.6$ MPa""",
    r"""$J = 0.5$ kg m², $\omega = 100$ rad/s.

$E = \frac12 J\omega^2$

$E = 0.5\cdot 0.5\cdot 100^2 = 2500\,\mathrm{J}$""",
    r"""$J = 0.5$ kg m², $\omega = 100$ rad/s.

$E = \frac12 J\omega^2$

$E = 0.5\cdot 0.5\cdot 100^2 = 2500$ Nm = 2.5 kJ""",
    r"""$m = 0.4$ kg, $r = 40$ mm, $\omega = 300$ rad/s.

$F = m r \omega^2$

Hence

$F = 0.4\cdot 0.04\cdot 300^2 = 1.44$ kN""",
    r"""Gegeben: $P = 75$ kW, $n = 5500$ 1/min.

$M = P/(2\pi n) = 75000/576 = 130$ Nm""",
    r"""回転数 $n = 3000$ rpm

$ω = 2πn/60 = 314.2$ rad/s""",
    r"""$k = 10000$ N/m, $m = 4$ kg

$\omega_0 = \sqrt{k/m} = \sqrt{10000/4} = 50$ rad/s""",
    r"""$\omega = 2\pi\cdot 50 = 314$ rad/s and $f = 3000/60 = 50$ Hz""",
    r"""The speed is $\omega = 314.2$ rad/s $= 3000$ rpm""",
    r"""Das Drehmoment beträgt $M = 50$ N m. The mass is $m = 3$ kg.""",
)
WRONG = (
    r"""Power $P = 50$ kW at $n = 3000$ min⁻¹.

$M = P/\omega = 50000/314 = 159$ kNm""",
    r"""Power $P = 50$ kW at $n = 3000$ min⁻¹.

$M = P/\omega = 50/314 = 0.159$ N m""",
    r"""The stroke is $s=86$ mm.

The mean piston speed at 6000 rpm is $c = 2\cdot 0.086\cdot 100 = 17.2$ km/h.""",
    r"""$M = 120$ N m, $d = 30$ mm, $W_t = 5301$ mm³

$\tau = M/W_t$

$\tau = 120000/5301 = 22.6$ kPa""",
    r"""$J = 0.5$ kg m², $\omega = 100$ rad/s.

$E = \frac12 J\omega^2$

$E = 0.5\cdot 0.5\cdot 100^2 = 2500\,\mathrm{W}$""",
    r"""$m = 0.4$ kg, $r = 40$ mm, $\omega = 300$ rad/s.

$F = m r \omega^2$

Hence

$F = 0.4\cdot 0.04\cdot 300^2 = 1440$ N m""",
    r"""Gegeben: $P = 75$ kW, $n = 5500$ 1/min.

$M = P/(2\pi n) = 75000/576 = 130$ kNm""",
    r"""$k = 10000$ N/m, $m = 4$ kg

$\omega_0 = \sqrt{k/m} = \sqrt{10000/4} = 50$ rpm""",
    r"""$k = 10000$ N/m, $m = 4$ kg

$\omega_0 = \sqrt{k/m} = \sqrt{10000/4} = 50$ Hz""",
    r"""$\omega = 2\pi\cdot 50 = 314.2$ Hz""",
    r"""Das Drehmoment beträgt $M = 50$ N.""",
    r"""The mass is $m = 3$ N.""",
)


def _verdicts(page):
    return [link["verdict"] for link in check(page).data()["links"]]


@pytest.mark.parametrize("page", RIGHT)
def test_nothing_right_is_accused(page):
    assert not {"refuted", "contradiction", "unreadable"} & set(_verdicts(page))


@pytest.mark.parametrize("page", WRONG)
def test_what_is_wrong_is_refuted(page):
    assert "refuted" in _verdicts(page)


COUPLE = r"""The amplitude is <math>M_1 = m r\omega^2 c</math> and <math>M_2 = \lambda M_1</math>.

=== Example ===
For a twin with <math>m = 0.55\ \text{kg}</math>, <math>r = 38\ \text{mm}</math> and
<math>c = 42\ \text{mm}</math>:
* <math>\lambda = 0.29</math>
* <math>\omega = 2\pi \cdot 6000/60 \approx 628.3\ \text{rad/s}</math>
* <math>M_1 = 8250 \cdot 0.042 \approx 347\ \text{UNIT}</math>
* <math>M_2 \approx 101\ \text{N m}</math>
"""


@pytest.mark.parametrize(("unit", "refuted"), [("N m", 0), ("kN m", 1), ("J", 0), ("kJ", 1)])
def test_the_result_is_refuted_and_not_the_numbers_put_in(unit, refuted):
    verdicts = _verdicts(COUPLE.replace("UNIT", unit))
    assert [n for n, word in enumerate(verdicts) if word == "refuted"] == [len(verdicts) - 2] * refuted


LISTS = [
    "The forces are $F_1 = m r \\omega^2 = {}$ and $F_2 = \\lambda F_1 = 0.96$ kN.",
    "Kräfte: $F_1 = m r \\omega^2 = {}$ bzw. $F_2 = \\lambda F_1 = 0.96\\,\\mathrm{{kN}}$.",
    "On a $F_1 = m r \\omega^2 = {}$, $F_2 = \\lambda F_1 = 0.96$ kN.",
]


@pytest.mark.parametrize("sentence", LISTS)
@pytest.mark.parametrize(("number", "is_right"), [("3.2", True), ("2.3", False), ("32", False)])
def test_numbers_of_a_list_have_the_unit_at_its_end(sentence, number, is_right):
    data = "$m = 0.5$ kg, $r = 40$ mm, $\\omega = 400$ 1/s, $\\lambda = 0.3$.\n\n"
    links = check(data + sentence.format(number) + "\n", {}).data()["links"]
    assert (links[-3]["verdict"] == "refuted") is not is_right
    assert links[-1]["verdict"] in ("holds", "holds_to_order", "conditional")


def test_a_number_before_another_sentence_has_no_unit_of_that():
    page = "$m = 0.5$ kg, $g = 10$ m/s².\n\nSo $G = m g = 0.005$. And then $F = 2 m g = 0.01$ kN.\n"
    links = check(page, {}).data()["links"]
    assert links[-3]["verdict"] == "refuted"


@pytest.mark.parametrize(
    ("unit", "words"),
    [("kg mm", ("holds", "holds_to_order")), ("kg m", ("refuted",)), ("g mm", ("refuted",))],
)
def test_a_unit_behind_a_sum_of_numbers_put_in_is_compared(tmp_path, unit, words):
    page = (
        "m = 0.563 kg, p = 0.545 kg, r = 33 mm.\n\n$(m + p/2) r = (0.563 + 0.2725) \\cdot 33 = 27.57$ {}"
    )
    assert last_verdict(tmp_path, page.format(unit)) in words
