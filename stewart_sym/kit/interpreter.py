"""Interpreter of the functions of a kit on ``Running`` numbers: values with bounds of the rounding errors in
C.

The forces of a fidelity level and the kinematics are interpreted from their syntax trees. The inverse
dynamics with all outputs and the closed form run as modules of ``generated``, which are printed from trees.
Linear systems are solved by ``running``, whose bounds are smaller than bounds propagated through an
elimination. Every function takes the stored motion of one pose and returns the values that the C function
writes, flattened in the order of its struct.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import cache, cached_property
from types import FunctionType, ModuleType, SimpleNamespace
from typing import Any

import numpy as np

from ..backend.kernel import kernel_name, module
from ..derive.generate import reduced_axial, reduced_fidelity, reduced_kinematics, reduced_rotation
from ..derive.kernel.kinematics import PUBLIC, rotation_program, search_program
from ..derive.kernel.outputs import FORCED, FORCES, program
from ..derive.kernel.torque import axial_program, torque_program
from ..derive.kernel.tree.constants import constants
from ..derive.kernel.tree.interpret import Arithmetic, Interpreter
from ..derive.kernel.tree.nodes import Program
from ..derive.mechanics import quantities as n
from ..derive.mechanics.formulation import BY_KERNEL, EXACT, EXACT_DRIVE
from ..formulas.trees import robot_structure, structure
from ..generated.arithmetic import Arithmetic as OnArrays
from ..io.array_types import Array
from ..precision.truth import ON_DIGITS, digits, form_and_level, number_of_digits
from ..results import OK
from ..robot.robot import LEGS
from . import running
from .running import HALF_UNIT, Objects, Running, array, errors, sizes, values

Numbers = Mapping[str, Array]
Found = dict[str, Objects]

NEAR_JOINT_SINGULAR = constants("double")["NEAR_JOINT_SINGULAR"]
"""Sine of the angle between a leg and its fixed axis below which a third axis replaces the fixed axis."""

# Rotation matrices and axes are normalized only up to rounding, although some forms of the equations assume
# exact normalization.
_ORTHONORMAL = ("R", "k")
# Rounding unit of double precision, the unit of the errors.
_UNIT = float(np.finfo(np.float64).eps)
# Error of the orthonormality of R after repeated rotations and one rounding (rounding units).
_TURNED = 4.0

ON = Arithmetic(
    Running,
    {name: Running(value) for name, value in (constants("double") | {"NAN": np.nan}).items()},
    Running.sqrt,
)


class _OnArrays(OnArrays):
    """Arithmetic for modules of ``generated`` that evaluate one pose, with the legs in an array."""

    def __init__(self) -> None:
        vars(self).update(ON.constants)

    def agree(self, **given: Any) -> None:
        pass

    def arrays(self, value: Any) -> Any:
        return value

    def checked(self, made: Any, name: str, value: Any) -> Any:
        return value

    def sqrt(self, value: Any) -> Any:
        return np.frompyfunc(lambda each: Running.of(each).sqrt(), 1, 1)(value)


ON_ARRAYS = _OnArrays()


@dataclass(frozen=True, eq=False)
class KitInterpreter:
    """Functions of one robot in one formulation.

    Attributes
    ----------
    robot : mapping of str to ndarray
        Constants named by ``parts.fields``, as stored in C.
    base_joint : str
        Type of the base joints, "universal" or "spherical".
    formulation : str
        "exact" or "paper".
    fidelity : str
        Fidelity level of the forces.
    folded : bool
        True if the constants are rounded only after their preparation, as in baked kernels.
    drives : mapping of str to ndarray
        Arrays of ``stewart_drives``; empty without drives.
    """

    robot: Numbers
    base_joint: str
    formulation: str = "exact"
    fidelity: str = "general"
    folded: bool = False
    drives: Numbers = field(default_factory=dict)

    def forces(self, at: Numbers) -> Found:
        """Compute F of (37) by the regrouped equations of the fidelity level.

        Near a joint singularity, the equations that C uses there replace them.
        """
        # C evaluates these equations for any rotation matrix and axes, whether or not these are normalized.
        given = structure(n.MOTION, at, _exact)
        return _flat(self._forces.run(FORCES, self._forces_model, given))

    def inverse_dynamics(self, at: Numbers) -> Found:
        """Compute F, D, x, K, H, and c of (20)-(37)."""
        found = self._every_output.terms(ON_ARRAYS, self._legs_side_by_side, _motion(at))
        D, H, c = array(found.D), array(found.H), array(found.c)
        x = running.solve(H, c[:, None])[:, 0]
        return _flat({"F": D - x, "D": D, "x": x, "K": found.K, "H": H, "c": c})

    def joint_reactions(self, at: Numbers) -> Found:
        """Compute F_s, F_u, F_p, F_c, M_p, and M_u of (21), (26)-(29), and (17).

        ``at`` also contains the bearing distances, shape (6,).
        """
        robot, axial = self._legs_side_by_side, (self.inverse_dynamics(at)["x"], array(at["bearing"]))
        found = self._every_output.leg_reactions(ON_ARRAYS, robot.leg, robot, _motion(at), *axial)
        return _flat({name: _by_leg(value) for name, value in vars(found).items()})

    def found(self, function: str, at: Numbers) -> Found:
        """Compute the results of a function by the method of the same name or by the closed form."""
        if function in reduced_rotation():
            return _rotated(function, at)
        own = getattr(self, function, None)
        return self._of_model(function, at) if own is None else own(at)

    def _of_model(self, what: str, at: Numbers, **given: Any) -> Found:
        """Evaluate a function of the closed form; functions in ``FORCED`` also take F of ``at``, (6,)."""
        motion = SimpleNamespace(**vars(_motion(at)), **given)
        forces = [list(array(at["F"]))] if what in FORCED else []
        return _flat(getattr(_closed_form(self._rotors), what)(ON_ARRAYS, self._model, motion, *forces))

    def derivatives(self, at: Numbers) -> Found:
        """Compute F and its derivatives by_pose, by_twist, and by_acceleration."""
        acting = SimpleNamespace(F=self.forces(at)["F"], status=OK)
        return self._of_model("derivatives", at, acting=acting)

    def inverse_kinematics(self, at: Numbers) -> Found:
        """Compute L and L_dot, (2) and (5)."""
        motion = structure((n.R, n.t, n.omega, n.v), at, _number)
        return _flat(_kinematics().run("inverse_kinematics", self._robot, motion))

    def forward_velocity(self, at: Numbers) -> Found:
        """Compute v and omega from the leg rates L_dot of ``at``, shape (6,)."""
        pose = structure((n.R, n.t), at, _number)
        return _flat(_kinematics().run("forward_velocity", self._robot, pose, list(array(at["L_dot"]))))

    def forward_kinematics(self, at: Numbers) -> Found:
        """Compute R and t from the leg lengths L, shape (6,), near the pose R, t of ``at``."""
        robot = robot_structure(SimpleNamespace(**self.robot), number_of_digits)
        guess = structure((n.R, n.t), at, number_of_digits)
        search = Interpreter(_search_program(), ON_DIGITS)
        found = search.run("forward_kinematics", robot, [ON_DIGITS.number(L) for L in at["L"]], guess)
        assert found.status == OK
        pose = structure((n.R, n.t), vars(found.pose), _number)
        run = _kinematics()
        legs = run.zero(run.program.function("legs_at").arguments[-1].type)
        run.run("legs_at", self._robot, pose, legs)
        run.run("rows_at", legs, Running(1))
        agreed = ON.constants["ROUNDING"].value / ON.constants["EPSILON"].value * legs.reach.value
        off = running.inverse_sizes(array(legs.A)[:, :6]) @ (float(agreed) + errors(array(legs.L)))
        x, y, z = off[3:]
        R, t = array(pose.R).reshape(3, 3), array(pose.t)
        bound = np.array([[0, z, y], [z, 0, x], [y, x, 0]]) @ sizes(R) + _TURNED
        return _flat({"R": _with_errors(R, bound), "t": _with_errors(t, off[:3] + sizes(t))})

    def axial_forces(self, at: Numbers) -> Found:
        """Compute the axial forces and L_dot, (5), from the forces F of ``at``, shape (6,)."""
        name = f"{kernel_name('exact', self.base_joint)}_drive"
        axial = _axial(name, self.fidelity != "general")
        return _flat(axial.run("axial_forces", self._robot, _motion(at), list(array(at["F"]))))

    def motor_torques(self, at: Numbers) -> Found:
        """Compute torque and current from F, axial, and L_dot of ``at``, shape (6,).

        The values are from the formulas in 50-digit arithmetic, and the error bounds are bounds of the C
        code.
        """
        drives = SimpleNamespace(**{name: list(array(of)) for name, of in self.drives.items()})
        given = [list(array(at[name])) for name in ("F", "axial", "L_dot")]
        found = _flat(Interpreter(torque_program(), ON).run("motor_torques", drives, *given))
        law = torques_of_law(self.drives, at)
        off = {name: abs(values(found[name] - law[name])) / _UNIT for name in law}
        return {name: _with_errors(law[name], errors(found[name]) + off[name]) for name in law}

    # ------------------------------------------------------------ interpreters and constants

    @property
    def _forces(self) -> Interpreter:
        return _of_level(self.base_joint, self.formulation, self.fidelity, self._rotors)

    @property
    def _every_output(self) -> ModuleType:
        name = kernel_name(self.formulation, self.base_joint)
        return module(f"{name}_drive" if self._rotors else name)

    @property
    def _rotors(self) -> bool:
        return n.m_r.name in self.robot

    @cached_property
    def _forces_model(self) -> SimpleNamespace:
        exact = robot_structure(SimpleNamespace(**self.robot), _exact)
        model: SimpleNamespace = self._forces.run("prepare", exact)
        return _rounded_once(model) if self.folded else model

    @cached_property
    def _model(self) -> Any:
        return _closed_form(self._rotors).prepare(ON_ARRAYS, self._robot)

    @cached_property
    def _legs_side_by_side(self) -> SimpleNamespace:
        robot = self._robot
        legs = {name: [getattr(leg, name) for leg in robot.leg] for name in vars(robot.leg[0])}
        leg = {name: [*array(of).T] if isinstance(of[0], list) else array(of) for name, of in legs.items()}
        return SimpleNamespace(**vars(robot) | {"leg": SimpleNamespace(**leg)})

    @cached_property
    def _robot(self) -> SimpleNamespace:
        def number(name: str, value: Any) -> Running:
            return Running(value, HALF_UNIT * (name in _ORTHONORMAL), rounded=self.folded)

        return robot_structure(SimpleNamespace(**self.robot), number)


def torques_of_law(drives: Numbers, at: Numbers) -> Found:
    """Compute torque and current by the formulas of ``drives.friction`` in 50-digit arithmetic.

    Parameters
    ----------
    drives : mapping of str to ndarray
        Arrays of ``stewart_drives``.
    at : mapping of str to ndarray
        Arrays F, axial, and L_dot, shape (6,).
    """
    found: dict[str, list[Running]] = {"torque": [], "current": []}
    for i in range(LEGS):
        of = SimpleNamespace(**{name: digits.mpf(float(value[i])) for name, value in drives.items()})
        F, axial, rate = (digits.mpf(float(at[name][i])) for name in ("F", "axial", "L_dot"))
        x = max(-1, min(1, rate / of.smoothing)) if of.smoothing else digits.sign(rate)
        sign = x * (3 - x**2) / 2
        decay = digits.exp(-((rate / of.stribeck_speed) ** 2)) if of.stribeck else 0
        dry = of.coulomb + of.stribeck * decay + (of.driving if axial * sign > 0 else of.driven) * abs(axial)
        torque = (F + sign * dry + of.viscous * rate) / of.turns
        found["torque"].append(Running(torque))
        found["current"].append(Running(torque / of.torque_constant if of.torque_constant else 0))
    return {name: array(each) for name, each in found.items()}


@cache
def _axial(name: str, reflected: bool) -> Interpreter:
    return Interpreter(axial_program(reduced_axial(BY_KERNEL[name], reflected)), ON)


@cache
def _of_level(base_joint: str, formulation: str, fidelity: str, rotors: bool) -> Interpreter:
    kernel = reduced_fidelity(*form_and_level(base_joint, formulation, fidelity, rotors))
    found = program(kernel, by_pivots=True)
    return Interpreter(found, ON, _solvers(each.name for each in found.functions))


@cache
def _search_program() -> Program:
    return search_program(reduced_kinematics(), PUBLIC)


@cache
def _kinematics() -> Interpreter:
    instead: dict[str, Callable[..., Any]] = {
        "reflect": lambda A: None,
        "substitute": _eliminate,
        "is_open": lambda *_: 0,
    }
    return Interpreter(_search_program(), ON, instead)


@cache
def _closed_form(rotors: bool) -> SimpleNamespace:
    """Copy the generated functions of the closed form with solvers of ``running`` and given forces."""
    names: dict[str, Any] = {}
    for form in (EXACT, EXACT_DRIVE) if rotors else (EXACT,):
        names |= vars(module(f"{form.kernel_name}_arrays"))
    functions = {name: each for name, each in names.items() if isinstance(each, FunctionType)}
    names |= {name: FunctionType(each.__code__, names) for name, each in functions.items()}
    instead = _solvers(functions) | {"forces": lambda _, motion: motion.acting}
    for name, function in instead.items():
        names[name] = lambda on, *given, function=function: function(*given)
    return SimpleNamespace(**names)


def _rotated(function: str, at: Numbers) -> Found:
    """Compute R, omega, and alpha from inputs in the order of the call."""
    block = reduced_rotation()[function]
    run = Interpreter(rotation_program([block]), ON)
    return _flat(run.run(block.name, *(list(array(values)) for values in at.values())))


# ---------------------------------------------------------------- linear systems


def _solvers(names: Iterable[str]) -> dict[str, Callable[..., Any]]:
    """Return replacements of the functions that solve linear systems.

    ``singular_status`` returns OK, because H is well-conditioned in all test motions.
    """
    known: dict[str, Callable[..., Any]] = {
        "eliminate": _eliminate,
        "accelerations_of": _accelerations,
        "singular_status": lambda *_: OK,
    }
    for name in names:
        if name.startswith("solve_pivoted"):
            known[name] = lambda A: _solve_rows(A, running.solve)
        if name.startswith("solve_definite"):
            known[name] = lambda A, kept: _solve_rows(A, running.solve_definite)
    return known


def _eliminate(A: list[list[Running]], x: list[Running]) -> int:
    rows = array(A)
    x[:] = running.solve(rows[:, :6], rows[:, 6:])[:, 0]
    return 0


def _accelerations(legs: Any, summed: Any, out: Any) -> None:
    """Solve for the accelerations with M and the right side, which are sums over the legs."""
    turning = [summed.M_vw[3 * i : 3 * i + 3] for i in range(3)]
    rows = [[*row, *more] for row, more in zip(_symmetric(summed.M_vv), turning, strict=True)]
    columns = zip(zip(*turning, strict=True), _symmetric(summed.M_ww), strict=True)
    rows += [[*more, *row] for more, row in columns]
    right = [[each] for each in (*summed.right_force, *summed.right_moment)]
    found = running.solve_definite(array(rows), array(right))[:, 0]
    out.a, out.alpha, out.status = list(found[:3]), list(found[3:]), legs.status


def _symmetric(parts: list[Running]) -> list[list[Running]]:
    xx, xy, xz, yy, yz, zz = parts
    return [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]


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


def _rounded_once(value: Any) -> Any:
    """Round constants that were prepared exactly once."""
    if isinstance(value, SimpleNamespace):
        return SimpleNamespace(**{name: _rounded_once(part) for name, part in vars(value).items()})
    if isinstance(value, list):
        return [_rounded_once(part) for part in value]
    return value if isinstance(value, int) else Running(value.value, rounded=True)


def _by_leg(value: Any) -> Objects:
    """Stack values of the legs so that the first axis counts the legs."""
    if isinstance(value, list):
        return np.array([array(each, (LEGS,)) for each in value]).T
    return array(value, (LEGS,))


def _with_errors(numbers: Objects, bound: Array) -> Objects:
    made = np.empty(numbers.shape, dtype=object)
    for where in np.ndindex(numbers.shape):
        made[where] = Running(numbers.item(*where).value, float(bound[where]))
    return made


def _flat(found: Any) -> Found:
    """Flatten all members except the status, which must be OK, and combine both accelerations."""
    members = dict(found if isinstance(found, Mapping) else vars(found))
    assert members.pop("status", OK) == OK
    if {"a", "alpha"} <= members.keys():
        members = {"acceleration": [*members.pop("a"), *members.pop("alpha")], **members}
    return {name: array(value).ravel() for name, value in members.items()}
