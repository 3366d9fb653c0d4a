"""Machines and poses of the stability study, with numbers of more than double precision."""

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym.backend.kernel import MOTION, robot_numbers
from stewart_sym.dynamics.forward_dynamics import closed_form_of
from stewart_sym.generated.interface import OUTPUTS
from stewart_sym.precision.exact_forces import Truth, digits
from stewart_sym.results import OK
from stewart_sym.studies.robustness.failures import random_cases
from stewart_sym.studies.robustness.oracle import CLOSED, Cases

Array = NDArray[np.float64]

WITHIN = 10.0
"""Rounding units times the condition number that every output of every kernel must keep."""
PRECISIONS = ("double", "float")
NEAR_JOINT = ("joint singularity", "zero-length leg", "heavy leg")
exact = np.vectorize(digits.mpf, otypes=[object])


def cases_near(kind: str, seed: int, count: int, each: int = 1) -> Cases:
    """Random cases in double, ``each`` of every machine."""
    return random_cases(kind, np.random.default_rng(seed), count, each, 16.6)


def case(cases: Cases, index: int) -> tuple[ss.Robot, ss.Motion, Array]:
    """The machine, the motion, and the actuator forces of a case."""
    machine, moving, upper = cases.robot[index], cases.motion[index], np.triu_indices(3)
    legs = machine["legs"]

    def tensor(six: Array) -> Array:
        full = np.zeros((*six.shape[:-1], 3, 3))
        full[..., upper[0], upper[1]] = full[..., upper[1], upper[0]] = six
        return full

    robot = ss.Robot(
        name="random",
        base_joint="universal",
        **{name: tensor(legs[name]) if name[0] == "I" else legs[name] for name in legs.dtype.names},
        M=machine["M"],
        R_0=machine["R_0"],
        I_p=tensor(machine["I_p"]),
        g=machine["g"],
    )
    np.testing.assert_allclose(robot_numbers(robot), cases.robots[index], rtol=1e-15)
    return robot, ss.Motion(**{name: moving[name] for name in MOTION}), cases.forces[index]


def differentiated(robot: ss.Robot, motion: ss.Motion, F: Array) -> dict[str, Any]:
    """Derivatives of the forces, and of the acceleration under given forces, by pose and by twist."""
    found = fifty_digits(robot, motion, F)
    moving = digits.matrix([*motion.a.tolist(), *motion.alpha.tolist()])
    slopes = dict(zip(("by_pose", "by_twist"), differences(robot, motion, moving), strict=True))
    held = differences(robot, motion, found["forward_dynamics", "acceleration"])
    back = -(found["derivatives", "by_acceleration"] ** -1)
    return {("derivatives", name): value for name, value in slopes.items()} | {
        ("linearization", name): back * each
        for name, each in zip(("A by pose", "A by twist"), held, strict=True)
    }


def differences(robot: ss.Robot, motion: ss.Motion, acceleration: Any) -> list[Any]:
    """Derivatives of the forces by pose and by twist, central differences."""
    truth, step = Truth(robot), digits.mpf("1e-50")
    given = {name: exact(getattr(motion, name)) for name in MOTION}
    given |= {"a": np.array(list(acceleration)[:3]), "alpha": np.array(list(acceleration)[3:])}

    def moved(name: str, axis: int, by: Any) -> Any:
        values = given[name].copy()
        if name == "R":
            N = np.cross(np.eye(3)[axis], np.eye(3)).T.astype(int).astype(object)
            values = values + by * (N @ values) + by * by / 2 * (N @ (N @ values))
        else:
            values[axis] += by
        return digits.matrix(list(truth.of_pose(given | {name: values})))

    found = []
    for names in (("t", "R"), ("v", "omega")):
        slopes = digits.matrix(6, 6)
        for column in range(6):
            name, axis = names[column // 3], column % 3
            slopes[:, column] = (moved(name, axis, step) - moved(name, axis, -step)) / (2 * step)
        found.append(slopes)
    return found


def fifty_digits(robot: ss.Robot, motion: ss.Motion, F: Array) -> dict[tuple[str, str], Any]:
    """Outputs by kernel and block, by linearity of the forces in the accelerations, in 50 digits."""
    truth, none = Truth(robot), np.zeros(3)
    H = columns_of_fifty_digits(robot, motion)

    def wrench(a: Array, F_ext: Array = none, M_ext: Array = none) -> Any:
        moving = dataclasses.replace(motion, a=a[:3], alpha=a[3:], F_ext=F_ext, M_ext=M_ext)
        return H * digits.matrix(list(truth.forces(moving)))

    zero = np.zeros(6)
    bias = wrench(zero)
    M = digits.matrix(6, 6)
    for j, unit in enumerate(np.eye(6)):
        M[:, j] = wrench(unit) - bias
    loaded_bias = wrench(zero, motion.F_ext, motion.M_ext)
    acceleration = digits.lu_solve(M, H * digits.matrix(F.tolist()) - loaded_bias)
    inverse = H**-1
    moving = digits.matrix([*motion.a.tolist(), *motion.alpha.tolist()])
    return {
        ("equations", "M"): M,
        ("equations", "H"): H,
        ("bias_and_friction", "bias_and_friction"): bias,
        ("forward_dynamics", "acceleration"): acceleration,
        ("joint_inertia", "inertia"): inverse * M * inverse.T,
        ("derivatives", "F"): inverse * (M * moving + loaded_bias),
        ("derivatives", "by_acceleration"): inverse * M,
        ("linearization", "B"): M**-1 * H,
    }


def columns_of_fifty_digits(robot: ss.Robot, motion: ss.Motion) -> Any:
    """H at 50 digits, moments about the reference point."""
    R, t, b, p = map(exact, (motion.R, motion.t, robot.b, robot.p))
    q = p @ R.T
    s = np.array([S / digits.sqrt(S @ S) for S in q + t - b])
    return digits.matrix(np.hstack([s, np.cross(q, s)]).T.tolist())


def rounded(matrix: Any) -> NDArray[np.longdouble]:
    """The entries of a matrix of 50 digits in long double, row by row."""
    high = np.array([float(x) for x in matrix])
    low = np.array([float(x - h) for x, h in zip(matrix, high, strict=True)])
    return high.astype(np.longdouble) + low


def joined(motions: list[ss.Motion]) -> ss.Motion:
    """One motion of shape (n,); one pose in three has no rotation."""
    arrays = {name: np.stack([np.asarray(getattr(motion, name)) for motion in motions]) for name in MOTION}
    arrays["R"][::3] = np.eye(3)
    return ss.Motion(**arrays)


def numpy_outputs(robot: ss.Robot, motion: ss.Motion, F: Array) -> dict[str, tuple[Array, int]]:
    """Numbers of each NumPy kernel, one output after the other, and its status."""
    closed, found = closed_form_of(robot, "exact", "numpy"), {}
    assert closed is not None
    for what in CLOSED:
        result = closed.run(what, motion, *[F][: what in ("forward_dynamics", "linearization")])
        numbers = [np.ravel(result[name]) for name in OUTPUTS[what]]
        found[what] = np.concatenate(numbers), int(result["status"])
    return found


def given(values: Array) -> NDArray[np.int64]:
    """A status made of NaN."""
    return np.where(np.isfinite(values).all(axis=(-2, -1)), OK, 1)


def size_and_mass(rng: np.random.Generator, number: int) -> tuple[float, float]:
    """One meter and ten kilograms, or anything."""
    return (
        (1.0, 10.0) if number % 2 else (float(10.0 ** rng.uniform(-3, 2)), float(10.0 ** rng.uniform(-3, 3)))
    )
