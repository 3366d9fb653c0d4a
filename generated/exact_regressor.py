"""Regressor of a Gough-Stewart platform on arrays, formulation `exact`, universal base joints.

Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
SPDX-License-Identifier: 0BSD

Columns of Y are in ``force_NAME``, rows 0 to 2, and ``moment_NAME``, rows 3 to 5. Arguments and results are described
in every_output.py. Of the robot only the points, the axes, and gravity are read.
"""

from typing import Any

from .arithmetic import Arithmetic
from .every_output import fault_of, first_of, reach_of

# Name and unit of each column of one leg and of the platform.
LEG_PARAMETERS = (
    ("m_d", "kg"),
    ("h_d_x", "kg m"),
    ("h_d_y", "kg m"),
    ("h_d_z", "kg m"),
    ("J_d_xx", "kg m^2"),
    ("J_d_xy", "kg m^2"),
    ("J_d_xz", "kg m^2"),
    ("J_d_yy", "kg m^2"),
    ("J_d_yz", "kg m^2"),
    ("J_d_zz", "kg m^2"),
    ("m_u", "kg"),
    ("h_u_x", "kg m"),
    ("h_u_y", "kg m"),
    ("h_u_z", "kg m"),
    ("J_u_xx", "kg m^2"),
    ("J_u_xy", "kg m^2"),
    ("J_u_xz", "kg m^2"),
    ("J_u_yy", "kg m^2"),
    ("J_u_yz", "kg m^2"),
    ("J_u_zz", "kg m^2"),
    ("C_u", "N m s"),
    ("C_p", "N s/m"),
    ("C_s", "N m s"),
)
PLATFORM_PARAMETERS = (
    ("M", "kg"),
    ("h_P_x", "kg m"),
    ("h_P_y", "kg m"),
    ("h_P_z", "kg m"),
    ("J_P_xx", "kg m^2"),
    ("J_P_xy", "kg m^2"),
    ("J_P_xz", "kg m^2"),
    ("J_P_yy", "kg m^2"),
    ("J_P_yz", "kg m^2"),
    ("J_P_zz", "kg m^2"),
)

# Parameters of a leg whose columns are zero or sums of others for every robot, and the base parameters that contain
# them, with sums over the legs. All other parameters are base parameters.
DEPENDENT = (
    "m_d",
    "m_u",
    "J_d_xx",
    "J_d_xy",
    "J_d_xz",
    "J_d_yy",
    "J_d_yz",
    "J_d_zz",
)
MERGED = (
    ("M", "M + sum(m_u)"),
    ("h_P_x", "h_P_x + sum(m_u*p_x)"),
    ("h_P_y", "h_P_y + sum(m_u*p_y)"),
    ("h_P_z", "h_P_z + sum(m_u*p_z)"),
    ("J_P_xx", "J_P_xx + sum(m_u*(p_y*p_y + p_z*p_z))"),
    ("J_P_xy", "J_P_xy + sum(-m_u*p_x*p_y)"),
    ("J_P_xz", "J_P_xz + sum(-m_u*p_x*p_z)"),
    ("J_P_yy", "J_P_yy + sum(m_u*(p_x*p_x + p_z*p_z))"),
    ("J_P_yz", "J_P_yz + sum(-m_u*p_y*p_z)"),
    ("J_P_zz", "J_P_zz + sum(m_u*(p_x*p_x + p_y*p_y))"),
    ("J_u_xx", "J_u_xx + J_d_xx"),
    ("J_u_xy", "J_u_xy + J_d_xy"),
    ("J_u_xz", "J_u_xz + J_d_xz"),
    ("J_u_yy", "J_u_yy + J_d_yy"),
    ("J_u_yz", "J_u_yz + J_d_yz"),
    ("J_u_zz", "J_u_zz + J_d_zz"),
)


class RegressorOfLegs:
    """Columns of the legs."""

    def __init__(self) -> None:
        self.force_m_d: Any = [0.0] * 3  # column of m_d, force rows, base frame
        self.moment_m_d: Any = [0.0] * 3  # column of m_d, moment rows, base frame
        self.force_h_d_x: Any = [0.0] * 3  # column of h_d_x, force rows, base frame
        self.moment_h_d_x: Any = [0.0] * 3  # column of h_d_x, moment rows, base frame
        self.force_h_d_y: Any = [0.0] * 3  # column of h_d_y, force rows, base frame
        self.moment_h_d_y: Any = [0.0] * 3  # column of h_d_y, moment rows, base frame
        self.force_h_d_z: Any = [0.0] * 3  # column of h_d_z, force rows, base frame
        self.moment_h_d_z: Any = [0.0] * 3  # column of h_d_z, moment rows, base frame
        self.force_J_d_xx: Any = [0.0] * 3  # column of J_d_xx, force rows, base frame
        self.moment_J_d_xx: Any = [0.0] * 3  # column of J_d_xx, moment rows, base frame
        self.force_J_d_xy: Any = [0.0] * 3  # column of J_d_xy, force rows, base frame
        self.moment_J_d_xy: Any = [0.0] * 3  # column of J_d_xy, moment rows, base frame
        self.force_J_d_xz: Any = [0.0] * 3  # column of J_d_xz, force rows, base frame
        self.moment_J_d_xz: Any = [0.0] * 3  # column of J_d_xz, moment rows, base frame
        self.force_J_d_yy: Any = [0.0] * 3  # column of J_d_yy, force rows, base frame
        self.moment_J_d_yy: Any = [0.0] * 3  # column of J_d_yy, moment rows, base frame
        self.force_J_d_yz: Any = [0.0] * 3  # column of J_d_yz, force rows, base frame
        self.moment_J_d_yz: Any = [0.0] * 3  # column of J_d_yz, moment rows, base frame
        self.force_J_d_zz: Any = [0.0] * 3  # column of J_d_zz, force rows, base frame
        self.moment_J_d_zz: Any = [0.0] * 3  # column of J_d_zz, moment rows, base frame
        self.force_m_u: Any = [0.0] * 3  # column of m_u, force rows, base frame
        self.moment_m_u: Any = [0.0] * 3  # column of m_u, moment rows, base frame
        self.force_h_u_x: Any = [0.0] * 3  # column of h_u_x, force rows, base frame
        self.moment_h_u_x: Any = [0.0] * 3  # column of h_u_x, moment rows, base frame
        self.force_h_u_y: Any = [0.0] * 3  # column of h_u_y, force rows, base frame
        self.moment_h_u_y: Any = [0.0] * 3  # column of h_u_y, moment rows, base frame
        self.force_h_u_z: Any = [0.0] * 3  # column of h_u_z, force rows, base frame
        self.moment_h_u_z: Any = [0.0] * 3  # column of h_u_z, moment rows, base frame
        self.force_J_u_xx: Any = [0.0] * 3  # column of J_u_xx, force rows, base frame
        self.moment_J_u_xx: Any = [0.0] * 3  # column of J_u_xx, moment rows, base frame
        self.force_J_u_xy: Any = [0.0] * 3  # column of J_u_xy, force rows, base frame
        self.moment_J_u_xy: Any = [0.0] * 3  # column of J_u_xy, moment rows, base frame
        self.force_J_u_xz: Any = [0.0] * 3  # column of J_u_xz, force rows, base frame
        self.moment_J_u_xz: Any = [0.0] * 3  # column of J_u_xz, moment rows, base frame
        self.force_J_u_yy: Any = [0.0] * 3  # column of J_u_yy, force rows, base frame
        self.moment_J_u_yy: Any = [0.0] * 3  # column of J_u_yy, moment rows, base frame
        self.force_J_u_yz: Any = [0.0] * 3  # column of J_u_yz, force rows, base frame
        self.moment_J_u_yz: Any = [0.0] * 3  # column of J_u_yz, moment rows, base frame
        self.force_J_u_zz: Any = [0.0] * 3  # column of J_u_zz, force rows, base frame
        self.moment_J_u_zz: Any = [0.0] * 3  # column of J_u_zz, moment rows, base frame
        self.force_C_u: Any = [0.0] * 3  # column of C_u, force rows, base frame
        self.moment_C_u: Any = [0.0] * 3  # column of C_u, moment rows, base frame
        self.force_C_p: Any = [0.0] * 3  # column of C_p, force rows, base frame
        self.moment_C_p: Any = [0.0] * 3  # column of C_p, moment rows, base frame
        self.force_C_s: Any = [0.0] * 3  # column of C_s, force rows, base frame
        self.moment_C_s: Any = [0.0] * 3  # column of C_s, moment rows, base frame
        self.q: Any = [0.0] * 3  # m: platform point from the reference point, base frame
        self.L: Any = 0.0  # m: length of the leg
        self.k3: Any = 0.0  # 1: |k x s|, sine of the angle between the leg and the fixed axis


class RegressorOfPlatform:
    """Columns of the platform."""

    def __init__(self) -> None:
        self.force_M: Any = [0.0] * 3  # column of M, force rows, base frame
        self.moment_M: Any = [0.0] * 3  # column of M, moment rows, base frame
        self.force_h_P_x: Any = [0.0] * 3  # column of h_P_x, force rows, base frame
        self.moment_h_P_x: Any = [0.0] * 3  # column of h_P_x, moment rows, base frame
        self.force_h_P_y: Any = [0.0] * 3  # column of h_P_y, force rows, base frame
        self.moment_h_P_y: Any = [0.0] * 3  # column of h_P_y, moment rows, base frame
        self.force_h_P_z: Any = [0.0] * 3  # column of h_P_z, force rows, base frame
        self.moment_h_P_z: Any = [0.0] * 3  # column of h_P_z, moment rows, base frame
        self.force_J_P_xx: Any = [0.0] * 3  # column of J_P_xx, force rows, base frame
        self.moment_J_P_xx: Any = [0.0] * 3  # column of J_P_xx, moment rows, base frame
        self.force_J_P_xy: Any = [0.0] * 3  # column of J_P_xy, force rows, base frame
        self.moment_J_P_xy: Any = [0.0] * 3  # column of J_P_xy, moment rows, base frame
        self.force_J_P_xz: Any = [0.0] * 3  # column of J_P_xz, force rows, base frame
        self.moment_J_P_xz: Any = [0.0] * 3  # column of J_P_xz, moment rows, base frame
        self.force_J_P_yy: Any = [0.0] * 3  # column of J_P_yy, force rows, base frame
        self.moment_J_P_yy: Any = [0.0] * 3  # column of J_P_yy, moment rows, base frame
        self.force_J_P_yz: Any = [0.0] * 3  # column of J_P_yz, force rows, base frame
        self.moment_J_P_yz: Any = [0.0] * 3  # column of J_P_yz, moment rows, base frame
        self.force_J_P_zz: Any = [0.0] * 3  # column of J_P_zz, force rows, base frame
        self.moment_J_P_zz: Any = [0.0] * 3  # column of J_P_zz, moment rows, base frame


class Regressor:
    """Columns of Y."""

    def __init__(self) -> None:
        self.legs: Any = RegressorOfLegs()  # of the legs
        self.platform: Any = RegressorOfPlatform()  # of the platform
        self.status: Any = 0  # 0, or the code of an error


def regressor_of_leg(on: Arithmetic, leg: Any, robot: Any, motion: Any) -> Any:
    """Columns of one leg's parameters: 618 (404 mul, 210 add, 2 div, 2 sqrt)."""
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    t_x, t_y, t_z = motion.t
    omega_x, omega_y, omega_z = motion.omega
    v_x, v_y, v_z = motion.v
    alpha_x, alpha_y, alpha_z = motion.alpha
    a_x, a_y, a_z = motion.a
    g_x, g_y, g_z = robot.g
    # (1) platform point from the reference point
    q_x = R_xx * p_x + R_xy * p_y + R_xz * p_z
    q_y = R_yx * p_x + R_yy * p_y + R_yz * p_z
    q_z = R_zx * p_x + R_zy * p_y + R_zz * p_z
    # (1) leg vector
    S_x = t_x - b_x + q_x
    S_y = t_y - b_y + q_y
    S_z = t_z - b_z + q_z
    # (10) component of the leg vector along the fixed axis, and normal to both
    zeta = S_x * k_x + S_y * k_y + S_z * k_z
    k_cross_S_x = S_z * k_y - S_y * k_z
    k_cross_S_y = S_x * k_z - S_z * k_x
    k_cross_S_z = S_y * k_x - S_x * k_y
    # (2) leg length, and distance of the tip from the fixed axis
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
    # (10) leg length, and distance of the tip from the fixed axis
    rho = (on.sqrt(s_cross_normal_x * s_cross_normal_x + s_cross_normal_y * s_cross_normal_y + s_cross_normal_z
        * s_cross_normal_z))
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
    # (7) acceleration of the platform point
    S_ddot_x = a_x + alpha_y * q_z - alpha_z * q_y + omega_y * w_q_z - omega_z * w_q_y
    S_ddot_y = a_y + alpha_z * q_x - alpha_x * q_z + omega_z * w_q_x - omega_x * w_q_z
    S_ddot_z = a_z + alpha_x * q_y - alpha_y * q_x + omega_x * w_q_y - omega_y * w_q_x
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x * s_x + S_dot_y * s_y + S_dot_z * s_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = inv_rho * (S_dot_x * y_x + S_dot_y * y_y + S_dot_z * y_z)
    theta_dot = -inv_L * (S_dot_x * z_x + S_dot_y * z_y + S_dot_z * z_z)
    # L_dot / L
    L_share = L_dot * inv_L
    lean = kappa * theta_dot
    c1 = theta_dot * theta_dot
    theta_dot2 = c1
    c2 = phi_dot * phi_dot
    phi_dot2 = c2
    c3 = 2.0 * phi_dot
    two_phi_dot = c3
    c4 = k3 * k3
    k33 = c4
    # (8) accelerations of the joint coordinates
    L_ddot = L * (theta_dot2 + k33 * phi_dot2) + S_ddot_x * s_x + S_ddot_y * s_y + S_ddot_z * s_z
    c5 = 2.0 * theta_dot
    # (9) accelerations of the joint coordinates without the rotation of the leg frame about s
    own_theta_ddot = -inv_L * (S_ddot_x * z_x + S_ddot_y * z_y + S_ddot_z * z_z) - L_share * c5
    own_phi_ddot = inv_rho * (S_ddot_x * y_x + S_ddot_y * y_y + S_ddot_z * y_z) - L_share * two_phi_dot
    c6 = k1 * k3
    # (9) accelerations of the joint coordinates
    theta_ddot = c6 * phi_dot2 + own_theta_ddot
    phi_ddot = own_phi_ddot - lean * two_phi_dot
    # component of g along the fixed axis k
    g_k = g_x * k_x + g_y * k_y + g_z * k_z
    # g x k, base frame
    g_x_k_x = g_y * k_z - g_z * k_y
    g_x_k_y = g_z * k_x - g_x * k_z
    g_x_k_z = g_x * k_y - g_y * k_x
    # components of gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # omega along k x y, y and k
    w_y_omega = omega_x * y_x + omega_y * y_y + omega_z * y_z
    w_k_omega = k_x * omega_x + k_y * omega_y + k_z * omega_z
    c7 = g_k * k3 + gamma_n * k1
    c8 = -gamma_y * k3
    # (20) torques by h_d_x
    tau_theta_h_d_x = c7
    tau_phi_h_d_x = c8
    c9 = g_k * k1
    # (20) torques by h_d_z
    tau_theta_h_d_z = gamma_n * k3 - c9
    tau_phi_h_d_z = gamma_y * k1
    c10 = c2 * c4
    c11 = 2.0 * L
    c12 = L_dot * c5
    c13 = c4 * own_phi_ddot
    c14 = c3 * c4
    # (20) torques by h_u_x
    tau_L_h_u_x = -c1 - c10
    tau_theta_h_u_x = c12 + c7 + c11 * own_theta_ddot
    tau_phi_h_u_x = c8 + L_dot * c14 + c11 * c13
    c15 = k3 * phi_ddot
    c16 = k1 * phi_ddot
    c17 = k1 * theta_ddot
    # (20) torques by h_u_y
    tau_L_h_u_y = -c15
    tau_theta_h_u_y = -L * c16
    tau_phi_h_u_y = L * c1 * k3 - L_ddot * k3 - gamma_n - c12 * k1 - L * c17
    c18 = c2 * c6
    c19 = k1 * k1
    c20 = c19 * c2
    c21 = c15 * k1
    c22 = c3 * theta_dot
    c23 = c19 * c22
    # (20) torques by h_u_z
    tau_L_h_u_z = c18 + theta_ddot
    tau_theta_h_u_z = L * c20 - L * c10 - c9 + L_ddot + gamma_n * k3
    tau_phi_h_u_z = (gamma_y * k1 + 2.0 * L * c4 * phi_dot * theta_dot - L_dot * c3 * c6 - L * c23 - c11 * c21)
    # (20) torques by J_u_xx
    tau_theta_J_u_xx = c18
    tau_phi_J_u_xx = phi_ddot - c22 * c6 - c4 * phi_ddot
    # (20) torques by J_u_xy
    tau_theta_J_u_xy = c16
    tau_phi_J_u_xy = c17 - c1 * k3
    # (20) torques by J_u_xz
    tau_theta_J_u_xz = c10 - c20
    tau_phi_J_u_xz = c23 - c14 * theta_dot + 2.0 * c21
    # (20) torques by J_u_yz
    tau_theta_J_u_yz = c15
    tau_phi_J_u_yz = c1 * k1 + k3 * theta_ddot
    # (20) torques by J_u_zz
    tau_theta_J_u_zz = -c18
    tau_phi_J_u_zz = c13
    # (20) torques by C_s
    tau_theta_C_s = theta_dot - w_y_omega
    tau_phi_C_s = phi_dot - w_k_omega
    # (6) angular velocity of the leg
    W_x = theta_dot * y_x + k_x * phi_dot
    W_y = theta_dot * y_y + k_y * phi_dot
    W_z = theta_dot * y_z + k_z * phi_dot
    c24 = inv_L * tau_theta_h_d_x
    # force at the tip by h_d_x
    R_h_d_x_x = inv_rho * tau_phi_h_d_x * y_x - c24 * z_x
    R_h_d_x_y = inv_rho * tau_phi_h_d_x * y_y - c24 * z_y
    R_h_d_x_z = inv_rho * tau_phi_h_d_x * y_z - c24 * z_z
    c25 = gamma_n * inv_rho
    # force at the tip by h_d_y
    R_h_d_y_x = -c25 * y_x
    R_h_d_y_y = -c25 * y_y
    R_h_d_y_z = -c25 * y_z
    c26 = inv_L * tau_theta_h_d_z
    # force at the tip by h_d_z
    R_h_d_z_x = inv_rho * tau_phi_h_d_z * y_x - c26 * z_x
    R_h_d_z_y = inv_rho * tau_phi_h_d_z * y_y - c26 * z_y
    R_h_d_z_z = inv_rho * tau_phi_h_d_z * y_z - c26 * z_z
    c27 = inv_rho * tau_phi_h_u_x
    c28 = inv_L * tau_theta_h_u_x
    # force at the tip by h_u_x
    R_h_u_x_x = s_x * tau_L_h_u_x - c28 * z_x + c27 * y_x
    R_h_u_x_y = s_y * tau_L_h_u_x - c28 * z_y + c27 * y_y
    R_h_u_x_z = s_z * tau_L_h_u_x - c28 * z_z + c27 * y_z
    c29 = inv_rho * tau_phi_h_u_y
    c30 = inv_L * tau_theta_h_u_y
    # force at the tip by h_u_y
    R_h_u_y_x = s_x * tau_L_h_u_y + c29 * y_x - c30 * z_x
    R_h_u_y_y = s_y * tau_L_h_u_y + c29 * y_y - c30 * z_y
    R_h_u_y_z = s_z * tau_L_h_u_y + c29 * y_z - c30 * z_z
    c31 = inv_rho * tau_phi_h_u_z
    c32 = inv_L * tau_theta_h_u_z
    # force at the tip by h_u_z
    R_h_u_z_x = s_x * tau_L_h_u_z - c32 * z_x + c31 * y_x
    R_h_u_z_y = s_y * tau_L_h_u_z - c32 * z_y + c31 * y_y
    R_h_u_z_z = s_z * tau_L_h_u_z - c32 * z_z + c31 * y_z
    c33 = inv_L * tau_theta_J_u_xx
    # force at the tip by J_u_xx
    R_J_u_xx_x = inv_rho * tau_phi_J_u_xx * y_x - c33 * z_x
    R_J_u_xx_y = inv_rho * tau_phi_J_u_xx * y_y - c33 * z_y
    R_J_u_xx_z = inv_rho * tau_phi_J_u_xx * y_z - c33 * z_z
    c34 = inv_L * tau_theta_J_u_xy
    # force at the tip by J_u_xy
    R_J_u_xy_x = inv_rho * tau_phi_J_u_xy * y_x - c34 * z_x
    R_J_u_xy_y = inv_rho * tau_phi_J_u_xy * y_y - c34 * z_y
    R_J_u_xy_z = inv_rho * tau_phi_J_u_xy * y_z - c34 * z_z
    c35 = inv_L * tau_theta_J_u_xz
    # force at the tip by J_u_xz
    R_J_u_xz_x = inv_rho * tau_phi_J_u_xz * y_x - c35 * z_x
    R_J_u_xz_y = inv_rho * tau_phi_J_u_xz * y_y - c35 * z_y
    R_J_u_xz_z = inv_rho * tau_phi_J_u_xz * y_z - c35 * z_z
    c36 = inv_L * theta_ddot
    # force at the tip by J_u_yy
    R_J_u_yy_x = -c36 * z_x
    R_J_u_yy_y = -c36 * z_y
    R_J_u_yy_z = -c36 * z_z
    c37 = inv_L * tau_theta_J_u_yz
    # force at the tip by J_u_yz
    R_J_u_yz_x = inv_rho * tau_phi_J_u_yz * y_x - c37 * z_x
    R_J_u_yz_y = inv_rho * tau_phi_J_u_yz * y_y - c37 * z_y
    R_J_u_yz_z = inv_rho * tau_phi_J_u_yz * y_z - c37 * z_z
    c38 = inv_L * tau_theta_J_u_zz
    # force at the tip by J_u_zz
    R_J_u_zz_x = inv_rho * tau_phi_J_u_zz * y_x - c38 * z_x
    R_J_u_zz_y = inv_rho * tau_phi_J_u_zz * y_y - c38 * z_y
    R_J_u_zz_z = inv_rho * tau_phi_J_u_zz * y_z - c38 * z_z
    c39 = inv_L * theta_dot
    # force at the tip by C_u
    R_C_u_x = inv_rho * phi_dot * y_x - c39 * z_x
    R_C_u_y = inv_rho * phi_dot * y_y - c39 * z_y
    R_C_u_z = inv_rho * phi_dot * y_z - c39 * z_z
    # force at the tip by C_p
    R_C_p_x = L_dot * s_x
    R_C_p_y = L_dot * s_y
    R_C_p_z = L_dot * s_z
    c40 = inv_L * tau_theta_C_s
    # force at the tip by C_s
    R_C_s_x = inv_rho * tau_phi_C_s * y_x - c40 * z_x
    R_C_s_y = inv_rho * tau_phi_C_s * y_y - c40 * z_y
    R_C_s_z = inv_rho * tau_phi_C_s * y_z - c40 * z_z
    # (18) S_ddot - g
    rise_x = S_ddot_x - g_x
    rise_y = S_ddot_y - g_y
    rise_z = S_ddot_z - g_z
    c41 = R_J_u_xx_z * q_y - R_J_u_xx_y * q_z
    c42 = R_J_u_xx_x * q_z - R_J_u_xx_z * q_x
    c43 = R_J_u_xx_y * q_x - R_J_u_xx_x * q_y
    c44 = R_J_u_xy_z * q_y - R_J_u_xy_y * q_z
    c45 = R_J_u_xy_x * q_z - R_J_u_xy_z * q_x
    c46 = R_J_u_xy_y * q_x - R_J_u_xy_x * q_y
    c47 = R_J_u_xz_z * q_y - R_J_u_xz_y * q_z
    c48 = R_J_u_xz_x * q_z - R_J_u_xz_z * q_x
    c49 = R_J_u_xz_y * q_x - R_J_u_xz_x * q_y
    c50 = R_J_u_yy_z * q_y - R_J_u_yy_y * q_z
    c51 = R_J_u_yy_x * q_z - R_J_u_yy_z * q_x
    c52 = R_J_u_yy_y * q_x - R_J_u_yy_x * q_y
    c53 = R_J_u_yz_z * q_y - R_J_u_yz_y * q_z
    c54 = R_J_u_yz_x * q_z - R_J_u_yz_z * q_x
    c55 = R_J_u_yz_y * q_x - R_J_u_yz_x * q_y
    c56 = R_J_u_zz_z * q_y - R_J_u_zz_y * q_z
    c57 = R_J_u_zz_x * q_z - R_J_u_zz_z * q_x
    c58 = R_J_u_zz_y * q_x - R_J_u_zz_x * q_y
    out = RegressorOfLegs()
    out.force_m_d = [0.0, 0.0, 0.0]
    out.moment_m_d = [0.0, 0.0, 0.0]
    out.force_h_d_x = [R_h_d_x_x, R_h_d_x_y, R_h_d_x_z]
    out.moment_h_d_x = [
        R_h_d_x_z * q_y - R_h_d_x_y * q_z,
        R_h_d_x_x * q_z - R_h_d_x_z * q_x,
        R_h_d_x_y * q_x - R_h_d_x_x * q_y,
    ]
    out.force_h_d_y = [R_h_d_y_x, R_h_d_y_y, R_h_d_y_z]
    out.moment_h_d_y = [
        R_h_d_y_z * q_y - R_h_d_y_y * q_z,
        R_h_d_y_x * q_z - R_h_d_y_z * q_x,
        R_h_d_y_y * q_x - R_h_d_y_x * q_y,
    ]
    out.force_h_d_z = [R_h_d_z_x, R_h_d_z_y, R_h_d_z_z]
    out.moment_h_d_z = [
        R_h_d_z_z * q_y - R_h_d_z_y * q_z,
        R_h_d_z_x * q_z - R_h_d_z_z * q_x,
        R_h_d_z_y * q_x - R_h_d_z_x * q_y,
    ]
    out.force_J_d_xx = [R_J_u_xx_x, R_J_u_xx_y, R_J_u_xx_z]
    out.moment_J_d_xx = [c41, c42, c43]
    out.force_J_d_xy = [R_J_u_xy_x, R_J_u_xy_y, R_J_u_xy_z]
    out.moment_J_d_xy = [c44, c45, c46]
    out.force_J_d_xz = [R_J_u_xz_x, R_J_u_xz_y, R_J_u_xz_z]
    out.moment_J_d_xz = [c47, c48, c49]
    out.force_J_d_yy = [R_J_u_yy_x, R_J_u_yy_y, R_J_u_yy_z]
    out.moment_J_d_yy = [c50, c51, c52]
    out.force_J_d_yz = [R_J_u_yz_x, R_J_u_yz_y, R_J_u_yz_z]
    out.moment_J_d_yz = [c53, c54, c55]
    out.force_J_d_zz = [R_J_u_zz_x, R_J_u_zz_y, R_J_u_zz_z]
    out.moment_J_d_zz = [c56, c57, c58]
    out.force_m_u = [rise_x, rise_y, rise_z]
    out.moment_m_u = [q_y * rise_z - q_z * rise_y, q_z * rise_x - q_x * rise_z, q_x * rise_y - q_y * rise_x]
    out.force_h_u_x = [R_h_u_x_x, R_h_u_x_y, R_h_u_x_z]
    out.moment_h_u_x = [
        R_h_u_x_z * q_y - R_h_u_x_y * q_z,
        R_h_u_x_x * q_z - R_h_u_x_z * q_x,
        R_h_u_x_y * q_x - R_h_u_x_x * q_y,
    ]
    out.force_h_u_y = [R_h_u_y_x, R_h_u_y_y, R_h_u_y_z]
    out.moment_h_u_y = [
        R_h_u_y_z * q_y - R_h_u_y_y * q_z,
        R_h_u_y_x * q_z - R_h_u_y_z * q_x,
        R_h_u_y_y * q_x - R_h_u_y_x * q_y,
    ]
    out.force_h_u_z = [R_h_u_z_x, R_h_u_z_y, R_h_u_z_z]
    out.moment_h_u_z = [
        R_h_u_z_z * q_y - R_h_u_z_y * q_z,
        R_h_u_z_x * q_z - R_h_u_z_z * q_x,
        R_h_u_z_y * q_x - R_h_u_z_x * q_y,
    ]
    out.force_J_u_xx = [R_J_u_xx_x, R_J_u_xx_y, R_J_u_xx_z]
    out.moment_J_u_xx = [c41, c42, c43]
    out.force_J_u_xy = [R_J_u_xy_x, R_J_u_xy_y, R_J_u_xy_z]
    out.moment_J_u_xy = [c44, c45, c46]
    out.force_J_u_xz = [R_J_u_xz_x, R_J_u_xz_y, R_J_u_xz_z]
    out.moment_J_u_xz = [c47, c48, c49]
    out.force_J_u_yy = [R_J_u_yy_x, R_J_u_yy_y, R_J_u_yy_z]
    out.moment_J_u_yy = [c50, c51, c52]
    out.force_J_u_yz = [R_J_u_yz_x, R_J_u_yz_y, R_J_u_yz_z]
    out.moment_J_u_yz = [c53, c54, c55]
    out.force_J_u_zz = [R_J_u_zz_x, R_J_u_zz_y, R_J_u_zz_z]
    out.moment_J_u_zz = [c56, c57, c58]
    out.force_C_u = [R_C_u_x, R_C_u_y, R_C_u_z]
    out.moment_C_u = [
        R_C_u_z * q_y - R_C_u_y * q_z,
        R_C_u_x * q_z - R_C_u_z * q_x,
        R_C_u_y * q_x - R_C_u_x * q_y,
    ]
    out.force_C_p = [R_C_p_x, R_C_p_y, R_C_p_z]
    out.moment_C_p = [
        R_C_p_z * q_y - R_C_p_y * q_z,
        R_C_p_x * q_z - R_C_p_z * q_x,
        R_C_p_y * q_x - R_C_p_x * q_y,
    ]
    out.force_C_s = [R_C_s_x, R_C_s_y, R_C_s_z]
    out.moment_C_s = [
        omega_x + R_C_s_z * q_y - W_x - R_C_s_y * q_z,
        omega_y + R_C_s_x * q_z - W_y - R_C_s_z * q_x,
        omega_z + R_C_s_y * q_x - W_z - R_C_s_x * q_y,
    ]
    out.q = [q_x, q_y, q_z]
    out.L = L
    out.k3 = k3
    return out


def regressor_of_platform(on: Arithmetic, robot: Any, motion: Any) -> Any:
    """Columns of the platform's parameters: 255 (150 mul, 105 add, 0 div, 0 sqrt)."""
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    omega_x, omega_y, omega_z = motion.omega
    alpha_x, alpha_y, alpha_z = motion.alpha
    a_x, a_y, a_z = motion.a
    g_x, g_y, g_z = robot.g
    # (33) a - g
    rise_x = a_x - g_x
    rise_y = a_y - g_y
    rise_z = a_z - g_z
    # angular velocity, platform frame
    omega_P_x = R_xx * omega_x + R_yx * omega_y + R_zx * omega_z
    omega_P_y = R_xy * omega_x + R_yy * omega_y + R_zy * omega_z
    omega_P_z = R_xz * omega_x + R_yz * omega_y + R_zz * omega_z
    # angular acceleration, platform frame
    alpha_P_x = R_xx * alpha_x + R_yx * alpha_y + R_zx * alpha_z
    alpha_P_y = R_xy * alpha_x + R_yy * alpha_y + R_zy * alpha_z
    alpha_P_z = R_xz * alpha_x + R_yz * alpha_y + R_zz * alpha_z
    # (31) omega x an axis of the platform
    w_h_P_x_x = R_zx * omega_y - R_yx * omega_z
    w_h_P_x_y = R_xx * omega_z - R_zx * omega_x
    w_h_P_x_z = R_yx * omega_x - R_xx * omega_y
    w_h_P_y_x = R_zy * omega_y - R_yy * omega_z
    w_h_P_y_y = R_xy * omega_z - R_zy * omega_x
    w_h_P_y_z = R_yy * omega_x - R_xy * omega_y
    w_h_P_z_x = R_zz * omega_y - R_yz * omega_z
    w_h_P_z_y = R_xz * omega_z - R_zz * omega_x
    w_h_P_z_z = R_yz * omega_x - R_xz * omega_y
    c1 = omega_P_x * omega_P_z
    c2 = omega_P_x * omega_P_y
    # (34) I alpha + omega x I omega by J_P_xx
    E_J_P_xx_y = c1
    E_J_P_xx_z = -c2
    c5 = omega_P_y * omega_P_z
    c6 = omega_P_x * omega_P_x
    c7 = omega_P_y * omega_P_y
    # (34) I alpha + omega x I omega by J_P_xy
    E_J_P_xy_x = alpha_P_y - c1
    E_J_P_xy_y = alpha_P_x + c5
    E_J_P_xy_z = c6 - c7
    c8 = -omega_P_z * omega_P_z
    # (34) I alpha + omega x I omega by J_P_xz
    E_J_P_xz_x = alpha_P_z + c2
    E_J_P_xz_y = -c6 - c8
    E_J_P_xz_z = alpha_P_x - c5
    # (34) I alpha + omega x I omega by J_P_yy
    E_J_P_yy_x = -c5
    E_J_P_yy_z = c2
    # (34) I alpha + omega x I omega by J_P_yz
    E_J_P_yz_x = c7 + c8
    E_J_P_yz_y = alpha_P_z - c2
    E_J_P_yz_z = alpha_P_y + c1
    # (34) I alpha + omega x I omega by J_P_zz
    E_J_P_zz_x = c5
    E_J_P_zz_y = -c1
    out = RegressorOfPlatform()
    out.force_M = [rise_x, rise_y, rise_z]
    out.moment_M = [0.0, 0.0, 0.0]
    out.force_h_P_x = [
        R_zx * alpha_y + omega_y * w_h_P_x_z - R_yx * alpha_z - omega_z * w_h_P_x_y,
        R_xx * alpha_z + omega_z * w_h_P_x_x - R_zx * alpha_x - omega_x * w_h_P_x_z,
        R_yx * alpha_x + omega_x * w_h_P_x_y - R_xx * alpha_y - omega_y * w_h_P_x_x,
    ]
    out.moment_h_P_x = [
        R_yx * rise_z - R_zx * rise_y,
        R_zx * rise_x - R_xx * rise_z,
        R_xx * rise_y - R_yx * rise_x,
    ]
    out.force_h_P_y = [
        R_zy * alpha_y + omega_y * w_h_P_y_z - R_yy * alpha_z - omega_z * w_h_P_y_y,
        R_xy * alpha_z + omega_z * w_h_P_y_x - R_zy * alpha_x - omega_x * w_h_P_y_z,
        R_yy * alpha_x + omega_x * w_h_P_y_y - R_xy * alpha_y - omega_y * w_h_P_y_x,
    ]
    out.moment_h_P_y = [
        R_yy * rise_z - R_zy * rise_y,
        R_zy * rise_x - R_xy * rise_z,
        R_xy * rise_y - R_yy * rise_x,
    ]
    out.force_h_P_z = [
        R_zz * alpha_y + omega_y * w_h_P_z_z - R_yz * alpha_z - omega_z * w_h_P_z_y,
        R_xz * alpha_z + omega_z * w_h_P_z_x - R_zz * alpha_x - omega_x * w_h_P_z_z,
        R_yz * alpha_x + omega_x * w_h_P_z_y - R_xz * alpha_y - omega_y * w_h_P_z_x,
    ]
    out.moment_h_P_z = [
        R_yz * rise_z - R_zz * rise_y,
        R_zz * rise_x - R_xz * rise_z,
        R_xz * rise_y - R_yz * rise_x,
    ]
    out.force_J_P_xx = [0.0, 0.0, 0.0]
    out.moment_J_P_xx = [
        E_J_P_xx_y * R_xy + E_J_P_xx_z * R_xz + R_xx * alpha_P_x,
        E_J_P_xx_y * R_yy + E_J_P_xx_z * R_yz + R_yx * alpha_P_x,
        E_J_P_xx_y * R_zy + E_J_P_xx_z * R_zz + R_zx * alpha_P_x,
    ]
    out.force_J_P_xy = [0.0, 0.0, 0.0]
    out.moment_J_P_xy = [
        E_J_P_xy_x * R_xx + E_J_P_xy_y * R_xy + E_J_P_xy_z * R_xz,
        E_J_P_xy_x * R_yx + E_J_P_xy_y * R_yy + E_J_P_xy_z * R_yz,
        E_J_P_xy_x * R_zx + E_J_P_xy_y * R_zy + E_J_P_xy_z * R_zz,
    ]
    out.force_J_P_xz = [0.0, 0.0, 0.0]
    out.moment_J_P_xz = [
        E_J_P_xz_x * R_xx + E_J_P_xz_y * R_xy + E_J_P_xz_z * R_xz,
        E_J_P_xz_x * R_yx + E_J_P_xz_y * R_yy + E_J_P_xz_z * R_yz,
        E_J_P_xz_x * R_zx + E_J_P_xz_y * R_zy + E_J_P_xz_z * R_zz,
    ]
    out.force_J_P_yy = [0.0, 0.0, 0.0]
    out.moment_J_P_yy = [
        E_J_P_yy_x * R_xx + E_J_P_yy_z * R_xz + R_xy * alpha_P_y,
        E_J_P_yy_x * R_yx + E_J_P_yy_z * R_yz + R_yy * alpha_P_y,
        E_J_P_yy_x * R_zx + E_J_P_yy_z * R_zz + R_zy * alpha_P_y,
    ]
    out.force_J_P_yz = [0.0, 0.0, 0.0]
    out.moment_J_P_yz = [
        E_J_P_yz_x * R_xx + E_J_P_yz_y * R_xy + E_J_P_yz_z * R_xz,
        E_J_P_yz_x * R_yx + E_J_P_yz_y * R_yy + E_J_P_yz_z * R_yz,
        E_J_P_yz_x * R_zx + E_J_P_yz_y * R_zy + E_J_P_yz_z * R_zz,
    ]
    out.force_J_P_zz = [0.0, 0.0, 0.0]
    out.moment_J_P_zz = [
        E_J_P_zz_x * R_xx + E_J_P_zz_y * R_xy + R_xz * alpha_P_z,
        E_J_P_zz_x * R_yx + E_J_P_zz_y * R_yy + R_yz * alpha_P_z,
        E_J_P_zz_x * R_zx + E_J_P_zz_y * R_zy + R_zz * alpha_P_z,
    ]
    return out


def regressor(on: Arithmetic, robot: Any, motion: Any) -> Any:
    """Columns of Y, and a status: what is wrong with a leg."""
    out = Regressor()
    out.legs = regressor_of_leg(on, robot.leg, robot, motion)
    out.platform = regressor_of_platform(on, robot, motion)
    reach = reach_of(on, robot.leg.b, motion.t, out.legs.q)
    out.status = first_of(on, fault_of(on, out.legs.L, out.legs.k3, reach))
    return out
