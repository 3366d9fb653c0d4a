"""Blocks and kernels at 50 digits."""

import functools

import numpy as np
from mpmath import mp
from numpy.typing import NDArray

from stewart_sym.derive.mechanics.formulation import Formulation
from stewart_sym.derive.mechanics.inverse_dynamics import kernel
from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot

DIGITS = 50
derived = functools.cache(kernel)


def named(name: str, array: NDArray[np.float64]) -> dict[str, mp.mpf]:
    """Entries of a scalar, vector or matrix under the names of the blocks."""
    return {
        name + ("_" + "".join("xyz"[i] for i in key) if key else ""): mp.mpf(float(array[key]))
        for key in np.ndindex(array.shape)
    }


def block_inputs(robot: Robot, motion: Motion, leg: int) -> dict[str, mp.mpf]:
    values: dict[str, mp.mpf] = {}
    of_leg = ("b", "p", "k", "m_d", "r_d0", "I_d0", "m_u", "r_u0", "I_u0", "C_u", "C_p", "C_s", "m_r", "j_r")
    for name in of_leg:
        values |= named(name, np.asarray(getattr(robot, name)[leg]))
    for name in ("M", "R_0", "I_p", "g"):
        values |= named(name, np.asarray(getattr(robot, name)))
    for name in ("R", "t", "omega", "v", "alpha", "a", "F_ext", "M_ext"):
        values |= named(name, getattr(motion, name))
    return values


def truth(
    form: Formulation, robot: Robot, motion: Motion, raw: list[dict[str, mp.mpf]] | None = None
) -> dict[str, mp.matrix]:
    """D, K, H, c, x, F from the blocks as they were derived, without sharing, at 50 digits.

    raw: the inputs of each leg; None for those of the robot and the motion.
    """
    blocks = derived(form)
    raw = raw or [block_inputs(robot, motion, i) for i in range(6)]
    own = blocks.platform.run(raw[0], mp.sqrt)
    c = mp.matrix([*own["c_force"], *own["c_moment"]])
    D, K, H = mp.matrix(6, 1), mp.matrix(6, 3), mp.matrix(6, 6)
    for i in range(6):
        leg = blocks.leg.run(raw[i], mp.sqrt)
        D[i] = leg["D"][0]
        c += mp.matrix([*leg["c_force"], *leg["c_moment"]])
        for j in range(3):
            K[i, j] = leg["K"][j]
            H[j, i], H[j + 3, i] = leg["H_force"][j], leg["H_moment"][j]
    x = mp.lu_solve(H, c)
    return {"D": D, "K": K, "H": H, "c": c, "x": x, "F": D - x}
