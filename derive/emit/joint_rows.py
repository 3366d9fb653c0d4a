"""C of forward dynamics where M's factors lose digits: the legs' inertia stays in their joint coordinates.

Near a joint singularity, with a very short or a very heavy leg, M is the sum of large parts that act in a few
directions and of small ones, which are rounded away. Here M = A^T W A with three rows of A for each leg and
six of the platform, and weights W of about one in blocks of three. Elimination with complete pivoting picks
the six stiffest rows, and their accelerations become the unknowns: no large number is added to a small one.
Texts alone, used by ``motion``.
"""

FORWARD_APART = """\
/* M = A^T W A: three rows for each leg, by L, theta, phi, and six of the platform. Each row of A carries the
 * root of its inertia, so that blocks of weights are of about one. Six rows serve as coordinates. */
#define ROWS 24

typedef struct {
    stewart_real weight[8][9];   /* of three rows each */
    stewart_real size[ROWS];     /* root of the inertia that is in the row */
    stewart_real share[ROWS][6]; /* the row as a sum of the six that serve as coordinates */
    stewart_real factors[6][6];  /* L and U of these six, columns in the order of `column` */
    stewart_real inertia[6][6];  /* M in these coordinates */
    stewart_real length;         /* m: moments and rotations are measured by it */
    int pivot[6], column[6];
} row_factors;

/* Inertia of three coordinates, xx xy xz yy yz zz, as weights of rows of these sizes. */
static void weigh(const stewart_real *inertia, const stewart_real *size, stewart_real *weight)
{
    static const int place[9] = {0, 1, 2, 1, 3, 4, 2, 4, 5};
    int i;
    for (i = 0; i < 9; ++i) {
        weight[i] = inertia[place[i]] / size[i / 3] / size[i % 3];
    }
}

/* Rows and weights of the legs. `least` is far below the root of any mass that counts. */
static void leg_rows(
    const joint_rows_legs *legs, stewart_real least, stewart_real (*row)[6], row_factors *by)
{
    int l, i, j;
    for (l = 0; l < 6; ++l) {
        stewart_real *size = &by->size[3 * l];
        stewart_real inertia[6];
        const stewart_real reach = least * legs->judged.L[l];
        for (i = 0; i < 6; ++i) {
            inertia[i] = legs->M_xi[i][l];
        }
        size[1] = STEWART_LARGER(STEWART_SQRT(STEWART_FABS(inertia[3])), reach);
        size[2] = STEWART_LARGER(STEWART_SQRT(STEWART_FABS(inertia[5])), reach * legs->judged.k3[l]);
        size[0] = STEWART_LARGER(STEWART_FABS(inertia[1]) / size[1], STEWART_FABS(inertia[2]) / size[2]);
        size[0] = STEWART_LARGER(size[0], STEWART_SQRT(STEWART_FABS(inertia[0])));
        size[0] = STEWART_LARGER(size[0], least);
        weigh(inertia, size, by->weight[l]);
        for (i = 0; i < 3; ++i) {
            for (j = 0; j < 3; ++j) {
                row[3 * l + i][j] = size[i] * legs->row_v[3 * i + j][l];
                row[3 * l + i][j + 3] = size[i] * (legs->row_w[3 * i + j][l] / by->length);
            }
        }
    }
}

/* Rows and weights of the platform from its part of M: its centre of mass, and rotation about it. */
static void platform_rows(
    const stewart_real *sum, stewart_real least, stewart_real (*row)[6], row_factors *by)
{
    static const int axis[3] = {15, 18, 20};
    const stewart_real mass = sum[0], heft = STEWART_LARGER(STEWART_SQRT(STEWART_FABS(mass)), least);
    const stewart_real per_mass = mass > REAL(0) ? REAL(1) / mass : REAL(0);
    const stewart_real c[3] = {sum[11] * per_mass, -sum[8] * per_mass, sum[7] * per_mass};
    const stewart_real whole[6] = {mass, REAL(0), REAL(0), mass, REAL(0), mass};
    stewart_real about[6];
    int i, j, place = 0;
    for (i = 0; i < 3; ++i) {
        for (j = i; j < 3; ++j) {
            const stewart_real square = i == j ? c[0] * c[0] + c[1] * c[1] + c[2] * c[2] : REAL(0);
            about[place] = sum[15 + place] - mass * (square - c[i] * c[j]);
            ++place;
        }
        by->size[18 + i] = heft;
    }
    for (i = 0; i < 3; ++i) {
        const stewart_real turned = STEWART_SQRT(STEWART_FABS(about[axis[i] - 15]));
        by->size[21 + i] = STEWART_LARGER(turned, least * by->length);
        for (j = 0; j < 3; ++j) {
            row[18 + i][j] = i == j ? heft : REAL(0);
            row[21 + i][j] = REAL(0);
            row[21 + i][j + 3] = i == j ? by->size[21 + i] / by->length : REAL(0);
        }
        row[18 + i][i + 3] = REAL(0);
        row[18 + i][(i + 1) % 3 + 3] = heft * (c[(i + 2) % 3] / by->length);
        row[18 + i][(i + 2) % 3 + 3] = -heft * (c[(i + 1) % 3] / by->length);
    }
    weigh(whole, &by->size[18], by->weight[6]);
    weigh(about, &by->size[21], by->weight[7]);
}

static void swap(stewart_real *one, stewart_real *other)
{
    const stewart_real moved = *one;
    *one = *other;
    *other = moved;
}

/* Brings the largest number of rows and columns from k on to row and column k. */
static void bring_largest(stewart_real (*row)[6], int k, int *order, row_factors *by)
{
    int i, j, best = k, across = k;
    for (i = k; i < ROWS; ++i) {
        for (j = k; j < 6; ++j) {
            if (STEWART_FABS(row[i][j]) > STEWART_FABS(row[best][across])) {
                best = i;
                across = j;
            }
        }
    }
    i = order[k];
    order[k] = order[best];
    order[best] = i;
    j = by->column[k];
    by->column[k] = by->column[across];
    by->column[across] = j;
    for (j = 0; j < 6; ++j) {
        swap(&row[k][j], &row[best][j]);
    }
    for (i = 0; i < ROWS; ++i) {
        swap(&row[i][k], &row[i][across]);
    }
}

/* Picks six rows as coordinates and writes the others as sums of them. */
static void eliminate_rows(stewart_real (*row)[6], row_factors *by)
{
    int order[ROWS], i, j, k;
    for (i = 0; i < ROWS; ++i) {
        order[i] = i;
        by->column[i % 6] = i % 6;
    }
    for (k = 0; k < 6; ++k) {
        bring_largest(row, k, order, by);
        for (i = k + 1; i < ROWS; ++i) {
            row[i][k] = row[i][k] / row[k][k];
            for (j = k + 1; j < 6; ++j) {
                row[i][j] = row[i][j] - row[i][k] * row[k][j];
            }
        }
    }
    for (i = 0; i < ROWS; ++i) {
        stewart_real *share = by->share[order[i]];
        for (j = 5; j >= 0; --j) {
            share[j] = i < 6 ? (i == j ? REAL(1) : REAL(0)) : row[i][j];
            for (k = j + 1; i >= 6 && k < 6; ++k) {
                share[j] = share[j] - share[k] * row[k][j];
            }
        }
    }
    for (k = 0; k < 6; ++k) {
        by->pivot[k] = order[k];
        for (j = 0; j < 6; ++j) {
            by->factors[k][j] = row[k][j];
        }
    }
}

static void factor_rows(const joint_rows_legs *legs, const stewart_real *sum, row_factors *by)
{
    stewart_real row[ROWS][6], least = STEWART_FABS(sum[0]);
    int l, i, j, k;
    by->length = REAL(0);
    for (l = 0; l < 6; ++l) {
        const stewart_real L = legs->judged.L[l], rho = L * legs->judged.k3[l];
        for (i = 0; i < 3; ++i) {
            by->length = STEWART_LARGER(STEWART_FABS(legs->row_w[i][l]), by->length);
        }
        least = STEWART_LARGER(STEWART_FABS(legs->M_xi[3][l]) / L / L, least);
        least = STEWART_LARGER(STEWART_FABS(legs->M_xi[5][l]) / rho / rho, least);
    }
    least = STEWART_LARGER(STEWART_EPSILON * STEWART_SQRT(least), STEWART_SHORTEST);
    by->length = by->length > REAL(0) ? by->length : REAL(1);
    leg_rows(legs, least, row, by);
    platform_rows(sum, least, row, by);
    eliminate_rows(row, by);
    for (k = 0; k < 36; ++k) {
        by->inertia[k / 6][k % 6] = REAL(0);
    }
    for (i = 0; i < ROWS; ++i) {
        for (j = 0; j < 3; ++j) {
            const stewart_real weight = by->weight[i / 3][i % 3 * 3 + j];
            for (k = 0; k < 36; ++k) {
                const stewart_real one = by->share[i][k / 6], other = by->share[i / 3 * 3 + j][k % 6];
                by->inertia[k / 6][k % 6] = by->inertia[k / 6][k % 6] + one * weight * other;
            }
        }
    }
}

/* Accelerations of the rows that serve as coordinates, and of no others, under which the inertia of each
 * block balances the forces of these rows; `balanced` says which they are, without those that have no inertia
 * of their own beside the rows before them. */
static void balance(
    const row_factors *by, const stewart_real *force, stewart_real (*moved)[3], int (*balanced)[3])
{
    int b, i, j, k;
    for (i = 0; i < ROWS; ++i) {
        balanced[i / 3][i % 3] = 0;
        moved[i / 3][i % 3] = force[i];
    }
    for (k = 0; k < 6; ++k) {
        balanced[by->pivot[k] / 3][by->pivot[k] % 3] = 1;
    }
    for (b = 0; b < ROWS / 3; ++b) {
        stewart_real W[3][3];
        for (i = 0; i < 9; ++i) {
            W[i / 3][i % 3] = by->weight[b][i];
        }
        for (k = 0; k < 3; ++k) {
            balanced[b][k] = W[k][k] > STEWART_KEPT ? balanced[b][k] : 0;
            for (i = k + 1; balanced[b][k] != 0 && i < 3; ++i) {
                const stewart_real factor = W[i][k] / W[k][k];
                moved[b][i] = moved[b][i] - factor * moved[b][k];
                for (j = k + 1; j < 3; ++j) {
                    W[i][j] = W[i][j] - factor * W[k][j];
                }
            }
        }
        for (k = 2; k >= 0; --k) {
            for (j = k + 1; j < 3; ++j) {
                moved[b][k] = moved[b][k] - W[k][j] * moved[b][j];
            }
            moved[b][k] = balanced[b][k] != 0 ? moved[b][k] / W[k][k] : REAL(0);
        }
    }
}

/* What six coordinates' accelerations must balance, of the rows' forces and a wrench.
 *
 * force: of each row, as its generalised force over its size, without accelerations. start: accelerations of
 * the coordinates that balance their own large forces, from which the unknown ones are measured; rest: the
 * rows' forces there. */
static void row_right(
    const row_factors *by, const stewart_real *force, const stewart_real *wrench, stewart_real *start,
    stewart_real *rest, stewart_real *right)
{
    stewart_real moved[ROWS / 3][3], y[6];
    int balanced[ROWS / 3][3];
    int i, j, k;
    balance(by, force, moved, balanced);
    for (k = 0; k < 6; ++k) {
        start[k] = moved[by->pivot[k] / 3][by->pivot[k] % 3];
        y[k] = wrench[by->column[k]] / (by->column[k] < 3 ? REAL(1) : by->length);
    }
    for (i = 0; i < ROWS; ++i) {
        moved[i / 3][i % 3] = REAL(0);
        for (k = 0; k < 6; ++k) {
            moved[i / 3][i % 3] = moved[i / 3][i % 3] + by->share[i][k] * start[k];
        }
    }
    for (i = 0; i < ROWS; ++i) {
        const int b = i / 3, own = balanced[b][i % 3];
        rest[i] = own != 0 ? REAL(0) : force[i];
        for (j = 0; j < 3; ++j) {
            if (own == 0 || balanced[b][j] == 0) {
                rest[i] = rest[i] - by->weight[b][i % 3 * 3 + j] * moved[b][j];
            }
        }
    }
    for (k = 0; k < 6; ++k) {
        for (j = 0; j < k; ++j) {
            y[k] = y[k] - by->factors[j][k] * y[j];
        }
        y[k] = y[k] / by->factors[k][k];
    }
    for (k = 5; k >= 0; --k) {
        for (j = k + 1; j < 6; ++j) {
            y[k] = y[k] - by->factors[j][k] * y[j];
        }
    }
    for (k = 0; k < 6; ++k) {
        right[k] = y[k];
        for (i = 0; i < ROWS; ++i) {
            right[k] = right[k] - by->share[i][k] * rest[i];
        }
    }
}

/* [a; alpha] from the coordinates' accelerations. */
static void row_back(
    const row_factors *by, const stewart_real *found, const stewart_real *start, stewart_real *acceleration)
{
    stewart_real x[6];
    int j, k;
    for (k = 0; k < 6; ++k) {
        x[k] = found[k] - start[k];
        for (j = 0; j < k; ++j) {
            x[k] = x[k] - by->factors[k][j] * x[j];
        }
    }
    for (k = 5; k >= 0; --k) {
        for (j = k + 1; j < 6; ++j) {
            x[k] = x[k] - by->factors[k][j] * x[j];
        }
        x[k] = x[k] / by->factors[k][k];
        acceleration[by->column[k]] = x[k] / (by->column[k] < 3 ? REAL(1) : by->length);
    }
}

/* Of each leg the generalised forces, the accelerations that those of the platform give to it, and the share
 * of the inertia about its own axis beside k3 times that of its tip. */
static void rows_held(
    const row_factors *by, const leg_judgement *judged, const stewart_real *found, const stewart_real *start,
    const stewart_real *rest, stewart_real (*apart)[LANES])
{
    stewart_real whole[ROWS];
    int l, i, j;
    for (i = 0; i < ROWS; ++i) {
        whole[i] = REAL(0);
        for (j = 0; j < 6; ++j) {
            whole[i] = whole[i] + by->share[i][j] * found[j];
        }
    }
    for (l = 0; l < LANES; ++l) {
        const stewart_real *size = &by->size[3 * (l < 6 ? l : 5)];
        const stewart_real k3 = judged->k3[l], tip = judged->L[l] * size[0];
        const stewart_real share = tip / size[1] * (tip / size[2] * k3);
        apart[6][l] = k3 < STEWART_LEANING ? k3 / (k3 + share * share * (share * share)) : REAL(1);
        for (i = 0; i < 3; ++i) {
            const int row = 3 * (l < 6 ? l : 5) + i;
            stewart_real force = rest[row], turned = REAL(0);
            for (j = 0; j < 3; ++j) {
                force = force + by->weight[row / 3][3 * i + j] * whole[row - i + j];
            }
            for (j = 0; j < 6; ++j) {
                turned = turned + by->share[row][j] * (found[j] - start[j]);
            }
            apart[i][l] = force * by->size[row];
            apart[i + 3][l] = turned / by->size[row];
        }
    }
}

/* Forward dynamics where M's factors would lose digits; apart: the legs' generalised forces, without the
 * actuators', the accelerations that those of the platform give to L, theta, phi, and shares of the inertias
 * about the legs' axes. Returns a status. */
static int forward_apart(
    const stewart_@NAME@_model *model, const stewart_motion *motion, const stewart_real F[6],
    row_factors *by, stewart_real (*apart)[LANES], stewart_real acceleration[6])
{
    joint_rows_legs legs;
    stewart_real A[48], sum[27], force[ROWS], rest[ROWS], start[6], right[6], found[6];
    int i, status = joint_rows_sums(model, motion, F, &legs, sum);
    if (status != STEWART_OK) {
        return status;
    }
    factor_rows(&legs, sum, by);
    for (i = 0; i < ROWS; ++i) {
        force[i] = i < 18 ? legs.tau[i % 3][i / 3] / by->size[i] : REAL(0);
    }
    row_right(by, force, &sum[21], start, rest, right);
    for (i = 0; i < 6; ++i) {
        copy(by->inertia[i], 6, &A[8 * i]);
        A[8 * i + 6] = right[i];
        A[8 * i + 7] = REAL(0);
    }
    status = solve_definite_8(A, STEWART_ROUNDING);
    if (status != STEWART_OK) {
        return status;
    }
    for (i = 0; i < 6; ++i) {
        right[i] = A[8 * i + 6];
    }
    row_back(by, right, start, found);
    if (is_finite(found, 6) == 0) {
        return STEWART_NOT_FINITE;
    }
    copy(found, 6, acceleration);
    rows_held(by, &legs.judged, right, start, rest, apart);
    return STEWART_OK;
}
"""
"""Forward dynamics, and what it is made of."""

SLOPES_APART = """\
/* M^-1 times the derivatives of the wrench and H, columns 6 to 23 of the rows of A, as forward_apart solves.
 * Returns a status. */
static int slopes_apart(
    const stewart_@NAME@_model *model, const stewart_motion *motion, const row_factors *by,
    stewart_real (*apart)[LANES], stewart_real A[144])
{
    joint_slopes_legs legs;
    stewart_real sum[93], start[18][6];
    int i, c, status = joint_slopes_sums(model, motion, apart, &legs, sum);
    if (status != STEWART_OK) {
        return status;
    }
    block_rows(&sum[21], 24, &A[6]);
    block_rows(&sum[57], 24, &A[12]);
    column_rows(legs.H_force, legs.H_moment, 24, &A[18]);
    for (c = 0; c < 18; ++c) {
        stewart_real (*const tau[4])[LANES] = {legs.tau_t, legs.tau_r, legs.tau_v, legs.tau_w};
        stewart_real wrench[6], right[6], force[ROWS], rest[ROWS];
        for (i = 0; i < ROWS; ++i) {
            force[i] = i < 18 && c < 12 ? -tau[c / 3][i % 3 * 3 + c % 3][i / 3] / by->size[i] : REAL(0);
        }
        for (i = 0; i < 6; ++i) {
            wrench[i] = A[24 * i + 6 + c];
        }
        row_right(by, force, wrench, start[c], rest, right);
        for (i = 0; i < 6; ++i) {
            A[24 * i + 6 + c] = right[i];
        }
    }
    for (i = 0; i < 6; ++i) {
        copy(by->inertia[i], 6, &A[24 * i]);
    }
    status = solve_definite_24(A, STEWART_ROUNDING);
    for (c = 0; status == STEWART_OK && c < 18; ++c) {
        stewart_real found[6], acceleration[6];
        for (i = 0; i < 6; ++i) {
            found[i] = A[24 * i + 6 + c];
        }
        row_back(by, found, start[c], acceleration);
        for (i = 0; i < 6; ++i) {
            A[24 * i + 6 + c] = acceleration[i];
        }
    }
    return status;
}
"""
"""The linearisation's solve in the same coordinates."""
