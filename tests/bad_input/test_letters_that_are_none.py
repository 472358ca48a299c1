"""A line of the symbols file that names no letter costs its own meaning, not the page: and it is said."""

import pytest

from symbalance.checking import check
from symbalance.cli import run

PAGE = "With the crank radius $r$ the stroke is $s = 2r$, and $s/2 = r$.\n"
GOOD = '[symbols]\n"r" = "crank radius"\n"s" = "stroke"\n'
NONE = ["|\\\\ddot x|_{\\\\rm PMB}", "E_1 - E_2", "\\\\lamda", "x("]


def _verdicts(checked):
    return [(v.line, v.verdict) for v in checked.verdicts]


@pytest.mark.parametrize("key", NONE)
def test_the_page_is_judged_as_without_the_line(tmp_path, key):
    page = tmp_path / "page.md"
    page.write_text(PAGE)
    symbols = tmp_path / "page.symbols.toml"
    symbols.write_text(GOOD)
    without = check(page)
    symbols.write_text(GOOD + f'"{key}" = "something"\n')
    checked = check(page)
    assert _verdicts(checked) == _verdicts(without)
    assert not without.failed
    assert not without.unread_letters
    assert checked.failed
    assert not checked.fails(lenient=True)
    assert checked.unread_letters == 1
    (remark,) = checked.data()["remarks"]
    assert remark.startswith(f"Declares nothing: {symbols}:4: ")
    assert "is not a letter" in remark


def test_one_document_and_a_folder_name_the_line_once_and_exit_with_1(tmp_path, capsys):
    for name in "ab":
        (tmp_path / f"{name}.md").write_text(PAGE)
    (tmp_path / "symbols.toml").write_text(GOOD + '"|x|" = "size"\n')
    assert run(["check", str(tmp_path / "a.md")]) == 1
    assert capsys.readouterr().out.count("Declares nothing") == 1
    assert run(["check", str(tmp_path)]) == 1
    assert capsys.readouterr().out.count("Declares nothing") == 1
    assert run(["check", str(tmp_path), "--lenient"]) == 0


def test_a_scope_and_a_mapping_say_it_too():
    scope = {"symbols": {"r": "crank radius"}, "scope": [{"lines": [1, 2], "symbols": {"r(": "radius"}}]}
    assert check(PAGE, scope).unread_letters == 1
    assert check(PAGE, {"r": "crank radius", "s": "stroke", "2x": "double"}).unread_letters == 1
