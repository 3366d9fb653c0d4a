"""Command ``stewart-sym``: one module for each subcommand in three folders, and common modules."""
