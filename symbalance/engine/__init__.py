"""Engines: cylinders, firing order, crank, counterweights and balance shafts, and engine files.

In: an engine file, a preset's name, or a builder's arguments. Out: an `Engine`, resolved once: cylinders
that know all about themselves, in groups of like ones, and what balances them.

    crank_train, cylinders, engine    sizes; one cylinder; all of them together
    variants                          the same engine with other sizes, bank angle or rod ratio
    builders                          engines from a firing order and bank angles, or from crank pins
    station_lists                     stations and pins as a drawing lists them
    stars                             cranks, firing orders and bank angles that fire evenly
    balance_masses                    counterweights and balance shafts
    rotating_masses                   all that turns and is not balanced by itself
    dead_centres                      the crank angles at which pistons stand at the top
    engine_keys                       what an engine file may hold: kind, unit, range, meaning of each key
    engine_file, engine_writing       engines from and to TOML
    catalogue                         the presets
    engine_document, balance_mass_facts   what every document says of an engine
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
