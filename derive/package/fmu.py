"""FMI 2.0 co-simulation unit (FMU) with a kernel: model description, C code, and documentation page.

The functions take plain data and return texts by path. One list of variables, from the interface table,
determines the description and the C code (variables, order, start values). ``stewart_fmi2.c`` implements the
functions of the standard; ``stewart_unit.h`` contains the code that differs between units.
"""

import hashlib
import itertools
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from html import escape

from ..kernel.interface import CALLS
from ..kernel.tree.constants import STATUSES
from ..mechanics import quantities as n
from ..program.block import AXES, Quantity
from . import kit_license
from .functions import Function, Part
from .robot_source import Machine
from .text_format import Numbers, stored, template

STEP = 0.001
"""Default step size in the description (s)."""

_STATIC = ("stewart_fmi2.h", "stewart_fmi2.c")
_LONGEST_IDENTIFIER = 63
_BASE_UNITS = {"kg": {"kg": 1}, "m": {"m": 1}, "s": {"s": 1}, "rad": {"rad": 1}, "1": {}}
_BASE_UNITS["N"] = {"kg": 1, "m": 1, "s": -2}


@dataclass(frozen=True)
class Variable:
    """Variable of the unit.

    Attributes
    ----------
    name, unit, meaning : str
        Name, unit, and description.
    causality : str
        "input", "output", or "parameter".
    start : float, optional
        Start value; None for an output.
    """

    name: str
    unit: str
    meaning: str
    causality: str
    start: float | None = None


def unit(
    machine: Machine, sources: Mapping[str, str], kernel: Part, precision: str, pose: Numbers
) -> dict[str, str]:
    """Return all texts of the unit, path in the archive -> text, with the C code below ``sources/``.

    The GUID of the unit is a digest of all these texts.

    Parameters
    ----------
    machine : Machine
        Robot. Its payload M, R_0, I_p and gravity g are tunable parameters, unless the kernel is baked.
    sources : mapping
        File name -> text of each .h and .c file of the kernel, including the robot unless it is baked.
    kernel : Part
        Part of the forces.
    precision : str
        "double" or "float", as in ``stewart.h``.
    pose : mapping
        R (3, 3) and t (3,) (m) as start values of the inputs. The pose must have forces, so that the unit
        runs before its inputs are connected. Velocities, accelerations, and loads start at zero.

    Raises
    ------
    ValueError
        If a number is not finite.
    """
    (forces,) = kernel.functions
    variables = _variables(pose, machine.numbers if forces.subject else None)

    def texts(guid: str) -> dict[str, str]:
        common = {
            "version": escape(machine.version),
            "guid": guid,
            "name": escape(machine.name),
            "says": escape(f"{kernel.says} SHA-256 of name and constants: {machine.digest}".strip()),
            "license": escape(kit_license.NOTICE),
        }
        own = {
            **{f"sources/{name}": template(f"kit/{name}", common) for name in _STATIC},
            "sources/stewart_unit.h": _unit_header(machine.symbol, forces, variables, common),
        }
        held = own | {f"sources/{file}": text for file, text in sources.items()}
        compiled = sorted(path.removeprefix("sources/") for path in held if path.endswith(".c"))
        return held | {
            "modelDescription.xml": _description(machine.symbol, variables, compiled, common),
            "documentation/licenses/license.txt": kit_license.TEXT,
            "documentation/index.html": _page(precision, variables, common),
        }

    return texts(_guid(texts("")))


def model_identifier(symbol: str) -> str:
    """Return the identifier of the unit, which is also the name of its binary.

    It is the symbol, shortened if necessary, because Simulink accepts names of up to 63 letters.
    """
    if len(symbol) <= _LONGEST_IDENTIFIER:
        return symbol
    digest = hashlib.sha256(symbol.encode()).hexdigest()[:12]
    return f"{symbol[: _LONGEST_IDENTIFIER - 13]}_{digest}"


# ---------------------------------------------------------------- variables


def _variables(pose: Numbers, payload: Numbers | None) -> list[Variable]:
    """Return the real variables in the order of their value references: inputs, forces, parameters."""
    (force,) = CALLS["forces"].outputs
    # An unconnected input keeps its start value, which must not affect the forces.
    start = {q.name: [0.0] * 3 for q in n.MOTION if q not in (n.R, n.t)} | {
        q.name: pose[q.name] for q in (n.R, n.t) if q.name in pose
    }
    found = [v for q in n.MOTION for v in _components(q, "input", start, "pose")]
    found += [Variable(f"{force.name}[{i + 1}]", force.unit, force.meaning, "output") for i in range(6)]
    if payload is not None:
        found += [v for q in n.PLATFORM for v in _components(q, "parameter", payload, "payload")]
    return found


def _components(quantity: Quantity, causality: str, numbers: Numbers, owner: str) -> list[Variable]:
    unit = quantity.unit.replace(" ", ".").replace("^", "")  # kg.m2, as FMI and Modelica spell it
    return [
        Variable(_variable_name(quantity, key), unit, quantity.meaning, causality, number)
        for key, number in zip(quantity.keys, stored(numbers, quantity, owner), strict=True)
    ]


def _variable_name(quantity: Quantity, key: tuple[int, ...]) -> str:
    if not key:
        return quantity.name
    if quantity.symmetric:
        return f"{quantity.name}.{''.join(AXES[i] for i in key)}"
    return f"{quantity.name}[{','.join(str(i + 1) for i in key)}]"


def _dimension(unit: str) -> dict[str, int]:
    """Return the exponents of the base units of ``kg.m2`` or ``m/s2``."""
    above, _, below = unit.partition("/")
    found: dict[str, int] = {}
    for factors, sign in ((above, 1), (below, -1)):
        for factor in filter(None, factors.split(".")):
            match = re.fullmatch(r"([A-Za-z]+|1)(\d*)", factor)
            assert match is not None, unit
            for base, exponent in _BASE_UNITS[match[1]].items():
                found[base] = found.get(base, 0) + sign * exponent * int(match[2] or 1)
    return found


# ---------------------------------------------------------------- description


def _description(
    symbol: str, variables: Sequence[Variable], files: Sequence[str], common: Mapping[str, str]
) -> str:
    outputs = [i + 1 for i, v in enumerate(variables) if v.causality == "output"]
    outputs.append(len(variables) + 1)
    units = {v.unit: _dimension(v.unit) for v in variables}
    bases = {
        unit: "".join(f' {name}="{exponent}"' for name, exponent in dimension.items() if exponent)
        for unit, dimension in units.items()
    }
    lines = {
        "units": [f'    <Unit name="{unit}"><BaseUnit{base}/></Unit>' for unit, base in bases.items()],
        "files": [f'      <File name="{escape(file)}"/>' for file in files],
        "variables": [_scalar_variable(i, v) for i, v in enumerate(variables)],
        "unknowns": [f'      <Unknown index="{index}"/>' for index in outputs],
        "codes": [escape(f"{code} {text}") for _, code, text in STATUSES],
    }
    values = {
        "identifier": model_identifier(symbol),
        "step": repr(STEP),
        "reference": str(len(variables)),
        **common,
        **{mark: ("; " if mark == "codes" else "\n").join(rows) for mark, rows in lines.items()},
    }
    return template("kit/modelDescription.xml", values)


def _scalar_variable(reference: int, variable: Variable) -> str:
    kind = {"input": "continuous", "output": "continuous", "parameter": "tunable"}[variable.causality]
    start = "" if variable.start is None else f' start="{variable.start!r}"'
    least = ' min="0"' if variable.name == n.M.name else ""
    return (
        f'    <ScalarVariable name="{variable.name}" valueReference="{reference}" '
        f'causality="{variable.causality}" variability="{kind}" description="{escape(variable.meaning)}">\n'
        f'      <Real unit="{variable.unit}"{least}{start}/>\n'
        f"    </ScalarVariable>"
    )


def _page(precision: str, variables: Sequence[Variable], common: Mapping[str, str]) -> str:
    rows = {
        kind: "\n".join(
            f"<tr><td>{v.name}</td><td>{v.unit}</td><td>{escape(v.meaning)}</td></tr>"
            for v in variables
            if v.causality == kind
        )
        for kind in ("input", "output", "parameter")
    }
    of_parameters = "index_parameters.html" if rows["parameter"] else "index_no_parameters.html"
    values = {
        **common,
        "real": precision,
        "inputs": rows["input"],
        "outputs": rows["output"],
        "parameters": template(f"kit/{of_parameters}", {"rows": rows["parameter"]}),
        "status": "\n".join(f"<tr><td>{code}</td><td>{escape(text)}</td></tr>" for _, code, text in STATUSES),
    }
    return template("kit/index.html", values)


def _guid(texts: Mapping[str, str]) -> str:
    """Return a digest of all paths and texts as ``{8-4-4-4-12}`` hexadecimal digits."""
    parts = hashlib.sha256()
    for path, text in sorted(texts.items()):
        for part in (path.encode(), text.encode()):
            parts.update(len(part).to_bytes(8, "big") + part)
    digits = parts.hexdigest()
    cuts = (0, 8, 12, 16, 20, 32)
    groups = [digits[a:b] for a, b in itertools.pairwise(cuts)]
    return "{" + "-".join(groups) + "}"


# ---------------------------------------------------------------- C


def _unit_header(
    symbol: str, forces: Function, variables: Sequence[Variable], common: Mapping[str, str]
) -> str:
    counts = {kind: sum(v.causality == kind for v in variables) for kind in ("input", "output", "parameter")}
    literals = [f"{0.0 if v.start is None else v.start!r}, /* {v.name} */" for v in variables]
    meanings = [f'"{text}", /* STEWART_{code} */' for code, _, text in STATUSES]
    motion, place = _taken(n.MOTION, "motion", 0)
    payload, _ = _taken(n.PLATFORM, "robot", place + counts["output"])
    prefix = forces.symbol.removesuffix("_forces")
    model = {"symbol": symbol, "prefix": prefix, "payload": _continued(payload)}
    values = {
        **common,
        "header": forces.header,
        "model": template("kit/stewart_unit_model.h", model) if forces.subject else "",
        "prefix": prefix,
        "inputs": str(counts["input"]),
        "reals": str(len(variables)),
        "start": _continued(literals),
        "messages": _continued(meanings),
        "motion": _continued(motion),
    }
    return template("kit/stewart_unit.h", values)


def _continued(lines: Iterable[str]) -> str:
    """Join lines of a macro."""
    return " \\\n".join(f"    {line}" for line in lines)


def _taken(quantities: Iterable[Quantity], owner: str, place: int) -> tuple[list[str], int]:
    """Return lines that fill a structure of stewart.h from the unit's values, and the next index."""
    lines = []
    for quantity in quantities:
        count = len(quantity.keys)
        to = f"{owner}.{quantity.name}" if quantity.shape else f"&{owner}.{quantity.name}"
        lines.append(f"narrowed(value + {place}, {count}, {to});")
        place += count
    return lines, place
