"""Words that say of which case a formula is: "In series: c = …", then "In parallel: c = …".

The words that open a sentence, an item or a clause name what its formula is of: a beam, a stroke, a way
of counting. Two formulas of one letter whose openings name two things are no two claims of one.
"""

from __future__ import annotations

from symbalance.text import lazy_patterns as re

_OPENS = re.compile(
    r"(?:(?:and|but|while|whereas|und|aber|während|dagegen|et|mais|y|pero|e|ma|now|nun|back|again|zurück|only|nur)\s+)?"
    r"(?P<word>for|at|in|with|on|during|under|after|when|für|fürs|bei|beim|im|in|mit|auf|während|nach|wenn|unter|ist|pour|dans|avec"
    r"|en|à|au|aux|lors|para|con|nel|nella|per|voor|bij|för|vid|dla|przy|při|pro)\s+(?P<words>[^:：,=]{2,80})",
    re.IGNORECASE,
)
_LABEL = re.compile(r"(?P<words>[^:：,=]{2,50}?)[ \t*_}]{0,6}[:：][ \t*_]{0,4}$")
_CASE_BEHIND = re.compile(r"(?P<words>[^:：,、=]{1,24})(?:の場合|のとき|の時|では|に対して)[^=]{0,12}$")
_BEHIND = re.compile(
    r"[\s$)\]}]{0,4}(?:\(|(?:after|according\s+to|for|in|at|with|during|nach|bei|beim|im|für|pour|dans|selon|d'après)\s)"
    r"(?P<words>[^:：,;.=$()]{2,40}?)\)?(?=\s(?:and|or|but|while|und|oder|et|ou)\s|[,;.]|\n\s*\n|\s*\Z)",
    re.IGNORECASE,
)
_NO_THING = re.compile(
    r"(?<![^\W\d_])(?:given|data|find|wanted|sought|solutions?|results?|checks?|summary|conclusions?|notes?|remarks?|answers?"
    r"|steps?|proofs?|hints?|where|so|then|hence|thus|therefore|total|comparison|formulas?|equations?|overview|general\w*|words?"
    r"|short|brief|terms?|units?|numbers?|numerical\w*|brackets?|form|forms|notation|law|laws|rule|rules|theorem"
    r"|identity|identities|definitions?|approximations?|expansions?|substitutions?|help|hand|^(?:this|that|these|those)|both|all"
    r"|each|every|any|same|again|following|sequel|(?:first|second|last)(?=\s*$)|finally|above|below|before|earlier|other|simplicity|example|instance"
    r"|\w{4,}ed(?=\s*$)|simplification|linearization|differentiation|integration|rearrangement|once|alternatively|instead|exactly|approximately|roughly|methods?|means"
    r"|gegeben|gesucht|lösung|ergebniss?e?|probe|kontrolle|schritt\w*|zusammenfassung|bemerkung|hinweis|also|vergleich|allgemein\w*"
    r"|worten?|kürze|zahlen|klammern?|form|satz|regel|\w*formel|\w*gleichung|näherung|hilfe|dies\w*|beid\w*|all\w*|gleich\w*|daraus"
    r"|folgt|folgende\w*|\w{3,}iert|\w*multipli\w*|\w*setz\w*|umgeformt|beispiel\w*|données|résultats?|général|résumé|étape|formule|règle"
    r"|théorème|cela|ceci|datos|resultados?|paso|regla|fórmula|general|esto)(?![^\W\d_])"
    r"|解|答|結果|まとめ|検算|手順|一般|定義|公式|定理|式|展開|代入|整理|この|その|これ|それ|ここ|上記|近似",
    re.IGNORECASE,
)
"""Words by which an opening is of the same thing: a step, a way to work it out, what was said before."""
_STEP = re.compile(
    r"(?!(?:bend|buckl|turn|brak|heat|cool|charg|load|unload|ris|fall|accelerat|decelerat|idl|start|roll|slid)ing\b)\w{3,}ing\b",
    re.IGNORECASE,
)
"""A label that says what was done: expanding, inserting."""
_FOR = re.compile(
    r"^(?:(?:and|but|und|aber|et|mais)\s)?(?:for|für|pour|para|per)\s(?:an?|the|eine?n?|die|das|den|une?|la|le|el|una?|il)\s"
    r"(?P<words>[^:：,=]{2,60})",
    re.IGNORECASE,
)
_SPECIAL = re.compile(
    r"[0-9°<>≤≥≈$\\]"
    r"|(?<![^\W\d_])(?:TDC|BDC|OT|UT|PMH|PMB|dead|cent(?:re|er)s?|\w*totpunkt\w*|points?|limit\w*|small\w*|large\w*|low\w*|high\w*"
    r"|\w*grenzfall|klein\w*|groß\w*|zero|null|speciale?|particul\w+|symmetr\w*|equal|case|fall|cas|caso|whole|total|engine"
    r"|motor|moteur|motore|position|stellung|angle|winkel)(?![^\W\d_])",
    re.IGNORECASE,
)
"""Words of a special case: what is true in general is true there."""
_WORD = re.compile(r"[^\W\d_]{2,}")
_LITTLE = re.compile(
    r"(?:an?|the|of|its|our|is|it|they|we|has|have|gives?|are|be|to|and|or|by|as|one|get|becomes|finds?|obtains?|thus|there|stands"
    r"|reads|holds|gilt|ist|wird|man|er|sie|wir|es|der|die|das|den|dem|des|eine?[nmr]?|und|ergibt|sich|beträgt|lautet|le|la|les"
    r"|une?|du|de|est|on|el|los|las|il|lo|uno|una)",
    re.IGNORECASE,
)
"""Words that name nothing."""
_NAMED = re.compile(
    r"(?:(?:the|der|die|das|la|le)\s+[^\W\d_]{3,20}\s+(?=(?:of|von|de|des|du)\s))?"
    r"(?:(?:now|back|again|for|at|in|with|of|to|on|return(?:ing)?|once\s+more|the|für|bei|beim|im|mit|von|vom|zurück|zu|zum|zur|noch\s+einmal|der|die"
    r"|pour|avec|le|la|de|du|des|para|con|el|per|il)\s+){0,4}"
    r"(?P<noun>engine|motor|moteur|motore|machine|maschine|version|variante?|design|entwurf|option|example|beispiel|exemple|car|bike"
    r"|compressor|verdichter|crankshaft|kurbelwelle|shaft|welle|spring|feder|机|機関|エンジン|ケース)\s?"
    r"(?P<own>[A-H]|[IVX]{1,4}|[0-9]{1,2})(?=\s*[:：,(]|\s*[$\\]|\s+(?:again|has|have|is|gives|hat|ist|gilt|with|mit|we)\b|\s*$|では|の場合)",
    re.IGNORECASE,
)
_AT_VALUE = re.compile(
    r"(?:for|at|with|when|bei|für|mit|pour|à|para|con|per)\s+"
    r"(?P<value>[^:：.;=]{1,30}=[^:：;]{1,40}?)\s*[:：]",
    re.IGNORECASE,
)
_SPLIT = re.compile(r"[.!?]\s+|[;。；]\s*|\n[ \t]*\n|(?<!\\)\\item\b|\n[ \t]*[-*•]\s|\|")
_SENTENCE = re.compile(r"[.!?]\s+|[;。；]\s*|\n[ \t]*\n|(?<!\\)\\item\b|\n[ \t]*[-*•]\s")
_OPENING = " \t\n$\\([{&"
_MARKS = " \t\n$\\([{&*_>#-•,–—"
_CLAUSE = re.compile(
    r",\s+(?:(?:and|but|while|whereas|und|aber|während|et|mais|y|pero|e|ma)\s+)?", re.IGNORECASE
)


REACH = 200
"""Characters before a formula in which its sentence begins."""


def words_of_case(text: str, first: int, start: int, end: int) -> frozenset[str]:
    """Return the words that open what leads to a formula, from a place that is behind the one before.

    >>> page = "In series: c = a. In parallel: c = b."
    >>> sorted(words_of_case(page, 0, 11, 16)), sorted(words_of_case(page, 16, 31, 36))
    (['series'], ['parallel'])
    >>> words_of_case("In general: c = a", 0, 12, 17) or words_of_case("Expanding: c = a", 0, 11, 16)
    frozenset()
    """
    before = _BEHIND.match(text, first) if first else None
    opening = _opening(text, first if before is None else before.end(), start)
    if not opening and (behind := _BEHIND.match(text, end)) is not None:
        opening = behind["words"]
    if _NO_THING.search(opening) is not None:
        return frozenset()
    return _words_of(opening)


def case_named(text: str, start: int, end: int) -> str:
    """Return what names the case that a relation's sentence, item or row is of: "engine a".

    >>> page = "Engine A: r = 40 mm. Back to engine A: 2r = 80 mm. At n = 9 rpm: F = 1"
    >>> case_named(page, 10, 19), case_named(page, 39, 49), case_named(page, 65, 70)
    ('engine a', 'engine a', 'n=9rpm')
    """
    row = text[text.rfind("\n", 0, start) + 1 : start]
    if row.lstrip().startswith("|"):
        lead = row.strip(" |\t").partition("|")[0].strip(" *_") + ":"
    else:
        lead = _SENTENCE.split(text[max(0, start - REACH) : start].rstrip(_OPENING))[-1].lstrip(_MARKS)
    if (named := _NAMED.match(lead)) is not None:
        return f"{named['noun']} {named['own']}".lower()
    if (valued := _AT_VALUE.match(lead)) is not None:
        return re.sub(r"[\s$\\{}]|mathrm|text", "", valued["value"])
    words = (
        words_of_case(text, max(0, start - REACH), start, end) if "=" not in lead else frozenset[str]()
    )
    return " ".join(sorted(words))


def thing_of_case(text: str, first: int, start: int) -> frozenset[str]:
    """Return the words right before a formula that say for which thing it is: for the cantilever it is.

    None of a special case of what was said in general, where that counts too: for small λ, for TDC.

    >>> page = "The load is F = a; for the cantilever it is F = b"
    >>> sorted(thing_of_case(page, 17, 44)), thing_of_case("F = a. For small waves F = b", 5, 23)
    (['cantilever'], frozenset())
    """
    before = text[max(first, start - REACH) : start].rstrip(_MARKS)
    opened = _FOR.search(_CLAUSE.split(_SPLIT.split(before)[-1].lstrip(_MARKS))[-1])
    if opened is None or _SPECIAL.search(opened["words"]) or _NO_THING.search(opened["words"]):
        return frozenset()
    return _words_of(opened["words"])


_OF_THING = re.compile(
    r"(?:(?:and|but|while|whereas|und|aber|während|dagegen|et|mais|y|pero|e|ma|now|nun|again|also|then)\s+)?"
    r"(?:(?:the\s+)?(?:one|ones|that|those|it|der|die|das|celui|celle)\s+)?"
    r"(?:for|at|in|with|without|on|during|under|after|when|if|about|around|round|over|across|along|through|against|behind|before|between"
    r"|für|fürs|bei|beim|im|in|mit|ohne|auf|während|nach|wenn|unter|um|über|quer|längs|entlang|durch|vor|hinter|zwischen"
    r"|pour|dans|avec|sans|en|à|au|aux|sur|lors|autour|suivant|para|con|sin|sobre|alrededor|nel|nella|per|su|intorno)\s+"
    r"(?P<words>[^:：=]{1,100})",
    re.IGNORECASE,
)
"""Words that say of what a formula is: with a 180° crank, about its end, over a whole turn."""
_HAS = re.compile(
    r"(?:(?:and|but|while|whereas|und|aber|während|et|mais|y|e)\s+)?(?P<words>[^:：=]{2,80}?)\s+"
    r"(?:has|have|had|hat|haben|a|ont|tiene|ha|hanno)(?:\s[^:：=]{0,50})?$",
    re.IGNORECASE,
)
"""What has a quantity: six such cylinders have."""
_WHERE = re.compile(
    r"(?<![^\W\d_])(?:without|across|along|under|over|below|above|outside|inside|ohne|quer|längs|entlang|unter|über|außerhalb"
    r"|innerhalb|sans|hors|à travers|sous|sin|senza|fuori)(?![^\W\d_])",
    re.IGNORECASE,
)
"""Words of place that tell two things apart by themselves: along the cylinder, across it."""
FEWEST_WORDS = 3
"""Words of an opening that tell whether it is one of a case."""
_TELLING = re.compile(r"[0-9]+(?:[.,][0-9]+)?|[^\W\d_]{2,}")


def thing_said_anew(
    text: str, before: tuple[int, int], now: tuple[int, int], first: int
) -> frozenset[str]:
    """Return what the words of a formula name that those of the same formula above do not; none for most.

    `before` and `now` are the places of both formulas, `first` where the relation ends before the second.

    >>> page = "For springs in parallel k = a. For springs in series k = a"
    >>> sorted(thing_said_anew(page, (24, 29), (53, 58), 29))
    ['series']
    >>> page = "For springs in parallel k = a. So in parallel k = a"
    >>> thing_said_anew(page, (24, 29), (46, 51), 29)
    frozenset()
    """
    lead = _SPLIT.split(text[max(first, now[0] - REACH) : now[0]].rstrip(_OPENING))[-1].lstrip(_MARKS)
    named = _named_by(lead, _OF_THING, _HAS)
    if _NO_THING.search(" ".join(named.split()[:FEWEST_WORDS])) is not None:
        return frozenset()
    start = max(0, before[0] - REACH)
    above = _SPLIT.split(text[start : before[0]].rstrip(_OPENING))[-1]
    above += " " + re.split(r"[.,;:。]|\n", text[before[1] : now[0]], maxsplit=1)[0]
    apart = telling_words(named) - telling_words(above)
    where = {m[0].lower() for m in _WHERE.finditer(lead)} - {m[0].lower() for m in _WHERE.finditer(above)}
    return apart | where


def telling_words(words: str) -> frozenset[str]:
    """Return the words and numbers that may tell one thing from another.

    >>> sorted(telling_words("the beam has 2 supports"))
    ['2', 'beam', 'supports']
    """
    return frozenset(w.lower() for w in _TELLING.findall(words) if not _LITTLE.fullmatch(w))


_LINE_LABEL = re.compile(r"[ \t>*•·–-]*(?P<words>[^=:：\n]{1,40}?)[ \t*_]{0,4}[:：][\s$*_\\({[]{0,8}$")
"""The words before a colon that a formula's line opens with: long rod:"""
_LABEL_IN_WORDS = re.compile(
    r"(?:the|die|der|das|la|le|il|el)\s+(?P<words>[^\W\d_]{3,20}\s+(?:one|formula|expression|value|result|series|method|model"
    r"|formel|näherung|reihe|rechnung|formule|valeur|série|formula|valore))\s+"
    r"(?:(?:gives?|yields?|is|says?|gibt|liefert|ergibt|donne|dà|da)\s+)?[\s$\\(]*$",
    re.IGNORECASE,
)
"""Which of two ways to it a value is by: the exact one gives x = 48.0, and the short one x = 47.9."""
_LABEL_BEHIND = re.compile(
    r"[\s$)\]}]{0,4}(?:\(|(?:for|at|with|bei|beim|für|mit|pour|avec|para|con|per)\s)(?:(?:the|an?|der|die|das|dem|le|la)\s)?"
    r"(?P<words>[^:：,;=$()\n]{2,30}?)\)?(?=\s(?:and|or|but|while|und|oder|et|ou|y|e)\s|[,;]|\.(?:\s|$)|\n|\s*\Z)",
    re.IGNORECASE,
)
"""What a formula is said to be of right behind it: (crank pin), for the 6.00."""
_TOKEN = re.compile(r"[0-9]+(?:[.,][0-9]+)?|[^\W\d_]+|[\"″'′%°]")
_WAY = re.compile(
    r"(?:by|from|using|via|per|aus|durch|nach|mittels|selon|d'après|según|secondo)\s", re.IGNORECASE
)
"""A label that says by what a value is found: two ways to one thing."""


def label_beside(text: str, start: int, end: int) -> tuple[str, ...]:
    """Return the words and numbers of the label that a formula's line opens with, or right behind it.

    >>> page = "long rod:   b = 16.9 deg for the 6.00, a"
    >>> label_beside(page, 12, 24), label_beside(page[12:], 0, 12)
    (('long', 'rod'), ('6.00',))
    """
    line = text[text.rfind("\n", 0, start) + 1 : start]
    label = _LABEL_IN_WORDS.search(text, max(0, start - REACH), start)
    label = label or _LINE_LABEL.fullmatch(line) or _LABEL_BEHIND.match(text, end)
    if label is None or _WAY.match(label["words"]):
        return ()
    return tuple(token.lower() for token in _TOKEN.findall(label["words"]))


def are_labels_of_a_kind(first: tuple[str, ...], second: tuple[str, ...]) -> bool:
    """Tell whether two labels tell apart two things of one kind: short rod, long rod; 5.70", 6.00".

    >>> are_labels_of_a_kind(("short", "rod"), ("long", "rod")), are_labels_of_a_kind(("rod",), ("pin",))
    (True, False)
    """
    if len(first) != len(second) or first == second:
        return False
    apart = [(a, b) for a, b in zip(first, second, strict=True) if a != b]
    shared = [a for a, b in zip(first, second, strict=True) if a == b and not _NO_THING.search(a)]
    are_numbers = all(a[0].isdecimal() and b[0].isdecimal() for a, b in apart)
    is_count = all(len(a) == len(b) == 1 for a, b in apart) and not shared  # 1: and 2: of a list
    return len(apart) == 1 and not is_count and (are_numbers or bool(shared))


def are_two_cases(first: frozenset[str], second: frozenset[str]) -> bool:
    """Tell whether two openings each have a word of their own: low speed, high speed."""
    return bool(first - second) and bool(second - first)


def _words_of(opening: str) -> frozenset[str]:
    return frozenset(w.lower() for w in _WORD.findall(opening) if not _LITTLE.fullmatch(w))


def _opening(text: str, first: int, start: int) -> str:
    """Return the words by which a formula's sentence, item or clause names a case, or ""."""
    before = text[max(first, start - REACH) : start].rstrip(_OPENING)
    return _named_by(_SPLIT.split(before)[-1].lstrip(_MARKS), _OPENS)


def _named_by(lead: str, *openings: re.Pattern[str]) -> str:
    """Return the words behind one of several openings of a clause or sentence, or those of a label."""
    for part in (_CLAUSE.split(lead)[-1], lead):
        for pattern in openings:
            if (opened := pattern.match(part)) is not None:
                return opened["words"]
    for pattern in (_CASE_BEHIND, _LABEL):
        if (label := pattern.match(lead)) is not None:
            return "" if _STEP.match(label["words"]) else label["words"]
    return ""
