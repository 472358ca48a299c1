r"""Constructs with bounds, bars and cells: integrals, limits, product signs, matrices, values at a place.

Each function reads one construct from a parser that stands at its first token, and leaves the parser
behind it. The differential that closes an integral is looked for first, so that what stands before it is
read as any formula is: `\int_0^{2\pi} \cos\theta \, d\theta`, `\int \frac{dx}{1+x}`, `\int dx\, f`.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

from symbalance.document.formula import (
    INFINITY,
    Apply,
    Call,
    Cases,
    Derivative,
    Dots,
    Evaluation,
    Extremum,
    Formula,
    IndexedProduct,
    Integral,
    Limit,
    Matrix,
    Name,
    Negative,
    Number,
    Product,
    Sum,
)
from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.formulas.lexer import AT, Token
from symbalance.notes.reading.signs import MULTIPLE
from symbalance.text import lazy_patterns as re

if TYPE_CHECKING:
    from symbalance.notes.reading.formulas.parser import Parser

UNNAMED = Name("")
"""The letter of `\\max f` or `[f]_a^b`, which names none: the algebra takes the only one there is."""
MOST_CELLS = 2500
TRANSPOSED = ("T", "t", "top", "intercal")
_INDEX = re.compile(r"([+−-]?)(?=[0-9A-Za-z])([0-9]*)([A-Za-z]?)(?:([+−-])([0-9]+))?")
_TWO_INDICES = re.compile(r"([A-Za-z]|[0-9]+),?([A-Za-z]|[0-9]+)")


# Integrals ----------------------------------------------------------------------------------------


def read_integral(parser: Parser) -> Formula:
    """Read \\int_a^b f dx or \\oint f dx."""
    first, sign = parser.place, parser.take()
    lower, upper = read_bounds(parser)
    if (lower is None) != (upper is None):
        raise ReadingError(sign.start, "an integral with one bound only", "write both, or none")
    variable = _mark_differential(parser, sign)
    if parser.at("differential"):
        parser.take()
        body = _factor_behind(parser)
    else:
        with parser.nested():
            parser.bound.append(variable.name)
            body = parser.expression()
            parser.bound.pop()
        if parser.at("differential"):
            parser.take()
        elif parser.place < len(parser.tokens) and not _is_end_of_term(parser):
            raise parser.unexpected_token()
    span = parser.span_since(first)
    return Integral(body, variable, lower, upper, sign.value == "oint", span=span)


def _factor_behind(parser: Parser) -> Formula:
    """Return what follows \\int dx: a product, or 1."""
    if parser.starts_factor():
        with parser.nested():
            return parser.product()
    return Number(Fraction(1), span=(parser.offset, parser.offset))


def _is_end_of_term(parser: Parser) -> bool:
    token = parser.current
    return token is None or token.kind in ("close", "cell", "row", "rel", "sep") or token.is_op("+-±∓*/")


def _mark_differential(parser: Parser, sign: Token) -> Name:
    """Make one token of the integral's d x, or take it out of a numerator; return the letter x."""
    depth, open_signs = 0, 0
    _unwrap_differentials(parser)
    for place in range(parser.place, len(parser.tokens)):
        token = parser.tokens[place]
        if token.kind in ("open", "close"):
            depth += 1 if token.kind == "open" else -1
            if depth < 0:
                break
        if token.is_cmd("int", "oint"):
            open_signs += 1
        if not (token.kind == "name" and token.value == "d") or _is_of_a_derivative(parser, place):
            continue
        if open_signs:
            open_signs -= 1
            continue
        return _take_differential(parser, place, depth)
    remedy = "close it with its dx, as in \\int_0^{2\\pi} f \\, d\\theta"
    raise ReadingError(sign.start, "an integral without its differential", remedy)


def _unwrap_differentials(parser: Parser) -> None:
    r"""Take out the braces that set off a sign or a letter, {d} θ and d {θ}, behind an integral sign."""
    tokens = parser.tokens
    for place in range(len(tokens) - 3, parser.place - 1, -1):
        if place + 3 > len(tokens):
            continue
        opener, inside, closer = tokens[place : place + 3]
        is_group = (opener.kind, opener.value, closer.kind, closer.value) == ("open", "{", "close", "}")
        before = tokens[place - 1] if place else None
        is_bare = before is None or before.kind not in ("cmd", "sup", "sub", "close", "function")
        if not is_group or inside.kind != "name" or not is_bare or before is None:
            continue
        after = tokens[place + 3] if place + 3 < len(tokens) else None
        is_sign = inside.value == "d" and after is not None and after.kind == "name"
        is_letter = before.kind == "name" and before.value == "d" and _stands_free(tokens, place - 1)
        if is_sign or is_letter:
            tokens[place : place + 3] = [inside]


def _stands_free(tokens: list[Token], place: int) -> bool:
    """Tell whether a sign is under no command: not the d of \\frac d{x}, whose braces are arguments."""
    before = tokens[place - 1] if place else None
    return before is None or before.kind not in ("cmd", "sup", "sub")


def _is_of_a_derivative(parser: Parser, place: int) -> bool:
    """Tell whether the d at a place belongs to dx/dt, or has no letter behind it."""
    tokens = parser.tokens
    after = tokens[place + 1] if place + 1 < len(tokens) else None
    if after is None or after.kind != "name":
        return True
    before = tokens[place - 1] if place else None
    beyond = tokens[place + 2] if place + 2 < len(tokens) else None
    slashes = (before is not None and before.is_op("/")) or (
        beyond is not None and beyond.is_op("/") and _is_d_at(tokens, place + 3)
    )
    below = (
        before is not None and before.kind == "open" and place > 1 and tokens[place - 2].kind == "close"
    )
    above = (
        beyond is not None
        and beyond.kind == "close"
        and place + 3 < len(tokens)
        and tokens[place + 3].kind == "open"
        and _is_d_at(tokens, place + 4)
    )
    return slashes or below or above


def _is_d_at(tokens: list[Token], place: int) -> bool:
    return place < len(tokens) and tokens[place].kind == "name" and tokens[place].value == "d"


def _take_differential(parser: Parser, place: int, depth: int) -> Name:
    d, letter = parser.tokens[place : place + 2]
    variable = Name(letter.value, span=(letter.start, letter.end))
    if depth == 0:
        parser.tokens[place : place + 2] = [Token("differential", letter.value, d.start, letter.end)]
        return variable
    alone = parser.tokens[place - 1].kind == "open" and parser.tokens[place + 2].kind == "close"
    one = Token("number", "1", d.start, letter.end, Fraction(1))
    parser.tokens[place : place + 2] = [one] if alone else []
    return variable


def read_bounds(parser: Parser) -> tuple[Formula | None, Formula | None]:
    """Read _a^b or ^b_a; a name and = before the lower bound only repeat the variable."""
    lower = upper = None
    for _ in range(2):
        if parser.at("under") and lower is None:
            parser.take()
            lower = _lower_bound(parser)
        elif parser.at("sup") and upper is None:
            parser.take()
            upper = _bound(parser)
    return lower, upper


def _lower_bound(parser: Parser) -> Formula:
    following, relation = parser.peek(1), parser.peek(2)
    braced = parser.at("open", "{") and following is not None and following.kind == "name"
    if braced and relation is not None and relation.kind == "rel" and relation.value == "=":
        opener = parser.take()
        parser.place += 2
        bound = parser.expression()
        parser.expect_close(opener)
        return bound
    return _bound(parser)


def _bound(parser: Parser) -> Formula:
    """Read a bound: a group, or a sign and a number or letter; in plain text 2π is one."""
    first = parser.place
    minus = parser.current is not None and parser.current.is_op("+-") and parser.take().value == "-"
    bound = parser.argument(whole_number=not parser.latex)
    behind_number = isinstance(bound, Number) and not parser.latex and parser.is_tight()
    if behind_number and parser.at("name", "pi") and "pi" not in parser.names:
        bound = Product((bound, parser.atom()), span=parser.span_since(first))
    return Negative(bound, span=parser.span_since(first)) if minus else bound


def read_range_below(parser: Parser) -> tuple[Name, Formula, Formula] | None:
    """Read the _{1 \\le k \\le 4} of a sum: index and bounds; None where no such range stands below."""
    tokens = parser.tokens[parser.place : parser.place + _LONGEST_RANGE]
    stop = next((n for n, token in enumerate(tokens) if token.kind == "close"), 0)
    inside = tokens[2:stop]
    signs = [n for n, token in enumerate(inside) if token.kind == "rel"]
    if not parser.at("under") or tokens[1].value != "{" or len(signs) != 2 or signs[1] != signs[0] + 2:
        return None
    (lower_sign, letter, upper_sign) = inside[signs[0] : signs[1] + 1]
    if letter.kind != "name" or not {lower_sign.value, upper_sign.value} <= {"<", "≤"}:
        return None
    parser.take()
    opener = parser.take()
    lower = parser.expression()
    parser.place += 3
    upper = parser.expression()
    parser.expect_close(opener)
    one = Number(Fraction(1), span=lower.span)
    if lower_sign.value == "<":
        lower = Sum((lower, one), span=lower.span)
    if upper_sign.value == "<":
        upper = Sum((upper, Negative(one, span=upper.span)), span=upper.span)
    return Name(letter.value, span=(letter.start, letter.end)), lower, upper


def read_start_below(parser: Parser) -> tuple[Name, Formula, Formula] | None:
    """Read the _{n \\ge 0} of a sum without end: its index, where it begins, and infinity; else None."""
    tokens = parser.tokens[parser.place : parser.place + _LONGEST_RANGE]
    stop = next((n for n, token in enumerate(tokens) if token.kind == "close"), 0)
    inside = tokens[2:stop]
    kinds = [token.kind for token in inside]
    if not parser.at("under") or tokens[1].value != "{" or kinds != ["name", "rel", "number"]:
        return None
    letter, sign, _ = inside
    if sign.value not in (">", "≥"):
        return None
    parser.take()
    opener = parser.take()
    parser.place += 2
    lower = parser.expression()
    parser.expect_close(opener)
    if sign.value == ">":
        lower = Sum((lower, Number(Fraction(1), span=lower.span)), span=lower.span)
    infinity = replace(INFINITY, span=(sign.start, sign.end))
    return Name(letter.value, span=(letter.start, letter.end)), lower, infinity


_LONGEST_RANGE = 40
"""Tokens of a range below a sum sign, with room to spare."""


# Product signs, limits and extrema ----------------------------------------------------------------


def read_product_sign(parser: Parser) -> Formula:
    """Read \\prod_{k=1}^{n} body."""
    first, sign = parser.place, parser.take()
    index, lower = parser.lower_bound() if parser.at("under") else (None, None)
    upper = parser.upper_bound() if parser.at("sup") else None
    if index is None or lower is None or upper is None:
        remedy = "write \\prod_{k=1}^{n}"
        raise ReadingError(sign.start, "a product sign without index and bounds", remedy)
    parser.bound.append(index.name)
    with parser.nested():
        body = parser.product()
    parser.bound.pop()
    return IndexedProduct(body, index, lower, upper, span=parser.span_since(first))


def read_limit(parser: Parser) -> Formula:
    """Read \\lim_{x \\to 0} body."""
    first, sign = parser.place, parser.take()
    if not parser.at("under"):
        raise ReadingError(sign.start, "a limit without its point", "write \\lim_{x \\to 0}")
    parser.take()
    opener = parser.take()
    letter = parser.take()
    if opener.value != "{" or letter.kind != "name" or not parser.at("arrow"):
        raise ReadingError(opener.start, "a limit that is not read", "write \\lim_{x \\to 0}")
    parser.take()
    point, side = _point_of_limit(parser)
    parser.expect_close(opener)
    variable = Name(letter.value, span=(letter.start, letter.end))
    parser.bound.append(variable.name)
    with parser.nested():
        body = parser.product()
    parser.bound.pop()
    return Limit(body, variable, point, side, span=parser.span_since(first))


def _point_of_limit(parser: Parser) -> tuple[Formula, int]:
    """Return where a limit is taken, and from which side: 0^+ and 0+ come from above."""
    first = parser.place
    depth, stop = 0, first
    while stop < len(parser.tokens) and (depth or parser.tokens[stop].kind != "close"):
        depth += {"open": 1, "close": -1}.get(parser.tokens[stop].kind, 0)
        stop += 1
    signs = [t for t in parser.tokens[first + 1 : stop] if t.kind not in ("open", "close", "sup")]
    if signs and signs[-1].is_op("+-") and parser.tokens[first].kind != "op":
        side = 1 if signs[-1].value == "+" else -1
        point = parser.atom()
        parser.place = stop
        return point, side
    return parser.expression(), 0


def read_extremum(parser: Parser) -> Formula:
    """Read \\max_\\theta f, \\max f, or \\max(a, b)."""
    first, sign = parser.place, parser.take()
    variable = UNNAMED
    if parser.at("under"):
        parser.take()
        bound = parser.exponent()
        if not isinstance(bound, Name):
            raise ReadingError(sign.start, f"{sign.value} over what is no letter", "name one letter")
        variable = bound
    elif parser.at("open", "(", "\\{"):
        listed = _read_list(parser)
        if listed is not None:
            return Apply(sign.value, listed, span=parser.span_since(first))
    with parser.nested():
        body = parser.product()
    return Extremum(sign.value, body, variable, span=parser.span_since(first))


def _read_list(parser: Parser) -> tuple[Formula, ...] | None:
    """Return a, b, c of (a, b, c); None where a bracket holds no list."""
    depth = 0
    for place in range(parser.place, len(parser.tokens)):
        token = parser.tokens[place]
        depth += {"open": 1, "close": -1}.get(token.kind, 0)
        if depth == 1 and token.kind == "sep":
            break
        if depth == 0:
            return None
    opener = parser.take()
    with parser.nested():
        parts = [parser.expression()]
        while parser.at("sep"):
            parser.take()
            parts.append(parser.expression())
    parser.expect_close(opener)
    return tuple(parts)


# Values at a place --------------------------------------------------------------------------------


def read_bar(parser: Parser, node: Formula, first: int) -> Formula:
    """Read |_{x=b}, |_a^b or ]_a^b behind a formula, the parser standing at the underscore."""
    parser.take()
    variable, lower = UNNAMED, None
    following, relation = parser.peek(1), parser.peek(2)
    braced = parser.at("open", "{") and following is not None and following.kind == "name"
    if braced and relation is not None and relation.kind == "rel" and relation.value == "=":
        opener, letter = parser.take(), parser.take()
        variable = Name(letter.value, span=(letter.start, letter.end))
        parser.take()
        value = parser.expression()
        parser.expect_close(opener)
    else:
        value = _bound(parser)
    if parser.at("sup"):
        parser.take()
        lower, value = value, _upper_end(parser, variable)
    span = parser.span_since(first)
    return Evaluation(node, variable, value, lower, span=span)


def _upper_end(parser: Parser, variable: Name) -> Formula:
    following, relation = parser.peek(1), parser.peek(2)
    named = parser.at("open", "{") and following is not None and following.value == variable.name
    if named and relation is not None and relation.kind == "rel":
        opener = parser.take()
        parser.place += 2
        value = parser.expression()
        parser.expect_close(opener)
        return value
    return _bound(parser)


def read_place(parser: Parser, letter: Name, first: int) -> Formula | None:
    """Read x(π), x(0), x(90°): a letter and tightly behind it one number in brackets.

    The other reading, the product, is tried too; what x depends on the algebra knows.
    """
    if not (parser.at("open", "(") and parser.is_tight()):
        return None
    start, stop = parser.place + 1, parser.place + 1
    while stop < len(parser.tokens) and parser.tokens[stop].kind not in ("open", "close"):
        stop += 1
    inside = parser.tokens[start:stop]
    if stop >= len(parser.tokens) or parser.tokens[stop].value != ")" or not _is_a_number(parser, inside):
        return None
    if not _has_other_place(parser, start, stop) and parser.choose() == 1:
        return None
    opener = parser.take()
    place = parser.expression()
    parser.expect_close(opener)
    return Apply("at", (letter, place), span=parser.span_since(first))


def _has_other_place(parser: Parser, start: int, stop: int) -> bool:
    """Tell whether a letter stands at two places of a side, F(3000)/F(6500): nobody writes products so.

    `start` and `stop` are the tokens within the first place's brackets; the letter stands before them.
    """
    tokens = parser.tokens
    name, inside = tokens[start - 2], [token.value for token in tokens[start:stop]]
    for n, token in enumerate(tokens[:-3]):
        is_same = token.kind == name.kind and token.value == name.value
        if not is_same or tokens[n + 1].value != "(" or tokens[n + 1].start != token.end:
            continue
        close = next((m for m in range(n + 2, len(tokens)) if tokens[m].kind in ("open", "close")), n + 2)
        other = [token.value for token in tokens[n + 2 : close]]
        if tokens[close].value == ")" and other != inside and _is_a_number(parser, tokens[n + 2 : close]):
            return True
    return False


def read_place_of_derivative(parser: Parser, node: Derivative, first: int) -> Formula:
    """Read \\frac{dx}{dt}(0), \\ddot x(\\pi), \\dot x(t): a derivative at a place, never times a number.

    Nor times an angle or time alone, shifted or stretched: dx/dt(-θ). A bracket with other letters in it
    is left, as a factor or as the place that the letter's declaration makes it.
    """
    if not (parser.at("open", "(") and parser.is_tight()) or not isinstance(node.expression, Name):
        return node
    start = parser.place + 1
    stop = start
    while stop < len(parser.tokens) and parser.tokens[stop].kind not in ("open", "close"):
        stop += 1
    inside = parser.tokens[start:stop]
    if stop >= len(parser.tokens) or parser.tokens[stop].value != ")" or not inside:
        return node
    if len(inside) == 1 and inside[0].value in (node.variable.name, *_ANGLES):
        parser.place = stop + 1
        return replace(node, span=parser.span_since(first))
    if not (_is_a_number(parser, inside) or _is_an_angle(inside, node)):
        return node
    opener = parser.take()
    place = parser.expression()
    parser.expect_close(opener)
    return Apply("at", (node, place), span=parser.span_since(first))


def _is_an_angle(inside: list[Token], node: Derivative) -> bool:
    """Tell whether tokens hold an angle or time with numbers and ω, and not the letter differentiated."""
    letters = {token.value for token in inside if token.kind == "name"}
    running = {node.variable.name, *_ANGLES}
    plain = all(token.kind in ("number", "vulgar", "degree", "name", "op") for token in inside)
    own = isinstance(node.expression, Name) and node.expression.name in {*letters, *_ANGLES}
    return plain and not own and bool(letters & running) and letters <= {*running, "omega", "pi"}


_ANGLES = ("t", "theta", "phi", "varphi", "vartheta")


def _is_a_number(parser: Parser, tokens: list[Token]) -> bool:
    """Tell whether tokens are a number, a multiple of π, or degrees, and no sum."""
    has_pi = any(t.kind == "name" and t.value == "pi" and "pi" not in parser.names for t in tokens)
    plain = all(
        t.kind in ("number", "degree", "vulgar")
        or (t.kind == "name" and t.value == "pi" and "pi" not in parser.names)
        or (t.is_op("/*") and has_pi)
        or (t.is_op("-") and t is tokens[0])
        for t in tokens
    )
    return bool(tokens) and plain


# Letters with indices: Bessel functions, Kronecker's delta -----------------------------------------


def read_indexed(parser: Parser, token: Token) -> Formula | None:
    """Read J_n(z) and δ_{mn} where these are no declared letters, the parser behind the name."""
    base, _, script = token.value.partition("_")
    span = (token.start, token.end)
    is_own = token.value in parser.page_letters  # J_2 (n_2/n_1)² of an inertia that lines above name
    if base == "J" and script and not is_own and parser.at("open", "(", "[", AT):
        index = _index(parser, script, span)
        return index and Apply(
            "besselj", (index, parser.group()), span=(token.start, parser.tokens[parser.place - 1].end)
        )
    if base == "delta" and (match := _TWO_INDICES.fullmatch(script)):
        one, two = (_index(parser, part, span) for part in match.groups())
        return Apply("kronecker", (one, two), span=span) if one and two else None
    return None


def _index(parser: Parser, script: str, span: tuple[int, int]) -> Formula | None:
    match = _INDEX.fullmatch(script)
    if match is None or not script:
        return None
    own_sign, digits, letter, sign, shift = match.groups()
    parts: list[Formula] = [Number(Fraction(int(digits)), span=span)] if digits else []
    if letter:
        if letter not in parser.names and letter not in parser.bound:
            if not parser.takes_free_letters or "delta" in parser.names:
                return None
            parts.append(parser.letter(letter, span))
        else:
            parts.append(Name(letter, span=span))
    node = parts[0] if len(parts) == 1 else Product(tuple(parts), span=span)
    if own_sign in ("-", "−"):  # J_{-1}: the sign is the order's own, no difference from nothing
        node = Negative(node, span=span)
    if not shift:
        return node
    by: Formula = Number(Fraction(int(shift)), span=span)
    by = Negative(by, span=span) if sign in ("-", "−") else by
    return Sum((node, by), span=span)


# Binomials, conjugates, transposes ----------------------------------------------------------------


def read_binomial(parser: Parser) -> Formula:
    """Read \\binom{n}{k}."""
    first = parser.place
    parser.take()
    upper = parser.argument()
    lower = parser.argument()
    return Apply("binomial", (upper, lower), span=parser.span_since(first))


def read_determinant(parser: Parser) -> Formula:
    """Read \\det A, \\det(A B)."""
    first = parser.place
    parser.take()
    if not parser.starts_factor():
        raise parser.unexpected_token()
    with parser.nested():
        inside = parser.factor()
    return Apply("det", (inside,), span=parser.span_since(first))


def read_conjugate(parser: Parser) -> Formula | None:
    """Read \\overline{a b} over more than one letter: the complex conjugate; None for a letter."""
    opener, inside, after = parser.peek(1), parser.peek(2), parser.peek(3)
    if opener is None or opener.value != "{" or inside is None or after is None:
        return None
    if inside.kind == "name" and after.kind == "close":
        return None
    first = parser.place
    parser.take()
    return Call("conj", parser.group(), span=parser.span_since(first))


def read_raised_mark(parser: Parser, node: Formula, first: int) -> Formula | None:
    """Read z^* and M^T, M^\\top, the parser at the caret; None where a power follows."""
    mark, closing = parser.peek(1), None
    steps = 2
    if mark is not None and mark.kind == "open" and mark.value == "{":
        mark, closing = parser.peek(2), parser.peek(3)
        steps = 4
        if closing is None or closing.kind != "close":
            return None
    if mark is None:
        return None
    if mark.is_op("*"):
        parser.place += steps
        return Call("conj", node, span=parser.span_since(first))
    is_mark = mark.is_cmd("top", "intercal") or (
        mark.kind == "name" and mark.value in TRANSPOSED and mark.value not in parser.names
    )
    if not is_mark:
        return None
    parser.place += steps
    return Apply("transpose", (node,), span=parser.span_since(first))


def bracketed(parser: Parser, inside: Formula, opener: Token, first: int) -> Formula:
    """Return what a bracket holds, a row (a_1 … a_N) as one, a matrix between bars as its determinant.

    The bracket's own tokens tell a row from a sum: no sign stands among them.
    """
    tokens = parser.tokens[first + 1 : parser.place - 1]
    if opener.value == "|" and isinstance(inside, Matrix):
        return Apply("det", (inside,), span=inside.span)
    if opener.value not in ("(", "["):
        return inside
    kinds = {isinstance(term, Dots) for term in inside.terms} if isinstance(inside, Sum) else set()
    is_sum = len(kinds) == 2  # dots beside entries: dots alone are no row
    if is_sum and isinstance(inside, Sum) and not any(token.is_op("+-±∓") for token in tokens):
        return Matrix((inside.terms,), span=inside.span)
    return inside


# Matrices and cases -------------------------------------------------------------------------------


def read_cells(parser: Parser) -> Formula:
    """Read the rows between \\begin{pmatrix} and \\end{pmatrix}, or those of cases."""
    first, opener = parser.place, parser.take()
    if opener.value == "[cases]":
        return _read_cases(parser, opener, first)
    rows: list[list[Formula]] = [[]]
    count = 0
    with parser.nested():
        while not parser.at("close"):
            if parser.current is None:
                raise ReadingError(opener.start, "a matrix without its end", "close it")
            if parser.at("row"):
                parser.take()
                rows.append([])
                continue
            rows[-1].append(_read_cell(parser))
            count += 1
            if count > MOST_CELLS:
                what = f"a matrix of more than {MOST_CELLS} entries"
                raise ReadingError(opener.start, what, "write it in blocks")
            if parser.at("cell"):
                parser.take()
                if parser.at("row") or parser.at("close"):
                    rows[-1].append(_nothing(parser))
    parser.expect_close(opener)
    rows = [row for row in rows if row]
    if not rows or len({len(row) for row in rows}) > 1:
        remedy = "give every row as many entries"
        raise ReadingError(opener.start, "a matrix whose rows differ in length", remedy)
    matrix = Matrix(tuple(map(tuple, rows)), span=parser.span_since(first))
    return Apply("det", (matrix,), span=matrix.span) if opener.value == "[vmatrix]" else matrix


def _read_cell(parser: Parser) -> Formula:
    return _nothing(parser) if parser.at("cell") else parser.contents()


def _nothing(parser: Parser) -> Formula:
    """Return what an empty cell stands for."""
    return Number(Fraction(0), span=(parser.offset, parser.offset))


def _read_cases(parser: Parser, opener: Token, first: int) -> Formula:
    values: list[Formula] = []
    conditions: list[tuple[Formula, str, Formula] | None] = []
    with parser.nested():
        while not parser.at("close"):
            if parser.current is None:
                raise ReadingError(opener.start, "cases without their end", "close them")
            if parser.at("row") or (values and parser.at("sep")):
                parser.take()
                continue
            values.append(parser.contents())
            if parser.at("rel"):
                what = "a system of equations in one brace"
                raise ReadingError(opener.start, what, "write each row as an equation")
            conditions.append(_read_condition(parser))
    parser.expect_close(opener)
    if len(values) < 2 or None in conditions[:-1]:
        remedy = "write value & condition in every row, the last may be otherwise"
        raise ReadingError(opener.start, "cases without conditions", remedy)
    return Cases(tuple(values), tuple(conditions), span=parser.span_since(first))


def _read_condition(parser: Parser) -> tuple[Formula, str, Formula] | None:
    while parser.at("cell") or parser.at("sep"):
        parser.take()
    if parser.at("row") or parser.at("close"):
        return None
    bars = [place for place in range(parser.place, _end_of_cell(parser)) if _is_bar(parser, place)]
    is_multiple = len(bars) == 1 and parser.tokens[bars[0]].value == MULTIPLE
    if len(bars) == 1:  # N | n: N divides n
        parser.tokens[bars[0]] = replace(parser.tokens[bars[0]], kind="rel", value=_DIVIDES)
    parity = parser.take() if parser.at("parity") else None
    left = parser.contents()
    parity = parser.take() if parity is None and parser.at("parity") else parity
    if parity is not None:
        return _of_remainder(
            left, Number(Fraction(2), span=left.span), Number(Fraction(int(parity.value)))
        )
    if parser.at("remainder"):
        return _read_remainder(parser, left)
    if not parser.at("rel"):
        raise ReadingError(parser.offset, "a condition that is not read", "write n = 0 or x > 0")
    sign, right = parser.take().value, parser.contents()
    if parser.at("remainder") or (parser.at("open", "(") and _is_remainder(parser.peek(1))):
        return _of_remainder(left, _read_divisor(parser), right)
    if sign == _DIVIDES:
        left, right = (right, left) if is_multiple else (left, right)
        zero = Number(Fraction(0), span=right.span)
        return Apply("mod", (right, left), span=(left.span[0], right.span[1])), "=", zero
    if parser.at("rel"):
        _skip_lower_bound(parser, sign)
    return left, sign, right


def _of_remainder(left: Formula, divisor: Formula, rest: Formula) -> tuple[Formula, str, Formula]:
    """Return the condition that a whole number leaves a rest."""
    return Apply("mod", (left, divisor), span=left.span), "=", replace(rest, span=left.span)


def _read_remainder(parser: Parser, left: Formula) -> tuple[Formula, str, Formula]:
    """Read the rest of n \\bmod 4 = 1, the parser at the word between the numbers."""
    divisor = _read_divisor(parser)
    if not parser.at("rel", "="):
        raise ReadingError(parser.offset, "a remainder without its value", "write n \\bmod 4 = 1")
    parser.take()
    return _of_remainder(left, divisor, parser.contents())


def _is_remainder(token: Token | None) -> bool:
    return token is not None and token.kind == "remainder"


def _read_divisor(parser: Parser) -> Formula:
    """Read the 4 of \\bmod 4, \\pmod{4} and (\\mod 4)."""
    opener = parser.take() if parser.at("open", "(") else None
    parser.take()
    divisor = parser.atom()
    if opener is not None:
        parser.expect_close(opener)
    return divisor


_DIVIDES = "∣"


def _end_of_cell(parser: Parser) -> int:
    """Return the place of the token that ends the condition begun: a new row or the end of the cases."""
    depth = 0
    for place in range(parser.place, len(parser.tokens)):
        token = parser.tokens[place]
        depth += {"open": 1, "close": -1}.get(token.kind, 0)
        if depth < 0 or (depth == 0 and token.kind == "row"):
            return place
    return len(parser.tokens)


def _is_bar(parser: Parser, place: int) -> bool:
    return parser.tokens[place].kind == "bar"


def _skip_lower_bound(parser: Parser, sign: str) -> None:
    """Go past the ≥ 1 of m = n ≥ 1: it says of whole numbers which case the others leave out."""
    first, bound = parser.take(), parser.contents()
    is_bound = first.value in (">", "≥", "≠") and bound in (Number(Fraction(0)), Number(Fraction(1)))
    if sign != "=" or not is_bound:
        what = "two conditions at once"
        raise ReadingError(first.start, what, "write one condition in each row")
