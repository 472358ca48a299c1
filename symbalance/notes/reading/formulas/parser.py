"""The recursive-descent parser of hand-written formulas: tokens to every tree they may mean.

The argument of a function without brackets is the product that follows: sin 2θ cos θ = sin(2θ)·cos θ,
cos n(θ + h) = cos(n(θ + h)). After a whole angle such as θ a bracket or fraction stands outside. A sum
sign sums as far as the next + or -. Where d is itself a declared letter, a derivative may be a quotient.

Where usage differs (`1/2λ`, `cos θ/2`) the parser asks `choose`, which follows a list of decisions;
`read_tokens` parses again with other decisions and returns every tree that comes out, the usual first.
"""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Collection, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import (
    Apply,
    Call,
    Constant,
    Derivative,
    Dots,
    Formula,
    Name,
    Negative,
    Number,
    PlusMinus,
    Power,
    Product,
    Quotient,
    Span,
    Sum,
    Summation,
    children,
    names,
    walk,
)
from symbalance.document.letters import ACCENTS, TIME_DOTS, is_greek, plain_letter
from symbalance.notes.reading.failures import ReadingError, UndeclaredError
from symbalance.notes.reading.formulas import constructs
from symbalance.notes.reading.formulas.free_letters import may_be_free, unclear
from symbalance.notes.reading.formulas.lexer import AT, CLOSER, Token
from symbalance.notes.reading.signs import CELLS, VULGAR

# A formula with n doubtful places has 2^n readings: the number kept and the number tried are limited.
MOST_READINGS = 8
_MOST_TRIALS = 24
# The parser and what works on trees later recurse: depth stays well below Python's own limit.
DEEPEST_BRACKETS = 60
DEEPEST_TREE = 100
MOST_SLASHES = 20
HIGHEST_DERIVATIVE = 20
_INDICES = ("i", "j", "k", "n", "N")
_OF_ANGLES = ("sin", "cos", "tan", "cot", "sec", "csc")
"""Functions whose values are numbers, and no angles as those of arcsin are."""
_INVERSE = {"sin": "asin", "cos": "acos", "tan": "atan"}
_WITH_BOUNDS = ("int", "oint", "prod", "lim", "max", "min", "det")
_TWO_FORMS = ("phi", "theta", "epsilon", "rho", "sigma", "kappa")
_STARTS = frozenset({"number", "name", "function", "vulgar"})


def read_tokens(
    tokens: Sequence[Token],
    names: Collection[str],
    end: int,
    latex: bool = False,
    free: set[str] | None = None,
) -> tuple[tuple[Formula, ...], tuple[str, ...]]:
    """Return the readings of one expression and the remarks on the usual one.

    `free` gathers letters that are not declared and are read as letters of their own; None refuses them.
    """
    first, readings, refusal = _parse(tokens, names, (), latex, end, free)
    waiting, trials, notes = deque(_other_decisions(first, ())), 0, first.notes
    while waiting and len(readings) < MOST_READINGS and trials < _MOST_TRIALS:
        decisions = waiting.popleft()
        trials += 1
        parser, trees, _ = _parse(tokens, names, decisions, latex, end, free)
        notes = notes if readings else parser.notes
        readings.extend(node for node in trees if node not in readings)
        if len(waiting) < _MOST_TRIALS:
            waiting.extend(_other_decisions(parser, decisions))
    if refusal and not readings:
        raise refusal
    return tuple(readings), tuple(notes)


def _parse(
    tokens: Sequence[Token],
    names: Collection[str],
    decisions: Sequence[int],
    latex: bool,
    end: int,
    free: set[str] | None,
) -> tuple[Parser, list[Formula], ReadingError | None]:
    """Return the tree that a list of decisions leads to, in a list that is empty on a refusal."""
    parser = Parser(tokens, names, decisions, latex, end)
    parser.takes_free_letters = free is not None
    parser.page_letters = frozenset(free or ())
    try:
        node = parser.contents()
        if parser.current is not None:
            raise parser.unexpected_token()
        if _is_too_deep(node):
            raise ReadingError(node.span[0], "a formula nested too deeply", "write it in parts")
        if (letter := unclear(node, parser.free_letters)) is not None:
            raise UndeclaredError(parser.free_letters[letter], letter)
    except ReadingError as refusal:
        return parser, [], refusal
    if free is not None:
        free.update(parser.free_letters)
    return parser, [node], None


def _other_decisions(parser: Parser, decisions: Sequence[int]) -> list[tuple[int, ...]]:
    """Return the lists of decisions that differ from the one followed at one later place."""
    options = [option for option, _ in parser.choices[: len(decisions) + _MOST_TRIALS]]
    result: list[tuple[int, ...]] = []
    for site in range(len(decisions), len(options)):
        others = range(1, parser.choices[site][1])
        result.extend((*options[:site], other) for other in others)
    return result


def _is_too_deep(node: Formula) -> bool:
    level = [node]
    for _ in range(DEEPEST_TREE):
        level = [part for parent in level for part in children(parent)]
        if not level:
            return False
    return True


class Parser:
    """Reads one formula from its tokens, each method one kind of part."""

    def __init__(
        self,
        tokens: Sequence[Token],
        names: Collection[str],
        decisions: Sequence[int],
        latex: bool,
        end: int,
    ) -> None:
        self.tokens, self.names, self.decisions = list(tokens), names, decisions
        self.latex, self.end = latex, end
        self.place = 0
        self.choices: list[tuple[int, int]] = []
        self.notes: list[str] = []
        self.bound: list[str] = []
        self.takes_free_letters = False
        self.free_letters: dict[str, int] = {}  # and where each is first
        self.page_letters: frozenset[str] = frozenset()  # not declared, and letters of lines above
        self.exponentials = 0
        self.open_bars = 0
        self._depth = 0

    def choose(self, options: int = 2) -> int:
        """Return the way to read what follows, among so many; 0 is the usual way."""
        site = len(self.choices)
        option = self.decisions[site] if site < len(self.decisions) else 0
        self.choices.append((option, options))
        return option

    def note(self, remark: str) -> None:
        """Keep a remark on something read generously, once."""
        if remark not in self.notes:
            self.notes.append(remark)

    @contextmanager
    def nested(self) -> Iterator[None]:
        """Go one level into brackets, scripts or arguments."""
        self._depth += 1
        if self._depth > DEEPEST_BRACKETS:
            raise ReadingError(
                self.offset, f"more than {DEEPEST_BRACKETS} levels of brackets", "write it in parts"
            )
        try:
            yield
        finally:
            self._depth -= 1

    @property
    def current(self) -> Token | None:
        """The token at the place, None at the end."""
        return self.tokens[self.place] if self.place < len(self.tokens) else None

    def peek(self, steps: int) -> Token | None:
        """Return the token so many steps on."""
        place = self.place + steps
        return self.tokens[place] if 0 <= place < len(self.tokens) else None

    @property
    def offset(self) -> int:
        """Where the token at the place begins, in the document."""
        return self.current.start if self.current else self.end

    def take(self) -> Token:
        """Return the token at the place and go past it."""
        token = self.current
        if token is None:
            raise ReadingError(self.end, "the formula ends too early", "complete it")
        self.place += 1
        return token

    def at(self, kind: str, *values: str) -> bool:
        """Tell whether the token at the place is of a kind, and one of the values if any are given."""
        token = self.current
        return token is not None and token.kind == kind and (not values or token.value in values)

    def is_tight(self, steps: int = 0) -> bool:
        """Tell whether no space stands before the token so many steps on."""
        before, token = self.peek(steps - 1), self.peek(steps)
        return before is not None and token is not None and before.end == token.start

    def expect_close(self, opener: Token) -> Token:
        """Go past the bracket that closes `opener`."""
        token = self.current
        if token is None:
            raise ReadingError(opener.start, f"bracket {opener.value} is never closed", "close it")
        if token.kind not in ("close", "bar") or token.value != CLOSER[opener.value]:
            raise self.unexpected_token()
        return self.take()

    def unexpected_token(self) -> ReadingError:
        """Return the refusal of the token at the place."""
        token = self.current
        if token is None:
            return ReadingError(self.end, "the formula ends too early", "complete it")
        if token.kind == "sep":
            return ReadingError(token.start, f"{token.value} within a formula", "write two equations")
        if token.kind == "rel":
            return ReadingError(token.start, "a relation within brackets", "write it as an equation")
        if token.kind == "close":
            return ReadingError(
                token.start, f"bracket {token.value} was never opened", "open it or remove it"
            )
        return ReadingError(
            token.start, f"{token_text(token)} is not expected here", "check what stands before it"
        )

    def span_since(self, place: int) -> Span:
        """Return the span from the token at `place` to the last one taken."""
        last = max(self.place - 1, 0)
        return (self.tokens[place].start, self.tokens[last].end) if self.tokens else (self.end, self.end)

    def letter(self, name: str, span: Span) -> Formula:
        """Return a letter's node: a declared or bound name, π, the imaginary i, j in an exponential."""
        is_imaginary = self._is_imaginary_beside_index(name)
        if name in self.names or (name in self.bound and not is_imaginary):
            return Name(name, span=span)
        if (other := other_form(name)) in self.names:
            self.note(f"{plain_letter(name)} read as {plain_letter(other)}, which is declared")
            return Name(other, span=span)
        if (run_on := _with_subscript(name)) in self.names:
            self.note(f"{plain_letter(name)} read as {plain_letter(run_on)}")
            return Name(run_on, span=span)
        if name == "pi":
            return Constant("pi", span=span)
        is_own = name == "i" and name in self.page_letters
        if not is_own and (name == "i" or (name == "j" and self.exponentials)):
            return Constant("i", span=span)
        if self.takes_free_letters and may_be_free(
            name, self.tokens, span[0], self.place, self.page_letters
        ):
            self.free_letters.setdefault(name, span[0])
            return Name(name, span=span)
        raise UndeclaredError(span[0], name)

    def _is_imaginary_beside_index(self, name: str) -> bool:
        """Tell whether the i of Σ e^{i δ_i} is the imaginary one, as the index stands below a letter."""
        if name not in ("i", "j") or not self.exponentials or name in self.names:
            return False
        return any(t.kind == "name" and t.value.endswith(f"_{name}") for t in self.tokens)

    # Sums, products and slashes

    def expression(self) -> Formula:
        """Read a sum; three dots are a term, with or without a sign before them."""
        first = self.place
        terms = [self._first_term()]
        while (token := self.current) is not None:
            if token.kind == "dots":
                self._refuse_dots_of_product(terms[-1])
                terms.append(self._dots())
            elif token.is_op("+-±∓"):
                terms.append(self._signed_term())
            elif isinstance(terms[-1], Dots) and self.starts_factor():
                terms.append(self.product())
            else:
                break
        return terms[0] if len(terms) == 1 else Sum(tuple(terms), span=self.span_since(first))

    def _refuse_dots_of_product(self, before: Formula) -> None:
        """Refuse 1·2⋯5 and 2·4⋯2n: dots between factors, which no sign sets apart from them."""
        behind = self.peek(1)
        is_followed = behind is not None and (behind.kind in ("number", "name") or behind.value == "(")
        signs = [token for token in self.tokens[: self.place] if token.is_op("*")]
        if is_followed and isinstance(before, Product) and signs:
            raise ReadingError(self.offset, "dots within a product are not read", "write the factors")

    def _first_term(self) -> Formula:
        if self.at("dots"):
            return self._dots()
        if self.current is not None and self.current.is_op("+-±∓"):
            return self._signed_term()
        return self._big_o() or self.product()

    def _dots(self) -> Formula:
        token = self.take()
        return Dots(span=(token.start, token.end))

    def _signed_term(self) -> Formula:
        first = self.place
        if self.current is not None and self.current.is_op("±∓"):
            upper = 1 if self.take().value == "±" else -1
            if self.at("dots"):  # 1 - x + x² ∓ …
                return self._dots()
            return PlusMinus(self.product(), upper, span=self.span_since(first))
        minus = self._sign_run()
        term = self._dots() if self.at("dots") else self._big_o() or self.product()
        if isinstance(term, Dots):
            return term
        for _ in range(minus):
            term = Negative(term, span=self.span_since(first))
        return term

    def _big_o(self) -> Dots | None:
        """Read O(x^7) at the end of a sum: what is left out."""
        following = self.peek(1)
        if not self.at("name", "O") or "O" in self.names or not following or following.value != "(":
            return None
        depth, steps, has_letter = 1, 2, False
        while depth and (token := self.peek(steps)):
            depth += {"open": 1, "close": -1}.get(token.kind, 0)
            has_letter = has_letter or (token.kind == "name" and token.value != "pi")
            steps += 1
        if not has_letter:
            remedy = "name the small letter, as in O(λ^2)"
            raise ReadingError(self.offset, "an order O( ) without a small letter", remedy)
        after = self.peek(steps)
        if depth or not (after is None or after.kind == "close"):
            return None
        first = self.place
        self.place += 1
        opener = self.take()
        order = self.expression()
        self.expect_close(opener)
        return Dots(order, span=self.span_since(first))

    def _sign_run(self) -> int:
        """Take signs and return how many are minus."""
        signs = [self.take()]
        while self.current is not None and self.current.is_op("+-"):
            signs.append(self.take())
        if len(signs) > 3:
            raise ReadingError(signs[0].start, "more than three signs in a row", "write one")
        if [sign.value for sign in signs] == ["+", "+"]:
            self.note("+ + read as +")
        if self.current is None:
            raise ReadingError(signs[-1].start, f"nothing stands after {signs[-1].value}", "complete it")
        return sum(sign.value == "-" for sign in signs)

    def product(self) -> Formula:
        """Read runs of factors joined by · or ×; a bar behind them is taken at a place, |_{x=0}."""
        first = self.place
        factors: list[Formula] = []
        self._join(factors, self.run_of_factors())
        while (token := self.current) is not None and token.is_op("*"):
            self.take()
            if self.at("dots"):
                raise ReadingError(self.offset, "dots within a product are not read", "write the factors")
            self._join(factors, self._signed_run(token))
        node = product_of(factors)
        while self._is_bar_with_place():
            self.take()
            node = constructs.read_bar(self, node, first)
        return node

    def _is_bar_with_place(self) -> bool:
        """Tell whether f|_ stands here and the bar closes no bracket."""
        following = self.peek(1)
        return (
            self.at("bar") and not self.open_bars and following is not None and following.kind == "under"
        )

    def _join(self, factors: list[Formula], run: Formula) -> None:
        is_bracketed = self.tokens[self.place - 1].kind == "close" and run.span[1] == self._last_end()
        whole = isinstance(run, Product) and not (is_bracketed and self._opens(run))
        if whole and isinstance(run, Product) and not self._is_degrees(run):
            factors.extend(run.factors)
        else:
            factors.append(run)

    def _opens(self, run: Product) -> bool:
        return run.span[0] != run.factors[0].span[0]

    def _last_end(self) -> int:
        return self.tokens[self.place - 1].end

    def _is_degrees(self, run: Product) -> bool:
        last = run.factors[-1]
        return isinstance(last, Quotient) and last.numerator.span == last.denominator.span

    def _signed_run(self, operator: Token) -> Formula:
        if self.current is None:
            raise ReadingError(
                operator.start, "nothing stands after the multiplication sign", "complete it"
            )
        if not self.current.is_op("+-"):
            return self.run_of_factors()
        first, sign = self.place, self.take()
        run = self.run_of_factors()
        return Negative(run, span=self.span_since(first)) if sign.value == "-" else run

    def run_of_factors(self) -> Formula:
        """Read factors side by side; a slash divides all of the run before it by one factor."""
        if not self.starts_factor():
            raise self.unexpected_token()
        factors: list[Formula] = [self.factor()]
        slashes = 0
        while self.current is not None:
            if self.current.is_op("/"):
                slashes += 1
                if slashes > MOST_SLASHES:
                    raise ReadingError(self.offset, "too many slashes", "write brackets")
                top = product_of(factors)
                bottom = self._denominator()
                factors = [Quotient(top, bottom, span=(top.span[0], bottom.span[1]))]
            elif self.starts_factor():
                self._refuse_two_numbers(factors[-1])
                if self._is_lowered_behind_bracket() and self.choose() == 1:
                    power = self.number(self.take())
                    factors[-1] = Power(factors[-1], power, span=(factors[-1].span[0], power.span[1]))
                else:
                    factors.append(self.factor())
            else:
                break
        return product_of(factors)

    def _is_lowered_behind_bracket(self) -> bool:
        """Tell whether the 2 of `(cos θ)2` touches its bracket: a power that a scan may have let down."""
        before = self.peek(-1)
        is_behind = before is not None and before.kind == "close" and before.value == ")"
        return is_behind and self.at("number", "2", "3") and self.is_tight() and not self.latex

    def _refuse_two_numbers(self, last: Formula) -> None:
        if (
            self.at("number")
            and isinstance(last, Number)
            and self.tokens[self.place - 1].kind == "number"
        ):
            raise ReadingError(self.offset, "two numbers side by side", "write · between them")

    def _denominator(self) -> Formula:
        """Read what follows a slash: one factor, or digits with the letters that touch them (1/2λ).

        A ÷ divides by all factors behind it; so may a slash between typed spaces, v² / 2 g.
        """
        slash, first = self.take(), self.place
        is_wide = slash.divides_all or not (self.latex or self.is_tight())
        if self.current is None:
            raise ReadingError(slash.start, "nothing stands after the slash", "complete it")
        if self.current.is_op("+-"):
            sign = self.take()
            bottom = self.factor()
            return Negative(bottom, span=self.span_since(first)) if sign.value == "-" else bottom
        if not self.starts_factor():
            raise self.unexpected_token()
        digits = self.at("number")
        factors = [self.factor()]
        if self.place != first + 1 and isinstance(factors[0], Number):
            return factors[0]
        if is_wide and self.starts_factor() and not self.at("number"):
            return self._denominator_to_end(factors, slash)
        touching = self.is_tight() and (self.at("name") or (digits and self.at("open", "(", "[")))
        if not touching:
            return factors[0]
        usual_inside = digits and self.at("name")
        inside = usual_inside if self.choose() == 0 else not usual_inside
        while inside and self.is_tight() and (self.at("name") or (len(factors) == 1 and self.at("open"))):
            factors.append(self.factor())
        return product_of(factors)

    def _denominator_to_end(self, factors: list[Formula], slash: Token) -> Formula:
        """Read the factors side by side behind ÷ as below it, behind a slash as below or beside it."""
        if not slash.divides_all and self.choose() == 0:
            return factors[0]
        while self.starts_factor() and not self.at("number"):
            factors.append(self.factor())
        return product_of(factors)

    # Single factors: numbers, letters, brackets, fractions, roots, accents, and their powers

    def starts_factor(self) -> bool:
        """Tell whether a factor begins at the place."""
        token = self.current
        if token is None:
            return False
        if token.kind == "cmd":
            return token.value not in ("over", "top")
        if token.kind == "bar":
            return not self.open_bars and not self._is_bar_with_place()
        return token.kind in _STARTS or (token.kind == "open" and token.value != AT)

    def factor(self) -> Formula:
        """Read an atom with what is attached to it: powers, degrees."""
        first = self.place
        node = self.atom()
        powers = 0
        while self.current is not None:
            if self.at("degree"):
                self.take()
                node = _degrees(node, self.span_since(first))
            elif (
                self.at("sup") and (marked := constructs.read_raised_mark(self, node, first)) is not None
            ):
                node = marked
            elif self.at("open", AT):
                opener = self.take()
                inside = self.expression()
                self.expect_close(opener)
                node = Apply("at", (node, inside), span=self.span_since(first))
            elif self.at("postfix"):
                self.take()
                node = Apply("factorial", (node,), span=self.span_since(first))
            elif self.at("under") and self.tokens[self.place - 1].value == "]":
                node = constructs.read_bar(self, node, first)
            elif self.at("sup"):
                powers += 1
                if powers > 1:
                    raise ReadingError(
                        self.offset, "two exponents on one base", "put the base in brackets"
                    )
                self.take()
                node = Power(node, self.exponent(), span=self.span_since(first))
            elif self.at("under") or self.at("sub"):
                raise ReadingError(
                    self.offset, "a subscript that is not a letter's", "write the letter itself"
                )
            else:
                break
        return node

    def atom(self) -> Formula:
        """Read one number, letter, bracket or command."""
        token = self.current
        if token is None:
            raise self.unexpected_token()
        if token.kind == "number":
            return self.number(self.take())
        if token.kind == "vulgar":
            return self._vulgar(self.take())
        if token.kind == "name":
            return self._name(token)
        if token.kind == "function":
            return self.call()
        if token.kind == "cmd":
            return self._command(token)
        return self._bracket()

    def _vulgar(self, token: Token) -> Formula:
        span = (token.start, token.end)
        top, bottom = (Number(Fraction(n), span=span) for n in VULGAR[token.value])
        return Quotient(top, bottom, span=span)

    def _bracket(self) -> Formula:
        if self.at("open"):
            return self.group()
        if self.at("bar"):
            self.open_bars += 1
            opener = self.take()
            with self.nested():
                inside = self.contents()
            if not (self.at("bar") or self.at("close", "|")):
                raise ReadingError(opener.start, "bracket | is never closed", "close it")
            last = self.take()
            self.open_bars -= 1
            return Call("abs", inside, span=(opener.start, last.end))
        raise self.unexpected_token()

    def _name(self, token: Token) -> Formula:
        if (derivative := self.derivative_in_line()) is not None:
            return derivative
        following = self.peek(1)
        if self._is_euler(token) and following and following.kind == "sup":
            return self._exponential()
        self.take()
        indexed = None if token.value in self.names else constructs.read_indexed(self, token)
        if indexed is not None:
            return indexed
        is_difference = token.value in ("Delta", "delta") and token.value not in self.names
        if is_difference and self.at("cmd", *ACCENTS):
            return self._accented_difference(token)
        letter = self.letter(token.value, (token.start, token.end))
        return self._with_place(letter, token) if isinstance(letter, Name) else letter

    def _with_place(self, letter: Name, token: Token) -> Formula:
        """Read what stands in brackets behind a letter as its place: x(π), f(x) of an unknown f."""
        if not (letter.name in self.free_letters and self._is_call()):
            return constructs.read_place(self, letter, self.place - 1) or letter
        opener = self.take()
        inside = self.expression()
        self.expect_close(opener)
        return Apply("at", (letter, inside), span=(token.start, self._last_end()))

    def _is_call(self) -> bool:
        """Tell whether f(x) or f(0) stands here, one letter or number in brackets: f is a function."""
        inside, closer = self.peek(1), self.peek(2)
        return (
            self.at("open", "(")
            and self.is_tight()
            and inside is not None
            and inside.kind in ("name", "number")
            and closer is not None
            and closer.kind == "close"
        )

    def _is_euler(self, token: Token) -> bool:
        """Tell whether a token is the number e: e is no letter here, or is upright before e^{i φ}."""
        is_letter = "e" in self.names or "e" in self.page_letters
        return token.value == "e" and (not is_letter or token.upright)

    def _exponential(self) -> Formula:
        first = self.place
        self.place += 2
        self.exponentials += 1
        power = self.exponent()
        self.exponentials -= 1
        return Call("exp", power, span=self.span_since(first))

    def _command(self, token: Token) -> Formula:
        readers = {
            "frac": self._fraction,
            "sqrt": self._root,
            **dict.fromkeys(("surd", "surd3", "surd4"), self._root),
            "sum": self.summation,
            "infty": self._infinity,
            "boxed": self._box,
        }
        bounded = {
            "int": constructs.read_integral, "oint": constructs.read_integral,
            "prod": constructs.read_product_sign, "lim": constructs.read_limit,
            "max": constructs.read_extremum, "min": constructs.read_extremum,
            "binom": constructs.read_binomial, "det": constructs.read_determinant,
        }  # fmt: skip
        if token.value in bounded:
            return bounded[token.value](self)
        readers |= dict.fromkeys(TIME_DOTS, self._time_derivative) | dict.fromkeys(ACCENTS, self._accent)
        return readers.get(token.value, self._operator)()

    def _operator(self) -> Formula:
        if (derivative := self.derivative_in_line()) is not None:
            return derivative
        raise self.unexpected_token()

    def _infinity(self) -> Formula:
        token = self.take()
        return Constant("infinity", span=(token.start, token.end))

    def _box(self) -> Formula:
        self.take()
        if not self.at("open"):
            raise self.unexpected_token()
        return self.group()

    def _fraction(self) -> Formula:
        if (derivative := self.derivative_fraction()) is not None:
            return derivative
        first = self.place
        self.take()
        top = self.argument()
        bottom = self.argument()
        return Quotient(top, bottom, span=self.span_since(first))

    def _root(self) -> Formula:
        first = self.place
        degree = self.take().value.removeprefix("surd")
        if degree.isdecimal():
            return self._indexed_root(
                Number(Fraction(degree)), self.argument(True), self.span_since(first)
            )
        if self.at("open", "[") and self.tokens[first].value == "sqrt" and self._has_index():
            index = self.group()
            return self._indexed_root(index, self.argument(True), self.span_since(first))
        if self.at("open", "(") and self.tokens[first].value == "sqrt":
            self.note("\\sqrt( ) read as the root of the bracket")
        return Call("sqrt", self.argument(True), span=self.span_since(first))

    def _has_index(self) -> bool:
        """Tell whether [n] is followed by something to take the root of."""
        steps = 1
        while (token := self.peek(steps)) and token.kind != "close":
            steps += 1
        after = self.peek(steps + 1)
        return after is not None and (after.kind in _STARTS or after.kind in ("open", "cmd"))

    def _indexed_root(self, index: Formula, inside: Formula, span: Span) -> Formula:
        span = (span[0], inside.span[1])
        if index == Number(Fraction(2)):
            return Call("sqrt", inside, span=span)
        return Power(
            inside, Quotient(Number(Fraction(1), span=index.span), index, span=index.span), span=span
        )

    def _time_derivative(self) -> Formula:
        first = self.place
        order = TIME_DOTS[self.take().value]
        name = self._bare_name()
        span = self.span_since(first)
        dotted = f"{self.tokens[first].value}_{name}"
        is_own_letter = dotted in self.names and name not in self.names
        if is_extreme(name) or is_own_letter:
            return self.letter(dotted, span)
        node = Derivative(self.letter(name, span), Name("t", span=span), order, span=span)
        return constructs.read_place_of_derivative(self, node, first)

    def _accent(self) -> Formula:
        if self.at("cmd", "overline", "bar") and (over := constructs.read_conjugate(self)) is not None:
            return over
        first = self.place
        accent = ACCENTS[self.take().value]
        bare = self._bare_name()
        name = f"{accent}_{bare}"
        if accent == "vec" and name not in self.names and bare in self.names:
            name = bare
            self.note(f"vector {bare} read as {bare}")
        letter = self.letter(name, self.span_since(first))
        place = constructs.read_place(self, letter, first) if isinstance(letter, Name) else None
        return place or letter

    def _without_vector(self, name: str) -> str:
        """Return the letter under an arrow where only that is declared."""
        bare = name.removeprefix("vec_")
        return bare if name not in self.names and bare in self.names else name

    def _accented_difference(self, token: Token) -> Formula:
        """Read \\Delta \\tilde{K}, one letter as ΔK is."""
        accent = ACCENTS[self.take().value]
        name = f"{token.value}_{accent}_{self._bare_name()}"
        return self.letter(name, (token.start, self.tokens[self.place - 1].end))

    def _bare_name(self) -> str:
        """Read the letter under an accent and the subscript that follows the accent."""
        token = self.take()
        is_braced = token.kind == "open" and token.value == "{"
        inner = self.take() if is_braced else token
        if inner.is_cmd(*ACCENTS):  # \\dot{\\vec r}
            name = f"{ACCENTS[inner.value]}_{self._bare_name()}"
            if is_braced and not self.at("close", "}"):
                raise ReadingError(
                    inner.start, "an accent over more than one letter", "write one letter under it"
                )
            self.place += is_braced
            return self._without_vector(name)
        if inner.kind != "name" or (is_braced and not self.at("close", "}")):
            raise ReadingError(
                inner.start, "an accent over more than one letter", "write one letter under it"
            )
        if is_braced:
            self.take()
        scripts = self.take().value if self.at("sub") else ""
        return f"{inner.value}_{scripts}" if scripts else inner.value

    # Functions, and how far their argument goes when no bracket says so

    def call(self) -> Formula:
        """Read sin x, sin^2 x, sin^{-1} x, sqrt(x), exp(x)."""
        first = self.place
        function = self.take()
        power = self._function_power(function.value) or self._lowered_power(function)
        name = function.value
        if self.at("under"):
            if name not in ("log", "lg") or not self._is_of_ten():
                raise ReadingError(self.offset, "a logarithm's base is not read", "write log x / log b")
            name = "lg"
        self.exponentials += function.value == "exp"
        argument = self.call_argument(function.value)
        self.exponentials -= function.value == "exp"
        if name == "log" and self.choose() == 1:
            name = "lg"  # an engineer's log 100 = 2
        if power is not None and _is_minus_one(power):
            name, power = self._inverse(name), None
        node = Call(name, argument, span=self.span_since(first))
        return node if power is None else Power(node, power, span=node.span)

    def _is_of_ten(self) -> bool:
        """Go past the base of log_{10}, if it is ten."""
        braced = (following := self.peek(1)) is not None and following.value == "{"
        base, closer = self.peek(1 + braced), self.peek(3)
        if base is None or base.number != 10 or (braced and (closer is None or closer.value != "}")):
            return False
        self.place += 4 if braced else 2
        return True

    def _function_power(self, function: str) -> Formula | None:
        if not self.at("sup"):
            return None
        if function in ("sqrt", "exp", "abs"):
            raise ReadingError(self.offset, f"an exponent on {function}", "put the whole in brackets")
        self.take()
        if self.current is not None and self._is_power_and_multiple(self.current):
            self.split_digit(self.current)
        return self.exponent()

    def _lowered_power(self, function: Token) -> Formula | None:
        """Read the 2 of `cos2 θ` as a power that a scan may have let down, as the second reading."""
        following = self.peek(1)
        is_apart = following is not None and following.kind == "name" and not self.is_tight(1)
        is_lowered = self.at("number", "2", "3") and self.is_tight() and is_apart and not self.latex
        if not is_lowered or function.value in ("sqrt", "exp", "abs") or self.choose() == 0:
            return None
        return self.number(self.take())

    def _is_power_and_multiple(self, token: Token) -> bool:
        """Tell sin^22θ, which is sin²(2θ), from sin^10θ and sin^22 θ."""
        following = self.peek(1)
        touches_letter = following is not None and following.kind == "name" and self.is_tight(1)
        digits = token.kind == "number" and token.value.isdecimal() and len(token.value) > 1
        return digits and touches_letter and token.value[0] in "23456789" and token.value[1] != "0"

    def _inverse(self, function: str) -> str:
        if function not in _INVERSE:
            what = f"the inverse of {function} is not read"
            raise ReadingError(self.offset, what, "write it with asin, acos or atan")
        return _INVERSE[function]

    def call_argument(self, function: str) -> Formula:
        """Read the argument: the bracket that follows at once, else the product that follows."""
        with self.nested():
            if self.at("open") or (self.at("bar") and not self.open_bars):
                return self._bracket()
            if function in ("sqrt", "abs"):
                return self.argument(whole_number=True)
            if self.current and self.current.is_op("+-"):
                first, sign = self.place, self.take()
                inside = self._open_argument()
                return Negative(inside, span=self.span_since(first)) if sign.value == "-" else inside
            return self._open_argument()

    def _open_argument(self) -> Formula:
        if self.at("function"):
            return self.call()
        if not self.starts_factor():
            raise ReadingError(self.offset, "a function without an argument", "write its argument")
        factors = [self.factor()]
        while self._belongs_to_argument(factors):
            factors.append(self.factor())
        inside = product_of(factors)
        if self._tight_slash() and self.choose() == 1:
            self.take()
            bottom = self.factor()
            return Quotient(inside, bottom, span=(inside.span[0], bottom.span[1]))
        return inside

    def _tight_slash(self) -> bool:
        return (
            self.current is not None and self.current.is_op("/") and self.is_tight() and self.is_tight(1)
        )

    def _belongs_to_argument(self, factors: list[Formula]) -> bool:
        """Tell whether the factor at the place belongs to the argument too."""
        token = self.current
        if token is None or not self.starts_factor() or self._ends_argument(token):
            return False
        whole = any(map(_is_whole_angle, factors))
        if whole and (self._leaves_angle(token) or self._may_leave_angle(token, factors)):
            return not self._leaves_angle(token) and self.choose() == 1
        if not (
            token.kind in ("open", "vulgar", "bar")
            or token.is_cmd("frac", "sqrt", "surd", "surd3", "surd4")
        ):
            return True
        if token.kind == "open" and not whole:
            return self._goes_on_in_bracket(factors)
        if token.kind == "open" and not any(map(names, factors)):
            return False  # cos 45° [...]: an angle in numbers is complete
        return whole == bool(self.choose())

    def _goes_on_in_bracket(self, factors: list[Formula]) -> bool:
        """Tell whether a bracket behind letters is of the argument: cos n(θ + α), not sin t (1 + q).

        A function within says that it is a factor of its own: sin t(1 + q cos t). Behind a space it is
        one too, unless it holds an angle or the time.
        """
        last, inside = factors[-1], self._tokens_in_bracket()
        is_number = not any(map(names, factors))
        has_angle_before = any(name not in _INDICES for factor in factors for name in names(factor))
        is_bare = not self.at("open", "{") and (has_angle_before or is_number)
        if is_bare and any(token.kind == "function" and token.value in _OF_ANGLES for token in inside):
            return False  # cos V/2 [cos(θ - V/2) + …], cos45 [cos(t - 45) + …]
        if self.at("open", "{") or not isinstance(last, Name) or last.name in _INDICES:
            return True
        if any(token.kind == "function" for token in inside):
            return False
        letters = [token for token in inside if token.kind == "name"]
        has_angle = any(is_greek(token.value) or _is_time(token) for token in letters)
        if self.is_tight() or (has_angle and not _is_angle_of_time(last)):
            return True
        return bool(self.choose())

    def _tokens_in_bracket(self) -> list[Token]:
        """Return the tokens between the bracket at the place and the one that closes it."""
        depth = 0
        for stop in range(self.place, len(self.tokens)):
            depth += {"open": 1, "close": -1}.get(self.tokens[stop].kind, 0)
            if not depth:
                return list(self.tokens[self.place + 1 : stop])
        return []

    def _leaves_angle(self, token: Token) -> bool:
        """Tell whether a factor after a whole angle is outside: \\cos\\phi\\,r, \\cos\\phi\\dot\\phi."""
        if _is_time(token):
            return False
        degrees = self.tokens[self.place - 1].kind == "degree"
        latin = _is_latin(token) and (degrees or not (self.latex or self.is_tight()))
        return token.spaced or latin or token.is_cmd(*TIME_DOTS)

    def _may_leave_angle(self, token: Token, factors: list[Formula]) -> bool:
        """Tell whether a Latin letter follows a Greek angle, \\cos\\theta r: usually it is outside."""
        greek = any(is_greek(name) for factor in factors for name in names(factor))
        return greek and _is_latin(token) and not _is_time(token)

    def _ends_argument(self, token: Token) -> bool:
        """Tell whether a factor can never belong to an argument already begun."""
        power_of_e = token.kind == "name" and self._is_euler(token)
        return token.kind in ("function", "number") or token.is_cmd("sum", *_WITH_BOUNDS) or power_of_e

    # Derivatives: with a bar, in line, and as the operator d/dθ before a bracket

    def derivative_fraction(self) -> Formula | None:
        """Read \\frac{d^n f}{d x^n} if the fraction at the place is one."""
        top, bottom = self._fraction_parts()
        if not (_is_d(top) and _is_d(bottom)) or ("d" in self.names and self.choose() == 1):
            return None
        first = self.place
        self.place += 2
        order, body = self._top_of_derivative("{")
        if not self.at("close", "}"):
            raise self.unexpected_token()
        self.place += 2
        variable = self._bottom_of_derivative(order)
        if not self.at("close", "}"):
            raise self.unexpected_token()
        self.take()
        return self._derivative_of(first, order, body, variable)

    def _fraction_parts(self) -> tuple[Token | None, Token | None]:
        """Return the first tokens within the two braces of \\frac{…}{…}."""
        if not (opener := self.peek(1)) or opener.kind != "open":
            return None, None
        depth, steps = 1, 2
        while depth and (token := self.peek(steps)):
            depth += {"open": 1, "close": -1}.get(token.kind, 0)
            steps += 1
        after = self.peek(steps)
        is_braced = after is not None and after.kind == "open" and after.value == "{"
        variable = self.peek(steps + 2)
        has_letter = is_braced and variable is not None and variable.kind in ("name", "cmd")
        return self.peek(2), self.peek(steps + 1) if has_letter else None

    def derivative_in_line(self) -> Formula | None:
        """Read dx/dt, d^2x/dt^2 or d/dt if it begins at the place, without spaces."""
        if (
            not _is_d(self.current)
            or not self._is_derivative_in_line()
            or ("d" in self.names and self.choose() == 1)
        ):
            return None
        first = self.place
        order, body = self._top_of_derivative("/")
        self.take()
        variable = self._bottom_of_derivative(order)
        return self._derivative_of(first, order, body, variable)

    def _is_derivative_in_line(self) -> bool:
        """Tell whether the tokens are d [^n] [letter] / d letter, tight."""
        steps = 1
        if (token := self.peek(steps)) and token.kind == "sup":
            steps += self._power_length(steps)
        if (token := self.peek(steps)) and token.kind == "name":
            steps += 1
        slash = self.peek(steps)
        letter = self.peek(steps + 2)
        if slash is None or not (slash.is_op("/") or slash.is_cmd("over")):
            return False
        has_letter = _is_d(self.peek(steps + 1)) and letter is not None and letter.kind == "name"
        return has_letter and (slash.is_cmd("over") or self._all_tight(steps + 2))

    def _all_tight(self, steps: int) -> bool:
        return all(self.is_tight(step) for step in range(1, steps + 1))

    def _power_length(self, steps: int) -> int:
        following = self.peek(steps + 1)
        return 4 if following is not None and following.kind == "open" else 2

    def _top_of_derivative(self, stop: str) -> tuple[int, Formula | None]:
        """Read d^n f; f may be missing."""
        self.take()
        order = self._derivative_order()
        is_at_end = (
            self.at("close", "}")
            if stop == "{"
            else bool(self.current and (self.current.is_op("/") or self.current.is_cmd("over")))
        )
        if is_at_end:
            return order, None
        if stop == "/":
            token = self.take()
            return order, self.letter(token.value, (token.start, token.end))
        return order, self.product()

    def _derivative_order(self) -> int:
        if not self.at("sup"):
            return 1
        self.take()
        place = self.offset
        power = self.exponent()
        value = getattr(power, "value", None)
        if value is None or value.denominator != 1 or not 1 <= value <= HIGHEST_DERIVATIVE:
            raise ReadingError(place, "a derivative of an order that is not read", "write a whole number")
        return int(value)

    def _bottom_of_derivative(self, order: int) -> Name:
        """Read d x^n, with the same n."""
        self.take()
        variable = self._variable_below()
        place = self.offset
        if self._derivative_order() != order:
            raise ReadingError(place, "two different orders in one derivative", "make them equal")
        return variable

    def _variable_below(self) -> Name:
        """Read the letter under the bar; time needs no declaration."""
        token = self.current
        if token is not None and token.kind == "name":
            self.take()
            span = (token.start, token.end)
            letter = Name("t", span=span) if token.value == "t" else self.letter(token.value, span)
            if isinstance(letter, Name):
                return letter
            self.place -= 1
        place = self.offset
        variable = self.atom()
        if not isinstance(variable, Name):
            raise ReadingError(place, "a derivative by something that is no letter", "name the variable")
        return variable

    def _derivative_of(self, first: int, order: int, body: Formula | None, variable: Name) -> Formula:
        if body is None:
            with self.nested():
                bracket = self.at("open", "(", "[", "{", "\\{")
                body = self.group() if bracket else self.run_of_factors()
            return Derivative(body, variable, order, span=self.span_since(first))
        node = Derivative(body, variable, order, span=self.span_since(first))
        return constructs.read_place_of_derivative(self, node, first)

    # Sum signs, with and without bounds

    def summation(self) -> Formula:
        """Read \\sum_{k=0}^{N-1} body."""
        first = self.place
        self.take()
        below = constructs.read_range_below(self) or constructs.read_start_below(self)
        index, lower, upper = below or (None, None, None)
        if index is None and self.at("under"):
            index, lower = self.lower_bound()
        if self.at("sup") and upper is None:
            upper = self.upper_bound()
        if index is None and self.at("under"):
            index, lower = self.lower_bound()
        if upper is not None and lower is None:
            raise ReadingError(self.offset, "a sum with an end but no beginning", "write \\sum_{k=0}^{n}")
        self.bound.append(index.name if index else "")
        with self.nested():
            body = self.product()
        self.bound.pop()
        return Summation(body, index, lower, upper, span=self.span_since(first))

    def lower_bound(self) -> tuple[Name, Formula | None]:
        """Read _{k=0} or _k: the index, and where it begins."""
        self.take()
        is_braced = self.at("open", "{")
        opener = self.take() if is_braced else None
        token = self.take()
        if token.kind != "name":
            raise ReadingError(token.start, "a sum without an index", "write \\sum_{k=0}^{n}")
        index = Name(token.value, span=(token.start, token.end))
        lower = None
        if opener is not None:
            if self.at("rel", "="):
                self.take()
                lower = self.expression()
            self.expect_close(opener)
        return index, lower

    def upper_bound(self) -> Formula:
        """Read ^n: where a sum ends."""
        self.take()
        return self.exponent()

    # Brackets, exponents and the arguments of LaTeX commands

    def group(self) -> Formula:
        """Read ( … ), [ … ], { … }, | … | as an absolute value, a matrix, or \\left. … \\right|_{x=0}."""
        if self.at("open", *CELLS.values()):
            return constructs.read_cells(self)
        place, opener = self.place, self.take()
        closer = CLOSER[opener.value]
        with self.nested():
            if self.at("close", closer):
                raise ReadingError(opener.start, "empty brackets", "write what stands in them")
            inside = self.contents()
        last = self.expect_close(opener)
        span = (opener.start, last.end)
        if opener.value == ".":
            if not self.at("under"):
                raise ReadingError(opener.start, "a bar without its place", "write \\right|_{\\theta=0}")
            return constructs.read_bar(self, inside, place)
        inside = constructs.bracketed(self, inside, opener, place)
        if opener.value == "|" and not isinstance(inside, Apply):
            return Call("abs", inside, span=span)
        return replace(inside, span=span)

    def contents(self) -> Formula:
        """Read a sum, or `a \\over b`."""
        first = self.place
        top = self.expression()
        if not self.at("cmd", "over"):
            return top
        self.take()
        return Quotient(top, self.expression(), span=self.span_since(first))

    def number(self, token: Token) -> Number:
        """Return a number's node."""
        return Number(token.number, token.place, span=(token.start, token.end))

    def exponent(self) -> Formula:
        """Read what follows ^: a group, a number or a letter, with a sign."""
        with self.nested():
            if self.current and self.current.is_op("+-"):
                first, sign = self.place, self.take()
                power = self.exponent()
                return Negative(power, span=self.span_since(first)) if sign.value == "-" else power
            power = self.argument(whole_number=True)
            if self.at("sup") and self.tokens[self.place - 1].kind != "close":
                self.take()
                higher = self.exponent()
                return Power(power, higher, span=(power.span[0], higher.span[1]))
            return power

    def argument(self, whole_number: bool = False) -> Formula:
        """Read the argument of a command: a group, or the one sign that follows.

        `\\frac12` is a half: unless `whole_number`, only one digit is taken.
        """
        token = self.current
        if token is None:
            raise self.unexpected_token()
        if token.kind == "open":
            return self.group()
        if token.kind == "number":
            if not whole_number or (self.latex and self.tokens[self.place - 1].kind == "sup"):
                self.split_digit(token)
            return self.number(self.take())
        if token.kind == "name":
            self.take()
            return self.letter(token.value, (token.start, token.end))
        if token.kind in ("cmd", "vulgar", "function"):
            with self.nested():
                return self.factor()
        raise self.unexpected_token()

    def split_digit(self, token: Token) -> None:
        """Cut a run of digits after its first, as TeX does."""
        if len(token.value) < 2 or not token.value.isdecimal():
            return
        cut = token.start + 1
        first, rest = token.value[0], token.value[1:]
        pieces = [
            Token("number", first, token.start, cut, type(token.number)(int(first))),
            Token("number", rest, cut, token.end, type(token.number)(int(rest))),
        ]
        self.tokens[self.place : self.place + 1] = pieces


def token_text(token: Token) -> str:
    """Return a token as a refusal names it."""
    return f"\\{token.value}" if token.kind == "cmd" else token.value


def product_of(factors: Sequence[Formula]) -> Formula:
    """Return the product of factors, the factor itself if there is one."""
    if len(factors) == 1:
        return factors[0]
    return Product(tuple(factors), span=(factors[0].span[0], factors[-1].span[1]))


def _is_whole_angle(factor: Formula) -> bool:
    """Tell whether a factor is an angle already: it holds a Greek letter, or is a part of π."""
    letters = names(factor)
    pi = any(isinstance(part, Constant) and part.name == "pi" for part in walk(factor))
    return any(map(is_greek, letters)) or (pi and not letters)


def _is_latin(token: Token) -> bool:
    """Tell whether a token is a Latin letter that counts nothing; n and k are multipliers."""
    greek = is_greek(token.value) or token.value == "pi"
    return token.kind == "name" and not greek and token.value not in _INDICES


def _is_time(token: Token) -> bool:
    return token.kind == "name" and token.value.split("_")[0] == "t"


def _is_angle_of_time(letter: Name) -> bool:
    return letter.name.split("_")[0] == "t"


def _is_minus_one(power: Formula) -> bool:
    return power in (Negative(Number(Fraction(1))), Number(Fraction(-1)))


def other_form(name: str) -> str:
    """Return the letter in its other form, phi for varphi and back; "" if it has one form only."""
    base, mark, rest = name.partition("_")
    bare = base.rstrip("'")
    if bare.removeprefix("var") not in _TWO_FORMS:
        return ""
    other = bare[3:] if bare.startswith("var") else f"var{bare}"
    return other + base[len(bare) :] + mark + rest


def _with_subscript(name: str) -> str:
    """Return F_1 for F1, the same letter typed without its subscript, and F1 for F_1; "" for others."""
    match = re.fullmatch(r"([A-Za-z]+)(_?)([0-9]+)", name)
    return "" if match is None else f"{match[1]}{'' if match[2] else '_'}{match[3]}"


def is_extreme(name: str) -> bool:
    r"""Tell whether a letter under dots is a value that does not change: \ddot x_{\max}, not ẍ of x_max.

    >>> is_extreme("x_max"), is_extreme("x_1")
    (True, False)
    """
    return re.split("[_,]", name)[-1] in ("max", "min", "rms", "eff")


def _is_d(token: Token | None) -> bool:
    return token is not None and (
        token.is_cmd("partial") or (token.kind == "name" and token.value == "d")
    )


def _degrees(node: Formula, span: Span) -> Formula:
    """30° is 30 π/180."""
    place = (span[1] - 1, span[1])
    half_turn = Number(Fraction(180), span=place)
    unit = Quotient(Constant("pi", span=place), half_turn, span=place)
    return Product((replace(node), unit), span=span)
