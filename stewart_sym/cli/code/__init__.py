"""Subcommands for generated code: the derivation, kits, and the CMake package."""
