"""Base parameters: as many as the derivation says, enough for the regressor; what each adds to M, C, g."""

import dataclasses
import re

import numpy as np
import pytest
from command_line import rejects
from machines import dasgupta, machine_in_motion, random_motion, random_robot

import stewart_sym as ss
from stewart_sym.derive.mechanics.regressor import dependencies
from stewart_sym.identification.base_parameters import MERGED
from stewart_sym.identification.parameters import leg_name

EVERY = 148
GENERAL = EVERY - 6 * len(dependencies())


def names_at(robot: ss.Robot, leg: int) -> dict[str, float]:
    """What a formula of ``MERGED`` may name: parameters of the platform and of one leg, and its p."""
    pi = ss.inertial_parameters(robot)
    values = dict(zip(pi.names, pi.values.tolist(), strict=True))
    plain = {name: values[leg_name(name, leg + 1)] for name in leg_parameters()}
    return values | plain | dict(zip(("p_x", "p_y", "p_z"), robot.p[leg].tolist(), strict=True))


def leg_parameters() -> list[str]:
    return [name for base in MERGED if base.startswith("J_u") for name in (base, base.replace("u", "d"))] + [
        "m_u"
    ]


def general_value(formula: str, robot: ss.Robot, leg: int) -> float:
    """A formula of ``MERGED`` for one leg or, with its sum over the legs, for the platform."""
    head, _, inner = formula.partition(" + sum")
    total = eval(head, {}, names_at(robot, leg))
    if inner:
        total += sum(eval(inner, {}, names_at(robot, i)) for i in range(6))
    return float(total)


@pytest.mark.slow
def test_there_are_as_many_as_the_derivation_leaves_on_any_machine() -> None:
    assert GENERAL == 100
    for seed in range(20):
        base = ss.base_parameters(random_robot(np.random.default_rng(seed)))
        assert base.rank == GENERAL, seed
        assert base.rank_gap > 1e9
    assert ss.base_parameters(dasgupta()).rank == GENERAL


@pytest.mark.parametrize("seed", range(3))
def test_kept_columns_give_the_whole_regressor_on_other_poses(seed: int) -> None:
    rng = np.random.default_rng(seed)
    robot = random_robot(rng)
    base = ss.base_parameters(robot)
    Y = ss.regressor(robot, random_motion(rng, robot, (20,)))
    assert base.matrix.shape == (base.rank, EVERY)
    assert np.max(np.abs(Y[..., base.independent_columns] @ base.matrix - Y)) <= 1e-12 * np.max(np.abs(Y))


@pytest.mark.parametrize("seed", range(3))
def test_formulas_of_every_machine_are_what_the_singular_values_find(seed: int) -> None:
    robot = random_robot(np.random.default_rng(seed))
    base, pi = ss.base_parameters(robot), ss.inertial_parameters(robot)
    found = dict(zip(base.names, (base.matrix @ pi.values).tolist(), strict=True))
    for name, formula in MERGED.items():
        for leg in range(6) if name.startswith("J_u") else (None,):
            expected = general_value(formula, robot, leg or 0)
            value = found.pop(name if leg is None else leg_name(name, leg + 1))
            assert value == pytest.approx(expected, rel=1e-9), name
    own = dict(zip(pi.names, pi.values.tolist(), strict=True))
    assert found == pytest.approx({name: own[name] for name in found}, rel=1e-9)


def test_machines_whose_forces_tell_less_lose_what_is_not_felt() -> None:
    robot = dasgupta()
    upright = dataclasses.replace(robot, k=np.tile([0.0, 0.0, 1.0], (6, 1)))
    afloat = dataclasses.replace(robot, g=np.zeros(3))
    every = set(ss.base_parameters(robot).names)
    for machine, lost in ((upright, r"h_d\d_y"), (afloat, r"h_d\d_[xyz]")):
        base = ss.base_parameters(machine)
        assert every - set(base.names) == {name for name in every if re.fullmatch(lost, name)}
        assert base.rank_gap > 1e9


def test_a_motion_tells_no_more_than_it_excites() -> None:
    robot = dasgupta()
    at_rest = ss.Motion(
        R=np.eye(3), t=[0.1, 0.0, 0.5], omega=np.zeros(3), v=np.zeros(3), alpha=np.zeros(3), a=np.zeros(3)
    )
    assert ss.base_parameters(robot, at_rest).rank == 6
    path, step = ss.PAPER_PATHS["I"]
    motion = path.sample(path.time_grid(step))
    base = ss.base_parameters(robot, motion)
    assert 6 < base.rank < GENERAL
    Y = ss.regressor(robot, motion)
    assert np.max(np.abs(Y[..., base.independent_columns] @ base.matrix - Y)) <= 1e-6 * np.max(np.abs(Y))


def test_terms_by_parameter_sum_to_the_regressor() -> None:
    robot, motion = machine_in_motion(7, (4,))
    found, Y = ss.equations_by_parameter(robot, motion), ss.regressor(robot, motion)
    twist, rate = (
        np.concatenate(pair, axis=-1) for pair in ((motion.v, motion.omega), (motion.a, motion.alpha))
    )
    total = np.einsum("nijk,nj->nik", found.M, rate) + np.einsum("nijk,nj->nik", found.C, twist)
    total += found.g + found.friction
    np.testing.assert_allclose(total, Y, rtol=0.0, atol=1e-11 * np.abs(Y).max())
    for name, value in vars(ss.equations_by_parameter(robot, motion[2])).items():
        np.testing.assert_array_equal(value, getattr(found, name)[2])


def test_a_pose_without_a_regressor_is_named_or_is_nan_alone() -> None:
    robot = dasgupta()
    zero = np.zeros((2, 3))
    S = np.array([robot.k[1], [0.0, 0.0, 1.0]])
    motion = ss.Motion(R=np.eye(3), t=robot.b[1] - robot.p[1] + S, omega=zero, v=zero)
    rejects(r"motion\[0\].*leg 2", ss.equations_by_parameter, robot, motion)
    for value in vars(ss.equations_by_parameter(robot, motion, on_singular="nan")).values():
        assert np.isnan(value[0]).all()
        assert np.isfinite(value[1]).all()
