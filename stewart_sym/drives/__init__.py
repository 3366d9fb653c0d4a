"""Between the force of a leg and its motor: friction, efficiency, torque, current and power."""
