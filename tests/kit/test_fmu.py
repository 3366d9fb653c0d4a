"""The FMI unit in another tool's hands: valid, the kernel's forces to the bit, and honest about the rest."""

import ctypes
import dataclasses
import functools
import io
import os
import re
import subprocess
import sys
import tempfile
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import fmpy
import machines
import numpy as np
import pytest
from fmpy.build import build_platform_binary
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import (
    FMU2Slave,
    defaultCallbacks,
    fmi2CallbackFunctions,
    fmi2CallbackLoggerTYPE,
    fmi2CoSimulation,
    fmi2LastSuccessfulTime,
    fmi2ModelExchange,
)
from fmpy.validation import validate_fmu
from numpy.typing import NDArray

from stewart_sym import PATHS, inverse_dynamics
from stewart_sym.backend import native
from stewart_sym.backend.kernel import MOTION, robot_numbers
from stewart_sym.derive.package import fmu as texts
from stewart_sym.derive.package.words import robot_symbol
from stewart_sym.dynamics.home_pose import home_pose
from stewart_sym.kit import Choice, kit
from stewart_sym.kit.fmu import UnitKernel, binary_folder, fmu_unit
from stewart_sym.kit.poses import sample
from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot

Array = NDArray[np.float64]

CASES = {
    "lanes": Choice(fmu=True),
    "scalar": Choice(scalar=True, fmu=True),
    "baked": Choice(bake=True, fmu=True),
    "float": Choice(precision="float", fmu=True),
    "spherical": Choice(fmu=True),
    "massless": Choice(fidelity="massless", fmu=True),
}
SLOW = ("massless",)
EVERY = [pytest.param(case, marks=[pytest.mark.slow] if case in SLOW else []) for case in CASES]
PREPARED = [case for case in EVERY if case.values != ("baked",)]
STRICT = ("-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wdouble-promotion", "-Wshadow", "-Werror")
COMPILERS = {
    "gcc": ("gcc", "-std=c99"),
    "clang": ("clang", "-std=c99"),
    "g++": ("g++", "-x", "c++", "-std=c++11"),
    "clang++": ("clang++", "-x", "c++", "-std=c++11"),
}
PAYLOAD = ("M", "R_0", "I_p", "g")
FORCES = range(30, 36)
NOT_FINITE, ZERO_LENGTH, SINGULAR = 1, 2, 4


@dataclass(frozen=True)
class Made:
    """A unit and what it was made of."""

    robot: Robot
    kernel: UnitKernel
    sources: dict[str, str]
    content: bytes

    @property
    def symbol(self) -> str:
        return robot_symbol(self.robot.name)


def robot_of(case: str) -> Robot:
    if case == "spherical":
        return machines.random_robot(np.random.default_rng(3), "spherical")
    return machines.dasgupta()


def numbers(robot: Robot) -> dict[str, object]:
    return {field: np.asarray(getattr(robot, field)).tolist() for field in PAYLOAD}


def pose(motion: Motion) -> dict[str, object]:
    return {field: getattr(motion, field).tolist() for field in ("R", "t")}


def unit(robot: Robot, kernel: UnitKernel, sources: dict[str, str]) -> bytes:
    start = {"R": np.eye(3).tolist(), "t": home_pose(robot).t.tolist()}
    payload = None if kernel.baked else numbers(robot)
    return fmu_unit(robot.name, robot_symbol(robot.name), sources, kernel, start, payload, "0" * 64, "1.2.3")


@functools.cache
def made(case: str) -> Made:
    robot = robot_of(case)
    files = kit(robot, CASES[case]).files
    unused = ("example/main.c", "test/selftest.c", "stewart_rotation.h", "stewart_rotation.c")
    sources = {
        name: text.decode()
        for name, text in files.items()
        if name.endswith((".c", ".h")) and name not in unused
    }
    header, prefix = forces_function(sources)
    kernel = UnitKernel(header, prefix, case == "baked", CASES[case].precision)
    return Made(robot, kernel, sources, files[f"{robot_symbol(robot.name)}.fmu"])


def forces_function(sources: dict[str, str]) -> tuple[str, str]:
    for name, text in sources.items():
        found = (
            re.search(r"^STEWART_NODISCARD int (stewart_\w+)_forces\(", text, re.MULTILINE)
            if name.endswith(".h")
            else None
        )
        if found is not None:
            return name, found[1]
    raise AssertionError("no header declares forces")


@functools.cache
def folder(case: str) -> Path:
    """The unit, unpacked for as long as the tests run."""
    place = Path(KEEP.name) / case
    with zipfile.ZipFile(io.BytesIO(made(case).content)) as archive:
        archive.extractall(place)
    return place


KEEP = tempfile.TemporaryDirectory(prefix="stewart-sym-fmu-", ignore_cleanup_errors=True)


# --- the same kernel without a unit -----------------------------------------------------------


@functools.cache
def library(case: str) -> ctypes.CDLL:
    """The kernel compiled as in the unit, its functions shown."""
    place = Path(KEEP.name) / f"{case}_kernel"
    place.mkdir()
    flags = ("-fvisibility=default",)
    return ctypes.CDLL(
        str(native.compiled(place, "kernel", made(case).sources, flags, native.PORTABLE_FLAGS))
    )


def forces(case: str, rows: Array, robot: Robot | None = None) -> Array:
    """Forces (n, 6) of motions (n, 30), every one of which has some."""
    kernel, code = made(case).kernel, library(case)
    real = np.float32 if kernel.precision == "float" else np.float64
    constants = robot_numbers(made(case).robot if robot is None else robot).astype(real)
    model, found = ctypes.create_string_buffer(1 << 15), np.zeros((len(rows), 78), dtype=real)
    owner = [] if kernel.baked else [model]
    if not kernel.baked:
        assert getattr(code, f"{kernel.prefix}_prepare")(pointer(constants), model) == 0
    for row, F in zip(np.ascontiguousarray(rows, dtype=real), found, strict=True):
        assert getattr(code, f"{kernel.prefix}_forces")(*owner, pointer(row), pointer(F)) == 0
    return found[:, :6].astype(np.float64)


def pointer(array: NDArray[np.generic]) -> ctypes.c_void_p:
    return ctypes.c_void_p(array.ctypes.data)


def rows_of(motion: Motion) -> Array:
    """Motions as the unit's inputs in their order, (n, 30)."""
    fields = [getattr(motion, name) for name in MOTION]
    count = len(motion.t)
    return np.concatenate(
        [np.zeros((count, 3)) if value is None else value.reshape(count, -1) for value in fields], axis=1
    )


def path(case: str, times: Array) -> Motion:
    if case == "spherical":
        return machines.random_path(np.random.default_rng(4), made(case).robot)(times)
    return PATHS["I"].path.sample(times)


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


@contextmanager
def running(case: str, log: list[tuple[int, str, str]] | None = None) -> Iterator[FMU2Slave]:
    """An initialised instance; with a log, logging is on."""
    callbacks = fmi2CallbackFunctions()
    callbacks.allocateMemory, callbacks.freeMemory = (
        defaultCallbacks.allocateMemory,
        defaultCallbacks.freeMemory,
    )

    def logger(_: object, __: bytes, status: int, category: bytes, message: bytes) -> None:
        assert log is not None
        log.append((status, category.decode(), message.decode()))

    callbacks.logger = fmi2CallbackLoggerTYPE(logger)
    with loaded(case) as slave:
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


# --- what it computes -------------------------------------------------------------------------


@pytest.mark.parametrize("case", EVERY)
def test_unit_is_valid_by_the_schema_and_the_rules_of_the_standard(case: str, tmp_path: Path) -> None:
    (tmp_path / "unit.fmu").write_bytes(made(case).content)
    assert validate_fmu(str(tmp_path / "unit.fmu")) == []
    told = fmpy.read_model_description(str(folder(case)))
    assert told.fmiVersion == "2.0"
    assert told.modelExchange is None
    assert told.defaultExperiment.stepSize == "0.001"


@pytest.mark.parametrize("case", EVERY)
def test_path_gives_the_forces_of_the_kernel_to_the_bit(case: str) -> None:
    interval, count = 0.05, 40
    times = interval * np.arange(count + 1)
    names = list(references(case))
    rows = rows_of(path(case, times))
    signals = np.zeros(count + 1, dtype=[("time", float), *((name, float) for name in names[:30])])
    signals["time"] = times
    for name, column in zip(names[:30], rows.T, strict=True):
        signals[name] = column
    found = fmpy.simulate_fmu(
        str(folder(case)),
        stop_time=interval * count,
        output_interval=interval,
        input=signals,
        output=[*names[:36], "status"],
    )
    assert found.shape == (count + 1,)
    taken = np.array([found[name] for name in names[:30]]).T
    F = np.array([found[name] for name in names[30:36]]).T
    assert not found["status"].any()
    np.testing.assert_array_equal(F, forces(case, taken))
    # Outputs are those of the inputs at the start of the step.
    np.testing.assert_allclose(taken[1:], rows[:-1], rtol=0, atol=1e-9)
    assert np.ptp(F, axis=0).min() > 1.0


def test_forces_are_those_of_the_library_and_of_the_reference() -> None:
    rows = some_rows()
    motion = machines.random_motion(np.random.default_rng(7), made("lanes").robot, (3,))
    for case, bound in (("lanes", 1e-12), ("baked", 1e-12), ("float", 2e-5)):
        with running(case) as slave:
            F = np.array([step(slave, row) for row in rows])
        for backend in ("c", "reference"):
            expected = inverse_dynamics(made(case).robot, motion, "exact", backend).F
            np.testing.assert_allclose(F, expected, rtol=0, atol=bound * np.abs(expected).max())


@pytest.mark.parametrize("case", EVERY)
def test_unit_runs_at_rest_before_anything_is_connected(case: str) -> None:
    home = home_pose(made(case).robot)
    start = np.zeros(30)
    start[:9], start[9:12] = np.eye(3).ravel(), home.t
    with running(case) as slave:
        np.testing.assert_array_equal(slave.getReal(range(30)), start)
        np.testing.assert_array_equal(slave.getReal(FORCES), forces(case, start[None])[0])
        assert status(slave, case) == 0


def test_outputs_follow_inputs_in_initialisation_and_steps_afterwards() -> None:
    first, second, _ = some_rows()
    with loaded("lanes") as slave:
        slave.instantiate()
        slave.setupExperiment()
        with pytest.raises(FMICallException):
            slave.getReal(FORCES)
        slave.enterInitializationMode()
        slave.setReal(range(30), first)
        F = slave.getReal(FORCES)
        np.testing.assert_array_equal(F, forces("lanes", first[None])[0])
        slave.exitInitializationMode()
        slave.setReal(range(30), second)
        assert slave.getReal(FORCES) == F
        slave.doStep(0.0, 0.25)
        np.testing.assert_array_equal(slave.getReal(FORCES), forces("lanes", second[None])[0])
        assert slave.getRealStatus(fmi2LastSuccessfulTime) == 0.25
        slave.terminate()
        np.testing.assert_array_equal(slave.getReal(FORCES), forces("lanes", second[None])[0])
        slave.fmi2FreeInstance(slave.component)


@pytest.mark.parametrize("case", PREPARED)
def test_new_payload_holds_from_the_next_step_on(case: str) -> None:
    robot, rows = made(case).robot, some_rows(case)[:1]
    heavier = dataclasses.replace(
        robot, M=1.7 * robot.M, R_0=robot.R_0 + 0.03, I_p=1.3 * robot.I_p, g=np.array([0.1, -0.2, -9.7])
    )
    at = references(case)
    values = {"M": heavier.M}
    values |= {f"{name}[{i + 1}]": getattr(heavier, name)[i] for name in ("R_0", "g") for i in range(3)}
    axes = [(i, j) for i in range(3) for j in range(i, 3)]
    values |= {f"I_p.{'xyz'[i]}{'xyz'[j]}": heavier.I_p[i, j] for i, j in axes}
    assert set(values) == {name for name in list(at)[36:] if name != "status"}
    with running(case) as slave:
        before = step(slave, rows[0])
        slave.setReal([at[name] for name in values], values.values())
        np.testing.assert_array_equal(slave.getReal(FORCES), before)
        slave.doStep(0.001, 0.001)
        np.testing.assert_array_equal(slave.getReal(FORCES), forces(case, rows, heavier)[0])
        assert np.abs(slave.getReal(FORCES) - before).max() > 1e-3 * np.abs(before).max()
        slave.reset()
        started(slave)
        np.testing.assert_array_equal(step(slave, rows[0]), before)


def test_baked_unit_has_no_parameters() -> None:
    assert list(references("baked"))[36:] == ["status"]


def test_units_of_measure_come_down_to_base_units() -> None:
    told = fmpy.read_model_description(str(folder("lanes")))
    base = {unit.name: unit.baseUnit for unit in told.unitDefinitions}
    exponents = {
        name: tuple(int(getattr(unit, part) or 0) for part in ("kg", "m", "s", "rad"))
        for name, unit in base.items()
    }
    assert exponents == {
        "1": (0, 0, 0, 0),
        "m": (0, 1, 0, 0),
        "rad/s": (0, 0, -1, 1),
        "m/s": (0, 1, -1, 0),
        "rad/s2": (0, 0, -2, 1),
        "m/s2": (0, 1, -2, 0),
        "N": (1, 1, -2, 0),
        "N.m": (1, 2, -2, 0),
        "kg": (1, 0, 0, 0),
        "kg.m2": (1, 2, 0, 0),
    }


# --- where a pose has no forces ---------------------------------------------------------------


def bad_rows() -> dict[str, tuple[Array, int]]:
    """Motions without forces, with the status that each must give."""
    good, robot = some_rows()[0], made("lanes").robot
    short, infinite, nan = good.copy(), good.copy(), good.copy()
    short[:9], short[9:12] = np.eye(3).ravel(), robot.b[0] - robot.p[0]
    infinite[20], nan[3] = np.inf, np.nan
    return {"short": (short, ZERO_LENGTH), "infinite": (infinite, NOT_FINITE), "nan": (nan, NOT_FINITE)}


@pytest.mark.parametrize("which", ["short", "infinite", "nan"])
def test_pose_without_forces_leaves_the_outputs_and_is_told_once(which: str) -> None:
    bad, code = bad_rows()[which]
    good, other, _ = some_rows()
    log: list[tuple[int, str, str]] = []
    with running("lanes", log) as slave:
        before = step(slave, good)
        for time in (0.001, 0.002, 0.003):
            np.testing.assert_array_equal(step(slave, bad, time), before)
            assert status(slave) == code
        assert [entry[:2] for entry in log] == [(1, "logStatusWarning")]
        np.testing.assert_array_equal(step(slave, other), forces("lanes", other[None])[0])
        assert status(slave) == 0


def test_singular_pose_has_its_status(tmp_path: Path) -> None:
    robot = machines.dasgupta()
    flat = dataclasses.replace(
        robot, b=robot.b * np.array([1.0, 1.0, 0.0]), p=robot.p * np.array([1.0, 1.0, 0.0])
    )
    files = kit(flat, CASES["lanes"]).files
    sources = made("lanes").sources | {"stewart_robot.c": files["stewart_robot.c"].decode()}
    with zipfile.ZipFile(io.BytesIO(unit(flat, made("lanes").kernel, sources))) as archive:
        archive.extractall(tmp_path)
    row = np.zeros(30)
    row[:9], row[9:12] = np.eye(3).ravel(), [0.05, 0.02, 0.0]
    with loaded("flat", tmp_path) as slave:
        slave.instantiate()
        started(slave)
        before = slave.getReal(FORCES)
        assert step(slave, row).tolist() == before
        assert status(slave) == SINGULAR
        slave.fmi2FreeInstance(slave.component)


def test_number_too_large_for_float_is_not_finite() -> None:
    good = some_rows("float")[0]
    bad = good.copy()
    bad[12] = 1e39
    with running("float") as slave:
        before = step(slave, good)
        np.testing.assert_array_equal(step(slave, bad), before)
        assert status(slave, "float") == NOT_FINITE


def test_payload_that_is_not_finite_is_told_and_mended_by_the_next() -> None:
    good, at = some_rows()[0], references("lanes")
    with running("lanes") as slave:
        before = step(slave, good)
        mass = slave.getReal([at["M"]])
        slave.setReal([at["M"]], [np.nan])
        np.testing.assert_array_equal(step(slave, good), before)
        assert status(slave) == NOT_FINITE
        slave.setReal([at["M"]], mass)
        np.testing.assert_array_equal(step(slave, good), before)
        assert status(slave) == 0


def test_calls_that_make_no_sense_are_rejected_and_change_nothing() -> None:
    good = some_rows()[0]
    log: list[tuple[int, str, str]] = []
    with running("lanes", log) as slave:
        before = step(slave, good)
        rejected = [
            lambda: slave.setReal([30], [1.0]),
            lambda: slave.setReal([0, 50], [9.0, 9.0]),
            lambda: slave.getReal([49]),
            lambda: slave.getInteger([0]),
            lambda: slave.setInteger([49], [0]),
            lambda: slave.getBoolean([0]),
            lambda: slave.setString([0], ["x"]),
            lambda: slave.doStep(0.0, -1.0),
            lambda: slave.doStep(np.nan, 1.0),
            lambda: slave.exitInitializationMode(),
            lambda: slave.getDirectionalDerivative([30], [0], [1.0]),
            lambda: slave.cancelStep(),
            lambda: slave.deSerializeFMUstate(b"x"),
        ]
        for call in rejected:
            with pytest.raises(FMICallException):
                call()
        assert [entry[:2] for entry in log] == [(3, "logStatusError")] * len(rejected)
        slave.doStep(0.001, 0.001)
        np.testing.assert_array_equal(slave.getReal(FORCES), before)
        slave.setDebugLogging(False, ["logStatusError"])
        with pytest.raises(FMICallException):
            slave.cancelStep()
        step(slave, bad_rows()["nan"][0])
        assert len(log) == len(rejected) + 1


# --- instances and their states ---------------------------------------------------------------


def test_state_comes_back_and_goes_over_to_another_instance() -> None:
    first, second, third = some_rows()
    at = references("lanes")
    with running("lanes") as slave, running("lanes") as other:
        slave.setReal([at["M"]], [55.0])
        F = step(slave, first)
        state = slave.getFMUstate()
        held = slave.serializeFMUstate(state)
        slave.setReal([at["M"]], [66.0])
        assert not np.array_equal(step(slave, second), F)
        slave.setFMUstate(state)
        for one in (slave, other):
            copy = one.deSerializeFMUstate(held)
            one.setFMUstate(copy)
            one.freeFMUstate(copy)
            np.testing.assert_array_equal(one.getReal(FORCES), F)
            assert one.getReal([at["M"]]) == [55.0]
            np.testing.assert_array_equal(one.getReal(range(30)), first)
        np.testing.assert_array_equal(step(slave, third), step(other, third))
        with pytest.raises(FMICallException):
            slave.deSerializeFMUstate(b"{" + bytes(len(held) - 1))
        slave.freeFMUstate(state)


def test_instances_know_nothing_of_each_other() -> None:
    first, second, _ = some_rows()
    with loaded("lanes") as slave:
        slave.instantiate()
        started(slave)
        one = slave.component
        slave.instantiate()
        started(slave)
        two = slave.component
        assert one != two
        slave.setReal([references("lanes")["M"]], [99.0])
        F = step(slave, second)
        slave.component = one
        np.testing.assert_array_equal(step(slave, first), forces("lanes", first[None])[0])
        slave.fmi2FreeInstance(one)
        slave.component = two
        np.testing.assert_array_equal(slave.getReal(FORCES), F)
        slave.fmi2FreeInstance(two)


def test_reset_gives_a_fresh_instance() -> None:
    with running("lanes") as slave:
        fresh = slave.serializeFMUstate(slave.getFMUstate())
        slave.setReal([references("lanes")["g[3]"]], [-1.6])
        step(slave, some_rows()[0])
        slave.reset()
        started(slave)
        assert slave.serializeFMUstate(slave.getFMUstate()) == fresh


@pytest.mark.parametrize("wrong", ["guid", "kind", "name"])
def test_unit_rejects_what_does_not_belong_to_it(wrong: str) -> None:
    told: list[bytes] = []
    callbacks = fmi2CallbackFunctions()
    callbacks.allocateMemory, callbacks.freeMemory = (
        defaultCallbacks.allocateMemory,
        defaultCallbacks.freeMemory,
    )
    callbacks.logger = fmi2CallbackLoggerTYPE(lambda *entry: told.append(entry[4]))
    with loaded("lanes") as slave:
        guid = slave.guid.replace(slave.guid[1], "x", 1) if wrong == "guid" else slave.guid
        made_instance = slave.fmi2Instantiate(
            b"" if wrong == "name" else b"one",
            fmi2ModelExchange if wrong == "kind" else fmi2CoSimulation,
            guid.encode(),
            b"",
            ctypes.byref(callbacks),
            0,
            0,
        )
        assert made_instance is None
    assert len(told) == 1


# --- the archive ------------------------------------------------------------------------------


def contents(content: bytes) -> dict[str, bytes]:
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def guid(content: bytes) -> str:
    found = re.search(rb'guid="(.*?)"', contents(content)["modelDescription.xml"])
    assert found is not None
    return found[1].decode()


def test_archive_holds_description_page_all_sources_and_the_binary() -> None:
    held = contents(made("lanes").content)
    code = {f"sources/{name}": text.encode() for name, text in made("lanes").sources.items()}
    assert {name: held[name] for name in code} == code
    own = {f"sources/{name}" for name in ("stewart_fmi2.c", "stewart_fmi2.h", "stewart_unit.h")}
    binary = f"{binary_folder()}/{made('lanes').symbol}.so"
    page = {"modelDescription.xml", "documentation/index.html", "documentation/licenses/license.txt"}
    assert set(held) == set(code) | own | page | {binary}
    listed = re.findall(rb'<File name="(.*?)"', held["modelDescription.xml"])
    assert [name.decode() for name in listed] == sorted(
        name.removeprefix("sources/") for name in held if name.endswith(".c")
    )
    with zipfile.ZipFile(io.BytesIO(made("lanes").content)) as archive:
        assert {entry.date_time for entry in archive.infolist()} == {(1980, 1, 1, 0, 0, 0)}
        assert archive.namelist() == sorted(archive.namelist())


def test_guid_follows_the_contents() -> None:
    units = [guid(made(case).content) for case in ("lanes", "baked", "float")]
    sources = made("lanes").sources
    changed = sources | {"stewart_robot.c": sources["stewart_robot.c"].replace("REAL(40.0)", "REAL(41.0)")}
    assert changed != sources
    units.append(guid(unit(made("lanes").robot, made("lanes").kernel, changed)))
    assert len(set(units)) == 4
    assert all(re.fullmatch(r"\{[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}\}", one) for one in units)
    assert guid(made("lanes").content).encode() in contents(made("lanes").content)["sources/stewart_unit.h"]


def test_without_a_compiler_the_unit_has_its_sources_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(native, "find_compiler", lambda: None)
    bare = kit(made("lanes").robot, CASES["lanes"]).files[f"{made('lanes').symbol}.fmu"]
    full = contents(made("lanes").content)
    assert contents(bare) == {name: text for name, text in full.items() if not name.startswith("binaries/")}
    (tmp_path / "unit.fmu").write_bytes(bare)
    assert validate_fmu(str(tmp_path / "unit.fmu")) == []


def test_any_name_is_described(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    name = 'a<b> & "c" ünï 机器人 @GUID@ @VERSION@ \\ */ /*'
    monkeypatch.setattr(native, "find_compiler", lambda: None)
    odd = dataclasses.replace(made("lanes").robot, name=name)
    (tmp_path / "unit.fmu").write_bytes(unit(odd, made("lanes").kernel, made("lanes").sources))
    assert validate_fmu(str(tmp_path / "unit.fmu")) == []
    told = fmpy.read_model_description(str(tmp_path / "unit.fmu"))
    assert told.modelName == name


def test_long_symbol_gives_an_identifier_that_simulink_takes() -> None:
    longer = ["stewart_robot_" + "a" * 80 + end for end in "bc"]
    short = [texts.model_identifier(symbol) for symbol in longer]
    assert len(set(short)) == 2
    assert all(re.fullmatch(r"[a-z]\w{0,62}", one) for one in short)
    assert texts.model_identifier("stewart_robot_x") == "stewart_robot_x"


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"pose": {"R": np.eye(3).tolist()}}, "pose: t: missing"),
        ({"pose": {"R": np.eye(3).tolist(), "t": [0.0, 0.0]}}, "pose: t: expected an entry [2]"),
        ({"payload": None}, "payload: expected M, R_0, I_p and g for this kernel"),
        ({"sources": {}}, "sources: expected stewart_exact_forces.h among them"),
    ],
)
def test_what_is_missing_is_named(change: dict[str, object], message: str) -> None:
    robot = made("lanes").robot
    given = {
        "name": robot.name,
        "symbol": made("lanes").symbol,
        "sources": made("lanes").sources,
        "kernel": made("lanes").kernel,
        "pose": pose(sample(robot, "exact")[0]),
        "payload": numbers(robot),
        "digest": "",
        "version": "",
    }
    with pytest.raises(ValueError, match=rf"\A{re.escape(message)}\Z"):
        fmu_unit(**(given | change))


# --- the C ------------------------------------------------------------------------------------


def silent(command: list[str], where: Path) -> None:
    done = subprocess.run(command, cwd=where, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout + done.stderr) == (0, "")


@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("case", [case for case in EVERY if case.values[0] in ("lanes", "baked", "float")])
def test_unit_compiles_with_every_warning_an_error(case: str, compiler: str, tmp_path: Path) -> None:
    command = [*COMPILERS[compiler], *STRICT, "-O1", "-c", "stewart_fmi2.c", "-o", str(tmp_path / "unit.o")]
    silent(command, folder(case) / "sources")


def test_declarations_are_the_standards(tmp_path: Path) -> None:
    """The C compiles against the standard's own headers in place of ours."""
    for file in (folder("lanes") / "sources").iterdir():
        (tmp_path / file.name).write_bytes(file.read_bytes())
    (tmp_path / "stewart_fmi2.h").write_text('#include "fmi2Functions.h"\n', encoding="utf-8")
    standard = Path(fmpy.__file__).parent / "c-code"
    silent(["gcc", "-std=c99", *STRICT, "-isystem", str(standard), "-c", "stewart_fmi2.c"], tmp_path)


def test_binary_shows_the_functions_of_co_simulation_and_nothing_else() -> None:
    binary = next((folder("lanes") / "binaries").rglob("*.so"))
    listed = subprocess.run(
        ["nm", "-D", "--defined-only", binary], capture_output=True, text=True, check=True
    )
    shown = {line.split()[-1] for line in listed.stdout.splitlines()}
    standard = (Path(fmpy.__file__).parent / "c-code" / "fmi2Functions.h").read_text(encoding="utf-8")
    common, exchange, stepping = re.split(r"\n(?:Functions for|.*Functions for FMI2 for)", standard)[-3:]
    del common, exchange
    own = set(re.findall(r"FMI2_Export fmi2\w+TYPE\s+(\w+);", stepping))
    every = set(re.findall(r"FMI2_Export fmi2\w+TYPE\s+(\w+);", standard))
    assert own <= shown <= every
    assert not shown & {"fmi2SetTime", "fmi2GetDerivatives", "fmi2EnterEventMode", "fmi2NewDiscreteStates"}


def test_prefix_is_put_before_every_function(tmp_path: Path) -> None:
    command = ["gcc", "-std=c99", "-DFMI2_FUNCTION_PREFIX=mine_", "-c", "stewart_fmi2.c"]
    silent([*command, "-o", str(tmp_path / "unit.o")], folder("lanes") / "sources")
    listed = subprocess.run(
        ["nm", "-g", "--defined-only", tmp_path / "unit.o"], capture_output=True, text=True
    )
    shown = [line.split()[-1] for line in listed.stdout.splitlines()]
    assert len(shown) > 30
    assert all(name.startswith("mine_fmi2") for name in shown)


@pytest.mark.slow
@pytest.mark.parametrize("case", ["lanes"])
def test_another_tool_builds_the_unit_from_its_sources(
    case: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name, content in contents(made(case).content).items():
        if not name.startswith("binaries/"):
            (tmp_path / name).parent.mkdir(exist_ok=True)
            (tmp_path / name).write_bytes(content)
    monkeypatch.setenv("PATH", str(Path(sys.executable).parent), prepend=os.pathsep)
    build_platform_binary(tmp_path)
    row = some_rows(case)[0]
    with loaded(case, tmp_path) as slave:
        slave.instantiate()
        started(slave)
        F = step(slave, row)
        slave.fmi2FreeInstance(slave.component)
    expected = forces(case, row[None])[0]
    bound = 1e-4 if case == "float" else 1e-11
    np.testing.assert_allclose(F, expected, rtol=0, atol=bound * np.abs(expected).max())


@pytest.mark.slow
@pytest.mark.parametrize("case", ["lanes", "baked", "float"])
def test_sanitizers_find_nothing_in_a_life_of_two_instances(case: str, tmp_path: Path) -> None:
    where, driver = folder(case) / "sources", Path(__file__).parents[1] / "support" / "c" / "fmi2_driver.c"
    program, values = tmp_path / "driver", references(case)
    flags = [
        "-std=c99",
        "-g",
        "-O1",
        "-fsanitize=address,undefined",
        "-fno-sanitize-recover=all",
        "-I",
        str(where),
    ]
    flags += [f'-DUNIT_GUID="{guid(made(case).content)}"', f"-DUNIT_REALS={values['status']}"]
    silent(["clang", *flags, str(driver), *map(str, where.glob("*.c")), "-o", str(program), "-lm"], tmp_path)
    silent([str(program)], tmp_path)


@pytest.mark.slow
@pytest.mark.parametrize("case", ["lanes", "baked"])
def test_analysers_find_nothing(case: str) -> None:
    where = folder(case) / "sources"
    checks = ["--enable=warning,style,performance,portability", "--std=c99", "--quiet", "--error-exitcode=3"]
    # The standard gives the signatures; declarations stand at the head of a function, as in all the C.
    hidden = [f"--suppress={name}" for name in ("missingIncludeSystem", "constParameter", "variableScope")]
    silent(["cppcheck", *checks, *hidden, "-D__GNUC__=12", "-USTEWART_REAL", "stewart_fmi2.c"], where)
    silent(["gcc", "-std=c99", "-O2", "-fanalyzer", "-S", "-o", os.devnull, "stewart_fmi2.c"], where)
