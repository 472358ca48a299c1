"""What a run leaves in its folder: tables in every medium, curves as CSV, pictures.

summary           the figures that every report prints, a result
summary_document  what is written of them
summary_data      the same for other programs
curves            every channel against the crank angle as CSV
pictures          plots against crank angle, order and speed
"""

from symbalance.crankshaft.reports.curves import curves_csv, loads_csv
from symbalance.crankshaft.reports.summary import Summary, summarise_run

__all__ = ["Summary", "curves_csv", "loads_csv", "summarise_run"]
