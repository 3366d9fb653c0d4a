"""The text of logs: lines above their numbers, dates."""
