"""Machines near the joint singularity of a leg, and what a rounding unit of every number does to each answer.

The generated closed form is compiled for ``__float128`` as truth, and run once more for each input number
(robot, motion, actuator forces) with that number changed by a share of itself: the sum of the absolute
changes is the machine's own sensitivity.
"""

import ctypes
import dataclasses
import functools
from collections.abc import Sequence
from typing import Any

import numpy as np
from leaning_legs import leaning
from machines import Array, random_motion, random_robot

import stewart_sym as ss
from stewart_sym.backend import native
from stewart_sym.backend.c_kernel import address
from stewart_sym.backend.kernel import MOTION, robot_numbers
from stewart_sym.backend.numpy_kernel import loaded
from stewart_sym.dynamics.closed_form import OUTPUTS, c_sources
from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot

EPSILON = np.finfo(np.float64).eps
KINDS = (
    *("lean", "two lean", "all lean", "short", "heavy", "short and heavy", "lean and heavy"),
    *("axisymmetric", "slender"),
)
WHOLE = ("equations", "bias", "forward_dynamics", "joint_inertia", "derivatives", "linearisation")
BLOCKS = {
    name: shape for what in WHOLE for name, shape in ((f"{what}.{n}", s) for n, s in OUTPUTS[what].items())
}
"""Every output, with the shape of a pose's part, in the order in which the truth stores them."""

_MACROS = {
    "STEWART_REAL": "__float128",
    "STEWART_SQRT": "sqrtq",
    "STEWART_FABS": "fabsq",
    "STEWART_EPSILON": "FLT128_EPSILON",
    "STEWART_MAX": "FLT128_MAX",
}
_FLAGS = ("-include", "quadmath.h", "-Wl,--no-as-needed", "-lquadmath", "-O0")


def shortened(robot: Robot, motion: Motion, leg: int, length: float) -> Robot:
    """The machine with the base point of a leg moved along the leg until it is this long, m."""
    found = ss.inverse_kinematics(robot, motion)
    b = robot.b.copy()
    b[leg] += (found.L[leg] - length) * found.s[leg]
    return dataclasses.replace(robot, b=b)


def heavier(robot: Robot, leg: int, times: float) -> Robot:
    """The machine with the masses and inertias of a leg multiplied."""
    parts = {name: getattr(robot, name).copy() for name in ("m_d", "m_u", "I_d0", "I_u0")}
    for part in parts.values():
        part[leg] *= times
    return dataclasses.replace(robot, **parts)


def axisymmetric(robot: Robot, axial_inertia: float) -> Robot:
    """The machine with legs that are axisymmetric, their axial inertias times a number."""
    I_d0, I_u0 = (
        np.array([np.diag([axial_inertia * own[0, 0], own[1, 1], own[1, 1]]) for own in each])
        for each in (robot.I_d0, robot.I_u0)
    )
    axial = np.array([1.0, 0.0, 0.0])
    return dataclasses.replace(robot, I_d0=I_d0, I_u0=I_u0, r_d0=robot.r_d0 * axial, r_u0=robot.r_u0 * axial)


def random_case(rng: np.random.Generator, kind: str, deepest: float = 12.0) -> tuple[Robot, Motion, Array]:
    """A machine near a degenerate leg, its motion and actuator forces of the size that the motion needs."""
    robot = random_robot(rng, friction=bool(rng.integers(2)))
    motion = random_motion(rng, robot)
    if rng.integers(4) == 0:
        motion = dataclasses.replace(motion, omega=np.zeros(3), v=np.zeros(3))
    sine = 10 ** -rng.uniform(0.0, deepest)
    legs = rng.permutation(6)[: {"two lean": 2, "all lean": 6}.get(kind, 1)]
    if kind in ("axisymmetric", "slender"):
        robot = axisymmetric(robot, float(kind == "axisymmetric"))
    if "short" in kind:
        robot = shortened(robot, motion, legs[0], 10 ** -rng.uniform(0.0, 7.0))
    if kind not in ("short", "heavy", "short and heavy"):
        for leg in legs:
            share = 1 if leg == legs[0] else rng.uniform(0.1, 1)
            robot = leaning(robot, motion, sine * share, leg, rng.normal(size=3))
    if "heavy" in kind:
        robot = heavier(robot, legs[0], 10 ** rng.uniform(0.0, 6.0))
    F = ss.inverse_dynamics(robot, motion).F
    return robot, motion, F + 0.1 * np.abs(F).max() * rng.normal(size=6)


@dataclasses.dataclass(frozen=True, eq=False)
class Truth:
    """Status of each function, and by output the value as high + low, and the sensitivity."""

    status: dict[str, int]
    high: dict[str, Array]
    low: dict[str, Array]
    sensitivity: dict[str, Array]


def truth(
    robot: Robot, motion: Motion, F: Array, samples: int = 0, plain: bool = False, rotation: bool = False
) -> Truth:
    """Every output in quadruple precision, and what one rounding unit of each input number does to it.

    plain: without the code paths for lost digits, so that the truth shares nothing with them; it then loses
    digits itself, of 34, like the square of the sine's inverse and more.

    rotation: with R made a rotation to all of 34 digits; the two agree for no other.

    samples: 0 for the sum over all numbers of absolute changes; else that many changes of all at once with
    random signs, the largest of which is taken: never more than the sum, and cheaper.
    """
    given = loaded(motion)
    numbers = np.concatenate([robot_numbers(robot), *(np.ravel(getattr(given, name)) for name in MOTION), F])
    size = sum(int(np.prod(shape)) for shape in BLOCKS.values())
    high, low, sensitivity = (np.full(size, np.nan) for _ in range(3))
    status = np.zeros(len(WHOLE), dtype=np.int32)
    _library().near_joint(
        address(numbers),
        ctypes.c_int(samples),
        ctypes.c_int(plain),
        ctypes.c_int(rotation),
        address(high),
        address(low),
        address(sensitivity),
        address(status),
    )
    return Truth(
        dict(zip(WHOLE, status.tolist(), strict=True)),
        _apart(high),
        _apart(low),
        _apart(sensitivity),
    )


def _apart(flat: Array) -> dict[str, Array]:
    ends = np.cumsum([int(np.prod(shape)) for shape in BLOCKS.values()])
    return dict(zip(BLOCKS, np.split(flat, ends[:-1]), strict=True))


def blocks(name: str, value: Array) -> list[Array]:
    """Parts of an output that have one unit: threes of rows and of columns, but where these are legs."""
    value = value.reshape(BLOCKS[name])
    what, _, output = name.partition(".")
    rows = [value] if what in ("derivatives", "joint_inertia") else np.split(value, len(value) // 3)
    if value.ndim == 1 or what == "joint_inertia" or output in ("B", "H", "H_dot"):
        return rows
    return [part for row in rows for part in np.split(row, value.shape[1] // 3, axis=1)]


def excess(true: Truth, found: dict[str, Array]) -> dict[str, float]:
    """Error of each output over the sensitivity, the worst of its blocks: inf where it is not finite."""
    worst = {}
    for name, value in found.items():
        error = np.abs((np.ravel(value) - true.high[name]) - true.low[name])
        parts = zip(
            *(blocks(name, each) for each in (error, true.sensitivity[name], np.abs(true.high[name]))),
            strict=True,
        )
        ratios = [_ratio(e, max(s.max(), EPSILON * v.max())) for e, s, v in parts]
        worst[name] = max(ratios)
    return worst


def _ratio(error: Array, allowed: float) -> float:
    if not np.isfinite(error).all():
        return np.inf
    return float(error.max() / allowed) if allowed > 0 else float(0 if error.max() == 0 else np.inf)


def outputs(
    closed: Any, motion: Motion, F: Array, functions: Sequence[str] = WHOLE
) -> tuple[dict[str, Array], dict[str, int]]:
    """Every output of a closed form's kernels by the names of ``BLOCKS``, and each function's status."""
    found, status = {}, {}
    for what in functions:
        result = closed.run(what, motion, F if what in ("forward_dynamics", "linearisation") else None)
        status[what] = int(result.pop("status"))
        found |= {f"{what}.{name}": value for name, value in result.items()}
    return found, status


def of_reference(robot: Robot, motion: Motion, F: Array) -> tuple[dict[str, Array], dict[str, int]]:
    """What the vector reference has of the same, by the same names, and each function's status."""
    terms = ss.equations_of_motion(robot, motion, backend="reference", on_singular="nan")
    inertia = ss.joint_space_inertia(robot, motion, backend="reference", on_singular="nan")
    a, alpha = ss.forward_dynamics(robot, motion, F, backend="reference", on_singular="nan")
    found = {f"equations.{name}": getattr(terms, name) for name in ("M", "C", "g", "friction", "bias")}
    found |= {"bias.bias": terms.bias, "joint_inertia.inertia": inertia}
    found |= {"forward_dynamics.acceleration": np.concatenate([a, alpha])}
    status = dict.fromkeys(("equations", "bias", "joint_inertia", "forward_dynamics"), int(terms.status))
    return found, status


@functools.cache
def _library() -> ctypes.CDLL:
    sources = {**c_sources(), "near_joint.c": _source()}
    for name, value in PLAIN.items():
        text, define = sources["stewart_exact_motion.c"], f"#define {name} ((stewart_real){value})"
        assert define in text
        switched = f"extern _Thread_local int near_plain;\n#define {name} REAL(near_plain ? 0 : {value})"
        sources["stewart_exact_motion.c"] = text.replace(define, switched)
    return native.load("stewart_near_joint", sources, _FLAGS, _MACROS)


PLAIN = {"STEWART_LEANING": "0.125", "STEWART_KEPT": "0.0625"}
"""Macros of the thresholds at which the code paths for lost digits begin."""


def _source() -> str:
    calls, offset = [], 0
    for index, what in enumerate(WHOLE):
        size = sum(int(np.prod(shape)) for shape in OUTPUTS[what].values())
        argument = "at->F, " if what in ("forward_dynamics", "linearisation") else ""
        struct = what in ("equations", "derivatives", "linearisation")
        target = f"(stewart_{what} *)&out[{offset}]" if struct else f"&out[{offset}]"
        calls.append(f"    status[{index}] = stewart_exact_{what}(&model, &at->motion, {argument}{target});")
        offset += size
    return (
        _SOURCE.replace("@CALLS@", "\n".join(calls))
        .replace("@SIZE@", str(offset))
        .replace("@FUNCTIONS@", str(len(WHOLE)))
    )


_SOURCE = """\
#include <stdint.h>
#include "stewart_exact_motion.h"

#define NUMBERS ((int)(sizeof(given) / sizeof(stewart_real)))

typedef struct {
    stewart_robot robot;
    stewart_motion motion;
    stewart_real F[6];
} given;

static void run(const given *at, stewart_real out[@SIZE@], int status[@FUNCTIONS@])
{
    stewart_exact_model model;
    int i;
    for (i = 0; i < @SIZE@; ++i) {
        out[i] = nanq("");
    }
    stewart_exact_prepare(&at->robot, &model);
@CALLS@
}

_Thread_local int near_plain;

/* Rows of R, each made perpendicular to those before it, of length one. */
static void rotate(stewart_real *R)
{
    int i, j, k;
    for (i = 0; i < 9; i += 3) {
        stewart_real size = 0;
        for (j = 0; j < i; j += 3) {
            const stewart_real along = R[i] * R[j] + R[i + 1] * R[j + 1] + R[i + 2] * R[j + 2];
            for (k = 0; k < 3; ++k) {
                R[i + k] -= along * R[j + k];
            }
        }
        size = sqrtq(R[i] * R[i] + R[i + 1] * R[i + 1] + R[i + 2] * R[i + 2]);
        for (k = 0; k < 3; ++k) {
            R[i + k] /= size;
        }
    }
}

void near_joint(
    const double *numbers, int samples, int plain, int rotation, double *high, double *low,
    double *sensitivity, int *status)
{
    const stewart_real share = ldexpq(1, -70), unit = ldexpq(1, -52);
    uint64_t seed = 88172645463325252ULL;
    static _Thread_local stewart_real out[@SIZE@], moved[@SIZE@], total[@SIZE@];
    given at;
    stewart_real *to = (stewart_real *)&at;
    int i, j, unused[@FUNCTIONS@];
    for (i = 0; i < NUMBERS; ++i) {
        to[i] = numbers[i];
    }
    near_plain = plain;
    if (rotation) {
        rotate(at.motion.R);
    }
    run(&at, out, status);
    for (i = 0; i < @SIZE@; ++i) {
        total[i] = 0;
        high[i] = (double)out[i];
        low[i] = (double)(out[i] - high[i]);
    }
    for (j = 0; j < (samples > 0 ? samples : NUMBERS); ++j) {
        given other = at;
        stewart_real *number = (stewart_real *)&other;
        if (samples == 0) {
            if (numbers[j] == 0) {
                continue;
            }
            number[j] += number[j] * share;
        }
        for (i = 0; samples > 0 && i < NUMBERS; ++i) {
            seed ^= seed << 13;
            seed ^= seed >> 7;
            seed ^= seed << 17;
            number[i] += number[i] * (seed >> 63 ? share : -share);
        }
        run(&other, moved, unused);
        for (i = 0; i < @SIZE@; ++i) {
            const stewart_real change = fabsq(moved[i] - out[i]) / share * unit;
            total[i] = samples == 0 ? total[i] + change : fmaxq(total[i], change);
        }
    }
    for (i = 0; i < @SIZE@; ++i) {
        sensitivity[i] = (double)total[i];
    }
}
"""
