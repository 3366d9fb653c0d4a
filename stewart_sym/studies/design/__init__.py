"""Reports and plots of workspaces and actuator requirements."""
