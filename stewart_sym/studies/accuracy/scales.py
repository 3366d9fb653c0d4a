"""Rounding errors of the force kernels over size and mass of the machine, in double and in float.

Each arithmetic is compared with a more precise arithmetic with the same input numbers.
"""

import ctypes
import dataclasses
import functools
import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ... import robots
from ...backend import native
from ...backend.c_kernel import address, c_sources, pointers
from ...backend.kernel import MOTION, kernel_name, robot_numbers
from ...backend.numpy_kernel import loaded
from ...dynamics.home_pose import radius
from ...dynamics.inverse_dynamics import inverse_dynamics
from ...generated.interface import MODELS
from ...io.progress import Progress, silent, tracked
from ...kinematics.conditioning import characteristic_length, scaled_condition_number
from ...kinematics.inverse_kinematics import clear_of_joint_singularities, inverse_kinematics
from ...motion.motion import Motion
from ...results import OK
from ...robot.robot import Robot
from ...robot.units import rescaled
from ..common.drawing import Axes, Figure, as_written, legend_below, log_numbers, new_figure
from ..common.output import csv_text
from ..common.random_motions import Spread, random_motions

Array = NDArray[Any]

DOUBLE, FLOAT = "double", "float"
SIZES = tuple(10.0**power for power in range(-4, 4))
"""Radii of the base (m)."""
MASSES = tuple(10.0**power for power in range(-6, 7, 3))
"""Masses of the platform, and of the heaviest part of a leg (kg)."""
MEANT = (1e-3, 10.0)
"""Range of machine sizes for which float is intended (m)."""
BOUND = 100.0
"""Largest expected error (rounding units times the condition number)."""

MAX_CONDITION = 60.0
_DRAWS = 40
_SPREAD = Spread(0.15, 0.2, 0.5)
_COPIES = 50
_STANDARD_GRAVITY = 9.81
_RAGGED = 0.08


_WIDE = "long double"
_ARITHMETIC: Mapping[str, tuple[type[np.floating[Any]], Mapping[str, str | int], tuple[str, ...]]] = {
    DOUBLE: (np.float64, {}, ()),
    FLOAT: (np.float32, {"STEWART_FLOAT": 1}, ()),
    _WIDE: (
        np.longdouble,
        {
            "STEWART_REAL": "long double",
            "STEWART_SQRT(value)": "sqrtl(value)",
            "STEWART_FABS(value)": "fabsl(value)",
            "STEWART_EPSILON": "LDBL_EPSILON",
            "STEWART_MAX": "LDBL_MAX",
        },
        # Optimization improves x87 code little, and compilers are slow.
        ("-include", "float.h", "-include", "math.h", "-O0"),
    ),
}
"""Type of the numbers, and macros and flags of the C compiler."""


@dataclass(frozen=True, eq=False)
class Scales:
    """Errors of the forces over size and mass.

    Attributes
    ----------
    robot : str
        Name of the scaled robot.
    sizes : ndarray, shape (s,)
        Radii of the base (m).
    masses : ndarray, shape (p,)
        Masses of the platform and of the heaviest part of a leg (kg).
    errors : mapping of str to ndarray, shape (s, p, p, n)
        Errors of n poses by arithmetic, in rounding units of that arithmetic times the scaled condition
        number of H times the largest of |F|, |D|, and |x|. Errors are infinite if poses are unsolvable.
        ``double`` is missing if C has no wider type.
    """

    robot: str
    sizes: Array
    masses: Array
    errors: Mapping[str, Array]


def scales_study(
    progress: Progress = silent,
    robot: Robot | None = None,
    sizes: Sequence[float] = SIZES,
    masses: Sequence[float] = MASSES,
    machines: int = 16,
    poses: int = 16,
    seed: int = 1,
) -> Scales:
    """Measure the errors for machines similar to a robot with other sizes and masses.

    Parameters
    ----------
    progress : Progress
        Display of the current masses.
    robot : Robot or None
        Robot; None means the robot of the paper.
    sizes : sequence of float
        Radii of the base (m).
    masses : sequence of float
        Masses of the platform, and of the heaviest part of a leg (kg), in all combinations.
    machines : int
        Number of machines with the same masses: the robot and copies whose joints are displaced by about
        ``_RAGGED`` of the radius.
    poses : int
        Number of random poses near the home pose of each machine, with rates, accelerations, and loads in
        proportion to gravity.
    seed : int
        Random seed.

    Returns
    -------
    Scales
        Errors.

    Raises
    ------
    ValueError
        If the robot has too few poses with a scaled condition number below ``MAX_CONDITION`` and sines of the
        angles between legs and universal axes above ``MIN_JOINT_SINE``.
    native.CompilerError
        Without a C compiler.
    """
    robot = robots.dasgupta1998() if robot is None else robot
    rng = np.random.default_rng(seed)
    checked = [DOUBLE, FLOAT] if _is_wider() else [FLOAT]
    shape = (len(sizes), len(masses), len(masses), machines, poses)
    errors = {name: np.empty(shape) for name in checked}
    pairs = list(np.ndindex(len(masses), len(masses)))
    for p, leg in tracked(
        progress, pairs, lambda pair: f"platform of {masses[pair[0]]:g} kg, legs of {masses[pair[1]]:g} kg"
    ):
        for k in range(machines):
            kind, motion = _case(rng, robot, k > 0, poses)
            factor = masses[leg] / masses[p] * kind.M / float(max(kind.m_d.max(), kind.m_u.max()))
            parts = {name: getattr(kind, name) * factor for name in ("m_d", "m_u", "I_d0", "I_u0")}
            kind = dataclasses.replace(kind, **parts)
            for s, size in enumerate(sizes):
                case = _scaled(kind, motion, size, masses[p])
                for name, found in _errors(*case, checked).items():
                    errors[name][s, p, leg, k] = found
    return Scales(
        robot.name,
        np.array(sizes),
        np.array(masses),
        {name: values.reshape(*shape[:3], machines * poses) for name, values in errors.items()},
    )


# --- machines and poses -----------------------------------------------------------------------


def _case(rng: np.random.Generator, robot: Robot, ragged: bool, poses: int) -> tuple[Robot, Motion]:
    """Return the robot, or a copy with displaced joints and enough poses, and its motions, shape (poses,)."""
    spread, kind = _RAGGED * radius(robot.b), robot
    for _ in range(_COPIES if ragged else 1):
        if ragged:
            b, p = (points + spread * rng.normal(size=(6, 3)) for points in (robot.b, robot.p))
            kind = dataclasses.replace(robot, b=b, p=p)
        motion = _motions(rng, kind, poses)
        if motion.shape == (poses,):
            return kind, motion
    raise ValueError(
        f"robot {robot.name!r}: too few poses around its home with a condition number below "
        f"{MAX_CONDITION:g} and legs clear of their universal axes"
    )


def _motions(rng: np.random.Generator, robot: Robot, count: int) -> Motion:
    """Return up to ``count`` well-conditioned motions at free-fall speed, with loads for 1 kg."""
    drawn = random_motions(rng, robot, _DRAWS * count, _SPREAD, _STANDARD_GRAVITY, 1.0)
    # For most machines the first few motions are sufficient.
    for number in (len(drawn.t) // 8, len(drawn.t)):
        motion = drawn[:number]
        found = inverse_dynamics(robot, motion, on_singular="nan")
        condition = scaled_condition_number(found.H, characteristic_length(robot))
        clear = clear_of_joint_singularities(robot, inverse_kinematics(robot, motion))
        good = np.flatnonzero((found.status == OK) & (condition < MAX_CONDITION) & clear)[:count]
        if len(good) == count:
            break
    return motion[good]


def _scaled(robot: Robot, motion: Motion, size: float, platform: float) -> tuple[Robot, Motion]:
    """Scale the machine to a base radius and a platform mass, and its motion, and round it to float."""
    longer = size / radius(robot.b)
    slower = float(np.sqrt(longer))
    given = loaded(motion)
    moved = Motion._unchecked(
        R=motion.R,
        t=motion.t * longer,
        omega=motion.omega / slower,
        v=motion.v * slower,
        alpha=given.alpha / longer,
        a=given.a,
        F_ext=given.F_ext * platform,
        M_ext=given.M_ext * platform * longer,
    )
    rounded = {name: _rounded(getattr(moved, name)) for name in MOTION}
    return rescaled(robot, longer, platform / robot.M, slower), Motion._unchecked(**rounded)


def _rounded(array: Array) -> Array:
    return array.astype(np.float32).astype(np.float64)


# --- kernels ----------------------------------------------------------------------------------


def _is_wider() -> bool:
    """Return True if long double in C has more digits than double."""
    return bool(np.finfo(np.longdouble).eps < np.finfo(np.float64).eps / 64)


def _errors(robot: Robot, motion: Motion, checked: Sequence[str]) -> dict[str, Array]:
    """Compute errors, shape (n,), by arithmetic from the same input numbers, which float can represent."""
    numbers = _rounded(robot_numbers(robot))
    name = kernel_name("exact", robot.base_joint)
    truth = _forces(name, _WIDE if _is_wider() else DOUBLE, numbers, motion)
    full = inverse_dynamics(robot, motion, on_singular="nan")
    condition = scaled_condition_number(full.H, characteristic_length(robot))
    largest = np.max([np.abs(values).max(axis=-1) for values in (full.F, full.D, full.x)], axis=0)
    errors = {}
    for each in checked:
        found = _forces(name, each, numbers, motion).astype(truth.dtype)
        error = np.abs(found - truth).max(axis=-1).astype(np.float64)
        unit = float(np.finfo(_ARITHMETIC[each][0]).eps) * condition * largest
        errors[each] = np.where(np.isfinite(error), error, np.inf) / unit
    return errors


@functools.cache
def _functions(name: str, arithmetic: str) -> ctypes.CDLL:
    _, defines, flags = _ARITHMETIC[arithmetic]
    return native.load(f"stewart_{name}_forces", c_sources(f"{name}_forces"), flags, defines)


def _forces(name: str, arithmetic: str, numbers: Array, motion: Motion) -> Array:
    """Compute forces (N), shape (n, 6), from the constants of a robot; NaN for unsolvable poses."""
    functions, dtype = _functions(name, arithmetic), _ARITHMETIC[arithmetic][0]
    given = numbers.astype(dtype)
    model = np.zeros(MODELS[name], dtype=dtype)
    count = motion.t.shape[0]
    F = np.full((count, 6), np.nan, dtype=dtype)
    if getattr(functions, f"stewart_{name}_prepare")(address(given), address(model)) == OK:
        arrays = [np.ascontiguousarray(getattr(motion, field), dtype=dtype) for field in MOTION]
        getattr(functions, f"stewart_{name}_forces_batch")(
            address(model),
            ctypes.c_size_t(count),
            pointers(arrays),
            address(F),
            address(np.zeros(count, dtype=np.int32)),
        )
    return F


# --- table and picture ------------------------------------------------------------------------


def csv_rows(data: Scales) -> str:
    """Format a CSV table with all digits: size, masses, and the median and largest error of each
    arithmetic.
    """
    header = ["size_m", "platform_mass_kg", "leg_mass_kg"]
    columns = []
    for name, errors in data.errors.items():
        header += [f"{name}_median", f"{name}_largest"]
        columns += [np.median(errors, axis=-1).ravel(), errors.max(axis=-1).ravel()]
    masses = data.masses.tolist()
    places = itertools.product(data.sizes.tolist(), masses, masses)
    rows = zip(places, np.transpose(columns).tolist(), strict=True)
    return csv_text([header, *((*place, *values) for place, values in rows)])


# Colors of Okabe and Ito, also distinguished by markers and dashes.
_STYLE: Mapping[str, Mapping[str, Any]] = {
    FLOAT: {"color": "#0072b2", "marker": "o", "linestyle": "-"},
    DOUBLE: {"color": "#555555", "marker": "s", "linestyle": (0, (1.2, 1.2))},
}


def figure(data: Scales) -> Figure:
    """Plot largest and median errors over size, over platform mass, and over leg mass, in three panels.

    Each panel evaluates the largest and median error over the other two variables and omits infinite errors.
    """
    picture = new_figure(10.0, 4.4)
    from matplotlib.ticker import LogLocator

    picture.suptitle(
        f"Rounding error of the leg forces, exact, machines similar to {as_written(data.robot)}:\n"
        r"rounding units of each arithmetic $\times$ scaled condition number $\times$ largest force",
        fontsize=10.0,
    )
    panels = picture.subplots(1, 3, sharey=True, width_ratios=(1.3, 1.0, 1.0))
    labels = ("radius of the base, m", "mass of the platform, kg", "heaviest part of a leg, kg")
    steps = (data.sizes, data.masses, data.masses)
    for axis, (axes, label, places) in enumerate(zip(panels, labels, steps, strict=True)):
        _panel(axes, data, axis, places)
        axes.set_xlabel(label)
        axes.xaxis.set_major_locator(LogLocator(numticks=8))
    low, high = panels[0].get_ylim()
    panels[0].set_ylim(0.5 * low, 2.0 * high)
    panels[0].axvspan(*MEANT, color="#0072b2", alpha=0.07, linewidth=0.0)
    panels[0].set_ylabel("error: largest (thick), median (thin)")
    panels[0].annotate(
        "1 mm to 10 m",
        (float(np.sqrt(MEANT[0] * MEANT[1])), 0.0),
        xycoords=("data", "axes fraction"),
        xytext=(0, 4),
        textcoords="offset points",
        ha="center",
        fontsize=8.0,
    )
    log_numbers(panels[0].yaxis)
    legend_below(picture, fontsize=9.0)
    return picture


def _panel(axes: Axes, data: Scales, axis: int, places: Array) -> None:
    """Draw largest errors as lines with markers, medians as thin lines, and the bound."""
    for name, style in _STYLE.items():
        if name not in data.errors:
            continue
        errors = np.moveaxis(data.errors[name], axis, 0).reshape(len(places), -1)
        finite = np.where(np.isfinite(errors), errors, np.nan)
        label = f"{name}: largest {np.nanmax(finite):.3g}"
        axes.loglog(places, np.nanmax(finite, axis=1), label=label, linewidth=1.6, markersize=4.5, **style)
        plain = {**style, "marker": ""}
        axes.loglog(places, np.nanmedian(finite, axis=1), linewidth=1.0, alpha=0.7, **plain)
    axes.axhline(BOUND, color="black", linewidth=0.8, label=f"bound, {BOUND:g}")
