from symbalance.document.result import Result as Result
from symbalance.document.result import to_html as to_html
from symbalance.document.result import to_json as to_json
from symbalance.document.result import to_latex as to_latex
from symbalance.document.result import to_markdown as to_markdown
from symbalance.document.result import to_text as to_text
from symbalance.document.symbols import symbol as symbol
