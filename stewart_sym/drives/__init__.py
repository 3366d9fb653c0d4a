"""Relations between leg forces and motors: friction, efficiency, torque, current, and power."""
