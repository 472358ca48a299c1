"""Hand derivations, checked line by line: verdicts, claims, diagnosis and reports."""

from symbalance.notes.checking.declaring import sidecar_draft as sidecar_draft
from symbalance.notes.checking.documents import check as check
from symbalance.notes.checking.expressions import check_equal as check_equal
from symbalance.notes.checking.reports.latex import report_latex as report_latex
from symbalance.notes.checking.reports.markdown import corrections_markdown as corrections_markdown
from symbalance.notes.checking.reports.markdown import report_markdown as report_markdown
from symbalance.notes.checking.reports.plain_data import report_json as report_json
from symbalance.notes.checking.reports.text import report_text as report_text
from symbalance.notes.checking.verdicts import Checked as Checked
from symbalance.notes.checking.verdicts import Verdict as Verdict
