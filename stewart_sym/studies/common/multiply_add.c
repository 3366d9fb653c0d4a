/* Independent chains of fused multiply-adds at full width. */
#include <stddef.h>

#if defined(__AVX512F__)
#define LANES 8
#elif defined(__AVX__)
#define LANES 4
#else
#define LANES 2
#endif

/* What the compiler was allowed, widest first. */
#if defined(__AVX512F__)
#define SET "AVX-512"
#elif defined(__AVX2__)
#define SET "AVX2"
#elif defined(__AVX__)
#define SET "AVX"
#elif defined(__aarch64__)
#define SET "NEON"
#elif defined(__SSE2__)
#define SET "SSE2"
#else
#define SET ""
#endif

typedef double lanes __attribute__((vector_size(8 * LANES)));

/* Chains enough that none waits for another, few enough for the registers. */
#define FEW(X) X(0) X(1) X(2) X(3) X(4) X(5) X(6) X(7) X(8) X(9) X(10) X(11)
#if defined(__AVX512F__) || defined(__aarch64__)
#define CHAINS(X) FEW(X) X(12) X(13) X(14) X(15) X(16) X(17) \
    X(18) X(19) X(20) X(21) X(22) X(23)
#else
#define CHAINS(X) FEW(X)
#endif

const char *multiply_add_set(void)
{
    return SET;
}

int multiply_add_lanes(void)
{
    return LANES;
}

int multiply_add_chains(void)
{
#define ONE(i) +1
    return CHAINS(ONE);
}

double multiply_add(size_t steps, double by, double plus)
{
    const lanes zero = {0}, factor = zero + by, shift = zero + plus;
#define DECLARED(i) lanes a##i = shift + i;
    CHAINS(DECLARED)
    lanes sum = zero;
    double total = 0;
    size_t i;
    for (i = 0; i < steps; ++i) {
#define STEP(i) a##i = a##i * factor + shift;
        CHAINS(STEP)
    }
#define SUMMED(i) sum += a##i;
    CHAINS(SUMMED)
    for (i = 0; i < LANES; ++i) {
        total += sum[i];
    }
    return total;
}
