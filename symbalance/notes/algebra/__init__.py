"""Exact decisions: is a hand-written equation an identity of the harmonics' domain?"""
