"""Pages of mails and notes whose verdicts are known: degrees without a sign, quotations, units."""

import pytest

from symbalance.checking import check

PAGES = {
    "cranks.txt": (
        "For the twin cos(t) + cos(t+180) = 0, for the triple\n"
        "  cos(t) + cos(t+120) + cos(t+240) = 0\n"
        "  cos(t+120) + cos(t+240) = cos(t)\n",
        ["holds", "holds", "refuted"],
    ),
    "radians.txt": ("sin(15) = 0.650 and cos(30) = 0.154\n", ["holds_to_order", "holds_to_order"]),
    "program.md": (
        "The sum is `cos(120) + cos(240) = -1`.\n\n```python\nassert math.cos(120) == 0.814\n```\n",
        ["holds"],
    ),
    "mail.txt": (
        "  F = 8636/4 = 4318 N\n\nBob wrote:\n> F = 4318 N\nNo:\n  G = 8636/4 = 2159 N\n",
        ["definition", "refuted", "refuted", "definition", "holds"],
    ),
    "heading.txt": ("=== Forum > Cranks ===\n\n  k = 45/180 = 0.25\n", ["definition", "holds"]),
    "masses.md": (
        "$m = 180$ g $= 0.180$ kg and $p = 5$ bar $= 5\\cdot10^4$ Pa\n",
        ["definition", "holds", "definition", "refuted"],
    ),
    "mass_of_a_pin.txt": (
        "numbers: r = 33 mm, m = 0.45 kg, mr = 0.60 kg, w = 628.3 1/s\nmrw² = 5862 N\n",
        ["definition", "definition", "definition", "definition", "holds_to_order"],
    ),
    "product_in_a_list.txt": (
        "m = 3 kg, r = 2 m, mr = 6 kg\nmr = 7 kg m\n",
        ["definition", "definition", "refuted", "refuted"],
    ),
    "units_that_are_letters.txt": (
        "Contrepoids mg à rg : r = 40 mm, m = 0,5 kg, mr = 0,8 kg, rg = 50 mm\n"
        "mg·rg = (m + mr)·r\nmg = (m + mr)·r/rg = 1,04 kg\nmg = (m + mr)·r/rg = 1,2 kg\n",
        [*["definition"] * 5, "conditional", "holds", "conditional", "refuted"],
    ),
    "components.txt": (
        "FV1 = m*r*w^2*cos(phi)\nFH1 = m*r*w^2*sin(phi)\nFR = sqrt(FV1^2 + FH1^2) = 2*m*r*w^2\n",
        ["definition", "definition", "definition", "refuted"],
    ),
    "work_of_a_gas.txt": ("P = 3 Pa, V1 = 2 m³\nPV1 = 6 J\n", ["definition", "definition", "holds"]),
    "factors_side_by_side.txt": (
        "F = 2 lam m r w^2 sin(2 phi)/sqrt(2)\n    = sqrt(2) lam m r w^2 sin(2 phi)\n"
        "    = m r w^2 sqrt(2) sin(2 phi) lambda\n    = 2 lam m r w^2 sin(2 phi)\n",
        ["definition", "holds", "holds", "refuted"],
    ),
    "unknown_factor.txt": (
        "F = 2 q m r w^2 sin(2 phi)/sqrt(2)\n    = sqrt(2) kue m r w^2 sin(2 phi)\n",
        ["definition", "unreadable"],
    ),
    "no_slope.txt": (
        "FV = m*r*w²*cos(t)\nFH = m*r*w²*sin(t) = 0\nF = m*r*w²*cos(t)\ndF/dt = -m*r*w²*sin(t) = 0\n",
        ["definition", "definition", "undecided", "definition", "holds", "condition"],
    ),
    "shaft.txt": (
        "A shaft of D = 2.5 in. under T = 12000 lb.-in. has\n\n"
        "     f = 16 T / (3.1416 D³) = 3911 lb. per\nsquare inch.\n",
        ["definition", "definition", "definition", "holds_to_order"],
    ),
    "wrong_twice.txt": (
        "r = 4 ft., N = 90 revolutions per minute\n\n     v = 2 × 3.1416 r N / 60\n\n"
        "     v = 0.1047 × 4 × 90 = 73.7 ft. per sec.\n",
        ["definition", "definition", "definition", "conditional", "refuted"],
    ),
}


@pytest.mark.parametrize("name", PAGES)
def test_a_page_has_the_verdicts_that_are_known(name, tmp_path):
    text, verdicts = PAGES[name]
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    assert [v.verdict for v in check(path).verdicts] == verdicts


def test_the_report_says_in_which_unit_angles_are_read():
    degrees = check("  cos(t) + cos(t+120) + cos(t+240) = 0\n").derivation.notes
    assert any("read in degrees" in note for note in degrees)
    assert not any("degrees" in note for note in check("  cos(t+2) = cos(t+2)\n").derivation.notes)


def test_a_quotation_says_which_line_it_repeats():
    *_, quoted = check("  F = 8636/4 = 4318 N\n\n> F = 4318 N\n").verdicts
    assert quoted.reason == "quotes line 1, which is refuted"
