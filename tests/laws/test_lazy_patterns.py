"""Patterns that are compiled when first used: as those of `re` in all else, and none of them wrong."""

import copy
import gc
import importlib
import pickle
import pkgutil
import re
import subprocess
import sys
from pathlib import Path

import pytest

import symbalance.notes
from symbalance.notes.reading.letters.letter_e import with_number_e
from symbalance.text import lazy_patterns
from symbalance.text.lazy_patterns import LazyPattern

FEW = 250
"""Patterns compiled for a page without a formula: the reader's, a tenth of all."""


def test_every_pattern_of_the_checker_compiles():
    for module in pkgutil.walk_packages(symbalance.notes.__path__, "symbalance.notes."):
        importlib.import_module(module.name)
    patterns = [each for each in gc.get_objects() if type(each) is LazyPattern]
    assert len(patterns) > 1000
    for each in patterns:
        assert each.compiled.pattern == each.pattern


@pytest.mark.parametrize("text", ["", "b", "xaay", "A a"])
def test_a_lazy_pattern_does_what_one_of_re_does(text):
    lazy, plain = lazy_patterns.compile("(a)+", re.IGNORECASE), re.compile("(a)+", re.IGNORECASE)
    assert isinstance(lazy, LazyPattern)
    for name in ("search", "match", "fullmatch"):
        assert str(getattr(lazy, name)(text)) == str(getattr(plain, name)(text))
        assert str(getattr(lazy_patterns, name)(lazy, text)) == str(getattr(plain, name)(text))
    assert lazy.sub("c", text) == lazy_patterns.sub(lazy, "c", text) == plain.sub("c", text)
    assert lazy.split(text) == lazy_patterns.split(lazy, text) == plain.split(text)
    assert lazy.findall(text) == lazy_patterns.findall(lazy, text) == plain.findall(text)
    assert [m.span() for m in lazy.finditer(text)] == [m.span() for m in plain.finditer(text)]
    assert (lazy.pattern, lazy.flags, lazy.groups) == (plain.pattern, plain.flags, plain.groups)


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda p: pickle.loads(pickle.dumps(p))])
def test_a_lazy_pattern_is_copied_before_and_after_its_first_use(copied):
    lazy = lazy_patterns.compile("a+")
    assert copied(lazy).findall("aab") == ["aa"]
    assert lazy.search("a")
    assert copied(lazy).findall("aab") == ["aa"]


def test_a_wrong_pattern_is_refused_at_its_first_use():
    lazy = lazy_patterns.compile("(a")
    with pytest.raises(re.error, match="missing"):
        lazy.search("a")


def test_no_match_is_asked_for_its_pattern_by_identity():
    """`match.re` is the pattern of `re`, never the lazy one: a comparison with that is always false."""
    files = [f for path in symbalance.notes.__path__ for f in Path(path).rglob("*.py")]
    places = [f.name for f in files if re.search(r"\.re (?:is|==|!=|in) ", f.read_text(encoding="utf-8"))]
    assert places == []


def test_an_upright_e_with_a_plain_exponent_is_the_number():
    rewritten = with_number_e(r"\mathrm{e}^{2}, \mathrm{e} and e^2")
    assert rewritten is not None
    assert rewritten.text == r"\exp{2}, \mathrm{e} and e^2"


def test_a_page_without_formulas_compiles_few_patterns_and_loads_no_sympy(tmp_path):
    page = tmp_path / "page.md"
    page.write_text("# Nothing\n", encoding="utf-8")
    code = (
        "import sys, re._compiler as c; n, compile = [], c.compile;"
        "c.compile = lambda p, flags=0: (n.append(p), compile(p, flags))[1];"
        f"from symbalance.cli import run; run(['check', {str(page)!r}]);"
        "print(len(n), sorted({'sympy', 'numpy'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, encoding="utf-8", check=True)
    count, heavy = done.stdout.splitlines()[-1].split(maxsplit=1)
    assert int(count) < FEW
    assert heavy == "[]"
