"""Common part of the modules of inverse dynamics and regressor: robot, motion, platform, checks, solver.

Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
SPDX-License-Identifier: 0BSD

Each number of a structure may be an array with one value per pose, so the component is the first index: ``t`` is a
list of three. Numbers of ``robot.leg`` and results for legs have an additional axis for the leg before the axis of
the poses: ``m_d`` is (6, 1), ``F_s`` a list of three arrays (6, n). ``on`` is the arithmetic of arithmetic.py. Only
the conditions that a status describes are checked.
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
        self.r_d0: Any = [0.0] * 3  # m: center of mass of the lower part, frame D
        self.I_d0: Any = [0.0] * 6  # kg m^2: inertia of the lower part about its center of mass, frame D
        self.m_u: Any = 0.0  # kg: mass of the upper part
        self.r_u0: Any = [0.0] * 3  # m: center of mass of the upper part, frame U
        self.I_u0: Any = [0.0] * 6  # kg m^2: inertia of the upper part about its center of mass, frame U
        self.C_u: Any = 0.0  # N m s: viscous friction of the universal joint
        self.C_p: Any = 0.0  # N s/m: viscous friction of the prismatic joint
        self.C_s: Any = 0.0  # N m s: viscous friction of the spherical joint


class Robot:
    """The machine."""

    def __init__(self) -> None:
        self.M: Any = 0.0  # kg: mass of the platform with its payload
        self.R_0: Any = [0.0] * 3  # m: center of mass of the platform, platform frame
        # kg m^2: inertia of the platform about its center of mass, platform frame
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


class PlatformWrench:
    """The platform's part of c."""

    def __init__(self) -> None:
        self.c_force: Any = [0.0] * 3  # N: part of c, force rows, base frame
        self.c_moment: Any = [0.0] * 3  # N m: part of c, moment rows, base frame


class Terms:
    """Terms of F = D - x, H x = c; moments about the reference point."""

    def __init__(self) -> None:
        self.D: Any = [0.0] * 6  # N: known part of the actuator force, (24)
        # N: transverse force on the leg at its spherical joint, (21)
        self.K: Any = [[0.0] * 3 for _ in range(6)]
        self.H: Any = [[0.0] * 6 for _ in range(6)]  # 1 and m: from x to the wrench on the platform, (36)
        self.c: Any = [0.0] * 6  # N, N m: wrench that the axial forces balance, (36)


def platform_wrench(on: Arithmetic, robot: Any, motion: Any) -> Any:
    """Part of c that belongs to the platform, (33)-(35): 219 (123 mul, 96 add, 0 div, 0 sqrt)."""
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    omega_x, omega_y, omega_z = motion.omega
    alpha_x, alpha_y, alpha_z = motion.alpha
    a_x, a_y, a_z = motion.a
    F_ext_x, F_ext_y, F_ext_z = motion.F_ext
    M_ext_x, M_ext_y, M_ext_z = motion.M_ext
    M = robot.M
    R_0_x, R_0_y, R_0_z = robot.R_0
    I_p_xx, I_p_xy, I_p_xz, I_p_yy, I_p_yz, I_p_zz = robot.I_p
    g_x, g_y, g_z = robot.g
    # (30) center of mass from the reference point, base frame
    R_G_x = R_0_x * R_xx + R_0_y * R_xy + R_0_z * R_xz
    R_G_y = R_0_x * R_yx + R_0_y * R_yy + R_0_z * R_yz
    R_G_z = R_0_x * R_zx + R_0_y * R_zy + R_0_z * R_zz
    c1 = R_G_y * omega_x - R_G_x * omega_y
    c2 = R_G_x * omega_z - R_G_z * omega_x
    c3 = R_G_z * omega_y - R_G_y * omega_z
    # (31) acceleration of the center of mass
    a_G_x = a_x + R_G_z * alpha_y - R_G_y * alpha_z + c1 * omega_y - c2 * omega_z
    a_G_y = a_y + R_G_x * alpha_z - R_G_z * alpha_x + c3 * omega_z - c1 * omega_x
    a_G_z = a_z + R_G_y * alpha_x - R_G_x * alpha_y + c2 * omega_x - c3 * omega_y
    c4 = I_p_xx * R_xx + I_p_xy * R_xy + I_p_xz * R_xz
    c5 = I_p_xy * R_xx + I_p_yy * R_xy + I_p_yz * R_xz
    c6 = I_p_xz * R_xx + I_p_yz * R_xy + I_p_zz * R_xz
    c7 = I_p_xx * R_yx + I_p_xy * R_yy + I_p_xz * R_yz
    c8 = I_p_xy * R_yx + I_p_yy * R_yy + I_p_yz * R_yz
    c9 = I_p_xz * R_yx + I_p_yz * R_yy + I_p_zz * R_yz
    # (32) inertia of the platform, base frame
    I_xx = R_xx * c4 + R_xy * c5 + R_xz * c6
    I_xy = R_yx * c4 + R_yy * c5 + R_yz * c6
    I_xz = R_zx * c4 + R_zy * c5 + R_zz * c6
    I_yy = R_yx * c7 + R_yy * c8 + R_yz * c9
    I_yz = R_zx * c7 + R_zy * c8 + R_zz * c9
    I_zz = (R_zx * (I_p_xx * R_zx + I_p_xy * R_zy + I_p_xz * R_zz) + R_zy * (I_p_xy * R_zx + I_p_yy * R_zy + I_p_yz
        * R_zz) + R_zz * (I_p_xz * R_zx + I_p_yz * R_zy + I_p_zz * R_zz))
    # (33) M (g - a_G)
    N_x = M * (g_x - a_G_x)
    N_y = M * (g_y - a_G_y)
    N_z = M * (g_z - a_G_z)
    c10 = I_xz * omega_x + I_yz * omega_y + I_zz * omega_z
    c11 = I_xy * omega_x + I_yy * omega_y + I_yz * omega_z
    c12 = I_xx * omega_x + I_xy * omega_y + I_xz * omega_z
    # (34) I alpha + omega x I omega
    E_x = I_xx * alpha_x + I_xy * alpha_y + I_xz * alpha_z + c10 * omega_y - c11 * omega_z
    E_y = I_xy * alpha_x + I_yy * alpha_y + I_yz * alpha_z + c12 * omega_z - c10 * omega_x
    E_z = I_xz * alpha_x + I_yz * alpha_y + I_zz * alpha_z + c11 * omega_x - c12 * omega_y
    # (33) external force, base frame
    F_load_x = F_ext_x * R_xx + F_ext_y * R_xy + F_ext_z * R_xz
    F_load_y = F_ext_x * R_yx + F_ext_y * R_yy + F_ext_z * R_yz
    F_load_z = F_ext_x * R_zx + F_ext_y * R_zy + F_ext_z * R_zz
    # (34) external moment, base frame
    M_load_x = M_ext_x * R_xx + M_ext_y * R_xy + M_ext_z * R_xz
    M_load_y = M_ext_x * R_yx + M_ext_y * R_yy + M_ext_z * R_yz
    M_load_z = M_ext_x * R_zx + M_ext_y * R_zy + M_ext_z * R_zz
    out = PlatformWrench()
    out.c_force = [F_load_x + N_x, F_load_y + N_y, F_load_z + N_z]
    out.c_moment = [
        M_load_x + N_z * R_G_y - E_x - N_y * R_G_z,
        M_load_y + N_x * R_G_z - E_y - N_z * R_G_x,
        M_load_z + N_y * R_G_x - E_z - N_x * R_G_y,
    ]
    return out


def largest_component(on: Arithmetic, vector: Any, least: Any) -> Any:
    """Returns the largest of ``least`` and the magnitudes of a vector's components."""
    most = least
    for j in range(3):
        most = on.larger(on.size(vector[j]), most)
    return most


def reach_of(on: Arithmetic, b: Any, t: Any, q: Any) -> Any:
    """Returns the largest component (m) of the vectors q, t, and b, whose sum is a leg."""
    return largest_component(on, b, largest_component(on, t, largest_component(on, q, 0.0)))


def fault_of(on: Arithmetic, L: Any, k3: Any, reach: Any) -> Any:
    """Returns the status of a leg: not finite, short compared with the vectors in its sum, along k, or
    OK.
    """
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
    """Returns SINGULAR if H is singular to rounding, NOT_FINITE, or OK; H is overwritten.

    arm (m): moment arms; L (m): lengths of the legs; reach (m): largest component of the vectors
    whose sum is a leg. tip (m): largest component of the platform point from which the arms are
    measured, 0 for the reference point.

    Let Y be the inverse of H. The error of the direction s of a leg is at most 4 epsilon (reach / L +
    2). Each input and each operation is rounded by half a unit, and the elimination adds its own
    error. This error changes the column (s, arm x s) of H, and Y_force + Y_moment x arm is its factor
    for any center of moments. The rounding of the moment is added.

    G_ik bounds the effect of the error of column k on row i of Y H. If H minus its error is singular,
    no v > 0 satisfies G v < v, and the spectral radius of G is at least 1. v is computed by powers of
    G. The limit 1/2 covers the errors of Y.
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
    """Returns the factor (1/m) of moments in the linear solver for arms whose largest coordinate is
    `size` (m). It is 1 from `smallest` to 16 m. Otherwise it is the reciprocal of the smallest power
    of two, from 2^-100 to 2^100, that is not below `size`.
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
