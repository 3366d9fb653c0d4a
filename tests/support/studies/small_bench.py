"""The bench with few poses and rounds, and machines that are not the paper's."""

import dataclasses
import gc
import sys
from types import ModuleType

import numpy as np
import pytest
from motion_fields import FIELDS
from numpy.typing import NDArray
from quick_compiler import compile_quickly

import stewart_sym as ss
from stewart_sym.backend import native
from stewart_sym.backend.c_kernel import c_sources
from stewart_sym.dynamics import forces
from stewart_sym.generated.interface import MODELS
from stewart_sym.robot.robot import Robot
from stewart_sym.studies.benchmark import bench
from stewart_sym.studies.benchmark.baselines import PEERS
from stewart_sym.studies.benchmark.poses import Poses
from stewart_sym.studies.common import timing

Array = NDArray[np.float64]

CONTESTANTS = (*bench.OURS, *bench.CALLS, *PEERS)


@dataclasses.dataclass(frozen=True)
class Pass:
    """As ``stewart_sym.derive.passes`` hands them out."""

    name: str
    meaning: str
    operations: tuple[int, int]
    sources: dict[str, str]
    model_numbers: int


def padded(numbers: int) -> dict[str, str]:
    """The forces' C with so many numbers more in front of the prepared model."""
    sources = c_sources("exact_forces")
    header, start = "stewart_exact_forces.h", "typedef struct {\n"
    assert start in sources[header]
    sources[header] = sources[header].replace(start, f"{start}    stewart_real padding[{numbers}];\n")
    code, made = "stewart_exact_forces.c", "    stewart_exact_model made;\n"
    assert made in sources[code]
    sources[code] = sources[code].replace(made, made.replace("    ", "    static ", 1))
    return sources


def some_passes() -> tuple[Pass, ...]:
    """Two passes whose models differ; deriving the real ones takes too long here."""
    numbers = MODELS["exact"]
    return (
        Pass("as derived", "steps as stated", (30, 40), padded(1_000), numbers + 1_000),
        Pass("folded", "constants prepared", (10, 20), c_sources("exact_forces"), numbers),
    )


def shorten(patch: pytest.MonkeyPatch) -> None:
    """Samples so short that the figures mean nothing; without Drake, which is not everywhere."""
    compile_quickly(patch)
    patch.delitem(bench.COMPARED, "pydrake")
    derived = ModuleType("stewart_sym.derive.passes")
    derived.passes = some_passes  # type: ignore[attr-defined]
    patch.setitem(sys.modules, derived.__name__, derived)
    few = 2 * forces.LEAST_SHARE
    smaller = [dataclasses.replace(each, poses=min(each.poses, few)) for each in bench.OURS]
    patch.setattr(bench, "OURS", tuple(smaller))
    patch.setattr(bench, "LARGE", few)
    patch.setattr(bench, "QUICK_COMPILATIONS", 1)
    patch.setattr(native, "compiled", lambda *given, make=native.compiled: make(*given, ("-O0",)))
    patch.setattr(timing, "SHORTEST", 1e-5)
    patch.setattr(gc, "collect", lambda: 0)
    patch.setattr(bench, "time_source", lambda: {})
    patch.setattr(bench, "QUICK_ROUNDS", 3)
    patch.setattr(bench, "QUICK_SIZES", (8, 64))


def poses_of(robot: Robot, motion: ss.Motion) -> Poses:
    return Poses(robot, tuple(np.ascontiguousarray(getattr(motion, name)) for name in FIELDS))
