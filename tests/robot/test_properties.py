"""Properties of every public function: units, frames, order of legs, shapes, extremes, wrong arguments."""

import contextlib
import dataclasses
import functools
import warnings
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from machines import Array, random_motion, random_robot, rotation
from motion_fields import FIELDS
from numpy.typing import NDArray
from public_calls import RECORDS, Call, calls, public

import stewart_sym as ss
from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot

FEW = settings(derandomize=True, deadline=None, max_examples=8, suppress_health_check=[HealthCheck.too_slow])
BACKENDS = ("c", "numpy", "reference")
seeds = st.integers(0, 2**32 - 1)


@functools.cache
def cached_calls() -> dict[str, Call]:
    return calls()


def machine(seed: int, shape: tuple[int, ...] = ()) -> tuple[Robot, Motion]:
    rng = np.random.default_rng(seed)
    robot = random_robot(rng)
    return robot, random_motion(rng, robot, shape)


# --- results of a pose that do not depend on how it is written down


Results = dict[str, Array]


def results(robot: Robot, motion: Motion, backend: Any = "c") -> Results:
    """What the functions of a pose return, by name; (...) in front is the motion's shape."""
    dynamics = ss.inverse_dynamics(robot, motion, backend=backend)
    equations = ss.equations_of_motion(robot, motion, backend=backend)
    acceleration, alpha = ss.forward_dynamics(robot, motion, dynamics.F, backend=backend)
    reactions = ss.joint_reactions(robot, motion, backend=backend)
    legs = ss.inverse_kinematics(robot, motion)
    closed = "c" if backend == "reference" else backend
    derivatives = ss.force_derivatives(robot, motion, backend=closed)
    linear = ss.linearize(robot, motion, dynamics.F, backend=closed)
    return {
        **{name: getattr(dynamics, name) for name in ("F", "D", "x", "K", "H", "c")},
        **{
            name: getattr(equations, name)
            for name in ("M", "C", "g", "friction", "bias", "bias_and_friction")
        },
        **{name: getattr(reactions, name) for name in ("F_s", "F_u", "F_p", "F_c", "M_p", "M_u")},
        **{name: getattr(legs, name) for name in ("L", "L_dot", "L_ddot", "s", "S")},
        **{name: getattr(derivatives, name) for name in ("by_pose", "by_twist", "by_acceleration")},
        **{name: getattr(linear, name) for name in ("A", "B")},
        "a": acceleration,
        "alpha": alpha,
        "joint_inertia": ss.joint_space_inertia(robot, motion, backend=backend),
        "massless": ss.massless_forces(robot, motion),
        "H_of_pose": ss.wrench_matrix(robot, motion),
        "H_dot": ss.wrench_matrix_rate(robot, motion),
        "Y": ss.regressor(robot, motion),
    }


@pytest.mark.slow
@FEW
@given(seed=seeds, shape=st.sampled_from([(1,), (3,), (9,), (2, 3), (0,), (2, 0), (1, 1, 1)]))
def test_a_batch_is_its_poses_to_the_last_bit(seed: int, shape: tuple[int, ...]) -> None:
    robot, motion = machine(seed, shape)
    whole = results(robot, motion)
    for index in np.ndindex(shape):
        for name, value in results(robot, motion[index]).items():
            assert value.tobytes() == np.ascontiguousarray(whole[name][index]).tobytes(), name
    for name, value in whole.items():
        assert value.shape[: len(shape)] == shape, name


@FEW
@given(seed=seeds)
def test_arguments_broadcast(seed: int) -> None:
    robot, motion = machine(seed, (3,))
    column = Motion(
        R=motion.R[:, None],
        t=motion.t[0],
        omega=motion.omega[0],
        v=motion.v,
        alpha=motion.alpha[0],
        a=motion.a[:, None],
    )
    assert column.shape == (3, 3)
    F = ss.inverse_dynamics(robot, column).F
    a, _ = ss.forward_dynamics(robot, column, F[:, :1])
    assert a.shape == (3, 3, 3)
    assert (a[1, 2] == ss.forward_dynamics(robot, column[1, 2], F[1, 0])[0]).all()
    legs = ss.inverse_kinematics(robot, column)
    v, omega = ss.forward_velocity(robot, motion.R[:, None], motion.t[0], legs.L_dot)
    assert np.allclose(v, column.v, rtol=0, atol=1e-9 * np.abs(column.v).max())
    assert np.allclose(omega, column.omega, rtol=0, atol=1e-9 * np.abs(column.omega).max())
    found = ss.forward_kinematics(robot, legs.L[:, 0], (motion.R, motion.t[0]))
    assert found.t.shape == (3, 3)


# What the solve has no part in: its pivots are chosen among rows of H with units and without, so that another
# unit of length may make it take the rows in another order.
UNSOLVED = ("D", "K", "L", "S", "s", "L_dot", "L_ddot")
UNITS = {  # powers of mass, length and time
    **dict.fromkeys(("F", "D", "x", "K", "F_s", "F_u", "F_p", "F_c", "massless"), (1, 1, -2)),
    **dict.fromkeys(("M_p", "M_u"), (1, 2, -2)),
    **dict.fromkeys(("L", "S"), (0, 1, 0)),
    "s": (0, 0, 0),
    "L_dot": (0, 1, -1),
    "L_ddot": (0, 1, -2),
    "a": (0, 1, -2),
    "alpha": (0, 0, -2),
    "joint_inertia": (1, 0, 0),
}


@pytest.mark.slow
@FEW
@given(seed=seeds, mass=st.integers(-12, 12), length=st.integers(-12, 12), time=st.integers(-12, 12))
def test_other_units_change_no_bit_but_the_exponent(seed: int, mass: int, length: int, time: int) -> None:
    """Units that are powers of two: every product, sum and root only moves its exponent."""
    robot, motion = machine(seed)

    def unit(m: int, l: int, t: int) -> float:  # noqa: E741
        return 2.0 ** (m * mass + l * length + t * time)

    scaled = dataclasses.replace(
        robot,
        g=robot.g * unit(0, 1, -2),
        M=robot.M * unit(1, 0, 0),
        m_d=robot.m_d * unit(1, 0, 0),
        m_u=robot.m_u * unit(1, 0, 0),
        **{name: getattr(robot, name) * unit(0, 1, 0) for name in ("R_0", "b", "p", "r_d0", "r_u0")},
        **{name: getattr(robot, name) * unit(1, 2, 0) for name in ("I_p", "I_d0", "I_u0")},
        C_u=robot.C_u * unit(1, 2, -1),
        C_p=robot.C_p * unit(1, 0, -1),
        C_s=robot.C_s * unit(1, 2, -1),
    )
    powers = {"R": (0, 0, 0), "t": (0, 1, 0), "omega": (0, 0, -1), "v": (0, 1, -1), "alpha": (0, 0, -2)}
    powers |= {"a": (0, 1, -2), "F_ext": (1, 1, -2), "M_ext": (1, 2, -2)}
    moved = Motion(**{name: getattr(motion, name) * unit(*power) for name, power in powers.items()})
    for backend in ("c", "numpy"):
        here, there = (results(*pair, backend) for pair in ((robot, motion), (scaled, moved)))
        for name, power in UNITS.items():
            expected = here[name] * unit(*power)
            if length == 0 or name in UNSOLVED:
                assert (there[name] == expected).all(), (backend, name)
            else:
                close({name: there[name]}, {name: expected}, robot, motion, (name,))


def close(found: Results, expected: Results, robot: Robot, motion: Motion, names: tuple[str, ...]) -> None:
    """Equal to rounding, errors to the size of the array times the condition of what is solved."""
    condition = ss.condition_number(ss.wrench_matrix(robot, motion)) * np.linalg.cond(
        ss.equations_of_motion(robot, motion).M
    )
    for name in names:
        size = np.abs(expected[name]).max()
        assert np.abs(found[name] - expected[name]).max() <= 1e-12 * condition * size, name


SCALARS = ("F", "D", "x", "M_u", "L", "L_dot", "L_ddot", "massless", "joint_inertia")
VECTORS = ("K", "F_s", "F_u", "F_p", "F_c", "M_p", "s", "S", "a", "alpha")


@FEW
@given(seed=seeds, turn=st.tuples(*[st.floats(-3.0, 3.0)] * 3), shift=st.tuples(*[st.floats(-1, 1)] * 3))
def test_results_turn_with_the_base_frame(seed: int, turn: tuple, shift: tuple) -> None:
    robot, motion = machine(seed)
    Q = rotation(np.array(turn) + 1e-3)
    away = np.array(shift)
    turned = dataclasses.replace(robot, b=robot.b @ Q.T + away, k=robot.k @ Q.T, g=Q @ robot.g)
    vectors = {name: Q @ getattr(motion, name) for name in ("omega", "v", "alpha", "a")}
    moved = Motion(R=Q @ motion.R, t=Q @ motion.t + away, **vectors, F_ext=motion.F_ext, M_ext=motion.M_ext)
    found, expected = results(turned, moved), results(robot, motion)
    for name in VECTORS:
        expected[name] = expected[name] @ Q.T
    close(found, expected, robot, motion, SCALARS + VECTORS)


PER_LEG = ("b", "p", "k", "m_d", "r_d0", "I_d0", "m_u", "r_u0", "I_u0", "C_u", "C_p", "C_s")


@FEW
@given(seed=seeds, order=st.permutations(range(6)))
def test_results_follow_the_order_of_the_legs(seed: int, order: list[int]) -> None:
    robot, motion = machine(seed)
    other = dataclasses.replace(robot, **{name: getattr(robot, name)[order] for name in PER_LEG})
    found, expected = results(other, motion), results(robot, motion)
    of_platform = ("a", "alpha", "M", "C", "g", "friction", "bias", "bias_and_friction", "c")
    for name in (set(SCALARS) | set(VECTORS)) - set(of_platform):
        expected[name] = expected[name][order]
    expected["joint_inertia"] = expected["joint_inertia"][:, order]
    close(found, expected, robot, motion, SCALARS + VECTORS + of_platform)


# --- there and back


# --- extremes: finite, or a status


EXTREME = st.sampled_from(
    [0.0, 5e-324, 1e-300, 1e-160, 1e-20, 1.0, 1e20, 1e100, 1e154, 1e160, 1e300, 1.7e308]
)


def outputs(found: Any) -> tuple[dict[str, Array], NDArray[np.int32]]:
    parts = dict(vars(found))
    given = {name: value for name, value in parts.items() if name != "status" and value is not None}
    return given, parts["status"]


@pytest.mark.filterwarnings("error")
@FEW
@given(seed=seeds, sizes=st.tuples(*[EXTREME] * 7), backend=st.sampled_from(BACKENDS))
def test_results_are_finite_or_have_a_status(seed: int, sizes: tuple, backend: Any) -> None:
    robot, motion = machine(seed, (3,))
    parts = {name: getattr(motion, name).copy() for name in FIELDS}
    for name, size in zip(FIELDS[1:], sizes, strict=True):
        direction = parts[name][1] / np.abs(parts[name][1]).max()
        parts[name][1] = direction * size
    extreme = Motion(**parts)
    F = np.ones((3, 6)) * min(sizes[-1], 1e300)
    options = {"on_singular": "nan"}
    found: list[Any] = [
        ss.inverse_dynamics(robot, extreme, backend=backend, **options),
        ss.inverse_dynamics(robot, extreme, "paper", backend, **options),
        ss.joint_reactions(robot, extreme, backend=backend, **options),
        ss.equations_of_motion(robot, extreme, backend=backend, **options),
    ]
    if backend != "reference":
        found.append(ss.force_derivatives(robot, extreme, backend=backend, **options))
        found.append(ss.linearize(robot, extreme, F, backend=backend, **options))
    for result in found:
        parts, status = outputs(result)
        for name, value in parts.items():
            for i in range(3):
                finite = np.isfinite(value[i])
                assert finite.all() if status[i] == 0 else np.isnan(value[i]).all(), (type(result), name)
        assert not status[[0, 2]].any()
    a, alpha = ss.forward_dynamics(robot, extreme, F, backend=backend, **options)
    assert (np.isfinite(a).all(axis=-1) == np.isfinite(alpha).all(axis=-1)).all()
    assert not np.isinf(a).any()
    inertia = ss.joint_space_inertia(robot, extreme, backend=backend, **options)
    assert np.isfinite(inertia[[0, 2]]).all()
    assert not np.isinf(inertia).any()
    regressor = ss.regressor(robot, extreme, **options)
    assert not np.isinf(regressor).any()
    assert not np.isinf(ss.massless_forces(robot, extreme)).any()
    for kinematics in (ss.inverse_kinematics, ss.wrench_matrix, ss.wrench_matrix_rate):
        with contextlib.suppress(ValueError):
            result = kinematics(robot, extreme)
            values = [result] if isinstance(result, np.ndarray) else list(vars(result).values())
            assert all(np.isfinite(value).all() for value in values)


# --- wrong arguments


def circle() -> list[Any]:
    round_about: list[Any] = []
    round_about.append(round_about)
    return round_about


WRONG: dict[str, Any] = {
    "None": None,
    "text": "x",
    "complex": 1j,
    "nothing": [],
    "table": {},
    "object": object(),
    "nan": np.nan,
    "infinite": -np.inf,
    "five": np.zeros(5),
    "ragged": [[1], [1, 2]],
    "True": True,
    "many digits": 10**400,
    "nan vector": np.full(3, np.nan),
    "nan matrix": np.full((3, 3), np.nan),
    "zero matrix": np.zeros((3, 3)),
    "seven vectors": np.zeros((7, 3)),
    "a module": np,
    "record": np.zeros(3, dtype=[("a", float)]),
    "circle": circle(),
}
# A law or a load may be any function; what it makes of its arguments is its own.
CALLABLE = {
    ("singularity_crossings", "path"),
    ("path_singularities", "path"),
    ("simulate", "forces"),
    ("simulate", "load"),
    ("parameterize_path", "path"),
}


CHOICES = ("formulation", "backend", "precision", "on_singular", "on_failure")


OF_UNIVERSAL_JOINTS = (
    *("force_error_bounds", "force_derivatives", "linearize", "regressor", "equations_by_parameter"),
    *("inertial_parameters", "base_parameters"),
)


@pytest.mark.parametrize("name", OF_UNIVERSAL_JOINTS)
def test_what_is_of_universal_joints_alone_rejects_others(name: str) -> None:
    call, ball = cached_calls()[name], random_robot(np.random.default_rng(8), "spherical")
    with pytest.raises(ValueError, match=r'\Arobot: expected base_joint "universal", got "spherical"\Z'):
        call.function(**{**call.arguments, "robot": ball})


def test_every_public_name_is_called_or_a_record() -> None:
    assert public() == {name.partition(".")[0] for name in cached_calls()}
    assert set(ss.__all__) >= RECORDS


@pytest.mark.parametrize("name", sorted(calls()))
def test_arguments_of_a_wrong_kind_are_named_in_one_line(name: str) -> None:
    call = cached_calls()[name]
    names = (*call.arguments, *call.other.values())
    for argument in call.arguments:
        for kind, value in WRONG.items():
            if argument in call.free or ((name, argument) in CALLABLE and callable(value)):
                continue
            told = f"{argument}: expected "
            try:
                with warnings.catch_warnings(action="ignore"):
                    call.function(**{**call.arguments, argument: value})
            except ValueError as error:
                told = str(error)
            assert told.isprintable(), (argument, kind, told)
            named = f"{argument}: expected " if argument in CHOICES else names
            assert told.startswith(named), (argument, kind, told)
            assert len(told) < 400
