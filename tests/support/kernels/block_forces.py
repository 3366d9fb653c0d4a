"""Blocks of the force kernels evaluated by name."""

from fifty_digits import block_inputs, named
from mpmath import mp

from stewart_sym.derive.mechanics.actuator_forces import ForceKernel
from stewart_sym.derive.mechanics.lumped_constants import ADDED
from stewart_sym.derive.program.block import Block
from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot


def by_name(block: Block, outputs: dict[str, tuple]) -> dict[str, mp.mpf]:
    """The outputs of a block under the names of their components."""
    return {
        name: value
        for out in block.outputs
        for name, value in zip(out.quantity.names, outputs[out.quantity.name], strict=True)
    }


def forces(kernel: ForceKernel, robot: Robot, motion: Motion) -> mp.matrix:
    """F from the regrouped blocks, in the working precision."""
    kernel = kernel.whole()
    first = named("p_1", robot.p[0])
    raw = [block_inputs(robot, motion, leg) | first for leg in range(6)]
    legs = [by_name(kernel.prepare_leg, kernel.prepare_leg.run(values, mp.sqrt)) for values in raw]
    added = {name: sum(leg[name] for leg in legs) for quantity in ADDED for name in quantity.names}
    platform = by_name(kernel.prepare_platform, kernel.prepare_platform.run(raw[0] | added, mp.sqrt))
    shared = kernel.shared.run(raw[0] | platform, mp.sqrt)
    turn = by_name(kernel.shared, shared)
    nothing = {"D": (0,), "c_force": (0,) * 3, "c_moment": (0,) * 3, "arm_c": (0,) * 3}
    c = mp.matrix([*shared["c_force"], *shared["c_tip"]])
    D, H = mp.matrix(6, 1), mp.matrix(6, 6)
    for i, leg in enumerate(legs):
        found = nothing | kernel.leg.run(raw[i] | turn | leg, mp.sqrt)
        D[i] = found["D"][0]
        c += mp.matrix([*found["c_force"], *found["c_moment"]])
        c += mp.matrix([0, 0, 0, *found["arm_c"]])
        for j in range(3):
            H[j, i], H[j + 3, i] = found["H_force"][j], found["H_moment"][j]
    return D - mp.lu_solve(H, c)
