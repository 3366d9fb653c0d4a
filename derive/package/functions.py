"""Functions of a kit, their test vectors, and the parts of a kit, each a header and a source."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ..kernel.interface import CALLS, Call, Member
from ..mechanics import quantities as n
from .robot_source import HEADER
from .text_format import Numbers

ROBOT, MODEL, DRIVES, NOTHING = "robot", "model", "drives", ""


@dataclass(frozen=True)
class Function:
    """Function of a kit.

    Attributes
    ----------
    stem : str
        Key in ``interface.CALLS``.
    symbol, header : str
        Name in C, and file name of the header.
    subject : str
        Type of the first argument: ROBOT, MODEL (``prefix`` + ``_model``, filled by ``prefix`` +
        ``_prepare``), DRIVES, or NOTHING.
    prefix : str
        Prefix of the model and its preparation.
    operations : str
        Number of operations per pose, as text.
    plain : str
        For a baked kernel, the C name of the same function without baked constants.
    one_pose : bool
        True if the kernel computes one pose at a time.
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
        """True if there is also a function ``<symbol>_batch``."""
        return self.call.has_batch and not self.one_pose

    @property
    def prototypes(self) -> list[str]:
        """Declarations of the function and its batches, without macros such as STEWART_NODISCARD."""
        types = {ROBOT: "stewart_robot", DRIVES: "stewart_drives", MODEL: f"{self.prefix}_model"}
        subject = f"const {types[self.subject]} *{self.subject}" if self.subject else ""
        return self.call.prototypes(self.symbol, subject, self.batch)

    def subject_argument(self, of_robot: str, of_model: str, of_drives: str) -> str:
        """Return the first argument of a call and a comma, out of the texts for robot, model, and drives."""
        subjects = {ROBOT: f"{of_robot}, ", MODEL: f"{of_model}, ", DRIVES: f"{of_drives}, ", NOTHING: ""}
        return subjects[self.subject]


@dataclass(frozen=True)
class Part:
    """Header and source of a kit.

    Attributes
    ----------
    name : str
        File name of both without the extension.
    files : mapping
        File name -> text.
    functions : tuple of Function
        Functions.
    kinds : tuple of str
        Some of ``misra_deviations.KINDS``, which select the listed deviations from MISRA C.
    says : str
        Line for the README.
    shared : tuple of str
        Headers that the source shares with other sources.
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
    """Test vector: one call of one function with inputs, expected results, and tolerances.

    Attributes
    ----------
    function : str
        Name of the function without prefix.
    inputs : dict
        Flat arrays by name, exactly representable in the precision. R (9,), t, omega, v, alpha, a, F_ext,
        M_ext (3,) are the fields of ``stewart_motion``. Some functions also have F, axial, L, L_dot, bearing
        (6,), R_guess (9,), t_guess (3,), sine, cosine, theta_dot, theta_ddot (3,), or e, e_dot, e_ddot (4,).
    answers : dict
        Flat arrays by member of the C struct, in its order: results with 50 digits, rounded to the nearest
        double. Empty for a status other than 0.
    bounds : dict
        Tolerances of ``answers``, > 0, in units of the epsilon of the precision.
    ordinary : bool
        True if a machine may perform the motion.
    status : int
        Expected status.
    """

    function: str
    inputs: dict[str, Any]
    answers: dict[str, Any]
    bounds: dict[str, Any]
    ordinary: bool = True
    status: int = 0

    @property
    def motion(self) -> Numbers | None:
        """Fields of a ``stewart_motion`` with R as (3, 3), or None if the function reads no motion.

        Fields that are not read are zero.
        """
        if not CALLS[self.function].motion:
            return None
        fields = {q.name: list(map(float, self.inputs.get(q.name, (0.0,) * 3))) for q in n.MOTION}
        return fields | {n.R.name: [fields[n.R.name][i : i + 3] for i in (0, 3, 6)]}


def flat(arrays: Numbers, members: Iterable[Member]) -> list[float]:
    """Return the numbers of a vector in the order of a call."""
    return [float(number) for each in members for number in arrays[each.name]]


def reads_robot(functions: Iterable[Function]) -> bool:
    """Return True if a function takes the robot, its model, or its drives."""
    return any(function.subject != NOTHING for function in functions)


def includes(functions: Sequence[Function]) -> str:
    """Return C lines that include the headers of the functions."""
    headers = [*([HEADER] if reads_robot(functions) else []), *(function.header for function in functions)]
    return "".join(f'#include "{header}"\n' for header in dict.fromkeys(headers))
