"""What the modules of every output and of the regressor share: robot and motion, checks of legs, the solve.

Written by stewart-sym 0.1.0 with SymPy 1.14; do not edit.
SPDX-License-Identifier: 0BSD

Every number of a structure may be an array with one value for each pose, so that components come first: ``t``
is a list of three. Numbers of ``robot.leg``, and those that functions find of the legs, have one value for each
leg along an axis before that of the poses: ``m_d`` is (6, 1), ``F_s`` a list of three (6, n). ``on`` is the
arithmetic of arithmetic.py. Nothing is checked but what a status says.
"""

from typing import Any

from .arithmetic import JOINT_SINGULAR, NOT_FINITE, OK, SINGULAR, ZERO_LENGTH, Arithmetic


class Leg:
    """One leg."""

    def __init__(self) -> None:
        self.b: Any = [0.0] * 3  # m: base point, base frame
        self.p: Any = [0.0] * 3  # m: platform point, platform frame
        self.k: Any = [0.0] * 3  # 1: unit vector along the fixed axis of the universal joint, base frame
        self.m_d: Any = 0.0  # kg: mass of the lower part
        self.r_d0: Any = [0.0] * 3  # m: centre of mass of the lower part, frame D
        self.I_d0: Any = [0.0] * 6  # kg m^2: inertia of the lower part about its centre of mass, frame D
        self.m_u: Any = 0.0  # kg: mass of the upper part
        self.r_u0: Any = [0.0] * 3  # m: centre of mass of the upper part, frame U
        self.I_u0: Any = [0.0] * 6  # kg m^2: inertia of the upper part about its centre of mass, frame U
        self.C_u: Any = 0.0  # N m s: viscous friction of the universal joint
        self.C_p: Any = 0.0  # N s/m: viscous friction of the prismatic joint
        self.C_s: Any = 0.0  # N m s: viscous friction of the spherical joint


class Robot:
    """The machine."""

    def __init__(self) -> None:
        self.M: Any = 0.0  # kg: mass of the platform with its payload
        self.R_0: Any = [0.0] * 3  # m: centre of mass of the platform, platform frame
        # kg m^2: inertia of the platform about its centre of mass, platform frame
        self.I_p: Any = [0.0] * 6
        self.g: Any = [0.0] * 3  # m/s^2: acceleration due to gravity, base frame
        self.leg: Any = Leg()  # the legs, in each number one value for each leg


class Motion:
    """Motion of the platform and its load."""

    def __init__(self) -> None:
        self.R: Any = [0.0] * 9  # 1: orientation of the platform, platform frame to base frame
        self.t: Any = [0.0] * 3  # m: position of the platform's reference point, base frame
        self.omega: Any = [0.0] * 3  # rad/s: angular velocity of the platform, base frame
        self.v: Any = [0.0] * 3  # m/s: velocity of the reference point, base frame
        self.alpha: Any = [0.0] * 3  # rad/s^2: angular acceleration of the platform, base frame
        self.a: Any = [0.0] * 3  # m/s^2: acceleration of the reference point, base frame
        self.F_ext: Any = [0.0] * 3  # N: external force at the reference point, platform frame
        self.M_ext: Any = [0.0] * 3  # N m: external moment about the reference point, platform frame


def largest_component(on: Arithmetic, vector: Any, least: Any) -> Any:
    """The largest of ``least`` and the sizes of a vector's components."""
    most = least
    for j in range(3):
        most = on.larger(on.size(vector[j]), most)
    return most


def reach_of(on: Arithmetic, b: Any, t: Any, q: Any) -> Any:
    """Size of the vectors q, t and b that a leg is the sum of, m."""
    return largest_component(on, b, largest_component(on, t, largest_component(on, q, 0.0)))


def fault_of(on: Arithmetic, L: Any, k3: Any, reach: Any) -> Any:
    """What is wrong with a leg: not finite, short beside the vectors that it is the sum of, or along k."""
    status = OK
    status = on.where((status != OK) | (L <= on.MAX), status, NOT_FINITE)
    status = on.where((status != OK) | ((L > on.ROUNDING * reach) & (L > on.SHORTEST)), status, ZERO_LENGTH)
    status = on.where((status != OK) | (k3 > on.JOINT_SINGULAR_SINE), status, JOINT_SINGULAR)
    return status


def first_of(on: Arithmetic, codes: Any) -> Any:
    """The first code of six legs that is not OK."""
    found = OK
    for i in range(6):
        found = on.where(found == OK, codes[i], found)
    return found


def singular_status(on: Arithmetic, H: Any, arm: Any, L: Any, reach: Any, tip: Any) -> Any:
    """Whether H is singular to rounding: OK, SINGULAR or NOT_FINITE; H is replaced.

    arm: of the moments; L: lengths of the legs; reach: size of the vectors that a leg is the sum of;
    tip: of the platform point that the arms are measured from, whose rounding they have, 0 for none.
    The direction s of a leg errs by 4 epsilon (reach / L + 2) at most: half a unit of each number
    that goes in and of each operation, and what the elimination adds. Its column of H, (s, arm x s),
    errs by that through Y_force + Y_moment x arm with Y the inverse of H, wherever moments are taken
    about, and by the rounding of the moment. Where H less its error is singular, no v > 0 has G v <
    v, G_ik what the error of column k does to row i of Y H: the spectral radius of G is 1 or more.
    Powers of G make v; 1/2 leaves room for the errors of Y itself.
    """
    Y = [[0.0] * 6 for _ in range(6)]
    G = [[0.0] * 6 for _ in range(6)]
    v = [0.0] * 6
    grown = [0.0] * 6
    extent = tip
    least = 1.0
    status = OK
    for i in range(6):
        v[i] = 1.0
        for j in range(3):
            extent = on.larger(on.size(arm[i][j]), extent)
    for i in range(6):
        for j in range(6):
            status = on.where((status != OK) | (on.size(H[i][j]) <= on.MAX), status, NOT_FINITE)
            H[i][j] = on.where(i < 3, H[i][j], H[i][j] / extent)
            Y[i][j] = on.where(i == j, 1.0, 0.0)
    for k in range(6):
        pivot = k
        most = on.size(H[k][k])
        for i in range(k + 1, 6):
            entry = on.size(H[i][k])
            pivot = on.where(entry > most, i, pivot)
            most = on.where(entry > most, entry, most)
        if on.anywhere(pivot != k):
            for j in range(6):
                moved = H[k][j]
                H[k][j] = on.at(H, pivot, j)
                on.put(H, moved, pivot, j)
                beside = Y[k][j]
                Y[k][j] = on.at(Y, pivot, j)
                on.put(Y, beside, pivot, j)
        status = on.where((status != OK) | (on.size(H[k][k]) > 0.0), status, SINGULAR)
        for i in range(6):
            if i != k:
                factor = H[i][k] / H[k][k]
                for j in range(6):
                    H[i][j] = H[i][j] - factor * H[k][j]
                    Y[i][j] = Y[i][j] - factor * Y[k][j]
    for i in range(6):
        by_moment = on.size(Y[i][3]) + on.size(Y[i][4]) + on.size(Y[i][5])
        for k in range(6):
            x = on.size(Y[i][0] + (Y[i][4] * arm[k][2] - Y[i][5] * arm[k][1]) / extent)
            y = on.size(Y[i][1] + (Y[i][5] * arm[k][0] - Y[i][3] * arm[k][2]) / extent)
            z = on.size(Y[i][2] + (Y[i][3] * arm[k][1] - Y[i][4] * arm[k][0]) / extent)
            turned = (x + y + z) * (reach[k] / L[k] + 2.0) + 2.0 * by_moment
            G[i][k] = turned * (4.0 * on.EPSILON) / on.size(H[i][i])
    for turn in range(4):
        if on.anywhere(least > 0.5):
            worst = 0.0
            greatest = 0.0
            for i in range(6):
                total = 0.0
                for k in range(6):
                    total = total + G[i][k] * v[k]
                share = total / v[i]
                worst = on.where(share <= worst, worst, share)
                greatest = on.larger(total, greatest)
                grown[i] = total
            least = on.where(worst <= least, worst, least)
            for i in range(6):
                v[i] = on.larger(grown[i] / greatest, on.EPSILON)
        else:
            break
    status = on.where((status != OK) | (least <= 0.5), status, SINGULAR)
    return status


def per_length_of(on: Arithmetic, size: Any, smallest: Any) -> Any:
    """What moments are multiplied by in the solve where no coordinate of their arms exceeds `size`, 1/m:
    1 for arms of about a metre, `smallest` and more, else one over the least power of two, from
    2^-100 to 2^100, that is as large.
    """
    per_length = 1.0
    if on.anywhere((size < smallest) | (size > on.LARGEST)):
        unit = 1.0
        for i in range(100):
            if on.anywhere(unit < size):
                unit = on.where(unit < size, 2.0 * unit, unit)
            else:
                break
        for i in range(100):
            if on.anywhere((size > 0.0) & (0.5 * unit >= size)):
                unit = on.where((size > 0.0) & (0.5 * unit >= size), 0.5 * unit, unit)
            else:
                break
        per_length = on.where((size < smallest) | (size > on.LARGEST), 1.0 / unit, 1.0)
    return per_length


def largest_of(on: Arithmetic, sizes: Any) -> Any:
    """The largest of six sizes."""
    most = 0.0
    for i in range(6):
        most = on.larger(sizes[i], most)
    return most


def scale_of(on: Arithmetic, q: Any) -> Any:
    """By what the solve multiplies moments about the reference point."""
    return per_length_of(on, largest_of(on, largest_component(on, q, 0.0)), 0.0625)


def eliminate(on: Arithmetic, H: Any, c: Any, x: Any) -> Any:
    """Solves H x = c by elimination with partial pivoting, (36), the columns of H side by side; replaces
    H and c. Returns 1 where a pivot is small.
    """
    inverse = [0.0] * 6
    suspect = 0
    for k in range(6):
        pivot = k
        most = on.size(H[k][k])
        for i in range(k + 1, 6):
            entry = on.size(H[i][k])
            pivot = on.where(entry > most, i, pivot)
            most = on.where(entry > most, entry, most)
        row = H[k]
        right = c[k]
        for i in range(k + 1, 6):
            here = pivot == i
            H[k] = on.where(here, H[i], H[k])
            c[k] = on.where(here, c[i], c[k])
            H[i] = on.where(here, row, H[i])
            c[i] = on.where(here, right, c[i])
        suspect = on.where(on.size(H[k][k]) > on.SUSPECT, suspect, 1)
        inverse[k] = 1.0 / H[k][k]
        for i in range(k + 1, 6):
            factor = H[i][k] * inverse[k]
            H[i] = H[i] - factor * H[k]
            c[i] = c[i] - factor * c[k]
    for i in range(5, -1, -1):
        total = c[i]
        for j in range(i + 1, 6):
            total = total - H[i][j] * x[j]
        x[i] = total * inverse[i]
    return suspect
