"""Hand derivations and single lines whose truth was worked out beforehand."""
