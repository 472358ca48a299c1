"""What a sentence has as formulas alone is what the next one makes a resultant or a balance of."""

from __future__ import annotations

import pytest

from tests.checked_pages import verdicts_of

COMPONENTS = (
    r"The force is $a r\omega^2\cos\theta$ along and $b r\omega^2\sin\theta$ across the axis. "
    r"The resultant is $F = VALUE$."
)
SHAFTS = (
    r"Two counter-rotating shafts, each with the unbalance $u q$, turn at $2\omega$. "
    r"They have to cancel $4\lambda m r\omega^2\cos 2\theta$. Each of them needs $u q = VALUE$."
)
WELLEN = (
    r"Zwei gegenläufige Wellen mit der Drehzahl $2\omega$ und je der Unwucht $u q$ sollen die "
    r"Kraft mit der Amplitude "
    r"$4\lambda m r\omega^2$ tilgen. Dann ist $u q = VALUE$."
)
CASES = [
    (COMPONENTS, r"r\omega^2\sqrt{a^2\cos^2\theta + b^2\sin^2\theta}", True),
    (COMPONENTS, r"r\omega^2\sqrt{b^2\cos^2\theta + a^2\sin^2\theta}", False),
    (COMPONENTS, r"r\omega^2 (a\cos\theta + b\sin\theta)", False),
    (SHAFTS, r"\frac{\lambda m r}{2}", True),
    (SHAFTS, r"\lambda m r", False),
    (SHAFTS, r"2\lambda m r", False),
    (WELLEN, r"\frac{1}{2}\lambda m r", True),
    (WELLEN, r"\frac{1}{4}\lambda m r", False),
]


@pytest.mark.parametrize(("page", "value", "is_right"), CASES)
def test_the_forces_of_the_sentence_decide(tmp_path, page, value, is_right):
    last = verdicts_of(tmp_path, page.replace("VALUE", value))[-1]
    assert (last != "refuted") is is_right


def test_components_in_one_line_are_left(tmp_path):
    page = COMPONENTS.replace("across", "along").replace(
        "VALUE", r"r\omega^2 (a\cos\theta + b\sin\theta)"
    )
    assert "refuted" not in verdicts_of(tmp_path, page)
