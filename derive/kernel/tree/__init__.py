"""Trees of functions in no language: nodes, reader, transformations, interpreter, and operation counter."""
