"""What an undeclared angle may be proves nothing: two rod's angles, or an order of the engine."""

import pytest

from symbalance.checking import check
from symbalance.notes.checking.verdicts import PROVED_WORDS

FALSE_IDENTITIES = (
    r"\cos\alpha-\cos\beta = 2\sin\frac{\alpha+\beta}{2}\,\sin\frac{\alpha-\beta}{2}",
    r"\sin\alpha-\sin\beta = 2\sin\frac{\alpha+\beta}{2}\,\cos\frac{\alpha+\beta}{2}",
    r"\tan(\alpha-\beta) = \sin(\alpha-\beta)\,\cos\alpha\cos\beta",
    r"\sin\alpha\cos\beta = \sin 2\alpha",
)
SINGLE = """Einzylinder. Kurbelwinkel φ, Pleuelwinkel β mit
$\\sin\\beta = \\lambda\\sin\\varphi$, λ = r/l.

Die Kolbenkraft ist $F_K$, die Normalkraft auf die Zylinderwand $F_N = {force}$.
"""


def _last(page):
    return check(page).data()["links"][-1]["verdict"]


@pytest.mark.parametrize("identity", FALSE_IDENTITIES)
def test_a_false_identity_is_true_of_no_rod(identity):
    assert _last(f"Using the identity\n\n$${identity}$$\n") not in PROVED_WORDS


def test_a_force_that_turns_with_the_rod_is_no_order_of_the_engine():
    assert _last(SINGLE.replace("{force}", r"F_K\sin\beta")) not in PROVED_WORDS
    assert _last(SINGLE.replace("{force}", r"F_K\tan\beta")) not in ("refuted", "undecided")
