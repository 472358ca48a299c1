"""Evidence about the evidence: planted faults, which tests, benches and the record must report."""
