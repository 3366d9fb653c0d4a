"""``stewart.h``: arithmetic, status codes and structs, the same for every kernel."""

from ..kernel.interface import STATUS, STRUCTS, Member
from ..mechanics.quantities import LEG, MOTION, PLATFORM
from ..print.template import filled
from .thresholds import comment

_MATRICES = {q.name: q for q in (*LEG, *PLATFORM, *MOTION) if len(q.shape) == 2}


def common_header(version: str, precision: str = "double") -> str:
    """``stewart.h``; precision: "float" where it defines float by itself, as that of a float kit does."""
    structs = {name: "\n".join(map(_member, members)) for name, members in STRUCTS.items()}
    arrays = {f"{name}_arrays": _pointers(name) for name in ("forces", "reactions")}
    return filled(
        "stewart.h",
        version=version,
        release=version.partition(" ")[0],
        thresholds=comment(),
        status="\n".join(f"#define STEWART_{name} {code} /* {text} */" for name, code, text in STATUS),
        motions=_pointers("motion", "const "),
        own_type=filled("float.h") if precision == "float" else "",
        **structs,
        **arrays,
    )


def _member(member: Member) -> str:
    quantity = _MATRICES.get(member.name) if len(member.stored) == 1 else None
    order = "" if quantity is None else ", order xx xy xz yy yz zz" if quantity.symmetric else ", row-major"
    return f"    stewart_real {member.name}{member.dims}; /* {member.unit}: {member.meaning}{order} */"


def _pointers(struct: str, const: str = "") -> str:
    return "\n".join(
        f"    {const}stewart_real *{each.name}; /* [count]{each.dims} */" for each in STRUCTS[struct]
    )
