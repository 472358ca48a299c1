"""Spellings of letters, arguments and extremes as people type them, with wrong neighbours."""

from __future__ import annotations

import pytest

from symbalance.checking import check as check_with_engines
from symbalance.notes.checking import check

LETTERS = {"theta": "crank angle", "m": "mass", "r": "crank radius", "a": "positive"}

CASES = [
    # a bracket with a function in it is a factor, and no argument of the function before
    ("sin t (1 + q cos t) = sin t + q sin t cos t.", "holds"),
    ("sin t (1 + q cos t) = sin t − q sin t cos t.", "refuted"),
    (r"$\sin t(1 + q\cos t) = \sin t + q\sin t\cos t$", "holds"),
    ("sin 2u (1 − cos u) = sin 2u − sin 2u cos u.", "holds"),
    ("cos t (a + b) = a cos t + b cos t.", "holds"),
    ("cos t (a + b) = a cos t − b cos t.", "refuted"),
    (r"$\cos n(\theta + \alpha) = \cos(n\theta + n\alpha)$", "holds"),
    (r"$\cos p (t - t_0) = \cos(p t - p t_0)$", "holds"),
    ("sin 2x (1 - 2 sin² x) = ½ sin 4x.", "holds"),
    ("2 x (3 + 4) = 14.", "holds"),
    # extremes
    (r"$F_{S(\max)} = 3 m$, $F_{S,\max}/m = 3$", "holds"),
    (r"$F_{S(\max)} = 3 m$, $F_{S,\max}/m = 4$", "refuted"),
    ("P_I,max = 1775 N und P_II,max = P_I,max/4 = 443.75 N.", "holds"),
    ("P_I,max = 1775 N und P_II,max = P_I,max/4 = 887.5 N.", "refuted"),
    ("M = m r a cos θ.\n\n$|M|_\\mathrm{max} = m r a$", "holds"),
    ("M = m r a cos θ.\n\n$|M|_{max} = 2 m r a$", "refuted"),
    ("M = m r a cos θ.\n\n|M|max = −m r a.", "refuted"),
    ("M = m r cos θ.\n\n$|M|_{max} = m r c/c$", "holds"),
    # starred letters, and letters that are words elsewhere
    ("J* = J + m r² and T = ½ J* w², so 2T/w² = J + m r².", "holds"),
    ("J* = J + m r² and T = ½ J* w², so 2T/w² = J − m r².", "refuted"),
    ("F = m r b. The quotient is F/m = r b; F/r = m b.", "holds"),
    ("F = m r b. The quotient is F/m = r b; F/r = 2 m b.", "refuted"),
    # components
    ("F2x = √2 P cos 2θ, F2y = 0 and F2x² + F2y² = 2 P² cos² 2θ.", "conditional"),
    ("F2x = √2 P cos 2θ, F2y = 0 and F2x² + F2y² = 4 P² cos² 2θ.", "refuted"),
    # a number put in for a multiple of a letter that has none
    (r"v = 25 m/s. $$c = \dfrac{v}{D/2} = \dfrac{25}{0.9}$$", "premise"),
    (r"v = 25 m/s, D = 1.8 m. $$c = \dfrac{v}{D/2} = \dfrac{25}{0.9}$$", "holds"),
    (r"v = 25 m/s, D = 1.8 m. $$c = \dfrac{v}{D/2} = \dfrac{25}{0.8}$$", "refuted"),
    (r"v = 25 m/s. $$c = \dfrac{v}{D/2} = \dfrac{35}{0.9}$$", "undecided"),
    # two hyphens before words
    ("We have 3 · 2 = 6 -- right?", "holds"),
    ("We have 3 · 2 = 7 -- right?", "refuted"),
    # mixed numbers
    ("2 × 4½ = 9.", "holds"),
    ("2 × 4½ = 8.", "refuted"),
    ("4 ½ + ½ = 5.", "holds"),
    ("r = 2½ in. = 63.5 mm.", "holds"),
    ("r = 2½ in. = 65.3 mm.", "refuted"),
    ("l = 7 1/2 in. = 190.5 mm.", "holds"),
]


@pytest.mark.parametrize("judge", [check, check_with_engines])
@pytest.mark.parametrize(("page", "word"), CASES)
def test_what_is_typed_is_read_as_it_is_meant(page, word, judge):
    assert judge(f"{page}\n", LETTERS, fixes=False).verdicts[-1].verdict == word
