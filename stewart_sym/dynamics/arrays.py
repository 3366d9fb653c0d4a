"""Generated modules bound to a robot and an array library such as NumPy, JAX, or PyTorch.

Arguments and results are arrays of the library; ``jit``, ``vmap``, and ``grad`` work with every method.
"""

from dataclasses import dataclass, field
from importlib import import_module
from types import ModuleType
from typing import Any, NamedTuple, TypeVar

import numpy as np

from ..backend.kernel import MOTION, OFFSETS, force_kernel, module, overflows, stored
from ..generated.interface import OUTPUTS
from ..io.arguments import instance, leading_shape
from ..io.array_types import Array, Frozen
from ..motion.motion import Motion
from ..results import OK
from ..robot.offsets import need_no_offsets
from ..robot.robot import Robot, need_drive, need_masses, of_symbol
from .inverse_dynamics import Formulation
from .leg_formulas import Functions, LegMotion, leg_motions, motor_torques


class ArrayForces(NamedTuple):
    """Actuator forces F (N), shape (..., 6), (37), and status, shape (...)."""

    F: Any
    status: Any


class ArrayEquations(NamedTuple):
    """Terms of the equations of motion, and status, shape (...).

    M [a; alpha] + C [v; omega] + g + friction = H F + [R F_ext; R M_ext]. M, C, and H have the shape (..., 6,
    6). g, friction, bias = C [v; omega] + g, and bias_and_friction have the shape (..., 6) and are in N and N
    m, base frame.
    """

    M: Any
    C: Any
    g: Any
    friction: Any
    bias: Any
    bias_and_friction: Any
    H: Any
    status: Any


class ArrayAccelerations(NamedTuple):
    """Accelerations a (m/s^2) and alpha (rad/s^2), base frame, shape (..., 3), and status, shape (...)."""

    a: Any
    alpha: Any
    status: Any


class ArrayTorques(NamedTuple):
    """Motor torques (N m), shape (..., 6), and status, shape (...)."""

    torque: Any
    status: Any


Result = TypeVar("Result", ArrayForces, ArrayEquations, ArrayAccelerations)


@dataclass(frozen=True, eq=False)
class ArrayKernel(Frozen):
    """Robot prepared for one array library.

    Omitted arguments of the methods are zero, and leading shapes broadcast. The methods check shapes and
    require real numbers. They do not check that R is a rotation; ``Motion`` does. If a status, a code of
    ``results.STATUS_TEXT``, is not 0, the other results are NaN.

    Attributes
    ----------
    robot : Robot
        Robot model.
    xp : module
        Namespace of the array library, for example ``jax.numpy``.
    formulation : {"exact", "paper"}, optional
        "exact" for the corrected equations, "paper" for the equations as printed.
    dtype : object, optional
        Real number type of the library; by default ``xp.float64``.

    Examples
    --------
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> kernel = ss.ArrayKernel(ss.robots.load("unal"), xp=np)
    >>> kernel.forces(np.eye(3), t=[0.0, 0.0, 0.7]).F.round(2).tolist()
    [5.91, 5.91, 5.91, 5.91, 5.91, 5.91]
    """

    robot: Robot
    xp: Any
    formulation: Formulation = "exact"
    dtype: Any = None
    _source: ModuleType = field(init=False, repr=False)
    _on: Any = field(init=False, repr=False)
    _model: Any = field(init=False, repr=False)

    def __post_init__(self) -> None:
        instance(self.robot, Robot, "robot")
        geometry_alone = bool(self.robot.missing_bodies)
        name = "exact" if geometry_alone else force_kernel(self.robot, self.formulation)
        if not hasattr(self.xp, "asarray"):
            got = type(self.xp).__name__
            raise ValueError(f"xp: expected an array namespace such as numpy or jax.numpy, got {got}")
        source, on_numpy = module(f"{name}_arrays"), module("arithmetic").Arithmetic(np)
        try:
            on = module("arithmetic").Arithmetic(self.xp, self.dtype)
        except (ValueError, TypeError):
            on = None
        if on is None or "complex" in str(on.type):
            raise ValueError(f"dtype: expected a type of real numbers, got {self.dtype}")
        with np.errstate(all="ignore"):
            model = source.prepare(on_numpy, robot_structure(source.Robot(), self.robot))
        if model.status != OK and not geometry_alone:
            raise overflows("double")
        self._set({"_source": source, "_on": on, "_model": _converted(model, on), "dtype": on.type})

    def __reduce__(self) -> tuple[Any, ...]:
        """Copy and pickle by the name of the library, because modules cannot be pickled."""
        return _prepared, (self.robot, self.xp.__name__, self.formulation, self.dtype)

    def forces(
        self,
        R: Any,
        t: Any,
        omega: Any = None,
        v: Any = None,
        alpha: Any = None,
        a: Any = None,
        F_ext: Any = None,
        M_ext: Any = None,
    ) -> ArrayForces:
        """Compute the actuator forces that produce a motion of the platform, (37).

        Parameters
        ----------
        R : array_like, shape (..., 3, 3)
            Orientation, from the platform frame to the base frame.
        t : array_like, shape (..., 3)
            Position of the reference point (m), base frame.
        omega, v : array_like, shape (..., 3), optional
            Angular velocity (rad/s) and velocity of the reference point (m/s), base frame; by default 0.
        alpha, a : array_like, shape (..., 3), optional
            Angular acceleration (rad/s^2) and acceleration of the reference point (m/s^2), base frame; by
            default 0.
        F_ext, M_ext : array_like, shape (..., 3), optional
            External force (N) and moment (N m) at the reference point, platform frame; by default 0.

        Returns
        -------
        ArrayForces
            Named tuple: actuator forces ``F`` (N), shape (..., 6), and ``status``, shape (...).

        Raises
        ------
        ValueError
            If an argument is not real or has another shape; the message names the argument.
        """
        given = {"R": R, "t": t, "omega": omega, "v": v, "alpha": alpha, "a": a}
        return self._run("forces", ArrayForces, given | {"F_ext": F_ext, "M_ext": M_ext})

    def equations(self, R: Any, t: Any, omega: Any = None, v: Any = None) -> ArrayEquations:
        """Compute the terms of the equations of motion: M, C, g, friction, bias, bias_and_friction, and H.

        Parameters
        ----------
        R, t, omega, v : array_like
            Pose and velocities, as in ``forces``.

        Returns
        -------
        ArrayEquations
            Named tuple of the terms and ``status``, shape (...).

        Raises
        ------
        ValueError
            If an argument is not real or has another shape, the formulation is not "exact", or the base
            joints are not universal joints without offsets.
        """
        return self._run("equations", ArrayEquations, {"R": R, "t": t, "omega": omega, "v": v})

    def forward_dynamics(
        self,
        R: Any,
        t: Any,
        omega: Any = None,
        v: Any = None,
        F: Any = None,
        F_ext: Any = None,
        M_ext: Any = None,
    ) -> ArrayAccelerations:
        """Compute the accelerations of the platform under actuator forces.

        Parameters
        ----------
        R, t, omega, v : array_like
            Pose and velocities, as in ``forces``.
        F : array_like, shape (..., 6), optional
            Actuator forces (N), positive when they extend the leg; by default 0.
        F_ext, M_ext : array_like, optional
            External force and moment, as in ``forces``.

        Returns
        -------
        ArrayAccelerations
            Named tuple: ``a`` (m/s^2) and ``alpha`` (rad/s^2), base frame, shape (..., 3), and ``status``,
            shape (...).

        Raises
        ------
        ValueError
            If an argument is not real or has another shape, the formulation is not "exact", or the base
            joints are not universal joints without offsets.
        """
        given = {"R": R, "t": t, "omega": omega, "v": v, "F_ext": F_ext, "M_ext": M_ext}
        given["F"] = np.zeros(6) if F is None else F
        return self._run("forward_dynamics", ArrayAccelerations, given)

    def lengths(self, R: Any, t: Any) -> Any:
        """Compute the leg lengths, (2).

        Parameters
        ----------
        R, t : array_like
            Pose, as in ``forces``.

        Returns
        -------
        array, shape (..., 6)
            Leg lengths (m).

        Raises
        ------
        ValueError
            If an argument is not real or has another shape, or if the robot has joint offsets.
        """
        motion, _, shape = self._motion({"R": R, "t": t})
        return stacked(self.xp, [leg.L for leg in self._legs(motion)], shape)

    def rates(self, R: Any, t: Any, omega: Any = None, v: Any = None) -> Any:
        """Compute the leg rates, (5).

        Parameters
        ----------
        R, t, omega, v : array_like
            Pose and velocities, as in ``forces``.

        Returns
        -------
        array, shape (..., 6)
            Leg rates (m/s), positive when the leg extends.

        Raises
        ------
        ValueError
            If an argument is not real or has another shape, or if the robot has joint offsets.
        """
        motion, _, shape = self._motion({"R": R, "t": t, "omega": omega, "v": v})
        return stacked(self.xp, [leg.L_dot for leg in self._legs(motion)], shape)

    def torques(
        self,
        R: Any,
        t: Any,
        omega: Any = None,
        v: Any = None,
        alpha: Any = None,
        a: Any = None,
        F_ext: Any = None,
        M_ext: Any = None,
    ) -> ArrayTorques:
        """Compute the motor torques that produce a motion of the platform, including the drive's losses.

        Parameters
        ----------
        R, t, omega, v, alpha, a, F_ext, M_ext : array_like
            Motion and load, as in ``forces``.

        Returns
        -------
        ArrayTorques
            Named tuple: motor torques ``torque`` (N m), shape (..., 6), and ``status``, shape (...).

        Raises
        ------
        ValueError
            If an argument is not real or has another shape, or if the robot has joint offsets or no drive.
        """
        need_drive(self.robot)
        given = {"R": R, "t": t, "omega": omega, "v": v, "alpha": alpha, "a": a}
        need_no_offsets(self.robot)
        motion, _, _ = self._motion(given)
        F, status = self.forces(**given, F_ext=F_ext, M_ext=M_ext)
        forces = [F[..., i] for i in range(6)]
        torque = motor_torques(self._functions, self.robot, motion, forces)
        return ArrayTorques(stacked(self.xp, torque, tuple(F.shape[:-1])), status)

    @property
    def _functions(self) -> Functions:
        return Functions(self._on.sqrt, self._on.size, self.xp.exp, self._on.where)

    def _motion(self, fields: dict[str, Any]) -> tuple[Any, list[Any], tuple[int, ...]]:
        """Return a motion of the generated module, forces if given, and the leading shape."""
        given = {name: self._array(name, value) for name, value in fields.items() if value is not None}
        shapes = {name: tuple(each.shape[: -len(_shape_of(name))]) for name, each in given.items()}
        F = [given.pop("F")] if "F" in given else []
        return self._source.motion_of(self._on, **given), F, leading_shape(shapes)

    def _legs(self, motion: Any) -> list[LegMotion]:
        need_no_offsets(self.robot)
        return leg_motions(self._functions, self.robot, motion)

    def _run(self, function: str, kind: type[Result], fields: dict[str, Any]) -> Result:
        need_masses(self.robot)
        found, shape = self._evaluated(function, fields)
        return kind(*(stacked(self.xp, getattr(found, name), shape) for name in kind._fields))

    def _evaluated(self, function: str, fields: dict[str, Any]) -> tuple[Any, tuple[int, ...]]:
        """Return the results of a function of the generated module, and their leading shape."""
        if not hasattr(self._source, function):
            raise ValueError(
                f'{function}: expected formulation "exact" and universal base joints without offsets, '
                f'got "{self.formulation}" and {self.robot.base_joint} ones'
                f"{'' if self.robot.offsets is None else ' with offsets'}"
            )
        motion, forces, shape = self._motion(fields)
        more = [[F[..., i] for i in range(6)] for F in forces]
        with np.errstate(all="ignore"):
            found = getattr(self._source, function)(self._on, self._model, motion, *more)
        return found, shape

    def _array(self, name: str, value: Any) -> Any:
        """Convert an argument to an array of real numbers of the library, and check its shape."""
        try:
            given = getattr(value, "dtype", None) or np.asarray(value).dtype
            kind = str(getattr(given, "name", given)).rpartition(".")[2]
        except ValueError as error:
            raise ValueError(f"{name}: expected real numbers, {error}") from None
        if not kind.startswith(("float", "bfloat", "int", "uint", "bool")):
            raise ValueError(f"{name}: expected real numbers, got {kind}")
        array, shape = self.xp.asarray(value, dtype=self.dtype), _shape_of(name)
        if tuple(array.shape[-len(shape) :]) != shape:
            expected = ", ".join(map(str, shape))
            raise ValueError(f"{name}: expected shape (..., {expected}), got {tuple(array.shape)}")
        return array


class NumpyClosedForm(ArrayKernel):
    """NumPy kernels of the closed form, called like ``CKernel``; the bits of C without fused multiply-add."""

    def run(self, output: str, motion: Motion, *given: Array) -> dict[str, Any]:
        """Return the results by name of an output of the closed form, as ``CKernel.run``."""
        fields = {name: getattr(motion, name) for name in MOTION} | dict(zip("F", given, strict=False))
        result, shape = self._evaluated(output, fields)
        found = {name: stacked(np, value, shape) for name, value in vars(result).items()}
        if "alpha" in found:
            found["acceleration"] = np.concatenate([found.pop("a"), found.pop("alpha")], axis=-1)
        return {name: found[name] for name in OUTPUTS[output]} | {"status": found["status"].astype(np.int32)}


def _shape_of(name: str) -> tuple[int, ...]:
    """Return the shape of an argument at one pose."""
    return {"R": (3, 3), "F": (6,)}.get(name, (3,))


def _prepared(robot: Robot, library: str, formulation: Formulation, dtype: Any) -> ArrayKernel:
    return ArrayKernel(robot, import_module(library), formulation, dtype)


def robot_structure(made: Any, robot: Any) -> Any:
    """Fill a structure of a generated module with the numbers of a robot; symmetric tensors have six."""
    for i, leg in enumerate(made.leg):
        if not hasattr(leg, OFFSETS[0]):
            need_no_offsets(robot)
        for name in vars(leg):
            owner = robot.offsets if name in OFFSETS else robot
            setattr(leg, name, _components(of_symbol(owner, name)[i]))
    for name in vars(made).keys() - {"leg"}:
        setattr(made, name, _components(of_symbol(robot, name)))
    return made


def _components(value: Any) -> Any:
    """Convert a quantity with at most one index to its stored form, a number or a list."""
    components = stored(np.asarray(value))
    return list(components) if components.shape else components[()]


def _converted(value: Any, on: Any) -> Any:
    """Convert the numbers of a model to arrays of another library."""
    if isinstance(value, list):
        return [_converted(each, on) for each in value]
    if hasattr(value, "__dict__"):
        made = type(value)()
        for name, each in vars(value).items():
            setattr(made, name, int(each) if name == "status" else _converted(each, on))
        return made
    return on.real(float(value))


def stacked(xp: Any, value: Any, shape: tuple[int, ...]) -> Any:
    """Stack lists of arrays, one per component, into one array (*shape, ...)."""
    dims: tuple[int, ...] = ()
    parts = [value]
    while isinstance(parts[0], list):
        dims = (*dims, len(parts[0]))
        parts = [each for row in parts for each in row]
    parts = [xp.broadcast_to(xp.asarray(each), shape) for each in parts]
    return xp.reshape(xp.stack(parts, axis=-1), (*shape, *dims)) if dims else parts[0]
