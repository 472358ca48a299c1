from symbalance.search.cranks_search import search_cranks as search_cranks
from symbalance.search.problem import SearchProblem as SearchProblem
from symbalance.search.problem import search_problem as search_problem
from symbalance.search.search_result import CrankSearch as CrankSearch
from symbalance.search.search_result import SearchPoint as SearchPoint
from symbalance.search.search_result import SearchStar as SearchStar
