"""Machines and poses of the robustness sweep, with numbers of more than double precision."""

import ctypes
import dataclasses
from typing import Any

import mpmath
import numpy as np
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym.backend.c_kernel import address
from stewart_sym.backend.kernel import MOTION, robot_numbers
from stewart_sym.dynamics.closed_form import OUTPUTS, NumpyClosedForm
from stewart_sym.precision.truth import Truth, digits
from stewart_sym.results import OK
from stewart_sym.studies.robustness.family import exact
from stewart_sym.studies.robustness.sweep import oracle
from stewart_sym.studies.robustness.sweep.machines import LEGS, random_machine

Array = NDArray[np.float64]

WITHIN = 10.0
"""Rounding units times the condition number that every output of every kernel must keep."""
PRECISIONS = ("double", "float")
NEAR_JOINT = ("joint singularity", "zero-length leg", "heavy leg")


def differentiated(robot: ss.Robot, motion: ss.Motion, F: Array) -> dict[str, Any]:
    """Derivatives of the forces, and of the acceleration under given forces, by pose and by twist."""
    found = fifty_digits(robot, motion, F)
    moving = digits.matrix([*motion.a.tolist(), *motion.alpha.tolist()])
    slopes = dict(zip(("by_pose", "by_twist"), differences(robot, motion, moving), strict=True))
    held = differences(robot, motion, found["forward dynamics"])
    back = -(found["by_acceleration"] ** -1)
    return slopes | dict(zip(("A by pose", "A by twist"), (back * each for each in held), strict=True))


def differences(robot: ss.Robot, motion: ss.Motion, acceleration: Any) -> list[Any]:
    """Derivatives of the forces by pose and by twist, central differences."""
    truth, step = Truth(robot), digits.mpf("1e-50")
    given = {name: np.vectorize(digits.mpf, otypes=[object])(getattr(motion, name)) for name in MOTION}
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


def fifty_digits(robot: ss.Robot, motion: ss.Motion, F: Array) -> dict[str, Array]:
    """M, bias, acceleration, joint inertia and forces by linearity in the accelerations, in 50 digits."""
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
        "M": M,
        "H": H,
        "bias and friction": bias,
        "forward dynamics": acceleration,
        "joint inertia": inverse * M * inverse.T,
        "F": inverse * (M * moving + loaded_bias),
        "by_acceleration": inverse * M,
        "B": M**-1 * H,
    }


def columns_of_fifty_digits(robot: ss.Robot, motion: ss.Motion) -> Any:
    """H at 50 digits, moments about the reference point."""
    R, t, b, p = map(exact, (motion.R, motion.t, robot.b, robot.p))
    q = p @ R.T
    s = np.array([S / digits.sqrt(S @ S) for S in q + t - b])
    return digits.matrix(np.hstack([s, np.cross(q, s)]).T.tolist())


# --- helpers ----------------------------------------------------------------------------------------

BLOCK_H = slice(oracle.BLOCKS["H"][1], oracle.BLOCKS["H"][1] + 36)


def machines_of(seed: int, count: int) -> tuple[Array, Array, list[ss.Robot]]:
    """Numbers, sizes and the machines of one meter that they belong to, whose numbers change case by case."""
    rng = np.random.default_rng(seed)
    robots = [random_machine(rng, legs=LEGS[number % len(LEGS)]) for number in range(count)]
    return np.array([robot_numbers(robot) for robot in robots]), np.ones(count), robots


def case(
    kind: str, numbers: Array, sizes: Array, robots: list[ss.Robot], each: int, seed: int, index: int
) -> tuple[ss.Robot, ss.Motion]:
    """The machine and the motion of a random case."""
    found, pose = oracle.random_case(kind, numbers, sizes, each, seed, index)
    return robot_of(robots[index // each], found), motion_of(pose)


def robot_of(robot: ss.Robot, numbers: Array) -> ss.Robot:
    """A machine with the numbers of the C structure."""
    legs = numbers[:192].reshape(6, 32)
    upper = np.triu_indices(3)

    def tensor(six: Array) -> Array:
        full = np.zeros((*six.shape[:-1], 3, 3))
        full[..., upper[0], upper[1]] = six
        full[..., upper[1], upper[0]] = six
        return full

    changed = dataclasses.replace(
        robot,
        b=legs[:, 0:3],
        p=legs[:, 3:6],
        k=legs[:, 6:9],
        m_d=legs[:, 9],
        I_d0=tensor(legs[:, 13:19]),
        m_u=legs[:, 19],
        I_u0=tensor(legs[:, 23:29]),
        R_0=numbers[193:196],
        I_p=tensor(numbers[196:202]),
    )
    np.testing.assert_allclose(robot_numbers(changed), numbers, rtol=1e-15)
    return changed


def motion_of(numbers: Array) -> ss.Motion:
    """The motion of shape () with the numbers of the C structure."""
    parts = np.split(numbers, np.cumsum([9, *[3] * 6]))
    return ss.Motion(R=parts[0].reshape(3, 3), **dict(zip(list(MOTION)[1:], parts[1:], strict=True)))


def joined(motions: list[ss.Motion]) -> ss.Motion:
    """One motion of shape (n,); one pose in three has no rotation."""
    arrays = {name: np.stack([np.asarray(getattr(motion, name)) for motion in motions]) for name in MOTION}
    arrays["R"][::3] = np.eye(3)
    return ss.Motion(**arrays)


def wider(
    robot: ss.Robot, motion: ss.Motion, F: Array, samples: int = 8, library: ctypes.CDLL | None = None
) -> tuple[Array, Array, Array, NDArray[np.int32]]:
    """Outputs of the closed form's kernels in quadruple precision, high + low, their change and statuses."""
    high, low, change = np.zeros((3, OUTPUT_NUMBERS))
    status = np.zeros(len(oracle.CLOSED_KERNELS), dtype=np.int32)
    numbers, pose = robot_numbers(robot), oracle.motion_numbers(motion)
    (library or oracle._library()).quad_closed_form(
        *(address(np.ascontiguousarray(array)) for array in (numbers, pose, F)),
        ctypes.c_int(2 ** len(status) - 1),
        ctypes.c_double(1e-20),
        ctypes.c_int(samples),
        ctypes.c_uint64(1),
        *(address(array) for array in (high, low, change, status)),
    )
    return high, low, change, status


def outputs(closed: Any, motion: ss.Motion, F: Array) -> tuple[dict[str, Array], dict[str, int]]:
    """Every output of a closed form's kernels by function and name, and each function's status."""
    found, status = {}, {}
    for what in OUTPUTS:
        result = closed.run(what, motion, F if what in ("forward_dynamics", "linearization") else None)
        status[what] = int(result.pop("status"))
        found |= {f"{what}.{name}": value for name, value in result.items()}
    return found, status


def numpy_outputs(robot: ss.Robot, motion: ss.Motion, F: Array) -> tuple[Array, list[int]]:
    """The same numbers of the NumPy kernels, one output after the other, and their statuses."""
    found, status = outputs(NumpyClosedForm(robot), motion, F)
    names = [f"{what}.{name}" for what, names in OUTPUTS.items() for name in names]
    return np.concatenate([np.ravel(found[name]) for name in names]), [*status.values()]


OUTPUT_NUMBERS = sum(int(np.prod(shape)) for shapes in OUTPUTS.values() for shape in shapes.values())


def block_error(
    part: tuple[int, ...], length: float, scaled: float, found: Any, high: Array, low: Array, change: Array
) -> float:
    """Error of a block in rounding units of its size times its condition number.

    found: all outputs, or the block alone at 50 digits.
    """
    _, offset, rows, columns, stride, row, column = part
    size = error = moved = 0.0
    for i in range(rows):
        for j in range(columns):
            at = offset + i * stride + j
            weight = length ** ((i % 6 > 2) * row + (j % 6 > 2) * column)
            value = found[i, j] if isinstance(found, mpmath.matrix | digits.matrix) else found[at]
            error = max(error, float(abs((digits.mpf(value) - high[at]) - low[at])) * weight)
            size, moved = max(size, abs(high[at]) * weight), max(moved, change[at] * weight)
    condition = max(moved / size if size else 1.0, scaled, 1.0)
    return error / (np.finfo(np.float64).eps * size * condition) if error else 0.0


def _given(values: Array) -> NDArray[np.int64]:
    """A status made of NaN."""
    return np.where(np.isfinite(values).all(axis=(-2, -1)), OK, 1)


def _size_and_mass(rng: np.random.Generator, number: int) -> tuple[float, float]:
    """One meter and ten kilograms, or anything."""
    return (
        (1.0, 10.0) if number % 2 else (float(10.0 ** rng.uniform(-3, 2)), float(10.0 ** rng.uniform(-3, 3)))
    )
