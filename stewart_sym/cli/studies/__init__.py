"""Subcommands for studies, with tables, plots, and data."""
