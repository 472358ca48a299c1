"""The checker of hand derivations: a verdict, a witness and a correction for every relation.

In: a document, a sidecar that says what its letters mean, and somebody who knows engines. Out: `Checked`.
A relation climbs these rooms from the ground up:

    words      cases, sections, numbers as typed: what stands between the relations
    declared   roles of letters, the symbols file, proposals, engines as the caller knows them
    deciding   is a relation true: exactly, through an order, or to the digits printed
    premises   letters defined on the way, equations taken as given, what follows from them
    repair     the smallest change that makes a refuted line true
    units      units and dimensions, at letters, at numbers and in words
    motions    series, means, largest values and equations of motion
    meant      quantities that nobody declared, known by their words and formulas
    page       data, quotations, conclusions, and lines bound to a known quantity
    steps      kinds of relations that are no plain step, and what is known where one stands
    judging    the page's relations in order
    reports    for readers, for programs, as the author's page, as certificates

    documents, sympy_expressions    `check` of a document, `check_equal` of two SymPy expressions
    verdicts                        what is said of a relation, and of a page
"""

from symbalance.notes.checking.documents import check as check
from symbalance.notes.checking.documents import sidecar_draft as sidecar_draft
from symbalance.notes.checking.sympy_expressions import check_equal as check_equal
from symbalance.notes.checking.verdicts import Checked as Checked
from symbalance.notes.checking.verdicts import Verdict as Verdict
