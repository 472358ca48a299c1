"""The place of the crank that words name: at top dead centre, at 60°, for θ = 60°."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from symbalance.document.formula import Constant, Formula, Number, Product, Quotient
from symbalance.document.letters import is_greek
from symbalance.notes.reading.letters.macro_letters import letter_in
from symbalance.text import lazy_patterns as re

HALF_TURN = 180
"""Degrees."""
_DEAD = r"\s+(?:dead[\s-](?:cent(?:re|er)|point|position)s?|Totpunkte?s?|Totlagen?)"
_TOP = rf"(?:top|inner|upper|front|oberen?r?|inneren?r?|vorderen?r?){_DEAD}|上死点"
_BOTTOM = rf"(?:bottom|outer|lower|back|rear|unteren?r?|äußeren?r?|hinteren?r?){_DEAD}|下死点"
"""Of an engine that lies, a locomotive's, the front one is its top."""
_SHORT_TOP, _SHORT_BOTTOM = r"(?<![A-Za-z])(?:TDC|OT)(?![A-Za-z])", r"(?<![A-Za-z])(?:BDC|UT)(?![A-Za-z])"
_DEAD_CENTRE = re.compile(
    rf"(?i:(?P<top>{_TOP})|(?P<bottom>{_BOTTOM}|(?:im|at\s+the|am)\s+(?:unteren|outer|lower|bottom)))"
    rf"|(?P<short_top>{_SHORT_TOP})|(?P<short_bottom>{_SHORT_BOTTOM})"
)
_FROM = re.compile(
    r"(?<![^\W\d_])(?:from|after|past|since|ab|vom?|nach|seit|aus|depuis|après|desde|dal?|dopo)\s"
    r"(?:(?:the|its|dem|der|le|el|il)\s)?$",
    re.IGNORECASE,
)
"""Before a dead centre that a path or an angle is counted from: Kolbenweg ab OT."""
_TURN_BEFORE = (
    r"(?:after|past|nach|après|dopo|tras|después\s+(?:de|of)|depois\s+(?:de|of)|na|efter)\s+(?:(?:an?|one|the|einer|der|une?|le|la|una?|el"
    r"|um|uma|een|en|ett|et)\s+)?"
)
_QUARTER_TURN = (
    rf"{_TURN_BEFORE}(?:quarter(?:[\s-]+(?:of\s+a\s+|of\s+the\s+)?)(?:turn|revolution)|viertel\s?(?:um)?drehung"
    r"|quart\s+(?:de|of)\s+tour|quarto\s+(?:di|de|of)\s+(?:giro|volta)|cuarto\s+(?:de|of)\s+vuelta|kwart(?:\s?slag|\s+omwenteling)"
    r"|kvarts?\s+varv)(?![^\W\d_])"
    r"|(?:(?:4|四)\s?分の\s?(?:1|一)|1/4|¼)\s?回転(?:した|すると|後|では|のとき|して)"
)
_HALF_TURN_LATER = (
    rf"{_TURN_BEFORE}(?:half(?:\s+an?|\s+of\s+a)?[\s-]+(?:turn|revolution)|halben\s+(?:Um)?drehung|demi[\s-]tour|mezzo\s+giro"
    r"|medi[ao]\s+(?:giro|vuelta)|mei[ao]\s+volta|halve\s+(?:slag|omwenteling)|halvt\s+varv)(?![^\W\d_])"
    r"|(?:半|(?:2|二)\s?分の\s?(?:1|一)|1/2|½)\s?回転(?:した|すると|後|では|のとき|して)"
)
"""By how much the crank has turned since its start, the top: after a quarter turn."""
_PLACE = re.compile(
    rf"(?P<quarter>{_QUARTER_TURN})|(?P<half>{_HALF_TURN_LATER})"
    rf"|(?P<top>{_TOP}|{_SHORT_TOP})|(?P<bottom>{_BOTTOM}|{_SHORT_BOTTOM})"
    r"|(?<![A-Za-z])(?:at|for|bei|für|fuer|pour|à|en|przy|vid|per|para|when|wenn|quand|lorsque)\s+(?:an?\s+(?:crank\s+)?angle\s+of\s+)?"
    r"(?:\$?(?P<letter>\\?[a-zθφαψβ]{1,8})\$?\s?(?:=|(?:is|ist|est|equal\s+to|equals|gleich|égale?\s+à|vaut|è|uguale\s+a|es|igual\s+a)\s)\s?)?\$?"
    r"(?P<at>[0-9]{1,3})\s?\$?(?:°|\^\{?\\circ|degrees?|Grad)|(?P<when>[0-9]{1,3})\s?(?:°|度)\$?(?:では|のとき)"
    r"|(?P<alone>[αβγθφϕψ]|\\(?:alpha|beta|gamma|theta|varphi|phi|psi))\s?=\s?(?P<value>[0-9]{1,3})\s?(?:°|\^\{?\\circ)",
    re.IGNORECASE,
)
"""Where a value is taken: at a dead centre, or at an angle."""


_TILTED = re.compile(
    r"(?<![^\W\d_])(?:inclined|tilted|spaced|arranged|offset|mounted|placed|geneigt|versetzt|angeordnet"
    r"|inclin[ée]e?s?|décal[ée]e?s?|inclinat[aeio]|inclinad[ao]s?|sfalsat[aeio])\s$",
    re.IGNORECASE,
)
"""Before an angle between parts: cylinders inclined at 60°."""


@dataclass(frozen=True, slots=True)
class PlaceInWords:
    """An angle that words name, in whole degrees, with the letter they give it and where they begin."""

    degrees: int
    letter: str = ""
    """As the page writes it; "" where words name none."""
    start: int = 0

    @property
    def angle(self) -> Formula:
        """The angle in radians.

        >>> PlaceInWords(60).angle == Quotient(Constant("pi"), Number(Fraction(3)))
        True
        """
        turn = Fraction(self.degrees, HALF_TURN)
        if turn.denominator == 1:
            return _times_pi(turn) if turn else Number(turn)
        return Quotient(_times_pi(Fraction(turn.numerator)), Number(Fraction(turn.denominator)))

    def may_be_of(self, angle: str, document: str) -> bool:
        """Tell whether the place may be one of an angle of the page: for θ = 60° is none of φ.

        >>> PlaceInWords(60, "θ").may_be_of("phi", ""), PlaceInWords(60, "φ").may_be_of("varphi", "")
        (False, True)
        """
        name = letter_in(document, self.letter) if self.letter else None
        if name is None or (len(name) > 1 and not is_greek(name)):  # "for angle = 60°"
            return True
        return name.removeprefix("var") == angle.removeprefix("var")


def _times_pi(number: Fraction) -> Formula:
    return Constant("pi") if number == 1 else Product((Number(number), Constant("pi")))


def last_place(words: str) -> PlaceInWords | None:
    """Return the place that words name last, None where they name none.

    >>> last_place("at TDC, then for θ = 60°")
    PlaceInWords(degrees=60, letter='θ', start=13)
    """
    places = [*_places(words)]
    return places[-1] if places else None


def first_place(words: str) -> PlaceInWords | None:
    """Return the place that words name first, None where they name none."""
    return next(_places(words), None)


def _places(words: str) -> Iterator[PlaceInWords]:
    for match in _PLACE.finditer(words):
        is_centre = match["top"] or match["bottom"]
        if is_centre and _FROM.search(words, max(match.start() - 16, 0), match.start()):
            continue  # what is counted from there is not taken there
        if not is_centre and _TILTED.search(words, max(match.start() - 16, 0), match.start()):
            continue
        turned = 90 if match["quarter"] else 0 if match["top"] else 180
        degrees = match["at"] or match["when"] or match["value"] or turned
        yield PlaceInWords(int(degrees), match["letter"] or match["alone"] or "", match.start())


def dead_centre_named(words: str) -> bool | None:
    """Return whether words name bottom dead centre, False for top, None where they name neither.

    What is counted from one is not taken there.

    >>> dead_centre_named("Massenkraft im OT:"), dead_centre_named("at the crank pin")
    (False, None)
    >>> dead_centre_named("Kolbenweg ab OT:") is None
    True
    """
    matches = [
        match
        for match in _DEAD_CENTRE.finditer(words)
        if not _FROM.search(words, max(match.start() - 16, 0), match.start())
    ]
    return None if not matches else bool((matches[-1].lastgroup or "").endswith("bottom"))


_OTHER_TOP = (
    r"point\s+mort\s+haut|punto\s+(?:morto|muerto)\s+superiore?|(?<![A-Za-z])(?:PMH|PMS)(?![A-Za-z])"
)
_OTHER_BOTTOM = (
    r"point\s+mort\s+bas|punto\s+(?:morto|muerto)\s+inferiore?|(?<![A-Za-z])(?:PMB|PMI)(?![A-Za-z])"
)
_TOPS = re.compile(rf"(?i:{_TOP}|{_OTHER_TOP})|{_SHORT_TOP}")
_BOTTOMS = re.compile(rf"(?i:{_BOTTOM}|{_OTHER_BOTTOM})|{_SHORT_BOTTOM}")


def with_dead_centres(words: str) -> str:
    """Return words in which a dead centre has one name, whatever the page calls it.

    >>> with_dead_centres("at BDC, im oberen Totpunkt")
    'at bottom, im top'
    """
    return _BOTTOMS.sub("bottom", _TOPS.sub("top", words))
