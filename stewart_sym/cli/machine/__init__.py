"""Subcommands for a machine and its motions: description, forces, workspace, planning, and simulation."""
