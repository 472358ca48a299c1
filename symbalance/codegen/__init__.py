"""Code generation: results as fast functions of the crank angle, in memory or as source code.

In: a balance or a torque. Out: a function in memory, or source that runs alone.

    requests, torque_requests   from a result to harmonic sums: outputs, surviving orders, proved bounds
    plans                       from sums to a plan: which cosines, which polynomial, or the closed form
    evaluation_scheme           Horner, Clenshaw or Reinsch, by what each rounds (polynomials, rounding)
    cosines, float32_cosines    reduction of the crank angle and its cosine;  argument_reduction: to 2^50
    expression_ir               the lines and constants of which a plan is made
    targets                     from a plan to text;  evaluators: from text to a function
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
