"""Actuator forces, joint reactions, and equations of motion of one robot."""
