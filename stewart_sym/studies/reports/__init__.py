"""Reports of the subcommands about a machine, a log, a run, or a path."""
