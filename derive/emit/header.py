"""The interface table as C and as Python: ``stewart.h``, the same for every kernel, and ``interface.py``."""

from collections.abc import Iterable, Mapping

from ..kernel.interface import CALLS, STRUCTS, Member
from ..kernel.tree.statuses import STATUS
from ..mechanics.quantities import MOTION, OF_LEG, PLATFORM
from ..print.template import filled
from .thresholds import comment

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
        thresholds=comment(),
        status="\n".join(f"#define STEWART_{name} {code} /* {text} */" for name, code, text in STATUS),
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
        status="\n".join(f'    "{name}": ({code}, "{text}"),' for name, code, text in STATUS),
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
