"""Reports of a run: a document in every format, JSON data, CSV curves, pictures.

summary           the figures that every report prints, a result, and its data for programs
summary_document  its document
curves            every channel against the crank angle as CSV
pictures          plots against crank angle, order and speed
"""

from symbalance.crankshaft.reports.curves import curves_csv, loads_csv
from symbalance.crankshaft.reports.summary import Summary, summarise_run

__all__ = ["Summary", "curves_csv", "loads_csv", "summarise_run"]
