"""Convex polytopes as half-spaces: what six bounded actuator forces bring about, and what of it is in reach.

The forces fill a box; a regular matrix makes of it a parallelepiped with twelve facets. Where some of its
coordinates are to be zero it is cut; where they may be anything it is projected, onto a zonotope whose facets
are spanned by pairs of its six generators.
"""

from __future__ import annotations

import itertools

import numpy as np

from ..io.array_types import Array

_PAIRS = np.array(list(itertools.combinations(range(6), 2))).T
# A facet's normal shorter than this share of its generators' product is one of parallel generators.
_PARALLEL = 1e-12
# Share of the largest offset by which a vertex may miss a plane; vertices within ten times that are one.
_SAME = 1e-9


def cut(A: Array, forces: Array, limits: Array) -> tuple[Array, Array]:
    """Half-spaces n . x <= o of |A x + forces| <= limits: n (..., 12, d) of unit length, o (..., 12).

    A: (..., 6, d). forces: (..., 6). limits: (6,).
    """
    normals = np.concatenate([A, -A], axis=-2)
    offsets = np.concatenate([limits - forces, limits + forces], axis=-1)
    return unit_normals(normals, offsets)


def projected(B: Array, forces: Array, limits: Array) -> tuple[Array, Array]:
    """Half-spaces of {B (f - forces): |f| <= limits}: n (..., 30, 3), o (..., 30).

    B: (..., 3, 6). forces: (..., 6). limits: (6,).
    """
    generators = np.swapaxes(B * limits, -1, -2)
    one, other = generators[..., _PAIRS[0], :], generators[..., _PAIRS[1], :]
    normals = np.cross(one, other)
    largest = np.max(np.linalg.norm(generators, axis=-1), axis=-1)[..., None, None]
    parallel = np.linalg.norm(normals, axis=-1, keepdims=True) <= _PARALLEL * largest**2
    normals = np.where(parallel, 0.0, normals)
    reach = np.abs(normals @ np.swapaxes(generators, -1, -2)).sum(axis=-1)
    centre = -(normals @ (B @ forces[..., None]))[..., 0]
    return unit_normals(
        np.concatenate([normals, -normals], axis=-2),
        np.concatenate([reach + centre, reach - centre], axis=-1),
    )


def unit_normals(normals: Array, offsets: Array) -> tuple[Array, Array]:
    """The same half-spaces by normals of unit length; one without a normal is all of space."""
    size = np.linalg.norm(normals, axis=-1)
    none = size == 0.0
    safe = np.where(none, 1.0, size)
    return normals / safe[..., None], np.where(none, np.inf, offsets / safe)


def farthest(normals: Array, offsets: Array, directions: Array) -> Array:
    """Largest lambda >= 0 of lambda * direction in the polytope, (...); nan where there is none."""
    along = np.einsum("...mk,...k->...m", normals, directions)
    with np.errstate(divide="ignore", invalid="ignore"):
        ends = offsets / along
    most = np.min(np.where(along > 0.0, ends, np.inf), axis=-1)
    least = np.max(np.where(along < 0.0, ends, 0.0), axis=-1)
    missed = np.any((along == 0.0) & (offsets < 0.0), axis=-1) | np.isnan(offsets).any(axis=-1)
    return np.asarray(np.where(missed | (most < least), np.nan, most))


def vertices(normals: Array, offsets: Array) -> Array:
    """Corners, (n, d), of one polytope: where d of its planes meet in a point within the others."""
    d = normals.shape[-1]
    some = np.isfinite(offsets)
    normals, offsets = normals[some], offsets[some]
    sets = np.array(list(itertools.combinations(range(len(offsets)), d)))
    planes = normals[sets]
    regular = np.abs(np.linalg.det(planes)) > _PARALLEL
    met = np.linalg.solve(planes[regular], offsets[sets[regular]][..., None])[..., 0]
    slack = _SAME * np.abs(offsets).max()
    met = met[np.all(met @ normals.T <= offsets + slack, axis=-1)]
    found: list[Array] = []
    for point in met:
        if all(np.abs(point - other).max() > 10.0 * slack for other in found):
            found.append(point)
    return np.array(found).reshape(-1, d)
