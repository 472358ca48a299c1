from symbalance.notes.checking import check_equal as check_equal
from symbalance.notes.checking import report_json as report_json
from symbalance.notes.checking import report_latex as report_latex
from symbalance.notes.checking import report_text as report_text
