"""Exchange of robots with other programs: export to MJCF, SDF, URDF, and USD; import of the first three."""
