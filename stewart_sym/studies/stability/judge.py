"""Answers of the shipped C judged in wider arithmetic: error over the problem's own condition number.

Compiles the plain elimination kernel for ``long double`` and ``__float128`` beside the shipped kernels in
double and float; wider types share neither regrouping nor preparation with the fast ones. The problem's own
condition number is what relative changes of the inputs by one unit do to F: measured by random changes of
every quantity, over the largest of |F|, |D|, |x|. Knows the layout of ``stewart.h`` and no equation.
"""

import ctypes
import functools
import re
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ... import native
from ...kernel import MOTION, address, c_sources, loaded, robot_numbers
from ...motion import Motion
from ...robot import Robot
from . import judge_source

Array = NDArray[np.float64]

KERNELS = ("one pose", "batch", "every output")
"""Shipped kernels that are judged."""
KINDS = ("singular", "pole", "short leg", "scales", "pole and singular")
"""Failures that random cases come near to."""
SAMPLES = 3
"""Random changes of the inputs by which a condition number is measured."""

RESULT = np.dtype(
    [
        ("distance", np.float64),
        ("size", np.float64),
        ("own", np.float64),
        ("scaled", np.float64),
        ("frames", np.float64),
        ("error", np.float64, (len(KERNELS),)),
        ("truth", np.int32),
        ("in_quad", np.int32),
        ("status", np.int32, (len(KERNELS),)),
        ("made", np.int32),
    ]
)
"""Of a case: distance from the failure; size, the largest of |F|, |D| and |x|, N; the problem's own condition
number, the scaled one of H and that of the legs' frames, the largest of 1 over |k x s| and of the terms of S
over L; error of each kernel, in rounding units of the size, NaN without an answer; status of the truth;
whether it was judged in quadruple precision; status of each kernel; whether such a case was found."""

# Of the linker's libraries that stand before the sources, only those kept by force are linked.
_FLAGS = ("-Wl,--no-as-needed", "-lquadmath")
_WIDER = {
    "wide": ("long double", "sqrtl", "fabsl", "LDBL_EPSILON", "LDBL_MAX", "<math.h>"),
    "quad": ("__float128", "sqrtq", "fabsq", "FLT128_EPSILON", "FLT128_MAX", "<quadmath.h>"),
}
_OWN = {"double": "", "float": "#define STEWART_FLOAT 1"}


def judge_poses(
    robots: Sequence[Robot], motions: Sequence[Motion], precision: str = "double", samples: int = SAMPLES
) -> NDArray[Any]:
    """Judge the answers to poses in quadruple precision: one record of ``RESULT`` each, (n,).

    robots, motions: n each, motions of shape (). Raises native.CompilerError without ``__float128``.
    """
    numbers = np.array([robot_numbers(robot) for robot in robots])
    poses = np.array([motion_numbers(motion) for motion in motions])
    if precision == "float":
        numbers, poses = (array.astype(np.float32).astype(np.float64) for array in (numbers, poses))
    results = np.zeros(len(numbers), dtype=RESULT)
    _judge(0, precision, True, samples, 0.0, 0, numbers, np.zeros(len(numbers)), poses, 1, results)
    return results


def judge_random(
    kind: str,
    numbers: Array,
    sizes: Array,
    each: int,
    seed: int,
    precision: str = "double",
    samples: int = SAMPLES,
) -> NDArray[Any]:
    """Judge random cases near a failure, ``each`` of every robot: records of ``RESULT``, (robots * each,).

    kind: of ``KINDS``. numbers: robots as in ``struct stewart_robot``, (robots, 205), and their sizes, m.
    Distances are spread evenly in their logarithm, from 1 to a tenth of a rounding unit. Doubtful answers
    are judged again in quadruple precision. Raises native.CompilerError without ``__float128``.
    """
    results = np.zeros(len(numbers) * each, dtype=RESULT)
    _judge(
        KINDS.index(kind),
        precision,
        False,
        samples,
        _nearest(precision),
        seed,
        numbers,
        sizes,
        None,
        each,
        results,
    )
    return results


def random_case(
    kind: str, numbers: Array, sizes: Array, each: int, seed: int, index: int, precision: str = "double"
) -> tuple[Array, Array]:
    """Robot's numbers, (205,), and the motion's, (30,), of the case that ``judge_random`` has at an index."""
    mine, motion = np.zeros(numbers.shape[1]), np.zeros(30)
    _library().show_case(
        ctypes.c_int(KINDS.index(kind)),
        ctypes.c_int(precision == "float"),
        ctypes.c_double(_nearest(precision)),
        ctypes.c_uint64(seed),
        ctypes.c_size_t(index),
        address(np.ascontiguousarray(numbers[index // each])),
        ctypes.c_double(sizes[index // each]),
        address(mine),
        address(motion),
    )
    return mine, motion


def motion_numbers(motion: Motion) -> Array:
    """A motion of shape () as the numbers of ``struct stewart_motion``, (30,)."""
    given = loaded(motion)
    return np.concatenate([np.ravel(getattr(given, name)) for name in MOTION])


def _nearest(precision: str) -> float:
    """Decades from 1 to the nearest distance."""
    epsilon = np.finfo(np.float64 if precision == "double" else np.float32).eps
    return float(1.0 - np.log10(epsilon))


def _judge(
    kind: int,
    precision: str,
    in_quad: bool,
    samples: int,
    nearest: float,
    seed: int,
    numbers: Array,
    sizes: Array,
    motions: Array | None,
    each: int,
    results: NDArray[Any],
) -> None:
    _library().judge_cases(
        ctypes.c_int(kind),
        ctypes.c_int(precision == "float"),
        ctypes.c_int(in_quad),
        ctypes.c_int(samples),
        ctypes.c_double(nearest),
        ctypes.c_uint64(seed),
        ctypes.c_size_t(len(numbers)),
        address(np.ascontiguousarray(numbers)),
        address(np.ascontiguousarray(sizes)),
        address(None if motions is None else np.ascontiguousarray(motions)),
        ctypes.c_size_t(each),
        address(results),
    )


@functools.cache
def _library() -> ctypes.CDLL:
    every, forces = c_sources("exact"), c_sources("exact_forces")
    sources = {name: text for name, text in (every | forces).items() if name.endswith(".h")}
    sources["judge.h"] = judge_source.HEADER
    # Compiled several times, each under names of its own: no source of itself.
    for name, kernel in (("exact", every), ("exact_forces", forces)):
        sources[f"stewart_{name}_text.h"] = kernel[f"stewart_{name}.c"]
    declared = []
    for name, (real, root, size, epsilon, largest, header) in _WIDER.items():
        wider = judge_source.WIDER.replace("#define STEWART_REAL", f"#include {header}\n#define STEWART_REAL")
        marks = {"REAL": real, "SQRT": root, "FABS": size, "EPSILON": epsilon, "MAX": largest}
        sources[f"{name}.c"] = _filled(wider, name, every["stewart_exact.c"], marks)
        declared.append(_declaration(sources[f"{name}.c"], f"{name}_judge"))
    for name, define in _OWN.items():
        for part, text, source in (
            ("every", judge_source.EVERY, every["stewart_exact.c"]),
            ("forces", judge_source.FORCES, forces["stewart_exact_forces.c"]),
        ):
            sources[f"{name}_{part}.c"] = _filled(text, name, source, {"TYPE": define})
            declared.append(_declaration(sources[f"{name}_{part}.c"], f"{name}_{part}"))
    sources["cases.c"] = judge_source.CASES.replace("@DECLARED@", "\n".join(declared))
    return native.load("stewart_judge", sources, _FLAGS)


def _filled(text: str, name: str, kernel: str, marks: dict[str, str]) -> str:
    functions = re.findall(r"^int (stewart_\w+)\(", kernel, re.MULTILINE)
    renamed = "\n".join(f"#define {function} {name}_{function}" for function in functions)
    for mark, value in {**marks, "NAME": name, "RENAMED": renamed}.items():
        text = text.replace(f"@{mark}@", value)
    return text


def _declaration(text: str, function: str) -> str:
    found = re.search(rf"^\w+ {function}\([^)]*\)", text, re.MULTILINE)
    if found is None:
        raise LookupError(function)
    return f"{found[0]};"
