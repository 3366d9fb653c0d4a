"""Common modules of the studies: tables, plots, timing, and loops in C."""
