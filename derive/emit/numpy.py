"""NumPy Python: kernels vectorised over poses and legs, one module for each formulation.

The same blocks and the same order of operations as the C; the leg index is the last axis of every leg scalar,
so one straight-line program serves all six legs of all poses. Knows nothing of files.
"""

from .. import notation as n
from ..block import Block, Output, Quantity, Step
from ..kernel.prepare import ABOUT_REFERENCE
from ..kernels import Kernel
from ..operations import KernelOperations
from .c import operations_table
from .infix import WIDTH, infix, wrap


def module(
    kernel: Kernel,
    counts: tuple[KernelOperations, KernelOperations],
    force_counts: tuple[KernelOperations, KernelOperations],
    version: str,
) -> str:
    """``<kernel>.py``: the blocks as functions, and inverse dynamics and joint reactions made of them.

    counts, force_counts: operations with and without friction, of this kernel and of the regrouped one.
    """
    name = kernel.formulation.kernel_name
    return _MODULE.format(
        name=name,
        version=version,
        operations=operations_table(*counts, ""),
        table=_operations_literal("OPERATIONS", *counts),
        force_table=_operations_literal("FORCE_OPERATIONS", *force_counts),
        leg=block_function(kernel.leg, legs=True),
        platform=block_function(kernel.platform, legs=False),
        reactions=block_function(kernel.reactions, legs=True),
    )


def assembly(version: str) -> str:
    """``assembly.py``: what every kernel shares."""
    smallest, largest = ABOUT_REFERENCE
    return _ASSEMBLY.format(version=version, smallest=smallest, largest=largest)


def _operations_literal(name: str, with_friction: KernelOperations, frictionless: KernelOperations) -> str:
    lines = [f"{name}: dict[str, dict[str, tuple[int, int, int, int]]] = {{"]
    for label, counts in (("friction", with_friction), ("frictionless", frictionless)):
        lines.append(f'    "{label}": {{')
        for part, count in counts.parts().items():
            lines.append(f'        "{part}": ({count.mul}, {count.add}, {count.div}, {count.sqrt}),')
        lines.append("    },")
    return "\n".join([*lines, "}"])


def block_function(block: Block, legs: bool) -> str:
    """A block as a function of arrays; ``legs``: its scalars carry the leg index as last axis."""
    used = {symbol.name for expr in block.expressions() for symbol in expr.free_symbols}
    extra = "".join(f", {q.name}: Array" for q in block.inputs if q in (n.x, n.bearing))
    owners = [("robot", n.LEG + n.PLATFORM), ("motion", n.MOTION)]
    loads = [
        line
        for quantity in block.inputs
        for owner, group in owners
        if quantity in group
        for line in _load(quantity, owner, used, legs)
    ]
    outputs = [line for out in block.outputs for line in _output(out)]
    shape = "(*motion.t.shape[:-1], 6)" if legs else "motion.t.shape[:-1]"
    return "\n".join(
        [
            f"def {block.name}(robot: Any, motion: Any{extra}) -> dict[str, Array]:",
            f'    """{block.meaning[0].upper()}{block.meaning[1:]}.',
            "",
            f"    Operations: {block.operations()}.",
            '    """',
            *loads,
            *step_lines(block.steps),
            f"    shape = {shape}",
            "    return {",
            *outputs,
            "    }",
        ]
    )


def _load(quantity: Quantity, owner: str, used: set[str], legs: bool) -> list[str]:
    per_leg = quantity in n.LEG
    lines = []
    for key, name in zip(quantity.keys, quantity.names, strict=True):
        if name not in used:
            continue
        index = [":"] if per_leg else ["..."] if owner == "motion" else []
        index += [str(i) for i in key]
        if owner == "motion" and legs:
            index.append("None")
        where = f"[{', '.join(index)}]" if quantity.shape else ""
        lines.append(f"    {name} = {owner}.{quantity.name}{where}")
    return lines


def step_lines(steps: tuple[Step, ...]) -> list[str]:
    """Each step as an assignment, with equation and meaning before the first of a run that shares them."""
    return [line for step, before in zip(steps, (None, *steps), strict=False) for line in _step(step, before)]


def _step(step: Step, before: Step | None) -> list[str]:
    lines = [wrapped(f"    {step.name} = ", infix(step.expr, "np.sqrt"))]
    said = (step.equation, step.meaning)
    if any(said) and (before is None or said != (before.equation, before.meaning)):
        lines.insert(0, f"    # {' '.join(part for part in said if part)}")
    return lines


def wrapped(left: str, text: str) -> str:
    """An assignment, in parentheses when it needs more than one line."""
    if len(left) + len(text) <= WIDTH:
        return left + text
    return f"{left}(\n{wrap(' ' * 8 + text, ' ' * 8)}\n    )"


def _output(out: Output) -> list[str]:
    name = out.quantity.name
    parts = [infix(expr, "np.sqrt") for expr in out.exprs]
    if not out.quantity.shape:
        return [f'        "{name}": np.broadcast_to({parts[0]}, shape),']
    line = f'        "{name}": stack(shape, {", ".join(parts)}),'
    if len(line) <= WIDTH:
        return [line]
    return [
        f'        "{name}": stack(',
        *(f"            {part}," for part in ("shape", *parts)),
        "        ),",
    ]


_MODULE = '''\
"""Inverse dynamics and joint reactions of the Stewart platform, formulation and joint `{name}`.

Written by stewart-sym {version}; do not edit.
SPDX-License-Identifier: 0BSD

``robot`` has the fields of ``stewart_robot`` in stewart.h as arrays, legs first: b (6, 3), I_d0 (6, 3, 3).
``motion`` has R (..., 3, 3), t, omega, v, alpha, a, F_ext, M_ext (..., 3). Units as in stewart.h.

{operations}
"""

from typing import Any

import numpy as np

from .assembly import Array, solve, stack

# (mul, add, div, sqrt) of each part of one pose, and of all.
{table}

# The same of stewart_{name}_forces.h.
{force_table}


def inverse_dynamics(robot: Any, motion: Any) -> dict[str, Array]:
    """F, D, x, c (..., 6), K (..., 6, 3), H (..., 6, 6) and status (...), (1)-(37)."""
    with np.errstate(all="ignore"):
        return solve(robot, motion, leg_dynamics(robot, motion), platform_wrench(robot, motion))


def joint_reactions(robot: Any, motion: Any, x: Array, bearing: Array) -> dict[str, Array]:
    """F_s, F_u, F_p, F_c, M_p (..., 6, 3) and M_u (..., 6) from x (..., 6); bearing (6,), m."""
    with np.errstate(all="ignore"):
        return leg_reactions(robot, motion, x, bearing)


{leg}


{platform}


{reactions}
'''

_ASSEMBLY = '''\
"""What every NumPy kernel shares: stacking components, assembling H x = c, solving it, status.

Written by stewart-sym {version}; do not edit.
SPDX-License-Identifier: 0BSD
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]

OK, NOT_FINITE, SHORT_LEG, POLE, SINGULAR = range(5)

# A length or sine below this many rounding units of its terms is rounding error and nothing else.
ROUNDING = 16 * np.finfo(np.float64).eps
# Sine of the angle between a leg and the fixed axis below which rounding decides where the leg's second axis
# points: the pole of the universal joint.
POLE_SINE = 4096 * np.finfo(np.float64).eps
# Pivot below which H, its moments over a length, may be singular to rounding.
SUSPECT = np.sqrt(np.sqrt(np.finfo(np.float64).eps))
# Below this share of the vectors that it is the sum of, a leg may make H singular while the pivots are large.
SHORT_SHARE = 64 * np.sqrt(np.finfo(np.float64).eps)
# A leg shorter than this has a square that is not held to all its digits.
SHORTEST = np.sqrt(1 / np.finfo(np.float64).max / np.finfo(np.float64).eps)


def stack(shape: tuple[int, ...], *components: Any) -> Array:
    """Components side by side in a new last axis."""
    return np.stack([np.broadcast_to(component, shape) for component in components], axis=-1)


def solve(robot: Any, motion: Any, leg: dict[str, Array], platform: dict[str, Array]) -> dict[str, Array]:
    """H x = c and F = D - x, (35)-(37); poses with a status other than 0 are NaN."""
    H = np.concatenate([leg["H_force"], leg["H_moment"]], axis=-1).swapaxes(-1, -2)
    c = np.concatenate([platform["c_force"], platform["c_moment"]], axis=-1)
    of_legs = np.concatenate([leg["c_force"], leg["c_moment"]], axis=-1)
    for i in range(6):
        c = c + of_legs[..., i, :]
    q = leg["q"]
    x, suspect = eliminate(*over_length(np.abs(q).max(axis=(-1, -2)), H, c))
    F = leg["D"] - x
    reach = np.abs(np.broadcast_arrays(q, motion.t[..., None, :], robot.b)).max(axis=(0, -1))
    status = singular_status(H, suspect, leg["L"], reach, q)
    status = np.where(np.isfinite(F).all(axis=-1) | (status != OK), status, NOT_FINITE)
    fault = leg_status(robot, motion, leg)
    status = np.where(fault == OK, status, fault).astype(np.int32)
    found = {{"F": F, "D": leg["D"], "x": x, "K": leg["K"], "H": H, "c": c}}
    return {{**{{name: only_good(value, status) for name, value in found.items()}}, "status": status}}


def only_good(values: Array, status: Array) -> Array:
    """``values`` (..., more axes) with NaN where ``status`` (...) is not 0."""
    return np.where((status == OK)[(..., *(None,) * (values.ndim - status.ndim))], values, np.nan)


def eliminate(H: Array, c: Array) -> tuple[Array, Array]:
    """x (..., 6) of H x = c by elimination with partial pivoting, and whether a pivot is small (...)."""
    A = np.concatenate([H, c[..., None]], axis=-1)
    suspect = np.zeros(H.shape[:-2], dtype=bool)
    for k in range(6):
        pivot = k + np.argmax(np.abs(A[..., k:, k]), axis=-1)[..., None]
        order = np.broadcast_to(np.arange(6), (*suspect.shape, 6)).copy()
        np.put_along_axis(order, pivot, k, axis=-1)
        order[..., k] = pivot[..., 0]
        A = np.take_along_axis(A, order[..., None], axis=-2)
        suspect |= ~(np.abs(A[..., k, k]) > SUSPECT)
        factor = A[..., k + 1 :, k] * (1 / A[..., k, k])[..., None]
        A[..., k + 1 :, k + 1 :] -= factor[..., None] * A[..., k, None, k + 1 :]
    x = np.empty_like(c)
    for i in range(5, -1, -1):
        total = A[..., i, 6]
        for j in range(i + 1, 6):
            total = total - A[..., i, j] * x[..., j]
        x[..., i] = total * (1 / A[..., i, i])
    return x, suspect


def per_length(size: Any) -> Any:
    """What moments are multiplied by in the solve, 1/m; ``size``: m, largest coordinate of their arms.

    1 for sizes of about a metre, else one over the least power of two, 2^-100 to 2^100, that is as large.
    """
    fraction, exponent = np.frexp(size)
    power = np.ldexp(1.0, np.clip((fraction == 0.5) - exponent, -100, 100))
    return np.where((size >= {smallest}) & (size <= {largest}) | (size == 0.0), 1.0, power)


def over_length(size: Any, H: Array, right: Array) -> tuple[Array, Array]:
    """H (..., 6, 6) and right (..., 6) or (..., 6, n), moments over a length that suits ``size``: pivots are
    chosen among forces and moments.
    """
    factor = np.where(np.arange(6) < 3, 1.0, np.asarray(per_length(size))[..., None])
    return H * factor[..., None], right * (factor if right.ndim < H.ndim else factor[..., None])


def eliminate_many(H: Array, right: Array) -> tuple[Array, Array]:
    """X (..., 6, n) of H X = right, column by column, and whether a pivot is small (...)."""
    solved = [eliminate(H, right[..., j]) for j in range(right.shape[-1])]
    return np.stack([x for x, _ in solved], axis=-1), solved[0][1]


def singular_status(H: Array, suspect: Array, L: Array, reach: Array, arm: Array) -> Array:
    """OK, SINGULAR or NOT_FINITE of every pose: whether H (..., 6, 6) is singular to rounding.

    suspect: whether a pivot is small (...). L, reach (..., 6): length of each leg, size of the vectors that
    it is the sum of; arm (..., 6, 3): of its moment. As ``singular_status`` of the C, where the bound is
    explained.
    """
    size = np.abs(arm).max(axis=(-1, -2))
    close = suspect | (L <= SHORT_SHARE * reach).any(axis=-1)
    status = np.zeros(suspect.shape, dtype=np.int32)
    if close.any():
        status[close] = _status_of_close(H[close], L[close], reach[close], arm[close], size[close, None])
    return status


def _status_of_close(H: Array, L: Array, reach: Array, arm: Array, size: Array) -> Array:
    scaled = H / np.where(np.arange(6) < 3, 1.0, size)[..., None]
    Y, _ = eliminate_many(scaled, np.broadcast_to(np.eye(6), H.shape))
    turned = Y[..., None, :3] + np.cross(Y[..., None, 3:], (arm / size[..., None])[..., None, :, :])
    G = np.abs(turned).sum(axis=-1) * (reach / L + 2)[..., None, :]
    G = (G + 2 * np.abs(Y[..., 3:]).sum(axis=-1)[..., None]) * 4 * np.finfo(np.float64).eps
    v, worst = np.ones(L.shape), np.full(L.shape[:-1], np.inf)
    for _ in range(4):
        grown = (G * v[..., None, :]).sum(axis=-1)
        worst = np.minimum(worst, (grown / v).max(axis=-1))
        v = np.maximum(grown / grown.max(axis=-1, keepdims=True), np.finfo(np.float64).eps)
    status = np.where(worst <= 0.5, OK, SINGULAR)
    return np.where(np.isfinite(H).all(axis=(-1, -2)), status, NOT_FINITE)


def leg_status(robot: Any, motion: Any, leg: dict[str, Array]) -> Array:
    """The first leg's fault of each pose: not finite, too short, along its universal axis.

    S = q + t - b is known to within rounding of its largest term.
    """
    terms = np.broadcast_arrays(leg["q"], motion.t[..., None, :], robot.b)
    L, reach = leg["L"], np.abs(terms).max(axis=(0, -1))
    clear = leg["k3"] > POLE_SINE if "k3" in leg else np.full(L.shape, True)
    fault = np.where(clear, 0, POLE)
    fault = np.where(L > np.maximum(ROUNDING * reach, SHORTEST), fault, SHORT_LEG)
    fault = np.where(np.isfinite(L), fault, NOT_FINITE)
    first = np.argmax(fault != OK, axis=-1)
    return np.take_along_axis(fault, first[..., None], axis=-1)[..., 0]
'''
