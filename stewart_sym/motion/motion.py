"""Motion of the platform at one or many samples: pose, velocities, accelerations, and external load."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..io.arguments import finite_array, leading_shape
from ..io.array_types import Array, Frozen, read_only
from ..io.error_policy import errors_of
from . import rotation

ROTATION_TOLERANCE = 1e-9
FLOAT_TOLERANCE = 16.0 * float(np.finfo(np.float32).eps)
"""Tolerance of R^T R = E for R of type float32: rounding of R and of the operations before."""


@dataclass(frozen=True, eq=False, kw_only=True)
class Motion(Frozen):
    """Motion of the platform: pose, velocities, accelerations, and load of the reference point.

    Vectors are in the base frame, except the load. The leading shapes of the arguments broadcast to one
    ``shape``. The arrays are read-only copies of this shape, and ``motion[index]`` slices them.

    Attributes
    ----------
    R : ndarray, shape (..., 3, 3)
        Rotation matrix from the platform frame to the base frame.
    t : ndarray, shape (..., 3)
        Position of the reference point (m).
    omega, v : ndarray, shape (..., 3)
        Angular velocity (rad/s), and velocity of the reference point (m/s).
    alpha, a : ndarray, shape (..., 3), optional
        Angular acceleration (rad/s^2), and acceleration of the reference point (m/s^2). Both are None if the
        motion has no accelerations, for example for forward dynamics.
    F_ext, M_ext : ndarray, shape (..., 3), optional
        External force (N) and moment (N m) at the reference point in the platform frame. None means no load.

    Raises
    ------
    ValueError
        If shapes do not broadcast, a number is not finite, R is not a rotation (R^T R = E to 1e-9 and
        det R > 0), or only one of alpha and a is given. The message names the argument.

    Notes
    -----
    R of type float32 may differ from a rotation by 2e-6. It is replaced by the nearest rotation in double
    precision.

    Examples
    --------
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> rest = np.zeros(3)
    >>> motion = ss.Motion(R=np.eye(3), t=[[0.0, 0.0, 0.5], [0.0, 0.0, 0.6]], omega=rest, v=rest)
    >>> motion.shape, motion[1].t.tolist()
    ((2,), [0.0, 0.0, 0.6])
    """

    R: Array
    t: Array
    omega: Array
    v: Array
    alpha: Array | None = None
    a: Array | None = None
    F_ext: Array | None = None
    M_ext: Array | None = None

    def __post_init__(self) -> None:
        if (self.alpha is None) != (self.a is None):
            missing = "alpha" if self.alpha is None else "a"
            raise ValueError(f"{missing}: expected both accelerations, alpha and a, or neither")
        self._store(_checked(vars(self)))

    def _store(self, arrays: dict[str, Array]) -> None:
        """Store checked arrays, broadcast to one leading shape."""
        shape = _leading_shape(arrays)
        for name, array in arrays.items():
            core = array.shape[-2:] if name == "R" else array.shape[-1:]
            object.__setattr__(self, name, np.broadcast_to(read_only(array), (*shape, *core)))

    @property
    def shape(self) -> tuple[int, ...]:
        """Leading shape of the arrays; () for one sample."""
        return self.t.shape[:-1]

    def __getitem__(self, index: Any) -> Motion:
        """Slice the leading shape like a NumPy array of this shape."""
        index = index if isinstance(index, tuple) else (index,)
        # Indices apply to the leading shape only, so the axes of the vectors are added.
        rest = () if any(item is Ellipsis for item in index) else (Ellipsis,)
        picked: dict[str, Any] = {}
        for field in fields(self):
            value = getattr(self, field.name)
            own = (slice(None),) * (2 if field.name == "R" else 1)
            picked[field.name] = None if value is None else value[(*index, *rest, *own)]
        return Motion._unchecked(**picked)

    def external_wrench(self) -> Array:
        """Return the external load in the base frame, [R F_ext; R M_ext].

        Returns
        -------
        ndarray, shape (..., 6)
            Force (N) and moment (N m) about the reference point; 0 without a load.
        """
        load = [np.zeros(3) if vector is None else vector for vector in (self.F_ext, self.M_ext)]
        turned = [np.einsum("...ij,...j->...i", self.R, vector) for vector in load]
        return np.concatenate(turned, axis=-1)

    def at_point(self, point: ArrayLike) -> Motion:
        """Return the motion of another point of the platform in place of the reference point.

        ``motion.at_point(robot.tool)`` is the motion of the tool; ``.at_point(-robot.tool)`` undoes it. If
        the motion has a load, its moment becomes the moment about the new point.

        Parameters
        ----------
        point : array_like, shape (3,)
            Position of the point from the reference point in the platform frame (m).

        Returns
        -------
        Motion
            Motion of the point, of the same shape.
        """
        p = finite_array(point, (3,), "point")
        arm = self.R @ p
        turned = rotation.cross(self.omega, arm)
        moved = {"R": self.R, "t": self.t + arm, "omega": self.omega, "v": self.v + turned}
        if self.a is not None and self.alpha is not None:
            a = self.a + rotation.cross(self.alpha, arm) + rotation.cross(self.omega, turned)
            moved |= {"alpha": self.alpha, "a": a}
        if self.F_ext is not None:
            moved |= {"F_ext": self.F_ext, "M_ext": rotation.cross(self.F_ext, p)}
        if self.M_ext is not None:
            moved["M_ext"] = self.M_ext + moved.get("M_ext", 0.0)
        return Motion._unchecked(**moved)

    def __iter__(self) -> Iterator[Motion]:
        if not self.shape:
            raise TypeError("a motion of shape () is one sample and cannot be iterated over")
        return (self[i] for i in range(self.shape[0]))

    @classmethod
    def _unchecked(
        cls,
        R: Array,
        t: Array,
        omega: Array,
        v: Array,
        alpha: Array | None = None,
        a: Array | None = None,
        F_ext: Array | None = None,
        M_ext: Array | None = None,
    ) -> Motion:
        """Create a motion from checked arrays of one leading shape, without copies.

        For inner loops, in which the checks would cost more time than the dynamics.
        """
        motion = object.__new__(cls)
        motion.__dict__.update(R=R, t=t, omega=omega, v=v, alpha=alpha, a=a, F_ext=F_ext, M_ext=M_ext)
        return motion

    @classmethod
    def at_rest(
        cls, R: ArrayLike, t: ArrayLike, F_ext: ArrayLike | None = None, M_ext: ArrayLike | None = None
    ) -> Motion:
        """Create poses at rest, optionally under a load: all rates and accelerations are 0.

        Parameters
        ----------
        R : array_like, shape (..., 3, 3)
            Rotation matrix from the platform frame to the base frame.
        t : array_like, shape (..., 3)
            Position of the reference point in the base frame (m).
        F_ext, M_ext : array_like, shape (..., 3), optional
            Load, as in ``Motion``.

        Returns
        -------
        Motion
            Motion with zero rates and accelerations.

        Raises
        ------
        ValueError
            If an argument is invalid, as in ``Motion``.

        Examples
        --------
        >>> import numpy as np
        >>> import stewart_sym as ss
        >>> pose = ss.Motion.at_rest(R=np.eye(3), t=[0.0, 0.0, 0.7])
        >>> ss.inverse_kinematics(ss.robots.load("unal"), pose).L.round(3).tolist()
        [0.617, 0.617, 0.617, 0.617, 0.617, 0.617]
        """
        zero = np.zeros(3)
        return cls(R=R, t=t, omega=zero, v=zero, alpha=zero, a=zero, F_ext=F_ext, M_ext=M_ext)  # type: ignore[arg-type]

    @classmethod
    def from_rpy(
        cls,
        t: ArrayLike,
        theta: ArrayLike,
        v: ArrayLike,
        theta_dot: ArrayLike,
        a: ArrayLike | None = None,
        theta_ddot: ArrayLike | None = None,
        F_ext: ArrayLike | None = None,
        M_ext: ArrayLike | None = None,
    ) -> Motion:
        """Create a motion from roll, pitch, and yaw, (38), and their rates.

        Parameters
        ----------
        t : array_like, shape (..., 3)
            Position of the reference point in the base frame (m).
        theta : array_like, shape (..., 3)
            Angles (theta_x, theta_y, theta_z) (rad), R = Rz(theta_z) Ry(theta_y) Rx(theta_x).
        v, theta_dot : array_like, shape (..., 3)
            Velocity of the reference point (m/s), and time derivatives of the angles (rad/s), which differ
            from the angular velocity.
        a, theta_ddot : array_like, shape (..., 3), optional
            Their time derivatives; required if and only if the other one is given.
        F_ext, M_ext : array_like, shape (..., 3), optional
            Load, as in ``Motion``.

        Returns
        -------
        Motion
            Motion; without accelerations if a is not given.

        Raises
        ------
        ValueError
            If an argument is invalid, as in ``Motion``.

        Examples
        --------
        >>> import stewart_sym as ss
        >>> rest = [0.0, 0.0, 0.0]
        >>> motion = ss.Motion.from_rpy(t=rest, theta=[0.1, 0.0, 0.0], v=rest, theta_dot=[0.0, 0.0, 1.0])
        >>> motion.omega.tolist()
        [0.0, 0.0, 1.0]
        """
        turns = {"theta": theta, "theta_dot": theta_dot, "theta_ddot": theta_ddot}
        given = {"t": t, "v": v, "a": a, "F_ext": F_ext, "M_ext": M_ext}
        return cls._turned(rotation.motion_about_axes, turns, given)

    @classmethod
    def _turned(
        cls,
        convert: Callable[..., tuple[Array, Array, Array]],
        turns: dict[str, ArrayLike | None],
        given: dict[str, Any],
    ) -> Motion:
        """Create a motion from an orientation and its derivatives, which a function converts."""
        second = list(turns)[-1]
        if (given["a"] is None) != (turns[second] is None):
            missing = "a" if given["a"] is None else second
            raise ValueError(f"{missing}: expected both accelerations, a and {second}, or neither")
        core = (4,) if "e" in turns else (3,)
        arrays = {name: finite_array(value, core, name) for name, value in turns.items() if value is not None}
        shape = (*_leading_shape(arrays), *core)
        orientation = [np.broadcast_to(array, shape) for array in arrays.values()]
        R, omega, alpha = convert(*orientation, *[np.zeros(shape)] * (3 - len(orientation)))
        motion = cls._unchecked(*(np.empty(0),) * 4)
        given |= {"omega": omega, "alpha": None if given["a"] is None else alpha}
        motion._store({"R": R} | _checked(given))
        return motion

    @classmethod
    def from_quaternion(
        cls,
        t: ArrayLike,
        e: ArrayLike,
        v: ArrayLike,
        e_dot: ArrayLike,
        a: ArrayLike | None = None,
        e_ddot: ArrayLike | None = None,
        F_ext: ArrayLike | None = None,
        M_ext: ArrayLike | None = None,
    ) -> Motion:
        """Create a motion from quaternions and their rates, without a singular orientation.

        Parameters
        ----------
        t : array_like, shape (..., 3)
            Position of the reference point in the base frame (m).
        e : array_like, shape (..., 4)
            Quaternions from the platform frame to the base frame, scalar first, of any length except zero.
        v, e_dot : array_like
            Velocity of the reference point (m/s), and time derivative of e (1/s).
        a, e_ddot : array_like, optional
            Their time derivatives; required if and only if the other one is given.
        F_ext, M_ext : array_like, shape (..., 3), optional
            Load, as in ``Motion``.

        Returns
        -------
        Motion
            Motion; without accelerations if a is not given.

        Raises
        ------
        ValueError
            If an argument is invalid, as in ``Motion``, or a quaternion has length zero.
        """
        turns = {"e": e, "e_dot": e_dot, "e_ddot": e_ddot}
        given = {"t": t, "v": v, "a": a, "F_ext": F_ext, "M_ext": M_ext}
        return cls._turned(rotation.motion_of_quaternion, turns, given)


at_rest = Motion.at_rest


def pose_of(value: object, name: str, expected: str) -> Motion:
    """Convert a pose (R, t) to a motion at rest without accelerations; errors begin with ``name``."""
    if not isinstance(value, tuple | list) or len(value) != 2:
        raise ValueError(f"{name}: expected {expected}, got {type(value).__name__}")
    R, t = value
    with errors_of(f"{name}: "):
        return Motion(R=R, t=t, omega=np.zeros(3), v=np.zeros(3))


def _checked(given: Mapping[str, object]) -> dict[str, Array]:
    """Check and copy the arrays of a motion; the optional ones may be None."""
    return {
        name: rotations(value, name) if name == "R" else finite_array(value, (3,), name)
        for name, value in given.items()
        if value is not None or name in ("R", "t", "omega", "v")
    }


def _leading_shape(arrays: dict[str, Array]) -> tuple[int, ...]:
    return leading_shape({name: x.shape[: -2 if name == "R" else -1] for name, x in arrays.items()})


def rotations(value: object, name: str, batch: bool = True) -> Array:
    """Check the rotation matrices of an argument, shape (..., 3, 3), and return them.

    Matrices of single precision are made orthonormal in double precision. Other matrices that are no
    rotations raise ValueError.
    """
    R = finite_array(value, (3, 3), name, batch)
    in_float = np.asarray(value).dtype == np.float32
    tolerance = FLOAT_TOLERANCE if in_float else ROTATION_TOLERANCE
    with np.errstate(over="ignore", invalid="ignore"):
        off = np.max(np.abs(np.swapaxes(R, -1, -2) @ R - np.eye(3)), axis=(-2, -1))
        bad = ~(off <= tolerance) | (np.linalg.det(R) < 0.0)
    if np.any(bad):
        where = tuple(np.argwhere(bad)[0].tolist())
        finding = f"{name}^T {name} differs from E by {off[where]:.2g}"
        if off[where] <= tolerance:
            finding = f"this one is a reflection (det {name} = -1)"
        elif off[where] <= FLOAT_TOLERANCE and np.array_equal(R[where], R[where].astype(np.float32)):
            finding += f": these are numbers of single precision, give {name} as an array of float32"
        place = f"[{', '.join(map(str, where))}]" if where else ""
        raise ValueError(f"{name}{place}: expected a rotation matrix, {finding}")
    # A Newton step squares the error; after two steps only rounding errors of a double remain.
    return rotation.orthonormal(rotation.orthonormal(R)) if in_float else R
