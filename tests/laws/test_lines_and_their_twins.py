"""Short pages with a wrong line, never said to hold, and the same pages right, never refuted."""

from __future__ import annotations

from pathlib import Path

import pytest

from symbalance.notes.checking import check

HELD, ACCUSED = {"holds", "holds_to_order", "conditional"}, {"refuted", "contradiction"}

LETTERS_LIKE_UNITS = {
    "right": [
        r"With the mass $m$ and the stiffness $k$: $(k-m\omega^2)^2 = k^2-2km\omega^2+m^2\omega^4$.",
        r"$(3km)^2 = 9k^2m^2$",
        r"$T = \frac12J\omega^2$ and $L = J\omega$, so $T = \frac{L^2}{2J}$.",
        "Let $c = 3$ and $m=2$. Then $c^2+2cm+m^2 = 25$.",
        "$(m+s)^2 = m^2 + 2ms + s^2$",
        "With $N$ and $m$ integers: $(N+m)^2 - (N-m)^2 = 4Nm$.",
        "$k = 3$, $g = 9.81$, $m = 2$. $ks = 2mg$, so $s = 2mg/k$.",
        "$m = 2$ kg, $k = 3$ N/m. The track has $x = 2km$, so $x = 2000$ m and $3km = 3000$ m.",
        "$m = 0.4$ kg and the stroke $s$; the time is $t = 2ms$, so $t = 0.002$ s.",
        "$k = 3$, $m = 2$, $t = x/v = 2km/(4 m/s) = 500$ s",
    ],
    "wrong": [
        r"With the mass $m$ and the stiffness $k$: $(k-m\omega^2)^2 = k^2+2km\omega^2+m^2\omega^4$.",
        "Let $k=5$ and $m=2$. Then $3km = 3000$.",
        "Let $c = 3$ and $m=2$. Then $c^2+2cm+m^2 = 19$.",
        "$(m+s)^2 = m^2 + 3ms + s^2$",
        "$m = 2$ kg, $k = 3$ N/m. The track has $x = 2km$, so $x = 12$ m.",
    ],
}
IN_TEXT = {
    "right": ["(k - mω²)² = k² - 2km ω² + m² ω⁴", "(c+m)² = c² + 2cm + m²", "L = Jω, T = ½Jω² = L²/(2J)"],
    "wrong": ["(k - mω²)² = k² - 3km ω² + m² ω⁴", "(c+m)² = c² + cm·3 + m²"],
}
MATRICES = {
    "wrong": [
        "Let $A$ and $B$ be matrices. Then $(A+B)(A-B) = A^2-B^2$.",
        "Let $A$ and $B$ be two rotation matrices in space. Then $AB = BA$.",
        "The square of a sum of two matrices is $(A+B)^2 = A^2+2AB+B^2$.",
        "Seien $A$ und $B$ zwei quadratische Matrizen. Dann ist $(AB)^2 = A^2B^2$.",
        "Soient $P$ et $Q$ deux matrices carrées. Alors $(P-Q)^2 = P^2 - 2PQ + Q^2$.",
        r"$A$, $B$ are $n\times n$ matrices, so $(AB)^{-1} = A^{-1}B^{-1}$.",
        "$A$ と $B$ を行列とする。$AB = BA$。",
    ],
    "right": [
        "Let $A$ and $B$ be matrices. Then $(A+B)(A-B) = A^2-AB+BA-B^2$.",
        "Let $A$ and $B$ be two commuting matrices. Then $AB = BA$, hence $(A+B)^2 = A^2+2AB+B^2$.",
        "Seien $A$ und $B$ zwei Diagonalmatrizen. Dann ist $(AB)^2 = A^2B^2$.",
        "Let $R$ and $S$ be rotation matrices about the same axis. Then $RS = SR$.",
        "Let $A$ and $B$ be matrices with $AB = BA$. Then $(A+B)^2 = A^2+2AB+B^2$.",
        r"$A$, $B$ are $n\times n$ matrices, so $(AB)^{-1} = B^{-1}A^{-1}$.",
        "A mass matrix is symmetric. The width is $B$, the area $A$: $A B = B A$.",
    ],
}


def _verdicts(tmp_path: Path, page: str, ending: str = "md") -> list[str]:
    path = tmp_path / f"page.{ending}"
    path.write_text(f"{page}\n", encoding="utf-8")
    return [link["verdict"] for link in check(path, fixes=False).data()["links"]]


@pytest.mark.parametrize("page", LETTERS_LIKE_UNITS["right"])
def test_letters_like_units_are_letters(tmp_path: Path, page: str):
    verdicts = _verdicts(tmp_path, page)
    assert verdicts[-1] in HELD
    assert not ACCUSED & set(verdicts)


@pytest.mark.parametrize("page", LETTERS_LIKE_UNITS["wrong"])
def test_letters_like_units_hide_no_slip(tmp_path: Path, page: str):
    assert _verdicts(tmp_path, page)[-1] in ACCUSED


@pytest.mark.parametrize("page", IN_TEXT["right"])
def test_letters_like_units_in_plain_text(tmp_path: Path, page: str):
    assert _verdicts(tmp_path, page, "txt")[-1] in HELD


@pytest.mark.parametrize("page", IN_TEXT["wrong"])
def test_slips_beside_letters_like_units_in_plain_text(tmp_path: Path, page: str):
    assert not HELD & set(_verdicts(tmp_path, page, "txt")[-1:])


@pytest.mark.parametrize("page", MATRICES["wrong"])
def test_products_of_matrices_do_not_commute(tmp_path: Path, page: str):
    assert _verdicts(tmp_path, page)[-1] in ACCUSED


@pytest.mark.parametrize("page", MATRICES["right"])
def test_right_products_of_matrices_hold(tmp_path: Path, page: str):
    verdicts = _verdicts(tmp_path, page)
    assert verdicts[-1] in HELD
    assert not ACCUSED & set(verdicts)
