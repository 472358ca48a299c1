"""What small pages come to, idea by idea: right lines pass, wrong ones do not, and others stay alone."""

import pytest

from symbalance.checking import check

SIZES = {"r": "crank radius", "l": "rod length", "lambda": "rod ratio r/l"}
FORCES = {"r": "crank radius", "m": "reciprocating mass", "omega": "angular speed", "F_1": "N"}
ACCELERATION = {"l": "rod length", "a": "piston acceleration", "b": "mm"}
TABLE = "| quantity | symbol | value |\n|---|---|---|\n| radius | $r$ | 45 mm |\n| rod | $l$ | 150 mm |\n"
SECOND_RADIUS = "| radius | $r$ | 50 mm |\n"
GIVEN = "$m = 0.72$ kg, $r = 0.045$ m, $\\omega = 377$ 1/s.\n\n"
WRONG_FORCE = "$m = 0.72$ kg, $r = 0.045$ m, $\\omega = 300$ 1/s.\n\n$$F_1 = m r \\omega^2 = 2961$$\n\n"
BEARING = "Here $a = 88$ mm and $l = 200$ mm, so\n\n"
WORK = "$x = \\sin\\theta$, $F = 2$.\n\n$$T d\\theta = F dx$$\n\n"
TURN = {"theta": "angle", "x": "number", "T": "number"}
X, ANGLE, BARE = {"x": "number"}, {"x": "angle"}, {"omega": "number", "N": "number"}
SYSTEM = "\\[\\begin{cases} a + b = 5 \\\\ a - b = 1 \\end{cases}\\]\n\nso $a = 3$ and "
BOTH = {"a": "number", "b": "number"}

LAST = {
    "a table's values are put in": (TABLE + "\n$$\\frac r l = 0.3$$", SIZES, "holds"),
    "a wrong ratio of a table's values": (TABLE + "\n$$\\frac r l = 0.4$$", SIZES, "refuted"),
    "two values of one letter are none": (
        TABLE + SECOND_RADIUS + "\n$$\\frac r l = 0.4$$",
        SIZES,
        "condition",
    ),
    "a wrong result is gone on with": (
        WRONG_FORCE + "$$0.3 F_1 = 0.3 \\cdot 2961 = 888.3$$",
        FORCES,
        "holds",
    ),
    "a second slip is not excused": (
        WRONG_FORCE + "$$0.3 F_1 = 0.3 \\cdot 2961 = 988.3$$",
        FORCES,
        "refuted",
    ),
    "a distance called a": (BEARING + "$$b = l - a = 112\\,\\mathrm{mm}$$", ACCELERATION, "holds"),
    "a wrong distance called a": (
        BEARING + "$$b = l - a = 122\\,\\mathrm{mm}$$",
        ACCELERATION,
        "refuted",
    ),
    "N is a letter": ("ω = 2πN/60 = 0.10472 N\n", BARE, "holds_to_order"),
    "N is a letter, the factor wrong": ("ω = 2πN/60 = 0.20472 N\n", BARE, "refuted"),
    "N is newton": ("$$F = m a = 2\\cdot 3 = 6 N$$", {"F": "N", "m": "kg", "a": "m/s^2"}, "holds"),
    "a case": ("$y = \\cos x$. For $x = 0$ we have $y = 1$.", ANGLE, "conditional"),
    "a case is not all values": (
        "For $x = 0$ we have $\\cos x = 1$. In general $\\cos x = 1$.",
        ANGLE,
        "refuted",
    ),
    "what is true of all values": (
        "For $x = 0$ we have $x = 0$. In general $\\cos(-x) = \\cos x$.",
        ANGLE,
        "holds",
    ),
    "a wider range follows": ("$x > 3$, hence $x > 2$.", X, "range"),
    "a narrower range does not": ("$x > 3$, hence $x > 5$.", X, "refuted"),
    "no word says that it follows": ("$x > 3$. And $x > 5$.", X, "range"),
    "an equivalence": ("$$x - 1 = 4 \\Leftrightarrow x = 5$$", X, "holds"),
    "an equivalence that loses a root": ("$$x^2 = 4 \\Leftrightarrow x = 2$$", X, "refuted"),
    "a converse": ("$$x = 1 \\Leftarrow x^2 = 1$$", X, "refuted"),
    "a result put in": (
        GIVEN + "$$r\\omega^2 = 6396$$\n\n$$m r\\omega^2 = 0.72 \\cdot 6396$$",
        FORCES,
        "holds_to_order",
    ),
    "a mistyped result put in": (
        GIVEN + "$$r\\omega^2 = 6396$$\n\n$$m r\\omega^2 = 0.72 \\cdot 6936$$",
        FORCES,
        "refuted",
    ),
    "a root of a negative letter": ("With $x < 0$: $$\\sqrt{x^2} = -x$$", X, "conditional"),
    "its sign forgotten": ("With $x < 0$: $$\\sqrt{x^2} = x$$", X, "refuted"),
    "work of a turn": (WORK + "$$T = 2\\cos\\theta$$", TURN, "holds"),
    "work of a turn, wrong": (WORK + "$$T = 2\\sin\\theta$$", TURN, "refuted"),
    "a system in a brace": (SYSTEM + "$b = 2$.", BOTH, "conditional"),
    "what contradicts a system": (SYSTEM + "$b = 4$.", BOTH, "contradiction"),
    "what every angle satisfies": ("$$\\forall x: \\sin^2 x + \\cos^2 x = 1$$", ANGLE, "holds"),
    "Greek by name": ("cos(2phi) = 1 - 2*sin(phi)^2\n", {"phi": "angle"}, "holds"),
    "Greek by name, wrong": ("cos(2phi) = 1 - 3*sin(phi)^2\n", {"phi": "angle"}, "refuted"),
    "a name of two letters": (
        "With rG = 2 m and m = 3 kg it is M = m*rG = 6 kg m.\n",
        {"m": "kg"},
        "conditional",
    ),
    "a name of two letters, wrong": (
        "With rG = 2 m and m = 3 kg it is M = m*rG = 7 kg m.\n",
        {"m": "kg"},
        "refuted",
    ),
    "a product without a sign": ("m = 3 kg, r = 2 m, mr = 7 kg m", {"m": "kg", "r": "m"}, "refuted"),
    "a word that multiplies": (
        "Here $F = \\sqrt4$ times $m r$, so $F = 2 m r$.",
        {"m": "kg", "r": "m"},
        "holds",
    ),
    "a word that multiplies, wrong": (
        "Here $F = \\sqrt4$ times $m r$, so $F = 3 m r$.",
        {"m": "kg", "r": "m"},
        "refuted",
    ),
}


@pytest.mark.parametrize("name", LAST)
def test_the_last_relation_of_a_page(name: str) -> None:
    page, symbols, verdict = LAST[name]
    judged = check(page, symbols, fixes=False).verdicts
    assert judged[-1].verdict == verdict, [(v.verdict, v.reason) for v in judged]
