"""Drawings of the paper's Path I and of the data flow through the program."""

from typing import TYPE_CHECKING, Any

import numpy as np
from drawing_sheet import AXIS, FORCE, GRAY, INK, LOWER, MOMENT, PAPER, PLATFORM, Sheet

import stewart_sym as ss

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def path_I() -> "Figure":
    """Draw the machine at both ends of Path I, and its position, yaw, speed, and yaw rate over time."""
    from matplotlib.figure import Figure

    path = ss.StraightLinePath(
        t0=(0.1, 0.0, 0.4),
        theta0=(0.0, 0.0, -0.2),
        t1=(0.3, 0.0, 0.6),
        theta1=(0.0, 0.0, 0.2),
        tau_f=6.0,
        V=0.08,
        Omega=0.08,
    )
    time = np.linspace(0.0, 6.0, 241)
    motion = path.sample(time)
    figure = Figure(figsize=(8.4, 4.6), facecolor=PAPER)
    machine: Any = figure.add_axes((0.0, 0.0, 0.5, 1.0), projection="3d", facecolor=PAPER)
    _machine(machine, motion)
    yaw = np.arctan2(motion.R[:, 1, 0], motion.R[:, 0, 0])
    top, bottom = (figure.add_axes((0.6, y, 0.29, 0.33), facecolor=PAPER) for y in (0.58, 0.13))
    _curves(top, time, motion.t[:, [0, 2]], yaw, ("position (m)", "yaw (rad)"), ("$t_x$", "$t_z$", "yaw"))
    rates = (motion.v[:, [0, 2]], motion.omega[:, 2], ("velocity (m/s)", "yaw rate (rad/s)"))
    _curves(bottom, time, *rates, ("$v_x = v_z$", "", "yaw rate"))
    top.tick_params(labelbottom=False)
    bottom.set_xlabel("time (s)")
    return figure


def _machine(axes: Any, motion: ss.Motion) -> None:
    """Draw the paper's robot at the first and at the last pose."""
    robot = ss.robots.dasgupta1998()
    axes.set_axis_off()
    axes.view_init(elev=16.0, azim=-72.0)
    axes.plot(*np.vstack([robot.b, robot.b[:1]]).T, color=INK, linewidth=2.0)
    for index, alpha in ((0, 0.35), (-1, 1.0)):
        tips = motion.t[index] + robot.p @ motion.R[index].T
        axes.plot(*np.vstack([tips, tips[:1]]).T, color=PLATFORM, linewidth=2.0, alpha=alpha)
        for base, tip in zip(robot.b, tips, strict=True):
            axes.plot(*np.stack([base, tip]).T, color=LOWER, linewidth=2.4, alpha=alpha)
    axes.plot(*motion.t.T, color=FORCE, linewidth=2.4)
    axes.scatter(*motion.t[[0, -1]].T, color=FORCE, s=30, depthshade=False)
    for index, name, shift in ((0, "0 s", -0.16), (-1, "6 s", 0.05)):
        axes.text(*(motion.t[index] + [shift, 0.0, 0.03]), name, color=FORCE, fontsize=12)
    axes.set_box_aspect((1.0, 1.0, 0.8), zoom=1.5)
    axes.set(xlim=(-0.5, 0.6), ylim=(-0.5, 0.6), zlim=(-0.1, 0.75))


def _curves(
    axes: Any, time: Any, left: Any, right: Any, labels: tuple[str, str], names: tuple[str, ...]
) -> None:
    other = axes.twinx()
    for column, style, name in zip(left.T, ("-", "--"), names, strict=False):
        if name:
            axes.plot(time, column, color=FORCE, linestyle=style, label=name)
    other.plot(time, right, color=AXIS, label=names[2], linewidth=1.6)
    axes.set_ylabel(labels[0], color=FORCE)
    other.set_ylabel(labels[1], color=AXIS)
    handles = [*axes.lines, *other.lines]
    axes.legend(
        handles=handles, fontsize=9, frameon=False, ncol=3, loc="lower center", bbox_to_anchor=(0.5, 0.98)
    )
    axes.set_xlim(0.0, 6.0)


def data_flow() -> "Figure":
    """Draw the flow of data: robot and motion to results, equations to generated kernels."""
    sheet = Sheet(8.6, 5.2)
    boxes = {
        "robot": (1.3, 4.3, "robot file\nrobot.toml", LOWER),
        "motion": (1.3, 2.9, "motion, trajectory,\nor scene", LOWER),
        "equations": (1.3, 1.0, "equations of\none leg and of\nthe platform", PLATFORM),
        "blocks": (3.75, 1.0, "blocks\n(SymPy, shared\nsubexpressions)", PLATFORM),
        "printers": (6.35, 1.0, "printers:\nC, Python,\nMATLAB, Rust", PLATFORM),
        "constants": (3.75, 4.3, "prepared\nconstants", LOWER),
        "kernel": (4.7, 2.9, "kernel: D, K, H, c;\nsolve; status", FORCE),
        "results": (7.3, 2.9, "forces, reactions,\nM, C, g, ...", MOMENT),
        "kit": (7.3, 4.3, "kit, FMU,\nyour firmware", MOMENT),
    }
    for x, y, words, color in boxes.values():
        wide, high = 1.0, 0.46
        sheet.area(
            [x - wide, y - high],
            [x + wide, y - high],
            [x + wide, y + high],
            [x - wide, y + high],
            color=color,
            alpha=0.16,
        )
        sheet.text([x, y], words, INK, fontsize=11.0)
    for start, end in (
        ([2.3, 4.3], [2.75, 4.3]),
        ([4.1, 3.84], [4.4, 3.36]),
        ([2.3, 2.9], [3.7, 2.9]),
        ([5.7, 2.9], [6.3, 2.9]),
        ([2.3, 1.0], [2.75, 1.0]),
        ([4.75, 1.0], [5.35, 1.0]),
        ([6.1, 1.46], [5.2, 2.44]),
        ([5.5, 3.36], [6.3, 4.1]),
    ):
        sheet.arrow(start, end, GRAY, 1.8)
    sheet.text([4.25, 1.95], "derive: once, ahead of use", PLATFORM, fontsize=10.5)
    return sheet.figure
