"""Single-line faults planted by program into the library, and the share of them that the tests catch.

`python -m tests.faults.planting ROOM --seed 1 --count 10` plants; each module here is one step of it:

- `single_faults`: every fault that one line of a module can have, from its syntax tree
- `recorded_results`: the results that tell a fault that matters from one that changes nothing
- `nearest_tests`: which test files belong to which room
- `worker`: a process that has the other libraries loaded and forks for each job
- `trees`: copies of the checkout, in which alone faults are planted
- `planting`: chooses faults, plants them, runs what is near and reports
"""
