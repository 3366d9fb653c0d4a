"""Robot model and robot files."""
