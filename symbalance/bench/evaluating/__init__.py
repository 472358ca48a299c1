"""The parts of `symbalance bench accuracy`: what is evaluated, how fast, how truly."""
