"""Words of pages in other languages are read by their English terms, and no others are touched."""

import re

import pytest

from symbalance.checking import check
from symbalance.notes.checking.words import glossary
from symbalance.notes.checking.words.glossary import Glossary, glossary_of, language_of
from tests import TESTS

LANGUAGES = sorted({*glossary._MARKERS} - {"english", "german"})
SENTENCES = {
    "french": "La force d'inertie du second ordre et le moment d'inertie du volant",
    "spanish": "La fuerza de inercia de segundo orden y el momento de inercia del volante",
    "italian": "La forza d'inerzia del secondo ordine e il momento d'inerzia del volano",
    "dutch": "De massakracht van de tweede orde en het traagheidsmoment van het vliegwiel",
    "polish": "Siła bezwładności drugiego rzędu oraz moment bezwładności koła zamachowego",
    "portuguese": "A força de inércia de segunda ordem e o momento de inércia do volante",
    "swedish": "Masskraften av andra ordningen och svänghjulets tröghetsmoment är stora",
    "czech": "Setrvačná síla druhého řádu se má k momentu; moment setrvačnosti setrvačníku",
}
HAND = sorted(p for p in (TESTS / "hand").iterdir() if p.suffix in (".md", ".tex", ".txt", ".html"))


@pytest.mark.parametrize("language", LANGUAGES)
def test_each_language_is_told_and_its_terms_are_put_in_english(language):
    sentence = SENTENCES[language]
    assert language_of(sentence) == language
    words = glossary_of(sentence).english(sentence)
    for term in ("inertia force", "second order", "moment of inertia", "flywheel"):
        assert term in words


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_term_is_a_letter_of_formulas_and_every_one_can_be_matched(language):
    for first, terms in glossary._tables(language).items():
        assert first.isalnum()
        for own, english in terms:
            assert re.fullmatch(r"[A-Za-z -]+", english)
            assert not any(own.fullmatch(letter) for letter in "abcdefghijklmnopqrstuvwxyz")


@pytest.mark.parametrize("page", HAND, ids=lambda p: p.name)
def test_english_german_and_japanese_pages_are_read_as_they_stand(page):
    assert language_of(page.read_text(encoding="utf-8")) == ""


def test_formulas_and_commands_stay_as_they_are():
    text = r"$m_{os} = \le x_{de}$, $\alpha$"
    assert Glossary("portuguese").english(text) == text
    assert Glossary("french").english(text) == text


def test_a_verdict_quotes_the_page_and_not_the_english_term():
    page = "La poussée latérale du piston sur la paroi du cylindre est $N = F_p\\tan\\beta$.\n"
    (verdict,) = check(page, {}).verdicts
    assert "taken from the words “poussée latérale”" in verdict.assumption
