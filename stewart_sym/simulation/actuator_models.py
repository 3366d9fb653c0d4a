"""Force laws of the legs: what the actuators do in a simulation, as functions of time and state.

A law is any callable (time, state) -> F, N, (6,), where state is a Motion of shape () without
accelerations.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..dynamics.inverse_dynamics import Backend, Formulation, inverse_dynamics, prepared_kernel
from ..io.arguments import instance, number_in, real_array, shown
from ..io.array_types import Array
from ..io.frozen import Frozen
from ..kinematics.inverse_kinematics import inverse_kinematics, leg_vectors, tip_velocities
from ..motion.motion import Motion, at_rest
from ..motion.rotation import vector_from_rotation
from ..motion.straight_line import StraightLinePath
from ..robot.offset_chains import SLIDING, joint_motion
from ..robot.robot import Robot

ForceLaw = Callable[[float, Motion], ArrayLike]
"""(time, s, state) -> actuator forces, N, (6,)."""
Wanted = Callable[[float], Motion]
"""time, s -> the motion wanted then, of shape ()."""
Model = Callable[[Motion], Array]
"""Motion of shape () -> actuator forces that a model gives it, N, (6,)."""


@dataclass(frozen=True, eq=False)
class LegSprings(Frozen):
    """Legs as springs with dampers: F = -k (L - L0) - d L_dot.

    stiffness k, N/m, rest_length L0, m, and damping d, N s/m: one number or six.

    Attributes
    ----------
    robot : Robot
        The machine.
    stiffness : ndarray or float
        N/m, one or (6,).
    rest_length : ndarray or float
        m, one or (6,).
    damping : ndarray or float, optional
        N s/m, one or (6,).

    Raises
    ------
    ValueError
        Naming the argument that is not finite or of another shape.
    """

    robot: Robot
    stiffness: Array | float
    rest_length: Array | float
    damping: Array | float = 0.0

    def __post_init__(self) -> None:
        """Check and spread over six legs."""
        instance(self.robot, Robot, "robot")
        for name in ("stiffness", "rest_length", "damping"):
            self._set({name: of_six(getattr(self, name), name)})

    @classmethod
    def in_equilibrium(
        cls, robot: Robot, pose: Motion, stiffness: ArrayLike, damping: ArrayLike = 0.0
    ) -> LegSprings:
        """Springs that hold the machine at rest in a pose, against its weight and the pose's load.

        Parameters
        ----------
        robot : Robot
            The machine.
        pose : Motion
            Pose and load, of shape (); rates don't count.
        stiffness : array_like
            N/m, > 0, one or (6,).
        damping : array_like, optional
            N s/m, one or (6,).

        Returns
        -------
        LegSprings
            With rest lengths L + F / k, L and F those of the machine at rest in the pose.

        Raises
        ------
        ValueError
            Naming the argument; as ``inverse_dynamics`` where the pose is unsolvable.
        """
        instance(robot, Robot, "robot")
        instance(pose, Motion, "pose")
        k = of_six(stiffness, "stiffness")
        if not (k > 0.0).all():
            text = "stiffness: expected numbers > 0, since springs are to hold the weight"
            raise ValueError(f"{text}, got {float(k[~(k > 0.0)][0]):g}")
        rest = at_rest(pose.R, pose.t, pose.F_ext, pose.M_ext)
        F = inverse_dynamics(robot, rest).F
        return cls(robot, k, inverse_kinematics(robot, rest).L + F / k, of_six(damping, "damping"))

    def __call__(self, time: float, state: Motion) -> Array:
        """Forces, N, (..., 6), of any state."""
        if self.robot.offsets is None:
            q, S, L = leg_vectors(self.robot, state.R, state.t)
            L_dot = np.einsum("...i,...i->...", S, tip_velocities(state, q)) / L
        else:
            moving = joint_motion(self.robot, state)
            L, L_dot = moving.at.L[..., 0], moving.rates[..., SLIDING]
        return np.asarray(-self.stiffness * (L - self.rest_length) - self.damping * L_dot)

    def energy(self, L: ArrayLike) -> Array:
        """Energy in all springs.

        Parameters
        ----------
        L : array_like
            Leg lengths, m, (..., 6).

        Returns
        -------
        ndarray
            J, (...).

        Raises
        ------
        ValueError
            For lengths of another shape.
        """
        lengths = real_array(L, "L", "lengths of shape (..., 6)")
        if lengths.shape[-1:] != (6,):
            raise ValueError(f"L: expected lengths of shape (..., 6), got {lengths.shape}")
        stretch = lengths - self.rest_length
        return np.asarray(np.sum(0.5 * self.stiffness * stretch**2, axis=-1))


@dataclass(frozen=True, eq=False)
class ModelTorque:
    """Follow a wanted motion by any model of the machine, with errors fed back into the accelerations.

        a     = a_w     + k_d (v_w - v)         + k_p (t_w - t)
        alpha = alpha_w + k_d (omega_w - omega) + k_p e

    with e the rotation vector, base axes, of R_w R^T. On a machine that is as the model says, each error
    decays as x'' + k_d x' + k_p x = 0.

    model: Motion of shape () with accelerations -> F, N, (6,). wanted: time, s -> Motion with accelerations;
    the model bears its load.

    Raises ValueError naming the gain that is not finite or negative.
    """

    model: Model
    wanted: Wanted
    k_p: float
    k_d: float

    def __post_init__(self) -> None:
        """Check the gains."""
        _gains(self.k_p, self.k_d)

    def __call__(self, time: float, state: Motion) -> Array:
        """Forces, N, (6,), of a state."""
        wanted = self.wanted(time)
        if wanted.a is None or wanted.alpha is None:
            raise ValueError("reference: expected a motion with accelerations, got none")
        a, alpha = feedback(wanted, state, self.k_p, self.k_d)
        a, alpha = wanted.a + a, wanted.alpha + alpha
        rates = state.omega, state.v, alpha, a
        return self.model(Motion._unchecked(state.R, state.t, *rates, wanted.F_ext, wanted.M_ext))


@dataclass(frozen=True, eq=False)
class ComputedTorque:
    """Follow a wanted motion by inverse dynamics of the state: ``ModelTorque`` with a robot as the model.

    Attributes
    ----------
    robot : Robot
        The model.
    reference : Wanted
        Time, s -> Motion with accelerations, whose load the model bears.
    k_p : float
        Gain of position, 1/s^2.
    k_d : float
        Gain of velocity, 1/s.
    formulation, backend : {"exact", "paper"} or {"c", "numpy", "reference"}, optional
        Of the model. Poses where the model is unsolvable get NaN forces.
    """

    robot: Robot
    reference: Wanted
    k_p: float
    k_d: float
    formulation: Formulation = "exact"
    backend: Backend = "c"
    _law: ModelTorque = field(init=False, repr=False)

    def __post_init__(self) -> None:
        """Check the gains and prepare the model."""
        instance(self.robot, Robot, "robot")
        _gains(self.k_p, self.k_d)
        kernel = prepared_kernel(self.robot, self.formulation, self.backend)
        law = ModelTorque(lambda motion: kernel.forces(motion).F, self.reference, self.k_p, self.k_d)
        object.__setattr__(self, "_law", law)

    def __reduce__(self) -> tuple[Any, ...]:
        """Copies and pickles prepare a model of their own."""
        numbers = self.k_p, self.k_d, self.formulation, self.backend
        return ComputedTorque, (self.robot, self.reference, *numbers)

    def __call__(self, time: float, state: Motion) -> Array:
        """Forces, N, (6,), of a state."""
        return self._law(time, state)


@dataclass(frozen=True, eq=False)
class GravityCompensation(Frozen):
    """Hold the machine's weight and push toward a wanted motion: H F = g + M_0 [k_p e + k_d e'].

    Errors as in ``ModelTorque``; no inertia is computed, and the wanted accelerations don't count.

    model: inverse dynamics, Motion of shape () with accelerations and load -> F, N, (6,), evaluated at rest.
    inertia: M_0 of twists [v; omega], base frame, (6, 6), constant; it turns the gains of ``ModelTorque``,
    k_p, 1/s^2, and k_d, 1/s, into stiffness and damping.

    Raises ValueError naming the gain that is not finite or negative, or the inertia of another shape.
    """

    model: Model
    inertia: Array
    wanted: Wanted
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
        """Forces, N, (6,), of a state."""
        wrench = self.inertia @ np.concatenate(feedback(self.wanted(time), state, self.k_p, self.k_d))
        # The wrench commanded is what the legs would hold if its opposite lay on the platform.
        load = -wrench.reshape(2, 3) @ state.R
        zero = np.zeros(3)
        return self.model(Motion._unchecked(state.R, state.t, zero, zero, zero, zero, load[0], load[1]))


def feedback(wanted: Motion, state: Motion, k_p: float, k_d: float) -> tuple[Array, Array]:
    """Accelerations, m/s^2 and rad/s^2, each (..., 3), that take the state's errors away."""
    turn = vector_from_rotation(wanted.R @ np.swapaxes(state.R, -1, -2))
    a = k_d * (wanted.v - state.v) + k_p * (wanted.t - state.t)
    return a, k_d * (wanted.omega - state.omega) + k_p * turn


def along(path: StraightLinePath) -> Wanted:
    """A path as a wanted motion: at rest at its end afterwards."""

    def wanted(time: float) -> Motion:
        motion = path.sample(min(time, path.tau_f))
        return motion if time < path.tau_f else at_rest(motion.R, motion.t)

    return wanted


def _gains(k_p: float, k_d: float) -> None:
    for name, value in (("k_p", k_p), ("k_d", k_d)):
        number_in(value, name, "a finite gain >= 0", closed=True)


def of_six(value: ArrayLike, name: str) -> Array:
    """One finite number for each of six legs, from one or six; ValueError naming the argument otherwise."""
    expected = "one finite number or six"
    values = real_array(value, name, expected)
    if values.shape not in ((), (6,)) or not np.isfinite(values).all():
        raise ValueError(f"{name}: expected {expected}, got {shown(value)}")
    return np.broadcast_to(values, (6,))
