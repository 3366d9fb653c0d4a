"""Exported files are read by others: SDF and URDF by Drake, whose parser is SDF's own, USD by OpenUSD."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from machines import offset_case, random_robot
from pxr import Usd, UsdGeom, UsdPhysics, UsdValidation

import stewart_sym as ss

MACHINES = {
    "mathworks2002": ss.robots.mathworks2002,
    "tsai2000": ss.robots.tsai2000,
    "random": lambda: random_robot(np.random.default_rng(5)),
    "offset joints": lambda: offset_case(2)[0],
}
pytestmark = pytest.mark.filterwarnings("ignore:.*no place in the format")


def moving_mass(robot: ss.Robot) -> float:
    crosses = 0.0 if robot.offsets is None else robot.offsets.cross_mass.sum()
    return float(robot.M + robot.m_d.sum() + robot.m_u.sum() + crosses)


def parsed(text: str, form: str) -> Any:
    # Not at the top: Drake takes half a second, in every process that collects tests.
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import MultibodyPlant

    plant = MultibodyPlant(0.0)
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


def test_the_parser_of_sdf_finds_an_impossible_inertia() -> None:
    robot = MACHINES["random"]()
    text = ss.export_model(robot, "sdf").text
    start = text.index("<ixx>")
    broken = text[:start] + "<ixx>1e9" + text[text.index("</ixx>", start) :]
    with pytest.raises(RuntimeError, match="error: Failed to load"):
        parsed(broken, "sdf")


@pytest.mark.parametrize("name", MACHINES)
def test_the_parser_of_urdf_finds_the_tree_and_its_mass(name: str) -> None:
    robot = MACHINES[name]()
    plant = parsed(ss.export_model(robot, "urdf").text, "urdf")
    plant.Finalize()
    turns = 2 if robot.base_joint == "universal" else 3
    assert plant.num_velocities() == 6 * (turns + 1) + 6
    total = plant.CalcTotalMass(plant.CreateDefaultContext())
    np.testing.assert_allclose(total, moving_mass(robot))


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


def test_usd_places_bodies_and_joints_where_the_machine_has_them(stage: tuple[ss.Robot, Usd.Stage]) -> None:
    robot, opened = stage
    assert UsdGeom.GetStageMetersPerUnit(opened) == 1.0
    assert UsdGeom.GetStageUpAxis(opened) == "Z"
    cache = UsdGeom.XformCache()

    def placed(body: str, point: tuple[float, ...]) -> np.ndarray:
        return np.array(cache.GetLocalToWorldTransform(opened.GetPrimAtPath(body)).Transform(point))

    joints = [UsdPhysics.Joint(prim) for prim in opened.Traverse() if prim.IsA(UsdPhysics.Joint)]
    for joint in joints:
        sides = [
            placed(str(rel.GetTargets()[0]), tuple(map(float, point.Get())))
            for rel, point in (
                (joint.GetBody0Rel(), joint.GetLocalPos0Attr()),
                (joint.GetBody1Rel(), joint.GetLocalPos1Attr()),
            )
            if rel.GetTargets() and point.HasAuthoredValue()
        ]
        if len(sides) == 2 and not joint.GetPrim().IsA(UsdPhysics.PrismaticJoint):
            np.testing.assert_allclose(*sides, rtol=0, atol=1e-5 * np.abs(robot.b).max())
    mass = sum(
        UsdPhysics.MassAPI(prim).GetMassAttr().Get()
        for prim in opened.Traverse()
        if prim.HasAPI(UsdPhysics.MassAPI) and not prim.GetName().startswith("base")
    )
    np.testing.assert_allclose(mass, moving_mass(robot), rtol=1e-6)
    scene = UsdPhysics.Scene(opened.GetPrimAtPath("/machine/physics"))
    g = scene.GetGravityMagnitudeAttr().Get() * np.array(scene.GetGravityDirectionAttr().Get())
    np.testing.assert_allclose(g, robot.g, rtol=0, atol=1e-5)
