"""Random machines, motions and paths for the tests: every leg different in every parameter, everything on.

Poses are drawn where the mechanics is well posed (H well conditioned, legs well away from their universal
axes), rates to the machine's own scale of time.
"""

import dataclasses
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from stewart_sym import robots
from stewart_sym.derive.mechanics.formulation import Formulation
from stewart_sym.motion.motion import Motion
from stewart_sym.motion.rotation import cross
from stewart_sym.robot.drive import Drive
from stewart_sym.robot.offsets import JointOffsets
from stewart_sym.robot.robot import Robot

Array = NDArray[np.float64]

GRAVITY = 9.81
MAX_CONDITION = 60.0
MIN_JOINT_SINE = 0.35


def random_robot(
    rng: np.random.Generator, base_joint: str = "universal", friction: bool = True, scale: float | None = None
) -> Robot:
    """A machine of random size (0.1-5 m, or `scale`), masses 1-1000 kg, tilted gravity.

    base_joint "spherical": the legs are axisymmetric. friction False: all eighteen coefficients are 0.
    """
    size = scale if scale is not None else _log_uniform(rng, 0.1, 5.0)
    b = _hexagon(rng, size, [-12, 12, 108, 132, 228, 252])
    p = _hexagon(rng, 0.6 * size, [-48, 48, 72, 168, 192, -72])
    M = _log_uniform(rng, 1.0, 1000.0)
    m_d, m_u = np.array([[_log_uniform(rng, 1.0, 1000.0) for _ in range(6)] for _ in range(2)])
    axial = base_joint == "spherical"
    off_axis = 0.0 if axial else 0.1
    r_d0 = size * np.column_stack([rng.uniform(0.1, 0.6, 6), off_axis * rng.normal(size=(6, 2))])
    r_u0 = size * np.column_stack([-rng.uniform(0.1, 0.6, 6), off_axis * rng.normal(size=(6, 2))])
    home = home_position(b, size) + p - b
    k = np.zeros((6, 3)) if axial else np.array([_axis_across(rng, direction) for direction in home])
    damping = M * np.sqrt(GRAVITY / size) * rng.uniform(0.02, 0.2, (3, 6)) if friction else np.zeros((3, 6))
    return Robot(
        name="random",
        base_joint=base_joint,
        g=GRAVITY * _unit(np.array([0.0, 0.0, -1.0]) + 0.5 * rng.normal(size=3)),
        M=M,
        R_0=0.2 * size * rng.normal(size=3),
        I_p=M * _inertia_per_mass(rng, size),
        b=b,
        p=p,
        k=k,
        m_d=m_d,
        r_d0=r_d0,
        I_d0=np.array([m * _inertia_per_mass(rng, size, axial) for m in m_d]),
        m_u=m_u,
        r_u0=r_u0,
        I_u0=np.array([m * _inertia_per_mass(rng, size, axial) for m in m_u]),
        C_u=damping[0] * size**2,
        C_p=damping[1],
        C_s=damping[2] * size**2,
        length_limits=np.tile([0.0, np.inf], (6, 1)),
        force_limit=np.full(6, np.inf),
        speed_limit=np.full(6, np.inf),
    )


def in_axes(robot: Robot, base: Array) -> Robot:
    """The same machine with both frames turned: x becomes `base` x."""
    return dataclasses.replace(
        robot,
        b=robot.b @ base.T,
        k=robot.k @ base.T,
        g=base @ robot.g,
        p=robot.p @ base.T,
        R_0=base @ robot.R_0,
        I_p=base @ robot.I_p @ base.T,
    )


def with_random_rotors(rng: np.random.Generator, robot: Robot) -> Robot:
    """The machine with a rotor in each leg, whose inertia is a share of the lower part's.

    It turns so fast that it resists like a tenth to ten times the upper part; half of the screws are
    left-handed.
    """
    axial = np.array([np.linalg.eigvalsh(inertia)[0] for inertia in robot.I_d0])
    inertia = axial * rng.uniform(0.1, 0.5, 6)
    mass = robot.m_u * np.exp(rng.uniform(-2.3, 2.3, 6))
    lead = 2 * np.pi * np.sqrt(inertia / mass) * rng.permutation([1, 1, 1, -1, -1, -1])
    return dataclasses.replace(robot, drive=Drive(lead=lead, rotor_inertia=inertia))


def with_random_drives(rng: np.random.Generator, robot: Robot, rotors: bool = True) -> Robot:
    """The machine with drives that have friction of every kind, half of them without Stribeck's, smoothing
    or a torque constant; rotors: with rotors as well."""
    mass = np.sum(robot.m_d + robot.m_u) + robot.M
    rotor = with_random_rotors(rng, robot).drive
    assert rotor is not None
    force, speed = 10.0 * mass, np.sqrt(10.0 * machine_size(robot))
    half = rng.permutation([0.0, 0.0, 0.0, 1.0, 1.0, 1.0])

    def some(scale: float, share: Array | float = 1.0) -> Array:
        return np.asarray(scale * share * rng.uniform(0.5, 1.5, 6))

    turns = np.abs(rotor.transmission_ratio)
    drive = dataclasses.replace(
        rotor,
        rotor_inertia=rotor.rotor_inertia * rotors,
        efficiency=rng.uniform(0.3, 0.95, 6),
        backdrive_efficiency=rng.uniform(-0.5, 0.9, 6),
        screw_coulomb=some(0.05 * force),
        screw_viscous=some(0.05 * force / speed),
        motor_coulomb=some(0.05 * force) / turns,
        motor_viscous=some(0.05 * force / speed) / turns**2,
        stribeck_force=some(0.05 * force, half),
        stribeck_speed=some(0.1 * speed),
        regularization_speed=some(0.01 * speed, rng.permutation(half)),
        torque_constant=some(0.1, rng.permutation(half)),
    )
    return dataclasses.replace(robot, drive=drive)


def random_robot_of(rng: np.random.Generator, form: Formulation, friction: bool = True) -> Robot:
    """A machine with all that a formulation of the derivation has."""
    robot = random_robot(rng, form.base_joint, friction=friction)
    return with_random_rotors(rng, robot) if form.drive else robot


def dasgupta(friction: bool = True) -> Robot:
    """The paper's machine."""
    robot = robots.dasgupta1998()
    none = np.zeros(6)
    return robot if friction else dataclasses.replace(robot, C_u=none, C_p=none, C_s=none)


def random_motion(
    rng: np.random.Generator, robot: Robot, shape: tuple[int, ...] = (), load: bool = True
) -> Motion:
    """Random poses around the home position with rates, accelerations and, with `load`, a wrench."""
    count = int(np.prod(shape))
    size = machine_size(robot)
    R, t = np.empty((count, 3, 3)), np.empty((count, 3))
    for i in range(count):
        R[i], t[i] = _good_pose(rng, robot)
    rate = np.sqrt(GRAVITY / size)

    def vectors(scale: float) -> Array:
        return scale * rng.normal(size=(*shape, 3))

    return Motion(
        R=R.reshape(*shape, 3, 3),
        t=t.reshape(*shape, 3),
        omega=vectors(0.5 * rate),
        v=vectors(0.5 * rate * size),
        alpha=vectors(0.5 * rate**2),
        a=vectors(0.5 * rate**2 * size),
        F_ext=vectors(robot.M * GRAVITY) if load else None,
        M_ext=vectors(robot.M * GRAVITY * size) if load else None,
    )


def machine_in_motion(
    seed: int | list[int] | np.random.Generator,
    shape: tuple[int, ...] = (),
    base_joint: str = "universal",
    friction: bool = True,
    scale: float | None = None,
    load: bool = True,
) -> tuple[Robot, Motion]:
    """A random machine and a motion of it."""
    rng = np.random.default_rng(seed)
    robot = random_robot(rng, base_joint, friction, scale)
    return robot, random_motion(rng, robot, shape, load)


def random_path(rng: np.random.Generator, robot: Robot, load: bool = True) -> Callable[[Array], Motion]:
    """A smooth path around the home position, of period `path_period`: time (n,), s -> Motion."""
    size, period = machine_size(robot), path_period(robot)
    harmonics = 2 * np.pi * np.array([1.0, 2.0]) / period
    phase = rng.uniform(0, 2 * np.pi, (2, 6))
    width = rng.uniform(0.3, 1.0, (2, 6)) * np.array([[1.0], [0.4]]) * 0.08
    wrench = rng.normal(size=(2, 3)) * robot.M * GRAVITY
    home = home_position(robot.b, size)

    def path(time: Array) -> Motion:
        angle = harmonics[:, None] * time[:, None, None] + phase
        position = np.sum(width * np.sin(angle), axis=1)
        rate = np.sum(width * harmonics[:, None] * np.cos(angle), axis=1)
        acceleration = -np.sum(width * harmonics[:, None] ** 2 * np.sin(angle), axis=1)
        swing = 1 + 0.5 * np.sin(harmonics[0] * time)[:, None]
        return Motion.from_rpy(
            home + size * position[:, :3],
            2 * position[:, 3:],
            size * rate[:, :3],
            2 * rate[:, 3:],
            size * acceleration[:, :3],
            2 * acceleration[:, 3:],
            F_ext=swing * wrench[0] if load else None,
            M_ext=swing * wrench[1] * size if load else None,
        )

    return path


def path_period(robot: Robot) -> float:
    """A period in which the motions of `random_path` have accelerations of the order of gravity."""
    return float(4 * np.sqrt(machine_size(robot) / GRAVITY))


def machine_size(robot: Robot) -> float:
    """Radius of the base points, m."""
    return float(np.sqrt(np.mean(np.sum((robot.b - robot.b.mean(axis=0)) ** 2, axis=-1))))


def home_position(b: Array, size: float) -> Array:
    """Where random poses are drawn around: above the middle of the base points."""
    return np.asarray(b.mean(axis=0) + np.array([0.0, 0.0, 1.1 * size]))


def rotation(vector: Array) -> Array:
    """Rotation matrix (3, 3) of a rotation vector (3,), rad."""
    angle = float(np.linalg.norm(vector))
    x, y, z = vector / angle
    N = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.asarray(np.eye(3) + np.sin(angle) * N + (1 - np.cos(angle)) * N @ N)


def _good_pose(rng: np.random.Generator, robot: Robot) -> tuple[Array, Array]:
    size = machine_size(robot)
    home = home_position(robot.b, size)
    for _ in range(1000):
        R = rotation(0.2 * rng.normal(size=3))
        t = home + 0.15 * size * rng.normal(size=3)
        q = robot.p @ R.T
        S = t + q - robot.b
        s = S / np.linalg.norm(S, axis=-1, keepdims=True)
        H = np.vstack([s.T, cross(q, s).T / size])
        clear = robot.base_joint == "spherical" or np.all(
            np.linalg.norm(cross(robot.k, s), axis=-1) > MIN_JOINT_SINE
        )
        values = np.linalg.svd(H, compute_uv=False)
        if clear and values[0] < MAX_CONDITION * values[-1]:
            return R, t
    raise RuntimeError("no well-posed pose found in 1000 draws")


def _hexagon(rng: np.random.Generator, radius: float, degrees: list[float]) -> Array:
    """Six points near a circle, each moved by a tenth of the radius or so."""
    angle = np.radians(degrees)
    ring = np.column_stack([np.cos(angle), np.sin(angle), np.zeros(6)])
    return radius * (ring + 0.08 * rng.normal(size=(6, 3)))


def _axis_across(rng: np.random.Generator, direction: Array) -> Array:
    """A random unit vector at 45 degrees or more from a direction."""
    while True:
        k = _unit(rng.normal(size=3))
        if np.linalg.norm(cross(k, _unit(direction))) > np.sqrt(0.5):
            return k


def _inertia_per_mass(rng: np.random.Generator, size: float, axial: bool = False) -> Array:
    """Inertia of a cloud of four mass points over its mass, m^2: possible for a body by construction."""
    points = 0.15 * size * rng.normal(size=(4, 3))
    if axial:
        along, across = np.mean(points[:, 0] ** 2), np.mean(points[:, 1:] ** 2)
        return np.diag([2 * across, along + across, along + across])
    second = np.einsum("ni,nj->ij", points, points) / 4
    return np.asarray(np.trace(second) * np.eye(3) - second)


def _log_uniform(rng: np.random.Generator, low: float, high: float) -> float:
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def _unit(vector: Array) -> Array:
    return np.asarray(vector / np.linalg.norm(vector))


def upside_down_in_millimeters() -> Robot:
    """A machine in millimeters, gravity along +z."""
    robot = random_robot(np.random.default_rng(31))
    lengths = {name: 1e3 * getattr(robot, name) for name in ("b", "p", "R_0", "r_d0", "r_u0", "g")}
    inertias = {name: 1e6 * getattr(robot, name) for name in ("I_p", "I_d0", "I_u0", "C_u", "C_s")}
    turned = {"g": 1e3 * np.array([0.0, 0.0, 9.81])}
    return dataclasses.replace(robot, **{**lengths, **inertias, **turned})


MACHINES: dict[str, Callable[[], Robot]] = {
    "paper": dasgupta,
    "random": lambda: random_robot(np.random.default_rng(30)),
    "upside down, mm": upside_down_in_millimeters,
}


PLATFORM_JOINTS = ("spherical", "universal")


def offsets_of(
    rng: np.random.Generator, robot: Robot, joint: str = "spherical", share: float = 0.05
) -> JointOffsets:
    """Every offset and a cross; share: of the machine's size."""
    size = machine_size(robot)
    parts = {
        name: share * size * rng.normal(size=6)
        for name in ("axis_offset", "slide_offset_y", "slide_offset_z")
    }
    if joint == "universal":
        parts["platform_axis"] = robot.k + 0.3 * rng.normal(size=(6, 3))
        parts["wrist_offset"] = share * size * rng.normal(size=6)
    return JointOffsets(
        platform_joint=joint,
        cross_mass=0.3 * robot.m_d,
        cross_center=share * size * rng.normal(size=(6, 3)),
        cross_inertia=0.003 * robot.m_d * size**2,
        **parts,
    )


def offset_case(
    seed: int, joint: str = "spherical", shape: tuple[int, ...] = (), screws: bool = False
) -> tuple[Robot, Motion]:
    """A machine and motions of it; screws: with geared drives, three of whose screws are left-handed."""
    rng = np.random.default_rng(seed)
    plain = random_robot(rng)
    motion = random_motion(rng, plain, shape)
    drive = None
    if screws:
        size = machine_size(plain)
        lead = size * rng.uniform(0.02, 0.1, 6) * np.tile([1.0, -1.0], 3)
        gear = rng.uniform(0.5, 3.0, 6)
        drive = Drive(lead=lead, rotor_inertia=1e-5 * plain.M * size**2, gear_ratio=gear)
    return dataclasses.replace(plain, offsets=offsets_of(rng, plain, joint), drive=drive), motion
