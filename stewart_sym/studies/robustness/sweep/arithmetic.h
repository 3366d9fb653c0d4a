/* The arithmetic of one compilation, and names of its own for all that it defines: the kernels are compiled
 * once for each of WIDE, QUAD, IN_DOUBLE and IN_FLOAT. */
#ifndef ARITHMETIC_H
#define ARITHMETIC_H

#include <float.h>

#if defined(__OPTIMIZE__) && (defined(WIDE) || defined(QUAD))
/* The truth is made in calls of a library or by the x87 unit: optimizing it gains little and takes compilers long. */
#pragma GCC optimize("O1")
#endif

#if defined(WIDE)
#include <math.h>
#define OWN(name) wide_##name
#define STEWART_REAL long double
#define STEWART_SQRT(value) sqrtl(value)
#define STEWART_FABS(value) fabsl(value)
#define STEWART_EPSILON LDBL_EPSILON
#define STEWART_MAX LDBL_MAX
#elif defined(QUAD)
#include <quadmath.h>
#define OWN(name) quad_##name
#define STEWART_REAL __float128
#define STEWART_SQRT(value) sqrtq(value)
#define STEWART_FABS(value) fabsq(value)
#define STEWART_EPSILON FLT128_EPSILON
#define STEWART_MAX FLT128_MAX
#elif defined(IN_FLOAT)
#define OWN(name) float_##name
#define STEWART_FLOAT 1
#else
#define OWN(name) double_##name
#endif

#define stewart_exact_inverse_dynamics OWN(stewart_exact_inverse_dynamics)
#define stewart_exact_joint_reactions OWN(stewart_exact_joint_reactions)
#define stewart_exact_inverse_dynamics_batch OWN(stewart_exact_inverse_dynamics_batch)
#define stewart_exact_joint_reactions_batch OWN(stewart_exact_joint_reactions_batch)
#define stewart_exact_prepare OWN(stewart_exact_prepare)
#define stewart_exact_forces OWN(stewart_exact_forces)
#define stewart_exact_forces_batch OWN(stewart_exact_forces_batch)
#define stewart_exact_forces_columns OWN(stewart_exact_forces_columns)
#define stewart_exact_equations OWN(stewart_exact_equations)
#define stewart_exact_bias_and_friction OWN(stewart_exact_bias_and_friction)
#define stewart_exact_forward_dynamics OWN(stewart_exact_forward_dynamics)
#define stewart_exact_joint_inertia OWN(stewart_exact_joint_inertia)
#define stewart_exact_derivatives OWN(stewart_exact_derivatives)
#define stewart_exact_linearization OWN(stewart_exact_linearization)
#define stewart_exact_equations_batch OWN(stewart_exact_equations_batch)
#define stewart_exact_bias_and_friction_batch OWN(stewart_exact_bias_and_friction_batch)
#define stewart_exact_forward_dynamics_batch OWN(stewart_exact_forward_dynamics_batch)
#define stewart_exact_joint_inertia_batch OWN(stewart_exact_joint_inertia_batch)
#define stewart_exact_derivatives_batch OWN(stewart_exact_derivatives_batch)
#define stewart_exact_linearization_batch OWN(stewart_exact_linearization_batch)

#endif
