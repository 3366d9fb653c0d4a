"""NumPy Python of the closed form: the same blocks as ``motion`` emits in C, vectorised over poses and legs.

Scalars are arrays by component name; those of a leg have the leg as last axis. Knows no files.
"""

from collections.abc import Callable

from .. import notation as n
from ..block import Block, Quantity, component_name
from ..motion import AXIAL, F_LEG, NET, TURNED, SumKernel
from ..prepared import ADDED
from ..regroup import ForceKernel
from .infix import WIDTH, infix, wrap
from .lane_text import names_used
from .motion import sum_operations
from .numpy import step_lines
from .numpy_joint_rows import JOINT_ROWS

Load = Callable[[Quantity, tuple[int, ...], str], str]


def module(kernels: tuple[SumKernel, ...], model: ForceKernel, version: str) -> str:
    """``<kernel>_motion.py``."""
    name = model.formulation.kernel_name
    blocks = [
        _function(model.prepare_leg, "robot", _of_leg),
        _function(model.prepare_platform, "robot, added", _of_platform),
    ]
    for kernel in kernels:
        blocks += [
            _function(kernel.pose, "platform, motion", _of_pose),
            *(
                _function(leg, "leg, platform, pose, motion, F", _in_lanes(kernel, model))
                for leg in (kernel.leg, kernel.near)
                if leg is not None
            ),
        ]
    parts = {
        "@NAME@": name,
        "@VERSION@": version,
        "@ADDED@": wrap_names("_ADDED = (" + ", ".join(f'"{c}"' for q in ADDED for c in q.names) + ")"),
        "@SUMMED@": "\n".join(_summed(kernel) for kernel in kernels),
        "@OPERATIONS@": "\n".join(f'    "{k.name}": {sum_operations(k).total},' for k in kernels),
        "@JOINT_ROWS@": JOINT_ROWS,
        "@NEAR@": "\n".join(f'    "{k.name}": {k.near.name},' for k in kernels if k.near is not None),
        "@BLOCKS@": "\n\n\n".join(blocks),
    }
    text = _MODULE
    for mark, value in parts.items():
        text = text.replace(mark, value)
    return text


def _summed(kernel: SumKernel) -> str:
    names = ", ".join(f'"{component}"' for q in kernel.summed for component in q.names)
    return wrap_names(f'    "{kernel.name}": ({names}),')


def wrap_names(text: str) -> str:
    """Break a long tuple of names after a comma."""
    lines, line = [], ""
    for word in text.split(", "):
        if line and len(line) + len(word) > WIDTH - 4:
            lines.append(line + ",")
            line = " " * 8 + word
        else:
            line = f"{line}, {word}" if line else word
    return "\n".join([*lines, line])


def _index(key: tuple[int, ...]) -> str:
    return "".join(f", {i}" for i in key)


def _of_leg(quantity: Quantity, key: tuple[int, ...], _: str) -> str:
    if quantity in n.LEG:
        return f"robot.{quantity.name}[:{_index(key)}]" if key else f"robot.{quantity.name}"
    return f"robot.{quantity.name}[{key[0]}]"


def _of_platform(quantity: Quantity, key: tuple[int, ...], name: str) -> str:
    if quantity in ADDED:
        return f'added["{name}"]'
    return f"robot.{quantity.name}[{', '.join(map(str, key))}]" if key else f"robot.{quantity.name}"


def _of_pose(quantity: Quantity, key: tuple[int, ...], name: str) -> str:
    if quantity in n.MOTION:
        return f"motion.{quantity.name}[...{_index(key)}]"
    return f'platform["{name}"]'


def _in_lanes(kernel: SumKernel, model: ForceKernel) -> Load:
    given = {out.quantity for out in kernel.pose.outputs}

    def load(quantity: Quantity, key: tuple[int, ...], name: str) -> str:
        if quantity == F_LEG:
            return "F"
        if quantity in (NET, TURNED):
            return f"motion.{quantity.name}[..., {key[0]}]"
        if quantity == AXIAL:
            return f"motion.{quantity.name}"
        if quantity in n.MOTION:
            return f"motion.{quantity.name}[...{_index(key)}, None]"
        if quantity in given:
            return f'pose["{name}"][..., None]'
        return f'leg["{name}"]' if quantity in model.leg_constants() else f'platform["{name}"]'

    return load


def _function(block: Block, arguments: str, load: Load) -> str:
    """A block as a function that hands out its components by name."""
    used = names_used(block)
    loads = [
        f"    {name} = {load(q, key, name)}"
        for q in block.inputs
        for key, name in zip(q.keys, q.names, strict=True)
        if name in used
    ]
    outputs = [
        _item(component_name(out.quantity.name, key), infix(expr, "np.sqrt"))
        for out in block.outputs
        for key, expr in zip(out.quantity.keys, out.exprs, strict=True)
    ]
    typed = ", ".join(f"{name}: Any" for name in arguments.split(", "))
    return "\n".join(
        [
            f"def {block.name}({typed}) -> dict[str, Any]:",
            f'    """{block.meaning[0].upper()}{block.meaning[1:]}.',
            "",
            f"    Operations: {block.operations()}.",
            '    """',
            *loads,
            *step_lines(block.steps),
            "    return {",
            *outputs,
            "    }",
        ]
    )


def _item(name: str, text: str) -> str:
    line = f'        "{name}": {text},'
    if len(line) <= WIDTH:
        return line
    return f'        "{name}": (\n{wrap(" " * 12 + text, " " * 12)}\n        ),'


_MODULE = '''\
"""Closed form of the Stewart platform's equations of motion, formulation and joint `@NAME@`.

Written by stewart-sym @VERSION@; do not edit.
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
@OPERATIONS@
}

@ADDED@
_SUMMED: dict[str, tuple[str, ...]] = {
@SUMMED@
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


@JOINT_ROWS@def _good(found: dict[str, Array], status: Array) -> dict[str, Array]:
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


@BLOCKS@


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
@NEAR@
}
'''
