"""Old British prints have their decimal points on the middle of the line, 0·0284; 3,000 is 3000 there.

Where the page shows no such number, 2·3 is a product.
"""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

OLD = "The throw is r = 2·25 in., the rod l = 8·5 in., thus r/l = 0·2647, and c = 0·0284.\n\n"
ENGINE = (
    "F₁ is the inertia force, n the speed, r the crank radius, W₁ the weight, v the rubbing speed, d the"
    " pin diameter.\n\nW₁ = 3.5 lb, r = 2.25 in., n = 3,000 rev/min, d = 2.0 in.\n\n"
)
ON_THE_LINE = "Es ist l = 0,5 m.\n\n"

CASES = [
    (OLD + "q = 2,013 × 1·2647 = 2,546", ["holds_to_order"]),
    (OLD + "q = 2,013 × 1·2647 = 2,456", ["refuted"]),
    (OLD + "q = 3,000² = 9,000,000", ["holds"]),
    (OLD + "q = 2·3 + 0·04 = 2·34", ["holds"]),
    (OLD + "q = 2·3 + 0·04 = 2·43", ["refuted"]),
    ("The factor is c = 0·0284 and n = 3,000 rev/min.\n\nq = 2·5 + c = 2·5284", ["holds"]),
    ("The factor is c = 0{\\cdot}0284.\n\nq = 2{\\cdot}5 + c = 2{\\cdot}5284", ["holds"]),
    ("The factor is c = 0{\\cdot}0284.\n\nq = 2{\\cdot}5 + c = 2{\\cdot}2584", ["refuted"]),
    (ON_THE_LINE + "q = 0,5·0,04 = 0,02", ["holds"]),
    (ON_THE_LINE + "q = 2·3·9 = 54", ["holds"]),
    (ON_THE_LINE + "q = 2·3 = 6", ["holds"]),
    (ON_THE_LINE + "q = 2·3 = 5", ["refuted"]),
    ("The rod is l = 0.5 m.\n\nA = 0.5 × 4 = 2.0\n\nq = 2·3 = 6", ["holds"]),
    ("The rod is l = 0.5 m.\n\nA = 0.5 × 4 = 2.0\n\nq = 2·3 = 2.3", ["refuted"]),
    ("The rod is 2 × 4 long.\n\nq = 2·10^3 = 2000", ["holds"]),
    ("The rod is 2 × 4 long.\n\nq = 0·12 + 3·4 = 3·52", ["holds"]),
    ("Two vectors at right angles.\n\nq = 0·12 + 3·4 = 12", ["holds"]),
    (ENGINE + "F₁ = 0.0000284 W₁ r n² = 2,013 lb", ["definition", "conditional"]),
    (ENGINE + "F₁ = 0.0000284 W₁ r n² = 2,310 lb", ["definition", "refuted"]),
    (ENGINE + "v = πdn/12 = 1,571 ft. per min", ["definition", "conditional"]),
    (ENGINE + "v = πdn/12 = 1,751 ft. per min", ["definition", "refuted"]),
    (ENGINE + "v = πdn/10 = 1,885 ft. per min", ["definition", "refuted"]),
]


@pytest.mark.parametrize(("text", "words"), CASES)
def test_a_point_is_a_decimal_sign_where_no_product_can_be_meant(tmp_path, text, words):
    path = tmp_path / "page.txt"
    path.write_text(f"{text}\n", encoding="utf-8")
    verdicts = check(path, fixes=False).verdicts
    assert [v.verdict for v in verdicts][-len(words) :] == words
