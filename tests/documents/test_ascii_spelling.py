"""What a stream cannot encode is spelled out: the same numbers, columns in line, never a `?`."""

import json
import os
import re
import subprocess
import sys
from itertools import pairwise
from pathlib import Path

import pytest
import sympy
from sympy.parsing.sympy_parser import convert_xor, parse_expr, standard_transformations

from symbalance.cli import run
from symbalance.cli.ascii_spelling import RAISED, as_encodable, as_json
from symbalance.engine.catalogue import preset_text
from tests.different_presets import different_presets

ENCODINGS = ("ascii", "latin-1", "cp1252", "cp932", "koi8-r")
GOLDEN = Path(__file__).parent.parent / "golden"
C_LOCALE = {"LC_ALL": "C", "PYTHONCOERCECLOCALE": "0", "PYTHONUTF8": "0"}


def printed(capsys, *arguments: str) -> str:
    assert run(list(arguments)) == 0
    return capsys.readouterr().out


def program(*arguments: str, **environment: str) -> bytes:
    plain = {k: v for k, v in os.environ.items() if not k.startswith(("LC_", "LANG", "PYTHON"))}
    done = subprocess.run(
        [sys.executable, "-m", "symbalance", *arguments],
        capture_output=True,
        check=True,
        env={**plain, **environment},
    )
    assert done.stderr == b""
    return done.stdout


def value(text: str) -> sympy.Expr:
    names = {"lam": sympy.Symbol("lam")}
    product = re.sub(r"(?<=\d) (?=[a-z])", "*", text)  # 4 cos(x)
    return parse_expr(product, names, (*standard_transformations, convert_xor))


SPELLED = {
    "−√(5 − 2√5)/2": "-sqrt(5 - 2*sqrt(5))/2",
    "6√3": "6*sqrt(3)",
    "√√2": "sqrt(sqrt(2))",
    "√λ₁ + √x": "sqrt(lam_1) + sqrt(x)",
    "(1 + √2)√3λ": "(1 + sqrt(2))*sqrt(3)*lam",
    "9/(128λ⁵) + 45λ⁻¹²": "9/(128*lam^5) + 45*lam^(-12)",
    "m r²ω²": "m r^2*omega^2",
    "mrω²": "mr*omega^2",
    "(−1)ᵏ λ⁽ᵏ⁺¹⁾ λᵏ⁺¹": "(-1)^k lam^(k+1) lam^(k+1)",
    "Aₙ, A₁₂, A₂ₖ": "A_n, A_12, A_(2k)",
    "sin²θ/λ² + cos 2θ cos nθ": "sin(theta)^2/lam^2 + cos(2*theta) cos(n*theta)",
    "cos(nθ − φ) · sin θ": "cos(n*theta - phi) * sin(theta)",
    "3πρ/4 ≈ 2.4 ≤ 3 ≠ ±1 × 2 …": "3*pi*rho/4 ~ 2.4 <= 3 != +/-1 x 2 ...",
    "90°, 1–4, 7.4e−5": "90 deg, 1-4, 7.4e-5",
    "7.4 × 10⁻⁵ r, 86 × 86": "7.4e-5 r, 86 x 86",
    "ΔF, Σ(k≥1) ½": "Delta_F, Sum(k>=1) (1/2)",
    "sin (2i+1)θ + cos (n + 1)θ": "sin((2i+1)*theta) + cos((n + 1)*theta)",
    "sin ½θ, sin²½θ, cos²(θ)λ": "sin((1/2)*theta), sin((1/2)*theta)^2, cos(theta)^2*lam",
    "cos 2πθ, sinωt, cos nωt": "cos(2*pi*theta), sin(omega*t), cos(n*omega*t)",
    "cos ωt², cos θ(1 + λ)": r"cos \u03c9t\xb2, cos \u03b8(1 + lam)",
    "√ab, √λ²": r"\u221aab, \u221alam^2",
    "λ⁻½, ⁴√2, x⁴√2": "lam^(-1/2), (2)^(1/4), x^4*sqrt(2)",
    "₂F₁(1, 2; 3; x)": "hyp2f1(1, 2; 3; x)",
    "ẋ² + ẍ": r"\u1e8b^2 + \u1e8d",
    "λ(λ+1), π(1 + λ), φ(t)": "lam*(lam+1), pi*(1 + lam), phi(t)",
    "√2(1 + √3), ω²(1 + λ)": "sqrt(2)*(1 + sqrt(3)), omega^2*(1 + lam)",
    "3½, ½x, λ½": "(3+1/2), (1/2)*x, lam*(1/2)",
    "désaxé “Lösung” ｘ＝１": "desaxe \"Losung\" x=1",
    "λ 度 ?": "lam \\u5ea6 ?",
}  # fmt: skip


@pytest.mark.parametrize("text", SPELLED)
def test_formulas_in_ascii(text):
    assert as_encodable(text, "ascii") == SPELLED[text]


def test_a_text_that_can_be_encoded_is_left_as_it_is():
    assert as_encodable("Größe 90° désaxé", "latin-1") == "Größe 90° désaxé"
    assert as_encodable("−√3", "utf-8") == "−√3"


def test_letters_that_can_be_encoded_stay_beside_formulas_that_cannot():
    assert as_encodable("Größe −√3 度", "latin-1") == "Größe -sqrt(3) \\u5ea6"


def test_every_raised_character_is_a_power():
    for character, plain in RAISED.items():
        assert as_encodable(f"x{character}", "ascii").startswith("x^"), (character, plain)


@pytest.mark.slow
def test_no_character_is_lost_whatever_it_is():
    for code in (*range(0x80, 0xD800), *range(0xE000, 0x30000, 7)):
        spelled = as_encodable(f"a{chr(code)}b", "ascii")
        assert spelled.isascii()
        assert "?" not in spelled or chr(code) in ";⁇⁈⁉︖﹖？՞؟¿", hex(code)


@pytest.mark.spread(2)
@pytest.mark.parametrize("encoding", ENCODINGS)
@pytest.mark.parametrize("command", ["balance", "torque", "design", "sensitivities"])
def test_what_the_commands_print_can_be_written_anywhere(command, encoding, capsys):
    text = printed(capsys, command, "v2-45")
    spelled = as_encodable(text, encoding)
    assert spelled.encode(encoding).decode(encoding) == spelled
    assert "?" not in spelled
    assert "\\u" not in spelled
    assert spelled.count("\n") == text.count("\n")


def columns(line: str) -> list[tuple[int, int]]:
    return [cell.span() for cell in re.finditer(r"\S+(?: \S+)*", line)]


def tables(text: str) -> list[list[str]]:
    """Return the tables of an ASCII report: titles above a rule, and the rows of as many cells.

    Where a title takes two lines, the second alone stands above the rule: such a table is left out.
    """
    found = []
    for block in text.split("\n\n"):
        lines = block.split("\n")
        rules = [k for k, line in enumerate(lines) if re.fullmatch(" *-{8,}", line)]
        if rules:
            titles, rows = lines[rules[0] - 1], lines[rules[0] + 1 :]
            if len(columns(titles)) == 1:
                continue
            found.append([titles, *(row for row in rows if len(columns(row)) == len(columns(titles)))])
    return found


@pytest.mark.slow
@pytest.mark.parametrize("name", different_presets()[1::2])
def test_columns_stay_in_line_and_amplitudes_keep_their_value(name, capsys):
    text = as_encodable(printed(capsys, "balance", name), "ascii")
    exact = json.loads(printed(capsys, "balance", name, "--format", "json"))["orders"]
    wanted = {(o["order"], kind): o[kind] for o in exact for kind in ("force", "couple")}
    compared = 0
    for titles, *rows in tables(text):
        for row in rows:
            for head, cell in zip(columns(titles), columns(row), strict=True):
                assert head[0] == cell[0] or head[1] == cell[1], (titles, row)
    kind = ""
    for line in text.splitlines():
        title = re.match(r"Free (force|couple)", line)
        kind = title[1] if title else "" if line and not line.startswith(" ") else kind
        cells = [line[start:end] for start, end in columns(line)]
        if kind and len(cells) >= 6 and cells[0].isdigit() and cells[1] in ("vertical", "lateral"):
            component = wanted[cells[0], kind][cells[1]]
            for cell, key in ((cells[2], "cos"), (cells[3], "sin"), (cells[4], "amplitude")):
                for part in cell.removesuffix(" ~").split(" ~ "):  # exactly, and nearly, or that below
                    apart = value(part) - value(component[key])
                    printed_digits = "." in part  # wide entries stand there rounded to six digits
                    near = 1e-5 * max(1, abs(float(value(component[key]))))
                    assert abs(apart.evalf(30)) < (near if printed_digits else 1e-25), (line, key)
                    compared += 1
    assert compared or not any(o[k][c]["cos"] != "0" for o in exact for k in ("force", "couple")
                               for c in ("vertical", "lateral"))  # fmt: skip


REPORTS = sorted(path.name for path in GOLDEN.glob("*.txt"))


def rows_of_table(text: str) -> tuple[int, list[list[tuple[int, int]]]]:
    """Return where the rule stands, 0 if nowhere, and the cells of rows with one in each column."""
    rows = [columns(line) for line in text.split("\n")]
    rule = next((k for k, line in enumerate(text.split("\n")) if re.fullmatch(" *─{3,}", line)), 0)
    most = max(map(len, rows))
    rows = [row if len(row) == most > 1 and k >= rule - 1 else [] for k, row in enumerate(rows)]
    if min(gaps_of(rows), default=2) < 2:
        return 0, rows  # a cell wider than its column: where it ends, no reader knows
    return rule, rows


def gaps_of(rows: list[list[tuple[int, int]]]) -> list[int]:
    """Return how many blanks at least stand between a column and the next."""
    by_column = zip(*filter(None, rows), strict=True)
    return [
        min(start for start, _ in right) - max(end for _, end in left)
        for left, right in pairwise(by_column)
    ]


@pytest.mark.spread(12)
@pytest.mark.parametrize("name", REPORTS)
def test_a_table_in_ascii_has_its_cells_and_its_columns(name):
    """Cell by cell what stands there, also what goes on alone; no column in another; a rule as wide."""
    before = (GOLDEN / name).read_text(encoding="utf-8")
    for old, new in zip(before.split("\n\n"), as_encodable(before, "ascii").split("\n\n"), strict=True):
        rule, rows = rows_of_table(old)
        old_lines, lines = old.split("\n"), new.split("\n")
        places = [columns(line) if row else [] for row, line in zip(rows, lines, strict=True)]
        if not rule or not any(rows):
            continue
        for old_line, line, row, cells in zip(old_lines, lines, rows, places, strict=True):
            spelled = [as_encodable(old_line[start:end], "ascii") for start, end in row]
            assert [line[start:end] for start, end in cells] == spelled
        gaps = [gaps_of(rows), gaps_of(places)]
        if all(rows[rule - 1 : rule] + rows[rule + 1 :]):  # no cell stands anywhere else
            assert gaps[0] == gaps[1]
            assert len(lines[rule]) == max(row[-1][1] for row in places if row)
        assert min(gaps[1]) >= 2
        for k, line in enumerate(old_lines):
            start = len(line) - len(line.lstrip())
            if k > rule and not rows[k] and len(columns(line)) == 1:
                for was, now in zip(rows[rule - 1], places[rule - 1], strict=False):
                    if was[0] == start > rows[rule - 1][0][0] and len(line) <= was[1]:
                        assert columns(lines[k])[0][0] == now[0]
        assert columns(lines[rule])[0][0] == columns(old_lines[rule])[0][0]


@pytest.mark.slow
@pytest.mark.parametrize("environment", [{"PYTHONIOENCODING": e} for e in ENCODINGS], ids=ENCODINGS)
def test_a_stream_of_another_encoding_loses_nothing(environment):
    encoding = environment["PYTHONIOENCODING"]
    text = program("balance", "v12-60", **environment).decode(encoding)
    assert "6*sqrt(3)" in text
    assert "?" not in text
    document = json.loads(program("balance", "v12-60", "--format", "json", **environment))
    assert document == json.loads(program("balance", "v12-60", "--format", "json"))
    latex = program("balance", "v12-60", "--format", "latex", **environment)
    assert latex == program("balance", "v12-60", "--format", "latex")
    ratio = "λ" if encoding == "cp932" else "lam"
    assert f"--ratio {ratio}" in program("balance", "--help", **environment).decode(encoding)


@pytest.mark.spread(1)
@pytest.mark.parametrize("environment", [C_LOCALE, {}, {"PYTHONIOENCODING": "latin-1"}, {"LC_ALL": "C"}])
def test_an_engine_file_printed_is_one_that_is_read(environment, tmp_path, capsys):
    own = tmp_path / "mine.toml"
    for name in ("audi-v10", "bugatti-w16"):
        assert not preset_text(name).isascii()
        own.write_bytes(program("engines", "--show", name, **environment))
        assert own.read_text(encoding="utf-8") == preset_text(name)
        printed(capsys, "balance", str(own))


@pytest.mark.slow
def test_other_things_for_programs_are_utf8_too(tmp_path):
    notes = tmp_path / "notes.md"
    notes.write_text("$$θ = a$$\n", encoding="utf-8")
    for arguments in (
        ("check", str(notes), "--declare"),
        ("emit", "audi-v10", "--target", "numpy"),
        ("derive", "--format", "latex"),
    ):
        assert program(*arguments, PYTHONIOENCODING="ascii") == program(*arguments)


@pytest.mark.slow
def test_a_pipe_in_the_c_locale_gets_utf8():
    assert program("balance", "v12-60", **C_LOCALE) == program("balance", "v12-60", LC_ALL="C.UTF-8")
    assert "6√3" in program("balance", "v12-60", **C_LOCALE).decode("utf-8")


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="no pseudo-terminal")
def test_a_terminal_that_has_ascii_only_gets_ascii():
    import pty

    ours, theirs = pty.openpty()
    command = [sys.executable, "-m", "symbalance", "balance", "inline-3"]
    running = subprocess.Popen(command, stdout=theirs, env={**os.environ, **C_LOCALE})
    os.close(theirs)
    text = b""
    while True:
        try:
            part = os.read(ours, 65536)
        except OSError:  # the other end is closed
            break
        if not part:
            break
        text += part
    os.close(ours)
    assert running.wait() == 0
    assert text.isascii()
    assert b"sqrt(3)" in text


def test_json_escapes_stand_for_the_same_characters():
    text = json.dumps({"a": "−√3 𝜃 度"}, ensure_ascii=False)
    assert as_json(text, "latin-1").isascii()
    assert json.loads(as_json(text, "latin-1")) == json.loads(text)
    assert as_json(text, "utf-8") == text


# Names of files ---------------------------------------------------------------------------------------

C = "C locale"
ENVIRONMENTS = {
    C: C_LOCALE,
    "ASCII asked for": {"PYTHONIOENCODING": "ascii", "LC_ALL": "C.UTF-8"},
    "UTF-8": {"LC_ALL": "C.UTF-8"},
}
NAMES = {
    (b"b\xff", C): r"b\xff",
    (b"b\xff", "ASCII asked for"): r"b\xff",
    (b"b\xff", "UTF-8"): r"b\xff",
    ("ü".encode(), C): r"\xc3\xbc",
    ("ü".encode(), "ASCII asked for"): r"\xfc",
    ("ü".encode(), "UTF-8"): "ü",
}


def ended(folder, environment: str, *arguments: str | bytes) -> tuple[int, str, str]:
    plain = {k: v for k, v in os.environ.items() if not k.startswith(("LC_", "LANG", "PYTHON"))}
    command = [sys.executable, "-m", "symbalance", *arguments]
    env = {**plain, **ENVIRONMENTS[environment]}
    done = subprocess.run(command, cwd=folder, capture_output=True, check=False, env=env)
    return done.returncode, done.stdout.decode("utf-8"), done.stderr.decode("utf-8")


@pytest.fixture
def folder(tmp_path):
    if os.name != "posix" or sys.platform == "darwin":
        pytest.skip("names of files are text here")
    for name, _ in NAMES:
        for ending, text in ((b".md", "$$1 = 1$$\n"), (b".toml", preset_text("inline-2"))):
            own = "".join(line for line in text.splitlines(True) if not line.startswith("name"))
            with open(
                os.path.join(os.fsencode(tmp_path), name + ending), "w", encoding="utf-8"
            ) as stream:
                stream.write(own)
    return tmp_path


@pytest.mark.slow
@pytest.mark.parametrize(("name", "environment"), NAMES)
def test_a_file_keeps_its_name_wherever_it_is_printed(name, environment, folder):
    shown = NAMES[name, environment]
    code, out, err = ended(folder, environment, "check", name + b".md")
    assert (code, err, out.splitlines()[0]) == (0, "", f"Check of {shown}.md")
    code, out, err = ended(folder, environment, "check", name + b".md", "--format", "json")
    of_file = "ü" if shown == r"\xfc" else shown  # JSON escapes stand for the character
    assert (code, err, json.loads(out)["document"]) == (0, "", f"{of_file}.md")
    code, out, err = ended(folder, environment, "check", name + b".md", "-o", "report.txt")
    assert (code, out, err) == (0, "", "")
    assert (folder / "report.txt").read_text(encoding="utf-8").startswith(f"Check of {of_file}.md\n")
    code, out, err = ended(folder, environment, "check", name + b".md", "--format", "latex")
    of_latex = of_file.replace("\\", r"\textbackslash{}")
    assert rf"Check of \texttt{{{of_latex}.md}}}}" in out.replace(r"\allowbreak{}", "")
    code, out, err = ended(folder, environment, "check", name + b"gone.md")
    assert (code, out) == (2, "")
    assert err.startswith(f"symbalance: {shown}gone.md: cannot be read")


@pytest.mark.slow
@pytest.mark.parametrize("environment", [C, "UTF-8"])
@pytest.mark.parametrize("form", ["text", "json", "latex"])
def test_an_engine_is_named_by_its_file_whatever_that_is_called(form, environment, folder):
    code, out, err = ended(folder, environment, "balance", b"b\xff.toml", "--format", form)
    assert (code, err) == (0, "")
    assert {"text": r"b\xff", "json": r"b\\xff", "latex": r"b\textbackslash{}xff"}[form] in out


def test_the_words_of_notes_are_no_formulas():
    from symbalance.cli.ascii_spelling import as_quoted

    assert as_quoted("sinωt − ½λ² “ü”", "ascii") == r'sin\u03c9t - \xbd\u03bb\xb2 "\xfc"'
    assert as_quoted("sinωt − ½λ²", "utf-8") == "sinωt − ½λ²"


@pytest.mark.slow
def test_what_is_printed_opens_with_no_mark():
    assert program("engines", "--show", "v12-60", PYTHONIOENCODING="utf-8-sig").startswith(b"name")
    document = program("derive", "--format", "latex", PYTHONIOENCODING="utf-8-sig")
    assert document == program("derive", "--format", "latex")
