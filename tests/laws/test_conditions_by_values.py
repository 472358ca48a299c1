"""What holds on a condition only is true or false where the page gives every letter its number."""

import pytest

from symbalance.notes.checking import check

A_BELOW_B = "$a = 3$, $b = 5$\n\n"


def last_word(page: str) -> tuple[str, str]:
    checked = check(page + "\n", {})
    verdict = max(checked.verdicts, key=lambda v: (v.line, v.span))
    return verdict.verdict, verdict.reason


@pytest.mark.parametrize(
    "page",
    [
        A_BELOW_B + r"$\sqrt{(a-b)^2} = a-b$",
        r"$x = 2 - 5$" + "\n\n" + r"$|x| = x$",
        r"$x + 5 = 2$" + "\n\n" + r"$\sqrt{x^2} = x$",
        r"$x = \cos 120°$" + "\n\n" + r"$|x| = x$",
        r"For $θ = 150°$:" + "\n\n" + r"$\sqrt{\cos^2θ} = \cosθ$",
        r"Für $θ = 150°$ gilt" + "\n\n" + r"$$\sqrt{\cos^2θ} = \cosθ$$",
        r"Let $φ = 150°$. Then" + "\n\n" + r"$\sqrt{1-\sin^2φ} = \cosφ$",
        r"For $θ = 150°$ we have $\sqrt{\cos^2θ} = \cosθ$.",
    ],
)
def test_a_condition_that_the_numbers_deny_refutes(page):
    word, reason = last_word(page)
    assert (word, "it holds if" in reason) == ("refuted", True)


@pytest.mark.parametrize(
    "page",
    [
        "$a = 5$, $b = 3$\n\n" + r"$\sqrt{(a-b)^2} = a-b$",
        A_BELOW_B + r"$\sqrt{(a-b)^2} = b-a$",
        A_BELOW_B + r"In general $\sqrt{(a-b)^2} = a-b$.",
        A_BELOW_B + r"For $a \ge b$ we have $\sqrt{(a-b)^2} = a-b$.",
        "# Example\n\n" + A_BELOW_B + "# In general\n\n" + r"$\sqrt{(a-b)^2} = a-b$",
        "$a = 1.00$, $b = 1.00$\n\n" + r"$\sqrt{(a-b)^2} = a-b$",
        r"For $θ = 150°$ we have $\sqrt{\cos^2θ} = -\cosθ$.",
        r"For $θ = 150°$ the force is $F = 3$ N." + "\n\n" + r"The rod: $\sqrt{1-\sin^2θ} = \cosθ$.",
        r"Engine A has $a = 3$, $b = 5$. Engine B has $a = 7$, $b = 5$." + "\n\n" + r"$|a-b| = a-b$",
    ],
)
def test_a_condition_that_other_values_satisfy_stays_one(page):
    assert last_word(page)[0] == "conditional"
