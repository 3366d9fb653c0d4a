"""What the studies share: tables, pictures, timing and loops in C."""
