"""The functions and parts of a kit; a part is one header and source with some functions."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from ..kernel.interface import CALLS, Call
from .robot import HEADER

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


def reads_robot(functions: Iterable[Function]) -> bool:
    """Whether some function takes the robot, its model or its drives."""
    return any(function.subject != NOTHING for function in functions)


def includes(functions: Sequence[Function]) -> str:
    """Lines of C that include what callers of the functions need."""
    headers = [*([HEADER] if reads_robot(functions) else []), *(function.header for function in functions)]
    return "".join(f'#include "{header}"\n' for header in dict.fromkeys(headers))
