"""``ss.view``: a machine in motion, shown in a notebook or written to one HTML file."""

from __future__ import annotations

import html
import os
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, cast

from ..dynamics.home_pose import home_pose
from ..io.arguments import instance, safe_text
from ..io.atomic_write import replaced_file
from ..kinematics.conditioning import characteristic_length
from ..motion.motion import Motion
from ..motion.straight_line import StraightLinePath
from ..motion.trajectory import PoseLog, Trajectory
from ..robot.robot import Robot
from ..simulation.state_history import StateHistory
from .content import content, data_text, limits_html, noise_html, parts_text, units
from .limit_report import LimitReport, limits
from .motion_history import MotionHistory, at_home, of_motion, of_path, of_run, of_trajectory
from .page import document, filled, generator

_HEIGHT = 900


@dataclass(frozen=True, eq=False)
class Viewer:
    """A machine in motion as one HTML file; in a notebook it is shown where it stands at a cell's end.

    Attributes
    ----------
    robot : Robot
        The machine.
    instants : Instants
        What is shown of its motion.
    """

    robot: Robot
    instants: MotionHistory

    @property
    def title(self) -> str:
        """Names of machine and motion."""
        return f"{safe_text(self.robot.name)}: {safe_text(self.instants.name)}"

    @cached_property
    def limits(self) -> LimitReport:
        """The machine's limits beside the motion."""
        return limits(self.robot, self.instants)

    @property
    def html(self) -> str:
        """The file's text."""
        shown = units(self.robot)
        body = filled(
            "viewer.html",
            {
                "name": html.escape(safe_text(self.robot.name)),
                "motion": html.escape(safe_text(self.instants.name)),
                "length": shown["lengthName"],
                "moment": f"{(characteristic_length(self.robot) or 1.0) * shown['length']:.4g}",
                "generator": html.escape(generator()),
                "parts": parts_text(self.robot),
                "noise": noise_html(self.instants),
                "limits": limits_html(self.limits),
                "data": data_text(content(self.robot, self.instants, self.limits)),
            },
        )
        return document(self.title, body, "main")

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the file; what stands there is replaced once all is written.

        Parameters
        ----------
        path : str or os.PathLike
            Where to write.

        Raises
        ------
        OSError
            Naming the file, when it can't be written.
        """
        with replaced_file(Path(path)) as stream:
            stream.write(self.html)

    def _repr_html_(self) -> str:
        """The page within a notebook's, closed off from it."""
        return frame(self)


def frame(view: Viewer, height: int = _HEIGHT) -> str:
    """The page as a frame within another; height: of the frame, pixels."""
    values = {"title": html.escape(view.title), "page": html.escape(view.html), "height": str(height)}
    return filled("frame.html", values)


def view(
    robot: Robot,
    motion: Motion | StateHistory | Trajectory | PoseLog | StraightLinePath | str | None = None,
    time: Any = None,
) -> Viewer:
    """Return a machine in motion, to be looked at in a notebook or saved as one HTML file.

    The file needs no network and no other file. It shows the machine in three dimensions with its legs
    colored by force, and forces, lengths, speeds and condition number over time, beside the limits of legs
    and motors; of a log with noise with the deviations that it leaves. Forces are of both formulations, of
    ``exact`` alone for a robot whose drive has rotor inertia.

    Parameters
    ----------
    robot : Robot
        The machine.
    motion : Motion, StateHistory, Trajectory, PoseLog, StraightLinePath or str, optional
        A motion of shape (n,) at ``time``; what ``simulate`` returns, with the forces that acted; a
        trajectory; a straight line; I, II or III, a path of the paper. None: at rest at the home pose. A
        motion without accelerations is shown without forces.
    time : array_like, optional
        Of a Motion, s, (n,), increasing. None: for a motion of one pose.

    Returns
    -------
    Viewer
        Shown by a notebook; ``save(path)`` writes the file, ``html`` is its text.

    Raises
    ------
    ValueError
        Naming the argument.
    """
    instance(robot, Robot, "robot")
    if time is not None and not isinstance(motion, Motion):
        raise ValueError("time: are for a Motion, expected none")
    return Viewer(robot, _instants(robot, motion, time))


def _instants(robot: Robot, motion: object, times: object) -> MotionHistory:
    if motion is None:
        return at_home(robot, home_pose(robot).t)
    if isinstance(motion, str | StraightLinePath):
        return of_path(robot, motion)
    if isinstance(motion, Trajectory | PoseLog):
        return of_trajectory(robot, motion)
    if isinstance(motion, StateHistory):
        return of_run(robot, motion)
    instance(motion, Motion, "motion")
    if times is None and cast(Motion, motion).shape not in ((), (1,)):
        raise ValueError("times: expected the times of the motion's poses, s, got none")
    return of_motion(robot, cast(Motion, motion), times)
