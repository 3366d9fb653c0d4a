"""Force laws: the actuator forces in a simulation as functions of time and state.

A law is any callable (time, state) -> F (N), shape (6,). The state is a Motion of shape () without
accelerations.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..backend.c_kernel import CKernel
from ..dynamics.forces import ForceKernel
from ..dynamics.inverse_dynamics import Backend, Formulation, inverse_dynamics, prepared_kernel
from ..io.arguments import instance, number_in, of_six, real_array
from ..io.array_types import Array
from ..io.frozen import Frozen
from ..kinematics.inverse_kinematics import inverse_kinematics, leg_vectors, tip_velocities
from ..motion.interpolation import with_rest
from ..motion.motion import Motion, at_rest
from ..motion.rotation import one_rotation_vector, vector_from_rotation
from ..motion.straight_line import StraightLinePath
from ..robot.offset_chains import SLIDING, joint_motion
from ..robot.robot import Robot

ForceLaw = Callable[[float, Motion], ArrayLike]
"""Function (time in s, state) -> actuator forces (N), shape (6,)."""
Reference = Callable[[Any], Motion]
"""Function time (s) -> reference motion of shape (); references of this package accept arrays of times."""
Model = Callable[[Motion], Array]
"""Function Motion of shape () -> actuator forces of the model (N), shape (6,)."""


@dataclass(frozen=True, eq=False)
class LegSprings(Frozen):
    """Legs as springs with dampers: F = -k (L - L_0) - d L_dot.

    Attributes
    ----------
    robot : Robot
        Robot model.
    stiffness : ndarray or float, shape (6,)
        Stiffness k (N/m), one number or six.
    rest_length : ndarray or float, shape (6,)
        Rest length L_0 (m), one number or six.
    damping : ndarray or float, shape (6,), optional
        Damping d (N s/m), one number or six.

    Raises
    ------
    ValueError
        If an argument is not finite or has another shape.
    """

    robot: Robot
    stiffness: Array | float
    rest_length: Array | float
    damping: Array | float = 0.0

    def __post_init__(self) -> None:
        """Check the arguments and broadcast them to six legs."""
        instance(self.robot, Robot, "robot")
        for name in ("stiffness", "rest_length", "damping"):
            self._set({name: of_six(getattr(self, name), name)})

    @classmethod
    def in_equilibrium(
        cls, robot: Robot, pose: Motion, stiffness: ArrayLike, damping: ArrayLike = 0.0
    ) -> LegSprings:
        """Create springs in equilibrium with the weight of the robot and the load of a pose.

        Parameters
        ----------
        robot : Robot
            Robot model.
        pose : Motion
            Pose and load, shape (); its velocities are ignored.
        stiffness : array_like
            Stiffness k (N/m), > 0, one number or six.
        damping : array_like, optional
            Damping d (N s/m), one number or six.

        Returns
        -------
        LegSprings
            Springs with rest lengths L + F / k: L are the leg lengths, F the actuator forces at rest in the
            pose.

        Raises
        ------
        ValueError
            If an argument is invalid, or if ``inverse_dynamics`` has no solution in the pose.
        """
        instance(robot, Robot, "robot")
        instance(pose, Motion, "pose")
        k = of_six(stiffness, "stiffness")
        if not (k > 0.0).all():
            text = "stiffness: expected numbers > 0, because the springs support the weight"
            raise ValueError(f"{text}, got {float(k[~(k > 0.0)][0]):g}")
        rest = at_rest(pose.R, pose.t, pose.F_ext, pose.M_ext)
        F = inverse_dynamics(robot, rest).F
        return cls(robot, k, inverse_kinematics(robot, rest).L + F / k, of_six(damping, "damping"))

    def __call__(self, time: float, state: Motion) -> Array:
        """Compute the forces (N), shape (..., 6), of any state."""
        if self.robot.offsets is None:
            q, S, L = leg_vectors(self.robot, state.R, state.t)
            L_dot = np.einsum("...i,...i->...", S, tip_velocities(state, q)) / L
        else:
            moving = joint_motion(self.robot, state)
            L, L_dot = moving.at.L[..., 0], moving.rates[..., SLIDING]
        return np.asarray(-self.stiffness * (L - self.rest_length) - self.damping * L_dot)

    def energy(self, L: ArrayLike) -> Array:
        """Compute the energy of all springs.

        Parameters
        ----------
        L : array_like, shape (..., 6)
            Leg lengths (m).

        Returns
        -------
        ndarray, shape (...)
            Energy (J).

        Raises
        ------
        ValueError
            If ``L`` has another shape.
        """
        lengths = real_array(L, "L", "lengths of shape (..., 6)")
        if lengths.shape[-1:] != (6,):
            raise ValueError(f"L: expected lengths of shape (..., 6), got {lengths.shape}")
        stretch = lengths - self.rest_length
        return np.asarray(np.sum(0.5 * self.stiffness * stretch**2, axis=-1))


@dataclass(frozen=True, eq=False)
class ModelTorque:
    """Tracking control of a reference motion by inverse dynamics of any model, with feedback of the errors.

        a     = a_w     + k_d (v_w - v)         + k_p (t_w - t)
        alpha = alpha_w + k_d (omega_w - omega) + k_p e

    The index w denotes the reference; e is the rotation vector of R_w R^T in the base frame. If model and
    load are exact, the position error satisfies x'' + k_d x' + k_p x = 0. For rotation this holds about a
    fixed axis.
    """

    model: Model
    reference: Reference
    k_p: float
    k_d: float

    def __post_init__(self) -> None:
        """Check the gains."""
        _gains(self.k_p, self.k_d)

    def __call__(self, time: float, state: Motion) -> Array:
        """Compute the forces (N), shape (6,), of a state."""
        reference = self.reference(time)
        if reference.a is None or reference.alpha is None:
            raise ValueError("reference: expected a motion with accelerations, got none")
        a, alpha = feedback(reference, state, self.k_p, self.k_d)
        a, alpha = reference.a + a, reference.alpha + alpha
        rates = state.omega, state.v, alpha, a
        return self.model(Motion._unchecked(state.R, state.t, *rates, reference.F_ext, reference.M_ext))


@dataclass(frozen=True, eq=False)
class ComputedTorque:
    """Computed-torque control: ``ModelTorque`` with the inverse dynamics of a robot as the model.

    Attributes
    ----------
    robot : Robot
        Robot model of the controller.
    reference : callable
        Function time (s) -> reference Motion with accelerations. Its external load is passed to the model.
    k_p : float
        Gain of position (1/s^2).
    k_d : float
        Gain of velocity (1/s).
    formulation : {"exact", "paper"}, optional
        Corrected equations or equations as printed.
    backend : {"c", "numpy", "reference"}, optional
        Implementation of the model. The forces are NaN in poses in which the model has no solution.
    """

    robot: Robot
    reference: Reference
    k_p: float
    k_d: float
    formulation: Formulation = "exact"
    backend: Backend = "c"
    _law: ModelTorque = field(init=False, repr=False)

    def __post_init__(self) -> None:
        """Check the gains and prepare the kernel of the model."""
        instance(self.robot, Robot, "robot")
        _gains(self.k_p, self.k_d)
        model = _model(self.robot, self.formulation, self.backend)
        law = ModelTorque(model, self.reference, self.k_p, self.k_d)
        object.__setattr__(self, "_law", law)

    def __reduce__(self) -> tuple[Any, ...]:
        """Copy and pickle the arguments only, because a kernel cannot be copied."""
        numbers = self.k_p, self.k_d, self.formulation, self.backend
        return ComputedTorque, (self.robot, self.reference, *numbers)

    def __call__(self, time: float, state: Motion) -> Array:
        """Compute the forces (N), shape (6,), of a state."""
        return self._law(time, state)


@dataclass(frozen=True, eq=False)
class GravityCompensation(Frozen):
    """PD control with gravity compensation: H F = g + M_0 u, without inertia forces and load.

    The feedback is u = [k_d (v_w - v) + k_p (t_w - t); k_d (omega_w - omega) + k_p e], with the symbols of
    ``ModelTorque``. M_0 is the constant ``inertia``, shape (6, 6), for twists [v; omega] in the base frame.
    """

    model: Model
    inertia: Array
    reference: Reference
    k_p: float
    k_d: float

    def __post_init__(self) -> None:
        """Check the gains and the inertia."""
        _gains(self.k_p, self.k_d)
        inertia = real_array(self.inertia, "inertia", "a matrix of shape (6, 6)")
        if inertia.shape != (6, 6):
            raise ValueError(f"inertia: expected a matrix of shape (6, 6), got {inertia.shape}")
        self._set({"inertia": inertia})

    def __call__(self, time: float, state: Motion) -> Array:
        """Compute the forces (N), shape (6,), of a state."""
        wrench = self.inertia @ np.concatenate(feedback(self.reference(time), state, self.k_p, self.k_d))
        # At rest the legs apply this wrench if the platform carries the opposite wrench as its load.
        load = -wrench.reshape(2, 3) @ state.R
        zero = np.zeros(3)
        return self.model(Motion._unchecked(state.R, state.t, zero, zero, zero, zero, load[0], load[1]))


def feedback(reference: Motion, state: Motion, k_p: float, k_d: float) -> tuple[Array, Array]:
    """Return the feedback accelerations (m/s^2 and rad/s^2) of a state, shape (..., 3) each."""
    vector = one_rotation_vector if state.R.ndim == reference.R.ndim == 2 else vector_from_rotation
    turn = vector(reference.R @ np.swapaxes(state.R, -1, -2))
    a = k_d * (reference.v - state.v) + k_p * (reference.t - state.t)
    return a, k_d * (reference.omega - state.omega) + k_p * turn


def _model(robot: Robot, formulation: Formulation, backend: Backend) -> Model:
    """Return the inverse dynamics of single poses: F (N), shape (6,), NaN in poses without a solution."""
    kernel = prepared_kernel(robot, formulation, backend)
    if not isinstance(kernel, CKernel):
        return lambda motion: np.asarray(kernel.run("inverse_dynamics", motion)["F"])
    pose = ForceKernel(robot, formulation).single_pose()

    def forces(motion: Motion) -> Array:
        pose.load(motion)
        return np.full(6, np.nan) if pose.solve() else pose.F.copy()

    return forces


def along(path: StraightLinePath) -> Reference:
    """Return a path as a reference motion that remains at rest at its end."""
    return with_rest(path.sample, path.tau_f)


def at_samples(reference: Reference, rate: float, duration: float) -> Reference:
    """Evaluate a reference motion, which accepts arrays of times, at all samples of a law (Hz, s)."""
    last = math.ceil(duration * rate)
    motion = reference(np.arange(last + 1) / rate)
    return lambda time: motion[min(round(time * rate), last)]


def _gains(k_p: float, k_d: float) -> None:
    """Check the two gains."""
    for name, value in (("k_p", k_p), ("k_d", k_d)):
        number_in(value, name, "a finite gain >= 0", closed=True)
