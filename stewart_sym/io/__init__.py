"""Reading, validation, and writing of files and arguments, with their error messages."""
