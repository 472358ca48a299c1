"""An engine: its cylinders, firing order, crank, what balances it, and its file.

In: an engine file, a preset's name, or a builder's arguments. Out: an `Engine`, resolved once: cylinders
that know all about themselves, in groups of like ones, and what balances them.

    trains, cylinders, engine     sizes; one cylinder; all of them together
    builders, firing, stars       engines from firing orders, banks and pins; the orders a crank allows
    balancers, rotors             counterweights and balance shafts; rotating masses
    tops                          when pistons are at the top
    engine_keys                   what an engine file may hold: each key's kind, unit, range, meaning
    engine_file, engine_writing   engines from and to TOML;  balancer_tables: its weights and shafts
    catalogue                     the presets
    engine_document, facts, kinds, balancer_facts  what every document says of an engine
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
