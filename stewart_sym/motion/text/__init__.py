"""The text of logs: what stands above their numbers."""
