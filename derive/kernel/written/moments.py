"""Moments about platform point 1, and the scaling of all moments, as written functions.

The legs of a pose, or the poses of a block, are side by side.
"""


def shift_of_pose(
    q: "alone(array(3, LANES))",
    c_force: "alone(array(3))",
    c_moment: "alone(array(3))",
    c_tip: "alone(array(3))",
) -> None:
    """Moves the platform's part of c to moments about platform point 1."""
    SHIFT


def moments_of_pose(
    q: "alone(array(3, LANES))",
    A: "alone(array(6, LANES))",
    c_force: "alone(array(3, LANES))",
    arm_c: "alone(array(3, LANES))",
) -> None:
    """Computes the moments of the legs of a pose about platform point 1, $count operations each. Leg 1 has
    none."""
    FIRST
    for l in range(LANES):
        MOMENTS


def moments_of_first(
    q: "alone(array(3, POSES))",
    c_force: "alone(array(3, POSES))",
    c_moment: "alone(array(3, POSES))",
    c: "alone(array(6, POSES))",
) -> None:
    """Moves the platform's part of c of a block of poses to platform point 1, and adds the part of leg 1."""
    for l in range(POSES):
        FIRST


def moments_of_block(
    q: "alone(array(3, POSES))",
    q_1: "alone(array(3, POSES))",
    c_force: "alone(array(3, POSES))",
    c_moment: "alone(array(3, POSES))",
    column: "alone(array(6, POSES))",
    c: "alone(array(6, POSES))",
) -> None:
    """Computes the moments of legs 2 to 6 about platform point 1, $count operations each, and adds their
    parts of c."""
    for l in range(POSES):
        MOMENTS


def scale_pose(A: "array(6, LANES)", wrench: "array(6)", per_length: "Real") -> None:
    """Multiplies the moment rows of [H | c] of a pose by `per_length`."""
    for i in range(3, 6):
        wrench[i] = wrench[i] * per_length
        for j in range(LANES):
            A[i][j] = A[i][j] * per_length


def scale_block(column: "array(7, 6, POSES)", per_length: "Real") -> None:
    """Multiplies the moment rows of [H | c] of a block of poses by `per_length`."""
    for i in range(1 if ABOUT_TIP else 0, 7):
        for j in range(3, 6):
            for l in range(POSES):
                column[i][j][l] = column[i][j][l] * per_length


def rows_status(
    A: "array(6, LANES)", q: "array(3, LANES)", L: "array(LANES)", reach: "array(LANES)", per_length: "Real"
) -> "Integer":
    """Returns the status of a pose whose H may be singular to rounding."""
    H = blank(array(6, 6))
    arm = blank(array(6, 3))
    tip = 0.0
    if ABOUT_TIP:
        for j in range(3):
            tip = larger(size(q[j][0]), tip)
    for i in range(6):
        for j in range(3):
            arm[i][j] = q[j][i] - q[j][0] if ABOUT_TIP else q[j][i]
            H[j][i] = A[j][i]
            H[j + 3][i] = A[j + 3][i] / per_length
    return singular_status(H, arm, L, reach, tip)
