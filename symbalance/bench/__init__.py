"""Every measurement behind one command: `symbalance bench TOPIC`."""
