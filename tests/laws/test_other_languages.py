"""Words of pages in other languages are read by their English terms, and no others are touched."""

import re

import pytest

from symbalance.checking import check
from symbalance.notes.checking.words import glossary
from symbalance.notes.checking.words.glossary import Glossary, glossary_of, language_of
from tests import TESTS
from tests.checked_pages import last_verdict

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


CRANK = (
    "$r$ est le rayon de manivelle, $\\theta$ l'angle de manivelle, $\\beta$ l'obliquité de la bielle."
    " La course $2r$ vaut 80 mm.\n\n"
)


@pytest.mark.parametrize(("sign", "verdict"), [("+", ("conditional",)), ("-", ("refuted",))])
@pytest.mark.parametrize(
    "words",
    [
        "Si les gaz poussent le piston de $F$, le couple des gaz est\n",
        "La force des gaz sur le piston est $F$. Le couple moteur vaut\n",
    ],
)
def test_a_noun_that_begins_a_clause_names_no_letter_before_it(tmp_path, words, sign, verdict):
    formula = f"$$M = F r \\frac{{\\sin(\\theta{sign}\\beta)}}{{\\cos\\beta}}$$"
    assert last_verdict(tmp_path, CRANK + words + formula) in verdict


@pytest.mark.parametrize(
    "data",
    [
        "La masse volumique de la fonte est $\\rho = 7200$ kg/m³, la vitesse $v = 40$ m/s.",
        "Die spezifische Masse ist $\\rho = 7200$ kg/m³, die Geschwindigkeit $v = 40$ m/s.",
        "La massa volumica è $\\rho = 7200$ kg/m³, la velocità $v = 40$ m/s.",
    ],
)
def test_a_mass_by_volume_is_no_mass(tmp_path, data):
    symbols = '[symbols]\n"\\\\rho" = "masse volumique de la fonte"\n"\\\\sigma" = "contrainte"\n'
    assert last_verdict(tmp_path, f"{data}\n\n$\\sigma = \\rho v^2$", symbols) == "definition"


def test_a_density_by_another_name_has_its_dimension(tmp_path):
    page = "$\\rho = 7200$ kg/m³, $v = 40$ m/s, $\\rho v^2 = 11.52$ {}"
    assert last_verdict(tmp_path, page.format("MPa")) in ("holds", "holds_to_order")
    assert last_verdict(tmp_path, page.format("MN")) == "refuted"
