"""Closed form of the Stewart platform's equations of motion, formulation and joint `exact`.

Written by stewart-sym 0.1.0 with SymPy 1.14; do not edit.
SPDX-License-Identifier: 0BSD

    M [a; alpha] + C [v; omega] + g + friction = H F + [R F_ext; R M_ext]

``robot`` has the fields of ``stewart_robot`` in stewart.h as arrays, legs first: b (6, 3), I_d0 (6, 3, 3).
``motion`` has R (..., 3, 3), t, omega, v, and, where accelerations or loads are read, alpha, a, F_ext, M_ext
(..., 3). Wrenches and twists in base axes about the reference point. Units as in stewart.h.
"""

from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any

import numpy as np

from .assembly import (
    NOT_FINITE,
    OK,
    POLE,
    POLE_SINE,
    ROUNDING,
    SHORT_LEG,
    SHORTEST,
    Array,
    eliminate_many,
    over_length,
    singular_status,
)

INDEFINITE = 6
# Where elimination leaves less than this of a diagonal number of M, digits are lost that the machine has.
KEPT = 2.0**-5
# Below this sine of the angle between a leg and its fixed axis the shorter formulas lose digits.
LEANING = 2.0**-3

_ROWS = tuple(f"{part}_{axis}" for part in ("force", "moment") for axis in "xyz")

# Operations of a pose before any solve.
OPERATIONS: dict[str, int] = {
    "equations": 4634,
    "bias": 2031,
    "forward_dynamics": 2913,
    "derivatives": 11204,
    "joint_rows": 2430,
    "joint_slopes": 14153,
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
    "joint_rows": ("M_vv_xx", "M_vv_xy", "M_vv_xz", "M_vv_yy", "M_vv_yz", "M_vv_zz", "M_vw_xx", "M_vw_xy",
        "M_vw_xz", "M_vw_yx", "M_vw_yy", "M_vw_yz", "M_vw_zx", "M_vw_zy", "M_vw_zz", "M_ww_xx", "M_ww_xy",
        "M_ww_xz", "M_ww_yy", "M_ww_yz", "M_ww_zz", "right_force_x", "right_force_y", "right_force_z",
        "right_moment_x", "right_moment_y", "right_moment_z"),
    "joint_slopes": ("M_vv_xx", "M_vv_xy", "M_vv_xz", "M_vv_yy", "M_vv_yz", "M_vv_zz", "M_vw_xx",
        "M_vw_xy", "M_vw_xz", "M_vw_yx", "M_vw_yy", "M_vw_yz", "M_vw_zx", "M_vw_zy", "M_vw_zz", "M_ww_xx",
        "M_ww_xy", "M_ww_xz", "M_ww_yy", "M_ww_yz", "M_ww_zz", "W_ft_xx", "W_ft_xy", "W_ft_xz", "W_ft_yx",
        "W_ft_yy", "W_ft_yz", "W_ft_zx", "W_ft_zy", "W_ft_zz", "W_fr_xx", "W_fr_xy", "W_fr_xz", "W_fr_yx",
        "W_fr_yy", "W_fr_yz", "W_fr_zx", "W_fr_zy", "W_fr_zz", "W_mt_xx", "W_mt_xy", "W_mt_xz", "W_mt_yx",
        "W_mt_yy", "W_mt_yz", "W_mt_zx", "W_mt_zy", "W_mt_zz", "W_mr_xx", "W_mr_xy", "W_mr_xz", "W_mr_yx",
        "W_mr_yy", "W_mr_yz", "W_mr_zx", "W_mr_zy", "W_mr_zz", "W_fv_xx", "W_fv_xy", "W_fv_xz", "W_fv_yx",
        "W_fv_yy", "W_fv_yz", "W_fv_zx", "W_fv_zy", "W_fv_zz", "W_fw_xx", "W_fw_xy", "W_fw_xz", "W_fw_yx",
        "W_fw_yy", "W_fw_yz", "W_fw_zx", "W_fw_zy", "W_fw_zz", "W_mv_xx", "W_mv_xy", "W_mv_xz", "W_mv_yx",
        "W_mv_yy", "W_mv_yz", "W_mv_zx", "W_mv_zy", "W_mv_zz", "W_mw_xx", "W_mw_xy", "W_mw_xz", "W_mw_yx",
        "W_mw_yy", "W_mw_yz", "W_mw_zx", "W_mw_zy", "W_mw_zz"),
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
    x, fault = _solve_definite(_inertia(total), _wrench(total, "right")[..., None], KEPT)
    lost = (status == OK) & (fault == INDEFINITE)
    if lost.any():
        _, x[lost, :, 0], fault[lost] = _forward_apart(robot, _chosen(motion, lost), F[lost])
    return _good({"acceleration": x[..., 0]}, np.where(status == OK, fault, status))


def joint_inertia(robot: Any, motion: Any) -> dict[str, Array]:
    """H^-1 M H^-T, inertia (..., 6, 6), and status (...)."""
    found = equations(robot, motion)
    H = found["H"]
    half, fault = _solve_columns(robot, motion, H, found["M"])
    whole, _ = _solve_columns(robot, motion, H, half.swapaxes(-1, -2))
    status = np.where(found["status"] == OK, fault, found["status"])
    return _good({"inertia": 0.5 * (whole + whole.swapaxes(-1, -2))}, status)


def derivatives(robot: Any, motion: Any, F: Array) -> dict[str, Array]:
    """by_pose, by_twist, by_acceleration (..., 6, 6) of F (..., 6), this motion's forces; status (...)."""
    total, leg, status = _sums("derivatives", robot, motion, F)
    pose, twist = _slopes(total)
    right = np.concatenate([pose, twist, _inertia(total)], axis=-1)
    H = _columns(leg, "H")
    x, fault = _solve_columns(robot, motion, H, right)
    names = ("by_pose", "by_twist", "by_acceleration")
    found = dict(zip(names, np.split(x, 3, axis=-1), strict=True))
    return _good(found, np.where(status == OK, fault, status))


def linearisation(robot: Any, motion: Any, F: Array) -> dict[str, Array]:
    """A (..., 12, 12), B (..., 12, 6) about this motion; its accelerations must be those under F; status."""
    total, leg, status = _sums("derivatives", robot, motion, F)
    pose, twist = _slopes(total)
    right = np.concatenate([pose, twist, _columns(leg, "H")], axis=-1)
    x, fault = _solve_definite(_inertia(total), right, KEPT)
    lost = (status == OK) & (fault == INDEFINITE)
    if lost.any():
        x[lost], fault[lost] = _slopes_apart(robot, _chosen(motion, lost), F[lost])
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
        if what in _NEAR and np.any(near := parts["k3"].min(axis=-1, keepdims=True) < LEANING):
            exact = _NEAR[what](leg, platform, pose, motion, F)
            parts = {name: np.where(near, exact[name], value) for name, value in parts.items()}
        total = {name: np.broadcast_to(pose[name], shape[:-1]) + _six(parts[name]) for name in _SUMMED[what]}
        return total, parts, _leg_status(leg, motion, parts)


def _six(parts: Array) -> Array:
    total = parts[..., 0]
    for i in range(1, 6):
        total = total + parts[..., i]
    return total


def _leg_status(leg: dict[str, Array], motion: Any, parts: dict[str, Array]) -> Array:
    """The first leg's fault of each pose: not finite, too short, along its universal axis."""
    terms = [parts[f"q_{axis}"] for axis in "xyz"] + [motion.t[..., i, None] for i in range(3)]
    terms += [leg[f"b_{axis}"] for axis in "xyz"]
    L, reach = parts["L"], np.abs(np.broadcast_arrays(*terms)).max(axis=0)
    fault = np.where(parts["k3"] > POLE_SINE, OK, POLE)
    fault = np.where(L > np.maximum(ROUNDING * reach, SHORTEST), fault, SHORT_LEG)
    fault = np.where(np.isfinite(L), fault, NOT_FINITE)
    first = np.argmax(fault != OK, axis=-1)
    return np.take_along_axis(fault, first[..., None], axis=-1)[..., 0]


def _solve_columns(robot: Any, motion: Any, H: Array, right: Array) -> tuple[Array, Array]:
    """X (..., 6, n) of H X = right, and whether H is singular to rounding: status (...)."""
    with np.errstate(all="ignore"):
        q = np.einsum("...ij,lj->...li", motion.R, robot.p)
        terms = np.broadcast_arrays(q, motion.t[..., None, :], robot.b)
        L = np.sqrt(np.sum((q + motion.t[..., None, :] - robot.b) ** 2, axis=-1))
        x, suspect = eliminate_many(*over_length(np.abs(q).max(axis=(-1, -2)), H, right))
        return x, singular_status(H, suspect, L, np.abs(terms).max(axis=(0, -1)), q)


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


def _solve_definite(M: Array, right: Array, least: float = ROUNDING) -> tuple[Array, Array]:
    """x of M x = right by L D L^T, pivots more than ``least`` of their diagonal numbers; status (...)."""
    A = np.concatenate([M, right], axis=-1)
    scale = np.diagonal(M, axis1=-2, axis2=-1)
    status = np.zeros(M.shape[:-2], dtype=np.int32)
    with np.errstate(all="ignore"):
        for k in range(6):
            pivot = A[..., k, k]
            fault = np.where(np.isfinite(pivot), INDEFINITE, NOT_FINITE)
            status = np.where((status == OK) & ~(pivot > least * scale[..., k]), fault, status)
            factor = A[..., k + 1 :, k] * (1 / pivot)[..., None]
            A[..., k + 1 :, :] -= factor[..., None] * A[..., k, None, :]
        for k in range(5, -1, -1):
            A[..., k, 6:] *= (1 / A[..., k, k])[..., None]
            A[..., :k, 6:] -= A[..., :k, k, None] * A[..., k, None, 6:]
    return A[..., 6:], status


@dataclass(frozen=True, eq=False)
class _Rows:
    """M = A^T W A of poses: three rows of A for each leg, by L, theta, phi, and six of the platform.

    weight (n, 8, 3, 3): W in blocks of about one; size (n, 24): root of the inertia in each row; share
    (n, 24, 6): rows as sums of the six that serve as coordinates, which are ``pivot`` (n, 6); factors
    (n, 6, 6): L and U of these six, columns in the order of ``column`` (n, 6); inertia (n, 6, 6): M in these
    coordinates; length (n,): m, by which moments and rotations are measured.
    """

    weight: Array
    size: Array
    share: Array
    factors: Array
    inertia: Array
    length: Array
    pivot: Array
    column: Array


def _factored(total: dict[str, Array], leg: dict[str, Array]) -> _Rows:
    M_xi, row_v, row_w = (_matrix(leg, name, name == "M_xi") for name in ("M_xi", "row_v", "row_w"))
    mass, (theta, phi) = total["M_vv_xx"], (np.abs(M_xi[..., i, i]) for i in (1, 2))
    length = np.abs(row_w[..., 0, :]).max(axis=(-1, -2))
    length = np.where(length > 0, length, 1.0)
    L, rho = leg["L"], leg["L"] * leg["k3"]
    least = np.maximum(np.abs(mass), np.maximum(theta / L / L, phi / rho / rho).max(axis=-1))
    least = np.maximum(np.finfo(np.float64).eps * np.sqrt(least), SHORTEST)
    theta = np.maximum(np.sqrt(theta), least[..., None] * L)
    phi = np.maximum(np.sqrt(phi), least[..., None] * rho)
    along = np.maximum(np.abs(M_xi[..., 0, 1]) / theta, np.abs(M_xi[..., 0, 2]) / phi)
    along = np.maximum(along, np.maximum(np.sqrt(np.abs(M_xi[..., 0, 0])), least[..., None]))
    c = np.stack([total["M_vw_yz"], -total["M_vw_xz"], total["M_vw_xy"]], axis=-1)
    c = c * np.where(mass > 0, 1 / mass, 0.0)[..., None]
    square = np.sum(c * c, axis=-1)[..., None, None] * np.eye(3) - c[..., None] * c[..., None, :]
    about = _matrix(total, "M_ww", symmetric=True) - mass[..., None, None] * square
    root = np.maximum(np.sqrt(np.abs(mass)), least)[..., None]
    turned = np.sqrt(np.abs(np.diagonal(about, axis1=-2, axis2=-1)))
    turned = np.maximum(turned, (least * length)[..., None])
    masses = mass[..., None, None] * np.eye(3)
    inertia = np.concatenate([M_xi, masses[..., None, :, :], about[..., None, :, :]], axis=-3)
    of_platform = np.stack([np.broadcast_to(root, turned.shape), turned], axis=-2)
    size = np.concatenate([np.stack([along, theta, phi], axis=-1), of_platform], axis=-2)
    row = np.zeros((*mass.shape, 8, 3, 6))
    row[..., :6, :, :3], row[..., :6, :, 3:] = row_v, row_w / length[..., None, None, None]
    row[..., 6, :, :3], row[..., 7, :, 3:] = np.eye(3), np.eye(3) / length[..., None, None]
    for i in range(3):
        row[..., 6, i, (i + 1) % 3 + 3] = c[..., (i + 2) % 3] / length
        row[..., 6, i, (i + 2) % 3 + 3] = -c[..., (i + 1) % 3] / length
    weight = inertia / size[..., None] / size[..., None, :]
    row = (row * size[..., None]).reshape(*mass.shape, 24, 6)
    share, factors, pivot, column = _eliminated(row)
    apart = share.reshape(*mass.shape, 8, 3, 6)
    M = np.einsum("nbik,nbij,nbjl->nkl", apart, weight, apart)
    return _Rows(weight, size.reshape(*mass.shape, 24), share, factors, M, length, pivot, column)


def _eliminated(row: Array) -> tuple[Array, Array, Array, Array]:
    """share, factors, pivot and column by elimination with complete pivoting."""
    at = np.arange(len(row))
    order, column = (np.tile(np.arange(count), (len(row), 1)) for count in (24, 6))
    for k in range(6):
        best, across = np.divmod(np.argmax(np.abs(row[:, k:, k:]).reshape(len(row), -1), axis=-1), 6 - k)
        for array, other in ((order, best + k), (column, across + k), (row, best + k)):
            array[at, k], array[at, other] = array[at, other].copy(), array[at, k].copy()
        row[at, :, k], row[at, :, across + k] = row[at, :, across + k].copy(), row[at, :, k].copy()
        row[:, k + 1 :, k] /= row[:, k, k, None]
        row[:, k + 1 :, k + 1 :] -= row[:, k + 1 :, k, None] * row[:, k, None, k + 1 :]
    sums = row[:, 6:].copy()
    for j in range(5, -1, -1):
        sums[..., j] -= (sums[..., j + 1 :] @ row[:, j + 1 : 6, j, None])[..., 0]
    share = np.empty_like(row)
    share[at[:, None], order] = np.concatenate([np.broadcast_to(np.eye(6), (len(row), 6, 6)), sums], axis=1)
    return share, row[:, :6], order[:, :6], column


def _rows_solved(by: _Rows, force: Array, wrench: Array) -> tuple[Array, Array, Array, Array]:
    """x (n, 6, m) of M x = wrench - A^T (force sizes), forces and accelerations of rows, and the status (n,).

    force: generalised forces (n, 24, m); wrench: (n, 6, m).
    """
    at = np.arange(len(force))[:, None]
    force = force / by.size[..., None]
    moved, balanced = _balanced(by, force)
    start = moved[at, by.pivot]
    moved = by.share @ start
    others = by.weight * ~(balanced[..., None] & balanced[..., None, :])
    rest = np.where(balanced.reshape(-1, 24, 1), 0.0, force) - _weighted(others, moved)
    unit = np.where(by.column < 3, 1.0, by.length[:, None])[..., None]
    y = wrench[at, by.column] / unit
    for k in range(6):
        y[:, k] = (y[:, k] - (by.factors[:, None, :k, k] @ y[:, :k])[:, 0]) / by.factors[:, k, k, None]
    for k in range(5, -1, -1):
        y[:, k] -= (by.factors[:, None, k + 1 :, k] @ y[:, k + 1 :])[:, 0]
    found, status = _solve_definite(by.inertia, y - by.share.swapaxes(-1, -2) @ rest)
    held = (rest + _weighted(by.weight, by.share @ found)) * by.size[..., None]
    x = found - start
    turned = (by.share @ x) / by.size[..., None]
    for k in range(6):
        x[:, k] -= (by.factors[:, None, k, :k] @ x[:, :k])[:, 0]
    for k in range(5, -1, -1):
        x[:, k] -= (by.factors[:, None, k, k + 1 :] @ x[:, k + 1 :])[:, 0]
        x[:, k] /= by.factors[:, k, k, None]
    solved = np.empty_like(x)
    solved[at, by.column] = x / unit
    return solved, held, turned, status


def _balanced(by: _Rows, force: Array) -> tuple[Array, Array]:
    """Accelerations (n, 24, m) of the coordinates, under which each block balances their forces, and whose.

    From these the unknown accelerations are measured: the coordinates' own large forces are then out of the
    way. Whose, (n, 8, 3): without rows that have no inertia of their own beside the rows before them.
    """
    W, moved = by.weight.copy(), force.reshape(len(force), 8, 3, -1).copy()
    pivots = np.zeros(by.size.shape, dtype=bool)
    pivots[np.arange(len(force))[:, None], by.pivot] = True
    balanced = pivots.reshape(-1, 8, 3)
    for k in range(3):
        balanced[..., k] &= W[..., k, k] > KEPT
        for i in range(k + 1, 3):
            factor = np.where(balanced[..., k], W[..., i, k] / W[..., k, k], 0.0)[..., None]
            moved[..., i, :] -= factor * moved[..., k, :]
            W[..., i, k + 1 :] -= factor * W[..., k, k + 1 :]
    for k in (2, 1, 0):
        left = moved[..., k, :] - np.sum(W[..., k, k + 1 :, None] * moved[..., k + 1 :, :], axis=-2)
        moved[..., k, :] = np.where(balanced[..., k, None], left / W[..., k, k, None], 0.0)
    return moved.reshape(force.shape), balanced


def _weighted(weight: Array, rows: Array) -> Array:
    """Blocks of weights (n, 8, 3, 3) times rows (n, 24, m)."""
    return (weight @ rows.reshape(len(rows), 8, 3, -1)).reshape(rows.shape)


def _forward_apart(robot: Any, motion: Any, F: Array) -> tuple[_Rows, Array, Array]:
    """The rows, [a; alpha] (n, 6) and the status (n,); ``motion`` gets what derivatives read of the legs."""
    total, leg, _ = _sums("joint_rows", robot, motion, F)
    by = _factored(total, leg)
    force = np.zeros((len(F), 24, 1))
    force[:, :18, 0] = np.stack([leg[f"tau_{axis}"] for axis in "xyz"], axis=-1).reshape(-1, 18)
    x, held, turned, status = _rows_solved(by, force, _wrench(total, "right")[..., None])
    motion.net, motion.turned = (rows[:, :18, 0].reshape(-1, 6, 3) for rows in (held, turned))
    size = by.size[:, :18].reshape(-1, 6, 3)
    of_tip = leg["L"] * size[..., 0]
    share = of_tip / size[..., 1] * (of_tip / size[..., 2] * leg["k3"])
    axial = leg["k3"] / (leg["k3"] + share * share * (share * share))
    motion.axial = np.where(leg["k3"] < LEANING, axial, 1.0)
    return by, x[..., 0], status


def _slopes_apart(robot: Any, motion: Any, F: Array) -> tuple[Array, Array]:
    """M^-1 times the derivatives of the wrench and H, (n, 6, 18), and the status (n,)."""
    by, x, status = _forward_apart(robot, motion, F)
    motion.a, motion.alpha = x[..., :3], x[..., 3:]
    total, leg, _ = _sums("joint_slopes", robot, motion)
    force = np.zeros((len(F), 24, 18))
    slopes = [_matrix(leg, f"tau_{by}") for by in "trvw"]
    force[:, :18, :12] = -np.concatenate(slopes, axis=-1).reshape(-1, 18, 12)
    x, _, _, fault = _rows_solved(by, force, np.concatenate([*_slopes(total), _columns(leg, "H")], axis=-1))
    return x, np.where(status == OK, fault, status)


def _chosen(motion: Any, poses: Array) -> SimpleNamespace:
    """The motion of some poses, (n, ...)."""
    names = ("R", "t", "omega", "v", "alpha", "a", "F_ext", "M_ext")
    return SimpleNamespace(**{name: getattr(motion, name)[poses] for name in names if hasattr(motion, name)})


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

    Operations: 96 (55 mul, 39 add, 1 div, 1 sqrt).
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
        "b_x": b_x,
        "b_y": b_y,
        "b_z": b_z,
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
        "m_u": m_u,
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
        "M": M,
        "R_0_x": R_0_x,
        "R_0_y": R_0_y,
        "R_0_z": R_0_z,
        "I_p_xx": I_p_xx,
        "I_p_xy": I_p_xy,
        "I_p_xz": I_p_xz,
        "I_p_yy": I_p_yy,
        "I_p_yz": I_p_yz,
        "I_p_zz": I_p_zz,
    }


def equations_of_platform(platform: Any, motion: Any) -> dict[str, Any]:
    """The platform's part of M, C, g and friction.

    Operations: 152 (93 mul, 59 add, 0 div, 0 sqrt).
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

    Operations: 678 (422 mul, 252 add, 2 div, 2 sqrt).
    """
    b_x = leg["b_x"]
    b_y = leg["b_y"]
    b_z = leg["b_z"]
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
    t_x = motion.t[..., 0, None]
    t_y = motion.t[..., 1, None]
    t_z = motion.t[..., 2, None]
    omega_x = motion.omega[..., 0, None]
    omega_y = motion.omega[..., 1, None]
    omega_z = motion.omega[..., 2, None]
    v_x = motion.v[..., 0, None]
    v_y = motion.v[..., 1, None]
    v_z = motion.v[..., 2, None]
    g_x = platform["g_x"]
    g_y = platform["g_y"]
    g_z = platform["g_z"]
    # (1) platform point from the reference point
    q_x = R_xx*p_x + R_xy*p_y + R_xz*p_z
    q_y = R_yx*p_x + R_yy*p_y + R_yz*p_z
    q_z = R_zx*p_x + R_zy*p_y + R_zz*p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = q_x + t_b_x
    S_y = q_y + t_b_y
    S_z = q_z + t_b_z
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
    # (4) omega x q
    w_q_x = omega_y*q_z - omega_z*q_y
    w_q_y = omega_z*q_x - omega_x*q_z
    w_q_z = omega_x*q_y - omega_y*q_x
    # (4) velocity of the platform point
    S_dot_x = v_x + w_q_x
    S_dot_y = v_y + w_q_y
    S_dot_z = v_z + w_q_z
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
        "q_x": q_x,
        "q_y": q_y,
        "q_z": q_z,
        "L": L,
        "k3": k3,
    }


def equations_of_leg_near(leg: Any, platform: Any, pose: Any, motion: Any, F: Any) -> dict[str, Any]:
    """One leg's part of M, C, g and friction, its column of H and the column's rate.

    Operations: 698 (426 mul, 268 add, 2 div, 2 sqrt).
    """
    b_x = leg["b_x"]
    b_y = leg["b_y"]
    b_z = leg["b_z"]
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
    t_x = motion.t[..., 0, None]
    t_y = motion.t[..., 1, None]
    t_z = motion.t[..., 2, None]
    omega_x = motion.omega[..., 0, None]
    omega_y = motion.omega[..., 1, None]
    omega_z = motion.omega[..., 2, None]
    v_x = motion.v[..., 0, None]
    v_y = motion.v[..., 1, None]
    v_z = motion.v[..., 2, None]
    g_x = platform["g_x"]
    g_y = platform["g_y"]
    g_z = platform["g_z"]
    # (1) platform point from the reference point
    q_x = R_xx*p_x + R_xy*p_y + R_xz*p_z
    q_y = R_yx*p_x + R_yy*p_y + R_yz*p_z
    q_z = R_zx*p_x + R_zy*p_y + R_zz*p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = q_x + t_b_x
    S_y = q_y + t_b_y
    S_z = q_z + t_b_z
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
    # (4) omega x q
    w_q_x = omega_y*q_z - omega_z*q_y
    w_q_y = omega_z*q_x - omega_x*q_z
    w_q_z = omega_x*q_y - omega_y*q_x
    # (4) velocity of the platform point
    S_dot_x = v_x + w_q_x
    S_dot_y = v_y + w_q_y
    S_dot_z = v_z + w_q_z
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x*s_x + S_dot_y*s_y + S_dot_z*s_z
    c1 = S_dot_x*y_x + S_dot_y*y_y + S_dot_z*y_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = c1*inv_rho
    theta_dot = -inv_L*(S_dot_x*z_x + S_dot_y*z_y + S_dot_z*z_z)
    k33 = k3*k3
    k13 = k1*k3
    L_h2 = L*h2_x
    a1 = L_h2 + dJ_zx
    a2 = J2_xz - L*h2_z
    a3 = J_xy - L*h_y
    # (19) inertia of the joint coordinates
    M_phi = J_xx + a1*k33 + a2*k13
    M_theta = J_yy + L_h2
    M_mixed = J_yz*k3 + a3*k1
    k3_h = h_y*k3
    c2 = h_z*inv_L
    c3 = inv_L*inv_L
    # inertia at the tip, leg frame
    m_leg_sy = -inv_rho*k3_h
    m_leg_sz = -c2
    m_leg_yy = M_phi*inv_rho*inv_rho
    m_leg_yz = -M_mixed*inv_L*inv_rho
    m_leg_zz = M_theta*c3
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
    inv_k3 = L*inv_rho
    # (6) leg's turning about z
    W_z = c1*inv_L
    c4 = W_z*inv_L
    c5 = c4*h_y
    c6 = c5 - c2*theta_dot
    C_leg_11 = c6
    c7 = c4*h_x
    c8 = L_dot*c3
    c9 = c8*h_y
    c10 = inv_L*theta_dot
    c11 = c10*h_y
    c12 = inv_k3*k1
    c13 = W_z*c2
    C_leg_12 = c11*c12 + 2*c12*c13 + c9 - c7
    c14 = c10*h_x - c12*c5
    C_leg_13 = c14 + c8*h_z
    c15 = c3*theta_dot
    c16 = J_yz*c15
    c17 = J_xy*c15
    c18 = W_z*c3
    c19 = inv_k3*inv_k3
    c20 = J_xx*c19
    c21 = 2*J_xz
    c22 = c18*c21
    c23 = J_xx - J_zz
    C_leg_21 = W_z*c23*c3 + W_z*h_z*inv_L*inv_k3*k1 - c12*c17 - c12*c22 - c16 - c18*c20 - c7
    c24 = J_xy*c18
    c25 = c8*h_x
    c26 = c19*c5
    c27 = inv_L*inv_L*inv_L
    c28 = L_dot*c27
    c29 = J_xz*c19
    c30 = c12*c28
    c31 = J_yz*c18
    c32 = c12*c31
    c33 = c19*c24
    c34 = J_xx*k1*inv_k3*inv_k3*inv_k3
    C_leg_22 = (
        L_dot*c23*c27 + L_dot*c3*h_z*inv_k3*k1 + c19*h_z*inv_L*theta_dot + c32 + c33 - c15*c29 - c15*c34
        - c20*c28 - c21*c30 - c24 - c25 - c26
    )
    c35 = c12*c16
    c36 = J_xy*c30 + J_yz*c28 + c18*c29 - c13*c19
    C_leg_23 = c17 + c18*c34 + c36 - c35
    C_leg_31 = J_yy*c15 + c12*c24 + c14 + c31
    C_leg_32 = c11 + c12*c18*(-J_yy - c23) + c13 + c17*c19 + c35 + c36 - c11*c19 - c12*c9 - c17 - c22
    C_leg_33 = c24 + c26 - J_yy*c28 - c25 - c32 - c33 - c6
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
    c37 = C_tip_xy*q_z
    c38 = m_xy*w_q_z
    c39 = C_tip_xz*q_y
    c40 = m_xz*w_q_y
    C_q_xx = c39 + c40 - c37 - c38
    c41 = C_tip_xx*q_z
    C_q_xy = c41 + m_xx*w_q_z - C_tip_xz*q_x - m_xz*w_q_x
    c42 = C_tip_xx*q_y
    C_q_xz = C_tip_xy*q_x + m_xy*w_q_x - c42 - m_xx*w_q_y
    c43 = C_tip_yy*q_z
    C_q_yx = C_tip_yz*q_y + m_yz*w_q_y - c43 - m_yy*w_q_z
    c44 = C_tip_yx*q_z
    c45 = -C_tip_yz*q_x
    c46 = -m_yz*w_q_x
    C_q_yy = c38 + c44 + c45 + c46
    c47 = -C_tip_yy*q_x
    C_q_yz = m_yy*w_q_x - C_tip_yx*q_y - c47 - m_xy*w_q_y
    c48 = -C_tip_zz*q_y
    C_q_zx = m_zz*w_q_y - C_tip_zy*q_z - c48 - m_yz*w_q_z
    c49 = -C_tip_zz*q_x
    C_q_zy = C_tip_zx*q_z + c49 + m_xz*w_q_z - m_zz*w_q_x
    c50 = C_tip_zx*q_y
    c51 = -C_tip_zy*q_x
    C_q_zz = -c40 - c46 - c50 - c51
    # gravity along k x y and along y
    gamma_n = g_x_k_x*y_x + g_x_k_y*y_y + g_x_k_z*y_z
    gamma_y = g_x*y_x + g_y*y_y + g_z*y_z
    # first moment along k and against k x y
    w_k = k1*w_x + k3*w_z
    w_n = k3*w_x - k1*w_z
    c52 = inv_L*(g_k*w_n + gamma_n*w_k)
    c53 = -gamma_n*w_y - gamma_y*w_n
    # against gravity
    held_x = c53*inv_rho*y_x - c52*z_x
    held_y = c53*inv_rho*y_y - c52*z_y
    held_z = c53*inv_rho*y_z - c52*z_z
    c54 = L_dot*s_x
    c55 = inv_rho*(C_us*phi_dot - C_s*(k_x*omega_x + k_y*omega_y + k_z*omega_z))
    c56 = inv_L*(C_us*theta_dot - C_s*(omega_x*y_x + omega_y*y_y + omega_z*y_z))
    c57 = L_dot*s_y
    c58 = L_dot*s_z
    # against friction
    rubbed_x = C_p*c54 + c55*y_x - c56*z_x
    rubbed_y = C_p*c57 + c55*y_y - c56*z_y
    rubbed_z = C_p*c58 + c55*y_z - c56*z_z
    # (3) rate of s
    s_dot_x = inv_L*(S_dot_x - c54)
    s_dot_y = inv_L*(S_dot_y - c57)
    s_dot_z = inv_L*(S_dot_z - c58)
    c59 = m_xy*q_z
    c60 = m_xz*q_y
    c61 = -m_yz*q_x
    # m [q]x
    m_q_xx = c59 - c60
    m_q_xy = m_xz*q_x - m_xx*q_z
    m_q_xz = m_xx*q_y - m_xy*q_x
    m_q_yx = m_yy*q_z - m_yz*q_y
    m_q_yy = -c59 - c61
    m_q_yz = m_xy*q_y - m_yy*q_x
    m_q_zx = m_yz*q_z - m_zz*q_y
    m_q_zy = m_zz*q_x - m_xz*q_z
    m_q_zz = c60 + c61
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
        "C_wv_xx": c50 - c44,
        "C_wv_xy": C_tip_zy*q_y - c43,
        "C_wv_xz": -C_tip_yz*q_z - c48,
        "C_wv_yx": c41 - C_tip_zx*q_x,
        "C_wv_yy": c37 + c51,
        "C_wv_yz": C_tip_xz*q_z + c49,
        "C_wv_zx": C_tip_yx*q_x - c42,
        "C_wv_zy": -C_tip_xy*q_y - c47,
        "C_wv_zz": -c39 - c45,
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
        "q_x": q_x,
        "q_y": q_y,
        "q_z": q_z,
        "L": L,
        "k3": k3,
    }


def bias_of_platform(platform: Any, motion: Any) -> dict[str, Any]:
    """The platform's part of C twist + g + friction.

    Operations: 165 (99 mul, 66 add, 0 div, 0 sqrt).
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
    b_x = leg["b_x"]
    b_y = leg["b_y"]
    b_z = leg["b_z"]
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
    t_x = motion.t[..., 0, None]
    t_y = motion.t[..., 1, None]
    t_z = motion.t[..., 2, None]
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
    # (1) platform point from the reference point
    q_x = R_xx*p_x + R_xy*p_y + R_xz*p_z
    q_y = R_yx*p_x + R_yy*p_y + R_yz*p_z
    q_z = R_zx*p_x + R_zy*p_y + R_zz*p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = q_x + t_b_x
    S_y = q_y + t_b_y
    S_z = q_z + t_b_z
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
    # (4) omega x q
    w_q_x = omega_y*q_z - omega_z*q_y
    w_q_y = omega_z*q_x - omega_x*q_z
    w_q_z = omega_x*q_y - omega_y*q_x
    # (4) velocity of the platform point
    S_dot_x = v_x + w_q_x
    S_dot_y = v_y + w_q_y
    S_dot_z = v_z + w_q_z
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
        "q_x": q_x,
        "q_y": q_y,
        "q_z": q_z,
        "L": L,
        "k3": k3,
    }


def forward_of_platform(platform: Any, motion: Any) -> dict[str, Any]:
    """The platform's part of M and of the right side.

    Operations: 201 (117 mul, 84 add, 0 div, 0 sqrt).
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
    b_x = leg["b_x"]
    b_y = leg["b_y"]
    b_z = leg["b_z"]
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
    t_x = motion.t[..., 0, None]
    t_y = motion.t[..., 1, None]
    t_z = motion.t[..., 2, None]
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
    # (1) platform point from the reference point
    q_x = R_xx*p_x + R_xy*p_y + R_xz*p_z
    q_y = R_yx*p_x + R_yy*p_y + R_yz*p_z
    q_z = R_zx*p_x + R_zy*p_y + R_zz*p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = q_x + t_b_x
    S_y = q_y + t_b_y
    S_z = q_z + t_b_z
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
    # (4) omega x q
    w_q_x = omega_y*q_z - omega_z*q_y
    w_q_y = omega_z*q_x - omega_x*q_z
    w_q_z = omega_x*q_y - omega_y*q_x
    # (4) velocity of the platform point
    S_dot_x = v_x + w_q_x
    S_dot_y = v_y + w_q_y
    S_dot_z = v_z + w_q_z
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
        "q_x": q_x,
        "q_y": q_y,
        "q_z": q_z,
        "L": L,
        "k3": k3,
    }


def derivatives_of_platform(platform: Any, motion: Any) -> dict[str, Any]:
    """The platform's part of the derivatives of the wrench.

    Operations: 338 (168 mul, 170 add, 0 div, 0 sqrt).
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

    Operations: 1718 (1020 mul, 694 add, 2 div, 2 sqrt).
    """
    b_x = leg["b_x"]
    b_y = leg["b_y"]
    b_z = leg["b_z"]
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
    t_x = motion.t[..., 0, None]
    t_y = motion.t[..., 1, None]
    t_z = motion.t[..., 2, None]
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
    # (1) platform point from the reference point
    q_x = R_xx*p_x + R_xy*p_y + R_xz*p_z
    q_y = R_yx*p_x + R_yy*p_y + R_yz*p_z
    q_z = R_zx*p_x + R_zy*p_y + R_zz*p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = q_x + t_b_x
    S_y = q_y + t_b_y
    S_z = q_z + t_b_z
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
    # (4) omega x q
    w_q_x = omega_y*q_z - omega_z*q_y
    w_q_y = omega_z*q_x - omega_x*q_z
    w_q_z = omega_x*q_y - omega_y*q_x
    # (4) velocity of the platform point
    S_dot_x = v_x + w_q_x
    S_dot_y = v_y + w_q_y
    S_dot_z = v_z + w_q_z
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
    A_0_leg_22 = (
        c13*k1*tau_theta + c67*inv_rho*k3 + inv_rho*(G_ddot_22*M_mixed + G_ddot_32*M_phi
        + G_dot_12*tau_rate_31 + G_dot_22*tau_rate_32 + G_dot_32*tau_rate_33 + inv_rho*tau_place_33
        - G_ddot_12*k3_h)
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
        c67*inv_L - inv_L*(G_ddot_13*h_z + G_ddot_23*M_theta + G_ddot_33*M_mixed + G_dot_23*tau_rate_22
        + G_dot_33*tau_rate_23 - inv_L*tau_place_22 - tau_rate_21*theta_dot)
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
    c76 = 2*h_z
    c77 = 2*k3_h
    A_1_leg_11 = C_p + G_dot_21*c76 - G_dot_31*c77
    A_1_leg_12 = G_dot_22*c76 + inv_rho*tau_rate_13 - G_dot_32*c77
    A_1_leg_13 = 2*G_dot_23*h_z - G_dot_33*c77 - inv_L*tau_rate_12
    c78 = 2*M_mixed
    c79 = 2*M_phi
    A_1_leg_21 = inv_rho*(G_dot_21*c78 + G_dot_31*c79 + tau_rate_31)
    A_1_leg_22 = inv_rho*(G_dot_22*c78 + G_dot_32*c79 + inv_rho*tau_rate_33 - G_dot_12*c77)
    A_1_leg_23 = inv_rho*(G_dot_23*c78 + G_dot_33*c79 + c7*k3_h - inv_L*tau_rate_32)
    c80 = 2*M_theta
    A_1_leg_31 = -inv_L*(G_dot_21*c80 + G_dot_31*c78 + tau_rate_21)
    A_1_leg_32 = -inv_L*(G_dot_12*c76 + G_dot_22*c80 + G_dot_32*c78 + inv_rho*tau_rate_23)
    A_1_leg_33 = -inv_L*(G_dot_23*c80 + G_dot_33*c78 - c7*h_z - inv_L*tau_rate_22)
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
    c81 = m_xy*omega_z
    c82 = m_xz*omega_y
    Y_xx = A_1_xx + c81 - c82
    Y_xy = A_1_xy + m_xz*omega_x - m_xx*omega_z
    Y_xz = A_1_xz + m_xx*omega_y - m_xy*omega_x
    Y_yx = A_1_yx + m_yy*omega_z - m_yz*omega_y
    c83 = m_yz*omega_x
    Y_yy = A_1_yy + c83 - c81
    Y_yz = A_1_yz + m_xy*omega_y - m_yy*omega_x
    Y_zx = A_1_zx + m_yz*omega_z - m_zz*omega_y
    Y_zy = A_1_zy + m_zz*omega_x - m_xz*omega_z
    Y_zz = A_1_zz + c82 - c83
    Z_xx = X_xz*q_y - X_xy*q_z
    Z_xy = X_xx*q_z - X_xz*q_x
    Z_xz = X_xy*q_x - X_xx*q_y
    Z_yx = X_yz*q_y - X_yy*q_z
    Z_yy = X_yx*q_z - X_yz*q_x
    Z_yz = X_yy*q_x - X_yx*q_y
    Z_zx = X_zz*q_y - X_zy*q_z
    Z_zy = X_zx*q_z - X_zz*q_x
    Z_zz = X_zy*q_x - X_zx*q_y
    c84 = m_xz*w_q_y
    c85 = m_xy*w_q_z
    V_xx = A_3_xx + Y_xz*q_y + c84 - Y_xy*q_z - c85
    V_xy = A_3_xy + Y_xx*q_z + m_xx*w_q_z - Y_xz*q_x - m_xz*w_q_x
    V_xz = A_3_xz + Y_xy*q_x + m_xy*w_q_x - Y_xx*q_y - m_xx*w_q_y
    V_yx = A_3_yx + Y_yz*q_y + m_yz*w_q_y - Y_yy*q_z - m_yy*w_q_z
    c86 = m_yz*w_q_x
    V_yy = A_3_yy + Y_yx*q_z + c85 - Y_yz*q_x - c86
    V_yz = A_3_yz + Y_yy*q_x + m_yy*w_q_x - Y_yx*q_y - m_xy*w_q_y
    V_zx = A_3_zx + Y_zz*q_y + m_zz*w_q_y - Y_zy*q_z - m_yz*w_q_z
    V_zy = A_3_zy + Y_zx*q_z + m_xz*w_q_z - Y_zz*q_x - m_zz*w_q_x
    V_zz = A_3_zz + Y_zy*q_x + c86 - Y_zx*q_y - c84
    c87 = m_xy*q_z
    c88 = m_xz*q_y
    c89 = -m_yz*q_x
    # m [q]x
    m_q_xx = c87 - c88
    m_q_xy = m_xz*q_x - m_xx*q_z
    m_q_xz = m_xx*q_y - m_xy*q_x
    m_q_yx = m_yy*q_z - m_yz*q_y
    m_q_yy = -c87 - c89
    m_q_yz = m_xy*q_y - m_yy*q_x
    m_q_zx = m_yz*q_z - m_zz*q_y
    m_q_zy = m_zz*q_x - m_xz*q_z
    m_q_zz = c88 + c89
    c90 = R_tip_y*q_y
    c91 = R_tip_z*q_z
    c92 = f_S_dot_xx*omega_y + f_S_xz - f_S_dot_xy*omega_x
    c93 = f_S_dot_xz*omega_x + f_S_xy - f_S_dot_xx*omega_z
    c94 = f_S_dot_xy*omega_z + f_S_xx - f_S_dot_xz*omega_y
    c95 = f_S_dot_yz*omega_x + f_S_yy - f_S_dot_yx*omega_z
    c96 = f_S_dot_yx*omega_y + f_S_yz - f_S_dot_yy*omega_x
    c97 = R_tip_x*q_x
    c98 = f_S_dot_yy*omega_z + f_S_yx - f_S_dot_yz*omega_y
    c99 = f_S_dot_zz*omega_x + f_S_zy - f_S_dot_zx*omega_z
    c100 = f_S_dot_zx*omega_y + f_S_zz - f_S_dot_zy*omega_x
    c101 = f_S_dot_zy*omega_z + f_S_zx - f_S_dot_zz*omega_y
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
        "W_mr_xx": Z_zx*q_y + c93*q_z - Z_yx*q_z - c90 - c91 - c92*q_y,
        "W_mr_xy": R_tip_y*q_x + Z_zy*q_y + c92*q_x - Z_yy*q_z - c94*q_z,
        "W_mr_xz": R_tip_z*q_x + Z_zz*q_y + c94*q_y - Z_yz*q_z - c93*q_x,
        "W_mr_yx": R_tip_x*q_y + Z_xx*q_z + c95*q_z - Z_zx*q_x - c96*q_y,
        "W_mr_yy": Z_xy*q_z + c96*q_x - Z_zy*q_x - c91 - c97 - c98*q_z,
        "W_mr_yz": R_tip_z*q_y + Z_xz*q_z + c98*q_y - Z_zz*q_x - c95*q_x,
        "W_mr_zx": R_tip_x*q_z + Z_yx*q_x + c99*q_z - Z_xx*q_y - c100*q_y,
        "W_mr_zy": R_tip_y*q_z + Z_yy*q_x + c100*q_x - Z_xy*q_y - c101*q_z,
        "W_mr_zz": Z_yz*q_x + c101*q_y - Z_xz*q_y - c90 - c97 - c99*q_x,
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
        "q_x": q_x,
        "q_y": q_y,
        "q_z": q_z,
        "L": L,
        "k3": k3,
    }


def derivatives_of_leg_near(leg: Any, platform: Any, pose: Any, motion: Any, F: Any) -> dict[str, Any]:
    """One leg's part of the derivatives of the wrench.

    Operations: 2155 (1283 mul, 868 add, 2 div, 2 sqrt).
    """
    b_x = leg["b_x"]
    b_y = leg["b_y"]
    b_z = leg["b_z"]
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
    t_x = motion.t[..., 0, None]
    t_y = motion.t[..., 1, None]
    t_z = motion.t[..., 2, None]
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
    # (1) platform point from the reference point
    q_x = R_xx*p_x + R_xy*p_y + R_xz*p_z
    q_y = R_yx*p_x + R_yy*p_y + R_yz*p_z
    q_z = R_zx*p_x + R_zy*p_y + R_zz*p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = q_x + t_b_x
    S_y = q_y + t_b_y
    S_z = q_z + t_b_z
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
    # (4) omega x q
    w_q_x = omega_y*q_z - omega_z*q_y
    w_q_y = omega_z*q_x - omega_x*q_z
    w_q_z = omega_x*q_y - omega_y*q_x
    # (4) velocity of the platform point
    S_dot_x = v_x + w_q_x
    S_dot_y = v_y + w_q_y
    S_dot_z = v_z + w_q_z
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x*s_x + S_dot_y*s_y + S_dot_z*s_z
    c1 = S_dot_x*y_x + S_dot_y*y_y + S_dot_z*y_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = c1*inv_rho
    theta_dot = -inv_L*(S_dot_x*z_x + S_dot_y*z_y + S_dot_z*z_z)
    c2 = L_dot*inv_L
    # L_dot / L
    L_share = c2
    c3 = theta_dot*theta_dot
    theta_dot2 = c3
    phi_dot2 = phi_dot*phi_dot
    inv_k3 = L*inv_rho
    # (6) leg's turning about z
    W_z = c1*inv_L
    # (7) acceleration of the platform point
    S_ddot_x = B_xx*q_x + B_xy*q_y + B_xz*q_z + a_x
    S_ddot_y = B_yx*q_x + B_yy*q_y + B_yz*q_z + a_y
    S_ddot_z = B_zx*q_x + B_zy*q_y + B_zz*q_z + a_z
    c4 = k3*k3
    # (8) acceleration of the length
    L_ddot = L*(c4*phi_dot2 + theta_dot2) + S_ddot_x*s_x + S_ddot_y*s_y + S_ddot_z*s_z
    c5 = 2*L_share
    # (9) turning accelerations of the leg about y and z but for the turning of the frame about s
    own_y = -c5*theta_dot - inv_L*(S_ddot_x*z_x + S_ddot_y*z_y + S_ddot_z*z_z)
    own_z = inv_L*(S_ddot_x*y_x + S_ddot_y*y_y + S_ddot_z*y_z) - W_z*c5
    k33 = c4
    k13 = k1*k3
    L_h2 = L*h2_x
    a1 = L_h2 + dJ_zx
    a2 = J2_xz - L*h2_z
    c6 = L*h_y
    a3 = J_xy - c6
    c7 = J_yz*k3
    # (19) inertia of the joint coordinates
    M_phi = J_xx + a1*k33 + a2*k13
    M_theta = J_yy + L_h2
    M_mixed = a3*k1 + c7
    c8 = h_y*k3
    k3_h = c8
    c9 = h_z*inv_L
    c10 = inv_L*inv_L
    # inertia at the tip, leg frame
    m_leg_sy = -inv_rho*k3_h
    m_leg_sz = -c9
    m_leg_yy = M_phi*inv_rho*inv_rho
    m_leg_yz = -M_mixed*inv_L*inv_rho
    m_leg_zz = M_theta*c10
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
    c11 = h_y*own_z
    c12 = W_z*W_z
    c13 = c12*h_x
    c14 = c3*h_x
    c15 = h_y*k1
    c16 = W_z*inv_k3
    c17 = 2*theta_dot
    c18 = c16*c17
    c19 = c12*h_z
    c20 = inv_k3*k1
    c21 = 2*c20
    tau_L = C_p*L_dot + c15*c18 + c19*c21 + h_z*own_y - c11 - c13 - c14
    c22 = C_us*theta_dot
    c23 = J_yy*own_y
    c24 = J_yz*own_z
    c25 = L_ddot*h_z
    c26 = C_s*w_y_omega
    c27 = k3*w_x
    c28 = c27*g_k
    c29 = k1*w_x
    c30 = c29*gamma_n
    c31 = k3*w_z
    c32 = c31*gamma_n
    c33 = J_xy*c17
    c34 = W_z*c33
    c35 = 2*L
    c36 = h_x*own_y
    c37 = L_dot*c17
    c38 = k1*w_z
    c39 = c38*g_k
    c40 = inv_k3*own_z
    c41 = J_xy*k1
    c42 = c40*c41
    c43 = J_xz*c12
    c44 = 2*c43
    c45 = W_z*c17*c6
    c46 = J_yz*k1
    c47 = c18*c46
    c48 = c6*k1
    c49 = inv_k3*inv_k3
    c50 = c43*c49
    c51 = c12*inv_k3
    c53 = J_xx - J_zz
    c54 = J_yy + c53
    c55 = c54*k1
    tau_theta = (
        L*c19*c49 + c22 + c23 + c24 + c25 + c28 + c30 + c32 + c34 + c35*c36 + c37*h_x + c42 + c44 + c45*c49
        + c51*c55 - c19*c35 - c26 - c34*c49 - c39 - c40*c48 - c45 - c47 - c50
    )
    c56 = C_s*w_k_omega
    c57 = gamma_n*w_y
    c58 = c41*own_y
    c59 = c38*gamma_y
    c60 = 2*own_z
    c61 = J_xz*k1
    c62 = J_xy*c12
    c63 = c62*inv_k3
    c64 = c12*c46
    c65 = c3*c46
    c66 = J_xz*c17
    c67 = k3*own_z
    c68 = h_z*k1
    c69 = 2*h_x
    c70 = 2*W_z
    c71 = J_xy*c3
    c72 = c6*k3
    c73 = c16*theta_dot
    c75 = 2*J_xx
    c76 = c49*c75
    c77 = W_z*theta_dot
    tau_phi = (
        C_us*c16 + J_xx*c40 + L_dot*W_z*c69*k3 + c12*c72 + c3*c72 + c35*c67*h_x + c35*c73*h_z + c58 + c59
        + c60*c61 + c63 + c64 + c65 + c7*own_y - L_ddot*c8 - L_dot*c68*c70 - c15*c37 - c16*c66 - c27*gamma_y
        - c35*c68*own_z - c48*own_y - c51*c6 - c53*c67 - c56 - c57 - c62*k3 - c71*k3 - c76*c77*k1
    )
    c78 = inv_rho*tau_phi
    c79 = inv_L*tau_theta
    c80 = tau_L - F
    # force at the tip, less the actuator's
    R_tip_x = c78*y_x + c80*s_x - c79*z_x
    R_tip_y = c78*y_y + c80*s_y - c79*z_y
    R_tip_z = c78*y_z + c80*s_z - c79*z_z
    c81 = C_s*inv_rho
    c82 = c81*k1
    A_3_leg_21 = -c82
    c83 = c81*k3
    A_3_leg_23 = -c83
    c84 = C_s*inv_L
    A_3_leg_32 = c84
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
    c85 = inv_L*theta_dot
    G_dot_21 = -c85
    c86 = k1*phi_dot
    G_dot_22 = c86*inv_L
    c87 = L_dot*c10
    G_dot_23 = c87
    c88 = inv_rho*k3
    G_dot_31 = -c88*phi_dot
    c89 = inv_rho*theta_dot
    G_dot_32 = -c2*inv_rho - c89*kappa
    G_dot_33 = c86*inv_rho
    c90 = C_s*k1
    f_S_leg_11 = G_dot_31*c90
    f_S_leg_12 = C_s*(G_dot_32*k1 - c88*theta_dot)
    f_S_leg_13 = G_dot_33*c90
    f_S_leg_21 = C_s*G_dot_21
    f_S_leg_22 = C_s*G_dot_22
    f_S_leg_23 = C_s*G_dot_23
    c91 = C_s*k3
    f_S_leg_31 = G_dot_31*c91
    f_S_leg_32 = C_s*(G_dot_32*k3 + c89*k1)
    f_S_leg_33 = G_dot_33*c91
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
    f_S_dot_leg_12 = c82
    f_S_dot_leg_23 = -c84
    f_S_dot_leg_32 = c83
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
    c92 = c9*own_y
    c93 = c87*h_z
    c94 = -c17*c93
    c95 = c9*k1
    c96 = c51*c95
    c97 = c11*inv_L
    c98 = 2*h_y
    c99 = c87*c98
    c100 = W_z*c99
    c101 = c100 + 4*c15*c16*c85 - c97
    A_0_leg_11 = 2*c12*h_x*inv_L + 2*c3*h_x*inv_L - c101 - c92 - c94 - 4*c96
    c102 = h_x*inv_L
    c103 = c102*c60
    c104 = J_yz*c10
    c105 = c104*own_y
    c106 = h_y*inv_L
    c107 = c106*c12
    c108 = 2*c107
    c109 = c10*inv_k3
    c110 = c109*c58
    c111 = c109*c59
    c112 = inv_L*inv_L*inv_L
    c113 = L_dot*L_dot
    c114 = c112*c113
    c115 = c114*c98
    c116 = C_us*c10
    c117 = W_z*c116*c49
    c118 = c10*own_z
    c119 = J_xx*c49
    c120 = 2*c40
    c121 = c10*c61
    c122 = c49*c9
    c123 = c106*c3
    c124 = 2*c49
    c125 = c109*c64
    c126 = c109*c65
    c127 = 2*c93
    c128 = c16*k1
    c129 = c10*c62
    c130 = c129*c49
    c131 = inv_k3*inv_k3*inv_k3
    A_0_leg_12 = (
        C_p*W_z + C_s*c10*inv_k3*w_k_omega + 2*J_xx*W_z*c10*c131*k1*theta_dot + J_xy*c10*c12 + J_xy*c10*c3
        + 2*J_xz*W_z*c10*c49*theta_dot + 2*L_ddot*c10*h_y + 2*W_z*h_z*inv_L*theta_dot + c10*c53*own_z
        + c10*gamma_n*inv_k3*w_y + c10*gamma_y*w_x + 3*c12*c49*h_y*inv_L + 2*h_y*inv_L*inv_k3*k1*own_y
        + 3*h_z*inv_L*inv_k3*k1*own_z - c103 - c105 - c108 - c110 - c111 - c115 - c117 - c118*c119
        - c120*c121 - 6*c122*c77 - c123*c124 - c125 - c126 - c127*c128 - c130
    )
    c132 = c10*c22
    c133 = c10*c23
    c134 = c10*c24
    c135 = 2*c114
    c136 = c135*h_z
    c137 = c10*c44
    c138 = c10*c25
    c139 = c10*c50
    c140 = W_z*c10
    c141 = c140*c33
    c142 = c12*c9
    c143 = 3*c142
    c144 = c10*c42
    c145 = c10*c12
    c146 = c3*c9
    c147 = c10*c26
    c148 = 4*W_z
    c149 = c148*c85
    c150 = c149*h_y
    c151 = (
        c10*c28 + c10*c30 + c10*c32 + c128*c99 + c146 + c150*c49 + 2*c36*inv_L - c10*c39 - c143 - c147
        - c150 - c20*c97
    )
    A_0_leg_13 = (
        c132 + c133 + c134 + c137 + 2*c138 + c141 + c143*c49 + c144 + c145*c55*inv_k3 + c151 - C_p*theta_dot
        - c10*c47 - c136 - c139 - c141*c49
    )
    c152 = L_ddot*c10
    c153 = c152*h_y
    c154 = c10*gamma_y
    c155 = c106*own_y
    c156 = L_dot*c112
    c157 = c156*c17
    c158 = 3*c129
    c159 = 4*c121
    c160 = c148*theta_dot
    c161 = c41*inv_k3
    c162 = 4*c61
    c163 = c156*c16
    c164 = c17*c87*h_y
    c165 = W_z*c156
    c166 = c140*theta_dot
    c167 = 6*c166
    c168 = -2*J_zz
    c169 = c168 + c75
    c170 = c131*k1
    c171 = J_xx*c170
    A_0_leg_21 = (
        J_xz*c167*c49 + J_yz*c157 + 3*c10*c71 + c108*c49 + c109*c56 + c109*c57 + c118*c169 + c120*c95 + c153
        + c154*w_x + c155*c20 + c157*c161 + c158 + c162*c163 + c164*c20 + c165*c76 + c167*c171 - c103
        - 2*c105 - c107 - 2*c110 - c111 - 2*c117 - c118*c76 - c122*c160 - c123 - 3*c125 - 3*c126 - 3*c130
        - c159*c40 - c165*c169
    )
    c173 = L_ddot*c112
    c174 = c14*inv_L
    c175 = c113*inv_L*inv_L*inv_L*inv_L
    c176 = c10*c3
    c177 = J_yy*c145
    c178 = c13*inv_L
    c179 = 2*J_xy
    c180 = c118*c179
    c181 = c10*own_y
    c182 = 2*J_xz
    c183 = c181*c182
    c184 = c154*c49
    c185 = c145*c49
    c186 = C_us*c156
    c187 = inv_k3*inv_k3*inv_k3*inv_k3
    c188 = c187*c75
    c189 = c49*c97
    c190 = c165*c179
    c191 = 2*c92
    c192 = c10*gamma_n
    c193 = c192*c38
    c194 = c109*own_y
    c195 = c10*c43
    c196 = c190*c49
    c197 = 2*c61
    c198 = c197*inv_k3
    c199 = c104*c17
    c200 = W_z*c199
    c201 = c200*c49
    c202 = 2*c170
    c203 = c49*c66
    c204 = c131*c176
    c205 = 2*c134
    c206 = c162*inv_k3
    c207 = c131*c166
    c208 = 4*c207*c41
    c209 = 2*c46
    c210 = c163*c209
    c211 = c170*c75
    c212 = c211*theta_dot
    c213 = c131*c149*c15
    c214 = c10*g_k
    c215 = C_p*c2 + c135*h_x + c193 + c214*c29 + c214*c31 - F*inv_L - c152*c69 - c192*c27
    A_0_leg_22 = (
        c132*c20 + 3*c138*c20 + c143*c170 + c156*c203 + c156*c212 + c173*c53 + c174 + c175*c206 + c175*c76
        + c176*c188 + c176*c198 + c180*c49 + c183 + c184*w_y + c185*(J_yy + c75 - J_zz) + c190 + c191*c49
        + c193*c49 + c194*c55 + c197*c204 + c20*c205 + c213 + c215 + c94 - c109*g_k*w_z - c119*c173
        - c119*c176 - c132*c170 - c136*c20 - c145*c188 - c146*c202 - c146*c21 - c147*c20 - c169*c175
        - 3*c170*c195 - c171*c181 - c173*c198 - c176*c53 - c177 - c178 - c180 - c183*c49 - c186*c49 - 2*c189
        - c196 - c201 - c208 - c210 - c92
    )
    c216 = c104*c3
    c217 = c104*c12
    c218 = J_xy*c49
    c219 = c217*c49
    c220 = c216*c49
    c221 = c155*c49
    c222 = c156*c33
    c223 = c10*k1
    c224 = c223*c63
    c225 = c116*c170
    c226 = c17*c9
    c227 = c157*c46*inv_k3
    c228 = 2*J_yz
    c229 = c9*own_z
    c230 = c118*c182
    c231 = c69*c85
    c232 = c223*c49
    c233 = 2*c161
    c234 = c182*c49
    c235 = (
        J_yz*c173 + W_z*c231 + c159*c73 + c160*c170*c9 + c161*c173 + c184*w_z + c230*c49 - c124*c229
        - c162*c207 - c165*c234 - c166*c169 - c175*c228 - c175*c233 - c232*c56 - c232*c57
    )
    A_0_leg_23 = (
        c107*c20 + c118*c211 + c119*c167 + c123*c20 + c129*c202 + c155 + c161*c176 + c164 + c181*c218 + c216
        + c219 + c220 + c225*c70 + c227 + c235 - J_xx*c167*c187 - c108*c170 - c128*c226 - c153*c20
        - c164*c49 - c165*c211 - c217 - c221 - c222 - c224
    )
    c236 = 2*J_yy
    c237 = c236*theta_dot
    c238 = 2*c41
    A_0_leg_31 = (
        J_xy*c167 + c124*c142 + 2*c132 + 2*c133 + c138 + 2*c144 + c145*c20*(3*J_xx + 3*J_yy - 3*J_zz) + c151
        + 6*c195 + c205 - 6*c10*c46*c73 - 3*c139 - c156*c237 - c163*c238 - c165*c228 - c167*c218
    )
    c239 = c179*c181
    c240 = 4*J_xz
    c242 = c169 + c236
    c243 = 4*c128*c9
    A_0_leg_32 = (
        C_s*c109*w_n_omega + W_z*c225 + c108*c20 + c115*c20 + c118*c171 + c123*c202 + c128*c156*c242
        + 2*c155 + c158*c170 + c165*c240 + c166*c49*(4*J_xx + c168 + c236) + c194*c209 + 3*c219 + c222
        + c229 + c235 + c239*c49 - 3*c107*c170 - c116*c128 - 2*c153*c20 - c166*c188 - c204*c238 - 2*c217
        - c220 - 2*c221 - c222*c49 - c223*c40*c54 - 2*c224 - c227 - c230 - c239 - c243*theta_dot - c70*c93
    )
    A_0_leg_33 = (
        c101 + c137*c170 + c175*c236 + c177 + c178 + c189 + c191 + c196 + c201 + c208 + c210 + c215 + 2*c96
        - J_yy*c173 - J_yy*c176 - c10*c18*c41 - c100*c49 - c118*c218 - c142*c202 - c174 - c185*c54 - c186
        - c190 - c200 - c213
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
    c244 = c106*c70
    c245 = c244 - c226
    A_1_leg_11 = C_p + c245
    c246 = c102*c70
    c247 = c85*c98
    A_1_leg_12 = c20*c247 + c243 + c99 - c246
    c248 = c231 - 2*c106*c128
    A_1_leg_13 = c127 + c248
    c249 = c109*c17
    A_1_leg_21 = W_z*c10*c169 + 2*W_z*h_z*inv_L*inv_k3*k1 - c140*c76 - c159*c16 - c199 - c246 - c249*c41
    c250 = c140*c179
    c251 = c69*c87
    c252 = c244*c49
    c253 = c10*c16
    c254 = c209*c253
    c255 = c250*c49
    A_1_leg_22 = (
        C_us*c10*c49 + 2*L_dot*c10*h_z*inv_k3*k1 + L_dot*c112*c169 + c254 + c255 + 2*c49*h_z*inv_L*theta_dot
        - c10*c203 - c10*c212 - c156*c206 - c156*c76 - c250 - c251 - c252
    )
    c256 = c10*c33
    c257 = c249*c46
    c258 = c70*c9
    c259 = c140*c234 + c156*c228 + c156*c233 - c258*c49
    A_1_leg_23 = c140*c211 + c256 + c259 - c257
    A_1_leg_31 = c10*c237 + c104*c70 + c238*c253 + c248
    A_1_leg_32 = (
        c247 + c256*c49 + c257 + c258 + c259 - c140*c240 - c16*c223*c242 - c20*c99 - c247*c49 - c256
    )
    A_1_leg_33 = C_us*c10 + c250 + c252 - c156*c236 - c245 - c251 - c254 - c255
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
    c260 = m_xy*omega_z
    c261 = m_xz*omega_y
    Y_xx = A_1_xx + c260 - c261
    Y_xy = A_1_xy + m_xz*omega_x - m_xx*omega_z
    Y_xz = A_1_xz + m_xx*omega_y - m_xy*omega_x
    Y_yx = A_1_yx + m_yy*omega_z - m_yz*omega_y
    c262 = m_yz*omega_x
    Y_yy = A_1_yy + c262 - c260
    Y_yz = A_1_yz + m_xy*omega_y - m_yy*omega_x
    Y_zx = A_1_zx + m_yz*omega_z - m_zz*omega_y
    Y_zy = A_1_zy + m_zz*omega_x - m_xz*omega_z
    Y_zz = A_1_zz + c261 - c262
    Z_xx = X_xz*q_y - X_xy*q_z
    Z_xy = X_xx*q_z - X_xz*q_x
    Z_xz = X_xy*q_x - X_xx*q_y
    Z_yx = X_yz*q_y - X_yy*q_z
    Z_yy = X_yx*q_z - X_yz*q_x
    Z_yz = X_yy*q_x - X_yx*q_y
    Z_zx = X_zz*q_y - X_zy*q_z
    Z_zy = X_zx*q_z - X_zz*q_x
    Z_zz = X_zy*q_x - X_zx*q_y
    c263 = m_xz*w_q_y
    c264 = m_xy*w_q_z
    V_xx = A_3_xx + Y_xz*q_y + c263 - Y_xy*q_z - c264
    V_xy = A_3_xy + Y_xx*q_z + m_xx*w_q_z - Y_xz*q_x - m_xz*w_q_x
    V_xz = A_3_xz + Y_xy*q_x + m_xy*w_q_x - Y_xx*q_y - m_xx*w_q_y
    V_yx = A_3_yx + Y_yz*q_y + m_yz*w_q_y - Y_yy*q_z - m_yy*w_q_z
    c265 = m_yz*w_q_x
    V_yy = A_3_yy + Y_yx*q_z + c264 - Y_yz*q_x - c265
    V_yz = A_3_yz + Y_yy*q_x + m_yy*w_q_x - Y_yx*q_y - m_xy*w_q_y
    V_zx = A_3_zx + Y_zz*q_y + m_zz*w_q_y - Y_zy*q_z - m_yz*w_q_z
    V_zy = A_3_zy + Y_zx*q_z + m_xz*w_q_z - Y_zz*q_x - m_zz*w_q_x
    V_zz = A_3_zz + Y_zy*q_x + c265 - Y_zx*q_y - c263
    c266 = m_xy*q_z
    c267 = m_xz*q_y
    c268 = -m_yz*q_x
    # m [q]x
    m_q_xx = c266 - c267
    m_q_xy = m_xz*q_x - m_xx*q_z
    m_q_xz = m_xx*q_y - m_xy*q_x
    m_q_yx = m_yy*q_z - m_yz*q_y
    m_q_yy = -c266 - c268
    m_q_yz = m_xy*q_y - m_yy*q_x
    m_q_zx = m_yz*q_z - m_zz*q_y
    m_q_zy = m_zz*q_x - m_xz*q_z
    m_q_zz = c267 + c268
    c269 = R_tip_y*q_y
    c270 = R_tip_z*q_z
    c271 = f_S_dot_xx*omega_y + f_S_xz - f_S_dot_xy*omega_x
    c272 = f_S_dot_xz*omega_x + f_S_xy - f_S_dot_xx*omega_z
    c273 = f_S_dot_xy*omega_z + f_S_xx - f_S_dot_xz*omega_y
    c274 = f_S_dot_yz*omega_x + f_S_yy - f_S_dot_yx*omega_z
    c275 = f_S_dot_yx*omega_y + f_S_yz - f_S_dot_yy*omega_x
    c276 = R_tip_x*q_x
    c277 = f_S_dot_yy*omega_z + f_S_yx - f_S_dot_yz*omega_y
    c278 = f_S_dot_zz*omega_x + f_S_zy - f_S_dot_zx*omega_z
    c279 = f_S_dot_zx*omega_y + f_S_zz - f_S_dot_zy*omega_x
    c280 = f_S_dot_zy*omega_z + f_S_zx - f_S_dot_zz*omega_y
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
        "W_mr_xx": Z_zx*q_y + c272*q_z - Z_yx*q_z - c269 - c270 - c271*q_y,
        "W_mr_xy": R_tip_y*q_x + Z_zy*q_y + c271*q_x - Z_yy*q_z - c273*q_z,
        "W_mr_xz": R_tip_z*q_x + Z_zz*q_y + c273*q_y - Z_yz*q_z - c272*q_x,
        "W_mr_yx": R_tip_x*q_y + Z_xx*q_z + c274*q_z - Z_zx*q_x - c275*q_y,
        "W_mr_yy": Z_xy*q_z + c275*q_x - Z_zy*q_x - c270 - c276 - c277*q_z,
        "W_mr_yz": R_tip_z*q_y + Z_xz*q_z + c277*q_y - Z_zz*q_x - c274*q_x,
        "W_mr_zx": R_tip_x*q_z + Z_yx*q_x + c278*q_z - Z_xx*q_y - c279*q_y,
        "W_mr_zy": R_tip_y*q_z + Z_yy*q_x + c279*q_x - Z_xy*q_y - c280*q_z,
        "W_mr_zz": Z_yz*q_x + c280*q_y - Z_xz*q_y - c269 - c276 - c278*q_x,
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
        "q_x": q_x,
        "q_y": q_y,
        "q_z": q_z,
        "L": L,
        "k3": k3,
    }


def joint_rows_of_platform(platform: Any, motion: Any) -> dict[str, Any]:
    """The platform's part of M and of the right side.

    Operations: 222 (129 mul, 93 add, 0 div, 0 sqrt).
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
    omega_x = motion.omega[..., 0]
    omega_y = motion.omega[..., 1]
    omega_z = motion.omega[..., 2]
    F_ext_x = motion.F_ext[..., 0]
    F_ext_y = motion.F_ext[..., 1]
    F_ext_z = motion.F_ext[..., 2]
    M_ext_x = motion.M_ext[..., 0]
    M_ext_y = motion.M_ext[..., 1]
    M_ext_z = motion.M_ext[..., 2]
    C_P = platform["C_P"]
    g_x = platform["g_x"]
    g_y = platform["g_y"]
    g_z = platform["g_z"]
    M = platform["M"]
    R_0_x = platform["R_0_x"]
    R_0_y = platform["R_0_y"]
    R_0_z = platform["R_0_z"]
    I_p_xx = platform["I_p_xx"]
    I_p_xy = platform["I_p_xy"]
    I_p_xz = platform["I_p_xz"]
    I_p_yy = platform["I_p_yy"]
    I_p_yz = platform["I_p_yz"]
    I_p_zz = platform["I_p_zz"]
    c1 = R_0_y*R_0_y
    c2 = R_0_z*R_0_z
    J_0_xx = I_p_xx + M*(c1 + c2)
    c3 = M*R_0_x
    J_0_xy = I_p_xy - R_0_y*c3
    J_0_xz = I_p_xz - R_0_z*c3
    c4 = R_0_x*R_0_x
    J_0_yy = I_p_yy + M*(c2 + c4)
    c5 = M*R_0_y
    J_0_yz = I_p_yz - R_0_z*c5
    J_0_zz = I_p_zz + M*(c1 + c4)
    c6 = M*R_0_z
    # (30) first moment of the platform, base frame
    h_base_x = R_xx*c3 + R_xy*c5 + R_xz*c6
    h_base_y = R_yx*c3 + R_yy*c5 + R_yz*c6
    h_base_z = R_zx*c3 + R_zy*c5 + R_zz*c6
    c7 = J_0_xx*R_xx + J_0_xy*R_xy + J_0_xz*R_xz
    c8 = J_0_xy*R_xx + J_0_yy*R_xy + J_0_yz*R_xz
    c9 = J_0_xz*R_xx + J_0_yz*R_xy + J_0_zz*R_xz
    c10 = J_0_xx*R_yx + J_0_xy*R_yy + J_0_xz*R_yz
    c11 = J_0_xy*R_yx + J_0_yy*R_yy + J_0_yz*R_yz
    c12 = J_0_xz*R_yx + J_0_yz*R_yy + J_0_zz*R_yz
    # (32) inertia of the platform, base frame
    J_base_xx = R_xx*c7 + R_xy*c8 + R_xz*c9
    J_base_xy = R_yx*c7 + R_yy*c8 + R_yz*c9
    J_base_xz = R_zx*c7 + R_zy*c8 + R_zz*c9
    J_base_yy = R_yx*c10 + R_yy*c11 + R_yz*c12
    J_base_yz = R_zx*c10 + R_zy*c11 + R_zz*c12
    J_base_zz = (
        R_zx*(J_0_xx*R_zx + J_0_xy*R_zy + J_0_xz*R_zz) + R_zy*(J_0_xy*R_zx + J_0_yy*R_zy + J_0_yz*R_zz)
        + R_zz*(J_0_xz*R_zx + J_0_yz*R_zy + J_0_zz*R_zz)
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
        "B_0_xx": B_xx,
        "B_0_xy": omega_xy,
        "B_0_xz": omega_xz,
        "B_0_yx": omega_xy,
        "B_0_yy": B_yy,
        "B_0_yz": omega_yz,
        "B_0_zx": omega_xz,
        "B_0_zy": omega_yz,
        "B_0_zz": B_zz,
        "M_vv_xx": M,
        "M_vv_xy": 0,
        "M_vv_xz": 0,
        "M_vv_yy": M,
        "M_vv_yz": 0,
        "M_vv_zz": M,
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
        "right_force_x": F_ext_x*R_xx + F_ext_y*R_xy + F_ext_z*R_xz + M*g_x + omega_z*w_h_y - omega_y*w_h_z,
        "right_force_y": F_ext_x*R_yx + F_ext_y*R_yy + F_ext_z*R_yz + M*g_y + omega_x*w_h_z - omega_z*w_h_x,
        "right_force_z": F_ext_x*R_zx + F_ext_y*R_zy + F_ext_z*R_zz + M*g_z + omega_y*w_h_x - omega_x*w_h_y,
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


def joint_rows_of_leg(leg: Any, platform: Any, pose: Any, motion: Any, F: Any) -> dict[str, Any]:
    """One leg's inertia and generalised forces in its joint coordinates, and their gradients.

    Operations: 341 (207 mul, 130 add, 2 div, 2 sqrt).
    """
    b_x = leg["b_x"]
    b_y = leg["b_y"]
    b_z = leg["b_z"]
    p_x = leg["p_x"]
    p_y = leg["p_y"]
    p_z = leg["p_z"]
    k_x = leg["k_x"]
    k_y = leg["k_y"]
    k_z = leg["k_z"]
    m_u = leg["m_u"]
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
    t_x = motion.t[..., 0, None]
    t_y = motion.t[..., 1, None]
    t_z = motion.t[..., 2, None]
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
    # (1) platform point from the reference point
    q_x = R_xx*p_x + R_xy*p_y + R_xz*p_z
    q_y = R_yx*p_x + R_yy*p_y + R_yz*p_z
    q_z = R_zx*p_x + R_zy*p_y + R_zz*p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = q_x + t_b_x
    S_y = q_y + t_b_y
    S_z = q_z + t_b_z
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
    # (4) omega x q
    w_q_x = omega_y*q_z - omega_z*q_y
    w_q_y = omega_z*q_x - omega_x*q_z
    w_q_z = omega_x*q_y - omega_y*q_x
    # (4) velocity of the platform point
    S_dot_x = v_x + w_q_x
    S_dot_y = v_y + w_q_y
    S_dot_z = v_z + w_q_z
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
    c1 = B_0_xx*q_x + B_0_xy*q_y + B_0_xz*q_z
    c2 = B_0_yx*q_x + B_0_yy*q_y + B_0_yz*q_z
    c3 = B_0_zx*q_x + B_0_zy*q_y + B_0_zz*q_z
    # (7) acceleration of the platform point, a = alpha = 0
    S_ddot_x = c1
    S_ddot_y = c2
    S_ddot_z = c3
    c4 = k3*k3
    k33 = c4
    # (8) accelerations of the joint coordinates
    L_ddot = L*(k33*phi_dot2 + theta_dot2) + S_ddot_x*s_x + S_ddot_y*s_y + S_ddot_z*s_z
    # (9) accelerations of the joint coordinates but for the turning of the leg frame about s
    own_theta_ddot = -2*L_share*theta_dot - inv_L*(S_ddot_x*z_x + S_ddot_y*z_y + S_ddot_z*z_z)
    own_phi_ddot = inv_rho*(S_ddot_x*y_x + S_ddot_y*y_y + S_ddot_z*y_z) - L_share*two_phi_dot
    c5 = k1*k3
    # (9) accelerations of the joint coordinates
    theta_ddot = c5*phi_dot2 + own_theta_ddot
    phi_ddot = own_phi_ddot - lean*two_phi_dot
    k13 = c5
    L_h2 = L*h2_x
    a1 = L_h2 + dJ_zx
    c6 = L*h2_z
    c7 = J2_xz - c6
    a2 = c7
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
        + gamma_n*w_k + phi_dot2*(k13*(J_yy - dJ_zx) - c7*(0.5 - k33)) - C_s*(omega_x*y_x + omega_y*y_y
        + omega_z*y_z)
    )
    tau_k = (
        C_us*phi_dot + M_mixed*theta_ddot + M_mixed_theta*theta_dot2 + M_phi*own_phi_ddot
        + two_phi_dot*(L_dot*M_phi_L - theta_dot*(0.5*J2_xz + J_xx*kappa - 0.5*c6)) - C_s*(k_x*omega_x
        + k_y*omega_y + k_z*omega_z) - L_ddot*k3_h - bend*h2_y*k1 - gamma_n*w_y - gamma_y*w_n
    )
    # of the platform point, from free fall
    fall_x = c1 - g_x
    fall_y = c2 - g_y
    fall_z = c3 - g_z
    fall_T_x = fall_x*s_x + fall_y*s_y + fall_z*s_z
    fall_T_y = fall_x*y_x + fall_y*y_y + fall_z*y_z
    fall_T_z = fall_x*z_x + fall_y*z_y + fall_z*z_z
    row_v_yx = -inv_L*z_x
    row_v_yy = -inv_L*z_y
    row_v_yz = -inv_L*z_z
    row_v_zx = inv_rho*y_x
    row_v_zy = inv_rho*y_y
    row_v_zz = inv_rho*y_z
    c8 = m_u*L*L
    c9 = L*m_u
    return {
        "M_vv_xx": 0,
        "M_vv_xy": 0,
        "M_vv_xz": 0,
        "M_vv_yy": 0,
        "M_vv_yz": 0,
        "M_vv_zz": 0,
        "M_vw_xx": 0,
        "M_vw_xy": 0,
        "M_vw_xz": 0,
        "M_vw_yx": 0,
        "M_vw_yy": 0,
        "M_vw_yz": 0,
        "M_vw_zx": 0,
        "M_vw_zy": 0,
        "M_vw_zz": 0,
        "M_ww_xx": 0,
        "M_ww_xy": 0,
        "M_ww_xz": 0,
        "M_ww_yy": 0,
        "M_ww_yz": 0,
        "M_ww_zz": 0,
        "right_force_x": 0,
        "right_force_y": 0,
        "right_force_z": 0,
        "right_moment_x": C_s*(k_x*phi_dot + theta_dot*y_x),
        "right_moment_y": C_s*(k_y*phi_dot + theta_dot*y_y),
        "right_moment_z": C_s*(k_z*phi_dot + theta_dot*y_z),
        "M_xi_xx": m_u,
        "M_xi_xy": h_z,
        "M_xi_xz": -k3_h,
        "M_xi_yy": M_theta + c8,
        "M_xi_yz": M_mixed,
        "M_xi_zz": M_phi + c4*c8,
        "row_v_xx": s_x,
        "row_v_xy": s_y,
        "row_v_xz": s_z,
        "row_v_yx": row_v_yx,
        "row_v_yy": row_v_yy,
        "row_v_yz": row_v_yz,
        "row_v_zx": row_v_zx,
        "row_v_zy": row_v_zy,
        "row_v_zz": row_v_zz,
        "row_w_xx": q_y*s_z - q_z*s_y,
        "row_w_xy": q_z*s_x - q_x*s_z,
        "row_w_xz": q_x*s_y - q_y*s_x,
        "row_w_yx": q_y*row_v_yz - q_z*row_v_yy,
        "row_w_yy": q_z*row_v_yx - q_x*row_v_yz,
        "row_w_yz": q_x*row_v_yy - q_y*row_v_yx,
        "row_w_zx": q_y*row_v_zz - q_z*row_v_zy,
        "row_w_zy": q_z*row_v_zx - q_x*row_v_zz,
        "row_w_zz": q_x*row_v_zy - q_y*row_v_zx,
        "tau_x": (
            C_p*L_dot + fall_T_x*m_u + h_z*theta_ddot - F - M_phi_L*phi_dot2 - h_x*theta_dot2
            - k3_h*phi_ddot
        ),
        "tau_y": tau_y - c9*fall_T_z,
        "tau_z": c9*fall_T_y*k3 + tau_k,
        "q_x": q_x,
        "q_y": q_y,
        "q_z": q_z,
        "L": L,
        "k3": k3,
    }


def joint_slopes_of_platform(platform: Any, motion: Any) -> dict[str, Any]:
    """The platform's part of the derivatives of the wrench.

    Operations: 359 (180 mul, 179 add, 0 div, 0 sqrt).
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
    C_P = platform["C_P"]
    g_x = platform["g_x"]
    g_y = platform["g_y"]
    g_z = platform["g_z"]
    M = platform["M"]
    R_0_x = platform["R_0_x"]
    R_0_y = platform["R_0_y"]
    R_0_z = platform["R_0_z"]
    I_p_xx = platform["I_p_xx"]
    I_p_xy = platform["I_p_xy"]
    I_p_xz = platform["I_p_xz"]
    I_p_yy = platform["I_p_yy"]
    I_p_yz = platform["I_p_yz"]
    I_p_zz = platform["I_p_zz"]
    c1 = R_0_y*R_0_y
    c2 = R_0_z*R_0_z
    J_0_xx = I_p_xx + M*(c1 + c2)
    c3 = M*R_0_x
    J_0_xy = I_p_xy - R_0_y*c3
    J_0_xz = I_p_xz - R_0_z*c3
    c4 = R_0_x*R_0_x
    J_0_yy = I_p_yy + M*(c2 + c4)
    c5 = M*R_0_y
    J_0_yz = I_p_yz - R_0_z*c5
    J_0_zz = I_p_zz + M*(c1 + c4)
    c6 = M*R_0_z
    # (30) first moment of the platform, base frame
    h_base_x = R_xx*c3 + R_xy*c5 + R_xz*c6
    h_base_y = R_yx*c3 + R_yy*c5 + R_yz*c6
    h_base_z = R_zx*c3 + R_zy*c5 + R_zz*c6
    c7 = J_0_xx*R_xx + J_0_xy*R_xy + J_0_xz*R_xz
    c8 = J_0_xy*R_xx + J_0_yy*R_xy + J_0_yz*R_xz
    c9 = J_0_xz*R_xx + J_0_yz*R_xy + J_0_zz*R_xz
    c10 = J_0_xx*R_yx + J_0_xy*R_yy + J_0_xz*R_yz
    c11 = J_0_xy*R_yx + J_0_yy*R_yy + J_0_yz*R_yz
    c12 = J_0_xz*R_yx + J_0_yz*R_yy + J_0_zz*R_yz
    # (32) inertia of the platform, base frame
    J_base_xx = R_xx*c7 + R_xy*c8 + R_xz*c9
    J_base_xy = R_yx*c7 + R_yy*c8 + R_yz*c9
    J_base_xz = R_zx*c7 + R_zy*c8 + R_zz*c9
    J_base_yy = R_yx*c10 + R_yy*c11 + R_yz*c12
    J_base_yz = R_zx*c10 + R_zy*c11 + R_zz*c12
    J_base_zz = (
        R_zx*(J_0_xx*R_zx + J_0_xy*R_zy + J_0_xz*R_zz) + R_zy*(J_0_xy*R_zx + J_0_yy*R_zy + J_0_yz*R_zz)
        + R_zz*(J_0_xz*R_zx + J_0_yz*R_zy + J_0_zz*R_zz)
    )
    c13 = h_base_y*omega_z
    c14 = h_base_z*omega_y
    c15 = h_base_x*omega_z
    c16 = h_base_z*omega_x
    c17 = h_base_x*omega_y
    c18 = h_base_y*omega_x
    # (31) omega x h
    w_h_x = c14 - c13
    w_h_y = c15 - c16
    w_h_z = c18 - c17
    c19 = J_base_xy*omega_y
    c20 = J_base_xz*omega_z
    c21 = J_base_xy*omega_x
    c22 = J_base_yz*omega_z
    c23 = J_base_xz*omega_x
    c24 = J_base_yz*omega_y
    # (34) I omega
    J_w_x = J_base_xx*omega_x + c19 + c20
    J_w_y = J_base_yy*omega_y + c21 + c22
    J_w_z = J_base_zz*omega_z + c23 + c24
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
    c25 = J_base_xy*alpha_y
    c26 = J_base_xz*alpha_z
    J_alpha_x = J_base_xx*alpha_x + c25 + c26
    c27 = J_base_xy*alpha_x
    c28 = J_base_yz*alpha_z
    J_alpha_y = J_base_yy*alpha_y + c27 + c28
    c29 = J_base_xz*alpha_x
    c30 = J_base_yz*alpha_y
    J_alpha_z = J_base_zz*alpha_z + c29 + c30
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
    c31 = J_base_xy*omega_z
    c32 = J_base_xz*omega_y
    c34 = J_w_z + c23 - J_base_xx*omega_z
    c35 = J_w_y + c21 - J_base_xx*omega_y
    c36 = J_w_z + c24 - J_base_yy*omega_z
    c37 = J_base_yz*omega_x
    c39 = c31 - c37
    c40 = J_w_x + c19 - J_base_yy*omega_x
    c41 = J_w_y + c22 - J_base_zz*omega_y
    c42 = J_w_x + c20 - J_base_zz*omega_x
    # derivative of I omega by dphi at fixed omega
    spin_xx = c31 - c32
    spin_xy = c34
    spin_xz = -c35
    spin_yx = -c36
    spin_yy = -c39
    spin_yz = c40
    spin_zx = c41
    spin_zy = -c42
    spin_zz = c32 - c37
    c43 = J_base_xz*alpha_y
    c44 = h_base_y*rise_y
    c45 = h_base_z*rise_z
    c46 = J_base_xy*alpha_z
    c47 = h_base_x*rise_x
    c48 = J_base_yz*alpha_x
    c49 = h_base_y*omega_y
    c50 = h_base_z*omega_z
    c51 = h_base_x*omega_x
    return {
        "B_xx": B_xx,
        "B_xy": B_xy,
        "B_xz": B_xz,
        "B_yx": B_yx,
        "B_yy": B_yy,
        "B_yz": B_yz,
        "B_zx": B_zx,
        "B_zy": B_zy,
        "B_zz": B_zz,
        "M_vv_xx": M,
        "M_vv_xy": 0,
        "M_vv_xz": 0,
        "M_vv_yy": M,
        "M_vv_yz": 0,
        "M_vv_zz": M,
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
        "W_mr_xx": c46 + omega_y*spin_zx - c43 - c44 - c45 - omega_z*spin_yx,
        "W_mr_xy": (
            J_alpha_z + c29 + h_base_x*rise_y + omega_y*spin_zy - J_base_xx*alpha_z - M_load_z
            - omega_z*spin_yy
        ),
        "W_mr_xz": (
            J_base_xx*alpha_y + M_load_y + h_base_x*rise_z + omega_y*spin_zz - J_alpha_y - c27
            - omega_z*spin_yz
        ),
        "W_mr_yx": (
            J_base_yy*alpha_z + M_load_z + h_base_y*rise_x + omega_z*spin_xx - J_alpha_z - c30
            - omega_x*spin_zx
        ),
        "W_mr_yy": c48 + omega_z*spin_xy - c45 - c46 - c47 - omega_x*spin_zy,
        "W_mr_yz": (
            J_alpha_x + c25 + h_base_y*rise_z + omega_z*spin_xz - J_base_yy*alpha_x - M_load_x
            - omega_x*spin_zz
        ),
        "W_mr_zx": (
            J_alpha_y + c28 + h_base_z*rise_x + omega_x*spin_yx - J_base_zz*alpha_y - M_load_y
            - omega_y*spin_xx
        ),
        "W_mr_zy": (
            J_base_zz*alpha_x + M_load_x + h_base_z*rise_y + omega_x*spin_yy - J_alpha_x - c26
            - omega_y*spin_xy
        ),
        "W_mr_zz": c43 + omega_x*spin_yz - c44 - c47 - c48 - omega_y*spin_xz,
        "W_fv_xx": 0,
        "W_fv_xy": 0,
        "W_fv_xz": 0,
        "W_fv_yx": 0,
        "W_fv_yy": 0,
        "W_fv_yz": 0,
        "W_fv_zx": 0,
        "W_fv_zy": 0,
        "W_fv_zz": 0,
        "W_fw_xx": c49 + c50,
        "W_fw_xy": w_h_z - c17,
        "W_fw_xz": -c15 - w_h_y,
        "W_fw_yx": -c18 - w_h_z,
        "W_fw_yy": c50 + c51,
        "W_fw_yz": w_h_x - c13,
        "W_fw_zx": w_h_y - c16,
        "W_fw_zy": -c14 - w_h_x,
        "W_fw_zz": c49 + c51,
        "W_mv_xx": 0,
        "W_mv_xy": 0,
        "W_mv_xz": 0,
        "W_mv_yx": 0,
        "W_mv_yy": 0,
        "W_mv_yz": 0,
        "W_mv_zx": 0,
        "W_mv_zy": 0,
        "W_mv_zz": 0,
        "W_mw_xx": C_P + c32 - c31,
        "W_mw_xy": c36,
        "W_mw_xz": -c41,
        "W_mw_yx": -c34,
        "W_mw_yy": C_P + c39,
        "W_mw_yz": c42,
        "W_mw_zx": c35,
        "W_mw_zy": -c40,
        "W_mw_zz": C_P + c37 - c32,
    }


def joint_slopes_of_leg(leg: Any, platform: Any, pose: Any, motion: Any, F: Any) -> dict[str, Any]:
    """One leg's part of the derivatives of the wrench, and its generalised forces' derivatives.

    Operations: 2206 (1382 mul, 820 add, 2 div, 2 sqrt).
    """
    b_x = leg["b_x"]
    b_y = leg["b_y"]
    b_z = leg["b_z"]
    p_x = leg["p_x"]
    p_y = leg["p_y"]
    p_z = leg["p_z"]
    k_x = leg["k_x"]
    k_y = leg["k_y"]
    k_z = leg["k_z"]
    m_u = leg["m_u"]
    C_p = leg["C_p"]
    C_s = leg["C_s"]
    h_x = leg["h_x"]
    h_y = leg["h_y"]
    h_z = leg["h_z"]
    w_x = leg["w_x"]
    w_y = leg["w_y"]
    w_z = leg["w_z"]
    J_xx = leg["J_xx"]
    J_xy = leg["J_xy"]
    J_xz = leg["J_xz"]
    J_yy = leg["J_yy"]
    J_yz = leg["J_yz"]
    J_zz = leg["J_zz"]
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
    t_x = motion.t[..., 0, None]
    t_y = motion.t[..., 1, None]
    t_z = motion.t[..., 2, None]
    omega_x = motion.omega[..., 0, None]
    omega_y = motion.omega[..., 1, None]
    omega_z = motion.omega[..., 2, None]
    v_x = motion.v[..., 0, None]
    v_y = motion.v[..., 1, None]
    v_z = motion.v[..., 2, None]
    B_xx = pose["B_xx"][..., None]
    B_xy = pose["B_xy"][..., None]
    B_xz = pose["B_xz"][..., None]
    B_yx = pose["B_yx"][..., None]
    B_yy = pose["B_yy"][..., None]
    B_yz = pose["B_yz"][..., None]
    B_zx = pose["B_zx"][..., None]
    B_zy = pose["B_zy"][..., None]
    B_zz = pose["B_zz"][..., None]
    net_x = motion.net[..., 0]
    net_y = motion.net[..., 1]
    net_z = motion.net[..., 2]
    turned_x = motion.turned[..., 0]
    turned_y = motion.turned[..., 1]
    turned_z = motion.turned[..., 2]
    axial = motion.axial
    g_x = platform["g_x"]
    g_y = platform["g_y"]
    g_z = platform["g_z"]
    # (1) platform point from the reference point
    q_x = R_xx*p_x + R_xy*p_y + R_xz*p_z
    q_y = R_yx*p_x + R_yy*p_y + R_yz*p_z
    q_z = R_zx*p_x + R_zy*p_y + R_zz*p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = q_x + t_b_x
    S_y = q_y + t_b_y
    S_z = q_z + t_b_z
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
    # (4) omega x q
    w_q_x = omega_y*q_z - omega_z*q_y
    w_q_y = omega_z*q_x - omega_x*q_z
    w_q_z = omega_x*q_y - omega_y*q_x
    # (4) velocity of the platform point
    S_dot_x = v_x + w_q_x
    S_dot_y = v_y + w_q_y
    S_dot_z = v_z + w_q_z
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x*s_x + S_dot_y*s_y + S_dot_z*s_z
    c1 = S_dot_x*y_x + S_dot_y*y_y + S_dot_z*y_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = c1*inv_rho
    theta_dot = -inv_L*(S_dot_x*z_x + S_dot_y*z_y + S_dot_z*z_z)
    c2 = L_dot*inv_L
    # L_dot / L
    L_share = c2
    c3 = theta_dot*theta_dot
    theta_dot2 = c3
    phi_dot2 = phi_dot*phi_dot
    inv_k3 = L*inv_rho
    # (6) leg's turning about z
    W_z = c1*inv_L
    c4 = omega_z*w_q_y
    c5 = omega_x*w_q_z - omega_z*w_q_x
    c6 = omega_y*w_q_x
    # (7) acceleration of the platform point
    S_ddot_x = omega_y*w_q_z - c4
    S_ddot_y = -c5
    S_ddot_z = omega_x*w_q_y - c6
    c7 = k3*k3
    # (8) acceleration of the length
    L_ddot = L*(c7*phi_dot2 + theta_dot2) + S_ddot_x*s_x + S_ddot_y*s_y + S_ddot_z*s_z + turned_x
    c8 = 2*L_share
    c9 = k3*turned_z
    # (9) turning accelerations of the leg about y and z but for the turning of the frame about s
    own_y = turned_y - c8*theta_dot - inv_L*(S_ddot_x*z_x + S_ddot_y*z_y + S_ddot_z*z_z)
    own_z = c9 + inv_L*(S_ddot_x*y_x + S_ddot_y*y_y + S_ddot_z*y_z) - W_z*c8
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
    c10 = inv_rho*net_z
    c11 = inv_L*net_y
    # force at the tip, less the actuator's
    R_tip_x = c10*y_x + net_x*s_x - c11*z_x
    R_tip_y = c10*y_y + net_x*s_y - c11*z_y
    R_tip_z = c10*y_z + net_x*s_z - c11*z_z
    fall_x = omega_y*w_q_z - c4 - g_x
    fall_y = -c5 - g_y
    fall_z = omega_x*w_q_y - c6 - g_z
    # acceleration of the platform point from free fall, leg frame
    fall_T_x = fall_x*s_x + fall_y*s_y + fall_z*s_z + turned_x
    fall_T_y = L*c9 + fall_x*y_x + fall_y*y_y + fall_z*y_z
    fall_T_z = fall_x*z_x + fall_y*z_y + fall_z*z_z - L*turned_y
    c12 = h_z*own_y
    c13 = W_z*W_z
    c14 = inv_L*inv_L
    c15 = L_dot*c14
    c16 = 2*h_y
    c17 = W_z*c16
    c18 = h_y*inv_L
    c19 = W_z*inv_k3
    c20 = c19*k1
    c21 = 4*c20
    c22 = c21*theta_dot
    c23 = c13*h_z
    c24 = c23*inv_L
    c25 = inv_k3*k1
    tau_S_leg_11 = (
        2*L_dot*c14*h_z*theta_dot + 2*c13*h_x*inv_L + 2*c3*h_x*inv_L + h_y*inv_L*own_z - c12*inv_L - c15*c17
        - c18*c22 - 4*c24*c25
    )
    c26 = 2*h_x
    c27 = c26*inv_L
    c28 = c27*own_z
    c29 = axial*m_u
    c30 = c29*fall_T_y
    c31 = L_ddot*c14
    c32 = c14*w_x
    c33 = c32*gamma_y
    c34 = c18*c3
    c35 = h_z*inv_L
    c36 = 2*theta_dot
    c37 = c35*c36
    c38 = h_y*own_y
    c39 = inv_L*k1
    c40 = c39*inv_k3
    c41 = h_z*own_z
    c42 = J_zz*own_z
    c43 = c14*c42
    c44 = c13*c18
    c45 = L_dot*L_dot
    c46 = inv_L*inv_L*inv_L
    c47 = c45*c46
    c48 = axial*c15
    c49 = inv_k3*inv_k3
    c50 = 4*W_z
    c51 = 2*c49
    c52 = 4*c15
    c53 = h_y*k1
    c54 = c53*inv_k3
    c55 = c15*c36
    tau_S_leg_12 = (
        C_p*W_z + W_z*c26*c48 + W_z*c37 + axial*c28 + axial*c43 + c30*inv_L + c31*h_y + c33 + c34 + c38*c40
        + c40*c41 + c44*c51 - axial*c33 - c16*c47 - c20*c52*h_z - c28 - c34*c51 - c35*c49*c50*theta_dot
        - c43 - c44 - c54*c55
    )
    c56 = c26*own_y
    c57 = c56*inv_L
    c58 = c29*fall_T_z
    c59 = J_yy*c14*own_y
    c60 = L_ddot*h_z
    c61 = c3*h_z
    c62 = W_z*c36
    c63 = c18*c62
    c64 = c32*g_k*k3
    c65 = gamma_n*k1
    c66 = c32*c65
    c67 = 2*h_z
    c68 = c26*theta_dot
    c69 = 2*W_z
    c70 = c54*c69
    c72 = J_yy - J_zz
    c73 = c13*inv_k3
    c74 = c73*k1
    c75 = c14*c74
    tau_S_leg_13 = (
        c14*c60 + c15*c70 + c24*c51 + c49*c63 + c57 + c58*inv_L + c59 + c61*inv_L + c64 + c66 + c72*c75
        - C_p*theta_dot - axial*c57 - axial*c59 - axial*c64 - axial*c66 - axial*c72*c75 - c24 - c47*c67
        - c48*c68 - c63
    )
    c77 = C_us*inv_L
    c78 = c77*theta_dot
    c79 = 2*J_yy
    c80 = inv_L*own_y
    c81 = J_yz*inv_L
    c82 = c16*theta_dot
    c83 = W_z*c82
    c84 = axial*c56
    c85 = J_yy*inv_L
    c86 = axial*c85
    c87 = inv_L*theta_dot
    c88 = J_xy*c87
    c89 = c50*c88
    c90 = inv_L*k3
    c91 = c90*w_x
    c92 = c91*g_k
    c93 = inv_L*w_x
    c94 = c65*c93
    c95 = J_xz*c13
    c96 = 4*inv_L
    c97 = J_xy*inv_L
    c98 = c97*k1
    c99 = c98*inv_k3
    c100 = axial*c2
    c101 = c15*c79
    c102 = 2*J_yz
    c103 = c102*c15
    c104 = c49*c83
    c105 = c23*c49
    c106 = 2*c95
    c107 = c49*inv_L
    c108 = 2*k1
    c109 = J_xy*c15
    c110 = c108*c109
    c111 = c39*c73
    c112 = 2*J_xx
    tau_S_leg_21 = (
        W_z*c103 + axial*c111*c72 + axial*c92 + axial*c94 + c100*c68 + c101*theta_dot + c106*c107 + c110*c19
        + c111*(3*J_zz - 3*J_yy - c112) + c22*c81 + c23 + c49*c89 + c83 + c84 + c86*own_y - c104 - c105
        - c2*c70 - c56 - c58 - c61 - c78 - c79*c80 - c81*own_z - c89 - c92 - c94 - c95*c96 - c99*own_z
    )
    c113 = c97*own_y
    c114 = W_z*c68
    c115 = gamma_y*inv_L*w_z
    c116 = c13*c81
    c117 = C_s*inv_L
    c118 = W_z*c77*inv_k3
    c119 = c30*k1
    c120 = J_yz*c31
    c121 = c3*c81
    c122 = k1*own_y
    c123 = c122*c81
    c124 = inv_k3*own_z
    c125 = axial*k1
    c126 = c125*c26
    c127 = axial*c42
    c128 = c109*c36
    c129 = J_xz*W_z
    c130 = c129*c52
    c131 = J_xz*k1
    c132 = c125*c93
    c133 = J_xy*k1
    c134 = c133*c31
    c135 = W_z*c67
    c136 = c135*c49
    c137 = inv_k3*inv_k3*inv_k3
    c138 = c135*k1
    c139 = c138*theta_dot
    c140 = c2*c26
    c141 = c125*c140
    c142 = 2*c53
    c143 = c13*c137
    c144 = c137*c3
    c145 = c39*own_z
    c146 = c129*c87
    c147 = J_yz*k1
    c148 = -2*J_zz
    c149 = c112 + c148
    c150 = J_xy*c108*c47
    c151 = 2*c98
    c152 = J_xz*c69
    c153 = c14*c45
    c154 = c149 + c79
    c156 = W_z*c49
    tau_S_leg_22 = (
        L_ddot*c18*c25 + W_z*c149*c87 + c102*c47 + c108*c137*c146 + c113 + c116 + c118*k1 + c119*inv_k3
        + c121*c51 + c124*c126 + c127*c40 + c128*c49 + c141*c19 + c142*c143 + c144*c151 + c145*c72*inv_k3
        + c147*c55*inv_k3 + c15*c152*c49 + c150*inv_k3 + c2*c50*h_z + c2*c82 + c22*h_z + c3*c54 + c38*c49
        + c41 + c73*c98 - c113*c49 - c114 - c115 - c116*c51 - c117*inv_k3*w_n_omega - c120 - c121
        - c123*inv_k3 - c128 - c130 - 4*c131*c19*c87 - c132*gamma_y*inv_k3 - c134*inv_k3 - c136*c2
        - c137*c139 - c142*c144 - c143*c151 - c15*c154*c20 - 2*c153*c54 - c154*c156*c87 - c2*c49*c82
        - c3*c99 - c38 - c53*c73
    )
    c157 = g_k*k1
    c158 = gamma_n*w_z
    c159 = h_y*own_z
    c160 = c50*c87
    c161 = c137*c160
    c162 = c15*c19
    c163 = c106*c39
    c164 = J_xx + c72
    tau_S_leg_23 = (
        C_us*L_dot*c14 + 2*J_xy*L_dot*W_z*c14 + 2*J_xy*W_z*inv_L*inv_k3*k1*theta_dot + J_xy*c49*inv_L*own_z
        + J_yy*L_ddot*c14 + J_yy*c3*inv_L + 2*J_yz*W_z*inv_L*theta_dot + 2*L_ddot*h_x*inv_L
        + 2*L_dot*W_z*c49*h_y*inv_L + 4*W_z*c137*h_y*k1*theta_dot + 2*c13*c137*h_z*k1 + c13*c164*c49*inv_L
        + fall_T_x*m_u + gamma_n*inv_L*k3*w_x - c109*c49*c69 - c12 - c13*c26 - c13*c85 - c133*c161
        - c137*c163 - 2*c147*c162 - c153*c26 - c157*c93 - c158*c39 - c159*c49 - c17*c2 - c47*c79
        - c49*c62*c81 - c54*c62 - c90*g_k*w_z
    )
    c165 = c26*k3
    c166 = c165*own_z
    c167 = c91*gamma_y
    c168 = c73*h_y
    c169 = J_xx*inv_k3
    c170 = c169*inv_L
    c171 = 2*J_xz
    c172 = c81*k3
    c173 = c135*inv_k3
    c174 = J_xz*c19
    c175 = 4*c87
    c176 = 2*k3
    c177 = c176*c97
    c178 = W_z*c165
    c179 = c90*own_z
    c180 = J_yz*k3
    c181 = c49*k1
    c183 = -W_z*c149*k3
    tau_S_leg_31 = (
        J_xx*c160*c181 + axial*c166 + c100*c178 + c110*theta_dot + c112*c162 + c127*c90 + c13*c177 + c130*k1
        + c15*c183 + c167 + c168 + c174*c175 + c177*c3 + c179*(J_xx + c148) + c180*c55 + c30*k3 - axial*c167
        - c108*c116 - c108*c121 - c113*k1 - c118 - c138*c2 - c145*c171 - c166 - c170*own_z - c172*own_y
        - c173*theta_dot - 2*c73*c97
    )
    c184 = k3*own_z
    c185 = c93*gamma_n
    c186 = c171*inv_k3
    c187 = c108*c61
    c188 = c108*c88
    c189 = c67*theta_dot
    c190 = c2*k3
    c191 = c112*inv_L
    c192 = c67*k1
    c193 = J_xx - J_zz
    tau_S_leg_32 = (
        2*J_xx*L_dot*c14*c49*k1*theta_dot + 2*J_xx*c137*c3*inv_L + 2*J_xx*c45*c46*inv_k3
        + 2*J_xy*L_dot*W_z*c14*k3 + J_xy*inv_L*inv_k3*own_z + 2*J_xz*L_dot*c14*inv_k3*theta_dot
        + 2*J_xz*c3*c49*inv_L*k1 + 2*J_xz*c3*inv_L*k1 + 4*J_xz*c45*c46*k1 + 2*J_xz*inv_L*k3*own_y
        + J_yz*inv_L*k1*own_z + L_ddot*c14*c193*k3 + 2*L_ddot*h_z*inv_L*k1 + 2*W_z*c49*h_y*k1*theta_dot
        + axial*c13*c72*inv_L*k3 + axial*c7*gamma_n*inv_L*w_x + axial*fall_T_z*k1*m_u
        + c13*c164*inv_L*inv_k3 + 2*c13*c49*h_z*k1 + c13*inv_L*k3*(J_xx - J_yy) + 2*c14*c45*h_x*k3
        + c164*inv_L*k1*own_y + 2*c3*h_x*k3 + g_k*inv_L*k1*k3*w_x + gamma_n*inv_L*inv_k3*k1*w_z
        + gamma_y*inv_L*inv_k3*w_y + 2*h_z*inv_k3*own_y - C_us*c15*inv_k3 - J_xx*c107*c122 - J_xz*c108*c31
        - L_ddot*c165*inv_L - W_z*c188 - axial*c13*c72*inv_L*inv_k3 - axial*c157*c91 - axial*c185
        - 2*c109*c19 - 2*c12*k3 - c122*c86 - c125*c2*c68 - c143*c191 - c147*c15*c69 - c149*c45*c46*k3
        - c153*c192 - c156*c188 - c159*inv_k3 - c163*c49 - c163 - c169*c31 - c170*c3 - c172*c62 - c181*c78
        - c184*c97 - c185*c7 - c186*c80 - c187*c49 - c187 - c189*c190 - c193*c3*inv_L*k3 - c84*k1
        - fall_T_x*k3*m_u
    )
    c195 = J_xx*c145
    c196 = c156*k1
    c197 = J_xy*k3
    c198 = c171*c19
    c199 = 2*c180
    c200 = c13*c49
    c201 = c112*c196
    tau_S_leg_33 = (
        c113*k3 + c114*k3 + c115*k3 + c120*k3 + c121*c176 + c129*c175*k1 + c132*gamma_y + c134
        + c136*k1*theta_dot + c147*c55 + c151*c3 + c160*c169 + c171*c179 + c173*c2 + c183*c87 + c195*c49
        + c195 + c196*c77 + c200*c98 - J_xx*c161 - W_z*c141 - c108*c146*c49 - c119 - c123 - c126*own_z
        - c127*c39 - c135*c190 - c139 - c15*c198 - c15*c201 - c150 - c176*c41 - c197*c55 - c199*c47
        - c200*c53
    )
    # generalised forces by the tip's motion
    tau_S_xx = s_x*tau_S_leg_11 + tau_S_leg_12*y_x + tau_S_leg_13*z_x
    tau_S_xy = s_y*tau_S_leg_11 + tau_S_leg_12*y_y + tau_S_leg_13*z_y
    tau_S_xz = s_z*tau_S_leg_11 + tau_S_leg_12*y_z + tau_S_leg_13*z_z
    tau_S_yx = s_x*tau_S_leg_21 + tau_S_leg_22*y_x + tau_S_leg_23*z_x
    tau_S_yy = s_y*tau_S_leg_21 + tau_S_leg_22*y_y + tau_S_leg_23*z_y
    tau_S_yz = s_z*tau_S_leg_21 + tau_S_leg_22*y_z + tau_S_leg_23*z_z
    tau_S_zx = s_x*tau_S_leg_31 + tau_S_leg_32*y_x + tau_S_leg_33*z_x
    tau_S_zy = s_y*tau_S_leg_31 + tau_S_leg_32*y_y + tau_S_leg_33*z_y
    tau_S_zz = s_z*tau_S_leg_31 + tau_S_leg_32*y_z + tau_S_leg_33*z_z
    tau_S_dot_leg_11 = C_p + c18*c69 - c37
    c202 = c108*c18
    tau_S_dot_leg_12 = c15*c16 + c202*inv_k3*theta_dot + c21*c35 - W_z*c27
    tau_S_dot_leg_13 = c15*c67 + c26*c87 - c19*c202
    tau_S_dot_leg_21 = 2*W_z*h_y*inv_k3*k1 - c151*c19 - c68 - c69*c81 - c79*c87
    c203 = c108*c81
    c204 = c203*theta_dot
    tau_S_dot_leg_22 = (
        2*J_xy*inv_L*theta_dot + 4*J_xz*W_z*inv_L + 2*L_dot*h_y*inv_L*inv_k3*k1 + W_z*c154*inv_L*inv_k3*k1
        + 2*W_z*c49*h_z + 2*c49*h_y*theta_dot - c103 - c107*c152 - c110*inv_k3 - c135 - c204*inv_k3
        - 2*c49*c88 - c82
    )
    c205 = c69*c97
    tau_S_dot_leg_23 = c101 + c140 + c17 + c19*c203 + c205*c49 - c17*c49 - c189 - c205 - c77
    tau_S_dot_leg_31 = W_z*c149*inv_L*k3 + 2*W_z*h_z*k1 - c129*c96*k1 - c172*c36 - c178 - c188 - c19*c191
    tau_S_dot_leg_32 = (
        C_us*inv_L*inv_k3 + 2*J_xy*W_z*inv_L*inv_k3 + 2*J_yz*W_z*inv_L*k1 + L_dot*c14*c149*k3
        + 2*L_dot*h_z*inv_L*k1 + 2*h_z*inv_k3*theta_dot - W_z*c177 - c112*c15*inv_k3 - c112*c181*c87
        - c131*c52 - c165*c2 - c17*inv_k3 - c186*c87
    )
    tau_S_dot_leg_33 = c110 + c112*c156*c39 + c15*c199 + 2*c197*c87 + c198*inv_L - c173 - c204
    # generalised forces by the tip's motion
    tau_S_dot_xx = s_x*tau_S_dot_leg_11 + tau_S_dot_leg_12*y_x + tau_S_dot_leg_13*z_x
    tau_S_dot_xy = s_y*tau_S_dot_leg_11 + tau_S_dot_leg_12*y_y + tau_S_dot_leg_13*z_y
    tau_S_dot_xz = s_z*tau_S_dot_leg_11 + tau_S_dot_leg_12*y_z + tau_S_dot_leg_13*z_z
    tau_S_dot_yx = s_x*tau_S_dot_leg_21 + tau_S_dot_leg_22*y_x + tau_S_dot_leg_23*z_x
    tau_S_dot_yy = s_y*tau_S_dot_leg_21 + tau_S_dot_leg_22*y_y + tau_S_dot_leg_23*z_y
    tau_S_dot_yz = s_z*tau_S_dot_leg_21 + tau_S_dot_leg_22*y_z + tau_S_dot_leg_23*z_z
    tau_S_dot_zx = s_x*tau_S_dot_leg_31 + tau_S_dot_leg_32*y_x + tau_S_dot_leg_33*z_x
    tau_S_dot_zy = s_y*tau_S_dot_leg_31 + tau_S_dot_leg_32*y_y + tau_S_dot_leg_33*z_y
    tau_S_dot_zz = s_z*tau_S_dot_leg_31 + tau_S_dot_leg_32*y_z + tau_S_dot_leg_33*z_z
    tau_S_ddot_leg_12 = -c18
    tau_S_ddot_leg_13 = -c35
    tau_S_ddot_leg_22 = c81 + c99 - c54
    c206 = L*m_u
    tau_S_ddot_leg_23 = -c206 - c26 - c85
    c207 = h_y*k3
    tau_S_ddot_leg_31 = -c207
    tau_S_ddot_leg_32 = c165 + c170 + c171*c39 + c206*k3 - c192 - c193*c90
    tau_S_ddot_leg_33 = h_y*k1 - c172 - c98
    # generalised forces by the tip's motion
    tau_S_ddot_xx = m_u*s_x + tau_S_ddot_leg_12*y_x + tau_S_ddot_leg_13*z_x
    tau_S_ddot_xy = m_u*s_y + tau_S_ddot_leg_12*y_y + tau_S_ddot_leg_13*z_y
    tau_S_ddot_xz = m_u*s_z + tau_S_ddot_leg_12*y_z + tau_S_ddot_leg_13*z_z
    tau_S_ddot_yx = h_z*s_x + tau_S_ddot_leg_22*y_x + tau_S_ddot_leg_23*z_x
    tau_S_ddot_yy = h_z*s_y + tau_S_ddot_leg_22*y_y + tau_S_ddot_leg_23*z_y
    tau_S_ddot_yz = h_z*s_z + tau_S_ddot_leg_22*y_z + tau_S_ddot_leg_23*z_z
    tau_S_ddot_zx = s_x*tau_S_ddot_leg_31 + tau_S_ddot_leg_32*y_x + tau_S_ddot_leg_33*z_x
    tau_S_ddot_zy = s_y*tau_S_ddot_leg_31 + tau_S_ddot_leg_32*y_y + tau_S_ddot_leg_33*z_y
    tau_S_ddot_zz = s_z*tau_S_ddot_leg_31 + tau_S_ddot_leg_32*y_z + tau_S_ddot_leg_33*z_z
    X_xx = (
        B_xx*tau_S_ddot_xx + B_yx*tau_S_ddot_xy + B_zx*tau_S_ddot_xz + omega_z*tau_S_dot_xy + tau_S_xx
        - omega_y*tau_S_dot_xz
    )
    X_xy = (
        B_xy*tau_S_ddot_xx + B_yy*tau_S_ddot_xy + B_zy*tau_S_ddot_xz + omega_x*tau_S_dot_xz + tau_S_xy
        - omega_z*tau_S_dot_xx
    )
    X_xz = (
        B_xz*tau_S_ddot_xx + B_yz*tau_S_ddot_xy + B_zz*tau_S_ddot_xz + omega_y*tau_S_dot_xx + tau_S_xz
        - omega_x*tau_S_dot_xy
    )
    X_yx = (
        B_xx*tau_S_ddot_yx + B_yx*tau_S_ddot_yy + B_zx*tau_S_ddot_yz + omega_z*tau_S_dot_yy + tau_S_yx
        - omega_y*tau_S_dot_yz
    )
    X_yy = (
        B_xy*tau_S_ddot_yx + B_yy*tau_S_ddot_yy + B_zy*tau_S_ddot_yz + omega_x*tau_S_dot_yz + tau_S_yy
        - omega_z*tau_S_dot_yx
    )
    X_yz = (
        B_xz*tau_S_ddot_yx + B_yz*tau_S_ddot_yy + B_zz*tau_S_ddot_yz + omega_y*tau_S_dot_yx + tau_S_yz
        - omega_x*tau_S_dot_yy
    )
    X_zx = (
        B_xx*tau_S_ddot_zx + B_yx*tau_S_ddot_zy + B_zx*tau_S_ddot_zz + omega_z*tau_S_dot_zy + tau_S_zx
        - omega_y*tau_S_dot_zz
    )
    X_zy = (
        B_xy*tau_S_ddot_zx + B_yy*tau_S_ddot_zy + B_zy*tau_S_ddot_zz + omega_x*tau_S_dot_zz + tau_S_zy
        - omega_z*tau_S_dot_zx
    )
    X_zz = (
        B_xz*tau_S_ddot_zx + B_yz*tau_S_ddot_zy + B_zz*tau_S_ddot_zz + omega_y*tau_S_dot_zx + tau_S_zz
        - omega_x*tau_S_dot_zy
    )
    Y_xx = omega_z*tau_S_ddot_xy + tau_S_dot_xx - omega_y*tau_S_ddot_xz
    Y_xy = omega_x*tau_S_ddot_xz + tau_S_dot_xy - omega_z*tau_S_ddot_xx
    Y_xz = omega_y*tau_S_ddot_xx + tau_S_dot_xz - omega_x*tau_S_ddot_xy
    Y_yx = omega_z*tau_S_ddot_yy + tau_S_dot_yx - omega_y*tau_S_ddot_yz
    Y_yy = omega_x*tau_S_ddot_yz + tau_S_dot_yy - omega_z*tau_S_ddot_yx
    Y_yz = omega_y*tau_S_ddot_yx + tau_S_dot_yz - omega_x*tau_S_ddot_yy
    Y_zx = omega_z*tau_S_ddot_zy + tau_S_dot_zx - omega_y*tau_S_ddot_zz
    Y_zy = omega_x*tau_S_ddot_zz + tau_S_dot_zy - omega_z*tau_S_ddot_zx
    Y_zz = omega_y*tau_S_ddot_zx + tau_S_dot_zz - omega_x*tau_S_ddot_zy
    c208 = 1 - axial
    c209 = (
        axial*net_z + c208*(C_us*W_z*inv_k3 + J_xx*inv_k3*own_z + J_xy*c13*inv_k3 + J_xy*k1*own_y
        + 2*J_xz*k1*own_z + J_yz*c13*k1 + J_yz*c3*k1 + J_yz*k3*own_y + 2*L*W_z*h_z*inv_k3*theta_dot
        + L*c13*h_y*k3 + L*c3*h_y*k3 + gamma_y*k1*w_z - C_s*w_k_omega - J_xx*c184 - L*c108*c41 - L*c168
        - L*c38*k1 - L_ddot*c207 - L_dot*c138 - L_dot*c36*c53 - c13*c197 - c174*c36 - c197*c3
        - c201*theta_dot - gamma_n*w_y)
    )
    c210 = c209*inv_rho*inv_rho
    bent_leg_12 = -c210*k3
    c211 = J_xy*c62
    c212 = (
        axial*net_y + c208*(C_us*theta_dot + J_xx*c74 + J_yz*own_z + L*c104 + L*c105 + c106 + c124*c133
        + c158*k3 + c211 + c60 - C_s*w_y_omega - 2*L*c23 - L*c54*own_z - L*c83 - c147*c19*c36 - c157*w_z
        - c211*c49 - c49*c95)
    )
    c213 = c14*c212
    bent_leg_13 = c213
    c214 = inv_L*inv_rho
    c215 = c209*c214
    bent_leg_21 = -c215
    c216 = inv_rho*k3
    bent_leg_22 = c212*c214*k1 + c216*net_x
    bent_leg_23 = c215*kappa
    bent_leg_31 = c213
    bent_leg_32 = c210*k1
    bent_leg_33 = inv_L*net_x
    bent_T_xs = bent_leg_21*y_x + bent_leg_31*z_x
    bent_T_xy = bent_leg_12*s_x + bent_leg_22*y_x + bent_leg_32*z_x
    bent_T_xz = bent_leg_13*s_x + bent_leg_23*y_x + bent_leg_33*z_x
    bent_T_ys = bent_leg_21*y_y + bent_leg_31*z_y
    bent_T_yy = bent_leg_12*s_y + bent_leg_22*y_y + bent_leg_32*z_y
    bent_T_yz = bent_leg_13*s_y + bent_leg_23*y_y + bent_leg_33*z_y
    bent_T_zs = bent_leg_21*y_z + bent_leg_31*z_z
    bent_T_zy = bent_leg_12*s_z + bent_leg_22*y_z + bent_leg_32*z_z
    bent_T_zz = bent_leg_13*s_z + bent_leg_23*y_z + bent_leg_33*z_z
    # force by S as the rows turn
    bent_xx = bent_T_xs*s_x + bent_T_xy*y_x + bent_T_xz*z_x
    bent_xy = bent_T_xs*s_y + bent_T_xy*y_y + bent_T_xz*z_y
    bent_xz = bent_T_xs*s_z + bent_T_xy*y_z + bent_T_xz*z_z
    bent_yx = bent_T_ys*s_x + bent_T_yy*y_x + bent_T_yz*z_x
    bent_yy = bent_T_ys*s_y + bent_T_yy*y_y + bent_T_yz*z_y
    bent_yz = bent_T_ys*s_z + bent_T_yy*y_z + bent_T_yz*z_z
    bent_zx = bent_T_zs*s_x + bent_T_zy*y_x + bent_T_zz*z_x
    bent_zy = bent_T_zs*s_y + bent_T_zy*y_y + bent_T_zz*z_y
    bent_zz = bent_T_zs*s_z + bent_T_zy*y_z + bent_T_zz*z_z
    c217 = bent_xy*q_z
    c218 = bent_xz*q_y
    Z_xx = c218 - c217
    Z_xy = bent_xx*q_z - bent_xz*q_x
    c219 = bent_xx*q_y
    Z_xz = bent_xy*q_x - c219
    c220 = bent_yy*q_z
    Z_yx = bent_yz*q_y - c220
    c221 = bent_yx*q_z
    c222 = -bent_yz*q_x
    Z_yy = c221 + c222
    c223 = -bent_yy*q_x
    Z_yz = -bent_yx*q_y - c223
    c224 = -bent_zz*q_y
    Z_zx = -bent_zy*q_z - c224
    c225 = bent_zz*q_x
    Z_zy = bent_zx*q_z - c225
    c226 = bent_zx*q_y
    c227 = bent_zy*q_x
    Z_zz = c227 - c226
    G_dot_21 = -c87
    c228 = k1*phi_dot
    G_dot_22 = c228*inv_L
    G_dot_23 = c15
    G_dot_31 = -c216*phi_dot
    c229 = inv_rho*theta_dot
    G_dot_32 = -c2*inv_rho - c229*kappa
    G_dot_33 = c228*inv_rho
    c230 = C_s*k1
    f_S_leg_11 = G_dot_31*c230
    f_S_leg_12 = C_s*(G_dot_32*k1 - c216*theta_dot)
    f_S_leg_13 = G_dot_33*c230
    f_S_leg_21 = C_s*G_dot_21
    f_S_leg_22 = C_s*G_dot_22
    f_S_leg_23 = C_s*G_dot_23
    c231 = C_s*k3
    f_S_leg_31 = G_dot_31*c231
    f_S_leg_32 = C_s*(G_dot_32*k3 + c229*k1)
    f_S_leg_33 = G_dot_33*c231
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
    f_S_dot_leg_12 = c230*inv_rho
    f_S_dot_leg_23 = -c117
    f_S_dot_leg_32 = C_s*c216
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
    c232 = R_tip_y*q_y
    c233 = R_tip_z*q_z
    c234 = f_S_dot_xx*omega_y + f_S_xz - f_S_dot_xy*omega_x
    c235 = f_S_dot_xz*omega_x + f_S_xy - f_S_dot_xx*omega_z
    c236 = f_S_dot_xy*omega_z + f_S_xx - f_S_dot_xz*omega_y
    c237 = f_S_dot_yz*omega_x + f_S_yy - f_S_dot_yx*omega_z
    c238 = f_S_dot_yx*omega_y + f_S_yz - f_S_dot_yy*omega_x
    c239 = R_tip_x*q_x
    c240 = f_S_dot_yy*omega_z + f_S_yx - f_S_dot_yz*omega_y
    c241 = f_S_dot_zz*omega_x + f_S_zy - f_S_dot_zx*omega_z
    c242 = f_S_dot_zx*omega_y + f_S_zz - f_S_dot_zy*omega_x
    c243 = f_S_dot_zy*omega_z + f_S_zx - f_S_dot_zz*omega_y
    return {
        "M_vv_xx": 0,
        "M_vv_xy": 0,
        "M_vv_xz": 0,
        "M_vv_yy": 0,
        "M_vv_yz": 0,
        "M_vv_zz": 0,
        "M_vw_xx": 0,
        "M_vw_xy": 0,
        "M_vw_xz": 0,
        "M_vw_yx": 0,
        "M_vw_yy": 0,
        "M_vw_yz": 0,
        "M_vw_zx": 0,
        "M_vw_zy": 0,
        "M_vw_zz": 0,
        "M_ww_xx": 0,
        "M_ww_xy": 0,
        "M_ww_xz": 0,
        "M_ww_yy": 0,
        "M_ww_yz": 0,
        "M_ww_zz": 0,
        "W_ft_xx": bent_xx,
        "W_ft_xy": bent_xy,
        "W_ft_xz": bent_xz,
        "W_ft_yx": bent_yx,
        "W_ft_yy": bent_yy,
        "W_ft_yz": bent_yz,
        "W_ft_zx": bent_zx,
        "W_ft_zy": bent_zy,
        "W_ft_zz": bent_zz,
        "W_fr_xx": Z_xx,
        "W_fr_xy": Z_xy,
        "W_fr_xz": Z_xz,
        "W_fr_yx": Z_yx,
        "W_fr_yy": Z_yy,
        "W_fr_yz": Z_yz,
        "W_fr_zx": Z_zx,
        "W_fr_zy": Z_zy,
        "W_fr_zz": Z_zz,
        "W_mt_xx": c226 - c221 - f_S_xx,
        "W_mt_xy": bent_zy*q_y - c220 - f_S_xy,
        "W_mt_xz": -bent_yz*q_z - c224 - f_S_xz,
        "W_mt_yx": bent_xx*q_z - bent_zx*q_x - f_S_yx,
        "W_mt_yy": c217 - c227 - f_S_yy,
        "W_mt_yz": bent_xz*q_z - c225 - f_S_yz,
        "W_mt_zx": bent_yx*q_x - c219 - f_S_zx,
        "W_mt_zy": -bent_xy*q_y - c223 - f_S_zy,
        "W_mt_zz": -c218 - c222 - f_S_zz,
        "W_mr_xx": Z_zx*q_y + c235*q_z - Z_yx*q_z - c232 - c233 - c234*q_y,
        "W_mr_xy": R_tip_y*q_x + Z_zy*q_y + c234*q_x - Z_yy*q_z - c236*q_z,
        "W_mr_xz": R_tip_z*q_x + Z_zz*q_y + c236*q_y - Z_yz*q_z - c235*q_x,
        "W_mr_yx": R_tip_x*q_y + Z_xx*q_z + c237*q_z - Z_zx*q_x - c238*q_y,
        "W_mr_yy": Z_xy*q_z + c238*q_x - Z_zy*q_x - c233 - c239 - c240*q_z,
        "W_mr_yz": R_tip_z*q_y + Z_xz*q_z + c240*q_y - Z_zz*q_x - c237*q_x,
        "W_mr_zx": R_tip_x*q_z + Z_yx*q_x + c241*q_z - Z_xx*q_y - c242*q_y,
        "W_mr_zy": R_tip_y*q_z + Z_yy*q_x + c242*q_x - Z_xy*q_y - c243*q_z,
        "W_mr_zz": Z_yz*q_x + c243*q_y - Z_xz*q_y - c232 - c239 - c241*q_x,
        "W_fv_xx": 0,
        "W_fv_xy": 0,
        "W_fv_xz": 0,
        "W_fv_yx": 0,
        "W_fv_yy": 0,
        "W_fv_yz": 0,
        "W_fv_zx": 0,
        "W_fv_zy": 0,
        "W_fv_zz": 0,
        "W_fw_xx": 0,
        "W_fw_xy": 0,
        "W_fw_xz": 0,
        "W_fw_yx": 0,
        "W_fw_yy": 0,
        "W_fw_yz": 0,
        "W_fw_zx": 0,
        "W_fw_zy": 0,
        "W_fw_zz": 0,
        "W_mv_xx": -f_S_dot_xx,
        "W_mv_xy": -f_S_dot_xy,
        "W_mv_xz": -f_S_dot_xz,
        "W_mv_yx": -f_S_dot_yx,
        "W_mv_yy": -f_S_dot_yy,
        "W_mv_yz": -f_S_dot_yz,
        "W_mv_zx": -f_S_dot_zx,
        "W_mv_zy": -f_S_dot_zy,
        "W_mv_zz": -f_S_dot_zz,
        "W_mw_xx": f_S_dot_xy*q_z - f_S_dot_xz*q_y,
        "W_mw_xy": f_S_dot_xz*q_x - f_S_dot_xx*q_z,
        "W_mw_xz": f_S_dot_xx*q_y - f_S_dot_xy*q_x,
        "W_mw_yx": f_S_dot_yy*q_z - f_S_dot_yz*q_y,
        "W_mw_yy": f_S_dot_yz*q_x - f_S_dot_yx*q_z,
        "W_mw_yz": f_S_dot_yx*q_y - f_S_dot_yy*q_x,
        "W_mw_zx": f_S_dot_zy*q_z - f_S_dot_zz*q_y,
        "W_mw_zy": f_S_dot_zz*q_x - f_S_dot_zx*q_z,
        "W_mw_zz": f_S_dot_zx*q_y - f_S_dot_zy*q_x,
        "tau_t_xx": tau_S_xx,
        "tau_t_xy": tau_S_xy,
        "tau_t_xz": tau_S_xz,
        "tau_t_yx": tau_S_yx,
        "tau_t_yy": tau_S_yy,
        "tau_t_yz": tau_S_yz,
        "tau_t_zx": tau_S_zx,
        "tau_t_zy": tau_S_zy,
        "tau_t_zz": tau_S_zz,
        "tau_r_xx": X_xz*q_y - X_xy*q_z,
        "tau_r_xy": X_xx*q_z - X_xz*q_x,
        "tau_r_xz": X_xy*q_x - X_xx*q_y,
        "tau_r_yx": X_yz*q_y - X_yy*q_z,
        "tau_r_yy": X_yx*q_z - X_yz*q_x,
        "tau_r_yz": X_yy*q_x - X_yx*q_y,
        "tau_r_zx": X_zz*q_y - X_zy*q_z,
        "tau_r_zy": X_zx*q_z - X_zz*q_x,
        "tau_r_zz": X_zy*q_x - X_zx*q_y,
        "tau_v_xx": tau_S_dot_xx,
        "tau_v_xy": tau_S_dot_xy,
        "tau_v_xz": tau_S_dot_xz,
        "tau_v_yx": tau_S_dot_yx,
        "tau_v_yy": tau_S_dot_yy,
        "tau_v_yz": tau_S_dot_yz,
        "tau_v_zx": tau_S_dot_zx,
        "tau_v_zy": tau_S_dot_zy,
        "tau_v_zz": tau_S_dot_zz,
        "tau_w_xx": Y_xz*q_y + tau_S_ddot_xz*w_q_y - Y_xy*q_z - tau_S_ddot_xy*w_q_z,
        "tau_w_xy": Y_xx*q_z + tau_S_ddot_xx*w_q_z - Y_xz*q_x - tau_S_ddot_xz*w_q_x,
        "tau_w_xz": Y_xy*q_x + tau_S_ddot_xy*w_q_x - Y_xx*q_y - tau_S_ddot_xx*w_q_y,
        "tau_w_yx": Y_yz*q_y + tau_S_ddot_yz*w_q_y - C_s*y_x - Y_yy*q_z - tau_S_ddot_yy*w_q_z,
        "tau_w_yy": Y_yx*q_z + tau_S_ddot_yx*w_q_z - C_s*y_y - Y_yz*q_x - tau_S_ddot_yz*w_q_x,
        "tau_w_yz": Y_yy*q_x + tau_S_ddot_yy*w_q_x - C_s*y_z - Y_yx*q_y - tau_S_ddot_yx*w_q_y,
        "tau_w_zx": Y_zz*q_y + tau_S_ddot_zz*w_q_y - C_s*k_x - Y_zy*q_z - tau_S_ddot_zy*w_q_z,
        "tau_w_zy": Y_zx*q_z + tau_S_ddot_zx*w_q_z - C_s*k_y - Y_zz*q_x - tau_S_ddot_zz*w_q_x,
        "tau_w_zz": Y_zy*q_x + tau_S_ddot_zy*w_q_x - C_s*k_z - Y_zx*q_y - tau_S_ddot_zx*w_q_y,
        "H_force_x": s_x,
        "H_force_y": s_y,
        "H_force_z": s_z,
        "H_moment_x": q_y*s_z - q_z*s_y,
        "H_moment_y": q_z*s_x - q_x*s_z,
        "H_moment_z": q_x*s_y - q_y*s_x,
        "q_x": q_x,
        "q_y": q_y,
        "q_z": q_z,
        "L": L,
        "k3": k3,
    }


_PARTS = {
    "equations": (equations_of_platform, equations_of_leg),
    "bias": (bias_of_platform, bias_of_leg),
    "forward_dynamics": (forward_of_platform, forward_of_leg),
    "derivatives": (derivatives_of_platform, derivatives_of_leg),
    "joint_rows": (joint_rows_of_platform, joint_rows_of_leg),
    "joint_slopes": (joint_slopes_of_platform, joint_slopes_of_leg),
}
# Legs' blocks for poses in which a leg is near its joint singularity.
_NEAR = {
    "equations": equations_of_leg_near,
    "derivatives": derivatives_of_leg_near,
}
