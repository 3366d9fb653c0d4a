"""FMI 2.0 co-simulation unit (FMU) with a kernel: model description, C code, and documentation page.

The functions take plain data and return texts by path. One list of variables, from the interface table,
determines the description and the C code (variables, order, start values). ``stewart_fmi2.c`` implements the
functions of the standard and contains the computation of the unit's kind; ``stewart_unit.h`` contains names
and numbers that differ between robots.
"""

import hashlib
import itertools
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from html import escape

from ..kernel.interface import CALLS, STRUCTS, Member
from ..mechanics import quantities as n
from ..mechanics.orientation import RATE, SECOND
from ..program.block import AXES, Quantity
from ..trace.constants import STATUSES
from . import kit_license
from .functions import MODEL, Function, Part, includes
from .robot_source import Machine
from .text_format import Numbers, stored, template

STEP = 0.001
"""Default step size in the description (s)."""

_STATIC = ("stewart_fmi2.h", "stewart_fmi2.c")
_LONGEST_IDENTIFIER = 63
_BASE_UNITS = {"kg": {"kg": 1}, "m": {"m": 1}, "s": {"s": 1}, "rad": {"rad": 1}, "1": {}}
_BASE_UNITS |= {"A": {"A": 1}, "N": {"kg": 1, "m": 1, "s": -2}}

FORCES, FORCES_RPY, PLANT = "forces", "forces-rpy", "plant"
KINDS = (FORCES, FORCES_RPY, PLANT)
"""Kinds of units: forces of a motion, with a rotation matrix or with angles, and forward dynamics."""

_THETA = Quantity("theta", (3,), "rad", "roll, pitch, and yaw, R = Rz(theta_z) Ry(theta_y) Rx(theta_x)")
_MAX_STEP = Quantity("max_step", (), "s", "largest step of the integration, > 0")
_MAX_STEP_START = 0.001
_ANGLES = {n.R.name: _THETA, n.omega.name: RATE, n.alpha.name: SECOND}
# The order of the state in stewart_unit_plant.c.
_STATE = (n.t, _THETA, n.v, n.omega)


@dataclass(frozen=True)
class Texts:
    """Texts about one kind of unit: title, description, and meaning of a status other than 0."""

    title: str
    says: str
    status: str


_OF_FORCES = Texts(
    "actuator forces",
    "The unit has no states: a step of any length computes the outputs from the inputs at its start, and "
    "sets them at its end. During initialization they are computed from the current inputs. If R is an "
    "input, it must be a rotation, which is not checked. Unconnected velocities, accelerations, and loads "
    "are zero.",
    "If the status is not 0, the outputs keep their previous values, initially 0",
)
_OF_PLANT = Texts(
    "forward dynamics",
    "A step integrates the state by Runge-Kutta steps of at most max_step under constant forces and loads. "
    "The forces F act on the legs; friction of the drives is not included. Limits and singular poses are not "
    "checked. An unconnected input is zero. Initial values (_start) change only before a run.",
    "If the status is not 0, the integration has stopped, and the outputs keep the last state with a "
    "solution until the unit is reset",
)


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
    fixed : bool
        True for a parameter that does not change after initialization.
    """

    name: str
    unit: str
    meaning: str
    causality: str
    start: float | None = None
    fixed: bool = False

    @property
    def array(self) -> str:
        """Name without the index of the component."""
        return re.split(r"[\[.]", self.name)[0]


def unit(
    machine: Machine,
    kind: str,
    parts: Sequence[Part],
    sources: Mapping[str, str],
    precision: str,
    pose: Numbers,
) -> dict[str, str]:
    """Return all texts of the unit, path in the archive -> text, with the C code below ``sources/``.

    The GUID of the unit is a digest of all these texts.

    Parameters
    ----------
    machine : Machine
        Robot. Its payload M, R_0, I_p and gravity g are tunable parameters, unless the kernel is baked. If it
        has drives, units of the forces also have motor torques as outputs.
    kind : str
        One of ``KINDS``.
    parts : sequence of Part
        Parts of the unit; the first one is described.
    sources : mapping
        File name -> text of each .h and .c file of the parts, including the robot if a function reads it.
    precision : str
        "double" or "float", as in ``stewart.h``.
    pose : mapping
        R (3, 3), t (3,) (m), and theta (3,) (rad) as start values of the inputs or the state. The pose must
        have forces, so that the unit runs before its inputs are connected. Other values start at zero.

    Raises
    ------
    ValueError
        If a number is not finite.
    """
    functions = {each.stem: each for part in parts for each in part.functions}
    variables = _variables(kind, pose, machine, _kernel(kind, functions).subject == MODEL)
    about = _OF_PLANT if kind == PLANT else _OF_FORCES

    def texts(guid: str) -> dict[str, str]:
        common = {
            "version": escape(machine.version),
            "guid": guid,
            "name": escape(machine.name),
            "title": about.title,
            "says": escape(f"{parts[0].says} SHA-256 of name and constants: {machine.digest}".strip()),
            "about": escape(about.says),
            "status_meaning": about.status,
            "license": escape(kit_license.NOTICE),
            "solve": template(f"kit/stewart_unit_{'plant' if kind == PLANT else 'forces'}.c"),
        }
        own = {
            **{f"sources/{name}": template(f"kit/{name}", common) for name in _STATIC},
            "sources/stewart_unit.h": _unit_header(machine, kind, functions, variables, common),
        }
        held = own | {f"sources/{file}": text for file, text in sources.items()}
        compiled = sorted(path.removeprefix("sources/") for path in held if path.endswith(".c"))
        return held | {
            "modelDescription.xml": _description(machine.symbol, variables, compiled, common),
            "documentation/licenses/license.txt": kit_license.TEXT,
            "documentation/index.html": _page(precision, variables, common),
        }

    return texts(_guid(texts("")))


def _kernel(kind: str, functions: Mapping[str, Function]) -> Function:
    """Return the function of the dynamics, out of the functions by stem."""
    return functions["forward_dynamics" if kind == PLANT else "forces"]


def model_identifier(symbol: str) -> str:
    """Return the identifier of the unit, which is also the name of its binary.

    It is the symbol, shortened if necessary, because Simulink accepts names of up to 63 letters.
    """
    if len(symbol) <= _LONGEST_IDENTIFIER:
        return symbol
    digest = hashlib.sha256(symbol.encode()).hexdigest()[:12]
    return f"{symbol[: _LONGEST_IDENTIFIER - 13]}_{digest}"


# ---------------------------------------------------------------- variables


def _variables(kind: str, pose: Numbers, machine: Machine, has_payload: bool) -> list[Variable]:
    """Return the real variables in the order of their value references: inputs, outputs, parameters."""
    (force,) = CALLS["forces"].outputs
    # An unconnected input keeps its start value, which must not affect the forces.
    zero = {q.name: [0.0] * 3 for q in (*n.MOTION, RATE, SECOND)}
    start = {**zero, _MAX_STEP.name: _MAX_STEP_START, **pose}
    payload = _several(n.PLATFORM, "parameter", machine.numbers, "robot") if has_payload else []
    if kind == PLANT:
        legs = {member.name: member for member in STRUCTS["legs"]}
        return [
            *_six(force, "input"),
            *_several((n.F_ext, n.M_ext), "input", start),
            *_several((n.R, *_STATE), "output"),
            *_six(legs["L"], "output"),
            *_six(legs["L_dot"], "output"),
            *payload,
            *_several((_MAX_STEP,), "parameter", start),
            *(variable for quantity in _STATE for variable in _initial(quantity, start)),
        ]
    angles = _ANGLES if kind == FORCES_RPY else {}
    motion = [angles.get(quantity.name, quantity) for quantity in n.MOTION]
    motors = []
    if machine.drives is not None:
        torque, current = CALLS["motor_torques"].outputs
        motors = [*_six(torque, "output"), *_six(current, "output", _legs_with_current(machine))]
    return [*_several(motion, "input", start), *_six(force, "output"), *motors, *payload]


def _legs_with_current(machine: Machine) -> list[int]:
    """Return the indices of the legs whose motors have a torque constant."""
    constants = () if machine.drives is None else machine.drives["torque_constant"]
    return [i for i, constant in enumerate(constants) if constant > 0.0]


def _six(member: Member, causality: str, legs: Iterable[int] = range(6)) -> list[Variable]:
    """Return the variables of one number per leg."""
    start = None if causality == "output" else 0.0
    unit, meaning = _spelled(member.unit), member.meaning.removesuffix(", 0 without one; may be null")
    return [Variable(f"{member.name}[{i + 1}]", unit, meaning, causality, start) for i in legs]


def _several(
    quantities: Iterable[Quantity], causality: str, numbers: Numbers | None = None, owner: str = "pose"
) -> list[Variable]:
    """Return the variables of quantities; without ``numbers`` they have no start values."""
    found = []
    for q in quantities:
        values = [None] * len(q.keys) if numbers is None else stored(numbers, q, owner)
        for key, value in zip(q.keys, values, strict=True):
            found.append(Variable(_variable_name(q, key), _spelled(q.unit), q.meaning, causality, value))
    return found


def _initial(quantity: Quantity, start: Numbers) -> list[Variable]:
    """Return the parameters for the initial value of a quantity of the state."""
    meaning = f"initial value: {quantity.meaning}"
    return [
        replace(each, name=each.name.replace("[", "_start["), meaning=meaning, fixed=True)
        for each in _several((quantity,), "parameter", start)
    ]


def _spelled(unit: str) -> str:
    """Spell a unit as FMI and Modelica do, such as kg.m2."""
    return unit.replace(" ", ".").replace("^", "")


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
    of_parameter = "fixed" if variable.fixed else "tunable"
    kind = {"input": "continuous", "output": "continuous", "parameter": of_parameter}[variable.causality]
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
        "statuses": "\n".join(
            f"<tr><td>{code}</td><td>{escape(text)}</td></tr>" for _, code, text in STATUSES
        ),
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
    machine: Machine,
    kind: str,
    functions: Mapping[str, Function],
    variables: Sequence[Variable],
    common: Mapping[str, str],
) -> str:
    counts = {kind: sum(v.causality == kind for v in variables) for kind in ("input", "output", "parameter")}
    places: dict[str, int] = {}
    for place, variable in enumerate(variables):
        places.setdefault(variable.array, place)
    kernel = _kernel(kind, functions)
    names = {"KERNEL": kernel.symbol}
    taken = {} if kind == PLANT else {"MOTION(value, motion)": _taken(n.MOTION, "motion", places)}
    if kernel.subject == MODEL:
        names |= {"MODEL": f"{kernel.prefix}_model", "PREPARE": f"{kernel.prefix}_prepare"}
        taken["PAYLOAD(value, robot)"] = _taken(n.PLATFORM, "robot", places)
    if kernel.subject == MODEL or machine.drives is not None:
        names["ROBOT"] = machine.symbol
    if machine.drives is not None:
        names["DRIVES"] = f"{machine.symbol}_drives"
    if "current" in places:
        names["CURRENT_LEGS"] = f"{{{', '.join(map(str, _legs_with_current(machine)))}}}"
    if "axial_forces" in functions:
        names["AXIAL"] = functions["axial_forces"].symbol
    literals = [f"{0.0 if v.start is None else v.start!r}, /* {v.name} */" for v in variables]
    meanings = [f'"{text}", /* STEWART_{code} */' for code, _, text in STATUSES]
    values = {
        **common,
        "includes": includes(list(functions.values())),
        "names": "\n".join(f"#define {name} {value}" for name, value in names.items()),
        "inputs": str(counts["input"]),
        "outputs": str(counts["output"]),
        "fixed": str(sum(not v.fixed for v in variables)),
        "reals": str(len(variables)),
        "places": "\n".join(f"#define AT_{name.upper()} {place}u" for name, place in places.items()),
        "start": _continued(literals),
        "messages": _continued(meanings),
        "taken": "".join(f"\n#define TAKE_{name} \\\n{_continued(lines)}\n" for name, lines in taken.items()),
    }
    return template("kit/stewart_unit.h", values)


def _continued(lines: Iterable[str]) -> str:
    """Join lines of a macro."""
    return " \\\n".join(f"    {line}" for line in lines)


def _taken(quantities: Iterable[Quantity], owner: str, places: Mapping[str, int]) -> list[str]:
    """Return lines that fill members of a structure of stewart.h from the variables of the same names."""
    lines = []
    for quantity in quantities:
        if quantity.name in places:
            to = f"{owner}.{quantity.name}" if quantity.shape else f"&{owner}.{quantity.name}"
            lines.append(f"narrowed(value + AT_{quantity.name.upper()}, {len(quantity.keys)}, {to});")
    return lines
