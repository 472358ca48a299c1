"""The cases of a record: which command lines are run, and under which name what they print is kept.

A case's name is the path of its standard output in the record. `bench` is left out because it
measures the machine, `crankshaft` because it runs for minutes and rounds; of both, the help and the
refusals are kept.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from .engines import Engine
from .inputs import pages

SUFFIX = {"text": "txt", "latex": "tex", "json": "json"}
TARGETS = {
    "numpy": "py",
    "numba": "py",
    "array-api": "py",
    "c": "txt",
    "javascript": "mjs",
    "octave": "m",
}
COMMANDS = (
    "balance",
    "emit",
    "torque",
    "crankshaft",
    "design",
    "overbalance",
    "firing",
    "formulas",
    "draw",
    "page",
    "sheet",
    "atlas",
    "search",
    "sensitivities",
    "sweep",
    "tolerances",
    "assign",
    "derive",
    "bounds",
    "check",
    "engines",
    "bench",
    "completion",
)
QUANTITIES = ("displacement", "velocity", "acceleration", "force", "rod-angle")
ROTATIONS = ("vector", "uvw", "uwv", "vuw", "vwu", "wuv", "wvu")

CHOSEN = (
    "inline-1",
    "inline-3",
    "inline-4",
    "inline-5",
    "inline-4-cross",
    "v2-90",
    "v6-60",
    "v8-90",
    "v12-60",
    "boxer-6",
    "radial-5",
    "man-6s50mc-c",
    "vw-vr6",
    "r-985",
    "napier-lion",
    "own/offset-four",
    "own/link-rod-twin",
    "own/unlike-strokes-four",
    "own/counterweighted-twin",
    "own/lanchester-four",
    "own/even-seven",
    "own/two-stroke-odd-twin",
)
"""Engines of every kind, for the options that would only cost time on all."""
EMITTED = ("inline-1", "inline-5", "v8-90", "v12-60", "vw-vr6", "own/link-rod-twin", "own/unusual-name")
BOTH = "force.vertical,force.lateral,couple.vertical,couple.lateral"


@dataclass(frozen=True)
class Case:
    """One command line, and the name under which what it prints is kept."""

    name: str
    arguments: tuple[str, ...]


def all_cases(engines: Sequence[Engine], inputs: dict[str, bytes]) -> list[Case]:
    """Return every case, in order of their names.

    Engines that `CHOSEN` names and the program does not have are run all the same: it refuses them.
    """
    known = {engine.key: engine for engine in engines}
    chosen = [known.get(key, Engine(key, key, "")) for key in CHOSEN]
    emitted = [known.get(key, Engine(key, key, "")) for key in EMITTED]
    cases = [
        *_helps(),
        *_refusals(),
        *_presets(engines),
        *_balances(engines, chosen),
        *_torques(engines, chosen),
        *_derivations(),
        *_designs(engines, chosen),
        *_tables(),
        *_long_work(),
        *_variations(engines, chosen),
        *_assignments(engines, chosen),
        *_checks(inputs),
        *_sources(engines, emitted),
    ]
    names = [case.name for case in cases]
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        raise ValueError(f"two cases are called {twice[0]}")
    return sorted(cases, key=lambda case: case.name)


def _formats(name: str, formats: Iterable[str], *arguments: str) -> Iterator[Case]:
    for form in formats:
        yield Case(f"{name}.{SUFFIX[form]}", (*arguments, "--format", form))


def _helps() -> Iterator[Case]:
    yield Case("help/symbalance.txt", ("--help",))
    yield Case("help/version.txt", ("--version",))
    for command in COMMANDS:
        yield Case(f"help/{command}.txt", (command, "--help"))


def _refusals() -> Iterator[Case]:
    """Bad input, a row each: what is said, and the exit code."""
    lines = {
        "no-command": "",
        "unknown-command": "blance",
        "unknown-preset": "balance v13",
        "missing-file": "balance nowhere/engine.toml",
        "folder": "balance inputs/engines/own/",
        "not-an-engine": "balance inputs/pages/hand/vtwin.symbols.toml",
        "bad-toml": "balance inputs/pages/hand/hostile/bad_toml.symbols.toml",
        "order-0": "balance v8-90 --order 0",
        "order-1001": "balance v8-90 --order 1001",
        "order-half": "balance v8-90 --order 2.5",
        "power-too-small": "balance v12-60 --power 1",
        "ratio-1": "balance v8-90 --ratio 1",
        "ratio-word": "balance v8-90 --ratio four",
        "ratio-short-of-the-offset": "balance inputs/engines/own/one-offset.toml --ratio 1.05",
        "unknown-format": "balance v8-90 --format yaml",
        "output-in-no-folder": "balance v8-90 -o nowhere/out.txt",
        "torque-without-bore": "torque v8-90 --compression 10 --rpm 3000",
        "torque-without-stroke": "torque v8-90 --compression 10 --bore 90 --rpm 3000",
        "torque-two-pressures": "torque v8-90 --compression 9 --pressure inputs/pressure-4.csv --bore 90",
        "torque-stroke-without-pressure": "torque inputs/engines/own/sized-four.toml --stroke 80",
        "torque-stroke-twice": "torque inputs/engines/own/sized-four.toml --compression 9 --bore 80 "
        "--rpm 900 --stroke 80",
        "sensitivities-no-ratio": "sensitivities inputs/engines/own/geometry-only-six.toml",
        "emit-no-ratio": "emit inputs/engines/own/geometry-only-six.toml --target numpy",
        "emit-gas-without-order": "emit inputs/engines/own/sized-four.toml --target numpy "
        "--outputs torque.gas --compression 9 --bore 80 --rpm 900",
        "derive-unknown": "derive --quantity jerk",
        "derive-both": "derive --quantity force --rotation uvw",
        "design-order-3": "design v8-90 --remove 3",
        "design-stations": "design v8-90 --stations=1,1",
        "tolerances-none": "tolerances v8-90",
        "tolerances-kilograms": "tolerances v8-90 --mass 0.002",
        "assign-too-few": "assign v8-90 --parts inputs/parts/7.csv",
        "assign-no-file": "assign v8-90 --parts nowhere.csv",
        "engines-unknown": "engines --show v13",
        "check-no-file": "check nowhere.md",
        "check-unknown-suffix": "check inputs/pressure-4.csv",
        "emit-no-target": "emit v8-90",
        "emit-unknown-output": "emit v8-90 --target numpy --outputs force.up",
        "emit-c-to-the-terminal": "emit v8-90 --target c",
        "crankshaft-preset": "crankshaft v8-90 -o out/",
        "crankshaft-no-tables": "crankshaft inputs/engines/own/sized-four.toml -o out/",
        "bench-unknown": "bench speed",
    }
    for name, line in lines.items():
        yield Case(f"refusals/{name}.txt", tuple(line.split()))


def _presets(engines: Sequence[Engine]) -> Iterator[Case]:
    yield Case("engines/list.txt", ("engines",))
    for engine in engines:
        if engine.argument == engine.key:
            yield Case(f"engines/{engine.key}.toml", ("engines", "--show", engine.key))


def _balances(engines: Sequence[Engine], chosen: Sequence[Engine]) -> Iterator[Case]:
    for engine in engines:
        yield from _formats(f"balance/{engine.key}", SUFFIX, "balance", engine.argument)
    for engine in chosen:
        key, line = engine.key, ("balance", engine.argument)
        yield from _formats(f"balance-order-24/{key}", ("json", "text"), *line, "--order", "24")
        yield from _formats(f"balance-ratio/{key}", ("json", "latex"), *line, "--ratio", "147.15/36.65")
        yield from _formats(f"balance-power/{key}", ("text",), *line, "--order", "6", "--power", "11")
    names = ("v8-90", "v8-90-flat", "inline-5", "v6-60")
    for extra in ((), ("--percent",), ("--phases",)):
        name = "".join(("balance-several/table", *extra))
        yield from _formats(name, SUFFIX, "balance", *names, "--order", "6", *extra)
    yield Case("balance-file/v8-90.txt", ("balance", "v8-90", "-o", "v8.txt"))


def _torques(engines: Sequence[Engine], chosen: Sequence[Engine]) -> Iterator[Case]:
    for engine in engines:
        yield from _formats(f"torque/{engine.key}", SUFFIX, "torque", engine.argument)
        if engine.text:
            running = ("--compression", "10", "--bore", "85", "--rpm", "3000", *engine.missing_sizes)
            line = ("torque", engine.argument, *running, *engine.missing_ratio)
            yield from _formats(f"torque-running/{engine.key}", ("json", "text"), *line)
    for engine in chosen:
        if engine.text:
            trace = (
                "--pressure",
                f"inputs/pressure-{engine.strokes}.csv",
                "--bore",
                "85",
                "--rpm",
                "1500",
            )
            line = ("torque", engine.argument, *trace, *engine.missing_sizes, "--delta", "0.01")
            yield from _formats(f"torque-pressure/{engine.key}", ("json", "latex"), *line, "--order", "4")
            motored = ("--compression", "8.5", "--heat", "0", "--bore", "85", "--rpm", "600")
            line = ("torque", engine.argument, *motored, *engine.missing_sizes)
            yield from _formats(f"torque-motored/{engine.key}", ("json",), *line)
        line = ("torque", engine.argument, "--order", "12", "--ratio", "3.5")
        yield from _formats(f"torque-order-12/{engine.key}", ("json",), *line)


def _derivations() -> Iterator[Case]:
    for quantity in QUANTITIES:
        for convention in ("l/r", "r/l", "l/s"):
            for order in ("6", "13"):
                name = f"derive/{quantity}.{convention.replace('/', '-over-')}.{order}"
                line = ("--quantity", quantity, "--convention", convention, "--order", order)
                yield from _formats(name, ("text", "latex"), "derive", *line)
    for rotation in ROTATIONS:
        line = ("--quantity", "crank-node", "--rotation", rotation)
        yield from _formats(f"derive/crank-node.{rotation}", ("text", "latex"), "derive", *line)


def _designs(engines: Sequence[Engine], chosen: Sequence[Engine]) -> Iterator[Case]:
    for engine in engines:
        line = ("design", engine.argument, *engine.missing_ratio)
        yield from _formats(f"design/{engine.key}", SUFFIX, *line)
        yield from _formats(f"design-order-1/{engine.key}", ("json",), *line, "--remove", "1")
        yield from _formats(f"design-one-shaft/{engine.key}", ("json", "text"), *line, "--shafts", "1")
    variants = {
        "no-counter-rotation": ("--remove", "1", "--no-counter-rotation"),
        "no-counterweights": ("--remove", "1", "--no-counterweights"),
        "even": ("--remove", "1,2", "--spread", "even"),
        "stations": ("--remove", "1", "--stations=1,-1"),
        "per-throw": ("--remove", "1", "--per-throw"),
        "weighed": ("--shafts", "1", "--vertical", "2", "--lateral", "0.5", "--length", "3"),
        "ratio": ("--remove", "2", "--ratio", "3.5"),
        "write": ("--remove", "1", "--write", "balanced.toml"),
    }
    for engine in chosen:
        for variant, options in variants.items():
            form = "text" if variant == "write" else "json"
            line = ("design", engine.argument, *options)
            yield from _formats(f"design-{variant}/{engine.key}", (form,), *line)
    for engine in engines:
        if engine.has_all_sizes:
            line = ("design", engine.argument, "--most", "30")
            yield from _formats(f"design-most/{engine.key}", ("json", "text"), *line)


def _variations(engines: Sequence[Engine], chosen: Sequence[Engine]) -> Iterator[Case]:
    for engine in engines:
        line = ("sensitivities", engine.argument, *engine.missing_ratio)
        yield from _formats(f"sensitivities/{engine.key}", SUFFIX, *line)
        line = ("tolerances", engine.argument, "--mass", "0.5%", "--throw", "0.1", *engine.missing_ratio)
        yield from _formats(f"tolerances/{engine.key}", SUFFIX, *line)
    everything = ("--bank", "0.1", "--station", "0.2%", "--rotating", "0.5%")
    lengths = ("--stroke", "0.05", "--rod", "0.05", "--offset", "0.05")
    for engine in chosen:
        line = ("sensitivities", engine.argument, "--order", "6", "--parameters", "mass,station,rod")
        yield from _formats(f"sensitivities-some/{engine.key}", ("json",), *line)
        line = ("tolerances", engine.argument, "--mass", "1%", *everything, "--of", "vertical,forward")
        yield from _formats(f"tolerances-places/{engine.key}", ("json",), *line)
    for engine in engines:
        if engine.has_all_sizes:
            line = ("tolerances", engine.argument, *lengths, "--rpm", "3000")
            yield from _formats(f"tolerances-lengths/{engine.key}", ("json", "text"), *line)
            masses = ("--mass", "0.002", "--throw", "0.1", "--rpm", "3000")
            line = ("tolerances", engine.argument, *masses)
            yield from _formats(f"tolerances-newtons/{engine.key}", ("json", "text"), *line)


def _assignments(engines: Sequence[Engine], chosen: Sequence[Engine]) -> Iterator[Case]:
    for engine in engines:
        line = _assign(engine)
        yield from _formats(f"assign/{engine.key}", ("json", "text"), *line, "--paired")
    for engine in chosen:
        if engine.text and engine.cylinders <= 6:
            yield from _formats(f"assign-two-sets/{engine.key}", ("json", "latex"), *_assign(engine))
        options = ("--paired", "--orders", "1,2", "--whole")
        yield from _formats(f"assign-whole/{engine.key}", ("json",), *_assign(engine), *options)
    for engine in engines:
        if engine.has_all_sizes:
            options = ("--paired", "--lever", "100", "--rpm", "3000")
            yield from _formats(
                f"assign-newtons/{engine.key}", ("json", "text"), *_assign(engine), *options
            )


def _assign(engine: Engine) -> tuple[str, ...]:
    count = engine.cylinders if engine.text else 1
    return ("assign", engine.argument, "--parts", f"inputs/parts/{count}.csv")


def _checks(inputs: dict[str, bytes]) -> Iterator[Case]:
    for page in pages(inputs):
        path, key = f"inputs/{page}", page.removeprefix("pages/")
        yield from _formats(f"check/{key}", SUFFIX, "check", path)
        yield Case(f"check-declare/{key}.toml", ("check", path, "--declare"))


def _tables() -> Iterator[Case]:
    """Bounds, firing orders and overbalance: a few of each."""
    for ratio in ("4", "3"):
        yield from _formats(f"bounds/{ratio}", SUFFIX, "bounds", "--ratio", ratio)
    yield from _formats("firing/v8-90", SUFFIX, "firing", "v8-90")
    yield from _formats("firing/uneven", ("text",), "firing", "v2-45", "--uneven")
    yield from _formats("firing/cranks", SUFFIX, "firing", "--cylinders", "5")
    yield from _formats("firing/vee", SUFFIX, "firing", "--cylinders", "6", "--vee", "60,90")
    yield from _formats("formulas/row", SUFFIX, "formulas", "--order", "4")
    yield from _formats("formulas/twin", SUFFIX, "formulas", "v2-90", "--bank", "alpha", "--masses", "m")
    for name in ("inline-1", "v2-45", "boxer-6"):
        yield from _formats(f"overbalance/{name}", SUFFIX, "overbalance", name)


def _long_work() -> Iterator[Case]:
    """Searches, sweeps and reports of several: work in parts, some of it kept (in `finished/`)."""
    lines = {
        "twelve": "search --cylinders 12 --strokes 2 --require couple.1=0,couple.2=0 --limit couple.4<=3",
        "proof": "search --cylinders 8 --strokes 2 --require couple.1=0 --certificate proof.json",
        "none": "search --cylinders 5 --require couple.1=0,couple.2=0 --certificate none.json",
        "any": "search --cylinders 4 --intervals any --grid 90 --minimize evenness,couple.1,adjacent",
        "pins": "search --cylinders 6 --banks=-45,45 --pins split --minimize couple.1,bearing",
        "shafts": "search --cylinders 6 --minimize couple.2,bending --after balance-shafts 1",
        "engines": "search --cylinders 5 --minimize couple.1,couple.2 --engines stars/",
    }
    for name, line in lines.items():
        yield from _formats(f"search/{name}", ("text", "json"), *line.split())
    kept = {
        "sweep": "sweep v2-90 --vary ratio=3:5:0.5 --vary bank=60,75,90 --quantities force.1,torque.2",
        "search": "search --cylinders 7 --minimize couple.1,couple.2,adjacent",
    }
    for name, line in kept.items():
        yield from _formats(f"kept/{name}", ("text", "json"), *line.split(), "--keep", "finished/")
    two = ("inputs/pages/hand/vtwin.txt", "inputs/pages/hand/lanchester.md")
    yield from _formats("kept/check", ("text", "json"), "check", *two, "-o", "reports/", "--lenient")
    yield Case("kept/balance.txt", ("balance", "inline-4", "v8-90", "vw-vr6", "-o", "balances/"))
    yield Case("kept/budget.txt", ("check", two[0], "--budget", "1h,8GB"))


def _sources(engines: Sequence[Engine], emitted: Sequence[Engine]) -> Iterator[Case]:
    for engine in engines:
        line = (engine.argument, "--outputs", f"{BOTH},torque.inertia", *engine.missing_ratio)
        yield _source(f"emit-all/{engine.key}", "numpy", *line)
    turning = "force.forward,force.backward,couple.forward,couple.backward"
    for engine in emitted:
        for target in TARGETS:
            at = f"emit/{engine.key}"
            yield _source(f"{at}/plain", target, engine.argument)
            yield _source(f"{at}/frame", target, engine.argument, "--outputs", BOTH)
            yield _source(f"{at}/turning", target, engine.argument, "--outputs", turning)
            yield _source(f"{at}/torque", target, engine.argument, "--outputs", "torque.inertia")
            yield _source(f"{at}/order-2", target, engine.argument, "--order", "2", "--uniform-grid")
            yield _source(f"{at}/tolerance", target, engine.argument, "--tolerance", "1e-6")
        if engine.text:
            outputs = ("--outputs", "torque.gas,torque.total,torque.frame", "--order", "24")
            running = ("--compression", "10", "--bore", "85", "--rpm", "3000", *engine.missing_sizes)
            for target in ("numpy", "c"):
                yield _source(f"emit/{engine.key}/gas", target, engine.argument, *outputs, *running)
    piston = ("--outputs", "piston.displacement,piston.velocity,piston.acceleration")
    for target in TARGETS:
        yield _source("emit/inline-4/piston", target, "inline-4", *piston)
        yield _source("emit/inline-4/ratio-3.5", target, "inline-4", "--ratio", "3.5")


def _source(name: str, target: str, *arguments: str) -> Case:
    # C is two files, so it cannot go to the terminal.
    output = ("-o", "engine.c") if target == "c" else ()
    return Case(f"{name}/{target}.{TARGETS[target]}", ("emit", *arguments, "--target", target, *output))
