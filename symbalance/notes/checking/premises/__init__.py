"""What a page takes as given: letters it defines, equations it assumes, and what follows from them.

In: relations that are no steps. Out: values of letters with their scope, the premises solved for the
letters of a relation, and whether one more equation follows from them, contradicts them, or neither.
"""
