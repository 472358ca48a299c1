"""The range in brackets behind a numbered case in plain prose is read: Case 1 (x > 0): |x| = x."""

from __future__ import annotations

import pytest

from tests.checked_pages import verdicts_of

RIGHT = [
    "Case 1 (x > 0): |x| = x\n\nCase 2 (x < 0): |x| = -x",
    "Case 1. (x > 0): |x| = x. Case 2. (x < 0): |x| = -x.",
    "Fall 2 (x < 0): |x| = -x",
    "Cas 1 (x > 0) : |x| = x",
    "場合1 (x > 0): |x| = x",
    "In case 1 (x = 0) we have |x| = 0.",
]
WRONG = ["Case 1 (x < 0): |x| = x", "Caso 1 (x > 0): |x| = -x"]


@pytest.mark.parametrize("page", RIGHT)
def test_each_case_holds_in_its_range(tmp_path, page):
    assert {*verdicts_of(tmp_path, page)} <= {"range", "conditional", "definition", "premise"}


@pytest.mark.parametrize("page", WRONG)
def test_what_fails_there_is_refuted(tmp_path, page):
    assert verdicts_of(tmp_path, page) == ["range", "refuted"]
