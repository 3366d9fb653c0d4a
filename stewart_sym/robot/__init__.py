"""Robot model, robot files, and unit scaling."""
