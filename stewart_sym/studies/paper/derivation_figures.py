"""Figures of the derivation notebooks: cone of a universal joint, printed and corrected terms, energy."""

import numpy as np

from ...io.array_types import Array
from ...motion.straight_line import PAPER_PATHS
from ...reference import newton_euler
from ...robot.robot import Robot
from ..common.drawing import Figure, new_figure

PRINTED, CORRECTED, INK = "#d55e00", "#0072b2", "#333333"
"""Colors of printed and corrected equations, and of everything else."""
LEG_COLORS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#000000")
LEG_STYLES = ("-", "--", "-.", ":", (0, (5, 1)), (0, (3, 1, 1, 1)))


def cone(directions: Array, printed: Array, corrected: Array, fixed_axis: Array) -> Figure:
    """Draw a leg that sweeps once around a cone, with its second joint axis by both conditions.

    ``directions`` of the leg, first and last equal, and second axes of the joint ``printed`` without spin and
    ``corrected`` have shape (n, 3).
    """
    figure = new_figure(9.5, 3.8)
    shown = np.linspace(0, len(directions) - 1, 13).astype(int)
    sweep = np.linspace(0.0, 360.0, len(directions))
    for column, (axes_y, color, title) in enumerate(
        ((printed, PRINTED, "printed: s.W = 0"), (corrected, CORRECTED, "universal joint: n.W = 0"))
    ):
        axes = figure.add_subplot(1, 3, column + 1, projection="3d")
        axes.plot(*directions.T, color=INK, linewidth=1.0)
        for i in shown:
            axes.plot(*np.array([np.zeros(3), directions[i]]).T, color=INK, linewidth=0.6, alpha=0.5)
            axes.plot(*(directions[i] + np.outer([-0.16, 0.16], axes_y[i])).T, color=color, linewidth=2.0)
        # The first and the last position are the same place.
        axes.plot(*(directions[-1] + np.outer([-0.3, 0.3], axes_y[-1])).T, color=color, linewidth=3.0)
        axes.plot(*np.array([np.zeros(3), 0.9 * fixed_axis]).T, color=INK, linestyle="--", linewidth=1.2)
        axes.text(*(0.98 * fixed_axis), "k")
        axes.set_title(title, fontsize=9.0, color=color)
        axes.set(xlim=(-0.6, 0.6), ylim=(-0.6, 0.6), zlim=(0.0, 1.0))
        axes.set_box_aspect((1.2, 1.2, 1.0), zoom=1.25)
        axes.view_init(28.0, -60.0)
        axes.set_axis_off()
    panel = figure.add_subplot(1, 3, 3)
    for axes_y, color, label in ((printed, PRINTED, "printed"), (corrected, CORRECTED, "universal joint")):
        angle = np.degrees(np.arccos(np.clip(axes_y @ fixed_axis, -1.0, 1.0)))
        panel.plot(sweep, angle, color=color, label=label)
    panel.set(xlabel="sweep around the cone, degrees", ylabel="angle between k and y, degrees")
    panel.set(xlim=(0.0, 360.0), xticks=(0, 90, 180, 270, 360))
    panel.legend(frameon=False, fontsize=8.0)
    panel.grid(linewidth=0.4, alpha=0.6)
    return figure


def printed_and_corrected(robot: Robot, path: str = "II", leg: int = 0) -> Figure:
    """Draw the terms of one leg that the first three faults change, over time on a path of the paper."""
    motion_path = PAPER_PATHS[path].path
    time = np.linspace(0.0, motion_path.breakpoints()[-1], 601)
    motion = motion_path.sample(time)
    figure = new_figure(7.5, 6.0)
    labels = {
        newton_euler.SPIN: r"fault 1: spin $\mathbf{s}\cdot\mathbf{W}$, rad/s",
        newton_euler.MOMENT: r"fault 2: $\mathbf{K}\cdot\mathbf{y}$, N",
        newton_euler.TRANSPORT: "fault 3: moment of the\nupper part, N m",
    }
    terms = dict(zip(labels, (_spin, _transverse, _upper_moment), strict=True))
    panels = figure.subplots(3, 1, sharex=True)
    for panel, (fault, label) in zip(panels, labels.items(), strict=True):
        for faults, color, style, name in (
            (frozenset({fault}), PRINTED, "--", "printed"),
            (newton_euler.EXACT, CORRECTED, "-", "corrected"),
        ):
            values = terms[fault](newton_euler.legs(robot, motion, faults))[:, leg]
            panel.plot(time, values, color=color, linestyle=style, linewidth=1.6, label=name)
        panel.set_ylabel(label, fontsize=9.0)
        panel.grid(linewidth=0.4, alpha=0.6)
    panels[0].legend(frameon=False, fontsize=9.0, ncols=2)
    panels[-1].set(xlabel=f"time on Path {path}, s", xlim=time[[0, -1]])
    return figure


def _spin(legs: newton_euler.Legs) -> Array:
    """Return the angular velocity of the legs about their own axes (rad/s)."""
    return np.asarray(np.sum(legs.W * legs.s, axis=-1))


def _transverse(legs: newton_euler.Legs) -> Array:
    """Return the transverse forces along the second axes of the universal joints (N)."""
    return np.asarray(np.sum(legs.K * legs.y, axis=-1))


def _upper_moment(legs: newton_euler.Legs) -> Array:
    """Return the moments of the upper parts' motion about the second axes (N m), without their mass terms."""
    turned = np.einsum("...ij,...j->...i", legs.I_u, legs.A)
    spun = np.cross(legs.W, np.einsum("...ij,...j->...i", legs.I_u, legs.W))
    return np.asarray(np.sum((turned + spun) * legs.y, axis=-1))


def along_path(time: Array, difference: Array, edges: Array, accounts: dict[str, Array]) -> Figure:
    """Draw the change of six forces (N) over time, and work minus energy (J) at ``edges`` by formulation."""
    figure = new_figure(7.5, 6.0)
    forces, energies = figure.subplots(2, 1, sharex=True, height_ratios=[3, 2])
    for i in range(6):
        style = {"color": LEG_COLORS[i], "linestyle": LEG_STYLES[i], "linewidth": 1.6}
        forces.plot(time, difference[:, i], label=f"leg {i + 1}", **style)
    forces.set_ylabel("force, paper minus exact, N")
    forces.legend(ncols=6, fontsize=8, loc="upper center", bbox_to_anchor=(0.5, 1.14), frameon=False)
    for (name, values), color, line in zip(accounts.items(), (PRINTED, CORRECTED), ("-", "--"), strict=True):
        energies.plot(edges, values, color=color, linewidth=1.8, linestyle=line, label=name)
    energies.set(ylabel="work minus energy gained, J", xlabel="time on Path I, s")
    energies.legend(fontsize=9, frameon=False)
    for panel in (forces, energies):
        panel.grid(linewidth=0.4, alpha=0.6)
        panel.set_xlim(edges[0], edges[-1])
    return figure
