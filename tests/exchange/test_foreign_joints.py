"""Joints as others write them: masses between axes, platform frames, empty elements, closures of Drake."""

import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import mujoco
import numpy as np
import pytest
from command_line import rejects
from exported_models import exported, imported, written
from model_family import TOP, Edge, Family, family, grows, mjcf, urdf
from model_statics import InMujoco
from numpy.typing import NDArray

import stewart_sym as ss

Array = NDArray[np.float64]
MASS, OFF = 0.02, 0.002


def first_with(said: Callable[[Family], bool], urdf_: bool = False) -> tuple[int, Family]:
    """The first machine of the family, none with a fault, of which something holds."""
    made = ((seed, family(seed, urdf_)) for seed in range(400))
    return next((seed, each) for seed, each in made if not each.fault and not each.off and said(each))


def axes_at(made: Family, joint: str) -> list[Array]:
    """Axes of the hinges at one end of a leg, in the order of their names."""
    edges = sorted(
        (edge.name, edge.axis) for edge in (*made.edges, *made.cuts) if edge.name.startswith(f"{joint}_")
    )
    return [axis for _, axis in edges if axis is not None]


def with_mass(made: Family, name: str, point: Array, off: Array) -> Family:
    """The machine with 20 g in a body between axes, the center of mass off the point where they meet."""
    inertia = 1e-6 * np.eye(3)
    part = replace(made.parts[name], mass=MASS, center=point + off, inertia=inertia)
    return replace(made, parts={**made.parts, name: part})


def at_rest(found: ss.ImportedModel, engine: InMujoco, made: Family) -> tuple[Array, Array]:
    """Forces of the legs at home, here and in MuJoCo, (6,) each."""
    zero = np.zeros(3)
    motion = ss.Motion(R=np.eye(3), t=found.robot.home_position, omega=zero, v=zero, alpha=zero, a=zero)
    numbers = re.findall(r"\d 'lower(\d)' 'upper\d'", "\n".join(found.assumptions))
    F = ss.inverse_dynamics(found.robot, motion).F[[numbers.index(str(i)) for i in range(1, 7)]]
    truth = engine.forces([f"slide{i}" for i in range(1, 7)])
    return F, np.array([grows(made, i) for i in range(6)]) * truth


def universal(made: Family) -> bool:
    return "cross1_1" in made.parts and "cross1_2" not in made.parts


def three_hinges(made: Family) -> bool:
    return universal(made) and "end1_2" in made.parts


@pytest.mark.parametrize("name", ["cross1_1", "end1_1", "end1_2"])
def test_a_cross_with_its_mass_off_the_axes_is_imported_with_its_effect(name: str, tmp_path: Path) -> None:
    seed, made = first_with(three_hinges)
    joint = "base1" if name.startswith("cross") else "tip1"
    axes = axes_at(made, joint)
    point = np.linalg.lstsq(
        sum(np.eye(3) - np.outer(axis, axis) for axis in axes),
        sum(
            (np.eye(3) - np.outer(edge.axis, edge.axis)) @ edge.point
            for edge in (*made.edges, *made.cuts)
            if edge.name.startswith(f"{joint}_")
        ),
        rcond=None,
    )[0]
    # Across both neighboring axes, where no part takes over its weight's moment.
    pair = axes[:2] if name.endswith("_1") else axes[1:]
    off = OFF * np.cross(*pair) / np.linalg.norm(np.cross(*pair))
    errors = []
    for off_by in (np.zeros(3), off):
        changed = with_mass(made, name, point, off_by)
        text = mjcf(changed, seed)
        found = imported(text, tmp_path)
        stated = re.findall(r"off by up to (\S+) N", "\n".join(found.assumptions))
        (line,) = (each for each in found.assumptions if "between the axes" in each and repr(name) in each)
        assert ("leaves forces at rest as they are" in line) == (not off_by.any())
        F, truth = at_rest(found, InMujoco(text), changed)
        errors.append((float(np.abs(F - truth).max()), [float(value) for value in stated]))
    (exact, nothing), (error, (bound,)) = errors
    assert nothing == []
    assert exact < 1e-8 * np.abs(truth).max() < error < 1e-3 * np.abs(truth).max()
    assert bound == pytest.approx(error, rel=6e-3)


def test_axes_at_the_platform_that_miss_by_millimeters_are_imported_with_their_effect(tmp_path: Path) -> None:
    seed, made = first_with(three_hinges)
    first, second, _ = axes_at(made, "tip1")
    across = np.cross(first, second) / np.linalg.norm(np.cross(first, second))

    def moved(edges: tuple[Edge, ...]) -> tuple[Edge, ...]:
        return tuple(
            edge._replace(point=edge.point + 2.8e-3 * across) if edge.name == "tip1_2" else edge
            for edge in edges
        )

    text = mjcf(replace(made, edges=moved(made.edges), cuts=moved(made.cuts)), seed)
    found = imported(text, tmp_path)
    (stated,) = re.findall(r"leg \d: .* apart: .* off by up to (\S+) N", "\n".join(found.assumptions))
    F, truth = at_rest(found, InMujoco(text), made)
    assert float(stated) == pytest.approx(np.abs(F - truth).max(), rel=6e-3)
    assert float(stated) > 1e-5 * np.abs(truth).max()


@pytest.mark.parametrize("load", [0.5, 60.0])
def test_the_platform_is_the_body_that_the_legs_hold(load: float, tmp_path: Path) -> None:
    def loaded(made: Family) -> bool:
        part = made.parts.get("load")
        return part is not None and part.mass == load and "fork1" in made.parts and not made.align

    seed, made = first_with(loaded)
    text = mjcf(made, seed)
    found = imported(text, tmp_path)
    np.testing.assert_allclose(found.robot.home_position, InMujoco(text).frame(TOP)[1], rtol=0, atol=1e-12)
    start = f"platform: {TOP!r}, to which are fixed: "
    (line,) = (line for line in found.assumptions if line.startswith(start))
    assert "'load'" in line


@pytest.mark.parametrize("change", [("", 'align="true"'), ('alignfree="true"', "")])
@pytest.mark.parametrize("turned", [False, True])
def test_the_frame_of_an_aligned_platform_is_that_of_mujoco(
    change: tuple[str, str], turned: bool, tmp_path: Path
) -> None:
    compiler, align = change
    text = re.sub("<custom>.*?</custom>", "", exported().text, flags=re.DOTALL)
    text = text.replace("<compiler ", f"<compiler {compiler} ")
    text = text.replace('<freejoint name="free"', f'<freejoint name="free" {align}')
    inertial = re.search(r'<body name="platform".*?(<inertial [^>]*/>)', text, re.DOTALL)
    assert inertial is not None
    diagonal = '<inertial mass="40" pos="0.01 0.02 0.03" diaginertia="0.9 0.8 0.7"'
    text = text.replace(inertial[1], diagonal + (' euler="0.3 0.2 0.1"/>' if turned else "/>"))
    found = imported(text, tmp_path)
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    np.testing.assert_allclose(found.robot.home_position, data.body("platform").xpos, rtol=0, atol=1e-12)
    points = np.array([data.site(f"tip_{i}_b").xpos for i in range(1, 7)])
    np.testing.assert_allclose(found.robot.p, points - data.body("platform").xpos, rtol=0, atol=1e-12)
    np.testing.assert_allclose(found.robot.R_0, 0.0, atol=1e-12)
    assert any("the frame of 'platform', which is taken" in line for line in found.assumptions)


@pytest.mark.slow
def test_ball_constraints_close_a_urdf_as_its_loops_do(tmp_path: Path) -> None:
    def by_balls(made: Family) -> bool:
        return all(edge.kind == "ball" for edge in made.cuts)

    seed, made = first_with(by_balls, True)
    made = replace(made, gravity=np.array([0.0, 0.0, -9.81]))
    alone = ss.import_model(written(ss.ExportedModel(*urdf(made, seed, drake=True)), tmp_path / "alone.urdf"))
    beside = ss.import_model(
        written(ss.ExportedModel(*urdf(made, seed, drake=False)), tmp_path / "beside.urdf")
    )
    assert alone.robot.to_dict() == beside.robot.to_dict()
    assert (
        "left out: friction of closures, armatures, and the note (the file NAME.loops.json is missing)"
        in (alone.assumptions)
    )


@pytest.mark.parametrize(
    ("form", "change", "said"),
    [
        ("drake", ("_body_A>upper_1<", "_body_A>upper_9<"), "ball_constraint 1: link 'upper_9': missing"),
        ("drake", ("_p_AP>0.0 0.0 0.0<", "_p_AP>0.0 0.0<"), "ball_constraint 1: p_AP: expected 3 numbers"),
        ("urdf", ('_body_A name="upper_1"', '_body_A name="upper_9"'), "1: link 'upper_9': missing"),
        ("urdf", ('_p_AP value="0.0 0.0 0.0"', '_p_AP value="0"'), "1: p_AP: expected 3 numbers, got '0'"),
    ],
)
def test_a_broken_ball_constraint_is_one_line(
    form: str, change: tuple[str, str], said: str, tmp_path: Path
) -> None:
    text = exported(form).text
    assert change[0] in text
    rejects(re.escape(said), imported, text.replace(*change, 1), tmp_path)


FRAMES = (
    '<frame name="wrist" attached_to="upper_3"><pose>0.1 0.2 0.3 0.4 0.5 0.6</pose></frame>'
    '<frame name="hand" attached_to="wrist"/><frame name="deck" attached_to="tip_1"/>'
)


def test_joints_of_sdf_may_name_frames_since_1_7(tmp_path: Path) -> None:
    text = exported("sdf").text
    named = text.replace("<parent>upper_3</parent>", "<parent>hand</parent>")
    point = r"(<child>)platform(</child>\s*<pose)(>)"
    head, tail = named[: named.index('name="tip_3"')], named[named.index('name="tip_3"') :]
    tail, count = re.subn(point, r'\1deck\2 relative_to="platform"\3', tail, count=1)
    assert count == 1
    named = (head + tail).replace("<link", f"{FRAMES}<link", 1)
    robots = [imported(each, tmp_path).robot for each in (text, named)]
    np.testing.assert_allclose(robots[1].p, robots[0].p, rtol=0, atol=1e-12)
    old = named.replace('version="1.9"', 'version="1.6"')
    rejects("link 'hand': missing", imported, old, tmp_path)
    circle = named.replace('attached_to="wrist"', 'attached_to="hand"')
    rejects("link 'hand': missing", imported, circle, tmp_path)
