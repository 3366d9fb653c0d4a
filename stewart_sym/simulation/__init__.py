"""Motion in time under actuator models, from a scene file or from Python."""
