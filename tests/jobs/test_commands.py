"""Commands of long work: several documents and engines, what a break leaves, and Ctrl-C."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import time
import tomllib
from pathlib import Path

import pytest

from symbalance.cli import run
from tests import ROOT
from tests.cranks import sheet, written
from tests.interrupts import that_hears_ctrl_c

TRUE = "$$\\sin^2 x + \\cos^2 x = 1$$\n"
FALSE = "$$\\sin^2 x + \\cos^2 x = 2$$\n"
SIDECAR = '[symbols]\nx = "angle"\n'


@pytest.fixture
def notes(tmp_path) -> Path:
    """A folder of documents: one right, one wrong, one that is no text, one below, two passed over."""
    folder = tmp_path / "notes"
    (folder / "below").mkdir(parents=True)
    (folder / ".hidden").mkdir()
    for name, text in (("right.md", TRUE), ("wrong.txt", FALSE), ("below/deep.tex", TRUE)):
        (folder / name).write_text(text, encoding="utf-8")
        (folder / name).with_suffix(".symbols.toml").write_text(SIDECAR, encoding="utf-8")
    (folder / "broken.md").write_bytes(b"$$a = b$$ \xff\n")
    (folder / ".hidden" / "other.md").write_text(FALSE, encoding="utf-8")
    (folder / "data.csv").write_text("1,2\n", encoding="utf-8")
    return folder


def reports_of(text: str) -> dict[str, dict]:
    return {Path(one["document"]).name: one for one in json.loads(text)["documents"]}


def test_every_document_of_a_folder_is_a_line_and_the_worst_decides(notes, capsys):
    assert run(["check", str(notes), "--format", "json"]) == 2
    out, err = capsys.readouterr()
    reports = reports_of(out)
    assert [*reports] == ["deep.tex", "broken.md", "right.md", "wrong.txt"]
    assert {name: one["exit"] for name, one in reports.items()} == {
        "deep.tex": 0,
        "broken.md": 2,
        "right.md": 0,
        "wrong.txt": 1,
    }
    assert reports["wrong.txt"]["counts"]["refuted"] == 1
    assert "is not UTF-8 text" in reports["broken.md"]["problem"]
    refusals = [line for line in err.splitlines() if line.startswith("symbalance: ")]
    assert refusals == [f"symbalance: {notes}/broken.md:1: is not UTF-8 text; save it as UTF-8"]


def test_one_draft_declares_the_letters_of_a_whole_course(tmp_path, capsys):
    """What documents agree on is proposed; λ, which two of them mean differently, is left to them."""
    course = tmp_path / "course"
    course.mkdir()
    texts = {
        "anna.md": "crank radius r, rod ratio λ = l/r, crank angle θ\n\n$$y = r cos θ + λ$$\n",
        "Ben.txt": "r: Kurbelradius, Kurbelwinkel θ, Schubstangenverhältnis λ = r/l\n\ny = r cos θ + λ\n",
    }
    for name, text in texts.items():
        (course / name).write_text(text, encoding="utf-8")
    (course / "broken.md").write_bytes(b"\xff")
    assert run(["check", str(course), "--declare"]) == 2
    out, err = capsys.readouterr()
    assert err.count("\n") == 1
    assert "broken.md:1: is not UTF-8 text" in err
    symbols = tomllib.loads(out)["symbols"]
    assert (symbols["r"], symbols["θ"], symbols["λ"]) == ("? crank radius", "? crank angle", "")
    assert "they differ: crank ratio r/l (1), rod ratio l/r (1)" in out.replace(
        "rod ratio l/r (1), crank ratio r/l (1)", "crank ratio r/l (1), rod ratio l/r (1)"
    )


def test_of_two_letters_a_course_calls_crank_angle_a_page_has_the_one_it_writes(tmp_path, capsys):
    """β is asin(ρ sin φ) where φ alone stands: with θ for it, right lines would be refuted."""
    course = tmp_path / "course"
    course.mkdir()
    (course / "symbols.toml").write_text(
        '[symbols]\n"θ" = "crank angle"\n"φ" = "crank angle"\n"β" = "rod angle"\n'
        'r = "crank radius"\nl = "rod length"\n',
        encoding="utf-8",
    )
    (course / "one.txt").write_text("l sin β = r sin φ\n", encoding="utf-8")
    (course / "other.txt").write_text("l sin β = r sin θ\n", encoding="utf-8")
    (course / "wrong.txt").write_text("l sin β = r cos φ\n", encoding="utf-8")
    assert run(["check", str(course), "--format", "json"]) == 1
    reports = reports_of(capsys.readouterr().out)
    assert {name: one["exit"] for name, one in reports.items()} == {
        "one.txt": 0,
        "other.txt": 0,
        "wrong.txt": 1,
    }


def test_the_index_of_reports_leads_to_the_line_of_each_error(notes, tmp_path, capsys):
    reports = tmp_path / "reports"
    assert run(["check", str(notes), "-o", str(reports), "--format", "html"]) == 2
    capsys.readouterr()
    index = (reports / "index.html").read_text(encoding="utf-8")
    targets = re.findall(r'href="([^"#]*)#([^"]+)"', index)
    assert set(targets) == {("wrong.txt.html", "line-1")}
    assert 'id="line-1"' in (reports / "wrong.txt.html").read_text(encoding="utf-8")
    assert 'href="below/deep.tex.html"' in index


def test_a_document_among_several_is_said_what_is_said_of_it_alone(notes, capsys):
    run(["check", str(notes / "wrong.txt"), "--format", "json"])
    alone = json.loads(capsys.readouterr().out)
    run(["check", str(notes / "right.md"), str(notes / "wrong.txt"), "--format", "json"])
    among = reports_of(capsys.readouterr().out)["wrong.txt"]
    assert {**alone, "exit": 1} == {"schema": alone["schema"], **among}


def test_the_exit_code_is_that_of_the_worst(notes, capsys):
    right, wrong = str(notes / "right.md"), str(notes / "wrong.txt")
    assert run(["check", right, str(notes / "below")]) == 0
    assert run(["check", right, wrong]) == 1
    assert run(["check", right, wrong, str(notes / "missing.md")]) == 2
    assert "missing.md: cannot be read (No such file or directory)" in capsys.readouterr().err


def test_a_report_each_and_an_index_and_nothing_done_twice(notes, tmp_path, capsys):
    out = tmp_path / "out"
    command = ["check", str(notes), "-o", str(out)]
    run(command)
    first = capsys.readouterr()
    files = {str(p.relative_to(out)): p.read_text(encoding="utf-8") for p in out.rglob("*.txt")}
    assert set(files) == {"index.txt", "right.md.txt", "wrong.txt.txt", "below/deep.tex.txt"}
    assert files["index.txt"] == first.out
    assert "refuted" in files["wrong.txt.txt"]
    run(command)
    second = capsys.readouterr()
    assert second.out == first.out
    assert "4 of 4 done (3 from before)" in second.err
    assert {str(p.relative_to(out)) for p in out.rglob("*.txt")} == set(files)


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("right.md", FALSE),
        ("right.symbols.toml", '[symbols]\nx = "positive"\n'),
        ("right.md.symbols.toml", SIDECAR),
    ],
)
def test_what_decides_a_verdict_decides_whether_it_is_done_again(notes, tmp_path, capsys, name, content):
    command = ["check", str(notes), "-o", str(tmp_path / "out")]
    run(command)
    (notes / name).write_text(content, encoding="utf-8")
    capsys.readouterr()
    run(command)
    assert "4 of 4 done (2 from before)" in capsys.readouterr().err


def test_an_engine_that_a_sidecar_names_counts_by_its_content(tmp_path, capsys):
    notes, out = tmp_path / "notes", tmp_path / "out"
    notes.mkdir()
    bind = (
        '[symbols]\nx = "angle"\n[[bind]]\nline = 1\nquantity = "force"\norder = 2\nengine = "own.toml"\n'
    )
    engine = "[crank_train]\nratio = {}\n[layout]\nfiring_order = [1, 3, 4, 2]\n"
    (notes / "a.md").write_text(TRUE, encoding="utf-8")
    (notes / "a.symbols.toml").write_text(bind, encoding="utf-8")
    saved = []
    from symbalance.cli.check_several import _job
    from symbalance.notes.checking.deciding.guarded_verdicts import PAGE

    for ratio in (4, 4, 3):
        (notes / "own.toml").write_text(engine.format(ratio), encoding="utf-8")
        saved.append(_job(notes / "a.md", None, PAGE, False, "text", False, True).key)
    assert saved[0] == saved[1] != saved[2]
    assert not out.exists()


def test_the_same_document_by_two_ways_is_one(notes, capsys):
    run(["check", str(notes / "right.md"), str(notes / "below" / ".." / "right.md"), "--format", "json"])
    assert len(json.loads(capsys.readouterr().out)["documents"]) == 1


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["right.md", "-"], "is one document among several"),
        (["right.md", ""], "is an empty name"),
        (
            ["right.md", "wrong.txt", "--declare", "--format", "html"],
            "--format: plays no part",
        ),
        (["right.md", "wrong.txt", "--declare", "-o", "out"], "--output out: is no .toml file"),
        ([".", "-o", "."], "is a folder of documents, and reports in it would be documents too"),
        ([".hidden/none"], "cannot be read"),
        (["empty"], "holds no .tex, .md, .txt, .text, "),
        (["right.md", "wrong.txt", "-o", "right.md"], "--output right.md: cannot be made"),
        (["right.md", "--dask", "tcp://x:1"], "--dask: is for several documents"),
        (["right.md", "wrong.txt", "--jobs", "many"], "--jobs = many: must be a whole number"),
        (["right.md", "wrong.txt", "--standalone"], "--standalone: is for LaTeX"),
    ],
)
def test_what_cannot_be_is_refused_in_one_line(notes, arguments, said, capsys, monkeypatch):
    monkeypatch.chdir(notes)
    Path("empty").mkdir()
    before = sorted(Path().rglob("*"))
    assert run(["check", *arguments]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert said in line
    assert sorted(Path().rglob("*")) == before


def test_a_hostile_name_reaches_the_terminal_spelled_out(tmp_path, capsys):
    folder = tmp_path / "notes"
    folder.mkdir()
    for name in ("\x1b[31mred.md", "\u202eright.md"):
        (folder / name).write_text(TRUE, encoding="utf-8")
    run(["check", str(folder)])
    out, err = capsys.readouterr()
    assert "\x1b" not in out + err
    assert "\u202e" not in out + err


@pytest.mark.slow
def test_each_of_several_engines_is_a_file_as_alone(tmp_path, capsys):
    out = tmp_path / "out"
    assert run(["balance", "inline-4", "v2-90", "-o", str(out), "--format", "json"]) == 0
    for name in ("inline-4", "v2-90"):
        assert run(["balance", name, "--format", "json"]) == 0
        assert (out / f"{name}.json").read_text(encoding="utf-8") == capsys.readouterr().out
    assert run(["balance", "inline-4", "inline-2", "-o", str(out), "--format", "json"]) == 0
    assert "(1 from before)" in capsys.readouterr().err
    assert run(["balance", "inline-4", "-o", str(out / "text.txt"), "--order", "4"]) == 0
    assert run(["balance", "inline-4", "inline-2", "-o", str(out), "--order", "4"]) == 0
    both = [(out / name).read_text(encoding="utf-8") for name in ("text.txt", "inline-4.txt")]
    assert both[0] == both[1]


def test_an_engine_that_is_refused_stops_no_other(tmp_path, capsys):
    out = tmp_path / "out"
    assert run(["balance", "v13", "inline-4", "--ratio", "3", "-o", str(out)]) == 2
    err = capsys.readouterr().err
    assert "symbalance: v13: engine 'v13': is no preset" in err
    assert (out / "inline-4.txt").exists()
    assert not (out / "v13.txt").exists()


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["inline-4", "-", "-o", "out"], "is standard input, among several"),
        (["inline-4", "inline-4", "-o", "out"], "would be the report of two"),
        (["inline-4", "v2-90", "-o", "file"], "--output file: cannot be made"),
        (["inline-4", "--dask", "tcp://x:1"], "--dask: is for several engines"),
        (["./own.txt", "v2-90", "-o", "."], "is a file that is read, and would be replaced"),
    ],
)
def test_several_engines_are_refused_in_one_line(tmp_path, monkeypatch, arguments, said, capsys):
    monkeypatch.chdir(tmp_path)
    for name in ("file", "own.txt.txt", "own.txt"):
        Path(name).write_text("", encoding="utf-8")
    Path("own.txt.txt").unlink()
    Path("own.txt.txt").hardlink_to("own.txt")
    assert run(["balance", *arguments]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert said in line


# With processes


@pytest.mark.slow
def test_documents_and_engines_are_the_same_however_many_share_them(notes, tmp_path, capsys):
    shown = []
    for count in ("1", "3"):
        run(["check", str(notes), "--jobs", count, "--format", "json"])
        shown.append(capsys.readouterr().out)
        engines = ["inline-4", "v2-90", "inline-3", "--order", "4"]
        assert run(["balance", *engines, "--jobs", count, "-o", str(tmp_path / count)]) == 0
    assert shown[0] == shown[1]
    for path in (tmp_path / "1").glob("*.txt"):
        assert path.read_bytes() == (tmp_path / "3" / path.name).read_bytes()


def _started(*arguments: str) -> subprocess.Popen[str]:
    """Start a command in a group of processes of its own, as a terminal does."""
    return subprocess.Popen(
        that_hears_ctrl_c("-m", "symbalance", *arguments),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        cwd=ROOT,
        start_new_session=True,
    )


@pytest.mark.slow
@pytest.mark.parametrize("count", ["1", "2"])
def test_ctrl_c_says_what_is_kept_and_how_to_go_on(tmp_path, count):
    """As a terminal sends it, to every process of the group: no traceback of a worker, none left."""
    keep, command = tmp_path / "kept", ["sweep", "v12-60", "--vary", "ratio=3:6:0.005"]
    arguments = [*command, "--quantities", "force.500,torque.500", "--keep", str(keep), "--jobs", count]
    process = _started(*arguments)
    end = time.monotonic() + 60
    while len(list(keep.glob("*.result"))) < 5:
        assert time.monotonic() < end
        assert process.poll() is None
        time.sleep(0.02)
    os.killpg(process.pid, signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert (process.returncode, out) == (130, "")
    *progress, last = err.splitlines()
    assert last.startswith("symbalance: interrupted: ")
    assert f"of 601 finished, kept in {keep}; go on with: symbalance sweep" in last
    assert all(" of 601 done" in line for line in progress)
    finished = int(last.split()[2])
    assert finished <= len(list(keep.glob("*.result"))) <= finished + 1
    end = time.monotonic() + 20  # Python's own tracker of semaphores ends a moment after
    while _group(process.pid) and time.monotonic() < end:
        time.sleep(0.1)
    assert not _group(process.pid)


@pytest.mark.slow
def test_ctrl_c_while_workers_start_shows_no_traceback(tmp_path):
    """They hear of it in the midst of their imports, which are as long as half a second."""
    keep = tmp_path / "kept"
    arguments = ["sweep", "v12-60", "--vary", "ratio=3:6:0.005", "--quantities", "force.500"]
    process = _started(*arguments, "--keep", str(keep), "--jobs", "2")
    end = time.monotonic() + 60
    while len(_group(process.pid)) < 4:  # the command, what keeps count of its resources, two workers
        assert time.monotonic() < end
        assert process.poll() is None
        time.sleep(0.01)
    os.killpg(process.pid, signal.SIGINT)
    _, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "Traceback" not in err
    assert "interrupted: " in err.splitlines()[-1]
    end = time.monotonic() + 20  # Python's own tracker of semaphores ends a moment after
    while _group(process.pid) and time.monotonic() < end:
        time.sleep(0.1)
    assert not _group(process.pid)


def _group(leader: int) -> list[int]:
    """Return the processes of a group that still run."""
    alive = []
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                fields = (entry / "stat").read_text(encoding="utf-8").rpartition(") ")[2].split()
            except OSError:
                continue
            if int(fields[2]) == leader and fields[0] != "Z":
                alive.append(int(entry.name))
    return alive


@pytest.mark.slow
def test_speeds_side_by_side_are_the_same_to_the_bit(tmp_path):
    """As commands of their own, so that BLAS has the threads that each gives it."""
    engine = str(written(tmp_path, sheet()))
    shown = []
    for count in ("1", "2"):
        process = _started(
            *("crankshaft", engine, "--rpm", "1000,1500", "--webs", "nominal", "--steps", "120"),
            *("--about", "centre", "--no-plots", "--format", "json", "--jobs", count),
        )
        out, _ = process.communicate(timeout=300)
        report = json.loads(out)
        for speed in report["speeds"]:
            assert speed.pop("seconds") > 0
        shown.append(report)
    assert shown[0] == shown[1]


@pytest.mark.slow
def test_speeds_of_an_earlier_version_are_said_and_solved_anew(tmp_path, capsys):
    engine, out = str(written(tmp_path, sheet())), tmp_path / "out"
    (out / "speeds").mkdir(parents=True)
    (out / "speeds" / "1500rpm.npz").write_bytes(b"PK")
    command = ["crankshaft", engine, "--rpm", "1500", "--webs", "nominal", "--steps", "120"]
    for said in (True, False):
        run([*command, "--about", "centre", "--no-plots", "-o", str(out)])
        err = capsys.readouterr().err
        assert ("1500rpm.npz: is of an earlier version: solved anew" in err) is said


# What is kept must be of what it says


def test_a_document_that_is_changed_while_it_is_checked_is_not_kept(notes, tmp_path, monkeypatch, capsys):
    """Its key is of the first content, its verdict of the second: the next run must not believe it."""
    from symbalance.cli import check_several as command

    wrong, checked = notes / "wrong.txt", command.check

    def changed_first(document, *rest, **options):
        if document.name == "wrong.txt":
            wrong.write_text(TRUE, encoding="utf-8")
        return checked(document, *rest, **options)

    files = [str(notes / "right.md"), str(wrong), "-o", str(tmp_path / "out"), "--format", "json"]
    monkeypatch.setattr(command, "check", changed_first)
    assert run(["check", *files]) == 0
    assert "wrong.txt: was changed while it was checked: not kept" in capsys.readouterr().err
    wrong.write_text(FALSE, encoding="utf-8")
    monkeypatch.undo()
    assert run(["check", *files]) == 1
    assert reports_of(capsys.readouterr().out)["wrong.txt"]["counts"]["refuted"] == 1


def test_what_a_budget_left_open_is_judged_again(notes, tmp_path, monkeypatch, capsys):
    from symbalance.notes.checking.deciding.guarded_verdicts import Guard

    files = [str(notes / "right.md"), str(notes / "wrong.txt"), "-o", str(tmp_path / "out")]
    original = Guard._time_left
    monkeypatch.setattr(Guard, "_time_left", lambda guard: 0.0)
    assert run(["check", *files, "--format", "json"]) == 1
    assert reports_of(capsys.readouterr().out)["right.md"]["counts"]["undecided"] == 1
    monkeypatch.setattr(Guard, "_time_left", original)
    assert run(["check", *files, "--format", "json"]) == 1
    assert reports_of(capsys.readouterr().out)["right.md"]["counts"]["holds"] == 1
