"""Text by which the solves take their moment rows over a length, so that pivots suit any size of machine.

Every operation of a kernel but one is homogeneous in the units of length, mass and time, so that units that
are powers of two change no bit of it: the choice of a pivot compares force rows, without unit, with moment
rows, in metres. The length is a power of two as well, so that it changes no bit but through that choice. On
platforms of about a metre it is 1, and no solve multiplies by it.
"""

import math

SMALLEST, LARGEST = 0.125, 16.0
"""Sizes of platforms, m, between which forces and moments in metres compare well enough.

Of 10^4 poses none loses more than 6.1 rounding units times its condition number at 1/8 m, 2 at 1 m and above,
but 10 at 1/16 m. In float, pivots that are rounding error of moments come near
``STEWART_SUSPECT`` at 64 m.
"""

MEMBER = f"""\
    /* 1/m: by which the solve multiplies moments, 18 to 21 multiplications, unless it is 1: for platforms of
     * {SMALLEST:g} to {LARGEST:g} m. Otherwise one over the least power of two that no arm exceeds. */
    stewart_real per_length;"""

ABOUT_REFERENCE = SMALLEST / 2, LARGEST
"""The same of arms from the reference point, which is amid most platforms."""

_PER_LENGTH = """\
/* What moments are multiplied by in the solve where no coordinate of their arms exceeds `size`, 1/m: 1 for
 * sizes of about a metre, else one over the least power of two, from 2^-100 to 2^100, that is as large. */
static stewart_real per_length_of(stewart_real size)
{
    stewart_real unit = REAL(1);
    int i;
    if (size >= REAL(@SMALLEST@) && size <= REAL(@LARGEST@)) {
        return unit;
    }
    for (i = 0; i < 100 && unit < size; ++i) {
        unit = REAL(2) * unit;
    }
    for (i = 0; i < 100 && size > REAL(0) && STEWART_HALF * unit >= size; ++i) {
        unit = STEWART_HALF * unit;
    }
    return REAL(1) / unit;
}
"""


def per_length_function(smallest: float = SMALLEST, largest: float = LARGEST) -> str:
    """``per_length_of`` in C, with the sizes between which it is 1."""
    return _PER_LENGTH.replace("@SMALLEST@", repr(smallest)).replace("@LARGEST@", repr(largest))


_SIZE = """\
/* Largest coordinate of the arms of moments about platform point 1, m. */
static stewart_real size_of(const @MODEL@ *model)
{
    stewart_real largest = REAL(0);
    int i, j;
    for (j = 0; j < 3; ++j) {
        for (i = 1; i < 6; ++i) {
            largest = STEWART_LARGER(STEWART_FABS(@POINT@ - @FIRST@), largest);
        }
    }
    return largest;
}
"""

SIZE = (
    per_length_function()
    + "\n"
    + _SIZE.replace("@POINT@", "model->p[j][i]").replace("@FIRST@", "model->p[j][0]")
)
"""Functions of a model, its type still to be named, for its member ``per_length``."""
SIZE_BY_LEGS = (
    per_length_function()
    + "\n"
    + _SIZE.replace("@POINT@", "model->leg[i].p[j]").replace("@FIRST@", "model->leg[0].p[j]")
)
"""The same for a model in which the legs stand one after the other."""

MEMBER_OF_POSE = f"""\
    stewart_real least; /* product of the pivots of H below which it may be singular to rounding */
{MEMBER}"""
LEAST_PIVOTS = """
/* Product of the pivots below which H may be singular, of arms that are no larger than `size`. */
static stewart_real least_pivots(stewart_real size)
{
    const stewart_real least = STEWART_LEAST_PIVOTS(size);
    return least <= STEWART_MAX ? least : STEWART_MAX;
}
"""
"""Of a model with ``MEMBER_OF_POSE``, after its functions."""

PREPARED = """\
    {model}per_length = per_length_of(size_of({address}));"""
"""What preparation does with them."""
PREPARED_OF_POSE = (
    PREPARED
    + """
    {model}least = least_pivots(size_of({address}) * {model}per_length);"""
)
"""The same with ``MEMBER_OF_POSE``."""

IS_SCALED = "model->per_length != REAL(1)"
"""Whether a prepared model's moments are multiplied at all."""


def per_length(size: float) -> float:
    """What ``per_length_of`` of the C returns."""
    if SMALLEST <= size <= LARGEST or size == 0.0:
        return 1.0
    fraction, exponent = math.frexp(size)
    return math.ldexp(1.0, min(max((fraction == 0.5) - exponent, -100), 100))
