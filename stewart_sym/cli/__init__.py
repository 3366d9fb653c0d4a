"""The command ``stewart-sym``."""
