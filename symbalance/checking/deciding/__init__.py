"""Is one relation true? Decided by what is known at its line: exactly, through an order, or by rounding."""
