"""Comparison of the kernels with CasADi, Pinocchio, and MuJoCo, and times after each pass of the derivation.

``python tests/support/studies/compare_engines.py RUN`` runs in the top folder of the source, and writes
``bench.json``, ``bench.png``, and ``bench_motion.png`` into the folder RUN: the results of ``benchmark`` with
further cases, measured alternately with the kernels. It takes about four minutes on an idle machine.

CasADi generates C of the same equations, as the closed form in the leg frame and with vectors in the base
frame. Engines compute over a tree of all 13 bodies and are called from Python, less a call for a model
without bodies. Joint coordinates, rates, accelerations, and generalized forces are prepared in advance.
Each of the six legs is revolute about k, revolute about y, and prismatic along s. A spherical joint connects
the platform to the last leg, and five points close the loops. Engines share no equation with the kernels;
rotations of the legs are from the vector reference.
"""

import ctypes
import dataclasses
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from importlib.metadata import version
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import casadi_forces
import mujoco
import numpy as np
import pinocchio as pin
from benchmark_tables import CLOSED, PASSES, PLAIN

from stewart_sym.backend import kernel, native
from stewart_sym.calls import c_kernel
from stewart_sym.calls.numpy_kernel import loaded
from stewart_sym.derive.passes import passes
from stewart_sym.exchange.model_from_robot import robot_of_bodies
from stewart_sym.io.array_types import Array
from stewart_sym.io.output import json_text, write_file
from stewart_sym.motion.motion import Motion
from stewart_sym.motion.rotation import cross_matrix, quaternion_from_rotation
from stewart_sym.reference import newton_euler
from stewart_sym.robot.robot import Robot
from stewart_sym.studies.benchmark.benchmark import benchmark, full_report
from stewart_sym.studies.benchmark.cases import (
    EQUATION_POSES,
    EQUATIONS,
    FEW,
    FORCES,
    NAME,
    Case,
    Poses,
)
from stewart_sym.studies.common.report import draw
from stewart_sym.studies.common.timing import Task, Timed, loop, over

_FUSED = ("-ffp-contract=fast",)
"""Flag for CasADi's C, which is faster with fused products and sums."""

_SOLVED = 1024
"""Number of systems in one call of the solve, so that the overhead of the call is negligible."""

STIFFNESS = 1e7
"""Ratio of MuJoCo's acceleration of a constrained point to the gap of the constraint (1/s^2)."""

_CORRECTIONS = 3
"""Number of corrections of MuJoCo's joint coordinates; each reduces the error to a small fraction."""

CARRIER = 5
"""Index of the leg that carries the platform."""

SLIDES = slice(2, 18, 3)
"""Indices of the actuated coordinates among the 21 joint rates."""


def compared(poses: Poses, truth: Array) -> Iterator[Case]:
    """Yield all cases of this script; ``truth`` are the forces of the reference (N), (n, 6)."""
    few = poses.resized(FEW)
    yield from casadi_cases(few, truth)
    yield inverse_engine(few, truth)
    motions = poses.resized(EQUATION_POSES)
    yield from forward_engines(Poses(robot_of_bodies(poses.robot), motions.arrays))
    yield from pass_cases(poses, truth)


def main(folder: Path) -> None:
    """Write the figures and plots of a run."""
    results = benchmark(progress=lambda text, *_: print(text, file=sys.stderr), more=compared)
    results["software"] |= {name: version(name) for name in ("casadi", "pin", "mujoco")}
    write_file(folder / "bench.json", json_text(results).encode())
    for stem, picture in full_report(results).figures.items():
        draw(dataclasses.replace(picture, kinds=("png",)), folder / stem)


# --- C ----------------------------------------------------------------------------------------


def casadi_cases(few: Poses, truth: Array) -> Iterator[Case]:
    """Yield C that CasADi generates from the equations."""
    numbers = kernel.robot_numbers(few.robot)
    programs = ((CLOSED, "leg", casadi_forces.leg_frame), (PLAIN, "base", casadi_forces.base_frame))
    for name, frame, legs in programs:
        sources, count = casadi_forces.program(legs)
        timed = loop(few.rows, native.load("bench_casadi", sources, _FUSED).one_pose, numbers)
        yield Case(FORCES, name, f"C, {frame} frame", *timed, truth, count, package="CasADi")


def pass_cases(poses: Poses, truth: Array) -> Iterator[Case]:
    """Yield the kernel after every pass of the derivation, for one pose and for a batch."""
    numbers, few, address = kernel.robot_numbers(poses.robot), poses.resized(FEW), c_kernel.address
    for number, made in enumerate(passes(), 1):
        library = native.load(f"bench_pass_{number}", made.sources)
        one, batch, prepare = (
            getattr(library, f"stewart_{NAME}_{name}") for name in ("forces", "forces_batch", "prepare")
        )
        model = np.zeros(made.model_numbers)
        if prepare(address(numbers), address(model)):
            raise ValueError(f"{made.name}: the constants of the robot cannot be prepared")
        for kind, timed in (
            ("one pose", loop(few.rows, one, model)),
            ("batch", _c_batch(batch, model, poses)),
        ):
            yield Case(PASSES, f"{made.name}, {kind}", made.meaning, *timed, truth, made.operations[1])


def _c_batch(function: Any, model: Array, poses: Poses) -> Timed:
    """Time a batch function in C."""
    F, status = np.zeros((len(poses), 6)), np.zeros(len(poses), dtype=np.int32)
    size, motions, address = ctypes.c_size_t(len(poses)), c_kernel.pointers(poses.arrays), c_kernel.address
    # The addresses are computed in each call, because a pointer does not keep its array alive.
    run = over(lambda: function(address(model), size, motions, address(F), address(status)))
    return Task(run, len(poses)), lambda: F


# --- joint tree -------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class JointTree:
    """Motions (n,) in joint coordinates.

    ``coordinates``, (n, 18), are two angles and the length of each leg, and ``quaternion``, (n, 4), is the
    orientation of the platform relative to the upper part that carries it, scalar first. ``rates``, (n, 21),
    are the joint rates of the legs, then the angular velocity of the platform relative to its leg in the
    platform frame, and ``accelerations`` their derivatives. ``resistance``, (n, 21), are the generalized
    forces of joint friction and external load. ``per_twist``, (n, 21, 6), are joint rates per twist [v;
    omega] of the platform, and ``jacobian``, (n, 6, 3, 3), velocities of the leg tips per joint rates.
    """

    coordinates: Array
    quaternion: Array
    rates: Array
    accelerations: Array
    resistance: Array
    per_twist: Array
    jacobian: Array
    _acceleration: Array

    def platform_acceleration(self, joints: Array) -> Array:
        """Return [a; alpha], (n, 6), for joint accelerations, (n, 21), of the leg with the platform."""
        change = (joints - self.accelerations)[:, 3 * CARRIER :, None]
        return self._acceleration + np.linalg.solve(self.per_twist[:, 3 * CARRIER :], change)[..., 0]

    def gaps(self, joints: Array) -> Array:
        """Return accelerations of the other leg tips relative to their platform points, (n, 5, 3)."""
        change = self.platform_acceleration(joints) - self._acceleration
        off = joints - self.accelerations - _product(self.per_twist, change)
        return _product(self.jacobian, off[:, :-3].reshape(-1, 6, 3))[:, :CARRIER]


def base_frames(robot: Robot) -> Array:
    """Return frames of the first joints, (6, 3, 3), with the x axis along k; columns are their axes."""
    k = robot.k
    across = np.cross(k, np.eye(3)[np.argmin(np.abs(k), axis=-1)])
    across /= np.linalg.norm(across, axis=-1, keepdims=True)
    return np.stack([k, across, np.cross(k, across)], axis=-1)


def joint_tree(robot: Robot, motion: Motion) -> JointTree:
    """Compute the joint motion at poses (n,); base joints must be universal."""
    given = SimpleNamespace(**loaded(motion))
    leg, k = newton_euler.legs(robot, motion), np.broadcast_to(robot.k, (6, 3))
    R, to_platform = given.R, np.swapaxes(given.R, -1, -2)
    _, second, third = np.moveaxis(np.einsum("kji,nkj->nki", base_frames(robot), leg.y), -1, 0)
    tilt = np.arccos(np.einsum("ki,nki->nk", k, leg.s))
    coordinates = np.stack([np.arctan2(third, second), tilt, leg.L[..., 0]], axis=-1)
    axes = np.stack([np.broadcast_to(k, leg.y.shape), leg.y], axis=-1)
    jacobian = np.stack([np.cross(k, leg.S), np.cross(leg.y, leg.S), leg.s], axis=-1)
    # Joint rates of the legs and of the joint below the platform are linear in the twist.
    arms = np.concatenate([np.broadcast_to(np.eye(3), (*leg.q.shape, 3)), -cross_matrix(leg.q)], axis=-1)
    of_legs = np.linalg.inv(jacobian) @ arms
    turn = np.zeros((len(R), 3, 6))
    turn[..., 3:] = np.eye(3)
    below = to_platform @ (turn - axes[:, CARRIER] @ of_legs[:, CARRIER, :2])
    per_twist = np.concatenate([of_legs.reshape(len(R), -1, 6), below], axis=1)
    rates = _product(per_twist, np.concatenate([given.v, given.omega], axis=-1))
    accelerations = np.concatenate([_product(np.swapaxes(axes, -1, -2), leg.A), leg.Lddot], axis=-1)
    W, A = leg.W[:, CARRIER], leg.A[:, CARRIER]
    spin = _product(to_platform, given.alpha - A - np.cross(W, given.omega))
    return JointTree(
        coordinates.reshape(len(R), -1),
        quaternion_from_rotation(np.swapaxes(leg.T[:, CARRIER], -1, -2) @ R),
        rates,
        np.concatenate([accelerations.reshape(len(R), -1), spin], axis=-1),
        _resistance(robot, given, leg, rates[:, :-3].reshape(-1, 6, 3), axes, jacobian),
        per_twist,
        jacobian,
        np.concatenate([given.a, given.alpha], axis=-1),
    )


def _resistance(
    robot: Robot, given: Any, leg: newton_euler.Legs, rates: Array, axes: Array, jacobian: Array
) -> Array:
    """Compute the generalized forces of friction and load, (n, 21)."""
    joints = np.concatenate([-robot.C_u[:, None] * rates[..., :2], -robot.C_p[:, None] * rates[..., 2:]], -1)
    joints[..., :2] -= np.einsum("nkij,nki->nkj", axes, leg.f)
    # The load acts at the reference point and is moved to the point that the last leg carries.
    force = _product(given.R, given.F_ext)
    moment = _product(given.R, given.M_ext) + leg.f.sum(axis=1) - np.cross(leg.q[:, CARRIER], force)
    joints[:, CARRIER] += np.einsum("nij,ni->nj", jacobian[:, CARRIER], force)
    joints[:, CARRIER, :2] += np.einsum("nij,ni->nj", axes[:, CARRIER], moment)
    in_platform = _product(np.swapaxes(given.R, -1, -2), moment)
    return np.concatenate([joints.reshape(len(force), -1), in_platform], axis=-1)


def _product(matrix: Array, vector: Array) -> Array:
    return np.asarray(np.einsum("...ij,...j->...i", matrix, vector))


# --- engines ----------------------------------------------------------------------------------


def inverse_engine(poses: Poses, truth: Array) -> Case:
    """Return Pinocchio's inverse dynamics with the solution of 6x6 systems for the actuator forces."""
    tree = joint_tree(poses.robot, poses.motion)
    model, _ = _pinocchio_model(poses.robot)
    data, nothing = model.createData(), pin.Model()
    states = list(zip(_positions(tree), tree.rates, tree.accelerations, strict=True))
    tau = np.array([pin.rnea(model, data, *state) for state in states])
    several = np.resize(np.arange(len(tau)), _SOLVED)
    matrices = np.swapaxes(tree.per_twist[:, SLIDES], -1, -2)[several]
    right = np.einsum("nji,nj->ni", tree.per_twist, tau - tree.resistance)[several, :, None]
    empty = over(partial(pin.rnea, nothing, nothing.createData()), [3 * (np.zeros(0),)] * len(states))
    task = Task(over(partial(pin.rnea, model, data), states), len(states))
    solve = Task(over(np.linalg.solve, [(matrices, right)]), _SOLVED)
    more: Any = {"package": "Pinocchio", "others": {solve: 1.0, Task(empty, len(states)): -1.0}}

    def results() -> Array:
        return np.asarray(np.linalg.solve(matrices, right)[: len(tau), :, 0])

    return Case(FORCES, "Pinocchio", "rnea + solve - call", task, results, truth, **more)


def forward_engines(poses: Poses) -> Iterator[Case]:
    """Yield engines that compute [a; alpha], shape (n, 6), from the actuator forces."""
    robot, motion = poses.robot, poses.motion
    expected = np.concatenate([motion.a, motion.alpha], axis=-1)
    tree = joint_tree(robot, motion)
    forces = tree.resistance.copy()
    forces[:, SLIDES] += newton_euler.inverse_dynamics(robot, motion).F
    for name, what, engine, tolerance in (
        ("Pinocchio", "constraintDynamics", _constraint_dynamics, 1e-6),
        ("MuJoCo", "mj_forward", _mj_forward, 1e-4),
    ):
        *calls, joints = engine(robot, tree, forces)
        run, empty = (Task(call, len(expected)) for call in calls)
        results = partial(lambda joints: tree.platform_acceleration(joints()), joints)
        more: Any = {"tolerance": tolerance, "package": name, "others": {empty: -1.0}}
        row, what = f"forward dynamics, {name}", f"{what}, 5 loops - call"
        yield Case(EQUATIONS, row, what, run, results, expected, **more)


Engine = tuple[Callable[[int], None], Callable[[int], None], Callable[[], Array]]
"""Calls for all poses and for an empty model, and the function that returns the joint accelerations."""

# --- Pinocchio --------------------------------------------------------------------------------


def _constraint_dynamics(robot: Robot, tree: JointTree, forces: Array) -> Engine:
    """Call ``constraintDynamics`` with rigid constraints and one step of its proximal solver."""

    def solver(model: Any, constraints: list[Any]) -> tuple[Callable[..., Any], tuple[Any, ...]]:
        models = pin.StdVec_RigidConstraintModel(constraints)
        datas = pin.StdVec_RigidConstraintData([each.createData() for each in constraints])
        data = model.createData()
        pin.initConstraintDynamics(model, data, models, datas)
        more = models, datas, pin.ProximalSettings(1e-12, 1e-12, 1)
        return partial(pin.constraintDynamics, model, data), more

    solve, more = solver(*_pinocchio_model(robot))
    nothing, no_more = solver(pin.Model(), [])
    states = [(*state, *more) for state in zip(_positions(tree), tree.rates, forces, strict=True)]
    empty = over(nothing, [(*3 * (np.zeros(0),), *no_more)] * len(states))
    return over(solve, states), empty, lambda: np.array([solve(*state) for state in states])


def _positions(tree: JointTree) -> Array:
    return np.hstack([tree.coordinates, np.roll(tree.quaternion, -1, axis=1)])


def _pinocchio_model(robot: Robot) -> tuple[Any, list[Any]]:
    """Return the tree of the machine and the constraints that close its loops."""
    model, here, uppers = pin.Model(), pin.SE3.Identity(), []
    model.gravity = pin.Motion(robot.g, np.zeros(3))
    for i, frame in enumerate(base_frames(robot)):
        first = model.addJoint(0, pin.JointModelRX(), pin.SE3(frame, robot.b[i]), f"fixed axis {i + 1}")
        lower = model.addJoint(first, pin.JointModelRY(), here, f"moving axis {i + 1}")
        upper = model.addJoint(lower, pin.JointModelPX(), here, f"actuator {i + 1}")
        model.appendBodyToJoint(lower, pin.Inertia(robot.m_d[i], robot.r_d0[i], robot.I_d0[i]), here)
        model.appendBodyToJoint(upper, pin.Inertia(robot.m_u[i], robot.r_u0[i], robot.I_u0[i]), here)
        uppers.append(upper)
    carried = robot.p[CARRIER]
    platform = model.addJoint(uppers[CARRIER], pin.JointModelSpherical(), here, "platform")
    model.appendBodyToJoint(platform, pin.Inertia(robot.M, robot.R_0 - carried, robot.I_p), here)
    contact, local = pin.ContactType.CONTACT_3D, pin.ReferenceFrame.LOCAL
    points = (pin.SE3(np.eye(3), point - carried) for point in robot.p)
    constraints = [
        pin.RigidConstraintModel(contact, model, upper, here, platform, point, local)
        for upper, point in zip(uppers[:CARRIER], points, strict=False)
    ]
    return model, constraints


# --- MuJoCo -----------------------------------------------------------------------------------


def _mj_forward(robot: Robot, tree: JointTree, forces: Array) -> Engine:
    """Call ``mj_forward`` with five ``connect`` constraints and one dense Newton step.

    The constraints yield in proportion to their force. In compensation the legs are moved by nanometers in
    advance, so that the springs of the constraints supply the missing force.
    """
    model, nothing = _mujoco_model(robot), mujoco.MjModel.from_xml_string(_OPTIONS)
    datas = [mujoco.MjData(model) for _ in forces]
    for data, quaternion, rates, of_pose in zip(datas, tree.quaternion, tree.rates, forces, strict=True):
        data.qpos[-4:], data.qvel[:], data.qfrc_applied[:] = quaternion, rates, of_pose
    forward = over(mujoco.mj_forward, [(model, data) for data in datas])
    empty = over(mujoco.mj_forward, [(nothing, mujoco.MjData(nothing)) for _ in datas])

    def joints() -> Array:
        forward(1)
        return np.array([data.qacc for data in datas])

    moves, places = np.zeros((len(datas), CARRIER, 3)), tree.coordinates.reshape(-1, 6, 3).copy()
    for correction in range(1 + _CORRECTIONS):
        moves += tree.gaps(joints()) / STIFFNESS if correction else 0.0
        closed = np.linalg.solve(tree.jacobian[:, :CARRIER], moves[..., None])[..., 0]
        for data, place, by in zip(datas, places, closed, strict=True):
            data.qpos[:-4] = place.ravel()
            data.qpos[: 3 * CARRIER] += by.ravel()
    return forward, empty, joints


def _mujoco_model(robot: Robot) -> Any:
    """Return the machine; sites are the constrained points."""
    spec = mujoco.MjSpec.from_string(_OPTIONS)
    spec.option.gravity = robot.g
    slide, hinge, ball = (getattr(mujoco.mjtJoint, f"mjJNT_{name}") for name in ("SLIDE", "HINGE", "BALL"))
    x, y = np.eye(3)[:2]

    def body(parent: Any, mass: Any, center: Array, inertia: Array, joints: Any, **place: Any) -> Any:
        tensor = inertia[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
        made = parent.add_body(mass=mass, ipos=center, fullinertia=tensor, explicitinertial=True, **place)
        for kind, axis in joints:
            made.add_joint(type=kind, axis=axis)
        return made

    uppers = []
    for i, quaternion in enumerate(quaternion_from_rotation(base_frames(robot))):
        place: Any = {"joints": [(hinge, x), (hinge, y)], "pos": robot.b[i], "quat": quaternion}
        lower = body(spec.worldbody, robot.m_d[i], robot.r_d0[i], robot.I_d0[i], **place)
        uppers.append(body(lower, robot.m_u[i], robot.r_u0[i], robot.I_u0[i], [(slide, x)]))
    carried = robot.p[CARRIER]
    platform = body(uppers[CARRIER], robot.M, robot.R_0 - carried, robot.I_p, [(ball, x)])
    closure: Any = {"type": mujoco.mjtEq.mjEQ_CONNECT, "objtype": mujoco.mjtObj.mjOBJ_SITE}
    closure |= {"solref": (-STIFFNESS, 0.0), "solimp": (mujoco.mjMAXIMP, mujoco.mjMAXIMP, 1.0, 0.5, 2.0)}
    for i, upper in enumerate(uppers[:CARRIER]):
        upper.add_site(name=f"tip{i}")
        platform.add_site(name=f"point{i}", pos=robot.p[i] - carried)
        spec.add_equality(name1=f"tip{i}", name2=f"point{i}", **closure)
    return spec.compile()


_OPTIONS = """<mujoco>
  <option gravity="0 0 0" solver="Newton" jacobian="dense" iterations="1" tolerance="0">
    <flag contact="disable" sensor="disable" warmstart="disable" island="disable"/>
  </option>
  <size memory="1M"/>
</mujoco>"""
"""MuJoCo's fastest solver, without warm start and unrequested computations."""


if __name__ == "__main__":
    main(Path(sys.argv[1]))
