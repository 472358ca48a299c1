"""Values where words change one letter: at twice the speed the force is four times as large, not twice.

The words say which quantity changes and by how much: half the speed, bei dreifachem Trägheitsmoment, 3000
rpm after 6000. The formula that the page has of the value says by which power the value goes with it. So
F = 4·2171 N, 8685 N, F_2 = F_1/4 or J_2 = J_1/4 follow from the lines above. A value that goes with
another power of the change, or is a power of ten away, is wrong; one that goes with none may have another
cause, and is left alone.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction

from symbalance.document.formula import Call, Formula, Name, Number, Product, names
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.powers_of_letters import PowersOfLetter
from symbalance.notes.checking.steps.scaled_numbers import SPEED, SQUARE, is_speed, speed_of
from symbalance.notes.checking.words.sentences import SENTENCE_END
from symbalance.notes.reading import canonical_name
from symbalance.notes.reading.equations import Chain
from symbalance.notes.reading.failures import ReadingError
from symbalance.text import lazy_patterns as re

_FACTORS = {
    "1/2": r"half|halv(?:e|ed|es|ing)|halb(?:e[mnrs]?|ier\w*)|Hälfte|moitié|mitad|metà|metade|dimezz\w*"
    r"|半分|1/2",
    "2": r"twice|doubl(?:e[ds]?|ing|ée?|ant|er)|two\s+times|2\s+times|doppelt\w*|verdoppel\w*|zweifach\w*"
    r"|doble|dupli\w+|doppi[oa]|raddoppi\w+|dobro|(?:2|２|二)倍",
    "3": r"thrice|tripl(?:e[ds]?|ing|o)|three\s+times|3\s+times|(?:ver)?dreifach\w*|(?:3|３|三)倍",
    "4": r"quadrupl(?:e[ds]?|ing|o)|four\s+times|4\s+times|(?:ver)?vierfach\w*|(?:4|４|四)倍",
    "1/3": r"(?:a|one)\s+third(?:\s+of)?|Drittel|tiers|3分の1|三分の一",
    "1/4": r"(?:a|one)\s+(?:quarter|fourth)(?:\s+of)?|Viertel|quart|4分の1|四分の一",
}
"""Words of a change, by the number that a quantity is multiplied by."""
_KINDS = {
    "speed": r"speed|rpm|revs|revolutions|Drehzahl|Winkelgeschwindigkeit|vitesse|régime|velocidad"
    r"|velocità|regime|giri|回転数|回転速度|角速度",
    "inertia": r"(?:moments?\s+of\s+)?inertia|\w*[tT]rägheitsmoments?|inertie|inercia|inerzia"
    r"|慣性モーメント",
    "mass": r"mass|Masse|masse|masa|massa|質量",
    "radius": r"(?:crank\s+)?radius|Kurbelradius|Radius|rayon|クランク半径|半径",
    "stiffness": r"stiffness|\w*[sS]teifigkeit|raideur|rigidez|rigidezza|剛性|ばね定数",
    "energy": r"energy|work|Energie|\w*[aA]rbeit|énergie|travail|energía|energia|lavoro|エネルギー|仕事",
    "diameter": r"diameter|Durchmesser|diamètre|diámetro|diametro|直径",
}
"""Nouns of quantities that words change."""
_LETTERS = {
    "inertia": "J I Theta",
    "mass": "m M",
    "radius": "r R",
    "stiffness": "k c",
    "energy": "E W Delta",
    "diameter": "d D",
}
"""What such a quantity is usually called, but for the speed."""
_BETWEEN = (
    r"(?:(?:the|a|an|its|our|of|this|that|engine|crank|rotational|angular|mean|running|is|are|was|were|be|been|gets|to|we"
    r"|one|you|man|die|der|das|den|dem|des|einer?|wird|werden|würde|statt|dessen|jetzt|now|auf|um|bei|la|le|les|de|du|des"
    r"|ce|cette|est|el|del|il|della|dell'|l'|d'|を|が|の|に|は)\s*){0,4}"
)
_LETTER = (
    r"\$?(?P<letter>(?:\\[A-Za-z]{1,8}|[A-Za-z\u0391-\u03c9])(?:_(?:\{\w{1,8}\}|\w))?)\$?(?![A-Za-zÀ-ÿ'])"
)
_FACTOR = "(?i:" + "|".join(f"(?P<f{n}>{words})" for n, words in enumerate(_FACTORS.values())) + ")"
_KIND = "|".join(f"(?P<{kind}>{words})" for kind, words in _KINDS.items())
_FACTOR_FIRST = re.compile(
    rf"(?<![A-Za-zÀ-ÿ0-9.,/])(?:{_FACTOR})(?![A-Za-zÀ-ÿ/0-9])[\s-]*{_BETWEEN}(?:(?:{_KIND})(?![A-Za-zÀ-ÿ])|(?<![a-z]){_LETTER})"
)
_KIND_FIRST = re.compile(
    rf"(?<![A-Za-zÀ-ÿ])(?:(?:{_KIND})|(?<![a-z]){_LETTER})\s*{_BETWEEN}(?<![A-Za-zÀ-ÿ0-9.,/])(?:{_FACTOR})(?![A-Za-zÀ-ÿ/0-9])"
)
_OTHER_BODY = r"shaft|gear|cam\b|welle|nocken|getriebe|arbre|albero|軸"
_OTHER_TURNING = re.compile(
    rf"{_OTHER_BODY}|turn|rotat|revolv|alternat|oscillat|vibrat|pulsat|frequen|order|harmonic|half\s+(?:again|as)"
    r"|dreh(?!zahl)|läuft|laufen|umlauf|umläuf|schwing|Ordnung|frequenz|tourn|ordre|fréquen|gira|ordin|振動|周波数"
    r"|crank(?:shaft)?(?:'s)?\s+speed|Kurbeldrehzahl",
    re.IGNORECASE,
)
"""What goes at twice the speed of the crank, and is no engine at another speed."""
_ORDER = re.compile(r"(?:first|second|1st|2nd)[\s-]+order|\w+\s+Ordnung|ordre|ordin\w*", re.IGNORECASE)
"""At half the speed no order of a force turns."""
_TWICE = 2.0
_OTHER = re.compile(
    r"(?<![^\W\d_])(?:another|other|second(?!\s+(?:order|harm))|hollow|zweite[rsnm]?(?!\s+Ordn)|andere?[rsnm]?|hohle?[rsnm]?|autre|creux|otr[ao]|altr[ao])"
    r"(?![^\W\d_])|別の|中空",
    re.IGNORECASE,
)
"""What is of another thing, with a formula of its own perhaps."""
_AND = re.compile(
    rf"(?<![A-Za-z])(?:and|but|und|aber|et|y|e|con|with|mit|avec)\s[^.;:]{{0,30}}?(?:{_FACTOR})"
)
"""A second change beside the first."""
_BARE = re.compile(r"(?:[0-9.,()/*·×{}\s]|\\(?:cdot|times|[dt]?frac|[,;]))+")
"""Numbers without a unit, be it that of the value above that they are worked out from."""
_INDEX = re.compile(r"(?:'+|[,_][^,_']+)$")
_SPEED_INDEX = re.compile(r"(?<=_)([0-9]{3,5}),|[,_]([0-9]{3,5})$")
_MEAN = re.compile(r"_(?:m|mean|max|min|mittel|av)$")
_POWERS = tuple(Fraction(n, 2) for n in (-8, -6, -4, -3, -2, -1, 1, 2, 3, 4, 6, 8))
_TENS = (Fraction(1, 100), Fraction(1, 10), Fraction(10), Fraction(100))
_USUAL = (1, 2, -1, -2)
_NOISE = 1e-6
_HALF = 0.51
"""Of its last digit, by which a printed number may be off."""
_RIGHT_BEHIND = 60
"""Characters behind a value in which the speed that it is had at may stand."""
REACH = 240
"""Characters before a relation in which its sentence is looked at."""


@dataclass(frozen=True)
class Change:
    """What words change: the kind of quantity or its letter, by which factor, and in which words."""

    kind: str
    letter: str
    factor: float
    words: str


@dataclass(frozen=True)
class _Base:
    """A value above that another one is a multiple of: its letter, the multiple and how far it is off."""

    chain: Chain
    letter: str
    ratio: float
    rounding: float
    change: Change | None = None
    """What changes by the indices of both: F_3000 = F_6000/4."""


def scaled_in_words(state: JudgingState, chain: Chain, k: int) -> Decision | None:
    """Return the decision on a value of a letter where words change another one; None for others."""
    head, value = _letter_of(chain.sides[0].node), chain.sides[1].node
    if k or not chain.relations or chain.relations[0].sign not in "=≈" or head is None:
        return None
    words, changes = _words_before(state, chain)
    speed = None if changes else _speed_in(words)
    if is_speed(state, head.partition("_")[0]) and not any(c.kind != "speed" for c in changes):
        return None  # the speed itself
    if (len(changes) != 1 and speed is None) or _repeats_a_slip(state, chain, head):
        return None
    decisions = [
        _decide(state, chain, base, change)
        for base in _bases(state, chain, head, value)
        for change in changes or _changes_of_speed(state, base, speed)
    ]
    known = [decision for decision in decisions if decision is not None]
    return next((d for d in known if d.is_proved), known[0] if known else None)


def _letter_of(node: Formula) -> str | None:
    """Return the name of a letter, or of one between bars."""
    node = node.argument if isinstance(node, Call) and node.function == "abs" else node
    return node.name if isinstance(node, Name) else None


def _words_before(state: JudgingState, chain: Chain) -> tuple[str, list[Change]]:
    """Return what words change, with the words: those since the relation before, or the whole sentence
    where these change nothing.
    """
    text = state.document.text
    sentence = SENTENCE_END.split(text[max(0, chain.start - REACH) : chain.start])[-1]
    last = state.sections.end_before(chain.start) or 0
    near = sentence[max(0, len(sentence) - (chain.start - last)) :]
    changes = changes_in(near)
    if changes or near == sentence or SPEED.search(near):
        return near, changes
    return sentence, changes_in(sentence)


def changes_in(words: str) -> list[Change]:
    """Return what words change: half the speed, with three times the inertia, J verdoppelt."""
    if _OTHER.search(words):
        return []
    found: list[re.Match[str]] = []
    for pattern in (_FACTOR_FIRST, _KIND_FIRST):
        for match in pattern.finditer(words):
            if not any(match.start() < m.end() and m.start() < match.end() for m in found):
                found.append(match)
    changes = []
    if len(found) == 1 and _AND.search(words[found[0].end() :]):
        return []
    for match in found:
        factor = next(each for n, each in enumerate(_FACTORS) if match[f"f{n}"])
        kind = next((each for each in _KINDS if match[each]), "")
        try:
            letter = "" if kind else canonical_name(match["letter"])
        except ReadingError:  # \unit{N}, say: what is changed is no letter
            continue
        is_twice = float(Fraction(factor)) == _TWICE
        if kind == "speed" and _OTHER_TURNING.search(words if is_twice else _ORDER.sub(" ", words)):
            continue
        changes.append(Change(kind, letter, float(Fraction(factor)), match[0]))
    return changes


def is_of_kind(state: JudgingState, name: str, kind: str) -> bool:
    """Tell whether a letter is usually one of a kind of quantities: ω a speed, m a mass."""
    if kind == "speed":
        return is_speed(state, name)
    return name.partition("_")[0] in _LETTERS.get(kind, "").split()


def _speed_in(words: str) -> re.Match[str] | None:
    """Return the one speed that words name; None for several."""
    speeds = list(SPEED.finditer(words))
    is_other = re.search(_OTHER_BODY, words, re.IGNORECASE) or _OTHER.search(words)
    return speeds[0] if len(speeds) == 1 and not is_other else None


def _changes_of_speed(state: JudgingState, base: _Base, speed: re.Match[str] | None) -> Iterator[Change]:
    """Yield the changes from the speeds that a value may be given at: named before or right behind it."""
    text, chain = state.document.text, base.chain
    if base.change is not None:
        yield base.change
        return
    behind = SENTENCE_END.split(text[chain.end : chain.end + _RIGHT_BEHIND])[0]
    named = [*SPEED.finditer(text[: chain.start])][-1:] + [*SPEED.finditer(behind)][:1]
    if speed is None:
        return
    for other in named:
        first, second = speed_of(other), speed_of(speed)
        if first and second and first != second:
            yield Change("speed", "", second / first, f"{speed[0]} after {other[0]}")


def _repeats_a_slip(state: JudgingState, chain: Chain, head: str) -> bool:
    """Tell whether the sentence has refuted the letter before: F' = F/2, and so F' = 663 N."""
    text = state.document.text
    return any(
        _letter_of(c.sides[0].node) == head
        and any(side.span[0] in state.refuted for side in c.sides[1:])
        and not SENTENCE_END.search(text[c.end : chain.start])
        for c in state.document.chains
        if chain.start - REACH < c.start < chain.start
    )


def _bases(state: JudgingState, chain: Chain, head: str, value: Formula) -> Iterator[_Base]:
    """Yield the values above that a value is a multiple of, the nearest first: 4·2171, F_2/4, 8685 N."""
    knowledge = state.knowledge(chain.lines[0])
    own = _without_index(head)
    above = [c for c in state.sections.in_order if c.start < chain.start and c.relations]
    if not names(value):
        exact = number_of(value, knowledge)
        is_bare = _BARE.fullmatch(state.document.source(chain.sides[1].span)) is not None
        numbers = [
            (c, letter, c.sides[-1].node)
            for c in reversed(above)
            if (letter := _letter_of(c.sides[0].node)) in (head, own) and not names(c.sides[-1].node)
        ]
        for each, letter, node in numbers if exact else []:
            base = number_of(node, knowledge)
            if base and letter is not None:
                rounding = _rounding(value) + _rounding(node)
                ratio = float(exact) / float(base)
                for prefix in (1, 1000, 0.001) if is_bare else (1,):
                    yield _Base(each, letter, ratio * prefix, rounding)
        return
    letters = names(value)
    if len(letters) != 1:
        return
    (letter,) = letters
    owner = letter if letter == own else own if own == _without_index(letter) else None
    is_own = owner == own != letter
    if (
        owner is None
        or letter == head
        or (is_own and any(_has_formula(state, n, chain) for n in (head, letter)))
    ):
        return
    once, twice = (number_of(substitute(value, letter, Number(Fraction(n))), knowledge) for n in (1, 2))
    if once and twice and abs(float(twice) / float(once) - 2) < _NOISE and chain.relations:
        last = next((c for c in reversed(above) if _letter_of(c.sides[0].node) == letter), chain)
        yield _Base(last, owner, float(once), _NOISE, _change_of_index(state, head, letter))


def _change_of_index(state: JudgingState, head: str, letter: str) -> Change | None:
    """Return the change from one speed to another that stand as indices; None for other indices."""
    own, other = (_SPEED_INDEX.search(name) for name in (head, letter))
    if own is None or other is None:
        return None
    now, before = (int(match[1] or match[2]) for match in (own, other))
    is_of_speeds = {now, before} <= state.speeds
    return Change("speed", "", now / before, f"{now} after {before}") if is_of_speeds else None


def _without_index(name: str) -> str:
    """Return a letter without its speed, or its last index: F_2 for F_2,3000, A_2 for A_2', J for J_2."""
    return _SPEED_INDEX.sub("", name) if _SPEED_INDEX.search(name) else _INDEX.sub("", name)


def _has_formula(state: JudgingState, name: str, chain: Chain) -> bool:
    above = state.sections.chains_above(Name(name), chain.start)
    return any(names(side.node) for c in above for side in c.sides[1:])


def _rounding(node: Formula) -> float:
    """Return how far a printed number is off, as a part of it; an arithmetic is worked out exactly."""
    parts = node.factors if isinstance(node, Product) else (node,)
    numbers = [part for part in parts if isinstance(part, Number) and not _may_be_unit(part)]
    if len(numbers) != 1 or not isinstance(node, Number | Product):
        return _NOISE
    place = numbers[0].last_place
    return float((place if place is not None else 1) / abs(numbers[0].value)) * _HALF


def _may_be_unit(number: Number) -> bool:
    """Tell whether a number may be a unit of another one: a power of ten, typed without a point."""
    digits = {str(part).strip("0") for part in (number.value.numerator, number.value.denominator)}
    return (number.last_place is None and digits == {"1"}) or not number.value


def _decide(state: JudgingState, chain: Chain, base: _Base, change: Change) -> Decision | None:
    """Return whether a value goes with the power of the change that its letter's formula has."""
    powers = _powers(state, chain, base.letter, change) or _powers_in_words(state, chain, base, change)
    if not powers and any(_is_near(base.ratio, change.factor**n, base.rounding + _NOISE) for n in _USUAL):
        return Decision(UNDECIDED, f"by {change.words.strip()}: nothing says by which power of it")
    if not powers or change.factor <= 0 or base.ratio <= 0:
        return None
    near = base.rounding + _NOISE
    line = base.chain.lines[0]
    for power in powers:
        if _is_near(base.ratio, change.factor ** float(power), near):
            reason = f"by {change.words.strip()}: {_ordinal(power)} of it times the value of line {line}"
            return Decision(PROVED, reason if base.chain is not chain else f"by {change.words.strip()}")
    others = [change.factor ** float(power) for power in _POWERS if power not in powers]
    others += [change.factor ** float(power) * ten for power in powers for ten in _TENS]
    if not any(_is_near(base.ratio, other, near) for other in others):
        return None
    reason = f"by {change.words.strip()} it changes {change.factor ** float(powers[0]):.4g} times"
    return Decision(
        REFUTED, f"{reason}, with {_ordinal(powers[0])} of it, and not {base.ratio:.4g} times"
    )


def _powers_in_words(state: JudgingState, chain: Chain, base: _Base, change: Change) -> list[Fraction]:
    """Return the second power where the words around a value say that it goes with the speed squared."""
    text, first, last = state.document.text, base.chain, chain.start
    start = max(0, first.start - _RIGHT_BEHIND)
    is_said = SQUARE.search(text, start, min(first.end + REACH, last)) or SQUARE.search(
        SENTENCE_END.split(text[max(0, last - REACH) : last])[-1]
    )
    return [Fraction(2)] if change.kind == "speed" and is_said else []


def _ordinal(power: Fraction) -> str:
    return "the first power" if power == 1 else f"the power {power}"


def _is_near(first: float, second: float, near: float) -> bool:
    return abs(first - second) <= near * abs(second)


def _powers(state: JudgingState, chain: Chain, letter: str, change: Change) -> list[Fraction]:
    """Return by which powers a letter may go with what is changed, by its formulas; none if unknown.

    Through λ = r/l a force goes with r² in all, and by its own formula with r alone. An equation that is
    not solved for the letter says it too: by W = J δ ω², δ goes as 1/J.
    """
    above = [c for c in state.sections.in_order if c.start < chain.start and c.relations]
    for owner in dict.fromkeys((letter, letter.removeprefix("hat_"), _without_index(letter))):
        changed = _letters_changed(state, above, owner, change)
        if not changed:
            continue
        of_changed = PowersOfLetter(state.sections, changed.__contains__, deep=False)
        of_owner = PowersOfLetter(state.sections, lambda name, own=owner: name == own, deep=False)
        of_all = replace(of_changed, deep=True)
        powers = {each.of_letter(owner, chain.start) for each in (of_changed, of_all)}
        if change.kind != "speed":  # P = T ω says of T what the engine gives, and nothing of the speed
            powers |= {_solved(c, of_owner, of_changed) for c in above}
        if known := sorted(power for power in powers if power):
            return known
    return []


def _solved(chain: Chain, of_letter: PowersOfLetter, of_changed: PowersOfLetter) -> Fraction | None:
    """Return the power by which a letter goes with another one where an equation holds; or None."""
    left, right = chain.sides[0].node, chain.sides[1].node
    if chain.relations[0].sign not in "=≈":
        return None
    own, other = (_difference(powers.of(right), powers.of(left)) for powers in (of_letter, of_changed))
    return -other / own if own and other else None


def _difference(first: Fraction | None, second: Fraction | None) -> Fraction | None:
    return None if first is None or second is None else first - second


def _letters_changed(
    state: JudgingState, above: list[Chain], owner: str, change: Change
) -> frozenset[str]:
    """Return the letter behind a letter's equations that words change, where it is one alone.

    Of the speed, its mean, largest and smallest values change together.
    """
    values = {
        c.sides[0].node.name: c.sides[1].node
        for c in above
        if isinstance(c.sides[0].node, Name) and names(c.sides[1].node)
    }
    own = [c for c in above if owner in c.letters]
    behind = {name for c in own for name in c.letters}
    behind |= {n for c in own for side in c.sides for n in names_behind(side.node, values)} - {owner}
    if not change.kind:
        return frozenset({change.letter} & behind)
    if change.kind != "speed":
        like = {n for n in behind if n.partition("_")[0] in _LETTERS[change.kind].split()}
        return frozenset(like if len(like) == 1 else ())
    like = {n for n in behind if is_speed(state, _MEAN.sub("", n))}
    others = {n for n in behind if n not in like and is_speed(state, n.partition("_")[0])}
    return frozenset() if others else frozenset(like)
