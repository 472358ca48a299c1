"""The JSON Schemas that the package ships: each describes every key of a result's JSON, and no other."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest
from sympy import Symbol

import symbalance as sb
from symbalance.checking import check
from symbalance.crankshaft.running.measured import Comparison
from symbalance.document.result import Result, to_json
from symbalance.engine.engine_file import SCHEMA as ENGINE_FILE
from symbalance.kinematics.conventions import CONVENTIONS
from symbalance.kinematics.truncation_table import UNITS
from symbalance.notes.checking.reports.document_table import DocumentRow, DocumentTable
from symbalance.notes.checking.verdicts import VERDICTS
from tests import TESTS
from tests.results import EXAMPLES, UNEVEN, example, result_classes

Schema = dict[str, Any]
PACKAGE = Path(sb.__file__).parent
ENGINES = TESTS / "record" / "engines"
CLASSES = {cls.kind: cls for cls in result_classes()}


def _engine(name: str) -> sb.Engine:
    return sb.load(ENGINES / f"{name}.toml")


def _measured() -> Result:
    """A run of a crankshaft with a measured curve beside it, and films about orbits."""
    run: Any = example("crankshaft")
    none = np.empty(0)
    measured = Comparison(1000.0, "pin 1 bending", none, none, rms=1.5, peak=-2.0, span=80.0)
    return replace(run, comparisons=(measured,), speeds=(replace(run.speeds[0], departure=0.01),))


def _bound() -> Result:
    """A line that is bound to a quantity, has a number, and is read generously."""
    text = "$$x = r(1 - \\cos\\theta) + \\frac{r}{4\\lambda}(1 - \\cos 2\\theta) \\quad - (1)$$\n"
    letters = {"theta": "crank angle", "r": "crank radius", "lambda": "rod ratio l/r"}
    verdict = sb.check(text, {**letters, "x": "displacement from top dead centre"}).verdicts[0]
    assert verdict.tag
    return replace(verdict, bind="displacement", notes=("read generously",))


def _on_two_lines() -> Result:
    """A relation whose side goes on in a second line."""
    return sb.check("$$a = b +\n c$$\n", {"a": "any", "b": "any", "c": "any"})


def _notebook() -> Result:
    """A notebook with decimal commas and a relation of words."""
    page = TESTS / "hand" / "secondary.ipynb"
    report: Any = sb.check(page)
    words = sb.check("Kraft = Masse und 0,045 = 0,045\n").derivation
    return replace(
        report,
        derivation=replace(report.derivation, notes=words.notes, not_mathematics=words.not_mathematics),
    )


def _table_of_a_notebook() -> Result:
    return DocumentTable((DocumentRow("secondary.ipynb", _notebook().data(), 1),))


VARIANTS: dict[str, Callable[[], Result]] = {
    "balance-with-shafts-aside": lambda: sb.balance(_engine("lanchester-four"), 4),
    "balance-with-weights-on-webs": lambda: sb.balance(_engine("placed-counterweights-three"), 2),
    "balance-with-symbols": lambda: sb.balance(sb.vee(Symbol("alpha"), pins=[0]), 2),
    "torque-of-rods": lambda: sb.torque.torque_report(_engine("rod-inertia-twin"), 3),
    "ellipse-with-symbols": lambda: sb.design.ellipse(
        sb.balance(sb.vee(Symbol("alpha"), pins=[0]), 1), 1, "force"
    ),
    "design-with-limits": lambda: sb.design_balance(
        _engine("sized-four"), [2], shafts=1, stations=["1/2", 0], most="1000"
    ),
    "worst-cases-without-a-speed": lambda: sb.worst_cases(
        sb.load("inline-4"), sb.design.Tolerances(mass="1%", station="1%"), 2
    ),
    "rotating-balance-in-shares": lambda: sb.design.balanced_weights(
        [sb.engine.Weight(1, 0, share=2)], [1]
    ),
    "critical-speeds-of-supports-by-speed": lambda: sb.crankshaft.rotor.critical_speeds(
        example("whirl").rotor,  # type: ignore[attr-defined]
        lambda speed: UNEVEN,
        most=300.0,
    ),
    "crankshaft-measured": _measured,
    "verdict-bound": _bound,
    "check-on-two-lines": _on_two_lines,
    "check-on-proposals": lambda: check("crank radius r\n\n$$v = r u$$", accept_proposals=True),
    "check-of-a-notebook": _notebook,
    "document-table-of-a-notebook": _table_of_a_notebook,
    "verdict-in-a-notebook": lambda: sb.check(TESTS / "hand" / "secondary.ipynb").verdicts[0],
}
"""Results with keys that no example of `tests.results` has, and with null where those have values."""


@cache
def result(name: str) -> Result:
    return VARIANTS[name]() if name in VARIANTS else example(name)


@cache
def written(name: str) -> Any:
    """Return a result's JSON, read back."""
    return json.loads(to_json(result(name)))


def closed(schema: Any) -> Any:
    """Return a schema that refuses every key it does not describe."""
    if isinstance(schema, list):
        return [closed(part) for part in schema]
    if not isinstance(schema, dict):
        return schema
    shut = {key: closed(part) for key, part in schema.items()}
    if isinstance(schema.get("properties"), dict) and "type" in schema:
        shut.setdefault("additionalProperties", False)
    return shut


def checker(schema: Schema) -> jsonschema.Draft202012Validator:
    return jsonschema.Draft202012Validator(schema)


def properties(schema: Schema) -> Iterator[tuple[str, Schema]]:
    """Yield every key that a schema describes, by its place, with what is said of it."""
    yield from _below(schema, "")
    for name, part in schema.get("$defs", {}).items():
        yield from _below(part, f"#{name}")


def _below(schema: Schema, place: str) -> Iterator[tuple[str, Schema]]:
    for key, part in schema.get("properties", {}).items():
        yield f"{place}/{key}", part
        yield from _below(part, f"{place}/{key}")
    for word in ("items", "additionalProperties"):
        if word in schema:
            yield from _below(schema[word], place)


def used(value: Any, schema: Schema, root: Schema, place: str = "") -> Iterator[str]:
    """Yield the places of the keys that a value has, as `properties` names them."""
    if "$ref" in schema:
        name = schema["$ref"].removeprefix("#/$defs/")
        yield from used(value, root["$defs"][name], root, f"#{name}")
    for part in schema.get("anyOf", ()):
        if checker({**part, "$defs": root.get("$defs", {})}).is_valid(value):
            yield from used(value, part, root, place)
    if isinstance(value, dict):
        for key, inner in value.items():
            part = schema.get("properties", {}).get(key)
            if part is not None:
                yield f"{place}/{key}"
                yield from used(inner, part, root, f"{place}/{key}")
            elif "additionalProperties" in schema:
                yield from used(inner, schema["additionalProperties"], root, place)
    elif isinstance(value, list) and "items" in schema:
        for inner in value:
            yield from used(inner, schema["items"], root, place)


def test_every_class_of_result_has_a_schema_and_no_file_is_left_over() -> None:
    shipped = {path for path in PACKAGE.rglob("*.schema.json") if path.name != ENGINE_FILE}
    modules = {kind: cls.__module__ for kind, cls in CLASSES.items()}
    folders = {kind: [p for p in shipped if p.name == f"{kind}.schema.json"] for kind in modules}
    assert {kind: len(paths) for kind, paths in folders.items()} == dict.fromkeys(modules, 1)
    assert len(shipped) == len(modules)
    assert all(cls.json_schema() for cls in CLASSES.values())


@pytest.mark.parametrize("kind", sorted(CLASSES))
def test_a_schema_is_sound_and_names_its_kind_and_version(kind: str) -> None:
    cls = CLASSES[kind]
    schema = cls.json_schema()
    jsonschema.Draft202012Validator.check_schema(schema)
    assert schema["$schema"] == "https://json-schema.org/draft/2020-12/schema"
    assert schema["$id"] == f"urn:symbalance:{kind}:{cls.schema_version}"
    assert schema["properties"]["schema"]["properties"] == {
        "result": {"const": kind},
        "version": {"const": cls.schema_version},
    }
    assert schema["title"]
    assert "additionalProperties" not in schema


@pytest.mark.parametrize("kind", sorted(CLASSES))
def test_a_schema_says_of_every_key_what_it_is(kind: str) -> None:
    schema = CLASSES[kind].json_schema()
    definitions = schema.get("$defs", {})
    silent = []
    for place, part in properties(schema):
        if place.startswith("/schema/"):
            continue
        target = definitions[part["$ref"].removeprefix("#/$defs/")] if "$ref" in part else part
        words = part.get("description", target.get("description", ""))
        if len(words) < 3 or not ("type" in target or "anyOf" in target):
            silent.append(place)
    assert not silent


@pytest.mark.slow
@pytest.mark.parametrize("name", [*EXAMPLES, *VARIANTS])
def test_what_is_written_fits_its_schema_and_every_key_is_described(name: str) -> None:
    schema = CLASSES[written(name)["schema"]["result"]].json_schema()
    assert schema == result(name).json_schema()
    checker(schema).validate(written(name))
    checker(closed(schema)).validate(written(name))


@pytest.mark.slow
def test_no_key_is_described_that_no_result_has() -> None:
    described = {
        _anywhere(kind, place)
        for kind, cls in CLASSES.items()
        for place, _ in properties(cls.json_schema())
    }
    met: set[str] = set()
    for name in [*EXAMPLES, *VARIANTS]:
        value = written(name)
        kind = value["schema"]["result"]
        schema = CLASSES[kind].json_schema()
        met |= {_anywhere(kind, place) for place in used(value, schema, schema)}
    assert described == met


def _anywhere(kind: str, place: str) -> str:
    """Return a key's place with one name for all schemas that define it alike."""
    name = place.removeprefix("#").split("/")[0]
    return kind + place if not name else place.removeprefix("#") if name in CLASSES else place


def test_what_several_schemas_define_is_defined_alike() -> None:
    known: dict[str, Any] = {}
    for kind, cls in CLASSES.items():
        for name, part in cls.json_schema().get("$defs", {}).items():
            assert known.setdefault(name, part) == part, (kind, name)
    for name in known.keys() & CLASSES.keys():  # a result within another
        own = CLASSES[name].json_schema()
        keys = {key: part for key, part in own["properties"].items() if key != "schema"}
        assert known[name]["properties"] == keys
        assert known[name]["required"] == [key for key in own["required"] if key != "schema"]
    assert {"balance", "running-torque", "verdict"} <= known.keys()


def test_the_words_that_a_schema_lists_are_those_there_are() -> None:
    check = CLASSES["check"].json_schema()
    assert check["$defs"]["verdict_word"]["enum"] == list(VERDICTS)
    derivation = CLASSES["derivation"].json_schema()["properties"]
    assert set(derivation["convention"]["enum"]) == set(CONVENTIONS)
    bounds = CLASSES["truncation-bounds"].json_schema()["properties"]
    assert set(bounds["quantity"]["enum"]) == set(derivation["quantity"]["enum"]) == set(UNITS)


@pytest.mark.slow
@pytest.mark.parametrize("kind", sorted(CLASSES))
def test_a_fault_in_a_result_is_refused(kind: str) -> None:
    schema, value = CLASSES[kind].json_schema(), written(kind)
    check = checker(schema)
    for key in value:
        optional = key not in schema["required"]
        assert check.is_valid({k: v for k, v in value.items() if k != key}) == optional, key
        of_another_type: Any = 1 if isinstance(value[key], dict) else {"another": "type"}
        assert not check.is_valid({**value, key: of_another_type}), key
    assert not check.is_valid({**value, "schema": {**value["schema"], "version": 99}})
    assert check.is_valid({**value, "a_key_of_a_later_version": 1})


def test_a_fault_deep_in_a_balance_is_refused() -> None:
    check = checker(CLASSES["balance"].json_schema())
    for fault in (
        lambda order: order["force"]["vertical"].pop("cos"),
        lambda order: order["force"]["vertical"].update(cos=6.0),
        lambda order: order["couple"].pop("backward"),
        lambda order: order["coefficient"].update(value=0.25),
        lambda order: order["force"]["lateral"].update(decimal=["1"]),
        lambda order: order.update(order=2),
    ):
        value = json.loads(to_json(example("balance")))
        assert check.is_valid(value)
        fault(value["orders"][0])
        assert not check.is_valid(value)


def test_a_class_without_a_schema_is_refused() -> None:
    class Another(Result):
        kind = "another"

    for cls in (Result, Another):
        with pytest.raises(sb.SymbalanceError, match="has no JSON Schema"):
            cls.json_schema()
