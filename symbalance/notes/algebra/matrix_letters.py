"""Letters that stand for matrices and vectors, by the words of their declared meaning."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from symbalance.text import lazy_patterns as re

_MATRIX = re.compile(r"\bmatri(?:x|ces)\b|行列", re.IGNORECASE)
_VECTOR = re.compile(r"\bve[ck]tor\b|ベクトル", re.IGNORECASE)
_SYMMETRIC = re.compile(r"\bsymmetric\b|\bsymmetrische\b|対称", re.IGNORECASE)
_PLAINLY = re.compile(r"\s*(?:(?:column|row)\s+)?vector\s*(?:,.*)?", re.IGNORECASE)
_IDENTITY = re.compile(r"\b(?:identity|unit) matrix\b|\bEinheitsmatrix\b|単位行列", re.IGNORECASE)


@dataclass(frozen=True)
class Kinds:
    """Which letters are matrices and vectors, which of the matrices are symmetric or the identity."""

    matrices: frozenset[str] = frozenset()
    vectors: frozenset[str] = frozenset()
    symmetric: frozenset[str] = frozenset()
    identities: frozenset[str] = frozenset()

    @property
    def letters(self) -> frozenset[str]:
        """All of them."""
        return self.matrices | self.vectors


def kinds_of(symbols: Mapping[str, str]) -> Kinds:
    """Return which of the declared letters are matrices and vectors.

    >>> kinds_of({"K": "stiffness matrix, symmetric", "u": "displacement vector"}).symmetric
    frozenset({'K'})
    """
    identities = {name for name, text in symbols.items() if _IDENTITY.search(text)}
    matrices = {name for name, text in symbols.items() if _MATRIX.search(text)} - identities
    is_vector = _VECTOR.search if matrices else _PLAINLY.fullmatch  # a phasor is called a vector too
    vectors = {name for name, text in symbols.items() if is_vector(text)} - matrices - identities
    symmetric = {name for name in matrices if _SYMMETRIC.search(symbols[name])}
    return Kinds(frozenset(matrices), frozenset(vectors), frozenset(symmetric), frozenset(identities))
