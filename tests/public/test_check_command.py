"""`symbalance check`, `sb.check` and `sb.check_equal`: formats, exit codes, declarations, refusals."""

import html
import io
import json
import re
import shutil
import subprocess
from pathlib import Path

import pytest
import sympy as sp

import symbalance as sb
from symbalance.cli import run
from symbalance.notes.checking.verdicts import VERDICTS
from tests.results import example

LETTERS = {
    "theta": "crank angle",
    "r": "crank radius",
    "lambda": "rod ratio l/r",
    "x": "displacement from top dead centre",
    "k": "any",
}
GOOD = r"$$x \approx r(1-\cos\theta) + \frac{r}{4\lambda}(1-\cos 2\theta)$$" + "\n"
BAD = r"$$x \approx r(1-\cos\theta) + \frac{r}{2\lambda}(1-\cos 2\theta)$$" + "\n"
SIDECAR = "[symbols]\n" + "".join(f'{k} = "{v}"\n' for k, v in LETTERS.items())


def written(folder: Path, text: str, sidecar: str = SIDECAR) -> str:
    (folder / "notes.md").write_text(text, encoding="utf-8")
    (folder / "notes.symbols.toml").write_text(sidecar, encoding="utf-8")
    return str(folder / "notes.md")


@pytest.mark.slow
def test_exit_codes(tmp_path, capsys):
    assert run(["check", written(tmp_path, GOOD)]) == 0
    assert run(["check", written(tmp_path, BAD)]) == 1
    assert run(["check", written(tmp_path, r"$$x = \foo$$")]) == 1
    assert run(["check", "--lenient", written(tmp_path, r"$$x = \foo$$" + "\n\n" + GOOD)]) == 0
    assert run(["check", "--lenient", written(tmp_path, r"$$x = \foo$$" + "\n\n" + BAD)]) == 1
    assert run(["check", "--lenient", written(tmp_path, r"$$x = \foo$$")]) == 1  # nothing is judged
    assert run(["check", str(tmp_path / "missing.md")]) == 2
    assert capsys.readouterr().err.count("\n") == 1


@pytest.mark.parametrize("page", ["", "Nothing but prose.\n"])
def test_a_page_without_relations_has_not_passed(page, tmp_path, capsys):
    path = written(tmp_path, page)
    for form, said in (
        ("text", "No relation was seen"),
        ("json", '"seen": 0'),
        ("latex", "No relation was seen"),
    ):
        assert run(["check", path, "--format", form, "--lenient"]) == 1
        assert said in capsys.readouterr().out
    assert sb.check(Path(path)).failed


@pytest.mark.slow
def test_every_relation_seen_is_counted(tmp_path, capsys):
    path = written(tmp_path, f"{GOOD}\n{BAD}\n$$x = \\Xi\\wr q$$\n\n$$k = 2r$$\n")
    assert run(["check", path, "--format", "json"]) == 1
    report = json.loads(capsys.readouterr().out)
    assert report["seen"] == 4 == sum(report["counts"].values())
    assert {name for name, count in report["counts"].items() if count} == {
        "holds_to_order", "refuted", "unreadable", "definition"
    }  # fmt: skip
    assert report["counts"]["undecided"] == 0
    run(["check", path])
    assert "\n4 relations seen: " in capsys.readouterr().out


@pytest.mark.slow
def test_a_fault_of_ours_leaves_its_relation_undecided_and_the_report_whole(
    tmp_path, capsys, monkeypatch
):
    from symbalance.notes.checking.judging import one_relation

    honest = one_relation.decide

    def faulty(left, right, *rest):
        return 1 / 0 if "sin" in str(right.node) else honest(left, right, *rest)

    monkeypatch.setattr(one_relation, "decide", faulty)
    path = written(tmp_path, f"{GOOD}\n$$2\\sin x = \\sin x + \\sin x$$\n\n{BAD}")
    for form in ("text", "latex", "json"):
        assert run(["check", path, "--format", form]) == 3
        out, err = capsys.readouterr()
        assert err.count("\n") == 1
        assert "line 3 of" in err
        assert "ZeroDivisionError" in err
        assert "please report it" in err
    report = json.loads(out)
    assert [link["verdict"] for link in report["links"]] == ["holds_to_order", "undecided", "refuted"]
    assert "fault of symbalance: ZeroDivisionError" in report["links"][1]["reason"]
    monkeypatch.setenv("SYMBALANCE_TRACEBACK", "1")
    assert run(["check", path]) == 3
    assert "Traceback" in capsys.readouterr().err


def test_a_fault_in_looking_for_a_correction_leaves_the_line_refuted(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("symbalance.notes.checking.repair.fixes.diagnose", lambda _case: 1 / 0)
    path = written(tmp_path, BAD)
    assert run(["check", path, "--format", "json"]) == 3
    (link,) = json.loads(capsys.readouterr().out)["links"]
    assert link["verdict"] == "refuted"
    assert "no correction was found, by a fault of symbalance" in link["notes"][0]


BOUND_LINE = SIDECAR + '[[bind]]\nline = 1\nquantity = "displacement"\n'
CHAIN = "$$2k - k = k = 2k - k$$\n\n$$3k - k = 2k$$\n"


def boom(*_: object, **__: object) -> None:
    raise RuntimeError("boom")


def reported(capsys, path: str) -> list[dict]:
    """Return what a report says that a fault of ours went into: all of it, with exit code 3."""
    assert run(["check", path, "--format", "json"]) == 3
    out, err = capsys.readouterr()
    assert "RuntimeError" in err
    return json.loads(out)["links"]


def test_a_step_that_was_not_judged_is_told_of_beside_a_claim_that_holds(tmp_path, capsys, monkeypatch):
    path = written(tmp_path, GOOD, BOUND_LINE)
    assert run(["check", path]) == 0
    monkeypatch.setattr("symbalance.notes.checking.judging.judge.Judge.link", boom)
    capsys.readouterr()
    (link,) = reported(capsys, path)
    assert link["bind"] == "displacement"
    assert link["verdict"] == "holds_to_order"
    assert "as a step: not judged, by a fault of symbalance: RuntimeError" in link["notes"][-1]


def test_a_step_that_was_not_mended_is_told_of_beside_its_claim(tmp_path, capsys, monkeypatch):
    path = written(tmp_path, BAD, BOUND_LINE)
    monkeypatch.setattr("symbalance.notes.checking.page.assertions.add_fix", lambda base, *_: base)
    monkeypatch.setattr("symbalance.notes.checking.repair.fixes.diagnose", boom)
    (link,) = reported(capsys, path)
    assert (link["verdict"], link["bind"]) == ("refuted", "displacement")
    assert "as a step: no correction was found, by a fault of symbalance" in link["notes"][-1]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("broken", "verdicts"),
    [
        ("judging.judge.assertions.side_of", ["undecided", "undecided", "holds"]),
        ("judging.judge.assertions.side_verdict", ["holds", "undecided", "holds"]),
        ("premises.definitions.Definitions.use", ["holds", "refuted", "holds"]),
    ],
)
def test_no_fault_in_judging_a_chain_loses_the_report(broken, verdicts, tmp_path, capsys, monkeypatch):
    path = written(tmp_path, CHAIN, BOUND_LINE)
    monkeypatch.setattr(f"symbalance.notes.checking.{broken}", boom)
    links = reported(capsys, path)
    assert [link["verdict"] for link in links] == verdicts
    told = [link for link in links if "fault of symbalance" in f"{link['reason']} {link.get('notes')}"]
    assert len(told) == (2 if broken != "judging.judge.assertions.side_verdict" else 1)


@pytest.mark.parametrize("broken", ["missing_equation", "span_of", "piece_verdict"])
def test_no_fault_in_placing_a_bind_loses_the_report(broken, tmp_path, capsys, monkeypatch):
    text = "" if broken == "missing_equation" else 'text = "2k"\n'
    bind = SIDECAR + f'[[bind]]\nline = 4\nquantity = "displacement"\n{text}'
    path = written(tmp_path, f"{CHAIN}so much for 2k\n", bind)
    monkeypatch.setattr(f"symbalance.notes.checking.page.assertions.{broken}", boom)
    links = reported(capsys, path)
    assert [(link["line"], link["verdict"]) for link in links] == [
        (1, "holds"), (1, "holds"), (3, "holds"), (4, "undecided")
    ]  # fmt: skip


@pytest.mark.parametrize("line", [1, 2])
def test_a_bound_line_that_cannot_be_read_is_counted_once(line, tmp_path):
    bind = BOUND_LINE.replace("line = 1", f"line = {line}")
    found = sb.check(Path(written(tmp_path, "$$x =\nr(1 - \\cos\\theta) \\unknown$$\n", bind)))
    assert [(v.verdict, v.bind) for v in found.verdicts] == [("unreadable", "displacement")]
    assert found.relation_count == 1
    nowhere = BOUND_LINE.replace("line = 1", "line = 2")
    found = sb.check(Path(written(tmp_path, f"$$x = f(q)$$\nprose\n\n{GOOD}", nowhere)))
    assert [(v.line, v.bind) for v in found.verdicts] == [(1, ""), (2, "displacement"), (4, "")]


@pytest.mark.parametrize(
    "relation",
    [r"1 = \ldots", r"1 = \ldots \cdots", r"\ldots \cdots = 1", r"1 = \ldots + \ldots",
     r"1 \approx \ldots \cdots", r"\sin x = 2(\ldots \cdots)", r"1 = 2^{\ldots\cdots}"],
)  # fmt: skip
def test_dots_alone_are_no_number(relation):
    (found,) = sb.check(f"$${relation}$$", {"x": "angle"}).verdicts
    assert (found.verdict, found.fault) == ("undecided", "")


def test_dots_alone_give_a_letter_no_value():
    found = sb.check(r"$$k = \ldots \cdots$$" + "\n\n$$k + 1 = 1$$", LETTERS).verdicts
    assert found[1].verdict != "holds"


def test_a_repair_of_a_sum_with_dots_is_no_fault():
    (found,) = sb.check(r"$$1 = 2 + \ldots \cdots$$", {}).verdicts
    assert (found.verdict, found.fault) == ("refuted", "")


PRINTED_ZEROS = {
    "0.0004 = 0.000": True,
    "0.0006 = 0.000": False,
    "-0.0005 = 0.000": True,
    "0.0004 \\approx 0.000": True,
    "0.0009 \\approx 0.000": False,
    "\\frac{1}{300} = 0.00": True,
    "\\frac{1}{100} = 0.00": False,
    "\\frac{1}{3000} = -0.000": True,
    "0.04 = 0.": False,
    "0.4 = .0": False,
    "10^{-400} = 0.0": True,
    "0.0 = 0.000": True,
    "\\sin x + 0.04 = 1.0 \\sin x + 0.0": True,
    "\\sin x + 0.06 = 1.0 \\sin x + 0.0": False,
    "\\sin x + 0.004 \\cos x = \\sin x + 0.00 \\cos x": True,
    "\\sin x + 0.006 \\cos x = \\sin x + 0.00 \\cos x": False,
}


@pytest.mark.parametrize("relation", PRINTED_ZEROS)
def test_a_printed_zero_stands_for_half_a_unit_of_its_last_place(relation):
    (found,) = sb.check(f"$${relation}$$", {"x": "angle"}).verdicts
    assert (found.verdict in ("holds", "holds_to_order"), found.fault) == (PRINTED_ZEROS[relation], "")


@pytest.mark.parametrize(
    ("relation", "verdict"),
    [
        (r"\frac{1}{0} < 2", "undecided"),
        (r"9^{9^9} > 1", "undecided"),
        (r"\sqrt{-1} < 2", "undecided"),
        (r"\arcsin 2 < 1", "undecided"),
        (r"1 < 2", "holds"),
        (r"2 \le 1", "refuted"),
        (r"\sqrt{-1} \neq 1", "holds"),
        (r"x < 3", "range"),
    ],
)
def test_an_inequality_of_numbers_is_never_just_a_range(relation, verdict):
    (found,) = sb.check(f"$${relation}$$", {"x": "angle"}).verdicts
    assert found.verdict == verdict


@pytest.mark.spread(2)
@pytest.mark.parametrize(
    "relation",
    [
        r"\ln 0 = 0.0",
        r"\ln 0.0 = 3 F",
        r"2 = 1e400",
        r"\frac{n}{x} = 10^{400}",
        r"\frac{0.0}{0.0} = 1",
        r"0^0 = 1",
        r"\frac{1}{0} = \frac{x}{0.0}",
        r"\sqrt{-1} = \sqrt{0.0}",
        r"0^0 \approx \ln(\sin(1))",
        r"\cos e^{0.0} = \frac{\sin(e^{0.0})}{10^{40}}",
        r"1 = \arcsin 2 = \frac{1}{(|x|)} = 99999999999999999999.5",
        r"\sum_{k=1}^{n} k \approx \frac{3}{2 \sum_{k=1}^{n} k \, \sum_{k=0}^{3} \frac{1}{k}} = 0^{-1}",
        r"(1 + 2 + \cdots + n) = n \frac{d}{dn} \frac{1}{n}",
        r"9^{9^9} = 2^{1000}",
    ],
)
def test_no_number_however_odd_is_a_fault(relation):
    found = sb.check(f"$${relation}$$\n\n$$0.0 = 0.0$$", {"x": "angle", "F": "any", "n": "integer"})
    assert [v.traceback for v in found.faults] == []
    assert found.verdicts[-1].verdict == "holds"


def test_json_has_the_agreed_keys_and_refers_continued_lines(tmp_path, capsys):
    page = "\\displaystyle x \\fallingdotseq r(1-\\cos\\theta)\n"
    page += "\\displaystyle +\\frac{r}{4\\lambda}(1+\\cos 2\\theta)\n"
    assert run(["check", written(tmp_path, page), "--format", "json"]) == 1
    report = json.loads(capsys.readouterr().out)
    assert report["document"].endswith("notes.md")
    first, second = report["links"]
    agreed = {"line", "link", "source", "verdict", "claimed", "exact", "witness", "fix"}
    assert agreed <= set(first)
    assert (first["line"], first["link"], first["verdict"]) == (1, 1, "refuted")
    assert first["witness"]["left"] != first["witness"]["right"]
    assert second == {"line": 2, "link": 1, "continues": 1, "verdict": "refuted"}
    assert [(w["line"], w["should"]) for w in first["wrong"]] == [(2, "-cos 2θ")]


def test_coefficients_that_differ_are_named(tmp_path):
    found = sb.check(Path(written(tmp_path, BAD))).verdicts[0]
    assert {d.term: (d.claimed, d.exact) for d in found.differences} == {
        "r/λ": ("1/2", "1/4"),
        "r/λ cos 2θ": ("-1/2", "-1/4"),
    }
    assert found.fix.text == "r (1 - cos θ) + r/(4λ) (1 - cos 2θ)"


def test_links_count_the_relations_of_a_line():
    found = sb.check(r"$k = r,\quad x = k - r$ and $2k = 2r = k + r$", LETTERS)
    assert [(v.line, v.link) for v in found.verdicts] == [(1, 1), (1, 2), (1, 3), (1, 4)]


def test_a_side_is_compared_with_the_last_sound_one():
    found = sb.check(r"$$\sin 2\theta = \sin\theta\cos\theta = 2\sin\theta\cos\theta$$", LETTERS)
    assert [v.verdict for v in found.verdicts] == ["refuted", "holds"]


def test_one_letter_may_mean_two_things(tmp_path):
    text = "$$k = 2r$$\n\n$$k = 3\\theta$$\n\n$$k + \\theta = 4\\theta$$\n"
    scope = SIDECAR + '[[scope]]\nlines = [3, 5]\nsymbols = { k = "another" }\n'
    found = sb.check(Path(written(tmp_path, text, scope)))
    assert [v.verdict for v in found.verdicts] == ["definition", "definition", "holds"]
    found = sb.check(Path(written(tmp_path, text)))
    assert [v.verdict for v in found.verdicts] == ["definition", "refuted", "conditional"]
    assert "which is refuted" in found.verdicts[2].assumption


def test_a_given_makes_a_step_conditional(tmp_path):
    scope = SIDECAR + '[[scope]]\nlines = [1, 1]\ngiven = ["theta = π/6"]\n'
    found = sb.check(Path(written(tmp_path, r"$$2r\cos\theta = \sqrt3 r$$", scope))).verdicts[0]
    assert (found.verdict, found.assumption) == ("conditional", "theta = π/6")


def test_a_line_bound_to_a_quantity_is_held_to_it(tmp_path):
    bind = SIDECAR + (
        '[[bind]]\nline = 1\nquantity = "force.vertical"\nengine = "v12-60"\norder = 6\nunit = "F_n"\n'
    )
    right = r"$$4\sqrt3\cos 6\theta + 2\sqrt3 \cos 6\theta = 6\sqrt3\cos 6\theta$$"
    assert sb.check(Path(written(tmp_path, right, bind))).verdicts[0].verdict == "holds"
    wrong = r"$$4\cos 6\theta + 5\cos 6\theta = 9\cos 6\theta$$"  # sound as a step, wrong as the force
    found = sb.check(Path(written(tmp_path, wrong, bind))).verdicts[0]
    assert (found.verdict, found.bind) == ("refuted", "force.vertical, order 6 of v12-60")


@pytest.mark.slow
def test_declarations_may_head_the_document(tmp_path):
    for suffix, opening, mark, closing in (
        (".md", "<!-- ", "", "-->\n"),
        (".tex", "% ", "% ", ""),
        (".txt", "# ", "# ", ""),
    ):
        head = opening + SIDECAR.replace("\n", "\n" + mark).removesuffix(mark) + closing
        path = tmp_path / f"headed{suffix}"
        path.write_text(head + (BAD if suffix != ".txt" else BAD.replace("$$", "")), encoding="utf-8")
        found = sb.check(path).verdicts
        assert [v.verdict for v in found] == ["refuted"], suffix
        assert found[0].line == head.count("\n") + 1


def piped(monkeypatch, text: str) -> None:
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(text.encode("utf-8")), encoding="utf-8"))


def test_notes_may_be_piped_in(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "letters.toml").write_text(SIDECAR, encoding="utf-8")
    (tmp_path / "-.symbols.toml").write_text("no = sidecar", encoding="utf-8")  # of a file called -
    for text, code in ((GOOD, 0), (BAD, 1)):
        piped(monkeypatch, text)
        assert run(["check", "-", "--symbols", "letters.toml"]) == code
        assert capsys.readouterr().out.startswith("Check of standard input\n1 relation seen: ")
    piped(monkeypatch, GOOD)
    assert run(["check", "-", "--declare"]) == 0
    assert '"r" = "' in capsys.readouterr().out
    piped(monkeypatch, BAD)
    assert run(["check", "-", "--symbols", "-"]) == 2
    assert "can be read only once" in capsys.readouterr().err


@pytest.mark.slow
@pytest.mark.parametrize(
    ("opening", "mark", "closing"), [("<!-- ", "", "-->"), ("% ", "% ", ""), ("# ", "# ", "")]
)
def test_what_is_piped_in_may_declare_its_letters_itself(opening, mark, closing, capsys, monkeypatch):
    head = opening + SIDECAR.replace("\n", f"\n{mark}").removesuffix(mark) + closing
    piped(monkeypatch, f"{head}\n{BAD}")
    assert run(["check", "-", "--format", "json"]) == 1
    (link,) = json.loads(capsys.readouterr().out)["links"]
    assert link["verdict"] == "refuted"


def test_a_fault_of_ours_names_standard_input(capsys, monkeypatch):
    monkeypatch.setattr("symbalance.notes.checking.judging.one_relation.decide", lambda *_: 1 / 0)
    piped(monkeypatch, "$$2 = 1 + 1$$")
    assert run(["check", "-"]) == 3
    assert "line 1 of standard input: ZeroDivisionError" in capsys.readouterr().err


def test_missing_declarations_are_listed_to_be_filled_in(tmp_path, capsys):
    path = tmp_path / "notes.md"
    path.write_text("$$F = m a$$\n\n$$F = m r \\omega^2$$\n", encoding="utf-8")
    assert run(["check", str(path), "--declare"]) == 0
    printed = capsys.readouterr().out
    (tmp_path / "notes.symbols.toml").write_text(printed, encoding="utf-8")
    letters = [line[:3] for line in printed.splitlines() if line.startswith('"')]
    assert letters == ['"F"', '"a"', '"m"', '"ω"', '"r"']
    assert run(["check", str(path)]) in (0, 1)
    assert "UNREADABLE" not in capsys.readouterr().out


BAD_SIDECARS = {
    "letter = [1]": "'letter'",
    '[symbols]\nk = 3': ":2: k = 3: must be text",
    '[symbols]\n"m_1" = "a"\n"m_{1}" = "b"': "twice",
    '[[scope]]\nlines = [5, 2]': ":8: lines = [5, 2]: must go upwards",
    '[[scope]]\nlines = [1, 2]\ngiven = ["r < 3"]': "given",
    '[[bind]]\nline = 1': ":7: [[bind]]: needs quantity",
    '[[bind]]\nline = 1\nquantity = "colour"': "known are",
    '[[bind]]\nline = 1\nquantity = "coefficient"': "add order",
    '[[bind]]\nline = 1\nquantity = "force.vertical"\norder = 2\nengine = "no-such"': "no-such",
    '[[bind]]\nline = 99\nquantity = "velocity"': "line",
    '[[bind]]\nline = 1\ntext = "zz"\nquantity = "velocity"': "does not stand on line 1",
    '[[bind]]\nline = 1\nquantity = "velocity"\nconvention = "r/s"': "l/r, r/l, l/s",
    "[symbols": "TOML",
}  # fmt: skip


@pytest.mark.spread(2)
@pytest.mark.parametrize("sidecar", BAD_SIDECARS)
def test_bad_declarations_are_refused_in_one_line(sidecar, tmp_path, capsys):
    known = "" if sidecar.startswith("[symbols") else SIDECAR
    assert run(["check", written(tmp_path, GOOD, known + sidecar)]) == 2
    message = capsys.readouterr().err
    assert message.count("\n") == 1
    assert BAD_SIDECARS[sidecar].strip("'") in message


@pytest.mark.parametrize("wrong", [3, None, ["a"], b"x = 1"])
def test_what_is_no_document_is_refused(wrong):
    with pytest.raises(sb.SymbalanceError):
        sb.check(wrong)


def plain(medium: str, printed: str) -> str:
    """Return what a medium says, in the letters it was handed, without blanks."""
    if medium == "html":
        printed = html.unescape(re.sub(r"<[^>]*>", "", printed))
    if medium == "markdown":
        printed = re.sub(r"\\([\\`*_{}\[\]<>#|$])", r"\1", printed)
    if medium == "latex":
        printed = re.sub(r"\\allowbreak(\{\})?|\$", "", printed)
        for command, letter in TEX.items():
            printed = printed.replace(command, letter)
        printed = re.sub(r"\\([&%#_{}])", r"\1", printed)
    return "".join(printed.replace("\\", "").replace("−", "-").split())


TEX = {
    r"\textbackslash{}": "\\", r"\textasciicircum{}": "^", "--": "-", r"\lambda": "λ", r"\theta": "θ",
}  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("medium", ["text", "latex", "html", "markdown"])
def test_every_medium_says_what_the_data_says(medium):
    checked = example("check")
    printed = plain(medium, getattr(sb, f"to_{medium}")(checked))
    found = {link["verdict"] for link in checked.data()["links"]}
    assert found == {*VERDICTS} - {"conditional"}
    at = 0
    for link in checked.data()["links"]:
        if "continues" in link:
            continue
        if medium != "latex" or link["verdict"] == "unreadable":  # what is read is typeset there
            at = printed.index(plain(medium, link["source"]), at)
        below = printed[at:]
        said = [link["reason"], link["slip"], *link.get("notes", ())]
        # of two numbers the right one is shown, not both as a witness
        is_point = {*link["witness"]} - {"left", "right"} or not (link["fix"] or link["exact"])
        said += (
            [value[:6] for value in link["witness"].values()] if is_point else []
        )  # six digits are shown
        said += [f"line {w['line']}, column {w['column']}: " for w in link["wrong"]]
        for text in filter(None, said):
            assert plain(medium, text) in below, (link["line"], text)


def test_the_count_is_read_before_the_relations_and_the_legend_after_them():
    printed = sb.to_text(sb.check(BAD, LETTERS))
    order = ["Check of ", "1 relation seen: 1 refuted.", "  REFUTED  ", "found: ", "How to read it"]
    assert sorted(order, key=printed.index) == order


def test_a_line_of_text_stands_beside_its_verdict_or_whole_below_it():
    long = " + ".join(["k"] * 60)
    printed = sb.to_text(sb.check(f"$$2k = k + k$$\n\n$$60k = {long}$$", LETTERS))
    assert "\n     1  holds  k + k\n     3  holds\n        k + k + k" in printed
    assert long in " ".join(printed.split())
    assert "\n     3  holds  k + k + k" in sb.to_text(
        sb.check(f"\n\n$$60k = {long}$$", LETTERS), width=300
    )


@pytest.mark.slow
def test_records_are_one_row_for_each_relation(tmp_path):
    rows = sb.check(Path(written(tmp_path, f"{GOOD}\n{BAD}"))).records()
    assert [(row["line"], row["verdict"], row["fix_kind"]) for row in rows] == [
        (1, "holds_to_order", None),
        (3, "refuted", "number misprinted (4 for 2)"),
    ]


@pytest.mark.slow
def test_the_ending_of_the_output_chooses_the_medium(tmp_path, capsys):
    path = written(tmp_path, BAD)
    for name, begins in (
        ("r.html", "<!DOCTYPE html>"),
        ("r.tex", "% Needs"),
        ("r.json", "{"),
        ("r.md", "# "),
    ):
        assert run(["check", path, "-o", str(tmp_path / name)]) == 1
        assert (tmp_path / name).read_text(encoding="utf-8").startswith(begins)
    assert run(["check", path, "--declare", "--standalone"]) == 2
    assert "--standalone: plays no part in --declare" in capsys.readouterr().err


def test_a_correction_of_the_left_side_says_so():
    (found,) = sb.check("$$(r - k)^3 = r^3 + 3 r^2 k + 3 r k^2 + k^3$$", LETTERS).verdicts
    printed = sb.to_text(found)
    assert "left side should be: (r + k)³" in printed
    assert "stands:" not in printed  # of the right side, which is not what is wrong
    (found,) = sb.check("$$(r - k)^2 = r^2 + 2 r k + k^2$$", LETTERS).verdicts
    assert "stands: r² + 2r k + k²\n        should be: r² − 2r k + k²" in sb.to_text(found)


@pytest.mark.slow
def test_the_latex_report_compiles_and_shows_both_lines(compile_latex, tmp_path):
    found = sb.check(Path(written(tmp_path, BAD + r"$$x = \unknown_1$$" + "\n" + GOOD)))
    printed = sb.to_latex(found, standalone=True)
    assert r"\frac{r}{2 \lambda}" in printed  # as it stands
    assert "should be:" in printed
    assert r"\frac{r}{4 \lambda}" in printed
    compile_latex(printed)


@pytest.mark.slow
def test_the_latex_report_loses_no_character_of_the_source(compile_latex):
    source = "$$x = −√3·½ λ² ± ∂ ÷ × ∫ ΔΩς désaxé ☃ ≠ … ₂ ÿ$$"
    printed = sb.to_latex(sb.check(source, LETTERS), standalone=True)
    shown = next(line for line in printed.splitlines() if r"\textsc{unreadable}" in line)
    assert "?" not in shown
    for piece in ("-{}-", r"\surd", r"\times", r"\Delta", "désaxé", "U+2603", r"\pm", "ÿ"):
        assert piece in shown, piece
    compile_latex(printed)


JAPANESE = "連桿比 $2k = 力 k$\n\n$$2r = 90度$$\n"


@pytest.mark.parametrize("writer", [sb.to_text, sb.to_latex, sb.to_html, sb.to_markdown, sb.to_json])
def test_japanese_stands_in_a_report_as_it_is(writer):
    printed = writer(sb.check(JAPANESE, LETTERS))
    assert "力" in printed
    degree = r"90^{\circ}" if writer is sb.to_latex else "度"  # LaTeX typesets what is read
    assert degree in printed


@pytest.mark.rare
@pytest.mark.parametrize(("engine", "read"), [("lualatex", "2k = 力 k"), ("pdflatex", "2k = U+529B k")])
def test_a_report_with_japanese_is_set_by_lualatex_and_spelled_by_pdflatex(engine, read, tmp_path):
    if shutil.which(engine) is None or not _output("kpsewhich", "luatexja.sty", folder=tmp_path):
        pytest.skip(f"{engine} or luatexja is not installed")
    source = sb.to_latex(sb.check(JAPANESE, LETTERS), standalone=True)
    (tmp_path / "notes.tex").write_text(source, encoding="utf-8")
    _output(engine, "-interaction=nonstopmode", "-halt-on-error", "notes.tex", folder=tmp_path)
    page = " ".join(_output("pdftotext", "notes.pdf", "-", folder=tmp_path).split())
    assert read in page
    assert ("compile with lualatex" in page) == (engine == "pdflatex")


def _output(*command: str, folder: Path) -> str:
    done = subprocess.run(command, cwd=folder, capture_output=True, timeout=120, check=False)
    return done.stdout.decode("utf-8", "replace")


@pytest.mark.slow
def test_every_character_of_the_report_compiles(compile_latex):
    from symbalance.document.latex_characters import escaped

    ranges = ((0xA0, 0x100), (0x370, 0x400), (0x2010, 0x2040), (0x2070, 0x20A0), (0x2190, 0x2260))
    text = [escaped(chr(code)) for start, end in ranges for code in range(start, end)]
    assert "?" not in "".join(text)
    head = "\\documentclass{article}\\usepackage[T1]{fontenc}\\usepackage[utf8]{inputenc}"
    page = "\n\n".join(text)
    compile_latex(f"{head}\\usepackage{{lmodern,amsmath}}\\begin{{document}}{page}\\end{{document}}")


def test_check_equal_decides_sympy_expressions():
    x, n = sp.Symbol("x"), sp.Symbol("n", integer=True)
    a = sp.Symbol("a", positive=True)
    assert sb.check_equal(sp.cos(3 * x), 4 * sp.cos(x) ** 3 - 3 * sp.cos(x)).verdict == "holds"
    assert sb.check_equal(sp.sqrt(a**2 * 3), sp.sqrt(3) * a).verdict == "holds"
    assert sb.check_equal(sp.sqrt(x**2), x).verdict == "conditional"
    assert sb.check_equal(sp.exp(2 * sp.I * sp.pi * n), 1).verdict == "holds"
    assert sb.check_equal(2 * x, sp.pi / 3, assuming=["x = pi/6"]).verdict == "conditional"
    series = sb.check_equal(sp.sqrt(1 - a**2), 1 - a**2 / 2, approximately=True)
    assert (series.verdict, series.order) == ("holds_to_order", "a²")
    wrong = sb.check_equal(sp.sqrt(1 - a**2), 1 - a**2 / 4, approximately=True)
    assert wrong.verdict == "refuted"
    with pytest.raises(sb.SymbalanceError):
        sb.check_equal(sp.gamma(x), x)
    with pytest.raises(sb.SymbalanceError):
        sb.check_equal("x", x)


def test_seven_cylinders_cancel_where_simplify_does_not():
    theta = sp.Symbol("theta")
    total = sum(sp.cos(2 * (theta + 2 * sp.pi * k / 7)) for k in range(7))
    assert sb.check_equal(total, 0).verdict == "holds"


def test_an_undecided_step_is_never_a_pass(tmp_path):
    page = r"$$\ln(k^2) = 2\ln k$$"
    found = sb.check(Path(written(tmp_path, page)))
    assert found.verdicts[0].verdict in ("undecided", "conditional", "refuted")


def test_two_claims_for_one_side_are_refused_and_neither_is_dropped():
    page = r"$x = r(1 - \cos \theta) + l(1 - \sqrt{1 - r^2/l^2 \sin^2 \theta})$"
    letters = {"x": "displacement", "r": "crank radius", "l": "rod length", "theta": "crank angle"}
    binds = [{"line": 1, "quantity": "velocity"}, {"line": 1, "quantity": "displacement"}]
    assert sb.check(page, {"symbols": letters, "bind": binds[1:]}).verdicts[-1].verdict == "holds"
    assert sb.check(page, {"symbols": letters, "bind": binds[:1]}).verdicts[-1].verdict == "refuted"
    with pytest.raises(sb.SymbalanceError, match="bound twice, as velocity and as displacement"):
        sb.check(page, {"symbols": letters, "bind": binds})


def test_a_notebook_declares_its_letters_in_a_raw_cell(tmp_path, capsys):
    cells = [
        {"cell_type": "markdown", "source": ["$l \\sin\\beta = r\\sin\\theta$"]},
        {
            "cell_type": "raw",
            "source": ["[symbols]\n", 'theta = "crank angle"\n', 'beta = "rod angle"\n'],
        },
        {"cell_type": "markdown", "source": ["$l \\sin\\beta = r\\cos\\theta$"]},
    ]
    cells[1]["source"] += ['r = "crank radius"\n', 'l = "rod length"']
    path = tmp_path / "work.ipynb"
    path.write_text(json.dumps({"nbformat": 4, "metadata": {}, "cells": cells}), encoding="utf-8")
    assert run(["check", str(path), "--format", "json"]) == 1
    words = [(e["cell"], e["verdict"]) for e in json.loads(capsys.readouterr().out)["links"]]
    assert words == [(1, "holds"), (3, "refuted")]
    cells[1]["source"][1] = 'theta = "cranck angle"\n'
    path.write_text(json.dumps({"nbformat": 4, "metadata": {}, "cells": cells}), encoding="utf-8")
    assert run(["check", str(path)]) == 2
    assert "much like crank angle" in capsys.readouterr().err
