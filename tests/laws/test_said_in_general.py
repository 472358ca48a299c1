"""What is said in general stands apart from the case behind it, its exception."""

from __future__ import annotations

import pytest

from tests.checked_pages import verdicts_of

RIGHT = [
    r"In general $\sqrt{a^2+b^2} \ne a+b$. But for $b = 0$, $a>0$: $\sqrt{a^2+b^2} = a$.",
    r"In general $\sqrt{a^2+b^2} \ne a+b$. With $b = 0$, $a>0$ we get $\sqrt{a^2+b^2} = a$.",
    r"$\sqrt{a^2+b^2} \ne a+b$. But for $b = 0$, $a>0$: $\sqrt{a^2+b^2} = a$.",
    r"Im Allgemeinen ist $\sqrt{a^2+b^2} \ne a+b$. Für $b = 0$, $a > 0$ aber ist $\sqrt{a^2+b^2} = a$.",
    r"En général $(a+b)^2 \ne a^2+b^2$. Mais pour $b = 0$, $(a+b)^2 = a^2$.",
    r"In general $\sin 2x \ne 2\sin x$, but for $x = 0$ both are $0$.",
    r"In general $(a+b)^2 \ne a^2+b^2$. Only if $b = 0$ is $(a+b)^2 = a^2+b^2$.",
    "In general $x^2 \\ge x$. But for $x = 0.5$: $x^2 = 0.25$.",
    "In general $\\sin 2x \\ne 2\\sin x$.\nFor $x = 0$ both are $0$.",
]
WRONG = [
    r"In general $\sqrt{a^2+b^2} \ne a+b$. But for $b = 0$, $a>0$: $\sqrt{a^2+b^2} = 2a$.",
    r"In general $(a+b)^2 \ne a^2+2ab+b^2$. But for $b = 0$: $(a+b)^2 = a^2$.",
    r"$b = 0$, $a > 0$. Then $\sqrt{a^2+b^2} \ne a+b$.",
    r"$(a+b)^2 \ne a^2+b^2$ for $b = 0$.",
]


@pytest.mark.parametrize("page", RIGHT)
def test_its_exception_does_not_refute_it(tmp_path, page):
    assert not {"refuted", "contradiction"} & {*verdicts_of(tmp_path, page)}


@pytest.mark.parametrize("page", WRONG)
def test_what_is_wrong_is_refuted(tmp_path, page):
    assert "refuted" in verdicts_of(tmp_path, page)
