"""The machine in other programs' formats: MJCF, SDF, URDF and USD out, the first three in."""
