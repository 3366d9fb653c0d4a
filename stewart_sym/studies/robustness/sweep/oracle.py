"""Verification of the shipped C code in wider arithmetic, with errors relative to the condition number.

The plain elimination kernel is compiled for ``long double`` and ``__float128``, and the shipped kernels for
double and float. The wider kernels share neither regrouping nor preparation with the fast ones. The condition
number of the problem is the sensitivity of F to relative changes of the inputs by one unit. It is measured by
random changes of every quantity, relative to the largest of |F|, |D|, and |x|.
"""

import ctypes
import functools
import math
from collections.abc import Sequence
from importlib.resources import files
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....backend import native
from ....backend.c_kernel import address, c_sources
from ....backend.kernel import MOTION, robot_numbers
from ....backend.numpy_kernel import loaded
from ....dynamics import closed_form
from ....io.array_types import Array
from ....motion.motion import Motion
from ....robot.robot import Robot

KERNELS = ("one pose", "batch", "every output")
"""Verified force kernels."""
CLOSED_KERNELS = tuple(closed_form.OUTPUTS)
"""Kernels of the closed form that are compared with wider arithmetic."""
KINDS = (
    *("singular", "joint singularity", "zero-length leg", "scales", "joint and singular", "heavy leg"),
    *("proportions", "far reference point", "singular machine"),
)
"""Failures that random cases approach, and machines that are singular at every pose."""
DOUBTFUL = 10.0
"""Error relative to the condition number above which a case is verified more precisely.

The error is then computed in quadruple precision instead of long double. The condition number is the sum of
the effects of separate changes of each input, instead of random changes of all inputs.
"""
SAMPLES = 3
"""Number of random changes of the inputs for the measurement of a condition number."""

MACHINE = KINDS[-1]
"""Kind whose robots must be singular at every pose: every kernel with a solve of H must return a status."""

RESULT = np.dtype(
    [
        *((name, np.float64) for name in ("distance", "size", "own", "scaled", "frames")),
        ("error", np.float64, (len(KERNELS),)),
        *((name, np.int32) for name in ("truth", "in_quad")),
        ("status", np.int32, (len(KERNELS),)),
        ("made", np.int32),
    ]
)
"""Record of a case.

``distance`` is the distance from the failure. ``size`` is the largest of |F|, |D|, and |x| (N). The field
``own`` is the condition number of the problem, and ``scaled`` is the scaled condition number of H. The field
``frames`` is the condition number of the leg frames, the largest of 1 over |k x s| and of the terms of S over
L. The field ``error`` contains the error of each kernel in rounding units of the size, NaN for unsolvable
poses. The field ``truth`` is the correct status, and ``status`` contains the status of each kernel. The field
``in_quad`` is 1 for verification in quadruple precision, and ``made`` is 1 if such a case was found.
"""

CLOSED_RESULT = np.dtype(
    [
        *((name, np.float64) for name in ("distance", "scaled", "frames")),
        *((name, np.float64, (len(CLOSED_KERNELS),)) for name in ("error", "condition")),
        *((name, np.int32, (len(CLOSED_KERNELS),)) for name in ("block", "status", "truth")),
        *((name, np.int32) for name in ("made", "in_quad")),
    ]
)
"""Record of a case of the closed form: fields of ``RESULT``, and results of each kernel of
``CLOSED_KERNELS``.

``error`` is the largest error of its blocks, in rounding units of the size of the block times its condition
number, -1 if unsolvable. ``condition`` is that condition number, and ``block`` the index of the block in
``BLOCKS``. The condition number of a block is the effect of relative changes of every input by one rounding
unit. For the kinds "proportions" and "far reference point" it is at least the scaled one of H.
"""

_POWERS = {
    **dict.fromkeys(("M", "C"), (-1, -1)),
    **dict.fromkeys(("g", "friction", "bias", "bias_and_friction", "H", "H_dot"), (-1, 0)),
    "acceleration": (1, 0),
    "inertia": (0, 0),
    "F": (0, 0),
    **dict.fromkeys(("by_pose", "by_twist", "by_acceleration"), (0, -1)),
    "A": (1, -1),
    "B": (1, 0),
}
"""Powers of the platform size by which the last three rows and columns of six are multiplied."""
_PARTS = {"A": {"A by pose": (6, 0), "A by twist": (6, 6)}, "B": {"B": (6, 0)}}
"""Names of the 6x6 parts of a matrix with a known error bound, and their first row and column."""


def _blocks() -> dict[str, tuple[int, ...]]:
    found: dict[str, tuple[int, ...]] = {}
    start = 0
    names = [name for outputs in closed_form.OUTPUTS.values() for name in outputs]
    for kernel, (what, outputs) in enumerate(closed_form.OUTPUTS.items()):
        for name, shape in outputs.items():
            columns = shape[1] if len(shape) > 1 else 1
            whole = name if names.count(name) == 1 else f"{name} of {what}"
            whole = what.replace("_", " ") if len(outputs) == 1 else whole
            for part, (row, column) in _PARTS.get(name, {whole: (0, 0)}).items():
                place = start + row * columns + column
                found[part] = (kernel, place, 6, min(columns, 6), columns, *_POWERS[name])
            start += math.prod(shape)
    return found


BLOCKS = _blocks()
"""Outputs of the kernels of the closed form: kernel, offset, rows, columns, stride, and two powers.

The last three rows and columns are multiplied by these powers of the platform size to be comparable with the
first three.
"""

# The linker drops a library that precedes the sources, because nothing requires it yet, unless it must keep
# it.
_FLAGS = ("-Wl,--no-as-needed", "-lquadmath")
_SOURCES = {
    "wide": ("WIDE", ("wider", "prepare", "closed_form")),
    "quad": ("QUAD", ("wider", "prepare", "closed_form")),
    "double": ("IN_DOUBLE", ("every_output", "forces", "closed_form")),
    "float": ("IN_FLOAT", ("every_output", "forces", "closed_form")),
}
"""Macro of ``arithmetic.h`` for each arithmetic, and the C files that are compiled for it."""


def check_poses(
    robots: Sequence[Robot], motions: Sequence[Motion], precision: str = "double"
) -> NDArray[Any]:
    """Verify the results of poses in quadruple precision; return one ``RESULT`` record each, shape (n,).

    ``robots`` and ``motions`` have n entries, motions of shape (). Raises native.CompilerError without
    ``__float128``.
    """
    numbers = np.array([robot_numbers(robot) for robot in robots])
    poses = np.array([motion_numbers(motion) for motion in motions])
    if precision == "float":
        numbers, poses = (array.astype(np.float32).astype(np.float64) for array in (numbers, poses))
    return check_numbers(numbers, poses, precision)


def check_numbers(numbers: Array, poses: Array, precision: str = "double") -> NDArray[Any]:
    """Verify robots and motions stored as C structures, (n, 205) and (n, 30), like ``check_poses``."""
    given = (RESULT, KINDS[0], numbers, np.zeros(len(numbers)), 1, 0)
    return _checked("sweep_cases", *given, DOUBTFUL, precision=precision, in_quad=True, motions=poses)


def check_random(
    kind: str,
    numbers: Array,
    sizes: Array,
    each: int,
    seed: int,
    precision: str = "double",
    samples: int = SAMPLES,
    doubtful: float = DOUBTFUL,
) -> NDArray[Any]:
    """Verify random cases near a failure, ``each`` of every robot.

    Distances are logarithmically uniform from 1 to a tenth of a rounding unit. Cases with a ratio above
    ``doubtful`` are verified again in quadruple precision.

    Parameters
    ----------
    kind : str
        Failure, one of ``KINDS``.
    numbers : ndarray, shape (robots, 205)
        Robots in the layout of ``struct stewart_robot``.
    sizes : ndarray, shape (robots,)
        Sizes of the robots (m).
    each : int
        Number of cases of each robot.
    seed : int
        Random seed.
    precision : str
        "double" or "float".
    samples : int
        Number of random changes of the inputs.
    doubtful : float
        Ratio of error to condition number above which a case is verified again.

    Returns
    -------
    ndarray of RESULT, shape (robots * each,)
        Records.

    Raises
    ------
    native.CompilerError
        Without ``__float128``.
    """
    given = (RESULT, kind, numbers, sizes, each, seed)
    return _checked("sweep_cases", *given, doubtful, precision=precision, samples=samples)


def closed_form_errors(
    kind: str,
    numbers: Array,
    sizes: Array,
    each: int,
    seed: int,
    precision: str = "double",
    samples: int = SAMPLES,
    kernels: tuple[str, ...] = CLOSED_KERNELS,
    in_quad: bool = False,
    motions: Array | None = None,
    doubtful: float = DOUBTFUL,
) -> NDArray[Any]:
    """Verify the kernels of the closed form for the cases of ``check_random``; return ``CLOSED_RESULT``
    records.

    ``kernels`` are some of ``CLOSED_KERNELS``. ``in_quad`` uses quadruple precision for all cases; otherwise
    long double is used, and quadruple precision for cases above ``doubtful``. ``motions``, shape (robots *
    each, 30), replace random motions. For machines that are singular at every pose, only the statuses are
    verified. Raises native.CompilerError without ``__float128``.
    """
    blocks = np.array([*BLOCKS.values()], dtype=np.int32)
    chosen = sum(1 << CLOSED_KERNELS.index(kernel) for kernel in kernels)
    given = (CLOSED_RESULT, kind, numbers, sizes, each, seed, chosen, blocks, len(blocks), doubtful)
    how: Any = {"precision": precision, "in_quad": in_quad, "samples": samples, "motions": motions}
    return _checked("closed_form_cases", *given, **how)


def random_case(
    kind: str, numbers: Array, sizes: Array, each: int, seed: int, index: int
) -> tuple[Array, Array]:
    """Return the numbers of the robot, (205,), and of the motion, (30,), of a double-precision case of
    ``check_random``.
    """
    mine, motion = np.zeros(numbers.shape[1]), np.zeros(30)
    robot = index // each
    drawn = (KINDS.index(kind), False, _nearest("double"), seed, index)
    _call("show_case", *drawn, numbers[robot], sizes[robot], mine, motion)
    return mine, motion


def motion_numbers(motion: Motion) -> Array:
    """Return a motion of shape () in the layout of ``struct stewart_motion``, (30,)."""
    given = loaded(motion)
    return np.concatenate([np.ravel(getattr(given, name)) for name in MOTION])


def _nearest(precision: str) -> float:
    """Return the number of decades from 1 to the smallest distance."""
    epsilon = np.finfo(np.float64 if precision == "double" else np.float32).eps
    return float(1.0 - np.log10(epsilon))


def _checked(
    function: str,
    result: np.dtype[Any],
    kind: str,
    numbers: Array,
    sizes: Array,
    each: int,
    seed: int,
    *last: Any,
    precision: str = "double",
    in_quad: bool = False,
    samples: int = SAMPLES,
    motions: Array | None = None,
) -> NDArray[Any]:
    """Return the records of a C function that checks cases; ``last`` are its arguments before the records."""
    found = np.zeros(len(numbers) * each, dtype=result)
    how = (KINDS.index(kind), precision == "float", in_quad, samples, _nearest(precision), seed)
    _call(function, *how, len(numbers), numbers, sizes, motions, each, *last, found)
    return found


def _call(name: str, *arguments: Any) -> None:
    """Call a C function of the sweep with arrays passed by address."""
    kept = [np.ascontiguousarray(each) if isinstance(each, np.ndarray) else each for each in arguments]
    function = getattr(_library(), name)
    function.argtypes = _TYPES[name]
    function(*(address(each) if isinstance(each, np.ndarray) else each for each in kept))


_INT, _REAL, _SEED = ctypes.c_int, ctypes.c_double, ctypes.c_uint64
_SIZE, _AT = ctypes.c_size_t, ctypes.c_void_p
_CASES = [_INT, _INT, _INT, _INT, _REAL, _SEED, _SIZE, _AT, _AT, _AT, _SIZE]
_TYPES: dict[str, list[Any]] = {
    "sweep_cases": [*_CASES, _REAL, _AT],
    "closed_form_cases": [*_CASES, _INT, _AT, _INT, _REAL, _AT],
    "show_case": [_INT, _INT, _REAL, _SEED, _SIZE, _AT, _REAL, _AT, _AT],
}


def sources() -> dict[str, str]:
    """Generate the C sources of the sweep, text by file name.

    Kernels, and code that is compiled once for each arithmetic, are headers ``<name>_text.h``. One source for
    each arithmetic includes them with names of its own.
    """
    every = c_sources("exact") | closed_form.c_sources()
    here = [path for path in files(__package__).iterdir() if path.name.endswith((".c", ".h"))]
    own = {path.name: path.read_text(encoding="utf-8") for path in here}
    repeated = {part for _, parts in _SOURCES.values() for part in parts}
    found = {}
    for name, text in (every | own).items():
        stem = name.removesuffix(".c")
        as_header = name.endswith(".c") and (name in every or stem in repeated)
        found[f"{stem}_text.h" if as_header else name] = text
    for name, (macro, parts) in _SOURCES.items():
        for part in parts:
            found[f"{name}_{part}.c"] = f'#define {macro}\n#include "{part}_text.h"\n'
    return found


@functools.cache
def _library() -> ctypes.CDLL:
    return native.load("stewart_sweep", sources(), _FLAGS)
