"""Interface table in C, ``stewart.h`` of all kernels, and in Python, ``interface.py``."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from ..kernel.interface import CALLS, STRUCTS, Member
from ..mechanics.quantities import MOTION, OF_LEG, PLATFORM
from ..print.template import filled
from ..trace.constants import STATUSES

_MORE = {"NOT_CONVERGED": ", or R of the guess is not a rotation"}
"""Causes of a status in addition to its text."""
_MATRICES = {q.name: q for q in (*OF_LEG, *PLATFORM, *MOTION) if len(q.shape) == 2}


def common_header(version: str, precision: str = "double", rotors: bool = False) -> str:
    """Return ``stewart.h``.

    Parameters
    ----------
    precision : str
        "float" if the header defines float itself, as in a float kit.
    rotors : bool
        True if the header defines that legs have rotors.
    """
    structs = {name: "\n".join(map(member_text, members)) for name, members in STRUCTS.items()}
    arrays = {f"{name}_arrays": _pointers(name) for name in ("forces", "reactions")}
    return filled(
        "stewart.h",
        version=version,
        release=version.partition(" ")[0],
        thresholds=_thresholds(),
        status="\n".join(
            f"#define STEWART_{name} {code} /* {text}{_MORE.get(name, '')} */"
            for name, code, text in STATUSES
        ),
        motions=_pointers("motion", "const "),
        own_type=filled("float.h") if precision == "float" else "",
        own_legs=filled("own_rotors.h") if rotors else "",
        **structs,
        **arrays,
    )


def member_text(member: Member) -> str:
    """Print the declaration of a struct member with unit and meaning."""
    quantity = _MATRICES.get(member.name) if len(member.stored) == 1 else None
    order = "" if quantity is None else ", order xx xy xz yy yz zz" if quantity.symmetric else ", row-major"
    return f"    stewart_real {member.name}{member.dims}; /* {member.unit}: {member.meaning}{order} */"


def _pointers(struct: str, const: str = "") -> str:
    return "\n".join(
        f"    {const}stewart_real *{each.name}; /* [count]{each.dims} */" for each in STRUCTS[struct]
    )


def layout(models: Mapping[str, int], headers: Iterable[str], version: str) -> str:
    """Return ``interface.py``.

    Parameters
    ----------
    models : mapping
        Count of numbers in the prepared model of each kernel.
    headers : iterable of str
        Headers that sources share.
    """
    return filled(
        "interface.py",
        version=version,
        status="\n".join(f'    "{name}": ({code}, "{text}"),' for name, code, text in STATUSES),
        structs=_shapes(STRUCTS),
        outputs=_shapes({stem: call.outputs for stem, call in CALLS.items()}),
        headers="\n".join(f'    "{name}",' for name in headers),
        models="\n".join(f'    "{name}": {count},' for name, count in sorted(models.items())),
    )


def _shapes(groups: Mapping[str, Iterable[Member]]) -> str:
    return "\n".join(
        "\n".join([f'    "{name}": {{', *(f'        "{m.name}": {m.shape},' for m in members), "    },"])
        for name, members in groups.items()
    )


# ---------------------------------------------------------------- thresholds of the statuses
# Results of ``stewart-sym stability``, a sweep over random poses near failure: largest errors of the kernels
# within each threshold. The tests compare them with the last run of the sweep.


@dataclass(frozen=True)
class Threshold:
    """Threshold of one status.

    Attributes
    ----------
    status : str
        Name of the status.
    kind : str
        Kind of failure in the sweep.
    begins : str
        Threshold in words.
    worst : int
        Largest error with status OK, in rounding units times the condition number of the problem, rounded up.
    where : str
        Distance from the failure at which this error occurred.
    """

    status: str
    kind: str
    begins: str
    worst: int
    where: str


CASES = 1_000_000
"""Number of random poses of the sweep, in double."""

THRESHOLDS = (
    Threshold(
        "ZERO_LENGTH",
        "zero-length leg",
        "leg shorter than 16 rounding units of the vectors in its sum",
        5,
        "7.9e-02",
    ),
    Threshold(
        "JOINT_SINGULAR",
        "joint singularity",
        "sine between leg and fixed axis below 4096 rounding units",
        15,
        "4.9e-02",
    ),
    Threshold(
        "SINGULAR",
        "singular",
        "spectral radius of |inverse of H| times the error bounds of H above 1/2",
        10,
        "7.1e-09",
    ),
)


def _thresholds() -> str:
    """Print the thresholds as lines of a C comment."""
    lines = [
        "Thresholds of the statuses, and the largest error of results with STEWART_OK for",
        f"10^{len(str(CASES)) - 1} random poses near a failure (`stewart-sym stability`), in rounding units",
        "times the condition number of the problem, with the relative distance of the pose from the failure.",
        *(
            f"STEWART_{each.status}: {each.begins}; error {each.worst} at the distance {each.where}"
            for each in THRESHOLDS
        ),
    ]
    return "/* " + "\n * ".join(lines) + " */"
