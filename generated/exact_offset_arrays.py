"""Dynamics of a Gough-Stewart platform on arrays of the array API: NumPy, JAX, PyTorch, and others.

Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
SPDX-License-Identifier: 0BSD

Each number of a structure may be an array with one value per pose, so the component is the first index: ``F`` is
a list of six. An array instead of such a list has the components last, (..., 6). ``on`` is the arithmetic:
selections, square roots, and constants. If a status is not 0, the other numbers of a result are NaN.
"""

from typing import Any

from .arithmetic import NOT_FINITE, OK, Arithmetic
from .exact_arrays import (
    Added, Forces, LegTerms, MomentTerms, Motion, Sums, add_up, cube_of, fault_of, largest_component,
    moments_of, per_length_of, reach_of, shared_terms, shift, singular_status, size_of, solve_legs,
)


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
        # kg: reflected mass J_r N^2 of the rotor with inertia J_r (kg m^2) and transmission N (rad/m)
        self.m_r: Any = 0.0
        self.j_r: Any = 0.0  # kg m: angular momentum J_r N of the rotor per length rate
        self.cross: Any = 0.0  # m: offset from the fixed to the moving axis, along o = y x k
        self.along: Any = 0.0  # m: offset along y from o to the line of sliding
        self.across: Any = 0.0  # m: offset from the moving axis to the line of sliding, along z = s x y
        self.cross_mass: Any = 0.0  # kg: mass of the body between fixed and moving axis
        # m: center of mass of this body from the base point, along o, y, and k
        self.cross_center: Any = [0.0] * 3
        self.cross_inertia: Any = 0.0  # kg m^2: inertia of this body about its center of mass, axis k


class Robot:
    """The machine."""

    def __init__(self) -> None:
        self.M: Any = 0.0  # kg: mass of the platform with its payload
        self.R_0: Any = [0.0] * 3  # m: center of mass of the platform, platform frame
        # kg m^2: inertia of the platform about its center of mass, platform frame
        self.I_p: Any = [0.0] * 6
        self.g: Any = [0.0] * 3  # m/s^2: acceleration due to gravity, base frame
        self.leg: Any = [Leg() for _ in range(6)]  # the legs


class LegConstants:
    """Prepared constants of one leg."""

    def __init__(self) -> None:
        self.b: Any = [0.0] * 3  # m: base point, base frame
        self.p: Any = [0.0] * 3  # m: platform point, platform frame
        self.k: Any = [0.0] * 3  # 1: unit vector along the fixed axis of the universal joint, base frame
        self.C_p: Any = 0.0  # N s/m: viscous friction of the prismatic joint
        self.C_s: Any = 0.0  # N m s: viscous friction of the spherical joint
        # kg: reflected mass J_r N^2 of the rotor with inertia J_r (kg m^2) and transmission N (rad/m)
        self.m_r: Any = 0.0
        self.j_r: Any = 0.0  # kg m: angular momentum J_r N of the rotor per length rate
        self.h: Any = [0.0] * 3  # kg m: first moment of the upper part about the platform point, leg frame
        self.h2_x: Any = 0.0  # kg m: 2 h_x
        self.h2_y: Any = 0.0  # kg m: 2 h_y
        self.h2_z: Any = 0.0  # kg m: 2 h_z
        # kg m: sum m_d r_d0 + m_u r_u0 of the first moments of both parts, leg frame
        self.w: Any = [0.0] * 3
        # kg m^2: sum of the inertias of the lower part about the base point and the upper part about the platform point, leg frame
        self.J: Any = [0.0] * 6
        self.J2_xz: Any = 0.0  # kg m^2: 2 J_xz
        self.dJ_zx: Any = 0.0  # kg m^2: J_zz - J_xx
        self.g_k: Any = 0.0  # m/s^2: component of g along the fixed axis k
        self.g_x_k: Any = [0.0] * 3  # m/s^2: g x k, base frame
        self.C_us: Any = 0.0  # N m s: C_u + C_s
        self.cross: Any = 0.0  # m: offset from the fixed to the moving axis, along o = y x k
        self.along: Any = 0.0  # m: offset along y from o to the line of sliding
        self.across: Any = 0.0  # m: offset from the moving axis to the line of sliding, along z = s x y
        self.across2: Any = 0.0  # m^2: across^2
        self.along2: Any = 0.0  # m^2: along^2
        self.cross2: Any = 0.0  # m: 2 cross
        self.w_o: Any = 0.0  # kg m: first moment along o of the bodies that rotate about k only
        self.M_add: Any = 0.0  # kg: mass of the leg that is added to the platform
        # kg m: first moment of the mass M_add about platform point 1, platform frame
        self.h_add: Any = [0.0] * 3
        # kg m^2: inertia of the mass M_add about platform point 1, platform frame
        self.J_add: Any = [0.0] * 6
        self.C_add: Any = 0.0  # N m s: friction of the leg's spherical joint


class Platform:
    """Constants of the platform."""

    def __init__(self) -> None:
        self.M_P: Any = 0.0  # kg: M plus the masses m_u of all legs (massless legs: M)
        # m: center of mass of M_P, with the masses m_u at the platform points (massless legs: R_0), platform frame
        self.r_C: Any = [0.0] * 3
        self.J_C: Any = [0.0] * 6  # kg m^2: inertia of the mass M_P about r_C, platform frame
        self.dJ_C: Any = [0.0] * 3  # kg m^2: J_C_zz - J_C_yy, J_C_xx - J_C_zz, J_C_yy - J_C_xx
        self.C_P: Any = 0.0  # N m s: sum of C_s of all legs
        self.g: Any = [0.0] * 3  # m/s^2: acceleration due to gravity, base frame


class Model:
    """A robot's constants, prepared once."""

    def __init__(self) -> None:
        self.leg: Any = [LegConstants() for _ in range(6)]  # the legs
        self.platform: Any = Platform()  # the platform
        self.per_length: Any = 0.0  # 1/m: one over the length over which moments are taken
        self.arm_cube: Any = 0.0  # cube of the largest arm over that length
        self.status: Any = 0  # 0, or the code of an error


def prepare_leg(on: Arithmetic, robot: Any, p_1: Any, leg: Any) -> Any:
    """Constants of one leg, and its contributions to the constants of the platform: 126 (70 mul, 54 add,
    1 div, 1 sqrt).
    """
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    m_d = leg.m_d
    r_d0_x, r_d0_y, r_d0_z = leg.r_d0
    I_d0_xx, I_d0_xy, I_d0_xz, I_d0_yy, I_d0_yz, I_d0_zz = leg.I_d0
    m_u = leg.m_u
    r_u0_x, r_u0_y, r_u0_z = leg.r_u0
    I_u0_xx, I_u0_xy, I_u0_xz, I_u0_yy, I_u0_yz, I_u0_zz = leg.I_u0
    C_u, C_p, C_s, m_r, j_r = leg.C_u, leg.C_p, leg.C_s, leg.m_r, leg.j_r
    g_x, g_y, g_z = robot.g
    cross, along, across, cross_mass = leg.cross, leg.along, leg.across, leg.cross_mass
    cross_center_x, cross_center_y = leg.cross_center[0], leg.cross_center[1]
    cross_inertia = leg.cross_inertia
    p_1_x, p_1_y, p_1_z = p_1[0], p_1[1], p_1[2]
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
    own_w_y = c4 + h_y
    w_z = h_z + m_d * r_d0_z
    c5 = r_d0_y * r_d0_y
    c6 = r_d0_z * r_d0_z
    c7 = r_u0_y * r_u0_y
    c8 = r_u0_z * r_u0_z
    own_J_xx = I_d0_xx + I_u0_xx + m_d * (c5 + c6) + m_u * (c7 + c8)
    J_xy = I_d0_xy + I_u0_xy - c1 * r_u0_y - c3 * r_d0_y
    own_J_xz = I_d0_xz + I_u0_xz - c1 * r_u0_z - c3 * r_d0_z
    c9 = r_d0_x * r_d0_x
    c10 = r_u0_x * r_u0_x
    own_J_yy = I_d0_yy + I_u0_yy + m_d * (c6 + c9) + m_u * (c10 + c8)
    own_J_yz = I_d0_yz + I_u0_yz - c2 * r_u0_z - c4 * r_d0_z
    own_J_zz = I_d0_zz + I_u0_zz + m_d * (c5 + c9) + m_u * (c10 + c7)
    # platform point from platform point 1
    arm_x = p_x - p_1_x
    arm_y = p_y - p_1_y
    arm_z = p_z - p_1_z
    c11 = 2.0 * h_y
    # inertia about k of the bodies that rotate about k only
    I_k = (cross_inertia + m_d * cross * cross + along * c11 + cross_mass * (cross_center_x * cross_center_x
        + cross_center_y * cross_center_y))
    c12 = 2.0 * h_z
    c13 = across * c12
    # with the terms of the offsets and of the body between the axes
    J_xx = c13 + I_k + own_J_xx
    J_xz = own_J_xz - across * h_x
    J_yy = c13 + own_J_yy
    J_yz = own_J_yz - across * h_y
    J_zz = I_k + own_J_zz
    w_y = cross_center_y * cross_mass + own_w_y
    c14 = arm_x * m_u
    c15 = arm_y * m_u
    c16 = arm_y * arm_y
    c17 = arm_z * arm_z
    c18 = arm_x * arm_x
    out = LegConstants()
    out.b = [b_x, b_y, b_z]
    out.p = [p_x, p_y, p_z]
    out.k = [k_unit_x, k_unit_y, k_unit_z]
    out.C_p = C_p
    out.C_s = C_s
    out.m_r = m_r
    out.j_r = j_r
    out.h = [h_x, h_y, h_z]
    out.h2_x = 2.0 * h_x
    out.h2_y = c11
    out.h2_z = c12
    out.w = [w_x, w_y, w_z]
    out.J = [J_xx, J_xy, J_xz, J_yy, J_yz, J_zz]
    out.J2_xz = 2.0 * J_xz
    out.dJ_zx = J_zz - J_xx
    out.g_k = g_x * k_unit_x + g_y * k_unit_y + g_z * k_unit_z
    out.g_x_k = [
        g_y * k_unit_z - g_z * k_unit_y,
        g_z * k_unit_x - g_x * k_unit_z,
        g_x * k_unit_y - g_y * k_unit_x,
    ]
    out.C_us = C_s + C_u
    out.cross = cross
    out.along = along
    out.across = across
    out.across2 = across * across
    out.along2 = along * along
    out.cross2 = 2.0 * cross
    out.w_o = cross * m_d + cross_center_x * cross_mass
    out.M_add = m_u
    out.h_add = [c14, c15, arm_z * m_u]
    out.J_add = [
        m_u * (c16 + c17),
        -arm_y * c14,
        -arm_z * c14,
        m_u * (c17 + c18),
        -arm_z * c15,
        m_u * (c16 + c18),
    ]
    out.C_add = C_s
    return out


def prepare_platform(on: Arithmetic, robot: Any, p_1: Any, total: Any) -> Any:
    """Constants of the platform: 82 (38 mul, 43 add, 1 div, 0 sqrt)."""
    M = robot.M
    R_0_x, R_0_y, R_0_z = robot.R_0
    I_p_xx, I_p_xy, I_p_xz, I_p_yy, I_p_yz, I_p_zz = robot.I_p
    g_x, g_y, g_z = robot.g
    M_add = total.M_add
    h_add_x, h_add_y, h_add_z = total.h_add
    J_add_xx, J_add_xy, J_add_xz, J_add_yy, J_add_yz, J_add_zz = total.J_add
    C_add = total.C_add
    p_1_x, p_1_y, p_1_z = p_1[0], p_1[1], p_1[2]
    M_P = M + M_add
    # center of mass of the platform without the upper parts, from platform point 1
    arm_x = R_0_x - p_1_x
    arm_y = R_0_y - p_1_y
    arm_z = R_0_z - p_1_z
    # first moment of the lumped masses about this center
    e_x = h_add_x - M_add * arm_x
    e_y = h_add_y - M_add * arm_y
    e_z = h_add_z - M_add * arm_z
    # first moment about the reference point
    h_P_x = h_add_x + M * R_0_x + M_add * p_1_x
    h_P_y = h_add_y + M * R_0_y + M_add * p_1_y
    h_P_z = h_add_z + M * R_0_z + M_add * p_1_z
    c1 = 1.0 / M_P
    r_C_x = c1 * h_P_x
    r_C_y = c1 * h_P_y
    r_C_z = c1 * h_P_z
    r_x = c1 * h_add_x
    r_y = c1 * h_add_y
    r_z = c1 * h_add_z
    c2 = 0.5 * M * c1
    u_x = c2 * (h_add_x + e_x)
    u_y = c2 * (h_add_y + e_y)
    u_z = c2 * (h_add_z + e_z)
    c3 = h_add_z * r_z + 2.0 * arm_z * u_z
    c4 = h_add_y * r_y + 2.0 * arm_y * u_y
    J_C_xx = I_p_xx + J_add_xx - c3 - c4
    J_C_xy = I_p_xy + J_add_xy + h_add_x * r_y + arm_x * u_y + arm_y * u_x
    J_C_xz = I_p_xz + J_add_xz + h_add_x * r_z + arm_x * u_z + arm_z * u_x
    c5 = h_add_x * r_x + 2.0 * arm_x * u_x
    J_C_yy = I_p_yy + J_add_yy - c3 - c5
    J_C_yz = I_p_yz + J_add_yz + h_add_y * r_z + arm_y * u_z + arm_z * u_y
    J_C_zz = I_p_zz + J_add_zz - c4 - c5
    out = Platform()
    out.M_P = M_P
    out.r_C = [r_C_x, r_C_y, r_C_z]
    out.J_C = [J_C_xx, J_C_xy, J_C_xz, J_C_yy, J_C_yz, J_C_zz]
    out.dJ_C = [J_C_zz - J_C_yy, J_C_xx - J_C_zz, J_C_yy - J_C_xx]
    out.C_P = C_add
    out.g = [g_x, g_y, g_z]
    return out


def lost_digits(on: Arithmetic, model: Any) -> Any:
    """Zero as long as all constants are finite."""
    lost = 0.0
    for leg in range(6):
        for i in range(3):
            lost = lost + 0.0 * model.leg[leg].b[i]
        for i in range(3):
            lost = lost + 0.0 * model.leg[leg].p[i]
        for i in range(3):
            lost = lost + 0.0 * model.leg[leg].k[i]
        lost = lost + 0.0 * model.leg[leg].C_p
        lost = lost + 0.0 * model.leg[leg].C_s
        lost = lost + 0.0 * model.leg[leg].m_r
        lost = lost + 0.0 * model.leg[leg].j_r
        for i in range(3):
            lost = lost + 0.0 * model.leg[leg].h[i]
        lost = lost + 0.0 * model.leg[leg].h2_x
        lost = lost + 0.0 * model.leg[leg].h2_y
        lost = lost + 0.0 * model.leg[leg].h2_z
        for i in range(3):
            lost = lost + 0.0 * model.leg[leg].w[i]
        for i in range(6):
            lost = lost + 0.0 * model.leg[leg].J[i]
        lost = lost + 0.0 * model.leg[leg].J2_xz
        lost = lost + 0.0 * model.leg[leg].dJ_zx
        lost = lost + 0.0 * model.leg[leg].g_k
        for i in range(3):
            lost = lost + 0.0 * model.leg[leg].g_x_k[i]
        lost = lost + 0.0 * model.leg[leg].C_us
        lost = lost + 0.0 * model.leg[leg].cross
        lost = lost + 0.0 * model.leg[leg].along
        lost = lost + 0.0 * model.leg[leg].across
        lost = lost + 0.0 * model.leg[leg].across2
        lost = lost + 0.0 * model.leg[leg].along2
        lost = lost + 0.0 * model.leg[leg].cross2
        lost = lost + 0.0 * model.leg[leg].w_o
        lost = lost + 0.0 * model.leg[leg].M_add
        for i in range(3):
            lost = lost + 0.0 * model.leg[leg].h_add[i]
        for i in range(6):
            lost = lost + 0.0 * model.leg[leg].J_add[i]
        lost = lost + 0.0 * model.leg[leg].C_add
    lost = lost + 0.0 * model.platform.M_P
    for i in range(3):
        lost = lost + 0.0 * model.platform.r_C[i]
    for i in range(6):
        lost = lost + 0.0 * model.platform.J_C[i]
    for i in range(3):
        lost = lost + 0.0 * model.platform.dJ_C[i]
    lost = lost + 0.0 * model.platform.C_P
    for i in range(3):
        lost = lost + 0.0 * model.platform.g[i]
    return lost


def prepare(on: Arithmetic, robot: Any) -> Any:
    """Constants of a robot, prepared once; the status is not OK if a number of the robot is not finite."""
    robot = on.arrays(on.checked(Robot(), "robot", robot))
    model = Model()
    total = Added()
    for i in range(6):
        found = prepare_leg(on, robot, robot.leg[0].p, robot.leg[i])
        model.leg[i] = found
        total = add_up(on, total, found)
    model.platform = prepare_platform(on, robot, robot.leg[0].p, total)
    largest = size_of(on, model)
    model.per_length = per_length_of(on, largest, on.SMALLEST)
    model.arm_cube = cube_of(on, largest * model.per_length)
    model.status = on.where(lost_digits(on, model) == 0.0, OK, NOT_FINITE)
    return model


def leg_terms(on: Arithmetic, leg: Any, platform: Any, motion: Any, shared: Any) -> Any:
    """One leg with offset joints: D, its column of H and its part of c: 379 (222 mul, 151 add, 4 div, 2
    sqrt).
    """
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    C_p, C_s, m_r, j_r = leg.C_p, leg.C_s, leg.m_r, leg.j_r
    h_x, h_y, h_z = leg.h
    h2_x, h2_y, h2_z = leg.h2_x, leg.h2_y, leg.h2_z
    w_x, w_y, w_z = leg.w
    J_xx, J_xy, J_yy, J_yz = leg.J[0], leg.J[1], leg.J[3], leg.J[4]
    J2_xz, dJ_zx, g_k = leg.J2_xz, leg.dJ_zx, leg.g_k
    g_x_k_x, g_x_k_y, g_x_k_z = leg.g_x_k
    C_us = leg.C_us
    cross = leg.cross
    along = leg.along
    across = leg.across
    across2 = leg.across2
    along2 = leg.along2
    cross2 = leg.cross2
    w_o = leg.w_o
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    t_x, t_y, t_z = motion.t
    omega_x, omega_y, omega_z = motion.omega
    v_x, v_y, v_z = motion.v
    a_x, a_y, a_z = motion.a
    B_xx, B_xy, B_xz, B_yx, B_yy, B_yz, B_zx, B_zy, B_zz = shared.B
    g_x, g_y, g_z = platform.g
    # (1) platform point from the reference point
    q_x = R_xx * p_x + R_xy * p_y + R_xz * p_z
    q_y = R_yx * p_x + R_yy * p_y + R_yz * p_z
    q_z = R_zx * p_x + R_zy * p_y + R_zz * p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = t_b_x + q_x
    S_y = t_b_y + q_y
    S_z = t_b_z + q_z
    # (10) leg vector: component along the fixed axis, normal to both, and part across the fixed axis
    zeta = S_x * k_x + S_y * k_y + S_z * k_z
    k_cross_S_x = S_z * k_y - S_y * k_z
    k_cross_S_y = S_x * k_z - S_z * k_x
    k_cross_S_z = S_y * k_x - S_x * k_y
    S_across_x = S_x - k_x * zeta
    S_across_y = S_y - k_y * zeta
    S_across_z = S_z - k_z * zeta
    rho2 = k_cross_S_x * k_cross_S_x + k_cross_S_y * k_cross_S_y + k_cross_S_z * k_cross_S_z
    # (10) distance of the tip from the fixed axis along o
    r = on.sqrt(rho2 - along2)
    inv_rho2 = 1.0 / rho2
    r_share = inv_rho2 * r
    e_share = along * inv_rho2
    # (10) moving axis of the universal joint
    y_x = k_cross_S_x * r_share + S_across_x * e_share
    y_y = k_cross_S_y * r_share + S_across_y * e_share
    y_z = k_cross_S_z * r_share + S_across_z * e_share
    # (10) from the fixed axis toward the platform
    o_x = k_z * y_y - k_y * y_z
    o_y = k_x * y_z - k_z * y_x
    o_z = k_y * y_x - k_x * y_y
    # distance of the tip from the moving axis: along o, and squared
    r_out = r - cross
    reach2 = r_out * r_out + zeta * zeta
    # (2) leg length
    L = on.sqrt(reach2 - across2)
    inv_L = 1.0 / L
    inv_r = 1.0 / r
    inv_reach2 = 1.0 / reach2
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = inv_reach2 * (L * zeta - across * r_out)
    k3 = inv_reach2 * (L * r_out + across * zeta)
    # (3) unit vector along the line of sliding
    s_x = k1 * k_x + k3 * o_x
    s_y = k1 * k_y + k3 * o_y
    s_z = k1 * k_z + k3 * o_z
    # (10) third axis of the leg frame
    z_x = k3 * k_x - k1 * o_x
    z_y = k3 * k_y - k1 * o_y
    z_z = k3 * k_z - k1 * o_z
    column_of_z = across * inv_L
    column_of_y = along * inv_r * (k3 - column_of_z * k1)
    # (22) gradient of L by the tip: the leg's column of H
    column_x = column_of_y * y_x + s_x + column_of_z * z_x
    column_y = column_of_y * y_y + s_y + column_of_z * z_y
    column_z = column_of_y * y_z + s_z + column_of_z * z_z
    # (10) r / L, scaled by (r / rho)^2 because the rounding error of r grows near the least distance
    sine = inv_L * r_share * r * r
    # (4) velocity of the platform point
    S_dot_x = v_x + omega_y * q_z - omega_z * q_y
    S_dot_y = v_y + omega_z * q_x - omega_x * q_z
    S_dot_z = v_z + omega_x * q_y - omega_y * q_x
    # (7) acceleration of the platform point
    S_ddot_x = a_x + B_xx * q_x + B_xy * q_y + B_xz * q_z
    S_ddot_y = a_y + B_yx * q_x + B_yy * q_y + B_yz * q_z
    S_ddot_z = a_z + B_zx * q_x + B_zy * q_y + B_zz * q_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = inv_r * (S_dot_x * y_x + S_dot_y * y_y + S_dot_z * y_z)
    e_phi_dot = along * phi_dot
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    theta_dot = inv_L * (e_phi_dot * k1 - S_dot_x * z_x - S_dot_y * z_y - S_dot_z * z_z)
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x * s_x + S_dot_y * s_y + S_dot_z * s_z + e_phi_dot * k3 - across * theta_dot
    # rate of r
    r_dot = S_dot_x * o_x + S_dot_y * o_y + S_dot_z * o_z + e_phi_dot
    theta_dot2 = theta_dot * theta_dot
    phi_dot2 = phi_dot * phi_dot
    two_phi_dot = 2.0 * phi_dot
    # (9) accelerations of the joint coordinates
    phi_ddot = (inv_r * (along * phi_dot2 + S_ddot_x * y_x + S_ddot_y * y_y + S_ddot_z * y_z - r_dot * two_phi_dot))
    # part of r_ddot by phi only
    turning = phi_dot2 * r + along * phi_ddot
    c1 = L_dot * theta_dot
    # (9) accelerations of the joint coordinates
    theta_ddot = (inv_L * (k1 * turning - across * theta_dot2 - S_ddot_x * z_x - S_ddot_y * z_y - S_ddot_z * z_z
        - 2.0 * c1))
    # (8) accelerations of the joint coordinates
    L_ddot = (L * theta_dot2 + S_ddot_x * s_x + S_ddot_y * s_y + S_ddot_z * s_z + k3 * turning - across * theta_ddot)
    k33 = k3 * k3
    k13 = k1 * k3
    L_h2 = L * h2_x
    a1 = dJ_zx + L_h2
    a2 = J2_xz - L * h2_z
    a3 = J_xy - L * h_y
    # (19) inertia of the joint coordinates
    M_phi = J_xx + a1 * k33 + a2 * k13
    M_theta = J_yy + L_h2
    M_mixed = J_yz * k3 + a3 * k1
    k3_h = h_y * k3
    # (19) derivatives of M_phi / 2 by theta and L, of M_mixed by theta
    M_phi_theta = a2 * (0.5 - k33) + a1 * k13
    M_phi_L = h_x * k33 - h_z * k13
    M_mixed_theta = J_yz * k1 - a3 * k3
    w_k = k1 * w_x + k3 * w_z
    w_n = k3 * w_x - k1 * w_z
    h_k = h_x * k1 + h_z * k3
    h_n = h_x * k3 - h_z * k1
    M_phi_offset = M_phi + cross2 * w_n
    M_phi_theta_offset = M_phi_theta + cross * w_k
    M_mixed_offset = M_mixed - along * h_k
    M_mixed_theta_offset = M_mixed_theta + along * h_n
    bend = c1
    c2 = g_x * y_x + g_y * y_y + g_z * y_z
    # components of gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = c2
    c3 = j_r * k3
    c4 = c3 * phi_dot
    c5 = j_r * k1 - k3_h
    # (20) generalized forces about y and about k
    tau_y = (g_k * w_n + gamma_n * w_k - M_phi_theta_offset * phi_dot2 - C_s * (omega_x * y_x + omega_y * y_y
        + omega_z * y_z) + C_us * theta_dot + M_mixed_offset * phi_ddot + L_dot * c4 + bend * h2_x + M_theta
        * theta_ddot + L_ddot * h_z)
    tau_k = (M_mixed_theta_offset * theta_dot2 - C_s * (k_x * omega_x + k_y * omega_y + k_z * omega_z) + C_us
        * phi_dot - gamma_n * w_y - gamma_y * w_n + M_phi_offset * phi_ddot + two_phi_dot * (M_phi_theta_offset
        * theta_dot + L_dot * M_phi_L) - c1 * c3 - bend * h2_y * k1 + M_mixed_offset * theta_ddot + L_ddot * c5)
    # (20)
    tau_k_offset = tau_k - c2 * w_o
    # (21) K = Q_y y + Q_z z
    Q_z = -inv_L * tau_y
    Q_y = inv_r * (tau_k_offset - Q_z * along * k1)
    # (21) force at the platform joint, base frame
    K_x = Q_z * z_x + Q_y * y_x
    K_y = Q_z * z_y + Q_y * y_y
    K_z = Q_z * z_z + Q_y * y_z
    # (24) known part of the actuator force
    D = (c5 * phi_ddot - h_x * theta_dot2 - M_phi_L * phi_dot2 - c4 * theta_dot + C_p * L_dot + h_z * theta_ddot
        + L_ddot * m_r)
    c6 = C_s * phi_dot
    c7 = C_s * theta_dot
    out = LegTerms()
    out.q = [q_x, q_y, q_z]
    out.L = L
    out.k3 = sine
    out.D = D
    out.H_force = [column_x, column_y, column_z]
    out.c_force = [-K_x, -K_y, -K_z]
    out.c_moment = [c6 * k_x + c7 * y_x, c6 * k_y + c7 * y_y, c6 * k_z + c7 * y_z]
    return out


def forces(on: Arithmetic, model: Any, motion: Any) -> Any:
    """Actuator forces F, N, (37), and a status; F is NaN if the status is not OK."""
    model = on.arrays(on.checked(Model(), "model", model))
    motion = on.arrays(on.checked(Motion(), "motion", motion))
    on.agree(motion=motion)
    out = Forces()
    sums = Sums()
    A = [[0.0] * 7 for _ in range(6)]
    L = [0.0] * 6
    reach = [0.0] * 6
    x = [0.0] * 6
    status = model.status
    suspect = 0
    shared = shared_terms(on, model.platform, motion)
    for i in range(6):
        leg = leg_terms(on, model.leg[i], model.platform, motion, shared)
        reach[i] = reach_of(on, model.leg[i].b, motion.t, leg.q)
        fault = fault_of(on, leg.L, leg.k3, reach[i])
        status = on.where(status == OK, fault, status)
        suspect = on.where(leg.L > on.SHORT_SHARE * reach[i], suspect, 1)
        sums.leg[i] = leg
    for j in range(3):
        sums.q_1[j] = sums.leg[0].q[j]
    tip = shift(on, sums, shared)
    for j in range(3):
        sums.c[j] = shared.c_force[j]
        sums.c[j + 3] = tip.c_tip[j]
    for i in range(6):
        leg = sums.leg[i]
        turned = MomentTerms()
        if i > 0:
            turned = moments_of(on, leg, sums)
        L[i] = leg.L
        for j in range(3):
            sums.arm[i][j] = leg.q[j] - sums.q_1[j]
            sums.H[j][i] = leg.H_force[j]
            sums.H[j + 3][i] = turned.H_moment[j]
            sums.c[j] = sums.c[j] + leg.c_force[j]
            sums.c[j + 3] = sums.c[j + 3] + leg.c_moment[j]
            sums.c[j + 3] = sums.c[j + 3] + turned.arm_c[j]
    for i in range(3):
        A[i][6] = sums.c[i]
        A[i + 3][6] = sums.c[i + 3] * model.per_length
        for j in range(6):
            A[i][j] = sums.H[i][j]
            A[i + 3][j] = sums.H[i + 3][j] * model.per_length
    small_pivot = solve_legs(on, A, model.arm_cube, x)
    suspect = on.where(small_pivot == 0, suspect, 1)
    if on.anywhere(suspect == 1):
        found = singular_status(on, sums.H, sums.arm, L, reach, largest_component(on, sums.q_1, 0.0))
        status = on.where((status == OK) & (suspect == 1), found, status)
    for i in range(6):
        out.F[i] = sums.leg[i].D - x[i]
        status = on.where((status != OK) | (on.size(out.F[i]) <= on.MAX), status, NOT_FINITE)
    for i in range(6):
        out.F[i] = on.where(status == OK, out.F[i], on.NAN)
    out.status = status
    return out



def motion_of(on: Arithmetic, **fields: Any) -> Motion:
    """Return a motion from arrays: R (..., 9) or (..., 3, 3), t, omega, v, alpha, a, F_ext, M_ext (..., 3).

    R is required; other fields are zero by default. The leading shapes must broadcast.

    Raises
    ------
    ValueError
        If a name or a shape is wrong.
    """
    made = Motion()
    on.fill(made, fields)
    return made
