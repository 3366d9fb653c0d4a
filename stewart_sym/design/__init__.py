"""Workspace and capability of a robot, and actuator requirements of motions."""
