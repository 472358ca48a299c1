"""Firing intervals and frequencies of orders, as numbers: "the straight six fires every 720°/5" is wrong.

An engine whose cranks are even fires at equal intervals of two turns over its cylinders, of one turn if
it is a two-stroke. Of a twin, of banks and of uneven firing nothing is said.
"""

from __future__ import annotations

from math import isclose, pi

from symbalance.document.formula import Formula, Name, names
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision, without_dots
from symbalance.notes.checking.meant.engine_speeds import speeds_of
from symbalance.notes.checking.meant.engines.engine_claims import EngineClaims
from symbalance.notes.checking.meant.meant_words import NOBODY
from symbalance.notes.checking.meant.products import NoProductError, product_of
from symbalance.notes.checking.words.engines_in_words import NamedEngine
from symbalance.notes.checking.words.working_cycles import last_strokes
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_INTERVAL = re.compile(
    r"(?:firing|ignition|explosion)\s+(?:interval|spacing|distance)"
    r"|intervals?\s+between\s+(?:two\s+)?(?:firings|ignitions)"
    r"|zünd(?:folge)?abst[aä]nd|zündintervall|(?:点火|爆発|着火)間隔|intervalle\s+d.allumage"
    r"|intervalo\s+de\s+encendido"
    r"|intervallo\s+(?:di|tra\s+le)\s+accension|ontstekingsinterval|odstęp\s+zapłon|tändintervall"
    r"|(?:fires?|ignites?|fired|zündet)\s[^.;:=]{0,30}?(?:every|intervals?|alle\s|abständen)",
    re.IGNORECASE,
)
_UNEVEN = re.compile(
    r"uneven|ungleich|irregular|unregelmäßig|不等|\bodd|per\s+bank|je\s+bank|cross-?plane|big[\s-]?bang"
    r"|クロスプレーン"
    r"|camshaft|nockenwelle|カム|split|between\s+cylinders?\s+[0-9]",
    re.IGNORECASE,
)
_OTHER_ANGLE = re.compile(
    r"crank|throw|offset|angle|bank|winkel|kröpf|\bpins?\b|lead|vor\b|クランク|角", re.IGNORECASE
)
_FREQUENCY = re.compile(
    r"frequenc(?:y|ies)|frequenz|周波数|振動数|fréquence|frecuencia|frequenza", re.IGNORECASE
)
_OTHER_RATE = re.compile(
    r"fir(?:es|ing)|ignit|zünd|点火|natural|eigen|固有|camshaft|nockenwelle|angular|kreisfrequenz|角"
    r"|half|ratio|verhältnis"
    r"|resonan|critical|kritisch",
    re.IGNORECASE,
)
_FEWEST = 3


def refute_repeated_interval(claims: EngineClaims, chain: Chain, k: int) -> Decision | None:
    """Return the refutation of a number that stands above too, where its sentence names the strokes."""
    if not claims.names_strokes or not last_strokes(claims.sentence(chain)):
        return None
    decision = decide_firing_interval(claims, chain, k)
    return decision if decision is not None and decision.status == REFUTED else None


def decide_firing_interval(claims: EngineClaims, chain: Chain, k: int) -> Decision | None:
    """Return the decision on a number for the firing interval of a named engine; None for others."""
    head, value = chain.sides[0].node, without_dots(chain.sides[1].node)[0]
    if k or not isinstance(head, Name) or names(value) or chain.relations[0].sign not in "=≈":
        return None
    words = claims.sentence(chain)
    heading = claims.sections.heading_above(chain.lines[0])
    match = _INTERVAL.search(words) or (None if _OTHER_ANGLE.search(words) else _INTERVAL.search(heading))
    engine = None if match is None else claims.engine_of(chain)
    if (
        match is None
        or engine is None
        or engine.cylinders < _FEWEST
        or _UNEVEN.search(claims.section(chain))
    ):
        return None
    size = _angle(value)
    if size is None:
        return None
    cycle = last_strokes(words) or last_strokes(claims.section(chain))
    text = (
        f"{plain_letter(head.name)} is the firing interval of {engine.cylinders} cylinders"
        f" ({NOBODY}; taken from the words “{match[0]}” and “{engine.words}”)"
    )
    for strokes in (4, 2):
        if isclose(size, _even(engine, strokes), rel_tol=1e-3) and cycle in (0, strokes):
            return Decision(
                PROVED, assumptions=(text, f"the engine is a {strokes}-stroke with even firing")
            )
    if not cycle and isclose(size, _even(engine, 2), rel_tol=1e-3):
        return None
    turns = f"{_even(engine, cycle or 4) * 180 / pi:.6g}°"
    return Decision(REFUTED, f"if {text}: with even firing it is {turns}")


def decide_order_frequency(claims: EngineClaims, chain: Chain, k: int) -> Decision | None:
    """Return the decision on a number for an order's frequency at the speed its sentence names."""
    head, value = chain.sides[0].node, without_dots(chain.sides[1].node)[0]
    if k or not isinstance(head, Name) or names(value) or chain.relations[0].sign not in "=≈":
        return None
    words = claims.sentence(chain)
    speeds, orders = speeds_of(words), claims.orders_before(chain)
    if not _FREQUENCY.search(words) or _OTHER_RATE.search(words) or len(speeds) != 1 or len(orders) != 1:
        return None
    (speed,), (order,) = speeds, orders
    try:
        number = product_of(value).number * 60 / speed
    except NoProductError:
        return None
    typed = claims.words.document.source(chain.sides[1].span)
    if typed.strip(" $").startswith(str(speed)) and words.count(str(speed)) == 1:
        return None  # the order at n = 3000 rpm: it is the speed itself, which nothing else names
    text = (
        f"{plain_letter(head.name)} is the frequency of the order {order} at {speed} turns a minute"
        f" ({NOBODY}; taken from the words “{_FREQUENCY.findall(words)[-1]}”)"
    )
    if isclose(number, order, rel_tol=5e-3):
        return Decision(PROVED, assumptions=(text,))
    is_slip = any(isclose(number, order * factor, rel_tol=1e-3) for factor in (0.5, 2, 1 / order, order))
    return Decision(REFUTED, f"if {text}: it is {order * speed / 60:.6g} 1/s") if is_slip else None


def _even(engine: NamedEngine, strokes: int) -> float:
    return strokes * pi / engine.cylinders


def _angle(value: Formula) -> float | None:
    """Return an angle in radians, None for what is none."""
    try:
        size = product_of(value).number
    except NoProductError:
        return None
    return size if 0 < size < 4 * pi else None
