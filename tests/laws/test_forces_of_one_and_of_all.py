"""The force of a whole engine behind words of one cylinder's: "the resultant of second order is"."""

import pytest

from symbalance.checking import check


def last(page: str) -> str:
    return check(page + "\n").data()["links"][-1]["verdict"]


ONE = r"$m r \omega^2\lambda\cos 2\theta$"
PAGES = (
    f"In a four-in-line one cylinder gives the force of second order {ONE}. "
    "The second-order force of the whole engine is $F_2 = {}$.",
    "The four-in-line has cranks at $0^\\circ$, $180^\\circ$, $180^\\circ$ and $0^\\circ$. "
    f"The second-order force of a single cylinder is {ONE}. "
    "The resultant of second order is $F_2 = {}$.",
    f"Beim Reihenvierzylinder liefert jeder Zylinder in der zweiten Ordnung {ONE}. "
    "Die freie Massenkraft zweiter Ordnung ist $F_2 = {}$.",
    f"Dans un quatre cylindres en ligne, chaque piston donne la force du second ordre {ONE}. "
    "La résultante du second ordre est $F_2 = {}$.",
    f"In un quattro cilindri in linea ogni cilindro dà la forza del secondo ordine {ONE}. "
    "La risultante del secondo ordine è $F_2 = {}$.",
    f"En un motor de cuatro cilindros en línea cada pistón da la fuerza de segundo orden {ONE}. "
    "La resultante de segundo orden es $F_2 = {}$.",
    f"直列4気筒では、各気筒の2次慣性力は {ONE} である。機関全体の2次慣性力の合力は $F_2 = {{}}$ である。",
)


@pytest.mark.parametrize("page", [p.replace("{{}}", "{}").replace(ONE, "ONE") for p in PAGES])
def test_the_whole_engine_gives_all_its_cylinders(page: str) -> None:
    for number, verdict in (("4", "conditional"), ("", "refuted"), ("2", "refuted")):
        formula = page.replace("{}", rf"{number} m r \omega^2\lambda\cos 2\theta").replace("ONE", ONE)
        assert last(formula) == verdict
    assert last(page.replace("{}", "0").replace("ONE", ONE)) == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        "The inline four is common. A single-cylinder engine is simple: its resultant "
        "second-order force is {}.",
        "The inline four has four pistons. Each cylinder has a free second-order force {}.",
        "In the inline four each cylinder gives a force of second order. This free force of second order "
        "is {}, and all four are in phase.",
        "Der Reihenvierzylinder hat vier Kolben. Jeder Zylinder hat die freie "
        "Massenkraft zweiter Ordnung {}.",
        "In the inline four each cylinder gives a second-order force. The total second-order force "
        "per cylinder is {}.",
    ],
)
def test_a_force_of_one_cylinder_is_not_accused(page: str) -> None:
    assert last(page.format(r"$F_2 = m r \omega^2\lambda\cos 2\theta$")) != "refuted"
