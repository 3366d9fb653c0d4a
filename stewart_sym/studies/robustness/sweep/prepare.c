/* The closed form's constants in a wider type. */
#include "arithmetic.h"

#include "stewart_exact_forces_text.h"
