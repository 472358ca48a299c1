"""What a run leaves in its folder: tables as text, LaTeX and JSON, curves as CSV, pictures.

summary     the numbers every report prints
text, page  the report as text; as a LaTeX page that compiles alone
curves      every channel against the crank angle as CSV, the summary as JSON
pictures    plots against crank angle, order and speed
"""

from symbalance.crankshaft.reports.curves import curves_csv, loads_csv, summary_json
from symbalance.crankshaft.reports.page import summary_page
from symbalance.crankshaft.reports.summary import Summary, summary
from symbalance.crankshaft.reports.text import summary_text

__all__ = [
    "Summary",
    "curves_csv",
    "loads_csv",
    "summary",
    "summary_json",
    "summary_page",
    "summary_text",
]
