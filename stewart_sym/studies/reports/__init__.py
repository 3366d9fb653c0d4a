"""What the subcommands write about a machine, a log, a run or a path."""
