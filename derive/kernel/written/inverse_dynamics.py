"""Terms of the actuator forces around their blocks, in the part of Python that ``read`` reads."""


def terms(robot: "Robot", motion: "Motion") -> "Terms":
    """D, K, H and c of (21), (24), (36): H x = c and F = D - x; moments about the reference point."""
    out = Terms()
    pose = platform_wrench(robot, motion)
    for i in range(3):
        out.c[i] = pose.c_force[i]
        out.c[i + 3] = pose.c_moment[i]
    for i in range(6):
        leg = leg_dynamics(robot.leg[i], robot, motion)
        out.D[i] = leg.D
        for j in range(3):
            out.K[i][j] = leg.K[j]
            add_leg(i, j, out, leg)
    return out
