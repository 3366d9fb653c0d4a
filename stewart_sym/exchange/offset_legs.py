"""Legs with joint offsets: their bodies and joints in a model, and identification of offsets in a model."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..io.array_types import Array
from ..motion.motion import at_rest
from ..robot.fields import LEGS, legs_text
from ..robot.offset_chains import chains
from ..robot.offset_positions import Chains
from ..robot.offsets import JointOffsets
from ..robot.robot import Robot
from .model import WORLD, Body, Joint, Shape

_LEAST = 1e-9
"""Mass and inertia of a massless cross relative to the lower part, because simulators require some."""


def chains_at(robot: Robot, t: Array) -> Chains:
    """Return the leg chains with the platform at rest at t, (3,); raise ValueError out of reach."""
    with np.errstate(all="ignore"):
        at = chains(robot, at_rest(np.eye(3), t))
    lost = [i for i in range(LEGS) if not np.isfinite(at.U[i]).all()]
    if lost:
        raise ValueError(f"{legs_text(lost)}: expected a home pose that their offsets reach, got none")
    return at


def cross_of(robot: Robot, offsets: JointOffsets, i: int, at: Chains, radius: float) -> Body:
    """Return the body between both axes of leg i, with the frame o, y, k at the base point.

    It rotates about k only, so its inertia about k is used for all axes. A massless body gets a billionth of
    the mass of the lower part on the axis.
    """
    frame = np.stack([at.o[i], at.y[i], robot.k[i]], axis=-1)
    mass, inertia = float(offsets.cross_mass[i]), float(offsets.cross_inertia[i])
    reach = np.array([float(offsets.axis_offset[i]), 0.0, 0.0])
    return Body(
        f"cross_{i + 1}",
        frame,
        robot.b[i],
        mass or _LEAST * float(robot.m_d[i]),
        offsets.cross_center[i] if mass else np.zeros(3),
        (inertia or _LEAST * float(np.trace(robot.I_d0[i]))) * np.eye(3),
        (Shape(radius, np.zeros(3), reach),),
    )


def base_joints(robot: Robot, i: int, at: Chains) -> tuple[Joint, Joint]:
    """Create the joints of leg i about the fixed axis and about the moving axis."""
    cross, lower, damping = f"cross_{i + 1}", f"lower_{i + 1}", float(robot.C_u[i])
    first = Joint(f"base_{i + 1}_1", "revolute", WORLD, cross, axes=robot.k[i][None], damping=damping)
    second = Joint(f"base_{i + 1}_2", "revolute", cross, lower, axes=at.y[i][None], damping=damping)
    return first, second


@dataclass(frozen=True, eq=False)
class OffsetLines:
    """Both axes at the base and the sliding axis of a leg, in the world frame.

    Attributes
    ----------
    b : ndarray, shape (3,)
        Base point.
    A : ndarray, shape (3,)
        Intersection of the common normal o with the moving axis.
    k, y : ndarray, shape (3,)
        Directions of the fixed and of the moving axis.
    tip : ndarray, shape (3,)
        End of the sliding axis.
    """

    b: Array
    A: Array
    k: Array
    y: Array
    tip: Array

    @classmethod
    def of(cls, points: Array, axes: Array, tip: Array) -> "OffsetLines":
        """Create the lines from points and directions of two perpendicular axes, (2, 3), fixed axis first."""
        (first, second), (k, y) = points, axes
        between = second - first
        b, A = first + (between @ k) * k, second - (between @ y) * y
        return cls(b, A, k, -y if np.cross(y, k) @ (tip - b) < 0.0 else y, tip)

    def offsets(self, s: Array) -> dict[str, float]:
        """Compute the offset lengths with the sliding axis along s, outward."""
        r, o = self.tip - self.A, np.cross(self.y, self.k)
        return {
            "axis_offset": float((self.A - self.b) @ o),
            "slide_offset_y": float(r @ self.y),
            "slide_offset_z": float(r @ np.cross(s, self.y)),
        }

    def cross(self, body: Body) -> dict[str, Any]:
        """Return mass, center of mass (from the base point along o, y, k), and inertia of a cross."""
        frame = np.stack([np.cross(self.y, self.k), self.y, self.k], axis=-1)
        center = (body.placed(body.center) - self.b) @ frame if body.mass else np.zeros(3)
        about = self.k @ body.R @ body.inertia @ body.R.T @ self.k
        return {"cross_mass": body.mass, "cross_center": center, "cross_inertia": float(about)}
