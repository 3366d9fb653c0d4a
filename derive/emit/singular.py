"""Text by which every C source decides whether H is singular to rounding.

The solves compare their pivots with a limit: of a matrix that is singular to rounding one at least is small.
Where one is, or a leg is short beside what its vector is the sum of, ``singular_status`` decides from bounds
of the rounding error of every entry of H. No dynamics, no solve.
"""

MACROS = """
/* Below this share of the vectors that it is the sum of, a leg has lost so many digits that its column of H
 * may be singular to rounding with others while the pivots are large. */
#if !defined(STEWART_SHORT_SHARE)
#if defined(STEWART_FLOAT)
#define STEWART_SHORT_SHARE REAL(0.0625)
#else
#define STEWART_SHORT_SHARE (REAL(64) * STEWART_SQRT(STEWART_EPSILON))
#endif
#endif

/* Pivot below which H may be singular to rounding, 2^-13 or 2^-7. The product of all pivots of a singular H
 * is a few epsilon: where n of them are small, the least is of the order of the n-th root of epsilon at most.
 * Of singular machines that are nearly singular in other ways as well, it was seen to reach 5e-7, in float
 * 2.5e-3. */
#if !defined(STEWART_SUSPECT)
#if defined(STEWART_FLOAT)
#define STEWART_SUSPECT REAL(0.0078125)
#else
#define STEWART_SUSPECT REAL(0.0001220703125)
#endif
#endif
"""

PRODUCT_MACROS = """
/* Product of the pivots, moments over the size of the platform, below which H may be singular to rounding:
 * that of singular machines was seen to reach epsilon / 5 times 2 + reach / L. Without vector registers it
 * takes fewer instructions than a look at each pivot. */
#if defined(STEWART_FLOAT)
#define STEWART_LEAST_PRODUCT (REAL(64) * STEWART_EPSILON)
#else
#define STEWART_LEAST_PRODUCT (REAL(4) * STEWART_SQRT(STEWART_EPSILON))
#endif

/* The same for arms of moments that are no larger than `size`. */
#define STEWART_LEAST_PIVOTS(size) (STEWART_LEAST_PRODUCT * (size) * (size) * (size))
"""
"""Of the solve of ``scalar``, after MACROS."""

FUNCTION = """\
#if !defined(STEWART_SINGULAR_STATUS)
#define STEWART_SINGULAR_STATUS
/* Whether H is singular to rounding: STEWART_OK, STEWART_SINGULAR or STEWART_NOT_FINITE. H is replaced by its
 * inverse Y. `arm`: of the moments; `L`: lengths of the legs; `reach`: size of the vectors that a leg is the
 * sum of.
 *
 * The direction s of a leg errs by 4 epsilon (reach / L + 2) at most: half a unit of each number that goes in
 * and of each operation, and what the elimination adds. Its column of H, (s, arm x s), errs by that through
 * Y_force + Y_moment x arm, wherever moments are taken about, and by the rounding of the moment. Where H less
 * its error is singular, no v > 0 has G v < v, G_ik what the error of column k does to row i of Y H: the
 * spectral radius of G is 1 or more. Powers of G make v; 1/2 leaves room for the errors of Y itself. */
STEWART_APART static int singular_status(
    stewart_real H[6][6], stewart_real arm[6][3], const stewart_real *L, const stewart_real *reach)
{
    stewart_real Y[6][6], G[6][6], v[6], grown[6];
    stewart_real size = REAL(0), worst = REAL(1);
    int i, j, k, turn;
    for (i = 0; i < 6; ++i) {
        v[i] = REAL(1);
        for (j = 0; j < 3; ++j) {
            size = STEWART_LARGER(STEWART_FABS(arm[i][j]), size);
        }
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
    for (i = 0; i < 6; ++i) {
        const stewart_real by_moment = STEWART_FABS(Y[i][3]) + STEWART_FABS(Y[i][4]) + STEWART_FABS(Y[i][5]);
        for (k = 0; k < 6; ++k) {
            stewart_real turned = REAL(0);
            for (j = 0; j < 3; ++j) {
                const int next = (j + 1) % 3, last = (j + 2) % 3;
                turned = turned + STEWART_FABS(Y[i][j]
                    + (Y[i][3 + next] * arm[k][last] - Y[i][3 + last] * arm[k][next]) / size);
            }
            G[i][k] = (turned * (reach[k] / L[k] + REAL(2)) + REAL(2) * by_moment)
                * (REAL(4) * STEWART_EPSILON) / STEWART_FABS(H[i][i]);
        }
    }
    for (turn = 0; turn < 4 && worst > STEWART_HALF; ++turn) {
        stewart_real greatest = REAL(0);
        worst = REAL(0);
        for (i = 0; i < 6; ++i) {
            grown[i] = REAL(0);
            for (k = 0; k < 6; ++k) {
                grown[i] = grown[i] + G[i][k] * v[k];
            }
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
