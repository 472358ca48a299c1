"""Certificates: what a check proves is retraced by a program apart, and a planted fault is rejected."""

from __future__ import annotations

import copy
import json
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

from symbalance.checking import check
from symbalance.cli import run
from symbalance.notes import verify_certificates
from symbalance.notes.checking.reports.certificates import certificates
from symbalance.notes.verify_certificates import Rejected, cyclotomic, is_zero, plus, verify
from tests import ROOT, TESTS

VERIFIER = Path(verify_certificates.__file__)
LETTERS = {
    "theta": "crank angle", "r": "crank radius", "lambda": "rod ratio l/r", "l": "rod length",
    "x": "displacement from top dead centre", "beta": "rod angle", "k": "1",
}  # fmt: skip
PAGE = r"""$$\cos\frac{\pi}{5} = \frac{1+\sqrt 5}{4}$$
$$\cos^3\theta = \frac{3\cos\theta + \cos 3\theta}{4}$$
$$x = r(1-\cos\theta) + l(1-\cos\beta)$$
$$x \approx r(1-\cos\theta) + \frac{r}{4\lambda}(1-\cos 2\theta)$$
$$\frac{2}{3} = 0.6667$$
$$\cos 2\theta = 2\cos^2\theta + 1$$
$$\frac{k}{k+1} + \frac{1}{k+1} = 1$$
"""


@cache
def written() -> list[dict]:
    return json.loads(json.dumps(certificates(check(PAGE, LETTERS))))["certificates"]


def test_every_kind_of_proof_is_retraced():
    proofs = [(c["line"], verify(c)) for c in written()]
    assert proofs == [
        (1, "identity"), (2, "identity"), (3, "identity"), (4, "order"), (5, "digits"), (6, "witness"),
        (7, "identity"),
    ]  # fmt: skip


def faults(certificate: dict) -> list[dict]:
    """A certificate with every number of its sides and values wrong in turn, and other proofs put in."""
    changed = []

    def places(tree: list) -> list[list]:
        inner = [place for part in tree[1:] if isinstance(part, list) for place in places(part)]
        return [tree, *inner] if tree[0] in ("number", "call") else inner

    for key in ("left", "right"):
        for k in range(len(places(certificate[key]))):
            copied = copy.deepcopy(certificate)
            tree = places(copied[key])[k]
            tree[1] = {"sin": "cos", "cos": "sin"}.get(tree[1], tree[1]) if tree[0] == "call" else "7"
            if tree[0] == "number" or tree[1] in ("sin", "cos"):
                changed.append(copied)
    return changed


@pytest.mark.parametrize("k", range(7))
def test_a_fault_in_a_side_is_rejected(k):
    certificate = written()[k]
    planted = faults(certificate)
    assert planted
    for wrong in planted:
        with pytest.raises((Rejected, ArithmeticError)):
            verify(wrong)


def test_a_fault_in_a_premise_is_rejected():
    certificate = copy.deepcopy(written()[2])
    assert certificate["values"]
    for name in certificate["values"]:
        wrong = copy.deepcopy(certificate)
        wrong["values"][name] = ["product", ["number", "2"], wrong["values"][name]]
        with pytest.raises(Rejected):
            verify(wrong)


@pytest.mark.parametrize(
    ("k", "verdict"), [(0, "refuted"), (5, "holds"), (5, "holds_to_order"), (3, "holds")]
)
def test_a_proof_of_something_else_is_rejected(k, verdict):
    with pytest.raises(Rejected):
        verify({**written()[k], "verdict": verdict})


def test_a_witness_must_have_the_values_it_states_and_they_must_differ():
    certificate = written()[5]
    wrong = copy.deepcopy(certificate)
    wrong["witness"]["left"] = "0.123"
    with pytest.raises(Rejected, match="values stated"):
        verify(wrong)
    same = {**certificate, "right": certificate["left"]}
    same["witness"] = {**certificate["witness"], "right": certificate["witness"]["left"]}
    with pytest.raises(Rejected, match="do not differ"):
        verify(same)


def test_an_order_too_high_is_rejected():
    certificate = copy.deepcopy(written()[3])
    certificate["order"]["through"] += 2
    with pytest.raises(Rejected, match="does not fall"):
        verify(certificate)


def test_the_verifier_runs_alone_and_imports_nothing_of_ours(tmp_path):
    source = VERIFIER.read_text(encoding="utf-8")
    assert "symbalance" not in source
    good, bad = tmp_path / "good.json", tmp_path / "bad.json"
    good.write_text(json.dumps({"certificates": written()}), encoding="utf-8")
    bad.write_text(json.dumps({"certificates": [*written(), faults(written()[1])[0]]}), encoding="utf-8")
    for name, code, words in (
        (good, 0, "7 verified"),
        (bad, 1, "1 rejected"),
        (tmp_path, 2, "cannot be read"),
    ):
        command = [sys.executable, "-I", "-S", str(VERIFIER), str(name)]
        done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=tmp_path)
        assert (done.returncode, words in done.stdout + done.stderr) == (code, True)


def test_the_command_writes_them(tmp_path, capsys):
    page = tmp_path / "page.md"
    page.write_text("$$1 + 1 = 2$$\n", encoding="utf-8")
    assert run(["check", str(page), "--certificates", str(tmp_path / "c.json")]) == 0
    assert verify_certificates.main([str(tmp_path / "c.json")]) == 0
    assert "1 verified (1 by identity), 0 rejected" in capsys.readouterr().out
    assert run(["check", str(page), "--certificates", str(tmp_path / "c.txt")]) == 2
    assert run(["check", str(page), str(page), "--certificates", str(tmp_path / "c.json")]) == 2


@pytest.mark.parametrize("n", [1, 2, 12, 15, 105])
def test_cyclotomic_polynomials_divide_and_vanish(n):
    import cmath

    row = cyclotomic(n)
    root = cmath.exp(2j * cmath.pi / n)
    assert abs(sum(c * root**k for k, c in enumerate(row))) < 1e-9
    assert row[-1] == 1


def test_zero_is_decided_exactly():
    one, near = {(): 1}, {(): 1 + 1e-30}
    assert is_zero(plus(one, one, -1))
    from fractions import Fraction

    assert not is_zero({(): Fraction(1, 10**40)})
    assert near


@pytest.mark.slow
def test_most_verdicts_of_the_pages_of_known_truth_are_certified():
    counts = {"nothing": 0}
    pages = [
        ROOT / "derivations/checked/000_6d19e3a8fb7bcb72.txt",
        *sorted((TESTS / "hand").glob("*.tex")),
    ]
    for page in pages:
        for certificate in json.loads(json.dumps(certificates(check(page, fixes=False))))["certificates"]:
            proof = verify(certificate)
            counts[proof] = counts.get(proof, 0) + 1
            assert proof != "nothing" or certificate["why"]
    certified = sum(counts.values()) - counts["nothing"]
    # What rests on words, such as a trial motion, has no certificate; pages of vibrations have many.
    assert certified >= 2 / 3 * sum(counts.values()), counts
