"""Dynamics of the Stewart platform on arrays of the array API: NumPy, JAX, PyTorch and others.

Written by stewart-sym 0.1.0 with SymPy 1.14; do not edit.
SPDX-License-Identifier: 0BSD

Every number of a structure may be an array with one value for each pose. ``on`` is the arithmetic: selections,
square roots and constants. Where a status is not 0, the other numbers of a result are NaN.
"""

from typing import Any

from .arithmetic import INDEFINITE, NOT_FINITE, OK, POLE, SHORT_LEG, SINGULAR, Arithmetic


class Leg:
    """One leg."""

    def __init__(self) -> None:
        # m: base point, base frame
        self.b: Any = [0.0] * 3
        # m: platform point, platform frame
        self.p: Any = [0.0] * 3
        # 1: unit vector along the fixed axis of the universal joint, base frame
        self.k: Any = [0.0] * 3
        # kg: mass of the lower part
        self.m_d: Any = 0.0
        # m: centre of mass of the lower part, frame D
        self.r_d0: Any = [0.0] * 3
        # kg m^2: inertia of the lower part about its centre of mass, frame D
        self.I_d0: Any = [0.0] * 6
        # kg: mass of the upper part
        self.m_u: Any = 0.0
        # m: centre of mass of the upper part, frame U
        self.r_u0: Any = [0.0] * 3
        # kg m^2: inertia of the upper part about its centre of mass, frame U
        self.I_u0: Any = [0.0] * 6
        # N m s: viscous friction of the universal joint
        self.C_u: Any = 0.0
        # N s/m: viscous friction of the prismatic joint
        self.C_p: Any = 0.0
        # N m s: viscous friction of the spherical joint
        self.C_s: Any = 0.0


class Robot:
    """The machine."""

    def __init__(self) -> None:
        # kg: mass of the platform with its payload
        self.M: Any = 0.0
        # m: centre of mass of the platform, platform frame
        self.R_0: Any = [0.0] * 3
        # kg m^2: inertia of the platform about its centre of mass, platform frame
        self.I_p: Any = [0.0] * 6
        # m/s^2: acceleration due to gravity, base frame
        self.g: Any = [0.0] * 3
        # the legs
        self.leg: Any = [Leg() for _ in range(6)]


class Motion:
    """Motion of the platform and its load."""

    def __init__(self) -> None:
        # 1: orientation of the platform, platform frame to base frame
        self.R: Any = [0.0] * 9
        # m: position of the platform's reference point, base frame
        self.t: Any = [0.0] * 3
        # rad/s: angular velocity of the platform, base frame
        self.omega: Any = [0.0] * 3
        # m/s: velocity of the reference point, base frame
        self.v: Any = [0.0] * 3
        # rad/s^2: angular acceleration of the platform, base frame
        self.alpha: Any = [0.0] * 3
        # m/s^2: acceleration of the reference point, base frame
        self.a: Any = [0.0] * 3
        # N: external force at the reference point, platform frame
        self.F_ext: Any = [0.0] * 3
        # N m: external moment about the reference point, platform frame
        self.M_ext: Any = [0.0] * 3


class LegConstants:
    """Prepared constants of one leg."""

    def __init__(self) -> None:
        # m: base point, base frame
        self.b: Any = [0.0] * 3
        # m: platform point, platform frame
        self.p: Any = [0.0] * 3
        # 1: unit vector along the fixed axis of the universal joint, base frame
        self.k: Any = [0.0] * 3
        # N s/m: viscous friction of the prismatic joint
        self.C_p: Any = 0.0
        # N m s: viscous friction of the spherical joint
        self.C_s: Any = 0.0
        # kg m: first moment of the upper part about the platform point, leg frame
        self.h: Any = [0.0] * 3
        # kg m: 2 h_x
        self.h2_x: Any = 0.0
        # kg m: 2 h_y
        self.h2_y: Any = 0.0
        # kg m: 2 h_z
        self.h2_z: Any = 0.0
        # kg m: first moments of both parts, about the base and the platform point, leg frame
        self.w: Any = [0.0] * 3
        # kg m^2: inertias of the parts about base and platform point, leg frame
        self.J: Any = [0.0] * 6
        # kg m^2: 2 J_xz
        self.J2_xz: Any = 0.0
        # kg m^2: J_zz - J_xx
        self.dJ_zx: Any = 0.0
        # m/s^2: gravity along the fixed axis
        self.g_k: Any = 0.0
        # m/s^2: g x k, base frame
        self.g_x_k: Any = [0.0] * 3
        # N m s: C_u + C_s
        self.C_us: Any = 0.0
        # kg: mass of the upper part
        self.m_u: Any = 0.0
        # kg: mass that rides on the platform
        self.M_add: Any = 0.0
        # kg m: its first moment, platform frame
        self.h_add: Any = [0.0] * 3
        # kg m^2: its inertia about the reference point, platform frame
        self.J_add: Any = [0.0] * 6
        # N m s: friction of the leg's spherical joint
        self.C_add: Any = 0.0


class Added:
    """What the legs add to the platform's constants."""

    def __init__(self) -> None:
        # kg: mass that rides on the platform
        self.M_add: Any = 0.0
        # kg m: its first moment, platform frame
        self.h_add: Any = [0.0] * 3
        # kg m^2: its inertia about the reference point, platform frame
        self.J_add: Any = [0.0] * 6
        # N m s: friction of the leg's spherical joint
        self.C_add: Any = 0.0


class Platform:
    """Constants of the platform."""

    def __init__(self) -> None:
        # kg: mass of the platform with the upper parts
        self.M_P: Any = 0.0
        # kg m: its first moment, platform frame
        self.h_P: Any = [0.0] * 3
        # kg m^2: its inertia about the reference point, platform frame
        self.J_P: Any = [0.0] * 6
        # kg m^2: J_P_zz - J_P_yy, J_P_xx - J_P_zz, J_P_yy - J_P_xx
        self.dJ_P: Any = [0.0] * 3
        # N m s: friction of all spherical joints
        self.C_P: Any = 0.0
        # m/s^2: acceleration due to gravity, base frame
        self.g: Any = [0.0] * 3
        # kg: mass of the platform with its payload
        self.M: Any = 0.0
        # m: centre of mass of the platform, platform frame
        self.R_0: Any = [0.0] * 3
        # kg m^2: inertia of the platform about its centre of mass, platform frame
        self.I_p: Any = [0.0] * 6


class Model:
    """A robot's constants, prepared once."""

    def __init__(self) -> None:
        # the legs
        self.leg: Any = [LegConstants() for _ in range(6)]
        # the platform
        self.platform: Any = Platform()
        # 1/m: one over the length over which moments are taken
        self.per_length: Any = 0.0
        # 0, or what is wrong
        self.status: Any = 0


class SharedTerms:
    """What a pose has for all legs."""

    def __init__(self) -> None:
        # 1/s^2: [alpha]x + [omega]x [omega]x: S_ddot = B q + a
        self.B: Any = [0.0] * 9
        # N: part of c, force rows, base frame
        self.c_force: Any = [0.0] * 3
        # N m: part of c, moment rows, base frame
        self.c_moment: Any = [0.0] * 3


class LegTerms:
    """What a leg has."""

    def __init__(self) -> None:
        # m: platform point from the reference point, base frame
        self.q: Any = [0.0] * 3
        # m: length of the leg
        self.L: Any = 0.0
        # 1: |k x s|, sine of the angle between the leg and the fixed axis
        self.k3: Any = 0.0
        # N: known part of the actuator force
        self.D: Any = 0.0
        # 1: the leg's column of H, force rows
        self.H_force: Any = [0.0] * 3
        # N: part of c, force rows, base frame
        self.c_force: Any = [0.0] * 3
        # N m: part of c, moment rows, base frame
        self.c_moment: Any = [0.0] * 3


class ShiftTerms:
    """The platform's part of c about platform point 1."""

    def __init__(self) -> None:
        # N m: the platform's part of c, moment rows, about platform point 1
        self.c_tip: Any = [0.0] * 3


class MomentTerms:
    """A leg's moments about platform point 1."""

    def __init__(self) -> None:
        # m: the leg's column of H, moment rows
        self.H_moment: Any = [0.0] * 3
        # N m: moment of the leg's part of c, force rows, about platform point 1
        self.arm_c: Any = [0.0] * 3


class Sums:
    """H, c, and what moments are made with."""

    def __init__(self) -> None:
        # N: part of c, force rows, base frame
        self.c_force: Any = [0.0] * 3
        # N m: part of c, moment rows, base frame
        self.c_moment: Any = [0.0] * 3
        # m: platform point 1 from the reference point, base frame
        self.q_1: Any = [0.0] * 3
        # 1 and m: from x to the wrench on the platform, (36)
        self.H: Any = [[0.0] * 6 for _ in range(6)]
        # m: arms of the moments
        self.arm: Any = [[0.0] * 3 for _ in range(6)]


class Forces:
    """Actuator forces of one pose."""

    def __init__(self) -> None:
        # N: positive when they extend the leg, (37)
        self.F: Any = [0.0] * 6
        # 0, or what is wrong
        self.status: Any = 0


class EquationsPose:
    """The pose's own part."""

    def __init__(self) -> None:
        # kg: inertia, force by a
        self.M_vv: Any = [0.0] * 6
        # kg m: inertia, force by alpha
        self.M_vw: Any = [0.0] * 9
        # kg m^2: inertia, moment by alpha
        self.M_ww: Any = [0.0] * 6
        # kg/s: Coriolis matrix, force by v
        self.C_vv: Any = [0.0] * 9
        # kg m/s: Coriolis matrix, force by omega
        self.C_vw: Any = [0.0] * 9
        # kg m/s: Coriolis matrix, moment by v
        self.C_wv: Any = [0.0] * 9
        # kg m^2/s: Coriolis matrix, moment by omega
        self.C_ww: Any = [0.0] * 9
        # N: gravity, force
        self.g_force: Any = [0.0] * 3
        # N m: gravity, moment
        self.g_moment: Any = [0.0] * 3
        # N: friction, force
        self.friction_force: Any = [0.0] * 3
        # N m: friction, moment
        self.friction_moment: Any = [0.0] * 3


class EquationsLeg:
    """A leg's part."""

    def __init__(self) -> None:
        # kg: inertia, force by a
        self.M_vv: Any = [0.0] * 6
        # kg m: inertia, force by alpha
        self.M_vw: Any = [0.0] * 9
        # kg m^2: inertia, moment by alpha
        self.M_ww: Any = [0.0] * 6
        # kg/s: Coriolis matrix, force by v
        self.C_vv: Any = [0.0] * 9
        # kg m/s: Coriolis matrix, force by omega
        self.C_vw: Any = [0.0] * 9
        # kg m/s: Coriolis matrix, moment by v
        self.C_wv: Any = [0.0] * 9
        # kg m^2/s: Coriolis matrix, moment by omega
        self.C_ww: Any = [0.0] * 9
        # N: gravity, force
        self.g_force: Any = [0.0] * 3
        # N m: gravity, moment
        self.g_moment: Any = [0.0] * 3
        # N: friction, force
        self.friction_force: Any = [0.0] * 3
        # N m: friction, moment
        self.friction_moment: Any = [0.0] * 3
        # 1: the leg's column of H, force rows
        self.H_force: Any = [0.0] * 3
        # m: the leg's column of H, moment rows
        self.H_moment: Any = [0.0] * 3
        # 1/s: rate of the leg's column of H, force rows
        self.H_dot_force: Any = [0.0] * 3
        # m/s: rate of the leg's column of H, moment rows
        self.H_dot_moment: Any = [0.0] * 3
        # m: platform point from the reference point, base frame
        self.q: Any = [0.0] * 3
        # m: length of the leg
        self.L: Any = 0.0
        # 1: |k x s|, sine of the angle between the leg and the fixed axis
        self.k3: Any = 0.0


class EquationsSums:
    """Sums over the machine."""

    def __init__(self) -> None:
        # kg: inertia, force by a
        self.M_vv: Any = [0.0] * 6
        # kg m: inertia, force by alpha
        self.M_vw: Any = [0.0] * 9
        # kg m^2: inertia, moment by alpha
        self.M_ww: Any = [0.0] * 6
        # kg/s: Coriolis matrix, force by v
        self.C_vv: Any = [0.0] * 9
        # kg m/s: Coriolis matrix, force by omega
        self.C_vw: Any = [0.0] * 9
        # kg m/s: Coriolis matrix, moment by v
        self.C_wv: Any = [0.0] * 9
        # kg m^2/s: Coriolis matrix, moment by omega
        self.C_ww: Any = [0.0] * 9
        # N: gravity, force
        self.g_force: Any = [0.0] * 3
        # N m: gravity, moment
        self.g_moment: Any = [0.0] * 3
        # N: friction, force
        self.friction_force: Any = [0.0] * 3
        # N m: friction, moment
        self.friction_moment: Any = [0.0] * 3


class Equations:
    """M [a; alpha] + C [v; omega] + g + friction = H F + [R F_ext; R M_ext]."""

    def __init__(self) -> None:
        # kg, kg m, kg m^2: inertia
        self.M: Any = [[0.0] * 6 for _ in range(6)]
        # kg/s, kg m/s, kg m^2/s: Coriolis matrix
        self.C: Any = [[0.0] * 6 for _ in range(6)]
        # N, N m: gravity
        self.g: Any = [0.0] * 6
        # N, N m: friction
        self.friction: Any = [0.0] * 6
        # N, N m: C [v; omega] + g + friction
        self.bias: Any = [0.0] * 6
        # 1 and m: from F to the wrench on the platform
        self.H: Any = [[0.0] * 6 for _ in range(6)]
        # 0, or what is wrong
        self.status: Any = 0


class ForwardPose:
    """The pose's own part."""

    def __init__(self) -> None:
        # 1/s^2: [omega]x [omega]x
        self.B_0: Any = [0.0] * 9
        # kg: inertia, force by a
        self.M_vv: Any = [0.0] * 6
        # kg m: inertia, force by alpha
        self.M_vw: Any = [0.0] * 9
        # kg m^2: inertia, moment by alpha
        self.M_ww: Any = [0.0] * 6
        # N: H F + external wrench - bias, force
        self.right_force: Any = [0.0] * 3
        # N m: H F + external wrench - bias, moment
        self.right_moment: Any = [0.0] * 3


class ForwardLeg:
    """A leg's part."""

    def __init__(self) -> None:
        # kg: inertia, force by a
        self.M_vv: Any = [0.0] * 6
        # kg m: inertia, force by alpha
        self.M_vw: Any = [0.0] * 9
        # kg m^2: inertia, moment by alpha
        self.M_ww: Any = [0.0] * 6
        # N: H F + external wrench - bias, force
        self.right_force: Any = [0.0] * 3
        # N m: H F + external wrench - bias, moment
        self.right_moment: Any = [0.0] * 3
        # m: platform point from the reference point, base frame
        self.q: Any = [0.0] * 3
        # m: length of the leg
        self.L: Any = 0.0
        # 1: |k x s|, sine of the angle between the leg and the fixed axis
        self.k3: Any = 0.0


class ForwardSums:
    """Sums over the machine."""

    def __init__(self) -> None:
        # kg: inertia, force by a
        self.M_vv: Any = [0.0] * 6
        # kg m: inertia, force by alpha
        self.M_vw: Any = [0.0] * 9
        # kg m^2: inertia, moment by alpha
        self.M_ww: Any = [0.0] * 6
        # N: H F + external wrench - bias, force
        self.right_force: Any = [0.0] * 3
        # N m: H F + external wrench - bias, moment
        self.right_moment: Any = [0.0] * 3


class JointRowsPose:
    """The pose's own part."""

    def __init__(self) -> None:
        # 1/s^2: [omega]x [omega]x
        self.B_0: Any = [0.0] * 9
        # kg: inertia, force by a
        self.M_vv: Any = [0.0] * 6
        # kg m: inertia, force by alpha
        self.M_vw: Any = [0.0] * 9
        # kg m^2: inertia, moment by alpha
        self.M_ww: Any = [0.0] * 6
        # N: H F + external wrench - bias, force
        self.right_force: Any = [0.0] * 3
        # N m: H F + external wrench - bias, moment
        self.right_moment: Any = [0.0] * 3


class JointRowsLeg:
    """A leg's part."""

    def __init__(self) -> None:
        # kg: inertia, force by a
        self.M_vv: Any = [0.0] * 6
        # kg m: inertia, force by alpha
        self.M_vw: Any = [0.0] * 9
        # kg m^2: inertia, moment by alpha
        self.M_ww: Any = [0.0] * 6
        # N: H F + external wrench - bias, force
        self.right_force: Any = [0.0] * 3
        # N m: H F + external wrench - bias, moment
        self.right_moment: Any = [0.0] * 3
        # kg, kg m, kg m^2: inertia of the joint coordinates, rows L, theta, phi
        self.M_xi: Any = [0.0] * 6
        # 1, 1/m: gradients of L, theta, phi by position
        self.row_v: Any = [0.0] * 9
        # m, 1: gradients of L, theta, phi by rotation
        self.row_w: Any = [0.0] * 9
        # N, N m: generalised forces less the actuator's without accelerations of the platform
        self.tau: Any = [0.0] * 3
        # m: platform point from the reference point, base frame
        self.q: Any = [0.0] * 3
        # m: length of the leg
        self.L: Any = 0.0
        # 1: |k x s|, sine of the angle between the leg and the fixed axis
        self.k3: Any = 0.0


class JointRowsSums:
    """Sums over the machine."""

    def __init__(self) -> None:
        # kg: inertia, force by a
        self.M_vv: Any = [0.0] * 6
        # kg m: inertia, force by alpha
        self.M_vw: Any = [0.0] * 9
        # kg m^2: inertia, moment by alpha
        self.M_ww: Any = [0.0] * 6
        # N: H F + external wrench - bias, force
        self.right_force: Any = [0.0] * 3
        # N m: H F + external wrench - bias, moment
        self.right_moment: Any = [0.0] * 3


class RowBlock:
    """Three rows of A."""

    def __init__(self) -> None:
        # root of the inertia in each row
        self.extent: Any = [0.0] * 3
        # 1: their inertia over these
        self.weight: Any = [[0.0] * 3 for _ in range(3)]


class Rows:
    """M = A^T W A: three rows for each leg, by L, theta, phi, and six of the platform."""

    def __init__(self) -> None:
        # what legs have
        self.leg: Any = [JointRowsLeg() for _ in range(6)]
        # of legs, and two of the platform
        self.block: Any = [RowBlock() for _ in range(8)]
        # A, each row times the root of its inertia; then multipliers
        self.row: Any = [[0.0] * 6 for _ in range(24)]
        # each row as a sum of the six that serve as coordinates
        self.share: Any = [[0.0] * 6 for _ in range(24)]
        # L and U of these six, columns exchanged
        self.factors: Any = [[0.0] * 6 for _ in range(6)]
        # number of the column in each place
        self.column: Any = [0] * 6
        # 1 where a row is the one picked in a place, else 0
        self.place: Any = [[0.0] * 24 for _ in range(6)]
        # 1 of a row that was picked, else 0
        self.chosen: Any = [0.0] * 24
        # m: moments and rotations are measured by it
        self.length: Any = 0.0


class Apart:
    """What the rows give."""

    def __init__(self) -> None:
        # m/s^2, rad/s^2: a and alpha
        self.x: Any = [0.0] * 6
        # 0, or what is wrong
        self.status: Any = 0


class Accelerations:
    """Accelerations of the platform."""

    def __init__(self) -> None:
        # m/s^2: acceleration of the reference point
        self.a: Any = [0.0] * 3
        # rad/s^2: angular acceleration
        self.alpha: Any = [0.0] * 3
        # 0, or what is wrong
        self.status: Any = 0


def prepare_leg(on: Arithmetic, robot: Any, leg: Any) -> Any:
    """Constants of one leg, and what it adds to the platform: 96 (55 mul, 39 add, 1 div, 1 sqrt)."""
    b_x = leg.b[0]
    b_y = leg.b[1]
    b_z = leg.b[2]
    p_x = leg.p[0]
    p_y = leg.p[1]
    p_z = leg.p[2]
    k_x = leg.k[0]
    k_y = leg.k[1]
    k_z = leg.k[2]
    m_d = leg.m_d
    r_d0_x = leg.r_d0[0]
    r_d0_y = leg.r_d0[1]
    r_d0_z = leg.r_d0[2]
    I_d0_xx = leg.I_d0[0]
    I_d0_xy = leg.I_d0[1]
    I_d0_xz = leg.I_d0[2]
    I_d0_yy = leg.I_d0[3]
    I_d0_yz = leg.I_d0[4]
    I_d0_zz = leg.I_d0[5]
    m_u = leg.m_u
    r_u0_x = leg.r_u0[0]
    r_u0_y = leg.r_u0[1]
    r_u0_z = leg.r_u0[2]
    I_u0_xx = leg.I_u0[0]
    I_u0_xy = leg.I_u0[1]
    I_u0_xz = leg.I_u0[2]
    I_u0_yy = leg.I_u0[3]
    I_u0_yz = leg.I_u0[4]
    I_u0_zz = leg.I_u0[5]
    C_u = leg.C_u
    C_p = leg.C_p
    C_s = leg.C_s
    g_x = robot.g[0]
    g_y = robot.g[1]
    g_z = robot.g[2]
    k_size = on.sqrt(k_x * k_x + k_y * k_y + k_z * k_z)
    inv_k_size = 1.0 / k_size
    # fixed axis, of length one
    k_unit_x = inv_k_size * k_x
    k_unit_y = inv_k_size * k_y
    k_unit_z = inv_k_size * k_z
    c1 = m_u * r_u0_x
    h_x = c1
    c2 = m_u * r_u0_y
    h_y = c2
    h_z = m_u * r_u0_z
    c3 = m_d * r_d0_x
    w_x = c3 + h_x
    c4 = m_d * r_d0_y
    w_y = c4 + h_y
    w_z = h_z + m_d * r_d0_z
    c5 = r_d0_y * r_d0_y
    c6 = r_d0_z * r_d0_z
    c7 = r_u0_y * r_u0_y
    c8 = r_u0_z * r_u0_z
    J_xx = I_d0_xx + I_u0_xx + m_d * (c5 + c6) + m_u * (c7 + c8)
    J_xy = I_d0_xy + I_u0_xy - c1 * r_u0_y - c3 * r_d0_y
    J_xz = I_d0_xz + I_u0_xz - c1 * r_u0_z - c3 * r_d0_z
    c9 = r_d0_x * r_d0_x
    c10 = r_u0_x * r_u0_x
    J_yy = I_d0_yy + I_u0_yy + m_d * (c6 + c9) + m_u * (c10 + c8)
    J_yz = I_d0_yz + I_u0_yz - c2 * r_u0_z - c4 * r_d0_z
    J_zz = I_d0_zz + I_u0_zz + m_d * (c5 + c9) + m_u * (c10 + c7)
    c11 = m_u * p_x
    c12 = m_u * p_y
    c13 = p_y * p_y
    c14 = p_z * p_z
    c15 = p_x * p_x
    out = LegConstants()
    out.b[0] = b_x
    out.b[1] = b_y
    out.b[2] = b_z
    out.p[0] = p_x
    out.p[1] = p_y
    out.p[2] = p_z
    out.k[0] = k_unit_x
    out.k[1] = k_unit_y
    out.k[2] = k_unit_z
    out.C_p = C_p
    out.C_s = C_s
    out.h[0] = h_x
    out.h[1] = h_y
    out.h[2] = h_z
    out.h2_x = 2.0 * h_x
    out.h2_y = 2.0 * h_y
    out.h2_z = 2.0 * h_z
    out.w[0] = w_x
    out.w[1] = w_y
    out.w[2] = w_z
    out.J[0] = J_xx
    out.J[1] = J_xy
    out.J[2] = J_xz
    out.J[3] = J_yy
    out.J[4] = J_yz
    out.J[5] = J_zz
    out.J2_xz = 2.0 * J_xz
    out.dJ_zx = J_zz - J_xx
    out.g_k = g_x * k_unit_x + g_y * k_unit_y + g_z * k_unit_z
    out.g_x_k[0] = g_y * k_unit_z - g_z * k_unit_y
    out.g_x_k[1] = g_z * k_unit_x - g_x * k_unit_z
    out.g_x_k[2] = g_x * k_unit_y - g_y * k_unit_x
    out.C_us = C_s + C_u
    out.m_u = m_u
    out.M_add = m_u
    out.h_add[0] = c11
    out.h_add[1] = c12
    out.h_add[2] = m_u * p_z
    out.J_add[0] = m_u * (c13 + c14)
    out.J_add[1] = -c11 * p_y
    out.J_add[2] = -c11 * p_z
    out.J_add[3] = m_u * (c14 + c15)
    out.J_add[4] = -c12 * p_z
    out.J_add[5] = m_u * (c13 + c15)
    out.C_add = C_s
    return out


def prepare_platform(on: Arithmetic, robot: Any, total: Any) -> Any:
    """Constants of the platform: 34 (12 mul, 22 add, 0 div, 0 sqrt)."""
    M = robot.M
    R_0_x = robot.R_0[0]
    R_0_y = robot.R_0[1]
    R_0_z = robot.R_0[2]
    I_p_xx = robot.I_p[0]
    I_p_xy = robot.I_p[1]
    I_p_xz = robot.I_p[2]
    I_p_yy = robot.I_p[3]
    I_p_yz = robot.I_p[4]
    I_p_zz = robot.I_p[5]
    g_x = robot.g[0]
    g_y = robot.g[1]
    g_z = robot.g[2]
    M_add = total.M_add
    h_add_x = total.h_add[0]
    h_add_y = total.h_add[1]
    h_add_z = total.h_add[2]
    J_add_xx = total.J_add[0]
    J_add_xy = total.J_add[1]
    J_add_xz = total.J_add[2]
    J_add_yy = total.J_add[3]
    J_add_yz = total.J_add[4]
    J_add_zz = total.J_add[5]
    C_add = total.C_add
    c1 = R_0_y * R_0_y
    c2 = R_0_z * R_0_z
    J_P_xx = I_p_xx + J_add_xx + M * (c1 + c2)
    c3 = M * R_0_x
    J_P_xy = I_p_xy + J_add_xy - R_0_y * c3
    J_P_xz = I_p_xz + J_add_xz - R_0_z * c3
    c4 = R_0_x * R_0_x
    J_P_yy = I_p_yy + J_add_yy + M * (c2 + c4)
    c5 = M * R_0_y
    J_P_yz = I_p_yz + J_add_yz - R_0_z * c5
    J_P_zz = I_p_zz + J_add_zz + M * (c1 + c4)
    out = Platform()
    out.M_P = M + M_add
    out.h_P[0] = c3 + h_add_x
    out.h_P[1] = c5 + h_add_y
    out.h_P[2] = M * R_0_z + h_add_z
    out.J_P[0] = J_P_xx
    out.J_P[1] = J_P_xy
    out.J_P[2] = J_P_xz
    out.J_P[3] = J_P_yy
    out.J_P[4] = J_P_yz
    out.J_P[5] = J_P_zz
    out.dJ_P[0] = J_P_zz - J_P_yy
    out.dJ_P[1] = J_P_xx - J_P_zz
    out.dJ_P[2] = J_P_yy - J_P_xx
    out.C_P = C_add
    out.g[0] = g_x
    out.g[1] = g_y
    out.g[2] = g_z
    out.M = M
    out.R_0[0] = R_0_x
    out.R_0[1] = R_0_y
    out.R_0[2] = R_0_z
    out.I_p[0] = I_p_xx
    out.I_p[1] = I_p_xy
    out.I_p[2] = I_p_xz
    out.I_p[3] = I_p_yy
    out.I_p[4] = I_p_yz
    out.I_p[5] = I_p_zz
    return out


def add_up(on: Arithmetic, total: Any, more: Any) -> Any:
    """What the legs add to the platform, with one leg more."""
    out = Added()
    out.M_add = total.M_add + more.M_add
    out.h_add[0] = total.h_add[0] + more.h_add[0]
    out.h_add[1] = total.h_add[1] + more.h_add[1]
    out.h_add[2] = total.h_add[2] + more.h_add[2]
    out.J_add[0] = total.J_add[0] + more.J_add[0]
    out.J_add[1] = total.J_add[1] + more.J_add[1]
    out.J_add[2] = total.J_add[2] + more.J_add[2]
    out.J_add[3] = total.J_add[3] + more.J_add[3]
    out.J_add[4] = total.J_add[4] + more.J_add[4]
    out.J_add[5] = total.J_add[5] + more.J_add[5]
    out.C_add = total.C_add + more.C_add
    return out


def lost_digits(on: Arithmetic, model: Any) -> Any:
    """Zero as long as all constants are finite."""
    lost = 0.0
    lost = lost + 0.0 * model.leg[0].b[0]
    lost = lost + 0.0 * model.leg[0].b[1]
    lost = lost + 0.0 * model.leg[0].b[2]
    lost = lost + 0.0 * model.leg[0].p[0]
    lost = lost + 0.0 * model.leg[0].p[1]
    lost = lost + 0.0 * model.leg[0].p[2]
    lost = lost + 0.0 * model.leg[0].k[0]
    lost = lost + 0.0 * model.leg[0].k[1]
    lost = lost + 0.0 * model.leg[0].k[2]
    lost = lost + 0.0 * model.leg[0].C_p
    lost = lost + 0.0 * model.leg[0].C_s
    lost = lost + 0.0 * model.leg[0].h[0]
    lost = lost + 0.0 * model.leg[0].h[1]
    lost = lost + 0.0 * model.leg[0].h[2]
    lost = lost + 0.0 * model.leg[0].h2_x
    lost = lost + 0.0 * model.leg[0].h2_y
    lost = lost + 0.0 * model.leg[0].h2_z
    lost = lost + 0.0 * model.leg[0].w[0]
    lost = lost + 0.0 * model.leg[0].w[1]
    lost = lost + 0.0 * model.leg[0].w[2]
    lost = lost + 0.0 * model.leg[0].J[0]
    lost = lost + 0.0 * model.leg[0].J[1]
    lost = lost + 0.0 * model.leg[0].J[2]
    lost = lost + 0.0 * model.leg[0].J[3]
    lost = lost + 0.0 * model.leg[0].J[4]
    lost = lost + 0.0 * model.leg[0].J[5]
    lost = lost + 0.0 * model.leg[0].J2_xz
    lost = lost + 0.0 * model.leg[0].dJ_zx
    lost = lost + 0.0 * model.leg[0].g_k
    lost = lost + 0.0 * model.leg[0].g_x_k[0]
    lost = lost + 0.0 * model.leg[0].g_x_k[1]
    lost = lost + 0.0 * model.leg[0].g_x_k[2]
    lost = lost + 0.0 * model.leg[0].C_us
    lost = lost + 0.0 * model.leg[0].m_u
    lost = lost + 0.0 * model.leg[0].M_add
    lost = lost + 0.0 * model.leg[0].h_add[0]
    lost = lost + 0.0 * model.leg[0].h_add[1]
    lost = lost + 0.0 * model.leg[0].h_add[2]
    lost = lost + 0.0 * model.leg[0].J_add[0]
    lost = lost + 0.0 * model.leg[0].J_add[1]
    lost = lost + 0.0 * model.leg[0].J_add[2]
    lost = lost + 0.0 * model.leg[0].J_add[3]
    lost = lost + 0.0 * model.leg[0].J_add[4]
    lost = lost + 0.0 * model.leg[0].J_add[5]
    lost = lost + 0.0 * model.leg[0].C_add
    lost = lost + 0.0 * model.leg[1].b[0]
    lost = lost + 0.0 * model.leg[1].b[1]
    lost = lost + 0.0 * model.leg[1].b[2]
    lost = lost + 0.0 * model.leg[1].p[0]
    lost = lost + 0.0 * model.leg[1].p[1]
    lost = lost + 0.0 * model.leg[1].p[2]
    lost = lost + 0.0 * model.leg[1].k[0]
    lost = lost + 0.0 * model.leg[1].k[1]
    lost = lost + 0.0 * model.leg[1].k[2]
    lost = lost + 0.0 * model.leg[1].C_p
    lost = lost + 0.0 * model.leg[1].C_s
    lost = lost + 0.0 * model.leg[1].h[0]
    lost = lost + 0.0 * model.leg[1].h[1]
    lost = lost + 0.0 * model.leg[1].h[2]
    lost = lost + 0.0 * model.leg[1].h2_x
    lost = lost + 0.0 * model.leg[1].h2_y
    lost = lost + 0.0 * model.leg[1].h2_z
    lost = lost + 0.0 * model.leg[1].w[0]
    lost = lost + 0.0 * model.leg[1].w[1]
    lost = lost + 0.0 * model.leg[1].w[2]
    lost = lost + 0.0 * model.leg[1].J[0]
    lost = lost + 0.0 * model.leg[1].J[1]
    lost = lost + 0.0 * model.leg[1].J[2]
    lost = lost + 0.0 * model.leg[1].J[3]
    lost = lost + 0.0 * model.leg[1].J[4]
    lost = lost + 0.0 * model.leg[1].J[5]
    lost = lost + 0.0 * model.leg[1].J2_xz
    lost = lost + 0.0 * model.leg[1].dJ_zx
    lost = lost + 0.0 * model.leg[1].g_k
    lost = lost + 0.0 * model.leg[1].g_x_k[0]
    lost = lost + 0.0 * model.leg[1].g_x_k[1]
    lost = lost + 0.0 * model.leg[1].g_x_k[2]
    lost = lost + 0.0 * model.leg[1].C_us
    lost = lost + 0.0 * model.leg[1].m_u
    lost = lost + 0.0 * model.leg[1].M_add
    lost = lost + 0.0 * model.leg[1].h_add[0]
    lost = lost + 0.0 * model.leg[1].h_add[1]
    lost = lost + 0.0 * model.leg[1].h_add[2]
    lost = lost + 0.0 * model.leg[1].J_add[0]
    lost = lost + 0.0 * model.leg[1].J_add[1]
    lost = lost + 0.0 * model.leg[1].J_add[2]
    lost = lost + 0.0 * model.leg[1].J_add[3]
    lost = lost + 0.0 * model.leg[1].J_add[4]
    lost = lost + 0.0 * model.leg[1].J_add[5]
    lost = lost + 0.0 * model.leg[1].C_add
    lost = lost + 0.0 * model.leg[2].b[0]
    lost = lost + 0.0 * model.leg[2].b[1]
    lost = lost + 0.0 * model.leg[2].b[2]
    lost = lost + 0.0 * model.leg[2].p[0]
    lost = lost + 0.0 * model.leg[2].p[1]
    lost = lost + 0.0 * model.leg[2].p[2]
    lost = lost + 0.0 * model.leg[2].k[0]
    lost = lost + 0.0 * model.leg[2].k[1]
    lost = lost + 0.0 * model.leg[2].k[2]
    lost = lost + 0.0 * model.leg[2].C_p
    lost = lost + 0.0 * model.leg[2].C_s
    lost = lost + 0.0 * model.leg[2].h[0]
    lost = lost + 0.0 * model.leg[2].h[1]
    lost = lost + 0.0 * model.leg[2].h[2]
    lost = lost + 0.0 * model.leg[2].h2_x
    lost = lost + 0.0 * model.leg[2].h2_y
    lost = lost + 0.0 * model.leg[2].h2_z
    lost = lost + 0.0 * model.leg[2].w[0]
    lost = lost + 0.0 * model.leg[2].w[1]
    lost = lost + 0.0 * model.leg[2].w[2]
    lost = lost + 0.0 * model.leg[2].J[0]
    lost = lost + 0.0 * model.leg[2].J[1]
    lost = lost + 0.0 * model.leg[2].J[2]
    lost = lost + 0.0 * model.leg[2].J[3]
    lost = lost + 0.0 * model.leg[2].J[4]
    lost = lost + 0.0 * model.leg[2].J[5]
    lost = lost + 0.0 * model.leg[2].J2_xz
    lost = lost + 0.0 * model.leg[2].dJ_zx
    lost = lost + 0.0 * model.leg[2].g_k
    lost = lost + 0.0 * model.leg[2].g_x_k[0]
    lost = lost + 0.0 * model.leg[2].g_x_k[1]
    lost = lost + 0.0 * model.leg[2].g_x_k[2]
    lost = lost + 0.0 * model.leg[2].C_us
    lost = lost + 0.0 * model.leg[2].m_u
    lost = lost + 0.0 * model.leg[2].M_add
    lost = lost + 0.0 * model.leg[2].h_add[0]
    lost = lost + 0.0 * model.leg[2].h_add[1]
    lost = lost + 0.0 * model.leg[2].h_add[2]
    lost = lost + 0.0 * model.leg[2].J_add[0]
    lost = lost + 0.0 * model.leg[2].J_add[1]
    lost = lost + 0.0 * model.leg[2].J_add[2]
    lost = lost + 0.0 * model.leg[2].J_add[3]
    lost = lost + 0.0 * model.leg[2].J_add[4]
    lost = lost + 0.0 * model.leg[2].J_add[5]
    lost = lost + 0.0 * model.leg[2].C_add
    lost = lost + 0.0 * model.leg[3].b[0]
    lost = lost + 0.0 * model.leg[3].b[1]
    lost = lost + 0.0 * model.leg[3].b[2]
    lost = lost + 0.0 * model.leg[3].p[0]
    lost = lost + 0.0 * model.leg[3].p[1]
    lost = lost + 0.0 * model.leg[3].p[2]
    lost = lost + 0.0 * model.leg[3].k[0]
    lost = lost + 0.0 * model.leg[3].k[1]
    lost = lost + 0.0 * model.leg[3].k[2]
    lost = lost + 0.0 * model.leg[3].C_p
    lost = lost + 0.0 * model.leg[3].C_s
    lost = lost + 0.0 * model.leg[3].h[0]
    lost = lost + 0.0 * model.leg[3].h[1]
    lost = lost + 0.0 * model.leg[3].h[2]
    lost = lost + 0.0 * model.leg[3].h2_x
    lost = lost + 0.0 * model.leg[3].h2_y
    lost = lost + 0.0 * model.leg[3].h2_z
    lost = lost + 0.0 * model.leg[3].w[0]
    lost = lost + 0.0 * model.leg[3].w[1]
    lost = lost + 0.0 * model.leg[3].w[2]
    lost = lost + 0.0 * model.leg[3].J[0]
    lost = lost + 0.0 * model.leg[3].J[1]
    lost = lost + 0.0 * model.leg[3].J[2]
    lost = lost + 0.0 * model.leg[3].J[3]
    lost = lost + 0.0 * model.leg[3].J[4]
    lost = lost + 0.0 * model.leg[3].J[5]
    lost = lost + 0.0 * model.leg[3].J2_xz
    lost = lost + 0.0 * model.leg[3].dJ_zx
    lost = lost + 0.0 * model.leg[3].g_k
    lost = lost + 0.0 * model.leg[3].g_x_k[0]
    lost = lost + 0.0 * model.leg[3].g_x_k[1]
    lost = lost + 0.0 * model.leg[3].g_x_k[2]
    lost = lost + 0.0 * model.leg[3].C_us
    lost = lost + 0.0 * model.leg[3].m_u
    lost = lost + 0.0 * model.leg[3].M_add
    lost = lost + 0.0 * model.leg[3].h_add[0]
    lost = lost + 0.0 * model.leg[3].h_add[1]
    lost = lost + 0.0 * model.leg[3].h_add[2]
    lost = lost + 0.0 * model.leg[3].J_add[0]
    lost = lost + 0.0 * model.leg[3].J_add[1]
    lost = lost + 0.0 * model.leg[3].J_add[2]
    lost = lost + 0.0 * model.leg[3].J_add[3]
    lost = lost + 0.0 * model.leg[3].J_add[4]
    lost = lost + 0.0 * model.leg[3].J_add[5]
    lost = lost + 0.0 * model.leg[3].C_add
    lost = lost + 0.0 * model.leg[4].b[0]
    lost = lost + 0.0 * model.leg[4].b[1]
    lost = lost + 0.0 * model.leg[4].b[2]
    lost = lost + 0.0 * model.leg[4].p[0]
    lost = lost + 0.0 * model.leg[4].p[1]
    lost = lost + 0.0 * model.leg[4].p[2]
    lost = lost + 0.0 * model.leg[4].k[0]
    lost = lost + 0.0 * model.leg[4].k[1]
    lost = lost + 0.0 * model.leg[4].k[2]
    lost = lost + 0.0 * model.leg[4].C_p
    lost = lost + 0.0 * model.leg[4].C_s
    lost = lost + 0.0 * model.leg[4].h[0]
    lost = lost + 0.0 * model.leg[4].h[1]
    lost = lost + 0.0 * model.leg[4].h[2]
    lost = lost + 0.0 * model.leg[4].h2_x
    lost = lost + 0.0 * model.leg[4].h2_y
    lost = lost + 0.0 * model.leg[4].h2_z
    lost = lost + 0.0 * model.leg[4].w[0]
    lost = lost + 0.0 * model.leg[4].w[1]
    lost = lost + 0.0 * model.leg[4].w[2]
    lost = lost + 0.0 * model.leg[4].J[0]
    lost = lost + 0.0 * model.leg[4].J[1]
    lost = lost + 0.0 * model.leg[4].J[2]
    lost = lost + 0.0 * model.leg[4].J[3]
    lost = lost + 0.0 * model.leg[4].J[4]
    lost = lost + 0.0 * model.leg[4].J[5]
    lost = lost + 0.0 * model.leg[4].J2_xz
    lost = lost + 0.0 * model.leg[4].dJ_zx
    lost = lost + 0.0 * model.leg[4].g_k
    lost = lost + 0.0 * model.leg[4].g_x_k[0]
    lost = lost + 0.0 * model.leg[4].g_x_k[1]
    lost = lost + 0.0 * model.leg[4].g_x_k[2]
    lost = lost + 0.0 * model.leg[4].C_us
    lost = lost + 0.0 * model.leg[4].m_u
    lost = lost + 0.0 * model.leg[4].M_add
    lost = lost + 0.0 * model.leg[4].h_add[0]
    lost = lost + 0.0 * model.leg[4].h_add[1]
    lost = lost + 0.0 * model.leg[4].h_add[2]
    lost = lost + 0.0 * model.leg[4].J_add[0]
    lost = lost + 0.0 * model.leg[4].J_add[1]
    lost = lost + 0.0 * model.leg[4].J_add[2]
    lost = lost + 0.0 * model.leg[4].J_add[3]
    lost = lost + 0.0 * model.leg[4].J_add[4]
    lost = lost + 0.0 * model.leg[4].J_add[5]
    lost = lost + 0.0 * model.leg[4].C_add
    lost = lost + 0.0 * model.leg[5].b[0]
    lost = lost + 0.0 * model.leg[5].b[1]
    lost = lost + 0.0 * model.leg[5].b[2]
    lost = lost + 0.0 * model.leg[5].p[0]
    lost = lost + 0.0 * model.leg[5].p[1]
    lost = lost + 0.0 * model.leg[5].p[2]
    lost = lost + 0.0 * model.leg[5].k[0]
    lost = lost + 0.0 * model.leg[5].k[1]
    lost = lost + 0.0 * model.leg[5].k[2]
    lost = lost + 0.0 * model.leg[5].C_p
    lost = lost + 0.0 * model.leg[5].C_s
    lost = lost + 0.0 * model.leg[5].h[0]
    lost = lost + 0.0 * model.leg[5].h[1]
    lost = lost + 0.0 * model.leg[5].h[2]
    lost = lost + 0.0 * model.leg[5].h2_x
    lost = lost + 0.0 * model.leg[5].h2_y
    lost = lost + 0.0 * model.leg[5].h2_z
    lost = lost + 0.0 * model.leg[5].w[0]
    lost = lost + 0.0 * model.leg[5].w[1]
    lost = lost + 0.0 * model.leg[5].w[2]
    lost = lost + 0.0 * model.leg[5].J[0]
    lost = lost + 0.0 * model.leg[5].J[1]
    lost = lost + 0.0 * model.leg[5].J[2]
    lost = lost + 0.0 * model.leg[5].J[3]
    lost = lost + 0.0 * model.leg[5].J[4]
    lost = lost + 0.0 * model.leg[5].J[5]
    lost = lost + 0.0 * model.leg[5].J2_xz
    lost = lost + 0.0 * model.leg[5].dJ_zx
    lost = lost + 0.0 * model.leg[5].g_k
    lost = lost + 0.0 * model.leg[5].g_x_k[0]
    lost = lost + 0.0 * model.leg[5].g_x_k[1]
    lost = lost + 0.0 * model.leg[5].g_x_k[2]
    lost = lost + 0.0 * model.leg[5].C_us
    lost = lost + 0.0 * model.leg[5].m_u
    lost = lost + 0.0 * model.leg[5].M_add
    lost = lost + 0.0 * model.leg[5].h_add[0]
    lost = lost + 0.0 * model.leg[5].h_add[1]
    lost = lost + 0.0 * model.leg[5].h_add[2]
    lost = lost + 0.0 * model.leg[5].J_add[0]
    lost = lost + 0.0 * model.leg[5].J_add[1]
    lost = lost + 0.0 * model.leg[5].J_add[2]
    lost = lost + 0.0 * model.leg[5].J_add[3]
    lost = lost + 0.0 * model.leg[5].J_add[4]
    lost = lost + 0.0 * model.leg[5].J_add[5]
    lost = lost + 0.0 * model.leg[5].C_add
    lost = lost + 0.0 * model.platform.M_P
    lost = lost + 0.0 * model.platform.h_P[0]
    lost = lost + 0.0 * model.platform.h_P[1]
    lost = lost + 0.0 * model.platform.h_P[2]
    lost = lost + 0.0 * model.platform.J_P[0]
    lost = lost + 0.0 * model.platform.J_P[1]
    lost = lost + 0.0 * model.platform.J_P[2]
    lost = lost + 0.0 * model.platform.J_P[3]
    lost = lost + 0.0 * model.platform.J_P[4]
    lost = lost + 0.0 * model.platform.J_P[5]
    lost = lost + 0.0 * model.platform.dJ_P[0]
    lost = lost + 0.0 * model.platform.dJ_P[1]
    lost = lost + 0.0 * model.platform.dJ_P[2]
    lost = lost + 0.0 * model.platform.C_P
    lost = lost + 0.0 * model.platform.g[0]
    lost = lost + 0.0 * model.platform.g[1]
    lost = lost + 0.0 * model.platform.g[2]
    lost = lost + 0.0 * model.platform.M
    lost = lost + 0.0 * model.platform.R_0[0]
    lost = lost + 0.0 * model.platform.R_0[1]
    lost = lost + 0.0 * model.platform.R_0[2]
    lost = lost + 0.0 * model.platform.I_p[0]
    lost = lost + 0.0 * model.platform.I_p[1]
    lost = lost + 0.0 * model.platform.I_p[2]
    lost = lost + 0.0 * model.platform.I_p[3]
    lost = lost + 0.0 * model.platform.I_p[4]
    lost = lost + 0.0 * model.platform.I_p[5]
    return lost


def shared_terms(on: Arithmetic, platform: Any, motion: Any) -> Any:
    """B and the platform's part of c, (7), (30)-(35): 180 (93 mul, 87 add, 0 div, 0 sqrt)."""
    R_xx = motion.R[0]
    R_xy = motion.R[1]
    R_xz = motion.R[2]
    R_yx = motion.R[3]
    R_yy = motion.R[4]
    R_yz = motion.R[5]
    R_zx = motion.R[6]
    R_zy = motion.R[7]
    R_zz = motion.R[8]
    omega_x = motion.omega[0]
    omega_y = motion.omega[1]
    omega_z = motion.omega[2]
    alpha_x = motion.alpha[0]
    alpha_y = motion.alpha[1]
    alpha_z = motion.alpha[2]
    a_x = motion.a[0]
    a_y = motion.a[1]
    a_z = motion.a[2]
    F_ext_x = motion.F_ext[0]
    F_ext_y = motion.F_ext[1]
    F_ext_z = motion.F_ext[2]
    M_ext_x = motion.M_ext[0]
    M_ext_y = motion.M_ext[1]
    M_ext_z = motion.M_ext[2]
    M_P = platform.M_P
    h_P_x = platform.h_P[0]
    h_P_y = platform.h_P[1]
    h_P_z = platform.h_P[2]
    J_P_xx = platform.J_P[0]
    J_P_xy = platform.J_P[1]
    J_P_xz = platform.J_P[2]
    J_P_yy = platform.J_P[3]
    J_P_yz = platform.J_P[4]
    J_P_zz = platform.J_P[5]
    dJ_P_x = platform.dJ_P[0]
    dJ_P_y = platform.dJ_P[1]
    dJ_P_z = platform.dJ_P[2]
    C_P = platform.C_P
    g_x = platform.g[0]
    g_y = platform.g[1]
    g_z = platform.g[2]
    # products of omega
    omega_xx = omega_x * omega_x
    omega_xy = omega_x * omega_y
    omega_xz = omega_x * omega_z
    omega_yy = omega_y * omega_y
    omega_yz = omega_y * omega_z
    omega_zz = omega_z * omega_z
    # (7) S_ddot = B q + a
    B_xx = -omega_yy - omega_zz
    B_xy = omega_xy - alpha_z
    B_xz = alpha_y + omega_xz
    B_yx = alpha_z + omega_xy
    B_yy = -omega_xx - omega_zz
    B_yz = omega_yz - alpha_x
    B_zx = omega_xz - alpha_y
    B_zy = alpha_x + omega_yz
    B_zz = -omega_xx - omega_yy
    # (30) first moment of the platform, base frame
    h_base_x = R_xx * h_P_x + R_xy * h_P_y + R_xz * h_P_z
    h_base_y = R_yx * h_P_x + R_yy * h_P_y + R_yz * h_P_z
    h_base_z = R_zx * h_P_x + R_zy * h_P_y + R_zz * h_P_z
    # (33) g - a
    fall_x = g_x - a_x
    fall_y = g_y - a_y
    fall_z = g_z - a_z
    # angular velocity, platform frame
    omega_P_x = R_xx * omega_x + R_yx * omega_y + R_zx * omega_z
    omega_P_y = R_xy * omega_x + R_yy * omega_y + R_zy * omega_z
    omega_P_z = R_xz * omega_x + R_yz * omega_y + R_zz * omega_z
    # angular acceleration, platform frame
    alpha_P_x = R_xx * alpha_x + R_yx * alpha_y + R_zx * alpha_z
    alpha_P_y = R_xy * alpha_x + R_yy * alpha_y + R_zy * alpha_z
    alpha_P_z = R_xz * alpha_x + R_yz * alpha_y + R_zz * alpha_z
    P_xy = omega_P_x * omega_P_y
    P_xz = omega_P_x * omega_P_z
    P_yz = omega_P_y * omega_P_z
    P_xx = omega_P_x * omega_P_x
    P_yy = omega_P_y * omega_P_y
    P_zz = omega_P_z * omega_P_z
    # (34) external moment less I alpha + omega x I omega, platform frame
    M_P_load_x = (
        J_P_xy * (P_xz - alpha_P_y) + M_ext_x - J_P_xx * alpha_P_x - J_P_xz * (P_xy + alpha_P_z) - J_P_yz * (P_yy
            - P_zz) - P_yz * dJ_P_x
    )
    M_P_load_y = (
        J_P_yz * (P_xy - alpha_P_z) + M_ext_y - J_P_xy * (P_yz + alpha_P_x) - J_P_xz * (P_zz - P_xx) - J_P_yy
            * alpha_P_y - P_xz * dJ_P_y
    )
    M_P_load_z = (
        J_P_xz * (P_yz - alpha_P_x) + M_ext_z - J_P_xy * (P_xx - P_yy) - J_P_yz * (P_xz + alpha_P_y) - J_P_zz
            * alpha_P_z - P_xy * dJ_P_z
    )
    out = SharedTerms()
    out.B[0] = B_xx
    out.B[1] = B_xy
    out.B[2] = B_xz
    out.B[3] = B_yx
    out.B[4] = B_yy
    out.B[5] = B_yz
    out.B[6] = B_zx
    out.B[7] = B_zy
    out.B[8] = B_zz
    out.c_force[0] = (
        F_ext_x * R_xx + F_ext_y * R_xy + F_ext_z * R_xz + M_P * fall_x - B_xx * h_base_x - B_xy * h_base_y
            - B_xz * h_base_z
    )
    out.c_force[1] = (
        F_ext_x * R_yx + F_ext_y * R_yy + F_ext_z * R_yz + M_P * fall_y - B_yx * h_base_x - B_yy * h_base_y
            - B_yz * h_base_z
    )
    out.c_force[2] = (
        F_ext_x * R_zx + F_ext_y * R_zy + F_ext_z * R_zz + M_P * fall_z - B_zx * h_base_x - B_zy * h_base_y
            - B_zz * h_base_z
    )
    out.c_moment[0] = (
        M_P_load_x * R_xx + M_P_load_y * R_xy + M_P_load_z * R_xz + fall_z * h_base_y - C_P * omega_x - fall_y
            * h_base_z
    )
    out.c_moment[1] = (
        M_P_load_x * R_yx + M_P_load_y * R_yy + M_P_load_z * R_yz + fall_x * h_base_z - C_P * omega_y - fall_z
            * h_base_x
    )
    out.c_moment[2] = (
        M_P_load_x * R_zx + M_P_load_y * R_zy + M_P_load_z * R_zz + fall_y * h_base_x - C_P * omega_z - fall_x
            * h_base_y
    )
    return out


def leg_terms(on: Arithmetic, leg: Any, platform: Any, motion: Any, shared: Any) -> Any:
    """One leg in joint coordinates: D, its column of H and its part of c: 265 (156 mul, 105 add, 2 div, 2 sqrt)."""
    b_x = leg.b[0]
    b_y = leg.b[1]
    b_z = leg.b[2]
    p_x = leg.p[0]
    p_y = leg.p[1]
    p_z = leg.p[2]
    k_x = leg.k[0]
    k_y = leg.k[1]
    k_z = leg.k[2]
    C_p = leg.C_p
    C_s = leg.C_s
    h_x = leg.h[0]
    h_y = leg.h[1]
    h_z = leg.h[2]
    h2_x = leg.h2_x
    h2_y = leg.h2_y
    h2_z = leg.h2_z
    w_x = leg.w[0]
    w_y = leg.w[1]
    w_z = leg.w[2]
    J_xx = leg.J[0]
    J_xy = leg.J[1]
    J_yy = leg.J[3]
    J_yz = leg.J[4]
    J2_xz = leg.J2_xz
    dJ_zx = leg.dJ_zx
    g_k = leg.g_k
    g_x_k_x = leg.g_x_k[0]
    g_x_k_y = leg.g_x_k[1]
    g_x_k_z = leg.g_x_k[2]
    C_us = leg.C_us
    R_xx = motion.R[0]
    R_xy = motion.R[1]
    R_xz = motion.R[2]
    R_yx = motion.R[3]
    R_yy = motion.R[4]
    R_yz = motion.R[5]
    R_zx = motion.R[6]
    R_zy = motion.R[7]
    R_zz = motion.R[8]
    t_x = motion.t[0]
    t_y = motion.t[1]
    t_z = motion.t[2]
    omega_x = motion.omega[0]
    omega_y = motion.omega[1]
    omega_z = motion.omega[2]
    v_x = motion.v[0]
    v_y = motion.v[1]
    v_z = motion.v[2]
    a_x = motion.a[0]
    a_y = motion.a[1]
    a_z = motion.a[2]
    B_xx = shared.B[0]
    B_xy = shared.B[1]
    B_xz = shared.B[2]
    B_yx = shared.B[3]
    B_yy = shared.B[4]
    B_yz = shared.B[5]
    B_zx = shared.B[6]
    B_zy = shared.B[7]
    B_zz = shared.B[8]
    g_x = platform.g[0]
    g_y = platform.g[1]
    g_z = platform.g[2]
    # (1) platform point from the reference point
    q_x = R_xx * p_x + R_xy * p_y + R_xz * p_z
    q_y = R_yx * p_x + R_yy * p_y + R_yz * p_z
    q_z = R_zx * p_x + R_zy * p_y + R_zz * p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = q_x + t_b_x
    S_y = q_y + t_b_y
    S_z = q_z + t_b_z
    # (10) leg vector along the fixed axis, and normal to both
    zeta = S_x * k_x + S_y * k_y + S_z * k_z
    k_cross_S_x = S_z * k_y - S_y * k_z
    k_cross_S_y = S_x * k_z - S_z * k_x
    k_cross_S_z = S_y * k_x - S_x * k_y
    rho2 = k_cross_S_x * k_cross_S_x + k_cross_S_y * k_cross_S_y + k_cross_S_z * k_cross_S_z
    # (2) leg length, and distance of its tip from the fixed axis
    L = on.sqrt(rho2 + zeta * zeta)
    rho = on.sqrt(rho2)
    inv_L = 1.0 / L
    # (3) unit vector along the leg
    s_x = S_x * inv_L
    s_y = S_y * inv_L
    s_z = S_z * inv_L
    inv_rho = 1.0 / rho
    # (10) second axis of the leg frame
    y_x = inv_rho * k_cross_S_x
    y_y = inv_rho * k_cross_S_y
    y_z = inv_rho * k_cross_S_z
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = inv_L * zeta
    k3 = inv_L * rho
    # (10) k1 / k3
    kappa = inv_rho * zeta
    # (4) velocity of the platform point
    S_dot_x = omega_y * q_z + v_x - omega_z * q_y
    S_dot_y = omega_z * q_x + v_y - omega_x * q_z
    S_dot_z = omega_x * q_y + v_z - omega_y * q_x
    # (7) acceleration of the platform point
    S_ddot_x = B_xx * q_x + B_xy * q_y + B_xz * q_z + a_x
    S_ddot_y = B_yx * q_x + B_yy * q_y + B_yz * q_z + a_y
    S_ddot_z = B_zx * q_x + B_zy * q_y + B_zz * q_z + a_z
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x * s_x + S_dot_y * s_y + S_dot_z * s_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = inv_rho * (S_dot_x * y_x + S_dot_y * y_y + S_dot_z * y_z)
    theta_dot = inv_rho * (L_dot * k1 - S_dot_x * k_x - S_dot_y * k_y - S_dot_z * k_z)
    # L_dot / L
    L_share = L_dot * inv_L
    lean = kappa * theta_dot
    theta_dot2 = theta_dot * theta_dot
    phi_dot2 = phi_dot * phi_dot
    two_phi_dot = 2.0 * phi_dot
    # rho_dot / rho
    rho_share = L_share + lean
    k33 = k3 * k3
    # (8) accelerations of the joint coordinates
    L_ddot = L * (k33 * phi_dot2 + theta_dot2) + S_ddot_x * s_x + S_ddot_y * s_y + S_ddot_z * s_z
    # (9) accelerations of the joint coordinates
    theta_ddot = (
        inv_rho * (L_ddot * k1 - S_ddot_x * k_x - S_ddot_y * k_y - S_ddot_z * k_z) - theta_dot * (L_share + rho_share)
    )
    phi_ddot = inv_rho * (S_ddot_x * y_x + S_ddot_y * y_y + S_ddot_z * y_z) - rho_share * two_phi_dot
    k13 = k1 * k3
    L_h2 = L * h2_x
    a1 = L_h2 + dJ_zx
    a2 = J2_xz - L * h2_z
    a3 = J_xy - L * h_y
    # (19) inertia of the joint coordinates
    M_phi = J_xx + a1 * k33 + a2 * k13
    M_theta = J_yy + L_h2
    M_mixed = J_yz * k3 + a3 * k1
    k3_h = h_y * k3
    # (19) slopes of M_phi / 2 along theta and L, of M_mixed along theta
    M_phi_theta = a1 * k13 + a2 * (0.5 - k33)
    M_phi_L = h_x * k33 - h_z * k13
    M_mixed_theta = J_yz * k1 - a3 * k3
    bend = L_dot * theta_dot
    # gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # first moment along k and against k x y
    w_k = k1 * w_x + k3 * w_z
    w_n = k3 * w_x - k1 * w_z
    # (20) generalised forces about y and about k
    tau_y = (
        C_us * theta_dot + L_ddot * h_z + M_mixed * phi_ddot + M_theta * theta_ddot + bend * h2_x + g_k * w_n
            + gamma_n * w_k - C_s * (omega_x * y_x + omega_y * y_y + omega_z * y_z) - M_phi_theta * phi_dot2
    )
    tau_k = (
        C_us * phi_dot + M_mixed * theta_ddot + M_mixed_theta * theta_dot2 + M_phi * phi_ddot + two_phi_dot
            * (L_dot * M_phi_L + M_phi_theta * theta_dot) - C_s * (k_x * omega_x + k_y * omega_y + k_z * omega_z)
            - L_ddot * k3_h - bend * h2_y * k1 - gamma_n * w_y - gamma_y * w_n
    )
    # (21) K = Q_k k + Q_y y, up to a part along s
    Q_k = -inv_rho * tau_y
    Q_y = inv_rho * tau_k
    # (21) force at the spherical joint, base frame
    K_x = Q_k * k_x + Q_y * y_x
    K_y = Q_k * k_y + Q_y * y_y
    K_z = Q_k * k_z + Q_y * y_z
    # (24) known part of the actuator force, to match
    D = C_p * L_dot + h_z * theta_ddot - M_phi_L * phi_dot2 - Q_k * k1 - h_x * theta_dot2 - k3_h * phi_ddot
    c1 = C_s * phi_dot
    c2 = C_s * theta_dot
    out = LegTerms()
    out.q[0] = q_x
    out.q[1] = q_y
    out.q[2] = q_z
    out.L = L
    out.k3 = k3
    out.D = D
    out.H_force[0] = s_x
    out.H_force[1] = s_y
    out.H_force[2] = s_z
    out.c_force[0] = -K_x
    out.c_force[1] = -K_y
    out.c_force[2] = -K_z
    out.c_moment[0] = c1 * k_x + c2 * y_x
    out.c_moment[1] = c1 * k_y + c2 * y_y
    out.c_moment[2] = c1 * k_z + c2 * y_z
    return out


def leg_near_terms(on: Arithmetic, leg: Any, platform: Any, motion: Any, shared: Any) -> Any:
    """One leg in joint coordinates: D, its column of H and its part of c: 289 (173 mul, 112 add, 2 div, 2 sqrt)."""
    b_x = leg.b[0]
    b_y = leg.b[1]
    b_z = leg.b[2]
    p_x = leg.p[0]
    p_y = leg.p[1]
    p_z = leg.p[2]
    k_x = leg.k[0]
    k_y = leg.k[1]
    k_z = leg.k[2]
    C_p = leg.C_p
    C_s = leg.C_s
    h_x = leg.h[0]
    h_y = leg.h[1]
    h_z = leg.h[2]
    h2_x = leg.h2_x
    h2_y = leg.h2_y
    h2_z = leg.h2_z
    w_x = leg.w[0]
    w_y = leg.w[1]
    w_z = leg.w[2]
    J_xx = leg.J[0]
    J_xy = leg.J[1]
    J_yy = leg.J[3]
    J_yz = leg.J[4]
    J2_xz = leg.J2_xz
    dJ_zx = leg.dJ_zx
    g_k = leg.g_k
    g_x_k_x = leg.g_x_k[0]
    g_x_k_y = leg.g_x_k[1]
    g_x_k_z = leg.g_x_k[2]
    C_us = leg.C_us
    R_xx = motion.R[0]
    R_xy = motion.R[1]
    R_xz = motion.R[2]
    R_yx = motion.R[3]
    R_yy = motion.R[4]
    R_yz = motion.R[5]
    R_zx = motion.R[6]
    R_zy = motion.R[7]
    R_zz = motion.R[8]
    t_x = motion.t[0]
    t_y = motion.t[1]
    t_z = motion.t[2]
    omega_x = motion.omega[0]
    omega_y = motion.omega[1]
    omega_z = motion.omega[2]
    v_x = motion.v[0]
    v_y = motion.v[1]
    v_z = motion.v[2]
    a_x = motion.a[0]
    a_y = motion.a[1]
    a_z = motion.a[2]
    B_xx = shared.B[0]
    B_xy = shared.B[1]
    B_xz = shared.B[2]
    B_yx = shared.B[3]
    B_yy = shared.B[4]
    B_yz = shared.B[5]
    B_zx = shared.B[6]
    B_zy = shared.B[7]
    B_zz = shared.B[8]
    g_x = platform.g[0]
    g_y = platform.g[1]
    g_z = platform.g[2]
    # (1) platform point from the reference point
    q_x = R_xx * p_x + R_xy * p_y + R_xz * p_z
    q_y = R_yx * p_x + R_yy * p_y + R_yz * p_z
    q_z = R_zx * p_x + R_zy * p_y + R_zz * p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = q_x + t_b_x
    S_y = q_y + t_b_y
    S_z = q_z + t_b_z
    # (10) leg vector along the fixed axis, and normal to both
    zeta = S_x * k_x + S_y * k_y + S_z * k_z
    k_cross_S_x = S_z * k_y - S_y * k_z
    k_cross_S_y = S_x * k_z - S_z * k_x
    k_cross_S_z = S_y * k_x - S_x * k_y
    # (2) leg length, and distance of its tip from the fixed axis
    L = on.sqrt(S_x * S_x + S_y * S_y + S_z * S_z)
    inv_L = 1.0 / L
    # (3) unit vector along the leg
    s_x = S_x * inv_L
    s_y = S_y * inv_L
    s_z = S_z * inv_L
    # (10) along the third axis of the leg
    s_cross_normal_x = k_cross_S_z * s_y - k_cross_S_y * s_z
    s_cross_normal_y = k_cross_S_x * s_z - k_cross_S_z * s_x
    s_cross_normal_z = k_cross_S_y * s_x - k_cross_S_x * s_y
    # (10) leg length, and distance of its tip from the fixed axis
    rho = (
        on.sqrt(s_cross_normal_x * s_cross_normal_x + s_cross_normal_y * s_cross_normal_y + s_cross_normal_z
            * s_cross_normal_z)
    )
    inv_rho = 1.0 / rho
    # (10) third axis of the leg frame
    z_x = inv_rho * s_cross_normal_x
    z_y = inv_rho * s_cross_normal_y
    z_z = inv_rho * s_cross_normal_z
    # (10) rotating axis of the universal joint
    y_x = s_z * z_y - s_y * z_z
    y_y = s_x * z_z - s_z * z_x
    y_z = s_y * z_x - s_x * z_y
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = inv_L * zeta
    k3 = inv_L * rho
    # (10) k1 / k3
    kappa = inv_rho * zeta
    # (4) velocity of the platform point
    S_dot_x = omega_y * q_z + v_x - omega_z * q_y
    S_dot_y = omega_z * q_x + v_y - omega_x * q_z
    S_dot_z = omega_x * q_y + v_z - omega_y * q_x
    # (7) acceleration of the platform point
    S_ddot_x = B_xx * q_x + B_xy * q_y + B_xz * q_z + a_x
    S_ddot_y = B_yx * q_x + B_yy * q_y + B_yz * q_z + a_y
    S_ddot_z = B_zx * q_x + B_zy * q_y + B_zz * q_z + a_z
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x * s_x + S_dot_y * s_y + S_dot_z * s_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = inv_rho * (S_dot_x * y_x + S_dot_y * y_y + S_dot_z * y_z)
    theta_dot = -inv_L * (S_dot_x * z_x + S_dot_y * z_y + S_dot_z * z_z)
    # L_dot / L
    L_share = L_dot * inv_L
    lean = kappa * theta_dot
    theta_dot2 = theta_dot * theta_dot
    phi_dot2 = phi_dot * phi_dot
    two_phi_dot = 2.0 * phi_dot
    k33 = k3 * k3
    # (8) accelerations of the joint coordinates
    L_ddot = L * (k33 * phi_dot2 + theta_dot2) + S_ddot_x * s_x + S_ddot_y * s_y + S_ddot_z * s_z
    # (9) accelerations of the joint coordinates but for the turning of the leg frame about s
    own_theta_ddot = -2.0 * L_share * theta_dot - inv_L * (S_ddot_x * z_x + S_ddot_y * z_y + S_ddot_z * z_z)
    own_phi_ddot = inv_rho * (S_ddot_x * y_x + S_ddot_y * y_y + S_ddot_z * y_z) - L_share * two_phi_dot
    c1 = k1 * k3
    # (9) accelerations of the joint coordinates
    theta_ddot = c1 * phi_dot2 + own_theta_ddot
    phi_ddot = own_phi_ddot - lean * two_phi_dot
    k13 = c1
    L_h2 = L * h2_x
    a1 = L_h2 + dJ_zx
    c2 = L * h2_z
    c3 = J2_xz - c2
    a2 = c3
    a3 = J_xy - L * h_y
    # (19) inertia of the joint coordinates
    M_phi = J_xx + a1 * k33 + a2 * k13
    M_theta = J_yy + L_h2
    M_mixed = J_yz * k3 + a3 * k1
    k3_h = h_y * k3
    # (19) slopes of M_phi / 2 along theta and L, of M_mixed along theta
    M_phi_L = h_x * k33 - h_z * k13
    M_mixed_theta = J_yz * k1 - a3 * k3
    bend = L_dot * theta_dot
    # gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # first moment along k and against k x y
    w_k = k1 * w_x + k3 * w_z
    w_n = k3 * w_x - k1 * w_z
    # (20) generalised forces about y and about k
    tau_y = (
        C_us * theta_dot + L_ddot * h_z + M_mixed * phi_ddot + M_theta * own_theta_ddot + bend * h2_x + g_k
            * w_n + gamma_n * w_k + phi_dot2 * (k13 * (J_yy - dJ_zx) - c3 * (0.5 - k33)) - C_s * (omega_x * y_x
            + omega_y * y_y + omega_z * y_z)
    )
    tau_k = (
        C_us * phi_dot + M_mixed * theta_ddot + M_mixed_theta * theta_dot2 + M_phi * own_phi_ddot + two_phi_dot
            * (L_dot * M_phi_L - theta_dot * (0.5 * J2_xz + J_xx * kappa - 0.5 * c2)) - C_s * (k_x * omega_x
            + k_y * omega_y + k_z * omega_z) - L_ddot * k3_h - bend * h2_y * k1 - gamma_n * w_y - gamma_y * w_n
    )
    # (21) K = Q_y y + Q_z z
    Q_y = inv_rho * tau_k
    Q_z = -inv_L * tau_y
    # (21) force at the spherical joint, base frame
    K_x = Q_y * y_x + Q_z * z_x
    K_y = Q_y * y_y + Q_z * z_y
    K_z = Q_y * y_z + Q_z * z_z
    # (24) known part of the actuator force, to match
    D = C_p * L_dot + h_z * theta_ddot - M_phi_L * phi_dot2 - h_x * theta_dot2 - k3_h * phi_ddot
    c4 = C_s * phi_dot
    c5 = C_s * theta_dot
    out = LegTerms()
    out.q[0] = q_x
    out.q[1] = q_y
    out.q[2] = q_z
    out.L = L
    out.k3 = k3
    out.D = D
    out.H_force[0] = s_x
    out.H_force[1] = s_y
    out.H_force[2] = s_z
    out.c_force[0] = -K_x
    out.c_force[1] = -K_y
    out.c_force[2] = -K_z
    out.c_moment[0] = c4 * k_x + c5 * y_x
    out.c_moment[1] = c4 * k_y + c5 * y_y
    out.c_moment[2] = c4 * k_z + c5 * y_z
    return out


def shift(on: Arithmetic, sums: Any, shared: Any) -> Any:
    """The platform's part of c: 12 (6 mul, 6 add, 0 div, 0 sqrt)."""
    q_1_x = sums.q_1[0]
    q_1_y = sums.q_1[1]
    q_1_z = sums.q_1[2]
    c_force_x = shared.c_force[0]
    c_force_y = shared.c_force[1]
    c_force_z = shared.c_force[2]
    c_moment_x = shared.c_moment[0]
    c_moment_y = shared.c_moment[1]
    c_moment_z = shared.c_moment[2]
    out = ShiftTerms()
    out.c_tip[0] = c_force_y * q_1_z + c_moment_x - c_force_z * q_1_y
    out.c_tip[1] = c_force_z * q_1_x + c_moment_y - c_force_x * q_1_z
    out.c_tip[2] = c_force_x * q_1_y + c_moment_z - c_force_y * q_1_x
    return out


def moments_of(on: Arithmetic, leg: Any, sums: Any) -> Any:
    """Moments of one leg: 21 (12 mul, 9 add, 0 div, 0 sqrt)."""
    q_x = leg.q[0]
    q_y = leg.q[1]
    q_z = leg.q[2]
    q_1_x = sums.q_1[0]
    q_1_y = sums.q_1[1]
    q_1_z = sums.q_1[2]
    H_force_x = leg.H_force[0]
    H_force_y = leg.H_force[1]
    H_force_z = leg.H_force[2]
    c_force_x = leg.c_force[0]
    c_force_y = leg.c_force[1]
    c_force_z = leg.c_force[2]
    # platform point from platform point 1
    arm_x = q_x - q_1_x
    arm_y = q_y - q_1_y
    arm_z = q_z - q_1_z
    out = MomentTerms()
    out.H_moment[0] = H_force_z * arm_y - H_force_y * arm_z
    out.H_moment[1] = H_force_x * arm_z - H_force_z * arm_x
    out.H_moment[2] = H_force_y * arm_x - H_force_x * arm_y
    out.arm_c[0] = arm_y * c_force_z - arm_z * c_force_y
    out.arm_c[1] = arm_z * c_force_x - arm_x * c_force_z
    out.arm_c[2] = arm_x * c_force_y - arm_y * c_force_x
    return out


def equations_pose(on: Arithmetic, platform: Any, motion: Any) -> Any:
    """The platform's part of M, C, g and friction: 152 (93 mul, 59 add, 0 div, 0 sqrt)."""
    R_xx = motion.R[0]
    R_xy = motion.R[1]
    R_xz = motion.R[2]
    R_yx = motion.R[3]
    R_yy = motion.R[4]
    R_yz = motion.R[5]
    R_zx = motion.R[6]
    R_zy = motion.R[7]
    R_zz = motion.R[8]
    omega_x = motion.omega[0]
    omega_y = motion.omega[1]
    omega_z = motion.omega[2]
    M_P = platform.M_P
    h_P_x = platform.h_P[0]
    h_P_y = platform.h_P[1]
    h_P_z = platform.h_P[2]
    J_P_xx = platform.J_P[0]
    J_P_xy = platform.J_P[1]
    J_P_xz = platform.J_P[2]
    J_P_yy = platform.J_P[3]
    J_P_yz = platform.J_P[4]
    J_P_zz = platform.J_P[5]
    C_P = platform.C_P
    g_x = platform.g[0]
    g_y = platform.g[1]
    g_z = platform.g[2]
    # (30) first moment of the platform, base frame
    h_base_x = R_xx * h_P_x + R_xy * h_P_y + R_xz * h_P_z
    h_base_y = R_yx * h_P_x + R_yy * h_P_y + R_yz * h_P_z
    h_base_z = R_zx * h_P_x + R_zy * h_P_y + R_zz * h_P_z
    c1 = J_P_xx * R_xx + J_P_xy * R_xy + J_P_xz * R_xz
    c2 = J_P_xy * R_xx + J_P_yy * R_xy + J_P_yz * R_xz
    c3 = J_P_xz * R_xx + J_P_yz * R_xy + J_P_zz * R_xz
    c4 = J_P_xx * R_yx + J_P_xy * R_yy + J_P_xz * R_yz
    c5 = J_P_xy * R_yx + J_P_yy * R_yy + J_P_yz * R_yz
    c6 = J_P_xz * R_yx + J_P_yz * R_yy + J_P_zz * R_yz
    # (32) inertia of the platform, base frame
    J_base_xx = R_xx * c1 + R_xy * c2 + R_xz * c3
    J_base_xy = R_yx * c1 + R_yy * c2 + R_yz * c3
    J_base_xz = R_zx * c1 + R_zy * c2 + R_zz * c3
    J_base_yy = R_yx * c4 + R_yy * c5 + R_yz * c6
    J_base_yz = R_zx * c4 + R_zy * c5 + R_zz * c6
    J_base_zz = (
        R_zx * (J_P_xx * R_zx + J_P_xy * R_zy + J_P_xz * R_zz) + R_zy * (J_P_xy * R_zx + J_P_yy * R_zy + J_P_yz
            * R_zz) + R_zz * (J_P_xz * R_zx + J_P_yz * R_zy + J_P_zz * R_zz)
    )
    # (31) omega x h
    w_h_x = h_base_z * omega_y - h_base_y * omega_z
    w_h_y = h_base_x * omega_z - h_base_z * omega_x
    w_h_z = h_base_y * omega_x - h_base_x * omega_y
    half_trace = 0.5 * J_base_xx + 0.5 * J_base_yy + 0.5 * J_base_zz
    c7 = J_base_xy * omega_z
    c8 = J_base_xz * omega_y
    c9 = half_trace * omega_z
    c10 = half_trace * omega_y
    c11 = -J_base_yz * omega_x
    c12 = half_trace * omega_x
    out = EquationsPose()
    out.M_vv[0] = M_P
    out.M_vv[1] = 0.0
    out.M_vv[2] = 0.0
    out.M_vv[3] = M_P
    out.M_vv[4] = 0.0
    out.M_vv[5] = M_P
    out.M_vw[0] = 0.0
    out.M_vw[1] = h_base_z
    out.M_vw[2] = -h_base_y
    out.M_vw[3] = -h_base_z
    out.M_vw[4] = 0.0
    out.M_vw[5] = h_base_x
    out.M_vw[6] = h_base_y
    out.M_vw[7] = -h_base_x
    out.M_vw[8] = 0.0
    out.M_ww[0] = J_base_xx
    out.M_ww[1] = J_base_xy
    out.M_ww[2] = J_base_xz
    out.M_ww[3] = J_base_yy
    out.M_ww[4] = J_base_yz
    out.M_ww[5] = J_base_zz
    out.C_vv[0] = 0.0
    out.C_vv[1] = 0.0
    out.C_vv[2] = 0.0
    out.C_vv[3] = 0.0
    out.C_vv[4] = 0.0
    out.C_vv[5] = 0.0
    out.C_vv[6] = 0.0
    out.C_vv[7] = 0.0
    out.C_vv[8] = 0.0
    out.C_vw[0] = 0.0
    out.C_vw[1] = w_h_z
    out.C_vw[2] = -w_h_y
    out.C_vw[3] = -w_h_z
    out.C_vw[4] = 0.0
    out.C_vw[5] = w_h_x
    out.C_vw[6] = w_h_y
    out.C_vw[7] = -w_h_x
    out.C_vw[8] = 0.0
    out.C_wv[0] = 0.0
    out.C_wv[1] = 0.0
    out.C_wv[2] = 0.0
    out.C_wv[3] = 0.0
    out.C_wv[4] = 0.0
    out.C_wv[5] = 0.0
    out.C_wv[6] = 0.0
    out.C_wv[7] = 0.0
    out.C_wv[8] = 0.0
    out.C_ww[0] = c8 - c7
    out.C_ww[1] = J_base_yz * omega_y + c9 - J_base_yy * omega_z
    out.C_ww[2] = J_base_zz * omega_y - J_base_yz * omega_z - c10
    out.C_ww[3] = J_base_xx * omega_z - J_base_xz * omega_x - c9
    out.C_ww[4] = c11 + c7
    out.C_ww[5] = J_base_xz * omega_z + c12 - J_base_zz * omega_x
    out.C_ww[6] = J_base_xy * omega_x + c10 - J_base_xx * omega_y
    out.C_ww[7] = J_base_yy * omega_x - J_base_xy * omega_y - c12
    out.C_ww[8] = -c11 - c8
    out.g_force[0] = -M_P * g_x
    out.g_force[1] = -M_P * g_y
    out.g_force[2] = -M_P * g_z
    out.g_moment[0] = g_y * h_base_z - g_z * h_base_y
    out.g_moment[1] = g_z * h_base_x - g_x * h_base_z
    out.g_moment[2] = g_x * h_base_y - g_y * h_base_x
    out.friction_force[0] = 0.0
    out.friction_force[1] = 0.0
    out.friction_force[2] = 0.0
    out.friction_moment[0] = C_P * omega_x
    out.friction_moment[1] = C_P * omega_y
    out.friction_moment[2] = C_P * omega_z
    return out


def equations_leg(on: Arithmetic, leg: Any, platform: Any, motion: Any) -> Any:
    """One leg's part of M, C, g and friction, its column of H and the column's rate: 678 (422 mul, 252 add, 2 div, 2 sqrt)."""
    b_x = leg.b[0]
    b_y = leg.b[1]
    b_z = leg.b[2]
    p_x = leg.p[0]
    p_y = leg.p[1]
    p_z = leg.p[2]
    k_x = leg.k[0]
    k_y = leg.k[1]
    k_z = leg.k[2]
    C_p = leg.C_p
    C_s = leg.C_s
    h_x = leg.h[0]
    h_y = leg.h[1]
    h_z = leg.h[2]
    h2_x = leg.h2_x
    h2_z = leg.h2_z
    w_x = leg.w[0]
    w_y = leg.w[1]
    w_z = leg.w[2]
    J_xx = leg.J[0]
    J_xy = leg.J[1]
    J_xz = leg.J[2]
    J_yy = leg.J[3]
    J_yz = leg.J[4]
    J_zz = leg.J[5]
    J2_xz = leg.J2_xz
    dJ_zx = leg.dJ_zx
    g_k = leg.g_k
    g_x_k_x = leg.g_x_k[0]
    g_x_k_y = leg.g_x_k[1]
    g_x_k_z = leg.g_x_k[2]
    C_us = leg.C_us
    R_xx = motion.R[0]
    R_xy = motion.R[1]
    R_xz = motion.R[2]
    R_yx = motion.R[3]
    R_yy = motion.R[4]
    R_yz = motion.R[5]
    R_zx = motion.R[6]
    R_zy = motion.R[7]
    R_zz = motion.R[8]
    t_x = motion.t[0]
    t_y = motion.t[1]
    t_z = motion.t[2]
    omega_x = motion.omega[0]
    omega_y = motion.omega[1]
    omega_z = motion.omega[2]
    v_x = motion.v[0]
    v_y = motion.v[1]
    v_z = motion.v[2]
    g_x = platform.g[0]
    g_y = platform.g[1]
    g_z = platform.g[2]
    # (1) platform point from the reference point
    q_x = R_xx * p_x + R_xy * p_y + R_xz * p_z
    q_y = R_yx * p_x + R_yy * p_y + R_yz * p_z
    q_z = R_zx * p_x + R_zy * p_y + R_zz * p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = q_x + t_b_x
    S_y = q_y + t_b_y
    S_z = q_z + t_b_z
    # (10) leg vector along the fixed axis, and normal to both
    zeta = S_x * k_x + S_y * k_y + S_z * k_z
    k_cross_S_x = S_z * k_y - S_y * k_z
    k_cross_S_y = S_x * k_z - S_z * k_x
    k_cross_S_z = S_y * k_x - S_x * k_y
    # (2) leg length, and distance of its tip from the fixed axis
    L = on.sqrt(S_x * S_x + S_y * S_y + S_z * S_z)
    inv_L = 1.0 / L
    # (3) unit vector along the leg
    s_x = S_x * inv_L
    s_y = S_y * inv_L
    s_z = S_z * inv_L
    # (10) along the third axis of the leg
    s_cross_normal_x = k_cross_S_z * s_y - k_cross_S_y * s_z
    s_cross_normal_y = k_cross_S_x * s_z - k_cross_S_z * s_x
    s_cross_normal_z = k_cross_S_y * s_x - k_cross_S_x * s_y
    # (10) leg length, and distance of its tip from the fixed axis
    rho = (
        on.sqrt(s_cross_normal_x * s_cross_normal_x + s_cross_normal_y * s_cross_normal_y + s_cross_normal_z
            * s_cross_normal_z)
    )
    inv_rho = 1.0 / rho
    # (10) third axis of the leg frame
    z_x = inv_rho * s_cross_normal_x
    z_y = inv_rho * s_cross_normal_y
    z_z = inv_rho * s_cross_normal_z
    # (10) rotating axis of the universal joint
    y_x = s_z * z_y - s_y * z_z
    y_y = s_x * z_z - s_z * z_x
    y_z = s_y * z_x - s_x * z_y
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = inv_L * zeta
    k3 = inv_L * rho
    # (10) k1 / k3
    kappa = inv_rho * zeta
    # (4) omega x q
    w_q_x = omega_y * q_z - omega_z * q_y
    w_q_y = omega_z * q_x - omega_x * q_z
    w_q_z = omega_x * q_y - omega_y * q_x
    # (4) velocity of the platform point
    S_dot_x = v_x + w_q_x
    S_dot_y = v_y + w_q_y
    S_dot_z = v_z + w_q_z
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x * s_x + S_dot_y * s_y + S_dot_z * s_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = inv_rho * (S_dot_x * y_x + S_dot_y * y_y + S_dot_z * y_z)
    theta_dot = -inv_L * (S_dot_x * z_x + S_dot_y * z_y + S_dot_z * z_z)
    c1 = k3 * k3
    k33 = c1
    k13 = k1 * k3
    L_h2 = L * h2_x
    a1 = L_h2 + dJ_zx
    a2 = J2_xz - L * h2_z
    c2 = J_xy - L * h_y
    a3 = c2
    # (19) inertia of the joint coordinates
    M_phi = J_xx + a1 * k33 + a2 * k13
    M_theta = J_yy + L_h2
    M_mixed = J_yz * k3 + a3 * k1
    k3_h = h_y * k3
    c3 = inv_L * inv_rho
    c4 = inv_L * inv_L
    # inertia at the tip, leg frame
    m_leg_sy = -inv_rho * k3_h
    m_leg_sz = -h_z * inv_L
    m_leg_yy = M_phi * inv_rho * inv_rho
    m_leg_yz = -M_mixed * c3
    m_leg_zz = M_theta * c4
    m_T_xs = m_leg_sy * y_x + m_leg_sz * z_x
    m_T_xy = m_leg_sy * s_x + m_leg_yy * y_x + m_leg_yz * z_x
    m_T_xz = m_leg_sz * s_x + m_leg_yz * y_x + m_leg_zz * z_x
    m_T_ys = m_leg_sy * y_y + m_leg_sz * z_y
    m_T_yy = m_leg_sy * s_y + m_leg_yy * y_y + m_leg_yz * z_y
    m_T_yz = m_leg_sz * s_y + m_leg_yz * y_y + m_leg_zz * z_y
    m_T_zs = m_leg_sy * y_z + m_leg_sz * z_z
    m_T_zy = m_leg_sy * s_z + m_leg_yy * y_z + m_leg_yz * z_z
    m_T_zz = m_leg_sz * s_z + m_leg_yz * y_z + m_leg_zz * z_z
    # inertia at the tip, base frame
    m_xx = m_T_xs * s_x + m_T_xy * y_x + m_T_xz * z_x
    m_xy = m_T_xs * s_y + m_T_xy * y_y + m_T_xz * z_y
    m_xz = m_T_xs * s_z + m_T_xy * y_z + m_T_xz * z_z
    m_yy = m_T_ys * s_y + m_T_yy * y_y + m_T_yz * z_y
    m_yz = m_T_ys * s_z + m_T_yy * y_z + m_T_yz * z_z
    m_zz = m_T_zs * s_z + m_T_zy * y_z + m_T_zz * z_z
    c5 = h_x * theta_dot
    C_xi_12 = -c5
    c6 = c1 * h_x - h_z * k1 * k3
    C_xi_13 = -c6 * phi_dot
    C_xi_21 = c5
    C_xi_22 = L_dot * h_x
    c7 = 2.0 * L
    c8 = 2.0 * J_xz - c7 * h_z
    c9 = 0.5 * k1 * (c8 * k1 + 2.0 * k3 * (J_zz + c7 * h_x - J_xx)) - 0.5 * c1 * c8
    C_xi_23 = -c9 * phi_dot
    c10 = h_y * k1
    C_xi_31 = c6 * phi_dot - c10 * theta_dot
    C_xi_32 = c9 * phi_dot + theta_dot * (J_yz * k1 - c2 * k3) - L_dot * c10
    C_xi_33 = L_dot * c6 + c9 * theta_dot
    c11 = k3 * phi_dot
    G_dot_12 = c11
    G_dot_21 = -inv_L * theta_dot
    c12 = k1 * phi_dot
    G_dot_22 = c12 * inv_L
    G_dot_23 = L_dot * c4
    G_dot_31 = -c11 * inv_rho
    G_dot_32 = -L_dot * c3 - inv_rho * kappa * theta_dot
    G_dot_33 = c12 * inv_rho
    C_leg_11 = G_dot_21 * h_z - G_dot_31 * k3_h
    C_leg_12 = C_xi_13 * inv_rho + G_dot_22 * h_z - G_dot_32 * k3_h
    C_leg_13 = G_dot_23 * h_z - C_xi_12 * inv_L - G_dot_33 * k3_h
    C_leg_21 = inv_rho * (C_xi_31 + G_dot_21 * M_mixed + G_dot_31 * M_phi)
    C_leg_22 = inv_rho * (C_xi_33 * inv_rho + G_dot_22 * M_mixed + G_dot_32 * M_phi - G_dot_12 * k3_h)
    C_leg_23 = inv_rho * (G_dot_23 * M_mixed + G_dot_33 * M_phi + k3_h * theta_dot - C_xi_32 * inv_L)
    C_leg_31 = -inv_L * (C_xi_21 + G_dot_21 * M_theta + G_dot_31 * M_mixed)
    C_leg_32 = -inv_L * (C_xi_23 * inv_rho + G_dot_12 * h_z + G_dot_22 * M_theta + G_dot_32 * M_mixed)
    C_leg_33 = -inv_L * (G_dot_23 * M_theta + G_dot_33 * M_mixed - C_xi_22 * inv_L - h_z * theta_dot)
    C_tip_T_xs = C_leg_11 * s_x + C_leg_21 * y_x + C_leg_31 * z_x
    C_tip_T_xy = C_leg_12 * s_x + C_leg_22 * y_x + C_leg_32 * z_x
    C_tip_T_xz = C_leg_13 * s_x + C_leg_23 * y_x + C_leg_33 * z_x
    C_tip_T_ys = C_leg_11 * s_y + C_leg_21 * y_y + C_leg_31 * z_y
    C_tip_T_yy = C_leg_12 * s_y + C_leg_22 * y_y + C_leg_32 * z_y
    C_tip_T_yz = C_leg_13 * s_y + C_leg_23 * y_y + C_leg_33 * z_y
    C_tip_T_zs = C_leg_11 * s_z + C_leg_21 * y_z + C_leg_31 * z_z
    C_tip_T_zy = C_leg_12 * s_z + C_leg_22 * y_z + C_leg_32 * z_z
    C_tip_T_zz = C_leg_13 * s_z + C_leg_23 * y_z + C_leg_33 * z_z
    # Coriolis matrix at the tip, base frame
    C_tip_xx = C_tip_T_xs * s_x + C_tip_T_xy * y_x + C_tip_T_xz * z_x
    C_tip_xy = C_tip_T_xs * s_y + C_tip_T_xy * y_y + C_tip_T_xz * z_y
    C_tip_xz = C_tip_T_xs * s_z + C_tip_T_xy * y_z + C_tip_T_xz * z_z
    C_tip_yx = C_tip_T_ys * s_x + C_tip_T_yy * y_x + C_tip_T_yz * z_x
    C_tip_yy = C_tip_T_ys * s_y + C_tip_T_yy * y_y + C_tip_T_yz * z_y
    C_tip_yz = C_tip_T_ys * s_z + C_tip_T_yy * y_z + C_tip_T_yz * z_z
    C_tip_zx = C_tip_T_zs * s_x + C_tip_T_zy * y_x + C_tip_T_zz * z_x
    C_tip_zy = C_tip_T_zs * s_y + C_tip_T_zy * y_y + C_tip_T_zz * z_y
    C_tip_zz = C_tip_T_zs * s_z + C_tip_T_zy * y_z + C_tip_T_zz * z_z
    c13 = C_tip_xy * q_z
    c14 = m_xy * w_q_z
    c15 = C_tip_xz * q_y
    c16 = m_xz * w_q_y
    C_q_xx = c15 + c16 - c13 - c14
    c17 = C_tip_xx * q_z
    C_q_xy = c17 + m_xx * w_q_z - C_tip_xz * q_x - m_xz * w_q_x
    c18 = C_tip_xx * q_y
    C_q_xz = C_tip_xy * q_x + m_xy * w_q_x - c18 - m_xx * w_q_y
    c19 = C_tip_yy * q_z
    C_q_yx = C_tip_yz * q_y + m_yz * w_q_y - c19 - m_yy * w_q_z
    c20 = C_tip_yx * q_z
    c21 = -C_tip_yz * q_x
    c22 = -m_yz * w_q_x
    C_q_yy = c14 + c20 + c21 + c22
    c23 = -C_tip_yy * q_x
    C_q_yz = m_yy * w_q_x - C_tip_yx * q_y - c23 - m_xy * w_q_y
    c24 = -C_tip_zz * q_y
    C_q_zx = m_zz * w_q_y - C_tip_zy * q_z - c24 - m_yz * w_q_z
    c25 = -C_tip_zz * q_x
    C_q_zy = C_tip_zx * q_z + c25 + m_xz * w_q_z - m_zz * w_q_x
    c26 = C_tip_zx * q_y
    c27 = -C_tip_zy * q_x
    C_q_zz = -c16 - c22 - c26 - c27
    # gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # first moment along k and against k x y
    w_k = k1 * w_x + k3 * w_z
    w_n = k3 * w_x - k1 * w_z
    c28 = inv_L * (g_k * w_n + gamma_n * w_k)
    c29 = -gamma_n * w_y - gamma_y * w_n
    # against gravity
    held_x = c29 * inv_rho * y_x - c28 * z_x
    held_y = c29 * inv_rho * y_y - c28 * z_y
    held_z = c29 * inv_rho * y_z - c28 * z_z
    c30 = L_dot * s_x
    c31 = inv_rho * (C_us * phi_dot - C_s * (k_x * omega_x + k_y * omega_y + k_z * omega_z))
    c32 = inv_L * (C_us * theta_dot - C_s * (omega_x * y_x + omega_y * y_y + omega_z * y_z))
    c33 = L_dot * s_y
    c34 = L_dot * s_z
    # against friction
    rubbed_x = C_p * c30 + c31 * y_x - c32 * z_x
    rubbed_y = C_p * c33 + c31 * y_y - c32 * z_y
    rubbed_z = C_p * c34 + c31 * y_z - c32 * z_z
    # (3) rate of s
    s_dot_x = inv_L * (S_dot_x - c30)
    s_dot_y = inv_L * (S_dot_y - c33)
    s_dot_z = inv_L * (S_dot_z - c34)
    c35 = m_xy * q_z
    c36 = m_xz * q_y
    c37 = -m_yz * q_x
    # m [q]x
    m_q_xx = c35 - c36
    m_q_xy = m_xz * q_x - m_xx * q_z
    m_q_xz = m_xx * q_y - m_xy * q_x
    m_q_yx = m_yy * q_z - m_yz * q_y
    m_q_yy = -c35 - c37
    m_q_yz = m_xy * q_y - m_yy * q_x
    m_q_zx = m_yz * q_z - m_zz * q_y
    m_q_zy = m_zz * q_x - m_xz * q_z
    m_q_zz = c36 + c37
    out = EquationsLeg()
    out.M_vv[0] = m_xx
    out.M_vv[1] = m_xy
    out.M_vv[2] = m_xz
    out.M_vv[3] = m_yy
    out.M_vv[4] = m_yz
    out.M_vv[5] = m_zz
    out.M_vw[0] = -m_q_xx
    out.M_vw[1] = -m_q_xy
    out.M_vw[2] = -m_q_xz
    out.M_vw[3] = -m_q_yx
    out.M_vw[4] = -m_q_yy
    out.M_vw[5] = -m_q_yz
    out.M_vw[6] = -m_q_zx
    out.M_vw[7] = -m_q_zy
    out.M_vw[8] = -m_q_zz
    out.M_ww[0] = m_q_yx * q_z - m_q_zx * q_y
    out.M_ww[1] = m_q_yy * q_z - m_q_zy * q_y
    out.M_ww[2] = m_q_yz * q_z - m_q_zz * q_y
    out.M_ww[3] = m_q_zy * q_x - m_q_xy * q_z
    out.M_ww[4] = m_q_zz * q_x - m_q_xz * q_z
    out.M_ww[5] = m_q_xz * q_y - m_q_yz * q_x
    out.C_vv[0] = C_tip_xx
    out.C_vv[1] = C_tip_xy
    out.C_vv[2] = C_tip_xz
    out.C_vv[3] = C_tip_yx
    out.C_vv[4] = C_tip_yy
    out.C_vv[5] = C_tip_yz
    out.C_vv[6] = C_tip_zx
    out.C_vv[7] = C_tip_zy
    out.C_vv[8] = C_tip_zz
    out.C_vw[0] = C_q_xx
    out.C_vw[1] = C_q_xy
    out.C_vw[2] = C_q_xz
    out.C_vw[3] = C_q_yx
    out.C_vw[4] = C_q_yy
    out.C_vw[5] = C_q_yz
    out.C_vw[6] = C_q_zx
    out.C_vw[7] = C_q_zy
    out.C_vw[8] = C_q_zz
    out.C_wv[0] = c26 - c20
    out.C_wv[1] = C_tip_zy * q_y - c19
    out.C_wv[2] = -C_tip_yz * q_z - c24
    out.C_wv[3] = c17 - C_tip_zx * q_x
    out.C_wv[4] = c13 + c27
    out.C_wv[5] = C_tip_xz * q_z + c25
    out.C_wv[6] = C_tip_yx * q_x - c18
    out.C_wv[7] = -C_tip_xy * q_y - c23
    out.C_wv[8] = -c15 - c21
    out.C_ww[0] = C_q_zx * q_y - C_q_yx * q_z
    out.C_ww[1] = C_q_zy * q_y - C_q_yy * q_z
    out.C_ww[2] = C_q_zz * q_y - C_q_yz * q_z
    out.C_ww[3] = C_q_xx * q_z - C_q_zx * q_x
    out.C_ww[4] = C_q_xy * q_z - C_q_zy * q_x
    out.C_ww[5] = C_q_xz * q_z - C_q_zz * q_x
    out.C_ww[6] = C_q_yx * q_x - C_q_xx * q_y
    out.C_ww[7] = C_q_yy * q_x - C_q_xy * q_y
    out.C_ww[8] = C_q_yz * q_x - C_q_xz * q_y
    out.g_force[0] = held_x
    out.g_force[1] = held_y
    out.g_force[2] = held_z
    out.g_moment[0] = held_z * q_y - held_y * q_z
    out.g_moment[1] = held_x * q_z - held_z * q_x
    out.g_moment[2] = held_y * q_x - held_x * q_y
    out.friction_force[0] = rubbed_x
    out.friction_force[1] = rubbed_y
    out.friction_force[2] = rubbed_z
    out.friction_moment[0] = q_y * rubbed_z - C_s * (k_x * phi_dot + theta_dot * y_x) - q_z * rubbed_y
    out.friction_moment[1] = q_z * rubbed_x - C_s * (k_y * phi_dot + theta_dot * y_y) - q_x * rubbed_z
    out.friction_moment[2] = q_x * rubbed_y - C_s * (k_z * phi_dot + theta_dot * y_z) - q_y * rubbed_x
    out.H_force[0] = s_x
    out.H_force[1] = s_y
    out.H_force[2] = s_z
    out.H_moment[0] = q_y * s_z - q_z * s_y
    out.H_moment[1] = q_z * s_x - q_x * s_z
    out.H_moment[2] = q_x * s_y - q_y * s_x
    out.H_dot_force[0] = s_dot_x
    out.H_dot_force[1] = s_dot_y
    out.H_dot_force[2] = s_dot_z
    out.H_dot_moment[0] = q_y * s_dot_z + s_z * w_q_y - q_z * s_dot_y - s_y * w_q_z
    out.H_dot_moment[1] = q_z * s_dot_x + s_x * w_q_z - q_x * s_dot_z - s_z * w_q_x
    out.H_dot_moment[2] = q_x * s_dot_y + s_y * w_q_x - q_y * s_dot_x - s_x * w_q_y
    out.q[0] = q_x
    out.q[1] = q_y
    out.q[2] = q_z
    out.L = L
    out.k3 = k3
    return out


def equations_near(on: Arithmetic, leg: Any, platform: Any, motion: Any) -> Any:
    """One leg's part of M, C, g and friction, its column of H and the column's rate: 698 (426 mul, 268 add, 2 div, 2 sqrt)."""
    b_x = leg.b[0]
    b_y = leg.b[1]
    b_z = leg.b[2]
    p_x = leg.p[0]
    p_y = leg.p[1]
    p_z = leg.p[2]
    k_x = leg.k[0]
    k_y = leg.k[1]
    k_z = leg.k[2]
    C_p = leg.C_p
    C_s = leg.C_s
    h_x = leg.h[0]
    h_y = leg.h[1]
    h_z = leg.h[2]
    h2_x = leg.h2_x
    h2_z = leg.h2_z
    w_x = leg.w[0]
    w_y = leg.w[1]
    w_z = leg.w[2]
    J_xx = leg.J[0]
    J_xy = leg.J[1]
    J_xz = leg.J[2]
    J_yy = leg.J[3]
    J_yz = leg.J[4]
    J_zz = leg.J[5]
    J2_xz = leg.J2_xz
    dJ_zx = leg.dJ_zx
    g_k = leg.g_k
    g_x_k_x = leg.g_x_k[0]
    g_x_k_y = leg.g_x_k[1]
    g_x_k_z = leg.g_x_k[2]
    C_us = leg.C_us
    R_xx = motion.R[0]
    R_xy = motion.R[1]
    R_xz = motion.R[2]
    R_yx = motion.R[3]
    R_yy = motion.R[4]
    R_yz = motion.R[5]
    R_zx = motion.R[6]
    R_zy = motion.R[7]
    R_zz = motion.R[8]
    t_x = motion.t[0]
    t_y = motion.t[1]
    t_z = motion.t[2]
    omega_x = motion.omega[0]
    omega_y = motion.omega[1]
    omega_z = motion.omega[2]
    v_x = motion.v[0]
    v_y = motion.v[1]
    v_z = motion.v[2]
    g_x = platform.g[0]
    g_y = platform.g[1]
    g_z = platform.g[2]
    # (1) platform point from the reference point
    q_x = R_xx * p_x + R_xy * p_y + R_xz * p_z
    q_y = R_yx * p_x + R_yy * p_y + R_yz * p_z
    q_z = R_zx * p_x + R_zy * p_y + R_zz * p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = q_x + t_b_x
    S_y = q_y + t_b_y
    S_z = q_z + t_b_z
    # (10) leg vector along the fixed axis, and normal to both
    zeta = S_x * k_x + S_y * k_y + S_z * k_z
    k_cross_S_x = S_z * k_y - S_y * k_z
    k_cross_S_y = S_x * k_z - S_z * k_x
    k_cross_S_z = S_y * k_x - S_x * k_y
    # (2) leg length, and distance of its tip from the fixed axis
    L = on.sqrt(S_x * S_x + S_y * S_y + S_z * S_z)
    inv_L = 1.0 / L
    # (3) unit vector along the leg
    s_x = S_x * inv_L
    s_y = S_y * inv_L
    s_z = S_z * inv_L
    # (10) along the third axis of the leg
    s_cross_normal_x = k_cross_S_z * s_y - k_cross_S_y * s_z
    s_cross_normal_y = k_cross_S_x * s_z - k_cross_S_z * s_x
    s_cross_normal_z = k_cross_S_y * s_x - k_cross_S_x * s_y
    # (10) leg length, and distance of its tip from the fixed axis
    rho = (
        on.sqrt(s_cross_normal_x * s_cross_normal_x + s_cross_normal_y * s_cross_normal_y + s_cross_normal_z
            * s_cross_normal_z)
    )
    inv_rho = 1.0 / rho
    # (10) third axis of the leg frame
    z_x = inv_rho * s_cross_normal_x
    z_y = inv_rho * s_cross_normal_y
    z_z = inv_rho * s_cross_normal_z
    # (10) rotating axis of the universal joint
    y_x = s_z * z_y - s_y * z_z
    y_y = s_x * z_z - s_z * z_x
    y_z = s_y * z_x - s_x * z_y
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = inv_L * zeta
    k3 = inv_L * rho
    # (4) omega x q
    w_q_x = omega_y * q_z - omega_z * q_y
    w_q_y = omega_z * q_x - omega_x * q_z
    w_q_z = omega_x * q_y - omega_y * q_x
    # (4) velocity of the platform point
    S_dot_x = v_x + w_q_x
    S_dot_y = v_y + w_q_y
    S_dot_z = v_z + w_q_z
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x * s_x + S_dot_y * s_y + S_dot_z * s_z
    c1 = S_dot_x * y_x + S_dot_y * y_y + S_dot_z * y_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = c1 * inv_rho
    theta_dot = -inv_L * (S_dot_x * z_x + S_dot_y * z_y + S_dot_z * z_z)
    k33 = k3 * k3
    k13 = k1 * k3
    L_h2 = L * h2_x
    a1 = L_h2 + dJ_zx
    a2 = J2_xz - L * h2_z
    a3 = J_xy - L * h_y
    # (19) inertia of the joint coordinates
    M_phi = J_xx + a1 * k33 + a2 * k13
    M_theta = J_yy + L_h2
    M_mixed = J_yz * k3 + a3 * k1
    k3_h = h_y * k3
    c2 = h_z * inv_L
    c3 = inv_L * inv_L
    # inertia at the tip, leg frame
    m_leg_sy = -inv_rho * k3_h
    m_leg_sz = -c2
    m_leg_yy = M_phi * inv_rho * inv_rho
    m_leg_yz = -M_mixed * inv_L * inv_rho
    m_leg_zz = M_theta * c3
    m_T_xs = m_leg_sy * y_x + m_leg_sz * z_x
    m_T_xy = m_leg_sy * s_x + m_leg_yy * y_x + m_leg_yz * z_x
    m_T_xz = m_leg_sz * s_x + m_leg_yz * y_x + m_leg_zz * z_x
    m_T_ys = m_leg_sy * y_y + m_leg_sz * z_y
    m_T_yy = m_leg_sy * s_y + m_leg_yy * y_y + m_leg_yz * z_y
    m_T_yz = m_leg_sz * s_y + m_leg_yz * y_y + m_leg_zz * z_y
    m_T_zs = m_leg_sy * y_z + m_leg_sz * z_z
    m_T_zy = m_leg_sy * s_z + m_leg_yy * y_z + m_leg_yz * z_z
    m_T_zz = m_leg_sz * s_z + m_leg_yz * y_z + m_leg_zz * z_z
    # inertia at the tip, base frame
    m_xx = m_T_xs * s_x + m_T_xy * y_x + m_T_xz * z_x
    m_xy = m_T_xs * s_y + m_T_xy * y_y + m_T_xz * z_y
    m_xz = m_T_xs * s_z + m_T_xy * y_z + m_T_xz * z_z
    m_yy = m_T_ys * s_y + m_T_yy * y_y + m_T_yz * z_y
    m_yz = m_T_ys * s_z + m_T_yy * y_z + m_T_yz * z_z
    m_zz = m_T_zs * s_z + m_T_zy * y_z + m_T_zz * z_z
    inv_k3 = L * inv_rho
    # (6) leg's turning about z
    W_z = c1 * inv_L
    c4 = W_z * inv_L
    c5 = c4 * h_y
    c6 = c5 - c2 * theta_dot
    C_leg_11 = c6
    c7 = c4 * h_x
    c8 = L_dot * c3
    c9 = c8 * h_y
    c10 = inv_L * theta_dot
    c11 = c10 * h_y
    c12 = inv_k3 * k1
    c13 = W_z * c2
    C_leg_12 = c11 * c12 + 2.0 * c12 * c13 + c9 - c7
    c14 = c10 * h_x - c12 * c5
    C_leg_13 = c14 + c8 * h_z
    c15 = c3 * theta_dot
    c16 = J_yz * c15
    c17 = J_xy * c15
    c18 = W_z * c3
    c19 = inv_k3 * inv_k3
    c20 = J_xx * c19
    c21 = 2.0 * J_xz
    c22 = c18 * c21
    c23 = J_xx - J_zz
    C_leg_21 = (
        W_z * c23 * c3 + W_z * h_z * inv_L * inv_k3 * k1 - c12 * c17 - c12 * c22 - c16 - c18 * c20 - c7
    )
    c24 = J_xy * c18
    c25 = c8 * h_x
    c26 = c19 * c5
    c27 = inv_L * inv_L * inv_L
    c28 = L_dot * c27
    c29 = J_xz * c19
    c30 = c12 * c28
    c31 = J_yz * c18
    c32 = c12 * c31
    c33 = c19 * c24
    c34 = J_xx * k1 * inv_k3 * inv_k3 * inv_k3
    C_leg_22 = (
        L_dot * c23 * c27 + L_dot * c3 * h_z * inv_k3 * k1 + c19 * h_z * inv_L * theta_dot + c32 + c33 - c15
            * c29 - c15 * c34 - c20 * c28 - c21 * c30 - c24 - c25 - c26
    )
    c35 = c12 * c16
    c36 = J_xy * c30 + J_yz * c28 + c18 * c29 - c13 * c19
    C_leg_23 = c17 + c18 * c34 + c36 - c35
    C_leg_31 = J_yy * c15 + c12 * c24 + c14 + c31
    C_leg_32 = (
        c11 + c12 * c18 * (-J_yy - c23) + c13 + c17 * c19 + c35 + c36 - c11 * c19 - c12 * c9 - c17 - c22
    )
    C_leg_33 = c24 + c26 - J_yy * c28 - c25 - c32 - c33 - c6
    C_tip_T_xs = C_leg_11 * s_x + C_leg_21 * y_x + C_leg_31 * z_x
    C_tip_T_xy = C_leg_12 * s_x + C_leg_22 * y_x + C_leg_32 * z_x
    C_tip_T_xz = C_leg_13 * s_x + C_leg_23 * y_x + C_leg_33 * z_x
    C_tip_T_ys = C_leg_11 * s_y + C_leg_21 * y_y + C_leg_31 * z_y
    C_tip_T_yy = C_leg_12 * s_y + C_leg_22 * y_y + C_leg_32 * z_y
    C_tip_T_yz = C_leg_13 * s_y + C_leg_23 * y_y + C_leg_33 * z_y
    C_tip_T_zs = C_leg_11 * s_z + C_leg_21 * y_z + C_leg_31 * z_z
    C_tip_T_zy = C_leg_12 * s_z + C_leg_22 * y_z + C_leg_32 * z_z
    C_tip_T_zz = C_leg_13 * s_z + C_leg_23 * y_z + C_leg_33 * z_z
    # Coriolis matrix at the tip, base frame
    C_tip_xx = C_tip_T_xs * s_x + C_tip_T_xy * y_x + C_tip_T_xz * z_x
    C_tip_xy = C_tip_T_xs * s_y + C_tip_T_xy * y_y + C_tip_T_xz * z_y
    C_tip_xz = C_tip_T_xs * s_z + C_tip_T_xy * y_z + C_tip_T_xz * z_z
    C_tip_yx = C_tip_T_ys * s_x + C_tip_T_yy * y_x + C_tip_T_yz * z_x
    C_tip_yy = C_tip_T_ys * s_y + C_tip_T_yy * y_y + C_tip_T_yz * z_y
    C_tip_yz = C_tip_T_ys * s_z + C_tip_T_yy * y_z + C_tip_T_yz * z_z
    C_tip_zx = C_tip_T_zs * s_x + C_tip_T_zy * y_x + C_tip_T_zz * z_x
    C_tip_zy = C_tip_T_zs * s_y + C_tip_T_zy * y_y + C_tip_T_zz * z_y
    C_tip_zz = C_tip_T_zs * s_z + C_tip_T_zy * y_z + C_tip_T_zz * z_z
    c37 = C_tip_xy * q_z
    c38 = m_xy * w_q_z
    c39 = C_tip_xz * q_y
    c40 = m_xz * w_q_y
    C_q_xx = c39 + c40 - c37 - c38
    c41 = C_tip_xx * q_z
    C_q_xy = c41 + m_xx * w_q_z - C_tip_xz * q_x - m_xz * w_q_x
    c42 = C_tip_xx * q_y
    C_q_xz = C_tip_xy * q_x + m_xy * w_q_x - c42 - m_xx * w_q_y
    c43 = C_tip_yy * q_z
    C_q_yx = C_tip_yz * q_y + m_yz * w_q_y - c43 - m_yy * w_q_z
    c44 = C_tip_yx * q_z
    c45 = -C_tip_yz * q_x
    c46 = -m_yz * w_q_x
    C_q_yy = c38 + c44 + c45 + c46
    c47 = -C_tip_yy * q_x
    C_q_yz = m_yy * w_q_x - C_tip_yx * q_y - c47 - m_xy * w_q_y
    c48 = -C_tip_zz * q_y
    C_q_zx = m_zz * w_q_y - C_tip_zy * q_z - c48 - m_yz * w_q_z
    c49 = -C_tip_zz * q_x
    C_q_zy = C_tip_zx * q_z + c49 + m_xz * w_q_z - m_zz * w_q_x
    c50 = C_tip_zx * q_y
    c51 = -C_tip_zy * q_x
    C_q_zz = -c40 - c46 - c50 - c51
    # gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # first moment along k and against k x y
    w_k = k1 * w_x + k3 * w_z
    w_n = k3 * w_x - k1 * w_z
    c52 = inv_L * (g_k * w_n + gamma_n * w_k)
    c53 = -gamma_n * w_y - gamma_y * w_n
    # against gravity
    held_x = c53 * inv_rho * y_x - c52 * z_x
    held_y = c53 * inv_rho * y_y - c52 * z_y
    held_z = c53 * inv_rho * y_z - c52 * z_z
    c54 = L_dot * s_x
    c55 = inv_rho * (C_us * phi_dot - C_s * (k_x * omega_x + k_y * omega_y + k_z * omega_z))
    c56 = inv_L * (C_us * theta_dot - C_s * (omega_x * y_x + omega_y * y_y + omega_z * y_z))
    c57 = L_dot * s_y
    c58 = L_dot * s_z
    # against friction
    rubbed_x = C_p * c54 + c55 * y_x - c56 * z_x
    rubbed_y = C_p * c57 + c55 * y_y - c56 * z_y
    rubbed_z = C_p * c58 + c55 * y_z - c56 * z_z
    # (3) rate of s
    s_dot_x = inv_L * (S_dot_x - c54)
    s_dot_y = inv_L * (S_dot_y - c57)
    s_dot_z = inv_L * (S_dot_z - c58)
    c59 = m_xy * q_z
    c60 = m_xz * q_y
    c61 = -m_yz * q_x
    # m [q]x
    m_q_xx = c59 - c60
    m_q_xy = m_xz * q_x - m_xx * q_z
    m_q_xz = m_xx * q_y - m_xy * q_x
    m_q_yx = m_yy * q_z - m_yz * q_y
    m_q_yy = -c59 - c61
    m_q_yz = m_xy * q_y - m_yy * q_x
    m_q_zx = m_yz * q_z - m_zz * q_y
    m_q_zy = m_zz * q_x - m_xz * q_z
    m_q_zz = c60 + c61
    out = EquationsLeg()
    out.M_vv[0] = m_xx
    out.M_vv[1] = m_xy
    out.M_vv[2] = m_xz
    out.M_vv[3] = m_yy
    out.M_vv[4] = m_yz
    out.M_vv[5] = m_zz
    out.M_vw[0] = -m_q_xx
    out.M_vw[1] = -m_q_xy
    out.M_vw[2] = -m_q_xz
    out.M_vw[3] = -m_q_yx
    out.M_vw[4] = -m_q_yy
    out.M_vw[5] = -m_q_yz
    out.M_vw[6] = -m_q_zx
    out.M_vw[7] = -m_q_zy
    out.M_vw[8] = -m_q_zz
    out.M_ww[0] = m_q_yx * q_z - m_q_zx * q_y
    out.M_ww[1] = m_q_yy * q_z - m_q_zy * q_y
    out.M_ww[2] = m_q_yz * q_z - m_q_zz * q_y
    out.M_ww[3] = m_q_zy * q_x - m_q_xy * q_z
    out.M_ww[4] = m_q_zz * q_x - m_q_xz * q_z
    out.M_ww[5] = m_q_xz * q_y - m_q_yz * q_x
    out.C_vv[0] = C_tip_xx
    out.C_vv[1] = C_tip_xy
    out.C_vv[2] = C_tip_xz
    out.C_vv[3] = C_tip_yx
    out.C_vv[4] = C_tip_yy
    out.C_vv[5] = C_tip_yz
    out.C_vv[6] = C_tip_zx
    out.C_vv[7] = C_tip_zy
    out.C_vv[8] = C_tip_zz
    out.C_vw[0] = C_q_xx
    out.C_vw[1] = C_q_xy
    out.C_vw[2] = C_q_xz
    out.C_vw[3] = C_q_yx
    out.C_vw[4] = C_q_yy
    out.C_vw[5] = C_q_yz
    out.C_vw[6] = C_q_zx
    out.C_vw[7] = C_q_zy
    out.C_vw[8] = C_q_zz
    out.C_wv[0] = c50 - c44
    out.C_wv[1] = C_tip_zy * q_y - c43
    out.C_wv[2] = -C_tip_yz * q_z - c48
    out.C_wv[3] = c41 - C_tip_zx * q_x
    out.C_wv[4] = c37 + c51
    out.C_wv[5] = C_tip_xz * q_z + c49
    out.C_wv[6] = C_tip_yx * q_x - c42
    out.C_wv[7] = -C_tip_xy * q_y - c47
    out.C_wv[8] = -c39 - c45
    out.C_ww[0] = C_q_zx * q_y - C_q_yx * q_z
    out.C_ww[1] = C_q_zy * q_y - C_q_yy * q_z
    out.C_ww[2] = C_q_zz * q_y - C_q_yz * q_z
    out.C_ww[3] = C_q_xx * q_z - C_q_zx * q_x
    out.C_ww[4] = C_q_xy * q_z - C_q_zy * q_x
    out.C_ww[5] = C_q_xz * q_z - C_q_zz * q_x
    out.C_ww[6] = C_q_yx * q_x - C_q_xx * q_y
    out.C_ww[7] = C_q_yy * q_x - C_q_xy * q_y
    out.C_ww[8] = C_q_yz * q_x - C_q_xz * q_y
    out.g_force[0] = held_x
    out.g_force[1] = held_y
    out.g_force[2] = held_z
    out.g_moment[0] = held_z * q_y - held_y * q_z
    out.g_moment[1] = held_x * q_z - held_z * q_x
    out.g_moment[2] = held_y * q_x - held_x * q_y
    out.friction_force[0] = rubbed_x
    out.friction_force[1] = rubbed_y
    out.friction_force[2] = rubbed_z
    out.friction_moment[0] = q_y * rubbed_z - C_s * (k_x * phi_dot + theta_dot * y_x) - q_z * rubbed_y
    out.friction_moment[1] = q_z * rubbed_x - C_s * (k_y * phi_dot + theta_dot * y_y) - q_x * rubbed_z
    out.friction_moment[2] = q_x * rubbed_y - C_s * (k_z * phi_dot + theta_dot * y_z) - q_y * rubbed_x
    out.H_force[0] = s_x
    out.H_force[1] = s_y
    out.H_force[2] = s_z
    out.H_moment[0] = q_y * s_z - q_z * s_y
    out.H_moment[1] = q_z * s_x - q_x * s_z
    out.H_moment[2] = q_x * s_y - q_y * s_x
    out.H_dot_force[0] = s_dot_x
    out.H_dot_force[1] = s_dot_y
    out.H_dot_force[2] = s_dot_z
    out.H_dot_moment[0] = q_y * s_dot_z + s_z * w_q_y - q_z * s_dot_y - s_y * w_q_z
    out.H_dot_moment[1] = q_z * s_dot_x + s_x * w_q_z - q_x * s_dot_z - s_z * w_q_x
    out.H_dot_moment[2] = q_x * s_dot_y + s_y * w_q_x - q_y * s_dot_x - s_x * w_q_y
    out.q[0] = q_x
    out.q[1] = q_y
    out.q[2] = q_z
    out.L = L
    out.k3 = k3
    return out


def equations_more(on: Arithmetic, total: Any, more: Any) -> Any:
    """The sums with one part more."""
    out = EquationsSums()
    out.M_vv[0] = total.M_vv[0] + more.M_vv[0]
    out.M_vv[1] = total.M_vv[1] + more.M_vv[1]
    out.M_vv[2] = total.M_vv[2] + more.M_vv[2]
    out.M_vv[3] = total.M_vv[3] + more.M_vv[3]
    out.M_vv[4] = total.M_vv[4] + more.M_vv[4]
    out.M_vv[5] = total.M_vv[5] + more.M_vv[5]
    out.M_vw[0] = total.M_vw[0] + more.M_vw[0]
    out.M_vw[1] = total.M_vw[1] + more.M_vw[1]
    out.M_vw[2] = total.M_vw[2] + more.M_vw[2]
    out.M_vw[3] = total.M_vw[3] + more.M_vw[3]
    out.M_vw[4] = total.M_vw[4] + more.M_vw[4]
    out.M_vw[5] = total.M_vw[5] + more.M_vw[5]
    out.M_vw[6] = total.M_vw[6] + more.M_vw[6]
    out.M_vw[7] = total.M_vw[7] + more.M_vw[7]
    out.M_vw[8] = total.M_vw[8] + more.M_vw[8]
    out.M_ww[0] = total.M_ww[0] + more.M_ww[0]
    out.M_ww[1] = total.M_ww[1] + more.M_ww[1]
    out.M_ww[2] = total.M_ww[2] + more.M_ww[2]
    out.M_ww[3] = total.M_ww[3] + more.M_ww[3]
    out.M_ww[4] = total.M_ww[4] + more.M_ww[4]
    out.M_ww[5] = total.M_ww[5] + more.M_ww[5]
    out.C_vv[0] = total.C_vv[0] + more.C_vv[0]
    out.C_vv[1] = total.C_vv[1] + more.C_vv[1]
    out.C_vv[2] = total.C_vv[2] + more.C_vv[2]
    out.C_vv[3] = total.C_vv[3] + more.C_vv[3]
    out.C_vv[4] = total.C_vv[4] + more.C_vv[4]
    out.C_vv[5] = total.C_vv[5] + more.C_vv[5]
    out.C_vv[6] = total.C_vv[6] + more.C_vv[6]
    out.C_vv[7] = total.C_vv[7] + more.C_vv[7]
    out.C_vv[8] = total.C_vv[8] + more.C_vv[8]
    out.C_vw[0] = total.C_vw[0] + more.C_vw[0]
    out.C_vw[1] = total.C_vw[1] + more.C_vw[1]
    out.C_vw[2] = total.C_vw[2] + more.C_vw[2]
    out.C_vw[3] = total.C_vw[3] + more.C_vw[3]
    out.C_vw[4] = total.C_vw[4] + more.C_vw[4]
    out.C_vw[5] = total.C_vw[5] + more.C_vw[5]
    out.C_vw[6] = total.C_vw[6] + more.C_vw[6]
    out.C_vw[7] = total.C_vw[7] + more.C_vw[7]
    out.C_vw[8] = total.C_vw[8] + more.C_vw[8]
    out.C_wv[0] = total.C_wv[0] + more.C_wv[0]
    out.C_wv[1] = total.C_wv[1] + more.C_wv[1]
    out.C_wv[2] = total.C_wv[2] + more.C_wv[2]
    out.C_wv[3] = total.C_wv[3] + more.C_wv[3]
    out.C_wv[4] = total.C_wv[4] + more.C_wv[4]
    out.C_wv[5] = total.C_wv[5] + more.C_wv[5]
    out.C_wv[6] = total.C_wv[6] + more.C_wv[6]
    out.C_wv[7] = total.C_wv[7] + more.C_wv[7]
    out.C_wv[8] = total.C_wv[8] + more.C_wv[8]
    out.C_ww[0] = total.C_ww[0] + more.C_ww[0]
    out.C_ww[1] = total.C_ww[1] + more.C_ww[1]
    out.C_ww[2] = total.C_ww[2] + more.C_ww[2]
    out.C_ww[3] = total.C_ww[3] + more.C_ww[3]
    out.C_ww[4] = total.C_ww[4] + more.C_ww[4]
    out.C_ww[5] = total.C_ww[5] + more.C_ww[5]
    out.C_ww[6] = total.C_ww[6] + more.C_ww[6]
    out.C_ww[7] = total.C_ww[7] + more.C_ww[7]
    out.C_ww[8] = total.C_ww[8] + more.C_ww[8]
    out.g_force[0] = total.g_force[0] + more.g_force[0]
    out.g_force[1] = total.g_force[1] + more.g_force[1]
    out.g_force[2] = total.g_force[2] + more.g_force[2]
    out.g_moment[0] = total.g_moment[0] + more.g_moment[0]
    out.g_moment[1] = total.g_moment[1] + more.g_moment[1]
    out.g_moment[2] = total.g_moment[2] + more.g_moment[2]
    out.friction_force[0] = total.friction_force[0] + more.friction_force[0]
    out.friction_force[1] = total.friction_force[1] + more.friction_force[1]
    out.friction_force[2] = total.friction_force[2] + more.friction_force[2]
    out.friction_moment[0] = total.friction_moment[0] + more.friction_moment[0]
    out.friction_moment[1] = total.friction_moment[1] + more.friction_moment[1]
    out.friction_moment[2] = total.friction_moment[2] + more.friction_moment[2]
    return out


def equations_total(on: Arithmetic, total: Any, more: Any) -> Any:
    """The sums with one part more."""
    out = EquationsSums()
    out.M_vv[0] = total.M_vv[0] + more.M_vv[0]
    out.M_vv[1] = total.M_vv[1] + more.M_vv[1]
    out.M_vv[2] = total.M_vv[2] + more.M_vv[2]
    out.M_vv[3] = total.M_vv[3] + more.M_vv[3]
    out.M_vv[4] = total.M_vv[4] + more.M_vv[4]
    out.M_vv[5] = total.M_vv[5] + more.M_vv[5]
    out.M_vw[0] = total.M_vw[0] + more.M_vw[0]
    out.M_vw[1] = total.M_vw[1] + more.M_vw[1]
    out.M_vw[2] = total.M_vw[2] + more.M_vw[2]
    out.M_vw[3] = total.M_vw[3] + more.M_vw[3]
    out.M_vw[4] = total.M_vw[4] + more.M_vw[4]
    out.M_vw[5] = total.M_vw[5] + more.M_vw[5]
    out.M_vw[6] = total.M_vw[6] + more.M_vw[6]
    out.M_vw[7] = total.M_vw[7] + more.M_vw[7]
    out.M_vw[8] = total.M_vw[8] + more.M_vw[8]
    out.M_ww[0] = total.M_ww[0] + more.M_ww[0]
    out.M_ww[1] = total.M_ww[1] + more.M_ww[1]
    out.M_ww[2] = total.M_ww[2] + more.M_ww[2]
    out.M_ww[3] = total.M_ww[3] + more.M_ww[3]
    out.M_ww[4] = total.M_ww[4] + more.M_ww[4]
    out.M_ww[5] = total.M_ww[5] + more.M_ww[5]
    out.C_vv[0] = total.C_vv[0] + more.C_vv[0]
    out.C_vv[1] = total.C_vv[1] + more.C_vv[1]
    out.C_vv[2] = total.C_vv[2] + more.C_vv[2]
    out.C_vv[3] = total.C_vv[3] + more.C_vv[3]
    out.C_vv[4] = total.C_vv[4] + more.C_vv[4]
    out.C_vv[5] = total.C_vv[5] + more.C_vv[5]
    out.C_vv[6] = total.C_vv[6] + more.C_vv[6]
    out.C_vv[7] = total.C_vv[7] + more.C_vv[7]
    out.C_vv[8] = total.C_vv[8] + more.C_vv[8]
    out.C_vw[0] = total.C_vw[0] + more.C_vw[0]
    out.C_vw[1] = total.C_vw[1] + more.C_vw[1]
    out.C_vw[2] = total.C_vw[2] + more.C_vw[2]
    out.C_vw[3] = total.C_vw[3] + more.C_vw[3]
    out.C_vw[4] = total.C_vw[4] + more.C_vw[4]
    out.C_vw[5] = total.C_vw[5] + more.C_vw[5]
    out.C_vw[6] = total.C_vw[6] + more.C_vw[6]
    out.C_vw[7] = total.C_vw[7] + more.C_vw[7]
    out.C_vw[8] = total.C_vw[8] + more.C_vw[8]
    out.C_wv[0] = total.C_wv[0] + more.C_wv[0]
    out.C_wv[1] = total.C_wv[1] + more.C_wv[1]
    out.C_wv[2] = total.C_wv[2] + more.C_wv[2]
    out.C_wv[3] = total.C_wv[3] + more.C_wv[3]
    out.C_wv[4] = total.C_wv[4] + more.C_wv[4]
    out.C_wv[5] = total.C_wv[5] + more.C_wv[5]
    out.C_wv[6] = total.C_wv[6] + more.C_wv[6]
    out.C_wv[7] = total.C_wv[7] + more.C_wv[7]
    out.C_wv[8] = total.C_wv[8] + more.C_wv[8]
    out.C_ww[0] = total.C_ww[0] + more.C_ww[0]
    out.C_ww[1] = total.C_ww[1] + more.C_ww[1]
    out.C_ww[2] = total.C_ww[2] + more.C_ww[2]
    out.C_ww[3] = total.C_ww[3] + more.C_ww[3]
    out.C_ww[4] = total.C_ww[4] + more.C_ww[4]
    out.C_ww[5] = total.C_ww[5] + more.C_ww[5]
    out.C_ww[6] = total.C_ww[6] + more.C_ww[6]
    out.C_ww[7] = total.C_ww[7] + more.C_ww[7]
    out.C_ww[8] = total.C_ww[8] + more.C_ww[8]
    out.g_force[0] = total.g_force[0] + more.g_force[0]
    out.g_force[1] = total.g_force[1] + more.g_force[1]
    out.g_force[2] = total.g_force[2] + more.g_force[2]
    out.g_moment[0] = total.g_moment[0] + more.g_moment[0]
    out.g_moment[1] = total.g_moment[1] + more.g_moment[1]
    out.g_moment[2] = total.g_moment[2] + more.g_moment[2]
    out.friction_force[0] = total.friction_force[0] + more.friction_force[0]
    out.friction_force[1] = total.friction_force[1] + more.friction_force[1]
    out.friction_force[2] = total.friction_force[2] + more.friction_force[2]
    out.friction_moment[0] = total.friction_moment[0] + more.friction_moment[0]
    out.friction_moment[1] = total.friction_moment[1] + more.friction_moment[1]
    out.friction_moment[2] = total.friction_moment[2] + more.friction_moment[2]
    return out


def forward_pose(on: Arithmetic, platform: Any, motion: Any) -> Any:
    """The platform's part of M and of the right side: 201 (117 mul, 84 add, 0 div, 0 sqrt)."""
    R_xx = motion.R[0]
    R_xy = motion.R[1]
    R_xz = motion.R[2]
    R_yx = motion.R[3]
    R_yy = motion.R[4]
    R_yz = motion.R[5]
    R_zx = motion.R[6]
    R_zy = motion.R[7]
    R_zz = motion.R[8]
    omega_x = motion.omega[0]
    omega_y = motion.omega[1]
    omega_z = motion.omega[2]
    F_ext_x = motion.F_ext[0]
    F_ext_y = motion.F_ext[1]
    F_ext_z = motion.F_ext[2]
    M_ext_x = motion.M_ext[0]
    M_ext_y = motion.M_ext[1]
    M_ext_z = motion.M_ext[2]
    M_P = platform.M_P
    h_P_x = platform.h_P[0]
    h_P_y = platform.h_P[1]
    h_P_z = platform.h_P[2]
    J_P_xx = platform.J_P[0]
    J_P_xy = platform.J_P[1]
    J_P_xz = platform.J_P[2]
    J_P_yy = platform.J_P[3]
    J_P_yz = platform.J_P[4]
    J_P_zz = platform.J_P[5]
    C_P = platform.C_P
    g_x = platform.g[0]
    g_y = platform.g[1]
    g_z = platform.g[2]
    # (30) first moment of the platform, base frame
    h_base_x = R_xx * h_P_x + R_xy * h_P_y + R_xz * h_P_z
    h_base_y = R_yx * h_P_x + R_yy * h_P_y + R_yz * h_P_z
    h_base_z = R_zx * h_P_x + R_zy * h_P_y + R_zz * h_P_z
    c1 = J_P_xx * R_xx + J_P_xy * R_xy + J_P_xz * R_xz
    c2 = J_P_xy * R_xx + J_P_yy * R_xy + J_P_yz * R_xz
    c3 = J_P_xz * R_xx + J_P_yz * R_xy + J_P_zz * R_xz
    c4 = J_P_xx * R_yx + J_P_xy * R_yy + J_P_xz * R_yz
    c5 = J_P_xy * R_yx + J_P_yy * R_yy + J_P_yz * R_yz
    c6 = J_P_xz * R_yx + J_P_yz * R_yy + J_P_zz * R_yz
    # (32) inertia of the platform, base frame
    J_base_xx = R_xx * c1 + R_xy * c2 + R_xz * c3
    J_base_xy = R_yx * c1 + R_yy * c2 + R_yz * c3
    J_base_xz = R_zx * c1 + R_zy * c2 + R_zz * c3
    J_base_yy = R_yx * c4 + R_yy * c5 + R_yz * c6
    J_base_yz = R_zx * c4 + R_zy * c5 + R_zz * c6
    J_base_zz = (
        R_zx * (J_P_xx * R_zx + J_P_xy * R_zy + J_P_xz * R_zz) + R_zy * (J_P_xy * R_zx + J_P_yy * R_zy + J_P_yz
            * R_zz) + R_zz * (J_P_xz * R_zx + J_P_yz * R_zy + J_P_zz * R_zz)
    )
    # (31) omega x h
    w_h_x = h_base_z * omega_y - h_base_y * omega_z
    w_h_y = h_base_x * omega_z - h_base_z * omega_x
    w_h_z = h_base_y * omega_x - h_base_x * omega_y
    # (34) I omega
    J_w_x = J_base_xx * omega_x + J_base_xy * omega_y + J_base_xz * omega_z
    J_w_y = J_base_xy * omega_x + J_base_yy * omega_y + J_base_yz * omega_z
    J_w_z = J_base_xz * omega_x + J_base_yz * omega_y + J_base_zz * omega_z
    # products of omega
    omega_xx = omega_x * omega_x
    omega_xy = omega_x * omega_y
    omega_xz = omega_x * omega_z
    omega_yy = omega_y * omega_y
    omega_yz = omega_y * omega_z
    omega_zz = omega_z * omega_z
    # (7) S_ddot = B q + a
    B_xx = -omega_yy - omega_zz
    B_yy = -omega_xx - omega_zz
    B_zz = -omega_xx - omega_yy
    out = ForwardPose()
    out.B_0[0] = B_xx
    out.B_0[1] = omega_xy
    out.B_0[2] = omega_xz
    out.B_0[3] = omega_xy
    out.B_0[4] = B_yy
    out.B_0[5] = omega_yz
    out.B_0[6] = omega_xz
    out.B_0[7] = omega_yz
    out.B_0[8] = B_zz
    out.M_vv[0] = M_P
    out.M_vv[1] = 0.0
    out.M_vv[2] = 0.0
    out.M_vv[3] = M_P
    out.M_vv[4] = 0.0
    out.M_vv[5] = M_P
    out.M_vw[0] = 0.0
    out.M_vw[1] = h_base_z
    out.M_vw[2] = -h_base_y
    out.M_vw[3] = -h_base_z
    out.M_vw[4] = 0.0
    out.M_vw[5] = h_base_x
    out.M_vw[6] = h_base_y
    out.M_vw[7] = -h_base_x
    out.M_vw[8] = 0.0
    out.M_ww[0] = J_base_xx
    out.M_ww[1] = J_base_xy
    out.M_ww[2] = J_base_xz
    out.M_ww[3] = J_base_yy
    out.M_ww[4] = J_base_yz
    out.M_ww[5] = J_base_zz
    out.right_force[0] = (
        F_ext_x * R_xx + F_ext_y * R_xy + F_ext_z * R_xz + M_P * g_x + omega_z * w_h_y - omega_y * w_h_z
    )
    out.right_force[1] = (
        F_ext_x * R_yx + F_ext_y * R_yy + F_ext_z * R_yz + M_P * g_y + omega_x * w_h_z - omega_z * w_h_x
    )
    out.right_force[2] = (
        F_ext_x * R_zx + F_ext_y * R_zy + F_ext_z * R_zz + M_P * g_z + omega_y * w_h_x - omega_x * w_h_y
    )
    out.right_moment[0] = (
        J_w_y * omega_z + M_ext_x * R_xx + M_ext_y * R_xy + M_ext_z * R_xz + g_z * h_base_y - C_P * omega_x
            - J_w_z * omega_y - g_y * h_base_z
    )
    out.right_moment[1] = (
        J_w_z * omega_x + M_ext_x * R_yx + M_ext_y * R_yy + M_ext_z * R_yz + g_x * h_base_z - C_P * omega_y
            - J_w_x * omega_z - g_z * h_base_x
    )
    out.right_moment[2] = (
        J_w_x * omega_y + M_ext_x * R_zx + M_ext_y * R_zy + M_ext_z * R_zz + g_y * h_base_x - C_P * omega_z
            - J_w_y * omega_x - g_x * h_base_y
    )
    return out


def forward_leg(on: Arithmetic, leg: Any, platform: Any, motion: Any, pose: Any, F: Any) -> Any:
    """One leg's part of M and of the right side: 425 (260 mul, 161 add, 2 div, 2 sqrt)."""
    b_x = leg.b[0]
    b_y = leg.b[1]
    b_z = leg.b[2]
    p_x = leg.p[0]
    p_y = leg.p[1]
    p_z = leg.p[2]
    k_x = leg.k[0]
    k_y = leg.k[1]
    k_z = leg.k[2]
    C_p = leg.C_p
    C_s = leg.C_s
    h_x = leg.h[0]
    h_y = leg.h[1]
    h_z = leg.h[2]
    h2_x = leg.h2_x
    h2_y = leg.h2_y
    h2_z = leg.h2_z
    w_x = leg.w[0]
    w_y = leg.w[1]
    w_z = leg.w[2]
    J_xx = leg.J[0]
    J_xy = leg.J[1]
    J_yy = leg.J[3]
    J_yz = leg.J[4]
    J2_xz = leg.J2_xz
    dJ_zx = leg.dJ_zx
    g_k = leg.g_k
    g_x_k_x = leg.g_x_k[0]
    g_x_k_y = leg.g_x_k[1]
    g_x_k_z = leg.g_x_k[2]
    C_us = leg.C_us
    R_xx = motion.R[0]
    R_xy = motion.R[1]
    R_xz = motion.R[2]
    R_yx = motion.R[3]
    R_yy = motion.R[4]
    R_yz = motion.R[5]
    R_zx = motion.R[6]
    R_zy = motion.R[7]
    R_zz = motion.R[8]
    t_x = motion.t[0]
    t_y = motion.t[1]
    t_z = motion.t[2]
    omega_x = motion.omega[0]
    omega_y = motion.omega[1]
    omega_z = motion.omega[2]
    v_x = motion.v[0]
    v_y = motion.v[1]
    v_z = motion.v[2]
    B_0_xx = pose.B_0[0]
    B_0_xy = pose.B_0[1]
    B_0_xz = pose.B_0[2]
    B_0_yx = pose.B_0[3]
    B_0_yy = pose.B_0[4]
    B_0_yz = pose.B_0[5]
    B_0_zx = pose.B_0[6]
    B_0_zy = pose.B_0[7]
    B_0_zz = pose.B_0[8]
    g_x = platform.g[0]
    g_y = platform.g[1]
    g_z = platform.g[2]
    # (1) platform point from the reference point
    q_x = R_xx * p_x + R_xy * p_y + R_xz * p_z
    q_y = R_yx * p_x + R_yy * p_y + R_yz * p_z
    q_z = R_zx * p_x + R_zy * p_y + R_zz * p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = q_x + t_b_x
    S_y = q_y + t_b_y
    S_z = q_z + t_b_z
    # (10) leg vector along the fixed axis, and normal to both
    zeta = S_x * k_x + S_y * k_y + S_z * k_z
    k_cross_S_x = S_z * k_y - S_y * k_z
    k_cross_S_y = S_x * k_z - S_z * k_x
    k_cross_S_z = S_y * k_x - S_x * k_y
    # (2) leg length, and distance of its tip from the fixed axis
    L = on.sqrt(S_x * S_x + S_y * S_y + S_z * S_z)
    inv_L = 1.0 / L
    # (3) unit vector along the leg
    s_x = S_x * inv_L
    s_y = S_y * inv_L
    s_z = S_z * inv_L
    # (10) along the third axis of the leg
    s_cross_normal_x = k_cross_S_z * s_y - k_cross_S_y * s_z
    s_cross_normal_y = k_cross_S_x * s_z - k_cross_S_z * s_x
    s_cross_normal_z = k_cross_S_y * s_x - k_cross_S_x * s_y
    # (10) leg length, and distance of its tip from the fixed axis
    rho = (
        on.sqrt(s_cross_normal_x * s_cross_normal_x + s_cross_normal_y * s_cross_normal_y + s_cross_normal_z
            * s_cross_normal_z)
    )
    inv_rho = 1.0 / rho
    # (10) third axis of the leg frame
    z_x = inv_rho * s_cross_normal_x
    z_y = inv_rho * s_cross_normal_y
    z_z = inv_rho * s_cross_normal_z
    # (10) rotating axis of the universal joint
    y_x = s_z * z_y - s_y * z_z
    y_y = s_x * z_z - s_z * z_x
    y_z = s_y * z_x - s_x * z_y
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = inv_L * zeta
    k3 = inv_L * rho
    # (10) k1 / k3
    kappa = inv_rho * zeta
    # (4) omega x q
    w_q_x = omega_y * q_z - omega_z * q_y
    w_q_y = omega_z * q_x - omega_x * q_z
    w_q_z = omega_x * q_y - omega_y * q_x
    # (4) velocity of the platform point
    S_dot_x = v_x + w_q_x
    S_dot_y = v_y + w_q_y
    S_dot_z = v_z + w_q_z
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x * s_x + S_dot_y * s_y + S_dot_z * s_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = inv_rho * (S_dot_x * y_x + S_dot_y * y_y + S_dot_z * y_z)
    theta_dot = -inv_L * (S_dot_x * z_x + S_dot_y * z_y + S_dot_z * z_z)
    # L_dot / L
    L_share = L_dot * inv_L
    lean = kappa * theta_dot
    theta_dot2 = theta_dot * theta_dot
    phi_dot2 = phi_dot * phi_dot
    two_phi_dot = 2.0 * phi_dot
    # (7) acceleration of the platform point, a = alpha = 0
    S_ddot_x = B_0_xx * q_x + B_0_xy * q_y + B_0_xz * q_z
    S_ddot_y = B_0_yx * q_x + B_0_yy * q_y + B_0_yz * q_z
    S_ddot_z = B_0_zx * q_x + B_0_zy * q_y + B_0_zz * q_z
    k33 = k3 * k3
    # (8) accelerations of the joint coordinates
    L_ddot = L * (k33 * phi_dot2 + theta_dot2) + S_ddot_x * s_x + S_ddot_y * s_y + S_ddot_z * s_z
    # (9) accelerations of the joint coordinates but for the turning of the leg frame about s
    own_theta_ddot = -2.0 * L_share * theta_dot - inv_L * (S_ddot_x * z_x + S_ddot_y * z_y + S_ddot_z * z_z)
    own_phi_ddot = inv_rho * (S_ddot_x * y_x + S_ddot_y * y_y + S_ddot_z * y_z) - L_share * two_phi_dot
    c1 = k1 * k3
    # (9) accelerations of the joint coordinates
    theta_ddot = c1 * phi_dot2 + own_theta_ddot
    phi_ddot = own_phi_ddot - lean * two_phi_dot
    k13 = c1
    L_h2 = L * h2_x
    a1 = L_h2 + dJ_zx
    c2 = L * h2_z
    c3 = J2_xz - c2
    a2 = c3
    a3 = J_xy - L * h_y
    # (19) inertia of the joint coordinates
    M_phi = J_xx + a1 * k33 + a2 * k13
    M_theta = J_yy + L_h2
    M_mixed = J_yz * k3 + a3 * k1
    k3_h = h_y * k3
    # (19) slopes of M_phi / 2 along theta and L, of M_mixed along theta
    M_phi_L = h_x * k33 - h_z * k13
    M_mixed_theta = J_yz * k1 - a3 * k3
    bend = L_dot * theta_dot
    # gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # first moment along k and against k x y
    w_k = k1 * w_x + k3 * w_z
    w_n = k3 * w_x - k1 * w_z
    # (20) generalised forces about y and about k
    tau_y = (
        C_us * theta_dot + L_ddot * h_z + M_mixed * phi_ddot + M_theta * own_theta_ddot + bend * h2_x + g_k
            * w_n + gamma_n * w_k + phi_dot2 * (k13 * (J_yy - dJ_zx) - c3 * (0.5 - k33)) - C_s * (omega_x * y_x
            + omega_y * y_y + omega_z * y_z)
    )
    tau_k = (
        C_us * phi_dot + M_mixed * theta_ddot + M_mixed_theta * theta_dot2 + M_phi * own_phi_ddot + two_phi_dot
            * (L_dot * M_phi_L - theta_dot * (0.5 * J2_xz + J_xx * kappa - 0.5 * c2)) - C_s * (k_x * omega_x
            + k_y * omega_y + k_z * omega_z) - L_ddot * k3_h - bend * h2_y * k1 - gamma_n * w_y - gamma_y * w_n
    )
    # (21) K = Q_y y + Q_z z
    Q_y = inv_rho * tau_k
    Q_z = -inv_L * tau_y
    # (21) force at the spherical joint, base frame
    K_x = Q_y * y_x + Q_z * z_x
    K_y = Q_y * y_y + Q_z * z_y
    K_z = Q_y * y_z + Q_z * z_z
    # (24) known part of the actuator force, to match
    D = C_p * L_dot + h_z * theta_ddot - M_phi_L * phi_dot2 - h_x * theta_dot2 - k3_h * phi_ddot
    c4 = F - D
    # force on the platform at the tip
    push_x = c4 * s_x - K_x
    push_y = c4 * s_y - K_y
    push_z = c4 * s_z - K_z
    # inertia at the tip, leg frame
    m_leg_sy = -inv_rho * k3_h
    m_leg_sz = -h_z * inv_L
    m_leg_yy = M_phi * inv_rho * inv_rho
    m_leg_yz = -M_mixed * inv_L * inv_rho
    m_leg_zz = M_theta * inv_L * inv_L
    m_T_xs = m_leg_sy * y_x + m_leg_sz * z_x
    m_T_xy = m_leg_sy * s_x + m_leg_yy * y_x + m_leg_yz * z_x
    m_T_xz = m_leg_sz * s_x + m_leg_yz * y_x + m_leg_zz * z_x
    m_T_ys = m_leg_sy * y_y + m_leg_sz * z_y
    m_T_yy = m_leg_sy * s_y + m_leg_yy * y_y + m_leg_yz * z_y
    m_T_yz = m_leg_sz * s_y + m_leg_yz * y_y + m_leg_zz * z_y
    m_T_zs = m_leg_sy * y_z + m_leg_sz * z_z
    m_T_zy = m_leg_sy * s_z + m_leg_yy * y_z + m_leg_yz * z_z
    m_T_zz = m_leg_sz * s_z + m_leg_yz * y_z + m_leg_zz * z_z
    # inertia at the tip, base frame
    m_xx = m_T_xs * s_x + m_T_xy * y_x + m_T_xz * z_x
    m_xy = m_T_xs * s_y + m_T_xy * y_y + m_T_xz * z_y
    m_xz = m_T_xs * s_z + m_T_xy * y_z + m_T_xz * z_z
    m_yy = m_T_ys * s_y + m_T_yy * y_y + m_T_yz * z_y
    m_yz = m_T_ys * s_z + m_T_yy * y_z + m_T_yz * z_z
    m_zz = m_T_zs * s_z + m_T_zy * y_z + m_T_zz * z_z
    c5 = m_xy * q_z
    c6 = m_xz * q_y
    c7 = -m_yz * q_x
    # m [q]x
    m_q_xx = c5 - c6
    m_q_xy = m_xz * q_x - m_xx * q_z
    m_q_xz = m_xx * q_y - m_xy * q_x
    m_q_yx = m_yy * q_z - m_yz * q_y
    m_q_yy = -c5 - c7
    m_q_yz = m_xy * q_y - m_yy * q_x
    m_q_zx = m_yz * q_z - m_zz * q_y
    m_q_zy = m_zz * q_x - m_xz * q_z
    m_q_zz = c6 + c7
    out = ForwardLeg()
    out.M_vv[0] = m_xx
    out.M_vv[1] = m_xy
    out.M_vv[2] = m_xz
    out.M_vv[3] = m_yy
    out.M_vv[4] = m_yz
    out.M_vv[5] = m_zz
    out.M_vw[0] = -m_q_xx
    out.M_vw[1] = -m_q_xy
    out.M_vw[2] = -m_q_xz
    out.M_vw[3] = -m_q_yx
    out.M_vw[4] = -m_q_yy
    out.M_vw[5] = -m_q_yz
    out.M_vw[6] = -m_q_zx
    out.M_vw[7] = -m_q_zy
    out.M_vw[8] = -m_q_zz
    out.M_ww[0] = m_q_yx * q_z - m_q_zx * q_y
    out.M_ww[1] = m_q_yy * q_z - m_q_zy * q_y
    out.M_ww[2] = m_q_yz * q_z - m_q_zz * q_y
    out.M_ww[3] = m_q_zy * q_x - m_q_xy * q_z
    out.M_ww[4] = m_q_zz * q_x - m_q_xz * q_z
    out.M_ww[5] = m_q_xz * q_y - m_q_yz * q_x
    out.right_force[0] = push_x
    out.right_force[1] = push_y
    out.right_force[2] = push_z
    out.right_moment[0] = C_s * (k_x * phi_dot + theta_dot * y_x) + push_z * q_y - push_y * q_z
    out.right_moment[1] = C_s * (k_y * phi_dot + theta_dot * y_y) + push_x * q_z - push_z * q_x
    out.right_moment[2] = C_s * (k_z * phi_dot + theta_dot * y_z) + push_y * q_x - push_x * q_y
    out.q[0] = q_x
    out.q[1] = q_y
    out.q[2] = q_z
    out.L = L
    out.k3 = k3
    return out


def joint_rows_pose(on: Arithmetic, platform: Any, motion: Any) -> Any:
    """The platform's part of M and of the right side: 222 (129 mul, 93 add, 0 div, 0 sqrt)."""
    R_xx = motion.R[0]
    R_xy = motion.R[1]
    R_xz = motion.R[2]
    R_yx = motion.R[3]
    R_yy = motion.R[4]
    R_yz = motion.R[5]
    R_zx = motion.R[6]
    R_zy = motion.R[7]
    R_zz = motion.R[8]
    omega_x = motion.omega[0]
    omega_y = motion.omega[1]
    omega_z = motion.omega[2]
    F_ext_x = motion.F_ext[0]
    F_ext_y = motion.F_ext[1]
    F_ext_z = motion.F_ext[2]
    M_ext_x = motion.M_ext[0]
    M_ext_y = motion.M_ext[1]
    M_ext_z = motion.M_ext[2]
    C_P = platform.C_P
    g_x = platform.g[0]
    g_y = platform.g[1]
    g_z = platform.g[2]
    M = platform.M
    R_0_x = platform.R_0[0]
    R_0_y = platform.R_0[1]
    R_0_z = platform.R_0[2]
    I_p_xx = platform.I_p[0]
    I_p_xy = platform.I_p[1]
    I_p_xz = platform.I_p[2]
    I_p_yy = platform.I_p[3]
    I_p_yz = platform.I_p[4]
    I_p_zz = platform.I_p[5]
    c1 = R_0_y * R_0_y
    c2 = R_0_z * R_0_z
    J_0_xx = I_p_xx + M * (c1 + c2)
    c3 = M * R_0_x
    J_0_xy = I_p_xy - R_0_y * c3
    J_0_xz = I_p_xz - R_0_z * c3
    c4 = R_0_x * R_0_x
    J_0_yy = I_p_yy + M * (c2 + c4)
    c5 = M * R_0_y
    J_0_yz = I_p_yz - R_0_z * c5
    J_0_zz = I_p_zz + M * (c1 + c4)
    c6 = M * R_0_z
    # (30) first moment of the platform, base frame
    h_base_x = R_xx * c3 + R_xy * c5 + R_xz * c6
    h_base_y = R_yx * c3 + R_yy * c5 + R_yz * c6
    h_base_z = R_zx * c3 + R_zy * c5 + R_zz * c6
    c7 = J_0_xx * R_xx + J_0_xy * R_xy + J_0_xz * R_xz
    c8 = J_0_xy * R_xx + J_0_yy * R_xy + J_0_yz * R_xz
    c9 = J_0_xz * R_xx + J_0_yz * R_xy + J_0_zz * R_xz
    c10 = J_0_xx * R_yx + J_0_xy * R_yy + J_0_xz * R_yz
    c11 = J_0_xy * R_yx + J_0_yy * R_yy + J_0_yz * R_yz
    c12 = J_0_xz * R_yx + J_0_yz * R_yy + J_0_zz * R_yz
    # (32) inertia of the platform, base frame
    J_base_xx = R_xx * c7 + R_xy * c8 + R_xz * c9
    J_base_xy = R_yx * c7 + R_yy * c8 + R_yz * c9
    J_base_xz = R_zx * c7 + R_zy * c8 + R_zz * c9
    J_base_yy = R_yx * c10 + R_yy * c11 + R_yz * c12
    J_base_yz = R_zx * c10 + R_zy * c11 + R_zz * c12
    J_base_zz = (
        R_zx * (J_0_xx * R_zx + J_0_xy * R_zy + J_0_xz * R_zz) + R_zy * (J_0_xy * R_zx + J_0_yy * R_zy + J_0_yz
            * R_zz) + R_zz * (J_0_xz * R_zx + J_0_yz * R_zy + J_0_zz * R_zz)
    )
    # (31) omega x h
    w_h_x = h_base_z * omega_y - h_base_y * omega_z
    w_h_y = h_base_x * omega_z - h_base_z * omega_x
    w_h_z = h_base_y * omega_x - h_base_x * omega_y
    # (34) I omega
    J_w_x = J_base_xx * omega_x + J_base_xy * omega_y + J_base_xz * omega_z
    J_w_y = J_base_xy * omega_x + J_base_yy * omega_y + J_base_yz * omega_z
    J_w_z = J_base_xz * omega_x + J_base_yz * omega_y + J_base_zz * omega_z
    # products of omega
    omega_xx = omega_x * omega_x
    omega_xy = omega_x * omega_y
    omega_xz = omega_x * omega_z
    omega_yy = omega_y * omega_y
    omega_yz = omega_y * omega_z
    omega_zz = omega_z * omega_z
    # (7) S_ddot = B q + a
    B_xx = -omega_yy - omega_zz
    B_yy = -omega_xx - omega_zz
    B_zz = -omega_xx - omega_yy
    out = JointRowsPose()
    out.B_0[0] = B_xx
    out.B_0[1] = omega_xy
    out.B_0[2] = omega_xz
    out.B_0[3] = omega_xy
    out.B_0[4] = B_yy
    out.B_0[5] = omega_yz
    out.B_0[6] = omega_xz
    out.B_0[7] = omega_yz
    out.B_0[8] = B_zz
    out.M_vv[0] = M
    out.M_vv[1] = 0.0
    out.M_vv[2] = 0.0
    out.M_vv[3] = M
    out.M_vv[4] = 0.0
    out.M_vv[5] = M
    out.M_vw[0] = 0.0
    out.M_vw[1] = h_base_z
    out.M_vw[2] = -h_base_y
    out.M_vw[3] = -h_base_z
    out.M_vw[4] = 0.0
    out.M_vw[5] = h_base_x
    out.M_vw[6] = h_base_y
    out.M_vw[7] = -h_base_x
    out.M_vw[8] = 0.0
    out.M_ww[0] = J_base_xx
    out.M_ww[1] = J_base_xy
    out.M_ww[2] = J_base_xz
    out.M_ww[3] = J_base_yy
    out.M_ww[4] = J_base_yz
    out.M_ww[5] = J_base_zz
    out.right_force[0] = (
        F_ext_x * R_xx + F_ext_y * R_xy + F_ext_z * R_xz + M * g_x + omega_z * w_h_y - omega_y * w_h_z
    )
    out.right_force[1] = (
        F_ext_x * R_yx + F_ext_y * R_yy + F_ext_z * R_yz + M * g_y + omega_x * w_h_z - omega_z * w_h_x
    )
    out.right_force[2] = (
        F_ext_x * R_zx + F_ext_y * R_zy + F_ext_z * R_zz + M * g_z + omega_y * w_h_x - omega_x * w_h_y
    )
    out.right_moment[0] = (
        J_w_y * omega_z + M_ext_x * R_xx + M_ext_y * R_xy + M_ext_z * R_xz + g_z * h_base_y - C_P * omega_x
            - J_w_z * omega_y - g_y * h_base_z
    )
    out.right_moment[1] = (
        J_w_z * omega_x + M_ext_x * R_yx + M_ext_y * R_yy + M_ext_z * R_yz + g_x * h_base_z - C_P * omega_y
            - J_w_x * omega_z - g_z * h_base_x
    )
    out.right_moment[2] = (
        J_w_x * omega_y + M_ext_x * R_zx + M_ext_y * R_zy + M_ext_z * R_zz + g_y * h_base_x - C_P * omega_z
            - J_w_y * omega_x - g_x * h_base_y
    )
    return out


def joint_rows_leg(on: Arithmetic, leg: Any, platform: Any, motion: Any, pose: Any, F: Any) -> Any:
    """One leg's inertia and generalised forces in its joint coordinates, and their gradients: 341 (207 mul, 130 add, 2 div, 2 sqrt)."""
    b_x = leg.b[0]
    b_y = leg.b[1]
    b_z = leg.b[2]
    p_x = leg.p[0]
    p_y = leg.p[1]
    p_z = leg.p[2]
    k_x = leg.k[0]
    k_y = leg.k[1]
    k_z = leg.k[2]
    m_u = leg.m_u
    C_p = leg.C_p
    C_s = leg.C_s
    h_x = leg.h[0]
    h_y = leg.h[1]
    h_z = leg.h[2]
    h2_x = leg.h2_x
    h2_y = leg.h2_y
    h2_z = leg.h2_z
    w_x = leg.w[0]
    w_y = leg.w[1]
    w_z = leg.w[2]
    J_xx = leg.J[0]
    J_xy = leg.J[1]
    J_yy = leg.J[3]
    J_yz = leg.J[4]
    J2_xz = leg.J2_xz
    dJ_zx = leg.dJ_zx
    g_k = leg.g_k
    g_x_k_x = leg.g_x_k[0]
    g_x_k_y = leg.g_x_k[1]
    g_x_k_z = leg.g_x_k[2]
    C_us = leg.C_us
    R_xx = motion.R[0]
    R_xy = motion.R[1]
    R_xz = motion.R[2]
    R_yx = motion.R[3]
    R_yy = motion.R[4]
    R_yz = motion.R[5]
    R_zx = motion.R[6]
    R_zy = motion.R[7]
    R_zz = motion.R[8]
    t_x = motion.t[0]
    t_y = motion.t[1]
    t_z = motion.t[2]
    omega_x = motion.omega[0]
    omega_y = motion.omega[1]
    omega_z = motion.omega[2]
    v_x = motion.v[0]
    v_y = motion.v[1]
    v_z = motion.v[2]
    B_0_xx = pose.B_0[0]
    B_0_xy = pose.B_0[1]
    B_0_xz = pose.B_0[2]
    B_0_yx = pose.B_0[3]
    B_0_yy = pose.B_0[4]
    B_0_yz = pose.B_0[5]
    B_0_zx = pose.B_0[6]
    B_0_zy = pose.B_0[7]
    B_0_zz = pose.B_0[8]
    g_x = platform.g[0]
    g_y = platform.g[1]
    g_z = platform.g[2]
    # (1) platform point from the reference point
    q_x = R_xx * p_x + R_xy * p_y + R_xz * p_z
    q_y = R_yx * p_x + R_yy * p_y + R_yz * p_z
    q_z = R_zx * p_x + R_zy * p_y + R_zz * p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = q_x + t_b_x
    S_y = q_y + t_b_y
    S_z = q_z + t_b_z
    # (10) leg vector along the fixed axis, and normal to both
    zeta = S_x * k_x + S_y * k_y + S_z * k_z
    k_cross_S_x = S_z * k_y - S_y * k_z
    k_cross_S_y = S_x * k_z - S_z * k_x
    k_cross_S_z = S_y * k_x - S_x * k_y
    # (2) leg length, and distance of its tip from the fixed axis
    L = on.sqrt(S_x * S_x + S_y * S_y + S_z * S_z)
    inv_L = 1.0 / L
    # (3) unit vector along the leg
    s_x = S_x * inv_L
    s_y = S_y * inv_L
    s_z = S_z * inv_L
    # (10) along the third axis of the leg
    s_cross_normal_x = k_cross_S_z * s_y - k_cross_S_y * s_z
    s_cross_normal_y = k_cross_S_x * s_z - k_cross_S_z * s_x
    s_cross_normal_z = k_cross_S_y * s_x - k_cross_S_x * s_y
    # (10) leg length, and distance of its tip from the fixed axis
    rho = (
        on.sqrt(s_cross_normal_x * s_cross_normal_x + s_cross_normal_y * s_cross_normal_y + s_cross_normal_z
            * s_cross_normal_z)
    )
    inv_rho = 1.0 / rho
    # (10) third axis of the leg frame
    z_x = inv_rho * s_cross_normal_x
    z_y = inv_rho * s_cross_normal_y
    z_z = inv_rho * s_cross_normal_z
    # (10) rotating axis of the universal joint
    y_x = s_z * z_y - s_y * z_z
    y_y = s_x * z_z - s_z * z_x
    y_z = s_y * z_x - s_x * z_y
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = inv_L * zeta
    k3 = inv_L * rho
    # (10) k1 / k3
    kappa = inv_rho * zeta
    # (4) omega x q
    w_q_x = omega_y * q_z - omega_z * q_y
    w_q_y = omega_z * q_x - omega_x * q_z
    w_q_z = omega_x * q_y - omega_y * q_x
    # (4) velocity of the platform point
    S_dot_x = v_x + w_q_x
    S_dot_y = v_y + w_q_y
    S_dot_z = v_z + w_q_z
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x * s_x + S_dot_y * s_y + S_dot_z * s_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = inv_rho * (S_dot_x * y_x + S_dot_y * y_y + S_dot_z * y_z)
    theta_dot = -inv_L * (S_dot_x * z_x + S_dot_y * z_y + S_dot_z * z_z)
    # L_dot / L
    L_share = L_dot * inv_L
    lean = kappa * theta_dot
    theta_dot2 = theta_dot * theta_dot
    phi_dot2 = phi_dot * phi_dot
    two_phi_dot = 2.0 * phi_dot
    c1 = B_0_xx * q_x + B_0_xy * q_y + B_0_xz * q_z
    c2 = B_0_yx * q_x + B_0_yy * q_y + B_0_yz * q_z
    c3 = B_0_zx * q_x + B_0_zy * q_y + B_0_zz * q_z
    # (7) acceleration of the platform point, a = alpha = 0
    S_ddot_x = c1
    S_ddot_y = c2
    S_ddot_z = c3
    c4 = k3 * k3
    k33 = c4
    # (8) accelerations of the joint coordinates
    L_ddot = L * (k33 * phi_dot2 + theta_dot2) + S_ddot_x * s_x + S_ddot_y * s_y + S_ddot_z * s_z
    # (9) accelerations of the joint coordinates but for the turning of the leg frame about s
    own_theta_ddot = -2.0 * L_share * theta_dot - inv_L * (S_ddot_x * z_x + S_ddot_y * z_y + S_ddot_z * z_z)
    own_phi_ddot = inv_rho * (S_ddot_x * y_x + S_ddot_y * y_y + S_ddot_z * y_z) - L_share * two_phi_dot
    c5 = k1 * k3
    # (9) accelerations of the joint coordinates
    theta_ddot = c5 * phi_dot2 + own_theta_ddot
    phi_ddot = own_phi_ddot - lean * two_phi_dot
    k13 = c5
    L_h2 = L * h2_x
    a1 = L_h2 + dJ_zx
    c6 = L * h2_z
    c7 = J2_xz - c6
    a2 = c7
    a3 = J_xy - L * h_y
    # (19) inertia of the joint coordinates
    M_phi = J_xx + a1 * k33 + a2 * k13
    M_theta = J_yy + L_h2
    M_mixed = J_yz * k3 + a3 * k1
    k3_h = h_y * k3
    # (19) slopes of M_phi / 2 along theta and L, of M_mixed along theta
    M_phi_L = h_x * k33 - h_z * k13
    M_mixed_theta = J_yz * k1 - a3 * k3
    bend = L_dot * theta_dot
    # gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # first moment along k and against k x y
    w_k = k1 * w_x + k3 * w_z
    w_n = k3 * w_x - k1 * w_z
    # (20) generalised forces about y and about k
    tau_y = (
        C_us * theta_dot + L_ddot * h_z + M_mixed * phi_ddot + M_theta * own_theta_ddot + bend * h2_x + g_k
            * w_n + gamma_n * w_k + phi_dot2 * (k13 * (J_yy - dJ_zx) - c7 * (0.5 - k33)) - C_s * (omega_x * y_x
            + omega_y * y_y + omega_z * y_z)
    )
    tau_k = (
        C_us * phi_dot + M_mixed * theta_ddot + M_mixed_theta * theta_dot2 + M_phi * own_phi_ddot + two_phi_dot
            * (L_dot * M_phi_L - theta_dot * (0.5 * J2_xz + J_xx * kappa - 0.5 * c6)) - C_s * (k_x * omega_x
            + k_y * omega_y + k_z * omega_z) - L_ddot * k3_h - bend * h2_y * k1 - gamma_n * w_y - gamma_y * w_n
    )
    # of the platform point, from free fall
    fall_x = c1 - g_x
    fall_y = c2 - g_y
    fall_z = c3 - g_z
    fall_T_x = fall_x * s_x + fall_y * s_y + fall_z * s_z
    fall_T_y = fall_x * y_x + fall_y * y_y + fall_z * y_z
    fall_T_z = fall_x * z_x + fall_y * z_y + fall_z * z_z
    row_v_yx = -inv_L * z_x
    row_v_yy = -inv_L * z_y
    row_v_yz = -inv_L * z_z
    row_v_zx = inv_rho * y_x
    row_v_zy = inv_rho * y_y
    row_v_zz = inv_rho * y_z
    c8 = m_u * L * L
    c9 = L * m_u
    out = JointRowsLeg()
    out.M_vv[0] = 0.0
    out.M_vv[1] = 0.0
    out.M_vv[2] = 0.0
    out.M_vv[3] = 0.0
    out.M_vv[4] = 0.0
    out.M_vv[5] = 0.0
    out.M_vw[0] = 0.0
    out.M_vw[1] = 0.0
    out.M_vw[2] = 0.0
    out.M_vw[3] = 0.0
    out.M_vw[4] = 0.0
    out.M_vw[5] = 0.0
    out.M_vw[6] = 0.0
    out.M_vw[7] = 0.0
    out.M_vw[8] = 0.0
    out.M_ww[0] = 0.0
    out.M_ww[1] = 0.0
    out.M_ww[2] = 0.0
    out.M_ww[3] = 0.0
    out.M_ww[4] = 0.0
    out.M_ww[5] = 0.0
    out.right_force[0] = 0.0
    out.right_force[1] = 0.0
    out.right_force[2] = 0.0
    out.right_moment[0] = C_s * (k_x * phi_dot + theta_dot * y_x)
    out.right_moment[1] = C_s * (k_y * phi_dot + theta_dot * y_y)
    out.right_moment[2] = C_s * (k_z * phi_dot + theta_dot * y_z)
    out.M_xi[0] = m_u
    out.M_xi[1] = h_z
    out.M_xi[2] = -k3_h
    out.M_xi[3] = M_theta + c8
    out.M_xi[4] = M_mixed
    out.M_xi[5] = M_phi + c4 * c8
    out.row_v[0] = s_x
    out.row_v[1] = s_y
    out.row_v[2] = s_z
    out.row_v[3] = row_v_yx
    out.row_v[4] = row_v_yy
    out.row_v[5] = row_v_yz
    out.row_v[6] = row_v_zx
    out.row_v[7] = row_v_zy
    out.row_v[8] = row_v_zz
    out.row_w[0] = q_y * s_z - q_z * s_y
    out.row_w[1] = q_z * s_x - q_x * s_z
    out.row_w[2] = q_x * s_y - q_y * s_x
    out.row_w[3] = q_y * row_v_yz - q_z * row_v_yy
    out.row_w[4] = q_z * row_v_yx - q_x * row_v_yz
    out.row_w[5] = q_x * row_v_yy - q_y * row_v_yx
    out.row_w[6] = q_y * row_v_zz - q_z * row_v_zy
    out.row_w[7] = q_z * row_v_zx - q_x * row_v_zz
    out.row_w[8] = q_x * row_v_zy - q_y * row_v_zx
    out.tau[0] = (
        C_p * L_dot + fall_T_x * m_u + h_z * theta_ddot - F - M_phi_L * phi_dot2 - h_x * theta_dot2 - k3_h * phi_ddot
    )
    out.tau[1] = tau_y - c9 * fall_T_z
    out.tau[2] = c9 * fall_T_y * k3 + tau_k
    out.q[0] = q_x
    out.q[1] = q_y
    out.q[2] = q_z
    out.L = L
    out.k3 = k3
    return out


def forward_more(on: Arithmetic, total: Any, more: Any) -> Any:
    """The sums with one part more."""
    out = ForwardSums()
    out.M_vv[0] = total.M_vv[0] + more.M_vv[0]
    out.M_vv[1] = total.M_vv[1] + more.M_vv[1]
    out.M_vv[2] = total.M_vv[2] + more.M_vv[2]
    out.M_vv[3] = total.M_vv[3] + more.M_vv[3]
    out.M_vv[4] = total.M_vv[4] + more.M_vv[4]
    out.M_vv[5] = total.M_vv[5] + more.M_vv[5]
    out.M_vw[0] = total.M_vw[0] + more.M_vw[0]
    out.M_vw[1] = total.M_vw[1] + more.M_vw[1]
    out.M_vw[2] = total.M_vw[2] + more.M_vw[2]
    out.M_vw[3] = total.M_vw[3] + more.M_vw[3]
    out.M_vw[4] = total.M_vw[4] + more.M_vw[4]
    out.M_vw[5] = total.M_vw[5] + more.M_vw[5]
    out.M_vw[6] = total.M_vw[6] + more.M_vw[6]
    out.M_vw[7] = total.M_vw[7] + more.M_vw[7]
    out.M_vw[8] = total.M_vw[8] + more.M_vw[8]
    out.M_ww[0] = total.M_ww[0] + more.M_ww[0]
    out.M_ww[1] = total.M_ww[1] + more.M_ww[1]
    out.M_ww[2] = total.M_ww[2] + more.M_ww[2]
    out.M_ww[3] = total.M_ww[3] + more.M_ww[3]
    out.M_ww[4] = total.M_ww[4] + more.M_ww[4]
    out.M_ww[5] = total.M_ww[5] + more.M_ww[5]
    out.right_force[0] = total.right_force[0] + more.right_force[0]
    out.right_force[1] = total.right_force[1] + more.right_force[1]
    out.right_force[2] = total.right_force[2] + more.right_force[2]
    out.right_moment[0] = total.right_moment[0] + more.right_moment[0]
    out.right_moment[1] = total.right_moment[1] + more.right_moment[1]
    out.right_moment[2] = total.right_moment[2] + more.right_moment[2]
    return out


def forward_total(on: Arithmetic, total: Any, more: Any) -> Any:
    """The sums with one part more."""
    out = ForwardSums()
    out.M_vv[0] = total.M_vv[0] + more.M_vv[0]
    out.M_vv[1] = total.M_vv[1] + more.M_vv[1]
    out.M_vv[2] = total.M_vv[2] + more.M_vv[2]
    out.M_vv[3] = total.M_vv[3] + more.M_vv[3]
    out.M_vv[4] = total.M_vv[4] + more.M_vv[4]
    out.M_vv[5] = total.M_vv[5] + more.M_vv[5]
    out.M_vw[0] = total.M_vw[0] + more.M_vw[0]
    out.M_vw[1] = total.M_vw[1] + more.M_vw[1]
    out.M_vw[2] = total.M_vw[2] + more.M_vw[2]
    out.M_vw[3] = total.M_vw[3] + more.M_vw[3]
    out.M_vw[4] = total.M_vw[4] + more.M_vw[4]
    out.M_vw[5] = total.M_vw[5] + more.M_vw[5]
    out.M_vw[6] = total.M_vw[6] + more.M_vw[6]
    out.M_vw[7] = total.M_vw[7] + more.M_vw[7]
    out.M_vw[8] = total.M_vw[8] + more.M_vw[8]
    out.M_ww[0] = total.M_ww[0] + more.M_ww[0]
    out.M_ww[1] = total.M_ww[1] + more.M_ww[1]
    out.M_ww[2] = total.M_ww[2] + more.M_ww[2]
    out.M_ww[3] = total.M_ww[3] + more.M_ww[3]
    out.M_ww[4] = total.M_ww[4] + more.M_ww[4]
    out.M_ww[5] = total.M_ww[5] + more.M_ww[5]
    out.right_force[0] = total.right_force[0] + more.right_force[0]
    out.right_force[1] = total.right_force[1] + more.right_force[1]
    out.right_force[2] = total.right_force[2] + more.right_force[2]
    out.right_moment[0] = total.right_moment[0] + more.right_moment[0]
    out.right_moment[1] = total.right_moment[1] + more.right_moment[1]
    out.right_moment[2] = total.right_moment[2] + more.right_moment[2]
    return out


def joint_rows_more(on: Arithmetic, total: Any, more: Any) -> Any:
    """The sums with one part more."""
    out = JointRowsSums()
    out.M_vv[0] = total.M_vv[0] + more.M_vv[0]
    out.M_vv[1] = total.M_vv[1] + more.M_vv[1]
    out.M_vv[2] = total.M_vv[2] + more.M_vv[2]
    out.M_vv[3] = total.M_vv[3] + more.M_vv[3]
    out.M_vv[4] = total.M_vv[4] + more.M_vv[4]
    out.M_vv[5] = total.M_vv[5] + more.M_vv[5]
    out.M_vw[0] = total.M_vw[0] + more.M_vw[0]
    out.M_vw[1] = total.M_vw[1] + more.M_vw[1]
    out.M_vw[2] = total.M_vw[2] + more.M_vw[2]
    out.M_vw[3] = total.M_vw[3] + more.M_vw[3]
    out.M_vw[4] = total.M_vw[4] + more.M_vw[4]
    out.M_vw[5] = total.M_vw[5] + more.M_vw[5]
    out.M_vw[6] = total.M_vw[6] + more.M_vw[6]
    out.M_vw[7] = total.M_vw[7] + more.M_vw[7]
    out.M_vw[8] = total.M_vw[8] + more.M_vw[8]
    out.M_ww[0] = total.M_ww[0] + more.M_ww[0]
    out.M_ww[1] = total.M_ww[1] + more.M_ww[1]
    out.M_ww[2] = total.M_ww[2] + more.M_ww[2]
    out.M_ww[3] = total.M_ww[3] + more.M_ww[3]
    out.M_ww[4] = total.M_ww[4] + more.M_ww[4]
    out.M_ww[5] = total.M_ww[5] + more.M_ww[5]
    out.right_force[0] = total.right_force[0] + more.right_force[0]
    out.right_force[1] = total.right_force[1] + more.right_force[1]
    out.right_force[2] = total.right_force[2] + more.right_force[2]
    out.right_moment[0] = total.right_moment[0] + more.right_moment[0]
    out.right_moment[1] = total.right_moment[1] + more.right_moment[1]
    out.right_moment[2] = total.right_moment[2] + more.right_moment[2]
    return out


def joint_rows_total(on: Arithmetic, total: Any, more: Any) -> Any:
    """The sums with one part more."""
    out = JointRowsSums()
    out.M_vv[0] = total.M_vv[0] + more.M_vv[0]
    out.M_vv[1] = total.M_vv[1] + more.M_vv[1]
    out.M_vv[2] = total.M_vv[2] + more.M_vv[2]
    out.M_vv[3] = total.M_vv[3] + more.M_vv[3]
    out.M_vv[4] = total.M_vv[4] + more.M_vv[4]
    out.M_vv[5] = total.M_vv[5] + more.M_vv[5]
    out.M_vw[0] = total.M_vw[0] + more.M_vw[0]
    out.M_vw[1] = total.M_vw[1] + more.M_vw[1]
    out.M_vw[2] = total.M_vw[2] + more.M_vw[2]
    out.M_vw[3] = total.M_vw[3] + more.M_vw[3]
    out.M_vw[4] = total.M_vw[4] + more.M_vw[4]
    out.M_vw[5] = total.M_vw[5] + more.M_vw[5]
    out.M_vw[6] = total.M_vw[6] + more.M_vw[6]
    out.M_vw[7] = total.M_vw[7] + more.M_vw[7]
    out.M_vw[8] = total.M_vw[8] + more.M_vw[8]
    out.M_ww[0] = total.M_ww[0] + more.M_ww[0]
    out.M_ww[1] = total.M_ww[1] + more.M_ww[1]
    out.M_ww[2] = total.M_ww[2] + more.M_ww[2]
    out.M_ww[3] = total.M_ww[3] + more.M_ww[3]
    out.M_ww[4] = total.M_ww[4] + more.M_ww[4]
    out.M_ww[5] = total.M_ww[5] + more.M_ww[5]
    out.right_force[0] = total.right_force[0] + more.right_force[0]
    out.right_force[1] = total.right_force[1] + more.right_force[1]
    out.right_force[2] = total.right_force[2] + more.right_force[2]
    out.right_moment[0] = total.right_moment[0] + more.right_moment[0]
    out.right_moment[1] = total.right_moment[1] + more.right_moment[1]
    out.right_moment[2] = total.right_moment[2] + more.right_moment[2]
    return out


def per_length_of(on: Arithmetic, extent: Any) -> Any:
    """By what moments are multiplied in the solve, 1/m: 1 for arms of about a metre, else one over the least power of two, from 2^-100 to 2^100, that is no smaller than the longest of them."""
    unit = 1.0
    for turn in range(100):
        unit = on.where(unit < extent, 2.0 * unit, unit)
    for turn in range(100):
        unit = on.where((extent > 0.0) & (0.5 * unit >= extent), 0.5 * unit, unit)
    return on.where((extent >= on.SMALLEST) & (extent <= on.LARGEST), 1.0, 1.0 / unit)


def prepare(on: Arithmetic, robot: Any) -> Any:
    """A robot's constants, prepared once; every number of the robot must be finite, else status says so."""
    robot = on.arrays(robot)
    model = Model()
    total = Added()
    for i in range(6):
        found = prepare_leg(on, robot, robot.leg[i])
        model.leg[i] = found
        total = add_up(on, total, found)
    model.platform = prepare_platform(on, robot, total)
    extent = 0.0
    for i in range(6):
        for j in range(3):
            extent = on.larger(on.size(model.leg[i].p[j] - model.leg[0].p[j]), extent)
    model.per_length = per_length_of(on, extent)
    model.status = on.where(lost_digits(on, model) == 0.0, OK, NOT_FINITE)
    return model


def fault_of(on: Arithmetic, L: Any, k3: Any, reach: Any) -> Any:
    """What is wrong with a leg: not finite, short beside the vectors that it is the sum of, or along k."""
    fault = on.where(k3 > on.POLE_SINE, OK, POLE)
    fault = on.where(L > on.larger(on.ROUNDING * reach, on.SHORTEST), fault, SHORT_LEG)
    return on.where(L <= on.MAX, fault, NOT_FINITE)


def reach_of(on: Arithmetic, leg: Any, motion: Any, q: Any) -> Any:
    """Size of the vectors that a leg is the sum of, m."""
    reach = 0.0
    for j in range(3):
        reach = (
            on.larger(on.larger(on.size(q[j]), on.larger(on.size(motion.t[j]), on.size(leg.b[j]))), reach)
        )
    return reach


def leg_of(on: Arithmetic, model: Any, i: Any, motion: Any, shared: Any) -> Any:
    """One leg, by the block that suits its distance from its joint singularity."""
    leg = leg_terms(on, model.leg[i], model.platform, motion, shared)
    near = leg.k3 <= on.NEAR_POLE
    if on.anywhere(near):
        other = leg_near_terms(on, model.leg[i], model.platform, motion, shared)
        leg = on.where(near, other, leg)
    return leg


def add_leg(on: Arithmetic, leg: Any, i: Any, shared: Any, sums: Any) -> None:
    """Adds a leg's column of H and its part of c, moments about platform point 1."""
    if i == 0:
        for j in range(3):
            sums.q_1[j] = leg.q[j]
        tip = shift(on, sums, shared)
        for j in range(3):
            sums.c_force[j] = shared.c_force[j] + leg.c_force[j]
            sums.c_moment[j] = tip.c_tip[j] + leg.c_moment[j]
    if i != 0:
        turned = moments_of(on, leg, sums)
        for j in range(3):
            sums.c_force[j] = sums.c_force[j] + leg.c_force[j]
            sums.c_moment[j] = sums.c_moment[j] + leg.c_moment[j] + turned.arm_c[j]
            sums.H[j + 3][i] = turned.H_moment[j]
            sums.arm[i][j] = leg.q[j] - sums.q_1[j]
    for j in range(3):
        sums.H[j][i] = leg.H_force[j]


def eliminate(on: Arithmetic, A: Any, x: Any) -> Any:
    """Solves [H | c] for x by elimination with partial pivoting, (36); returns 1 where a pivot is small."""
    suspect = 0
    for k in range(6):
        for i in range(k + 1, 6):
            larger_below = on.size(A[i][k]) > on.size(A[k][k])
            for j in range(k, 7):
                upper = A[k][j]
                A[k][j] = on.where(larger_below, A[i][j], A[k][j])
                A[i][j] = on.where(larger_below, upper, A[i][j])
        suspect = on.where(on.size(A[k][k]) > on.SUSPECT, suspect, 1)
        inverse = 1.0 / A[k][k]
        x[k] = inverse
        for i in range(k + 1, 6):
            factor = A[i][k] * inverse
            for j in range(k + 1, 7):
                A[i][j] = A[i][j] - factor * A[k][j]
    for i in range(5, -1, -1):
        total = A[i][6]
        for j in range(i + 1, 6):
            total = total - A[i][j] * x[j]
        x[i] = on.where(i == 5, total / A[i][i], total * x[i])
    return suspect


def singular_status(on: Arithmetic, H: Any, arm: Any, L: Any, reach: Any) -> Any:
    """Whether H is singular to rounding: OK, SINGULAR or NOT_FINITE; H is replaced. arm: of the moments; L: lengths of the legs; reach: size of the vectors that a leg is the sum of. The direction s of a leg errs by 4 epsilon (reach / L + 2) at most, its column of H, (s, arm x s), by that through Y_force + Y_moment x arm with Y the inverse of H, and by the rounding of the moment. Where H less its error is singular, no v > 0 has G v < v, G_ik what the error of column k does to row i of Y H: the spectral radius of G is 1 or more. Powers of G make v; 1/2 leaves room for the errors of Y itself."""
    Y = [[0.0] * 6 for _ in range(6)]
    G = [[0.0] * 6 for _ in range(6)]
    v = [0.0] * 6
    grown = [0.0] * 6
    extent = 0.0
    for i in range(6):
        v[i] = 1.0
        for j in range(3):
            extent = on.larger(on.size(arm[i][j]), extent)
    lost = 0.0
    for i in range(6):
        for j in range(6):
            lost = lost + 0.0 * H[i][j]
            H[i][j] = on.where(i < 3, H[i][j], H[i][j] / extent)
            Y[i][j] = on.where(i == j, 1.0, 0.0)
    for k in range(6):
        for i in range(k + 1, 6):
            larger_below = on.size(H[i][k]) > on.size(H[k][k])
            for j in range(6):
                upper_h = H[k][j]
                upper_y = Y[k][j]
                H[k][j] = on.where(larger_below, H[i][j], H[k][j])
                Y[k][j] = on.where(larger_below, Y[i][j], Y[k][j])
                H[i][j] = on.where(larger_below, upper_h, H[i][j])
                Y[i][j] = on.where(larger_below, upper_y, Y[i][j])
        for i in range(6):
            factor = on.where(i == k, 0.0, H[i][k] / H[k][k])
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
    least = 1.0
    for turn in range(4):
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
    return on.where(lost == 0.0, on.where(least <= 0.5, OK, SINGULAR), NOT_FINITE)


def forces(on: Arithmetic, model: Any, motion: Any) -> Any:
    """Actuator forces F, N, (37), and a status; where the status is not OK, F is NaN."""
    model = on.arrays(model)
    motion = on.arrays(motion)
    out = Forces()
    sums = Sums()
    A = [[0.0] * 7 for _ in range(6)]
    D = [0.0] * 6
    L = [0.0] * 6
    reach = [0.0] * 6
    x = [0.0] * 6
    status = model.status
    suspect = 0
    shared = shared_terms(on, model.platform, motion)
    for i in range(6):
        leg = leg_of(on, model, i, motion, shared)
        reach[i] = reach_of(on, model.leg[i], motion, leg.q)
        fault = fault_of(on, leg.L, leg.k3, reach[i])
        status = on.where(status == OK, fault, status)
        suspect = on.where(leg.L > on.SHORT_SHARE * reach[i], suspect, 1)
        L[i] = leg.L
        D[i] = leg.D
        add_leg(on, leg, i, shared, sums)
    for i in range(3):
        A[i][6] = sums.c_force[i]
        A[i + 3][6] = sums.c_moment[i] * model.per_length
        for j in range(6):
            A[i][j] = sums.H[i][j]
            A[i + 3][j] = sums.H[i + 3][j] * model.per_length
    small_pivot = eliminate(on, A, x)
    suspect = on.where(small_pivot == 0, suspect, 1)
    if on.anywhere(suspect == 1):
        found = singular_status(on, sums.H, sums.arm, L, reach)
        status = on.where((status == OK) & (suspect == 1), found, status)
    for i in range(6):
        out.F[i] = D[i] - x[i]
        status = on.where((status != OK) | (on.size(out.F[i]) <= on.MAX), status, NOT_FINITE)
    for i in range(6):
        out.F[i] = on.where(status == OK, out.F[i], on.NAN)
    out.status = status
    return out


def place_symmetric(on: Arithmetic, parts: Any, first: Any, M: Any) -> None:
    """A symmetric 3 x 3 block on the diagonal, from xx xy xz yy yz zz."""
    M[first][first] = parts[0]
    M[first][first + 1] = parts[1]
    M[first][first + 2] = parts[2]
    M[first + 1][first] = parts[1]
    M[first + 1][first + 1] = parts[3]
    M[first + 1][first + 2] = parts[4]
    M[first + 2][first] = parts[2]
    M[first + 2][first + 1] = parts[4]
    M[first + 2][first + 2] = parts[5]


def place_inertia(on: Arithmetic, vv: Any, vw: Any, ww: Any, M: Any) -> None:
    """M from its parts: symmetric ones as xx xy xz yy yz zz."""
    for i in range(3):
        for j in range(3):
            M[i][j + 3] = vw[3 * i + j]
            M[j + 3][i] = vw[3 * i + j]
    place_symmetric(on, vv, 0, M)
    place_symmetric(on, ww, 3, M)


def equations(on: Arithmetic, model: Any, motion: Any) -> Any:
    """M, C, g, friction and bias of M [a; alpha] + C [v; omega] + g + friction = H F + external wrench."""
    model = on.arrays(model)
    motion = on.arrays(motion)
    out = Equations()
    total = EquationsSums()
    close = EquationsSums()
    status = model.status
    leaning = 0
    pose = equations_pose(on, model.platform, motion)
    for i in range(6):
        leg = equations_leg(on, model.leg[i], model.platform, motion)
        fault = fault_of(on, leg.L, leg.k3, reach_of(on, model.leg[i], motion, leg.q))
        status = on.where(status == OK, fault, status)
        leaning = on.where(leg.k3 < on.LEANING, 1, leaning)
        total = equations_more(on, total, leg)
        for j in range(3):
            out.H[j][i] = leg.H_force[j]
            out.H[j + 3][i] = leg.H_moment[j]
    if on.anywhere(leaning == 1):
        for i in range(6):
            near = equations_near(on, model.leg[i], model.platform, motion)
            close = equations_more(on, close, near)
        total = on.where(leaning == 1, close, total)
    sums = equations_total(on, total, pose)
    for i in range(3):
        out.g[i] = sums.g_force[i]
        out.g[i + 3] = sums.g_moment[i]
        out.friction[i] = sums.friction_force[i]
        out.friction[i + 3] = sums.friction_moment[i]
        for j in range(3):
            out.C[i][j] = sums.C_vv[3 * i + j]
            out.C[i][j + 3] = sums.C_vw[3 * i + j]
            out.C[i + 3][j] = sums.C_wv[3 * i + j]
            out.C[i + 3][j + 3] = sums.C_ww[3 * i + j]
    place_inertia(on, sums.M_vv, sums.M_vw, sums.M_ww, out.M)
    for i in range(6):
        coriolis = 0.0
        for j in range(3):
            coriolis = coriolis + out.C[i][j] * motion.v[j]
        for j in range(3):
            coriolis = coriolis + out.C[i][j + 3] * motion.omega[j]
        out.bias[i] = out.g[i] + out.friction[i] + coriolis
        lost = 0.0 * out.bias[i]
        for j in range(6):
            lost = lost + 0.0 * out.M[i][j]
        status = on.where((status != OK) | (lost == 0.0), status, NOT_FINITE)
    for i in range(6):
        out.g[i] = on.where(status == OK, out.g[i], on.NAN)
        out.friction[i] = on.where(status == OK, out.friction[i], on.NAN)
        out.bias[i] = on.where(status == OK, out.bias[i], on.NAN)
        for j in range(6):
            out.M[i][j] = on.where(status == OK, out.M[i][j], on.NAN)
            out.C[i][j] = on.where(status == OK, out.C[i][j], on.NAN)
            out.H[i][j] = on.where(status == OK, out.H[i][j], on.NAN)
    out.status = status
    return out


def solve_definite(on: Arithmetic, M: Any, x: Any, kept: Any) -> Any:
    """x of M x = x by L D L^T; INDEFINITE where a pivot is not more than ``kept`` of its diagonal number."""
    scale = [0.0] * 6
    status = OK
    for k in range(6):
        scale[k] = M[k][k]
    for k in range(6):
        fault = on.where(on.size(M[k][k]) <= on.MAX, INDEFINITE, NOT_FINITE)
        fault = on.where(M[k][k] > kept * scale[k], OK, fault)
        status = on.where(status == OK, fault, status)
        inverse = 1.0 / M[k][k]
        for i in range(k + 1, 6):
            factor = M[i][k] * inverse
            for j in range(k + 1, 6):
                M[i][j] = M[i][j] - factor * M[k][j]
            x[i] = x[i] - factor * x[k]
    for k in range(5, -1, -1):
        for j in range(k + 1, 6):
            x[k] = x[k] - M[k][j] * x[j]
        x[k] = x[k] / M[k][k]
    return status


def weigh(on: Arithmetic, inertia: Any, extent: Any, weight: Any) -> None:
    """Inertia of three coordinates, xx xy xz yy yz zz, as weights of rows of these sizes."""
    weight[0][0] = inertia[0] / extent[0] / extent[0]
    weight[0][1] = inertia[1] / extent[0] / extent[1]
    weight[0][2] = inertia[2] / extent[0] / extent[2]
    weight[1][0] = inertia[1] / extent[1] / extent[0]
    weight[1][1] = inertia[3] / extent[1] / extent[1]
    weight[1][2] = inertia[4] / extent[1] / extent[2]
    weight[2][0] = inertia[2] / extent[2] / extent[0]
    weight[2][1] = inertia[4] / extent[2] / extent[1]
    weight[2][2] = inertia[5] / extent[2] / extent[2]


def make_rows(on: Arithmetic, sums: Any, by: Any) -> None:
    """Rows and weights: each row of A carries the root of its inertia, so that weights are of about one."""
    mass = sums.M_vv[0]
    c = [0.0] * 3
    about = [0.0] * 6
    whole = [0.0] * 6
    heaviest = on.size(mass)
    length = 0.0
    for i in range(6):
        rho = by.leg[i].L * by.leg[i].k3
        for j in range(3):
            length = on.larger(on.size(by.leg[i].row_w[j]), length)
        heaviest = on.larger(on.size(by.leg[i].M_xi[3]) / by.leg[i].L / by.leg[i].L, heaviest)
        heaviest = on.larger(on.size(by.leg[i].M_xi[5]) / rho / rho, heaviest)
    least = on.larger(on.EPSILON * on.sqrt(heaviest), on.SHORTEST)
    by.length = on.where(length > 0.0, length, 1.0)
    for i in range(6):
        reach = least * by.leg[i].L
        theta = on.larger(on.sqrt(on.size(by.leg[i].M_xi[3])), reach)
        phi = on.larger(on.sqrt(on.size(by.leg[i].M_xi[5])), reach * by.leg[i].k3)
        along = on.larger(on.size(by.leg[i].M_xi[1]) / theta, on.size(by.leg[i].M_xi[2]) / phi)
        along = on.larger(along, on.sqrt(on.size(by.leg[i].M_xi[0])))
        by.block[i].extent[0] = on.larger(along, least)
        by.block[i].extent[1] = theta
        by.block[i].extent[2] = phi
        weigh(on, by.leg[i].M_xi, by.block[i].extent, by.block[i].weight)
        for j in range(3):
            for k in range(3):
                by.row[3 * i + j][k] = by.block[i].extent[j] * by.leg[i].row_v[3 * j + k]
                by.row[3 * i + j][k + 3] = by.block[i].extent[j] * (by.leg[i].row_w[3 * j + k] / by.length)
    heft = on.larger(on.sqrt(on.size(mass)), least)
    per_mass = on.where(mass > 0.0, 1.0 / mass, 0.0)
    c[0] = sums.M_vw[5] * per_mass
    c[1] = -sums.M_vw[2] * per_mass
    c[2] = sums.M_vw[1] * per_mass
    square = c[0] * c[0] + c[1] * c[1] + c[2] * c[2]
    about[0] = sums.M_ww[0] - mass * (square - c[0] * c[0])
    about[1] = sums.M_ww[1] + mass * (c[0] * c[1])
    about[2] = sums.M_ww[2] + mass * (c[0] * c[2])
    about[3] = sums.M_ww[3] - mass * (square - c[1] * c[1])
    about[4] = sums.M_ww[4] + mass * (c[1] * c[2])
    about[5] = sums.M_ww[5] - mass * (square - c[2] * c[2])
    whole[0] = mass
    whole[3] = mass
    whole[5] = mass
    by.block[7].extent[0] = on.larger(on.sqrt(on.size(about[0])), least * by.length)
    by.block[7].extent[1] = on.larger(on.sqrt(on.size(about[3])), least * by.length)
    by.block[7].extent[2] = on.larger(on.sqrt(on.size(about[5])), least * by.length)
    for i in range(3):
        by.block[6].extent[i] = heft
        by.row[18 + i][i] = heft
        by.row[21 + i][i + 3] = by.block[7].extent[i] / by.length
    by.row[18][4] = heft * (c[2] / by.length)
    by.row[18][5] = -heft * (c[1] / by.length)
    by.row[19][5] = heft * (c[0] / by.length)
    by.row[19][3] = -heft * (c[2] / by.length)
    by.row[20][3] = heft * (c[1] / by.length)
    by.row[20][4] = -heft * (c[0] / by.length)
    weigh(on, whole, by.block[6].extent, by.block[6].weight)
    weigh(on, about, by.block[7].extent, by.block[7].weight)


def pick_rows(on: Arithmetic, by: Any) -> None:
    """Picks six rows as coordinates by elimination with complete pivoting; the others are sums of them. ``chosen``: 1 of a row that was picked, else 0; ``pivot``, ``column``: number of the row picked and of the column exchanged with it; ``factors``: L and U of the six."""
    for k in range(6):
        by.column[k] = k
    for k in range(6):
        best = -1.0
        row = 0
        across = 0
        for i in range(24):
            for j in range(k, 6):
                entry = on.where(by.chosen[i] > 0.0, -1.0, on.size(by.row[i][j]))
                row = on.where(entry > best, i, row)
                across = on.where(entry > best, j, across)
                best = on.larger(entry, best)
        held = by.column[k]
        for j in range(k + 1, 6):
            by.column[k] = on.where(across == j, by.column[j], by.column[k])
            by.column[j] = on.where(across == j, held, by.column[j])
            for i in range(24):
                moved = by.row[i][k]
                by.row[i][k] = on.where(across == j, by.row[i][j], by.row[i][k])
                by.row[i][j] = on.where(across == j, moved, by.row[i][j])
            for i in range(k):
                moved_up = by.factors[i][k]
                by.factors[i][k] = on.where(across == j, by.factors[i][j], by.factors[i][k])
                by.factors[i][j] = on.where(across == j, moved_up, by.factors[i][j])
        for i in range(24):
            by.chosen[i] = on.where(row == i, 1.0, by.chosen[i])
            by.place[k][i] = on.where(row == i, 1.0, 0.0)
            for j in range(6):
                by.factors[k][j] = on.where(row == i, by.row[i][j], by.factors[k][j])
        for i in range(24):
            factor = by.row[i][k] / by.factors[k][k]
            by.row[i][k] = on.where(by.chosen[i] > 0.0, by.row[i][k], factor)
            for j in range(k + 1, 6):
                less = by.row[i][j] - factor * by.factors[k][j]
                by.row[i][j] = on.where(by.chosen[i] > 0.0, by.row[i][j], less)
    for i in range(24):
        for j in range(5, -1, -1):
            part = by.row[i][j]
            for k in range(j + 1, 6):
                part = part - by.share[i][k] * by.factors[k][j]
            by.share[i][j] = part
        for j in range(6):
            by.share[i][j] = on.where(by.chosen[i] > 0.0, by.place[j][i], by.share[i][j])


def balance_rows(on: Arithmetic, by: Any, force: Any, moved: Any, balanced: Any) -> None:
    """Accelerations of the coordinates' rows under which each block balances their forces. ``balanced``: 1 of these rows, without those that have no inertia of their own beside the rows before them, else 0; ``moved`` is 0 of all others."""
    W = [[0.0] * 3 for _ in range(3)]
    for i in range(24):
        moved[i] = force[i]
    for b in range(8):
        for i in range(3):
            for j in range(3):
                W[i][j] = by.block[b].weight[i][j]
        for k in range(3):
            heavy = on.where(W[k][k] > on.KEPT, 1.0, 0.0)
            balanced[3 * b + k] = heavy * by.chosen[3 * b + k]
            pivot = on.where(balanced[3 * b + k] > 0.0, W[k][k], 1.0)
            for i in range(k + 1, 3):
                factor = balanced[3 * b + k] * W[i][k] / pivot
                moved[3 * b + i] = moved[3 * b + i] - factor * moved[3 * b + k]
                for j in range(k + 1, 3):
                    W[i][j] = W[i][j] - factor * W[k][j]
        for k in range(2, -1, -1):
            for j in range(k + 1, 3):
                moved[3 * b + k] = moved[3 * b + k] - W[k][j] * moved[3 * b + j]
            divisor = on.where(balanced[3 * b + k] > 0.0, W[k][k], 1.0)
            moved[3 * b + k] = on.where(balanced[3 * b + k] > 0.0, moved[3 * b + k] / divisor, 0.0)


def solve_rows(on: Arithmetic, sums: Any, by: Any, out: Any) -> None:
    """Solves for the accelerations of the six coordinates, from those that balance their own forces."""
    force = [0.0] * 24
    balanced = [0.0] * 24
    start = [0.0] * 6
    moved = [0.0] * 24
    rest = [0.0] * 24
    wrench = [0.0] * 6
    y = [0.0] * 6
    inertia = [[0.0] * 6 for _ in range(6)]
    for i in range(6):
        for j in range(3):
            force[3 * i + j] = by.leg[i].tau[j] / by.block[i].extent[j]
    for i in range(3):
        wrench[i] = sums.right_force[i]
        wrench[i + 3] = sums.right_moment[i] / by.length
    balance_rows(on, by, force, moved, balanced)
    for k in range(6):
        for i in range(24):
            start[k] = on.where(by.place[k][i] > 0.0, moved[i], start[k])
        for j in range(6):
            y[k] = on.where(by.column[k] == j, wrench[j], y[k])
    for i in range(24):
        moved[i] = 0.0
        for k in range(6):
            moved[i] = moved[i] + by.share[i][k] * start[k]
    for b in range(8):
        for i in range(3):
            rest[3 * b + i] = on.where(balanced[3 * b + i] > 0.0, 0.0, force[3 * b + i])
            for j in range(3):
                less = rest[3 * b + i] - by.block[b].weight[i][j] * moved[3 * b + j]
                own = (balanced[3 * b + i] > 0.0) & (balanced[3 * b + j] > 0.0)
                rest[3 * b + i] = on.where(own, rest[3 * b + i], less)
    for k in range(6):
        for j in range(k):
            y[k] = y[k] - by.factors[j][k] * y[j]
        y[k] = y[k] / by.factors[k][k]
    for k in range(5, -1, -1):
        for j in range(k + 1, 6):
            y[k] = y[k] - by.factors[j][k] * y[j]
    for k in range(6):
        for i in range(24):
            y[k] = y[k] - by.share[i][k] * rest[i]
    for b in range(8):
        for i in range(3):
            for j in range(3):
                for k in range(6):
                    weighed = by.share[3 * b + i][k] * by.block[b].weight[i][j]
                    for n in range(6):
                        inertia[k][n] = inertia[k][n] + weighed * by.share[3 * b + j][n]
    out.status = solve_definite(on, inertia, y, on.ROUNDING)
    for k in range(6):
        y[k] = y[k] - start[k]
        for j in range(k):
            y[k] = y[k] - by.factors[k][j] * y[j]
    for k in range(5, -1, -1):
        for j in range(k + 1, 6):
            y[k] = y[k] - by.factors[k][j] * y[j]
        y[k] = y[k] / by.factors[k][k]
    for k in range(6):
        for j in range(6):
            unit = on.where(j < 3, 1.0, by.length)
            out.x[j] = on.where(by.column[k] == j, y[k] / unit, out.x[j])


def forward_apart(on: Arithmetic, model: Any, motion: Any, F: Any) -> Any:
    """Forward dynamics in the accelerations of the six stiffest rows."""
    out = Apart()
    by = Rows()
    total = JointRowsSums()
    pose = joint_rows_pose(on, model.platform, motion)
    for i in range(6):
        by.leg[i] = joint_rows_leg(on, model.leg[i], model.platform, motion, pose, F[i])
        total = joint_rows_more(on, total, by.leg[i])
    sums = joint_rows_total(on, total, pose)
    make_rows(on, sums, by)
    pick_rows(on, by)
    solve_rows(on, sums, by, out)
    return out


def forward_dynamics(on: Arithmetic, model: Any, motion: Any, F: Any) -> Any:
    """Accelerations a and alpha of the platform under the actuator forces F, N; a and alpha are not read."""
    model = on.arrays(model)
    motion = on.arrays(motion)
    F = on.arrays(F)
    out = Accelerations()
    total = ForwardSums()
    M = [[0.0] * 6 for _ in range(6)]
    x = [0.0] * 6
    status = model.status
    pose = forward_pose(on, model.platform, motion)
    for i in range(6):
        leg = forward_leg(on, model.leg[i], model.platform, motion, pose, F[i])
        fault = fault_of(on, leg.L, leg.k3, reach_of(on, model.leg[i], motion, leg.q))
        status = on.where(status == OK, fault, status)
        total = forward_more(on, total, leg)
    sums = forward_total(on, total, pose)
    place_inertia(on, sums.M_vv, sums.M_vw, sums.M_ww, M)
    for i in range(3):
        x[i] = sums.right_force[i]
        x[i + 3] = sums.right_moment[i]
    lost = solve_definite(on, M, x, on.KEPT)
    if on.anywhere((status == OK) & (lost == INDEFINITE)):
        apart = forward_apart(on, model, motion, F)
        for i in range(6):
            x[i] = on.where(lost == INDEFINITE, apart.x[i], x[i])
        lost = on.where(lost == INDEFINITE, apart.status, lost)
    status = on.where(status == OK, lost, status)
    for i in range(6):
        status = on.where((status != OK) | (on.size(x[i]) <= on.MAX), status, NOT_FINITE)
    for i in range(3):
        out.a[i] = on.where(status == OK, x[i], on.NAN)
        out.alpha[i] = on.where(status == OK, x[i + 3], on.NAN)
    out.status = status
    return out



def motion_of(on: Arithmetic, **fields: Any) -> Motion:
    """A motion from arrays: R (..., 9) or (..., 3, 3), t, omega, v, alpha, a, F_ext, M_ext (..., 3).

    What is not given is zero; all share their leading shape. Raises ValueError for other names and shapes.
    """
    made = Motion()
    for name, value in fields.items():
        if name not in vars(made):
            raise ValueError(f"{name}: expected one of {', '.join(vars(made))}")
        array = on.xp.asarray(value, dtype=on.type)
        if name == "R" and tuple(array.shape[-2:]) == (3, 3):
            array = on.xp.reshape(array, (*array.shape[:-2], 9))
        count = len(getattr(made, name))
        if array.ndim == 0 or array.shape[-1] != count:
            raise ValueError(f"{name}: expected shape (..., {count}), got {tuple(array.shape)}")
        setattr(made, name, [array[..., i] for i in range(count)])
    return made
