"""Decisions whether a relation is true: exactly, through an order, or to the digits printed."""
