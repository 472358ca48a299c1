"""Names of several letters in plain text, ωm, rG or Fmax: which are one name is decided once for a page.

Without TeX a subscript is typed on the line. Whether `ωm` is one letter or ω times m, the page itself
says: it is one where it stands alone left of = and one of its letters is no letter of the page, where
what it is defined by belongs to its first letter (ωm = (ω1 + ω2)/2), or where the page writes every
product with a sign, or where a d with a subscript has its partner beside it (D and di), or where its
value is of the kind of its first letter, which the product is not (mr = 0.60 kg beside m = 0.45 kg).
Each name is then read so throughout, as ω_{m}, and a note says it; a note also says which ones are
products although they stand alone. A name by its value alone is read so where it stands by itself, and
as the product within a longer one, mrω².
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from symbalance.document.letters import (
    FUNCTION_WORDS,
    GREEK_SIGN,
    NAME_OF_SIGN,
    SHORT_NAMES,
    plain_letter,
)
from symbalance.notes.reading.letters.kinds_of_values import (
    USUAL_KIND,
    is_of_kind_of_base,
    is_of_kind_of_noun,
    kind_of_value,
)
from symbalance.notes.reading.letters.letter_names import canonical_name
from symbalance.notes.reading.markup.marked_formulas import marked_formulas
from symbalance.notes.reading.rewriting import Rewriter, Rewritten, Span
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

_GREEK = "".join(sign for sign in (*GREEK_SIGN.values(), *NAME_OF_SIGN) if sign not in "πΣΠ")
_LETTER = f"A-Za-z{_GREEK}"
_EQUALS = r"(?=[ \t]*(?:=(?![=>])|[≈≒≃]))"
_HEAD = re.compile(
    rf"(?<![A-Za-z0-9_À-ÿ\\^}}'′’{_GREEK}])(?P<base>[{_LETTER}])(?P<suffix>[A-Za-z]{{1,4}}|[A-Za-z]{{1,3}}[0-9]){_EQUALS}"
)
_NOUNS = (
    "mass(?:es?)?|masses?|Massen?|massa|masa|radius|rayon|Radius|raggio|radio|length|longueur|Länge"
    "|force|Kraft|forza|fuerza|stroke|course|Hub|corsa|carrera"
    "|counterweight|Gegengewicht|contrepoids|contrappeso|contrapeso"
)
_SHORT_WORDS = (
    "(?:is|as|at|in|of|on|to|or|by|if|im|am|an|ab|de|du|di|et|en|es|el|il|la|le|un|una|al|au)(?![a-z])"
)
_NAMED = re.compile(
    rf"(?:{_NOUNS})[ ](?!{_SHORT_WORDS})"
    r"(?P<base>[A-Za-z])(?P<suffix>[a-z]{1,2})"
    r"(?=[ ](?:vaut|valent|est|is|was|ist|beträgt|vale|es|of|de|du|von|di|und|and|et|e|y|at|on|per|am|an"
    r"|im|je|bei|sur|au|à|su|al|en)[ ]|[,:;)]| \(|\.?[ \t]*(?:\n|$))"
)
"""A name behind the noun that says what it is: la masse ma vaut 0,5 kg."""
_BEFORE = re.compile(
    rf"(?:^|(?:^|\s)\(?[a-z0-9]{{1,2}}\)|[.,:;(、。，：；|`\ue000]|[^\W\d_{_GREEK}]{{2,}}\.?"
    r"|[\u2e80-\u9fff])[ \t]*$"
)
_VALUE = re.compile(r"[ \t]*[=≈≒≃](?P<value>[^\n=≈≒≃<>,;、。]{1,200})")
_NUMBER_GIVEN = re.compile(r"[ \t]*[=≈≒≃][ \t]*[0-9]+(?:[.,][0-9]+)?(?![0-9]*[ \t]*[·*×/+−^-])")
_BEHIND_NOUN = re.compile(rf"(?<![^\W\d_])(?:{_NOUNS})[ ]$")
_ANGULAR_SPEED_BEHIND = re.compile(r"[ \t]?[·*×⋅]?[ \t]?(?:[ωΩ]|(?:w|omega)(?![A-Za-z]))")
_LONG_WORDS_AROUND = re.compile(r"[^\W\d_]{2}[ ]$")
_GRAVITY = re.compile(r"(?<!\w)g[ ]?[=≈]|9[.,]8|[Gg]ravit|(?<![a-z])(?:[Ww]eight|Gewicht|poids|[Pp]eso)")
_BEHIND_NUMBER = re.compile(r"(?:[0-9][ \t]?|[A-Za-z0-9]-)$")
_OPERATOR = "·*×/+²³^"
_ALONE = re.compile(
    "|".join(
        (
            rf"(?:^|(?<=[^\w {{\\'’]))[ \t]*([{_LETTER}])[ \t]*(?=[=≈≒≃{_OPERATOR}])",
            rf"(?<=[·*×/+−(=] )([{_LETTER}])(?![{_LETTER}\w'’])",
            rf"(?<=[·*×/+−(=])([{_LETTER}])(?![{_LETTER}\w'’])",
            rf"(?<=[^\W\d_]{{3}} )([{_LETTER}])(?=[ \t]*[=≈≒≃,.;:)])",
            rf"(?<=[\u2e80-\u9fff])[ \t]?([{_LETTER}])(?=[ \t]*[=≈≒≃,.;:)、。])",
            rf"(?<=[0-9])([{_GREEK}])(?![{_LETTER}\w])",
        )
    ),
    re.MULTILINE,
)
"""A letter by itself: left of a sign, behind one, behind a word that it stands for, behind a digit."""
_SIGNED_PRODUCT = re.compile(
    rf"(?<![{_LETTER}])[{_LETTER}](?:_?\w{{1,3}})?[²³]?[ \t]?[·*×⋅][ \t]?[{_LETTER}](?![{_LETTER}])"
)
_BESIDE_STAR = re.compile(
    r"(?:(?<=[0-9A-Za-z)]\*)|(?<=[0-9A-Za-z)] \* ))"
    r"(?P<base>[A-Za-z])(?P<suffix>[A-Za-z]{1,3}[0-9]?)(?![A-Za-z_{(0-9])"
    r"|(?<![A-Za-z\\_{])(?P<first>[A-Za-z])(?P<rest>[A-Za-z]{1,3}[0-9]?)"
    r"(?=\*[0-9A-Za-z(]| \* [0-9A-Za-z(])"
)
"""A run of letters beside a typed star, pme*Vh: on a page that types all its products it is one name."""
_IN_FORMULA = re.compile(r"[ \t]*[²³^·・*×⋅/+−=≈≒≃)]|[ \t]*-[ \t]*\S|[ ][A-Za-z]{2}[ ]?[=≈²^·*/]")
_BEHIND_SIGN = re.compile(r"[·・*×⋅/+−=≈≒≃(0-9²³√][ \t]*$|[^\w \t]-[ \t]*$")
_TIMES = frozenset("tT")
_EXTREMES = ("max", "min")
_LONGEST_BEFORE, _LONGEST_REMARK = 40, 80
MOST_NAMES = 200
"""A page has fewer; the limit keeps the search in proportion to the text."""


@dataclass(slots=True)
class _Name:
    """A spelling that stands alone left of a relation, and where it first does."""

    base: str
    suffix: str
    place: int
    is_defined_by_kin: bool = False
    is_by_value: bool = False
    """Whether nothing but the kind of its value says that it is no product."""

    @property
    def spelling(self) -> str:
        return self.base + self.suffix


def with_compound_names(
    text: str, is_letter: Callable[[str, int], bool] = lambda name, line: False
) -> tuple[Rewritten | None, tuple[str, ...]]:
    """Return a text with ωm as ω_{m} where that is one name, None where there are none, and notes.

    >>> with_compound_names("Der Mittelwert ωm = (ω1 + ω2)/2, also ωm² = 4")[0].text
    'Der Mittelwert ω_{m} = (ω1 + ω2)/2, also ω_{m}² = 4'
    >>> with_compound_names("m = 3 kg, r = 2 m, mr = 6 kg m")[0] is None
    True
    """
    formulas = marked_formulas(text)
    plain = _without(text, formulas)
    candidates = _candidates(plain, is_letter)
    factors = _beside_stars(plain, is_letter)
    if not candidates and not factors:
        return None, ()
    known = _letters_of(plain, candidates)
    signed = len(_SIGNED_PRODUCT.findall(plain))
    enough = 1 if factors else 2  # a spelling beside a star is itself a product with a sign
    has_signs = signed >= enough and not _has_bare_products(plain, [*candidates, *factors], known)
    if has_signs:
        spellings = {name.spelling for name in candidates}
        candidates += [name for name in factors if name.spelling not in spellings]
    if not candidates:
        return None, ()
    names: list[_Name] = []
    products: list[_Name] = []
    for name in candidates:
        line = plain.count("\n", 0, name.place) + 1
        is_declared = is_letter(_canonical(name), line)

        def is_known(letter: str, at: int = line) -> bool:
            return (
                letter.isdecimal()
                or letter in known
                or letter in _TIMES
                or is_letter(NAME_OF_SIGN.get(letter, letter), at)
            )

        is_product = all(map(is_known, name.spelling)) and name.suffix not in _EXTREMES
        is_product = is_product and not _is_diameter(name, plain)
        if is_product and not (is_declared or name.is_defined_by_kin or has_signs):
            end = name.place + len(name.spelling)
            name.is_by_value = is_of_kind_of_base(name.spelling, end, plain) or is_of_kind_of_noun(
                name.spelling, name.place, plain
            )
            is_product = not name.is_by_value
        if is_declared or not is_product or name.is_defined_by_kin or has_signs:
            names.append(name)
        else:
            products.append(name)
    notes: list[str] = []
    if names:
        shown = ", ".join(f"{name.spelling} as {plain_letter(_canonical(name))}" for name in names)
        notes.append(f"one letter each: {shown}")
    if products:
        shown = ", ".join(f"{name.spelling} as {'·'.join(name.spelling)}" for name in products)
        notes.append(f"products of letters of the page: {shown}")
    return _written(text, plain, names, known) if names else None, tuple(notes)


def _without(text: str, spans: list[Span]) -> str:
    """Return a text with blanks where TeX stands: its subscripts are marked."""
    pieces, place = [], 0
    for start, end in spans:
        pieces += [text[place:start], re.sub(r"[^\n]", "\ue000", text[start:end])]
        place = end
    return "".join([*pieces, text[place:]])


def _canonical(name: _Name) -> str:
    return canonical_name(f"{name.base}_{{{name.suffix}}}")


def _candidates(plain: str, is_letter: Callable[[str, int], bool]) -> list[_Name]:
    """Return the spellings that stand alone left of a relation, each once."""
    first: dict[str, _Name] = {}
    looks: dict[tuple[str, bool, str | None], bool] = {}  # each spelling is looked for on the page once
    line, place = 1, 0
    for match in _HEAD.finditer(plain):
        before = plain[max(match.start() - _LONGEST_BEFORE, 0) : match.start()].rpartition("\n")[2]
        name = _Name(match["base"], match["suffix"], match.start())
        value = _VALUE.match(plain, match.end())
        name.is_defined_by_kin = value is not None and _is_kin(name, value["value"])
        if not _BEFORE.search(before):
            continue
        kind = kind_of_value(plain, match.end())
        look = name.spelling, name.is_defined_by_kin, kind
        if look not in looks:
            looks[look] = _may_be_name(name, plain)
        if not looks[look]:
            continue
        line, place = line + plain.count("\n", place, match.start()), match.start()
        if is_letter(name.spelling, line):
            continue
        earlier = first.setdefault(name.spelling, name)
        earlier.is_defined_by_kin = earlier.is_defined_by_kin or name.is_defined_by_kin
        if len(first) >= MOST_NAMES:
            break
    for match in _NAMED.finditer(plain):
        name = _Name(match["base"], match["suffix"], match.start("base"))
        line = plain.count("\n", 0, match.start()) + 1
        is_used = any(_stands_in_formula(plain, *span) for span in _uses(name, plain))
        if is_used and not _has_other_meaning(name.spelling) and not is_letter(name.spelling, line):
            first.setdefault(name.spelling, name)
    spellings = "|".join(first)
    runs = re.compile(rf"(?:{spellings}){{2,}}")
    return [name for name in first.values() if not runs.fullmatch(name.spelling)]


def _may_be_name(name: _Name, plain: str) -> bool:
    """Tell whether a spelling may be a letter and its subscript by its look, and is no word or unit."""
    spelling = name.spelling
    if _has_other_meaning(spelling) and not _is_unit_but_letter(name, plain):
        return False
    if name.base in "dδ∂Δ∆" and len(name.suffix) == 1:
        return _is_diameter(name, plain)
    if name.base in _GREEK or name.suffix in _EXTREMES:
        return True
    is_long = len(spelling) > 2
    if is_long and not name.suffix.islower():
        return _is_of_capitals(name, plain)
    return (not is_long and not spelling.islower()) or _is_used_as_letter(name, plain)


def _is_of_capitals(name: _Name, plain: str) -> bool:
    """Tell FV1 and mKW from words, and from P V1 on a page that has V1 or V2."""
    if name.base.isupper() and len(name.suffix) == 2 and name.suffix[0].isupper():
        factor = rf"(?<![A-Za-z\\_{{]){name.suffix[0]}_?\{{?[0-9]"
        return name.suffix[1].isdecimal() and re.search(factor, plain) is None
    return name.base.islower() and name.suffix[0].isupper()


def _is_used_as_letter(name: _Name, plain: str) -> bool:
    """Tell a name of small letters from a word by where it stands."""
    uses = [span for span in _uses(name, plain) if not _is_named_by_noun(plain, span[0])]
    in_formulas = sum(_stands_in_formula(plain, *span) for span in uses)
    if len(name.spelling) == 2:  # a word of two letters is given no kilograms, and is rarely a factor
        given = name.base in USUAL_KIND and kind_of_value(plain, name.place + 2) is not None
        return (
            given
            or len(uses) == in_formulas > 0
            or (name.base in USUAL_KIND and in_formulas > len(uses) // 2)
        )
    return in_formulas == len(uses) >= (1 if name.is_defined_by_kin else 2)


def _is_named_by_noun(plain: str, start: int) -> bool:
    """Tell whether the noun before a spelling says what it is: rotating mass mr at the pin."""
    return _BEHIND_NOUN.search(plain, max(start - 16, 0), start) is not None


def _is_unit_but_letter(name: _Name, plain: str) -> bool:
    """Tell whether mg is no unit on a page: it is given a formula or a quantity, and behind no number."""
    spelling = name.spelling
    if len(spelling) != 2 or not spelling.islower() or scale_of(spelling) is None:
        return False
    if spelling[0] not in USUAL_KIND or spelling in ("mm", "lb"):
        return False  # in = 25.4 mm
    uses = list(_uses(name, plain))
    if any(_BEHIND_NUMBER.search(plain, max(start - 2, 0), start) for start, _ in uses):
        return False
    if (kind := kind_of_value(plain, name.place + 2)) is not None:
        return kind == USUAL_KIND.get(name.base)
    if spelling == "mg" and _GRAVITY.search(plain):
        return False
    value = _VALUE.match(plain, name.place + 2)
    return value is not None and re.search(r"[A-Za-z][ \t]*[·*×/+)−-]", value["value"]) is not None


def _is_diameter(name: _Name, plain: str) -> bool:
    """Tell whether di is a letter and no differential: it has a number, and D or d stands beside it.

    It has none where it is divided by or stands behind an integral.
    """
    spelling = name.spelling
    if name.base != "d" or len(spelling) != 2 or "∫" in plain:
        return False
    if not _NUMBER_GIVEN.match(plain, name.place + len(spelling)):
        return False
    if re.search(rf"/[ \t]?{spelling}(?![A-Za-z])", plain):
        return False
    own, other = rf"{spelling}(?![A-Za-z])", r"(?<![A-Za-z\\_])[Dd](?:[²³⁴]|\^\d)?"
    between = r"[ \t]*(?:[-−+,]|(?<=[ \t])(?:and|und|et|y|e))[ \t\n]*"
    return (
        re.search(rf"{other}{between}{own}|(?<![A-Za-z]){own}{between}{other}(?![A-Za-z_])", plain)
        is not None
    )


def _has_other_meaning(spelling: str) -> bool:
    """Tell whether a spelling is a function, a unit or a Greek letter written out."""
    spelling = spelling.rstrip("0123456789")
    is_letter = spelling in GREEK_SIGN or spelling in SHORT_NAMES or spelling == "pi"
    is_function = spelling.lower() in FUNCTION_WORDS or spelling[1:] in FUNCTION_WORDS
    return is_letter or is_function or scale_of(spelling) is not None


def _stands_in_formula(plain: str, start: int, end: int) -> bool:
    before = plain[max(start - 4, 0) : start]
    return _IN_FORMULA.match(plain, end) is not None or _BEHIND_SIGN.search(before) is not None


def _is_kin(name: _Name, value: str) -> bool:
    """Tell whether a value is made of letters of the same base, (ω1 + ω2)/2, and not of the suffix."""
    kin = re.search(rf"(?<![A-Za-z\\]){name.base}(?:_?\{{?[0-9A-Za-z]|[₀-₉ₐ-ₜ])", value)
    own = any(re.search(rf"(?<![A-Za-z{_GREEK}_{{]){sign}(?![a-zA-Z(])", value) for sign in name.suffix)
    return kin is not None and not own


def _letters_of(plain: str, candidates: list[_Name]) -> set[str]:
    """Return the single letters that stand as such on the page."""
    return {next(filter(None, match.groups())) for match in _ALONE.finditer(plain)} - set("aAI")


def _has_bare_products(plain: str, candidates: list[_Name], known: set[str]) -> bool:
    """Tell whether letters of the page stand side by side as a product that is no candidate."""
    spellings = {name.spelling for name in candidates}
    for match in re.finditer(rf"(?<![\w\\{_GREEK}])[{_LETTER}]{{2,4}}(?![{_LETTER}_{{])", plain):
        run = match.group()
        if run in spellings or run.lower() in FUNCTION_WORDS or not set(run) <= known or scale_of(run):
            continue
        if _stands_in_formula(plain, *match.span()) and not _ends_remark(plain, *match.span()):
            return True
    return False


def _ends_remark(plain: str, start: int, end: int) -> bool:
    """Tell whether a run is the last word of a remark in brackets: (it should fit in the sump)."""
    before = plain[max(start - _LONGEST_REMARK, 0) : start].rpartition("(")
    is_last = plain[end : end + 4].lstrip(" \t").startswith(")")
    return is_last and before[2][-1:] == " " and re.search(r"[0-9=*·/+^]", before[2]) is None


def _beside_stars(plain: str, is_letter: Callable[[str, int], bool]) -> list[_Name]:
    """Return the runs of letters that stand as factors beside a star, each once.

    A run of letters that are all declared is their product: th is t h.
    """
    names: dict[str, _Name] = {}
    line, place = 1, 0
    for match in _BESIDE_STAR.finditer(plain):
        name = _Name(match["base"] or match["first"], match["suffix"] or match["rest"], match.start())
        line, place = line + plain.count("\n", place, match.start()), match.start()
        is_product = all(is_letter(letter, line) for letter in name.spelling)
        if not is_product and not _has_other_meaning(name.spelling):
            names.setdefault(name.spelling, name)
    return list(names.values())[:MOST_NAMES]


def _uses(name: _Name, plain: str) -> list[Span]:
    """Return where a spelling stands: in no longer word, but behind Greek letters and digits too."""
    before = "" if name.base in _GREEK else "A-Za-z"
    pattern = rf"(?<![\\_{{{before}]){name.spelling}(?![A-Za-z_{{]|[0-9]\w)"
    return [match.span() for match in re.finditer(pattern, plain)]


def _written(text: str, plain: str, names: list[_Name], known: set[str]) -> Rewritten | None:
    """Return a text whose runs of letters are cut into names, functions and letters of the page."""
    names = sorted(names, key=lambda name: -len(name.spelling))
    by_value = {name.spelling for name in names if name.is_by_value}
    spellings = "|".join(name.spelling for name in names)
    functions = "|".join(sorted(FUNCTION_WORDS, key=len, reverse=True))
    single = "".join(sorted(known | set(_GREEK)))
    part = rf"(?:{spellings}|{functions}|[{single}])"
    run = re.compile(rf"(?<![{_LETTER}\\_]){part}*?(?:{spellings}){part}*(?![{_LETTER}_{{]|[0-9]\w)")
    piece = re.compile(rf"(?P<name>{spellings})|{functions}|[{single}]")
    rewriter, has_names = Rewriter(text), False
    for match in run.finditer(plain):
        for inner in piece.finditer(plain, *match.span()):
            if inner["name"] and not _is_word_or_product(inner, match, plain, by_value):
                start, end = inner.span()
                rewriter.replace(start, end, (start, start + 1), "_{", (start + 1, end), "}")
                has_names = True
    return rewriter.finish() if has_names else None


def _is_word_or_product(inner: re.Match[str], run: re.Match[str], plain: str, by_value: set[str]) -> bool:
    """Tell whether a spelling stands in words, or is a product where a name by its value is none."""
    start, end = inner.span()
    if len(inner.group()) == 2 and inner.group().islower() and run.span() == inner.span():
        in_words = not _stands_in_formula(plain, start, end) and not _is_named_by_noun(plain, start)
        if in_words and _LONG_WORDS_AROUND.search(plain, max(start - 3, 0), start):
            return True
    if inner.group() not in by_value:
        return False
    return run.span() != inner.span() or _ANGULAR_SPEED_BEHIND.match(plain, end) is not None
