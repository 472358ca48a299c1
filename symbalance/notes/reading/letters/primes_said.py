"""What a page says its primes stand for: "a prime denotes d/dθ", "Striche sind Ableitungen nach φ".

A prime is a mark like any other elsewhere, J' = J + m r². Where one sentence has both the word for it and
a derivative by a letter, in either order, every letter with primes is that derivative.
"""

from __future__ import annotations

from symbalance.notes.reading.letters.macro_letters import letter_in
from symbalance.text import lazy_patterns as re

_PRIME = re.compile(
    r"(?<![A-Za-z])(?:primes?|dash(?:es)?|apostrophes?|Strich(?:e[ns]?)?|Apostrophs?|apic[ei]|apóstrofos?"
    r"|comillas?|accents?|plica|pliche|primas?)(?![A-Za-z])|プライム|ダッシュ|(?<![A-Za-z0-9}′'])[′'’](?=\s?[)»”]|\s?は|\$|\s?=)"
    r"|\\prime",
    re.IGNORECASE,
)
_LETTER = r"(?P<letter{}>\\[A-Za-z]+(?![A-Za-z])|[A-Za-zα-ωϑϕ](?![A-Za-z]))"
_DOLLAR = r"(?:\$|\\\(|<math>|''|\s){0,3}"
_BY = (
    rf"(?:d|\\(?:mathrm|text)\s?\{{d\}}|∂|\\partial)\s?/\s?(?:\\,)?(?:d|\\(?:mathrm|text)\s?\{{d\}}|∂|\\partial)\s?{_LETTER.format(1)}",
    r"\\[dt]?frac\s?\{\s?(?:d|\\(?:mathrm|text)\s?\{d\}|\\partial)\s?\}\s?"
    rf"\{{\s?(?:d|\\(?:mathrm|text)\s?\{{d\}}|\\partial)\s?{_LETTER.format(2)}",
    r"(?:derivatives?|differentiation)\s+(?:with\s+respect\s+to|w\.?\s?r\.?\s?t\.?|by|in)\s+"
    rf"(?:the\s+)?(?:crank\s+|rotation\s+)?(?:angle\s+)?{_DOLLAR}{_LETTER.format(3)}",
    rf"(?:Ableitung(?:en)?|Differentiation)\s+nach\s+(?:(?:dem\s+)?\w*[Ww]inkel\s+)?{_DOLLAR}{_LETTER.format(4)}",
    rf"dériv(?:ées?|ation)\s+par\s+rapport\s+à\s+(?:l['’]angle\s+(?:\w+\s+){{0,2}})?{_DOLLAR}{_LETTER.format(5)}",
    r"deriva(?:t[ae]|zione)\s+rispetto\s+(?:ad?|all['’]angolo(?:\s+di\s+manovella)?)\s+"
    rf"{_DOLLAR}{_LETTER.format(6)}",
    r"(?:derivadas?|derivación)\s+(?:con\s+)?respecto\s+(?:de|al?)\s+(?:ángulo\s+(?:del?\s+\w+\s+)?)?"
    rf"{_DOLLAR}{_LETTER.format(7)}",
    rf"{_LETTER.format(8)}{_DOLLAR}(?:に関する|による|での?|についての)\s?微分",
)
_DERIVATIVES = tuple(re.compile(pattern, re.IGNORECASE) for pattern in _BY)
_SENTENCE = re.compile(r"[.!?。;](?:\s|$)|\n\s*\n|[()（）](?=[^()（）]{0,200}\n)|。")
_LONGEST = 240


def variable_of_primes(text: str) -> str:
    r"""Return the letter by which a page says that its primes are derivatives, "" where it says none.

    >>> variable_of_primes(r"(a prime denotes $d/d\theta$)"), variable_of_primes("the prime mover")
    ('theta', '')
    >>> variable_of_primes("Striche sind Ableitungen nach $x$.")
    'x'
    >>> variable_of_primes("プライムはθによる微分")
    'theta'
    """
    if _PRIME.search(text) is None:
        return ""
    found: set[str] = set()
    for sentence in _SENTENCE.split(text):
        if _PRIME.search(sentence) is None or len(sentence) > _LONGEST:
            continue
        for pattern in _DERIVATIVES:
            for match in pattern.finditer(sentence):
                spelling = next(own for own in match.groups() if own)
                name = letter_in(text, spelling)
                found |= {name} if name else set()
    return found.pop() if len(found) == 1 else ""
