"""Corrections of refuted lines: the smallest change that makes a line true, proved and pointed at."""
