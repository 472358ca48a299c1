"""Base class of the document writers: a method for each kind of block and inline element."""

from __future__ import annotations

from abc import ABC, abstractmethod

from symbalance.document import nodes
from symbalance.document.formula import Equation, Formula
from symbalance.document.nodes import Inline, inlines


class DocumentWriter(ABC):
    """Writes blocks; a method is named after the kind of block that it writes."""

    def block(self, block: nodes.Block) -> str:
        """Return a block in print."""
        return getattr(self, type(block).__name__.lower())(block)

    def words(self, words: nodes.Words) -> str:
        """Return words in print."""
        return "".join(map(self.inline, inlines(words)))

    def inline(self, inline: Inline) -> str:
        """Return an inline in print."""
        if isinstance(inline, str):
            return self.string(inline)
        if isinstance(inline, nodes.Code):
            return self.code(inline.text)
        if isinstance(inline, nodes.Jump):
            return self.jump(inline)
        return self.strong(inline.text) if isinstance(inline, nodes.Strong) else self.math(inline)

    def jump(self, jump: nodes.Jump) -> str:
        """Return words that lead elsewhere in the document; by themselves where nothing leads."""
        return self.string(jump.text)

    def marked(self, block: nodes.Marked) -> str:
        """Return a marked line with all that is said of it; where nothing folds, in a row."""
        head = nodes.Paragraph(
            (f"{block.place} ", nodes.Strong(block.verdict), ": ", *inlines(block.words))
        )
        return "\n\n".join(self.block(each) for each in (head, *block.blocks))

    @abstractmethod
    def string(self, text: str) -> str:
        """Return plain words in print."""

    @abstractmethod
    def code(self, text: str) -> str:
        """Return text taken literally."""

    @abstractmethod
    def strong(self, text: str) -> str:
        """Return words that must not be missed."""

    @abstractmethod
    def math(self, value: Formula | Equation) -> str:
        """Return a formula within a sentence."""

    @abstractmethod
    def heading(self, block: nodes.Heading) -> str:
        """Return a title."""

    @abstractmethod
    def paragraph(self, block: nodes.Paragraph) -> str:
        """Return a paragraph."""

    @abstractmethod
    def facts(self, block: nodes.Facts) -> str:
        """Return names and what is said of them."""

    @abstractmethod
    def table(self, block: nodes.Table) -> str:
        """Return a table."""

    @abstractmethod
    def formulas(self, block: nodes.Formulas) -> str:
        """Return displayed equations."""

    @abstractmethod
    def figure(self, block: nodes.Figure) -> str:
        """Return a picture."""

    @abstractmethod
    def source(self, block: nodes.Source) -> str:
        """Return lines somebody wrote, with their verdicts."""

    @abstractmethod
    def details(self, block: nodes.Details) -> str:
        """Return what may be skipped."""
