"""Against published values: books, papers, data sheets of engines and rotors."""
