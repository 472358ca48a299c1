"""Hand derivations, checked line by line: verdicts, claims, diagnosis and reports."""

from symbalance.checking.declaring import sidecar_draft as sidecar_draft
from symbalance.checking.documents import check as check
from symbalance.checking.expressions import check_equal as check_equal
from symbalance.checking.reports.latex import report_latex as report_latex
from symbalance.checking.reports.markdown import corrections_markdown as corrections_markdown
from symbalance.checking.reports.markdown import report_markdown as report_markdown
from symbalance.checking.reports.plain_data import report_json as report_json
from symbalance.checking.reports.text import report_text as report_text
from symbalance.checking.verdicts import Checked as Checked
from symbalance.checking.verdicts import Verdict as Verdict
