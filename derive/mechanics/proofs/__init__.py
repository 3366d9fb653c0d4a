"""Proofs by normal form that independent derivations of the same force are equal."""
