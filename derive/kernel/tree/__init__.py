"""Trees of functions in no language: nodes, reading, lowering, running, counting."""
