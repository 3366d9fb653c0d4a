"""Drawings of one leg: frames and symbols, free bodies of its parts, and dimensions of its parts."""

from typing import TYPE_CHECKING

import numpy as np
from drawing_sheet import (
    AXIS,
    BASE,
    FORCE,
    GRAY,
    INK,
    LOWER,
    MOMENT,
    PLATFORM,
    UPPER,
    Array,
    Sheet,
    across,
    direction,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

ANGLE = 62.0
"""Angle of the drawn leg (degrees)."""


def leg() -> "Figure":
    """Draw a leg with the base frame, the platform frame, frames D and U, and the symbols of (1)-(16)."""
    sheet = Sheet(8.0, 7.8)
    s = direction(ANGLE)
    base = np.array([2.75, 1.75])
    tip = base + 5.1 * s
    origin, reference = np.array([0.75, 1.0]), np.array([2.05, 6.6])
    sheet.area(
        reference + [-1.0, 0.32],
        tip + [0.45, 0.42],
        tip + [0.3, 0.1],
        reference + [-0.85, -0.02],
        color=PLATFORM,
    )
    sheet.ground(base - [0.0, 0.16])
    sheet.body(base, base + 2.9 * s, 0.44, LOWER)
    sheet.body(base + 2.2 * s, tip, 0.2, UPPER)
    for point in (base, tip):
        sheet.joint(point)
    sheet.frame(origin, 0.0, 0.75, ("X", "Z"), BASE)
    sheet.text(origin + [0.0, -0.32], "base frame", BASE)
    sheet.frame(reference, 9.0, 0.75, ("$x_P$", "$z_P$"), PLATFORM)
    sheet.text(reference + [-1.1, -0.38], "reference point of\nthe platform frame", PLATFORM)
    for end, name, place in (
        (base, "b", origin + 0.7 * (base - origin) + [0.0, -0.2]),
        (reference, "t", origin + 0.45 * (reference - origin) + [-0.2, 0.0]),
    ):
        sheet.arrow(origin, end, GRAY, 1.4, linestyle="--")
        sheet.text(place, name, INK)
    sheet.arrow(reference, tip, GRAY, 1.4, linestyle="--")
    sheet.text(0.42 * reference + 0.58 * tip + [0.0, -0.24], r"$q = R\,p$", INK)
    _masses(sheet, base, tip, s)
    sheet.frame(base, ANGLE, 1.15, ("", "z"), AXIS, out=False)
    sheet.text(base + 1.36 * s, "x", AXIS)
    sheet.text(base + [-0.75, 1.0], "frame D", AXIS)
    sheet.frame(tip, ANGLE, 1.15, ("x = s", "z"), AXIS, out=False)
    sheet.text(tip + [-0.35, 1.15], "frame U", AXIS)
    sheet.text(base + [0.62, 0.15], "base point,\nuniversal joint", INK, "left")
    sheet.text(tip + [0.65, 0.02], "platform point,\nspherical joint", INK, "left")
    sheet.dimension(base, tip, "$S = L\\,s$", -2.3 * across(s), INK)
    return sheet.figure


def _masses(sheet: Sheet, base: Array, tip: Array, s: Array) -> None:
    lower, upper = base + 1.85 * s - 0.05 * across(s), tip - 1.5 * s + 0.02 * across(s)
    for at, words, color in (
        (lower, "lower part: $m_d,\\ I_{d0}$\n$r_{d0}$ in frame D", LOWER),
        (upper, "upper part: $m_u,\\ I_{u0}$\n$r_{u0}$ in frame U", LOWER),
    ):
        sheet.mass(at)
        sheet.text(at + [0.26, -0.12], words, color, "left")


def lower_part() -> "Figure":
    """Draw all forces and moments on the lower part, (17) and (25)."""
    sheet = Sheet(7.0, 5.0)
    s = direction(ANGLE)
    base = np.array([2.35, 1.4])
    end = base + 2.9 * s
    mass, slide = base + 1.5 * s, base + 2.35 * s
    sheet.body(base, end, 0.5, LOWER)
    sheet.joint(base)
    sheet.mass(mass)
    sheet.dot(slide, FORCE, 4.0)
    sheet.arrow(base - [0.75, 1.0], base - [0.06, 0.08])
    sheet.text(base - [0.95, 1.15], "$F_u$", FORCE)
    sheet.moment(base, base + 1.25 * direction(ANGLE + 68.0))
    sheet.text(base + 1.52 * direction(ANGLE + 66.0), "$M_u\\,n$", MOMENT)
    sheet.moment(base, base + 1.0 * direction(-12.0))
    sheet.text(base + [1.1, -0.28], "$-C_u W$", MOMENT, "left")
    sheet.arrow(mass, mass - [0.0, 1.15])
    sheet.text(mass + [0.18, -1.05], "$m_d\\,g$", FORCE, "left")
    sheet.arrow(mass, mass + [1.2, -0.1], GRAY, linestyle="--")
    sheet.text(mass + [1.3, -0.1], "inertia: $-m_d\\,a_d$ and\n$-I_d A - W \\times I_d W$", GRAY, "left")
    sheet.arrow(slide, slide + 1.25 * direction(150.0))
    sheet.text(slide + 1.5 * direction(152.0), "$-F_p$", FORCE)
    sheet.moment(slide, slide + 1.2 * direction(20.0))
    sheet.text(slide + 1.5 * direction(20.0), "$-M_p$", MOMENT)
    sheet.arrow(end - 0.1 * s, end + 0.7 * s)
    sheet.text(end + 0.75 * s + [0.2, 0.02], "$C_p\\,\\dot L\\,s$", FORCE, "left")
    return sheet.figure


def upper_part() -> "Figure":
    """Draw all forces and moments on the upper part, (18) and (23)."""
    sheet = Sheet(7.0, 5.0)
    s = direction(ANGLE)
    start = np.array([2.2, 1.0])
    tip = start + 3.3 * s
    mass, slide = start + 1.95 * s, start + 0.65 * s
    sheet.body(start, tip, 0.26, UPPER)
    sheet.joint(tip)
    sheet.mass(mass)
    sheet.dot(slide, FORCE, 4.0)
    sheet.arrow(tip, tip + 1.05 * direction(158.0))
    sheet.text(tip + 1.6 * direction(160.0), "$F_s = x\\,s + K$", FORCE)
    sheet.moment(tip, tip + 1.1 * direction(18.0))
    sheet.text(tip + 1.25 * direction(18.0) + [0.1, 0.0], "$-f$, friction", MOMENT, "left")
    sheet.arrow(mass, mass - [0.0, 1.15])
    sheet.text(mass + [0.15, -1.1], "$m_u\\,g$", FORCE, "left")
    sheet.arrow(mass, mass + [1.2, -0.1], GRAY, linestyle="--")
    sheet.text(mass + [1.3, -0.1], "inertia: $-m_u\\,a_u$ and\n$-I_u A - W \\times I_u W$", GRAY, "left")
    sheet.arrow(slide, slide + 1.2 * direction(125.0))
    sheet.text(slide + 1.45 * direction(128.0), "$F_p$", FORCE)
    sheet.moment(slide, slide + 1.15 * direction(-20.0))
    sheet.text(slide + 1.4 * direction(-20.0) + [0.08, 0.0], "$M_p$", MOMENT)
    sheet.arrow(start + 0.05 * s, start - 0.75 * s)
    sheet.text(start - 0.75 * s + [-0.15, 0.0], "$-C_p\\,\\dot L\\,s$", FORCE, "right")
    return sheet.figure


def parts() -> "Figure":
    """Draw the lower and the upper part with the dimensions that a data sheet gives."""
    sheet = Sheet(8.4, 4.6)
    base, tip = np.array([1.25, 2.45]), np.array([7.05, 2.45])
    x = np.array([1.0, 0.0])
    sheet.body(base, base + 3.5 * x, 0.62, LOWER)
    sheet.body(base + 2.6 * x, tip, 0.3, UPPER)
    lower, upper = base + 1.5 * x, tip - 1.6 * x
    for point in (base, tip):
        sheet.joint(point)
    for point in (lower, upper):
        sheet.mass(point)
    sheet.dimension(base, tip, "length $L$ between the joints", [0.0, 1.6])
    sheet.dimension(base, base + 3.5 * x, "length of the lower part", [0.0, 0.9], LOWER)
    sheet.dimension(base + 2.6 * x, tip, "length of the upper part", [0.0, -1.85], LOWER)
    sheet.dimension(base, lower, "$x > 0$", [0.0, -0.85])
    sheet.dimension(upper, tip, "$x < 0$", [0.0, -0.85])
    sheet.text(base + [0.75, -1.3], "center_of_mass\nof lower", INK, fontsize=11.0)
    sheet.text(tip + [-0.8, -1.3], "center_of_mass\nof upper", INK, fontsize=11.0)
    sheet.text(base + [-0.2, 0.0], "base\npoint", BASE, "right")
    sheet.text(tip + [0.2, 0.0], "platform\npoint", PLATFORM, "left")
    return sheet.figure
