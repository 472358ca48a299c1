from symbalance.document.printing import to_json as to_json
from symbalance.document.printing import to_latex as to_latex
from symbalance.document.printing import to_text as to_text
from symbalance.document.symbols import symbol as symbol
