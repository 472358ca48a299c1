"""Macros of a document, and those of common LaTeX packages, put into plain LaTeX.

\\newcommand, \\def, \\DeclareMathOperator and their kin are collected where they stand and replaced where
they are used, in rounds: the outermost use first, what it brings in the next round. What they bring is
bounded; a macro that never ends stays, and is refused by name.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable
from dataclasses import dataclass, field

from symbalance.document.wordlists import word_set, words
from symbalance.notes.reading.markup import differential_signs, siunitx
from symbalance.notes.reading.markup.physics_macros import PHYSICS
from symbalance.notes.reading.markup.underlined_letters import is_underlined_letter
from symbalance.notes.reading.rewriting import Rewriter, Rewritten, Span
from symbalance.notes.reading.signs import RELATION
from symbalance.text import lazy_patterns as re

# A macro in its own body doubles the text every round: rounds and growth are both bounded.
MOST_ROUNDS = 30
MOST_GROWTH = 200_000  # characters over the document's own, half as many again as its length
LONGEST_ARGUMENT = 20_000
MOST_USES = 20_000  # of macros in one round
_DEEPEST = 200

_NAME = r"(?:\{\s*\\(?P<braced>[A-Za-z@]+)\s*\}|\\(?P<bare>[A-Za-z@]+))"
_DEFINITION = re.compile(
    r"\\(?P<command>(?:(?:re)?new|provide)command|DeclareRobustCommand|DeclareMathOperator"
    r"|DeclarePairedDelimiter|(?:New|Renew|Provide|Declare)DocumentCommand|let|[gex]?def)"
    rf"(?![A-Za-z])\*?\s*{_NAME}"
)
_COUNT = re.compile(r"\s*\[\s*([0-9])\s*\]")
_COMMENT = re.compile(r"(?<!\\)%[^\n]*\n[ \t]*")
_DEFAULT = re.compile(r"\s*\[([^\]\n]{0,200})\]")
_PARAMETERS = re.compile(r"((?:\s*#[1-9])*)\s*(?=\{)")
_LET = re.compile(r"\s*=?\s*(\\[A-Za-z@]+)")
_USE = re.compile(r"\\(\\|[A-Za-z@]+)")
_PARAMETER = re.compile(r"#([1-9])")
_SPACE = re.compile(r"\s*")
_BRACE = re.compile(r"\\.|[{}]", re.DOTALL)
_SIGN = re.compile(r"\\(?:[A-Za-z@]+|.)", re.DOTALL)
_EMPTY = re.compile(r"\{\s*\}")

_WHOLE_FUNCTION = re.compile(
    r"\s*\\(?:sin|cos|tan|cot|sec|csc|sinh|cosh|tanh|exp|ln|log)(?![A-Za-z])(?!\s*\^)\s*[^\s]"
)
_POWER_BEHIND = re.compile(r"\s?\^")

LEFT_ALONE = word_set("section subsection thesection theequation maketitle item labelenumi")
"""Commands of layout whose redefinition changes no formula."""


@dataclass(frozen=True, slots=True)
class Macro:
    """What a macro stands for: its body, with #1 to #9 for its arguments; `place` is its definition's.

    `default` is that of the first argument, which stands in [ ]. `refusal` tells why it is not read.
    """

    name: str
    body: str = ""
    parameters: int = 0
    default: str | None = None
    place: int = -1
    refusal: str = ""


@dataclass(slots=True)
class Definitions:
    """The macros of a document in the order of their places, and the stretches that define them."""

    by_name: dict[str, list[Macro]] = field(default_factory=dict)
    spans: list[Span] = field(default_factory=list)

    def at(self, name: str, place: int) -> Macro | None:
        """Return what a name stands for at a place of the document."""
        macros = self.by_name.get(name)
        if not macros:
            return None
        number = bisect_left([macro.place for macro in macros], place) - 1
        return macros[number] if number >= 0 else None


@dataclass(frozen=True, slots=True)
class Expanded:
    """A text without macros; at some places of the document, why one could not be replaced."""

    source: Rewritten | None
    refusals: dict[int, tuple[str, str]]


def expand_macros(text: str) -> Expanded:
    r"""Return a text with its macros replaced; `source` is None where there are none.

    >>> expand_macros(r"\newcommand{\half}[1]{\frac{#1}{2}} $x = \half{y}$").source.text.strip()
    '$x = \\frac{y}{2}$'
    """
    if "\\" not in text:
        return Expanded(None, {})
    definitions = definitions_in(text)
    refusals: dict[int, tuple[str, str]] = {}
    source: Rewritten | None = None
    current, most = text, len(text) + len(text) // 2 + MOST_GROWTH
    for rounds in range(MOST_ROUNDS):
        expansion = Round(current, source, definitions, refusals, most)
        result = expansion.run(definitions.spans if not rounds else ())
        if result is None:
            return Expanded(source, refusals)
        source = result.after(source)
        current = source.text
    for use in _USE.finditer(current):
        place = source.offset(use.start()) if source else use.start()
        if definitions.at(use[1], place):
            refusals.setdefault(place, _endless(use[1]))
    return Expanded(source, refusals)


def _endless(name: str) -> tuple[str, str]:
    return f"macro \\{name} stands for too much, or for itself", "write out what it stands for"


# The definitions of a document


def definitions_in(text: str) -> Definitions:
    """Return the macros that a text defines."""
    result = Definitions()
    pairs = brace_pairs(text)
    place = 0
    while match := _DEFINITION.search(text, place):
        name = match["braced"] or match["bare"]
        macro, place = _definition(text, match, name, pairs)
        if macro is not None and name not in LEFT_ALONE:
            result.by_name.setdefault(name, []).append(macro)
            result.spans.append((match.start(), place))
    return result


def _definition(
    text: str, match: re.Match[str], name: str, pairs: dict[int, int]
) -> tuple[Macro | None, int]:
    """Return the macro that a definition makes, and where the definition ends."""
    command, place, start = match["command"], match.end(), match.start()
    if command == "let":
        target = _LET.match(text, place)
        return (Macro(name, target[1], place=start), target.end()) if target else (None, place)
    if command.endswith("DocumentCommand"):
        return _document_command(text, place, name, start, pairs)
    if command == "DeclarePairedDelimiter":
        return _paired_delimiter(text, place, name, start, pairs)
    parameters, default, refusal = 0, None, ""
    if command.endswith("def"):
        listed = _PARAMETERS.match(text, place)
        if listed is None:
            brace = text.find("{", place, place + 60)
            refusal, place = "with arguments that are not in braces", brace if brace >= 0 else place
        else:
            parameters, place = listed[1].count("#"), listed.end()
    elif command != "DeclareMathOperator" and (count := _COUNT.match(text, place)):
        parameters, place = int(count[1]), count.end()
        if optional := _DEFAULT.match(text, place):
            default, place = optional[1], optional.end()
    body = argument_at(text, place, pairs)
    if body is None:
        return None, match.end()
    words_of_body = text[body[0] : body[1]]
    if command == "DeclareMathOperator":
        words_of_body = f"\\operatorname{{{words_of_body}}}"
    return Macro(name, words_of_body, parameters, default, start, refusal), body[2]


def _document_command(
    text: str, place: int, name: str, start: int, pairs: dict[int, int]
) -> tuple[Macro | None, int]:
    """Read \\NewDocumentCommand{\\x}{O{1} m}{body}: an optional argument first, the others in braces."""
    kinds = argument_at(text, place, pairs)
    body = argument_at(text, kinds[2], pairs) if kinds else None
    if kinds is None or body is None:
        return None, place
    match = re.fullmatch(r"\s*(?:O\{([^{}]*)\}|(o))?((?:\s*m)*)\s*", text[kinds[0] : kinds[1]])
    if match is None:
        refusal = f"with arguments of the kinds {text[kinds[0] : kinds[1]].strip()!r}"
        return Macro(name, place=start, refusal=refusal), body[2]
    is_optional = match[1] is not None or match[2] is not None
    count = match[3].count("m") + is_optional
    default = (match[1] or "") if is_optional else None
    return Macro(name, text[body[0] : body[1]], count, default, start), body[2]


def _paired_delimiter(
    text: str, place: int, name: str, start: int, pairs: dict[int, int]
) -> tuple[Macro | None, int]:
    left = argument_at(text, place, pairs)
    right = argument_at(text, left[2], pairs) if left else None
    if left is None or right is None:
        return None, place
    body = f"\\left{text[left[0] : left[1]].strip()} #1 \\right{text[right[0] : right[1]].strip()}"
    return Macro(name, body, 1, place=start), right[2]


def brace_pairs(text: str) -> dict[int, int]:
    """Return where each brace of a text closes, those nested too deeply left out."""
    pairs: dict[int, int] = {}
    open_braces: list[int] = []
    for match in _BRACE.finditer(text):
        if match.group() == "{":
            open_braces.append(match.start())
        elif match.group() == "}" and open_braces:
            start = open_braces.pop()
            if len(open_braces) < _DEEPEST and match.start() - start < LONGEST_ARGUMENT:
                pairs[start] = match.start()
    return pairs


def argument_at(text: str, place: int, pairs: dict[int, int]) -> tuple[int, int, int] | None:
    """Return where an argument's inside begins and ends, and where it ends with its braces."""
    blank = _SPACE.match(text, place)
    place = blank.end() if blank else place
    if place >= len(text) or text[place] in "}&$%":
        return None
    if text[place] != "{":
        command = _SIGN.match(text, place)
        stop = command.end() if command else place + 1
        return place, stop, stop
    close = pairs.get(place)
    return None if close is None else (place + 1, close, close + 1)


# One round: every outermost use is replaced

LONGEST_COMMAND = 40
"""Characters before a macro in which the command ends that its first letter would run into."""

Handler = Callable[[str, int, dict[int, int]], "tuple[list[str | Span], int] | str | None"]
"""What a package's command at a place becomes, and where it ends; why not; or None: it stays."""


class Round:
    """Replaces each outermost macro of a text once."""

    def __init__(
        self,
        text: str,
        source: Rewritten | None,
        definitions: Definitions,
        refusals: dict[int, tuple[str, str]],
        most: int,
    ) -> None:
        self.text, self.source, self.definitions, self.refusals = text, source, definitions, refusals
        self.room = most - len(text)
        self.pairs = brace_pairs(text)
        self.rewriter = Rewriter(text)
        self.changes = 0

    def run(self, spans: Span | tuple[()] | list[Span] = ()) -> Rewritten | None:
        """Return the text after the round, None if nothing changed; `spans` are taken out."""
        place = 0
        taken_out = iter([*spans, None])
        out = next(taken_out)
        while match := _USE.search(self.text, place):
            if isinstance(out, tuple) and match.start() >= out[0]:
                self.rewriter.replace(out[0], out[1], "")
                self.changes += 1
                place, out = out[1], next(taken_out)
                continue
            place = self._use(match)
            if self.changes > MOST_USES:
                break
        return self.rewriter.finish() if self.changes else None

    def _origin(self, place: int) -> int:
        return self.source.offset(place) if self.source else place

    def _use(self, match: re.Match[str]) -> int:
        """Replace a macro; return where to go on."""
        name, origin = match[1], self._origin(match.start())
        macro = self.definitions.at(name, origin)
        if macro is not None:
            result = self._replacement(macro, match.end())
        elif name in PACKAGES and name not in self.definitions.by_name:
            result = PACKAGES[name](self.text, match.end(), self.pairs)
        else:
            return match.end()
        if isinstance(result, str):
            self.refusals.setdefault(origin, (result, "write out what it stands for"))
        if result is None or isinstance(result, str):
            return match.end()
        texts, end = result
        growth = sum(len(t) if isinstance(t, str) else t[1] - t[0] for t in texts) - end + match.start()
        if growth > self.room:
            self.refusals.setdefault(origin, _endless(name))
            return match.end()
        self.room -= max(growth, 0)
        if (
            macro is not None
            and _WHOLE_FUNCTION.match(macro.body)
            and _POWER_BEHIND.match(self.text, end)
        ):
            texts = ["{", *texts, "}"]  # \\C^2 is the square of the whole \\cos\\theta
        first = texts[0] if texts else ""
        first = first if isinstance(first, str) else self.text[slice(*first)]
        before = self.text[max(match.start() - LONGEST_COMMAND, 0) : match.start()]
        is_glued = first[:1].isalpha() and re.search(r"_\w$|\\[A-Za-z]+$", before)
        lead = [" "] if is_glued else []  # a_z\mo is a_z m_o, \lambda\mo is \lambda m_o
        self.rewriter.replace(match.start(), end, *lead, *texts, *self._parting(texts, end))
        self.changes += 1
        return end

    def _parting(self, texts: list[str | Span], end: int) -> list[str]:
        """Return a blank where a command at the end would run into a letter, typed or of a macro."""
        last = next(
            (t if isinstance(t, str) else self.text[t[0] : t[1]] for t in reversed(texts) if t), ""
        )
        runs_on = re.match(r"[^\W\d_]|\\[A-Za-z]", self.text[end : end + 2])
        return [" "] if runs_on and re.search(r"\\[A-Za-z]+$", last) else []

    def _replacement(self, macro: Macro, place: int) -> tuple[list[str | Span], int] | str | None:
        """Return a macro's body with its arguments in it, and where the last argument ends."""
        if macro.refusal:
            return f"macro \\{macro.name} {macro.refusal}"
        arguments: list[str | Span] = []
        if self.text.startswith("*", place) and macro.parameters:
            place += 1
        if macro.default is not None:
            optional = _DEFAULT.match(self.text, place)
            arguments.append(optional.span(1) if optional else macro.default)
            place = optional.end() if optional else place
        while len(arguments) < macro.parameters:
            argument = argument_at(self.text, place, self.pairs)
            if argument is None:
                return f"macro \\{macro.name} without its {macro.parameters} arguments"
            arguments.append((argument[0], argument[1]))
            place = argument[2]
        if not macro.parameters and (empty := _EMPTY.match(self.text, place)):
            place = empty.end()
        return self._filled(macro.body, arguments), place

    def _filled(self, body: str, arguments: list[str | Span]) -> list[str | Span]:
        texts: list[str | Span] = []
        done = 0
        body = _in_one_line(body)
        for match in _PARAMETER.finditer(body):
            before = body[done : match.start()]
            number = int(match[1])
            argument = arguments[number - 1] if number <= len(arguments) else ""
            first = (
                self.text[argument[0]]
                if isinstance(argument, tuple) and argument[0] < argument[1]
                else ""
            )
            parting = " " if re.search(r"\\[A-Za-z]+$", before) and first.isalpha() else ""
            texts += [before + parting, argument]
            done = match.end()
        return [*texts, body[done:]]


def _in_one_line(body: str) -> str:
    """Return the body of a macro without line ends: what stands behind its use keeps its line number."""
    if "\n" not in body:
        return body
    body = _COMMENT.sub("", body)
    return re.sub(r"\n", " ", re.sub(r"\n[ \t]*\n\s*", r"\\par ", body))


# Commands of packages


def _arguments(
    text: str, place: int, pairs: dict[int, int], count: int, optional: bool = False
) -> tuple[list[Span], int] | None:
    """Return the spans of so many arguments and where they end; an optional one first is passed over."""
    if optional and (match := _DEFAULT.match(text, place)):
        place = match.end()
    spans: list[Span] = []
    for _ in range(count):
        argument = argument_at(text, place, pairs)
        if argument is None:
            return None
        spans.append((argument[0], argument[1]))
        place = argument[2]
    return spans, place


def _only(which: int, count: int) -> Handler:
    """Return the handler of a command that shows one of its arguments, as \\textcolor{red}{x} does."""

    def handle(text: str, place: int, pairs: dict[int, int]) -> tuple[list[str | Span], int] | None:
        parts = _arguments(text, place, pairs, count, optional=True)
        if parts is None:
            return None
        texts: list[str | Span] = ["{", parts[0][which], "}"]
        return texts, parts[1]

    return handle


def _spaced(text: str, place: int, pairs: dict[int, int]) -> tuple[list[str | Span], int] | None:
    """\\mathrel{:=} is := with its space."""
    parts = _arguments(text, place, pairs, 1)
    return ([" ", parts[0][0], " "], parts[1]) if parts else None


def _struck_out(
    text: str, place: int, pairs: dict[int, int]
) -> tuple[list[str | Span], int] | str | None:
    """\\cancel{r} is r where it is struck out twice, above and below; alone it is there or not."""
    parts = _arguments(text, place, pairs, 1, optional=True)
    if parts is None:
        return None
    first = max((end.end() for end in _END_OF_FORMULA.finditer(text, 0, place)), default=0)
    last = _END_OF_FORMULA.search(text, parts[1])
    around = "".join(text[first : last.start() if last else len(text)].split())
    inside = "".join(text[slice(*parts[0][0])].split())
    count = sum(around.count(f"\\{name}{{{inside}}}") for name in ("cancel", "bcancel", "xcancel"))
    if count % 2:
        return f"{inside!r} struck out once, which may stand or not"
    return ["{", parts[0][0], "}"], parts[1]


_END_OF_FORMULA = re.compile(r"\$|\n\s*\n|\\[\[\]()]|\\\\(?![A-Za-z])|\\(?:begin|end)\b")


def _dropped(count: int) -> Handler:
    """Return the handler of a command that says nothing, with so many arguments."""

    def handle(text: str, place: int, pairs: dict[int, int]) -> tuple[list[str | Span], int] | None:
        parts = _arguments(text, place, pairs, count, optional=True)
        return ([" "], parts[1]) if parts else None

    return handle


def _siunitx(write: Callable[..., str | None], count: int) -> Handler:
    """Return the handler of a command of siunitx with so many arguments."""

    def handle(text: str, place: int, pairs: dict[int, int]) -> tuple[list[str | Span], int] | str | None:
        parts = _arguments(text, place, pairs, count, optional=True)
        if parts is None:
            return None
        inside = [text[a:b] for a, b in parts[0]]
        written = write(*inside)
        if written is None:
            return f"the quantity {' '.join(inside)!r} is not one number with a unit that is known"
        return [f" {written} "], parts[1]

    return handle


def _quantity(text: str, place: int, pairs: dict[int, int]) -> tuple[list[str | Span], int] | str | None:
    """\\qty{40}{mm} is a quantity; \\qty( ) of the package physics only a bracket."""
    blank = _SPACE.match(text, place)
    start = blank.end() if blank else place
    if text.startswith(("(", "[", "|"), start) and not _siunitx_options(text, start):
        return [" "], place
    return _siunitx(siunitx.quantity_text, 2)(text, place, pairs)


def _siunitx_options(text: str, place: int) -> bool:
    match = _DEFAULT.match(text, place)
    return match is not None and "=" in match[1]


def _derivative(sign: str) -> Handler:
    """Return the handler of \\dv[n]{f}{x} and \\dv{x}."""

    def handle(text: str, place: int, pairs: dict[int, int]) -> tuple[list[str | Span], int] | None:
        order = _DEFAULT.match(text, place)
        place = order.end() if order else place
        first = _arguments(text, place, pairs, 1)
        if first is None:
            return None
        power = f"^{{{order[1]}}}" if order else ""
        after = text[first[1] : first[1] + 1]
        second = _arguments(text, first[1], pairs, 1) if after == "{" else None
        variable, end = (second[0][0], second[1]) if second else (first[0][0], first[1])
        body: Span = first[0][0] if second else (place, place)
        return [f"\\frac{{{sign}{power} ", body, f"}}{{{sign} ", variable, f"{power}}}"], end

    return handle


def _above(text: str, place: int, pairs: dict[int, int]) -> tuple[list[str | Span], int] | str | None:
    """\\overset{!}{=} is =, which is to hold; words above another relation say nothing about it."""
    parts = _arguments(text, place, pairs, 2)
    if parts is None:
        return None
    above, sign = (text[a:b].strip() for a, b in parts[0])
    if sign in _WITH_PLACE_BELOW:
        return [f"{sign}_{{", parts[0][0], "}"], parts[1]
    if not RELATION.fullmatch(sign):
        return f"{above!r} above or below {sign!r} is not read"
    return ([" \\shallbe "] if sign == "=" and above == "!" else [" ", parts[0][1], " "]), parts[1]


_WITH_PLACE_BELOW = ("\\max", "\\min", "\\lim", "\\sup", "\\inf", "\\sum")


def _framed(text: str, place: int, pairs: dict[int, int]) -> tuple[list[str | Span], int] | None:
    """Return what is underlined as what is boxed, a relation or a part; a phasor's letter stays."""
    command = text.rfind("\\", 0, place)
    if is_underlined_letter(text, command):
        return None
    parts = _arguments(text, place, pairs, 1)
    return (["\\boxed{", parts[0][0], "}"], parts[1]) if parts else None


def _solidus(text: str, place: int, pairs: dict[int, int]) -> tuple[list[str | Span], int] | None:
    """Return \\nicefrac{r}{l} as \\frac{r}{l}."""
    parts = _arguments(text, place, pairs, 2, optional=True)
    return (["\\frac{", parts[0][0], "}{", parts[0][1], "}"], parts[1]) if parts else None


def _unit_or_quantity(
    text: str, place: int, pairs: dict[int, int]
) -> tuple[list[str | Span], int] | str | None:
    """\\unit[40]{mm} of the package units is a quantity, \\unit{mm} of siunitx a unit."""
    number = _NUMBER_FIRST.match(text, place)
    if number is None:
        return _siunitx(siunitx.unit_text, 1)(text, place, pairs)
    size = number[1].replace("{,}", ".")
    return _siunitx(lambda unit: siunitx.quantity_text(size, unit), 1)(text, number.end(), pairs)


def _unit_fraction(
    text: str, place: int, pairs: dict[int, int]
) -> tuple[list[str | Span], int] | str | None:
    """\\unitfrac[9.81]{m}{s^2} is a quantity."""
    number = _NUMBER_FIRST.match(text, place)
    size = number[1].replace("{,}", ".") if number else ""

    def write(above: str, below: str) -> str | None:
        unit = f"{above}/{below}"
        return siunitx.quantity_text(size, unit) if size else siunitx.unit_text(unit)

    return _siunitx(write, 2)(text, number.end() if number else place, pairs)


_NUMBER_FIRST = re.compile(r"\s*\[\s*([-+−]?[0-9][0-9 .,{}]*(?:[eE][-+]?[0-9]+)?)\s*\]")

PACKAGES: dict[str, Handler] = {
    **dict.fromkeys(words("cancel bcancel xcancel"), _struck_out),
    **dict.fromkeys(words("mathclap mathllap mathrlap smash ensuremath"), _only(0, 1)),
    **dict.fromkeys(words("textcolor mathcolor colorbox raisebox scalebox href"), _only(1, 2)),
    **dict.fromkeys(words("fcolorbox resizebox"), _only(2, 3)),
    **dict.fromkeys(words("color pagecolor eqref ref cite autoref cref Cref"), _dropped(1)),
    **dict.fromkeys(words("leftroot uproot"), _dropped(1)),
    **dict.fromkeys(
        words(
            "checkmark blacksquare square Box qed qedhere lozenge bigstar xspace IEEEyesnumber"
            " IEEEyessubnumber IEEEnonumber IEEEeqnarraynumspace"
        ),
        _dropped(0),
    ),
    **dict.fromkeys(words("overset underset stackrel stackbin"), _above),
    **dict.fromkeys(words("mathrel mathbin mathord mathopen mathclose mathinner"), _spaced),
    "mathop": differential_signs.operator_sign,
    **dict.fromkeys(differential_signs.NAMES, differential_signs.without_definition),
    "IEEEeqnarraymulticol": _only(2, 3),
    "SI": _siunitx(siunitx.quantity_text, 2),
    "num": _siunitx(siunitx.number_text, 1),
    **dict.fromkeys(words("SIrange qtyrange"), _siunitx(siunitx.range_text, 3)),
    "numrange": _siunitx(siunitx.range_text, 2),
    **dict.fromkeys(words("SIlist qtylist"), _siunitx(siunitx.list_text, 2)),
    "numlist": _siunitx(siunitx.list_text, 1),
    "anglist": _siunitx(lambda source: siunitx.list_text(source, "\\degree"), 1),
    "angrange": _siunitx(lambda first, last: siunitx.range_text(first, last, "\\degree"), 2),
    "ang": _siunitx(siunitx.angle_text, 1),
    "si": _siunitx(siunitx.unit_text, 1),
    "unit": _unit_or_quantity,
    **dict.fromkeys(words("unitfrac"), _unit_fraction),
    **dict.fromkeys(words("nicefrac sfrac flatfrac xfrac"), _solidus),
    **dict.fromkeys(words("underline uline uuline dunderline"), _framed),
    "qty": _quantity,
    "dv": _derivative("d"),
    "pdv": _derivative("\\partial"),
    **PHYSICS,
}  # fmt: skip
