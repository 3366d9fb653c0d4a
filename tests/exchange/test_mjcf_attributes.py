"""Attributes of MJCF: forces at rest are those of MuJoCo, or one line names the attribute with its effect."""

import re
import sys
import warnings
from pathlib import Path

import mujoco
import numpy as np
import pytest
from command_line import rejects
from exported_models import exported, imported
from model_statics import balanced
from numpy.typing import NDArray

import stewart_sym as ss

SAME = 1e-8
OFF = re.compile(r"are off by up to (\S+) N|, (\S+) N of force in the pose")
PLAIN = re.sub("<custom>.*?</custom>", "", exported().text, flags=re.DOTALL)
WORLD, EQUALITY, ACTUATOR, END = "</worldbody>", "</equality>", "</actuator>", "</mujoco>"
HINGE, SLIDE, BASE_LINK = 'name="base_1_2"', 'name="leg_1" type="slide"', 'name="lower_1"'
TOP_MASS = re.search(r'<inertial mass="40[^>]*/>', PLAIN)[0]
FREE = '<freejoint name="free" />'
COMPILER, OPTION, MOTOR = "<compiler", "<option", '<motor name="leg_1" joint="leg_1"'
TETRAHEDRON = '<mesh name="m" vertex="0 0 0  0.3 0 0  0 0.3 0  0 0 0.3"/>'
LOAD = '<body name="load" pos="0 0 1"><freejoint/><geom size="0.05" mass="2"/></body>'
GEOM_TOP = '<geom type="{}" size="0.1 0.2 0.05" density="700" pos="0.01 0.02 0.03" euler="0.3 0.2 0.1"/>'
TENDON = '<tendon><fixed name="rope" {}><joint joint="base_1_2" coef="1"/></fixed></tendon></mujoco>'
ROPE = (
    '<tendon><spatial name="rope" {}><site site="tip_1_a"/><site site="tip_3_a"/></spatial></tendon></mujoco>'
)

Change = tuple[str, str]


def at(place: str, attributes: str) -> Change:
    """More attributes of an element."""
    return place, f"{place} {attributes}"


def before(end: str, elements: str) -> Change:
    return end, elements + end


SHAPES = ("sphere", "box", "capsule", "cylinder", "ellipsoid")
ATTRIBUTES: dict[str, tuple[str | Change, ...]] = {
    # Compiler.
    "autolimits": ("error: `range` but not `limited`", ('autolimits="true"', 'autolimits="false"')),
    "angle": ("", ('angle="radian"', 'angle="degree"')),
    "eulerseq": ("", at(COMPILER, 'eulerseq="ZYX"'), (TOP_MASS, GEOM_TOP.format("box"))),
    "inertiafromgeom": ("", at(COMPILER, 'inertiafromgeom="true"'), ('density="0"', 'density="900"')),
    "inertiagrouprange": (
        "",
        at(COMPILER, 'inertiagrouprange="0 1"'),
        (TOP_MASS, '<geom size="0.1" group="2"/><geom size="0.2" mass="9"/>'),
    ),
    "boundmass": ("", at(COMPILER, 'boundmass="2"')),
    "boundinertia": ("", at(COMPILER, 'boundinertia="0.05"')),
    "balanceinertia": (
        "",
        at(COMPILER, 'balanceinertia="true"'),
        ('fullinertia="0.01 0.08', 'fullinertia="0.2 0.08'),
    ),
    "settotalmass": ("settotalmass", at(COMPILER, 'settotalmass="50"')),
    "alignfree": ("freejoint align", at(COMPILER, 'alignfree="true"')),
    "fusestatic": ("", at(COMPILER, 'fusestatic="true"')),
    "discardvisual": ("", at(COMPILER, 'discardvisual="true"')),
    "coordinate": ("error: .*coordinate", at(COMPILER, 'coordinate="global"')),
    # Options.
    "gravity": ("", ('gravity="0.0 0.0 -9.81"', 'gravity="1 2 -3"')),
    "density": ("density 1.2 of the medium", at(OPTION, 'density="1.2"')),
    "viscosity": ("viscosity 0.1 of the medium", at(OPTION, 'viscosity="0.1"')),
    "wind": ("springs and other loads", at(OPTION, 'density="1.2" wind="9 0 0"')),
    "actuatorgroupdisable": ("that the option disables actuators", at(OPTION, 'actuatorgroupdisable="0"')),
    **{
        f"no {flag}": (said, before("<worldbody>", f'<option><flag {flag}="disable"/></option>'))
        for flag, said in (
            ("gravity", ""),
            ("spring", ""),
            ("damper", ""),
            ("limit", "which MuJoCo does not apply"),
            ("frictionloss", ""),
            ("clampctrl", ""),
            ("contact", ""),
            ("actuation", "that the option disables actuators"),
            ("equality", "error: option: flag: equality: expected enable"),
            ("constraint", "error: option: flag: constraint: expected enable"),
        )
    },
    # Bodies and shapes.
    "gravcomp": ("gravcomp 0.5 of body 'lower_1'", at(BASE_LINK, 'gravcomp="0.5"')),
    **{f"geom {kind}": ("", (TOP_MASS, GEOM_TOP.format(kind))) for kind in SHAPES},
    "shellinertia": ("", (TOP_MASS, '<geom size="0.2" mass="9" shellinertia="true"/>')),
    "mesh": ("", before("</asset>", TETRAHEDRON), (TOP_MASS, '<geom type="mesh" mesh="m" density="2000"/>')),
    "contype": ("contacts of shapes", ('conaffinity="0"', 'conaffinity="1"')),
    "contact pair": (
        "contacts of shapes",
        ('rgba="0.35 0.4 0.47 1.0"', 'rgba="0 0 0 1" name="g"'),
        at('<geom type="sphere"', 'name="h"'),
        before(END, '<contact><pair geom1="g" geom2="h"/></contact>'),
    ),
    "childclass": (
        "armature 3 of joints 'base_1_1', 'base_1_2'",
        before("</default>", '<default class="c"><joint armature="3"/></default>'),
        at(BASE_LINK, 'childclass="c"'),
    ),
    "frame": (
        "",
        ('<body name="lower_1"', '<frame pos="0 0 0"><body name="lower_1"'),
        ('<body name="lower_2"', '</frame><body name="lower_2"'),
    ),
    "mocap": ("", before(WORLD, '<body mocap="true"><geom size="0.1"/></body>')),
    "bodies on the platform": (
        "",
        (
            FREE,
            f'{FREE}<body pos="0.3 0.1 0.2" zaxis="1 2 -3"><geom size="0.1"/>'
            '<frame axisangle="1 2 3 0.9">'
            '<geom type="box" size="0.1 0.2 0.3" density="500" xyaxes="1 2 3 -1 2 5"/>'
            "</frame></body>",
        ),
    ),
    "weld": ("", before(WORLD, LOAD), before(EQUALITY, '<weld body1="platform" body2="load"/>')),
    # Joints.
    "damping": ("", ('damping="20.0"', 'damping="3"')),
    "damping, polynomial": ("nonlinear damping 1 of joint", ('damping="20.0"', 'damping="3 1"')),
    "armature": ("armatures of the slides", at(SLIDE, 'armature="7"')),
    "frictionloss": ("frictionloss 5 of joint 'leg_1'", at(SLIDE, 'frictionloss="5"')),
    "stiffness": ("stiffness 30 of joint 'base_1_2'", at(HINGE, 'stiffness="30" springref="0.2"')),
    "springref of a slide": ("stiffness 900 of joint 'leg_1'", at(SLIDE, 'stiffness="900" springref="0.5"')),
    "springdamper": ("stiffness .* of joint 'base_1_2'", at(HINGE, 'springdamper="0.1 1"')),
    "springyield": ("stiffness 30 of joint", at(HINGE, 'stiffness="30" springref="0.2" springyield="1"')),
    "range of a hinge": ("limits -1 to 1 rad of joint 'base_1_2'", at(HINGE, 'range="-1 1"')),
    "limited": (
        "range 0.55 0.95, which MuJoCo does not apply, of joint 'leg_1'",
        at(SLIDE, 'limited="false"'),
    ),
    "margin": ("margin 0.01 of joint 'leg_1'", at(SLIDE, 'margin="0.01"')),
    "actuatorfrcrange": ("", at(SLIDE, 'actuatorfrcrange="-100 100"')),
    "actuatorgravcomp": (
        "gravcomp 1 of body",
        at(SLIDE, 'actuatorgravcomp="true"'),
        at(BASE_LINK, 'gravcomp="1"'),
    ),
    "solreflimit": ("loop closures and limits: rigid", at(SLIDE, 'solreflimit="0.02 1"')),
    "pos of a slide": ("", at(SLIDE, 'pos="0.1 0.2 0.3"')),
    "pos of a hinge": ("joint offsets", at(HINGE, 'pos="0 0 0.05"')),
    "axis": (
        "",
        ('type="slide" axis="1.0 0.0 0.0"', 'type="slide" axis="-2 0 0"'),
        ('ref="0.751', 'ref="-0.751'),
        ('range="0.55 0.95"', 'range="-0.95 -0.55"'),
    ),
    "align": ("freejoint align", (FREE, '<freejoint name="free" align="true"/>')),
    "user": ("", at(HINGE, 'group="3"')),
    # Equality, tendons, and actuators.
    "polycoef": (
        "equality joint 'gear'",
        before(EQUALITY, '<joint name="gear" joint1="base_1_2" joint2="base_2_2" polycoef="0 1 0 0 0"/>'),
    ),
    "active": ("", before(EQUALITY, '<joint joint1="base_1_2" active="false"/>')),
    "solref": ("loop closures and limits: rigid", at("<connect", 'solref="0.1 1"')),
    "tendon": ("tendon 'rope'", (END, TENDON.format('stiffness="40" springlength="0.3"'))),
    "spatial tendon": ("tendon 'rope'", (END, ROPE.format('stiffness="40" springlength="0.1"'))),
    "equality tendon": (
        "equality tendon",
        (END, TENDON.format("")),
        before(EQUALITY, '<tendon tendon1="rope"/>'),
    ),
    "actuator of a tendon": (
        "actuator 'pull', which does not drive a prismatic joint",
        (END, TENDON.format("")),
        before(ACTUATOR, '<motor name="pull" tendon="rope"/>'),
    ),
    "actuator of a site": ("actuator 'jet', which", before(ACTUATOR, '<motor name="jet" site="tip_1_a"/>')),
    "adhesion": (
        "actuator 'actuator 6', which",
        before(ACTUATOR, '<adhesion body="platform" ctrlrange="0 1"/>'),
    ),
    "gear": ("", (MOTOR, f'{MOTOR} gear="-3"')),
    "uneven": (
        "the limit of 500 N in one direction of actuator 'leg_1': 600 N",
        ('ctrlrange="-500.0 500.0" forcerange="-500.0 500.0"', 'gear="50" ctrlrange="-10 12"'),
    ),
    **{
        f"<{kind}>": (
            "gain, bias and dynamics of actuator 'x'",
            before(ACTUATOR, f'<{kind} name="x" joint="leg_1" {given}/>'),
        )
        for kind, given in (
            ("position", 'kp="30" dampratio="1" inheritrange="1"'),
            ("velocity", 'kv="3"'),
            ("intvelocity", 'kp="3" actrange="0 1"'),
            ("damper", 'kv="3" ctrlrange="0 1"'),
            ("cylinder", 'area="0.1" timeconst="1"'),
            ("muscle", ""),
            ("general", 'dyntype="filter" dynprm="0.1"'),
            ("dcmotor", 'motorconst="0.1" resistance="1"'),
        )
    },
    "keyframe": ("", before(END, f'<keyframe><key qpos="{"0 " * 25}"/></keyframe>')),
    "sensor": ("", before(END, '<sensor><jointpos joint="leg_1"/></sensor>')),
}
"""Changes of the exported hexapod without its note, and a line of the import that names the attribute."""


def changed(text: str, changes: list[Change]) -> str:
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new, 1)
    return text


def forces_in_mujoco(model: mujoco.MjModel) -> NDArray[np.float64]:
    """Forces of the slides, (6,), that hold the model with its springs and loop closures."""
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    J = np.asarray(data.efc_J).reshape(-1, model.nv)
    loops = (mujoco.mjtEq.mjEQ_CONNECT, mujoco.mjtEq.mjEQ_WELD)
    kept = [
        kind == mujoco.mjtConstraint.mjCNSTR_EQUALITY and model.eq_type[i] in [int(each) for each in loops]
        for kind, i in zip(data.efc_type, data.efc_id, strict=True)
    ]
    slides = [int(model.joint(f"leg_{i}").dofadr[0]) for i in range(1, 7)]
    passive = data.qfrc_spring + data.qfrc_gravcomp + data.qfrc_fluid
    return balanced(data.qfrc_bias - passive, J[kept], slides)


def need_same_platform(robot: ss.Robot, model: mujoco.MjModel) -> None:
    """Compare mass, center of mass, and inertia of the platform with what it carries."""
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    roots = {i for i in range(model.nbody) if model.body(i).name in ("platform", "load")}
    parts = [i for i in range(model.nbody) if int(model.body_rootid[i]) in roots]
    mass = model.body_mass[parts]
    center = mass @ data.xipos[parts] / mass.sum()
    inertia = np.zeros((3, 3))
    for i, m in zip(parts, mass, strict=True):
        r, axes = data.xipos[i] - center, data.ximat[i].reshape(3, 3)
        inertia += axes @ np.diag(model.body_inertia[i]) @ axes.T + m * (r @ r * np.eye(3) - np.outer(r, r))
    np.testing.assert_allclose(robot.M, mass.sum(), rtol=1e-12)
    np.testing.assert_allclose(robot.R_0, center - data.body("platform").xpos, rtol=0, atol=1e-12)
    np.testing.assert_allclose(robot.I_p, inertia, rtol=0, atol=1e-12 * np.abs(inertia).max())


def at_home(robot: ss.Robot) -> NDArray[np.float64]:
    zero = np.zeros(3)
    pose = ss.Motion(R=np.eye(3), t=robot.home_position, omega=zero, v=zero, alpha=zero, a=zero)
    return ss.inverse_dynamics(robot, pose).F


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("name", ATTRIBUTES)
def test_an_attribute_has_the_effect_that_it_has_in_mujoco_or_is_named(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    said, *changes = ATTRIBUTES[name]
    text = changed(PLAIN, changes)
    if said.startswith("error: "):
        rejects(said.removeprefix("error: "), imported, text, tmp_path)
        return
    found = imported(text, tmp_path)
    assert not Path("MUJOCO_LOG.TXT").exists()
    assert re.search(said, "\n".join(found.assumptions)), found.assumptions
    model = mujoco.MjModel.from_xml_string(text)
    signs = np.array([model.joint(f"leg_{i}").axis[0] for i in range(1, 7)])
    need_same_platform(found.robot, model)
    truth, robot = signs * forces_in_mujoco(model), found.robot
    stated = sum(float(one or two) for line in found.assumptions for one, two in OFF.findall(line))
    error = np.abs(at_home(robot) - truth).max()
    assert error <= SAME * np.abs(truth).max() + 1.005 * stated
    assert error >= 0.99 * stated
    moving = model.body_mass[[model.body_weldid[i] != 0 for i in range(model.nbody)]].sum()
    np.testing.assert_allclose(robot.M + robot.m_d.sum() + robot.m_u.sum(), moving, rtol=1e-12)


@pytest.mark.parametrize(
    ("flag", "field", "value"),
    [
        ("damper", "C_u", 0.0),
        ("damper", "C_p", 0.0),
        ("limit", "length_limits", [0.0, np.inf]),
        ("gravity", "g", 0.0),
    ],
)
def test_a_disabled_feature_is_not_imported(flag: str, field: str, value: object, tmp_path: Path) -> None:
    option = f'<option><flag {flag}="disable"/></option>'
    found = getattr(imported(changed(PLAIN, [before("<worldbody>", option)]), tmp_path).robot, field)
    np.testing.assert_array_equal(found, np.broadcast_to(value, found.shape))


LEG = """
<body name="lower" pos="{b}" xyaxes="{frame}"><joint axis="{k}"/><joint axis="0 1 0"/>
  <inertial mass="3" pos="0.2 0 0" diaginertia="0.01 0.08 0.08"/>
  <body name="upper" pos="{L} 0 0"><joint name="slide" type="slide" axis="1 0 0"/>
    <geom type="mesh" mesh="part" density="900"/><site name="tip"/></body></body>"""


def replicated() -> dict[str, str]:
    """A platform on two triples of legs, with a mesh and the legs in files of their own."""
    legs, tops, connects = [], [], []
    for name, turn, top in (("a", 10.0, 50.0), ("b", -10.0, -50.0)):
        b, p = (
            np.array([radius * np.cos(np.radians(angle)), radius * np.sin(np.radians(angle)), 0.0])
            for radius, angle in ((0.6, turn), (0.4, top))
        )
        s = p - b + np.array([0.0, 0.0, 0.6])
        L = float(np.linalg.norm(s))
        y = np.cross([0.0, 0.0, 1.0], s / L)
        y /= np.linalg.norm(y)
        R = np.stack([s / L, y, np.cross(s / L, y)], axis=-1)
        leg = LEG.format(b=text(b), frame=text(R[:, :2].T), k=text(R[2]), L=repr(L))
        legs.append(f'<replicate count="3" euler="0 0 120" sep="{name}">{leg}</replicate>')
        site = f'<site name="top" pos="{text(p)}"/>'
        tops.append(f'<replicate count="3" euler="0 0 120" sep="{name}">{site}</replicate>')
        connects += [f'<connect site1="tip{name}{i}" site2="top{name}{i}"/>' for i in range(3)]
    main = f"""<mujoco model="copies"><compiler angle="degree" meshdir="parts"/>
      <asset><mesh name="part" file="part.obj"/></asset>
      <worldbody><frame euler="0 0 20"><include file="legs.xml"/>
        <body name="top" pos="0 0 0.6"><freejoint/><inertial mass="20" pos="0 0 0.1" diaginertia="1 1 2"/>
        {"".join(tops)}</body></frame></worldbody>
      <equality>{"".join(connects)}</equality></mujoco>"""
    corners = "v -0.3 -0.01 -0.01\nv 0 0.02 0\nv 0 -0.01 0.02\nv 0 -0.01 -0.02\n"
    faces = "f 1 3 2\nf 1 4 3\nf 1 2 4\nf 2 3 4\n"
    return {
        "model.xml": main,
        "legs.xml": f"<mujoco>{''.join(legs)}</mujoco>",
        "parts/part.obj": corners + faces,
    }


def text(values: NDArray[np.float64]) -> str:
    return " ".join(repr(float(value)) for value in np.ravel(values))


def test_replicated_legs_with_meshes_in_included_files_are_those_of_mujoco(tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    for name, content in replicated().items():
        (tmp_path / name).write_text(content, encoding="utf-8")
    found = ss.import_model(tmp_path / "model.xml")
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "model.xml"))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    slides = [int(model.joint(f"slide{name}{i}").dofadr[0]) for name in "ab" for i in range(3)]
    truth = balanced(data.qfrc_bias, np.asarray(data.efc_J).reshape(-1, model.nv), slides)
    np.testing.assert_allclose(at_home(found.robot), truth, rtol=0, atol=SAME * np.abs(truth).max())
    np.testing.assert_allclose(found.robot.m_u, model.body("uppera0").mass[0], rtol=1e-12)


def test_what_mujoco_rejects_is_one_line(tmp_path: Path) -> None:
    for change, said in (
        (at(SLIDE, 'dampping="20"'), "unrecognized attribute: 'dampping' Element 'joint', line"),
        (('"tip_4_a" site2', '"tip_9" site2'), "tip_9"),
        (('name="lower_2"', 'name="lower_1"'), "repeated name 'lower_1'"),
        (before("<worldbody>", '<include file="x.xml"/>'), "x.xml"),
        ((TOP_MASS, '<geom type="mesh" mesh="m"/>'), "mesh 'm' not found"),
    ):
        with warnings.catch_warnings(action="error"):
            rejects(rf"model\.xml: MuJoCo: .*{said}", imported, changed(PLAIN, [change]), tmp_path)


def test_without_mujoco_one_line_names_the_extra(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "mujoco", None)
    with pytest.raises(ImportError, match=r'MJCF needs MuJoCo: pip install "stewart-sym\[exchange\]"\Z'):
        imported(PLAIN, tmp_path)
