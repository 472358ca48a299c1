"""Data that labels give to several things, engine A and engine B, and which of them a result is of.

Two labels that give one letter two numbers name two cases: Old and new, before and after, (a) and (b),
Cylinder 1 and Cylinder 2, steel and aluminium. A result whose words open with such a label, or that has
it right behind, is of that one alone: "for A, P = 31.4 kW", "old η = 0.585", "p = 600 (before)".
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

from symbalance.document.formula import Formula, Name
from symbalance.notes.checking.words.labels_of_cases import without_comparisons
from symbalance.notes.checking.words.lists_of_data import sets_number
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

Label = tuple[str, ...]
"""The words of a label without their endings, and without articles: ("cylinder", "1")."""
_REACH, MOST_WORDS = 160, 4
"""Characters before a relation that are looked at, and words of a label."""
_CONJUNCTION = (
    r"(?<![^\W\d_])(?:and|but|while|whereas|or|und|aber|während|dagegen|oder|et|mais|tandis\s+que|ou|e|ma|mentre|o|y|pero|mientras)"
    r"(?![^\W\d_])"
)
_BOUNDARY = re.compile(
    rf"(?P<end>[.!?](?=\s|$|\*)|[;。；])|(?P<wrap>\n)|[:：,、，]|{_CONJUNCTION}", re.IGNORECASE
)
"""What parts clauses: the ends of sentences and lines, colons, commas and conjunctions."""
_LEAD = re.compile(
    r"[\s*_>#$\\({\[•–—-]*(?:item\b\s*)?"
    r"(?:(?:now|then|so|hence|thus|therefore|again|finally|similarly|likewise|nun|dann|also|wieder|ebenso|donc|alors|puis|ora|poi|quindi"
    r"|ahora|luego)\s+)?"
    r"(?:(?:for|at|in|with|of|under|during|on|für|bei|beim|im|am|zu|mit|von|pour|à|au|avec|dans|en|de|per|con|nel|nella|di|del|para)\s+)?"
    r"(?:(?:the|der|die|das|den|dem|des|le|la|les|du|il|lo|gli|el|los|las)\s+|l['’])?",
    re.IGNORECASE,
)
"""What may stand before a label: "so for the", a mark of a list."""
_TOKEN = re.compile(r"[^\W\d_]+|[0-9]+|\([a-z0-9]{1,3}\)|[a-z]\)", re.IGNORECASE)
_PARTICLE = re.compile(r"(?<=[\u3040-\u9fffA-Z0-9])(?:の(?:場合|とき|方)(?:は|に)?|では|には|は|の)$")
_ENDING = re.compile(r"(?<=[^\W\d_]{3})(?:en|em|er|es|e|s|n)$")
_ITEM = re.compile(
    r"(?P<label>\([a-hA-H1-9]\)|\((?:i{1,3}|iv|v)\)|(?<![\w(])[a-h]\))[*_]{0,2}\s*[:：,]?[\s*_$\\(]*$"
)
"""The mark of an item right before a relation: (a), b)."""
_CONTRAST = re.compile(
    r"(?:the\s+|der\s+|die\s+|das\s+|dem\s+|im\s+|le\s+|la\s+|il\s+|el\s+)?(?:old|new|before|after|first|second|third|former|latter|initial|initially"
    r"|final|finally|start|end|beginning|empty|loaded|unloaded|cold|hot|warm|idle|alte[nrsm]?|neue?[nrsm]?|vorher|nachher|anfangs|anfang|ende"
    r"|erste[nrsm]?|zweite[nrsm]?|leer|beladen|kalt|warm|avant|après|ancien|ancienne|nouveau|nouvelle|début|fin|vide|chargé|premi[eè]re?"
    r"|deuxième|prima|dopo|vecchio|vecchia|nuovo|nuova|primo|secondo|inizio|vuoto|carico|antes|después|viejo|vieja|nuevo|nueva|primer[oa]?"
    r"|segund[oa]|inicio|vacío|cargado|前|後|旧|新|変更前|変更後|最初|最後)"
    r"|[^\W\d_]{3,20}\s+(?-i:[A-Z]|[0-9]|[IVX]{1,3})|(?-i:[A-Z])",
    re.IGNORECASE,
)
"""A label that tells two things apart without a colon: old, before, engine A."""
_NO_LABEL = re.compile(
    r"(?:given|data|find|wanted|sought|solution|solutions|result|results|check|checks|summary|conclusion|note|notes|remark|answer|answers"
    r"|step|proof|hint|where|so|then|hence|thus|therefore|formula|equation|with|here|wrong|right|correct|corrected|correction|better|exact"
    r"|exactly|approximately|rounded|known|let|take|assume|from|gegeben|gesucht|lösung|ergebnis|probe|kontrolle|schritt|also|daten|falsch"
    r"|richtig|genau|gerundet|gerechnet|mit|données|donnée|résultat|vérification|étape|donc|faux|correct|dati|risultato|verifica|datos|resultado"
    r"|comprobación|解|答|結果|検算|与|条件|測定|measured|computed|calculated|gemessen|berechnet|mesuré|calculé)$",
    re.IGNORECASE,
)
"""Words before a colon that name no thing: given, check, solution."""
_BEHIND_LABEL = re.compile(
    r"(?:has|have|had|is|are|was|were|gives?|gets?|yields?|we|it|one|the|this|its|an?|hat|haben|ist|sind|war|wird|werden|gilt|ergibt|gibt|beträgt"
    r"|der|die|das|man|wir|sich|le|la|les|il|on|est|était|donne|vaut|ha|è|dà|vale|el|tiene|es|da|su|there|here|only"
    r"|engines?|motors?|machines?|cylinders?|rods?|pistons?|springs?|shafts?|values?|states?|cases?|versions?|design|one|bodies|body|stage|wheel|tank"
    r"|motor|maschine|zylinder|stange|kolben|feder|welle|wert|zustand|fall|version|körper|rad"
    r"|moteur|machine|cylindre|bielle|piston|ressort|arbre|valeur|état|cas|motore|cilindro|valore|stato|caso|estado|valor)$",
    re.IGNORECASE,
)
"""What may follow a label in its clause: a verb, an article, or the kind of thing that it is of."""
_OF = re.compile(
    r"(?<![^\W\d_])(?:for|at|in|with|of|on|für|bei|beim|im|in|von|vom|an|des|der|pour|de|du|à|au|dans|per|di|del|della|con|para)\s+"
    r"(?:(?:the|der|die|das|den|dem|la|le|il|el)\s+)?",
    re.IGNORECASE,
)
"""Before a label within a clause: the force on cylinder 1."""
_IN_TIME = re.compile(
    r"(?:before|after|avant|après|prima|dopo|antes|después|vorher|nachher)$", re.IGNORECASE
)
"""Labels that also open a clause of their own, before we …, of which only a verb of being may follow."""
_IS = re.compile(r"(?:is|are|was|were|it|ist|sind|war|est|était|è|era|es)$", re.IGNORECASE)
_ORDINAL = re.compile(
    r"(?:first|second|third|final|former|latter|erste[nrsm]?|zweite[nrsm]?|dritte[nrsm]?|premi[eè]re?|deuxième|primo|second[oa]|primer[oa]?"
    r"|segund[oa])$",
    re.IGNORECASE,
)
"""Labels that count steps too, where no article stands before them: first, p = 1200."""
_ARTICLE = re.compile(r"(?:the|der|die|das|den|dem|des|im|beim|le|la|du|il|el|del|al)\s+$", re.IGNORECASE)
_BEHIND = re.compile(
    r"[\s$)\]}~]{0,6}(?:\((?P<aside>[^.,;:!?()$=\n。、]{1,40})\)|(?P<words>[^\W\d_][^.,;:!?()$=\n。、]{0,40}?))"
    rf"(?=\s*(?:[.,;:!?。、]|\n|$|{_CONJUNCTION}))",
    re.IGNORECASE,
)
"""The words right behind a relation, to the end of their clause."""


class Labelled(NamedTuple):
    """A label in its place, with the relation that it stands before."""

    label: Label
    chain: Chain


class LabelledData:
    """The numbers that a page's labels give, where two labels give one letter two of them."""

    def __init__(self, sections: Sections) -> None:
        self._sections = sections
        self._text = sections.document.text
        self._own: dict[int, Label | None] = {}

    def numbers_at(self, chain: Chain) -> Mapping[str, Chain]:
        """Return what gives letters their numbers in the case that a relation is of; empty for none."""
        label = self.label_of(chain) if self.givers else None
        if label is None:
            return {}
        given: dict[str, Chain] = {}
        for name, givers in self.givers.items():
            own = [g.chain for g in givers if g.label == label and g.chain.start < chain.start]
            if own:
                given[name] = own[-1]
        return given

    def of_others(self, chain: Chain) -> frozenset[str]:
        """Return the letters that labels give numbers, but not the label of a relation."""
        return frozenset(self.givers.keys() - self.numbers_at(chain).keys())

    def is_another(self, chain: Chain, before: Chain) -> bool:
        """Tell whether two relations give one letter its number in two labelled cases."""
        givers = (
            self.givers.get(chain.sides[0].node.name, ()) if isinstance(chain.sides[0].node, Name) else ()
        )
        own = {g.chain.start: g.label for g in givers}
        labels = own.get(chain.start), own.get(before.start)
        return None not in labels and labels[0] != labels[1]

    def gives(self, chain: Chain) -> bool:
        """Tell whether a relation is one of those that give the labelled numbers."""
        return chain.start in self._starts

    @cached_property
    def _starts(self) -> frozenset[int]:
        return frozenset(g.chain.start for givers in self.givers.values() for g in givers)

    @cached_property
    def givers(self) -> dict[str, list[Labelled]]:
        """The letters that two labels of one section give two numbers, with what gives them."""
        by_letter: dict[tuple[int, str], list[Labelled]] = defaultdict(list)
        for label, chains in self._blocks():
            first = {c.sides[0].node: c for c in reversed(chains)}
            for head, chain in reversed(first.items()):
                if isinstance(head, Name) and not self._sections.has_formula_above(head, chain.start):
                    home = self._sections.section_start(chain.lines[0])
                    by_letter[home, head.name].append(Labelled(label, chain))
        found: dict[str, list[Labelled]] = defaultdict(list)
        for (_, name), givers in by_letter.items():
            if any(_tell_apart(a, b) for a, b in pairwise(givers)):
                found[name] += givers
        return dict(found)

    @cached_property
    def _labels(self) -> frozenset[Label]:
        return frozenset(g.label for givers in self.givers.values() for g in givers)

    def _blocks(self) -> Iterator[tuple[Label, list[Chain]]]:
        """Yield each label with the relations behind it in its paragraph that set numbers."""
        label: Label = ()
        own: list[Chain] = []
        last: Chain | None = None
        for chain in self._sections.in_order:
            opened = self._opened(chain, last) if sets_number(chain) else None
            if opened is None and label and last is not None and self._is_left(last, chain):
                yield label, own
                label, own = (), []
            if opened is not None:
                if label:
                    yield label, own
                label, own = opened, [chain]
            elif label and sets_number(chain):
                own.append(chain)
            last = chain
        if label:
            yield label, own

    def _is_left(self, last: Chain, chain: Chain) -> bool:
        """Tell whether a relation stands in another paragraph than the one before it."""
        return self._sections.paragraph_start(chain.lines[0]) != self._sections.paragraph_start(
            last.lines[0]
        )

    def _opened(self, chain: Chain, last: Chain | None) -> Label | None:
        """Return the label that stands before a datum and may open the data of a thing; None for none."""
        words, _ = self._words_before(chain, last)
        if (item := _ITEM.search(words)) is not None:
            return _label(item["label"])
        parts = _clauses(words, is_behind_formula=last is not None and self._is_near(chain, last))
        for clause, mark in reversed(parts):
            shown = clause.strip(" \t\n$\\({[*_")
            if not shown:
                continue
            shown = _without_lead(shown)
            label = _label(shown)
            is_word = 0 < len(label) <= MOST_WORDS and not _NO_LABEL.match(_TOKEN.findall(shown)[0])
            is_told = mark in (":", "：") or _CONTRAST.fullmatch(shown.strip()) is not None
            return label if is_word and is_told else None
        return None

    def _is_near(self, chain: Chain, last: Chain) -> bool:
        return last.end > chain.start - _REACH and not self._is_left(last, chain)

    def _words_before(self, chain: Chain, last: Chain | None) -> tuple[str, bool]:
        """Return the words of a paragraph behind the relation before one, and if there is any."""
        sections = self._sections
        first = sections.start_of_line(sections.paragraph_start(chain.lines[0]))
        is_near = last is not None and last.end >= first
        start = max(first, chain.start - _REACH, last.end if last is not None else 0)
        return self._text[start : chain.start], is_near

    def label_of(self, chain: Chain) -> Label | None:
        """Return the label of the thing that a relation is of by its words, None where they tell none."""
        if chain.start not in self._own:
            self._own[chain.start] = None
            self._own[chain.start] = self._told(chain)
        return self._own[chain.start]

    def is_of_several(self, chain: Chain) -> bool:
        """Tell whether the words before a relation name several labels: for A and B."""
        return bool(self.givers) and self._before(chain)[1]

    def numbers_of_each(self, chain: Chain) -> list[dict[str, Chain]]:
        """Return what gives letters their numbers above a relation, for each label."""
        every: dict[Label, dict[str, Chain]] = defaultdict(dict)
        for name, givers in self.givers.items():
            for giver in givers:
                if giver.chain.start < chain.start:
                    every[giver.label][name] = giver.chain
        return list(every.values())

    def _told(self, chain: Chain) -> Label | None:
        """Return the label of a relation: its own, or that of the one before it in its sentence."""
        behind = self._behind(chain)
        before, is_several = self._before(chain)
        if is_several or (behind is not None and before is not None and behind != before):
            return None
        if behind is not None or before is not None:
            return behind or before
        last = self._sections.chain_before(chain.start)
        if last is None or self._is_left(last, chain) or last.end < chain.start - _REACH:
            return None
        words = self._text[last.end : chain.start]
        ends = any(match["end"] for match in _BOUNDARY.finditer(words))
        return None if ends or self._behind(last) is not None else self.label_of(last)

    def _behind(self, chain: Chain) -> Label | None:
        match = _BEHIND.match(self._text, chain.end)
        if match is None:
            return None
        words = match["aside"] or match["words"]
        label = _label(_without_lead(words))
        return label if label in self._labels else None

    def _before(self, chain: Chain) -> tuple[Label | None, bool]:
        """Return the label in the words before a relation, and whether they name several."""
        last = self._sections.chain_before(chain.start)
        words, is_near = self._words_before(chain, last)
        words = without_comparisons(words)
        if (item := _ITEM.search(words)) is not None and _label(item["label"]) in self._labels:
            return _label(item["label"]), False
        found: list[Label] = []
        for clause, mark in reversed(_clauses(words, is_behind_formula=is_near)):
            told = self._label_in(clause, mark)
            if told is not None:
                found.append(told[0])
            is_alone = told is not None and told[1]
            if found and clause.strip() and not is_alone:
                break
        if len(set(found)) > 1:
            return None, True  # for A and B
        return (found[0] if found else None), False

    def _label_in(self, clause: str, mark: str) -> tuple[Label, bool] | None:
        """Return the label that a clause opens with, and whether nothing follows it there."""
        lead = _LEAD.match(clause)
        first = lead.end() if lead else 0
        for shown in (clause[first:], clause.strip(" \t\n*_$")):
            tokens = _tokens(shown)
            for count in range(min(MOST_WORDS, len(tokens)), 0, -1):
                label = tuple(_stem(t) for t in tokens[:count])
                rest = tokens[count:]
                if label not in self._labels:
                    continue
                if _ORDINAL.match(tokens[0]) and not (
                    mark in (":", "：") or _ARTICLE.search(clause[:first])
                ):
                    return None
                follows = _IS if _IN_TIME.match(tokens[0]) else _BEHIND_LABEL
                if not rest or follows.match(rest[0]):
                    return label, not rest
        return self._label_within(clause)

    def _label_within(self, clause: str) -> tuple[Label, bool] | None:
        """Return the label that words within a clause name: the force on cylinder 1 is."""
        for match in _OF.finditer(clause):
            tokens = _tokens(clause[match.end() :])
            for count in range(min(MOST_WORDS, len(tokens)), 0, -1):
                label, rest = tuple(_stem(t) for t in tokens[:count]), tokens[count:]
                if label in self._labels and (not rest or _BEHIND_LABEL.match(rest[0])):
                    return label, False
        return None


def _tell_apart(first: Labelled, second: Labelled) -> bool:
    """Tell whether two labels differ, and the numbers that they give."""
    values: Sequence[Formula] = [each.chain.sides[1].node for each in (first, second)]
    return first.label != second.label and values[0] != values[1]


def _clauses(words: str, *, is_behind_formula: bool) -> list[tuple[str, str]]:
    """Return the clauses of the words before a relation with the mark behind each, but the first one.

    Right behind another relation the first one is of that: its unit, or "before" in "p = 600 before,".

    >>> _clauses(" kW; for B, ", is_behind_formula=True)
    [(' for B', ','), (' ', '')]
    """
    parts: list[tuple[str, str]] = []
    place = 0
    for match in _BOUNDARY.finditer(words):
        parts.append((words[place : match.start()], match[0]))
        place = match.end()
        if match["end"] or match["wrap"]:
            parts = parts if match["wrap"] else []
            parts = [] if is_behind_formula else parts
            is_behind_formula = False
    parts.append((words[place:], ""))
    return parts[1:] if is_behind_formula else parts


def _without_lead(words: str) -> str:
    """Return words without what may stand before a label."""
    lead = _LEAD.match(words)
    return words if lead is None else words[lead.end() :]


def _tokens(words: str) -> list[str]:
    return [_PARTICLE.sub("", token) for token in _TOKEN.findall(words)]


def _stem(token: str) -> str:
    """Return a word without its ending; a single capital letter stays one."""
    is_letter = len(token) == 1 and token.isupper()
    return token if is_letter else _ENDING.sub("", token.lower().strip("()"))


def _label(words: str) -> Label:
    """Return the words of a label as they are compared.

    >>> _label("Cylinder 1"), _label("(a)"), _label("neue")
    (('cylind', '1'), ('a',), ('neu',))
    """
    return tuple(_stem(token) for token in _tokens(words))
