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
MOST = 37
"""Largest size of a part of the batch."""
_KINDS = 16


def differing(
    folder: Path, kernel: str, compiler: str, flags: Sequence[str], precision: str
) -> tuple[Array, Array]:
    """Differing poses of a batch, its parts, and columns, (3,), and poses by status, (8,)."""
    dtype = np.dtype(np.float64 if precision == "double" else np.float32)
    robot = machine(kernel)
    given = offset_numbers(robot) if robot.offsets else robot_numbers(robot, bool(defines_of(kernel)))
    with np.errstate(over="ignore", invalid="ignore"):
        rows = [np.ascontiguousarray(each, dtype=dtype) for each in motions(robot).values()]
    columns = [np.ascontiguousarray(each.reshape(POSES, -1).T) for each in rows]
    poses = np.concatenate([each.reshape(POSES, -1) for each in rows], axis=1)
    library = _library(folder, kernel, compiler, flags, precision)
    count, numbers = ctypes.c_size_t, given.astype(dtype)
    prepare, forces, batch, by_columns = (
        getattr(library, f"stewart_{kernel}_{what}")
        for what in ("prepare", "forces", "forces_batch", "forces_columns")
    )
    room = np.zeros(MODELS[kernel] + 64, dtype=dtype)
    model = ctypes.c_void_p(room.ctypes.data + -room.ctypes.data % 64)
    assert prepare(address(numbers), model) == 0
    out = np.full((4, 6 * POSES * dtype.itemsize), 0xA5, dtype=np.uint8).view(dtype)
    status = np.full((4, POSES), -1, dtype=np.int32)
    for i in range(POSES):
        status[0, i] = forces(model, address(poses, 30 * i), address(out[0], 6 * i))
    batch(model, count(POSES), pointers(rows), address(out[1]), address(status[1]))
    start = 0
    while start < POSES:
        length = min(1 + start % MOST, POSES - start)
        part = [np.ascontiguousarray(each[start : start + length]) for each in rows]
        ends = address(out[2], 6 * start), address(status[2], start)
        batch(model, count(length), pointers(part), *ends)
        start += length
    by_columns(model, count(POSES), count(POSES), pointers(columns), address(out[3]), address(status[3]))
    bits = out.view(f"u{dtype.itemsize}").reshape(4, POSES, 6)
    bits[3] = bits[3].reshape(6, POSES).T
    apart = (bits[1:] != bits[0]).any(axis=-1) | (status[1:] != status[0])
    return apart.sum(axis=1), np.bincount(status[0], minlength=8)


def _library(folder: Path, kernel: str, compiler: str, flags: Sequence[str], precision: str) -> ctypes.CDLL:
    defines = [f"-D{each}" for each in defines_of(kernel)]
    defines += ["-DSTEWART_FLOAT"] if precision == "float" else []
    source, made = str(GENERATED / f"stewart_{kernel}_forces.c"), folder / f"{kernel}.so"
    common = [compiler, *attack_build.STRICT, "-fPIC", "-shared", *defines, f"-I{GENERATED}", *flags]
    attack_build.ran([*common, source, "-o", str(made), "-lm"], folder)
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
