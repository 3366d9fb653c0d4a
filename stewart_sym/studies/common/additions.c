/* A chain of additions of whole numbers, each waiting for the one before: one for each cycle of the processor. */
#include <stddef.h>

#define FOUR(X) X X X X
#define CHAIN(X) FOUR(FOUR(FOUR(X)))
#define UNKNOWN(number) __asm__ volatile("" : "+r"(number))

int additions_chain(void)
{
#define ONE +1
    return CHAIN(ONE);
}

/* The compiler is not to know either number: it would fold the chain, and processors skip small constants. */
size_t additions(size_t steps, size_t by)
{
    size_t sum = 0, i;
    UNKNOWN(by);
    for (i = 0; i < steps; ++i) {
#define STEP sum += by; UNKNOWN(sum);
        CHAIN(STEP)
    }
    return sum;
}
