"""Text by which the float solve takes its moment rows over a length, so that pivots suit any size of machine.

Stands below ``lanes``. Every operation of the kernel but one is homogeneous in the units of length, mass and
time, so that units that are powers of two change no bit of it: the choice of a pivot compares force rows,
without unit, with moment rows, in metres. The length is a power of two as well, so that it changes no bit
but through that choice. In double none of this text is compiled.
"""

SWITCH = """\
/* In float the solve takes moments over a length: 21 multiplications a pose more. Otherwise the pivots of a
 * machine of millimetres would be chosen among its forces alone, those of a large one among its moments.
 * -DSTEWART_UNSCALED: float without it. -DSTEWART_SCALED: any arithmetic with it. */
#if defined(STEWART_FLOAT) && !defined(STEWART_UNSCALED) && !defined(STEWART_SCALED)
#define STEWART_SCALED
#endif
"""

MEMBER = """\
#if defined(STEWART_SCALED)
    stewart_real per_length; /* 1/m: one over the least power of two that no coordinate of p exceeds */
#endif"""

_MACROS = """
#if defined(STEWART_SCALED)
#define STEWART_OVER_LENGTH(value) ((value) * model->per_length)
#define STEWART_CHOOSE_LENGTH(made) ((made)->per_length = REAL(1) / unit_of_length(made))
#else
#define STEWART_OVER_LENGTH(value) (value)
#define STEWART_CHOOSE_LENGTH(made) ((void)(made))
#endif
"""

_BAKED_MACROS = """
{switch}
#if defined(STEWART_SCALED)
#define STEWART_OVER_LENGTH(value) ((value) * REAL({per_length!r}))
#else
#define STEWART_OVER_LENGTH(value) (value)
#endif
"""

_UNIT_OF_LENGTH = """\
#if defined(STEWART_SCALED)
/* The least power of two, down to 2^-100 and up to 2^100, that no coordinate of the platform points exceeds;
 * 1 if all of them are zero. */
static stewart_real unit_of_length(const @MODEL@ *model)
{
    stewart_real largest = REAL(0), unit = REAL(1);
    int i, j;
    for (j = 0; j < 3; ++j) {
        for (i = 0; i < 6; ++i) {
            largest = STEWART_LARGER(STEWART_FABS(@POINT@), largest);
        }
    }
    for (i = 0; i < 100 && unit < largest; ++i) {
        unit = REAL(2) * unit;
    }
    for (i = 0; i < 100 && largest > REAL(0) && STEWART_HALF * unit >= largest; ++i) {
        unit = STEWART_HALF * unit;
    }
    return unit;
}
#endif
"""

_LEAST_PIVOTS = """\
/* A product of pivots below which H may be singular: of the size of the largest arm of a moment. */
static stewart_real least_pivots(const @MODEL@ *model)
{
    stewart_real largest = REAL(0);
    int i, j;
    for (j = 0; j < 3; ++j) {
        for (i = 1; i < 6; ++i) {
            largest = STEWART_LARGER(STEWART_FABS(@POINT@ - @FIRST@), largest);
        }
    }
    largest = STEWART_OVER_LENGTH(largest);
    largest = STEWART_SUSPECT * STEWART_CUBE(largest);
    return largest <= STEWART_MAX ? largest : STEWART_MAX;
}
"""

LEAST_PIVOTS = (
    _LEAST_PIVOTS.replace("@POINT@", "model->p[j][i]")
    .replace("@FIRST@", "model->p[j][0]")
    .replace("@MODEL@", "stewart_@NAME@_model")
)
LEAST_PIVOTS_BY_LEGS = _LEAST_PIVOTS.replace("@POINT@", "model->leg[i].p[j]").replace(
    "@FIRST@", "model->leg[0].p[j]"
)
"""The same for a model in which the legs stand one after the other, its type still to be named."""

UNIT_OF_LENGTH = _UNIT_OF_LENGTH.replace("@POINT@", "model->p[j][i]").replace(
    "@MODEL@", "stewart_@NAME@_model"
)
UNIT_OF_LENGTH_BY_LEGS = _UNIT_OF_LENGTH.replace("@POINT@", "model->leg[i].p[j]")
"""The same for a model in which the legs stand one after the other, its type still to be named."""


def macros(per_length: float | None) -> str:
    """Macros that take a moment over the length; ``per_length``, 1/m, None where the model holds it."""
    if per_length is None:
        return _MACROS
    return _BAKED_MACROS.format(switch=SWITCH, per_length=per_length)
