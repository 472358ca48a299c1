r"""What is true of numbers is not said of what a page sets as vectors and "
r"matrices: \mathbf{A}, \vec a."""

import pytest

from symbalance.checking import check

PROVED = ("holds", "holds_to_order", "conditional")
ACCUSED = ("refuted", "contradiction")


def words_of(page: str) -> list[str]:
    return [link["verdict"] for link in check(page + "\n", fixes=False).data()["links"]]


@pytest.mark.parametrize(
    "page",
    [
        r"$(\mathbf{A}\mathbf{B})^T = \mathbf{A}^T\mathbf{B}^T$",
        r"$(\mathbf{M}^T \mathbf{K})^T = \mathbf{M} \mathbf{K}^T$",
        r"$(\boldsymbol{P}\boldsymbol{Q})^{T} = \boldsymbol{P}^T\boldsymbol{Q}^T$",
        r"With the mass matrix $\mathbf{M}$ and the modal matrix $\mathbf{\Phi}$: "
        r"$\mathbf{\Phi}^T \mathbf{M} \mathbf{\Phi} = \mathbf{M}\mathbf{\Phi}^T\mathbf{\Phi}$",
        r"Die Massenmatrix: $\mathbf{T}^T\mathbf{M}\mathbf{T} = \mathbf{M}\mathbf{T}^T\mathbf{T}$",
        r"$\mathbf{x}^T\mathbf{A}\mathbf{y} = \mathbf{A}\mathbf{x}^T\mathbf{y}$",
        r"$e^{\mathbf{A}+\mathbf{B}} = e^{\mathbf{A}} e^{\mathbf{B}}$",
        r"Matrices A, B: C = A B, so C A^{-1} = B.",
        r"Matrizen $A$ und $B$: $C = A B$, also $C A^{-1} = B$.",
    ],
)
def test_matrices_do_not_commute(page):
    assert words_of(page)[-1] not in PROVED


@pytest.mark.parametrize(
    "page",
    [
        r"$(\mathbf{A}\mathbf{B})^T = \mathbf{A}^T\mathbf{B}^T$",
        r"$e^{\mathbf{C}+\mathbf{D}} = e^{\mathbf{C}} e^{\mathbf{D}}$",
        r"$\mathbf{Q}^T\mathbf{A}\mathbf{Q} = \mathbf{A}\mathbf{Q}^T\mathbf{Q}$",
        r"For matrices $P$ and $Q$ with $R = P Q$ we have $R P^{-1} = Q$.",
        r"$\vec a \cdot \vec b = |\vec a||\vec b|$",
        r"$|\vec a + \vec b| = |\vec a| + |\vec b|$ for any two vectors.",
        r"$|\vec u-\vec w| = |\vec u|-|\vec w|$",
        r"$|\vec a+\vec b|^2 = |\vec a|^2+|\vec b|^2+2|\vec a||\vec b|$",
        r"$\|x+y\| = \|x\|+\|y\|$",
        r"$\lVert u - v\rVert = \lVert u\rVert - \lVert v\rVert$",
        r"Le produit $(\vec u\cdot\vec v)\vec w = \vec u(\vec v\cdot\vec w)$ est associatif.",
        r"$(\mathbf a\cdot\mathbf b)\mathbf c = \mathbf a(\mathbf b\cdot\mathbf c)$",
        r"$\mathbf{a}\cdot\mathbf{b} = ab$",
        r"$(\vec a\cdot\vec b)^2 = a^2 b^2$",
        r"内積は $\vec p\cdot\vec q = |\vec p||\vec q|$ である。",
    ],
)
def test_a_relation_of_any_arrays_that_fails_is_refuted(page):
    assert words_of(page)[-1] == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        r"$\mathbf{A}^2 - \mathbf{B}^2 = (\mathbf{A}-\mathbf{B})(\mathbf{A}+\mathbf{B})$",
        r"$\mathbf{A} = \mathbf{A}^T$. Now $(\mathbf{A}\mathbf{B})^T = \mathbf{A}^T\mathbf{B}^T$.",
        r"With $\mathbf{K}\mathbf{x} = \mathbf{f}$ follows $\mathbf{x} = \mathbf{f}\mathbf{K}^{-1}$.",
        r"$\mathbf F = \mathbf M \mathbf a$, so $\mathbf a = \mathbf F \mathbf M^{-1}$.",
        r"$\mathbf{K}\mathbf{x} = \mathbf{M}\mathbf{x}\,\omega^2$, so "
        r"$\mathbf{K} = \omega^2 \mathbf{M}$.",
        r"$\mathbf{L} = \mathbf{J}\boldsymbol\omega$, so $\mathbf{J} = \mathbf{L}\boldsymbol\omega^{-1}$",
    ],
)
def test_what_other_lines_or_vectors_may_make_true_is_left_open(page):
    assert words_of(page)[-1] == "undecided"


@pytest.mark.parametrize(
    "page",
    [
        r"$(\mathbf{A}\mathbf{B})^T = \mathbf{B}^T\mathbf{A}^T$",
        r"$(\mathbf{M}^T \mathbf{K})^T = \mathbf{K}^T \mathbf{M}$",
        r"$(\mathbf{A}+\mathbf{B})^T = \mathbf{A}^T+\mathbf{B}^T$",
        r"$\bm{M}^{-1}\bm{M} \bm{x} = \bm{x}$",
        r"With $\mathbf{K}\mathbf{x} = \mathbf{f}$ follows $\mathbf{x} = \mathbf{K}^{-1}\mathbf{f}$.",
        r"$\mathbf F = \mathbf M \mathbf a$, so $\mathbf a = \mathbf M^{-1} \mathbf F$.",
        r"$\mathbf{K}\mathbf{x} = \omega^2\mathbf{M}\mathbf{x}$, so "
        r"$(\mathbf{K} - \omega^2\mathbf{M})\mathbf{x} = \mathbf{0}$",
        r"$\mathbf{M}\ddot{\mathbf{x}} + \mathbf{K}\mathbf{x} = \mathbf{0}$, so "
        r"$\mathbf{M}\ddot{\mathbf{x}} = -\mathbf{K}\mathbf{x}$",
        r"With $\mathbf{A}\mathbf{B} = \mathbf{B}\mathbf{A}$ we have "
        r"$(\mathbf{A}\mathbf{B})^T = \mathbf{A}^T\mathbf{B}^T$",
        r"Matrices A, B: C = A B, so A^{-1} C = B.",
        r"For matrices $P$ and $Q$ with $R = P Q$ we have $P^{-1} R = Q$.",
        r"$\mathbf{F} = m\mathbf{a}$, so $\mathbf{a} = \frac{1}{m}\mathbf{F}$",
        r"$\mathbf{F} = \mathbf{F}_1 + \mathbf{F}_2$, so $\mathbf{F}_1 = \mathbf{F} - \mathbf{F}_2$",
        r"$\mathbf{F} = m\mathbf{a}$ and $\mathbf{M} = \mathbf{r}\times\mathbf{F}$. So "
        r"$\mathbf{a} = \mathbf{F}/m$.",
        r"The power is $P = \mathbf{F}\cdot\mathbf{v}$ with $\mathbf{F} = m\mathbf{a}$, so "
        r"$P = m\mathbf{a}\cdot\mathbf{v}$.",
        r"$P = \mathbf{F}_1\cdot\mathbf{v}$. $\mathbf{F}_1+\mathbf{F}_2+\mathbf{F}_3 = \mathbf{0}$ and "
        r""
        r"$\mathbf{F}_3 = m\mathbf{g}$, so $\mathbf{F}_1 + \mathbf{F}_2 = -m\mathbf{g}$.",
        r"$\mathbf{F} = m\mathbf{a}$ with $m = 2$ kg, $|\mathbf a| = 3$ m/s², $|\mathbf F| = 6$ N",
        r"$\mathbf{P} = 3$ and $\mathbf{Q} = 4$, $\mathbf{P}^2 + \mathbf{Q}^2 = 25$",
        r"$\mathbf{n} = 3000$ rpm and $\mathbf{s} = 80$ mm: $\mathbf{v} = 2\mathbf{s}\mathbf{n} = 8$ m/s",
        r"$|\vec a+\vec b|^2 = |\vec a|^2+|\vec b|^2+2\vec a\cdot\vec b$",
        r"$\vec a\cdot(\vec b + \vec c) = \vec a\cdot\vec b + \vec a\cdot\vec c$",
        r"$|\vec a|^2 = \vec a\cdot\vec a$",
        r"$\vec F = m\vec a$, $|\vec F| = m|\vec a|$",
        r"$\|2x\| = 2\|x\|$",
        r"If $\vec a$ and $\vec b$ are parallel, $\vec a\cdot\vec b = |\vec a||\vec b|$.",
        r"Sind die Vektoren gleichgerichtet, so ist $|\vec u + \vec w| = |\vec u| + |\vec w|$.",
        r"$\vec F_+ = \frac12 m r\omega^2 e^{i\theta}$, $\vec F_- = \frac12 m r\omega^2 e^{-i\theta}$, "
        r"$\vec F_+ + \vec F_- = m r\omega^2\cos\theta$",
    ],
)
def test_what_is_true_of_arrays_too_is_confirmed(page):
    assert words_of(page)[-1] in PROVED


def test_what_is_said_of_the_length_of_a_vector_fixes_nothing():
    page = (
        r"$\mathbf{M}\ddot{\mathbf{x}} + \mathbf{K}\mathbf{x} = \mathbf{f}$ and "
        r"$\vec M = \vec r\times\vec F$."
    )
    assert words_of(page) == ["definition", "definition"]
