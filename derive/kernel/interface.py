"""Interface of the C code in one table: structures with ordered members, and functions with arguments.

The C++ wrapper, the self-test, the example, and the README of a kit read the table, and so does the FMI unit.
The ctypes layer and the tests read it from ``generated/interface.py``. Tests compare the headers with it.
"""

import math
from collections.abc import Iterable
from dataclasses import dataclass

from ..mechanics import quantities as n
from ..program.block import Quantity
from ..trace import nodes as t
from .outputs import FORCED, RESULTS, arrays


@dataclass(frozen=True)
class Member:
    """Numbers of a structure, or an array that a function takes: name, shape, unit, meaning.

    ``stored`` are the dimensions in C, in which a matrix usually is one row-major array.
    """

    name: str
    shape: tuple[int, ...]
    unit: str
    meaning: str
    stored: tuple[int, ...]

    @property
    def count(self) -> int:
        """Count of numbers that C stores."""
        return math.prod(self.stored)

    @property
    def dims(self) -> str:
        """Dimensions in C, "" for a number."""
        return "".join(f"[{dim}]" for dim in self.stored)


def _member(quantity: Quantity) -> Member:
    stored = (len(quantity.keys),) if quantity.shape else ()
    return Member(quantity.name, quantity.shape, quantity.unit, quantity.meaning, stored)


def _flat(name: str, shape: tuple[int, ...], unit: str, meaning: str) -> Member:
    return Member(name, shape, unit, meaning, (math.prod(shape),))


def _nested(name: str, shape: tuple[int, ...], unit: str, meaning: str) -> Member:
    return Member(name, shape, unit, meaning, shape)


_WRENCH, _INERTIA = "N and N m", "kg, kg m and kg m^2"
_F = _flat("F", (6,), "N", "actuator forces, positive when they extend the leg, (37)")
_ACCELERATION = _flat("acceleration", (6,), "m/s^2 and rad/s^2", "[a; alpha], base frame")

STRUCTS: dict[str, tuple[Member, ...]] = {
    "leg": tuple(map(_member, n.LEG)),
    "rotor": tuple(map(_member, n.ROTOR)),
    "platform": tuple(map(_member, n.PLATFORM)),
    "limits": (
        _flat("shortest", (6,), "m", "smallest leg length"),
        _flat("longest", (6,), "m", "largest leg length"),
        _flat("force", (6,), "N", "largest magnitude of the actuator force"),
        _flat("speed", (6,), "m/s", "largest magnitude of the sliding velocity"),
    ),
    "drives": (
        _flat("turns", (6,), "rad/m", "motor angle per length, 2 pi gear / lead or gear / radius; not 0"),
        _flat(
            "driving", (6,), "1", "friction per axial force if the motor drives the leg: 1 / efficiency - 1"
        ),
        _flat(
            "driven",
            (6,),
            "1",
            "friction per axial force if the leg drives the motor: 1 - backdrive_efficiency",
        ),
        _flat("coulomb", (6,), "N", "dry friction along the leg: screw_coulomb + |turns| motor_coulomb"),
        _flat("viscous", (6,), "N s/m", "viscous friction: screw_viscous + turns^2 motor_viscous"),
        _flat("stribeck", (6,), "N", "additional dry friction at rest"),
        _flat("stribeck_speed", (6,), "m/s", "length rate at which this friction has decayed to 1/e"),
        _flat("smoothing", (6,), "m/s", "length rate below which the sign of the rate is smoothed"),
        _flat("torque_constant", (6,), "N m/A", "torque per current; 0 if unknown"),
    ),
    "motion": tuple(map(_member, n.MOTION)),
    "pose": (_member(n.R), _member(n.t)),
    "forces": (
        _F,
        _nested("D", (6,), "N", "known part of the actuator forces, (24)"),
        _nested("x", (6,), "N", "axial forces on the legs at their spherical joints, (22)"),
        _nested(
            "K", (6, 3), "N", "transverse forces on the legs at their spherical joints, base frame, (21)"
        ),
        _nested(
            "H",
            (6, 6),
            "1 and m",
            "columns [s; q x s], row-major, H x = c, (36); wrenches on the platform: H F and -H x",
        ),
        _nested(
            "c", (6,), _WRENCH, "wrench that x must balance, base frame, about the reference point, (36)"
        ),
    ),
    "reactions": tuple(
        _nested(q.name, (6, *q.shape), q.unit, q.meaning) for q in (n.F_s, n.F_u, n.F_p, n.F_c, n.M_p, n.M_u)
    ),
    "equations": (
        _flat("M", (6, 6), _INERTIA, "mass matrix, row-major"),
        _flat("C", (6, 6), "units of M over s", "Coriolis and centrifugal matrix, row-major"),
        _flat("g", (6,), _WRENCH, "wrench of gravity"),
        _flat("friction", (6,), _WRENCH, "wrench of the joint friction"),
        _flat("bias", (6,), _WRENCH, "C [v; omega] + g"),
        _flat("bias_and_friction", (6,), _WRENCH, "C [v; omega] + g + friction"),
        _flat("H", (6, 6), "1 and m", "wrench matrix: H F is the generalized force of F, row-major"),
        _flat("H_dot", (6, 6), "1/s and m/s", "time derivative of H, row-major"),
    ),
    "derivatives": (
        _flat("F", (6,), "N", "actuator forces"),
        _flat("by_pose", (6, 6), "N/m and N/rad", "derivatives of F by [dt; dphi], row-major"),
        _flat("by_twist", (6, 6), "N s/m and N s/rad", "derivatives of F by [v; omega], row-major"),
        _flat(
            "by_acceleration", (6, 6), "N s^2/m and N s^2/rad", "derivatives of F by [a; alpha], row-major"
        ),
    ),
    "linearization": (
        _ACCELERATION,
        _flat("A", (12, 12), "mixed", "state matrix, 12 by 12, row-major"),
        _flat("B", (12, 6), "mixed", "input matrix of dF, 12 by 6, row-major"),
    ),
    "legs": (
        _nested("L", (6,), "m", "leg lengths, (2)"),
        _nested("L_dot", (6,), "m/s", "length rates, (5)"),
        _nested("L_ddot", (6,), "m/s^2", "second derivatives of the lengths, (8)"),
        _nested("s", (6, 3), "1", "unit vectors along the legs, base frame, (3)"),
        _nested("S", (6, 3), "m", "leg vectors, base frame, (1)"),
    ),
}
"""Members of each ``stewart_<name>`` in order.

Those of ``rotor`` end ``stewart_leg`` where STEWART_ROTORS is defined; those of ``platform`` end
``stewart_robot``, after its six legs; of ``legs`` there is ``stewart_legs_arrays``
alone. ``drives`` stands in the header of the torques, the others in ``stewart.h``."""


@dataclass(frozen=True)
class Argument:
    """Argument of a C function, after the robot or model.

    ``struct`` is a name in ``STRUCTS``, or "" for an array. ``takes`` and ``gives`` are the members that the
    caller sets and reads; both are empty for a complete structure that is only read, or that is written in
    addition to the outputs. An ``optional`` argument may be null. A ``shared`` array is the same for all
    poses of a batch.
    """

    name: str
    struct: str = ""
    takes: tuple[Member, ...] = ()
    gives: tuple[Member, ...] = ()
    written: bool = False
    optional: bool = False
    shared: bool = False

    @property
    def is_motion(self) -> bool:
        """True if the function reads a motion."""
        return self.struct == "motion" and not self.written

    @property
    def whole(self) -> bool:
        """True if the function writes all members of a structure."""
        return bool(self.struct) and self.gives == STRUCTS[self.struct]

    def declared(self) -> str:
        """Declaration in C."""
        const = "" if self.written else "const "
        if self.struct:
            return f"{const}stewart_{self.struct} *{self.name}"
        (array,) = self.takes or self.gives
        return f"{const}stewart_real {self.name}{array.dims}"

    def of_batch(self) -> str:
        """Declaration in a batch function, "" if the batch function has no such argument."""
        if self.is_motion:
            return "const stewart_motions *motions"
        if self.whole:
            return f"const stewart_{self.struct}_arrays *{self.name}"
        if self.struct or self.shared:
            return "" if self.struct else self.declared()
        return f"{'' if self.written else 'const '}stewart_real *{self.name if self.name == 'F' else 'out'}"


@dataclass(frozen=True)
class Call:
    """Call of the functions with one stem.

    ``says`` is the description. ``has_batch`` is True if a function for many poses exists, and
    ``has_columns`` if one with a column for each component exists.
    """

    says: str
    arguments: tuple[Argument, ...]
    has_batch: bool = False
    has_columns: bool = False

    @property
    def motion(self) -> bool:
        """True if the function reads a ``stewart_motion``."""
        return any(each.is_motion for each in self.arguments)

    @property
    def inputs(self) -> tuple[Member, ...]:
        """Inputs except motion, robot, and model."""
        return tuple(member for each in self.arguments for member in each.takes)

    @property
    def outputs(self) -> tuple[Member, ...]:
        """Outputs in order."""
        return tuple(member for each in self.arguments for member in each.gives)

    @property
    def taken(self) -> int:
        """Count of numbers in the inputs except motion, robot, and model."""
        return sum(member.count for member in self.inputs)

    @property
    def count(self) -> int:
        """Count of numbers in the outputs."""
        return sum(member.count for member in self.outputs)

    def prototypes(self, symbol: str, subject: str, batch: bool) -> list[str]:
        """Return the C declarations of ``symbol`` and, with ``batch``, of the batch and column functions.

        ``subject`` is the first parameter, "" for none.
        """
        first = [subject] if subject else []
        found = [_prototype(symbol, [*first, *(each.declared() for each in self.arguments)])]
        if batch:
            own = [text for each in self.arguments if (text := each.of_batch())]
            after = [*own, "int *status"]
            found.append(_prototype(f"{symbol}_batch", [*first, "size_t count", *after]))
            if self.has_columns:
                counts = ["size_t count", "size_t stride"]
                found.append(_prototype(f"{symbol}_columns", [*first, *counts, *after]))
        return found


def _prototype(symbol: str, parameters: Iterable[str]) -> str:
    return f"int {symbol}({', '.join(parameters)});"


def _in(
    name: str, count: int, unit: str, meaning: str, shared: bool = False, optional: bool = False
) -> Argument:
    """Return an input; a ``shared`` array is the same for all poses and may be null."""
    taken = (_flat(name, (count,), unit, meaning),)
    return Argument(name, takes=taken, optional=shared or optional, shared=shared)


def _out(member: Member, optional: bool = False) -> Argument:
    return Argument(member.name, gives=(member,), written=True, optional=optional)


def _struct(struct: str, name: str = "out") -> Argument:
    return Argument(name, struct, gives=STRUCTS[struct], written=True)


_BEARING = "distance along each leg from its base point to the reference point of M_p; may be null"
_AXIAL = "axial forces in the screws; may be null if F does not include rotors"
_CURRENT = "torque / torque_constant, 0 without one; may be null"
_MOTION = Argument("motion", "motion")
_GIVEN_F = Argument("F", takes=(_F,))
_TURNED = Argument(
    "motion",
    "motion",
    gives=(
        _flat("R", (9,), "1", "orientation, row-major: `motion.R`"),
        _flat("omega", (3,), "rad/s", "angular velocity, base frame: `motion.omega`"),
        _flat("alpha", (3,), "rad/s^2", "angular acceleration, base frame: `motion.alpha`"),
    ),
    written=True,
)
_SEARCHED = Argument(
    "pose",
    "pose",
    takes=(
        _flat("R_guess", (9,), "1", "orientation of the guess, row-major: `pose.R` on entry"),
        _flat("t_guess", (3,), "m", "position of the guess: `pose.t` on entry"),
    ),
    gives=(
        _flat("R", (9,), "1", "orientation, row-major: `pose.R`"),
        _flat("t", (3,), "m", "position of the reference point: `pose.t`"),
    ),
    written=True,
)
_POSE = Argument(
    "pose",
    "pose",
    takes=(
        _flat("R", (9,), "1", "orientation of the pose, row-major: `pose.R`"),
        _flat("t", (3,), "m", "position of the pose: `pose.t`"),
    ),
)

CALLS: dict[str, Call] = {
    "forces": Call("Actuator forces of a motion, (37).", (_MOTION, _out(_F)), True, True),
    "inverse_dynamics": Call(
        "Inverse dynamics with its terms D, K, H and c, (21) to (37).",
        (_MOTION, _struct("forces", "forces")),
        True,
    ),
    "joint_reactions": Call(
        "Reactions in every joint. `bearing` may be null; then M_p is taken at the base points. `forces` "
        "receives the inverse dynamics of the same motion.",
        (
            _MOTION,
            _in("bearing", 6, "m", _BEARING, shared=True),
            Argument("forces", "forces", written=True),
            _struct("reactions", "reactions"),
        ),
        True,
    ),
    "equations": Call(
        "Closed form M [a; alpha] + C [v; omega] + g + friction = H F + load.",
        (_MOTION, _struct("equations")),
        True,
    ),
    "bias_and_friction": Call(
        "C [v; omega] + g + friction alone.",
        (_MOTION, _out(_flat("bias_and_friction", (6,), _WRENCH, "force and moment, base frame"))),
        True,
    ),
    "forward_dynamics": Call(
        "Accelerations of the platform under actuator forces F.",
        (_MOTION, _GIVEN_F, _out(_ACCELERATION)),
        True,
    ),
    "joint_inertia": Call(
        "Inertia seen by the actuators, H^-1 M H^-T.",
        (_MOTION, _out(_flat("inertia", (6, 6), "kg", "row-major"))),
        True,
    ),
    "derivatives": Call(
        "Actuator forces and their derivatives by [dt; dphi], [v; omega] and [a; alpha].",
        (_MOTION, _struct("derivatives")),
        True,
    ),
    "linearization": Call(
        "Forward dynamics and d/dt [dt; dphi; dv; domega] = A [dt; dphi; dv; domega] + B dF.",
        (_MOTION, _GIVEN_F, _struct("linearization")),
        True,
    ),
    "inverse_kinematics": Call(
        "Leg lengths and length rates, (2) and (5).",
        (
            _MOTION,
            _out(_flat("L", (6,), "m", "lengths of the legs")),
            _out(_flat("L_dot", (6,), "m/s", "length rates; may be null")),
        ),
    ),
    "forward_kinematics": Call(
        "Pose with the given leg lengths, searched from the guess in `pose`. Of the poses found by up to "
        "STEWART_MAX_SEARCHES searches, the pose nearest to the guess is returned. If the guess may be "
        "farther away than 0.05 (m and rad), compare the pose with the guess. STEWART_NOT_CONVERGED: no "
        "search found a pose in STEWART_MAX_STEPS steps. STEWART_SINGULAR: the lengths do not determine the "
        "pose.",
        (_in("L", 6, "m", "lengths of the legs"), _SEARCHED),
    ),
    "forward_velocity": Call(
        "Velocities of the platform from the rates of the legs, (5).",
        (
            _POSE,
            _in("L_dot", 6, "m/s", "rates of the legs"),
            _out(_flat("v", (3,), "m/s", "velocity of the reference point, base frame")),
            _out(_flat("omega", (3,), "rad/s", "angular velocity, base frame")),
        ),
    ),
    "axial_forces": Call(
        "Axial forces between the parts of legs with rotors, and length rates, (5). Both are inputs of "
        "`motor_torques`. The axial force is F minus m_r L_ddot + j_r A.s, the force that accelerates the "
        "rotor (m_r L_ddot at the fidelity levels `reflected`).",
        (
            _MOTION,
            _GIVEN_F,
            _out(_flat("axial", (6,), "N", "forces that pass through the screws, positive when they extend")),
            _out(_flat("L_dot", (6,), "m/s", "rates of the lengths; may be null"), optional=True),
        ),
    ),
    "motor_torques": Call(
        "Torques and currents of the motors, from forces of the inverse dynamics and the legs' rates: "
        "(F + friction) / turns, where friction = sgn(L_dot) (coulomb + stribeck exp(-(L_dot / "
        "stribeck_speed)^2) + mu |axial|) + viscous L_dot, mu = driving where axial L_dot > 0, else driven.",
        (
            _GIVEN_F,
            _in("axial", 6, "N", _AXIAL, optional=True),
            _in("L_dot", 6, "m/s", "rates of the lengths, computed or measured"),
            _out(_flat("torque", (6,), "N m", "torques; of a right-handed screw positive when they extend")),
            _out(_flat("current", (6,), "A", _CURRENT), optional=True),
        ),
    ),
    "motion_from_rpy": Call(
        "R, omega and alpha of a motion from roll, pitch and yaw, R = Rz Ry Rx, (38), and their rates.",
        (
            _in("sine", 3, "1", "sines of roll, pitch and yaw"),
            _in("cosine", 3, "1", "their cosines"),
            _in("theta_dot", 3, "rad/s", "rates of the angles"),
            _in("theta_ddot", 3, "rad/s^2", "their second rates"),
            _TURNED,
        ),
    ),
    "motion_from_quaternion": Call(
        "R, omega and alpha of a motion from a quaternion, platform to base, scalar first, and its rates.",
        (
            _in("e", 4, "1", "quaternion of any length"),
            _in("e_dot", 4, "1/s", "its rate"),
            _in("e_ddot", 4, "1/s^2", "its second rate"),
            _TURNED,
        ),
    ),
}


def _of_result(of: str) -> Call:
    """Return the call of an output with one array, by its entry in ``RESULTS``; ValueError for several."""
    found = arrays(RESULTS[of])
    if len(found) != 1:
        tables = "STRUCTS and CALLS in kernel/interface.py, STRUCTS in emit/closed_form_interface.py"
        raise ValueError(f"RESULTS: {of}: expected one array, or it in {tables}, got {len(found)} arrays")
    (array,) = found
    assert isinstance(array.type, t.Array)
    unit, _, meaning = array.meaning.partition(": ")
    given = (_GIVEN_F,) if of in FORCED else ()
    out = _out(_flat(array.name, array.type.dims, unit, meaning))
    return Call(RESULTS[of].meaning, (_MOTION, *given, out), True)


CALLS |= {of: _of_result(of) for of in RESULTS if of not in CALLS}
"""Functions of the kernels by stem: the C name is ``stewart_<kernel>_<stem>``, or without a kernel."""
