/* loop.c: a 1 kHz computed-torque loop on the kit of a robot, with the machine itself simulated beside it.
 *
 *     loop [--cycles N] [--paced]
 *
 * Each cycle the controller adds what its errors ask for to the wanted accelerations,
 *
 *     a     = a_w     + k_d (v_w - v)         + k_p (t_w - t)
 *     alpha = alpha_w + k_d (omega_w - omega) + k_p e,   e the rotation vector of R_w R^T, base axes,
 *
 * and has the kit's inverse dynamics turn them into forces of the legs; these are held over the cycle, in which
 * the kit's forward dynamics moves the machine by Runge-Kutta steps on position, quaternion and rates. Cycles
 * follow each other at once, or with --paced at ticks of 1 ms.
 *
 * Returns 0 if the machine kept to the path and every call said STEWART_OK. Late cycles are counted, no more.
 */
#define _POSIX_C_SOURCE 200809L

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "stewart_robot.h"
#include "stewart_exact_forces.h"
#include "stewart_exact_motion.h"

#define ROBOT stewart_robot_client_hexapod

enum { MOST_CYCLES = 100000, SUBSTEPS = 2, STATE = 13 };

static const double PERIOD = 1e-3;    /* s */
static const double DEADLINE = 1e3;   /* us */
static const double K_P = 900.0;      /* 1/s^2 */
static const double K_D = 60.0;       /* 1/s */
static const double START_OFF = 1e-4; /* m and rad, in each coordinate */
static const double SETTLED = 1.0;    /* s: by then the start is forgotten */

/* m and rad: how far off the path the machine may ever be, and may be once the start is forgotten. The second
 * is left by holding the forces over a cycle. */
static const double EVER_OFF = 2e-4;
static const double SETTLED_OFF = 2e-5;

/* Numbers of a state: position t, quaternion (w, x, y, z) of R, velocity v, angular velocity omega. */
enum { T = 0, Q = 3, V = 7, OMEGA = 10 };

/* --- rotations -------------------------------------------------------------------------------- */

static void matrix_of(const double q[4], double R[9])
{
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    R[0] = 1.0 - 2.0 * (y * y + z * z);
    R[1] = 2.0 * (x * y - w * z);
    R[2] = 2.0 * (x * z + w * y);
    R[3] = 2.0 * (x * y + w * z);
    R[4] = 1.0 - 2.0 * (x * x + z * z);
    R[5] = 2.0 * (y * z - w * x);
    R[6] = 2.0 * (x * z - w * y);
    R[7] = 2.0 * (y * z + w * x);
    R[8] = 1.0 - 2.0 * (x * x + y * y);
}

/* p q */
static void product(const double p[4], const double q[4], double out[4])
{
    out[0] = p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3];
    out[1] = p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2];
    out[2] = p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1];
    out[3] = p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0];
}

/* Rotation vector e, rad, of the turn that takes q to q_w, base axes: of the shorter way round. */
static void turn_between(const double q_w[4], const double q[4], double e[3])
{
    const double back[4] = {q[0], -q[1], -q[2], -q[3]};
    double d[4], sine, factor;
    product(q_w, back, d);
    sine = sqrt(d[1] * d[1] + d[2] * d[2] + d[3] * d[3]);
    factor = sine > 1e-9 ? 2.0 * atan2(sine, fabs(d[0])) / sine : 2.0;
    factor = d[0] < 0.0 ? -factor : factor;
    e[0] = factor * d[1];
    e[1] = factor * d[2];
    e[2] = factor * d[3];
}

static void normalize(double q[4])
{
    const double size = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    int i;
    for (i = 0; i < 4; ++i) {
        q[i] /= size;
    }
}

/* --- the path --------------------------------------------------------------------------------- */

/* Position middle + amplitude sin(rate time); a turn about a fixed axis by an angle of the same form. */
static const double MIDDLE[3] = {0.0, 0.0, 0.7};          /* m */
static const double AMPLITUDE[4] = {0.08, 0.05, 0.06, 0.2}; /* m, m, m, rad */
static const double RATE[4] = {2.0, 3.1, 2.6, 2.3};       /* rad/s */
static const double AXIS[3] = {2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0};

/* The wanted state and accelerations [a; alpha] at a time, s. */
static void wanted(double time, double state[STATE], double acceleration[6])
{
    double s[4], c[4];
    double half;
    int i;
    for (i = 0; i < 4; ++i) {
        s[i] = AMPLITUDE[i] * sin(RATE[i] * time);
        c[i] = AMPLITUDE[i] * RATE[i] * cos(RATE[i] * time);
    }
    half = 0.5 * s[3];
    state[Q] = cos(half);
    for (i = 0; i < 3; ++i) {
        state[T + i] = MIDDLE[i] + s[i];
        state[V + i] = c[i];
        acceleration[i] = -RATE[i] * RATE[i] * s[i];
        state[Q + 1 + i] = AXIS[i] * sin(half);
        state[OMEGA + i] = AXIS[i] * c[3];
        acceleration[3 + i] = -AXIS[i] * RATE[3] * RATE[3] * s[3];
    }
}

/* --- controller and machine ------------------------------------------------------------------- */

static void motion_of(const double state[STATE], stewart_motion *motion)
{
    (void)memset(motion, 0, sizeof *motion);
    matrix_of(state + Q, motion->R);
    (void)memcpy(motion->t, state + T, sizeof motion->t);
    (void)memcpy(motion->v, state + V, sizeof motion->v);
    (void)memcpy(motion->omega, state + OMEGA, sizeof motion->omega);
}

/* Forces of the legs, N, from the measured state. Returns a status. */
static int control(const stewart_exact_model *model, double time, const double state[STATE], double F[6])
{
    double goal[STATE], acceleration[6], e[3];
    stewart_motion motion;
    int i;
    wanted(time, goal, acceleration);
    turn_between(goal + Q, state + Q, e);
    motion_of(state, &motion);
    for (i = 0; i < 3; ++i) {
        motion.a[i] = acceleration[i] + K_D * (goal[V + i] - state[V + i]) + K_P * (goal[T + i] - state[T + i]);
        motion.alpha[i] = acceleration[3 + i] + K_D * (goal[OMEGA + i] - state[OMEGA + i]) + K_P * e[i];
    }
    return stewart_exact_forces(model, &motion, F);
}

static int rates(const stewart_exact_model *model, const double state[STATE], const double F[6], double rate[STATE])
{
    const double turning[4] = {0.0, 0.5 * state[OMEGA], 0.5 * state[OMEGA + 1], 0.5 * state[OMEGA + 2]};
    double acceleration[6];
    stewart_motion motion;
    int status;
    motion_of(state, &motion);
    status = stewart_exact_forward_dynamics(model, &motion, F, acceleration);
    if (status == STEWART_OK) {
        (void)memcpy(rate + T, state + V, 3 * sizeof *rate);
        product(turning, state + Q, rate + Q);
        (void)memcpy(rate + V, acceleration, 6 * sizeof *rate);
    }
    return status;
}

/* Moves the machine on by h, s, under held forces: the classical method of fourth order. Returns a status. */
static int step(const stewart_exact_model *model, double h, const double F[6], double state[STATE])
{
    static const double AHEAD[4] = {0.0, 0.5, 0.5, 1.0};
    static const double WEIGHT[4] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    double rate[STATE] = {0.0}, at[STATE], sum[STATE] = {0.0};
    int stage, i;
    for (stage = 0; stage < 4; ++stage) {
        int status;
        for (i = 0; i < STATE; ++i) {
            at[i] = state[i] + AHEAD[stage] * h * rate[i];
        }
        normalize(at + Q);
        status = rates(model, at, F, rate);
        if (status != STEWART_OK) {
            return status;
        }
        for (i = 0; i < STATE; ++i) {
            sum[i] += WEIGHT[stage] * rate[i];
        }
    }
    for (i = 0; i < STATE; ++i) {
        state[i] += h * sum[i];
    }
    normalize(state + Q);
    return STEWART_OK;
}

/* --- time ------------------------------------------------------------------------------------- */

static double microseconds(const struct timespec *from, const struct timespec *to)
{
    return 1e6 * (double)(to->tv_sec - from->tv_sec) + 1e-3 * (double)(to->tv_nsec - from->tv_nsec);
}

static void tick_on(struct timespec *tick)
{
    tick->tv_nsec += (long)(1e9 * PERIOD);
    if (tick->tv_nsec >= 1000000000L) {
        tick->tv_nsec -= 1000000000L;
        ++tick->tv_sec;
    }
}

static int in_order(const void *left, const void *right)
{
    const double x = *(const double *)left, y = *(const double *)right;
    return (x > y) - (x < y);
}

/* Prints and sorts the times of `count` cycles, us. */
static void told(const char *what, double *times, int count)
{
    int i, late = 0;
    for (i = 0; i < count; ++i) {
        late += times[i] > DEADLINE;
    }
    qsort(times, (size_t)count, sizeof *times, in_order);
    (void)printf("%s, us: min %.2f, median %.2f, 99.9 %% %.2f, max %.2f; over 1 ms: %d\n", what, times[0],
        times[count / 2], times[(int)(0.999 * (count - 1))], times[count - 1], late);
}

/* --- the loop --------------------------------------------------------------------------------- */

/* The most so far; once it is NaN it stays so. */
static double larger(double x, double most)
{
    return x <= most || isnan(most) ? most : x;
}

static double size_of(const double x[3])
{
    return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

int main(int argc, char **argv)
{
    static double thinking[MOST_CYCLES], whole[MOST_CYCLES], waking[MOST_CYCLES];
    static stewart_exact_model model;
    double state[STATE], goal[STATE], acceleration[6], F[6], off[3], e[3];
    double ever_t = 0.0, ever_phi = 0.0, settled_t = 0.0, settled_phi = 0.0, largest = 0.0;
    struct timespec tick, begun, decided, done;
    int cycles = MOST_CYCLES, paced = 0, cycle, substep, i;
    int status = stewart_exact_prepare(&ROBOT, &model);
    for (i = 1; i < argc; ++i) {
        if (strcmp(argv[i], "--paced") == 0) {
            paced = 1;
        } else if (strcmp(argv[i], "--cycles") == 0 && i + 1 < argc) {
            cycles = atoi(argv[++i]);
        } else {
            cycles = 0;
        }
    }
    if (cycles < 1 || cycles > MOST_CYCLES) {
        (void)fprintf(stderr, "usage: loop [--cycles 1..%d] [--paced]\n", MOST_CYCLES);
        return 2;
    }

    wanted(0.0, state, acceleration);
    for (i = 0; i < 3; ++i) {
        state[T + i] += START_OFF;
    }
    {
        /* exp of the rotation vector START_OFF (1, 1, 1), before the wanted turn */
        const double half = 0.5 * sqrt(3.0) * START_OFF, part = sin(half) / sqrt(3.0);
        const double shift[4] = {cos(half), part, part, part};
        wanted(0.0, goal, acceleration);
        product(shift, goal + Q, state + Q);
    }

    (void)clock_gettime(CLOCK_MONOTONIC, &tick);
    for (cycle = 0; cycle < cycles && status == STEWART_OK; ++cycle) {
        const double time = cycle * PERIOD;
        if (paced) {
            tick_on(&tick);
            while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &tick, NULL) != 0) {
            }
        }
        (void)clock_gettime(CLOCK_MONOTONIC, &begun);
        status = control(&model, time, state, F);
        (void)clock_gettime(CLOCK_MONOTONIC, &decided);
        for (substep = 0; substep < SUBSTEPS && status == STEWART_OK; ++substep) {
            status = step(&model, PERIOD / SUBSTEPS, F, state);
        }
        wanted(time + PERIOD, goal, acceleration);
        turn_between(goal + Q, state + Q, e);
        for (i = 0; i < 3; ++i) {
            off[i] = goal[T + i] - state[T + i];
        }
        ever_t = larger(size_of(off), ever_t);
        ever_phi = larger(size_of(e), ever_phi);
        if (time >= SETTLED) {
            settled_t = larger(size_of(off), settled_t);
            settled_phi = larger(size_of(e), settled_phi);
        }
        for (i = 0; i < 6; ++i) {
            largest = larger(fabs(F[i]), largest);
        }
        (void)clock_gettime(CLOCK_MONOTONIC, &done);
        thinking[cycle] = microseconds(&begun, &decided);
        waking[cycle] = paced ? microseconds(&tick, &begun) : 0.0;
        whole[cycle] = waking[cycle] + microseconds(&begun, &done);
    }
    if (status != STEWART_OK) {
        (void)printf("cycle %d: status %d, see stewart.h\n", cycle, status);
        return 1;
    }

    (void)printf("cycles: %d\n", cycles);
    (void)printf("worst error: %.3g m, %.3g rad\n", ever_t, ever_phi);
    (void)printf("worst error after %g s: %.3g m, %.3g rad\n", SETTLED, settled_t, settled_phi);
    (void)printf("largest force: %.9g N\n", largest);
    (void)printf("at the end:");
    for (i = 0; i < STATE; ++i) {
        (void)printf(" %.17g", state[i]);
    }
    (void)printf("\n");
    told("controller", thinking, cycles);
    if (paced) {
        told("waking up", waking, cycles);
    }
    told("cycle", whole, cycles);
    if (ever_t <= EVER_OFF && ever_phi <= EVER_OFF && settled_t <= SETTLED_OFF && settled_phi <= SETTLED_OFF) {
        return 0;
    }
    (void)printf("too far off the path: allowed are %g and, after %g s, %g m and rad\n", EVER_OFF, SETTLED,
        SETTLED_OFF);
    return 1;
}
