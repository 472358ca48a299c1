"""The letter that an integral, a derivative or a sum runs over is no place for a slip."""

import pytest

from symbalance.checking import check
from symbalance.document import formula
from symbalance.document.formula import Name
from symbalance.notes.checking.repair.edits import edits, parents_of

BODY = 350 * formula.Call("sin", 2 * Name("theta"))
ZERO, ONE = formula.number(0), formula.number(1)


@pytest.mark.parametrize(
    "node",
    [
        formula.Integral(BODY, Name("theta"), ZERO, ONE),
        formula.Derivative(BODY, Name("theta")),
        formula.Summation(BODY, Name("theta"), ZERO, ONE),
        formula.IndexedProduct(BODY, Name("theta"), ZERO, ONE),
        formula.Evaluation(BODY, Name("theta"), ONE, ZERO),
        formula.Limit(BODY, Name("theta"), ZERO),
        formula.Extremum("max", BODY, Name("theta")),
    ],
)
def test_what_a_formula_runs_over_stays_a_letter(node):
    parents = parents_of(node)
    changed = [edit.applied(parents) for edit in edits(node, ["r", "theta"], ())]
    assert any(each != node for each in changed)
    for each in changed:
        for part in formula.walk(each):
            if type(part) is type(node):
                running = part.index if hasattr(part, "index") else part.variable
                assert running == Name("theta")


PAGE = r"""Le rayon de manivelle est $r = 42$ mm, la longueur de bielle $l = 147$ mm, $\lambda = r/l$,
$\theta$ l'angle de manivelle et $\omega$ la vitesse angulaire. Pour le piston
$$ \dot x = -r\omega\left(\sin\theta + \frac{\lambda}{2}\sin 2\theta\right). $$
La variation d'énergie cinétique entre les deux vitesses extrêmes est
$$ E = \int_0^{\pi/2} 350\sin 2\theta\,d\theta
= 350\left[-\frac{\cos 2\theta}{2}\right]_0^{\pi/2} = VALUE. $$
"""


@pytest.mark.parametrize(("value", "verdict"), [("350", "holds"), ("175", "refuted")])
def test_an_integral_named_like_a_motion_is_judged(value, verdict):
    links = check(PAGE.replace("VALUE", value)).data()["links"]
    assert not any("fault of symbalance" in str(link.get("reason")) for link in links)
    assert links[-1]["verdict"] == verdict
