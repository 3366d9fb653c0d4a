"""FMI units of some machines, unpacked, with their kernels beside them and an instance to step."""

import functools
import io
import re
import tempfile
import zipfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import fmpy
import machines
import numpy as np
import pytest
from fmpy.fmi2 import FMU2Slave, defaultCallbacks, fmi2CallbackFunctions, fmi2CallbackLoggerTYPE
from kits import c_of, few_vectors
from numpy.typing import NDArray
from sweeps import slow_but

from stewart_sym.backend import native
from stewart_sym.backend.kernel import MOTION
from stewart_sym.derive.package import fmu
from stewart_sym.derive.package.functions import Part
from stewart_sym.derive.package.robot_source import Machine
from stewart_sym.derive.package.text_format import robot_symbol
from stewart_sym.dynamics.forces import ForceKernel
from stewart_sym.dynamics.home_pose import home_pose
from stewart_sym.kit import Choice, kit
from stewart_sym.kit.fmu import packed
from stewart_sym.kit.required_kernels import parts
from stewart_sym.kit.required_kernels import robot_numbers as fields
from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot

Array = NDArray[np.float64]

CASES = {
    "lanes": Choice(fmu="forces"),
    "scalar": Choice(scalar=True, fmu="forces"),
    "baked": Choice(bake=True, fmu="forces"),
    "float": Choice(precision="float", fmu="forces"),
}
EVERY = slow_but(("lanes", "float"), CASES)
PREPARED = [case for case in EVERY if case.values != ("baked",)]
FORCES = range(30, 36)
NOT_FINITE, ZERO_LENGTH, SINGULAR = 1, 2, 4


@dataclass(frozen=True)
class Made:
    """A unit and what it was made of."""

    robot: Robot
    kernel: Part
    sources: dict[str, str]
    content: bytes

    @property
    def symbol(self) -> str:
        return robot_symbol(self.robot.name)


def unit(robot: Robot, sources: dict[str, str]) -> bytes:
    """A unit of the kernel in lanes."""
    start = {"R": np.eye(3).tolist(), "t": home_pose(robot).t.tolist()}
    machine = Machine(robot.name, fields(robot), {}, None, "1.2.3")
    texts = fmu.unit(machine, "forces", [made("lanes").kernel], sources, "double", start)
    return packed(robot_symbol(robot.name), texts)


@functools.cache
def made(case: str) -> Made:
    robot = machines.dasgupta()
    with few_vectors(), pytest.MonkeyPatch.context() as patch:
        patch.setattr(native, "PORTABLE_FLAGS", flags(case))
        whole = kit(robot, CASES[case])
    unused = (
        "stewart_kit.h",
        "example/main.c",
        "test/selftest.c",
        "stewart_rotation.h",
        "stewart_rotation.c",
    )
    sources = {name: text for name, text in c_of(whole).items() if name not in unused}
    kernel = parts(robot, CASES[case]).parts[0]
    return Made(robot, kernel, sources, whole.files[f"{robot_symbol(robot.name)}.fmu"])


def flags(case: str) -> tuple[str, ...]:
    """Of the compiler: -O0 gives the same bits in a quarter of the time; one unit is compiled as it ships."""
    return native.PORTABLE_FLAGS if case == "baked" else (*native.PORTABLE_FLAGS, "-O0")


@functools.cache
def folder(case: str) -> Path:
    """The unit, unpacked for as long as the tests run."""
    place = Path(KEEP.name) / case
    with zipfile.ZipFile(io.BytesIO(made(case).content)) as archive:
        archive.extractall(place)
    return place


KEEP = tempfile.TemporaryDirectory(prefix="stewart-sym-fmu-", ignore_cleanup_errors=True)


def assert_forces(found: Array, case: str, rows: Array, robot: Robot | None = None) -> None:
    """Forces (n, 6) are the package's own of motions (n, 30), to rounding."""
    precision = CASES[case].precision
    kernel = ForceKernel(made(case).robot if robot is None else robot, precision=precision)
    parts = np.split(rows, np.cumsum([9, *[3] * 6]), axis=1)
    arrays = dict(zip(MOTION, [parts[0].reshape(-1, 3, 3), *parts[1:]], strict=True))
    expected = kernel.forces(Motion._unchecked(**arrays))
    error = np.abs(np.asarray(found) - expected).max(axis=-1)
    assert (error <= {"double": 1e-11, "float": 1e-3}[precision] * np.abs(expected).max(axis=-1)).all()


def rows_of(motion: Motion) -> Array:
    """Motions as the unit's inputs in their order, (n, 30)."""
    fields = [getattr(motion, name) for name in MOTION]
    count = len(motion.t)
    return np.concatenate(
        [np.zeros((count, 3)) if value is None else value.reshape(count, -1) for value in fields], axis=1
    )


# --- an instance ------------------------------------------------------------------------------


@contextmanager
def loaded(case: str, place: Path | None = None) -> Iterator[FMU2Slave]:
    where = folder(case) if place is None else place
    told = fmpy.read_model_description(str(where))
    slave = FMU2Slave(
        guid=told.guid,
        unzipDirectory=str(where),
        modelIdentifier=told.coSimulation.modelIdentifier,
        instanceName="one",
    )
    try:
        yield slave
    finally:
        slave.freeLibrary()


def told_to(log: Callable[[int, bytes, bytes], object]) -> fmi2CallbackFunctions:
    """What an instance calls: the memory's functions, and the log's with status, category and message."""
    allocate, free = defaultCallbacks.allocateMemory, defaultCallbacks.freeMemory
    callbacks = fmi2CallbackFunctions(allocateMemory=allocate, freeMemory=free)
    callbacks.logger = fmi2CallbackLoggerTYPE(lambda _, __, *entry: log(*entry) and None)
    return callbacks


@contextmanager
def running(
    case: str, log: list[tuple[int, str, str]] | None = None, place: Path | None = None
) -> Iterator[FMU2Slave]:
    """An initialized instance; with a log, logging is on."""

    def note(status: int, category: bytes, message: bytes) -> None:
        assert log is not None
        log.append((status, category.decode(), message.decode()))

    callbacks = told_to(note)
    with loaded(case, place) as slave:
        slave.instantiate(callbacks=callbacks, loggingOn=log is not None)
        started(slave)
        yield slave
        slave.fmi2FreeInstance(slave.component)


def started(slave: FMU2Slave) -> None:
    slave.setupExperiment(startTime=0.0)
    slave.enterInitializationMode()
    slave.exitInitializationMode()


def step(slave: FMU2Slave, row: Array, time: float = 0.0) -> Array:
    slave.setReal(range(30), row)
    slave.doStep(time, 0.001)
    return np.array(slave.getReal(FORCES))


def references(case: str) -> dict[str, int]:
    told = fmpy.read_model_description(str(folder(case)))
    return {variable.name: variable.valueReference for variable in told.modelVariables}


def status(slave: FMU2Slave, case: str = "lanes") -> int:
    return int(slave.getInteger([references(case)["status"]])[0])


def some_rows(case: str = "lanes") -> Array:
    """Motions that differ in all that moves, and loads."""
    rng = np.random.default_rng(7)
    return rows_of(machines.random_motion(rng, made(case).robot, (3,)))


# --- the archive ------------------------------------------------------------------------------


def contents(content: bytes) -> dict[str, bytes]:
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def guid(content: bytes) -> str:
    found = re.search(rb'guid="(.*?)"', contents(content)["modelDescription.xml"])
    assert found is not None
    return found[1].decode()
