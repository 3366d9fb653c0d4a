"""Sound machines, published ones and absurd ones."""

import functools
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym.motion.rotation import rotation_from_quaternion
from stewart_sym.robot.robot import Robot

Array = NDArray[np.float64]
Change = Callable[[Robot], Robot]

BASE, PLATFORM = (-10, 10, 110, 130, 230, 250), (-48, 48, 72, 168, 192, 288)


def ring(size: float, angles: object, z: float = 0.0) -> Array:
    angle = np.radians(np.asarray(angles, dtype=np.float64))
    return np.column_stack([size * np.cos(angle), size * np.sin(angle), np.full(6, z)])


def across(rng: np.random.Generator, s: Array) -> Array:
    """Unit vectors within some 30 degrees of the plane across s (6, 3)."""
    k = np.cross(s, rng.normal(size=3))
    k = k / np.linalg.norm(k, axis=-1, keepdims=True) + 0.2 * rng.normal(size=k.shape)
    return np.asarray(k / np.linalg.norm(k, axis=-1, keepdims=True))


def rods(masses: Array, length: Array, thickness: Array) -> Array:
    """Inertias of round bars along x, (6, 3, 3)."""
    axial, transverse = masses * thickness**2 / 2, masses * (length**2 / 12 + thickness**2 / 4)
    return np.array([np.diag([a, t, t]) for a, t in zip(axial, transverse, strict=True)])


def machine_of(
    rng: np.random.Generator,
    b: Array,
    p: Array,
    t: Array,
    joint: str = "universal",
    limited: bool = True,
    gravity: object = (0.0, 0.0, -9.81),
) -> Robot:
    """A machine of those points, at home at t: actuators that carry it, rods in tubes."""
    S = t + p - b
    L = np.linalg.norm(S, axis=-1)
    size = float(np.linalg.norm(p - p.mean(axis=0), axis=-1).max())
    M = 4.0 * size**3 * 10 ** rng.uniform(1.5, 3.7)
    masses = M * rng.uniform(0.01, 0.3, (2, 6))
    stroke = L * rng.uniform(0.2, 0.4, 6)
    lower, upper = (L * rng.uniform(0.45, 0.6, 6) for _ in range(2))
    robot = Robot(
        name="sound",
        base_joint=joint,
        g=gravity,
        M=M,
        R_0=p.mean(axis=0) + 0.3 * size * rng.normal(size=3),
        I_p=M * size**2 * np.diag(rng.uniform(0.2, 0.38, 3)),
        b=b,
        p=p,
        k=across(rng, S / L[:, None]) if joint == "universal" else np.zeros((6, 3)),
        m_d=masses[0],
        r_d0=np.column_stack([lower / 2, np.zeros((6, 2))]),
        I_d0=rods(masses[0], lower, L / 20),
        m_u=masses[1],
        r_u0=np.column_stack([-upper / 2, np.zeros((6, 2))]),
        I_u0=rods(masses[1], upper, L / 40),
        C_u=np.zeros(6),
        C_p=M * np.sqrt(9.81 / size) * rng.uniform(0.0, 1.0, 6),
        C_s=np.zeros(6),
    )
    if not limited:
        return robot
    zero = np.zeros(3)
    rest = ss.Motion(R=np.eye(3), t=t, omega=zero, v=zero, alpha=zero, a=zero)
    hold = np.abs(ss.inverse_dynamics(robot, rest, backend="numpy").F).max()
    return replace(
        robot,
        length_limits=np.column_stack([L - stroke, L + stroke]),
        force_limit=rng.uniform(4.0, 20.0, 6) * (hold + 0.1 * M),
        speed_limit=rng.uniform(0.1, 3.0, 6) * np.sqrt(size),
    )


def sound_machine(rng: np.random.Generator) -> Robot:
    """A machine of 1 mm to 10 m whose legs differ; its frames lie anywhere, its base in any plane."""
    size = 10 ** rng.uniform(-3.0, 1.0)
    half = rng.uniform(0.0, 20.0, 2)
    b = ring(size, [c + d * half[0] for c in (0, 120, 240) for d in (-1, 1)])
    p = ring(size * rng.uniform(0.35, 1.2), [c + d * (60 - half[1]) for c in (0, 120, 240) for d in (-1, 1)])
    height = size * rng.uniform(0.6, 1.8)
    t = np.array([0.0, 0.0, height])
    b, p = b + 0.06 * size * rng.normal(size=(6, 3)), p + 0.04 * size * rng.normal(size=(6, 3))
    kind = rng.integers(4)
    if kind == 0:  # the platform's frame is off the platform, on the side away from the base
        shift = np.array([0.0, 0.0, -size * rng.uniform(0.2, 2.0)])
        p, t = p + shift, t - shift
    if kind == 1:  # the legs are numbered in another order
        order = rng.permutation(6)
        b, p = b[order], p[order]
    if kind == 2:  # the machine hangs, or is seen in a mirror
        b, p, t = (x * [1.0, -1.0, rng.choice([-1.0, 1.0])] for x in (b, p, t))
    if kind == 3:  # the base frame is anywhere
        turn = rotation_from_quaternion(rng.normal(size=4)) if rng.random() < 0.5 else np.eye(3)
        b, p, t = b @ turn.T, p @ turn.T, turn @ t
        shift = size * rng.normal(size=3)
        b, t = b + shift, t + shift
    direction = rng.normal(size=3)
    gravity = 9.81 * direction / np.linalg.norm(direction) * rng.choice([0.0, 0.17, 1.0, 1.0, 2.5])
    joint = ("universal", "spherical")[rng.integers(2)]
    return machine_of(rng, b, p, t, joint, bool(rng.random() < 0.6), gravity)


def published() -> dict[str, tuple[Array, Array, Array]]:
    """Base points, platform points and home position of the package's machines and of others."""

    def pairs(radius: float, half: float) -> Array:
        return ring(radius, [c + d * half for c in (0, 120, 240) for d in (-1, 1)])

    up = np.array([0.0, 0.0, 1.0])
    ours = [ss.robots.load(name) for name in ss.robots.NAMES if name != "dasgupta1998"]
    return {robot.name: (robot.b, robot.p, robot.home_position) for robot in ours} | {
        "krex4715": (
            ring(0.12, [20, 100, 140, 220, 260, 340]),
            ring(0.095, [40, 80, 160, 200, 280, 320]),
            0.39 * up,
        ),
        "TU Braunschweig": (pairs(0.25145, 48.53), pairs(0.2169, 12.86), 0.5 * up),
    }


# Absurd machines


def sound() -> Robot:
    rng = np.random.default_rng(7)
    return machine_of(rng, ring(0.5, BASE), ring(0.3, PLATFORM), np.array([0.0, 0.0, 0.7]))


def unlimited() -> Robot:
    none = sound()
    return replace(
        none,
        length_limits=np.tile([0.0, np.inf], (6, 1)),
        force_limit=np.full(6, np.inf),
        speed_limit=np.full(6, np.inf),
    )


def of(**changes: Any) -> Change:
    """A change of a robot: field -> its new value, or what becomes of the old one."""

    def changed(robot: Robot) -> Robot:
        old = {name: getattr(robot, name) for name in changes}
        new = {name: change(old[name]) if callable(change) else change for name, change in changes.items()}
        return replace(robot, **new)

    return changed


def scaled(**factors: float) -> Change:
    """A change of a robot: field -> the factor of its numbers."""
    return of(**{name: lambda value, factor=factor: factor * value for name, factor in factors.items()})


def driven(**numbers: float) -> Change:
    """Drives of these numbers."""
    return of(drive=ss.Drive(**{"lead": 0.005, **numbers}))


def alike(unit: float) -> Change:
    """Limits that are those of all legs, in another unit: a platform far away has its legs within them."""
    return of(length_limits=lambda x: np.tile([unit * x[:, 0].min(), unit * x[:, 1].max()], (6, 1)))


def one_leg(name: str, leg: int, factor: float) -> Change:
    return of(**{name: lambda x: (x.T * np.where(np.arange(6) == leg, factor, 1.0)).T})


def same(*legs: int, of_base: bool = True, of_platform: bool = True) -> Change:
    """Each leg from the points of the leg with that number."""
    points = {"b": of_base, "p": of_platform}
    return of(**{name: lambda x: x[list(legs)] for name, chosen in points.items() if chosen})


MIRROR, SECOND, OPPOSITE = [0, 5, 4, 3, 2, 1], [1, 0, 2, 3, 4, 5], [0, 4, 2, 3, 1, 5]
OTHER_UNIT = "limits in millimeters, centimeters, or inches"
TWICE = "converted from kg mm^2 twice"


def like_base(robot: Robot) -> Robot:
    """Base and platform exchanged, with a body like the base."""
    return replace(robot, b=0.55 * robot.b, p=robot.b, I_p=robot.M * 0.15**2 * np.eye(3))


BY_DOUBT: dict[str, dict[str, tuple[Change, str]]] = {
    # name of the doubt -> what is wrong: change of a sound machine, words of its cause
    "length-unit": {
        "millimeters": (scaled(b=1e3, p=1e3), "points in millimeters"),
        "100 mm in millimeters": (scaled(b=200.0, p=200.0), "points in millimeters"),
    },
    "proportion": {
        "platform in millimeters": (scaled(p=1e3), "platform points in millimeters"),
        "exchanged": (
            lambda robot: replace(robot, b=0.6 * robot.p, p=robot.b),
            "base_point and platform_point exchanged",
        ),
        "all platform points in one place": (same(*[0] * 6, of_base=False), "points in millimeters"),
        "exchanged, body": (like_base, "base_point and platform_point exchanged"),
    },
    "gravity": {"gravity in mm/s^2": (scaled(g=1e3), "given in mm/s^2")},
    "": {
        "mass in grams": (scaled(M=1e3, m_d=1e3, m_u=1e3), "grams"),
        "platform points numbered the other way": (of(p=lambda p: p[MIRROR]), "mirrored"),
        "platform points of a left-handed frame": (of(p=lambda p: p[MIRROR] * [1, -1, 1]), ""),
    },
    "mass": {"platform in grams": (scaled(M=1e3, I_p=1e3), "in grams")},
    "inertia-size": {
        "platform's 1e-6 of what it is": (scaled(I_p=1e-6), TWICE),
        "upper parts' in kg cm^2": (scaled(I_u0=1e4), "kg cm^2"),
        "one lower part's in kg mm^2": (one_leg("I_d0", 4, 1e6), "lower part of leg 5"),
    },
    "center-of-mass": {
        "platform's in mm": (of(R_0=lambda R_0: 1e3 * (R_0 + 0.1)), "platform: center_of_mass"),
        "lower ones in mm": (scaled(r_d0=1e3), "lower part of all legs: center_of_mass"),
        "lower ones in m in a file of mm": (
            of(length_unit="mm", r_d0=lambda r: 1e-3 * r),
            "larger unit, expected mm",
        ),
        "upper ones of the wrong sign": (scaled(r_u0=-1.0), "wrong sign, expected a negative"),
        "lower ones of the wrong sign": (scaled(r_d0=-0.5), "wrong sign, expected a positive"),
    },
    "leg-order": {
        f"platform points shifted by {by}": (
            of(p=functools.partial(np.roll, shift=by, axis=0)),
            f"shifted by {by}",
        )
        for by in (1, 2, 3)
    }
    | {"platform points of opposite legs exchanged": (of(p=lambda p: p[OPPOSITE]), "or exchanged")},
    "crossing": {
        "two platform points exchanged": (of(p=lambda p: p[SECOND]), "legs 1, 2 cross"),
    },
    "length-limits": {
        "limits in millimeters, alike": (alike(1e3), OTHER_UNIT),
        "limits in millimeters": (scaled(length_limits=1e3), OTHER_UNIT),
        "limits in meters in a file of millimeters": (
            scaled(length_limits=1e-3),
            "limits given in m in a file",
        ),
        "the stroke for limits": (of(length_limits=np.tile([0.0, 0.2], (6, 1))), "the stroke given"),
    },
    "home": {
        "home in meters in a file of millimeters": (
            of(length_unit="mm", home_position=np.array([0.0, 0.0, 7e-4])),
            "in a larger unit",
        )
    }
    | {"home of another point": (of(home_position=np.array([0.0, 0.0, 1.7])), "home of another point")},
    "force-limit": {"force limit in kN": (scaled(force_limit=1e-3), "force_limit in kN")},
    "drive-limit": {"motors without their gear": (driven(torque_limit=1e-4), "motors too weak")},
    "drive-inertia": {"rotor in g cm^2": (driven(rotor_inertia=173.0), "or g cm^2")},
    "drive-lead": {
        "lead in meters in a file of millimeters": (driven(lead=5e-6), "expected m"),
        "motors with that lead": (driven(lead=5e-6, speed_limit=300.0, torque_limit=1e-4), "expected m"),
    },
    "tool": {
        "tool in meters in a file of millimeters": (
            of(length_unit="mm", tool=np.array([0.0, 0.0, 1e-4])),
            "expected mm",
        )
    },
    "drive-speed": {
        "revolutions a minute": (driven(speed_limit=5000.0), "5000 rad/s"),
        "radians in a file of degrees": (driven(speed_limit=8e-3), "expected rad/s"),
    },
    "speed-limit": {
        "speed limit in mm/s": (scaled(speed_limit=1e3), "given in mm/s"),
        "speed limit in m/s in a file of millimeters": (scaled(speed_limit=1e-3), "expected m/s"),
    },
    "condition": {
        "platform on one line": (of(p=lambda p: np.outer(p[:, 0], [1, 2, 3])), ""),
        "similar hexagons": (of(p=ring(0.3, BASE)), "similar hexagons"),
        "two legs the same": (same(0, 0, 2, 3, 4, 5), "in one place"),
    },
}
ABSURD: dict[str, tuple[Change, str, str]] = {
    wrong: (change, doubt, words)
    for doubt, cases in BY_DOUBT.items()
    for wrong, (change, words) in cases.items()
}
"""What is wrong: change of a sound machine, name of the doubt or "" for any, words of its cause."""
