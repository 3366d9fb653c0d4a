"""What the functions of a kit compute, read in ``Running`` numbers from what their C was printed from.

The forces from derived blocks; inverse dynamics, reactions and the closed form from the generated NumPy
modules, which run on arrays of objects; kinematics from (1)-(5). Every reading takes the robot and the motion
of one pose as stored and hands out what the C writes, flat, in the order of its struct. Knows no file.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..closed_form import robot_structure
from ..derive.generate import reduced_rotation
from ..derive.regroup import ForceKernel
from ..kernel import MOTION, kernel_name, module
from ..studies.truth import ForceTerms, digits
from .parts import plain_kernel
from .running import (
    HALF_UNIT,
    Objects,
    Running,
    array,
    errors,
    inverse_sizes,
    running,
    sizes,
    solve,
    solve_definite,
)

Array = NDArray[np.float64]
Numbers = Mapping[str, Array]
Found = dict[str, Objects]

LEG_FIELDS = ("b", "p", "k", "m_d", "r_d0", "I_d0", "m_u", "r_u0", "I_u0", "C_u", "C_p", "C_s")
PLATFORM_FIELDS = ("M", "R_0", "I_p", "g")

# What the blocks of the modules on arrays take from an arithmetic.
_ON = SimpleNamespace(sqrt=Running.sqrt)
# Rotations and axes are of length one only to rounding; other forms of the equations use that they are.
_ORTHONORMAL = ("R", "k")
NEAR_POLE = 1 / 32
"""Sine of the angle between a leg and its fixed axis below which a third axis takes the place of that one."""

# Leg lengths agree once they are within this many rounding units of the largest term of S = q + t - b.
_AGREED = 16.0
# What repeated turns and one rounding leave of R's orthonormality, in rounding units.
_TURNED = 4.0
# Steps that double the digits: to orthonormality from that of float; to lengths, until this share is left.
_TURNS = 5
_MOST_STEPS = 20
_LEFT = 1e-30


@dataclass(frozen=True, eq=False)
class Readings:
    """The functions of one robot in one formulation.

    robot: arrays of LEG_FIELDS and PLATFORM_FIELDS, legs first, as the C holds them. folded: the constants
    are rounded after they were prepared and not before.
    """

    robot: Numbers
    base_joint: str
    formulation: str = "exact"
    fidelity: str = "general"
    folded: bool = False

    def forces(self, at: Numbers) -> Found:
        """F of (37), by the regrouped equations of the fidelity; those for legs near their joint singularity
        where the C takes them."""
        terms = self._near_terms if self._is_near(at) else self._terms
        D, H, c = terms.at({name: at[name].reshape(shape) for name, shape in MOTION.items()})
        x = solve(array(H), array(c)[:, None])[:, 0]
        return {"F": array(D) - x}

    def inverse_dynamics(self, at: Numbers) -> Found:
        """F, D, x, K, H, c of (20)-(37)."""
        motion = _motion(at)
        leg = self._kernel.leg_dynamics(self._objects, motion)
        platform = self._kernel.platform_wrench(self._objects, motion)
        wrenches = np.concatenate([leg["c_force"], leg["c_moment"]], axis=-1)
        c = np.concatenate([platform["c_force"], platform["c_moment"]])
        for i in range(6):
            c = c + wrenches[i]
        H, c, D = np.concatenate([leg["H_force"], leg["H_moment"]], axis=-1).T, array(c), array(leg["D"])
        x = solve(array(H), c[:, None])[:, 0]
        return _flat({"F": D - x, "D": D, "x": x, "K": leg["K"], "H": H, "c": c})

    def joint_reactions(self, at: Numbers) -> Found:
        """F_s, F_u, F_p, F_c, M_p, M_u of (21), (26)-(29), (17); ``at`` also has bearing (6,)."""
        x = self.inverse_dynamics(at)["x"]
        found = self._kernel.joint_reactions(self._objects, _motion(at), x, array(at["bearing"]))
        return _flat({name: found[name] for name in ("F_s", "F_u", "F_p", "F_c", "M_p", "M_u")})

    def equations(self, at: Numbers) -> Found:
        """M, C, g, friction, bias, H, H_dot."""
        total, legs = self._sums("equations", _motion(at))
        C = np.block([[_matrix(total, f"C_{row}{column}") for column in "vw"] for row in "vw"])
        g, friction = _wrench(total, "g"), _wrench(total, "friction")
        twist = array(np.concatenate([at["v"], at["omega"]]))
        found = {"M": _inertia(total), "C": C, "g": g, "friction": friction, "bias": g + friction + C @ twist}
        return _flat({**found, "H": _columns(legs, "H"), "H_dot": _columns(legs, "H_dot")})

    def bias(self, at: Numbers) -> Found:
        """C [v; omega] + g + friction."""
        return {"bias": _wrench(self._sums("bias", _motion(at))[0], "bias")}

    def forward_dynamics(self, at: Numbers) -> Found:
        """acceleration [a; alpha] under F (6,) of ``at``."""
        total, _ = self._sums("forward", _motion(at), array(at["F"]))
        return {"acceleration": solve_definite(_inertia(total), _wrench(total, "right")[:, None])[:, 0]}

    def joint_inertia(self, at: Numbers) -> Found:
        """H^-1 M H^-T."""
        total, legs = self._sums("equations", _motion(at))
        H = _columns(legs, "H")
        return _flat({"inertia": solve(H, solve(H, _inertia(total)).T)})

    def derivatives(self, at: Numbers) -> Found:
        """F and its derivatives by_pose, by_twist, by_acceleration."""
        F = self.forces(at)["F"]
        total, legs = self._sums("derivatives", _motion(at), F)
        right = np.concatenate([*_slopes(total), _inertia(total)], axis=1)
        by = np.split(solve(_columns(legs, "H"), right), 3, axis=1)
        names = ("by_pose", "by_twist", "by_acceleration")
        return _flat({"F": F, **dict(zip(names, by, strict=True))})

    def linearisation(self, at: Numbers) -> Found:
        """acceleration under F (6,) of ``at``, A and B about the motion with it."""
        acceleration = self.forward_dynamics(at)["acceleration"]
        moving = _motion(at)
        moving.a, moving.alpha = acceleration[:3], acceleration[3:]
        total, legs = self._sums("derivatives", moving, array(at["F"]))
        right = np.concatenate([*_slopes(total), _columns(legs, "H")], axis=1)
        x = solve_definite(_inertia(total), right)
        A, B = array(0, (12, 12)), array(0, (12, 6))
        A[:6, 6:] = array(np.eye(6, dtype=np.int64))
        wx, wy, wz = moving.omega
        A[3:6, 3:6] = array([[0, -wz, wy], [wz, 0, -wx], [-wy, wx, 0]])
        A[6:], B[6:] = -x[:, :12], x[:, 12:]
        return _flat({"acceleration": acceleration, "A": A, "B": B})

    def inverse_kinematics(self, at: Numbers) -> Found:
        """L and L_dot, (2), (5)."""
        q, _, L, s = self._legs(_stored("R", at["R"].reshape(3, 3)), array(at["t"]))
        S_dot = np.cross(array(at["omega"]), q) + array(at["v"])
        return {"L": L, "L_dot": np.sum(s * S_dot, axis=1)}

    def forward_velocity(self, at: Numbers) -> Found:
        """v and omega of leg rates L_dot (6,) of ``at``."""
        H = self._wrench_matrix(_stored("R", at["R"].reshape(3, 3)), array(at["t"]))
        twist = solve(H.T, array(at["L_dot"])[:, None])
        return {"v": twist[:3, 0], "omega": twist[3:, 0]}

    def forward_kinematics(self, at: Numbers) -> Found:
        """R and t of the pose with lengths L (6,) next to R, t of ``at``."""
        R, t = self._pose_of(at["L"], at["R"].reshape(3, 3), at["t"])
        turned, place = _stored("R", R), _stored("t", t)
        q, _, L, _ = self._legs(turned, place)
        terms = np.broadcast_arrays(sizes(q), sizes(place), np.abs(self.robot["b"]))
        reach = np.max(terms, axis=(0, 2))
        J = self._wrench_matrix(turned, place).T
        off = inverse_sizes(J) @ (_AGREED * reach + errors(L))
        x, y, z = off[3:]
        bound = np.array([[0, z, y], [z, 0, x], [y, x, 0]]) @ sizes(turned) + _TURNED
        return _flat({"R": _with_errors(R, bound), "t": _with_errors(t, off[:3] + sizes(place))})

    def motion_from_rpy(self, at: Numbers) -> Found:
        """R, omega and alpha, (38), of sine, cosine, theta_dot, theta_ddot (3,) of ``at``."""
        return self._rotated("motion_from_rpy", at)

    def motion_from_quaternion(self, at: Numbers) -> Found:
        """The same of e, e_dot, e_ddot (4,), scalar first."""
        return self._rotated("motion_from_quaternion", at)

    def _rotated(self, function: str, at: Numbers) -> Found:
        block = reduced_rotation()[function]
        values: dict[str, Running] = {}
        for q in block.inputs:
            first = at[q.name.removesuffix("_w")]
            held = first if q.shape and len(first) == 3 else first[1:] if q.shape else first[:1]
            values |= {name: Running(value) for name, value in zip(q.names, held, strict=True)}
        return _flat(dict(block.run(values, Running.sqrt)))

    # ------------------------------------------------------------ legs

    def _legs(self, R: Objects, t: Objects) -> tuple[Objects, Objects, Objects, Objects]:
        """q, S (6, 3), L (6,), s (6, 3) of (1)-(3)."""
        b = self._objects.b
        q = self._objects.p @ R.T
        # Others take the terms in another order: each intermediate sum is at most the sum of the sizes.
        S = _with_more(q + t - b, sizes(q) + sizes(t) + sizes(b) + sizes(b[0]))
        L = np.sqrt(np.sum(S * S, axis=1))
        return q, S, L, S / L[:, None]

    def _wrench_matrix(self, R: Objects, t: Objects) -> Objects:
        q, _, _, s = self._legs(R, t)
        return np.concatenate([s, np.cross(q, s)], axis=1).T

    def _pose_of(self, L: Array, R: Array, t: Array) -> tuple[Objects, Objects]:
        """R, t of the pose of lengths L next to a pose, at 50 digits, by Newton steps."""
        unit = np.vectorize(digits.mpf, otypes=[object])
        turn, place = unit(R), unit(t)
        for _ in range(_TURNS):
            turn = turn @ (3 * np.eye(3, dtype=np.int64) - turn.T @ turn) / 2
        for _ in range(_MOST_STEPS):
            at = array(turn), array(place)
            rest = array(L) - self._legs(*at)[2]
            step = np.array([x.value for x in solve(self._wrench_matrix(*at).T, rest[:, None])[:, 0]])
            turn, place = _turned(step[3:], turn), place + step[:3]
            if max(sizes(rest)) < _LEFT * max(L):
                break
        return turn, place

    # ------------------------------------------------------------ sums of the closed form

    def _sums(self, kernel: str, motion: SimpleNamespace, F: Objects | None = None) -> tuple[Any, Any]:
        """Sums over the machine, and what each leg has, as structures of the module on arrays."""
        source = self._closed_form
        block = {part: getattr(source, f"{kernel}_{part}") for part in ("pose", "leg", "total")}
        stored = SimpleNamespace(**{**vars(motion), "R": motion.R.ravel()})
        pose = block["pose"](_ON, self._model.platform, stored)
        legs = SimpleNamespace(leg=[])
        for i, leg in enumerate(self._model.leg):
            given = SimpleNamespace(F=None if F is None else F[i])
            legs.leg.append(block["leg"](_ON, leg, self._model.platform, stored, pose, given))
        total = getattr(source, f"{kernel.capitalize()}Sums")()
        block["total"](_ON, pose, legs, total)
        return total, legs.leg

    @cached_property
    def _model(self) -> SimpleNamespace:
        source = self._closed_form
        robot = robot_structure(source.Robot(), self._objects)
        legs, total = [], source.Added()
        for leg in robot.leg:
            legs.append(source.prepare_leg(_ON, robot, leg))
            total = source.add_up(_ON, total, legs[-1])
        return SimpleNamespace(leg=legs, platform=source.prepare_platform(_ON, robot, total))

    @property
    def _closed_form(self) -> ModuleType:
        return module(f"{kernel_name(self.formulation, self.base_joint)}_arrays")

    # ------------------------------------------------------------ numbers

    @cached_property
    def _objects(self) -> SimpleNamespace:
        return SimpleNamespace(**{name: self._constant(name) for name in (*LEG_FIELDS, *PLATFORM_FIELDS)})

    def _constant(self, name: str) -> Any:
        values = _stored(name, self.robot[name], self.folded)
        return values if values.shape else values[()]

    @cached_property
    def _terms(self) -> ForceTerms:
        return self._terms_of(self._forces_kernel)

    @cached_property
    def _near_terms(self) -> ForceTerms:
        near = self._forces_kernel.leg_near_pole
        assert near is not None
        return self._terms_of(replace(self._forces_kernel, leg=near))

    @property
    def _forces_kernel(self) -> ForceKernel:
        return plain_kernel(self.base_joint, self.formulation, self.fidelity)

    def _terms_of(self, kernel: ForceKernel) -> ForceTerms:
        # The C evaluates these equations, whether or not rotation and axes are of length one.
        kind = _FoldedTerms if self.folded else ForceTerms
        return kind(kernel, SimpleNamespace(**self.robot), lambda _, value: Running(value), Running.sqrt)

    def _is_near(self, at: Numbers) -> bool:
        """Whether a leg's third axis takes the place of the fixed axis of its universal joint."""
        if self._forces_kernel.leg_near_pole is None:
            return False
        S = self.robot["p"] @ at["R"].reshape(3, 3).T + at["t"] - self.robot["b"]
        k = self.robot["k"]
        across = np.linalg.norm(np.cross(k, S), axis=1)
        return bool((across <= NEAR_POLE * np.linalg.norm(k, axis=1) * np.linalg.norm(S, axis=1)).any())

    @property
    def _kernel(self) -> ModuleType:
        return module(kernel_name(self.formulation, self.base_joint))


class _FoldedTerms(ForceTerms):
    """The terms with constants that are prepared exactly and rounded once."""

    @cached_property
    def _constants(self) -> tuple[dict[str, Any], list[dict[str, Any]], dict[str, Any]]:
        robot, legs, platform = ForceTerms(self.kernel, self.robot, self.number, self.sqrt)._constants
        return _rounded_once(robot), [_rounded_once(leg) for leg in legs], _rounded_once(platform)


def _rounded_once(constants: Mapping[str, Any]) -> dict[str, Any]:
    return {name: Running(running(value).value, rounded=True) for name, value in constants.items()}


def _number(name: str, value: Any, folded: bool = False) -> Running:
    return Running(value, HALF_UNIT * (name in _ORTHONORMAL), rounded=folded)


def _stored(name: str, values: NDArray[Any], folded: bool = False) -> Objects:
    """A quantity's numbers as they are held; ``folded``: rounded last."""
    made = np.empty(values.shape, dtype=object)
    for where in np.ndindex(values.shape):
        made[where] = _number(name, values[where], folded)
    return made


def _with_errors(numbers: Objects, bound: Array) -> Objects:
    made = np.empty(numbers.shape, dtype=object)
    for where in np.ndindex(numbers.shape):
        made[where] = Running(numbers[where], float(bound[where]))
    return made


def _with_more(numbers: Objects, more: Array) -> Objects:
    """The numbers with larger errors."""
    values = np.array([number.value for number in numbers.flat], dtype=object).reshape(numbers.shape)
    return _with_errors(values, errors(numbers) + more)


def _motion(at: Numbers) -> SimpleNamespace:
    return SimpleNamespace(**{name: _stored(name, at[name].reshape(shape)) for name, shape in MOTION.items()})


def _flat(found: Mapping[str, Any]) -> Found:
    return {name: array(value).ravel() for name, value in found.items()}


def _matrix(total: Any, name: str) -> Objects:
    """A 3x3 matrix from its components, six of a symmetric one."""
    parts = array(getattr(total, name))
    return (parts if len(parts) == 9 else parts[[0, 1, 2, 1, 3, 4, 2, 4, 5]]).reshape(3, 3)


def _inertia(total: Any) -> Objects:
    vv, vw, ww = (_matrix(total, name) for name in ("M_vv", "M_vw", "M_ww"))
    return np.block([[vv, vw], [vw.T, ww]])


def _slopes(total: Any) -> tuple[Objects, Objects]:
    """Derivatives of the wrench by pose and by twist."""
    pose, twist = (
        np.block([[_matrix(total, f"W_{row}{column}") for column in columns] for row in "fm"])
        for columns in ("tr", "vw")
    )
    return pose, twist


def _wrench(total: Any, name: str) -> Objects:
    return array([*getattr(total, f"{name}_force"), *getattr(total, f"{name}_moment")])


def _columns(legs: Sequence[Any], name: str) -> Objects:
    """Rows of force and moment, one column a leg."""
    return np.stack([_wrench(leg, name) for leg in legs], axis=-1)


def _turned(by: Objects, R: Objects) -> Objects:
    """R turned by about the vector ``by``, rad; a rotation to all digits (Cayley)."""
    x, y, z = by
    turn = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]], dtype=object)
    return np.asarray(R + (turn + turn @ turn / 2) @ R / (1 + (x * x + y * y + z * z) / 4))
