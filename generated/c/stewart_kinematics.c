/* stewart_kinematics.c: functions that are declared and described in stewart_kinematics.h.
 *
 * Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include "stewart_kinematics.h"

#include "stewart_arithmetic.h"

/* Vectors of a leg. */
typedef struct {
    stewart_real q[3]; /* m: platform point from the reference point, base frame */
    stewart_real S[3]; /* m: vector from base point to platform point, base frame */
    stewart_real L; /* m: length of the leg */
} leg_vectors;

/* A leg's row of J. */
typedef struct {
    stewart_real H_force[3]; /* 1: the leg's column of H, force rows */
    stewart_real H_moment[3]; /* m: the leg's column of H, moment rows */
} leg_row;

/* A leg's rate. */
typedef struct {
    stewart_real L_dot; /* m/s: rate of the leg's length, positive when it extends */
} leg_rate;

/* A rotation. */
typedef struct {
    stewart_real Q[9]; /* 1: rotation matrix of this rotation, base frame */
} small_turn;

/* Lengths of six legs and their rates. */
typedef struct {
    stewart_real L[6]; /* m: lengths, (2) */
    stewart_real L_dot[6]; /* m/s: rates, (5) */
    int status; /* 0, or the code of an error */
} leg_rates;

/* Six legs at a pose, and their equations. */
typedef struct {
    stewart_real A[6][7]; /* 1: rows [s, q x s / size] of J, and a right side; then a triangle */
    leg_vectors leg[6]; /* the legs */
    stewart_real extent; /* m: largest distance of a joint from the origin of its part */
    stewart_real reach; /* m: size of the terms of S = q + t - b */
    stewart_real of_inverse; /* 1: square of the size of J^-1 */
    stewart_real last; /* m^2: square of the last step of a search */
    int straight; /* 1 if each step reduced the largest length error by 30 % */
} legs_at_pose;

/* Nearest pose that the searches found. */
typedef struct {
    stewart_pose guess; /* the guess */
    stewart_pose pose; /* the nearest pose to it */
    stewart_real away; /* m^2 and rad^2: square of the distance between both */
    stewart_real basin; /* rad^2: square of a distance from which steps lead to the pose */
} nearest_pose;

/* Result of the search for a pose. */
typedef struct {
    stewart_pose pose; /* the pose */
    int status; /* 0, or the code of an error */
} found_pose;

/* Velocity of the platform. */
typedef struct {
    stewart_real v[3]; /* m/s: of the reference point */
    stewart_real omega[3]; /* rad/s: angular velocity, base frame */
    int status; /* 0, or the code of an error */
} twist;

/* Vectors q and S of one leg, and its length L, (1), (2): 27 (12 mul, 14 add, 0 div, 1 sqrt). */
static leg_vectors vectors_of(const stewart_leg *leg, const stewart_pose *pose)
{
    const stewart_real R_xx = pose->R[0], R_xy = pose->R[1], R_xz = pose->R[2], R_yx = pose->R[3], R_yy = pose->R[4],
        R_yz = pose->R[5], R_zx = pose->R[6], R_zy = pose->R[7], R_zz = pose->R[8];
    const stewart_real t_x = pose->t[0], t_y = pose->t[1], t_z = pose->t[2];
    const stewart_real b_x = leg->b[0], b_y = leg->b[1], b_z = leg->b[2];
    const stewart_real p_x = leg->p[0], p_y = leg->p[1], p_z = leg->p[2];
    /* (1) platform point from the reference point */
    const stewart_real q_x = (R_xx*p_x) + (R_xy*p_y) + (R_xz*p_z);
    const stewart_real q_y = (R_yx*p_x) + (R_yy*p_y) + (R_yz*p_z);
    const stewart_real q_z = (R_zx*p_x) + (R_zy*p_y) + (R_zz*p_z);
    /* (1) leg vector */
    const stewart_real S_x = (t_x - b_x) + q_x;
    const stewart_real S_y = (t_y - b_y) + q_y;
    const stewart_real S_z = (t_z - b_z) + q_z;
    /* (2) leg length */
    const stewart_real L = STEWART_SQRT((S_x*S_x) + (S_y*S_y) + (S_z*S_z));
    leg_vectors out;
    out.q[0] = q_x;
    out.q[1] = q_y;
    out.q[2] = q_z;
    out.S[0] = S_x;
    out.S[1] = S_y;
    out.S[2] = S_z;
    out.L = L;
    return out;
}

/* Row [s, q x s] of the inverse Jacobian H^T, which maps [v; omega] to the length rate, (5): 13 (9 mul,
 * 3 add, 1 div, 0 sqrt). */
static leg_row row_of(const leg_vectors *leg)
{
    const stewart_real q_x = leg->q[0], q_y = leg->q[1], q_z = leg->q[2];
    const stewart_real S_x = leg->S[0], S_y = leg->S[1], S_z = leg->S[2];
    const stewart_real L = leg->L;
    const stewart_real inv_L = REAL(1)/L;
    /* (3) unit vector along the leg */
    const stewart_real s_x = S_x*inv_L;
    const stewart_real s_y = S_y*inv_L;
    const stewart_real s_z = S_z*inv_L;
    leg_row out;
    out.H_force[0] = s_x;
    out.H_force[1] = s_y;
    out.H_force[2] = s_z;
    out.H_moment[0] = (q_y*s_z) - (q_z*s_y);
    out.H_moment[1] = (q_z*s_x) - (q_x*s_z);
    out.H_moment[2] = (q_x*s_y) - (q_y*s_x);
    return out;
}

/* Rate L_dot of one leg, (4), (5): 18 (9 mul, 8 add, 1 div, 0 sqrt). */
static leg_rate rate_of(const leg_vectors *leg, const stewart_motion *motion)
{
    const stewart_real q_x = leg->q[0], q_y = leg->q[1], q_z = leg->q[2];
    const stewart_real S_x = leg->S[0], S_y = leg->S[1], S_z = leg->S[2];
    const stewart_real L = leg->L;
    const stewart_real omega_x = motion->omega[0], omega_y = motion->omega[1], omega_z = motion->omega[2];
    const stewart_real v_x = motion->v[0], v_y = motion->v[1], v_z = motion->v[2];
    /* (4) omega x q */
    const stewart_real w_q_x = (omega_y*q_z) - (omega_z*q_y);
    const stewart_real w_q_y = (omega_z*q_x) - (omega_x*q_z);
    const stewart_real w_q_z = (omega_x*q_y) - (omega_y*q_x);
    /* (4) velocity of the platform point */
    const stewart_real S_dot_x = v_x + w_q_x;
    const stewart_real S_dot_y = v_y + w_q_y;
    const stewart_real S_dot_z = v_z + w_q_z;
    /* (5) L L_dot */
    const stewart_real S_S_dot = (S_dot_x*S_x) + (S_dot_y*S_y) + (S_dot_z*S_z);
    /* (5) sliding velocity */
    const stewart_real rate = S_S_dot/L;
    leg_rate out;
    out.L_dot = rate;
    return out;
}

/* Cayley's rotation, without sines: exp([turn]x) to third order: 34 (18 mul, 15 add, 1 div, 0 sqrt). */
static small_turn turned_by(const stewart_real turn[3])
{
    const stewart_real turn_x = turn[0], turn_y = turn[1], turn_z = turn[2];
    /* half of the rotation vector */
    const stewart_real w_x = STEWART_HALF*turn_x;
    const stewart_real w_y = STEWART_HALF*turn_y;
    const stewart_real w_z = STEWART_HALF*turn_z;
    const stewart_real c1 = w_x*w_x;
    const stewart_real c2 = w_y*w_y;
    const stewart_real c3 = w_z*w_z;
    const stewart_real share = REAL(2)/(REAL(1) + c1 + c2 + c3);
    /* products of the components of w */
    const stewart_real W_xx = c1;
    const stewart_real W_xy = w_x*w_y;
    const stewart_real W_xz = w_x*w_z;
    const stewart_real W_yy = c2;
    const stewart_real W_yz = w_y*w_z;
    const stewart_real W_zz = c3;
    small_turn out;
    out.Q[0] = REAL(1) + (share*(-W_yy - W_zz));
    out.Q[1] = share*(W_xy - w_z);
    out.Q[2] = share*(W_xz + w_y);
    out.Q[3] = share*(W_xy + w_z);
    out.Q[4] = REAL(1) + (share*(-W_xx - W_zz));
    out.Q[5] = share*(W_yz - w_x);
    out.Q[6] = share*(W_xz - w_y);
    out.Q[7] = share*(W_yz + w_x);
    out.Q[8] = REAL(1) + (share*(-W_xx - W_yy));
    return out;
}

/* Returns the largest of ``least`` and the magnitudes of a vector's components. */
static stewart_real largest_component(const stewart_real vector[3], stewart_real least)
{
    int j;
    stewart_real most = least;
    for (j = 0; j < 3; ++j) {
        most = STEWART_LARGER(STEWART_FABS(vector[j]), most);
    }
    return most;
}

/* Returns the largest component (m) of the vectors q, t, and b, whose sum is a leg. */
static stewart_real reach_of(const stewart_real b[3], const stewart_real t[3], const stewart_real q[3])
{
    return largest_component(b, largest_component(t, largest_component(q, REAL(0))));
}

/* Returns the status of a leg: not finite, short compared with the vectors in its sum, along k, or OK. */
static int fault_of(stewart_real L, stewart_real k3, stewart_real reach)
{
    if (!(L <= STEWART_MAX)) {
        return STEWART_NOT_FINITE;
    }
    if (!((L > (STEWART_ROUNDING*reach)) && (L > STEWART_SHORTEST))) {
        return STEWART_ZERO_LENGTH;
    }
    if (!(k3 > STEWART_JOINT_SINGULAR_SINE)) {
        return STEWART_JOINT_SINGULAR;
    }
    return STEWART_OK;
}

/* Lengths of the legs, where ``moving`` is 1 their rates, and a status. */
static leg_rates rates_of(const stewart_robot *robot, const stewart_motion *motion, int moving)
{
    int i;
    leg_rates out = {{0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}, 0};
    stewart_pose pose = {{0, 0, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 0}};
    int status = STEWART_OK;
    for (i = 0; i < 9; ++i) {
        pose.R[i] = motion->R[i];
    }
    for (i = 0; i < 3; ++i) {
        pose.t[i] = motion->t[i];
    }
    for (i = 0; i < 6; ++i) {
        leg_vectors leg;
        leg = vectors_of(&robot->leg[i], &pose);
        int fault = fault_of(leg.L, REAL(1), reach_of(robot->leg[i].b, pose.t, leg.q));
        out.L[i] = leg.L;
        if (moving == 1) {
            leg_rate found;
            found = rate_of(&leg, motion);
            out.L_dot[i] = found.L_dot;
            fault = ((fault != STEWART_OK) || (STEWART_FABS(found.L_dot) <= STEWART_MAX)) ? fault : STEWART_NOT_FINITE;
        }
        status = (status == STEWART_OK) ? fault : status;
    }
    out.status = status;
    return out;
}

/* Vectors and lengths of the legs at a pose; returns a status. */
static int legs_at(const stewart_robot *robot, const stewart_pose *pose, legs_at_pose *legs)
{
    int i;
    int status = STEWART_OK;
    legs->reach = largest_component(pose->t, legs->extent);
    for (i = 0; i < 6; ++i) {
        legs->leg[i] = vectors_of(&robot->leg[i], pose);
        const int fault = fault_of(legs->leg[i].L, REAL(1), legs->reach);
        status = (status == STEWART_OK) ? fault : status;
    }
    return status;
}

/* Compute J of the legs at a pose. */
static void rows_at(legs_at_pose *legs, stewart_real per_size)
{
    int i;
    int j;
    for (i = 0; i < 6; ++i) {
        leg_row row;
        row = row_of(&legs->leg[i]);
        for (j = 0; j < 3; ++j) {
            legs->A[i][j] = row.H_force[j];
            legs->A[i][j + 3] = row.H_moment[j]*per_size;
        }
    }
}

/* Return the square of a vector's length. */
static stewart_real square_of(const stewart_real vector[3])
{
    return (vector[0]*vector[0]) + (vector[1]*vector[1]) + (vector[2]*vector[2]);
}

/* Return the largest distance of a joint from the origin of its part (m). */
static stewart_real extent_of(const stewart_robot *robot)
{
    int i;
    stewart_real square = REAL(0);
    for (i = 0; i < 6; ++i) {
        square = STEWART_LARGER(square_of(robot->leg[i].b), square);
        square = STEWART_LARGER(square_of(robot->leg[i].p), square);
    }
    return STEWART_SQRT(square);
}

/* Root mean square distance of the platform points from the reference point, by which moments are
 * measured, m; 1 if they lie in it. */
static stewart_real platform_size(const stewart_robot *robot)
{
    int i;
    int j;
    stewart_real total = REAL(0);
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 3; ++j) {
            total = total + (robot->leg[i].p[j]*robot->leg[i].p[j]);
        }
    }
    const stewart_real extent = STEWART_SQRT(total/REAL(6));
    return (extent > STEWART_SHORTEST) ? extent : REAL(1);
}

/* Makes a triangle of [J | right side] by Householder's reflections. Its diagonal holds reciprocals, or
 * 0 where the entry is 0. */
static void reflect(stewart_real A[6][7])
{
    int i;
    int j;
    int k;
    for (k = 0; k < 6; ++k) {
        stewart_real square = REAL(0);
        for (i = k; i < 6; ++i) {
            square = square + (A[i][k]*A[i][k]);
        }
        const stewart_real norm = STEWART_SQRT(square);
        const stewart_real diagonal = (A[k][k] > REAL(0)) ? -norm : norm;
        const stewart_real first = A[k][k] - diagonal;
        const stewart_real factor = (square > REAL(0)) ? REAL(1)/(diagonal*first) : REAL(0);
        A[k][k] = first;
        for (j = k + 1; j < 7; ++j) {
            stewart_real total = REAL(0);
            for (i = k; i < 6; ++i) {
                total = total + (A[i][k]*A[i][j]);
            }
            total = total*factor;
            for (i = k; i < 6; ++i) {
                A[i][j] = A[i][j] + (total*A[i][k]);
            }
        }
        A[k][k] = factor*first;
    }
}

/* Compute x of the triangle's equations, the last first, or 0 where the diagonal entry is 0. Return the
 * square of the size of x. */
static stewart_real substitute(stewart_real A[6][7], stewart_real x[6])
{
    int back;
    int i;
    stewart_real square = REAL(0);
    for (i = 5; i >= 0; --i) {
        stewart_real total = A[i][6];
        for (back = 0; back < 5 - i; ++back) {
            total = total - (A[i][5 - back]*x[5 - back]);
        }
        x[i] = total*A[i][i];
        square = square + (x[i]*x[i]);
    }
    return square;
}

/* 1 where the triangle's condition number, by Frobenius norms, exceeds 1 / (16 sqrt(eps)), else 0. Two
 * poses with the same lengths meet where H is singular, and sqrt(eps) from there they differ by
 * rounding: lengths known to rounding leave the pose open. ``factor`` multiplies the square of the
 * condition number. Stores |J^-1|^2 in ``legs``. */
static int is_open(legs_at_pose *legs, stewart_real factor)
{
    int back;
    int j;
    int k;
    stewart_real total = REAL(0);
    stewart_real of_inverse = REAL(0);
    int regular = 1;
    for (k = 0; k < 6; ++k) {
        const stewart_real pivot = legs->A[k][k];
        regular = (STEWART_FABS(pivot) > REAL(0)) ? regular : 0;
        legs->A[k][6] = pivot;
        total = total + ((STEWART_FABS(pivot) > REAL(0)) ? REAL(1)/(pivot*pivot) : REAL(0));
        of_inverse = of_inverse + (pivot*pivot);
        for (back = 0; back < k; ++back) {
            const stewart_real corner = legs->A[k - 1 - back][k];
            stewart_real entry = corner*pivot;
            for (j = k - back; j < k; ++j) {
                entry = entry + (legs->A[k - 1 - back][j]*legs->A[k][j]);
            }
            entry = (-entry)*legs->A[k - 1 - back][k - 1 - back];
            legs->A[k][k - 1 - back] = entry;
            total = total + (corner*corner);
            of_inverse = of_inverse + (entry*entry);
        }
    }
    legs->of_inverse = of_inverse;
    const stewart_real square = REAL(256)*STEWART_EPSILON*factor*total*of_inverse;
    return ((regular == 1) && (square <= REAL(1))) ? 0 : 1;
}

/* One of Newton's steps toward the rotation nearest to R, R <- R + R (E - R^T R) / 2, or none where
 * ``half`` is 0; returns how far an entry of R^T R was from E. */
static stewart_real polish(stewart_real R[9], stewart_real half)
{
    int i;
    int j;
    int k;
    stewart_real lack[9] = {0, 0, 0, 0, 0, 0, 0, 0, 0};
    stewart_real skew = REAL(0);
    for (i = 0; i < 3; ++i) {
        for (j = i; j < 3; ++j) {
            const stewart_real product = (R[i]*R[j]) + (R[3 + i]*R[3 + j]) + (R[6 + i]*R[6 + j]);
            const stewart_real missing = ((i == j) ? REAL(1) : REAL(0)) - product;
            skew = STEWART_LARGER(STEWART_FABS(missing), skew);
            const stewart_real part = half*missing;
            lack[(3*i) + j] = part;
            lack[(3*j) + i] = part;
        }
    }
    for (k = 0; k < 3; ++k) {
        const stewart_real x = R[3*k], y = R[(3*k) + 1], z = R[(3*k) + 2];
        for (j = 0; j < 3; ++j) {
            R[(3*k) + j] = R[(3*k) + j] + ((x*lack[j]) + (y*lack[3 + j]) + (z*lack[6 + j]));
        }
    }
    return skew;
}

/* Makes R a rotation to rounding; returns 1 if it was near to one, else 0. */
static int make_rotation(stewart_real R[9])
{
    int turn;
    const stewart_real first = R[0]*((R[4]*R[8]) - (R[5]*R[7]));
    const stewart_real volume = first + (R[1]*((R[5]*R[6]) - (R[3]*R[8]))) + (R[2]*((R[3]*R[7]) - (R[4]*R[6])));
    stewart_real skew = polish(R, STEWART_HALF);
    int near = 1;
    near = ((volume > REAL(0)) && (skew <= REAL(0.0625))) ? near : 0;
    for (turn = 0; turn < 4; ++turn) {
        const stewart_real half = ((skew*skew) > STEWART_EPSILON) ? STEWART_HALF : REAL(0);
        if (half > REAL(0)) {
            skew = polish(R, half);
        } else {
            break;
        }
    }
    return near;
}

/* Stores the given lengths minus the lengths of a pose (m) next to J; returns the largest magnitude. */
static stewart_real compare(const stewart_real L[6], legs_at_pose *legs)
{
    int i;
    stewart_real worst = REAL(0);
    for (i = 0; i < 6; ++i) {
        const stewart_real miss = L[i] - legs->leg[i].L;
        legs->A[i][6] = miss;
        worst = STEWART_LARGER(STEWART_FABS(miss), worst);
    }
    return worst;
}

/* Turn [J | miss] into [J^T J + damping E | J^T miss], the equations of a Levenberg-Marquardt step. */
static void damp(stewart_real A[6][7], stewart_real damping)
{
    int i;
    int j;
    int k;
    stewart_real J[6][7] = {{0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0}, {0, 0, 0,
        0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0}};
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 7; ++j) {
            J[i][j] = A[i][j];
        }
    }
    for (i = 0; i < 6; ++i) {
        for (j = i; j < 7; ++j) {
            stewart_real total = (i == j) ? damping : REAL(0);
            for (k = 0; k < 6; ++k) {
                total = total + (J[k][i]*J[k][j]);
            }
            A[i][j] = total;
        }
        for (j = 0; j < i; ++j) {
            A[i][j] = A[j][i];
        }
    }
}

/* Return 1 over the largest of six lengths (1/m). */
static stewart_real per_longest_of(const stewart_real L[6])
{
    int i;
    stewart_real longest = L[0];
    for (i = 1; i < 6; ++i) {
        longest = STEWART_LARGER(L[i], longest);
    }
    return REAL(1)/longest;
}

/* Split a step x into [along; turn], no longer than 0.4 rad and 0.4 times the longest leg. Beyond this,
 * (2) is far from linear. Such steps need no damping: a search that rejects steps loses more poses. */
static void trusted(
    const stewart_real x[6], stewart_real per_size, stewart_real per_longest, stewart_real along[3],
    stewart_real turn[3])
{
    int i;
    for (i = 0; i < 3; ++i) {
        along[i] = x[i];
        turn[i] = x[i + 3]*per_size;
    }
    const stewart_real way = REAL(6.25)*per_longest*per_longest*square_of(along);
    const stewart_real angle = REAL(6.25)*square_of(turn);
    const stewart_real excess = STEWART_LARGER(STEWART_LARGER(way, angle), REAL(1));
    if (excess > REAL(1)) {
        const stewart_real shorter = REAL(1)/STEWART_SQRT(excess);
        for (i = 0; i < 3; ++i) {
            along[i] = along[i]*shorter;
            turn[i] = turn[i]*shorter;
        }
    }
}

/* Move a pose by a step if ``going`` is 1, and polish R by ``half``. */
static void advance(
    stewart_pose *pose, const stewart_real along[3], const stewart_real turn[3], stewart_real half,
    int going)
{
    int i;
    int j;
    stewart_real R[9] = {0, 0, 0, 0, 0, 0, 0, 0, 0};
    small_turn turned;
    turned = turned_by(turn);
    for (i = 0; i < 3; ++i) {
        for (j = 0; j < 3; ++j) {
            const stewart_real part = (turned.Q[3*i]*pose->R[j]) + (turned.Q[(3*i) + 1]*pose->R[3 + j]);
            R[(3*i) + j] = part + (turned.Q[(3*i) + 2]*pose->R[6 + j]);
        }
    }
    if (half > REAL(0)) {
        (void)polish(R, half);
    }
    for (i = 0; i < 9; ++i) {
        pose->R[i] = (going == 1) ? R[i] : pose->R[i];
    }
    for (i = 0; i < 3; ++i) {
        pose->t[i] = (going == 1) ? pose->t[i] + along[i] : pose->t[i];
    }
}

/* Compute the squares of the distance (m^2) and of the angle (rad^2) between poses. */
static void apart(const stewart_pose *one, const stewart_pose *other, stewart_real squares[2])
{
    int i;
    stewart_real way = REAL(0);
    stewart_real chord = REAL(0);
    for (i = 0; i < 9; ++i) {
        const stewart_real gap = one->R[i] - other->R[i];
        chord = chord + (gap*gap);
    }
    for (i = 0; i < 3; ++i) {
        const stewart_real gap = one->t[i] - other->t[i];
        way = way + (gap*gap);
    }
    chord = STEWART_HALF*chord;
    squares[0] = way;
    squares[1] = chord*(REAL(1) + (chord*(REAL(0.08333333333333333) + (REAL(0.011111111111111112)*chord))));
}

/* Return 1 if a search at a pose leads to the nearest pose found so far or is farther from the guess. */
static int is_futile(const nearest_pose *nearest, stewart_real per_size, const stewart_pose *pose)
{
    stewart_real squares[2] = {0, 0};
    apart(pose, &nearest->pose, squares);
    const int futile = (((per_size*per_size*squares[0]) + squares[1]) < nearest->basin) ? 1 : 0;
    apart(pose, &nearest->guess, squares);
    return ((REAL(0.8)*(squares[0] + squares[1])) > nearest->away) ? 1 : futile;
}

/* Step from a pose, with its legs, to lengths L. The first four steps of search 1 are damped. Return 1
 * if a pose with these lengths was found, else 0. ``legs`` keeps the triangle of J before the last step. */
static int search(
    const stewart_robot *robot, const stewart_real L[6], stewart_real per_size, int number,
    const nearest_pose *nearest, stewart_pose *pose, legs_at_pose *legs)
{
    int step;
    stewart_real x[6] = {0, 0, 0, 0, 0, 0};
    stewart_real along[3] = {0, 0, 0};
    stewart_real turn[3] = {0, 0, 0};
    const stewart_real per_longest = per_longest_of(L);
    int status = STEWART_OK;
    stewart_real worst = compare(L, legs);
    int going = 1;
    legs->straight = 1;
    legs->last = REAL(1e+30);
    for (step = 0; step < STEWART_MAX_STEPS; ++step) {
        going = (status == STEWART_OK) ? going : 0;
        going = (worst > (REAL(4)*STEWART_EPSILON*legs->reach)) ? going : 0;
        if (number > 0) {
            going = (is_futile(nearest, per_size, pose) == 1) ? 0 : going;
        }
        if (going == 1) {
            rows_at(legs, per_size);
            const stewart_real damping = ((number == 1) && (step < 4)) ? REAL(0.001) : REAL(0);
            if (damping > REAL(0)) {
                damp(legs->A, damping);
            }
            reflect(legs->A);
            stewart_real square = substitute(legs->A, x);
            square = (damping > REAL(0)) ? REAL(1e+30) : square;
            legs->last = square;
            trusted(x, per_size, per_longest, along, turn);
            const stewart_real half = (worst > (REAL(0.0009765625)*legs->reach)) ? REAL(0) : STEWART_HALF;
            advance(pose, along, turn, half, going);
            const stewart_real allowed = STEWART_LARGER(REAL(0.7)*worst, STEWART_ROUNDING*legs->reach);
            status = legs_at(robot, pose, legs);
            worst = compare(L, legs);
            legs->straight = (worst > allowed) ? 0 : legs->straight;
        } else {
            break;
        }
    }
    return ((status == STEWART_OK) && (worst <= (STEWART_ROUNDING*legs->reach))) ? 1 : 0;
}

/* Returns the status of the inputs of a search: not finite, or not a length. */
static int first_fault(const stewart_real L[6], const stewart_pose *guess)
{
    int i;
    int status = STEWART_OK;
    for (i = 0; i < 6; ++i) {
        status = (STEWART_FABS(L[i]) <= STEWART_MAX) ? status : STEWART_NOT_FINITE;
    }
    for (i = 0; i < 9; ++i) {
        status = (STEWART_FABS(guess->R[i]) <= STEWART_MAX) ? status : STEWART_NOT_FINITE;
    }
    for (i = 0; i < 3; ++i) {
        status = (STEWART_FABS(guess->t[i]) <= STEWART_MAX) ? status : STEWART_NOT_FINITE;
    }
    for (i = 0; i < 6; ++i) {
        status = ((status != STEWART_OK) || (L[i] > REAL(0))) ? status : STEWART_ZERO_LENGTH;
    }
    return status;
}

/* Velocities of the platform that the rates of the legs make, and a status. */
static twist twist_of(const stewart_robot *robot, const stewart_pose *pose, const stewart_real L_dot[6])
{
    int i;
    twist out = {{0, 0, 0}, {0, 0, 0}, 0};
    legs_at_pose legs = {{{0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0,
        0, 0, 0}, {0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0}}, {{{0, 0, 0}, {0, 0, 0}, 0}, {{0, 0, 0}, {0,
        0, 0}, 0}, {{0, 0, 0}, {0, 0, 0}, 0}, {{0, 0, 0}, {0, 0, 0}, 0}, {{0, 0, 0}, {0, 0, 0}, 0}, {{0, 0,
        0}, {0, 0, 0}, 0}}, 0, 0, 0, 0, 0};
    stewart_real x[6] = {0, 0, 0, 0, 0, 0};
    const stewart_real per_size = REAL(1)/platform_size(robot);
    legs.extent = extent_of(robot);
    int status = legs_at(robot, pose, &legs);
    rows_at(&legs, per_size);
    for (i = 0; i < 6; ++i) {
        legs.A[i][6] = L_dot[i];
    }
    reflect(legs.A);
    (void)substitute(legs.A, x);
    const int unsettled = is_open(&legs, REAL(1));
    status = ((status == STEWART_OK) && (unsettled == 1)) ? STEWART_SINGULAR : status;
    for (i = 0; i < 3; ++i) {
        out.v[i] = x[i];
        out.omega[i] = x[i + 3]*per_size;
        status = ((status != STEWART_OK) || (STEWART_FABS(out.v[i]) <= STEWART_MAX)) ? status : STEWART_NOT_FINITE;
        status = ((status != STEWART_OK) || (STEWART_FABS(out.omega[i]) <= STEWART_MAX)) ? status : STEWART_NOT_FINITE;
    }
    out.status = status;
    return out;
}

/* Estimate the direction x that changes the lengths least, by inverse iteration. */
static void flattest(const legs_at_pose *legs, stewart_real x[6])
{
    int i;
    int k;
    int turn;
    stewart_real y[6] = {0, 0, 0, 0, 0, 0};
    const stewart_real shrink = REAL(1)/legs->of_inverse;
    for (i = 0; i < 6; ++i) {
        x[i] = REAL(1);
    }
    for (turn = 0; turn < 3; ++turn) {
        for (k = 0; k < 6; ++k) {
            stewart_real total = legs->A[k][6]*x[k];
            for (i = 0; i < k; ++i) {
                total = total + (legs->A[k][i]*x[i]);
            }
            y[k] = total*shrink;
        }
        for (i = 0; i < 6; ++i) {
            stewart_real total = legs->A[i][6]*y[i];
            for (k = i + 1; k < 6; ++k) {
                total = total + (legs->A[k][i]*y[k]);
            }
            x[i] = total;
        }
    }
}

/* Compute the cross product of x and y. */
static void cross(const stewart_real x[3], const stewart_real y[3], stewart_real out[3])
{
    out[0] = (x[1]*y[2]) - (x[2]*y[1]);
    out[1] = (x[2]*y[0]) - (x[0]*y[2]);
    out[2] = (x[0]*y[1]) - (x[1]*y[0]);
}

/* Estimate the step x to the pose with the same lengths behind the next singular pose. It goes along the
 * flattest direction, twice as far as the rate of the lengths takes to become 0. */
static void step_beyond(const legs_at_pose *legs, stewart_real per_size, stewart_real x[6])
{
    int i;
    int j;
    stewart_real v[3] = {0, 0, 0};
    stewart_real omega[3] = {0, 0, 0};
    stewart_real turning[3] = {0, 0, 0};
    stewart_real bending[3] = {0, 0, 0};
    flattest(legs, x);
    for (i = 0; i < 3; ++i) {
        v[i] = x[i];
        omega[i] = x[i + 3]*per_size;
    }
    stewart_real square = REAL(0);
    stewart_real bent = REAL(0);
    for (i = 0; i < 6; ++i) {
        cross(omega, legs->leg[i].q, turning);
        cross(omega, turning, bending);
        stewart_real rate = REAL(0);
        stewart_real second = REAL(0);
        for (j = 0; j < 3; ++j) {
            const stewart_real moving = v[j] + turning[j];
            rate = rate + (legs->leg[i].S[j]*moving);
            second = second + (moving*moving) + (legs->leg[i].S[j]*bending[j]);
        }
        const stewart_real per_L = REAL(1)/legs->leg[i].L;
        rate = rate*per_L;
        second = (second - (rate*rate))*per_L;
        square = square + (rate*rate);
        bent = bent + (rate*second);
    }
    stewart_real way = (STEWART_FABS(bent) > REAL(0)) ? ((-REAL(2))*square)/bent : REAL(0);
    way = (STEWART_FABS(way) <= STEWART_MAX) ? way : REAL(0);
    for (i = 0; i < 6; ++i) {
        x[i] = way*x[i];
    }
}

/* Estimate the rate of J at a pose (1/m), from the shortest leg and the size of the platform. */
static stewart_real bend_of(stewart_real per_size, const legs_at_pose *legs)
{
    int i;
    stewart_real shortest = legs->leg[0].L;
    for (i = 1; i < 6; ++i) {
        shortest = (legs->leg[i].L < shortest) ? legs->leg[i].L : shortest;
    }
    return (REAL(2)/shortest) + per_size;
}

/* Return 1 if the lengths do not determine the pose that a search found, else 0. The triangle before the
 * last step suffices if this step hardly changed J; ``flat`` is 1 over the square of the rate of J. */
static int settle(stewart_real per_size, stewart_real flat, legs_at_pose *legs)
{
    int unsettled = is_open(legs, REAL(4));
    const int redo = ((REAL(4096)*legs->last*legs->of_inverse) <= flat) ? unsettled : 1;
    if (redo == 1) {
        rows_at(legs, per_size);
        reflect(legs->A);
        unsettled = is_open(legs, REAL(1));
    }
    return unsettled;
}

/* Move a pose, with its triangle, behind the next singular pose. Return 1 if the step is shorter than
 * sqrt(6) times the distance of the nearest pose found from the guess, else 0. */
static int pass_over(
    const stewart_real L[6], stewart_real per_size, stewart_real away, stewart_pose *pose,
    const legs_at_pose *legs)
{
    int i;
    stewart_real x[6] = {0, 0, 0, 0, 0, 0};
    stewart_real along[3] = {0, 0, 0};
    stewart_real turn[3] = {0, 0, 0};
    step_beyond(legs, per_size, x);
    for (i = 0; i < 3; ++i) {
        along[i] = x[i];
        turn[i] = x[i + 3]*per_size;
    }
    const int hopeful = ((square_of(along) + square_of(turn)) >= (REAL(6)*away)) ? 0 : 1;
    if (hopeful == 1) {
        trusted(x, per_size, per_longest_of(L), along, turn);
        advance(pose, along, turn, STEWART_HALF, 1);
    }
    return hopeful;
}

/* Compute the triangle of J at a pose. */
static void measure(
    const stewart_robot *robot, stewart_real per_size, const stewart_pose *pose, legs_at_pose *legs)
{
    (void)legs_at(robot, pose, legs);
    rows_at(legs, per_size);
    reflect(legs->A);
    (void)is_open(legs, REAL(1));
}

/* Replace ``pose``, the nearest found so far, by the first pose of a search. The third search starts
 * behind the next singular pose, the others at the guess. Return 1 if the search may find a nearer pose. */
static int start_of(
    int number, const stewart_real L[6], stewart_real per_size, const nearest_pose *nearest,
    stewart_pose *pose, const legs_at_pose *legs)
{
    int i;
    int hopeful = 1;
    if (number == 2) {
        hopeful = pass_over(L, per_size, nearest->away, pose, legs);
    } else {
        for (i = 0; i < 9; ++i) {
            pose->R[i] = nearest->guess.R[i];
        }
        for (i = 0; i < 3; ++i) {
            pose->t[i] = nearest->guess.t[i];
        }
    }
    return hopeful;
}

/* Return the pose for lengths L that is nearest to a guess, and a status. */
static found_pose pose_of(const stewart_robot *robot, const stewart_real L[6], const stewart_pose *guess)
{
    int i;
    int turn;
    found_pose out = {{{0, 0, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 0}}, 0};
    legs_at_pose legs = {{{0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0,
        0, 0, 0}, {0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0}}, {{{0, 0, 0}, {0, 0, 0}, 0}, {{0, 0, 0}, {0,
        0, 0}, 0}, {{0, 0, 0}, {0, 0, 0}, 0}, {{0, 0, 0}, {0, 0, 0}, 0}, {{0, 0, 0}, {0, 0, 0}, 0}, {{0, 0,
        0}, {0, 0, 0}, 0}}, 0, 0, 0, 0, 0};
    nearest_pose nearest = {{{0, 0, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 0}}, {{0, 0, 0, 0, 0, 0, 0, 0, 0}, {0, 0,
        0}}, 0, 0};
    stewart_pose pose = {{0, 0, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 0}};
    stewart_real squares[2] = {0, 0};
    const stewart_real per_size = REAL(1)/platform_size(robot);
    legs.extent = extent_of(robot);
    int status = first_fault(L, guess);
    for (i = 0; i < 9; ++i) {
        pose.R[i] = guess->R[i];
    }
    for (i = 0; i < 3; ++i) {
        pose.t[i] = guess->t[i];
    }
    const int near = make_rotation(pose.R);
    status = ((status != STEWART_OK) || (near == 1)) ? status : STEWART_NOT_CONVERGED;
    int going = (status == STEWART_OK) ? 1 : 0;
    nearest.away = STEWART_MAX;
    int straight = 0;
    int measured = 1;
    for (i = 0; i < 9; ++i) {
        nearest.guess.R[i] = pose.R[i];
        nearest.pose.R[i] = pose.R[i];
    }
    for (i = 0; i < 3; ++i) {
        nearest.guess.t[i] = pose.t[i];
        nearest.pose.t[i] = pose.t[i];
    }
    for (turn = 0; turn < STEWART_MAX_SEARCHES; ++turn) {
        int active = ((turn == 1) && (straight == 1)) ? 0 : going;
        if ((turn == 2) && (active == 1) && (measured == 0)) {
            for (i = 0; i < 9; ++i) {
                pose.R[i] = nearest.pose.R[i];
            }
            for (i = 0; i < 3; ++i) {
                pose.t[i] = nearest.pose.t[i];
            }
            measure(robot, per_size, &pose, &legs);
        }
        if (active == 1) {
            const int hopeful = start_of(turn, L, per_size, &nearest, &pose, &legs);
            active = (hopeful == 1) ? active : 0;
        }
        if (active == 1) {
            int fault = legs_at(robot, &pose, &legs);
            status = ((turn == 0) && (status == STEWART_OK)) ? fault : status;
            active = (status == STEWART_OK) ? active : 0;
            const int found = search(robot, L, per_size, turn, &nearest, &pose, &legs);
            measured = 0;
            straight = 0;
            going = (status == STEWART_OK) ? going : 0;
            if (found == 1) {
                const stewart_real bend = bend_of(per_size, &legs);
                const stewart_real flat = REAL(1)/(bend*bend);
                const int unsettled = settle(per_size, flat, &legs);
                const stewart_real basin = (flat*per_size*per_size)/legs.of_inverse;
                apart(&pose, &nearest.guess, squares);
                const stewart_real away = squares[0] + squares[1];
                const int take = ((active == 1) && (away < nearest.away)) ? found : 0;
                nearest.away = (take == 1) ? away : nearest.away;
                nearest.basin = (take == 1) ? basin : nearest.basin;
                for (i = 0; i < 9; ++i) {
                    nearest.pose.R[i] = (take == 1) ? pose.R[i] : nearest.pose.R[i];
                }
                for (i = 0; i < 3; ++i) {
                    nearest.pose.t[i] = (take == 1) ? pose.t[i] : nearest.pose.t[i];
                }
                fault = (unsettled == 1) ? STEWART_SINGULAR : STEWART_OK;
                status = (take == 1) ? fault : status;
                measured = take;
                straight = legs.straight;
                const int certain = (((per_size*per_size*squares[0]) + squares[1]) <= basin) ? found : 0;
                going = (((active == 1) && (certain == 1)) || (status != STEWART_OK)) ? 0 : going;
            }
        }
    }
    for (i = 0; i < 9; ++i) {
        out.pose.R[i] = nearest.pose.R[i];
    }
    for (i = 0; i < 3; ++i) {
        out.pose.t[i] = nearest.pose.t[i];
    }
    status = ((status == STEWART_OK) && (nearest.away >= STEWART_MAX)) ? STEWART_NOT_CONVERGED : status;
    out.status = status;
    return out;
}

int stewart_inverse_kinematics(
    const stewart_robot *robot, const stewart_motion *motion, stewart_real L[6], stewart_real L_dot[6])
{
    int status = STEWART_BAD_ARGUMENT;
    int i;
    if ((robot != NULL) && (motion != NULL) && (L != NULL)) {
        leg_rates found;
        found = rates_of(robot, motion, (L_dot != NULL) ? 1 : 0);
        status = found.status;
        for (i = 0; (i < 6) && (status == STEWART_OK); ++i) {
            L[i] = found.L[i];
            if (L_dot != NULL) {
                L_dot[i] = found.L_dot[i];
            }
        }
    }
    return status;
}

int stewart_forward_kinematics(const stewart_robot *robot, const stewart_real L[6], stewart_pose *pose)
{
    int status = STEWART_BAD_ARGUMENT;
    if ((robot != NULL) && (L != NULL) && (pose != NULL)) {
        found_pose found;
        found = pose_of(robot, L, pose);
        status = found.status;
        if (status == STEWART_OK) {
            *pose = found.pose;
        }
    }
    return status;
}

int stewart_forward_velocity(
    const stewart_robot *robot, const stewart_pose *pose, const stewart_real L_dot[6], stewart_real v[3],
    stewart_real omega[3])
{
    int status = STEWART_BAD_ARGUMENT;
    int i;
    if ((robot != NULL) && (pose != NULL) && (L_dot != NULL) && (v != NULL) && (omega != NULL)) {
        twist found;
        found = twist_of(robot, pose, L_dot);
        status = found.status;
        for (i = 0; (i < 3) && (status == STEWART_OK); ++i) {
            v[i] = found.v[i];
            omega[i] = found.omega[i];
        }
    }
    return status;
}
