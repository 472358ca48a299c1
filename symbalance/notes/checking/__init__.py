"""Hand derivations, checked line by line: verdicts, claims, diagnosis and reports."""

from symbalance.notes.checking.documents import check as check
from symbalance.notes.checking.documents import sidecar_draft as sidecar_draft
from symbalance.notes.checking.sympy_expressions import check_equal as check_equal
from symbalance.notes.checking.verdicts import Checked as Checked
from symbalance.notes.checking.verdicts import Verdict as Verdict
