"""Relations that a page itself calls wrong: "the textbook's v = s n is wrong; v = 2 s n".

They are no definitions, and what they say is not claimed.
"""

from __future__ import annotations

from symbalance.text import lazy_patterns as re

_THAT = (
    r"(?:that|to\s+(?:write|set|say|put|use|take|assume)|dass|zu\s+(?:schreiben|setzen|sagen)"
    r"|que|qu'|che|,)"
)
_BEFORE = re.compile(
    r"(?<![^\W\d_])(?:"
    rf"(?:it\s+(?:is|was|would\s+be)|es\s+(?:ist|wäre)|il\s+(?:est|serait)|è|sarebbe|es|sería)\s+(?:simply\s+|quite\s+|einfach\s+)?"
    rf"(?:false|wrong|incorrect|not\s+(?:true|correct|right|the\s+case)|a\s+mistake|falsch|unrichtig|nicht\s+(?:wahr|richtig)|faux|incorrect"
    rf"|falso|sbagliato|errato|incorrecto|erróneo)\s*,?\s*{_THAT}"
    r"|(?:do|does|must|should|may|can|we|you)\s?n[o']t\s+(?:write|use|set|put|take|have)"
    r"|(?:one|you)\s+(?:might|may|could|would)\s+(?:think|expect|believe|guess|be\s+tempted\s+to\s+write)(?:\s+that)?"
    r"|man\s+(?:könnte|möchte|würde)\s+(?:meinen|glauben|denken|erwarten)\s*,?\s*(?:dass)?"
    r"|on\s+pourrait\s+(?:croire|penser)\s+que|si\s+potrebbe\s+(?:credere|pensare)\s+che"
    r"|I\s+(?:first|had\s+first|originally|initially|wrongly)\s+(?:wrote|had|written|thought|took|assumed|used)"
    r")[\s$:\\({[]*$"
    r"|(?:\A|[.;:!?。]\s|\n)\s*(?:instead\s+of|(?:an)?statt|anstelle\s+von|au\s+lieu\s+de|invece\s+di|in\s+luogo\s+di|en\s+(?:lugar|vez)\s+de)[\s$:\\({[]*$",
    re.IGNORECASE,
)
"""Before a relation that is not claimed. 888 N instead of 3609 N compares two that are."""
_WRONG = (
    r"(?:wrong|false|incorrect|erroneous|nonsense|not\s+(?:true|correct|right)|(?:a|an)\s+(?:common\s+)?(?:mistake|misprint|slip|typo|error|blunder)"
    r"|falsch|unrichtig|nicht\s+(?:richtig|wahr)|ein\s+(?:häufiger\s+)?(?:fehler|irrtum|druckfehler|tippfehler)"
    r"|faux|fausse|erronée?|incorrecte?|une\s+erreur|falso|falsa|sbagliat[oa]|errat[oa]|un\s+errore|incorrect[oa]|erróne[oa])"
)
_BEHIND = re.compile(
    r"[\s$)}\]\\]{0,6}(?:,?\s?(?:which|that|but\s+(?:this|that|it)|this|was|das|dies|ce\s+qui|il\s+che|lo\s+que)\s)?\s{0,2}"
    rf"(?:(?:is|was|would\s+be|ist|wäre|war|est|était|è|era|es)\s+(?:(?:of\s+course|simply|clearly|plainly|obviously|quite|natürlich|schlicht|einfach|bien\s+sûr)\s+)?{_WRONG}"
    r"(?!\s+(?:by|of|von|um|de|d['’]|di|in\s+general|at|when|if|unless|only|for\s(?:all|any|every|large|small)))(?![^\W\d_])"
    r"|(?:does\s?n[o']t|do\s+not|cannot)\s+hold(?!\s+(?:in\s+general|for|at|when|if|unless|only))(?![^\W\d_])"
    r"|(?:gilt|stimmt)\s+(?:hier\s+|so\s+)?nicht(?!\s+(?:für|im|bei|wenn|immer|allgemein))(?![^\W\d_])"
    r"|(?:must|has\s+to|should|is\s+to|ought\s+to)\s+be\s+(?:replaced|corrected)(?![^\W\d_])"
    r"|(?:muss|ist)\s+durch\s[^.;!?]{1,60}?(?:zu\s+ersetzen|ersetzt\s+werden|zu\s+korrigieren)(?![^\W\d_])"
    r"|(?:は|が)(?:誤り|間違い|間違って|正しくない|成り立たない|誤って)|ではない|とはならない)",
    re.IGNORECASE,
)
"""Behind a relation that the page calls wrong."""
_NOT_ALWAYS = re.compile(
    r"[\s$)}\]\\]{0,6}(?:,?\s?(?:which|but\s+(?:this|it)|was|das|dies|ce\s+qui|il\s+che)\s)?\s{0,2}"
    r"(?:(?:(?:is|are|ist|est|è|es)\s+(?:not|nicht|pas|non|no)\s+(?:true|right|correct|valid|wahr|richtig|gültig|vrai|vera?|verdad)"
    r"|(?:does\s?n[o']t|do\s+not)\s+hold|fails|gilt\s+nicht|versagt|n'est\s+pas\s+vrai)\s+"
    r"(?:in\s+general|always|generally|for|at|when|if|beyond|above|below|immer|allgemein|im\s+allgemeinen|für|bei|wenn|en\s+général|pour)"
    r"|,?\s*(?:only\s+(?:if|when|for|where)|nur\s+(?:wenn|für|falls)|seulement\s+si|solo\s+se|sólo\s+si)(?![^\W\d_]))"
    r"|[\s$)}\]]{0,4}(?:は|が)(?:一般に|常に)(?:は)?(?:成り立たない|正しくない)",
    re.IGNORECASE,
)
"""Behind a relation that is said not to hold of everything: sin 2x = 2 sin x is not true in general."""
_NEVER_BEFORE = re.compile(
    r"(?<![^\W\d_])(?:it\s+is\s+never\s+(?:so|true|the\s+case)\s+that|(?:it\s+)?never\s+happens\s+that|never\s+is|it\s+is\s+impossible\s+that"
    r"|es\s+gilt\s+nie(?:mals)?|nie(?:mals)?\s+(?:ist|gilt)|jamais|on\s+n'a\s+jamais|non\s+è\s+mai|mai|nunca(?:\s+es)?)[\s$:\\({[]*$",
    re.IGNORECASE,
)
_NEVER_BEHIND = re.compile(
    r"[\s$)}\]\\]{0,6}(?:(?:is|are|ist|est|è|es)\s+(?:impossible|unmöglich|imposible|impossibile|never\s+(?:true|so|possible))"
    r"|never\s+(?:happens|occurs)|(?:cannot|can\s+never)\s+(?:be|happen|occur)|tritt\s+nie\s+auf|(?:は|が)?(?:あり得ない|ありえない))"
    r"(?![^\W\d_])(?!\s+(?:for|if|when|at|für|wenn|pour|si))",
    re.IGNORECASE,
)
"""Around an inequality that is said to be true nowhere."""
REACH = 90
"""Characters around a relation that are looked at."""


def is_said_wrong(text: str, start: int, end: int) -> bool:
    """Tell whether the words around a relation, from `start` to `end`, call it wrong.

    >>> is_said_wrong("The book's v = s n is wrong.", 11, 18), is_said_wrong("So v = 2 is right.", 3, 8)
    (True, False)
    >>> is_said_wrong("It is false that v = s n.", 17, 24), is_said_wrong("v = 8 is wrong by 2 %", 0, 5)
    (True, False)
    """
    before = text[max(0, start - REACH) : start]
    return _BEFORE.search(before) is not None or _BEHIND.match(text[end : end + REACH]) is not None


def is_said_not_always(text: str, end: int) -> bool:
    """Tell whether the words behind a relation say that it does not hold of everything.

    >>> is_said_not_always("a = b is not true in general", 5), is_said_not_always("a = b is not true", 5)
    (True, False)
    """
    return _NOT_ALWAYS.match(text, end, end + REACH) is not None


def is_said_never(text: str, start: int, end: int) -> bool:
    """Tell whether the words around a relation say that it is true nowhere.

    >>> is_said_never("It is never so that y > 1.", 20, 25), is_said_never("y > 1 is impossible.", 0, 5)
    (True, True)
    """
    before = text[max(0, start - REACH) : start]
    return (
        _NEVER_BEFORE.search(before) is not None
        or _NEVER_BEHIND.match(text, end, end + REACH) is not None
    )
