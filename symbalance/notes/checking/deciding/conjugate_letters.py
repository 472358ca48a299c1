"""A letter with a bar as the conjugate of the complex number that the letter is: Re z = (z + z̄)/2.

A bar may mean a mean value or just another letter. It is the conjugate where the letter below has a
value that is not real, or stands under Re, Im or arg beside it.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Call, Name, names
from symbalance.notes.algebra.conjugation import imaginary_part
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.declared.symbol_roles import conjugate_name
from symbalance.notes.reading.equations import Chain

_OF_COMPLEX = ("re", "im", "arg", "conj")
_BAR = conjugate_name("")


def with_conjugates(chain: Chain, knowledge: Knowledge) -> Knowledge:
    """Return what is known with the conjugates of complex letters among a relation's sides."""
    letters = chain.letters
    calls = [call.argument for call in chain.calls if call.function in _OF_COMPLEX]
    barred = [name for name in sorted(letters) if name.startswith(_BAR) and not knowledge.knows(name)]
    for name in barred:
        base = name.removeprefix(_BAR)
        if name in knowledge.meanings:
            continue
        if base in knowledge.definitions and _is_complex(base, knowledge):
            definition = Definition(Call("conj", Name(base)), chain.lines[0])
            knowledge = knowledge.with_definition(name, definition)
        elif any(base in names(inside) for inside in calls):
            knowledge = _as_complex(base, knowledge)
    for inside in calls:
        if isinstance(inside, Name) and (
            conjugate_name(inside.name) in letters or Call("conj", inside) in chain.calls
        ):
            knowledge = _as_complex(inside.name, knowledge)
    return knowledge


def _as_complex(name: str, knowledge: Knowledge) -> Knowledge:
    """Return what is known with a letter that nobody declared nor defined as that of a complex number."""
    meaning = knowledge.meaning
    if name in knowledge.meanings or knowledge.has_meaning(name) or name in meaning.complex:
        return knowledge
    values = {**meaning.values, conjugate_name(name): Call("conj", Name(name))}
    meaning = replace(meaning, complex=meaning.complex | {name}, values=values)
    return replace(knowledge, meaning=meaning)


def _is_complex(name: str, knowledge: Knowledge) -> bool:
    """Tell whether a letter's value is a number, or a formula, with an imaginary part."""
    level = list(knowledge.levels(Name(name)))[-1]
    try:
        return not imaginary_part(knowledge.evaluator(level).form(Name(name))).is_zero()
    except (NoFormError, TooLargeError, ZeroDivisionError):
        return False
