"""Bodies by shape have the mass, the centre and the inertia of what they are made of."""

from typing import Any

import numpy as np
import pytest

from stewart_sym.robot.bodies import INERTIA_KEYS, Body, body, joined


def made(value: Any, along: float | None = None) -> Body:
    found = body(value, "part", lambda x: x, along)
    return Body(*(found[key] for key in INERTIA_KEYS))


def points_of(shape: dict[str, Any], axis: np.ndarray) -> np.ndarray:
    """Points evenly spread over a cylinder about an axis through the origin, or over a box."""
    n = 41
    grid = (np.arange(n) + 0.5) / n - 0.5
    x, y, z = (each.ravel() for each in np.meshgrid(grid, grid, grid))
    if shape["shape"] == "box":
        return np.stack([x, y, z], axis=-1) * shape["size"]
    outer, inner = shape["radius"], shape.get("inner_radius", 0.0)
    # Even in the square of the radius, so that each point has the same volume.
    r = np.sqrt(inner**2 + (outer**2 - inner**2) * (x + 0.5))
    turn = 2.0 * np.pi * y
    height = z * shape.get("length", shape.get("thickness"))
    u = np.linalg.svd(axis[None])[2][1:]
    return r[:, None] * (np.cos(turn)[:, None] * u[0] + np.sin(turn)[:, None] * u[1]) + height[:, None] * axis


SHAPES: list[dict[str, Any]] = [
    {"shape": "rod", "radius": 0.1, "length": 0.7},
    {"shape": "tube", "radius": 0.2, "inner_radius": 0.15, "length": 0.3},
    {"shape": "plate", "radius": 0.5, "thickness": 0.02},
    {"shape": "plate", "radius": 0.5, "inner_radius": 0.4, "thickness": 0.1},
    {"shape": "box", "size": [0.2, 0.5, 0.9]},
]


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("axis", [[0.0, 0.0, 1.0], [0.6, 0.0, -0.8]])
def test_inertia_is_that_of_points_spread_over_the_shape(shape: dict[str, Any], axis: list[float]) -> None:
    turned = {} if shape["shape"] == "box" else {"axis": axis}
    found = made({**shape, "mass": 2.0, "center": [0.1, -0.2, 0.3], **turned})
    x = points_of(shape, np.array(axis))
    square = np.einsum("ni,nj->ij", x, x) / len(x)
    expected = 2.0 * (np.trace(square) * np.eye(3) - square)
    np.testing.assert_allclose(found.inertia, expected, atol=2e-3 * np.abs(expected).max())
    np.testing.assert_array_equal(found.center_of_mass, [0.1, -0.2, 0.3])


def test_a_tube_and_what_fills_it_are_a_rod() -> None:
    whole = made({"shape": "rod", "radius": 0.3, "length": 2.0, "density": 7800.0}, 1.0)
    tube = {"shape": "tube", "radius": 0.3, "inner_radius": 0.2, "length": 2.0, "density": 7800.0}
    parts = made([tube, {"shape": "rod", "radius": 0.2, "length": 2.0, "density": 7800.0}], 1.0)
    for one, other in zip(parts, whole, strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-14, atol=1e-15)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_rod_in_two_pieces_is_the_rod(side: float) -> None:
    whole = made({"shape": "rod", "radius": 0.1, "length": 1.0, "mass": 3.0}, side)
    pieces = [{"shape": "rod", "radius": 0.1, "length": 0.4, "mass": 1.2}]
    pieces += [{"shape": "rod", "radius": 0.1, "length": 0.6, "mass": 1.8, "start": 0.4}]
    for one, other in zip(made(pieces, side), whole, strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-14, atol=1e-15)
    assert whole.center_of_mass[0] == 0.5 * side


def test_joined_bodies_move_as_one() -> None:
    """Kinetic energy and momentum of any motion are the sums of the parts'."""
    rng = np.random.default_rng(5)
    parts = []
    for _ in range(4):
        root = rng.normal(size=(3, 3))
        tensor = np.trace(root @ root.T) * np.eye(3) - root @ root.T
        parts.append(Body(rng.uniform(0.5, 2.0), rng.normal(size=3), tensor))
    one = joined(parts)
    for _ in range(5):
        v, omega = rng.normal(size=(2, 3))
        energies = [
            0.5 * each.mass * np.sum((v + np.cross(omega, each.center_of_mass)) ** 2)
            + 0.5 * omega @ each.inertia @ omega
            for each in (*parts, one)
        ]
        assert sum(energies[:-1]) == pytest.approx(energies[-1], rel=1e-13)
    moments = sum(each.mass * each.center_of_mass for each in parts)
    np.testing.assert_allclose(one.mass * one.center_of_mass, moments, rtol=1e-14)


def test_a_list_takes_bodies_by_inertia_beside_shapes() -> None:
    load = {"mass": 1.0, "center_of_mass": [0.0, 0.0, 1.0], "inertia": [0.0, 0.0, 0.0]}
    found = made([{"shape": "plate", "radius": 1.0, "thickness": 0.1, "mass": 1.0}, load])
    assert found.mass == 2.0
    np.testing.assert_array_equal(found.center_of_mass, [0.0, 0.0, 0.5])
    np.testing.assert_allclose(np.diag(found.inertia)[:2], 0.25 + 0.1**2 / 12 + 0.5, rtol=1e-15)
