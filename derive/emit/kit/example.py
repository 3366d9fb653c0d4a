"""``example/main.c``: an example of a kit, one call of each of its functions with what it prints.

One of the kit's texts. Takes the functions of a kit and one of their calls; knows no equation.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from . import robot
from .functions import MODEL, NOTHING, ROBOT, Function
from .selftest import Case
from .words import EPSILON, braces, filled, in_comment, literal, motion_members


def example(
    name: str, symbol: str, functions: Sequence[Function], cases: Mapping[str, Sequence[Case]], version: str
) -> str:
    """``example/main.c``. Arguments and errors as of ``selftest``; the first case of each is shown."""
    shown = [(function, cases[function.stem][0]) for function in functions]
    motions = [case.motion for _, case in shown if case.motion is not None]
    uses_robot = any(function.subject != NOTHING for function in functions)
    headers = dict.fromkeys(function.header for function in functions)
    parts = {
        "name": in_comment(name),
        "version": version,
        "includes": "".join(
            f'#include "{file}"\n' for file in ([*([robot.HEADER] if uses_robot else []), *headers])
        ),
        "real": EPSILON.split("\n\n")[0],
        "motion": f"static const stewart_motion motion = {{\n{motion_members(motions[0], '    ')}\n}};\n"
        if motions
        else "",
        "shown": "\n".join(_shown(function, case, symbol) for function, case in shown),
        "calls": "\n".join(f"    failed |= show_{function.stem}();" for function in functions),
    }
    return filled(_EXAMPLE, parts)


def _shown(function: Function, case: Case, symbol: str) -> str:
    signature = function.signature
    subject = {ROBOT: f"&{symbol}, ", MODEL: "&model, ", NOTHING: ""}[function.subject]
    call = _CALLS[function.stem]
    declared = [f"    static {function.prefix}_model model;"] if function.subject == MODEL else []
    start = 0
    for given in signature.inputs:
        name, count = given.name, given.count
        values = [literal(float(v), name) for v in case.inputs[start : start + count]]
        start += count
        if name not in _OF_POSE:
            numbers = braces(values, " " * 8)
            declared.append(f"    static const stewart_real {name}[{count}] =\n        {numbers};")
        elif name in ("R", "R_guess"):
            declared.append(f"    stewart_pose pose = {{\n        {braces(values, ' ' * 8)},")
        else:
            declared.append(f"        {braces(values, ' ' * 8)}}};")
    declared += [f"    {line}" for line in call.declared]
    declared.append("    int status;")
    made = f"    status = {function.symbol}({subject}{call.arguments});"
    if function.subject == MODEL:
        made = (
            f"    status = {function.prefix}_prepare(&{symbol}, &model);\n"
            "    if (status == STEWART_OK) {\n"
            f"        status = {function.symbol}({subject}{call.arguments});\n"
            "    }"
        )
    text = [
        f"/* {signature.says} */",
        f"static int show_{function.stem}(void)",
        "{",
        *declared,
        made,
        "    if (status != STEWART_OK) {",
        f'        (void)printf("{function.symbol}: status %d, see stewart.h\\n", status);',
        "        return 1;",
        "    }",
        *(f'    print("{label}", {where}, {count});' for label, where, count in call.printed),
        "    return 0;",
        "}",
        "",
    ]
    return "\n".join(text)


@dataclass(frozen=True)
class _Call:
    """How the example calls a function: what it declares, the arguments after the first, what it prints as
    label, array and count of numbers."""

    declared: tuple[str, ...]
    arguments: str
    printed: tuple[tuple[str, str, int], ...]


_OF_POSE = ("R", "t", "R_guess", "t_guess")

_TURNED = (("R", "turned.R", 9), ("omega, rad/s", "turned.omega", 3), ("alpha, rad/s^2", "turned.alpha", 3))

_CALLS = {
    "forces": _Call(("stewart_real F[6];",), "&motion, F", (("F, N", "F", 6),)),
    "inverse_dynamics": _Call(
        ("stewart_forces forces;",),
        "&motion, &forces",
        (("F, N", "forces.F", 6), ("D, N", "forces.D", 6), ("c, N and N m", "forces.c", 6)),
    ),
    "joint_reactions": _Call(
        ("stewart_forces forces;", "stewart_reactions reactions;"),
        "&motion, bearing, &forces, &reactions",
        (("F_s of leg 1, N", "reactions.F_s[0]", 3), ("M_u, N m", "reactions.M_u", 6)),
    ),
    "equations": _Call(
        ("stewart_equations found;",),
        "&motion, &found",
        (("M, first row", "found.M", 6), ("g, N and N m", "found.g", 6)),
    ),
    "bias": _Call(("stewart_real bias[6];",), "&motion, bias", (("bias, N and N m", "bias", 6),)),
    "forward_dynamics": _Call(
        ("stewart_real acceleration[6];",),
        "&motion, F, acceleration",
        (("a, m/s^2, alpha, rad/s^2", "acceleration", 6),),
    ),
    "joint_inertia": _Call(
        ("stewart_real inertia[36];",), "&motion, inertia", (("joint inertia, first row, kg", "inertia", 6),)
    ),
    "derivatives": _Call(
        ("stewart_derivatives found;",), "&motion, &found", (("dF by pose, first row", "found.by_pose", 6),)
    ),
    "linearisation": _Call(
        ("stewart_linearisation found;",), "&motion, F, &found", (("A, row of a, by dt", "found.A + 72", 6),)
    ),
    "inverse_kinematics": _Call(
        ("stewart_real L[6], L_dot[6];",),
        "&motion, L, L_dot",
        (("L, m", "L", 6), ("L_dot, m/s", "L_dot", 6)),
    ),
    "forward_kinematics": _Call((), "L, &pose", (("R", "pose.R", 9), ("t, m", "pose.t", 3))),
    "forward_velocity": _Call(
        ("stewart_real v[3], omega[3];",),
        "&pose, L_dot, v, omega",
        (("v, m/s", "v", 3), ("omega, rad/s", "omega", 3)),
    ),
    "motion_from_rpy": _Call(
        ("stewart_motion turned;",), "sine, cosine, theta_dot, theta_ddot, &turned", _TURNED
    ),
    "motion_from_quaternion": _Call(("stewart_motion turned;",), "e, e_dot, e_ddot, &turned", _TURNED),
}

_EXAMPLE = """\
/* main.c: an example: each function of the kit of "@name@", called once.
 *
 * Build it with `make example`, or link it with the kit's library, or with the sources beside this folder.
 *
 * Written by stewart-sym @version@; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include <stdio.h>

@includes@
@real@

@motion@
static void print(const char *label, const stewart_real *numbers, int count)
{
    int i;
    (void)printf("%s:", label);
    for (i = 0; i < count; ++i) {
        (void)printf(" %.9g", (double)numbers[i]);
    }
    (void)printf("\\n");
}

@shown@
int main(void)
{
    int failed = 0;
@calls@
    return failed;
}
"""
