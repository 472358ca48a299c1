"""Words that open a case (for θ = 0), that end every case (in general), and that name an engine.

A case is a value or a range that holds where its sentence says so: the next case takes its place, and
what a page says of all values, or of any, does not rest on it.
"""

from __future__ import annotations

from bisect import bisect_right

from symbalance.notes.checking.words.glossary import glossary_of
from symbalance.text import lazy_patterns as re

_END = r"\s[^.;:!?\n=<>≤≥]{0,30}$"
_CASE = re.compile(
    r"(?<![A-Za-z])(?:for|if|when|whenever|where|at|only for|provided(?:\s+that)?"
    rf"|as\s+(?:long|soon)\s+as|sobald|dès\s+que|non\s+appena|tan\s+pronto\s+como|in\s+the\s+case|für|bei|falls|wenn|sofern|solange|im\s+Fall|pour|si(?!\s+(?:ha|ottiene|ricava|trova|vede|tiene|obtiene|encuentra)(?![^\W\d_]))"
    r"|lorsque|quand|para|cuando|per|quando|voor|bij|wanneer|för|vid|när|dla|przy|gdy|při|když"
    rf"|(?:da|alcanza|ocurre|produce|máxim[oa])\s+en|(?:^|[.:]\s)en){_END}|(?:もし|仮に)[^。、]{{0,12}}$",
    re.IGNORECASE,
)
_CASE_BEHIND = re.compile(r"[\s$)\]}\\,]{0,6}(?:なら|のとき|の時|の場合|では(?!な))")
_EXCEPTION = re.compile(
    r"[\s$)}\],\\]{0,6}(?:unless|except(?:\s+(?:if|when|where|for))?|save\s+(?:when|for)|but\s+for"
    r"|außer(?:\s+(?:wenn|für|bei|falls))?|es\s+sei\s+denn|sofern\s+nicht|wenn\s+nicht|falls\s+nicht"
    r"|sauf(?:\s+(?:si|pour))?"
    r"|salvo|a\s+meno\s+che|excepto|if\s+\S{1,12}\s+is\s+(?:not|no)\s)(?![A-Za-z])"
    r"|[\s$)}\]、]{0,6}(?:ただし|を除)",
    re.IGNORECASE,
)
_TAG = re.compile(r"</?[A-Za-z][^<>]*>")
_BETWEEN = re.compile(r"[\s$,)}\]°]*(?:[^\W\d_]+\s+){1,3}[\s$({\[\\]*")
_PLACE_BEHIND = re.compile(r"[$)}\]°]{0,4}\.?,?\s[\s$]{0,4}(?:at|for|bei|für|pour)\s[\s$({\[\\]{0,6}")
LONGEST_PLACE = 24
"""Characters between a value and the place where it is had, and a few more."""
_CLAUSE_LAST = re.compile(r"[\s$)}\]°]*(?:[.;。]|\n\s*\n|\Z)")
_CLAUSE = re.compile(
    r"[.!?]\s|[;。；]|\n\s*\n|,\s+(?:but|aber|jedoch|mais|ma|pero)(?=[\s$])", re.IGNORECASE
)
_GENERAL = re.compile(
    r"(?<![A-Za-zÀ-ÿ\\])(?:always|in\s+general|generally|everywhere|elsewhere|otherwise"
    r"|at\s+all\s+times|at\s+any\s+time"
    r"|in\s+(?:every|any|all|each)\s+(?:other\s+)?(?:positions?|cases?)|allgemein|im\s+allgemeinen"
    r"|immer|stets|überall"
    r"|andernfalls|sonst|in\s+jeder\s+(?:Stellung|Lage))(?![A-Za-zÀ-ÿ])"
    r"|一般に|一般には|常に|つねに|いつも|それ以外",
    re.IGNORECASE,
)
_ALWAYS_BEHIND = re.compile(
    r"[\s$)}\]\\,]{0,6}(?:\\text\s*\{\s*)?(?:(?:holds?|is\s+true|gilt|is\s+valid)\s+)?(?:always"
    r"|at\s+all\s+times"
    r"|at\s+any\s+time|immer|stets|everywhere|identically|for\s+(?:all|every"
    r"|any)\s+(?:crank\s+)?(?:angles?|positions?|values?)"
    r"|für\s+(?:alle|jeden)\s+(?:Kurbel)?[Ww]inkeln?)(?:\s+(?:holds?|true|vanishes))?(?=\s*[.,;:)}\]$]"
    r"|\s*$)"
    r"|[\s$)}\]]{0,4}(?:は|が)?(?:常に|つねに|いつも)(?:成り立つ|成立)",
    re.IGNORECASE | re.MULTILINE,
)
_ALWAYS = re.compile(
    r"(?<![A-Za-zÀ-ÿ\\])(?<!not )(?<!nicht )(?<!pas )(?<!non )(?<!no )(?:always|at\s+all\s+times"
    r"|in\s+(?:every|any|all|each)\s+cases?|without\s+exception|immer|stets|in\s+jedem\s+Fall|toujours|en\s+tout\s+cas"
    r"|at\s+(?:every|any|all|each)\s+(?:crank\s+)?(?:angles?|positions?)|bei\s+jedem\s+(?:Kurbel)?winkel"
    r"|in\s+jeder\s+(?:Kurbel)?stellung|à\s+tout\s+(?:angle|instant)|per\s+ogni\s+angolo|para\s+todo\s+ángulo"
    r"|sempre|in\s+ogni\s+caso|siempre|en\s+todo\s+caso)(?![A-Za-zÀ-ÿ])|常に|つねに|いつも|必ず"
    r"|(?<![A-Za-zÀ-ÿ\\])(?:never|nie|niemals|jamais|nunca|non\s+\w+\s+mai)\s[^:.;]{1,60}[:：][\s$\\(\[]*$",
    re.IGNORECASE,
)
"""Words that make an inequality a claim, of all that it can be said of."""
_OF_ALL = (
    r"(?<![A-Za-zÀ-ÿ\\])(?:(?:for\s+|at\s+)?(?:all|every|any|arbitrary|each)|für\s+(?:alle|jede[nsrm]?"
    r"|beliebige[nsrm]?)|beliebige[snrm]?|pour\s+tou(?:te?s?)|quel(?:le)?s?\s+que\s+soi(?:en)?t|per\s+(?:ogni|tutt[ie])"
    r"|para\s+tod[oa]s?)"
    r"(?:\s+other)?\s+(?:(?:real|integers?|whole|natural|complex|numbers?|reellen?|ganzen?|natürlichen?"
    r"|Zahlen?|values?"
    r"|angles?|crank\s+angles?|Werte?|Winkel|(?:Kurbel)?[Ww]inkel|of)\s+){0,3}"
    r"|(?:任意の|すべての|全ての|あらゆる)\s*"
)
_ALL = re.compile(_OF_ALL, re.IGNORECASE)
_CLAIM = re.compile(
    r"(?:[\s$,:、]|(?<![^\W\d_])(?:we|one|it|that|have|has|holds?|is|true|then|clearly|obviously|gilt|ist|dann|stets|on|a|si|ha|vale|se|tiene)"
    r"(?![^\W\d_])|について|に対して|では|で)*",
    re.IGNORECASE,
)
_RIGHT_OF_ALL = re.compile(
    r"(?<![^\W\d_])(?:(?:for|at)\s+(?:all|every|any|each)|für\s+(?:alle|jede[nsrm]?|beliebige[nsrm]?)|pour\s+tou[ts]\w*|per\s+ogni|para\s+todo\w*)"
    r"(?:\s+(?:real|numbers?|integers?|reellen?|ganzen?|natürlichen?|Zahlen?|réels?|entiers?|values?\s+of|Werte))*$|(?:任意の|すべての|全ての)$",
    re.IGNORECASE,
)
_FOR_ALL_BEHIND = re.compile(
    r"[\s$)}\]\\,]{0,6}(?:\\text\s*\{\s*)?(?:(?:holds?|is\s+(?:true|zero)|gilt|is\s+valid|valid|vanish(?:es)?"
    r"|verschwindet)\s+)?(?=(?:for|für)\s+(?:all|every|any|arbitrary|each|alle|jede[nsrm]?|beliebige[nsrm]?)\s)",
    re.IGNORECASE,
)
_OF_ANY_SIGN = re.compile(
    r"(?<![A-Za-z])(?:(?:any|either|arbitrary|both)\s+signs?|beliebige[nrs]?\s+Vorzeichens?"
    r"|(?:positive\s+or\s+negative|positiv\s+oder\s+negativ"
    r"|positive[nrsm]?\s+oder\s+negative[nrsm]?))(?![A-Za-z])",
    re.IGNORECASE,
)
_OF_ANY_SIGN_BEHIND = re.compile(
    r"[\s$)}\],]{0,6}(?:(?:holds?|is\s+(?:true|valid|right)|gilt|vaut|vale|est\s+vrai)\s+)?(?:(?:regardless|irrespective|independent(?:ly)?)\s+of\s+(?:the\s+)?signs?"
    r"|(?:whatever|no\s+matter\s+what)\s+(?:the\s+)?signs?|unabhängig\s+vom\s+Vorzeichen|bei\s+jedem\s+Vorzeichen|quel\s+que\s+soit\s+le\s+signe"
    r"|indépendamment\s+du\s+signe|indipendentemente\s+dal\s+segno|sea\s+cual\s+sea\s+el\s+signo|(?:also\s+|auch\s+|aussi\s+|anche\s+|también\s+)?"
    r"(?:even\s+)?(?:for|für|bei|pour|per|para)\s+(?:negative[nrsm]?|négati(?:f|ve)s?|negativ[oiae]s?)(?![^\W\d_])|(?:on|over|during|in)\s+(?:the\s+)?(?:whole|full|entire)\s+"
    r"(?:circle|turn|revolution|cycle)|(?:auf|über|im)\s+(?:dem\s+|den\s+|der\s+)?(?:ganze[nrm]?|gesamten|voll[en]+)\s+(?:Kreis|Umlauf|Umdrehung)"
    r"|sur\s+(?:tout\s+le\s+(?:cercle|tour)|un\s+tour\s+entier)|su\s+tutto\s+il\s+(?:cerchio|giro)|en\s+toda\s+la\s+(?:vuelta|circunferencia))"
    r"|[\s$)}\]]{0,4}(?:は)?(?:符号によらず|一周にわたって)",
    re.IGNORECASE,
)
"""Words right behind a relation by which its letters may be below zero, or its angle anywhere."""
_FARTHEST_BEHIND = 80
"""Characters behind a relation in which such words name their letters."""
_ANGLE_WORD = r"(?:crank\s+)?(?:angles?|positions?)|(?:Kurbel)?[Ww]inkel|Stellungen?|クランク角|角度?"
_ALL_BEHIND = re.compile(
    r"(?:[\s$)}\],]|\\[,;: ]|\\q?quad(?![A-Za-z])){0,8}(?:\\text\s*\{\s*)?"
    r"(?:(?:holds?|is\s+true|gilt|is\s+valid)\s+)?"
    r"(?:(?:for\s+(?:all|every|any|each|arbitrary)|für\s+(?:alle|jede[nrsm]?|beliebige[nsrm]?))"
    r"(?:\s+(?:real|values?\s+of|numbers?|angles?|reellen?|Werte?(?:\s+von)?|Winkel)){0,3}"
    r"|\\forall(?![A-Za-z])|∀)"
    r"(?P<letters>[^.;:!?\n]{0,40})",
    re.IGNORECASE,
)
"""Behind a relation, of which letters' values it is claimed."""
_LETTER_OF_LIST = re.compile(
    r"(?:[\s$,{}()]|\\[,;]|(?<![A-Za-z])(?:and|und|et)(?![A-Za-z])|\\text(?![A-Za-z]))*"
    r"(?P<letter>\\?[^\W\d_]+(?:_(?:\{\w{1,8}\}|\w))?)(?![A-Za-z0-9_])"
)
_COUNTING = frozenset("ijknNK")
"""Letters that usually count: cos 2πk = 1 for all k speaks of whole numbers."""
_RESTRICTED = re.compile(
    r"[\s$)}]*(?:\\(?:in|geq?|leq?|gt|lt|ne|neq|not)(?![A-Za-z])|[=<>≤≥≠∈]"
    r"|(?:in|with|between|from|except|but|other|such|mit|zwischen|außer|von)(?![A-Za-z]))"
)
"""What says that not all values of a letter are meant: for all x > 0, for all θ in the first quadrant."""
_COUNTS = {
    "single": 1, "one": 1, "two": 2, "twin": 2, "three": 3, "triple": 3, "four": 4, "five": 5, "six": 6,
    "seven": 7, "eight": 8, "nine": 9, "ten": 10, "twelve": 12, "sixteen": 16,
    "ein": 1, "zwei": 2, "drei": 3, "vier": 4, "fünf": 5, "sechs": 6, "sieben": 7, "acht": 8, "neun": 9,
    "zehn": 10, "zwölf": 12, "sechzehn": 16,
    "単": 1, "二": 2, "三": 3, "四": 4, "五": 5, "六": 6, "八": 8, "十二": 12,
}  # fmt: skip
_NUMBER = "|".join(sorted((*_COUNTS, r"[0-9]{1,2}"), key=len, reverse=True))
ENGINE = re.compile(
    rf"(?<![A-Za-z0-9.,])(?P<before>{_NUMBER})[-\s]?(?:cylinders?|throws?|cranks|cyl|zylinder|シリンダ"
    rf"|気筒)"
    rf"|(?<![A-Za-z])(?P<kind>in-?line|straight|flat|boxer|reihen|直列|水平対向|V型|V"
    rf"|W)[-\s]?(?P<behind>{_NUMBER})"
    r"(?:(?=-?zylinder)|(?![0-9.,]*[0-9A-Za-z]))"
    r"|(?<![A-Za-z])(?:(?P<noun>twin|triple)s|(?:parallel|vertical|inline|straight|flat|boxer"
    r"|V)[-\s](?P<alone>twin|triple))"
    r"(?![A-Za-z-])",
    re.IGNORECASE,
)
PROBLEM = re.compile(
    r"(?:exercise|problem|question|example|case|aufgabe|beispiel|fall|例題|問題?"
    r"|演習)\s*\(?([0-9]+(?:\.[0-9]+)*|[a-h])\b",
    re.IGNORECASE,
)

_GENERALLY = re.compile(
    r"(?<![^\W\d_\\])(?:in\s+general|generally|im\s+allgemeinen|allgemein|i\.\s?a\.|en\s+général|généralement|in\s+generale"
    r"|generalmente|en\s+general)(?![^\W\d_])|一般に",
    re.IGNORECASE,
)
"""Words of every case."""


def opens_case(text: str, start: int, end: int) -> bool:
    """Tell whether a relation, from `start` to `end`, is introduced as a case: for x > 0, bei θ = 0."""
    bare = _TAG.sub(" ", text[max(0, start - 80) : start]).removesuffix("stem:[")
    before = glossary_of(text).english(_CLAUSE.split(bare)[-1].rstrip(" \t\n$\\([{"))
    return _CASE.search(before + " ") is not None or _CASE_BEHIND.match(text, end) is not None


def is_said_generally(before: str) -> bool:
    """Tell whether the words before a relation say that it is so in general, exceptions apart.

    >>> is_said_generally("In general $"), is_said_generally("Here $")
    (True, False)
    """
    return _GENERALLY.search(before) is not None


def is_case_behind(text: str, end: int, first: int, last: int) -> bool:
    """Tell whether a case, from `first` to `last`, stands behind the relation that ends before it.

    As in cos θ = -1 for θ = π: it ends the clause, and nothing but such words stands between.
    """
    between = _BETWEEN.fullmatch(text, end, first) is not None
    return between and opens_case(text, first, last) and _CLAUSE_LAST.match(text, last) is not None


def is_place_behind(text: str, end: int, first: int) -> bool:
    """Tell whether only "at" or "for" parts a relation from the next one, which says where it holds.

    >>> is_place_behind("S = 5 lb., at a = 0", 8, 14), is_place_behind("S = 5, T = 0", 5, 7)
    (True, False)
    """
    return first > end and _PLACE_BEHIND.fullmatch(text, end, first) is not None


def is_said_of_all_behind(text: str, end: int) -> bool:
    """Tell whether a relation is said to hold always by the words right behind it.

    >>> is_said_of_all_behind("x + y = 1 always.", 9), is_said_of_all_behind("x = 1 here, always y", 5)
    (True, False)
    """
    return _ALWAYS_BEHIND.match(text, end) is not None


def is_said_always(before: str) -> bool:
    """Tell whether the words of a clause before a relation say that it is so always.

    >>> is_said_always("Here always $"), is_said_always("It is not always so that $")
    (True, False)
    >>> is_said_always("The sum never exceeds 1: $"), is_said_always("It is never so that $")
    (True, False)
    """
    return _ALWAYS.search(before) is not None


def has_exception_behind(text: str, end: int) -> bool:
    """Tell whether words right behind a relation name cases in which it does not hold.

    >>> has_exception_behind("S = 0 unless k is 5", 5), has_exception_behind("S = 0, k = 5", 5)
    (True, False)
    """
    return _EXCEPTION.match(text, end) is not None


def words_of_all_behind(text: str, end: int, stop: int) -> str:
    """Return the words right behind a relation, before `stop`, that begin with "for all"; "" for others.

    >>> words_of_all_behind("x = x for all real x. Here y", 5, 99)
    'for all real x'
    """
    match = _FOR_ALL_BEHIND.match(text, end)
    if match is None:
        return ""
    stop = min(stop, match.end() + _FARTHEST_BEHIND)
    return _CLAUSE.split(text[match.end() : stop], maxsplit=1)[0]


def speaks_of_every(before: str) -> bool:
    """Tell whether the words right before a letter speak of all its values: for every y > 0 say.

    >>> speaks_of_every("For all $"), speaks_of_every("For all engines with $")
    (True, False)
    """
    return _RIGHT_OF_ALL.search(before.rstrip(" $\\({")) is not None


def leads_to_claim(words: str) -> bool:
    """Tell whether nothing but "we have" and the like stands between a range and what is claimed of it.

    >>> leads_to_claim("$ we have $$"), leads_to_claim("$ we take $")
    (True, False)
    """
    return _CLAIM.fullmatch(words) is not None


def is_of_any_sign(words: str) -> bool:
    """Tell whether words say that numbers may be positive or negative."""
    return _OF_ANY_SIGN.search(words) is not None


def is_of_any_sign_behind(text: str, end: int) -> bool:
    """Tell whether words right behind a relation say that it is so whatever the signs of its letters.

    >>> is_of_any_sign_behind("|x| = x for negative x too", 7), is_of_any_sign_behind("|x| = x.", 7)
    (True, False)
    """
    return _OF_ANY_SIGN_BEHIND.match(text, end) is not None


def spoken_of_behind(text: str, end: int) -> frozenset[str]:
    r"""Return the letters of all of whose values a relation is claimed by the words right behind it.

    >>> sorted(spoken_of_behind("a b = b a for all real $a$ and $b$.", 9))
    ['a', 'b']
    >>> spoken_of_behind("x > 1 for all x > 2", 5), spoken_of_behind("x > 1 for all such x", 5)
    (frozenset(), frozenset())
    """
    match = _ALL_BEHIND.match(text, end)
    if match is None:
        return frozenset()
    letters: list[str] = []
    words, place = match["letters"], 0
    while not _RESTRICTED.match(words, place) and (listed := _LETTER_OF_LIST.match(words, place)):
        letter = listed["letter"].replace("{", "").replace("}", "")
        if letter[0] != "\\" and len(letter.partition("_")[0]) > 1:
            break
        if letter[:1] not in _COUNTING:
            letters.append(letter.lstrip("\\"))
        place = listed.end()
    return frozenset() if not letters or _RESTRICTED.match(words, place) else frozenset(letters)


def clause_start(text: str, start: int) -> int:
    """Return where the clause begins that a relation stands in."""
    first = max(0, start - 200)
    ends = [match.end() for match in _CLAUSE.finditer(text, first, start)]
    return ends[-1] if ends else first


def clause_before(text: str, start: int) -> str:
    """Return the words of a relation's clause that stand before it."""
    return text[clause_start(text, start) : start]


def speaks_of_all(before: str, letters: dict[str, bool], *, named: bool = False) -> set[str]:
    """Return the letters that a claim is made for all values of, by the words before it.

    `letters` are those of the page with cases: by the name as it is written, whether it is an angle.
    "In general" speaks of all of them, unless those that are `named` are wanted; "for every x" of x.
    """
    if not named and _GENERAL.search(before):
        return set(letters)
    spoken: set[str] = set()
    if not _ALL.search(before):
        return spoken
    for name, is_angle in letters.items():
        written = rf"[\s$\\({{]{{0,6}}{re.escape(name)}(?![A-Za-z0-9_])"
        if re.search(f"(?:{_OF_ALL}){written}", before, re.IGNORECASE) or (
            is_angle and re.search(rf"(?:{_OF_ALL})(?:{_ANGLE_WORD})", before, re.IGNORECASE)
        ):
            spoken.add(name)
    name = "|".join(sorted(map(re.escape, letters), key=len, reverse=True))
    listed = re.compile(
        rf"(?:{_OF_ALL})[\s$\\({{]{{0,6}}(?P<list>(?:{name})(?:[\s$)}}]{{0,4}}(?:,|,?\s*(?:and|und|et|y)\s)"
        rf"[\s$\\({{]{{0,4}}(?:{name})(?![A-Za-z0-9_]))+)",
        re.IGNORECASE,
    )
    lists = [match["list"] for match in listed.finditer(before)] if letters else []
    for each in lists:  # for all real a and b
        spoken |= {name for name in letters if re.search(rf"(?<![\w\\]){re.escape(name)}(?!\w)", each)}
    return spoken


_TIMES = {
    "both": 2, "pair": 2, "double": 2, "doubles": 2, "doubled": 2, "twice": 2, "triples": 3, "trebles": 3,
    "threefold": 3, "fourfold": 4, "beide": 2, "beiden": 2, "doppelt": 2, "doppelte": 2, "verdoppelt": 2,
    "verdoppeln": 2, "zweifach": 2, "dreifach": 3, "dreifache": 3, "vierfach": 4, "vierfache": 4,
    "両": 2, "2倍": 2, "二倍": 2, "3倍": 3, "4倍": 4, "6倍": 6, "倍": 2,
}  # fmt: skip
_LATIN_NUMBERS = "|".join(
    sorted(
        (word for word in {**_COUNTS, **_TIMES} if word[0] < "\u2e80" and word[0].isalpha()),
        key=len,
        reverse=True,
    )
)
_HOW_MANY = re.compile(
    rf"(?<![A-Za-zäöü])(?P<all>{_LATIN_NUMBERS})(?![A-Za-zäöü])"
    r"|(?P<digits>(?<![0-9.,])[0-9]{1,2})\s?"
    r"(?:cylinders?|pistons?|cranks|forces|Zylinder|Kolben|Kräfte|気筒|ピストン|倍)"
    r"|(?P<signs>両|[二2]倍|[346]倍|倍)",
    re.IGNORECASE,
)


_TOGETHER = {*_COUNTS, "both", "pair", "beide", "beiden", "両"}
"""Words that count things, and multiply none."""
_OF_SPEED = re.compile(
    r"\s*(?:(?:as|so|the|of|its|der|die|das|the\s+engine|crank|angular|engine|rotational|mittlere[rn]?)\s+){0,3}"
    r"(?:fast|quick|speed|rpm\b|revolutions|frequen|rate\b|angle|schnell|drehzahl|winkelgeschw|geschwind|frequenz|winkel)"
    r"|の?(?:角?速|回転|周波数|振動数|角度)",
    re.IGNORECASE,
)
"""Behind how many times as fast something turns: twice as fast, at double the speed."""


_OF_FORMULAS = re.compile(
    r"\s*(?:(?:of|the|these|der|die|das|diese[rn]?|les|des|le|las|los)\s+){0,2}"
    r"(?:stress|expression|equation|formula|relation|term|side|value|result|line|number|definition|spannung|gleichung|formel"
    r"|ausdr[uü]ck|beziehung|glied|seite|wert|ergebnis|zeile|contrainte|équation|formule|terme|membre|valeur|résultat"
    r"|tension[ie]|equazion|formul|termin|membri|valori|risultat|tensione|ecuacion|fórmula|término|miembro|valor)"
    r"|の?(?:式|項|辺|応力|値|結果)",
    re.IGNORECASE,
)
"""Behind a number of what is put in or compared, and of which none is several times as large."""


def numbers_of_several(words: str) -> frozenset[int]:
    """Return how many things words speak of together: both pistons, all four forces, doubled.

    What turns twice as fast is one thing.

    >>> sorted(numbers_of_several("both pistons go up together, as in all four cylinders"))
    [2, 4]
    >>> sorted(numbers_of_several("a crank that turns twice as fast"))
    []
    >>> sorted(numbers_of_several("putting both stresses in"))
    []
    """
    numbers = set[int]()
    for match in _HOW_MANY.finditer(words):
        word = (match["all"] or match["signs"] or "").lower().replace("2", "二")
        if word not in _TOGETHER and _OF_SPEED.match(words, match.end()):
            continue
        if word in _TOGETHER and _OF_FORMULAS.match(words, match.end()):
            continue
        numbers.add(int(match["digits"]) if match["digits"] else {**_COUNTS, **_TIMES}.get(word, 1))
    return frozenset(numbers - {1})


class Mentions:
    """The places of a text where a pattern occurs, to find the last one before another place."""

    def __init__(self, pattern: re.Pattern[str], text: str) -> None:
        self._pattern, self._text = pattern, text
        self._matches = list(pattern.finditer(text))
        self._ends = [match.end() for match in self._matches]

    def last_before(self, start: int) -> re.Match[str] | None:
        """Return the last occurrence in the text before a place, as if the text ended there.

        >>> Mentions(ENGINE, "a two-cylinder engine, then the V8").last_before(30)
        <re.Match object; span=(2, 14), match='two-cylinder'>
        """
        count = bisect_right(self._ends, start - REACH)
        last = self._matches[count - 1] if count else None
        first = max(start - REACH, last.end() if last else 0)  # near the end the text is read anew
        if count < len(self._matches):
            first = min(first, self._matches[count].start())
        for match in self._pattern.finditer(self._text, max(first, 0), start):
            last = match
        return last


REACH = 200
"""Characters: longer than any mention of an engine or an exercise."""


def engine_named(text: str, start: int) -> tuple[int, str] | None:
    """Return the cylinders of the engine that was named last before a place, and its kind if said.

    >>> engine_named("a two-cylinder engine, then the V8", 40)
    (8, 'v')
    """
    last = None
    for match in ENGINE.finditer(text, 0, start):
        last = match
    return engine_of(last)


def engine_of(last: re.Match[str] | None) -> tuple[int, str] | None:
    """Return the cylinders of the engine that a mention names, and its kind if said."""
    if last is None:
        return None
    number = (last["before"] or last["behind"] or last["noun"] or last["alone"]).lower()
    return _COUNTS.get(number) or int(number), (last["kind"] or "").lower()


def is_other_engine(before: tuple[int, str] | None, now: tuple[int, str] | None) -> bool:
    """Tell whether two engines that are both named are not the same: other cylinders or another kind.

    >>> is_other_engine((2, "v"), (2, "")), is_other_engine((2, ""), (4, "flat"))
    (False, True)
    """
    if before is None or now is None:
        return False
    return before[0] != now[0] or bool(before[1] and now[1] and before[1] != now[1])
