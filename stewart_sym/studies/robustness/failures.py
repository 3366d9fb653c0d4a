"""Failures: functions that move cases near a failure, families at fixed distances, and random cases."""

import dataclasses
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ...backend.kernel import robot_numbers
from ...io.array_types import Array, Flags
from ...motion.rotation import cross, rotation_from_rpy, rotation_from_vector, rpy_from_rotation
from ...motion.straight_line import PAPER_PATHS
from ...robots import dasgupta1998
from ...singularities.path_singularities import singularity_crossings
from .machines import GRAVITY, LEGS, random_machine, random_motion, similar_hexagons
from .oracle import Cases, cases_of
from .singular_machines import FAMILIES as SINGULAR_MACHINES
from .singular_machines import singular_machine

POINTS = 49
"""Number of distances of every family except that of extreme sizes."""
FAR = "far reference point"
UNLIKE = ("proportions", FAR)
"""Kinds that are checked with the scaled condition number as the least condition number."""
MACHINE = "singular machine"
"""Kind of machines that are singular at every pose; a kernel that solves with H must return a status."""
SIZES, MASSES = (1e-4, 1e3), (1e-6, 1e6)
"""Extremes of the size (m) and mass (kg) of a random machine."""
RATES = ("omega", "v", "alpha", "a")

Draw = Callable[[np.random.Generator, Cases, Array], Array]
"""Function that changes cases, given distances (n,), and returns the distances from the failure."""


def distances() -> Array:
    """Return logarithmically spaced distances from 1 to 1e-16, shape (POINTS,)."""
    return np.logspace(0.0, -16.0, POINTS)


def singular(rng: np.random.Generator, cases: Cases, way: Array) -> Array:
    """Move poses near singular poses. Distances are fractions of a random way; NaN if there is none."""
    R, t, n = cases.motion["R"], cases.motion["t"], len(way)
    size = np.abs(cases.legs["b"]).max(axis=(1, 2))[:, None]
    start = _side(cases, R, t)
    phi, shift, found = np.zeros((n, 3)), np.zeros((n, 3)), np.zeros(n, dtype=np.bool_)
    for _ in range(200):
        phi[~found] = 0.8 * rng.normal(size=(n, 3))[~found]
        shift[~found] = (0.4 * size * rng.normal(size=(n, 3)))[~found]
        found = _side(cases, rotation_from_vector(phi) @ R, t + shift) != start
        if found.all():
            break
    low, high = np.zeros(n), np.ones(n)
    for _ in range(60):
        middle = 0.5 * (low + high)
        at = rotation_from_vector(middle[:, None] * phi) @ R, t + middle[:, None] * shift
        same = _side(cases, *at) == start
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    place = (low + rng.choice([-1.0, 1.0], n) * way)[:, None]
    cases.motion["R"] = rotation_from_vector(place * phi) @ R
    cases.motion["t"] = t + place * shift
    return np.where(found, way, np.nan)


def _side(cases: Cases, R: Array, t: Array) -> Flags:
    """Return the sign of det H as True or False, (n,)."""
    q, S = _points(cases, R, t)
    size = np.abs(S).max(axis=(1, 2), keepdims=True)
    return np.asarray(np.linalg.det(np.concatenate([S / size, cross(q / size, S / size)], axis=-1)) > 0.0)


def joint(rng: np.random.Generator, cases: Cases, way: Array) -> Array:
    """Rotate the fixed axis of a random leg to an angle from the leg."""
    each, leg = np.arange(len(way)), rng.integers(6, size=len(way))
    s = _unit(_points(cases)[1][each, leg])
    across = _unit(cross(s, rng.normal(size=s.shape)))
    side = rng.choice([-1.0, 1.0], (len(way), 1))
    cases.legs["k"][each, leg] = _unit(side * s + way[:, None] * across)
    return way


def both(rng: np.random.Generator, cases: Cases, way: Array) -> Array:
    """Move poses near singular ones, and an axis near its leg."""
    found = singular(rng, cases, way)
    joint(rng, cases, rng.permutation(way))
    return found


def short(rng: np.random.Generator, cases: Cases, way: Array) -> Array:
    """Move the base point of a random leg near its platform point; distances relative to the largest term."""
    each, leg, t = np.arange(len(way)), rng.integers(6, size=len(way)), cases.motion["t"]
    q = _points(cases)[0][each, leg]
    reach = np.fmax(np.abs(q), np.abs(t)).max(axis=1)
    aside = _unit(rng.normal(size=q.shape))
    cases.legs["b"][each, leg] = q + t - (way * reach)[:, None] * aside
    return way


def heavy(rng: np.random.Generator, cases: Cases, way: Array) -> Array:
    """Multiply masses and inertias of a random leg by up to 1e6, with its fixed axis near the leg."""
    light = 10.0 ** -rng.uniform(0.0, 6.0, len(way))
    each, leg = np.arange(len(way)), rng.integers(6, size=len(way))
    for part in ("m_d", "I_d0", "m_u", "I_u0"):
        cases.legs[part][each, leg] = (cases.legs[part][each, leg].T / light).T
    joint(rng, cases, 10.0 ** -rng.uniform(0.0, 3.0, len(way)))
    return light


def proportions(rng: np.random.Generator, cases: Cases, way: Array) -> Array:
    """Shrink platforms by up to 1e5, half of them with their body, and lengthen legs by up to 1e4."""
    n, which = len(way), rng.integers(3, size=len(way))
    small = np.where(which == 0, 1.0, 10.0 ** -rng.uniform(0.0, 5.0, n))[:, None]
    body = np.where(rng.random((n, 1)) < 0.5, small, 1.0)
    cases.legs["p"] *= small[:, None]
    cases.robot["R_0"] *= body
    cases.robot["I_p"] *= body**2
    cases.motion["M_ext"] *= body
    longer = np.where(rng.random((n, 6)) < 0.5, 10.0 ** rng.uniform(0.0, 4.0, (n, 6)), 1.0)
    longer[which == 1] = 1.0
    cases.legs["b"] -= (longer - 1.0)[..., None] * _points(cases)[1]
    return np.asarray(np.minimum(small[:, 0], 1.0 / longer.max(axis=1)))


def far(rng: np.random.Generator, cases: Cases, way: Array) -> Array:
    """Move the reference point of machines of ``proportions`` by up to 1e4 radii.

    With distances for float it is 100 radii, because rounding of R changes the inertia by the square of them.
    """
    distance = proportions(rng, cases, way)
    p, moving = cases.legs["p"], cases.motion
    times = 10.0 ** rng.uniform(0.0, 4.0 if way.min() < 1e-9 else 2.0, len(way))
    d = _unit(rng.normal(size=(len(way), 3))) * (times * np.sqrt((p * p).sum(axis=(1, 2)) / 6.0))[:, None]
    r, omega = np.einsum("nij,nj->ni", moving["R"], d), moving["omega"]
    cases.robot["R_0"] += d
    p += d[:, None]
    moving["t"] -= r
    moving["v"] -= cross(omega, r)
    moving["a"] -= cross(moving["alpha"], r) + cross(omega, cross(omega, r))
    moving["M_ext"] += cross(d, moving["F_ext"])
    return np.minimum(distance, 1.0 / times)


def turned(rng: np.random.Generator, cases: Cases, way: Array) -> Array:
    """Rotate singular machines by random angles, except one third of them."""
    phi = 0.8 * rng.normal(size=(len(way), 3)) * (rng.random((len(way), 1)) > 1.0 / 3.0)
    cases.motion["R"] = rotation_from_vector(phi)
    return np.zeros(len(way))


def not_finite(rng: np.random.Generator, cases: Cases, way: Array) -> Array:
    """Replace one number of each motion by NaN or infinity."""
    places = np.arange(len(way)), rng.integers(30, size=len(way))
    cases.motions[places] = rng.choice([np.nan, np.inf, -np.inf], len(way))
    return np.zeros(len(way))


def _points(cases: Cases, R: Array | None = None, t: Array | None = None) -> tuple[Array, Array]:
    """Compute q and S of all legs, (n, 6, 3) each, at the poses of the cases or other ones."""
    R, t = (cases.motion["R"], cases.motion["t"]) if R is None or t is None else (R, t)
    q = cases.legs["p"] @ np.swapaxes(R, -1, -2)
    return q, q + t[:, None] - cases.legs["b"]


def _unit(vectors: Array) -> Array:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))


@dataclass(frozen=True)
class Family:
    """Cases that approach a failure, from the function ``make`` of a random generator with a ``seed``.

    ``name`` is the stem of the file names, and ``axis`` the meaning of the distance. ``in_range`` is False if
    the family exceeds the range of double, so that a status is valid for any pose.
    """

    name: str
    title: str
    axis: str
    make: Callable[[np.random.Generator], Cases]
    seed: int
    in_range: bool = True


def _path_III(rng: np.random.Generator) -> Cases:
    """Return poses of the robot of the paper near the crossing, on the tangent of Path III before it."""
    robot, path = dasgupta1998(), PAPER_PATHS["III"].path
    crossing = singularity_crossings(robot, path.sample, path.breakpoints())[0].time
    moving = path.sample(crossing)
    theta = rpy_from_rotation(moving.R)
    # The tangent also extends beyond the ends of the path.
    before, after = (rpy_from_rotation(path.sample(crossing + h).R) for h in (-1e-3, 1e-3))
    theta_dot = (after - before) / 2e-3
    motions = [
        dataclasses.replace(moving, R=rotation_from_rpy(theta - d * theta_dot), t=moving.t - d * moving.v)
        for d in distances()
    ]
    return cases_of([robot] * POINTS, motions, distances())


def _hexagons(rng: np.random.Generator) -> Cases:
    robot = similar_hexagons(rng)
    cases = cases_of([robot] * POINTS, [random_motion(rng, robot)] * POINTS, distances())
    turns = 0.5 * np.pi - distances()
    cases.motion["R"] = rotation_from_vector(turns[:, None] * np.array([0.0, 0.0, 1.0]))
    return cases


def _walk(draw: Draw, legs: str = LEGS[0], rest: bool = False) -> Callable[[np.random.Generator], Cases]:
    """Return a function that moves one machine to all distances from a failure in the same direction."""

    def make(rng: np.random.Generator) -> Cases:
        robot = random_machine(rng, legs=legs)
        cases = cases_of([robot] * POINTS, [random_motion(rng, robot)] * POINTS, distances())
        for rate in RATES:
            cases.motion[rate] *= not rest
        state = rng.bit_generator.state
        for i in range(POINTS):
            rng.bit_generator.state = state
            draw(rng, cases[i : i + 1], distances()[i : i + 1])
        return cases

    return make


def _extreme(rng: np.random.Generator) -> Cases:
    """Generate machines of one shape and many sizes, the larger the lighter, so that inertias are finite."""
    sizes, state, robots, motions = np.logspace(200, -200, 81), rng.bit_generator.state, [], []
    for size in sizes:
        rng.bit_generator.state = state
        robots.append(random_machine(rng, float(size), float(1.0 / size)))
        motions.append(random_motion(rng, robots[-1]))
    return cases_of(robots, motions, sizes)


_CROSSING, _TURNED = "Path III crosses a singular pose", "Similar hexagons turned by 90 degrees"
_ANGLE = "angle between a leg and its fixed axis, rad"
_LENGTH, _OVER = "A leg's length approaches zero", "length over the largest term of its sum"
_AT_REST = "A leg's joint singularity, axisymmetric legs at rest: well conditioned"
_OVERFLOW = "Machines of 1e-200 to 1e200 m: overflow and subnormal numbers"
FAMILIES = (
    Family("singular_path_III", _CROSSING, "time from the crossing, s", _path_III, 6),
    Family("singular_hexagons", _TURNED, "angle from 90 degrees, rad", _hexagons, 6),
    Family("joint_singularity", "A leg's joint singularity, moving machine", _ANGLE, _walk(joint), 2),
    Family("joint_singularity_at_rest", _AT_REST, _ANGLE, _walk(joint, LEGS[1], rest=True), 2),
    Family("zero_length", _LENGTH, _OVER, _walk(short), 3),
    Family("scale_extreme", _OVERFLOW, "radius of the base, m", _extreme, 7, in_range=False),
)
"""Families of cases that approach a failure, in the order of the report."""


KINDS: dict[str, Draw] = {
    "singular": singular,
    "joint singularity": joint,
    "zero-length leg": short,
    "scales": lambda rng, cases, way: way,
    "joint and singular": both,
    "heavy leg": heavy,
    "proportions": proportions,
    FAR: far,
    MACHINE: turned,
    "wrong input": not_finite,
}
"""Functions that change random cases, by kind."""


def random_cases(kind: str, rng: np.random.Generator, count: int, each: int, decades: float) -> Cases:
    """Generate up to ``count`` cases of a kind, ``each`` per machine, with distances over the decades."""
    robots = np.repeat(_random_machines(rng, -(-count // each), kind == MACHINE), each, axis=0)[:count]
    cases = Cases(robots, np.empty((count, 30)), np.empty((count, 6)), np.empty(count))
    _move(rng, cases)
    at_rest = rng.integers(4, size=count) == 0
    for rate in RATES:
        cases.motion[rate][at_rest] = 0.0
    cases.forces[:] = GRAVITY * cases.robot["M"][:, None] * rng.normal(size=(count, 6))
    cases.distance[:] = KINDS[kind](rng, cases, 10.0 ** -rng.uniform(0.0, decades, count))
    return cases[np.isfinite(cases.distance)]


def _random_machines(rng: np.random.Generator, count: int, are_singular: bool) -> Array:
    """Generate numbers of machines, (count, 205), half of them of about one meter, others of any size."""
    machines, families = [], tuple(SINGULAR_MACHINES)
    for number in range(count):
        size, mass = (10.0 ** rng.uniform(*np.log10(extremes)) for extremes in (SIZES, MASSES))
        size, mass = (size, mass) if number % 2 else (1.0, 10.0)
        kind = (size, mass, LEGS[number // 2 % len(LEGS)])
        family = families[number % len(families)]
        robot = singular_machine(rng, family, *kind) if are_singular else random_machine(rng, *kind)
        machines.append(robot_numbers(robot))
    return np.array(machines)


def _move(rng: np.random.Generator, cases: Cases) -> None:
    """Set motions near the home pose, with rates of the time scale of each machine."""
    b = cases.legs["b"]
    home = b.mean(axis=1)
    sizes = np.sqrt(((b - home[:, None]) ** 2).sum(axis=2).mean(axis=1))
    home[:, 2] += 1.1 * sizes
    rate2, weight = GRAVITY / sizes, GRAVITY * cases.robot["M"]
    rate = np.sqrt(rate2)
    spread = (0.15 * sizes, 0.5 * rate, 0.5 * rate * sizes, 0.5 * rate2, 0.5 * rate2 * sizes)
    loads = (weight, weight * sizes)
    for name, scale in zip(("t", *RATES, "F_ext", "M_ext"), (*spread, *loads), strict=True):
        cases.motion[name] = scale[:, None] * rng.normal(size=home.shape)
    cases.motion["t"] += home
    cases.motion["R"] = rotation_from_vector(0.2 * rng.normal(size=home.shape))
