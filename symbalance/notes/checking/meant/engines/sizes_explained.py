"""Words that say of which size a letter is, and nothing of the force: "m is the mass of one cylinder".

A force or couple of a whole engine is told apart from one cylinder's by words such as "per cylinder" and
"each". Those that go with a mass say so of the mass alone: it is one cylinder's in a formula of all.
"""

from __future__ import annotations

from symbalance.text import lazy_patterns as re

_MASS = r"(?:mass(?:es)?|kg|reciprocating|oscillating|oszillierend\w*|masse[ns]?|masas?|massa|質量)"
_PIECE = r"(?:cylind\w+|pistons?|zylinders?|kolbens?|cilindr\w+|pist[oó]n\w*|unit|motor|engine)"
_OF_ONE = (
    r"(?:(?:of|per|for|in|on|at|je|pro|für|eines|einer|jedes|jeder|d['’]un|de\s+chaque|de\s+cada|par|por"
    r"|de\s+un|di|per|di\s+ciascun|di\s+ogni|del\s+singolo|de|du)(?![a-zà-ü])['’]?\s*(?:\w+\s+){0,3}?"
    rf"{_PIECE}(?![a-zà-ü])"
    r"|each(?!\s+of)\b|apiece|jeweils|je(?=\s*[,.;:)]|\s*$)|chacune?|cada\s+un[ao]|ciascun[ao])"
)
_LETTER = r"\$?\\?\(?\s?\\?[mM](?:_\{?\\?[\w,]+\}?|_\{\\(?:mathrm|text|rm)\s?\{?\w+\}?\})?\s?\\?\)?\$?"
_MASSES = re.compile(
    rf"(?<![a-zà-ü]){_MASS}(?![a-zà-ü])[^.;:=\n]{{0,50}}?(?<![a-zà-ü]){_OF_ONE}"
    rf"|(?<![A-Za-z\\]){_LETTER}\s+(?:is\s+|ist\s+)?(?:the\s+)?{_OF_ONE}"
    rf"|\beach\s+(?:\w+\s+){{0,2}}?(?:with|of|having|has)\s+(?:\w+\s+){{0,3}}?{_MASS}(?![a-zà-ü])"
    rf"|(?:\bhat\s+)?\bjeder\s+(?:\w+\s+)?(?:hat\s+)?(?:\w+\s+){{0,2}}?{_MASS}(?![a-zà-ü])"
    rf"|\b(?:chaque|ogni|cada)\s+\w+\s+(?:a|ha|tiene)\s+(?:\w+\s+){{0,2}}?{_MASS}(?![a-zà-ü])"
    rf"|\b(?:each|every)\s+{_PIECE}\s+(?:has|moves|carries)\s+(?:the|a|an|its)\s+(?:own\s+)?(?:\w+\s+){{0,2}}?"
    rf"{_MASS}(?![a-zà-ü])"
    r"|\bjeder\s+(?:zylinder|kolben)\s+hat\s+(?:die|eine)\s+(?:\w+\s+){0,2}?masse(?![a-zà-ü])"
    r"|\bchaque\s+(?:cylindre|piston)\s+a\s+(?:la|une)\s+masse(?![a-zà-ü])"
    r"|\b(?:ogni|ciascun)\s+(?:cilindro|pistone)\s+ha\s+(?:la|una)\s+massa(?![a-zà-ü])"
    r"|\bcada\s+(?:cilindro|pist[oó]n)\s+tiene\s+(?:la|una)\s+masa(?![a-zà-ü])"
    r"|\b(?:each|every\s+one)\s+with\s+(?:the|an?)\s+(?:force\s+)?amplitude\s+\$[^$]{1,60}\$"
    rf"|(?:1|一|各|単)\s?(?:気筒|シリンダ)(?:あたり|当たり|当り|分)?(?:の)?[^。、\n]{{0,10}}?質量"
    rf"|(?:往復|運動)[^。、\n]{{0,6}}質量[^。、\n]{{0,14}}(?:1|一|各)\s?(?:気筒|シリンダ)(?:あたり|当たり|当り)?",
    re.IGNORECASE,
)
_EXPLAINED = re.compile(
    r"\b(?:where|wherein|when(?=\s+\$[^$=]{1,12}\$\s+(?:is|denotes)))\s+(?=\$|\\\(|`|\\?[^\W\d_](?:_\w+)?\s+(?:is|denotes|being)\b)",
    re.IGNORECASE,
)
_RATIO = re.compile(
    r"(?:(?:crank|rod)[\s-]+)?(?:ratio|verhältnis|rapport|rapporto|relación|cociente|quotient)\s[^.;:=\n]{0,40}?"
    r"(?:rod|pleuel\w*|stange\w*|bielle|biela|biella)(?![a-z])(?:[\s-]*(?:length|länge))?"
    r"|(?:connecting[\s-]+)?rods?\s+(?:length|ratio)|pleuel(?:stangen)?(?:länge|verhältnis)"
    r"|longueur\s+de\s+(?:la\s+)?bielle|lunghezza\s+d(?:i|ella)\s+biella|longitud\s+de\s+(?:la\s+)?biela",
    re.IGNORECASE,
)
_YET_UNBALANCED = re.compile(
    r"(?:\bleft\s+(?:over\s+)?)?\b(?:before|without|unless|ohne|vor|sans|avant|senza|prima\s+d\w+|sin"
    r"|antes\s+de)\s+(?:\w+\s+){0,2}?"
    r"(?:counter-?weight\w*|balanc\w+|gegengewicht\w*|ausgleich\w*|contrepoids|[ée]quilibr\w+|contrapp?es\w*)"
    r"|\bcan\s+(?:\w+\s+){0,2}?be\s+(?:\w+\s+)?(?:cancel\w+|balanced|compensated|removed|eliminated)[^.;=\n]*"
    r"|(?:lässt|lassen)\s+sich\s[^.;=\n]*(?:ausgleichen|aufheben|beseitigen)"
    r"|\bkann\s[^.;=\n]*(?:ausgeglichen|aufgehoben)\s+werden"
    r"|(?:peut|peuvent)\s+(?:\w+\s+){0,2}?être\s+(?:équilibré|compensé|annulé)\w*[^.;=\n]*"
    r"|(?:può|possono)\s+(?:\w+\s+){0,2}?essere\s+(?:equilibrat|annullat|compensat)\w*[^.;=\n]*"
    r"|pued\w+\s+(?:\w+\s+){0,2}?(?:equilibrar|compensar|anular)\w*[^.;=\n]*"
    r"|(?:釣り?合い?おもり|カウンタ\w*|バランサ\w*)(?:で|により|によって)[^。\n]{0,12}(?:消|釣り?合)\w*(?:できる|られる)",
    re.IGNORECASE,
)
"""Words for what an engine's cylinders do before anything balances it, or for what may balance it."""


def without_balance_to_come(words: str) -> str:
    """Return words without those of a balance that is not there yet: "before counterweighting".

    >>> without_balance_to_come("the couple left before counterweighting is")
    'the couple  is'
    """
    return _YET_UNBALANCED.sub("", words)


def without_masses_of_one(words: str) -> str:
    """Return words without those that say which mass goes with one cylinder.

    >>> without_masses_of_one("for the reciprocating mass $m$ per cylinder it is")
    'for the   it is'
    >>> without_masses_of_one("the force per cylinder is")
    'the force per cylinder is'
    """
    return _MASSES.sub(" ", words)


def without_letters_explained(words: str) -> str:
    """Return words without a "where" that only explains a letter, and without the ratio of the rod.

    >>> without_letters_explained("where $m$ is the mass"), without_letters_explained("where it turns")
    ('$m$ is the mass', 'where it turns')
    """
    return _RATIO.sub(" ", _EXPLAINED.sub("", words))
