"""Text by which every C source decides whether H is singular to rounding.

The solves multiply their pivots: of a matrix that is singular to rounding the product is rounding error.
Where it is small, or a leg is short beside what its vector is the sum of, ``singular_status`` decides from
bounds of the rounding error of every entry of H. No dynamics, no solve.
"""

MACROS = """
/* Product of the pivots, moments over the size of the platform, below which H may be singular to rounding. */
#if !defined(STEWART_SUSPECT)
#define STEWART_SUSPECT (REAL(4) * STEWART_SQRT(STEWART_EPSILON))
#endif

/* Below this share of the vectors that it is the sum of, a leg has lost so many digits that its column of H
 * may be singular to rounding with others while the pivots are large. */
#define STEWART_SHORT_SHARE (REAL(16) * STEWART_SUSPECT)

/* The same for arms of moments that are no larger than `size`. */
#if !defined(STEWART_LEAST_PIVOTS)
#define STEWART_LEAST_PIVOTS(size) (STEWART_SUSPECT * (size) * (size) * (size))
#endif
"""

FUNCTION = """\
#if !defined(STEWART_SINGULAR_STATUS)
#define STEWART_SINGULAR_STATUS
/* Whether H is singular to rounding: STEWART_OK, STEWART_SINGULAR or STEWART_NOT_FINITE. H is replaced by its
 * inverse Y. `L`: lengths of the legs; `reach`: size of the vectors that a leg is the sum of; `arm`: size of
 * the arms of the moments.
 *
 * A column s of H errs by 4 epsilon (reach / L + 2) at most: half a unit of each number that goes in and of
 * each operation, and what the elimination adds. If H less its error, in size at most E, is singular, then no
 * v > 0 has |Y| E v < v: the spectral radius of |Y| E is 1 or more. Powers of |Y| E make v; 1/2 leaves room
 * for the errors of Y itself. */
STEWART_APART static int singular_status(
    stewart_real H[6][6], const stewart_real *L, const stewart_real *reach, const stewart_real *arm)
{
    stewart_real Y[6][6], error[6], v[6], grown[6];
    stewart_real size = REAL(0), worst = REAL(1);
    int i, j, k, turn;
    for (i = 0; i < 6; ++i) {
        size = STEWART_LARGER(arm[i], size);
        error[i] = REAL(4) * STEWART_EPSILON * (reach[i] / L[i] + REAL(2));
        v[i] = REAL(1);
    }
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            if (!(STEWART_FABS(H[i][j]) <= STEWART_MAX)) {
                return STEWART_NOT_FINITE;
            }
            H[i][j] = i < 3 ? H[i][j] : H[i][j] / size;
            Y[i][j] = i == j ? REAL(1) : REAL(0);
        }
    }
    for (k = 0; k < 6; ++k) {
        int pivot = k;
        for (i = k + 1; i < 6; ++i) {
            pivot = STEWART_FABS(H[i][k]) > STEWART_FABS(H[pivot][k]) ? i : pivot;
        }
        if (!(STEWART_FABS(H[pivot][k]) > REAL(0))) {
            return STEWART_SINGULAR;
        }
        for (j = 0; j < 6; ++j) {
            const stewart_real h = H[k][j], y = Y[k][j];
            H[k][j] = H[pivot][j];
            H[pivot][j] = h;
            Y[k][j] = Y[pivot][j];
            Y[pivot][j] = y;
        }
        for (i = 0; i < 6; ++i) {
            const stewart_real factor = H[i][k] / H[k][k];
            for (j = 0; i != k && j < 6; ++j) {
                H[i][j] = H[i][j] - factor * H[k][j];
                Y[i][j] = Y[i][j] - factor * Y[k][j];
            }
        }
    }
    for (turn = 0; turn < 4 && worst > STEWART_HALF; ++turn) {
        stewart_real force = REAL(0), moment = REAL(0), greatest = REAL(0);
        for (k = 0; k < 6; ++k) {
            force = force + error[k] * v[k];
            moment = moment + (REAL(3) * error[k] * arm[k] / size + REAL(8) * STEWART_EPSILON) * v[k];
        }
        worst = REAL(0);
        for (i = 0; i < 6; ++i) {
            stewart_real by_force = REAL(0), by_moment = REAL(0);
            for (j = 0; j < 3; ++j) {
                by_force = by_force + STEWART_FABS(Y[i][j]);
                by_moment = by_moment + STEWART_FABS(Y[i][j + 3]);
            }
            grown[i] = (by_force * force + by_moment * moment) / STEWART_FABS(H[i][i]);
            worst = grown[i] / v[i] <= worst ? worst : grown[i] / v[i];
            greatest = STEWART_LARGER(grown[i], greatest);
        }
        for (i = 0; i < 6; ++i) {
            v[i] = STEWART_LARGER(grown[i] / greatest, STEWART_EPSILON);
        }
    }
    return worst <= STEWART_HALF ? STEWART_OK : STEWART_SINGULAR;
}
#endif
"""
"""``singular_status``; needs ``STEWART_APART`` and ``c.ARITHMETIC``."""
