"""Path parameterization: limited quantities along a path, and the phase plane of the path parameter."""
