"""Exported files are read by Drake and OpenUSD, and accelerate in MuJoCo and Pinocchio as ours do."""

import dataclasses
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from exported_mujoco import Exported
from exported_pinocchio import accelerations
from machines import offset_case, random_motion, random_robot
from model_statics import balanced
from numpy.typing import NDArray
from pxr import Usd, UsdValidation

import stewart_sym as ss
from stewart_sym.plausibility.level_poses import level_home

MACHINES = {
    "mathworks2002": ss.robots.mathworks2002,
    "tsai2000": ss.robots.tsai2000,
    "random": lambda: random_robot(np.random.default_rng(5)),
    "offset joints": lambda: offset_case(2)[0],
}
pytestmark = pytest.mark.filterwarnings("ignore:.*no place in the format")


def parsed(text: str, form: str, step: float = 0.0) -> Any:
    # Not at the top: Drake takes half a second, in every process that collects tests.
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import MultibodyPlant

    plant = MultibodyPlant(step)
    Parser(plant).AddModelsFromString(text, form)
    return plant


@pytest.mark.parametrize("name", MACHINES)
def test_the_parser_of_sdf_finds_the_machine(name: str) -> None:
    robot = MACHINES[name]()
    plant = parsed(ss.export_model(robot, "sdf").text, "sdf")
    kinds = [plant.get_joint(index).type_name() for index in plant.GetJointIndices()]
    at_base = ["universal"] if robot.base_joint == "universal" else ["ball_rpy"]
    if robot.offsets is not None:
        at_base = ["revolute", "revolute"]
    expected = {"prismatic": 6, "weld": 1}
    for kind in (*at_base, "ball_rpy"):
        expected[kind] = expected.get(kind, 0) + 6
    assert {kind: kinds.count(kind) for kind in set(kinds)} == expected
    for i in range(6):
        slide = plant.GetJointByName(f"leg_{i + 1}")
        np.testing.assert_allclose(slide.translation_axis(), [1, 0, 0], atol=1e-12)
        assert slide.default_damping() == robot.C_p[i]
        for part, mass in (("lower", robot.m_d), ("upper", robot.m_u)):
            assert plant.GetBodyByName(f"{part}_{i + 1}").default_mass() == mass[i]


def closures_in_drake(
    robot: ss.Robot, form: str
) -> tuple[Any, Any, NDArray[np.float64], NDArray[np.float64]]:
    """The plant at home, its context, how far closures are open, (6, 3), and their Jacobian, (18, n)."""
    from pydrake.math import RigidTransform
    from pydrake.multibody.tree import JacobianWrtVariable

    text = ss.export_model(robot, form).text
    plant = parsed(text, "urdf" if form == "urdf" else "sdf", 1e-3)
    plant.mutable_gravity_field().set_gravity_vector(robot.g)
    plant.Finalize()
    context, world = plant.CreateDefaultContext(), plant.world_frame()
    plant.SetFreeBodyPose(context, plant.GetBodyByName("platform"), RigidTransform(robot.home_position))
    gaps, rows = [], []
    values = re.findall(r'<drake:ball_constraint_(?:body|p)_\w+(?:>| \w+=")([^<"]+)', text)
    for one, first, other, second in zip(*(values[i::4] for i in range(4)), strict=True):
        ends = []
        for body, place in ((one, first), (other, second)):
            frame, point = plant.GetFrameByName(body), np.array(place.split(), dtype=np.float64)
            place = plant.CalcPointsPositions(context, frame, point, world).ravel()
            kind = JacobianWrtVariable.kV
            J = plant.CalcJacobianTranslationalVelocity(context, kind, frame, point, world, world)
            ends.append((place, J))
        gaps.append(ends[0][0] - ends[1][0])
        rows.append(ends[0][1] - ends[1][1])
    return plant, context, np.array(gaps), np.concatenate(rows)


@pytest.mark.parametrize("form", ["drake", "urdf"])
@pytest.mark.parametrize("name", MACHINES)
def test_drake_closes_the_loops_and_needs_our_forces_at_rest(name: str, form: str) -> None:
    robot = MACHINES[name]()
    if robot.home_position is None:
        robot = dataclasses.replace(robot, home_position=level_home(robot))
    plant, context, gaps, J = closures_in_drake(robot, form)
    assert plant.num_constraints() == plant.num_actuators() == len(gaps) == 6
    assert np.abs(gaps).max() < 1e-12
    slides = [plant.GetJointByName(f"leg_{i}").velocity_start() for i in range(1, 7)]
    found = balanced(-plant.CalcGravityGeneralizedForces(context), J, slides)
    zero = np.zeros(3)
    at_home = ss.Motion(R=np.eye(3), t=robot.home_position, omega=zero, v=zero, alpha=zero, a=zero)
    truth = ss.inverse_dynamics(robot, at_home).F
    np.testing.assert_allclose(found, truth, rtol=0, atol=1e-9 * np.abs(truth).max())


@pytest.fixture(params=MACHINES)
def stage(request: pytest.FixtureRequest, tmp_path: Path) -> tuple[ss.Robot, Usd.Stage]:
    robot = MACHINES[request.param]()
    path = tmp_path / "machine.usda"
    path.write_text(ss.export_model(robot, "usd").text, encoding="utf-8")
    return robot, Usd.Stage.Open(str(path))


def test_usd_is_valid_and_has_only_attributes_of_its_schemas(stage: tuple[ss.Robot, Usd.Stage]) -> None:
    robot, opened = stage
    registry = UsdValidation.ValidationRegistry()
    context = UsdValidation.ValidationContext(registry.GetOrLoadAllValidators())
    assert [error.GetMessage() for error in context.Validate(opened)] == []
    unknown = {
        name
        for prim in opened.Traverse()
        for name in prim.GetAuthoredPropertyNames()
        if name not in prim.GetPrimDefinition().GetPropertyNames() and not name.startswith("xformOp")
    }
    assert unknown == set()
    kinds = [str(prim.GetTypeName()) for prim in opened.Traverse()]
    turns, balls = {"universal": (12, 6), "spherical": (0, 12)}[robot.base_joint]
    expected = {"Revolute": turns, "Spherical": balls, "Prismatic": 6, "Fixed": 1}
    assert {kind: kinds.count(f"Physics{kind}Joint") for kind in expected} == expected


SEEDS = range(4)
OFFSET_SEEDS = range(2)
NONE = np.zeros(6)
MUJOCO, PINOCCHIO = 4e-6, 1e-9
"""Largest error over the pose's largest acceleration."""

Case = tuple[ss.Robot, ss.Motion, NDArray[np.float64], NDArray[np.float64]]


def case(seed: int, **friction: NDArray[np.float64]) -> Case:
    """A random machine, one in four with spherical base joints, a pose, forces, and [a; alpha] under them."""
    rng = np.random.default_rng(seed)
    robot = random_robot(rng, "spherical" if seed % 4 == 3 else "universal")
    robot = dataclasses.replace(robot, **friction)
    motion = random_motion(rng, robot)
    F = ss.inverse_dynamics(robot, motion).F + robot.M * rng.normal(size=6)
    return robot, motion, F, np.concatenate(ss.forward_dynamics(robot, motion, F=F)[:2])


def off(found: NDArray[np.float64], truth: NDArray[np.float64]) -> float:
    return float(np.abs(found - truth).max() / np.abs(truth).max())


def test_mujoco_accelerates_the_exported_machine_as_we_do() -> None:
    worst = {}
    for seed in SEEDS:
        # Closures have no friction there.
        robot, motion, F, truth = case(seed, C_s=NONE)
        worst[seed] = off(Exported(robot).accelerations(motion, F), truth)
    assert max(worst.values()) < MUJOCO, worst


def offset_machine(seed: int) -> Case:
    """A random machine with offset joints, a pose, forces, and [a; alpha] under them by the reference."""
    robot, motion = offset_case(seed)
    robot = dataclasses.replace(robot, C_s=NONE)
    F = ss.inverse_dynamics(robot, motion).F + robot.M * np.random.default_rng(seed).normal(size=6)
    found = ss.forward_dynamics(robot, motion, F=F, backend="reference")
    return robot, motion, F, np.concatenate(found[:2])


@pytest.mark.slow
def test_machines_with_offset_joints_accelerate_in_both_engines_as_in_the_reference() -> None:
    worst = {}
    for seed in OFFSET_SEEDS:
        robot, motion, F, truth = offset_machine(seed)
        worst[seed] = (
            off(Exported(robot).accelerations(motion, F), truth),
            off(accelerations(robot, motion, F), truth),
        )
    assert max(each for each, _ in worst.values()) < MUJOCO, worst
    assert max(each for _, each in worst.values()) < PINOCCHIO, worst
