"""Inverse dynamics with all terms, joint reactions, and the regressor, on arrays, as written functions.

Poses are side by side: a number has one value per pose. Legs are consecutive, or side by side too. In the
second case, numbers of ``robot.leg`` and of ``Legs`` have one value per leg, on an axis before the poses.
"""


def legs_in_turn(robot: "Robot", motion: "Motion") -> "Legs":
    """The legs one after the other."""
    out = Legs()
    for i in range(6):
        out.leg[i] = leg_dynamics(robot.leg[i], robot, motion)
    return out


def leg_of_array(legs: "Legs", i: "Integer") -> "LegDynamics":
    """One of the legs."""
    return legs.leg[i]


def legs_side_by_side(robot: "Robot", motion: "Motion") -> "Legs":
    """The legs side by side."""
    return leg_dynamics(robot.leg, robot, motion)


def leg_of_lanes(legs: "Legs", i: "Integer") -> "Legs":
    """One of the legs."""
    out = Legs()
    for number in entries(SUMMED):
        out[number] = legs[number, i]
    return out


def terms(robot: "Robot", motion: "Motion") -> "Terms":
    """D, K, H and c of (21), (24), (36): H x = c and F = D - x; moments about the reference point."""
    legs = legs_of(robot, motion)
    return terms_of(legs, robot, motion)


def terms_of(legs: "Legs", robot: "Robot", motion: "Motion") -> "Terms":
    """The same, where the legs are known."""
    out = Terms()
    pose = platform_wrench(robot, motion)
    for i in range(3):
        out.c[i] = pose.c_force[i]
        out.c[i + 3] = pose.c_moment[i]
    for i in range(6):
        leg = leg_of(legs, i)
        out.D[i] = leg.D
        for j in range(3):
            out.K[i][j] = leg.K[j]
            add_leg(i, j)
    return out


def solved(robot: "Robot", motion: "Motion") -> "Forces":
    """The same as `inverse_dynamics`, but `suspect` is 1 where H may be singular to rounding."""
    out = Forces()
    H = array(6)
    c = array(6)
    legs = legs_of(robot, motion)
    known = terms_of(legs, robot, motion)
    reach = reach_of(robot.leg.b, motion.t, legs.q)
    status = first_of(fault_of(legs.L, legs.k3, reach))
    close = first_of(where(legs.L > SHORT_SHARE * reach, 0, 1))
    per_length = scale_of(legs.q)
    for i in range(3):
        H[i] = legs.H_force[i]
        H[i + 3] = legs.H_moment[i] * per_length
        c[i] = known.c[i]
        c[i + 3] = known.c[i + 3] * per_length
    small_pivot = eliminate(H, c, out.x)
    out.suspect = where((status == OK) & ((close == 1) | (small_pivot == 1)), 1, 0)
    for i in range(6):
        out.F[i] = known.D[i] - out.x[i]
        status = where((status != OK) | (size(out.F[i]) <= MAX), status, NOT_FINITE)
    out.terms = known
    out.legs = legs
    out.reach = reach
    out.status = status
    return out


def inverse_dynamics(robot: "Robot", motion: "Motion") -> "Forces":
    """Every output of (1)-(37) and a status; where that is not OK, the numbers mean nothing."""
    out = solved(robot, motion)
    if anywhere(out.suspect == 1):
        H = array(6, 6)
        arm = array(6, 3)
        for i in range(6):
            for j in range(3):
                arm[i][j] = out.legs.q[j][i]
            for j in range(6):
                H[i][j] = out.terms.H[i][j]
        found = singular_status(H, arm, out.legs.L, out.reach, 0.0)
        out.status = where((out.suspect == 1) & (found != OK), found, out.status)
    return out


def regressor(robot: "Robot", motion: "Motion") -> "Regressor":
    """Columns of Y, and a status: what is wrong with a leg."""
    out = Regressor()
    out.legs = regressor_of_leg(robot.leg, robot, motion)
    out.platform = regressor_of_platform(robot, motion)
    reach = reach_of(robot.leg.b, motion.t, out.legs.q)
    out.status = first_of(fault_of(out.legs.L, out.legs.k3, reach))
    return out


def first_of(codes: "array(6)") -> "Integer":
    """The first code of six legs that is not OK."""
    found = OK
    for i in range(6):
        found = where(found == OK, codes[i], found)
    return found


def scale_of(q: "array(3, 6)") -> "Real":
    """By what the solve multiplies moments about the reference point."""
    return per_length_of(largest_of(largest_component(q, 0.0)), SMALLEST)


def largest_of(sizes: "array(6)") -> "Real":
    """The largest of six sizes."""
    most = 0.0
    for i in range(6):
        most = larger(sizes[i], most)
    return most


def eliminate(H: "array(6)", c: "array(6)", x: "array(6)") -> "Integer":
    """Solves H x = c by elimination with partial pivoting, (36), the columns of H side by side; replaces H
    and c. Returns 1 where a pivot is small."""
    inverse = blank(array(6))
    suspect = 0
    elimination()
    return suspect


# ---------------------------------------------------------------- steps of the elimination


def exchange_rows(k) -> None:
    """The row of the pivot comes to its place."""
    row = H[k]
    right = c[k]
    for i in each(k + 1, 6):
        here = pivot == i
        H[k] = where(here, H[i], H[k])
        c[k] = where(here, c[i], c[k])
        H[i] = where(here, row, H[i])
        c[i] = where(here, right, c[i])


def by_whole_rows(k) -> None:
    """The rows below lose the column; what stands in earlier columns is not read again."""
    for i in each(k + 1, 6):
        factor = a[i, k] * inverse[k,]
        H[i] = H[i] - factor * H[k]
        c[i] = c[i] - factor * c[k]
