"""What is congruent differs by whole multiples of the modulus typed behind it, and is not equal."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

CASES = [
    ("x.txt", "13 ≡ 1 (mod 4)", ["holds"]),
    ("x.txt", "13 ≡ 2 (mod 4)", ["refuted"]),
    ("x.txt", "900° ≡ 180° (mod 720°)", ["holds"]),
    ("x.txt", "900° ≡ 540° (mod 720°)", ["refuted"]),
    ("x.txt", "θ + 720° ≡ θ (mod 720°)", ["holds"]),
    ("x.txt", "480° ≡ 840° ≡ 120° modulo 360°", ["holds", "holds"]),
    ("x.txt", "480° ≡ 830° ≡ 120° modulo 360°", ["refuted", "refuted"]),
    ("x.txt", "n ≡ 1 (mod 4)\n\nn = 1", ["premise", "definition"]),
    ("x.md", r"$\theta + 4\pi \equiv \theta \pmod{4\pi}$", ["holds"]),
    ("x.md", r"$\theta + 2\pi \equiv \theta \pmod{4\pi}$", ["undecided"]),
    ("x.md", r"$900^\circ \equiv 180^\circ \mod 720^\circ$", ["holds"]),
    ("x.md", r"$900^\circ \equiv 540^\circ$ modulo $720^\circ$", ["refuted"]),
    ("x.md", r"$900^\circ \equiv 180^\circ$", ["conditional"]),
    ("x.md", r"$7 \equiv 3 \pmod{p+1}$", ["unreadable"]),
    ("x.txt", "480° ≡ 120° (modulo a full turn)", ["holds"]),
    ("x.txt", "480° ≡ 130° (modulo a full turn)", ["refuted"]),
    ("x.txt", "7 ≡ 3 (mod p+1)", ["undecided"]),
]


@pytest.mark.parametrize(("name", "text", "words"), CASES)
def test_a_congruence_is_judged_by_its_modulus(tmp_path, name, text, words):
    page = tmp_path / name
    page.write_text(f"{text}\n", encoding="utf-8")
    assert [verdict.verdict for verdict in check(page, fixes=False).verdicts] == words
