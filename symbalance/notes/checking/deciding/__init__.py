"""Is a relation true, by what is known at its line? Exactly, through an order, or to the digits."""
