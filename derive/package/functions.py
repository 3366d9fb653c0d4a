"""The functions of a kit, their test vectors, and its parts, each a header and source with some functions."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ..kernel.interface import CALLS, Call, Member
from ..mechanics import quantities as n
from .robot import HEADER
from .text_format import Numbers

ROBOT, MODEL, DRIVES, NOTHING = "robot", "model", "drives", ""


@dataclass(frozen=True)
class Function:
    """A function of a kit: its stem in ``interface.CALLS``, C name, header, what its first argument is.

    subject: ROBOT, MODEL (``prefix`` + ``_model``, made by ``prefix`` + ``_prepare``), DRIVES or NOTHING.
    operations: their number per pose, in words. plain: of a kernel with a robot's numbers folded in, the C
    name of the same function without them. one_pose: whether the kernel computes one pose at a time.
    """

    stem: str
    symbol: str
    header: str
    subject: str
    prefix: str = ""
    operations: str = ""
    plain: str = ""
    one_pose: bool = False

    @property
    def call(self) -> Call:
        """Arguments and outputs."""
        return CALLS[self.stem]

    @property
    def batch(self) -> bool:
        """Whether there is ``<symbol>_batch`` as well."""
        return self.call.has_batch and not self.one_pose

    @property
    def prototypes(self) -> list[str]:
        """Declarations of the function and its batches, without macros such as STEWART_NODISCARD."""
        types = {ROBOT: "stewart_robot", DRIVES: "stewart_drives", MODEL: f"{self.prefix}_model"}
        subject = f"const {types[self.subject]} *{self.subject}" if self.subject else ""
        return self.call.prototypes(self.symbol, subject, self.batch)

    def subject_argument(self, of_robot: str, of_model: str, of_drives: str) -> str:
        """The first argument of a call, given those of a robot, model and drives, with the comma after it."""
        subjects = {ROBOT: f"{of_robot}, ", MODEL: f"{of_model}, ", DRIVES: f"{of_drives}, ", NOTHING: ""}
        return subjects[self.subject]


@dataclass(frozen=True)
class Part:
    """One header and source of a kit.

    name: of both, without the ending. files: file name -> text. kinds: some of ``deviations.KINDS``, by which
    deviations from MISRA C are listed. says: a line for the README. shared: headers that its source shares
    with others.
    """

    name: str
    files: Mapping[str, str]
    functions: tuple[Function, ...]
    kinds: tuple[str, ...]
    says: str
    shared: tuple[str, ...]

    @property
    def header(self) -> str:
        """File name of the header."""
        return f"{self.name}.h"

    @property
    def source(self) -> str:
        """File name of the source."""
        return f"{self.name}.c"


@dataclass(frozen=True)
class Vector:
    """One call of one function: inputs, answers, how far from them rounding may take the C.

    function: its name without prefix. inputs: flat arrays by name, exactly representable in the precision:
    R (9,), t, omega, v, alpha, a, F_ext, M_ext (3,), the fields of ``stewart_motion``; where the function
    needs them F, axial, L, L_dot, bearing (6,), R_guess (9,), t_guess (3,), sine, cosine, theta_dot,
    theta_ddot (3,), e, e_dot, e_ddot (4,). answers: flat arrays by member of the
    C struct, in its order, of 50 digits rounded to the nearest double. bounds: of the same shapes, > 0, the
    largest error by rounding in rounding units: to be multiplied by the epsilon of the precision. ordinary:
    whether its motion is one that a machine may make. status: other than 0 without answers.
    """

    function: str
    inputs: dict[str, Any]
    answers: dict[str, Any]
    bounds: dict[str, Any]
    ordinary: bool = True
    status: int = 0

    @property
    def motion(self) -> Numbers | None:
        """Fields of a ``stewart_motion``, R as (3, 3), what is not read at rest; None where none is read."""
        if not CALLS[self.function].motion:
            return None
        fields = {q.name: list(map(float, self.inputs.get(q.name, (0.0,) * 3))) for q in n.MOTION}
        return fields | {n.R.name: [fields[n.R.name][i : i + 3] for i in (0, 3, 6)]}


def flat(arrays: Numbers, members: Iterable[Member]) -> list[float]:
    """Numbers of a vector in the order of a call."""
    return [float(number) for each in members for number in arrays[each.name]]


def reads_robot(functions: Iterable[Function]) -> bool:
    """Whether some function takes the robot, its model or its drives."""
    return any(function.subject != NOTHING for function in functions)


def includes(functions: Sequence[Function]) -> str:
    """Lines of C that include what callers of the functions need."""
    headers = [*([HEADER] if reads_robot(functions) else []), *(function.header for function in functions)]
    return "".join(f'#include "{header}"\n' for header in dict.fromkeys(headers))
