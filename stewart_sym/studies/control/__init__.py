"""Controllers that differ in nothing but their model of the machine."""
