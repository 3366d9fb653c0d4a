"""The machine: its robot file, and units in which its numbers are near one."""
