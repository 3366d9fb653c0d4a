/* What an attack on the generated C is made of: a case decoded from bytes, and oracles that abort.
 *
 * attack.c turns bytes into a case and hands it to the oracle of one kernel. The oracles (attack_axial.c,
 * attack_torque.c, attack_forces.c, attack_bounds.c, attack_dynamics.c, attack_motion.c, attack_kinematics.c, attack_regressor.c) are compiled once for each kernel, with KERNEL its name and HEADER its
 * header; they call every entry point and know the contract of stewart.h and of no equation.
 */
#ifndef ATTACK_H
#define ATTACK_H

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "stewart.h"

#if defined(STEWART_FLOAT)
#define ATTACK_MAX FLT_MAX
#define ATTACK_EPSILON ((double)FLT_EPSILON)
#else
#define ATTACK_MAX DBL_MAX
#define ATTACK_EPSILON DBL_EPSILON
#endif

#define MOST_POSES 17

/* Which pointers are null, and whether arrays begin one number after what malloc gives. */
enum {
    NULL_MODEL = 1,
    NULL_MOTIONS = 2,
    NULL_OUT = 4,
    NULL_STATUS = 8,
    NULL_FORCES = 16,
    NULL_BEARING = 32,
    ONE_OFF = 64,
    FIRST_ARRAY = 8 /* bit of R; those of t, omega, v, alpha, a, F_ext, M_ext follow */
};
#define NULL_ARRAY(i) (1u << (FIRST_ARRAY + (i)))
enum { ARRAY_R, ARRAY_T, ARRAY_OMEGA, ARRAY_V, ARRAY_ALPHA, ARRAY_A, ARRAY_F_EXT, ARRAY_M_EXT, ARRAYS };

typedef struct {
    unsigned flags;
    size_t count;
    stewart_robot robot;
    stewart_motion pose[MOST_POSES];
    stewart_real F[MOST_POSES][6];
    stewart_real bearing[6];
} attack_case;

typedef void attack_oracle(const attack_case *it);

/* The motions of a case in exactly sized arrays of their own. */
typedef struct {
    void *block[ARRAYS];
    stewart_motions motions;
} attack_arrays;

void attack_arrays_make(const attack_case *it, attack_arrays *out);
void attack_arrays_free(attack_arrays *arrays);

/* `numbers` numbers, all bytes ATTACK_UNTOUCHED, one off where the case says so. */
#define ATTACK_UNTOUCHED 0xA5
stewart_real *attack_array(const attack_case *it, size_t numbers, void **block);
int attack_untouched(const void *bytes, size_t size);
/* Whether all are; they go into attack_digest, which tells whether two runs gave the same bits. */
int attack_finite(const stewart_real *numbers, size_t count);
extern uint64_t attack_digest;
int attack_known(int status, unsigned allowed);
/* What a batch has to return, from the status of each pose. */
int attack_first(const int *status, size_t count);

#define ALLOWED(status) (1u << (status))

/* Ends the program, and with it the run of a fuzzer, with what was expected. */
#define EXPECT(condition) \
    do { \
        if (!(condition)) { \
            fprintf(stderr, "%s:%d: %s: expected %s\n", __FILE__, __LINE__, KERNEL_TEXT, #condition); \
            abort(); \
        } \
    } while (0)

#define TEXT_(name) #name
#define TEXT(name) TEXT_(name)
#define JOINED_(one, two, three) one##two##three
#define JOINED(one, two, three) JOINED_(one, two, three)

#if defined(KERNEL)
#define KERNEL_TEXT TEXT(KERNEL)
#define KERNEL_NAME(what) JOINED(stewart_, KERNEL, what)
#endif

#endif
