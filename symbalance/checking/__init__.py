"""Hand derivations, checked line by line: verdicts, claims, diagnosis and reports."""

from symbalance.checking.declaring import sidecar_draft as sidecar_draft
from symbalance.checking.documents import check as check
from symbalance.checking.expressions import check_equal as check_equal
from symbalance.checking.report_json import report_json as report_json
from symbalance.checking.report_latex import report_latex as report_latex
from symbalance.checking.report_markdown import corrections_markdown as corrections_markdown
from symbalance.checking.report_markdown import report_markdown as report_markdown
from symbalance.checking.report_text import report_text as report_text
from symbalance.checking.verdicts import Checked as Checked
from symbalance.checking.verdicts import Verdict as Verdict
