"""The lexer of hand-written formulas, LaTeX or plain text: one formula cut into tokens.

Letters are looked up among the declared ones, so that `mr` may be two letters and `Lh` one.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache

from symbalance.document.letters import (
    ACCENTS,
    DOTTED,
    FONTS,
    FUNCTION_WORDS,
    GREEK_SIGN,
    LOWERED,
    NAME_OF_SIGN,
    RAISED,
    TIME_DOTS,
    WORDS,
)
from symbalance.notes.reading import signs
from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.formulas.minutes_of_angles import minutes_at
from symbalance.notes.reading.formulas.moduli import modulus_end
from symbalance.notes.reading.letters.letter_names import (
    EXTREMES,
    matching_brace,
    may_be_letters,
    subscript_at,
    with_order,
    with_scripts,
)
from symbalance.notes.reading.units import (
    Scale,
    bracketed_unit_at,
    is_multiple_of_letter,
    is_set_apart,
    plain_unit_at,
    scale_of,
    unit_fraction_at,
    unit_set_at,
)
from symbalance.text import lazy_patterns as re

LONGEST_EQUATION = 20_000
"""Characters of one equation: text that is no derivation must not cost minutes."""
LARGEST = Fraction(10) ** 300
"""Numbers up to it and down to its reciprocal are read: witnesses are floats, which end at 10³⁰⁸."""

_DEGREE = re.compile(
    r"\^\s*(?:\{(?:\s|\\[,;:! ])*\\circ\s*\}|\\circ(?![A-Za-z]))|[°˚º]|度|\\degree(?![A-Za-z])"
)
_NUMBER_WITH_E = re.compile(r"[0-9]+(?:\.[0-9]+)?[eE]([+-]?[0-9]{1,2})(?![0-9A-Za-z_.])")
_SPACE = re.compile(
    r"(?:\\[,;:> \t\n]|\\(?:q?quad|enspace|enskip|thinspace|medspace|thickspace|hspace)(?![A-Za-z])|~)"
)
_TYPED_SPACE = re.compile(r"(?:\\[,;: ]|~)+")
_DIFFERENCE = re.compile(r"\s*(\\[a-z]+(?![A-Za-z])|[A-Za-zα-ωϕϵϑ])")
_ARROW = re.compile(r"-+>|=+>|<-+(?![\w.\\(])|<=+>")  # x <-2 is no arrow
_RELATION = re.compile(r"==|:=|<=|>=|!=")
_TWO_SIGNS = {"==": "=", ":=": "=", "<=": "≤", ">=": "≥", "!=": "≠"}
_RUN = re.compile(r"[A-Za-z]+")
_DIGITS = re.compile(r"[0-9]+")
PERCENT = "%"
"""The value of the factor that a percent sign is read as, to tell it from a centimetre's."""
LONGEST_ANNOTATED = 2000  # characters under one \underbrace
_COMMAND = re.compile(r"\\([A-Za-z]+)\*?")
_FONT_WORD = re.compile(r"\s*\{\s*([A-Za-z0-9]+)\s*\}")
_EULER = re.compile(
    r"\s*(?:\{\s*e\s*\}|(?<=\s)e)(?=\s*\^\s*\{(?:[^{}]|\{[^{}]*\})*?(?:\\mathrm\s*\{?\s*|(?<![A-Za-z\\]))[ij](?![A-Za-z]))"
)
"""Behind \\mathrm the e of e^{i φ}, beside which an italic e may be an offset."""
_LEFT_RIGHT = re.compile(r"\\(left|right|[bB]igg?[lr])\s*(\\[{}|]|\\[lr]?vert(?![A-Za-z])|[|.])")
_SIZED_BRACKET = re.compile(r"\\(?:left|right|[bB]igg?[lrm]?)\s*([()\[\]])")
_ARGUMENT = re.compile(r"\s*\{[^{}]*\}")
_ENVIRONMENT = re.compile(r"\s*\{([A-Za-z]+)\*?\}(?:\s*\{\s*[0-9]+\s*\}|\[[a-z]\])?")
_CELLS = re.compile(r"\s*\{([A-Za-z]+)\*?\}(?:\s*\{[lcr|@{}\s]*\}|\[[a-z]\])?")
_AND_SO_ON = r"(?:etc(?![a-z])|usw(?![a-z])|u\.\s?s\.\s?w(?![a-z])|h\.\s?o\.\s?t(?![a-z]))\.?"
_ET_CETERA = re.compile(
    rf"&\s?c(?:\.|(?=\s*(?:[,;)=]|$)))|{_AND_SO_ON}|\.(?:[ \t]\.){{2,}}"
    rf"|\\&\s?c\.?|\\(?:text|textrm|mathrm|mbox)\s*\{{\s*(?:\\?&\s?c\.?|{_AND_SO_ON})\s*\}}"
)
"""What stands for dots behind the last sign of a sum, in words: + etc., − &c., + u. s. w., + . . ."""
_END_OF_CELL = re.compile(r"\s*(?:\\[,;: !]\s*)*(?:\\\\|\\end\s*\{|$)")
_ARGUMENT_BEHIND = re.compile(r"\s*(?:\(|\\left\(|(?:\\[,;: ]|~|\s)+[0-9A-Za-z\\])")
"""What a function is taken of: \\mathrm{arctg}\\, 1 is no product of five letters."""
_OWN_FUNCTION = re.compile(r"(Re|Im|conj|lg)(?=\s*(?:[({]|\\left))|lg(?=\s+[0-9A-Za-z\\])")
_WORD_FONTS = ("text", "textrm", "mbox")
_UNIT_OF_LETTER = re.compile(
    r"(?<=[A-Za-zΑ-ω}_0-9])\s?(?:\\[,;: ])?\[\s*(?:\\mathrm\s*\{|\\text\s*\{)?"
    r"([A-Za-zµμ/^0-9·⁻¹² .{}-]{1,20}?)\}?\s*\]"
)
"""A letter with the unit in which it is counted in square brackets: P[kW], n [rpm]."""
_NEAR_UNIT = 160
"""Characters of a formula beside a letter in which the units of others stand."""
_UNIT_COMMANDS = ("mathrm", "unit", "si", *_WORD_FONTS)


@dataclass(frozen=True, slots=True)
class Token:
    """A piece of a formula from `start` to `end` (offsets in the document).

    Kinds: number, name, function, op (+ - * /), rel, open, close, bar, sup, sub, under, cmd, sep,
    dots, degree, arrow (of a limit), postfix (!), cell and row (of a matrix), parity and remainder (of a
    case: even, odd, mod), differential (the d x of an integral). `sub` carries a subscript that follows
    something other than a letter; `under` is a bare underscore after a sum sign or a
    function. `spaced` tells of a space typed as such before it.
    `counted` marks a letter behind a number that is no unit there, by the formula around it.
    `scale` is what the unit behind it multiplies it by, 0 where that is not sure. `upright` marks the e
    of e^{i φ} where a letter e is declared. `divides_all` marks a ÷, which divides by all that
    stands side by side behind it.
    """

    kind: str
    value: str
    start: int
    end: int
    number: Fraction = Fraction(0)
    place: Fraction | None = None
    spaced: bool = False
    scale: Fraction | None = None
    is_demanded: bool = False
    upright: bool = False
    counted: bool = False
    divides_all: bool = False

    def moved(self, offset: int) -> Token:
        """Return the token so many characters further on."""
        return replace(self, start=self.start + offset, end=self.end + offset)

    def is_op(self, signs: str) -> bool:
        """Tell whether this is one of the operators."""
        return self.kind == "op" and self.value in signs

    def is_cmd(self, *names: str) -> bool:
        """Tell whether this is one of the commands."""
        return self.kind == "cmd" and self.value in names


CLOSER = {"(": ")", "[": "]", "{": "}", "\\{": "\\}", "<": ">", "|": "|", ".": "|"}
AT = "(at"
"""The bracket of x(π), where it is known to hold a place and no factor."""
CLOSER[AT] = ")"
CLOSER |= dict.fromkeys(signs.CELLS.values(), "[end]")
"""The bracket that closes each bracket."""


def lex(text: str, start: int, end: int, names: Collection[str], setting: str = "") -> list[Token]:
    """Return the tokens of text[start:end]; 3!= 6 is 3! = 6 in the setting "tex", 3 ≠ 6 in "code"."""
    lexer = Lexer(text, start, end, names)
    lexer.setting = setting
    return lexer.run()


class Lexer:
    """Cuts one formula into tokens; every offset is one of the whole document."""

    def __init__(self, text: str, start: int, end: int, names: Collection[str]) -> None:
        self.text, self.place, self.end = text, start, end
        self.words = vocabulary(names)
        self.tokens: list[Token] = []
        self.skips: dict[int, int] = {}  # where words under a brace begin -> where they end
        self.latex = "\\" in text[start:end]
        self.cells: list[str] = []  # the matrices that are open
        self.setting = ""

    def run(self) -> list[Token]:
        """Return all tokens."""
        if self.end - self.place > LONGEST_EQUATION:
            what = f"an equation of more than {LONGEST_EQUATION} characters"
            raise ReadingError(self.place, what, "write it in parts")
        spaced = False
        while self.place < self.end:
            count, space = len(self.tokens), _SPACE.match(self.text, self.place, self.end)
            self._next_token()
            if len(self.tokens) == count:
                spaced = spaced or space is not None
            elif spaced:
                self.tokens[count] = replace(self.tokens[count], spaced=True)
                spaced = False
        return _with_three_dots(_without_braces(self.tokens))

    def _next_token(self) -> None:
        """Add the token that begins at the place, or go past what is none."""
        sign = self.text[self.place]
        if self._may_begin_unit(sign) and self.plain_unit(sign):
            return
        if dots := self._and_so_on():
            self._add("dots", "…", dots)
        elif self.place in self.skips:
            self.place = self.skips.pop(self.place)
        elif (
            sign in "(\\"
            and self._is_congruence()
            and (end := modulus_end(self.text, self.place, self.end))
        ):
            self.place = end  # the checker looks for it behind the right side
        elif sign == "&" and self.cells:
            self._add("cell", "&", self.place + 1)
        elif sign.isspace() or sign == "&" or not sign.isprintable():
            self.place += 1
        elif match := _DEGREE.match(self.text, self.place, self.end):
            self._degrees(match.end())
        elif sign == "\\":
            self._backslash()
        elif sign.isascii() and sign.isalpha():
            self._word()
        elif sign in "0123456789" or self._decimal_point(sign):
            self._number()
        else:
            self._sign(sign)

    def _is_congruence(self) -> bool:
        """Tell whether n ≡ 1 stands before the place."""
        return not self.cells and any(token.value == "≡" for token in self.tokens)

    def _and_so_on(self) -> int:
        """Return where the &c. of 1 + x + &c. ends; 0 where none stands here."""
        last = self.tokens[-1] if self.tokens else None
        if last is None or not (last.kind == "sep" or last.is_op("+-±∓")):
            return 0
        match = _ET_CETERA.match(self.text, self.place, self.end)
        return match.end() if match and not (self.latex and self.text[self.place] == "&") else 0

    def _may_begin_unit(self, sign: str) -> bool:
        """Tell whether a unit may begin at the place: behind a number, or in square brackets."""
        if sign == "[":
            return True
        if not self.tokens or not (sign in " \u2009\u202f\u205f" or sign.isalpha()):
            return False
        between = self.text[self.tokens[-1].end : self.place]
        return (not between or _TYPED_SPACE.fullmatch(between) is not None) and (
            self.tokens[-1].kind in ("number", "vulgar", "close") or self.tokens[-1].value == "pi"
        )

    def _is_behind_power(self) -> bool:
        """Tell whether 5² or 5^2 stands before the place."""
        kinds = "".join(token.kind[0] for token in self.tokens[-5:])
        return kinds.endswith(("nsn", "nsonc", "csn", "csonc"))

    def _sign(self, sign: str) -> None:
        """Add the token of a sign: relation, dots, operator, bracket."""
        arrow = _ARROW.match(self.text, self.place, self.end)
        if (arrow or sign == "→") and self._is_in_limit():
            self._add("arrow", "→", arrow.end() if arrow else self.place + 1)
            return
        if arrow and arrow.group() != "<=":
            raise ReadingError(self.place, *signs.REFUSED["to"])
        match = _RELATION.match(self.text, self.place, self.end)
        if match and match.group() == "!=" and self.setting != "code" and self._is_behind_operand():
            self._factorial_before_equals()
        elif match:
            self._add("rel", _TWO_SIGNS[match.group()], match.end())
        elif dots := next((d for d in signs.DOTS_SIGNS if self.text.startswith(d, self.place)), None):
            self._add("dots", "…", self.place + len(dots))
        elif sign in signs.RELATION_SIGNS:
            self._add("rel", signs.RELATION_SIGNS[sign], self.place + 1)
        elif sign in signs.OPERATOR_SIGNS:
            self._operator(sign)
        elif sign in signs.OPENING:
            self._add("open", signs.OPENING[sign], self.place + 1)
        elif sign in signs.CLOSING:
            self._add("close", signs.CLOSING[sign], self.place + 1)
        else:
            self._rare_sign(sign)

    def _is_behind_operand(self) -> bool:
        last = self.tokens[-1] if self.tokens else None
        return last is not None and last.end == self.place and last.kind in ("number", "name", "close")

    def _factorial_before_equals(self) -> None:
        """Take the ! of 3!=6, which TeX sets as 3! = 6; in plain text it may as well be 3 ≠ 6."""
        if self.setting != "tex":
            what = "!= right behind a letter or number, ≠ or a factorial and ="
            raise ReadingError(self.place, what, "write x ≠ 3, or n! = 6 with a space")
        self._add("postfix", "!", self.place + 1)

    def _is_in_limit(self) -> bool:
        """Tell whether lim_{x stands right before the place."""
        return any(token.is_cmd("lim") for token in self.tokens[-4:])

    def _operator(self, sign: str) -> None:
        if self.text.startswith("**", self.place):
            self._add("sup", "^", self.place + 2)
        else:
            self._add("op", signs.OPERATOR_SIGNS[sign], self.place + 1)
            self.tokens[-1] = replace(self.tokens[-1], divides_all=sign == "÷")

    def _rare_sign(self, sign: str) -> None:
        """Add the token of a sign that is none of the usual ones."""
        simple = {"^": "sup", "|": "bar", ",": "sep", ";": "sep", "!": "postfix"}
        if sign == "!" and self.tokens and self.tokens[-1].kind == "postfix":
            raise ReadingError(self.place, "a double factorial is not read", "write the product")
        if sign in simple:
            self._add(simple[sign], sign, self.place + 1)
        elif sign == "_":
            self._underscore()
        elif sign in RAISED:
            self._superscript()
        elif (
            sign in LOWERED and self.tokens and self.tokens[-1].is_cmd(*signs.WITH_BOUNDS.values(), "sum")
        ):
            self._lowered_bound()
        elif sign in signs.VULGAR:
            self._vulgar(sign)
        elif sign in ("√", "∛", "∜", "∂", "∞", "Σ", "∑", "∫", "∮", "∏", "⊤"):
            self._named_sign(sign)
        elif sign in DOTTED:
            letter, order = DOTTED[sign]
            self.tokens.append(Token("cmd", "dot" if order == 1 else "ddot", self.place, self.place + 1))
            self._letter(letter, self.place + 1)
        elif sign in NAME_OF_SIGN:
            self._greek_sign(NAME_OF_SIGN[sign])
        else:
            self._unknown(sign)

    def _named_sign(self, sign: str) -> None:
        if sign == "Σ" and "Sigma" in self.words.names:
            self._letter("Sigma", self.place + 1)
        else:
            name = {
                "√": "surd", "∛": "surd3", "∜": "surd4", "∂": "partial", "∞": "infty",
                "Σ": "sum", "∑": "sum", "∫": "int", "∮": "oint", "∏": "prod", "⊤": "top",
            }[sign]  # fmt: skip
            self._add("cmd", name, self.place + 1)

    def _vulgar(self, sign: str) -> None:
        """Take ½ as a number, and 4½ as one that is a half larger than 4."""
        last = self.tokens[-1] if self.tokens else None
        if last is None or last.kind != "number" or last.place is not None:
            self._add("vulgar", sign, self.place + 1)
            return
        before = self.tokens[-2].kind if len(self.tokens) > 1 else ""
        is_apart = last.end < self.place
        behind = self.text[self.place + 1 : min(self.place + 3, self.end)].lstrip()
        is_factor = is_apart and (behind[:1].isalpha() or behind[:1] in ("(", "\\"))
        if before in ("sup", "sub", "under", "cmd") or last.scale is not None or is_factor:
            what = f"{last.value}{sign}, a mixed number or a product"
            raise ReadingError(self.place, what, "write 5/2 for 2½")
        whole = last.number + Fraction(*signs.VULGAR[sign])
        self.tokens[-1] = replace(last, value=str(whole), end=self.place + 1, number=whole)
        self.place += 1

    def _underscore(self) -> None:
        last = self.tokens[-1] if self.tokens else None
        if last and self._has_place_below(last):
            self._add("under", "_", self.place + 1)
            return
        if last and (last.is_cmd("sum") or last.kind in ("function", "number", "sup", "close", "name")):
            if last.kind == "close":
                subscript = subscript_at(self.text, self.place, self.end)
                if subscript:
                    self._add("sub", *subscript)
                    return
            self._add("under", "_", self.place + 1)
            return
        raise ReadingError(self.place, "a subscript without its letter", "write the letter before it")

    def _has_place_below(self, last: Token) -> bool:
        """Tell whether an underscore begins a bound or the place of a bar: \\int_0, |_{x=0}, ]_a^b."""
        if last.is_cmd(*signs.WITH_BOUNDS.values()) or last.kind == "bar":
            return True
        if last.kind == "sup" or last.kind != "close" or last.value not in ("]", "|", ")"):
            return False
        return last.value != ")" or "=" in self.text[self.place : self.place + 12].partition("}")[0]

    def _lowered_bound(self) -> None:
        """∫₀ is \\int_{0}."""
        stop = self.place
        while stop < self.end and self.text[stop] in LOWERED:
            stop += 1
        plain = "".join(LOWERED[sign] for sign in self.text[self.place : stop])
        number = read_number(plain, 0, len(plain))
        first = self.place
        self._add("under", "_", first)
        self._add("open", "{", first)
        if number is not None and number.end == len(plain):
            self.tokens.append(replace(number, start=first, end=stop))
        else:
            self.tokens.append(Token("name", plain, first, stop))
        self.place = first
        self._add("close", "}", stop)

    def _superscript(self) -> None:
        first = self.place
        self._add("sup", "^", first)
        self._add("open", "{", first)
        while self.place < self.end and (plain := RAISED.get(self.text[self.place])):
            self._superscript_sign(plain)
        self._add("close", "}", self.place)

    def _superscript_sign(self, plain: str) -> None:
        if plain.isdecimal():
            stop = self.place
            while stop < self.end and RAISED.get(self.text[stop], " ").isdecimal():
                stop += 1
            digits = "".join(RAISED[c] for c in self.text[self.place : stop])
            number = read_number(digits, 0, len(digits))
            assert number
            self.tokens.append(Token("number", digits, self.place, stop, number.number))
            self.place = stop
            return
        kinds = {"+": "op", "-": "op", "(": "open", ")": "close"}
        self._add(kinds.get(plain, "name"), plain, self.place + 1)

    def _unknown(self, sign: str) -> None:
        if sign == "%":
            self._percent(self.place + 1)
        elif sign in signs.REFUSED_SIGNS:
            raise ReadingError(self.place, *signs.REFUSED_SIGNS[sign])
        elif sign == "~":
            self._tilde()
        elif sign in ".。" and self.cells and _END_OF_CELL.match(self.text, self.place + 1, self.end):
            self.place += 1
        elif sign in ".。":
            raise ReadingError(self.place, "a stray point", "remove it")
        else:
            raise ReadingError(
                self.place, f"sign {sign} is not read", "write it in letters and operators"
            )

    def _degrees(self, stop: int) -> None:
        """Add a degree sign; the minutes and seconds of 18° 26' 30'' go with the degrees before it."""
        last = self.tokens[-1] if self.tokens else None
        parts = (
            minutes_at(self.text, stop, self.end) if last is not None and last.kind == "number" else None
        )
        if last is None or parts is None:
            self._add("degree", "°", stop)
            return
        if last.place is not None or last.scale is not None:
            raise ReadingError(stop, "minutes behind degrees with decimals", "write the angle in degrees")
        size, place, end = parts
        number = last.number + size
        self.tokens[-1] = replace(last, value=str(number), end=end, number=number, place=place)
        self._add("degree", "°", end)

    def _percent(self, stop: int) -> None:
        """5 % is 5/100."""
        if not self.is_behind_number():
            raise ReadingError(self.place, *signs.REFUSED_SIGNS["%"])
        self.add_factor("%", (Fraction(1, 100), False), stop)
        self.tokens[-2] = replace(self.tokens[-2], value=PERCENT)

    def _tilde(self) -> None:
        around = self.text[max(self.place - 1, 0) : self.place + 2]
        if self.latex:
            self.place += 1
        elif around[:1].isspace() and around[-1:].isspace():
            self._add("rel", "≈", self.place + 1)
        else:
            raise ReadingError(self.place, "~ is not read here", "write ≈")

    # Numbers and letters

    def _add(self, kind: str, value: str, stop: int) -> None:
        self.tokens.append(Token(kind, value, self.place, stop))
        self.place = stop

    def _decimal_point(self, sign: str) -> bool:
        return sign == "." and self.text[self.place + 1 : min(self.place + 2, self.end)].isdecimal()

    def _number(self) -> None:
        scientific = "e" not in self.words.names or self._is_power_of_ten()
        last = self.tokens[-1] if self.tokens else None
        # 10^3 500 and x_1 200 end their index at the space; \frac 1 200 has two arguments
        is_apart = last is None or last.kind not in ("sup", "sub", "cmd")
        if not (token := read_number(self.text, self.place, self.end, scientific, is_apart)):
            raise ReadingError(self.place, "a digit that is not read", "write it as 0 to 9")
        self.tokens.append(token)
        self.place = token.end

    def _is_power_of_ten(self) -> bool:
        """Tell whether 11e5 is a number in plain text beside a letter e: no letter e_5 is known there."""
        match = _NUMBER_WITH_E.match(self.text, self.place, self.end)
        if match is None or self.latex or {f"e{match[1]}", f"e_{match[1]}"} & self.words.names:
            return False
        return match[1][0] in "+-" or "." in match[0] or len(match[0]) > 3

    def _word(self) -> None:
        if self._own_function():
            return
        entry = self.words.longest(self.text, self.place, self.end)
        if entry and entry[0] != "name":
            kind, word = entry
            value = FUNCTION_WORDS.get(word, word)
            self._add("name" if kind == "constant" else kind, value, self.place + len(word))
            return
        word = entry[1] if entry else self.text[self.place]
        digits = self._touching_digits(self.place + len(word))
        word += "" if self._is_imaginary(word, word + digits) else digits
        self._letter(word, self.place + len(word))

    def _own_function(self) -> bool:
        """Read Re( ), Im( ), lg x, and lim, max, min in plain text, where the words are no letters."""
        names = self.words.names
        match = _OWN_FUNCTION.match(self.text, self.place, self.end)
        if match and match.group() not in names and not all(sign in names for sign in match.group()):
            self._add("function", signs.OWN_FUNCTIONS[match.group()], match.end())
            return True
        word = self.text[self.place : self.place + 3]
        after = self.text[self.place + 3 : min(self.place + 4, self.end)]
        is_construct = word in ("lim", "max", "min", "det") and after in ("_", "(", " ", "\\") and after
        if is_construct and word not in names and not all(sign in names for sign in word):
            self._add("cmd", word, self.place + 3)
            return True
        return False

    def _touching_digits(self, place: int) -> str:
        """Return digits that touch a letter: M2 is a letter of its own, x 2 a product."""
        digits = _DIGITS.match(self.text, place, self.end)
        return "" if digits is None or self._expects_argument() else digits.group()

    def _is_imaginary(self, word: str, whole: str) -> bool:
        """Tell whether i2 is i times 2: in a power of e, where neither i nor i2 is a letter."""
        if word not in ("i", "j") or word in self.words.names or whole in self.words.names:
            return False
        return any(token.value in ("e", "exp") for token in self.tokens[-40:])

    def _expects_argument(self) -> bool:
        last = self.tokens[-1] if self.tokens else None
        return last is not None and (last.kind in ("sup", "under") or last.is_cmd("frac", "sqrt"))

    def _letter(self, base: str, stop: int) -> None:
        names = self.words.names
        is_whole = "_" in base
        name, stop = (
            with_order(self.text, base, stop, self.end)
            if is_whole
            else with_scripts(self.text, base, stop, self.end, names)
        )
        if is_whole:
            while stop < self.end and self.text[stop] in "'′’":
                name, stop = name + "'", stop + 1
        if name in ("Delta", "delta") and (after := self._difference(name, stop)):
            name, stop = after
        self._add("name", name, stop)
        if len(name) == 1 and is_multiple_of_letter(self.text, stop - 1, self.end):
            self.tokens[-1] = replace(self.tokens[-1], counted=True)

    def _difference(self, name: str, stop: int) -> tuple[str, int] | None:
        match = _DIFFERENCE.match(self.text, stop, self.end)
        if match is None or name in self.words.names:
            return None
        letter = match.group(1).lstrip("\\")
        letter = NAME_OF_SIGN.get(letter, letter)
        is_letter = len(letter) == 1 or letter in GREEK_SIGN
        indexed, stop = with_scripts(self.text, letter, match.end(), self.end, self.words.names)
        if f"{name}_{indexed}" in self.words.names:
            return f"{name}_{indexed}", stop
        if f"{name}_{letter}" in self.words.names and (indexed == letter or name != "Delta"):
            return f"{name}_{letter}", match.end()
        is_new = name == "Delta" and is_letter and letter != "pi"
        return (f"{name}_{indexed}", stop) if is_new else None

    # What begins with a backslash

    def _backslash(self) -> None:
        if bracket := _SIZED_BRACKET.match(self.text, self.place, self.end):
            kind = "open" if bracket.group(1) in "([" else "close"
            self._add(kind, bracket.group(1), bracket.end())
        elif match := _LEFT_RIGHT.match(self.text, self.place, self.end):
            self._sized_bracket(match)
        elif match := _COMMAND.match(self.text, self.place, self.end):
            self._command(match.group(1), match.end())
        else:
            self._escape(self.text[self.place + 1 : self.place + 2])

    def _sized_bracket(self, match: re.Match[str]) -> None:
        side, delimiter = match.group(1), match.group(2)
        if delimiter == "." and side == "left":
            self._add("open", ".", match.end())
            return
        if delimiter == ".":
            raise ReadingError(self.place, "a bracket with one side only", "write both sides")
        if "|" in delimiter or "vert" in delimiter:
            self._add("open" if side in ("left",) or side[-1] == "l" else "close", "|", match.end())
        else:
            self._add("open" if delimiter == "\\{" else "close", delimiter, match.end())

    def _escape(self, sign: str) -> None:
        if sign == "\\" and self.cells:
            self._add("row", "\\\\", self.place + 2)
        elif sign in ("{", "}"):
            self._add("open" if sign == "{" else "close", "\\" + sign, self.place + 2)
        elif sign == "|":
            self._add("bar", "|", self.place + 2)
        elif sign == "%":
            self._percent(self.place + 2)
        elif not sign or sign in ",;:!> \t\r\n/\\":
            self.place += 2
        else:
            raise ReadingError(self.place, f"unknown command \\{sign}", "write it without")

    def _command(self, name: str, stop: int) -> None:
        """Add what a command stands for: a unit, a letter, a function, a sign."""
        if self.text[stop - 1] == "*":
            stop -= 1
        if self.set_unit(name):
            return
        if name in GREEK_SIGN:
            self._greek(name, stop)
        elif name in signs.OWN_FUNCTIONS:
            self._add("function", signs.OWN_FUNCTIONS[name], stop)
        elif name in signs.ARROWS and self._is_in_limit():
            self._add("arrow", "→", stop)
        elif name in FUNCTION_WORDS and name != "sqrt":
            self._add("function", FUNCTION_WORDS[name], stop)
        elif name in signs.RELATION_COMMANDS:
            self._add("rel", signs.RELATION_COMMANDS[name], stop)
            self.tokens[-1] = replace(self.tokens[-1], is_demanded=name == "shallbe")
        elif name in signs.OPERATOR_COMMANDS:
            self._add("op", signs.OPERATOR_COMMANDS[name], stop)
            self.tokens[-1] = replace(self.tokens[-1], divides_all=name == "div")
        elif name in signs.DOTS_COMMANDS:
            self._add("dots", "…", stop)
        elif name in signs.BRACKET_COMMANDS:
            self._add(*signs.BRACKET_COMMANDS[name], stop)
        else:
            self._other_command(name, stop)

    def _other_command(self, name: str, stop: int) -> None:
        """Add a command of structure, skip one of layout, refuse one that is not read."""
        if name in signs.STRUCTURE or name in ACCENTS or name in TIME_DOTS:
            self._add("cmd", "frac" if name.endswith("frac") else name, stop)
        elif name in signs.CONSTRUCTS:
            self._add("cmd", signs.CONSTRUCTS[name], stop)
        elif name in FONTS:
            self._font(name, stop)
        elif name in signs.SPACE_COMMANDS:
            self.place = stop
        elif self.cells and name in WORDS and (words := _ARGUMENT.match(self.text, stop, self.end)):
            self._condition_word(words)
        elif self.cells and name in signs.REMAINDERS:
            self._add("remainder", "mod", stop)
        elif name in ("underbrace", "overbrace"):
            self._annotated_brace(stop)
        elif name in signs.SPACE_WITH_ARGUMENT:
            argument = _ARGUMENT.match(self.text, stop, self.end)
            self.place = argument.end() if argument else stop
        elif name in signs.REFUSED:
            raise ReadingError(self.place, *signs.REFUSED[name])
        elif name in ("begin", "end"):
            self._environment(stop)
        else:
            raise ReadingError(self.place, f"unknown command \\{name}", "write what it stands for")

    def _condition_word(self, match: re.Match[str]) -> None:
        """Go past "if" and "otherwise" among cases; other words are no condition that is read."""
        word = " ".join(match.group().strip(" {}~.,;").lower().split())
        if word in signs.DIVIDES or word in signs.IS_DIVISIBLE:
            self._add("bar", "|" if word in signs.DIVIDES else signs.MULTIPLE, match.end())
            return
        first, _, behind = word.partition(" ")
        bare = behind if first in signs.CONDITION_WORDS else word
        if bare in signs.EVEN or bare in signs.ODD:
            self._add("parity", "0" if bare in signs.EVEN else "1", match.end())
            return
        if word not in signs.CONDITION_WORDS:
            raise ReadingError(self.place, f"a condition in words: {word}", "write it as a relation")
        self.place = match.end()

    def _annotated_brace(self, stop: int) -> None:
        """\\underbrace{X}_{words} is X: the words will be skipped."""
        sign = "_" if self.text.startswith("\\under", self.place) else "^"
        after = matching_brace(self.text, stop, self.end, LONGEST_ANNOTATED)
        match = re.compile(rf"\s*\{sign}\s*(?=\{{)").match(self.text, after, self.end)
        if match:
            self.skips[after] = matching_brace(self.text, match.end(), self.end, LONGEST_ANNOTATED)
        self.place = stop

    def _environment(self, stop: int) -> None:
        cells = _CELLS.match(self.text, stop, self.end)
        if cells and cells.group(1) in signs.CELLS:
            self._cells(signs.CELLS[cells.group(1)], cells.end())
            return
        match = _ENVIRONMENT.match(self.text, stop, self.end)
        if not match or match.group(1) not in signs.ENVIRONMENTS:
            what = "an environment that is not read"
            raise ReadingError(self.place, what, "write each row as an equation")
        self.place = match.end()

    def _cells(self, bracket: str, stop: int) -> None:
        """Open or close a matrix or cases; within, & and \\\\ part cells and rows."""
        if self.text.startswith("\\begin", self.place):
            self.cells.append(bracket)
            self._add("open", bracket, stop)
        else:
            if self.cells:
                self.cells.pop()
            self._add("close", "[end]", stop)

    def _greek_sign(self, name: str) -> None:
        """Add a Greek letter that is no command: digits that touch it are its subscript, ω1 is ω_1."""
        digits = self._touching_digits(self.place + 1)
        stop = self.place + 1 + len(digits)
        is_decimal = re.match(r"[.,][0-9]", self.text[stop : stop + 2]) is not None
        if digits and name != "pi" and not is_decimal:
            self._letter(f"{name}_{digits}", stop)
        else:
            self._greek(name, self.place + 1)

    def _greek(self, name: str, stop: int) -> None:
        if name == "pi" and "pi" not in self.words.names:
            full_name, after = with_scripts(self.text, name, stop, self.end, self.words.names)
            self._add("name", full_name, after if full_name != name else stop)
        else:
            self._letter(name, stop)

    def _font(self, name: str, stop: int) -> None:
        """\\mathrm{Lh} is the run Lh, \\operatorname{sin} the function; the rest stays as it is."""
        match = _FONT_WORD.match(self.text, stop, self.end)
        euler = _EULER.match(self.text, stop, self.end) if name == "mathrm" else None
        if euler and "e" in self.words.names:
            self._letter("e", euler.end())
            self.tokens[-1] = replace(self.tokens[-1], upright=True)
        elif match and match.group(1) in signs.OWN_FUNCTIONS and match.group(1) not in self.words.names:
            self._add("function", signs.OWN_FUNCTIONS[match.group(1)], match.end())
        elif match and match.group(1) in FUNCTION_WORDS and match.group(1) not in self.words.names:
            self._add("function", FUNCTION_WORDS[match.group(1)], match.end())
        elif match and match.group(1)[0].isalpha() and self._is_one_letter(match.group(1)):
            self._letter(match.group(1), match.end())
        elif match and (name == "operatorname" or self._is_unknown_function(match)):
            raise ReadingError(
                self.place, f"unknown function {match.group(1)}", "write what it stands for"
            )
        else:
            self.place = stop

    def _is_unknown_function(self, word: re.Match[str]) -> bool:
        """Tell whether a word of no letters of the page stands before a bracket: \\mathrm{sgn}(x)."""
        letters, after = word.group(1), self.text[word.end() : min(word.end() + 6, self.end)]
        return (
            len(letters) > 2
            and letters.isalpha()
            and _ARGUMENT_BEHIND.match(after) is not None
            and not all(letter in self.words.names for letter in letters)
        )

    def _is_one_letter(self, word: str) -> bool:
        return len(word) == 1 or word in self.words.names or word[1:].isdecimal()

    # Units: behind a number they multiply it, behind a letter only those of factor 1 are clear

    def set_unit(self, command: str) -> bool:
        """Read \\mathrm{mm} behind a number; tell whether it was a unit."""
        if command.endswith("frac") and (self.is_behind_number() or self._is_behind_power()):
            unit_span = unit_fraction_at(self.text, self.place, self.end, self.words.names)
        else:
            unit_span = (
                unit_set_at(self.text, self.place, self.end) if command in _UNIT_COMMANDS else None
            )
        if unit_span is None:
            return False
        unit, stop = unit_span
        bare, scale = unit.strip("{} ~"), scale_of(unit)
        if len(bare) == 1 and self._is_factor_of_product(bare, stop):
            return False
        is_unit = command not in ("mathrm", *_WORD_FONTS) or self._may_be_unit(
            command, bare, scale is not None
        )
        if not is_unit:
            return False
        if scale is None:
            raise ReadingError(self.place, f"unit {bare} is not read", "leave it out of the formula")
        self.add_factor(bare, scale, stop)
        return True

    def _is_factor_of_product(self, letter: str, stop: int) -> bool:
        """Tell whether \\frac12\\mathrm{m}v^2 goes on after a declared letter: it is no unit there."""
        after = self.text[stop : min(stop + 8, self.end)].lstrip()
        goes_on = after[:1].isalnum() or after[:1] == "(" or after.startswith(("\\left", "\\frac"))
        is_apart = is_set_apart(self.text, self.place)
        return letter in self.words.names and goes_on and not is_apart

    def _may_be_unit(self, command: str, word: str, is_known_unit: bool) -> bool:
        """Tell whether upright letters are a unit: behind a number; behind a letter if set apart."""
        names = frozenset() if command in _WORD_FONTS else self.words.names
        is_apart = is_set_apart(self.text, self.place)
        if word in FUNCTION_WORDS or (word in names and (len(word) > 1 or not self.is_behind_number())):
            return False
        if self.is_behind_number():
            foreign = word.isalpha() and len(word) > 1 and word[0] != "d"
            return is_known_unit or (foreign and (is_apart or not all(sign in names for sign in word)))
        return (
            is_known_unit
            and bool(self.tokens)
            and (command in _WORD_FONTS or (is_apart and len(word) > 1))
        )

    def is_behind_number(self) -> bool:
        """Tell whether a number, π or a bracket stands before the place."""
        if not self.tokens:
            return False
        last, pi = self.tokens[-1], "pi" not in self.words.names
        is_exponent = last.kind == "number" and len(self.tokens) > 1 and self.tokens[-2].kind == "sup"
        if is_exponent and not (self._is_behind_power_of_ten() or is_set_apart(self.text, self.place)):
            return False
        return last.kind in ("number", "close", "vulgar") or (pi and last.value == "pi")

    def _is_behind_power_of_ten(self) -> bool:
        """Tell whether 10^4 stands before the place: no letter has such a factor, a number has."""
        tail = self.tokens[-3:]
        return [token.kind for token in tail] == ["number", "sup", "number"] and tail[0].value == "10"

    def add_factor(self, unit: str, scale: tuple[Fraction, bool], stop: int) -> None:
        """Multiply by a unit's factor; behind a letter only a unit of factor 1 is clear."""
        if not (self.is_behind_number() or self._is_behind_power()) and scale != (1, False):
            what = f"unit {unit} behind a letter"
            raise ReadingError(self.place, what, "leave it out of the formula")
        last = self.tokens[-1] if self.tokens else None
        before = self.tokens[-2] if len(self.tokens) > 1 else None
        is_apart = before is not None and (
            before.is_op("/") or before.kind == "sup" or before.value == "{"
        )
        if last is not None:
            is_quantity = last.kind == "number" and not scale[1] and not is_apart
            end = stop if scale == (1, False) else last.end
            self.tokens[-1] = replace(last, scale=scale[0] if is_quantity else Fraction(0), end=end)
        self.tokens += factor_tokens(scale, self.place, stop)
        self.place = stop

    def plain_unit(self, sign: str) -> bool:
        """Read ` mm` or `[mm]` behind a number; tell whether it was a unit."""
        number = bool(self.tokens) and self.tokens[-1].kind == "number"
        if sign != "[":
            unit_span = plain_unit_at(self.text, self.place, self.end, self.words.names)
            number = self.is_behind_number() or self._is_behind_power()
        else:
            unit_span = bracketed_unit_at(self.text, self.place, self.end)
            if unit_span and self._is_counted_in(*unit_span):
                self.tokens[-1] = replace(self.tokens[-1], end=unit_span[1])
                self.place = unit_span[1]
                return True
        scale = scale_of(unit_span[0]) if unit_span else None
        if not unit_span or not scale or not (number or self._is_last(unit_span[1])):
            return False
        self.add_factor(unit_span[0], scale, unit_span[1])
        return True

    def _is_counted_in(self, unit: str, stop: int) -> bool:
        """Tell whether a unit in brackets says in what its letter is counted: P[kW] = T[Nm] n[rpm]/9549.

        The formula is then one between numbers, and no unit multiplies anything. One letter in brackets,
        x[m], is a unit only beside another one that is told from letters.
        """
        if not self.tokens or self.tokens[-1].kind != "name":
            return False
        last = min(self.end, stop + _NEAR_UNIT)
        others = (self.text[max(0, self.place - _NEAR_UNIT) : self.place], self.text[stop:last])
        others = (others[0].rpartition("\n\n")[2], others[1].partition("\n\n")[0])
        beside = [match for part in others for match in _UNIT_OF_LETTER.finditer(part)]
        is_beside = any(scale_of(match[1]) is not None for match in beside)
        return is_beside and (len(unit) > 1 or any(len(match[1]) > 1 for match in beside))

    def _is_last(self, stop: int) -> bool:
        """Tell whether a side ends at a place."""
        after = self.text[stop : self.end].lstrip()
        return self.tokens != [] and (not after or signs.relation_at_start(after) != "")


def _without_braces(tokens: list[Token]) -> list[Token]:
    """{\\cos}^2 is \\cos^2, and {} a way to set a sign apart."""
    result: list[Token] = []
    for token in tokens:
        last = result[-1] if result else None
        argument = result[-2] if len(result) > 1 else None
        is_empty = token.kind == "close" and token.value == "}" and last is not None and last.value == "{"
        if is_empty and (argument is None or argument.kind in ("op", "rel", "number", "name", "close")):
            result.pop()
            continue
        result.append(token)
        kinds = [last.kind for last in result[-3:]]
        if kinds == ["open", "function", "close"] and token.value == "}":
            result[-3:] = [replace(result[-2], start=result[-3].start, end=token.end)]
    return result


def _with_three_dots(tokens: list[Token]) -> list[Token]:
    """\\cdot \\cdot \\cdot is three dots."""
    result: list[Token] = []
    place = 0
    while place < len(tokens):
        if all(t.is_op("*") for t in tokens[place : place + 3]) and len(tokens) >= place + 3:
            result.append(Token("dots", "…", tokens[place].start, tokens[place + 2].end))
            place += 3
        else:
            result.append(tokens[place])
            place += 1
    return result


def factor_tokens(scale: Scale, start: int, end: int) -> list[Token]:
    """Return a bracket that holds the factor, nothing where it is 1."""
    size, pi = scale
    if size == 1 and not pi:
        return []
    inside = [Token("number", str(size), start, end, size)]
    if pi:
        top = [Token("name", "pi", start, end)]
        if size.numerator != 1:
            top.insert(0, Token("number", str(size.numerator), start, end, Fraction(size.numerator)))
        below = Token("number", str(size.denominator), start, end, Fraction(size.denominator))
        inside = [*top, *([Token("op", "/", start, end), below] if size.denominator > 1 else [])]
    return [Token("open", "{", start, end), *inside, Token("close", "}", start, end)]


MOST_DIGITS = 400
"""Digits, and the largest power of ten: exact arithmetic with more of them would take over."""

_THOUSANDS = re.compile(r"[0-9]{1,3}(?:(?:\\,|\{,\}|\u2009|\u202f)[0-9]{3})+(?![0-9])(?:\.[0-9]+)?")
_BETWEEN = r"(?:[ ~\u00a0]|\\[ ;:])"
_SPACED_THOUSANDS = re.compile(
    rf"(?:[1-9][0-9]?(?:{_BETWEEN}[0-9]{{3}})+|[1-9][0-9]{{2}}{_BETWEEN}[0-9]{{3}}"
    rf"|[1-9][0-9]{{2}}(?:{_BETWEEN}[0-9]{{3}})+(?<=000))(?!{_BETWEEN}?[0-9])(?:\.[0-9]+)?"
)
"""A plain space between groups of three: 37 100, 500 000. 120 240 360 are three numbers of a list."""
_DECIMAL_COMMA = re.compile(r"[0-9]+\{,\}[0-9]+")
_PLAIN_NUMBER = re.compile(r"(?:[0-9]+(?:\.[0-9]+)?|\.[0-9]+)")
_EXPONENT = re.compile(r"[eE]([+-]?[0-9]+)(?![A-Za-z0-9])")
_GROUPING = re.compile(r"\\[,;: ]|\{,\}|[ ~\u00a0\u2009\u202f]")


def read_number(
    text: str, start: int, end: int, scientific: bool = True, spaced: bool = False
) -> Token | None:
    """Return the number that begins at `start`, or None; `spaced` if a space may part its thousands.

    >>> read_number("4.02", 0, 4).number, read_number("4.02", 0, 4).place
    (Fraction(201, 50), Fraction(1, 100))
    >>> read_number("1\\\\,024", 0, 6).number
    Fraction(1024, 1)
    """
    if match := _THOUSANDS.match(text, start, end) or (
        _SPACED_THOUSANDS.match(text, start, end) if spaced else None
    ):
        digits, exponent = _GROUPING.sub("", match.group()), None
    elif match := _DECIMAL_COMMA.match(text, start, end):
        digits, exponent = match.group().replace("{,}", "."), None
    elif match := _PLAIN_NUMBER.match(text, start, end):
        digits = match.group()
        exponent = _EXPONENT.match(text, match.end(), end) if scientific else None
    else:
        return None
    return _number_token(digits, exponent, start, match.end())


def _number_token(digits: str, exponent: re.Match[str] | None, start: int, stop: int) -> Token:
    if len(digits) > MOST_DIGITS:
        raise ReadingError(start, f"a number of more than {MOST_DIGITS} digits", "write fewer digits")
    value = Fraction(digits)
    decimals = len(digits.partition(".")[2])
    place = Fraction(1, 10**decimals) if decimals else None
    if exponent:
        scale = _power_of_ten(exponent, start)
        value, stop = value * scale, exponent.end()
        place = place * scale if place else None
    if value and not 1 / LARGEST <= value <= LARGEST:
        raise ReadingError(start, "a number that no float holds", "check its digits and its power of ten")
    return Token("number", digits, start, stop, value, place)


def _power_of_ten(exponent: re.Match[str], start: int) -> Fraction:
    digits = exponent.group(1)
    if len(digits) > 4 or abs(int(digits)) > MOST_DIGITS:
        raise ReadingError(start, "a power of ten out of all proportion", "check the exponent")
    return Fraction(10) ** int(digits)


class Vocabulary:
    """Finds the longest declared letter or function that begins at a place.

    >>> Vocabulary(frozenset({"L", "Lh"})).longest("Lh cos", 0, 6)
    ('name', 'Lh')
    >>> Vocabulary(frozenset()).longest("cosh x", 0, 6)
    ('function', 'cosh')
    """

    def __init__(self, names: frozenset[str]) -> None:
        self.names = names
        words = {name for name in names if name.isascii() and name[:1].isalpha()}
        words |= {name.split("_")[0].rstrip("'") for name in words}
        self._by_letter: dict[str, list[tuple[int, str, str]]] = {}
        functions = set(FUNCTION_WORDS) - names
        functions -= {"asin", "acos", "atan"} if "a" in names else set()
        for kind, group in (("name", words), ("function", functions), ("constant", {"pi"} - names)):
            for word in group:
                self._by_letter.setdefault(word[:1], []).append((-len(word), kind, word))
        for entries in self._by_letter.values():
            entries.sort()

    def longest(self, text: str, start: int, end: int) -> tuple[str, str] | None:
        """Return kind and word of the longest entry at `start`; a base counts where a script follows."""
        for _, kind, word in self._by_letter.get(text[start], ()):
            stop = start + len(word)
            if stop <= end and text.startswith(word, start) and self._fits(text, word, stop, end, kind):
                return kind, word
        return None

    def _fits(self, text: str, word: str, stop: int, end: int, kind: str) -> bool:
        after = text[stop] if stop < end else " "
        if kind != "name":
            return True
        if word[-1].isdigit() and after.isdigit():
            return False
        if "_" in word and after.isascii() and after.isalpha():
            rest = _RUN.match(text, stop, end)
            if rest is not None and not may_be_letters(rest.group(), self.names):
                return False
            if rest is not None and word.rpartition("_")[2] + rest.group() in EXTREMES:
                return False
        return word in self.names or (len(word) > 1 and (after in "_'′" or after in LOWERED))


@lru_cache(maxsize=256)
def _vocabulary(names: frozenset[str]) -> Vocabulary:
    return Vocabulary(names)


def vocabulary(names: Collection[str]) -> Vocabulary:
    """Return the vocabulary of some names; equal sets share one."""
    return _vocabulary(names if isinstance(names, frozenset) else frozenset(names))
