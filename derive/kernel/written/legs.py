"""What can be wrong with a leg."""


def fault_of(L: "Real", k3: "Real", reach: "Real") -> "Integer":
    """What is wrong with a leg: not finite, short beside the vectors that it is the sum of, or along k."""
    fault = OK
    fault = where(k3 > POLE_SINE, fault, POLE)
    fault = where(L > larger(ROUNDING * reach, SHORTEST), fault, SHORT_LEG)
    return where(L <= MAX, fault, NOT_FINITE)


def reach_of(b: "array(3)", t: "array(3)", q: "array(3)") -> "Real":
    """Size of the vectors q, t and b that a leg is the sum of, m."""
    reach = 0.0
    for j in range(3):
        reach = larger(size(q[j]), reach)
        reach = larger(size(t[j]), reach)
        reach = larger(size(b[j]), reach)
    return reach
