"""What planning gains: condition numbers, forces, and whether the one tells of the other."""
