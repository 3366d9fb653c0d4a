"""The command ``stewart-sym``: a module for each subcommand, in three folders, and what they share."""
