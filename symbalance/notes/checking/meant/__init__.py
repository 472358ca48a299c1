"""What letters mean though nobody declared them: a ≈ r ω² (cos θ + λ cos 2θ), "the bending stress is σ".

In: a page's words and formulas. Out: the known quantity that a line gives, with the formula it must be,
and how an angle runs with the time. A guess is used only where it makes a right line right or shows a
known slip.
"""
