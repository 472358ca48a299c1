from symbalance.search.problem import SearchProblem as SearchProblem
from symbalance.search.problem import search_problem as search_problem
