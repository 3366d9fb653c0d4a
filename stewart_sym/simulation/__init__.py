"""Simulation of motions under actuator models, from a scene file or from Python."""
