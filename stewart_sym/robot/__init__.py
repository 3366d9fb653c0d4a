"""The machine: its robot file, published machines, and units in which its numbers are near one."""
