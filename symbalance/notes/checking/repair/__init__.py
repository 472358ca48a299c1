"""The smallest change that makes a refuted line true: looked for, proved, and pointed at."""
