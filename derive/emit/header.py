"""The interface table as C and as Python: ``stewart.h``, the same for every kernel, and ``interface.py``."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from ..kernel.interface import CALLS, STRUCTS, Member
from ..kernel.tree.constants import STATUSES
from ..mechanics.quantities import MOTION, OF_LEG, PLATFORM
from ..print.template import filled

_MATRICES = {q.name: q for q in (*OF_LEG, *PLATFORM, *MOTION) if len(q.shape) == 2}


def common_header(version: str, precision: str = "double", rotors: bool = False) -> str:
    """``stewart.h``; precision: "float" where it defines float by itself, as that of a float kit does;
    rotors: where it defines by itself that legs have them."""
    structs = {name: "\n".join(map(member_text, members)) for name, members in STRUCTS.items()}
    arrays = {f"{name}_arrays": _pointers(name) for name in ("forces", "reactions")}
    return filled(
        "stewart.h",
        version=version,
        release=version.partition(" ")[0],
        thresholds=_thresholds(),
        status="\n".join(f"#define STEWART_{name} {code} /* {text} */" for name, code, text in STATUSES),
        motions=_pointers("motion", "const "),
        own_type=filled("float.h") if precision == "float" else "",
        own_legs=filled("own_rotors.h") if rotors else "",
        **structs,
        **arrays,
    )


def member_text(member: Member) -> str:
    """A member of a struct as C declares it, with unit and meaning."""
    quantity = _MATRICES.get(member.name) if len(member.stored) == 1 else None
    order = "" if quantity is None else ", order xx xy xz yy yz zz" if quantity.symmetric else ", row-major"
    return f"    stewart_real {member.name}{member.dims}; /* {member.unit}: {member.meaning}{order} */"


def _pointers(struct: str, const: str = "") -> str:
    return "\n".join(
        f"    {const}stewart_real *{each.name}; /* [count]{each.dims} */" for each in STRUCTS[struct]
    )


def layout(models: Mapping[str, int], headers: Iterable[str], version: str) -> str:
    """``interface.py``; models: how many numbers each kernel's prepared model holds. headers: those that
    sources share."""
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


# ---------------------------------------------------------------- where a status begins
# Figures of the sweep over random poses near failure that ``stewart-sym stability`` makes: what the kernels
# were seen to do on this side of each threshold. The tests hold them to the sweep's last run.


@dataclass(frozen=True)
class Threshold:
    """Where one status begins.

    status: its name. kind: of near failure, as the sweep calls it. begins: in words. worst: largest error
    seen with status ok, in rounding units times the condition number of the problem itself, rounded up;
    where: at which distance from the failure that was.
    """

    status: str
    kind: str
    begins: str
    worst: int
    where: str


CASES = 1_000_000
"""Random poses of the sweep, in double."""

THRESHOLDS = (
    Threshold(
        "ZERO_LENGTH",
        "zero-length leg",
        "within 16 rounding units of the vectors it is the sum of",
        7,
        "2.2e-01",
    ),
    Threshold("JOINT_SINGULAR", "joint singularity", "sine below 4096 rounding units", 10, "5.9e-02"),
    Threshold(
        "SINGULAR",
        "singular",
        "spectral radius of |1/H| times the bounds of its errors above 1/2",
        10,
        "1.6e-10",
    ),
)


def _thresholds() -> str:
    """The thresholds as lines of a C comment."""
    lines = [
        f"Where a status begins, and the worst error seen on this side of it among 10^{len(str(CASES)) - 1}",
        "random poses near failure, in rounding units times the condition number of the problem itself, at",
        "which distance from the failure (`stewart-sym stability`):",
        *(f"STEWART_{each.status}: {each.begins}; {each.worst}, at {each.where}" for each in THRESHOLDS),
    ]
    return "/* " + "\n * ".join(lines) + " */"
