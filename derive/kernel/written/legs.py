"""What can be wrong with a leg, and what it adds to the platform's equations."""


def fault_of(L: "Real", k3: "Real", reach: "Real") -> "Integer":
    """What is wrong with a leg: not finite, short beside the vectors that it is the sum of, or along k."""
    if CARRIED:
        status = OK
    reject(L <= MAX, NOT_FINITE)
    reject((L > ROUNDING * reach) & (L > SHORTEST), ZERO_LENGTH)
    reject(k3 > JOINT_SINGULAR_SINE, JOINT_SINGULAR)
    return status if CARRIED else OK


def reach_of(b: "array(3)", t: "array(3)", q: "array(3)") -> "Real":
    """Size of the vectors q, t and b that a leg is the sum of, m."""
    return largest_component(b, largest_component(t, largest_component(q, 0.0)))


def largest_component(vector: "array(3)", least: "Real") -> "Real":
    """The largest of ``least`` and the sizes of a vector's components."""
    most = least
    for j in range(3):
        most = larger(size(vector[j]), most)
    return most


# ---------------------------------------------------------------- a leg in its lane: ``layouts.checks``


def largest_term() -> None:
    """The largest of the terms that a leg is the sum of, and of what is too short by itself."""
    reach = SHORTEST / ROUNDING
    for term in entries(TERMS):
        reach = larger(size(term), reach)


def checked(out) -> None:
    """What decides on a leg, and a mark where it needs a closer look."""
    largest_term()
    out.reach[l] = reach
    out.L[l] = LENGTH
    if HAS_SINE:
        out.k3[l] = SINE
    mark(0.0, out.bad[l])


def mark(before, after) -> None:
    """1 in ``after`` where a leg is not finite, short, or too near its joint singularity, else ``before``.

    The sine of a leg without finite length is zero or no number.
    """
    fault = where(LENGTH > LEAST_LENGTH, before, 1.0)
    fault = where(SINE > LEAST_SINE if HAS_SINE else LENGTH <= MAX, fault, 1.0)
    after = fault


# ---------------------------------------------------------------- what a leg adds; places: ``kernel.shared``


def add_leg(i, j) -> None:
    """A component of a leg's column of H and of its part of c."""
    H[j, i] = H_force[j, i]
    H[j + 3, i] = H_moment[j, i]
    part_of_leg(i, j)


def part_of_leg(i, j) -> None:
    """A component of a leg's part of c; with moments about platform point 1 leg 1 has no arm."""
    plus(j, c_force[j, i])
    if HAS_C_MOMENT:
        plus(j + 3, c_moment[j, i])
    if ABOUT_TIP and ALL_LEGS:
        plus(j + 3, arm_c[j, i])
    if ABOUT_TIP and not ALL_LEGS:
        if i > 0:
            plus(j + 3, arm_c[j, i])


def plus(row, term) -> None:
    """Adds a term to a sum."""
    c[row,] = c[row,] + term


def plus_error(row, term) -> None:
    """Adds a term to a sum, and its rounding error to that of the sum."""
    add(c[row,], c_own[row,], term, 0.0)
