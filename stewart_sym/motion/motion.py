"""Motion of the platform at one or many samples: pose, velocities, accelerations and external load."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..io.arguments import finite_array, leading_shape
from ..io.array_types import Array
from ..io.error_policy import errors_of
from ..io.frozen import Frozen, read_only
from . import rotation

ROTATION_TOLERANCE = 1e-9
FLOAT_TOLERANCE = 16.0 * float(np.finfo(np.float32).eps)
"""Of R given as float32: its own rounding and that of the few operations that made it."""


@dataclass(frozen=True, eq=False, kw_only=True)
class Motion(Frozen):
    """Motion of the platform's reference point and frame; SI units, base frame unless said otherwise.

    Leading shapes broadcast, as in NumPy, to one ``shape``; every array is a read-only private copy of that
    shape. ``motion[index]`` slices it.

    R given as float32 is a rotation only to float32's rounding (R^T R = E to 2e-6): it is made orthonormal in
    double, by the nearest rotation, and stored so.

    Attributes
    ----------
    R : ndarray
        Orientation, platform to base, (..., 3, 3).
    t : ndarray
        Position of the reference point, m, (..., 3).
    omega, v : ndarray
        Angular velocity, rad/s, and velocity of the reference point, m/s, (..., 3).
    alpha, a : ndarray, optional
        Angular acceleration, rad/s^2, and acceleration of the reference point, m/s^2, (..., 3); both None
        when the motion has no accelerations, as for forward dynamics.
    F_ext, M_ext : ndarray, optional
        External force, N, and moment, N m, at the reference point, in the platform frame, (..., 3); None for
        no load.

    Raises
    ------
    ValueError
        Naming the argument: shapes that do not fit, entries that are no finite numbers, R that is no rotation
        (R^T R = E to 1e-9 and det R > 0), one of alpha and a without the other.
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
        arrays: dict[str, Array] = {}
        for field in fields(self):
            value = getattr(self, field.name)
            if value is not None or field.name in ("R", "t", "omega", "v"):
                name = field.name
                arrays[name] = rotations(value, name) if name == "R" else finite_array(value, (3,), name)
        self._spread(arrays)

    def _spread(self, arrays: dict[str, Array]) -> None:
        """Set checked arrays, which nobody else holds, broadcast to one leading shape."""
        order = [field.name for field in fields(self) if field.name in arrays]
        shape = _leading_shape({name: arrays[name] for name in order})
        for name in order:
            core = arrays[name].shape[-2:] if name == "R" else arrays[name].shape[-1:]
            object.__setattr__(self, name, np.broadcast_to(read_only(arrays[name]), (*shape, *core)))

    @classmethod
    def _sound(cls, arrays: dict[str, Array]) -> Motion:
        """Make a motion of arrays already known to be finite, R a rotation, which nobody else holds."""
        motion = cls._unchecked(*(np.empty(0),) * 4)
        motion._spread(arrays)
        return motion

    @property
    def shape(self) -> tuple[int, ...]:
        """The leading shape, () for one sample."""
        return self.t.shape[:-1]

    def __getitem__(self, index: Any) -> Motion:
        """Slice the leading shape, as a NumPy array of ``shape`` would be sliced."""
        index = index if isinstance(index, tuple) else (index,)
        # The vectors' own axes are spelled out, so that no index can reach them.
        rest = () if any(item is Ellipsis for item in index) else (Ellipsis,)
        picked: dict[str, Any] = {}
        for field in fields(self):
            value = getattr(self, field.name)
            own = (slice(None),) * (2 if field.name == "R" else 1)
            picked[field.name] = None if value is None else value[(*index, *rest, *own)]
        return Motion._unchecked(**picked)

    def external_wrench(self) -> Array:
        """External load in base axes, [R F_ext; R M_ext].

        Returns
        -------
        ndarray
            Force, N, and moment about the reference point, N m, (..., 6); 0 without a load.
        """
        load = [np.zeros(3) if vector is None else vector for vector in (self.F_ext, self.M_ext)]
        turned = [np.einsum("...ij,...j->...i", self.R, vector) for vector in load]
        return np.concatenate(turned, axis=-1)

    def in_rotated_frames(self, Q: ArrayLike) -> Motion:
        """Return the motion in base and platform frames turned by a rotation: x becomes Q x.

        Parameters
        ----------
        Q : array_like
            The rotation, (3, 3).

        Returns
        -------
        Motion
            Of the same shape.

        Raises
        ------
        ValueError
            For what is no rotation, a reflection among them: angular velocities would change their sign.
        """
        Q = rotations(Q, "Q", batch=False)
        vectors = {
            field.name: value @ Q.T
            for field in fields(self)
            if field.name != "R" and (value := getattr(self, field.name)) is not None
        }
        return Motion(R=Q @ self.R @ Q.T, **vectors)

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
        return Motion._sound(moved)

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
        """Make a motion of arrays already known to be sound and of one leading shape; nothing is copied.

        For inner loops, where the checks would cost more than the dynamics.

        Parameters
        ----------
        R, t, omega, v : ndarray
            As in ``Motion``.
        alpha, a, F_ext, M_ext : ndarray, optional
            As in ``Motion``.

        Returns
        -------
        Motion
            Its arrays are those given.
        """
        motion = object.__new__(cls)
        motion.__dict__.update(R=R, t=t, omega=omega, v=v, alpha=alpha, a=a, F_ext=F_ext, M_ext=M_ext)
        return motion

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
        """Make a motion from roll-pitch-yaw angles, (38), and their rates.

        Parameters
        ----------
        t : array_like
            Position of the reference point, m, base frame, (..., 3).
        theta : array_like
            Angles (theta_x, theta_y, theta_z), rad, (..., 3).
        v : array_like
            Velocity of the reference point, m/s, base frame, (..., 3).
        theta_dot : array_like
            Rates of the angles, rad/s, (..., 3).
        a : array_like, optional
            Acceleration of the reference point, m/s^2, base frame, (..., 3).
        theta_ddot : array_like, optional
            Second rates of the angles, rad/s^2, (..., 3); given together with a or not at all.
        F_ext, M_ext : array_like, optional
            As in ``Motion``.

        Returns
        -------
        Motion
            Without accelerations where a is not given.

        Raises
        ------
        ValueError
            Naming the argument, as ``Motion``.
        """
        turns = _turns((3,), {"theta": theta, "theta_dot": theta_dot, "theta_ddot": theta_ddot}, a)
        *shape, _ = np.broadcast_shapes(*(array.shape for array in turns))
        theta, theta_dot, *second = (np.broadcast_to(array, (*shape, 3)) for array in turns)
        R, omega, alpha = rotation.rpy_motion(theta, theta_dot, second[0] if second else None)
        return cls._turned(R, omega, alpha, {"t": t, "v": v, "a": a, "F_ext": F_ext, "M_ext": M_ext})

    @classmethod
    def _turned(
        cls, R: Array, omega: Array, alpha: Array | None, given: dict[str, ArrayLike | None]
    ) -> Motion:
        checked = {
            name: finite_array(value, (3,), name)
            for name, value in given.items()
            if value is not None or name in ("t", "v")
        }
        turned = {"R": R, "omega": omega} | ({} if alpha is None else {"alpha": alpha})
        for name, array in turned.items():
            if not np.isfinite(array).all():
                finite_array(array, (3, 3) if name == "R" else (3,), name)
        return cls._sound(turned | checked)

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
        """Make a motion from quaternions, platform to base, and their rates: no orientation is special.

        Parameters
        ----------
        t : array_like
            As for ``from_rpy``.
        e : array_like
            Quaternions, scalar first, (..., 4), of any length but zero.
        v : array_like
            As for ``from_rpy``.
        e_dot : array_like
            Rates of e, 1/s, (..., 4).
        a : array_like, optional
            As for ``from_rpy``.
        e_ddot : array_like, optional
            Second rates of e, 1/s^2, (..., 4); given together with a or not at all.
        F_ext, M_ext : array_like, optional
            As in ``Motion``.

        Returns
        -------
        Motion
            Without accelerations where a is not given.

        Raises
        ------
        ValueError
            As ``Motion``, and for a quaternion of length zero.
        """
        turns = _turns((4,), {"e": e, "e_dot": e_dot, "e_ddot": e_ddot}, a)
        alpha = None if a is None else rotation.angular_acceleration_from_quaternion(*turns)
        omega = rotation.angular_velocity_from_quaternion(*turns[:2])
        R = rotation.rotation_from_quaternion(turns[0])
        return cls._turned(R, omega, alpha, {"t": t, "v": v, "a": a, "F_ext": F_ext, "M_ext": M_ext})

    @classmethod
    def from_rotation_vector(
        cls,
        t: ArrayLike,
        phi: ArrayLike,
        v: ArrayLike,
        phi_dot: ArrayLike,
        a: ArrayLike | None = None,
        phi_ddot: ArrayLike | None = None,
        F_ext: ArrayLike | None = None,
        M_ext: ArrayLike | None = None,
    ) -> Motion:
        """Make a motion from rotation vectors, R = exp([phi]x), and their rates.

        Parameters
        ----------
        t : array_like
            As for ``from_rpy``.
        phi : array_like
            Rotation vectors, rad, (..., 3): turns about phi by its magnitude; phi may be zero.
        v : array_like
            As for ``from_rpy``.
        phi_dot : array_like
            Rates of phi, rad/s, (..., 3).
        a : array_like, optional
            As for ``from_rpy``.
        phi_ddot : array_like, optional
            Second rates of phi, rad/s^2, (..., 3); given together with a or not at all.
        F_ext, M_ext : array_like, optional
            As in ``Motion``.

        Returns
        -------
        Motion
            Without accelerations where a is not given.

        Raises
        ------
        ValueError
            As ``Motion``.
        """
        turns = _turns((3,), {"phi": phi, "phi_dot": phi_dot, "phi_ddot": phi_ddot}, a)
        second = np.zeros(3) if a is None else turns[2]
        omega, alpha = rotation.angular_motion_from_vector(turns[0], turns[1], second)
        R = rotation.rotation_from_vector(turns[0])
        second_rate = None if a is None else alpha
        given: dict[str, Any] = {"t": t, "v": v, "a": a, "F_ext": F_ext, "M_ext": M_ext}
        return cls(R=R, omega=omega, alpha=second_rate, **given)


def at_rest(
    R: ArrayLike, t: ArrayLike, F_ext: ArrayLike | None = None, M_ext: ArrayLike | None = None
) -> Motion:
    """Poses at rest, under a load: all rates and accelerations are 0."""
    zero = np.zeros(3)
    return Motion(R=R, t=t, omega=zero, v=zero, alpha=zero, a=zero, F_ext=F_ext, M_ext=M_ext)  # type: ignore[arg-type]


def pose_of(value: object, name: str, expected: str) -> Motion:
    """A pose (R, t) as a motion at rest without accelerations; ValueError that begins with the name."""
    if not isinstance(value, tuple | list) or len(value) != 2:
        raise ValueError(f"{name}: expected {expected}, got {type(value).__name__}")
    R, t = value
    with errors_of(f"{name}: "):
        return Motion(R=R, t=t, omega=np.zeros(3), v=np.zeros(3))


def _turns(core: tuple[int, ...], given: dict[str, ArrayLike | None], a: ArrayLike | None) -> list[Array]:
    """An orientation and its rates, checked; the second rate only along with a."""
    second = list(given)[-1]
    if (a is None) != (given[second] is None):
        missing = "a" if a is None else second
        raise ValueError(f"{missing}: expected both accelerations, a and {second}, or neither")
    checked = {name: finite_array(value, core, name) for name, value in given.items() if value is not None}
    _leading_shape(checked)
    return list(checked.values())


def _leading_shape(arrays: dict[str, Array]) -> tuple[int, ...]:
    return leading_shape({name: x.shape[: -2 if name == "R" else -1] for name, x in arrays.items()})


def rotations(value: ArrayLike, name: str, batch: bool = True) -> Array:
    """Return rotations, (3, 3) or of a leading shape, from what a caller gave under a name.

    Those of single precision are made orthonormal in double. Raises ValueError for what is no rotation.
    """
    R = finite_array(value, (3, 3), name, batch)
    in_float = np.asarray(value).dtype == np.float32
    _check_rotation(R, FLOAT_TOLERANCE if in_float else ROTATION_TOLERANCE, name)
    # Newton's step squares what is off: twice, and only rounding of a double is left.
    return rotation.orthonormal(rotation.orthonormal(R)) if in_float else R


def _check_rotation(R: Array, tolerance: float, name: str) -> None:
    if R.size == 0:
        return
    with np.errstate(over="ignore", invalid="ignore"):
        off = np.max(np.abs(np.swapaxes(R, -1, -2) @ R - np.eye(3)), axis=(-2, -1))
        bad = ~(off <= tolerance)
    if np.any(bad):
        where = tuple(int(i) for i in np.argwhere(bad)[0])
        cause = ""
        if off[where] <= FLOAT_TOLERANCE and np.array_equal(R[where], R[where].astype(np.float32)):
            cause = f": these are numbers of single precision, give {name} as an array of float32"
        raise ValueError(
            f"{name}{_at(where)}: expected a rotation matrix, {name}^T {name} differs from E by "
            f"{off[where]:.2g}{cause}"
        )
    mirrored = np.linalg.det(R) < 0.0
    if np.any(mirrored):
        where = tuple(int(i) for i in np.argwhere(mirrored)[0])
        raise ValueError(
            f"{name}{_at(where)}: expected a rotation matrix, this one is a reflection (det {name} = -1)"
        )


def _at(where: tuple[int, ...]) -> str:
    return f"[{', '.join(str(i) for i in where)}]" if where else ""
