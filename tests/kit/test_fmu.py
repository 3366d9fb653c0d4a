"""The FMI unit in another tool's hands: valid, the kernel's forces, and honest about the rest."""

import dataclasses
from pathlib import Path

import fmpy
import numpy as np
import pytest
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import fmi2LastSuccessfulTime
from fmpy.validation import validate_fmu
from fmu_units import (
    EVERY,
    FORCES,
    NOT_FINITE,
    PREPARED,
    ZERO_LENGTH,
    Array,
    assert_forces,
    folder,
    loaded,
    made,
    references,
    rows_of,
    running,
    some_rows,
    started,
    status,
    step,
)

from stewart_sym import PAPER_PATHS
from stewart_sym.dynamics.home_pose import home_pose

# --- what it computes -------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("case", EVERY)
def test_unit_is_valid_by_the_schema_and_the_rules_of_the_standard(case: str, tmp_path: Path) -> None:
    (tmp_path / "unit.fmu").write_bytes(made(case).content)
    assert validate_fmu(str(tmp_path / "unit.fmu")) == []
    told = fmpy.read_model_description(str(folder(case)))
    assert told.fmiVersion == "2.0"
    assert told.modelExchange is None
    assert (list(references(case))[36:] == ["status"]) == (case == "baked")
    assert told.defaultExperiment.stepSize == "0.001"


@pytest.mark.parametrize("case", EVERY)
def test_path_gives_the_forces_of_the_kernel(case: str) -> None:
    interval, count = 0.05, 40
    times = interval * np.arange(count + 1)
    names = list(references(case))
    rows = rows_of(PAPER_PATHS["I"].path.sample(times))
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
    assert_forces(F, case, taken)
    # Outputs are those of the inputs at the start of the step.
    np.testing.assert_allclose(taken[1:], rows[:-1], rtol=0, atol=1e-9)
    assert np.ptp(F, axis=0).min() > 1.0


@pytest.mark.parametrize("case", EVERY)
def test_unit_runs_at_rest_before_anything_is_connected(case: str) -> None:
    home = home_pose(made(case).robot)
    start = np.zeros(30)
    start[:9], start[9:12] = np.eye(3).ravel(), home.t
    with running(case) as slave:
        np.testing.assert_array_equal(slave.getReal(range(30)), start)
        assert_forces(slave.getReal(FORCES), case, start[None])
        assert status(slave, case) == 0


def test_outputs_follow_inputs_in_initialization_and_steps_afterwards() -> None:
    first, second, _ = some_rows()
    with loaded("lanes") as slave:
        slave.instantiate()
        slave.setupExperiment()
        with pytest.raises(FMICallException):
            slave.getReal(FORCES)
        slave.enterInitializationMode()
        slave.setReal(range(30), first)
        F = slave.getReal(FORCES)
        assert_forces(F, "lanes", first[None])
        slave.exitInitializationMode()
        slave.setReal(range(30), second)
        assert slave.getReal(FORCES) == F
        slave.doStep(0.0, 0.25)
        assert_forces(slave.getReal(FORCES), "lanes", second[None])
        assert slave.getRealStatus(fmi2LastSuccessfulTime) == 0.25
        slave.terminate()
        assert_forces(slave.getReal(FORCES), "lanes", second[None])
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
        assert_forces(slave.getReal(FORCES), case, rows, heavier)
        assert np.abs(slave.getReal(FORCES) - before).max() > 1e-3 * np.abs(before).max()
        slave.reset()
        started(slave)
        np.testing.assert_array_equal(step(slave, rows[0]), before)


def test_units_of_measure_come_down_to_base_units() -> None:
    told = fmpy.read_model_description(str(folder("lanes")))
    base = {unit.name: unit.baseUnit for unit in told.unitDefinitions}
    exponents = {
        name: tuple(int(getattr(unit, part) or 0) for part in ("kg", "m", "s", "rad"))
        for name, unit in base.items()
    }
    assert exponents == {
        **{"1": (0, 0, 0, 0), "m": (0, 1, 0, 0), "kg": (1, 0, 0, 0), "kg.m2": (1, 2, 0, 0)},
        **{"rad/s": (0, 0, -1, 1), "m/s": (0, 1, -1, 0), "rad/s2": (0, 0, -2, 1), "m/s2": (0, 1, -2, 0)},
        **{"N": (1, 1, -2, 0), "N.m": (1, 2, -2, 0)},
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
        assert_forces(step(slave, other), "lanes", other[None])
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
