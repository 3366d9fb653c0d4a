"""Files and arguments: what is read, checked and written, and what an error says."""
