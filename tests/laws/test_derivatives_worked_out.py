"""A formula that is differentiated has its derivative everywhere: it is no equation to be solved."""

import pytest

import symbalance as sb

WORDS = ["For the root I used the chain rule:", "Für die Nullstelle brauchen wir", "The maximum follows:"]
RULE = r"$$\frac{d}{d\theta}\sqrt{L^2 - R^2\sin^2\theta} = SIGN\frac{R^2\sin\theta\cos\theta}{ROOT}$$"
ROOT = r"\sqrt{L^2 - R^2\sin^2\theta}"


def _verdicts(page):
    return [each["verdict"] for each in sb.check(page, {}).data()["links"]]


@pytest.mark.parametrize("words", WORDS)
@pytest.mark.parametrize(("sign", "verdict"), [("-", "conditional"), ("", "refuted")])
def test_words_of_roots_and_extremes_make_no_equation_of_a_derivative(words, sign, verdict):
    page = f"{words}\n\n{RULE.replace('SIGN', sign).replace('ROOT', ROOT)}\n"
    assert _verdicts(page) == [verdict]


@pytest.mark.parametrize(
    "page",
    [
        "The slope is as large as $x$ where\n\n$$\\frac{d}{dx}(x^3 - 2x) = x.$$\n",
        "Die Steigung ist $x$, wo\n\n$$\\frac{d}{dx}(x^3 - 2x) = x.$$\n",
        "The slope is 1 where\n\n$$\\frac{d}{dx}(x^3 - 2x) = 1,$$\n\nso $x = 1$.\n",
        "At the root\n\n$$\\frac{d}{dx}(x^3 - 2x) = x,$$\n\nso $x = 1$.\n",
    ],
)
def test_a_derivative_that_has_some_value_somewhere_is_an_equation(page):
    assert _verdicts(page)[0] == "condition"
