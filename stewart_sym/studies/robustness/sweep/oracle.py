"""Answers of the shipped C checked in wider arithmetic: error over the problem's own condition number.

Compiles the plain elimination kernel for ``long double`` and ``__float128`` beside the shipped kernels in
double and float; wider types share neither regrouping nor preparation with the fast ones. The problem's own
condition number is what relative changes of the inputs by one unit do to F: measured by random changes of
every quantity, over the largest of |F|, |D|, |x|.
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
"""Shipped kernels that are checked."""
CLOSED_KERNELS = tuple(closed_form.OUTPUTS)
"""Shipped kernels of the closed form that are held against wider arithmetic."""
KINDS = (
    *("singular", "joint singularity", "zero-length leg", "scales", "joint and singular", "heavy leg"),
    *("proportions", "far reference point", "singular machine"),
)
"""Failures that random cases come near to, and machines that are singular at every pose."""
DOUBTFUL = 10.0
"""Error over the condition number above which long double is not trusted to tell it, nor random changes of
the inputs the condition number: each input is changed by itself then, and what they do is added up."""
SAMPLES = 3
"""Random changes of the inputs by which a condition number is measured."""

MACHINE = KINDS[-1]
"""The kind whose robots must be singular at every pose: whatever has H to solve must give a status."""

RESULT = np.dtype(
    [
        *((name, np.float64) for name in ("distance", "size", "own", "scaled", "frames")),
        ("error", np.float64, (len(KERNELS),)),
        *((name, np.int32) for name in ("truth", "in_quad")),
        ("status", np.int32, (len(KERNELS),)),
        ("made", np.int32),
    ]
)
"""Of a case: distance from the failure; size, the largest of |F|, |D| and |x|, N; the problem's own condition
number, the scaled one of H and that of the legs' frames, the largest of 1 over |k x s| and of the terms of S
over L; error of each kernel, in rounding units of the size, NaN for unsolvable poses; status of the truth;
whether it was checked in quadruple precision; status of each kernel; whether such a case was found."""

CLOSED_RESULT = np.dtype(
    [
        *((name, np.float64) for name in ("distance", "scaled", "frames")),
        *((name, np.float64, (len(CLOSED_KERNELS),)) for name in ("error", "condition")),
        *((name, np.int32, (len(CLOSED_KERNELS),)) for name in ("block", "status", "truth")),
        *((name, np.int32) for name in ("made", "in_quad")),
    ]
)
"""Of a case: as in ``RESULT``, and of each kernel of ``CLOSED_KERNELS`` the largest error of its blocks, in
rounding units of the block's size times its condition number, -1 where unsolvable; that condition number and
the block's index in ``BLOCKS``. A block's condition number is what changes of every input by a rounding unit
of itself do to it; of kinds "proportions" and "far reference point" at least the scaled one of H."""

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
"""Powers of the platform's size by which the last three rows and columns of six are multiplied."""
_PARTS = {"A": {"A by pose": (6, 0), "A by twist": (6, 6)}, "B": {"B": (6, 0)}}
"""Names of the parts of a matrix of which something is known, six by six, and where they begin."""


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
"""Outputs of the closed form's kernels: kernel, offset, rows, columns, stride, and the powers of the
platform's size by which the last three rows and columns are multiplied to be comparable with the first."""

# A library named before the sources is dropped, as nothing needs it yet, unless the linker must keep it.
_FLAGS = ("-Wl,--no-as-needed", "-lquadmath")
_SOURCES = {
    "wide": ("WIDE", ("wider", "prepare", "closed_form")),
    "quad": ("QUAD", ("wider", "prepare", "closed_form")),
    "double": ("IN_DOUBLE", ("every_output", "forces", "closed_form")),
    "float": ("IN_FLOAT", ("every_output", "forces", "closed_form")),
}
"""Arithmetics: the macro that ``arithmetic.h`` goes by, and the C files that are compiled for each."""


def check_poses(
    robots: Sequence[Robot], motions: Sequence[Motion], precision: str = "double"
) -> NDArray[Any]:
    """Check the answers to poses in quadruple precision: one record of ``RESULT`` each, (n,).

    robots, motions: n each, motions of shape (). Raises native.CompilerError without ``__float128``.
    """
    numbers = np.array([robot_numbers(robot) for robot in robots])
    poses = np.array([motion_numbers(motion) for motion in motions])
    if precision == "float":
        numbers, poses = (array.astype(np.float32).astype(np.float64) for array in (numbers, poses))
    return check_numbers(numbers, poses, precision)


def check_numbers(numbers: Array, poses: Array, precision: str = "double") -> NDArray[Any]:
    """The same of robots and motions as in the C structures, (n, 205) and (n, 30)."""
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
    """Check random cases near a failure, ``each`` of every robot: records of ``RESULT``, (robots * each,).

    kind: of ``KINDS``. numbers: robots as in ``struct stewart_robot``, (robots, 205), and their sizes, m.
    Distances are spread evenly in their logarithm, from 1 to a tenth of a rounding unit. Doubtful answers
    are checked again in quadruple precision. Raises native.CompilerError without ``__float128``.
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
    """The closed form's kernels on the cases of ``check_random``: records of ``CLOSED_RESULT``.

    kernels: which of ``CLOSED_KERNELS``. in_quad: in quadruple precision throughout, else in long double with
    the doubtful ones again. motions: given ones, (robots * each, 30), in place of random ones. Of machines
    that are singular at every pose the statuses alone. Raises native.CompilerError without ``__float128``.
    """
    blocks = np.array([*BLOCKS.values()], dtype=np.int32)
    chosen = sum(1 << CLOSED_KERNELS.index(kernel) for kernel in kernels)
    given = (CLOSED_RESULT, kind, numbers, sizes, each, seed, chosen, blocks, len(blocks), doubtful)
    how: Any = {"precision": precision, "in_quad": in_quad, "samples": samples, "motions": motions}
    return _checked("closed_form_cases", *given, **how)


def random_case(
    kind: str, numbers: Array, sizes: Array, each: int, seed: int, index: int
) -> tuple[Array, Array]:
    """Robot's numbers, (205,), and the motion's, (30,), of the case in double that ``check_random`` has."""
    mine, motion = np.zeros(numbers.shape[1]), np.zeros(30)
    robot = index // each
    drawn = (KINDS.index(kind), False, _nearest("double"), seed, index)
    _call("show_case", *drawn, numbers[robot], sizes[robot], mine, motion)
    return mine, motion


def motion_numbers(motion: Motion) -> Array:
    """A motion of shape () as the numbers of ``struct stewart_motion``, (30,)."""
    given = loaded(motion)
    return np.concatenate([np.ravel(getattr(given, name)) for name in MOTION])


def _nearest(precision: str) -> float:
    """Decades from 1 to the nearest distance."""
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
    """Records of the C function that checks cases; ``last``: its arguments before them."""
    found = np.zeros(len(numbers) * each, dtype=result)
    how = (KINDS.index(kind), precision == "float", in_quad, samples, _nearest(precision), seed)
    _call(function, *how, len(numbers), numbers, sizes, motions, each, *last, found)
    return found


def _call(name: str, *arguments: Any) -> None:
    """Call a function of the sweep's C; arrays by their addresses."""
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
    """File name -> text of the sweep's C.

    Kernels, and what is compiled once for each arithmetic, are headers ``<name>_text.h`` that a source for
    each includes under names of its own.
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
