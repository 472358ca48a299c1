"""What a page rounds on the way to a result explains that result, and no more than that is forgiven."""

import pytest

from symbalance.checking import check


def _verdicts(page: str) -> list[str]:
    return [link["verdict"] for link in check(page).data()["links"]]


SUMS = (
    "    Je = 0.030*1^2 + 0.042*2.434 + 1.85*0.093^2\n    Je = {} kg m^2\n",
    "With J1 = 0.030 kg m^2, m = 0.042 kg, r = 1.56 m and J2 = 0.0163 kg m^2:\n\n"
    "    Je = J1 + m*r^2 + J2 = {} kg m^2\n",
    "Das Trägheitsmoment ist $J = 0{{,}}030·1^2 + 0{{,}}042·2{{,}}434 + 1{{,}}85·0{{,}}093^2$ kg m².\n\n"
    "Also $J = {}$ kg m².\n",
)


@pytest.mark.parametrize("page", SUMS)
@pytest.mark.parametrize(
    ("terms", "is_right"),
    [
        ("0.030 + 0.102 + 0.016 = 0.148", True),
        ("0.03 + 0.10 + 0.016 = 0.146", True),
        ("0.030 + 0.112 + 0.016 = 0.158", False),
        ("0.030 + 0.102 + 0.018 = 0.150", False),
        ("0.030 + 0.102 - 0.016 = 0.116", False),
        ("0.030 + 0.102 + 0.016 = 0.184", False),
    ],
)
def test_each_term_of_a_sum_is_rounded_for_itself(page, terms, is_right):
    typed = terms.replace(".", "{,}") if "{{" in page else terms
    assert ("refuted" not in _verdicts(page.format(typed))) == is_right
