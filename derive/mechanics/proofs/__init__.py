"""Proofs that two derivations of the same force are equal, by normal form."""
