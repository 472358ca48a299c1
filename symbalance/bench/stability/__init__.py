"""`symbalance bench stability`: the worst cases in ulp, the naive form beside ours."""

from symbalance.bench.stability.reporting import StabilityReport, report

__all__ = ["StabilityReport", "report"]
