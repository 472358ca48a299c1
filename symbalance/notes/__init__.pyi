from symbalance.notes.checking import check_equal as check_equal
