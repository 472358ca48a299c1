"""One balance shaft that runs backwards takes half of what swings: never the whole of it."""

import pytest

from symbalance.checking import check

THREE = (
    "# Inline three\n\nReciprocating mass m, crank radius r, speed ω, distance of cylinders a."
    " The primary couple has the amplitude $M_1 = \\sqrt{3}\\, m r \\omega^2 a$. "
)
BACKWARD = (
    "Its forward half is balanced by the crank webs. A single balance shaft turning backwards at crank"
    " speed takes the other half, by two weights $m_b$ at the radius $r_b$, the distance $b$ apart:\n\n"
)
GERMAN = (
    "# Einzylinder\n\nOszillierende Masse $m_o$, Kurbelradius $r$. Die Massenkraft erster Ordnung ist"
    " $F_1 = m_o r\\omega^2\\cos\\varphi$. Das Gegengewicht gleicht ihre Hälfte aus. Eine"
    " einzige Ausgleichswelle, die mit Kurbeldrehzahl rückwärts läuft, hebt den Rest auf:\n\n"
)
FRENCH = (
    "# Monocylindre\n\nLa force du premier ordre est $F = m_a R\\omega^2\\cos\\alpha$. Le contrepoids"
    " équilibre la moitié de la masse alternative. Un seul arbre tournant en sens inverse à la vitesse du"
    " vilebrequin, avec une masse $m_e$ au rayon $r_e$, annule le reste :\n\n"
)
JAPANESE = (
    "# 直列3気筒\n\n往復質量 m、クランク半径 r、気筒間隔 a。1次の偶力の振幅は\n\n　M1 = √3 m r ω² a\n\n"
    "半分の正回転分はウェイトで消す。逆回転のバランサーシャフト1本が受け持つ偶力は\n\n　"
)
PLAIN = (
    "The primary force of the single is F = m*r*w^2*cos(t). Half of m is balanced at the crank and\n"
    "one contra-rotating balance shaft geared 1:1 does the rest, with mb at radius rb:\n\n   "
)
BOTH = "Two counter-rotating shafts could cancel it, which together give the couple\n\n"
IN_ALL = (
    "It splits in two halves. The shaft that runs backwards cancels one; its two weights have the"
    " unbalance $U$ in total and stand the distance $b$ apart:\n\n"
)
RIGHT = [
    THREE + BACKWARD + r"$m_b r_b b = \frac{\sqrt{3}}{2} m r a$",
    THREE + BACKWARD + r"$m_b r_b b\,\omega^2 = \frac{\sqrt3}{2} m r\omega^2 a$",
    GERMAN + r"$U_A = \tfrac12 m_o r$",
    FRENCH + r"$m_e r_e\omega^2 = \tfrac12 m_a R\omega^2$",
    JAPANESE + "MB = (√3/2) m r ω² a",
    PLAIN + "mb = m*r/(2*rb)",
]
WRONG = [
    THREE + BACKWARD + r"$m_b r_b b = \sqrt{3}\, m r a$",
    THREE + BACKWARD + r"$m_b r_b b\,\omega^2 = \sqrt3\, m r\omega^2 a$",
    GERMAN + r"$U_A = m_o r$",
    FRENCH + r"$m_e r_e\omega^2 = m_a R\omega^2$",
    JAPANESE + "MB = √3 m r ω² a",
    PLAIN + "mb = m*r/rb",
]
OPEN = [
    THREE + BOTH + r"$M_B = \sqrt{3}\, m r \omega^2 a$",
    THREE + IN_ALL + r"$U b = \sqrt3 m r a$",
    THREE
    + r"The rotating masses $m_r$ are balanced at the webs:"
    + "\n\n"
    + r"$m_c r_c b = \sqrt3 m_r r a$",
]


def last(page: str) -> str:
    return check(page + "\n").data()["links"][-1]["verdict"]


@pytest.mark.parametrize("page", RIGHT)
def test_half_of_it_is_right(page: str) -> None:
    assert last(page) == "conditional"


@pytest.mark.parametrize("page", WRONG)
def test_the_whole_of_it_is_refuted(page: str) -> None:
    assert last(page) == "refuted"


@pytest.mark.parametrize("page", OPEN)
def test_several_shafts_or_both_weights_together_are_not_accused(page: str) -> None:
    assert last(page) != "refuted"


def test_what_is_solved_from_a_wrong_line_is_not_refuted_once_more() -> None:
    page = THREE + BACKWARD + "$U b\\omega^2 = \\sqrt3 m r\\omega^2 a$\n\n$U = \\sqrt3 m r a/b$\n"
    assert [link["verdict"] for link in check(page).data()["links"]].count("refuted") == 1
