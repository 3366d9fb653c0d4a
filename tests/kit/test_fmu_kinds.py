"""Units with roll, pitch, and yaw, with motor torques, and of the plant equal the package."""

import functools
import io
import tempfile
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import fmpy
import machines
import numpy as np
import pytest
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Slave
from fmpy.validation import validate_fmu
from fmu_units import Array, told_to
from kits import COMPILERS, STRICT, machine, silently

import stewart_sym as ss
from stewart_sym.backend import native
from stewart_sym.dynamics.home_pose import home_pose
from stewart_sym.kit import Choice, files
from stewart_sym.kit.required_kernels import parts
from stewart_sym.motion.rotation import angle_rates, rpy_from_rotation

KEEP = tempfile.TemporaryDirectory(prefix="stewart-sym-fmu-", ignore_cleanup_errors=True)
DASGUPTA = "dasgupta"
DRIVEN = {"random drive": "forces-rpy", "random rotors": "forces"}
PATH = ss.PAPER_PATHS["I"].path


@functools.cache
def folder(which: str, kind: str) -> Path:
    """The unit of a machine, unpacked; its archive is beside its files."""
    robot, choice, place = machine(which), Choice(fmu=kind), Path(tempfile.mkdtemp(dir=KEEP.name))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(native, "PORTABLE_FLAGS", (*native.PORTABLE_FLAGS, "-O0"))
        content = files._unit(robot, choice, parts(robot, choice))
    (place / "unit.fmu").write_bytes(content)
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        archive.extractall(place)
    return place


class Unit:
    """An instance whose variables are arrays by name."""

    def __init__(self, which: str, kind: str, log: list[bytes]) -> None:
        """Start the instance; ``initialize`` ends its initialization."""
        place = str(folder(which, kind))
        told = fmpy.read_model_description(place)
        self.at: dict[str, list[int]] = {}
        for variable in told.modelVariables:
            self.at.setdefault(variable.name.partition("[")[0], []).append(variable.valueReference)
        identifier = told.coSimulation.modelIdentifier
        self.slave = FMU2Slave(
            guid=told.guid, unzipDirectory=place, modelIdentifier=identifier, instanceName="one"
        )
        self.slave.instantiate(callbacks=told_to(lambda *entry: log.append(entry[2])), loggingOn=True)
        self.begin()

    def begin(self) -> None:
        self.slave.setupExperiment(startTime=0.0)
        self.slave.enterInitializationMode()

    def __getitem__(self, name: str) -> Array:
        return np.array(self.slave.getReal(self.at[name]))

    def __setitem__(self, name: str, value: Array) -> None:
        self.slave.setReal(self.at[name], np.ravel(value))

    def initialize(self) -> None:
        self.slave.exitInitializationMode()

    def step(self, step: float = 0.001, count: int = 1) -> None:
        for _ in range(count):
            self.slave.doStep(0.0, step)

    @property
    def status(self) -> int:
        return int(self.slave.getInteger(self.at["status"])[0])


@contextmanager
def running(which: str, kind: str, log: list[bytes] | None = None) -> Iterator[Unit]:
    unit = Unit(which, kind, [] if log is None else log)
    try:
        yield unit
    finally:
        unit.slave.fmi2FreeInstance(unit.slave.component)
        unit.slave.freeLibrary()


def set_motion(unit: Unit, motion: ss.Motion) -> None:
    """Set the inputs of a unit of the forces, with R or with angles."""
    if "theta" in unit.at:
        theta = rpy_from_rotation(motion.R)
        unit["theta"] = theta
        unit["theta_dot"], unit["theta_ddot"] = angle_rates(theta, motion.omega, motion.alpha, "zyx")
    for name, value in vars(motion).items():
        if name in unit.at and value is not None:
            unit[name] = value


def start_at(unit: Unit, state: ss.Motion) -> None:
    """Initialize a plant at a state."""
    unit["theta_start"], unit["t_start"] = rpy_from_rotation(state.R), state.t
    unit["v_start"], unit["omega_start"] = state.v, state.omega
    unit.initialize()


def some_state() -> ss.Motion:
    return ss.Motion.from_rpy(
        t=[0.0, 0.0, 0.4],
        theta=[0.1, 0.2, 0.0],
        v=[0.01, 0.004, -0.01],
        theta_dot=[0.02, -0.02, 0.04],
        a=np.zeros(3),
        theta_ddot=np.zeros(3),
        F_ext=[3.0, -2.0, 5.0],
        M_ext=[0.5, 0.2, -0.3],
    )


@pytest.mark.parametrize(
    ("which", "kind", "compiler"),
    [
        *((which, kind, "gcc") for which, kind in DRIVEN.items()),
        pytest.param(DASGUPTA, "plant", "clang", marks=pytest.mark.slow),
    ],
)
def test_unit_is_valid_and_compiles_without_a_warning(
    which: str, kind: str, compiler: str, tmp_path: Path
) -> None:
    place = folder(which, kind)
    assert validate_fmu(str(place / "unit.fmu")) == []
    command = [*COMPILERS[compiler], *STRICT, "-O1", "-c", "stewart_fmi2.c", "-o", str(tmp_path / "unit.o")]
    silently(command, place / "sources")


def test_roll_pitch_and_yaw_give_the_forces_of_the_rotation_matrix() -> None:
    motion = PATH.sample(np.linspace(0.0, 2.0, 21))
    with running(DASGUPTA, "forces") as by_matrix, running(DASGUPTA, "forces-rpy") as by_angles:
        assert set(by_matrix.at) - set(by_angles.at) == {"R", "omega", "alpha"}
        for unit in (by_matrix, by_angles):
            unit.initialize()
        for i in range(len(motion.t)):
            forces = []
            for unit in (by_matrix, by_angles):
                set_motion(unit, motion[i])
                unit.step()
                assert unit.status == 0
                forces.append(unit["F"])
            np.testing.assert_allclose(*forces, rtol=0.0, atol=1e-12 * np.abs(forces[0]).max())


@pytest.mark.parametrize("which", DRIVEN)
def test_torques_and_currents_are_those_of_the_drives(which: str) -> None:
    robot = machine(which)
    motion = machines.random_motion(np.random.default_rng(3), robot, (3,))
    effort = ss.drive_effort(robot, motion)
    assert effort.current is not None
    known = np.isfinite(effort.current[0])
    with running(which, DRIVEN[which]) as unit:
        unit.initialize()
        for i in range(3):
            set_motion(unit, motion[i])
            unit.step()
            assert unit.status == 0
            np.testing.assert_allclose(unit["torque"], effort.torque[i], rtol=1e-9, atol=1e-12)
            # Motors without a torque constant have no current as output.
            np.testing.assert_allclose(unit["current"], effort.current[i][known], rtol=1e-9, atol=1e-12)


def test_plant_follows_the_simulation() -> None:
    state = some_state()
    F = ss.inverse_dynamics(machine(DASGUPTA), state).F
    run = ss.simulate(machine(DASGUPTA), state, F, 0.2, output_step=0.2, rtol=1e-12)
    assert run.stop.reason == "completed"
    legs = ss.inverse_kinematics(machine(DASGUPTA), run.motion[-1])
    with running(DASGUPTA, "plant") as unit:
        start_at(unit, state)
        unit["F"], unit["F_ext"], unit["M_ext"] = F, state.F_ext, state.M_ext
        saved = unit.slave.getFMUstate()
        unit.step(count=200)
        assert unit.status == 0
        end = {name: unit[name] for name in ("R", "t", "v", "omega", "theta", "L", "L_dot")}
        expected = {name: getattr(run, name)[-1].ravel() for name in ("R", "t", "v", "omega")}
        expected |= {"theta": rpy_from_rotation(run.R[-1]), "L": legs.L, "L_dot": legs.L_dot}
        for name, value in expected.items():
            np.testing.assert_allclose(end[name], value, rtol=0.0, atol=1e-8)
        unit.slave.setFMUstate(saved)
        unit.step(0.1, 2)
        for name, value in end.items():
            np.testing.assert_allclose(unit[name], value, rtol=0.0, atol=1e-12)
        unit.slave.reset()
        unit.begin()
        unit.initialize()
        np.testing.assert_array_equal(unit["t"], home_pose(machine(DASGUPTA)).t)
        assert not unit["v"].any()


def test_plant_stops_with_a_warning_and_keeps_its_state() -> None:
    log: list[bytes] = []
    with running(DASGUPTA, "plant", log) as unit:
        unit.initialize()
        unit.step()
        t = unit["t"]
        unit["F"] = np.full(6, np.nan)
        unit.step()
        unit["F"] = np.zeros(6)
        unit.step(count=3)
        assert unit.status == 1
        assert len(log) == 1
        np.testing.assert_array_equal(unit["t"], t)
        for name, value in (("t_start", np.zeros(3)), ("L", np.zeros(6))):
            with pytest.raises(FMICallException):
                unit[name] = value
        unit["max_step"] = np.array([0.0])
        with pytest.raises(FMICallException):
            unit.step()
