"""mpmath as the bench's independent judge, in a context of the bench's own.

Nobody else's settings count here, and none of anybody else's are changed.
"""

from typing import Any

from mpmath.ctx_mp import MPContext

Number = Any
"""A number of the judge."""
mp: Any = MPContext()
