"""Verifier of certificates: retraces what a check proved, with Python's standard library alone.

    python verify_certificates.py FILE.json ...

A certificate holds the two sides of a relation as trees, the values of the letters that the proof used
(its premises), and what it claims: an identity, a witness that the sides differ, or agreement to an
order.

    identity   both sides are expanded into quotients of polynomials in letters, e^(i m), roots of unity,
               roots of primes and of polynomials; the cross difference must vanish, exactly
    witness    both sides are evaluated at the point named; they must be what is stated, and differ
    digits     a printed decimal must be the other side, rounded at its last digit
    order      the difference must fall with the small letter as fast as the order says, in numbers

Exit code 0 if every certificate is verified, 1 if one is not, 2 if a file cannot be read. A certificate
says why it has no proof to be retraced ("nothing"); such ones are counted, and are not verified.
"""

from __future__ import annotations

import cmath
import json
import math
import sys
from fractions import Fraction
from functools import cache

MOST_TERMS, LARGEST_TURN = 20_000, 2_000
CALLS = {
    "sin": cmath.sin, "cos": cmath.cos, "tan": cmath.tan, "sqrt": cmath.sqrt, "exp": cmath.exp,
    "asin": cmath.asin, "acos": cmath.acos, "atan": cmath.atan, "ln": cmath.log, "abs": abs,
}  # fmt: skip


class Rejected(Exception):  # noqa: N818
    """A certificate that does not prove what it says, or is none."""


# Polynomials: {monomial: coefficient}, a monomial being a sorted tuple of (generator, exponent)


def plus(a, b, factor=1):
    """Return a + factor b."""
    result = dict(a)
    for monomial, value in b.items():
        result[monomial] = result.get(monomial, 0) + factor * value
    if len(result) > MOST_TERMS:
        raise Rejected("too large to be retraced")
    return {m: v for m, v in result.items() if v}


def times(a, b):
    """Return a b, with e^(2 pi i) = 1, p^(1/2)^2 = p and the square of a root resolved."""
    result = {}
    for one, first in a.items():
        for other, second in b.items():
            powers = dict(one)
            for generator, exponent in other:
                powers[generator] = powers.get(generator, 0) + exponent
            piece = _resolved(powers, first * second)
            result = plus(result, piece)
    return result


def _resolved(powers, value):
    polynomial = {(): value}
    rest = {}
    for generator, power in powers.items():
        left = power
        if generator[0] == "turn":
            left = power % 1
        elif generator[0] == "prime":
            whole = math.floor(power)
            polynomial = {m: v * Fraction(generator[1]) ** whole for m, v in polynomial.items()}
            left = power - whole
        elif generator[0] == "root" and power >= 2:
            for _ in range(int(power // 2)):
                polynomial = times(polynomial, dict(generator[1]))
            left = power % 2
        if left:
            rest[generator] = left
    key = tuple(sorted(rest.items(), key=repr))
    return (
        times(polynomial, {key: Fraction(1)})
        if len(polynomial) > 1 or () not in polynomial
        else {key: polynomial[()]}
    )


def letter(*generator, exponent=Fraction(1)):
    """Return a generator as a quotient."""
    return {((generator, Fraction(exponent)),): Fraction(1)}, ONE


ONE = {(): Fraction(1)}


def inverse(polynomial):
    """Return 1/p as a polynomial where p has one term without a root; None elsewhere."""
    if len(polynomial) != 1:
        return None
    ((monomial, value),) = polynomial.items()
    if any(generator[0] == "root" for generator, _ in monomial):
        return None
    return _resolved({generator: -exponent for generator, exponent in monomial}, 1 / value)


def quotient(above, below):
    """Return (a/b)/(c/d)."""
    numerator, denominator = times(above[0], below[1]), times(above[1], below[0])
    if not denominator:
        raise Rejected("a division by zero")
    inverted = inverse(denominator)
    return (times(numerator, inverted), ONE) if inverted is not None else (numerator, denominator)


# Trees


def expand(tree, values):  # noqa: PLR0911
    """Return the quotient of polynomials that a tree stands for, its letters put in."""
    kind, *parts = tree
    if kind == "number":
        return {(): Fraction(parts[0])} if Fraction(parts[0]) else {}, ONE
    if kind == "name":
        return expand(values[parts[0]], values) if parts[0] in values else letter("letter", parts[0])
    if kind == "constant":
        if parts[0] == "i":
            return letter("turn", exponent=Fraction(1, 4))
        return letter("letter", f"constant {parts[0]}")
    if kind == "call":
        return _call(parts[0], parts[1], values)
    pieces = [expand(part, values) for part in parts]
    if kind == "sum":
        total = ({}, ONE)
        for above, below in pieces:
            numerator = plus(times(total[0], below), times(above, total[1]))
            total = quotient((numerator, ONE), (times(total[1], below), ONE))
        return total
    if kind == "product":
        total = (ONE, ONE)
        for above, below in pieces:
            total = quotient((times(total[0], above), ONE), (times(total[1], below), ONE))
        return total
    if kind == "quotient":
        return quotient(*pieces)
    if kind == "power":
        return _power(pieces[0], pieces[1])
    raise Rejected(f"{kind} is not retraced")


def _number(value):
    """Return a rational number, None if a quotient is none."""
    return value[0].get((), Fraction(0)) if value[1] == ONE and set(value[0]) <= {()} else None


def _power(base, exponent):
    power = _number(exponent)
    if power is None:
        raise Rejected("a power that is no number is not retraced")
    if power.denominator == 2:
        base, power = _root(base), power * 2
    if power.denominator != 1 or abs(power) > 64:
        raise Rejected("this power is not retraced")
    result = (ONE, ONE)
    for _ in range(abs(int(power))):
        result = times(result[0], base[0]), times(result[1], base[1])
    return quotient((ONE, ONE), result) if power < 0 else quotient((result[0], ONE), (result[1], ONE))


def _root(value):
    """Return the root of a quotient: of a number by its primes, else a generator whose square it is."""
    above, below = times(value[0], value[1]), value[1]
    if not above:
        return {}, ONE
    lead = above[min(above, key=repr)]
    scale = _root_of_number(abs(lead))
    rest = {m: v / abs(lead) for m, v in above.items()}
    own = (
        ONE
        if rest == ONE
        else {((("root", tuple(sorted(rest.items(), key=repr))), Fraction(1)),): Fraction(1)}
    )
    return quotient((times(scale, own), ONE), (below, ONE))


def _root_of_number(number):
    result = ONE
    for whole, sign in ((number.numerator, 1), (number.denominator, -1)):
        part, prime = whole, 2
        while part > 1 and prime * prime <= 10**9:
            if prime * prime > part:
                prime = part
            if part % prime == 0:
                result = times(result, _resolved({("prime", prime): Fraction(sign, 2)}, Fraction(1)))
                part //= prime
            else:
                prime += 1
        if part > 1:
            raise Rejected("a root of a number this large is not retraced")
    return result


def _call(function, argument, values):
    if function == "sqrt":
        return _root(expand(argument, values))
    if function in ("sin", "cos", "tan"):
        arc = argument
        while arc[0] == "name" and arc[1] in values:
            arc = values[arc[1]]
        if arc[0] == "call" and arc[1] in ("asin", "acos"):
            same = expand(arc[2], values)
            square = quotient((times(same[0], same[0]), ONE), (times(same[1], same[1]), ONE))
            other = _root(quotient((plus(square[1], square[0], -1), ONE), (square[1], ONE)))
            sine, cosine = (same, other) if arc[1] == "asin" else (other, same)
        else:
            sine, cosine = _waves(expand(argument, values))
        return {"sin": sine, "cos": cosine}.get(function) or quotient(sine, cosine)
    above, below = expand(argument, values)
    key = tuple(sorted(above.items(), key=repr)), tuple(sorted(below.items(), key=repr))
    return letter("function", function, key)


def _waves(argument):
    """Return sine and cosine of a polynomial, by e^(i m) of its terms."""
    if argument[1] != ONE:
        key = tuple(sorted(argument[0].items(), key=repr)), tuple(sorted(argument[1].items(), key=repr))
        return letter("function", "sin", key), letter("function", "cos", key)
    powers, turn = {}, Fraction(0)
    pi = ((("letter", "constant pi"), Fraction(1)),)
    for monomial, value in argument[0].items():
        if monomial == pi:
            turn += value / 2
        elif any(generator[0] == "turn" for generator, _ in monomial):
            raise Rejected("the sine of a complex number is not retraced")
        else:
            powers[("wave", monomial)] = value
    forward = _resolved({**powers, ("turn",): turn}, Fraction(1, 2))
    backward = _resolved({**{g: -e for g, e in powers.items()}, ("turn",): -turn}, Fraction(1, 2))
    minus_i = {((("turn",), Fraction(3, 4)),): Fraction(1)}
    return (times(minus_i, plus(forward, backward, -1)), ONE), (plus(forward, backward), ONE)


# Is a polynomial zero?


def is_zero(polynomial):
    """Tell whether a polynomial vanishes: for each product of its other generators, its number does."""
    numbers = {}
    for monomial, value in polynomial.items():
        here = {g: e for g, e in monomial if g[0] == "turn" or (g[0] == "prime" and e == Fraction(1, 2))}
        rest = tuple((g, e) for g, e in monomial if g not in here)
        numbers.setdefault(rest, []).append((here, value))
    return all(_is_zero_number(terms) for terms in numbers.values())


def _is_zero_number(terms):
    """Tell whether a sum of roots of unity times roots of primes is 0: in a cyclotomic field, exactly."""
    total = {}
    for powers, value in terms:
        piece = {powers.get(("turn",), Fraction(0)): value}
        for prime in (g[1] for g in powers if g[0] == "prime"):
            piece = _convolved(piece, _gauss(prime))
        for turn, part in piece.items():
            total[turn % 1] = total.get(turn % 1, 0) + part
    size = math.lcm(*(turn.denominator for turn in total))
    if size > LARGEST_TURN:
        raise Rejected("a field this large is not retraced")
    row = [Fraction(0)] * size
    for turn, part in total.items():
        row[int(turn * size)] += part
    divisor = cyclotomic(size)
    for k in range(size - 1, len(divisor) - 2, -1):
        lead = row[k]
        if lead:
            for j, digit in enumerate(reversed(divisor)):
                row[k - j] -= lead * digit
    return not any(row)


def _convolved(a, b):
    result = {}
    for x, first in a.items():
        for y, second in b.items():
            result[(x + y) % 1] = result.get((x + y) % 1, 0) + first * second
    return result


@cache
def _gauss(prime):
    """Return the root of a prime as a sum of roots of unity."""
    if prime == 2:
        return {Fraction(1, 8): Fraction(1), Fraction(7, 8): Fraction(1)}
    if prime > LARGEST_TURN:
        raise Rejected("the root of a prime this large is not retraced")
    squares = {k * k % prime for k in range(1, prime)}
    shift = Fraction(0) if prime % 4 == 1 else Fraction(3, 4)
    return {
        (Fraction(k, prime) + shift) % 1: Fraction(1 if k in squares else -1) for k in range(1, prime)
    }


@cache
def cyclotomic(n):
    """Return the coefficients of the cyclotomic polynomial, the constant first."""
    row = [-1, *[0] * (n - 1), 1]
    for d in range(1, n):
        if n % d == 0:
            row = _divided(row, cyclotomic(d))
    return tuple(row)


def _divided(row, divisor):
    row, result = list(row), []
    for k in range(len(row) - len(divisor), -1, -1):
        lead = row[k + len(divisor) - 1]
        result.append(lead)
        for j, digit in enumerate(divisor):
            row[k + j] -= lead * digit
    return result[::-1]


# Numbers


def evaluate(tree, point, values):  # noqa: PLR0911
    """Return a tree's value in floats at a point."""
    kind, *parts = tree
    if kind == "number":
        return complex(Fraction(parts[0]))
    if kind == "name":
        if parts[0] in point:
            return complex(Fraction(point[parts[0]]))
        return evaluate(values[parts[0]], point, values)
    if kind == "constant":
        return {"pi": math.pi, "e": math.e, "i": 1j}[parts[0]]
    if kind == "call":
        return CALLS[parts[0]](evaluate(parts[1], point, values))
    pieces = [evaluate(part, point, values) for part in parts]
    if kind == "sum":
        return sum(pieces)
    if kind == "product":
        return math.prod(pieces)
    return pieces[0] / pieces[1] if kind == "quotient" else pieces[0] ** pieces[1]


def _is_near(a, b, part):
    return abs(a - b) <= part * max(abs(a), abs(b), 1e-12)


# Certificates


def verify(certificate):
    """Raise Rejected unless a certificate proves what it says; return what it is that is proved."""
    claim = certificate["proof"]
    if claim == "nothing":
        return claim
    left, right, values = certificate["left"], certificate["right"], certificate["values"]
    if claim == "identity":
        first, second = expand(left, values), expand(right, values)
        if not is_zero(plus(times(first[0], second[1]), times(second[0], first[1]), -1)):
            raise Rejected("the two sides are not identical")
    elif claim == "witness":
        witness = certificate["witness"]
        one, other = (evaluate(side, witness["point"], values) for side in (left, right))
        stated = [complex(witness[name]) for name in ("left", "right")]
        if not all(_is_near(a, b, 1e-9) for a, b in zip((one, other), stated, strict=True)):
            raise Rejected("the sides do not have the values stated")
        if _is_near(one, other, 1e-9):
            raise Rejected("the sides do not differ")
    elif claim == "order":
        _verify_order(certificate, values)
    elif claim == "digits":
        sides = [evaluate(side, {}, values) for side in (left, right)]
        if abs(sides[0] - sides[1]) > float(Fraction(certificate["place"])) / 2 * (1 + 1e-6):
            raise Rejected("the decimal is not the value rounded")
    else:
        raise Rejected(f"{claim} is no proof")
    expected = {
        "identity": ("holds", "holds_to_order", "conditional"),
        "witness": ("refuted",),
        "order": ("holds_to_order",),
        "digits": ("holds_to_order",),
    }
    if certificate["verdict"] not in expected[claim]:
        raise Rejected(f"{claim} does not prove that it is {certificate['verdict']}")
    return claim


def _verify_order(certificate, values):
    """Halve the small letter and see the difference fall by the power that the order says."""
    order = certificate["order"]
    gaps = []
    for k in (3, 4):
        size = Fraction(1, 2**k) if order["power"] > 0 else Fraction(2**k)
        point = {**order["point"], order["letter"]: str(size)}
        sides = [evaluate(certificate[name], point, values) for name in ("left", "right")]
        gaps.append(abs(sides[0] - sides[1]) / max(abs(sides[0]), 1e-300))
    if gaps[0] > 1e-13 and gaps[1] > gaps[0] / 2 ** (order["through"] + 0.5):
        raise Rejected("the difference does not fall as the order says")


def main(names):
    """Verify the certificates of files, and say of each that is rejected where and why."""
    counts, bad = {}, 0
    for name in names:
        try:
            with open(name, encoding="utf-8") as file:
                certificates = json.load(file)["certificates"]
        except (OSError, ValueError, KeyError, TypeError) as problem:
            print(f"{name}: cannot be read as certificates ({problem})", file=sys.stderr)
            return 2
        for certificate in certificates:
            try:
                proof = verify(certificate)
                counts[proof] = counts.get(proof, 0) + 1
            except (
                Rejected,
                KeyError,
                ValueError,
                TypeError,
                ArithmeticError,
                RecursionError,
            ) as problem:
                bad += 1
                where = (
                    f"{name}, line {certificate.get('line')}" if isinstance(certificate, dict) else name
                )
                print(f"{where}: rejected: {problem!s}")
    without = counts.pop("nothing", 0)
    said = ", ".join(f"{count} by {proof}" for proof, count in sorted(counts.items()))
    verified = f"{sum(counts.values())} verified" + (f" ({said})" if said else "")
    print(f"{verified}, {bad} rejected" + (f"; {without} have no proof to retrace" if without else ""))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
