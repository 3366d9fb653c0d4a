"""An FMI 2.0 co-simulation unit around a kernel: its description, its C and its page.

Stands beside ``kit``, whose files the unit holds; takes plain data and hands back text by path. What is in
the description and in the C (variables, order, start values) comes from one list, made of the notation. Knows
the standard's names and binary interface; nothing of compilers, of archives or of how forces are computed.
"""

import hashlib
import itertools
import math
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from typing import Any

from ... import notation as n
from ...block import AXES, Quantity
from ..c import FORCES, STATUS
from . import licence
from . import robot as robot_text

Numbers = Mapping[str, Any]
"""Quantity name -> number or nested lists of numbers."""

STEP = 0.001
"""Step that the description proposes, s."""

_LONGEST_IDENTIFIER = 63
_BASE_UNITS = {"kg": {"kg": 1}, "m": {"m": 1}, "s": {"s": 1}, "rad": {"rad": 1}, "1": {}}
_BASE_UNITS["N"] = {"kg": 1, "m": 1, "s": -2}


@dataclass(frozen=True)
class UnitKernel:
    """How the unit calls the kernel.

    header: the file that declares it. prefix: of its functions, as ``stewart_exact``. baked: there is
    ``<prefix>_forces`` alone, without a ``<prefix>_model`` that ``<prefix>_prepare`` makes. precision:
    "double" or "float", that of ``stewart.h``. says: lines about it, plain text.
    """

    header: str
    prefix: str
    baked: bool = False
    precision: str = "double"
    says: str = ""


@dataclass(frozen=True)
class Variable:
    """A variable of the unit; start: None for what the unit computes."""

    name: str
    unit: str
    meaning: str
    causality: str
    start: float | None = None


def unit(
    name: str,
    symbol: str,
    sources: Mapping[str, str],
    kernel: UnitKernel,
    pose: Numbers,
    payload: Numbers | None,
    digest: str,
    version: str,
) -> dict[str, str]:
    """All texts of the unit: path in the archive -> text; the C lies below ``sources/``.

    name: the robot's. symbol: the identifier of its constants, also of the unit. sources: file name -> text
    of the C that the kernel needs, the robot's too unless it is baked. pose:
    R (3, 3) and t (3,), that the inputs have until they are set; rates, accelerations and loads start at
    zero. payload: M, R_0, I_p and g, the tunable parameters; None for a baked kernel. digest: of name and
    constants. version: of the generator.

    The unit's GUID is a digest of all of these texts. Raises ValueError naming a number that is missing or
    not finite, or a file that is missing.
    """
    bare = kernel.baked
    if bare != (payload is None):
        raise ValueError(f"payload: expected {'None' if bare else 'M, R_0, I_p and g'} for this kernel")
    for file in (kernel.header, *(() if bare else (robot_text.HEADER, robot_text.SOURCE))):
        if file not in sources:
            raise ValueError(f"sources: expected {file} among them")
    variables = _variables(pose, payload)

    def texts(guid: str) -> dict[str, str]:
        common = {"VERSION": escape(version), "GUID": guid}
        own = {
            "sources/stewart_fmi2.h": _header(common),
            "sources/stewart_fmi2.c": _source(symbol, kernel, variables, common),
        }
        held = own | {f"sources/{file}": text for file, text in sources.items()}
        compiled = sorted(path.removeprefix("sources/") for path in held if path.endswith(".c"))
        return held | {
            "modelDescription.xml": _description(name, symbol, kernel, variables, compiled, digest, common),
            "documentation/licenses/license.txt": licence.TEXT,
            "documentation/index.html": _page(name, kernel, variables, digest, common),
        }

    return texts(_guid(texts("")))


def model_identifier(symbol: str) -> str:
    """The unit's identifier, which is also the name of its binary: the symbol, shortened if it is long.

    Simulink takes names of up to 63 letters.
    """
    if len(symbol) <= _LONGEST_IDENTIFIER:
        return symbol
    digest = hashlib.sha256(symbol.encode()).hexdigest()[:12]
    return f"{symbol[: _LONGEST_IDENTIFIER - 13]}_{digest}"


# ---------------------------------------------------------------- variables


def _variables(pose: Numbers, payload: Numbers | None) -> list[Variable]:
    """The reals by value reference: inputs, forces, parameters."""
    force, _ = FORCES[0]
    # An input that nobody connects keeps its start value, and must add nothing to the forces.
    start = {q.name: [0.0] * 3 for q in n.MOTION if q not in (n.R, n.t)} | {
        q.name: pose[q.name] for q in (n.R, n.t) if q.name in pose
    }
    found = [v for q in n.MOTION for v in _components(q, "input", start, "pose")]
    found += [Variable(f"{force.name}[{i + 1}]", force.unit, force.meaning, "output") for i in range(6)]
    if payload is not None:
        found += [v for q in n.PLATFORM for v in _components(q, "parameter", payload, "payload")]
    return found


def _components(quantity: Quantity, causality: str, numbers: Numbers, owner: str) -> list[Variable]:
    where = f"{owner}: {quantity.name}"
    if quantity.name not in numbers:
        raise ValueError(f"{where}: missing")
    return [
        Variable(
            _variable_name(quantity, key),
            _unit(quantity.unit),
            quantity.meaning,
            causality,
            _number(numbers[quantity.name], key, where),
        )
        for key in quantity.keys
    ]


def _variable_name(quantity: Quantity, key: tuple[int, ...]) -> str:
    if not key:
        return quantity.name
    if quantity.symmetric:
        return f"{quantity.name}.{''.join(AXES[i] for i in key)}"
    return f"{quantity.name}[{','.join(str(i + 1) for i in key)}]"


def _number(value: Any, key: Sequence[int], where: str) -> float:
    try:
        for i in key:
            value = value[i]
    except (IndexError, TypeError):
        raise ValueError(f"{where}: expected an entry {list(key)}") from None
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise ValueError(f"{where}: expected finite numbers, got {value!r}")
    return float(value)


def _unit(unit: str) -> str:
    """A unit of the notation as FMI and Modelica spell it: ``kg.m2``."""
    return unit.replace(" ", ".").replace("^", "")


def _dimension(unit: str) -> dict[str, int]:
    """Exponents of the base units of ``kg.m2`` or ``m/s2``."""
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
    name: str,
    symbol: str,
    kernel: UnitKernel,
    variables: Sequence[Variable],
    files: Sequence[str],
    digest: str,
    common: Mapping[str, str],
) -> str:
    outputs = [i + 1 for i, v in enumerate(variables) if v.causality == "output"]
    outputs.append(len(variables) + 1)
    units = {v.unit: _dimension(v.unit) for v in variables}
    lines = {
        "UNITS": [
            f'    <Unit name="{unit}"><BaseUnit{_attributes(dimension)}/></Unit>'
            for unit, dimension in units.items()
        ],
        "FILES": [f'      <File name="{escape(file)}"/>' for file in files],
        "VARIABLES": [_scalar_variable(i, v) for i, v in enumerate(variables)],
        "UNKNOWNS": [f'      <Unknown index="{index}"/>' for index in outputs],
        "CODES": [f"{code} {text}" for _, code, text in STATUS],
    }
    values = {
        "NAME": escape(name),
        "IDENTIFIER": model_identifier(symbol),
        "SAYS": escape(_says(kernel, digest)),
        "STEP": repr(STEP),
        "LICENCE": escape(licence.SAYS),
        "REFERENCE": str(len(variables)),
        **common,
        **{mark: ("; " if mark == "CODES" else "\n").join(rows) for mark, rows in lines.items()},
    }
    return _fill(_DESCRIPTION, values)


def _says(kernel: UnitKernel, digest: str) -> str:
    return f"{kernel.says} SHA-256 of name and constants: {digest}".strip()


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


def _attributes(values: Mapping[str, int]) -> str:
    return "".join(f' {name}="{value}"' for name, value in values.items() if value)


def _page(
    name: str, kernel: UnitKernel, variables: Sequence[Variable], digest: str, common: Mapping[str, str]
) -> str:
    groups = {
        kind: [v for v in variables if v.causality == kind] for kind in ("input", "output", "parameter")
    }
    rows = {
        kind: "\n".join(
            f"<tr><td>{v.name}</td><td>{v.unit}</td><td>{escape(v.meaning)}</td></tr>" for v in group
        )
        for kind, group in groups.items()
    }
    parameters = _fill(_PARAMETERS, {"ROWS": rows["parameter"]}) if rows["parameter"] else _NO_PARAMETERS
    values = {
        **common,
        "NAME": escape(name),
        "SAYS": escape(_says(kernel, digest)),
        "LICENCE": escape(licence.SAYS),
        "REAL": kernel.precision,
        "INPUTS": rows["input"],
        "OUTPUTS": rows["output"],
        "PARAMETERS": parameters,
        "STATUS": "\n".join(f"<tr><td>{code}</td><td>{escape(text)}</td></tr>" for _, code, text in STATUS),
    }
    return _fill(_PAGE, values)


def _guid(texts: Mapping[str, str]) -> str:
    """``{8-4-4-4-12}`` hexadecimal digits of a digest of all paths and texts."""
    parts = hashlib.sha256()
    for path, text in sorted(texts.items()):
        for part in (path.encode(), text.encode()):
            parts.update(len(part).to_bytes(8, "big") + part)
    digits = parts.hexdigest()
    cuts = (0, 8, 12, 16, 20, 32)
    groups = [digits[a:b] for a, b in itertools.pairwise(cuts)]
    return "{" + "-".join(groups) + "}"


# ---------------------------------------------------------------- C


def _header(common: Mapping[str, str]) -> str:
    names = re.findall(r"^FMI2_EXPORT .*?\b(fmi2\w+)\(", _HEADER, re.MULTILINE)
    defined = "\n".join(f"#define {name} STEWART_NAMED({name})" for name in names)
    return _fill(_HEADER, {**common, "PREFIXED": defined})


def _source(symbol: str, kernel: UnitKernel, variables: Sequence[Variable], common: Mapping[str, str]) -> str:
    bare = kernel.baked
    counts = {kind: sum(v.causality == kind for v in variables) for kind in ("input", "output", "parameter")}
    literals = [f"    {0.0 if v.start is None else v.start!r}, /* {v.name} */" for v in variables]
    motion, place = _taken(n.MOTION, "motion", 0)
    payload, _ = _taken(n.PLATFORM, "robot", place + counts["output"])
    values = {
        **common,
        "HEADER": kernel.header,
        "INPUTS": str(counts["input"]),
        "REALS": str(len(variables)),
        "START": "\n".join(literals),
        "SYMBOL": symbol,
        "PREFIX": kernel.prefix,
        "MODEL": f"{kernel.prefix}_model",
        "MOTION": "\n".join(motion),
        "PAYLOAD": "\n".join(payload),
        "MESSAGES": "\n".join(f'    "{text}", /* STEWART_{code} */' for code, _, text in STATUS),
    }
    flags = {"M": not bare, "B": bare}
    return _fill(_only(_SOURCE, flags), values)


def _taken(quantities: Iterable[Quantity], owner: str, place: int) -> tuple[list[str], int]:
    """Lines that fill a structure of stewart.h from the unit's values, and the place after them."""
    lines = []
    for quantity in quantities:
        count = len(quantity.keys)
        to = f"{owner}.{quantity.name}" if quantity.shape else f"&{owner}.{quantity.name}"
        lines.append(f"    narrowed(value + {place}, {count}, {to});")
        place += count
    return lines, place


def _only(text: str, flags: Mapping[str, bool]) -> str:
    """Keep lines that end in ``//`` and a letter only where that flag is set."""
    lines = []
    for line in text.split("\n"):
        body, mark, flag = line.partition(" //")
        if not mark or flags[flag]:
            lines.append(body)
    return "\n".join(lines)


def _fill(template: str, values: Mapping[str, str]) -> str:
    # One pass, so that an @ in a robot's name stays what it is.
    return re.sub(r"@([A-Z]+)@", lambda match: values.get(match[1], match[0]), template)


_DESCRIPTION = """\
<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription
  fmiVersion="2.0"
  modelName="@NAME@"
  guid="@GUID@"
  description="Actuator forces of a Stewart platform. @SAYS@"
  license="@LICENCE@"
  generationTool="stewart-sym @VERSION@"
  variableNamingConvention="structured">
  <CoSimulation
    modelIdentifier="@IDENTIFIER@"
    canHandleVariableCommunicationStepSize="true"
    canGetAndSetFMUstate="true"
    canSerializeFMUstate="true">
    <SourceFiles>
@FILES@
    </SourceFiles>
  </CoSimulation>
  <UnitDefinitions>
@UNITS@
  </UnitDefinitions>
  <LogCategories>
    <Category name="logStatusWarning" description="a pose, or a payload, that has no forces"/>
    <Category name="logStatusError" description="a call that the unit refuses"/>
  </LogCategories>
  <DefaultExperiment startTime="0.0" stopTime="1.0" stepSize="@STEP@"/>
  <ModelVariables>
@VARIABLES@
    <ScalarVariable name="status" valueReference="@REFERENCE@" causality="output" variability="discrete" \
description="status of the forces; other than 0, they stay what they were: @CODES@">
      <Integer/>
    </ScalarVariable>
  </ModelVariables>
  <ModelStructure>
    <Outputs>
@UNKNOWNS@
    </Outputs>
    <InitialUnknowns>
@UNKNOWNS@
    </InitialUnknowns>
  </ModelStructure>
</fmiModelDescription>
"""

_PAGE = """\
<!DOCTYPE html>
<html lang="en">
<head><meta charset="utf-8"><title>@NAME@</title></head>
<body>
<h1>@NAME@</h1>
<p>@SAYS@</p>
<p>FMI 2.0 co-simulation unit, written by stewart-sym @VERSION@. It has no dynamics of its own: a step of
whatever length computes the forces of the motion that the inputs have at its start; they are the outputs at
its end. On initialisation the outputs are those of the inputs at that time. R must be a rotation; that is not
checked. An input that nobody connects keeps its start value: rates, accelerations and loads start at zero.
Arithmetic is @REAL@ within, double at the interface.</p>
<h2>Inputs</h2>
<table>
@INPUTS@
</table>
<h2>Outputs</h2>
<table>
@OUTPUTS@
<tr><td>status</td><td></td><td>status of the forces</td></tr>
</table>
@PARAMETERS@
<h2>Status</h2>
<p>Other than 0, the forces stay what they were before, 0 N at the start.</p>
<table>
@STATUS@
</table>
<h2>Licence</h2>
<p>@LICENCE@ Text: <a href="licenses/license.txt">license.txt</a>.</p>
<h2>Another platform</h2>
<p>The binary is for the kind of machine on which the unit was made. All of its C is in <code>sources</code>,
C99 that needs no other files: <code>fmudialog.compileFMUSources</code> in MATLAB R2024a and later,
<code>fmpy compile</code>, or a C compiler makes the others.</p>
</body>
</html>
"""

_PARAMETERS = """\
<h2>Tunable parameters</h2>
<p>A change holds from the next step on.</p>
<table>
@ROWS@
</table>"""

_NO_PARAMETERS = "<p>The numbers of the machine are in the code: there are no parameters.</p>"

_HEADER = """\
/* stewart_fmi2.h: what a co-simulation unit takes of the binary interface of FMI 2.0.
 *
 * Written by stewart-sym @VERSION@; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 * Names, order and kinds are the standard's. With -DFMI2_FUNCTION_PREFIX=<prefix>, as for a unit that is
 * linked statically, every function's name begins with the prefix.
 */
#ifndef STEWART_FMI2_H
#define STEWART_FMI2_H

#include <stddef.h>

#if defined(FMI2_FUNCTION_PREFIX)
#define STEWART_JOINED(prefix, name) prefix##name
#define STEWART_PREFIXED(prefix, name) STEWART_JOINED(prefix, name)
#define STEWART_NAMED(name) STEWART_PREFIXED(FMI2_FUNCTION_PREFIX, name)
@PREFIXED@
#endif

#if defined(_WIN32) || defined(__CYGWIN__)
#define FMI2_EXPORT __declspec(dllexport)
#elif defined(__GNUC__) && __GNUC__ >= 4
#define FMI2_EXPORT __attribute__((visibility("default")))
#else
#define FMI2_EXPORT
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef void *fmi2Component;
typedef void *fmi2ComponentEnvironment;
typedef void *fmi2FMUstate;
typedef unsigned int fmi2ValueReference;
typedef double fmi2Real;
typedef int fmi2Integer;
typedef int fmi2Boolean;
typedef const char *fmi2String;
typedef char fmi2Byte;

typedef enum { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending } fmi2Status;
typedef enum { fmi2ModelExchange, fmi2CoSimulation } fmi2Type;
typedef enum {
    fmi2DoStepStatus,
    fmi2PendingStatus,
    fmi2LastSuccessfulTime,
    fmi2Terminated
} fmi2StatusKind;

typedef struct {
    void (*logger)(fmi2ComponentEnvironment environment, fmi2String instance, fmi2Status status,
        fmi2String category, fmi2String message, ...);
    void *(*allocateMemory)(size_t count, size_t size); /* zeroed */
    void (*freeMemory)(void *memory);
    void (*stepFinished)(fmi2ComponentEnvironment environment, fmi2Status status);
    fmi2ComponentEnvironment componentEnvironment;
} fmi2CallbackFunctions;

FMI2_EXPORT const char *fmi2GetTypesPlatform(void);
FMI2_EXPORT const char *fmi2GetVersion(void);
FMI2_EXPORT fmi2Status fmi2SetDebugLogging(
    fmi2Component c, fmi2Boolean on, size_t count, const fmi2String categories[]);

FMI2_EXPORT fmi2Component fmi2Instantiate(
    fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
    const fmi2CallbackFunctions *callbacks, fmi2Boolean visible, fmi2Boolean logging);
FMI2_EXPORT void fmi2FreeInstance(fmi2Component c);

FMI2_EXPORT fmi2Status fmi2SetupExperiment(
    fmi2Component c, fmi2Boolean has_tolerance, fmi2Real tolerance, fmi2Real start, fmi2Boolean has_stop,
    fmi2Real stop);
FMI2_EXPORT fmi2Status fmi2EnterInitializationMode(fmi2Component c);
FMI2_EXPORT fmi2Status fmi2ExitInitializationMode(fmi2Component c);
FMI2_EXPORT fmi2Status fmi2Terminate(fmi2Component c);
FMI2_EXPORT fmi2Status fmi2Reset(fmi2Component c);

FMI2_EXPORT fmi2Status fmi2GetReal(
    fmi2Component c, const fmi2ValueReference vr[], size_t count, fmi2Real value[]);
FMI2_EXPORT fmi2Status fmi2GetInteger(
    fmi2Component c, const fmi2ValueReference vr[], size_t count, fmi2Integer value[]);
FMI2_EXPORT fmi2Status fmi2GetBoolean(
    fmi2Component c, const fmi2ValueReference vr[], size_t count, fmi2Boolean value[]);
FMI2_EXPORT fmi2Status fmi2GetString(
    fmi2Component c, const fmi2ValueReference vr[], size_t count, fmi2String value[]);
FMI2_EXPORT fmi2Status fmi2SetReal(
    fmi2Component c, const fmi2ValueReference vr[], size_t count, const fmi2Real value[]);
FMI2_EXPORT fmi2Status fmi2SetInteger(
    fmi2Component c, const fmi2ValueReference vr[], size_t count, const fmi2Integer value[]);
FMI2_EXPORT fmi2Status fmi2SetBoolean(
    fmi2Component c, const fmi2ValueReference vr[], size_t count, const fmi2Boolean value[]);
FMI2_EXPORT fmi2Status fmi2SetString(
    fmi2Component c, const fmi2ValueReference vr[], size_t count, const fmi2String value[]);

FMI2_EXPORT fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *state);
FMI2_EXPORT fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state);
FMI2_EXPORT fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *state);
FMI2_EXPORT fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, size_t *size);
FMI2_EXPORT fmi2Status fmi2SerializeFMUstate(
    fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size);
FMI2_EXPORT fmi2Status fmi2DeSerializeFMUstate(
    fmi2Component c, const fmi2Byte bytes[], size_t size, fmi2FMUstate *state);

FMI2_EXPORT fmi2Status fmi2GetDirectionalDerivative(
    fmi2Component c, const fmi2ValueReference unknown[], size_t unknowns, const fmi2ValueReference known[],
    size_t knowns, const fmi2Real change[], fmi2Real found[]);
FMI2_EXPORT fmi2Status fmi2SetRealInputDerivatives(
    fmi2Component c, const fmi2ValueReference vr[], size_t count, const fmi2Integer order[],
    const fmi2Real value[]);
FMI2_EXPORT fmi2Status fmi2GetRealOutputDerivatives(
    fmi2Component c, const fmi2ValueReference vr[], size_t count, const fmi2Integer order[],
    fmi2Real value[]);

FMI2_EXPORT fmi2Status fmi2DoStep(fmi2Component c, fmi2Real time, fmi2Real step, fmi2Boolean no_return);
FMI2_EXPORT fmi2Status fmi2CancelStep(fmi2Component c);
FMI2_EXPORT fmi2Status fmi2GetStatus(fmi2Component c, fmi2StatusKind kind, fmi2Status *value);
FMI2_EXPORT fmi2Status fmi2GetRealStatus(fmi2Component c, fmi2StatusKind kind, fmi2Real *value);
FMI2_EXPORT fmi2Status fmi2GetIntegerStatus(fmi2Component c, fmi2StatusKind kind, fmi2Integer *value);
FMI2_EXPORT fmi2Status fmi2GetBooleanStatus(fmi2Component c, fmi2StatusKind kind, fmi2Boolean *value);
FMI2_EXPORT fmi2Status fmi2GetStringStatus(fmi2Component c, fmi2StatusKind kind, fmi2String *value);

#ifdef __cplusplus
}
#endif

#endif
"""

_SOURCE = """\
/* stewart_fmi2.c: the actuator forces as a co-simulation unit of FMI 2.0.
 *
 * Written by stewart-sym @VERSION@; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 * A step computes the forces of the motion that the inputs have at its start; where there are none, they stay
 * what they were and `status` says why. An instance is one piece of memory from the importer's allocator, and
 * another for its name; its state is plain, copied and serialised as it lies there. No globals: any number of
 * instances, each from one thread at a time.
 */
#include "stewart_fmi2.h"

#include "@HEADER@"
#include "stewart_robot.h" //M

#include <float.h>
#include <string.h>

#define GUID "@GUID@"

/* Value references: inputs, forces, parameters, and the status. */
#define INPUTS @INPUTS@u
#define FORCES 6u
#define REALS @REALS@u
#define STATUS REALS

/* The largest number that the kernel's arithmetic holds. */
#if defined(STEWART_REAL)
#define LARGEST ((fmi2Real)STEWART_MAX)
#elif defined(STEWART_FLOAT)
#define LARGEST ((fmi2Real)FLT_MAX)
#else
#define LARGEST DBL_MAX
#endif

#define LOG_WARNINGS 1
#define LOG_ERRORS 2

/* Phases of an instance. */
#define INSTANTIATED 0
#define INITIALISING 1
#define STEPPING 2
#define TERMINATED 3

/* Values by reference before anything is set. */
static const fmi2Real start_values[REALS] = {
@START@
};

static const char *const meanings[] = {
@MESSAGES@
};
#define MEANINGS ((int)(sizeof meanings / sizeof *meanings))

/* All that an instance goes by, without a pointer. */
typedef struct {
    char guid[sizeof GUID];
    int phase;
    int status; /* of the forces, see stewart.h */
    int current; /* whether forces and status are those of the inputs */
    int prepared; /* whether the model is that of the parameters */ //M
    fmi2Real time; /* s */
    fmi2Real value[REALS];
    @MODEL@ model; //M
} unit_state;

typedef struct {
    unit_state state;
    fmi2CallbackFunctions callbacks;
    int logging;
    char *name;
} unit;

/* ---------------------------------------------------------------- forces */

static int representable(const fmi2Real *value, size_t count)
{
    size_t i;
    for (i = 0; i < count; ++i) {
        /* This way round a NaN is not. */
        if (!(value[i] >= -LARGEST && value[i] <= LARGEST)) {
            return 0;
        }
    }
    return 1;
}

/* To the kernel's arithmetic: rounded where that is float. */
static void narrowed(const fmi2Real *value, size_t count, stewart_real *to)
{
    size_t i;
    for (i = 0; i < count; ++i) {
        to[i] = (stewart_real)value[i];
    }
}

/* The model of the robot with the payload and gravity of the parameters. Returns a status. */ //M
static int prepare(unit_state *state) //M
{ //M
    const fmi2Real *const value = state->value; //M
    stewart_robot robot = @SYMBOL@; //M
    if (!representable(value + INPUTS + FORCES, REALS - INPUTS - FORCES)) { //M
        return STEWART_NOT_FINITE; //M
    } //M
@PAYLOAD@ //M
    return @PREFIX@_prepare(&robot, &state->model); //M
} //M
 //M
/* Forces of the inputs. Returns a status. */
static int solve(unit_state *state, stewart_real F[6])
{
    const fmi2Real *const value = state->value;
    stewart_motion motion;
    int status;
    if (!representable(value, INPUTS)) {
        return STEWART_NOT_FINITE;
    }
@MOTION@
    if (!state->prepared) { //M
        status = prepare(state); //M
        if (status != STEWART_OK) { //M
            return status; //M
        } //M
        state->prepared = 1; //M
    } //M
    status = @PREFIX@_forces(&state->model, &motion, F); //M
    status = @PREFIX@_forces(&motion, F); //B
    return status;
}

static void report(const unit *u, int which, fmi2Status status, const char *message)
{
    if ((u->logging & which) != 0 && u->callbacks.logger) {
        u->callbacks.logger(u->callbacks.componentEnvironment, u->name, status,
            which == LOG_ERRORS ? "logStatusError" : "logStatusWarning", message);
    }
}

/* Brings forces and status up to the inputs; a status that lasts is reported once. */
static void evaluate(unit *u)
{
    unit_state *const state = &u->state;
    stewart_real F[FORCES];
    const int before = state->status;
    size_t i;
    if (state->current) {
        return;
    }
    state->current = 1;
    state->status = solve(state, F);
    if (state->status == STEWART_OK) {
        for (i = 0; i < FORCES; ++i) {
            state->value[INPUTS + i] = (fmi2Real)F[i];
        }
    } else if (state->status != before) {
        report(u, LOG_WARNINGS, fmi2Warning,
            state->status > 0 && state->status < MEANINGS ? meanings[state->status] : "unknown status");
    }
}

/* ---------------------------------------------------------------- instances */

static fmi2Status refused(const unit *u, const char *message)
{
    report(u, LOG_ERRORS, fmi2Error, message);
    return fmi2Error;
}

static void restart(unit_state *state)
{
    memset(state, 0, sizeof *state);
    memcpy(state->guid, GUID, sizeof GUID);
    memcpy(state->value, start_values, sizeof start_values);
    state->phase = INSTANTIATED;
}

/* From one phase to the next. */
static fmi2Status advance(fmi2Component c, int from, int to)
{
    unit *const u = (unit *)c;
    if (!u) {
        return fmi2Error;
    }
    if (u->state.phase != from) {
        return refused(u, "called out of turn");
    }
    u->state.phase = to;
    return fmi2OK;
}

const char *fmi2GetTypesPlatform(void)
{
    return "default";
}

const char *fmi2GetVersion(void)
{
    return "2.0";
}

fmi2Component fmi2Instantiate(
    fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
    const fmi2CallbackFunctions *callbacks, fmi2Boolean visible, fmi2Boolean logging)
{
    unit refusal;
    unit *u;
    size_t length;
    const char *wrong = NULL;
    (void)resources;
    (void)visible;
    if (!callbacks || !callbacks->allocateMemory || !callbacks->freeMemory) {
        return NULL;
    }
    if (!name || !*name) {
        wrong = "an instance needs a name";
    } else if (type != fmi2CoSimulation) {
        wrong = "the unit is for co-simulation only";
    } else if (!guid || strcmp(guid, GUID) != 0) {
        wrong = "the GUID is not that of this unit: description and binary do not belong together";
    }
    if (wrong) {
        char nobody[] = "?";
        memset(&refusal, 0, sizeof refusal);
        refusal.callbacks = *callbacks;
        refusal.logging = LOG_ERRORS;
        refusal.name = nobody;
        report(&refusal, LOG_ERRORS, fmi2Error, wrong);
        return NULL;
    }
    length = strlen(name) + 1;
    u = (unit *)callbacks->allocateMemory(1, sizeof *u);
    if (!u) {
        return NULL;
    }
    u->name = (char *)callbacks->allocateMemory(length, 1);
    if (!u->name) {
        callbacks->freeMemory(u);
        return NULL;
    }
    memcpy(u->name, name, length);
    u->callbacks = *callbacks;
    u->logging = logging ? LOG_WARNINGS | LOG_ERRORS : 0;
    restart(&u->state);
    return u;
}

void fmi2FreeInstance(fmi2Component c)
{
    unit *const u = (unit *)c;
    if (u) {
        void (*const release)(void *) = u->callbacks.freeMemory;
        release(u->name);
        release(u);
    }
}

fmi2Status fmi2SetDebugLogging(
    fmi2Component c, fmi2Boolean on, size_t count, const fmi2String categories[])
{
    unit *const u = (unit *)c;
    int which = 0;
    size_t i;
    if (!u) {
        return fmi2Error;
    }
    if (count > 0 && !categories) {
        return refused(u, "fmi2SetDebugLogging: no categories given");
    }
    for (i = 0; i < count; ++i) {
        if (categories[i] && strcmp(categories[i], "logStatusWarning") == 0) {
            which |= LOG_WARNINGS;
        } else if (categories[i] && strcmp(categories[i], "logStatusError") == 0) {
            which |= LOG_ERRORS;
        } else {
            return refused(u, "fmi2SetDebugLogging: unknown category");
        }
    }
    if (count == 0) {
        which = LOG_WARNINGS | LOG_ERRORS;
    }
    u->logging = on ? u->logging | which : u->logging & ~which;
    return fmi2OK;
}

fmi2Status fmi2SetupExperiment(
    fmi2Component c, fmi2Boolean has_tolerance, fmi2Real tolerance, fmi2Real start, fmi2Boolean has_stop,
    fmi2Real stop)
{
    const fmi2Status status = advance(c, INSTANTIATED, INSTANTIATED);
    (void)has_tolerance;
    (void)tolerance;
    (void)has_stop;
    (void)stop;
    if (status == fmi2OK) {
        ((unit *)c)->state.time = start;
    }
    return status;
}

fmi2Status fmi2EnterInitializationMode(fmi2Component c)
{
    return advance(c, INSTANTIATED, INITIALISING);
}

fmi2Status fmi2ExitInitializationMode(fmi2Component c)
{
    const fmi2Status status = advance(c, INITIALISING, STEPPING);
    if (status == fmi2OK) {
        evaluate((unit *)c);
    }
    return status;
}

fmi2Status fmi2Terminate(fmi2Component c)
{
    return advance(c, STEPPING, TERMINATED);
}

fmi2Status fmi2Reset(fmi2Component c)
{
    unit *const u = (unit *)c;
    if (!u) {
        return fmi2Error;
    }
    restart(&u->state);
    return fmi2OK;
}

/* ---------------------------------------------------------------- values */

/* In initialisation the outputs follow the inputs; later each step sets them. Before there are none. */
static fmi2Status outputs_known(unit *u)
{
    if (u->state.phase == INSTANTIATED) {
        return refused(u, "there are no outputs before initialisation");
    }
    if (u->state.phase == INITIALISING) {
        evaluate(u);
    }
    return fmi2OK;
}

fmi2Status fmi2GetReal(
    fmi2Component c, const fmi2ValueReference vr[], size_t count, fmi2Real value[])
{
    unit *const u = (unit *)c;
    size_t i;
    if (!u) {
        return fmi2Error;
    }
    if (count > 0 && (!vr || !value)) {
        return refused(u, "fmi2GetReal: a pointer is null");
    }
    for (i = 0; i < count; ++i) {
        if (vr[i] >= REALS) {
            return refused(u, "fmi2GetReal: unknown value reference");
        }
        if (vr[i] >= INPUTS && vr[i] < INPUTS + FORCES && outputs_known(u) != fmi2OK) {
            return fmi2Error;
        }
        value[i] = u->state.value[vr[i]];
    }
    return fmi2OK;
}

fmi2Status fmi2SetReal(
    fmi2Component c, const fmi2ValueReference vr[], size_t count, const fmi2Real value[])
{
    unit *const u = (unit *)c;
    size_t i;
    if (!u) {
        return fmi2Error;
    }
    if (count > 0 && (!vr || !value)) {
        return refused(u, "fmi2SetReal: a pointer is null");
    }
    if (u->state.phase == TERMINATED) {
        return refused(u, "fmi2SetReal: called out of turn");
    }
    for (i = 0; i < count; ++i) {
        if (vr[i] >= REALS || (vr[i] >= INPUTS && vr[i] < INPUTS + FORCES)) {
            return refused(u, "fmi2SetReal: no input or parameter has this value reference");
        }
    }
    for (i = 0; i < count; ++i) {
        fmi2Real *const to = &u->state.value[vr[i]];
        /* Importers set the same parameters again and again. This way round a NaN is another one. */ //M
        if (vr[i] >= INPUTS && !(value[i] <= *to && value[i] >= *to)) { //M
            u->state.prepared = 0; //M
        } //M
        *to = value[i];
        u->state.current = 0;
    }
    return fmi2OK;
}

fmi2Status fmi2GetInteger(
    fmi2Component c, const fmi2ValueReference vr[], size_t count, fmi2Integer value[])
{
    unit *const u = (unit *)c;
    size_t i;
    if (!u) {
        return fmi2Error;
    }
    if (count > 0 && (!vr || !value)) {
        return refused(u, "fmi2GetInteger: a pointer is null");
    }
    for (i = 0; i < count; ++i) {
        if (vr[i] != STATUS) {
            return refused(u, "fmi2GetInteger: unknown value reference");
        }
        if (outputs_known(u) != fmi2OK) {
            return fmi2Error;
        }
        value[i] = u->state.status;
    }
    return fmi2OK;
}

/* For what the unit does not have: good if nothing is asked. */
static fmi2Status nothing(fmi2Component c, size_t count, const char *message)
{
    if (!c) {
        return fmi2Error;
    }
    return count == 0 ? fmi2OK : refused((const unit *)c, message);
}

fmi2Status fmi2GetBoolean(
    fmi2Component c, const fmi2ValueReference vr[], size_t count, fmi2Boolean value[])
{
    (void)vr;
    (void)value;
    return nothing(c, count, "fmi2GetBoolean: no variable is Boolean");
}

fmi2Status fmi2GetString(
    fmi2Component c, const fmi2ValueReference vr[], size_t count, fmi2String value[])
{
    (void)vr;
    (void)value;
    return nothing(c, count, "fmi2GetString: no variable is a string");
}

fmi2Status fmi2SetInteger(
    fmi2Component c, const fmi2ValueReference vr[], size_t count, const fmi2Integer value[])
{
    (void)vr;
    (void)value;
    return nothing(c, count, "fmi2SetInteger: no input or parameter is an integer");
}

fmi2Status fmi2SetBoolean(
    fmi2Component c, const fmi2ValueReference vr[], size_t count, const fmi2Boolean value[])
{
    (void)vr;
    (void)value;
    return nothing(c, count, "fmi2SetBoolean: no variable is Boolean");
}

fmi2Status fmi2SetString(
    fmi2Component c, const fmi2ValueReference vr[], size_t count, const fmi2String value[])
{
    (void)vr;
    (void)value;
    return nothing(c, count, "fmi2SetString: no variable is a string");
}

fmi2Status fmi2GetDirectionalDerivative(
    fmi2Component c, const fmi2ValueReference unknown[], size_t unknowns, const fmi2ValueReference known[],
    size_t knowns, const fmi2Real change[], fmi2Real found[])
{
    (void)unknown;
    (void)known;
    (void)knowns;
    (void)change;
    (void)found;
    return nothing(c, unknowns, "fmi2GetDirectionalDerivative: not provided");
}

fmi2Status fmi2SetRealInputDerivatives(
    fmi2Component c, const fmi2ValueReference vr[], size_t count, const fmi2Integer order[],
    const fmi2Real value[])
{
    (void)vr;
    (void)order;
    (void)value;
    return nothing(c, count, "fmi2SetRealInputDerivatives: inputs are not interpolated");
}

fmi2Status fmi2GetRealOutputDerivatives(
    fmi2Component c, const fmi2ValueReference vr[], size_t count, const fmi2Integer order[],
    fmi2Real value[])
{
    (void)vr;
    (void)order;
    (void)value;
    return nothing(c, count, "fmi2GetRealOutputDerivatives: not provided");
}

/* ---------------------------------------------------------------- states */

/* Copies a state into *to, allocated where it is null. */
static fmi2Status kept(const unit *u, const unit_state *state, fmi2FMUstate *to)
{
    if (!*to) {
        *to = u->callbacks.allocateMemory(1, sizeof *state);
    }
    if (!*to) {
        return refused(u, "no memory for a state");
    }
    memcpy(*to, state, sizeof *state);
    return fmi2OK;
}

fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *state)
{
    unit *const u = (unit *)c;
    if (!u) {
        return fmi2Error;
    }
    return state ? kept(u, &u->state, state) : refused(u, "fmi2GetFMUstate: a pointer is null");
}

fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state)
{
    unit *const u = (unit *)c;
    if (!u) {
        return fmi2Error;
    }
    if (!state) {
        return refused(u, "fmi2SetFMUstate: a pointer is null");
    }
    memcpy(&u->state, state, sizeof u->state);
    return fmi2OK;
}

fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *state)
{
    unit *const u = (unit *)c;
    if (!u) {
        return fmi2Error;
    }
    if (state && *state) {
        u->callbacks.freeMemory(*state);
        *state = NULL;
    }
    return fmi2OK;
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, size_t *size)
{
    unit *const u = (unit *)c;
    if (!u) {
        return fmi2Error;
    }
    if (!state || !size) {
        return refused(u, "fmi2SerializedFMUstateSize: a pointer is null");
    }
    *size = sizeof(unit_state);
    return fmi2OK;
}

fmi2Status fmi2SerializeFMUstate(
    fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size)
{
    unit *const u = (unit *)c;
    if (!u) {
        return fmi2Error;
    }
    if (!state || !bytes || size < sizeof(unit_state)) {
        return refused(u, "fmi2SerializeFMUstate: a pointer is null or the size too small");
    }
    memcpy(bytes, state, sizeof(unit_state));
    return fmi2OK;
}

fmi2Status fmi2DeSerializeFMUstate(
    fmi2Component c, const fmi2Byte bytes[], size_t size, fmi2FMUstate *state)
{
    unit *const u = (unit *)c;
    unit_state found;
    if (!u) {
        return fmi2Error;
    }
    if (!bytes || !state || size != sizeof found) {
        return refused(u, "fmi2DeSerializeFMUstate: a pointer is null or the size another");
    }
    memcpy(&found, bytes, sizeof found);
    if (memcmp(found.guid, GUID, sizeof GUID) != 0) {
        return refused(u, "fmi2DeSerializeFMUstate: not a state of this unit");
    }
    return kept(u, &found, state);
}

/* ---------------------------------------------------------------- steps */

fmi2Status fmi2DoStep(fmi2Component c, fmi2Real time, fmi2Real step, fmi2Boolean no_return)
{
    const fmi2Status status = advance(c, STEPPING, STEPPING);
    unit *const u = (unit *)c;
    (void)no_return;
    if (status != fmi2OK) {
        return status;
    }
    if (!(time >= -DBL_MAX && time <= DBL_MAX && step >= 0 && step <= DBL_MAX)) {
        return refused(u, "fmi2DoStep: expected a finite time and a step that is not negative");
    }
    evaluate(u);
    u->state.time = time + step;
    return fmi2OK;
}

fmi2Status fmi2CancelStep(fmi2Component c)
{
    return nothing(c, 1, "fmi2CancelStep: no step is under way when a call returns");
}

/* No step is ever pending: of the questions about one, two have an answer. */

fmi2Status fmi2GetStatus(fmi2Component c, fmi2StatusKind kind, fmi2Status *value)
{
    (void)kind;
    (void)value;
    return c ? fmi2Discard : fmi2Error;
}

fmi2Status fmi2GetRealStatus(fmi2Component c, fmi2StatusKind kind, fmi2Real *value)
{
    if (!c) {
        return fmi2Error;
    }
    if (kind != fmi2LastSuccessfulTime || !value) {
        return fmi2Discard;
    }
    *value = ((unit *)c)->state.time;
    return fmi2OK;
}

fmi2Status fmi2GetIntegerStatus(fmi2Component c, fmi2StatusKind kind, fmi2Integer *value)
{
    (void)kind;
    (void)value;
    return c ? fmi2Discard : fmi2Error;
}

fmi2Status fmi2GetBooleanStatus(fmi2Component c, fmi2StatusKind kind, fmi2Boolean *value)
{
    if (!c) {
        return fmi2Error;
    }
    if (kind != fmi2Terminated || !value) {
        return fmi2Discard;
    }
    *value = 0;
    return fmi2OK;
}

fmi2Status fmi2GetStringStatus(fmi2Component c, fmi2StatusKind kind, fmi2String *value)
{
    (void)kind;
    (void)value;
    return c ? fmi2Discard : fmi2Error;
}
"""
