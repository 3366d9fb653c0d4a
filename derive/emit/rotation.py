"""C99: R, omega and alpha of a motion from roll, pitch and yaw, or from a quaternion, and their rates."""

from ..block import Block, Quantity
from .c import ARITHMETIC, step_lines, wrap_list
from .infix import infix, wrap
from .lane_text import names_used


def header(version: str) -> str:
    """``stewart_rotation.h``."""
    return _HEADER.replace("@VERSION@", version)


def source(rpy: Block, quaternion: Block, version: str) -> str:
    """``stewart_rotation.c``: both blocks, shared, and the checks around them."""
    top = _TOP.replace("@VERSION@", version) + ARITHMETIC
    arguments = {
        rpy: ("sine", "cosine", "theta_dot", "theta_ddot"),
        quaternion: ("e", "e_dot", "e_ddot"),
    }
    return "\n".join(
        [top, _CHECKS, *(_function(block, names) for block, names in arguments.items()), _PUBLIC]
    )


def _function(block: Block, arguments: tuple[str, ...]) -> str:
    used = names_used(block)
    loads = [line for quantity in block.inputs for line in _load(quantity, block, used)]
    stores = [
        wrap(f"    out->{out.quantity.name}[{i}] = {infix(expr, 'STEWART_SQRT')};", " " * 8)
        for out in block.outputs
        for i, expr in enumerate(out.exprs)
    ]
    width = 4 if "e" in arguments else 3
    taken = ", ".join(f"const stewart_real {name}[{width}]" for name in arguments)
    return "\n".join(
        [
            f"/* {block.meaning}.\n * Operations: {block.operations()}. */",
            wrap_list(f"static void {block.name}({taken}, stewart_motion *out)", "    "),
            "{",
            *loads,
            *step_lines(block.steps, "    "),
            *stores,
            "}",
            "",
        ]
    )


def _load(quantity: Quantity, block: Block, used: set[str]) -> list[str]:
    """A quaternion is stored scalar first."""
    if not quantity.shape:
        return [f"    const stewart_real {quantity.name} = {quantity.name.removesuffix('_w')}[0];"]
    first = 1 if any(f"{quantity.name}_w" == other.name for other in block.inputs) else 0
    parts = [
        f"{name} = {quantity.name}[{first + i}]" for i, name in enumerate(quantity.names) if name in used
    ]
    return [wrap_list(f"    const stewart_real {', '.join(parts)};")]


_HEADER = """\
/* stewart_rotation.h: R, omega and alpha of a motion, from roll, pitch and yaw or from a quaternion.
 *
 * Written by stewart-sym @VERSION@; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#ifndef STEWART_ROTATION_H
#define STEWART_ROTATION_H

#include "stewart.h"

#ifdef __cplusplus
extern "C" {
#endif

/* R = Rz(theta_z) Ry(theta_y) Rx(theta_x), (38), omega and alpha from sines and cosines of theta_x, theta_y
 * and theta_z, rates, rad/s, and second rates, rad/s^2. The rates of the angles are not omega. Returns a
 * status: STEWART_NOT_FINITE if a number or result is not finite; other members of the motion stay as they
 * are. */
STEWART_NODISCARD int stewart_motion_from_rpy(
    const stewart_real sine[3], const stewart_real cosine[3], const stewart_real theta_dot[3],
    const stewart_real theta_ddot[3], stewart_motion *motion);

/* The same from a quaternion, platform to base, scalar first, of any length whose square is a number that
 * the arithmetic holds to all digits, else STEWART_NOT_FINITE; its rate, 1/s, and second rate, 1/s^2. */
STEWART_NODISCARD int stewart_motion_from_quaternion(
    const stewart_real e[4], const stewart_real e_dot[4], const stewart_real e_ddot[4],
    stewart_motion *motion);

#ifdef __cplusplus
}
#endif

#endif
"""

_TOP = """\
/* stewart_rotation.c: see stewart_rotation.h.
 *
 * Written by stewart-sym @VERSION@; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include "stewart_rotation.h"

"""

_CHECKS = """\
static int all_finite(const stewart_real *numbers, int count)
{
    int i, finite = 1;
    for (i = 0; i < count; ++i) {
        if (!(STEWART_FABS(numbers[i]) <= STEWART_MAX)) {
            finite = 0;
        }
    }
    return finite;
}

/* Takes what was found over into the motion, if it is finite. */
static int taken(const stewart_motion *found, stewart_motion *motion)
{
    int i, status = STEWART_NOT_FINITE;
    if ((all_finite(found->R, 9) != 0) && (all_finite(found->omega, 3) != 0) &&
        (all_finite(found->alpha, 3) != 0)) {
        status = STEWART_OK;
        for (i = 0; i < 9; ++i) {
            motion->R[i] = found->R[i];
        }
        for (i = 0; i < 3; ++i) {
            motion->omega[i] = found->omega[i];
            motion->alpha[i] = found->alpha[i];
        }
    }
    return status;
}
"""

_PUBLIC = """\
int stewart_motion_from_rpy(
    const stewart_real sine[3], const stewart_real cosine[3], const stewart_real theta_dot[3],
    const stewart_real theta_ddot[3], stewart_motion *motion)
{
    stewart_motion found;
    int status = STEWART_BAD_ARGUMENT;
    if ((sine != NULL) && (cosine != NULL) && (theta_dot != NULL) && (theta_ddot != NULL) &&
        (motion != NULL)) {
        turned_by_angles(sine, cosine, theta_dot, theta_ddot, &found);
        status = taken(&found, motion);
    }
    return status;
}

int stewart_motion_from_quaternion(
    const stewart_real e[4], const stewart_real e_dot[4], const stewart_real e_ddot[4],
    stewart_motion *motion)
{
    stewart_motion found;
    int status = STEWART_BAD_ARGUMENT;
    if ((e != NULL) && (e_dot != NULL) && (e_ddot != NULL) && (motion != NULL)) {
        const stewart_real square = (e[0]*e[0] + e[1]*e[1]) + (e[2]*e[2] + e[3]*e[3]);
        status = STEWART_NOT_FINITE;
        if ((square >= (REAL(1) / STEWART_MAX / STEWART_EPSILON)) && (square <= STEWART_MAX)) {
            turned_by_quaternion(e, e_dot, e_ddot, &found);
            status = taken(&found, motion);
        }
    }
    return status;
}
"""
