"""From leg-frame components back to vectors, for legs that look the same all round their axis.

A leg held by spherical joints at both ends has no leg frame: any two axes y, z perpendicular to it serve.
So the solved components of such a leg can depend on transverse vectors v only as c v or as c (s x v), and
on pairs of them only through their length. This file checks that of SymPy's result, reads off each c, and
writes the result in base-frame vectors.
"""

from dataclasses import dataclass

import sympy as sp

from ...program.block import Builder

_TURN = sp.Matrix([[0, -1], [1, 0]])


@dataclass(frozen=True)
class Transverse:
    """A vector's two transverse components in the leg frame, and its transverse part in the base frame."""

    name: str
    y: sp.Symbol
    z: sp.Symbol
    base: sp.Matrix


def scalar_form(expr: sp.Expr, vector: Transverse, square: sp.Expr) -> sp.Expr:
    """Write v_y^2 + v_z^2 as ``square``; ValueError if ``expr`` depends on v in any other way."""
    rewritten = sp.expand(sp.expand(expr).subs(vector.y**2, square - vector.z**2))
    if rewritten.has(vector.y, vector.z):
        raise ValueError(f"not a function of |{vector.name}| alone: {expr}")
    return rewritten


def vector_form(
    build: Builder, name: str, transverse: sp.Matrix, vectors: tuple[Transverse, ...], s: sp.Matrix
) -> sp.Matrix:
    """The base-frame vector whose leg-frame components (y, z) are the 2x1 ``transverse``.

    Names each coefficient ``<name>_<vector>``. ValueError if a component is not isotropic.
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
