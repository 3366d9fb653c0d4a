"""Conversion from leg-frame components to base-frame vectors for axisymmetric legs.

A leg with spherical joints at both ends has no unique leg frame: any axes y, z perpendicular to the leg are
valid. So its solved components can depend on a transverse vector v only as c v or c (s x v), and on pairs of
such vectors only through |v|. This module checks this property of SymPy's result, extracts each c, and
returns base-frame vectors.
"""

from dataclasses import dataclass

import sympy as sp

from ...program.block import Builder

_TURN = sp.Matrix([[0, -1], [1, 0]])


@dataclass(frozen=True)
class Transverse:
    """Transverse components y, z of a vector in the leg frame, and its transverse part in the base frame."""

    name: str
    y: sp.Symbol
    z: sp.Symbol
    base: sp.Matrix


def scalar_form(expr: sp.Expr, vector: Transverse, square: sp.Expr) -> sp.Expr:
    """Replace v_y^2 + v_z^2 by ``square``.

    Raises
    ------
    ValueError
        If ``expr`` depends on v in another way.
    """
    rewritten = sp.expand(sp.expand(expr).subs(vector.y**2, square - vector.z**2))
    if rewritten.has(vector.y, vector.z):
        raise ValueError(f"not a function of |{vector.name}| alone: {expr}")
    return rewritten


def vector_form(
    build: Builder, name: str, transverse: sp.Matrix, vectors: tuple[Transverse, ...], s: sp.Matrix
) -> sp.Matrix:
    """Return the base-frame vector with the leg-frame components (y, z) in the 2x1 ``transverse``.

    Each coefficient is named ``<name>_<vector>``.

    Raises
    ------
    ValueError
        If a component is not isotropic.
    """
    total = sp.zeros(3, 1)
    rest = transverse.applyfunc(sp.expand)
    for vector in vectors:
        part = rest.jacobian([vector.y, vector.z]).applyfunc(sp.expand)
        along, across = part[0, 0], part[1, 0]
        if (part - along * sp.eye(2) - across * _TURN).applyfunc(sp.expand) != sp.zeros(2):
            raise ValueError(f"{name} is not isotropic in {vector.name}: {part}")
        if along != 0:
            total += build.scalar(f"{name}_{vector.name}", sp.factor(along)) * vector.base
        if across != 0:
            total += build.scalar(f"{name}_s_{vector.name}", sp.factor(across)) * s.cross(vector.base)
        rest = (rest - part * sp.Matrix([vector.y, vector.z])).applyfunc(sp.expand)
    if rest != sp.zeros(2, 1):
        raise ValueError(f"{name} has a transverse part that belongs to no vector: {rest}")
    return total
