"""Closed form of the Stewart platform's equations of motion, formulation and joint `exact`.

Written by stewart-sym 0.1.0 with SymPy 1.14; do not edit.
SPDX-License-Identifier: 0BSD

    M [a; alpha] + C [v; omega] + g + friction = H F + [R F_ext; R M_ext]

``robot`` has the fields of ``stewart_robot`` in stewart.h as arrays, legs first: b (6, 3), I_d0 (6, 3, 3).
``motion`` has R (..., 3, 3), t, omega, v, and, where accelerations or loads are read, alpha, a, F_ext, M_ext
(..., 3). Wrenches and twists in base axes about the reference point. Units as in stewart.h.
"""

from typing import Any

import numpy as np

from .assembly import NOT_FINITE, OK, POLE, POLE_SINE, ROUNDING, SHORT_LEG, SHORTEST, Array, eliminate_many

INDEFINITE = 6

_ROWS = tuple(f"{part}_{axis}" for part in ("force", "moment") for axis in "xyz")

# Operations of a pose before any solve.
OPERATIONS: dict[str, int] = {
    "equations": 4655,
    "bias": 2034,
    "forward_dynamics": 2916,
    "derivatives": 11249,
}

_ADDED = ("M_add", "h_add_x", "h_add_y", "h_add_z", "J_add_xx", "J_add_xy", "J_add_xz", "J_add_yy",
        "J_add_yz", "J_add_zz", "C_add")
_SUMMED: dict[str, tuple[str, ...]] = {
    "equations": ("M_vv_xx", "M_vv_xy", "M_vv_xz", "M_vv_yy", "M_vv_yz", "M_vv_zz", "M_vw_xx", "M_vw_xy",
        "M_vw_xz", "M_vw_yx", "M_vw_yy", "M_vw_yz", "M_vw_zx", "M_vw_zy", "M_vw_zz", "M_ww_xx", "M_ww_xy",
        "M_ww_xz", "M_ww_yy", "M_ww_yz", "M_ww_zz", "C_vv_xx", "C_vv_xy", "C_vv_xz", "C_vv_yx", "C_vv_yy",
        "C_vv_yz", "C_vv_zx", "C_vv_zy", "C_vv_zz", "C_vw_xx", "C_vw_xy", "C_vw_xz", "C_vw_yx", "C_vw_yy",
        "C_vw_yz", "C_vw_zx", "C_vw_zy", "C_vw_zz", "C_wv_xx", "C_wv_xy", "C_wv_xz", "C_wv_yx", "C_wv_yy",
        "C_wv_yz", "C_wv_zx", "C_wv_zy", "C_wv_zz", "C_ww_xx", "C_ww_xy", "C_ww_xz", "C_ww_yx", "C_ww_yy",
        "C_ww_yz", "C_ww_zx", "C_ww_zy", "C_ww_zz", "g_force_x", "g_force_y", "g_force_z", "g_moment_x",
        "g_moment_y", "g_moment_z", "friction_force_x", "friction_force_y", "friction_force_z",
        "friction_moment_x", "friction_moment_y", "friction_moment_z"),
    "bias": ("bias_force_x", "bias_force_y", "bias_force_z", "bias_moment_x", "bias_moment_y",
        "bias_moment_z"),
    "forward_dynamics": ("M_vv_xx", "M_vv_xy", "M_vv_xz", "M_vv_yy", "M_vv_yz", "M_vv_zz", "M_vw_xx",
        "M_vw_xy", "M_vw_xz", "M_vw_yx", "M_vw_yy", "M_vw_yz", "M_vw_zx", "M_vw_zy", "M_vw_zz", "M_ww_xx",
        "M_ww_xy", "M_ww_xz", "M_ww_yy", "M_ww_yz", "M_ww_zz", "right_force_x", "right_force_y",
        "right_force_z", "right_moment_x", "right_moment_y", "right_moment_z"),
    "derivatives": ("M_vv_xx", "M_vv_xy", "M_vv_xz", "M_vv_yy", "M_vv_yz", "M_vv_zz", "M_vw_xx", "M_vw_xy",
        "M_vw_xz", "M_vw_yx", "M_vw_yy", "M_vw_yz", "M_vw_zx", "M_vw_zy", "M_vw_zz", "M_ww_xx", "M_ww_xy",
        "M_ww_xz", "M_ww_yy", "M_ww_yz", "M_ww_zz", "W_ft_xx", "W_ft_xy", "W_ft_xz", "W_ft_yx", "W_ft_yy",
        "W_ft_yz", "W_ft_zx", "W_ft_zy", "W_ft_zz", "W_fr_xx", "W_fr_xy", "W_fr_xz", "W_fr_yx", "W_fr_yy",
        "W_fr_yz", "W_fr_zx", "W_fr_zy", "W_fr_zz", "W_mt_xx", "W_mt_xy", "W_mt_xz", "W_mt_yx", "W_mt_yy",
        "W_mt_yz", "W_mt_zx", "W_mt_zy", "W_mt_zz", "W_mr_xx", "W_mr_xy", "W_mr_xz", "W_mr_yx", "W_mr_yy",
        "W_mr_yz", "W_mr_zx", "W_mr_zy", "W_mr_zz", "W_fv_xx", "W_fv_xy", "W_fv_xz", "W_fv_yx", "W_fv_yy",
        "W_fv_yz", "W_fv_zx", "W_fv_zy", "W_fv_zz", "W_fw_xx", "W_fw_xy", "W_fw_xz", "W_fw_yx", "W_fw_yy",
        "W_fw_yz", "W_fw_zx", "W_fw_zy", "W_fw_zz", "W_mv_xx", "W_mv_xy", "W_mv_xz", "W_mv_yx", "W_mv_yy",
        "W_mv_yz", "W_mv_zx", "W_mv_zy", "W_mv_zz", "W_mw_xx", "W_mw_xy", "W_mw_xz", "W_mw_yx", "W_mw_yy",
        "W_mw_yz", "W_mw_zx", "W_mw_zy", "W_mw_zz"),
}


def equations(robot: Any, motion: Any) -> dict[str, Array]:
    """M, C, H, H_dot (..., 6, 6), g, friction, bias (..., 6) and status (...)."""
    total, leg, status = _sums("equations", robot, motion)
    C = np.concatenate(
        [
            np.concatenate([_matrix(total, "C_vv"), _matrix(total, "C_vw")], axis=-1),
            np.concatenate([_matrix(total, "C_wv"), _matrix(total, "C_ww")], axis=-1),
        ],
        axis=-2,
    )
    g, friction = _wrench(total, "g"), _wrench(total, "friction")
    twist = np.concatenate([motion.v, motion.omega], axis=-1)
    found = {
        "M": _inertia(total),
        "C": C,
        "g": g,
        "friction": friction,
        "bias": g + friction + (C @ twist[..., None])[..., 0],
        "H": _columns(leg, "H"),
        "H_dot": _columns(leg, "H_dot"),
    }
    return _good(found, status)


def bias(robot: Any, motion: Any) -> dict[str, Array]:
    """C [v; omega] + g + friction, bias (..., 6), and status (...)."""
    total, _, status = _sums("bias", robot, motion)
    return _good({"bias": _wrench(total, "bias")}, status)


def forward_dynamics(robot: Any, motion: Any, F: Array) -> dict[str, Array]:
    """acceleration [a; alpha] (..., 6) under F (..., 6), and status (...)."""
    total, _, status = _sums("forward_dynamics", robot, motion, F)
    x, fault = _solve_definite(_inertia(total), _wrench(total, "right")[..., None])
    return _good({"acceleration": x[..., 0]}, np.where(status == OK, fault, status))


def joint_inertia(robot: Any, motion: Any) -> dict[str, Array]:
    """H^-1 M H^-T, inertia (..., 6, 6), and status (...)."""
    found = equations(robot, motion)
    half, fault = eliminate_many(found["H"], found["M"])
    whole, _ = eliminate_many(found["H"], half.swapaxes(-1, -2))
    status = np.where(found["status"] == OK, fault, found["status"])
    return _good({"inertia": 0.5 * (whole + whole.swapaxes(-1, -2))}, status)


def derivatives(robot: Any, motion: Any, F: Array) -> dict[str, Array]:
    """by_pose, by_twist, by_acceleration (..., 6, 6) of F (..., 6), this motion's forces; status (...)."""
    total, leg, status = _sums("derivatives", robot, motion, F)
    pose, twist = _slopes(total)
    right = np.concatenate([pose, twist, _inertia(total)], axis=-1)
    x, fault = eliminate_many(_columns(leg, "H"), right)
    names = ("by_pose", "by_twist", "by_acceleration")
    found = dict(zip(names, np.split(x, 3, axis=-1), strict=True))
    return _good(found, np.where(status == OK, fault, status))


def linearisation(robot: Any, motion: Any, F: Array) -> dict[str, Array]:
    """A (..., 12, 12), B (..., 12, 6) about this motion; its accelerations must be those under F; status."""
    total, leg, status = _sums("derivatives", robot, motion, F)
    pose, twist = _slopes(total)
    right = np.concatenate([pose, twist, _columns(leg, "H")], axis=-1)
    x, fault = _solve_definite(_inertia(total), right)
    A = np.zeros((*status.shape, 12, 12))
    A[..., :6, 6:] = np.eye(6)
    A[..., 3, 4], A[..., 4, 3] = -motion.omega[..., 2], motion.omega[..., 2]
    A[..., 5, 3], A[..., 3, 5] = -motion.omega[..., 1], motion.omega[..., 1]
    A[..., 4, 5], A[..., 5, 4] = -motion.omega[..., 0], motion.omega[..., 0]
    A[..., 6:, :] = -x[..., :12]
    B = np.concatenate([np.zeros_like(x[..., 12:]), x[..., 12:]], axis=-2)
    return _good({"A": A, "B": B}, np.where(status == OK, fault, status))


def prepared(robot: Any) -> tuple[dict[str, Any], dict[str, Any]]:
    """Constants of the legs, each (6,), and of the platform, by component name."""
    leg = prepare_leg(robot)
    added = {name: np.sum(leg.pop(name)) for name in _ADDED}
    return leg, prepare_platform(robot, added)


def _sums(
    what: str, robot: Any, motion: Any, F: Array | None = None
) -> tuple[dict[str, Array], dict[str, Array], Array]:
    """Sums over the machine, what each leg hands out, status of every pose."""
    leg, platform = prepared(robot)
    of_platform, of_leg = _PARTS[what]
    with np.errstate(all="ignore"):
        pose = {name: np.asarray(value) for name, value in of_platform(platform, motion).items()}
        shape = (*motion.t.shape[:-1], 6)
        parts = {
            name: np.broadcast_to(value, shape)
            for name, value in of_leg(leg, platform, pose, motion, F).items()
        }
        total = {name: np.broadcast_to(pose[name], shape[:-1]) + _six(parts[name]) for name in _SUMMED[what]}
        return total, parts, _leg_status(leg, pose, parts)


def _six(parts: Array) -> Array:
    total = parts[..., 0]
    for i in range(1, 6):
        total = total + parts[..., i]
    return total


def _leg_status(leg: dict[str, Array], pose: dict[str, Array], parts: dict[str, Array]) -> Array:
    """The first leg's fault of each pose: not finite, too short, along its universal axis."""
    terms = [parts[f"S_1_{axis}"] for axis in "xyz"]
    terms += [pose[f"t_1_{axis}"][..., None] for axis in "xyz"] + [leg[f"r_{axis}"] for axis in "xyz"]
    L, reach = parts["L"], np.abs(np.broadcast_arrays(*terms)).max(axis=0)
    fault = np.where(parts["k3"] > POLE_SINE, OK, POLE)
    fault = np.where(L > np.maximum(ROUNDING * reach, SHORTEST), fault, SHORT_LEG)
    fault = np.where(np.isfinite(L), fault, NOT_FINITE)
    first = np.argmax(fault != OK, axis=-1)
    return np.take_along_axis(fault, first[..., None], axis=-1)[..., 0]


def _matrix(total: dict[str, Array], name: str, symmetric: bool = False) -> Array:
    """A 3x3 matrix from its components."""
    keys = [(min(i, j), max(i, j)) if symmetric else (i, j) for i in range(3) for j in range(3)]
    parts = [total[f"{name}_{'xyz'[i]}{'xyz'[j]}"] for i, j in keys]
    return np.stack(parts, axis=-1).reshape(*parts[0].shape, 3, 3)


def _inertia(total: dict[str, Array]) -> Array:
    vw = _matrix(total, "M_vw")
    upper = np.concatenate([_matrix(total, "M_vv", symmetric=True), vw], axis=-1)
    lower = np.concatenate([vw.swapaxes(-1, -2), _matrix(total, "M_ww", symmetric=True)], axis=-1)
    return np.concatenate([upper, lower], axis=-2)


def _slopes(total: dict[str, Array]) -> tuple[Array, Array]:
    """Derivatives of the wrench by pose and by twist."""
    found = []
    for columns in ("tr", "vw"):
        rows = [[_matrix(total, f"W_{row}{column}") for column in columns] for row in "fm"]
        found.append(np.concatenate([np.concatenate(row, axis=-1) for row in rows], axis=-2))
    return found[0], found[1]


def _wrench(total: dict[str, Array], name: str) -> Array:
    return np.stack([total[f"{name}_{row}"] for row in _ROWS], axis=-1)


def _columns(leg: dict[str, Array], name: str) -> Array:
    """Rows of force and moment, one column a leg."""
    return np.stack([leg[f"{name}_{row}"] for row in _ROWS], axis=-2)


def _solve_definite(M: Array, right: Array) -> tuple[Array, Array]:
    """x of M x = right by L D L^T, and the status (...)."""
    A = np.concatenate([M, right], axis=-1)
    scale = np.diagonal(M, axis1=-2, axis2=-1)
    status = np.zeros(M.shape[:-2], dtype=np.int32)
    with np.errstate(all="ignore"):
        for k in range(6):
            pivot = A[..., k, k]
            fault = np.where(np.isfinite(pivot), INDEFINITE, NOT_FINITE)
            status = np.where((status == OK) & ~(pivot > ROUNDING * scale[..., k]), fault, status)
            factor = A[..., k + 1 :, k] * (1 / pivot)[..., None]
            A[..., k + 1 :, :] -= factor[..., None] * A[..., k, None, :]
        for k in range(5, -1, -1):
            A[..., k, 6:] *= (1 / A[..., k, k])[..., None]
            A[..., :k, 6:] -= A[..., :k, k, None] * A[..., k, None, 6:]
    return A[..., 6:], status


def _good(found: dict[str, Array], status: Array) -> dict[str, Array]:
    """Results with NaN where the status is not 0, and the status."""
    finite = np.ones(status.shape, dtype=bool)
    for value in found.values():
        finite &= np.isfinite(value).all(axis=tuple(range(status.ndim, value.ndim)))
    status = np.where((status == OK) & ~finite, NOT_FINITE, status).astype(np.int32)
    blank = {
        name: np.where((status == OK)[(..., *(None,) * (value.ndim - status.ndim))], value, np.nan)
        for name, value in found.items()
    }
    return {**blank, "status": status}


def prepare_leg(robot: Any) -> dict[str, Any]:
    """Constants of one leg, and what it adds to the platform.

    Operations: 99 (55 mul, 42 add, 1 div, 1 sqrt).
    """
    b_x = robot.b[:, 0]
    b_y = robot.b[:, 1]
    b_z = robot.b[:, 2]
    p_x = robot.p[:, 0]
    p_y = robot.p[:, 1]
    p_z = robot.p[:, 2]
    k_x = robot.k[:, 0]
    k_y = robot.k[:, 1]
    k_z = robot.k[:, 2]
    m_d = robot.m_d
    r_d0_x = robot.r_d0[:, 0]
    r_d0_y = robot.r_d0[:, 1]
    r_d0_z = robot.r_d0[:, 2]
    I_d0_xx = robot.I_d0[:, 0, 0]
    I_d0_xy = robot.I_d0[:, 0, 1]
    I_d0_xz = robot.I_d0[:, 0, 2]
    I_d0_yy = robot.I_d0[:, 1, 1]
    I_d0_yz = robot.I_d0[:, 1, 2]
    I_d0_zz = robot.I_d0[:, 2, 2]
    m_u = robot.m_u
    r_u0_x = robot.r_u0[:, 0]
    r_u0_y = robot.r_u0[:, 1]
    r_u0_z = robot.r_u0[:, 2]
    I_u0_xx = robot.I_u0[:, 0, 0]
    I_u0_xy = robot.I_u0[:, 0, 1]
    I_u0_xz = robot.I_u0[:, 0, 2]
    I_u0_yy = robot.I_u0[:, 1, 1]
    I_u0_yz = robot.I_u0[:, 1, 2]
    I_u0_zz = robot.I_u0[:, 2, 2]
    C_u = robot.C_u
    C_p = robot.C_p
    C_s = robot.C_s
    b_1_x = robot.b[0, 0]
    b_1_y = robot.b[0, 1]
    b_1_z = robot.b[0, 2]
    g_x = robot.g[0]
    g_y = robot.g[1]
    g_z = robot.g[2]
    k_size = np.sqrt(k_x*k_x + k_y*k_y + k_z*k_z)
    inv_k_size = 1/k_size
    # fixed axis, of length one
    k_unit_x = inv_k_size*k_x
    k_unit_y = inv_k_size*k_y
    k_unit_z = inv_k_size*k_z
    c1 = m_u*r_u0_x
    h_x = c1
    c2 = m_u*r_u0_y
    h_y = c2
    h_z = m_u*r_u0_z
    c3 = m_d*r_d0_x
    w_x = c3 + h_x
    c4 = m_d*r_d0_y
    w_y = c4 + h_y
    w_z = h_z + m_d*r_d0_z
    c5 = r_d0_y*r_d0_y
    c6 = r_d0_z*r_d0_z
    c7 = r_u0_y*r_u0_y
    c8 = r_u0_z*r_u0_z
    J_xx = I_d0_xx + I_u0_xx + m_d*(c5 + c6) + m_u*(c7 + c8)
    J_xy = I_d0_xy + I_u0_xy - c1*r_u0_y - c3*r_d0_y
    J_xz = I_d0_xz + I_u0_xz - c1*r_u0_z - c3*r_d0_z
    c9 = r_d0_x*r_d0_x
    c10 = r_u0_x*r_u0_x
    J_yy = I_d0_yy + I_u0_yy + m_d*(c6 + c9) + m_u*(c10 + c8)
    J_yz = I_d0_yz + I_u0_yz - c2*r_u0_z - c4*r_d0_z
    J_zz = I_d0_zz + I_u0_zz + m_d*(c5 + c9) + m_u*(c10 + c7)
    c11 = m_u*p_x
    c12 = m_u*p_y
    c13 = p_y*p_y
    c14 = p_z*p_z
    c15 = p_x*p_x
    return {
        "p_x": p_x,
        "p_y": p_y,
        "p_z": p_z,
        "k_x": k_unit_x,
        "k_y": k_unit_y,
        "k_z": k_unit_z,
        "C_p": C_p,
        "C_s": C_s,
        "h_x": h_x,
        "h_y": h_y,
        "h_z": h_z,
        "h2_x": 2*h_x,
        "h2_y": 2*h_y,
        "h2_z": 2*h_z,
        "w_x": w_x,
        "w_y": w_y,
        "w_z": w_z,
        "J_xx": J_xx,
        "J_xy": J_xy,
        "J_xz": J_xz,
        "J_yy": J_yy,
        "J_yz": J_yz,
        "J_zz": J_zz,
        "J2_xz": 2*J_xz,
        "dJ_zx": J_zz - J_xx,
        "g_k": g_x*k_unit_x + g_y*k_unit_y + g_z*k_unit_z,
        "g_x_k_x": g_y*k_unit_z - g_z*k_unit_y,
        "g_x_k_y": g_z*k_unit_x - g_x*k_unit_z,
        "g_x_k_z": g_x*k_unit_y - g_y*k_unit_x,
        "C_us": C_s + C_u,
        "r_x": b_x - b_1_x,
        "r_y": b_y - b_1_y,
        "r_z": b_z - b_1_z,
        "M_add": m_u,
        "h_add_x": c11,
        "h_add_y": c12,
        "h_add_z": m_u*p_z,
        "J_add_xx": m_u*(c13 + c14),
        "J_add_xy": -c11*p_y,
        "J_add_xz": -c11*p_z,
        "J_add_yy": m_u*(c14 + c15),
        "J_add_yz": -c12*p_z,
        "J_add_zz": m_u*(c13 + c15),
        "C_add": C_s,
    }


def prepare_platform(robot: Any, added: Any) -> dict[str, Any]:
    """Constants of the platform.

    Operations: 34 (12 mul, 22 add, 0 div, 0 sqrt).
    """
    M = robot.M
    R_0_x = robot.R_0[0]
    R_0_y = robot.R_0[1]
    R_0_z = robot.R_0[2]
    I_p_xx = robot.I_p[0, 0]
    I_p_xy = robot.I_p[0, 1]
    I_p_xz = robot.I_p[0, 2]
    I_p_yy = robot.I_p[1, 1]
    I_p_yz = robot.I_p[1, 2]
    I_p_zz = robot.I_p[2, 2]
    g_x = robot.g[0]
    g_y = robot.g[1]
    g_z = robot.g[2]
    b_1_x = robot.b[0, 0]
    b_1_y = robot.b[0, 1]
    b_1_z = robot.b[0, 2]
    M_add = added["M_add"]
    h_add_x = added["h_add_x"]
    h_add_y = added["h_add_y"]
    h_add_z = added["h_add_z"]
    J_add_xx = added["J_add_xx"]
    J_add_xy = added["J_add_xy"]
    J_add_xz = added["J_add_xz"]
    J_add_yy = added["J_add_yy"]
    J_add_yz = added["J_add_yz"]
    J_add_zz = added["J_add_zz"]
    C_add = added["C_add"]
    c1 = R_0_y*R_0_y
    c2 = R_0_z*R_0_z
    J_P_xx = I_p_xx + J_add_xx + M*(c1 + c2)
    c3 = M*R_0_x
    J_P_xy = I_p_xy + J_add_xy - R_0_y*c3
    J_P_xz = I_p_xz + J_add_xz - R_0_z*c3
    c4 = R_0_x*R_0_x
    J_P_yy = I_p_yy + J_add_yy + M*(c2 + c4)
    c5 = M*R_0_y
    J_P_yz = I_p_yz + J_add_yz - R_0_z*c5
    J_P_zz = I_p_zz + J_add_zz + M*(c1 + c4)
    return {
        "M_P": M + M_add,
        "h_P_x": c3 + h_add_x,
        "h_P_y": c5 + h_add_y,
        "h_P_z": M*R_0_z + h_add_z,
        "J_P_xx": J_P_xx,
        "J_P_xy": J_P_xy,
        "J_P_xz": J_P_xz,
        "J_P_yy": J_P_yy,
        "J_P_yz": J_P_yz,
        "J_P_zz": J_P_zz,
        "dJ_P_x": J_P_zz - J_P_yy,
        "dJ_P_y": J_P_xx - J_P_zz,
        "dJ_P_z": J_P_yy - J_P_xx,
        "C_P": C_add,
        "g_x": g_x,
        "g_y": g_y,
        "g_z": g_z,
        "b_1_x": b_1_x,
        "b_1_y": b_1_y,
        "b_1_z": b_1_z,
    }


def equations_of_platform(platform: Any, motion: Any) -> dict[str, Any]:
    """The platform's part of M, C, g and friction.

    Operations: 155 (93 mul, 62 add, 0 div, 0 sqrt).
    """
    R_xx = motion.R[..., 0, 0]
    R_xy = motion.R[..., 0, 1]
    R_xz = motion.R[..., 0, 2]
    R_yx = motion.R[..., 1, 0]
    R_yy = motion.R[..., 1, 1]
    R_yz = motion.R[..., 1, 2]
    R_zx = motion.R[..., 2, 0]
    R_zy = motion.R[..., 2, 1]
    R_zz = motion.R[..., 2, 2]
    t_x = motion.t[..., 0]
    t_y = motion.t[..., 1]
    t_z = motion.t[..., 2]
    omega_x = motion.omega[..., 0]
    omega_y = motion.omega[..., 1]
    omega_z = motion.omega[..., 2]
    M_P = platform["M_P"]
    h_P_x = platform["h_P_x"]
    h_P_y = platform["h_P_y"]
    h_P_z = platform["h_P_z"]
    J_P_xx = platform["J_P_xx"]
    J_P_xy = platform["J_P_xy"]
    J_P_xz = platform["J_P_xz"]
    J_P_yy = platform["J_P_yy"]
    J_P_yz = platform["J_P_yz"]
    J_P_zz = platform["J_P_zz"]
    C_P = platform["C_P"]
    b_1_x = platform["b_1_x"]
    b_1_y = platform["b_1_y"]
    b_1_z = platform["b_1_z"]
    g_x = platform["g_x"]
    g_y = platform["g_y"]
    g_z = platform["g_z"]
    # (30) first moment of the platform, base frame
    h_base_x = R_xx*h_P_x + R_xy*h_P_y + R_xz*h_P_z
    h_base_y = R_yx*h_P_x + R_yy*h_P_y + R_yz*h_P_z
    h_base_z = R_zx*h_P_x + R_zy*h_P_y + R_zz*h_P_z
    c1 = J_P_xx*R_xx + J_P_xy*R_xy + J_P_xz*R_xz
    c2 = J_P_xy*R_xx + J_P_yy*R_xy + J_P_yz*R_xz
    c3 = J_P_xz*R_xx + J_P_yz*R_xy + J_P_zz*R_xz
    c4 = J_P_xx*R_yx + J_P_xy*R_yy + J_P_xz*R_yz
    c5 = J_P_xy*R_yx + J_P_yy*R_yy + J_P_yz*R_yz
    c6 = J_P_xz*R_yx + J_P_yz*R_yy + J_P_zz*R_yz
    # (32) inertia of the platform, base frame
    J_base_xx = R_xx*c1 + R_xy*c2 + R_xz*c3
    J_base_xy = R_yx*c1 + R_yy*c2 + R_yz*c3
    J_base_xz = R_zx*c1 + R_zy*c2 + R_zz*c3
    J_base_yy = R_yx*c4 + R_yy*c5 + R_yz*c6
    J_base_yz = R_zx*c4 + R_zy*c5 + R_zz*c6
    J_base_zz = (
        R_zx*(J_P_xx*R_zx + J_P_xy*R_zy + J_P_xz*R_zz) + R_zy*(J_P_xy*R_zx + J_P_yy*R_zy + J_P_yz*R_zz)
        + R_zz*(J_P_xz*R_zx + J_P_yz*R_zy + J_P_zz*R_zz)
    )
    # (31) omega x h
    w_h_x = h_base_z*omega_y - h_base_y*omega_z
    w_h_y = h_base_x*omega_z - h_base_z*omega_x
    w_h_z = h_base_y*omega_x - h_base_x*omega_y
    half_trace = 0.5*J_base_xx + 0.5*J_base_yy + 0.5*J_base_zz
    c7 = J_base_xy*omega_z
    c8 = J_base_xz*omega_y
    c9 = half_trace*omega_z
    c10 = half_trace*omega_y
    c11 = -J_base_yz*omega_x
    c12 = half_trace*omega_x
    return {
        "t_1_x": t_x - b_1_x,
        "t_1_y": t_y - b_1_y,
        "t_1_z": t_z - b_1_z,
        "M_vv_xx": M_P,
        "M_vv_xy": 0,
        "M_vv_xz": 0,
        "M_vv_yy": M_P,
        "M_vv_yz": 0,
        "M_vv_zz": M_P,
        "M_vw_xx": 0,
        "M_vw_xy": h_base_z,
        "M_vw_xz": -h_base_y,
        "M_vw_yx": -h_base_z,
        "M_vw_yy": 0,
        "M_vw_yz": h_base_x,
        "M_vw_zx": h_base_y,
        "M_vw_zy": -h_base_x,
        "M_vw_zz": 0,
        "M_ww_xx": J_base_xx,
        "M_ww_xy": J_base_xy,
        "M_ww_xz": J_base_xz,
        "M_ww_yy": J_base_yy,
        "M_ww_yz": J_base_yz,
        "M_ww_zz": J_base_zz,
        "C_vv_xx": 0,
        "C_vv_xy": 0,
        "C_vv_xz": 0,
        "C_vv_yx": 0,
        "C_vv_yy": 0,
        "C_vv_yz": 0,
        "C_vv_zx": 0,
        "C_vv_zy": 0,
        "C_vv_zz": 0,
        "C_vw_xx": 0,
        "C_vw_xy": w_h_z,
        "C_vw_xz": -w_h_y,
        "C_vw_yx": -w_h_z,
        "C_vw_yy": 0,
        "C_vw_yz": w_h_x,
        "C_vw_zx": w_h_y,
        "C_vw_zy": -w_h_x,
        "C_vw_zz": 0,
        "C_wv_xx": 0,
        "C_wv_xy": 0,
        "C_wv_xz": 0,
        "C_wv_yx": 0,
        "C_wv_yy": 0,
        "C_wv_yz": 0,
        "C_wv_zx": 0,
        "C_wv_zy": 0,
        "C_wv_zz": 0,
        "C_ww_xx": c8 - c7,
        "C_ww_xy": J_base_yz*omega_y + c9 - J_base_yy*omega_z,
        "C_ww_xz": J_base_zz*omega_y - J_base_yz*omega_z - c10,
        "C_ww_yx": J_base_xx*omega_z - J_base_xz*omega_x - c9,
        "C_ww_yy": c11 + c7,
        "C_ww_yz": J_base_xz*omega_z + c12 - J_base_zz*omega_x,
        "C_ww_zx": J_base_xy*omega_x + c10 - J_base_xx*omega_y,
        "C_ww_zy": J_base_yy*omega_x - J_base_xy*omega_y - c12,
        "C_ww_zz": -c11 - c8,
        "g_force_x": -M_P*g_x,
        "g_force_y": -M_P*g_y,
        "g_force_z": -M_P*g_z,
        "g_moment_x": g_y*h_base_z - g_z*h_base_y,
        "g_moment_y": g_z*h_base_x - g_x*h_base_z,
        "g_moment_z": g_x*h_base_y - g_y*h_base_x,
        "friction_force_x": 0,
        "friction_force_y": 0,
        "friction_force_z": 0,
        "friction_moment_x": C_P*omega_x,
        "friction_moment_y": C_P*omega_y,
        "friction_moment_z": C_P*omega_z,
    }


def equations_of_leg(leg: Any, platform: Any, pose: Any, motion: Any, F: Any) -> dict[str, Any]:
    """One leg's part of M, C, g and friction, its column of H and the column's rate.

    Operations: 681 (422 mul, 255 add, 2 div, 2 sqrt).
    """
    p_x = leg["p_x"]
    p_y = leg["p_y"]
    p_z = leg["p_z"]
    k_x = leg["k_x"]
    k_y = leg["k_y"]
    k_z = leg["k_z"]
    C_p = leg["C_p"]
    C_s = leg["C_s"]
    h_x = leg["h_x"]
    h_y = leg["h_y"]
    h_z = leg["h_z"]
    h2_x = leg["h2_x"]
    h2_z = leg["h2_z"]
    w_x = leg["w_x"]
    w_y = leg["w_y"]
    w_z = leg["w_z"]
    J_xx = leg["J_xx"]
    J_xy = leg["J_xy"]
    J_xz = leg["J_xz"]
    J_yy = leg["J_yy"]
    J_yz = leg["J_yz"]
    J_zz = leg["J_zz"]
    J2_xz = leg["J2_xz"]
    dJ_zx = leg["dJ_zx"]
    g_k = leg["g_k"]
    g_x_k_x = leg["g_x_k_x"]
    g_x_k_y = leg["g_x_k_y"]
    g_x_k_z = leg["g_x_k_z"]
    C_us = leg["C_us"]
    R_xx = motion.R[..., 0, 0, None]
    R_xy = motion.R[..., 0, 1, None]
    R_xz = motion.R[..., 0, 2, None]
    R_yx = motion.R[..., 1, 0, None]
    R_yy = motion.R[..., 1, 1, None]
    R_yz = motion.R[..., 1, 2, None]
    R_zx = motion.R[..., 2, 0, None]
    R_zy = motion.R[..., 2, 1, None]
    R_zz = motion.R[..., 2, 2, None]
    omega_x = motion.omega[..., 0, None]
    omega_y = motion.omega[..., 1, None]
    omega_z = motion.omega[..., 2, None]
    v_x = motion.v[..., 0, None]
    v_y = motion.v[..., 1, None]
    v_z = motion.v[..., 2, None]
    g_x = platform["g_x"]
    g_y = platform["g_y"]
    g_z = platform["g_z"]
    t_1_x = pose["t_1_x"][..., None]
    t_1_y = pose["t_1_y"][..., None]
    t_1_z = pose["t_1_z"][..., None]
    r_x = leg["r_x"]
    r_y = leg["r_y"]
    r_z = leg["r_z"]
    # (1) platform point from the reference point
    q_x = R_xx*p_x + R_xy*p_y + R_xz*p_z
    q_y = R_yx*p_x + R_yy*p_y + R_yz*p_z
    q_z = R_zx*p_x + R_zy*p_y + R_zz*p_z
    # (1) platform point from base point 1, base frame
    S_1_x = q_x + t_1_x
    S_1_y = q_y + t_1_y
    S_1_z = q_z + t_1_z
    # (1) leg vector
    S_x = S_1_x - r_x
    S_y = S_1_y - r_y
    S_z = S_1_z - r_z
    # (10) leg vector along the fixed axis, and normal to both
    zeta = S_x*k_x + S_y*k_y + S_z*k_z
    k_cross_S_x = S_z*k_y - S_y*k_z
    k_cross_S_y = S_x*k_z - S_z*k_x
    k_cross_S_z = S_y*k_x - S_x*k_y
    # (2) leg length, and distance of its tip from the fixed axis
    L = np.sqrt(S_x*S_x + S_y*S_y + S_z*S_z)
    inv_L = 1/L
    # (3) unit vector along the leg
    s_x = S_x*inv_L
    s_y = S_y*inv_L
    s_z = S_z*inv_L
    # (10) along the third axis of the leg
    s_cross_normal_x = k_cross_S_z*s_y - k_cross_S_y*s_z
    s_cross_normal_y = k_cross_S_x*s_z - k_cross_S_z*s_x
    s_cross_normal_z = k_cross_S_y*s_x - k_cross_S_x*s_y
    # (10) leg length, and distance of its tip from the fixed axis
    rho = (
        np.sqrt(s_cross_normal_x*s_cross_normal_x + s_cross_normal_y*s_cross_normal_y
        + s_cross_normal_z*s_cross_normal_z)
    )
    inv_rho = 1/rho
    # (10) third axis of the leg frame
    z_x = inv_rho*s_cross_normal_x
    z_y = inv_rho*s_cross_normal_y
    z_z = inv_rho*s_cross_normal_z
    # (10) rotating axis of the universal joint
    y_x = s_z*z_y - s_y*z_z
    y_y = s_x*z_z - s_z*z_x
    y_z = s_y*z_x - s_x*z_y
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = inv_L*zeta
    k3 = inv_L*rho
    # (10) k1 / k3
    kappa = inv_rho*zeta
    # (4) velocity of the platform point
    S_dot_x = omega_y*q_z + v_x - omega_z*q_y
    S_dot_y = omega_z*q_x + v_y - omega_x*q_z
    S_dot_z = omega_x*q_y + v_z - omega_y*q_x
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x*s_x + S_dot_y*s_y + S_dot_z*s_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = inv_rho*(S_dot_x*y_x + S_dot_y*y_y + S_dot_z*y_z)
    theta_dot = -inv_L*(S_dot_x*z_x + S_dot_y*z_y + S_dot_z*z_z)
    c1 = k3*k3
    k33 = c1
    k13 = k1*k3
    L_h2 = L*h2_x
    a1 = L_h2 + dJ_zx
    a2 = J2_xz - L*h2_z
    c2 = J_xy - L*h_y
    a3 = c2
    # (19) inertia of the joint coordinates
    M_phi = J_xx + a1*k33 + a2*k13
    M_theta = J_yy + L_h2
    M_mixed = J_yz*k3 + a3*k1
    k3_h = h_y*k3
    c3 = inv_L*inv_rho
    c4 = inv_L*inv_L
    # inertia at the tip, leg frame
    m_leg_sy = -inv_rho*k3_h
    m_leg_sz = -h_z*inv_L
    m_leg_yy = M_phi*inv_rho*inv_rho
    m_leg_yz = -M_mixed*c3
    m_leg_zz = M_theta*c4
    m_T_xs = m_leg_sy*y_x + m_leg_sz*z_x
    m_T_xy = m_leg_sy*s_x + m_leg_yy*y_x + m_leg_yz*z_x
    m_T_xz = m_leg_sz*s_x + m_leg_yz*y_x + m_leg_zz*z_x
    m_T_ys = m_leg_sy*y_y + m_leg_sz*z_y
    m_T_yy = m_leg_sy*s_y + m_leg_yy*y_y + m_leg_yz*z_y
    m_T_yz = m_leg_sz*s_y + m_leg_yz*y_y + m_leg_zz*z_y
    m_T_zs = m_leg_sy*y_z + m_leg_sz*z_z
    m_T_zy = m_leg_sy*s_z + m_leg_yy*y_z + m_leg_yz*z_z
    m_T_zz = m_leg_sz*s_z + m_leg_yz*y_z + m_leg_zz*z_z
    # inertia at the tip, base frame
    m_xx = m_T_xs*s_x + m_T_xy*y_x + m_T_xz*z_x
    m_xy = m_T_xs*s_y + m_T_xy*y_y + m_T_xz*z_y
    m_xz = m_T_xs*s_z + m_T_xy*y_z + m_T_xz*z_z
    m_yy = m_T_ys*s_y + m_T_yy*y_y + m_T_yz*z_y
    m_yz = m_T_ys*s_z + m_T_yy*y_z + m_T_yz*z_z
    m_zz = m_T_zs*s_z + m_T_zy*y_z + m_T_zz*z_z
    c5 = h_x*theta_dot
    C_xi_12 = -c5
    c6 = c1*h_x - h_z*k1*k3
    C_xi_13 = -c6*phi_dot
    C_xi_21 = c5
    C_xi_22 = L_dot*h_x
    c7 = 2*L
    c8 = 2*J_xz - c7*h_z
    c9 = 0.5*k1*(c8*k1 + 2*k3*(J_zz + c7*h_x - J_xx)) - 0.5*c1*c8
    C_xi_23 = -c9*phi_dot
    c10 = h_y*k1
    C_xi_31 = c6*phi_dot - c10*theta_dot
    C_xi_32 = c9*phi_dot + theta_dot*(J_yz*k1 - c2*k3) - L_dot*c10
    C_xi_33 = L_dot*c6 + c9*theta_dot
    c11 = k3*phi_dot
    G_dot_12 = c11
    G_dot_21 = -inv_L*theta_dot
    c12 = k1*phi_dot
    G_dot_22 = c12*inv_L
    G_dot_23 = L_dot*c4
    G_dot_31 = -c11*inv_rho
    G_dot_32 = -L_dot*c3 - inv_rho*kappa*theta_dot
    G_dot_33 = c12*inv_rho
    C_leg_11 = G_dot_21*h_z - G_dot_31*k3_h
    C_leg_12 = C_xi_13*inv_rho + G_dot_22*h_z - G_dot_32*k3_h
    C_leg_13 = G_dot_23*h_z - C_xi_12*inv_L - G_dot_33*k3_h
    C_leg_21 = inv_rho*(C_xi_31 + G_dot_21*M_mixed + G_dot_31*M_phi)
    C_leg_22 = inv_rho*(C_xi_33*inv_rho + G_dot_22*M_mixed + G_dot_32*M_phi - G_dot_12*k3_h)
    C_leg_23 = inv_rho*(G_dot_23*M_mixed + G_dot_33*M_phi + k3_h*theta_dot - C_xi_32*inv_L)
    C_leg_31 = -inv_L*(C_xi_21 + G_dot_21*M_theta + G_dot_31*M_mixed)
    C_leg_32 = -inv_L*(C_xi_23*inv_rho + G_dot_12*h_z + G_dot_22*M_theta + G_dot_32*M_mixed)
    C_leg_33 = -inv_L*(G_dot_23*M_theta + G_dot_33*M_mixed - C_xi_22*inv_L - h_z*theta_dot)
    C_tip_T_xs = C_leg_11*s_x + C_leg_21*y_x + C_leg_31*z_x
    C_tip_T_xy = C_leg_12*s_x + C_leg_22*y_x + C_leg_32*z_x
    C_tip_T_xz = C_leg_13*s_x + C_leg_23*y_x + C_leg_33*z_x
    C_tip_T_ys = C_leg_11*s_y + C_leg_21*y_y + C_leg_31*z_y
    C_tip_T_yy = C_leg_12*s_y + C_leg_22*y_y + C_leg_32*z_y
    C_tip_T_yz = C_leg_13*s_y + C_leg_23*y_y + C_leg_33*z_y
    C_tip_T_zs = C_leg_11*s_z + C_leg_21*y_z + C_leg_31*z_z
    C_tip_T_zy = C_leg_12*s_z + C_leg_22*y_z + C_leg_32*z_z
    C_tip_T_zz = C_leg_13*s_z + C_leg_23*y_z + C_leg_33*z_z
    # Coriolis matrix at the tip, base frame
    C_tip_xx = C_tip_T_xs*s_x + C_tip_T_xy*y_x + C_tip_T_xz*z_x
    C_tip_xy = C_tip_T_xs*s_y + C_tip_T_xy*y_y + C_tip_T_xz*z_y
    C_tip_xz = C_tip_T_xs*s_z + C_tip_T_xy*y_z + C_tip_T_xz*z_z
    C_tip_yx = C_tip_T_ys*s_x + C_tip_T_yy*y_x + C_tip_T_yz*z_x
    C_tip_yy = C_tip_T_ys*s_y + C_tip_T_yy*y_y + C_tip_T_yz*z_y
    C_tip_yz = C_tip_T_ys*s_z + C_tip_T_yy*y_z + C_tip_T_yz*z_z
    C_tip_zx = C_tip_T_zs*s_x + C_tip_T_zy*y_x + C_tip_T_zz*z_x
    C_tip_zy = C_tip_T_zs*s_y + C_tip_T_zy*y_y + C_tip_T_zz*z_y
    C_tip_zz = C_tip_T_zs*s_z + C_tip_T_zy*y_z + C_tip_T_zz*z_z
    # (4) omega x q
    w_q_x = S_dot_x - v_x
    w_q_y = S_dot_y - v_y
    w_q_z = S_dot_z - v_z
    c13 = C_tip_xy*q_z
    c14 = m_xy*w_q_z
    c15 = C_tip_xz*q_y
    c16 = m_xz*w_q_y
    C_q_xx = c15 + c16 - c13 - c14
    c17 = C_tip_xx*q_z
    C_q_xy = c17 + m_xx*w_q_z - C_tip_xz*q_x - m_xz*w_q_x
    c18 = C_tip_xx*q_y
    C_q_xz = C_tip_xy*q_x + m_xy*w_q_x - c18 - m_xx*w_q_y
    c19 = C_tip_yy*q_z
    C_q_yx = C_tip_yz*q_y + m_yz*w_q_y - c19 - m_yy*w_q_z
    c20 = C_tip_yx*q_z
    c21 = -C_tip_yz*q_x
    c22 = -m_yz*w_q_x
    C_q_yy = c14 + c20 + c21 + c22
    c23 = -C_tip_yy*q_x
    C_q_yz = m_yy*w_q_x - C_tip_yx*q_y - c23 - m_xy*w_q_y
    c24 = -C_tip_zz*q_y
    C_q_zx = m_zz*w_q_y - C_tip_zy*q_z - c24 - m_yz*w_q_z
    c25 = -C_tip_zz*q_x
    C_q_zy = C_tip_zx*q_z + c25 + m_xz*w_q_z - m_zz*w_q_x
    c26 = C_tip_zx*q_y
    c27 = -C_tip_zy*q_x
    C_q_zz = -c16 - c22 - c26 - c27
    # gravity along k x y and along y
    gamma_n = g_x_k_x*y_x + g_x_k_y*y_y + g_x_k_z*y_z
    gamma_y = g_x*y_x + g_y*y_y + g_z*y_z
    # first moment along k and against k x y
    w_k = k1*w_x + k3*w_z
    w_n = k3*w_x - k1*w_z
    c28 = inv_L*(g_k*w_n + gamma_n*w_k)
    c29 = -gamma_n*w_y - gamma_y*w_n
    # against gravity
    held_x = c29*inv_rho*y_x - c28*z_x
    held_y = c29*inv_rho*y_y - c28*z_y
    held_z = c29*inv_rho*y_z - c28*z_z
    c30 = L_dot*s_x
    c31 = inv_rho*(C_us*phi_dot - C_s*(k_x*omega_x + k_y*omega_y + k_z*omega_z))
    c32 = inv_L*(C_us*theta_dot - C_s*(omega_x*y_x + omega_y*y_y + omega_z*y_z))
    c33 = L_dot*s_y
    c34 = L_dot*s_z
    # against friction
    rubbed_x = C_p*c30 + c31*y_x - c32*z_x
    rubbed_y = C_p*c33 + c31*y_y - c32*z_y
    rubbed_z = C_p*c34 + c31*y_z - c32*z_z
    # (3) rate of s
    s_dot_x = inv_L*(S_dot_x - c30)
    s_dot_y = inv_L*(S_dot_y - c33)
    s_dot_z = inv_L*(S_dot_z - c34)
    c35 = m_xy*q_z
    c36 = m_xz*q_y
    c37 = -m_yz*q_x
    # m [q]x
    m_q_xx = c35 - c36
    m_q_xy = m_xz*q_x - m_xx*q_z
    m_q_xz = m_xx*q_y - m_xy*q_x
    m_q_yx = m_yy*q_z - m_yz*q_y
    m_q_yy = -c35 - c37
    m_q_yz = m_xy*q_y - m_yy*q_x
    m_q_zx = m_yz*q_z - m_zz*q_y
    m_q_zy = m_zz*q_x - m_xz*q_z
    m_q_zz = c36 + c37
    return {
        "M_vv_xx": m_xx,
        "M_vv_xy": m_xy,
        "M_vv_xz": m_xz,
        "M_vv_yy": m_yy,
        "M_vv_yz": m_yz,
        "M_vv_zz": m_zz,
        "M_vw_xx": -m_q_xx,
        "M_vw_xy": -m_q_xy,
        "M_vw_xz": -m_q_xz,
        "M_vw_yx": -m_q_yx,
        "M_vw_yy": -m_q_yy,
        "M_vw_yz": -m_q_yz,
        "M_vw_zx": -m_q_zx,
        "M_vw_zy": -m_q_zy,
        "M_vw_zz": -m_q_zz,
        "M_ww_xx": m_q_yx*q_z - m_q_zx*q_y,
        "M_ww_xy": m_q_yy*q_z - m_q_zy*q_y,
        "M_ww_xz": m_q_yz*q_z - m_q_zz*q_y,
        "M_ww_yy": m_q_zy*q_x - m_q_xy*q_z,
        "M_ww_yz": m_q_zz*q_x - m_q_xz*q_z,
        "M_ww_zz": m_q_xz*q_y - m_q_yz*q_x,
        "C_vv_xx": C_tip_xx,
        "C_vv_xy": C_tip_xy,
        "C_vv_xz": C_tip_xz,
        "C_vv_yx": C_tip_yx,
        "C_vv_yy": C_tip_yy,
        "C_vv_yz": C_tip_yz,
        "C_vv_zx": C_tip_zx,
        "C_vv_zy": C_tip_zy,
        "C_vv_zz": C_tip_zz,
        "C_vw_xx": C_q_xx,
        "C_vw_xy": C_q_xy,
        "C_vw_xz": C_q_xz,
        "C_vw_yx": C_q_yx,
        "C_vw_yy": C_q_yy,
        "C_vw_yz": C_q_yz,
        "C_vw_zx": C_q_zx,
        "C_vw_zy": C_q_zy,
        "C_vw_zz": C_q_zz,
        "C_wv_xx": c26 - c20,
        "C_wv_xy": C_tip_zy*q_y - c19,
        "C_wv_xz": -C_tip_yz*q_z - c24,
        "C_wv_yx": c17 - C_tip_zx*q_x,
        "C_wv_yy": c13 + c27,
        "C_wv_yz": C_tip_xz*q_z + c25,
        "C_wv_zx": C_tip_yx*q_x - c18,
        "C_wv_zy": -C_tip_xy*q_y - c23,
        "C_wv_zz": -c15 - c21,
        "C_ww_xx": C_q_zx*q_y - C_q_yx*q_z,
        "C_ww_xy": C_q_zy*q_y - C_q_yy*q_z,
        "C_ww_xz": C_q_zz*q_y - C_q_yz*q_z,
        "C_ww_yx": C_q_xx*q_z - C_q_zx*q_x,
        "C_ww_yy": C_q_xy*q_z - C_q_zy*q_x,
        "C_ww_yz": C_q_xz*q_z - C_q_zz*q_x,
        "C_ww_zx": C_q_yx*q_x - C_q_xx*q_y,
        "C_ww_zy": C_q_yy*q_x - C_q_xy*q_y,
        "C_ww_zz": C_q_yz*q_x - C_q_xz*q_y,
        "g_force_x": held_x,
        "g_force_y": held_y,
        "g_force_z": held_z,
        "g_moment_x": held_z*q_y - held_y*q_z,
        "g_moment_y": held_x*q_z - held_z*q_x,
        "g_moment_z": held_y*q_x - held_x*q_y,
        "friction_force_x": rubbed_x,
        "friction_force_y": rubbed_y,
        "friction_force_z": rubbed_z,
        "friction_moment_x": q_y*rubbed_z - C_s*(k_x*phi_dot + theta_dot*y_x) - q_z*rubbed_y,
        "friction_moment_y": q_z*rubbed_x - C_s*(k_y*phi_dot + theta_dot*y_y) - q_x*rubbed_z,
        "friction_moment_z": q_x*rubbed_y - C_s*(k_z*phi_dot + theta_dot*y_z) - q_y*rubbed_x,
        "H_force_x": s_x,
        "H_force_y": s_y,
        "H_force_z": s_z,
        "H_moment_x": q_y*s_z - q_z*s_y,
        "H_moment_y": q_z*s_x - q_x*s_z,
        "H_moment_z": q_x*s_y - q_y*s_x,
        "H_dot_force_x": s_dot_x,
        "H_dot_force_y": s_dot_y,
        "H_dot_force_z": s_dot_z,
        "H_dot_moment_x": q_y*s_dot_z + s_z*w_q_y - q_z*s_dot_y - s_y*w_q_z,
        "H_dot_moment_y": q_z*s_dot_x + s_x*w_q_z - q_x*s_dot_z - s_z*w_q_x,
        "H_dot_moment_z": q_x*s_dot_y + s_y*w_q_x - q_y*s_dot_x - s_x*w_q_y,
        "S_1_x": S_1_x,
        "S_1_y": S_1_y,
        "S_1_z": S_1_z,
        "L": L,
        "k3": k3,
    }


def bias_of_platform(platform: Any, motion: Any) -> dict[str, Any]:
    """The platform's part of C twist + g + friction.

    Operations: 168 (99 mul, 69 add, 0 div, 0 sqrt).
    """
    R_xx = motion.R[..., 0, 0]
    R_xy = motion.R[..., 0, 1]
    R_xz = motion.R[..., 0, 2]
    R_yx = motion.R[..., 1, 0]
    R_yy = motion.R[..., 1, 1]
    R_yz = motion.R[..., 1, 2]
    R_zx = motion.R[..., 2, 0]
    R_zy = motion.R[..., 2, 1]
    R_zz = motion.R[..., 2, 2]
    t_x = motion.t[..., 0]
    t_y = motion.t[..., 1]
    t_z = motion.t[..., 2]
    omega_x = motion.omega[..., 0]
    omega_y = motion.omega[..., 1]
    omega_z = motion.omega[..., 2]
    M_P = platform["M_P"]
    h_P_x = platform["h_P_x"]
    h_P_y = platform["h_P_y"]
    h_P_z = platform["h_P_z"]
    J_P_xx = platform["J_P_xx"]
    J_P_xy = platform["J_P_xy"]
    J_P_xz = platform["J_P_xz"]
    J_P_yy = platform["J_P_yy"]
    J_P_yz = platform["J_P_yz"]
    J_P_zz = platform["J_P_zz"]
    C_P = platform["C_P"]
    b_1_x = platform["b_1_x"]
    b_1_y = platform["b_1_y"]
    b_1_z = platform["b_1_z"]
    g_x = platform["g_x"]
    g_y = platform["g_y"]
    g_z = platform["g_z"]
    # (30) first moment of the platform, base frame
    h_base_x = R_xx*h_P_x + R_xy*h_P_y + R_xz*h_P_z
    h_base_y = R_yx*h_P_x + R_yy*h_P_y + R_yz*h_P_z
    h_base_z = R_zx*h_P_x + R_zy*h_P_y + R_zz*h_P_z
    c1 = J_P_xx*R_xx + J_P_xy*R_xy + J_P_xz*R_xz
    c2 = J_P_xy*R_xx + J_P_yy*R_xy + J_P_yz*R_xz
    c3 = J_P_xz*R_xx + J_P_yz*R_xy + J_P_zz*R_xz
    c4 = J_P_xx*R_yx + J_P_xy*R_yy + J_P_xz*R_yz
    c5 = J_P_xy*R_yx + J_P_yy*R_yy + J_P_yz*R_yz
    c6 = J_P_xz*R_yx + J_P_yz*R_yy + J_P_zz*R_yz
    # (32) inertia of the platform, base frame
    J_base_xx = R_xx*c1 + R_xy*c2 + R_xz*c3
    J_base_xy = R_yx*c1 + R_yy*c2 + R_yz*c3
    J_base_xz = R_zx*c1 + R_zy*c2 + R_zz*c3
    J_base_yy = R_yx*c4 + R_yy*c5 + R_yz*c6
    J_base_yz = R_zx*c4 + R_zy*c5 + R_zz*c6
    J_base_zz = (
        R_zx*(J_P_xx*R_zx + J_P_xy*R_zy + J_P_xz*R_zz) + R_zy*(J_P_xy*R_zx + J_P_yy*R_zy + J_P_yz*R_zz)
        + R_zz*(J_P_xz*R_zx + J_P_yz*R_zy + J_P_zz*R_zz)
    )
    # (31) omega x h
    w_h_x = h_base_z*omega_y - h_base_y*omega_z
    w_h_y = h_base_x*omega_z - h_base_z*omega_x
    w_h_z = h_base_y*omega_x - h_base_x*omega_y
    # (34) I omega
    J_w_x = J_base_xx*omega_x + J_base_xy*omega_y + J_base_xz*omega_z
    J_w_y = J_base_xy*omega_x + J_base_yy*omega_y + J_base_yz*omega_z
    J_w_z = J_base_xz*omega_x + J_base_yz*omega_y + J_base_zz*omega_z
    # products of omega
    omega_xx = omega_x*omega_x
    omega_xy = omega_x*omega_y
    omega_xz = omega_x*omega_z
    omega_yy = omega_y*omega_y
    omega_yz = omega_y*omega_z
    omega_zz = omega_z*omega_z
    # (7) S_ddot = B q + a
    B_xx = -omega_yy - omega_zz
    B_yy = -omega_xx - omega_zz
    B_zz = -omega_xx - omega_yy
    return {
        "t_1_x": t_x - b_1_x,
        "t_1_y": t_y - b_1_y,
        "t_1_z": t_z - b_1_z,
        "B_0_xx": B_xx,
        "B_0_xy": omega_xy,
        "B_0_xz": omega_xz,
        "B_0_yx": omega_xy,
        "B_0_yy": B_yy,
        "B_0_yz": omega_yz,
        "B_0_zx": omega_xz,
        "B_0_zy": omega_yz,
        "B_0_zz": B_zz,
        "bias_force_x": omega_y*w_h_z - M_P*g_x - omega_z*w_h_y,
        "bias_force_y": omega_z*w_h_x - M_P*g_y - omega_x*w_h_z,
        "bias_force_z": omega_x*w_h_y - M_P*g_z - omega_y*w_h_x,
        "bias_moment_x": C_P*omega_x + J_w_z*omega_y + g_y*h_base_z - J_w_y*omega_z - g_z*h_base_y,
        "bias_moment_y": C_P*omega_y + J_w_x*omega_z + g_z*h_base_x - J_w_z*omega_x - g_x*h_base_z,
        "bias_moment_z": C_P*omega_z + J_w_y*omega_x + g_x*h_base_y - J_w_x*omega_y - g_y*h_base_x,
    }


def bias_of_leg(leg: Any, platform: Any, pose: Any, motion: Any, F: Any) -> dict[str, Any]:
    """One leg's part of C twist + g + friction.

    Operations: 305 (183 mul, 118 add, 2 div, 2 sqrt).
    """
    p_x = leg["p_x"]
    p_y = leg["p_y"]
    p_z = leg["p_z"]
    k_x = leg["k_x"]
    k_y = leg["k_y"]
    k_z = leg["k_z"]
    C_p = leg["C_p"]
    C_s = leg["C_s"]
    h_x = leg["h_x"]
    h_y = leg["h_y"]
    h_z = leg["h_z"]
    h2_x = leg["h2_x"]
    h2_y = leg["h2_y"]
    h2_z = leg["h2_z"]
    w_x = leg["w_x"]
    w_y = leg["w_y"]
    w_z = leg["w_z"]
    J_xx = leg["J_xx"]
    J_xy = leg["J_xy"]
    J_yy = leg["J_yy"]
    J_yz = leg["J_yz"]
    J2_xz = leg["J2_xz"]
    dJ_zx = leg["dJ_zx"]
    g_k = leg["g_k"]
    g_x_k_x = leg["g_x_k_x"]
    g_x_k_y = leg["g_x_k_y"]
    g_x_k_z = leg["g_x_k_z"]
    C_us = leg["C_us"]
    R_xx = motion.R[..., 0, 0, None]
    R_xy = motion.R[..., 0, 1, None]
    R_xz = motion.R[..., 0, 2, None]
    R_yx = motion.R[..., 1, 0, None]
    R_yy = motion.R[..., 1, 1, None]
    R_yz = motion.R[..., 1, 2, None]
    R_zx = motion.R[..., 2, 0, None]
    R_zy = motion.R[..., 2, 1, None]
    R_zz = motion.R[..., 2, 2, None]
    omega_x = motion.omega[..., 0, None]
    omega_y = motion.omega[..., 1, None]
    omega_z = motion.omega[..., 2, None]
    v_x = motion.v[..., 0, None]
    v_y = motion.v[..., 1, None]
    v_z = motion.v[..., 2, None]
    B_0_xx = pose["B_0_xx"][..., None]
    B_0_xy = pose["B_0_xy"][..., None]
    B_0_xz = pose["B_0_xz"][..., None]
    B_0_yx = pose["B_0_yx"][..., None]
    B_0_yy = pose["B_0_yy"][..., None]
    B_0_yz = pose["B_0_yz"][..., None]
    B_0_zx = pose["B_0_zx"][..., None]
    B_0_zy = pose["B_0_zy"][..., None]
    B_0_zz = pose["B_0_zz"][..., None]
    g_x = platform["g_x"]
    g_y = platform["g_y"]
    g_z = platform["g_z"]
    t_1_x = pose["t_1_x"][..., None]
    t_1_y = pose["t_1_y"][..., None]
    t_1_z = pose["t_1_z"][..., None]
    r_x = leg["r_x"]
    r_y = leg["r_y"]
    r_z = leg["r_z"]
    # (1) platform point from the reference point
    q_x = R_xx*p_x + R_xy*p_y + R_xz*p_z
    q_y = R_yx*p_x + R_yy*p_y + R_yz*p_z
    q_z = R_zx*p_x + R_zy*p_y + R_zz*p_z
    # (1) platform point from base point 1, base frame
    S_1_x = q_x + t_1_x
    S_1_y = q_y + t_1_y
    S_1_z = q_z + t_1_z
    # (1) leg vector
    S_x = S_1_x - r_x
    S_y = S_1_y - r_y
    S_z = S_1_z - r_z
    # (10) leg vector along the fixed axis, and normal to both
    zeta = S_x*k_x + S_y*k_y + S_z*k_z
    k_cross_S_x = S_z*k_y - S_y*k_z
    k_cross_S_y = S_x*k_z - S_z*k_x
    k_cross_S_z = S_y*k_x - S_x*k_y
    # (2) leg length, and distance of its tip from the fixed axis
    L = np.sqrt(S_x*S_x + S_y*S_y + S_z*S_z)
    inv_L = 1/L
    # (3) unit vector along the leg
    s_x = S_x*inv_L
    s_y = S_y*inv_L
    s_z = S_z*inv_L
    # (10) along the third axis of the leg
    s_cross_normal_x = k_cross_S_z*s_y - k_cross_S_y*s_z
    s_cross_normal_y = k_cross_S_x*s_z - k_cross_S_z*s_x
    s_cross_normal_z = k_cross_S_y*s_x - k_cross_S_x*s_y
    # (10) leg length, and distance of its tip from the fixed axis
    rho = (
        np.sqrt(s_cross_normal_x*s_cross_normal_x + s_cross_normal_y*s_cross_normal_y
        + s_cross_normal_z*s_cross_normal_z)
    )
    inv_rho = 1/rho
    # (10) third axis of the leg frame
    z_x = inv_rho*s_cross_normal_x
    z_y = inv_rho*s_cross_normal_y
    z_z = inv_rho*s_cross_normal_z
    # (10) rotating axis of the universal joint
    y_x = s_z*z_y - s_y*z_z
    y_y = s_x*z_z - s_z*z_x
    y_z = s_y*z_x - s_x*z_y
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = inv_L*zeta
    k3 = inv_L*rho
    # (10) k1 / k3
    kappa = inv_rho*zeta
    # (4) velocity of the platform point
    S_dot_x = omega_y*q_z + v_x - omega_z*q_y
    S_dot_y = omega_z*q_x + v_y - omega_x*q_z
    S_dot_z = omega_x*q_y + v_z - omega_y*q_x
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x*s_x + S_dot_y*s_y + S_dot_z*s_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = inv_rho*(S_dot_x*y_x + S_dot_y*y_y + S_dot_z*y_z)
    theta_dot = -inv_L*(S_dot_x*z_x + S_dot_y*z_y + S_dot_z*z_z)
    # L_dot / L
    L_share = L_dot*inv_L
    lean = kappa*theta_dot
    theta_dot2 = theta_dot*theta_dot
    phi_dot2 = phi_dot*phi_dot
    two_phi_dot = 2*phi_dot
    # (7) acceleration of the platform point, a = alpha = 0
    S_ddot_x = B_0_xx*q_x + B_0_xy*q_y + B_0_xz*q_z
    S_ddot_y = B_0_yx*q_x + B_0_yy*q_y + B_0_yz*q_z
    S_ddot_z = B_0_zx*q_x + B_0_zy*q_y + B_0_zz*q_z
    k33 = k3*k3
    # (8) accelerations of the joint coordinates
    L_ddot = L*(k33*phi_dot2 + theta_dot2) + S_ddot_x*s_x + S_ddot_y*s_y + S_ddot_z*s_z
    # (9) accelerations of the joint coordinates but for the turning of the leg frame about s
    own_theta_ddot = -2*L_share*theta_dot - inv_L*(S_ddot_x*z_x + S_ddot_y*z_y + S_ddot_z*z_z)
    own_phi_ddot = inv_rho*(S_ddot_x*y_x + S_ddot_y*y_y + S_ddot_z*y_z) - L_share*two_phi_dot
    c1 = k1*k3
    # (9) accelerations of the joint coordinates
    theta_ddot = c1*phi_dot2 + own_theta_ddot
    phi_ddot = own_phi_ddot - lean*two_phi_dot
    k13 = c1
    L_h2 = L*h2_x
    a1 = L_h2 + dJ_zx
    c2 = L*h2_z
    c3 = J2_xz - c2
    a2 = c3
    a3 = J_xy - L*h_y
    # (19) inertia of the joint coordinates
    M_phi = J_xx + a1*k33 + a2*k13
    M_theta = J_yy + L_h2
    M_mixed = J_yz*k3 + a3*k1
    k3_h = h_y*k3
    # (19) slopes of M_phi / 2 along theta and L, of M_mixed along theta
    M_phi_L = h_x*k33 - h_z*k13
    M_mixed_theta = J_yz*k1 - a3*k3
    bend = L_dot*theta_dot
    # gravity along k x y and along y
    gamma_n = g_x_k_x*y_x + g_x_k_y*y_y + g_x_k_z*y_z
    gamma_y = g_x*y_x + g_y*y_y + g_z*y_z
    # first moment along k and against k x y
    w_k = k1*w_x + k3*w_z
    w_n = k3*w_x - k1*w_z
    # (20) generalised forces about y and about k
    tau_y = (
        C_us*theta_dot + L_ddot*h_z + M_mixed*phi_ddot + M_theta*own_theta_ddot + bend*h2_x + g_k*w_n
        + gamma_n*w_k + phi_dot2*(k13*(J_yy - dJ_zx) - c3*(0.5 - k33)) - C_s*(omega_x*y_x + omega_y*y_y
        + omega_z*y_z)
    )
    tau_k = (
        C_us*phi_dot + M_mixed*theta_ddot + M_mixed_theta*theta_dot2 + M_phi*own_phi_ddot
        + two_phi_dot*(L_dot*M_phi_L - theta_dot*(0.5*J2_xz + J_xx*kappa - 0.5*c2)) - C_s*(k_x*omega_x
        + k_y*omega_y + k_z*omega_z) - L_ddot*k3_h - bend*h2_y*k1 - gamma_n*w_y - gamma_y*w_n
    )
    # (21) K = Q_y y + Q_z z
    Q_y = inv_rho*tau_k
    Q_z = -inv_L*tau_y
    # (21) force at the spherical joint, base frame
    K_x = Q_y*y_x + Q_z*z_x
    K_y = Q_y*y_y + Q_z*z_y
    K_z = Q_y*y_z + Q_z*z_z
    # (24) known part of the actuator force, to match
    D = C_p*L_dot + h_z*theta_ddot - M_phi_L*phi_dot2 - h_x*theta_dot2 - k3_h*phi_ddot
    # force at the tip
    R_tip_x = D*s_x + K_x
    R_tip_y = D*s_y + K_y
    R_tip_z = D*s_z + K_z
    return {
        "bias_force_x": R_tip_x,
        "bias_force_y": R_tip_y,
        "bias_force_z": R_tip_z,
        "bias_moment_x": R_tip_z*q_y - C_s*(k_x*phi_dot + theta_dot*y_x) - R_tip_y*q_z,
        "bias_moment_y": R_tip_x*q_z - C_s*(k_y*phi_dot + theta_dot*y_y) - R_tip_z*q_x,
        "bias_moment_z": R_tip_y*q_x - C_s*(k_z*phi_dot + theta_dot*y_z) - R_tip_x*q_y,
        "S_1_x": S_1_x,
        "S_1_y": S_1_y,
        "S_1_z": S_1_z,
        "L": L,
        "k3": k3,
    }


def forward_of_platform(platform: Any, motion: Any) -> dict[str, Any]:
    """The platform's part of M and of the right side.

    Operations: 204 (117 mul, 87 add, 0 div, 0 sqrt).
    """
    R_xx = motion.R[..., 0, 0]
    R_xy = motion.R[..., 0, 1]
    R_xz = motion.R[..., 0, 2]
    R_yx = motion.R[..., 1, 0]
    R_yy = motion.R[..., 1, 1]
    R_yz = motion.R[..., 1, 2]
    R_zx = motion.R[..., 2, 0]
    R_zy = motion.R[..., 2, 1]
    R_zz = motion.R[..., 2, 2]
    t_x = motion.t[..., 0]
    t_y = motion.t[..., 1]
    t_z = motion.t[..., 2]
    omega_x = motion.omega[..., 0]
    omega_y = motion.omega[..., 1]
    omega_z = motion.omega[..., 2]
    F_ext_x = motion.F_ext[..., 0]
    F_ext_y = motion.F_ext[..., 1]
    F_ext_z = motion.F_ext[..., 2]
    M_ext_x = motion.M_ext[..., 0]
    M_ext_y = motion.M_ext[..., 1]
    M_ext_z = motion.M_ext[..., 2]
    M_P = platform["M_P"]
    h_P_x = platform["h_P_x"]
    h_P_y = platform["h_P_y"]
    h_P_z = platform["h_P_z"]
    J_P_xx = platform["J_P_xx"]
    J_P_xy = platform["J_P_xy"]
    J_P_xz = platform["J_P_xz"]
    J_P_yy = platform["J_P_yy"]
    J_P_yz = platform["J_P_yz"]
    J_P_zz = platform["J_P_zz"]
    C_P = platform["C_P"]
    b_1_x = platform["b_1_x"]
    b_1_y = platform["b_1_y"]
    b_1_z = platform["b_1_z"]
    g_x = platform["g_x"]
    g_y = platform["g_y"]
    g_z = platform["g_z"]
    # (30) first moment of the platform, base frame
    h_base_x = R_xx*h_P_x + R_xy*h_P_y + R_xz*h_P_z
    h_base_y = R_yx*h_P_x + R_yy*h_P_y + R_yz*h_P_z
    h_base_z = R_zx*h_P_x + R_zy*h_P_y + R_zz*h_P_z
    c1 = J_P_xx*R_xx + J_P_xy*R_xy + J_P_xz*R_xz
    c2 = J_P_xy*R_xx + J_P_yy*R_xy + J_P_yz*R_xz
    c3 = J_P_xz*R_xx + J_P_yz*R_xy + J_P_zz*R_xz
    c4 = J_P_xx*R_yx + J_P_xy*R_yy + J_P_xz*R_yz
    c5 = J_P_xy*R_yx + J_P_yy*R_yy + J_P_yz*R_yz
    c6 = J_P_xz*R_yx + J_P_yz*R_yy + J_P_zz*R_yz
    # (32) inertia of the platform, base frame
    J_base_xx = R_xx*c1 + R_xy*c2 + R_xz*c3
    J_base_xy = R_yx*c1 + R_yy*c2 + R_yz*c3
    J_base_xz = R_zx*c1 + R_zy*c2 + R_zz*c3
    J_base_yy = R_yx*c4 + R_yy*c5 + R_yz*c6
    J_base_yz = R_zx*c4 + R_zy*c5 + R_zz*c6
    J_base_zz = (
        R_zx*(J_P_xx*R_zx + J_P_xy*R_zy + J_P_xz*R_zz) + R_zy*(J_P_xy*R_zx + J_P_yy*R_zy + J_P_yz*R_zz)
        + R_zz*(J_P_xz*R_zx + J_P_yz*R_zy + J_P_zz*R_zz)
    )
    # (31) omega x h
    w_h_x = h_base_z*omega_y - h_base_y*omega_z
    w_h_y = h_base_x*omega_z - h_base_z*omega_x
    w_h_z = h_base_y*omega_x - h_base_x*omega_y
    # (34) I omega
    J_w_x = J_base_xx*omega_x + J_base_xy*omega_y + J_base_xz*omega_z
    J_w_y = J_base_xy*omega_x + J_base_yy*omega_y + J_base_yz*omega_z
    J_w_z = J_base_xz*omega_x + J_base_yz*omega_y + J_base_zz*omega_z
    # products of omega
    omega_xx = omega_x*omega_x
    omega_xy = omega_x*omega_y
    omega_xz = omega_x*omega_z
    omega_yy = omega_y*omega_y
    omega_yz = omega_y*omega_z
    omega_zz = omega_z*omega_z
    # (7) S_ddot = B q + a
    B_xx = -omega_yy - omega_zz
    B_yy = -omega_xx - omega_zz
    B_zz = -omega_xx - omega_yy
    return {
        "t_1_x": t_x - b_1_x,
        "t_1_y": t_y - b_1_y,
        "t_1_z": t_z - b_1_z,
        "B_0_xx": B_xx,
        "B_0_xy": omega_xy,
        "B_0_xz": omega_xz,
        "B_0_yx": omega_xy,
        "B_0_yy": B_yy,
        "B_0_yz": omega_yz,
        "B_0_zx": omega_xz,
        "B_0_zy": omega_yz,
        "B_0_zz": B_zz,
        "M_vv_xx": M_P,
        "M_vv_xy": 0,
        "M_vv_xz": 0,
        "M_vv_yy": M_P,
        "M_vv_yz": 0,
        "M_vv_zz": M_P,
        "M_vw_xx": 0,
        "M_vw_xy": h_base_z,
        "M_vw_xz": -h_base_y,
        "M_vw_yx": -h_base_z,
        "M_vw_yy": 0,
        "M_vw_yz": h_base_x,
        "M_vw_zx": h_base_y,
        "M_vw_zy": -h_base_x,
        "M_vw_zz": 0,
        "M_ww_xx": J_base_xx,
        "M_ww_xy": J_base_xy,
        "M_ww_xz": J_base_xz,
        "M_ww_yy": J_base_yy,
        "M_ww_yz": J_base_yz,
        "M_ww_zz": J_base_zz,
        "right_force_x": (
            F_ext_x*R_xx + F_ext_y*R_xy + F_ext_z*R_xz + M_P*g_x + omega_z*w_h_y - omega_y*w_h_z
        ),
        "right_force_y": (
            F_ext_x*R_yx + F_ext_y*R_yy + F_ext_z*R_yz + M_P*g_y + omega_x*w_h_z - omega_z*w_h_x
        ),
        "right_force_z": (
            F_ext_x*R_zx + F_ext_y*R_zy + F_ext_z*R_zz + M_P*g_z + omega_y*w_h_x - omega_x*w_h_y
        ),
        "right_moment_x": (
            J_w_y*omega_z + M_ext_x*R_xx + M_ext_y*R_xy + M_ext_z*R_xz + g_z*h_base_y - C_P*omega_x
            - J_w_z*omega_y - g_y*h_base_z
        ),
        "right_moment_y": (
            J_w_z*omega_x + M_ext_x*R_yx + M_ext_y*R_yy + M_ext_z*R_yz + g_x*h_base_z - C_P*omega_y
            - J_w_x*omega_z - g_z*h_base_x
        ),
        "right_moment_z": (
            J_w_x*omega_y + M_ext_x*R_zx + M_ext_y*R_zy + M_ext_z*R_zz + g_y*h_base_x - C_P*omega_z
            - J_w_y*omega_x - g_x*h_base_y
        ),
    }


def forward_of_leg(leg: Any, platform: Any, pose: Any, motion: Any, F: Any) -> dict[str, Any]:
    """One leg's part of M and of the right side.

    Operations: 425 (260 mul, 161 add, 2 div, 2 sqrt).
    """
    p_x = leg["p_x"]
    p_y = leg["p_y"]
    p_z = leg["p_z"]
    k_x = leg["k_x"]
    k_y = leg["k_y"]
    k_z = leg["k_z"]
    C_p = leg["C_p"]
    C_s = leg["C_s"]
    h_x = leg["h_x"]
    h_y = leg["h_y"]
    h_z = leg["h_z"]
    h2_x = leg["h2_x"]
    h2_y = leg["h2_y"]
    h2_z = leg["h2_z"]
    w_x = leg["w_x"]
    w_y = leg["w_y"]
    w_z = leg["w_z"]
    J_xx = leg["J_xx"]
    J_xy = leg["J_xy"]
    J_yy = leg["J_yy"]
    J_yz = leg["J_yz"]
    J2_xz = leg["J2_xz"]
    dJ_zx = leg["dJ_zx"]
    g_k = leg["g_k"]
    g_x_k_x = leg["g_x_k_x"]
    g_x_k_y = leg["g_x_k_y"]
    g_x_k_z = leg["g_x_k_z"]
    C_us = leg["C_us"]
    R_xx = motion.R[..., 0, 0, None]
    R_xy = motion.R[..., 0, 1, None]
    R_xz = motion.R[..., 0, 2, None]
    R_yx = motion.R[..., 1, 0, None]
    R_yy = motion.R[..., 1, 1, None]
    R_yz = motion.R[..., 1, 2, None]
    R_zx = motion.R[..., 2, 0, None]
    R_zy = motion.R[..., 2, 1, None]
    R_zz = motion.R[..., 2, 2, None]
    omega_x = motion.omega[..., 0, None]
    omega_y = motion.omega[..., 1, None]
    omega_z = motion.omega[..., 2, None]
    v_x = motion.v[..., 0, None]
    v_y = motion.v[..., 1, None]
    v_z = motion.v[..., 2, None]
    B_0_xx = pose["B_0_xx"][..., None]
    B_0_xy = pose["B_0_xy"][..., None]
    B_0_xz = pose["B_0_xz"][..., None]
    B_0_yx = pose["B_0_yx"][..., None]
    B_0_yy = pose["B_0_yy"][..., None]
    B_0_yz = pose["B_0_yz"][..., None]
    B_0_zx = pose["B_0_zx"][..., None]
    B_0_zy = pose["B_0_zy"][..., None]
    B_0_zz = pose["B_0_zz"][..., None]
    F = F
    g_x = platform["g_x"]
    g_y = platform["g_y"]
    g_z = platform["g_z"]
    t_1_x = pose["t_1_x"][..., None]
    t_1_y = pose["t_1_y"][..., None]
    t_1_z = pose["t_1_z"][..., None]
    r_x = leg["r_x"]
    r_y = leg["r_y"]
    r_z = leg["r_z"]
    # (1) platform point from the reference point
    q_x = R_xx*p_x + R_xy*p_y + R_xz*p_z
    q_y = R_yx*p_x + R_yy*p_y + R_yz*p_z
    q_z = R_zx*p_x + R_zy*p_y + R_zz*p_z
    # (1) platform point from base point 1, base frame
    S_1_x = q_x + t_1_x
    S_1_y = q_y + t_1_y
    S_1_z = q_z + t_1_z
    # (1) leg vector
    S_x = S_1_x - r_x
    S_y = S_1_y - r_y
    S_z = S_1_z - r_z
    # (10) leg vector along the fixed axis, and normal to both
    zeta = S_x*k_x + S_y*k_y + S_z*k_z
    k_cross_S_x = S_z*k_y - S_y*k_z
    k_cross_S_y = S_x*k_z - S_z*k_x
    k_cross_S_z = S_y*k_x - S_x*k_y
    # (2) leg length, and distance of its tip from the fixed axis
    L = np.sqrt(S_x*S_x + S_y*S_y + S_z*S_z)
    inv_L = 1/L
    # (3) unit vector along the leg
    s_x = S_x*inv_L
    s_y = S_y*inv_L
    s_z = S_z*inv_L
    # (10) along the third axis of the leg
    s_cross_normal_x = k_cross_S_z*s_y - k_cross_S_y*s_z
    s_cross_normal_y = k_cross_S_x*s_z - k_cross_S_z*s_x
    s_cross_normal_z = k_cross_S_y*s_x - k_cross_S_x*s_y
    # (10) leg length, and distance of its tip from the fixed axis
    rho = (
        np.sqrt(s_cross_normal_x*s_cross_normal_x + s_cross_normal_y*s_cross_normal_y
        + s_cross_normal_z*s_cross_normal_z)
    )
    inv_rho = 1/rho
    # (10) third axis of the leg frame
    z_x = inv_rho*s_cross_normal_x
    z_y = inv_rho*s_cross_normal_y
    z_z = inv_rho*s_cross_normal_z
    # (10) rotating axis of the universal joint
    y_x = s_z*z_y - s_y*z_z
    y_y = s_x*z_z - s_z*z_x
    y_z = s_y*z_x - s_x*z_y
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = inv_L*zeta
    k3 = inv_L*rho
    # (10) k1 / k3
    kappa = inv_rho*zeta
    # (4) velocity of the platform point
    S_dot_x = omega_y*q_z + v_x - omega_z*q_y
    S_dot_y = omega_z*q_x + v_y - omega_x*q_z
    S_dot_z = omega_x*q_y + v_z - omega_y*q_x
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x*s_x + S_dot_y*s_y + S_dot_z*s_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = inv_rho*(S_dot_x*y_x + S_dot_y*y_y + S_dot_z*y_z)
    theta_dot = -inv_L*(S_dot_x*z_x + S_dot_y*z_y + S_dot_z*z_z)
    # L_dot / L
    L_share = L_dot*inv_L
    lean = kappa*theta_dot
    theta_dot2 = theta_dot*theta_dot
    phi_dot2 = phi_dot*phi_dot
    two_phi_dot = 2*phi_dot
    # (7) acceleration of the platform point, a = alpha = 0
    S_ddot_x = B_0_xx*q_x + B_0_xy*q_y + B_0_xz*q_z
    S_ddot_y = B_0_yx*q_x + B_0_yy*q_y + B_0_yz*q_z
    S_ddot_z = B_0_zx*q_x + B_0_zy*q_y + B_0_zz*q_z
    k33 = k3*k3
    # (8) accelerations of the joint coordinates
    L_ddot = L*(k33*phi_dot2 + theta_dot2) + S_ddot_x*s_x + S_ddot_y*s_y + S_ddot_z*s_z
    # (9) accelerations of the joint coordinates but for the turning of the leg frame about s
    own_theta_ddot = -2*L_share*theta_dot - inv_L*(S_ddot_x*z_x + S_ddot_y*z_y + S_ddot_z*z_z)
    own_phi_ddot = inv_rho*(S_ddot_x*y_x + S_ddot_y*y_y + S_ddot_z*y_z) - L_share*two_phi_dot
    c1 = k1*k3
    # (9) accelerations of the joint coordinates
    theta_ddot = c1*phi_dot2 + own_theta_ddot
    phi_ddot = own_phi_ddot - lean*two_phi_dot
    k13 = c1
    L_h2 = L*h2_x
    a1 = L_h2 + dJ_zx
    c2 = L*h2_z
    c3 = J2_xz - c2
    a2 = c3
    a3 = J_xy - L*h_y
    # (19) inertia of the joint coordinates
    M_phi = J_xx + a1*k33 + a2*k13
    M_theta = J_yy + L_h2
    M_mixed = J_yz*k3 + a3*k1
    k3_h = h_y*k3
    # (19) slopes of M_phi / 2 along theta and L, of M_mixed along theta
    M_phi_L = h_x*k33 - h_z*k13
    M_mixed_theta = J_yz*k1 - a3*k3
    bend = L_dot*theta_dot
    # gravity along k x y and along y
    gamma_n = g_x_k_x*y_x + g_x_k_y*y_y + g_x_k_z*y_z
    gamma_y = g_x*y_x + g_y*y_y + g_z*y_z
    # first moment along k and against k x y
    w_k = k1*w_x + k3*w_z
    w_n = k3*w_x - k1*w_z
    # (20) generalised forces about y and about k
    tau_y = (
        C_us*theta_dot + L_ddot*h_z + M_mixed*phi_ddot + M_theta*own_theta_ddot + bend*h2_x + g_k*w_n
        + gamma_n*w_k + phi_dot2*(k13*(J_yy - dJ_zx) - c3*(0.5 - k33)) - C_s*(omega_x*y_x + omega_y*y_y
        + omega_z*y_z)
    )
    tau_k = (
        C_us*phi_dot + M_mixed*theta_ddot + M_mixed_theta*theta_dot2 + M_phi*own_phi_ddot
        + two_phi_dot*(L_dot*M_phi_L - theta_dot*(0.5*J2_xz + J_xx*kappa - 0.5*c2)) - C_s*(k_x*omega_x
        + k_y*omega_y + k_z*omega_z) - L_ddot*k3_h - bend*h2_y*k1 - gamma_n*w_y - gamma_y*w_n
    )
    # (21) K = Q_y y + Q_z z
    Q_y = inv_rho*tau_k
    Q_z = -inv_L*tau_y
    # (21) force at the spherical joint, base frame
    K_x = Q_y*y_x + Q_z*z_x
    K_y = Q_y*y_y + Q_z*z_y
    K_z = Q_y*y_z + Q_z*z_z
    # (24) known part of the actuator force, to match
    D = C_p*L_dot + h_z*theta_ddot - M_phi_L*phi_dot2 - h_x*theta_dot2 - k3_h*phi_ddot
    c4 = F - D
    # force on the platform at the tip
    push_x = c4*s_x - K_x
    push_y = c4*s_y - K_y
    push_z = c4*s_z - K_z
    # inertia at the tip, leg frame
    m_leg_sy = -inv_rho*k3_h
    m_leg_sz = -h_z*inv_L
    m_leg_yy = M_phi*inv_rho*inv_rho
    m_leg_yz = -M_mixed*inv_L*inv_rho
    m_leg_zz = M_theta*inv_L*inv_L
    m_T_xs = m_leg_sy*y_x + m_leg_sz*z_x
    m_T_xy = m_leg_sy*s_x + m_leg_yy*y_x + m_leg_yz*z_x
    m_T_xz = m_leg_sz*s_x + m_leg_yz*y_x + m_leg_zz*z_x
    m_T_ys = m_leg_sy*y_y + m_leg_sz*z_y
    m_T_yy = m_leg_sy*s_y + m_leg_yy*y_y + m_leg_yz*z_y
    m_T_yz = m_leg_sz*s_y + m_leg_yz*y_y + m_leg_zz*z_y
    m_T_zs = m_leg_sy*y_z + m_leg_sz*z_z
    m_T_zy = m_leg_sy*s_z + m_leg_yy*y_z + m_leg_yz*z_z
    m_T_zz = m_leg_sz*s_z + m_leg_yz*y_z + m_leg_zz*z_z
    # inertia at the tip, base frame
    m_xx = m_T_xs*s_x + m_T_xy*y_x + m_T_xz*z_x
    m_xy = m_T_xs*s_y + m_T_xy*y_y + m_T_xz*z_y
    m_xz = m_T_xs*s_z + m_T_xy*y_z + m_T_xz*z_z
    m_yy = m_T_ys*s_y + m_T_yy*y_y + m_T_yz*z_y
    m_yz = m_T_ys*s_z + m_T_yy*y_z + m_T_yz*z_z
    m_zz = m_T_zs*s_z + m_T_zy*y_z + m_T_zz*z_z
    c5 = m_xy*q_z
    c6 = m_xz*q_y
    c7 = -m_yz*q_x
    # m [q]x
    m_q_xx = c5 - c6
    m_q_xy = m_xz*q_x - m_xx*q_z
    m_q_xz = m_xx*q_y - m_xy*q_x
    m_q_yx = m_yy*q_z - m_yz*q_y
    m_q_yy = -c5 - c7
    m_q_yz = m_xy*q_y - m_yy*q_x
    m_q_zx = m_yz*q_z - m_zz*q_y
    m_q_zy = m_zz*q_x - m_xz*q_z
    m_q_zz = c6 + c7
    return {
        "M_vv_xx": m_xx,
        "M_vv_xy": m_xy,
        "M_vv_xz": m_xz,
        "M_vv_yy": m_yy,
        "M_vv_yz": m_yz,
        "M_vv_zz": m_zz,
        "M_vw_xx": -m_q_xx,
        "M_vw_xy": -m_q_xy,
        "M_vw_xz": -m_q_xz,
        "M_vw_yx": -m_q_yx,
        "M_vw_yy": -m_q_yy,
        "M_vw_yz": -m_q_yz,
        "M_vw_zx": -m_q_zx,
        "M_vw_zy": -m_q_zy,
        "M_vw_zz": -m_q_zz,
        "M_ww_xx": m_q_yx*q_z - m_q_zx*q_y,
        "M_ww_xy": m_q_yy*q_z - m_q_zy*q_y,
        "M_ww_xz": m_q_yz*q_z - m_q_zz*q_y,
        "M_ww_yy": m_q_zy*q_x - m_q_xy*q_z,
        "M_ww_yz": m_q_zz*q_x - m_q_xz*q_z,
        "M_ww_zz": m_q_xz*q_y - m_q_yz*q_x,
        "right_force_x": push_x,
        "right_force_y": push_y,
        "right_force_z": push_z,
        "right_moment_x": C_s*(k_x*phi_dot + theta_dot*y_x) + push_z*q_y - push_y*q_z,
        "right_moment_y": C_s*(k_y*phi_dot + theta_dot*y_y) + push_x*q_z - push_z*q_x,
        "right_moment_z": C_s*(k_z*phi_dot + theta_dot*y_z) + push_y*q_x - push_x*q_y,
        "S_1_x": S_1_x,
        "S_1_y": S_1_y,
        "S_1_z": S_1_z,
        "L": L,
        "k3": k3,
    }


def derivatives_of_platform(platform: Any, motion: Any) -> dict[str, Any]:
    """The platform's part of the derivatives of the wrench.

    Operations: 341 (168 mul, 173 add, 0 div, 0 sqrt).
    """
    R_xx = motion.R[..., 0, 0]
    R_xy = motion.R[..., 0, 1]
    R_xz = motion.R[..., 0, 2]
    R_yx = motion.R[..., 1, 0]
    R_yy = motion.R[..., 1, 1]
    R_yz = motion.R[..., 1, 2]
    R_zx = motion.R[..., 2, 0]
    R_zy = motion.R[..., 2, 1]
    R_zz = motion.R[..., 2, 2]
    t_x = motion.t[..., 0]
    t_y = motion.t[..., 1]
    t_z = motion.t[..., 2]
    omega_x = motion.omega[..., 0]
    omega_y = motion.omega[..., 1]
    omega_z = motion.omega[..., 2]
    alpha_x = motion.alpha[..., 0]
    alpha_y = motion.alpha[..., 1]
    alpha_z = motion.alpha[..., 2]
    a_x = motion.a[..., 0]
    a_y = motion.a[..., 1]
    a_z = motion.a[..., 2]
    F_ext_x = motion.F_ext[..., 0]
    F_ext_y = motion.F_ext[..., 1]
    F_ext_z = motion.F_ext[..., 2]
    M_ext_x = motion.M_ext[..., 0]
    M_ext_y = motion.M_ext[..., 1]
    M_ext_z = motion.M_ext[..., 2]
    M_P = platform["M_P"]
    h_P_x = platform["h_P_x"]
    h_P_y = platform["h_P_y"]
    h_P_z = platform["h_P_z"]
    J_P_xx = platform["J_P_xx"]
    J_P_xy = platform["J_P_xy"]
    J_P_xz = platform["J_P_xz"]
    J_P_yy = platform["J_P_yy"]
    J_P_yz = platform["J_P_yz"]
    J_P_zz = platform["J_P_zz"]
    C_P = platform["C_P"]
    b_1_x = platform["b_1_x"]
    b_1_y = platform["b_1_y"]
    b_1_z = platform["b_1_z"]
    g_x = platform["g_x"]
    g_y = platform["g_y"]
    g_z = platform["g_z"]
    # (30) first moment of the platform, base frame
    h_base_x = R_xx*h_P_x + R_xy*h_P_y + R_xz*h_P_z
    h_base_y = R_yx*h_P_x + R_yy*h_P_y + R_yz*h_P_z
    h_base_z = R_zx*h_P_x + R_zy*h_P_y + R_zz*h_P_z
    c1 = J_P_xx*R_xx + J_P_xy*R_xy + J_P_xz*R_xz
    c2 = J_P_xy*R_xx + J_P_yy*R_xy + J_P_yz*R_xz
    c3 = J_P_xz*R_xx + J_P_yz*R_xy + J_P_zz*R_xz
    c4 = J_P_xx*R_yx + J_P_xy*R_yy + J_P_xz*R_yz
    c5 = J_P_xy*R_yx + J_P_yy*R_yy + J_P_yz*R_yz
    c6 = J_P_xz*R_yx + J_P_yz*R_yy + J_P_zz*R_yz
    # (32) inertia of the platform, base frame
    J_base_xx = R_xx*c1 + R_xy*c2 + R_xz*c3
    J_base_xy = R_yx*c1 + R_yy*c2 + R_yz*c3
    J_base_xz = R_zx*c1 + R_zy*c2 + R_zz*c3
    J_base_yy = R_yx*c4 + R_yy*c5 + R_yz*c6
    J_base_yz = R_zx*c4 + R_zy*c5 + R_zz*c6
    J_base_zz = (
        R_zx*(J_P_xx*R_zx + J_P_xy*R_zy + J_P_xz*R_zz) + R_zy*(J_P_xy*R_zx + J_P_yy*R_zy + J_P_yz*R_zz)
        + R_zz*(J_P_xz*R_zx + J_P_yz*R_zy + J_P_zz*R_zz)
    )
    c7 = h_base_y*omega_z
    c8 = h_base_z*omega_y
    c9 = h_base_x*omega_z
    c10 = h_base_z*omega_x
    c11 = h_base_x*omega_y
    c12 = h_base_y*omega_x
    # (31) omega x h
    w_h_x = c8 - c7
    w_h_y = c9 - c10
    w_h_z = c12 - c11
    c13 = J_base_xy*omega_y
    c14 = J_base_xz*omega_z
    c15 = J_base_xy*omega_x
    c16 = J_base_yz*omega_z
    c17 = J_base_xz*omega_x
    c18 = J_base_yz*omega_y
    # (34) I omega
    J_w_x = J_base_xx*omega_x + c13 + c14
    J_w_y = J_base_yy*omega_y + c15 + c16
    J_w_z = J_base_zz*omega_z + c17 + c18
    # products of omega
    omega_xx = omega_x*omega_x
    omega_xy = omega_x*omega_y
    omega_xz = omega_x*omega_z
    omega_yy = omega_y*omega_y
    omega_yz = omega_y*omega_z
    omega_zz = omega_z*omega_z
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
    c19 = J_base_xy*alpha_y
    c20 = J_base_xz*alpha_z
    J_alpha_x = J_base_xx*alpha_x + c19 + c20
    c21 = J_base_xy*alpha_x
    c22 = J_base_yz*alpha_z
    J_alpha_y = J_base_yy*alpha_y + c21 + c22
    c23 = J_base_xz*alpha_x
    c24 = J_base_yz*alpha_y
    J_alpha_z = J_base_zz*alpha_z + c23 + c24
    # (33) a - g
    rise_x = a_x - g_x
    rise_y = a_y - g_y
    rise_z = a_z - g_z
    F_load_x = F_ext_x*R_xx + F_ext_y*R_xy + F_ext_z*R_xz
    F_load_y = F_ext_x*R_yx + F_ext_y*R_yy + F_ext_z*R_yz
    F_load_z = F_ext_x*R_zx + F_ext_y*R_zy + F_ext_z*R_zz
    M_load_x = M_ext_x*R_xx + M_ext_y*R_xy + M_ext_z*R_xz
    M_load_y = M_ext_x*R_yx + M_ext_y*R_yy + M_ext_z*R_yz
    M_load_z = M_ext_x*R_zx + M_ext_y*R_zy + M_ext_z*R_zz
    c25 = J_base_xy*omega_z
    c26 = J_base_xz*omega_y
    c28 = J_w_z + c17 - J_base_xx*omega_z
    c29 = J_w_y + c15 - J_base_xx*omega_y
    c30 = J_w_z + c18 - J_base_yy*omega_z
    c31 = J_base_yz*omega_x
    c33 = c25 - c31
    c34 = J_w_x + c13 - J_base_yy*omega_x
    c35 = J_w_y + c16 - J_base_zz*omega_y
    c36 = J_w_x + c14 - J_base_zz*omega_x
    # derivative of I omega by dphi at fixed omega
    spin_xx = c25 - c26
    spin_xy = c28
    spin_xz = -c29
    spin_yx = -c30
    spin_yy = -c33
    spin_yz = c34
    spin_zx = c35
    spin_zy = -c36
    spin_zz = c26 - c31
    c37 = J_base_xz*alpha_y
    c38 = h_base_y*rise_y
    c39 = h_base_z*rise_z
    c40 = J_base_xy*alpha_z
    c41 = h_base_x*rise_x
    c42 = J_base_yz*alpha_x
    c43 = h_base_y*omega_y
    c44 = h_base_z*omega_z
    c45 = h_base_x*omega_x
    return {
        "t_1_x": t_x - b_1_x,
        "t_1_y": t_y - b_1_y,
        "t_1_z": t_z - b_1_z,
        "B_xx": B_xx,
        "B_xy": B_xy,
        "B_xz": B_xz,
        "B_yx": B_yx,
        "B_yy": B_yy,
        "B_yz": B_yz,
        "B_zx": B_zx,
        "B_zy": B_zy,
        "B_zz": B_zz,
        "M_vv_xx": M_P,
        "M_vv_xy": 0,
        "M_vv_xz": 0,
        "M_vv_yy": M_P,
        "M_vv_yz": 0,
        "M_vv_zz": M_P,
        "M_vw_xx": 0,
        "M_vw_xy": h_base_z,
        "M_vw_xz": -h_base_y,
        "M_vw_yx": -h_base_z,
        "M_vw_yy": 0,
        "M_vw_yz": h_base_x,
        "M_vw_zx": h_base_y,
        "M_vw_zy": -h_base_x,
        "M_vw_zz": 0,
        "M_ww_xx": J_base_xx,
        "M_ww_xy": J_base_xy,
        "M_ww_xz": J_base_xz,
        "M_ww_yy": J_base_yy,
        "M_ww_yz": J_base_yz,
        "M_ww_zz": J_base_zz,
        "W_ft_xx": 0,
        "W_ft_xy": 0,
        "W_ft_xz": 0,
        "W_ft_yx": 0,
        "W_ft_yy": 0,
        "W_ft_yz": 0,
        "W_ft_zx": 0,
        "W_ft_zy": 0,
        "W_ft_zz": 0,
        "W_fr_xx": B_xz*h_base_y - B_xy*h_base_z,
        "W_fr_xy": B_xx*h_base_z - B_xz*h_base_x - F_load_z,
        "W_fr_xz": B_xy*h_base_x + F_load_y - B_xx*h_base_y,
        "W_fr_yx": B_yz*h_base_y + F_load_z - B_yy*h_base_z,
        "W_fr_yy": B_yx*h_base_z - B_yz*h_base_x,
        "W_fr_yz": B_yy*h_base_x - B_yx*h_base_y - F_load_x,
        "W_fr_zx": B_zz*h_base_y - B_zy*h_base_z - F_load_y,
        "W_fr_zy": B_zx*h_base_z + F_load_x - B_zz*h_base_x,
        "W_fr_zz": B_zy*h_base_x - B_zx*h_base_y,
        "W_mt_xx": 0,
        "W_mt_xy": 0,
        "W_mt_xz": 0,
        "W_mt_yx": 0,
        "W_mt_yy": 0,
        "W_mt_yz": 0,
        "W_mt_zx": 0,
        "W_mt_zy": 0,
        "W_mt_zz": 0,
        "W_mr_xx": c40 + omega_y*spin_zx - c37 - c38 - c39 - omega_z*spin_yx,
        "W_mr_xy": (
            J_alpha_z + c23 + h_base_x*rise_y + omega_y*spin_zy - J_base_xx*alpha_z - M_load_z
            - omega_z*spin_yy
        ),
        "W_mr_xz": (
            J_base_xx*alpha_y + M_load_y + h_base_x*rise_z + omega_y*spin_zz - J_alpha_y - c21
            - omega_z*spin_yz
        ),
        "W_mr_yx": (
            J_base_yy*alpha_z + M_load_z + h_base_y*rise_x + omega_z*spin_xx - J_alpha_z - c24
            - omega_x*spin_zx
        ),
        "W_mr_yy": c42 + omega_z*spin_xy - c39 - c40 - c41 - omega_x*spin_zy,
        "W_mr_yz": (
            J_alpha_x + c19 + h_base_y*rise_z + omega_z*spin_xz - J_base_yy*alpha_x - M_load_x
            - omega_x*spin_zz
        ),
        "W_mr_zx": (
            J_alpha_y + c22 + h_base_z*rise_x + omega_x*spin_yx - J_base_zz*alpha_y - M_load_y
            - omega_y*spin_xx
        ),
        "W_mr_zy": (
            J_base_zz*alpha_x + M_load_x + h_base_z*rise_y + omega_x*spin_yy - J_alpha_x - c20
            - omega_y*spin_xy
        ),
        "W_mr_zz": c37 + omega_x*spin_yz - c38 - c41 - c42 - omega_y*spin_xz,
        "W_fv_xx": 0,
        "W_fv_xy": 0,
        "W_fv_xz": 0,
        "W_fv_yx": 0,
        "W_fv_yy": 0,
        "W_fv_yz": 0,
        "W_fv_zx": 0,
        "W_fv_zy": 0,
        "W_fv_zz": 0,
        "W_fw_xx": c43 + c44,
        "W_fw_xy": w_h_z - c11,
        "W_fw_xz": -c9 - w_h_y,
        "W_fw_yx": -c12 - w_h_z,
        "W_fw_yy": c44 + c45,
        "W_fw_yz": w_h_x - c7,
        "W_fw_zx": w_h_y - c10,
        "W_fw_zy": -c8 - w_h_x,
        "W_fw_zz": c43 + c45,
        "W_mv_xx": 0,
        "W_mv_xy": 0,
        "W_mv_xz": 0,
        "W_mv_yx": 0,
        "W_mv_yy": 0,
        "W_mv_yz": 0,
        "W_mv_zx": 0,
        "W_mv_zy": 0,
        "W_mv_zz": 0,
        "W_mw_xx": C_P + c26 - c25,
        "W_mw_xy": c30,
        "W_mw_xz": -c35,
        "W_mw_yx": -c28,
        "W_mw_yy": C_P + c33,
        "W_mw_yz": c36,
        "W_mw_zx": c29,
        "W_mw_zy": -c34,
        "W_mw_zz": C_P + c31 - c26,
    }


def derivatives_of_leg(leg: Any, platform: Any, pose: Any, motion: Any, F: Any) -> dict[str, Any]:
    """One leg's part of the derivatives of the wrench.

    Operations: 1725 (1022 mul, 699 add, 2 div, 2 sqrt).
    """
    p_x = leg["p_x"]
    p_y = leg["p_y"]
    p_z = leg["p_z"]
    k_x = leg["k_x"]
    k_y = leg["k_y"]
    k_z = leg["k_z"]
    C_p = leg["C_p"]
    C_s = leg["C_s"]
    h_x = leg["h_x"]
    h_y = leg["h_y"]
    h_z = leg["h_z"]
    h2_x = leg["h2_x"]
    h2_z = leg["h2_z"]
    w_x = leg["w_x"]
    w_y = leg["w_y"]
    w_z = leg["w_z"]
    J_xx = leg["J_xx"]
    J_xy = leg["J_xy"]
    J_xz = leg["J_xz"]
    J_yy = leg["J_yy"]
    J_yz = leg["J_yz"]
    J_zz = leg["J_zz"]
    J2_xz = leg["J2_xz"]
    dJ_zx = leg["dJ_zx"]
    g_k = leg["g_k"]
    g_x_k_x = leg["g_x_k_x"]
    g_x_k_y = leg["g_x_k_y"]
    g_x_k_z = leg["g_x_k_z"]
    C_us = leg["C_us"]
    R_xx = motion.R[..., 0, 0, None]
    R_xy = motion.R[..., 0, 1, None]
    R_xz = motion.R[..., 0, 2, None]
    R_yx = motion.R[..., 1, 0, None]
    R_yy = motion.R[..., 1, 1, None]
    R_yz = motion.R[..., 1, 2, None]
    R_zx = motion.R[..., 2, 0, None]
    R_zy = motion.R[..., 2, 1, None]
    R_zz = motion.R[..., 2, 2, None]
    omega_x = motion.omega[..., 0, None]
    omega_y = motion.omega[..., 1, None]
    omega_z = motion.omega[..., 2, None]
    v_x = motion.v[..., 0, None]
    v_y = motion.v[..., 1, None]
    v_z = motion.v[..., 2, None]
    a_x = motion.a[..., 0, None]
    a_y = motion.a[..., 1, None]
    a_z = motion.a[..., 2, None]
    B_xx = pose["B_xx"][..., None]
    B_xy = pose["B_xy"][..., None]
    B_xz = pose["B_xz"][..., None]
    B_yx = pose["B_yx"][..., None]
    B_yy = pose["B_yy"][..., None]
    B_yz = pose["B_yz"][..., None]
    B_zx = pose["B_zx"][..., None]
    B_zy = pose["B_zy"][..., None]
    B_zz = pose["B_zz"][..., None]
    F = F
    g_x = platform["g_x"]
    g_y = platform["g_y"]
    g_z = platform["g_z"]
    t_1_x = pose["t_1_x"][..., None]
    t_1_y = pose["t_1_y"][..., None]
    t_1_z = pose["t_1_z"][..., None]
    r_x = leg["r_x"]
    r_y = leg["r_y"]
    r_z = leg["r_z"]
    # (1) platform point from the reference point
    q_x = R_xx*p_x + R_xy*p_y + R_xz*p_z
    q_y = R_yx*p_x + R_yy*p_y + R_yz*p_z
    q_z = R_zx*p_x + R_zy*p_y + R_zz*p_z
    # (1) platform point from base point 1, base frame
    S_1_x = q_x + t_1_x
    S_1_y = q_y + t_1_y
    S_1_z = q_z + t_1_z
    # (1) leg vector
    S_x = S_1_x - r_x
    S_y = S_1_y - r_y
    S_z = S_1_z - r_z
    # (10) leg vector along the fixed axis, and normal to both
    zeta = S_x*k_x + S_y*k_y + S_z*k_z
    k_cross_S_x = S_z*k_y - S_y*k_z
    k_cross_S_y = S_x*k_z - S_z*k_x
    k_cross_S_z = S_y*k_x - S_x*k_y
    # (2) leg length, and distance of its tip from the fixed axis
    L = np.sqrt(S_x*S_x + S_y*S_y + S_z*S_z)
    inv_L = 1/L
    # (3) unit vector along the leg
    s_x = S_x*inv_L
    s_y = S_y*inv_L
    s_z = S_z*inv_L
    # (10) along the third axis of the leg
    s_cross_normal_x = k_cross_S_z*s_y - k_cross_S_y*s_z
    s_cross_normal_y = k_cross_S_x*s_z - k_cross_S_z*s_x
    s_cross_normal_z = k_cross_S_y*s_x - k_cross_S_x*s_y
    # (10) leg length, and distance of its tip from the fixed axis
    rho = (
        np.sqrt(s_cross_normal_x*s_cross_normal_x + s_cross_normal_y*s_cross_normal_y
        + s_cross_normal_z*s_cross_normal_z)
    )
    inv_rho = 1/rho
    # (10) third axis of the leg frame
    z_x = inv_rho*s_cross_normal_x
    z_y = inv_rho*s_cross_normal_y
    z_z = inv_rho*s_cross_normal_z
    # (10) rotating axis of the universal joint
    y_x = s_z*z_y - s_y*z_z
    y_y = s_x*z_z - s_z*z_x
    y_z = s_y*z_x - s_x*z_y
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = inv_L*zeta
    k3 = inv_L*rho
    # (10) k1 / k3
    kappa = inv_rho*zeta
    # (4) velocity of the platform point
    S_dot_x = omega_y*q_z + v_x - omega_z*q_y
    S_dot_y = omega_z*q_x + v_y - omega_x*q_z
    S_dot_z = omega_x*q_y + v_z - omega_y*q_x
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x*s_x + S_dot_y*s_y + S_dot_z*s_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = inv_rho*(S_dot_x*y_x + S_dot_y*y_y + S_dot_z*y_z)
    theta_dot = -inv_L*(S_dot_x*z_x + S_dot_y*z_y + S_dot_z*z_z)
    c1 = L_dot*inv_L
    # L_dot / L
    L_share = c1
    c2 = kappa*theta_dot
    lean = c2
    c3 = theta_dot*theta_dot
    theta_dot2 = c3
    c4 = phi_dot*phi_dot
    phi_dot2 = c4
    c5 = 2*phi_dot
    two_phi_dot = c5
    # (7) acceleration of the platform point
    S_ddot_x = B_xx*q_x + B_xy*q_y + B_xz*q_z + a_x
    S_ddot_y = B_yx*q_x + B_yy*q_y + B_yz*q_z + a_y
    S_ddot_z = B_zx*q_x + B_zy*q_y + B_zz*q_z + a_z
    c6 = k3*k3
    k33 = c6
    # (8) accelerations of the joint coordinates
    L_ddot = L*(k33*phi_dot2 + theta_dot2) + S_ddot_x*s_x + S_ddot_y*s_y + S_ddot_z*s_z
    c7 = 2*theta_dot
    # (9) accelerations of the joint coordinates but for the turning of the leg frame about s
    own_theta_ddot = -L_share*c7 - inv_L*(S_ddot_x*z_x + S_ddot_y*z_y + S_ddot_z*z_z)
    own_phi_ddot = inv_rho*(S_ddot_x*y_x + S_ddot_y*y_y + S_ddot_z*y_z) - L_share*two_phi_dot
    c8 = k1*k3
    # (9) accelerations of the joint coordinates
    theta_ddot = c8*phi_dot2 + own_theta_ddot
    phi_ddot = own_phi_ddot - lean*two_phi_dot
    k13 = c8
    L_h2 = L*h2_x
    a1 = L_h2 + dJ_zx
    a2 = J2_xz - L*h2_z
    c9 = J_xy - L*h_y
    a3 = c9
    c10 = J_yz*k3
    # (19) inertia of the joint coordinates
    M_phi = J_xx + a1*k33 + a2*k13
    M_theta = J_yy + L_h2
    M_mixed = a3*k1 + c10
    c11 = h_y*k3
    k3_h = c11
    c12 = inv_rho*inv_rho
    c13 = inv_L*inv_rho
    c14 = inv_L*inv_L
    # inertia at the tip, leg frame
    m_leg_sy = -inv_rho*k3_h
    m_leg_sz = -h_z*inv_L
    m_leg_yy = M_phi*c12
    m_leg_yz = -M_mixed*c13
    m_leg_zz = M_theta*c14
    m_T_xs = m_leg_sy*y_x + m_leg_sz*z_x
    m_T_xy = m_leg_sy*s_x + m_leg_yy*y_x + m_leg_yz*z_x
    m_T_xz = m_leg_sz*s_x + m_leg_yz*y_x + m_leg_zz*z_x
    m_T_ys = m_leg_sy*y_y + m_leg_sz*z_y
    m_T_yy = m_leg_sy*s_y + m_leg_yy*y_y + m_leg_yz*z_y
    m_T_yz = m_leg_sz*s_y + m_leg_yz*y_y + m_leg_zz*z_y
    m_T_zs = m_leg_sy*y_z + m_leg_sz*z_z
    m_T_zy = m_leg_sy*s_z + m_leg_yy*y_z + m_leg_yz*z_z
    m_T_zz = m_leg_sz*s_z + m_leg_yz*y_z + m_leg_zz*z_z
    # inertia at the tip, base frame
    m_xx = m_T_xs*s_x + m_T_xy*y_x + m_T_xz*z_x
    m_xy = m_T_xs*s_y + m_T_xy*y_y + m_T_xz*z_y
    m_xz = m_T_xs*s_z + m_T_xy*y_z + m_T_xz*z_z
    m_yy = m_T_ys*s_y + m_T_yy*y_y + m_T_yz*z_y
    m_yz = m_T_ys*s_z + m_T_yy*y_z + m_T_yz*z_z
    m_zz = m_T_zs*s_z + m_T_zy*y_z + m_T_zz*z_z
    # gravity along k x y and along y
    gamma_n = g_x_k_x*y_x + g_x_k_y*y_y + g_x_k_z*y_z
    gamma_y = g_x*y_x + g_y*y_y + g_z*y_z
    # k x y
    normal_x = k_y*y_z - k_z*y_y
    normal_y = k_z*y_x - k_x*y_z
    normal_z = k_x*y_y - k_y*y_x
    # omega along k x y, y and k
    w_n_omega = normal_x*omega_x + normal_y*omega_y + normal_z*omega_z
    w_y_omega = omega_x*y_x + omega_y*y_y + omega_z*y_z
    w_k_omega = k_x*omega_x + k_y*omega_y + k_z*omega_z
    c15 = c6*h_x
    c16 = c15 - h_z*k1*k3
    tau_L = C_p*L_dot + h_z*theta_ddot - c11*phi_ddot - c16*c4 - c3*h_x
    c18 = c7*h_x
    c19 = 2*L
    c20 = c19*h_x
    c21 = k1*w_x + k3*w_z
    c22 = k1*w_z - k3*w_x
    c24 = c10 + c9*k1
    c25 = 2*J_xz - c19*h_z
    c26 = c25*k1
    c27 = J_zz + c20 - J_xx
    c28 = c27*k3
    c29 = c26 + 2*c28
    c30 = 0.5*k1
    c31 = c29*c30 - 0.5*c25*c6
    tau_theta = (
        C_us*theta_dot + L_ddot*h_z + L_dot*c18 + c21*gamma_n + c24*phi_ddot + theta_ddot*(J_yy + c20)
        - C_s*w_y_omega - c22*g_k - c31*c4
    )
    c33 = h_y*theta_dot
    c34 = c33*k1
    c35 = L_dot*c16
    c36 = c31*theta_dot
    c37 = L_dot*h_y
    c38 = c37*k1
    c39 = theta_dot*(J_yz*k1 - c9*k3)
    tau_phi = (
        C_us*phi_dot + L_dot*(c16*phi_dot - c34) + c22*gamma_y + c24*theta_ddot + phi_ddot*(J_xx + c25*c8
        + c27*c6) + phi_dot*(c35 + c36) + theta_dot*(c31*phi_dot + c39 - c38) - C_s*w_k_omega - L_ddot*c11
        - gamma_n*w_y
    )
    c40 = k3*phi_dot
    G_dot_12 = c40
    c41 = inv_L*theta_dot
    G_dot_21 = -c41
    c42 = k1*phi_dot
    G_dot_22 = c42*inv_L
    c43 = L_dot*c14
    G_dot_23 = c43
    c44 = c40*inv_rho
    G_dot_31 = -c44
    c45 = c1*inv_rho
    c46 = -c2*inv_rho - c45
    G_dot_32 = c46
    c47 = c42*inv_rho
    G_dot_33 = c47
    c48 = c4*c6
    G_ddot_11 = -c3 - c48
    c49 = k3*phi_ddot
    c50 = c5*k1
    G_ddot_12 = c49 + c50*theta_dot
    c51 = c4*c8
    G_ddot_13 = c51 - theta_ddot
    G_ddot_21 = 2*L_dot*c14*theta_dot - c51*inv_L - inv_L*theta_ddot
    G_ddot_22 = inv_L*k1*phi_ddot - c41*c5*k3 - c43*c50
    c52 = c4*k1*k1
    G_ddot_23 = L_ddot*c14 + c3*inv_L + c52*inv_L - 2*L_dot*L_dot*inv_L*inv_L*inv_L
    G_ddot_31 = c1*c44 + c47*theta_dot + theta_dot*(inv_rho*k3*kappa*phi_dot - c47) - c40*c46 - c49*inv_rho
    c53 = inv_rho*kappa
    c54 = -c1 - c2
    c55 = inv_rho*theta_dot
    G_ddot_32 = (
        L_dot*(c43*inv_rho - c13*c54) + theta_dot*(-c53*c54 - c55*(-kappa*kappa - 1)) - L_ddot*c13
        - c48*inv_rho - c52*inv_rho - c53*theta_ddot
    )
    G_ddot_33 = c42*c46 + c44*theta_dot + inv_rho*k1*phi_ddot + theta_dot*(-c44 - c47*kappa) - c42*c45
    tau_rate_12 = -c18
    tau_rate_13 = -c16*c5
    tau_rate_21 = c18
    c56 = 2*h_x
    tau_rate_22 = C_us + L_dot*c56
    tau_rate_23 = -c31*c5
    tau_rate_31 = 2*c16*phi_dot - 2*c34
    tau_rate_32 = c31*c5 + 2*c39 - 2*c38
    tau_rate_33 = C_us + 2*c35 + 2*c36
    c57 = h_y*phi_ddot
    c58 = c56*k3 - h_z*k1
    tau_place_12 = k1*(-c4*c58 - c57) - c48*h_z
    c59 = 4*h_x
    c60 = c30*(c59*k3 - 2*h_z*k1) + c6*h_z
    tau_place_21 = c56*theta_ddot - c4*c60 - c57*k1
    c61 = c30*(2*J_zz + L*c59 - 2*J_xx) - c25*k3
    c62 = c26 + c28
    tau_place_22 = (
        k1*(J_yz*phi_ddot + g_k*w_x + gamma_n*w_z - c4*c61) - k3*(c9*phi_ddot + gamma_n*w_x - c4*c62
        - g_k*w_z)
    )
    tau_place_23 = -C_s*w_n_omega - c21*gamma_y
    c63 = c60*phi_dot
    tau_place_31 = (
        c63*theta_dot + phi_ddot*(2*c15 - 2*c8*h_z) + theta_dot*(c11*theta_dot + c63) - h_y*k1*theta_ddot
    )
    c64 = L_dot*c58
    tau_place_32 = (
        k1*(J_yz*theta_ddot + c29*phi_ddot + c64*phi_dot + phi_dot*(c61*theta_dot + c64)
        + theta_dot*(c61*phi_dot - c9*theta_dot) - L_ddot*h_y - gamma_y*w_x) - k3*(L_dot*(-c33 - c40*h_z)
        + c25*c49 + c9*theta_ddot + gamma_y*w_z + phi_dot*(c62*theta_dot - L_dot*h_z*k3)
        + theta_dot*(J_yz*theta_dot + c62*phi_dot - c37))
    )
    tau_place_33 = c22*gamma_n + gamma_y*w_y
    c65 = inv_rho*tau_phi
    c66 = inv_L*tau_theta
    c67 = tau_L - F
    # force at the tip, less the actuator's
    R_tip_x = c65*y_x + c67*s_x - c66*z_x
    R_tip_y = c65*y_y + c67*s_y - c66*z_y
    R_tip_z = c65*y_z + c67*s_z - c66*z_z
    c68 = C_s*inv_rho
    c69 = c68*k1
    A_3_leg_21 = -c69
    c70 = c68*k3
    A_3_leg_23 = -c70
    c71 = C_s*inv_L
    A_3_leg_32 = c71
    A_3_T_xs = A_3_leg_21*y_x
    A_3_T_xy = A_3_leg_32*z_x
    A_3_T_xz = A_3_leg_23*y_x
    A_3_T_ys = A_3_leg_21*y_y
    A_3_T_yy = A_3_leg_32*z_y
    A_3_T_yz = A_3_leg_23*y_y
    A_3_T_zs = A_3_leg_21*y_z
    A_3_T_zy = A_3_leg_32*z_z
    A_3_T_zz = A_3_leg_23*y_z
    # force at the tip by omega
    A_3_xx = A_3_T_xs*s_x + A_3_T_xy*y_x + A_3_T_xz*z_x
    A_3_xy = A_3_T_xs*s_y + A_3_T_xy*y_y + A_3_T_xz*z_y
    A_3_xz = A_3_T_xs*s_z + A_3_T_xy*y_z + A_3_T_xz*z_z
    A_3_yx = A_3_T_ys*s_x + A_3_T_yy*y_x + A_3_T_yz*z_x
    A_3_yy = A_3_T_ys*s_y + A_3_T_yy*y_y + A_3_T_yz*z_y
    A_3_yz = A_3_T_ys*s_z + A_3_T_yy*y_z + A_3_T_yz*z_z
    A_3_zx = A_3_T_zs*s_x + A_3_T_zy*y_x + A_3_T_zz*z_x
    A_3_zy = A_3_T_zs*s_y + A_3_T_zy*y_y + A_3_T_zz*z_y
    A_3_zz = A_3_T_zs*s_z + A_3_T_zy*y_z + A_3_T_zz*z_z
    c72 = C_s*k1
    f_S_leg_11 = G_dot_31*c72
    f_S_leg_12 = C_s*(G_dot_32*k1 - c55*k3)
    f_S_leg_13 = G_dot_33*c72
    f_S_leg_21 = C_s*G_dot_21
    f_S_leg_22 = C_s*G_dot_22
    f_S_leg_23 = C_s*G_dot_23
    c73 = C_s*k3
    f_S_leg_31 = G_dot_31*c73
    f_S_leg_32 = C_s*(G_dot_32*k3 + c55*k1)
    f_S_leg_33 = G_dot_33*c73
    f_S_T_xs = f_S_leg_11*s_x + f_S_leg_21*y_x + f_S_leg_31*z_x
    f_S_T_xy = f_S_leg_12*s_x + f_S_leg_22*y_x + f_S_leg_32*z_x
    f_S_T_xz = f_S_leg_13*s_x + f_S_leg_23*y_x + f_S_leg_33*z_x
    f_S_T_ys = f_S_leg_11*s_y + f_S_leg_21*y_y + f_S_leg_31*z_y
    f_S_T_yy = f_S_leg_12*s_y + f_S_leg_22*y_y + f_S_leg_32*z_y
    f_S_T_yz = f_S_leg_13*s_y + f_S_leg_23*y_y + f_S_leg_33*z_y
    f_S_T_zs = f_S_leg_11*s_z + f_S_leg_21*y_z + f_S_leg_31*z_z
    f_S_T_zy = f_S_leg_12*s_z + f_S_leg_22*y_z + f_S_leg_32*z_z
    f_S_T_zz = f_S_leg_13*s_z + f_S_leg_23*y_z + f_S_leg_33*z_z
    # friction moment by S
    f_S_xx = f_S_T_xs*s_x + f_S_T_xy*y_x + f_S_T_xz*z_x
    f_S_xy = f_S_T_xs*s_y + f_S_T_xy*y_y + f_S_T_xz*z_y
    f_S_xz = f_S_T_xs*s_z + f_S_T_xy*y_z + f_S_T_xz*z_z
    f_S_yx = f_S_T_ys*s_x + f_S_T_yy*y_x + f_S_T_yz*z_x
    f_S_yy = f_S_T_ys*s_y + f_S_T_yy*y_y + f_S_T_yz*z_y
    f_S_yz = f_S_T_ys*s_z + f_S_T_yy*y_z + f_S_T_yz*z_z
    f_S_zx = f_S_T_zs*s_x + f_S_T_zy*y_x + f_S_T_zz*z_x
    f_S_zy = f_S_T_zs*s_y + f_S_T_zy*y_y + f_S_T_zz*z_y
    f_S_zz = f_S_T_zs*s_z + f_S_T_zy*y_z + f_S_T_zz*z_z
    f_S_dot_leg_12 = c69
    f_S_dot_leg_23 = -c71
    f_S_dot_leg_32 = c70
    f_S_dot_T_xy = f_S_dot_leg_12*s_x + f_S_dot_leg_32*z_x
    f_S_dot_T_xz = f_S_dot_leg_23*y_x
    f_S_dot_T_yy = f_S_dot_leg_12*s_y + f_S_dot_leg_32*z_y
    f_S_dot_T_yz = f_S_dot_leg_23*y_y
    f_S_dot_T_zy = f_S_dot_leg_12*s_z + f_S_dot_leg_32*z_z
    f_S_dot_T_zz = f_S_dot_leg_23*y_z
    # friction moment by S_dot
    f_S_dot_xx = f_S_dot_T_xy*y_x + f_S_dot_T_xz*z_x
    f_S_dot_xy = f_S_dot_T_xy*y_y + f_S_dot_T_xz*z_y
    f_S_dot_xz = f_S_dot_T_xy*y_z + f_S_dot_T_xz*z_z
    f_S_dot_yx = f_S_dot_T_yy*y_x + f_S_dot_T_yz*z_x
    f_S_dot_yy = f_S_dot_T_yy*y_y + f_S_dot_T_yz*z_y
    f_S_dot_yz = f_S_dot_T_yy*y_z + f_S_dot_T_yz*z_z
    f_S_dot_zx = f_S_dot_T_zy*y_x + f_S_dot_T_zz*z_x
    f_S_dot_zy = f_S_dot_T_zy*y_y + f_S_dot_T_zz*z_y
    f_S_dot_zz = f_S_dot_T_zy*y_z + f_S_dot_T_zz*z_z
    A_0_leg_11 = G_ddot_21*h_z + G_dot_21*tau_rate_12 + G_dot_31*tau_rate_13 - G_ddot_31*k3_h
    A_0_leg_12 = (
        C_p*G_dot_12 + G_ddot_22*h_z + G_dot_22*tau_rate_12 + G_dot_32*tau_rate_13 - G_ddot_32*k3_h
        - c12*k3*tau_phi
    )
    c74 = c14*tau_theta
    A_0_leg_13 = (
        G_ddot_23*h_z + G_dot_23*tau_rate_12 + G_dot_33*tau_rate_13 + c74 - C_p*theta_dot - G_ddot_33*k3_h
        - inv_L*tau_place_12
    )
    c75 = c13*tau_phi
    A_0_leg_21 = (
        inv_rho*(G_ddot_21*M_mixed + G_ddot_31*M_phi + G_dot_21*tau_rate_32 + G_dot_31*tau_rate_33
        + tau_place_31 - G_ddot_11*k3_h) - c75
    )
    c76 = inv_rho*k3
    A_0_leg_22 = (
        c13*k1*tau_theta + c76*tau_L + inv_rho*(G_ddot_22*M_mixed + G_ddot_32*M_phi + G_dot_12*tau_rate_31
        + G_dot_22*tau_rate_32 + G_dot_32*tau_rate_33 + inv_rho*tau_place_33 - G_ddot_12*k3_h) - F*c76
    )
    A_0_leg_23 = (
        c75*kappa + inv_rho*(G_ddot_23*M_mixed + G_ddot_33*M_phi + G_dot_23*tau_rate_32
        + G_dot_33*tau_rate_33 - G_ddot_13*k3_h - inv_L*tau_place_32 - tau_rate_31*theta_dot)
    )
    A_0_leg_31 = (
        c74 - inv_L*(G_ddot_11*h_z + G_ddot_21*M_theta + G_ddot_31*M_mixed + G_dot_21*tau_rate_22
        + G_dot_31*tau_rate_23 + tau_place_21)
    )
    A_0_leg_32 = (
        c12*k1*tau_phi - inv_L*(G_ddot_12*h_z + G_ddot_22*M_theta + G_ddot_32*M_mixed + G_dot_12*tau_rate_21
        + G_dot_22*tau_rate_22 + G_dot_32*tau_rate_23 + inv_rho*tau_place_23)
    )
    A_0_leg_33 = (
        inv_L*tau_L - F*inv_L - inv_L*(G_ddot_13*h_z + G_ddot_23*M_theta + G_ddot_33*M_mixed
        + G_dot_23*tau_rate_22 + G_dot_33*tau_rate_23 - inv_L*tau_place_22 - tau_rate_21*theta_dot)
    )
    A_0_T_xs = A_0_leg_11*s_x + A_0_leg_21*y_x + A_0_leg_31*z_x
    A_0_T_xy = A_0_leg_12*s_x + A_0_leg_22*y_x + A_0_leg_32*z_x
    A_0_T_xz = A_0_leg_13*s_x + A_0_leg_23*y_x + A_0_leg_33*z_x
    A_0_T_ys = A_0_leg_11*s_y + A_0_leg_21*y_y + A_0_leg_31*z_y
    A_0_T_yy = A_0_leg_12*s_y + A_0_leg_22*y_y + A_0_leg_32*z_y
    A_0_T_yz = A_0_leg_13*s_y + A_0_leg_23*y_y + A_0_leg_33*z_y
    A_0_T_zs = A_0_leg_11*s_z + A_0_leg_21*y_z + A_0_leg_31*z_z
    A_0_T_zy = A_0_leg_12*s_z + A_0_leg_22*y_z + A_0_leg_32*z_z
    A_0_T_zz = A_0_leg_13*s_z + A_0_leg_23*y_z + A_0_leg_33*z_z
    # force at the tip by S
    A_0_xx = A_0_T_xs*s_x + A_0_T_xy*y_x + A_0_T_xz*z_x
    A_0_xy = A_0_T_xs*s_y + A_0_T_xy*y_y + A_0_T_xz*z_y
    A_0_xz = A_0_T_xs*s_z + A_0_T_xy*y_z + A_0_T_xz*z_z
    A_0_yx = A_0_T_ys*s_x + A_0_T_yy*y_x + A_0_T_yz*z_x
    A_0_yy = A_0_T_ys*s_y + A_0_T_yy*y_y + A_0_T_yz*z_y
    A_0_yz = A_0_T_ys*s_z + A_0_T_yy*y_z + A_0_T_yz*z_z
    A_0_zx = A_0_T_zs*s_x + A_0_T_zy*y_x + A_0_T_zz*z_x
    A_0_zy = A_0_T_zs*s_y + A_0_T_zy*y_y + A_0_T_zz*z_y
    A_0_zz = A_0_T_zs*s_z + A_0_T_zy*y_z + A_0_T_zz*z_z
    c77 = 2*h_z
    c78 = 2*k3_h
    A_1_leg_11 = C_p + G_dot_21*c77 - G_dot_31*c78
    A_1_leg_12 = G_dot_22*c77 + inv_rho*tau_rate_13 - G_dot_32*c78
    A_1_leg_13 = 2*G_dot_23*h_z - G_dot_33*c78 - inv_L*tau_rate_12
    c79 = 2*M_mixed
    c80 = 2*M_phi
    A_1_leg_21 = inv_rho*(G_dot_21*c79 + G_dot_31*c80 + tau_rate_31)
    A_1_leg_22 = inv_rho*(G_dot_22*c79 + G_dot_32*c80 + inv_rho*tau_rate_33 - G_dot_12*c78)
    A_1_leg_23 = inv_rho*(G_dot_23*c79 + G_dot_33*c80 + c7*k3_h - inv_L*tau_rate_32)
    c81 = 2*M_theta
    A_1_leg_31 = -inv_L*(G_dot_21*c81 + G_dot_31*c79 + tau_rate_21)
    A_1_leg_32 = -inv_L*(G_dot_12*c77 + G_dot_22*c81 + G_dot_32*c79 + inv_rho*tau_rate_23)
    A_1_leg_33 = -inv_L*(G_dot_23*c81 + G_dot_33*c79 - c7*h_z - inv_L*tau_rate_22)
    A_1_T_xs = A_1_leg_11*s_x + A_1_leg_21*y_x + A_1_leg_31*z_x
    A_1_T_xy = A_1_leg_12*s_x + A_1_leg_22*y_x + A_1_leg_32*z_x
    A_1_T_xz = A_1_leg_13*s_x + A_1_leg_23*y_x + A_1_leg_33*z_x
    A_1_T_ys = A_1_leg_11*s_y + A_1_leg_21*y_y + A_1_leg_31*z_y
    A_1_T_yy = A_1_leg_12*s_y + A_1_leg_22*y_y + A_1_leg_32*z_y
    A_1_T_yz = A_1_leg_13*s_y + A_1_leg_23*y_y + A_1_leg_33*z_y
    A_1_T_zs = A_1_leg_11*s_z + A_1_leg_21*y_z + A_1_leg_31*z_z
    A_1_T_zy = A_1_leg_12*s_z + A_1_leg_22*y_z + A_1_leg_32*z_z
    A_1_T_zz = A_1_leg_13*s_z + A_1_leg_23*y_z + A_1_leg_33*z_z
    # force at the tip by S_dot
    A_1_xx = A_1_T_xs*s_x + A_1_T_xy*y_x + A_1_T_xz*z_x
    A_1_xy = A_1_T_xs*s_y + A_1_T_xy*y_y + A_1_T_xz*z_y
    A_1_xz = A_1_T_xs*s_z + A_1_T_xy*y_z + A_1_T_xz*z_z
    A_1_yx = A_1_T_ys*s_x + A_1_T_yy*y_x + A_1_T_yz*z_x
    A_1_yy = A_1_T_ys*s_y + A_1_T_yy*y_y + A_1_T_yz*z_y
    A_1_yz = A_1_T_ys*s_z + A_1_T_yy*y_z + A_1_T_yz*z_z
    A_1_zx = A_1_T_zs*s_x + A_1_T_zy*y_x + A_1_T_zz*z_x
    A_1_zy = A_1_T_zs*s_y + A_1_T_zy*y_y + A_1_T_zz*z_y
    A_1_zz = A_1_T_zs*s_z + A_1_T_zy*y_z + A_1_T_zz*z_z
    # (4) omega x q
    w_q_x = S_dot_x - v_x
    w_q_y = S_dot_y - v_y
    w_q_z = S_dot_z - v_z
    # force by rotation about the tip
    X_xx = A_0_xx + A_1_xy*omega_z + B_xx*m_xx + B_yx*m_xy + B_zx*m_xz - A_1_xz*omega_y
    X_xy = A_0_xy + A_1_xz*omega_x + B_xy*m_xx + B_yy*m_xy + B_zy*m_xz - A_1_xx*omega_z
    X_xz = A_0_xz + A_1_xx*omega_y + B_xz*m_xx + B_yz*m_xy + B_zz*m_xz - A_1_xy*omega_x
    X_yx = A_0_yx + A_1_yy*omega_z + B_xx*m_xy + B_yx*m_yy + B_zx*m_yz - A_1_yz*omega_y
    X_yy = A_0_yy + A_1_yz*omega_x + B_xy*m_xy + B_yy*m_yy + B_zy*m_yz - A_1_yx*omega_z
    X_yz = A_0_yz + A_1_yx*omega_y + B_xz*m_xy + B_yz*m_yy + B_zz*m_yz - A_1_yy*omega_x
    X_zx = A_0_zx + A_1_zy*omega_z + B_xx*m_xz + B_yx*m_yz + B_zx*m_zz - A_1_zz*omega_y
    X_zy = A_0_zy + A_1_zz*omega_x + B_xy*m_xz + B_yy*m_yz + B_zy*m_zz - A_1_zx*omega_z
    X_zz = A_0_zz + A_1_zx*omega_y + B_xz*m_xz + B_yz*m_yz + B_zz*m_zz - A_1_zy*omega_x
    c82 = m_xy*omega_z
    c83 = m_xz*omega_y
    Y_xx = A_1_xx + c82 - c83
    Y_xy = A_1_xy + m_xz*omega_x - m_xx*omega_z
    Y_xz = A_1_xz + m_xx*omega_y - m_xy*omega_x
    Y_yx = A_1_yx + m_yy*omega_z - m_yz*omega_y
    c84 = m_yz*omega_x
    Y_yy = A_1_yy + c84 - c82
    Y_yz = A_1_yz + m_xy*omega_y - m_yy*omega_x
    Y_zx = A_1_zx + m_yz*omega_z - m_zz*omega_y
    Y_zy = A_1_zy + m_zz*omega_x - m_xz*omega_z
    Y_zz = A_1_zz + c83 - c84
    Z_xx = X_xz*q_y - X_xy*q_z
    Z_xy = X_xx*q_z - X_xz*q_x
    Z_xz = X_xy*q_x - X_xx*q_y
    Z_yx = X_yz*q_y - X_yy*q_z
    Z_yy = X_yx*q_z - X_yz*q_x
    Z_yz = X_yy*q_x - X_yx*q_y
    Z_zx = X_zz*q_y - X_zy*q_z
    Z_zy = X_zx*q_z - X_zz*q_x
    Z_zz = X_zy*q_x - X_zx*q_y
    c85 = m_xz*w_q_y
    c86 = m_xy*w_q_z
    V_xx = A_3_xx + Y_xz*q_y + c85 - Y_xy*q_z - c86
    V_xy = A_3_xy + Y_xx*q_z + m_xx*w_q_z - Y_xz*q_x - m_xz*w_q_x
    V_xz = A_3_xz + Y_xy*q_x + m_xy*w_q_x - Y_xx*q_y - m_xx*w_q_y
    V_yx = A_3_yx + Y_yz*q_y + m_yz*w_q_y - Y_yy*q_z - m_yy*w_q_z
    c87 = m_yz*w_q_x
    V_yy = A_3_yy + Y_yx*q_z + c86 - Y_yz*q_x - c87
    V_yz = A_3_yz + Y_yy*q_x + m_yy*w_q_x - Y_yx*q_y - m_xy*w_q_y
    V_zx = A_3_zx + Y_zz*q_y + m_zz*w_q_y - Y_zy*q_z - m_yz*w_q_z
    V_zy = A_3_zy + Y_zx*q_z + m_xz*w_q_z - Y_zz*q_x - m_zz*w_q_x
    V_zz = A_3_zz + Y_zy*q_x + c87 - Y_zx*q_y - c85
    c88 = m_xy*q_z
    c89 = m_xz*q_y
    c90 = -m_yz*q_x
    # m [q]x
    m_q_xx = c88 - c89
    m_q_xy = m_xz*q_x - m_xx*q_z
    m_q_xz = m_xx*q_y - m_xy*q_x
    m_q_yx = m_yy*q_z - m_yz*q_y
    m_q_yy = -c88 - c90
    m_q_yz = m_xy*q_y - m_yy*q_x
    m_q_zx = m_yz*q_z - m_zz*q_y
    m_q_zy = m_zz*q_x - m_xz*q_z
    m_q_zz = c89 + c90
    c91 = R_tip_y*q_y
    c92 = R_tip_z*q_z
    c93 = f_S_dot_xx*omega_y + f_S_xz - f_S_dot_xy*omega_x
    c94 = f_S_dot_xz*omega_x + f_S_xy - f_S_dot_xx*omega_z
    c95 = f_S_dot_xy*omega_z + f_S_xx - f_S_dot_xz*omega_y
    c96 = f_S_dot_yz*omega_x + f_S_yy - f_S_dot_yx*omega_z
    c97 = f_S_dot_yx*omega_y + f_S_yz - f_S_dot_yy*omega_x
    c98 = R_tip_x*q_x
    c99 = f_S_dot_yy*omega_z + f_S_yx - f_S_dot_yz*omega_y
    c100 = f_S_dot_zz*omega_x + f_S_zy - f_S_dot_zx*omega_z
    c101 = f_S_dot_zx*omega_y + f_S_zz - f_S_dot_zy*omega_x
    c102 = f_S_dot_zy*omega_z + f_S_zx - f_S_dot_zz*omega_y
    return {
        "M_vv_xx": m_xx,
        "M_vv_xy": m_xy,
        "M_vv_xz": m_xz,
        "M_vv_yy": m_yy,
        "M_vv_yz": m_yz,
        "M_vv_zz": m_zz,
        "M_vw_xx": -m_q_xx,
        "M_vw_xy": -m_q_xy,
        "M_vw_xz": -m_q_xz,
        "M_vw_yx": -m_q_yx,
        "M_vw_yy": -m_q_yy,
        "M_vw_yz": -m_q_yz,
        "M_vw_zx": -m_q_zx,
        "M_vw_zy": -m_q_zy,
        "M_vw_zz": -m_q_zz,
        "M_ww_xx": m_q_yx*q_z - m_q_zx*q_y,
        "M_ww_xy": m_q_yy*q_z - m_q_zy*q_y,
        "M_ww_xz": m_q_yz*q_z - m_q_zz*q_y,
        "M_ww_yy": m_q_zy*q_x - m_q_xy*q_z,
        "M_ww_yz": m_q_zz*q_x - m_q_xz*q_z,
        "M_ww_zz": m_q_xz*q_y - m_q_yz*q_x,
        "W_ft_xx": A_0_xx,
        "W_ft_xy": A_0_xy,
        "W_ft_xz": A_0_xz,
        "W_ft_yx": A_0_yx,
        "W_ft_yy": A_0_yy,
        "W_ft_yz": A_0_yz,
        "W_ft_zx": A_0_zx,
        "W_ft_zy": A_0_zy,
        "W_ft_zz": A_0_zz,
        "W_fr_xx": Z_xx,
        "W_fr_xy": Z_xy,
        "W_fr_xz": Z_xz,
        "W_fr_yx": Z_yx,
        "W_fr_yy": Z_yy,
        "W_fr_yz": Z_yz,
        "W_fr_zx": Z_zx,
        "W_fr_zy": Z_zy,
        "W_fr_zz": Z_zz,
        "W_mt_xx": A_0_zx*q_y - A_0_yx*q_z - f_S_xx,
        "W_mt_xy": A_0_zy*q_y - A_0_yy*q_z - f_S_xy,
        "W_mt_xz": A_0_zz*q_y - A_0_yz*q_z - f_S_xz,
        "W_mt_yx": A_0_xx*q_z - A_0_zx*q_x - f_S_yx,
        "W_mt_yy": A_0_xy*q_z - A_0_zy*q_x - f_S_yy,
        "W_mt_yz": A_0_xz*q_z - A_0_zz*q_x - f_S_yz,
        "W_mt_zx": A_0_yx*q_x - A_0_xx*q_y - f_S_zx,
        "W_mt_zy": A_0_yy*q_x - A_0_xy*q_y - f_S_zy,
        "W_mt_zz": A_0_yz*q_x - A_0_xz*q_y - f_S_zz,
        "W_mr_xx": Z_zx*q_y + c94*q_z - Z_yx*q_z - c91 - c92 - c93*q_y,
        "W_mr_xy": R_tip_y*q_x + Z_zy*q_y + c93*q_x - Z_yy*q_z - c95*q_z,
        "W_mr_xz": R_tip_z*q_x + Z_zz*q_y + c95*q_y - Z_yz*q_z - c94*q_x,
        "W_mr_yx": R_tip_x*q_y + Z_xx*q_z + c96*q_z - Z_zx*q_x - c97*q_y,
        "W_mr_yy": Z_xy*q_z + c97*q_x - Z_zy*q_x - c92 - c98 - c99*q_z,
        "W_mr_yz": R_tip_z*q_y + Z_xz*q_z + c99*q_y - Z_zz*q_x - c96*q_x,
        "W_mr_zx": R_tip_x*q_z + Z_yx*q_x + c100*q_z - Z_xx*q_y - c101*q_y,
        "W_mr_zy": R_tip_y*q_z + Z_yy*q_x + c101*q_x - Z_xy*q_y - c102*q_z,
        "W_mr_zz": Z_yz*q_x + c102*q_y - Z_xz*q_y - c100*q_x - c91 - c98,
        "W_fv_xx": A_1_xx,
        "W_fv_xy": A_1_xy,
        "W_fv_xz": A_1_xz,
        "W_fv_yx": A_1_yx,
        "W_fv_yy": A_1_yy,
        "W_fv_yz": A_1_yz,
        "W_fv_zx": A_1_zx,
        "W_fv_zy": A_1_zy,
        "W_fv_zz": A_1_zz,
        "W_fw_xx": V_xx,
        "W_fw_xy": V_xy,
        "W_fw_xz": V_xz,
        "W_fw_yx": V_yx,
        "W_fw_yy": V_yy,
        "W_fw_yz": V_yz,
        "W_fw_zx": V_zx,
        "W_fw_zy": V_zy,
        "W_fw_zz": V_zz,
        "W_mv_xx": A_1_zx*q_y - A_1_yx*q_z - f_S_dot_xx,
        "W_mv_xy": A_1_zy*q_y - A_1_yy*q_z - f_S_dot_xy,
        "W_mv_xz": A_1_zz*q_y - A_1_yz*q_z - f_S_dot_xz,
        "W_mv_yx": A_1_xx*q_z - A_1_zx*q_x - f_S_dot_yx,
        "W_mv_yy": A_1_xy*q_z - A_1_zy*q_x - f_S_dot_yy,
        "W_mv_yz": A_1_xz*q_z - A_1_zz*q_x - f_S_dot_yz,
        "W_mv_zx": A_1_yx*q_x - A_1_xx*q_y - f_S_dot_zx,
        "W_mv_zy": A_1_yy*q_x - A_1_xy*q_y - f_S_dot_zy,
        "W_mv_zz": A_1_yz*q_x - A_1_xz*q_y - f_S_dot_zz,
        "W_mw_xx": V_zx*q_y + f_S_dot_xy*q_z - V_yx*q_z - f_S_dot_xz*q_y,
        "W_mw_xy": V_zy*q_y + f_S_dot_xz*q_x - V_yy*q_z - f_S_dot_xx*q_z,
        "W_mw_xz": V_zz*q_y + f_S_dot_xx*q_y - V_yz*q_z - f_S_dot_xy*q_x,
        "W_mw_yx": V_xx*q_z + f_S_dot_yy*q_z - V_zx*q_x - f_S_dot_yz*q_y,
        "W_mw_yy": V_xy*q_z + f_S_dot_yz*q_x - V_zy*q_x - f_S_dot_yx*q_z,
        "W_mw_yz": V_xz*q_z + f_S_dot_yx*q_y - V_zz*q_x - f_S_dot_yy*q_x,
        "W_mw_zx": V_yx*q_x + f_S_dot_zy*q_z - V_xx*q_y - f_S_dot_zz*q_y,
        "W_mw_zy": V_yy*q_x + f_S_dot_zz*q_x - V_xy*q_y - f_S_dot_zx*q_z,
        "W_mw_zz": V_yz*q_x + f_S_dot_zx*q_y - V_xz*q_y - f_S_dot_zy*q_x,
        "H_force_x": s_x,
        "H_force_y": s_y,
        "H_force_z": s_z,
        "H_moment_x": q_y*s_z - q_z*s_y,
        "H_moment_y": q_z*s_x - q_x*s_z,
        "H_moment_z": q_x*s_y - q_y*s_x,
        "S_1_x": S_1_x,
        "S_1_y": S_1_y,
        "S_1_z": S_1_z,
        "L": L,
        "k3": k3,
    }


_PARTS = {
    "equations": (equations_of_platform, equations_of_leg),
    "bias": (bias_of_platform, bias_of_leg),
    "forward_dynamics": (forward_of_platform, forward_of_leg),
    "derivatives": (derivatives_of_platform, derivatives_of_leg),
}
