r"""Sums over cylinders go over the cranks a page lists: by macros, in a table, in a section above."""

import pytest

import symbalance as sb

MACRO = (
    r"\newcommand{\dg}{^{\circ}}"
    "\n\nThe cranks stand at $\\delta_1,\\delta_2,\\delta_3$ of $0$, $120\\dg$ and $240\\dg$.\n\n"
    "$$\\sum_i \\cos {n}(\\theta+\\delta_i) = {sum}$$\n"
)
TABLE = """== In-line six ==

=== Throws ===
{| class="wikitable"
! cylinder !! 1 !! 2 !! 3 !! 4 !! 5 !! 6
|-
| throw angle ''α''<sub>i</sub> || 0° || 240° || 120° || 120° || 240° || 0°
|}

=== Free forces ===
The force of one cylinder is known. The sums over the cylinders are
: <math>\\sum_i\\cos {n}(\\varphi+\\alpha_i) = {sum}</math>
"""
FLAT = (
    "Flat crank, throws at $0,\\pi,\\pi,0$. The cylinder pitch is $a$.\n\n"
    "* $\\sum_k\\cos {n}\\theta_k = {sum}$\n"
)
EIGHT = (
    "# The V8\n\nThe cross-plane crank has its pins (front to rear) at 0°, 90°, 270° and 180°.\n\n"
    "$$\\sum_k \\cos {n}\\varphi_k = {sum}$$\n"
)
RADIAL = (
    "Let the nine cylinders of the radial be spaced at the angle $\\alpha = 360°/9 = 40°$; the k-th"
    " stands at $k\\alpha$.\n\n$$\\sum_k \\cos {n}(\\theta - k\\alpha)\\cos k\\alpha = {sum}$$\n"
)


def _last(page, order, total):
    return sb.check(page.replace("{n}", order).replace("{sum}", total), {}).data()["links"][-1]["verdict"]


@pytest.mark.parametrize(
    ("page", "order", "right", "wrong"),
    [
        (MACRO, "2", "0", r"3\cos 2\theta"),
        (MACRO, "6", r"3\cos 6\theta", "0"),
        (TABLE, "2", "0", r"2\cos 2\varphi"),
        (TABLE, "6", r"6\cos 6\varphi", r"3\cos 6\varphi"),
        (FLAT, "2", r"4\cos 2\theta", "0"),
        (FLAT, "4", r"4\cos 4\theta", "0"),
        (EIGHT, "2", "0", r"4\cos 2\varphi"),
        (EIGHT, "4", r"4\cos 4\varphi", "0"),
        (RADIAL, "2", "0", r"\frac92"),
        (RADIAL, "1", r"\frac92\cos\theta", "0"),
    ],
)
def test_a_sum_over_the_cranks_listed(page, order, right, wrong):
    assert _last(page, order, right) in ("holds", "conditional")
    assert _last(page, order, wrong) == "refuted"


def test_the_list_of_another_engine_is_not_taken():
    page = (
        "## The three\n\nIts crank throws are at 0°, 120° and 240°.\n\n"
        "## The five-cylinder engine\n\n$$\\sum_i \\cos 3(\\theta+\\delta_i) = 0$$\n"
    )
    assert sb.check(page, {}).data()["links"][-1]["verdict"] != "refuted"


STAR = (
    r"$$\gamma_1 = 0°,\quad \gamma_2 = 90°,\quad \gamma_3 = 270°,\quad \gamma_4 = 180°$$"
    "\n\n$$\\sum_k e^{2i\\gamma_k} = {sum}$$\n\n"
)


@pytest.mark.parametrize(("total", "verdict"), [("0", "holds"), ("4", "refuted")])
def test_a_sum_over_angles_given_one_by_one(total, verdict):
    assert sb.check(STAR.replace("{sum}", total), {}).data()["links"][-1]["verdict"] == verdict


@pytest.mark.parametrize("meaning", ["imaginary unit", "imaginäre Einheit", "虚数単位"])
def test_an_i_may_be_declared_as_the_imaginary_unit(meaning):
    page = STAR.replace("{sum}", "0").replace("2i", "2\\ii")
    page = "\\newcommand{\\ii}{\\mathrm{i}}\n\n" + page
    assert sb.check(page, {"\\ii": meaning}).data()["links"][-1]["verdict"] == "holds"


def test_a_sentence_may_say_other_angles_than_the_page_above():
    page = STAR.replace("{sum}", "0")
    flat = "In the flat shaft ($\\gamma_k$ only 0° and 180°) $\\sum_k e^{2i\\gamma_k} = 4$ instead.\n"
    assert sb.check(page + flat, {}).data()["links"][-1]["verdict"] != "refuted"


FIVE = (
    "The angle of throw $i$ is $\\theta_i = \\theta - \\delta_i$.\n\n"
    "| cylinder $i$ | 1 | 2 | 3 | 4 | 5 |\n|---|---|---|---|---|---|\n"
    "| $\\delta_i$ | 0° | 144° | 216° | 288° | 72° |\n| $z_i$ | $2a$ | $a$ | $0$ | $-a$ | $-2a$ |\n\n"
    "$$\\sum_i {body} = {sum}$$\n"
)


@pytest.mark.parametrize(
    ("body", "right", "wrong"),
    [
        (r"\cos\theta_i", "0", r"\cos\theta"),
        (r"\cos 10\theta_i", r"5\cos 10\theta", "0"),
    ],
)
def test_a_sum_over_angles_given_by_a_rule_and_a_table(body, right, wrong):
    def last(total):
        page = FIVE.replace("{body}", body).replace("{sum}", total)
        return sb.check(page, {}).data()["links"][-1]["verdict"]

    assert last(right) in ("holds", "conditional")
    assert last(wrong) == "refuted"


PLANES = (
    "The flat-plane crank has pins at 0°, 180°, 180° and 0°,"
    " the cross-plane one at 0°, 90°, 270°, 180°.\n\n"
)
SECTIONS = (
    "## Cross-plane\n\nThe crank has its pins at 0°, 90°, 270° and 180°.\n\n"
    "## Flat-plane\n\nThe crank has its pins at 0°, 180°, 180° and 0°. "
)


@pytest.mark.parametrize(
    ("page", "verdicts"),
    [
        (
            PLANES + "For the flat-plane crank $\\sum_k\\cos 2(\\theta+\\alpha_k) = {sum}$.\n",
            ("refuted", "conditional"),
        ),
        (PLANES + "So $\\sum_k\\cos 2(\\theta+\\alpha_k) = {sum}$.\n", ("undecided", "undecided")),
        (
            SECTIONS + "In the cross-plane one $\\sum_k\\cos 2(\\theta+\\alpha_k) = {sum}$.\n",
            ("conditional", "refuted"),
        ),
        (SECTIONS + "So $\\sum_k\\cos 2(\\theta+\\alpha_k) = {sum}$.\n", ("refuted", "conditional")),
    ],
)
def test_of_several_engines_the_one_named_is_meant(page, verdicts):
    for total, verdict in zip(("0", "4\\cos 2\\theta"), verdicts, strict=True):
        assert sb.check(page.replace("{sum}", total), {}).data()["links"][-1]["verdict"] == verdict


ARMS = (
    "| $k$ | 1 | 2 | 3 |\n|---|---|---|---|\n| $\\delta_k$ | 0° | 120° | 240° |\n"
    "| $z_k$ | $a$ | 0 | $-a$ |\n\n"
    "$$\\sum_k z_k\\cos\\delta_k = {sum}$$\n"
)


@pytest.mark.parametrize(("total", "verdict"), [(r"\frac32 a", "conditional"), ("2a", "refuted")])
def test_a_letter_in_a_row_of_arms_is_none_with_a_value(total, verdict):
    page = ARMS.replace("{sum}", total)
    assert sb.check(page, {"a": "cylinder pitch"}).data()["links"][-1]["verdict"] == verdict
