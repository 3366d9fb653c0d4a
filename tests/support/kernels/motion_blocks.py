"""Blocks of the closed form, numeric and symbolic."""

import functools

import numpy as np
from block_forces import by_name
from fifty_digits import DIGITS, block_inputs, named
from machines import random_motion, random_robot
from mpmath import mp
from numpy.typing import NDArray

from stewart_sym.derive.mechanics.closed_form import kernels
from stewart_sym.derive.mechanics.closed_form.terms import SumKernel
from stewart_sym.derive.mechanics.lumped_constants import ADDED, Lumped, prepare_leg, prepare_platform
from stewart_sym.derive.mechanics.regressor import regressor
from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot

STEP = mp.mpf(10) ** -15
Values = dict[str, mp.mpf]


@functools.cache
def symbolic() -> dict[str, SumKernel]:
    """The kernels of the closed form by name, before sharing."""
    return {kernel.name: kernel for kernel in kernels()}


@functools.cache
def preparation() -> tuple:
    """Blocks that prepare every constant that some kernel reads."""
    every = symbolic().values()
    of_leg = dict.fromkeys(q for kernel in every for q in kernel.leg.inputs)
    of_platform = dict.fromkeys(q for kernel in every for q in kernel.pose.inputs)
    return prepare_leg(of_leg, Lumped(mass=True, friction=True)), prepare_platform(of_platform)


def summed(kernel: SumKernel, raw: list[Values], F: list[mp.mpf]) -> dict[str, mp.matrix]:
    """Sums of a kernel over the machine as matrices by name, and H and its rate where they are handed out."""
    leg_block, platform_block = preparation()
    legs = [by_name(leg_block, leg_block.run(values, mp.sqrt)) for values in raw]
    added = {name: sum(leg[name] for leg in legs) for q in ADDED for name in q.names}
    platform = by_name(platform_block, platform_block.run(raw[0] | added, mp.sqrt))
    pose = by_name(kernel.pose, kernel.pose.run(raw[0] | platform, mp.sqrt))
    total = {name: pose[name] for q in kernel.summed for name in q.names}
    columns = []
    for values, leg, force in zip(raw, legs, F, strict=True):
        found = kernel.leg.run(values | leg | pose | {"F": force}, mp.sqrt)
        parts = by_name(kernel.leg, found)
        for name in total:
            total[name] += parts[name]
        columns.append(found)
    result = {q.name: filled(q, total) for q in kernel.summed}
    for name in ("H", "H_dot"):
        if f"{name}_force" in columns[0]:
            rows = [[*leg[f"{name}_force"], *leg[f"{name}_moment"]] for leg in columns]
            result[name] = mp.matrix(rows).T
    return result


def filled(quantity, values: Values) -> mp.matrix:
    """A vector or a matrix from its components, the symmetric ones twice."""
    if len(quantity.shape) == 1:
        return mp.matrix([values[name] for name in quantity.names])
    table = dict(zip(quantity.keys, quantity.names, strict=True))

    def entry(i: int, j: int) -> mp.mpf:
        return values[table[(min(i, j), max(i, j)) if quantity.symmetric else (i, j)]]

    return mp.matrix([[entry(i, j) for j in range(3)] for i in range(3)])


def blocks(a: mp.matrix, b: mp.matrix, c: mp.matrix, d: mp.matrix) -> mp.matrix:
    """[[a, b], [c, d]]."""
    whole = mp.matrix(6, 6)
    whole[:3, :3], whole[:3, 3:], whole[3:, :3], whole[3:, 3:] = a, b, c, d
    return whole


def stacked(a: mp.matrix, b: mp.matrix) -> mp.matrix:
    """[a; b]."""
    return mp.matrix([*a, *b])


def inertia(found: dict[str, mp.matrix]) -> mp.matrix:
    """M, 6x6."""
    return blocks(found["M_vv"], found["M_vw"], found["M_vw"].T, found["M_ww"])


def inputs(robot: Robot, motion: Motion) -> list[Values]:
    first = named("b_1", robot.b[0]) | named("p_1", robot.p[0])
    return [block_inputs(robot, motion, leg) | first for leg in range(6)]


def vector(values: Values, *names: str) -> mp.matrix:
    return mp.matrix([values[f"{name}_{axis}"] for name in names for axis in "xyz"])


def rotation(w: mp.matrix) -> mp.matrix:
    return mp.expm(mp.matrix([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]]))


def moved(raw: list[Values], pose: mp.matrix, twist: mp.matrix, acceleration: mp.matrix) -> list[Values]:
    """The motion with [dt; dphi], [dv; domega] and [da; dalpha] added, R turned in the base frame."""
    first = raw[0]
    R = mp.matrix([[first[f"R_{i}{j}"] for j in "xyz"] for i in "xyz"])
    turned = rotation(pose[3:]) * R
    change = {f"R_{i}{j}": turned[m, k] for m, i in enumerate("xyz") for k, j in enumerate("xyz")}
    parts = (("t", pose[:3]), ("v", twist[:3]), ("omega", twist[3:]), ("a", acceleration[:3]))
    for name, difference in (*parts, ("alpha", acceleration[3:])):
        change |= {f"{name}_{axis}": first[f"{name}_{axis}"] + difference[i] for i, axis in enumerate("xyz")}
    return [values | change for values in raw]


def case(seed: int) -> tuple[Robot, Motion, list[Values]]:
    rng = np.random.default_rng(seed)
    robot = random_robot(rng)
    motion = random_motion(rng, robot)
    raw = inputs(robot, motion)
    # R and k are orthonormal to double rounding only; here they must be so to 50 digits.
    with mp.workdps(DIGITS):
        R = mp.matrix([[raw[0][f"R_{i}{j}"] for j in "xyz"] for i in "xyz"])
        for _ in range(6):
            R = R * (3 * mp.eye(3) - R.T * R) / 2
        fixed = {f"R_{i}{j}": R[m, n] for m, i in enumerate("xyz") for n, j in enumerate("xyz")}
        for values in raw:
            k = vector(values, "k")
            values |= fixed | {f"k_{axis}": k[i] / mp.norm(k) for i, axis in enumerate("xyz")}
    return robot, motion, raw


def nothing() -> mp.matrix:
    return mp.zeros(6, 1)


def unit(i: int) -> mp.matrix:
    found = nothing()
    found[i] = STEP
    return found


def load(values: Values) -> mp.matrix:
    R = mp.matrix([[values[f"R_{i}{j}"] for j in "xyz"] for i in "xyz"])
    return stacked(R * vector(values, "F_ext"), R * vector(values, "M_ext"))


Column = mp.matrix
derived = functools.cache(regressor)


def columns(raw: list[dict[str, mp.mpf]]) -> tuple[list[dict[str, Column]], dict[str, Column]]:
    """Columns by parameter of each leg and of the platform, from the blocks."""

    def found(block, values: dict[str, mp.mpf]) -> dict[str, Column]:
        parts = block.run(values, mp.sqrt)
        names = [name.removeprefix("force_") for name in parts if name.startswith("force_")]
        return {name: mp.matrix([*parts[f"force_{name}"], *parts[f"moment_{name}"]]) for name in names}

    return [found(derived().leg, values) for values in raw], found(derived().platform, raw[0])


def whole(raw: list[dict[str, mp.mpf]]) -> NDArray[np.object_]:
    """Y, (6, 148)."""
    legs, platform = columns(raw)
    return np.array([list(column) for part in (*legs, platform) for column in part.values()], dtype=object).T
