"""What the functions of a kit compute, in ``Running`` numbers: the kernels that are printed, interpreted.

Linear systems are solved by ``running``, with smaller errors than a run of the elimination. Every
reading takes the robot and the motion of one pose as stored and hands out what the C writes, flat, in the
order of its struct.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache, cached_property, partial
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..derive import notation as n
from ..derive.formulation import EXACT, FORMULATIONS
from ..derive.generate import output_program, reduced, reduced_kinematics, reduced_rotation
from ..derive.kernel.constants import constants
from ..derive.kernel.interpret import Arithmetic, Interpreter
from ..derive.kernel.inverse_dynamics import REACTIONS, TERMS, terms_program
from ..derive.kernel.kinematics import PUBLIC, rotation_program, search_program
from ..derive.kernel.nodes import Program
from ..derive.kernel.outputs import FORCES, program
from ..kernel import kernel_name
from ..results import OK
from ..studies.truth import ON_DIGITS, number_of_digits
from ..trees import robot_structure, structure
from .parts import plain_kernel
from .running import (
    HALF_UNIT,
    Objects,
    Running,
    array,
    errors,
    inverse_sizes,
    sizes,
    solve,
    solve_definite,
)

Array = NDArray[np.float64]
Numbers = Mapping[str, Array]
Found = dict[str, Objects]

LEG_FIELDS = tuple(q.name for q in n.LEG)
PLATFORM_FIELDS = tuple(q.name for q in n.PLATFORM)
NEAR_POLE = constants("double")["NEAR_POLE"]
"""Sine of the angle between a leg and its fixed axis below which a third axis takes the place of that one."""

# Outputs of the closed form in two programs: derivatives take longest to derive.
_EQUATIONS = ("equations", "bias", "forward_dynamics", "joint_inertia")
_SLOPES = ("derivatives", "linearisation")
# Rotations and axes are of length one only to rounding; other forms of the equations use that they are.
_ORTHONORMAL = ("R", "k")
# What repeated turns and one rounding leave of R's orthonormality, in rounding units.
_TURNED = 4.0

ON = Arithmetic(
    Running,
    {name: Running(value) for name, value in (constants("double") | {"NAN": np.nan}).items()},
    Running.sqrt,
)


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
        # The C evaluates these equations, whether or not rotation and axes are of length one.
        given = structure(n.MOTION, at, _exact)
        return _flat(self._forces.run(FORCES, self._forces_model, given))

    def inverse_dynamics(self, at: Numbers) -> Found:
        """F, D, x, K, H, c of (20)-(37)."""
        found = self._terms.run(TERMS, self._robot, _motion(at))
        D, H, c = array(found.D), array(found.H), array(found.c)
        x = solve(H, c[:, None])[:, 0]
        return _flat({"F": D - x, "D": D, "x": x, "K": found.K, "H": H, "c": c})

    def joint_reactions(self, at: Numbers) -> Found:
        """F_s, F_u, F_p, F_c, M_p, M_u of (21), (26)-(29), (17); ``at`` also has bearing (6,)."""
        x, motion = self.inverse_dynamics(at)["x"], _motion(at)
        legs = zip(self._robot.leg, x, array(at["bearing"]), strict=True)
        found = [self._terms.run(REACTIONS, leg, self._robot, motion, *own) for leg, *own in legs]
        return _flat({name: [getattr(leg, name) for leg in found] for name in vars(found[0])})

    def equations(self, at: Numbers) -> Found:
        """M, C, g, friction, bias, H, H_dot."""
        return self._of_model("equations", at)

    def bias(self, at: Numbers) -> Found:
        """C [v; omega] + g + friction."""
        return self._of_model("bias", at)

    def forward_dynamics(self, at: Numbers) -> Found:
        """acceleration [a; alpha] under F (6,) of ``at``."""
        return self._of_model("forward_dynamics", at, list(array(at["F"])))

    def joint_inertia(self, at: Numbers) -> Found:
        """H^-1 M H^-T."""
        return self._of_model("joint_inertia", at)

    def derivatives(self, at: Numbers) -> Found:
        """F and its derivatives by_pose, by_twist, by_acceleration."""
        acting = SimpleNamespace(F=self.forces(at)["F"], status=OK)
        return self._of_model("derivatives", at, acting=acting)

    def linearisation(self, at: Numbers) -> Found:
        """acceleration under F (6,) of ``at``, A and B about the motion with it."""
        return self._of_model("linearisation", at, list(array(at["F"])))

    def inverse_kinematics(self, at: Numbers) -> Found:
        """L and L_dot, (2), (5)."""
        motion = structure((n.R, n.t, n.omega, n.v), at, _number)
        return _flat(_kinematics().run("inverse_kinematics", self._robot, motion))

    def forward_velocity(self, at: Numbers) -> Found:
        """v and omega of leg rates L_dot (6,) of ``at``."""
        pose = structure((n.R, n.t), at, _number)
        return _flat(_kinematics().run("forward_velocity", self._robot, pose, list(array(at["L_dot"]))))

    def forward_kinematics(self, at: Numbers) -> Found:
        """R and t of the pose with lengths L (6,) next to R, t of ``at``."""
        robot = robot_structure(SimpleNamespace(**self.robot), number_of_digits)
        guess = structure((n.R, n.t), at, number_of_digits)
        search = Interpreter(_search_program(), ON_DIGITS)
        found = search.run("forward_kinematics", robot, [ON_DIGITS.number(L) for L in at["L"]], guess)
        assert found.status == OK
        pose = structure((n.R, n.t), vars(found.pose), _number)
        run = _kinematics()
        legs = run.zero(run.program.function("legs_at").arguments[-1].type)
        run.run("legs_at", self._robot, pose, Running(1), legs)
        agreed = ON.constants["ROUNDING"].value / ON.constants["EPSILON"].value * legs.reach.value
        off = inverse_sizes(array(legs.A)[:, :6]) @ (float(agreed) + errors(array(legs.L)))
        x, y, z = off[3:]
        R, t = array(pose.R).reshape(3, 3), array(pose.t)
        bound = np.array([[0, z, y], [z, 0, x], [y, x, 0]]) @ sizes(R) + _TURNED
        return _flat({"R": _with_errors(R, bound), "t": _with_errors(t, off[:3] + sizes(t))})

    def motion_from_rpy(self, at: Numbers) -> Found:
        """R, omega and alpha, (38), of sine, cosine, theta_dot, theta_ddot (3,) of ``at``."""
        return _rotated("motion_from_rpy", at)

    def motion_from_quaternion(self, at: Numbers) -> Found:
        """The same of e, e_dot, e_ddot (4,), scalar first."""
        return _rotated("motion_from_quaternion", at)

    # ------------------------------------------------------------ interpreters and constants

    def _of_model(self, what: str, at: Numbers, *more: Any, **given: Any) -> Found:
        """A function of the closed form."""
        motion = SimpleNamespace(**vars(_motion(at)), **given)
        run = _closed_form(_SLOPES if what in _SLOPES else _EQUATIONS)
        return _flat(run.run(what, self._model, motion, *more))

    @property
    def _forces(self) -> Interpreter:
        return _of_level(self.base_joint, self.formulation, self.fidelity)

    @property
    def _terms(self) -> Interpreter:
        return _terms(kernel_name(self.formulation, self.base_joint))

    @cached_property
    def _forces_model(self) -> SimpleNamespace:
        exact = robot_structure(SimpleNamespace(**self.robot), _exact)
        model: SimpleNamespace = self._forces.run("prepare", exact)
        return _rounded_once(model) if self.folded else model

    @cached_property
    def _model(self) -> SimpleNamespace:
        model: SimpleNamespace = _closed_form(_EQUATIONS).run("prepare", self._robot)
        return model

    @cached_property
    def _robot(self) -> SimpleNamespace:
        def number(name: str, value: Any) -> Running:
            return Running(value, HALF_UNIT * (name in _ORTHONORMAL), rounded=self.folded)

        return robot_structure(SimpleNamespace(**self.robot), number)


@cache
def _of_level(base_joint: str, formulation: str, fidelity: str) -> Interpreter:
    return _solving(program(plain_kernel(base_joint, formulation, fidelity)))


@cache
def _terms(name: str) -> Interpreter:
    return Interpreter(terms_program(reduced(next(f for f in FORMULATIONS if f.kernel_name == name))), ON)


@cache
def _search_program() -> Program:
    return search_program(reduced_kinematics(), PUBLIC)


@cache
def _kinematics() -> Interpreter:
    instead: dict[str, Callable[..., Any]] = {
        "reflect": lambda A: None,
        "substitute": _eliminate,
        "is_open": lambda A: 0,
    }
    return Interpreter(_search_program(), ON, instead)


@cache
def _closed_form(outputs: tuple[str, ...], deep: bool = False) -> Interpreter:
    """Some of its functions; those for poses that cost digits are derived where one is met."""
    found = output_program(EXACT, outputs, deep=deep)
    later = (each.name for each in found.functions if not each.body)
    derived = {name: partial(_derived, outputs, name) for name in later}
    return _solving(found, forces=lambda _, motion: motion.acting, **derived)


def _derived(outputs: tuple[str, ...], name: str, *given: Any) -> Any:
    return _closed_form(outputs, deep=True).run(name, *given)


def _rotated(function: str, at: Numbers) -> Found:
    block = reduced_rotation()[function]
    run = Interpreter(rotation_program([block]), ON)
    return _flat(run.run(block.name, *(list(array(values)) for values in at.values())))


# ---------------------------------------------------------------- linear systems


def _solving(found: Program, **instead: Callable[..., Any]) -> Interpreter:
    """An interpreter that solves by ``running``; near its joint singularity no leg is short."""
    known: dict[str, Callable[..., Any]] = {"eliminate": _eliminate, "singular_status": lambda *_: OK}
    for each in found.functions:
        if each.name.startswith("solve_pivoted"):
            known[each.name] = _solve_pivoted
        if each.name.startswith("solve_definite"):
            known[each.name] = _solve_definite
    return Interpreter(found, ON, known | instead)


def _eliminate(A: list[list[Running]], x: list[Running]) -> int:
    rows = array(A)
    x[:] = solve(rows[:, :6], rows[:, 6:])[:, 0]
    return 0


def _solve_pivoted(A: list[list[Running]]) -> int:
    return _solve_rows(A, solve)


def _solve_definite(A: list[list[Running]], kept: Running) -> int:
    return _solve_rows(A, solve_definite)


def _solve_rows(A: list[list[Running]], how: Callable[[Objects, Objects], Objects]) -> int:
    rows = array(A)
    for row, found in zip(A, how(rows[:, :6], rows[:, 6:]), strict=True):
        row[6:] = found
    return OK


# ---------------------------------------------------------------- numbers


def _exact(_: str, value: Any) -> Running:
    return Running(value)


def _number(name: str, value: Any) -> Running:
    return Running(value, HALF_UNIT * (name in _ORTHONORMAL))


def _motion(at: Numbers) -> SimpleNamespace:
    return structure(n.MOTION, at, _number)


def _rounded_once(held: Any) -> Any:
    """Constants that are prepared exactly and rounded once."""
    if isinstance(held, SimpleNamespace):
        return SimpleNamespace(**{name: _rounded_once(part) for name, part in vars(held).items()})
    if isinstance(held, list):
        return [_rounded_once(part) for part in held]
    return held if isinstance(held, int) else Running(held.value, rounded=True)


def _with_errors(numbers: Objects, bound: Array) -> Objects:
    made = np.empty(numbers.shape, dtype=object)
    for where in np.ndindex(numbers.shape):
        made[where] = Running(numbers.item(*where).value, float(bound[where]))
    return made


def _flat(found: Any) -> Found:
    """Members but the status, which is OK; accelerations of both kinds as one."""
    held = dict(found if isinstance(found, Mapping) else vars(found))
    assert held.pop("status", OK) == OK
    if {"a", "alpha"} <= held.keys():
        held = {"acceleration": [*held.pop("a"), *held.pop("alpha")], **held}
    return {name: array(value).ravel() for name, value in held.items()}
