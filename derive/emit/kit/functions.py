"""What a kit's functions take, hand out and cost: one table for self-test, example and README.

A part of a kit is one header and source with some functions. Knows signatures and units, no equation.
"""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from ...block import Quantity
from .. import c

ROBOT, MODEL, NOTHING = "robot", "model", ""


@dataclass(frozen=True)
class Field:
    """One array that a function takes or hands out: name, C dimensions, count of numbers, unit, meaning."""

    name: str
    dims: str
    count: int
    unit: str
    meaning: str


@dataclass(frozen=True)
class Signature:
    """How the functions of one stem are called.

    says: what it does, for the README. motion: whether a ``stewart_motion`` is read. inputs: other inputs, in
    the order in which a self-test keeps them. outputs: what is handed out, in
    the order of the struct or of the arguments. call: body of a self-test's function that has ``motion``,
    ``in`` (the other inputs) and ``out`` (all outputs, untouched on a status other than STEWART_OK).
    """

    says: str
    outputs: tuple[Field, ...]
    call: str
    motion: bool = True
    inputs: tuple[Field, ...] = ()

    @property
    def count(self) -> int:
        """How many numbers are handed out."""
        return sum(out.count for out in self.outputs)

    @property
    def taken(self) -> int:
        """How many numbers are taken besides the motion."""
        return sum(given.count for given in self.inputs)


@dataclass(frozen=True)
class Function:
    """A function of a kit: its stem in ``SIGNATURES``, C name, header, what its first argument is.

    subject: ROBOT, MODEL (``prefix`` + ``_model``, made by ``prefix`` + ``_prepare``) or NOTHING.
    operations: what a pose takes, in words. plain: C name without a robot's numbers in it. batch: whether
    there is ``<symbol>_batch`` as well.
    """

    stem: str
    symbol: str
    header: str
    subject: str
    prefix: str = ""
    operations: str = ""
    plain: str = ""
    batch: bool = False

    @property
    def signature(self) -> Signature:
        """Inputs and outputs."""
        return SIGNATURES[self.stem]


@dataclass(frozen=True)
class Part:
    """One header and source of a kit.

    name: of both, without the ending. files: file name -> text. kinds: what it is for the list of deviations,
    out of ``deviations.KINDS``. says: a line for the README.
    """

    name: str
    files: Mapping[str, str]
    functions: tuple[Function, ...]
    kinds: tuple[str, ...]
    says: str

    @property
    def header(self) -> str:
        """File name of the header."""
        return f"{self.name}.h"

    @property
    def source(self) -> str:
        """File name of the source."""
        return f"{self.name}.c"


def _array(name: str, dims: tuple[int, ...], unit: str, meaning: str) -> Field:
    return Field(name, "".join(f"[{dim}]" for dim in dims), math.prod(dims), unit, meaning)


_IN_STRUCT = """\
    @type@ found;
    int status;
    (void)memcpy(&found, out, sizeof found);
    status = @symbol@(@subject@motion@further@, &found);
    (void)memcpy(out, &found, sizeof found);
    return status;
"""
_IN_ARRAY = "    return @symbol@(@subject@motion@further@, out);\n"


def _struct(name: str) -> str:
    return _IN_STRUCT.replace("@type@", name)


def _further(text: str, arguments: str) -> str:
    return text.replace("@further@", arguments)


def _of_struct(quantities: Iterable[tuple[Quantity, str]]) -> tuple[Field, ...]:
    """Members of a struct of ``stewart.h``."""
    return tuple(Field(q.name, dims, _count(dims), q.unit, q.meaning) for q, dims in quantities)


def _count(dims: str) -> int:
    return math.prod(int(dim) for dim in dims.strip("[]").split("]["))


FORCES = _of_struct(c.FORCES)
_REACTIONS = _of_struct((q, "[6][3]" if q.shape else "[6]") for q in c.REACTIONS)
_TURNED = (
    _array("R", (9,), "1", "orientation, row-major: `motion.R`"),
    _array("omega", (3,), "rad/s", "angular velocity, base frame: `motion.omega`"),
    _array("alpha", (3,), "rad/s^2", "angular acceleration, base frame: `motion.alpha`"),
)
_TURN = """\
    stewart_motion made;
    int status;
    (void)memset(&made, 0, sizeof made);
    status = @symbol@(@arguments@, &made);
    if (status == STEWART_OK) {
        (void)memcpy(out, made.R, sizeof made.R);
        (void)memcpy(out + 9, made.omega, sizeof made.omega);
        (void)memcpy(out + 12, made.alpha, sizeof made.alpha);
    }
    return status;
"""
_WRENCH, _MATRIX = "N and N m", "kg, kg m and kg m^2"

SIGNATURES: dict[str, Signature] = {
    "forces": Signature("Actuator forces of a motion, (37).", FORCES[:1], _further(_IN_ARRAY, "")),
    "inverse_dynamics": Signature(
        "Inverse dynamics with its terms D, K, H and c, (21) to (37).",
        FORCES,
        _further(_struct("stewart_forces"), ""),
    ),
    "joint_reactions": Signature(
        "Reactions in every joint; `bearing` may be null: M_p at the base points. `forces` takes the inverse "
        "dynamics of the same motion.",
        _REACTIONS,
        """\
    stewart_forces forces;
    stewart_reactions found;
    int status;
    (void)memcpy(&found, out, sizeof found);
    status = @symbol@(@subject@motion, in, &forces, &found);
    (void)memcpy(out, &found, sizeof found);
    return status;
""",
        inputs=(
            _array("bearing", (6,), "m", "from each base point along its leg to where M_p is taken; or null"),
        ),
    ),
    "equations": Signature(
        "Closed form M [a; alpha] + C [v; omega] + g + friction = H F + load.",
        (
            _array("M", (36,), _MATRIX, "inertia matrix, row-major"),
            _array("C", (36,), "the same over s", "Coriolis and centrifugal matrix, row-major"),
            _array("g", (6,), _WRENCH, "gravity"),
            _array("friction", (6,), _WRENCH, "friction of the joints"),
            _array("bias", (6,), _WRENCH, "C [v; omega] + g + friction"),
            _array("H", (36,), "1 and m", "from actuator forces to the wrench, row-major"),
            _array("H_dot", (36,), "1/s and m/s", "rate of H, row-major"),
        ),
        _further(_struct("stewart_equations"), ""),
    ),
    "bias": Signature(
        "C [v; omega] + g + friction alone.",
        (_array("bias", (6,), _WRENCH, "force and moment, base frame"),),
        _further(_IN_ARRAY, ""),
    ),
    "forward_dynamics": Signature(
        "Accelerations of the platform under actuator forces F.",
        (_array("acceleration", (6,), "m/s^2 and rad/s^2", "[a; alpha], base frame"),),
        _further(_IN_ARRAY, ", in"),
        inputs=FORCES[:1],
    ),
    "joint_inertia": Signature(
        "Inertia that the actuators feel, H^-1 M H^-T.",
        (_array("inertia", (36,), "kg", "row-major"),),
        _further(_IN_ARRAY, ""),
    ),
    "derivatives": Signature(
        "Actuator forces and their derivatives by [dt; dphi], [v; omega] and [a; alpha].",
        (
            _array("F", (6,), "N", "actuator forces"),
            _array("by_pose", (36,), "N/m and N/rad", "row-major"),
            _array("by_twist", (36,), "N s/m and N s/rad", "row-major"),
            _array("by_acceleration", (36,), "N s^2/m and N s^2/rad", "row-major"),
        ),
        _further(_struct("stewart_derivatives"), ""),
    ),
    "linearisation": Signature(
        "Forward dynamics and d/dt [dt; dphi; dv; domega] = A [dt; dphi; dv; domega] + B dF.",
        (
            _array("acceleration", (6,), "m/s^2 and rad/s^2", "[a; alpha], base frame"),
            _array("A", (144,), "mixed", "12 by 12, row-major"),
            _array("B", (72,), "mixed", "12 by 6, row-major"),
        ),
        _further(_struct("stewart_linearisation"), ", in"),
        inputs=FORCES[:1],
    ),
    "inverse_kinematics": Signature(
        "Lengths of the legs and their rates, (2) and (5).",
        (
            _array("L", (6,), "m", "lengths of the legs"),
            _array("L_dot", (6,), "m/s", "their rates; may be null"),
        ),
        "    return @symbol@(@subject@motion, out, out + 6);\n",
    ),
    "forward_kinematics": Signature(
        "The pose that has given lengths of the legs, searched from a guess in `pose`: from one within 0.3 "
        "rad it is the pose beside the guess; from afar another may come out, or STEWART_NOT_CONVERGED after "
        "STEWART_MAX_STEPS steps. STEWART_SINGULAR: the lengths are met, but do not settle the pose.",
        (
            _array("R", (9,), "1", "orientation, row-major: `pose.R`"),
            _array("t", (3,), "m", "position of the reference point: `pose.t`"),
        ),
        """\
    stewart_pose pose;
    int status;
    (void)memcpy(pose.R, in + 6, sizeof pose.R);
    (void)memcpy(pose.t, in + 15, sizeof pose.t);
    status = @symbol@(@subject@in, &pose);
    if (status == STEWART_OK) {
        (void)memcpy(out, pose.R, sizeof pose.R);
        (void)memcpy(out + 9, pose.t, sizeof pose.t);
    }
    return status;
""",
        motion=False,
        inputs=(
            _array("L", (6,), "m", "lengths of the legs"),
            _array("R_guess", (9,), "1", "orientation of the guess, row-major: `pose.R` on entry"),
            _array("t_guess", (3,), "m", "position of the guess: `pose.t` on entry"),
        ),
    ),
    "forward_velocity": Signature(
        "Velocities of the platform from the rates of the legs, (5).",
        (
            _array("v", (3,), "m/s", "velocity of the reference point, base frame"),
            _array("omega", (3,), "rad/s", "angular velocity, base frame"),
        ),
        """\
    stewart_pose pose;
    (void)memcpy(pose.R, in + 6, sizeof pose.R);
    (void)memcpy(pose.t, in + 15, sizeof pose.t);
    return @symbol@(@subject@&pose, in, out, out + 3);
""",
        motion=False,
        inputs=(
            _array("L_dot", (6,), "m/s", "rates of the legs"),
            _array("R", (9,), "1", "orientation of the pose, row-major: `pose.R`"),
            _array("t", (3,), "m", "position of the pose: `pose.t`"),
        ),
    ),
    "motion_from_rpy": Signature(
        "R, omega and alpha of a motion from roll, pitch and yaw, R = Rz Ry Rx, (38), and their rates.",
        _TURNED,
        _TURN.replace("@arguments@", "in, in + 3, in + 6, in + 9"),
        motion=False,
        inputs=(
            _array("sine", (3,), "1", "sines of roll, pitch and yaw"),
            _array("cosine", (3,), "1", "their cosines"),
            _array("theta_dot", (3,), "rad/s", "rates of the angles"),
            _array("theta_ddot", (3,), "rad/s^2", "their second rates"),
        ),
    ),
    "motion_from_quaternion": Signature(
        "R, omega and alpha of a motion from a quaternion, platform to base, scalar first, and its rates.",
        _TURNED,
        _TURN.replace("@arguments@", "in, in + 4, in + 8"),
        motion=False,
        inputs=(
            _array("e", (4,), "1", "quaternion of any length"),
            _array("e_dot", (4,), "1/s", "its rate"),
            _array("e_ddot", (4,), "1/s^2", "its second rate"),
        ),
    ),
}
"""How each function that a kit may hold is called."""
