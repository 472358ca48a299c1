r"""A node's equations as LaTeX: `sb.to_latex(node_equations())`; amsmath and booktabs only.

>>> from symbalance.crankshaft.equations.node import node_equations
>>> print(entry_latex(node_equations().mass[5, 5]))
I_{ww} + m \left(e_u^{2} + e_v^{2}\right)
"""

from __future__ import annotations

from typing import Any

import sympy

from symbalance.crankshaft.equations.bearings import turned_bearing
from symbalance.crankshaft.equations.node import NodeEquations
from symbalance.crankshaft.equations.published import HOLDS, Entry, compared
from symbalance.crankshaft.equations.quantities import LATEX, THETA, M
from symbalance.document.latex_parts import in_document

_NAMES = {"mass": "M", "gyroscopic": "G", "centrifugal": r"\Delta K", "centrifugal_force": "F_M"}

_STATEMENT = r"""\section*{A node of the turning crankshaft}
A rigid body of mass $m$ sits at the node $(U, V, W)$ of axes that turn about $W$ at $\omega$;
$\alpha = \dot\omega$. Its mass centre is $(e_u, e_v, e_w)$ from the node, $I$ its inertia tensor about
that centre, $I_{uv} = -\int uv\,\mathrm{d}m$. The coordinates
$q = (u, v, w, \theta_u, \theta_v, \theta_w)$ are a shift and TURN.
Through the second order in $q$ and $\dot q$ the kinetic energy is
\[ T = \tfrac12 \dot q^t M \dot q + \omega\,(\dot q^t B q + c^t \dot q)
  + \omega^2 (F_M^t q - \tfrac12 q^t \Delta K q) + \dots, \]
and the equations of motion, with $G = B - B^t$ skew and $\Delta K$ symmetric whatever the body, are
\[ M \ddot q + \omega G \dot q + (\omega^2 \Delta K + \alpha B)\, q
  = F + \omega^2 F_M - \alpha c + g F_g. \]"""

_PAPER = r"""\subsection*{Beside the published equation (1)}
Where the mass centre is the node and the principal axes are $U$, $V$, $W$, HELD of its ALL entries hold.
For any other body these do not (rows and columns from 1; of a symmetric or skew pair the upper one):
\begin{center}\small\begin{tabular}{@{}llll@{}}
\toprule
entry & published & derived & verdict \\
\midrule
ROWS
\bottomrule
\end{tabular}\end{center}"""

_BEARING = r"""\subsection*{A bearing in turning axes}
A bearing with stiffness $K$ and damping $C$ in stationary axes has, with $Q = R(\theta)$, $S = R(\pi/2)$,
\[ K_\mathrm{rot} = Q^t K Q + \omega\, Q^t C Q\, S, \qquad C_\mathrm{rot} = Q^t C Q. \]
The last term is circulatory. At $\theta = 0$ it is the first of these; the second is the whole of
$K_\mathrm{rot}$ for a bearing that is the same in all directions:
\[ FIRST, \qquad SECOND. \]"""


def entry_latex(value: Any) -> str:
    """Return an entry as LaTeX, what the mass multiplies collected."""
    flat = sympy.expand(value)
    by_mass = flat.coeff(M, 1)
    if by_mass.is_Add:
        flat = sympy.expand(flat - M * by_mass) + M * sympy.factor_terms(by_mass)
    return sympy.latex(flat, symbol_names=LATEX)


def matrix_latex(matrix: Any) -> str:
    """Return a matrix in brackets."""
    rows = ([entry_latex(cell) for cell in matrix.row(i)] for i in range(matrix.rows))
    lines = [" & ".join(row) for row in rows]
    body = (" \\\\[3pt]\n" if any("frac" in line for line in lines) else " \\\\\n").join(lines)
    return f"\\begin{{bmatrix}}\n{body}\n\\end{{bmatrix}}"


def equations_latex(equations: NodeEquations, *, standalone: bool = False) -> str:
    """Return a node's equations as LaTeX, beside the published ones."""
    sections = (_statement, _matrices, _forces, _paper, _bearing)
    body = "\n".join(section(equations) for section in sections) + "\n"
    return in_document(body) if standalone else body


def _statement(equations: NodeEquations) -> str:
    kind = equations.rotation
    turn = "a rotation vector"
    if kind != "vector":
        turn = "Cardan angles, $A = {}$".format(" ".join(f"R_{axis}" for axis in kind))
    return _STATEMENT.replace("TURN", turn)


def _matrices(equations: NodeEquations) -> str:
    named = (
        ("M", equations.mass),
        ("G", equations.gyroscopic),
        (r"\Delta K", equations.centrifugal),
        (r"B - \tfrac12 G", (equations.euler + equations.euler.T) / 2),
    )
    title = "\\subsection*{Matrices}\nIn blocks of three rows and columns, shifts first:"
    return "\n".join([title, *(_in_blocks(name, matrix) for name, matrix in named)])


def _in_blocks(name: str, matrix: Any) -> str:
    """Return a matrix as its blocks: shift, coupling X, turn Y; the fourth follows by symmetry."""
    shift, coupling, turn = matrix[:3, :3], matrix[:3, 3:], matrix[3:, 3:]
    sign = "" if matrix == matrix.T else "-"
    whole = rf"{name} = \begin{{bmatrix}} {matrix_latex(shift)} & X \\ {sign}X^t & Y \end{{bmatrix}}"
    if shift.is_zero_matrix and coupling.is_zero_matrix:
        whole = rf"{name} = \begin{{bmatrix}} 0 & 0 \\ 0 & Y \end{{bmatrix}}"
    elif not coupling.is_zero_matrix:
        whole += rf",\quad X = {matrix_latex(coupling)}"
    else:
        whole = whole.replace(f"{sign}X^t", "0").replace("X", "0")
    return f"\\[ {whole} \\]\n\\[ Y = {matrix_latex(turn)} \\]"


def _forces(equations: NodeEquations) -> str:
    pairs = (("F_M", equations.centrifugal_force), ("c", equations.euler_force))
    shown = ",\\quad ".join(f"{name} = {matrix_latex(vector)}" for name, vector in pairs)
    gravity = f"F_g^t = {matrix_latex(equations.gravity_force.T)}"
    return f"\\subsection*{{Forces}}\n\\[ {shown} \\]\n\\[ {gravity} \\]"


def _paper(equations: NodeEquations) -> str:
    plain = [entry.verdict for entry in compared(equations.principal())]
    rows = [_row(entry) for entry in compared(equations) if entry.verdict != HOLDS and _is_upper(entry)]
    text = _PAPER.replace("HELD", str(plain.count(HOLDS))).replace("ALL", str(len(plain)))
    return text.replace("ROWS", "\n".join(rows))


def _is_upper(entry: Entry) -> bool:
    return entry.matrix == "centrifugal_force" or entry.row <= entry.column


def _row(entry: Entry) -> str:
    places = (entry.row, entry.column)[: 1 if entry.matrix == "centrifugal_force" else 2]
    index = "".join(str(place + 1) for place in places)
    published, derived = entry_latex(entry.published), entry_latex(entry.derived)
    return rf"${_NAMES[entry.matrix]}{{}}_{{{index}}}$ & ${published}$ & ${derived}$ & {entry.verdict} \\"


def _bearing(_: NodeEquations) -> str:
    turned = turned_bearing()
    first = matrix_latex(turned.circulatory.subs(THETA, 0))
    second = matrix_latex(turned.isotropic().stiffness)
    return _BEARING.replace("FIRST", first).replace("SECOND", second)
