"""Interpreter of the functions of a kit in 50-digit arithmetic or in Python floats.

The forces of a fidelity level, the kinematics, and the motor torques are interpreted from their syntax trees.
The inverse dynamics with all outputs and the closed form run as modules of ``generated``, which are printed
from trees. Every function takes the stored motion of one pose and returns the values that the C function
writes, flattened in the order of its struct.
"""

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import cache, cached_property, partial
from types import FunctionType, ModuleType, SimpleNamespace
from typing import Any

import numpy as np

from ..backend.kernel import kernel_name, module
from ..derive.generated_files import reduced_axial, reduced_fidelity, reduced_kinematics, reduced_rotation
from ..derive.kernel.kinematics import PUBLIC, rotation_program, search_program
from ..derive.kernel.outputs import FORCED, FORCES, program
from ..derive.kernel.torque import axial_program, torque_program
from ..derive.mechanics import quantities as n
from ..derive.mechanics.formulation import BY_KERNEL, EXACT, EXACT_DRIVE
from ..derive.trace.constants import constants
from ..derive.trace.interpret import Arithmetic, Interpreter
from ..derive.trace.nodes import Program
from ..formulas.trees import robot_structure, structure
from ..generated.arithmetic import Arithmetic as OnArrays
from ..io.array_types import Array
from ..precision.exact_forces import ON_DIGITS, digits, form_and_level
from ..results import OK
from ..robot.robot import LEGS

Numbers = Mapping[str, Array]
Found = dict[str, Any]

NEAR_JOINT_SINGULAR = constants("double")["NEAR_JOINT_SINGULAR"]
"""Sine of the angle between a leg and its fixed axis below which a third axis replaces the fixed axis."""

_CONSTANTS = constants("double") | {"NAN": math.nan}
DIGITS = Arithmetic(digits.mpf, {name: digits.mpf(value) for name, value in _CONSTANTS.items()}, digits.sqrt)
"""50-digit arithmetic with the thresholds of double precision."""
FLOATS = Arithmetic(float, _CONSTANTS, math.sqrt)
"""Arithmetic of Python floats."""


class _OnArrays(OnArrays):
    """Arithmetic for modules of ``generated`` that evaluate one pose, with the legs in an array."""

    def __init__(self, sqrt: Callable[[Any], Any]) -> None:
        vars(self).update(_CONSTANTS, sqrt=np.frompyfunc(sqrt, 1, 1))

    def agree(self, **given: Any) -> None:
        pass

    def arrays(self, value: Any) -> Any:
        return value

    def checked(self, made: Any, name: str, value: Any) -> Any:
        return value


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
    drives : mapping of str to ndarray
        Arrays of ``stewart_drives``; empty without drives.
    arithmetic : Arithmetic
        DIGITS or FLOATS.
    """

    robot: Numbers
    base_joint: str
    formulation: str = "exact"
    fidelity: str = "general"
    drives: Numbers = field(default_factory=dict)
    arithmetic: Arithmetic = DIGITS

    def found(self, function: str, at: Numbers) -> Found:
        """Compute the results of a function by the method of the same name or by the closed form."""
        if function in reduced_rotation():
            block = reduced_rotation()[function]
            return _flat(self._run(rotation_program([block]), block.name, *map(self._list, at.values())))
        own = getattr(self, function, None)
        return self._of_model(function, at) if own is None else own(at)

    def forces(self, at: Numbers) -> Found:
        """Compute F of (37) by the regrouped equations of the fidelity level."""
        return _flat(self._forces.run(FORCES, self._forces_model, self._motion(at)))

    def inverse_dynamics(self, at: Numbers) -> Found:
        """Compute F, D, x, K, H, and c of (20)-(37)."""
        found = self._every_output.terms(self._on_arrays, self._legs_side_by_side, self._motion(at))
        D, H, c = (_array(each) for each in (found.D, found.H, found.c))
        x = _solve(H, c[:, None])[:, 0]
        return _flat({"F": D - x, "D": D, "x": x, "K": found.K, "H": H, "c": c})

    def joint_reactions(self, at: Numbers) -> Found:
        """Compute F_s, F_u, F_p, F_c, M_p, and M_u of (21), (26)-(29), and (17).

        ``at`` also contains the bearing distances, shape (6,).
        """
        robot = self._legs_side_by_side
        axial = (self.inverse_dynamics(at)["x"], _array(self._list(at["bearing"])))
        reactions = self._every_output.leg_reactions
        found = reactions(self._on_arrays, robot.leg, robot, self._motion(at), *axial)
        return _flat({name: _by_leg(value) for name, value in vars(found).items()})

    def derivatives(self, at: Numbers) -> Found:
        """Compute F and its derivatives by_pose, by_twist, and by_acceleration."""
        acting = SimpleNamespace(F=self.forces(at)["F"], status=OK)
        return self._of_model("derivatives", at, acting=acting)

    def inverse_kinematics(self, at: Numbers) -> Found:
        """Compute L and L_dot, (2) and (5)."""
        motion = structure((n.R, n.t, n.omega, n.v), at, self._number)
        return _flat(self._search.run("inverse_kinematics", self._robot, motion))

    def forward_velocity(self, at: Numbers) -> Found:
        """Compute v and omega from the leg rates L_dot of ``at``, shape (6,)."""
        pose = structure((n.R, n.t), at, self._number)
        return _flat(self._search.run("forward_velocity", self._robot, pose, self._list(at["L_dot"])))

    def forward_kinematics(self, at: Numbers) -> Found:
        """Compute R and t from the leg lengths L, shape (6,), near the pose R, t of ``at``."""
        guess = structure((n.R, n.t), at, self._number)
        found = self._search.run("forward_kinematics", self._robot, self._list(at["L"]), guess)
        return _flat({"status": found.status, **vars(found.pose)})

    def axial_forces(self, at: Numbers) -> Found:
        """Compute the axial forces and L_dot, (5), from the forces F of ``at``, shape (6,)."""
        form = BY_KERNEL[f"{kernel_name('exact', self.base_joint)}_drive"]
        text = axial_program(reduced_axial(form, self.fidelity != "general"))
        return _flat(self._run(text, "axial_forces", self._robot, self._motion(at), self._list(at["F"])))

    def motor_torques(self, at: Numbers) -> Found:
        """Compute torque and current from F, axial, and L_dot of ``at``, shape (6,)."""
        drives = SimpleNamespace(**{name: self._list(of) for name, of in self.drives.items()})
        given = [self._list(at[name]) for name in ("F", "axial", "L_dot")]
        return _flat(self._run(torque_program(), "motor_torques", drives, *given))

    def _of_model(self, what: str, at: Numbers, **given: Any) -> Found:
        """Evaluate a function of the closed form; functions in ``FORCED`` also take F of ``at``, (6,)."""
        motion = SimpleNamespace(**vars(self._motion(at)), **given)
        forces = [self._list(at["F"])] if what in FORCED else []
        function = getattr(_closed_form(self._rotors), what)
        return _flat(function(self._on_arrays, self._model, motion, *forces))

    # ------------------------------------------------------------ numbers and constants

    def _run(self, text: Program, name: str, *arguments: Any) -> Any:
        return Interpreter(text, self.arithmetic).run(name, *arguments)

    def _number(self, _: str, value: Any) -> Any:
        return self.arithmetic.number(value)

    def _list(self, values: Any) -> list[Any]:
        return [self.arithmetic.number(value) for value in np.ravel(values)]

    def _motion(self, at: Numbers) -> SimpleNamespace:
        return structure(n.MOTION, at, self._number)

    @property
    def _rotors(self) -> bool:
        return n.m_r.name in self.robot

    @cached_property
    def _on_arrays(self) -> _OnArrays:
        return _OnArrays(self.arithmetic.sqrt)

    @cached_property
    def _forces(self) -> Interpreter:
        return Interpreter(
            _of_level(self.base_joint, self.formulation, self.fidelity, self._rotors), self.arithmetic
        )

    @cached_property
    def _search(self) -> Interpreter:
        # A search in 50 digits ends only when the pose has 45 digits.
        on = ON_DIGITS if self.arithmetic is DIGITS else self.arithmetic
        return Interpreter(_search_program(), on)

    @property
    def _every_output(self) -> ModuleType:
        name = kernel_name(self.formulation, self.base_joint)
        return module(f"{name}_drive" if self._rotors else name)

    @cached_property
    def _forces_model(self) -> Any:
        return self._forces.run("prepare", self._robot)

    @cached_property
    def _model(self) -> Any:
        return _closed_form(self._rotors).prepare(self._on_arrays, self._robot)

    @cached_property
    def _legs_side_by_side(self) -> SimpleNamespace:
        robot = self._robot
        legs = {name: [getattr(leg, name) for leg in robot.leg] for name in vars(robot.leg[0])}
        leg = {name: [*_array(of).T] if isinstance(of[0], list) else _array(of) for name, of in legs.items()}
        return SimpleNamespace(**vars(robot) | {"leg": SimpleNamespace(**leg)})

    @cached_property
    def _robot(self) -> SimpleNamespace:
        return robot_structure(SimpleNamespace(**self.robot), self._number)


@cache
def _of_level(base_joint: str, formulation: str, fidelity: str, rotors: bool) -> Program:
    kernel = reduced_fidelity(*form_and_level(base_joint, formulation, fidelity, rotors))
    return program(kernel, by_pivots=True)


@cache
def _search_program() -> Program:
    return search_program(reduced_kinematics(), PUBLIC)


@cache
def _closed_form(rotors: bool) -> SimpleNamespace:
    """Copy the generated functions of the closed form with other solvers and with given forces."""
    names: dict[str, Any] = {}
    for form in (EXACT, EXACT_DRIVE) if rotors else (EXACT,):
        names |= vars(module(f"{form.kernel_name}_arrays"))
    functions = {name: each for name, each in names.items() if isinstance(each, FunctionType)}
    names |= {name: FunctionType(each.__code__, names) for name, each in functions.items()}
    instead = _solvers(functions) | {"forces": lambda _, motion: motion.acting}
    for name, function in instead.items():
        names[name] = lambda on, *given, function=function: function(*given)
    return SimpleNamespace(**names)


def _solvers(names: Iterable[str]) -> dict[str, Callable[..., Any]]:
    """Return replacements of the functions that solve linear systems.

    ``singular_status`` returns OK, because H is well-conditioned in all test motions.
    """
    solves = {name: _solve_rows for name in names if name.startswith(("solve_pivoted", "solve_definite"))}
    return {"accelerations_of": _accelerations, "singular_status": lambda *_: OK, **solves}


def _accelerations(legs: Any, summed: Any, out: Any) -> None:
    """Solve for the accelerations with M and the right side, which are sums over the legs."""
    turning = [summed.M_vw[3 * i : 3 * i + 3] for i in range(3)]
    rows = [[*row, *more] for row, more in zip(_symmetric(summed.M_vv), turning, strict=True)]
    columns = zip(zip(*turning, strict=True), _symmetric(summed.M_ww), strict=True)
    rows += [[*more, *row] for more, row in columns]
    right = [[each] for each in (*summed.right_force, *summed.right_moment)]
    found = _solve(_array(rows), _array(right))[:, 0]
    out.a, out.alpha, out.status = list(found[:3]), list(found[3:]), legs.status


def _symmetric(parts: list[Any]) -> list[list[Any]]:
    xx, xy, xz, yy, yz, zz = parts
    return [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]


def _solve_rows(A: list[list[Any]], *_: Any) -> int:
    rows = _array(A)
    for row, found in zip(A, _solve(rows[:, :6], rows[:, 6:]), strict=True):
        row[6:] = found
    return OK


def _solve(A: Any, right: Any) -> Any:
    """Solve A X = right for A (n, n) and ``right`` (n, m)."""
    if isinstance(A[0, 0], digits.mpf):
        found = digits.inverse(digits.matrix(A.tolist())) * digits.matrix(right.tolist())
    else:
        found = np.linalg.solve(A.astype(np.float64), right.astype(np.float64))
    return _array(found.tolist()).reshape(right.shape)


_array = partial(np.array, dtype=object)


def _by_leg(value: Any) -> Any:
    """Stack values of the legs so that the first axis counts the legs."""
    if isinstance(value, list):
        return np.array([np.broadcast_to(_array(each), LEGS) for each in value]).T
    return np.broadcast_to(_array(value), LEGS)


def _flat(found: Any) -> Found:
    """Flatten all members except the status, which must be OK, and combine both accelerations."""
    members = dict(found if isinstance(found, Mapping) else vars(found))
    assert members.pop("status", OK) == OK
    if {"a", "alpha"} <= members.keys():
        members = {"acceleration": [*members.pop("a"), *members.pop("alpha")], **members}
    return {name: _array(value).ravel() for name, value in members.items()}
