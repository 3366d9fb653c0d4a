"""Errors of the shipped C kernels against the same equations in ``long double``, over the condition number.

The truth of the forces is the plain elimination, which shares neither regrouping nor preparation with the
fast kernels. The condition number of an output is its change by relative changes of every input number.
"""

import ctypes
import dataclasses
import functools
import math
from dataclasses import dataclass
from importlib.resources import files
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...backend import native
from ...backend.kernel import robot_numbers
from ...calls.c_kernel import address, c_sources
from ...calls.numpy_kernel import loaded
from ...generated.interface import OUTPUTS, STRUCTS
from ...io.array_types import Array, Codes
from ...motion.motion import Motion
from ...results import OK, SINGULAR
from ...robot.robot import Robot

FORCES = ("one_pose", "batch", "every_output")
"""Kernels of the actuator forces."""
CLOSED = (
    *("equations", "bias_and_friction", "forward_dynamics"),
    *("joint_inertia", "derivatives", "linearization"),
)
"""Kernels of the closed form."""
GOOD = {"double": 1e12, "float": 1e3}
"""Condition number below which a pose must have a result."""
DOUBTFUL = 10.0
"""Ratio of error to condition number above which the latter is measured again, input by input."""
SAMPLES = 3
"""Number of random changes of all inputs."""

_TRUTH = "every_output"
_TYPES: dict[str, Any] = {"double": np.float64, "float": np.float32, "wide": np.longdouble}
EPSILON = {"double": 2.0**-52, "float": 2.0**-23}
_WIDE = {"SQRT": "sqrtl", "FABS": "fabsl", "EPSILON": "LDBL_EPSILON", "MAX": "LDBL_MAX"}
_MACROS = [f"-DSTEWART_{name}={value}" for name, value in {"REAL": "long double", **_WIDE}.items()]
_FLAGS = {
    "double": (),
    "float": ("-DSTEWART_FLOAT",),
    "wide": ("-O1", "-include", "float.h", "-include", "math.h", *_MACROS),
}
_SHAPES: dict[str, Any] = {**OUTPUTS, **{name: {"F": (6,)} for name in FORCES[:2]}, _TRUTH: STRUCTS["forces"]}
_POWERS = {
    **dict.fromkeys(("M", "C"), (-1, -1)),
    **dict.fromkeys(("g", "friction", "bias", "bias_and_friction", "H", "H_dot"), (-1, 0)),
    "acceleration": (1, 0),
    **dict.fromkeys(("inertia", "F"), (0, 0)),
    **dict.fromkeys(("by_pose", "by_twist", "by_acceleration"), (0, -1)),
    "A": (1, -1),
    "B": (1, 0),
}
"""Powers of the platform size that make the last three of six rows and columns comparable with the first."""


def _members(struct: str, tensor: tuple[int, ...]) -> list[Any]:
    """Return names, types, and shapes of the members of a C struct, whose tensors have a given shape."""
    shapes = STRUCTS[struct].items()
    return [(name, np.float64, tensor if shape == (3, 3) else shape) for name, shape in shapes]


# Symmetric tensors have six numbers.
_ROBOT = np.dtype([("legs", _members("leg", (6,)), (6,)), *_members("platform", (6,))])
_MOTION = np.dtype(_members("motion", (3, 3)))


@dataclass(frozen=True, eq=False)
class Cases:
    """Machines with one motion each, as numbers of the C structs, and with the names of their members.

    ``robots`` has the shape (n, 205), ``motions`` (n, 30). ``forces``, (n, 6), are actuator forces of the
    forward dynamics (N), and ``distance``, (n,), are distances from a failure.
    """

    robots: Array
    motions: Array
    forces: Array
    distance: Array

    @property
    def robot(self) -> NDArray[Any]:
        """View of the robots with the members of ``stewart_robot``, shape (n,)."""
        return self.robots.view(_ROBOT)[:, 0]

    @property
    def legs(self) -> NDArray[Any]:
        """View of the legs with the members of ``stewart_leg``, shape (n, 6)."""
        return np.asarray(self.robot["legs"])

    @property
    def motion(self) -> NDArray[Any]:
        """View of the motions with the members of ``stewart_motion``, shape (n,)."""
        return self.motions.view(_MOTION)[:, 0]

    def __getitem__(self, where: Any) -> "Cases":
        """Return some of the cases."""
        return Cases(self.robots[where], self.motions[where], self.forces[where], self.distance[where])


def cases_of(robots: list[Robot], motions: list[Motion], distance: Array | None = None) -> Cases:
    """Return cases from n robots and n motions of shape (); the forces are multiples of the weight."""
    numbers = np.array([robot_numbers(robot) for robot in robots])
    every = [[*map(np.ravel, loaded(motion).values())] for motion in motions]
    with np.errstate(over="ignore"):
        forces = numbers[:, 192:193] * 9.81 * np.array([0.7, -1.1, 0.4, 1.3, -0.2, 0.9])
    distance = np.zeros(len(numbers)) if distance is None else distance
    return Cases(numbers, np.array([*map(np.concatenate, every)]), forces, distance)


def _blocks(kernel: str) -> dict[str, tuple[NDArray[np.int64], NDArray[np.int64]]]:
    """Return places and powers of the size for each part of the outputs; of forces only F counts."""
    found, start = {}, 0
    for name, shape in _SHAPES[kernel].items():
        places = start + np.arange(math.prod(shape)).reshape(shape[0], -1)
        start += places.size
        # Only the lower half of A and B has rounding errors.
        parts = {"A": {"A by pose": places[6:, :6], "A by twist": places[6:, 6:]}, "B": {"B": places[6:]}}
        for part, at in parts.get(name, {name: places}).items():
            if kernel not in FORCES or name == "F":
                rows, columns = np.indices(at.shape) > 2
                powers = _POWERS[name][0] * rows + _POWERS[name][1] * columns
                found[part] = at.ravel(), powers.ravel()
    return found


BLOCKS = {kernel: _blocks(kernel) for kernel in (*FORCES, *CLOSED)}
"""Parts of the outputs of each kernel with one unit, by name: places, and powers of the platform size."""


@dataclass(frozen=True, eq=False)
class Truth:
    """Outputs of a kernel in wide arithmetic.

    ``values`` are the outputs, one after the other, shape (n, m), NaN for unsolvable cases, and ``change`` is
    their change over the relative change of the inputs. ``scaled`` and ``frames`` are the condition numbers
    of H and of the leg frames, shape (n,).
    """

    values: NDArray[np.longdouble]
    status: Codes
    change: Array
    scaled: Array
    frames: Array


@dataclass(frozen=True, eq=False)
class Verdict:
    """Errors of a kernel, shape (n,) each.

    ``error`` is the largest error of a block in rounding units of its size, NaN with a status of the
    kernel or the truth, and ``condition`` is the condition number of that block. ``pose`` is the largest
    condition number of block, scaled H, and leg frames.
    """

    error: Array
    condition: Array
    pose: Array
    status: Codes
    truth: Codes

    @property
    def ratio(self) -> Array:
        """Error over condition number of cases with status OK, inf for wrong answers, else -1."""
        ratio = np.where(self.truth == OK, self.error / self.condition, np.inf)
        return np.where(self.status == OK, np.where(np.isnan(ratio), np.inf, ratio), -1.0)

    def rejected_good(self, precision: str) -> NDArray[np.bool_]:
        """Return True for good poses with a status."""
        return np.asarray((self.status != OK) & (self.truth == OK) & (self.pose < GOOD[precision]))


@np.errstate(all="ignore")
def check(
    cases: Cases,
    kernels: tuple[str, ...],
    precision: str = "double",
    floor: bool = False,
    samples: int = SAMPLES,
    solvable: bool = True,
) -> dict[str, Verdict]:
    """Compare some of ``FORCES`` and ``CLOSED`` with the truth; return the verdict on each kernel.

    With ``floor`` condition numbers of the closed form are at least the scaled condition number of H. All are
    measured by ``samples`` random changes of all inputs, and again if they seem too small. Without
    ``solvable`` no answer is right, as for machines that are singular at every pose.
    """
    if precision == "float":
        given = (cases.robots, cases.motions, cases.forces)
        robots, motions, forces = (each.astype(np.float32).astype(np.float64) for each in given)
        cases = Cases(robots, motions, forces, cases.distance)
    truth = functools.cache(lambda source: truth_of(cases, source, precision, samples))
    found = {}
    for kernel in kernels:
        values, status = run(cases, kernel, precision)
        if not solvable:
            none = np.full(len(status), np.nan)
            found[kernel] = Verdict(none, none, none, status, np.full_like(status, SINGULAR))
            continue
        source = _TRUTH if kernel in FORCES else kernel
        found[kernel] = judge(kernel, values, status, truth(source), cases, precision, floor)
        again = (found[kernel].ratio > DOUBTFUL) & (found[kernel].ratio < 30.0 * DOUBTFUL)
        again |= found[kernel].rejected_good(precision)
        if samples and again.any():
            change = truth(source).change.copy()
            change[again] = truth_of(cases[again], source, precision, samples=-1).change
            closer = dataclasses.replace(truth(source), change=change)
            found[kernel] = judge(kernel, values, status, closer, cases, precision, floor)
    return found


def truth_of(cases: Cases, kernel: str, precision: str = "double", samples: int = SAMPLES) -> Truth:
    """Compute the outputs in wide arithmetic, and their changes with random signs; -1: input by input."""
    values, status = run(cases, kernel, "wide")
    H = values if kernel == _TRUTH else run(cases, _TRUTH, "wide")[0]
    amount = np.longdouble(1e-12 if precision == "float" else 2.0**-53)
    whole = np.hstack([cases.robots, cases.motions, cases.forces]).astype(np.longdouble)
    rng = np.random.default_rng(whole.shape[1])
    signs = (rng.choice([-1.0, 1.0], whole.shape) for _ in range(samples))
    change = np.zeros(values.shape)
    for step in np.eye(whole.shape[1]) if samples < 0 else signs:
        robots, motions, forces = np.split(whole * (1 + amount * step), (205, 235), axis=1)
        beside, codes = run(Cases(robots, motions, forces, cases.distance), kernel, "wide")
        by = np.abs((beside - values) / amount).astype(np.float64)
        by[(codes != OK) & (status == OK)] = np.inf
        change = change + by if samples < 0 else np.fmax(change, by)
    return Truth(values, status, change, _scaled(cases, H), _frames(cases))


def judge(
    kernel: str,
    values: NDArray[Any],
    status: Codes,
    truth: Truth,
    cases: Cases,
    precision: str = "double",
    floor: bool = False,
) -> Verdict:
    """Compare outputs (n, m) with the truth, block by block; keep the worst block of each case."""
    count, length, known = len(values), _length(cases)[:, None], truth.status == OK
    least = truth.scaled if floor or kernel in FORCES else np.ones(count)
    error, condition = np.full(count, np.nan), np.ones(count)
    solved = (status == OK) & known
    for places, powers in BLOCKS[kernel].values():
        weight, true = length**powers, truth.values[:, places]
        off = (np.abs(values[:, places] - true) * weight).max(axis=1)
        # The forces are differences of D and x.
        whole = np.abs(truth.values[:, :18] if kernel in FORCES else true * weight).max(axis=1)
        whole = np.where(known & (whole > 0), whole, 1.0).astype(np.float64)
        moved = (truth.change[:, places] * weight).max(axis=1)
        own = np.fmax(np.fmax(moved / whole, least), 1.0)
        units = np.where(solved, off / (EPSILON[precision] * whole), np.nan).astype(np.float64)
        worse = np.where(solved, ~(units / own <= error / condition), known & (own > condition))
        for kept, new in ((error, units), (condition, own)):
            kept[worse] = new[worse]
    condition = np.where(known, condition, np.inf)
    pose = np.fmax(np.fmax(condition, truth.scaled), truth.frames)
    return Verdict(error, condition, pose, status, truth.status)


def run(cases: Cases, kernel: str, precision: str) -> tuple[NDArray[Any], Codes]:
    """Run a kernel in "double", "float", or "wide" arithmetic; return outputs (n, m) and statuses (n,)."""
    kind, count = _TYPES[precision], len(cases.robots)
    with np.errstate(over="ignore"):
        inputs = (cases.robots, cases.motions, cases.forces)
        given = [np.ascontiguousarray(each, dtype=kind) for each in inputs]
    width = sum(math.prod(shape) for shape in _SHAPES[kernel].values())
    out, status = np.full((count, width), np.nan, dtype=kind), np.zeros(count, dtype=np.int32)
    getattr(library(precision), kernel)(ctypes.c_size_t(count), *map(address, (*given, out, status)))
    return out, status


def _length(cases: Cases) -> Array:
    """Compute the root mean square distance of the platform points from the reference point, (n,)."""
    p = cases.legs["p"]
    largest = np.abs(p).max(axis=(1, 2))
    square: Array = ((p / largest[:, None, None]) ** 2).sum(axis=(1, 2))
    return np.asarray(largest * np.sqrt(square / 6.0))


def _scaled(cases: Cases, values: NDArray[Any]) -> Array:
    """Compute the condition number of H with moments over a length, from all outputs (n, 78)."""
    H = values[:, 36:72].reshape(-1, 6, 6).astype(np.float64)
    H = np.where(np.isfinite(H), H, 0.0)
    H[:, 3:] /= _length(cases)[:, None, None]
    return np.asarray(np.linalg.cond(H))


def _frames(cases: Cases) -> Array:
    """Compute the effect of a rounding unit on the leg frames: 1 over |k x s|, and terms of S over L."""
    b, p, k = (cases.legs[name].astype(np.longdouble) for name in "bpk")
    R, t = (cases.motion[name].astype(np.longdouble) for name in "Rt")
    q = np.einsum("nij,nlj->nli", R, p)
    t = np.broadcast_to(t[:, None], q.shape)
    S = q + t - b
    with np.errstate(all="ignore"):
        L = np.linalg.norm(S, axis=-1)
        sine = np.linalg.norm(np.cross(k, S / L[..., None]), axis=-1)
        reach = np.max(np.abs([q, t, b]), axis=(0, -1))
        worst = np.fmax(1 / sine, reach / L).max(axis=1)
    return np.asarray(np.fmax(worst, 1.0).astype(np.float64))


def sources() -> dict[str, str]:
    """Return the C sources of the kernels, text by file name."""
    own = (files(__package__) / "kernels.c").read_text(encoding="utf-8")
    return c_sources("exact") | c_sources("exact_motion") | {"kernels.c": own}


@functools.cache
def library(precision: str) -> ctypes.CDLL:
    """Load the kernels in one arithmetic."""
    if np.finfo(np.longdouble).nmant < 63:
        raise native.CompilerError("long double: expected at least 64 bits; use another platform")
    return native.load(f"stewart_stability_{precision}", sources(), _FLAGS[precision])
