"""Benchmarks: speed and error of what the package computes, measured beside the alternatives.

In: a topic, `symbalance bench TOPIC`. Out: a report with `text()` and `missed_targets()`.

    derive       exact derivations: derive_alternatives (SymPy, FLINT), ideal_engine
    check        hand derivations: check_page, sympy_decisions; planted_faults of several fault_kinds
    accuracy     functions, error against time: evaluated_outputs, accuracy_alternatives; speed,
                 error_sweep, crossover (closed form or polynomial)
    stability    functions at the worst inputs: hard_angles, output_requests, bounded_cases; piston_cases,
                 engine_cases, ratio_cases, closed_sum_cases
    crankshaft   integrators of the inline_four: integrator_runs
    timing, true_values   the clock and the judge of them all
"""
