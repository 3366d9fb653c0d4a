"""Counts of poses at which a force kernel gives other bits for one pose, a batch, its parts, or columns."""

import ctypes
import dataclasses
from collections.abc import Sequence
from pathlib import Path

import attack_build
import numpy as np
from machines import Array, offsets_of, random_robot, with_random_rotors
from motion_fields import FIELDS
from scipy.spatial.transform import Rotation
from unsolvable_poses import semiregular

from stewart_sym.backend.c_kernel import address, pointers
from stewart_sym.backend.kernel import defines_of, offset_numbers, robot_numbers
from stewart_sym.generated.interface import MODELS
from stewart_sym.robot.robot import Robot

GENERATED = attack_build.GENERATED
"""Folder of the generated C."""
KERNELS = tuple(name for name in MODELS if not name.endswith("bounds"))
"""Names of all force kernels."""
PORTABLE = ("-O2",)
"""Optimization that the Makefile of a kit states."""
NATIVE = ("-O3", "-march=native")
"""Optimization of the libraries that ``prepare`` compiles."""
POSES = 8192
_KINDS = 16


def differing(
    folder: Path, kernel: str, compiler: str, flags: Sequence[str], precision: str
) -> tuple[Array, Array]:
    """Differing poses of a batch, its parts, and columns, (3,), and poses by status, (8,)."""
    library = _library(folder, kernel, compiler, flags, precision)
    dtype = np.float64 if precision == "double" else np.float32
    robot = machine(kernel)
    given = offset_numbers(robot) if robot.offsets else robot_numbers(robot, bool(defines_of(kernel)))
    numbers = given.astype(dtype)
    with np.errstate(over="ignore", invalid="ignore"):
        rows = [np.ascontiguousarray(each, dtype=dtype) for each in motions(robot).values()]
    columns = [np.ascontiguousarray(each.reshape(POSES, -1).T) for each in rows]
    counts, statuses = np.zeros(3, dtype=np.uintp), np.zeros(8, dtype=np.uintp)
    arrays = (pointers(rows), pointers(columns))
    of_robot = library.pose_bits(
        address(numbers),
        ctypes.c_size_t(POSES),
        *map(ctypes.byref, arrays),
        address(counts),
        address(statuses),
    )
    assert of_robot == 0
    return counts, statuses


def _library(folder: Path, kernel: str, compiler: str, flags: Sequence[str], precision: str) -> ctypes.CDLL:
    """The kernel, and the comparison compiled apart from it so that nothing is inlined."""
    header = f"stewart_{kernel}_forces.h"
    defines = [f"-D{each}" for each in defines_of(kernel)]
    defines += ["-DSTEWART_FLOAT"] if precision == "float" else []
    common = [compiler, *attack_build.STRICT, "-fPIC", *defines, f"-I{GENERATED}"]
    source = str(GENERATED / header.replace(".h", ".c"))
    named = [f"-DKERNEL={kernel}", f'-DHEADER="{header}"', "-O1"]
    compared = str(attack_build.ATTACK / "pose_bits.c")
    parts = [folder / f"{kernel}_{name}.o" for name in ("kernel", "compared")]
    attack_build.ran([*common, *flags, "-c", source, "-o", str(parts[0])], folder)
    attack_build.ran([*common, *named, "-c", compared, "-o", str(parts[1])], folder)
    made = folder / f"{kernel}.so"
    attack_build.ran([compiler, "-shared", *map(str, parts), "-o", str(made), "-lm"], folder)
    return ctypes.CDLL(str(made))


def machine(kernel: str) -> Robot:
    """A machine of threefold symmetry, for which H is singular at a yaw of 90 degrees."""
    rng = np.random.default_rng(240)
    robot = random_robot(rng, "spherical" if "spherical" in kernel else "universal", scale=1.0)
    base = semiregular([-12, 12, 108, 132, 228, 252], 1.0)
    robot = dataclasses.replace(robot, b=base, p=semiregular([-45, 45, 75, 165, 195, 285], 0.5))
    if "offset" in kernel:
        robot = dataclasses.replace(robot, offsets=offsets_of(rng, robot))
    return with_random_rotors(rng, robot) if "drive" in kernel else robot


def motions(robot: Robot) -> dict[str, Array]:
    """Arrays of a motion; five eighths of the poses are ordinary, the others near or beyond failure."""
    rng = np.random.default_rng(241)
    turns = Rotation.from_rotvec(0.3 * rng.normal(size=(POSES, 3))).as_matrix()
    found = {name: rng.normal(size=(POSES, 3)) for name in FIELDS} | {"R": turns}
    found["t"] = np.array([0.0, 0.0, 1.1]) + 0.15 * found["t"]
    found |= {name: 300.0 * found[name] for name in ("F_ext", "M_ext")}
    small = 10 ** -rng.uniform(0.0, 17.0, POSES)
    for i in range(POSES):
        kind, leg = i % _KINDS, int(rng.integers(6))
        other = found[FIELDS[rng.integers(len(FIELDS))]][i]
        if kind == 10:
            found["R"][i] = Rotation.from_euler("z", np.pi / 2 + small[i]).as_matrix()
            found["t"][i] = 0.0, 0.0, 1.0
        elif kind in (11, 12):
            # Near the axis of a universal joint, and of nearly no length.
            off = rng.normal(size=3)
            along = (robot.k[leg] + small[i] * off) if kind == 11 else small[i] * off
            found["t"][i] = robot.b[leg] - found["R"][i] @ robot.p[leg] + along
        elif kind == 13:
            other.flat[rng.integers(other.size)] = rng.choice([np.nan, np.inf, -np.inf])
        elif kind == 14:
            other *= 10.0 ** rng.uniform(15.0, 300.0)
        elif kind == 15:
            other *= rng.choice([0.0, 1e-310])
    return found
