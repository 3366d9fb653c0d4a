/* The forces, and how sensitive they are to their inputs, in a type wider than the kernels'. */
#include "arithmetic.h"

#include "stewart_exact_text.h"
#include "sweep.h"

#define EACH(array) (int)(sizeof (array) / sizeof (array)[0])

/* Numbers in a leg's own frame change one by one: what is symmetric stays so, and what is zero. */
static const int of_leg[] = {3, 3, 3, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
static const int of_platform[] = {1, 3, 6, 3};
static const int of_motion[] = MOTION_MEMBERS;

/* Copies quantities, each component moved by at most `amount` of its quantity's largest; or, where `only` is
 * not null, by just that the one component to which it counts down. */
static void move(
    stewart_real **to, const double **from, const int *widths, int count, double amount, uint64_t *seed,
    int *only)
{
    int group, i;
    for (group = 0; group < count; ++group) {
        double largest = 0;
        for (i = 0; i < widths[group]; ++i) {
            const double size = (*from)[i] < 0 ? -(*from)[i] : (*from)[i];
            largest = size > largest ? size : largest;
        }
        for (i = 0; i < widths[group]; ++i) {
            const double share = only ? (*only)-- == 0 : amount > 0 ? between(seed) : 0;
            *(*to)++ = (stewart_real)*(*from)++ + (stewart_real)(amount * share) * (stewart_real)largest;
        }
    }
}

static int solved(
    const double *numbers, const double *motion, double amount, uint64_t *seed, int *only,
    stewart_forces *out)
{
    stewart_robot robot;
    stewart_motion at;
    stewart_real *to = (stewart_real *)&robot;
    int leg;
    for (leg = 0; leg < 6; ++leg) {
        move(&to, &numbers, of_leg, EACH(of_leg), amount, seed, only);
    }
    move(&to, &numbers, of_platform, EACH(of_platform), amount, seed, only);
    to = (stewart_real *)&at;
    move(&to, &motion, of_motion, EACH(of_motion), amount, seed, only);
    return stewart_exact_inverse_dynamics(&robot, &at, out);
}

/* Ratio of the largest to the smallest singular value of H, moments over a length; one-sided Jacobi. */
static double condition(const stewart_real H[6][6], double length)
{
    stewart_real A[6][6], size[6], largest = 0, smallest;
    int sweep, i, j, k;
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 6; ++j) {
            A[j][i] = i < 3 ? H[i][j] : H[i][j] / (stewart_real)length;
        }
    }
    for (sweep = 0; sweep < 12; ++sweep) {
        int turned = 0;
        for (i = 0; i < 5; ++i) {
            for (j = i + 1; j < 6; ++j) {
                stewart_real ii = 0, jj = 0, ij = 0, t, c, s, tau;
                for (k = 0; k < 6; ++k) {
                    ii += A[i][k] * A[i][k];
                    jj += A[j][k] * A[j][k];
                    ij += A[i][k] * A[j][k];
                }
                if (!(ij * ij > (stewart_real)1e-24 * ii * jj)) {
                    continue;
                }
                turned = 1;
                tau = (jj - ii) / (2 * ij);
                t = (tau < 0 ? -1 : 1) / (STEWART_FABS(tau) + STEWART_SQRT(1 + tau * tau));
                c = 1 / STEWART_SQRT(1 + t * t);
                s = c * t;
                for (k = 0; k < 6; ++k) {
                    const stewart_real one = A[i][k];
                    A[i][k] = c * one - s * A[j][k];
                    A[j][k] = s * one + c * A[j][k];
                }
            }
        }
        if (!turned) {
            break;
        }
    }
    for (i = 0; i < 6; ++i) {
        size[i] = 0;
        for (k = 0; k < 6; ++k) {
            size[i] += A[i][k] * A[i][k];
        }
        size[i] = STEWART_SQRT(size[i]);
    }
    smallest = size[0];
    for (i = 0; i < 6; ++i) {
        largest = size[i] > largest ? size[i] : largest;
        smallest = size[i] < smallest ? size[i] : smallest;
    }
    return smallest > 0 ? (double)(largest / smallest) : DBL_MAX;
}

/* How far a rounding unit turns a leg's frame: the largest of 1 over |k x s| and of the terms of S over L. */
static double frames(const double *numbers, const double *motion)
{
    double worst = 1;
    int leg, i;
    for (leg = 0; leg < 6; ++leg) {
        const double *b = numbers + 32 * leg, *p = b + 3, *k = b + 6;
        stewart_real S[3], L = 0, sine, reach = 0, ratio;
        for (i = 0; i < 3; ++i) {
            const stewart_real q = (stewart_real)motion[3 * i] * p[0]
                + (stewart_real)motion[3 * i + 1] * p[1] + (stewart_real)motion[3 * i + 2] * p[2];
            const stewart_real terms[3] = {q, (stewart_real)motion[9 + i], (stewart_real)b[i]};
            int j;
            S[i] = terms[0] + terms[1] - terms[2];
            L += S[i] * S[i];
            for (j = 0; j < 3; ++j) {
                reach = STEWART_FABS(terms[j]) > reach ? STEWART_FABS(terms[j]) : reach;
            }
        }
        L = STEWART_SQRT(L);
        sine = 0;
        for (i = 0; i < 3; ++i) {
            const stewart_real part = k[(i + 1) % 3] * S[(i + 2) % 3] - k[(i + 2) % 3] * S[(i + 1) % 3];
            sine += part * part;
        }
        sine = STEWART_SQRT(sine);
        ratio = sine > 0 ? L / sine : STEWART_MAX;
        ratio = reach > ratio * L ? reach / L : ratio;
        worst = ratio > (stewart_real)worst ? (double)ratio : worst;
    }
    return worst;
}

void OWN(solve)(
    const double *numbers, const double *motion, double length, double amount, int samples, uint64_t seed,
    verdict *out)
{
    stewart_forces truth, moved;
    stewart_real size = 0;
    double sum[6] = {0, 0, 0, 0, 0, 0};
    int sample, i;
    out->status = solved(numbers, motion, 0, &seed, 0, &truth);
    if (out->status != STEWART_OK) {
        return;
    }
    for (i = 0; i < 6; ++i) {
        const stewart_real parts[3] = {truth.F[i], truth.D[i], truth.x[i]};
        int part;
        for (part = 0; part < 3; ++part) {
            size = STEWART_FABS(parts[part]) > size ? STEWART_FABS(parts[part]) : size;
        }
        out->high[i] = (double)truth.F[i];
        out->low[i] = (double)(truth.F[i] - (stewart_real)out->high[i]);
    }
    out->size = (double)size;
    out->own = 0;
    /* Negative: every number by itself, changes added up, instead of random changes of all. */
    for (sample = 0; sample < (samples < 0 ? ROBOT_NUMBERS + MOTION_NUMBERS : samples); ++sample) {
        int only = sample;
        if (solved(numbers, motion, amount, &seed, samples < 0 ? &only : 0, &moved) != STEWART_OK) {
            out->own = 1 / amount;
            break;
        }
        for (i = 0; i < 6; ++i) {
            const double change
                = (double)(STEWART_FABS(moved.F[i] - truth.F[i]) / ((stewart_real)amount * size));
            sum[i] = samples < 0 ? sum[i] + change : change;
            out->own = sum[i] > out->own ? sum[i] : out->own;
        }
    }
    out->frames = frames(numbers, motion);
    out->scaled = condition((const stewart_real(*)[6])truth.H, length);
}
