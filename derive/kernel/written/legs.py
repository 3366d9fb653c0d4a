"""What can be wrong with a leg, and what it adds to the platform's equations."""


def check_leg(L, k3, reach) -> None:
    """A leg is finite, longer than the rounding of the vectors that it is the sum of, and not along k."""
    reject(L <= MAX, NOT_FINITE)
    reject((L > ROUNDING * reach) & (L > SHORTEST), SHORT_LEG)
    if HAS_SINE:
        reject(k3 > POLE_SINE, POLE)


def fault_of(L: "Real", k3: "Real", reach: "Real") -> "Integer":
    """What is wrong with a leg: not finite, short beside the vectors that it is the sum of, or along k."""
    if CARRIED:
        status = OK
    check_leg(L, k3, reach)
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


def add_leg(i, j, out, leg) -> None:
    """A component of a leg's column of H and of its part of c; no moment of leg 1 about its own point."""
    out.H[j][i] = leg.H_force[j]
    out.H[j + 3][i] = where(i > 0, leg.H_moment[j], 0.0) if ABOUT_TIP else leg.H_moment[j]
    plus(out, j, leg.c_force[j])
    plus(out, j + 3, leg.c_moment[j])
    if ABOUT_TIP:
        if i > 0:
            plus(out, j + 3, leg.arm_c[j])


def plus(out, i, term) -> None:
    """One term more."""
    out.c[i] = out.c[i] + term


def plus_error(out, i, term) -> None:
    """And the rounding error of the sum."""
    add(out.c[i], out.c_own[i], term, 0.0)
