"""How fast a path may be traveled: what it takes of a machine, and the phase plane of its parameter."""
