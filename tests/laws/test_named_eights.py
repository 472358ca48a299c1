"""Free forces and couples of a V8 that words name with the plane of its crankshaft."""

import pytest

from symbalance.checking import check

SIZES = {
    "en": "The reciprocating mass per cylinder is m, the crank radius r, λ = r/l, the angular speed ω,"
    " the distance of neighbouring cranks a.\n\n",
    "ja": "往復質量 m(1気筒)、クランク半径 r、λ = r/l、角速度 ω、気筒の間隔 a。\n\n",
    "de": "Die oszillierende Masse je Zylinder sei m, der Kurbelradius r, λ = r/l,"
    " die Winkelgeschwindigkeit ω, der Zylinderabstand a.\n\n",
}
RIGHT = {
    "en": (
        "For the cross-plane V8 the second-order couple vanishes: M_2 = 0.",
        "The cross-plane V8 has a free first-order couple M_1 = √10 m r ω² a.",
        "In the 90° cross-plane V8 the first-order couple is M_1 ≈ 3.16 m r ω² a.",
        "The flat-plane V8 has a free second-order force F_2 = 4√2 λ m r ω².",
        "## Flat-plane V8\n\nThe first-order couple is M_1 = 0.",
    ),
    "de": (
        "Der Crossplane-V8 hat keine freien Kräfte zweiter Ordnung, F_II = 0.",
        "Der V8 mit ebener Kurbelwelle hat die freie Massenkraft zweiter Ordnung F_II = 4√2 λ m r ω².",
    ),
    "ja": ("■ V8(クロスプレーン)\n\n2次の偶力は\n\n  M2 = 0",),
}
WRONG = {
    "en": (
        "For the cross-plane V8 (90°) the second-order couple is M_2 = √2 λ m r ω² a.",
        "The cross-plane V8 has a free first-order couple M_1 = √5 m r ω² a.",
        "For the cross-plane V8 the free first-order couple vanishes: M_1 = 0.",
        "The flat-plane V8 has a free second-order force F_2 = 8 λ m r ω².",
        "For the flat-plane V8 the second-order forces cancel: F_2 = 0.",
    ),
    "de": ("Der Crossplane-V8 hat die freie Kraft zweiter Ordnung F_II = 8 λ m r ω² cos 2φ.",),
    "ja": ("■ 90°V8(クロスプレーン)\n\n2次の力は消え、2次の偶力は\n\n  M2 = √2 λ m r ω² a",),
}
OPEN = {
    "en": (
        "In the flat-plane V8 each bank has the second-order force F_2 = 4 λ m r ω².",
        "The cross-plane V8's first-order couple is taken by counterweights: M_1 = 0.",
        "The 72° cross-plane V8 has a second-order force F_2 = λ m r ω².",
        "The V8 has the second-order force F_2 = 4√2 λ m r ω².",
        "A cross-plane V8 and a flat-plane V8 differ: the second-order force is F_2 = 0.",
        "The flat-plane V8 is two inline fours, one of which has a second-order force F_2 = 4 λ m r ω².",
    ),
    "de": ("Beim Crossplane-V8 gleichen Gegengewichte das Moment erster Ordnung aus: M_I = 0.",),
    "ja": ("■ V8(クロスプレーン)\n\n1次の偶力はカウンターウェイトで消え、M1 = 0",),
}


def last(language: str, page: str) -> str:
    return check(SIZES[language] + page + "\n").data()["links"][-1]["verdict"]


def pages(of: dict[str, tuple[str, ...]]) -> list[tuple[str, str]]:
    return [(language, page) for language, each in of.items() for page in each]


@pytest.mark.parametrize(("language", "page"), pages(RIGHT))
def test_what_its_cranks_give_is_right(language: str, page: str) -> None:
    assert last(language, page) == "conditional"


@pytest.mark.parametrize(("language", "page"), pages(WRONG))
def test_another_size_is_refuted(language: str, page: str) -> None:
    assert last(language, page) == "refuted"


@pytest.mark.parametrize(("language", "page"), pages(OPEN))
def test_a_part_a_balanced_or_another_one_is_open(language: str, page: str) -> None:
    assert last(language, page) in ("definition", "premise", "undecided")
