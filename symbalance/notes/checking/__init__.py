"""The checker of hand derivations: a verdict, a witness and a correction for every relation.

In: a document, a sidecar that says what its letters mean, and somebody who knows engines. Out: `Checked`.

    sidecar, symbol_roles, symbols  what is declared: letters, their roles and what they stand for
    engines, geometry, quantities   what lines may be bound to: engines' forces, a slider-crank's motion
    verdicts, descriptions          what is said of a relation
    constraints, definitions        relations that state something, and letters defined on the way
    letter_values, another_value    may a letter have this value, the first or a second one
    impossible_values, premises     why it may not: by what it means, by the equations taken as given
    deciding, assertions            is a relation true, is a line what it is bound to
    judging, judging_state          the page's relations in order, and what is known where each stands
    one_relation                    the verdict on one: definition, step, equation to solve, given
    appeals, open_reasons           what is tried before a refutation stands, why it may stay open
    dead_centres                    values at the dead centres that words or an index name
    leftover_premises               numbers of sizes that are written in others: l of n r
    numbers_in_units, conversions   units that numbers are meant in; one quantity in two units
    printed_units                   units that numbers put in have in the words before
    formulas_between_numbers        formulas whose constant converts units; rpm as rad/s in
    speeds_as_numbers, bare_degrees angular speeds, angles typed without their sign
    repair                          the smallest change that makes a refuted line true
    role_phrases, proposals         what a page's words propose, for a person to confirm
    declaration_draft               the symbols file drafted from it
    documents, sympy_expressions    `check` of a document, `check_equal` of two SymPy expressions
    report_document, report_data    the report for readers and for programs
    page_prose                      what stands between relations, in whatever markup, as blocks
    marked_page, sides_plot         the author's page for a browser, both sides of what is wrong drawn
    document_table                  several documents, a line for each
"""

from symbalance.notes.checking.documents import check as check
from symbalance.notes.checking.documents import sidecar_draft as sidecar_draft
from symbalance.notes.checking.sympy_expressions import check_equal as check_equal
from symbalance.notes.checking.verdicts import Checked as Checked
from symbalance.notes.checking.verdicts import Verdict as Verdict
