"""Random Stewart platforms as trees of bodies with cuts, in MJCF and URDF, with joints as in public files.

A machine consists of six chains of bodies from the base to the platform. Each chain is cut where two bodies
are fixed together or meet in a ball, so that a tree remains. The platform is free or hangs on one leg, and
legs may hang on the platform.
"""

import json
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stewart_sym.motion.rotation import quaternion_from_rotation, rotation_from_vector, rpy_from_rotation

Array = NDArray[np.float64]
BASE, TOP = "base", "top"
Z = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True, eq=False)
class Part:
    """A body: its frame, and mass, center of mass, and inertia about it, all in the world frame."""

    name: str
    R: Array
    t: Array
    mass: float = 0.0
    center: Array = field(default_factory=lambda: np.zeros(3))
    inertia: Array = field(default_factory=lambda: np.zeros((3, 3)))


class Edge(NamedTuple):
    """Joint of two bodies, the first one nearer the base: ``hinge``, ``slide``, ``ball``, or ``fixed``."""

    kind: str
    one: str
    other: str
    point: Array
    axis: Array
    name: str


@dataclass(frozen=True, eq=False)
class Family:
    """One machine.

    edges: edges of the tree, from the parent to the child. cuts: edges that close loops. off: whether centers
    of mass may be off the axes. fault: whether import rejects the machine. s: directions of the legs, (6, 3).
    """

    parts: dict[str, Part]
    edges: tuple[Edge, ...]
    cuts: tuple[Edge, ...]
    gravity: Array
    free: bool
    align: bool
    off: bool
    fault: bool
    s: Array


def across(rng: np.random.Generator, axis: Array, least: float = 0.3) -> Array:
    """Return a random direction at an angle to another."""
    while True:
        found = rng.normal(size=3)
        found /= np.linalg.norm(found)
        if np.linalg.norm(np.cross(found, axis)) > least:
            return found


def turn(rng: np.random.Generator, angle: float = 3.0) -> Array:
    return rotation_from_vector(angle * rng.uniform(-1, 1, 3) / np.sqrt(3.0))


def tensor(rng: np.random.Generator, size: float, mass: float, along: Array | None = None) -> Array:
    """Return a possible inertia, of a body of revolution if a direction is given."""
    squares = mass * size**2 * rng.uniform(0.05, 1.0, 3)
    if along is not None:
        return (squares[0] + squares[1]) * np.eye(3) + (squares[0] - squares[1]) * np.outer(along, along)
    R = turn(rng)
    return R @ np.diag(squares.sum() - squares) @ R.T


class _Maker:
    """Collects the chains of one machine."""

    def __init__(self, rng: np.random.Generator, urdf: bool) -> None:
        self.rng, self.urdf = rng, urdf
        self.parts: dict[str, Part] = {}
        self.chains: list[list[Edge]] = []
        self.spherical = rng.random() < 0.3
        self.off = not self.spherical and rng.random() < 0.25
        self.moved = 0.03 if rng.random() < 0.7 else 0.0
        self.fault = rng.choice(["", "", "", "", "", "", "", "", "", "missed", "universal tip"])
        self.level, self.missed = rng.random() < 0.5, False

    def part(self, name: str, point: Array, mass: float, center: Array, inertia: Array) -> None:
        rng = self.rng
        R = np.eye(3) if self.level and name == TOP else turn(rng)
        self.parts[name] = Part(name, R, point + rng.uniform(-0.05, 0.05, 3), mass, center, inertia)

    def small(self, name: str, point: Array, kept: list[Array]) -> None:
        """Add a cross or fork without a mass, or with its mass where the axes meet or apart from it."""
        rng = self.rng
        if rng.random() < 0.4:
            self.part(name, point, 0.0, point, np.zeros((3, 3)))
            return
        mass, center = rng.uniform(0.005, 0.3), point
        if kept and rng.random() < 0.5:
            center = point + sum(rng.uniform(-0.01, 0.01) * axis for axis in kept)
        if self.off and rng.random() < 0.5:
            mass, center = rng.uniform(0.005, 0.03), point + rng.uniform(-0.002, 0.002, 3)
        self.part(name, point, mass, center, tensor(rng, 0.01, mass))

    def hinge(self, one: str, other: str, point: Array, axis: Array, name: str) -> Edge:
        """Make a hinge with its anchor somewhere on its axis, or off it if axes are to miss each other."""
        rng = self.rng
        at = point + self.moved * rng.uniform(-1, 1) * axis
        if self.fault == "missed" and name == "tip3_2":
            at, self.missed = at + 0.02 * np.cross(axis, across(rng, axis)), True
        return Edge("hinge", one, other, at, axis, name)

    def leg(self, i: int, b: Array, T: Array, foot: str) -> None:
        rng, s = self.rng, (T - b) / np.linalg.norm(T - b)
        first = across(rng, s)
        y = np.cross(first, s)
        y /= np.linalg.norm(y)
        lower, upper = f"lower{i}", f"upper{i}"
        edges, at = [], foot
        ball = self.spherical and not self.urdf and rng.random() < 0.5
        if ball:
            edges.append(Edge("ball", at, lower, b, Z, f"base{i}"))
        else:
            axes = self.three(s) if self.spherical else [first, y]
            for number, axis in enumerate(axes, 1):
                last = number == len(axes)
                name = lower if last else f"cross{i}_{number}"
                if not last:
                    self.small(name, b, [] if self.spherical else axes)
                edges.append(self.hinge(at, name, b, axis, f"base{i}_{number}"))
                at = name
        self.long(lower, b, s)
        self.long(upper, T, s)
        edges.append(Edge("slide", lower, upper, T, s * rng.choice([-1.0, 1.0]), f"slide{i}"))
        edges += self.tip(i, T, s, upper)
        self.chains.append(edges)

    def three(self, s: Array) -> list[Array]:
        """Return three axes at angles to each other."""
        rng = self.rng
        R = turn(rng)
        if rng.random() < 0.5:
            x = across(rng, s)
            x = np.cross(x, s) / np.linalg.norm(np.cross(x, s))
            R = np.stack([s, x, np.cross(s, x)])
        R = R[rng.permutation(3)]
        return [
            rotation_from_vector(rng.uniform(-0.15, 0.15, 3) * self.rng.choice([0, 1])) @ axis for axis in R
        ]

    def long(self, name: str, point: Array, s: Array) -> None:
        """Add a part of a leg, a body of revolution if the leg can spin."""
        rng = self.rng
        mass, center = rng.uniform(0.3, 4.0), point + rng.uniform(-0.2, 0.2) * s
        if not self.spherical:
            center = center + rng.uniform(-0.03, 0.03, 3)
        self.part(name, point, mass, center, tensor(rng, 0.1, mass, s if self.spherical else None))

    def tip(self, i: int, T: Array, s: Array, upper: str) -> list[Edge]:
        rng = self.rng
        if self.fault == "universal tip":
            x = across(rng, s)
            axes = [x, np.cross(x, across(rng, x))]
        elif rng.random() < 0.35:
            return [Edge("ball", upper, TOP, T, Z, f"tip{i}")]
        else:
            axes = self.three(s)
        found, at = [], upper
        for number, axis in enumerate(axes, 1):
            last = number == len(axes)
            name = f"fork{i}" if last else f"end{i}_{number}"
            kept = [axes[0]] if number == 1 else [axes[-1]]
            self.small(name, T, [] if last or (self.spherical and number == 1) else kept)
            found.append(self.hinge(at, name, T, axis, f"tip{i}_{number}"))
            at = name
        return [*found, Edge("fixed", at, TOP, T, Z, f"weld{i}")]


def family(seed: int, urdf: bool = False) -> Family:
    """Make the machine of a seed; for URDF every joint has one axis, at the origin of a link."""
    rng = np.random.default_rng([seed, urdf])
    make = _Maker(rng, urdf)
    turns = np.radians([-10.0, 10.0, 110.0, 130.0, 230.0, 250.0]) + rng.uniform(-0.1, 0.1, 6)
    upper = np.radians([-50.0, 50.0, 70.0, 170.0, 190.0, -70.0]) + rng.uniform(-0.1, 0.1, 6)
    b = np.stack([0.5 * np.cos(turns), 0.5 * np.sin(turns), rng.uniform(-0.05, 0.05, 6)], axis=-1)
    p = np.stack([0.3 * np.cos(upper), 0.3 * np.sin(upper), rng.uniform(-0.05, 0.05, 6)], axis=-1)
    lean, middle = turn(rng, 0.2), np.array([*rng.uniform(-0.1, 0.1, 2), rng.uniform(0.5, 0.9)])
    T = middle + p @ lean.T
    mass = rng.uniform(5.0, 40.0)
    make.part(TOP, middle, mass, middle + rng.uniform(-0.05, 0.05, 3), tensor(rng, 0.2, mass))
    make.parts[BASE] = Part(
        BASE, turn(rng), rng.uniform(-0.1, 0.1, 3), 3.0, np.zeros(3), tensor(rng, 0.2, 3.0)
    )
    order = rng.permutation(6)
    for i in order:
        foot = BASE
        if not urdf and rng.random() < 0.3:
            # A foot that is fixed to the base is where a leg that hangs on the platform is cut.
            foot = f"foot{i + 1}"
            make.part(foot, b[i], 0.2, b[i], tensor(rng, 0.02, 0.2))
        make.leg(i + 1, b[i], T[i], foot)
        if foot != BASE:
            make.chains[-1].insert(0, Edge("fixed", BASE, foot, b[i], Z, f"foot{i + 1}_weld"))
    return _cut(rng, make, (T - b) / np.linalg.norm(T - b, axis=-1)[:, None], urdf)


def _cut(rng: np.random.Generator, make: _Maker, s: Array, urdf: bool) -> Family:
    """Cut each chain once, but for one on which the platform may hang."""
    edges, cuts, carried = [], [], None
    if not urdf or all(edge.kind != "ball" for edge in make.chains[0]):
        carried = 0 if rng.random() < 0.4 else None
    for number, chain in enumerate(make.chains):
        at = [
            i
            for i, edge in enumerate(chain)
            if edge.kind == "fixed" or (edge.kind == "ball" and edge.other == TOP)
        ]
        cut = len(chain) if number == carried else int(rng.choice(at))
        edges += chain[:cut]
        cuts += chain[cut : cut + 1]
        edges += [edge._replace(one=edge.other, other=edge.one) for edge in chain[cut + 1 :][::-1]]
    load = rng.random() < 0.4
    if load:
        where, mass = make.parts[TOP].t, rng.choice([0.5, 60.0])
        make.part("load", where, mass, where + rng.uniform(-0.1, 0.1, 3), tensor(rng, 0.1, mass))
        edges.append(Edge("fixed", TOP, "load", where, Z, "load_weld"))
    free = carried is None
    held = {edge.one for edge in edges}
    gravity = np.array([0.0, 0.0, -9.81]) if rng.random() < 0.7 else 9.81 * across(rng, np.array([1.0, 0, 0]))
    # MuJoCo wants a mass at the ends of the tree.
    light = [part for part in make.parts.values() if not part.mass and part.name not in held]
    for part in light:
        inertia = 1e-6 * np.eye(3)
        point = next(edge.point for edge in edges if edge.other == part.name)
        point = next((edge.point for edge in cuts if part.name in (edge.one, edge.other)), point)
        make.parts[part.name] = replace(part, mass=1e-3, center=point, inertia=inertia)
    if urdf:
        for edge in edges:
            if edge.kind == "hinge":
                make.parts[edge.other] = replace(make.parts[edge.other], t=edge.point)
    align = free and TOP not in held and rng.random() < 0.5
    return Family(
        make.parts,
        tuple(edges),
        tuple(cuts),
        gravity,
        free,
        align,
        make.off,
        make.fault == "universal tip" or make.missed,
        s,
    )


def grows(made: Family, i: int) -> float:
    """Return 1 if the coordinate of the slide of leg i, from 0, grows with the leg, else -1."""
    edge = next(edge for edge in made.edges if edge.name == f"slide{i + 1}")
    outward = 1.0 if edge.one.startswith("lower") else -1.0
    return float(np.sign(edge.axis @ made.s[i])) * outward


def _text(values: Array) -> str:
    return " ".join(repr(float(value)) for value in np.ravel(values))


def mjcf(made: Family, seed: int) -> str:
    """Write MJCF with siblings in random order; a body without a mass becomes a joint of the next body."""
    rng = np.random.default_rng([seed, 2])
    sites: dict[str, list[str]] = {name: [] for name in made.parts}
    equality = []
    for edge in made.cuts:
        tag = "connect" if edge.kind == "ball" else "weld"
        if made.align or rng.random() < 0.6:
            for end, mark in ((edge.one, "a"), (edge.other, "b")):
                part = made.parts[end]
                turned = quaternion_from_rotation(part.R.T)
                place = part.R.T @ (edge.point - part.t)
                sites[end].append(
                    f'<site name="{edge.name}{mark}" pos="{_text(place)}" quat="{_text(turned)}"/>'
                )
            equality.append(f'<{tag} name="{edge.name}" site1="{edge.name}a" site2="{edge.name}b"/>')
        else:
            ends = [edge.one, edge.other] if rng.random() < 0.5 else [edge.other, edge.one]
            part = made.parts[ends[0] if tag == "connect" else ends[1]]
            anchor = _text(part.R.T @ (edge.point - part.t))
            equality.append(
                f'<{tag} name="{edge.name}" body1="{ends[0]}" body2="{ends[1]}" anchor="{anchor}"/>'
            )

    def inside(name: str, frame: tuple[Array, Array]) -> str:
        """Write the bodies that one carries, in a frame."""
        carried = [edge for edge in made.edges if edge.one == name]
        found = []
        for number in rng.permutation(len(carried)):
            edge = carried[number]
            found.append(body(edge.other, frame, [edge]))
        return "".join(found)

    def body(name: str, frame: tuple[Array, Array], edges: list[Edge]) -> str:
        part = made.parts[name]
        if not part.mass:
            (after,) = [edge for edge in made.edges if edge.one == name]
            return body(after.other, frame, [*edges, after])
        place, rotation = frame[0].T @ (part.t - frame[1]), frame[0].T @ part.R
        joints = []
        for edge in edges:
            if edge.kind != "fixed":
                at, axis = part.R.T @ (edge.point - part.t), part.R.T @ edge.axis
                joints.append(
                    f'<joint name="{edge.name}" type="{edge.kind}" pos="{_text(at)}" axis="{_text(axis)}"/>'
                )
        if name == TOP and made.free:
            joints = [f'<freejoint name="free" align="{"true" if made.align else "false"}"/>']
        moments, axes = np.linalg.eigh(part.inertia)
        if np.linalg.det(axes) < 0.0:
            axes[:, 0] *= -1.0
        turned = quaternion_from_rotation(part.R.T @ axes)
        own = (
            f'<inertial mass="{float(part.mass)!r}" pos="{_text(part.R.T @ (part.center - part.t))}" '
            f'quat="{_text(turned)}" diaginertia="{_text(moments)}"/>'
        )
        where = f'pos="{_text(place)}" quat="{_text(quaternion_from_rotation(rotation))}"'
        content = "".join(joints) + own + "".join(sites[name]) + inside(name, (part.R, part.t))
        return f'<body name="{name}" {where}>{content}</body>\n'

    world = np.eye(3), np.zeros(3)
    roots = [body(BASE, world, [])] + ([body(TOP, world, [])] if made.free else [])
    roots = [roots[i] for i in rng.permutation(len(roots))]
    return (
        f'<mujoco model="family"><option gravity="{_text(made.gravity)}" jacobian="dense"/>'
        f"<worldbody>{''.join(roots)}</worldbody><equality>{''.join(equality)}</equality></mujoco>"
    )


def urdf(made: Family, seed: int, drake: bool) -> tuple[str, str | None]:
    """Write URDF with links and joints in random order, and its loops, or ball constraints of Drake."""
    rng = np.random.default_rng([seed, 3])
    items = []
    for part in made.parts.values():
        inertial = ""
        if part.mass:
            place, moments = part.R.T @ (part.center - part.t), part.R.T @ part.inertia @ part.R
            six = zip(("xx", "xy", "xz", "yy", "yz", "zz"), moments[np.triu_indices(3)], strict=True)
            six_ = " ".join(f'i{key}="{float(value)!r}"' for key, value in six)
            inertial = (
                f'<inertial><origin xyz="{_text(place)}"/><mass value="{float(part.mass)!r}"/>'
                f"<inertia {six_}/></inertial>"
            )
        items.append(f'<link name="{part.name}">{inertial}</link>')
    items.append('<link name="world"/>')
    fixed = Edge("fixed", "world", BASE, np.zeros(3), Z, "fixed_base")
    free = [Edge("free", "world", TOP, np.zeros(3), Z, "free")] if made.free else []
    world = Part("world", np.eye(3), np.zeros(3))
    kinds = {"hinge": "continuous", "slide": "prismatic", "fixed": "fixed", "free": "floating"}
    for edge in (fixed, *free, *made.edges):
        one, other = made.parts.get(edge.one, world), made.parts[edge.other]
        place, angles = one.R.T @ (other.t - one.t), rpy_from_rotation(one.R.T @ other.R)
        axis = f'<axis xyz="{_text(other.R.T @ edge.axis)}"/>' if edge.kind in ("hinge", "slide") else ""
        limit = '<limit lower="-1" upper="1" effort="1e16" velocity="1e16"/>' if edge.kind == "slide" else ""
        items.append(
            f'<joint name="{edge.name}" type="{kinds[edge.kind]}"><parent link="{edge.one}"/>'
            f'<child link="{edge.other}"/><origin xyz="{_text(place)}" rpy="{_text(angles)}"/>{axis}{limit}'
            "</joint>"
        )
    closures = []
    for edge in made.cuts:
        ends = [made.parts[end] for end in (edge.one, edge.other)]
        points = [part.R.T @ (edge.point - part.t) for part in ends]
        closures.append((edge, ends, points))
    items = [items[i] for i in rng.permutation(len(items))]
    if drake:
        keys = "drake:ball_constraint"
        items += [
            f'<{keys}><{keys}_body_A name="{ends[0].name}"/><{keys}_p_AP value="{_text(points[0])}"/>'
            f'<{keys}_body_B name="{ends[1].name}"/><{keys}_p_BQ value="{_text(points[1])}"/></{keys}>'
            for _, ends, points in closures
        ]
    text = f'<robot name="family" xmlns:drake="http://drake.mit.edu">{"".join(items)}</robot>'
    loops = {
        "gravity_m_s2": made.gravity.tolist(),
        "closures": [
            {
                "name": edge.name,
                "type": "spherical" if edge.kind == "ball" else "fixed",
                **{f"link_{n}": end.name for n, end in enumerate(ends, 1)},
                **{f"point_{n}_m": point.tolist() for n, point in enumerate(points, 1)},
            }
            for edge, ends, points in closures
        ],
    }
    return text, None if drake else json.dumps(loops)
