"""Drawings of the platform's free body, the joints of a leg, and the tool point."""

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
    direction,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def platform() -> "Figure":
    """Draw all forces and moments on the platform, (33) and (34)."""
    sheet = Sheet(7.2, 4.9)
    reference, mass = np.array([3.35, 2.45]), np.array([3.8, 3.0])
    left, right = np.array([1.15, 2.15]), np.array([5.6, 2.15])
    sheet.area(left, [1.0, 2.6], [2.6, 3.55], [5.0, 3.45], [5.75, 2.6], right, color=PLATFORM)
    for at, angle, name in ((left, 235.0, 1), (right, 300.0, 6)):
        sheet.joint(at)
        sheet.arrow(at + 0.08 * direction(angle), at + 1.15 * direction(angle))
        sheet.text(at + 1.4 * direction(angle), f"$-F_{{s{name}}}$", FORCE)
    sheet.text([3.35, 0.55], "$-F_{si}$ at all six platform points", FORCE)
    sheet.arrow(reference, right, GRAY, 1.3, linestyle="--")
    sheet.text(0.45 * reference + 0.55 * right + [0.0, -0.25], "$q_6$")
    sheet.arrow(reference, left, GRAY, 1.3, linestyle="--")
    sheet.text(0.5 * (reference + left) + [0.0, -0.3], "$q_1$")
    sheet.moment(left, left + 1.0 * direction(172.0) + [0.1, 0.3])
    sheet.text(left + [-0.7, 0.65], "$f_1$", MOMENT)
    sheet.moment(right, right + [1.0, 0.2])
    sheet.text(right + [1.2, 0.25], "$f_6$", MOMENT)
    sheet.mass(mass)
    sheet.arrow(mass, mass + [0.0, -1.7])
    sheet.text(mass + [0.2, -1.62], "$M g$", FORCE, "left")
    sheet.arrow(mass, mass + [0.95, 0.85], GRAY, linestyle="--")
    sheet.text(
        mass + [1.05, 1.05], "inertia: $-M a$ and\n$-I\\alpha - \\omega \\times I\\omega$", GRAY, "left"
    )
    sheet.arrow(reference, reference + [-0.85, 1.55])
    sheet.text(reference + [-0.95, 1.75], r"$R\,F_{ext}$", FORCE)
    sheet.moment(reference, reference + [0.25, 1.75])
    sheet.text(reference + [0.35, 1.97], r"$R\,M_{ext}$", MOMENT)
    sheet.dot(reference, PLATFORM, 7.0)
    sheet.text(reference + [-0.25, 0.12], "reference point", PLATFORM, "right")
    return sheet.figure


def _oblique(vector: tuple[float, float, float]) -> Array:
    """Project a vector of space to the plane of a drawing."""
    x, y, z = vector
    return np.array([0.9 * x - 0.45 * y, 0.28 * x + 0.32 * y + z])


def universal_joint() -> "Figure":
    """Draw the two axes of the universal joint, the leg, and the direction n of the constraint moment."""
    sheet = Sheet(6.4, 6.0)
    center = np.array([2.9, 3.0])
    k, y = _oblique((1.0, 0.0, 0.0)), _oblique((0.0, -1.0, 0.0))
    s, n = _oblique((0.62, 0.0, 0.78)), _oblique((0.0, 0.0, -1.0))
    for side in (-1.0, 1.0):
        foot = center + 1.25 * side * k
        sheet.line(foot, foot - [0.0, 1.6], color=BASE, width=5.0)
    sheet.line(center - 1.25 * k - [0.0, 1.6], center + 1.25 * k - [0.0, 1.6], color=BASE, width=5.0)
    sheet.line(center - 1.25 * k, center + 1.25 * k, color=AXIS, width=4.0)
    sheet.line(center - 0.85 * y, center + 0.85 * y, color=LOWER, width=4.0)
    for side in (-1.0, 1.0):
        sheet.line(center + 0.85 * side * y, center + 0.85 * side * y + 0.7 * s, color=LOWER, width=5.0)
    sheet.line(center - 0.85 * y + 0.7 * s, center + 0.85 * y + 0.7 * s, color=LOWER, width=5.0)
    sheet.line(center + 0.7 * s, center + 2.1 * s, color=LOWER, width=9.0)
    sheet.joint(center)
    sheet.arrow(center + 1.25 * k, center + 2.2 * k, AXIS)
    sheet.text(center + 2.3 * k + [0.35, -0.35], "$k$, fixed axis\non the base", AXIS)
    sheet.arrow(center + 0.85 * y, center + 1.75 * y, LOWER)
    sheet.text(center + 1.75 * y + [-0.22, -0.45], "$y$, axis\non the leg", LOWER)
    sheet.arrow(center + 2.1 * s, center + 2.8 * s, LOWER)
    sheet.text(center + 2.85 * s + [0.05, 0.1], "$s$", LOWER, "left")
    sheet.moment(center, center + 2.0 * n)
    sheet.text(
        center + 2.4 * n,
        "constraint moment $M_u\\,n$\n$n = k \\times y$, normal to both axes",
        MOMENT,
    )
    sheet.text([1.4, 1.2], "base", BASE)
    return sheet.figure


def offset_joint() -> "Figure":
    """Draw a leg whose axes and line of sliding miss each other, with a universal platform joint."""
    sheet = Sheet(7.4, 6.8)
    base = np.array([2.1, 1.0])
    s, z = direction(82.0), direction(-8.0)
    moving = base + [0.0, 1.05]
    start = moving + 1.75 * z
    end = start + 3.1 * s
    tip = end + 0.75 * s
    sheet.ground(base - [0.0, 0.28])
    sheet.line(base - [0.75, 0.0], base + [0.75, 0.0], color=AXIS, width=2.0, style="-.")
    sheet.line(base, moving, color=INK, width=7.0)
    sheet.line(moving, start, color=LOWER, width=7.0)
    sheet.body(start - 0.1 * s, start + 1.8 * s, 0.42, LOWER)
    sheet.body(start + 1.3 * s, end, 0.2, UPPER)
    sheet.line(end, tip, color=INK, width=7.0)
    sheet.line(tip - [0.75, 0.0], tip + [0.75, 0.0], color=AXIS, width=2.0, style="-.")
    sheet.area(tip + [-0.9, 0.17], tip + [1.9, 0.17], tip + [1.9, 0.42], tip + [-0.9, 0.42], color=PLATFORM)
    for point in (base, moving, end, tip):
        sheet.joint(point)
    sheet.text(base + [0.9, 0.0], "fixed axis $k$ through the base point", AXIS, "left")
    sheet.text(moving + [-0.2, 0.42], "moving axis $y$\n(toward the reader)", AXIS)
    sheet.dimension(base, moving, "axis_offset", [-0.85, 0.0])
    sheet.dimension(moving, start, "slide_offset_z", -0.5 * s)
    sheet.dimension(start, end, "length $L$", 1.0 * z)
    sheet.dimension(end, tip, "wrist_offset", -1.1 * z)
    sheet.text(
        start + 0.62 * s + 1.25 * z, "line of sliding $s$,\nmoved by slide_offset_y\nalong $y$", LOWER, "left"
    )
    sheet.text(tip + [0.9, -0.08], "platform_axis through\nthe platform point", AXIS, "left", va="top")
    return sheet.figure


def tool_point() -> "Figure":
    """Draw the tool point, whose pose a trajectory describes, and the reference point."""
    sheet = Sheet(7.2, 6.0)
    origin, reference = np.array([1.1, 0.85]), np.array([3.3, 3.0])
    angle = 12.0
    x, z = direction(angle), direction(angle + 90.0)
    corner = reference - 1.7 * x
    sheet.area(corner, corner + 3.4 * x, corner + 3.4 * x - 0.28 * z, corner - 0.28 * z, color=PLATFORM)
    body = reference + 0.2 * x
    sheet.area(
        body - 0.5 * x, body + 0.9 * x, body + 0.9 * x + 0.85 * z, body - 0.5 * x + 0.85 * z, color=UPPER
    )
    tool = reference + 1.15 * x + 1.95 * z
    sheet.line(body + 0.6 * x + 0.85 * z, tool, color=INK, width=2.5)
    for foot, top in (([2.35, 0.85], -1.4), ([3.0, 0.85], -0.9), ([4.1, 0.85], 0.9), ([5.1, 0.85], 1.4)):
        sheet.line(foot, reference + top * x - 0.3 * z, color=LOWER, width=4.0)
        sheet.joint(foot)
        sheet.joint(reference + top * x - 0.3 * z)
    sheet.ground([3.75, 0.7], 3.6)
    sheet.frame(origin, 0.0, 0.6, ("X", "Z"), BASE)
    sheet.frame(reference, angle, 0.8, ("$x_P$", "$z_P$"), PLATFORM)
    sheet.arrow(reference, tool, AXIS, 1.6, linestyle="--")
    sheet.text(0.68 * reference + 0.32 * tool + [0.2, -0.02], "tool", AXIS, "left")
    sheet.dot(tool, FORCE, 9.0)
    sheet.text(tool + [0.2, 0.3], "tool point: poses and loads\nof a trajectory", FORCE, "left")
    sheet.arrow(origin, reference, GRAY, 1.4, linestyle="--")
    sheet.text([2.05, 1.55], "$t$")
    sheet.arrow(origin, tool, FORCE, 1.4, linestyle="--")
    sheet.text([1.25, 3.4], "position in the file:\n$t + R\\,$tool", FORCE)
    sheet.dot(reference, PLATFORM, 7.0)
    sheet.text(
        reference + [1.9, 0.1], "reference point:\nMotion, reactions,\nequations of motion", PLATFORM, "left"
    )
    return sheet.figure
