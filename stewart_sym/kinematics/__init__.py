"""Inverse and forward kinematics, equations (1)-(9), and the condition number of H."""
