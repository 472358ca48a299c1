"""How far a premise in prose reaches: "Take r = 1" to the next heading, a caption to a blank line."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import accumulate

from symbalance.document.formula import Call, Formula, Name, Number, names
from symbalance.document.text_writer import formula_text
from symbalance.notes.checking.words import case_words
from symbalance.notes.checking.words.bodies_named import body_named
from symbalance.notes.checking.words.case_labels import case_named
from symbalance.notes.checking.words.engines_in_words import (
    EnginesInWords,
    NamedEngine,
    engines_of_label,
    is_another_engine,
)
from symbalance.notes.checking.words.glossary import glossary_of
from symbalance.notes.checking.words.items import item_end
from symbalance.notes.checking.words.listed_cases import item_of_cases
from symbalance.notes.checking.words.phrases_in_order import PhrasesInOrder
from symbalance.notes.checking.words.places_in_words import (
    PlaceInWords,
    dead_centre_named,
    first_place,
    last_place,
)
from symbalance.notes.checking.words.running_angles import RunningAngles, angle_placed
from symbalance.notes.checking.words.table_cells import TableCells, cells_of
from symbalance.notes.checking.words.value_groups import in_next_groups
from symbalance.notes.checking.words.working_cycles import (
    is_another_cycle,
    last_strokes,
    names_cycles,
    strokes_named,
    strokes_of,
)
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

_HEADING = re.compile(
    r"#{1,6}\s|={2,6}\s*\S.*|<h[1-6]\b|-{2,6}\s+[^\s-][^\n-]{0,80}\s-{2,6}\s*$"
    r"|\\(?:part|chapter|(?:sub){0,2}section|paragraph|subparagraph)\*?\s*[\[{]"
    r"|(?:§\s?|art(?:icle|ikel|\.)\s)?[0-9]{1,3}\.?\s+[^\W\d_][^.=\n]{2,80}\.\s?(?:--|[—–])"
    r"|【[^】=≒≈\n]{1,60}】\s*$",
    re.IGNORECASE,
)
"""Headings; those of old books stand in the line, "34. Hammer blow.--Let the fraction …"."""
_SIGNED_HEADING = re.compile(r"(?P<sign>[■□◆◇▼▽◎★☆❖])[ \u3000]?[^\s=≒≈][^=≒≈\n]{0,60}$")
"""A heading of plain text, ■ 水平対向4気筒 say; such lines right below one another are a list."""
_CAPITALS = re.compile(r"(?:[0-9]{1,2}|[A-Z])[.)]\s+(?=[^=\n]*[A-Z]{3})[^a-z=≈\n]{3,70}$")
"""A numbered line of plain text in capitals is a heading where nothing stands above it: 3) THE 270."""
FEWEST_DATA = 2
"""Letters that get their first numbers beside one that has another one before, in data of an example."""
_BLOCK = "p|h[1-6]|li|[ou]l|d[dtl]|blockquote|div|section|article|table|t[rdh]|pre|figure|hr"
_BLOCK_BEGINS = re.compile(rf"\s*<(?:{_BLOCK})\b[^>]*>", re.IGNORECASE)
_BLOCK_ENDS = re.compile(rf"</(?:{_BLOCK})>\s*$", re.IGNORECASE)
_UNDERLINE = re.compile(r"(?:={3,}|-{3,})\s*$")
_CAPTION = re.compile(
    r"\s*(?:[*_]{0,2}(?:figure|fig\.|table|tab\.|abbildung|abb\.|bild|tabelle)\s*[\d.:a-z(]"
    r"(?![\d.:a-z()~ ]{0,8}\s(?:shows?|gives?|lists?|depicts?|illustrates?|zeig(?:t|en)|enthält|gibt)\s)"
    r"|[*_]{0,2}(?:caption|legende?|bildunterschrift)\s*:|!\[|\\caption\b"
    r"|[図表](?!\s?[0-9０-９.．()（）-]{0,8}\s?(?:の|に|を|は|で|から|より)))",
    re.IGNORECASE,
)
"""The text of a figure or table; "Figure 3 shows the crank" and 図3のように begin a sentence."""
_NUMBERED = re.compile(
    r" {0,3}(?:[*_]{1,2})?(?:(?:Q|Ex|Aufgabe|Exercise|Problem|Question|Task|Part|Teil|問題?)\.? ?)?"
    r"[0-9]{1,2}[.):]"
)
"""A line that begins a numbered exercise or answer."""
_IN_BRACKETS = re.compile(r"\s*\([^()\n$]{1,40}\)\s*$")
"""A line of its own in brackets is a remark on what it stands beside: (θ = 90°)."""
_END = r"\s[^.;:!?\n$=]{0,30}$"
_INTRODUCTION = re.compile(
    r"(?<![A-Za-z])(?:take|for|if|assume|assuming|suppose|supposing|when|whenever|choose|at"
    rf"|für|bei|falls|wenn|nimm|angenommen){_END}",
    re.IGNORECASE,
)
_DATA = re.compile(
    r"[\s*_#>]*(?:Data|Given|Gegeben|Daten|Angaben|Zahlenwerte|Données|Dati|Datos|諸元|データ)[*_]{0,2}"
    r"(?:\s[^\n:$=]{1,40})?\s*[:：]",
    re.IGNORECASE,
)
"""A list of what holds for the page: "piston with pin and rings m = 0.41 kg" is no case."""
_NAMING = re.compile(
    rf"(?<![A-Za-z])(?:let|with|put|set|setting|sei|seien|mit|setze|setzt man){_END}", re.IGNORECASE
)
"""Before a number a premise (let r = 1), before a formula the name of it (let P = m r ω²)."""
_CONSIDERED = re.compile(
    r"(?<![^\W\d_])(?:we\s+(?:consider|study|treat|look\s+at)|(?:is|are)\s+considered|wir\s+(?:betrachten|untersuchen)"
    r"|(?:wird|werden)\s+betrachtet|betrachtet\s+(?:wird|werden)|nous\s+(?:considérons|étudions)|on\s+considère"
    r"|consideriamo|si\s+consider[ai]|consideramos|se\s+considera)(?![^\W\d_])|を考える|を扱う",
    re.IGNORECASE,
)
"""Words that open a page: "we consider a V8 with γ = 90°", and all of it is of that engine."""
_CONSEQUENCE = re.compile(
    r"(?:(?<![A-Za-z\\])(?:therefore|hence|thus|then|dann|so(?!\s+(?:that|dass|daß|as)\b)|consequently|accordingly"
    r"|it\s+follows(?:\s+that)?|(?:this|which)\s+implies|daher|folglich|somit|demnach|mithin"
    r"|daraus\s+folgt|es\s+folgt|hieraus\s+folgt)(?![A-Za-z])"
    r"|\\(?:Rightarrow|implies|Longrightarrow|therefore|Leftrightarrow|iff)(?![A-Za-z])|[⇒⟹⇔∴]"
    r"|よって|したがって|従って|ゆえに|故に)[^.;:!?$=]{0,30}$",
    re.IGNORECASE,
)
_THIN_SPACE = re.compile(r"\\[;:,!]")
"""Spaces typed with signs that end a sentence elsewhere: \\;\\Rightarrow\\; goes on."""
_CONDITION = re.compile(
    r"(?:(?<![A-Za-z\\{])(?:where|when|whenever|if|setting|set|solve|solving|condition|equation|root|roots|extremum"
    r"|extrema|maximum|minimum|crossings?|cross(?:es)?|intersections?|intersect|wo|wenn|falls|setze|setzt|löse"
    r"|Bedingung|Gleichung|Nullstellen?|Maximum|Schnittpunkt\w*|schneiden|croisements?|intersecz?i\w+|cruces?)"
    r"(?![A-Za-z])|条件|方程式|のとき|交点)[^.;!?$=]{0,40}$",
    re.IGNORECASE,
)
"""Before an equation that is to be solved, not claimed for all angles."""
_EQUATION = re.compile(
    r"(?:quadratic|cubic|biquadratic|polynomial|determinant|quadratische|biquadratische|Polynom|Determinante"
    r"|équation|déterminant|ecuación|determinante|equazione|vergelijking|równanie|ekvation(?:en)?"
    r"|行列式|特性方程式|[二三]次式)[^.;!?$=]{0,40}$",
    re.IGNORECASE,
)
"""Before something that is to vanish."""
_ONLY_IF = re.compile(
    r"(?<![^\W\d_])(?:only\s+(?:if|when|where|while|for|as\s+long\s+as)|iff|exactly\s+(?:if|when)|unless|provided(?:\s+that)?|nur(?:\s+dann)?,?\s+(?:wenn|wo)"
    r"|nur\s+für|solange|genau\s+dann[^.;=]{0,30}wenn|sofern|seulement\s+si|si\s+et\s+seulement\s+si|sólo\s+si|solo\s+se|se\s+e\s+solo\s+se)"
    r"(?:[\s$\\(\[]|stem:)*$",
    re.IGNORECASE,
)
"""Right before an equation that is not said to be so, but without which something else is not."""
_THAT_IS = re.compile(
    r"[\s$\])]*[,;(]?\s*(?:(?:that\s+is|i\.\s*e\.|d\.\s*h\.|das\s+heißt|also|c'est-à-dire|cioè|es\s+decir|つまり|すなわち)"
    r"(?:,?\s*(?:to\s+say|only|nur))?)?,?\s*(?:(?:if|for|when|where|für|wenn|pour|si|per|se|para)\s+)?(?:[\s$\\(\[]|stem:)*",
    re.IGNORECASE,
)
"""Between a condition and the same one said of another letter."""
_FAILS = re.compile(
    r"(?:(?<![A-Za-z])(?:third|fourth|last|latter|this|it|which|dritte|vierte|letzte|letztere|diese|sie)"
    r"(?![A-Za-z])[^.;\n=$]{0,40}(?<![A-Za-z])(?:fails|(?:is|are)\s+(?:in\s+general\s+)?not\s+(?:satisfied|fulfilled|met)"
    r"|cannot\s+be\s+(?:satisfied|fulfilled|met)|ist\s+(?:im\s+Allgemeinen\s+)?nicht\s+(?:erfüllt|erfüllbar|zu\s+erfüllen)"
    r"|nicht\s+erfüllt\s+werden)(?![A-Za-z])|(?:第三|三つ目|最後)の?(?:条件|式)[^。\n]{0,20}(?:満た(?:さない|せない)|成り立たない))",
    re.IGNORECASE,
)
"""Behind an equation that words name, and say not to hold."""
_ANY = (
    r"(?<![A-Za-z])(?:for|with|at)\s+(?:an?|any|every|all|arbitrary|general)(?![A-Za-z])|in\s+general|general(?:ly)?(?![A-Za-z])"
    r"|(?<![A-Za-z])(?:für|bei|mit)\s+(?:eine[nmrs]?|jede[nmrs]?|beliebige[nmrs]?|alle[nmrs]?|allgemeine[nmrs]?)(?![A-Za-z])"
    r"|(?<![A-Za-z])(?:allgemein|beliebige[nmrs]?)(?![A-Za-z])|任意の|一般(?:に|の)"
)
"""Words before a letter of which a formula is said for every value: for a bank angle 2γ."""
_AT_AN_ANGLE = re.compile(
    r"(?:(?<![A-Za-z])(?:at|near|to|towards|until|past|before|after)\s+(?:the|an|that|this|one)\s+(?:crank\s+)?"
    r"(?:angles?|positions?)(?![A-Za-z])"
    r"|(?<![A-Za-z])(?:beim|im|nahe\s+dem|bei\s+(?:dem|der|einem|einer))\s+(?:Kurbel)?(?:[Ww]inkel|[Ss]tellung)(?![a-z])"
    r"|(?:角度?|位置)(?:は|で|では|において|の近く))[^.;!?$=]{0,90}$"
)
"""Before an equation that says at which angle something is: near the angle at which …, tan A ≈ l/r."""
_CHOSEN = re.compile(
    r"(?<![A-Za-z])(?:(?:I|we)\s+(?:shall\s+|will\s+)?(?:take|choose|took|chose)|(?:nehme|wähle)n?\s+(?:ich|wir))$"
)
"""Before a number that is the author's choice, whatever an equation above gives."""
_ROUNDED = re.compile(
    r"(?<![A-Za-z])(?:say|rounded(?:\s+(?:up|down|off))?(?:\s+to)?|in\s+round\s+(?:numbers|figures)|rund|gerundet|aufgerundet"
    r"|abgerundet|sagen\s+wir|disons|soit\s+environ|丸めて)[,:]?[\s(]*$",
    re.IGNORECASE,
)
"""Before a number that is put in the place of one with more digits: 15947, say N = 16000."""
_ROUNDED_BEHIND = re.compile(
    r"[\s$)\]}~,(]{0,6}(?:(?:rpm|kg|mm|N|kN|min⁻¹|m)(?![A-Za-z])[\s$]{0,2},?\s?\(?)?"
    r"(?:say|rounded|in\s+round\s+(?:numbers|figures)|gerundet|aufgerundet|abgerundet|とする)(?![A-Za-z])",
    re.IGNORECASE,
)
_FOR_ONE = re.compile(
    r"(?<![A-Za-z])(?:(?:for|with|at)\s+an?|(?:für|bei|mit)\s+eine[mnr]?)\s+[^\W\d_][\w-]{2,30}"
    r"(?:\s+[^\W\d_][\w-]{1,30}){0,2}$",
    re.IGNORECASE,
)
"""Before a number of one that is looked at as an example: for a speed n = 4200."""
_PLACE_ABOVE = re.compile(
    r"(?<![A-Za-z])(?:(?<!is )(?<!are )there|dort"
    r"|(?:at|in)\s+(?:this|that)\s+(?:angle|position|point|place)"
    r"|in\s+dieser\s+Stellung|an\s+dieser\s+Stelle|bei\s+diesem\s+Winkel)[^.;!?=\n]{0,12}$|そこで[^。\n=]{0,12}$",
    re.IGNORECASE,
)
"""Before a relation that is said of the place named above: the speed there is v = r ω."""
_CONSTANT = re.compile(
    r"(?<![A-Za-z])(?:is|are|stays?|remains?|ist|sind|bleibt|bleiben)\s+(?:always\s+|stets\s+|immer\s+)?"
    r"(?:constant|konstant|(?:independent\s+of|unabhängig\s+vo[nm])\s[^.;:!?=\n]{1,30})\s*[:,]$"
    r"|(?:一定|よらない)[^.;:!?。=\n]{0,6}[:：、]$",
    re.IGNORECASE,
)
"""Before an equation whose left side is said to have its value everywhere."""
_ALSO = re.compile(r"[\s$,)\\]*(?<![A-Za-z])(?:and|und|et|y|e|sowie)(?:\s+(?:also|auch))?[\s$(\\]*")
"""Between two relations that are said of the same values."""
_ASIDE = re.compile(r"\([^()$=]*\)")
_LINK = re.compile(
    r"(?:[\s,;:.()、。，；：–—-]|\\(?:[,;: !]|quad|qquad|ldots|dots)|(?<![A-Za-zÀ-ÿ])(?:also|and|so"
    r"|hence|thus|therefore"
    r"|whence|ergo|which|this|that|it|we|one|you|i\.?\s?e\.?|is|are|to|say|be|by|in|other|words"
    r"|means?|meaning|gives?|giving"
    r"|yields?|yielding|get|obtain|have|had|find|finally|then|follows?|implies|imply|implying"
    r"|equivalently|because|since|as|but|yet"
    r"|namely|consequently|accordingly|results?|resulting|equals?|means|still|hereby|from|therefrom"
    r"|damit|dann|d\.?\s?h\.?"
    r"|das|dies|heißt|heisst|daher|folglich|somit|mithin|demnach|ist|da|weil|denn|aber|wir|man|also"
    r"|ergibt|liefert|folgt"
    r"|erhalten|erhält|bekommen|bedeutet|schließlich|nämlich|sich|wodurch|woraus|womit|donc|d'où|ce"
    r"|qui|c'est|est|dire|à"
    r"|donne|ainsi|alors|car|puisque|mais|on|obtient|luego|entonces|pues|porque|pero|quindi|dunque"
    r"|perché|cioè|not"
    r"|[mck]?m|kg|g|k?N|k?Nm|rpm|m/s|rad/s|1/s|s)"
    r"(?![A-Za-zÀ-ÿ])|すなわち|つまり|だから|なので|より|から|ので|よって|したがって|従って|ゆえに|故に|である|となる|を得る|が|は)*$",
    re.IGNORECASE,
)
"""Nothing but words that lead from one statement to what is the same or follows."""
_NEW_CASE = re.compile(
    r"(?<![A-Za-zÀ-ÿ\\])(?:for|at|case|cases|now|if|when|whenever|or|with|take|let|put|set|setting|suppose|supposing"
    r"|assume|assuming|choose|another|second|third|fourth|next|instead|otherwise|else|elsewhere|while|whereas"
    r"|respectively|resp|alternatively|again|later|once|new|use|changed?|becomes?|until|through|up|down|to|after|than|until|say"
    r"|example|exercise|problem|variant|version|engine|one|either|both|values?|solutions?|roots?|between|vs"
    r"|für|bei|im|am|fall|falls|fälle|wenn|nun|jetzt|oder|bzw|sei|seien|mit|setze|setzt|nimm|zweite[nrs]?|dritte[nrs]?"
    r"|andere[nrs]?|sonst|dagegen|während|statt|anstelle|beispiel|aufgabe|variante|bis|zu|nach|danach|alternativ|neu|wird"
    r"|lösung(?:en)?|nullstellen?|werte?|hingegen|erst|pour|si|ou|avec|maintenant|cas|sinon|puis|para|sea|con|ahora|caso"
    r"|se|oppure)(?![A-Za-zÀ-ÿ])"
    r"|の場合|のとき|の時|では|とする|とすると|または|あるいは|および|次に|今|いま|例|ならば|なら|まで|一方|他方|別|に対して|解"
    r"|(?:^|[\s(])(?:[0-9]{1,2}|[a-z]|[ivx]{1,4})\)|\\(?:lor|vee|land|wedge|text|mathrm|to|rightarrow)(?![A-Za-z])",
    re.IGNORECASE,
)
"""Between two values of a letter, what says that they belong to two cases."""
_ARROW = re.compile(
    r"\\(?:Rightarrow|implies|Longrightarrow|therefore|Leftrightarrow|iff)(?![A-Za-z])|[⇒⟹⇔∴]"
)
_OR = r"(?:or|oder|bzw\.?|ou|または|あるいは|\\(?:lor|vee)|\\(?:text|mathrm)\{\s*(?:or|oder)\s*\})"
_OR_BEHIND = re.compile(r"(?:[\s$,})]|\\(?:[,;: ]|q?quad))*" + _OR + r"(?![A-Za-z])", re.IGNORECASE)
_OR_BEFORE = re.compile(rf"(?<![A-Za-z]){_OR}(?:[\s$,]|\\(?:[,;: ]|q?quad))*$", re.IGNORECASE)
_EQUIVALENT = re.compile(
    r"(?:[\s,$]|\\(?:[,;: ]|q?quad))*(?:\\(?:Leftrightarrow|Longleftrightarrow|iff)(?![A-Za-z])|[⇔⟺]"
    r"|<=>|if\s+and\s+only\s+if|iff|genau\s+dann,?\s+wenn|dann\s+und\s+nur\s+dann,?\s+wenn)"
    r"(?:[\s,$]|\\(?:[,;: ]|q?quad))*",
    re.IGNORECASE,
)
_CONVERSE = re.compile(
    r"(?:[\s,$]|\\(?:[,;: ]|q?quad))*(?:\\(?:Leftarrow|Longleftarrow|impliedby)(?![A-Za-z])|[⇐⟸])[\s$,]*"
)
_ROOT_LEFT = (
    r"(?:\s+(?:the|an?|der|die|das|dem|den|la|le|les|il|el|trivial\w*|rigid\w*|body|zero|null|solution|soluzione"
    r"|solución|root|mode|value|Lösung|Wurzel|Nullstelle|Fall|case|racine|raíz|radice|valeur|valor)(?![A-Za-z])){0,4}"
)
_DENIED = re.compile(
    r"(?<![A-Za-z])(?:(?:not|nicht|never|nie|kein|unless)"
    r"|(?:besides|apart\s+from|aside\s+from|except(?:\s+for|\s+at|\s+when)?|other\s+than|außer|ausser|neben"
    r"|abgesehen\s+von|ausgenommen|en\s+dehors\s+de|à\s+part|hormis|sauf|aparte\s+de|además\s+de|salvo|excepto"
    r"|oltre\s+a|eccetto|tranne|naast|behalve|oprócz|poza|förutom|utom)"
    + _ROOT_LEFT
    + r")[\s$\\(`]{0,12}(?:(?:stem|latexmath|asciimath):\[|:math:`|<[a-z]+>)?\s*$",
    re.IGNORECASE,
)
_ANGLE = re.compile(
    r"(?<![\w.,/])(?P<angle>[1-9][0-9]{1,2}(?:[.,][0-9])?)(?:[\s$-]|\\,)?(?:°|&deg;|\^?\{?\\circ|(?:degrees?|deg|Grad|degrés)"
    r"(?![A-Za-z])|度)"
)
"""An angle in a heading, of which a section is: the 270° crank."""
_TURN = re.compile(
    r"(?<![\w.,/])(?P<angle>90|180|270|315|360)(?=[\s*#]*(?:\([^()]{1,60}\)[\s*#]*)?(?:</h[1-6]>\s*)?$"
    r"|[\s-](?:crank|twin|kurbel|deg|motor))",
    re.IGNORECASE,
)
"""A part of a turn without a sign at the end of a heading, or before a crank: the 270."""
_BANK_ANGLE = re.compile(
    r"(?<![A-Za-z])(?:bankwinkel|gabelwinkel|v-?winkel|(?:bank|vee|v)[-\s]angle|angle\s+(?:du|entre\s+les)\s+\w+"
    r"|(?:バンク|Ｖ|V)(?:間)?角度?)(?:\s+(?:of|von|de))?[\s:=＝はの$]{0,4}(?:\\?\w+\s*=\s*)?"
    r"(?P<angle>[1-9][0-9]{1,2}(?:[.,][0-9])?)\s*(?:°|\^?\{?\\circ|degrees?|deg|Grad|degrés|度)",
    re.IGNORECASE,
)
"""A bank angle in words, in a heading and in the text: Bankwinkel γ = 90°."""
_EXCEPT_BEHIND = re.compile(r"[\s$)\]}]{0,4}(?:以外|を除)")
_SUPPOSED = re.compile(
    r"(?<![A-Za-zÀ-ÿ])(?:would|wäre|wären|würde|würden|hätte)(?![A-Za-zÀ-ÿ])", re.IGNORECASE
)
_LABELLED_ITEM = re.compile(
    r"\s*(?:[-*+•]|\\item)\s+\$?(?P<label>[0-9]{1,3}\$?\s?(?:°|\^\\circ|\^\{\\circ\}|degrees?|Grad)\$?)\s?[:：]"
)
"""An item that begins with the angle that it is for."""
_ROW_OR_ITEM = re.compile(r"\s*(?:\||[-*+•]\s|[0-9]{1,3}[.)]\s|\\item|<t[dr])")
_SPLIT_CLAUSE = re.compile(r"(?<!bzw)(?<!resp)(?<!i\.e)(?<!d\.h)(?<!\bvs)[.!?]\s|;|[。；]|\n\s*\n")
_DISPLAY = re.compile(r"\\(?:begin|end|label|tag)\{[^{}]*\}|^[^\\\s]*\}")
_DISPLAY_LAST = re.compile(r"\s*(?:\\(?:begin|label|tag)\{[^{}]*\}\s*)+$")
_CASE_BEHIND = re.compile(r"[\s$)\]]{0,4}(?:なら|のとき|の時|の場合|とすると|とすれば|では(?=[\s$]))")
"""Behind a relation that is a case, in Japanese."""
_WHEN_BEHIND = re.compile(r"[\s$)\]]{0,4}(?:なら|のとき|の時|の場合)")
"""Behind one that is not claimed of all angles."""
_ROOTS_BEHIND = re.compile(
    r"[\s$)\]\\,.;]{0,12}(?:(?:which|it|this|and|mit|with|und|hat|has|have|die|der|das|the|den)\s+){1,3}"
    r"(?:(?:the|two|three|four|die|den|zwei|drei|vier|following|real|positive)\s+){0,3}"
    r"(?:roots?|solutions?|zeros|Wurzeln?|Lösung(?:en)?|Nullstellen?)(?![A-Za-z])"
    r"|[\s$)\]\\]{0,6}の(?:根|解)|[\s$)\]\\]{0,6}を(?:解く|満たす)",
    re.IGNORECASE,
)
"""Behind one whose roots are named next."""
_RIGHT_BEHIND = re.compile(
    r"[\s$)}\]\\]{0,4}(?:\\?(?:text|mathrm)\{[^{}]{0,12}\}[\s$)}\]\\]{0,4})?(?:</?\w{1,5}>)?\s?(?:(?!(?:and|und|et)\s)[^\W\d_]{1,3}(?:/[^\W\d_]{1,3})?\s)?(?:at\s|in\s|the\s|its\s){0,2}"
)
"""What may stand between a value and its place: 8 in at top dead centre."""
_SENTENCE_OR_ITEM = re.compile(
    r"(?<![A-Za-z]\.[A-Za-z]\.[A-Za-z])[.;!?。]\s|\n\s*\n"
    r"|\n[ \t]{0,8}(?:[-*+•·–]|\(?[a-z0-9]{1,2}[.)]|\\item)(?=\s)"
)
"""What ends a sentence, but not the points of p.m.s., or begins an item of a list."""
_THERE = re.compile(r"[\s$)\]}\\,]{0,6}(?:there|here|dort|hier)(?![A-Za-zäöüß])")
"""Words behind a relation by which it is meant at the place that its section named last."""
_ENDS = (".", ";", "!", "?", "。")
_OPENING = " \t\n$\\([{&"
"""What stands between a word and the formula that it introduces."""
LONGEST_SENTENCE = 160
"""Characters before a relation in which a dead centre may be named."""
LONGEST_INTRODUCTION = 60
"""Characters before a relation in which such a word is looked for."""
_RANKS = ("part", "chapter", "section", "subsection", "subsubsection", "paragraph", "subparagraph")
_MARK_OF_LEVEL = re.compile(
    rf"\s*(?:(?P<marks>[#=*]{{1,6}})[ \w]|\\(?P<rank>{'|'.join(_RANKS)})\*?\s*\{{)"
)
_DEEPEST = 99
"""Deeper than any heading."""


@dataclass(frozen=True)
class Sections:
    """The headings and paragraphs of a document."""

    document: ReadNotes

    @cached_property
    def lines(self) -> list[str]:
        """The lines of the document, the first one at place 0."""
        return self.document.text.split("\n")

    def _english(self, words: str) -> str:
        """Return words with their terms in English, where the document is in another language."""
        return glossary_of(self.document.text).english(words)

    @property
    def heading_lines(self) -> list[int]:
        """The lines, from 1, that begin a section."""
        return self._headings

    @cached_property
    def _headings(self) -> list[int]:
        """The lines, from 1, that begin a section."""
        marked = [k for k, line in enumerate(self.lines, 1) if _HEADING.match(line.lstrip())]
        underlined = [
            k
            for k in range(1, len(self.lines))
            if _UNDERLINE.match(self.lines[k]) and self.lines[k - 1].strip()
        ]
        marked += self._signed_headings
        above = ["", *(line.strip() for line in self.lines)]
        bare = zip(above, self.lines, strict=False)
        marked += [
            k for k, (last, line) in enumerate(bare, 1) if not last and _CAPITALS.match(line.strip())
        ]
        lines = {k + 1 for k in underlined} - set(underlined)
        return sorted(({*marked} - lines) | {*underlined})

    @property
    def _signed_headings(self) -> list[int]:
        """The lines, from 1, that begin with a sign for a heading, and are no items of a list."""
        bare = [line.strip() for line in self.lines]
        signs = [match["sign"] if (match := _SIGNED_HEADING.match(line)) else "" for line in bare]
        around = zip(
            signs,
            ["", *(line[:1] for line in bare)],
            [*(line[:1] for line in bare[1:]), ""],
            strict=False,
        )
        return [
            k for k, (sign, above, below) in enumerate(around, 1) if sign and sign not in (above, below)
        ]

    def end_of_angle_headed(self, line: int) -> int | None:
        """Return the last line of a section whose heading is an angle of the crank, 30°; or None."""
        is_place = _PLACE_HEADING.fullmatch(self.heading_above(line).strip()) is not None
        is_place = is_place or self.section_start(line) in self._headings_of_angles
        return self.section_end(line) if is_place else None

    @cached_property
    def _headings_of_angles(self) -> frozenset[int]:
        """The lines of headings that differ in an angle: Punkt φ = 30° and Punkt φ = 90°."""
        alike: dict[str, dict[str, int]] = {}
        for line in self._headings:
            words = self.lines[line - 1].strip()
            for key in _angle_headed(words):
                alike.setdefault(key, {})[words] = line
        return frozenset(line for lines in alike.values() if len(lines) > 1 for line in lines.values())

    def heading_above(self, line: int) -> str:
        """Return the heading of the section that a line stands in, "" where there is none."""
        above = [heading for heading in self._headings if heading <= line]
        return self.lines[above[-1] - 1] if above else ""

    @cached_property
    def _paragraphs(self) -> list[tuple[int, int]]:
        """The first and the last line of the paragraph of each line, from 1."""
        starts, ends = [1], [len(self.lines)]
        breaks = [self._is_break(line) for line in range(1, len(self.lines))]
        for line, is_break in enumerate(breaks, 2):
            is_first = is_break or not self.lines[line - 2].strip()
            starts.append(line if is_first else starts[-1])
        for line in range(len(breaks), 0, -1):
            ends.append(line if breaks[line - 1] else ends[-1])
        return list(zip(starts, reversed(ends), strict=True))

    @cached_property
    def _chain_ends(self) -> list[int]:
        """The places behind the relations, in their order in the text."""
        return sorted(chain.end for chain in self.document.chains)

    @property
    def in_order(self) -> list[Chain]:
        """The relations in the order of the text."""
        return self._by_start[1]

    def chain_before(self, place: int) -> Chain | None:
        """Return the last relation that ends before a place; None for the first of the text."""
        ends, chains = self._by_end
        before = bisect_right(ends, place)
        return chains[before - 1] if before else None

    def chains_behind(self, place: int) -> Iterator[Chain]:
        """Yield the relations that begin behind a place, in the order of the text."""
        starts, chains = self._by_start
        behind = range(bisect_right(starts, place), len(chains))  # no slice, which copies them all
        return (chains[k] for k in behind if chains[k].relations)

    def chains_between(self, start: int, end: int) -> list[Chain]:
        """Return the relations and lone expressions that stand between two places, in their order."""
        starts, chains = self._by_start
        between = chains[bisect_left(starts, start) : bisect_left(starts, end)]
        return [chain for chain in between if chain.end <= end]

    @cached_property
    def _by_end(self) -> tuple[list[int], list[Chain]]:
        """The relations by where they end; lone expressions are none."""
        chains = sorted((c for c in self.document.chains if c.relations), key=lambda chain: chain.end)
        return [chain.end for chain in chains], chains

    @cached_property
    def _by_start(self) -> tuple[list[int], list[Chain]]:
        """The relations by where their first side begins, in the order of the text."""
        chains = sorted(self.document.chains, key=lambda chain: chain.sides[0].span[0])
        return [chain.sides[0].span[0] for chain in chains], chains

    @cached_property
    def _by_line(self) -> dict[int, list[Chain]]:
        """The relations that begin on each line."""
        chains: dict[int, list[Chain]] = {}
        for chain in self.document.chains:
            chains.setdefault(chain.lines[0], []).append(chain)
        return chains

    @cached_property
    def _next_groups(self) -> dict[int, set[int]]:
        """Where the relations of each line begin that take up the letters of a group before them."""
        text = self.document.text
        return {
            line: {c.sides[0].span[0] for c in in_next_groups(text, chains)}
            for line, chains in self._by_line.items()
        }

    def is_in_next_group(self, chain: Chain) -> bool:
        """Tell whether a relation stands in a group of values behind another of the same letters."""
        return chain.sides[0].span[0] in self._next_groups.get(chain.lines[0], ())

    @cached_property
    def _line_starts(self) -> list[int]:
        """The place of each line's first character."""
        return [0, *accumulate(len(line) + 1 for line in self.lines)]

    @cached_property
    def _engines(self) -> case_words.Mentions:
        return case_words.Mentions(case_words.ENGINE, self.document.text)

    @cached_property
    def _problems(self) -> case_words.Mentions:
        return case_words.Mentions(case_words.PROBLEM, self.document.text)

    @cached_property
    def _numbers_given(self) -> dict[int, dict[str, int]]:
        """The letters that a paragraph gives a number, with the first line that does, by its start."""
        numbers: dict[int, dict[str, int]] = {}
        for chain in self.document.chains:
            head, line = chain.sides[0].node, chain.lines[0]
            if chain.relations and isinstance(head, Name) and not names(chain.sides[1].node):
                own = numbers.setdefault(self.paragraph_start(line), {})
                own[head.name] = min(line, own.get(head.name, line))
        return numbers

    def numbers_given_again(self, line: int) -> frozenset[str]:
        """Return the letters that a line's own paragraph gives a number: with x = 15 once more."""
        own = self._numbers_given.get(self.paragraph_start(line), {})
        return frozenset(name for name, first in own.items() if first <= line)

    def section_start(self, line: int) -> int:
        """Return the line of the heading that a line stands under, 1 where there is none."""
        above = bisect_right(self._headings, line)
        return self._headings[above - 1] if above else 1

    def is_in_list_of_data(self, chain: Chain, earlier_line: int) -> bool:
        """Tell whether a relation stands among the data of an example of its own, in another section.

        Some numbers are given there, to letters that had none in the earlier line's section.
        """
        line = chain.lines[0]
        if self.same_section(earlier_line, line):
            return False
        own = self._numbers_given.get(self.paragraph_start(line), {})
        first = max((heading for heading in self._headings if heading <= earlier_line), default=1)
        there = {
            name
            for start, numbers in self._numbers_given.items()
            if first <= start <= self.section_end(earlier_line)
            for name in numbers
        }
        return len(own.keys() - there) >= FEWEST_DATA

    def section_end(self, line: int) -> int:
        """Return the last line of the section that a line stands in."""
        place = bisect_right(self._headings, line)
        return self._headings[place] - 1 if place < len(self._headings) else len(self.lines)

    def paragraph_end(self, line: int) -> int:
        """Return the last line of the paragraph that a line stands in."""
        return self._paragraphs[line - 1][1]

    def _is_break(self, line: int) -> bool:
        """Tell whether a paragraph ends with a line: before a blank one, at an edge of an HTML block."""
        above, below = self.lines[line - 1], self.lines[line]
        return not below.strip() or bool(_BLOCK_BEGINS.match(below) or _BLOCK_ENDS.search(above))

    def is_in_brackets(self, chain: Chain) -> bool:
        """Tell whether a relation stands in brackets, as the condition of a formula: = 0 (N ≥ 2)."""
        start, end = chain.sides[0].span[0], chain.end
        before, after = self.document.text[:start].rstrip(" $"), self.document.text[end:].lstrip(" $")
        return before[-1:] == "(" and after[:1] == ")"

    def case_end(self, line: int) -> int:
        """Return the last line of a case: its paragraph, and the displays that stand right below."""
        end = self.paragraph_end(line)
        while (following := self._next_text(end)) and self._goes_on(end, following):
            end = self.paragraph_end(following)
        return end

    def _goes_on(self, end: int, following: int) -> bool:
        """Tell whether a paragraph belongs to the one before: a display, or what its end leads to."""
        below = self.lines[following - 1]
        is_open = _OPEN_END.search(self.lines[end - 1]) is not None
        is_formula = _FORMULA_ALONE.fullmatch(below) is not None
        return _SET_OFF.match(below) is not None or (is_formula and is_open)

    def moment_end(self, line: int) -> int:
        """Return the last line of the item, or else the section, that looks at one crank angle."""
        return min(self.section_end(line), item_end(self.lines, line))

    def item_of_cases(self, line: int, start: int) -> tuple[int, int] | None:
        """Return the list of cases and the end of its item that a formula at a place of a line opens."""
        return item_of_cases(self.lines, line, start - self.start_of_line(line))

    def _next_text(self, line: int) -> int | None:
        """Return the next line that is not blank."""
        return next((k + 1 for k in range(line, len(self.lines)) if self.lines[k].strip()), None)

    def premise_end(self, chain: Chain, *, is_number: bool) -> int | None:
        """Return the last line that a relation reaches if its sentence makes it a premise, else None.

        `is_number` tells whether it gives its letter a number.
        """
        line = chain.lines[0]
        if line in self._engine_rows:
            return line
        first = self.lines[self.paragraph_start(line) - 1]
        if (chain.inline and _CAPTION.match(first)) or _IN_BRACKETS.match(first):
            return self.paragraph_end(line)
        start = chain.start
        before = self.document.text[max(0, start - LONGEST_INTRODUCTION) : start]
        before = re.split(r"\n\s*\n", before)[-1].rstrip(" \t\n$\\([")
        if not chain.inline or _DATA.match(first) or self._is_item_of_data(line):
            return None
        end = chain.end
        is_case = _CASE_BEHIND.match(self.document.text, end) or _INTRODUCTION.search(before + " ")
        is_place = is_number and (
            angle_placed(chain) != ""
            if is_case
            else self.running.is_at_place(chain) and not self.is_consequence(chain)
        )
        if is_place:
            if self.document.text[end : end + 4].lstrip(" $)").startswith(":"):
                return self.case_end(line)  # in UT, α = 180°: what its lines say
            return self.moment_end(line)
        is_of_page = _CONSIDERED.search(before) is not None and self.is_first(chain)
        is_premise = is_case or (is_number and not is_of_page and _NAMING.search(before + " "))
        return self.section_end(line) if is_premise else None

    def is_first(self, chain: Chain) -> bool:
        """Tell whether no relation stands before one on its page."""
        return self.chain_before(chain.start) is None

    def _is_item_of_data(self, line: int) -> bool:
        """Tell whether a line is an item of a list that words call data: "Gegeben laut Blatt:"."""
        if not _ROW_OR_ITEM.match(self.lines[line - 1]):
            return False
        first = self.paragraph_start(line) - 1
        above = next((text for text in reversed(self.lines[:first]) if text.strip()), "")
        return _DATA.match(above) is not None

    @cached_property
    def running(self) -> RunningAngles:
        """The angles that run on the page."""
        return RunningAngles(self.in_order)

    @cached_property
    def _engine_rows(self) -> frozenset[int]:
        """The lines, from 1, of rows that each name an engine: F_2 of one row is not that of the next."""
        rows = {
            number
            for number, text in enumerate(self.lines, 1)
            if text.lstrip().startswith("|")
            and case_words.ENGINE.search(text.lstrip(" \t|").split("|", 1)[0])
        }
        return frozenset(n for n in rows if {n - 1, n + 1} & rows)

    def is_consequence(self, chain: Chain) -> bool:
        """Tell whether a relation is introduced as what follows: therefore, hence, ⇒."""
        return _CONSEQUENCE.search(_THIN_SPACE.sub(" ", self._text_before(chain))) is not None

    def starts_new_case(self, chain: Chain, earlier_line: int, name: str) -> bool | None:
        """Tell whether words before a letter's other value say that it belongs to another case.

        False where they say that it follows or is the same, or there are none; None where they may mean
        either.
        """
        start = chain.start
        row = self.lines[chain.lines[0] - 1]
        text = self.document.text
        if _ROW_OR_ITEM.match(row) or self.is_in_next_group(chain) or self._names_its_row(chain):
            return True
        before = [
            other
            for other in self._by_line.get(earlier_line, ())
            if other is not chain and other.end <= start
        ]
        givers = [other for other in before if _gives(other, name)]
        end = max((other.end for other in givers or before), default=None)
        if end is None:
            return True  # taken before what stands left of it: x² = 4 for x = 2
        between = list(text[end:start])
        starts, chains = self._by_start
        for other in chains[bisect_left(starts, end) : bisect_right(starts, start)]:
            first, last = other.sides[0].span[0], other.sides[-1].span[1]
            if last <= start:
                between[first - end : last - end] = " " * (last - first)
        words = "".join(between).replace("$", " ").strip(_OPENING)
        if self.is_consequence(chain):
            return False
        if words.lower() in ("and", "und", "et", "y", "e", "と"):
            return True  # the roots are x = 1 and x = 2
        if _LINK.fullmatch(words):
            return None if ";" in words and any(c.isdigit() for c in text[end:start]) else False
        clause = _SPLIT_CLAUSE.split(words)[-1]
        return True if _NEW_CASE.search(clause) or _NEW_CASE.search(self._english(clause)) else None

    def opens_case(self, chain: Chain) -> bool:
        """Tell whether a relation is introduced as a case, which the next one ends: for x > 0."""
        start = chain.start
        return chain.inline and case_words.opens_case(self.document.text, start, chain.end)

    def spoken_of_generally(
        self, chain: Chain, letters: dict[str, bool], *, named: bool = False
    ) -> frozenset[str]:
        """Return the letters, given with whether each is an angle, of all of whose values it is claimed.

        With `named`, those only that the words name: for every x, and not "in general".
        """
        text = self.document.text
        is_of_all = case_words.is_said_of_all_behind(text, chain.end)
        if is_of_all or case_words.is_of_any_sign_behind(text, chain.end):
            return frozenset(letters)
        start = chain.start
        last = self.chain_before(start)
        is_next = last is not None and _ALSO.fullmatch(self.document.text, last.end, start) is not None
        if last and is_next and chain.letters == last.letters and all(names(s.node) for s in chain.sides):
            return self.spoken_of_generally(last, letters, named=named)
        first, end = case_words.clause_start(self.document.text, start), self.end_before(start) or 0
        if _AND_ONLY.fullmatch(self.document.text, end, start) is None:
            first = max(first, end)
        before = self.document.text[first:start]
        written = {formula_text(Name(name), plain=True): is_angle for name, is_angle in letters.items()}
        written |= letters | {f"\\{name}": is_angle for name, is_angle in letters.items()}
        behind = case_words.words_of_all_behind(
            self.document.text, chain.end, self._start_behind(chain.end)
        )
        spoken = case_words.speaks_of_all(before, written, named=named)
        spoken |= case_words.speaks_of_all(behind, written, named=True)
        if case_words.is_of_any_sign(before):
            return frozenset(letters)
        spoken |= case_words.spoken_of_behind(self.document.text, chain.end)
        own = {name: {name, f"\\{name}", formula_text(Name(name), plain=True)} for name in letters}
        return frozenset(name for name, ways in own.items() if ways & spoken)

    def _start_behind(self, end: int) -> int:
        """Return where the next relation begins behind a place, or the text ends."""
        starts = self._by_start[0]
        place = bisect_left(starts, end)
        return starts[place] if place < len(starts) else len(self.document.text)

    @cached_property
    def phrases_in_order(self) -> PhrasesInOrder:
        """The phrases of sentences that name several formulas in a row."""
        return PhrasesInOrder(self.document.text, self.in_order, self.end_before)

    def end_before(self, start: int) -> int | None:
        """Return where the last relation ends that stands before a place, None where there is none."""
        place = bisect_right(self._chain_ends, start)
        return self._chain_ends[place - 1] if place else None

    def stands_in_clause(self, position: int, chain: Chain) -> bool:
        """Tell whether a place in the text is in the clause that a relation stands in."""
        start = chain.start
        return position >= case_words.clause_start(self.document.text, start)

    def is_of_another_engine(self, chain: Chain, earlier_line: int) -> bool:
        """Tell whether another engine, or another exercise, was named since a line.

        What the headings of the two sections name goes before what stands between: four cylinders are
        spoken of as two and two.
        """
        by_headings = self.headings_name_other_engines(chain.lines[0], earlier_line)
        if by_headings or self.is_of_another_cycle(chain, earlier_line):
            return True
        start = chain.start
        earlier = self.start_of_line(earlier_line)
        starts = self._by_start[0]
        place = bisect_left(starts, min(start, self.start_of_line(earlier_line + 1)))
        earlier = max(earlier, starts[place - 1] if place else 0)  # where the last one on its line begins
        if self.names_another_case(chain, earlier_line):
            return True
        text = self.document.text
        before, now = (
            case_words.engine_of(self._engines.last_before(place)) for place in (earlier, start)
        )
        if by_headings is None and case_words.is_other_engine(before, now):
            return True
        own_engine = case_words.engine_named(case_words.clause_before(text, start), start)
        if before is None and own_engine is not None and own_engine[0] > 1:
            return True  # of one cylinder above, and here its own clause says: for an inline four
        if self.same_section(earlier_line, chain.lines[0]):
            return False
        mentions = [self._problems.last_before(place) for place in (earlier, start)]
        problems = ["" if mention is None else mention[1] for mention in mentions]
        return problems[0] != problems[1] != ""

    def _named_in_paragraph(self, place: int) -> NamedEngine | None:
        """Return the engine that the paragraph of a place names last before it."""
        line = self.document.line_of(place)
        return self.named_engines.last_before(self.start_of_line(self.paragraph_start(line)), place)

    def _named_in_heading(self, line: int) -> NamedEngine | None:
        """Return the engine that the heading of a line's section names."""
        first = self.section_start(line)
        end = self.start_of_line(first + 1) if first < len(self.lines) else len(self.document.text)
        return self.named_engines.last_before(self.start_of_line(first), end)

    def _named_in_headings(self, line: int) -> NamedEngine | None:
        """Return the engine that the heading of a line's section names, or the one that it is under."""
        level = _DEEPEST
        for heading in reversed([n for n in self._headings if n <= line]):
            own = _level(self.lines[heading - 1])
            if own >= level:
                continue
            level = own
            if (engine := self._named_in_heading(heading)) is not None:
                return engine
        return None

    @cached_property
    def named_engines(self) -> EnginesInWords:
        """The engines that the page names."""
        return EnginesInWords(self.document.text)

    def is_in_another_row(self, chain: Chain, earlier_line: int) -> bool:
        """Tell whether two lines are rows of one table, with a case in their first cells, and a letter
        has its formula in the same column of both; or items of one list, with a case before a colon.
        """
        line = chain.lines[0]
        rows = [self.lines[n - 1] for n in (earlier_line, line)]
        labels = [match["label"].strip() for row in rows if (match := _LABELLED_ITEM.match(row))]
        if len(labels) == len(rows):  # * 45°: β = 315°, and below * 60°: β = 300°
            return earlier_line < line and labels[0] != labels[1]
        between = self.lines[earlier_line - 1 : line]
        if earlier_line >= line or not all(row.lstrip().startswith("|") for row in between):
            return False
        if self._is_in_cell_of_another_row(chain, earlier_line):
            return True
        first, second = (row.split("|")[1].strip() for row in rows)
        start = self.start_of_line(line)
        column = self.document.text[start : chain.start].count("|")
        cells = rows[0].split("|")
        own = self.document.text[chain.sides[0].span[0] : chain.sides[0].span[1]].strip()
        has_same = column < len(cells) and cells[column].strip(" $").startswith(own)
        return has_same and column > 1 and first != second and "=" not in first + second

    def _names_its_row(self, chain: Chain) -> bool:
        """Tell whether a relation is the first cell of a table's row, in any markup: κ = 1/2 & circle."""
        own = cells_of(self.document.text).at(chain.start)
        return (
            own is not None
            and bool(own.others)
            and len(own.labels) == 1
            and own.labels[0].text == own.rows
        )

    def _is_in_cell_of_another_row(self, chain: Chain, earlier_line: int) -> bool:
        """Tell whether a letter stands in its column of an earlier line, in another row of the table."""
        tables = cells_of(self.document.text)
        own = tables.at(chain.start)
        if own is None or not own.column or "=" in own.row:
            return False
        earlier = [c for c in self.chains_on(earlier_line) if c.sides[0].node == chain.sides[0].node]
        cells = [cell for c in earlier if (cell := tables.at(c.start)) is not None and cell.column]
        return any(
            cell.labels[0].span == own.labels[0].span and cell.row != own.row and "=" not in cell.row
            for cell in cells
        )

    def _is_in_cell_of_another_engine(self, chain: Chain, earlier_line: int) -> bool:
        """Tell whether a letter's formula stands in a cell of another engine than the earlier one."""
        own = self._engines_of_cell(chain.start)
        earlier = self.chains_above(chain.sides[0].node, chain.start)
        earlier = [c for c in earlier if earlier_line in c.lines] if own else []
        before = self._engines_of_cell(earlier[-1].start) if earlier else frozenset()
        return bool(before) and not own & before

    def _engines_of_cell(self, place: int) -> frozenset[tuple[int, bool, int]]:
        """Return the engines that the row or the column of a table's cell is of."""
        cell = self._table_cells.at(place)
        labels = () if cell is None else cell.labels
        return frozenset(engine.key for label in labels for engine in engines_of_label(label.text))

    @cached_property
    def _table_cells(self) -> TableCells:
        return cells_of(self.document.text)

    def is_labelled_item(self, line: int) -> bool:
        """Tell whether a line is an item of a list that begins with the angle that it is for."""
        return _LABELLED_ITEM.match(self.lines[line - 1]) is not None

    def names_another_case(self, chain: Chain, earlier_line: int) -> bool:
        """Tell whether a relation's own words name other strokes, another engine, another row's case."""
        if self._names_another_cycle(chain, earlier_line) or self.is_in_another_row(chain, earlier_line):
            return True
        if self._is_in_cell_of_another_engine(chain, earlier_line):
            return True
        end = self.start_of_line(earlier_line + 1) if earlier_line < len(self.lines) else chain.start
        starts = self._by_start[0]
        place = bisect_left(starts, min(chain.start, end))
        earlier = max(self.start_of_line(earlier_line), starts[place - 1] if place else 0)
        before, now = (self._named_in_paragraph(place) for place in (earlier, chain.start))
        if before is None and now is not None:
            before = self._named_in_paragraph(now.place)  # named behind the earlier relation
            is_below = not self.same_section(earlier_line, chain.lines[0])
            before = before or (self._named_in_heading(earlier_line) if is_below else None)
        return before is not None and now is not None and is_another_engine(before, now)

    def _names_another_cycle(self, chain: Chain, earlier_line: int) -> bool:
        """Tell whether a relation's clause is of engines of other strokes than an earlier line."""
        if not self.names_strokes:
            return False
        text, start = self.document.text, chain.start
        first = self.start_of_line(self.paragraph_start(earlier_line))
        clause = case_words.clause_start(text, start)
        before, now = last_strokes(text[first:clause]), strokes_named(text[clause:start])
        return before > 0 and len(now) == 1 and before not in now

    def case_named(self, chain: Chain) -> str:
        """Return what names the case that a relation's sentence, item or row is of, or ""."""
        if chain.start not in self._cases_named:
            self._cases_named[chain.start] = case_named(self.document.text, chain.start, chain.end)
        return self._cases_named[chain.start]

    @cached_property
    def _cases_named(self) -> dict[int, str]:
        return {}

    def of_its_named_case(self, chain: Chain, givers: list[Chain]) -> list[Chain]:
        """Return those of a letter's values that the case of a relation gave it; none if another did not.

        A value given since in no case is that of every case.
        """
        own = self.case_named(chain)
        cases = [self.case_named(giver) for giver in givers]
        if not own or own not in cases or "" in cases[cases.index(own) :] or set(cases) == {own}:
            return []
        return [giver for giver, case in zip(givers, cases, strict=True) if case == own]

    def of_its_cycle(self, chain: Chain, givers: list[Chain]) -> list[Chain]:
        """Return those of a letter's values that are of the engine with the strokes of a relation's.

        None where its last value is, or is of no such engine: P = p V n/2 of the four-stroke, P = p V n
        of the two-stroke, and then "the torque of the four-stroke is P/ω".
        """
        if not self.names_strokes or len(givers) < 2 or not self._strokes_of(chain):
            return []
        strokes = [self._strokes_of(giver) for giver in givers]
        if 0 in strokes or strokes[-1] == self._strokes_of(chain):
            return []
        return [c for c, own in zip(givers, strokes, strict=True) if own == self._strokes_of(chain)]

    def _strokes_of(self, chain: Chain) -> int:
        """Return the strokes of the engine that a relation's own words name, 0 for none."""
        before = self.end_before(chain.start) or 0
        return strokes_of(self.document.text, (chain.start, chain.end), before)

    def chains_of(self, head: Formula) -> list[Chain]:
        """Return the chains that begin with a formula, a letter say, in the order of the text."""
        return self._by_head.get(head, [])

    def chains_above(self, head: Formula, place: int) -> list[Chain]:
        """Return the chains that begin with a formula, and before a place, in the order of the text."""
        chains = self.chains_of(head)
        return chains[: bisect_left(chains, place, key=lambda chain: chain.start)]

    def last_above(self, head: Formula, place: int) -> Chain | None:
        """Return the last chain before a place that begins with a formula; None where there is none."""
        above = self.chains_above(head, place)
        return above[-1] if above else None

    @cached_property
    def _by_head(self) -> dict[Formula, list[Chain]]:
        chains: dict[Formula, list[Chain]] = {}
        for chain in self.in_order:
            if chain.relations:
                chains.setdefault(chain.sides[0].node, []).append(chain)
        return chains

    def equation_before(self, place: int, letters: Collection[str]) -> Chain | None:
        """Return the last equation of one of these letters alone that ends before a place, or None."""
        found = [self._equations_of[name] for name in letters if name in self._equations_of]
        last = [chains[k - 1] for ends, chains in found if (k := bisect_right(ends, place))]
        return max(last, key=lambda chain: chain.end, default=None)

    @cached_property
    def _equations_of(self) -> dict[str, tuple[list[int], list[Chain]]]:
        """The equations that have one letter and do not begin with it alone, by that letter."""
        found: dict[str, tuple[list[int], list[Chain]]] = {}
        for chain in self._by_end[1]:
            is_one = len(chain.relations) == 1 and chain.relations[0].sign == "="
            if is_one and len(chain.letters) == 1 and not isinstance(chain.sides[0].node, Name):
                ends, chains = found.setdefault(next(iter(chain.letters)), ([], []))
                ends.append(chain.end)
                chains.append(chain)
        return found

    def has_formula_above(self, head: Formula, place: int) -> bool:
        """Tell whether a relation above a place gives what it begins with a formula."""
        return self._first_formulas.get(head, place) < place

    @cached_property
    def _first_formulas(self) -> dict[Formula, int]:
        first: dict[Formula, int] = {}
        for chain in self.in_order:
            if len(chain.sides) > 1 and names(chain.sides[1].node):
                first.setdefault(chain.sides[0].node, chain.start)
        return first

    def chains_on(self, line: int) -> list[Chain]:
        """Return the relations that begin on a line."""
        return self._by_line.get(line, [])

    @cached_property
    def names_strokes(self) -> bool:
        """Whether the page names an engine of two or four strokes."""
        return bool(strokes_named(self.document.text))

    @cached_property
    def _names_cycles(self) -> bool:
        """Whether the page names any way in which engines work."""
        return names_cycles(self.document.text)

    def is_of_another_cycle(self, chain: Chain, earlier_line: int) -> bool:
        """Tell whether a relation's engine is a four-stroke, say, and a line's a two-stroke."""
        if not self._names_cycles:
            return False
        starts, chains = self._by_start
        place = bisect_left(starts, min(chain.start, self.start_of_line(earlier_line + 1)))
        start = self.start_of_line(earlier_line)
        before = (start, start)
        if place and starts[place - 1] >= start:
            before = (starts[place - 1], chains[place - 1].end)
        return is_another_cycle(self.document.text, before, (chain.start, chain.end))

    def headings_name_other_engines(self, line: int, earlier_line: int) -> bool | None:
        """Tell whether two lines' headings name different engines, or cranks; None if one names none."""
        if self.same_section(earlier_line, line):
            return None
        headings = [self.heading_above(n)[: case_words.REACH] for n in (earlier_line, line)]
        before, now = (case_words.engine_of(case_words.ENGINE.search(heading)) for heading in headings)
        if now is None or before is None:
            angles = [
                {match["angle"] for pattern in (_ANGLE, _TURN) for match in pattern.finditer(heading)}
                for heading in headings
            ]
            if all(len(each) == 1 for each in angles) and angles[0] != angles[1]:
                return True
            if self._is_of_other_banks(headings[1], earlier_line):
                return True
            named = [self._named_in_headings(n) for n in (earlier_line, line)]  # in any language
            counts = [engine.cylinders for engine in named if engine is not None]
            return True if len(set(counts)) > 1 else None
        return case_words.is_other_engine(before, now)

    def _is_of_other_banks(self, heading: str, earlier_line: int) -> bool:
        """Tell whether a heading names another bank angle than the text above an earlier line."""
        now = _BANK_ANGLE.search(heading)
        if now is None:
            return False
        above = self.document.text[: self.start_of_line(earlier_line)]
        before = [match["angle"] for match in _BANK_ANGLE.finditer(above)]
        return bool(before) and before[-1] != now["angle"]

    def start_of_line(self, line: int) -> int:
        """Return the place of a line's first character."""
        return self._line_starts[line - 1]

    def follows_at_once(self, chain: Chain) -> bool:
        """Tell whether nothing but words such as "hence" stands behind the relation before."""
        start = chain.start
        end = self.end_before(start)
        return end is not None and _LINK.fullmatch(self._words_between(end, start)) is not None

    def is_one_of_several(self, chain: Chain) -> bool:
        """Tell whether a relation stands beside an "or": x = 0 or x = 1."""
        text, start = self.document.text, chain.start
        before = text[max(0, start - 20) : start].rstrip(_OPENING)
        return bool(_OR_BEHIND.match(text, chain.end) or _OR_BEFORE.search(before))

    def behind_or(self, chain: Chain) -> str:
        """Return the line behind the "or" that follows a relation: 315° of θ = 135° or 315°; else ""."""
        match = _OR_BEHIND.match(self.document.text, chain.end)
        return "" if match is None else self.document.text[match.end() :].partition("\n")[0]

    def is_equivalence(self, chain: Chain) -> bool:
        """Tell whether a relation is said to be equivalent to the one before it: ⇔, if and only if."""
        return _EQUIVALENT.fullmatch(self._between(chain)) is not None

    def is_converse(self, chain: Chain) -> bool:
        """Tell whether the relation before is said to follow from a relation: x² = 1 ⇐ x = 1."""
        return _CONVERSE.fullmatch(self._between(chain)) is not None

    def _between(self, chain: Chain) -> str:
        start = chain.start
        end = self.end_before(start)
        return "" if end is None else self.document.text[end:start].strip(" \t\n$}")

    def _words_between(self, end: int, start: int) -> str:
        text = self.document.text[end:start].replace("$", " ")
        return _ARROW.sub(" ", text).strip(_OPENING)

    def is_denied(self, chain: Chain) -> bool:
        """Tell whether a relation stands behind a "not", or as what is left out: besides ω = 0."""
        start, end = chain.start, chain.end
        before = self.document.text[max(0, start - LONGEST_INTRODUCTION) : start]
        return bool(_DENIED.search(before) or _EXCEPT_BEHIND.match(self.document.text, end))

    def is_supposed(self, chain: Chain) -> bool:
        """Tell whether a relation is in the mood of what is not so: it would be, es wäre."""
        start = chain.start
        text = self.document.text
        return _SUPPOSED.search(case_words.clause_before(text, start)) is not None

    def stands_next(self, chain: Chain, line: int) -> bool:
        """Tell whether no other relation stands between a line and a relation below it."""
        start = chain.start
        starts, chains = self._by_start
        first = bisect_left(starts, self.start_of_line(line + 1))
        return not any(line < other.lines[0] for other in chains[first : bisect_left(starts, start)])

    def is_said_to_fail(self, chain: Chain) -> bool:
        """Tell whether the words right below a relation say that it fails: the third one."""
        following = self._by_start[0]
        place = bisect_right(following, chain.sides[0].span[0])
        end = following[place] if place < len(following) else len(self.document.text)
        end = min(
            end, chain.end + LONGEST_INTRODUCTION, self.end_of_line(self.section_end(chain.lines[0]))
        )
        return _FAILS.search(self.document.text, chain.end, end) is not None

    def is_only_if(self, chain: Chain) -> bool:
        """Tell whether a relation stands right behind "only if" or "iff": what something else takes.

        Or behind one that does, said in another letter: only where T < 1, that is for s > 1.
        """
        return self._stands_behind_only_if(chain, self._behind_only_if)

    @cached_property
    def _behind_only_if(self) -> list[bool]:
        """Whether each of the relations, by where they end, stands behind "only if": in one pass."""
        found: list[bool] = []
        for chain in self._by_end[1]:
            found.append(self._stands_behind_only_if(chain, found))
        return found

    def _stands_behind_only_if(self, chain: Chain, earlier: list[bool]) -> bool:
        text = self.document.text
        ends, _ = self._by_end
        before = bisect_right(ends, chain.start) - 1
        if before >= 0 and _THAT_IS.fullmatch(text, ends[before], chain.start) is not None:
            return earlier[before]
        return _ONLY_IF.search(text[max(0, chain.start - LONGEST_SENTENCE) : chain.start]) is not None

    def end_of_line(self, line: int) -> int:
        """Return the place behind a line."""
        return self._line_starts[line] if line < len(self._line_starts) else len(self.document.text)

    def is_condition(self, chain: Chain) -> bool:
        """Tell whether a relation is introduced as an equation to be solved: where, condition, set."""
        if any(words.match(self.document.text, chain.end) for words in (_WHEN_BEHIND, _ROOTS_BEHIND)):
            return True
        before = _ASIDE.sub(" ", self._text_before(chain))
        if _CONDITION.search(before) is not None:
            return True
        if chain.sides[-1].node == Number(Fraction(0)) and _EQUATION.search(before) is not None:
            return True
        sentence = self.sentence_leading_to(chain)
        return not self.is_consequence(chain) and _AT_AN_ANGLE.search(sentence) is not None

    def looks_back(self, chain: Chain, line: int) -> bool:
        """Tell whether a relation is said of a place that the paragraph before names: the speed there."""
        start = self.paragraph_start(chain.lines[0])
        above = next((n for n in range(start - 1, 0, -1) if self.lines[n - 1].strip()), 0)
        if not above or not self.paragraph_start(above) <= line < start:
            return False
        return (
            self.same_section(line, start)
            and _PLACE_ABOVE.search(self.sentence_before(chain)) is not None
        )

    def is_chosen(self, chain: Chain, earlier_line: int) -> bool:
        """Tell whether words give a number as another one: I take k = 0.62; for a speed n = 4200."""
        before = self.document.text[max(0, chain.start - LONGEST_INTRODUCTION) : chain.start].rstrip(" $")
        if len(chain.relations) != 1 or not chain.inline:
            return False
        if _CHOSEN.search(before) is not None:
            return True
        is_below = self.paragraph_start(chain.lines[0]) > earlier_line
        return is_below and _FOR_ONE.search(before) is not None

    def is_rounded_choice(self, chain: Chain) -> bool:
        """Tell whether words give a number in the place of one with more digits: say N = 16000."""
        before = self.document.text[max(0, chain.start - LONGEST_INTRODUCTION) : chain.start].rstrip(" $")
        is_alone = len(chain.relations) == 1 and chain.inline
        return is_alone and bool(
            _ROUNDED.search(before) or _ROUNDED_BEHIND.match(self.document.text, chain.end)
        )

    def is_called_identity(self, chain: Chain) -> bool:
        """Tell whether the words right before a relation call it an identity."""
        return _IDENTITY.search(self.sentence_leading_to(chain)) is not None

    def is_said_always(self, chain: Chain) -> bool:
        """Tell whether the words of a relation's clause before it say that it is so always."""
        start = max(
            case_words.clause_start(self.document.text, chain.start), self.end_before(chain.start) or 0
        )
        return case_words.is_said_always(self.document.text[start : chain.start])

    def is_said_to_be_constant(self, chain: Chain) -> bool:
        """Tell whether the words right before a relation say that its left side is constant."""
        return _CONSTANT.search(self._text_before(chain).rstrip()) is not None

    def dead_centre(self, chain: Chain) -> bool | None:
        """Return whether a relation's sentence names bottom dead centre, False for top, else None.

        What stands right behind a relation counts before what stands in front of it.
        """
        behind = self.place_behind(chain)
        if behind is not None and behind.degrees in (0, 180):
            return behind.degrees == 180
        words = self.sentence_before(chain)
        words = self._english(words if words.strip(_OPENING) else self._introduction_above(chain))
        named = dead_centre_named(words)
        last = last_place(words)
        if named is not None and last is not None and last.degrees not in (0, 180):
            return None  # at another angle since
        if named is not None or _THERE.match(self.document.text, chain.end) is None:
            return named
        return dead_centre_named(self._english(self._section_before(chain)))

    def sentence_before(self, chain: Chain) -> str:
        """Return what a relation's sentence says before it."""
        text = self.document.text[max(0, chain.start - LONGEST_SENTENCE) : chain.start]
        return _SENTENCE_OR_ITEM.split(text)[-1]

    def _introduction_above(self, chain: Chain) -> str:
        """Return the open sentence of the paragraph above a formula that begins its own."""
        text = self.document.text[max(0, chain.start - LONGEST_SENTENCE) : chain.start]
        above = text.rstrip(_OPENING)
        return "" if above.endswith(_ENDS) else _SENTENCE_OR_ITEM.split(above)[-1]

    def place_before(self, chain: Chain) -> PlaceInWords | None:
        """Return the place at which words right before a letter's value put it, or None."""
        last = self.last_above(chain.sides[0].node, chain.start)
        first = max(chain.start - LONGEST_INTRODUCTION, last.end if last else 0)
        words = self.document.text[first : chain.start]
        return last_place(self._english(_SENTENCE_OR_ITEM.split(words)[-1]))

    def place_of_sentence(self, chain: Chain) -> PlaceInWords | None:
        """Return the place that a relation's sentence or heading names before it, or None."""
        named = last_place(self._english(self.sentence_before(chain)))
        if named is not None or self.end_of_angle_headed(chain.lines[0]) is None:
            return named
        angles = [*_WHOLE_DEGREES.finditer(self.heading_above(chain.lines[0]))]
        return PlaceInWords(int(angles[-1]["degrees"])) if angles else None

    def place_behind(self, chain: Chain) -> PlaceInWords | None:
        """Return the place at which words right behind a letter's value put it, or None."""
        words = re.split(
            r"[.;,:。、=]", self.document.text[chain.end : chain.end + LONGEST_INTRODUCTION]
        )[0]
        first = first_place(self._english(words))
        is_next = first is not None and _RIGHT_BEHIND.fullmatch(words[: first.start]) is not None
        return first if is_next else None

    def place_named(self, chain: Chain) -> PlaceInWords | None:
        """Return the place of the crank that a relation's sentence names last before it, or None."""
        return last_place(self._english(self.sentence_before(chain)))

    def is_at_another_place(self, chain: Chain) -> bool:
        """Tell whether words place a value elsewhere than its last one: at 0°, then at 180°.

        The last one may have its angle in its own formula: sin β = λ sin 30°, then sin β at 60°.
        """
        last = self.last_above(chain.sides[0].node, chain.sides[0].span[0])
        if last is None:
            return False
        text, first = self.document.text, last.end
        if chain.start - first > LONGEST_SENTENCE:
            first = max(first, self.start_of_line(self.paragraph_start(chain.lines[0])))
        here = last_place(self._english(text[first : chain.start]))
        before = self._english(text[max(0, last.start - LONGEST_INTRODUCTION) : last.start])
        there = last_place(before)
        own = {int(match["degrees"]) for match in _WHOLE_DEGREES.finditer(text, last.start, last.end)}
        if len(own) == 1 and isinstance(last.sides[0].node, Call):
            there = PlaceInWords(own.pop())
        return here is not None and there is not None and here.degrees != there.degrees

    def is_of_another_body(self, chain: Chain, name: str) -> bool:
        """Tell whether a letter's formula is that of a ring, say, and its last one that of a disc."""
        starts, chains = self._by_start
        before = chains[: bisect_left(starts, chain.sides[0].span[0])]
        last = next((c for c in reversed(before) if c.sides[0].node == Name(name)), None)
        here = body_named(self.document.text, chain.start)
        there = "" if last is None else body_named(self.document.text, last.start)
        return here != "" != there and here.rstrip("s") != there.rstrip("s")

    def is_introduced_as_any(self, chain: Chain, name: str) -> bool:
        """Tell whether the words of a relation's paragraph name a letter as any: for a bank angle 2γ."""
        line = chain.lines[0]
        first = self.paragraph_start(line)
        while first > 1 and _SET_OFF.match(self.lines[first - 1]):  # the words above a display
            above = next((n for n in range(first - 1, 0, -1) if self.lines[n - 1].strip()), 0)
            if not above:
                break
            first = self.paragraph_start(above)
        begin = max(self.start_of_line(first), chain.start - 4 * LONGEST_SENTENCE)
        ways = "|".join(
            re.escape(way) for way in {f"\\{name}", name, formula_text(Name(name), plain=True)}
        )
        pattern = rf"(?:{_ANY})[^.;!?。；=\n]{{0,60}}?(?<![A-Za-z\\])(?:{ways})(?![A-Za-z0-9_])"
        return re.search(pattern, self.document.text[begin : chain.start], re.IGNORECASE) is not None

    def sentence_leading_to(self, chain: Chain) -> str:
        """Return the sentence before a relation, be it that of the paragraph above a display."""
        text = self.document.text[max(0, chain.start - LONGEST_SENTENCE) : chain.start]
        text = _DISPLAY_LAST.sub("", text.rstrip(_OPENING)).rstrip(_OPENING)
        return re.split(r"[.;!?]\s|[。；]|\n\s*\n", text)[-1]

    def _section_before(self, chain: Chain) -> str:
        """Return the text of a relation's section before it, with its heading."""
        line = chain.lines[0]
        first = max((heading for heading in self._headings if heading <= line), default=1)
        start = chain.start
        return self.document.text[self.start_of_line(first) : start]

    def _text_before(self, chain: Chain) -> str:
        """Return the words before a relation, without the marks that begin and end displays."""
        start = chain.start
        before = self.document.text[max(0, start - LONGEST_INTRODUCTION) : start]
        return _DISPLAY.sub(".", _DISPLAY_LAST.sub("", before.rstrip(_OPENING))).rstrip(_OPENING)

    def same_section(self, first: int, second: int) -> bool:
        """Tell whether no heading stands between two lines."""
        return self.section_end(min(first, second)) >= max(first, second)

    def same_exercise(self, first: int, second: int) -> bool:
        """Tell whether neither a heading nor a numbered line begins between two lines: "10. Torque"."""
        low, high = sorted((first, second))
        numbered = any(_NUMBERED.match(line) for line in self.lines[low:high])
        return self.same_section(first, second) and not numbered

    def paragraph_start(self, line: int) -> int:
        """Return the first line of the paragraph that a line stands in."""
        return self._paragraphs[line - 1][0]


def _level(heading: str) -> int:
    """Return how deep a heading is by its marks, one more than the first; 1 where it has none.

    >>> _level("### Example"), _level(r"\\subsection{Example}"), _level("Example")
    (3, 4, 1)
    """
    if (mark := _MARK_OF_LEVEL.match(heading)) is None:
        return 1
    return _RANKS.index(mark["rank"]) + 1 if mark["rank"] else len(mark["marks"])


def _gives(chain: Chain, name: str) -> bool:
    """Tell whether a letter is a side of a chain, alone."""
    return any(isinstance(side.node, Name) and side.node.name == name for side in chain.sides)


def _angle_headed(words: str) -> Iterator[str]:
    """Yield what a heading with an angle has in common with that of another case: form and letter."""
    form = _NUMBER_OR_MARK.sub("#", words)
    angle = _ANGLE_IN_FORM.search(form)
    if angle:
        yield form
        if angle["letter"]:
            yield angle["letter"]


_NUMBER_OR_MARK = re.compile(r"[0-9]+(?:(?:[.,]|\{,\})[0-9]+)?|(?<![A-Za-z\\])[A-H](?![A-Za-z])")
_DEGREES = (
    r"[\s$~]*(?:\\,)?(?:°|&deg;|\^?\{?\\circ|\\degree|\\dg|(?:degrees?|deg|Grad|degrés)(?![A-Za-z])|度)"
)
_ANGLE_IN_FORM = re.compile(rf"(?:(?P<letter>\\?[^\W\d]\w{{0,12}})[\s$]*=[\s$]*[-−+]?)?#{_DEGREES}")
_WHOLE_DEGREES = re.compile(rf"(?<![\w.,])(?P<degrees>[0-9]{{1,3}}){_DEGREES}")
_PLACE_HEADING = re.compile(
    r"(?:[#=*\s]|\d{1,2}[.)]|[a-z]\)|\\(?:sub){0,2}section\*?\{|\\paragraph\{)*"
    r"(?:(?:at|for|bei|für|à|pour|cas[eo]?|fall|position|stellung|point|punk?to?|posi[cz]i[oó]ne?|instant|位置|angle|winkel|kurbelwinkel|crank\s+angle)\s+)*"
    r"\$?(?:\\?[a-zA-Zα-ω]{1,10}\s*=\s*)?[0-9]{1,3}(?:[.,][0-9])?\s*\$?(?:°|\^?\{?\\circ\}?|degrees?|deg|Grad|度)"
    r"(?:\s*の場合)?[\s:$}#=*]*",
    re.IGNORECASE,
)
"""A heading that is an angle of the crank and nothing else: what stands below is of that moment."""
_IDENTITY = re.compile(
    r"(?<![^\W\d_])(?:identit(?:y|ies)|identität|identité|identità|identidad)(?:\s+\w+){0,2}[\s:$]*$|恒等式\w{0,3}[\s:：$]*$",
    re.IGNORECASE,
)
_OPEN_END = re.compile(
    r"(?::|(?<![A-Za-z])(?:then|is|gives?|so|thus|hence|dann|ist|gilt|wird|ergibt|folgt|also|alors|donc)"
    r"|[はとで、])[\s$]*$",
    re.IGNORECASE,
)
"""The end of a paragraph that leads on to the formula below it."""
_AND_ONLY = re.compile(r"[\s$,]*(?:and|und|et|y|e|sowie|と|、)[\s$]*")
"""Between two formulas of which the words before the first one speak."""
_FORMULA_ALONE = re.compile(r"\s*\$[^$]{1,400}\$[^$]{0,12}")
_SET_OFF = re.compile(r"\s*(?:\$\$|\\\[|\\begin\s*\{|```math|<math|\+\+\+\+|\[stem\])|\s{4}")
"""How a display begins."""
