"""Function ``view``: a robot in motion, shown in a notebook or saved as one HTML file."""

from __future__ import annotations

import html
import os
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from ..dynamics.home_pose import home_pose
from ..io.arguments import instance, safe_text
from ..io.output import write_file
from ..kinematics.conditioning import characteristic_length
from ..motion.motion import Motion, at_rest
from ..motion.straight_line import StraightLinePath
from ..motion.trajectory import Trajectory
from ..robot.robot import Robot
from ..robot.units import Units
from ..simulation.state_history import StateHistory
from .content import content, data_text, limits_html, noise_html, parts_text
from .motion_history import LimitReport, MotionHistory, limits, of_motion, of_path, of_run, of_trajectory
from .page import document, filled, generator

_HEIGHT = 900


@dataclass(frozen=True, eq=False)
class Viewer:
    """Robot in motion as one HTML file; a notebook displays it at the end of a cell.

    Attributes
    ----------
    robot : Robot
        Robot.
    history : MotionHistory
        Displayed motion.
    """

    robot: Robot
    history: MotionHistory

    @property
    def title(self) -> str:
        """Names of the robot and the motion."""
        return f"{safe_text(self.robot.name)}: {safe_text(self.history.name)}"

    @cached_property
    def limits(self) -> LimitReport:
        """Limits of the robot compared with the motion."""
        return limits(self.robot, self.history)

    @property
    def html(self) -> str:
        """Text of the HTML file."""
        units = Units.of(self.robot)
        body = filled(
            "viewer.html",
            {
                "name": html.escape(safe_text(self.robot.name)),
                "motion": html.escape(safe_text(self.history.name)),
                "length": units.length,
                "moment": f"{(characteristic_length(self.robot) or 1.0) / units.meters:.4g}",
                "generator": html.escape(generator()),
                "parts": parts_text(self.robot),
                "noise": noise_html(self.history),
                "limits": limits_html(self.limits),
                "data": data_text(content(self.robot, self.history, self.limits)),
            },
        )
        return document(self.title, body, "main")

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the HTML file; an existing file is replaced after the new file is complete.

        Parameters
        ----------
        path : str or os.PathLike
            Path of the HTML file.

        Raises
        ------
        OSError
            If the file cannot be written; the message contains its name.
        """
        write_file(Path(path), self.html)

    def _repr_html_(self) -> str:
        """Return the page as a separate frame of a notebook."""
        return frame(self)


def frame(view: Viewer, height: int = _HEIGHT) -> str:
    """Return the page as a frame within another page; ``height`` is the height of the frame (pixels)."""
    values = {"title": html.escape(view.title), "page": html.escape(view.html), "height": str(height)}
    return filled("frame.html", values)


def view(
    robot: Robot,
    motion: Motion | StateHistory | Trajectory | StraightLinePath | str | None = None,
    time: Any = None,
) -> Viewer:
    """Show a robot in motion, in a notebook or in one HTML file.

    The file needs neither a network nor other files. It shows the robot in three dimensions with legs colored
    by force. Curves show forces, lengths, speeds, and the condition number over time, compared with the
    limits of legs and motors. For a noisy log they include standard deviations.

    Parameters
    ----------
    robot : Robot
        Robot to display.
    motion : Motion, StateHistory, Trajectory, StraightLinePath or str, optional
        Motion of shape (n,) at ``time``, result of ``simulate`` with its forces, trajectory, straight line,
        or path "I", "II", or "III" of the paper. By default, the robot is at rest at its home pose. A motion
        without accelerations is displayed without forces.
    time : array_like, shape (n,), optional
        Increasing times of a Motion (s). Not required for a single pose.

    Returns
    -------
    Viewer
        Object that a notebook displays. ``save(path)`` writes the file, and ``html`` is its text.

    Raises
    ------
    ValueError
        If an argument is invalid.

    See Also
    --------
    simulate : Simulate a motion that can be displayed.
    read_trajectory : Read a log that can be displayed.

    Notes
    -----
    Forces are computed for both formulations, or only for "exact" if the robot has rotor inertia or joint
    offsets.

    Examples
    --------
    >>> import pathlib
    >>> import tempfile
    >>> import stewart_sym as ss
    >>> viewer = ss.view(ss.robots.load("unal"))
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = pathlib.Path(folder) / "robot.html"
    ...     viewer.save(file)
    ...     file.read_text(encoding="utf-8")[:15]
    '<!DOCTYPE html>'
    """
    instance(robot, Robot, "robot")
    if time is not None and not isinstance(motion, Motion):
        raise ValueError("time: expected None unless motion is a Motion")
    return Viewer(robot, _history(robot, motion, time))


def _history(robot: Robot, motion: Any, times: Any) -> MotionHistory:
    if motion is None:
        return of_motion(robot, at_rest(np.eye(3), home_pose(robot).t), None, "home pose")
    if isinstance(motion, str | StraightLinePath):
        return of_path(robot, motion)
    if isinstance(motion, Trajectory):
        return of_trajectory(robot, motion)
    if isinstance(motion, StateHistory):
        return of_run(robot, motion)
    instance(motion, Motion, "motion")
    return of_motion(robot, motion, times)
