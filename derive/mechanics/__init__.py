"""The mechanics of the paper: equations in, blocks of named steps out."""
